//! Section 4 from a CL file.

use std::sync::Arc;

use aptc_cldata::{Kind, Reader, Record, RecordReader as _};

use crate::{Compiled, MachineChoice, Part, Source, Summary, post_part};

/// Posts every part program of a CL file.
pub fn post_cl(source: Source, machine: Option<&MachineChoice>) -> Compiled {
    let mut compiled = Compiled::default();
    let file = compiled.sources.add(source.name, Arc::clone(&source.text));
    let mut reader =
        Reader::open_file(source.text.as_bytes(), None, file).expect("memory can be read");
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
