//! MOVARC and the other words of vendors that are an arc by themselves.

use aptc_geometry::{Circle, Vec3};

use super::arcs::Pending;
use super::comments::unit;
use super::state::State;
use super::words::{unread, wrong};
use super::{args, nx};
use crate::{Arg, Kind};

const MOVARC_FORMS: &str =
    "write MOVARC/x,y,z,i,j,k,r,ANGLE,sweep or MOVARC/CENTER,x,y,z,AXIS,i,j,k,RADIUS,r";

/// Numbers of a couplet statement: those before any word, and those after each word.
struct Couplets {
    list: Vec<Arg>,
}

impl Couplets {
    fn read(rest: &[u8]) -> Self {
        let mut list = Vec::new();
        args::parse(rest, &mut list);
        Self { list }
    }

    /// The numbers that follow the word, or those at the head for the empty word.
    fn after(&self, word: &str) -> Option<Vec<f64>> {
        let start = match word {
            "" => 0,
            _ => self.list.iter().position(|a| matches!(a, Arg::Word(w) if w == word))? + 1,
        };
        let numbers = self.list[start..].iter().map_while(|a| match a {
            Arg::Number(x) => Some(*x).filter(|x| args::is_coordinate(*x)),
            _ => None,
        });
        Some(numbers.collect())
    }

    fn vector(&self, word: &str) -> Option<Vec3> {
        let n = self.after(word)?;
        Some(Vec3::new(*n.first()?, *n.get(1)?, *n.get(2)?))
    }

    /// Three numbers from an argument on.
    fn vector_at(&self, at: usize) -> Option<Vec3> {
        let number = |i: usize| match self.list.get(at + i) {
            Some(Arg::Number(x)) => Some(*x).filter(|x| args::is_coordinate(*x)),
            _ => None,
        };
        Some(Vec3::new(number(0)?, number(1)?, number(2)?))
    }

    fn number(&self, word: &str) -> Option<f64> {
        self.after(word)?.first().copied()
    }
}

/// `MOVARC/x,y,z,i,j,k,r[,ANGLE,sweep]`, or couplets CENTER, AXIS, RADIUS, ANGLE, TIMES; then a GOTO to
/// the end. Right-handed about the axis; a negative angle turns the sense.
pub(super) fn movarc(state: &mut State, text: &[u8], rest: &[u8]) {
    let couplets = Couplets::read(rest);
    let head = couplets.after("").unwrap_or_default();
    let (center, axis, radius) = if let [x, y, z, i, j, k, r, ..] = head.as_slice() {
        (Some(Vec3::new(*x, *y, *z)), Some(Vec3::new(*i, *j, *k)), Some(*r))
    } else {
        (couplets.vector("CENTER"), couplets.vector("AXIS"), couplets.number("RADIUS"))
    };
    let (Some(center), Some(axis)) = (center, axis) else {
        return wrong(state, text, "a MOVARC that cannot be read", MOVARC_FORMS);
    };
    let angle = couplets.number("ANGLE").or_else(|| head.get(7).copied());
    let axis = if angle.is_some_and(|a| a < 0.0) { -axis } else { axis };
    let sweep = angle.map(f64::abs).filter(|a| *a > 0.0);
    let turns = couplets.number("TIMES").filter(|n| (1.0..1e6).contains(n)).unwrap_or(1.0);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 1..1e6")]
    let turns = turns as u32 - 1;
    state.close();
    state.pending = Some(Pending::End { center, axis, radius, turns, sweep });
}

/// `MCSYS/NUM,n,POINT,x,y,z,VECTOR,i,j,k,VECTOR,l,m,n`: the frame by origin, x and y axis; its number
/// stays a post-processor word.
pub(super) fn mcsys(state: &mut State, rest: &[u8]) -> bool {
    let couplets = Couplets::read(rest);
    let mut vectors = couplets
        .list
        .iter()
        .enumerate()
        .filter(|(_, a)| matches!(a, Arg::Word(w) if w == "VECTOR"))
        .map(|(i, _)| couplets.vector_at(i + 1));
    let (Some(o), Some(Some(x)), Some(Some(y))) =
        (couplets.vector("POINT"), vectors.next(), vectors.next())
    else {
        return false;
    };
    let Some(frame) = nx::frame(&[o, x, y].map(|v| [v.x, v.y, v.z]).concat()) else { return false };
    if let Some(n) = couplets.number("NUM") {
        let args = vec![Arg::Word("NUM".into()), Arg::Number(n)];
        state.emit(Kind::Post { word: "MCSYS".into(), args });
    }
    state.emit(Kind::Csys(frame));
    true
}

/// `MCS/i,j,k,l,m,n,o,p,q,x,y,z` of CAMplete: the frame by its three axes and its origin.
pub(super) fn mcs(state: &mut State, rest: &[u8]) -> bool {
    let numbers = args::all_numbers(rest);
    let Some(&[i, j, k, l, m, n, _, _, _, x, y, z]) = numbers.as_ref().map(args::Numbers::get)
    else {
        return false;
    };
    let Some(frame) = nx::frame(&[x, y, z, i, j, k, l, m, n]) else { return false };
    state.emit(Kind::Csys(frame));
    true
}

/// ARC, ARCDAT, ARCMOV, GOCLW, GOCCLW, CW, CCW, HELICAL.
pub(super) fn arc_word(state: &mut State, text: &[u8], word: &str, rest: &[u8]) {
    let couplets = Couplets::read(rest);
    let n = couplets.after("").unwrap_or_default();
    let v = |i: usize| Vec3::new(n[i], n[i + 1], n[i + 2]);
    match (word, n.len()) {
        // Centre, axis, radius; ARCMOV or CONT gives the end.
        ("ARCDAT", 7) => {
            if let Some(axis) = unit(v(3)) {
                state.arcdat = Some(Circle { center: v(0), axis, radius: n[6] });
                return;
            }
        }
        // Sense, end, angle.
        ("ARCMOV", 0) => {
            let (clw, ccw) = (couplets.after("CLW"), couplets.after("CCLW"));
            if let (Some(circle), Some(n)) = (state.arcdat, ccw.as_ref().or(clw.as_ref()))
                && n.len() >= 3
            {
                let axis = if ccw.is_some() { circle.axis } else { -circle.axis };
                let end = Vec3::new(n[0], n[1], n[2]);
                return arc(state, Circle { axis, ..circle }, 0, end);
            }
        }
        // The circle and its end.
        ("ARC", 10) => {
            return arc(state, Circle { center: v(0), axis: v(3), radius: n[6] }, 0, v(7));
        }
        // Centre, axis, radius, end.
        ("GOCLW" | "GOCCLW", 10) => {
            let axis = if word == "GOCLW" { -v(3) } else { v(3) };
            return arc(state, Circle { center: v(0), axis, radius: n[6] }, 0, v(7));
        }
        // Axis, start, centre, end, radius.
        ("CW" | "CCW", 13) => {
            let axis = if word == "CW" { -v(0) } else { v(0) };
            return arc(state, Circle { center: v(6), axis, radius: n[12] }, 0, v(9));
        }
        // Centre, tangent at the start, axis, angle, radius, end; with 17 numbers also full turns.
        ("HELICAL", 14 | 17) => {
            let (center, tangent, end) = (v(0), v(3), v(n.len() - 3));
            if let Some(start) = state.te {
                let ahead = v(6).cross(&(start - center)).dot(&tangent);
                let axis = if ahead < 0.0 { -v(6) } else { v(6) };
                let circle = Circle { center, axis, radius: n[10] };
                let turns = if n.len() == 17 { n[13] } else { turns(&circle, start, end, n[9]) };
                #[expect(clippy::cast_possible_truncation, reason = "clamped")]
                #[expect(clippy::cast_sign_loss, reason = "clamped")]
                return arc(state, circle, turns.clamp(0.0, 1e6) as u32, end);
            }
        }
        _ => {}
    }
    // Alone these are modes of other systems; an arc that is left out would be cut straight.
    if matches!(word, "CW" | "CCW" | "ARC") && n.is_empty() && couplets.list.is_empty() {
        return unread(state, text);
    }
    let help = "give centre, axis, radius and end as numbers";
    wrong(state, text, &format!("{word} that cannot be read"), help);
}

/// Full turns that are in an angle besides the arc from start to end.
fn turns(circle: &Circle, start: Vec3, end: Vec3, angle: f64) -> f64 {
    let Some(axis) = unit(circle.axis) else { return 0.0 };
    let arc = super::arcs::sweep(circle.center, axis, start, end);
    ((angle.abs() - arc) / 360.0).round()
}

fn arc(state: &mut State, circle: Circle, turns: u32, end: Vec3) {
    let Circle { center, axis, radius } = circle;
    state.close();
    state.pending = Some(Pending::End { center, axis, radius: Some(radius), turns, sweep: None });
    state.point(false, end, None);
}
