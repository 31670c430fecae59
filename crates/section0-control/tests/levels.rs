//! Levels of hills as outlines: REGION/..,OUT mills what lies outside of them, and nothing within.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// The hill over the square of 40 with these heights inside of its border, at 0; and statements.
fn program(heights: [[f64; 4]; 4], level: f64, work: &str) -> String {
    let spline = |j: usize| {
        let z = |i: usize| match (1..5).contains(&i) && (1..5).contains(&j) {
            true => heights[j - 1][i - 1],
            false => 0.0,
        };
        let points = (0..6).map(|i| format!("({},{},{})", 8 * i, 8 * j, z(i)));
        format!("SPLINE,$\n{}", points.collect::<Vec<_>>().join(",$\n"))
    };
    let splines = (0..6).map(spline).collect::<Vec<_>>().join(",$\n");
    format!(
        "PARTNO LEVELS
UNITS/MM
HILL=SSURF/SMESH,XYZ,{splines}
LEVEL=PLANE/0,0,1,{level}
CUTTER/.002,.001
INTOL/.002
OUTTOL/.002
{work}
FROM/0,0,60
SCON/FEED,(PLANE/0,0,1,50)
REGION/1,OUT
TLAXIS/0,0,1
GOMILL/HILL,UCONST,.05,STEPOV,.1,ZIGZAG
END
FINI
"
    )
}

const OUTLINE: &str = "CLDAT/START,1,UVPPS
INTSEC/LEVEL,WITH,HILL
CLDAT/NOMORE,1";

/// A part of the first was found twice, a part of the second alone, each left open.
const HILLS: [([[f64; 4]; 4], f64); 2] = [
    (
        [
            [3.2, 4.6, 4.9, 6.9],
            [9.0, -0.6, 0.2, 2.8],
            [0.8, 1.7, -1.7, 0.8],
            [-0.6, 5.2, -1.9, -0.8],
        ],
        1.0,
    ),
    (
        [[5.3, 3.4, 4.7, -1.3], [3.5, 4.3, 7.7, 0.5], [3.4, 6.9, -0.3, 0.1], [6.1, 4.3, -1.5, 0.0]],
        0.49,
    ),
];

#[test]
fn what_lies_outside_a_level_is_milled_alone() {
    for (heights, level) in HILLS {
        let ran = run::run(&program(heights, level, OUTLINE), Verify::Full);
        assert_eq!(ran.faults(), ["APT2052"], "{:?}", ran.told);
        assert!(
            ran.told
                .iter()
                .any(|(_, text)| text.contains("in 1 curve") && text.ends_with("(closed)"))
        );
        let milled = || ran.places.iter().filter(|p| p[2] < 49.0);
        assert!(milled().count() > 500);
        let highest = milled().map(|p| p[2]).fold(f64::NEG_INFINITY, f64::max);
        // Half of the band beside the curve, on slopes of three at most.
        assert!(highest > level - 0.2 && highest < level + 0.01, "{level}: {highest}");
    }
}

#[test]
fn a_curve_that_is_there_twice_is_refused() {
    let (heights, level) = HILLS[0];
    let work =
        OUTLINE.replace("INTSEC/LEVEL,WITH,HILL", "INTSEC/LEVEL,WITH,HILL\nINTSEC/LEVEL,WITH,HILL");
    let ran = run::run(&program(heights, level, &work), Verify::Off);
    assert!(ran.codes().contains(&"APT2055".to_owned()), "{:?}", ran.told);
}
