//! Binary records in the layout of ISO 3592, as CATIA writes its clfiles.
//!
//! Each record is set off as FORTRAN sets it: its length in bytes before and after. It holds three 32-bit
//! integers (number, type, subtype) and words of eight bytes as on an APT-360 [tape](crate::tape). Read in
//! either byte order, written with the least significant byte first. A circle is a 3000 record before its
//! chords, or, where only the end is known, a 15000 record: 0, 4, 9, name, subscript, centre, axis, radius,
//! start, end, angle in degrees.

use std::io::{self, Read, Write};

use aptc_diagnostics::{Diagnostic, FileId};
use aptc_vocabulary as vocabulary;

use crate::tape::{Framing, TapeReader, TapeWriter};
use crate::{Record, RecordReader, RecordWriter};

/// Do the bytes begin like a FORTRAN record with the integers of CL data?
pub(crate) fn looks_like(head: &[u8]) -> bool {
    order(head).is_some()
}

/// Is the most significant byte first?
fn order(head: &[u8]) -> Option<bool> {
    let head: &[u8; 16] = head.first_chunk()?;
    let int = |i: usize, big: bool| {
        let bytes = [head[i], head[i + 1], head[i + 2], head[i + 3]];
        if big { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) }
    };
    [false, true].into_iter().find(|big| {
        let (length, number, kind) = (int(0, *big), int(4, *big), int(8, *big));
        (12..=1 << 16).contains(&length)
            && length % 8 == 4
            && number <= 1
            && kind % 1000 == 0
            && (1000..=29000).contains(&kind)
    })
}

/// Reads clfiles.
pub struct ClfileReader<R>(State<R>);

enum State<R> {
    /// The byte order is not known yet.
    New(Option<R>, FileId),
    Open(Box<TapeReader<io::Chain<io::Cursor<Vec<u8>>, R>>>),
}

impl<R: Read> ClfileReader<R> {
    /// A reader of `input`; `file` stands in the spans of its messages.
    pub fn new(input: R, file: FileId) -> Self {
        Self(State::New(Some(input), file))
    }

    /// What the reader has to say, after the end.
    pub fn into_diagnostics(self) -> Vec<Diagnostic> {
        match self.0 {
            State::New(..) => Vec::new(),
            State::Open(r) => r.into_diagnostics(),
        }
    }
}

impl<R: Read> RecordReader for ClfileReader<R> {
    fn read(&mut self, record: &mut Record) -> io::Result<bool> {
        if let State::New(input, file) = &mut self.0
            && let Some(mut input) = input.take()
        {
            let file = *file;
            let mut head = Vec::new();
            input.by_ref().take(16).read_to_end(&mut head)?;
            let framing = Framing::Fortran { big: order(&head).unwrap_or(false) };
            let input = io::Cursor::new(head).chain(input);
            let dialect = vocabulary::Dialect::IbmCl;
            self.0 = State::Open(Box::new(TapeReader::framed(input, file, framing, dialect)));
        }
        match &mut self.0 {
            State::New(..) => Ok(false),
            State::Open(r) => r.read(record),
        }
    }
}

/// Writes clfiles.
pub struct ClfileWriter<W>(TapeWriter<W>);

impl<W: Write> ClfileWriter<W> {
    /// A writer onto `out`, which need not be buffered.
    pub fn new(out: W) -> Self {
        let framing = Framing::Fortran { big: false };
        Self(TapeWriter::framed(out, framing, vocabulary::Dialect::IbmCl))
    }

    /// Ends the file and gives back what was written onto.
    pub fn into_inner(self) -> io::Result<W> {
        self.0.into_inner()
    }
}

impl<W: Write> RecordWriter for ClfileWriter<W> {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        self.0.write(record)
    }

    fn finish(&mut self) -> io::Result<()> {
        self.0.finish()
    }
}
