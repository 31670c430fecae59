//! Running programs in tests.
#![expect(dead_code, reason = "each test file uses some of it")]

use std::collections::BTreeMap;

use aptc_diagnostics::{Diagnostic, codes};
use aptc_protap::{Kind, NameRef, Outcome, Record};
use aptc_translate::{
    Entry, FileError, FileRequest, Files, Interpreter, LoadedFile, NoFiles, Options, Quantity, Step,
};

/// What came of a program.
pub(crate) struct Ran {
    pub(crate) records: Vec<Record>,
    pub(crate) diagnostics: Vec<Diagnostic>,
    pub(crate) listing: Vec<Entry>,
    pub(crate) geometry: Vec<(NameRef, Quantity)>,
    pub(crate) executed: u64,
    lines: Vec<u32>,
}

/// Files by name.
#[derive(Default)]
pub(crate) struct Shelf<'t>(pub(crate) BTreeMap<&'static str, &'t str>);

impl Files for Shelf<'_> {
    fn read(&mut self, request: &FileRequest) -> Result<LoadedFile, FileError> {
        match self.0.get(&*request.name) {
            Some(text) => Ok(LoadedFile { name: request.name.clone(), text: (*text).into() }),
            None => {
                let message = format!("no file {}", request.name);
                Err(FileError { code: codes::NOT_READ, message, help: None })
            }
        }
    }
}

/// Runs `text` without files, limits as by default, outcomes all empty.
pub(crate) fn run(text: &str) -> Ran {
    run_with(text, &mut NoFiles, Options::default(), |_| Outcome::None)
}

/// Runs `text`; `outcome` answers to each record.
pub(crate) fn run_with(
    text: &str,
    files: &mut dyn Files,
    options: Options,
    mut outcome: impl FnMut(&Record) -> Outcome,
) -> Ran {
    let mut program = Interpreter::new("test.apt", text, files, options);
    let mut records = Vec::new();
    while let Step::Record(record) = program.step() {
        program.outcome(outcome(&record));
        records.push(record);
    }
    let diagnostics = program.take_diagnostics();
    let line = |d: &Diagnostic| program.sources().line_column(d.span.file, d.span.start).0;
    Ran {
        lines: diagnostics.iter().map(line).collect(),
        geometry: program.geometry(),
        executed: program.n_executed(),
        listing: program.take_listing(),
        records,
        diagnostics,
    }
}

impl Ran {
    /// Codes and lines of the messages, in order of line.
    pub(crate) fn told(&self) -> Vec<(u16, u32)> {
        let mut told: Vec<_> =
            self.diagnostics.iter().zip(&self.lines).map(|(d, l)| (d.code.number(), *l)).collect();
        told.sort_by_key(|(code, line)| (*line, *code));
        told
    }

    /// The messages with their help, for a failing test.
    pub(crate) fn messages(&self) -> String {
        let line = |(d, l): (&Diagnostic, &u32)| {
            format!("line {l}: {} {} ({})\n", d.code, d.message, d.help.as_deref().unwrap_or(""))
        };
        self.diagnostics.iter().zip(&self.lines).map(line).collect()
    }

    /// What the records say, without definitions and end.
    pub(crate) fn kinds(&self) -> Vec<&Kind> {
        let kinds = self.records.iter().map(|r| &r.kind);
        kinds.filter(|k| !matches!(k, Kind::Define { .. } | Kind::Fini)).collect()
    }

    /// The canonical elements of a name.
    pub(crate) fn form(&self, name: &str) -> Vec<f64> {
        let (base, subscript) = match name.split_once('(') {
            Some((base, rest)) => (base, rest.trim_end_matches(')').parse().expect("a subscript")),
            None => (name, 0),
        };
        let found = self.geometry.iter().find(|(n, _)| n.name == base && n.subscript == subscript);
        found.unwrap_or_else(|| panic!("no form {name}\n{}", self.messages())).1.elements()
    }
}

/// Runs `text`, which must give no messages.
pub(crate) fn clean(text: &str) -> Ran {
    let ran = run(text);
    assert!(ran.diagnostics.is_empty(), "{text}\n{}", ran.messages());
    ran
}

/// The scalars that GOTO gives out as x: `GOTO/A,0,0` prints A.
pub(crate) fn numbers(ran: &Ran) -> Vec<f64> {
    ran.records
        .iter()
        .filter_map(|r| match &r.kind {
            Kind::Goto(place) => Some(place.point.x),
            _ => None,
        })
        .collect()
}
