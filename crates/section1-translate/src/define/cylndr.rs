//! CYLNDR.

use aptc_geometry::{Circle, Cylinder, Form, Vec3};
use aptc_vocabulary::word;

use super::circle;
use super::fault::Fault;
use super::format::Item::{C, N, P, V};
use super::format::{Args, Format, row};

/// The formats of its own; those of CIRCLE with tangents follow in [`super::table`].
const OWN: &[Format] = &[
    row(&[N, N, N, N, N, N, N], numbers),
    row(&[P, N, N, N, N], point_numbers),
    row(&[P, V, N], point_vector),
    row(&[N, N, N, V, N], numbers_vector),
    row(&[C], same),
];

const N_OWN: usize = OWN.len();
const N_TANGENT: usize = 10;

/// Its own, then every format of CIRCLE by points and tangents.
pub(super) const FORMATS: &[Format] = &{
    let mut all = [OWN[0]; N_OWN + N_TANGENT];
    let mut i = 0;
    while i < N_OWN {
        all[i] = OWN[i];
        i += 1;
    }
    while i < N_OWN + N_TANGENT {
        all[i] = circle::FORMATS[i - N_OWN + 4];
        i += 1;
    }
    all
};

/// The form of a circle under the word that is being defined.
pub(super) fn circular(a: &Args<'_>, c: Circle) -> Form {
    if a.head == word::CYLNDR { Form::Cylinder(c.cylinder()) } else { Form::Circle(c) }
}

/// The cylinder, or why not: the axis comes from the places `from` on.
fn along(point: Vec3, axis: Vec3, radius: f64, from: usize) -> Result<Form, Fault> {
    let axis = axis.try_normalize(0.0).ok_or(Fault::NoNormal { at: from })?;
    Ok(Form::Cylinder(Cylinder { point, axis, radius }))
}

fn numbers(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y, z, i, j, k] = a.numbers(0)?;
    along(Vec3::new(x, y, z), Vec3::new(i, j, k), a.positive(6)?, 3)
}

fn point_numbers(a: &Args<'_>) -> Result<Form, Fault> {
    let [i, j, k] = a.numbers(1)?;
    along(a.point(0)?, Vec3::new(i, j, k), a.positive(4)?, 1)
}

fn point_vector(a: &Args<'_>) -> Result<Form, Fault> {
    along(a.point(0)?, a.direction(1)?, a.positive(2)?, 1)
}

fn numbers_vector(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y, z] = a.numbers(0)?;
    along(Vec3::new(x, y, z), a.direction(3)?, a.positive(4)?, 3)
}

fn same(a: &Args<'_>) -> Result<Form, Fault> {
    a.circle_in_space(0).map(|c| Form::Cylinder(c.cylinder()))
}
