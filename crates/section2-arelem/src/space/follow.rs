//! A motion on its way along its track (APT: `ARLM3`), from cut vector to cut vector until a check surface.

use std::collections::VecDeque;

use aptc_cldata::{Control, Controlled, Position};
use aptc_contact::Side;
use aptc_geometry::{Surface, Vec3};

use super::begin::Begin;
use super::keep::Keep;
use super::loops::Loops;
use super::pace::Pace;
use super::refusal::{blocked, not_reached, trouble_at};
use super::stride::Stride;
use super::swing;
use super::track::{Node, Trouble};
use super::watch::{Halt, Mark, Watch, clearance};
use super::way::Lost;
use crate::failure::Failure;
use crate::scene::{Check, Path, Scene, Wall, to_or_on};

/// Cut vectors that turn back before a motion counts as caught between two places of contact: a path may have
/// a cusp, but a tool that is caught goes to and fro.
const MOST_BACK: u32 = 3;
/// Cut vectors one after another that are shorter than the band is wide before a motion counts as caught: an edge or a
/// corner that the band rounds is passed in a few.
const MOST_CREEPS: u32 = 60;
/// How often the way to the check surface may be cut shorter, because its last cut vector leaves the bands.
const MOST_SHORTENED: u32 = 20;
/// Cut vectors before a corner that one may stand for.
const MERGED: usize = 8;
/// How far a tool goes from its start, in sizes of the scene: what it has not met there it never does.
const FAR: f64 = 1e2;
/// Sine below which a track is along rulings.
const PARALLEL: f64 = 1e-9;
/// Cut vectors of one motion when NUMPTS does not say.
const MOST_VECTORS: u32 = 20_000;

/// The path of a motion from its beginning to its check surface. Where one is to be tangent a place at which it misses that by more
/// than the bands counts only when none comes after it.
pub(super) fn follow(scene: &Scene, begin: &Begin) -> Result<Path, Failure> {
    swing::clear(scene, begin)?;
    let mut walk = Walk::new(scene, begin, true)?;
    let found = walk.walk_on();
    // What another check surface stopped behind such a place has gone through it.
    let stopped_by = found.as_ref().ok().map(|path| path.check);
    let mut watches = walk.watches.iter().enumerate();
    if watches.any(|(i, w)| w.passed_by && stopped_by != Some(i)) {
        return Walk::new(scene, begin, false)?.walk_on();
    }
    found
}

/// A motion on its way.
struct Walk<'a> {
    scene: &'a Scene,
    begin: &'a Begin,
    watches: Vec<Watch>,
    /// What they had seen before the cut vector that is looked at.
    marks: Vec<Mark>,
    /// Greatest length of a cut vector, and whether one goes all the way.
    cap: f64,
    straight: bool,
    /// Cut vectors at most.
    most: u32,
    /// The width of the narrower band.
    least: f64,
    /// How far from the start it is given up.
    far: f64,
    node: Node,
    points: Vec<Position>,
    loops: Loops,
    pace: Pace,
    gone: f64,
    /// The last way, none behind a corner.
    last: Vec3,
    /// Cut vectors that turned back, and short ones one after another.
    back: u32,
    creeps: u32,
    /// Greatest length of the next cut vector, and how often it was cut shorter.
    reach: f64,
    shortened: u32,
    vectors: u32,
    /// The last nodes since the start or a corner.
    trail: VecDeque<Node>,
    /// Is it at a corner?
    cornered: bool,
}

impl<'a> Walk<'a> {
    fn new(scene: &'a Scene, begin: &'a Begin, strict: bool) -> Result<Self, Failure> {
        let mut watches: Vec<Watch> = Vec::with_capacity(scene.checks.len());
        for check in &scene.checks {
            let keep = Keep::of(&check.wall)?;
            let watch = Watch::new(&keep, check.relation, check.nth, &begin.node.pose);
            watches.push(if strict { watch.strict() } else { watch });
        }
        let track = &begin.track;
        let (cap, straight) = longest(scene, begin, &watches);
        // Where a straight track meets other check surfaces than planes is not known before.
        let planes = scene.checks.iter().all(|c| matches!(c.wall.fitted, Some(Surface::Plane(_))));
        let far = if along_rulings(begin) && planes {
            beyond(scene, begin, &watches)
        } else {
            FAR * scene.checks.iter().map(|c| extent(&c.wall)).fold(track.size, f64::max)
        };
        Ok(Self {
            marks: Vec::with_capacity(watches.len()),
            watches,
            cap,
            straight,
            most: scene.limits.vectors.unwrap_or(MOST_VECTORS),
            least: track.keeps.iter().map(Keep::width).fold(f64::INFINITY, f64::min),
            far,
            node: begin.node,
            points: begin.first.clone(),
            loops: Loops::new(&begin.node, track.keeps.iter().map(Keep::width).sum()),
            pace: Pace::new(),
            gone: 0.0,
            last: Vec3::zeros(),
            back: 0,
            creeps: 0,
            reach: cap,
            shortened: 0,
            vectors: 0,
            trail: VecDeque::with_capacity(MERGED),
            cornered: true,
            scene,
            begin,
        })
    }

    fn walk_on(&mut self) -> Result<Path, Failure> {
        while self.vectors < self.most {
            if self.cruise() {
                return Err(self.not_reached(None));
            }
            if self.vectors >= self.most {
                break;
            }
            let (stride, leave) = self.next()?;
            if let Some((i, halt)) = self.halt(&stride)? {
                match self.arrive(i, halt) {
                    Some(path) => return Ok(path),
                    None => continue,
                }
            }
            self.caught(&stride, leave.is_some())?;
            if self.advance(&stride, leave) {
                return Err(self.not_reached(None));
            }
        }
        Err(self.not_reached(Some(self.most)))
    }

    /// Goes on along guides while all check surfaces are far, as most of a path is. Has it come back to its start?
    fn cruise(&mut self) -> bool {
        let free = self.watches.iter().map(Watch::free).fold(f64::INFINITY, f64::min);
        let may = free > 0.0 && self.reach >= self.cap && !self.straight;
        if !may {
            return false;
        }
        let (met, ta, mut round) = (self.met(), self.node.pose.ta, false);
        let Self {
            begin, node, cap, pace, most, least, vectors, gone, last, points, loops, ..
        } = self;
        let cruised = begin.track.cruise(node, *cap, pace, free, |[from, to], along| {
            let way = to - from;
            let length = way.norm();
            if round || *vectors >= *most || length < *least {
                return false;
            }
            (*vectors, *gone, *last) = (*vectors + 1, *gone + length, way);
            points.push(Position { te: to, ta });
            round = loops.closed(from, to, along, met);
            true
        });
        if let Some(to) = cruised {
            self.node = to;
            (self.creeps, self.cornered) = (0, false);
            self.trail.clear();
            self.watches.iter_mut().for_each(Watch::moved);
        }
        round
    }

    /// The next cut vector; to a corner, with how it is left.
    fn next(&mut self) -> Result<(Stride, Option<Node>), Failure> {
        let track = &self.begin.track;
        let stride = track.stride(&self.node, self.reach, &mut self.pace);
        self.reach = self.cap;
        let trouble = match stride {
            Ok(stride) => return Ok((stride, None)),
            Err(trouble) => trouble,
        };
        match track.corner(&self.node) {
            // A place with a corner after a corner at it leads nowhere.
            Some(c) if c.arrive.length > track.exact || !self.cornered => {
                Ok((c.arrive, Some(c.leave)))
            }
            _ => Err(self.blocked(trouble)),
        }
    }

    /// Where the cut vector first meets a check surface, and which one.
    fn halt(&mut self, stride: &Stride) -> Result<Option<(usize, Halt)>, Failure> {
        let Self { scene, begin, node, .. } = *self;
        self.marks.clear();
        self.marks.extend(self.watches.iter().map(Watch::mark));
        let mut stop: Option<(usize, Halt)> = None;
        let mut lost: Option<(usize, Lost)> = None;
        for (i, w) in self.watches.iter_mut().enumerate() {
            match w.scan(&begin.track, &node, stride) {
                Ok(Some(h)) if stop.as_ref().is_none_or(|(_, s)| h.s < s.s) => stop = Some((i, h)),
                Ok(_) => {}
                Err(l) if lost.as_ref().is_none_or(|(_, known)| l.s < known.s) => {
                    lost = Some((i, l));
                }
                Err(_) => {}
            }
        }
        // What is behind the place where another check surface stops it does not matter.
        let matters = |l: &Lost| stop.as_ref().is_none_or(|(_, s)| l.s < s.s);
        match lost.filter(|(_, l)| matters(l)) {
            Some((i, Lost { trouble: Trouble::Check, .. })) => {
                Err(Failure::NoContact { surface: scene.checks[i].wall.surface.clone() })
            }
            Some((_, Lost { trouble, .. })) => Err(trouble_at(scene, &node.pose, trouble)),
            None => Ok(stop),
        }
    }

    /// The whole path, which ends so at the check surface `i`; `None` where one cut vector more must go there.
    fn arrive(&mut self, i: usize, mut halt: Halt) -> Option<Path> {
        let Begin { track, astray, .. } = self.begin;
        let node = &self.node;
        // It was told from the end of the cut vector that is made anew.
        self.pace.left = None;
        // A place that the cut vector before ended at needs no other. The last one ends where the gaps were to be farther on;
        // where the surface changes its bend on the way that does not fit, and a cut vector made for that length does.
        let here = halt.s <= track.exact && !self.points.is_empty();
        if !here && (halt.beside || !track.fits(node, &halt.node)) {
            let shorter = track.stride(node, halt.s, &mut self.pace);
            let again = shorter.and_then(|s| self.watches[i].again(track, node, &s, &halt));
            match again.ok().filter(|h| track.fits(node, &h.node)) {
                Some(made) => halt = made,
                None if self.shortened < MOST_SHORTENED => {
                    self.watches.iter_mut().zip(&self.marks).for_each(|(w, m)| w.back_to(m));
                    self.reach = 0.5 * halt.s;
                    self.shortened += 1;
                    self.straight = false;
                    return None;
                }
                // The proof of the path says by how much it is off.
                None => {}
            }
        }
        if !here {
            let tangent = self.watches[i].tangent(&halt);
            let both = tangent.and_then(|(k, check)| track.met_by_both(&halt.node, k, check));
            if let Some(both) = both.filter(|both| track.fits(node, both)) {
                halt.node = both;
            }
            self.points.push(halt.node.pose.position());
        }
        Some(Path {
            points: std::mem::take(&mut self.points),
            arc: None,
            check: i,
            forward: halt.node.course.along,
            control: self.control(i, &halt),
            fouls: None,
            astray: *astray,
            rivals: Vec::new(),
            left: None,
        })
    }

    /// Refuses a motion that goes to and fro, or in cut vectors that are ever shorter than the band is wide.
    fn caught(&mut self, stride: &Stride, cornered: bool) -> Result<(), Failure> {
        let way = stride.to.pose.te - self.node.pose.te;
        let returns = way.dot(&self.last) < 0.0 && !cornered;
        // A tool end on a surface that ends finds no way on there, only the one that it came.
        let ends = |i: usize| self.begin.track.keeps[i].ends_below(&self.node.gaps[i]);
        if returns && (0..2).any(ends) {
            return Err(self.blocked(Trouble::Contact));
        }
        // Where the place of contact goes over to another one, the way on may be taken for the way back: the surfaces lie on the other hand.
        if self.node.hand() * stride.to.hand() < 0.0 {
            return Err(self.blocked(Trouble::Stuck));
        }
        self.back += u32::from(returns);
        self.last = if cornered { Vec3::zeros() } else { way };
        if self.back >= MOST_BACK {
            return Err(self.blocked(Trouble::Stuck));
        }
        let length = way.norm();
        self.gone += length;
        self.creeps = if length < self.least { self.creeps + 1 } else { 0 };
        if self.creeps >= MOST_CREEPS {
            return Err(self.blocked(Trouble::Stuck));
        }
        Ok(())
    }

    /// Puts out the cut vector, and stands at its end or leaves the corner there. Does the motion lead nowhere, as it has come
    /// back to its start or goes on for ever?
    fn advance(&mut self, stride: &Stride, leave: Option<Node>) -> bool {
        let to = &stride.to;
        self.vectors += 1;
        if self.trail.len() >= MERGED {
            self.trail.pop_front();
        }
        self.trail.push_back(self.node);
        if let Some(leave) = leave {
            // The cut vectors before a corner come ever shorter: one that ends at it stands for them.
            let short = |t: &Node| (to.pose.te - t.pose.te).norm() <= self.cap;
            let fits = |t: &Node| short(t) && self.begin.track.fits(t, to);
            let kept = self.trail.iter().position(fits).unwrap_or(self.trail.len() - 1);
            self.points.truncate(self.points.len().saturating_sub(self.trail.len() - 1 - kept));
            self.points.push(to.pose.position());
            self.trail.clear();
            (self.node, self.cornered) = (leave, true);
            return false;
        }
        self.points.push(to.pose.position());
        if (to.pose.te - self.begin.node.pose.te).norm() > self.far || self.straight {
            return true;
        }
        let met = self.met();
        let round = self.loops.closed(self.node.pose.te, to.pose.te, to.course.along, met);
        (self.node, self.cornered) = (*to, false);
        round
    }

    /// How often check surfaces were met.
    fn met(&self) -> u32 {
        self.watches.iter().map(|w| w.account().0).sum()
    }

    fn blocked(&self, trouble: Trouble) -> Failure {
        blocked(self.scene, self.begin, &self.watches, &self.node, self.gone, trouble)
    }

    /// `spent` are the cut vectors after which it was given up.
    fn not_reached(&self, spent: Option<u32>) -> Failure {
        // Behind what puts the tool in place and turns it there.
        let (start, first) = (self.begin.node.pose, self.begin.first.len());
        let points = self.points.get(first..).unwrap_or_default();
        not_reached(self.scene, &self.watches, start, points, self.gone, spent)
    }

    /// What holds of the path that stopped at a check surface.
    fn control(&self, stopped: usize, halt: &Halt) -> Control {
        let Self { scene, begin, .. } = self;
        let side = |i: usize, wall: &Wall| {
            if i == stopped {
                return halt.side;
            }
            let near = Keep::of(wall).ok().and_then(|k| clearance(&k, &halt.node.pose).ok());
            near.map_or(Side::Positive, |(_, side)| side)
        };
        let check = |(i, c): (usize, &Check)| Controlled {
            nth: c.nth,
            ..c.wall.beside(c.relation, side(i, &c.wall))
        };
        let mut checks: Vec<_> = scene.checks.iter().enumerate().map(check).collect();
        checks.swap(0, stopped);
        let [drive, part] = [0, 1].map(|i| begin.track.keeps[i].side);
        Control {
            drive: Some(scene.drive.beside(to_or_on(scene.drive.on), drive)),
            part: Some(scene.part.beside(to_or_on(scene.part.on), part)),
            checks,
            milling: None,
        }
    }
}

fn extent(wall: &Wall) -> f64 {
    wall.fitted.as_ref().map_or(0.0, Surface::extent)
}

/// Greatest length of a cut vector, and whether the track is one straight line.
fn longest(scene: &Scene, begin: &Begin, watches: &[Watch]) -> (f64, bool) {
    let track = &begin.track;
    if !track.keeps.iter().all(Keep::is_plane) || track.axis.turns() {
        return (scene.limits.step, false);
    }
    (beyond(scene, begin, watches), true)
}

/// A length of a straight track that passes whatever the check surfaces have on it.
fn beyond(scene: &Scene, begin: &Begin, watches: &[Watch]) -> f64 {
    let size = scene.checks.iter().map(|c| extent(&c.wall)).fold(scene.tool.te.norm(), f64::max);
    let planes = watches.iter().map(|w| w.ahead(&begin.node)).fold(0.0, f64::max);
    8.0 * (size + begin.track.keeps[0].profile.reach()) + 2.0 * planes
}

/// Is the track one straight line, along the rulings of surfaces whose rulings are parallel and in planes?
fn along_rulings(begin: &Begin) -> bool {
    let along = begin.node.course.along;
    let straight = |k: &Keep| {
        let across = |g: Vec3| g.normalize().cross(&along).norm();
        k.is_plane() || k.surface.generator().is_some_and(|g| across(g) <= PARALLEL)
    };
    !begin.track.axis.turns() && begin.track.keeps.iter().all(straight)
}
