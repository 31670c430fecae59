//! The reader.

use std::collections::VecDeque;
use std::io::{self, BufReader, Read};

use aptc_diagnostics::{Diagnostic, FileId, Origin, Span, codes};
use aptc_geometry::{Circle, Cutter, Transform, Vec3};
use aptc_vocabulary as vocabulary;
use smol_str::SmolStr;

use super::Framing;
use super::words::{self, Raw};
use crate::{
    Arc, Arg, Clprnt, Course, Edit, Kind, Motion, MotionKind, NameRef, Output, Position, Record,
    RecordReader, Units,
};

/// Most words of a record; the format's own limit is 245.
const MOST_WORDS: u32 = 1 << 16;
/// A number beyond this is no coordinate: its products would leave the range of numbers.
const FARTHEST: f64 = 1e30;
/// Most positions of one record of ours.
const MOST_POINTS: usize = 1 << 16;

/// Do the bytes begin like records of APT-360?
pub(crate) fn looks_like(head: &[u8]) -> bool {
    let Some(first) = head.get(..16) else { return false };
    let n = |i: usize| u32::from_le_bytes([first[i], first[i + 1], first[i + 2], first[i + 3]]);
    n(0) <= 1 && n(4) <= MOST_WORDS && (1000..=29000).contains(&n(8)) && n(8) % 1000 == 0
}

/// Reads binary records of APT-360.
pub struct TapeReader<R> {
    input: BufReader<R>,
    dialect: vocabulary::Dialect,
    framing: Framing,
    file: FileId,
    list: Vec<Diagnostic>,
    /// Number of the record that is read, and where it begins.
    record: u64,
    offset: u64,
    body: Vec<Raw>,
    ended: bool,
    isn: u32,
    multax: bool,
    te: Option<Vec3>,
    ta: Vec3,
    tolerance: f64,
    /// Circle and name of a 3000 record.
    circle: Option<Circle>,
    open: Option<Record>,
    queue: VecDeque<Record>,
}

impl<R: Read> TapeReader<R> {
    /// A reader of `input`; `file` stands in the spans of its messages.
    pub fn new(input: R, file: FileId) -> Self {
        Self::framed(input, file, Framing::Tape, vocabulary::Dialect::Apt360)
    }

    pub(crate) fn framed(
        input: R,
        file: FileId,
        framing: Framing,
        dialect: vocabulary::Dialect,
    ) -> Self {
        Self {
            input: BufReader::with_capacity(1 << 16, input),
            dialect,
            framing,
            file,
            list: Vec::new(),
            record: 0,
            offset: 0,
            body: Vec::new(),
            ended: false,
            isn: 0,
            multax: false,
            te: None,
            ta: Vec3::z(),
            tolerance: 0.0,
            circle: None,
            open: None,
            queue: VecDeque::new(),
        }
    }

    /// What the reader has to say, after the end.
    pub fn into_diagnostics(self) -> Vec<Diagnostic> {
        self.list
    }

    fn say(&mut self, what: &str) {
        if self.list.len() < 50 {
            let at = u32::try_from(self.offset).unwrap_or(u32::MAX);
            let message = format!("record {}: {what}", self.record);
            let span = Span::new(self.file, at, at);
            self.list.push(Diagnostic::error(codes::UNREADABLE_CL, span, message));
        }
    }

    /// Type and subtype of the next record, its words in `body`; `None` at the end.
    fn next_record(&mut self) -> io::Result<Option<(i32, i32)>> {
        let mut head = [0; 16];
        let got = fill(&mut self.input, &mut head)?;
        self.record += 1;
        if got == 0 || (got == 1 && head[0] == 0xff) {
            return Ok(None);
        }
        if got < 16 {
            self.say("the file ends within a record");
            return Ok(None);
        }
        let int = |i: usize| {
            let bytes = [head[i], head[i + 1], head[i + 2], head[i + 3]];
            match self.framing {
                Framing::Fortran { big: true } => i32::from_be_bytes(bytes),
                _ => i32::from_le_bytes(bytes),
            }
        };
        let (n, kind, subtype) = match self.framing {
            Framing::Tape => (int(4), int(8), int(12)),
            Framing::Fortran { .. } => match int(0).checked_sub(12) {
                Some(n) if n % 8 == 0 => (n / 8, int(8), int(12)),
                _ => (-1, 0, 0),
            },
        };
        let Some(n) = u32::try_from(n).ok().filter(|n| *n <= MOST_WORDS) else {
            self.say("a length that no record has; the rest of the file is not read");
            return Ok(None);
        };
        self.body.clear();
        self.body.resize(n as usize, [0; 8]);
        let mut got = fill(&mut self.input, self.body.as_flattened_mut())?;
        self.offset += 16 + 8 * u64::from(n);
        if let Framing::Fortran { big } = self.framing {
            got = got.saturating_sub(4) + fill(&mut self.input, &mut [0; 4])?;
            self.offset += 4;
            if big {
                for raw in self.body.iter_mut().filter(|raw| !words::is_text(raw)) {
                    raw.reverse();
                }
            }
        }
        if got < 8 * n as usize {
            self.say("the file ends within a record");
            return Ok(None);
        }
        Ok(Some((kind, subtype)))
    }

    fn emit(&mut self, kind: Kind) {
        self.close();
        let at = u32::try_from(self.offset).unwrap_or(u32::MAX);
        let span = Span::new(self.file, at, at);
        let origin = Origin { span, isn: self.isn, line: self.isn, ..Origin::default() };
        self.queue.push_back(Record { origin, kind });
    }

    /// Ends the open motion; its circle becomes that of the path, if it is one.
    fn close(&mut self) {
        let Some(mut record) = self.open.take() else { return };
        if matches!(&record.kind, Kind::Motion(m) if m.points.is_empty()) {
            return;
        }
        if let Kind::Motion(m) = &mut record.kind
            && let Some(circle) = self.circle.take()
        {
            let circle = path_circle(circle, m, self.tolerance);
            m.arc = circle.map(|circle| Arc { circle, course: Course::Chords });
        }
        self.queue.push_back(record);
    }

    /// The words as numbers; one that cannot be a coordinate or a tolerance is 0.
    fn numbers(&self) -> Vec<f64> {
        let limited = |x: f64| if x.abs() < FARTHEST { x } else { 0.0 };
        self.body.iter().map(words::number_of).map(limited).collect()
    }

    fn take(&mut self, kind: i32, subtype: i32) {
        match (kind, subtype) {
            (5000, 6) if self.open.is_some() => self.points(subtype),
            (5000, 3 | 5 | 6) => {
                let circle = self.circle.take();
                self.close();
                self.circle = circle;
                self.points(subtype);
            }
            (5000, 4) => self.say("a GODLTA that was not carried out"),
            (1000, n) => {
                self.close();
                self.isn = n.unsigned_abs();
            }
            (2000, code) => self.post(code),
            (3000, _) => {
                self.close();
                let n = self.numbers();
                self.circle = match n.as_slice() {
                    [_, kind, _, _, _, x, y, z, i, j, k, r] if (*kind - 4.0).abs() < 0.5 => {
                        let (center, axis) = (Vec3::new(*x, *y, *z), Vec3::new(*i, *j, *k));
                        Some(Circle { center, axis, radius: *r })
                    }
                    _ => None,
                };
            }
            (15000, _) => self.whole_arc(),
            // Normals for radius compensation: not lost, but nothing here uses them.
            (10000 | 28000 | 29000, _) => {
                let args: Vec<String> = self.numbers().iter().map(f64::to_string).collect();
                self.emit(Kind::Unread(format!("{kind}:{subtype} {}", args.join(",")).into()));
            }
            (6000, 1) => {
                let off = self.numbers().first().is_some_and(|x| *x > 0.5);
                self.emit(Kind::Output(if off { Output::Dntcut } else { Output::Cut }));
            }
            (6000, 4 | 5) => {
                let n = self.numbers();
                let first = n.first().copied().unwrap_or(0.0);
                let mut t = [first; 4];
                for (place, x) in t.iter_mut().zip(&n) {
                    *place = *x;
                }
                if subtype == 4 {
                    self.tolerance = t[1];
                    self.emit(Kind::Intol(t));
                } else {
                    self.tolerance += t[1];
                    self.emit(Kind::Outtol(t));
                }
            }
            (6000, 6) => self.cutter(),
            (9000, 2) => {
                self.multax = self.numbers().first().is_none_or(|x| *x > 0.5);
                if !self.multax {
                    self.ta = Vec3::z();
                }
                self.emit(Kind::Multax(self.multax));
            }
            (9000, 9) => {
                let code = self.numbers().first().copied().unwrap_or(3.0);
                let units = match code {
                    x if x < 1.5 => Units::Mm,
                    x if x < 2.5 => Units::Cm,
                    x if x < 3.5 => Units::Inches,
                    _ => Units::Feet,
                };
                self.emit(Kind::Units(units));
            }
            (13000, 4) => {
                let code = self.numbers().first().copied().unwrap_or(1.0);
                let what = match code {
                    x if x < 0.5 => Clprnt::Off,
                    x if x < 1.5 => Clprnt::On,
                    x if x < 2.5 => Clprnt::Whole,
                    _ => Clprnt::Option,
                };
                self.emit(Kind::Clprnt(what));
            }
            (14000, _) => {
                self.emit(Kind::Fini);
                // Nothing of a program holds for the next one in the file.
                (self.multax, self.te, self.ta) = (false, None, Vec3::z());
            }
            (kind, subtype) => {
                let args: Vec<String> = self.numbers().iter().map(f64::to_string).collect();
                self.say(&format!("type {kind} subtype {subtype} is not known"));
                self.emit(Kind::Unread(format!("{kind}:{subtype} {}", args.join(",")).into()));
            }
        }
    }

    /// One or two numbers as CUTTER has them, five to seven, or the disk of CUTTER/OPTION.
    fn cutter(&mut self) {
        let n = self.numbers();
        let cutter = match n.as_slice() {
            &[d] => Cutter::by_two(d, 0.0, 5.0),
            &[d, r] => Cutter::by_two(d, r, 5.0),
            &[d, r, e, f, a, b, ref h @ ..] if h.len() <= 1 => Cutter {
                diameter: d,
                corner_radius: r,
                e,
                f,
                alpha_deg: a,
                beta_deg: b,
                height: h.first().copied().unwrap_or(5.0),
            },
            other => {
                let args = other.iter().copied().map(Arg::Number).collect();
                return self.emit(Kind::Post { word: "CUTTER".into(), args });
            }
        };
        self.emit(Kind::Cutter(cutter));
    }

    /// An arc that is not cut into chords: 0, 4, 9, name, subscript, circle, start, end, angle. Where
    /// there are fewer numbers, the last three are the end, and the arc goes there right-handed.
    fn whole_arc(&mut self) {
        let n = self.numbers();
        let (&[_, _, _, _, _, x, y, z, i, j, k, radius], rest) = match n.split_at_checked(12) {
            Some((head, rest)) => (<&[f64; 12]>::try_from(head).expect("split there"), rest),
            None => return self.say("an arc that cannot be read"),
        };
        let (&[a, b, c], angle) = match rest {
            [_, _, _, end @ .., sweep] if end.len() == 3 => {
                (<&[f64; 3]>::try_from(end).expect("of that length"), Some(*sweep))
            }
            _ => match rest.last_chunk() {
                Some(end) => (end, None),
                None => return self.say("an arc without an end"),
            },
        };
        let (center, te) = (Vec3::new(x, y, z), Vec3::new(a, b, c));
        let Some(axis) = crate::read::unit(Vec3::new(i, j, k)) else {
            return self.say("an arc without an axis");
        };
        let start = self.te.unwrap_or(te);
        let sweep = angle.unwrap_or_else(|| crate::read::sweep(center, axis, start, te));
        self.te = Some(te);
        self.close();
        let body = std::mem::take(&mut self.body);
        self.begin(body.get(3..).unwrap_or_default(), 5, false);
        self.body = body;
        if let Some(Record { kind: Kind::Motion(m), .. }) = &mut self.open {
            let circle = Circle { center, axis, radius };
            m.arc = Some(Arc { circle, course: Course::Sweep(sweep) });
            m.with_axis = self.multax;
            m.points.push(Position { te, ta: self.ta });
        }
        self.close();
    }

    fn post(&mut self, code: i32) {
        let code = u32::try_from(code).unwrap_or(0);
        let mut args = words::arguments(&self.body, self.dialect);
        let word = if code == 0 {
            let Some(Arg::Text(word)) = args.first().cloned() else {
                return self.say("a statement without its word");
            };
            args.remove(0);
            SmolStr::from(&*word)
        } else {
            words::word(code, self.dialect, true).unwrap_or_else(|| format!("WORD{code}").into())
        };
        let kind = match word.as_str() {
            "PARTNO" | "PPRINT" | "INSERT" | "LETTER" | "TITLES" | "REMARK"
                if code > 0 && self.body.iter().all(words::is_text) =>
            {
                let text: String = self.body.iter().map(words::text_of).collect();
                Kind::Text { word, text: text.trim().into() }
            }
            "$UNREAD" | "TITLES" | "REMARK" | "PARTNO" | "PPRINT" | "INSERT" => match &*args {
                [Arg::Text(text)] if word == "$UNREAD" => Kind::Unread(text.clone()),
                [Arg::Text(text)] => Kind::Text { word, text: text.clone() },
                _ => Kind::Post { word, args },
            },
            _ => edit(&word, &args).unwrap_or(Kind::Post { word, args }),
        };
        self.emit(kind);
    }

    fn points(&mut self, subtype: i32) {
        let body = std::mem::take(&mut self.body);
        let points = body.get(2..).unwrap_or_default();
        let mut width = if self.multax { 6 } else { 3 };
        if points.len() % width != 0 {
            width = 9 - width;
        }
        if points.len() % width != 0 {
            self.say("points that are not complete");
        }
        if self.open.is_none() {
            self.begin(&body, subtype, width == 6);
        }
        for p in points.chunks_exact(width) {
            let v = |i: usize| {
                let number = |raw: &Raw| Some(words::number_of(raw)).filter(|x| x.abs() < FARTHEST);
                Some(Vec3::new(number(&p[i])?, number(&p[i + 1])?, number(&p[i + 2])?))
            };
            let axis = if width == 6 { v(3).filter(|a| a.norm() > 0.0) } else { Some(Vec3::z()) };
            let (Some(te), Some(ta)) = (v(0), axis) else {
                self.say("a point that is not a number, or an axis without direction");
                continue;
            };
            if width == 6 {
                self.ta = ta;
            }
            self.te = Some(te);
            if let Some(Record { kind: Kind::Motion(m), .. }) = &mut self.open {
                m.points.push(Position { te, ta });
            }
        }
        self.body = body;
        if let Some(Record { kind: Kind::Motion(m), .. }) = &self.open
            && m.points.len() >= MOST_POINTS
        {
            let (kind, name, with_axis) = (m.kind, m.name.clone(), m.with_axis);
            let circle = self.circle;
            self.close();
            self.circle = circle;
            self.open_motion(kind, name, with_axis);
        }
    }

    /// A motion with the name that the record has.
    fn begin(&mut self, body: &[Raw], subtype: i32, with_axis: bool) {
        let kind = if subtype == 3 { MotionKind::From } else { MotionKind::Goto };
        let name = body.first().filter(|r| words::is_text(r)).map(words::text_of);
        let subscript = body.get(1).map_or(0.0, words::number_of);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
        let subscript = subscript as u32;
        let name = NameRef { name: name.unwrap_or_default().trim().into(), subscript };
        self.open_motion(kind, name, with_axis);
    }

    fn open_motion(&mut self, kind: MotionKind, name: NameRef, with_axis: bool) {
        let at = u32::try_from(self.offset).unwrap_or(u32::MAX);
        let span = Span::new(self.file, at, at);
        let origin = Origin { span, isn: self.isn, line: self.isn, ..Origin::default() };
        let motion = Motion { kind, name, with_axis, ..Motion::default() };
        self.open = Some(Record { origin, kind: Kind::Motion(motion) });
    }
}

/// Reads until the buffer is full or the stream ends; the bytes read.
fn fill(input: &mut impl Read, mut out: &mut [u8]) -> io::Result<usize> {
    let mut n = 0;
    while !out.is_empty() {
        match input.read(out) {
            Ok(0) => break,
            Ok(got) => {
                n += got;
                out = &mut out[got..];
            }
            Err(e) if e.kind() == io::ErrorKind::Interrupted => {}
            Err(e) => return Err(e),
        }
    }
    Ok(n)
}

/// INDEX, COPY, TRACUT; and CSYS, the frame.
fn edit(word: &str, args: &[Arg]) -> Option<Kind> {
    let numbers = |list: &[Arg]| {
        let mut e = [0.0; 12];
        for (place, arg) in e.iter_mut().zip(list) {
            let Arg::Number(x) = arg else { return None };
            *place = Some(*x).filter(|x| x.abs() < FARTHEST)?;
        }
        (list.len() == 12).then(|| Transform::from_rows(&e))
    };
    let nomore = |a: &Arg| matches!(a, Arg::Word(w) if w == "NOMORE");
    match (word, args) {
        ("INDEX", [Arg::Number(n)]) => Some(Edit::Index { n: *n, close: false }),
        ("INDEX", [Arg::Number(n), w]) if nomore(w) => Some(Edit::Index { n: *n, close: true }),
        ("TRACUT", [w]) if nomore(w) => Some(Edit::Tracut(None)),
        ("TRACUT", [_, _, rest @ ..]) => Some(Edit::Tracut(Some(numbers(rest)?))),
        ("COPY", [Arg::Number(n), Arg::Word(how), middle @ .., Arg::Number(count)]) => {
            let turn = |axis| match middle {
                [Arg::Number(angle)] => Some(Transform::rotation(axis, *angle)),
                _ => None,
            };
            let step = match (how.as_str(), middle) {
                ("SAME", []) => Transform::identity(),
                ("TRANSL", [Arg::Number(x), Arg::Number(y), Arg::Number(z)]) => {
                    Transform::translation(Vec3::new(*x, *y, *z))
                }
                ("MODIFY", [_, _, rest @ ..]) => numbers(rest)?,
                ("XYROT", _) => turn(Vec3::z())?,
                ("YZROT", _) => turn(Vec3::x())?,
                ("ZXROT", _) => turn(Vec3::y())?,
                _ => return None,
            };
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
            let count = (*count >= 0.0 && *count <= 1e9).then_some(*count as u32)?;
            Some(Edit::Copy { n: *n, step, count })
        }
        ("CSYS", list) => return numbers(list).map(Kind::Csys),
        _ => None,
    }
    .map(Kind::Edit)
}

/// The circle of the tool end's path. APT-360 gives the drive surface's: the path is concentric when the
/// tool axis is parallel to the circle's and all points are equally far from it.
fn path_circle(circle: Circle, motion: &Motion, tolerance: f64) -> Option<Circle> {
    let axis = circle.axis.try_normalize(0.0)?;
    let arm = |p: &Position| p.te - circle.center;
    let distance = |p: &Position| (arm(p) - axis * axis.dot(&arm(p))).norm();
    let last = motion.points.last()?;
    let radius = distance(last);
    let band = 2.0 * tolerance + 1e-6 * radius;
    let level = |p: &Position| (axis.dot(&arm(p)) - axis.dot(&arm(last))).abs() <= band;
    let on = |r: f64| motion.points.iter().all(|p| (distance(p) - r).abs() <= band);
    if (radius - circle.radius).abs() <= 1e-9 * radius && on(circle.radius) {
        return Some(circle);
    }
    let upright = motion.points.iter().all(|p| p.ta.cross(&axis).norm() < 1e-6);
    (upright && on(radius) && motion.points.iter().all(level)).then(|| {
        let center = circle.center + axis * axis.dot(&arm(last));
        Circle { center, axis, radius }
    })
}

impl<R: Read> RecordReader for TapeReader<R> {
    fn read(&mut self, record: &mut Record) -> io::Result<bool> {
        loop {
            if let Some(next) = self.queue.pop_front() {
                *record = next;
                return Ok(true);
            }
            if self.ended {
                return Ok(false);
            }
            match self.next_record()? {
                Some((kind, subtype)) => self.take(kind, subtype),
                None => {
                    self.ended = true;
                    self.close();
                }
            }
        }
    }
}
