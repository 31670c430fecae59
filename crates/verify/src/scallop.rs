//! What is left between the passes of a region.
//!
//! Over each point of the part surface the point at the allowed height along the normal was in the cutter at
//! some time: what stands on the surface is lower. A piece of the surface, raised by that height, lies in a
//! parallelogram made thicker by how its normal turns; what a tool sweeps without turning is convex, so that
//! it holds the piece when it holds the corners by that thickness.

use std::cmp::Ordering;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering as Memory};

use aptc_cldata::Position;
use aptc_cldata::milling::{Extent, Scallop};
use aptc_geometry::Vec3;

use crate::outline::{Outline, Share};
use crate::passes::{List, Passes};
use crate::sheet::{Patch, Sheet, Spot};
use crate::swath::{Piece, Swath};
use crate::tool::Pose;

/// Pieces that are looked at in one part of a region.
const MOST: u32 = 500_000;
/// The same beside a place that is not decided.
const MORE: u32 = 10_000;
/// The same once something is known to stand higher than allowed and the highest is looked for; by this part of its height a
/// higher place is to stand higher still.
const HIGHER: u32 = 20_000;
const BY: f64 = 0.05;
/// Pieces that a region is cut into at least, so that its parts have equal work.
const PIECES: usize = 256;
/// Halvings of what is left at a place.
const HALVINGS: u32 = 50;

/// What is asked of a region.
#[derive(Debug)]
pub(crate) struct Cusps {
    sheet: Arc<Sheet>,
    side: f64,
    /// Allowed height over the surface, thickness and tolerance included.
    pub(crate) height: f64,
    /// What of it is scallop and tolerance.
    pub(crate) room: f64,
    /// The reason where the region is not known.
    pieces: Result<Vec<Patch>, &'static str>,
    /// What of the pieces counts, where that is not all of them.
    outline: Option<Outline>,
    /// Why more may stand somewhere, if it may.
    pub(crate) excused: Option<&'static str>,
    /// From each end of a pass to the same end of the next.
    pub(crate) links: Vec<[Pose; 2]>,
    /// The first part that is not decided; those behind it do not count.
    first: AtomicUsize,
}

/// The answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Left {
    /// Nothing stands higher.
    Proved,
    /// Something does, but where passes end and the tool does not step to the next, and nowhere else: as below.
    Ends(f64, usize),
    /// Something does: the height of the highest, to a twentieth of it as far as [`HIGHER`] pieces tell, and the number of
    /// the nearest way.
    Higher(f64, usize),
    /// It is not known near this way, and why where that is known.
    Open(usize, Option<&'static str>),
}

impl Left {
    /// What is known of parts and of the next in their order: the highest of what stands too high, the first of equals, and
    /// what stands elsewhere before what stands at ends. What comes behind a part that is not decided does not count, and what
    /// stood higher before it does.
    pub(crate) fn then(self, next: Self) -> Self {
        match (self, next) {
            (Self::Higher(a, _), Self::Higher(b, _)) if b > a => next,
            (Self::Ends(a, _), Self::Ends(b, _)) if b > a => next,
            (Self::Ends(..), Self::Higher(..) | Self::Open(..)) | (Self::Proved, _) => next,
            _ => self,
        }
    }
}

impl Cusps {
    /// Over a surface with a thickness, what may be left with the tolerance.
    pub(crate) fn new(
        sheet: &Arc<Sheet>,
        side: f64,
        thick: f64,
        outtol: f64,
        asked: &Scallop,
    ) -> Self {
        let room = asked.height + outtol;
        let (range, outline) = match &asked.extent {
            Extent::Box(range) => (Ok(*range), None),
            Extent::Outline(outline) => {
                let outline = Outline::new(outline);
                (Ok(outline.range()), Some(outline))
            }
            Extent::Unknown(why) => (Err(*why), None),
        };
        let pieces = range.map(|range| {
            let mut pieces = sheet.pieces(&range);
            let mut across = 0;
            while (1..PIECES).contains(&pieces.len()) {
                pieces = pieces.iter().flat_map(|p| p.halves(across)).collect();
                across = 1 - across;
            }
            pieces.reverse();
            pieces
        });
        let pose = |p: &Position| Pose { te: p.te, ta: p.ta };
        let links = asked.links.iter().map(|[a, b]| [pose(a), pose(b)]).collect();
        let (sheet, first) = (Arc::clone(sheet), AtomicUsize::new(usize::MAX));
        let excused = asked.excused;
        Self { sheet, side, height: thick + room, room, pieces, outline, excused, links, first }
    }

    /// Judges what the ways leave in part `part` of `n`; `pad` covers rounding. Behind a part that is not decided any answer is
    /// given. Where something stands it is looked at again with the ways `linked`, which are followed by the links.
    pub(crate) fn judge<'a>(
        &self,
        swath: &Swath,
        linked: impl FnOnce() -> &'a Swath,
        pad: f64,
        part: usize,
        n: usize,
    ) -> Left {
        let pieces = match &self.pieces {
            Ok(pieces) => pieces,
            Err(why) => return Left::Open(0, Some(why)),
        };
        if part > self.first.load(Memory::Relaxed) {
            return Left::Proved;
        }
        let border = |i: usize| pieces.len() * i / n;
        let pieces = &pieces[border(part)..border(part + 1)];
        match self.part(swath, pad, pieces) {
            Left::Higher(height, i) => {
                let way = swath.whole(i);
                if self.links.is_empty() {
                    return Left::Higher(height, way);
                }
                let linked = linked();
                match self.part(linked, pad, pieces) {
                    Left::Proved => Left::Ends(height, way),
                    // What is left elsewhere. The links stand behind the ways.
                    Left::Higher(height, i) => {
                        let nearest = Some(linked.whole(i)).filter(|i| *i < swath.count());
                        Left::Higher(height, nearest.unwrap_or(way))
                    }
                    _ => Left::Higher(height, way),
                }
            }
            Left::Open(i, why) => {
                self.first.fetch_min(part, Memory::Relaxed);
                Left::Open(swath.whole(i), why)
            }
            left => left,
        }
    }

    fn part(&self, swath: &Swath, pad: f64, pieces: &[Patch]) -> Left {
        let mut passes = Passes::new(swath, pad);
        let mut stack: Vec<(Patch, Option<List>)> =
            pieces.iter().rev().map(|p| (*p, None)).collect();
        let mut hint = 0;
        let (mut seen, mut most) = (0, MOST);
        let mut open = None;
        // What was found that is too high; what is lower does not count from then on.
        let mut highest: Option<(f64, usize)> = None;
        let mut asked = self.height;
        while let Some((patch, mut list)) = stack.pop() {
            let counts = self.outline.as_ref().map_or(Share::All, |o| o.share(&patch));
            if counts == Share::None {
                continue;
            }
            seen += 1;
            let tile = self.sheet.tile(&patch);
            let high = asked.abs();
            let loose = [0, 1].map(|i| tile.stray[i] + high * tile.turn[i]);
            let piece = Piece {
                x: tile.c + tile.n * (self.side * asked),
                sides: tile.side,
                slop: loose[0] + loose[1],
            };
            // Neighbouring pieces are mostly held by the same way.
            let mut best = passes.look(hint, &piece);
            if !best.held {
                let own = passes.near(&piece, list);
                passes.nearest(&piece, own, &mut best);
                list = Some(own);
            }
            hint = best.way;
            if best.held {
                continue;
            }
            if best.distance > pad {
                // Where the middle is beside the region a place of its outline tells.
                let (c, n, near) = match counts {
                    Share::Rest(at) => {
                        let jet =
                            self.sheet.jet(&self.sheet.settle(Spot { chart: patch.chart, at }));
                        (jet.p, jet.n, swath.least(jet.p + jet.n * (self.side * asked), pad))
                    }
                    _ => (tile.c, tile.n, None),
                };
                if near.is_none_or(|(d, _)| d > pad) {
                    let (height, way) = self.height_at(swath, asked, c, n, best.way);
                    highest = Some((height, way));
                    if height == f64::INFINITY {
                        break;
                    }
                    asked = height + BY * (height - self.height + self.room);
                    most = most.min(seen + HIGHER);
                    // Other ways may hold what is higher.
                    stack.push((patch, None));
                    stack.iter_mut().for_each(|(_, list)| *list = None);
                    continue;
                }
            }
            let sides = [0, 1].map(|i| tile.side[i].norm() + tile.stray[i]);
            if seen >= most {
                open.get_or_insert(Left::Open(best.way, None));
                break;
            }
            if sides[0] + sides[1] <= pad {
                // The tip of what stands higher is narrow; where it is wider that is seen.
                most = most.min(seen + MORE);
                open.get_or_insert(Left::Open(best.way, None));
                continue;
            }
            // Across what makes its ends farther than its middle: what is left of a ridge is narrow and long.
            let gain = [0, 1].map(|i| best.ends[i] + loose[i]);
            let across = match gain[1].total_cmp(&gain[0]) {
                _ if sides[0].min(sides[1]) <= 0.5 * pad => sides[1] > sides[0],
                Ordering::Equal => sides[1] > sides[0],
                order => order.is_gt(),
            };
            stack.extend(patch.halves(usize::from(across)).map(|half| (half, list)));
        }
        match highest {
            Some((height, way)) => Left::Higher(height, way),
            None => open.unwrap_or(Left::Proved),
        }
    }

    /// How high the material stands over a place where it is higher than `asked`.
    fn height_at(&self, swath: &Swath, asked: f64, c: Vec3, n: Vec3, near: usize) -> (f64, usize) {
        let free = |h: f64| {
            let x = c + n * (self.side * h);
            swath.least(x, 0.0).filter(|b| b.0 <= 0.0).map(|b| b.1)
        };
        let (mut low, mut high) = (asked, 2.0 * asked.abs());
        let mut way = None;
        for _ in 0..20 {
            way = free(high);
            if way.is_some() {
                break;
            }
            (low, high) = (high, 2.0 * high);
        }
        let Some(mut way) = way else { return (f64::INFINITY, near) };
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            match free(middle) {
                Some(i) => (high, way) = (middle, i),
                None => low = middle,
            }
        }
        (high, way)
    }
}

#[cfg(test)]
#[path = "scallop_tests.rs"]
mod tests;
