//! The cells of a sculptured surface in the making: of its patches, and of what goes on beyond their borders.

use core::array;

use super::super::sculptured::jet;
use super::super::{Domain, Jet};
use super::{Cell, Smooth};
use crate::Vec3;
use crate::sculpt::{Bends, Layout, Patch, Sculptured, Vec4};

/// Where the continuation is divided, in shares of it: it bends the more the farther out.
const SHARES: [f64; 5] = [0.0, 0.03125, 0.125, 0.375, 1.0];

/// The cells of a surface over 0 to 1 and beyond as the domain says.
pub(super) fn cells(surface: &Sculptured, domain: &Domain) -> Vec<Cell> {
    let whole = |n: usize| (0..=n).map(|k| k as f64).collect::<Vec<_>>();
    let knots = match &surface.layout {
        Layout::Mesh { u, v } => [u.clone(), v.clone()],
        Layout::Patches => [whole(surface.patches.len()), whole(1)],
    };
    let cut = match surface.patches.len() {
        0..=4 => 8,
        5..=25 => 4,
        26..=400 => 2,
        _ => 1,
    };
    let mut put = Put { cells: Vec::new(), surface, place: [0; 2] };
    // What closes a hole is a continuation, as all that lies beyond the borders.
    let alone = [domain.u, domain.v].iter().all(|[low, high]| *low >= 0.0 && *high <= 1.0);
    for (index, patch) in surface.patches.iter().enumerate() {
        if alone && surface.is_hole(index) {
            continue;
        }
        put.patch(patch, index, &knots, cut, domain);
    }
    put.cells
}

/// Greatest derivatives along a border: of the border twice, and of the slope across it once and twice.
struct Edge {
    twice: f64,
    slope: f64,
    slope_twice: f64,
}

/// Cells in the making.
struct Put<'a> {
    cells: Vec<Cell>,
    surface: &'a Sculptured,
    /// Column and row of the patch at hand.
    place: [usize; 2],
}

impl Put<'_> {
    fn cell(&mut self, mid: [f64; 2], half: [f64; 2], bend: [(Vec3, f64); 3], smooth: Smooth) {
        let jet = self.jet(mid[0], mid[1]);
        self.cells.push(Cell::new(self.place, [mid, half], bend, smooth, &jet));
    }

    /// At which borders of the patch its neighbour goes on without an edge, or the straight continuation.
    fn smooth(&self, patch: &Patch, index: usize, count: [usize; 2], domain: &Domain) -> Smooth {
        let at = [index % count[0], index / count[0]];
        let continued = [domain.u, domain.v].map(|ends| [ends[0] < 0.0, ends[1] > 1.0]);
        let mesh = matches!(self.surface.layout, Layout::Mesh { .. });
        [0, 1].map(|k| {
            let step = if k == 0 { 1 } else { count[0] };
            [0, 1].map(|end| {
                let last = if end == 0 { at[k] == 0 } else { at[k] + 1 == count[k] };
                if last || !mesh {
                    return last && mesh && continued[k][end] && !patch.ends_in_point(k, end);
                }
                let other = if end == 0 { index - step } else { index + step };
                let other = &self.surface.patches[other];
                let [low, high] = if end == 0 { [other, patch] } else { [patch, other] };
                match k {
                    0 => goes_on(low, high),
                    _ => goes_on(&low.exchanged(), &high.exchanged()),
                }
            })
        })
    }

    fn jet(&self, u: f64, v: f64) -> Jet {
        jet(self.surface, Some(self.place), u, v)
    }

    /// The cells of a patch and of what goes on beyond its borders.
    fn patch(
        &mut self,
        patch: &Patch,
        index: usize,
        knots: &[Vec<f64>; 2],
        cut: usize,
        domain: &Domain,
    ) {
        let spans = self.surface.spans();
        let count = [knots[0].len() - 1, knots[1].len() - 1];
        let place = [index % count[0], index / count[0]];
        self.place = place;
        // Where the patch begins and how wide it is, in parameters of the whole.
        let from = [0, 1].map(|k| knots[k][place[k]] / spans[k]);
        let width = [0, 1].map(|k| (knots[k][place[k] + 1] - knots[k][place[k]]) / spans[k]);
        let n = cut as f64;
        let borders = self.smooth(patch, index, count, domain);
        let smooth = |k: usize, i: usize| [i > 0 || borders[k][0], i + 1 < cut || borders[k][1]];
        let share = |i: usize| [i as f64 / n, (i + 1) as f64 / n];
        let half = width.map(|w| 0.5 * w / n);
        let middle = |k: usize, i: usize| from[k] + width[k] * (i as f64 + 0.5) / n;
        for j in 0..cut {
            for i in 0..cut {
                let part = patch.part(share(i), share(j));
                let balls = bends(&part).balls();
                let bend = balls.map(|(m, r)| (m * 0.25, r * 0.25));
                self.cell([middle(0, i), middle(1, j)], half, bend, [smooth(0, i), smooth(1, j)]);
            }
        }
        let out = [0, 1].map(|k| {
            let ends = if k == 0 { domain.u } else { domain.v };
            let (first, last) = (place[k] == 0, place[k] + 1 == count[k]);
            let goes_on = |end: usize| !patch.ends_in_point(k, end);
            [
                (first && ends[0] < 0.0 && goes_on(0)).then_some([0.0, ends[0]]),
                (last && ends[1] > 1.0 && goes_on(1)).then_some([1.0, ends[1]]),
            ]
        });
        // Beyond the borders across u, then across v.
        for k in 0..2 {
            for (side, range) in out[k].iter().enumerate() {
                let Some(range) = range else { continue };
                for i in 0..cut {
                    let part = if k == 0 {
                        patch.part([0.0, 1.0], share(i))
                    } else {
                        patch.part(share(i), [0.0, 1.0]).exchanged()
                    };
                    let edge = Edge::of(&part, side);
                    for (mid_out, half_out, far) in stretches(*range) {
                        let out = outwards(side, *range, far);
                        let rate = 1.0 / width[k];
                        let twist = edge.slope * rate * half_out * 0.5;
                        let along = (edge.twice + far * rate * edge.slope_twice) * 0.25;
                        let zero = (Vec3::zeros(), 0.0);
                        let (twist, along) = ((Vec3::zeros(), twist), (Vec3::zeros(), along));
                        if k == 0 {
                            let mid = [mid_out, middle(1, i)];
                            let smooth = [out, smooth(1, i)];
                            self.cell(mid, [half_out, half[1]], [zero, twist, along], smooth);
                        } else {
                            let mid = [middle(0, i), mid_out];
                            let smooth = [smooth(0, i), out];
                            self.cell(mid, [half[0], half_out], [along, twist, zero], smooth);
                        }
                    }
                }
            }
        }
        // Beyond the corners the surface goes on doubly straight.
        let ends = |k: usize| out[k].iter().enumerate().filter_map(|(end, r)| Some((end, (*r)?)));
        for (end_u, range_u) in ends(0) {
            for (end_v, range_v) in ends(1) {
                for (mu, hu, far_u) in stretches(range_u) {
                    for (mv, hv, far_v) in stretches(range_v) {
                        let twist = self.jet(mu, mv).suv * (hu * hv);
                        let zero = (Vec3::zeros(), 0.0);
                        let smooth =
                            [outwards(end_u, range_u, far_u), outwards(end_v, range_v, far_v)];
                        self.cell([mu, mv], [hu, hv], [zero, (twist, 0.0), zero], smooth);
                    }
                }
            }
        }
    }
}

/// Does the second patch go on where the first ends along u, in its direction all along the border?
fn goes_on(first: &Patch, second: &Patch) -> bool {
    /// Share of the derivatives by which they may be off that direction.
    const OFF: f64 = 1e-9;
    let way = |p: &Patch, i: usize| array::from_fn::<_, 4, _>(|j| p.net[j][i + 1] - p.net[j][i]);
    let (before, after) = (way(first, 2), way(second, 0));
    let dot = |a: &[Vec4; 4], b: &[Vec4; 4]| a.iter().zip(b).map(|(a, b)| a.dot(b)).sum::<f64>();
    let square = dot(&before, &before);
    let rate = dot(&before, &after) / square;
    let off = array::from_fn(|j| after[j] - before[j] * rate);
    let meet = (0..4).map(|j| (second.net[j][0] - first.net[j][3]).norm_squared()).sum::<f64>();
    rate > 0.0 && dot(&off, &off) <= OFF * OFF * dot(&after, &after) && meet <= OFF * OFF * square
}

/// Middle, half width and greatest distance from the border of the stretches from a border to an end.
fn stretches([border, end]: [f64; 2]) -> impl Iterator<Item = (f64, f64, f64)> {
    let way = end - border;
    SHARES
        .windows(2)
        .map(|w| [w[0], w[1]])
        .collect::<Vec<_>>()
        .into_iter()
        .map(move |[a, b]| (border + 0.5 * (a + b) * way, 0.5 * (b - a) * way.abs(), b * way.abs()))
}

/// At which ends a stretch that reaches so `far` from the border goes on, beyond the low or the high end of the parameter: at
/// both, but for the last.
fn outwards(end: usize, [border, last]: [f64; 2], far: f64) -> [bool; 2] {
    let goes_on = far < (last - border).abs();
    if end == 0 { [goes_on, true] } else { [true, goes_on] }
}

/// A ball that holds the control points.
fn held(patch: &Patch) -> (Vec3, f64) {
    let [lo, hi] = patch.bounds();
    let center = (lo + hi) * 0.5;
    let far = |h: &Vec4| (h.xyz() / h.w - center).norm();
    (center, patch.net.iter().flatten().map(far).fold(0.0, f64::max))
}

fn bends(patch: &Patch) -> Bends {
    let (center, radius) = held(patch);
    Bends::of(patch, center, radius)
}

impl Edge {
    /// Along the border u = 0 or 1 of a patch: with S = H / w and the slope T = (H' - w' S) / w, all about the middle of
    /// the patch, the derivatives along the border follow from those of w S = H and w T = H' - w' S.
    fn of(patch: &Patch, side: usize) -> Self {
        let (center, r) = held(patch);
        let at = |j: usize, i: usize| {
            let h = patch.net[j][i];
            let p = h.xyz() - center * h.w;
            Vec4::new(p.x, p.y, p.z, h.w)
        };
        let border: [Vec4; 4] = array::from_fn(|j| at(j, 3 * side));
        let across: [Vec4; 4] = array::from_fn(|j| (at(j, 2 * side + 1) - at(j, 2 * side)) * 3.0);
        let least = border.iter().map(|h| h.w).fold(f64::INFINITY, f64::min);
        let [(_, _), (h1, w1), (h2, w2)] = greatest(&border);
        let [(d0, e0), (d1, e1), (d2, e2)] = greatest(&across);
        let s1 = (h1 + w1 * r) / least;
        let s2 = (h2 + 2.0 * w1 * s1 + w2 * r) / least;
        let t0 = (d0 + e0 * r) / least;
        let t1 = (d1 + s1 * e0 + r * e1 + t0 * w1) / least;
        let t2 = (d2 + s2 * e0 + 2.0 * s1 * e1 + r * e2 + 2.0 * t1 * w1 + t0 * w2) / least;
        Self { twice: s2, slope: t1, slope_twice: t2 }
    }
}

/// Greatest lengths of the coordinates, and of the weight, of a cubic and its two derivatives.
fn greatest(b: &[Vec4; 4]) -> [(f64, f64); 3] {
    let of = |all: &[Vec4]| {
        let top = |m: (f64, f64), h: &Vec4| (m.0.max(h.xyz().norm()), m.1.max(h.w.abs()));
        all.iter().fold((0.0, 0.0), top)
    };
    let first: [Vec4; 3] = array::from_fn(|k| (b[k + 1] - b[k]) * 3.0);
    let second: [Vec4; 2] = array::from_fn(|k| (first[k + 1] - first[k]) * 2.0);
    [of(b), of(&first), of(&second)]
}
