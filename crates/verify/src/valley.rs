//! The corner of a tool on its way along a hollow, its axis standing still.
//!
//! What both ends of the way show of the standing tool is all. Let f be the distance from all that the tool would sweep if its
//! way had no ends. Of a point of the surface that the tool passes nearest between the ends f is the distance from it on its way;
//! of one nearest to an end that is its distance from the tool there. The surface is cut by planes along the way, upright on
//! it. On such a curve f is concave where the surface bends towards the tool by more than f itself bends: so it is least
//! where the curve comes to what an end is nearest to, or leaves the pieces of which this is seen. There the standing tool shows
//! it, or whatever shows the piece beside it.
//!
//! With the unit vectors v along the way and w upright, the curve is `x' = v + h' w` by the way along it, where N being the
//! normal of the surface `h' = -N . v / N . w`, and `x'' = w N . B(x', x') / N . w` by the second derivatives B of the surface.
//! With n the gradient of f, which is square to v, `f'' = n . x'' + h'^2 w H w`. A ball of the corner's radius R rolls about
//! inside the tool, so that `H <= 1 / (R + f)`, and n turns by no more than the place moves across the way over that.
//!
//! At borders of charts normals may differ by rounding: a corner of d on a curve of which f bends by b loses `d^2 / 2 b` at most,
//! and no more than d times the way.

use aptc_geometry::Vec3;

use crate::each::{three, two};
use crate::paraboloid::{At, Corner, Place, Seen};
use crate::sheet::{Patch, Sheet, Spot, Tile};
use crate::solid::unit_or;
use crate::sweep::Sweep;

/// Share of the corner's radius that must be left between a piece and the middle of the corner.
const DEEP: f64 = 0.5;
/// Share of the corner's radius below which a piece is not cut for this alone.
const SMALL: f64 = 0.02;
/// Share of what bends the surface in the middle of a piece by which f is to be concave: of all of it, and in the middle for it
/// to be worth to be cut.
const LEAST: f64 = 0.05;
const HALF: f64 = 0.5;
/// Share of the corner's radius before and behind the way at which what is swept is still looked at.
const AHEAD: f64 = 0.25;
/// Turns of the direction to a piece, and the sine by which it may be another.
const TURNS: u32 = 6;
const TURNED: f64 = 1e-4;
/// Share of the flat's radius beside its middle below which is what counts as below it.
const BELOW: f64 = 0.95;
/// Least cosine of the normals to what is upright, and part by which the derivatives of a piece may change its velocity.
const UPRIGHT: f64 = 0.3;
const CHANGE: f64 = 0.5;

/// A hollow along the way.
#[derive(Debug)]
pub(crate) struct Valley<'a> {
    /// The standing tool at both ends, and its place.
    ends: [(Corner<'a>, Place); 2],
    whole: &'a Sweep<'a>,
    /// Unit vectors along the way, upright on it away from the tool, and square to both.
    along: Vec3,
    up: Vec3,
    beside: Vec3,
    /// The radius of the tool's corner.
    radius: f64,
}

/// A piece beside the tool on its way.
#[derive(Clone, Copy, Debug)]
struct Met {
    /// Unit direction from the tool to its middle.
    n: Vec3,
    /// How far it is from the middle of the corner at least.
    deep: f64,
    /// By how much the direction may be another.
    off: f64,
}

/// How f is bent on a piece.
#[derive(Clone, Copy, Debug)]
enum Bent {
    /// Concave all over it.
    Hollow,
    /// So on a smaller one, most likely.
    Smaller,
    Otherwise,
}

impl<'a> Valley<'a> {
    /// From a place of the surface beside the tool, in the direction `m` from it; `None` where there is no hollow along the way, or
    /// the standing tool has no paraboloid.
    pub(crate) fn new(
        [first, last]: &'a [Sweep<'a>; 2],
        whole: &'a Sweep<'a>,
        corner: &Corner<'a>,
        sheet: &Sheet,
        spot: Spot,
        m: Vec3,
    ) -> Option<Self> {
        let along = (whole.b.te - whole.a.te).try_normalize(0.0)?;
        let [first, last] = two([first, last], |sweep| corner.standing(sweep));
        let begin = first.find(sheet, spot, At::Start, m)?;
        let end = last.find(sheet, begin.spot, At::Start, begin.about.m)?;
        let up = across(begin.about.m, along).try_normalize(0.0)?;
        let beside = along.cross(&up);
        let (jet, bend) = sheet.bent(&begin.spot);
        let line = line(jet.d, along, beside)?;
        let hollow = bent(line, bend).dot(&begin.about.m) < 0.0;
        let radius = corner.own_radius();
        let ends = [(first, begin), (last, end)];
        hollow.then_some(Self { ends, whole, along, up, beside, radius })
    }

    /// The place at the end of the way, with its paraboloid.
    pub(crate) fn place(&self) -> &Place {
        &self.ends[1].1
    }

    /// What is shown of a piece.
    pub(crate) fn see(&self, sheet: &Sheet, patch: &Patch, tile: &Tile) -> Seen {
        match self.met(tile).map(|met| self.bent(tile, &met)) {
            None | Some(Bent::Otherwise) => return Seen::Near,
            Some(Bent::Smaller) => {
                let size = two([0, 1], |i| tile.side[i].norm() + tile.stray[i]);
                let longer = usize::from(size[1] > size[0]);
                let worth = size[longer] > SMALL * self.radius;
                return if worth { Seen::Large(longer) } else { Seen::Near };
            }
            Some(Bent::Hollow) if !sheet.goes_on(patch) => return Seen::Near,
            Some(Bent::Hollow) => {}
        }
        let [first, last] = &self.ends;
        if !(first.0.is_below_top(tile) && last.0.is_below_top(tile)) {
            return Seen::Near;
        }
        let stands = |(corner, place): &(Corner<'_>, Place)| {
            let (low, m) = corner.parted(tile);
            if low >= 0.0 {
                Seen::Clear(low, m, None)
            } else {
                corner.see(place, sheet, patch, tile)
            }
        };
        let first = match stands(first) {
            Seen::Clear(low, ..) => low,
            other => return other,
        };
        match stands(last) {
            Seen::Clear(last, m, _) => Seen::Spanned { low: first.min(last), last, m },
            other => other,
        }
    }

    /// In what direction the middle of a piece is from what the tool sweeps; `None` where it is farther than the piece is wide.
    ///
    /// With the unit vectors n square to the way the distance is the greatest `g = n . (c - x)`, x being the point of the tool
    /// farthest along n. On turning n by an angle it is `g'' = -(g + r)`, r being the radius at which the outline of what is swept
    /// bends in x, and that is the corner's radius at least: so from where `g'` is small it is soon 0.
    fn met(&self, tile: &Tile) -> Option<Met> {
        let (corner, far) = (&self.ends[0].0, tile.radius());
        let pose = &self.whole.a;
        let mut n = self.towards(tile.c);
        // Turned one way and the other as far as it is known to be too far.
        let mut ends: [Option<Vec3>; 2] = [None; 2];
        for turn in 0..=TURNS {
            let from = tile.c - self.whole.tool.farthest(pose, n);
            let on = self.along.cross(&n);
            let (gap, slope) = (n.dot(&from), on.dot(&from));
            let deep = self.radius + gap;
            if gap > far || deep <= 0.0 {
                return None;
            }
            if slope.abs() <= TURNED * deep || turn == TURNS {
                let ahead = self.along.dot(&from);
                let length = (self.whole.b.te - pose.te).dot(&self.along);
                let more = AHEAD * self.radius;
                if ahead < -more || ahead > length + more {
                    return None;
                }
                return Some(Met { n, deep: deep - far, off: slope.abs() / deep });
            }
            ends[usize::from(slope > 0.0)] = Some(n);
            let next = unit_or(n + on * (slope / (deep + corner.ring(n, on))), n);
            n = match ends {
                [Some(over), Some(short)] => {
                    let other = if slope > 0.0 { over } else { short };
                    let inside = on.dot(&other) * slope > on.dot(&next) * slope;
                    if inside { next } else { unit_or(over + short, next) }
                }
                _ => next,
            };
        }
        None
    }

    /// About the direction to a point from what the tool sweeps.
    fn towards(&self, c: Vec3) -> Vec3 {
        let at = &self.whole.a;
        let corner = &self.ends[0].0;
        if corner.rho == 0.0 {
            let middle = at.te + at.ta * self.whole.tool.shoulder();
            return unit_or(across(c - middle, self.along), self.up);
        }
        // Below the flat it leans as little as the way does.
        let down = unit_or(across(-at.ta, self.along), self.up);
        let beside = self.along.cross(&down);
        let y = beside.dot(&(c - at.te)) / corner.rho;
        if y.abs() < BELOW {
            let lean = down.cross(&at.ta).norm();
            return unit_or(down + beside * (lean * y / (1.0 - y * y).sqrt()), down);
        }
        unit_or(across(self.place().about.m, self.along), self.up)
    }

    /// Is the distance from the tool on its way concave all over the piece, along the way?
    fn bent(&self, tile: &Tile, &Met { n, deep, off }: &Met) -> Bent {
        if deep < DEEP * self.radius {
            let smaller = deep + tile.radius() > DEEP * self.radius;
            return if smaller { Bent::Smaller } else { Bent::Otherwise };
        }
        let Some(line) = line(tile.side, self.along, self.beside) else { return Bent::Otherwise };
        let normal = if tile.n.dot(&self.up) < 0.0 { -tile.n } else { tile.n };
        let (upright, slope) = (normal.dot(&self.up), normal.dot(&self.along).abs());
        let bend = bent(line, tile.bend);
        let bow = normal.dot(&bend);
        let rise = |slope: f64, upright: f64| (slope / upright) * (slope / upright) / deep;
        // By how much n, N and B may be others on the piece.
        let [x, y] = two([0, 1], |i| across(tile.side[i], self.along).norm() + tile.stray[i]);
        let other = (x + y) / deep + off;
        let lift = n.dot(&self.up) - other;
        let turn = tile.turn[0] + tile.turn[1];
        let bow_at_most = bow + turn * bend.norm() + self.vary(tile, line);
        let second = lift * bow_at_most + rise(slope + turn, upright - turn);
        // Beside the edge of the tool's top no ball rolls about inside it.
        let corner = &self.ends[0].0;
        let round = corner.turns_to(n, other);
        // Of what is no number nothing is known.
        let hollow = round && lift > 0.0 && upright - turn >= UPRIGHT && bow_at_most < 0.0;
        if hollow && second <= LEAST * bow {
            Bent::Hollow
        } else if upright > UPRIGHT
            && corner.turns_to(n, 0.0)
            && bow + rise(slope, upright) < HALF * bow
        {
            Bent::Smaller
        } else {
            Bent::Otherwise
        }
    }

    /// By how much `B(x', x')` may be another on a piece than in its middle, infinite where its derivatives change too much.
    fn vary(&self, tile: &Tile, line: [f64; 2]) -> f64 {
        let (rows, det) = self.rows(tile.side);
        let most = three([0, 1, 2], |i| tile.bend[i].norm() + tile.vary[i]);
        let change = (most[0] + 2.0 * most[1] + most[2]) * rows / det;
        if change > CHANGE {
            return f64::INFINITY;
        }
        let [a, b] = two(line, f64::abs);
        let d = (a + b) * change / (1.0 - change);
        let here = a * a * tile.vary[0] + 2.0 * a * b * tile.vary[1] + b * b * tile.vary[2];
        let other = most[0] * (2.0 * a + d) + 2.0 * most[1] * (a + b + d) + most[2] * (2.0 * b + d);
        here + other * d
    }

    /// The sum of all numbers of the derivatives seen from upright, and their determinant.
    fn rows(&self, side: [Vec3; 2]) -> (f64, f64) {
        let [[a, b], [c, d]] = two(side, |s| [s.dot(&self.along), s.dot(&self.beside)]);
        (a.abs() + b.abs() + c.abs() + d.abs(), (a * d - b * c).abs())
    }
}

/// `x` without its part along a unit vector.
fn across(x: Vec3, along: Vec3) -> Vec3 {
    x - along * x.dot(&along)
}

/// By the parameters the velocity that goes as `along` and not beside it.
fn line([u, v]: [Vec3; 2], along: Vec3, beside: Vec3) -> Option<[f64; 2]> {
    let (x, y) = (u.dot(&beside), v.dot(&beside));
    let det = u.dot(&along) * y - v.dot(&along) * x;
    (det != 0.0).then(|| [y / det, -x / det])
}

/// The second derivative with that velocity, but for what is along the surface.
fn bent([a, b]: [f64; 2], [uu, uv, vv]: [Vec3; 3]) -> Vec3 {
    uu * (a * a) + uv * (2.0 * a * b) + vv * (b * b)
}

#[cfg(test)]
#[path = "valley_tests.rs"]
mod tests;
