//! The simple forms: each with the canonical elements that APT gives it.

use serde::{Deserialize, Serialize};

use crate::Vec3;

/// LINE: the vertical plane `a x + b y = d`, (a, b) unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Normal, x.
    pub a: f64,
    /// Normal, y.
    pub b: f64,
    /// Distance of the origin, signed along the normal.
    pub d: f64,
}

/// PLANE: `n . p = d`, n unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plane {
    /// Unit normal.
    pub n: Vec3,
    /// Distance of the origin, signed along the normal.
    pub d: f64,
}

/// CIRCLE: as control surface the cylinder through it along `axis`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Circle {
    /// Centre.
    pub center: Vec3,
    /// Unit normal of its plane.
    pub axis: Vec3,
    /// Radius.
    pub radius: f64,
}

/// CYLNDR: a right circular cylinder without ends.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cylinder {
    /// A point of the axis.
    pub point: Vec3,
    /// Unit direction of the axis.
    pub axis: Vec3,
    /// Radius.
    pub radius: f64,
}

/// SPHERE.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sphere {
    /// Centre.
    pub center: Vec3,
    /// Radius.
    pub radius: f64,
}

/// CONE: one nappe, opening from the vertex along the axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cone {
    /// Vertex.
    pub vertex: Vec3,
    /// Unit direction from the vertex into the cone.
    pub axis: Vec3,
    /// Cosine of the half angle, in (0, 1).
    pub cos_half: f64,
}

/// Which word made a quadric; all of them share the ten coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum QuadricKind {
    /// ELLIPS.
    Ellips,
    /// HYPERB.
    Hyperb,
    /// GCONIC.
    Gconic,
    /// LCONIC.
    Lconic,
    /// QADRIC.
    Qadric,
}

/// ELLIPS HYPERB GCONIC LCONIC QADRIC: the surface of second degree
/// `A x2 + B y2 + C z2 + D + 2 F y z + 2 G x z + 2 H x y + 2 P x + 2 Q y + 2 R z = 0`, the coefficients
/// in the order A B C D F G H P Q R, that is with the mixed and linear terms halved.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quadric {
    /// The defining word.
    pub kind: QuadricKind,
    /// A B C D F G H P Q R.
    pub c: [f64; 10],
}

/// PATERN: points in order.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Pattern {
    /// The points.
    pub points: Vec<Vec3>,
}

impl Line {
    /// The line `a x + b y = d` with (a, b) of any length but zero.
    pub fn new(a: f64, b: f64, d: f64) -> Option<Self> {
        let s = crate::trig::hypot(a, b);
        (s > 0.0 && s.is_finite() && d.is_finite()).then(|| Self { a: a / s, b: b / s, d: d / s })
    }

    /// The line as the vertical plane that it is.
    pub fn plane(&self) -> Plane {
        Plane { n: Vec3::new(self.a, self.b, 0.0), d: self.d }
    }
}

impl Plane {
    /// The plane `n . p = d` with n of any length but zero.
    pub fn new(n: Vec3, d: f64) -> Option<Self> {
        let s = n.norm();
        (s > 0.0 && s.is_finite() && d.is_finite()).then(|| Self { n: n / s, d: d / s })
    }

    /// Signed distance of `p`, positive on the side of the normal.
    pub fn distance(&self, p: Vec3) -> f64 {
        self.n.dot(&p) - self.d
    }
}

impl Circle {
    /// The cylinder that the circle stands for as a control surface.
    pub fn cylinder(&self) -> Cylinder {
        Cylinder { point: self.center, axis: self.axis, radius: self.radius }
    }
}

impl Quadric {
    /// Value of the quadratic form at `p`; zero on the surface.
    pub fn value(&self, p: Vec3) -> f64 {
        let [a, b, c, d, f, g, h, l, m, n] = self.c;
        let (x, y, z) = (p.x, p.y, p.z);
        a * x * x
            + b * y * y
            + c * z * z
            + d
            + 2.0 * (f * y * z + g * x * z + h * x * y + l * x + m * y + n * z)
    }

    /// Gradient of the quadratic form at `p`.
    pub fn gradient(&self, p: Vec3) -> Vec3 {
        let [a, b, c, _, f, g, h, l, m, n] = self.c;
        2.0 * Vec3::new(
            a * p.x + h * p.y + g * p.z + l,
            h * p.x + b * p.y + f * p.z + m,
            g * p.x + f * p.y + c * p.z + n,
        )
    }
}
