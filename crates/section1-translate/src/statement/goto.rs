//! FROM, GOTO, GODLTA: point-to-point motion.
//!
//! | statement | arguments |
//! | --- | --- |
//! | FROM, GOTO | point, or `x,y[,z]`; then a vector or i,j,k; then a feed rate |
//! | GOTO | pattern with modifiers: `pattern.rs` |
//! | GODLTA | vector, dx,dy,dz, or one number along the tool axis; then a feed rate |

use aptc_diagnostics::{Diagnostic, codes};
use aptc_geometry::{Form, Vec3};
use aptc_protap::{Arg, Kind, NameRef, Place};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::{Word, word};

use super::reader::Reader;
use crate::Interpreter;
use crate::eval::{ArgKind, Known, Names, Poisoned};

impl Interpreter<'_> {
    /// FROM, GOTO, GODLTA.
    pub(super) fn goto(&mut self, word: Word, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        if let Some(empty) = args.iter().find(|a| matches!(a.kind, ArgKind::Empty)) {
            let message = format!("an empty field means nothing in {word}");
            self.error(
                Diagnostic::error(codes::BAD_ARGUMENTS, empty.span, message)
                    .help("write 0 for a coordinate that is zero, or take the extra comma away"),
            );
            return Err(Poisoned);
        }
        let mut reader = Reader::new(word, clause, &args);
        if word == word::GODLTA {
            if let [d, feed] = args.as_slice()
                && let (ArgKind::Number(d), ArgKind::Number(feed)) = (&d.kind, &feed.kind)
            {
                let message = format!(
                    "GODLTA with two numbers goes {d} along the tool axis, at feed rate {feed}"
                );
                self.error(
                    Diagnostic::note_at(codes::BAD_ARGUMENTS, clause.span, message)
                        .help("write GODLTA/dx,dy,0 where two coordinates are meant"),
                );
            }
            return self.delta(&mut reader);
        }
        if word == word::GOTO
            && matches!(reader.peek().and_then(|a| a.form()), Some(Form::Pattern(_)))
        {
            return self.goto_pattern(&mut reader);
        }
        let (point, name) = self.tool_end(&mut reader)?;
        let axis = match reader.vector() {
            Some(axis) => Some(axis),
            // Three more numbers are an axis, one is a feed rate.
            None if reader.numbers_ahead() >= 3 => reader.triple(),
            None => None,
        };
        let axis = axis.map(|axis| self.not_zero(axis, &reader)).transpose()?;
        self.feed(&mut reader)?;
        let place = Place { name, point, axis };
        self.emit(if word == word::FROM { Kind::From(place) } else { Kind::Goto(place) });
        Ok(())
    }

    /// A point by name or coordinates; two coordinates take z from ZSURF.
    fn tool_end(&mut self, reader: &mut Reader<'_>) -> Known<(Vec3, NameRef)> {
        if let Some(point) = reader.point() {
            return Ok(point);
        }
        let point = match reader.numbers_ahead() {
            2 if reader.left() == 2 => {
                let (x, y) = (reader.number(), reader.number());
                let flat = (x.unwrap_or_default(), y.unwrap_or_default());
                self.on_zsurf(flat.0, flat.1)
            }
            0..=2 => return Err(self.expect(reader, "a point or two or three coordinates")),
            _ => reader.triple().unwrap_or_default(),
        };
        Ok((point, NameRef::default()))
    }

    fn delta(&mut self, reader: &mut Reader<'_>) -> Known<()> {
        let kind = match reader.vector() {
            Some(v) => Kind::GoDelta(v),
            None => match reader.numbers_ahead() {
                0 => return Err(self.expect(reader, "a vector, three numbers or one number")),
                1 | 2 => Kind::GoDeltaAxis(reader.number().unwrap_or_default()),
                _ => Kind::GoDelta(reader.triple().unwrap_or_default()),
            },
        };
        self.feed(reader)?;
        self.emit(kind);
        Ok(())
    }

    /// A feed rate at the end of a motion statement is a FEDRAT before the motion.
    pub(super) fn feed(&mut self, reader: &mut Reader<'_>) -> Known<()> {
        if reader.is_empty() {
            return Ok(());
        }
        let Some(feed) = reader.number() else {
            return Err(self.expect(reader, "a feed rate or nothing more"));
        };
        self.at_end(reader)?;
        self.emit_feed(feed);
        Ok(())
    }

    /// FEDRAT/feed.
    pub(super) fn emit_feed(&mut self, feed: f64) {
        self.emit(Kind::Post { word: "FEDRAT".into(), args: vec![Arg::Number(feed)] });
    }
}
