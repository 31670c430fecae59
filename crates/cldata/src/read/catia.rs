//! CATIA aptsource: the matrix of the header, and arcs as motion along a circle to a line or plane.
//!
//! `INDIRV/` the way at the start, `PSIS/` the plane of the arc if it is not level, then
//! `TLON,GOFWD/(CIRCLE/..),ON,[n,INTOF,](LINE/..)`. The same reads what Creo calls APT format, CATIA V4
//! (CYLNDR and PLANE), ComputerVision (`TANTO` a plane that touches the circle at the end) and NCL.

use aptc_geometry::{Circle, Plane, Transform, Vec3};

use super::arcs::{self, EndPlane, Pending};
use super::comments::unit;
use super::nested::{self, Nested, Part};
use super::state::{Direction, State};
use super::words::{unread, wrong};
use super::{args, nx};
use crate::Kind;

const FORM: &str = "write INDIRV/i,j,k, then TLON,GOFWD/(CIRCLE/x,y,z,r),ON,(LINE/x,y,z,x,y,z)";

/// PSIS/(PLANE/..): the plane of the arcs that follow.
pub(super) fn psis(state: &mut State, text: &[u8], rest: &[u8]) {
    match nested::parts(rest).as_deref() {
        Some([Part::Nested(Nested::Plane(plane))]) => state.psis = Some(*plane),
        _ => unread(state, text),
    }
}

/// TLAXIS/i,j,k: the axis of the positions that follow without one.
pub(super) fn tlaxis(state: &mut State, rest: &[u8]) -> bool {
    let numbers = args::all_numbers(rest);
    let Some(&[i, j, k]) = numbers.as_ref().map(args::Numbers::get) else { return false };
    let Some(axis) = unit(Vec3::new(i, j, k)) else { return false };
    state.close();
    if axis != Vec3::z() || state.axis_seen {
        state.axis(Some(axis));
        state.axis_held = true;
    }
    state.ta = axis;
    true
}

/// A comment of a header: `*CATIA0` and the lines of its matrix. False when it is another comment.
pub(super) fn comment(state: &mut State, text: &[u8]) -> bool {
    let body = text.trim_ascii();
    if body.starts_with(b"*CATIA0") {
        state.matrix = Some(Vec::new());
        return false;
    }
    let Some(rows) = &mut state.matrix else { return false };
    let row: Option<Vec<f64>> = body
        .split(u8::is_ascii_whitespace)
        .filter(|w| !w.is_empty())
        .map(args::coordinate)
        .collect();
    match row {
        Some(row) if row.len() == 4 => rows.extend(row),
        // The name of the operation stands between.
        _ if rows.is_empty() => return false,
        _ => {
            state.matrix = None;
            return false;
        }
    }
    if let Ok(e) = <&[f64; 12]>::try_from(rows.as_slice()) {
        let frame = Transform::from_rows(e);
        state.matrix = None;
        state.emit(Kind::Csys(frame));
    }
    true
}

/// `ORIGIN/x,y,z,i,j,k,l,m,n`: the frame by origin, x and z axis.
pub(super) fn origin(state: &mut State, rest: &[u8]) -> bool {
    let numbers = args::all_numbers(rest);
    let Some(&[x, y, z, i, j, k, l, m, n]) = numbers.as_ref().map(args::Numbers::get) else {
        return false;
    };
    let (x_axis, z_axis) = (Vec3::new(i, j, k), Vec3::new(l, m, n));
    let y_axis = z_axis.cross(&x_axis);
    let frame = [x, y, z, i, j, k, y_axis.x, y_axis.y, y_axis.z];
    let Some(frame) = nx::frame(&frame) else { return false };
    state.emit(Kind::Csys(frame));
    true
}

/// What a circular move is made of.
struct Move {
    center: Vec3,
    axis: Option<Vec3>,
    radius: f64,
    nth: u32,
    tangent: bool,
    until: Nested,
}

/// `(CIRCLE/..),ON|TANTO,[n,INTOF,](LINE/..)`.
fn parse(rest: &[u8]) -> Option<Move> {
    let parts = nested::parts(rest)?;
    let (first, rest) = parts.split_first()?;
    let Part::Nested(Nested::Round(center, axis, radius)) = *first else { return None };
    let (mut nth, mut tangent, mut until) = (1, false, None);
    for (i, part) in rest.iter().enumerate() {
        match part {
            Part::Word(w) if w == "TANTO" || w == "TT" => tangent = true,
            Part::Word(w) if w == "INTOF" => {
                let Some(Part::Number(n)) = i.checked_sub(1).and_then(|i| rest.get(i)) else {
                    return None;
                };
                #[expect(clippy::cast_possible_truncation, reason = "clamped")]
                #[expect(clippy::cast_sign_loss, reason = "clamped")]
                let n = n.clamp(1.0, 1e6) as u32;
                nth = n;
            }
            Part::Nested(n) => until = Some(n.clone()),
            _ => {}
        }
    }
    Some(Move { center, axis, radius: radius.abs(), nth, tangent, until: until? })
}

/// Takes the circular move in.
pub(super) fn circular_move(state: &mut State, text: &[u8], rest: &[u8]) {
    state.in_goto = false;
    let Some(m) = parse(rest) else {
        return wrong(state, text, "a circular move that cannot be read", FORM);
    };
    let (Some(start), Some(direction)) = (state.te, state.direction.take()) else {
        let what = "a circular move without a start or without INDIRV before it";
        return wrong(state, text, what, FORM);
    };
    let ahead = match direction {
        Direction::Along(v) => v,
        Direction::Towards(p) => p - start,
    };
    match solve(state, &m, start, ahead) {
        Some((circle, end, sweep)) => {
            let Circle { center, axis, radius } = circle;
            let sweep = Some(sweep);
            state.close();
            let radius = Some(radius);
            state.pending = Some(Pending::End { center, axis, radius, turns: 0, sweep });
            state.point(false, end, None);
        }
        None => wrong(state, text, "a circular move whose end is not on its circle", FORM),
    }
}

/// Circle with its axis right-handed about the motion, end, angle.
fn solve(state: &State, m: &Move, start: Vec3, ahead: Vec3) -> Option<(Circle, Vec3, f64)> {
    let arm = start - m.center;
    let axis = m.axis.or_else(|| axis(state.psis, m, arm, ahead))?;
    // The motion begins along INDIRV: that decides the sense.
    let axis = if axis.cross(&arm).dot(&ahead) < 0.0 { -axis } else { axis };
    let circle = Circle { center: m.center, axis, radius: m.radius };
    let plane = match &m.until {
        Nested::Line(from, to) => {
            if let Some(found) = to_point(&circle, m.nth, start, *to) {
                return Some(found);
            }
            let n = (to - from).cross(&axis);
            Plane::new(n, n.dot(from))?
        }
        Nested::Plane(p) => *p,
        _ => return None,
    };
    let end = EndPlane { plane, nth: m.nth, tangent: m.tangent };
    let (end, sweep) = arcs::end_on_plane(&circle, start, &end)?;
    Some((circle, end, sweep))
}

/// CAM systems let the line end where the arc does: then that point is the end, digit for digit.
fn to_point(circle: &Circle, nth: u32, start: Vec3, to: Vec3) -> Option<(Circle, Vec3, f64)> {
    if arcs::off_circle(circle, to).abs() > 1e-3 * circle.radius {
        return None;
    }
    // A crossing in the middle comes first when the arc is longer than half a turn.
    let sweep = arcs::sweep(circle.center, circle.axis, start, to);
    let crossings = if sweep > 180.0 { 2 } else { 1 };
    let near_half = (sweep - 180.0).abs() < 0.1;
    (crossings == nth.max(1) || near_half).then_some((*circle, to, sweep))
}

/// Axis of a CIRCLE without one: the normal of PSIS or z, whichever start and way ahead fit; else across the
/// arm and the way ahead. On lathes circles lie in the zx plane, and from their quadrants the start fits z too.
fn axis(psis: Option<Plane>, m: &Move, arm: Vec3, ahead: Vec3) -> Option<Vec3> {
    let fits = |axis: Vec3| {
        let circle = Circle { center: Vec3::zeros(), axis, radius: m.radius };
        arcs::off_circle(&circle, arm).abs() <= 1e-2 * m.radius
            && axis.dot(&ahead).abs() <= 0.5 * ahead.norm()
    };
    psis.map(|p| p.n)
        .filter(|n| fits(*n))
        .or_else(|| Some(Vec3::z()).filter(|z| fits(*z)))
        .or_else(|| unit(arm.cross(&ahead)))
}
