//! One path along the drive.

use std::cell::RefCell;

use aptc_contact::Tool;
use aptc_geometry::Vec3;

use crate::area::Guide;
use crate::avoid::{Avoid, Avoided, Case};
use crate::drive::Course;
use crate::failure::Failure;
use crate::guard::Guard;
use crate::judge::{Judged, Way, Worst};
use crate::position::Position;
use crate::report::Note;
use crate::retract::Retract;
use crate::solve::{CLOSE, LOOSE, Memory, Setup, Take};

/// Halvings of a step before the path gives up.
const RETRIES: usize = 60;
/// After so many it is made much shorter each time.
const TIMID: usize = 10;
/// Least step of the parameter, for parameters of the size of 1.
const LEAST: f64 = 1e-11;
/// Where so many steps one after the other move the tool by less than this part of the band the path gives up: chords along what
/// is round are far longer.
const CREEPS: u32 = 400;
const CREEP: f64 = 1.0;
/// Cut vectors into which avoidance may divide one.
const DIVISIONS: usize = 4000;
/// A tool end that moves so many times as far as the contact swings about it.
const SWING: f64 = 4.0;
/// A chord aims at this part of what the tolerance leaves.
const AIM: f64 = 0.98;

/// A path, with the gouges that were avoided on it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Path {
    pub(crate) points: Vec<Position>,
    pub(crate) notes: Vec<Note>,
    /// Did the tool get out of the way of something?
    pub(crate) avoided: bool,
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
        let k = course.index();
        let mut points = Path::default();
        let broken =
            |points: &mut Path, why| Box::new(Broken { done: std::mem::take(points), why });
        let first = self.settled(from, course, sense, None, self.at_end());
        let (mut here, mut memory) = first.map_err(|why| broken(&mut points, why))?;
        self.guarded(&mut points, here, (course, sense), memory, false)
            .map_err(|why| broken(&mut points, why))?;
        if let Some(end) = self.still(&here, to, course, sense) {
            // Where the tool got out of the way it stands there.
            points.points.extend(points.points.last().map(|p| Position {
                te: p.te,
                ta: p.ta,
                lift: p.lift,
                ..end
            }));
            return Ok(points);
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
            let on = self.next(from, [stop, to], (course, sense), memory, &mut gait);
            let mut step = match on.map_err(|why| broken(&mut points, why))? {
                Next::Step(step) => step,
                Next::Over(all, kept) => {
                    points.rolls.extend(all.last().map(|last| [here, *last]));
                    for p in all {
                        if points.points.len() >= self.numpts {
                            let uv = here.drive_uv;
                            let why = Failure::TooMany { limit: self.numpts, uv };
                            return Err(broken(&mut points, why));
                        }
                        gone += (p.te - here.te).norm();
                        self.guarded(&mut points, p, (course, sense), memory, false)
                            .map_err(|why| broken(&mut points, why))?;
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
            gone += (next.te - here.te).norm();
            let uv = here.drive_uv;
            if points.points.len() >= self.numpts {
                return Err(broken(&mut points, Failure::TooMany { limit: self.numpts, uv }));
            }
            if let Some(limit) = self.length.filter(|l| gone > *l) {
                return Err(broken(&mut points, Failure::TooLong { limit, uv }));
            }
            // What avoidance has moved goes another way than the one that is proved.
            let as_proved =
                proved && points.points.last().is_some_and(|p| p.te == here.te && p.ta == here.ta);
            self.guarded(&mut points, next, (course, sense), memory, as_proved)
                .map_err(|why| broken(&mut points, why))?;
            (here, memory, clear) = (next, kept, proved);
        }
        Ok(points)
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

    /// Appends a position after CHKSRF: one that gouges is avoided or fails; a cut vector between two clear
    /// ones that gouges is divided. Is the way to it `proved` to keep out of the part surface, only what else is
    /// checked counts.
    fn guarded(
        &self,
        path: &mut Path,
        next: Position,
        (course, sense): (Course, f64),
        memory: Memory,
        proved: bool,
    ) -> Result<(), Failure> {
        let (part, intol) = (self.part, self.band.intol);
        let done = |guard: &Guard| proved && guard.is_part_alone(&part.tree, part.thick, intol);
        let Some((guard, avoid)) = self.guard.filter(|(guard, _)| !done(guard)) else {
            path.points.push(next);
            return Ok(());
        };
        let mut stack = vec![next];
        let mut left = DIVISIONS;
        while let Some(mut p) = stack.pop() {
            self.cleared(path, &mut p, (course, sense), None)?;
            let Some(last) = path.points.last() else {
                path.points.push(p);
                continue;
            };
            let way = guard.way(self.profile, [(last.te, last.ta), (p.te, p.ta)]);
            // Close to where the lift begins or ends the tool goes straight up or down.
            let near = 4.0 * (self.band.intol + self.band.outtol);
            let close = (p.contact - last.contact).norm() <= near;
            if way.is_err()
                && close
                && let Some(te) = self.corner(guard, last, &p)
            {
                path.points.push(Position { te, ..p });
                path.points.push(p);
                continue;
            }
            if way.is_err()
                && close
                && let Some([up, down]) =
                    avoid.over(self.profile, guard, [(last.te, last.ta), (p.te, p.ta)], &p)
            {
                let up = Position { te: up, ..*last };
                path.points.extend([up, Position { te: down, ..p }, p]);
                path.avoided = true;
                continue;
            }
            let stands_off =
                !close && left > 0 && self.stands_off(last, &p, (course, sense), memory);
            match way {
                Ok(()) if !stands_off => path.points.push(p),
                blocked => {
                    let k = course.index();
                    let mut uv = last.drive_uv;
                    uv[k] = 0.5 * (last.drive_uv[k] + p.drive_uv[k]);
                    if left == 0 || (uv[k] - last.drive_uv[k]).abs() < 1e-9 {
                        let ends = [(last.te, last.ta), (p.te, p.ta)];
                        let deepest = |gouge| guard.deepest(self.profile, ends, gouge);
                        blocked.map_err(|g| Failure::gouge(deepest(g), p.te, p.ta, avoid.on))?;
                    }
                    left -= 1;
                    let (mid, _) = self.settled(uv, course, sense, Some(memory), Take::Band)?;
                    stack.push(p);
                    stack.push(mid);
                }
            }
        }
        Ok(())
    }

    /// A position that stands alone, led away to where it is put out: CHKSRF holds of it there as of a path.
    pub(crate) fn alone(
        &self,
        mut p: Position,
        (course, sense): (Course, f64),
        away: Option<Retract>,
    ) -> Result<Path, Failure> {
        let mut path = Path::default();
        self.cleared(&mut path, &mut p, (course, sense), away)?;
        path.points.push(p);
        Ok(path)
    }

    /// Moves a position that gouges where it is put out to where avoidance leads it; an error without.
    fn cleared(
        &self,
        path: &mut Path,
        p: &mut Position,
        (course, sense): (Course, f64),
        away: Option<Retract>,
    ) -> Result<(), Failure> {
        let Some((guard, avoid)) = self.guard else { return Ok(()) };
        let out = |p: &Position| away.map_or((p.te, p.ta), |r| r.above((p.te, p.ta)));
        let (te, ta) = out(p);
        let Err(gouge) = guard.position(self.profile, te, ta) else { return Ok(()) };
        let gouge = || guard.deepest(self.profile, [(te, ta); 2], gouge);
        let place = self.drive.place(p.drive_uv, course);
        let unit = |v: Vec3| v.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        let case = Case {
            profile: self.profile,
            guard,
            clearance: self.thick() + p.shift,
            middle: self.thick() + 0.5 * (self.band.outtol - self.band.intol),
            outtol: self.band.outtol,
            on: !self.part.touches,
            forward: unit(place.along * sense),
            over: unit(place.across * self.over),
            away,
            seen: RefCell::default(),
        };
        let Some(how) = avoid.around(p, &case) else {
            return Err(Failure::gouge(gouge(), te, ta, avoid.on));
        };
        p.lift = how.lift.map_or_else(Vec3::zeros, |_| how.te - p.te);
        (p.te, p.ta) = (how.te, how.ta);
        path.avoided = true;
        if guard.report {
            let ends = out(p);
            let how = Avoided { te: ends.0, ta: ends.1, ..how };
            path.notes.push(Note { gouge: gouge(), te, ta, how });
        }
        Ok(())
    }

    /// Does the tool on its way between two places of which avoidance has tilted one leave the surface farther
    /// than OUTTOL?
    fn stands_off(
        &self,
        a: &Position,
        b: &Position,
        (course, sense): (Course, f64),
        memory: Memory,
    ) -> bool {
        let lifted = a.lift != Vec3::zeros() || b.lift != Vec3::zeros();
        if lifted || (a.ta - b.ta).norm() <= 1e-12 || !self.part.touches {
            return false;
        }
        let most = self.thick() + self.band.outtol;
        let k = course.index();
        [0.25, 0.5, 0.75].into_iter().any(|f| {
            let mut uv = a.drive_uv;
            uv[k] += (b.drive_uv[k] - a.drive_uv[k]) * f;
            let Ok((p, _)) = self.position(uv, course, sense, Some(memory), Take::Nothing) else {
                return false;
            };
            let te = a.te + (b.te - a.te) * f;
            let ta = (a.ta * (1.0 - f) + b.ta * f).try_normalize(1e-9).unwrap_or(a.ta);
            Tool { profile: self.profile, te, ta }.distance(p.contact) > most
        })
    }

    /// A tool end by which a lifted place is reached from one that is not, or the other way round, both ways
    /// clear and the axis the same.
    fn corner(&self, guard: &Guard, a: &Position, b: &Position) -> Option<Vec3> {
        let clear = |p: Vec3, q: Vec3| guard.way(self.profile, [(p, a.ta), (q, a.ta)]).is_ok();
        let same = (a.ta - b.ta).norm() <= 1e-12;
        let through = |te: &Vec3| same && clear(a.te, *te) && clear(*te, b.te);
        // Up by the lift of the one, or over by that of the other, whichever is the higher.
        let rise = if a.lift.norm() > b.lift.norm() { a.lift - b.lift } else { Vec3::zeros() };
        let fall = if b.lift.norm() > a.lift.norm() { b.lift - a.lift } else { Vec3::zeros() };
        [a.te + fall, b.te + rise].into_iter().find(through)
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

    /// The next position: as far on as MAXDP, the next joint of the drive and the tolerance let it, at most to
    /// the first of two parameters; the other is where the path ends. `clear` says that this one is proved to keep out of the
    /// part surface.
    fn step(
        &self,
        (here, clear): (&Position, bool),
        [to, limit]: [f64; 2],
        course: Course,
        sense: f64,
        memory: Memory,
        gait: &mut Gait,
    ) -> Result<Step, Failure> {
        let k = course.index();
        let t = here.drive_uv[k];
        // What goes across a swing needs none of the places on it.
        let joint = if self.lateral.is_finite() { next_joint(t, sense) } else { to };
        let most = ((to - t) * sense).min((joint - t) * sense);
        let last = if (to - joint) * sense < 0.0 { to } else { joint };
        let last = self.joint(here.drive_uv, last, (course, sense));
        let most = most.min((last - t) * sense);
        let mut length = gait.guess.min(most);
        let band = self.band.intol + self.band.outtol;
        let still = CREEP * band;
        let mut creeps = None;
        let mut worst = Judged {
            used: f64::INFINITY,
            worst: Worst::UNKNOWN,
            part_uv: here.part_uv,
            way: Way::Unknown,
        };
        for tried in 0..RETRIES {
            // What is off by little on every chord is not for ever tried a little shorter.
            let least = if tried < TIMID { 0.95 } else { 0.7 };
            // A place that the drive jumps at is come to in ever smaller steps.
            if length < most && length <= LEAST * (1.0 + t.abs()) {
                break;
            }
            let end = if length >= most { last } else { t + sense * length };
            let take = if (limit - end) * sense <= 0.0 { self.at_end() } else { Take::Band };
            let mut uv = here.drive_uv;
            uv[k] = end;
            let (mut next, mut kept) = self.position(uv, course, sense, Some(memory), take)?;
            let moved = (next.te - here.te).norm();
            if moved > self.maxdp {
                length *= (self.maxdp / moved * 0.999).clamp(0.1, 0.95);
                continue;
            }
            // So much of the tool moves at most.
            let stirs = moved + self.profile.reach() * (next.ta - here.ta).norm();
            if stirs < still && length < most && gait.creeps >= CREEPS {
                creeps = Some(still);
                break;
            }
            let judge = |next: &Position, kept| {
                self.judge([here, next], (course, sense), [memory, kept], clear)
            };
            let mut judged = judge(&next, kept);
            // It may be deeper beside its contact than there.
            if judged.is_some_and(|j| j.way == Way::End) {
                let eased = self.eased(next);
                if eased.te != next.te {
                    next = eased;
                    judged = judge(&next, kept);
                }
            }
            // The search from the last contact may have missed one that comes before. Where the way is proved and
            // the position lies low in the band, that would be in the tool.
            let known = judged.filter(|j| j.used <= 1.0).map(|j| j.way);
            let low = next.shift < 0.0;
            if known.is_some_and(|way| way != Way::Clear || !low) {
                let within = if known == Some(Way::Clear) { LOOSE } else { CLOSE };
                let (first, found) = self.earliest((next, kept), course, sense, (take, within));
                if first.te != next.te {
                    (next, kept) = (first, found);
                    judged = judge(&next, kept);
                }
            }
            let used = judged.map_or(f64::INFINITY, |j| j.used);
            if used <= 1.0 {
                // Grow towards what the band would bear.
                gait.guess = length * (AIM / used.max(1e-4)).sqrt().clamp(1.02, 5.0);
                gait.creeps = if stirs < still { gait.creeps + 1 } else { 0 };
                let proved = judged.is_some_and(|j| j.way == Way::Clear);
                return Ok(Step { next, kept, proved });
            }
            worst = judged.unwrap_or(worst);
            length *= (AIM / used.sqrt()).clamp(0.1, least);
        }
        Err(self.sharp(here).unwrap_or(Failure::NoStep {
            uv: here.drive_uv,
            part_uv: worst.part_uv,
            worst: worst.worst,
            creeps,
        }))
    }

    /// Why no chord keeps to a surface that the cutter is to be in by more than it is round where it touches: turned
    /// about its edge it is less deep.
    fn sharp(&self, p: &Position) -> Option<Failure> {
        let thick = self.thick();
        let tool = Tool { profile: self.profile, te: p.te, ta: p.ta };
        let radius = tool.support(-p.normal).radii[0];
        // Beside a face that lies on the surface its edge touches next.
        let radius = if radius.is_finite() { radius } else { self.profile.corner_radius() };
        let part = || self.part.name.name.as_str().into();
        (self.part.touches && radius < -thick).then(|| Failure::ThickBeyond {
            part: part(),
            uv: p.drive_uv,
            thick,
            radius,
        })
    }
}

/// How far a path goes.
struct Gait {
    /// The length of step of the parameter that is tried next.
    guess: f64,
    /// So many steps one after the other were far shorter than the band is wide.
    creeps: u32,
}

/// How a path goes on.
enum Next {
    Step(Step),
    /// By these positions over an edge.
    Over(Vec<Position>, Memory),
}

/// A position that the tolerance lets the tool go to.
struct Step {
    next: Position,
    kept: Memory,
    /// Is the way proved to keep out of the part surface?
    proved: bool,
}

/// A path that ended early, with what was done of it.
#[derive(Clone, Debug)]
pub(crate) struct Broken {
    pub(crate) done: Path,
    pub(crate) why: Failure,
}

/// The next whole parameter in the sense of the path.
fn next_joint(t: f64, sense: f64) -> f64 {
    const ROOM: f64 = 1e-9;
    if sense > 0.0 { (t + ROOM).floor() + 1.0 } else { (t - ROOM).ceil() - 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joints_are_met_in_both_senses() {
        for (t, sense, next) in [
            (0.0, 1.0, 1.0),
            (0.4, 1.0, 1.0),
            (1.0 - 1e-12, 1.0, 2.0),
            (2.5, -1.0, 2.0),
            (2.0, -1.0, 1.0),
            (1.0 + 1e-12, -1.0, 0.0),
        ] {
            assert!((next_joint(t, sense) - next).abs() < 1e-15, "{t} {sense}");
        }
    }
}
