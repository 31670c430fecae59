//! One reader for all dialects.

use std::io::{self, Chain, Cursor, Read};

use aptc_diagnostics::{Diagnostic, FileId};

use super::encoding::Decoded;
use super::text_reader::TextReader;
use super::{detect, layout};
use crate::clfile::ClfileReader;
use crate::json::JsonReader;
use crate::tape::TapeReader;
use crate::{Dialect, Record, RecordReader};

/// The stream with the bytes that were looked at before it.
type Input<R> = Chain<Cursor<Vec<u8>>, Decoded<R>>;

/// Reads CL data of any dialect.
pub struct Reader<R> {
    dialect: Dialect,
    /// Does the head have marks?
    marked: bool,
    inner: Inner<R>,
}

enum Inner<R> {
    Text(Box<TextReader<Input<R>>>),
    Json(JsonReader<Input<R>>),
    Tape(Box<TapeReader<Input<R>>>),
    Clfile(ClfileReader<Input<R>>),
}

impl<R: Read> Reader<R> {
    /// A reader of `input`, which need not be buffered, in the dialect given or else detected.
    pub fn open(input: R, dialect: Option<Dialect>) -> io::Result<Self> {
        Self::open_file(input, dialect, FileId(0))
    }

    /// The same; `file` stands in the spans of records and messages.
    pub fn open_file(input: R, dialect: Option<Dialect>, file: FileId) -> io::Result<Self> {
        let mut input = Decoded::new(input);
        let mut head = Vec::new();
        input.by_ref().take(detect::HEAD as u64).read_to_end(&mut head)?;
        let dialect = dialect.unwrap_or_else(|| detect::dialect(&head));
        let unit = detect::unit(&head).of(dialect);
        let layout = layout::of(&head);
        let marked = detect::marked(&head);
        let input = Cursor::new(head).chain(input);
        let inner = match dialect {
            Dialect::Json => Inner::Json(JsonReader::new(input, file)),
            Dialect::Tape => Inner::Tape(Box::new(TapeReader::new(input, file))),
            Dialect::Clfile => Inner::Clfile(ClfileReader::new(input, file)),
            text => {
                let mut reader = TextReader::new(input, text, file);
                reader.state_unit(&unit);
                reader.lay_out(layout);
                Inner::Text(Box::new(reader))
            }
        };
        Ok(Self { dialect, marked, inner })
    }

    /// The dialect that is read.
    pub fn dialect(&self) -> Dialect {
        self.dialect
    }

    /// Does the file say with `$$ LINE` where its records come from? Looked for in its first 64 KiB.
    pub fn is_marked(&self) -> bool {
        match &self.inner {
            Inner::Text(r) => self.marked || r.is_marked(),
            Inner::Json(_) | Inner::Tape(_) | Inner::Clfile(_) => true,
        }
    }

    /// What the reader has to say, after the last record.
    pub fn into_diagnostics(self) -> Vec<Diagnostic> {
        match self.inner {
            Inner::Text(r) => r.into_diagnostics(),
            Inner::Json(r) => r.into_diagnostics(),
            Inner::Tape(r) => r.into_diagnostics(),
            Inner::Clfile(r) => r.into_diagnostics(),
        }
    }
}

impl<R: Read> RecordReader for Reader<R> {
    fn read(&mut self, record: &mut Record) -> io::Result<bool> {
        match &mut self.inner {
            Inner::Text(r) => r.read(record),
            Inner::Json(r) => r.read(record),
            Inner::Tape(r) => r.read(record),
            Inner::Clfile(r) => r.read(record),
        }
    }
}
