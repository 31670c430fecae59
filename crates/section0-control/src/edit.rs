//! Section 3 over the records of a part program.

use std::io;

use aptc_cldata::{Record, RecordWriter};
use aptc_diagnostics::Diagnostic;
use aptc_edit::Editor;

/// The records with COPY and TRACUT carried out, unless the motion had errors.
pub(crate) fn edit(records: &[Record], whole: bool) -> (Vec<Record>, Vec<Diagnostic>) {
    let mut editor = Editor::new();
    if !whole {
        editor.motion_failed();
    }
    let mut edited = Kept(Vec::with_capacity(records.len()));
    for record in records {
        editor.push(record, &mut edited).expect("memory takes all");
    }
    editor.finish(&mut edited).expect("memory takes all");
    (edited.0, editor.take_diagnostics())
}

/// Keeps the records.
struct Kept(Vec<Record>);

impl RecordWriter for Kept {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        self.0.push(record.clone());
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}
