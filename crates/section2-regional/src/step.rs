//! A step along a path, as long as the tolerance lets it be.

use aptc_contact::Tool;

use crate::drive::Course;
use crate::failure::Failure;
use crate::judge::{Judged, Way, Worst};
use crate::position::{Position, level};
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
/// A chord aims at this part of what the tolerance leaves.
const AIM: f64 = 0.98;

/// How far a path goes.
pub(crate) struct Gait {
    /// The length of step of the parameter that is tried next.
    pub(crate) guess: f64,
    /// So many steps one after the other were far shorter than the band is wide.
    pub(crate) creeps: u32,
}

/// A position that the tolerance lets the tool go to.
pub(crate) struct Step {
    pub(crate) next: Position,
    pub(crate) kept: Memory,
    /// Is the way proved to keep out of the part surface?
    pub(crate) proved: bool,
}

impl Setup<'_> {
    /// The next position: as far on as MAXDP, the next joint of the drive and the tolerance let it, at most to
    /// the first of two parameters; the other is where the path ends. `clear` says that this one is proved to keep out of the
    /// part surface.
    pub(crate) fn step(
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
        let torn = || self.torn(here, course);
        Err(self.sharp(here).or_else(torn).unwrap_or(Failure::NoStep {
            uv: here.drive_uv,
            part_uv: self.part.surface.told(worst.part_uv),
            worst: worst.worst,
            creeps,
        }))
    }

    /// The path ends at a joint of the drive that is none: beyond it the drive goes on elsewhere.
    fn torn(&self, p: &Position, course: Course) -> Option<Failure> {
        /// Parameters by which the path ends before a joint at most, and beside which the drive is looked at.
        const BEFORE: f64 = 1e-6;
        const BESIDE: f64 = 1e-9;
        let mut uv = p.drive_uv;
        let t = uv[course.index()];
        let mut beside = |by: f64| {
            uv[course.index()] = t.round() + by;
            self.drive.place(uv, course).point
        };
        let [before, behind] = [-BESIDE, BESIDE].map(&mut beside);
        let [low, high] = self.drive.limits(course);
        let inside = (low + BESIDE..high).contains(&t.round()) && (t - t.round()).abs() < BEFORE;
        let apart = (before - behind).norm() > self.band.intol + self.band.outtol;
        let drive = if self.same_surface() { &self.part.name } else { &self.drive.name };
        (inside && apart).then(|| Failure::Torn {
            drive: drive.name.as_str().into(),
            uv: p.drive_uv,
            ends: [before, behind],
        })
    }

    /// Why no chord keeps to a surface that the cutter is to be in by more than it is round where it touches: turned
    /// about its edge it is less deep.
    fn sharp(&self, p: &Position) -> Option<Failure> {
        let thick = self.thick();
        let tool = Tool { profile: self.profile, te: p.te, ta: p.ta };
        let radius = tool.support(-level(p.normal, p.ta)).radii[0];
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
