//! Comments that carry meaning in every dialect.

use std::sync::Arc as Shared;

use aptc_geometry::{Circle, Vec3};
use smol_str::SmolStr;

use super::arcs::Pending;
use super::args;
use super::state::{Mark, State};
use crate::{Kind, MotionKind, NameRef, restore};

/// Takes a comment in: a mark of our own text, or one worth keeping.
pub(super) fn comment(state: &mut State, text: &[u8]) {
    if !mark(state, text) {
        let text = args::text(text);
        let kept = text.strip_prefix('.').filter(|t| crate::text::is_reserved(t));
        state.emit(Kind::Comment(kept.unwrap_or(&text).trim_end().into()));
    }
}

/// Is it a mark? Then it is taken in.
fn mark(state: &mut State, text: &[u8]) -> bool {
    let body = text.trim_ascii_start();
    let end = body.iter().position(|b| !b.is_ascii_alphabetic()).unwrap_or(body.len());
    let (word, rest) = body.split_at(end);
    if word.eq_ignore_ascii_case(b"LINE") || word.eq_ignore_ascii_case(b"ISN") {
        return line(state, word.len() == 3, rest);
    }
    if word.eq_ignore_ascii_case(b"PATH") {
        return path(state, rest);
    }
    if word.eq_ignore_ascii_case(b"CIRCLE") {
        return circle(state, rest);
    }
    if word.eq_ignore_ascii_case(b"GEOMETRY") {
        return geometry(state, rest);
    }
    false
}

/// `n`, `= n`, `n FILE name`.
pub(super) fn line(state: &mut State, isn: bool, rest: &[u8]) -> bool {
    let mut at = 0;
    while matches!(rest.get(at), Some(b' ' | b'\t' | b':' | b'=')) {
        at += 1;
    }
    let first = at;
    let mut n = 0_u32;
    while let Some(d) = rest.get(at).map(|b| b.wrapping_sub(b'0')).filter(|d| *d < 10) {
        n = n.saturating_mul(10).saturating_add(u32::from(d));
        at += 1;
    }
    if at == first || at == 0 {
        return false;
    }
    let tail = rest[at..].trim_ascii();
    let mut mark = Mark { isn: 0, line: n, file: None };
    if isn {
        mark = Mark { isn: n, line: n, file: None };
    }
    if !tail.is_empty() {
        let Some(name) = tail.strip_prefix(b"FILE ") else { return false };
        mark.file = Some(Shared::from(args::text(name.trim_ascii())));
    }
    state.set_mark(mark);
    true
}

/// `KIND name(i)`.
fn path(state: &mut State, rest: &[u8]) -> bool {
    let mut words = rest.split(|b| b.is_ascii_whitespace()).filter(|w| !w.is_empty());
    let Some(kind) = words.next() else { return false };
    let kinds = [MotionKind::From, MotionKind::Goto, MotionKind::Startup, MotionKind::Continuous];
    let Some(kind) = kinds
        .into_iter()
        .find(|k| crate::text::kind_word(*k).as_bytes().eq_ignore_ascii_case(kind))
    else {
        return false;
    };
    let name = words.next().map_or_else(NameRef::default, |w| name_ref(&args::text(w)));
    state.close();
    state.path = Some((kind, name));
    true
}

/// `L1` or `L1(3)`.
pub(super) fn name_ref(text: &str) -> NameRef {
    let (name, subscript) = text.split_once('(').unwrap_or((text, ""));
    let subscript = subscript.trim_end_matches(')').parse().unwrap_or(0);
    NameRef { name: SmolStr::new(name), subscript }
}

/// `x,y,z,i,j,k,r`, with or without a slash before it.
fn circle(state: &mut State, rest: &[u8]) -> bool {
    let rest = rest.trim_ascii_start();
    let rest = rest.strip_prefix(b"/").unwrap_or(rest);
    let Some(numbers) = args::all_numbers(rest) else { return false };
    let Ok(&[x, y, z, i, j, k, r]) = <&[f64; 7]>::try_from(numbers.get()) else { return false };
    let Some(axis) = unit(Vec3::new(i, j, k)) else { return false };
    state.close();
    let circle = Circle { center: Vec3::new(x, y, z), axis, radius: r };
    state.pending = Some(Pending::Points { circle, to_mark: true });
    true
}

/// A unit vector as it is, another one normalised.
pub(crate) fn unit(v: Vec3) -> Option<Vec3> {
    let norm = v.norm();
    if (norm - 1.0).abs() <= 1e-5 {
        return Some(v);
    }
    (norm > 0.0 && norm.is_finite()).then(|| v / norm)
}

/// `n KIND count ..`.
fn geometry(state: &mut State, rest: &[u8]) -> bool {
    let text = args::text(rest);
    let mut words = text.split_whitespace();
    let mut list = Vec::new();
    while let Some(index) = words.next() {
        let (Ok(index), Some(kind)) = (index.parse(), words.next().and_then(restore::kind_of))
        else {
            return false;
        };
        let Some(count) = words.next().and_then(|w| w.parse().ok()) else { return false };
        list.push((index, kind, count));
    }
    if list.is_empty() {
        return false;
    }
    state.close();
    state.geometry = list;
    true
}
