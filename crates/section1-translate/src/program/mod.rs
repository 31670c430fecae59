//! Files as they are executed: statements, and the plan of their labels, macros and loops.

mod foreign;
mod plan;
mod synonyms;
mod targets;

use std::sync::Arc;

use aptc_diagnostics::Span;
use aptc_syntax::tree::{Expr, ExprKind, Program};
use aptc_syntax::{Interner, Symbol};

pub(crate) use foreign::{foreign, has, sculptured, untranslated};
pub(crate) use plan::{MISSING, Plan, Role, Surroundings, plan};
pub(crate) use synonyms::Synonyms;

/// A parsed file.
#[derive(Debug)]
pub(crate) struct Unit {
    /// Its text.
    pub(crate) text: Arc<str>,
    /// Its name when it is not the main part program.
    pub(crate) name: Option<Arc<str>>,
    /// Its statements.
    pub(crate) program: Program,
}

impl Unit {
    /// The label that an argument spells: a name, or digits as they stand in the text.
    pub(crate) fn label(&self, interner: &Interner, argument: &Expr) -> Option<Symbol> {
        match &argument.kind {
            ExprKind::Name(name) => Some(name.symbol),
            ExprKind::Number(_) => self.digits(interner, argument.span),
            _ => None,
        }
    }

    /// The label that the digits at `span` spell.
    pub(crate) fn digits(&self, interner: &Interner, span: Span) -> Option<Symbol> {
        interner.find(&self.spelling(span))
    }

    /// The text at `span` in upper case without blanks.
    pub(crate) fn spelling(&self, span: Span) -> String {
        let text = self.text.get(span.start as usize..span.end as usize).unwrap_or_default();
        let compact = text.chars().filter(|c| !c.is_whitespace());
        compact.map(|c| c.to_ascii_uppercase()).collect()
    }
}
