//! The proof of machine code of any origin against a CL file.

use std::collections::VecDeque;
use std::io::{self, BufRead, Read};

use aptc_cldata::{Dialect, Reader, Record, RecordReader as _, RecordWriter};
use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_edit::Subprograms;
use aptc_post::{Machine, Proof, prove};

use crate::cl_edit::spool;

/// Reads machine code as the control of `machine` does, moves its axes, and compares tool end and tool axis with
/// the CL data, DEFSUB and CALSUB carried out. Neither is held in memory as a whole.
///
/// # Errors
/// What reading gives.
pub fn verify_code(
    machine: &Machine,
    cl: Box<dyn Read>,
    dialect: Option<Dialect>,
    text: &mut dyn BufRead,
) -> io::Result<(Proof, Vec<Diagnostic>)> {
    let mut records = Records {
        reader: Reader::open(cl, dialect)?,
        subprograms: Subprograms::with_spool(spool()),
        ready: Ready::default(),
        ended: false,
        fault: None,
    };
    let (proof, found) = prove(machine, &mut records, text)?;
    if let Some(e) = records.fault {
        return Err(e);
    }
    let mut list: Vec<_> = records.reader.into_diagnostics();
    list.extend(records.subprograms.take_diagnostics());
    list.retain(Diagnostic::is_error);
    let unread = !list.is_empty();
    let mut found = found.into_iter();
    match found.next() {
        // Not one position is reached: the rest of the messages says the same again.
        Some(first) if proof.points == 0 && !unread => {
            let help = format!(
                "no position of the CL data is reached: it is of another part, or for another machine than {}",
                machine.name
            );
            list.push(first.help(help));
        }
        first => list.extend(first.into_iter().chain(found)),
    }
    if list.is_empty() && proof.points == 0 {
        let message = "the CL data have no position to compare";
        list.push(Diagnostic::error(codes::NOT_THE_CL, Span::default(), message));
    }
    Ok((proof, list))
}

/// The records of a file one by one.
struct Records {
    reader: Reader<Box<dyn Read>>,
    subprograms: Subprograms,
    ready: Ready,
    ended: bool,
    fault: Option<io::Error>,
}

#[derive(Default)]
struct Ready(VecDeque<Record>);

impl RecordWriter for Ready {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        self.0.push_back(record.clone());
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Records {
    fn fill(&mut self) -> io::Result<()> {
        let mut record = Record::default();
        while self.ready.0.is_empty() && !self.ended {
            if self.reader.read(&mut record)? {
                self.subprograms.push(&record, &mut self.ready)?;
            } else {
                self.ended = true;
                self.subprograms.finish(&mut self.ready)?;
            }
        }
        Ok(())
    }
}

impl Iterator for Records {
    type Item = Record;

    fn next(&mut self) -> Option<Record> {
        if let Err(e) = self.fill() {
            self.ended = true;
            self.fault = Some(e);
        }
        self.ready.0.pop_front()
    }
}
