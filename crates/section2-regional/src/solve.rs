//! The position for a place of the drive.

use std::sync::Arc;

use aptc_contact::{Clear, PatchPlace, Tool};
use aptc_geometry::{Profile, Segment, Vec3};

use crate::area::{AxisArea, DriveArea, Guide, Hold, PartArea};
use crate::avoid::Avoid;
use crate::axis;
use crate::drive::{Course, DrivePoint};
use crate::failure::Failure;
use crate::guard::Guard;
use crate::position::{Chosen, Position, level, tool_end, toward_axis};
use crate::project::{Met, Probe, Shot};
use crate::settings::{Band, Settings};

/// Rounds that settle an axis that depends on the contact.
const ROUNDS: usize = 50;
/// Looks by which a position or a cut vector is to be seen to keep out of the part surface; one that but touches it takes ever
/// more, and the path has others.
pub(crate) const LOOKS: usize = 20_000;
/// Another place may be nearer by this part of the band: with what a position takes it stays within INTOL.
pub(crate) const CLOSE: f64 = 0.04;
/// And by this part where the way is proved anyway: the proof of a narrow part takes much longer.
pub(crate) const LOOSE: f64 = 0.25;
/// How often a position is moved to the contact that comes before.
const REPAIRS: usize = 6;

/// What holds along a path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Setup<'a> {
    pub(crate) drive: &'a DriveArea,
    pub(crate) part: &'a PartArea,
    pub(crate) axis: AxisArea,
    pub(crate) profile: &'a Profile,
    pub(crate) band: Band,
    /// How far a chord may leave the drive sideways; infinite for one that goes straight across a swing, over joints too.
    pub(crate) lateral: f64,
    pub(crate) maxdp: f64,
    pub(crate) numpts: usize,
    pub(crate) length: Option<f64>,
    /// Added to the thickness: the lift of a side step.
    pub(crate) lift: f64,
    /// What is checked, with the way to avoid it; none without CHKSRF.
    pub(crate) guard: Option<(&'a Guard, Avoid)>,
    /// Direction across the path in which the region goes on.
    pub(crate) over: f64,
    /// Step of the parameter at which positions are put out in any case, counted from the start.
    pub(crate) every: Option<f64>,
    /// Do other paths join this one at its ends? There it stands in the middle of the band.
    pub(crate) joins: bool,
    /// Is the tool end over the contact where axis and normal are parallel, as GOLOFT has it? Else the contact
    /// is behind.
    pub(crate) centred: bool,
    /// Which place of its bottom or flank is to touch.
    pub(crate) chosen: Chosen,
}

/// Which part of the tolerance a position may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Take {
    /// None: the cutter touches.
    Nothing,
    /// None but what it takes to stand in the middle of the band: where paths of several directions join.
    Middle,
    /// What lets the chords beside it be long.
    Band,
}

/// What one position passes on to the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Memory {
    /// Where the search on the part surface starts.
    pub(crate) part_uv: [f64; 2],
    /// From the contact to the axis.
    toward: Vec3,
    /// Where the path went, and the axis.
    forward: Vec3,
    ta: Vec3,
}

impl Memory {
    /// The same with the search starting elsewhere.
    pub(crate) fn at(self, part_uv: [f64; 2]) -> Self {
        Self { part_uv, ..self }
    }

    /// From the contact to the axis for another axis and the way there: where both turn it turns with them, so that a bottom
    /// that lies on the surface all along is touched behind all along.
    fn toward(&self, forward: Vec3, ta: Vec3) -> Vec3 {
        /// Axes that differ by less do not turn.
        const TURNS: f64 = 1e-12;
        if (ta - self.ta).norm() <= TURNS {
            return self.toward;
        }
        let frame = |forward: Vec3, ta: Vec3| {
            let level = (forward - ta * forward.dot(&ta)).try_normalize(0.0)?;
            Some([level, ta.cross(&level)])
        };
        let turned = || {
            let [from, to] = [frame(self.forward, self.ta)?, frame(forward, ta)?];
            Some(to[0] * from[0].dot(&self.toward) + to[1] * from[1].dot(&self.toward))
        };
        turned().unwrap_or(self.toward)
    }
}

impl<'a> Setup<'a> {
    /// What the modal words say, for this drive, part surface and axis.
    ///
    /// # Errors
    /// No cutter is given that is a solid.
    pub(crate) fn new(
        settings: &'a Settings,
        drive: &'a DriveArea,
        part: &'a PartArea,
        axis: AxisArea,
    ) -> Result<Self, Failure> {
        let profile = settings.profile.as_ref().ok_or(Failure::NoCutter)?;
        Ok(Self {
            drive,
            part,
            axis,
            profile,
            band: settings.band(),
            lateral: settings.lateral(),
            maxdp: settings.maxdp(),
            numpts: settings.numpts(),
            length: settings.length(),
            lift: 0.0,
            guard: None,
            over: 1.0,
            every: None,
            joins: false,
            centred: false,
            chosen: Chosen::default(),
        })
    }
}

impl Setup<'_> {
    /// By how much a chord may leave its line at most.
    pub(crate) fn strays(&self) -> f64 {
        self.band.intol.max(self.band.outtol).max(self.lateral)
    }

    /// Does no point of the cutter move from one tool end and axis to the other by more than the whole band, and is the way clear?
    pub(crate) fn touch(&self, a: (Vec3, Vec3), b: (Vec3, Vec3)) -> bool {
        let moves = (a.0 - b.0).norm() + self.profile.reach() * (a.1 - b.1).norm();
        moves <= self.band.intol + self.band.outtol
            && self.guard.is_none_or(|(guard, _)| guard.way(self.profile, [a, b]).is_ok())
    }

    /// Between cutter and part surface: thickness and lift.
    pub(crate) fn thick(&self) -> f64 {
        self.part.thick + self.lift
    }

    /// Is the drive the part surface itself?
    pub(crate) fn same_surface(&self) -> bool {
        matches!(&self.drive.guide, Guide::Surface(s) if Arc::ptr_eq(s, &self.part.surface))
    }

    /// What a position at the end of a path takes of the tolerance.
    pub(crate) fn at_end(&self) -> Take {
        if self.joins { Take::Middle } else { Take::Band }
    }

    /// Middle and half width of what the positions may use of the band.
    fn compensation(&self, curvature: f64) -> f64 {
        let Band { intol, outtol } = self.band;
        let (mid, half) = (0.5 * (outtol - intol), 0.45 * (intol + outtol));
        // Rounding must not decide on a plane.
        let flat = 1e-9 / self.part.extent.max(1e-300);
        if curvature < -flat {
            mid + half
        } else if curvature > flat {
            mid - half
        } else {
            mid
        }
    }

    /// The most of the band by which a position is above its contact.
    pub(crate) fn highest(&self) -> f64 {
        self.compensation(f64::NEG_INFINITY)
    }

    /// The position for a place of the drive.
    pub(crate) fn position(
        &self,
        uv: [f64; 2],
        course: Course,
        sense: f64,
        memory: Option<Memory>,
        take: Take,
    ) -> Result<(Position, Memory), Failure> {
        let p = self.drive.place(uv, course);
        let direction = p.direction.ok_or(Failure::NoAxis { uv: p.uv })?;
        let forward = (p.along * sense).try_normalize(0.0).ok_or(Failure::NoAxis { uv })?;
        let mut ta = axis::at_drive(&self.axis, &p, forward).ok_or(Failure::NoAxis { uv })?;
        let behind = if self.centred { Vec3::zeros() } else { -forward };
        let mut start = memory.map(|m| m.part_uv);
        if let Some(met) = self.seat(&p, direction, start) {
            let ta = met.normal;
            let toward = memory.map_or(behind, |m| m.toward(forward, ta));
            return self.finish(&p, &met, ta, toward, forward, take);
        }
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
                let toward = memory.map_or(behind, |m| m.toward(forward, ta));
                return self.finish(&p, &met, ta, toward, forward, take);
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
        let surface = &self.part.surface;
        if at && self.drive.offset == 0.0 && self.same_surface() {
            // The drive point is the contact; nothing is projected.
            let d = surface.at(p.uv[0], p.uv[1]);
            let normal = surface.normal_at(p.uv[0], p.uv[1]);
            let normal = normal.ok_or(Failure::NoAxis { uv: p.uv })? * self.part.side;
            return Ok(Met { uv: p.uv, at: d, normal, way: 0.0 });
        }
        let shot = self.shot(p, direction, ta);
        let tree = &self.part.tree;
        let spans = surface.spans();
        let foot = p.foot.map(|f| [f[0] * spans[0], f[1] * spans[1]]);
        // A point goes to its foot and no other place of the line; a cutter to what it meets first.
        let start = if self.leads() { start.or(foot) } else { foot.or(start) };
        // A point comes to the surface from behind as well, where it does not from the front.
        let back = matches!(shot.probe, Probe::Ball(r) if r == 0.0).then(|| shot.turned());
        let behind = |uv: [f64; 2]| {
            let n = surface.normal_at(uv[0], uv[1]).map(|n| n * self.part.side);
            n.is_some_and(|n| n.dot(&direction) > 0.0)
        };
        let from_behind = back.zip(start).filter(|(_, s)| behind(*s));
        let near = from_behind.and_then(|(back, s)| back.near(s)).map(Met::turned);
        let near = near.or_else(|| start.and_then(|s| shot.near(s)));
        let near = near.or_else(|| start.and_then(|s| shot.beside(s, tree)));
        let first = |shot: &Shot<'_>| {
            shot.touch(tree).or_else(|| shot.first(tree)).or_else(|| shot.fall(tree))
        };
        let met = near.or_else(|| first(&shot));
        met.or_else(|| back.as_ref().and_then(first).map(Met::turned)).ok_or_else(|| {
            Failure::NotMet { part: self.part.name.name.as_str().into(), uv: p.uv, place: p.point }
        })
    }

    /// The line of projection, and what is moved along it.
    pub(crate) fn shot(&self, p: &DrivePoint, direction: Vec3, ta: Vec3) -> Shot<'_> {
        let probe = if !self.part.touches || self.drive.hold == Hold::At {
            Probe::Ball(self.thick())
        } else {
            Probe::Cutter { profile: self.profile, ta, thick: self.thick() }
        };
        Shot {
            surface: &self.part.surface,
            extent: self.part.extent,
            ends: self.part.ends,
            side: self.part.side,
            // The tip moves up by the thickness and down by the offset before the projection.
            from: p.point + ta * (self.thick() - self.drive.offset),
            along: direction,
            probe,
        }
    }

    fn finish(
        &self,
        p: &DrivePoint,
        met: &Met,
        ta: Vec3,
        toward: Vec3,
        forward: Vec3,
        take: Take,
    ) -> Result<(Position, Memory), Failure> {
        let n = met.normal;
        let bend = || met.at.curvature_along(n, forward).unwrap_or(0.0);
        let shift = match take {
            Take::Nothing => 0.0,
            Take::Middle => self.compensation(0.0),
            Take::Band => self.compensation(bend()),
        };
        let led = self.part.touches && self.drive.hold == Hold::On;
        let te = if led {
            // The tool end stays on the line of projection, whatever of a flat bottom touches.
            let along = p.direction.unwrap_or_else(Vec3::zeros);
            p.point + ta * (self.thick() - self.drive.offset) + along * met.way + n * shift
        } else if self.part.touches {
            let (at, thick) = (met.at.point, self.thick() + shift);
            let back = if toward == Vec3::zeros() { -forward } else { toward };
            self.chosen
                .tool_end(self.profile, ta, at, n, thick, back)
                .unwrap_or_else(|| tool_end(self.profile, ta, at, n, thick, toward))
        } else {
            met.at.point + n * shift
        };
        let segment = if self.part.touches && self.profile.widest() > 0.0 {
            Tool { profile: self.profile, te, ta }.support(-level(n, ta)).segment
        } else {
            Segment::Arc
        };
        if segment == Segment::Top && !self.centred {
            let part = self.part.name.name.as_str().into();
            return Err(Failure::Sphere { part, part_uv: self.part.surface.told(met.uv), te });
        }
        let toward = toward_axis(n, ta).unwrap_or(toward);
        let position = Position {
            te,
            ta,
            part_uv: met.uv,
            contact: met.at.point,
            normal: n,
            shift,
            drive_uv: p.uv,
            segment,
            lift: Vec3::zeros(),
        };
        Ok((position, Memory { part_uv: met.uv, toward, forward, ta }))
    }

    /// As [`Setup::position`], and where the tool end stays on the line of projection the first contact on it; elsewhere
    /// [eased](Setup::eased).
    pub(crate) fn settled(
        &self,
        uv: [f64; 2],
        course: Course,
        sense: f64,
        memory: Option<Memory>,
        take: Take,
    ) -> Result<(Position, Memory), Failure> {
        let found = self.position(uv, course, sense, memory, take)?;
        let (p, kept) = self.earliest(found, course, sense, (take, CLOSE));
        Ok((self.eased(p), kept))
    }

    /// Is the tool end led along the line of projection, to the first contact on it?
    pub(crate) fn leads(&self) -> bool {
        self.drive.hold == Hold::On && self.part.touches
    }

    /// The position moved to the first contact on its line of projection, if it is led there. Where the search
    /// from the last contact has led into another place of the surface, which counts where it is nearer by more
    /// than the part `within` of the band, it begins again at the place that is in the tool, then at the deepest
    /// one, and at last where the tool touches when it comes from afar.
    pub(crate) fn earliest(
        &self,
        (mut p, mut kept): (Position, Memory),
        course: Course,
        sense: f64,
        (take, within): (Take, f64),
    ) -> (Position, Memory) {
        if !self.leads() {
            return (p, kept);
        }
        let place = self.drive.place(p.drive_uv, course);
        let Some(along) = place.direction else { return (p, kept) };
        let Band { intol, outtol } = self.band;
        let least = self.thick() - within * (intol + outtol);
        let tree = &self.part.tree;
        for _ in 0..REPAIRS {
            let te = p.te - p.normal * p.shift;
            let tool = Tool { profile: self.profile, te, ta: p.ta };
            let Clear::No(seen) = tree.clear(&tool, -least) else { break };
            let from = |part_uv: [f64; 2]| {
                let memory = Some(kept.at(part_uv));
                let other = self.position(p.drive_uv, course, sense, memory, take).ok()?;
                ((other.0.te - p.te).dot(&along) < 0.0).then_some(other)
            };
            let at = |place: &PatchPlace| {
                let [u, v] = place.uv;
                from(self.part.surface.global(place.patch, u, v))
            };
            let deepest = || tree.deepest(&tool, 1e-3 * (intol + outtol)).map(|(place, _)| place);
            let afar = || self.shot(&place, along, p.ta).fall(tree).map(|met| met.uv);
            let found = at(&seen)
                .or_else(|| deepest().and_then(|place| at(&place)))
                .or_else(|| afar().and_then(from));
            match found {
                Some(other) => (p, kept) = other,
                None => break,
            }
        }
        (p, kept)
    }
}
