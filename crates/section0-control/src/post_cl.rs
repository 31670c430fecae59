//! Section 4 from a CL file.

use std::io::Cursor;

use aptc_cldata::{Dialect, Kind, Reader, Record, RecordReader as _, detect};

use crate::{Compiled, MachineChoice, Part, Summary, post_part};

/// Posts every part program of a CL file, in whatever dialect it is written; binary too.
pub fn post_cl(
    name: &str,
    bytes: Vec<u8>,
    dialect: Option<Dialect>,
    machine: Option<&MachineChoice>,
) -> Compiled {
    let mut compiled = Compiled::default();
    let dialect = dialect.unwrap_or_else(|| detect(&bytes));
    let text = if dialect.is_text() {
        String::from_utf8_lossy(&bytes).into_owned()
    } else {
        String::new()
    };
    let file = compiled.sources.add(name, text);
    let mut reader =
        Reader::open_file(Cursor::new(bytes), Some(dialect), file).expect("memory can be read");
    let mut part = Part::default();
    let mut record = Record::default();
    while reader.read(&mut record).expect("memory can be read") {
        let fini = matches!(record.kind, Kind::Fini);
        part.edited.push(record.clone());
        if fini {
            compiled.parts.push(std::mem::take(&mut part));
        }
    }
    if !part.edited.is_empty() {
        compiled.parts.push(part);
    }
    compiled.diagnostics.extend(reader.into_diagnostics());
    for part in &mut compiled.parts {
        part.summary = Summary::of(&part.edited);
        let (nc, diagnostics) = post_part(&part.edited, machine);
        part.nc = nc;
        compiled.diagnostics.extend(diagnostics);
    }
    compiled
}
