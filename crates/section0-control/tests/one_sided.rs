//! A band that lies wholly in the part, OUTTOL 0: where the rim of a flat end comes deeper into a hollow than its contact, and
//! where it touches by little, there are chords all the same.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// A trough along x and a twisted sheet, and the statements after what they are milled with.
fn program(intol: f64, thick: f64, axis: &str, work: &str) -> String {
    format!(
        "PARTNO ONE SIDE
UNITS/MM
TROUGH=SSURF/SMESH,XYZ,SPLINE,(0,0,4),(20,0,4.2),(40,0,4),$
 SPLINE,(0,20,1),(20,20,1.1),(40,20,1),$
 SPLINE,(0,40,4),(20,40,4.1),(40,40,4)
TWIST=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(30,0,1.2),$
 SPLINE,(0,15,.7),(30,15,2.1),$
 SPLINE,(0,30,1.3),(30,30,2.8)
SAFE=PLANE/0,0,1,30
UP=VECTOR/0,0,1
CUTTER/8,0
INTOL/{intol}
OUTTOL/0
MULTAX/ON
FROM/0,0,40
SCON/AXIS,{axis}
SCON/FEED,SAFE
SCON/FEED,500,500,200,2000
SCON/STEPOV,0,3,0,4
CHKSRF/PS,ON
SCON/PS,TO,{work},PLUS,{thick}
FINI
"
    )
}

#[test]
fn chords_are_found_with_no_room_above_the_surface() {
    for (intol, thick, axis, work) in [
        (0.005, 0.3, "ATANGL,DS,0,CUTANG,6", "TROUGH"),
        (0.05, 0.0, "ATANGL,PS,0,CUTANG,LEAD,2", "TWIST"),
        (0.02, 0.0, "ATANGL,PS,0,CUTANG,LEAD,3", "TWIST"),
    ] {
        let text = program(intol, thick, axis, work);
        let milled = format!(
            "SCON/DS,{work},PARAM,0,1,0,2,AT,UP\nSMIL/PICKFD,DS,PARAM,0,0,CRSSPL,PLUS,STEPOV,PLUS\nFINI"
        );
        let ran = run::run(&text.replace("FINI", &milled), Verify::Full);
        assert_eq!(ran.codes(), Vec::<String>::new(), "{work} {axis}");
        assert!(ran.places.len() > 15, "{work} {axis}: {}", ran.places.len());
    }
}
