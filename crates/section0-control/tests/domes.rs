//! Surfaces that close in themselves: domes whole and with a hole on the axis, beyond which lines that go straight on would cross.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// A dome 80 wide and 20 high whose profile begins so far from the axis, level there, and statements.
fn program(hole: f64, cutter: &str, work: &str) -> String {
    format!(
        "PARTNO DOMES
UNITS/MM
RIM=SCURV/SPLINE,({hole},0,20),TANSPL,$
 (VECTOR/1,0,0),(25,0,14),(40,0,0)
DOME=SSURF/REVOLV,RIM,AXIS,(POINT/0,0,0),(VECTOR/0,0,1),CCLW,0,360
OVER=SSURF/SMESH,XYZ,SPLINE,(-14,-6,40),(12,-9,40),$
 SPLINE,(-12,9,40),(14,6,40)
DOWN=VECTOR/0,0,-1
CUTTER/{cutter}
INTOL/.01
OUTTOL/.01
FROM/-20,2,60
{work}
END
FINI
"
    )
}

/// Passes over the top: what they leave is told, and nothing is left.
#[test]
fn passes_over_the_top_clear_it() {
    let work = "SCON/DS,OVER,PARAM,0,1,0,1,AT,DOWN
SCON/PS,TO,DOME,PLUS,0
SCON/AXIS,(VECTOR/0,0,1)
SCON/FEED,0,0,0,0
SCON/STEPOV,.05,4,0,0
SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS";
    for hole in [0.0, 0.001, 4.0] {
        for cutter in ["10,5", "12,2"] {
            let ran = run::run(&program(hole, cutter, work), Verify::Full);
            assert_eq!(ran.faults(), Vec::<String>::new(), "{hole} {cutter}");
        }
    }
}

/// Round the axis of a flange the chords lie aside of their lines all along, and the tool stands off by nearly all of OUTTOL: beside the
/// vertices of one pass those of the next are farther off.
#[test]
fn chords_that_lie_aside_leave_no_more() {
    for (profile, cutter) in [
        ("(9,0,.3),(31,0,-.6),(52,0,-2.4),(71,0,.6)", "8,4"),
        ("(15.3,0,-2.6),(25.2,0,-3.2),(37,0,-2.9)", "4,2"),
    ] {
        for work in ["ZIGZAG", "PICKFD"] {
            let text = format!(
                "PARTNO FLANGE
UNITS/MM
RIM=SCURV/SPLINE,{profile}
FLANGE=SSURF/REVOLV,RIM,AXIS,(POINT/0,0,0),(VECTOR/0,0,1),CCLW,30,120
UP=VECTOR/0,0,1
CUTTER/{cutter}
INTOL/0
OUTTOL/.05
FROM/0,0,90
SCON/DS,FLANGE,PARAM,.1,1.9,.1,.75,AT,UP
SCON/PS,TO,FLANGE,PLUS,0
SCON/AXIS,UP
SCON/FEED,0,0,0,0
SCON/FEED,(PLANE/0,0,1,50)
SCON/STEPOV,.1,4,0,16
SMIL/{work},DS,PARAM,.1,.1,CRSSPL,PLUS,STEPOV,PLUS
FINI
"
            );
            let ran = run::run(&text, Verify::Full);
            assert_eq!(ran.faults(), Vec::<String>::new(), "{profile} {work}");
        }
    }
}

/// Beyond the hole there is no sheet over the dome that the tool could rest on.
#[test]
fn a_motion_over_a_hole_goes_down_on_the_other_side() {
    let work = "GO/ON,(PLANE/0,1,0,2),TO,DOME
INDIRV/1,0,0
TLON,GOFWD/(PLANE/0,1,0,2),ON,(PLANE/1,0,0,20)";
    let ends = [0.0, 0.1, 8.0].map(|hole| {
        let ran = run::run(&program(hole, "10,5", work), Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{hole}");
        ran.places[ran.places.len() - 1]
    });
    for [x, _, z] in ends {
        assert!(z > 14.0 && z < 18.0 && (x - 20.0).abs() < 1e-6, "{x} {z}");
    }
}

/// A dome down to its equator, where it is upright: the lower end of the flank touches there, not the rim of the top.
#[test]
fn the_last_pass_round_a_dome_stands_at_its_equator() {
    let mill = [
        "SCON/DS,DOME,PARAM,.5,1,0,3,AT,DOWN
SCON/PS,TO,DOME,PLUS,0
SCON/AXIS,(VECTOR/0,0,1)
SCON/FEED,0,0,0,0
SCON/STEPOV,.1,4,0,0
SMIL/ZIGZAG,DS,PARAM,.5,0,CRSSPL,PLUS,STEPOV,PLUS",
        "GOMILL/DOME,UCONST,0,STEPOV,.1,ZIGZAG,START,.5",
        "GOLOFT/DOME,UCONST,1",
    ];
    for (work, cutter) in mill.into_iter().zip(["10,5", "10,5", "12,2"]) {
        let text = program(0.0, cutter, work).replace(
            "(0,0,20),TANSPL,$\n (VECTOR/1,0,0),(25,0,14),(40,0,0)",
            "(0,0,30),TANSPL,$\n (VECTOR/1,0,0),(30,0,0),TANSPL,(VECTOR/0,0,-1)",
        );
        let text = text.replace("FROM/-20,2,60", "FROM/60,2,60");
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{work}");
        let lowest = ran.places.iter().map(|p| p[2]).fold(f64::INFINITY, f64::min);
        assert!(lowest > -5.1 && lowest < -1.9, "{work}: {lowest}");
    }
}

/// The tool comes down beside the tip of a cone, from a place to which the tip is the nearest of it.
#[test]
fn a_tool_beside_the_tip_of_a_cone_stands_outside() {
    for seam in ["0,360", "90,450", "180,540"] {
        let text = format!(
            "PARTNO CONE
UNITS/MM
RIM=SCURV/CURSEG,(0,0,40),(25,0,0)
CONE=SSURF/REVOLV,RIM,AXIS,(POINT/0,0,0),(VECTOR/0,0,1),CCLW,{seam}
CUTTER/10,5
INTOL/.01
OUTTOL/.01
FROM/-20,0,60
GO/ON,(PLANE/0,1,0,0),TO,CONE,ON,(PLANE/1,0,0,-20)
FINI
"
        );
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{seam}");
        // The centre is 5 from the side, which falls by 8 in 5.
        let z = 8.0 + 5.0 * (1.0 + 2.56_f64).sqrt() - 5.0;
        let [x, _, at] = ran.places[ran.places.len() - 1];
        assert!((x + 20.0).abs() < 1e-6 && (at - z).abs() < 0.03, "{seam}: {at} {z}");
    }
}

/// From the top of a dome the first ring lies as near as the next ones.
#[test]
fn the_first_ring_round_a_top_is_no_wider_than_the_scallop_lets_it() {
    let work = "SCON/DS,DOME,PARAM,0,.5,0,3,AT,DOWN
SCON/PS,TO,DOME,PLUS,0
SCON/AXIS,(VECTOR/0,0,1)
SCON/FEED,0,0,0,0
SCON/STEPOV,.05,4,0,0
SMIL/ZIGZAG,DS,PARAM,0,0,CRSSPL,PLUS,STEPOV,PLUS";
    let ran = run::run(&program(0.0, "10,5", work), Verify::Full);
    assert_eq!(ran.faults(), Vec::<String>::new());
}

/// Passes are as near to each other as the surface with its thickness asks for: 30 % closer round 20 and 6.
#[test]
fn passes_leave_the_scallop_on_a_thickness() {
    let text = "PARTNO THICK
UNITS/MM
LINE=SCURV/CURSEG,(0,0,20),(60,0,20)
LIES=SSURF/REVOLV,LINE,AXIS,(POINT/0,0,0),(VECTOR/1,0,0),CCLW,-80,80
CUTTER/8,4
INTOL/.01
OUTTOL/.01
FROM/0,0,100
SCON/DS,LIES,PARAM,0,1,.2,.8,AT,(VECTOR/0,0,1)
SCON/PS,TO,LIES,MINUS,6
SCON/AXIS,(VECTOR/0,0,1)
SCON/FEED,0,0,0,0
SCON/STEPOV,.1,6,0,0
SMIL/ZIGZAG,DS,PARAM,0,.2,TANSPL,PLUS,STEPOV,PLUS
FINI
";
    assert_eq!(run::run(text, Verify::Full).faults(), Vec::<String>::new());
}

/// REGION holds what a recorded outline goes round: over the seam of a dome, about its top, and all of the top above a level.
#[test]
fn outlines_on_a_dome_hold_what_they_go_round() {
    let square = |x: [f64; 2], y: [f64; 2]| {
        let [[a, b], [c, d]] = [x, y];
        format!(
            "CLDAT/START,1,UVPPS
GO/ON,(PLANE/1,0,0,{a}),TO,DOME,ON,(PLANE/0,1,0,{c})
INDIRV/1,0,0
TLON,GOFWD/(PLANE/0,1,0,{c}),ON,(PLANE/1,0,0,{b})
GOLFT/(PLANE/1,0,0,{b}),ON,(PLANE/0,1,0,{d})
GOLFT/(PLANE/0,1,0,{d}),ON,(PLANE/1,0,0,{a})
GOLFT/(PLANE/1,0,0,{a}),ON,(PLANE/0,1,0,{c})
CLDAT/NOMORE,1"
        )
    };
    let within = |x: [f64; 2], y: [f64; 2]| {
        let work = format!(
            "{}
GOTO/{},{},50
REGION/1,IN
GOMILL/DOME,UCONST,0,STEPOV,.1,PICKFD,RETR,(PLANE/0,0,1,50)",
            square(x, y),
            x[0],
            y[0]
        );
        let ran = run::run(&program(0.0, "6,3", &work), Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{x:?} {y:?}");
        // What is milled, not the outline before it or the ways above.
        let begins = ran.places.iter().position(|p| p[2] >= 49.9).expect("up once");
        let milled = ran.places[begins..].iter().filter(|p| p[2] < 30.0).copied();
        let milled: Vec<[f64; 3]> = milled.collect();
        assert!(milled.len() > 20, "{x:?} {y:?}: {}", milled.len());
        let beyond = |at: f64, [from, to]: [f64; 2]| (from - at).max(at - to);
        for p in &milled {
            assert!(beyond(p[0], x) < 0.5 && beyond(p[1], y) < 0.5, "{x:?} {y:?} {p:?}");
        }
    };
    within([10.0, 20.0], [-6.0, 6.0]);
    within([-8.0, 7.0], [-6.0, 9.0]);
    within([-20.0, -10.0], [-6.0, 6.0]);
}

/// A half of a ball of 60 whose pole stands at this height, and a flat end of 12.
fn quarter(pole: i32, work: &str) -> String {
    let at = f64::from(pole) * core::f64::consts::FRAC_1_SQRT_2;
    let arc = format!("CURSEG,$\n (0,0,{pole}),({},0,{at}),(30,0,0)", at.abs());
    program(0.0, "12,0", work)
        .replace("SPLINE,(0,0,20),TANSPL,$\n (VECTOR/1,0,0),(25,0,14),(40,0,0)", &arc)
}

/// A flat bottom that lies on a ball all along is touched behind all the way round, so that passes to and fro stand abreast.
#[test]
fn a_flat_bottom_goes_round_a_ball_behind_which_it_touches() {
    let work = "MULTAX
SCON/DS,DOME,PARAM,.2,.9,0,3,AT,(VECTOR/0,0,1)
SCON/PS,TO,DOME,PLUS,0
SCON/AXIS,NORMDS
SCON/FEED,0,0,0,0
SCON/STEPOV,.1,4,0,0
SMIL/ZIGZAG,DS,PARAM,.2,0,CRSSPL,PLUS,STEPOV,PLUS";
    let text = quarter(30, work);
    let ran = run::run(&text, Verify::Full);
    assert_eq!(ran.faults(), Vec::<String>::new());
    // As near to the contact as the bottom is wide: on a sphere of that radius, but for the chords.
    let radius = aptc_geometry::trig::hypot(30.0, 6.0);
    let beside =
        ran.places.iter().filter(|p| (aptc_geometry::Vec3::from(**p).norm() - radius).abs() < 0.02);
    assert!(beside.count() + 1 == ran.places.len(), "{}", ran.places.len());
    assert!(ran.places.len() < 2500, "{}", ran.places.len());
}

/// One that is led over the bottom of a bowl has no summit below it that a pass could go over.
#[test]
fn a_flat_bottom_is_led_over_that_of_a_bowl() {
    let work = "SCON/DS,OVER,PARAM,0,1,0,1,ON,DOWN
SCON/PS,TO,DOME,PLUS,0
SCON/AXIS,(VECTOR/0,0,1)
SCON/FEED,0,0,0,0
SCON/STEPOV,1,3,0,0
SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS";
    let text = quarter(-30, work);
    let ran = run::run(&text, Verify::Full);
    assert!(ran.faults().iter().all(|code| code == "APT5002"), "{:?}", ran.told);
    let low = ran.places.iter().map(|p| p[2]).fold(f64::INFINITY, f64::min);
    assert!((low + (900.0_f64 - 36.0).sqrt()).abs() < 0.05, "{low} {:?}", ran.told);
    assert!(ran.places.len() < 1500, "{}", ran.places.len());
}

/// Straight passes beside the axis of a bowl: in its parameters their long cut vectors are curves, between which nothing is left.
#[test]
fn passes_across_a_bowl_clear_it_to_the_last() {
    let text = "PARTNO A BOWL
UNITS/MM
ARCH=SCURV/CURSEG,(0,0,0),(12,0,2),(22,0,7)
BOWL=SSURF/REVOLV,ARCH,AXIS,(POINT/0,0,0),(VECTOR/0,0,1),CCLW,0,180
OVER=SSURF/SMESH,RULED,SPLINE,(5,5,60),(10,9,60),$
 SPLINE,(1,10,60),(6,14,60)
CUTTER/4
INTOL/.01
OUTTOL/.02
FROM/18,18,80
SCON/DS,OVER,PARAM,0,1,0,1,AT,(VECTOR/0,0,-1)
SCON/PS,TO,BOWL,PLUS,0
SCON/AXIS,(VECTOR/0,0,1)
SCON/FEED,0,0,0,0
SCON/STEPOV,.02,2,0,0
SMIL/ZIGZAG,DS,PARAM,0,0,CRSSPL,PLUS,STEPOV,PLUS
END
FINI
";
    let ran = run::run(text, Verify::Full);
    assert_eq!(ran.faults(), Vec::<String>::new());
    // Of many passes of one cut vector each.
    assert!(ran.places.len() > 200, "{}", ran.places.len());
}
