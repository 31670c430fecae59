//! Words with numbers: tolerances, thickness, steps, units.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_protap::{Kind, Units};
use aptc_syntax::tree::{Clause, Expr, ExprKind};
use aptc_vocabulary::{Word, word};

use super::reader::Reader;
use crate::Interpreter;
use crate::eval::{Arg, Known, Names, Poisoned};
use crate::memory::{Place, Value};

impl Interpreter<'_> {
    /// A word with one to four numbers, or UNITS.
    pub(super) fn setting(&mut self, word: Word, clause: &Clause) -> Known<()> {
        if word == word::UNITS
            && let Some(Expr { kind: ExprKind::Name(name), span }) =
                clause.args.as_deref().and_then(<[_]>::first)
            && self.synonyms.word(name).is_none()
        {
            let text = self.interner.text(name.symbol);
            let what = format!("{text} is no unit of length");
            let message = Diagnostic::error(codes::BAD_ARGUMENTS, *span, what);
            self.error(message.help("write UNITS/MM, CM, INCHES or FEET"));
            return Err(Poisoned);
        }
        let args = self.args(clause, Names::Defined)?;
        let mut reader = Reader::new(word, clause, &args);
        match word {
            word::UNITS => return self.units(&mut reader, clause),
            word::MAXDP => {
                let alone = reader.left() == 1;
                if alone && reader.peek().and_then(Arg::number).is_some_and(|n| n <= 0.0) {
                    return Err(self.expect(&reader, "a greatest step above 0"));
                }
                let step = self.one(&mut reader, "the greatest step")?;
                // With a length behind it a number below 0 is a switch of APT4's tests.
                let length = reader.number();
                self.at_end(&reader)?;
                self.emit(Kind::Maxdp { step, length });
                return Ok(());
            }
            word::NUMPTS => {
                let n = self.count(&mut reader)?;
                self.at_end(&reader)?;
                self.emit(Kind::Numpts(n));
                return Ok(());
            }
            _ => {}
        }
        let values = self.four(word, &mut reader)?;
        match word {
            word::THICK => self.emit(Kind::Thick(values)),
            word::INTOL => self.emit(Kind::Intol(values)),
            word::OUTTOL => self.emit(Kind::Outtol(values)),
            // TOLER allows stock on the surface and none below it.
            _ => {
                self.emit(Kind::Intol([0.0; 4]));
                self.emit(Kind::Outtol(values));
            }
        }
        Ok(())
    }

    /// One to four numbers for part, drive, check and second check surface; the last holds for the rest.
    fn four(&mut self, word: Word, reader: &mut Reader<'_>) -> Known<[f64; 4]> {
        let mut values = [self.one(reader, "a number")?; 4];
        self.not_negative(word, reader, values[0])?;
        for i in 1..4 {
            let Some(n) = reader.number() else { break };
            self.not_negative(word, reader, n)?;
            values[i..].fill(n);
        }
        self.at_end(reader)?;
        Ok(values)
    }

    fn not_negative(&mut self, word: Word, reader: &Reader<'_>, n: f64) -> Known<()> {
        if n >= 0.0 || word == word::THICK {
            return Ok(());
        }
        self.error(
            Diagnostic::error(
                codes::BAD_TOLERANCE,
                reader.before(),
                format!("a tolerance of {n} is negative"),
            )
            .help("INTOL is how deep, OUTTOL how far off the cut may be; both are lengths"),
        );
        Err(Poisoned)
    }

    fn one(&mut self, reader: &mut Reader<'_>, what: &str) -> Known<f64> {
        match reader.number() {
            Some(n) => Ok(n),
            None => Err(self.expect(reader, what)),
        }
    }

    /// A whole number from 1.
    pub(super) fn count(&mut self, reader: &mut Reader<'_>) -> Known<u32> {
        let whole = reader.peek().and_then(|a| a.number());
        let whole = whole.filter(|n| *n >= 1.0 && *n <= f64::from(u32::MAX) && n.fract() == 0.0);
        let Some(n) = whole else {
            return Err(self.expect(reader, "a whole number from 1"));
        };
        reader.skip(1);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number in the range of the type"
        )]
        Ok(n as u32)
    }

    /// UNITS/MM|CM|INCHES|FEET.
    ///
    /// It says what numbers mean from here on; geometry that was defined before keeps its numbers.
    fn units(&mut self, reader: &mut Reader<'_>, clause: &Clause) -> Known<()> {
        let unit = match reader.word_of(&[word::MM, word::CM, word::INCHES, word::FEET]) {
            Some(word::MM) => Units::Mm,
            Some(word::CM) => Units::Cm,
            Some(word::INCHES) => Units::Inches,
            Some(_) => Units::Feet,
            None => return Err(self.expect(reader, "MM, CM, INCHES or FEET")),
        };
        self.at_end(reader)?;
        let former = self.state.unit;
        let forms = |(_, value): (Place, &Value)| matches!(value, Value::Form(_));
        if unit != former && self.memory.in_order().any(forms) {
            let message = format!(
                "UNITS changes from {} to {} after geometry was defined; its numbers stay as they are",
                former.word(),
                unit.word()
            );
            let help =
                "write UNITS before the first definition, or scale what was defined by a MATRIX";
            self.error(Diagnostic::warning(codes::UNITS_CHANGED, clause.span, message).help(help));
        }
        self.state.unit = unit;
        self.emit(Kind::Units(unit));
        Ok(())
    }
}
