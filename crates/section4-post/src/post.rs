//! The post-processor: takes CL records, conducts words and motion, gives text and findings.

mod messages;
mod tools;
mod vars;

use std::collections::BTreeMap;
use std::sync::Arc;

use aptc_cldata::{Kind, MotionKind, Record, Units};
use aptc_diagnostics::{Diagnostic, Origin, Severity, codes};
use smol_str::SmolStr;

use self::messages::{Alike, Counted};
pub use self::tools::ToolScan;
use crate::args::Statement;
use crate::emit::{AptText, Blocks};
use crate::fitting::{Waiting, asks_nothing};
use crate::held::may_wait;
use crate::machine::{Dialect, Machine, MachineKind, OutputUnits};
use crate::report::{BlockOrigin, Summary, ToolUse};
use crate::roundtrip::{Checker, Proof};
use crate::state::State;
use crate::stock::Stock;
use crate::turning::seen_by_lathe;
use crate::words;

/// Comments before the first block that are kept back until the start lines stand; more begin the program.
const MOST_EARLY: usize = 200;

/// What the caller may set.
#[derive(Clone, Debug)]
pub struct PostOptions {
    /// The tools in order of LOADTL (see [`ToolScan`]), so that each tool change makes the next tool ready.
    pub tools: Vec<u32>,
    /// Work offset instead of the machine file's.
    pub work_offset: Option<String>,
    /// Two opposite corners of the block of material, in units of the CL data, as STOCK gives them.
    pub stock: Option<[f64; 6]>,
    /// Is the statement number written as a comment before its blocks?
    pub annotate: bool,
    /// Is the origin of each block kept?
    pub map: bool,
    /// Is the text read back and compared with the CL data? It costs about as much as writing.
    pub check: bool,
}

impl Default for PostOptions {
    fn default() -> Self {
        Self {
            tools: Vec::new(),
            work_offset: None,
            stock: None,
            annotate: false,
            map: false,
            check: true,
        }
    }
}

/// What remains when all records are through.
#[derive(Clone, Debug, Default)]
pub struct Posted {
    /// Messages in order.
    pub diagnostics: Vec<Diagnostic>,
    /// Summary.
    pub summary: Summary,
    /// Origin of each block, if asked for.
    pub map: Vec<BlockOrigin>,
    /// How well the text agrees with the CL data; none when it was not read back.
    pub proof: Option<Proof>,
}

/// Section 4 for one part program and one machine.
pub struct Post {
    pub(crate) machine: Arc<Machine>,
    /// The machine as its file has it: a lathe is another while it mills.
    pub(crate) lathe: Arc<Machine>,
    pub(crate) options: PostOptions,
    pub(crate) st: State,
    pub(crate) blocks: Blocks,
    pub(crate) diagnostics: Vec<Diagnostic>,
    pub(crate) summary: Summary,
    map: Vec<BlockOrigin>,
    annotated: Option<(u32, u32)>,
    checker: Option<Box<Checker>>,
    /// The material, where it is known.
    pub(crate) stock: Option<Box<Stock>>,
    /// The statement whose rapid motion through the stock was reported last.
    pub(crate) hit_told: Option<(u32, u32)>,
    /// Messages that stand for many.
    pub(crate) counted: Vec<Counted>,
    pub(crate) alike: BTreeMap<(u16, String), Alike>,
    /// Positions of motion so far.
    pub(crate) n_motions: u64,
    /// A position off the plane of turning was reported.
    pub(crate) off_plane_told: bool,
    /// Cuts that may become arcs.
    pub(crate) waiting: Waiting,
    /// Writes CL data instead of blocks.
    apt: Option<AptText>,
}

impl Post {
    /// A post-processor for a machine.
    pub fn new(machine: &Machine, options: PostOptions) -> Self {
        let machine = Arc::new(machine.clone());
        let mut st = State::new();
        st.inch = inch(&machine, st.units);
        st.rescale();
        st.away = machine.program.start_retracts;
        st.fit_mm = machine.arcs.as_ref().map(|a| a.fit).filter(|t| *t > 0.0);
        let blocks = Blocks::new(Arc::clone(&machine), st.inch);
        let summary = Summary { machine: machine.name.clone(), ..Summary::default() };
        let check = options.check && machine.dialect != Dialect::Apt;
        let checker = check.then(|| Box::new(Checker::new(&machine)));
        let (diagnostics, map) = (Vec::new(), Vec::new());
        let apt = (machine.dialect == Dialect::Apt).then(AptText::new);
        Self {
            lathe: Arc::clone(&machine),
            machine,
            options,
            st,
            blocks,
            diagnostics,
            summary,
            map,
            annotated: None,
            checker,
            stock: None,
            hit_told: None,
            counted: Vec::new(),
            alike: BTreeMap::new(),
            n_motions: 0,
            off_plane_told: false,
            waiting: Waiting::default(),
            apt,
        }
    }

    /// Takes one record; the text that it gives is added to `out`.
    pub fn push(&mut self, record: &Record, out: &mut Vec<u8>) {
        if let Some(apt) = &mut self.apt {
            apt.write(record, out);
            return;
        }
        let seen = match self.machine.kind {
            MachineKind::Lathe => seen_by_lathe(&self.machine, record, self.st.cycle.is_some()),
            MachineKind::Mill => None,
        };
        let record = seen.as_ref().unwrap_or(record);
        std::mem::swap(&mut self.blocks.out, out);
        if self.st.fit_mm.is_some() && self.st.index.is_none() && self.waits(record) {
            let begin = self.blocks.out.len();
            self.release(false);
            self.read_back(Some(record), begin, &record.origin);
        } else if self.waiting.is_empty() || !asks_nothing(&record.kind) {
            self.release_all();
            let begin = self.blocks.out.len();
            if !self.st.held.is_empty() && !may_wait(record) {
                self.let_go();
            }
            let before = self.blocks.lines;
            let from_part = self.seen_from_part(record);
            let ended = self.st.ended;
            self.record(from_part.as_ref().unwrap_or(record));
            if ended {
                self.leave_out(record, begin, before);
            } else {
                self.read_back(Some(record), begin, &record.origin);
            }
            if self.options.map && self.blocks.lines > before {
                self.note_origin(before, record);
            }
        }
        std::mem::swap(&mut self.blocks.out, out);
    }

    /// Takes back what a record wrote behind the end of the program, where no control reads it.
    fn leave_out(&mut self, record: &Record, begin: usize, before: u64) {
        if self.blocks.lines == before {
            return;
        }
        self.blocks.out.truncate(begin);
        self.blocks.lines = before;
        let (written, moves) = match &record.kind {
            Kind::Post { word, args } => {
                let s = Statement { word, args, origin: &record.origin };
                (s.written(), words::moves(word))
            }
            Kind::Text { word, .. } => (word.to_string(), false),
            _ => return,
        };
        self.after_end(&written, moves, &record.origin);
    }

    /// Work that no control would do, since END stands before it; where the machine moves it is an error.
    pub(crate) fn after_end(&mut self, what: &str, moves: bool, origin: &Origin) {
        let severity = if moves { Severity::Error } else { Severity::Warning };
        if self.st.late.is_some_and(|said| said >= severity) {
            return;
        }
        self.st.late = Some(severity);
        let message = format!("{what} after END, which ends the machine's program");
        let help = "put END after the last motion, or use STOP; what follows it is left out";
        if moves {
            self.error(codes::AFTER_END, origin, message, help);
        } else {
            self.warn(codes::AFTER_END, origin, message, help);
        }
    }

    /// Writes the cuts that waited for the end of their run.
    fn release_all(&mut self) {
        if !self.waiting.is_empty() {
            let begin = self.blocks.out.len();
            self.release(true);
            self.read_back(None, begin, &Origin::default());
        }
    }

    /// Ends the program: what END or FINI did not write is written now.
    pub fn finish(mut self, out: &mut Vec<u8>) -> Posted {
        if let Some(apt) = &mut self.apt {
            apt.finish(out);
        }
        std::mem::swap(&mut self.blocks.out, out);
        self.release_all();
        self.tell_fitted();
        let begin = self.blocks.out.len();
        if self.st.started && !self.st.ended {
            self.end(&Origin::default());
        }
        self.read_back(None, begin, &Origin::default());
        std::mem::swap(&mut self.blocks.out, out);
        self.summary.blocks = self.blocks.lines;
        self.summary.unit = if self.st.inch { "inch" } else { "mm" };
        self.summary.part = std::mem::take(&mut self.st.partno);
        self.summary.extent = self.st.extent;
        self.summary.axes = self.axes_used();
        self.count_messages();
        let proof = self.checker.map(|c| c.proof);
        Posted { diagnostics: self.diagnostics, summary: self.summary, map: self.map, proof }
    }

    /// Was anything refused? Then the text is not to be used.
    pub fn refused(&self) -> bool {
        self.diagnostics.iter().any(Diagnostic::is_error)
    }

    fn record(&mut self, record: &Record) {
        let origin = &record.origin;
        if self.st.cutcom_asked.is_some() {
            let silent = matches!(record.kind, Kind::Comment(_));
            let goes_on = matches!(&record.kind, Kind::Post { word, .. } if word == "CUTCOM");
            if !silent && !goes_on {
                self.no_side();
            }
        }
        match &record.kind {
            Kind::Motion(motion) => self.motion(motion, origin),
            Kind::Post { word, args } => {
                words::post_word(self, &Statement { word, args, origin });
            }
            Kind::Text { word, text } => words::text(self, word, text, origin),
            Kind::Units(units) => self.units(*units),
            Kind::Cutter(cutter) => {
                self.st.cutter = Some(*cutter);
                let values = cutter.values();
                self.tool_use().cutter = Some(values);
            }
            Kind::Intol(t) => {
                self.st.intol = greatest(t);
                self.st.tolerance_said = true;
            }
            Kind::Outtol(t) => {
                self.st.outtol = greatest(t);
                self.st.tolerance_said = true;
            }
            Kind::Multax(on) => self.st.multax = *on,
            Kind::Fini => {
                if !self.st.ended {
                    self.start(origin);
                    self.end(origin);
                }
            }
            Kind::Csys(frame) => self.frame(frame, origin),
            Kind::Output(_) | Kind::Edit(_) | Kind::Clprnt(_) | Kind::Comment(_) => {}
            Kind::Unread(text) => {
                let text: String = text.chars().take(40).collect();
                let message = format!("a CL statement was not understood and is left out: {text}");
                self.warn(codes::UNREAD_BY_POST, origin, message, "");
            }
        }
    }

    /// Compares what was written since `begin` with what the record asks for.
    fn read_back(&mut self, record: Option<&Record>, begin: usize, origin: &Origin) {
        if self.refused() {
            // There is no text to prove.
            self.checker = None;
        }
        let Some(checker) = &mut self.checker else { return };
        if let Some(record) = record {
            checker.record(record, self.st.clearance_mm);
        }
        if let Some(text) = self.blocks.out.get(begin..) {
            checker.text(text);
        }
        if self.waiting.is_empty() {
            checker.settle();
        }
        for fault in std::mem::take(&mut checker.faults) {
            let message = format!("line {} of the machine code: {}", fault.line, fault.message);
            let help = "this is a fault of aptc or of the machine file, not of the program; do not run the code";
            self.error(codes::NOT_THE_CL, origin, message, help);
        }
    }

    fn units(&mut self, units: Units) {
        self.st.units = units;
        self.st.units_said = true;
        if !self.st.started {
            self.st.inch = inch(&self.machine, units);
            let fresh = Blocks::new(Arc::clone(&self.machine), self.st.inch);
            let old = std::mem::replace(&mut self.blocks, fresh);
            self.blocks.out = old.out;
            self.blocks.skip = old.skip;
            self.blocks.numbered = old.numbered;
            self.blocks.next_number = old.next_number;
            self.blocks.number_step = old.number_step;
        }
        self.st.rescale();
    }

    /// Writes the start lines, once.
    pub(crate) fn start(&mut self, origin: &Origin) {
        if self.st.started {
            return;
        }
        self.st.started = true;
        if let (None, Some(corners)) = (&self.stock, self.options.stock)
            && !self.set_stock(corners, origin)
        {
            let message = "the block of --stock has no volume".to_owned();
            self.error(codes::POST_ARGUMENTS, origin, message, "give two opposite corners");
        }
        let machine = Arc::clone(&self.machine);
        let vars = self.common_vars();
        self.summary.work_offset = vars.work_offset.clone();
        let vars = vars.list();
        self.blocks.template(&machine.program.start, &vars);
        self.blocks.forget_after_start();
        let unit = self.st.out_mm();
        if let Some(checker) = &mut self.checker {
            checker.set_resolution_of(&self.blocks, unit);
        }
        for text in std::mem::take(&mut self.st.early) {
            self.blocks.comment(&text);
        }
        self.annotate(origin);
    }

    fn end(&mut self, origin: &Origin) {
        self.leave_cycle();
        if let Some((_, d)) = self.st.cutcom {
            let message = format!("radius compensation D{d} is still on at the end of the program");
            let help = "write CUTCOM/OFF before a straight motion away from the part";
            self.error(codes::COMPENSATION, origin, message, help);
        }
        self.leave_plane();
        self.tool_center_off();
        let machine = Arc::clone(&self.machine);
        let vars = self.common_vars();
        self.blocks.template(&machine.program.end, &vars.list());
        self.st.ended = true;
    }

    pub(crate) fn end_of_program(&mut self, origin: &Origin) {
        if !self.st.ended {
            self.start(origin);
            self.end(origin);
        }
    }

    /// A text of PPRINT or the like: a comment, kept back until the start lines stand.
    pub(crate) fn comment(&mut self, text: &str, origin: &Origin) {
        if !self.st.started && self.st.early.len() < MOST_EARLY {
            self.st.early.push(text.to_string());
            return;
        }
        self.start(origin);
        self.blocks.comment(text);
    }

    /// The work of the present tool.
    pub(crate) fn tool_use(&mut self) -> &mut ToolUse {
        if self.summary.tools.is_empty() {
            self.summary.tools.push(ToolUse::default());
        }
        let last = self.summary.tools.len() - 1;
        &mut self.summary.tools[last]
    }

    /// With `annotate`: the statement number in a comment before its first block.
    pub(crate) fn annotate(&mut self, origin: &Origin) {
        if !self.options.annotate || self.annotated == Some((origin.isn, origin.line)) {
            return;
        }
        self.annotated = Some((origin.isn, origin.line));
        if origin.line == 0 {
            return;
        }
        let file = origin.file.as_deref().map(|f| format!(" {f}")).unwrap_or_default();
        let isn = if origin.isn == 0 { String::new() } else { format!(" ISN {}", origin.isn) };
        self.blocks.comment(&format!("LINE {}{file}{isn}", origin.line));
    }

    fn note_origin(&mut self, before: u64, record: &Record) {
        let name = match &record.kind {
            Kind::Post { word, .. } | Kind::Text { word, .. } => word.clone(),
            Kind::Motion(m) => motion_name(m.kind),
            Kind::Fini => SmolStr::new_static("FINI"),
            _ => SmolStr::default(),
        };
        self.note_lines(before, &record.origin, name);
    }

    /// With `map`: the blocks since `before` come from a cut.
    pub(crate) fn note_cut(&mut self, before: u64, origin: &Origin, kind: MotionKind) {
        if self.options.map && self.blocks.lines > before {
            self.note_lines(before, origin, motion_name(kind));
        }
    }

    /// With `map`: the blocks since `before` come from a word.
    pub(crate) fn note_word(&mut self, before: u64, origin: &Origin, word: &'static str) {
        if self.options.map && self.blocks.lines > before {
            self.note_lines(before, origin, SmolStr::new_static(word));
        }
    }

    fn note_lines(&mut self, before: u64, origin: &Origin, record: SmolStr) {
        let (first, last) = (before + 1, self.blocks.lines);
        if let Some(run) = self.map.last_mut()
            && run.origin == *origin
        {
            run.last = last;
            return;
        }
        self.map.push(BlockOrigin { first, last, record, origin: origin.clone() });
    }
}

/// Text of a whole program at once, with the next tool made ready at each tool change.
pub fn post_all(
    machine: &Machine,
    mut options: PostOptions,
    records: &[Record],
) -> (String, Posted) {
    if options.tools.is_empty() {
        let mut scan = ToolScan::default();
        records.iter().for_each(|r| scan.push(r));
        options.tools = scan.finish();
    }
    let mut post = Post::new(machine, options);
    let mut out = Vec::new();
    for record in records {
        post.push(record, &mut out);
    }
    let posted = post.finish(&mut out);
    (String::from_utf8_lossy(&out).into_owned(), posted)
}

fn motion_name(kind: MotionKind) -> SmolStr {
    SmolStr::new_static(match kind {
        MotionKind::From => "FROM",
        MotionKind::Goto => "GOTO",
        MotionKind::Startup => "GO",
        MotionKind::Continuous => "CONTINUOUS",
    })
}

pub(crate) fn inch(machine: &Machine, units: Units) -> bool {
    match machine.units {
        OutputUnits::Part => matches!(units, Units::Inches | Units::Feet),
        OutputUnits::Mm => false,
        OutputUnits::Inch => true,
    }
}

fn greatest(t: &[f64; 4]) -> f64 {
    t.iter().fold(0.0, |a: f64, b| a.max(b.abs()))
}

/// A number with at most `places` decimals and no zeros at the end.
pub(crate) fn trimmed(value: f64, places: u8) -> String {
    use crate::machine::Format;
    use crate::number::Number;
    let n = Number::new(
        &Format { mm: places, inch: None, point: false, zeros: false, plus: false },
        false,
    );
    n.text(n.round(value).unwrap_or(0))
}
