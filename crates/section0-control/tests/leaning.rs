//! Passes of flat ends that lean over bumps: no more than the scallop is left between them, and the proof tells so.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

fn program(bumps: [f64; 2], cutter: &str, bands: [&str; 2], more: &str) -> String {
    let [a, b] = bumps;
    let [intol, outtol] = bands;
    format!(
        "PARTNO BUMPS
UNITS/MM
FORM=SSURF/SMESH,XYZ,SPLINE,(0,0,1),(20,0,{a}),(40,0,1),$
 SPLINE,(0,20,0),(20,20,{b}),(40,20,0),$
 SPLINE,(0,40,2),(20,40,0),(40,40,2)
UP=VECTOR/0,0,1
SAFE=PLANE/0,0,1,40
CUTTER/{cutter}
INTOL/{intol}
OUTTOL/{outtol}
MULTAX/ON
FROM/0,0,50
{more}
FINI
"
    )
}

/// Where the axis turns along the passes the rim clears a place beside its contact otherwise than it would going straight on.
#[test]
fn an_axis_that_turns_along_the_passes_leaves_no_more() {
    for bumps in [[0.0, 3.0], [-1.0, 3.0], [1.0, 5.0]] {
        for work in [
            "ZIGZAG,DS,PARAM,.2,.2,TANSPL,PLUS,STEPOV,PLUS",
            "PICKFD,DS,PARAM,.2,.2,CRSSPL,PLUS,STEPOV,PLUS",
        ] {
            let more = format!(
                "SCON/DS,FORM,PARAM,.2,1.8,.2,1.8,AT,UP
SCON/PS,TO,FORM,PLUS,0
SCON/AXIS,ATANGL,DS,14,CUTANG,2
SCON/FEED,SAFE
SCON/FEED,500,500,200,2000
SCON/STEPOV,.05,4,0,9
SMIL/{work}"
            );
            let ran = run::run(&program(bumps, "8,0", [".01", ".005"], &more), Verify::Full);
            let faults: Vec<_> = ran.faults().into_iter().filter(|c| c != "APT5007").collect();
            assert_eq!(faults, Vec::<String>::new(), "{bumps:?} {work}");
        }
    }
}

/// A band as wide as the strip that a steep rim clears is no reason to lay the passes without regard to it.
#[test]
fn a_wide_band_does_not_hide_how_little_a_steep_rim_clears() {
    let more = "TLAXIS/ATANGL,PS,75,CUTANG,5
GOMILL/FORM,UCONST,.5,STEPOV,.1,PICKFD,SCALOP,.06,MAXSTP,3.3,START,.3,$
 THRU,.6,RETR,10";
    let ran = run::run(&program([2.0, 1.0], "8,0", [".1", ".2"], more), Verify::Full);
    assert_eq!(ran.faults(), Vec::<String>::new());
}
