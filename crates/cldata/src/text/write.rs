//! The writer.

use std::io::{self, Write};
use std::sync::Arc as Shared;

use aptc_diagnostics::Origin;
use aptc_geometry::{Transform, Vec3};

use super::{is_reserved, kind_word};
use crate::number::{self, Decimals};
use crate::{
    Arc, Arg, Clprnt, Course, Edit, Kind, Motion, MotionKind, NameRef, Output, Record,
    RecordWriter, Units,
};

/// Bytes kept before they are handed on.
const BUFFER: usize = 128 * 1024;

/// How the text is written.
#[derive(Clone, Copy, Debug)]
pub struct TextOptions {
    /// Decimals of all numbers.
    pub decimals: Decimals,
    /// Write `$$ LINE` and `$$ PATH`, which tell where each record comes from.
    pub marks: bool,
    /// Unit of the lengths before a UNITS record, when there are such.
    pub units: Units,
}

impl Default for TextOptions {
    fn default() -> Self {
        Self { decimals: Decimals::Shortest, marks: true, units: Units::Inches }
    }
}

/// Writes CL text after ISO 4343.
pub struct TextWriter<W> {
    out: W,
    buf: Vec<u8>,
    options: TextOptions,
    /// Where UNITS goes as long as it has not been stated.
    units_at: Option<usize>,
    /// Has anything been written since the beginning or the last FINI?
    begun: bool,
    /// Line and file of the last mark.
    mark: (u32, Option<Shared<str>>),
}

impl<W: Write> TextWriter<W> {
    /// A writer onto `out`, which need not be buffered.
    pub fn new(out: W, options: TextOptions) -> Self {
        let buf = Vec::with_capacity(BUFFER + 4096);
        Self { out, buf, options, units_at: Some(0), begun: false, mark: (0, None) }
    }

    /// Ends the file and gives back what was written onto.
    pub fn into_inner(mut self) -> io::Result<W> {
        self.finish()?;
        Ok(self.out)
    }

    /// Appends lines that were made elsewhere.
    pub(crate) fn raw(&mut self, lines: &str) {
        self.begun = true;
        self.text(lines);
    }

    /// Hands on what has come together, if it is much.
    pub(crate) fn pass_on(&mut self) -> io::Result<()> {
        if self.buf.len() > BUFFER && self.units_at.is_none() { self.hand_on() } else { Ok(()) }
    }

    fn hand_on(&mut self) -> io::Result<()> {
        self.out.write_all(&self.buf)?;
        self.buf.clear();
        Ok(())
    }

    fn number(&mut self, x: f64) {
        number::put(&mut self.buf, x, self.options.decimals);
    }

    fn text(&mut self, text: &str) {
        self.buf.extend_from_slice(text.as_bytes());
    }

    /// Text that must stay on its line.
    fn line_text(&mut self, text: &str) {
        self.buf.extend(text.bytes().map(|b| if b == b'\n' || b == b'\r' { b' ' } else { b }));
    }

    fn end_line(&mut self) {
        self.buf.push(b'\n');
    }

    fn numbers(&mut self, values: &[f64]) {
        for (i, x) in values.iter().enumerate() {
            if i > 0 {
                self.buf.push(b',');
            }
            self.number(*x);
        }
    }

    fn vector(&mut self, v: Vec3) {
        self.numbers(&[v.x, v.y, v.z]);
    }

    fn statement(&mut self, word: &str, values: &[f64]) {
        self.text(word);
        self.buf.push(b'/');
        self.numbers(values);
        self.end_line();
    }

    /// States the unit, after PARTNO if that came.
    fn state_units(&mut self, units: Units) {
        let Some(at) = self.units_at.take() else {
            self.text("UNITS/");
            self.text(units.word());
            self.end_line();
            return;
        };
        let line = format!("UNITS/{}\n", units.word());
        self.buf.splice(at..at, line.into_bytes());
    }

    fn put_mark(&mut self, origin: &Origin, always: bool) {
        if !self.options.marks || origin.line == 0 {
            return;
        }
        if !always && self.mark.0 == origin.line && self.mark.1 == origin.file {
            return;
        }
        self.text("$$ LINE ");
        self.number(f64::from(origin.line));
        if let Some(file) = &origin.file {
            self.text(" FILE ");
            self.line_text(file);
        }
        self.end_line();
        if self.mark.1 != origin.file {
            self.mark.1.clone_from(&origin.file);
        }
        self.mark.0 = origin.line;
    }

    fn motion(&mut self, motion: &Motion) {
        let plain = match motion.kind {
            MotionKind::From | MotionKind::Goto => motion.name.name.is_empty(),
            MotionKind::Startup | MotionKind::Continuous => false,
        };
        if self.options.marks && !plain {
            self.text("$$ PATH ");
            self.text(kind_word(motion.kind));
            self.name(&motion.name);
            self.end_line();
        }
        if let Some(arc) = &motion.arc {
            self.arc(arc);
        }
        let word = if motion.kind == MotionKind::From { "FROM/" } else { "GOTO/" };
        for p in &motion.points {
            self.text(word);
            self.vector(p.te);
            if motion.with_axis {
                self.buf.push(b',');
                self.vector(p.ta);
            }
            self.end_line();
        }
    }

    fn name(&mut self, name: &NameRef) {
        if name.name.is_empty() {
            return;
        }
        self.buf.push(b' ');
        self.text(&name.name);
        if name.subscript > 0 {
            self.buf.push(b'(');
            self.number(f64::from(name.subscript));
            self.buf.push(b')');
        }
    }

    fn arc(&mut self, arc: &Arc) {
        let c = &arc.circle;
        let (word, axis) = match arc.course {
            Course::Chords => ("$$ CIRCLE ", c.axis),
            Course::Sweep(angle) if angle < 0.0 => ("MOVARC/", -c.axis),
            Course::Sweep(_) => ("MOVARC/", c.axis),
        };
        self.text(word);
        self.numbers(&[c.center.x, c.center.y, c.center.z, axis.x, axis.y, axis.z, c.radius]);
        if let Course::Sweep(angle) = arc.course {
            self.text(",ANGLE,");
            self.number(angle.abs());
        }
        self.end_line();
    }

    fn post(&mut self, word: &str, args: &[Arg]) {
        if args.iter().any(|a| matches!(a, Arg::Form { .. })) {
            self.text("$$ GEOMETRY");
            for (i, arg) in args.iter().enumerate() {
                let Arg::Form { form, .. } = arg else { continue };
                self.buf.push(b' ');
                self.number(i as f64 + 1.0);
                self.buf.push(b' ');
                self.text(form.kind().word());
                self.buf.push(b' ');
                self.number(form.canonical().len() as f64);
            }
            self.end_line();
        }
        self.text(word);
        for (i, arg) in args.iter().enumerate() {
            self.buf.push(if i == 0 { b'/' } else { b',' });
            match arg {
                Arg::Number(x) => self.number(*x),
                Arg::Word(w) => self.text(w),
                Arg::Text(t) => self.quoted(t),
                Arg::Form { name, form } => {
                    self.text(if name.name.is_empty() { "0" } else { &name.name });
                    self.buf.push(b',');
                    self.number(f64::from(name.subscript));
                    for x in form.canonical() {
                        self.buf.push(b',');
                        self.number(x);
                    }
                }
            }
        }
        self.end_line();
    }

    fn quoted(&mut self, text: &str) {
        self.buf.push(b'\'');
        for b in text.bytes() {
            match b {
                b'\'' => self.text("''"),
                b'\n' | b'\r' => self.buf.push(b' '),
                _ => self.buf.push(b),
            }
        }
        self.buf.push(b'\'');
    }

    /// PARTNO and its kind: the text after a blank. A text that begins with a slash gets one more, which
    /// readers take for the statement's.
    fn fixed_field(&mut self, word: &str, text: &str) {
        self.text(word);
        if !text.is_empty() {
            self.buf.push(b' ');
            if text.starts_with('/') {
                self.buf.push(b'/');
            }
            self.line_text(text);
        }
        self.end_line();
    }

    fn edit(&mut self, edit: &Edit) {
        match edit {
            Edit::Index { n, close } => {
                self.text("INDEX/");
                self.number(*n);
                if *close {
                    self.text(",NOMORE");
                }
            }
            Edit::Copy { n, step, count } => {
                self.text("COPY/");
                self.number(*n);
                self.step(step);
                self.buf.push(b',');
                self.number(f64::from(*count));
            }
            Edit::Tracut(None) => self.text("TRACUT/NOMORE"),
            Edit::Tracut(Some(m)) => {
                self.text("TRACUT/0,0,");
                self.numbers(&m.rows());
            }
        }
        self.end_line();
    }

    fn step(&mut self, step: &Transform) {
        let identity = Transform::identity();
        if *step == identity {
            self.text(",SAME");
        } else if step.linear == identity.linear {
            self.text(",TRANSL,");
            self.vector(step.shift);
        } else {
            self.text(",MODIFY,0,0,");
            self.numbers(&step.rows());
        }
    }

    /// Before the first length, UNITS must stand there.
    pub(crate) fn settle_units(&mut self, kind: &Kind) {
        if self.units_at.is_some() && (kind.has_lengths() || self.buf.len() > BUFFER / 2) {
            self.state_units(self.options.units);
        }
    }
}

impl<W: Write> RecordWriter for TextWriter<W> {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        let head = self.units_at.is_some();
        self.settle_units(&record.kind);
        self.begun = !matches!(record.kind, Kind::Fini);
        match &record.kind {
            Kind::Units(u) => {
                if !head {
                    self.put_mark(&record.origin, false);
                }
                self.state_units(*u);
            }
            Kind::Text { word, text } if head && word == "PARTNO" => {
                self.fixed_field(word, text);
                self.units_at = Some(self.buf.len());
            }
            kind => {
                self.put_mark(&record.origin, matches!(kind, Kind::Motion(_)));
                self.body(kind);
            }
        }
        if matches!(record.kind, Kind::Fini) {
            self.hand_on()?;
            self.units_at = Some(0);
        } else if self.buf.len() > BUFFER && self.units_at.is_none() {
            self.hand_on()?;
        }
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        if self.units_at.is_some() && self.begun {
            self.state_units(self.options.units);
        }
        self.hand_on()?;
        self.out.flush()
    }
}

impl<W: Write> TextWriter<W> {
    fn body(&mut self, kind: &Kind) {
        match kind {
            Kind::Text { word, text } => self.fixed_field(word, text),
            Kind::Post { word, args } => self.post(word, args),
            Kind::Units(u) => self.state_units(*u),
            Kind::Multax(on) => self.text(if *on { "MULTAX/ON\n" } else { "MULTAX/OFF\n" }),
            Kind::Cutter(c) => self.statement("CUTTER", &c.values()),
            Kind::Intol(t) => self.statement("INTOL", t),
            Kind::Outtol(t) => self.statement("OUTTOL", t),
            Kind::Motion(m) => self.motion(m),
            Kind::Output(Output::Cut) => self.text("CUT\n"),
            Kind::Output(Output::Dntcut) => self.text("DNTCUT\n"),
            Kind::Edit(e) => self.edit(e),
            Kind::Csys(m) => self.statement("CSYS", &m.rows()),
            Kind::Clprnt(what) => self.text(match what {
                Clprnt::Whole => "CLPRNT\n",
                Clprnt::On => "CLPRNT/ON\n",
                Clprnt::Off => "CLPRNT/OFF\n",
                Clprnt::Option => "CLPRNT/OPTION\n",
            }),
            Kind::Comment(text) => {
                self.text(if is_reserved(text) { "$$." } else { "$$" });
                self.line_text(text);
                self.end_line();
            }
            Kind::Unread(text) => {
                self.line_text(text);
                self.end_line();
            }
            Kind::Fini => self.text("FINI\n"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Position;
    use aptc_geometry::{Circle, Cutter, Form, Plane};

    fn lines(kinds: Vec<(u32, Kind)>) -> String {
        let mut w = TextWriter::new(Vec::new(), TextOptions::default());
        for (line, kind) in kinds {
            w.write(&Record { origin: Origin { line, ..Origin::default() }, kind }).unwrap();
        }
        String::from_utf8(w.into_inner().unwrap()).unwrap()
    }

    fn post(word: &str, args: Vec<Arg>) -> Kind {
        Kind::Post { word: word.into(), args }
    }

    #[test]
    fn a_small_program() {
        let part = Kind::Text { word: "PARTNO".into(), text: "BLOCK 7".into() };
        let at = |x, y, z| Position::upright(Vec3::new(x, y, z));
        let plane = Form::Plane(Plane::new(Vec3::z(), 0.1).unwrap());
        let circle = Circle { center: Vec3::zeros(), axis: Vec3::z(), radius: 1.0 };
        let text = lines(vec![
            (1, part),
            (2, post("MACHIN", vec![Arg::Word("PMILL".into()), Arg::Number(5.0)])),
            (3, Kind::Units(Units::Mm)),
            (4, Kind::Cutter(Cutter::mill(10.0, 0.0, 50.0))),
            (5, post("CLRSRF", vec![Arg::Form { name: NameRef::default(), form: plane.into() }])),
            (6, post("RAPID", vec![])),
            (6, Kind::Motion(Motion { points: vec![at(1.0, -0.0, 0.5)], ..Motion::default() })),
            (
                7,
                Kind::Motion(Motion {
                    kind: MotionKind::Continuous,
                    name: NameRef { name: "C1".into(), subscript: 2 },
                    arc: Some(Arc { circle, course: Course::Chords }),
                    points: vec![at(0.0, 1.0, 0.0), at(-1.0, 0.0, 0.0)],
                    ..Motion::default()
                }),
            ),
            (8, Kind::Comment(" LINE up".into())),
            (8, Kind::Fini),
        ]);
        let expected = "\
PARTNO BLOCK 7
UNITS/MM
$$ LINE 2
MACHIN/PMILL,5
$$ LINE 4
CUTTER/10,0,5,0,0,0,50
$$ LINE 5
$$ GEOMETRY 1 PLANE 4
CLRSRF/0,0,0,0,1,0.1
$$ LINE 6
RAPID
$$ LINE 6
GOTO/1,0,0.5
$$ LINE 7
$$ PATH CONTINUOUS C1(2)
$$ CIRCLE 0,0,0,0,0,1,1
GOTO/0,1,0
GOTO/-1,0,0
$$ LINE 8
$$. LINE up
FINI
";
        assert_eq!(text, expected);
    }

    #[test]
    fn the_unit_is_always_stated() {
        assert_eq!(
            lines(vec![(1, post("SPINDL", vec![Arg::Number(5.0)]))]),
            "UNITS/INCHES\n$$ LINE 1\nSPINDL/5\n"
        );
        let two = lines(vec![(1, Kind::Units(Units::Cm)), (2, Kind::Fini), (1, Kind::Fini)]);
        assert_eq!(two, "UNITS/CM\n$$ LINE 2\nFINI\nUNITS/INCHES\n$$ LINE 1\nFINI\n");
        assert_eq!(lines(vec![]), "");
    }
}
