//! That a tool is nowhere too deep at hollow edges: where faces are moved back they part, and a sharp tool would pass between.
//!
//! With the unit normals m and n of both faces at a place e of the edge, what is as deep as it may be is on the arc
//! `e + d u` between `e + d m` and `e + d n`, which closes the gap between faces moved back by d. So the edge counts as a face of its own
//! that has all normals in between, and is moved as the others are.

use super::Curved;
use crate::sheet::{Hollow, Patch};
use crate::tool::{Pose, Tool};

/// What a gap is held above, and by what.
#[derive(Debug)]
pub(super) struct Held {
    pub(super) least: f64,
    /// How much farther back the surface is moved, from which the tool then stays away by as much.
    pub(super) thin: f64,
    /// The hollow edges that the tool may come to.
    pub(super) edges: Vec<Patch>,
}

impl Curved<'_> {
    /// How the gap is held above `least` on a way.
    ///
    /// Where the border of an edge is not known, as of loose patches and at tips, the tool stays away from the faces all over: what is
    /// held is less deep then than it may be.
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
        let thin = if tool.is_thin() { self.back(least, pad) } else { 0.0 };
        let faces = |least: f64, thin: f64| Held { least, thin, edges: Vec::new() };
        let Some(edged) = self.sheet.edged() else { return faces(least, thin) };
        if least >= 0.0 {
            return faces(least, thin.max(least));
        }
        // Those that the tool may come to.
        let away = (end.te - start.te).norm() + turn * tool.reach() - BACK * least + thin;
        let comes = |h: &&Hollow| tool.near(start, h.center).0 - h.radius <= away;
        let hollow = || edged.hollow[usize::from(side < 0.0)].iter().filter(comes);
        let half = hollow().map(|h| h.half).fold(0.0, f64::max);
        if half <= 0.0 {
            return faces(least, thin);
        }
        if hollow().all(|h| h.rolled.is_some()) {
            return Held { least, thin, edges: hollow().filter_map(|h| h.rolled).collect() };
        }
        // A place on the middle of both faces, as deep below the edge as it may be, is to be no farther from the faces than the tool
        // stays away.
        let (deep, cos) = (-least, (1.0 - half * half).max(0.0).sqrt());
        let back = (BACK * deep).max(deep + thin);
        let away = (back * back - 2.0 * back * deep * cos + deep * deep).sqrt();
        faces(away - back, away)
    }
}

#[cfg(test)]
#[path = "edges_tests.rs"]
mod tests;
