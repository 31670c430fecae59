//! A cutter against sculptured surfaces: is it clear, and how deep is it in?
//!
//! A piece of a patch is its middle point, half its derivatives, what the second derivatives there add, and what third
//! derivatives can make of it at most. Below the distance of a rounded cutter lies a form of second degree, so that
//! the bound of a piece gives away terms of third degree only (`under`). Elsewhere the distance of a convex cutter is above
//! its tangent at one place: `distance >= sd(c) - |n.a| - |n.b| - d` for a parallelogram `c +- a +- b` made thicker by `d`,
//! and more where the piece bends away. Pieces are halved until the bound decides.

mod leaf;
mod piece;

use std::collections::{BTreeSet, BinaryHeap};

use aptc_geometry::{Ball, Below, Sculptured, Vec3, balls};

use crate::bodies::Convex;
use crate::under::Cell;
use leaf::{KEPT, Leaf};
pub(crate) use piece::{Look, Piece};

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
pub const PIECES: usize = 400_000;
/// Steps downhill go down to this share of what is asked for.
const LITTLE: f64 = 0.1;
/// Patches in a leaf.
const LEAF: usize = 4;
/// Pieces that may be kept in all.
const MOST: usize = 250_000;

/// Surfaces prepared for questions.
#[derive(Clone, Debug, Default)]
pub struct PatchTree {
    leaves: Vec<Leaf>,
    nodes: Vec<Ball>,
    cells: Vec<Cell>,
}

impl PatchTree {
    /// Prepares the patches of a surface. Memory: up to 16 kB a patch, from some 3,000 on 6 kB, from 12,000 on 2 kB.
    pub fn new(surface: &Sculptured) -> Self {
        // What closes a hole is none of the surface.
        let patches = surface.patches.iter().enumerate().filter(|(i, _)| !surface.is_hole(*i));
        let mut leaves: Vec<Leaf> = patches.flat_map(|(i, p)| Leaf::all(i, p)).collect();
        let nodes = balls(&mut leaves, LEAF, |l| (l.center, l.radius, Vec3::repeat(l.radius)));
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
        self.leaves.iter().map(|l| l.number).collect::<BTreeSet<_>>().len()
    }

    /// Is there no patch?
    pub fn is_empty(&self) -> bool {
        self.leaves.is_empty()
    }

    /// A ball about all of them, its middle and radius. `None` without patches.
    pub fn around(&self) -> Option<(Vec3, f64)> {
        self.nodes.first().map(|ball| (ball.center, ball.radius))
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
        found.dedup();
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
        self.clear_by(body, allowed, PIECES)
    }

    /// The same with so many looks at most, after which it is unknown.
    pub fn clear_by(&self, body: &impl Convex, allowed: f64, looks: usize) -> Clear {
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
            if looked > looks {
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
                    best = Some(self.polish(body, &piece, place, eps));
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

    /// Downhill from a place within its patch: steepest descent in lengths, halved until it descends, down to steps that are
    /// little beside `eps`.
    fn polish(&self, body: &impl Convex, piece: &Piece, place: PatchPlace, eps: f64) -> PatchPlace {
        let leaf = &self.leaves[piece.leaf];
        let patch = &leaf.patch;
        let mut best = place;
        let [mut u, mut v] = piece.mid;
        let mut step = piece.half;
        for _ in 0..200 {
            let d = patch.at(u, v);
            let (_, n, _) = body.near(d.point);
            let (gu, gv) = (n.dot(&d.u), n.dot(&d.v));
            let (su, sv) = (d.u.norm_squared().max(1e-300), d.v.norm_squared().max(1e-300));
            let size = ((gu * gu) / su + (gv * gv) / sv).sqrt();
            if size <= 1e-15 {
                break;
            }
            let scale = step[0] * su.sqrt().max(step[1] * sv.sqrt());
            if scale <= LITTLE * eps {
                break;
            }
            let to = |t: f64, g: f64, s: f64| (t - scale * g / (s * size)).clamp(0.0, 1.0);
            let uv = [to(u, gu, su), to(v, gv, sv)];
            let point = patch.at(uv[0], uv[1]).point;
            let distance = body.near(point).0;
            if distance < best.distance {
                [u, v] = uv;
                best = PatchPlace { uv: leaf.of_patch(uv), point, distance, ..best };
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

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::sculpt::{Patch, Vec4};
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

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        /// With weights up to forty times as heavy as others: the patch is held in parts, and places are told in its own parameters.
        #[test]
        fn uneven_weights_hide_no_place(
            z in prop::array::uniform16(-1.0_f64..1.0), heavy in 10.0_f64..40.0,
            at in prop::array::uniform2(5.0_f64..55.0), low in -6.0_f64..6.0,
        ) {
            let s = patch(z, heavy);
            let profile = Profile::new(&Cutter::mill(12.0, 3.0, 60.0)).unwrap();
            let tool = Tool { profile: &profile, te: Vec3::new(at[0], at[1], low), ta: Vec3::z() };
            let tree = PatchTree::new(&s);
            prop_assume!(tree.leaves.len() > 1);
            prop_assert_eq!(tree.len(), 1);
            prop_assert_eq!(tree.beside(tool.te, Vec3::z(), 100.0), vec![0]);
            let (found, certain) = tree.deepest(&tool, 1e-7).unwrap();
            let [u, v] = found.uv;
            prop_assert!(certain && found.patch == 0);
            prop_assert!((s.at(u, v).point - found.point).norm() < 1e-9, "{found:?}");
            let truth = brute(&s, &tool);
            prop_assert!(found.distance <= truth + 2e-7, "{} {}", found.distance, truth);
            let deep = -found.distance;
            prop_assert_eq!(tree.clear(&tool, deep + 1e-5), Clear::Yes);
            match tree.clear(&tool, deep - 1e-5) {
                Clear::No(w) => prop_assert!((s.at(w.uv[0], w.uv[1]).point - w.point).norm() < 1e-9),
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
