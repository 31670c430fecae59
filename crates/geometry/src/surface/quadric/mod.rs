//! ELLIPS HYPERB GCONIC LCONIC QADRIC as a surface: the form brought to its axes once, so that the nearest
//! point is the root of one monotone function.

mod eigen;
mod nearest;

use nalgebra::Matrix3;

use crate::roots::quadratic;
use crate::surface::{Foot, Shape, frame_about};
use crate::{Place, Quadric, Reason, Vec3};
use eigen::eigen;

/// Eigenvalues below this fraction of the greatest are rounding, and the surface is straight that way.
const STRAIGHT: f64 = 1e-13;

/// Where the surface bends along an axis by less than this share of what it bends most, its middle along that axis may be rounding
/// of the coefficients, as of a cylinder that was printed: nothing is measured by it. So it is with where an axis meets the surface
/// along which the form rises by less than that other share of what it rises most.
const SLACK: [f64; 2] = [1e-3, 1e-2];

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
            if lambda[i].abs() > SLACK[0] * top {
                extent = extent.max((beta[i] / lambda[i]).abs());
                extent = extent.max((d.abs() / lambda[i].abs()).sqrt());
            } else if beta[i].abs() > SLACK[1] * lin {
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

    /// A length of the size of its axes and of its centre's distance from the origin, but for those along which it hardly bends.
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
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use proptest::prelude::*;

    use super::*;
    use crate::QuadricKind;
    use crate::surface::{Fiop, Surface};

    pub(super) fn quadric(c: [f64; 10]) -> QuadricSurface {
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
    }
}
