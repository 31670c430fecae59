//! Conic sections along a length, as a function of two parameters.

use std::sync::Arc;

use crate::sculpt::Derivatives;
use crate::{ControlCurve, Polyconic, Transform, Vec2, Vec3};

use super::{Domain, Jet};

/// How far it goes on straight beyond its ends, in shares of its length and of its sections.
const BEYOND: f64 = 0.5;

/// A polyconic whose sections are conics throughout, as it is defined: without its thickness.
#[derive(Clone, Debug)]
pub(super) struct Sections {
    form: Arc<Polyconic>,
    transform: Option<Transform>,
    /// Have the control curves square roots? Then the parameter is the root of the share of the length.
    rooted: bool,
}

/// A function of the length with its two derivatives.
type Along<T> = [T; 3];

impl Sections {
    pub(super) fn new(form: &Arc<Polyconic>) -> Option<Self> {
        let conic = (0..=64).all(|i| form.section(f64::from(i) / 64.0).is_some());
        let finite = form.length > 0.0 && !form.is_skew();
        let rooted = form.curves.iter().any(|c| c.root != 0.0);
        let transform = form.transform();
        (conic && finite).then(|| Self { form: form.clone(), transform, rooted })
    }

    pub(super) fn domain(&self) -> Domain {
        Domain { u: [-BEYOND, 1.0 + BEYOND], v: [-BEYOND, 1.0 + BEYOND] }
    }

    pub(super) fn jet(&self, u: f64, v: f64) -> Jet {
        let (cu, cv) = (u.clamp(0.0, 1.0), v.clamp(0.0, 1.0));
        let (a, b) = (u - cu, v - cv);
        let beyond = a != 0.0 || b != 0.0;
        let (inner, thirds) = self.inner(cu, cv, beyond);
        if beyond { inner.beyond(a, b, thirds) } else { inner }.into()
    }

    /// Unit normal of the planes in which the sections lie.
    pub(super) fn across(&self) -> Option<Vec3> {
        self.vector(Vec3::y()).cross(&self.vector(Vec3::z())).try_normalize(0.0)
    }

    /// How far the working surface lies from it, along its normals.
    pub(super) fn rise(&self) -> f64 {
        self.form.rise()
    }

    /// A control curve by the parameter.
    fn control(&self, c: &ControlCurve, u: f64) -> Along<f64> {
        let d = if self.rooted { u * u } else { u };
        let (mut f, mut f1, mut f2) = (0.0, 0.0, 0.0);
        for k in c.c.iter().rev() {
            f2 = f2 * d + 2.0 * f1;
            f1 = f1 * d + f;
            f = f * d + k;
        }
        if self.rooted {
            [f + c.root * u, c.root + 2.0 * u * f1, 4.0 * u * u * f2 + 2.0 * f1]
        } else {
            [f, f1, f2]
        }
    }

    /// What is at a place between the ends, and with `more` the third derivatives by u, u, v and by u, v, v.
    fn inner(&self, u: f64, t: f64, more: bool) -> (Derivatives, [Vec3; 2]) {
        let [a, b, c, e, l, h, p] = std::array::from_fn(|i| self.control(&self.form.curves[i], u));
        let pair = |x: Along<f64>, y: Along<f64>| [0, 1, 2].map(|i| Vec2::new(x[i], y[i]));
        let plus = |x: Along<Vec2>, y: Along<Vec2>| [0, 1, 2].map(|i| x[i] + y[i]);
        let start = pair(l, h);
        let apex = plus(start, pair(c, b));
        let end = plus(apex, pair(a, e));
        // The weight w(p) = (2p - 1) / (2 - 2p).
        let q = 1.0 - p[0];
        let (w1, w2) = (0.5 / (q * q), 1.0 / (q * q * q));
        let w = [(p[0] - 0.5) / q, w1 * p[1], w2 * p[1] * p[1] + w1 * p[2]];
        let product = [
            apex[0] * w[0],
            apex[1] * w[0] + apex[0] * w[1],
            apex[2] * w[0] + apex[1] * (2.0 * w[1]) + apex[0] * w[2],
        ];
        // Bernstein polynomials and their derivatives by t.
        let s = 1.0 - t;
        let basis =
            [[s * s, 2.0 * t * s, t * t], [-2.0 * s, 2.0 - 4.0 * t, 2.0 * t], [2.0, -4.0, 2.0]];
        let num = |i: usize, j: usize| {
            start[i] * basis[j][0] + product[i] * basis[j][1] + end[i] * basis[j][2]
        };
        let den = |i: usize, j: usize| {
            let ends = if i == 0 { basis[j][0] + basis[j][2] } else { 0.0 };
            ends + w[i] * basis[j][1]
        };
        let d = den(0, 0);
        let x = num(0, 0) / d;
        let xu = (num(1, 0) - x * den(1, 0)) / d;
        let xv = (num(0, 1) - x * den(0, 1)) / d;
        let xuu = (num(2, 0) - xu * (2.0 * den(1, 0)) - x * den(2, 0)) / d;
        let xvv = (num(0, 2) - xv * (2.0 * den(0, 1)) - x * den(0, 2)) / d;
        let xuv = (num(1, 1) - xu * den(0, 1) - xv * den(1, 0) - x * den(1, 1)) / d;
        let length = self.form.length;
        let [at, rate, bend] = if self.rooted { [u * u, 2.0 * u, 2.0] } else { [u, 1.0, 0.0] };
        let place = self.form.origin + length * at;
        let lift = |along: f64, x: Vec2| self.vector(Vec3::new(along, x.x, x.y));
        let s = Vec3::new(place, x.x, x.y);
        let own = Derivatives {
            point: self.transform.as_ref().map_or(s, |m| m.point(s)),
            u: lift(length * rate, xu),
            v: lift(0.0, xv),
            uu: lift(length * bend, xuu),
            uv: lift(0.0, xuv),
            vv: lift(0.0, xvv),
        };
        if !more {
            return (own, [Vec3::zeros(); 2]);
        }
        let uuv = xv * den(2, 0) + (xu * den(1, 1) + xuv * den(1, 0)) * 2.0 + xuu * den(0, 1);
        let uvv = xu * den(0, 2) + (xv * den(1, 1) + xuv * den(0, 1)) * 2.0 + xvv * den(1, 0);
        let third = |i: usize, j: usize, known: Vec2| (num(i, j) - x * den(i, j) - known) / d;
        (own, [third(2, 1, uuv), third(1, 2, uvv)].map(|x| lift(0.0, x)))
    }

    fn vector(&self, v: Vec3) -> Vec3 {
        self.transform.as_ref().map_or(v, |m| m.vector(v))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Between the ends and beyond them each derivative is how the one before it changes.
        #[test]
        fn derivatives_are_those_of_the_place(
            k in prop::collection::vec(-1.0_f64..1.0, 16), u in -0.5_f64..1.5, v in -0.5_f64..1.5,
        ) {
            // Bends that change along the length, about sections that are near quarters of circles.
            let mut e = [0.0; Polyconic::N_ELEMENTS];
            (e[0], e[14], e[15], e[64]) = (1.0, 2.0, 10.0, 0.5 + 0.1 * k[15]);
            for (i, first) in [(16, -1.0), (24, 1.0), (48, 1.0)] {
                let n = (i - 16) / 8;
                (e[i], e[i + 1], e[i + 2], e[i + 3]) = (first, k[n], k[n + 5], 0.3 * k[n + 10]);
            }
            let sections = Sections::new(&Arc::new(Polyconic::from_canonical(&e)));
            prop_assume!(sections.is_some());
            let sections = sections.unwrap();
            let h = 1e-4;
            prop_assume!([u, v].iter().all(|t| t.abs() > h && (t - 1.0).abs() > h));
            let at = |du: f64, dv: f64| sections.jet(u + du, v + dv);
            let d = at(0.0, 0.0);
            let [by_u, by_v] = [[at(h, 0.0), at(-h, 0.0)], [at(0.0, h), at(0.0, -h)]];
            let slope = |of: [Jet; 2], what: fn(&Jet) -> Vec3| (what(&of[0]) - what(&of[1])) / (2.0 * h);
            let pairs = [
                (d.su, slope(by_u, |j| j.s)), (d.sv, slope(by_v, |j| j.s)),
                (d.suu, slope(by_u, |j| j.su)), (d.suv, slope(by_v, |j| j.su)),
                (d.suv, slope(by_u, |j| j.sv)), (d.svv, slope(by_v, |j| j.sv)),
            ];
            for (n, (told, seen)) in pairs.into_iter().enumerate() {
                let far = (told - seen).norm();
                prop_assert!(far <= 1e-4 * (1.0 + told.norm()), "{n}: {told} {seen}");
            }
        }
    }
}
