//! The message itself.

use serde::{Deserialize, Serialize};

use crate::{Code, Span, Trace};

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// Told for information; changes nothing.
    Note,
    /// The program runs, but the machinist should know.
    Warning,
    /// The program is not carried out as written.
    Error,
}

/// A place with words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Where.
    pub span: Span,
    /// What is to be seen there.
    pub text: String,
}

/// One message to the user about his program.
///
/// Small letters, no full stop, the user's own names and numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The stable code, which has a page of its own.
    pub code: Code,
    /// How bad it is.
    pub severity: Severity,
    /// The place that is at fault.
    pub span: Span,
    /// What is wrong.
    pub message: String,
    /// Words at the place itself; empty when the message says it all.
    pub label: String,
    /// Further places.
    pub labels: Vec<Label>,
    /// Facts that explain.
    pub notes: Vec<String>,
    /// What to do; only when doing it is right.
    pub help: Option<String>,
    /// Macro calls, loops and includes around the place, innermost first.
    pub trace: Trace,
}

impl Diagnostic {
    /// An error at `span`.
    pub fn error(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self::new(code, Severity::Error, span, message.into())
    }

    /// A warning at `span`.
    pub fn warning(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self::new(code, Severity::Warning, span, message.into())
    }

    /// A note at `span`.
    pub fn note_at(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self::new(code, Severity::Note, span, message.into())
    }

    fn new(code: Code, severity: Severity, span: Span, message: String) -> Self {
        let (label, labels, notes) = (String::new(), Vec::new(), Vec::new());
        Self { code, severity, span, message, label, labels, notes, help: None, trace: None }
    }

    /// Words at the place itself.
    #[must_use]
    pub fn label(mut self, text: impl Into<String>) -> Self {
        self.label = text.into();
        self
    }

    /// A further place.
    #[must_use]
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push(Label { span, text: text.into() });
        self
    }

    /// A fact that explains.
    #[must_use]
    pub fn note(mut self, text: impl Into<String>) -> Self {
        self.notes.push(text.into());
        self
    }

    /// What to do.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help = Some(text.into());
        self
    }

    /// The expansions around the place.
    #[must_use]
    pub fn within(mut self, trace: Trace) -> Self {
        self.trace = trace;
        self
    }

    /// Is it an error?
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}
