//! BOUNDS and OBJECT: sides of surfaces, and what is made of them.

use std::sync::Arc;

use aptc_geometry::sculptured::{Side, Solid};
use aptc_geometry::{Form, FormKind};
use aptc_vocabulary::word;

use super::choose::SENSES;
use super::cursor::{Cursor, bounded};
use super::fault::Fault;
use super::format::Item::Rest;
use super::format::{Args, Format, row};

pub(super) const BOUNDS: &[Format] =
    &[row(&[Rest("surfaces, each with a number, IN, OUT, POSX .. NEGZ or a point")], bounds)];
pub(super) const OBJECT: &[Format] = &[row(&[Rest("BOUNDS and OBJECTs")], object)];

fn bounds(a: &Args<'_>) -> Result<Form, Fault> {
    let mut c = Cursor::new(a, 0);
    let mut parts = Vec::new();
    while !c.is_empty() {
        let form = a.list[c.at].form().filter(|f| is_side(f));
        let Some(form) = form else { return c.unexpected("a surface") };
        c.at += 1;
        let choice = c.at;
        let side = if c.take(&[word::IN]).is_some() {
            Side::In
        } else if c.take(&[word::OUT]).is_some() {
            Side::Out
        } else if c.take(SENSES).is_some() {
            Side::Toward(a.toward(choice)?)
        } else if let Some(p) = c.point() {
            Side::Of(p)
        } else if a.is_number(c.at) {
            Side::Numbered(c.number("a number")?)
        } else {
            Side::Own
        };
        parts.push((form.clone(), side));
    }
    some(a, parts, false)
}

fn object(a: &Args<'_>) -> Result<Form, Fault> {
    let mut parts = Vec::new();
    for (at, arg) in a.list.iter().enumerate() {
        match arg.form() {
            Some(form @ Form::Solid(_)) => {
                parts.push((form.clone(), Side::Own));
            }
            _ => return Err(Fault::Unexpected { at, expected: "a BOUNDS or an OBJECT" }),
        }
    }
    some(a, parts, true)
}

fn some(a: &Args<'_>, parts: Vec<(Form, Side)>, object: bool) -> Result<Form, Fault> {
    if parts.is_empty() {
        let what = if object { "parts" } else { "surfaces" };
        return Err(Fault::TooFew { at: 0, need: 1, found: 0, what });
    }
    let solid = Solid { object, parts };
    bounded(solid.extent(), a.context.max_points)?;
    Ok(Form::Solid(Arc::new(solid)))
}

/// Does the form bound space? Sculptured surfaces end somewhere and do not.
fn is_side(form: &Form) -> bool {
    !matches!(
        form.kind(),
        FormKind::Point
            | FormKind::Vector
            | FormKind::Matrix
            | FormKind::Patern
            | FormKind::Scurv
            | FormKind::Ssurf
            | FormKind::Object
    )
}
