//! Barrel cutters, whose corner has its centre beyond the axis, inside of hollow walls that they do not stand along.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// Along a wall from one side to the other, by the bands all the way.
fn goes_round(wall: &str, cutter: &str, floor: &str, axis: &str) {
    let text = format!(
        "UNITS/MM\nDS={wall}\nPS=PLANE/{floor}\nCUTTER/{cutter}\nINTOL/.05\nOUTTOL/.05\nMULTAX\n\
         FROM/-22,0,4\nPSIS/PS\n{axis}\nGO/TO,DS,TO,PS\nINDIRV/0,1,0\n\
         TLRGT,GOFWD/DS,ON,(PLANE/1,0,0,0)\nNOPOST\nFINI\n"
    );
    let ran = run::run(&text, Verify::Full);
    assert!(ran.faults().is_empty(), "{:?} {text}", ran.told);
    let last = ran.places.last().expect("it goes");
    assert!(last[0].abs() < 1e-6 && last[1] > 10.0, "{last:?} {text}");
}

#[test]
fn a_barrel_goes_along_hollow_walls() {
    let walls = [
        "CONE/(POINT/0,0,-70),(VECTOR/0,0,1),30",
        "CYLNDR/0,0,0,0,.5,1,45",
        "QADRIC/1,1,0,0,0,0,0,0,-40,-1600",
    ];
    for wall in walls {
        for cutter in ["20,12,-2,8,0,0,30", "20,10.02,-.02,8,0,0,30"] {
            goes_round(wall, cutter, "0,0,1,0", "TLAXIS/.1,0,1");
        }
    }
    goes_round(walls[0], "16,30,-22,20,0,0,40", "-.1,.1,1,0", "TLAXIS/NORMPS");
}
