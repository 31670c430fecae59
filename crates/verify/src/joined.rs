//! The way from where DNTCUT left the tool to where CUT puts it out again: no statement asks for it, and what the tool goes through
//! on it is told.

use std::sync::Arc;

use aptc_cldata::{Control, Position};
use aptc_diagnostics::{Diagnostic, Origin};
use aptc_geometry::Profile;

use crate::certificate::Fault;
use crate::coming::Coming;
use crate::sheets::Sheets;
use crate::statement::Statement;

/// A straight way over motions that were not put out.
#[derive(Debug)]
pub(crate) struct Joined {
    pub(crate) origin: Origin,
    pub(crate) from: Position,
    pub(crate) to: Position,
    pub(crate) profile: Profile,
    pub(crate) pad: f64,
}

/// Holds such ways against the surfaces of the motions before and after them.
#[derive(Debug, Default)]
pub(crate) struct Joins {
    before: Option<(Arc<Control>, Sheets)>,
    /// Those since the last motion along surfaces that went through none of its surfaces.
    waiting: Vec<Arc<Joined>>,
}

impl Joins {
    /// A way; what it goes through of the motion before it.
    pub(crate) fn next(&mut self, joined: &Arc<Joined>) -> Option<Diagnostic> {
        let through =
            self.before.as_ref().and_then(|(control, sheets)| joined.through(control, sheets));
        if through.is_none() {
            self.waiting.push(Arc::clone(joined));
        }
        through
    }

    /// A motion along surfaces; what the ways before it go through of its surfaces.
    pub(crate) fn along(&mut self, next: &Statement) -> Vec<Diagnostic> {
        let waiting = std::mem::take(&mut self.waiting);
        self.before = Some((Arc::clone(&next.control), next.sheets.clone()));
        waiting.iter().filter_map(|joined| joined.through(&next.control, &next.sheets)).collect()
    }
}

impl Joined {
    fn through(&self, control: &Control, sheets: &Sheets) -> Option<Diagnostic> {
        let coming = Coming::new(control, sheets, &self.profile, &self.from, false);
        let fault = coming.fault(&self.profile, &self.from, &self.to, self.pad)?;
        Some(self.told(&fault))
    }

    fn told(&self, fault: &Fault) -> Diagnostic {
        let who = "the tool goes straight from where DNTCUT left it to where CUT puts it out,";
        let help = "put CUT before a motion that leads round it, or lift the tool before DNTCUT";
        fault.through(&self.origin, who, help)
    }
}
