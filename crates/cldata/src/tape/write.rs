//! The writer.

use std::io::{self, Write};

use aptc_geometry::Transform;
use aptc_vocabulary as vocabulary;

use super::Framing;
use super::words::{self, Raw};
use crate::{
    Arg, Clprnt, Course, Edit, Kind, Motion, MotionKind, Output, Position, Record, RecordWriter,
    Units, flatten,
};

/// Points of one record: 240 words.
const POINT_WORDS: usize = 240;

/// Writes binary records of APT-360.
pub struct TapeWriter<W> {
    out: W,
    buf: Vec<u8>,
    dialect: vocabulary::Dialect,
    framing: Framing,
    number: i32,
    /// Statement of the last 1000 record.
    statement: Option<u32>,
    last: Option<Position>,
    tolerance: f64,
    units: Units,
    words: Vec<Raw>,
}

impl<W: Write> TapeWriter<W> {
    /// A writer onto `out`, which need not be buffered; words get the codes of `dialect`.
    pub fn new(out: W, dialect: vocabulary::Dialect) -> Self {
        Self::framed(out, Framing::Tape, dialect)
    }

    pub(crate) fn framed(out: W, framing: Framing, dialect: vocabulary::Dialect) -> Self {
        Self {
            out,
            buf: Vec::new(),
            dialect,
            framing,
            number: 0,
            statement: None,
            last: None,
            tolerance: 0.0,
            units: Units::Inches,
            words: Vec::new(),
        }
    }

    /// Ends the file and gives back what was written onto.
    pub fn into_inner(mut self) -> io::Result<W> {
        self.finish()?;
        Ok(self.out)
    }

    fn record(&mut self, kind: i32, subtype: i32, body: &[Raw]) -> io::Result<()> {
        self.number = self.number.wrapping_add(1);
        let n = i32::try_from(body.len()).map_err(|_| io::ErrorKind::InvalidInput)?;
        let head = match self.framing {
            Framing::Tape => [self.number, n, kind, subtype],
            Framing::Fortran { .. } => [12 + 8 * n, self.number, kind, subtype],
        };
        match self.framing {
            Framing::Fortran { big: true } => {
                self.buf.extend(head.into_iter().flat_map(i32::to_be_bytes));
                for raw in body {
                    let mut raw = *raw;
                    if !words::is_text(&raw) {
                        raw.reverse();
                    }
                    self.buf.extend_from_slice(&raw);
                }
                self.buf.extend_from_slice(&head[0].to_be_bytes());
            }
            framing => {
                self.buf.extend(head.into_iter().flat_map(i32::to_le_bytes));
                self.buf.extend_from_slice(body.as_flattened());
                if framing != Framing::Tape {
                    self.buf.extend_from_slice(&head[0].to_le_bytes());
                }
            }
        }
        if self.buf.len() > 64 * 1024 {
            self.out.write_all(&self.buf)?;
            self.buf.clear();
        }
        Ok(())
    }

    fn values(&mut self, kind: i32, subtype: i32, values: &[f64]) -> io::Result<()> {
        let body: Vec<Raw> = values.iter().map(|x| words::number(*x)).collect();
        self.record(kind, subtype, &body)
    }

    /// A statement of a major word.
    fn major(&mut self, word: &str, args: &[Arg]) -> io::Result<()> {
        let mut body = std::mem::take(&mut self.words);
        body.clear();
        let subtype = match words::code_for(word, self.dialect, true) {
            Some(n) => i32::try_from(n).unwrap_or(0),
            None => {
                words::put_text(&mut body, word);
                0
            }
        };
        for arg in args {
            match arg {
                Arg::Number(x) => body.push(words::number(*x)),
                Arg::Word(w) => words::put_word(&mut body, w, self.dialect),
                Arg::Text(t) => words::put_text(&mut body, t),
                Arg::Form { name, form } => {
                    if name.name.is_empty() {
                        body.push([0; 8]);
                    } else {
                        words::put_word(&mut body, &name.name, vocabulary::Dialect::ClText);
                    }
                    body.push(words::number(f64::from(name.subscript)));
                    body.extend(form.canonical().into_iter().map(words::number));
                }
            }
        }
        let done = self.record(2000, subtype, &body);
        self.words = body;
        done
    }

    /// PARTNO, PPRINT, INSERT: at least 66 characters, the first of them a blank as on a card.
    fn text(&mut self, word: &str, text: &str) -> io::Result<()> {
        let Some(code) = words::code_for(word, self.dialect, true) else {
            return self.major(word, &[Arg::Text(text.into())]);
        };
        let bytes: Vec<u8> =
            format!(" {text}").chars().map(|c| u8::try_from(c).unwrap_or(b'?')).collect();
        let mut body: Vec<Raw> = bytes.chunks(6).map(words::chunk).collect();
        body.resize(body.len().max(11), *b"        ");
        self.record(2000, i32::try_from(code).unwrap_or(0), &body)
    }

    fn motion(&mut self, motion: &Motion) -> io::Result<()> {
        let name = if motion.name.name.is_empty() {
            [0; 8]
        } else {
            words::right(motion.name.name.get(..6).unwrap_or(&motion.name.name))
        };
        let subscript = words::number(f64::from(motion.name.subscript));
        if let (Framing::Fortran { .. }, Some(arc), Some(start), [end]) =
            (self.framing, &motion.arc, self.last, motion.points.as_slice())
            && let Course::Sweep(sweep) = arc.course
            && !motion.with_axis
        {
            let c = &arc.circle;
            let values = [c.center, c.axis].map(|v| [v.x, v.y, v.z]).concat();
            let ends = [start.te, end.te].map(|v| [v.x, v.y, v.z]).concat();
            let mut body = vec![[0; 8], words::integer(4), words::integer(9), name, subscript];
            body.extend(values.into_iter().map(words::number));
            body.push(words::number(c.radius));
            body.extend(ends.into_iter().map(words::number));
            body.push(words::number(sweep));
            self.last = Some(*end);
            return self.record(15000, 2, &body);
        }
        let is_end = matches!(motion.arc, Some(a) if matches!(a.course, Course::Sweep(_)));
        let tolerance =
            if self.tolerance > 0.0 { self.tolerance } else { 0.0127 / self.units.mm() };
        let made = is_end.then(|| flatten::positions(motion, self.last, tolerance));
        let points = made.as_deref().unwrap_or(&motion.points);
        if let Some(arc) = &motion.arc {
            let c = &arc.circle;
            let values =
                [c.center.x, c.center.y, c.center.z, c.axis.x, c.axis.y, c.axis.z, c.radius];
            let mut body = vec![[0; 8], words::integer(4), words::integer(9), name, subscript];
            body.extend(values.map(words::number));
            self.record(3000, 2, &body)?;
        }
        let width = if motion.with_axis { 6 } else { 3 };
        let mut subtype = if motion.kind == MotionKind::From { 3 } else { 5 };
        for part in points.chunks(POINT_WORDS / width) {
            let mut body = std::mem::take(&mut self.words);
            body.clear();
            body.extend([name, subscript]);
            for p in part {
                body.extend([p.te.x, p.te.y, p.te.z].map(words::number));
                if motion.with_axis {
                    body.extend([p.ta.x, p.ta.y, p.ta.z].map(words::number));
                }
            }
            self.record(5000, subtype, &body)?;
            self.words = body;
            subtype = 6;
        }
        self.last = points.last().copied().or(self.last);
        Ok(())
    }

    fn edit(&mut self, edit: &Edit) -> io::Result<()> {
        let word = |w: &str| Arg::Word(w.into());
        let matrix = |m: &Transform| {
            let mut list = vec![Arg::Number(0.0), Arg::Number(0.0)];
            list.extend(m.rows().map(Arg::Number));
            list
        };
        match edit {
            Edit::Index { n, close: false } => self.major("INDEX", &[Arg::Number(*n)]),
            Edit::Index { n, close: true } => {
                self.major("INDEX", &[Arg::Number(*n), word("NOMORE")])
            }
            Edit::Tracut(None) => self.major("TRACUT", &[word("NOMORE")]),
            Edit::Tracut(Some(m)) => self.major("TRACUT", &matrix(m)),
            Edit::Copy { n, step, count } => {
                let mut list = vec![Arg::Number(*n)];
                let identity = Transform::identity();
                if *step == identity {
                    list.push(word("SAME"));
                } else if step.linear == identity.linear {
                    list.push(word("TRANSL"));
                    list.extend([step.shift.x, step.shift.y, step.shift.z].map(Arg::Number));
                } else {
                    list.push(word("MODIFY"));
                    list.extend(matrix(step));
                }
                list.push(Arg::Number(f64::from(*count)));
                self.major("COPY", &list)
            }
        }
    }

    /// The 1000 record of a new statement.
    fn statement(&mut self, record: &Record) -> io::Result<()> {
        let n = if record.origin.isn > 0 { record.origin.isn } else { record.origin.line };
        let n = n.min(i32::MAX as u32);
        if n == 0 || self.statement == Some(n) {
            return Ok(());
        }
        self.statement = Some(n);
        self.record(1000, i32::try_from(n).unwrap_or(i32::MAX), &[[0; 8], *b"        "])
    }
}

impl<W: Write> RecordWriter for TapeWriter<W> {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        if matches!(record.kind, Kind::Comment(_)) {
            return Ok(());
        }
        self.statement(record)?;
        match &record.kind {
            Kind::Text { word, text } => self.text(word, text),
            Kind::Post { word, args } => self.major(word, args),
            Kind::Units(u) => {
                self.units = *u;
                let code = match u {
                    Units::Mm => 1,
                    Units::Cm => 2,
                    Units::Inches => 3,
                    Units::Feet => 4,
                };
                self.record(9000, 9, &[words::integer(code)])
            }
            Kind::Multax(on) => self.record(9000, 2, &[words::integer(u32::from(*on))]),
            Kind::Cutter(c) => self.values(6000, 6, &c.values()),
            Kind::Intol(t) => {
                self.tolerance = t[1];
                self.values(6000, 4, t)
            }
            Kind::Outtol(t) => {
                self.tolerance = self.tolerance.max(t[1]);
                self.values(6000, 5, t)
            }
            Kind::Motion(m) => self.motion(m),
            Kind::Output(o) => {
                self.record(6000, 1, &[words::integer(u32::from(*o == Output::Dntcut))])
            }
            Kind::Edit(e) => self.edit(e),
            Kind::Clprnt(what) => {
                let code = match what {
                    Clprnt::Off => 0,
                    Clprnt::On => 1,
                    Clprnt::Whole => 2,
                    Clprnt::Option => 3,
                };
                self.record(13000, 4, &[words::integer(code)])
            }
            Kind::Csys(m) => self.major("CSYS", &m.rows().map(Arg::Number)),
            Kind::Unread(text) => self.major("$UNREAD", &[Arg::Text(text.clone())]),
            Kind::Comment(_) => Ok(()),
            Kind::Fini => {
                self.last = None;
                self.record(14000, 0, &[])
            }
        }
    }

    fn finish(&mut self) -> io::Result<()> {
        if self.framing == Framing::Tape {
            self.buf.push(0xff);
        }
        self.out.write_all(&self.buf)?;
        self.buf.clear();
        self.out.flush()
    }
}
