//! Motion at feed from point to point between motions along surfaces, by closed forms.

#[path = "support/controlled.rs"]
mod controlled;
mod support;

use std::sync::Arc;

use aptc_cldata::milling::Milling;
use aptc_cldata::{Arg, Control, Kind, Motion, MotionKind, NameRef, Position, Record, Relation};
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::{Cutter, Form, Plane, Sculptured, Sphere, Vec3, trig};
use aptc_verify::{Certificate, Effort, Verifier};
use controlled::controlled;
use support::{BAND, milled, milling};

const RADIUS: f64 = 5.0;
/// Height of the ridge along y, at x = 10, over a square of 20.
const HIGH: f64 = 8.0;

fn ridge() -> Arc<Sculptured> {
    support::square(8, |x, _| 0.5 * HIGH * (1.0 - trig::cos(0.1 * std::f64::consts::PI * x)))
}

fn record(kind: Kind) -> Record {
    Record { origin: Origin::default(), kind }
}

fn word(word: &str, args: Vec<Arg>) -> Record {
    record(Kind::Post { word: word.into(), args })
}

fn motion(kind: MotionKind, control: Option<Control>, points: &[Position]) -> Record {
    let points = points.to_vec();
    record(Kind::Motion(Motion {
        kind,
        points,
        control: control.map(Arc::new),
        ..Motion::default()
    }))
}

/// The statement of a motion, by its number.
fn of(line: u32, mut record: Record) -> Record {
    record.origin.line = line;
    record
}

fn upright(p: [f64; 3]) -> Position {
    Position::upright(Vec3::from(p))
}

/// Goes to each place by a motion of its own.
fn goto(points: &[[f64; 3]]) -> Vec<Record> {
    points.iter().map(|p| motion(MotionKind::Goto, None, &[upright(*p)])).collect()
}

fn rapid() -> Vec<Record> {
    vec![word("RAPID", Vec::new())]
}

/// The arithmetic element along a part surface.
fn guided(name: &str, form: Form, points: &[[f64; 3]]) -> Vec<Record> {
    let part = controlled(name, form, Relation::To, 1);
    let control = Control { part: Some(part), ..Control::default() };
    let points: Vec<_> = points.iter().map(|p| upright(*p)).collect();
    vec![motion(MotionKind::Continuous, Some(control), &points)]
}

fn floor(z: f64) -> Form {
    Form::Plane(Plane::new(Vec3::z(), z).expect("a normal"))
}

/// Along the floor at a height, from x = 0 to 100, from above.
fn along(z: f64) -> Vec<Record> {
    let ends = [[0.0, 0.0, z], [100.0, 0.0, z]];
    let first = goto(&[[0.0, 0.0, z + 30.0], ends[0]]);
    [first, guided("FLOOR", floor(z), &ends)].concat()
}

fn mill(milling: Milling, at: [f64; 3]) -> Vec<Record> {
    let control = Control { milling: Some(milling), ..Control::default() };
    vec![motion(MotionKind::Continuous, Some(control), &[upright(at)])]
}

fn over_ridge(at: [f64; 3]) -> Vec<Record> {
    mill(milling(Some(milled("RIDGE", &ridge(), 1.0, 0.0))), at)
}

fn judge(parts: &[Vec<Record>]) -> (Certificate, Vec<Diagnostic>) {
    let mut verifier = Verifier::new(Effort::Full);
    verifier.push(&record(Kind::Cutter(Cutter::mill(2.0 * RADIUS, RADIUS, 40.0))));
    parts.iter().flatten().for_each(|r| verifier.push(r));
    verifier.finish()
}

fn told(parts: &[Vec<Record>]) -> Vec<u16> {
    judge(parts).1.iter().map(|d| d.code.number()).collect()
}

const FEED: [u16; 1] = [codes::FEED_CUT.number()];
const NOTHING: [u16; 0] = [];
/// Left and right of the ridge, at its foot, and over it.
const LEFT: [f64; 3] = [-6.0, 10.0, 0.0];
const RIGHT: [f64; 3] = [26.0, 10.0, 0.0];
const OVER: [f64; 3] = [10.0, 10.0, 50.0];

/// Straight through the ridge, which is higher than the ball: as deep as the middle of it.
#[test]
fn a_motion_at_feed_through_the_part_is_a_warning_with_its_depth_and_statement() {
    let high = |[x, y, _]: [f64; 3]| [x, y, 50.0];
    let through = || vec![of(7, goto(&[RIGHT]).remove(0))];
    let after = [goto(&[high(LEFT), LEFT]), over_ridge(LEFT), through(), goto(&[high(RIGHT)])];
    let before =
        [goto(&[LEFT]), through(), goto(&[high(RIGHT), OVER]), over_ridge([10.0, 10.0, HIGH])];
    for parts in [&after[..], &before[..]] {
        let (c, said) = judge(parts);
        let [d] = &said[..] else { panic!("{said:?}") };
        assert!(c.is_proved() && c.rapids.is_empty() && d.code == codes::FEED_CUT, "{d:?}");
        let text = &d.message;
        assert!(
            text.starts_with("motion from point to point cuts into part surface RIDGE by 4.99"),
            "{text}"
        );
    }
    // One message, though both motions along surfaces stand beside it, and the others go through too.
    let back = [after[0].clone(), after[1].clone(), through(), goto(&[LEFT]), over_ridge(LEFT)];
    assert_eq!(told(&back), FEED);
    // Over it, beside it, and at rapid, where it is an error.
    let path = |way: &[[f64; 3]]| {
        [goto(&[high(LEFT), LEFT]), over_ridge(LEFT), goto(way), over_ridge(RIGHT)]
    };
    assert_eq!(told(&path(&[high(LEFT), high(RIGHT)])), NOTHING);
    assert_eq!(told(&path(&[[-6.0, 40.0, 0.0], [26.0, 40.0, 0.0]])), NOTHING);
    // The machine goes up by itself before.
    let plane = Arg::Form { name: NameRef::default(), form: Arc::new(floor(14.0)) };
    let clear = vec![word("CLRSRF", vec![plane]), word("CLRSRF", vec![Arg::Word("NOW".into())])];
    let aside = |clear: Vec<Record>| {
        [
            goto(&[high(LEFT), LEFT]),
            over_ridge(LEFT),
            goto(&[LEFT]),
            clear,
            goto(&[[26.0, 10.0, 14.0]]),
        ]
    };
    assert_eq!(told(&aside(clear)), NOTHING);
    assert_eq!(told(&aside(Vec::new())), FEED);
    let quick = [goto(&[LEFT]), over_ridge(LEFT), rapid(), goto(&[RIGHT]), goto(&[high(RIGHT)])];
    assert_eq!(told(&quick), [codes::RAPID_CUT.number()]);
}

/// It ends in the ridge and goes up from there, or on to the first position of regional milling: that place is not meant.
#[test]
fn a_motion_at_feed_that_ends_in_the_part_is_told() {
    let low = [10.0, 10.0, HIGH - 3.0];
    let side = [10.0, 40.0, HIGH - 3.0];
    let depth = 3.0 - BAND;
    let up = [10.0, 10.0, 50.0];
    let rest = |last: &[[f64; 3]]| {
        vec![
            goto(&[OVER]),
            over_ridge([10.0, 10.0, HIGH]),
            goto(&[[10.0, 10.0, 40.0], [10.0, 40.0, 40.0], side, low]),
            goto(last),
        ]
    };
    let (_, said) = judge(&rest(&[up, OVER]));
    let [d] = &said[..] else { panic!("{said:?}") };
    let by: f64 = d
        .message
        .split(" by ")
        .nth(1)
        .and_then(|t| t.split(' ').next())
        .expect("a depth")
        .parse()
        .expect("a number");
    assert!(d.code == codes::FEED_CUT && by > 0.85 * depth && by < depth + 1e-6, "{}", d.message);
    let then = [&rest(&[])[..], &[over_ridge([10.0, 14.0, HIGH])]].concat();
    assert_eq!(told(&then), FEED);
    // The same at rapid on.
    assert_eq!(told(&[rest(&[]), vec![rapid(), goto(&[up])]].concat()), FEED);
}

/// A chain that goes aside below the floor from the side, and back: nothing works as deep.
#[test]
fn below_a_plane_it_is_told_where_the_tool_ran() {
    let dip = |x: f64| goto(&[[x, 0.0, 9.0], [x + 8.0, 0.0, -2.0], [x + 16.0, 0.0, 9.0]]);
    assert_eq!(told(&[along(0.0), dip(40.0), along(0.0)]), FEED);
    assert_eq!(told(&[along(0.0), dip(40.0)]), FEED);
    assert_eq!(told(&[goto(&[[0.0, 0.0, 50.0]]), dip(40.0), along(0.0)]), FEED);
    // Elsewhere the plane may be no face of the part.
    assert_eq!(told(&[along(0.0), dip(300.0), along(0.0)]), NOTHING);
    // A ball: its highest place is 7 below the top of the cutter.
    let ball = || {
        guided(
            "BALL",
            Form::Sphere(Sphere { center: Vec3::new(0.0, 0.0, -30.0), radius: 30.0 }),
            &[[0.0, 0.0, 0.0]],
        )
    };
    let side = [
        [0.0, 0.0, 20.0],
        [60.0, 0.0, 20.0],
        [60.0, 0.0, -7.0],
        [-60.0, 0.0, -7.0],
        [-60.0, 0.0, 20.0],
    ];
    assert_eq!(told(&[ball(), goto(&side)]), FEED);
}

/// What a machinist means, and what nobody knows.
#[test]
fn what_is_meant_to_be_deeper_is_not_told() {
    let up = [100.0, 0.0, 9.0];
    let drill = [
        [20.0, 0.0, 9.0],
        [20.0, 0.0, -12.0],
        [20.0, 0.0, 9.0],
        [50.0, 0.0, 9.0],
        [50.0, 0.0, -12.0],
        [50.0, 0.0, 9.0],
    ];
    let slot = [
        [20.0, 0.0, 9.0],
        [20.0, 0.0, -3.0],
        [60.0, 0.0, -3.0],
        [60.0, 9.0, -3.0],
        [60.0, 9.0, 9.0],
    ];
    // Part of the way up, and aside from there.
    let steps = [
        [20.0, 0.0, 9.0],
        [20.0, 0.0, -9.0],
        [20.0, 0.0, -4.0],
        [60.0, 0.0, -4.0],
        [60.0, 0.0, 9.0],
    ];
    // A ramp to the deeper floor that comes next.
    let ramp = [[20.0, 0.0, 9.0], [60.0, 0.0, -6.0], [0.0, 0.0, -6.0]];
    for way in [&drill[..], &slot, &steps] {
        assert_eq!(told(&[along(0.0), goto(&[up]), goto(way), along(0.0)]), NOTHING, "{way:?}");
        assert_eq!(told(&[along(0.0), goto(&[up]), goto(way)]), NOTHING);
    }
    assert_eq!(told(&[along(0.0), goto(&[up]), goto(&ramp), along(-6.0)]), NOTHING);
    // From there back up to the other one.
    let back = [[100.0, 0.0, 9.0], [0.0, 0.0, 0.0]];
    assert_eq!(told(&[along(-6.0), goto(&back), along(0.0)]), NOTHING);
    let dip = [[40.0, 0.0, 9.0], [48.0, 0.0, -2.0], [56.0, 0.0, 9.0]];
    // Another tool, a cycle, another tool axis, along a curve, and a plane that no statement gives.
    let change = |records: Vec<Record>| [along(0.0), goto(&[up]), records, goto(&dip), goto(&[up])];
    let cutter = record(Kind::Cutter(Cutter::mill(4.0, 2.0, 40.0)));
    assert_eq!(told(&change(vec![cutter.clone()])), NOTHING);
    assert_eq!(told(&change(vec![word("LOADTL", vec![Arg::Number(2.0)])])), NOTHING);
    assert_eq!(told(&change(vec![word("CYCLE", vec![Arg::Word("DRILL".into())])])), NOTHING);
    assert_eq!(told(&change(Vec::new())), FEED);
    let same = record(Kind::Cutter(Cutter::mill(2.0 * RADIUS, RADIUS, 40.0)));
    assert_eq!(told(&change(vec![same])), FEED);
    let leaning = |p: [f64; 3]| {
        motion(MotionKind::Goto, None, &[Position { te: Vec3::from(p), ta: Vec3::x() }])
    };
    assert_eq!(told(&[along(0.0), goto(&[up]), dip.map(leaning).to_vec()]), NOTHING);
    let curve = motion(MotionKind::Goto, None, &dip.map(upright));
    assert_eq!(told(&[along(0.0), goto(&[up]), vec![curve], goto(&[up])]), NOTHING);
    let none =
        guided("the part surface of AUTOPS", floor(0.0), &[[0.0, 0.0, 0.0], [100.0, 0.0, 0.0]]);
    assert_eq!(told(&[none, goto(&dip), goto(&[up])]), NOTHING);
}

/// Of a chain that is longer than what is kept of one, what is next to the motions along surfaces is held.
#[test]
fn of_a_long_chain_both_ends_are_held() {
    let up = [100.0, 0.0, 9.0];
    let dip = [[40.0, 0.0, 9.0], [48.0, 0.0, -2.0], [56.0, 0.0, 9.0]];
    let away: Vec<_> = (0..7_000).flat_map(|_| [up, [90.0, 0.0, 9.0]]).collect();
    let all = |first: &[[f64; 3]], last: &[[f64; 3]]| {
        told(&[along(0.0), goto(first), goto(&away), goto(last), along(0.0)])
    };
    assert_eq!(all(&[up], &[up]), NOTHING);
    assert_eq!(all(&[&[up], &dip[..]].concat(), &[up]), FEED);
    assert_eq!(all(&[up], &dip), FEED);
}
