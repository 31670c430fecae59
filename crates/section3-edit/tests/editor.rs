//! INDEX, COPY and TRACUT in the combinations that the language allows.

#![expect(clippy::unwrap_used, reason = "a test: it fails")]

use std::io::Cursor;

use aptc_cldata::{Arg, Edit, Kind, Motion, NameRef, Position, Record, Spill, Spool};
use aptc_diagnostics::{Diagnostic, Origin};
use aptc_edit::Editor;
use aptc_geometry::{Form, Plane, Transform, Vec3};
use proptest::prelude::*;

fn goto(x: f64, y: f64, z: f64) -> Kind {
    let points = vec![Position::upright(Vec3::new(x, y, z))];
    Kind::Motion(Motion { points, ..Motion::default() })
}

fn index(n: f64) -> Kind {
    Kind::Edit(Edit::Index { n, close: false })
}

fn nomore(n: f64) -> Kind {
    Kind::Edit(Edit::Index { n, close: true })
}

fn copy(n: f64, step: Transform, count: u32) -> Kind {
    Kind::Edit(Edit::Copy { n, step, count })
}

fn shift(x: f64, y: f64) -> Transform {
    Transform::translation(Vec3::new(x, y, 0.0))
}

fn records(program: Vec<Kind>) -> Vec<Record> {
    let number = |(i, kind)| {
        let line = u32::try_from(i).unwrap() + 1;
        Record { origin: Origin { line, isn: line, ..Origin::default() }, kind }
    };
    program.into_iter().enumerate().map(number).collect()
}

fn edit_with(editor: &mut Editor, program: Vec<Kind>) -> (Vec<Record>, Vec<Diagnostic>) {
    let mut out = Vec::new();
    for r in records(program) {
        editor.push(&r, &mut out).unwrap();
    }
    editor.finish(&mut out).unwrap();
    (out, editor.take_diagnostics())
}

fn edit(program: Vec<Kind>) -> (Vec<Record>, Vec<Diagnostic>) {
    edit_with(&mut Editor::new(), program)
}

fn places(records: &[Record]) -> Vec<(f64, f64)> {
    let mut out = Vec::new();
    for r in records {
        if let Kind::Motion(m) = &r.kind {
            out.extend(m.points.iter().map(|p| (p.te.x, p.te.y)));
        }
    }
    out
}

#[test]
fn copies_without_and_with_nomore() {
    let (out, said) = edit(vec![
        index(1.0),
        goto(1.0, 0.0, 0.0),
        nomore(1.0),
        goto(0.0, 50.0, 0.0),
        copy(1.0, shift(10.0, 0.0), 2),
    ]);
    assert!(said.is_empty(), "{said:?}");
    assert_eq!(places(&out), [(1.0, 0.0), (0.0, 50.0), (11.0, 0.0), (21.0, 0.0)]);
    // Copies come from the statement that they repeat.
    let lines: Vec<u32> =
        out.iter().filter(|r| matches!(r.kind, Kind::Motion(_))).map(|r| r.origin.line).collect();
    assert_eq!(lines, [2, 4, 2, 2]);
    // Without NOMORE the range ends at the COPY, and a second COPY repeats the copies too.
    let (out, _) = edit(vec![
        index(1.0),
        goto(1.0, 0.0, 0.0),
        copy(1.0, shift(10.0, 0.0), 1),
        copy(1.0, shift(0.0, 5.0), 1),
        goto(9.0, 9.0, 0.0),
    ]);
    let expected = [(1.0, 0.0), (11.0, 0.0), (1.0, 5.0), (11.0, 5.0), (9.0, 9.0)];
    assert_eq!(places(&out), expected);
}

#[test]
fn copies_nest_three_deep() {
    let (out, said) = edit(vec![
        index(1.0),
        index(2.0),
        index(3.0),
        goto(0.0, 0.0, 0.0),
        copy(3.0, shift(1.0, 0.0), 1),
        copy(2.0, shift(10.0, 0.0), 1),
        copy(1.0, shift(100.0, 0.0), 1),
    ]);
    assert!(said.is_empty(), "{said:?}");
    let x: Vec<f64> = places(&out).iter().map(|p| p.0).collect();
    assert_eq!(x, [0.0, 1.0, 10.0, 11.0, 100.0, 101.0, 110.0, 111.0]);
}

/// As APT-360 has it: a range is carried out once more, the COPY in it too, on what the outer COPY has moved.
#[test]
fn a_copy_of_a_copy_is_made_from_the_original() {
    let quarter = Transform::rotation(Vec3::z(), 90.0);
    let near = |records: &[Record], expected: &[(f64, f64)]| {
        let places = places(records);
        let alike =
            |(p, q): (&(f64, f64), &(f64, f64))| (p.0 - q.0).abs().max((p.1 - q.1).abs()) < 1e-12;
        assert!(places.iter().zip(expected).all(alike), "{places:?}");
        assert_eq!(places.len(), expected.len());
    };
    let (out, _) = edit(vec![
        index(1.0),
        index(2.0),
        goto(3.0, 0.0, 0.0),
        copy(2.0, shift(1.0, 0.0), 2),
        copy(1.0, quarter, 1),
    ]);
    near(&out, &[(3.0, 0.0), (4.0, 0.0), (5.0, 0.0), (0.0, 3.0), (1.0, 3.0), (2.0, 3.0)]);
    // The same range twice, and a range with NOMORE within it: scaled, turned, shifted.
    let (out, _) = edit(vec![
        index(1.0),
        index(2.0),
        goto(4.0, 0.0, 0.0),
        nomore(2.0),
        goto(1.0, 1.0, 0.0),
        copy(2.0, shift(1.0, 0.0), 1),
        goto(5.0, 6.0, 0.0),
        copy(1.0, quarter, 1),
        copy(1.0, Transform::scale(2.0), 1),
        goto(7.0, 7.0, 0.0),
    ]);
    let once = [(4.0, 0.0), (1.0, 1.0), (5.0, 0.0), (5.0, 6.0)];
    let turned = [(0.0, 4.0), (-1.0, 1.0), (1.0, 4.0), (-6.0, 5.0)];
    let twice = [(8.0, 0.0), (2.0, 2.0), (9.0, 0.0), (10.0, 12.0)];
    let both = [(0.0, 8.0), (-2.0, 2.0), (1.0, 8.0), (-12.0, 10.0)];
    near(&out, &[&once[..], &turned, &twice, &both, &[(7.0, 7.0)]].concat());
}

#[test]
fn a_matrix_of_a_copy_is_applied_once_more_for_each() {
    let quarter = Transform::rotation(Vec3::z(), 90.0);
    let (out, _) = edit(vec![index(1.0), goto(2.0, 0.0, 0.0), copy(1.0, quarter, 3)]);
    assert_eq!(places(&out), [(2.0, 0.0), (0.0, 2.0), (-2.0, 0.0), (0.0, -2.0)]);
}

#[test]
fn tracut_replaces_and_does_not_add_up() {
    let (out, _) = edit(vec![
        Kind::Edit(Edit::Tracut(Some(shift(10.0, 0.0)))),
        goto(1.0, 0.0, 0.0),
        Kind::Edit(Edit::Tracut(Some(shift(0.0, 5.0)))),
        goto(1.0, 0.0, 0.0),
        Kind::Edit(Edit::Tracut(None)),
        goto(1.0, 0.0, 0.0),
    ]);
    assert_eq!(places(&out), [(11.0, 0.0), (1.0, 5.0), (1.0, 0.0)]);
    // The records stay for the post-processor to see.
    assert_eq!(out.iter().filter(|r| matches!(r.kind, Kind::Edit(_))).count(), 3);
}

#[test]
fn tracut_acts_on_originals_whether_it_stands_inside_or_around() {
    let half = Transform::rotation(Vec3::z(), 180.0);
    let tracut = |m| Kind::Edit(Edit::Tracut(m));
    let inside = vec![
        index(1.0),
        tracut(Some(half)),
        goto(1.0, 0.0, 0.0),
        tracut(None),
        copy(1.0, shift(10.0, 0.0), 1),
    ];
    let around = vec![
        tracut(Some(half)),
        index(1.0),
        goto(1.0, 0.0, 0.0),
        copy(1.0, shift(10.0, 0.0), 1),
        tracut(None),
    ];
    for program in [inside, around] {
        assert_eq!(places(&edit(program).0), [(-1.0, 0.0), (9.0, 0.0)]);
    }
}

#[test]
fn geometry_in_post_words_goes_along() {
    let plane = Form::Plane(Plane::new(Vec3::z(), 5.0).unwrap());
    let clrsrf = Kind::Post {
        word: "CLRSRF".into(),
        args: vec![Arg::Form { name: NameRef::default(), form: plane.into() }],
    };
    let up = Transform::translation(Vec3::new(0.0, 0.0, 3.0));
    let (out, _) = edit(vec![index(1.0), clrsrf, goto(0.0, 0.0, 0.0), copy(1.0, up, 1)]);
    let planes: Vec<f64> = out
        .iter()
        .filter_map(|r| match &r.kind {
            Kind::Post { args, .. } => match &args[0] {
                Arg::Form { form, .. } => Some(form.canonical()[3]),
                _ => None,
            },
            _ => None,
        })
        .collect();
    assert_eq!(planes, [5.0, 8.0]);
}

#[test]
fn axes_turn_with_the_matrix() {
    let points = vec![Position::upright(Vec3::new(0.0, 1.0, 0.0))];
    let tilted = Kind::Motion(Motion { points, with_axis: true, ..Motion::default() });
    let map = Transform::rotation(Vec3::x(), 90.0).then(&Transform::scale(2.0));
    let program = vec![Kind::Edit(Edit::Tracut(Some(map))), tilted, goto(0.0, 1.0, 0.0)];
    let (out, said) = edit(program);
    let Kind::Motion(m) = &out[1].kind else { panic!("motion") };
    assert!((m.points[0].te - Vec3::new(0.0, 0.0, 2.0)).norm() < 1e-12);
    assert!((m.points[0].ta + Vec3::y()).norm() < 1e-12);
    // Without axes in the output the tilt would be lost in silence.
    assert_eq!(said.len(), 1);
}

#[test]
fn mistakes_are_told() {
    for (program, code) in [
        (vec![copy(1.0, shift(1.0, 0.0), 1)], 3101),
        (vec![nomore(4.0)], 3101),
        (vec![index(1.0), nomore(1.0), index(1.0), nomore(1.0)], 3102),
        ((0..150).map(|i| index(f64::from(i))).collect(), 3103),
        (vec![index(1.0), goto(0.0, 0.0, 0.0)], 3105),
        (
            vec![
                index(1.0),
                goto(0.0, 0.0, 0.0),
                index(2.0),
                goto(1.0, 0.0, 0.0),
                copy(1.0, shift(1.0, 0.0), 1),
                copy(2.0, shift(1.0, 0.0), 1),
            ],
            3109,
        ),
    ] {
        let (_, said) = edit(program);
        assert!(said.iter().any(|d| d.code.number() == code), "{code}: {said:?}");
    }
}

/// Warnings without end are counted, and hide no error that comes behind them.
#[test]
fn an_error_behind_very_many_warnings_is_told() {
    let twice = (0..600).flat_map(|_| [index(1.0), nomore(1.0)]);
    let (_, said) = edit(twice.chain([nomore(4.0), nomore(5.0)]).collect());
    let errors: Vec<u16> = said.iter().filter(|d| d.is_error()).map(|d| d.code.number()).collect();
    assert_eq!((errors, said.len()), (vec![3101], 502));
    // 599 warnings and the second error, less the 500 that are shown.
    let last = &said.last().expect("502").message;
    assert!(last.starts_with("100 more messages"), "{last}");
}

#[test]
fn nothing_is_edited_after_a_failed_motion() {
    let mut editor = Editor::new();
    editor.motion_failed();
    let program = vec![index(1.0), goto(0.0, 0.0, 0.0), copy(1.0, shift(1.0, 0.0), 5)];
    assert_eq!(places(&edit_with(&mut editor, program).0).len(), 1);
}

fn program() -> impl Strategy<Value = Vec<Kind>> {
    let number = -100.0..100.0_f64;
    let n = 1_u32..4;
    let kind = prop_oneof![
        5 => (number.clone(), number.clone(), number.clone()).prop_map(|(x, y, z)| goto(x, y, z)),
        1 => n.clone().prop_map(|n| index(n.into())),
        1 => n.clone().prop_map(|n| nomore(n.into())),
        1 => (n, number.clone(), 0_u32..3)
            .prop_map(|(n, x, k)| copy(n.into(), shift(x, 1.0), k)),
        1 => number.prop_map(|x| Kind::Edit(Edit::Tracut(Some(shift(x, 0.0))))),
        1 => Just(Kind::Comment("note".into())),
    ];
    prop::collection::vec(kind, 0..25)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// What waits in a file comes back as what waits in memory.
    #[test]
    fn a_spool_in_a_file_gives_the_same(program in program()) {
        let opener = || Ok(Box::new(Cursor::new(Vec::new())) as Box<dyn Spill>);
        let mut spilling = Editor::with_spool(Spool::spilling_after(100, opener));
        let (a, _) = edit(program.clone());
        let (b, _) = edit_with(&mut spilling, program);
        prop_assert_eq!(a, b);
    }
}

/// The manual's own example: three COPY of one INDEX, others between them, three levels.
#[test]
fn one_index_serves_three_copies_around_others() {
    let at = |x: f64| goto(x, 0.0, 0.0);
    let same = Transform::identity;
    let (out, said) = edit(vec![
        index(1.0),
        at(1.0),
        copy(1.0, same(), 1),
        copy(1.0, shift(10.0, 0.0), 1),
        index(2.0),
        at(2.0),
        index(3.0),
        at(3.0),
        copy(3.0, shift(0.5, 0.0), 1),
        copy(2.0, shift(10.0, 0.0), 1),
        index(4.0),
        at(4.0),
        copy(4.0, Transform::rotation(Vec3::z(), 180.0), 1),
        copy(1.0, same(), 1),
    ]);
    assert!(said.is_empty(), "{said:?}");
    let x: Vec<f64> = places(&out).iter().map(|p| p.0).collect();
    let once = [1.0, 1.0, 11.0, 11.0, 2.0, 3.0, 3.5, 12.0, 13.0, 13.5, 4.0, -4.0];
    assert_eq!(x, [once, once].concat());
}

/// TRACUT of the originals inside a range, then the matrix of COPY on what it gave.
#[test]
fn tracut_and_copy_with_matrices_that_do_not_commute() {
    let quarter = Transform::rotation(Vec3::z(), 90.0);
    let tracut = |m| Kind::Edit(Edit::Tracut(m));
    let start = goto(3.0, 1.0, 0.0);
    // In the range: turn, then shift and turn again with each copy.
    let step = shift(10.0, 0.0).then(&quarter);
    let (out, _) =
        edit(vec![index(1.0), tracut(Some(quarter)), start, tracut(None), copy(1.0, step, 2)]);
    let p0 = quarter.point(Vec3::new(3.0, 1.0, 0.0));
    let p1 = step.point(p0);
    let p2 = step.point(p1);
    for (got, p) in places(&out).iter().zip([p0, p1, p2]) {
        assert!((got.0 - p.x).abs() < 1e-12 && (got.1 - p.y).abs() < 1e-12, "{got:?} {p}");
    }
    // By hand: (3,1) turns to (-1,3), shifted to (9,3), turned to (-3,9).
    assert!((p1 - Vec3::new(-3.0, 9.0, 0.0)).norm() < 1e-12, "{p1}");
}

/// One mistake, one message: MULTAX is missing once, however many paths want it.
#[test]
fn a_missing_multax_is_told_once() {
    let words = |list: &[&str]| -> Vec<Arg> {
        let arg = |w: &&str| w.parse().map_or_else(|_| Arg::Word((*w).into()), Arg::Number);
        list.iter().map(arg).collect()
    };
    let vtlaxs = |list: &[&str]| Kind::Post { word: "VTLAXS".into(), args: words(list) };
    let path = || {
        [
            goto(0.0, 0.0, 0.0),
            vtlaxs(&["ON", "LEFT", "5", "10", "2", "LEFT"]),
            goto(100.0, 0.0, 0.0),
            vtlaxs(&["OFF", "LEFT", "10"]),
        ]
    };
    let program: Vec<Kind> = path().into_iter().chain(path()).chain([Kind::Fini]).collect();
    let (_, told) = edit(program);
    let messages: Vec<&str> = told.iter().map(|d| d.message.as_str()).collect();
    assert_eq!(messages, ["VTLAXS without MULTAX"]);
}
