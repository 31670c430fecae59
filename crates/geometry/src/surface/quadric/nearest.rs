//! The nearest point of a quadric: the root of the form along its multiplier.

use super::QuadricSurface;
use crate::Vec3;
use crate::surface::{Foot, Shape};

/// Bound of the search for the multiplier; it halves a bracket of doubles at worst.
const MAX_STEPS: usize = 100;

impl QuadricSurface {
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

#[cfg(test)]
mod tests {
    use super::super::tests::quadric;
    use crate::Vec3;
    use proptest::prelude::*;

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
