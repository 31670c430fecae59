//! What can be known before a program runs: labels, macro bodies, loops and synonyms.

use std::collections::{HashMap, HashSet};

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_syntax::tree::{Body, Clause, Name, Statement};
use aptc_syntax::{Interner, Symbol};
use aptc_vocabulary::{Word, word};

use super::synonyms::Fault;
use super::targets::targets;
use super::{Synonyms, Unit};

/// A label that stands nowhere.
pub(crate) const MISSING: u32 = u32::MAX;

/// What a statement does to the order of execution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// Nothing.
    Plain,
    /// MACRO: the body ends with the TERMAC at this place.
    Macro(u32),
    /// TERMAC of a macro.
    Termac,
    /// IF: where to go for negative, zero, positive.
    If([u32; 3]),
    /// JUMPTO, also behind a logical IF.
    Jump(u32),
    /// DO: place of the last statement of the loop.
    Do(u32),
    /// A statement whose structure is wrong; a diagnostic was given.
    Skip,
}

/// One part program of a file, up to its FINI.
#[derive(Debug, Default)]
pub(crate) struct Plan {
    start: u32,
    end: u32,
    roles: Vec<Role>,
    scopes: Vec<u32>,
    /// The scope around a scope; a macro body and the program itself have none.
    outer: Vec<Option<u32>>,
    labels: HashMap<(u32, Symbol), u32>,
    /// Does a macro that is not closed hold the end of the program?
    swallowed: bool,
    /// Was a macro left out because it stands in another?
    lost_macro: bool,
}

/// What is needed beside the statements.
pub(crate) struct Surroundings<'s> {
    /// All names.
    pub(crate) interner: &'s Interner,
    /// The synonyms so far; those of the program are taken in.
    pub(crate) synonyms: &'s mut Synonyms,
    /// Names that some statement gives a value; those of the program are taken in.
    pub(crate) assigned: &'s mut HashSet<Symbol>,
}

impl Plan {
    /// First statement.
    pub(crate) fn start(&self) -> u32 {
        self.start
    }

    /// One past the last statement.
    pub(crate) fn end(&self) -> u32 {
        self.end
    }

    /// Does a macro that is not closed hold the end of the program?
    pub(crate) fn swallowed(&self) -> bool {
        self.swallowed
    }

    /// Was a macro left out because it stands in another?
    pub(crate) fn lost_macro(&self) -> bool {
        self.lost_macro
    }

    /// What the statement at `place` does to the order of execution.
    pub(crate) fn role(&self, place: u32) -> Role {
        self.roles.get((place - self.start) as usize).copied().unwrap_or(Role::Plain)
    }

    /// Where `label` stands, seen from the statement at `place`: in its own loop region, else in the macro
    /// or program around it, else in the one loop region of that macro or program that has it.
    pub(crate) fn goal(&self, place: u32, label: Symbol) -> Option<u32> {
        let here = self.scopes.get(place.checked_sub(self.start)? as usize).copied()?;
        let mut scope = here;
        loop {
            if let Some(&goal) = self.labels.get(&(scope, label)) {
                return Some(goal);
            }
            match self.outer[scope as usize] {
                Some(outer) => scope = outer,
                None => break,
            }
        }
        let inner = (0u32..).zip(&self.outer).filter(|(_, o)| **o == Some(scope));
        let mut found = inner.filter_map(|(s, _)| self.labels.get(&(s, label)));
        let goal = found.next().copied();
        if found.next().is_some() { None } else { goal }
    }

    /// All labels that can be reached from `place`, for a hint.
    pub(crate) fn labels(&self) -> impl Iterator<Item = Symbol> {
        self.labels.keys().map(|(_, label)| *label)
    }
}

/// Plans the part program that begins at statement `start`; a file that is read takes all of its
/// statements.
pub(crate) fn plan(unit: &Unit, start: u32, around: Surroundings<'_>) -> (Plan, Vec<Diagnostic>) {
    let mut planner = Planner {
        unit,
        interner: around.interner,
        synonyms: around.synonyms,
        assigned: around.assigned,
        plan: Plan { start, end: start, outer: vec![None], ..Plan::default() },
        diagnostics: Vec::new(),
        macro_open: None,
        loop_open: None,
        inner: [0; 2],
    };
    planner.structure();
    planner.goals();
    (planner.plan, planner.diagnostics)
}

struct Planner<'p> {
    unit: &'p Unit,
    interner: &'p Interner,
    synonyms: &'p mut Synonyms,
    assigned: &'p mut HashSet<Symbol>,
    plan: Plan,
    diagnostics: Vec<Diagnostic>,
    /// The MACRO that is not closed yet: place, scope, span.
    macro_open: Option<(u32, u32, Span)>,
    /// Likewise the LOOPST.
    loop_open: Option<(u32, Span)>,
    /// TERMACs and LOOPNDs that belong to a MACRO or LOOPST inside another, told already.
    inner: [u32; 2],
}

impl Planner<'_> {
    /// First pass: extent of macros and loop regions, labels, synonyms.
    fn structure(&mut self) {
        let statements = &self.unit.program.statements;
        for (place, statement) in (0u32..).zip(statements).skip(self.plan.start as usize) {
            let head = self.head(&statement.body);
            let mut role = Role::Plain;
            match head {
                Some(word::LOOPST) => role = self.open_loop(statement),
                Some(word::TERMAC) => role = self.close_macro(place, statement),
                Some(word::SYN) => self.synonym(statement),
                _ => {}
            }
            if let Body::Macro { name, params } = &statement.body {
                let inner = self.macro_open.is_some();
                role = self.open_macro(place, name, statement.span);
                if inner {
                    // Their values would have come with the CALL.
                    self.assigned.extend(params.iter().map(|p| p.name.symbol));
                }
            }
            let scope = self.scope();
            self.plan.scopes.push(scope);
            self.plan.roles.push(role);
            targets(&statement.body, &mut |symbol| {
                self.assigned.insert(symbol);
            });
            if let Some(label) = &statement.label {
                self.label(scope, label, place);
            }
            match head {
                Some(word::LOOPND) => self.close_loop(statement),
                Some(word::FINI) if self.macro_open.is_none() => {
                    self.plan.end = place + 1;
                    self.unfinished();
                    return;
                }
                _ => {}
            }
            if role == Role::Termac {
                self.macro_open = None;
            }
            self.plan.end = place + 1;
        }
        self.unfinished();
    }

    fn scope(&self) -> u32 {
        match (self.loop_open, self.macro_open) {
            (Some((scope, _)), _) | (None, Some((_, scope, _))) => scope,
            (None, None) => 0,
        }
    }

    fn new_scope(&mut self, outer: Option<u32>) -> u32 {
        self.plan.outer.push(outer);
        u32::try_from(self.plan.outer.len() - 1).expect("fewer scopes than statements")
    }

    fn head(&self, body: &Body) -> Option<Word> {
        match body {
            Body::Clauses(clauses) => self.synonyms.word(&clauses.first()?.head),
            _ => None,
        }
    }

    fn open_macro(&mut self, place: u32, name: &Name, span: Span) -> Role {
        if let Some((_, _, open)) = self.macro_open {
            self.diagnostics.push(
                Diagnostic::error(
                    codes::MACRO_IN_MACRO,
                    span,
                    format!("macro {} begins inside another", self.interner.text(name.symbol)),
                )
                .also(open, "this macro has no TERMAC yet")
                .help("end the outer macro with TERMAC first; macros may call each other"),
            );
            self.inner[0] += 1;
            self.plan.lost_macro = true;
            return Role::Skip;
        }
        let scope = self.new_scope(None);
        self.macro_open = Some((place, scope, span));
        Role::Macro(MISSING)
    }

    fn close_macro(&mut self, place: u32, statement: &Statement) -> Role {
        let Some((open, _, _)) = self.macro_open else {
            if self.inner[0] > 0 {
                self.inner[0] -= 1;
                return Role::Skip;
            }
            self.plan.lost_macro = true;
            self.diagnostics.push(
                Diagnostic::error(codes::TERMAC_ALONE, statement.span, "TERMAC ends no macro")
                    .help("begin the macro with `name=MACRO/...`, or take the TERMAC away"),
            );
            return Role::Skip;
        };
        if let Some((_, span)) = self.loop_open.take() {
            self.loop_not_closed(span);
        }
        self.plan.roles[(open - self.plan.start) as usize] = Role::Macro(place);
        Role::Termac
    }

    fn open_loop(&mut self, statement: &Statement) -> Role {
        if let Some((_, open)) = self.loop_open {
            self.diagnostics.push(
                Diagnostic::error(
                    codes::LOOP_IN_LOOP,
                    statement.span,
                    "LOOPST inside another loop region",
                )
                .also(open, "this region has no LOOPND yet")
                .help(
                    "one LOOPST .. LOOPND may hold any number of loops; take the inner pair away",
                ),
            );
            self.inner[1] += 1;
            return Role::Skip;
        }
        let outer = self.scope();
        let scope = self.new_scope(Some(outer));
        self.loop_open = Some((scope, statement.span));
        Role::Plain
    }

    fn close_loop(&mut self, statement: &Statement) {
        if self.loop_open.take().is_none() {
            if self.inner[1] > 0 {
                self.inner[1] -= 1;
                return;
            }
            self.diagnostics.push(
                Diagnostic::warning(
                    codes::LOOPND_ALONE,
                    statement.span,
                    "LOOPND ends no loop region",
                )
                .help("begin the region with LOOPST, or take the LOOPND away"),
            );
        }
    }

    fn loop_not_closed(&mut self, span: Span) {
        self.diagnostics.push(
            Diagnostic::error(codes::LOOP_NOT_CLOSED, span, "this loop region has no LOOPND")
                .help("end the region with LOOPND"),
        );
    }

    fn unfinished(&mut self) {
        if let Some((_, span)) = self.loop_open.take() {
            self.loop_not_closed(span);
        }
        if let Some((open, _, span)) = self.macro_open.take() {
            self.diagnostics.push(
                Diagnostic::error(codes::MACRO_NOT_CLOSED, span, "this macro has no TERMAC")
                    .help("end the macro with TERMAC"),
            );
            self.plan.swallowed = true;
            // The body reaches to the end: its statements stand in no other program.
            self.plan.roles[(open - self.plan.start) as usize] = Role::Macro(self.plan.end);
        }
    }

    fn label(&mut self, scope: u32, label: &Name, place: u32) {
        let before = self.plan.labels.insert((scope, label.symbol), place);
        let Some(before) = before else { return };
        self.plan.labels.insert((scope, label.symbol), before);
        let text = self.interner.text(label.symbol);
        let first = self.unit.program.statements[before as usize].label;
        let mut message = Diagnostic::error(
            codes::DUPLICATE_LABEL,
            label.span,
            format!("label {text} stands twice in the same loop, macro or program"),
        )
        .help("give one of them another name");
        if let Some(first) = first {
            message = message.also(first.span, "here first");
        }
        self.diagnostics.push(message);
    }

    fn synonym(&mut self, statement: &Statement) {
        let Body::Clauses(clauses) = &statement.body else { return };
        for args in clauses.iter().filter_map(|c| c.args.as_deref()) {
            for (at, fault) in self.synonyms.take(args) {
                let text = &self.unit.text[at.span.start as usize..at.span.end as usize];
                let (message, help) = match fault {
                    Fault::Alone => (
                        format!("{text} has no partner in SYN"),
                        "write pairs: new name, vocabulary word",
                    ),
                    Fault::NoName => {
                        (format!("{text} is no name"), "write pairs: new name, vocabulary word")
                    }
                    Fault::NoWord => (
                        format!("{text} is no vocabulary word"),
                        "the first pair decides whether the word stands first or second in all pairs",
                    ),
                };
                self.diagnostics
                    .push(Diagnostic::error(codes::BAD_SYN, at.span, message).help(help));
            }
        }
    }

    /// Second pass: where the jumps go.
    fn goals(&mut self) {
        let statements = &self.unit.program.statements;
        for place in self.plan.start..self.plan.end {
            let body = &statements[place as usize].body;
            let role = match body {
                Body::If { targets, .. } => {
                    Role::If(targets.map(|t| self.plan.goal(place, t.symbol).unwrap_or(MISSING)))
                }
                Body::IfThen { then, .. } => match &**then {
                    Body::Clauses(clauses) => match self.jump(place, clauses) {
                        Some(role) => role,
                        None => continue,
                    },
                    _ => continue,
                },
                Body::Clauses(clauses) => match self.jump(place, clauses) {
                    Some(role) => role,
                    None => continue,
                },
                Body::Do { label, .. } => {
                    let end = self.plan.goal(place, label.symbol).unwrap_or(MISSING);
                    if end != MISSING && end <= place {
                        self.do_ends_before(label, end);
                        Role::Skip
                    } else {
                        Role::Do(end)
                    }
                }
                _ => continue,
            };
            self.plan.roles[(place - self.plan.start) as usize] = role;
        }
    }

    fn jump(&self, place: u32, clauses: &[Clause]) -> Option<Role> {
        let [clause] = clauses else { return None };
        if !matches!(self.synonyms.word(&clause.head), Some(word::JUMPTO | word::TRANTO)) {
            return None;
        }
        let [argument] = clause.args.as_deref()? else { return None };
        let label = self.unit.label(self.interner, argument);
        Some(Role::Jump(label.and_then(|l| self.plan.goal(place, l)).unwrap_or(MISSING)))
    }

    fn do_ends_before(&mut self, label: &Name, end: u32) {
        let text = self.interner.text(label.symbol);
        let mut message = Diagnostic::error(
            codes::DO_ENDS_BEFORE,
            label.span,
            format!("the loop should end at {text}, which stands before it"),
        )
        .help("DO names the label of the loop's last statement");
        if let Some(label) = &self.unit.program.statements[end as usize].label {
            message = message.also(label.span, "the label is here");
        }
        self.diagnostics.push(message);
    }
}
