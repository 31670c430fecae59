//! The cut through the tree of a surface at which the last search ended: where the next one, a little farther on, begins.
//!
//! The signed distance of a point q from a convex tool is the greatest `m . q - h(m)` over the unit vectors m, h being the
//! tool's support function, so that it changes by no more than h does. A tool of revolution comes from one position to
//! another by the way of its end and the least rotation of its axis, by which a point at `r` from the end goes `r |ta' - ta|`:
//! h changes by no more than `|te' - te| + reach |ta' - ta|`. A group of charts that is `low` from the tool at one position is
//! at least that less from it at another, and ways one after another add up.
//!
//! Along a unit vector m the distance is no less than `m . q - h(m)` wherever the tool is, and while the axis stands still
//! `h(m) = m . te + h0(m)`: so a plane that parts tool and surface once tells by one product of vectors whether it does again.
//!
//! A cut belongs to one surface, as the places of it do: each part of a statement has its own of each surface and begins with
//! none, so that nothing hangs on who judges which part. What is asked along the surface may change; the next search then
//! begins at the root.

use aptc_geometry::{Profile, Vec3};

use crate::search::Moved;
use crate::sheet::{Kept, Node, Patch, Patches, Tile};
use crate::sweep::Sweep;
use crate::tool::{Pose, same};

/// Groups and pieces in a cut at most: a finer one is given up, and the next search begins at the root of the tree.
const MOST: usize = 1000;
/// Ways like the last one after which a group is soon looked at again.
const SOON: f64 = 4.0;
/// Those that are looked at again at most, of the room for those that wait.
const AGAIN: usize = 128;

/// Groups of charts and pieces of charts that together hold the whole surface, each with the way of the tool up to which it is far enough.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cut {
    /// What the tool was held against, and the position to which its way is counted.
    last: Option<(Asked, Pose)>,
    /// Its way so far, and its axis as long as that stands still.
    way: f64,
    axis: Option<Vec3>,
    parts: Vec<Part>,
    /// The way of the tool up to which each of them is far enough.
    until: Vec<f64>,
    /// What holds the pieces.
    tiles: Vec<Tile>,
    /// Did the last search begin here, not at the root?
    went_on: bool,
}

/// A group or a piece, and a plane that shows it to be far enough.
#[derive(Clone, Copy, Debug)]
struct Part {
    patch: Patch,
    plane: Plane,
}

/// What parts a group or a piece from the tool, while its axis stands still: by `to - m . te` at least, with the unit vector m.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    m: Vec3,
    to: f64,
}

impl Plane {
    /// Nothing is beyond it.
    pub(crate) const NONE: Self = Self { m: Vec3::new(0.0, 0.0, 0.0), to: f64::NEG_INFINITY };

    /// What parts by `low` along the whole way.
    pub(crate) fn along(sweep: &Sweep<'_>, m: Vec3, low: f64) -> Self {
        let size = size(&sweep.a.te).max(size(&sweep.b.te));
        Self { m, to: down(height(sweep, m) + low, size + low.abs()) }
    }

    /// What parts a tool that does not turn from all that is no lower than `low` along m.
    pub(crate) fn beyond(sweep: &Sweep<'_>, m: Vec3, low: f64) -> Self {
        let reach = sweep.tool.over(sweep.a.ta, m);
        Self { m, to: down(low - reach, size(&sweep.a.te) + low.abs() + reach.abs()) }
    }

    /// What parts by `low` at its end.
    pub(crate) fn at_end(sweep: &Sweep<'_>, m: Vec3, low: f64) -> Self {
        Self { m, to: down(m.dot(&sweep.b.te) + low, size(&sweep.b.te) + low.abs()) }
    }

    /// By how much at the end of the way.
    pub(crate) fn by_end(&self, sweep: &Sweep<'_>) -> f64 {
        self.to - self.m.dot(&sweep.b.te)
    }

    /// The one that shows more at the end of the way.
    pub(crate) fn or(self, other: Self, sweep: &Sweep<'_>) -> Self {
        if other.by_end(sweep) > self.by_end(sweep) { other } else { self }
    }
}

impl Part {
    /// How much farther than `enough` its plane shows it to be along the whole way.
    #[inline]
    fn room(&self, sweep: &Sweep<'_>, enough: f64) -> f64 {
        self.plane.to - height(sweep, self.plane.m) - enough
    }
}

/// The greatest `m . te` on the way of a tool that does not turn.
#[inline]
fn height(sweep: &Sweep<'_>, m: Vec3) -> f64 {
    let [a, b] = [m.dot(&sweep.a.te), m.dot(&sweep.b.te)];
    if a > b { a } else { b }
}

/// The sum of the coordinates' amounts.
fn size(te: &Vec3) -> f64 {
    te.x.abs() + te.y.abs() + te.z.abs()
}

/// A sum rounded down, of numbers that are so large.
fn down(sum: f64, size: f64) -> f64 {
    sum - 4.0 * f64::EPSILON * size
}

/// What a search asks: side and shift of the surface, the distance that is enough, the tool with the height at which it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Asked {
    shift: [f64; 2],
    enough: f64,
    solid: Option<(Profile, f64)>,
}

/// A search that goes on from a cut.
#[derive(Debug)]
pub(crate) struct Cutting<'c> {
    cut: &'c mut Cut,
    asked: Asked,
    /// The length of the way that is looked at.
    along: f64,
    /// Nothing that is not looked at again is nearer.
    pub(crate) rest: f64,
}

/// How much farther a point of the tool may be from the surface, or nearer, at another position.
fn way(sweep: &Sweep<'_>, from: &Pose, to: &Pose) -> f64 {
    let turned = if same(to.ta, from.ta) { 0.0 } else { (to.ta - from.ta).norm() };
    let along = (to.te - from.te).norm();
    if turned == 0.0 { along } else { along + sweep.tool.reach() * turned }
}

/// A sum of ways rounded up: what its roundings and those of the last way take is less than is put on, so that many short
/// ways are never counted short.
fn up(sum: f64) -> f64 {
    sum * (1.0 + 4.0 * f64::EPSILON)
}

/// A number that is not below 0 rounded down, as far as sums of it are concerned.
fn lower(x: f64) -> f64 {
    x * (1.0 - 2.0 * f64::EPSILON)
}

impl Cut {
    /// Puts what has to be looked at on the pile: the whole tree where nothing is known of what is asked.
    pub(crate) fn begin(
        &mut self,
        sweep: &Sweep<'_>,
        moved: &Moved<'_>,
        enough: f64,
        root: Patch,
        pile: &mut Patches,
    ) -> Cutting<'_> {
        let solid = sweep.tool.solid().map(|(profile, up)| (*profile, up));
        let asked = Asked { shift: [moved.side, moved.shift], enough, solid };
        // On an even way and turn nothing is farther from the start than the end.
        let along = way(sweep, &sweep.a, &sweep.b);
        let before = self.last.take().filter(|(same, _)| *same == asked);
        let before = before.map(|(_, at)| way(sweep, &at, &sweep.a));
        let mut until = up(up(self.way + before.unwrap_or(0.0)) + along);
        let stands = (sweep.turn == 0.0).then_some(sweep.a.ta);
        let planes = stands.zip(self.axis).is_some_and(|(now, then)| same(now, then));
        self.axis = stands;
        let mut least = f64::INFINITY;
        if !planes {
            self.parts.iter_mut().for_each(|part| part.plane = Plane::NONE);
        }
        self.went_on = before.is_some() && self.parts.len() <= MOST;
        if self.went_on {
            // Those that were the first the last time come first.
            let mut kept = self.parts.len();
            for i in (0..self.parts.len()).rev() {
                let far = self.until[i] - until;
                if far >= 0.0 {
                    least = if far < least { far } else { least };
                    continue;
                }
                let room = self.parts[i].room(sweep, enough);
                if room >= 0.0 {
                    least = if room < least { room } else { least };
                    // For so long its way is enough to tell.
                    self.until[i] = lower(until) + lower(room);
                    continue;
                }
                pile.push(self.parts[i].patch);
                kept -= 1;
                self.parts.swap(i, kept);
                self.until.swap(i, kept);
                if self.parts.len() - kept > AGAIN {
                    self.went_on = false;
                    break;
                }
            }
            self.parts.truncate(kept);
            self.until.truncate(kept);
        }
        if !self.went_on {
            self.parts.clear();
            self.until.clear();
            self.tiles.clear();
            pile.clear();
            pile.push(root);
            (until, least) = (along, f64::INFINITY);
        }
        self.way = until;
        Cutting { cut: self, asked, along, rest: enough + least }
    }

    /// Did the last search go on from the one before it?
    pub(crate) fn went_on(&self) -> bool {
        self.went_on
    }

    /// The next search begins at the root.
    pub(crate) fn forget(&mut self) {
        self.last = None;
    }
}

impl Cutting<'_> {
    /// Is what is so far from the tool not looked at again soon?
    pub(crate) fn is_far(&self, low: f64) -> bool {
        low >= self.asked.enough + SOON * self.along
    }

    /// What parts the group from the tool at the end of its way.
    pub(crate) fn at_end(&self, sweep: &Sweep<'_>, node: &Node, shift: f64) -> Plane {
        let (distance, m) = sweep.tool.near(&sweep.b, node.center);
        let low = distance - node.extent(m) - shift;
        Plane::at_end(sweep, m, low)
    }

    /// How far it is on all of the way what is so far at its end.
    pub(crate) fn before_end(&self, low: f64) -> f64 {
        low - self.along
    }

    /// What holds a piece, where it is kept here.
    pub(crate) fn tile(&self, piece: &Patch) -> Option<Tile> {
        match piece.kept {
            Kept::Cut(i) => self.cut.tiles.get(i).copied(),
            Kept::Nowhere | Kept::Chart => None,
        }
    }

    /// The piece with its tile kept here, as far as there is room.
    pub(crate) fn keep(&mut self, piece: &Patch, tile: &Tile) -> Patch {
        if piece.kept != Kept::Nowhere || self.cut.tiles.len() >= MOST {
            return *piece;
        }
        self.cut.tiles.push(*tile);
        Patch { kept: Kept::Cut(self.cut.tiles.len() - 1), ..*piece }
    }

    /// The part is at least so far at the end of the way, and beyond the plane.
    pub(crate) fn clear(&mut self, part: &Patch, low: f64, plane: Plane) {
        let until = lower(self.cut.way) + (low - self.asked.enough);
        // Each axis has planes of its own.
        let plane = if self.cut.axis.is_some() { plane } else { Plane::NONE };
        self.cut.parts.push(Part { patch: *part, plane });
        self.cut.until.push(until);
    }

    /// All of the surface was looked at.
    pub(crate) fn done(self, sweep: &Sweep<'_>) {
        self.cut.last = Some((self.asked, sweep.b));
    }
}

#[cfg(test)]
#[path = "cut_tests.rs"]
mod tests;
