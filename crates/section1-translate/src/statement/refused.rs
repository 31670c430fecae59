//! Words of the vocabulary that begin a statement and are not carried out: one table, with reasons.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::{Word, word};

use crate::Interpreter;
use crate::eval::{Known, Poisoned};
use crate::listing::EntryKind;

/// What happens to such a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fate {
    /// It says nothing about the part: the listing notes it.
    Ignored,
    /// Leaving it out would change the part: an error.
    Refused,
}

use Fate::{Ignored, Refused};

/// The table.
const TABLE: &[(Word, Fate, &str)] = &[
    (word::TUNEUP, Ignored, "it sized the tables of a computer's memory"),
    (word::DEBUG, Ignored, "it printed the old processor's intermediate results"),
    (word::DYNDMP, Ignored, "it printed the old processor's memory"),
    (word::EJECT, Ignored, "it began a page of the old listing"),
    (word::CONTRL, Ignored, "it steered the input of cards"),
    (word::PPOPTN, Ignored, "it chose what the old post-processor printed"),
    (word::CFSAVE, Ignored, "it kept canonical forms on a file of the old system"),
    (word::DDLIM, Ignored, "surfaces are searched without such a limit"),
    (word::CLTV, Ignored, "it chose another arithmetic element of the installation"),
    (word::LTV, Ignored, "it chose another arithmetic element of the installation"),
    (word::CMIT, Ignored, "it steered an input device of the old system"),
    (word::MIT, Ignored, "it steered an input device of the old system"),
    (word::DAC, Ignored, "it steered a display of the old system"),
    (word::PLOTFT, Ignored, "it drew a surface on a plotter"),
    (word::REAL, Ignored, "all numbers are real"),
    (word::SUBSCR, Ignored, "arrays are reserved by RESERV"),
    (word::APTRAN, Refused, "it begins statements of another language"),
    (word::APTREN, Refused, "it ends statements of another language"),
    (word::ERROR, Refused, "it calls an error routine of the old system"),
    (word::TANCRV, Refused, "its processor was never published"),
    (word::BEVELS, Refused, "its processor was never published"),
    (word::DMILL, Refused, "its processor was never published"),
    (word::VTLAXS, Refused, "the axis is tilted by TLAXIS instead"),
    (word::WCORN, Refused, "the axis is tilted by TLAXIS instead"),
    (word::INTSEC, Refused, "intersection curves of surfaces are not computed"),
    (word::TLPROJ, Refused, "paths are not projected"),
];

impl Interpreter<'_> {
    /// Says why a word of the table is not carried out; `None` for other words.
    pub(super) fn refused(&mut self, word: Word, clause: &Clause) -> Option<Known<()>> {
        let (_, fate, reason) = TABLE.iter().find(|(w, ..)| *w == word)?;
        Some(match fate {
            Ignored => {
                self.list(EntryKind::Remark(format!("{word} has no effect: {reason}")));
                Ok(())
            }
            Refused => {
                self.error(
                    Diagnostic::error(
                        codes::REFUSED_WORD,
                        clause.head.span,
                        format!("{word} is not carried out"),
                    )
                    .note((*reason).to_owned())
                    .help("take it away, or write what it does in other statements"),
                );
                Err(Poisoned)
            }
        })
    }
}
