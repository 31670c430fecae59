//! What changes the order of execution: IF, JUMPTO, DO, macros and files that are read.

mod calls;
mod include;
mod outside;

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_syntax::tree::{Body, Expr, ExprKind, Name};

use crate::Interpreter;
use crate::level::DoLoop;
use crate::memory::Value;
use crate::program::{MISSING, Unit};

/// IF takes what is smaller than this for zero, as APT-360 does (`ASYCTL`, class 11): a loop that adds
/// .03 ten times to .2 must see the .5 at its end. Comparisons such as `.EQ` are exact.
const ZERO: f64 = 1e-5;

/// Slack in the number of passes of a DO, so that 0 to 1 by .1 has eleven of them.
const PASS_SLACK: f64 = 1e-9;

impl Interpreter<'_> {
    /// IF(a)l1,l2,l3.
    pub(crate) fn three_way(&mut self, unit: &Unit, body: &Body, goals: [u32; 3]) {
        let Body::If { value, targets } = body else { return };
        for (i, (target, goal)) in targets.iter().zip(goals).enumerate() {
            // A label that stands nowhere is told of once, however often it is named here.
            let text = unit.spelling(target.span);
            let told = targets[..i].iter().any(|before| unit.spelling(before.span) == text);
            if goal == MISSING && !told {
                self.no_label(unit, target.span);
            }
        }
        let Ok(value) = self.number(value) else {
            self.state.doubt.paths = true;
            return;
        };
        let way = match value {
            v if v.abs() < ZERO => 1,
            v if v < 0.0 => 0,
            _ => 2,
        };
        if goals[way] == MISSING {
            self.state.doubt.paths = true;
        } else {
            self.go_to(goals[way]);
        }
    }

    /// JUMPTO/label, TRANTO/label, and both behind a logical IF.
    pub(crate) fn jump_to(&mut self, unit: &Unit, body: &Body, goal: u32) {
        if let Body::IfThen { condition, then } = body {
            match self.logical(condition) {
                Ok(true) => self.jump_to(unit, then, goal),
                Ok(false) => {}
                Err(_) => self.state.doubt.paths = true,
            }
            return;
        }
        if goal != MISSING {
            self.go_to(goal);
            return;
        }
        let Body::Clauses(clauses) = body else { return };
        let argument = clauses.first().and_then(|c| c.args.as_deref()?.first());
        let is_label = |a: &&Expr| matches!(a.kind, ExprKind::Name(_) | ExprKind::Number(_));
        match argument.filter(is_label) {
            Some(a) => self.no_label(unit, a.span),
            None => {
                let span = argument.map_or(self.here.span, |a| a.span);
                self.error(
                    Diagnostic::error(codes::NO_SUCH_LABEL, span, "a label is expected here")
                        .help("write JUMPTO/label"),
                );
            }
        }
        self.state.doubt.paths = true;
    }

    /// Says that a label stands nowhere.
    pub(crate) fn no_label(&mut self, unit: &Unit, span: Span) {
        let text = unit.spelling(span);
        let label = self.interner.find(&text);
        let mut message = Diagnostic::error(
            codes::NO_SUCH_LABEL,
            span,
            format!("no statement here has the label {text}"),
        );
        let plan = self.levels.last().map(|l| std::sync::Arc::clone(&l.plan));
        let known = plan.iter().any(|p| p.labels().any(|l| Some(l) == label));
        message = if known {
            message.help("labels hold within a macro, a loop region, or the rest of the program")
        } else {
            message.help(format!("put `{text})` before the statement that is meant"))
        };
        self.error(message);
    }

    /// DO/label,var=first,last,step.
    pub(crate) fn open_do(&mut self, unit: &Unit, body: &Body, place: u32, end: u32) {
        let Body::Do { label, variable, first, last, step } = body else { return };
        if end == MISSING {
            self.no_label(unit, label.span);
        }
        let values = (self.number(first), self.number(last), step.as_ref().map(|s| self.number(s)));
        let (Ok(first), Ok(last), Ok(by)) = (values.0, values.1, values.2.unwrap_or(Ok(1.0)))
        else {
            self.state.doubt.paths = true;
            let at = self.memory.place(variable.symbol);
            self.memory.set(at, Value::Poison, variable.span);
            return;
        };
        if by == 0.0 {
            let span = step.as_ref().map_or(self.here.span, |s| s.span);
            self.error(
                Diagnostic::error(codes::DO_WITHOUT_STEP, span, "the step of the loop is zero")
                    .help("a loop that counts down has a negative step"),
            );
        }
        if by == 0.0 || end == MISSING {
            // The body runs once, and what further passes would have done is not missed.
            self.state.doubt.paths = true;
            self.set_running(variable, first);
            return;
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates; the limit of executed statements ends such a loop"
        )]
        let passes = ((last - first) / by + 1.0 + PASS_SLACK).max(0.0) as u64;
        if passes == 0 {
            self.go_to(end + 1);
            return;
        }
        if !self.set_running(variable, first) {
            return;
        }
        let variable = *variable;
        if let Some(level) = self.levels.last_mut() {
            let start = place + 1;
            level.dos.push(DoLoop { start, end, variable, first, step: by, done: 1, passes });
        }
    }

    fn set_running(&mut self, variable: &Name, value: f64) -> bool {
        let place = self.memory.place(variable.symbol);
        match self.memory.slot(place).value {
            Value::Form(_) | Value::Array(_) => {
                let name = self.spelled(place);
                let given = self.memory.slot(place).given;
                self.error(
                    Diagnostic::error(
                        codes::KIND_CHANGED,
                        variable.span,
                        format!("{name} is no number and cannot count a loop"),
                    )
                    .also(given, "it is something else since here")
                    .help("use another name"),
                );
                false
            }
            _ => {
                self.memory.set(place, Value::Number(value), variable.span);
                // A counter is there to count, whether the body reads it or not.
                self.memory.slot_mut(place).read = true;
                true
            }
        }
    }

    /// Begins the next pass of a DO whose last statement was just executed, or ends the loop.
    pub(crate) fn next_pass(&mut self) {
        loop {
            let Some(level) = self.levels.last_mut() else { return };
            let (last, at) = (level.last, level.at);
            let Some(open) = level.dos.last_mut().filter(|d| d.end == last && at == last + 1)
            else {
                return;
            };
            if open.done >= open.passes {
                level.dos.pop();
                continue;
            }
            #[expect(clippy::cast_precision_loss, reason = "far fewer than 2**52 passes")]
            let value = open.first + open.step * open.done as f64;
            open.done += 1;
            let (start, variable) = (open.start, open.variable);
            if self.set_running(&variable, value) {
                self.go_to(start);
            } else if let Some(level) = self.levels.last_mut() {
                level.dos.pop();
            }
        }
    }

    /// The label that stands as an argument at `span`, and where it leads from the present statement.
    pub(crate) fn label_goal(&mut self, unit: &Unit, span: Span) -> Option<u32> {
        let level = self.levels.last()?;
        let label = self.interner.find(&unit.spelling(span));
        let goal = label.and_then(|label| level.plan.goal(level.last, label));
        if goal.is_none() {
            self.no_label(unit, span);
        }
        goal
    }

    /// Does what stands at `span` label a statement that the present one can go to?
    pub(crate) fn is_label(&self, unit: &Unit, span: Span) -> bool {
        let Some(level) = self.levels.last() else { return false };
        let label = self.interner.find(&unit.spelling(span));
        label.is_some_and(|label| level.plan.goal(level.last, label).is_some())
    }

    /// The names that PRINT, OBTAIN and the like take.
    pub(crate) fn as_name(kind: &ExprKind) -> Option<Name> {
        match kind {
            ExprKind::Name(name) => Some(*name),
            _ => None,
        }
    }
}
