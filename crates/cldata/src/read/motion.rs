//! Words that move the tool, and those that say on which way: FROM, GOTO, GODLTA, INDIRV, CIRCLE.

use aptc_diagnostics::{Severity, codes};
use aptc_geometry::{Circle, Vec3};

use super::arcs::Pending;
use super::args::{self, Numbers};
use super::comments::unit;
use super::state::{Direction, State};
use super::words::{list, post, unread, wrong};
use super::{fusion, nx};
use crate::{Arg, Dialect};

pub(super) fn motion(state: &mut State, text: &[u8], rest: &[u8], from: bool) {
    // `GOTO/1,2,` had a third coordinate, which is not 0 because it is lost.
    let lost = rest.trim_ascii_end().ends_with(b",");
    match args::all_numbers(rest) {
        Some(numbers) if numbers.get().len() >= 2 + usize::from(lost) => {
            goto(state, numbers.get(), from);
        }
        _ => {
            // A feed rate or a word may follow the numbers.
            let numbers = leading_numbers(rest);
            if numbers.get().len() >= 3 {
                let what = "words after the coordinates of a motion; they are left out";
                state.report.note(state.at, codes::CL_VALUE, Severity::Warning, what);
                return goto(state, numbers.get(), from);
            }
            state.pending = None;
            wrong(state, text, "a motion whose coordinates cannot be read", COORDINATES);
        }
    }
}

/// x,y,z or x,y,z,i,j,k; further numbers (contact points and the like) are left out.
pub(super) fn goto(state: &mut State, n: &[f64], from: bool) {
    let (te, axis) = match n {
        [x, y] => {
            let what = "a motion with two coordinates; z is taken as 0";
            state.report.note(state.at, codes::CL_VALUE, Severity::Warning, what);
            (Vec3::new(*x, *y, 0.0), None)
        }
        [x, y, z] => (Vec3::new(*x, *y, *z), None),
        [x, y, z, i, j, k] => (Vec3::new(*x, *y, *z), Some(Vec3::new(*i, *j, *k))),
        [x, y, z, rest @ ..] => {
            let what = "a motion with 4, 5 or more than 6 numbers; the first 3 or 6 are taken";
            state.report.note(state.at, codes::CL_VALUE, Severity::Warning, what);
            let axis = rest.get(..3).map(|a| Vec3::new(a[0], a[1], a[2]));
            (Vec3::new(*x, *y, *z), axis)
        }
        _ => return,
    };
    if state.spline.on {
        nx::end_spline(state);
    }
    let te = if state.bottoms.is_some() { fusion::top(state, te, axis) } else { te };
    state.point(from, te, axis);
}

pub(super) fn godlta(state: &mut State, text: &[u8], rest: &[u8]) {
    let numbers = args::all_numbers(rest);
    if (state.subprogram.is_some() || state.called) && numbers.is_some() {
        return post(state, &"GODLTA".into(), rest);
    }
    let Some(te) = state.te else {
        return wrong(state, text, "GODLTA before the tool has a position", "begin with FROM");
    };
    match numbers.as_ref().map(Numbers::get) {
        Some([d]) => {
            let ta = state.ta;
            state.point(false, te + ta * *d, None);
        }
        Some([x, y, z]) => state.point(false, te + Vec3::new(*x, *y, *z), None),
        Some([x, y, z, i, j, k]) => {
            let axis = Vec3::new(*i, *j, *k);
            state.point(false, te + Vec3::new(*x, *y, *z), Some(axis));
        }
        _ => wrong(state, text, "GODLTA without 1, 3 or 6 numbers", "write GODLTA/dx,dy,dz"),
    }
}

pub(super) fn indir(state: &mut State, text: &[u8], word: &str, rest: &[u8]) {
    let numbers = args::all_numbers(rest);
    let Some(&[x, y, z]) = numbers.as_ref().map(Numbers::get) else {
        return unread(state, text);
    };
    let v = Vec3::new(x, y, z);
    let along = word == "INDIRV";
    state.direction = Some(if along { Direction::Along(v) } else { Direction::Towards(v) });
}

/// CIRCLE before the points of an arc. 4 numbers: centre and radius in the xy plane; 6: centre and axis
/// (CAMWorks); 7: centre, axis, radius, then points or the end; 11: NX, clockwise about the axis.
pub(super) fn circle(state: &mut State, text: &[u8], rest: &[u8]) {
    let (mut numbers, mut turns) = (leading_numbers(rest), 0);
    let words = list(rest);
    if let [.., Arg::Word(w), Arg::Number(n)] = words.as_slice() {
        if w != "TIMES" || !(*n >= 1.0 && *n < 1e6) {
            numbers = args::all_numbers(b"").expect("nothing is all numbers");
        } else {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
            let n = *n as u32;
            turns = n - 1;
        }
    }
    let n = numbers.get();
    let v = |i: usize| Vec3::new(n[i], n[i + 1], n[i + 2]);
    state.close();
    state.pending = match n.len() {
        4 => Some(points(v(0), Vec3::z(), n[3])),
        6 => Some(Pending::End { center: v(0), axis: v(3), radius: None, turns, sweep: None }),
        7 if state.dialect == Dialect::Camworks || turns > 0 => {
            let radius = Some(n[6]);
            Some(Pending::End { center: v(0), axis: v(3), radius, turns, sweep: None })
        }
        7 => unit(v(3)).map(|axis| points(v(0), axis, n[6])),
        11 => {
            let radius = Some(n[6]);
            Some(Pending::End { center: v(0), axis: -v(3), radius, turns, sweep: None })
        }
        _ => None,
    };
    if state.pending.is_none() {
        let help = "a circle has 4, 6, 7 or 11 numbers: centre, axis, radius";
        wrong(state, text, "a circle that cannot be read", help);
    }
}

/// An arc of the tool end whose points come next.
pub(super) fn points(center: Vec3, axis: Vec3, radius: f64) -> Pending {
    Pending::Points { circle: Circle { center, axis, radius }, to_mark: false }
}

/// Numbers up to the first field that is none.
fn leading_numbers(rest: &[u8]) -> Numbers {
    let end = args::fields(rest)
        .take_while(|f| args::coordinate(f).is_some())
        .fold(0, |at, f| at + f.len() + 1);
    args::all_numbers(&rest[..end.min(rest.len())])
        .or_else(|| args::all_numbers(b""))
        .expect("nothing is all numbers")
}

/// What to write for a motion.
pub(super) const COORDINATES: &str = "write GOTO/x,y,z or GOTO/x,y,z,i,j,k with numbers";
