//! AVCTRL over waves tighter than the cutter: each way between a tilted or lifted place and the next is found, few are cut
//! into pieces, and all of it is proved.

#[path = "support/run.rs"]
mod run;

use std::fmt::Write;

use aptc_control::Verify;
use aptc_geometry::trig;

/// The codes of all messages, and the number of positions.
fn run(text: &str) -> (Vec<String>, usize) {
    let ran = run::run(text, Verify::Full);
    (ran.codes(), ran.places.len())
}

/// Waves along x of that number a unit, height and place, less high ones along y.
fn waves([often, high, place]: [f64; 3]) -> String {
    let mut out = String::from("FORM=SSURF/SMESH,XYZ");
    for y in [0.0, 3.0, 6.0, 9.0_f64] {
        out.push_str(",SPLINE");
        for x in [0.0, 3.0, 6.0, 9.0, 12.0_f64] {
            let z = high * (trig::sin(often * x + place) + 0.4 * trig::sin(0.6 * y));
            write!(out, ",$\n({x},{y},{z:.6})").expect("text");
        }
    }
    out
}

/// Waves, diameter, corner, tolerance, axis, AVCTRL, start and step-over.
type Scene = ([f64; 3], [f64; 3], &'static str, &'static str, [f64; 3]);

const SCENES: [Scene; 6] = [
    // A tilt that is just enough at two places is not between them.
    (
        [0.8742, 0.4632, 3.4837],
        [1.0, 0.15, 0.002],
        "UP",
        "CUTANG,CONST,0,RANGE,-20,20,AXIS,LIMIT,3",
        [0.755, 0.416, 1.783],
    ),
    (
        [0.8693, 0.4945, 3.4482],
        [1.0, 0.15, 0.01],
        "UP",
        "CUTANG,CONST,0,RANGE,-20,20,AXIS,LIMIT,1",
        [0.359, 0.363, 2.678],
    ),
    (
        [0.6701, 0.3520, 2.3777],
        [1.0, 0.05, 0.002],
        "NORMDS",
        "CUTANG,CONST,0,RANGE,-20,20,AXIS,LIMIT,1",
        [0.298, 0.678, 1.720],
    ),
    // Where a pass and the step to the next meet the one tilts otherwise than the other.
    (
        [0.6953, 0.6116, 5.5955],
        [3.0, 0.45, 0.002],
        "NORMDS",
        "CUTANG,CONST,0,RANGE,-20,20,AXIS,LIMIT,3",
        [0.515, 0.478, 2.749],
    ),
    (
        [0.8803, 0.6227, 1.3004],
        [3.0, 0.05, 0.005],
        "NORMDS",
        "CUTANG,CONST,2,RANGE,-30,30,NORMPS,LIMIT,1",
        [0.986, 0.462, 1.469],
    ),
    // A lift while the axis turns.
    (
        [0.6766, 0.5249, 1.2894],
        [3.0, 0.45, 0.002],
        "NORMDS",
        "NORMPS,LIMIT,3",
        [0.303, 0.503, 1.528],
    ),
];

#[test]
fn tilts_and_lifts_lead_on_to_each_other() {
    for (form, [d, r, band], axis, avoid, [u, v, over]) in SCENES {
        let text = format!(
            "{}
UP=VECTOR/0,0,1
CUTTER/{d},{r},{},{r},0,0,3
INTOL/{band}
OUTTOL/{band}
MULTAX
FROM/0,0,6
SCON/DS,FORM,PARAM,0,4,0,3,AT,UP
SCON/PS,TO,FORM,PLUS,0
SCON/AXIS,{axis}
SCON/FEED,10,20,30,40
SCON/STEPOV,0,{over},0,0
CHKSRF/PS,ON
AVCTRL/{avoid}
SMIL/ZIGZAG,DS,PARAM,{u},{v},TANSPL,PLUS,STEPOV,PLUS
FINI
",
            waves(form),
            0.5 * d - r
        );
        let (mut codes, points) = run(&text);
        // Some of the passes are farther apart than the cutter is wide.
        codes.retain(|code| code != "APT2053");
        assert!(codes.is_empty(), "{codes:?} {text}");
        assert!((100..700).contains(&points), "{points} {text}");
    }
}

/// A ball beside a straight path, as near, as high and with as large a technological angle.
fn beside(near: f64, high: f64, constant: f64) -> String {
    format!(
        "PARTNO BESIDE A BALL
UNITS/MM
F=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(30,0,0),(60,0,0),$
 SPLINE,(0,40,0),(30,40,0),(60,40,0)
K=SPHERE/30,{},{high},8
CUTTER/8,4,0,4,0,0,60
INTOL/.01
OUTTOL/.01
MULTAX
FROM/0,20,90
SCON/DS,F,PARAM,0,2,0,1,AT,(VECTOR/0,0,-1)
SCON/PS,TO,F,PLUS,0
SCON/AXIS,(VECTOR/0,0,1)
CHKSRF/K,ON
AVCTRL/CUTANG,CONST,{constant},RANGE,-40,40,AXIS,LIMIT,.01
SMIL/PATH,DS,PARAM,0,.5,TANSPL,PLUS
FINI
",
        20.0 + near
    )
}

/// Where the ball comes near the least tilt is a pitch back, which does not lead by it: the tool rolls all the way.
#[test]
fn a_tool_rolls_by_what_it_cannot_pitch_over() {
    for (near, high, constant) in [
        (4.0, 30.0, 0.0),
        (6.0, 20.0, 0.0),
        (6.0, 30.0, 0.0),
        (6.0, 30.0, 2.0),
        (8.0, 25.0, 5.0),
        (9.0, 30.0, 0.0),
    ] {
        let text = beside(near, high, constant);
        let ran = run::run(&text, Verify::Full);
        assert!(ran.faults().is_empty(), "{:?} {text}", ran.told);
        let last = ran.places.last().expect("it comes there");
        assert!((last[0] - 60.0).abs() < 1e-6, "{last:?} {text}");
        for ([x, y, z], [i, j, k]) in ran.places.iter().zip(&ran.axes).skip(1) {
            // The ball of the cutter keeps to the path; its axis goes by the sphere.
            let middle = [x + 4.0 * i, y + 4.0 * j, z + 4.0 * k];
            assert!((middle[1] - 20.0).abs() < 0.02 && (middle[2] - 4.0).abs() < 0.02, "{text}");
            let to = [30.0 - middle[0], 20.0 + near - middle[1], high - middle[2]];
            let along = to[0] * i + to[1] * j + to[2] * k;
            let square = to.iter().map(|t| t * t).sum::<f64>() - along * along;
            assert!(square.sqrt() >= 12.0 - 0.0101, "{square} {text}");
        }
    }
}

/// A blade leans over the path, higher than the cutter: under it the tool cannot be lifted out, and what stands above it is told.
/// What has the height of the tool goes over the blade.
#[test]
fn a_blade_that_leans_over_a_low_cutter_is_told() {
    let program = |cutter: &str, avoid: &str| {
        format!(
            "PARTNO A BLADE THAT LEANS OVER
UNITS/MM
F=SSURF/SMESH,RULED,SPLINE,(0,0,0),(60,0,0),$
 SPLINE,(0,60,0),(60,60,0)
B=SSURF/SMESH,RULED,SPLINE,(30,20,-1),(30,40,-1),$
 SPLINE,(28,20,20),(28,40,20)
UP=VECTOR/0,0,1
{cutter}
INTOL/.01
OUTTOL/.01
FROM/5,30,80
CHKSRF/B,ON
AVCTRL/{avoid},LIMIT,60
SCON/DS,F,PARAM,.05,.95,0,1,AT,UP
SCON/PS,TO,F,PLUS,0
SCON/AXIS,UP
SMIL/PATH,DS,PARAM,.05,.5,TANSPL,PLUS
NOPOST
FINI
"
        )
    };
    let (low, high) = ("CUTTER/6,3,0,3,0,0,12", "CUTTER/6,3,0,3,0,0,30");
    // On the flat the normal is the axis.
    for avoid in ["AXIS", "NORMPS"] {
        let ran = run::run(&program(low, avoid), Verify::Full);
        assert_eq!(ran.faults(), ["APT2046"], "{:?}", ran.told);
        let said = "B goes on above the tool as CUTTER and HOLDER say it is";
        assert!(ran.told.iter().any(|(_, text)| text.contains(said)), "{:?}", ran.told);
    }
    for cutter in [high, &format!("{low}\nHOLDER/6,12,6,60")] {
        let ran = run::run(&program(cutter, "AXIS"), Verify::Full);
        assert!(ran.faults().is_empty(), "{:?}", ran.told);
        let last = ran.places.last().expect("it comes there");
        let highest = ran.places.iter().skip(1).map(|p| p[2]).fold(0.0, f64::max);
        assert!((last[0] - 57.0).abs() < 1e-6 && (19.0..21.0).contains(&highest), "{last:?}");
    }
    // A limit that is too narrow is told as such.
    let ran = run::run(&program(high, "AXIS").replace("LIMIT,60", "LIMIT,9"), Verify::Full);
    assert_eq!(ran.faults(), ["APT2046"], "{:?}", ran.told);
    assert!(!ran.told.iter().any(|(_, text)| text.contains("goes on above")), "{:?}", ran.told);
}

/// Beside an upright post that the holder meets.
const POST: &str = "UNITS/MM
F=SSURF/PATCH,POLYGN,PLUS,(0.0,0.0,2.558927),(20.0,0.0,-0.978371),$
 (40.0,0.0,4.222413),(60.0,0.0,2.929197),(0.0,20.0,-4.02621),(20.0,$
 20.0,4.797357),(40.0,20.0,3.153394),(60.0,20.0,-2.455571),(0.0,40.0,$
 3.258483),(20.0,40.0,5.568625),(40.0,40.0,-4.324412),(60.0,40.0,$
 1.937825),(0.0,60.0,-2.053893),(20.0,60.0,-3.988602),(40.0,60.0,$
 0.304503),(60.0,60.0,-5.019302)
UP=VECTOR/0,0,1
K0=CYLNDR/68.182321,16.812788,0.0,0.0,0.0,1.0,6.046587
K1=CYLNDR/31.012774,0.0,4.427966,0.0,1.0,0.0,5.588888
K2=CYLNDR/24.390273,0.0,4.940971,0.0,1.0,0.0,5.584991
CUTTER/10.0,1.0,4.0,1.0,0.0,0.0,30.0
INTOL/0.01
OUTTOL/0.01
THICK/0,0,0
MULTAX
HOLDER/8.0,30.0,8.0,40.0,30.0,50.0,30.0,80.0
FROM/-30,-30,90
CHKSRF/PS,K0,K1,K2,ON
AVCTRL/CUTANG,CONST,0,RANGE,-30,30
AVCTRL/ON
SCON/DS,F,PARAM,.1,.9,.1,.9,AT,UP
SCON/PS,TO,F,PLUS,0
SCON/AXIS,UP
SCON/FEED,800,800,300,2000
SCON/FEED,(PLANE/0,0,1,70)
SCON/STEPOV,0,6,0,0
SMIL/ZIGZAG,DS,PARAM,.1,.1,CRSSPL,PLUS,STEPOV,PLUS
NOPOST
FINI
";

/// Where the step across was tilted it ends otherwise than a step that begins there would: from there the way to the next pass, tilted
/// along, has the holder in the post, and goes over.
#[test]
fn from_a_tilted_step_across_to_the_next_pass_the_holder_keeps_off() {
    let ran = run::run(POST, Verify::Full);
    let faults: Vec<_> = ran.faults().into_iter().filter(|c| c != "APT2053").collect();
    assert!(faults.is_empty() && ran.places.len() > 300, "{:?}", ran.told);
}
