//! From a case to what the Sections make of it.

use std::path::Path;

use aptc_control::{
    Artifact, Compiled, Disk, Machine, MachineChoice, Options, RecordWriter as _, TextOptions,
    TextWriter, UnknownWords,
};
use aptc_diagnostics::{Diagnostic, FileId, Severity, SourceMap};

use crate::case::Case;
use crate::run::{Message, Outputs};

/// Largest file of a case, in bytes.
const LARGEST: u64 = 64 << 20;

/// Compiles a case with its settings.
///
/// # Errors
/// When the program or its machine file cannot be read.
pub fn compile(case: &Case) -> Result<Outputs, String> {
    let path = &case.program;
    let unreadable = |path: &Path, error: aptc_control::WorldError| {
        format!("cannot read {}: {error}", path.display())
    };
    let mut source = Disk::open(path, LARGEST).map_err(|error| unreadable(path, error))?;
    // Messages and listings name the file as the case does, wherever it lies.
    let name = path.file_name().unwrap_or_default();
    source.name = name.to_string_lossy().into_owned().into();
    let mut options = Options { keep_protap: true, plot: false, ..Options::default() };
    options.translate.free_form = case.settings.free_form;
    if case.settings.deny_unknown_words {
        options.translate.unknown_words = UnknownWords::Refuse;
    }
    if let Some(most) = case.settings.max_statements {
        options.translate.limits.statements = most;
    }
    options.code.machine = match case.settings.machine.as_deref() {
        Some(name) if name.ends_with(".toml") => {
            let path = case.folder().join(name);
            let text = Disk::open(&path, LARGEST).map_err(|error| unreadable(&path, error))?.text;
            let wrong = |found: Vec<Diagnostic>| {
                let first = found.first().map_or("", |d| d.message.as_str());
                format!("{}: {first}", path.display())
            };
            Some(MachineChoice::Read(Box::new(Machine::parse(&text).map_err(wrong)?)))
        }
        name => name.map(|name| MachineChoice::Named(name.to_owned())),
    };
    let mut world = Disk::new(case.include_folders(), LARGEST);
    let mut outputs = outputs(&aptc_control::compile(source, &mut world, &options));
    // Goldens do not know where their folder lies.
    let here = case.folder().display().to_string();
    for message in &mut outputs.messages {
        message.text = message.text.replace(&here, ".");
        message.more = message.more.replace(&here, ".");
    }
    Ok(outputs)
}

fn outputs(compiled: &Compiled) -> Outputs {
    let whole = compiled.is_cl_whole();
    let first = |kind| {
        let files = compiled.artifact(kind, false).expect("memory is read").into_iter();
        let texts = files.map(|(_, bytes)| String::from_utf8_lossy(&bytes).into_owned());
        // Several part programs or machines in one file: one golden, one after the other.
        let all: Vec<String> = texts.collect();
        (!all.is_empty()).then(|| all.concat())
    };
    Outputs {
        protap: first(Artifact::Protap),
        cl: whole.then(|| cl_text(compiled)),
        edited_cl: first(Artifact::Cl),
        nc: first(Artifact::Nc),
        messages: messages(&compiled.diagnostics, &compiled.sources),
    }
}

/// CL data of Section 2.
fn cl_text(compiled: &Compiled) -> String {
    let mut bytes = Vec::new();
    let mut writer = TextWriter::new(&mut bytes, TextOptions::default());
    for part in &compiled.parts {
        part.computed.try_for_each(|record| writer.write(record)).expect("memory takes all");
    }
    writer.finish().expect("memory takes all");
    drop(writer);
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Messages as goldens know them, in their order.
fn messages(diagnostics: &[Diagnostic], sources: &SourceMap) -> Vec<Message> {
    diagnostics.iter().map(|diagnostic| message(diagnostic, sources)).collect()
}

fn message(d: &Diagnostic, sources: &SourceMap) -> Message {
    let (line, first) = sources.line_column(d.span.file, d.span.start);
    let (last_line, end) = sources.line_column(d.span.file, d.span.end);
    let last = if last_line == line && end > first { end - 1 } else { first };
    let here = d.span.file == FileId(0);
    let place = |span: aptc_diagnostics::Span| {
        let name = sources.get(span.file).map_or("", |file| &file.name);
        let name = if span.file == FileId(0) { String::new() } else { format!("{name} ") };
        let (line, column) = sources.line_column(span.file, span.start);
        format!("{name}line {line} column {column}")
    };
    let mut more = Vec::new();
    if !here {
        more.push(format!("at {}", place(d.span)));
    }
    if !d.label.is_empty() {
        more.push(format!("here: {}", d.label));
    }
    more.extend(d.labels.iter().map(|label| format!("{}: {}", place(label.span), label.text)));
    more.extend(d.notes.iter().map(|note| format!("note: {note}")));
    let frames = std::iter::successors(d.trace.as_deref(), |frame| frame.outer.as_deref());
    more.extend(frames.map(|frame| format!("in {} at line {}", frame.name, frame.line)));
    more.extend(d.help.iter().map(|help| format!("help: {help}")));
    let severity = match d.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    };
    Message {
        severity,
        code: d.code.to_string(),
        line: if here { line } else { 0 },
        columns: (first, last),
        text: d.message.clone(),
        more: more.join("\n"),
    }
}
