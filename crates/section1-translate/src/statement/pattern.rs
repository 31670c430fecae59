//! GOTO/pattern and its modifiers.
//!
//! | modifier | effect |
//! | --- | --- |
//! | INVERS | the points in reverse order |
//! | CONST | numbers of points count in the order of definition, also with INVERS |
//! | OMIT,n,.. | without these points |
//! | RETAIN,n,.. | these points alone |
//! | AVOID,h,n,.. | from each of these points to the next one at the height h above, off the cycle |
//! | ZIGZAG | every second column of a grid backwards: PATERN puts its points in that order |
//!
//! `n,THRU,m` names a range, in either order.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_geometry::{Form, Vec3};
use aptc_protap::{Arg, Kind, NameRef, Place};
use aptc_vocabulary::{Word, word};

use super::reader::Reader;
use crate::Interpreter;
use crate::eval::{ArgKind, Known, Poisoned};

const MODIFIERS: &[Word] =
    &[word::INVERS, word::CONST, word::OMIT, word::RETAIN, word::AVOID, word::ZIGZAG];

/// What becomes of a point of the pattern.
#[derive(Clone, Copy, Default)]
struct Mark {
    omit: bool,
    retain: bool,
    avoid: Option<f64>,
}

impl Interpreter<'_> {
    /// GOTO/pattern,...
    pub(super) fn goto_pattern(&mut self, reader: &mut Reader<'_>) -> Known<()> {
        let Some(first) = reader.next() else { return Err(Poisoned) };
        let (Some(Form::Pattern(pattern)), ArgKind::Form { name, .. }) =
            (first.form(), &first.kind)
        else {
            return Err(Poisoned);
        };
        let mut points = pattern.points.clone();
        let mut marks = vec![Mark::default(); points.len()];
        let mut retained = false;
        let (mut inverse, mut by_definition) = (false, false);
        while let Some(modifier) = reader.word_of(MODIFIERS) {
            match modifier {
                word::INVERS => inverse = true,
                word::CONST => by_definition = true,
                word::ZIGZAG => {}
                word::AVOID => {
                    let Some(height) = reader.number() else {
                        return Err(self.expect(reader, "the height of the detour"));
                    };
                    self.mark(reader, &mut marks, |m| m.avoid = Some(height))?;
                }
                word::OMIT => self.mark(reader, &mut marks, |m| m.omit = true)?,
                _ => {
                    retained = true;
                    self.mark(reader, &mut marks, |m| m.retain = true)?;
                }
            }
        }
        if reader.left() == 1 {
            self.feed(reader)?;
        }
        self.at_end(reader)?;
        // Numbers count in the order of output unless CONST says otherwise.
        if inverse {
            points.reverse();
            if by_definition {
                marks.reverse();
            }
        }
        let chosen: Vec<(Vec3, Option<f64>)> = points
            .into_iter()
            .zip(marks)
            .filter(|(_, m)| !m.omit && (m.retain || !retained))
            .map(|(p, m)| (p, m.avoid))
            .collect();
        let name = name.clone();
        self.emit_points(&name, &chosen);
        Ok(())
    }

    /// The numbers of points after a modifier.
    fn mark(
        &mut self,
        reader: &mut Reader<'_>,
        marks: &mut [Mark],
        set: impl Fn(&mut Mark),
    ) -> Known<()> {
        let before = reader.left();
        while reader.peek().is_some_and(|a| a.number().is_some()) {
            let first = self.point_number(reader, marks.len())?;
            let last = if reader.is_word(word::THRU) {
                self.point_number(reader, marks.len())?
            } else {
                first
            };
            for mark in &mut marks[first.min(last)..=first.max(last)] {
                set(mark);
            }
        }
        if reader.left() == before {
            return Err(self.expect(reader, "the number of a point"));
        }
        Ok(())
    }

    /// The number of a point, from 1, as its place, from 0.
    fn point_number(&mut self, reader: &mut Reader<'_>, n: usize) -> Known<usize> {
        let Some(arg) = reader.next() else {
            return Err(self.expect(reader, "the number of a point"));
        };
        let Some(number) = arg.number() else {
            self.error(Diagnostic::error(
                codes::BAD_ARGUMENTS,
                arg.span,
                "the number of a point is expected here",
            ));
            return Err(Poisoned);
        };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates, and is compared with the length"
        )]
        let place = number.trunc() as usize;
        if place >= 1 && place <= n {
            return Ok(place - 1);
        }
        self.error(Diagnostic::error(
            codes::NO_SUCH_POINT,
            arg.span,
            format!("the pattern has the points 1 to {n}, not {number}"),
        ));
        Err(Poisoned)
    }

    /// Runs of points as they are, with the detours of AVOID between them.
    fn emit_points(&mut self, name: &NameRef, chosen: &[(Vec3, Option<f64>)]) {
        let mut run: Vec<Vec3> = Vec::new();
        for (i, (point, avoid)) in chosen.iter().enumerate() {
            run.push(*point);
            let (Some(height), Some((next, _))) = (avoid, chosen.get(i + 1)) else { continue };
            let points = std::mem::take(&mut run);
            self.emit(Kind::Points { name: name.clone(), points });
            self.emit_cycle("NOMORE");
            for p in [point, next] {
                let point = Vec3::new(p.x, p.y, p.z + height);
                self.emit(Kind::Goto(Place { name: name.clone(), point, axis: None }));
            }
            self.emit_cycle("ON");
        }
        if !run.is_empty() {
            self.emit(Kind::Points { name: name.clone(), points: run });
        }
    }

    fn emit_cycle(&mut self, mode: &str) {
        self.emit(Kind::Post { word: "CYCLE".into(), args: vec![Arg::Word(mode.into())] });
    }
}
