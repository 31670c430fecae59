//! Faces of STEP: the box of a surface's parameters that a face's edges leave.

use aptc_geometry::Vec3;
use ruststep::ast::Parameter;

use super::curves::{edge, flag, single};
use super::forms::Form;
use super::{Entities, list, reference};
use crate::border::{Border, boxed};

/// A face, with its surface.
pub(super) struct Face {
    pub(super) id: u64,
    pub(super) surface: u64,
    /// Does its normal have the surface's sense?
    along: bool,
    bounds: Vec<u64>,
}

impl Line {
    /// A line in the parameters that comes back to its beginning there.
    pub(crate) fn of(places: Vec<[f64; 2]>) -> Self {
        Self { places, rounds: [0.0; 2] }
    }
}

/// The faces of a file, by their numbers.
pub(super) fn faces(entities: &Entities<'_>) -> Vec<Face> {
    let of = |(id, records): (&u64, &&[ruststep::ast::Record])| {
        let all = ["ADVANCED_FACE", "FACE_SURFACE"].iter().find_map(|n| super::of(records, n))?;
        let bounds = list(all.get(1)?).unwrap_or_default().iter().filter_map(reference).collect();
        let along = flag(all.get(3)?)?;
        Some(Face { id: *id, surface: reference(all.get(2)?)?, along, bounds })
    };
    entities.iter().filter_map(of).collect()
}

/// A border followed on the surface.
pub(crate) struct Line {
    places: Vec<[f64; 2]>,
    /// How often each parameter came round.
    rounds: [f64; 2],
}

/// The box of a face in the parameters of its surface; `None` where its edges do not tell.
pub(super) fn border(entities: &Entities<'_>, face: &Face, form: &Form) -> Option<Border> {
    let mut lines = Vec::new();
    for bound in &face.bounds {
        let name = ["FACE_OUTER_BOUND", "FACE_BOUND"];
        let all = name.iter().find_map(|n| single(entities, *bound, n))?;
        let id = reference(all.get(1)?)?;
        // A single vertex bounds nothing.
        if single(entities, id, "VERTEX_LOOP").is_some() {
            continue;
        }
        let edges = list(single(entities, id, "EDGE_LOOP")?.get(1)?)?;
        let mut line = follow(entities, edges, form)?;
        if !flag(all.get(2)?)? {
            line.rounds = line.rounds.map(|r| -r);
        }
        lines.push(line);
    }
    bounded(&lines, form, face.along)
}

/// The box within closed lines on a surface; `along`: is the face on their left, seen against the surface's normal? None where
/// the lines do not tell. No line at all is all of a surface that has no border.
pub(crate) fn bounded(lines: &[Line], form: &Form, along: bool) -> Option<Border> {
    let periods = form.periods();
    let mut around = [None; 2];
    if lines.is_empty() {
        // All of a surface that has no border.
        for k in 0..2 {
            around[k] = match (periods[k], form.ends(k)) {
                (_, [Some(from), Some(to)]) => Some([from, to]),
                (Some(period), _) => Some([0.0, period]),
                _ => return None,
            };
        }
        return Some(Border { range: [around[0]?, around[1]?], whole: true });
    }
    for k in 0..2 {
        let Some(period) = periods[k] else { continue };
        let Some(line) = lines.iter().find(|l| l.rounds[k] != 0.0) else { continue };
        let start = line.places.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min);
        let start = form.ends(k)[0].unwrap_or(start);
        around[k] = Some([start, start + period]);
    }
    let places: Vec<_> = lines.iter().map(|l| l.places.clone()).collect();
    let found = boxed(&places, around);
    if found.is_some() || lines.len() != 1 {
        return found;
    }
    // A single line round a surface that ends in a point: the face is on its left, seen against its normal.
    let k = (0..2).find(|k| lines[0].rounds[*k] != 0.0)?;
    let other = 1 - k;
    let left = lines[0].rounds[k] * if k == 0 { 1.0 } else { -1.0 };
    let left = if along { left } else { -left };
    let at = lines[0].places[0][other];
    let end = match form.ends(other) {
        [Some(low), Some(high)] if left > 0.0 => high.max(low),
        [Some(low), Some(high)] => low.min(high),
        [low, high] => low.or(high)?,
    };
    let mut range = [[0.0; 2]; 2];
    range[k] = around[k]?;
    range[other] = [at.min(end), at.max(end)];
    Some(Border { range, whole: true })
}

/// The parameters along the edges of a loop.
fn follow(entities: &Entities<'_>, edges: &[Parameter], form: &Form) -> Option<Line> {
    let all = edges.iter().map(|e| edge(entities, e)).collect::<Option<Vec<_>>>()?;
    followed(&all, form)
}

/// The parameters along curves that go on where the one before ends, each parameter that comes round going on from the place
/// before.
pub(crate) fn followed(curves: &[Vec<Vec3>], form: &Form) -> Option<Line> {
    let periods = form.periods();
    let mut places: Vec<[f64; 2]> = Vec::new();
    // The first place behind a pole or tip, where a parameter may have jumped.
    let mut jump: [Option<usize>; 2] = [None; 2];
    for curve in curves {
        for &p in curve {
            let own = form.parameters(p);
            let last = places.last().copied();
            for k in 0..2 {
                if own[k].is_none() {
                    jump[k] = jump[k].or(Some(places.len() + usize::from(last.is_some())));
                }
            }
            let place = |k: usize| match (own[k], last, periods[k]) {
                (None, last, _) => last.map(|l| l[k]),
                (Some(x), Some(last), Some(period)) => {
                    Some(x + period * ((last[k] - x) / period).round())
                }
                (x, ..) => x,
            };
            if let (Some(u), Some(v)) = (place(0), place(1)) {
                places.push([u, v]);
            }
        }
    }
    let (first, last) = (*places.first()?, *places.last()?);
    let mut rounds = [0.0; 2];
    for k in 0..2 {
        let Some(period) = periods[k] else { continue };
        let n = ((last[k] - first[k]) / period).round();
        match jump[k] {
            // Through the pole it may have come to the other side of the same place.
            Some(from) => places.iter_mut().skip(from.max(1)).for_each(|p| p[k] -= n * period),
            None => rounds[k] = n,
        }
        // Lies it beyond the range that the surface has, it is the same place one round before.
        if let [Some(low), _] = form.ends(k) {
            let ends = places
                .iter()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |r, p| [r[0].min(p[k]), r[1].max(p[k])]);
            let shift = ((0.5 * (ends[0] + ends[1]) - low) / period).floor() * period;
            places.iter_mut().for_each(|p| p[k] -= shift);
        }
    }
    Some(Line { places, rounds })
}
