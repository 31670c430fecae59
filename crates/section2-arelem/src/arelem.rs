//! The dispatcher (APT: `SECTN2`): passes records on, keeps the modal words, runs the motions.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_diagnostics::{Diagnostic, Origin};
use aptc_geometry::Vec3;
use aptc_protap as protap;
use aptc_protap::{
    Direction, DriveSide, Kind, Outcome, PartSide, Relation, Sense, SurfaceRef, ToolAxis,
};

use crate::failure::Failure;
use crate::forward::{self, forward};
use crate::plane;
use crate::pocket;
use crate::scene::{Check, Path, Scene, Start, Wall};
use crate::state::{Given, Part, Role, Settings, Tool, plane_ref};
use crate::tool::Shape;

/// Settings of Section 2 that no part program gives.
#[derive(Clone, Debug, Default)]
pub struct Options {}

/// Section 2: takes PROTAP records in order and gives CL records.
///
/// ```
/// use aptc_arelem::{Arelem, Options};
/// use aptc_protap::{Kind, Outcome, Place, Record};
/// let place = Place { name: Default::default(), point: [1.0, 2.0, 3.0].into(), axis: None };
/// let record = Record { origin: Default::default(), kind: Kind::From(place) };
/// let (mut arelem, mut cl) = (Arelem::new(Options::default()), Vec::new());
/// let outcome = arelem.execute(&record, &mut cl);
/// assert!(matches!(outcome, Outcome::Moved { te, .. } if te.z == 3.0));
/// assert_eq!(cl.len(), 1);
/// ```
#[derive(Debug, Default)]
pub struct Arelem {
    settings: Settings,
    tool: Option<Tool>,
    /// The last motion failed: the position is unknown until FROM or GOTO.
    poisoned: bool,
    /// A motion that waits for its check surface, and the records since.
    pending: Option<Box<(Origin, protap::Drive)>>,
    deferred: Vec<protap::Record>,
    diagnostics: Vec<Diagnostic>,
}

impl Arelem {
    /// A Section 2 at the start of a part program.
    pub fn new(_options: Options) -> Self {
        Self::default()
    }

    /// Executes one record; what it gives is appended to `out`.
    pub fn execute(&mut self, record: &protap::Record, out: &mut Vec<cl::Record>) -> Outcome {
        if self.pending.is_none() {
            return self.step(record, out);
        }
        match &record.kind {
            Kind::Drive(next) => {
                let done = self.resolve(Some(next), out);
                let outcome = self.step(record, out);
                if done == Outcome::Failed { done } else { outcome }
            }
            kind if needs_position(kind) => {
                self.resolve(None, out);
                self.step(record, out)
            }
            _ => {
                self.deferred.push(record.clone());
                Outcome::None
            }
        }
    }

    /// The part program is over: a motion that still waits for its check surface fails.
    pub fn finish(&mut self, out: &mut Vec<cl::Record>) {
        if self.pending.is_some() {
            self.resolve(None, out);
        }
    }

    /// The diagnostics since the last call.
    pub fn take_diagnostics(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.diagnostics)
    }

    /// Runs the waiting motion with the check surface that `next` implies, then the records since.
    fn resolve(&mut self, next: Option<&protap::Drive>, out: &mut Vec<cl::Record>) -> Outcome {
        let Some(waiting) = self.pending.take() else { return Outcome::None };
        let (origin, mut drive) = *waiting;
        let deferred = std::mem::take(&mut self.deferred);
        let side = deferred
            .iter()
            .rev()
            .find_map(|r| match r.kind {
                Kind::DriveSide(s) => Some(s),
                _ => None,
            })
            .unwrap_or(self.settings.drive_side);
        let outcome = match next.and_then(|n| implied(n, side)) {
            Some(check) => {
                drive.checks.push(check);
                self.drive(&origin, &drive, out)
            }
            None => self.fail(&origin, &Failure::NoCheck { word: drive.direction }),
        };
        for record in &deferred {
            self.step(record, out);
        }
        outcome
    }

    fn step(&mut self, record: &protap::Record, out: &mut Vec<cl::Record>) -> Outcome {
        let origin = &record.origin;
        if let Some(kind) = forward(&record.kind) {
            out.push(cl::Record { origin: origin.clone(), kind });
        }
        match &record.kind {
            Kind::From(p) => self.place(origin, p, cl::MotionKind::From, out),
            Kind::Goto(p) => self.place(origin, p, cl::MotionKind::Goto, out),
            Kind::Points { name, points } => self.points(origin, name, points, out),
            Kind::GoDelta(v) => self.by(origin, *v, out),
            Kind::GoDeltaAxis(d) => {
                let v = self.tool.map_or_else(Vec3::zeros, |t| t.ta * *d);
                self.by(origin, v, out)
            }
            Kind::Go(go) => self.start(origin, go, out),
            Kind::Drive(d) if d.checks.is_empty() && !self.poisoned => {
                if matches!(d.direction, Direction::Goup | Direction::Godown) {
                    return self.fail(origin, &Failure::NoCheck { word: d.direction });
                }
                self.pending = Some(Box::new((origin.clone(), d.clone())));
                Outcome::None
            }
            Kind::Drive(d) => self.drive(origin, d, out),
            Kind::Failed => {
                self.poisoned = true;
                Outcome::Failed
            }
            Kind::Pocket(p) => self.pocket(origin, p, out),
            Kind::Cut(on) => {
                self.cut(origin, *on, out);
                Outcome::None
            }
            kind => {
                self.set(kind);
                Outcome::None
            }
        }
    }

    /// Modal words.
    fn set(&mut self, kind: &Kind) {
        let s = &mut self.settings;
        match kind {
            Kind::Units(u) => s.units = *u,
            Kind::Cutter(c) => s.cutter = Some(*c),
            Kind::CutterOption { surface, disk } => s.set_disk(*surface, *disk),
            Kind::Intol(t) => s.set_intol(*t),
            Kind::Outtol(t) => s.set_outtol(*t),
            Kind::Thick(t) => s.thick = *t,
            Kind::Multax(on) => s.multax = *on,
            Kind::ToolAxis(a) => {
                let kept = ToolAxis::Fixed(self.tool.map_or_else(Vec3::z, |t| t.ta));
                s.set_axis(if matches!(a, ToolAxis::Keep) { kept } else { a.clone() });
                if let (ToolAxis::Fixed(v), Some(t)) = (&s.axis, &mut self.tool) {
                    t.ta = unit(*v).unwrap_or(t.ta);
                }
            }
            Kind::PartSurface(p) => {
                s.part = Part::Surface(p.clone());
                s.nops = false;
            }
            Kind::Autops => {
                s.nops = false;
                s.part = match &self.tool {
                    Some(t) if !self.poisoned => Part::Surface(plane_ref(t.ta, t.ta.dot(&t.te))),
                    _ => Part::Auto,
                };
            }
            Kind::Nops => s.nops = true,
            Kind::DriveSide(d) => s.drive_side = *d,
            Kind::PartSide(p) => s.part_side = *p,
            Kind::SurfaceNormals(v) => s.normals.clone_from(v),
            Kind::Sense(sense) => {
                s.given = Some(match sense {
                    Sense::Vector(v) => Given::Vectors(v.clone()),
                    Sense::Point(p) => Given::Points(p.clone()),
                });
                if let Some(t) = &mut self.tool {
                    let first = match sense {
                        Sense::Vector(v) => v.iter().flatten().next().copied(),
                        Sense::Point(p) => p.iter().flatten().next().map(|p| p - t.te),
                    };
                    if let Some(f) = first.and_then(unit) {
                        t.forward = f;
                    }
                }
            }
            _ => {}
        }
    }

    fn fail(&mut self, origin: &Origin, failure: &Failure) -> Outcome {
        self.diagnostics.push(failure.explain(origin));
        self.poisoned = true;
        Outcome::Failed
    }

    /// FROM and GOTO.
    fn place(
        &mut self,
        origin: &Origin,
        place: &protap::Place,
        kind: cl::MotionKind,
        out: &mut Vec<cl::Record>,
    ) -> Outcome {
        if let Some(axis) = place.axis.and_then(unit) {
            self.settings.set_axis(ToolAxis::Fixed(axis));
            if let Some(t) = &mut self.tool {
                t.ta = axis;
            }
        }
        self.go_to(place.point);
        if kind == cl::MotionKind::From {
            // Nothing moved: there is no direction yet but one given before.
            let given = self.settings.given.clone();
            if let (Some(Given::Vectors(v)), Some(t)) = (given, &mut self.tool) {
                t.forward = v.into_iter().flatten().next().and_then(unit).unwrap_or(t.forward);
            }
        } else {
            self.settings.given = None;
        }
        self.put(origin, kind, forward::name(&place.name), vec![place.point], out);
        self.moved(0)
    }

    fn points(
        &mut self,
        origin: &Origin,
        name: &protap::NameRef,
        points: &[Vec3],
        out: &mut Vec<cl::Record>,
    ) -> Outcome {
        for p in points {
            self.go_to(*p);
        }
        if points.is_empty() {
            return Outcome::None;
        }
        self.settings.given = None;
        self.put(origin, cl::MotionKind::Goto, forward::name(name), points.to_vec(), out);
        self.moved(0)
    }

    /// GODLTA.
    fn by(&mut self, origin: &Origin, v: Vec3, out: &mut Vec<cl::Record>) -> Outcome {
        if self.poisoned {
            return Outcome::Failed;
        }
        let Some(tool) = self.tool else { return self.fail(origin, &Failure::NoPosition) };
        let te = tool.te + v;
        self.go_to(te);
        self.settings.given = None;
        self.put(origin, cl::MotionKind::Goto, cl::NameRef::default(), vec![te], out);
        self.moved(0)
    }

    /// Puts the tool there.
    fn go_to(&mut self, te: Vec3) {
        let fixed = match &self.settings.axis {
            ToolAxis::Fixed(v) => unit(*v),
            _ => None,
        };
        match &mut self.tool {
            Some(t) => {
                t.turn(te - t.te);
                t.te = te;
            }
            None => {
                let ta = fixed.unwrap_or_else(Vec3::z);
                self.tool = Some(Tool { te, ta, forward: Vec3::zeros() });
            }
        }
        self.poisoned = false;
    }

    fn moved(&self, check: usize) -> Outcome {
        self.tool.map_or(Outcome::None, |t| Outcome::Moved { te: t.te, ta: t.ta, check })
    }

    fn put(
        &self,
        origin: &Origin,
        kind: cl::MotionKind,
        name: cl::NameRef,
        points: Vec<Vec3>,
        out: &mut Vec<cl::Record>,
    ) {
        let ta = self.tool.map_or_else(Vec3::z, |t| t.ta);
        let points = points.into_iter().map(|te| cl::Position { te, ta }).collect();
        let with_axis = self.settings.multax;
        let motion = cl::Motion { kind, name, arc: None, points, with_axis, control: None };
        self.put_motion(origin, motion, out);
    }

    fn put_motion(&self, origin: &Origin, motion: cl::Motion, out: &mut Vec<cl::Record>) {
        if self.settings.cut {
            out.push(cl::Record { origin: origin.clone(), kind: cl::Kind::Motion(motion) });
        }
    }

    /// CUT and DNTCUT: after DNTCUT, CUT puts out where the tool is.
    fn cut(&mut self, origin: &Origin, on: bool, out: &mut Vec<cl::Record>) {
        let again = on && !self.settings.cut;
        self.settings.cut = on;
        if let (true, false, Some(t)) = (again, self.poisoned, self.tool) {
            self.put(origin, cl::MotionKind::Goto, cl::NameRef::default(), vec![t.te], out);
        }
        let output = if on { cl::Output::Cut } else { cl::Output::Dntcut };
        out.push(cl::Record { origin: origin.clone(), kind: cl::Kind::Output(output) });
    }

    /// GO and OFFSET.
    fn start(&mut self, origin: &Origin, go: &protap::Go, out: &mut Vec<cl::Record>) -> Outcome {
        if self.poisoned {
            return Outcome::Failed;
        }
        let Some(tool) = self.tool else { return self.fail(origin, &Failure::NoPosition) };
        let roles = [Role::Drive, Role::Part, Role::Check];
        let surfaces: Vec<(Relation, Wall)> = go
            .surfaces
            .iter()
            .zip(roles)
            .map(|((relation, surface), role)| {
                (*relation, self.wall(surface, role, *relation == Relation::On))
            })
            .collect();
        let part = (surfaces.len() < 2 && !self.settings.nops).then(|| {
            let on = self.settings.part_side == PartSide::Tlonps;
            let relation = if on { Relation::On } else { Relation::To };
            (relation, self.wall(&self.part(&tool), Role::Part, on))
        });
        let along = match self.settings.given.take() {
            None => Vec::new(),
            Some(Given::Vectors(v)) => v.into_iter().map(|v| v.and_then(unit)).collect(),
            Some(Given::Points(p)) => {
                p.into_iter().map(|p| p.and_then(|p| unit(p - tool.te))).collect()
            }
        };
        let normals = std::mem::take(&mut self.settings.normals);
        let start = Start { tool, offset: go.offset, surfaces, part, along, normals };
        let result = match self.check_start(&start) {
            Some(f) => Err(f),
            None => plane::start(&start)
                .unwrap_or_else(|| Err(Failure::Unsupported { what: "this start-up".into() })),
        };
        let path = match result {
            Ok(path) => path,
            Err(f) => return self.fail(origin, &f),
        };
        if let Some((_, surface)) = go.surfaces.get(1) {
            self.settings.part = Part::Surface(surface.clone());
            self.settings.nops = false;
        }
        let name = go.surfaces.first().map(|(_, s)| forward::name(&s.name)).unwrap_or_default();
        self.arrive(origin, cl::MotionKind::Startup, name, path, out)
    }

    /// POCKET: three feeds, the plunge, the general passes from the inside out, the finish pass.
    fn pocket(
        &mut self,
        origin: &Origin,
        p: &protap::Pocket,
        out: &mut Vec<cl::Record>,
    ) -> Outcome {
        if self.poisoned {
            return Outcome::Failed;
        }
        let Some(tool) = self.tool else { return self.fail(origin, &Failure::NoPosition) };
        let passes = match pocket::passes(p, &self.settings, &tool) {
            Ok(passes) => passes,
            Err(why) => return self.fail(origin, &Failure::Pocket { why }),
        };
        let general: Vec<Vec3> = passes[..passes.len() - 1].iter().flatten().copied().collect();
        let finish = passes.last().cloned().unwrap_or_default();
        let all = [general, finish].concat();
        let split = all.len() - passes.last().map_or(0, Vec::len);
        let parts = [&all[..1], &all[1..split.max(1)], &all[split.max(1)..]];
        for (points, feed) in parts.into_iter().zip(p.feeds) {
            if points.is_empty() {
                continue;
            }
            let args = vec![cl::Arg::Number(feed)];
            let kind = cl::Kind::Post { word: "FEDRAT".into(), args };
            out.push(cl::Record { origin: origin.clone(), kind });
            for p in points {
                self.go_to(*p);
            }
            let name = cl::NameRef { name: "POCKET".into(), subscript: 0 };
            self.put(origin, cl::MotionKind::Goto, name, points.to_vec(), out);
        }
        self.settings.given = None;
        self.moved(0)
    }

    fn check_start(&self, start: &Start) -> Option<Failure> {
        for (relation, wall) in start.surfaces.iter().chain(&start.part) {
            if !wall.is_surface() {
                return Some(Failure::NotASurface { surface: wall.surface.clone() });
            }
            if *relation != Relation::On && wall.shape == Shape::Point {
                return Some(Failure::NoCutter { surface: wall.surface.clone() });
            }
        }
        None
    }

    /// Motion along surfaces.
    fn drive(&mut self, origin: &Origin, d: &protap::Drive, out: &mut Vec<cl::Record>) -> Outcome {
        if self.poisoned {
            return Outcome::Failed;
        }
        let Some(tool) = self.tool else { return self.fail(origin, &Failure::NoPosition) };
        self.settings.given = None;
        let side = self.settings.drive_side;
        let on = matches!(side, DriveSide::Tlon | DriveSide::Tlndon);
        let checks = d.checks.iter().enumerate().map(|(i, c)| {
            let role = if i == 0 { Role::Check } else { Role::SecondCheck };
            let on_check = c.relation == Relation::On || (on && c.relation == Relation::Tanto);
            let wall = self.wall(&c.surface, role, on_check);
            Check { wall, relation: c.relation, nth: c.nth }
        });
        let scene = Scene {
            tool,
            direction: d.direction,
            drive: self.wall(&d.drive, Role::Drive, on),
            side,
            part: self.wall(
                &self.part(&tool),
                Role::Part,
                self.settings.part_side == PartSide::Tlonps,
            ),
            checks: checks.collect(),
        };
        let result = match check_scene(&scene) {
            Some(f) => Err(f),
            None => plane::run(&scene).unwrap_or_else(|| {
                Err(Failure::Unsupported { what: "motion along these surfaces".into() })
            }),
        };
        match result {
            Ok(path) => {
                let name = forward::name(&d.drive.name);
                self.arrive(origin, cl::MotionKind::Continuous, name, path, out)
            }
            Err(f) => self.fail(origin, &f),
        }
    }

    fn arrive(
        &mut self,
        origin: &Origin,
        kind: cl::MotionKind,
        name: cl::NameRef,
        path: Path,
        out: &mut Vec<cl::Record>,
    ) -> Outcome {
        if let (Some(end), Some(tool)) = (path.points.last(), &mut self.tool) {
            tool.te = end.te;
            tool.ta = end.ta;
            tool.turn(path.forward);
        }
        let motion = cl::Motion {
            kind,
            name,
            arc: path.arc,
            points: path.points,
            with_axis: self.settings.multax,
            control: Some(Arc::new(path.control)),
        };
        self.put_motion(origin, motion, out);
        self.moved(path.check)
    }

    /// The part surface in force, with AUTOPS laid through the tool.
    fn part(&self, tool: &Tool) -> SurfaceRef {
        match &self.settings.part {
            Part::Surface(s) => s.clone(),
            Part::Auto => plane_ref(tool.ta, tool.ta.dot(&tool.te)),
        }
    }

    fn wall(&self, surface: &SurfaceRef, role: Role, on: bool) -> Wall {
        let s = &self.settings;
        let disk = match role {
            Role::Part => s.part_disk,
            Role::Drive => s.drive_disk,
            Role::Check | Role::SecondCheck => None,
        };
        Wall {
            surface: surface.clone(),
            shape: Shape::of(s.cutter, disk),
            on,
            thick: if on { 0.0 } else { s.thick(role) },
            band: s.band(role),
        }
    }
}

/// Must the tool have come to rest before this record?
fn needs_position(kind: &Kind) -> bool {
    matches!(
        kind,
        Kind::From(_)
            | Kind::Goto(_)
            | Kind::Points { .. }
            | Kind::GoDelta(_)
            | Kind::GoDeltaAxis(_)
            | Kind::Go(_)
            | Kind::Pocket(_)
            | Kind::Failed
            | Kind::Cut(true)
            | Kind::Fini
    )
}

/// The check surface that the next motion implies: tangent where it goes on forward or back, else on the
/// side of it from which it goes on.
fn implied(next: &protap::Drive, side: DriveSide) -> Option<protap::Check> {
    let relation = match (next.direction, side) {
        (Direction::Gofwd | Direction::Goback, _) => Relation::Tanto,
        (Direction::Golft | Direction::Gorgt, DriveSide::Tlon | DriveSide::Tlndon) => Relation::On,
        (Direction::Golft, DriveSide::Tllft) | (Direction::Gorgt, DriveSide::Tlrgt) => Relation::To,
        (Direction::Golft, DriveSide::Tlrgt) | (Direction::Gorgt, DriveSide::Tllft) => {
            Relation::Past
        }
        (Direction::Goup | Direction::Godown, _) => return None,
    };
    Some(protap::Check { relation, nth: 1, surface: next.drive.clone(), branch: false })
}

fn check_scene(scene: &Scene) -> Option<Failure> {
    let all = [&scene.drive, &scene.part].into_iter().chain(scene.checks.iter().map(|c| &c.wall));
    for wall in all {
        if !wall.is_surface() {
            return Some(Failure::NotASurface { surface: wall.surface.clone() });
        }
    }
    let touching = |w: &&Wall| !w.on && w.shape == Shape::Point;
    let mut solid = std::iter::once(&scene.drive).chain(scene.checks.iter().map(|c| &c.wall));
    solid.find(touching).map(|w| Failure::NoCutter { surface: w.surface.clone() })
}

fn unit(v: Vec3) -> Option<Vec3> {
    let l = v.norm();
    (l > 0.0 && l.is_finite()).then(|| v / l)
}
