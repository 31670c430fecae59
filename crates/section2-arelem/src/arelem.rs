//! The dispatcher (APT: `SECTN2`): passes records on, keeps the modal words, runs the motions.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::{Cutter, Vec3};
use aptc_protap as protap;
use aptc_protap::{Direction, DriveSide, Kind, Outcome, PartSide, Relation, Sense, ToolAxis};

use crate::diagram::Situation;
use crate::failure::Failure;
use crate::feed::Feed;
use crate::fitted::Fitted;
use crate::forward::forward;
use crate::points::put_feed;
use crate::since::Since;
use crate::state::{Part, Settings, Tool, auto_part, unit};
use crate::warning::{never_cut, no_band, no_multax};

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
    pub(crate) settings: Settings,
    pub(crate) tool: Option<Tool>,
    /// What the motion that brought the tool there was held to, where it was along surfaces, and with which cutter.
    pub(crate) ended: Option<(Arc<cl::Control>, Option<Cutter>)>,
    /// The last motion failed: the position is unknown until FROM or GOTO.
    pub(crate) poisoned: bool,
    /// Was there a statement that could not be translated?
    pub(crate) failed_before: bool,
    /// Is it told, since the last CUTTER, that there is none?
    told_no_cutter: bool,
    /// A motion that waits for its check surface, and the records since.
    pending: Option<Box<(Origin, protap::Drive)>>,
    deferred: Vec<protap::Record>,
    pub(crate) feed: Feed,
    pub(crate) fitted: Fitted,
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// DNTCUT without CUT since, and how many motions are not put out.
    pub(crate) silent: Option<(Origin, u64)>,
    /// What was given since the last motion along surfaces.
    pub(crate) since: Since,
    /// The first motion that failed.
    pub(crate) situation: Option<Situation>,
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

    /// The part program is over: a motion that still waits for its check surface fails, and motions for which no CUT came are told.
    pub fn finish(&mut self, out: &mut Vec<cl::Record>) {
        if self.pending.is_some() {
            self.resolve(None, out);
        }
        if let Some((origin, n @ 1..)) = self.silent.take() {
            self.diagnostics.push(never_cut(&origin, n));
        }
    }

    /// Another part of Section 2 moved the tool: it stands at `te` with the axis `ta`, and the last cut
    /// vector was `along` (zero when there was none). `None`: that motion failed, and the position is
    /// unknown until FROM or GOTO.
    pub fn stand(&mut self, place: Option<(Vec3, Vec3, Vec3)>) {
        let Some((te, ta, along)) = place else {
            self.poisoned = true;
            return;
        };
        let before = self.tool;
        let mut tool = before.unwrap_or(Tool::at(te, ta));
        (tool.te, tool.ta, tool.stood) = (te, ta, None);
        self.ended = None;
        tool.turn(along);
        self.tool = Some(tool);
        self.poisoned = false;
    }

    /// The diagnostics since the last call.
    pub fn take_diagnostics(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.diagnostics)
    }

    /// The situation in which the first motion failed.
    pub fn take_situation(&mut self) -> Option<Situation> {
        self.situation.take()
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
            .or(self.settings.drive_side);
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
        match forward(&record.kind) {
            Some(cl::Kind::Post { word, args }) if word == "FEDRAT" => {
                self.take_feed(origin, args, out);
            }
            Some(kind) => out.push(cl::Record { origin: origin.clone(), kind }),
            None => {}
        }
        if matches!(
            record.kind,
            Kind::From(_)
                | Kind::Goto(_)
                | Kind::Points { .. }
                | Kind::GoDelta(_)
                | Kind::GoDeltaAxis(_)
                | Kind::Pocket(_)
                | Kind::Regional { .. }
        ) {
            self.settings.started = None;
        }
        if matches!(record.kind, Kind::Go(_) | Kind::Drive(_)) {
            self.tell_no_band(origin);
        }
        let outcome = match &record.kind {
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
                // The motion that they were given for.
                self.settings.given.clear();
                self.settings.normals.clear();
                self.poisoned = true;
                self.failed_before = true;
                Outcome::Failed
            }
            Kind::Pocket(p) => self.pocket(origin, p, out),
            Kind::Cut(on) => {
                self.cut(origin, *on, out);
                Outcome::None
            }
            kind => {
                self.set(kind, origin.line);
                Outcome::None
            }
        };
        self.tell_no_multax(origin);
        outcome
    }

    /// Says once that the tool leans and the CL data do not have its axis.
    fn tell_no_multax(&mut self, origin: &Origin) {
        let leaning = |t: Tool| t.ta.z < 1.0 - 1e-9;
        if !self.settings.multax
            && self.tool.is_some_and(leaning)
            && !std::mem::replace(&mut self.settings.multax_told, true)
        {
            self.diagnostics.push(no_multax(origin));
        }
    }

    /// Says once for each pair of INTOL and OUTTOL that leave no band which one is taken.
    fn tell_no_band(&mut self, origin: &Origin) {
        if let Some(least) = self.settings.untold_least() {
            self.diagnostics.push(no_band(origin, least));
        }
    }

    /// Modal words of a statement of that line.
    fn set(&mut self, kind: &Kind, line: u32) {
        let s = &mut self.settings;
        match kind {
            Kind::Cutter(c) if s.cutter != Some(*c) => self.since.cutter = Some(line),
            Kind::Thick(t) if differs(&s.thick, t) => self.since.thick = Some(line),
            _ => {}
        }
        match kind {
            Kind::Units(u) => s.units = *u,
            Kind::Cutter(c) => {
                s.set_cutter(*c, line);
                self.told_no_cutter = false;
            }
            Kind::CutterOption { surface, disk } => s.set_disk(*surface, *disk),
            Kind::Intol(t) => s.set_intol(*t),
            Kind::Outtol(t) => s.set_outtol(*t),
            Kind::Thick(t) => (s.thick, s.thick_told) = (*t, false),
            Kind::Maxdp { step, length } => s.set_maxdp(*step, *length),
            Kind::Numpts(n) => s.numpts = Some(*n),
            Kind::Calc(d) => s.calc = *d,
            Kind::Multax(on) => s.multax = *on,
            Kind::ToolAxis(a) => {
                let kept = ToolAxis::Fixed(self.tool.map_or_else(Vec3::z, |t| t.ta));
                s.set_axis(if matches!(a, ToolAxis::Keep) { kept } else { a.clone() });
                if let (ToolAxis::Fixed(v), Some(t)) = (&s.axis, &mut self.tool) {
                    t.stood.get_or_insert(t.ta);
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
                    Some(t) if !self.poisoned => Part::Surface(auto_part(t.te, t.ta)),
                    _ => Part::Auto,
                };
            }
            Kind::Nops => s.nops = true,
            Kind::DriveSide(d) => (s.drive_side, s.astray_told) = (Some(*d), false),
            Kind::PartSide(p) => {
                s.part_side = Some(*p);
                s.ends_on_part = *p == PartSide::Tlonps;
            }
            Kind::SurfaceNormals(v) => s.normals.clone_from(v),
            Kind::Sense(sense) => {
                // A point is a direction from where the tool stands now, whatever moves it before the next motion.
                let here = self.tool.map_or_else(Vec3::zeros, |t| t.te);
                s.given = match sense {
                    Sense::Vector(v) => v.clone(),
                    Sense::Point(p) => p.iter().map(|p| p.map(|p| p - here)).collect(),
                };
                if let (Some(f), Some(t)) = (s.given.iter().flatten().next(), &mut self.tool) {
                    t.sense(*f);
                }
            }
            _ => {}
        }
    }

    pub(crate) fn fail(&mut self, origin: &Origin, failure: &Failure) -> Outcome {
        // A CUTTER that could not be translated was told of, and that there is none is told once.
        let told = matches!(failure, Failure::NoCutter { .. })
            && (std::mem::replace(&mut self.told_no_cutter, true) || self.failed_before);
        if !told {
            let told = failure.explain(origin);
            let notes = self.changed_since(failure);
            self.diagnostics.push(notes.into_iter().fold(told, Diagnostic::note));
        }
        self.give_up()
    }

    /// A FEDRAT, less what it says of slow-downs.
    pub(crate) fn take_feed(
        &mut self,
        origin: &Origin,
        args: Vec<cl::Arg>,
        out: &mut Vec<cl::Record>,
    ) {
        match self.feed.take(&args) {
            Ok(Some(args)) => put_feed(origin, args, out),
            Ok(None) => {}
            Err(bad) => self.diagnostics.push(
                Diagnostic::error(codes::SLOW_DOWN, origin.span, format!("FEDRAT {}", bad.what))
                    .within(origin.trace.clone())
                    .help(bad.help),
            ),
        }
    }

    /// Nothing moves before the tool has a position again.
    pub(crate) fn give_up(&mut self) -> Outcome {
        self.poisoned = true;
        Outcome::Failed
    }

    /// The outcome of a motion.
    pub(crate) fn moved(&mut self, check: usize) -> Outcome {
        if let Some((_, n)) = &mut self.silent {
            *n += 1;
        }
        self.stands(check)
    }

    /// Where the tool is.
    pub(crate) fn stands(&self, check: usize) -> Outcome {
        self.tool.map_or(Outcome::None, |t| Outcome::Moved { te: t.te, ta: t.ta, check })
    }

    pub(crate) fn put(
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

    pub(crate) fn put_motion(
        &self,
        origin: &Origin,
        motion: cl::Motion,
        out: &mut Vec<cl::Record>,
    ) {
        if self.settings.cut {
            out.push(cl::Record { origin: origin.clone(), kind: cl::Kind::Motion(motion) });
        }
    }
}

fn differs(a: &[f64; 4], b: &[f64; 4]) -> bool {
    a.iter().zip(b).any(|(a, b)| (a - b).abs() > 0.0)
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
            | Kind::Regional { .. }
            | Kind::Failed
            | Kind::Cut(true)
            | Kind::Fini
    )
}

/// The check surface that the next motion implies: tangent where it goes on forward or back, else on the
/// side of it from which it goes on.
fn implied(next: &protap::Drive, side: Option<DriveSide>) -> Option<protap::Check> {
    let side = side.unwrap_or(DriveSide::Tlon);
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
