//! What was written reads back as the same records.

use std::sync::Arc as Shared;

use aptc_diagnostics::Origin;
use aptc_geometry::{
    Circle, Cone, Cutter, Cylinder, Form, Line, Pattern, Plane, Quadric, QuadricKind, Sphere,
    Transform, Vec3,
};
use proptest::prelude::*;

use crate::*;

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-1_000_000_i64..1_000_000).prop_map(|q| q as f64 / 1000.0),
        -1e4_f64..1e4,
        Just(0.0),
        Just(1.0),
    ]
}

fn vector() -> impl Strategy<Value = Vec3> {
    (number(), number(), number()).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn unit() -> impl Strategy<Value = Vec3> {
    let some = (-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64)
        .prop_filter_map("not zero", |(x, y, z)| Vec3::new(x, y, z).try_normalize(0.1));
    prop_oneof![Just(Vec3::z()), Just(-Vec3::x()), some]
}

fn transform() -> impl Strategy<Value = Transform> {
    let any = proptest::array::uniform12(number()).prop_map(|e| Transform::from_rows(&e));
    prop_oneof![Just(Transform::identity()), vector().prop_map(Transform::translation), any]
}

fn word() -> impl Strategy<Value = smol_str::SmolStr> {
    prop_oneof![
        prop::sample::select(vec![
            "SPINDL", "CYCLE", "CLW", "ON", "MMPM", "1STPECK", "3PT2SL", "AT"
        ])
        .prop_map(smol_str::SmolStr::new),
        "[A-Z]{3,6}".prop_filter("no word of ours", |w| !own_word(w)).prop_map(Into::into),
    ]
}

fn own_word(w: &str) -> bool {
    let own = [
        "GOTO", "FROM", "GODLTA", "UNITS", "UNIT", "MULTAX", "CUTTER", "INTOL", "OUTTOL", "TOLER",
        "CUT", "DNTCUT", "INDEX", "COPY", "TRACUT", "CLPRNT", "CSYS", "CIRCLE", "MOVARC", "ARC",
        "ARCDAT", "ARCMOV", "CCW", "GOCLW", "INDIRV", "INDIRP", "PSIS", "AUTOPS", "FINI", "PARTNO",
        "PPRINT", "INSERT", "REMARK", "TITLES", "TLON", "CONT", "GOHOME", "LOAD", "SELECT",
        "GOFWD", "LETTER",
    ];
    own.contains(&w)
        || ["PARTNO", "PPRINT", "INSERT", "REMARK", "TITLES"].iter().any(|t| w.starts_with(t))
}

fn text() -> impl Strategy<Value = Box<str>> {
    "[ -~\u{e4}\u{fc}]{0,40}".prop_map(|t| t.trim().into())
}

fn form() -> impl Strategy<Value = Form> {
    let round = || (vector(), unit(), 0.1..100.0_f64);
    prop_oneof![
        vector().prop_map(Form::Point),
        vector().prop_map(Form::Vector),
        (unit(), number())
            .prop_filter_map("level", |(n, d)| Line::new(n.x, n.y, d).map(Form::Line)),
        (unit(), number()).prop_map(|(n, d)| Form::Plane(Plane { n, d })),
        round().prop_map(|(center, axis, radius)| Form::Circle(Circle { center, axis, radius })),
        round().prop_map(|(point, axis, radius)| Form::Cylinder(Cylinder { point, axis, radius })),
        (vector(), 0.1..9.0_f64)
            .prop_map(|(center, radius)| Form::Sphere(Sphere { center, radius })),
        (vector(), unit(), 0.1..0.9_f64).prop_map(|(vertex, axis, cos_half)| Form::Cone(Cone {
            vertex,
            axis,
            cos_half
        })),
        proptest::array::uniform10(number())
            .prop_map(|c| Form::Quadric(Quadric { kind: QuadricKind::Gconic, c })),
        transform().prop_map(Form::Matrix),
        prop::collection::vec(vector(), 1..5).prop_map(|points| Form::Pattern(Pattern { points })),
    ]
}

fn name() -> impl Strategy<Value = NameRef> {
    let some = ("[A-Z][A-Z0-9]{0,5}", 0_u32..50)
        .prop_map(|(name, subscript)| NameRef { name: name.into(), subscript });
    prop_oneof![Just(NameRef::default()), some]
}

fn arg() -> impl Strategy<Value = Arg> {
    prop_oneof![
        4 => number().prop_map(Arg::Number),
        3 => word().prop_map(Arg::Word),
        1 => text().prop_map(Arg::Text),
        1 => (name(), form()).prop_map(|(name, form)| Arg::Form { name, form: form.into() }),
    ]
}

fn motion() -> impl Strategy<Value = Motion> {
    let kind = prop::sample::select(vec![
        MotionKind::From,
        MotionKind::Goto,
        MotionKind::Startup,
        MotionKind::Continuous,
    ]);
    let circle = (vector(), unit(), 0.1..100.0_f64).prop_map(|(center, axis, radius)| Circle {
        center,
        axis,
        radius,
    });
    let arc = prop::option::of((circle, prop::option::of(0.5..1080.0_f64)));
    let points =
        prop::collection::vec((vector(), unit()).prop_map(|(te, ta)| Position { te, ta }), 1..6);
    (kind, name(), arc, points).prop_map(|(kind, name, arc, mut points)| {
        let arc = arc.filter(|_| kind != MotionKind::From).map(|(circle, sweep)| Arc {
            circle,
            course: sweep.map_or(Course::Chords, Course::Sweep),
        });
        let name = if kind == MotionKind::From { NameRef::default() } else { name };
        if matches!(arc, Some(Arc { course: Course::Sweep(_), .. })) || kind == MotionKind::From {
            points.truncate(1);
        }
        Motion { kind, name, arc, points, with_axis: false, control: None }
    })
}

fn kind() -> impl Strategy<Value = Kind> {
    let edit = prop_oneof![
        (1_u32..99, any::<bool>()).prop_map(|(n, close)| Edit::Index { n: n.into(), close }),
        (1_u32..99, transform(), 0_u32..20).prop_map(|(n, step, count)| Edit::Copy {
            n: n.into(),
            step,
            count
        }),
        prop::option::of(transform()).prop_map(Edit::Tracut),
    ];
    let units = prop::sample::select(vec![Units::Mm, Units::Cm, Units::Inches, Units::Feet]);
    let texts = prop::sample::select(vec!["PARTNO", "PPRINT", "INSERT", "TITLES", "REMARK"]);
    prop_oneof![
        8 => motion().prop_map(Kind::Motion),
        4 => (word(), prop::collection::vec(arg(), 0..5))
            .prop_map(|(word, args)| Kind::Post { word, args }),
        1 => (texts, text()).prop_map(|(w, text)| Kind::Text { word: w.into(), text }),
        1 => units.prop_map(Kind::Units),
        1 => any::<bool>().prop_map(Kind::Multax),
        1 => (0.1..99.0_f64, 0.0..1.0_f64, 1.0..99.0_f64)
            .prop_map(|(d, r, h)| Kind::Cutter(Cutter::mill(d, r, h))),
        1 => proptest::array::uniform4(0.0..1.0_f64).prop_map(Kind::Intol),
        1 => proptest::array::uniform4(0.0..1.0_f64).prop_map(Kind::Outtol),
        1 => prop::sample::select(vec![Output::Cut, Output::Dntcut]).prop_map(Kind::Output),
        2 => edit.prop_map(Kind::Edit),
        1 => prop_oneof![
            Just(Clprnt::Whole),
            Just(Clprnt::On),
            Just(Clprnt::Off),
            Just(Clprnt::Option)
        ]
        .prop_map(Kind::Clprnt),
        1 => transform().prop_map(Kind::Csys),
        1 => prop_oneof![
            text(),
            prop::sample::select(vec![" LINE 5", "ISN 3", ".", ".x", "PATH", "CIRCLE 1,2,3,0,0,1,4"])
                .prop_map(Box::from),
        ].prop_map(Kind::Comment),
        1 => "[A-Z]{1,5}=[A-Z]{4}/[0-9]{1,4}".prop_map(|t| Kind::Unread(t.into())),
        1 => Just(Kind::Fini),
    ]
}

/// A stream as Section 2 makes it: unit first, axis in the positions exactly under MULTAX.
fn stream() -> impl Strategy<Value = Vec<Record>> {
    let file = prop::option::of(Just(Shared::<str>::from("side.apt")));
    prop::collection::vec((kind(), 1_u32..9, file), 0..30).prop_map(|list| {
        let mut out = vec![Record { origin: Origin::default(), kind: Kind::Units(Units::Mm) }];
        let (mut multax, mut ended, mut at) = (false, false, None);
        for (mut kind, line, file) in list {
            // A new program states its unit again.
            if std::mem::take(&mut ended) {
                multax = false;
                let kind = Kind::Units(Units::Inches);
                out.push(Record { origin: Origin::default(), kind });
            }
            match &mut kind {
                Kind::Multax(on) => multax = *on,
                Kind::Motion(m) => {
                    m.with_axis = multax;
                    for p in &mut m.points {
                        p.ta = if multax { p.ta } else { Vec3::z() };
                    }
                    through(m, at);
                    at = m.points.last().map(|p| p.te);
                }
                Kind::Fini => (ended, at) = (true, None),
                _ => {}
            }
            out.push(Record {
                origin: Origin { line, isn: line, file, ..Origin::default() },
                kind,
            });
        }
        out
    })
}

/// Puts the circle of an arc where start and end lie on it; where more points follow, the first of them.
fn through(motion: &mut Motion, start: Option<Vec3>) {
    let Some(arc) = &mut motion.arc else { return };
    let first = motion.points[0].te;
    let (from, to) = match start {
        Some(start) if motion.points.len() == 1 => (start, first),
        _ => (first + arc.circle.axis.cross(&Vec3::new(0.6, 0.0, 0.8)) * 20.0, first),
    };
    let chord = to - from;
    let Some(axis) = arc.circle.axis.cross(&chord).try_normalize(1e-6) else {
        motion.arc = None;
        return;
    };
    arc.circle = Circle { center: (from + to) / 2.0, axis, radius: chord.norm() / 2.0 };
}

fn read_back(bytes: &[u8], dialect: Dialect) -> (Vec<Record>, usize) {
    let mut reader = Reader::open(bytes, Some(dialect)).unwrap();
    let mut record = Record::default();
    let mut out = Vec::new();
    while reader.read(&mut record).unwrap() {
        out.push(record.clone());
    }
    (out, reader.into_diagnostics().iter().filter(|d| d.is_error()).count())
}

fn write_all(writer: &mut dyn RecordWriter, records: &[Record]) {
    for r in records {
        writer.write(r).unwrap();
    }
    writer.finish().unwrap();
}

/// Records of FORTRAN words: forms are numbers, kinds of GOTO alike, no comments, numbers to 1e-12.
fn for_binary(records: &[Record]) -> Vec<Record> {
    let mut out = Vec::new();
    for r in records {
        let mut r = r.clone();
        match &mut r.kind {
            Kind::Comment(_) => continue,
            Kind::Motion(m) => {
                if m.kind != MotionKind::From {
                    m.kind = MotionKind::Goto;
                }
                if m.name.name.is_empty() {
                    m.name.subscript = 0;
                }
            }
            Kind::Post { args, .. } => {
                *args = args.iter().flat_map(flat).collect();
            }
            Kind::Text { text, .. } => *text = latin(text),
            _ => {}
        }
        out.push(r);
    }
    out
}

fn flat_text(arg: &Arg) -> Vec<Arg> {
    match arg {
        Arg::Form { .. } => flat(arg),
        other => vec![other.clone()],
    }
}

fn latin(text: &str) -> Box<str> {
    text.chars().map(|c| if c.is_ascii() { c } else { '?' }).collect()
}

fn flat(arg: &Arg) -> Vec<Arg> {
    match arg {
        Arg::Form { name, form } => {
            let n =
                if name.name.is_empty() { Arg::Number(0.0) } else { Arg::Word(name.name.clone()) };
            let mut list = vec![n, Arg::Number(name.subscript.into())];
            list.extend(form.canonical().into_iter().map(Arg::Number));
            list
        }
        Arg::Text(t) => vec![Arg::Text(latin(t))],
        other => vec![other.clone()],
    }
}

/// Equal but for the last digits of numbers.
fn same(a: &Kind, b: &Kind) -> bool {
    let json = |k: &Kind| serde_json::to_value(k).unwrap();
    close(&json(a), &json(b))
}

fn close(a: &serde_json::Value, b: &serde_json::Value) -> bool {
    use serde_json::Value as V;
    match (a, b) {
        (V::Number(x), V::Number(y)) => {
            let (x, y) = (x.as_f64().unwrap(), y.as_f64().unwrap());
            (x - y).abs() <= 1e-12 * x.abs().max(1.0)
        }
        (V::Array(x), V::Array(y)) => {
            x.len() == y.len() && x.iter().zip(y).all(|(x, y)| close(x, y))
        }
        (V::Object(x), V::Object(y)) => {
            x.len() == y.len() && x.iter().all(|(k, v)| y.get(k).is_some_and(|w| close(v, w)))
        }
        _ => a == b,
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn text_reads_back(records in stream()) {
        let mut writer = TextWriter::new(Vec::new(), TextOptions::default());
        for r in &records {
            writer.write(r).unwrap();
        }
        let bytes = writer.into_inner().unwrap();
        let (back, errors) = read_back(&bytes, Dialect::Iso);
        let shown = String::from_utf8_lossy(&bytes).into_owned();
        prop_assert_eq!(errors, 0, "{}", shown);
        for (a, b) in records.iter().zip(&back) {
            prop_assert_eq!(&a.kind, &b.kind, "{}", shown);
            if !matches!(a.kind, Kind::Units(_)) && !first_partno(&records, a) {
                prop_assert_eq!((a.origin.line, &a.origin.file), (b.origin.line, &b.origin.file));
            }
        }
        prop_assert_eq!(records.len(), back.len(), "{}", shown);
    }

    #[test]
    fn aptsource_reads_back(records in stream()) {
        let mut writer = CatiaWriter::new(Vec::new(), Decimals::Shortest);
        // Its arcs are other statements, tested elsewhere; it has no marks and no comments of ours.
        let mut expected = Vec::new();
        for r in &records {
            let mut r = r.clone();
            match &mut r.kind {
                Kind::Comment(_) => continue,
                Kind::Motion(m) => {
                    m.arc = None;
                    m.name = NameRef::default();
                    if m.kind != MotionKind::From {
                        m.kind = MotionKind::Goto;
                    }
                }
                // Forms stand between their marks in our own text only.
                Kind::Post { args, .. } if args.iter().any(|a| matches!(a, Arg::Form { .. })) => {
                    *args = args.iter().flat_map(flat_text).collect();
                }
                _ => {}
            }
            writer.write(&r).unwrap();
            expected.push(r.kind);
        }
        let bytes = writer.into_inner().unwrap();
        let (back, errors) = read_back(&bytes, Dialect::Catia);
        let shown = String::from_utf8_lossy(&bytes).into_owned();
        prop_assert_eq!(errors, 0, "{}", shown);
        let mut got = Vec::new();
        for r in back {
            match (got.last_mut(), r.kind) {
                (_, Kind::Comment(_)) => {}
                (_, kind) => got.push(kind),
            }
        }
        let split = |list: Vec<Kind>| {
            let mut out = Vec::new();
            for kind in list {
                match kind {
                    Kind::Motion(m) => out.extend(m.points.iter().map(|p| {
                        Kind::Motion(Motion { points: vec![*p], ..m.clone() })
                    })),
                    other => out.push(other),
                }
            }
            out
        };
        prop_assert_eq!(split(expected), split(got), "{}", shown);
    }

    #[test]
    fn json_reads_back(records in stream()) {
        let mut bytes = Vec::new();
        write_all(&mut JsonWriter::new(&mut bytes), &records);
        let (back, errors) = read_back(&bytes, Dialect::Json);
        prop_assert_eq!(errors, 0);
        prop_assert_eq!(records, back);
    }

    #[test]
    fn binary_records_read_back(records in stream()) {
        for clfile in [false, true] {
            let mut bytes = Vec::new();
            let dialect = if clfile {
                write_all(&mut ClfileWriter::new(&mut bytes), &records);
                Dialect::Clfile
            } else {
                let words = aptc_vocabulary::Dialect::Apt360;
                write_all(&mut TapeWriter::new(&mut bytes, words), &records);
                Dialect::Tape
            };
            let (back, errors) = read_back(&bytes, dialect);
            prop_assert_eq!(errors, 0);
            let expected = for_binary(&records);
            prop_assert_eq!(expected.len(), back.len());
            for (a, b) in expected.iter().zip(&back) {
                // The circle of a path may be restated, and an end becomes chords on a tape.
                if let (Kind::Motion(x), Kind::Motion(y)) = (&a.kind, &b.kind) {
                    prop_assert_eq!((&x.name, x.kind, x.with_axis), (&y.name, y.kind, y.with_axis));
                    let (p, q) = (x.points.last().unwrap(), y.points.last().unwrap());
                    prop_assert!((p.te - q.te).norm() <= 1e-12 * p.te.norm().max(1.0));
                    if x.arc.is_none() {
                        prop_assert_eq!(x.points.len(), y.points.len());
                    }
                } else {
                    prop_assert!(same(&a.kind, &b.kind), "{:?}\n{:?}", a.kind, b.kind);
                }
                if a.origin.isn > 0 {
                    prop_assert_eq!(a.origin.isn, b.origin.isn);
                }
            }
        }
    }
}

fn first_partno(records: &[Record], r: &Record) -> bool {
    std::ptr::eq(r, &records[0])
}
