//! A cutter that is missing is told once, until CUTTER comes.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

const PART: &str = "UNITS/MM
F=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(40,0,0),SPLINE,(0,40,0),(40,40,0)
LX=LINE/XAXIS
LY=LINE/YAXIS
FROM/20,20,5
";

fn codes(work: &str) -> Vec<String> {
    run::run(&format!("{PART}{work}\nFINI\n"), Verify::Full).faults()
}

#[test]
fn a_missing_cutter_is_told_once() {
    let lines = "GOLOFT/F,UCONST,.5\nGOLOFT/F,UCONST,.6\nGOMILL/F,UCONST,.1,STEPOV,.2";
    assert_eq!(codes(lines), ["APT2002"]);
    let starts = "GO/TO,LX\nGOTO/20,20,5\nGO/TO,LY";
    assert_eq!(codes(starts), ["APT2002"]);
    // Each CUTTER is a new one; the arc of this meets neither line.
    let none = "CUTTER/10,9,0,0,0,0,0";
    assert_eq!(codes(&format!("{lines}\n{none}\n{lines}")), ["APT2002", "APT2002"]);
    assert_eq!(codes("GOLOFT/F,UCONST,.5\nCUTTER/4,2\nGOLOFT/F,UCONST,.5"), ["APT2002"]);
}
