//! Forms from their canonical elements.

use std::sync::Arc;

use aptc_geometry::{
    Circle, Cone, Cylinder, Form, FormKind, Line, Pattern, Plane, Polyconic, Quadric, QuadricKind,
    Sphere, Transform, Vec3, Written,
};

/// The kind of that word.
pub(crate) fn kind_of(word: &str) -> Option<FormKind> {
    use FormKind as K;
    const ALL: [FormKind; 18] = [
        K::Point,
        K::Vector,
        K::Line,
        K::Plane,
        K::Circle,
        K::Cylndr,
        K::Sphere,
        K::Cone,
        K::Ellips,
        K::Hyperb,
        K::Gconic,
        K::Lconic,
        K::Qadric,
        K::Matrix,
        K::Patern,
        K::Tabcyl,
        K::Rldsrf,
        K::Polcon,
    ];
    ALL.into_iter().find(|k| k.word() == word)
}

/// The form whose canonical elements these are, number for number; `None` for TABCYL and RLDSRF, whose
/// elements do not hold all that they are made of, and for wrong counts.
pub(crate) fn form(kind: FormKind, e: &[f64]) -> Option<Form> {
    let v = |i: usize| Vec3::new(e[i], e[i + 1], e[i + 2]);
    let quadric = |kind| {
        let c = e.try_into().ok()?;
        Some(Form::Quadric(Quadric { kind, c }))
    };
    match kind {
        FormKind::Point if e.len() == 3 => Some(Form::Point(v(0))),
        FormKind::Vector if e.len() == 3 => Some(Form::Vector(v(0))),
        FormKind::Line if e.len() == 4 => line(e),
        FormKind::Plane if e.len() == 4 => Some(Form::Plane(Plane { n: v(0), d: e[3] })),
        FormKind::Circle if e.len() == 7 => {
            Some(Form::Circle(Circle { center: v(0), axis: v(3), radius: e[6] }))
        }
        FormKind::Cylndr if e.len() == 7 => {
            Some(Form::Cylinder(Cylinder { point: v(0), axis: v(3), radius: e[6] }))
        }
        FormKind::Sphere if e.len() == 4 => {
            Some(Form::Sphere(Sphere { center: v(0), radius: e[3] }))
        }
        FormKind::Cone if e.len() == 7 => {
            Some(Form::Cone(Cone { vertex: v(0), axis: v(3), cos_half: e[6] }))
        }
        FormKind::Ellips => quadric(QuadricKind::Ellips),
        FormKind::Hyperb => quadric(QuadricKind::Hyperb),
        FormKind::Gconic => quadric(QuadricKind::Gconic),
        FormKind::Lconic => quadric(QuadricKind::Lconic),
        FormKind::Qadric => quadric(QuadricKind::Qadric),
        FormKind::Matrix => Some(Form::Matrix(Transform::from_rows(e.try_into().ok()?))),
        FormKind::Patern if e.len().is_multiple_of(3) => {
            let points = (0..e.len() / 3).map(|i| v(3 * i)).collect();
            Some(Form::Pattern(Pattern { points }))
        }
        FormKind::Polcon => {
            let elements: &[f64; Polyconic::N_ELEMENTS] = e.try_into().ok()?;
            Some(Form::Polyconic(Arc::new(Polyconic::from_canonical(elements))))
        }
        _ => None,
    }
}

/// A LINE; one that CANON gave or REFSYS tilted keeps its elements.
fn line(e: &[f64]) -> Option<Form> {
    let (a, b, c, d) = (e[0], e[1], e[2], e[3]);
    if c.abs() <= 0.0 && (a * a + b * b - 1.0).abs() <= 1e-6 {
        return Some(Form::Line(Line { a, b, d }));
    }
    let shape = match Line::new(a, b, d) {
        Some(line) if c.abs() <= 0.0 => Form::Line(line),
        _ => Form::Plane(Plane::new(Vec3::new(a, b, c), d)?),
    };
    Some(Form::Written(Arc::new(Written { kind: FormKind::Line, elements: e.to_vec(), shape })))
}
