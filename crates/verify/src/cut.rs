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
    /// What holds the pieces.
    tiles: Vec<Tile>,
    /// Did the last search begin here, not at the root?
    went_on: bool,
}

/// A group or a piece, and what shows it to be far enough.
#[derive(Clone, Copy, Debug)]
struct Part {
    patch: Patch,
    /// The way of the tool up to which it is.
    until: f64,
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
    /// How much farther than `enough` it is along the whole way, at the end of which the way is `until`.
    fn room(&self, sweep: &Sweep<'_>, until: f64, enough: f64) -> f64 {
        let far = self.until - until;
        if far >= 0.0 { far } else { self.plane.to - height(sweep, self.plane.m) - enough }
    }
}

/// The greatest `m . te` on the way of a tool that does not turn.
fn height(sweep: &Sweep<'_>, m: Vec3) -> f64 {
    m.dot(&sweep.a.te).max(m.dot(&sweep.b.te))
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
    (to.te - from.te).norm() + sweep.tool.reach() * (to.ta - from.ta).norm()
}

/// A sum of ways rounded up: what its roundings and those of the last way take is less than is put on, so that many short
/// ways are never counted short.
fn up(sum: f64) -> f64 {
    sum * (1.0 + 4.0 * f64::EPSILON)
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
                let room = self.parts[i].room(sweep, until, enough);
                if room >= 0.0 {
                    least = least.min(room);
                } else {
                    pile.push(self.parts[i].patch);
                    kept -= 1;
                    self.parts.swap(i, kept);
                }
                if self.parts.len() - kept > AGAIN {
                    self.went_on = false;
                    break;
                }
            }
            self.parts.truncate(kept);
        }
        if !self.went_on {
            self.parts.clear();
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
        // Rounded down, as far as the way is concerned.
        let way = self.cut.way * (1.0 - 2.0 * f64::EPSILON);
        let until = way + (low - self.asked.enough);
        // Each axis has planes of its own.
        let plane = if self.cut.axis.is_some() { plane } else { Plane::NONE };
        self.cut.parts.push(Part { patch: *part, until, plane });
    }

    /// All of the surface was looked at.
    pub(crate) fn done(self, sweep: &Sweep<'_>) {
        self.cut.last = Some((self.asked, sweep.b));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::between::{angle, between_poses};
    use crate::search::{Aim, FOLD, Lead, clearance_from};
    use crate::sheet::{Sheet, Spot, forms};
    use crate::tool::Tool;
    use aptc_geometry::{Cutter, Vec3};
    use proptest::prelude::*;

    /// Places all over the surface, its continuations too.
    fn places(sheet: &Sheet) -> Vec<Spot> {
        let all = sheet.pieces(&[[f64::NEG_INFINITY, f64::INFINITY]; 2]);
        let at = |i: i32| [-1.0, -0.4, 0.3, 1.0].map(move |x| (i, x));
        let in_piece = at(0).into_iter().flat_map(|(_, s)| at(1).map(|(_, t)| [s, t]));
        let in_piece: Vec<[f64; 2]> = in_piece.collect();
        let of = |p: &Patch| {
            let (chart, at, half) = (p.chart, p.at, p.half);
            in_piece
                .clone()
                .into_iter()
                .map(move |st| Spot { chart, at: [0, 1].map(|i| at[i] + st[i] * half[i]) })
        };
        all.iter().flat_map(of).collect()
    }

    proptest! {
        /// No distance changes by more than the way from one position to another.
        #[test]
        fn distances_change_by_the_way_at_most(
            corner in 0.0_f64..1.0, te in prop::array::uniform3(-1.0..1.0_f64), small: bool,
            lean in prop::array::uniform4(-1.0..1.0_f64), q in prop::array::uniform3(-9.0..9.0_f64),
        ) {
            let profile = Profile::new(&Cutter::mill(2.0, corner, 6.0)).unwrap();
            let tool = Tool::Solid(&profile);
            let up = |x: f64, y: f64| Vec3::new(x, y, 1.0).normalize();
            let to = Vec3::from(te) * if small { 0.0 } else { 1.0 };
            let a = Pose { te: Vec3::zeros(), ta: up(lean[0], lean[1]) };
            let b = Pose { te: to, ta: up(lean[2], lean[3]) };
            let far = way(&Sweep::still(&tool, a), &a, &b);
            let [near, then] = [a, b].map(|at| tool.near(&at, Vec3::from(q)).0);
            prop_assert!((near - then).abs() <= far + 1e-9, "{near} {then} {far}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(96))]
        /// On a walk of many vectors no place of the surface is nearer than each search says that goes on from the last, also
        /// where now and then another tool is held against it, or the surface to its other side.
        #[test]
        fn no_place_is_nearer_on_a_walk(
            which in 0_usize..9, corner in 0.0_f64..1.0, held in 0_usize..3, right: bool, shift in -0.2_f64..0.2,
            te in prop::array::uniform3(-5.0..5.0_f64), short in -0.1_f64..0.5,
            steps in prop::collection::vec((prop::array::uniform5(-1.0..1.0_f64), 0_usize..8), 12), turning: bool,
        ) {
            let sheet = Sheet::new(&forms::parametric()[which]).expect("it has charts");
            let profile = Profile::new(&Cutter::mill(2.0, corner, 6.0)).unwrap();
            let tools = [Tool::End, Tool::Raised(&profile, 3.0), Tool::Solid(&profile)];
            let side = if right { 1.0 } else { -1.0 };
            let moved = |side| Moved { sheet: &sheet, side, shift, fold: FOLD };
            let points = |side| -> Vec<Vec3> {
                places(&sheet).iter().map(|spot| moved(side).place(spot)).collect()
            };
            let points = [side, -side].map(|side| (side, points(side)));
            let least = |pose: &Pose, tool: &Tool<'_>, points: &[Vec3]| {
                points.iter().map(|p| tool.near(pose, *p).0).fold(f64::INFINITY, f64::min)
            };
            let mut pose = Pose { te: Vec3::from(te), ta: Vec3::z() };
            let mut lead = Lead::default();
            for ([x, y, z, p, q], other) in steps {
                let [way, turn] = if turning && other % 2 == 0 { [0.02, 0.06] } else { [0.2, 0.0] };
                let ta = (pose.ta + Vec3::new(p, q, 0.0) * turn).normalize();
                let to = Pose { te: pose.te + Vec3::new(x, y, 0.2 * z) * way, ta };
                let tool = &tools[if other == 0 { (held + 1) % 3 } else { held }];
                let (side, points) = &points[usize::from(other == 1)];
                let enough = least(&Pose { te: Vec3::from(te), ta: Vec3::z() }, tool, points) - short;
                let sweep = Sweep::new(tool, pose, to, angle(pose.ta, to.ta));
                let found = clearance_from(&sweep, &moved(*side), enough, Aim::Clear, &mut lead);
                // What falls short is not searched to its end.
                for i in (0..=3).filter(|_| found.least >= enough) {
                    let at = between_poses(&pose, &to, f64::from(i) / 3.0);
                    let near = least(&at, tool, points);
                    prop_assert!(near >= found.least - 1e-9, "{near} {found:?} {}", lead.cut.went_on);
                }
                pose = to;
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// A tool that comes straight to the surface, turning or not, is not told to be clear of it when it is no more: no
        /// group comes nearer sooner than its way says.
        #[test]
        fn a_tool_that_comes_to_the_surface_is_told_in_time(
            which in 0_usize..9, corner in 0.0_f64..1.0, end: bool, shift in -0.2_f64..0.2, steps in 3_i32..40,
            te in prop::array::uniform3(-9.0..9.0_f64), enough in -0.1_f64..0.3, lean in prop::array::uniform2(-0.5..0.5_f64),
        ) {
            let sheet = Sheet::new(&forms::parametric()[which]).expect("it has charts");
            let profile = Profile::new(&Cutter::mill(0.5, 0.25 * corner, 3.0)).unwrap();
            let tool = if end { Tool::End } else { Tool::Solid(&profile) };
            let moved = Moved { sheet: &sheet, side: 1.0, shift, fold: FOLD };
            let points: Vec<Vec3> = places(&sheet).iter().map(|spot| moved.place(spot)).collect();
            let near = |pose: &Pose| {
                let all = points.iter().map(|p| (tool.near(pose, *p).0, *p));
                all.min_by(|a, b| a.0.total_cmp(&b.0)).expect("places")
            };
            let from = Pose { te: Vec3::from(te), ta: Vec3::z() };
            let to = Vec3::new(lean[0], lean[1], 1.0).normalize();
            let to = Pose { te: near(&from).1, ta: if te[0] > 0.0 { to } else { from.ta } };
            let turn = angle(from.ta, to.ta) / f64::from(steps);
            let mut lead = Lead::default();
            for i in 0..steps {
                let [a, b] = [i, i + 1]
                    .map(|i| between_poses(&from, &to, f64::from(i) / f64::from(steps)));
                let sweep = Sweep::new(&tool, a, b, turn);
                let found = clearance_from(&sweep, &moved, enough, Aim::Clear, &mut lead);
                // What falls short is not searched to its end.
                for at in [a, b].iter().filter(|_| found.least >= enough) {
                    prop_assert!(near(at).0 >= found.least - 1e-9, "{i} {found:?} {}", lead.cut.went_on);
                }
            }
        }
    }

    /// A cut is kept from one vector to the next for as long as the same is asked, and for nothing else.
    #[test]
    fn a_cut_serves_what_it_was_made_for() {
        let sheet = Sheet::new(&forms::parametric()[7]).expect("it has charts");
        let [ball, flat] = [1.0, 0.2].map(|r| Profile::new(&Cutter::mill(2.0, r, 6.0)).unwrap());
        let [tool, high] = [Tool::Solid(&ball), Tool::Raised(&ball, 1.0)];
        let moved = Moved { sheet: &sheet, side: 1.0, shift: 0.1, fold: FOLD };
        let at = |x: f64| Pose { te: Vec3::new(x, 0.3, 1.5), ta: Vec3::z() };
        let search = |lead: &mut Lead, tool: &Tool<'_>, moved: &Moved<'_>, enough: f64, x: f64| {
            let sweep = Sweep::new(tool, at(x), at(x + 0.01), 0.0);
            let found = clearance_from(&sweep, moved, enough, Aim::Clear, lead);
            assert!(found.least >= enough, "{found:?}");
            found.least
        };
        let mut lead = Lead::default();
        search(&mut lead, &tool, &moved, 0.1, 0.0);
        assert!(!lead.cut.went_on);
        search(&mut lead, &tool, &moved, 0.1, 0.01);
        assert!(lead.cut.went_on, "the next vector goes on");
        search(&mut lead.clone(), &tool, &moved, 0.1, 0.05);
        assert!(lead.cut.went_on, "also beyond a gap");
        let others = [
            (&Tool::Solid(&flat), moved, 0.1),
            (&high, moved, 0.1),
            (&Tool::End, moved, 0.1),
            (&tool, Moved { side: -1.0, ..moved }, 0.1),
            (&tool, Moved { shift: 0.2, ..moved }, 0.1),
            (&tool, moved, 0.05),
        ];
        for (tool, moved, enough) in others {
            let mut kept = lead.clone();
            let mut fresh = Lead { direction: lead.direction, ..Lead::default() };
            let [a, b] =
                [&mut kept, &mut fresh].map(|l| search(l, tool, &moved, enough, 0.02).to_bits());
            assert!(!kept.cut.went_on && a == b, "{tool:?} {moved:?} {enough}: {a} {b}");
        }
        // A search that broke off leaves nothing: the axis turns too far for any piece, whatever its size.
        let over = Pose { te: at(0.02).te, ta: Vec3::x() };
        let sweep = Sweep::new(&tool, at(0.02), over, angle(Vec3::z(), Vec3::x()));
        let found = clearance_from(&sweep, &moved, 0.1, Aim::Clear, &mut lead);
        assert!(found.least < 0.1 && lead.cut.last.is_none(), "{found:?}");
        search(&mut lead, &tool, &moved, 0.1, 0.02);
        assert!(!lead.cut.went_on);
    }
}
