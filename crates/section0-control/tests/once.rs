//! One mistake is told once.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

const HEAD: &str = "PARTNO ONCE\nUNITS/MM
F=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(20,0,4),(40,0,0),$
 SPLINE,(0,20,3),(20,20,8),(40,20,3),SPLINE,(0,40,0),(20,40,4),(40,40,0)
CUTTER/6,3\nINTOL/.01\nOUTTOL/.01\n";

/// Codes and words of all messages.
fn told(text: &str) -> Vec<(String, String)> {
    run::run(&format!("{HEAD}{text}\nNOPOST\nFINI\n"), Verify::Full).told
}

/// That just these codes are told, in order.
fn codes(text: &str, codes: &[&str]) {
    let told = told(text);
    let found: Vec<&str> = told.iter().map(|(code, _)| code.as_str()).collect();
    assert_eq!(found, codes, "{text}: {told:?}");
}

/// What asks for both sections of CLDAT.
const ASKED: &str = "N=NUMF(CLDATA,1)\nM=NUMF(CLDATA,2)\nA=CLDATF(1,UPS,1)\nB=CLDATF(2,UPS,1)
REGION/1,IN\nREGION/2,IN\nREGION/2,OFF";

#[test]
fn a_section_of_cldat_that_is_refused_is_told_once() {
    // An outline round the middle, recorded by INTSEC.
    let round = "INTSEC/(PLANE/0,0,1,5),WITH,F";
    let recorded = format!("FROM/0,0,60\nCLDAT/START,1,UVPPS\n{round}\nCLDAT/NOMORE,1");
    codes(&format!("{recorded}\nN=NUMF(CLDATA,1)\nREGION/1,IN"), &["APT2052"]);
    // The second section begins within the first, which goes on.
    let within = format!(
        "FROM/0,0,60\nCLDAT/START,1,UVPPS\nCLDAT/START,2,UVPPS\n{round}\nCLDAT/NOMORE,2\nCLDAT/NOMORE,1\n{ASKED}"
    );
    codes(&within, &["APT2041", "APT2052"]);
    // The open section ends at a NOMORE of another number.
    let other = format!("FROM/0,0,60\nCLDAT/START,1,UVPPS\n{round}\nCLDAT/NOMORE,2\n{ASKED}");
    codes(&other, &["APT2052", "APT2041"]);
    // Nothing was begun: once more is once, and what never stood in CLDAT is a mistake of its own.
    let never = format!("{recorded}\nCLDAT/NOMORE,2\nCLDAT/NOMORE,2\n{ASKED}");
    codes(&never, &["APT2052", "APT2041"]);
    codes(&format!("{recorded}\nREGION/3,IN"), &["APT2052", "APT2041"]);
    codes(&format!("{recorded}\nN=NUMF(CLDATA,3)"), &["APT2052", "APT1053"]);
}

#[test]
fn a_section_that_is_given_again_counts_again() {
    let text = "FROM/0,0,60\nCLDAT/NOMORE,2\nCLDAT/START,2,UVPPS
INTSEC/(PLANE/0,0,1,5),WITH,F\nCLDAT/NOMORE,2\nN=NUMF(CLDATA,2)\nGODLTA/0,0,N\nREGION/2,IN\nCLDAT/NOMORE,2";
    codes(text, &["APT2041", "APT2052", "APT2041"]);
}
