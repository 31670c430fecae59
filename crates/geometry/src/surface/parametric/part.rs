//! How a surface turns and bends near a tool: bounds over a rectangle of its parameters that holds all of it there, here of a
//! ruled one, over the cells of a sculptured one in `cells/part.rs`.

use super::ruled::Rulings;
use super::samples::steps;
use super::{ParametricSurface, Patch};
use crate::Vec3;

/// Least singular value of the derivatives as unit vectors from which a part is bounded.
const SQUARE: f64 = 0.1;
/// Greatest turn of the normals, as a vector.
pub(super) const MOST_TURN: f64 = 1.0;
/// Parts across the rulings in which normals are bounded, and curvatures.
const WHOLE: u32 = 3;
const FINE: u32 = 3;

/// Bounds over a part of a surface.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// By how much normals differ, as vectors, from that of the place that was asked for.
    pub turn: f64,
    /// Least and greatest curvature, positive where the surface bends away from its normal.
    pub curvature: [f64; 2],
    /// The same of those across the rulings, of which one principal curvature is no less and one no greater; zeros, which bound
    /// nothing, of a surface without rulings.
    pub across: [f64; 2],
    /// Direction of the ruling of that place; zero without rulings, and then `lean` and `twist` are zero too.
    pub ruling: Vec3,
    /// By how much those of the others differ from it, as vectors.
    pub lean: f64,
    /// By how much the normal turns along a ruling, in each unit of its length.
    pub twist: f64,
}

/// Parameters before the first ruling at which the straight continuation is cut into strips; the same behind the last one.
const BEFORE: [f64; 6] = [-0.5, -0.3, -0.18, -0.1, -0.05, -0.02];

/// Rulings next to each other and what lies between them.
#[derive(Clone, Debug)]
pub(super) struct Strips {
    us: Vec<f64>,
    rulings: Vec<Ruling>,
    /// The same of some at a time, which are far from most of what is asked for.
    groups: Vec<Ruling>,
    /// Base line and direction of both curves, whose height is along that.
    curves: [[Vec3; 2]; 2],
    /// Of each strip and curve the first and second derivatives of the height, least and greatest.
    heights: Vec<[[[f64; 2]; 2]; 2]>,
}

/// Rulings of a group.
const GROUP: usize = 5;

/// One of them, with the halves of the strips beside it.
#[derive(Clone, Copy, Debug)]
struct Ruling {
    /// Its place at `v` 0, its derivative by `v` and one over the square of that.
    start: Vec3,
    way: Vec3,
    inverse: f64,
    /// No place of these halves is farther from that of the ruling with the same `v` than at `v` 0 and 1 (as convex as it
    /// is in `v`), and by how much more that is for each unit of `v`.
    wide: [f64; 2],
    wider: f64,
    /// What is left of 1 without the square of that, as a share of the ruling's length.
    left: f64,
}

/// A ball of vectors: its middle and radius.
type Vectors = (Vec3, f64);

impl Strips {
    /// Those of rulings in `pieces`; `None` where a curve is steep or has joints, and where rulings turn far from one to the next.
    pub(super) fn new(surface: &Rulings) -> Option<Self> {
        let curves = surface.rails()?;
        let mut us = BEFORE.to_vec();
        us.extend(steps(surface.pieces()));
        us.extend(BEFORE.iter().rev().map(|u| 1.0 - u));
        let strip = |ends: &[f64]| Some([surface.slopes(0, ends)?, surface.slopes(1, ends)?]);
        let heights: Option<Vec<_>> = us.windows(2).map(strip).collect();
        let (rulings, groups) = (Vec::new(), Vec::new());
        let mut new = Self { us, rulings, groups, curves, heights: heights? };
        let n = new.us.len();
        new.rulings = (0..n).map(|i| new.ruling(surface, i, 0.5, [i, i + 1])).collect();
        let group = |first: usize| {
            let end = (first + GROUP).min(n);
            new.ruling(surface, (first + end) / 2, 1.0, [first, end])
        };
        new.groups = (0..n).step_by(GROUP).map(group).collect();
        let narrow = new.rulings.iter().all(|r| r.left > 0.5);
        narrow.then_some(new)
    }

    /// That of number `i`, with the `share` of the strips beside those from `first` up to `end`.
    fn ruling(&self, surface: &Rulings, i: usize, share: f64, [first, end]: [usize; 2]) -> Ruling {
        let jet = surface.jet(self.us[i], 0.0);
        let strips = first.saturating_sub(1)..end.min(self.heights.len());
        let away = |u: f64| share * (u - self.us[i]).abs();
        let far = away(self.us[strips.start]).max(away(self.us[strips.end]));
        let (mut wide, mut wider) = ([0.0_f64; 2], 0.0_f64);
        for strip in strips {
            // Beside a ruling of its own each strip counts by its own width.
            let half = if end - first == 1 {
                away(self.us[strip]) + away(self.us[strip + 1])
            } else {
                far
            };
            let [(a, ra), (b, rb)] = self.first(&self.heights[strip]);
            wide = [wide[0].max(half * (a.norm() + ra)), wide[1].max(half * (b.norm() + rb))];
            wider = wider.max(half * ((b - a).norm() + ra + rb));
        }
        let inverse = 1.0 / jet.sv.norm_squared();
        let left = 1.0 - wider * wider * inverse;
        Ruling { start: jet.s, way: jet.sv, inverse, wide, wider, left }
    }

    /// Least and greatest derivatives of the heights over some strips.
    fn over(&self, from: usize, to: usize) -> [[[f64; 2]; 2]; 2] {
        let both = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        self.heights[from..to].iter().copied().fold(self.heights[from], |mut all, strip| {
            for (all, strip) in all.iter_mut().zip(strip) {
                *all = [both(all[0], strip[0]), both(all[1], strip[1])];
            }
            all
        })
    }

    /// Derivatives by `u` of both curves, where those of their heights are so.
    fn first(&self, heights: &[[[f64; 2]; 2]; 2]) -> [Vectors; 2] {
        let of = |[base, up]: &[Vec3; 2], range: [f64; 2]| {
            let (mid, half) = middle(range);
            (base + up * mid, half)
        };
        [of(&self.curves[0], heights[0][0]), of(&self.curves[1], heights[1][0])]
    }

    /// Least and greatest `u` and `v` of the surface within the balls, and within the last of them alone; `None` at a border.
    fn rectangles(&self, balls: &[(Vec3, f64)], domain: [f64; 2]) -> Option<[[[f64; 2]; 2]; 2]> {
        let none = ([usize::MAX, 0], [f64::INFINITY, f64::NEG_INFINITY]);
        let (mut all, mut alone) = (none, none);
        let chunks = (0..).step_by(GROUP).zip(self.rulings.chunks(GROUP));
        for (group, (first, rulings)) in self.groups.iter().zip(chunks) {
            for (n, ball) in balls.iter().enumerate() {
                if !group.near(*ball) {
                    continue;
                }
                for (k, r) in rulings.iter().enumerate() {
                    let Some([least, most]) = r.within(*ball) else { continue };
                    let i = first + k;
                    let put = |(across, v): &mut ([usize; 2], [f64; 2])| {
                        *across = [across[0].min(i), across[1].max(i)];
                        *v = [v[0].min(least), v[1].max(most)];
                    };
                    put(&mut all);
                    if n + 1 == balls.len() {
                        put(&mut alone);
                    }
                }
            }
        }
        let half = |i: usize| 0.5 * (self.us[i] + self.us[i + 1]);
        let kept = |([first, last], v): ([usize; 2], [f64; 2])| {
            let inside = first > 0 && first <= last && last + 1 < self.us.len();
            let kept = inside && v[0] > domain[0] && v[1] < domain[1];
            kept.then(|| [[half(first - 1), half(last)], v])
        };
        Some([kept(all)?, kept(alone)?])
    }
}

impl Ruling {
    /// Where on the ruling it is nearest to a ball, the distance there that is left of its strips, and a measure of what of them
    /// is within the ball: none where that is less than zero.
    #[inline(always)]
    fn reach(&self, (center, radius): (Vec3, f64)) -> [f64; 3] {
        let away = center - self.start;
        let at = away.dot(&self.way) * self.inverse;
        let off = (away - self.way * at).norm_squared();
        let reach = radius + (1.0 - at).abs() * self.wide[0] + at.abs() * self.wide[1];
        // Along the ruling by x, in units of v, the strip is as wide as `reach + wider x`: where the square of that is
        // less than that of the distance nothing is within the ball.
        [at, reach, reach * reach - self.left * off]
    }

    /// May any of its strips be within the ball?
    fn near(&self, ball: (Vec3, f64)) -> bool {
        let [_, _, square] = self.reach(ball);
        self.left <= 0.0 || square >= 0.0
    }

    /// Least and greatest `v` of what is within the ball.
    fn within(&self, ball: (Vec3, f64)) -> Option<[f64; 2]> {
        let [at, reach, square] = self.reach(ball);
        (square >= 0.0).then(|| {
            let half = reach * self.wider * self.inverse + (square * self.inverse).sqrt();
            let half = half / self.left;
            [at - half, at + half]
        })
    }
}

/// Length of a vector of two.
fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// Middle and half width.
fn middle(range: [f64; 2]) -> (f64, f64) {
    (0.5 * (range[0] + range[1]), 0.5 * (range[1] - range[0]))
}

/// Bounds over a rectangle of the parameters about its middle.
struct Bounds {
    /// The normal there, and by how much the others differ from it, as vectors.
    normal: Vec3,
    turn: f64,
    /// Length of its derivatives, which bound the second fundamental form, and the least singular value of the pair as unit vectors.
    sides: [f64; 2],
    least: f64,
    /// Greatest square of the first one's length, as a share of that in the middle.
    longest: f64,
    bend: Vectors,
    twist: Vectors,
    /// The derivative along the rulings.
    along: Vectors,
    /// Is the square of the distance of each point asked for convex over it?
    convex: bool,
}

impl Bounds {
    /// Those between `u` and `v`, the square of the distance from the points of the ball `from`; `None` where they tell nothing.
    fn new(
        (strips, rulings): (&Strips, &Rulings),
        [u, v]: [[f64; 2]; 2],
        from: (Vec3, f64),
    ) -> Option<Self> {
        let first = strips.us.iter().rposition(|x| *x <= u[0])?;
        let last = strips.us.iter().position(|x| *x >= u[1])?;
        let heights = strips.over(first, last);
        let ((um, hu), (vm, hv)) = (middle(u), middle(v));
        let most = |f: fn(f64) -> f64| f(v[0]).abs().max(f(v[1]).abs());
        let [to_first, to_second] = [most(|v| 1.0 - v), most(|v| v)];
        let [(a, ra), (b, rb)] = strips.first(&heights);
        let (twist, rt) = (b - a, ra + rb);
        let across = a + twist * vm;
        let r_across = to_first * ra + to_second * rb + hv * twist.norm();
        let place = rulings.jet(um, vm);
        let (along, r_along) = (place.sv, hu * (twist.norm() + rt));
        let second = |i: usize| {
            let (mid, half) = middle(heights[i][1]);
            (strips.curves[i][1] * mid, half)
        };
        let ((x, rx), (y, ry)) = (second(0), second(1));
        let (bend, r_bend) =
            (x + (y - x) * vm, to_first * rx + to_second * ry + hv * (y - x).norm());
        // With both derivatives as unit vectors in the middle: least and greatest singular value of the pair.
        let (lu, lv) = (across.norm(), along.norm());
        let cos = (across.dot(&along) / (lu * lv)).abs().min(1.0);
        let off = length(r_across / lu, r_along / lv);
        let (least, most) = ((1.0 - cos).sqrt() - off, (1.0 + cos).sqrt() + off);
        (least > SQUARE).then_some(())?;
        // The second derivatives of half the square of the distance are the products of the first ones and w S_ij, with w from
        // the point to the place; along a direction w is no longer than its parts.
        let round = most * length(lu * hu, lv * hv);
        let w = place.s - from.0;
        let farthest = w.norm() + from.1 + round;
        let extent = |d: Vec3| {
            let (u, v) = (across.dot(&d).abs(), along.dot(&d).abs());
            from.1 * d.norm() + hu * (u + r_across * d.norm()) + hv * (v + r_along * d.norm())
        };
        let uu = (w.dot(&bend) - extent(bend)).min(0.0) - farthest * r_bend;
        let uv = w.dot(&twist).abs() + extent(twist) + farthest * rt;
        let (x, y) = (0.5 * uu / (lu * lu), uv / (lu * lv));
        let convex = least * least + x - (x * x + y * y).sqrt() > 0.0;
        // The normal turns along with the derivatives across it: by the second derivatives over the least singular value.
        let l = (bend.norm() + r_bend) / (lu * lu);
        let m = (twist.norm() + rt) / (lu * lv);
        let (x, y) = (lu * hu, lv * hv);
        let turn = length(l * x + m * y, m * x) / least;
        let normal = place.su.cross(&place.sv).try_normalize(0.0)?;
        let (sides, bend, twist) = ([lu, lv], (bend, r_bend), (twist, rt));
        let longest = 1.0 + r_across / lu;
        let longest = longest * longest;
        let along = (along, r_along);
        Some(Self { normal, turn, sides, least, longest, bend, twist, along, convex })
    }

    /// Least and greatest curvature, positive where the surface bends away from its normal, and those across the rulings.
    fn curvature(&self) -> [[f64; 2]; 2] {
        let (n, [lu, lv]) = (self.normal, self.sides);
        // Second fundamental form l xx + 2 m xy, whose eigenvalues rise with l.
        let around = |(v, r): Vectors| (-n.dot(&v), self.turn * v.norm() + r);
        let ((l, rl), (m, rm)) = (around(self.bend), around(self.twist));
        let across = [l - rl, l + rl].map(|l| l / (lu * lu));
        let [low, high] = across.map(|l| 0.5 * l);
        let m = (m.abs() + rm) / (lu * lv);
        let root = |l: f64| (l * l + m * m).sqrt();
        let square = self.least * self.least;
        let least = |l: f64| if l < 0.0 { l / square } else { l / self.longest };
        let across = [least(across[0]), -least(-across[1])];
        [[(low - root(low)) / square, (high + root(high)) / square], across]
    }

    /// By how much directions of rulings differ from this one, as vectors, and by how much the normal turns along one.
    fn rulings(&self, direction: Vec3) -> [f64; 2] {
        let (along, off) = self.along;
        let [lu, lv] = self.sides;
        let lean = (along / lv - direction).norm() + off / (lv - 0.5 * off);
        // No normal turns about a ruling: what is left of its second fundamental form is that with the other direction.
        let (v, r) = self.twist;
        let twist = self.normal.dot(&v).abs() + self.turn * v.norm() + r;
        [lean, twist / (lu * lv * self.least * self.least)]
    }
}

/// Equal parts of an interval.
fn parts([a, b]: [f64; 2], n: u32) -> impl Iterator<Item = [f64; 2]> {
    let at = move |i: u32| if i == n { b } else { a + (b - a) * f64::from(i) / f64::from(n) };
    (0..n).map(move |i| [at(i), at(i + 1)])
}

impl ParametricSurface {
    /// Bounds over a part that holds the place with the parameters `near` and all of the surface within the balls, and that
    /// has one nearest place to each point of the ball `from`: the square of the distance is convex over the parameters. The
    /// curvatures are those within the last one of the balls.
    ///
    /// `None` where that is not seen: at a border, at joints, where the normals turn far, and of other surfaces than ruled
    /// and sculptured ones.
    pub fn part(&self, balls: &[(Vec3, f64)], from: (Vec3, f64), near: [f64; 2]) -> Option<Part> {
        if let Patch::Sculptured(spans) = &self.patch {
            let here = spans.jet(near[0], near[1]);
            let n = here.su.cross(&here.sv).try_normalize(0.0)?;
            return spans.cells().part(balls, from, (near, n));
        }
        let (strips, Patch::Ruled(rulings)) = (self.strips.as_ref()?, &self.patch) else {
            return None;
        };
        let surface = (strips, rulings.as_ref());
        let [all, within] = strips.rectangles(balls, rulings.domain().v)?;
        let wider = |ends: [f64; 2], x: f64| [ends[0].min(x), ends[1].max(x)];
        let [all, within] = [all, within].map(|[u, v]| [wider(u, near[0]), wider(v, near[1])]);
        let here = rulings.jet(near[0], near[1]);
        let n = here.su.cross(&here.sv).try_normalize(0.0)?;
        let mut turn = 0.0_f64;
        for u in parts(all[0], WHOLE) {
            let bounds = Bounds::new(surface, [u, all[1]], from)?;
            turn = turn.max((bounds.normal - n).norm() + bounds.turn);
            if !bounds.convex || turn > MOST_TURN {
                return None;
            }
        }
        let mut found = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let (ruling, [mut lean, mut twist]) = (here.sv.normalize(), [0.0_f64; 2]);
        for u in parts(within[0], FINE) {
            let bounds = Bounds::new(surface, [u, within[1]], from)?;
            let (part, [leans, twists]) = (bounds.curvature(), bounds.rulings(ruling));
            (lean, twist) = (lean.max(leans), twist.max(twists));
            for (all, [least, most]) in found.iter_mut().zip(part) {
                *all = [all[0].min(least), all[1].max(most)];
            }
        }
        let [curvature, across] = found;
        Some(Part { turn, curvature, across, ruling, lean, twist })
    }
}
