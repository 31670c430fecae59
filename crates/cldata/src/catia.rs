//! CATIA aptsource, as other systems read it.
//!
//! Arcs are motion along a circle to a line through its end (`INDIRV/`, `TLON,GOFWD/(CIRCLE/..),ON,..`),
//! about other axes than z along a CYLNDR to a plane; helices and more than one turn are `HELICAL/`
//! statements. A frame is the matrix of a `$$*CATIA0` comment. No line is longer than 72 characters but
//! for texts.

use std::fmt::Write as _;
use std::io::{self, Write};

use aptc_geometry::{Circle, Transform, Vec3};

use crate::number::{self, Decimals};
use crate::read::sweep;
use crate::{
    Arc, Course, Kind, Motion, MotionKind, Position, Record, RecordWriter, TextOptions, TextWriter,
};

/// Longest line.
const COLUMNS: usize = 72;

/// Writes CATIA aptsource.
pub struct CatiaWriter<W> {
    text: TextWriter<W>,
    decimals: Decimals,
    last: Option<Position>,
    begun: bool,
}

impl<W: Write> CatiaWriter<W> {
    /// A writer onto `out`, which need not be buffered.
    pub fn new(out: W, decimals: Decimals) -> Self {
        let options = TextOptions { decimals, marks: false, ..TextOptions::default() };
        let text = TextWriter::new(out, options);
        Self { text, decimals, last: None, begun: false }
    }

    /// Ends the file and gives back what was written onto.
    pub fn into_inner(self) -> io::Result<W> {
        self.text.into_inner()
    }

    fn number(&self, x: f64) -> String {
        let mut out = Vec::new();
        number::put(&mut out, x, self.decimals);
        String::from_utf8(out).expect("digits")
    }

    fn numbers(&self, values: &[f64]) -> Vec<String> {
        values.iter().map(|x| self.number(*x)).collect()
    }

    fn vectors(&self, vectors: &[Vec3]) -> Vec<String> {
        vectors.iter().flat_map(|v| self.numbers(&[v.x, v.y, v.z])).collect()
    }

    /// A statement of fields, cut into lines behind commas.
    fn statement(&mut self, head: &str, fields: &[String]) {
        let mut line = head.to_owned();
        for (i, field) in fields.iter().enumerate() {
            let last = i + 1 == fields.len();
            // Room for the comma and the mark of continuation.
            if line.len() + field.len() + 2 > COLUMNS && line.trim() != "" {
                line.push_str("$\n");
                self.text.raw(&line);
                line = " ".repeat(6);
            }
            line.push_str(field);
            if !last {
                line.push(',');
            }
        }
        line.push('\n');
        self.text.raw(&line);
    }

    fn comment(&mut self, text: &str) {
        self.text.raw(&format!("$$ {text}\n"));
    }

    fn frame(&mut self, name: &str, frame: &Transform) {
        self.text.raw("$$*CATIA0\n");
        self.comment(name);
        for row in frame.rows().chunks(4) {
            let mut line = String::new();
            for x in row {
                let _ = write!(line, " {:>11}", self.number(*x));
            }
            self.comment(&line);
        }
    }

    fn head(&mut self) {
        let rule = "-".repeat(65);
        for line in [rule.as_str(), "    CATIA APT VERSION 1.0", rule.as_str()] {
            self.comment(line);
        }
    }

    fn motion(&mut self, m: &Motion) {
        if let (Some(arc), Some(last), Some(end)) = (&m.arc, self.last, m.points.last())
            && self.arc(arc, last, m)
        {
            self.last = Some(*end);
            return;
        }
        let head = if m.kind == MotionKind::From { "FROM  / " } else { "GOTO  / " };
        for p in &m.points {
            let fields =
                if m.with_axis { self.vectors(&[p.te, p.ta]) } else { self.vectors(&[p.te]) };
            self.statement(head, &fields);
        }
        self.last = m.points.last().copied().or(self.last);
    }

    /// Writes the motion as an arc; false when it is none that aptsource can say.
    fn arc(&mut self, arc: &Arc, start: Position, m: &Motion) -> bool {
        let Some((circle, angle)) = course(arc, start, m) else { return false };
        let Some(end) = m.points.last().copied() else { return false };
        let tilted = |p: &Position| (p.ta - start.ta).norm() > 1e-9;
        if m.points.iter().any(tilted) {
            return false;
        }
        let Circle { center, axis, radius } = circle;
        let arm = start.te - center;
        let Some(tangent) = axis.cross(&arm).try_normalize(0.0) else { return false };
        let rise = axis.dot(&(end.te - start.te)).abs();
        if rise > 1e-9 * radius || angle > 360.0 + 1e-9 {
            let mut fields = self.vectors(&[center, tangent, axis]);
            fields.extend(self.numbers(&[angle, radius]));
            fields.extend(self.vectors(&[end.te]));
            self.statement("HELICAL/ ", &fields);
            return true;
        }
        let fields = self.vectors(&[tangent]);
        self.statement("INDIRV/ ", &fields);
        let level = axis.x.abs() <= 0.0 && axis.y.abs() <= 0.0;
        let mut fields = if level {
            let mut f = self.vectors(&[center]);
            f[0] = format!("(CIRCLE/ {}", f[0]);
            f
        } else {
            let mut f = self.vectors(&[center, axis]);
            f[0] = format!("(CYLNDR/CANON,{}", f[0]);
            f
        };
        fields.push(format!("{})", self.number(radius)));
        fields.push("ON".into());
        // The line of the end crosses the circle twice; beyond half a turn the other place comes first.
        if angle > 180.0 + 1e-6 {
            fields.extend(["2".into(), "INTOF".into()]);
        }
        if level {
            let mut line = self.vectors(&[center, end.te]);
            line[0] = format!("(LINE/ {}", line[0]);
            line[5].push(')');
            fields.extend(line);
        } else {
            // The plane through the axis and the end.
            let arm = end.te - center;
            let Some(n) = axis.cross(&arm).try_normalize(0.0) else { return false };
            let mut plane = self.vectors(&[n]);
            plane.push(self.number(n.dot(&center)));
            plane[0] = format!("(PLANE/ {}", plane[0]);
            plane[3].push(')');
            fields.extend(plane);
        }
        self.statement("TLON,GOFWD/ ", &fields);
        true
    }
}

/// The circle, its axis right-handed about the motion, and the angle.
fn course(arc: &Arc, start: Position, m: &Motion) -> Option<(Circle, f64)> {
    let circle = arc.circle;
    match arc.course {
        Course::Sweep(angle) if angle < 0.0 => {
            Some((Circle { axis: -circle.axis, ..circle }, -angle))
        }
        Course::Sweep(angle) => Some((circle, angle)),
        Course::Chords => {
            // Chords are short: each goes the shorter way round.
            let mut total = 0.0;
            let mut last = start.te;
            for p in &m.points {
                let step = sweep(circle.center, circle.axis, last, p.te);
                total += if step > 180.0 { step - 360.0 } else { step };
                last = p.te;
            }
            let axis = if total < 0.0 { -circle.axis } else { circle.axis };
            let off = |p: Vec3| {
                let arm = p - circle.center;
                ((arm - axis * axis.dot(&arm)).norm() - circle.radius).abs()
            };
            // Both ends must be on the circle, or the arc would miss them.
            let slack = 1e-6 * circle.radius;
            let good = off(start.te) <= slack && off(last) <= slack && total.abs() > 1e-6;
            good.then_some((Circle { axis, ..circle }, total.abs()))
        }
    }
}

impl<W: Write> RecordWriter for CatiaWriter<W> {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        if !self.begun {
            self.begun = true;
            self.head();
        }
        match &record.kind {
            Kind::Motion(m) => {
                self.text.settle_units(&record.kind);
                self.motion(m);
                self.text.pass_on()
            }
            Kind::Cutter(c) => {
                self.text.settle_units(&record.kind);
                let fields = self.numbers(&c.values());
                self.statement("CUTTER/ ", &fields);
                Ok(())
            }
            Kind::Csys(frame) => {
                self.frame("frame", frame);
                Ok(())
            }
            Kind::Fini => {
                self.last = None;
                self.text.write(record)
            }
            _ => self.text.write(record),
        }
    }

    fn finish(&mut self) -> io::Result<()> {
        self.text.finish()
    }
}
