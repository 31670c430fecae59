//! The proof of machine code of any origin.

use aptc_cldata::{Kind, Record, Units};
use aptc_diagnostics::{Diagnostic, Span, codes};

use super::{Checker, MOST_FAULTS, Proof};
use crate::args::Statement;
use crate::machine::Machine;
use crate::readback::Fault;

/// Positions of the CL data that are looked at ahead of the text: more than an arc has cut vectors.
const AHEAD: usize = 100_000;

/// Reads machine code of any origin for a machine and compares it with CL data.
///
/// `inch` is the unit of the output. The messages have no place in the source; they name lines of `text`.
pub fn prove(
    machine: &Machine,
    inch: bool,
    records: &mut dyn Iterator<Item = Record>,
    text: &str,
) -> (Proof, Vec<Diagnostic>) {
    let machine = std::sync::Arc::new(machine.clone());
    let mut checker = Checker::new(&machine);
    let blocks = crate::emit::Blocks::new(std::sync::Arc::clone(&machine), inch);
    checker.set_resolution_of(&blocks, if inch { 25.4 } else { 1.0 });
    let mut clearance = None;
    let mut units = Units::default();
    let mut more = true;
    for line in text.lines() {
        while more && checker.queue.len() < AHEAD {
            match records.next() {
                Some(record) => {
                    if let Kind::Units(u) = record.kind {
                        units = u;
                    }
                    if let Kind::Post { word, args } = &record.kind
                        && matches!(word.as_str(), "CLRSRF" | "CLEARP")
                    {
                        let s = Statement { word, args, origin: &record.origin };
                        clearance = crate::words::planes::plane(&s, units.mm()).or(clearance);
                    }
                    checker.record(&record, clearance);
                }
                None => more = false,
            }
        }
        checker.text(line.as_bytes());
        if checker.faults.len() >= MOST_FAULTS {
            break;
        }
    }
    if checker.faults.len() < MOST_FAULTS {
        for record in records {
            checker.record(&record, clearance);
        }
        checker.settle();
    }
    let say = |f: Fault| {
        let message = format!("line {} of the machine code: {}", f.line, f.message);
        Diagnostic::error(codes::NOT_THE_CL, Span::default(), message)
    };
    (checker.proof, checker.faults.into_iter().map(say).collect())
}
