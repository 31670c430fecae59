//! One mistake is told once, and what misses the part is told where it is programmed.

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

#[test]
fn a_region_that_failed_is_told_once_and_lets_nothing_be_milled() {
    let recorded = format!("CLDAT/START,1,UVPDS\n{}\nCLDAT/NOMORE,1", along(20.0, 2.0, 38.0));
    let lines = "GOLOFT/F,UCONST,.5\nGODLTA/9\nFROM/0,0,60\nGOMILL/F,UCONST,0,STEPOV,1";
    let text = format!("FROM/0,0,60\n{recorded}\nREGION/1,IN\n{lines}");
    let ran = run::run(&format!("{HEAD}{text}\nNOPOST\nFINI\n"), Verify::Full);
    let [(code, message)] = &ran.told[..] else { panic!("{:?}", ran.told) };
    assert_eq!(code, "APT2055");
    let words = "UVPDS takes the drive surface, and D is no SSURF";
    assert!(message.ends_with(words), "{message}");
    assert_eq!(ran.places.len(), 2, "{:?}", ran.places);
    // Once it is off lines are milled.
    for off in ["REGION/OFF", "REGION/1,OFF"] {
        let text = text.replace("GODLTA/9", off);
        let ran = run::run(&format!("{HEAD}{text}\nNOPOST\nFINI\n"), Verify::Full);
        assert!(ran.told.len() == 1 && ran.places.len() > 10, "{off} {:?}", ran.told);
    }
}

#[test]
fn pickfd_of_gomill_without_a_way_back_is_told_by_its_own_words() {
    let told = told("FROM/0,0,60\nGOMILL/F,UCONST,0,STEPOV,1,PICKFD");
    let [(code, message)] = &told[..] else { panic!("{told:?}") };
    assert!(code == "APT2040" && message.contains("GOMILL has nothing"), "{message}");
    codes("FROM/0,0,60\nGOMILL/F,UCONST,0,STEPOV,1,PICKFD,RETR,9", &[]);
}

#[test]
fn the_way_from_where_a_line_was_broken_off_is_not_told() {
    let text = "S1=SCURV/SPLINE,(0,0,0),(20,0,3),(40,0,2),(60,0,0)
S2=SCURV/SPLINE,(0,20,3),(20,20,6),(40,20,5),(60,20,3)
S3=SCURV/SPLINE,(0,40,0),(20,40,3),(40,40,2),(60,40,0)
G=SSURF/COMBIN,(SSURF/RULED,S1,S2),(SSURF/RULED,S2,S3)
FROM/30,20,60\nGOMILL/G,VCONST,.1,STEPOV,.2\nGOMILL/G,UCONST,5,STEPOV,.25";
    codes(text, &["APT2043"]);
    // From a place that the program names it is.
    let from = text.replace("STEPOV,.2\n", "STEPOV,.2\nGOTO/60,2,.5\n");
    codes(&from, &["APT2043", "APT5009"]);
}

/// GO onto D, at that place along y, and GOFWD over it.
fn along(y: f64, from: f64, to: f64) -> String {
    format!(
        "D=PLANE/0,1,0,{y}\nFROM/{from},{y},30\nGO/ON,D,TO,F,ON,(PLANE/1,0,0,{from})
INDIRV/1,0,0\nTLON,GOFWD/D,ON,(PLANE/1,0,0,{to})"
    )
}

#[test]
fn motion_wholly_beyond_a_sculptured_surface_is_told() {
    let all = told(&along(55.0, 2.0, 38.0));
    let [go, gofwd] = all.as_slice() else { panic!("{all:?}") };
    for (code, words) in [go, gofwd] {
        assert_eq!(code, "APT2061");
        assert!(words.contains("beyond the border of F, by 1"), "{words}");
    }
    // No farther than the cutter's radius it reaches over the border, or nearly so.
    codes(&along(42.0, 2.0, 38.0), &[]);
    codes(&along(20.0, 2.0, 38.0), &[]);
    // From beyond to beyond, and over all of the surface: only where GO ends is beyond.
    codes(&along(20.0, -20.0, 60.0), &["APT2061"]);
    // Off it, and onto it.
    codes(&along(20.0, 20.0, 60.0), &[]);
    codes(&along(20.0, -20.0, 20.0), &["APT2061"]);
    // What is not put out is not told.
    codes(&format!("DNTCUT\n{}\nCUT", along(55.0, 2.0, 38.0)), &[]);
}

#[test]
fn a_flank_along_a_low_wall_is_not_beyond_it() {
    let wall = "W=SSURF/RULED,(SCURV/SPLINE,(0,0,0),(20,3,0),(40,0,0)),AXIS,(VECTOR/0,0,2)
PL=PLANE/0,0,1,-6\nFROM/0,-20,20\nINDIRV/0,1,0
GO/TO,W,TO,PL,ON,(PLANE/1,0,0,5)\nINDIRV/1,0,0\nTLRGT,GOFWD/W,ON,(PLANE/1,0,0,35)";
    for wall in [wall.to_owned(), format!("THICK/0,.5,0\n{wall}")] {
        let all = told(&wall);
        assert!(!all.iter().any(|(code, _)| code == "APT2061"), "{all:?}");
    }
}

/// TO a round island in which the cutter stands where the motion begins leads to its far wall, which is told with the depth: along upright
/// walls, and in space.
#[test]
fn a_cutter_that_begins_in_its_check_surface_is_told() {
    // The front of the cutter at y = -16 is that far from the island's axis, less what this leans.
    for (island, asked) in
        [("0,0,0,0,0,1,20", 4.0), ("0,0,0,0,.1,1,20", 20.0 - 16.0 / f64::sqrt(1.01))]
    {
        let program = |from: f64, word: &str| {
            format!(
                "UNITS/MM\nFLOOR=PLANE/0,0,1,0\nMIDDLE=PLANE/1,0,0,0\nISLAND=CYLNDR/{island}\nCUTTER/10\n\
                 INTOL/.01\nOUTTOL/.01\nFROM/0,-60,30\nGO/ON,MIDDLE,TO,FLOOR,ON,(PLANE/0,1,0,{from})\n\
                 INDIRV/0,1,0\nTLON,GOFWD/MIDDLE,{word}\nFINI\n"
            )
        };
        let ran = run::run(&program(-21.0, "TO,ISLAND"), Verify::Full);
        let [(code, message)] = &ran.told[..] else { panic!("{:?}", ran.told) };
        assert_eq!(code, "APT2062");
        let deep = message.split("stands ").nth(1).and_then(|m| m.split(' ').next());
        let deep: f64 = deep.and_then(|d| d.parse().ok()).expect("how deep");
        assert!((deep - asked).abs() < 1e-3, "{message}");
        assert!(message.contains("ISLAND"), "{message}");
        assert!(ran.places.last().is_some_and(|p| p[1] > 10.0), "{:?}", ran.places);
        // Clear of it, at it, to get past it, and at the second place that is meant.
        for (from, word) in
            [(-50.0, "TO,ISLAND"), (-50.0, "TO,2,INTOF,ISLAND"), (-21.0, "PAST,ISLAND")]
        {
            let ran = run::run(&program(from, word), Verify::Full);
            let told = ran.told.iter().any(|(code, _)| code == "APT2062");
            assert!(!told, "{from} {word} {:?}", ran.told);
        }
    }
}

/// The second number of MAXDP is for regional milling: at a motion along surfaces it is told, once.
#[test]
fn a_length_of_maxdp_is_told_where_it_does_not_count() {
    let program = |maxdp: &str| {
        format!(
            "UNITS/MM\nS=CYLNDR/0,0,-60,0,1,0,60\nL1=LINE/XAXIS\nCUTTER/8,2\nINTOL/.01\nOUTTOL/.01\n\
             MAXDP/{maxdp}\nFROM/-20,-10,20\nPSIS/S\nGO/ON,L1,TO,S\nINDIRV/1,0,0\n\
             TLON,GOFWD/L1,ON,(PLANE/1,0,0,10)\nGOFWD/L1,ON,(PLANE/1,0,0,30)\nNOPOST\nFINI\n"
        )
    };
    let ran = run::run(&program("2,20"), Verify::Full);
    let [(code, message)] = &ran.told[..] else { panic!("{:?}", ran.told) };
    assert_eq!(code, "APT1305");
    assert!(message.contains("MAXDP, 20,"), "{message}");
    for maxdp in ["2", "-4,0"] {
        assert!(run::run(&program(maxdp), Verify::Full).told.is_empty(), "{maxdp}");
    }
}
