//! A cutter against sculptured surfaces: is it clear, and how deep is it in?
//!
//! A piece of a patch is held by a parallelogram `c +- a +- b` made thicker by `d`: its middle point, half
//! its derivatives, and what second derivatives can bend it. The distance of a convex cutter is convex, so
//! its tangent at one place bounds it over the whole piece:
//! `distance >= sd(c) - |n.a| - |n.b| - d`. Pieces are halved until the bound decides.

use std::collections::BinaryHeap;

use aptc_geometry::sculpt::Patch;
use aptc_geometry::{Sculptured, Tool, Vec3};

/// A convex body with its signed distance, negative inside, and the unit gradient of it.
pub trait Convex {
    /// Distance of `q` and its gradient.
    fn near(&self, q: Vec3) -> (f64, Vec3);
}

impl Convex for Tool<'_> {
    #[inline]
    fn near(&self, q: Vec3) -> (f64, Vec3) {
        let n = Tool::near(self, q);
        (n.distance, n.normal)
    }
}

/// A tool with everything that it passes on the way by `by`, its axis unchanged.
#[derive(Clone, Copy, Debug)]
pub struct Swept<'a> {
    /// Where it starts.
    pub tool: Tool<'a>,
    /// The cut vector.
    pub by: Vec3,
}

impl Convex for Swept<'_> {
    /// The distance is convex along the way: its slope is halved down.
    fn near(&self, q: Vec3) -> (f64, Vec3) {
        let at = |t: f64| Convex::near(&self.tool, q - self.by * t);
        let rises = |n: Vec3| -n.dot(&self.by) > 0.0;
        let (first, last) = (at(0.0), at(1.0));
        if rises(first.1) || self.by == Vec3::zeros() {
            return first;
        }
        if !rises(last.1) {
            return last;
        }
        let (mut lo, mut hi) = (0.0, 1.0);
        let mut best = if last.0 < first.0 { last } else { first };
        for _ in 0..48 {
            let t = 0.5 * (lo + hi);
            let here = at(t);
            if here.0 < best.0 {
                best = here;
            }
            if rises(here.1) { hi = t } else { lo = t }
        }
        best
    }
}

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
const PIECES: usize = 400_000;
/// Patches in a leaf.
const LEAF: usize = 4;

/// Surfaces prepared for questions.
#[derive(Clone, Debug, Default)]
pub struct PatchTree {
    leaves: Vec<Leaf>,
    nodes: Vec<Node>,
}

/// A patch with bounds of its second derivatives.
#[derive(Clone, Debug)]
struct Leaf {
    /// Its number in the surface.
    number: usize,
    patch: Patch,
    /// Bounds of |Suu|, |Suv|, |Svv|.
    bend: [f64; 3],
    center: Vec3,
    radius: f64,
}

/// Patches within a ball: two nodes, or leaves `from..to`.
#[derive(Clone, Debug)]
struct Node {
    center: Vec3,
    radius: f64,
    below: Below,
}

#[derive(Clone, Debug)]
enum Below {
    Nodes([usize; 2]),
    Leaves(usize, usize),
}

/// A piece of a patch: middle and half widths of its parameters.
#[derive(Clone, Copy, Debug)]
struct Piece {
    leaf: usize,
    mid: [f64; 2],
    half: [f64; 2],
    /// No point of it is nearer to the body.
    bound: f64,
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
    /// Prepares the patches of a surface. Memory: about 0.7 kB a patch.
    pub fn new(surface: &Sculptured) -> Self {
        let leaves = surface.patches.iter().enumerate().map(|(i, p)| Leaf::new(i, p)).collect();
        let mut tree = Self { leaves, nodes: Vec::new() };
        let n = tree.leaves.len();
        if n > 0 {
            tree.grow(0, n);
        }
        tree
    }

    /// Number of patches.
    pub fn len(&self) -> usize {
        self.leaves.len()
    }

    /// Is there no patch?
    pub fn is_empty(&self) -> bool {
        self.leaves.is_empty()
    }

    /// Makes the node over the leaves `from..to`, sorted along its longest side, and those below it.
    fn grow(&mut self, from: usize, to: usize) -> usize {
        let all = &self.leaves[from..to];
        let (mut lo, mut hi) = (all[0].center, all[0].center);
        for l in all {
            (lo, hi) = (lo.inf(&l.center), hi.sup(&l.center));
        }
        let center = (lo + hi) * 0.5;
        let radius = all.iter().map(|l| (l.center - center).norm() + l.radius).fold(0.0, f64::max);
        let here = self.nodes.len();
        self.nodes.push(Node { center, radius, below: Below::Leaves(from, to) });
        if to - from > LEAF {
            let axis = (hi - lo).imax();
            self.leaves[from..to].sort_by(|a, b| {
                a.center[axis].total_cmp(&b.center[axis]).then(a.number.cmp(&b.number))
            });
            let mid = usize::midpoint(from, to);
            let pair = [self.grow(from, mid), self.grow(mid, to)];
            self.nodes[here].below = Below::Nodes(pair);
        }
        here
    }

    /// Leaves that may come nearer to the body than `limit`, with a bound each.
    fn suspects(&self, body: &impl Convex, limit: f64) -> Vec<Piece> {
        let mut found = Vec::new();
        let mut stack: Vec<usize> = if self.nodes.is_empty() { Vec::new() } else { vec![0] };
        while let Some(i) = stack.pop() {
            let node = &self.nodes[i];
            if body.near(node.center).0 - node.radius > limit {
                continue;
            }
            match node.below {
                Below::Nodes(pair) => stack.extend(pair),
                Below::Leaves(from, to) => {
                    for (k, leaf) in self.leaves[from..to].iter().enumerate() {
                        let bound = body.near(leaf.center).0 - leaf.radius;
                        if bound <= limit {
                            let (mid, half) = ([0.5; 2], [0.5; 2]);
                            found.push(Piece { leaf: from + k, mid, half, bound });
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
            let (place, bound, split) = self.look(body, &piece, limit);
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
            stack.extend(piece.halves(split));
        }
        Clear::Yes
    }

    /// The deepest place: within `eps` of the least distance between body and surfaces, and whether that is
    /// certain. `None` without patches.
    ///
    /// Replaces `MIXAL`: pieces with the least bound are halved first, and the best place seen is taken
    /// downhill by Newton's method, until no bound is below it by more than `eps`.
    pub fn deepest(&self, body: &impl Convex, eps: f64) -> Option<(PatchPlace, bool)> {
        let mut heap: BinaryHeap<Piece> = self.suspects(body, f64::INFINITY).into();
        let mut best: Option<PatchPlace> = None;
        let mut looked = 0;
        while let Some(piece) = heap.pop() {
            if best.is_some_and(|b| piece.bound >= b.distance - eps) {
                return best.map(|b| (b, true));
            }
            looked += 1;
            let aim = best.map_or(f64::INFINITY, |b| b.distance - eps);
            let (place, bound, split) = self.look(body, &piece, aim);
            if best.is_none_or(|b| place.distance < b.distance) {
                let polished = self.polish(body, &piece, place);
                best = Some(polished);
            }
            if looked > PIECES {
                return best.map(|b| (b, false));
            }
            if best.is_none_or(|b| bound < b.distance - eps) {
                let bound = bound.max(piece.bound);
                heap.extend(piece.halves(split).map(|h| Piece { bound, ..h }));
            }
        }
        best.map(|b| (b, true))
    }

    /// The middle of a piece, a bound below all its distances, and the parameter to halve. Below `aim` the
    /// bound is tried for twice.
    fn look(&self, body: &impl Convex, piece: &Piece, aim: f64) -> (PatchPlace, f64, usize) {
        let leaf = &self.leaves[piece.leaf];
        let [u, v] = piece.mid;
        let d = leaf.patch.at(u, v);
        let [hu, hv] = piece.half;
        let (a, b) = (d.u * hu, d.v * hv);
        let [muu, muv, mvv] = leaf.bend;
        let thick = 0.5 * hu * hu * muu + hu * hv * muv + 0.5 * hv * hv * mvv;
        let (distance, n) = body.near(d.point);
        let (x, y) = (n.dot(&a), n.dot(&b));
        let mut bound = distance - x.abs() - y.abs() - thick;
        if bound < aim {
            // Once more from the parallelogram's point that lies lowest along the gradient.
            let q = d.point - a * x.signum() - b * y.signum();
            let (e, m) = body.near(q);
            let w = d.point - q;
            let second = e + m.dot(&w) - m.dot(&a).abs() - m.dot(&b).abs() - thick;
            bound = bound.max(second);
        }
        let split = usize::from(b.norm() + 0.5 * hv * hv * mvv > a.norm() + 0.5 * hu * hu * muu);
        let place = PatchPlace { patch: leaf.number, uv: [u, v], point: d.point, distance };
        (place, bound, split)
    }

    /// Downhill from a place within its patch: steepest descent in lengths, halved until it descends.
    fn polish(&self, body: &impl Convex, piece: &Piece, place: PatchPlace) -> PatchPlace {
        let patch = &self.leaves[piece.leaf].patch;
        let mut best = place;
        let mut step = piece.half;
        for _ in 0..200 {
            let [u, v] = best.uv;
            let d = patch.at(u, v);
            let (_, n) = body.near(d.point);
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

impl Piece {
    fn halves(self, k: usize) -> [Self; 2] {
        let mut pair = [self; 2];
        let half = 0.5 * self.half[k];
        for (p, sign) in pair.iter_mut().zip([-1.0, 1.0]) {
            p.half[k] = half;
            p.mid[k] += sign * half;
        }
        pair
    }
}

impl Leaf {
    fn new(number: usize, patch: &Patch) -> Self {
        let [lo, hi] = patch.bounds();
        let center = (lo + hi) * 0.5;
        let radius =
            patch.net.iter().flatten().map(|h| (h.xyz() / h.w - center).norm()).fold(0.0, f64::max);
        Self { number, patch: patch.clone(), bend: bends(patch, center, radius), center, radius }
    }
}

/// Bounds of |Suu|, |Suv|, |Svv| from the differences of the control net.
///
/// With weights, S'' = (H'' - 2 w' S' - w'' S) / w for the homogeneous H about the middle of the patch,
/// where |S| is at most its radius.
fn bends(patch: &Patch, center: Vec3, radius: f64) -> [f64; 3] {
    let h = |j: usize, i: usize| {
        let p = patch.net[j][i];
        (p.xyz() - center * p.w, p.w)
    };
    let mut top = [[0.0_f64; 2]; 5];
    let mut least = f64::INFINITY;
    let mut raise = |k: usize, v: Vec3, w: f64| {
        top[k][0] = top[k][0].max(v.norm());
        top[k][1] = top[k][1].max(w.abs());
    };
    for a in 0..4 {
        for b in 0..4 {
            least = least.min(h(a, b).1);
            if b < 3 {
                let (p, q) = (h(a, b), h(a, b + 1));
                raise(0, (q.0 - p.0) * 3.0, 3.0 * (q.1 - p.1));
                let (p, q) = (h(b, a), h(b + 1, a));
                raise(1, (q.0 - p.0) * 3.0, 3.0 * (q.1 - p.1));
            }
            if b < 2 {
                let (p, q, r) = (h(a, b), h(a, b + 1), h(a, b + 2));
                raise(2, (p.0 - q.0 * 2.0 + r.0) * 6.0, 6.0 * (p.1 - 2.0 * q.1 + r.1));
                let (p, q, r) = (h(b, a), h(b + 1, a), h(b + 2, a));
                raise(4, (p.0 - q.0 * 2.0 + r.0) * 6.0, 6.0 * (p.1 - 2.0 * q.1 + r.1));
            }
            if a < 3 && b < 3 {
                let (p, q, r, s) = (h(a, b), h(a, b + 1), h(a + 1, b), h(a + 1, b + 1));
                raise(3, (p.0 - q.0 - r.0 + s.0) * 9.0, 9.0 * (p.1 - q.1 - r.1 + s.1));
            }
        }
    }
    let [[hu, wu], [hv, wv], [huu, wuu], [huv, wuv], [hvv, wvv]] = top;
    if !patch.rational {
        return [huu / least, huv / least, hvv / least];
    }
    let (su, sv) = ((hu + wu * radius) / least, (hv + wv * radius) / least);
    [
        (huu + 2.0 * wu * su + wuu * radius) / least,
        (huv + wu * sv + wv * su + wuv * radius) / least,
        (hvv + 2.0 * wv * sv + wvv * radius) / least,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::sculpt::Vec4;
    use aptc_geometry::{Cutter, Profile};
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
                    let (s8, c8) =
                        aptc_geometry::trig::sin_cos(core::f64::consts::FRAC_PI_4 * f64::from(k));
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
    fn a_way_is_the_union_of_its_places() {
        let profile = Profile::new(&Cutter::mill(12.0, 2.0, 40.0)).unwrap();
        let tool = Tool { profile: &profile, te: Vec3::new(1.0, 2.0, 3.0), ta: Vec3::z() };
        let by = Vec3::new(7.0, -3.0, 1.5);
        let swept = Swept { tool, by };
        for k in 0..60 {
            let f = f64::from(k);
            let q = Vec3::new(
                15.0 * aptc_geometry::trig::sin(f),
                12.0 * aptc_geometry::trig::cos(1.3 * f),
                10.0 * aptc_geometry::trig::sin(0.7 * f),
            );
            let least = (0..=4000)
                .map(|i| tool.at(tool.te + by * (f64::from(i) / 4000.0)).distance(q))
                .fold(f64::INFINITY, f64::min);
            let (d, n) = swept.near(q);
            assert!(d <= least + 1e-12 && d > least - 1e-3, "{k} {d} {least}");
            assert!((n.norm() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn many_patches_stand_in_a_tree() {
        let z =
            |x: f64, y: f64| aptc_geometry::trig::sin(0.3 * x) * aptc_geometry::trig::cos(0.2 * y);
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
        let s = aptc_geometry::sculpt::mesh(&rows, false).unwrap();
        let tree = PatchTree::new(&s);
        assert_eq!(tree.len(), 900);
        let profile = Profile::new(&Cutter::mill(4.0, 2.0, 30.0)).unwrap();
        let tool = Tool { profile: &profile, te: Vec3::new(12.3, 17.7, -0.5), ta: Vec3::z() };
        let (found, certain) = tree.deepest(&tool, 1e-8).unwrap();
        let hit = aptc_geometry::sculpt::nearest_on(&s, tool.te + Vec3::z() * 2.0);
        assert!(certain && (found.distance - (hit.distance - 2.0)).abs() < 1e-7);
    }
}
