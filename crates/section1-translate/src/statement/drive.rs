//! GOLFT GORGT GOFWD GOBACK GOUP GODOWN: continuous motion.
//!
//! `GOLFT/DS[,[rel,][n,INTOF,]CS[,label]]...[,feed]`, rel one of TO ON PAST TANTO DSTAN PSTAN. Without a
//! check surface the next motion's drive surface is meant. With one check surface a number at the end is
//! a feed rate, even when a label of these digits exists; with several it is the label of its surface.

use std::sync::Arc;

use aptc_diagnostics::Span;
use aptc_protap::{Check, Direction, Drive, Kind, Relation};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::{Word, word};

use super::reader::Reader;
use crate::Interpreter;
use crate::eval::{Arg, ArgKind, Known, Names, Poisoned};
use crate::program::Unit;

const RELATIONS: &[Word] = &[word::TO, word::ON, word::PAST, word::TANTO, word::DSTAN, word::PSTAN];

/// The relation that a word names.
pub(super) fn relation(word: Word) -> Relation {
    match word {
        word::ON => Relation::On,
        word::PAST => Relation::Past,
        word::TANTO | word::DSTAN => Relation::Tanto,
        word::PSTAN => Relation::Pstan,
        _ => Relation::To,
    }
}

impl Interpreter<'_> {
    /// A motion word with its surfaces.
    pub(super) fn drive(&mut self, word: Word, clause: &Clause, unit: &Arc<Unit>) -> Known<()> {
        let direction = match word {
            word::GOLFT => Direction::Golft,
            word::GORGT => Direction::Gorgt,
            word::GOFWD => Direction::Gofwd,
            word::GOBACK => Direction::Goback,
            word::GOUP => Direction::Goup,
            _ => Direction::Godown,
        };
        let args = self.args(clause, Names::Free)?;
        let mut reader = Reader::new(word, clause, &args);
        let drive = self.surface(&mut reader, "the drive surface")?;
        let mut checks: Vec<Check> = Vec::new();
        let mut labels: Vec<Option<Span>> = Vec::new();
        while !reader.is_empty() {
            if reader.left() == 1
                && reader.numbers_ahead() == 1
                && !labels.iter().any(Option::is_some)
            {
                break;
            }
            let (check, label) = self.check(&mut reader, unit, checks.len())?;
            checks.push(check);
            labels.push(label);
        }
        self.feed(&mut reader)?;
        let mut goals = Vec::with_capacity(labels.len());
        for label in &labels {
            goals.push(match label {
                Some(span) => match self.label_goal(unit, *span) {
                    Some(goal) => Some(goal),
                    None => return Err(Poisoned),
                },
                None => None,
            });
        }
        let branches = goals.iter().any(Option::is_some);
        self.emit(Kind::Drive(Drive { direction, drive, checks }));
        if branches {
            self.branch_on(goals);
        }
        Ok(())
    }

    /// A check surface and its label.
    fn check(
        &mut self,
        reader: &mut Reader<'_>,
        unit: &Arc<Unit>,
        before: usize,
    ) -> Known<(Check, Option<Span>)> {
        let relation = reader.word_of(RELATIONS).map_or(Relation::To, relation);
        let nth = if reader.ahead(1).and_then(Arg::word) == Some(word::INTOF) {
            self.nth(reader)?
        } else {
            1
        };
        let surface = self.surface(reader, "a check surface")?;
        // A name or digits are a label when more follows or when other surfaces have labels.
        let place_of_label = reader.left() > 1
            && reader.ahead(1).and_then(Arg::word) != Some(word::INTOF)
            || reader.left() == 1 && before > 0;
        let label = match reader.peek() {
            Some(Arg { kind: ArgKind::Name(_), span }) => Some(*span),
            Some(Arg { kind: ArgKind::Digits(_), span }) if place_of_label => Some(*span),
            // The name of a number may be that of a label too.
            Some(Arg { kind: ArgKind::Number(_), span }) if place_of_label => {
                unit.digits(&self.interner, *span).map(|_| *span)
            }
            // So may a word that says nothing of a check surface.
            Some(Arg { kind: ArgKind::Word(w), span })
                if place_of_label && !RELATIONS.contains(w) && self.is_label(unit, *span) =>
            {
                Some(*span)
            }
            _ => None,
        };
        if label.is_some() {
            reader.skip(1);
        }
        let check = Check { relation, nth, surface, branch: label.is_some() };
        Ok((check, label))
    }

    /// n,INTOF
    fn nth(&mut self, reader: &mut Reader<'_>) -> Known<u32> {
        let Some(arg) = reader.peek() else { return Err(Poisoned) };
        let whole = arg.number().filter(|n| *n >= 1.0 && *n <= 1e6 && n.fract() == 0.0);
        let Some(n) = whole else {
            return Err(self.expect(reader, "the whole number of an intersection, from 1,"));
        };
        reader.skip(2);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 1 and a million"
        )]
        Ok(n as u32)
    }
}
