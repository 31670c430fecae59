//! What a geometric name stands for, and its canonical elements.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::sculptured::{CurveDefinition, Solid, SurfaceDefinition};
use crate::{
    Circle, Cone, Cylinder, Line, Pattern, Plane, Polyconic, Quadric, QuadricKind, RuledSurface,
    Sphere, Tabcyl, Transform, Vec3,
};

/// A geometric definition in canonical form.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[expect(missing_docs, reason = "each is the form of its name")]
pub enum Form {
    Point(Vec3),
    Vector(Vec3),
    Line(Line),
    Plane(Plane),
    Circle(Circle),
    Cylinder(Cylinder),
    Sphere(Sphere),
    Cone(Cone),
    Quadric(Quadric),
    Matrix(Transform),
    Pattern(Pattern),
    Tabcyl(Arc<Tabcyl>),
    Ruled(Arc<RuledSurface>),
    Polyconic(Arc<Polyconic>),
    /// SCURV, as defined.
    Scurv(Arc<CurveDefinition>),
    /// SSURF, as defined.
    Ssurf(Arc<SurfaceDefinition>),
    /// BOUNDS and OBJECT.
    Solid(Arc<Solid>),
    /// Elements as CANON gave them, beside the form in normal shape that they stand for.
    Written(Arc<Written>),
}

/// A form whose canonical elements are not those of its normal shape: a LINE by CANON with a normal of
/// any length, or a LINE that REFSYS tilted. OBTAIN and PRINT see `elements`, geometry sees `shape`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Written {
    /// The word that defined it.
    pub kind: FormKind,
    /// The elements as they were given.
    pub elements: Vec<f64>,
    /// What they stand for, normalised; never itself a [`Form::Written`].
    pub shape: Form,
}

/// The word that defines a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[expect(missing_docs, reason = "each is the APT word")]
pub enum FormKind {
    Point,
    Vector,
    Line,
    Plane,
    Circle,
    Cylndr,
    Sphere,
    Cone,
    Ellips,
    Hyperb,
    Gconic,
    Lconic,
    Qadric,
    Matrix,
    Patern,
    Tabcyl,
    Rldsrf,
    Polcon,
    Scurv,
    Ssurf,
    Bounds,
    Object,
}

impl FormKind {
    /// The APT word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Point => "POINT",
            Self::Vector => "VECTOR",
            Self::Line => "LINE",
            Self::Plane => "PLANE",
            Self::Circle => "CIRCLE",
            Self::Cylndr => "CYLNDR",
            Self::Sphere => "SPHERE",
            Self::Cone => "CONE",
            Self::Ellips => "ELLIPS",
            Self::Hyperb => "HYPERB",
            Self::Gconic => "GCONIC",
            Self::Lconic => "LCONIC",
            Self::Qadric => "QADRIC",
            Self::Matrix => "MATRIX",
            Self::Patern => "PATERN",
            Self::Tabcyl => "TABCYL",
            Self::Rldsrf => "RLDSRF",
            Self::Polcon => "POLCON",
            Self::Scurv => "SCURV",
            Self::Ssurf => "SSURF",
            Self::Bounds => "BOUNDS",
            Self::Object => "OBJECT",
        }
    }

    /// What it is, in a word of everyday.
    pub fn noun(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Vector => "vector",
            Self::Line => "line",
            Self::Plane => "plane",
            Self::Circle => "circle",
            Self::Cylndr => "cylinder",
            Self::Sphere => "sphere",
            Self::Cone => "cone",
            Self::Ellips => "ellipse",
            Self::Hyperb => "hyperbola",
            Self::Gconic | Self::Lconic => "conic",
            Self::Qadric => "quadric",
            Self::Matrix => "matrix",
            Self::Patern => "pattern",
            Self::Tabcyl => "TABCYL",
            Self::Rldsrf => "ruled surface",
            Self::Polcon => "polyconic",
            Self::Scurv => "sculptured curve",
            Self::Ssurf => "sculptured surface",
            Self::Bounds => "bounded space",
            Self::Object => "object",
        }
    }
}

impl Form {
    /// The word that defines it.
    pub fn kind(&self) -> FormKind {
        match self {
            Self::Point(_) => FormKind::Point,
            Self::Vector(_) => FormKind::Vector,
            Self::Line(_) => FormKind::Line,
            Self::Plane(_) => FormKind::Plane,
            Self::Circle(_) => FormKind::Circle,
            Self::Cylinder(_) => FormKind::Cylndr,
            Self::Sphere(_) => FormKind::Sphere,
            Self::Cone(_) => FormKind::Cone,
            Self::Quadric(q) => match q.kind {
                QuadricKind::Ellips => FormKind::Ellips,
                QuadricKind::Hyperb => FormKind::Hyperb,
                QuadricKind::Gconic => FormKind::Gconic,
                QuadricKind::Lconic => FormKind::Lconic,
                QuadricKind::Qadric => FormKind::Qadric,
            },
            Self::Matrix(_) => FormKind::Matrix,
            Self::Pattern(_) => FormKind::Patern,
            Self::Tabcyl(_) => FormKind::Tabcyl,
            Self::Ruled(_) => FormKind::Rldsrf,
            Self::Polyconic(_) => FormKind::Polcon,
            Self::Scurv(_) => FormKind::Scurv,
            Self::Ssurf(_) => FormKind::Ssurf,
            Self::Solid(s) if s.object => FormKind::Object,
            Self::Solid(_) => FormKind::Bounds,
            Self::Written(w) => w.kind,
        }
    }

    /// The form to calculate with: itself, or the normal shape of elements that were written otherwise.
    pub fn shape(&self) -> &Self {
        match self {
            Self::Written(w) => &w.shape,
            plain => plain,
        }
    }

    /// Can it control the tool, as drive, part or check surface? Points, vectors, matrices, patterns,
    /// curves in space and solids cannot.
    pub fn is_surface(&self) -> bool {
        !matches!(
            self.shape(),
            Self::Point(_)
                | Self::Vector(_)
                | Self::Matrix(_)
                | Self::Pattern(_)
                | Self::Scurv(_)
                | Self::Solid(_)
        )
    }

    /// The canonical elements in APT's order, as OBTAIN and CANON see them: POINT x y z, LINE a b 0 d,
    /// PLANE a b c d, CIRCLE and CYLNDR x y z i j k r, SPHERE x y z r, CONE x y z i j k cosine, quadrics
    /// ten halved coefficients, VECTOR a b c, MATRIX three rows of four, PATERN its points, TABCYL count,
    /// control, axes, spans, POLCON its 79, RLDSRF its rails. SCURV, SSURF and BOUNDS
    /// have none but by CANON; they give the numbers of their definition in the order written.
    pub fn canonical(&self) -> Vec<f64> {
        fn join(a: Vec3, b: Vec3, c: f64) -> Vec<f64> {
            vec![a.x, a.y, a.z, b.x, b.y, b.z, c]
        }
        match self {
            Self::Point(v) | Self::Vector(v) => vec![v.x, v.y, v.z],
            Self::Line(l) => vec![l.a, l.b, 0.0, l.d],
            Self::Plane(p) => vec![p.n.x, p.n.y, p.n.z, p.d],
            Self::Circle(c) => join(c.center, c.axis, c.radius),
            Self::Cylinder(c) => join(c.point, c.axis, c.radius),
            Self::Sphere(s) => vec![s.center.x, s.center.y, s.center.z, s.radius],
            Self::Cone(c) => join(c.vertex, c.axis, c.cos_half),
            Self::Quadric(q) => q.c.to_vec(),
            Self::Matrix(m) => m.rows().to_vec(),
            Self::Pattern(p) => p.points.iter().flat_map(|p| [p.x, p.y, p.z]).collect(),
            Self::Tabcyl(t) => t.canonical(),
            Self::Ruled(r) => r.canonical(),
            Self::Polyconic(p) => p.canonical(),
            Self::Scurv(c) => c.numbers(),
            Self::Ssurf(s) => s.numbers(),
            Self::Solid(s) => s.numbers(),
            Self::Written(w) => w.elements.clone(),
        }
    }
}
