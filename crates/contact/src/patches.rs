//! A cutter against sculptured surfaces: is it clear, and how deep is it in?
//!
//! A piece of a patch is its middle point, half its derivatives, what the second derivatives there add, and what third
//! derivatives can make of it at most. Below the distance of a rounded cutter lies a form of second degree, so that
//! the bound of a piece gives away terms of third degree only (`under`). Elsewhere the distance of a convex cutter is above
//! its tangent at one place: `distance >= sd(c) - |n.a| - |n.b| - d` for a parallelogram `c +- a +- b` made thicker by `d`,
//! and more where the piece bends away. Pieces are halved until the bound decides.

use std::collections::BinaryHeap;

use aptc_geometry::sculpt::{Bends, Patch};
use aptc_geometry::{Ball, Below, Sculptured, Vec3, balls};

use crate::bodies::Convex;
use crate::under::Cell;

/// A place of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchPlace {
    /// Index of the patch, from 0.
    pub patch: usize,
    /// Its parameters.
    pub uv: [f64; 2],
    /// The point.
    pub point: Vec3,
    /// Distance of the body from it, negative inside.
    pub distance: f64,
}

/// What [`PatchTree::clear`] found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Clear {
    /// No point of the surfaces is deeper in the body than allowed: proved.
    Yes,
    /// This point is.
    No(PatchPlace),
    /// The bound of pieces was reached; the deepest place seen is within what is allowed.
    Unknown(PatchPlace),
}

/// Pieces that one question looks at, at most.
pub(crate) const PIECES: usize = 400_000;
/// Patches in a leaf.
const LEAF: usize = 4;
/// Times that a patch is divided beforehand, so that most pieces need no evaluation, and the pieces that may be kept in
/// all: each time takes four times the memory of the one before.
const KEPT: usize = 3;
const MOST: usize = 250_000;
/// A piece that strays from its parallelogram by no more than this part of the patch is not divided beforehand.
const FLAT: f64 = 2e-4;
/// A piece of half widths up to this is held against both bounds.
const SMALL: f64 = 1.0 / 128.0;
/// A side that is not shorter than this part of the other is halved with it.
const SQUARE: f64 = 0.6;

/// Surfaces prepared for questions.
#[derive(Clone, Debug, Default)]
pub struct PatchTree {
    leaves: Vec<Leaf>,
    nodes: Vec<Ball>,
    cells: Vec<Cell>,
}

/// A patch with bounds of its derivatives.
#[derive(Clone, Debug)]
struct Leaf {
    /// Its number in the surface.
    number: usize,
    patch: Patch,
    bends: Bends,
    center: Vec3,
    radius: f64,
    /// Its pieces that are kept, each level rows of as many columns as the parameter u is divided into, the whole first.
    levels: [Level; KEPT + 1],
    depth: usize,
}

/// Pieces of one size.
#[derive(Clone, Copy, Debug, Default)]
struct Level {
    /// Where the first of them is.
    first: usize,
    /// Into how many parts the parameters are divided.
    parts: [usize; 2],
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

impl PatchTree {
    /// Prepares the patches of a surface. Memory: up to 16 kB a patch, from some 3,000 on 6 kB, from 12,000 on 2 kB.
    pub fn new(surface: &Sculptured) -> Self {
        let mut leaves: Vec<Leaf> =
            surface.patches.iter().enumerate().map(|(i, p)| Leaf::new(i, p)).collect();
        let nodes = balls(&mut leaves, LEAF, |l| (l.center, l.radius));
        let mut cells = Vec::new();
        // A patch divided so often is 1, 5, 21 or 85 pieces.
        let pieces = |times: usize| leaves.len() * ((1 << (2 * times + 2)) - 1) / 3;
        let depth = (1..=KEPT).rev().find(|k| pieces(*k) <= MOST).unwrap_or(1);
        for leaf in &mut leaves {
            leaf.keep(depth, &mut cells);
        }
        Self { leaves, nodes, cells }
    }

    /// Number of patches.
    pub fn len(&self) -> usize {
        self.leaves.len()
    }

    /// Is there no patch?
    pub fn is_empty(&self) -> bool {
        self.leaves.is_empty()
    }

    /// Indices of the patches of which some point may be within `away` of the line through `from` along the unit
    /// vector `along`, rising.
    pub fn beside(&self, from: Vec3, along: Vec3, away: f64) -> Vec<usize> {
        let near = |center: Vec3, radius: f64| {
            let w = center - from;
            let reach = away + radius;
            (w - along * w.dot(&along)).norm_squared() <= reach * reach
        };
        let mut found = Vec::new();
        let mut stack: Vec<usize> = if self.nodes.is_empty() { Vec::new() } else { vec![0] };
        while let Some(node) = stack.pop().map(|i| &self.nodes[i]) {
            if !near(node.center, node.radius) {
                continue;
            }
            match node.below {
                Below::Balls(pair) => stack.extend(pair),
                Below::Things(from, to) => {
                    let leaves = self.leaves[from..to].iter();
                    found.extend(leaves.filter(|l| near(l.center, l.radius)).map(|l| l.number));
                }
            }
        }
        found.sort_unstable();
        found
    }

    /// Leaves that may come nearer to the body than `limit`, with a bound each.
    pub(crate) fn suspects(&self, body: &impl Convex, limit: f64) -> Vec<Piece> {
        let mut found = Vec::with_capacity(96);
        let mut stack: Vec<usize> = if self.nodes.is_empty() { Vec::new() } else { vec![0] };
        while let Some(i) = stack.pop() {
            let node = &self.nodes[i];
            let room = node.radius + body.slack(node.center, node.radius);
            if body.misses(node.center, limit + room) {
                continue;
            }
            match node.below {
                Below::Balls(pair) => stack.extend(pair),
                Below::Things(from, to) => {
                    for (k, leaf) in self.leaves[from..to].iter().enumerate() {
                        let room = leaf.radius + body.slack(leaf.center, leaf.radius);
                        if body.misses(leaf.center, limit + room) {
                            continue;
                        }
                        let bound = body.near_enough(leaf.center, limit + room).0 - room;
                        if bound <= limit {
                            let (mid, half) = ([0.5; 2], [0.5; 2]);
                            let kept = Some((0, leaf.levels[0].first));
                            found.push(Piece { leaf: from + k, kept, mid, half, bound });
                        }
                    }
                }
            }
        }
        found
    }

    /// Is no point of the surfaces deeper in the body than `allowed`?
    ///
    /// Replaces `INTCHK` with `REMSCN`, `REMINT` and `CURINT`: the patch in contact is treated as all others,
    /// depth alone decides, and the answer is a proof but for rounding. The witness of a No is the deepest
    /// place seen until then.
    pub fn clear(&self, body: &impl Convex, allowed: f64) -> Clear {
        let limit = -allowed;
        let mut stack = self.suspects(body, limit);
        // The most suspicious first.
        stack.sort();
        let mut deepest: Option<PatchPlace> = None;
        let mut looked = 0;
        while let Some(piece) = stack.pop() {
            looked += 1;
            let Look { mut place, bound, low, split, .. } = self.look(body, &piece, limit);
            if place.distance < limit {
                // The look tells no more than what the distance is at least.
                place.distance = body.near(place.point).0;
            }
            if place.distance < limit {
                return Clear::No(place);
            }
            if deepest.is_none_or(|d| place.distance < d.distance) {
                deepest = Some(place);
            }
            if bound >= limit {
                continue;
            }
            if looked > PIECES {
                return Clear::Unknown(deepest.unwrap_or(place));
            }
            // Is it as deep as it seems? Then it need not be halved until a middle happens to be so.
            if let Some(deep) = self.as_deep(body, &piece, low, limit) {
                return Clear::No(deep);
            }
            self.parts(piece, split, &mut |p| stack.push(p));
        }
        Clear::Yes
    }

    /// The deepest place: within `eps` of the least distance between body and surfaces, and whether that is
    /// certain. `None` without patches.
    ///
    /// Replaces `MIXAL`: pieces with the least bound are halved first, and the best place seen is taken
    /// downhill by Newton's method, until no bound is below it by more than `eps`.
    pub fn deepest(&self, body: &impl Convex, eps: f64) -> Option<(PatchPlace, bool)> {
        let mut heap: BinaryHeap<Piece> = self.suspects(body, self.reached(body)?).into();
        let mut best: Option<PatchPlace> = None;
        let mut looked = 0;
        while let Some(piece) = heap.pop() {
            if best.is_some_and(|b| piece.bound >= b.distance - eps) {
                return best.map(|b| (b, true));
            }
            looked += 1;
            let aim = best.map_or(f64::INFINITY, |b| b.distance - eps);
            let Look { place, bound, split, .. } = self.look(body, &piece, aim);
            if best.is_none_or(|b| place.distance < b.distance) {
                // The look tells no more than what the distance is at least.
                let place = PatchPlace { distance: body.near(place.point).0, ..place };
                if best.is_none_or(|b| place.distance < b.distance) {
                    best = Some(self.polish(body, &piece, place));
                }
            }
            if looked > PIECES {
                return best.map(|b| (b, false));
            }
            if best.is_none_or(|b| bound < b.distance - eps) {
                let bound = bound.max(piece.bound);
                self.parts(piece, split, &mut |p| heap.push(Piece { bound, ..p }));
            }
        }
        best.map(|b| (b, true))
    }

    /// A distance that some point of the surfaces does not exceed, from the middles of patches that look near.
    fn reached(&self, body: &impl Convex) -> Option<f64> {
        let mut node = self.nodes.first()?;
        loop {
            match node.below {
                Below::Balls(pair) => {
                    let [a, b] = pair.map(|i| &self.nodes[i]);
                    let far = |n: &Ball| body.near(n.center).0;
                    node = if far(b) < far(a) { b } else { a };
                }
                Below::Things(from, to) => {
                    let of = |leaf: &Leaf| {
                        let middle = self.cells[leaf.levels[0].first].point;
                        body.near(middle).0 + body.slack(middle, 0.0)
                    };
                    return self.leaves[from..to].iter().map(of).min_by(f64::total_cmp);
                }
            }
        }
    }

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
        let place = PatchPlace { patch: leaf.number, uv: piece.mid, point: cell.point, distance };
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
            uv,
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

    /// Downhill from a place within its patch: steepest descent in lengths, halved until it descends.
    fn polish(&self, body: &impl Convex, piece: &Piece, place: PatchPlace) -> PatchPlace {
        let patch = &self.leaves[piece.leaf].patch;
        let mut best = place;
        let mut step = piece.half;
        for _ in 0..200 {
            let [u, v] = best.uv;
            let d = patch.at(u, v);
            let (_, n, _) = body.near(d.point);
            let (gu, gv) = (n.dot(&d.u), n.dot(&d.v));
            let (su, sv) = (d.u.norm_squared().max(1e-300), d.v.norm_squared().max(1e-300));
            let size = ((gu * gu) / su + (gv * gv) / sv).sqrt();
            if size <= 1e-15 {
                break;
            }
            let scale = step[0] * su.sqrt().max(step[1] * sv.sqrt());
            let to = |t: f64, g: f64, s: f64| (t - scale * g / (s * size)).clamp(0.0, 1.0);
            let uv = [to(u, gu, su), to(v, gv, sv)];
            let point = patch.at(uv[0], uv[1]).point;
            let distance = body.near(point).0;
            if distance < best.distance {
                best = PatchPlace { uv, point, distance, ..best };
                step = step.map(|s| s * 1.2);
            } else {
                step = step.map(|s| s * 0.5);
                if step[0] + step[1] < 1e-12 {
                    break;
                }
            }
        }
        best
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
    let (distance, n, turn) = body.near_enough(cell.point, aim + cell.far);
    let (x, y) = (n.dot(&a), n.dot(&b));
    let rises = bends.rises(n, half);
    let bound = distance + lowest([x, y], rises);
    // A second bound lies below the distance of the middle less what bends: worth it only above the aim.
    if bound >= aim || distance + lowest([0.0; 2], rises) < aim {
        return (distance, bound);
    }
    // Once more from where the parallelogram comes nearest, by how fast the slope turns: a tangent there
    // hardly rises or falls over the piece.
    let to = |x: f64, a: &Vec3| (-x / (turn * a.norm_squared())).clamp(-1.0, 1.0);
    let (s, t) = (to(x, &a), to(y, &b));
    let (s, t) = (if s.is_nan() { 0.0 } else { s }, if t.is_nan() { 0.0 } else { t });
    let w = -(a * s + b * t);
    let (e, m, _) = body.near(cell.point - w);
    let slopes = [m.dot(&a), m.dot(&b)];
    let beside = e + m.dot(&w) + lowest(slopes, bends.rises(m, half));
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

impl Leaf {
    fn new(number: usize, patch: &Patch) -> Self {
        let [lo, hi] = patch.bounds();
        let center = (lo + hi) * 0.5;
        let radius =
            patch.net.iter().flatten().map(|h| (h.xyz() / h.w - center).norm()).fold(0.0, f64::max);
        let bends = Bends::of(patch, center, radius);
        let levels = [Level::default(); KEPT + 1];
        Self { number, patch: patch.clone(), bends, center, radius, levels, depth: 0 }
    }

    /// Adds its pieces to those that are kept.
    fn keep(&mut self, depth: usize, cells: &mut Vec<Cell>) {
        let mut parts = [1; 2];
        let mut size = [1.0, 1.0];
        for level in 0..=depth {
            let half = parts.map(|n| 0.5 / n as f64);
            let middle = |k: usize, i: usize| half[k] * (2 * i + 1) as f64;
            self.levels[level] = Level { first: cells.len(), parts };
            self.depth = level;
            for j in 0..parts[1] {
                cells.extend((0..parts[0]).map(|i| self.cell([middle(0, i), middle(1, j)], half)));
            }
            if level == 0 {
                size = cells[cells.len() - 1].first.map(|d| d.norm());
            }
            if self.bends.strays(half) <= FLAT * self.radius {
                break;
            }
            let sides = [0, 1].map(|k| size[k] / parts[k] as f64);
            for k in 0..2 {
                if sides[k] >= SQUARE * sides[1 - k] {
                    parts[k] *= 2;
                }
            }
        }
    }

    /// A piece by its middle and half widths.
    fn cell(&self, mid: [f64; 2], half: [f64; 2]) -> Cell {
        let d = self.patch.at(mid[0], mid[1]);
        let [hu, hv] = half;
        let first = [d.u * hu, d.v * hv];
        let far = first[0].norm() + first[1].norm() + self.bends.strays(half);
        let second = [d.uu * (0.5 * hu * hu), d.uv * (hu * hv), d.vv * (0.5 * hv * hv)];
        Cell { point: d.point, first, second, rests: self.bends.rests(half), far }
    }
}

impl Level {
    /// In which part of the parameter `k` a place is.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "0 to 1 times a few"
    )]
    fn place(&self, k: usize, at: f64) -> usize {
        (at * self.parts[k] as f64) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::sculpt::Vec4;
    use aptc_geometry::trig;
    use aptc_geometry::{Cutter, Profile, Tool};
    use proptest::prelude::*;

    fn patch(z: [f64; 16], w: f64) -> Sculptured {
        let net = core::array::from_fn(|j| {
            core::array::from_fn(|i| {
                let k = 4 * j + i;
                let w = 1.0 + w * (z[15 - k]).abs();
                Vec4::new(20.0 * i as f64 * w, 20.0 * j as f64 * w, 12.0 * z[k] * w, w)
            })
        });
        Sculptured::grid(vec![Patch::new(net)], 1, 1).unwrap()
    }

    /// Least distance over a grid, its lowest places searched again ever finer.
    fn brute(s: &Sculptured, tool: &Tool<'_>) -> f64 {
        let n = 80;
        let mut all = Vec::new();
        for i in 0..=n {
            for j in 0..=n {
                let (u, v) = (f64::from(i) / f64::from(n), f64::from(j) / f64::from(n));
                all.push((tool.distance(s.at(u, v).point), u, v));
            }
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut least = f64::INFINITY;
        for &(d, u, v) in all.iter().take(25) {
            let (mut d, mut u, mut v, mut h) = (d, u, v, 1.0 / f64::from(n));
            while h > 1e-11 {
                let mut moved = false;
                for k in 0..8 {
                    let (s8, c8) = trig::sin_cos(core::f64::consts::FRAC_PI_4 * f64::from(k));
                    let (a, b) = ((u + h * c8).clamp(0.0, 1.0), (v + h * s8).clamp(0.0, 1.0));
                    let e = tool.distance(s.at(a, b).point);
                    if e < d {
                        (d, u, v, moved) = (e, a, b, true);
                    }
                }
                if !moved {
                    h *= 0.5;
                }
            }
            least = least.min(d);
        }
        least
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        #[test]
        fn the_deepest_place_is_found(
            z in prop::array::uniform16(-1.0_f64..1.0), weights in 0..2_i32, r in 0.2_f64..5.0,
            at in prop::array::uniform2(5.0_f64..55.0), tilt in prop::array::uniform2(-0.4_f64..0.4),
            low in -6.0_f64..6.0,
        ) {
            let s = patch(z, 0.5 * f64::from(weights));
            let profile = Profile::new(&Cutter::mill(12.0, r, 60.0)).unwrap();
            let ta = Vec3::new(tilt[0], tilt[1], 1.0).normalize();
            let tool = Tool { profile: &profile, te: Vec3::new(at[0], at[1], low), ta };
            let tree = PatchTree::new(&s);
            let (found, certain) = tree.deepest(&tool, 1e-7).unwrap();
            let truth = brute(&s, &tool);
            prop_assert!(certain);
            prop_assert!(found.distance <= truth + 2e-7, "{} {}", found.distance, truth);
            prop_assert!((tool.distance(found.point) - found.distance).abs() < 1e-12);
            // The yes or no on both sides of it.
            let deep = -found.distance;
            prop_assert_eq!(tree.clear(&tool, deep + 1e-5), Clear::Yes);
            match tree.clear(&tool, deep - 1e-5) {
                Clear::No(w) => prop_assert!(w.distance < 1e-5 - deep),
                other => prop_assert!(false, "{:?}", other),
            }
        }
    }

    #[test]
    fn a_shank_that_touches_a_wall_is_found() {
        // A wall at x = 4, a ball of radius 5 whose end is far below the patch.
        let net = core::array::from_fn(|j| {
            core::array::from_fn(|i| Vec4::new(4.0, 3.0 * i as f64 - 4.5, 28.0 + j as f64, 1.0))
        });
        let s = Sculptured::grid(vec![Patch::new(net)], 1, 1).unwrap();
        let profile = Profile::new(&Cutter::mill(10.0, 5.0, 60.0)).unwrap();
        let tool = Tool { profile: &profile, te: Vec3::zeros(), ta: Vec3::z() };
        let (found, _) = PatchTree::new(&s).deepest(&tool, 1e-9).unwrap();
        assert!((found.distance + 1.0).abs() < 1e-9, "{found:?}");
    }

    #[test]
    fn many_patches_stand_in_a_tree() {
        let z = |x: f64, y: f64| trig::sin(0.3 * x) * trig::cos(0.2 * y);
        let rows: Vec<Vec<_>> = (0..31)
            .map(|j| {
                (0..31)
                    .map(|i| {
                        let (x, y) = (f64::from(i), f64::from(j));
                        aptc_geometry::sculpt::SplinePoint::plain(Vec3::new(x, y, z(x, y)))
                    })
                    .collect()
            })
            .collect();
        let s = aptc_geometry::sculpt::mesh(&rows, aptc_geometry::sculptured::MeshSpacing::Xyz)
            .unwrap();
        let tree = PatchTree::new(&s);
        assert_eq!(tree.len(), 900);
        // Along a line through it only the patches beside it.
        let beside = tree.beside(Vec3::new(12.3, 17.7, 9.0), Vec3::z(), 0.1);
        assert!(beside.contains(&(17 * 30 + 12)) && beside.len() < 10, "{beside:?}");
        let profile = Profile::new(&Cutter::mill(4.0, 2.0, 30.0)).unwrap();
        let tool = Tool { profile: &profile, te: Vec3::new(12.3, 17.7, -0.5), ta: Vec3::z() };
        let (found, certain) = tree.deepest(&tool, 1e-8).unwrap();
        let hit = aptc_geometry::sculpt::nearest_on(&s, tool.te + Vec3::z() * 2.0);
        assert!(certain && (found.distance - (hit.distance - 2.0)).abs() < 1e-7);
    }
}
