//! Lines that REGION limits: the straight way from one stretch to the next is told, and so is the line it belongs to.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// A surface of 60 by 60 with the window from 20 to 40 recorded as outline 1; and statements.
fn program(rise: f64, work: &str) -> String {
    let spline = |y: f64, z: f64| format!("SPLINE,(0,{y},{z}),(30,{y},{}),(60,{y},{z})", z + rise);
    let splines = [spline(0.0, 0.0), spline(30.0, rise), spline(60.0, 0.0)];
    format!(
        "UNITS/MM\nF=SSURF/SMESH,XYZ,{}\nCUTTER/4,2\nINTOL/.01\nOUTTOL/.01\n\
         PL=PLANE/1,0,0,20\nPR=PLANE/1,0,0,40\nPF=PLANE/0,1,0,20\nPB=PLANE/0,1,0,40\n\
         FROM/30,30,60\nCLDAT/START,1,UVPPS\nINDIRV/-1,1,0\nGO/ON,PB,TO,F,ON,PL\nINDIRV/0,-1,0\n\
         TLON,GOFWD/PL,ON,PF\nTLON,GOLFT/PF,ON,PR\nTLON,GOLFT/PR,ON,PB\nTLON,GOLFT/PB,ON,PL\n\
         CLDAT/NOMORE,1\n{work}\nFINI\n",
        splines.join(",$\n")
    )
}

#[test]
fn a_straight_way_through_the_window_is_told_once_a_region() {
    let two =
        "GOLOFT/F,VCONST,1,CHORD,.01\nGODLTA/0,0,40\nGOLOFT/F,VCONST,.9,CHORD,.01\nGODLTA/0,0,40";
    let ran = run::run(&program(0.0, &format!("REGION/1,OUT\n{two}")), Verify::Full);
    assert_eq!(ran.faults(), ["APT2057"], "{:?}", ran.told);
    let text = &ran.told.iter().find(|(code, _)| code == "APT2057").unwrap().1;
    assert!(
        text.contains("from the tool end 20, 30, 0 ") && text.contains(" at 40, 30, 0, "),
        "{text}"
    );
    let again = format!("REGION/1,OUT\n{two}\nREGION/1,OUT\n{two}");
    assert_eq!(run::run(&program(0.0, &again), Verify::Full).faults(), ["APT2057", "APT2057"]);
}

#[test]
fn nothing_is_told_where_there_is_no_such_way() {
    for work in [
        // One stretch of each line.
        "REGION/1,IN\nGOLOFT/F,VCONST,1,CHORD,.01",
        // The line passes the window.
        "REGION/1,OUT\nGOLOFT/F,VCONST,.5,CHORD,.01",
        "REGION/1,OUT\nGCLEAR/AWAY,NORMAL,5\nGCLEAR/BACK,NORMAL,5\nGOLOFT/F,VCONST,1,CHORD,.01",
        "REGION/1,OUT\nGCLEAR/ON,CLEARS,(PLANE/0,0,1,30)\nGOLOFT/F,VCONST,1,CHORD,.01",
        "GOLOFT/F,VCONST,1,CHORD,.01",
    ] {
        let ran = run::run(&program(0.0, work), Verify::Full);
        assert!(ran.faults().is_empty(), "{work}: {:?}", ran.told);
    }
}

#[test]
fn over_a_hill_the_way_is_refuted_or_refused() {
    let line = "REGION/1,OUT\nGOLOFT/F,VCONST,1,CHORD,.01";
    let ran = run::run(&program(4.0, line), Verify::Full);
    assert_eq!(ran.faults(), ["APT2057", "APT5001"], "{:?}", ran.told);
    let checked = format!("CHKSRF/PS,ON\n{line}");
    let ran = run::run(&program(4.0, &checked), Verify::Full);
    assert_eq!(ran.faults(), ["APT2046"], "{:?}", ran.told);
    let over = "on the way over what REGION leaves out";
    assert!(ran.told.iter().any(|(_, text)| text.contains(over)), "{:?}", ran.told);
}
