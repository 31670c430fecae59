//! CANON: a form by its canonical elements, all of them or those to be replaced.

use std::sync::Arc;

use aptc_geometry::sculptured::{CurveDefinition, CurveShape, SurfaceDefinition, SurfaceShape};
use aptc_geometry::{
    Circle, Cone, Cylinder, Form, FormKind, Line, Plane, Polyconic, Quadric, QuadricKind, Sphere,
    Transform, Vec3, Written,
};
use aptc_vocabulary::{Word, word};

use super::fault::Fault;
use super::{Arg, Context, DefineError, Value};

/// The form `head/CANON,args`, or with `old` the form `head/old,CANON,args`, where empty fields keep the
/// elements of `old`.
///
/// Elements that are not in normal shape (a normal of another length than 1) stay as written for OBTAIN
/// and PRINT; the result is then a [`Form::Written`].
pub fn canonical(
    head: Word,
    old: Option<&Form>,
    args: &[Arg],
    context: &Context,
) -> Result<Form, DefineError> {
    let kind = kind(head).ok_or_else(|| DefineError::no_word(head))?;
    let fault = |fault| DefineError::from_fault(head, fault);
    let Some(system) = &context.refsys else {
        return altered(kind, old, args).map_err(fault);
    };
    let inverse = system.inverse().ok_or_else(DefineError::flat_system)?;
    let local = match old {
        Some(old) => Some(old.transformed(&inverse).map_err(DefineError::result_not_carried)?),
        None => None,
    };
    let form = altered(kind, local.as_ref(), args).map_err(fault)?;
    form.transformed(system).map_err(DefineError::result_not_carried)
}

/// The kind of form that a word defines by CANON.
fn kind(head: Word) -> Option<FormKind> {
    Some(match head {
        word::POINT => FormKind::Point,
        word::VECTOR => FormKind::Vector,
        word::LINE => FormKind::Line,
        word::PLANE => FormKind::Plane,
        word::CIRCLE => FormKind::Circle,
        word::CYLNDR => FormKind::Cylndr,
        word::SPHERE => FormKind::Sphere,
        word::CONE => FormKind::Cone,
        word::ELLIPS => FormKind::Ellips,
        word::HYPERB => FormKind::Hyperb,
        word::GCONIC => FormKind::Gconic,
        word::LCONIC => FormKind::Lconic,
        word::QADRIC => FormKind::Qadric,
        word::MATRIX => FormKind::Matrix,
        word::TABCYL => FormKind::Tabcyl,
        word::POLCON => FormKind::Polcon,
        word::SCURV => FormKind::Scurv,
        word::SSURF => FormKind::Ssurf,
        _ => return None,
    })
}

/// The number of canonical elements; `None` where it depends on the first.
fn count(kind: FormKind) -> Option<usize> {
    Some(match kind {
        FormKind::Point | FormKind::Vector => 3,
        FormKind::Line | FormKind::Plane | FormKind::Sphere => 4,
        FormKind::Circle | FormKind::Cylndr | FormKind::Cone => 7,
        FormKind::Ellips
        | FormKind::Hyperb
        | FormKind::Gconic
        | FormKind::Lconic
        | FormKind::Qadric => 10,
        FormKind::Matrix => 12,
        FormKind::Polcon => Polyconic::N_ELEMENTS,
        FormKind::Patern
        | FormKind::Tabcyl
        | FormKind::Rldsrf
        | FormKind::Scurv
        | FormKind::Ssurf
        | FormKind::Bounds
        | FormKind::Object => return None,
    })
}

fn altered(kind: FormKind, old: Option<&Form>, args: &[Arg]) -> Result<Form, Fault> {
    let mut elements = match old {
        Some(old) if old.kind() == kind && !has_elements(old) => {
            return Err(Fault::NoCurve { what: "was not given by CANON and has no such elements" });
        }
        Some(old) if old.kind() == kind => old.canonical(),
        Some(old) => return Err(Fault::OtherKind { found: old.kind().word() }),
        None => vec![f64::NAN; count(kind).unwrap_or(args.len())],
    };
    let need = elements.len();
    if args.len() > need {
        return Err(Fault::Elements { at: need, need, found: args.len() });
    }
    for (i, arg) in args.iter().enumerate() {
        match arg.value {
            Value::Number(n) if n.is_finite() => elements[i] = n,
            Value::Number(_) => return Err(Fault::NotFinite { at: i }),
            Value::Empty if old.is_some() => {}
            _ => return Err(Fault::Unexpected { at: i, expected: "a number" }),
        }
    }
    if old.is_none() && args.len() < need {
        return Err(Fault::Elements { at: args.len(), need, found: args.len() });
    }
    build(kind, elements)
}

/// Sculptured forms have elements only when CANON gave them.
fn has_elements(form: &Form) -> bool {
    match form {
        Form::Scurv(c) => matches!(c.shape, CurveShape::Canonical(_)) && c.map.is_none(),
        Form::Ssurf(s) => matches!(s.shape, SurfaceShape::Canonical(_)) && s.map.is_none(),
        _ => true,
    }
}

/// The form of a full list of elements.
fn build(kind: FormKind, e: Vec<f64>) -> Result<Form, Fault> {
    let at = |i: usize| Vec3::new(e[i], e[i + 1], e[i + 2]);
    let unit = |i: usize| at(i).try_normalize(0.0).ok_or(Fault::NoNormal { at: i });
    let positive = |i: usize| {
        if e[i] > 0.0 {
            Ok(e[i])
        } else {
            Err(Fault::Range { at: i, value: e[i], need: "above 0" })
        }
    };
    let shape = match kind {
        FormKind::Point => Form::Point(at(0)),
        FormKind::Vector => Form::Vector(at(0)),
        FormKind::Line | FormKind::Plane => {
            let plane = Plane::new(at(0), e[3]).ok_or(Fault::NoNormal { at: 0 })?;
            match Line::new(plane.n.x, plane.n.y, plane.d) {
                Some(line) if kind == FormKind::Line && plane.n.z.abs() <= 1e-12 => {
                    Form::Line(line)
                }
                _ => Form::Plane(plane),
            }
        }
        FormKind::Circle => {
            Form::Circle(Circle { center: at(0), axis: unit(3)?, radius: positive(6)? })
        }
        FormKind::Cylndr => {
            Form::Cylinder(Cylinder { point: at(0), axis: unit(3)?, radius: positive(6)? })
        }
        FormKind::Sphere => Form::Sphere(Sphere { center: at(0), radius: positive(3)? }),
        FormKind::Cone => {
            let cos_half = positive(6)?;
            if cos_half >= 1.0 {
                let need = "between 0 and 1, the cosine of the half angle,";
                return Err(Fault::Range { at: 6, value: cos_half, need });
            }
            Form::Cone(Cone { vertex: at(0), axis: unit(3)?, cos_half })
        }
        FormKind::Ellips => quadric(QuadricKind::Ellips, &e),
        FormKind::Hyperb => quadric(QuadricKind::Hyperb, &e),
        FormKind::Gconic => quadric(QuadricKind::Gconic, &e),
        FormKind::Lconic => quadric(QuadricKind::Lconic, &e),
        FormKind::Qadric => quadric(QuadricKind::Qadric, &e),
        FormKind::Matrix => Form::Matrix(Transform::from_rows(&array(&e))),
        FormKind::Polcon => {
            let polyconic = Polyconic::from_canonical(&array(&e));
            if polyconic.is_skew() {
                let what =
                    "has a matrix (elements 2 to 13) that flattens space or does not keep angles";
                return Err(Fault::NoCurve { what });
            }
            Form::Polyconic(Arc::new(polyconic))
        }
        FormKind::Tabcyl => super::tabcyl::from_elements(&e)?,
        FormKind::Scurv | FormKind::Ssurf if e.is_empty() => {
            return Err(Fault::Elements { at: 0, need: 1, found: 0 });
        }
        FormKind::Scurv => {
            let curve = CurveDefinition::plain(CurveShape::Canonical(e));
            return Ok(Form::Scurv(Arc::new(curve)));
        }
        FormKind::Ssurf => {
            let surface = SurfaceDefinition::plain(SurfaceShape::Canonical(e));
            return Ok(Form::Ssurf(Arc::new(surface)));
        }
        FormKind::Patern | FormKind::Rldsrf | FormKind::Bounds | FormKind::Object => {
            return Err(Fault::NoCurve { what: "has no canonical input" });
        }
    };
    let normal = shape.canonical();
    let alike = |(x, y): (&f64, &f64)| (x - y).abs() <= 4.0 * f64::EPSILON * x.abs().max(1.0);
    let in_shape = kind == shape.kind() && normal.iter().zip(&e).all(alike);
    Ok(if in_shape { shape } else { Form::Written(Arc::new(Written { kind, elements: e, shape })) })
}

fn quadric(kind: QuadricKind, e: &[f64]) -> Form {
    Form::Quadric(Quadric { kind, c: array(e) })
}

fn array<const N: usize>(e: &[f64]) -> [f64; N] {
    std::array::from_fn(|i| e[i])
}
