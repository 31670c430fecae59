//! POINT.

use aptc_geometry::{Form, Vec3, trig};
use aptc_vocabulary::{Word, word};

use super::choose::XYZ_MODS;
use super::fault::Fault;
use super::format::Item::{C, K, L, N, Of, P, PL, PT, TC, W};
use super::format::{Args, Format, row};
use super::meet::{self, Meet};

const PLANES: &[Word] = &[word::XYPLAN, word::YZPLAN, word::ZXPLAN];

pub(super) const FORMATS: &[Format] = &[
    row(&[N, N], xy),
    row(&[N, N, N], xyz),
    row(&[W(word::INTOF), L, L], two_lines),
    row(&[W(word::INTOF), PL, PL, PL], three_planes),
    row(&[Of(XYZ_MODS), W(word::INTOF), L, C], line_circle),
    row(&[Of(XYZ_MODS), W(word::INTOF), C, C], two_circles),
    row(&[Of(XYZ_MODS), W(word::INTOF), L, K], line_conic),
    row(&[W(word::INTOF), L, TC, P], line_tabcyl),
    row(&[C, W(word::ATANGL), N], on_circle),
    row(&[W(word::CENTER), C], center),
    row(&[W(word::RTHETA), Of(PLANES), N, N], polar),
    row(&[W(word::THETAR), Of(PLANES), N, N], polar),
    row(&[PT, N], of_pattern),
    row(&[P], same),
];

fn xy(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y] = a.numbers(0)?;
    Ok(Form::Point(a.context.on_zsurf(x, y)))
}

fn xyz(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y, z] = a.numbers(0)?;
    Ok(Form::Point(Vec3::new(x, y, z)))
}

fn two_lines(a: &Args<'_>) -> Result<Form, Fault> {
    let (one, other) = (a.line(1)?, a.line(2)?);
    let p = meet::lines(&one, &other).ok_or(Fault::Parallel {
        a: 1,
        b: 2,
        one: one.plane(),
        other: other.plane(),
    })?;
    Ok(Form::Point(a.context.lift(p)))
}

fn three_planes(a: &Args<'_>) -> Result<Form, Fault> {
    let p = [a.plane(1)?, a.plane(2)?, a.plane(3)?];
    let pairs = [(0, 1, 2), (0, 2, 1), (1, 2, 0)];
    for (i, j, _) in pairs {
        if meet::across(p[i].n, p[j].n).is_none() {
            return Err(Fault::Parallel { a: i + 1, b: j + 1, one: p[i], other: p[j] });
        }
    }
    // Along the line of the two planes that stand most across each other.
    let sine = |(i, j, _): (usize, usize, usize)| p[i].n.cross(&p[j].n).norm();
    let best = pairs.into_iter().max_by(|a, b| sine(*a).total_cmp(&sine(*b)));
    let (i, j, k) = best.unwrap_or(pairs[0]);
    let (foot, along) = meet::planes(&p[i], &p[j]).ok_or(Fault::Kind { at: 1 })?;
    let sine = p[k].n.dot(&along);
    if sine.abs() <= meet::PARALLEL {
        return Err(Fault::OneDirection { planes: [1, 2, 3], along });
    }
    Ok(Form::Point(foot - along * (p[k].distance(foot) / sine)))
}

fn line_circle(a: &Args<'_>) -> Result<Form, Fault> {
    let (l, c) = (a.line(2)?, a.circle(3)?);
    match meet::line_circle(&l, c.center.xy(), c.radius) {
        Meet::At(one, other) => a.pick2(0, one, other).map(Form::Point),
        Meet::Apart(gap) => Err(Fault::Apart { a: 2, b: 3, gap }),
        Meet::Same => Err(Fault::Coincide { a: 2, b: 3 }),
    }
}

fn two_circles(a: &Args<'_>) -> Result<Form, Fault> {
    let (one, other) = (a.circle(2)?, a.circle(3)?);
    match meet::circles(one.center.xy(), one.radius, other.center.xy(), other.radius) {
        Meet::At(p, q) => a.pick2(0, p, q).map(Form::Point),
        Meet::Apart(gap) => Err(Fault::Apart { a: 2, b: 3, gap }),
        Meet::Same => Err(Fault::Coincide { a: 2, b: 3 }),
    }
}

fn line_conic(a: &Args<'_>) -> Result<Form, Fault> {
    let (l, q) = (a.line(2)?, a.conic(3)?);
    let foot = meet::normal(&l) * l.d;
    let from = a.context.lift(foot);
    let along = (a.context.lift(foot + meet::direction(&l)) - from).normalize();
    match meet::line_quadric(from, along, &q) {
        Meet::At(p, q) => a.pick(0, p, q).map(Form::Point),
        Meet::Apart(gap) => Err(Fault::Apart { a: 2, b: 3, gap }),
        Meet::Same => Err(Fault::Coincide { a: 2, b: 3 }),
    }
}

fn line_tabcyl(a: &Args<'_>) -> Result<Form, Fault> {
    super::tabcyl::line_meets(a, 1, 2, 3).map(Form::Point)
}

fn on_circle(a: &Args<'_>) -> Result<Form, Fault> {
    let (c, angle) = (a.circle(0)?, a.number(2)?);
    let (x, y) = (trig::cos_deg(angle) * c.radius, trig::sin_deg(angle) * c.radius);
    Ok(Form::Point(a.context.on_zsurf(c.center.x + x, c.center.y + y)))
}

/// An upright circle has no height of its own, as in APT-360; a cylinder's point stays where it was given.
fn center(a: &Args<'_>) -> Result<Form, Fault> {
    let center = a.circle_in_space(1)?.center;
    Ok(Form::Point(match a.circle(1) {
        Ok(c) if a.is_circle(1) => a.context.lift(c.center.xy()),
        _ => center,
    }))
}

/// RTHETA gives the radius first, THETAR the angle. In a plane the angle counts from its first axis to
/// its second: x to y, y to z, z to x. The point lies in the plane named, whatever ZSURF is, as in APT-360.
fn polar(a: &Args<'_>) -> Result<Form, Fault> {
    let [one, other] = a.numbers(2)?;
    let (r, angle) = if a.is(0, word::RTHETA) { (one, other) } else { (other, one) };
    let (u, v) = (r * trig::cos_deg(angle), r * trig::sin_deg(angle));
    Ok(Form::Point(match a.word(1)? {
        word::XYPLAN => Vec3::new(u, v, 0.0),
        word::YZPLAN => Vec3::new(0.0, u, v),
        _ => Vec3::new(v, 0.0, u),
    }))
}

fn of_pattern(a: &Args<'_>) -> Result<Form, Fault> {
    let points = &a.pattern(0)?.points;
    let value = a.number(1)?;
    let found = points.iter().zip(1_u32..).find(|(_, n)| (f64::from(*n) - value).abs() < 1e-6);
    found.map(|(p, _)| Form::Point(*p)).ok_or(Fault::NoSuchPoint { at: 1, value, n: points.len() })
}

fn same(a: &Args<'_>) -> Result<Form, Fault> {
    a.point(0).map(Form::Point)
}
