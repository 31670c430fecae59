//! Profiles of several curves that run into each other: TANTO ends where they join, whichever way both bend.

#[path = "support/run.rs"]
mod run;

use std::fmt::Write as _;

use aptc_control::Verify;

/// The parabola `y = k x x` on the one side of its vertex, and straight on there, to nine digits.
fn parabola(name: &str, k: f64, before: bool) -> String {
    let mut text = format!("{name}=TABCYL/NOZ,SPLINE,$\n");
    let places: Vec<f64> = (0..=7).map(|i| f64::from(i) * 45.0 / 7.0).collect();
    let places: Vec<f64> = match before {
        true => places.iter().rev().map(|x| -x).collect(),
        false => places,
    };
    for (i, x) in places.iter().enumerate() {
        let normal = 90.0 + aptc_geometry::trig::atan2(2.0 * k * x, 1.0).to_degrees();
        let end = i == 0 || i == 7;
        let told = if end { format!(",NORMAL,{normal:.9}") } else { String::new() };
        let next = if i == 7 { "\n" } else { ",$\n" };
        write!(text, "{x:.9},{:.9}{told}{next}", k * x * x).expect("text");
    }
    text
}

/// A circle that bends so at the origin.
fn circle(name: &str, k: f64) -> String {
    format!("{name}=CYLNDR/0,{:.9},0,0,0,1,{:.9}\n", 0.5 / k, 0.5 / k.abs())
}

#[test]
fn a_motion_ends_where_two_curves_join() {
    for [first, then] in [
        [0.02, 0.0075],
        [0.0075, 0.02],
        [-0.0075, -0.02],
        [-0.02, -0.0075],
        [0.02, -0.0075],
        [-0.0075, 0.02],
    ] {
        let ways = [
            [parabola("QA", first, true), parabola("QB", then, false)],
            [circle("QA", first), parabola("QB", then, false)],
            [parabola("QA", first, true), circle("QB", then)],
        ];
        for [a, b] in ways {
            for floor in ["0,0,1,0", ".2,.1,1,0"] {
                let text = format!(
                    "PARTNO JOINT\nUNITS/MM\n{a}{b}PS=PLANE/{floor}\nCUTTER/8,2\nINTOL/.005\nOUTTOL/.01\n\
                     FROM/-13,15,40\nINDIRV/0,-1,0\nGO/TO,QA,TO,PS,ON,(PLANE/1,0,0,-12)\n\
                     INDIRV/1,0,0\nTLLFT,GOFWD/QA,TANTO,QB\nGOFWD/QB,ON,(PLANE/1,0,0,20)\nFINI\n"
                );
                let ran = run::run(&text, Verify::Full);
                assert!(ran.faults().is_empty(), "{:?} {text}", ran.told);
                // By the bands the end may lie before or behind the joint.
                let near = |p: &[f64; 3]| p[0].abs() < 1.6 && (p[1] - 4.0).abs() < 0.06;
                assert!(ran.places.iter().any(near), "{:?} {text}", ran.places);
                let last = ran.places.last().expect("it goes on");
                assert!((last[0] - 20.0).abs() < 1e-6, "{last:?} {text}");
            }
        }
    }
}

/// A wall that leaves its line, goes round a hump and comes back to it is followed, and not leapt over: as a check surface and as a
/// drive surface.
#[test]
fn a_hump_between_two_straight_ends_is_not_leapt_over() {
    for hump in [
        "50,0,NORMAL,90,60,3,70,6,80,3,90,0,NORMAL,90",
        "50,0,NORMAL,90,70,6,90,0,NORMAL,90",
        "50,0,NORMAL,90,60,-3,70,-6,80,-3,90,0,NORMAL,90",
    ] {
        for far in [140, 300] {
            let text = format!(
                "PARTNO HUMP\nUNITS/MM\nPS=PLANE/0,0,1,0\nW1=LINE/XAXIS\n\
                 W2=LINE/(POINT/{far},0),(POINT/{far},50)\nT1=TABCYL/NOZ,SPLINE,$\n{hump}\n\
                 CUTTER/10,2\nINTOL/.01\nOUTTOL/.02\nFROM/0,30,40\nINDIRV/0,-1,0\n\
                 GO/TO,W1,TO,PS,ON,(PLANE/1,0,0,0)\nINDIRV/1,0,0\nTLLFT,GOFWD/W1,TANTO,T1\n\
                 GOFWD/T1,TO,W2\nFINI\n"
            );
            let ran = run::run(&text, Verify::Full);
            assert!(ran.faults().is_empty(), "{:?} {text}", ran.told);
            let stops = |p: &[f64; 3]| (p[0] - 50.0).abs() < 0.1 && (p[1] - 5.0).abs() < 0.03;
            assert!(ran.places.iter().any(stops), "{:?} {text}", ran.places);
            let high = ran.places.iter().any(|p| (p[1] - 5.0).abs() > 5.5 && p[0] < 100.0);
            assert!(high, "{:?} {text}", ran.places);
        }
    }
}

/// A tool axis that is square to a wall but for what nine digits leave out: the flank leans by as little.
#[test]
fn an_axis_of_nine_digits_is_taken_as_it_stands() {
    for k in 0..24 {
        let turn = f64::from(k) * 0.37;
        let (s, c) = aptc_geometry::trig::sin_cos(turn);
        let (t, u) = aptc_geometry::trig::sin_cos(0.5 * turn + 0.2);
        // A frame: the axis, the normal of the wall, the way.
        let axis = [s * u, c * u, t];
        let wall = [c, -s, 0.0];
        let way = [-s * t, -c * t, u];
        let nine = |v: [f64; 3]| format!("{:.9},{:.9},{:.9}", v[0], v[1], v[2]);
        let from: [f64; 3] = std::array::from_fn(|i| 25.0 * wall[i] + 40.0 * axis[i]);
        let text = format!(
            "PARTNO AXIS\nUNITS/MM\nMULTAX\nTLAXIS/{}\nS=PLANE/{},0\nPS=PLANE/{},0\nSP=PLANE/{},0\n\
             CUTTER/10,2\nOUTTOL/.02\nFROM/{}\nINDIRV/{}\nGO/TO,S,TO,PS,ON,SP\nINDIRV/{}\n\
             TLLFT,GOFWD/S,ON,(PLANE/{},30)\nFINI\n",
            nine(axis),
            nine(wall),
            nine(axis),
            nine(way),
            nine(from),
            nine(wall.map(|x| -x)),
            nine(way),
            nine(way)
        );
        let ran = run::run(&text, Verify::Full);
        let told: Vec<_> = ran.faults().into_iter().filter(|c| c != "APT2006").collect();
        assert!(told.is_empty(), "{:?} {text}", ran.told);
    }
}

/// A patch of third degree through these places, upright from -30 to 45.
fn upright(name: &str, row: [[f64; 2]; 4]) -> String {
    let heights = [-30, -5, 20, 45];
    let rows = heights.map(|z| row.map(|[x, y]| format!("({x},{y},{z})")).join(",$\n"));
    format!("{name}=SSURF/PATCH,POLYGN,PLUS,$\n{}\n", rows.join(",$\n"))
}

/// Walls that join at x = 40, along which a tool goes whose axis turns with the dome below.
#[test]
fn a_motion_ends_where_two_walls_join_however_the_axis_turns() {
    let walls = [
        [
            [[-15.0, 32.6138], [3.3333, 33.8525], [21.6667, 32.7572], [40.0, 33.4152]],
            [[40.0, 33.4152], [58.3333, 34.0731], [76.6667, 31.5745], [95.0, 33.7423]],
        ],
        [
            [[-15.0, 36.0162], [3.3333, 33.5031], [21.6667, 31.9751], [40.0, 35.9726]],
            [[40.0, 35.9726], [58.3333, 39.9702], [76.6667, 30.4255], [95.0, 30.5936]],
        ],
    ];
    for [first, then] in walls {
        for (dome, axis, bands) in [
            ("40,20,-60,60", "NORMPS", "0\nOUTTOL/.02"),
            ("45,25,-60,60", "NORMPS", ".003\nOUTTOL/.003"),
            ("30,20,-80,80", "ATANGL,1,5", "0\nOUTTOL/.02"),
            ("40,20,-60,60", "0,0,1", "0\nOUTTOL/.02"),
        ] {
            let text = format!(
                "PARTNO TURNING\nUNITS/MM\n{}{}PL=SPHERE/{dome}\nCUTTER/6,3,0,3,0,0,27\n\
                 INTOL/{bands}\nMULTAX\nFROM/8,5,60\nTLAXIS/{axis}\n\
                 GO/TO,WA,TO,PL,ON,(PLANE/1,0,0,5)\nINDIRV/1,0,0\n\
                 TLRGT,GOFWD/WA,TANTO,WB\nNOPOST\nFINI\n",
                upright("WA", first),
                upright("WB", then),
            );
            let ran = run::run(&text, Verify::Full);
            assert!(ran.faults().is_empty(), "{:?} {text}", ran.told);
            let (p, ta) = (ran.places.last().expect("it goes"), ran.axes.last());
            // The middle of the ball is beside the joint, but for what the bands take up.
            let middle = p[0] + 3.0 * ta.expect("an axis")[0];
            assert!((middle - 40.0).abs() < 3.0, "{p:?} {text}");
        }
    }
}

/// An axis that turns with the place leaves the end of a motion in the bands of both walls too.
#[test]
fn a_motion_under_a_turning_axis_ends_in_the_bands_of_both_walls() {
    let first = [[-15.0, 36.446], [3.3333, 37.3215], [21.6667, 36.0153], [40.0, 34.7695]];
    let then = [[40.0, 34.7695], [58.3333, 33.5237], [76.6667, 30.2875], [95.0, 28.6311]];
    let text = format!(
        "PARTNO LEANING\nUNITS/MM\n{}{}PL=SPHERE/32,20,-60,60\nCUTTER/10.2,5.1,0,5.1,0,0,35\n\
         INTOL/0\nOUTTOL/.005\nMULTAX\nFROM/8,5,70\nTLAXIS/ATANGL,1,87.4,CUTANG,4.7\n\
         GO/TO,WA,TO,PL,ON,(PLANE/1,0,0,8)\nINDIRV/1,0,0\nTLRGT,GOFWD/WA,TANTO,WB\nNOPOST\nFINI\n",
        upright("WA", first),
        upright("WB", then),
    );
    let ran = run::run(&text, Verify::Full);
    assert!(ran.faults().is_empty(), "{:?} {text}", ran.told);
}
