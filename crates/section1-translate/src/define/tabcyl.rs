//! TABCYL.

use aptc_geometry::{Form, Line, Vec2, Vec3};

use super::fault::Fault;
use super::format::{Args, Format};

pub(super) const FORMATS: &[Format] = &[];

pub(super) fn line_meets(_: &Args<'_>, line: usize, _: usize, _: usize) -> Result<Vec3, Fault> {
    Err(Fault::Kind { at: line })
}

pub(super) fn tangent(_: &Args<'_>, p: usize, _: usize, _: usize) -> Result<Line, Fault> {
    Err(Fault::Kind { at: p })
}

pub(super) fn normal(_: &Args<'_>, p: usize, _: usize, _: usize) -> Result<Line, Fault> {
    Err(Fault::Kind { at: p })
}

pub(super) fn circle_center(a: &Args<'_>, _: f64) -> Result<Vec2, Fault> {
    Err(Fault::Kind { at: a.len() })
}

pub(super) fn from_elements(_: &[f64]) -> Result<Form, Fault> {
    Err(Fault::NoCurve { what: "cannot be given by CANON" })
}
