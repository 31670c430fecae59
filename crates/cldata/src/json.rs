//! JSON lines: one record a line, as serde has it.

use std::io::{self, BufRead, BufReader, Read, Write};

use aptc_diagnostics::{Diagnostic, FileId, Span, codes};

use crate::{Record, RecordReader, RecordWriter};

/// Longest line that is read.
const LONGEST: u64 = 16 << 20;
/// Most messages about single lines.
const MOST: usize = 50;

/// Writes one JSON object a line.
pub struct JsonWriter<W> {
    out: W,
    buf: Vec<u8>,
}

impl<W: Write> JsonWriter<W> {
    /// A writer onto `out`, which need not be buffered.
    pub fn new(out: W) -> Self {
        Self { out, buf: Vec::new() }
    }
}

impl<W: Write> RecordWriter for JsonWriter<W> {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        serde_json::to_writer(&mut self.buf, record)?;
        self.buf.push(b'\n');
        if self.buf.len() > 64 * 1024 {
            self.out.write_all(&self.buf)?;
            self.buf.clear();
        }
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        self.out.write_all(&self.buf)?;
        self.buf.clear();
        self.out.flush()
    }
}

/// Reads JSON lines.
pub struct JsonReader<R> {
    input: BufReader<R>,
    buf: Vec<u8>,
    line: u64,
    offset: u64,
    file: FileId,
    list: Vec<Diagnostic>,
}

impl<R: Read> JsonReader<R> {
    /// A reader of `input`; `file` stands in the spans of its messages.
    pub fn new(input: R, file: FileId) -> Self {
        let (buf, list) = (Vec::new(), Vec::new());
        Self {
            input: BufReader::with_capacity(1 << 16, input),
            buf,
            line: 0,
            offset: 0,
            file,
            list,
        }
    }

    /// What the reader has to say, after the end.
    pub fn into_diagnostics(self) -> Vec<Diagnostic> {
        self.list
    }

    fn say(&mut self, what: &str) {
        if self.list.len() < MOST {
            let at = u32::try_from(self.offset).unwrap_or(u32::MAX);
            let message = format!("line {}: {what}", self.line);
            let span = Span::new(self.file, at, at);
            self.list.push(Diagnostic::error(codes::UNREADABLE_CL, span, message));
        }
    }

    /// Goes to the end of a line that is too long.
    fn skip(&mut self) -> io::Result<()> {
        loop {
            let (len, found) = {
                let held = self.input.fill_buf()?;
                match memchr::memchr(b'\n', held) {
                    Some(n) => (n + 1, true),
                    None => (held.len(), held.is_empty()),
                }
            };
            self.input.consume(len);
            self.offset += len as u64;
            if found {
                return Ok(());
            }
        }
    }
}

impl<R: Read> RecordReader for JsonReader<R> {
    fn read(&mut self, record: &mut Record) -> io::Result<bool> {
        loop {
            self.buf.clear();
            let n = (&mut self.input).take(LONGEST).read_until(b'\n', &mut self.buf)?;
            if n == 0 {
                return Ok(false);
            }
            self.line += 1;
            if n as u64 == LONGEST && self.buf.last() != Some(&b'\n') {
                self.say("a line longer than 16 MiB");
                self.offset += n as u64;
                self.skip()?;
                continue;
            }
            let parsed = match self.buf.trim_ascii() {
                b"" => None,
                text => Some(serde_json::from_slice::<Record>(text)),
            };
            match parsed {
                Some(Ok(read)) => {
                    *record = read;
                    self.offset += n as u64;
                    return Ok(true);
                }
                Some(Err(e)) => self.say(&e.to_string()),
                None => {}
            }
            self.offset += n as u64;
        }
    }
}
