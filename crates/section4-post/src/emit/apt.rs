//! CL data again, as text of ISO 4343.

use std::io::{self, Write};
use std::sync::{Arc, Mutex, PoisonError};

use aptc_cldata::{Record, RecordWriter, TextOptions, TextWriter};

/// Writes records and hands on what is ready.
pub(crate) struct AptText {
    writer: TextWriter<Ready>,
    ready: Ready,
}

/// Text that can be taken, while the writer goes on adding to it.
#[derive(Clone, Default)]
struct Ready(Arc<Mutex<Vec<u8>>>);

impl Write for Ready {
    fn write(&mut self, text: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(text);
        Ok(text.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl AptText {
    pub(crate) fn new() -> Self {
        let ready = Ready::default();
        let options = TextOptions { marks: false, ..TextOptions::default() };
        Self { writer: TextWriter::new(ready.clone(), options), ready }
    }

    pub(crate) fn write(&mut self, record: &Record, out: &mut Vec<u8>) {
        self.writer.write(record).expect("memory takes all");
        self.hand_on(out);
    }

    pub(crate) fn finish(&mut self, out: &mut Vec<u8>) {
        self.writer.finish().expect("memory takes all");
        self.hand_on(out);
    }

    fn hand_on(&self, out: &mut Vec<u8>) {
        out.append(&mut self.ready.0.lock().unwrap_or_else(PoisonError::into_inner));
    }
}
