//! The reader of all text dialects.

use std::io::{self, Read};

use aptc_diagnostics::{Diagnostic, FileId, Severity, codes};
use aptc_geometry::Vec3;

use super::layout::Layout;
use super::report::Place;
use super::scan::Scanner;
use super::state::State;
use super::{catia, comments, creo, detect, fast, nx, words};
use crate::{Dialect, Kind, Motion, Position, Record, RecordReader, Units};

/// Reads CL text of any dialect, record by record.
pub struct TextReader<R> {
    scanner: Scanner<R>,
    state: State,
    /// Unit to be stated before the first record that is no text.
    unit: Option<Units>,
    /// Is that the unit of a UNITS further down? Then nothing but a length wants it before.
    stated: bool,
    /// Memory of the positions of a record that was given up.
    spare: Vec<Position>,
    ended: bool,
}

impl<R: Read> TextReader<R> {
    /// A reader of `input` in that dialect; `file` stands in the spans of its messages.
    pub fn new(input: R, dialect: Dialect, file: FileId) -> Self {
        let (scanner, state) = (Scanner::new(input), State::new(dialect, file));
        Self { scanner, state, unit: None, stated: false, spare: Vec::new(), ended: false }
    }

    /// States the unit that the head of the file lets conclude, and says so.
    pub(super) fn state_unit(&mut self, unit: &detect::Unit) {
        if let Some((unit, severity, what)) = unit.statement() {
            let at = Place { line: 1, ..Place::default() };
            self.state.report.note(at, codes::CL_UNIT, severity, what);
            self.unit = unit;
            self.state.units = unit;
        }
        // A CAM system has one unit for all of its file, wherever it states it; in a program of statements
        // UNITS holds from where it stands.
        if let detect::Unit::Stated(unit) = *unit
            && self.state.dialect != Dialect::Iso
        {
            (self.unit, self.stated) = (unit, true);
            self.state.units = unit;
        }
    }

    /// The file lies so.
    pub(super) fn lay_out(&mut self, layout: Layout) {
        self.scanner.layout = layout;
    }

    /// Has a mark said where records come from?
    pub(super) fn is_marked(&self) -> bool {
        self.state.is_marked()
    }

    /// What the reader has to say, after the end.
    pub fn into_diagnostics(self) -> Vec<Diagnostic> {
        self.state.report.into_diagnostics()
    }

    /// The unit that must be stated before the next record.
    fn unit_due(&mut self) -> Option<Units> {
        self.unit?;
        match self.state.next_ready()? {
            Kind::Text { .. } | Kind::Comment(_) => None,
            Kind::Units(_) => {
                self.unit = None;
                None
            }
            kind if self.stated && !kind.has_lengths() => None,
            _ => self.unit.take(),
        }
    }

    /// A plain GOTO line into the record, or into the open motion. `None` when it must go the slow way.
    #[inline]
    fn fast(&mut self, record: &mut Record) -> io::Result<Option<bool>> {
        let plain = self.state.is_plain() && self.unit.is_none();
        if !plain && self.state.open.is_none() {
            return Ok(None);
        }
        let mut v = [0.0; 6];
        let Some(line) = self.scanner.peek()? else { return Ok(None) };
        let length = line.len() as u64;
        let Some(n) = fast::goto(line, &mut v) else { return Ok(None) };
        let te = Vec3::new(v[0], v[1], v[2]);
        let given = (n == 6).then(|| Vec3::new(v[3], v[4], v[5]));
        if !plain && !self.state.takes_points(given.is_some() || self.state.axis_seen) {
            return Ok(None);
        }
        let at = &mut self.state.at;
        at.line = self.scanner.line;
        at.start = self.scanner.offset;
        at.end = at.start + length;
        let (ta, with_axis) = self.state.axis(given);
        let p = Position { te, ta };
        self.scanner.advance();
        self.state.in_goto = true;
        if !plain {
            self.state.position(false, p, with_axis);
            return Ok(Some(false));
        }
        self.state.te = Some(te);
        self.state.set_origin(&mut record.origin);
        if let Kind::Motion(m) = &mut record.kind {
            m.points.clear();
            m.points.push(p);
            let points = std::mem::take(&mut m.points);
            *m = Motion { points, with_axis, ..Motion::default() };
        } else {
            let mut points = std::mem::take(&mut self.spare);
            points.clear();
            points.push(p);
            record.kind = Kind::Motion(Motion { points, with_axis, ..Motion::default() });
        }
        Ok(Some(true))
    }

    /// The next statement, of any kind.
    fn slow(&mut self) -> io::Result<()> {
        let (line, start) = (self.scanner.line, self.scanner.offset);
        let there = self.scanner.next_statement(words::is_verbatim)?;
        if !there {
            return Ok(());
        }
        let state = &mut self.state;
        state.at = Place { line, start, end: self.scanner.offset };
        let text = self.scanner.text();
        if self.scanner.cut_off {
            let help = "see whether the file is whole";
            state.report.error(state.at, "the file ends where the statement goes on", help);
        }
        words::statement(state, text);
        if let Some(comment) = self.scanner.comment() {
            let taken = match state.dialect {
                Dialect::Creo => creo::structured(state, comment),
                _ => catia::comment(state, comment),
            };
            if !taken {
                comments::comment(state, comment);
            }
        }
        Ok(())
    }

    fn end(&mut self) {
        self.ended = true;
        if self.state.spline.on {
            nx::end_spline(&mut self.state);
        }
        self.state.end();
        let (first, n) = self.scanner.overlong;
        for i in 0..n.min(1_000_000) {
            let what = "a line longer than 256 KiB, which is left out";
            let at = Place { line: first + i, ..Default::default() };
            self.state.report.note(at, codes::CL_LINE_TOO_LONG, Severity::Error, what);
        }
    }
}

impl<R: Read> RecordReader for TextReader<R> {
    fn read(&mut self, record: &mut Record) -> io::Result<bool> {
        loop {
            if let Some(unit) = self.unit_due() {
                record.origin = aptc_diagnostics::Origin::default();
                record.kind = Kind::Units(unit);
                return Ok(true);
            }
            if let Some(next) = self.state.take_ready() {
                let old = std::mem::replace(record, next);
                if let Kind::Motion(m) = old.kind
                    && m.points.capacity() > self.spare.capacity()
                {
                    self.spare = m.points;
                }
                return Ok(true);
            }
            match self.fast(record)? {
                Some(true) => return Ok(true),
                Some(false) => continue,
                None => {}
            }
            if self.scanner.peek()?.is_some() {
                self.slow()?;
            } else if self.ended {
                return Ok(false);
            } else {
                self.end();
            }
        }
    }
}
