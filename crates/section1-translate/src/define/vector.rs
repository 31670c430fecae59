//! VECTOR. Where no length is given it is 1.

use aptc_geometry::{Form, Vec2, Vec3, trig};
use aptc_vocabulary::{Word, word};

use super::choose::SENSES;
use super::fault::Fault;
use super::format::Item::{L, N, Of, P, PL, PV, V, W};
use super::format::{Args, Format, row};
use super::line::at_degrees;
use super::meet;

const PLANES: &[Word] = &[word::XYPLAN, word::YZPLAN, word::ZXPLAN];
const FLAT_SENSES: &[Word] = &[
    word::POSX,
    word::NEGX,
    word::POSY,
    word::NEGY,
    word::XLARGE,
    word::XSMALL,
    word::YLARGE,
    word::YSMALL,
];

pub(super) const FORMATS: &[Format] = &[
    row(&[N, N, N], components),
    row(&[N, N, N, N, N, N], between_numbers),
    row(&[P, P], between_points),
    row(&[W(word::PERPTO), PL, Of(SENSES)], normal),
    row(&[N, W(word::TIMES), PV], times),
    row(&[PV, W(word::CROSS), PV], cross),
    row(&[W(word::UNIT), PV], unit),
    row(&[W(word::UNIT), N, N, N], unit_components),
    row(&[W(word::LENGTH), N, W(word::ATANGL), N, Of(PLANES)], polar),
    row(&[W(word::PARLEL), W(word::INTOF), PL, PL, Of(SENSES)], along_cut),
    row(&[PV, W(word::PLUS), PV], plus),
    row(&[PV, W(word::MINUS), PV], minus),
    row(&[W(word::ATANGL), N, L, Of(FLAT_SENSES)], at_angle),
    row(&[V], same),
];

fn components(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y, z] = a.numbers(0)?;
    Ok(Form::Vector(Vec3::new(x, y, z)))
}

fn between_numbers(a: &Args<'_>) -> Result<Form, Fault> {
    let [x1, y1, z1, x2, y2, z2] = a.numbers(0)?;
    Ok(Form::Vector(Vec3::new(x2 - x1, y2 - y1, z2 - z1)))
}

fn between_points(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(Form::Vector(a.point(1)? - a.point(0)?))
}

fn normal(a: &Args<'_>) -> Result<Form, Fault> {
    let n = a.plane(1)?.n;
    Ok(Form::Vector(n * a.side(2, n)?))
}

fn times(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(Form::Vector(a.vector(2)? * a.number(0)?))
}

fn cross(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(Form::Vector(a.vector(0)?.cross(&a.vector(2)?)))
}

fn unit(a: &Args<'_>) -> Result<Form, Fault> {
    a.direction(1).map(Form::Vector)
}

fn unit_components(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y, z] = a.numbers(1)?;
    let v = Vec3::new(x, y, z).try_normalize(0.0);
    v.map(Form::Vector).ok_or(Fault::NoNormal { at: 1 })
}

/// The angle counts from the first axis of the plane's name to the second.
fn polar(a: &Args<'_>) -> Result<Form, Fault> {
    let (length, angle) = (a.number(1)?, a.number(3)?);
    let (u, v) = (length * trig::cos_deg(angle), length * trig::sin_deg(angle));
    Ok(Form::Vector(match a.word(4)? {
        word::XYPLAN => Vec3::new(u, v, 0.0),
        word::YZPLAN => Vec3::new(0.0, u, v),
        _ => Vec3::new(v, 0.0, u),
    }))
}

fn along_cut(a: &Args<'_>) -> Result<Form, Fault> {
    let (one, other) = (a.plane(2)?, a.plane(3)?);
    let along = meet::across(one.n, other.n).ok_or(Fault::Parallel { a: 2, b: 3, one, other })?;
    Ok(Form::Vector(along * a.side(4, along)?))
}

fn plus(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(Form::Vector(a.vector(0)? + a.vector(2)?))
}

fn minus(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(Form::Vector(a.vector(0)? - a.vector(2)?))
}

/// Anticlockwise from the line, which is taken in the sense that gives the vector the named direction.
fn at_angle(a: &Args<'_>) -> Result<Form, Fault> {
    let (turn, along) = (at_degrees(a.number(1)?), meet::direction(&a.line(2)?));
    let v = Vec2::new(along.x * turn.x - along.y * turn.y, along.x * turn.y + along.y * turn.x);
    let v = Vec3::new(v.x, v.y, 0.0);
    Ok(Form::Vector(v * a.side(3, v)?))
}

fn same(a: &Args<'_>) -> Result<Form, Fault> {
    a.vector(0).map(Form::Vector)
}
