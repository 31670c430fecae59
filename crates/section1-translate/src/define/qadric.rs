//! QADRIC: `A x2 + B y2 + C z2 + F y z + G x z + H x y + P x + Q y + R z + D = 0`, written in this order.

use aptc_geometry::{Form, Quadric, QuadricKind};

use super::fault::Fault;
use super::format::Item::N;
use super::format::{Args, Format, row};

pub(super) const FORMATS: &[Format] = &[row(&[N, N, N, N, N, N, N, N, N, N], coefficients)];

fn coefficients(a: &Args<'_>) -> Result<Form, Fault> {
    let [x2, y2, z2, f, g, h, p, q, r, d] = a.numbers(0)?;
    if [x2, y2, z2, f, g, h, p, q, r].iter().all(|c| c.abs() < f64::MIN_POSITIVE) {
        return Err(Fault::NoCurve { what: "has no term but the constant" });
    }
    let c = [x2, y2, z2, d, f / 2.0, g / 2.0, h / 2.0, p / 2.0, q / 2.0, r / 2.0];
    Ok(Form::Quadric(Quadric { kind: QuadricKind::Qadric, c }))
}
