//! PLANE.

use aptc_geometry::{Form, Plane, Vec3};
use aptc_vocabulary::word;

use super::choose::XYZ_MODS;
use super::fault::Fault;
use super::format::Item::{C, N, Of, P, PL, V, W};
use super::format::{Args, Format, row};
use super::line::{self, SIDES};
use super::meet;

pub(super) const FORMATS: &[Format] = &[
    row(&[N, N, N, N], coefficients),
    row(&[P, P, P], three_points),
    row(&[P, W(word::PARLEL), PL], parallel_at),
    row(&[W(word::PARLEL), PL, Of(XYZ_MODS), N], parallel_by),
    row(&[P, W(word::PERPTO), V], across_vector),
    row(&[W(word::PERPTO), PL, P, P], across_plane),
    row(&[P, P, W(word::PERPTO), PL], across_plane),
    row(&[P, W(word::PERPTO), PL, PL], across_two_planes),
    row(&[P, Of(SIDES), W(word::TANTO), C], tangent),
    row(&[Of(SIDES), W(word::TANTO), C, Of(SIDES), W(word::TANTO), C], tangent),
    row(&[PL], same),
];

/// The plane through `p` with the unit normal `n`.
fn at(p: Vec3, n: Vec3) -> Form {
    // No negative zeros: they would show in print-outs.
    let n = n.map(|x| x + 0.0);
    Form::Plane(Plane { n, d: n.dot(&p) + 0.0 })
}

fn coefficients(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y, z, d] = a.numbers(0)?;
    Plane::new(Vec3::new(x, y, z), d).map(Form::Plane).ok_or(Fault::NoNormal { at: 0 })
}

fn three_points(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, q, r) = (a.point(0)?, a.point(1)?, a.point(2)?);
    let (u, v) = (q - p, r - p);
    let sides = [u.norm(), v.norm(), (r - q).norm()];
    let (longest, shortest) = (
        sides.iter().fold(0.0, |m: f64, s| m.max(*s)),
        sides.iter().fold(f64::MAX, |m, s| m.min(*s)),
    );
    let size = p.amax().max(q.amax()).max(r.amax());
    // Corners closer than their rounding have no direction between them.
    let distinct = shortest > 1e-12 * size;
    let height = u.cross(&v).norm() / longest;
    let n = meet::across(u, v).filter(|_| distinct && height > 1e-12 * size);
    let what = "they lie on one line";
    n.map(|n| at(p, n)).ok_or(Fault::Dependent { places: vec![0, 1, 2], what })
}

fn parallel_at(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(at(a.point(0)?, a.plane(2)?.n))
}

fn parallel_by(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, by) = (a.plane(1)?, a.number(3)?);
    let side = a.side(2, p.n)?;
    Ok(Form::Plane(Plane { n: p.n.map(|x| side * x + 0.0), d: side * p.d + by }))
}

fn across_vector(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(at(a.point(0)?, a.direction(2)?))
}

fn across_plane(a: &Args<'_>) -> Result<Form, Fault> {
    let (plane, first, second) = if a.is(0, word::PERPTO) { (1, 2, 3) } else { (3, 0, 1) };
    let (p, q, n) = (a.point(first)?, a.point(second)?, a.plane(plane)?.n);
    let way = q - p;
    let size = p.amax().max(q.amax());
    if way.norm() <= 1e-12 * size {
        return Err(Fault::Coincide { a: first, b: second });
    }
    let what = "the way between the points stands upright on the plane";
    let across = meet::across(way, n);
    across.map(|n| at(p, n)).ok_or(Fault::Dependent { places: vec![plane, first, second], what })
}

fn across_two_planes(a: &Args<'_>) -> Result<Form, Fault> {
    let (one, other) = (a.plane(2)?, a.plane(3)?);
    let along = meet::across(one.n, other.n).ok_or(Fault::Parallel { a: 2, b: 3, one, other })?;
    Ok(at(a.point(0)?, along))
}

/// As LINE has it: the plane is vertical.
fn tangent(a: &Args<'_>) -> Result<Form, Fault> {
    line::tangent(a).map(|l| Form::Plane(l.plane()))
}

fn same(a: &Args<'_>) -> Result<Form, Fault> {
    a.plane(0).map(Form::Plane)
}
