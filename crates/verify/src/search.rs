//! That a curved surface, moved along its normals, stays clear of the tool: branch and bound over its charts.
//!
//! The tool's points all have signed distance at least `s` from the surface when no point of the surface
//! moved by `s` along its normal lies in the tool and the tool is not wholly on the wrong side. For a piece
//! in the parallelogram `c +- a +- b` inflated by `d` any unit m shows that it stays at
//! `m . c - h(T, m) - |m . a| - |m . b| - d` from the tool. As m serves the direction from the tool to c.

mod looks;
mod overlap;

use aptc_geometry::Vec3;

use crate::beside::Begin;
use crate::cut::Cut;
use crate::sheet::{Patch, Sheet, Spot};
use crate::sweep::Sweep;
use looks::search;

/// A bound may miss the truth by so many times what is allowed for the turn of the axis, and a shorter way still helps.
pub(crate) const TURNED: f64 = 20.0;

/// Share of the shift below which a piece that is too near is not cut further, as a rule and where that decides nothing.
pub(crate) const FOLD: f64 = 1e-4;
pub(crate) const FINE_FOLD: f64 = 1e-6;

/// What a search found.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clearance {
    /// No point of the moved surface is nearer to the tool; negative infinity when it is not known.
    pub(crate) least: f64,
    /// The nearest that was met: distance, share of the way, place of the surface.
    pub(crate) nearest: Option<(f64, f64, Spot)>,
    /// Did the search end where only a shorter way helps, as the axis turns?
    pub(crate) turned: bool,
}

/// The surface moved by `shift` along its normals to the side `side`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moved<'a> {
    pub(crate) sheet: &'a Sheet,
    pub(crate) side: f64,
    pub(crate) shift: f64,
    /// Share of the shift below which a piece of it counts as a fold.
    pub(crate) fold: f64,
    /// Does what lies nearer to the surface than the shift, as where faces overlap at edges, count as none of it?
    pub(crate) overlaps: bool,
    /// Pieces that are looked at alone.
    pub(crate) only: Option<&'a [Patch]>,
}

impl<'a> Moved<'a> {
    /// All of the surface.
    pub(crate) fn whole(sheet: &'a Sheet, side: f64, shift: f64) -> Self {
        Self { sheet, side, shift, fold: FOLD, overlaps: false, only: None }
    }

    /// Where a place of the surface is moved to.
    pub(crate) fn place(&self, spot: &Spot) -> Vec3 {
        let jet = self.sheet.jet(spot);
        jet.p + jet.n * (self.side * self.shift)
    }
}

/// What the search of the vector before leaves to the next along the same surface.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lead {
    /// The direction that separated the tool from the piece next to it. About a tool that stands against a crest it is the
    /// only one.
    pub(crate) direction: Option<Vec3>,
    pub(crate) cut: Cut,
    /// Where the place of the surface next to the tool's corner is looked for.
    pub(crate) begin: Begin,
    /// Is a place known that is too near, so that only how near it is hangs on this search?
    pub(crate) known: bool,
}

/// What a search is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Aim {
    /// The nearest place, to a tenth of what it falls short of `enough`.
    Nearest,
    /// That all is far enough, else the same; what is far enough is not looked at closely.
    Clear,
    /// Any place that is too near, else that all is far enough; what is far enough is not looked at closely.
    Any,
}

/// Bounds the distance between the moved surface and the tool on its way. The search ends where `enough` is
/// shown.
pub(crate) fn clearance(sweep: &Sweep<'_>, moved: &Moved<'_>, enough: f64, aim: Aim) -> Clearance {
    clearance_from(sweep, moved, enough, aim, &mut Lead::default())
}

/// The same with what the vector before leaves, which becomes what this one does.
pub(crate) fn clearance_from(
    sweep: &Sweep<'_>,
    moved: &Moved<'_>,
    enough: f64,
    aim: Aim,
    lead: &mut Lead,
) -> Clearance {
    let direction = lead.direction;
    let found = search(sweep, moved, enough, aim, lead);
    // Where the axis turns too far for the way to be shown at once a shorter one is looked at next.
    let shorter = found.turned && enough - found.least <= TURNED * sweep.turned();
    if found.least >= enough || !lead.cut.went_on() || shorter {
        return found;
    }
    // What the cut leaves may hide the direction that shows all: once more from the root of the tree.
    lead.direction = direction;
    lead.cut.forget();
    search(sweep, moved, enough, aim, lead)
}
