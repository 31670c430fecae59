//! The place of a surface next to the corner of a tool, from one search to the next.

use std::cell::OnceCell;

use aptc_geometry::Vec3;

use crate::each::two;
use crate::paraboloid::{At, Corner, Place, Seen};
use crate::sheet::{Patch, Sheet, Spot, Tile};
use crate::solid::unit_or;
use crate::sweep::Sweep;
use crate::valley::Valley;

/// Corner's radii across which a piece is no larger from which the way to the place begins.
const NEAR: f64 = 4.0;
/// Searches that need not look for it where one found none.
const REST: u32 = 7;

/// Where the next search begins.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Begin {
    last: Option<Last>,
    /// Searches that need not look, as the last one found nothing.
    rest: u32,
    /// Was it in a hollow along the way?
    valley: bool,
    /// The places next to the tool at both ends of its way, and about the directions to them, where they are known.
    told: Option<[(Spot, Vec3); 2]>,
}

impl Begin {
    /// Places of the surface beside the tool at both ends of the way that is looked at next, in the directions m from it.
    pub(crate) fn tell(&mut self, ends: [(Spot, Vec3); 2]) {
        self.told = Some(ends);
    }

    /// Where the place is looked for first, and in what direction: between those that are told, or where the last one was.
    fn first(&self) -> Option<(Spot, Vec3, At)> {
        match (&self.told, &self.last) {
            (Some([(a, m), (b, n)]), _) if a.chart == b.chart => {
                let at = two([0, 1], |i| 0.5 * (a.at[i] + b.at[i]));
                Some((Spot { at, ..*a }, unit_or(m + n, *m), At::Between))
            }
            (Some([_, (spot, m)]), None) => Some((*spot, *m, At::Between)),
            (_, last) => last.map(|last| (last.spot, last.m, last.at)),
        }
    }
}

/// The place that one search found.
#[derive(Clone, Copy, Debug)]
struct Last {
    spot: Spot,
    at: At,
    m: Vec3,
}

/// The tool on its way, and standing at both ends of it.
#[derive(Debug)]
pub(crate) struct Ways<'a> {
    pub(crate) whole: &'a Sweep<'a>,
    /// Only hollows ask for them.
    ends: OnceCell<[Sweep<'a>; 2]>,
}

impl<'a> Ways<'a> {
    pub(crate) fn new(whole: &'a Sweep<'a>) -> Self {
        Self { whole, ends: OnceCell::new() }
    }

    /// The tool where it stands at both ends.
    pub(crate) fn ends(&self) -> &[Sweep<'a>; 2] {
        let Sweep { tool, a, b, .. } = *self.whole;
        self.ends.get_or_init(|| [Sweep::still(tool, a), Sweep::still(tool, b)])
    }
}

/// The place next to the corner in one search, with its paraboloid.
#[derive(Debug)]
pub(crate) struct Beside<'a> {
    ways: &'a Ways<'a>,
    corner: Option<Corner<'a>>,
    held: Option<Place>,
    /// The hollow along the way at whose end it is, where it is in one.
    valley: Option<Valley<'a>>,
    begin: Begin,
}

impl<'a> Beside<'a> {
    /// Of a tool the distance from which is to be `least` at least.
    pub(crate) fn new(ways: &'a Ways<'a>, least: f64, begin: Begin) -> Self {
        let corner = if begin.rest == 0 { Corner::new(ways.whole, least) } else { None };
        let begin = Begin { rest: begin.rest.saturating_sub(1), ..begin };
        Self { ways, corner, held: None, valley: None, begin }
    }

    /// Where the next search begins.
    pub(crate) fn next(&self) -> Begin {
        Begin { told: None, ..self.begin }
    }

    /// Is the place in a piece, most likely?
    pub(crate) fn is_in(&self, patch: &Patch) -> bool {
        let spot = match &self.held {
            Some(held) => Some(held.spot),
            None if self.corner.is_some() => self.begin.first().map(|first| first.0),
            None => None,
        };
        spot.is_some_and(|spot| patch.holds(&spot))
    }

    /// What is shown of a piece, and the direction that shows it. The place is looked for from where the last search found one, or
    /// from the piece itself.
    pub(crate) fn see(&mut self, sheet: &Sheet, patch: &Patch, tile: &Tile) -> (Seen, Vec3) {
        let none = (Seen::Near, Vec3::zeros());
        let Some(corner) = self.corner else { return none };
        if self.held.is_none() {
            if self.begin.first().is_none() && tile.radius() > NEAR * corner.radius {
                return none;
            }
            self.find(&corner, sheet, patch, tile);
        }
        match (&self.valley, &self.held) {
            (Some(valley), _) => (valley.see(sheet, patch, tile), valley.place().about.m),
            (None, Some(held)) => (corner.see(held, sheet, patch, tile), held.about.m),
            (None, None) => {
                (self.corner, self.begin.rest) = (None, REST);
                none
            }
        }
    }

    /// Looks for the place over a crest or in a hollow: first where it is told or the last search found one, and what it was is so
    /// again, most likely.
    fn find(&mut self, corner: &Corner<'a>, sheet: &Sheet, patch: &Patch, tile: &Tile) {
        let first = self.begin.first();
        let valley = |spot: Spot, m: Vec3| {
            Valley::new(self.ways.ends(), self.ways.whole, corner, sheet, spot, m)
        };
        if self.begin.valley {
            self.valley = first.and_then(|(spot, m, _)| valley(spot, m));
        }
        if self.valley.is_none() {
            let followed = first.and_then(|(spot, m, at)| corner.find(sheet, spot, at, m));
            self.held = followed.or_else(|| corner.find_beside(sheet, patch, tile));
        }
        if self.valley.is_none() && self.held.is_none() {
            let from = first.map(|(spot, m, _)| (spot, m));
            let (spot, m) = from.unwrap_or_else(|| (patch.spot(), corner.met(tile)));
            self.valley = valley(spot, m);
        }
        self.held = self.valley.as_ref().map(|valley| *valley.place()).or(self.held);
        self.begin.valley = self.valley.is_some();
        self.begin.last =
            self.held.map(|Place { about, spot, .. }| Last { spot, at: about.at, m: about.m });
    }
}
