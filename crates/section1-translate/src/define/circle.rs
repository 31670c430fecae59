//! CIRCLE: its axis is along z. A height given with the centre is read and not kept: as in APT-360 the centre of
//! the form is in the xy plane of its system, and POINT/CENTER takes its height from ZSURF.

use aptc_geometry::{Circle, Form, Line, Vec2, Vec3};
use aptc_vocabulary::{Word, word};

use super::choose::XY_MODS;
use super::fault::Fault;
use super::format::Item::{C, L, N, Of, P, TC, W};
use super::format::{Args, Format, row};
use super::meet::{self, Meet};

const SIZES: &[Word] = &[word::LARGE, word::SMALL];
const IN_OUT: &[Word] = &[word::IN, word::OUT];
const MOD: super::format::Item = Of(XY_MODS);

pub(super) const FORMATS: &[Format] = &[
    row(&[N, N, N], center_radius),
    row(&[N, N, N, N], center_radius_z),
    row(&[W(word::CENTER), P, W(word::RADIUS), N], about_point),
    row(&[W(word::CENTER), N, N, N, W(word::RADIUS), N], about_numbers),
    row(&[W(word::CENTER), P, W(word::TANTO), L], about_touching_line),
    row(&[W(word::CENTER), P, P], about_through),
    row(&[P, P, P], three_points),
    row(&[W(word::CENTER), P, Of(SIZES), W(word::TANTO), C], about_touching_circle),
    row(&[W(word::TANTO), L, MOD, P, W(word::RADIUS), N], line_and_point),
    row(&[MOD, L, MOD, L, W(word::RADIUS), N], two_lines),
    row(&[MOD, L, MOD, Of(IN_OUT), C, W(word::RADIUS), N], line_and_circle),
    row(&[MOD, Of(IN_OUT), C, Of(IN_OUT), C, W(word::RADIUS), N], two_circles),
    row(&[W(word::TANTO), L, MOD, TC, MOD, P, W(word::RADIUS), N], line_and_tabcyl),
    row(&[MOD, L, MOD, L, MOD, L], three_lines),
    row(&[C], same),
];

/// The circle about `c`, or the cylinder over it for CYLNDR.
pub(super) fn about(a: &Args<'_>, center: Vec2, radius: f64) -> Form {
    over(a, Vec3::new(center.x, center.y, 0.0), radius)
}

fn over(a: &Args<'_>, center: Vec3, radius: f64) -> Form {
    super::cylndr::circular(a, Circle { center, axis: Vec3::z(), radius })
}

fn center_radius(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y, _] = a.numbers(0)?;
    Ok(about(a, Vec2::new(x, y), a.positive(2)?))
}

fn center_radius_z(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y, _] = a.numbers(0)?;
    Ok(about(a, Vec2::new(x, y), a.positive(3)?))
}

fn about_point(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(about(a, a.point2(1)?, a.positive(3)?))
}

fn about_numbers(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y, _] = a.numbers(1)?;
    Ok(about(a, Vec2::new(x, y), a.positive(5)?))
}

/// A radius that comes out of two arguments must not be lost in their rounding.
fn radius_of(a: usize, b: usize, radius: f64, size: f64) -> Result<f64, Fault> {
    if radius > 1e-12 * size { Ok(radius) } else { Err(Fault::Coincide { a, b }) }
}

fn about_touching_line(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, l) = (a.point2(1)?, a.line(3)?);
    let radius = (meet::normal(&l).dot(&p) - l.d).abs();
    Ok(about(a, p, radius_of(1, 3, radius, p.amax())?))
}

fn about_through(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, q) = (a.point2(1)?, a.point2(2)?);
    let radius = radius_of(1, 2, (q - p).norm(), p.amax().max(q.amax()))?;
    Ok(about(a, p, radius))
}

fn three_points(a: &Args<'_>) -> Result<Form, Fault> {
    let p = [a.point2(0)?, a.point2(1)?, a.point2(2)?];
    let size = p.iter().fold(0.0_f64, |m, p| m.max(p.amax()));
    let side = |i: usize, j: usize| (p[j] - p[i]).norm();
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        if side(i, j) <= 1e-12 * size {
            return Err(Fault::Coincide { a: i, b: j });
        }
    }
    // From the corner opposite the longest side: differences of close points are exact.
    let corners = [(0, 1, 2), (1, 2, 0), (2, 0, 1)];
    let opposite = |&(_, j, k): &(usize, usize, usize)| side(j, k);
    let best = corners.iter().max_by(|a, b| opposite(a).total_cmp(&opposite(b)));
    let &(i, j, k) = best.unwrap_or(&corners[0]);
    let (u, v) = (p[j] - p[i], p[k] - p[i]);
    let area = u.perp(&v);
    // Flatter, the centre would be more than a thousand million chords away.
    if area.abs() <= 1e-9 * u.norm() * v.norm() {
        return Err(Fault::Dependent { places: vec![0, 1, 2], what: "they lie on one line" });
    }
    let to_center = meet::left(u * v.norm_squared() - v * u.norm_squared()) / (2.0 * area);
    Ok(about(a, p[i] + to_center, to_center.norm()))
}

/// LARGE takes the given circle in, SMALL leaves it out, or lies within.
fn about_touching_circle(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, c) = (a.point2(1)?, a.circle(4)?);
    let distance = (c.center.xy() - p).norm();
    let radius =
        if a.is(2, word::LARGE) { distance + c.radius } else { (distance - c.radius).abs() };
    let size = p.amax() + c.radius;
    if radius <= 1e-12 * size {
        return Err(Fault::Misplaced { at: 1, by: 4, what: "lies on", amount: 0.0 });
    }
    Ok(about(a, p, radius))
}

/// A circle through a point of the line itself may lie on either side of it.
fn line_and_point(a: &Args<'_>) -> Result<Form, Fault> {
    let (l, p, r) = (a.line(1)?, a.point2(3)?, a.positive(5)?);
    let n = meet::normal(&l);
    let height = n.dot(&p) - l.d;
    let (one, other) = if height.abs() <= meet::SLACK * (r + p.amax()) {
        let foot = p - n * height;
        (foot + n * r, foot - n * r)
    } else {
        match meet::line_circle(&meet::offset(&l, r * height.signum()), p, r) {
            Meet::At(one, other) => (one, other),
            _ => {
                let amount = height.abs() - 2.0 * r;
                let what = "is out of reach of a circle of this radius on";
                return Err(Fault::Misplaced { at: 3, by: 1, what, amount });
            }
        }
    };
    Ok(about(a, a.pick2(2, one, other)?.xy(), r))
}

/// The line moved by `r` to the side that the modifier at `at` names, and its normal to that side.
fn moved(a: &Args<'_>, at: usize, r: f64) -> Result<Line, Fault> {
    let l = a.line(at + 1)?;
    Ok(meet::offset(&l, r * a.side2(at, meet::normal(&l))?))
}

fn two_lines(a: &Args<'_>) -> Result<Form, Fault> {
    let r = a.positive(5)?;
    let (one, other) = (moved(a, 0, r)?, moved(a, 2, r)?);
    let p = meet::lines(&one, &other).ok_or_else(|| {
        let planes = (a.plane(1), a.plane(3));
        match planes {
            (Ok(one), Ok(other)) => Fault::Parallel { a: 1, b: 3, one, other },
            _ => Fault::Kind { at: 1 },
        }
    })?;
    Ok(about(a, p, r))
}

/// Distance of the centre from that of the circle at `at + 1`, touched from IN or OUT as `at` says.
fn reach(a: &Args<'_>, at: usize, r: f64) -> Result<(Vec2, f64), Fault> {
    let c = a.circle(at + 1)?;
    let distance = if a.is(at, word::IN) { (c.radius - r).abs() } else { c.radius + r };
    Ok((c.center.xy(), distance))
}

fn line_and_circle(a: &Args<'_>) -> Result<Form, Fault> {
    let r = a.positive(6)?;
    let (c, distance) = reach(a, 3, r)?;
    match meet::line_circle(&moved(a, 0, r)?, c, distance) {
        Meet::At(one, other) => Ok(about(a, a.pick2(2, one, other)?.xy(), r)),
        Meet::Apart(gap) => Err(Fault::OutOfReach { a: 1, b: 4, gap }),
        Meet::Same => Err(Fault::Coincide { a: 1, b: 4 }),
    }
}

fn two_circles(a: &Args<'_>) -> Result<Form, Fault> {
    let r = a.positive(6)?;
    let ((c1, d1), (c2, d2)) = (reach(a, 1, r)?, reach(a, 3, r)?);
    match meet::circles(c1, d1, c2, d2) {
        // The one format whose form APT-360 gives the height of ZSURF.
        Meet::At(one, other) => Ok(over(a, a.pick2(0, one, other)?, r)),
        Meet::Apart(gap) => Err(Fault::OutOfReach { a: 2, b: 4, gap }),
        Meet::Same => Err(Fault::Coincide { a: 2, b: 4 }),
    }
}

/// The first modifier names the side of the line, the second that of the TABCYL.
fn line_and_tabcyl(a: &Args<'_>) -> Result<Form, Fault> {
    let r = a.positive(7)?;
    let center = super::tabcyl::circle_center(a, r)?;
    Ok(about(a, center, r))
}

/// On the named side of each line: `n . c - r = d` three times, linear in the centre and the radius.
fn three_lines(a: &Args<'_>) -> Result<Form, Fault> {
    let mut lines = [Line { a: 0.0, b: 0.0, d: 0.0 }; 3];
    for (i, line) in lines.iter_mut().enumerate() {
        let l = a.line(2 * i + 1)?;
        let side = a.side2(2 * i, meet::normal(&l))?;
        *line = Line { a: side * l.a, b: side * l.b, d: side * l.d };
    }
    // The centre stands on the bisectors n1 - n2 and n1 - n3.
    let bisector = |i: usize, j: usize| {
        let n = meet::normal(&lines[i]) - meet::normal(&lines[j]);
        Line::new(n.x, n.y, lines[i].d - lines[j].d).filter(|_| n.norm() > meet::PARALLEL)
    };
    let parallel = |i: usize, j: usize| Fault::Parallel {
        a: 2 * i + 1,
        b: 2 * j + 1,
        one: lines[i].plane(),
        other: lines[j].plane(),
    };
    let one = bisector(0, 1).ok_or_else(|| parallel(0, 1))?;
    let other = bisector(0, 2).ok_or_else(|| parallel(0, 2))?;
    let Some(center) = meet::lines(&one, &other) else {
        bisector(1, 2).ok_or_else(|| parallel(1, 2))?;
        return Err(Fault::Dependent {
            places: vec![1, 3, 5],
            what: "no circle touches all three on these sides",
        });
    };
    let radius = meet::normal(&lines[0]).dot(&center) - lines[0].d;
    if radius <= 1e-12 * center.amax() {
        let what = "the sides named by the modifiers have no circle in common".to_owned();
        return Err(Fault::NothingThere { at: 4, what });
    }
    Ok(about(a, center, radius))
}

fn same(a: &Args<'_>) -> Result<Form, Fault> {
    a.circle(0).map(|c| super::cylndr::circular(a, c))
}
