//! LINE: a vertical plane.
//!
//! Signs of the normal as APT-360 has them: through two points it lies to the right of the way from the
//! first to the second; at an angle or slope from the x axis to the left of the direction, from the y axis to the
//! right; in the cut of two planes to the left of the product of their normals; a tangent's points to the (last)
//! circle; a parallel's to the side that the modifier names; a perpendicular's is that of the given line turned
//! left.

use aptc_geometry::{Form, Line, Vec2, trig};
use aptc_vocabulary::{Word, word};

use super::choose::XY_MODS;
use super::fault::Fault;
use super::format::Item::{C, L, N, Of, P, PL, TC, W};
use super::format::{Args, Format, row};
use super::meet;

pub(super) const SIDES: &[Word] = &[word::LEFT, word::RIGHT];
const AXES: &[Word] = &[word::XAXIS, word::YAXIS];

pub(super) const FORMATS: &[Format] = &[
    row(&[N, N, N, N], four_numbers),
    row(&[N, N, N, N, N, N], six_numbers),
    row(&[P, P], two_points),
    row(&[P, Of(SIDES), W(word::TANTO), C], tangent_line),
    row(&[Of(SIDES), W(word::TANTO), C, Of(SIDES), W(word::TANTO), C], tangent_line),
    row(&[P, W(word::ATANGL), N], at_angle),
    row(&[P, W(word::ATANGL), N, Of(AXES)], at_angle),
    row(&[P, W(word::ATANGL), N, L], at_angle_to_line),
    row(&[P, W(word::SLOPE), N], at_angle),
    row(&[P, W(word::SLOPE), N, Of(AXES)], at_angle),
    row(&[P, W(word::SLOPE), N, L], at_angle_to_line),
    row(&[P, W(word::PARLEL), L], parallel_at),
    row(&[P, W(word::PERPTO), L], perpendicular_at),
    row(&[W(word::PARLEL), L, Of(XY_MODS), N], parallel_by),
    row(&[W(word::INTOF), PL, PL], two_planes),
    row(&[W(word::ATANGL), N, W(word::INTERC), N], intercept),
    row(&[W(word::ATANGL), N, W(word::INTERC), Of(AXES), N], intercept),
    row(&[W(word::SLOPE), N, W(word::INTERC), N], intercept),
    row(&[W(word::SLOPE), N, W(word::INTERC), Of(AXES), N], intercept),
    row(&[P, W(word::TANTO), TC], tangent_to_tabcyl),
    row(&[P, W(word::TANTO), TC, P], tangent_to_tabcyl),
    row(&[P, W(word::PERPTO), TC, P], normal_to_tabcyl),
    row(&[W(word::XAXIS)], x_axis),
    row(&[W(word::YAXIS)], y_axis),
    row(&[L], same),
];

/// The line from `p` to `q`, its normal to the right; `None` when rounding would turn it.
fn through(p: Vec2, q: Vec2) -> Option<Line> {
    let way = q - p;
    let size = p.amax().max(q.amax());
    let length = way.norm();
    (length > 1e-12 * size).then(|| meet::line_at(p, -meet::left(way) / length))
}

/// The unit vector at `degrees` from x, exact at the quarters.
pub(super) fn at_degrees(degrees: f64) -> Vec2 {
    Vec2::new(trig::cos_deg(degrees), trig::sin_deg(degrees))
}

fn four_numbers(a: &Args<'_>) -> Result<Form, Fault> {
    let [x1, y1, x2, y2] = a.numbers(0)?;
    through(Vec2::new(x1, y1), Vec2::new(x2, y2))
        .map(Form::Line)
        .ok_or(Fault::Coincide { a: 1, b: 3 })
}

fn six_numbers(a: &Args<'_>) -> Result<Form, Fault> {
    let [x1, y1, _, x2, y2, _] = a.numbers(0)?;
    through(Vec2::new(x1, y1), Vec2::new(x2, y2))
        .map(Form::Line)
        .ok_or(Fault::Coincide { a: 2, b: 5 })
}

fn two_points(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, q) = (a.point2(0)?, a.point2(1)?);
    through(p, q).map(Form::Line).ok_or(Fault::Coincide { a: 0, b: 1 })
}

/// +1 when the circle lies so that the line touches it on the left.
fn touch(a: &Args<'_>, at: usize) -> f64 {
    if a.is(at, word::LEFT) { 1.0 } else { -1.0 }
}

/// The line that touches two circles (radius 0: goes through a point), each on its side (+1 left) of the
/// way from the first centre to the second. Its normal points to the second centre, or to the first when
/// the second is a point. `Err` holds by how much one circle lies inside the other's reach.
fn common_tangent(c1: Vec2, r1: f64, c2: Vec2, r2: f64, sides: [f64; 2]) -> Result<Line, f64> {
    let between = c2 - c1;
    let distance = between.norm();
    let difference = sides[0] * r1 - sides[1] * r2;
    let size = r1 + r2 + c1.amax().max(c2.amax());
    let lack = difference.abs() - distance;
    if lack > meet::SLACK * size || distance <= 1e-12 * size {
        return Err(lack);
    }
    let u = between / distance;
    let k = (difference / distance).clamp(-1.0, 1.0);
    let n = u * k + meet::left(u) * ((1.0 - k) * (1.0 + k)).sqrt();
    // Both touching points are candidates to carry the line; the one nearer the origin rounds less.
    let (t1, t2) = (c1 + n * (sides[0] * r1), c2 + n * (sides[1] * r2));
    let at = if t1.amax() <= t2.amax() { t1 } else { t2 };
    let inward = if r2 > 0.0 { -sides[1] } else { -sides[0] };
    Ok(meet::line_at(at, n * inward))
}

/// The tangent through a point, or to two circles.
pub(super) fn tangent(a: &Args<'_>) -> Result<Line, Fault> {
    if a.is_point(0) {
        let (p, c) = (a.point2(0)?, a.circle(3)?);
        return common_tangent(p, 0.0, c.center.xy(), c.radius, [1.0, touch(a, 1)]).map_err(
            |amount| Fault::Misplaced {
                at: 0,
                by: 3,
                what: "lies inside",
                amount: amount.max(0.0),
            },
        );
    }
    let (one, other) = (a.circle(2)?, a.circle(5)?);
    let (p, q) = (one.center.xy(), other.center.xy());
    let sides = [touch(a, 0), touch(a, 3)];
    common_tangent(p, one.radius, q, other.radius, sides).map_err(|amount| {
        let what = if sides[0] * sides[1] > 0.0 {
            "has no such tangent, one circle lies inside the other: it is too near to"
        } else {
            "has no such tangent, the circles cut each other: it is too near to"
        };
        Fault::Misplaced { at: 2, by: 5, what, amount: amount.max(0.0) }
    })
}

fn tangent_line(a: &Args<'_>) -> Result<Form, Fault> {
    tangent(a).map(Form::Line)
}

/// The direction that ATANGL or SLOPE at `at` gives, counted from x, or against that from y with YAXIS at `axis`.
fn inclined(a: &Args<'_>, at: usize, axis: usize) -> Result<Vec2, Fault> {
    let value = a.number(at + 1)?;
    let from_x = if a.is(at, word::SLOPE) {
        let along = Vec2::new(1.0, value);
        along / along.norm()
    } else {
        at_degrees(value)
    };
    Ok(if a.is(axis, word::YAXIS) { -meet::left(from_x) } else { from_x })
}

fn at_angle(a: &Args<'_>) -> Result<Form, Fault> {
    let along = inclined(a, 1, 3)?;
    Ok(Form::Line(meet::line_at(a.point2(0)?, meet::left(along))))
}

/// Counted anticlockwise from the given line.
fn at_angle_to_line(a: &Args<'_>) -> Result<Form, Fault> {
    let turn = inclined(a, 1, usize::MAX)?;
    let n = meet::normal(&a.line(3)?);
    let n = Vec2::new(n.x * turn.x - n.y * turn.y, n.x * turn.y + n.y * turn.x);
    Ok(Form::Line(meet::line_at(a.point2(0)?, n)))
}

fn parallel_at(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(Form::Line(meet::line_at(a.point2(0)?, meet::normal(&a.line(2)?))))
}

fn perpendicular_at(a: &Args<'_>) -> Result<Form, Fault> {
    let n = meet::left(meet::normal(&a.line(2)?));
    Ok(Form::Line(meet::line_at(a.point2(0)?, n)))
}

/// A negative distance moves the line to the other side and leaves its normal.
fn parallel_by(a: &Args<'_>) -> Result<Form, Fault> {
    let (l, by) = (a.line(1)?, a.number(3)?);
    let side = a.side2(2, meet::normal(&l))?;
    let l = Line { a: side * l.a + 0.0, b: side * l.b + 0.0, d: side * l.d };
    Ok(Form::Line(meet::offset(&l, by)))
}

/// The vertical plane through the cut of two planes.
fn two_planes(a: &Args<'_>) -> Result<Form, Fault> {
    let (one, other) = (a.plane(1)?, a.plane(2)?);
    let (foot, along) =
        meet::planes(&one, &other).ok_or(Fault::Parallel { a: 1, b: 2, one, other })?;
    let flat = along.xy();
    let length = flat.norm();
    if length <= meet::PARALLEL {
        return Err(Fault::Aligned { a: 1, b: 2, what: "cut in a vertical line, seen as a point" });
    }
    Ok(Form::Line(meet::line_at(foot.xy(), meet::left(flat) / length)))
}

/// The intercept is measured on the y axis, on the x axis with XAXIS; the angle always from x.
fn intercept(a: &Args<'_>) -> Result<Form, Fault> {
    let along = inclined(a, 0, usize::MAX)?;
    let (on_x, value) =
        if a.is_number(3) { (false, a.number(3)?) } else { (a.is(3, word::XAXIS), a.number(4)?) };
    let (p, across) =
        if on_x { (Vec2::new(value, 0.0), along.y) } else { (Vec2::new(0.0, value), along.x) };
    if across.abs() <= meet::PARALLEL {
        let need = if on_x {
            "that leaves the x axis, to have an intercept on it,"
        } else {
            "that leaves the y axis, to have an intercept on it,"
        };
        return Err(Fault::Range { at: 1, value: a.number(1)?, need });
    }
    Ok(Form::Line(meet::line_at(p, meet::left(along))))
}

fn tangent_to_tabcyl(a: &Args<'_>) -> Result<Form, Fault> {
    super::tabcyl::tangent(a, 0, 2, if a.len() > 3 { 3 } else { 0 }).map(Form::Line)
}

fn normal_to_tabcyl(a: &Args<'_>) -> Result<Form, Fault> {
    super::tabcyl::normal(a, 0, 2, 3).map(Form::Line)
}

fn x_axis(_: &Args<'_>) -> Result<Form, Fault> {
    Ok(Form::Line(Line { a: 0.0, b: 1.0, d: 0.0 }))
}

fn y_axis(_: &Args<'_>) -> Result<Form, Fault> {
    Ok(Form::Line(Line { a: 1.0, b: 0.0, d: 0.0 }))
}

fn same(a: &Args<'_>) -> Result<Form, Fault> {
    a.line(0).map(Form::Line)
}
