//! Where a sculptured surface may touch a tool: pieces of it that may hold a place at which the distance of the tool dips.
//!
//! At such a place q with the normal n, towards the tool, the point of the tool next to it is the one that lies farthest against n.
//! So of a piece whose normals lean all about the same way across the tool's axis it is known from where around the axis and from what
//! part of the tool's outline it can be touched, and whether it lies there.
//!
//! Beside a flank the distance bends by how the surface does, and around the tool by one over its radius: M = K + kappa a a', in which a
//! is the direction around the axis. Where M is positive all over a piece no place of contact comes to be in it but one that moves into
//! it; where M is negative in one direction all over it, it holds none.

use super::{Cell, Cells};
use crate::surface::parametric::Jet;
use crate::{Tool, Vec3};

use super::beneath::Next;

/// How often a cell is cut in four at most.
const CUTS: u32 = 6;
/// Share of a normal's part across the axis by which others of its piece may differ, for it to be known from where they are touched.
const LEANS: f64 = 0.5;
/// Angle by which normals are taken to lean otherwise at least: along a flank all of it faces one.
const LEVEL: f64 = 1e-6;

/// A piece of a surface, seen from a tool.
#[derive(Clone, Copy, Debug)]
pub struct Touching {
    /// The parameters of its middle.
    pub mid: [f64; 2],
    /// The point there.
    pub point: Vec3,
    /// No point of it is farther from that one.
    pub reach: f64,
    /// No place of contact in it is deeper.
    pub bound: f64,
    /// How far the tool has to go until its distance may dip at a place of the piece.
    pub until: f64,
    /// May a place of contact come to be in it that did not move there?
    pub comes: bool,
    /// The normal in the middle, on the side of the tool; zero beside an edge.
    pub normal: Vec3,
    /// By how much others differ from it, as vectors; 2 where they may be anything.
    pub turn: f64,
    /// Can it be cut?
    pub whole: bool,
}

/// What a piece is to a tool that goes no farther than some way.
struct Seen {
    until: f64,
    comes: bool,
    /// Can the flank alone touch it, away from its ends?
    flank: bool,
}

impl Cells {
    /// The pieces that may come nearer to a tool than the first of the limits and, the tool having gone by less than the second, its
    /// axis standing, hold a place at which its distance dips: `look` is asked what is to become of each. The tool is on the side
    /// to which `sign` times the normals lead.
    pub(in super::super) fn touching(
        &self,
        (tool, sign): (&Tool<'_>, f64),
        limits: [f64; 2],
        jet: impl Fn([usize; 2], f64, f64) -> Jet,
        mut look: impl FnMut(&Touching) -> Next,
    ) {
        self.beside(
            |p| tool.distance(p),
            limits,
            |cell, limits| cell.touching((tool, sign), limits, &jet, CUTS, &mut look),
        );
    }
}

impl Cell {
    fn touching(
        &self,
        (tool, sign): (&Tool<'_>, f64),
        limits: &mut [f64; 2],
        jet: &impl Fn([usize; 2], f64, f64) -> Jet,
        cuts: u32,
        look: &mut impl FnMut(&Touching) -> Next,
    ) {
        let near = tool.near(self.c);
        let nearest = near.distance - self.below(near.normal);
        if nearest > limits[0].max(0.0) {
            return;
        }
        let smooth = self.smooth.iter().flatten().all(|s| *s);
        let normals = self.normals().filter(|_| smooth).map(|(n, turn)| (n * sign, turn));
        let [deepest, after] = match normals {
            Some(normals) => self.deepest(tool, normals, limits[1]),
            None => [f64::NEG_INFINITY; 2],
        };
        let far = [after, near.distance + self.reach + limits[1]];
        let seen = match normals {
            Some(normals) => self.seen(tool, normals, far, limits[1]),
            None => Some(Seen { until: 0.0, comes: true, flank: false }),
        };
        let Some(Seen { until, comes, flank }) = seen else { return };
        // A place at an edge of the tool may be deeper than it lies in it.
        let bound = if nearest > 0.0 || flank { nearest } else { deepest };
        if bound > limits[0] {
            return;
        }
        let (normal, turn) = normals.unwrap_or((Vec3::zeros(), 2.0));
        let &Self { mid, c: point, reach, .. } = self;
        let whole = cuts > 0;
        match look(&Touching { mid, point, reach, bound, until, comes, normal, turn, whole }) {
            Next::Left(next) => *limits = next,
            Next::Cut if whole => {
                for part in self.parts(jet) {
                    part.touching((tool, sign), limits, jet, cuts - 1, look);
                }
            }
            Next::Cut => {}
        }
    }

    /// By how much it goes against a direction from its middle.
    fn below(&self, t: Vec3) -> f64 {
        let [a, b] = &self.side;
        let [uu, uv, vv] = &self.bend;
        let over = |(m, r): &(Vec3, f64)| (r - t.dot(m)).max(0.0);
        t.dot(a).abs() + t.dot(b).abs() + 0.5 * (over(uu) + over(vv)) + t.dot(&uv.0).abs() + uv.1
    }

    /// The least gap at a place of contact in it, whose normals differ from `n` by no more than `turn`, now and when the tool has gone
    /// some way.
    ///
    /// It is the distance from the plane that holds the tool off along the normal: by another normal its place of contact is farther
    /// from that plane by no more than the turn takes of the gap.
    fn deepest(&self, tool: &Tool<'_>, (n, turn): (Vec3, f64), way: f64) -> [f64; 2] {
        let plane = n.dot(&(tool.support(-n).point - self.c)) - self.width(n);
        [plane, plane - way].map(|gap| match turn < LEANS {
            true => gap / (1.0 + turn.copysign(gap)),
            false => f64::NEG_INFINITY,
        })
    }

    /// When a place of it, whose normals differ from `n` by no more than `turn`, may face the tool, which is no nearer to it and no
    /// farther from it than `far` while it goes by `way`; `None` where no distance dips in it.
    fn seen(
        &self,
        tool: &Tool<'_>,
        (n, turn): (Vec3, f64),
        far: [f64; 2],
        way: f64,
    ) -> Option<Seen> {
        let (ta, profile) = (tool.ta, tool.profile);
        let up = n.dot(&ta);
        let across = n - ta * up;
        let lean = across.norm();
        if turn >= LEANS * lean {
            return Some(Seen { until: 0.0, comes: true, flank: false });
        }
        let (out, most) = (across * (-1.0 / lean), far[0].abs().max(far[1].abs()));
        let around = ta.cross(&out);
        let w = self.c - tool.te;
        let off = w.dot(&around).abs();
        // As a unit vector the direction away from the axis differs from `out` by no more.
        let other = turn / (lean - 0.5 * turn);
        // The ends of the part of the outline that faces the normals.
        let half = 0.5 * turn + LEVEL;
        let (cos, sin) = (1.0 - 2.0 * half * half, 2.0 * half * (1.0 - half * half).sqrt());
        let end =
            |sin: f64| profile.support((lean * cos + up * sin).max(0.0), lean * sin - up * cos);
        let [low, high] = [end(-sin).point, end(sin).point];
        let widest = if low[1] <= high[1] && up.abs() <= sin { profile.widest() } else { 0.0 };
        let [least, greatest] = [low[0].min(high[0]), low[0].max(high[0]).max(widest)];
        let beside = off - self.width(around) - (greatest + most) * other;
        let z = w.dot(&ta);
        let ([rise, fall], tall) = (self.lifted(up, turn, far), self.width(ta));
        let above = (z - tall) - (high[1] + rise);
        let below = (low[1] - fall) - (z + tall);
        let until = beside.max(above).max(below).max(0.0);
        let through = least * (1.0 - other * other) - most - (w.dot(&out) + self.width(out));
        if until > way || through > way {
            return None;
        }
        let [_, [_, joint]] = profile.joints();
        let flank = z - tall - rise - way > joint && z + tall + fall + way < profile.height();
        let radius = flank.then_some(least + far[0]).filter(|r| *r > 0.0);
        let bow = self.bow((n, turn), (around, other));
        if radius.is_some_and(|r| bow.falls(1.0 / r)) {
            return None;
        }
        let comes = !bow.rises((lean - turn).max(0.0) / (greatest + most));
        Some(Seen { until, comes, flank })
    }

    /// How far above and below the place of the tool a place of the surface may be that faces it, as normals lean by `up` along the axis.
    fn lifted(&self, up: f64, turn: f64, far: [f64; 2]) -> [f64; 2] {
        let leans = [up - turn, up + turn];
        let all = leans.map(|lean| far.map(|far| -lean * far));
        let all = all.iter().flatten();
        let most = all.clone().fold(f64::NEG_INFINITY, |a, b| a.max(*b));
        [most, -all.fold(f64::INFINITY, |a, b| a.min(*b))]
    }

    /// How it bends against its normals, and its derivatives around an axis, which others differ from by `other`.
    fn bow(&self, (n, turn): (Vec3, f64), (around, other): (Vec3, f64)) -> Bow {
        let ends = self.turns();
        let side = [0, 1].map(|k| {
            let side = &self.side[k];
            (around.dot(side), ends[k] + other * (side.norm() + ends[k]))
        });
        let bend = self.bend.map(|(m, r)| (-n.dot(&m), r + turn * (m.norm() + r)));
        Bow { side, bend }
    }
}

/// Derivatives of a piece around an axis, and second derivatives against its normals, each with by how much it may differ.
struct Bow {
    side: [(f64, f64); 2],
    bend: [(f64, f64); 3],
}

impl Bow {
    /// Is `K + kappa a a'` positive all over the piece, with no less than `kappa`?
    fn rises(&self, kappa: f64) -> bool {
        let [(a, ea), (b, eb)] = self.side;
        let [uu, uv, vv] = self.bend;
        let square = |a: f64, e: f64| {
            let least = (a.abs() - e).max(0.0);
            kappa * least * least
        };
        let (h11, h22) = (square(a, ea) + uu.0 - uu.1, square(b, eb) + vv.0 - vv.1);
        let h12 =
            (kappa * a * b + uv.0).abs() + kappa * (ea * b.abs() + eb * a.abs() + ea * eb) + uv.1;
        h11 > 0.0 && h22 > 0.0 && h11 * h22 > h12 * h12
    }

    /// Is it negative in one direction all over it, with no more than `kappa`?
    fn falls(&self, kappa: f64) -> bool {
        let [(a, ea), (b, eb)] = self.side;
        let [uu, uv, vv] = self.bend;
        // The direction that does not go around.
        let size = a.abs().max(b.abs());
        let (x, y) = if size > 0.0 { (-b / size, a / size) } else { (0.0, 1.0) };
        let round = x.abs() * ea + y.abs() * eb;
        let bend = x * x * uu.0 + 2.0 * x * y * uv.0 + y * y * vv.0;
        let unsure = x * x * uu.1 + 2.0 * (x * y).abs() * uv.1 + y * y * vv.1;
        bend + unsure + kappa * round * round < 0.0
    }
}
