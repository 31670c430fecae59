//! The listing, X.lst: source with statement numbers, what PRINT printed, the CL data where CLPRNT asked for
//! it, and what was found.

use std::fmt::Write as _;

use aptc_cldata::{Clprnt, Kind, Record};
use aptc_diagnostics::{Diagnostic, Severity, SourceFile, SourceMap};
use aptc_edit::Listing as Table;
use aptc_protap::NameRef;
use aptc_translate::{Entry, EntryKind};

use crate::Part;

/// Writes the source of a part program with its line numbers.
pub(crate) fn source(out: &mut String, file: &SourceFile) {
    writeln!(out, "SOURCE  {}\n", file.name).expect("strings take all");
    for (line, text) in (1..).zip(file.text.lines()) {
        writeln!(out, "{line:>6}  {}", text.trim_end()).expect("strings take all");
    }
}

/// Writes the CL data that CLPRNT asks for: before and after the editor.
pub(crate) fn clprnt(out: &mut String, parts: &[Part]) {
    for part in parts {
        let asks =
            |what| part.computed.iter().any(|r| matches!(&r.kind, Kind::Clprnt(w) if *w == what));
        if asks(Clprnt::Whole) {
            table(out, "CL DATA", Table::whole(), &part.edited);
            continue;
        }
        table(out, "CL DATA", Table::parts(), &part.edited);
        if asks(Clprnt::Option) {
            table(out, "CL DATA BEFORE TRANSFORMATION", Table::before_editing(), &part.computed);
        }
    }
}

fn table(out: &mut String, title: &str, mut listing: Table, records: &[Record]) {
    let mut text = String::new();
    for record in records {
        listing.push(record, &mut text);
    }
    if !text.is_empty() {
        writeln!(out, "\n{title}\n\n{text}").expect("strings take all");
    }
}

/// Writes what the program printed.
pub(crate) fn printed(out: &mut String, entries: &[Entry]) {
    if entries.is_empty() {
        return;
    }
    out.push_str("\nPRINTED\n\n");
    for entry in entries {
        let isn = entry.origin.isn;
        match &entry.kind {
            EntryKind::Page => out.push('\n'),
            EntryKind::Title { text, right } => {
                let width = if *right { 60 } else { 0 };
                line(out, isn, &format!("{:width$}{text}", ""));
            }
            EntryKind::Scalar { name, value } => {
                line(out, isn, &format!("{:<12}{:<8}{}", label(name), "SCALAR", number(*value)));
            }
            EntryKind::Form { name, word, elements } => {
                form(out, isn, &label(name), word, elements);
            }
            EntryKind::Bits { name, word, elements } => {
                let name = label(&Some(name.clone()));
                let bits: Vec<_> =
                    elements.iter().map(|x| format!("{:016X}", x.to_bits())).collect();
                line(out, isn, &format!("{name:<12}{word:<8}{}", bits.join(" ")));
            }
            EntryKind::Undefined { name } => {
                line(out, isn, &format!("{:<12}UNDEFINED", label(&Some(name.clone()))));
            }
            EntryKind::Remark(text) => line(out, isn, &format!("$$ {text}")),
        }
    }
}

/// Writes the messages, one line each.
pub(crate) fn messages(out: &mut String, diagnostics: &[Diagnostic], sources: &SourceMap) {
    if diagnostics.is_empty() {
        return;
    }
    out.push_str("\nMESSAGES\n\n");
    for d in diagnostics {
        let (line, column) = sources.line_column(d.span.file, d.span.start);
        let severity = match d.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
        };
        writeln!(out, "{line:>6}  {severity} {} column {column}: {}", d.code, d.message)
            .expect("strings take all");
    }
}

fn line(out: &mut String, isn: u32, text: &str) {
    writeln!(out, "{isn:>6}  {}", text.trim_end()).expect("strings take all");
}

fn form(out: &mut String, isn: u32, name: &str, word: &str, elements: &[f64]) {
    /// Elements on a line.
    const ROW: usize = 4;
    for (i, row) in elements.chunks(ROW).enumerate() {
        let row: String = row.iter().map(|x| format!("{:>18}", number(*x))).collect();
        if i == 0 {
            line(out, isn, &format!("{name:<12}{word:<8}{row}"));
        } else {
            line(out, isn, &format!("{:20}{row}", ""));
        }
    }
    if elements.is_empty() {
        line(out, isn, &format!("{name:<12}{word:<8}"));
    }
}

fn label(name: &Option<NameRef>) -> String {
    match name {
        Some(n) if n.subscript > 0 => format!("{}({})", n.name, n.subscript),
        Some(n) => n.name.to_string(),
        None => String::new(),
    }
}

/// Ten figures, without trailing zeros; large and small numbers with an exponent.
fn number(x: f64) -> String {
    if x != 0.0 && !(1e-5..1e10).contains(&x.abs()) {
        return format!("{x:.9E}");
    }
    let text = format!("{x:.9}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(number(0.5), "0.5");
        assert_eq!(number(-0.000_000_000_01), "-1.000000000E-11");
        assert_eq!(number(3.0), "3");
        assert_eq!(number(-0.0), "0");
    }
}
