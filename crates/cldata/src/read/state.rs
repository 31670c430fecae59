//! What a text reader knows between statements: tool position, pending arc, marks, records ready.

use std::collections::VecDeque;
use std::sync::Arc as Shared;

use aptc_diagnostics::{FileId, Origin, Severity, codes};
use aptc_geometry::{Circle, FormKind, Vec3};

use super::arcs::{self, Pending};
use super::report::{Place, Report};
use crate::{Arc, Course, Dialect, Kind, Motion, MotionKind, NameRef, Position, Record, Units};

/// Most positions of one record; a longer motion goes on in another with the same origin and circle.
const MOST_POINTS: usize = 1 << 16;

/// State of a reader.
pub(super) struct State {
    pub(super) dialect: Dialect,
    pub(super) report: Report,
    /// The statement that is read.
    pub(super) at: Place,
    /// The last `$$ LINE` or `$$ ISN`.
    mark: Option<Mark>,
    /// Tool end and axis.
    pub(super) te: Option<Vec3>,
    pub(super) ta: Vec3,
    /// Has an axis been given since the beginning or MULTAX/OFF?
    pub(super) axis_seen: bool,
    /// Did TLAXIS give it, so that it holds?
    pub(super) axis_held: bool,
    pub(super) multax: bool,
    pub(super) units: Option<Units>,
    /// INTOL of the drive surface.
    pub(super) intol: f64,
    pub(super) outtol: f64,
    /// Said of the next motion.
    pub(super) path: Option<(MotionKind, NameRef)>,
    pub(super) pending: Option<Pending>,
    /// ARCSLP, the rise of the next arc; or other arc words between two statements.
    pub(super) direction: Option<Direction>,
    pub(super) psis: Option<aptc_geometry::Plane>,
    pub(super) arcdat: Option<Circle>,
    /// Argument numbers from 1, kinds and, for patterns, lengths of the next post word's forms.
    pub(super) geometry: Vec<(usize, FormKind, usize)>,
    /// Matrix lines of a CATIA header that are still to come, and those read.
    pub(super) matrix: Option<Vec<f64>>,
    /// Control points and knots of an NX spline.
    pub(super) spline: super::spline::Spline,
    pub(super) open: Option<Open>,
    queue: VecDeque<Record>,
    /// Was the last statement a GOTO, so that a line of numbers goes on with it?
    pub(super) in_goto: bool,
    /// Is this such a line?
    pub(super) bare: bool,
    /// The line of a text that ends with `$`, which no reader of texts joins.
    pub(super) text_going_on: Option<u64>,
    /// Between DEFSUB and ENDSUB, and after CALSUB, the place of the tool is not known here: GODLTA stays a
    /// word that the editor makes into motion. The position before DEFSUB.
    pub(super) subprogram: Option<Option<Vec3>>,
    pub(super) called: bool,
    /// A cycle whose points are the bottoms of holes.
    pub(super) bottoms: Option<super::fusion::Cycle>,
    /// The last such cycle while it is off: CYCLE/ON brings it back.
    pub(super) bottoms_off: Option<super::fusion::Cycle>,
}

/// The way of the tool at the start of an arc.
#[derive(Clone, Copy, Debug)]
pub(super) enum Direction {
    /// INDIRV.
    Along(Vec3),
    /// INDIRP.
    Towards(Vec3),
}

/// A line of the part program that what follows comes from.
#[derive(Clone, Debug, Default)]
pub(super) struct Mark {
    pub(super) isn: u32,
    pub(super) line: u32,
    pub(super) file: Option<Shared<str>>,
}

/// A motion that may get more points.
pub(super) struct Open {
    origin: Origin,
    pub(super) motion: Motion,
    /// Position before it.
    start: Option<Vec3>,
    /// Points must lie on this circle to belong to it.
    on: Option<Circle>,
}

impl State {
    pub(super) fn new(dialect: Dialect, file: FileId) -> Self {
        Self {
            dialect,
            report: Report::new(file),
            at: Place::default(),
            mark: None,
            te: None,
            ta: Vec3::z(),
            axis_seen: false,
            axis_held: false,
            multax: false,
            units: None,
            intol: 0.0,
            outtol: 0.0,
            path: None,
            pending: None,
            direction: None,
            psis: None,
            arcdat: None,
            geometry: Vec::new(),
            matrix: None,
            spline: super::spline::Spline::default(),
            open: None,
            queue: VecDeque::new(),
            in_goto: false,
            bare: false,
            text_going_on: None,
            subprogram: None,
            called: false,
            bottoms: None,
            bottoms_off: None,
        }
    }

    /// Where the statement that is read comes from.
    pub(super) fn origin(&self) -> Origin {
        let mut origin = Origin::default();
        self.set_origin(&mut origin);
        origin
    }

    /// Sets an origin without giving up its memory.
    pub(super) fn set_origin(&self, origin: &mut Origin) {
        origin.span = self.at.span(self.report.file());
        origin.trace = None;
        if let Some(mark) = &self.mark {
            (origin.isn, origin.line) = (mark.isn, mark.line);
            if origin.file != mark.file {
                origin.file.clone_from(&mark.file);
            }
        } else {
            origin.isn = 0;
            origin.line = u32::try_from(self.at.line).unwrap_or(u32::MAX);
            origin.file = None;
        }
    }

    /// What follows comes from there.
    pub(super) fn set_mark(&mut self, mark: Mark) {
        self.close();
        self.mark = Some(mark);
    }

    /// Do marks say where statements come from?
    pub(super) fn is_marked(&self) -> bool {
        self.mark.is_some()
    }

    /// Puts out a record that is no motion.
    pub(super) fn emit(&mut self, kind: Kind) {
        self.close();
        let origin = self.origin();
        self.queue.push_back(Record { origin, kind });
    }

    /// The next record that is ready.
    pub(super) fn take_ready(&mut self) -> Option<Record> {
        self.queue.pop_front()
    }

    /// What the next ready record says.
    pub(super) fn next_ready(&self) -> Option<&Kind> {
        self.queue.front().map(|r| &r.kind)
    }

    /// Nothing is said of the next motion, which is to be a record of its own.
    pub(super) fn is_plain(&self) -> bool {
        self.path.is_none()
            && self.pending.is_none()
            && self.mark.is_none()
            && self.open.is_none()
            && self.matrix.is_none()
            && self.spline.is_empty()
            && self.bottoms.is_none()
    }

    /// A plain point can be added to the open motion without a look at circles and marks.
    pub(super) fn takes_points(&self, with_axis: bool) -> bool {
        self.path.is_none()
            && self.pending.is_none()
            && self.bottoms.is_none()
            && self.open.as_ref().is_some_and(|o| {
                o.on.is_none()
                    && o.motion.with_axis == with_axis
                    && o.motion.kind != MotionKind::From
                    && o.motion.points.len() < MOST_POINTS
            })
    }

    /// The axis of a position and whether it is part of the output.
    pub(super) fn axis(&mut self, given: Option<Vec3>) -> (Vec3, bool) {
        if let Some(v) = given {
            let norm = v.norm();
            if !(norm > 0.0 && norm.is_finite()) {
                // No CAM system is known to write it for an upright tool; they leave the axis out, or write 0,0,1.
                let what = "a tool axis of no length";
                self.report.note(self.at, codes::UNREADABLE_CL, Severity::Error, what);
                return (self.ta, true);
            }
            // Printed axes are unit vectors to their last decimal; their digits are kept.
            self.ta = if (norm - 1.0).abs() <= 1e-5 { v } else { v / norm };
            self.axis_seen = true;
            return (self.ta, true);
        }
        let modal = self.axis_held
            || match self.dialect {
                Dialect::Nx | Dialect::Catia => true,
                Dialect::Creo | Dialect::Camworks => false,
                _ => self.multax,
            };
        if !(modal && self.axis_seen) {
            self.ta = Vec3::z();
        }
        (self.ta, self.axis_seen)
    }

    /// A position of the tool.
    pub(super) fn point(&mut self, from: bool, te: Vec3, axis: Option<Vec3>) {
        let (ta, with_axis) = self.axis(axis);
        self.position(from, Position { te, ta }, with_axis);
    }

    pub(super) fn position(&mut self, from: bool, p: Position, with_axis: bool) {
        // Deltas add up; nothing beyond what can be read may come of it.
        if !p.te.iter().all(|x| super::args::is_coordinate(*x)) {
            let help = "look for a wrong exponent in the deltas before";
            return self.report.error(self.at, "a position too far away", help);
        }
        if !self.goes_on(from, p, with_axis) {
            self.start_motion(from, p, with_axis);
        }
        self.te = Some(p.te);
        self.called = false;
    }

    /// DEFSUB, ENDSUB and CALSUB.
    pub(super) fn subprogram_word(&mut self, word: &str) {
        match word {
            "DEFSUB" if self.subprogram.is_none() => self.subprogram = Some(self.te),
            "ENDSUB" => {
                if let Some(before) = self.subprogram.take() {
                    self.te = before;
                }
            }
            "CALSUB" => self.called = true,
            _ => {}
        }
    }

    /// Adds the point to the open motion if it belongs there.
    fn goes_on(&mut self, from: bool, p: Position, with_axis: bool) -> bool {
        if self.path.is_some() || self.pending.is_some() {
            return false;
        }
        let (slack, widest) = (self.slack(), self.widest());
        // A point with a GOTO of its own may end a straight move across the circle.
        let (bare, creo) = (self.bare, self.dialect == Dialect::Creo);
        let Some(open) = &mut self.open else { return false };
        let last = open.motion.points.last().map(|q| q.te);
        let near = |c: &Circle| match last {
            Some(last) if !bare => !creo && arcs::rise(c, last, std::iter::once(p.te)) <= widest,
            _ => true,
        };
        let same = (open.motion.kind == MotionKind::From) == from
            && open.motion.with_axis == with_axis
            && open.motion.points.len() < MOST_POINTS
            && open
                .on
                .is_none_or(|c| arcs::off_circle(&c, p.te).abs() <= slack * c.radius && near(&c));
        if same {
            open.motion.points.push(p);
        } else if open.motion.points.len() >= MOST_POINTS {
            // The rest of a long motion is part of the same one.
            let (kind, name) = (open.motion.kind, open.motion.name.clone());
            let arc = open.motion.arc;
            self.path = Some((kind, name));
            if let Some(arc) = arc {
                let (circle, to_mark) = (arc.circle, open.on.is_none());
                self.pending = Some(Pending::Points { circle, to_mark });
            }
        }
        same
    }

    /// How far from its circle a point may lie and still belong to it, in radii.
    fn slack(&self) -> f64 {
        2e-4
    }

    fn start_motion(&mut self, from: bool, p: Position, with_axis: bool) {
        self.close();
        let plain = if from { MotionKind::From } else { MotionKind::Goto };
        let (kind, name) = self.path.take().unwrap_or((plain, NameRef::default()));
        let mut motion = Motion { kind, name, with_axis, ..Motion::default() };
        let mut on = None;
        match self.pending.take() {
            Some(Pending::Points { circle, to_mark }) => {
                let free = to_mark && self.mark.is_some();
                let off = arcs::off_circle(&circle, p.te).abs();
                if free || self.lies_on(&circle, off) {
                    motion.arc = Some(Arc { circle, course: Course::Chords });
                    on = (!free).then_some(circle);
                }
            }
            Some(Pending::End { center, axis, radius, turns, sweep }) => {
                motion.arc = self.arc_to(p.te, center, axis, radius, turns, sweep);
            }
            None => {}
        }
        motion.points.push(p);
        let origin = self.origin();
        let closed = matches!(motion.arc, Some(Arc { course: Course::Sweep(_), .. }));
        if (self.mark.is_some() || on.is_some()) && !closed {
            self.open = Some(Open { origin, motion, start: self.te, on });
        } else {
            self.queue.push_back(Record { origin, kind: Kind::Motion(motion) });
        }
    }

    /// The arc from here to `end`.
    fn arc_to(
        &mut self,
        end: Vec3,
        center: Vec3,
        axis: Vec3,
        radius: Option<f64>,
        turns: u32,
        sweep: Option<f64>,
    ) -> Option<Arc> {
        let Some(axis) = super::comments::unit(axis) else {
            self.report.error(self.at, "an arc without an axis", "give a vector that is not zero");
            return None;
        };
        let mut circle = Circle { center, axis, radius: radius.map_or(0.0, f64::abs) };
        let Some(start) = self.te else {
            if radius.is_some()
                && let Some(sweep) = sweep
            {
                return Some(Arc { circle, course: Course::Sweep(sweep) });
            }
            let what = "an arc before the tool has a position";
            self.report.error(self.at, what, "give the start with FROM or GOTO");
            return None;
        };
        if radius.is_none() {
            circle.radius = arcs::off_circle(&circle, start);
        }
        if circle.radius <= 0.0 {
            self.report.error(self.at, "an arc of radius 0", "the centre may be wrong");
            return None;
        }
        let off = arcs::off_circle(&circle, start).abs().max(arcs::off_circle(&circle, end).abs());
        if !self.lies_on(&circle, off) {
            return None;
        }
        let fits = off <= self.loose(&circle);
        let shortest = arcs::sweep(center, axis, start, end);
        let sweep = sweep.unwrap_or(shortest + 360.0 * f64::from(turns));
        // Some posts state the plane's axis for both senses; then only the angle tells them apart.
        let left = arcs::apart(sweep, shortest) <= 1.0;
        if fits && !left && arcs::apart(sweep, 360.0 - shortest) < 1.0 {
            let what = "an arc whose angle fits only the other sense of rotation; it is turned";
            self.report.note(self.at, codes::CL_VALUE, Severity::Warning, what);
            circle.axis = -circle.axis;
        }
        Some(Arc { circle, course: Course::Sweep(sweep) })
    }

    /// Beyond this a start or end is said to lie off its circle.
    fn loose(&self, circle: &Circle) -> f64 {
        10.0 * self.slack() * circle.radius
    }

    /// Can an arc begin or end `off` this circle? What lies off by half the radius belongs to another circle.
    fn lies_on(&mut self, circle: &Circle, off: f64) -> bool {
        let possible = off < 0.5 * circle.radius;
        if !possible {
            let what =
                "an arc whose start or end is nowhere near its circle; the tool goes straight";
            self.report.error(self.at, what, "check centre, radius and both ends");
        } else if off > self.loose(circle) {
            let what = "the start or end of an arc does not lie on its circle";
            self.report.note(self.at, codes::ARC_OFF_CIRCLE, Severity::Warning, what);
        }
        possible
    }

    /// Ends the open motion.
    pub(super) fn close(&mut self) {
        let Some(mut open) = self.open.take() else { return };
        // A circle and one point: the arc goes there right-handed about the circle's axis.
        if let (Some(circle), [end], Some(start)) = (open.on, &*open.motion.points, open.start) {
            let angle = arcs::sweep(circle.center, circle.axis, start, end.te);
            let off = arcs::off_circle(&circle, start).abs();
            open.motion.arc =
                self.lies_on(&circle, off).then_some(Arc { circle, course: Course::Sweep(angle) });
        }
        if let (Some(circle), Some(start), [_, _, ..]) = (open.on, open.start, &*open.motion.points)
            && let Some(parts) = self.parts(circle, start, &open.motion)
        {
            let record = |m| Record { origin: open.origin.clone(), kind: Kind::Motion(m) };
            self.queue.extend(parts.into_iter().map(record));
            return;
        }
        self.queue.push_back(Record { origin: open.origin, kind: Kind::Motion(open.motion) });
    }

    /// Greatest distance of an arc from what can be one of its chords: twice the tolerance that is stated, at
    /// least 50 micrometres.
    fn widest(&self) -> f64 {
        let stated = 2.0 * (self.intol + self.outtol);
        stated.max(0.05 / self.units.unwrap_or_default().mm())
    }

    /// Points too far apart to be ends of chords (Creo's ARC_ONLY gives a few on each arc): an arc to each.
    fn parts(&self, circle: Circle, start: Vec3, motion: &Motion) -> Option<Vec<Motion>> {
        let widest = self.widest();
        let points = || motion.points.iter().map(|p| p.te);
        if arcs::rise(&circle, start, points()) <= widest {
            return None;
        }
        let axis = arcs::sense(&circle, start, points())?;
        let mut from = start;
        let part = |p: &Position| {
            let sweep = arcs::sweep(circle.center, axis, from, p.te);
            from = p.te;
            let arc = Arc { circle: Circle { axis, ..circle }, course: Course::Sweep(sweep) };
            Motion { arc: Some(arc), points: vec![*p], ..head(motion) }
        };
        Some(motion.points.iter().map(part).collect())
    }

    /// End of the stream.
    pub(super) fn end(&mut self) {
        self.close();
    }
}

impl State {
    /// Several positions of one motion.
    pub(super) fn run(&mut self, points: Vec<Position>, with_axis: bool) {
        let Some(last) = points.last() else { return };
        self.te = Some(last.te);
        let (kind, name) = self.path.take().unwrap_or_default();
        let motion = Motion { kind, name, points, with_axis, ..Motion::default() };
        self.emit(Kind::Motion(motion));
    }
}

/// The motion without its positions.
fn head(m: &Motion) -> Motion {
    let Motion { kind, ref name, with_axis, .. } = *m;
    Motion { kind, name: name.clone(), with_axis, ..Motion::default() }
}
