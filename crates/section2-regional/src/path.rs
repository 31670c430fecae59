//! One path along the drive.

use std::sync::Arc;

use aptc_geometry::{Profile, Vec3};

use crate::area::{AxisArea, DriveArea, Guide, Hold, PartArea};
use crate::avoid::{Avoid, Case};
use crate::axis;
use crate::drive::{Course, DrivePoint};
use crate::failure::Failure;
use crate::guard::Guard;
use crate::position::{Position, tool_end, toward_axis};
use crate::project::{Met, Probe, Shot};
use crate::settings::Band;

/// Halvings of a step before the path gives up.
const RETRIES: usize = 40;
/// Rounds that settle an axis that depends on the contact.
const ROUNDS: usize = 50;
/// Places between the ends at which a chord is judged.
const JUDGED: usize = 7;
/// A chord aims at this part of what the tolerance leaves.
const AIM: f64 = 0.98;

/// What holds along a path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Setup<'a> {
    pub(crate) drive: &'a DriveArea,
    pub(crate) part: &'a PartArea,
    pub(crate) axis: AxisArea,
    pub(crate) profile: &'a Profile,
    pub(crate) band: Band,
    /// How far a chord may leave the drive sideways.
    pub(crate) lateral: f64,
    pub(crate) maxdp: f64,
    pub(crate) numpts: usize,
    pub(crate) length: Option<f64>,
    /// Added to the thickness: the lift of a side step.
    pub(crate) lift: f64,
    /// Fixed step of the parameter, if one is wanted.
    pub(crate) fixed: Option<f64>,
    /// What is checked, with the way to avoid it; none without CHKSRF.
    pub(crate) guard: Option<(&'a Guard, Avoid)>,
    /// Direction across the path in which the region goes on.
    pub(crate) over: f64,
}

/// What one position passes on to the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Memory {
    /// Where the search on the part surface starts.
    part_uv: [f64; 2],
    /// From the contact to the axis.
    toward: Vec3,
}

impl Setup<'_> {
    fn thick(&self) -> f64 {
        self.part.thick + self.lift
    }

    /// Is the drive the part surface itself?
    fn same_surface(&self) -> bool {
        matches!(&self.drive.guide, Guide::Surface(s) if Arc::ptr_eq(s, &self.part.surface))
    }

    /// Middle and half width of what the positions may use of the band.
    fn compensation(&self, curvature: f64) -> f64 {
        let Band { intol, outtol } = self.band;
        let (mid, half) = (0.5 * (outtol - intol), 0.45 * (intol + outtol));
        // Rounding must not decide on a plane.
        let flat = 1e-9 / self.part.surface.extent().max(1e-300);
        if curvature < -flat {
            mid + half
        } else if curvature > flat {
            mid - half
        } else {
            mid
        }
    }

    /// The position for a place of the drive; `exact` without compensation of the tolerance.
    pub(crate) fn position(
        &self,
        uv: [f64; 2],
        course: Course,
        sense: f64,
        memory: Option<Memory>,
        exact: bool,
    ) -> Result<(Position, Memory), Failure> {
        let p = self.drive.place(uv, course);
        let direction =
            p.direction.ok_or(Failure::NoDirection { what: "the direction of projection" })?;
        let forward = (p.along * sense).try_normalize(0.0).ok_or(Failure::NoAxis { uv })?;
        let mut ta = axis::at_drive(&self.axis, &p, forward).ok_or(Failure::NoAxis { uv })?;
        let toward = memory.map_or(-forward, |m| m.toward);
        let mut start = memory.map(|m| m.part_uv);
        let mut settled = false;
        for _ in 0..ROUNDS {
            let met = self.meet(&p, direction, ta, start)?;
            start = Some(met.uv);
            if let AxisArea::Angle { part: true, alpha, beta } = self.axis {
                let over = p.across * self.over;
                let next = axis::at_part(alpha, beta, met.normal, forward, over)
                    .ok_or(Failure::NoAxis { uv })?;
                settled = (next - ta).norm() < 1e-13;
                ta = next;
                if !settled {
                    continue;
                }
            } else {
                settled = true;
            }
            if settled {
                return Ok(self.finish(&p, &met, ta, toward, forward, exact));
            }
        }
        debug_assert!(!settled, "a settled axis has returned");
        Err(Failure::NoAxis { uv })
    }

    fn meet(
        &self,
        p: &DrivePoint,
        direction: Vec3,
        ta: Vec3,
        start: Option<[f64; 2]>,
    ) -> Result<Met, Failure> {
        let at = self.drive.hold == Hold::At;
        let probe = if !self.part.touches || at {
            Probe::Ball(self.thick())
        } else {
            Probe::Cutter { profile: self.profile, ta, thick: self.thick() }
        };
        // The tip moves up by the thickness and down by the offset before the projection.
        let from = p.point + ta * (self.thick() - self.drive.offset);
        let surface = &self.part.surface;
        if at && self.drive.offset == 0.0 && self.same_surface() {
            // The drive point is the contact; nothing is projected.
            let d = surface.at(p.uv[0], p.uv[1]);
            let normal = d.normal().ok_or(Failure::NoAxis { uv: p.uv })? * self.part.side;
            return Ok(Met { uv: p.uv, at: d, normal, way: 0.0 });
        }
        let shot = Shot { surface, side: self.part.side, from, along: direction, probe };
        let near = start.and_then(|s| shot.near(s));
        near.or_else(|| shot.first()).ok_or_else(|| Failure::NotMet {
            part: self.part.name.name.as_str().into(),
            uv: p.uv,
            place: p.point,
        })
    }

    fn finish(
        &self,
        p: &DrivePoint,
        met: &Met,
        ta: Vec3,
        toward: Vec3,
        forward: Vec3,
        exact: bool,
    ) -> (Position, Memory) {
        let n = met.normal;
        let curvature = met.at.curvature_along(n, forward).unwrap_or(0.0);
        let shift = if exact { 0.0 } else { self.compensation(curvature) };
        let te = if self.part.touches {
            tool_end(self.profile, ta, met.at.point, n, self.thick() + shift, toward)
        } else {
            met.at.point + n * shift
        };
        let toward = toward_axis(n, ta).unwrap_or(toward);
        let position = Position {
            te,
            ta,
            part_uv: met.uv,
            contact: met.at.point,
            normal: n,
            shift,
            drive_uv: p.uv,
        };
        (position, Memory { part_uv: met.uv, toward })
    }

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
        memory: Option<Memory>,
    ) -> Result<Vec<Position>, Box<Broken>> {
        let k = course.index();
        let mut points = Vec::new();
        let broken = |points: &mut Vec<Position>, why| {
            Box::new(Broken { done: std::mem::take(points), why })
        };
        let first = self.position(from, course, sense, memory, false);
        let (mut here, mut memory) = first.map_err(|why| broken(&mut points, why))?;
        self.guarded(&mut points, here, course, sense, memory)
            .map_err(|why| broken(&mut points, why))?;
        let mut gone = 0.0;
        let span = (to - from[k]).abs();
        let room = 1e-10 * span.max(1.0);
        let mut guess = span;
        while (to - here.drive_uv[k]) * sense > room {
            let step = self.step(&here, to, course, sense, memory, &mut guess);
            let (next, kept) = step.map_err(|why| broken(&mut points, why))?;
            gone += (next.te - here.te).norm();
            let uv = here.drive_uv;
            if points.len() >= self.numpts {
                return Err(broken(&mut points, Failure::TooMany { limit: self.numpts, uv }));
            }
            if let Some(limit) = self.length.filter(|l| gone > *l) {
                return Err(broken(&mut points, Failure::TooLong { limit, uv }));
            }
            self.guarded(&mut points, next, course, sense, memory)
                .map_err(|why| broken(&mut points, why))?;
            (here, memory) = (next, kept);
        }
        Ok(points)
    }

    /// Appends a position after CHKSRF: one that gouges is avoided or fails; a cut vector between two clear
    /// ones that gouges is divided.
    fn guarded(
        &self,
        points: &mut Vec<Position>,
        next: Position,
        course: Course,
        sense: f64,
        memory: Memory,
    ) -> Result<(), Failure> {
        let Some((guard, avoid)) = self.guard else {
            points.push(next);
            return Ok(());
        };
        let mut stack = vec![next];
        let mut left = RETRIES;
        while let Some(mut p) = stack.pop() {
            if let Err(gouge) = guard.position(self.profile, p.te, p.ta) {
                let (te, ta) = (p.te, p.ta);
                let place = self.drive.place(p.drive_uv, course);
                let unit = |v: Vec3| v.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
                let case = Case {
                    profile: self.profile,
                    guard,
                    clearance: self.thick() + p.shift,
                    outtol: self.band.outtol,
                    forward: unit(place.along * sense),
                    over: unit(place.across * self.over),
                };
                let around = avoid.around(&p, &case);
                (p.te, p.ta) = around.ok_or_else(|| Failure::gouge(gouge, te, ta, avoid.on))?;
            }
            let Some(last) = points.last() else {
                points.push(p);
                continue;
            };
            let by = p.te - last.te;
            // A turning axis is checked at its ends, and between them by shorter vectors.
            let turns = (p.ta - last.ta).norm() > 1e-12;
            let way = if turns { Ok(()) } else { guard.way(self.profile, last.te, last.ta, by) };
            match way {
                Ok(()) => points.push(p),
                Err(gouge) => {
                    let k = course.index();
                    let mut uv = last.drive_uv;
                    uv[k] = 0.5 * (last.drive_uv[k] + p.drive_uv[k]);
                    if left == 0 || (uv[k] - last.drive_uv[k]).abs() < 1e-9 {
                        return Err(Failure::gouge(gouge, p.te, p.ta, avoid.on));
                    }
                    left -= 1;
                    let (mid, _) = self.position(uv, course, sense, Some(memory), false)?;
                    stack.push(p);
                    stack.push(mid);
                }
            }
        }
        Ok(())
    }

    /// The next position: as far on as MAXDP, the next joint of the drive and the tolerance let it.
    fn step(
        &self,
        here: &Position,
        to: f64,
        course: Course,
        sense: f64,
        memory: Memory,
        guess: &mut f64,
    ) -> Result<(Position, Memory), Failure> {
        let k = course.index();
        let t = here.drive_uv[k];
        let joint = next_joint(t, sense);
        let most = ((to - t) * sense).min((joint - t) * sense);
        if let Some(fixed) = self.fixed {
            return self.at(here, t + sense * fixed.min(most), course, sense, memory);
        }
        let last = if (to - joint) * sense < 0.0 { to } else { joint };
        let mut length = guess.min(most);
        let mut worst = Judged { used: f64::INFINITY, deviation: 0.0, part_uv: here.part_uv };
        for _ in 0..RETRIES {
            let end = if length >= most { last } else { t + sense * length };
            let (next, kept) = self.at(here, end, course, sense, memory)?;
            let moved = (next.te - here.te).norm();
            if moved > self.maxdp {
                length *= (self.maxdp / moved * 0.999).clamp(0.1, 0.95);
                continue;
            }
            let judged = self.judge(here, &next, course, sense, memory);
            let used = judged.map_or(f64::INFINITY, |j| j.used);
            if used <= 1.0 {
                // Grow towards what the band would bear.
                *guess = length * (AIM / used.max(1e-4)).sqrt().clamp(1.0, 5.0);
                return Ok((next, kept));
            }
            worst = judged.unwrap_or(worst);
            length *= (AIM / used.sqrt()).clamp(0.1, 0.95);
        }
        Err(Failure::NoStep {
            uv: here.drive_uv,
            part_uv: worst.part_uv,
            deviation: worst.deviation,
            allowed: self.band.intol.max(self.band.outtol),
        })
    }

    fn at(
        &self,
        here: &Position,
        t: f64,
        course: Course,
        sense: f64,
        memory: Memory,
    ) -> Result<(Position, Memory), Failure> {
        let mut uv = here.drive_uv;
        uv[course.index()] = t;
        self.position(uv, course, sense, Some(memory), false)
    }

    /// How much of the tolerance the chord between two positions uses; above 1 too much.
    fn judge(
        &self,
        a: &Position,
        b: &Position,
        course: Course,
        sense: f64,
        memory: Memory,
    ) -> Option<Judged> {
        let k = course.index();
        let Band { intol, outtol } = self.band;
        let mut memory = memory;
        let mut worst = Judged { used: 0.0, deviation: 0.0, part_uv: a.part_uv };
        let v = b.te - a.te;
        let square = v.norm_squared();
        for i in 1..=JUDGED {
            let f = i as f64 / (JUDGED + 1) as f64;
            let mut uv = a.drive_uv;
            uv[k] += (b.drive_uv[k] - a.drive_uv[k]) * f;
            let (p, kept) = self.position(uv, course, sense, Some(memory), true).ok()?;
            memory = kept;
            // The place of the chord beside the exact position, and how far it is from where the ends are.
            let s =
                if square > 0.0 { ((p.te - a.te).dot(&v) / square).clamp(0.0, 1.0) } else { 0.0 };
            let apart = a.te + v * s - p.te;
            let off = apart.dot(&p.normal);
            let shift = a.shift * (1.0 - s) + b.shift * s;
            let sag = off - shift;
            let room = if sag < 0.0 { shift + intol } else { outtol - shift };
            let lateral = (apart - p.normal * off).norm() / self.lateral;
            let used = (sag.abs() / room).max(lateral);
            if used > worst.used {
                worst = Judged { used, deviation: off.abs(), part_uv: p.part_uv };
            }
        }
        Some(worst)
    }
}

/// A path that ended early, with what was done of it.
#[derive(Clone, Debug)]
pub(crate) struct Broken {
    pub(crate) done: Vec<Position>,
    pub(crate) why: Failure,
}

/// What a chord does to the tolerance.
#[derive(Clone, Copy, Debug)]
struct Judged {
    /// Part of the tolerance that is used.
    used: f64,
    /// Deviation at the worst place.
    deviation: f64,
    /// The place on the part surface.
    part_uv: [f64; 2],
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
