//! The deepest place of a cutter in a patch, against a grid whose every low place is polished.
//!
//! Nothing here is shared with what is tested: patch, cutter and search are written once more.

#[path = "support/random.rs"]
mod random;

use aptc_contact::{Clear, PatchTree, Tool};
use aptc_geometry::sculpt::{Patch, Vec4};
use aptc_geometry::{Cutter, Profile, Sculptured, Vec3};
use random::Dice;

type V = [f64; 3];

fn add(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
fn scaled(a: V, s: f64) -> V {
    [a[0] * s, a[1] * s, a[2] * s]
}
fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A patch by its control points, row by row along u.
#[derive(Clone)]
struct Net([[V; 4]; 4]);

impl Net {
    fn sculptured(&self) -> Sculptured {
        let net = self.0.map(|row| row.map(|p| Vec4::new(p[0], p[1], p[2], 1.0)));
        Sculptured::grid(vec![Patch::new(net)], 1, 1).expect("one patch")
    }

    /// The four points of the curve along u at `v`, then the point on it, by de Casteljau.
    fn row(&self, v: f64) -> [V; 4] {
        [0, 1, 2, 3].map(|i| cubic([0, 1, 2, 3].map(|j| self.0[j][i]), v))
    }

    fn point(&self, u: f64, v: f64) -> V {
        cubic(self.row(v), u)
    }

    fn size(&self) -> f64 {
        self.0.iter().flatten().map(|p| dot(*p, *p).sqrt()).fold(0.0, f64::max)
    }
}

fn cubic(b: [V; 4], t: f64) -> V {
    let s = 1.0 - t;
    let w = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    let mut p = [0.0; 3];
    for (b, w) in b.iter().zip(w) {
        p = add(p, scaled(*b, w));
    }
    p
}

/// CUTTER/d,r with straight sides: tool end, unit axis, corner radius, distance of its centre from the axis,
/// height.
#[derive(Clone, Copy)]
struct Mill {
    te: V,
    ta: V,
    r: f64,
    e: f64,
    h: f64,
}

impl Mill {
    /// Signed distance, negative inside.
    fn distance(&self, q: V) -> f64 {
        let w = add(q, scaled(self.te, -1.0));
        let z = dot(w, self.ta);
        let radial = add(w, scaled(self.ta, -z));
        let rho = dot(radial, radial).sqrt();
        let wide = self.e + self.r;
        // Inside, the nearest of floor, side, top and corner; outside, the nearest point of them.
        if rho > self.e && z < self.r {
            let corner = ((rho - self.e).powi(2) + (z - self.r).powi(2)).sqrt() - self.r;
            return if corner > 0.0 { corner } else { corner.max(z - self.h).max(rho - wide) };
        }
        let (side, up) = (rho - wide, z - self.h);
        if side > 0.0 && up > 0.0 {
            return (side * side + up * up).sqrt();
        }
        side.max(up).max(-z)
    }

    fn tool<'a>(&self, profile: &'a Profile) -> Tool<'a> {
        Tool { profile, te: Vec3::from(self.te), ta: Vec3::from(self.ta) }
    }

    fn profile(&self) -> Profile {
        let c = Cutter::mill(2.0 * (self.e + self.r), self.r, self.h);
        Profile::new(&c).expect("a mill")
    }
}

/// The least distance: a grid of `n` by `n` cells, then Newton's method with differences from every place that is
/// no higher than its neighbours, and a search of shrinking steps where that stalls at an edge or fold.
fn truth(net: &Net, mill: &Mill, n: usize) -> f64 {
    let of = |k: usize| k as f64 / n as f64;
    let mut all = vec![0.0; (n + 1) * (n + 1)];
    for j in 0..=n {
        let row = net.row(of(j));
        for i in 0..=n {
            all[j * (n + 1) + i] = mill.distance(cubic(row, of(i)));
        }
    }
    let at = |i: usize, j: usize| all[j * (n + 1) + i];
    let floor = all.iter().copied().fold(f64::INFINITY, f64::min);
    let mut least = floor;
    for j in 0..=n {
        for i in 0..=n {
            let here = at(i, j);
            let low = (i.saturating_sub(1)..=(i + 1).min(n))
                .all(|a| (j.saturating_sub(1)..=(j + 1).min(n)).all(|b| at(a, b) >= here));
            // A place that lies higher than a cell can be deep cannot hold the least.
            if low && here < floor + net.size() * 4.0 / n as f64 {
                least = least.min(polished(net, mill, [of(i), of(j)], 1.0 / n as f64));
            }
        }
    }
    least
}

fn polished(net: &Net, mill: &Mill, start: [f64; 2], cell: f64) -> f64 {
    let f = |x: [f64; 2]| mill.distance(net.point(x[0], x[1]));
    let held = |x: [f64; 2]| x.map(|t: f64| t.clamp(0.0, 1.0));
    let (mut x, mut here) = (start, f(start));
    for _ in 0..30 {
        let h = 1e-5;
        let d = |a: f64, b: f64| f([x[0] + a * h, x[1] + b * h]);
        let (e, w, n, s) = (d(1.0, 0.0), d(-1.0, 0.0), d(0.0, 1.0), d(0.0, -1.0));
        let g = [(e - w) / (2.0 * h), (n - s) / (2.0 * h)];
        let (a, c) = ((e - 2.0 * here + w) / (h * h), (n - 2.0 * here + s) / (h * h));
        let b = (d(1.0, 1.0) - d(1.0, -1.0) - d(-1.0, 1.0) + d(-1.0, -1.0)) / (4.0 * h * h);
        let det = a * c - b * b;
        if det <= 0.0 || a <= 0.0 {
            break;
        }
        let step = [(c * g[0] - b * g[1]) / det, (a * g[1] - b * g[0]) / det];
        let next = held([x[0] - step[0].clamp(-cell, cell), x[1] - step[1].clamp(-cell, cell)]);
        let there = f(next);
        if there >= here {
            break;
        }
        (x, here) = (next, there);
    }
    let mut h = cell;
    while h > 1e-13 {
        let mut moved = false;
        for k in 0..16 {
            let turn = std::f64::consts::TAU * f64::from(k) / 16.0;
            let (s, c) = aptc_geometry::trig::sin_cos(turn);
            let next = held([x[0] + h * c, x[1] + h * s]);
            let there = f(next);
            if there < here {
                (x, here, moved) = (next, there, true);
            }
        }
        if !moved {
            h *= 0.5;
        }
    }
    here
}

/// One of the first `n` whole numbers.
fn below(dice: &mut Dice, n: u64) -> usize {
    usize::try_from(dice.next() % n).expect("less than n")
}

/// A random patch with a random mill pushed into it.
fn case(dice: &mut Dice) -> (Net, Mill) {
    let rough = [3.0, 12.0, 30.0][below(dice, 3)];
    let mut net = Net([[[0.0; 3]; 4]; 4]);
    for (j, row) in net.0.iter_mut().enumerate() {
        for (i, p) in row.iter_mut().enumerate() {
            let jitter = |d: &mut Dice| d.within(-3.0, 3.0);
            let (x, y) = (20.0 * i as f64 + jitter(dice), 20.0 * j as f64 + jitter(dice));
            *p = [x, y, rough * dice.within(-1.0, 1.0)];
        }
    }
    let wide = dice.within(2.0, 20.0);
    let r = match below(dice, 3) {
        0 => wide,
        1 => 0.0,
        _ => wide * dice.within(0.05, 0.7),
    };
    let (e, h) = (wide - r, wide + dice.within(20.0, 80.0));
    let (s, c) = aptc_geometry::trig::sin_cos(dice.within(0.0, 0.6));
    let (sa, ca) = aptc_geometry::trig::sin_cos(dice.within(0.0, std::f64::consts::TAU));
    let ta = [s * ca, s * sa, c];
    let [u, v] = [dice.within(0.05, 0.95), dice.within(0.05, 0.95)];
    let deep = dice.within(-0.1, 0.35) * wide;
    let te = add(net.point(u, v), scaled(ta, -deep));
    (net, Mill { te, ta, r, e, h })
}

fn held(net: &Net, mill: &Mill, n: usize, eps: f64) -> (f64, f64) {
    let profile = mill.profile();
    let tree = PatchTree::new(&net.sculptured());
    let tool = mill.tool(&profile);
    let (found, _) = tree.deepest(&tool, eps).expect("a patch");
    // What is said of the place is so.
    assert!((mill.distance(found.point.into()) - found.distance).abs() < 1e-10);
    let at = net.point(found.uv[0], found.uv[1]);
    assert!((Vec3::from(at) - found.point).norm() < 1e-10);
    (found.distance, truth(net, mill, n))
}

/// In 2,000 random cases no place of a 400 x 400 grid, polished, is deeper than the one found by more than
/// 1e-9 of the size.
#[test]
fn the_deepest_of_two_thousand() {
    let mut dice = Dice::new(90);
    let mut worst = 0.0_f64;
    for k in 0..2000 {
        let (net, mill) = case(&mut dice);
        let size = net.size();
        let (found, truth) = held(&net, &mill, 400, 1e-9 * size);
        assert!(found <= truth + 1e-9 * size, "{k}: {found} against {truth}");
        worst = worst.max((found - truth) / size);
        if k % 20 == 0 {
            // Yes and no on both sides of it.
            let (profile, tree) = (mill.profile(), PatchTree::new(&net.sculptured()));
            let tool = mill.tool(&profile);
            assert_eq!(tree.clear(&tool, 1e-6 - found), Clear::Yes, "{k}");
            assert!(matches!(tree.clear(&tool, -1e-6 - found), Clear::No(_)), "{k}");
        }
    }
    assert!(worst <= 1e-9, "{worst}");
}

fn from(z: impl Fn(f64, f64) -> f64) -> Net {
    let row = |j: i32| [0, 1, 2, 3].map(|i| (f64::from(i), f64::from(j)));
    Net([0, 1, 2, 3].map(|j| row(j).map(|(i, j)| [20.0 * i, 20.0 * j, z(i, j)])))
}

fn upright(te: V, wide: f64, r: f64) -> Mill {
    Mill { te, ta: [0.0, 0.0, 1.0], r, e: wide - r, h: 60.0 }
}

#[test]
fn ridge_saddle_corner_and_fit() {
    // A ridge narrower than the cutter: its top stands beside the middle of the flat.
    let ridge = from(|i, _| if (i - 1.0).abs() < 0.5 { 30.0 } else { 0.0 });
    // A saddle.
    let saddle = from(|i, j| (i - 1.5) * (j - 1.5) * 9.0);
    // An edge drawn together in one point.
    let mut corner = from(|i, j| 4.0 * i - 3.0 * j);
    corner.0[0] = [[30.0, 0.0, 2.0]; 4];
    for net in [&ridge, &saddle, &corner] {
        for (wide, r) in [(9.0, 9.0), (9.0, 2.0), (9.0, 0.0)] {
            for te in [[22.0, 28.0, 1.0], [30.0, 2.0, 0.5], [31.0, 30.0, -1.0]] {
                let mill = upright(te, wide, r);
                let size = net.size();
                let (found, truth) = held(net, &mill, 400, 1e-9 * size);
                assert!(found <= truth + 1e-9 * size, "{wide} {r} {te:?}: {found} {truth}");
            }
        }
    }
}

/// A trough of the cutter's own radius touches it along a line: any place of it is the deepest.
#[test]
fn a_cutter_that_fits_exactly() {
    let plane = from(|_, _| 5.0);
    let flat = upright([30.0, 30.0, 4.0], 9.0, 0.0);
    let (found, _) = held(&plane, &flat, 100, 1e-9);
    assert!((found + 1.0).abs() < 1e-12, "{found}");
    // A parabola of curvature 1/12 at its bottom, and a ball of radius 12 in it.
    let bowl = |x: f64| x * x / 24.0;
    let trough = Net([0, 1, 2, 3].map(|j| {
        let y = 20.0 * f64::from(j);
        // Control points of the parabola over -30..30.
        let (a, s) = (bowl(-30.0), -30.0 / 12.0);
        let z = [a, a + s * 20.0, a + s * 20.0, a];
        [(0.0, z[0]), (1.0, z[1]), (2.0, z[2]), (3.0, z[3])].map(|(i, z)| [20.0 * i - 30.0, y, z])
    }));
    for deep in [0.0, 0.3, -0.2] {
        let ball = upright([0.0, 30.0, -deep], 12.0, 12.0);
        let (found, truth) = held(&trough, &ball, 200, 1e-9);
        assert!((found - truth).abs() < 1e-9, "{found} {truth}");
        // Above the centre of curvature two places of the sides are nearer than the bottom.
        assert!(if deep < 0.0 { found < 0.2 } else { (found + deep).abs() < 1e-9 }, "{found}");
    }
}
