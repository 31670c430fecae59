//! What CHKSRF asks of single places of regional milling, and of what is added to its lines: the path is held to it without the proof.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// A floor with a wall that stands beside it at x = 45, over y up to 20, and something above.
fn program(close: &str, work: &str) -> String {
    format!(
        "PARTNO ALONE
UNITS/MM
FLOOR=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(20,0,2),(40,0,2),(60,0,0),$
 SPLINE,(0,30,1),(20,30,3),(40,30,3),(60,30,1)
EDGE=SCURV/SPLINE,(0,15,30),(30,15,31),(60,15,30)
WALL=SSURF/SMESH,RULED,SPLINE,(45,-20,-10),(45,20,-10),$
 SPLINE,(45,-20,40),(45,20,40)
CEIL=PLANE/0,0,1,100
UP=VECTOR/0,0,1
SAFE=PLANE/0,0,1,44
CUTTER/12,6,0,6,0,0,30
HOLDER/20,45,40,80
INTOL/.01
OUTTOL/.01
MULTAX/ON
TLAXIS/0,0,1
FROM/20,15,9
SCON/DS,FLOOR,PARAM,0,3,0,1,AT,UP
SCON/PS,TO,FLOOR,PLUS,0
SCON/AXIS,UP
SCON/FEED,0,0,0,0
{close}
{work}
END
FINI
"
    )
}

/// The codes of all messages, and the number of positions.
fn run(text: &str, verify: Verify) -> (Vec<String>, usize) {
    let ran = run::run(text, verify);
    (ran.codes(), ran.places.len())
}

const AVOID: &str = "AVCTRL/CUTANG,CONST,1,RANGE,-70,70,NORMPS";

/// Statements, the code that tells of a gouge, and whether AVCTRL gets out of its way.
const GOUGES: [(&str, &str, &str, bool); 9] = [
    ("CHKSRF/WALL,ON", "SMIL/POSN,DS,PARAM,2.1,.3,INCR,0", "APT2046", true),
    ("CHKSRF/WALL,ON", "SMIL/POSN,DS,PARAM,2.1,.3,INCR,-5", "APT2046", true),
    ("CHKSRF/CEIL,ON", "SMIL/POSN,DS,PARAM,1,.5,INCR,-25", "APT2046", false),
    ("CHKSRF/CEIL,ON", "SMIL/POSN,DS,PARAM,1,.5,INCR,(VECTOR/0,0,25)", "APT2046", false),
    ("CHKSRF/WALL,ON", "GOLOFT/FLOOR,VCONST,.3,AT,2.1", "APT2046", true),
    ("CHKSRF/WALL,ON", "GOMILL/FLOOR,VCONST,.1,STEPOV,.2,AT,2.1,RETR,50", "APT2046", true),
    // The first lines are clear of the wall; what is led over is not.
    ("CHKSRF/WALL,CEIL,ON", "GOMILL/FLOOR,UCONST,1.9,STEPOV,1,AT,.3,RETR,25", "APT2049", false),
    ("CHKSRF/CEIL,ON\nGCLEAR/THRU,NORMAL,25", "GOLOFT/FLOOR,VCONST,.3", "APT2046", false),
    ("CHKSRF/WALL,ON", "GOLOFT/EDGE,CHORD,.1", "APT2046", false),
];

#[test]
fn a_single_place_that_gouges_is_told_without_the_proof() {
    for (close, work, code, _) in GOUGES {
        for verify in [Verify::Full, Verify::Off] {
            let text = program(close, work);
            assert_eq!(run(&text, verify).0, [code], "{text}");
        }
    }
}

#[test]
fn a_single_place_gets_out_of_the_way() {
    for (close, work, ..) in GOUGES.into_iter().filter(|g| g.3) {
        // From above: what is lifted over the wall comes through its edge from below.
        let text = program(&format!("{close}\n{AVOID}"), work).replace("15,9", "15,60");
        let (codes, points) = run(&text, Verify::Full);
        assert!(codes.is_empty() && points > 1, "{codes:?} {text}");
    }
}

#[test]
fn the_way_to_a_place_that_is_lifted_over_a_wall_is_told() {
    let (close, work, ..) = GOUGES[0];
    for verify in [Verify::Full, Verify::Off] {
        let text = program(&format!("{close}\n{AVOID}"), work);
        assert_eq!(run(&text, verify).0, ["APT2049"], "{text}");
    }
}

#[test]
fn a_single_place_that_is_clear_stays_as_it_is() {
    for (close, work, ..) in GOUGES {
        let far = close.replace("WALL,", "").replace("CEIL,", "").replace("CHKSRF/ON", "");
        let text = program(&format!("{far}\nCHKSRF/PS,ON"), work);
        let far = run(&text, Verify::Full);
        assert!(far.0.is_empty() && far.1 > 1, "{far:?} {text}");
    }
}

/// A plane that the line does not meet is that of the word that named it.
#[test]
fn a_plane_that_is_not_met_has_the_word_that_named_it() {
    for word in ["START", "THRU", "AT"] {
        let work = format!("GOLOFT/FLOOR,VCONST,.3,{word},TO,CEIL");
        let ran = run::run(&program("HOLDER/OFF", &work), Verify::Off);
        let wanted = format!("along the line the tool nowhere meets the plane of {word}");
        assert_eq!(ran.told, [("APT2042".to_owned(), wanted)]);
    }
}

/// With the tool end led on its part surface what leads it away and back is free, and all of it on the surface is proved, also
/// where the first point is left out and the tool stands elsewhere.
#[test]
fn an_end_led_on_the_surface_is_free_where_it_is_led_away() {
    // From above, and from behind.
    let program = |(lift, along): (&str, &str), work: &str| {
        let set = format!(
            "SCON/DS,FLOOR,PARAM,0,3,0,1,ON,{along}\nSCON/PS,ON,FLOOR,PLUS,0\nSCON/STEPOV,0,6,{lift},0\nSCON/FEED,SAFE\nHOLDER/OFF"
        );
        program(&set, work)
    };
    for lift in [("0", "UP"), ("0", "(VECTOR/0,0,-1)"), ("1", "(VECTOR/0,0,-1)")] {
        for work in [
            "SMIL/PICKFD,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS",
            "SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS",
            "SMIL/ZIGZAG,DS,PARAM,0,0,CRSSPL,PLUS,STEPOV,PLUS,1",
        ] {
            let text = program(lift, work);
            let (codes, points) = run(&text, Verify::Full);
            // That it is left out is told.
            let told: &[&str] = if work.ends_with(",1") { &["APT2048"] } else { &[] };
            assert!(codes == told && points > 20, "{codes:?} {text}");
        }
    }
}

/// A point along a curve on a floor, nothing of which is to be cut in by (INTOL/0).
#[test]
fn a_tool_that_just_touches_is_not_in() {
    let text = |curve: &str| {
        format!(
            "UNITS/MM
INTOL/0
OUTTOL/.01
CUTTER/0
FLOOR=PLANE/.3,.1,1,.7
P1=POINT/INTOF,FLOOR,(PLANE/1,0,0,0),(PLANE/0,1,0,0)
P2=POINT/INTOF,FLOOR,(PLANE/1,0,0,20),(PLANE/0,1,0,10)
P3=POINT/INTOF,FLOOR,(PLANE/1,0,0,40),(PLANE/0,1,0,0)
{curve}
CHKSRF/FLOOR,ON
FROM/0,0,50
GOLOFT/S1,START,0,THRU,2
FINI
"
        )
    };
    let (codes, points) = run(&text("S1=SCURV/SPLINE,P1,P2,P3"), Verify::Off);
    assert!(codes.is_empty() && points > 20, "{codes:?} {points}");
    let below = "M1=MATRIX/TRANSL,0,0,-.02\nS1=SCURV/SPLINE,P1,P2,P3,TRFORM,M1";
    assert_eq!(run(&text(below), Verify::Off).0, ["APT2046"]);
}

/// Ordinary motion over the floor, on a plane across it, as far as another; its chords use the band to its edge.
fn ordinary(close: &str, intol: f64) -> String {
    format!(
        "PARTNO ORDINARY
UNITS/MM
FLOOR=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(30,0,8),(60,0,9),(90,0,2),$
 SPLINE,(0,30,9),(30,30,16),(60,30,14),(90,30,6),$
 SPLINE,(0,60,4),(30,60,10),(60,60,12),(90,60,8)
WALL=PLANE/0,1,0,30
POST=SPHERE/50,30,16,4
CUTTER/12,2
INTOL/{intol}
OUTTOL/.01
FROM/0,0,60
GO/ON,WALL,TO,FLOOR,ON,(PLANE/1,0,0,20)
INDIRV/1,0,0
{close}
TLON,GOFWD/WALL,ON,(PLANE/1,0,0,60)
NOPOST
FINI
"
    )
}

#[test]
fn ordinary_motion_within_its_band_is_none_that_gouges_its_part_surface() {
    for intol in [0.0, 0.001, 0.005, 0.01, 0.02] {
        let (codes, points) = run(&ordinary("", intol), Verify::Full);
        assert!(codes.is_empty(), "{intol}: {codes:?}");
        for close in ["CHKSRF/PS,ON", "CHKSRF/FLOOR,ON", "CHKSRF/PS,FLOOR,ON"] {
            assert_eq!(
                run(&ordinary(close, intol), Verify::Full),
                (vec![], points),
                "{intol} {close}"
            );
        }
    }
}

#[test]
fn a_motion_that_is_stopped_gives_one_message() {
    for close in ["CHKSRF/POST,ON", "CHKSRF/PS,POST,ON"] {
        for verify in [Verify::Full, Verify::Off] {
            assert_eq!(run(&ordinary(close, 0.01), verify).0, ["APT2046"], "{close}");
        }
    }
}

/// CUTTER/0 is a point: a plane that leans over it is not in its way.
#[test]
fn a_point_under_a_plane_that_leans_is_proved() {
    let text = "UNITS/MM
OUTTOL/.01
CUTTER/0
BED=PLANE/0,0,1,0
ROOF=PLANE/0,1,.2,0
FROM/0,-30,20
INDIRV/0,1,0
GO/TO,ROOF,TO,BED
TLRGT,GORGT/ROOF,PAST,(PLANE/1,0,0,50)
NOPOST
FINI
";
    let (codes, points) = run(text, Verify::Full);
    assert!(codes.is_empty() && points >= 3, "{codes:?} {points}");
}
