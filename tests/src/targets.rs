//! What must hold for any input at all: the bodies of the fuzz targets, which tests also run over damaged
//! corpus programs.
//!
//! Each takes bytes, does its work, and panics when something is broken that the work itself would not
//! notice, such as a message that points outside its file.

use aptc_diagnostics::{Diagnostic, FileId};
use aptc_syntax::{Interner, Options, parse};

/// Lexer and parser: every statement and message lies within the text, on whole characters, in order.
pub fn syntax(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    for free_form in [false, true] {
        let options = Options { free_form, ..Options::default() };
        let parsed = parse(FileId(0), &text, &mut Interner::default(), &options);
        places_are_right(&text, &parsed.diagnostics);
        let mut last = 0;
        for statement in &parsed.program.statements {
            assert!(
                statement.span.start >= last,
                "statements out of order at {}",
                statement.span.start
            );
            assert!(text.get(range(statement.span.start, statement.span.end)).is_some());
            last = statement.span.start;
        }
    }
}

/// Every message about file 0 points at characters of `text`.
fn places_are_right(text: &str, diagnostics: &[Diagnostic]) {
    for diagnostic in diagnostics {
        let labels = diagnostic.labels.iter().map(|label| label.span);
        for span in labels.chain([diagnostic.span]).filter(|span| span.file == FileId(0)) {
            let there = text.get(range(span.start, span.end));
            assert!(there.is_some(), "{} points at {}..{}", diagnostic.code, span.start, span.end);
        }
        assert!(!diagnostic.message.is_empty(), "{} says nothing", diagnostic.code);
    }
}

fn range(start: u32, end: u32) -> std::ops::Range<usize> {
    let at = |n: u32| usize::try_from(n).expect("32 bits fit");
    at(start)..at(end)
}
