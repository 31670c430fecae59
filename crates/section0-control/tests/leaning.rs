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

/// What a flat end that leans leaves is highest where the one pass ends to clear, be that between the places that are looked at or
/// not.
#[test]
fn the_edge_of_a_tooth_is_found_wherever_it_stands() {
    let gentle = |heights: [[f64; 3]; 5]| {
        let mut text = String::new();
        for (row, z) in (0..).zip(heights) {
            let y = 12.0 * f64::from(row);
            text.push_str(&format!(
                "G{row}=SCURV/SPLINE,(0,{y},{}),(12,{y},{}),(24,{y},{})\n",
                z[0], z[1], z[2]
            ));
        }
        text + "FORM=SSURF/GENCUR,G0,G1,G2,G3,G4\n"
    };
    let surface = gentle([
        [0.27, 0.17, 0.0],
        [-0.21, -0.27, 0.16],
        [-0.22, -0.04, 0.27],
        [0.21, 0.22, 0.05],
        [0.22, 0.17, 0.28],
    ]);
    for (cutter, axis, [intol, outtol], work) in [
        ("8", "PS,3,CUTANG,LEAD,2", [".005", ".02"], "ZIGZAG,DS,PARAM,.1,.1,CRSSPL"),
        ("12", "PS,10,CUTANG,LEAD,2", ["0", ".005"], "PICKFD,DS,PARAM,.1,.1,CRSSPL"),
    ] {
        let text = format!(
            "PARTNO GENTLE
UNITS/MM
{surface}UP=VECTOR/0,0,1
SAFE=PLANE/0,0,1,40
CUTTER/{cutter}
INTOL/{intol}
OUTTOL/{outtol}
MULTAX/ON
FROM/0,0,50
SCON/DS,FORM,PARAM,.1,1.9,.1,3.9,AT,UP
SCON/PS,TO,FORM,PLUS,0
SCON/AXIS,ATANGL,{axis}
SCON/FEED,SAFE
SCON/FEED,500,500,200,2000
SCON/STEPOV,.05,3,0,12
SMIL/{work},PLUS,STEPOV,PLUS
FINI
"
        );
        let ran = run::run(&text, Verify::Full);
        let faults: Vec<_> = ran.faults().into_iter().filter(|c| c != "APT5007").collect();
        assert_eq!(faults, Vec::<String>::new(), "{cutter} {axis}");
    }
}
