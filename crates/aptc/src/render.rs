//! Messages for people and programs: ariadne, one line, JSON lines, SARIF.

use std::collections::BTreeSet;
use std::fmt;
use std::io::{self, Write};

use aptc_diagnostics::{Diagnostic, FileId, FrameKind, Severity, SourceMap, Span};
use ariadne::{Cache, Config, IndexType, Label, Report, ReportKind, Source};
use serde_json::{Value, json};

use crate::cli::MessageFormat;
use crate::plain::plain;

/// Writes all messages in the chosen form.
pub(crate) fn render(
    out: &mut dyn Write,
    diagnostics: &[Diagnostic],
    sources: &SourceMap,
    format: MessageFormat,
    color: bool,
) -> io::Result<()> {
    match format {
        MessageFormat::Human => human(out, diagnostics, sources, color),
        MessageFormat::Short => short(out, diagnostics, sources),
        MessageFormat::Json => {
            for d in diagnostics {
                writeln!(out, "{}", to_json(d, sources))?;
            }
            Ok(())
        }
        MessageFormat::Sarif => writeln!(out, "{:#}", sarif(diagnostics, sources)),
    }
}

fn human(out: &mut dyn Write, all: &[Diagnostic], map: &SourceMap, color: bool) -> io::Result<()> {
    let mut named = Named {
        sources: map.iter().map(|(_, f)| Source::from(plain(&f.text).into_owned())).collect(),
        map,
    };
    let config = Config::default().with_index_type(IndexType::Byte).with_color(color);
    for d in all {
        let kind = match d.severity {
            Severity::Error => ReportKind::Error,
            Severity::Warning => ReportKind::Warning,
            Severity::Note => ReportKind::Advice,
        };
        // A message about the whole run has no place: line 1 would only mislead.
        let no_place = d.span == Span::default() && d.label.is_empty() && d.labels.is_empty();
        if no_place || map.get(d.span.file).is_none() {
            writeln!(out, "{}[{}]: {}", severity_word(d.severity), d.code, plain(&d.message))?;
            tail(out, d)?;
            continue;
        }
        if map.get(d.span.file).is_some_and(|f| !f.is_kept()) {
            let (line, column) = map.line_column(d.span.file, d.span.start);
            let name = map.get(d.span.file).map_or("aptc", |f| &f.name);
            writeln!(out, "{}[{}]: {}", severity_word(d.severity), d.code, plain(&d.message))?;
            writeln!(out, "  --> {name}:{line}:{column}")?;
            tail(out, d)?;
            continue;
        }
        let place = (d.span.file, d.span.start as usize..d.span.end.max(d.span.start) as usize);
        let mut report = Report::build(kind, place.clone())
            .with_config(config)
            .with_code(d.code)
            .with_message(plain(&d.message))
            .with_label(Label::new(place).with_message(plain(&d.label)).with_order(-1));
        for l in d.labels.iter().filter(|l| map.get(l.span.file).is_some()) {
            let place = (l.span.file, l.span.start as usize..l.span.end.max(l.span.start) as usize);
            report = report.with_label(Label::new(place).with_message(plain(&l.text)));
        }
        for note in notes(d) {
            report.add_note(plain(&note));
        }
        if let Some(help) = &d.help {
            report.set_help(plain(help));
        }
        report.finish().write(&mut named, &mut *out)?;
    }
    Ok(())
}

/// The sources, cut into lines once, under the names that the user gave.
struct Named<'a> {
    sources: Vec<Source<String>>,
    map: &'a SourceMap,
}

impl Cache<FileId> for Named<'_> {
    type Storage = String;

    fn fetch(&mut self, id: &FileId) -> Result<&Source<String>, impl fmt::Debug> {
        self.sources.get(id.0 as usize).ok_or("no such file")
    }

    fn display<'a>(&self, id: &'a FileId) -> Option<impl fmt::Display + 'a> {
        self.map.get(*id).map(|f| f.name.to_string())
    }
}

/// The notes of the message and the expansions around it, in words.
fn notes(d: &Diagnostic) -> Vec<String> {
    let frames = std::iter::successors(d.trace.as_deref(), |f| f.outer.as_deref());
    let traced = frames.take(20).map(|f| match f.kind {
        FrameKind::Macro => format!("in macro {} called at line {}", f.name, f.line),
        FrameKind::Loop => format!("in the loop at line {} ({})", f.line, f.name),
        FrameKind::Include => format!("in {} read at line {}", f.name, f.line),
    });
    d.notes.iter().cloned().chain(traced).collect()
}

fn tail(out: &mut dyn Write, d: &Diagnostic) -> io::Result<()> {
    for note in notes(d) {
        writeln!(out, "  note: {}", plain(&note))?;
    }
    d.help.as_ref().map_or(Ok(()), |h| writeln!(out, "  help: {}", plain(h)))
}

fn short(out: &mut dyn Write, all: &[Diagnostic], map: &SourceMap) -> io::Result<()> {
    for d in all {
        let name = map.get(d.span.file).map_or("aptc", |f| &f.name);
        let (line, column) = map.line_column(d.span.file, d.span.start);
        let (severity, code) = (severity_word(d.severity), d.code);
        writeln!(out, "{name}:{line}:{column}: {severity}[{code}]: {}", plain(&d.message))?;
    }
    Ok(())
}

/// One message as a JSON object: code, severity, message, file, line, column, end_line, end_column,
/// label, labels, notes, help, trace. Lines and columns count from 1.
pub(crate) fn to_json(d: &Diagnostic, map: &SourceMap) -> Value {
    let name = |id: FileId| map.get(id).map(|f| f.name.to_string());
    let (line, column) = map.line_column(d.span.file, d.span.start);
    let (end_line, end_column) = map.line_column(d.span.file, d.span.end);
    let labels: Vec<Value> = d
        .labels
        .iter()
        .map(|l| {
            let (line, column) = map.line_column(l.span.file, l.span.start);
            let (end_line, end_column) = map.line_column(l.span.file, l.span.end);
            json!({"file": name(l.span.file), "line": line, "column": column,
                   "end_line": end_line, "end_column": end_column, "text": l.text})
        })
        .collect();
    let frames = std::iter::successors(d.trace.as_deref(), |f| f.outer.as_deref());
    let trace: Vec<Value> =
        frames.map(|f| json!({"kind": f.kind, "name": f.name, "line": f.line})).collect();
    json!({"code": d.code, "severity": d.severity, "message": d.message, "file": name(d.span.file),
           "line": line, "column": column, "end_line": end_line, "end_column": end_column,
           "label": d.label, "labels": labels, "notes": d.notes, "help": d.help, "trace": trace})
}

fn sarif(all: &[Diagnostic], map: &SourceMap) -> Value {
    let used: BTreeSet<_> = all.iter().map(|d| d.code).collect();
    let rules: Vec<Value> =
        used.iter().map(|c| json!({"id": c, "shortDescription": {"text": c.title()}})).collect();
    let results: Vec<Value> = all.iter().map(|d| sarif_result(d, map)).collect();
    json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": {"driver": {"name": "aptc", "version": env!("CARGO_PKG_VERSION"), "rules": rules}},
            "columnKind": "unicodeCodePoints",
            "results": results,
        }],
    })
}

fn sarif_result(d: &Diagnostic, map: &SourceMap) -> Value {
    let (line, column) = map.line_column(d.span.file, d.span.start);
    let (end_line, end_column) = map.line_column(d.span.file, d.span.end);
    let text = d.help.as_ref().map_or(d.message.clone(), |h| format!("{}; help: {h}", d.message));
    let mut result = json!({"ruleId": d.code, "level": severity_word(d.severity),
                            "message": {"text": text}});
    if let Some(file) = map.get(d.span.file) {
        result["locations"] = json!([{"physicalLocation": {
            "artifactLocation": {"uri": &*file.name},
            "region": {"startLine": line, "startColumn": column,
                       "endLine": end_line, "endColumn": end_column}}}]);
    }
    result
}

fn severity_word(s: Severity) -> &'static str {
    match s {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}
