//! Siemens NX CLSF: what differs from ISO 4343.
//!
//! The tool axis is given where it changes and holds until then. `CIRCLE` has eleven numbers and is
//! clockwise about its axis. Splines are `NURBS/`, `KNOT/`, `CNTRL/` lines. `TOOL PATH/`, `PAINT/`,
//! `DISPLY/` say nothing to a machine and are kept as comments.

use aptc_diagnostics::{Severity, codes};
use aptc_geometry::{Cutter, Transform, Vec3};
use nalgebra::Matrix3;

use super::args;
use super::comments::unit;
use super::state::State;
use super::words::wrong;
use crate::{Arg, Kind, Position};

/// Takes a statement of NX in; false when it is not one of its own.
pub(super) fn statement(state: &mut State, text: &[u8], word: &str, rest: &[u8]) -> bool {
    if state.spline.on && !matches!(word, "KNOT" | "CNTRL") {
        end_spline(state);
    }
    match word {
        "PAINT" | "DISPLY" | "TOOLPATH" | "END-OF-PATH" => {
            state.emit(Kind::Comment(format!(" {}", args::text(text)).into()));
        }
        "TLDATA" => {
            state.emit(Kind::Comment(format!(" {}", args::text(text)).into()));
            let mut list = Vec::new();
            args::parse(rest, &mut list);
            if let Some(cutter) = cutter(&list) {
                state.emit(Kind::Cutter(cutter));
            }
        }
        "MSYS" => match args::all_numbers(rest).as_ref().and_then(|n| frame(n.get())) {
            Some(frame) => state.emit(Kind::Csys(frame)),
            None => wrong(state, text, "an MSYS without 9 numbers", "origin, x axis, y axis"),
        },
        "NURBS" => state.spline.on = true,
        "KNOT" | "CNTRL" if state.spline.on => return spline(state, word, rest),
        _ => return false,
    }
    true
}

/// From origin, x axis and y axis.
pub(super) fn frame(n: &[f64]) -> Option<Transform> {
    let &[a, b, c, i, j, k, l, m, o] = n else { return None };
    let (x, y) = (unit(Vec3::new(i, j, k))?, Vec3::new(l, m, o));
    let z = unit(x.cross(&y))?;
    let y = z.cross(&x);
    Some(Transform { linear: Matrix3::from_columns(&[x, y, z]), shift: Vec3::new(a, b, c) })
}

/// MILL: diameter, lower radius, length, taper and tip angle. DRILL: diameter, radius, length, point angle.
fn cutter(list: &[Arg]) -> Option<Cutter> {
    let n: Vec<f64> = list
        .iter()
        .filter_map(|a| match a {
            Arg::Number(x) => Some(*x),
            _ => None,
        })
        .collect();
    let is = |i: usize, w: &str| matches!(list.get(i), Some(Arg::Word(x)) if x == w);
    if is(0, "DRILL") {
        let (d, length, point) = (*n.first()?, *n.get(2)?, *n.get(3)?);
        let alpha = (90.0 - point / 2.0).clamp(0.0, 89.0);
        return Some(tool(d, 0.0, alpha, 0.0, length));
    }
    if !is(0, "MILL") || n.len() < 5 {
        return None;
    }
    Some(tool(n[0], n[1], n[4].clamp(0.0, 89.0), n[3].clamp(-89.0, 89.0), n[2]))
}

/// The seven numbers: the corner circle touches the lower and the upper line.
pub(super) fn tool(d: f64, r: f64, alpha_deg: f64, beta_deg: f64, height: f64) -> Cutter {
    let mut cutter =
        Cutter { diameter: d, corner_radius: r, e: 0.0, f: 0.0, alpha_deg, beta_deg, height };
    [cutter.e, cutter.f] = cutter.tangent_corner().unwrap_or([d / 2.0 - r, r]);
    cutter
}

fn spline(state: &mut State, word: &str, rest: &[u8]) -> bool {
    let Some(numbers) = args::all_numbers(rest) else { return false };
    let n = numbers.get();
    // A spline longer than this is no tool path; what follows it is read as statements.
    if state.spline.knots.len() + state.spline.points.len() > 1_000_000 {
        return false;
    }
    match (word, n) {
        ("KNOT", knots) => state.spline.knots.extend_from_slice(knots),
        (_, [x, y, z, ..]) => state.spline.points.push(Vec3::new(*x, *y, *z)),
        _ => return false,
    }
    true
}

/// The spline that was read, as chords within the tolerance stated, or else 5 micrometres.
pub(super) fn end_spline(state: &mut State) {
    let spline = std::mem::take(&mut state.spline);
    let stated = state.intol + state.outtol;
    let tolerance =
        if stated > 0.0 { stated } else { 0.005 / state.units.unwrap_or_default().mm() };
    let chords = state.te.and_then(|start| spline.chords(start, tolerance));
    let points = chords.unwrap_or_else(|| {
        let what =
            "a spline whose knots and control points do not fit; its control points are taken";
        state.report.note(state.at, codes::CL_VALUE, Severity::Warning, what);
        spline.points
    });
    let (ta, with_axis) = state.axis(None);
    state.close();
    state.run(points.into_iter().map(|te| Position { te, ta }).collect(), with_axis);
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::trig;

    #[test]
    fn tools_touch_their_lines() {
        let flat = tool(20.0, 3.0, 0.0, 0.0, 50.0);
        assert_eq!((flat.e, flat.f), (7.0, 3.0));
        let cone = tool(10.0, 0.0, 45.0, 0.0, 50.0);
        assert!((cone.e - 5.0).abs() < 1e-12 && (cone.f - 5.0).abs() < 1e-12);
        let t = tool(10.0, 1.0, 20.0, 5.0, 50.0);
        let (sa, ca) = (trig::sin_deg(20.0), trig::cos_deg(20.0));
        let (sb, cb) = (trig::sin_deg(5.0), trig::cos_deg(5.0));
        assert!((-sa * t.e + ca * t.f - 1.0).abs() < 1e-12);
        assert!((cb * (5.0 - t.e) + sb * (t.f - 5.0 * sa / ca) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn frames_are_right_handed() {
        let f = frame(&[1.0, 2.0, 3.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0]).unwrap();
        assert_eq!(f.point(Vec3::new(1.0, 0.0, 5.0)), Vec3::new(1.0, 3.0, 8.0));
        assert!(frame(&[0.0; 9]).is_none());
    }
}
