//! RLDSRF: rulings between two plane cuts of surfaces, or from one to a point.

use std::sync::Arc;

use aptc_geometry::{Form, Rail, RuledSurface, Second, Vec3};

use super::fault::Fault;
use super::format::Item::{P, S, V};
use super::format::{Args, Format, row};
use super::{Value, meet};

pub(super) const FORMATS: &[Format] = &[
    row(&[S, P, P, P, S, P, P, P], two_curves),
    row(&[S, P, P, V, S, P, P, V], two_curves),
    row(&[S, P, P, V, S, P, P, P], two_curves),
    row(&[S, P, P, P, S, P, P, V], two_curves),
    row(&[S, P, P, P, P], to_point),
    row(&[S, P, P, V, P], to_point),
];

/// Sine of the angle to the line between the ends up to which a vector leads along it, as APT-360 has it (702): the curve is
/// looked for along the vector, and rulings would lean into each other.
const ALONG: f64 = 0.1;

/// The curve whose surface stands at `at`, its ends and the third point or vector after it.
fn rail(a: &Args<'_>, at: usize) -> Result<Rail, Fault> {
    let surface = match a.list.get(at).map(|arg| &arg.value) {
        Some(Value::Form { form, .. }) => match &**form {
            Form::Written(w) => Arc::new(w.shape.clone()),
            _ => Arc::clone(form),
        },
        _ => return Err(Fault::Kind { at }),
    };
    let (start, end) = (a.point(at + 1)?, a.point(at + 2)?);
    let chord: Vec3 = end - start;
    let size = start.amax().max(end.amax());
    if chord.norm() <= 1e-12 * size {
        return Err(Fault::Coincide { a: at + 1, b: at + 2 });
    }
    let along = chord.normalize();
    let (toward, from_point) = match a.form(at + 3) {
        Ok(Form::Vector(v)) => (*v, false),
        _ => (a.point(at + 3)? - start, true),
    };
    let across = toward - along * along.dot(&toward);
    if across.norm() <= meet::PARALLEL * toward.norm() || toward.norm() <= 1e-12 * size {
        let places = vec![at + 1, at + 2, at + 3];
        return Err(Fault::Dependent { places, what: "they give no cutting plane" });
    }
    if !from_point && across.norm() <= ALONG * toward.norm() {
        let places = vec![at + 1, at + 2, at + 3];
        let what = "the vector leads along the line between the points; give one that leads from it to the curve";
        return Err(Fault::Dependent { places, what });
    }
    // A plane is cut in a line where it leans against the way to it.
    let flat = match surface.shape() {
        Form::Plane(p) => Some(p.n),
        Form::Line(l) => Some(l.plane().n),
        _ => None,
    };
    if flat.is_some_and(|n| n.dot(&across).abs() <= meet::PARALLEL * across.norm()) {
        let places = vec![at, at + 1, at + 2, at + 3];
        let what = "its cutting plane does not meet this plane in a line";
        return Err(Fault::Dependent { places, what });
    }
    // A third point only tells the side; a vector is the direction itself.
    let toward = if from_point { across.normalize() } else { toward.normalize() };
    Ok(Rail { surface, start, end, toward })
}

fn two_curves(a: &Args<'_>) -> Result<Form, Fault> {
    let (first, second) = (rail(a, 0)?, Second::Rail(rail(a, 4)?));
    Ok(Form::Ruled(Arc::new(RuledSurface { first, second })))
}

fn to_point(a: &Args<'_>) -> Result<Form, Fault> {
    let (first, second) = (rail(a, 0)?, Second::Apex(a.point(4)?));
    Ok(Form::Ruled(Arc::new(RuledSurface { first, second })))
}
