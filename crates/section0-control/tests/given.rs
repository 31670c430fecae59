//! Words that are given and have no effect on regional milling are told, those that have one have it in path and proof.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// What stands before all: a hill, its axis, a ball.
const HEAD: &str = "PARTNO GIVEN
UNITS/MM
F=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(30,0,4),(60,0,0),SPLINE,(0,20,3),(30,20,8),(60,20,3),SPLINE,(0,40,0),(30,40,4),(60,40,0)
FLAT=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(30,0,0),(60,0,0),SPLINE,(0,40,0),(30,40,0),(60,40,0)
UP=VECTOR/0,0,1
CUTTER/6,3
INTOL/.01
OUTTOL/.01
MULTAX/ON
FROM/30,20,50
SCON/DS,F,PARAM,0,2,0,2,AT,UP
SCON/PS,TO,F,PLUS,0
SCON/AXIS,UP
SCON/FEED,900,800,300,2000
SCON/FEED,(PLANE/0,0,1,30)
SCON/STEPOV,0,10,0,0
";
const ZIGZAG: &str = "SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS";

/// What comes of statements behind the head; long ones go on in the next line.
fn ran(text: &str) -> run::Ran {
    let mut all = String::new();
    for line in HEAD.lines().chain(text.lines()).chain(["FINI"]) {
        let mut length = 0;
        for part in line.split_inclusive(',') {
            if length + part.len() > 70 {
                all.push_str("$\n");
                length = 0;
            }
            length += part.len();
            all.push_str(part);
        }
        all.push('\n');
    }
    run::run(&all, Verify::Full)
}

/// The messages of Section 2 and of the proof.
fn told(text: &str) -> Vec<(String, String)> {
    let ran = ran(text);
    let own = |m: &(String, String)| m.0.starts_with("APT2") || m.0.starts_with("APT5");
    ran.told.into_iter().filter(own).collect()
}

/// That just one message is told, of that code and with those words.
fn one(text: &str, code: &str, words: &str) {
    let told = told(text);
    let [(c, m)] = told.as_slice() else { panic!("{text}: {told:?}") };
    assert!(c == code && m.contains(words), "{text}: {m}");
}

/// That nothing is told.
fn none(text: &str) {
    assert_eq!(told(text), [], "{text}");
}

const REGION: &str = "CLDAT/START,1,UVPPS\nGOTO/10,10,30\nINTSEC/(PLANE/0,0,1,5),WITH,F\nCLDAT/NOMORE,1\nREGION/1,IN";

#[test]
fn words_that_smil_takes_from_scon_are_told() {
    none(ZIGZAG);
    for (word, said) in [
        ("THICK/.5", "THICK leaves 0.5 on part surfaces and has no effect on SMIL"),
        ("TLAXIS/NORMPS", "TLAXIS/NORMPS has no effect on SMIL"),
        ("TLAXIS/.1,0,1", "has no effect on SMIL, whose tool axis is the 0, 0, 1 of SCON/AXIS"),
        ("GCLEAR/START,NORMAL,5", "GCLEAR has no effect on SMIL"),
        ("CUTTER/OPTION,2,10,1", "CUTTER/OPTION,2,10,1 has no effect on SMIL"),
    ] {
        one(&format!("{word}\n{ZIGZAG}"), "APT2059", said);
        // Once, however often it is milled.
        one(&format!("{word}\n{ZIGZAG}\n{word}\nGODLTA/20\n{ZIGZAG}"), "APT2059", said);
    }
    let region = REGION.replace("GOTO/10,10,30\n", "");
    let all = told(&format!("{region}\n{ZIGZAG}"));
    let own: Vec<_> = all.iter().filter(|m| m.0 == "APT2059").collect();
    assert!(own.len() == 1 && own[0].1.starts_with("REGION has no effect on SMIL"), "{all:?}");
    // What is off, used, or the same as SCON says is none of that.
    for words in [
        "THICK/0,.2",
        "THICK/.5\nTHICK/0",
        "THICK/.5\nSCON/PS,TO,F,PLUS,.5",
        "TLAXIS/0,0,2",
        "TLAXIS/NORMPS\nGOLOFT/F,VCONST,1\nGODLTA/(VECTOR/0,0,20)",
        "TLAXIS/NORMPS\nSCON/AXIS,ATANGL,PS,0,CUTANG,0",
        "GCLEAR/START,NORMAL,5\nGCLEAR/OFF",
        "GCLEAR/START,NORMAL,5\nGOLOFT/F,VCONST,1\nGODLTA/20",
        "CUTTER/OPTION,2,10,1\nCUTTER/OPTION,2,OFF",
    ] {
        none(&format!("{words}\n{ZIGZAG}"));
    }
    for line in ["GOLOFT/F,VCONST,1", "GOMILL/F,VCONST,0,STEPOV,1"] {
        one(&format!("CUTTER/OPTION,1,10,1\n{line}"), "APT2059", "CUTTER/OPTION,1,10,1");
        let word = &line[..6];
        let said = format!("TLPROJ has no effect on {word}");
        one(&format!("TLPROJ/(VECTOR/0,0,-1),ON\n{line}"), "APT2059", &said);
    }
    one(
        "GCLEAR/START,NORMAL,5\nGOMILL/F,VCONST,0,STEPOV,1",
        "APT2059",
        "GCLEAR has no effect on GOMILL",
    );
}

#[test]
fn a_thickness_with_on_is_told_where_it_is_given() {
    one("SCON/PS,ON,F,PLUS,-.2", "APT2059", "the thickness -0.2 has no effect with ON");
    none("SCON/PS,ON,F,PLUS,0");
}

#[test]
fn a_holder_that_is_held_against_nothing_is_told_once() {
    let holder = "HOLDER/40,10,40,60";
    let bare = "HOLDER is given and nothing is checked";
    one(&format!("{holder}\n{ZIGZAG}\nGODLTA/20\n{ZIGZAG}"), "APT2060", bare);
    one(&format!("{holder}\nGOLOFT/FLAT,VCONST,.5"), "APT2060", bare);
    let along = "FLOOR=PLANE/0,0,1,0\nWALL=PLANE/0,1,0,50\nEND1=PLANE/1,0,0,60";
    one(
        &format!("{along}\n{holder}\nGO/TO,WALL,TO,FLOOR\nTLRGT,GORGT/WALL,TO,END1"),
        "APT2060",
        bare,
    );
    let checked = format!("{holder}\nCHKSRF/PS,ON\nGOLOFT/FLAT,VCONST,.5");
    assert!(told(&checked).iter().all(|m| m.0 != "APT2060"));
    none(&format!("{holder}\nHOLDER/OFF\n{ZIGZAG}"));
}

#[test]
fn avoidance_while_nothing_is_checked_is_told_once() {
    let idle = "AVCTRL has no effect on ";
    one(&format!("AVCTRL/ON\n{ZIGZAG}\nGODLTA/20\n{ZIGZAG}"), "APT2059", idle);
    one("AVCTRL/AXIS\nGOLOFT/FLAT,VCONST,.5", "APT2059", idle);
    none(&format!("AVCTRL/ON\nAVCTRL/OFF\n{ZIGZAG}"));
    none(&format!("AVCTRL/ON\nCHKSRF/PS,ON\n{ZIGZAG}"));
    // With HOLDER it is one mistake, and a CHKSRF that failed is told.
    one(&format!("AVCTRL/ON\nHOLDER/40,10,40,60\n{ZIGZAG}"), "APT2060", "nothing is checked");
}

#[test]
fn a_region_of_one_pass_is_told_where_the_step_leads_out() {
    let out = ZIGZAG.replace("STEPOV,PLUS", "STEPOV,MINUS");
    one(&out, "APT2041", "one pass is milled: from 0,0 MINUS behind STEPOV");
    one(&out.replace("ZIGZAG", "PICKFD"), "APT2041", "one pass is milled");
    one("GOMILL/F,VCONST,2,STEPOV,.2", "APT2041", "from VCONST,2 a STEPOV of 0.2 leads out of F");
    one("GOMILL/F,UCONST,0,STEPOV,-.2", "APT2041", "from UCONST,0 a STEPOV of -0.2 leads out of F");
    // Where one is asked for, or there is room for no other, it is as it should be.
    none(&format!("SCON/STEPOV,0,10,0,1\n{out}"));
    none(&format!("SCON/DS,F,PARAM,0,2,1,1,AT,UP\n{}", ZIGZAG.replace("0,0,TANSPL", "0,1,TANSPL")));
}

#[test]
fn what_chksrf_names_keeps_the_thickness_of_check_surfaces() {
    let line = "GOLOFT/FLAT,VCONST,.5,CHORD,.01";
    let passes = "SCON/DS,FLAT,PARAM,0,2,.4,.6,AT,UP\nSCON/PS,TO,FLAT,PLUS,0\nSCON/STEPOV,0,2,0,0\n\
         SMIL/ZIGZAG,DS,PARAM,0,.4,TANSPL,PLUS,STEPOV,PLUS";
    let lines = "GOMILL/FLAT,VCONST,.4,STEPOV,.1,THRU,2";
    let away = |ran: &run::Ran| {
        // Of a ball from the sphere below, and the plane beside.
        let ball = |p: &[f64; 3]| {
            ((p[0] - 40.0).powi(2) + (p[1] - 20.0).powi(2) + (p[2] + 33.0).powi(2)).sqrt() - 33.0
        };
        let near = ran.places.iter().skip(1);
        near.clone().map(ball).fold(f64::INFINITY, f64::min)
    };
    for work in [line, passes, lines] {
        for (thick, left) in [("THICK/0", 0.0), ("THICK/0,0,2", 2.0), ("THICK/0,0,1,0", 1.0)] {
            let text = format!(
                "GOTO/10,16,20\nK=SPHERE/40,20,-30,30\nCHKSRF/K,ON\nAVCTRL/AXIS,LIMIT,30\n{thick}\n{work}"
            );
            let ran = ran(&text);
            assert_eq!(ran.faults(), Vec::<String>::new(), "{text}");
            let found = away(&ran);
            assert!(found > left - 0.011 && (left == 0.0 || found < left + 0.2), "{found} {text}");
        }
        // Beside a wall the path ends by so much before.
        for (wall, named) in [
            ("PLANE/1,0,0,50", "in W, with the thickness 2 on it"),
            (
                "SSURF/SMESH,RULED,SPLINE,(50,-5,-5),(50,45,-5),SPLINE,(50,-5,30),(50,45,30)",
                ", with the thickness 2 on it",
            ),
        ] {
            let text = format!("W={wall}\nGOTO/10,16,20\nTHICK/0,0,2\nCHKSRF/W,ON\n{work}");
            one(&text, "APT2046", named);
            let ran = ran(&text);
            let far = ran.places.iter().skip(2).map(|p| p[0]).fold(f64::NEG_INFINITY, f64::max);
            assert!(far <= 45.01, "{far}");
        }
    }
}

#[test]
fn ordinary_motion_keeps_the_thickness_of_check_surfaces_too() {
    let scene =
        "W=PLANE/1,0,0,50\nK=PLANE/0,1,0,60\nFLOOR=PLANE/0,0,1,0\nGOTO/20,20,0\nCHKSRF/W,ON";
    for (thick, x, gouges) in [("0", 46.0, false), ("0,0,2", 46.0, true), ("0,0,2", 44.9, false)] {
        let text = format!("{scene}\nTHICK/{thick}\nGOTO/{x},20,0");
        assert_eq!(!told(&text).is_empty(), gouges, "{text}");
    }
    // Ending beside it, and led along it with less on it.
    none(&format!(
        "{scene}\nTHICK/0,0,2\nPSIS/FLOOR\nINDIRV/1,0,0\nTLON,GOFWD/(LINE/XAXIS,20),TO,W"
    ));
    none(&format!("{scene}\nTHICK/0,0,2\nGO/TO,W,TO,FLOOR\nTLLFT,GOLFT/W,TO,K"));
}

#[test]
fn the_part_surface_by_its_name_is_told_to_be_named_ps() {
    let text = "SCON/PS,TO,F,PLUS,-.5\nCHKSRF/F,ON\nSMIL/PATH,DS,PARAM,0,1,TANSPL,PLUS";
    assert!(told(text).iter().any(|m| m.0 == "APT2046"));
    none(&text.replace("CHKSRF/F", "CHKSRF/PS"));
}

#[test]
fn along_a_curve_normds_is_its_crsspl() {
    let curve = "G=SCURV/SPLINE,(5,5,20),CRSSPL,(VECTOR/0,0,-1),(20,30,20),(40,10,20),(55,35,20),CRSSPL,(VECTOR/.3,0,-1)\n\
         SCON/DS,G,PARAM,0,3,AT,CRSSPL\nSCON/AXIS,NORMDS,MINUS\nSMIL/PATH,DS,PARAM,0,0,TANSPL,PLUS";
    let ran = ran(curve);
    assert_eq!(ran.faults(), Vec::<String>::new());
    let axes = &ran.axes[1..];
    let (first, last) = (axes[0], axes[axes.len() - 1]);
    let lean = -0.3 / 1.09_f64.sqrt();
    assert!(
        axes.len() > 10 && (first[2] - 1.0).abs() < 1e-12 && (last[0] - lean).abs() < 1e-9,
        "{last:?}"
    );
    assert!(axes.windows(2).all(|a| a[1][0] <= a[0][0] + 1e-12));
    // Without CRSSPL there is none.
    let bare = curve.replace(",CRSSPL,(VECTOR/0,0,-1)", "").replace(",CRSSPL,(VECTOR/.3,0,-1)", "");
    one(&bare.replace("AT,CRSSPL", "AT,UP"), "APT2020", "no tool axis");
}

#[test]
fn a_pass_that_stands_in_a_ridge_is_told_as_that() {
    let text = "R=SSURF/SMESH,RULED,SPLINE,(0,0,0),(40,0,0),SPLINE,(0,12,0),(40,12,0),SPLINE,(0,15,4),(40,15,4),SPLINE,(0,18,0),(40,18,0),SPLINE,(0,30,0),(40,30,0)
CUTTER/8
SCON/DS,R,PARAM,0,1,0,4,AT,UP
SCON/PS,TO,R,PLUS,0
SCON/STEPOV,0,3,0,0
SMIL/PICKFD,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS";
    let told = told(text);
    assert!(told.iter().any(|m| m.0 == "APT2049" && m.1.contains("where a pass ends")), "{told:?}");
    assert!(!told.iter().any(|m| m.1.contains("on the way to the next pass")), "{told:?}");
}

#[test]
fn a_first_point_left_out_far_from_the_tool_is_told() {
    let skip = format!("{ZIGZAG},1");
    one(
        &format!("GOTO/0,0,30\n{skip}"),
        "APT2048",
        "is left out, and the tool does not stand there but at 0, 0, 30",
    );
}

#[test]
fn a_lift_along_the_normal_leads_over_an_upright_wall() {
    let wall = "W=SSURF/SMESH,RULED,SPLINE,(45,10,8),(45,30,8),SPLINE,(45,10,20),(45,30,20)\nCHKSRF/PS,W,ON\n";
    let pass = "SMIL/PATH,DS,PARAM,0,.55,TANSPL,PLUS";
    for lift in ["AVCTRL/NORMPS,LIMIT,40", "AVCTRL/AXIS,LIMIT,40", "AVCTRL/NORMPS"] {
        for pass in [
            pass.into(),
            pass.replace(",.55,", ",.5,"),
            pass.replace("0,.55,TANSPL,PLUS", "2,.48,TANSPL,MINUS"),
        ] {
            none(&format!("{wall}{lift}\n{pass}"));
        }
    }
}
