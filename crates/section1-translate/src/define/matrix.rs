//! MATRIX: a map from the new system into the old one.
//!
//! Of two maps the left is applied to what the right gives, as a product of matrices is; but a rotation
//! followed by a translation, or a translation by a rotation, is carried out in the order written. In APT4 all are:
//! what SSV3 computed for its own tests says so.

use aptc_geometry::{Form, Plane, Transform, Vec3, trig};
use aptc_vocabulary::{Word, word};

use super::fault::Fault;
use super::format::Item::{self, M, N, Of, P, PL, V, W};
use super::format::{Args, Format, row};

const ROT: Item = Of(&[word::XYROT, word::YZROT, word::ZXROT]);
const TR: Item = W(word::TRANSL);
const SC: Item = W(word::SCALE);
const PLANES: Item = Of(&[word::XYPLAN, word::YZPLAN, word::ZXPLAN]);

pub(super) const FORMATS: &[Format] = &[
    row(&[N, N, N, N, N, N, N, N, N, N, N, N], coefficients),
    row(&[TR, N, N], single),
    row(&[TR, N, N, N], single),
    row(&[ROT, N], single),
    row(&[SC, N], single),
    row(&[M, M], pair),
    row(&[M, TR, N, N], pair),
    row(&[M, TR, N, N, N], pair),
    row(&[M, ROT, N], pair),
    row(&[M, SC, N], pair),
    row(&[TR, N, N, M], pair),
    row(&[TR, N, N, N, M], pair),
    row(&[ROT, N, M], pair),
    row(&[SC, N, M], pair),
    row(&[TR, N, N, TR, N, N], pair),
    row(&[TR, N, N, TR, N, N, N], pair),
    row(&[TR, N, N, N, TR, N, N], pair),
    row(&[TR, N, N, N, TR, N, N, N], pair),
    row(&[TR, N, N, ROT, N], pair),
    row(&[TR, N, N, N, ROT, N], pair),
    row(&[TR, N, N, SC, N], pair),
    row(&[TR, N, N, N, SC, N], pair),
    row(&[ROT, N, TR, N, N], pair),
    row(&[ROT, N, TR, N, N, N], pair),
    row(&[ROT, N, ROT, N], pair),
    row(&[ROT, N, SC, N], pair),
    row(&[SC, N, TR, N, N], pair),
    row(&[SC, N, TR, N, N, N], pair),
    row(&[SC, N, ROT, N], pair),
    row(&[SC, N, SC, N], pair),
    row(&[W(word::INVERS), M], inverse),
    row(&[PL, PL, PL], three_planes),
    row(&[P, V, V], origin_and_axes),
    row(&[P, V, N], about_axis),
    row(&[W(word::MIRROR), PLANES], mirror_axes),
    row(&[W(word::MIRROR), PLANES, PLANES], mirror_axes),
    row(&[W(word::MIRROR), PLANES, PLANES, PLANES], mirror_axes),
    row(&[W(word::MIRROR), PL], mirror_plane),
    row(&[M], same),
];

fn coefficients(a: &Args<'_>) -> Result<Form, Fault> {
    a.numbers(0).map(|rows| Form::Matrix(Transform::from_rows(&rows)))
}

/// One map of a list: what it is and where the next begins.
struct Step {
    map: Transform,
    kind: Kind,
    next: usize,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Turn,
    Move,
    Other,
}

fn rotation(word: Word, degrees: f64) -> Transform {
    let axis = match word {
        word::XYROT => Vec3::z(),
        word::YZROT => Vec3::x(),
        _ => Vec3::y(),
    };
    Transform::rotation(axis, degrees)
}

fn step(a: &Args<'_>, at: usize) -> Result<Step, Fault> {
    let Ok(word) = a.word(at) else {
        return Ok(Step { map: a.matrix(at)?, kind: Kind::Other, next: at + 1 });
    };
    Ok(match word {
        word::TRANSL => {
            let [x, y] = a.numbers(at + 1)?;
            let z = if a.is_number(at + 3) { a.number(at + 3)? } else { 0.0 };
            let next = if a.is_number(at + 3) { at + 4 } else { at + 3 };
            Step { map: Transform::translation(Vec3::new(x, y, z)), kind: Kind::Move, next }
        }
        word::SCALE => {
            let value = a.number(at + 1)?;
            if value.abs() < f64::MIN_POSITIVE {
                return Err(Fault::Range { at: at + 1, value, need: "other than 0" });
            }
            Step { map: Transform::scale(value), kind: Kind::Other, next: at + 2 }
        }
        turn => Step { map: rotation(turn, a.number(at + 1)?), kind: Kind::Turn, next: at + 2 },
    })
}

fn single(a: &Args<'_>) -> Result<Form, Fault> {
    step(a, 0).map(|s| Form::Matrix(s.map))
}

fn pair(a: &Args<'_>) -> Result<Form, Fault> {
    let one = step(a, 0)?;
    let other = step(a, one.next)?;
    let in_order = a.context.apt4
        || matches!((one.kind, other.kind), (Kind::Turn, Kind::Move) | (Kind::Move, Kind::Turn));
    let product = if in_order { one.map.then(&other.map) } else { other.map.then(&one.map) };
    Ok(Form::Matrix(product))
}

fn inverse(a: &Args<'_>) -> Result<Form, Fault> {
    a.matrix(1)?.inverse().map(Form::Matrix).ok_or(Fault::Flat { at: 1 })
}

/// Cosine of the angle between planes that still counts as square: more than the rounding of the planes,
/// less than what a user could mean.
const SQUARE: f64 = 1e-6;

/// The map with these columns.
fn columns(x: Vec3, y: Vec3, z: Vec3, shift: Vec3) -> Transform {
    Transform::from_rows(&[x.x, y.x, z.x, shift.x, x.y, y.y, z.y, shift.y, x.z, y.z, z.z, shift.z])
}

/// The new yz, zx and xy planes in this order: their normals are the new axes, the point that they have
/// in common is the new origin.
fn three_planes(a: &Args<'_>) -> Result<Form, Fault> {
    let p: [Plane; 3] = [a.plane(0)?, a.plane(1)?, a.plane(2)?];
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        let cosine = p[i].n.dot(&p[j].n);
        if cosine.abs() > SQUARE {
            let degrees = trig::acos_clamped(cosine).to_degrees();
            return Err(Fault::NotSquare { a: i, b: j, degrees });
        }
    }
    let axes = columns(p[0].n, p[1].n, p[2].n, Vec3::zeros());
    let d = Vec3::new(p[0].d, p[1].d, p[2].d);
    // Rows n_i take the origin to d_i, so it is the inverse of the transposed axes on d.
    let origin = axes.normal(d).ok_or(Fault::Flat { at: 2 })?;
    Ok(Form::Matrix(columns(p[0].n, p[1].n, p[2].n, origin)))
}

/// New origin, new x axis, and a vector in the first or second quadrant of the new xy plane.
fn origin_and_axes(a: &Args<'_>) -> Result<Form, Fault> {
    let (x, v) = (a.direction(1)?, a.direction(2)?);
    let what = "run along each other and give no plane";
    let z = super::meet::across(x, v).ok_or(Fault::Aligned { a: 1, b: 2, what })?;
    Ok(Form::Matrix(columns(x, z.cross(&x), z, a.point(0)?)))
}

fn about_axis(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, axis, degrees) = (a.point(0)?, a.direction(1)?, a.number(2)?);
    let turn = Transform::rotation(axis, degrees);
    Ok(Form::Matrix(Transform { shift: p - turn.vector(p), ..turn }))
}

fn mirror_axes(a: &Args<'_>) -> Result<Form, Fault> {
    let mut d = [1.0; 3];
    for at in 1..a.len() {
        d[match a.word(at)? {
            word::YZPLAN => 0,
            word::ZXPLAN => 1,
            _ => 2,
        }] = -1.0;
    }
    let [x, y, z] = d;
    let rows = [x, 0.0, 0.0, 0.0, 0.0, y, 0.0, 0.0, 0.0, 0.0, z, 0.0];
    Ok(Form::Matrix(Transform::from_rows(&rows)))
}

fn mirror_plane(a: &Args<'_>) -> Result<Form, Fault> {
    let p = a.plane(1)?;
    let across = |axis: Vec3| axis - p.n * (2.0 * p.n.dot(&axis));
    let (x, y, z) = (across(Vec3::x()), across(Vec3::y()), across(Vec3::z()));
    Ok(Form::Matrix(columns(x, y, z, p.n * (2.0 * p.d))))
}

fn same(a: &Args<'_>) -> Result<Form, Fault> {
    a.matrix(0).map(Form::Matrix)
}
