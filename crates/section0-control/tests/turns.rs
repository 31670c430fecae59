//! A tool that GO leaves with another axis than the motion behind it asks for turns in place first, and keeps to its surfaces on the
//! way.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

const RADIUS: f64 = 104.0;

/// Beside a wall that is hollow upwards, a part of a cylinder about the line y = -104, z = 20 along x, ahead with TLAXIS as GO has it
/// and then back.
fn program(axis: &str, [intol, outtol]: [f64; 2]) -> String {
    format!(
        "UNITS/MM
S1=SCURV/CURSEG,(POINT/-100,-8,-20),(POINT/-100,0,20),$
 (POINT/-100,-8,60)
S2=SCURV/COMBIN,S1,TRFORM,(MATRIX/TRANSL,200,0,0)
WALL=SSURF/RULED,S1,S2
CUTTER/20,0,10,0,0,0,40
INTOL/{intol}
OUTTOL/{outtol}
MULTAX
FROM/-30,-40,60
TLAXIS/{axis}
INDIRV/0,1,0
GO/TO,WALL,TO,(PLANE/0,0,1,0),ON,(PLANE/1,0,0,0)
INDIRV/-1,0,0
TLLFT,GOFWD/WALL,ON,(PLANE/1,0,0,-30)
FINI
"
    )
}

/// How far the flank and the edge of the cutter are out of the cylinder on the way between two places, at most.
fn out(a: ([f64; 3], [f64; 3]), b: ([f64; 3], [f64; 3])) -> f64 {
    let mut most = f64::NEG_INFINITY;
    for step in 0..=20 {
        let t = f64::from(step) / 20.0;
        let mix = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] + (b[i] - a[i]) * t);
        let (te, ta) = (mix(a.0, b.0), mix(a.1, b.1));
        let size = ta.iter().map(|x| x * x).sum::<f64>().sqrt();
        let ta = ta.map(|x| x / size);
        // Across the axis, one of the two level.
        let flat = (ta[0] * ta[0] + ta[1] * ta[1]).sqrt();
        let e = if flat > 1e-9 { [-ta[1] / flat, ta[0] / flat, 0.0] } else { [1.0, 0.0, 0.0] };
        let f =
            [ta[1] * e[2] - ta[2] * e[1], ta[2] * e[0] - ta[0] * e[2], ta[0] * e[1] - ta[1] * e[0]];
        for turn in 0..720 {
            let angle = f64::from(turn) * core::f64::consts::PI / 360.0;
            let (s, c) = (aptc_geometry::trig::sin(angle), aptc_geometry::trig::cos(angle));
            for height in [0.0, 40.0] {
                let at = |i: usize| te[i] + ta[i] * height + 10.0 * (e[i] * c + f[i] * s);
                let (y, z) = (at(1) + 104.0, at(2) - 20.0);
                most = most.max((y * y + z * z).sqrt() - RADIUS);
            }
        }
    }
    most
}

#[test]
fn a_turn_in_place_keeps_to_the_surfaces() {
    for (axis, bands) in [
        ("ATANGL,1,40,CUTANG,40", [0.01, 0.01]),
        ("ATANGL,1,40,CUTANG,40", [0.0, 0.02]),
        ("ATANGL,1,40,CUTANG,40", [0.02, 0.0]),
        ("ATANGL,1,20,CUTANG,-20", [0.005, 0.01]),
        ("ATANGL,1,30,CUTANG,25", [0.0, 0.05]),
    ] {
        let text = program(axis, bands);
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{text}");
        let places: Vec<_> = ran.places.iter().copied().zip(ran.axes.iter().copied()).collect();
        // Behind FROM and GO it turns in steps, then goes along.
        assert!(places.len() > 4, "{} {text}", places.len());
        for pair in places[1..].windows(2) {
            let deep = out(pair[0], pair[1]);
            assert!(deep <= bands[0] + 1e-6, "{deep} {pair:?} {text}");
        }
    }
}

/// Along a wall that winds to and fro the plane square to the vector nearly holds the motion, now on this side, now on that: the axis
/// stays on the side on which the motion began.
#[test]
fn an_axis_square_to_a_vector_stays_on_its_side() {
    for (angle, word) in [(9.0, "TLRGT"), (-9.0, "TLRGT"), (6.0, "TLON")] {
        let start = if word == "TLON" { "ON" } else { "TO" };
        let text = format!(
            "UNITS/MM
W1=SCURV/SPLINE,(-50,0,-20),(-25,3,-20),(0,-3,-20),(25,3,-20),$
 (50,0,-20)
W2=SCURV/COMBIN,W1,TRFORM,(MATRIX/TRANSL,0,0,80)
WALL=SSURF/RULED,W1,W2
FLOOR=SSURF/SMESH,XYZ,SPLINE,(-60,-40,0),(0,-40,2),(60,-40,-1),$
 SPLINE,(-60,0,1),(0,0,0),(60,0,2),$
 SPLINE,(-60,40,-1),(0,40,1),(60,40,0)
CUTTER/8,1,3,1,0,0,30
INTOL/.01
OUTTOL/.01
MULTAX
FROM/-40,-30,60
TLAXIS/ATANGL,1,{angle},(VECTOR/0,1,0)
INDIRV/0,1,0
GO/{start},WALL,TO,FLOOR,ON,(PLANE/1,0,0,-40)
INDIRV/1,0,0
{word},GOFWD/WALL,ON,(PLANE/1,0,0,40)
FINI
"
        );
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{:?} {text}", ran.told);
        let [first, .., last] = ran.places.as_slice() else { panic!("it goes") };
        assert!(first[0] < -39.0 && last[0] > 39.9, "{text}");
        // Behind GO, which does not know the motion.
        let leans: Vec<f64> = ran.axes[3..].iter().map(|ta| ta[0]).collect();
        let side = leans[0].signum();
        assert!(leans.iter().all(|x| x * side > 0.05), "{leans:?} {text}");
        assert!(ran.axes[3..].iter().all(|ta| ta[1].abs() < 1e-9));
    }
}
