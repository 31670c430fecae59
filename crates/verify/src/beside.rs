//! The place of a surface next to the corner of a tool, from one search to the next.

use std::cell::OnceCell;

use aptc_geometry::Vec3;

use crate::each::two;
use crate::paraboloid::{At, Corner, Place, Seen};
use crate::sheet::{Patch, Sheet, Spot, Tile};
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
}

impl Begin {
    /// A place of the surface beside the tool in the direction m, where none was found.
    pub(crate) fn offer(&mut self, spot: Spot, m: Vec3) {
        self.last.get_or_insert(Last { spot, before: None, at: At::Between, m });
    }
}

/// The place that one search found.
#[derive(Clone, Copy, Debug)]
struct Last {
    spot: Spot,
    /// The one before it.
    before: Option<Spot>,
    at: At,
    m: Vec3,
}

impl Last {
    /// As far ahead as it came from the one before.
    fn ahead(&self) -> Spot {
        match self.before {
            Some(before) if before.chart == self.spot.chart => {
                let at = two([0, 1], |i| 2.0 * self.spot.at[i] - before.at[i]);
                Spot { at, ..self.spot }
            }
            _ => self.spot,
        }
    }
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
        self.begin
    }

    /// What is shown of a piece, and the direction that shows it. The place is looked for from where the last search found one, or
    /// from the piece itself.
    pub(crate) fn see(&mut self, sheet: &Sheet, patch: &Patch, tile: &Tile) -> (Seen, Vec3) {
        let none = (Seen::Near, Vec3::zeros());
        let Some(corner) = self.corner else { return none };
        if self.held.is_none() {
            if self.begin.last.is_none() && tile.radius() > NEAR * corner.radius {
                return none;
            }
            self.find(&corner, sheet, patch, tile);
        }
        match (&self.valley, &self.held) {
            (Some(valley), _) => (valley.see(sheet, patch, tile), valley.place().0.m),
            (None, Some(held)) => (corner.see(held, sheet, patch, tile), held.0.m),
            (None, None) => {
                (self.corner, self.begin.rest) = (None, REST);
                none
            }
        }
    }

    /// Looks for the place over a crest or in a hollow: first where the last search found one, and what it was is so again, most
    /// likely.
    fn find(&mut self, corner: &Corner<'a>, sheet: &Sheet, patch: &Patch, tile: &Tile) {
        let last = self.begin.last.take();
        let valley = |spot: Spot, m: Vec3| {
            Valley::new(self.ways.ends(), self.ways.whole, corner, sheet, spot, m)
        };
        let crest = |last: Last| corner.find(sheet, last.ahead(), last.at, last.m);
        let hollow = last.filter(|_| self.begin.valley);
        self.valley = hollow.and_then(|last| valley(last.ahead(), last.m));
        let ahead = if self.valley.is_none() { last.and_then(crest) } else { None };
        let followed = self.valley.is_some() || ahead.is_some();
        self.held = ahead;
        if !followed {
            self.held = corner.find_beside(sheet, patch, tile);
        }
        if !followed && self.held.is_none() {
            let from = last.map(|last| (last.spot, last.m));
            let (spot, m) = from.unwrap_or_else(|| (patch.spot(), corner.met(tile)));
            self.valley = valley(spot, m);
        }
        self.held = self.valley.as_ref().map(|valley| *valley.place()).or(self.held);
        self.begin.valley = self.valley.is_some();
        self.begin.last = self.held.map(|(held, spot)| {
            let before = last.filter(|_| followed).map(|last| last.spot);
            Last { spot, before, at: held.at, m: held.m }
        });
    }
}
