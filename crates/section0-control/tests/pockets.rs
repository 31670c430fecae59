//! POCKET keeps a cutter inside of upright walls over the corners given.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

fn program(cutter: &str) -> String {
    format!(
        "UNITS/MM\nCUTTER/{cutter}\nOUTTOL/.01\nFEDRAT/200\nFROM/0,0,30\n\
         PSIS/(PLANE/0,0,1,-6)\nP1=POINT/-30,-20\nP2=POINT/30,-20\nP3=POINT/30,20\n\
         P4=POINT/-30,20\nPOCKET/1.5,1,1,100,200,200,0,1,P1,P2,P3,P4\nFINI\n"
    )
}

#[test]
fn a_cutter_touches_the_walls_and_no_more() {
    let cos = aptc_geometry::trig::cos_deg(10.0);
    // Sides that lean in by 10 degrees meet the bottom this much farther out than the corner's middle.
    let meet = 2.0 / cos + 2.0 * aptc_geometry::trig::tan(10.0_f64.to_radians());
    let bell = format!("{},2,4.5,2,0,-10,20", 2.0 * (4.5 + meet));
    for (cutter, widest) in [
        ("8", 4.0),
        ("8,1,3,1,0,0,20", 4.0),
        (bell.as_str(), 6.5),
        // Sides that lean out leave leaning walls, from the corners on.
        ("8,1,0,0,0,5,20", 4.0),
    ] {
        let text = program(cutter);
        let ran = run::run(&text, Verify::Full);
        let most = |i: usize| ran.places.iter().map(|p| p[i].abs()).fold(0.0, f64::max);
        let [x, y] = [most(0) + widest - 30.0, most(1) + widest - 20.0];
        assert!(x.abs() < 1e-9 && y.abs() < 1e-9, "{x} {y} {:?} {text}", ran.told);
    }
}

/// Half of its diameter would be inside of the walls; the corner is not.
#[test]
fn a_cutter_that_is_no_solid_mills_no_pocket() {
    let ran = run::run(&program("8,2,4.5,2,0,-10,20"), Verify::Full);
    assert_eq!(ran.faults(), ["APT2022"], "{:?}", ran.told);
}

/// On a floor that leans the tool end lies on it, and what of the cutter is lower is told.
#[test]
fn what_reaches_below_a_floor_that_leans_is_told() {
    let sin = 0.1 / f64::sqrt(1.01);
    for (cutter, deep) in [("12", 6.0 * sin), ("12,6", 6.0 * (1.0 - f64::sqrt(1.0 - sin * sin)))] {
        let program = |lean: f64, axis: &str, kind: u32| {
            format!(
                "UNITS/MM\nMULTAX\nCUTTER/{cutter}\nINTOL/.01\nOUTTOL/.01\nFEDRAT/200\nFROM/0,0,30\nTLAXIS/{axis}\n\
                 PSIS/(PLANE/0,{lean},1,-6)\nP1=POINT/-30,-20\nP2=POINT/30,-20\nP3=POINT/30,20\n\
                 P4=POINT/-30,20\nPOCKET/1,.3,.3,100,200,200,0,{kind},P1,P2,P3,P4\nFINI\n"
            )
        };
        let told = |text: &str| {
            let ran = run::run(text, Verify::Off);
            ran.told
                .into_iter()
                .filter(|(code, _)| code == "APT2063")
                .map(|(_, m)| m)
                .collect::<Vec<_>>()
        };
        for kind in [2, 3] {
            let [message] = &told(&program(0.1, "0,0,1", kind))[..] else { panic!("{kind}") };
            let by = message.split("reaches ").nth(1).and_then(|m| m.split(' ').next());
            let by: f64 = by.and_then(|by| by.parse().ok()).expect("how deep");
            assert!((by - deep).abs() < 1e-5, "{deep} {message}");
        }
        assert!(told(&program(0.0, "0,0,1", 3)).is_empty());
        assert!(told(&program(0.1, "0,.1,1", 3)).is_empty());
        assert!(told(&program(0.1, "0,0,1", 0)).is_empty());
    }
}
