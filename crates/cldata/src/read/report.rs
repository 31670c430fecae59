//! What a reader has to say about its file, each thing once.

use std::collections::BTreeMap;

use aptc_diagnostics::{Code, Diagnostic, FileId, Severity, Span, codes};

/// Most messages about single statements; further ones are counted.
const MOST: usize = 50;

/// Messages and counts of a file.
pub(super) struct Report {
    file: FileId,
    list: Vec<Diagnostic>,
    left_out: u64,
    unknown: BTreeMap<String, Seen>,
    notes: BTreeMap<(u16, &'static str), (Code, Severity, Seen)>,
}

/// How often something was met, and where first.
#[derive(Clone, Copy)]
struct Seen {
    count: u64,
    line: u64,
    span: Span,
}

/// A place in the file that is read.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place {
    pub(super) line: u64,
    pub(super) start: u64,
    pub(super) end: u64,
}

impl Place {
    pub(super) fn span(self, file: FileId) -> Span {
        let byte = |x: u64| u32::try_from(x).unwrap_or(u32::MAX);
        Span::new(file, byte(self.start), byte(self.end))
    }
}

impl Report {
    pub(super) fn new(file: FileId) -> Self {
        let (list, unknown, notes) = (Vec::new(), BTreeMap::new(), BTreeMap::new());
        Self { file, list, left_out: 0, unknown, notes }
    }

    pub(super) fn file(&self) -> FileId {
        self.file
    }

    /// A statement that cannot be carried out.
    pub(super) fn error(&mut self, at: Place, message: impl std::fmt::Display, help: &str) {
        if self.list.len() >= MOST {
            self.left_out += 1;
            return;
        }
        let message = format!("line {}: {message}", at.line);
        let d = Diagnostic::error(codes::UNREADABLE_CL, at.span(self.file), message);
        self.list.push(d.help(help));
    }

    /// A word that is in no table; it is kept.
    pub(super) fn unknown(&mut self, at: Place, word: &str) {
        // A file of rubbish has endless words; the table of them must not be endless.
        if let Some(seen) = self.unknown.get_mut(word) {
            seen.count += 1;
        } else if self.unknown.len() < 1000 {
            let seen = Seen { count: 1, line: at.line, span: at.span(self.file) };
            self.unknown.insert(word.to_owned(), seen);
        } else {
            self.left_out += 1;
        }
    }

    /// Something told once with a count; `what` says it in the field's words.
    pub(super) fn note(&mut self, at: Place, code: Code, severity: Severity, what: &'static str) {
        let first = Seen { count: 0, line: at.line, span: at.span(self.file) };
        let entry = self.notes.entry((code.number(), what)).or_insert((code, severity, first));
        entry.2.count += 1;
    }

    /// All messages in order of their kind.
    pub(super) fn into_diagnostics(mut self) -> Vec<Diagnostic> {
        for ((_, what), (code, severity, seen)) in self.notes {
            let message = format!("{what}, {}", times(seen));
            let d = match severity {
                Severity::Error => Diagnostic::error(code, seen.span, message),
                Severity::Warning => Diagnostic::warning(code, seen.span, message),
                Severity::Note => Diagnostic::note_at(code, seen.span, message),
            };
            self.list.push(d);
        }
        for (word, seen) in self.unknown {
            let message = format!("{word} is not known, {}", times(seen));
            self.list.push(
                Diagnostic::warning(codes::UNKNOWN_CL_WORD, seen.span, message)
                    .note("it is kept as it stands"),
            );
        }
        if self.left_out > 0 {
            let message = format!("{} more messages about this file are left out", self.left_out);
            let span = Place::default().span(self.file);
            self.list.push(Diagnostic::note_at(codes::UNREADABLE_CL, span, message));
        }
        self.list
    }
}

fn times(seen: Seen) -> String {
    if seen.count == 1 {
        format!("in line {}", seen.line)
    } else {
        format!("{} times, first in line {}", seen.count, seen.line)
    }
}
