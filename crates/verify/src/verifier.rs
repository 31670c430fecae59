//! Judges a stream of CL records.

mod leading;

use std::sync::{Arc, OnceLock};

use aptc_cldata::milling::Milling;
use aptc_cldata::{Arg, Control, Kind, Motion, MotionKind, Output, Position, Record};
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::{Cutter, Form, Plane, Profile};

use crate::asked::Asked;
use crate::batch::{Batch, Event};
use crate::behind::Behind;
use crate::certificate::{Breach, Certificate, Fault, StatementProof, length};
use crate::chain::Chains;
use crate::free::{Free, Rapid};
use crate::hurried::Hurried;
use crate::joined::{Joined, Joins};
use crate::sheets::Sheets;
use crate::statement::{Outcome, Statement};

/// Allowance for rounding as a share of the size of the scene: what is proved is proved of a band wider by
/// this. Positions are solved to 1e-12 of the scene.
const ROUNDING: f64 = 1e-11;
/// The same for files of others, which were calculated with fewer digits or written with fewer.
const FOREIGN_ROUNDING: f64 = 1e-7;

/// What a refuted cut vector does that is too deep.
const CUTS: &str = "cuts into";

/// Does a message tell of a cut vector that cuts in?
pub fn tells_gouge(d: &Diagnostic) -> bool {
    d.code == codes::REFUTED && d.message.contains(CUTS)
}

/// How many vectors are judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Every vector.
    Full,
    /// Every n-th vector of a statement, its first and its last.
    Every(u64),
}

impl Effort {
    /// Is vector `i` of `n` judged, counted from 0?
    pub(crate) fn takes(self, i: usize, n: usize) -> bool {
        match self {
            Self::Full => true,
            Self::Every(k) => i == 0 || i + 1 == n || (i as u64 + 1).is_multiple_of(k.max(1)),
        }
    }
}

/// Vectors that wait at most before they are judged.
const WAITING: usize = 8192;

/// Judges CL records one after the other.
///
/// What they ask waits until it is much, or until [`finish`](Self::finish), and is then judged on the caller's thread.
/// Who has more threads takes it before as a [`Batch`] after each record, lets any of them work at it, and brings
/// it back: `batch`, [`Batch::work`], [`Batch::wait`], `settle`, batches in their order. The certificate is the same.
#[derive(Debug)]
pub struct Verifier {
    effort: Effort,
    profile: Option<Profile>,
    last: Option<Position>,
    /// The end of the last motion, whatever the machine does after it: from there the tool comes to a statement.
    came: Option<Position>,
    /// The statement of that motion, with its last motion along surfaces, and from where the tool came to it.
    statement: (Origin, Option<Arc<Control>>, Option<Position>),
    /// From where it goes at feed, and the places to which the statement leads it before it is along surfaces.
    led: Vec<Position>,
    /// Is that the end of a line of the same statement?
    led_on: bool,
    /// What the last motion was held to, where it was along surfaces, and with which cutter.
    ended: Option<(Arc<Control>, Profile)>,
    /// The motion along surfaces that came last; the next record may go on with it.
    open: Option<Box<Statement>>,
    /// RAPID was said for the next motion.
    rapid: bool,
    /// Was the motion before one?
    was_rapid: bool,
    /// A cycle of the machine works at each point.
    cycle: bool,
    /// DNTCUT was said: the next position is where CUT puts the tool out again.
    silent: bool,
    clearance: Option<Plane>,
    sheets: Sheets,
    /// What is not judged yet, and its vectors.
    waiting: Vec<Event>,
    n_waiting: usize,
    free: Free,
    behind: Behind,
    chains: Chains,
    joins: Joins,
    /// The lines of which it is not known yet whether all are milled.
    asked: Option<Asked>,
    certificate: Certificate,
    diagnostics: Vec<Diagnostic>,
}

impl Verifier {
    /// A verifier at the beginning of a part program.
    pub fn new(effort: Effort) -> Self {
        Self::rounded(effort, ROUNDING)
    }

    /// The same for positions of others, which have fewer digits.
    pub fn foreign(effort: Effort) -> Self {
        Self::rounded(effort, FOREIGN_ROUNDING)
    }

    fn rounded(effort: Effort, rounding: f64) -> Self {
        let certificate = Certificate { rounding, ..Certificate::default() };
        Self {
            effort,
            profile: None,
            last: None,
            came: None,
            statement: (Origin::default(), None, None),
            led: Vec::new(),
            led_on: false,
            ended: None,
            open: None,
            rapid: false,
            was_rapid: false,
            cycle: false,
            silent: false,
            clearance: None,
            sheets: Sheets::default(),
            waiting: Vec::new(),
            n_waiting: 0,
            free: Free::default(),
            behind: Behind::default(),
            chains: Chains::default(),
            joins: Joins::default(),
            asked: None,
            certificate,
            diagnostics: Vec::new(),
        }
    }

    /// Takes the next record of Section 2, before editing: TRACUT and COPY move the path off the surfaces.
    pub fn push(&mut self, record: &Record) {
        if self.n_waiting >= WAITING {
            self.judge();
        }
        match &record.kind {
            Kind::Cutter(cutter) => {
                self.close();
                let before = std::mem::replace(&mut self.profile, profile(cutter));
                if before != self.profile {
                    self.breaks();
                }
            }
            Kind::Post { word, args } => match word.as_str() {
                "RAPID" => self.rapid = true,
                "CLRSRF" if now(args) => self.last = self.last.map(|p| self.cleared(&p)),
                // Without a plane it leaves the plane as it was.
                "CLRSRF" => self.clearance = clearance(args).or(self.clearance),
                // The machine takes the tool away, or a cycle leaves it above the hole.
                "RETRCT" | "GOHOME" | "LOADTL" | "LOAD" | "TURRET" => {
                    self.last = None;
                    self.breaks();
                }
                "CYCLE" => {
                    self.last = None;
                    self.breaks();
                    self.cycle = !args.iter().any(|a| matches!(a, Arg::Word(w) if w == "OFF"));
                }
                _ => {}
            },
            Kind::Output(output) => self.silent = *output == Output::Dntcut,
            Kind::Motion(motion) => {
                let rapid = self.rapid;
                self.comes(motion, &record.origin);
                self.motion(motion, &record.origin);
                self.last = motion.points.last().copied().or(self.last);
                self.came = motion.points.last().copied().or(self.came);
                self.leads(motion, rapid);
            }
            _ => {}
        }
    }

    /// The certificate, and a message for each statement that is not proved.
    pub fn finish(mut self) -> (Certificate, Vec<Diagnostic>) {
        self.ends();
        self.judge();
        self.lines(None);
        self.free.finish();
        self.diagnostics.append(&mut self.free.said);
        self.certificate.rapid_cuts = self.free.cuts.len() as u64;
        self.certificate.rapids = self.free.cuts;
        (self.certificate, self.diagnostics)
    }

    /// What waits to be judged, when it has so many cut vectors.
    pub fn batch(&mut self, least: usize) -> Option<Batch> {
        (self.n_waiting >= least.max(1)).then(|| self.taken())
    }

    /// The last batch: no record follows.
    pub fn last_batch(&mut self) -> Batch {
        self.ends();
        self.taken()
    }

    /// Takes the answers of a batch of which all is done, the batches in their order.
    ///
    /// # Panics
    /// When a part of it was not done.
    pub fn settle(&mut self, batch: &Batch) {
        for (i, event) in batch.events.iter().enumerate() {
            match event {
                Event::Along(statement) => {
                    let judgement = statement.judgement(batch.answers(i));
                    for outcome in &judgement.vectors {
                        *match outcome {
                            Outcome::Proved => &mut self.certificate.proved,
                            Outcome::Refuted => &mut self.certificate.refuted,
                            Outcome::Undecided => &mut self.certificate.undecided,
                            Outcome::LeftOut => &mut self.certificate.left_out,
                        } += 1;
                    }
                    self.report(&judgement.proof, judgement.real);
                    self.went_through(statement, judgement.through);
                    self.certificate.statements.push(judgement.proof);
                    self.lines(Some(statement));
                    self.diagnostics.extend(self.joins.along(statement));
                    self.free.along(statement);
                }
                Event::Unknown(motion, origin) => self.without_proof(motion, origin),
                Event::Rapid(rapid) => self.free.rapid(rapid),
                Event::Behind(way) => self.free.behind(way),
                Event::Chain(chain) => self.free.chain(chain),
                Event::Joined(joined) => self.diagnostics.extend(self.joins.next(joined)),
                Event::Feed(end) => self.free.next(end),
                Event::Hurried(hurried) => self.diagnostics.push(hurried.told()),
            }
            self.diagnostics.append(&mut self.free.said);
        }
    }

    /// Tells which lines are left out once the statement is over that they belong to.
    fn lines(&mut self, next: Option<&Statement>) {
        if let (Some(asked), Some(s)) = (&mut self.asked, next)
            && asked.takes(s)
        {
            return;
        }
        let before = std::mem::replace(&mut self.asked, next.and_then(Asked::new));
        for left in before.iter().flat_map(Asked::left_out) {
            self.diagnostics.push(left.told());
            self.certificate.left_out_lines.push(left);
        }
    }

    fn taken(&mut self) -> Batch {
        self.n_waiting = 0;
        Batch::new(std::mem::take(&mut self.waiting))
    }

    fn judge(&mut self) {
        let batch = self.taken();
        batch.work();
        self.settle(&batch);
    }

    /// Where CLRSRF/NOW leaves a tool that stands at `at`: on the clearance plane, when it is below it.
    fn cleared(&self, at: &Position) -> Position {
        let Some(plane) = &self.clearance else { return *at };
        let slope = plane.n.dot(&at.ta);
        let way = if slope.abs() > 1e-6 { -plane.distance(at.te) / slope } else { 0.0 };
        Position { te: at.te + way.max(0.0) * at.ta, ta: at.ta }
    }

    fn motion(&mut self, motion: &Motion, origin: &Origin) {
        if motion.kind == MotionKind::From {
            // The tool is there already: RAPID before FROM moves nothing.
            self.rapid = false;
            self.close_unless(None);
            self.breaks();
            return;
        }
        let rapid = std::mem::take(&mut self.rapid);
        let Some(profile) = self.profile.or_else(|| profile(&Cutter::mill(0.0, 0.0, 0.0))) else {
            return;
        };
        let startup = motion.kind == MotionKind::Startup;
        let told = match (&motion.control, motion.kind) {
            (Some(control), MotionKind::Startup | MotionKind::Continuous) => Some(control),
            _ => None,
        };
        let control = told.filter(|c| c.milling.as_ref().is_none_or(Milling::asks));
        self.close_unless(control);
        if told.is_none() && motion.kind == MotionKind::Continuous {
            self.waiting.push(Event::Unknown(motion.clone(), origin.clone()));
            self.n_waiting += motion.points.len();
        } else if control.is_none() {
            self.certificate.free += motion.points.len() as u64;
        }
        let after = std::mem::replace(&mut self.was_rapid, rapid && control.is_none());
        if after
            && control.is_none()
            && !rapid
            && let Some(end) = motion.points.last()
        {
            self.waiting.push(Event::Feed(*end));
        }
        // Of regional milling it is how the tool comes to its first place.
        let milling = control.and_then(|c| c.milling.as_ref()).filter(|_| self.open.is_none());
        if rapid && (control.is_none() || startup || milling.is_some()) {
            let n = if milling.is_some() { 1 } else { motion.points.len() };
            let points = self.last.iter().chain(motion.points.iter().take(n)).copied().collect();
            let pad = self.pad(&motion.points, &profile);
            let (origin, clearance) = (origin.clone(), self.clearance);
            let (cycle, arrives) = (self.cycle, milling.is_some());
            let rapid = Rapid { origin, points, profile, pad, clearance, cycle, arrives };
            self.waiting.push(Event::Rapid(Box::new(rapid)));
            self.n_waiting += 1;
        }
        self.chained(motion, origin, control, rapid, &profile);
        if control.is_some() {
            self.behind.goes_on();
        } else if !rapid && Behind::takes(motion, self.statement.1.as_ref()) {
            let points = self.last.iter().chain(&motion.points).copied().collect();
            let pad = self.pad(&motion.points, &profile);
            self.behind.add(Rapid::at_feed(origin, points, profile, pad));
        }
        if let (true, Some(from), [to]) = (self.silent && !rapid, self.last, &motion.points[..]) {
            let pad = self.pad(&motion.points, &profile);
            let joined = Joined { origin: origin.clone(), from, to: *to, profile, pad };
            self.waiting.push(Event::Joined(Arc::new(joined)));
            self.n_waiting += 1;
        }
        if rapid
            && !startup
            && let Some(control) = told
        {
            let arrives = control.milling.is_some() && self.open.is_none();
            let vectors = motion.points.len().saturating_sub(usize::from(arrives));
            self.waiting.extend(Hurried::new(origin, control, vectors).map(Event::Hurried));
        }
        let ended = control.map(|control| (Arc::clone(control), profile));
        let earlier = std::mem::replace(&mut self.ended, ended);
        let earlier = earlier.filter(|(_, cutter)| *cutter == profile).map(|(control, _)| control);
        let Some(control) = control else { return };
        match &mut self.open {
            Some(open) => {
                if control.milling.as_ref().is_some_and(|m| m.over) {
                    open.over.push(open.points.len() as u64 + 1);
                }
                open.points.extend_from_slice(&motion.points);
            }
            None => {
                // How the tool comes to a region is held against what CHKSRF names alone.
                let joined = control.milling.as_ref().is_none_or(|m| m.joined && !rapid);
                let start = self.last.filter(|_| joined);
                let way = if joined { Vec::new() } else { self.way() };
                self.open = Some(Box::new(Statement {
                    control: Arc::clone(control),
                    startup,
                    rapid,
                    origin: origin.clone(),
                    start,
                    before: self.statement.2,
                    way,
                    again: self.led_on,
                    earlier,
                    points: motion.points.clone(),
                    over: Vec::new(),
                    profile,
                    // As large as its points make it, which are not all here yet.
                    pad: 0.0,
                    effort: self.effort,
                    sheets: self.sheets.clone(),
                    ready: OnceLock::new(),
                }));
            }
        }
    }

    /// Cut vectors along surfaces that the records do not tell, as those of regional milling: nothing is known
    /// of them, and that is said once a statement.
    fn without_proof(&mut self, motion: &Motion, origin: &Origin) {
        let n = motion.points.len() as u64;
        self.certificate.undecided += n;
        if let Some(last) = self.certificate.statements.last_mut()
            && last.origin == *origin
            && last.method == NO_METHOD
        {
            last.vectors += n;
            return;
        }
        let fault = motion.points.first().map(|p| Fault {
            refuted: false,
            surface: "the surfaces of regional milling".to_owned(),
            vector: 1,
            te: p.te.into(),
            depth: f64::INFINITY,
            gouge: false,
            breach: None,
            ends: false,
            why: None,
        });
        let (origin, surfaces) = (origin.clone(), Vec::new());
        let proof =
            StatementProof { origin, vectors: n, proved: 0, method: NO_METHOD, surfaces, fault };
        self.report(&proof, None);
        self.certificate.statements.push(proof);
    }

    /// Judges the open motion unless it goes on under that control: a slow-down before the check surface
    /// parts it.
    fn close_unless(&mut self, control: Option<&Arc<Control>>) {
        let same = |o: &Statement| control.is_some_and(|c| Arc::ptr_eq(c, &o.control));
        if self.open.as_ref().is_some_and(|o| !same(o)) {
            self.close();
        }
    }

    /// No record follows.
    fn ends(&mut self) {
        self.close();
        self.breaks();
        self.waiting.extend(self.behind.over().map(Event::Behind));
    }

    fn close(&mut self) {
        let Some(mut statement) = self.open.take() else { return };
        statement.pad = self.pad(&statement.points, &statement.profile);
        self.n_waiting += statement.points.len();
        self.waiting.push(Event::Along(statement));
    }

    fn pad(&self, points: &[Position], profile: &Profile) -> f64 {
        let size = points.iter().chain(&self.last).map(|p| p.te.norm()).fold(0.0, f64::max);
        self.certificate.rounding * size.max(profile.reach()).max(f64::MIN_POSITIVE)
    }

    /// A start-up that ends where it should and goes through a surface before.
    fn went_through(&mut self, statement: &Statement, fault: Option<Fault>) {
        let (who, help) =
            ("on its way the start-up goes", "lead the tool round it before, with GOTO or GODLTA");
        self.diagnostics.extend(fault.map(|f| f.through(&statement.origin, who, help)));
    }

    fn report(&mut self, proof: &StatementProof, real: Option<Fault>) {
        let trace = &proof.origin.trace;
        if let Some(f) = real {
            let message = format!(
                "the real cutter cuts into {} by {} beyond tolerance {}; its disk does not",
                f.surface,
                length(f.depth),
                f.place()
            );
            let d = Diagnostic::warning(codes::REAL_CUTTER, proof.origin.span, message);
            self.diagnostics.push(d.within(trace.clone()));
        }
        let Some(f) = &proof.fault else { return };
        let d = if f.refuted {
            let what = if f.gouge { CUTS } else { "leaves material on" };
            // What no cutter came over has no height.
            let by = if f.depth < f64::INFINITY {
                format!("{} by {} beyond tolerance", f.surface, length(f.depth))
            } else {
                format!("{}, over which it never comes,", f.surface)
            };
            let (vector, surface, place) = (f.vector, &f.surface, f.place());
            let far = length(f.depth);
            let message = match f.breach {
                None => format!("cut vector {vector} {what} {by} {place}"),
                Some(Breach::Outside) => format!(
                    "cut vector {vector} mills {surface} {far} outside of what REGION leaves to be milled, {place}"
                ),
                Some(Breach::Past) => format!(
                    "cut vector {vector} goes past the place where {surface} is tangent, {place}, and on for {far}"
                ),
            };
            let d = Diagnostic::error(codes::REFUTED, proof.origin.span, message);
            let d = match f.breach {
                Some(Breach::Past) => d.help(
                    "end the motion there with ON and a plane across it; where a later place is meant, count them with n,INTOF",
                ),
                _ => d,
            };
            f.why.iter().fold(d, |d, why| d.note(why.to_string()))
        } else if f.ends {
            let high = if f.depth < f64::INFINITY {
                format!("by {} beyond tolerance", length(f.depth))
            } else {
                "with all that is over them".to_owned()
            };
            let message = format!(
                "corners stand on {} where passes end or cross an edge, {high}, near cut vector {} {}",
                f.surface,
                f.vector,
                f.place()
            );
            Diagnostic::warning(codes::CORNERS, proof.origin.span, message).help(
                "let the passes run on beyond what is to be clean, or trim the ends and edges along them",
            )
        } else {
            let message =
                format!("cut vector {} against {} could not be proved", f.vector, f.surface);
            let d = Diagnostic::warning(codes::UNPROVED, proof.origin.span, message);
            let d = f.why.iter().fold(d, |d, why| d.note(why.to_string()));
            if f.depth.is_finite() {
                d.note(format!("it leaves the band by {} at most, {}", length(f.depth), f.place()))
            } else {
                d
            }
        };
        self.diagnostics.push(d.within(trace.clone()));
    }
}

/// How a motion is proved of which the surfaces are not known.
const NO_METHOD: &str = "none";

/// Is it CLRSRF/NOW?
fn now(args: &[Arg]) -> bool {
    matches!(args.first(), Some(Arg::Word(w)) if w == "NOW" || w == "START")
}

/// The plane of CLRSRF/plane.
fn clearance(args: &[Arg]) -> Option<Plane> {
    let form = args.iter().find_map(|a| match a {
        Arg::Form { form, .. } => Some(form),
        _ => None,
    })?;
    match form.shape() {
        Form::Plane(p) => Some(*p),
        _ => None,
    }
}

fn profile(cutter: &Cutter) -> Option<Profile> {
    Profile::new(cutter).ok()
}
