//! Fusion, HSMWorks and Inventor CAM in their common APT form: what differs from ISO 4343.
//!
//! `CYCLE/KIND, depth, [INCR, step,] unit, feed, clearance[, RAPTO, r]` gives the clearance height as a
//! coordinate and `r` down from it to where the feed begins, both along the tool axis, and each GOTO under it
//! is the **bottom** of a hole. Elsewhere in APT the point is the top and heights count from there; so the
//! points are moved up by the depth and the cycle is said again in words, `DEPTH`, `CLEAR` and `RTRCTO`.

use aptc_diagnostics::{Severity, codes};
use aptc_geometry::Vec3;
use smol_str::SmolStr;

use super::args;
use super::report::Place;
use super::state::State;
use crate::{Arg, Kind};

/// A cycle whose points are bottoms.
#[derive(Clone, Debug)]
pub(super) struct Cycle {
    /// Its statement.
    at: Place,
    kind: SmolStr,
    depth: f64,
    /// Heights of the clearance and of the beginning of the feed, coordinates along the tool axis.
    clearance: f64,
    retract: f64,
    /// What stands as it is between the depth and the heights, and behind them.
    middle: Vec<Arg>,
    tail: Vec<Arg>,
    /// The heights above the top under which it was said last.
    said: Option<[f64; 2]>,
}

/// What Fusion writes, for whom it is to be written otherwise.
const FORM: &str = "write CYCLE/kind,depth[,INCR,step],MMPM|IPM|MMPR|IPR,feed,clearance[,RAPTO,r]";

/// Takes a CYCLE in; false when it has the words of other systems.
///
/// A number behind the kind is Fusion's depth. Anything unknown behind it is an error: taken as it stands, the
/// point would be the top of the hole and the hole as deep again.
pub(super) fn cycle(state: &mut State, rest: &[u8]) -> bool {
    let mut list = Vec::new();
    args::parse(rest, &mut list);
    let before = state.bottoms.take();
    match list.as_slice() {
        [Arg::Word(w), ..] if matches!(w.as_str(), "OFF" | "NOMORE") => {
            state.bottoms_off = before.or(state.bottoms_off.take());
            false
        }
        [Arg::Word(w), more @ ..] if w == "ON" => {
            let Some(cycle) = before.or(state.bottoms_off.take()) else { return false };
            state.close();
            if more.is_empty() {
                state.bottoms = Some(Cycle { at: state.at, said: None, ..cycle });
            } else {
                let what = "CYCLE/ON with values behind a cycle whose points are bottoms of holes";
                refused(state, what);
            }
            true
        }
        [Arg::Word(kind), Arg::Number(depth), rest @ ..] => {
            state.close();
            state.bottoms_off = None;
            match read(state, kind, *depth, rest) {
                Ok(cycle) => state.bottoms = Some(cycle),
                Err(what) => refused(state, &format!("CYCLE/{kind}: {what}")),
            }
            true
        }
        _ => {
            state.bottoms_off = None;
            false
        }
    }
}

/// A cycle that is not understood: the holes under it are not drilled as those before.
fn refused(state: &mut State, what: &str) {
    state.report.error(state.at, what, FORM);
    state.emit(Kind::Post { word: "CYCLE".into(), args: vec![Arg::Word("OFF".into())] });
}

/// The cycle, or what is not understood in it.
fn read(state: &mut State, kind: &SmolStr, depth: f64, rest: &[Arg]) -> Result<Cycle, String> {
    let (mut middle, mut tail) = (Vec::new(), Vec::new());
    let (mut clearance, mut rapto, mut shift, mut orient) = (None, None, false, None);
    let mut had = Vec::new();
    let mut rest = rest.iter();
    while let Some(arg) = rest.next() {
        match arg {
            Arg::Number(n) if clearance.is_none() => clearance = Some(*n),
            Arg::Number(_) if !shift => {
                shift = true;
                tail.push(arg.clone());
            }
            Arg::Number(n) => return Err(format!("{n} has no meaning behind the clearance")),
            Arg::Word(w) => {
                let Some(Arg::Number(n)) = rest.next() else {
                    return Err(format!("no number behind {w}"));
                };
                let pair = |w: &str| [Arg::Word(w.into()), Arg::Number(*n)];
                let place = match w.as_str() {
                    "MMPM" | "IPM" | "MMPR" | "IPR" => "a feed",
                    w => w,
                };
                if had.contains(&place) {
                    return Err(format!("{place} stands twice"));
                }
                had.push(place);
                match w.as_str() {
                    "INCR" => middle.extend(pair("STEP")),
                    "MMPM" | "IPM" | "MMPR" | "IPR" => middle.extend(pair(w)),
                    "RAPTO" => rapto = Some(*n),
                    "ORIENT" => orient = Some(pair(w)),
                    "DWELL" => tail.extend(pair(w)),
                    _ => return Err(format!("{w} is not known behind its depth")),
                }
            }
            Arg::Text(_) | Arg::Form { .. } => {
                return Err("it has numbers and words alone".into());
            }
        }
    }
    if shift && orient.is_none() {
        return Err("a number behind the clearance, and no ORIENT to shift the spindle in".into());
    }
    if let Some(orient) = orient {
        // ORIENT,0 stands behind every BORE; without a shift nothing depends on it.
        if shift || orient[1] != Arg::Number(0.0) {
            tail.extend(orient);
        } else {
            let what = "ORIENT,0 without a shift: the spindle is not oriented, it is left out";
            state.report.note(state.at, codes::CL_VALUE, Severity::Note, what);
        }
    }
    let clearance = clearance.ok_or("no clearance")?;
    let retract = clearance - rapto.unwrap_or(0.0);
    let (kind, depth, at) = (kind.clone(), depth.abs(), state.at);
    Ok(Cycle { at, kind, depth, clearance, retract, middle, tail, said: None })
}

/// The top of the hole with this bottom; the cycle is said when its heights above the top are others than before.
pub(super) fn top(state: &mut State, bottom: Vec3, axis: Option<Vec3>) -> Vec3 {
    let Some(mut cycle) = state.bottoms.take() else { return bottom };
    let (ta, _) = state.axis(axis);
    let top = bottom + ta * cycle.depth;
    // Six decimals are written; what is finer comes from the difference.
    let height = |z: f64| ((z - ta.dot(&top)) * 1e7).round() / 1e7;
    let heights = [cycle.retract, cycle.clearance].map(height);
    if cycle.said != Some(heights) {
        let pair = |w: &str, n: f64| [Arg::Word(w.into()), Arg::Number(n)];
        let mut args = vec![Arg::Word(cycle.kind.clone())];
        args.extend(pair("DEPTH", cycle.depth));
        args.extend_from_slice(&cycle.middle);
        args.extend(pair("CLEAR", heights[0]));
        args.extend(pair("RTRCTO", heights[1]));
        args.extend_from_slice(&cycle.tail);
        let here = std::mem::replace(&mut state.at, cycle.at);
        state.emit(Kind::Post { word: "CYCLE".into(), args });
        state.at = here;
        cycle.said = Some(heights);
    }
    state.bottoms = Some(cycle);
    top
}
