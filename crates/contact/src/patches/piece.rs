//! A piece of a patch: the bound below the distances of a body from it, and its parts.

use aptc_geometry::Vec3;
use aptc_geometry::sculpt::Bends;

use super::{PatchPlace, PatchTree};
use crate::bodies::Convex;
use crate::under::Cell;

/// A piece of half widths up to this is held against both bounds.
const SMALL: f64 = 1.0 / 128.0;

/// A piece of a patch: middle and half widths of its parameters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) leaf: usize,
    /// Its level and place among the pieces that are kept, if it is one.
    pub(crate) kept: Option<(usize, usize)>,
    pub(crate) mid: [f64; 2],
    pub(crate) half: [f64; 2],
    /// No point of it is nearer to the body.
    pub(crate) bound: f64,
}

impl PartialEq for Piece {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Piece {}

impl PartialOrd for Piece {
    fn partial_cmp(&self, other: &Self) -> Option<core::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Piece {
    fn cmp(&self, other: &Self) -> core::cmp::Ordering {
        // The least bound is the greatest piece; the rest keeps the order the same everywhere.
        other
            .bound
            .total_cmp(&self.bound)
            .then(other.leaf.cmp(&self.leaf))
            .then(other.mid[0].total_cmp(&self.mid[0]))
            .then(other.mid[1].total_cmp(&self.mid[1]))
    }
}

/// What a look at a piece tells.
pub(crate) struct Look {
    /// Its middle.
    pub(crate) place: PatchPlace,
    /// No point of it is nearer to the body.
    pub(crate) bound: f64,
    /// Where that bound is, about, in half widths from the middle.
    pub(crate) low: [f64; 2],
    /// The parameter to halve.
    pub(crate) split: usize,
    /// What was taken off the bound as the body turns.
    pub(crate) unsure: f64,
}

impl PatchTree {
    /// The middle of a piece, a bound below all its distances, and the parameter to halve. Below `aim` the
    /// bound is tried for twice where the body is not rounded.
    pub(crate) fn look(&self, body: &impl Convex, piece: &Piece, aim: f64) -> Look {
        let leaf = &self.leaves[piece.leaf];
        let made;
        let cell = match piece.kept {
            Some((_, k)) => &self.cells[k],
            None => {
                made = leaf.cell(piece.mid, piece.half);
                &made
            }
        };
        let [unsure, _] = body.slacks(cell);
        let aim = aim + unsure;
        let tangents = || tangents(body, cell, &leaf.bends, piece.half, aim);
        let (distance, bound, at) = match body.under(cell, aim) {
            Some(low) => {
                // What the form gives away shrinks with the piece; what else it does may not.
                let small = piece.half[0].max(piece.half[1]) <= SMALL;
                let more = if small && low.bound < aim { tangents().1 } else { low.bound };
                (low.middle, low.bound.max(more), low.at)
            }
            None => {
                let (distance, bound) = tangents();
                (distance, bound, [0.0; 2])
            }
        };
        let [a, b] = cell.first;
        let [p, _, r] = cell.second;
        // What strays counts too: where a border runs together in a point, the piece is short along it and strays as
        // elsewhere, and halves across the other parameter alone would never be near it.
        let [s, t] = cell.rests;
        let split = usize::from(
            b.norm_squared() + r.norm_squared() + t * t
                > a.norm_squared() + p.norm_squared() + s * s,
        );
        let uv = leaf.of_patch(piece.mid);
        let place = PatchPlace { patch: leaf.number, uv, point: cell.point, distance };
        Look { place, bound: bound - unsure, low: at, split, unsure }
    }

    /// The place of a piece where its bound is, about, if it is nearer than `limit`.
    pub(crate) fn as_deep(
        &self,
        body: &impl Convex,
        piece: &Piece,
        low: [f64; 2],
        limit: f64,
    ) -> Option<PatchPlace> {
        if piece.kept.is_some() || !low.iter().any(|x| x.abs() > 0.0) {
            return None;
        }
        let uv = [0, 1].map(|k| piece.mid[k] + low[k] * piece.half[k]);
        let leaf = &self.leaves[piece.leaf];
        let point = leaf.patch.tangents(uv[0], uv[1]).0;
        let distance = body.near(point).0;
        (distance + body.slack(point, 0.0) < limit).then_some(PatchPlace {
            patch: leaf.number,
            uv: leaf.of_patch(uv),
            point,
            distance,
        })
    }

    /// The parts of a piece: those that are kept of one that is, else its halves across the parameter `k`.
    pub(crate) fn parts(&self, piece: Piece, k: usize, put: &mut impl FnMut(Piece)) {
        let leaf = &self.leaves[piece.leaf];
        if let Some((level, _)) = piece.kept.filter(|(level, _)| *level < leaf.depth) {
            let [here, next] = [leaf.levels[level], leaf.levels[level + 1]];
            let ways = [0, 1].map(|k| next.parts[k] / here.parts[k]);
            let half = [0, 1].map(|k| piece.half[k] / ways[k] as f64);
            for j in 0..ways[1] {
                for i in 0..ways[0] {
                    let place = |k: usize, i: usize| {
                        let mid = piece.mid[k] - piece.half[k] + half[k] * (2 * i + 1) as f64;
                        (mid, next.place(k, mid))
                    };
                    let ((u, column), (v, row)) = (place(0, i), place(1, j));
                    let kept = Some((level + 1, next.first + row * next.parts[0] + column));
                    put(Piece { kept, mid: [u, v], half, ..piece });
                }
            }
            return;
        }
        let half = 0.5 * piece.half[k];
        for sign in [-1.0, 1.0] {
            let mut part = Piece { kept: None, ..piece };
            part.half[k] = half;
            part.mid[k] += sign * half;
            put(part);
        }
    }
}

/// The distance of the middle of a piece and a bound below all its distances, by a tangent to them at its middle, and where
/// that does not reach `aim` one at the place of its parallelogram that is nearest.
fn tangents(
    body: &impl Convex,
    cell: &Cell,
    bends: &Bends,
    half: [f64; 2],
    aim: f64,
) -> (f64, f64) {
    let [a, b] = cell.first;
    // The bends of the whole patch tell more of large pieces, those of the middle more of small ones.
    let falls = |slopes: [f64; 2], n: Vec3| {
        lowest(slopes, bends.rises(n, half)).max(lowest(slopes, cell.rises(n)))
    };
    let below = |n: Vec3| falls([n.dot(&a), n.dot(&b)], n);
    let ((distance, n, turn), most) = body.near_until(cell.point, aim, |n| -below(n));
    let (x, y) = (n.dot(&a), n.dot(&b));
    let bound = distance + below(n);
    // A second bound lies below the distance of the middle less what bends: worth it only above the aim.
    if bound >= aim || most + falls([0.0; 2], n) < aim {
        return (distance, bound);
    }
    // Once more from where the parallelogram comes nearest, by how fast the slope turns: a tangent there
    // hardly rises or falls over the piece.
    let to = |x: f64, a: &Vec3| (-x / (turn * a.norm_squared())).clamp(-1.0, 1.0);
    let (s, t) = (to(x, &a), to(y, &b));
    let (s, t) = (if s.is_nan() { 0.0 } else { s }, if t.is_nan() { 0.0 } else { t });
    let w = -(a * s + b * t);
    let beside = |m: Vec3| m.dot(&w) + below(m);
    let ((e, m, _), _) = body.near_until(cell.point - w, aim, |m| -beside(m));
    let beside = e + beside(m);
    (distance, bound.max(beside - body.slacks(cell)[1]))
}

/// How far a piece may lie below its middle along a vector by which its sides have these slopes and rises: the least of
/// `slope s + rise s^2 / 2` with s from -1 to 1, of both parameters together; negative or 0.
#[inline]
fn lowest(slopes: [f64; 2], rises: [f64; 2]) -> f64 {
    let of = |k: usize| {
        let (slope, rise) = (slopes[k].abs(), rises[k]);
        if rise > slope { -0.5 * slope * slope / rise } else { 0.5 * rise - slope }
    };
    of(0) + of(1)
}
