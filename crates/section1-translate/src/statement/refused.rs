//! Words of the vocabulary that begin a statement and are not carried out: one table, with reasons.

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::{Word, word};

use crate::Interpreter;
use crate::eval::{Known, Poisoned};

/// What happens to such a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fate {
    /// It says nothing about the part: a note.
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
    (
        word::PTONLY,
        Ignored,
        "it took points, or the CL data of an earlier run, in place of computed motion; all motion is computed",
    ),
    (word::CMIT, Ignored, "it steered an input device of the old system"),
    (word::MIT, Ignored, "it steered an input device of the old system"),
    (word::DAC, Ignored, "it steered a display of the old system"),
    (word::REAL, Ignored, "all numbers are real"),
    (word::SUBSCR, Ignored, "arrays are reserved by RESERV"),
    (word::APTRAN, Refused, "it begins statements of another language"),
    (word::APTREN, Refused, "it ends statements of another language"),
    (word::ERROR, Refused, "it calls an error routine of the old system"),
    (word::TANCRV, Refused, "its processor was never published"),
    (word::BEVELS, Refused, "its processor was never published"),
    (word::DMILL, Refused, "its processor was never published"),
    (
        word::PARSRF,
        Refused,
        "APT4 (SSV3) has one format of it, a parametric surface as data; what the numbers mean was never published",
    ),
    (word::HEX, Refused, "saved forms are read as statements by READ/1, not in hexadecimal"),
    (word::LOFT, Refused, "its processor was never published"),
    (word::MESH, Refused, "its processor was never published"),
    (word::CONSEC, Refused, "its processor was never published"),
    (word::ELMSRF, Refused, "its processor was never published"),
    (word::TOOL, Refused, "its processor was never published"),
];

/// What becomes of a word of the table, and why.
pub(crate) fn fate(word: Word) -> Option<(&'static str, &'static str)> {
    let (_, fate, reason) = TABLE.iter().find(|(w, ..)| *w == word)?;
    Some((if *fate == Ignored { "Ignored" } else { "Refused" }, reason))
}

/// Why a word that defines geometry in some system does not do so here.
pub(crate) fn no_geometry(word: Word) -> Option<&'static str> {
    TABLE.iter().find(|(w, ..)| *w == word).map(|(.., reason)| *reason)
}

impl Interpreter<'_> {
    /// Says once that a definition by BOUNDS or OBJECT is of no use: it is read, and no statement takes it.
    pub(crate) fn used_by_none(&mut self, head: Word, span: Span) {
        let of_no_use = [word::BOUNDS, word::OBJECT].contains(&head);
        if !of_no_use || self.state.ignored_said.contains(&head) {
            return;
        }
        self.state.ignored_said.push(head);
        let message =
            format!("{head} has no effect: nothing but BOUNDS and OBJECT takes what it defines");
        self.error(
            Diagnostic::warning(codes::WITHOUT_EFFECT, span, message)
                .note("the grammar of APT4 (SSV3) has BOUNDS and OBJECT, and no statement that uses them")
                .help("name surfaces that the tool must keep clear of in CHKSRF, and take the definition away"),
        );
    }

    /// Says why a word of the table is not carried out; `None` for other words.
    pub(super) fn refused(&mut self, word: Word, clause: &Clause) -> Option<Known<()>> {
        let (_, fate, reason) = TABLE.iter().find(|(w, ..)| *w == word)?;
        Some(match fate {
            Ignored => {
                // Old programs have some of them on every page: each word is told of once.
                if self.state.ignored_said.contains(&word) {
                    return Some(Ok(()));
                }
                self.state.ignored_said.push(word);
                let message = format!("{word} has no effect here: {reason}");
                self.error(Diagnostic::note_at(codes::WITHOUT_EFFECT, clause.head.span, message));
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

#[cfg(test)]
mod tests {
    use aptc_vocabulary::{Class, Dialect, all};

    use super::*;
    use crate::{NoFiles, Options, Step, define};

    /// Codes of the messages about a program.
    fn told(text: &str) -> Vec<aptc_diagnostics::Code> {
        let mut files = NoFiles;
        let mut program = Interpreter::new("test", text, &mut files, Options::default());
        while program.step() != Step::End {}
        program.take_diagnostics().into_iter().map(|d| d.code).collect()
    }

    /// Every word that heads statements in APT-360 or APT4 is carried out, or stands in the table.
    #[test]
    fn no_word_of_the_vocabulary_is_forgotten() {
        let mut forgotten = Vec::new();
        for word in all() {
            if !word.is_major(Dialect::Apt360) && !word.is_major(Dialect::Apt4) {
                continue;
            }
            let stands = TABLE.iter().any(|(w, ..)| *w == word);
            let statement = match word.class() {
                Class::Operator => continue,
                Class::Geometry => {
                    if define::is_definition(word) == stands {
                        forgotten.push(word);
                    }
                    format!("X={word}/0\n")
                }
                Class::Function => format!("X={word}(1)\n"),
                Class::Text => format!("{word} A TEXT\n"),
                _ => match word {
                    word::IF => "IF(1)1,1,1\n1) STOP\n".to_owned(),
                    word::DO => "DO/1,I=1,1\n1) STOP\n".to_owned(),
                    word::MACRO | word::TERMAC => "M=MACRO/\nTERMAC\n".to_owned(),
                    word::CALL => "CALL/M\n".to_owned(),
                    word::FINI => String::new(),
                    _ => format!("{word}/1\n"),
                },
            };
            let codes = told(&format!("{statement}FINI\n"));
            let refused = codes.contains(&codes::REFUSED_WORD);
            let lost = codes.contains(&codes::NO_STATEMENT)
                || codes.contains(&codes::OTHER_DIALECT)
                || codes.contains(&codes::UNKNOWN_POST_WORD)
                || codes.contains(&codes::NO_GEOMETRY)
                || codes.contains(&codes::EXPECTED_OTHERWISE);
            if lost || refused && !stands {
                forgotten.push(word);
            }
        }
        assert!(forgotten.is_empty(), "{forgotten:?}");
    }

    #[test]
    fn a_word_stands_in_the_table_once_and_with_a_reason() {
        for (i, (word, _, reason)) in TABLE.iter().enumerate() {
            assert!(!reason.is_empty());
            assert!(TABLE[..i].iter().all(|(w, ..)| w != word), "{word}");
        }
    }

    #[test]
    fn ignored_words_are_noted_and_refused_ones_are_errors() {
        let none = codes::WITHOUT_EFFECT;
        assert_eq!(told("TUNEUP/1000,2000,3000\nDEBUG/ON\nDEBUG/OFF\nFINI\n"), [none, none]);
        assert_eq!(told("BEVELS/1\nFINI\n"), [codes::REFUSED_WORD]);
        assert_eq!(told("S=MESH/1,2\nFINI\n"), [codes::REFUSED_WORD]);
        assert_eq!(told("S=PARSRF/1,2\nFINI\n"), [codes::REFUSED_WORD]);
        let spaces = "B=BOUNDS/(SPHERE/0,0,0,9),IN\nC=BOUNDS/(PLANE/0,0,1,4),POSZ\nO=OBJECT/B,C\n";
        assert_eq!(told(&format!("{spaces}FINI\n")), [none, none]);
    }
}
