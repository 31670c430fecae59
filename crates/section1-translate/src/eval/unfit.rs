//! Sculptured curves and surfaces that nothing meets: told where they are defined, as an error where they may be used.

use std::collections::BTreeSet;

use aptc_diagnostics::{Diagnostic, Severity, Span, codes};
use aptc_geometry::Form;
use aptc_geometry::sculpt::FitFault;
use aptc_syntax::Symbol;
use aptc_vocabulary::word;

use super::definition::FEW_POINTS;
use super::{Known, Poisoned};
use crate::Interpreter;

/// Messages about definitions that cannot be fitted.
#[derive(Debug, Default)]
pub(crate) struct Unfit {
    /// Of the definition just made, which has no name yet.
    now: Option<Diagnostic>,
    /// The places of names that were told.
    told: BTreeSet<Span>,
}

impl Interpreter<'_> {
    /// Refuses a curve or surface that nothing meets. Of an array that another system saved that is told where it is used: a file
    /// of them may hold more than a program needs.
    pub(super) fn fits(&mut self, form: &Form, span: Span) -> Known<()> {
        let (head, fault) = match form {
            Form::Scurv(c) => (word::SCURV, self.fits.curve(c).err()),
            Form::Ssurf(s) if s.extent().points > FEW_POINTS || s.only_checks() => return Ok(()),
            Form::Ssurf(s) => (word::SSURF, self.fits.surface(s).err()),
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

    /// What is defined within a statement is used where it stands.
    pub(super) fn unfit_in_place(&mut self) {
        let now = self.unfit.now.take();
        now.into_iter().for_each(|d| self.push(d));
    }

    /// What is given a name is an error where that stands elsewhere in what was read, too.
    pub(super) fn unfit_named(&mut self, name: Symbol, span: Span) {
        let Some(d) = self.unfit.now.take() else { return };
        if !self.unfit.told.insert(span) {
            return;
        }
        let severity =
            if self.stands_elsewhere(name) { Severity::Error } else { Severity::Warning };
        self.push(Diagnostic { severity, ..d });
    }

    /// Does a name stand in more than one place of all that was read, but for what is said of it? Where a text is not kept, or more is
    /// read, it counts as if it did.
    fn stands_elsewhere(&self, name: Symbol) -> bool {
        const READS: [&str; 2] = ["INCLUD", "READ"];
        const SAID: [&str; 5] = ["REMARK", "PARTNO", "PPRINT", "TITLES", "LETTER"];
        let name = self.interner.text(name);
        let files = || self.sources.iter().map(|(_, file)| file);
        let said = |line: &&str| {
            let begins =
                |word: &&str| line.get(..word.len()).is_some_and(|x| x.eq_ignore_ascii_case(word));
            SAID.iter().any(begins)
        };
        let lines = files().flat_map(|file| file.text.lines()).map(str::trim_start);
        let lines = lines.filter(|line| !said(line)).filter_map(|line| line.split("$$").next());
        let (mut named, mut more) = (0, files().any(|file| !file.is_kept()));
        for word in lines.flat_map(|line| line.split(|c: char| !c.is_ascii_alphanumeric())) {
            named += usize::from(word.eq_ignore_ascii_case(name));
            more |= READS.iter().any(|read| word.eq_ignore_ascii_case(read));
        }
        more || named > 1
    }
}
