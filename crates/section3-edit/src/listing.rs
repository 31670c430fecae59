//! CLPRNT: the CL data as a table for people.

use aptc_cldata::number::{self, Decimals};
use aptc_cldata::{Arg, Clprnt, Course, Edit, Kind, MotionKind, NameRef, Output, Position, Record};

/// Prints records where CLPRNT asks for them.
///
/// CLPRNT alone prints the whole program, CLPRNT/ON and OFF parts of it. CLPRNT/OPTION prints a part as it was
/// before transformation: that is the business of a listing of its own, which gets the records before the
/// editor.
#[derive(Default)]
pub struct Listing {
    part: Part,
    on: bool,
    line: u32,
    head: bool,
}

#[derive(Clone, Copy, Default, PartialEq, Eq)]
enum Part {
    #[default]
    On,
    Before,
    Whole,
}

impl Listing {
    /// A listing of edited records from CLPRNT/ON to OFF.
    pub fn parts() -> Self {
        Self::default()
    }

    /// A listing of all edited records: CLPRNT stands somewhere in the program.
    pub fn whole() -> Self {
        Self { part: Part::Whole, on: true, ..Self::default() }
    }

    /// A listing of records before the editor, from CLPRNT/OPTION to OFF.
    pub fn before_editing() -> Self {
        Self { part: Part::Before, ..Self::default() }
    }

    /// Appends what is to be printed of the record.
    pub fn push(&mut self, record: &Record, out: &mut String) {
        if let (Kind::Clprnt(what), Part::On | Part::Before) = (&record.kind, self.part) {
            self.on = match what {
                Clprnt::On => self.part == Part::On,
                Clprnt::Option => self.part == Part::Before,
                Clprnt::Off | Clprnt::Whole => false,
            };
        }
        if !self.on {
            return;
        }
        if !self.head {
            self.head = true;
            out.push_str(&format!(
                "{:>6}  {:<8} {:<10} {:>13} {:>13} {:>13} {:>10} {:>10} {:>10}\n",
                "line", "record", "name", "x", "y", "z", "i", "j", "k"
            ));
        }
        let line = record.origin.line;
        let number = if line == self.line || line == 0 { String::new() } else { line.to_string() };
        self.line = line;
        self.record(&number, &record.kind, out);
    }

    fn record(&self, line: &str, kind: &Kind, out: &mut String) {
        let mut row = |word: &str, rest: &str| {
            out.push_str(format!("{line:>6}  {word:<8} {rest}").trim_end());
            out.push('\n');
        };
        match kind {
            Kind::Text { word, text } => row(word, text),
            Kind::Post { word, args } => row(word, &list(args)),
            Kind::Units(u) => row("UNITS", u.word()),
            Kind::Multax(on) => row("MULTAX", on_off(*on)),
            Kind::Cutter(c) => row("CUTTER", &numbers(&c.values())),
            Kind::Intol(t) => row("INTOL", &numbers(t)),
            Kind::Outtol(t) => row("OUTTOL", &numbers(t)),
            Kind::Output(Output::Cut) => row("CUT", ""),
            Kind::Output(Output::Dntcut) => row("DNTCUT", ""),
            Kind::Clprnt(what) => row(
                "CLPRNT",
                match what {
                    Clprnt::Whole => "",
                    Clprnt::On => "ON",
                    Clprnt::Off => "OFF",
                    Clprnt::Option => "OPTION",
                },
            ),
            Kind::Csys(m) => row("CSYS", &numbers(&m.rows())),
            Kind::Comment(text) => row("$$", text.trim()),
            Kind::Unread(text) => row("?", text),
            Kind::Fini => row("FINI", ""),
            Kind::Edit(Edit::Index { n, close }) => {
                row("INDEX", &format!("{n}{}", if *close { ",NOMORE" } else { "" }));
            }
            Kind::Edit(Edit::Copy { n, step, count }) => {
                row("COPY", &format!("{n},MODIFY,{},{count}", numbers(&step.rows())));
            }
            Kind::Edit(Edit::Tracut(None)) => row("TRACUT", "NOMORE"),
            Kind::Edit(Edit::Tracut(Some(m))) => row("TRACUT", &numbers(&m.rows())),
            Kind::Motion(m) => {
                if let Some(arc) = &m.arc {
                    let c = arc.circle;
                    let v = [
                        c.center.x, c.center.y, c.center.z, c.axis.x, c.axis.y, c.axis.z, c.radius,
                    ];
                    let sweep = match arc.course {
                        Course::Chords => String::new(),
                        Course::Sweep(angle) => format!(" angle {angle:.4}"),
                    };
                    row("CIRCLE", &format!("{}{sweep}", numbers(&v)));
                }
                let word = match m.kind {
                    MotionKind::From => "FROM",
                    MotionKind::Goto => "GOTO",
                    MotionKind::Startup => "GO",
                    MotionKind::Continuous => "CUT VEC",
                };
                let name = name_of(&m.name);
                let mut rows = Vec::new();
                for (i, p) in m.points.iter().enumerate() {
                    match i {
                        0 => rows.extend(format!("{line:>6}  {word:<8} {name:<10} ").bytes()),
                        _ => rows.resize(rows.len() + HEAD, b' '),
                    }
                    position(&mut rows, p, m.with_axis);
                }
                out.push_str(&String::from_utf8_lossy(&rows));
            }
        }
    }
}

/// Columns of line, word and name before a position.
const HEAD: usize = 28;

/// Appends the row of a position: the tool end and, where it is programmed, the tool axis.
fn position(out: &mut Vec<u8>, p: &Position, with_axis: bool) {
    for (i, x) in [p.te.x, p.te.y, p.te.z].into_iter().enumerate() {
        out.resize(out.len() + usize::from(i > 0), b' ');
        number::put_column(out, x, 6, 13);
    }
    if with_axis {
        for x in [p.ta.x, p.ta.y, p.ta.z] {
            out.push(b' ');
            number::put_column(out, x, 6, 10);
        }
    }
    out.push(b'\n');
}

fn on_off(on: bool) -> &'static str {
    if on { "ON" } else { "OFF" }
}

fn name_of(name: &NameRef) -> String {
    if name.subscript > 0 {
        format!("{}({})", name.name, name.subscript)
    } else {
        name.name.to_string()
    }
}

fn put(out: &mut Vec<u8>, x: f64) {
    number::put(out, x, Decimals::Fixed(6));
}

fn numbers(values: &[f64]) -> String {
    let mut out = Vec::new();
    for (i, x) in values.iter().enumerate() {
        if i > 0 {
            out.push(b',');
        }
        put(&mut out, *x);
    }
    String::from_utf8(out).expect("digits")
}

fn list(args: &[Arg]) -> String {
    let parts: Vec<String> = args
        .iter()
        .map(|a| match a {
            Arg::Number(x) => numbers(&[*x]),
            Arg::Word(w) => w.to_string(),
            Arg::Text(t) => format!("'{t}'"),
            Arg::Form { name, form } => {
                let n = if name.name.is_empty() { "0".to_owned() } else { name_of(name) };
                format!("{n} {}({})", form.kind().word(), numbers(&form.canonical()))
            }
        })
        .collect();
    parts.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_cldata::Motion;
    use aptc_geometry::Vec3;

    #[test]
    fn only_what_stands_between_on_and_off() {
        let points = vec![Position::upright(Vec3::new(1.0, -2.5, -0.0))];
        let goto = || Kind::Motion(Motion { points: points.clone(), ..Motion::default() });
        let on = |what| Kind::Clprnt(what);
        let print = |mut listing: Listing, kinds: [Kind; 7]| {
            let mut text = String::new();
            for kind in kinds {
                listing.push(&Record { kind, ..Record::default() }, &mut text);
            }
            text
        };
        let program = || {
            use Clprnt::{Off, On, Option};
            [goto(), on(On), goto(), on(Option), goto(), on(Off), goto()]
        };
        let text = print(Listing::parts(), program());
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 3);
        assert!(lines[2].contains("GOTO") && lines[2].contains("-2.500000"));
        assert!(!text.contains("-0.000000"));
        assert_eq!(print(Listing::before_editing(), program()).lines().count(), 3);
        assert_eq!(print(Listing::whole(), program()).lines().count(), 8);
    }

    #[test]
    fn arguments_stand_as_they_were_written() {
        let center = Vec3::new(1.0, 2.0, 0.0);
        let circle = aptc_geometry::Circle { center, axis: Vec3::z(), radius: 3.5 };
        let name = |name: &str, subscript| NameRef { name: name.into(), subscript };
        let args = vec![
            Arg::Number(-2.5),
            Arg::Word("ON".into()),
            Arg::Text("DEEP".into()),
            Arg::Form { name: name("C", 4), form: aptc_geometry::Form::Circle(circle).into() },
        ];
        let kind = Kind::Post { word: "PPWORD".into(), args };
        let mut text = String::new();
        Listing::whole().push(&Record { kind, ..Record::default() }, &mut text);
        let shown = "PPWORD   -2.5,ON,'DEEP',C(4) CIRCLE(1,2,0,0,0,1,3.5)\n";
        assert!(text.ends_with(shown), "{text}");
    }
}
