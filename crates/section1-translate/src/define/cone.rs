//! CONE.

use aptc_geometry::{Cone, Form, trig};

use super::fault::Fault;
use super::format::Item::{N, P, V};
use super::format::{Args, Format, row};

pub(super) const FORMATS: &[Format] = &[row(&[P, V, N], vertex_axis_angle)];

fn vertex_axis_angle(a: &Args<'_>) -> Result<Form, Fault> {
    let value = a.number(2)?;
    let cos_half = trig::cos_deg(value);
    if !(value > 0.0 && value < 90.0 && cos_half < 1.0 && cos_half > 0.0) {
        return Err(Fault::Range { at: 2, value, need: "of degrees between 0 and 90" });
    }
    Ok(Form::Cone(Cone { vertex: a.point(0)?, axis: a.direction(1)?, cos_half }))
}
