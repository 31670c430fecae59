//! ELLIPS HYPERB GCONIC LCONIC QADRIC as a surface: the form brought to its axes once, so that the nearest
//! point is the root of one monotone function.

use nalgebra::Matrix3;

use crate::roots::quadratic;
use crate::surface::{Foot, Shape, frame_about};
use crate::{Place, Quadric, Reason, Vec3};

/// Eigenvalues below this fraction of the greatest are rounding, and the surface is straight that way.
const STRAIGHT: f64 = 1e-13;
/// Bound of the search for the multiplier; it halves a bracket of doubles at worst.
const MAX_STEPS: usize = 100;

/// A quadric prepared for evaluation. Its positive side is where the form is positive.
#[derive(Clone, Debug)]
pub struct QuadricSurface {
    /// The form, scaled to greatest coefficient 1.
    form: Quadric,
    /// Columns: the principal directions.
    axes: Matrix3<f64>,
    /// Coefficients of the squares along them, exact zeros where the surface is straight.
    lambda: Vec3,
    /// Halved linear coefficients along them.
    beta: Vec3,
    /// Constant term.
    constant: f64,
    /// Open interval of multipliers in which the nearest point is found.
    range: [f64; 2],
    /// 1 when the negative side is convex, -1 when the positive side is, else 0.
    convexity: i8,
    generator: Option<Vec3>,
    extent: f64,
}

impl QuadricSurface {
    /// Prepares a form; `None` when it has no finite coefficient but the constant.
    pub fn new(form: &Quadric) -> Option<Self> {
        let greatest = form.c.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
        let variable = form.c.iter().enumerate().any(|(i, c)| i != 3 && *c != 0.0);
        if !variable || !form.c.iter().all(|c| c.is_finite()) {
            return None;
        }
        let form = Quadric { kind: form.kind, c: form.c.map(|c| c / greatest) };
        let [a, b, c, d, f, g, h, p, q, r] = form.c;
        let (axes, mut lambda) = eigen(Matrix3::new(a, h, g, h, b, f, g, f, c));
        let top = lambda.amax();
        for l in lambda.iter_mut() {
            if l.abs() <= STRAIGHT * top {
                *l = 0.0;
            }
        }
        let mut beta = axes.transpose() * Vec3::new(p, q, r);
        let lin = beta.amax();
        for l in beta.iter_mut() {
            if l.abs() <= STRAIGHT * lin {
                *l = 0.0;
            }
        }
        let (max, min) = (lambda.max(), lambda.min());
        let low = if max > 0.0 { -1.0 / max } else { f64::NEG_INFINITY };
        let high = if min < 0.0 { -1.0 / min } else { f64::INFINITY };
        let straight = (0..3).find(|&i| lambda[i] == 0.0 && beta[i] == 0.0);
        let mut extent = 0.0_f64;
        for i in 0..3 {
            if lambda[i] != 0.0 {
                extent = extent.max((beta[i] / lambda[i]).abs());
                extent = extent.max((d.abs() / lambda[i].abs()).sqrt());
            } else if beta[i] != 0.0 {
                extent = extent.max((d / beta[i]).abs());
            }
        }
        let convexity = match (min >= 0.0, max <= 0.0) {
            (true, _) => 1,
            (false, true) => -1,
            (false, false) => 0,
        };
        let generator = straight.map(|i| axes.column(i).into_owned());
        Some(Self {
            form,
            axes,
            lambda,
            beta,
            constant: d,
            range: [low, high],
            convexity,
            generator,
            extent,
        })
    }

    /// The principal directions with the coefficients of the squares and the halved linear coefficients along them, and
    /// the constant: the form is the sum of `l x^2 + 2 b x` and that, scaled as [`Self::form`].
    pub fn principal(&self) -> ([Vec3; 3], Vec3, Vec3, f64) {
        let axes = [0, 1, 2].map(|i| self.axes.column(i).into_owned());
        (axes, self.lambda, self.beta, self.constant)
    }

    /// The same surface with its normals to the other side.
    pub fn reversed(&self) -> Option<Self> {
        Self::new(&Quadric { kind: self.form.kind, c: self.form.c.map(|c| -c) })
    }

    /// The form, scaled to greatest coefficient 1.
    pub fn form(&self) -> &Quadric {
        &self.form
    }

    /// 1 when the negative side is convex, -1 when the positive side is, else 0.
    pub fn convexity(&self) -> i8 {
        self.convexity
    }

    /// Direction in which the surface runs straight for ever, if there is one.
    pub fn generator(&self) -> Option<Vec3> {
        self.generator
    }

    /// A length of the size of its axes and of its centre's distance from the origin.
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// Directed distances along the unit direction `d`.
    ///
    /// APT: `DDQUAD`. An asymptotic direction meets the surface once or not at all.
    pub fn ray(&self, p: Vec3, d: Vec3) -> Result<Vec<f64>, Reason> {
        let c = self.form.value(p);
        let b = 0.5 * self.form.gradient(p).dot(&d);
        let a = {
            let [a, bb, cc, _, f, g, h, ..] = self.form.c;
            a * d.x * d.x
                + bb * d.y * d.y
                + cc * d.z * d.z
                + 2.0 * (f * d.y * d.z + g * d.x * d.z + h * d.x * d.y)
        };
        let size = p.norm() + self.extent;
        // What is left of terms that cancel is rounding.
        let linear = self.beta.norm() + self.lambda.amax() * size;
        let whole = self.constant.abs() + size * linear;
        let clean = |x: f64, s: f64| if x.abs() <= 8.0 * f64::EPSILON * s { 0.0 } else { x };
        let (a, b) = (clean(a, self.lambda.amax()), clean(b, linear));
        quadratic(a, b, clean(c, whole), size).map(|q| q.roots().to_vec())
    }

    /// Unit normal of the level surface through `p`.
    ///
    /// APT: `UNQUAD`. At a centre or the vertex of a cone there is none.
    pub fn normal(&self, p: Vec3) -> Result<Vec3, Reason> {
        let g = 0.5 * self.form.gradient(p);
        let size = self.beta.norm() + self.lambda.amax() * (p.norm() + self.extent);
        let s = g.norm();
        if s <= 8.0 * f64::EPSILON * size {
            return Err(Reason::Degenerate(Place::Singular));
        }
        Ok(g / s)
    }

    /// The nearest point of all sheets.
    ///
    /// With q the point and p - q = m (L q + b) in principal axes, the form at q(m) falls monotonically
    /// between the poles of m, and its root there is the nearest point of all (the multiplier for which
    /// the Lagrangian is convex). Where p has no part along the axis of a pole the root may be the pole
    /// itself: p lies on a medial surface and two points are equally near; one of them is given.
    #[inline]
    pub fn foot(&self, p: Vec3) -> Foot {
        let y = self.axes.tr_mul(&p);
        let (mu, pole) = self.multiplier(y);
        let mut q = self.at(y, mu);
        if let Some(i) = pole {
            // The free coordinate of the medial case solves the form; the greater root of the two.
            let b = self.beta[i];
            q[i] = 0.0;
            let rest = self.eval(q);
            let l = self.lambda[i];
            let root = (b * b - l * rest).max(0.0).sqrt();
            q[i] = (-b + root) / l;
        }
        let half_gradient = self.lambda.component_mul(&q) + self.beta;
        let s = half_gradient.norm();
        let point = self.axes * q;
        if s <= 1e-150 {
            // The surface is singular there (vertex of a cone, line of two planes).
            let w = p - point;
            let away = w.norm();
            let sign = 1.0_f64.copysign(self.eval(y));
            let normal = if away > 0.0 { w * (sign / away) } else { self.axes.column(0).into() };
            let shape = Shape::round(normal, f64::INFINITY);
            return Foot { point, normal, distance: sign * away, shape, at: None };
        }
        let distance = if pole.is_some() { (p - point).norm().copysign(mu) } else { mu * s };
        let normal = self.axes * (half_gradient / s);
        Foot { point, normal, distance, shape: self.shape(normal, s), at: None }
    }

    /// The foot of the point `q` of the surface; `None` at a singular one.
    pub fn place(&self, q: Vec3) -> Option<Foot> {
        let half_gradient = 0.5 * self.form.gradient(q);
        let s = half_gradient.norm();
        (s > 1e-150).then_some(())?;
        let normal = half_gradient / s;
        Some(Foot { point: q, normal, distance: 0.0, shape: self.shape(normal, s), at: None })
    }

    /// The place beside the point `q` of the surface by the tangent `by`: where the normal at `q`, set out from there, meets
    /// the same sheet. `None` where it meets none, and beside a singular place.
    pub fn beside(&self, q: Vec3, by: Vec3) -> Option<Foot> {
        let up = (0.5 * self.form.gradient(q)).try_normalize(1e-150)?;
        let p = q + by;
        let (c, b) = (self.form.value(p), 0.5 * self.form.gradient(p).dot(&up));
        let root = (b * b - up.dot(&(self.matrix() * up)) * c).sqrt();
        let away = -c / (b + root);
        if !(b > 0.0 && away.is_finite()) {
            return None;
        }
        self.place(p + up * away)
    }

    /// The other place of a convex hollow (the negative side) from which the distance of `p` grows all round, beside
    /// the nearest one: `None` where there is none, and for other surfaces.
    ///
    /// Places without a fall lie between the first two poles of the multiplier at most: beyond, the Lagrangian falls in
    /// two directions, of which one lies in the surface. There the form is a convex function of the multiplier, and the
    /// place is its root next to the first pole.
    pub fn second_foot(&self, p: Vec3) -> Option<Foot> {
        let first = (0..3).max_by(|&i, &j| self.lambda[i].total_cmp(&self.lambda[j]))?;
        let steep = self.lambda[first];
        if self.convexity != 1 || steep <= 0.0 {
            return None;
        }
        let y = self.axes.tr_mul(&p);
        let pole = -1.0 / steep;
        let rest = (0..3).filter(|&i| i != first).map(|i| self.lambda[i]).fold(0.0, f64::max);
        let end = if rest > 0.0 { -1.0 / rest } else { f64::NEG_INFINITY };
        // Without the term of the pole the form only grows from there on.
        let mut beside = self.at(y, pole);
        beside[first] = -self.beta[first] / steep;
        let depth = -self.eval(beside);
        if !depth.is_finite() || depth <= 0.0 {
            return None;
        }
        let off = (y[first] + self.beta[first] / steep).abs();
        let mut mu = pole * (1.0 + off * (steep / depth).sqrt());
        let mut close = (mu - pole).abs() <= f64::EPSILON * pole.abs();
        for _ in 0..MAX_STEPS {
            if close || mu <= end {
                break;
            }
            let (value, slope, _) = self.form_at(y, mu);
            // The form falls away from the pole until its root.
            if slope <= 0.0 {
                return None;
            }
            let next = mu - value / slope;
            close = (next - mu).abs() <= 1e-15 * mu.abs();
            mu = next;
        }
        if mu <= end {
            return None;
        }
        let mut q = self.at(y, mu);
        if off <= 1e-9 * (depth / steep).sqrt() {
            // Next to the medial surface the free coordinate solves the form: the root on the other side.
            q[first] = 0.0;
            let (b, rest) = (self.beta[first], self.eval(q));
            let root = (b * b - steep * rest).max(0.0).sqrt();
            let below = (-b - root) / steep;
            let above = (-b + root) / steep;
            q[first] = if y[first] >= -b / steep { below } else { above };
        }
        let half_gradient = self.lambda.component_mul(&q) + self.beta;
        let s = half_gradient.norm();
        let (point, normal) = (self.axes * q, self.axes * (half_gradient / s));
        let distance = (p - point).dot(&normal);
        Some(Foot { point, normal, distance, shape: self.shape(normal, s), at: None })
    }

    /// By how much the form falls below zero in the hollow on its negative side; `None` where it falls without end.
    pub(crate) fn depth(&self) -> Option<f64> {
        let mut depth = -self.constant;
        for i in 0..3 {
            if self.lambda[i] > 0.0 {
                depth += self.beta[i] * self.beta[i] / self.lambda[i];
            } else if self.beta[i] != 0.0 {
                return None;
            }
        }
        Some(depth)
    }

    /// Curvature at the point `q` of the surface with unit normal `n` there.
    pub fn shape_at(&self, q: Vec3, n: Vec3) -> Shape {
        let s = 0.5 * self.form.gradient(q).norm();
        if s <= 1e-150 { Shape::round(n, f64::INFINITY) } else { self.shape(n, s) }
    }

    /// The coefficients of second degree.
    #[inline]
    fn matrix(&self) -> Matrix3<f64> {
        let [a, b, c, _, f, g, h, ..] = self.form.c;
        Matrix3::new(a, h, g, h, b, f, g, f, c)
    }

    fn shape(&self, n: Vec3, s: f64) -> Shape {
        let frame = frame_about(n);
        let m = self.matrix();
        let (m0, m1) = (m * frame[0], m * frame[1]);
        let k = [frame[0].dot(&m0) / s, frame[0].dot(&m1) / s, frame[1].dot(&m1) / s];
        Shape { frame, k }
    }

    #[inline]
    fn at(&self, y: Vec3, mu: f64) -> Vec3 {
        let f = |i: usize| {
            let den = 1.0 + mu * self.lambda[i];
            let num = y[i] - mu * self.beta[i];
            if den.abs() <= 1e-300 { 0.0 } else { num / den }
        };
        Vec3::new(f(0), f(1), f(2))
    }

    #[inline]
    fn eval(&self, q: Vec3) -> f64 {
        let h = self.lambda.component_mul(&q) + 2.0 * self.beta;
        h.dot(&q) + self.constant
    }

    /// Value of the form at q(mu) and its first two derivatives.
    #[inline]
    fn form_at(&self, y: Vec3, mu: f64) -> (f64, f64, f64) {
        let (mut value, mut slope, mut bend) = (self.constant, 0.0, 0.0);
        for i in 0..3 {
            let (l, b) = (self.lambda[i], self.beta[i]);
            let den = 1.0 / (1.0 + mu * l);
            let q = (y[i] - mu * b) * den;
            let half = l * q + b;
            value += (half + b) * q;
            let term = half * half * den;
            slope -= 2.0 * term;
            bend += 6.0 * term * l * den;
        }
        (value, slope, bend)
    }

    /// The multiplier of the nearest point; with the axis of the pole when it is the pole itself.
    #[inline]
    fn multiplier(&self, y: Vec3) -> (f64, Option<usize>) {
        let [low, high] = self.range;
        let (mut value, mut slope, mut bend) = self.form_at(y, 0.0);
        if value == 0.0 || slope == 0.0 && low.is_infinite() && high.is_infinite() {
            return (0.0, None);
        }
        // The root lies on the side of 0 to which the form falls to zero.
        let (mut a, mut b) = if value > 0.0 { (0.0, high) } else { (low, 0.0) };
        let mut mu = 0.0;
        let mut last = f64::INFINITY;
        for _ in 0..MAX_STEPS {
            if value > 0.0 {
                a = mu;
            } else {
                b = mu;
            }
            // Halley's step: an error of 1e-5 of the way to the pole is followed by one of 1e-15.
            let step = -2.0 * value * slope / (2.0 * slope * slope - value * bend);
            let near = (mu - low).min(high - mu).min(1e300);
            if value == 0.0 || step.abs() <= 3e-6 * near && mu + step > low && mu + step < high {
                return (mu + step, None);
            }
            // Should it slow down near a pole or leave the bracket, halve.
            let next = mu + step;
            if next > a && next < b && step.abs() < 0.5 * last {
                last = step.abs();
                mu = next;
            } else {
                last = f64::INFINITY;
                mu = inside(a, b);
                if mu <= a || mu >= b {
                    break;
                }
            }
            (value, slope, bend) = self.form_at(y, mu);
        }
        // The bracket has shrunk on a pole: the medial case; or on the root itself.
        for (end, touched) in [(low, a - low), (high, high - b)] {
            if end.is_finite() && touched.abs() <= 1e-12 * end.abs() {
                let axis = (0..3)
                    .find(|&i| self.lambda[i] != 0.0 && (1.0 + end * self.lambda[i]).abs() < 1e-12);
                return (end, axis);
            }
        }
        (mu, None)
    }
}

/// A point between two ends of which one may be infinite.
fn inside(a: f64, b: f64) -> f64 {
    if a.is_infinite() && b.is_infinite() {
        0.0
    } else if b.is_infinite() {
        if a > 0.0 { 4.0 * a } else { 1.0 }
    } else if a.is_infinite() {
        if b < 0.0 { 4.0 * b } else { -1.0 }
    } else {
        0.5 * (a + b)
    }
}

/// Eigenvectors (columns) and eigenvalues of a symmetric matrix by Jacobi's rotations. A diagonal matrix
/// comes back untouched.
fn eigen(mut m: Matrix3<f64>) -> (Matrix3<f64>, Vec3) {
    let mut v = Matrix3::identity();
    // Convergence is quadratic: five sweeps do for doubles, the bound is never met.
    for _ in 0..30 {
        let off = m[(0, 1)].abs() + m[(0, 2)].abs() + m[(1, 2)].abs();
        if off <= f64::EPSILON * f64::EPSILON * m.amax() {
            break;
        }
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let e = m[(i, j)];
            if e == 0.0 {
                continue;
            }
            let theta = (m[(j, j)] - m[(i, i)]) / (2.0 * e);
            let t = 1.0_f64.copysign(theta) / (theta.abs() + (theta * theta + 1.0).sqrt());
            let c = 1.0 / (t * t + 1.0).sqrt();
            let s = t * c;
            let mut r = Matrix3::identity();
            r[(i, i)] = c;
            r[(j, j)] = c;
            r[(i, j)] = s;
            r[(j, i)] = -s;
            m = r.transpose() * m * r;
            m[(i, j)] = 0.0;
            m[(j, i)] = 0.0;
            v *= r;
        }
    }
    (v, m.diagonal())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::QuadricKind;
    use crate::surface::{Fiop, Surface};
    use proptest::prelude::*;
    use std::sync::Arc;

    fn quadric(c: [f64; 10]) -> QuadricSurface {
        QuadricSurface::new(&Quadric { kind: QuadricKind::Qadric, c }).unwrap()
    }

    #[test]
    fn published_distances_and_normals() {
        let s = quadric([1.0, 1.0, -1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(s.ray(Vec3::zeros(), Vec3::x()), Ok(vec![-1.0, 1.0]));
        let slant = Vec3::new(1.0, 0.0, 1.0).normalize();
        let r = s.ray(Vec3::new(0.0, 0.0, 2.0), slant).unwrap();
        assert_eq!(r.len(), 1);
        assert!((r[0] + 5.0 * 2.0_f64.sqrt() / 4.0).abs() < 1e-14);
        // z = x y as z - x y = 0: halves -1/2 on H and 1/2 on R.
        let saddle = quadric([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5, 0.0, 0.0, 0.5]);
        assert_eq!(saddle.ray(Vec3::new(1.0, 1.0, 5.0), -Vec3::z()), Ok(vec![4.0]));
        let n = saddle.normal(Vec3::new(1.0, 2.0, 2.0)).unwrap();
        assert!((n - Vec3::new(-2.0, -1.0, 1.0) / 6.0_f64.sqrt()).norm() < 1e-15);
        let cone = quadric([1.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(cone.normal(Vec3::zeros()), Err(Reason::Degenerate(Place::Singular)));
        let hit = Surface::Quadric(Arc::new(s)).directed_distance(
            Vec3::zeros(),
            Vec3::x(),
            Fiop::Nearest,
        );
        assert_eq!(hit.map(|h| h.distance), Ok(1.0));
    }

    #[test]
    fn curvature_of_known_quadrics() {
        let ball = quadric([1.0, 1.0, 1.0, -25.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let k = ball.foot(Vec3::new(3.0, 1.0, 9.0)).shape.principal();
        assert!((k[0] - 0.2).abs() < 1e-15 && (k[1] - 0.2).abs() < 1e-15);
        // z = xy at (1, 1) with the normal (-1, -1, 1): .1924501 and -.5773503 by the convention that
        // concave is positive; ours has the other sign.
        let saddle = quadric([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5, 0.0, 0.0, 0.5]);
        let f = saddle.foot(Vec3::new(1.0, 1.0, 1.0));
        let k = f.shape.principal();
        assert!((k[0] - 0.577_350_3).abs() < 1e-7 && (k[1] + 0.192_450_1).abs() < 1e-7);
    }

    #[test]
    fn medial_points_have_a_foot() {
        let e = quadric([0.25, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let f = e.foot(Vec3::new(0.0, 0.0, 3.0));
        assert!((f.distance + 1.0).abs() < 1e-12);
        assert!((f.point.y.abs() - 1.0).abs() < 1e-12);
        // Inside the evolute on the long axis: two feet off the axis.
        let f = e.foot(Vec3::new(1.0, 0.0, 0.0));
        let x = 4.0 / 3.0;
        assert!((f.point.x - x).abs() < 1e-9, "{:?}", f.point);
        assert!(e.form().value(f.point).abs() < 1e-12);
        assert_eq!(e.generator(), Some(Vec3::z()));
        assert_eq!(e.convexity(), 1);
    }

    proptest! {
        #[test]
        fn beside_a_point_lies_a_point_of_the_surface(
            c in prop::array::uniform10(-1.0_f64..1.0),
            p in prop::array::uniform3(-3.0_f64..3.0),
            by in prop::array::uniform3(-1.0_f64..1.0),
        ) {
            let s = quadric(c);
            let from = s.foot(Vec3::from(p));
            let by = Vec3::from(by);
            let by = by - from.normal * by.dot(&from.normal);
            // As the way falls to a tenth the place comes nearer to its end by its square.
            let mut off = [0.0; 2];
            for (off, share) in off.iter_mut().zip([1e-3, 1e-4]) {
                let Some(to) = s.beside(from.point, by * share) else { return Ok(()) };
                let known = s.foot(to.point);
                prop_assert!(known.distance.abs() < 1e-9 * (1.0 + to.point.norm()));
                let bend = known.shape.principal().map(f64::abs);
                prop_assume!(bend[0].max(bend[1]) < 30.0);
                prop_assert!((known.normal - to.normal).norm() < 1e-6);
                *off = (to.point - from.point - by * share).norm();
            }
            prop_assert!(off[1] <= 0.02 * off[0] + 1e-12, "{off:?}");
        }

        #[test]
        fn foot_is_the_nearest_point(
            c in prop::array::uniform10(-1.0_f64..1.0),
            p in prop::array::uniform3(-3.0_f64..3.0),
            d in prop::array::uniform32(-1.0_f64..1.0),
        ) {
            let s = quadric(c);
            let p = Vec3::from(p);
            let f = s.foot(p);
            if s.form.value(p) * s.range.iter().fold(1.0, |m, r| m * r) != 0.0 {
                let away = (p - f.point).norm();
                // No ray from p hits the surface nearer.
                for w in d.chunks(3).filter(|w| w.len() == 3) {
                    let w = Vec3::new(w[0], w[1], w[2]);
                    if w.norm() < 0.1 { continue; }
                    if let Ok(r) = s.ray(p, w.normalize()) {
                        for l in r {
                            prop_assert!(l.abs() >= away - 1e-9, "{} < {}", l.abs(), away);
                            let value = s.form.value(f.point);
                            prop_assert!(value.abs() < 1e-9 * (1.0 + f.point.norm_squared()));
                            prop_assert!((away - f.distance.abs()).abs() < 1e-9 * (1.0 + away));
                            prop_assert!(f.distance * s.form.value(p) >= -1e-12);
                        }
                    }
                }
            }
        }
    }
}
