//! Curves whose knots are none: what is made of them is not read, and that is told.

mod ig;
#[expect(dead_code, reason = "other tests make more of it")]
mod maker;

use aptc_exchange::{Limits, read};
use ig::iges;
use maker::Step;

/// A curve of three control points over these knots, moved up and bounded by its own edges.
fn wall(knots: &str) -> Step {
    let mut step = Step::default();
    let points: Vec<String> = [[0.0, 0.0, 0.0], [5.0, 5.0, 0.0], [10.0, 0.0, 0.0]]
        .iter()
        .map(|p| format!("#{}", step.point(*p)))
        .collect();
    let curve = step.add(format!(
        "B_SPLINE_CURVE_WITH_KNOTS('',2,({}),.UNSPECIFIED.,.F.,.F.,(3,3),({knots}),.UNSPECIFIED.)",
        points.join(",")
    ));
    let up = step.direction([0.0, 0.0, 1.0]);
    let up = step.add(format!("VECTOR('',#{up},4.)"));
    let surface = step.add(format!("SURFACE_OF_LINEAR_EXTRUSION('',#{curve},#{up})"));
    let [a, b] = [[0.0; 3], [10.0, 0.0, 0.0]].map(|p| step.vertex(p));
    let [c, d] = [[10.0, 0.0, 4.0], [0.0, 0.0, 4.0]].map(|p| step.vertex(p));
    let lines = [
        [[10.0, 0.0, 0.0], [10.0, 0.0, 4.0]],
        [[10.0, 0.0, 4.0], [0.0, 0.0, 4.0]],
        [[0.0, 0.0, 4.0], [0.0; 3]],
    ]
    .map(|[p, q]| step.line(p, q));
    let mut edges = vec![(step.edge([a, b], curve, true), true)];
    for (ends, line) in [[b, c], [c, d], [d, a]].into_iter().zip(lines) {
        edges.push((step.edge(ends, line, true), true));
    }
    let bound = step.bound(&edges);
    step.face(&[bound], surface);
    step
}

#[test]
fn step_with_knots_that_are_none() {
    for knots in ["1.E999,1.", "1.,0.", "0.,1.E999", "-1.E308,1.E308", "1.,1."] {
        let why = wall(knots).tried().unwrap_err().to_string();
        assert!(why.contains("1 SURFACE_OF_LINEAR_EXTRUSION (face #"), "{knots}: {why}");
    }
}

#[test]
fn iges_with_knots_that_are_none() {
    let made = |knots: &str, range: &str| {
        let curve =
            format!("2,2,1,0,0,0,{knots},1.,.7,1.,10.,0.,0.,10.,10.,0.,0.,10.,0.,{range},0.,0.,1.");
        let text = iges(2, &[(126, 0, curve), (122, 0, "1,10.,0.,20.".into())]);
        read(&text, &Limits::default()).expect("IGES")
    };
    assert!(made("0.,0.,0.,1.,1.,1.", "0.,1.").is_ok());
    for knots in ["5.,5.,5.,1.,1.,1.", "0.,0.,1.,1.,0.,0.", "0.,0.,0.,0.,0.,0."] {
        let why = made(knots, "0.,1.").unwrap_err().to_string();
        assert!(why.contains("1 of type 122 (tabulated cylinder)"), "{knots}: {why}");
    }
    for (knots, range) in [
        ("1.E999,1.E999,1.E999,1.,1.,1.", "0.,1."),
        ("0.,0.,nan,1.,1.,1.", "0.,1."),
        ("0.,0.,0.,1.,1.,1.", "0.,inf"),
    ] {
        let why = made(knots, range).unwrap_err().to_string();
        assert!(why.contains("is no number, among the parameters"), "{why}");
    }
}
