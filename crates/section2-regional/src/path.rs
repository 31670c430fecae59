//! One path along the drive.

use crate::area::Guide;
use crate::avoid::{Avoid, Tilt, Tilts};
use crate::drive::Course;
use crate::failure::Failure;
use crate::guard::Guard;
use crate::position::Position;
use crate::report::Note;
use crate::solve::{Memory, Setup};
use crate::step::{Gait, Step};

/// A tool end that moves so many times as far as the contact swings about it.
const SWING: f64 = 4.0;
/// Share of a path up to which its drive may jump at its end.
const END: f64 = 1e-6;

/// A path, with the gouges that were avoided on it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Path {
    pub(crate) points: Vec<Position>,
    pub(crate) notes: Vec<Note>,
    /// Did the tool get out of the way of something?
    pub(crate) avoided: bool,
    /// How the last position was tilted for it.
    pub(crate) tilt: Option<Tilt>,
    /// Which tilts they may have.
    pub(crate) tilts: Tilts,
    /// Did it end between two positions that are clear, for they are not tilted alike?
    pub(crate) parted: bool,
    /// Where it begins and where it ends to roll over an edge, one edge after the other.
    pub(crate) rolls: Vec<[Position; 2]>,
}

impl Setup<'_> {
    /// Positions from `from` to the limit of the course in the sense of `sense`, the first included.
    ///
    /// APT: `SSPATH`, with the deviation of each chord judged along it in place of an estimate from
    /// curvatures: between its ends the cutter on the chord may leave the place where it touches by no
    /// more than INTOL and OUTTOL.
    pub(crate) fn run(
        &self,
        from: [f64; 2],
        to: f64,
        course: Course,
        sense: f64,
    ) -> Result<Path, Box<Broken>> {
        let lay = |tilts| {
            let mut path = Path { tilts, ..Path::default() };
            match self.lay(&mut path, from, to, (course, sense)) {
                Ok(()) => Ok(path),
                Err(why) => Err(Box::new(Broken { done: path, why })),
            }
        };
        let broken = match lay(Tilts::Alike) {
            Err(broken) if broken.done.parted => broken,
            found => return found,
        };
        // Pitching back from what comes may lead where nothing does; rolling goes by it.
        let others = [Tilts::Least, Tilts::Alone { rolls: true }, Tilts::Alone { rolls: false }];
        others.into_iter().find_map(|tilts| lay(tilts).ok()).ok_or(broken)
    }

    /// Adds the positions from `from` on to the path, as far as it goes.
    fn lay(
        &self,
        path: &mut Path,
        from: [f64; 2],
        to: f64,
        (course, sense): (Course, f64),
    ) -> Result<(), Failure> {
        let k = course.index();
        let (mut here, mut memory) = self.settled(from, course, sense, None, self.at_end())?;
        self.guarded(path, here, (course, sense), memory, false)?;
        if let Some(end) = self.still(&here, to, course, sense) {
            // Where the tool got out of the way it stands there.
            let last = path.points.last();
            path.points.extend(last.map(|p| Position { te: p.te, ta: p.ta, lift: p.lift, ..end }));
            return Ok(());
        }
        let mut gone = 0.0;
        let span = (to - from[k]).abs();
        let room = 1e-10 * span.max(1.0);
        let mut gait = Gait { guess: span, creeps: 0 };
        // Is the last position proved to keep out of the part surface?
        let mut clear = false;
        while (to - here.drive_uv[k]) * sense > room {
            let stop = self.stop(from[k], here.drive_uv[k], to, sense);
            let from = (&here, clear);
            let mut step = match self.next(from, [stop, to], (course, sense), memory, &mut gait)? {
                Next::Step(step) => step,
                Next::Over(all, kept) => {
                    path.rolls.extend(all.last().map(|last| [here, *last]));
                    for p in all {
                        self.may_go_on(path, here.drive_uv)?;
                        gone += (p.te - here.te).norm();
                        self.guarded(path, p, (course, sense), memory, false)?;
                        here = p;
                    }
                    (memory, clear, gait.guess) = (kept, false, span);
                    continue;
                }
            };
            if self.swings(&here, &step.next) {
                // Straight across, if that goes on farther.
                let free = Setup { lateral: f64::INFINITY, ..*self };
                let mut gait = Gait { guess: span, creeps: 0 };
                let across = free.step(from, [to, to], course, sense, memory, &mut gait).ok();
                let on = |s: &Step| s.next.drive_uv[k] * sense;
                step = across.filter(|a| on(a) > on(&step)).unwrap_or(step);
            }
            let Step { next, kept, proved } = step;
            // Where the drive jumps at the end of the path, that ends just before.
            let at_end = (to - here.drive_uv[k]) * sense <= END * span.max(1.0);
            if at_end && (next.drive_uv[k] - here.drive_uv[k]) * sense <= 0.0 && next.te == here.te
            {
                return Ok(());
            }
            gone += (next.te - here.te).norm();
            let uv = here.drive_uv;
            self.may_go_on(path, uv)?;
            if let Some(limit) = self.length.filter(|l| gone > *l) {
                return Err(Failure::TooLong { limit, uv });
            }
            // What avoidance has moved goes another way than the one that is proved.
            let as_proved =
                proved && path.points.last().is_some_and(|p| p.te == here.te && p.ta == here.ta);
            self.guarded(path, next, (course, sense), memory, as_proved)?;
            (here, memory, clear) = (next, kept, proved);
        }
        Ok(())
    }

    /// Refuses more positions than NUMPTS.
    fn may_go_on(&self, path: &Path, uv: [f64; 2]) -> Result<(), Failure> {
        let full = path.points.len() >= self.numpts;
        if full { Err(Failure::TooMany { limit: self.numpts, uv }) } else { Ok(()) }
    }

    /// A guard that knows from where the tool comes: where nothing was put out before, from the first place of the path.
    pub(crate) fn coming(
        &self,
        mut guard: Guard,
        avoid: Avoid,
        from: [f64; 2],
        (course, sense): (Course, f64),
    ) -> Guard {
        if !guard.asks() {
            return guard;
        }
        let place = || {
            let setup = Setup { guard: Some((&guard, avoid)), ..*self };
            let (here, memory) = setup.settled(from, course, sense, None, setup.at_end()).ok()?;
            let mut path = Path::default();
            setup.guarded(&mut path, here, (course, sense), memory, false).ok()?;
            path.points.first().map(|p| (p.te, p.ta))
        };
        if let Some(place) = place() {
            guard.come_from(self.profile, place);
        }
        guard
    }

    /// The end of a path along a border of the drive that runs together in a point, where the tool stands still: the
    /// position at the last parameter. `None` elsewhere, and where the normals fan out so that the tool swings about the point.
    fn still(&self, first: &Position, to: f64, course: Course, sense: f64) -> Option<Position> {
        /// Places in a span of the drive that are looked at.
        const PLACES: f64 = 8.0;
        /// And on all of it.
        const MOST: f64 = 400.0;
        /// Part of the band by which the tool may move and still stands.
        const STILL: f64 = 1e-3;
        let Guide::Surface(surface) = &self.drive.guide else { return None };
        let k = course.index();
        let from = first.drive_uv;
        let at = |share: f64| {
            let mut uv = from;
            uv[k] += (to - from[k]) * share;
            uv
        };
        let point = |[u, v]: [f64; 2]| surface.at(u, v).point;
        let n = ((to - from[k]).abs() * PLACES).ceil().clamp(PLACES, MOST);
        let start = point(from);
        let near = 1e-9 * self.part.extent;
        let mut i = n;
        while i > 0.0 {
            if (point(at(i / n)) - start).norm() > near {
                return None;
            }
            i -= 1.0;
        }
        let room = STILL * (self.band.intol + self.band.outtol);
        let lever = self.profile.reach();
        let mut last = None;
        while i < n {
            i += 1.0;
            let (p, _) = self.settled(at(i / n), course, sense, None, self.at_end()).ok()?;
            if (p.te - first.te).norm() + lever * (p.ta - first.ta).norm() > room {
                return None;
            }
            last = Some(p);
        }
        last
    }

    /// Does a flat bottom swing about its contact from one position to the next, as it does beside a summit?
    fn swings(&self, here: &Position, next: &Position) -> bool {
        self.profile.corner()[0] > 0.0
            && (next.te - here.te).norm() > SWING * (next.contact - here.contact).norm()
    }

    /// The next parameter at which a position is put out in any case.
    fn stop(&self, start: f64, here: f64, to: f64, sense: f64) -> f64 {
        let Some(every) = self.every else { return to };
        let next = start + sense * every * (((here - start) * sense / every + 1e-6).floor() + 1.0);
        if (to - next) * sense < 1e-6 * every { to } else { next }
    }

    /// How the path goes on: over an edge just ahead, where it is not come to in ever smaller steps, or else by a step; and over
    /// an edge of the part surface where there is none.
    fn next(
        &self,
        from: (&Position, bool),
        [stop, to]: [f64; 2],
        (course, sense): (Course, f64),
        memory: Memory,
        gait: &mut Gait,
    ) -> Result<Next, Failure> {
        let over = || {
            let (all, kept) = self.roll(from.0, to, (course, sense), memory)?;
            Some(Next::Over(all, kept))
        };
        let ahead = self.at_edge(from.0.drive_uv, (course, sense));
        if let Some(over) = ahead.then(over).flatten() {
            return Ok(over);
        }
        let step = self.step(from, [stop, to], course, sense, memory, gait);
        step.map(Next::Step).or_else(|why| over().ok_or(why))
    }
}

/// How a path goes on.
enum Next {
    Step(Step),
    /// By these positions over an edge.
    Over(Vec<Position>, Memory),
}

/// A path that ended early, with what was done of it.
#[derive(Clone, Debug)]
pub(crate) struct Broken {
    pub(crate) done: Path,
    pub(crate) why: Failure,
}
