//! What changes from one motion to the next: tolerances, allowances, the feed near a check surface, the axis in place.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;
use aptc_geometry::Vec3;
use run::Ran;

const HEAD: &str = "PARTNO CHANGES\nUNITS/MM\nMID=PLANE/0,1,0,0\n";

fn ran(text: &str) -> Ran {
    run::run(&format!("{HEAD}{text}\nNOPOST\nFINI\n"), Verify::Full)
}

/// That nothing is told, so that all is proved.
fn proved(text: &str) -> Ran {
    let ran = ran(text);
    assert!(ran.told.is_empty(), "{text}: {:?}", ran.told);
    ran
}

/// Two motions of a ball over a dome or in a bowl, with these tolerances.
fn twice(surface: &str, cutter: &str, first: &str, second: &str) -> String {
    format!(
        "S={surface}\nCUTTER/{cutter}\n{first}\nFROM/-40,0,50\nGO/ON,MID,TO,S,ON,(PLANE/1,0,0,-30)
INDIRV/1,0,0\nTLON,GOFWD/MID,ON,(PLANE/1,0,0,-15)\n{second}
GOFWD/MID,ON,(PLANE/1,0,0,0)"
    )
}

#[test]
fn a_motion_comes_out_of_the_wider_band_of_the_one_before_into_its_own() {
    let dome = "SPHERE/0,0,-100,100";
    let bowl = "SPHERE/0,0,100,100";
    for surface in [dome, bowl, "QADRIC/.0025,.004,0,0,0,0,0,0,1,0"] {
        for cutter in ["10,5", "10,2", "10"] {
            for [first, second] in [
                ["INTOL/.01\nOUTTOL/.02", "OUTTOL/.01"],
                ["INTOL/.01\nOUTTOL/.02", "OUTTOL/.003"],
                ["INTOL/.02\nOUTTOL/.02", "TOLER/.001"],
                ["INTOL/0\nOUTTOL/.05", "INTOL/.002\nOUTTOL/0"],
                ["INTOL/.05\nOUTTOL/0", "INTOL/0\nOUTTOL/.002"],
                ["INTOL/.01\nOUTTOL/.01", "OUTTOL/.05"],
            ] {
                proved(&twice(surface, cutter, first, second));
            }
        }
    }
}

/// A larger cutter stands in the wall by itself, and another surface was held to no band before: in the plane and in space.
#[test]
fn another_cutter_or_surface_is_in_no_band_of_the_motion_before() {
    let text = |lean: f64, first: &str, change: &str, wall: &str| {
        format!(
            "F=PLANE/0,0,1,0\nW=PLANE/0,1,{lean},0\nX=PLANE/0,1,{lean},.8\nCUTTER/10\n{first}\nFROM/-60,20,20
GO/TO,W,TO,F,ON,(PLANE/1,0,0,-30)\nINDIRV/1,0,0\nTLLFT,GOFWD/W,ON,(PLANE/1,0,0,-20)\n{change}
GOFWD/{wall},ON,(PLANE/1,0,0,-5)"
        )
    };
    for lean in [0.0, 0.1] {
        for (first, change, wall) in [
            ("INTOL/1\nOUTTOL/.01", "CUTTER/11\nINTOL/.01", "W"),
            ("INTOL/0\nOUTTOL/1", "CUTTER/11\nOUTTOL/.01", "W"),
            ("INTOL/0\nOUTTOL/1", "OUTTOL/.01", "X"),
        ] {
            let ran = ran(&text(lean, first, change, wall));
            assert_eq!(ran.codes(), ["APT2003"], "{lean} {change} {wall} {:?}", ran.told);
        }
    }
}

/// One side of the band is none, or the axis is another one: the way into the narrower band is in it, with the axis that the tool has.
#[test]
fn the_way_into_a_band_that_begins_at_the_surface_stays_in_it() {
    let along = |cutter: &str, bands: [&str; 2], axis: &str| {
        format!(
            "P=CYLNDR/0,0,-60,.3,1,0,60\nD=CYLNDR/0,0,0,0,0,1,40\nCUTTER/{cutter}\n{}\nMULTAX\nFROM/-60,5,30
TLAXIS/{axis}\nGO/TO,D,TO,P,ON,(PLANE/0,1,0,0)\nINDIRV/0,1,0
GOFWD/D,ON,(PLANE/1,1,0,0)\n{}\nGOFWD/D,ON,(PLANE/1,0,0,0)",
            bands[0], bands[1]
        )
    };
    for bands in [
        ["INTOL/0\nOUTTOL/1", "OUTTOL/.5"],
        ["INTOL/0\nOUTTOL/.1", "OUTTOL/.05"],
        ["INTOL/.5\nOUTTOL/0", "INTOL/.05"],
        ["INTOL/.01\nOUTTOL/.05", "TOLER/.001"],
    ] {
        for cutter in ["8,2,2,2,0,0,25", "8", "8,4"] {
            proved(&along(cutter, bands, "0,0,1"));
            proved(&along(cutter, bands, "ATANGL,1,8"));
        }
    }
}

#[test]
fn another_allowance_is_no_wider_band() {
    let ran = ran(&twice("SPHERE/0,0,-100,100", "10,5", "TOLER/.02", "THICK/.5"));
    assert_eq!(ran.codes(), ["APT2004"], "{:?}", ran.told);
    let (_, words) = &ran.told[0];
    assert!(words.contains("0.48 in it, allowed 0.02"), "{words}");
}

#[test]
fn the_axis_turns_evenly_to_where_the_feed_slows_down() {
    let text = "S=SPHERE/0,0,-60,60\nCUTTER/10,2\nTOLER/.01\nFEDRAT/600,1.5,150\nMULTAX\nFROM/-40,0,50\nTLAXIS/NORMPS
GO/ON,MID,TO,S,ON,(PLANE/1,0,0,-30)\nINDIRV/1,0,0\nTLON,GOFWD/MID,ON,(PLANE/1,0,0,-28)";
    let ran = proved(text);
    let [.., split, _] = ran.places[..] else { panic!("{:?}", ran.places) };
    let [.., axis, _] = ran.axes[..] else { panic!("{:?}", ran.axes) };
    let normal = (Vec3::from(split) - Vec3::new(0.0, 0.0, -60.0)).normalize();
    assert!((normal - Vec3::from(axis)).norm() < 1e-3, "{normal} {axis:?}");
}

#[test]
fn a_rapid_retract_from_a_deeper_cut_is_none_into_the_surface_of_the_next_motion() {
    let text = "S=QADRIC/.0025,.004,0,0,0,0,0,0,1,0\nCUTTER/12,3\nTOLER/.01\nMULTAX\nFROM/-20,0,50\nTHICK/-.3\nTLAXIS/NORMPS
GO/ON,MID,TO,S,ON,(PLANE/1,0,0,-20)\nINDIRV/1,0,0\nTLON,GOFWD/MID,ON,(PLANE/1,0,0,-10)\nRAPID\nGODLTA/0,0,RISE
THICK/0\nRAPID\nGOTO/-20,0,50\nTLAXIS/0,0,1\nCUTTER/6,3\nGO/ON,MID,TO,S,ON,(PLANE/1,0,0,-20)
INDIRV/1,0,0\nTLON,GOFWD/MID,ON,(PLANE/1,0,0,0)";
    proved(&text.replace("RISE", "50"));
    // Deeper than where it began it is one.
    let down = ran(&text.replace("RISE", "-.2"));
    assert!(down.codes().contains(&"APT5005".to_owned()), "{:?}", down.told);
}
