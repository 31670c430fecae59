//! Two CL streams compared as what they are: ways of a tool, and words to a post-processor.
//!
//! Both ways are walked together, each step on the one that then is nearer to the other. Between two
//! stations both go straight, so their distance is greatest at a station: what the walk finds is a bound
//! that the distance of the two ways, run along without going back, does not exceed. Different chords of
//! the same curve therefore compare equal within a tolerance. Memory does not grow with the streams.

mod words;

use std::collections::VecDeque;
use std::fmt::Write;
use std::io;

use aptc_geometry::{Vec3, trig};
use serde::Serialize;

use crate::{Kind, Position, Record, RecordReader, Units, flatten};

pub use words::WordDifference;
use words::{Posts, Value, Words, values};

/// What two streams have not in common.
#[derive(Debug, Serialize)]
pub struct Difference {
    /// Allowed distance, in the unit of the first stream.
    pub tolerance: f64,
    /// Unit of the lengths here.
    pub units: Units,
    /// Where the ways first are farther apart than the tolerance.
    pub first: Option<Deviation>,
    /// Where they are farthest apart.
    pub greatest: Option<Deviation>,
    /// Where the tool axes differ most.
    pub greatest_axis: Option<Deviation>,
    /// Length of the first and of the second way.
    pub lengths: [f64; 2],
    /// Positions of the first and of the second stream.
    pub points: [u64; 2],
    /// Post-processor words of the first and of the second stream.
    pub words: [u64; 2],
    /// The first words that differ, in order.
    pub word_differences: Vec<WordDifference>,
    /// How many words differ.
    pub n_word_differences: u64,
}

/// A place where the ways are apart.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Deviation {
    /// Distance, for an axis degrees.
    pub distance: f64,
    /// Place on the first way.
    pub at: [f64; 3],
    /// Place on the second way.
    pub other: [f64; 3],
    /// Line of the motion in the first stream.
    pub line: u32,
    /// Line of the motion in the second stream.
    pub other_line: u32,
}

impl Difference {
    /// Are the ways within the tolerance and the words the same?
    pub fn is_same(&self) -> bool {
        self.first.is_none() && self.n_word_differences == 0 && !self.axes_differ()
    }

    /// Axes more than a tenth of a degree apart are different motion.
    fn axes_differ(&self) -> bool {
        self.greatest_axis.is_some_and(|a| a.distance > 0.1)
    }

    /// The comparison for people.
    pub fn text(&self) -> String {
        let mut out = String::new();
        let unit = self.units.word().to_lowercase();
        let place = |d: &Deviation| {
            format!(
                "at ({}), line {}; there ({}), line {}",
                d.at.map(|x| format!("{x:.4}")).join(", "),
                d.line,
                d.other.map(|x| format!("{x:.4}")).join(", "),
                d.other_line
            )
        };
        match &self.first {
            Some(d) if d.distance > 1e300 => {
                let _ = writeln!(out, "one of the streams has no motion");
                return out;
            }
            Some(d) => {
                let _ = writeln!(out, "first divergence: {:.6} {unit} {}", d.distance, place(d));
            }
            None => {
                let _ = writeln!(out, "the ways agree within {} {unit}", self.tolerance);
            }
        }
        if let Some(d) = &self.greatest {
            let _ = writeln!(out, "greatest deviation: {:.6} {unit} {}", d.distance, place(d));
        }
        if let Some(d) = self.greatest_axis.filter(|d| d.distance > 1e-6) {
            let _ =
                writeln!(out, "greatest axis deviation: {:.6} degrees {}", d.distance, place(&d));
        }
        let [a, b] = self.lengths;
        let [p, q] = self.points;
        let _ = writeln!(out, "length: {a:.4} and {b:.4} {unit}; positions: {p} and {q}");
        if self.n_word_differences == 0 {
            let _ = writeln!(out, "post-processor words agree: {}", self.words[0]);
        }
        for w in &self.word_differences {
            let show = |s: &str, line: u32| match s {
                "" => "nothing".to_owned(),
                s => format!("{s} (line {line})"),
            };
            let (a, b) = (show(&w.first, w.first_line), show(&w.second, w.second_line));
            let _ = writeln!(out, "post-processor word {}: {a}; there {b}", w.number);
        }
        let listed = self.word_differences.len() as u64;
        if self.n_word_differences > listed {
            let _ = writeln!(out, "and {} more", self.n_word_differences - listed);
        }
        out
    }
}

/// Compares two streams within `tolerance` in the unit of the first.
pub fn diff(
    a: &mut dyn RecordReader,
    b: &mut dyn RecordReader,
    tolerance: f64,
) -> io::Result<Difference> {
    let (mut a, mut b) = (Way::new(a), Way::new(b));
    let first = (a.next_station()?, b.next_station()?);
    let units = a.units;
    let mut walk = Walk { scale: units.mm(), tolerance, ..Walk::default() };
    let mut words = Words::default();
    match first {
        (Some(p), Some(q)) => walk.run(&mut a, &mut b, p, q, &mut words)?,
        (None, None) => {}
        (Some(p), None) => walk.alone(p, false),
        (None, Some(q)) => walk.alone(q, true),
    }
    for way in [&mut a, &mut b] {
        while way.next_station()?.is_some() {}
    }
    words.compare(&mut a.posts, &mut b.posts);
    words.rest(&mut a.posts, &mut b.posts);
    Ok(Difference {
        tolerance,
        units,
        first: walk.first,
        greatest: walk.greatest,
        greatest_axis: walk.greatest_axis,
        lengths: [a.length / units.mm(), b.length / units.mm()],
        points: [a.n_points, b.n_points],
        words: [a.n_posts, b.n_posts],
        word_differences: words.list,
        n_word_differences: words.n,
    })
}

/// A station: position in millimetres, line.
#[derive(Clone, Copy, Debug)]
struct Station {
    p: Position,
    line: u32,
}

/// A stream as stations and post-processor words.
struct Way<'a> {
    reader: &'a mut dyn RecordReader,
    record: Record,
    ready: VecDeque<Station>,
    posts: Posts,
    last: Option<Position>,
    units: Units,
    length: f64,
    n_points: u64,
    n_posts: u64,
}

impl<'a> Way<'a> {
    fn new(reader: &'a mut dyn RecordReader) -> Self {
        Self {
            reader,
            record: Record::default(),
            ready: VecDeque::new(),
            posts: VecDeque::new(),
            last: None,
            units: Units::Inches,
            length: 0.0,
            n_points: 0,
            n_posts: 0,
        }
    }

    fn next_station(&mut self) -> io::Result<Option<Station>> {
        while self.ready.is_empty() {
            if !self.reader.read(&mut self.record)? {
                return Ok(None);
            }
            self.take();
        }
        let station = self.ready.pop_front();
        Ok(station)
    }

    fn take(&mut self) {
        let line = self.record.origin.line;
        match &self.record.kind {
            Kind::Units(u) => self.units = *u,
            Kind::Post { word, args } => {
                self.n_posts += 1;
                let values = args.iter().flat_map(values).collect();
                self.posts.push_back((word.to_string(), values, line));
            }
            Kind::Text { word, text } if matches!(word.as_str(), "PPRINT" | "INSERT") => {
                self.n_posts += 1;
                let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
                self.posts.push_back((word.to_string(), vec![Value::Text(text)], line));
            }
            Kind::Motion(m) => {
                self.n_points += m.points.len() as u64;
                let radius = m.arc.map_or(1.0, |a| a.circle.radius);
                let mm = self.units.mm();
                // A thousandth of a thousandth of the radius: less than any tolerance asks for.
                for p in flatten::positions(m, self.last, 1e-6 * radius) {
                    if let Some(last) = self.last {
                        self.length += (p.te - last.te).norm() * mm;
                    }
                    self.last = Some(p);
                    let p = Position { te: p.te * mm, ta: p.ta };
                    self.ready.push_back(Station { p, line });
                }
            }
            _ => {}
        }
    }
}

/// What the walk finds.
#[derive(Default)]
struct Walk {
    scale: f64,
    tolerance: f64,
    first: Option<Deviation>,
    greatest: Option<Deviation>,
    greatest_axis: Option<Deviation>,
}

impl Walk {
    /// Walks both ways; `p` and `q` are their first stations.
    fn run(
        &mut self,
        a: &mut Way<'_>,
        b: &mut Way<'_>,
        p: Station,
        q: Station,
        words: &mut Words,
    ) -> io::Result<()> {
        let (mut p, mut q) = (p, q);
        self.meet(p, q);
        let (mut pn, mut qn) = (a.next_station()?, b.next_station()?);
        loop {
            words.compare(&mut a.posts, &mut b.posts);
            match (pn, qn) {
                (None, None) => return Ok(()),
                // One is at its end: the other goes on alone.
                (Some(next), None) => {
                    p = next;
                    pn = a.next_station()?;
                }
                (None, Some(next)) => {
                    q = next;
                    qn = b.next_station()?;
                }
                (Some(x), Some(y)) => {
                    // Go to the next station of the one way and the nearest place ahead on the other;
                    // of the two ways to do so, the one that keeps them closer.
                    let on_b = nearest(x.p.te, q, y);
                    let on_a = nearest(y.p.te, p, x);
                    let (db, da) = ((on_b.p.te - x.p.te).norm(), (on_a.p.te - y.p.te).norm());
                    let both = (x.p.te - y.p.te).norm();
                    if both <= db.min(da) {
                        (p, q) = (x, y);
                        (pn, qn) = (a.next_station()?, b.next_station()?);
                    } else if db <= da {
                        (p, q) = (x, on_b);
                        pn = a.next_station()?;
                    } else {
                        (p, q) = (on_a, y);
                        qn = b.next_station()?;
                    }
                }
            }
            self.meet(p, q);
        }
    }

    fn meet(&mut self, p: Station, q: Station) {
        let distance = (p.p.te - q.p.te).norm() / self.scale;
        let place = |v: Vec3| [v.x / self.scale, v.y / self.scale, v.z / self.scale];
        let d = Deviation {
            distance,
            at: place(p.p.te),
            other: place(q.p.te),
            line: p.line,
            other_line: q.line,
        };
        if self.first.is_none() && distance > self.tolerance {
            self.first = Some(d);
        }
        if self.greatest.is_none_or(|g| distance > g.distance) {
            self.greatest = Some(d);
        }
        let angle = trig::angle_between(p.p.ta, q.p.ta).to_degrees();
        if self.greatest_axis.is_none_or(|g| angle > g.distance) {
            self.greatest_axis = Some(Deviation { distance: angle, ..d });
        }
    }

    /// One stream has no motion at all.
    fn alone(&mut self, s: Station, second: bool) {
        let at = [s.p.te.x, s.p.te.y, s.p.te.z].map(|x| x / self.scale);
        let (line, other_line) = if second { (0, s.line) } else { (s.line, 0) };
        let d = Deviation { distance: f64::MAX, at, other: at, line, other_line };
        self.first = Some(d);
        self.greatest = Some(d);
    }
}

/// The place nearest to `v` between two stations of a way.
fn nearest(v: Vec3, from: Station, to: Station) -> Station {
    let u = to.p.te - from.p.te;
    let square = u.norm_squared();
    let t = if square > 0.0 { ((v - from.p.te).dot(&u) / square).clamp(0.0, 1.0) } else { 1.0 };
    let ta = from.p.ta + (to.p.ta - from.p.ta) * t;
    let ta = ta.try_normalize(0.0).unwrap_or(to.p.ta);
    Station { p: Position { te: from.p.te + u * t, ta }, line: to.line }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Dialect, TextReader};
    use aptc_diagnostics::FileId;

    fn compare(a: &str, b: &str, tolerance: f64) -> Difference {
        let reader = |t| TextReader::new(t, Dialect::Iso, FileId(0));
        diff(&mut reader(a.as_bytes()), &mut reader(b.as_bytes()), tolerance).unwrap()
    }

    /// A circle in n chords of the circle of radius 10 about (0, 0).
    fn circle(n: u32, radius: f64) -> String {
        let mut text = String::from("UNITS/MM\nGOTO/10,0,0\n");
        for i in 1..n {
            let (s, c) = trig::sin_cos(f64::from(i) / f64::from(n) * std::f64::consts::TAU);
            text.push_str(&format!("GOTO/{},{},0\n", radius * c, radius * s));
        }
        text + "GOTO/10,0,0\nFINI\n"
    }

    #[test]
    fn chords_and_arcs_of_one_circle_are_the_same_way() {
        let arc = "UNITS/MM\nGOTO/10,0,0\nMOVARC/0,0,0,0,0,1,10,ANGLE,360\nGOTO/10,0,0\nFINI\n";
        let sagitta = |n: f64| 10.0 * (1.0 - trig::cos(std::f64::consts::PI / n));
        for n in [24, 100] {
            let d = compare(arc, &circle(n, 10.0), 1.001 * sagitta(f64::from(n)));
            assert!(d.is_same(), "{}", d.text());
            assert!(!compare(arc, &circle(n, 10.0), 0.5 * sagitta(f64::from(n))).is_same());
        }
        let d = compare(&circle(24, 10.0), &circle(37, 10.0), 0.12);
        assert!(d.is_same(), "{}", d.text());
    }

    #[test]
    fn units_do_not_matter_but_places_do() {
        let mm = "UNITS/MM\nGOTO/0,0,0\nGOTO/25.4,0,0\nGOTO/25.4,25.4,0\nFINI\n";
        let inch = "UNITS/INCHES\nGOTO/0,0,0\nGOTO/1,0,0\nGOTO/1,1,0\nFINI\n";
        assert!(compare(mm, inch, 1e-9).is_same());
        let moved = "UNITS/INCHES\nGOTO/0,0,0\nGOTO/1,0,0\nGOTO/1,1.5,0\nFINI\n";
        let d = compare(inch, moved, 1e-3);
        let first = d.first.unwrap();
        assert!((first.distance - 0.5).abs() < 1e-9 && first.line == 4 && first.other_line == 4);
        assert!((d.lengths[1] - 2.5).abs() < 1e-9);
        // The same places in another order are another way.
        let back = "UNITS/INCHES\nGOTO/1,1,0\nGOTO/1,0,0\nGOTO/0,0,0\nFINI\n";
        assert!(!compare(inch, back, 0.01).is_same());
    }

    #[test]
    fn words_are_compared_in_order() {
        let a = "UNITS/MM\nSPINDL/1000,CLW\nGOTO/0,0,0\nCOOLNT/ON\nFINI\n";
        let b = "UNITS/MM\nSPINDL/1000,CCLW\nGOTO/0,0,0\nFINI\n";
        let d = compare(a, b, 0.1);
        assert!(d.first.is_none() && d.n_word_differences == 2);
        assert_eq!(d.word_differences[0].second, "SPINDL/1000,CCLW");
        assert_eq!(d.word_differences[1].second, "");
        assert!(compare(a, a, 0.0).is_same());
    }
}
