//! A path after CHKSRF: positions and cut vectors that gouge are avoided, or fail.

use std::cell::RefCell;

use aptc_contact::{PIECES, Tool};
use aptc_geometry::Vec3;

use crate::avoid::{AVOIDING, Avoided, Case};
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
                let raised =
                    |p: &Position, te: Vec3| Position { te, lift: p.lift + te - p.te, ..*p };
                let over = [raised(last, up), raised(&p, down)];
                path.points.extend(over);
                path.points.push(p);
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
                        blocked.map_err(|g| Failure::gouge(deepest(g), p.te, p.ta, avoid))?;
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
        // Where it can be avoided, to be unsure is enough.
        let looks = if avoid.on { AVOIDING } else { PIECES };
        let found = guard.way_by(self.profile, [(te, ta); 2], (looks, Patience::Full));
        let Err(gouge) = found else { return Ok(()) };
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
            // It may be clear for all that.
            if avoid.on && guard.way(self.profile, [(te, ta); 2]).is_ok() {
                return Ok(());
            }
            return Err(Failure::gouge(gouge(), te, ta, avoid));
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
}
