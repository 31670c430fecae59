//! Regions led ON another surface, and what passes leave beside crests.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// A dome 27 wide with a surface over it that leads a bull nose, its axis the normal of the dome, by that offset.
fn dome(offset: &str) -> String {
    format!(
        "PARTNO LED
UNITS/MM
F1=SSURF/PATCH,POLYGN,PLUS,$
(-0.5,0.6,-6.4),(9.7,0.6,2.1),(18.7,0.7,2.1),(26.9,-0.7,-6.4),$
(-0.8,9.7,2.1),(9.3,9.0,10.7),(18.1,9.1,10.7),(26.7,9.9,2.1),$
(0.1,17.8,2.1),(9.8,18.3,10.7),(18.1,17.1,10.7),(27.2,18.1,2.1),$
(-0.7,26.2,-6.4),(8.6,27.1,2.1),(17.0,26.8,2.1),(27.4,27.5,-6.4)
D1=SSURF/PATCH,POLYGN,PLUS,$
(1.5,1.6,37.8),(9.4,1.6,37.6),(17.3,1.6,39.1),(25.2,1.6,39.0),$
(1.5,9.5,36.4),(9.4,9.5,38.8),(17.3,9.5,38.6),(25.2,9.5,39.3),$
(1.5,17.3,36.5),(9.4,17.3,37.2),(17.3,17.3,37.5),(25.2,17.3,38.3),$
(1.5,25.2,38.1),(9.4,25.2,37.8),(17.3,25.2,39.5),(25.2,25.2,38.3)
SAFE=PLANE/0,0,1,95
CUTTER/16,4.8
INTOL/.01
OUTTOL/.02
MULTAX/ON
FROM/13,13,60
SCON/DS,D1,PARAM,0,.8,0,1,ON,(VECTOR/.12,0,-1){offset}
SCON/PS,TO,F1,PLUS,-.2
SCON/AXIS,ATANGL,PS,0,CUTANG,0
SCON/FEED,0,0,0,0
SCON/FEED,SAFE
SCON/STEPOV,.05,5,0,0
CHKSRF/PS,ON
SMIL/PICKFD,DS,PARAM,0,0,CRSSPL,PLUS,STEPOV,PLUS
END
FINI
"
    )
}

/// Any place of a bottom that lies on the surface may touch, and of them its middle does: with an offset and without.
#[test]
fn a_bottom_square_on_a_dome_stands_on_its_middle() {
    for offset in ["", ",.1"] {
        let ran = run::run(&dome(offset), Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{offset}");
        assert!(ran.places.len() > 100, "{}", ran.places.len());
    }
}

/// Passes of a ball around a flared body, each vector turning the axis by three degrees: on its way the ball bulges over the
/// chord of its centre, and clears what chords would leave.
#[test]
fn what_a_turning_ball_leaves_is_not_more_than_it_does() {
    let program = "PARTNO FLARE
UNITS/MM
F1C=SCURV/CURSEG,(POINT/0,0,11.02726),(POINT/16.07287,0,20.8838),(POINT/32.14573,0,37.74085)
F1=SSURF/REVOLV,F1C,AXIS,(POINT/0,0,0),(VECTOR/1,0,0),CCLW,-59.36454,59.36454
SAFE=PLANE/0,0,1,90
CUTTER/20,10
INTOL/0
OUTTOL/.01
MULTAX/ON
FROM/0,0,100
SCON/DS,F1,PARAM,.236,.704,.083,.963,AT,NORMAL
SCON/PS,TO,F1,MINUS,-.2
SCON/AXIS,NORMDS,MINUS
SCON/FEED,0,0,0,0
SCON/FEED,SAFE
SCON/STEPOV,.1,8,1,0
CHKSRF/PS,ON
SMIL/ZIGZAG,DS,PARAM,.236,.083,CRSSPL,PLUS,STEPOV,PLUS
END
FINI
";
    let ran = run::run(program, Verify::Full);
    assert_eq!(ran.faults(), Vec::<String>::new());
}
