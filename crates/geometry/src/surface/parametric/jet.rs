//! Value and derivatives of a surface at a place: the places beside it, the second fundamental form, tangents as parameters.

use crate::Vec3;
use crate::sculpt::Derivatives;
use crate::surface::Shape;

/// Value and derivatives at a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jet {
    pub(super) s: Vec3,
    pub(super) su: Vec3,
    pub(super) sv: Vec3,
    pub(super) suu: Vec3,
    pub(super) suv: Vec3,
    pub(super) svv: Vec3,
}

impl Jet {
    /// The unit normal; none where the derivatives have no area.
    pub(super) fn normal(&self) -> Option<Vec3> {
        across(self.su, self.sv)
    }

    /// The unit normal and the second fundamental form, where the derivatives have so much area that both are found at once.
    #[inline]
    pub(super) fn formed(&self) -> Option<(Vec3, Shape)> {
        /// Share of the product of their squares, and of the one square that the other is: beside a pole it is less.
        const SQUARE: f64 = 1e-8;
        const ALIKE: f64 = 1e-20;
        let (e, g) = (self.su.norm_squared(), self.sv.norm_squared());
        let n = self.su.cross(&self.sv);
        let square = n.norm_squared();
        let alike = e > ALIKE * g && g > ALIKE * e;
        if !(alike && square > SQUARE * e * g && square.is_finite()) {
            return None;
        }
        let area = square.sqrt();
        let normal = n / area;
        Some((normal, second_form(self, normal, [e, self.su.dot(&self.sv)], area)))
    }

    /// A place beside it where it is smooth, to second order.
    pub(super) fn beside(&self, a: f64, b: f64) -> Self {
        let (su, sv) = (self.suu * a + self.suv * b, self.suv * a + self.svv * b);
        Self {
            s: self.s + (self.su + su * 0.5) * a + (self.sv + sv * 0.5) * b,
            su: self.su + su,
            sv: self.sv + sv,
            ..*self
        }
    }
}

impl From<Derivatives> for Jet {
    #[inline(always)]
    fn from(d: Derivatives) -> Self {
        Self { s: d.point, su: d.u, sv: d.v, suu: d.uu, suv: d.uv, svv: d.vv }
    }
}

/// The unit vector across two others; none where they have no area.
pub(super) fn across(su: Vec3, sv: Vec3) -> Option<Vec3> {
    let n = su.cross(&sv);
    let square = n.norm_squared();
    let flat = square <= 1e-18 * su.norm_squared() * sv.norm_squared();
    (!flat).then(|| n / square.sqrt())
}

/// The second fundamental form from the derivatives, positive where the surface bends away from its normal.
pub(super) fn shape(jet: &Jet, normal: Vec3) -> Shape {
    let (e, f, g) = (jet.su.norm_squared(), jet.su.dot(&jet.sv), jet.sv.norm_squared());
    let area = (e * g - f * f).max(0.0).sqrt();
    if e <= 0.0 || area <= 1e-9 * (e * g).sqrt() {
        return Shape::flat(normal);
    }
    second_form(jet, normal, [e, f], area)
}

/// The same with the square of the derivative by u, its product with that by v, and the area of both.
#[inline]
fn second_form(jet: &Jet, normal: Vec3, [e, f]: [f64; 2], area: f64) -> Shape {
    let (l, m, n) = (-normal.dot(&jet.suu), -normal.dot(&jet.suv), -normal.dot(&jet.svv));
    let along = jet.su / e.sqrt();
    let k11 = l / e;
    let k12 = (m - f * k11) / area;
    let k22 = (e * n - f * f * k11 - 2.0 * f * area * k12) / (area * area);
    Shape { frame: [along, normal.cross(&along)], k: [k11, k12, k22] }
}

/// The tangent `by` in these derivatives by both parameters; `None` where they have no area.
#[inline]
pub(super) fn by_sides([su, sv]: [Vec3; 2], by: Vec3) -> Option<(f64, f64)> {
    let (e, f, g) = (su.norm_squared(), su.dot(&sv), sv.norm_squared());
    let det = e * g - f * f;
    if det <= 1e-12 * e * g {
        return None;
    }
    let (a, b) = (by.dot(&su), by.dot(&sv));
    Some(((g * a - f * b) / det, (e * b - f * a) / det))
}
