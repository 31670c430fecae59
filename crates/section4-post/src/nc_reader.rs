//! Machine code as a stream of records, so that two texts can be compared as what the axes do.

use std::io::{self, BufRead};

use aptc_cldata::{Arc, Arg, Course, Kind, Motion, Position, Record, RecordReader, Units};
use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::{Circle, Vec3, trig};

use crate::machine::Machine;
use crate::readback::{ArcStep, Place, Reader, Step};

/// Longest line that is read.
const LONGEST: u64 = 64 * 1024;
/// Messages about single lines.
const MOST: usize = 50;

/// Reads machine code of a machine: positions of the linear axes in millimetres, and a vector that turns
/// with the rotary axes; RAPID, FEDRAT, and the words M, S and T as post-processor words. Axes that the text
/// has not placed yet stand at 0. Records carry the line of the text.
pub struct NcReader<R> {
    input: R,
    reader: Reader,
    line: Vec<u8>,
    n_lines: u32,
    steps: Vec<Step>,
    ready: std::collections::VecDeque<Kind>,
    /// Unit stated, rapid said, feed said.
    begun: bool,
    feed: Option<f64>,
    list: Vec<Diagnostic>,
}

impl<R: BufRead> NcReader<R> {
    /// A reader of `input` as that machine's control reads it.
    pub fn new(machine: &Machine, input: R) -> Self {
        Self {
            input,
            reader: Reader::new(machine),
            line: Vec::new(),
            n_lines: 0,
            steps: Vec::new(),
            ready: std::collections::VecDeque::new(),
            begun: false,
            feed: None,
            list: Vec::new(),
        }
    }

    /// What the reader has to say, after the end.
    pub fn into_diagnostics(self) -> Vec<Diagnostic> {
        self.list
    }

    /// Takes the next line in; false at the end.
    fn next_line(&mut self) -> io::Result<bool> {
        self.line.clear();
        let n = io::Read::take(&mut self.input, LONGEST).read_until(b'\n', &mut self.line)?;
        if n == 0 {
            return Ok(false);
        }
        self.n_lines = self.n_lines.saturating_add(1);
        let mut steps = std::mem::take(&mut self.steps);
        steps.clear();
        let line = self.line.trim_ascii();
        for (letter, value) in codes(line) {
            let word = char::from(letter).to_string();
            self.ready.push_back(Kind::Post { word: word.into(), args: vec![Arg::Number(value)] });
        }
        if let Err(fault) = self.reader.read(line, &mut steps)
            && self.list.len() < MOST
        {
            let message = format!("line {}: {}", self.n_lines, fault.message);
            self.list.push(Diagnostic::error(codes::UNREADABLE_CL, Span::default(), message));
        }
        for step in &steps {
            self.step(step);
        }
        self.steps = steps;
        Ok(true)
    }

    fn step(&mut self, step: &Step) {
        let motion = match step {
            Step::Away => return self.word("GOHOME", Vec::new()),
            // Places of the axes are compared, in whatever frame they are written.
            Step::Frame(_) | Step::Center(_) => return,
            Step::Line { to, rapid, feed, .. } => {
                if *rapid {
                    self.word("RAPID", Vec::new());
                } else if let Some(f) = feed
                    && self.feed.is_none_or(|known| (known - f).abs() > 1e-9 * f.abs())
                {
                    self.feed = Some(*f);
                    self.word("FEDRAT", vec![Arg::Number(*f)]);
                }
                Motion { points: vec![position(to)], ..Motion::default() }
            }
            Step::Arc(arc) => circular(arc),
        };
        self.ready.push_back(Kind::Motion(Motion { with_axis: true, ..motion }));
    }

    fn word(&mut self, word: &str, args: Vec<Arg>) {
        self.ready.push_back(Kind::Post { word: word.into(), args });
    }
}

impl<R: BufRead> RecordReader for NcReader<R> {
    fn read(&mut self, record: &mut Record) -> io::Result<bool> {
        if !self.begun {
            self.begun = true;
            self.ready.push_back(Kind::Units(Units::Mm));
        }
        while self.ready.is_empty() {
            if !self.next_line()? {
                return Ok(false);
            }
        }
        record.origin = aptc_diagnostics::Origin { line: self.n_lines, ..Default::default() };
        record.kind = self.ready.pop_front().unwrap_or_default();
        Ok(true)
    }
}

/// Linear axes as they stand; the rotary axes turn a vector that lies on neither of their axes.
fn position(place: &Place) -> Position {
    let [x, y, z, a, b] = place.map(|v| v.unwrap_or(0.0));
    let (sa, ca) = (trig::sin_deg(a), trig::cos_deg(a));
    let (sb, cb) = (trig::sin_deg(b), trig::cos_deg(b));
    // A leaning vector turned about x by the first, then about the leaning (y + z) by the second.
    let r = std::f64::consts::FRAC_1_SQRT_2;
    let v = Vec3::new(r, -sa * r, ca * r);
    let n = Vec3::new(0.0, r, r);
    let ta = v * cb + n.cross(&v) * sb + n * (n.dot(&v) * (1.0 - cb));
    Position { te: Vec3::new(x, y, z), ta }
}

fn circular(step: &ArcStep) -> Motion {
    let from = position(&step.from);
    let [i, j] = step.axes;
    let mut center = from.te;
    center[i] = step.center[0];
    center[j] = step.center[1];
    let unit = |k: usize| Vec3::from_fn(|r, _| if r == k { 1.0 } else { 0.0 });
    let axis = unit(i).cross(&unit(j));
    let axis = if step.sweep < 0.0 { -axis } else { axis };
    let circle = Circle { center, axis, radius: step.radius };
    let arc = Arc { circle, course: Course::Sweep(step.sweep.abs().to_degrees()) };
    Motion { arc: Some(arc), points: vec![position(&step.to)], ..Motion::default() }
}

/// M, S and T words of a line, without what stands in comments.
fn codes(line: &[u8]) -> Vec<(u8, f64)> {
    let mut out = Vec::new();
    let (mut at, mut depth) = (0, 0_u32);
    while let Some(&b) = line.get(at) {
        at += 1;
        match b {
            b'(' => depth += 1,
            b')' => depth = depth.saturating_sub(1),
            b';' => break,
            _ if depth > 0 => {}
            _ if b.is_ascii_alphabetic() => {
                let alone = at < 2 || !line[at - 2].is_ascii_alphabetic();
                let letter = b.to_ascii_uppercase();
                if !(alone && matches!(letter, b'M' | b'S' | b'T')) {
                    continue;
                }
                let rest = &line[at..];
                let skip = usize::from(rest.first() == Some(&b'='));
                if let Some((value, len)) = aptc_cldata::number::parse_head(&rest[skip..]) {
                    out.push((letter, value));
                    at += skip + len;
                }
            }
            _ => {}
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine;
    use aptc_cldata::diff;

    fn reader<'a>(text: &'a str, name: &str) -> NcReader<&'a [u8]> {
        NcReader::new(machine(name).unwrap(), text.as_bytes())
    }

    #[test]
    fn codes_outside_of_comments() {
        let found = codes(b"N10 T3 M6 (T4 M7) S=1200 G1 X5 MSG ; M30");
        assert_eq!(found, [(b'T', 3.0), (b'M', 6.0), (b'S', 1200.0)]);
    }

    #[test]
    fn texts_that_do_the_same_are_the_same() {
        let absolute = "G21 G90 G17\nT1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X10 F300\n\
                        G3 X20 Y10 I0 J10\nG0 Z5\nM30\n";
        let other = "G21 G90 G17\nT1 M6\nM3 S1000\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X4 F300\nX10\n\
                     G3 X17.0710678 Y2.9289322 I0 J10\nX20 Y10 I-7.0710678 J7.0710678\nG0 Z5\nM30\n";
        let compare = |a: &str, b: &str| {
            let name = "linuxcnc-mill";
            diff::diff(&mut reader(a, name), &mut reader(b, name), 1e-3).unwrap()
        };
        let d = compare(absolute, absolute);
        assert!(d.is_same() && d.points[0] == 5, "{}", d.text());
        let d = compare(absolute, other);
        assert!(d.first.is_none(), "{}", d.text());
        // The order of M3 and S is another.
        assert_eq!(d.n_word_differences, 2);
        let d = compare(absolute, &absolute.replace("X10 F300", "X11 F300"));
        assert_eq!(d.first.unwrap().other_line, 6);
        let feed = compare(absolute, &absolute.replace("F300", "F400"));
        assert!(feed.first.is_none() && feed.n_word_differences == 1);
    }

    #[test]
    fn what_the_control_refuses_is_told_with_its_line() {
        let mut r = reader("G21 G90\nG1 X1 X2\nG0 Z1\n", "linuxcnc-mill");
        let mut record = Record::default();
        while r.read(&mut record).unwrap() {}
        let said = r.into_diagnostics();
        assert!(said[0].message.starts_with("line 2:"), "{said:?}");
    }
}
