//! Section 3 over a CL stream, in memory that does not grow with it.

use std::io;

use aptc_cldata::{Record, RecordReader, RecordWriter, Spill, Spool};
use aptc_diagnostics::Diagnostic;
use aptc_edit::{Editor, Subprograms};

/// A spool that goes to a temporary file when it grows.
pub(crate) fn spool() -> Spool {
    Spool::spilling(|| Ok(Box::new(tempfile::tempfile()?) as Box<dyn Spill>))
}

/// Passes the records on with subprograms, INDEX, COPY, TRACUT and VTLAXS carried out, and ends the file.
/// What there is to say.
///
/// # Errors
/// What reading and writing give.
pub fn edit_cl(
    reader: &mut dyn RecordReader,
    writer: &mut dyn RecordWriter,
) -> io::Result<Vec<Diagnostic>> {
    let mut subprograms = Subprograms::with_spool(spool());
    let mut editor = Editor::with_spool(spool());
    let mut record = Record::default();
    while reader.read(&mut record)? {
        subprograms.push(&record, &mut Edited { editor: &mut editor, out: &mut *writer })?;
    }
    subprograms.finish(&mut Edited { editor: &mut editor, out: &mut *writer })?;
    editor.finish(writer)?;
    writer.finish()?;
    let mut list = subprograms.take_diagnostics();
    list.extend(editor.take_diagnostics());
    Ok(list)
}

/// The editor with what it writes to.
pub(crate) struct Edited<'a> {
    pub(crate) editor: &'a mut Editor,
    pub(crate) out: &'a mut dyn RecordWriter,
}

impl RecordWriter for Edited<'_> {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        self.editor.push(record, self.out)
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}
