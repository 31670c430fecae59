//! Rapid motion beside regional milling, by closed forms.

#[path = "support/controlled.rs"]
mod controlled;
mod support;

use std::sync::Arc;

use aptc_cldata::milling::{Milling, Plain};
use aptc_cldata::{Control, Kind, Motion, MotionKind, NameRef, Position, Record, Relation};
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::{
    Cone, Cutter, Cylinder, Form, Plane, Quadric, QuadricKind, Sculptured, Sphere, Vec3, trig,
};
use aptc_verify::{Certificate, Effort, Verifier};
use controlled::controlled;
use support::{BAND, milled, milling};

const RADIUS: f64 = 5.0;
/// Height of the ridge along y, at x = 10, over a square of 20.
const HIGH: f64 = 8.0;

fn square(z: impl Fn(f64, f64) -> f64) -> Arc<Sculptured> {
    support::square(8, z)
}

fn flat() -> Arc<Sculptured> {
    square(|_, _| 0.0)
}

fn ridge() -> Arc<Sculptured> {
    square(|x, _| 0.5 * HIGH * (1.0 - trig::cos(0.1 * std::f64::consts::PI * x)))
}

fn record(kind: Kind) -> Record {
    Record { origin: Origin::default(), kind }
}

fn motion(kind: MotionKind, control: Option<Control>, points: &[[f64; 3]]) -> Record {
    let points = points.iter().map(|p| Position::upright(Vec3::from(*p))).collect();
    record(Kind::Motion(Motion {
        kind,
        points,
        control: control.map(Arc::new),
        ..Motion::default()
    }))
}

fn along(milling: Milling, points: &[[f64; 3]]) -> Record {
    let control = Control { milling: Some(milling), ..Control::default() };
    motion(MotionKind::Continuous, Some(control), points)
}

fn goto(points: &[[f64; 3]]) -> Record {
    motion(MotionKind::Goto, None, points)
}

fn rapid() -> Record {
    record(Kind::Post { word: "RAPID".into(), args: Vec::new() })
}

fn judge(records: &[Record]) -> (Certificate, Vec<Diagnostic>) {
    let mut verifier = Verifier::new(Effort::Full);
    verifier.push(&record(Kind::Cutter(Cutter::mill(2.0 * RADIUS, RADIUS, 40.0))));
    records.iter().for_each(|r| verifier.push(r));
    verifier.finish()
}

fn told(records: &[Record]) -> Vec<u16> {
    judge(records).1.iter().map(|d| d.code.number()).collect()
}

const CUT: [u16; 1] = [codes::RAPID_CUT.number()];
/// A place of the flat square, and one high over it.
const ON: [f64; 3] = [2.0, 10.0, 0.0];
const OVER: [f64; 3] = [2.0, 10.0, 50.0];

#[test]
fn a_rapid_through_the_part_after_and_before_regional_milling_is_told_with_its_depth() {
    for side in [1.0, -1.0] {
        let mill = || along(milling(Some(milled("FLOOR", &flat(), side, 0.0))), &[ON]);
        let deep = 3.0;
        let ways = [
            // Down, through and up again; and beyond the ends of the surface nothing is cut.
            (vec![OVER, [10.0, 10.0, -deep], [18.0, 10.0, 50.0]], true),
            (vec![OVER, [10.0, 40.0, -deep], [18.0, 40.0, 50.0]], false),
            (vec![OVER, [10.0, 10.0, 0.0], [18.0, 10.0, 50.0]], false),
        ];
        for (way, cuts) in ways {
            let after = [mill(), rapid(), goto(&way)];
            let before = [goto(&way[..1]), rapid(), goto(&way), mill()];
            for records in [&after[..], &before[..]] {
                let (c, said) = judge(records);
                if !cuts {
                    assert!(c.is_proved() && said.is_empty(), "{said:?}");
                    continue;
                }
                let [cut] = &c.rapids[..] else { panic!("{:?}", c.rapids) };
                assert!(!c.is_proved() && cut.surface == "part surface FLOOR", "{cut:?}");
                let beyond = deep - BAND;
                assert!(cut.depth > 0.85 * beyond && cut.depth < beyond + 1e-9, "{cut:?}");
                assert!((cut.te[0] - 10.0).abs() < 1.0 && cut.te[2] < -0.8 * deep, "{cut:?}");
                assert_eq!(said.iter().map(|d| d.code.number()).collect::<Vec<_>>(), CUT);
            }
        }
    }
}

/// Up along the axis, out of what it began deeper in, over a thickness, or beside a tool end that is led on the surface it cuts nothing.
#[test]
fn what_a_rapid_leaves_is_no_cut() {
    let on_ridge = |on: bool, thick: f64, at: [f64; 3]| {
        along(Milling { on, ..milling(Some(milled("RIDGE", &ridge(), 1.0, thick))) }, &[at])
    };
    // Half way up the ridge the tool end is on it, and the ball in it by what the slope makes.
    let half = [5.0, 10.0, 0.5 * HIGH];
    let up = [5.0, 10.0, 40.0];
    let free = |records: &[Record]| {
        let said = judge(records).1;
        assert!(said.iter().all(|d| d.code != codes::RAPID_CUT), "{said:?}");
    };
    free(&[on_ridge(true, 0.0, half), rapid(), goto(&[up])]);
    free(&[
        on_ridge(true, 0.0, half),
        rapid(),
        goto(&[up]),
        rapid(),
        goto(&[half]),
        on_ridge(true, 0.0, half),
    ]);
    // Down from the ridge it gets no deeper than it began.
    free(&[on_ridge(true, 0.0, half), rapid(), goto(&[[-20.0, 10.0, 0.5 * HIGH]])]);
    // A tool end below the surface is as deep as no slope makes it.
    let low = [5.0, 10.0, 0.1 * HIGH];
    let plunge = [on_ridge(true, 0.0, half), rapid(), goto(&[up]), rapid(), goto(&[low])];
    assert!(!told(&plunge).is_empty());
    // With a negative thickness the tool may be in it by that.
    let low = |z: f64| {
        [goto(&[OVER]), rapid(), goto(&[OVER, [10.0, 10.0, HIGH - z], [18.0, 10.0, 50.0]])]
    };
    let with = |z: f64, thick: f64| {
        let all = [&low(z)[..], &[on_ridge(false, thick, [10.0, 10.0, HIGH + thick])]].concat();
        told(&all)
    };
    assert_eq!(with(0.9, -1.0), [0_u16; 0]);
    assert_eq!(with(1.2, -1.0), CUT);
    assert_eq!(with(-1.1, 1.0), [0_u16; 0]);
    assert_eq!(with(-0.9, 1.0), CUT);
}

/// A tool through whose axis the surface goes where it ends is nowhere deeper in it as a sheet: it is through it higher up.
#[test]
fn a_rapid_through_a_ridge_that_ends_in_its_foot_is_told() {
    let mill = |at: [f64; 3]| along(milling(Some(milled("RIDGE", &ridge(), 1.0, 0.0))), &[at]);
    let crest = [10.0, 0.0, HIGH];
    let begin = [-10.0, 10.0, -8.0];
    let (through, up) = ([19.0, 10.0, -8.0], [19.0, 10.0, 50.0]);
    let over = [10.0, 10.0, 50.0];
    let records =
        |way: &[[f64; 3]]| vec![goto(&[over, begin]), rapid(), goto(way), goto(&[up]), mill(crest)];
    assert_eq!(told(&records(&[through])), CUT);
    // Round it nothing is.
    let round = [
        [-10.0, -20.0, -8.0],
        [19.0, -20.0, -8.0],
        [19.0, -20.0, 50.0],
        [19.0, 10.0, 50.0],
        through,
    ];
    assert_eq!(told(&records(&round)), [0_u16; 0]);
}

#[test]
fn what_is_checked_is_held_too_and_an_older_surface_no_more() {
    let wall = square(|x, _| 2.0 * x);
    let mut with = milling(Some(milled("FLOOR", &flat(), 1.0, 0.0)));
    with.checked.push(milled("WALL", &wall, 1.0, 0.0));
    let through = goto(&[[2.0, 10.0, 30.0], [18.0, 10.0, 6.0], [40.0, 10.0, 6.0]]);
    let (c, _) =
        judge(&[goto(&[OVER]), along(with, &[[2.0, 40.0, 0.0]]), rapid(), through.clone()]);
    assert!(c.rapids.len() == 1 && c.rapids[0].surface == "checked surface WALL", "{c:?}");
    // An ordinary motion before, along a plane above: regional milling goes on below it.
    let over = Form::Plane(Plane::new(Vec3::z(), 20.0).expect("a normal"));
    let high = controlled("HIGH", over, Relation::To, 1);
    let control = Control { part: Some(high), ..Control::default() };
    let first = motion(MotionKind::Continuous, Some(control), &[[2.0, 10.0, 20.0]]);
    let below = goto(&[[2.0, 10.0, 2.0], [18.0, 10.0, 2.0]]);
    let mill = || along(milling(Some(milled("FLOOR", &flat(), 1.0, 0.0))), &[ON]);
    let low = [codes::RAPID_ENDS_LOW.number()];
    assert_eq!(told(&[first.clone(), rapid(), below.clone(), goto(&[OVER])]), low);
    assert_eq!(told(&[first.clone(), mill(), rapid(), below.clone()]), [0_u16; 0]);
    // A tool end that is led away from its surface leaves that where it was.
    let deep = square(|_, _| -30.0);
    let away = Milling { checked: vec![milled("DEEP", &deep, 1.0, 0.0)], ..milling(None) };
    let away = along(away, &[[2.0, 60.0, 9.0]]);
    let down = goto(&[OVER, [10.0, 10.0, -3.0], [10.0, 60.0, -3.0]]);
    let (c, _) = judge(&[mill(), away, rapid(), down]);
    assert!(c.rapids.len() == 1 && c.rapids[0].surface == "part surface FLOOR", "{c:?}");
}

/// RAPID before regional milling itself is for the way to its first place.
#[test]
fn the_way_to_the_first_place_at_rapid_is_told_once() {
    let begin = [-20.0, 10.0, 1.0];
    let end = [20.0, 10.0, 6.0];
    let mill =
        |guarded: bool| Milling { guarded, ..milling(Some(milled("RIDGE", &ridge(), 1.0, 0.0))) };
    let over = [[-20.0, 10.0, 40.0], [20.0, 10.0, 40.0]];
    for (from, cuts) in [(vec![begin], true), (over.to_vec(), false)] {
        let records = |m: Milling| [goto(&from), rapid(), along(m, &[end])];
        let said = told(&records(mill(false)));
        assert_eq!(said.len(), usize::from(cuts), "{said:?}");
        assert!(said.iter().all(|c| CUT.contains(c)));
        // What CHKSRF/PS holds it against is told there.
        let said = told(&records(mill(true)));
        assert_eq!(said, if cuts { vec![codes::REFUTED.number()] } else { Vec::new() });
    }
}

#[test]
fn rapid_is_for_all_of_a_motion_along_surfaces_which_is_told() {
    let on = |x: f64| [x, 10.0, 0.0];
    let mill =
        |points: &[[f64; 3]]| along(milling(Some(milled("FLOOR", &flat(), 1.0, 0.0))), points);
    let to = |n: usize| {
        let said = judge(&[goto(&[OVER]), rapid(), mill(&[on(2.0), on(5.0), on(9.0)][..n])]).1;
        said.into_iter().map(|d| (d.code, d.message)).collect::<Vec<_>>()
    };
    // Its first vector is the way to where it begins.
    assert!(to(1).is_empty());
    let all = "RAPID is for all of the first path: its 2 cut vectors go along part surface FLOOR at rapid";
    assert_eq!(to(3), [(codes::RAPID_ALONG, all.to_owned())]);
    assert!(
        told(&[goto(&[OVER]), rapid(), goto(&[on(2.0)]), mill(&[on(2.0), on(5.0)])]).is_empty()
    );
}

/// Through the hill at feed is no cut at rapid, and it is not silent.
#[test]
fn the_way_at_feed_to_the_first_place_is_held_against_the_part_surface() {
    let mill =
        |x: f64| along(milling(Some(milled("RIDGE", &ridge(), 1.0, 0.0))), &[[x, 10.0, 0.0]]);
    let foot = [-6.0, 10.0, 0.0];
    let through = judge(&[goto(&[foot]), mill(25.0)]);
    let [d] = &through.1[..] else { panic!("{:?}", through.1) };
    assert!(through.0.rapids.is_empty() && d.code == codes::THROUGH, "{d:?}");
    assert!(d.message.contains("part surface RIDGE by 4.99"), "{}", d.message);
    // From above, beside it, and where it is checked, for then the way is refuted.
    assert!(told(&[goto(&[[25.0, 10.0, 50.0]]), mill(25.0)]).is_empty());
    assert!(told(&[goto(&[[25.0, 40.0, 0.0]]), mill(25.0)]).is_empty());
    let guarded = Milling { guarded: true, ..milling(Some(milled("RIDGE", &ridge(), 1.0, 0.0))) };
    let guarded = told(&[goto(&[foot]), along(guarded, &[[25.0, 10.0, 0.0]])]);
    assert_eq!(guarded, [codes::REFUTED.number()]);
}

/// Beside the floor, in front of it along x: what CHKSRF names. The middle of the ball is 5 above the tool end.
fn beside(form: Form, thick: f64) -> Milling {
    let name = NameRef { name: "K".into(), subscript: 0 };
    let mut with = milling(Some(milled("FLOOR", &flat(), 1.0, 0.0)));
    with.plain.push(Plain { name, form: Arc::new(form), thick });
    with
}

fn ball() -> Form {
    Form::Sphere(Sphere { center: Vec3::new(40.0, 10.0, 6.0), radius: 8.0 })
}

fn bar(axis: Vec3) -> Form {
    Form::Cylinder(Cylinder { point: Vec3::new(40.0, 10.0, 6.0), axis, radius: 8.0 })
}

/// With half axes 8, 30 and 8 about the middle of the ball.
fn egg() -> Form {
    let (a, b) = (1.0 / 64.0, 1.0 / 900.0);
    let middle = [40.0, 10.0, 6.0];
    let [g, h, i] = [a * middle[0], b * middle[1], a * middle[2]];
    let d = a * 40.0 * 40.0 + b * 100.0 + a * 36.0 - 1.0;
    let c = [a, b, a, d, 0.0, 0.0, 0.0, -g, -h, -i];
    Form::Quadric(Quadric { kind: QuadricKind::Qadric, c })
}

/// It opens downwards at 45 degrees.
fn cone(z: f64) -> Form {
    let cos_half = 0.5_f64.sqrt();
    Form::Cone(Cone { vertex: Vec3::new(40.0, 10.0, z), axis: -Vec3::z(), cos_half })
}

#[test]
fn a_rapid_into_what_is_checked_beside_the_part_is_told_with_its_depth() {
    let low = [[2.0, 10.0, 9.0], [80.0, 10.0, 9.0], [80.0, 10.0, 50.0]];
    let lower = [[2.0, 10.0, 0.0], [80.0, 10.0, 0.0], [80.0, 10.0, 50.0]];
    let to_wall = [[2.0, 10.0, 0.0], [33.0, 10.0, 0.0], [2.0, 10.0, 0.0]];
    let dip = [[60.0, 10.0, 20.0], [60.0, 10.0, -4.0], [60.0, 10.0, 20.0]];
    let plane = |n, d| Form::Plane(Plane::new(n, d).expect("a normal"));
    for (form, thick, way, deep) in [
        // It goes over the middle of each at a height of 14, and is 5 thick.
        (ball(), 0.0, low, 5.0),
        (ball(), 1.0, low, 6.0),
        (bar(Vec3::y()), 0.0, low, 5.0),
        (egg(), 0.0, low, 5.0),
        // Its middle comes to the axis of the post, and 8 beyond the wall; it dips 4 into the table.
        (bar(Vec3::z()), 0.0, lower, 13.0),
        (plane(Vec3::x(), 30.0), 0.0, to_wall, 8.0),
        (plane(-Vec3::x(), -30.0), -1.0, to_wall, 7.0),
        (plane(Vec3::z(), 0.0), 0.0, dip, 4.0),
        // The middle of the ball comes to (20 - 14) / sqrt 2 within the cone.
        (cone(20.0), 0.0, low, 5.0 + 6.0 * 0.5_f64.sqrt()),
    ] {
        let mill = || along(beside(form.clone(), thick), &[ON]);
        let after = [goto(&[OVER]), mill(), rapid(), goto(&way)];
        let back: Vec<_> = way.iter().rev().copied().collect();
        let before = [goto(&back[..1]), rapid(), goto(&back), goto(&[OVER]), mill()];
        for records in [&after[..], &before[..]] {
            let (c, said) = judge(records);
            let [cut] = &c.rapids[..] else { panic!("{:?} {said:?} {form:?}", c.rapids) };
            assert!(!c.is_proved() && cut.surface == "checked surface K", "{cut:?}");
            let beyond = deep - BAND;
            assert!(cut.depth > 0.85 * beyond && cut.depth < beyond + 1e-6, "{cut:?} {form:?}");
            assert_eq!(said.iter().map(|d| d.code.number()).collect::<Vec<_>>(), CUT);
        }
    }
}

/// What goes on without end is not known to stand higher than the milling went, and beyond it nobody says that the tool may not be.
#[test]
fn a_rapid_over_what_is_checked_or_out_of_it_is_not_told() {
    let plane = |n, d| Form::Plane(Plane::new(n, d).expect("a normal"));
    let over = [[2.0, 10.0, 20.0], [80.0, 10.0, 20.0], [80.0, 10.0, 50.0]];
    let across = [[2.0, 10.0, 1.0], [80.0, 10.0, 1.0]];
    // In a bowl and a trough that are open above.
    let bowl = Form::Sphere(Sphere { center: Vec3::new(2.0, 10.0, 40.0), radius: 60.0 });
    let trough = Cylinder { point: Vec3::new(2.0, 0.0, 40.0), axis: Vec3::y(), radius: 60.0 };
    for (form, way) in [
        (ball(), &over[..]),
        (bar(Vec3::y()), &over),
        (egg(), &over),
        (bar(Vec3::z()), &over),
        (bar(Vec3::z()), &across),
        (plane(Vec3::x(), 30.0), &over),
        (plane(Vec3::x(), 30.0), &across),
        (plane(Vec3::z(), -1.0), &across),
        (cone(6.0), &over),
        (bowl, &over),
        (Form::Cylinder(trough), &over),
    ] {
        let mill = || along(beside(form.clone(), 0.0), &[ON]);
        let after = [goto(&[OVER]), mill(), rapid(), goto(way)];
        let back: Vec<_> = way.iter().rev().copied().collect();
        let before = [goto(&back[..1]), rapid(), goto(&back), goto(&[OVER]), mill()];
        for records in [&after[..], &before[..]] {
            assert_eq!(told(records), [0_u16; 0], "{form:?}");
        }
    }
    // It ends behind the wall, as low as the milling went.
    let mill = along(beside(plane(Vec3::x(), 30.0), 0.0), &[ON]);
    let behind = [goto(&[OVER]), mill, rapid(), goto(&[[60.0, 10.0, 0.0]])];
    assert_eq!(told(&behind), [codes::RAPID_ENDS_LOW.number()]);
}
