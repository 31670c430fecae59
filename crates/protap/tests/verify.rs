//! Each rule of the verifier, kept and broken.

use std::sync::Arc;

use aptc_diagnostics::Origin;
use aptc_geometry::{Cone, Cutter, Form, Plane, Transform, Vec3};
use aptc_protap::{
    Arg, AxisAngle, Check, Direction, Drive, Edit, Go, Kind, NameRef, OptionSurface, Place, Pocket,
    Record, Relation, Sense, SurfaceRef, ToolAxis, verify,
};

fn record(kind: Kind) -> Record {
    Record { origin: Origin::default(), kind }
}

/// The messages about `kinds` with a FINI behind them.
fn told(kinds: Vec<Kind>) -> Vec<String> {
    let mut records: Vec<_> = kinds.into_iter().map(record).collect();
    records.push(record(Kind::Fini));
    verify(&records).into_iter().map(|d| d.message).collect()
}

fn surface(form: Form) -> SurfaceRef {
    SurfaceRef { name: NameRef::default(), form: Arc::new(form) }
}

fn top() -> SurfaceRef {
    surface(Form::Plane(Plane { n: Vec3::z(), d: 0.0 }))
}

fn point() -> SurfaceRef {
    surface(Form::Point(Vec3::zeros()))
}

fn drive(check: Check) -> Kind {
    Kind::Drive(Drive { direction: Direction::Gofwd, drive: top(), checks: vec![check] })
}

fn check() -> Check {
    Check { relation: Relation::To, nth: 1, surface: top(), branch: false }
}

fn go(surfaces: Vec<(Relation, SurfaceRef)>) -> Kind {
    Kind::Go(Go { offset: false, surfaces })
}

fn pocket(n: usize, flags: [i32; 2]) -> Kind {
    Kind::Pocket(Pocket {
        radius: 1.0,
        cut: 1.0,
        finish: 1.0,
        feeds: [1.0; 3],
        flags,
        vertices: vec![Vec3::zeros(); n],
    })
}

fn goto(x: f64, axis: Option<Vec3>) -> Kind {
    Kind::Goto(Place { name: NameRef::default(), point: Vec3::new(x, 0.0, 0.0), axis })
}

fn copy(n: f64, count: u32) -> Kind {
    Kind::Edit(Edit::Copy { n, step: Transform::identity(), count })
}

#[test]
fn a_good_program_keeps_all_rules() {
    let kinds = vec![
        Kind::Text { word: "PARTNO".into(), text: "a part".into() },
        Kind::Cutter(Cutter::mill(10.0, 2.0, 50.0)),
        Kind::Intol([0.0; 4]),
        Kind::ToolAxis(ToolAxis::Fixed(Vec3::z())),
        Kind::Edit(Edit::Index { n: 1.0, close: false }),
        goto(1.0, None),
        go(vec![(Relation::To, top()), (Relation::On, top()), (Relation::Tanto, top())]),
        Kind::Sense(Sense::Vector(vec![None, Some(Vec3::x())])),
        drive(check()),
        pocket(4, [0, 3]),
        Kind::Edit(Edit::Index { n: 1.0, close: true }),
        copy(1.0, 2),
        Kind::Post { word: "CYCLE".into(), args: vec![Arg::Word("ON".into())] },
    ];
    assert_eq!(told(kinds), Vec::<String>::new());
}

#[test]
fn each_broken_rule_is_told() {
    let axis = |angle_deg| AxisAngle {
        surface: OptionSurface::Part,
        angle_deg,
        reference: None,
        cutting_deg: None,
        radius: None,
        height: None,
    };
    let long = Form::Plane(Plane { n: Vec3::new(0.0, 0.0, 2.0), d: 0.0 });
    let flat = Cone { vertex: Vec3::zeros(), axis: Vec3::z(), cos_half: 0.0 };
    let broken = vec![
        (goto(f64::NAN, None), "NaN is no number"),
        (goto(0.0, Some(Vec3::zeros())), "a direction of no length"),
        (Kind::Post { word: "cycle".into(), args: vec![] }, "`cycle` is no word"),
        (Kind::Post { word: "".into(), args: vec![] }, "`` is no word"),
        (Kind::Text { word: "INSERT".into(), text: "a\nb".into() }, "a text of several lines"),
        (Kind::PartSurface(point()), "a POINT is no surface"),
        (Kind::PartSurface(surface(long)), "a unit vector of length 2"),
        (Kind::PartSurface(surface(Form::Cone(flat))), "a cone whose half angle has the cosine 0"),
        (go(vec![]), "GO to 0 surfaces"),
        (go(vec![(Relation::Tanto, top())]), "GO at a tangent to the drive or part surface"),
        (drive(Check { nth: 0, ..check() }), "intersection 0"),
        (drive(Check { surface: point(), ..check() }), "a POINT is no surface"),
        (Kind::Sense(Sense::Vector(vec![None])), "a sense of direction of no or too many fields"),
        (Kind::SurfaceNormals(vec![Some(Vec3::zeros())]), "a direction of no length"),
        (Kind::Outtol([-1.0, 0.0, 0.0, 0.0]), "a tolerance is negative"),
        (Kind::Cutter(Cutter::mill(-1.0, 0.0, 5.0)), "a cutter with a size of -1"),
        (Kind::Numpts(0), "NUMPTS is 0"),
        (pocket(2, [0, 0]), "a pocket of 2 vertices"),
        (pocket(3, [2, 0]), "flags 2 and 0 of a pocket"),
        (Kind::ToolAxis(ToolAxis::Fixed(Vec3::zeros())), "a direction of no length"),
        (Kind::ToolAxis(ToolAxis::Angle(axis(91.0))), "an angle of 91 degrees"),
        (copy(7.0, 1), "COPY/7 has no INDEX before it"),
        (Kind::Edit(Edit::Index { n: 2.0, close: true }), "INDEX/2,NOMORE closes no INDEX"),
        (
            Kind::Points { name: NameRef::default(), points: vec![] },
            "GOTO of a pattern without points",
        ),
    ];
    for (kind, message) in broken {
        assert_eq!(told(vec![kind]), [message]);
    }
}

#[test]
fn programs_end_with_fini() {
    assert_eq!(verify([&record(Kind::Nops)])[0].message, "the program has no FINI");
    let behind = [record(Kind::Fini), record(Kind::Nops)];
    assert_eq!(verify(&behind)[0].message, "records stand behind the last FINI");
    assert!(verify(&[]).is_empty());
}
