//! Edges of a sculptured surface: joints of its patches at which the normal jumps, and tips.
//!
//! What comes near to one may be nearest to it with any normal between those of its sides.

use super::Jet;
use super::sculptured::Spans;
use crate::Vec3;
use crate::sculpt::{Layout, Sculptured};
use crate::surface::{Shape, frame_about};

/// Normals that differ by more jump: those of patches fitted as one differ by rounding, and searches for contacts end at half as much.
const JUMPS: f64 = 5e-8;
/// Borders that are no farther apart than this share of the surface's size are one.
const SAME: f64 = 1e-6;
/// Parts of a joint at whose ends it is looked whether it is an edge.
const LOOKS: u8 = 4;
/// Share of a tip's surface at which its directions are taken, and how many.
const BESIDE: f64 = 1e-6;
const ROUND: u8 = 16;
/// By so much of the parameters a place on an edge is taken to lie inside of its patch.
const INTO: f64 = 1e-12;
/// Radius of an edge, as a part of the surface's size, its inverse.
const SHARP: f64 = 1e9;
/// Share of the parameters by which a place on an edge may lie beside it.
const ON: f64 = 1e-9;

/// An edge from one end to the other; a tip is one of no length.
#[derive(Clone, Debug)]
pub struct Edge {
    sides: Sides,
    /// A ball that holds it.
    pub center: Vec3,
    /// Its radius.
    pub radius: f64,
    /// Least cosine between normals of both sides, or about a tip.
    pub cos: f64,
}

/// What lies on both sides of an edge, or all round a tip.
#[derive(Clone, Debug)]
enum Sides {
    Joint([Beside; 2]),
    Tip { at: [f64; 2], inwards: Vec<Vec3>, mean: Vec3 },
}

/// A border of a patch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beside {
    patch: [usize; 2],
    /// Parameters of both ends, and the direction into the patch.
    from: [f64; 2],
    to: [f64; 2],
    inwards: [f64; 2],
}

/// A place on an edge.
#[derive(Clone, Debug)]
pub struct OnEdge {
    /// Its parameters.
    pub at: [f64; 2],
    /// The point.
    pub point: Vec3,
    /// The derivative along the edge; none of a tip.
    pub along: Vec3,
    /// The mean of the normals about it.
    pub mean: Vec3,
}

impl Edge {
    /// Is it a tip?
    pub fn is_tip(&self) -> bool {
        matches!(self.sides, Sides::Tip { .. })
    }

    /// The place at the share `t` of its length.
    pub(super) fn at(&self, spans: &Spans, t: f64) -> OnEdge {
        match &self.sides {
            Sides::Tip { at, mean, .. } => {
                OnEdge { at: *at, point: self.center, along: Vec3::zeros(), mean: *mean }
            }
            Sides::Joint([a, b]) => {
                let (at, jet) = a.jet(spans, t);
                let (_, other) = b.jet(spans, t);
                // Of loose patches the border's parameters may be those of another.
                let at = [0, 1].map(|k| at[k] + INTO * a.inwards[k]);
                let by = a.by();
                let along = jet.su * by[0] + jet.sv * by[1];
                let mean = jet.normal().unwrap_or_else(Vec3::zeros)
                    + other.normal().unwrap_or_else(Vec3::zeros);
                OnEdge { at, point: jet.s, along, mean }
            }
        }
    }

    /// The point at the share `t` of its length, and the derivative along it.
    pub(super) fn line(&self, spans: &Spans, t: f64) -> [Vec3; 2] {
        match &self.sides {
            Sides::Tip { .. } => [self.center, Vec3::zeros()],
            Sides::Joint([side, _]) => {
                let (_, jet) = side.jet(spans, t);
                let by = side.by();
                [jet.s, jet.su * by[0] + jet.sv * by[1]]
            }
        }
    }

    /// The directions from the place at `t` into the surface, until one does not do.
    pub(super) fn all_inwards(&self, spans: &Spans, t: f64, does: impl Fn(Vec3) -> bool) -> bool {
        match &self.sides {
            Sides::Tip { inwards, .. } => inwards.iter().all(|d| does(*d)),
            Sides::Joint(sides) => sides.iter().all(|side| {
                let jet = side.jet(spans, t).1;
                let by = side.by();
                let along = jet.su * by[0] + jet.sv * by[1];
                let into = jet.su * side.inwards[0] + jet.sv * side.inwards[1];
                let across = into - along * (into.dot(&along) / along.norm_squared().max(1e-300));
                across.try_normalize(0.0).is_none_or(&does)
            }),
        }
    }

    /// The mean of the normals, if the place with these parameters lies on it.
    pub(super) fn mean_at(&self, spans: &Spans, uv: [f64; 2]) -> Option<Vec3> {
        let (_, t) = self.holds(spans, uv)?;
        self.at(spans, t).mean.try_normalize(0.0)
    }

    /// How it bends where it is touched along the unit normal `n`, if the place with these parameters lies on it: across it
    /// nearly as a corner, along it as it runs.
    pub(super) fn shape_at(&self, spans: &Spans, uv: [f64; 2], n: Vec3) -> Option<Shape> {
        if let Sides::Tip { at, .. } = &self.sides {
            let here = (self.center - spans.jet(uv[0], uv[1]).s).norm() <= SAME * spans.size()
                && at.iter().zip(uv).any(|(a, b)| (a - b).abs() <= ON);
            return here.then(|| Shape { frame: frame_about(n), k: [f64::INFINITY, 0.0, 0.0] });
        }
        let (side, t) = self.holds(spans, uv)?;
        let jet = side.jet(spans, t).1;
        let [x, y] = side.by();
        let (along, turn) = (
            jet.su * x + jet.sv * y,
            jet.suu * (x * x) + jet.suv * (2.0 * x * y) + jet.svv * (y * y),
        );
        let size = along.norm_squared();
        let unit = (along - n * n.dot(&along)).try_normalize(0.0)?;
        let across = SHARP / spans.size().max(1e-300);
        Some(Shape { frame: [unit, n.cross(&unit)], k: [-n.dot(&turn) / size, 0.0, across] })
    }

    /// Both sides of it, first the one that a place with these parameters lies next to, where it lies so by a share of them; `None` of
    /// a tip.
    pub(super) fn sides_by(&self, uv: [f64; 2], near: f64) -> Option<[&Beside; 2]> {
        let Sides::Joint([a, b]) = &self.sides else { return None };
        [[a, b], [b, a]].into_iter().find(|[side, _]| side.is_by(uv, near))
    }

    /// The side of it that a place with these parameters lies on, and the share of its length.
    fn holds(&self, spans: &Spans, uv: [f64; 2]) -> Option<(&Beside, f64)> {
        let Sides::Joint(sides) = &self.sides else { return None };
        let side = sides.iter().find(|side| side.is_by(uv, ON))?;
        let t = side.share(uv);
        let away = side.jet(spans, t).1.s - spans.jet(uv[0], uv[1]).s;
        (away.norm() <= SAME * spans.size()).then_some((side, t))
    }
}

impl Beside {
    /// From one end to the other.
    pub(super) fn by(&self) -> [f64; 2] {
        [0, 1].map(|k| self.to[k] - self.from[k])
    }

    /// The direction into the patch by its parameters.
    pub(super) fn inwards(&self) -> [f64; 2] {
        self.inwards
    }

    /// The share of its length at which the place with these parameters lies beside it.
    pub(super) fn share(&self, uv: [f64; 2]) -> f64 {
        let (by, off) = (self.by(), [0, 1].map(|k| uv[k] - self.from[k]));
        (off[0] * by[0] + off[1] * by[1]) / (by[0] * by[0] + by[1] * by[1])
    }

    /// Its parameters at a share of its length, and what is there.
    pub(super) fn jet(&self, spans: &Spans, t: f64) -> ([f64; 2], Jet) {
        let at = [0, 1].map(|k| self.from[k] + (self.to[k] - self.from[k]) * t);
        (at, spans.jet_of(self.patch, at[0], at[1]))
    }

    /// Lies a place with these parameters next to it, by a share of them?
    fn is_by(&self, uv: [f64; 2], near: f64) -> bool {
        (0..2).all(|k| {
            let (low, high) = (self.from[k].min(self.to[k]), self.from[k].max(self.to[k]));
            (low - near..=high + near).contains(&uv[k])
        })
    }

    /// The share of its length at the share `t` of what lies on the surface, not on its continuation.
    fn within(&self, t: f64) -> f64 {
        let by = self.by();
        let k = usize::from(by[1].abs() > by[0].abs());
        let at = |x: f64| ((x.clamp(0.0, 1.0) - self.from[k]) / by[k]).clamp(0.0, 1.0);
        let (low, high) = (at(self.from[k]), at(self.to[k]));
        low + (high - low) * t
    }

    /// The same from the other end.
    fn turned(self) -> Self {
        Self { from: self.to, to: self.from, ..self }
    }
}

/// The edges of a surface.
pub(super) fn edges(surface: &Sculptured, spans: &Spans) -> Vec<Edge> {
    let joints = match &surface.layout {
        Layout::Mesh { u, v } => of_grid(surface, [u, v], spans),
        Layout::Patches => of_patches(surface, spans),
    };
    let edges = joints.into_iter().filter_map(|sides| {
        let mut jumps = false;
        let mut cos = 1.0_f64;
        for i in 0..=LOOKS {
            let t = sides[0].within(f64::from(i) / f64::from(LOOKS));
            let [a, b] = sides.map(|side| side.jet(spans, t).1.normal());
            let Some((a, b)) = a.zip(b) else { continue };
            jumps |= (a - b).norm() > JUMPS;
            cos = cos.min(a.dot(&b));
        }
        jumps.then(|| {
            let [low, high] = surface.patches[surface.index_of(sides[0].patch)].bounds();
            let center = (low + high) * 0.5;
            // Beyond the patch it goes straight on.
            let ends = [0.0, 1.0].map(|t| (sides[0].jet(spans, t).1.s - center).norm());
            let radius = ends.into_iter().fold(0.5 * (high - low).norm(), f64::max);
            Edge { sides: Sides::Joint(sides), center, radius, cos }
        })
    });
    edges.chain(tips(spans)).collect()
}

/// Borders along u and v between the patches of a grid, and those at which it closes; they go on with it.
fn of_grid(surface: &Sculptured, knots: [&Vec<f64>; 2], spans: &Spans) -> Vec<[Beside; 2]> {
    let shares = knots.map(|k| k.iter().map(|t| t / k[k.len() - 1]).collect::<Vec<_>>());
    let domain = spans.domain();
    let far = [domain.u, domain.v].map(|[low, high]| [low.min(0.0), high.max(1.0)]);
    let mut all = Vec::new();
    for k in 0..2 {
        let across = &shares[k];
        let last = across.len() - 1;
        let inner = (1..last).map(|i| ([i - 1, i], [across[i]; 2]));
        let seam = surface.closes(k).then_some(([last - 1, 0], [1.0, 0.0]));
        for (columns, at) in inner.chain(seam) {
            for (row, ends) in shares[1 - k].windows(2).enumerate() {
                let [low, high] = far[1 - k];
                let from = if row == 0 { low } else { ends[0] };
                let to = if row + 2 == shares[1 - k].len() { high } else { ends[1] };
                all.push([0, 1].map(|side| {
                    let place =
                        |along: f64| if k == 0 { [at[side], along] } else { [along, at[side]] };
                    let (column, sense) = (columns[side], if side == 0 { -1.0 } else { 1.0 });
                    Beside {
                        patch: if k == 0 { [column, row] } else { [row, column] },
                        from: place(from),
                        to: place(to),
                        inwards: if k == 0 { [sense, 0.0] } else { [0.0, sense] },
                    }
                }));
            }
        }
    }
    all
}

/// Borders of loose patches that are in one place.
fn of_patches(surface: &Sculptured, spans: &Spans) -> Vec<[Beside; 2]> {
    let n = surface.patches.len() as f64;
    let same = SAME * surface.extent();
    let border = |i: usize, k: usize, end: f64| {
        let [low, high] = [i as f64 / n, (i as f64 + 1.0) / n];
        let at = if end > 0.0 { high } else { low };
        let sense = 1.0 - 2.0 * end;
        let (from, to, inwards) = match k {
            0 => ([at, 0.0], [at, 1.0], [sense, 0.0]),
            _ => ([low, end], [high, end], [0.0, sense]),
        };
        Beside { patch: [i, 0], from, to, inwards }
    };
    let all = (0..surface.patches.len())
        .flat_map(|i| [(0, 0.0), (0, 1.0), (1, 0.0), (1, 1.0)].map(|(k, end)| border(i, k, end)));
    let mut all: Vec<([Vec3; 3], Beside)> =
        all.map(|b| ([0.0, 0.5, 1.0].map(|t| b.jet(spans, t).1.s), b)).collect();
    all.sort_by(|a, b| a.0[1].x.total_cmp(&b.0[1].x));
    let mut found = Vec::new();
    for (i, (p, a)) in all.iter().enumerate() {
        let beside = all[i + 1..].iter().take_while(|(q, _)| q[1].x - p[1].x <= same);
        for (q, b) in beside {
            let alike = |q: [Vec3; 3]| (0..3).all(|k| (q[k] - p[k]).norm() <= same);
            if alike(*q) {
                found.push([*a, *b]);
            } else if alike([q[2], q[1], q[0]]) {
                found.push([*a, b.turned()]);
            }
        }
    }
    found
}

/// Borders that are one point without one normal.
fn tips(spans: &Spans) -> Vec<Edge> {
    let mut all = Vec::new();
    for k in 0..2 {
        for end in [0.0, 1.0] {
            let place = |along: f64, away: f64| {
                let at = end + (1.0 - 2.0 * end) * away;
                if k == 0 { [at, along] } else { [along, at] }
            };
            let at = place(0.5, 0.0);
            let Some(mean) = spans.tip(at) else { continue };
            let point = spans.jet(at[0], at[1]).s;
            let beside = |i: u8| {
                let [u, v] = place((f64::from(i) + 0.5) / f64::from(ROUND), BESIDE);
                spans.jet(u, v)
            };
            let inwards = (0..ROUND).filter_map(|i| (beside(i).s - point).try_normalize(0.0));
            let normals: Vec<Vec3> = (0..ROUND).filter_map(|i| beside(i).normal()).collect();
            let pairs = normals.iter().flat_map(|a| normals.iter().map(|b| a.dot(b)));
            let cos = pairs.fold(1.0, f64::min);
            let sides = Sides::Tip { at, inwards: inwards.collect(), mean };
            all.push(Edge { sides, center: point, radius: 0.0, cos });
        }
    }
    all
}
