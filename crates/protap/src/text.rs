//! The text form: JSON, one record a line.
//!
//! The first line is the header `{"protap":1}`; each further line is a [`Record`] as serde has it. Numbers
//! are written in full and read back bit by bit. Empty lines are allowed. A reader of version 1 refuses
//! other versions.

use std::io::{self, Write};

use aptc_diagnostics::{Diagnostic, FileId, Span, codes};
use serde::{Deserialize, Serialize};

use crate::Record;

/// The version that is written and read.
const VERSION: u32 = 1;
/// Characters of a line that a message shows.
const SHOWN: usize = 40;

/// The first line.
#[derive(Serialize, Deserialize)]
struct Header {
    protap: u32,
}

/// Writes records as they come.
#[derive(Debug)]
pub struct Writer<W> {
    out: W,
}

impl<W: Write> Writer<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// When `out` takes no more.
    pub fn new(mut out: W) -> io::Result<Self> {
        serde_json::to_writer(&mut out, &Header { protap: VERSION })?;
        out.write_all(b"\n")?;
        Ok(Self { out })
    }

    /// Writes a record.
    ///
    /// # Errors
    /// When `out` takes no more.
    pub fn record(&mut self, record: &Record) -> io::Result<()> {
        serde_json::to_writer(&mut self.out, record)?;
        self.out.write_all(b"\n")
    }

    /// Gives back what was written to.
    ///
    /// # Errors
    /// When the rest cannot be written.
    pub fn finish(mut self) -> io::Result<W> {
        self.out.flush()?;
        Ok(self.out)
    }
}

/// All records as text.
pub fn write<'r>(records: impl IntoIterator<Item = &'r Record>) -> String {
    let mut writer = Writer::new(Vec::new()).expect("memory takes all");
    for record in records {
        writer.record(record).expect("memory takes all");
    }
    String::from_utf8(writer.out).expect("JSON is UTF-8")
}

/// The records of `text`, which is the file `file`; lines that cannot be read are left out and told.
pub fn read(file: FileId, text: &str) -> (Vec<Record>, Vec<Diagnostic>) {
    let (records, messages) = read_lines(file, text);
    (records.into_iter().map(|(record, _)| record).collect(), messages)
}

/// As [`read`], but each record says that it comes from its own line here: the part program that its span speaks
/// of is not at hand, and a message about the record should show something.
pub fn read_in_place(file: FileId, text: &str) -> (Vec<Record>, Vec<Diagnostic>) {
    let (records, messages) = read_lines(file, text);
    let placed = records.into_iter().map(|(mut record, span)| {
        record.origin.span = span;
        record
    });
    (placed.collect(), messages)
}

fn read_lines(file: FileId, text: &str) -> (Vec<(Record, Span)>, Vec<Diagnostic>) {
    let mut records = Vec::new();
    let mut messages = Vec::new();
    let mut start = 0;
    let mut header = false;
    for (n, line) in (1u32..).zip(text.split_inclusive('\n')) {
        let span = Span::new(file, offset(start), offset(start + line.trim_end().len()));
        start += line.len();
        let line = line.trim();
        if line.is_empty() {
            continue;
        }
        if !header {
            header = true;
            match serde_json::from_str::<Header>(line) {
                Ok(Header { protap: VERSION }) => continue,
                Ok(Header { protap }) => {
                    messages.push(
                        Diagnostic::error(
                            codes::NO_PROTAP,
                            span,
                            format!("version {protap} of PROTAP is not known"),
                        )
                        .help(format!("this program reads version {VERSION}")),
                    );
                    return (records, messages);
                }
                Err(_) => {
                    messages.push(
                        Diagnostic::error(
                            codes::NO_PROTAP,
                            span,
                            format!("line {n} is no header of a PROTAP file"),
                        )
                        .help(format!("the first line is {{\"protap\":{VERSION}}}")),
                    );
                    return (records, messages);
                }
            }
        }
        match serde_json::from_str::<Record>(line) {
            Ok(record) => records.push((record, span)),
            Err(why) => {
                let shown: String = line.chars().take(SHOWN).collect();
                messages.push(
                    Diagnostic::error(
                        codes::BAD_PROTAP_LINE,
                        span,
                        format!("line {n} is no PROTAP record: {why}"),
                    )
                    .label(format!("`{shown}`")),
                );
            }
        }
    }
    if !header {
        let end = offset(text.len());
        messages.push(
            Diagnostic::error(
                codes::NO_PROTAP,
                Span::new(file, 0, end),
                "the file is empty and no PROTAP file",
            )
            .help(format!("the first line is {{\"protap\":{VERSION}}}")),
        );
    }
    (records, messages)
}

fn offset(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}
