//! The road: from source text to machine code.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::sync::Arc;
use std::time::{Duration, Instant};

use aptc_arelem::{Arelem, Situation};
use aptc_cldata as cl;
use aptc_diagnostics::{Diagnostic, FrameKind, SourceMap, Span, Trace, codes};
use aptc_geometry::Vec3;
use aptc_protap as protap;
use aptc_regional::{Regional, Stand};
use aptc_translate::{
    Entry, FileError, FileRequest, Files, Interpreter, LoadedFile, Quantity, Step,
};
use aptc_verify::{Certificate, tells_gouge};

use crate::axis::AxisSaid;
use crate::geometry_json::Named;
use crate::post::{Nc, post_part};
use crate::proof::Ahead;
use crate::threads::Threads;
use crate::{Options, Records, Source, Summary, World, WorldError};

/// Codes of what is wrong with a motion, which is wrong in each call of a macro.
const MOTION: std::ops::Range<u16> = 2000..5000;

/// What came of a part program.
#[derive(Debug, Default)]
pub struct Compiled {
    /// The files that were read.
    pub sources: SourceMap,
    /// All messages of all Sections, in the order of the road.
    pub diagnostics: Vec<Diagnostic>,
    /// The part programs of the file, PARTNO to FINI, in order.
    pub parts: Vec<Part>,
    /// What the program printed.
    pub(crate) printed: Vec<Entry>,
    /// Final values of all names.
    pub geometry: Vec<(String, Named)>,
    /// The situation in which the first motion failed, of which a picture can be made.
    pub situation: Option<Situation>,
}

/// One part program, PARTNO to FINI.
#[derive(Debug, Default)]
pub struct Part {
    /// The numeric part program, if it was to be kept.
    pub protap: Vec<protap::Record>,
    /// CL data of Section 2.
    pub computed: Records,
    /// CL data after Section 3.
    pub edited: Records,
    /// Machine code, one text a machine.
    pub nc: Vec<Nc>,
    /// Figures.
    pub summary: Summary,
    /// What was proved of the path.
    pub certificate: Option<Certificate>,
    /// Lines that PLOTFT drew.
    pub drawn: Vec<Vec<Vec3>>,
    /// Was NOPLOT given?
    pub noplot: bool,
}

impl Compiled {
    /// Is there an error among the messages?
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.is_error() && !is_refutation(d))
    }

    /// Did verification refute a cut vector?
    pub fn is_refuted(&self) -> bool {
        self.diagnostics.iter().any(is_refutation)
    }

    /// Is the CL data whole: no error of Sections 1 to 3?
    pub fn is_cl_whole(&self) -> bool {
        !self.diagnostics.iter().any(|d| d.is_error() && d.code.number() < 4000)
    }
}

/// The records did not go to their temporary file, or did not come back.
pub(crate) fn no_room(e: &io::Error) -> Diagnostic {
    let what = format!("the temporary file for CL data cannot be used: {e}");
    Diagnostic::error(codes::UNREADABLE_FILE, Span::default(), what)
        .help("make room where temporary files go, or set TMPDIR to a folder that has it")
}

fn is_refutation(d: &Diagnostic) -> bool {
    d.is_error() && d.code.number() >= 5000
}

/// Compiles the part programs of a file.
pub fn compile(source: Source, world: &mut dyn World, options: &Options) -> Compiled {
    let mut files = Includes(world);
    let mut section1 =
        Interpreter::new(&source.name, &source.text, &mut files, options.translate.clone());
    let clock = Clock::start(options.time);
    let mut run = Run::new(options, clock);
    loop {
        if clock.is_over() {
            let why = format!("the program was stopped after {} seconds", clock.seconds());
            let help = "check what ends its loops and which statement before takes long, or allow more by --max-seconds";
            section1.stop(codes::TOO_MUCH_TIME, why, help);
        }
        let Some(step) = section1.step_within(BETWEEN_LOOKS) else { continue };
        run.compiled.diagnostics.extend(section1.take_diagnostics());
        run.compiled.printed.extend(section1.take_listing());
        match step {
            Step::Record(record) => {
                run.keeps_path = section1.asks_for_paths();
                let outcome = run.take(record);
                section1.outcome(outcome);
                run.take_saved().into_iter().for_each(|saved| section1.saved(saved));
            }
            Step::End => break,
        }
    }
    run.end_part();
    run.compiled.sources = section1.sources().clone();
    let named = |quantity| match quantity {
        Quantity::Scalar(x) => Named::Scalar(x),
        Quantity::Form(form) => Named::Form(form),
    };
    run.compiled.geometry =
        section1.geometry().into_iter().map(|(n, q)| (name_of(&n), named(q))).collect();
    run.finish()
}

/// Statements between two looks at the clock; fewer cost more than they are worth, more let a program run
/// on for a second.
const BETWEEN_LOOKS: u64 = 10_000;

/// The time that a part program may take.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock {
    start: Instant,
    limit: Option<Duration>,
}

impl Clock {
    fn start(limit: Option<Duration>) -> Self {
        Self { start: Instant::now(), limit }
    }

    pub(crate) fn is_over(&self) -> bool {
        self.limit.is_some_and(|limit| self.start.elapsed() >= limit)
    }

    fn seconds(&self) -> f64 {
        self.limit.unwrap_or_default().as_secs_f64()
    }
}

/// Goes on from a numeric part program, at Section 2.
pub fn resume(source: Source, options: &Options) -> Compiled {
    let mut run = Run::new(options, Clock::start(options.time));
    let file = run.compiled.sources.add(source.name, Arc::clone(&source.text));
    let (records, diagnostics) = protap::read_in_place(file, &source.text);
    run.compiled.diagnostics.extend(diagnostics);
    run.compiled.diagnostics.extend(protap::verify(&records));
    // What breaks a rule of its records has no meaning for the Sections that follow.
    if !run.compiled.has_errors() {
        for record in records {
            run.take(record);
        }
    }
    run.end_part();
    run.finish()
}

fn name_of(n: &protap::NameRef) -> String {
    if n.subscript > 0 { format!("{}({})", n.name, n.subscript) } else { n.name.to_string() }
}

/// The positions of motions, when there are any.
fn path_of(records: &[cl::Record]) -> Option<protap::CutVectors> {
    let mut points: Vec<protap::CutPoint> = Vec::new();
    for record in records {
        let cl::Kind::Motion(m) = &record.kind else { continue };
        points.extend(m.points.iter().map(|p| protap::CutPoint {
            te: p.te,
            ta: p.ta,
            ..protap::CutPoint::default()
        }));
    }
    (!points.is_empty()).then(|| protap::CutVectors { points, ..protap::CutVectors::default() })
}

/// A run through Sections 2 to 4.
struct Run<'o> {
    options: &'o Options,
    clock: Clock,
    compiled: Compiled,
    section2: Arelem,
    regional: Regional,
    axis: AxisSaid,
    part: Part,
    /// The proof of the present part program.
    proof: Ahead,
    /// What Section 2 has put out last.
    fresh: Vec<cl::Record>,
    /// Has the present part program any record?
    begun: bool,
    nopost: bool,
    /// Does Section 1 ask for the path of the last motion?
    keeps_path: bool,
    /// That path.
    path: Option<protap::CutVectors>,
    /// Did the last motion fail, so that it is unknown where the tool stands?
    lost: bool,
    /// Statements of regional milling to which it came from there.
    from_nowhere: Vec<(Span, Trace)>,
}

impl<'o> Run<'o> {
    fn new(options: &'o Options, clock: Clock) -> Self {
        Self {
            options,
            clock,
            proof: Ahead::new(options),
            compiled: Compiled::default(),
            section2: Arelem::new(aptc_arelem::Options::default()),
            regional: Regional::default(),
            axis: AxisSaid::default(),
            part: Part::default(),
            fresh: Vec::new(),
            begun: false,
            nopost: false,
            keeps_path: false,
            path: None,
            lost: false,
            from_nowhere: Vec::new(),
        }
    }

    /// Hands a record to Section 2 and brings back the outcome.
    fn take(&mut self, record: protap::Record) -> protap::Outcome {
        self.begun = true;
        match &record.kind {
            protap::Kind::Nopost => self.nopost = true,
            protap::Kind::Noplot => self.part.noplot = true,
            _ => {}
        }
        let outcome = if self.options.motion { self.mill(&record) } else { protap::Outcome::None };
        let fini = matches!(record.kind, protap::Kind::Fini);
        if self.options.keep_protap {
            self.part.protap.push(record);
        }
        if fini {
            self.end_part();
        }
        outcome
    }

    /// Section 2: the arithmetic element, and regional milling, which hand the tool to each other.
    fn mill(&mut self, record: &protap::Record) -> protap::Outcome {
        self.compiled.diagnostics.extend(self.axis.next(record));
        let known = self.fresh.len();
        let mut outcome = self.section2.execute(record, &mut self.fresh);
        // The arithmetic element goes on as programmed; what is put out is projected by TLPROJ.
        let projected = self.regional.project(&mut self.fresh, known);
        if projected.is_err() || self.regional.watch(&mut self.fresh, known).is_err() {
            self.section2.stand(None);
            outcome = protap::Outcome::Failed;
        }
        match outcome {
            protap::Outcome::Moved { te, ta, .. } => {
                self.lost = false;
                self.regional.stood(Some(Stand { te, ta, along: Vec3::zeros() }));
            }
            protap::Outcome::Failed => {
                self.lost = true;
                self.regional.stood(None);
            }
            _ => {}
        }
        if let Ok(Some(stand)) = projected {
            self.regional.stood(Some(stand));
        }
        let crew = Threads::new(self.options, self.clock);
        let milled = self.regional.execute_by(record, &crew, &mut self.fresh);
        self.compiled.diagnostics.extend(self.regional.take_diagnostics());
        self.part.drawn.extend(self.regional.take_drawn());
        if self.keeps_path {
            self.path = path_of(self.fresh.get(known..).unwrap_or_default()).or(self.path.take());
        }
        // Regional milling takes back what CLDAT only records.
        if !self.regional.is_recording() {
            let kept = self.keep();
            self.tell(kept);
        }
        if self.lost && !matches!(milled, Ok(None)) {
            self.from_nowhere.push((record.origin.span, record.origin.trace.clone()));
        }
        match milled {
            Ok(None) => outcome,
            Ok(Some(s)) => {
                self.lost = false;
                self.section2.stand(Some((s.te, s.ta, s.along)));
                protap::Outcome::Moved { te: s.te, ta: s.ta, check: 0 }
            }
            Err(aptc_regional::Failed) => {
                self.lost = true;
                self.section2.stand(None);
                protap::Outcome::Failed
            }
        }
    }

    /// Cut vectors for Section 1: sections of CLDAT, curves of INTSEC, the path of the last motion.
    fn take_saved(&mut self) -> Vec<protap::CutVectors> {
        let mut saved: Vec<_> = self.path.take().into_iter().collect();
        saved.extend(self.regional.take_saved());
        saved
    }

    /// Sections 3 and 4 of a part program.
    fn end_part(&mut self) {
        if !self.begun {
            return;
        }
        let known = self.fresh.len();
        self.section2.finish(&mut self.fresh);
        // Their messages are those of the program; nothing follows that would need the place of the tool.
        let _ = self.regional.project(&mut self.fresh, known);
        let _ = self.regional.watch(&mut self.fresh, known);
        self.compiled.diagnostics.extend(self.regional.take_diagnostics());
        let kept = self.keep();
        self.tell(kept);
        self.compiled.diagnostics.extend(self.section2.take_diagnostics());
        let situation = self.section2.take_situation();
        self.compiled.situation = self.compiled.situation.take().or(situation);
        let mut part = std::mem::take(&mut self.part);
        let done = self.later_sections(&mut part);
        self.tell(done);
        self.compiled.parts.push(part);
        self.section2 = Arelem::new(aptc_arelem::Options::default());
        self.regional = Regional::default();
        self.axis = AxisSaid::default();
        (self.begun, self.nopost, self.lost) = (false, false, false);
        self.from_nowhere.clear();
    }

    /// The proof of the path of Section 2 against its surfaces, and Sections 3 and 4.
    fn later_sections(&mut self, part: &mut Part) -> io::Result<()> {
        let whole = self.compiled.is_cl_whole();
        let new = Ahead::new(self.options);
        let proof = std::mem::replace(&mut self.proof, new);
        if let Some((certificate, diagnostics)) = proof.finish(&part.computed)? {
            part.certificate = Some(certificate);
            // Where the motion before failed, which is told, the way from there is not the program's.
            let lost = &self.from_nowhere;
            let leads_on = |d: &Diagnostic| {
                d.code != codes::THROUGH || !lost.contains(&(d.span, d.trace.clone()))
            };
            self.compiled.diagnostics.extend(diagnostics.into_iter().filter(leads_on));
        }
        let (edited, diagnostics) = crate::edit::edit(&part.computed, whole)?;
        (part.edited, part.summary) = (edited.records, edited.summary);
        self.compiled.diagnostics.extend(diagnostics);
        let (code, head) = (&self.options.code, &edited.head);
        let wanted = !code.unasked || code.machine.is_some() || head.names_machine();
        let posts = self.options.post && wanted && !self.nopost;
        if posts && self.compiled.is_cl_whole() {
            let (nc, diagnostics) = post_part(&part.edited, head, code)?;
            part.nc = nc;
            self.compiled.diagnostics.extend(diagnostics);
        }
        Ok(())
    }

    /// Puts what Section 2 made to the records of the part.
    fn keep(&mut self) -> io::Result<()> {
        self.fresh.drain(..).try_for_each(|record| {
            self.proof.push(&record);
            self.part.computed.push(record)
        })
    }

    /// Without its temporary file the part is not whole.
    fn tell(&mut self, done: io::Result<()>) {
        let Err(e) = done else { return };
        self.compiled.diagnostics.push(no_room(&e));
    }

    fn finish(mut self) -> Compiled {
        once_each(&mut self.compiled.diagnostics);
        self.compiled
    }
}

/// A statement in a loop or macro that fails in the same way each time is told of once, also when a loop brings
/// other numbers each time.
pub(crate) fn once_each(diagnostics: &mut Vec<Diagnostic>) {
    let known = |d: &&Diagnostic| {
        matches!(d.code, codes::UNKNOWN_POST_WORD | codes::UNKNOWN_CL_WORD | codes::UNREADABLE_CL)
    };
    let unknown: BTreeSet<_> = diagnostics.iter().filter(known).map(|d| d.span.start).collect();
    // The reader said it already, of the word itself; Section 4 says it of the statement.
    diagnostics.retain(|d| {
        !matches!(d.code, codes::WORD_UNKNOWN | codes::UNREAD_BY_POST)
            || !unknown.contains(&d.span.start)
    });
    // Where CHKSRF ends a statement with a gouge, one that the proof finds in the same is of the same mistake.
    let gouge = |d: &&Diagnostic| {
        d.is_error() && matches!(d.code, codes::INTERFERENCE | codes::BETWEEN_PASSES)
    };
    let gouged = diagnostics.iter().filter(gouge).map(|d| (d.span, d.trace.clone()));
    let gouged: Vec<_> = gouged.collect();
    diagnostics.retain(|d| !tells_gouge(d) || !gouged.contains(&(d.span, d.trace.clone())));
    let mut told = BTreeSet::new();
    diagnostics.retain(|d| told.insert((d.code, d.span, d.message.clone())));
    let frames = |d: &Diagnostic| std::iter::successors(d.trace.clone(), |f| f.outer.clone());
    // What Section 1 finds wrong in one call may be right in another: names and numbers are those of the call. So it is of what
    // the proof finds: how deep it is differs.
    let one_of_calls = |d: &Diagnostic| MOTION.contains(&d.code.number());
    let place = |d: &Diagnostic| {
        let calls = frames(d).filter(|f| f.kind != FrameKind::Loop && !one_of_calls(d));
        (d.code, d.severity, d.span, calls.map(|f| f.span).collect::<Vec<_>>())
    };
    // The first pass of a loop is told of without it.
    let again = |d: &&Diagnostic| {
        frames(d).any(|f| match f.kind {
            FrameKind::Loop => true,
            FrameKind::Macro => one_of_calls(d),
            _ => false,
        })
    };
    let repeated: BTreeSet<_> = diagnostics.iter().filter(again).map(place).collect();
    // How many there are of each, and whether some are of a loop.
    let mut passes = BTreeMap::<_, (u32, bool)>::new();
    diagnostics.retain(|d| {
        let key = place(d);
        if !repeated.contains(&key) {
            return true;
        }
        let (n, looped) = passes.entry(key).or_insert((0, false));
        *n += 1;
        *looped |= frames(d).any(|f| f.kind == FrameKind::Loop);
        *n == 1
    });
    for d in diagnostics {
        let (n, looped) = passes.remove(&place(d)).unwrap_or((1, false));
        if n > 1 {
            let further = match (looped, n) {
                (true, 2) => "a further pass".to_owned(),
                (true, n) => format!("{} further passes", n - 1),
                (false, 2) => "a further call".to_owned(),
                (false, n) => format!("{} further calls", n - 1),
            };
            d.notes.push(format!("the same in {further}, with other values"));
        }
    }
}

/// Section 1's way to files.
struct Includes<'w>(&'w mut dyn World);

impl Files for Includes<'_> {
    fn read(&mut self, request: &FileRequest) -> Result<LoadedFile, FileError> {
        let found = self.0.include(&request.name);
        found.map(|s| LoadedFile { name: s.name, text: s.text }).map_err(|e| {
            let help = match &e {
                WorldError::Missing { .. } => Some("name its folder with --include".to_owned()),
                WorldError::Outside => Some(
                    "allow its folder with --include, or copy the file beside the program"
                        .to_owned(),
                ),
                _ => None,
            };
            let code = match &e {
                WorldError::Outside => codes::OUTSIDE_FOLDERS,
                WorldError::TooLarge { .. } => codes::FILE_TOO_LARGE,
                _ => codes::UNREADABLE_FILE,
            };
            FileError { code, message: format!("cannot read {}: {e}", request.name), help }
        })
    }
}
