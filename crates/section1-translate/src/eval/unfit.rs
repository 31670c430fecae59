//! Sculptured curves and surfaces that nothing meets: told where they are defined, as an error once they are used.

use std::collections::BTreeMap;

use aptc_diagnostics::{Diagnostic, Severity, Span, codes};
use aptc_geometry::Form;
use aptc_geometry::sculpt::{FitFault, fit_curve, fit_surface};
use aptc_vocabulary::word;

use super::definition::FEW_POINTS;
use super::{Known, Poisoned};
use crate::Interpreter;

/// Messages about definitions that are not used yet.
#[derive(Debug, Default)]
pub(crate) struct Unfit {
    /// Of the definition just made, which has no name yet.
    now: Option<Diagnostic>,
    /// By the place of the name that was given.
    named: BTreeMap<Span, Diagnostic>,
}

impl Interpreter<'_> {
    /// Refuses a curve or surface that nothing meets. Of an array that another system saved that is told where it is used: a file
    /// of them may hold more than a program needs.
    pub(super) fn fits(&mut self, form: &Form, span: Span) -> Known<()> {
        let (head, fault) = match form {
            Form::Scurv(c) => (word::SCURV, fit_curve(c).err()),
            Form::Ssurf(s) if s.extent().points > FEW_POINTS || s.only_checks() => return Ok(()),
            Form::Ssurf(s) => (word::SSURF, fit_surface(s).err()),
            _ => return Ok(()),
        };
        let Some(why) = fault.filter(|why| *why != FitFault::Canonical) else { return Ok(()) };
        let message = format!("this {head} cannot be fitted: {why}");
        let d = Diagnostic::error(codes::UNFIT_SURFACE, span, message).within(self.trace());
        let split = "CURSEG is one conic arc: give several, put together by COMBIN, or a SPLINE";
        let d = if matches!(why, FitFault::Conic(_)) { d.help(split) } else { d };
        self.unfit.now = Some(d);
        Err(Poisoned)
    }

    /// What has no name is used where it stands.
    pub(super) fn told_at_once(&mut self) {
        let told = self.unfit.now.take();
        told.into_iter().for_each(|d| self.push(d));
    }

    /// The name given at `span` has no value.
    pub(super) fn told_when_used(&mut self, span: Span) {
        self.unfit.named.extend(self.unfit.now.take().map(|d| (span, d)));
    }

    /// A name that was given at `span` is used, and has no value.
    pub(super) fn blame_unfit(&mut self, span: Span) {
        if self.is_muted() {
            return;
        }
        let told = self.unfit.named.remove(&span);
        told.into_iter().for_each(|d| self.push(d));
    }

    /// At the end of the program, what was never used is no error.
    pub(crate) fn report_unfit(&mut self) {
        for (_, d) in std::mem::take(&mut self.unfit.named) {
            self.push(Diagnostic { severity: Severity::Warning, ..d });
        }
    }
}
