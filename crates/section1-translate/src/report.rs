//! Messages of a run: each fault once a place, however often a loop passes it.

use std::collections::HashSet;

use aptc_diagnostics::{Diagnostic, FrameKind, Span};

/// The messages so far.
#[derive(Debug, Default)]
pub(crate) struct Reports {
    messages: Vec<Diagnostic>,
    seen: HashSet<(u16, Span, Option<Span>)>,
    n_told: usize,
    n_errors: usize,
    /// Where the last error is.
    last_error: Option<Span>,
    n_dropped: usize,
    /// Is what comes left untold, as it follows from what was told?
    pub(crate) muted: bool,
}

impl Reports {
    /// Was an error told of a statement, given by its span?
    pub(crate) fn has_error_in(&self, statement: Span) -> bool {
        self.last_error.is_some_and(|e| {
            e.file == statement.file && e.start >= statement.start && e.end <= statement.end
        })
    }

    /// Takes a message in, unless the same fault was told for this place and call already.
    pub(crate) fn push(&mut self, message: Diagnostic, limit: usize) {
        if self.muted {
            return;
        }
        let frames = std::iter::successors(message.trace.as_deref(), |f| f.outer.as_deref());
        let caller = frames.filter(|f| f.kind != FrameKind::Loop).map(|f| f.span).next();
        if !self.seen.insert((message.code.number(), message.span, caller)) {
            return;
        }
        if message.is_error() {
            self.last_error = Some(message.span);
        }
        self.n_errors += usize::from(message.is_error());
        if self.n_told < limit {
            self.n_told += 1;
            self.messages.push(message);
        } else {
            self.n_dropped += 1;
        }
    }

    /// How many errors were told.
    pub(crate) fn n_errors(&self) -> usize {
        self.n_errors
    }

    /// How many messages are not among those given out.
    pub(crate) fn n_dropped(&self) -> usize {
        self.n_dropped
    }

    /// The messages since the last time.
    pub(crate) fn take(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.messages)
    }
}
