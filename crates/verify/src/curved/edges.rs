//! That a tool is nowhere too deep at hollow edges: where faces are moved back they part, and a sharp tool would pass between.
//!
//! With the unit normals m and n of both faces at a place e of the edge, what is as deep as it may be is on the arc
//! `e + d u` between `e + d m` and `e + d n`, which closes the gap between faces moved back by d. So the edge counts as a face of its own
//! that has all normals in between, and is moved as the others are. The arcs that end at one corner leave a hole on the sphere of radius d
//! about it: a corner of four faces counts as one that has all normals between theirs.

use arrayvec::ArrayVec;

use super::Curved;
use crate::search::{Aim, Clearance, Moved, clearance};
use crate::sheet::{Hollow, Patch, Tabcyl};
use crate::sweep::Sweep;
use crate::tool::{Pose, Tool};

/// Edges that are looked at in one search.
const AT_ONCE: usize = 32;

/// What a gap is held above, and by what.
#[derive(Debug)]
pub(super) struct Held {
    pub(super) least: f64,
    /// How much farther back the surface is moved, from which the tool then stays away by as much.
    pub(super) thin: f64,
    /// The hollow edges that the tool may come to.
    pub(super) edges: Option<Near>,
}

/// Hollow edges about a way: those that are no farther than this from the tool at its start.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    start: Pose,
    side: f64,
    away: f64,
}

impl Curved<'_> {
    /// How the gap is held above `least` on a way.
    ///
    /// Where the border of an edge is not known, as of loose patches, of faces that do not quite meet and at tips, the tool stays away
    /// from the faces all over: what is held is less deep then than it may be. So does it where a TABCYL turns back on itself.
    pub(super) fn held(
        &self,
        tool: &Tool<'_>,
        [start, end]: [&Pose; 2],
        turn: f64,
        side: f64,
        least: f64,
        pad: f64,
    ) -> Held {
        /// How far back, in depths that the tool may have.
        const BACK: f64 = 8.0;
        /// Sine of half the angle by which a corner turns that has no middle between its normals.
        const CUSP: f64 = 0.999;
        let thin = if tool.is_thin() { self.back(least, pad) } else { 0.0 };
        let faces = |least: f64, thin: f64| Held { least, thin, edges: None };
        let corners = self.sheet.curve().map(Tabcyl::sharpest).filter(|half| *half > 0.0);
        if self.sheet.edged().is_none() && corners.is_none() {
            return faces(least, thin);
        }
        let away = (end.te - start.te).norm() + turn * tool.reach() - BACK * least + thin;
        let near = Near { start: *start, side, away };
        let rolled = corners.is_some_and(|half| half <= CUSP);
        if least >= 0.0 {
            // Moved out, faces part where they are hollow seen from the other side.
            let beyond = Near { side: -side, ..near };
            return match rolled && thin <= 0.0 {
                true => Held { least, thin, edges: Some(beyond) },
                false => faces(least, thin.max(least)),
            };
        }
        let of_edges = || {
            self.hollow(tool, near).fold((0.0_f64, true, 0.0_f64), |(m, known, crack), h| {
                (m.max(h.half), known && h.rolled.is_some(), crack.max(h.crack))
            })
        };
        let (half, known, crack) = corners.map_or_else(of_edges, |half| (half, rolled, 0.0));
        if half <= 0.0 {
            return faces(least, thin);
        }
        if known {
            return Held { least, thin, edges: Some(near) };
        }
        // A place on the middle of both faces, as deep below the edge as it may be, is to be no farther from faces that are seen from
        // `back` away than the tool stays away. Where they do not meet it is seen from the edge of the one, and that of the other lies a
        // crack away.
        let (deep, cos) = (-least, (1.0 - half * half).max(0.0).sqrt());
        let back = (BACK * deep).max(deep + thin);
        let away = (back * back - 2.0 * back * deep * cos + deep * deep).sqrt();
        faces(away - back + crack, away + crack)
    }

    /// The hollow edges and corners near the tool.
    fn hollow<'h>(&'h self, tool: &'h Tool<'h>, near: Near) -> impl Iterator<Item = &'h Hollow> {
        let all = self.sheet.edged().map(|edged| &edged.hollow[usize::from(near.side < 0.0)][..]);
        let comes = move |h: &&Hollow| tool.near(&near.start, h.center).0 - h.radius <= near.away;
        all.unwrap_or_default().iter().filter(comes)
    }

    /// How far the tool is from what closes the gaps at edges; no closer than to `enough`.
    pub(super) fn clear_of_edges(
        &self,
        tool: &Tool<'_>,
        near: Near,
        sweep: &Sweep<'_>,
        moved: &Moved<'_>,
        enough: f64,
    ) -> Clearance {
        let (middle, radius) = sweep.sphere();
        let within = (middle, radius + moved.shift.abs() + enough.max(0.0));
        let corners = self.sheet.curve().into_iter().flat_map(|c| c.rolled(near.side, within));
        let mut edges = self.hollow(tool, near).filter_map(|h| h.rolled).chain(corners);
        let mut all = Clearance { least: f64::INFINITY, nearest: None, turned: false };
        loop {
            let some: ArrayVec<Patch, AT_ONCE> = edges.by_ref().take(AT_ONCE).collect();
            if some.is_empty() {
                return all;
            }
            let only = Moved { only: Some(&some), ..*moved };
            let found = clearance(sweep, &only, enough, Aim::Any);
            if found.least < enough {
                return found;
            }
            all.least = all.least.min(found.least);
        }
    }
}

#[cfg(test)]
#[path = "edges_tests.rs"]
mod tests;
