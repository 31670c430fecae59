//! Surfaces that close in themselves: domes whole and with a hole on the axis, beyond which lines that go straight on would cross.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// A dome 80 wide and 20 high whose profile begins so far from the axis, level there, and statements.
fn program(hole: f64, cutter: &str, work: &str) -> String {
    format!(
        "PARTNO DOMES
UNITS/MM
RIM=SCURV/SPLINE,({hole},0,20),TANSPL,$
 (VECTOR/1,0,0),(25,0,14),(40,0,0)
DOME=SSURF/REVOLV,RIM,AXIS,(POINT/0,0,0),(VECTOR/0,0,1),CCLW,0,360
OVER=SSURF/SMESH,XYZ,SPLINE,(-14,-6,40),(12,-9,40),$
 SPLINE,(-12,9,40),(14,6,40)
DOWN=VECTOR/0,0,-1
CUTTER/{cutter}
INTOL/.01
OUTTOL/.01
FROM/-20,2,60
{work}
END
FINI
"
    )
}

/// Passes over the top: what they leave is told, and nothing is left.
#[test]
fn passes_over_the_top_clear_it() {
    let work = "SCON/DS,OVER,PARAM,0,1,0,1,AT,DOWN
SCON/PS,TO,DOME,PLUS,0
SCON/AXIS,(VECTOR/0,0,1)
SCON/FEED,0,0,0,0
SCON/STEPOV,.05,4,0,0
SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS";
    for hole in [0.0, 0.001, 4.0] {
        for cutter in ["10,5", "12,2"] {
            let ran = run::run(&program(hole, cutter, work), Verify::Full);
            assert_eq!(ran.faults(), Vec::<String>::new(), "{hole} {cutter}");
        }
    }
}

/// Beyond the hole there is no sheet over the dome that the tool could rest on.
#[test]
fn a_motion_over_a_hole_goes_down_on_the_other_side() {
    let work = "GO/ON,(PLANE/0,1,0,2),TO,DOME
INDIRV/1,0,0
TLON,GOFWD/(PLANE/0,1,0,2),ON,(PLANE/1,0,0,20)";
    let ends = [0.0, 0.1, 8.0].map(|hole| {
        let ran = run::run(&program(hole, "10,5", work), Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{hole}");
        ran.places[ran.places.len() - 1]
    });
    for [x, _, z] in ends {
        assert!(z > 14.0 && z < 18.0 && (x - 20.0).abs() < 1e-6, "{x} {z}");
    }
}
