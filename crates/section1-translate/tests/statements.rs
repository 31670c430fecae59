//! Each motion, tool, tolerance, editing and post statement and the record it becomes.
#![expect(clippy::float_cmp, reason = "these values are exact")]

mod support;

use aptc_geometry::{Cutter, Form, Transform, Vec3};
use aptc_protap::{
    Arg, AxisAngle, Clprnt, Dimension, Direction, DriveSide, Edit, Kind, NameRef, OptionSurface,
    PartSide, Place, Relation, Sense, ToolAxis, Units,
};
use support::{clean, run};

const FORMS: &str = "P=POINT/1,2,3\nV=VECTOR/0,0,2\nL1=LINE/XAXIS\nL2=LINE/YAXIS\nL3=LINE/1,0,1,1\n\
    PL=PLANE/0,0,1,4\nC=CIRCLE/0,0,5\nM=MATRIX/TRANSL,1,2,3\nA=7\n";

/// What a statement becomes. UNITS stands before the forms that it measures.
fn kinds(statement: &str) -> Vec<Kind> {
    let (unit, rest) = match statement.split_once('\n') {
        Some((unit, rest)) if unit.starts_with("UNITS") => (unit, rest),
        None if statement.starts_with("UNITS") => (statement, ""),
        _ => ("", statement),
    };
    clean(&format!("{unit}\n{FORMS}{rest}\nFINI\n")).kinds().into_iter().cloned().collect()
}

/// What a statement becomes that gives one record.
fn kind(statement: &str) -> Kind {
    let mut kinds = kinds(statement);
    assert_eq!(kinds.len(), 1, "{kinds:?}");
    kinds.remove(0)
}

fn at(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3::new(x, y, z)
}

fn place(name: &str, point: Vec3, axis: Option<Vec3>) -> Place {
    Place { name: NameRef { name: name.into(), subscript: 0 }, point, axis }
}

fn feed(f: f64) -> Kind {
    Kind::Post { word: "FEDRAT".into(), args: vec![Arg::Number(f)] }
}

/// What a number would be that is missing is told, not only behind which word.
#[test]
fn a_missing_number_of_regional_milling_is_named() {
    let head = "S=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(9,0,1),SPLINE,(0,9,0),(9,9,2)\n";
    for (statement, wanted) in [
        ("SCON/STEPOV,.1", "SCON ends where the greatest step is expected"),
        ("SCON/STEPOV,.1,2,0", "SCON ends where the greatest number of passes is expected"),
        ("SCON/STEPOV,.1,S", "SCON expects the greatest step here, found the SSURF S"),
        ("SCON/DS,S,PARAM,0,1,0", "SCON ends where the second limit of v is expected"),
        ("SCON/PS,TO,S,PLUS", "SCON ends where the thickness is expected"),
        ("SCON/AXIS,ATANGL,PS,3,CUTANG", "SCON ends where the tilt angle or LEAD|LAG is expected"),
        ("SCON/FEED,9,9,9", "SCON ends where the feed up is expected"),
        ("SMIL/PATH,DS,PARAM,0", "SMIL ends where the parameter v is expected"),
        ("AVCTRL/AXIS,LIMIT", "AVCTRL ends where how far it may lift is expected"),
        ("AVCTRL/CUTANG,CONST,1,RANGE,0", "AVCTRL ends where the greatest angle is expected"),
        ("HOLDER/10", "HOLDER ends where its height above the tool end is expected"),
        ("GOLOFT/S,UCONST", "GOLOFT ends where the constant parameter is expected"),
        ("GOLOFT/S,UCONST,1,CHORD", "GOLOFT ends where the step or chord is expected"),
        (
            "GOLOFT/S,UCONST,1,AT",
            "GOLOFT ends where the parameter of the place or TO|ON|PAST is expected",
        ),
        ("GOMILL/S,UCONST,1,STEPOV", "GOMILL ends where the step of the parameter is expected"),
        ("WCORN/LEFT,3,RIGHT", "WCORN ends where the tilt behind the corner is expected"),
    ] {
        let ran = run(&format!("{head}{statement}\nFINI\n"));
        assert!(ran.messages().contains(wanted), "{statement}: {}", ran.messages());
    }
    // Nothing is checked of CHKSRF but surfaces.
    let ran = run(&format!("{head}CHKSRF/3,ON\nFINI\n"));
    assert!(
        ran.messages().contains("CHKSRF expects OFF, PS or surface here"),
        "{}",
        ran.messages()
    );
}

/// Forms of another system are carried into the one where the tool moves; numbers are given in it.
#[test]
fn motion_within_a_reference_system_is_in_that_system() {
    let refsys = "M9=MATRIX/XYROT,90,TRANSL,10,0,0\nREFSYS/M9\n";
    // P lies at 1,2,3 in the base system: 10 less in x, then turned back by 90 degrees.
    let there = at(2.0, 9.0, 3.0);
    let goto = |text: &str| match kinds(&format!("{refsys}{text}")).pop() {
        Some(Kind::Goto(place) | Kind::From(place)) => place.point,
        other => panic!("{text}: {other:?}"),
    };
    for (text, point) in [
        ("GOTO/P", there),
        ("FROM/P", there),
        ("GOTO/1,2,3", at(1.0, 2.0, 3.0)),
        ("GOTO/1,2", at(1.0, 2.0, 0.0)),
        ("GOTO/(1,2,3)", at(1.0, 2.0, 3.0)),
        ("GOTO/(POINT/1,2,3)", at(1.0, 2.0, 3.0)),
        ("Q=POINT/1,2,3\nGOTO/Q", at(1.0, 2.0, 3.0)),
        ("Q=POINT/1,2,3\nREFSYS/NOMORE\nGOTO/Q", at(8.0, 1.0, 3.0)),
        ("REFSYS/NOMORE\nGOTO/P", at(1.0, 2.0, 3.0)),
        // The distance of two points is that of the system as well.
        ("W=VECTOR/P,(POINT/2,9,7)\nGOTO/LNTHF(W),0,0", at(4.0, 0.0, 0.0)),
    ] {
        assert!((goto(text) - point).norm() < 1e-12, "{text}: {:?}", goto(text));
    }
    // Surfaces and directions too: the x axis of the base system stands at x = 0 there.
    let all = kinds(&format!("{refsys}INDIRV/(VECTOR/0,1,0)\nGO/TO,L1"));
    let Some(Kind::Go(go)) = all.last() else { panic!("{all:?}") };
    let Form::Line(line) = &*go.surfaces[0].1.form else { panic!("{go:?}") };
    assert!((line.plane().n.cross(&Vec3::x())).norm() < 1e-12 && line.plane().d.abs() < 1e-12);
}

#[test]
fn points_of_motion() {
    let p = at(1.0, 2.0, 3.0);
    assert_eq!(kind("FROM/P"), Kind::From(place("P", p, None)));
    assert_eq!(kind("GOTO/1,2"), Kind::Goto(place("", at(1.0, 2.0, 0.0), None)));
    assert_eq!(kind("GOTO/1,2,3"), Kind::Goto(place("", p, None)));
    assert_eq!(kind("GO TO/(1,2,3)"), Kind::Goto(place("", p, None)));
    assert_eq!(kind("GOTO/(POINT/1,2,3)"), Kind::Goto(place("", p, None)));
    let axis = Some(at(0.0, 0.0, 2.0));
    assert_eq!(kind("GOTO/P,V"), Kind::Goto(place("P", p, axis)));
    assert_eq!(kind("GOTO/P,0,0,2"), Kind::Goto(place("P", p, axis)));
    assert_eq!(kind("GOTO/1,2,3,V"), Kind::Goto(place("", p, axis)));
    assert_eq!(kind("GOTO/1,2,3,0,0,2"), Kind::Goto(place("", p, axis)));
    assert_eq!(kinds("GOTO/P,20"), [feed(20.0), Kind::Goto(place("P", p, None))]);
    assert_eq!(kinds("GOTO/1,2,3,20"), [feed(20.0), Kind::Goto(place("", p, None))]);
    assert_eq!(kinds("GOTO/1,2,3,0,0,2,20"), [feed(20.0), Kind::Goto(place("", p, axis))]);
    assert_eq!(kinds("FROM/P,0,0,2,20"), [feed(20.0), Kind::From(place("P", p, axis))]);
    assert_eq!(kinds("FROM/P,V,20"), [feed(20.0), Kind::From(place("P", p, axis))]);
}

#[test]
fn zsurf_gives_the_third_coordinate() {
    let z = |before: &str| {
        let kinds = kinds(&format!("{before}\nGOTO/1,2"));
        let Kind::Goto(place) = &kinds[0] else { panic!("{kinds:?}") };
        place.point.z
    };
    assert_eq!(z("ZSURF/PL"), 4.0);
    assert_eq!(z("ZSURF/2.5"), 2.5);
    assert_eq!(z("ZSURF/(PLANE/1,0,1,4)"), 3.0);
    assert_eq!(z("ZSURF/PL\nZSURF/NOMORE"), 0.0);
    assert_eq!(clean(&format!("{FORMS}ZSURF/PL\nQ=POINT/1,2\nFINI")).form("Q"), [1.0, 2.0, 4.0]);
    let tuple = "ZSURF/PL\nQ=PATERN/RANDOM,(1,2)";
    assert_eq!(clean(&format!("{FORMS}{tuple}\nFINI")).form("Q"), [1.0, 2.0, 4.0]);
}

#[test]
fn steps() {
    assert_eq!(kind("GODLTA/1,2,3"), Kind::GoDelta(at(1.0, 2.0, 3.0)));
    assert_eq!(kind("GODLTA/V"), Kind::GoDelta(at(0.0, 0.0, 2.0)));
    assert_eq!(kind("GODLTA/-5"), Kind::GoDeltaAxis(-5.0));
    assert_eq!(kinds("GODLTA/3,60"), [feed(60.0), Kind::GoDeltaAxis(3.0)]);
    assert_eq!(kinds("GODLTA/V,60"), [feed(60.0), Kind::GoDelta(at(0.0, 0.0, 2.0))]);
    assert_eq!(kinds("GODLTA/1,2,3,60"), [feed(60.0), Kind::GoDelta(at(1.0, 2.0, 3.0))]);
}

#[test]
fn senses_of_direction() {
    let (x, p) = (Some(Vec3::x()), Some(at(1.0, 2.0, 3.0)));
    assert_eq!(kind("INDIRV/1,0,0"), Kind::Sense(Sense::Vector(vec![x])));
    assert_eq!(
        kind("INDIRV/V,,1,0,0"),
        Kind::Sense(Sense::Vector(vec![Some(at(0.0, 0.0, 2.0)), None, x]))
    );
    assert_eq!(kind("INDIRP/P"), Kind::Sense(Sense::Point(vec![p])));
    assert_eq!(kind("INDIRP/1,2,3"), Kind::Sense(Sense::Point(vec![p])));
    assert_eq!(kind("SRFVCT/,1,0,0"), Kind::SurfaceNormals(vec![None, x]));
}

#[test]
fn start_ups() {
    let go = |statement: &str| match kind(statement) {
        Kind::Go(go) => (
            go.offset,
            go.surfaces.into_iter().map(|(r, s)| (r, s.name.name.to_string())).collect::<Vec<_>>(),
        ),
        other => panic!("{other:?}"),
    };
    let named = |r, n: &str| (r, n.to_owned());
    assert_eq!(go("GO/L1"), (false, vec![named(Relation::To, "L1")]));
    assert_eq!(
        go("GO/ON,L1,PAST,PL,TANTO,C"),
        (
            false,
            vec![
                named(Relation::On, "L1"),
                named(Relation::Past, "PL"),
                named(Relation::Tanto, "C")
            ]
        )
    );
    assert_eq!(
        go("OFFSET/L1,PL"),
        (true, vec![named(Relation::To, "L1"), named(Relation::To, "PL")])
    );
    let kinds = kinds("GO/TO,L1,TO,PL,ON,L2,7");
    assert_eq!(kinds[0], feed(7.0));
    assert!(matches!(kinds[1], Kind::Go(_)));
}

#[test]
fn continuous_motion() {
    let checks = |statement: &str| match kinds(statement).pop() {
        Some(Kind::Drive(d)) => d
            .checks
            .into_iter()
            .map(|c| (c.relation, c.nth, c.surface.name.name.to_string(), c.branch))
            .collect::<Vec<_>>(),
        other => panic!("{other:?}"),
    };
    assert_eq!(checks("GOLFT/L1"), []);
    assert_eq!(checks("GOLFT/L1,L2"), [(Relation::To, 1, "L2".into(), false)]);
    assert_eq!(checks("GOLFT/L1,PAST,2,INTOF,C"), [(Relation::Past, 2, "C".into(), false)]);
    assert_eq!(checks("GOLFT/L1,2,INTOF,C,10"), [(Relation::To, 2, "C".into(), false)]);
    assert_eq!(checks("GOLFT/L1,DSTAN,C"), [(Relation::Tanto, 1, "C".into(), false)]);
    assert_eq!(checks("GOLFT/L1,PSTAN,C"), [(Relation::Pstan, 1, "C".into(), false)]);
    assert_eq!(
        checks("GOLFT/L1,TO,L2,X,ON,3,INTOF,C,20,L3,30\nX) A=1\n20) A=2\n30) A=3"),
        [
            (Relation::To, 1, "L2".into(), true),
            (Relation::On, 3, "C".into(), true),
            (Relation::To, 1, "L3".into(), true)
        ]
    );
    let words = ["GOLFT", "GORGT", "GOFWD", "GOBACK", "GOUP", "GODOWN"];
    let directions = words.map(|w| match kind(&format!("{w}/L1,L2")) {
        Kind::Drive(d) => d.direction,
        other => panic!("{other:?}"),
    });
    use Direction::{Goback, Godown, Gofwd, Golft, Gorgt, Goup};
    assert_eq!(directions, [Golft, Gorgt, Gofwd, Goback, Goup, Godown]);
    let joined = kinds("TLRGT,TLONPS,GOFWD/L1,TO,L2,A");
    assert_eq!(joined[0], Kind::DriveSide(DriveSide::Tlrgt));
    assert_eq!(joined[1], Kind::PartSide(PartSide::Tlonps));
    assert_eq!(joined[2], feed(7.0));
    assert!(matches!(joined[3], Kind::Drive(_)));
}

#[test]
fn drive_surfaces_may_be_defined_in_place() {
    let kinds = kinds("GOLFT/(LX=LINE/1,0,1,1),ON,(PLANE/1,0,0,3)");
    let Some(Kind::Drive(drive)) = kinds.last() else { panic!("{kinds:?}") };
    assert_eq!(drive.drive.name.name, "LX");
    assert_eq!(drive.checks[0].surface.name, NameRef::default());
    assert_eq!(drive.checks[0].surface.form.canonical(), [1.0, 0.0, 0.0, 3.0]);
}

#[test]
fn words_that_stand_alone() {
    for (word, expected) in [
        ("TLLFT", Kind::DriveSide(DriveSide::Tllft)),
        ("TLON", Kind::DriveSide(DriveSide::Tlon)),
        ("TLNDON", Kind::DriveSide(DriveSide::Tlndon)),
        ("TLOFPS", Kind::PartSide(PartSide::Tlofps)),
        ("AUTOPS", Kind::Autops),
        ("NOPS", Kind::Nops),
        ("2DCALC", Kind::Calc(Dimension::Two)),
        ("3DCALC", Kind::Calc(Dimension::Three)),
        ("NDTEST", Kind::Calc(Dimension::Two)),
        ("CUT", Kind::Cut(true)),
        ("DNTCUT", Kind::Cut(false)),
        ("DNTCUT/PRINT", Kind::Cut(false)),
        ("MULTAX", Kind::Multax(true)),
        ("MULTAX/ON", Kind::Multax(true)),
        ("MULTAX/OFF", Kind::Multax(false)),
        ("GOUGCK/ON", Kind::Gougck(true)),
        ("GOUGCK/OFF", Kind::Gougck(false)),
        ("CLPRNT", Kind::Clprnt(Clprnt::Whole)),
        ("CLPRNT/ON", Kind::Clprnt(Clprnt::On)),
        ("CLPRNT/OFF", Kind::Clprnt(Clprnt::Off)),
        ("CLPRNT/OPTION", Kind::Clprnt(Clprnt::Option)),
        ("NOPOST", Kind::Nopost),
        ("NOPLOT", Kind::Noplot),
        ("NUMPTS/900", Kind::Numpts(900)),
        ("UNITS/MM", Kind::Units(Units::Mm)),
        ("UNITS/CM", Kind::Units(Units::Cm)),
        ("UNITS/INCHES", Kind::Units(Units::Inches)),
        ("UNITS/FEET", Kind::Units(Units::Feet)),
    ] {
        assert_eq!(kind(word), expected, "{word}");
    }
}

#[test]
fn multax_without_on_holds_to_the_end() {
    let ran = run("MULTAX\nMULTAX/OFF\nMULTAX/ON\nMULTAX/OFF\nFINI\n");
    assert_eq!(ran.told(), [(1305, 2)]);
    let ran = run("MULTAX\nMULTAX/OFF\nFINI\n");
    assert_eq!(ran.kinds(), [&Kind::Multax(true)]);
    assert_eq!(
        clean("MULTAX/ON\nMULTAX/OFF\nFINI\n").kinds(),
        [&Kind::Multax(true), &Kind::Multax(false)]
    );
}

#[test]
fn cutters() {
    let cutter = |s: &str| match kinds(s).pop() {
        Some(Kind::Cutter(c)) => c.values(),
        other => panic!("{other:?}"),
    };
    assert_eq!(cutter("CUTTER/1"), [1.0, 0.0, 0.5, 0.0, 0.0, 0.0, 5.0]);
    assert_eq!(cutter("CUTTER/1,.25"), [1.0, 0.25, 0.25, 0.25, 0.0, 0.0, 5.0]);
    assert_eq!(cutter("CUTTER/20,10,0,10,0,0,60"), [20.0, 10.0, 0.0, 10.0, 0.0, 0.0, 60.0]);
    // The height of five inches in the unit of the program.
    assert_eq!(cutter("UNITS/MM\nCUTTER/10")[6], 127.0);
    assert_eq!(cutter("UNITS/CM\nCUTTER/1")[6], 12.7);
    assert_eq!(kind("CUTTER/1"), Kind::Cutter(Cutter::mill(1.0, 0.0, 5.0)));
    let option = |surface, disk| Kind::CutterOption { surface, disk };
    assert_eq!(kind("CUTTER/OPTION,2,.5,1"), option(OptionSurface::Drive, Some((0.5, 1.0))));
    assert_eq!(kind("CUTTER/OPTION,1,OFF"), option(OptionSurface::Part, None));
}

#[test]
fn tolerances_and_thickness() {
    assert_eq!(kind("INTOL/.1"), Kind::Intol([0.1; 4]));
    assert_eq!(kind("OUTTOL/.1,.2,.3"), Kind::Outtol([0.1, 0.2, 0.3, 0.3]));
    assert_eq!(kind("THICK/-.1,.2"), Kind::Thick([-0.1, 0.2, 0.2, 0.2]));
    assert_eq!(kinds("TOLER/.01"), [Kind::Intol([0.0; 4]), Kind::Outtol([0.01; 4])]);
    assert_eq!(kind("MAXDP/2"), Kind::Maxdp { step: 2.0, length: None });
    assert_eq!(kind("MAXDP/.5,8"), Kind::Maxdp { step: 0.5, length: Some(8.0) });
    assert_eq!(kind("MAXDP/-4,0"), Kind::Maxdp { step: -4.0, length: Some(0.0) });
}

#[test]
fn part_surfaces() {
    let Kind::PartSurface(s) = kind("PSIS/PL") else { panic!() };
    assert_eq!((s.name.name.as_str(), s.form.canonical()), ("PL", vec![0.0, 0.0, 1.0, 4.0]));
}

#[test]
fn tool_axes() {
    let axis = |s: &str| match kind(&format!("TLAXIS/{s}")) {
        Kind::ToolAxis(axis) => axis,
        other => panic!("{other:?}"),
    };
    let angle = |surface, angle_deg| AxisAngle {
        surface,
        angle_deg,
        reference: None,
        cutting_deg: None,
        radius: None,
        height: None,
    };
    use OptionSurface::{Drive, Part};
    assert_eq!(axis("1,0,1"), ToolAxis::Fixed(at(1.0, 0.0, 1.0)));
    assert_eq!(axis("V"), ToolAxis::Fixed(at(0.0, 0.0, 2.0)));
    assert_eq!(axis("1"), ToolAxis::Keep);
    assert_eq!(axis("NORMPS"), ToolAxis::NormPs);
    assert_eq!(axis("NORMDS"), ToolAxis::NormDs);
    assert_eq!(axis("LAST"), ToolAxis::Last);
    assert_eq!(axis("PERPTO,V"), ToolAxis::PerpTo(at(0.0, 0.0, 2.0)));
    let parallel = |surface, radius, height| ToolAxis::Parallel { surface, radius, height };
    assert_eq!(axis("PARLEL,1"), parallel(Part, None, None));
    assert_eq!(axis("PARLEL,2,.5,A"), parallel(Drive, Some(0.5), Some(7.0)));
    assert_eq!(axis("PARLEL,DS,HIGHT,3,RADIUS,1"), parallel(Drive, Some(1.0), Some(3.0)));
    assert_eq!(axis("ATANGL,1,10"), ToolAxis::Angle(angle(Part, 10.0)));
    assert_eq!(
        axis("ATANGL,PS,-10,CUTANG,5"),
        ToolAxis::Angle(AxisAngle { cutting_deg: Some(5.0), ..angle(Part, -10.0) })
    );
    assert_eq!(
        axis("ATANGL,DS,10,CUTANG,LAG,5"),
        ToolAxis::Angle(AxisAngle { cutting_deg: Some(-5.0), ..angle(Drive, 10.0) })
    );
    assert_eq!(
        axis("ATANGL,DS,10,V"),
        ToolAxis::Angle(AxisAngle { reference: Some(at(0.0, 0.0, 2.0)), ..angle(Drive, 10.0) })
    );
    assert_eq!(
        axis("ATANGL,DS,10,PARLEL,PL"),
        ToolAxis::Angle(AxisAngle { reference: Some(Vec3::z()), ..angle(Drive, 10.0) })
    );
    assert_eq!(axis("ATANGL,DS,10,MOTDIR"), ToolAxis::Angle(angle(Drive, 10.0)));
    assert_eq!(
        axis("ATANGL,DS,10,RADIUS,1,HIGHT,2"),
        ToolAxis::Angle(AxisAngle { radius: Some(1.0), height: Some(2.0), ..angle(Drive, 10.0) })
    );
}

#[test]
fn editing() {
    assert_eq!(kind("INDEX/3"), Kind::Edit(Edit::Index { n: 3.0, close: false }));
    assert_eq!(kind("INDEX/3,NOMORE"), Kind::Edit(Edit::Index { n: 3.0, close: true }));
    assert_eq!(kind("TRACUT/NOMORE"), Kind::Edit(Edit::Tracut(None)));
    let move_by = Transform::translation(at(1.0, 2.0, 3.0));
    assert_eq!(kind("TRACUT/M"), Kind::Edit(Edit::Tracut(Some(move_by))));
    let copy = |s: &str| match kind(s) {
        Kind::Edit(Edit::Copy { step, count, .. }) => (step, count),
        other => panic!("{other:?}"),
    };
    assert_eq!(copy("COPY/1,SAME,2"), (Transform::identity(), 2));
    assert_eq!(copy("COPY/1,TRANSL,1,2,3,4"), (move_by, 4));
    assert_eq!(copy("COPY/1,TRANSL,1,2,4"), (Transform::translation(at(1.0, 2.0, 0.0)), 4));
    assert_eq!(copy("COPY/1,XYROT,30,11"), (Transform::rotation(Vec3::z(), 30.0), 11));
    assert_eq!(copy("COPY/1,YZROT,30,1"), (Transform::rotation(Vec3::x(), 30.0), 1));
    assert_eq!(copy("COPY/1,ZXROT,30,1"), (Transform::rotation(Vec3::y(), 30.0), 1));
    assert_eq!(copy("COPY/1,MODIFY,M,5"), (move_by, 5));
}

#[test]
fn pockets() {
    let Kind::Pocket(p) = kind("POCKET/.4,1,.5,10,20,30,1,0,P,(POINT/5,0),5,5,0") else { panic!() };
    assert_eq!((p.radius, p.cut, p.finish), (0.4, 1.0, 0.5));
    assert_eq!((p.feeds, p.flags), ([10.0, 20.0, 30.0], [1, 0]));
    assert_eq!(p.vertices, [at(1.0, 2.0, 3.0), at(5.0, 0.0, 0.0), at(5.0, 5.0, 0.0)]);
}

#[test]
fn post_words_pass_in_order() {
    let post = |s: &str| match kinds(s).pop() {
        Some(Kind::Post { word, args }) => (word.to_string(), args),
        other => panic!("{other:?}"),
    };
    let (n, w) = (Arg::Number, |w: &str| Arg::Word(w.into()));
    assert_eq!(post("RAPID"), ("RAPID".into(), vec![]));
    assert_eq!(post("SPINDL/A,RPM,CLW"), ("SPINDL".into(), vec![n(7.0), w("RPM"), w("CLW")]));
    assert_eq!(post("FEDRAT/30.,IPM"), ("FEDRAT".into(), vec![n(30.0), w("IPM")]));
    assert_eq!(post("FEDRAT/20,.5,5"), ("FEDRAT".into(), vec![n(20.0), n(0.5), n(5.0)]));
    assert_eq!(
        post("MACHIN/PMILL,1,CURCUL"),
        ("MACHIN".into(), vec![w("PMILL"), n(1.0), w("CURCUL")])
    );
    // The name of a machine is not that of a number.
    assert_eq!(post("MACHIN/A,2"), ("MACHIN".into(), vec![w("A"), n(2.0)]));
    assert_eq!(post("TPRINT/'T1 10 MM'"), ("TPRINT".into(), vec![Arg::Text("T1 10 MM".into())]));
    assert_eq!(post("REWIND/2"), ("REWIND".into(), vec![n(2.0)]));
    let (word, args) = post("CLRSRF/PL");
    let Arg::Form { name, form } = &args[0] else { panic!("{args:?}") };
    assert_eq!((word.as_str(), name.name.as_str(), name.subscript), ("CLRSRF", "PL", 0));
    assert!(matches!(**form, Form::Plane(_)));
    let joined = kinds("RAPID,GOTO/P");
    assert!(matches!(&joined[0], Kind::Post { word, .. } if word == "RAPID"));
    assert!(matches!(joined[1], Kind::Goto(_)));
}

#[test]
fn unknown_post_words_pass_with_a_warning() {
    let ran = run("HYDRAU/ON,12,LOUD\nFINI\n");
    assert_eq!(ran.told(), [(1301, 1)]);
    assert!(!ran.diagnostics[0].is_error());
    let args = vec![Arg::Word("ON".into()), Arg::Number(12.0), Arg::Word("LOUD".into())];
    assert_eq!(ran.kinds(), [&Kind::Post { word: "HYDRAU".into(), args }]);
}

#[test]
fn texts() {
    let text = |word: &str, text: &str| Kind::Text { word: word.into(), text: text.into() };
    let ran = clean(
        "PARTNO  A PART $$ MORE\nPPRINT**7/32 EM**\nINSERTG0G49\nREMARK NOTHING\n\
         PARTNO/'QUOTED, TEXT'\nFINI\n",
    );
    assert_eq!(
        ran.kinds(),
        [
            &text("PARTNO", "A PART $$ MORE"),
            &text("PPRINT", "**7/32 EM**"),
            &text("INSERT", "G0G49"),
            &text("PARTNO", "QUOTED, TEXT")
        ]
    );
}

#[test]
fn regional_words_pass_in_order() {
    let kind = kind("SCON/AXIS,V,PLUS");
    let Kind::Regional { word, args } = &kind else { panic!("{kind:?}") };
    assert_eq!(word, "SCON");
    assert_eq!(args[0], Arg::Word("AXIS".into()));
    assert!(matches!(&args[1], Arg::Form { .. }));
    assert_eq!(args[2], Arg::Word("PLUS".into()));
}

#[test]
fn what_moves_the_tool_and_fails_says_so() {
    for statement in ["GOTO/NOWHER", "GOLFT/L1,TO,P", "CUTTER/-1", "PSIS/P", "GOLTF/L1", "CALL/X"] {
        let ran = run(&format!("{FORMS}{statement}\nFINI\n"));
        assert_eq!(ran.diagnostics.len(), 1, "{statement}\n{}", ran.messages());
        assert_eq!(ran.kinds(), [&Kind::Failed], "{statement}");
    }
}

#[test]
fn definitions_come_with_their_names() {
    let ran = clean("RESERV/Q,2\nQ(2)=POINT/1,2\nL=LINE/(P=POINT/0,0),Q(2)\nFINI\n");
    let names: Vec<_> = ran
        .records
        .iter()
        .filter_map(|r| match &r.kind {
            Kind::Define { name, form } => {
                Some((name.name.to_string(), name.subscript, form.kind().word()))
            }
            _ => None,
        })
        .collect();
    let named = |n: &str, i, w| (n.to_owned(), i, w);
    assert_eq!(names, [named("Q", 2, "POINT"), named("P", 0, "POINT"), named("L", 0, "LINE")]);
}

/// A word that labels a statement is a label behind its check surface, and a relation stays one.
#[test]
fn a_word_may_be_a_label() {
    let text = format!(
        "{FORMS}FROM/0,0,0\nGOFWD/L1,TO,L2,UP,PAST,L3,NXT\nUP) GOTO/1,1,1\nNXT) GOTO/2,2,2\nFINI\n"
    );
    let kinds = clean(&text).kinds().into_iter().cloned().collect::<Vec<_>>();
    let drive = kinds.iter().find_map(|k| match k {
        Kind::Drive(d) => Some(d),
        _ => None,
    });
    let checks = &drive.expect("a motion").checks;
    assert_eq!(checks.len(), 2);
    assert!(checks.iter().all(|c| c.branch));
    assert_eq!(checks[1].relation, Relation::Past);
}

#[test]
fn numbers_that_a_disk_cannot_have() {
    for (statement, column, code) in [
        ("CUTTER/OPTION,3,5,2", 15, "APT1304"),
        ("CUTTER/OPTION,1,-5,2", 17, "APT1306"),
        ("CUTTER/OPTION,1,5,-2", 19, "APT1306"),
    ] {
        let ran = run(&format!("{statement}\nFINI\n"));
        assert_eq!(ran.diagnostics.len(), 1, "{statement}\n{}", ran.messages());
        let d = &ran.diagnostics[0];
        assert_eq!(
            (d.span.start, d.code.to_string().as_str()),
            (column - 1, code),
            "{}",
            ran.messages()
        );
    }
}
