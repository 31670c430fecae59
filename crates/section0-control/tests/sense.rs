//! What the words before a motion say of it as a whole: the side of the part surface, and the way to go.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// A flat end on a floor beside a hollow cylinder that the floor is tangent to, with what brings it there and what is said after.
fn hollow(go: &str, said: &str) -> run::Ran {
    let text = format!(
        "PARTNO HOLLOW\nUNITS/MM\nW=PLANE/0,1,0,0\nFLOOR=PLANE/0,0,1,0\nHOLLOW=CYLNDR/0,0,60,0,1,0,60\n\
         CUTTER/12,2\nINTOL/.01\nOUTTOL/.01\nFROM/0,0,0\n{go}\nPSIS/HOLLOW\nINDIRV/1,0,0\n\
         {said}TLON,GOFWD/W,ON,(PLANE/1,0,0,20)\nNOPOST\nFINI\n"
    );
    run::run(&text, Verify::Full)
}

/// GO had the cutter touch its part surface, and so it is to touch the next one; where nothing says so it is told.
#[test]
fn the_tool_end_stays_on_a_part_surface_where_that_is_said_and_else_with_a_word() {
    let touching = "GO/ON,W,TO,FLOOR";
    assert_eq!(hollow(touching, "").faults(), ["APT2004"]);
    assert_eq!(hollow(touching, "TLONPS,").faults(), [""; 0]);
    let unsaid = hollow("", "");
    assert_eq!(unsaid.faults(), ["APT2066"]);
    let [(_, message)] = &unsaid.told[..] else { panic!("{:?}", unsaid.told) };
    // The corner's circle of 4 about the tool end, 2 up: 60 - 2 less the distance of its middle from the axis.
    let depth = (16.0_f64 + 58.0 * 58.0).sqrt() - 58.0;
    assert!(message.contains(&format!("{depth:.6} deep")), "{message}");
    assert_eq!(hollow("", "TLONPS,").faults(), [""; 0]);
    assert_eq!(hollow("", "TLOFPS,").faults(), ["APT2004"]);
}

/// The plane of AUTOPS goes through the tool end, also where GO had the cutter stand off by THICK.
#[test]
fn the_plane_of_autops_is_where_the_tool_end_is() {
    let text = "PARTNO AUTO\nUNITS/MM\nW=PLANE/0,1,0,0\nCUTTER/12,2\nTHICK/.5,0\nFROM/-20,0,30\n\
                GO/ON,W,TO,(PLANE/0,0,1,0),ON,(PLANE/1,0,0,-20)\nAUTOPS\nINDIRV/1,0,0\n\
                TLON,GOFWD/W,ON,(PLANE/1,0,0,20)\nNOPOST\nFINI\n";
    let ran = run::run(text, Verify::Full);
    assert!(ran.faults().is_empty(), "{:?}", ran.told);
    assert!(ran.places.iter().skip(1).all(|p| (p[2] - 0.5).abs() < 1e-9), "{:?}", ran.places);
}

/// Round a bar in an upright plane from its left, told a direction.
fn round_the_bar(z: f64, given: &str) -> [f64; 3] {
    let text = format!(
        "PARTNO BAR\nUNITS/MM\nBAR=CYLNDR/0,0,0,0,1,0,30\nY0=PLANE/0,1,0,0\nZS=PLANE/0,0,1,{z}\nCUTTER/8,4\n\
         INTOL/.01\nOUTTOL/.01\nFROM/-60,0,{z}\nPSIS/Y0\nINDIRV/1,0,0\nGO/TO,BAR,ON,Y0,ON,ZS\n\
         INDIRV/{given}\nTLONPS,GOFWD/BAR,ON,(PLANE/0,0,1,20)\nNOPOST\nFINI\n"
    );
    let ran = run::run(&text, Verify::Full);
    assert!(ran.faults().is_empty(), "{:?}", ran.told);
    ran.places[ran.places.len() - 1]
}

#[test]
fn a_direction_along_the_tool_axis_says_whether_a_motion_goes_up_or_down() {
    for z in [-19.0, -4.0, 0.0] {
        for (given, left) in
            [("0,0,1", true), (".2,0,1", true), ("0,0,-1", false), (".2,0,-1", false)]
        {
            let end = round_the_bar(z, given);
            assert!((end[0] < 0.0) == left, "{z} {given} {end:?}");
        }
    }
}

/// FROM and GOTO with an axis end a TLAXIS by which it turns; that is told once, where a motion follows and no TLAXIS said anything since.
#[test]
fn an_axis_of_from_or_goto_ends_the_one_that_turns() {
    let slope = |axis: &str, from: &str, after: &str| {
        let text = format!(
            "PARTNO SLOPE\nUNITS/MM\nSLOPE=PLANE/(POINT/0,0,0),(POINT/0,10,0),(POINT/40,0,10)\nW=PLANE/0,1,0,0\n\
             CUTTER/12,2\nINTOL/.01\nOUTTOL/.01\nMULTAX\nTLAXIS/{axis}\nFROM/-40,0,60{from}\n{after}\n\
             GO/ON,W,TO,SLOPE,ON,(PLANE/1,0,0,-20)\nINDIRV/1,0,0\nTLON,GOFWD/W,ON,(PLANE/1,0,0,20)\n\
             GOTO/20,0,60,0,0,1\nNOPOST\nFINI\n"
        );
        run::run(&text, Verify::Full)
    };
    let upright = |ran: &run::Ran| ran.axes.iter().all(|a| a[2] > 1.0 - 1e-9);
    let ended = slope("NORMPS", ",0,0,1", "");
    assert_eq!(ended.faults(), ["APT2067"]);
    assert!(ended.told[0].1.contains("line 10"), "{:?}", ended.told);
    assert!(upright(&ended));
    let again = slope("NORMPS", ",0,0,1", "TLAXIS/NORMPS");
    assert!(again.told.is_empty() && !upright(&again), "{:?}", again.told);
    let stays = slope("NORMPS", ",0,0,1", "TLAXIS/1");
    assert!(stays.told.is_empty() && upright(&stays), "{:?}", stays.told);
    let fixed = slope("0,0,1", ",0,0,1", "");
    assert!(fixed.told.is_empty(), "{:?}", fixed.told);
    let turns = slope("NORMPS", "", "");
    assert!(turns.told.is_empty() && !upright(&turns), "{:?}", turns.told);
    let back = slope("NORMPS", ",0,0,1", "TLAXIS/LAST");
    assert!(back.told.is_empty() && !upright(&back), "{:?}", back.told);
}

/// Lines of a sculptured surface have the axis of TLAXIS as well.
#[test]
fn an_axis_that_ends_the_one_that_turns_is_told_before_a_line_of_a_surface() {
    for line in ["GOLOFT/F,VCONST,1", "GOMILL/F,VCONST,0,STEPOV,1"] {
        let text = format!(
            "PARTNO LINE\nUNITS/MM\nF=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(30,0,4),(60,0,0),$\nSPLINE,(0,20,3),(30,20,8),(60,20,3),$\n\
             SPLINE,(0,40,0),(30,40,4),(60,40,0)\nCUTTER/6,3\nINTOL/.01\nOUTTOL/.01\nMULTAX/ON\nTLAXIS/NORMPS\n\
             FROM/0,0,50,0,0,1\n{line}\nGODLTA/0,0,40\n{line}\nNOPOST\nFINI\n"
        );
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.faults(), ["APT2067"], "{line} {:?}", ran.told);
    }
}
