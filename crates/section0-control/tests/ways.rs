//! What a start-up goes through on its way is told, and nothing else.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// A ball of radius 50 about the origin, and its upper part as a sheet.
const BALLS: [&str; 2] = [
    "S=SPHERE/0,0,0,50",
    "C=SCURV/CURSEG,(POINT/0,30,40),(POINT/0,0,50),(POINT/0,-30,40)\n\
     S=SSURF/REVOLV,C,AXIS,(POINT/0,0,0),(VECTOR/0,1,0),CCLW,-90,90",
];
const INTOL: f64 = 0.01;
/// Radius of the ball of the cutter, and its distance from the origin where it touches.
const CUTTER: f64 = 5.0;
const APART: f64 = 55.0;

/// To where the plane x = 30 cuts the ball, from somewhere else.
fn program(ball: &str, [x, y, z]: [f64; 3], rapid: &str) -> String {
    format!(
        "UNITS/MM\n{ball}\nCUTTER/10,5\nINTOL/{INTOL}\nOUTTOL/.01\nFROM/{x},{y},{z}\n{rapid}\n\
         GO/ON,(PLANE/1,0,0,30),TO,S,ON,(PLANE/0,1,0,-8)\nFINI\n"
    )
}

/// How near to the origin the middle of the cutter's ball comes between two tool ends.
fn nearest(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [a, b] = [a, b].map(|p| [p[0], p[1], p[2] + CUTTER]);
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let way = [0, 1, 2].map(|i| b[i] - a[i]);
    let t = (-dot(a, way) / dot(way, way).max(1e-300)).clamp(0.0, 1.0);
    let at = [0, 1, 2].map(|i| a[i] + way[i] * t);
    dot(at, at).sqrt()
}

#[test]
fn what_a_start_up_goes_through_is_told_with_its_depth() {
    let (mut told, mut silent) = (0, 0);
    for (sheet, ball) in [false, true].into_iter().zip(BALLS) {
        for k in 0..24 {
            let [x, y] = [-90.0 + 4.0 * f64::from(k), 13.0 - 2.0 * f64::from(k)];
            let from = [x, y, if k % 2 == 0 { 4.0 } else { 110.0 }];
            if nearest(from, from) <= APART {
                continue;
            }
            let text = program(ball, from, "");
            let ran = run::run(&text, Verify::Full);
            let to = *ran.places.last().expect("it comes there");
            assert!(((nearest(to, to)) - APART).abs() < 0.02 && to[2] > 0.0, "{to:?} {text}");
            let near = nearest(from, to);
            // A sheet is no deeper in a ball than its middle.
            let deep = if sheet { (APART - near).min(CUTTER) } else { APART - near } - INTOL;
            let through: Vec<_> = ran.told.iter().filter(|(c, _)| c == "APT5009").collect();
            assert_eq!(ran.faults().len(), through.len(), "{:?} {text}", ran.told);
            if deep <= 0.0 {
                assert!(through.is_empty(), "{deep} {through:?} {text}");
                silent += 1;
                continue;
            }
            let [(_, message)] = &through[..] else { panic!("{deep} {:?} {text}", ran.told) };
            let by = message.split(" by ").nth(1).and_then(|s| s.split(' ').next());
            let by: f64 = by.and_then(|s| s.parse().ok()).expect("a depth");
            assert!(by <= deep + 1e-6 && by >= 0.9 * deep, "{by} {deep} {text}");
            assert!(message.contains("goes into part surface S by"), "{message}");
            told += 1;
        }
    }
    assert!(told > 10 && silent > 10, "{told} {silent}");
}

/// At rapid it is a cut at rapid, told once.
#[test]
fn a_start_up_at_rapid_is_told_once() {
    for ball in BALLS {
        let ran = run::run(&program(ball, [-90.0, 13.0, 4.0], "RAPID"), Verify::Full);
        assert_eq!(ran.faults(), ["APT5005"], "{:?}", ran.told);
    }
}

/// What the tool stood in before it may leave as it likes, what it is to go past or on it may go through.
#[test]
fn what_a_tool_is_to_go_through_is_not_told() {
    let program = |from: &str, go: &str| {
        format!(
            "UNITS/MM\nS=SPHERE/0,0,0,50\nCUTTER/10\nINTOL/.01\nOUTTOL/.01\nFROM/{from}\n{go}\n\
             FINI\n"
        )
    };
    for (from, go) in [
        ("-90,0,0", "INDIRV/1,0,0\nGO/PAST,S"),
        ("-90,0,0", "INDIRV/1,0,0\nGO/ON,S"),
        ("-50,0,0", "INDIRV/-1,0,0\nGO/TO,S"),
        ("0,-90,-9", "PSIS/(PLANE/0,0,1,0)\nGO/TO,(LINE/XAXIS)"),
    ] {
        let ran = run::run(&program(from, go), Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{from} {go} {:?}", ran.told);
        assert!(ran.places.len() == 2, "{from} {go}");
    }
}

/// Half of the way round a cylinder is not put out: the chord cuts in by what an arc is high, less the tolerance.
#[test]
fn what_dntcut_leaves_a_tool_to_go_through_is_told() {
    const RADIUS: f64 = 20.0;
    let program = |[from, to]: [f64; 2], before: &str, after: &str| {
        format!(
            "UNITS/MM\nS=CYLNDR/0,0,0,0,0,1,{RADIUS}\nF=PLANE/0,0,1,0\nCUTTER/10\nINTOL/{INTOL}\n\
             OUTTOL/.01\nFROM/-60,0,9\nGO/TO,S,TO,F\nINDIRV/0,1,0\n\
             TLLFT,GOFWD/S,ON,(PLANE/(SINF({from})),(-COSF({from})),0,0)\n{before}\n\
             GOFWD/S,ON,(PLANE/(SINF({to})),(-COSF({to})),0,0)\n{after}\n\
             GOFWD/S,ON,(PLANE/0,1,0,0)\nFINI\n"
        )
    };
    for (from, to) in [(160.0, 110.0), (100.0, 20.0), (170.0, 10.0), (44.0, 40.0), (51.0, 50.0)] {
        let half = f64::to_radians(0.5 * (from - to));
        let deep = (RADIUS + CUTTER) * (1.0 - aptc_geometry::trig::cos(half)) - INTOL;
        let ran = run::run(&program([from, to], "DNTCUT", "CUT"), Verify::Full);
        let told = ran.told.iter().find(|(c, _)| c == "APT5009");
        assert_eq!(told.is_some(), deep > 0.0, "{deep} {:?}", ran.told);
        if let Some((_, message)) = told {
            let by = message.split(" by ").nth(1).and_then(|s| s.split(' ').next());
            let by: f64 = by.and_then(|s| s.parse().ok()).expect("a depth");
            assert!((by - deep).abs() <= 0.1 * deep, "{by} {deep} {message}");
        }
        let ran = run::run(&program([from, to], "", ""), Verify::Full);
        assert!(ran.told.iter().all(|(c, _)| c != "APT5009"), "{:?}", ran.told);
    }
}

/// SRFVCT leads a tool from inside of a round surface through it.
#[test]
fn a_way_out_of_a_round_surface_is_told() {
    let text = "UNITS/MM\nC=CYLNDR/0,0,0,0,0,1,40\nCUTTER/10\nOUTTOL/.02\nFROM/0,5,30\n\
                SRFVCT/0,-1,0\nGO/TO,C,TO,(PLANE/0,0,1,0)\nFINI\n";
    let ran = run::run(text, Verify::Full);
    assert_eq!(ran.faults(), ["APT5009"], "{:?}", ran.told);
}

/// Of a circle that turns away before the cutter is through a line; by the manual PAST is where it touches it the second time.
#[test]
fn past_that_never_gets_past_is_told() {
    for space in ["", "3DCALC\n"] {
        for line in 26..44 {
            let text = format!(
                "UNITS/MM\n{space}C=CIRCLE/0,0,30\nL=LINE/PARLEL,(LINE/XAXIS),YLARGE,{line}.5\n\
                 CUTTER/10\nOUTTOL/.01\nFROM/-50,0,10\nGO/TO,C,TO,(PLANE/0,0,1,0)\n\
                 TLLFT,GOLFT/C,PAST,L\nFINI\n"
            );
            let ran = run::run(&text, Verify::Full);
            // The tool end comes to y = 35.
            let told: &[&str] = match line {
                ..30 => &[],
                30..40 => &["APT2056"],
                _ => &["APT2008"],
            };
            assert_eq!(ran.faults(), told, "{:?} {text}", ran.told);
        }
    }
}
