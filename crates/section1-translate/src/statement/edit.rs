//! INDEX, COPY, TRACUT: work for Section 3.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_geometry::{Form, Transform, Vec3};
use aptc_protap::{Edit, Kind};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::{Word, word};

use super::reader::Reader;
use crate::Interpreter;
use crate::eval::{Known, Names, Poisoned, whole};

impl Interpreter<'_> {
    /// `INDEX/n[,NOMORE]`, COPY/n,..., TRACUT/matrix or NOMORE.
    pub(super) fn edit(&mut self, word: Word, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        let mut reader = Reader::new(word, clause, &args);
        let edit = match word {
            word::TRACUT => self.tracut(&mut reader)?,
            word::INDEX => {
                let Some(n) = reader.number() else {
                    return Err(self.expect(&reader, "the number of a range"));
                };
                Edit::Index { n, close: reader.is_word(word::NOMORE) }
            }
            _ => self.copy(&mut reader)?,
        };
        self.at_end(&reader)?;
        self.emit(Kind::Edit(edit));
        Ok(())
    }

    fn tracut(&mut self, reader: &mut Reader<'_>) -> Known<Edit> {
        if reader.is_word(word::NOMORE) {
            return Ok(Edit::Tracut(None));
        }
        Ok(Edit::Tracut(Some(self.matrix(reader, "a matrix or NOMORE")?)))
    }

    fn matrix(&mut self, reader: &mut Reader<'_>, what: &str) -> Known<Transform> {
        let Some(Form::Matrix(m)) = reader.peek().and_then(|a| a.form()) else {
            return Err(self.expect(reader, what));
        };
        reader.skip(1);
        Ok(*m)
    }

    /// COPY/n,SAME,k | TRANSL,dx,dy,dz,k | XYROT,a,k | MODIFY,matrix,k
    fn copy(&mut self, reader: &mut Reader<'_>) -> Known<Edit> {
        let Some(n) = reader.number() else {
            return Err(self.expect(reader, "the number of an INDEX"));
        };
        let words =
            &[word::SAME, word::TRANSL, word::MODIFY, word::XYROT, word::YZROT, word::ZXROT];
        let step = match reader.word_of(words) {
            Some(word::SAME) => Transform::identity(),
            Some(word::TRANSL) => {
                let flat = reader.numbers_ahead() == 3;
                let shift = if flat {
                    let (x, y) = (reader.number(), reader.number());
                    Some(Vec3::new(x.unwrap_or_default(), y.unwrap_or_default(), 0.0))
                } else {
                    reader.vector().or_else(|| reader.triple())
                };
                match shift {
                    Some(v) => Transform::translation(v),
                    None => return Err(self.expect(reader, "dx,dy,dz")),
                }
            }
            Some(word::MODIFY) => self.matrix(reader, "a matrix")?,
            Some(turn) => {
                let Some(angle) = reader.number() else {
                    return Err(self.expect(reader, "an angle in degrees"));
                };
                let axis = match turn {
                    word::XYROT => Vec3::z(),
                    word::YZROT => Vec3::x(),
                    _ => Vec3::y(),
                };
                Transform::rotation(axis, angle)
            }
            None => {
                return Err(self.expect(reader, "SAME, TRANSL, XYROT, YZROT, ZXROT or MODIFY"));
            }
        };
        if reader.is_empty() {
            self.error(
                reader
                    .expected("the number of copies")
                    .help("COPY/n,... ends with how many copies are made"),
            );
            return Err(Poisoned);
        }
        let count = self.copies(reader)?;
        Ok(Edit::Copy { n, step, count })
    }

    /// How many copies: a whole number, which what was computed may miss in its last digits.
    fn copies(&mut self, reader: &mut Reader<'_>) -> Known<u32> {
        let number = reader.peek().and_then(|a| a.number());
        if let Some(n) = number.and_then(whole).filter(|n| (1.0..=1e9).contains(n)) {
            reader.skip(1);
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "between 1 and a milliard"
            )]
            return Ok(n as u32);
        }
        if let (Some(n), Some(arg)) = (number, reader.peek()) {
            self.error(Diagnostic::error(
                codes::BAD_ARGUMENTS,
                arg.span,
                format!("{n} copies cannot be made"),
            ));
            return Err(Poisoned);
        }
        Err(self.expect(reader, "the number of copies"))
    }
}
