//! Levels of random hills against the number of curves that a fine grid sees.

use super::{Cutting, meet};
use crate::sculpt::Sculptured;
use crate::sculpt::bspline;
use crate::sculptured::BsplineSurface;
use crate::{Plane, Vec3};

/// Lines of the coarser grid in each direction; the finer one has twice as many.
const LINES: usize = 160;
/// So near to a height at which curves come or go no count is sure.
const CLEAR: f64 = 0.03;

/// Numbers between 0 and 1, always the same: a step of a linear congruence.
struct Dice(u64);

impl Dice {
    fn throw(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 31)
    }

    fn of(&mut self, n: usize) -> usize {
        crate::sculpt::whole(self.throw() * n as f64).min(n - 1)
    }
}

/// A cubic B-spline over a square of 40 whose parameters run evenly in x and y.
struct Hill {
    n: usize,
    heights: Vec<f64>,
    weights: Vec<f64>,
}

impl Hill {
    fn random(dice: &mut Dice) -> Self {
        let n = 5 + dice.of(5);
        let (even, flat) = (dice.throw() < 0.7, dice.throw() < 0.6);
        let top = [4.0, 14.0][dice.of(2)];
        let at = |k: usize| (k % n, k / n);
        let inner = |i: usize| i > 0 && i + 1 < n;
        let heights = (0..n * n).map(|k| {
            let z = -2.0 + (top + 2.0) * dice.throw();
            if flat && !(inner(at(k).0) && inner(at(k).1)) { 0.0 } else { z }
        });
        let heights = heights.collect();
        let weights = (0..n * n).map(|_| if even { 1.0 } else { 0.6 + 0.9 * dice.throw() });
        Self { n, heights, weights: weights.collect() }
    }

    fn knots(&self) -> Vec<f64> {
        let spans = self.n - 3;
        (0..self.n + 4).map(|i| i.saturating_sub(3).min(spans) as f64).collect()
    }

    fn surface(&self) -> Sculptured {
        let (n, knots) = (self.n, self.knots());
        let size = 40.0 / (n - 3) as f64;
        let at = |i: usize| size * (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3.0;
        let point = |k: usize| [at(k % n), at(k / n), self.heights[k], self.weights[k]];
        let all = BsplineSurface {
            degree: [3, 3],
            counts: [n, n],
            points: (0..n * n).map(point).collect(),
            range: [None, None],
            knots: [knots.clone(), knots],
        };
        bspline(&all).unwrap().0
    }

    /// The share of each control point at lines evenly over the hill, by the recurrence of Cox and de Boor.
    fn shares(&self, lines: usize) -> Vec<Vec<f64>> {
        let knots = self.knots();
        let of = |line: usize| {
            let spans = (self.n - 3) as f64;
            let t = (spans * line as f64 / lines as f64).min(spans * (1.0 - 1e-14));
            let mut b: Vec<f64> =
                knots.windows(2).map(|w| f64::from(u8::from(w[0] <= t && t < w[1]))).collect();
            for d in 1..=3 {
                let over = |a: f64, b: f64| if b > 0.0 { a / b } else { 0.0 };
                b = (0..b.len() - 1)
                    .map(|i| {
                        b[i] * over(t - knots[i], knots[i + d] - knots[i])
                            + b[i + 1] * over(knots[i + d + 1] - t, knots[i + d + 1] - knots[i + 1])
                    })
                    .collect();
            }
            b
        };
        (0..=lines).map(of).collect()
    }

    fn grid(&self, lines: usize) -> Grid {
        let (n, shares) = (self.n, self.shares(lines));
        let weighted: Vec<[f64; 2]> =
            self.heights.iter().zip(&self.weights).map(|(z, w)| [z * w, *w]).collect();
        let sum = |share: &[f64], k: &dyn Fn(usize) -> [f64; 2]| {
            let parts = share.iter().enumerate().filter(|(_, s)| **s > 0.0);
            parts.fold([0.0; 2], |a, (i, s)| [a[0] + s * k(i)[0], a[1] + s * k(i)[1]])
        };
        let mut z = Vec::with_capacity((lines + 1) * (lines + 1));
        for across in &shares {
            let row: Vec<[f64; 2]> =
                (0..n).map(|i| sum(across, &|j| weighted[j * n + i])).collect();
            z.extend(shares.iter().map(|along| sum(along, &|i| row[i])).map(|[z, w]| z / w));
        }
        Grid { n: lines + 1, z }
    }
}

/// Heights of a grid.
struct Grid {
    n: usize,
    z: Vec<f64>,
}

impl Grid {
    /// How many closed and open curves marching squares find; none where four corners are in doubt.
    fn curves(&self, level: f64) -> Option<[usize; 2]> {
        let n = self.n;
        // An edge from each corner along the row, and one across.
        let mut root: Vec<usize> = (0..2 * n * n).collect();
        let above = |i: usize, j: usize| self.z[j * n + i] > level;
        for j in 0..n - 1 {
            for i in 0..n - 1 {
                let corners = [above(i, j), above(i + 1, j), above(i + 1, j + 1), above(i, j + 1)];
                let edges = [
                    2 * (j * n + i),
                    2 * (j * n + i + 1) + 1,
                    2 * ((j + 1) * n + i),
                    2 * (j * n + i) + 1,
                ];
                let met: Vec<usize> = (0..4)
                    .filter(|k| corners[*k] != corners[(k + 1) % 4])
                    .map(|k| edges[k])
                    .collect();
                match met[..] {
                    [] => {}
                    [a, b] => {
                        let (a, b) = (top(&mut root, a), top(&mut root, b));
                        root[a] = b;
                    }
                    _ => return None,
                }
            }
        }
        let mut known = vec![None; 2 * n * n];
        for j in 0..n {
            for i in 0..n {
                for (edge, to) in [(2 * (j * n + i), (i + 1, j)), (2 * (j * n + i) + 1, (i, j + 1))]
                {
                    if to.0 >= n || to.1 >= n || above(i, j) == above(to.0, to.1) {
                        continue;
                    }
                    let at_border =
                        if edge % 2 == 0 { j == 0 || j + 1 == n } else { i == 0 || i + 1 == n };
                    let open = known[top(&mut root, edge)].get_or_insert(false);
                    *open |= at_border;
                }
            }
        }
        let count = |open: bool| known.iter().flatten().filter(|k| **k == open).count();
        Some([count(false), count(true)])
    }

    /// Heights at which curves come, go or join: of summits, hollows, saddles, and of those along the borders.
    fn critical(&self) -> Vec<f64> {
        let n = self.n;
        let mut all = Vec::new();
        for j in 0..n {
            for i in 0..n {
                let here = self.z[j * n + i];
                let inner = [i, j].map(|k| k > 0 && k + 1 < n);
                let ring: Vec<bool> = match inner {
                    [true, true] => {
                        let around =
                            [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
                        around.map(|(a, b)| self.z[(j + b - 1) * n + i + a - 1] > here).to_vec()
                    }
                    [true, false] => {
                        vec![self.z[j * n + i - 1] > here, self.z[j * n + i + 1] < here]
                    }
                    [false, true] => {
                        vec![self.z[(j - 1) * n + i] > here, self.z[(j + 1) * n + i] < here]
                    }
                    // A corner.
                    _ => vec![true; 8],
                };
                let changes =
                    (0..ring.len()).filter(|k| ring[*k] != ring[(k + 1) % ring.len()]).count();
                if changes != if ring.len() == 8 { 2 } else { 0 } {
                    all.push(here);
                }
            }
        }
        all
    }
}

fn top(root: &mut [usize], mut k: usize) -> usize {
    while root[k] != k {
        root[k] = root[root[k]];
        k = root[k];
    }
    k
}

#[test]
fn levels_of_random_hills_have_the_curves_of_a_fine_grid() {
    let mut dice = Dice(1);
    let mut judged = 0;
    for case in 0..400 {
        let hill = Hill::random(&mut dice);
        let level = 0.2 + 4.8 * dice.throw();
        let tolerance = [0.01, 0.005, 0.0025, 0.0015, 0.001, 0.0005][dice.of(6)];
        let [coarse, fine] = [LINES, 2 * LINES].map(|n| hill.grid(n));
        if fine.critical().iter().any(|z| (z - level).abs() < CLEAR) {
            continue;
        }
        let Some(expected) = coarse.curves(level).filter(|n| fine.curves(level) == Some(*n)) else {
            continue;
        };
        judged += 1;
        let s = hill.surface();
        let plane = Plane { n: Vec3::z(), d: level };
        let curves = meet((&Cutting::Plane(plane), 0.0), (&[&s], 0.0), tolerance).unwrap();
        let count = |closed: bool| curves.iter().filter(|c| c.closed == closed).count();
        assert_eq!([count(true), count(false)], expected, "case {case}");
        for c in &curves {
            let [first, .., last] = &c.points[..] else { unreachable!() };
            if c.closed {
                assert!((first.point - last.point).norm() < 1e-12, "case {case}");
            } else {
                let spans = s.spans();
                for uv in [first.sides[1].uv, last.sides[1].uv] {
                    let at_end = |k: usize| uv[k] < 1e-6 || uv[k] > spans[k] - 1e-6;
                    assert!(at_end(0) || at_end(1), "case {case}: {uv:?}");
                }
            }
        }
    }
    assert!(judged > 250, "{judged}");
}
