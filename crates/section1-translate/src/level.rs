//! Where execution stands: the program, and the macro calls and files that it is in.

use std::sync::Arc;

use aptc_diagnostics::{Frame, FrameKind, Span, Trace};
use aptc_syntax::tree::Name;
use smol_str::SmolStr;

use crate::program::{Plan, Unit};

/// The program, a macro call or a file that is read.
#[derive(Debug)]
pub(crate) struct Level {
    /// The file.
    pub(crate) unit: Arc<Unit>,
    /// Its plan.
    pub(crate) plan: Arc<Plan>,
    /// The next statement.
    pub(crate) at: u32,
    /// One past the last statement.
    pub(crate) end: u32,
    /// The statement executed last.
    pub(crate) last: u32,
    /// What it is.
    pub(crate) kind: LevelKind,
    /// Macro calls, this one counted.
    pub(crate) n_calls: usize,
    /// Files that are read, this one counted.
    pub(crate) n_files: usize,
    /// DO loops that are open, outermost first.
    pub(crate) dos: Vec<DoLoop>,
    /// Loops that are in a further pass, outermost first.
    passes: Vec<Pass>,
    /// The call, and all around it.
    around: Trace,
    /// `around` and the passes, when somebody asked for it since the last jump.
    trace: Option<Trace>,
}

/// What a level is.
#[derive(Debug)]
pub(crate) enum LevelKind {
    /// The part program.
    Program,
    /// A file that is read.
    File,
    /// A macro call.
    Macro {
        /// Locals of the calls around it.
        first_local: usize,
        /// Of these, the first of the caller.
        caller_local: usize,
    },
}

/// A DO loop that is open.
#[derive(Clone, Debug)]
pub(crate) struct DoLoop {
    /// Its first statement.
    pub(crate) start: u32,
    /// Its last statement.
    pub(crate) end: u32,
    /// The running variable.
    pub(crate) variable: Name,
    /// Its first value.
    pub(crate) first: f64,
    /// Its step.
    pub(crate) step: f64,
    /// Passes done.
    pub(crate) done: u64,
    /// Passes in all.
    pub(crate) passes: u64,
}

/// A loop by a jump back that is in its second pass or a later one.
#[derive(Clone, Debug)]
struct Pass {
    start: u32,
    end: u32,
    name: SmolStr,
    span: Span,
    line: u32,
    pass: u32,
    /// When a value had last changed at the last jump back, and how many jumps ago that was.
    seen: u64,
    idle: u32,
}

/// So many passes of a loop that change nothing are believed to go on for ever.
const IDLE: u32 = 3;

impl Level {
    /// A level that begins at the start of `range`.
    pub(crate) fn new(
        unit: Arc<Unit>,
        plan: Arc<Plan>,
        range: (u32, u32),
        kind: LevelKind,
        around: Trace,
    ) -> Self {
        let (at, end) = range;
        Self {
            unit,
            plan,
            at,
            end,
            last: u32::MAX,
            kind,
            n_calls: 0,
            n_files: 0,
            dos: Vec::new(),
            passes: Vec::new(),
            around,
            trace: None,
        }
    }

    /// The same with its place in the chain of levels.
    pub(crate) fn inside(self, outer: Option<&Self>) -> Self {
        let (calls, files) = outer.map_or((0, 0), |o| (o.n_calls, o.n_files));
        let n_calls = calls + usize::from(matches!(self.kind, LevelKind::Macro { .. }));
        let n_files = files + usize::from(matches!(self.kind, LevelKind::File));
        Self { n_calls, n_files, ..self }
    }

    /// Whether the loop that the last jump back began again goes on for ever: passes have changed no value that
    /// its end could depend on. `change` says when a value last changed.
    pub(crate) fn is_endless(&mut self, goal: u32, change: u64) -> bool {
        let Some(pass) = self.passes.last_mut().filter(|p| p.start == goal) else { return false };
        pass.idle = if pass.seen == change && pass.pass > 2 { pass.idle + 1 } else { 0 };
        pass.seen = change;
        pass.idle >= IDLE
    }

    /// Goes on at the statement `goal`, named `name`.
    pub(crate) fn jump(&mut self, goal: u32, name: impl FnOnce() -> SmolStr) {
        let from = self.last;
        self.at = goal;
        self.dos.retain(|d| (d.start..=d.end).contains(&goal));
        if goal > from || from == u32::MAX {
            return;
        }
        // A jump back begins a further pass of the loop from the goal to here.
        self.trace = None;
        while self.passes.last().is_some_and(|p| p.start > goal) {
            self.passes.pop();
        }
        match self.passes.last_mut() {
            Some(pass) if pass.start == goal => {
                pass.pass = pass.pass.saturating_add(1);
                pass.end = pass.end.max(from);
            }
            _ => {
                let statement = &self.unit.program.statements[goal as usize];
                let span = statement.label.map_or(statement.span, |l| l.span);
                let (name, line) = (name(), statement.line);
                self.passes.push(Pass {
                    start: goal,
                    end: from,
                    name,
                    span,
                    line,
                    pass: 2,
                    seen: 0,
                    idle: 0,
                });
            }
        }
    }

    /// Notes that the statement at `place` is executed next.
    pub(crate) fn arrive(&mut self, place: u32) {
        self.last = place;
        self.at = place + 1;
        while let Some(pass) = self.passes.last() {
            if (pass.start..=pass.end).contains(&place) {
                break;
            }
            self.passes.pop();
            self.trace = None;
        }
    }

    /// The expansions around the present statement.
    pub(crate) fn trace(&mut self) -> Trace {
        if let Some(trace) = &self.trace {
            return trace.clone();
        }
        let trace = self.passes.iter().fold(self.around.clone(), |outer, pass| {
            Some(Arc::new(Frame {
                kind: FrameKind::Loop,
                name: pass.name.clone(),
                span: pass.span,
                line: pass.line,
                pass: pass.pass,
                outer,
            }))
        });
        self.trace = Some(trace.clone());
        trace
    }
}
