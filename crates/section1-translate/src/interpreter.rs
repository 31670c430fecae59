//! The interpreter: one statement after the other, one record at a time.
//!
//! APT: `AMONTR` and `ASYCTL` of Section 1, in one pass.

mod quantity;
mod stops;

use std::collections::{HashMap, HashSet, VecDeque};
use std::rc::Rc;
use std::sync::Arc;

use aptc_diagnostics::{Diagnostic, Origin, SourceMap, Span, Trace, codes};
use aptc_geometry::{Form, Plane, Transform};
use aptc_protap::{CutVectors, Kind, NameRef, Outcome, Record, Units};
use aptc_syntax::tree::{Body, Statement};
use aptc_syntax::{Interner, Symbol};
use aptc_vocabulary::{Word, word};
use smol_str::SmolStr;

use crate::define::{Fits, Found};
use crate::eval::Unfit;
use crate::level::{Level, LevelKind};
use crate::listing::{Entry, EntryKind};
use crate::memory::{Memory, Place, Value};
use crate::program::{Plan, Role, Surroundings, Synonyms, Unit, foreign, has, plan, sculptured};
use crate::report::Reports;
use crate::{Files, Language, Options};

pub use quantity::Quantity;

/// What a step gives.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// The next record. Its outcome is asked for before the next step.
    Record(Record),
    /// The program is at its end.
    End,
}

/// A part program in execution.
pub struct Interpreter<'w> {
    pub(crate) options: Options,
    pub(crate) files: &'w mut dyn Files,
    pub(crate) sources: SourceMap,
    pub(crate) interner: Interner,
    pub(crate) synonyms: Synonyms,
    pub(crate) memory: Memory,
    pub(crate) macros: HashMap<Symbol, MacroDef>,
    pub(crate) libraries: HashMap<Symbol, Span>,
    assigned: HashSet<Symbol>,
    pub(crate) levels: Vec<Level>,
    pub(crate) state: State,
    pub(crate) here: Here,
    reports: Reports,
    listing: Vec<Entry>,
    n_listed: usize,
    queue: VecDeque<Record>,
    outcome: Outcome,
    /// Where the labels behind the check surfaces of the last motion lead.
    branch: Option<Vec<Option<u32>>>,
    executed: u64,
    /// How many had been executed at the first error.
    pub(crate) failed_at: Option<u64>,
    /// The name without a value for whose sake the present statement is left out, and where it should
    /// have got one.
    pub(crate) blamed: Option<(Place, Span)>,
    /// Curves and surfaces that cannot be fitted.
    pub(crate) unfit: Unfit,
    /// Curves and surfaces that were asked for last, fitted.
    pub(crate) fits: Rc<Fits>,
    finished: Vec<(NameRef, Quantity)>,
    /// Does the program ask for the path of its last motion (CLDATA)?
    pub(crate) asks_for_paths: bool,
}

/// A macro of the program.
#[derive(Clone, Debug)]
pub(crate) struct MacroDef {
    pub(crate) unit: Arc<Unit>,
    pub(crate) plan: Arc<Plan>,
    /// Place of the MACRO statement.
    pub(crate) place: u32,
    /// Place of its TERMAC.
    pub(crate) end: u32,
}

/// The statement that is executed.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Here {
    pub(crate) span: Span,
    pub(crate) isn: u32,
    pub(crate) line: u32,
}

/// What statements set for those that follow.
#[derive(Clone, Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of the language")]
pub(crate) struct State {
    /// REFSYS.
    pub(crate) refsys: Option<Transform>,
    /// Forms as REFSYS sees them, by where they are kept: what is used again is the same surface.
    pub(crate) carried: HashMap<usize, [Arc<Form>; 2]>,
    /// ZSURF in the base system.
    pub(crate) zsurf: Option<Plane>,
    /// CANON/ON: names may be defined again.
    pub(crate) redefinition: bool,
    /// PRINT/ON.
    pub(crate) print: bool,
    /// MULTAX without ON, which no OFF takes back.
    pub(crate) multax_for_good: bool,
    /// UNITS.
    pub(crate) unit: Units,
    /// Has the program no UNITS, of which was not told yet? A file that it includes may have it.
    pub(crate) lacks_units: bool,
    /// What may be missing without being a mistake of its own.
    pub(crate) doubt: Doubt,
    /// The place found last on a sculptured form, for PARMF.
    pub(crate) found: Option<Found>,
    /// The sections of CLDAT, and the path of the last motion.
    pub(crate) cut_vectors: Vec<CutVectors>,
    /// Is this a program of APT4?
    pub(crate) sculptured: bool,
    /// The word of the post-processor whose arguments are read.
    pub(crate) arguments_of: Option<Word>,
    /// Words without effect that were told of.
    pub(crate) ignored_said: Vec<Word>,
    /// Was said that this part program stands behind a FINI and has no PARTNO?
    pub(crate) behind_fini: bool,
    /// Was said how a MATRIX in a reference system is taken?
    pub(crate) matrix_said: bool,
    /// Was said in which order two maps are carried out?
    pub(crate) product_said: bool,
    /// Parameters beyond an end that were pointed out.
    pub(crate) beyond_said: HashSet<Span>,
    /// Was a statement of this program executed?
    pub(crate) begun: bool,
}

/// What statements that could not be carried out would perhaps have done.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Doubt {
    /// A jump or a call: statements of the program were perhaps left out.
    pub(crate) paths: bool,
    /// A macro or a file that is missing: any name may have got a value.
    pub(crate) names: bool,
    /// A file that is missing: any macro may have been defined.
    pub(crate) macros: bool,
    /// A SCON since the last INIT: SMIL perhaps lacks what it would have set.
    pub(crate) milling: bool,
}

impl<'w> Interpreter<'w> {
    /// Reads the program `text`, named `name`, and stands before its first statement.
    pub fn new(name: &str, text: &str, files: &'w mut dyn Files, options: Options) -> Self {
        let mut run = Self {
            synonyms: Synonyms::new(options.language),
            options,
            files,
            sources: SourceMap::default(),
            interner: Interner::default(),
            memory: Memory::default(),
            macros: HashMap::new(),
            libraries: HashMap::new(),
            assigned: HashSet::new(),
            levels: Vec::new(),
            state: State::default(),
            here: Here::default(),
            reports: Reports::default(),
            listing: Vec::new(),
            n_listed: 0,
            queue: VecDeque::new(),
            outcome: Outcome::None,
            branch: None,
            executed: 0,
            failed_at: None,
            blamed: None,
            unfit: Unfit::default(),
            fits: Rc::default(),
            finished: Vec::new(),
            asks_for_paths: false,
        };
        let (unit, messages) = run.parse(name, text, None);
        let other = match run.options.language {
            Language::Apt => foreign(&unit.program),
            Language::Ncl => None,
        };
        if let Some(message) = other {
            // What else could be said about its statements would say the same again.
            run.push(message);
            return run;
        }
        run.state.sculptured = sculptured(&unit.program);
        run.state.lacks_units = !has(&unit.program, &[word::UNITS, word::INCLUD]);
        messages.into_iter().for_each(|m| run.push(m));
        run.begin(unit, 0);
        run
    }

    /// Executes statements up to the next record.
    pub fn step(&mut self) -> Step {
        loop {
            if let Some(step) = self.step_within(u64::MAX) {
                return step;
            }
        }
    }

    /// The same with at most `n` statements; `None` when they gave no record. So that somebody with a clock
    /// may look at it.
    pub fn step_within(&mut self, n: u64) -> Option<Step> {
        for _ in 0..n {
            if let Some(record) = self.queue.pop_front() {
                self.outcome = Outcome::None;
                return Some(Step::Record(record));
            }
            if self.levels.is_empty() {
                return Some(Step::End);
            }
            self.follow_branch();
            self.advance();
        }
        None
    }

    /// Takes in what came of the last record.
    pub fn outcome(&mut self, outcome: Outcome) {
        self.outcome = outcome;
    }

    /// The messages since the last time.
    pub fn take_diagnostics(&mut self) -> Vec<Diagnostic> {
        self.reports.take()
    }

    /// Errors so far; also those beyond the limit of messages.
    pub fn n_errors(&self) -> usize {
        self.reports.n_errors()
    }

    /// Messages beyond the limit, which are not given out.
    pub fn n_dropped(&self) -> usize {
        self.reports.n_dropped()
    }

    /// The files that were read, for the places of messages.
    pub fn sources(&self) -> &SourceMap {
        &self.sources
    }

    /// What the program printed since the last time.
    pub fn take_listing(&mut self) -> Vec<Entry> {
        std::mem::take(&mut self.listing)
    }

    /// How many statements were executed.
    pub fn n_executed(&self) -> u64 {
        self.executed
    }

    /// Parses a file, tells its mistakes and makes room for its names.
    pub(crate) fn load(&mut self, name: &str, text: &str, shown: Option<Arc<str>>) -> Arc<Unit> {
        let (unit, messages) = self.parse(name, text, shown);
        let trace = self.trace();
        for message in messages {
            self.push(message.within(trace.clone()));
        }
        unit
    }

    fn parse(
        &mut self,
        name: &str,
        text: &str,
        shown: Option<Arc<str>>,
    ) -> (Arc<Unit>, Vec<Diagnostic>) {
        let text: Arc<str> = text.into();
        let file = self.sources.add(name, Arc::clone(&text));
        let options = aptc_syntax::Options {
            free_form: self.options.free_form,
            percent_comments: self.options.language == Language::Ncl,
            max_bracket_depth: self.options.limits.bracket_depth,
            max_elements: self.options.limits.elements,
            ..aptc_syntax::Options::default()
        };
        let parsed = aptc_syntax::parse(file, &text, &mut self.interner, &options);
        self.memory.grow(self.interner.len());
        let asked = word::CLDATA.text().as_bytes();
        self.asks_for_paths |=
            text.as_bytes().windows(asked.len()).any(|w| w.eq_ignore_ascii_case(asked));
        (Arc::new(Unit { text, name: shown, program: parsed.program }), parsed.diagnostics)
    }

    /// The plan of the part program that begins at `start`.
    pub(crate) fn plan(&mut self, unit: &Unit, start: u32) -> Arc<Plan> {
        let around = Surroundings {
            interner: &self.interner,
            synonyms: &mut self.synonyms,
            assigned: &mut self.assigned,
        };
        let (plan, messages) = plan(unit, start, around);
        let trace = self.trace();
        for message in messages {
            self.push(message.within(trace.clone()));
        }
        self.state.doubt.macros |= plan.lost_macro();
        self.state.doubt.paths |= plan.lost_macro();
        Arc::new(plan)
    }

    /// Stands before the part program that begins at statement `start` of the main file.
    fn begin(&mut self, unit: Arc<Unit>, start: u32) {
        let rest = &unit.program.statements[start as usize..];
        if rest.iter().all(|s| matches!(s.body, Body::Empty)) {
            self.levels.clear();
            return;
        }
        let plan = self.plan(&unit, start);
        let range = (plan.start(), plan.end());
        if start > 0 {
            self.look_behind_fini(&unit.program.statements[start as usize..plan.end() as usize]);
        }
        self.levels = vec![Level::new(unit, plan, range, LevelKind::Program, None)];
    }

    /// Tells of statements behind FINI that no PARTNO heads: often FINI stands too early, or what follows is a remark.
    fn look_behind_fini(&mut self, rest: &[Statement]) {
        let heads = |s: &Statement| matches!(s.body, Body::Text { word: word::PARTNO, .. });
        let Some(first) = rest.iter().find(|s| !matches!(s.body, Body::Empty)) else { return };
        self.state.behind_fini = !rest.iter().any(heads);
        if self.state.behind_fini {
            let line = first.line;
            let message =
                format!("what follows FINI (line {line}) is taken as a further part program");
            self.push(
                Diagnostic::warning(codes::BEHIND_FINI, first.span, message)
                    .help("put FINI at the end, or head the further part program with PARTNO"),
            );
        }
    }

    /// Ends the part program and stands before the next one of the file.
    pub(crate) fn finish(&mut self) {
        self.report_unused();
        self.emit(Kind::Fini);
        let mut values = std::mem::take(&mut self.finished);
        self.add_geometry(&mut values);
        self.finished = values;
        let Some(level) = self.levels.drain(..).next() else { return };
        self.memory.clear();
        self.macros.clear();
        self.libraries.clear();
        self.assigned.clear();
        self.synonyms = Synonyms::new(self.options.language);
        self.state = State::default();
        self.branch = None;
        self.begin(Arc::clone(&level.unit), level.plan.end());
    }

    /// Executes one statement.
    fn advance(&mut self) {
        self.next_pass();
        let Some(level) = self.levels.last_mut() else { return };
        if level.at >= level.end {
            self.leave();
            return;
        }
        let place = level.at;
        level.arrive(place);
        let (unit, plan) = (Arc::clone(&level.unit), Arc::clone(&level.plan));
        let statement = &unit.program.statements[place as usize];
        self.here = Here { span: statement.span, isn: statement.isn, line: statement.line };
        if self.executed >= self.options.limits.statements {
            self.out_of_statements();
            return;
        }
        let after_error = self.options.limits.after_error;
        if self.failed_at.is_some_and(|n| self.executed - n >= after_error) {
            self.stopped_after_error(after_error);
            return;
        }
        self.executed += 1;
        self.state.begun = true;
        let told = self.reports.n_errors();
        self.blamed = None;
        self.execute(&unit, &plan, place, statement);
        if self.reports.n_errors() > 0 {
            self.failed_at.get_or_insert(self.executed);
        }
        if let Some((name, since)) = self.blamed.take()
            && self.reports.n_errors() == told
        {
            self.left_out(name, since, unit.program.statements[place as usize].span);
        }
    }

    /// Carries out the statement.
    fn execute(&mut self, unit: &Arc<Unit>, plan: &Arc<Plan>, place: u32, statement: &Statement) {
        let role = plan.role(place);
        match role {
            Role::Plain => self.body(unit, &statement.body),
            Role::Skip => {}
            Role::Macro(end) => {
                if let Body::Macro { name, .. } = &statement.body {
                    self.define_macro(unit, plan, name, place, end);
                }
                self.go_to(end.saturating_add(1).min(plan.end()));
            }
            Role::Termac => self.leave(),
            Role::If(goals) => self.three_way(unit, &statement.body, goals),
            Role::Jump(goal) => self.jump_to(unit, &statement.body, goal),
            Role::Do(end) => self.open_do(unit, &statement.body, place, end),
        }
    }

    /// Leaves a macro, a file or the program.
    fn leave(&mut self) {
        let Some(level) = self.levels.last() else { return };
        match level.kind {
            LevelKind::Program => {
                let end = level.plan.end();
                let at = level.unit.program.statements.get(end.saturating_sub(1) as usize);
                let span = at.map_or(self.here.span, |s| s.span);
                let text = level.unit.text.trim_end();
                let cut_short = text.ends_with('$') && !text.ends_with("$$");
                // The last statement may be a FINI that could not be read.
                let unread = self.reports.has_error_in(span);
                let told = self.state.behind_fini;
                if !level.plan.swallowed() && !cut_short && !unread && !told {
                    self.push(
                        Diagnostic::warning(codes::NO_FINI, span, "the program ends without FINI")
                            .help("end the part program with FINI"),
                    );
                }
                self.finish();
            }
            LevelKind::File => {
                self.levels.pop();
            }
            LevelKind::Macro { first_local, caller_local } => {
                self.memory.unbind(first_local, caller_local);
                self.levels.pop();
            }
        }
    }

    /// Tells of names that got a value and never gave it, when that is asked for.
    fn report_unused(&mut self) {
        let Doubt { paths, names, .. } = self.state.doubt;
        if !self.options.unused || paths || names {
            return;
        }
        let unused: Vec<(Place, Span)> = self
            .memory
            .values()
            .filter(|(place, slot)| {
                matches!(place, Place::Global(_))
                    && !slot.read
                    && !matches!(slot.value, Value::Unset | Value::Poison)
            })
            .map(|(place, slot)| (place, slot.given))
            .collect();
        for (place, given) in unused {
            let name = self.spelled(place);
            self.push(
                Diagnostic::warning(codes::UNUSED, given, format!("{name} is never used"))
                    .help("take it away, or check the spelling where it should be used"),
            );
        }
    }

    /// Notes in the listing why a statement without a mistake of its own is left out.
    fn left_out(&mut self, name: Place, since: Span, statement: Span) {
        let name = self.spelled(name);
        let at = |span: Span| self.sources.line_column(span.file, span.start).0;
        let (line, since) = (at(statement), at(since));
        let remark = format!("line {line} is left out: {name} has no value since line {since}");
        self.list(EntryKind::Remark(remark));
    }

    /// Goes where the check surface that stopped the last motion leads.
    fn follow_branch(&mut self) {
        let Some(goals) = self.branch.take() else { return };
        if let Outcome::Moved { check, .. } = self.outcome
            && let Some(Some(goal)) = goals.get(check)
        {
            self.go_to(*goal);
        }
    }

    /// The labels of the motion that was just put out.
    pub(crate) fn branch_on(&mut self, goals: Vec<Option<u32>>) {
        // Where the tool stands decides here, not a value.
        self.memory.stir();
        self.branch = Some(goals);
    }

    /// Goes on at statement `goal` of the present level.
    pub(crate) fn go_to(&mut self, goal: u32) {
        let Self { levels, interner, .. } = self;
        let Some(level) = levels.last_mut() else { return };
        let label = level.unit.program.statements.get(goal as usize).and_then(|s| s.label);
        let from = level.last;
        level
            .jump(goal, || label.map_or_else(SmolStr::default, |l| interner.text(l.symbol).into()));
        if goal <= from && level.is_endless(goal, self.memory.last_change()) {
            self.endless();
        }
    }

    /// Puts out a record of the present statement.
    pub(crate) fn emit(&mut self, kind: Kind) {
        let origin = self.origin();
        self.queue.push_back(Record { origin, kind });
    }

    /// Where the present statement stands.
    pub(crate) fn origin(&mut self) -> Origin {
        let Here { span, isn, line } = self.here;
        let file = self.levels.last().and_then(|l| l.unit.name.clone());
        Origin { span, isn, line, file, trace: self.trace() }
    }

    /// The expansions around the present statement.
    pub(crate) fn trace(&mut self) -> Trace {
        self.levels.last_mut().and_then(Level::trace)
    }

    /// Adds to the listing.
    pub(crate) fn list(&mut self, kind: EntryKind) {
        let limit = self.options.limits.printed;
        self.n_listed += 1;
        if self.n_listed <= limit {
            let origin = self.origin();
            self.listing.push(Entry { origin, kind });
        } else if self.n_listed == limit + 1 {
            self.error(
                Diagnostic::warning(
                    codes::TOO_MUCH_PRINTED,
                    self.here.span,
                    format!("more than {limit} printed lines: the rest is left out of the listing"),
                )
                .help("print less, or raise the limit; the part program itself goes on"),
            );
        }
    }

    /// Is the name perhaps without a value because another statement was not carried out?
    pub(crate) fn is_doubtful(&self, symbol: Symbol) -> bool {
        let Doubt { paths, names, .. } = self.state.doubt;
        names || paths && self.assigned.contains(&symbol)
    }

    /// Tells a message about the present statement.
    pub(crate) fn error(&mut self, message: Diagnostic) {
        let trace = self.trace();
        self.push(message.within(trace));
    }

    /// Does `work` without telling what is amiss: it follows from what was told.
    pub(crate) fn muted<T>(&mut self, work: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.reports.muted, true);
        let done = work(self);
        self.reports.muted = before;
        done
    }

    pub(crate) fn push(&mut self, message: Diagnostic) {
        self.reports.push(message, self.options.limits.messages);
    }

    /// Name and subscript of what is at `place`.
    pub(crate) fn name_ref(&self, place: Place) -> NameRef {
        let (symbol, subscript) = self.memory.name(place);
        NameRef { name: self.interner.text(symbol).into(), subscript }
    }

    /// Name and subscript as a user writes them.
    pub(crate) fn spelled(&self, place: Place) -> String {
        let (symbol, subscript) = self.memory.name(place);
        match subscript {
            0 => self.interner.text(symbol).to_owned(),
            n => format!("{}({n})", self.interner.text(symbol)),
        }
    }
}
