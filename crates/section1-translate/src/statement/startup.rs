//! GO, OFFSET, INDIRV, INDIRP, SRFVCT: getting the tool to its surfaces.
//!
//! APT: `STRTUP` takes them up in Section 2.

use std::sync::Arc;

use aptc_geometry::{Form, Vec3};
use aptc_protap::{Go, Kind, Relation, Sense};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::{Word, word};

use super::drive::relation;
use super::reader::Reader;
use crate::Interpreter;
use crate::eval::{ArgKind, Known, Names};
use crate::program::Unit;

impl Interpreter<'_> {
    /// `GO/[rel,]DS[,[rel,]PS[,[rel,]CS]][,feed]`, and OFFSET.
    pub(super) fn go(&mut self, word: Word, clause: &Clause, _: &Arc<Unit>) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        let mut reader = Reader::new(word, clause, &args);
        let mut surfaces = Vec::with_capacity(3);
        while surfaces.len() < 3 && !reader.is_empty() {
            if !surfaces.is_empty() && reader.left() == 1 && reader.numbers_ahead() == 1 {
                break;
            }
            // Only the check surface, the third, may be met at a tangent.
            let words: &[Word] = if surfaces.len() == 2 {
                &[word::TO, word::ON, word::PAST, word::TANTO, word::DSTAN, word::PSTAN]
            } else {
                &[word::TO, word::ON, word::PAST]
            };
            let rel = reader.word_of(words).map_or(Relation::To, relation);
            let surface = self.surface(&mut reader, "a surface")?;
            surfaces.push((rel, surface));
        }
        if surfaces.is_empty() {
            return Err(self.expect(&reader, "a surface"));
        }
        self.feed(&mut reader)?;
        self.emit(Kind::Go(Go { offset: word == word::OFFSET, surfaces }));
        Ok(())
    }

    /// INDIRV, INDIRP and SRFVCT: up to three directions or points, with empty fields.
    pub(super) fn sense(&mut self, word: Word, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        let mut reader = Reader::new(word, clause, &args);
        let what = if word == word::INDIRP { "a point" } else { "a vector" };
        let mut fields: Vec<Option<Vec3>> = Vec::new();
        while !reader.is_empty() && fields.len() < 3 {
            if matches!(reader.peek().map(|a| &a.kind), Some(ArgKind::Empty)) {
                reader.skip(1);
                fields.push(None);
                continue;
            }
            let named = match reader.peek().and_then(|a| a.form()) {
                Some(Form::Vector(v)) if word != word::INDIRP => Some(*v),
                Some(Form::Point(p)) if word == word::INDIRP => Some(*p),
                _ => None,
            };
            let field = if let Some(field) = named {
                reader.skip(1);
                field
            } else if word == word::INDIRP && reader.numbers_ahead() == 2 {
                let (x, y) = (reader.number(), reader.number());
                Vec3::new(x.unwrap_or_default(), y.unwrap_or_default(), 0.0)
            } else if let Some(field) = reader.triple() {
                field
            } else {
                return Err(self.expect(&reader, &format!("{what} or three numbers")));
            };
            if word != word::INDIRP && field == Vec3::zeros() {
                let mut message = reader.expected("a direction");
                message.message = format!("{word} gives no direction: the vector has no length");
                self.error(message.help("give three numbers that are not all zero"));
                return Err(crate::eval::Poisoned);
            }
            fields.push(Some(field));
        }
        self.at_end(&reader)?;
        if fields.iter().all(Option::is_none) {
            return Err(self.expect(&reader, what));
        }
        self.emit(match word {
            word::INDIRV => Kind::Sense(Sense::Vector(fields)),
            word::INDIRP => Kind::Sense(Sense::Point(fields)),
            _ => Kind::SurfaceNormals(fields),
        });
        Ok(())
    }
}
