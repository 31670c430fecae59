//! Programs and files brought together.

use super::*;
use aptc_cldata::{Edit, NameRef};

fn motion(isn: u32, name: &str, points: &[[f64; 3]]) -> Record {
    let origin = Origin { isn, line: isn, ..Origin::default() };
    let motion = Motion {
        name: NameRef { name: name.into(), subscript: 0 },
        points: points.iter().map(|p| Position::upright(Vec3::from(*p))).collect(),
        ..Motion::default()
    };
    Record { origin, kind: Kind::Motion(motion) }
}

fn edit(edit: Edit) -> Record {
    Record { origin: Origin::default(), kind: Kind::Edit(edit) }
}

fn ends_of(m: &Matched) -> Vec<(usize, [f64; 3])> {
    m.records
        .iter()
        .filter_map(|r| match &r.kind {
            Kind::Motion(m) if m.kind != MotionKind::From => {
                Some((m.points.len(), m.points.last()?.te.into()))
            }
            _ => None,
        })
        .collect()
}

#[test]
fn motions_without_marks_are_found_by_their_ends() {
    let program = [
        motion(1, "A", &[[0.0, 0.0, 0.0], [5.0, 0.0, 0.0], [10.0, 0.0, 0.0]]),
        motion(2, "B", &[[10.0, 10.0, 0.0]]),
        motion(3, "C", &[[0.0, 0.0, 0.0]]),
    ];
    // Other chords of the first motion, every point a record of its own.
    let file: Vec<Record> =
        [[0.0, 0.0], [3.0, 0.0], [7.0, 0.0], [10.001, 0.0], [10.0, 10.0], [0.0, 0.001]]
            .iter()
            .map(|[x, y]| motion(0, "", &[[*x, *y, 0.0]]))
            .collect();
    let m = matched(&program, &file, Marks::None).unwrap();
    assert_eq!(
        ends_of(&m),
        [(4, [10.001, 0.0, 0.0]), (1, [10.0, 10.0, 0.0]), (1, [0.0, 0.001, 0.0])]
    );
    assert!(m.missing.is_empty() && m.extra == 0);
}

#[test]
fn a_motion_that_the_file_lacks_is_told() {
    let program = [
        motion(4, "A", &[[10.0, 0.0, 0.0]]),
        motion(5, "B", &[[10.0, 10.0, 0.0]]),
        motion(6, "C", &[[0.0, 10.0, 0.0]]),
    ];
    let file = [motion(4, "A", &[[10.0, 0.0, 0.0]]), motion(6, "C", &[[0.0, 9.0, 0.0]])];
    for marks in [Marks::Statements, Marks::Lines] {
        let m = matched(&program, &file, marks).unwrap();
        assert_eq!(m.missing.iter().map(|o| o.isn).collect::<Vec<_>>(), [5]);
        // Its end is elsewhere, but it is that statement: the proof shall judge it.
        assert_eq!(ends_of(&m)[1], (1, [0.0, 9.0, 0.0]));
    }
}

#[test]
fn copies_and_tracut_are_undone() {
    let turn = Transform::rotation(Vec3::z(), 90.0);
    let program = [
        edit(Edit::Index { n: 1.0, close: false }),
        edit(Edit::Tracut(Some(turn))),
        motion(3, "A", &[[10.0, 0.0, 0.0]]),
        edit(Edit::Tracut(None)),
        edit(Edit::Copy { n: 1.0, step: Transform::translation(Vec3::z()), count: 2 }),
    ];
    let file = [
        motion(3, "A", &[[0.0, 10.0, 0.0]]),
        motion(3, "A", &[[0.0, 10.0, 1.0]]),
        motion(3, "A", &[[0.0, 10.0, 2.0]]),
    ];
    let m = matched(&program, &file, Marks::Statements).unwrap();
    assert!(m.missing.is_empty() && m.extra == 0);
    assert_eq!(ends_of(&m), [(1, [10.0, 0.0, 0.0]); 3]);
}

/// A shift in a range that is turned: what copies last goes first. The same range copied once more takes the first copy along.
#[test]
fn copies_of_copies_are_undone_in_their_order() {
    let [turn, tip] = [Vec3::z(), Vec3::x()].map(|axis| Transform::rotation(axis, 90.0));
    let shift = Transform::translation(Vec3::new(0.0, 200.0, 0.0));
    let index = |n| edit(Edit::Index { n, close: false });
    let copy = |n, step| edit(Edit::Copy { n, step, count: 1 });
    let p = Vec3::new(10.0, 4.0, 3.0);
    let own = || motion(3, "A", &[p.into()]);
    let file = |maps: &[Transform]| -> Vec<Record> {
        maps.iter().map(|m| motion(3, "A", &[m.point(p).into()])).collect()
    };
    let one = Transform::identity();
    let nested = [index(1.0), index(2.0), own(), copy(2.0, shift), copy(1.0, turn)];
    let twice = [index(1.0), own(), copy(1.0, shift), copy(1.0, turn)];
    let maps = [one, shift, turn, turn.then(&shift)];
    let under = [
        index(1.0),
        index(2.0),
        edit(Edit::Tracut(Some(tip))),
        own(),
        edit(Edit::Tracut(None)),
        copy(2.0, shift),
        copy(1.0, turn),
    ];
    let behind: Vec<_> = maps.iter().map(|m| tip.then(m)).collect();
    for (program, maps) in [(&nested[..], &maps[..]), (&twice, &maps), (&under, &behind)] {
        for marks in [Marks::Statements, Marks::None] {
            let m = matched(program, &file(maps), marks).unwrap();
            assert!(m.missing.is_empty() && m.extra == 0 && m.at_home == [4, 4], "{m:?}");
            for (_, at) in ends_of(&m) {
                assert!((Vec3::from(at) - p).norm() < 1e-9, "{at:?}");
            }
        }
    }
}
