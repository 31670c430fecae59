//! Passes across the ridge of a roof, where the normal jumps: the tool rolls over it, or turns about it, and all is proved.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// Two slopes that meet along x half way, `high` above their borders, and passes across.
fn program(high: f64, cutter: &str, axis: &str, more: &str, work: &str) -> String {
    format!(
        "PARTNO ROOF
UNITS/MM
ROOF=SSURF/SMESH,RULED,SPLINE,(0,0,0),(20,0,0),(40,0,0),$
 SPLINE,(0,15,{high}),(20,15,{high}),(40,15,{high}),$
 SPLINE,(0,30,1),(20,30,1),(40,30,1)
UP=VECTOR/0,0,1
SAFE=PLANE/0,0,1,40
CUTTER/{cutter}
INTOL/.01
OUTTOL/.01
MULTAX/ON
{more}
FROM/0,0,50
CHKSRF/PS,ON
SCON/DS,ROOF,PARAM,0,2,0,2,AT,UP
SCON/PS,TO,ROOF,PLUS,0
SCON/AXIS,{axis}
SCON/FEED,SAFE
SCON/FEED,500,500,200,2000
SCON/STEPOV,.05,3,0,7
SMIL/{work}
FINI
"
    )
}

const AXES: [&str; 3] = ["UP", "NORMDS", "ATANGL,PS,0,CUTANG,5"];
const CUTTERS: [&str; 3] = ["10,5", "10,2", "10,0"];

#[test]
fn a_pass_goes_over_a_ridge() {
    for axis in AXES {
        for cutter in CUTTERS {
            for work in [
                "ZIGZAG,DS,PARAM,0,0,CRSSPL,PLUS,STEPOV,PLUS",
                "PICKFD,DS,PARAM,2,2,CRSSPL,MINUS,STEPOV,MINUS",
            ] {
                let ran = run::run(&program(4.0, cutter, axis, "", work), Verify::Full);
                // Rims leave corners between the ends of passes, which is another matter.
                let wrong: Vec<_> = ran.faults().into_iter().filter(|c| c != "APT5007").collect();
                assert_eq!(wrong, Vec::<String>::new(), "{axis} {cutter} {work}");
                // Few vectors: no crowd of small steps before the ridge.
                let passes = 4;
                let most = if cutter == "10,5" { 16 } else { 90 };
                assert!(ran.places.len() < passes * most, "{axis} {cutter} {}", ran.places.len());
            }
        }
    }
}

/// A flat end that leans touches each slope with its rim: before the ridge and behind it stand corners between the passes, as at
/// their ends, and nothing else.
#[test]
fn corners_of_a_leaning_flat_end_stand_beside_the_ridge() {
    let mut corners = 0;
    for axis in ["LN", "ATANGL,PS,5,CUTANG,-5", "ATANGL,DS,10,CUTANG,3"] {
        for work in [
            "ZIGZAG,DS,PARAM,0,0,CRSSPL,PLUS,STEPOV,PLUS",
            "PICKFD,DS,PARAM,2,2,CRSSPL,MINUS,STEPOV,MINUS",
        ] {
            let lean = "LN=VECTOR/.1,.05,1";
            let ran = run::run(&program(4.0, "10,0", axis, lean, work), Verify::Full);
            let mut faults = ran.faults();
            corners += usize::from(!faults.is_empty());
            faults.retain(|c| c != "APT5007");
            assert_eq!(faults, Vec::<String>::new(), "{axis} {work}");
        }
    }
    assert!(corners > 3, "{corners}");
}

#[test]
fn a_way_over_a_ridge_is_no_longer_than_maxdp() {
    let work = "PATH,DS,PARAM,1,0,CRSSPL,PLUS";
    let ran = run::run(&program(4.0, "16,2", "UP", "MAXDP/1.5", work), Verify::Full);
    assert_eq!(ran.faults(), Vec::<String>::new());
    let place = |p: &[f64; 3]| aptc_geometry::Vec3::from(*p);
    // Behind FROM and the way to the first place.
    let longest = ran.places[1..].windows(2).map(|w| (place(&w[1]) - place(&w[0])).norm());
    let longest = longest.fold(0.0, f64::max);
    assert!(longest <= 1.5 * (1.0 + 1e-9), "{longest}");
}

#[test]
fn a_round_end_does_not_fit_into_a_valley() {
    let work = "PATH,DS,PARAM,1,0,CRSSPL,PLUS";
    let ran = run::run(&program(-4.0, "10,5", "UP", "", work), Verify::Full);
    assert_eq!(ran.faults(), ["APT2046"]);
}
