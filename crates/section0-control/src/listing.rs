//! The listing, X.lst: source with line numbers, what PRINT printed, the CL data where CLPRNT asked for
//! it, and what was found.

use std::fmt::Write as _;
use std::io;

use aptc_cldata::{Clprnt, Kind};
use aptc_diagnostics::{Diagnostic, Severity, SourceFile, SourceMap};
use aptc_edit::Listing as Table;
use aptc_protap::NameRef;
use aptc_translate::{Entry, EntryKind};

use crate::{Compiled, Records};

/// Writes the listing of all parts.
pub(crate) fn write(out: &mut dyn io::Write, compiled: &Compiled) -> io::Result<()> {
    let mut text = String::new();
    for (_, file) in compiled.sources.iter().take(1) {
        source(&mut text, file);
    }
    printed(&mut text, &compiled.printed);
    saved(&mut text, &compiled.printed);
    out.write_all(text.as_bytes())?;
    clprnt(out, compiled)?;
    text.clear();
    messages(&mut text, &compiled.diagnostics, &compiled.sources);
    out.write_all(text.as_bytes())
}

/// Writes the source of a part program with its line numbers.
fn source(out: &mut String, file: &SourceFile) {
    writeln!(out, "SOURCE  {}\n", file.name).expect("strings take all");
    for (line, text) in (1..).zip(file.text.lines()) {
        writeln!(out, "{line:>6}  {}", text.trim_end()).expect("strings take all");
    }
}

/// Writes the CL data that CLPRNT asks for: before and after the editor.
fn clprnt(out: &mut dyn io::Write, compiled: &Compiled) -> io::Result<()> {
    for part in &compiled.parts {
        let (mut whole, mut option) = (false, false);
        part.computed.for_each(|r| {
            whole |= matches!(r.kind, Kind::Clprnt(Clprnt::Whole));
            option |= matches!(r.kind, Kind::Clprnt(Clprnt::Option));
        })?;
        if whole {
            table(out, "CL DATA", Table::whole(), &part.edited)?;
            continue;
        }
        table(out, "CL DATA", Table::parts(), &part.edited)?;
        if option {
            table(out, "CL DATA BEFORE TRANSFORMATION", Table::before_editing(), &part.computed)?;
        }
    }
    Ok(())
}

fn table(
    out: &mut dyn io::Write,
    title: &str,
    mut listing: Table,
    records: &Records,
) -> io::Result<()> {
    let (mut text, mut begun) = (String::new(), false);
    records.try_for_each(|record| {
        listing.push(record, &mut text);
        if text.is_empty() {
            return Ok(());
        }
        if !begun {
            write!(out, "\n{title}\n\n")?;
            begun = true;
        }
        out.write_all(text.as_bytes())?;
        text.clear();
        Ok(())
    })?;
    if begun { writeln!(out) } else { Ok(()) }
}

/// Writes what the program printed.
fn printed(out: &mut String, entries: &[Entry]) {
    let saved = |e: &&Entry| matches!(e.kind, EntryKind::Saved(_));
    if entries.iter().all(|e| saved(&e)) {
        return;
    }
    out.push_str("\nPRINTED\n\n");
    for entry in entries {
        let at = entry.origin.line;
        match &entry.kind {
            EntryKind::Page => out.push('\n'),
            EntryKind::Title { text, right } => {
                let width = if *right { 60 } else { 0 };
                line(out, at, &format!("{:width$}{text}", ""));
            }
            EntryKind::Scalar { name, value } => {
                line(out, at, &format!("{:<12}{:<8}{}", label(name), "SCALAR", number(*value)));
            }
            EntryKind::Form { name, word, elements } => {
                form(out, at, &label(name), word, elements);
            }
            EntryKind::Bits { name, word, elements } => {
                let name = label(&Some(name.clone()));
                let bits: Vec<_> =
                    elements.iter().map(|x| format!("{:016X}", x.to_bits())).collect();
                line(out, at, &format!("{name:<12}{word:<8}{}", bits.join(" ")));
            }
            EntryKind::Undefined { name } => {
                line(out, at, &format!("{:<12}UNDEFINED", label(&Some(name.clone()))));
            }
            EntryKind::Remark(text) => line(out, at, &format!("$$ {text}")),
            EntryKind::Saved(_) => {}
        }
    }
}

/// Writes what PUNCH saved, as cards of a file for READ/1.
fn saved(out: &mut String, entries: &[Entry]) {
    let mut title = "\nPUNCHED\n\n";
    for entry in entries {
        if let EntryKind::Saved(card) = &entry.kind {
            writeln!(out, "{title}{card}").expect("strings take all");
            title = "";
        }
    }
}

/// Writes the messages, one line each.
fn messages(out: &mut String, diagnostics: &[Diagnostic], sources: &SourceMap) {
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

fn line(out: &mut String, at: u32, text: &str) {
    writeln!(out, "{at:>6}  {}", text.trim_end()).expect("strings take all");
}

fn form(out: &mut String, at: u32, name: &str, word: &str, elements: &[f64]) {
    /// Elements on a line.
    const ROW: usize = 4;
    for (i, row) in elements.chunks(ROW).enumerate() {
        let row: String = row.iter().map(|x| format!("{:>18}", number(*x))).collect();
        if i == 0 {
            line(out, at, &format!("{name:<12}{word:<8}{row}"));
        } else {
            line(out, at, &format!("{:20}{row}", ""));
        }
    }
    if elements.is_empty() {
        line(out, at, &format!("{name:<12}{word:<8}"));
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
