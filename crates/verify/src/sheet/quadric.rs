//! Quadrics in their principal axes, each kind with charts that have no pole on the surface.

use aptc_geometry::{Vec3, trig};

use super::slack::{SLACK, Slack};
use super::{Jet, Patch, Patches, Spot};

/// Eigenvalues and linear terms below this fraction of the greatest are rounding.
const STRAIGHT: f64 = 1e-13;

/// A quadric `sum lambda y^2 + 2 beta . y + k = 0` in its own system.
#[derive(Clone, Debug)]
pub(crate) struct Quadric {
    lambda: Vec3,
    beta: Vec3,
    k: f64,
    shape: Shape,
    /// Where it hardly bends along an axis: all of it about the origin.
    slack: Option<Loose>,
}

/// A quadric that hardly bends along an axis, in the system of its sheet.
#[derive(Clone, Debug)]
struct Loose {
    charts: Slack,
    /// Which of the axes here are those of the quadric's own system, in which its shape is given, and where the middle of that
    /// is, along the axes here.
    order: [usize; 3],
    middle: Vec3,
}

impl Loose {
    /// A vector of the quadric's own system.
    fn turned(&self, y: Vec3) -> Vec3 {
        let mut x = Vec3::zeros();
        for (i, at) in self.order.into_iter().enumerate() {
            x[at] = y[i];
        }
        x
    }

    /// A place in the quadric's own system.
    fn own(&self, x: Vec3) -> Vec3 {
        let x = x - self.middle;
        Vec3::from(self.order.map(|i| x[i]))
    }
}

/// What it is; lengths are semi-axes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    /// Six charts: a cube's faces blown up to the unit sphere, scaled.
    Ellipsoid(Vec3),
    /// `x2/a2 + y2/b2 - z2/c2 = 1`, over z / c and the angle.
    OneSheet(Vec3),
    /// `z2/c2 - x2/a2 - y2/b2 = 1`, two graphs over x and y.
    TwoSheets(Vec3),
    /// `x2/a2 + y2/b2 = z2/c2`, over z / c and the angle.
    Cone(Vec3),
    /// `z = p x2 + q y2`, over x and y.
    Paraboloid(f64, f64),
    /// `x2/a2 + y2/b2 = 1`, over the angle and z.
    EllipticRod(f64, f64),
    /// `x2/a2 - y2/b2 = 1`, two charts over y / b and z.
    HyperbolicRod(f64, f64),
    /// `z = p x2`, over x and y.
    ParabolicRod(f64),
}

impl Quadric {
    /// Axes and origin of the own system, and the quadric in it, from the ten coefficients; `None` for
    /// planes, pairs of planes, lines, points and nothing.
    pub(crate) fn new(c: &[f64; 10]) -> Option<([Vec3; 3], Vec3, Self)> {
        let greatest = c.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        if !(greatest > 0.0 && greatest.is_finite()) {
            return None;
        }
        let [a, b, d, k, f, g, h, p, q, r] = c.map(|x| x / greatest);
        let (mut axes, mut lambda) = eigen([[a, h, g], [h, b, f], [g, f, d]]);
        let top = lambda.iter().fold(0.0_f64, |m, l| m.max(l.abs()));
        let linear = Vec3::new(p, q, r);
        for l in &mut lambda {
            if l.abs() <= STRAIGHT * top {
                *l = 0.0;
            }
        }
        let straight: Vec<usize> = (0..3).filter(|&i| lambda[i] == 0.0).collect();
        if let [i, j] = straight[..] {
            // The linear part has one direction: it becomes an axis.
            let across = axes[i] * axes[i].dot(&linear) + axes[j] * axes[j].dot(&linear);
            if across.norm() > STRAIGHT * linear.norm() {
                let w = across.normalize();
                let other = axes[3 - i - j];
                (axes[i], axes[j]) = (w.cross(&other), w);
            }
        }
        let loose = Self::loose(&axes, lambda, linear, k);
        let mut beta = axes.map(|e| e.dot(&linear));
        let mut origin = Vec3::zeros();
        let mut k = k;
        for i in 0..3 {
            if lambda[i] != 0.0 {
                let shift = -beta[i] / lambda[i];
                origin += axes[i] * shift;
                k -= beta[i] * beta[i] / lambda[i];
                beta[i] = 0.0;
            } else if beta[i].abs() <= STRAIGHT * linear.norm() {
                beta[i] = 0.0;
            }
        }
        if let Some(i) = (0..3).find(|&i| beta[i] != 0.0) {
            origin -= axes[i] * (k / (2.0 * beta[i]));
            k = 0.0;
        }
        let (order, shape) = classify(lambda, beta, k)?;
        let pick = |x: [f64; 3]| Vec3::new(x[order[0]], x[order[1]], x[order[2]]);
        let mut own = Self { lambda: pick(lambda), beta: pick(beta), k, shape, slack: None };
        let Some((at, begin, charts)) = loose else {
            return Some((order.map(|i| axes[i]), origin, own));
        };
        // The axes of the sheet are those of its charts.
        let place = |i: usize| at.iter().position(|a| *a == i).unwrap_or(i);
        let middle = Vec3::from(at.map(|i| axes[i].dot(&(origin - begin))));
        own.slack = Some(Loose { charts, order: order.map(place), middle });
        Some((at.map(|i| axes[i]), begin, own))
    }

    /// The order of the axes with one last that hardly bends, where the system begins, and the charts about there; `None` where
    /// all bend or are straight.
    fn loose(
        axes: &[Vec3; 3],
        lambda: [f64; 3],
        linear: Vec3,
        mut k: f64,
    ) -> Option<([usize; 3], Vec3, Slack)> {
        let top = lambda.iter().fold(0.0_f64, |m, l| m.max(l.abs()));
        let slack = |i: usize| lambda[i].abs() <= SLACK * top;
        let mut beta = axes.map(|e| e.dot(&linear));
        let rounded =
            |i: usize| lambda[i] != 0.0 || beta[i] != 0.0 && beta[i].abs() <= SLACK * linear.norm();
        if !(0..3).any(|i| slack(i) && rounded(i)) {
            return None;
        }
        let mut origin = Vec3::zeros();
        for i in (0..3).filter(|&i| !slack(i)) {
            origin -= axes[i] * (beta[i] / lambda[i]);
            k -= beta[i] * beta[i] / lambda[i];
            beta[i] = 0.0;
        }
        let steep = |&i: &usize, &j: &usize| beta[i].abs().total_cmp(&beta[j].abs());
        let last = (0..3).filter(|&i| slack(i)).max_by(steep)?;
        let mut order = [(last + 1) % 3, (last + 2) % 3, last];
        // What opens to both sides does so along the first.
        if lambda[order[0]] * k > 0.0 {
            order.swap(0, 1);
        }
        let pick = |x: [f64; 3]| Vec3::from(order.map(|i| x[i]));
        Some((order, origin, Slack::new(pick(lambda), pick(beta), k)?))
    }

    pub(crate) fn value(&self, y: Vec3) -> f64 {
        if let Some(Loose { charts: s, .. }) = &self.slack {
            return (s.half_gradient(y) + s.beta).dot(&y) + s.k;
        }
        self.lambda.component_mul(&y).dot(&y) + 2.0 * self.beta.dot(&y) + self.k
    }

    fn half_gradient(&self, y: Vec3) -> Vec3 {
        self.lambda.component_mul(&y) + self.beta
    }

    /// Bounds of the change of the unit normal over a piece with the middle `y` and these half sides, from which it strays so far,
    /// split between two parameters.
    pub(crate) fn turn(&self, chart: usize, y: Vec3, side: [Vec3; 2], stray: [f64; 2]) -> [f64; 2] {
        let reach = [0, 1].map(|i| side[i].norm() + stray[i]);
        let Some(loose) = &self.slack else { return self.turn_within(y, reach) };
        if !Slack::has(chart) {
            return self.turn_within(loose.own(y), reach);
        }
        let s = &loose.charts;
        let by = |i: usize| s.lambda.component_mul(&side[i]).norm() + s.lambda.amax() * stray[i];
        turned(s.half_gradient(y).norm(), [by(0), by(1)])
    }

    /// The same over distances from a place of the own system.
    fn turn_within(&self, y: Vec3, reach: [f64; 2]) -> [f64; 2] {
        let g = self.half_gradient(y).norm();
        // Along a ruling of a cylinder the normal stays, and of a cone as far as its vertex.
        let reach = match self.shape {
            Shape::Cone(_) if y.z.abs() > reach[0] => [0.0, reach[1]],
            Shape::EllipticRod(..) | Shape::HyperbolicRod(..) | Shape::ParabolicRod(_) => {
                [reach[0], 0.0]
            }
            _ => reach,
        };
        turned(g, reach.map(|r| self.lambda.amax() * r))
    }

    pub(crate) fn roots(&self, center: Vec3, radius: f64, out: &mut Patches) -> bool {
        let Some(loose) = &self.slack else { return self.own_roots(center, radius, out) };
        let told = loose.charts.roots(center, radius, out);
        told.unwrap_or_else(|| self.own_roots(loose.own(center), radius, out))
    }

    fn own_roots(&self, center: Vec3, radius: f64, out: &mut Patches) -> bool {
        const PI: f64 = std::f64::consts::PI;
        let mut push = |chart: usize, at: [f64; 2], half: [f64; 2]| {
            out.push(Patch { chart, at, half, ..Patch::default() })
        };
        let (c, r) = (center, radius);
        match self.shape {
            Shape::Ellipsoid(_) => (0..6).all(|i| push(i, [0.0; 2], [1.0; 2])),
            Shape::OneSheet(s) | Shape::Cone(s) => (0..4).all(|i| {
                push(0, [c.z / s.z, PI * (0.5 * f64::from(i) - 0.75)], [r / s.z, PI / 4.0])
            }),
            Shape::TwoSheets(_) => (0..2).all(|i| push(i, [c.x, c.y], [r, r])),
            Shape::Paraboloid(..) | Shape::ParabolicRod(_) => push(0, [c.x, c.y], [r, r]),
            Shape::EllipticRod(..) => {
                (0..4).all(|i| push(0, [PI * (0.5 * f64::from(i) - 0.75), c.z], [PI / 4.0, r]))
            }
            Shape::HyperbolicRod(_, b) => (0..2).all(|i| push(i, [c.y / b, c.z], [r / b, r])),
        }
    }

    pub(crate) fn jet(&self, spot: &Spot) -> Jet {
        let Some(loose) = &self.slack else { return self.own_jet(spot) };
        if Slack::has(spot.chart) {
            return loose.charts.jet(spot);
        }
        let Jet { p, d, n } = self.own_jet(spot);
        let d = d.map(|d| loose.turned(d));
        Jet { p: loose.turned(p) + loose.middle, d, n: loose.turned(n) }
    }

    fn own_jet(&self, spot: &Spot) -> Jet {
        let [u, v] = spot.at;
        let sheet = if spot.chart == 0 { 1.0 } else { -1.0 };
        let (p, du, dv) = match self.shape {
            Shape::Ellipsoid(s) => blown_up(s, spot.chart, u, v),
            Shape::OneSheet(s) => {
                let w = (1.0 + u * u).sqrt();
                around(s, u, v, w, u / w)
            }
            Shape::Cone(s) => around(s, u, v, u, 1.0),
            Shape::TwoSheets(s) => {
                let (x, y) = (u / s.x, v / s.y);
                let w = (1.0 + x * x + y * y).sqrt();
                let z = sheet * s.z;
                (
                    Vec3::new(u, v, z * w),
                    Vec3::new(1.0, 0.0, z * x / (s.x * w)),
                    Vec3::new(0.0, 1.0, z * y / (s.y * w)),
                )
            }
            Shape::Paraboloid(p, q) => (
                Vec3::new(u, v, p * u * u + q * v * v),
                Vec3::new(1.0, 0.0, 2.0 * p * u),
                Vec3::new(0.0, 1.0, 2.0 * q * v),
            ),
            Shape::ParabolicRod(p) => {
                (Vec3::new(u, v, p * u * u), Vec3::new(1.0, 0.0, 2.0 * p * u), Vec3::y())
            }
            Shape::EllipticRod(a, b) => {
                let (sin, cos) = trig::sin_cos(u);
                (Vec3::new(a * cos, b * sin, v), Vec3::new(-a * sin, b * cos, 0.0), Vec3::z())
            }
            Shape::HyperbolicRod(a, b) => {
                let w = (1.0 + u * u).sqrt();
                (
                    Vec3::new(sheet * a * w, b * u, v),
                    Vec3::new(sheet * a * u / w, b, 0.0),
                    Vec3::z(),
                )
            }
        };
        let n = crate::solid::unit_or(self.half_gradient(p), Vec3::z());
        Jet { p, d: [du, dv], n }
    }

    pub(crate) fn settle(&self, spot: Spot) -> Spot {
        if let Some(loose) = self.slack.as_ref().filter(|_| Slack::has(spot.chart)) {
            return loose.charts.settle(spot);
        }
        let Shape::Ellipsoid(s) = self.shape else { return spot };
        if spot.at.iter().all(|x| x.abs() <= 1.5) {
            return spot;
        }
        // Onto the face of the cube in whose direction the place lies.
        let (p, ..) = blown_up(s, spot.chart, spot.at[0], spot.at[1]);
        let y = p.component_div(&s);
        let i = y.iamax();
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let chart = if y[i] > 0.0 { i } else { i + 3 };
        Spot { chart, at: [y[j] / y[i].abs(), y[k] / y[i].abs()] }
    }

    pub(crate) fn second(&self, patch: &Patch) -> [f64; 3] {
        if let Some(loose) = self.slack.as_ref().filter(|_| Slack::has(patch.chart)) {
            return loose.charts.second(patch);
        }
        let far = |i: usize| patch.at[i].abs() + patch.half[i];
        match self.shape {
            // Those of the unit sphere, stretched by the semi-axes.
            Shape::Ellipsoid(s) => {
                let top = s.max();
                [SPHERE_UU * top, SPHERE_UV * top, SPHERE_UU * top]
            }
            Shape::OneSheet(s) => {
                let (wide, u) = (s.x.max(s.y), far(0));
                [wide, wide * u / (1.0 + u * u).sqrt(), wide * (1.0 + u * u).sqrt()]
            }
            Shape::Cone(s) => {
                let wide = s.x.max(s.y);
                [0.0, wide, wide * far(0)]
            }
            Shape::TwoSheets(s) => {
                let [a, b] = [s.x, s.y];
                [s.z / (a * a), s.z * 0.5 / (a * b), s.z / (b * b)]
            }
            Shape::Paraboloid(p, q) => [2.0 * p.abs(), 0.0, 2.0 * q.abs()],
            Shape::ParabolicRod(p) => [2.0 * p.abs(), 0.0, 0.0],
            Shape::EllipticRod(a, b) => [a.max(b), 0.0, 0.0],
            Shape::HyperbolicRod(a, _) => [a, 0.0, 0.0],
        }
    }

    /// Second derivatives in the middle of a piece, and how much they differ on it: uu, uv, vv.
    pub(crate) fn bend(&self, patch: &Patch) -> ([Vec3; 3], [f64; 3]) {
        let Some(loose) = &self.slack else { return self.own_bend(patch) };
        if Slack::has(patch.chart) {
            return loose.charts.bend(patch);
        }
        let (bend, vary) = self.own_bend(patch);
        (bend.map(|b| loose.turned(b)), vary)
    }

    fn own_bend(&self, patch: &Patch) -> ([Vec3; 3], [f64; 3]) {
        let [u, v] = patch.at;
        let [hu, hv] = patch.half;
        let none = Vec3::zeros();
        let up = |x: f64| Vec3::new(0.0, 0.0, x);
        match self.shape {
            Shape::Paraboloid(p, q) => ([up(2.0 * p), none, up(2.0 * q)], [0.0; 3]),
            Shape::ParabolicRod(p) => ([up(2.0 * p), none, none], [0.0; 3]),
            Shape::EllipticRod(a, b) => {
                let (sin, cos) = trig::sin_cos(u);
                ([-Vec3::new(a * cos, b * sin, 0.0), none, none], [a.max(b) * hu, 0.0, 0.0])
            }
            Shape::HyperbolicRod(a, _) => {
                let a = if patch.chart == 0 { a } else { -a };
                let w = 1.0 + u * u;
                let bend = Vec3::new(a / (w * w.sqrt()), 0.0, 0.0);
                ([bend, none, none], [ROOT_UUU * a.abs() * hu, 0.0, 0.0])
            }
            Shape::Ellipsoid(s) => {
                let [same, mixed] = SPHERE_UUU.map(|x| x * s.max());
                let vary = [same * hu + mixed * hv, mixed * (hu + hv), mixed * hu + same * hv];
                (blown_up_bend(s, patch.chart, u, v), vary)
            }
            Shape::OneSheet(s) => {
                let (wide, far) = (s.x.max(s.y), u.abs() + hu);
                let w = (1.0 + u * u).sqrt();
                let bend = around_bend(s, v, [w, u / w, 1.0 / (w * w * w)]);
                let top = (1.0 + far * far).sqrt();
                let vary = [ROOT_UUU * hu + hv, hu + hv, hu + top * hv];
                (bend, vary.map(|x| wide * x))
            }
            Shape::Cone(s) => {
                let (wide, far) = (s.x.max(s.y), u.abs() + hu);
                (around_bend(s, v, [u, 1.0, 0.0]), [0.0, wide * hv, wide * (hu + far * hv)])
            }
            Shape::TwoSheets(_) => ([none; 3], self.second(patch)),
        }
    }
}

/// Bounds of the change of a unit normal along which the gradient `g` has half its length, which changes by so much.
fn turned(g: f64, change: [f64; 2]) -> [f64; 2] {
    let rest = g - change[0] - change[1];
    if rest > 0.5 * g {
        return change.map(|c| c / rest);
    }
    // Unit normals are never farther apart; the greater share is to the parameter that turns more.
    change.map(|c| 2.0 * c / (change[0] + change[1]).max(f64::MIN_POSITIVE))
}

/// Bound of the third derivative of `sqrt(1 + u^2)`.
const ROOT_UUU: f64 = 0.86;
/// Bounds of the third derivatives of `(1, u, v) / |(1, u, v)|`: uuu and vvv, uuv and uvv.
const SPHERE_UUU: [f64; 2] = [3.0 + 1e-9, 1.0 + 1e-9];

/// Bounds of the second derivatives of `(1, u, v) / |(1, u, v)|`: uu and vv, uv.
const SPHERE_UU: f64 = 1.2;
const SPHERE_UV: f64 = 0.7;

fn blown_up(s: Vec3, chart: usize, u: f64, v: f64) -> (Vec3, Vec3, Vec3) {
    let (i, sign) = if chart < 3 { (chart, 1.0) } else { (chart - 3, -1.0) };
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    let mut r = Vec3::zeros();
    (r[i], r[j], r[k]) = (sign, u, v);
    let n = (1.0 + u * u + v * v).sqrt();
    let p = r / n;
    let along = |axis: usize, w: f64| {
        let mut e = Vec3::zeros();
        e[axis] = 1.0;
        (e - p * (w / n)) / n
    };
    let (du, dv) = (along(j, u), along(k, v));
    (p.component_mul(&s), du.component_mul(&s), dv.component_mul(&s))
}

/// Second derivatives of the face of a cube blown up to the ellipsoid.
fn blown_up_bend(s: Vec3, chart: usize, u: f64, v: f64) -> [Vec3; 3] {
    let (i, sign) = if chart < 3 { (chart, 1.0) } else { (chart - 3, -1.0) };
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    let (mut r, mut along_u, mut along_v) = (Vec3::zeros(), Vec3::zeros(), Vec3::zeros());
    (r[i], r[j], r[k]) = (sign, u, v);
    (along_u[j], along_v[k]) = (1.0, 1.0);
    // Of 1 / n with n^2 = 1 + u^2 + v^2.
    let n = (1.0 + u * u + v * v).sqrt();
    let (cube, fifth) = (1.0 / (n * n * n), 3.0 / (n * n * n * n * n));
    let [du, dv] = [-u * cube, -v * cube];
    let [uu, uv, vv] = [u * u * fifth - cube, u * v * fifth, v * v * fifth - cube];
    [
        along_u * (2.0 * du) + r * uu,
        along_u * dv + along_v * du + r * uv,
        along_v * (2.0 * dv) + r * vv,
    ]
    .map(|p| p.component_mul(&s))
}

/// Second derivatives of `(a w cos v, b w sin v, c u)`, from w and its derivatives by u.
fn around_bend(s: Vec3, v: f64, [w, dw, ddw]: [f64; 3]) -> [Vec3; 3] {
    let (sin, cos) = trig::sin_cos(v);
    let out = Vec3::new(s.x * cos, s.y * sin, 0.0);
    [out * ddw, Vec3::new(-s.x * sin, s.y * cos, 0.0) * dw, out * -w]
}

/// `(a w cos v, b w sin v, c u)` with the derivative of w by u.
fn around(s: Vec3, u: f64, v: f64, w: f64, dw: f64) -> (Vec3, Vec3, Vec3) {
    let (sin, cos) = trig::sin_cos(v);
    (
        Vec3::new(s.x * w * cos, s.y * w * sin, s.z * u),
        Vec3::new(s.x * dw * cos, s.y * dw * sin, s.z),
        Vec3::new(-s.x * w * sin, s.y * w * cos, 0.0),
    )
}

/// Order of the axes and kind.
fn classify(lambda: [f64; 3], beta: [f64; 3], k: f64) -> Option<([usize; 3], Shape)> {
    let flat: Vec<usize> = (0..3).filter(|&i| lambda[i] == 0.0).collect();
    let round: Vec<usize> = (0..3).filter(|&i| lambda[i] != 0.0).collect();
    let greatest = lambda.iter().fold(0.0_f64, |m, l| m.max(l.abs()));
    let is_zero = k.abs() <= 1e-14 * greatest;
    // Semi-axes, with the sign of the square when the constant is brought to the other side as 1.
    let square = |i: usize| -lambda[i] / k;
    let axis = |i: usize| 1.0 / square(i).abs().sqrt();
    match (&round[..], &flat[..]) {
        (&[x, y, z], _) => {
            let sign = |i: usize| if is_zero { lambda[i] > 0.0 } else { square(i) > 0.0 };
            let positive: Vec<usize> = [x, y, z].into_iter().filter(|&i| sign(i)).collect();
            let negative: Vec<usize> = [x, y, z].into_iter().filter(|&i| !sign(i)).collect();
            let order = |two: &[usize], one: usize| [two[0], two[1], one];
            let semi = |o: [usize; 3]| Vec3::new(axis(o[0]), axis(o[1]), axis(o[2]));
            match (positive.len(), is_zero) {
                (3, false) => Some(([x, y, z], Shape::Ellipsoid(semi([x, y, z])))),
                (2, false) => {
                    let o = order(&positive, negative[0]);
                    Some((o, Shape::OneSheet(semi(o))))
                }
                (1, false) => {
                    let o = order(&negative, positive[0]);
                    Some((o, Shape::TwoSheets(semi(o))))
                }
                (n @ (1 | 2), true) => {
                    let o = if n == 2 {
                        order(&positive, negative[0])
                    } else {
                        order(&negative, positive[0])
                    };
                    let semi = o.map(|i| 1.0 / lambda[i].abs().sqrt());
                    Some((o, Shape::Cone(Vec3::from(semi))))
                }
                _ => None,
            }
        }
        (&[x, y], &[z]) if beta[z] != 0.0 => {
            let p = |i: usize| -lambda[i] / (2.0 * beta[z]);
            Some(([x, y, z], Shape::Paraboloid(p(x), p(y))))
        }
        (&[x, y], &[z]) if !is_zero => match (square(x) > 0.0, square(y) > 0.0) {
            (true, true) => Some(([x, y, z], Shape::EllipticRod(axis(x), axis(y)))),
            (true, false) => Some(([x, y, z], Shape::HyperbolicRod(axis(x), axis(y)))),
            (false, true) => Some(([y, x, z], Shape::HyperbolicRod(axis(y), axis(x)))),
            (false, false) => None,
        },
        (&[x], &[i, j]) => {
            let (z, y) = if beta[i] != 0.0 { (i, j) } else { (j, i) };
            (beta[z] != 0.0).then(|| ([x, y, z], Shape::ParabolicRod(-lambda[x] / (2.0 * beta[z]))))
        }
        _ => None,
    }
}

/// Unit eigenvectors and eigenvalues of a symmetric matrix, by Jacobi's rotations.
fn eigen(mut m: [[f64; 3]; 3]) -> ([Vec3; 3], [f64; 3]) {
    let mut axes = [Vec3::x(), Vec3::y(), Vec3::z()];
    for _ in 0..40 {
        let off = m[0][1].abs() + m[0][2].abs() + m[1][2].abs();
        if off == 0.0 {
            break;
        }
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            if m[i][j] == 0.0 {
                continue;
            }
            let theta = (m[j][j] - m[i][i]) / (2.0 * m[i][j]);
            let t = 1.0_f64.copysign(theta) / (theta.abs() + (theta * theta + 1.0).sqrt());
            let c = 1.0 / (t * t + 1.0).sqrt();
            let s = t * c;
            let k = 3 - i - j;
            let (ii, jj, ij) = (m[i][i], m[j][j], m[i][j]);
            let (ik, jk) = (m[i][k], m[j][k]);
            (m[i][i], m[j][j]) = (ii - t * ij, jj + t * ij);
            (m[i][j], m[j][i]) = (0.0, 0.0);
            (m[i][k], m[j][k]) = (c * ik - s * jk, s * ik + c * jk);
            (m[k][i], m[k][j]) = (m[i][k], m[j][k]);
            (axes[i], axes[j]) = (axes[i] * c - axes[j] * s, axes[i] * s + axes[j] * c);
        }
    }
    (axes, [m[0][0], m[1][1], m[2][2]])
}
