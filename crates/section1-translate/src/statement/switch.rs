//! Words that stand alone or with ON or OFF.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_protap::{Clprnt, Dimension, DriveSide, Kind, PartSide};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::{Word, word};

use super::reader::Reader;
use crate::eval::{Known, Names};
use crate::{EntryKind, Interpreter};

impl Interpreter<'_> {
    /// A word that sets something by itself or with ON or OFF.
    pub(super) fn switch(&mut self, word: Word, clause: &Clause) -> Known<()> {
        let kind = match word {
            word::TLLFT => Kind::DriveSide(DriveSide::Tllft),
            word::TLRGT => Kind::DriveSide(DriveSide::Tlrgt),
            word::TLON => Kind::DriveSide(DriveSide::Tlon),
            word::TLNDON => Kind::DriveSide(DriveSide::Tlndon),
            word::TLONPS => Kind::PartSide(PartSide::Tlonps),
            word::TLOFPS => Kind::PartSide(PartSide::Tlofps),
            word::AUTOPS => Kind::Autops,
            word::NOPS => Kind::Nops,
            // NDTEST lets the processor choose again, as 2DCALC does.
            word::W2DCALC | word::NDTEST => Kind::Calc(Dimension::Two),
            word::W3DCALC => Kind::Calc(Dimension::Three),
            word::CUT => Kind::Cut(true),
            word::NOPOST => Kind::Nopost,
            word::NOPLOT => Kind::Noplot,
            word::DNTCUT => return self.dntcut(clause),
            word::MULTAX => return self.multax(clause),
            word::GOUGCK => {
                let on = self.on_off(word, clause)?.unwrap_or(true);
                self.emit(Kind::Gougck(on));
                self.always_checked(word);
                return Ok(());
            }
            word::CANON => {
                self.state.redefinition = self.on_off(word, clause)?.unwrap_or(true);
                return Ok(());
            }
            _ => return self.clprnt(clause),
        };
        self.bare(word, clause)?;
        self.emit(kind);
        if word == word::NDTEST {
            self.always_checked(word);
        }
        Ok(())
    }

    /// The listing says once of each of the two words what becomes of it.
    fn always_checked(&mut self, word: Word) {
        if !self.state.ignored_said.contains(&word) {
            self.state.ignored_said.push(word);
            let remark = format!("every cut vector is checked for gouges, with or without {word}");
            self.list(EntryKind::Remark(remark));
        }
    }

    /// ON, OFF, or neither.
    pub(super) fn on_off(&mut self, word: Word, clause: &Clause) -> Known<Option<bool>> {
        let args = self.args(clause, Names::Defined)?;
        let mut reader = Reader::new(word, clause, &args);
        if reader.is_empty() {
            return Ok(None);
        }
        let on = match reader.word_of(&[word::ON, word::OFF]) {
            Some(word) => word == word::ON,
            None => return Err(self.expect(&reader, "ON or OFF")),
        };
        self.at_end(&reader)?;
        Ok(Some(on))
    }

    /// DNTCUT, DNTCUT/PRINT: the points are not put out; PRINT would list them.
    fn dntcut(&mut self, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        let mut reader = Reader::new(word::DNTCUT, clause, &args);
        reader.is_word(word::PRINT);
        self.at_end(&reader)?;
        self.emit(Kind::Cut(false));
        Ok(())
    }

    /// MULTAX holds to the end of the program; MULTAX/ON up to MULTAX/OFF. That no OFF takes MULTAX back is
    /// told once: the mistake is that of MULTAX.
    fn multax(&mut self, clause: &Clause) -> Known<()> {
        let on = self.on_off(word::MULTAX, clause)?;
        self.state.multax_for_good |= on.is_none();
        if on == Some(false) && self.state.multax_for_good {
            if self.state.ignored_said.contains(&word::MULTAX) {
                return Ok(());
            }
            self.state.ignored_said.push(word::MULTAX);
            self.error(
                Diagnostic::warning(
                    codes::WITHOUT_EFFECT,
                    clause.span,
                    "MULTAX/OFF has no effect after MULTAX without ON",
                )
                .help("write MULTAX/ON where the axis vectors begin"),
            );
            return Ok(());
        }
        self.emit(Kind::Multax(on.unwrap_or(true)));
        Ok(())
    }

    /// CLPRNT[/ON|OFF|OPTION].
    fn clprnt(&mut self, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        let mut reader = Reader::new(word::CLPRNT, clause, &args);
        let what = match reader.word_of(&[word::ON, word::OFF, word::OPTION]) {
            Some(word::OFF) => Clprnt::Off,
            Some(word::ON) => Clprnt::On,
            Some(_) => Clprnt::Option,
            None if reader.is_empty() => Clprnt::Whole,
            None => return Err(self.expect(&reader, "ON, OFF or OPTION")),
        };
        self.at_end(&reader)?;
        self.emit(Kind::Clprnt(what));
        Ok(())
    }
}
