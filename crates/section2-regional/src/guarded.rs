//! A path after CHKSRF: positions and cut vectors that gouge are avoided, or fail.

use std::cell::RefCell;

use aptc_contact::{PIECES, Tool};
use aptc_geometry::Vec3;

use crate::avoid::{AVOIDING, Avoided, Case, Tilt, Tilts};
use crate::drive::Course;
use crate::failure::Failure;
use crate::guard::Guard;
use crate::path::Path;
use crate::plain::Patience;
use crate::position::Position;
use crate::report::Note;
use crate::retract::Retract;
use crate::solve::{Memory, Setup, Take};

/// Cut vectors into which avoidance may divide one.
const DIVISIONS: usize = 4000;

/// A position that a path comes to next.
struct Ahead {
    /// As it is where nothing is avoided.
    at: Position,
    /// What becomes of it, where that is known.
    cleared: Option<Cleared>,
    /// The tilt of a place before it that it was asked for last.
    asked: Option<Tilt>,
}

/// A position that keeps out of what is checked.
struct Cleared {
    p: Position,
    /// How it is tilted for it.
    tilt: Option<Tilt>,
    /// Is it led out of the way?
    avoided: bool,
    /// What is told of it.
    note: Option<Note>,
}

impl Ahead {
    fn new(at: Position) -> Self {
        Self { at, cleared: None, asked: None }
    }
}

impl Cleared {
    /// Led out of the way so.
    fn led(p: Position, how: &Avoided) -> Self {
        let lift = how.lift.map_or_else(Vec3::zeros, |_| how.te - p.te);
        let p = Position { te: how.te, ta: how.ta, lift, ..p };
        Self { p, tilt: how.tilt, avoided: true, note: None }
    }
}

/// Do both roll, or both pitch, to the same side?
fn is_alike(a: Tilt, b: Tilt) -> bool {
    a.1 == b.1 && (a.0 < 0.0) == (b.0 < 0.0)
}

impl Path {
    /// Goes on to a position.
    fn take(&mut self, Cleared { p, tilt, avoided, note }: Cleared) {
        self.points.push(p);
        self.notes.extend(note);
        self.avoided |= avoided;
        self.tilt = tilt;
    }
}

impl Setup<'_> {
    /// Appends a position after CHKSRF: one that gouges is avoided or fails; a cut vector between two clear
    /// ones that gouges is divided. Is the way to it `proved` to keep out of the part surface, only what else is
    /// checked counts.
    pub(crate) fn guarded(
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
        let mut stack = vec![Ahead::new(next)];
        let mut left = DIVISIONS;
        while let Some(Ahead { at, cleared, asked }) = stack.pop() {
            let cleared = match cleared {
                Some(known) => known,
                None => self.cleared(at, (course, sense), None, path.tilts)?,
            };
            let p = cleared.p;
            let Some(last) = path.points.last() else {
                path.take(cleared);
                continue;
            };
            let tilts = path.tilt.or(cleared.tilt).is_some();
            let held = if tilts { guard.tilting() } else { guard };
            let way = held.way(self.profile, [(last.te, last.ta), (p.te, p.ta)]);
            // Close to where the lift begins or ends the tool goes straight up or down.
            let near = 4.0 * (self.band.intol + self.band.outtol);
            let close = (p.contact - last.contact).norm() <= near;
            if way.is_err()
                && close
                && let Some(te) = self.corner(guard, last, &p)
            {
                path.points.push(Position { te, ..p });
                path.take(cleared);
                continue;
            }
            let stands_off =
                !close && left > 0 && self.stands_off(last, &p, (course, sense), memory);
            // The axis does not jump between two tilts where one serves.
            let before = path.tilt.filter(|b| !asked.is_some_and(|a| is_alike(a, *b)));
            if (way.is_err() || stands_off)
                && path.tilts != Tilts::Least
                && let Some(before) = before
                && let Some(alike) = self.alike(&at, &cleared, before, (course, sense))
            {
                stack.push(Ahead { at, cleared: Some(alike), asked: Some(before) });
                continue;
            }
            let asked = before.or(asked);
            if way.is_err()
                && close
                && let Some([up, down]) =
                    avoid.over(self.profile, guard, [(last.te, last.ta), (p.te, p.ta)], &p)
            {
                let raised =
                    |p: &Position, te: Vec3| Position { te, lift: p.lift + te - p.te, ..*p };
                let over = [raised(last, up), raised(&p, down)];
                path.points.extend(over);
                path.take(cleared);
                path.avoided = true;
                continue;
            }
            match way {
                Ok(()) if !stands_off => path.take(cleared),
                blocked => {
                    let k = course.index();
                    let mut uv = last.drive_uv;
                    uv[k] = 0.5 * (last.drive_uv[k] + p.drive_uv[k]);
                    if left == 0 || (uv[k] - last.drive_uv[k]).abs() < 1e-9 {
                        let ends = [(last.te, last.ta), (p.te, p.ta)];
                        let deepest = |gouge| held.deepest(self.profile, ends, gouge);
                        path.parted = match (path.tilt, cleared.tilt) {
                            (Some(a), Some(b)) => !is_alike(a, b),
                            (a, b) => a.or(b).is_some(),
                        };
                        blocked.map_err(|g| {
                            let why = Failure::gouge(deepest(g), p.te, p.ta, avoid);
                            self.under(guard, [last, &p], why)
                        })?;
                    }
                    left -= 1;
                    let (mid, _) = self.settled(uv, course, sense, Some(memory), Take::Band)?;
                    stack.push(Ahead { at, cleared: Some(cleared), asked });
                    stack.push(Ahead::new(mid));
                }
            }
        }
        Ok(())
    }

    /// A position that stands alone, led away to where it is put out: CHKSRF holds of it there as of a path.
    pub(crate) fn alone(
        &self,
        p: Position,
        (course, sense): (Course, f64),
        away: Option<Retract>,
    ) -> Result<Path, Failure> {
        let mut path = Path::default();
        path.take(self.cleared(p, (course, sense), away, Tilts::Least)?);
        Ok(path)
    }

    /// A position as it is, or where avoidance leads it if it gouges where it is put out; an error without.
    fn cleared(
        &self,
        p: Position,
        (course, sense): (Course, f64),
        away: Option<Retract>,
        tilts: Tilts,
    ) -> Result<Cleared, Failure> {
        let plain = Cleared { p, tilt: None, avoided: false, note: None };
        let Some((guard, avoid)) = self.guard else { return Ok(plain) };
        let out = |p: &Position| away.map_or((p.te, p.ta), |r| r.above((p.te, p.ta)));
        let (te, ta) = out(&p);
        // Where it can be avoided, to be unsure is enough.
        let looks = if avoid.on { AVOIDING } else { PIECES };
        let found = guard.way_by(self.profile, [(te, ta); 2], (looks, Patience::Full));
        let Err(gouge) = found else { return Ok(plain) };
        let gouge = || guard.deepest(self.profile, [(te, ta); 2], gouge);
        let case = self.case(guard, &p, (course, sense), away);
        let Some(how) = avoid.around(&p, &case, tilts) else {
            // It may be clear for all that.
            if avoid.on && guard.way(self.profile, [(te, ta); 2]).is_ok() {
                return Ok(plain);
            }
            return Err(Failure::gouge(gouge(), te, ta, avoid));
        };
        let led = Cleared::led(p, &how);
        let ends = out(&led.p);
        let note =
            || Note { gouge: gouge(), te, ta, how: Avoided { te: ends.0, ta: ends.1, ..how } };
        Ok(Cleared { note: guard.report.then(note), ..led })
    }

    /// A position that is tilted otherwise, tilted as the one before it. `None` where it is so already, and where that does not
    /// clear.
    fn alike(
        &self,
        at: &Position,
        cleared: &Cleared,
        before: Tilt,
        way: (Course, f64),
    ) -> Option<Cleared> {
        let least = cleared.tilt.filter(|tilt| !is_alike(*tilt, before))?;
        let (guard, avoid) = self.guard?;
        let how = avoid.alike(at, &self.case(guard, at, way, None), [before, least])?;
        let note = cleared.note.clone().map(|note| Note { how, ..note });
        Some(Cleared { note, ..Cleared::led(*at, &how) })
    }

    /// What a position is judged with where it is led out of the way.
    fn case<'a>(
        &'a self,
        guard: &'a Guard,
        p: &Position,
        (course, sense): (Course, f64),
        away: Option<Retract>,
    ) -> Case<'a> {
        let place = self.drive.place(p.drive_uv, course);
        let unit = |v: Vec3| v.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        Case {
            profile: self.profile,
            guard: guard.tilting(),
            clearance: self.thick() + p.shift,
            middle: self.thick() + 0.5 * (self.band.outtol - self.band.intol),
            outtol: self.band.outtol,
            on: !self.part.touches,
            forward: unit(place.along * sense),
            over: unit(place.across * self.over),
            away,
            seen: RefCell::default(),
        }
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

    /// Why a way between two places gouges: where a lift along the axis begins or ends on it also what stands above the tool,
    /// so that it cannot go straight up from the lower place.
    fn under(&self, guard: &Guard, [a, b]: [&Position; 2], why: Failure) -> Failure {
        let [low, high] = if a.lift.norm() > b.lift.norm() { [b, a] } else { [a, b] };
        let rise = high.lift.norm() - low.lift.norm();
        let along = high.lift.cross(&high.ta).norm() <= 1e-9 * high.lift.norm();
        let Failure::Gouge(deep) = why else { return why };
        if rise <= 0.0 || !along {
            return Failure::Gouge(deep);
        }
        let ends = [low.te, low.te + low.ta * rise].map(|te| (te, low.ta));
        let above = guard.way(self.profile, ends).err().filter(|gouge| {
            let solids = guard.solids(self.profile).filter(|s| s.0 == gouge.by);
            let tops = solids.map(|(_, (profile, up))| up + profile.height());
            let top = tops.fold(f64::NEG_INFINITY, f64::max);
            let seen = gouge.seen.as_ref();
            seen.is_some_and(|seen| (seen.place - low.te).dot(&low.ta) > top)
        });
        match above {
            Some(gouge) => Failure::Under(deep, gouge.surface.into()),
            None => Failure::Gouge(deep),
        }
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
}
