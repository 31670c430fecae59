//! INDEX, COPY and TRACUT, which Section 3 carries out.

use aptc_geometry::{Transform, Vec3};
use smol_str::SmolStr;

use super::args;
use super::state::State;
use super::words::{list, post};
use crate::{Arg, Edit, Kind};

pub(super) fn index(state: &mut State, word: &SmolStr, rest: &[u8]) {
    match list(rest).as_slice() {
        [Arg::Number(n)] => state.emit(Kind::Edit(Edit::Index { n: *n, close: false })),
        [Arg::Number(n), Arg::Word(w)] if w == "NOMORE" => {
            state.emit(Kind::Edit(Edit::Index { n: *n, close: true }));
        }
        _ => post(state, word, rest),
    }
}

pub(super) fn copy(state: &mut State, word: &SmolStr, rest: &[u8]) {
    let list = list(rest);
    let copy = || {
        let (Arg::Number(n), Arg::Word(how), Arg::Number(count)) =
            (list.first()?, list.get(1)?, list.last()?)
        else {
            return None;
        };
        let middle = list.get(2..list.len() - 1)?;
        let turn = |axis| match middle {
            [Arg::Number(angle)] => Some(Transform::rotation(axis, *angle)),
            _ => None,
        };
        let step = match how.as_str() {
            "SAME" if middle.is_empty() => Transform::identity(),
            "TRANSL" => match middle {
                [Arg::Number(x), Arg::Number(y), Arg::Number(z)] => {
                    Transform::translation(Vec3::new(*x, *y, *z))
                }
                _ => return None,
            },
            "XYROT" => turn(Vec3::z())?,
            "YZROT" => turn(Vec3::x())?,
            "ZXROT" => turn(Vec3::y())?,
            "MODIFY" => matrix(middle)?,
            _ => return None,
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
        let count = (*count >= 0.0 && *count <= 1e9).then_some(*count as u32)?;
        Some(Edit::Copy { n: *n, step, count })
    };
    match copy() {
        Some(edit) => state.emit(Kind::Edit(edit)),
        None => post(state, word, rest),
    }
}

pub(super) fn tracut(state: &mut State, word: &SmolStr, rest: &[u8]) {
    let list = list(rest);
    match list.as_slice() {
        [Arg::Word(w)] if w == "NOMORE" => state.emit(Kind::Edit(Edit::Tracut(None))),
        other => match matrix(other) {
            Some(m) => state.emit(Kind::Edit(Edit::Tracut(Some(m)))),
            None => post(state, word, rest),
        },
    }
}

/// Twelve numbers, or name and subscript before them.
pub(super) fn matrix(list: &[Arg]) -> Option<Transform> {
    let tail = match list.len() {
        12 => list,
        14 => &list[2..],
        _ => return None,
    };
    let mut e = [0.0; 12];
    for (value, arg) in e.iter_mut().zip(tail) {
        let Arg::Number(x) = arg else { return None };
        *value = Some(*x).filter(|x| args::is_coordinate(*x))?;
    }
    Some(Transform::from_rows(&e))
}
