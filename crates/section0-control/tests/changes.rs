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

/// A thin disk along two walls of a hollow, the rim of it deeper than the narrower band of the second motion allows.
fn along_two_walls(hollow: &str, axis: &str, option: &str, bands: [&str; 2], second: &str) -> Ran {
    let text = format!(
        "UNITS/MM\nPS={hollow}\nWA=PLANE/0,1,0,34\nWB=PLANE/1,0,0,-40\nCUTTER/6,1,2,1,0,0,30
CUTTER/OPTION,{option}\n{}\nMULTAX\nFROM/0,0,50\nTLAXIS/{axis}\nINDIRV/0,1,-.2\nGO/TO,WA,TO,PS,ON,(PLANE/1,0,0,0)
INDIRV/-1,0,0\nGOFWD/WA,TO,WB\n{}\nINDIRV/0,-1,0\n{second}GOFWD/WB,TO,(PLANE/0,1,0,-40)\nFINI\n",
        bands[0], bands[1]
    );
    run::run(&text, Verify::Full)
}

/// From below as well as from above its band holds a disk: it stays on the side where it was, in a motion and in a start-up.
#[test]
fn a_disk_in_a_hollow_does_not_turn_over_where_the_band_becomes_narrower() {
    type Inwards = fn([f64; 3]) -> [f64; 3];
    let hollows: [(&str, Inwards); 2] = [
        ("SPHERE/0,0,300,300", |[x, y, z]| [-x, -y, 300.0 - z]),
        ("CYLNDR/0,0,200,0,1,0,200", |[x, _, z]| [-x, 0.0, 200.0 - z]),
    ];
    let equal = "INTOL/.01\nOUTTOL/.01";
    for ((hollow, inwards), axis) in hollows.into_iter().flat_map(|hollow| {
        ["NORMPS", "ATANGL,1,5", "PERPTO,(VECTOR/1,0,0)", "0,0,1"].map(|axis| (hollow, axis))
    }) {
        for (option, bands, second) in [
            ("1,1.654,0", [equal, "INTOL/.00454"], ""),
            ("1,1.654,0", [equal, "INTOL/.001"], ""),
            ("1,3,0", ["INTOL/.05\nOUTTOL/.001", "INTOL/.01"], ""),
            ("1,2,1", [equal, "INTOL/.001"], "GO/TO,WB,TO,PS\nINDIRV/0,-1,0\n"),
            ("1,1.654,0", [equal, "TOLER/.0005"], "GO/TO,WB,TO,PS\nINDIRV/0,-1,0\n"),
        ] {
            let ran = along_two_walls(hollow, axis, option, bands, second);
            // The cutter behind the disk is deeper, and a start-up begins where the band was wider.
            let told = |code: &String| !["APT5004", "APT5009"].contains(&code.as_str());
            let faults = ran.faults().into_iter().filter(told);
            let which = format!("{hollow} {axis} {option} {bands:?} {second}");
            assert_eq!(faults.collect::<Vec<_>>(), [""; 0], "{which} {:?}", ran.told);
            for (te, ta) in ran.places.iter().zip(&ran.axes).skip(1) {
                let lean = Vec3::from(inwards(*te)).normalize().dot(&Vec3::from(*ta));
                assert!(lean > 0.9, "{which} {te:?} {ta:?}");
            }
        }
    }
}

/// One that came from below a roof stays below it, and the normal is not its axis: the cutter would swing through the roof.
#[test]
fn a_disk_that_came_from_below_is_not_turned_over() {
    let below = |axis: &str| {
        let text = format!(
            "UNITS/MM\nPS=SPHERE/0,0,320,300\nWA=PLANE/0,1,0,34\nCUTTER/6,1,2,1,0,0,30\nCUTTER/OPTION,1,2,0
TOLER/.001\nMULTAX\nFROM/0,0,10\nTLAXIS/0,0,1\nINDIRV/0,1,.2\nGO/TO,WA,TO,PS,ON,(PLANE/1,0,0,0)\nTLAXIS/{axis}
INDIRV/-1,0,0\nGOFWD/WA,ON,(PLANE/1,0,0,-20)\nFINI\n"
        );
        run::run(&text, Verify::Full)
    };
    for axis in ["NORMPS", "ATANGL,1,5"] {
        let ran = below(axis);
        let over = |(code, words): &(String, String)| {
            code == "APT2020" && words.contains("would turn over at")
        };
        assert!(ran.told.iter().any(over), "{axis} {:?}", ran.told);
    }
    // As it stands it goes on, and its proof does not let it be turned over by hand.
    assert_eq!(below("0,.1,1").faults(), ["APT5004"; 2]);
    let by_hand = below("0,0,-1");
    assert!(by_hand.codes().contains(&"APT5001".to_owned()), "{:?}", by_hand.told);
}

/// Inside of a wall: in the narrower band alone the tool would seem to stand above the hollow, or in what is opposite.
#[test]
fn the_inside_of_a_wall_stays_whole_where_the_band_becomes_narrower() {
    let oval = "QADRIC/.0001,.000625,.00001,0,0,0,0,0,0,-1";
    let waves = "TABCYL/NOZ,SPLINE,70,36,40,41,20,39,0,42,-20,40,-50,43";
    for (wall, cutter, axis, [first, second]) in [
        (oval, "8,4", "0,0,1", ["TOLER/.01", "INTOL/.00249\nOUTTOL/.00791"]),
        (oval, "8", ".09,.08,1", ["TOLER/.01", "INTOL/.00249\nOUTTOL/.00791"]),
        (oval, "8,1,3,1,0,0,40", "0,0,1", ["TOLER/.01", "INTOL/.00249\nOUTTOL/.00791"]),
        (oval, "8,4", "NORMPS", ["TOLER/.01", "INTOL/.00249\nOUTTOL/.00791"]),
        // Its axis turns by more than the first vector may: it comes into the band, and turns then.
        (oval, "8,4", "ATANGL,1,5,CUTANG,LAG,1", ["TOLER/.01", "INTOL/.00249\nOUTTOL/.00791"]),
        // Deep in the surface its place is hard to decide alone.
        (waves, "8,1,3,1,0,0,40", "ATANGL,1,5,CUTANG,LAG,1", ["TOLER/.02", "OUTTOL/.0083"]),
    ] {
        let first = first.replace("TOLER/", "INTOL/") + &first.replace("TOLER/", "\nOUTTOL/");
        let text = format!(
            "UNITS/MM\nPS=CYLNDR/0,0,300,0,1,0,300\nW1=PLANE/1,0,0,45\nW2={wall}\nCUTTER/{cutter}\n{first}\nTHICK/0,-.2,-.2
MULTAX\nFROM/0,0,50\nTLAXIS/{axis}\nINDIRV/1,0,0\nGO/TO,W1,TO,PS,ON,(PLANE/0,1,0,0)\nINDIRV/0,1,0
TLLFT,GOFWD/W1,TO,W2\n{second}\nTLLFT,GOLFT/W2,TO,(PLANE/1,0,0,-10)\nFINI\n"
        );
        let ran = run::run(&text, Verify::Full);
        assert!(ran.faults().is_empty(), "{wall} {cutter} {axis} {:?}", ran.told);
    }
}
