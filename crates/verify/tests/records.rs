//! Streams of records as Section 2 makes them, good and bad.

#[path = "support/controlled.rs"]
mod controlled;

use std::f64::consts::PI;
use std::sync::Arc;

use aptc_cldata::{
    Arg, Control, Controlled, Kind, Motion, MotionKind, NameRef, Position, Record, Relation,
};
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::{Cutter, Cylinder, Form, Plane, Sphere, Vec3, trig};
use aptc_verify::{Certificate, Effort, Verifier};
use controlled::controlled;

const BAND: f64 = 0.01;

fn plane(x: f64, y: f64, z: f64, d: f64) -> Form {
    Form::Plane(Plane::new(Vec3::new(x, y, z), d).expect("a normal"))
}

/// Along the wall y = 0 on the floor z = 0 to the wall x = 100, cutter of 10.
fn control() -> Control {
    Control {
        drive: Some(controlled("WALL", plane(0.0, 1.0, 0.0, 0.0), Relation::To, 1)),
        part: Some(controlled("FLOOR", plane(0.0, 0.0, 1.0, 0.0), Relation::On, 0)),
        checks: vec![controlled("END", plane(1.0, 0.0, 0.0, 100.0), Relation::To, -1)],
        milling: None,
    }
}

fn record(kind: Kind) -> Record {
    Record { origin: Origin::default(), kind }
}

fn post(word: &str, args: Vec<Arg>) -> Record {
    record(Kind::Post { word: word.into(), args })
}

fn motion(kind: MotionKind, control: Option<&Arc<Control>>, points: &[[f64; 3]]) -> Record {
    record(Kind::Motion(Motion {
        kind,
        points: points.iter().map(|p| Position::upright(Vec3::from(*p))).collect(),
        control: control.map(Arc::clone),
        ..Motion::default()
    }))
}

fn along(control: &Arc<Control>, points: &[[f64; 3]]) -> Vec<Record> {
    vec![
        record(Kind::Cutter(Cutter::mill(10.0, 0.0, 30.0))),
        motion(MotionKind::From, None, &[[0.0, 5.0, 0.0]]),
        motion(MotionKind::Continuous, Some(control), points),
    ]
}

fn judge(records: &[Record]) -> (Certificate, Vec<Diagnostic>) {
    let mut verifier = Verifier::new(Effort::Full);
    for r in records {
        verifier.push(r);
    }
    verifier.finish()
}

fn codes_of(list: &[Diagnostic]) -> Vec<u16> {
    list.iter().map(|d| d.code.number()).collect()
}

#[test]
fn a_good_path_is_proved_and_bounded() {
    let (c, said) = judge(&along(&Arc::new(control()), &[[40.0, 5.0, 0.0], [95.0, 5.005, 0.0]]));
    assert!(c.is_proved() && c.proved == 2 && said.is_empty(), "{c} {said:?}");
    let drive = &c.statements[0].surfaces[0];
    assert!(drive.least.abs() < 1e-12 && (drive.most - 0.005).abs() < 1e-12, "{drive:?}");
}

#[test]
fn a_check_surface_that_is_overrun_or_not_reached() {
    for (x, gouge) in [(95.0 + 3.0 * BAND, true), (95.0 - 3.0 * BAND, false)] {
        let (c, said) = judge(&along(&Arc::new(control()), &[[40.0, 5.0, 0.0], [x, 5.0, 0.0]]));
        assert_eq!((c.proved, c.refuted), (1, 1));
        let fault = c.statements[0].fault.as_ref().unwrap();
        assert!((fault.depth - 2.0 * BAND).abs() < 1e-9 && fault.gouge == gouge, "{fault:?}");
        assert!(fault.surface.contains("END") && fault.vector == 2);
        assert_eq!(codes_of(&said), [codes::REFUTED.number()]);
    }
}

#[test]
fn a_check_surface_that_is_passed_on_the_way() {
    // To x = 120 and back to where it shall end.
    let path = [[120.0, 5.0, 0.0], [95.0, 5.0, 0.0]];
    let (c, _) = judge(&along(&Arc::new(control()), &path));
    let fault = c.statements[0].fault.clone().unwrap();
    assert!(c.refuted == 2 && (fault.depth - 25.0 + BAND).abs() < 1e-9, "{fault:?}");
    assert!((fault.te[0] - 120.0).abs() < 1e-9);
    // The second meeting is allowed to be behind the first.
    let mut second = control();
    second.checks[0].nth = 2;
    assert!(judge(&along(&Arc::new(second), &path)).0.is_proved());
    // Beyond the tool end for ON, beyond the far side for PAST.
    for (relation, side, x) in [(Relation::On, 0, 100.0), (Relation::Past, 1, 105.0)] {
        let mut other = control();
        other.checks[0].relation = relation;
        other.checks[0].side = side;
        let other = Arc::new(other);
        assert!(judge(&along(&other, &[[50.0, 5.0, 0.0], [x, 5.0, 0.0]])).0.is_proved());
        let (c, _) = judge(&along(&other, &[[x + 8.0, 5.0, 0.0], [x, 5.0, 0.0]]));
        let fault = c.statements[0].fault.clone().unwrap();
        assert!(c.refuted > 0 && (fault.depth - 8.0 + BAND).abs() < 1e-9, "{fault:?}");
    }
}

#[test]
fn a_motion_in_two_records_is_one() {
    // A slow-down before the check surface parts the motion.
    let control = Arc::new(control());
    let mut records = along(&control, &[[90.0, 5.0, 0.0]]);
    records.push(post("FEDRAT", vec![Arg::Number(50.0)]));
    records.push(motion(MotionKind::Continuous, Some(&control), &[[95.0, 5.0, 0.0]]));
    let (c, said) = judge(&records);
    assert!(c.is_proved() && c.statements.len() == 1 && c.statements[0].vectors == 2, "{said:?}");
}

#[test]
fn a_rapid_through_the_part_is_told_with_its_depth() {
    let control = Arc::new(control());
    let good = along(&control, &[[95.0, 5.0, 0.0]]);
    let through = [[50.0, 50.0, -7.0], [0.0, 50.0, 20.0]];
    let mut after = good.clone();
    after.push(post("RAPID", vec![]));
    after.push(motion(MotionKind::Goto, None, &through));
    let mut before = vec![good[0].clone(), good[1].clone(), post("RAPID", vec![])];
    before.push(motion(MotionKind::Goto, None, &through));
    before.extend_from_slice(&good[1..]);
    for records in [after, before] {
        let (c, said) = judge(&records);
        assert_eq!((c.free, c.proved), (2, 1));
        let [cut] = &c.rapids[..] else { panic!("{:?}", c.rapids) };
        assert!(c.rapid_cuts == 1 && !c.is_proved() && (cut.depth - 6.99).abs() < 1e-9, "{cut:?}");
        assert_eq!((cut.te, cut.point), ([50.0, 50.0, -7.0], 1));
        assert!(c.to_string().ends_with("; 1 cut at rapid"), "{c}");
        assert_eq!(codes_of(&said), [codes::RAPID_CUT.number()], "{said:?}");
        assert!(said[0].is_error() && said[0].message.contains("6.990000"), "{}", said[0].message);
        assert!(said[0].message.contains("50.00000, 50.00000, -7.00000"), "{}", said[0].message);
    }
    // So is one that ends in the part, when the next motion is no deeper.
    let mut into = good.clone();
    into.push(post("RAPID", vec![]));
    into.push(motion(MotionKind::Goto, None, &[[50.0, 50.0, 20.0], [50.0, 50.0, -7.0]]));
    assert_eq!(codes_of(&judge(&into).1), [codes::RAPID_ENDS_LOW.number()]);
    into.push(motion(MotionKind::Goto, None, &[[0.0, 5.0, 0.0]]));
    into.push(good[2].clone());
    assert_eq!(codes_of(&judge(&into).1), [codes::RAPID_CUT.number()]);
    let mut deeper = (*control).clone();
    deeper.part = Some(controlled("LOW", plane(0.0, 0.0, 1.0, -8.0), Relation::On, 0));
    let deeper = Arc::new(deeper);
    into.truncate(5);
    into.push(motion(MotionKind::Goto, None, &[[0.0, 5.0, -8.0]]));
    into.push(motion(MotionKind::Continuous, Some(&deeper), &[[95.0, 5.0, -8.0]]));
    assert!(judge(&into).1.is_empty());
    // RAPID before FROM is over there.
    let mut from = good.clone();
    from.push(post("RAPID", vec![]));
    from.push(motion(MotionKind::From, None, &[[50.0, 50.0, 20.0]]));
    from.push(motion(MotionKind::Goto, None, &through));
    assert!(judge(&from).1.is_empty());
    // At feed it is a plunge, and above the part nothing is cut.
    let mut feed = good.clone();
    feed.push(motion(MotionKind::Goto, None, &through));
    let mut above = good;
    above.push(post("RAPID", vec![]));
    above.push(motion(MotionKind::Goto, None, &[[50.0, 50.0, 7.0]]));
    for records in [feed, above] {
        assert!(judge(&records).1.is_empty());
    }
}

#[test]
fn a_rapid_that_ends_below_the_floor_is_told_where_nothing_goes_as_deep() {
    let control = Arc::new(control());
    let rapid = |te: [f64; 3]| [post("RAPID", vec![]), motion(MotionKind::Goto, None, &[te])];
    let feed = |te: [f64; 3]| motion(MotionKind::Goto, None, &[te]);
    let said = |more: &[Record]| {
        let (c, said) = judge(&[&along(&control, &[[95.0, 5.0, 0.0]]), more].concat());
        assert!(c.is_proved() && c.rapid_cuts == 0 && said.iter().all(|d| !d.is_error()), "{c}");
        said
    };
    let low = codes::RAPID_ENDS_LOW.number();
    // Of two that go down one after the other the last is told, with its place.
    let down = [rapid([39.0, 5.0, -2.0]), rapid([100.0, 100.0, -5.0])].concat();
    let told = said(&down);
    assert_eq!(codes_of(&told), [low]);
    assert!(told[0].message.contains("ends 4.990000 below"), "{}", told[0].message);
    assert!(told[0].message.contains("100.00000, 100.00000, -5.00000"), "{}", told[0].message);
    // Up again, at rapid or at feed, nothing was done there.
    let up = [100.0, 100.0, 30.0];
    assert_eq!(codes_of(&said(&[&down[..], &rapid(up)].concat())), [low]);
    assert_eq!(codes_of(&said(&[&down[..], &[feed(up)]].concat())), [low]);
    // Beside the part the tool works as deep, and deeper.
    for z in [-5.0, -9.0] {
        let works = [&down[..], &[feed([150.0, 100.0, z]), feed(up)], &rapid(up)].concat();
        assert!(said(&works).is_empty());
    }
    assert_eq!(codes_of(&said(&[&down[..], &[feed([150.0, 100.0, -4.0])]].concat())), [low]);
    // A cycle does what it does there.
    let mut drilled = down.clone();
    drilled.insert(0, post("CYCLE", vec![Arg::Word("DRILL".into())]));
    assert!(said(&drilled).is_empty());
    drilled.insert(1, post("CYCLE", vec![Arg::Word("OFF".into())]));
    assert_eq!(codes_of(&said(&drilled)), [low]);
    // With another axis the tool is at another side of the part.
    let mut turned = down;
    for record in &mut turned {
        if let Kind::Motion(m) = &mut record.kind {
            m.points.iter_mut().for_each(|p| p.ta = Vec3::x());
        }
    }
    turned.push(post("RAPID", vec![]));
    let away = said(&turned[2..]);
    assert!(away.is_empty(), "{away:?}");
}

#[test]
fn cut_vectors_whose_surfaces_are_not_known_are_not_taken_for_moves_from_point_to_point() {
    let mill = |points: &[[f64; 3]]| motion(MotionKind::Continuous, None, points);
    let records = [
        record(Kind::Cutter(Cutter::mill(10.0, 5.0, 30.0))),
        motion(MotionKind::Goto, None, &[[0.0, 0.0, 5.0]]),
        mill(&[[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]),
        mill(&[[3.0, 0.0, 0.0]]),
    ];
    let (c, said) = judge(&records);
    assert_eq!((c.free, c.undecided, c.statements.len()), (1, 3, 1));
    assert!(!c.is_proved() && c.statements[0].vectors == 3);
    assert_eq!(codes_of(&said), [codes::UNPROVED.number()]);
    assert_eq!(
        c.to_string(),
        "0 of 3 cut vectors along surfaces proved, 3 not decided; 1 from point to point"
    );
}

#[test]
fn a_rapid_below_the_clearance_plane_is_told() {
    let high = Arg::Form { name: NameRef::default(), form: Arc::new(plane(0.0, 0.0, 1.0, 25.0)) };
    let to = |points: &[[f64; 3]]| {
        let records = [
            post("CLRSRF", vec![high.clone()]),
            motion(MotionKind::From, None, &[[0.0, 0.0, 30.0]]),
            post("RAPID", vec![]),
            motion(MotionKind::Goto, None, points),
        ];
        codes_of(&judge(&records).1)
    };
    assert_eq!(to(&[[50.0, 0.0, 5.0]]), [codes::RAPID_LOW.number()]);
    assert!(to(&[[50.0, 0.0, 25.0], [50.0, 0.0, 5.0]]).is_empty());
}

#[test]
fn a_disk_is_proved_and_the_real_cutter_warned_of() {
    // Between floor z = 0 and a roof that the disk clears and the cutter of 30 does not.
    let mut low = control();
    let roof = Form::Cylinder(Cylinder {
        point: Vec3::new(0.0, 0.0, 35.0),
        axis: Vec3::x(),
        radius: 15.0,
    });
    low.drive = Some(Controlled {
        disk: Some([5.0, 20.0]),
        outtol: 100.0,
        ..controlled("ROOF", roof, Relation::To, 1)
    });
    let (c, said) = judge(&along(&Arc::new(low), &[[50.0, 5.0, 0.0], [95.0, 5.0, 0.0]]));
    assert!(c.is_proved(), "{c}");
    assert_eq!(codes_of(&said), [codes::REAL_CUTTER.number()]);
    assert!(!said[0].is_error());
}

/// A disk in a hollow of 300, its axis the normal, then with the surface on that side of it and the axis turned so far in place.
fn goes_over(turned: f64, sides: [i8; 2]) -> Option<bool> {
    let hollow = Form::Sphere(Sphere { center: Vec3::new(0.0, 0.0, 300.0), radius: 300.0 });
    let held = |side: i8, at: f64| Control {
        drive: Some(controlled("MIDDLE", plane(0.0, 1.0, 0.0, 0.0), Relation::On, 0)),
        part: Some(Controlled {
            disk: Some([1.0, 0.0]),
            ..controlled("HOLLOW", hollow.clone(), Relation::To, side)
        }),
        checks: vec![controlled("END", plane(1.0, 0.0, 0.0, at), Relation::On, 0)],
        milling: None,
    };
    let to = |controls: &Arc<Control>, at: Vec<Position>| {
        let control = Some(Arc::clone(controls));
        let kind = MotionKind::Continuous;
        record(Kind::Motion(Motion { kind, points: at, control, ..Motion::default() }))
    };
    // Leaning by an angle, with the rim in the surface.
    let at = |x: f64, angle: f64| {
        let rise = x * x / 600.0 + trig::sin(angle).abs();
        let ta = Vec3::new(trig::sin(angle), 0.0, trig::cos(angle));
        Position { te: Vec3::new(x, 0.0, rise), ta }
    };
    let steps = (0..=20_u32).map(|k| at(0.0, turned * f64::from(k) / 20.0));
    let end = at(0.5, turned);
    let records = [
        record(Kind::Cutter(Cutter::mill(4.0, 0.0, 30.0))),
        motion(MotionKind::From, None, &[[-5.0, 0.0, 25.0 / 600.0]]),
        to(&Arc::new(held(sides[0], 0.0)), vec![at(0.0, 0.0)]),
        to(&Arc::new(held(sides[1], 0.5)), steps.chain([end]).collect()),
    ];
    let fault = judge(&records).0.statements.last()?.fault.clone()?;
    Some(fault.depth > 25.0 && fault.gouge && fault.why.is_some())
}

/// What holds of the disk holds of it as well that stands on its head, or on the other side.
#[test]
fn a_disk_does_not_lead_the_cutter_to_the_other_side() {
    assert_eq!(goes_over(0.0, [-1, -1]), None);
    assert_eq!(goes_over(0.0, [-1, 1]), Some(true));
    assert_eq!(goes_over(PI, [-1, 1]), Some(true));
    assert_eq!(goes_over(PI, [1, 1]), Some(true));
    // It was there before, from below.
    assert_eq!(goes_over(0.0, [1, 1]), None);
}

#[test]
fn a_rapid_straight_up_out_of_a_deeper_cut_is_free() {
    // The next motion has a higher floor; the tool leaves the lower one the way it came.
    let control = Arc::new(control());
    let mut records = vec![
        record(Kind::Cutter(Cutter::mill(10.0, 0.0, 30.0))),
        motion(MotionKind::From, None, &[[0.0, 50.0, -8.0]]),
        post("RAPID", vec![]),
        motion(MotionKind::Goto, None, &[[0.0, 50.0, 30.0]]),
    ];
    records.extend_from_slice(&along(&control, &[[95.0, 5.0, 0.0]])[1..]);
    assert!(judge(&records).1.is_empty());
    // Aside and deeper still, it is not.
    let aside = motion(MotionKind::Goto, None, &[[50.0, 50.0, -9.0], [50.0, 50.0, 30.0]]);
    records[3] = aside;
    assert_eq!(codes_of(&judge(&records).1), [codes::RAPID_CUT.number()]);
}

#[test]
fn after_a_retract_of_the_machine_a_rapid_begins_above() {
    let high = Arg::Form { name: NameRef::default(), form: Arc::new(plane(0.0, 0.0, 1.0, 25.0)) };
    let retracts = [
        post("CLRSRF", vec![Arg::Word("NOW".into())]),
        post("RETRCT", vec![]),
        post("LOADTL", vec![Arg::Number(2.0)]),
        post("CYCLE", vec![Arg::Word("OFF".into())]),
    ];
    for retract in retracts {
        let records = [
            post("CLRSRF", vec![high.clone()]),
            motion(MotionKind::From, None, &[[0.0, 0.0, 2.0]]),
            retract.clone(),
            post("RAPID", vec![]),
            motion(MotionKind::Goto, None, &[[50.0, 0.0, 25.0]]),
        ];
        assert!(judge(&records).1.is_empty(), "{retract:?}");
    }
}

#[test]
fn a_rapid_out_of_a_trough_is_no_cut_of_its_upper_half() {
    let trough = Form::Cylinder(Cylinder { point: Vec3::zeros(), axis: Vec3::x(), radius: 25.0 });
    let mut control = control();
    control.part = Some(controlled("TROUGH", trough, Relation::To, -1));
    control.drive = Some(controlled("MID", plane(0.0, 1.0, 0.0, 0.0), Relation::On, 0));
    let control = Arc::new(control);
    let mut records = vec![
        record(Kind::Cutter(Cutter::mill(10.0, 5.0, 15.0))),
        motion(MotionKind::From, None, &[[0.0, 0.0, -25.0]]),
        motion(MotionKind::Continuous, Some(&control), &[[95.0, 0.0, -25.0]]),
    ];
    records.push(post("RAPID", vec![]));
    records.push(motion(MotionKind::Goto, None, &[[95.0, 0.0, 40.0]]));
    assert!(judge(&records).1.is_empty());
}

/// The same along the wall in two motions, the first in a band of a hundred times the width with a cutter of that radius, by where the
/// second goes.
fn in_two_bands(radius: f64, second: &[[f64; 3]]) -> Option<(bool, u64)> {
    let mut wide = control();
    let drive = wide.drive.as_mut().expect("a drive surface");
    (drive.intol, drive.outtol) = (100.0 * BAND, 100.0 * BAND);
    wide.checks = vec![controlled("MIDDLE", plane(1.0, 0.0, 0.0, 50.0), Relation::On, 0)];
    let mut records = along(&Arc::new(wide), &[[50.0, 5.04, 0.0]]);
    records.insert(3, record(Kind::Cutter(Cutter::mill(2.0 * radius, 0.0, 30.0))));
    records.push(motion(MotionKind::Continuous, Some(&Arc::new(control())), second));
    let all = judge(&records).0.statements;
    all[1].fault.as_ref().map(|f| (f.refuted, f.vector))
}

#[test]
fn from_a_wider_band_a_short_vector_leads_into_the_next_one() {
    let end = [95.0, 5.0, 0.0];
    assert_eq!(in_two_bands(5.0, &[[50.1, 5.005, 0.0], end]), None);
    // It does not come into the band at once, takes its time, or goes farther out first.
    assert_eq!(in_two_bands(5.0, &[[50.1, 5.02, 0.0], end]), Some((true, 1)));
    assert_eq!(in_two_bands(5.0, &[[51.0, 5.005, 0.0], end]), Some((true, 1)));
    assert_eq!(in_two_bands(5.0, &[end]), Some((true, 1)));
    // The next one has to stay in it.
    assert_eq!(in_two_bands(5.0, &[[50.1, 5.005, 0.0], [60.0, 5.02, 0.0], end]), Some((true, 2)));
    // A cutter that the motion before did not have stands there by itself.
    assert_eq!(in_two_bands(5.06, &[[50.05, 5.06, 0.0], [94.94, 5.06, 0.0]]), Some((true, 1)));
}

/// Over a round part surface within the wider band, from a place in the narrower one: the chord cuts in.
#[test]
fn a_chord_that_dips_where_it_begins_in_its_own_band_is_no_way_into_it() {
    let round = Form::Cylinder(Cylinder {
        point: Vec3::new(0.0, 0.0, -50.0),
        axis: Vec3::y(),
        radius: 50.0,
    });
    let held = |band: f64, at: f64| Control {
        drive: Some(controlled("MIDDLE", plane(0.0, 1.0, 0.0, 0.0), Relation::On, 0)),
        part: Some(Controlled {
            intol: band,
            ..controlled("ROUND", round.clone(), Relation::To, 1)
        }),
        checks: vec![controlled("END", plane(1.0, 0.0, 0.0, at), Relation::On, 0)],
        milling: None,
    };
    // A ball of 10, its middle 55 from the axis.
    let over = |x: f64, higher: f64| [x, 0.0, f64::sqrt(55.0 * 55.0 - x * x) - 55.0 + higher];
    let judged = |begins: f64| {
        let records = [
            record(Kind::Cutter(Cutter::mill(10.0, 5.0, 30.0))),
            motion(MotionKind::From, None, &[over(-12.0, 0.0)]),
            motion(MotionKind::Continuous, Some(&Arc::new(held(1.0, -5.0))), &[over(-5.0, begins)]),
            motion(MotionKind::Continuous, Some(&Arc::new(held(BAND, 5.0))), &[over(5.0, 0.0)]),
        ];
        judge(&records).0.statements.last().and_then(|s| s.fault.clone()).map(|f| f.refuted)
    };
    for begins in [0.0, 0.005, -0.005, -0.02] {
        assert_eq!(judged(begins), Some(true), "{begins}");
    }
}
