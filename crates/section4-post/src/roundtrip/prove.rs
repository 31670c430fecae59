//! The proof of machine code of any origin.

use std::io::{self, BufRead, Read as _};

use aptc_cldata::{Kind, Record, Units};
use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::Plane;

use super::{Checker, MOST_FAULTS, Proof};
use crate::args::Statement;
use crate::machine::Machine;
use crate::readback::Fault;

/// Positions of the CL data that are looked at ahead of the text: more than an arc has cut vectors.
const AHEAD: usize = 100_000;

/// Longest line that is read.
const LONGEST: u64 = 64 * 1024;

/// Reads machine code of any origin for a machine and compares it with CL data. Of both no more is held than a
/// line and the positions of some arcs. The messages have no place in the source; they name lines of `text`.
///
/// # Errors
/// What reading `text` gives.
pub fn prove(
    machine: &Machine,
    records: &mut dyn Iterator<Item = Record>,
    text: &mut dyn BufRead,
) -> io::Result<(Proof, Vec<Diagnostic>)> {
    let machine = std::sync::Arc::new(machine.clone());
    let mut checker = Checker::new(&machine);
    let mut asked = Asked { records, machine: &machine, clearance: None, units: Units::default() };
    asked.measure(&mut checker);
    let mut line = Vec::new();
    let mut more = true;
    loop {
        line.clear();
        if (&mut *text).take(LONGEST).read_until(b'\n', &mut line)? == 0 {
            break;
        }
        while more && checker.queue.len() < AHEAD {
            more = asked.next(&mut checker);
        }
        checker.text(line.trim_ascii_end());
        if checker.faults.len() >= MOST_FAULTS {
            break;
        }
    }
    if checker.faults.len() < MOST_FAULTS {
        while asked.next(&mut checker) {
            if checker.queue.len() >= AHEAD {
                break;
            }
        }
        checker.settle();
    }
    let say = |f: Fault| {
        let message = format!("line {} of the machine code: {}", f.line, f.message);
        Diagnostic::error(codes::NOT_THE_CL, Span::default(), message)
    };
    Ok((checker.proof, checker.faults.into_iter().map(say).collect()))
}

/// The CL data that is still to come.
struct Asked<'a> {
    records: &'a mut dyn Iterator<Item = Record>,
    machine: &'a std::sync::Arc<Machine>,
    clearance: Option<Plane>,
    units: Units,
}

impl Asked<'_> {
    /// Takes the next record; false at the end.
    fn next(&mut self, checker: &mut Checker) -> bool {
        let Some(record) = self.records.next() else { return false };
        if let Kind::Units(u) = record.kind {
            self.units = u;
            self.measure(checker);
        }
        if let Kind::Post { word, args } = &record.kind
            && matches!(word.as_str(), "CLRSRF" | "CLEARP")
        {
            let s = Statement { word, args, origin: &record.origin };
            let plane = crate::words::planes::plane(&s, self.units.mm());
            self.clearance = plane.or(self.clearance);
        }
        checker.record(&record, self.clearance);
        true
    }

    /// The steps of the output are the measure.
    fn measure(&self, checker: &mut Checker) {
        let inch = crate::post::inch(self.machine, self.units);
        let blocks = crate::emit::Blocks::new(std::sync::Arc::clone(self.machine), inch);
        checker.set_resolution_of(&blocks, if inch { 25.4 } else { 1.0 });
    }
}
