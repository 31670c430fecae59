//! The text form: what is written is read back, and garbage is told.

use std::sync::Arc;

use aptc_diagnostics::{FileId, Frame, FrameKind, Origin, Span, Trace};
use aptc_geometry::{
    Circle, Cone, Cutter, Cylinder, Form, FormKind, Line, Pattern, Plane, Quadric, QuadricKind,
    Sphere, Transform, Vec3, Written,
};
use aptc_protap::{
    Arg, AxisAngle, Check, Clprnt, Dimension, Direction, Drive, DriveSide, Edit, Go, Kind, NameRef,
    OptionSurface, PartSide, Place, Pocket, Record, Relation, Sense, SurfaceRef, ToolAxis, Units,
    Writer, read, verify, write,
};
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::{Just, Strategy, any, prop_oneof, proptest};

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
        -1e3..1e3,
        Just(0.0),
        Just(-0.0),
        Just(0.1),
        Just(f64::MIN_POSITIVE),
        Just(f64::MAX),
    ]
}

fn vec3() -> impl Strategy<Value = Vec3> {
    (number(), number(), number()).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn text() -> impl Strategy<Value = Box<str>> {
    "[ -~äß€\"\\\\]{0,20}".prop_map(String::into_boxed_str)
}

fn name() -> impl Strategy<Value = NameRef> {
    ("[A-Z0-9]{0,8}", any::<u32>())
        .prop_map(|(name, subscript)| NameRef { name: name.into(), subscript })
}

fn simple_form() -> impl Strategy<Value = Form> {
    prop_oneof![
        vec3().prop_map(Form::Point),
        vec3().prop_map(Form::Vector),
        (number(), number(), number()).prop_map(|(a, b, d)| Form::Line(Line { a, b, d })),
        (vec3(), number()).prop_map(|(n, d)| Form::Plane(Plane { n, d })),
        (vec3(), vec3(), number()).prop_map(|(center, axis, radius)| Form::Circle(Circle {
            center,
            axis,
            radius
        })),
        (vec3(), vec3(), number()).prop_map(|(point, axis, radius)| Form::Cylinder(Cylinder {
            point,
            axis,
            radius
        })),
        (vec3(), number()).prop_map(|(center, radius)| Form::Sphere(Sphere { center, radius })),
        (vec3(), vec3(), number()).prop_map(|(vertex, axis, cos_half)| Form::Cone(Cone {
            vertex,
            axis,
            cos_half
        })),
        vec(number(), 10).prop_map(|c| {
            let c = c.try_into().expect("ten");
            Form::Quadric(Quadric { kind: QuadricKind::Gconic, c })
        }),
        vec(number(), 12).prop_map(|m| {
            let rows: [f64; 12] = m.try_into().expect("twelve");
            Form::Matrix(Transform::from_rows(&rows))
        }),
        vec(vec3(), 0..4).prop_map(|points| Form::Pattern(Pattern { points })),
    ]
}

fn form() -> impl Strategy<Value = Arc<Form>> {
    prop_oneof![
        simple_form(),
        (vec(number(), 0..5), simple_form()).prop_map(|(elements, shape)| {
            Form::Written(Arc::new(Written { kind: FormKind::Line, elements, shape }))
        }),
    ]
    .prop_map(Arc::new)
}

fn surface() -> impl Strategy<Value = SurfaceRef> {
    (name(), form()).prop_map(|(name, form)| SurfaceRef { name, form })
}

fn relation() -> impl Strategy<Value = Relation> {
    prop_oneof![
        Just(Relation::To),
        Just(Relation::On),
        Just(Relation::Past),
        Just(Relation::Tanto),
        Just(Relation::Pstan),
    ]
}

fn place() -> impl Strategy<Value = Place> {
    (name(), vec3(), option::of(vec3())).prop_map(|(name, point, axis)| Place { name, point, axis })
}

fn arg() -> impl Strategy<Value = Arg> {
    prop_oneof![
        number().prop_map(Arg::Number),
        "[A-Z]{1,6}".prop_map(|w| Arg::Word(w.into())),
        text().prop_map(Arg::Text),
        (name(), form()).prop_map(|(name, form)| Arg::Form { name, form }),
    ]
}

fn four() -> impl Strategy<Value = [f64; 4]> {
    vec(number(), 4).prop_map(|v| v.try_into().expect("four"))
}

fn check() -> impl Strategy<Value = Check> {
    (relation(), any::<u32>(), surface(), any::<bool>())
        .prop_map(|(relation, nth, surface, branch)| Check { relation, nth, surface, branch })
}

fn control_surface() -> impl Strategy<Value = OptionSurface> {
    prop_oneof![Just(OptionSurface::Part), Just(OptionSurface::Drive)]
}

fn tool_axis() -> impl Strategy<Value = ToolAxis> {
    let angle = (
        control_surface(),
        number(),
        option::of(vec3()),
        option::of(number()),
        option::of(number()),
        option::of(number()),
    );
    prop_oneof![
        vec3().prop_map(ToolAxis::Fixed),
        vec3().prop_map(ToolAxis::PerpTo),
        Just(ToolAxis::Keep),
        Just(ToolAxis::NormPs),
        Just(ToolAxis::NormDs),
        Just(ToolAxis::Last),
        (control_surface(), option::of(number()), option::of(number()))
            .prop_map(|(surface, radius, height)| ToolAxis::Parallel { surface, radius, height }),
        angle.prop_map(|(surface, angle_deg, reference, cutting_deg, radius, height)| {
            ToolAxis::Angle(AxisAngle {
                surface,
                angle_deg,
                reference,
                cutting_deg,
                radius,
                height,
            })
        }),
    ]
}

fn setting() -> impl Strategy<Value = Kind> {
    prop_oneof![
        vec(number(), 7).prop_map(|v| Kind::Cutter(Cutter {
            diameter: v[0],
            corner_radius: v[1],
            e: v[2],
            f: v[3],
            alpha_deg: v[4],
            beta_deg: v[5],
            height: v[6],
        })),
        (control_surface(), option::of((number(), number())))
            .prop_map(|(surface, disk)| Kind::CutterOption { surface, disk }),
        prop_oneof![Just(Units::Mm), Just(Units::Cm), Just(Units::Inches), Just(Units::Feet)]
            .prop_map(Kind::Units),
        four().prop_map(Kind::Intol),
        four().prop_map(Kind::Outtol),
        four().prop_map(Kind::Thick),
        (number(), option::of(number())).prop_map(|(step, length)| Kind::Maxdp { step, length }),
        any::<u32>().prop_map(Kind::Numpts),
        prop_oneof![Just(Dimension::Two), Just(Dimension::Three)].prop_map(Kind::Calc),
        any::<bool>().prop_map(Kind::Multax),
        any::<bool>().prop_map(Kind::Gougck),
        any::<bool>().prop_map(Kind::Cut),
        prop_oneof![Just(Clprnt::Whole), Just(Clprnt::On), Just(Clprnt::Off), Just(Clprnt::Option)]
            .prop_map(Kind::Clprnt),
        tool_axis().prop_map(Kind::ToolAxis),
        surface().prop_map(Kind::PartSurface),
        Just(Kind::DriveSide(DriveSide::Tlndon)),
        Just(Kind::PartSide(PartSide::Tlonps)),
        Just(Kind::Autops),
        Just(Kind::Nops),
        Just(Kind::Failed),
        Just(Kind::Nopost),
        Just(Kind::Noplot),
        Just(Kind::Fini),
    ]
}

fn motion() -> impl Strategy<Value = Kind> {
    let pocket = (vec(number(), 6), [any::<i32>(), any::<i32>()], vec(vec3(), 0..5));
    prop_oneof![
        vec(option::of(vec3()), 1..4).prop_map(|v| Kind::Sense(Sense::Vector(v))),
        vec(option::of(vec3()), 1..4).prop_map(|v| Kind::Sense(Sense::Point(v))),
        vec(option::of(vec3()), 1..4).prop_map(Kind::SurfaceNormals),
        place().prop_map(Kind::From),
        place().prop_map(Kind::Goto),
        (name(), vec(vec3(), 0..4)).prop_map(|(name, points)| Kind::Points { name, points }),
        vec3().prop_map(Kind::GoDelta),
        number().prop_map(Kind::GoDeltaAxis),
        (any::<bool>(), vec((relation(), surface()), 1..4))
            .prop_map(|(offset, surfaces)| Kind::Go(Go { offset, surfaces })),
        (surface(), vec(check(), 0..3)).prop_map(|(drive, checks)| Kind::Drive(Drive {
            direction: Direction::Goup,
            drive,
            checks
        })),
        pocket.prop_map(|(v, flags, vertices)| Kind::Pocket(Pocket {
            radius: v[0],
            cut: v[1],
            finish: v[2],
            feeds: [v[3], v[4], v[5]],
            flags,
            vertices,
        })),
    ]
}

fn kind() -> impl Strategy<Value = Kind> {
    let matrix = || {
        vec(number(), 12).prop_map(|m| {
            let rows: [f64; 12] = m.try_into().expect("twelve");
            Transform::from_rows(&rows)
        })
    };
    prop_oneof![
        ("[A-Z]{1,6}", text()).prop_map(|(word, text)| Kind::Text { word: word.into(), text }),
        ("[A-Z]{1,6}", vec(arg(), 0..4))
            .prop_map(|(word, args)| Kind::Post { word: word.into(), args }),
        ("[A-Z]{1,6}", vec(arg(), 0..4))
            .prop_map(|(word, args)| Kind::Regional { word: word.into(), args }),
        (name(), form()).prop_map(|(name, form)| Kind::Define { name, form }),
        setting(),
        motion(),
        (number(), any::<bool>()).prop_map(|(n, close)| Kind::Edit(Edit::Index { n, close })),
        (number(), matrix(), any::<u32>()).prop_map(|(n, step, count)| Kind::Edit(Edit::Copy {
            n,
            step,
            count
        })),
        option::of(matrix()).prop_map(|m| Kind::Edit(Edit::Tracut(m))),
    ]
}

fn span() -> impl Strategy<Value = Span> {
    (any::<u32>(), any::<u32>(), any::<u32>())
        .prop_map(|(file, start, end)| Span::new(FileId(file), start, end))
}

fn trace() -> impl Strategy<Value = Trace> {
    let frame = ("[A-Z]{0,6}", span(), any::<u32>(), any::<u32>());
    vec(frame, 0..4).prop_map(|frames| {
        frames.into_iter().fold(None, |outer, (name, span, line, pass)| {
            let kind = FrameKind::Macro;
            Some(Arc::new(Frame { kind, name: name.into(), span, line, pass, outer }))
        })
    })
}

fn origin() -> impl Strategy<Value = Origin> {
    (span(), any::<u32>(), any::<u32>(), option::of("[a-z./]{0,9}"), trace()).prop_map(
        |(span, isn, line, file, trace)| Origin {
            span,
            isn,
            line,
            file: file.map(|f| f.into()),
            trace,
        },
    )
}

fn record() -> impl Strategy<Value = Record> {
    (origin(), kind()).prop_map(|(origin, kind)| Record { origin, kind })
}

proptest! {
    #[test]
    fn records_round_trip(records in vec(record(), 0..12)) {
        let text = write(&records);
        let (back, messages) = read(FileId(0), &text);
        assert_eq!(messages, []);
        assert_eq!(back, records);
        assert_eq!(write(&back), text);
        // The verifier takes whatever can be read.
        let _: Vec<_> = verify(&back);
    }

    #[test]
    fn damage_is_told_and_never_panics(records in vec(record(), 1..5), at in 0.0..1.0, c: char) {
        let mut text: Vec<char> = write(&records).chars().collect();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss,
            reason = "a place in a short text")]
        let place = (at * text.len() as f64) as usize;
        text[place] = c;
        let text: String = text.into_iter().collect();
        let (back, messages) = read(FileId(0), &text);
        assert!(back.len() + messages.len() >= 1);
        let truncated: String = text.chars().take(place).collect();
        let _: (Vec<_>, Vec<_>) = read(FileId(0), &truncated);
    }

    #[test]
    fn garbage_never_panics(text in "\\PC{0,200}") {
        let (back, messages) = read(FileId(0), &text);
        assert!(back.is_empty() && messages.len() == 1);
    }
}

#[test]
fn messages_name_the_line() {
    let end = Record { origin: Origin::default(), kind: Kind::Fini };
    let mut text = write([&end]);
    text.push_str("{\"origin\":7}\n\n{}\n");
    let (records, messages) = read(FileId(3), &text);
    assert_eq!(records, [end]);
    let told: Vec<_> = messages.iter().map(|m| (m.code.number(), m.message.as_str())).collect();
    assert!(told[0].1.starts_with("line 3 is no PROTAP record"), "{told:?}");
    assert!(told[1].1.starts_with("line 5 is no PROTAP record"), "{told:?}");
    assert_eq!(
        &text[messages[0].span.start as usize..messages[0].span.end as usize],
        "{\"origin\":7}"
    );
}

#[test]
fn other_files_are_refused_once() {
    for text in ["", "PARTNO X\nFINI\n", "{\"protap\":2}\n{}\n", "[[[[", "null\n"] {
        let (records, messages) = read(FileId(0), text);
        assert!(records.is_empty());
        assert_eq!(messages.len(), 1, "{text}");
        assert_eq!(messages[0].code.number(), 1110);
    }
}

#[test]
fn deep_nesting_is_no_danger() {
    for open in ["[", "{\"a\":", "{\"kind\":{\"written\":"] {
        let text = format!("{{\"protap\":1}}\n{}\n", open.repeat(200_000));
        let (_, messages) = read(FileId(0), &text);
        assert_eq!(messages.len(), 1);
    }
}

#[test]
fn a_long_trace_is_read_back() {
    let trace = (0..5_000).fold(None, |outer, line| {
        let (kind, span) = (FrameKind::Macro, Span::default());
        Some(Arc::new(Frame { kind, name: "M".into(), span, line, pass: 0, outer }))
    });
    let origin = Origin { trace, ..Origin::default() };
    let record = Record { origin, kind: Kind::Fini };
    let (back, messages) = read(FileId(0), &write([&record]));
    assert_eq!(messages, []);
    assert_eq!(back[0].origin.frames().count(), 5_000);
    assert_eq!(back[0].origin.frames().next().map(|f| f.line), Some(4_999));
}

#[test]
fn a_full_device_is_no_panic() {
    struct Full;
    impl std::io::Write for Full {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(std::io::Error::other("full"))
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    assert!(Writer::new(Full).is_err());
}
