//! Section 3 over the records of a part program.

use std::io;

use aptc_cldata::{Record, RecordWriter};
use aptc_diagnostics::Diagnostic;
use aptc_edit::Editor;

use crate::cl_edit::spool;
use crate::post::PartHead;
use crate::{Records, Summary};

/// What Section 3 hands on.
#[derive(Default)]
pub(crate) struct Edited {
    /// The records with COPY and TRACUT carried out.
    pub(crate) records: Records,
    /// What the post-processors must know before the first.
    pub(crate) head: PartHead,
    /// Figures.
    pub(crate) summary: Summary,
}

/// Edits the records, unless the motion had errors.
pub(crate) fn edit(records: &Records, whole: bool) -> io::Result<(Edited, Vec<Diagnostic>)> {
    let mut editor = Editor::with_spool(spool());
    if !whole {
        editor.motion_failed();
    }
    let mut edited = Edited::default();
    records.try_for_each(|record| editor.push(record, &mut edited))?;
    editor.finish(&mut edited)?;
    Ok((edited, editor.take_diagnostics()))
}

impl RecordWriter for Edited {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        self.head.push(record);
        self.summary.push(record);
        self.records.write(record)
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}
