//! Wide cutters over a wavy TABCYL, and long flanks beside one: they span many crests, and every cut vector is proved.

#[path = "support/run.rs"]
mod run;

use std::fmt::Write as _;

use aptc_control::Verify;
use aptc_geometry::trig;

/// A wave along x, or along z where it is a wall, that repeats itself but for its last digits, with the tool on its way across.
fn program(k: u32, wall: bool) -> String {
    // Fractions that do not repeat: the places of a low discrepancy sequence.
    let share = |i: u32| (f64::from(k + 1) * 0.618_033_988_75 * f64::from(i)).fract();
    let (height, length) = (0.05 + 0.25 * share(1), 6.0 + 18.0 * share(2));
    let step = length / f64::from(6 + k % 5);
    let mut points = String::new();
    let mut x = -70.0;
    while x < 70.0 {
        let turn = std::f64::consts::TAU * (x / length + share(3));
        let bend = height * (trig::sin(turn) + 0.15 * trig::sin(3.7 * turn));
        let (z, x_of) = if wall { (x, bend) } else { (bend, x) };
        write!(points, ",$\n{z:.4},{x_of:.5}").unwrap_or_default();
        x += step;
    }
    let (diameter, corner) = (16.0 + 9.0 * share(4), [0.0, 0.5, 2.0][(k % 3) as usize]);
    let (tolerance, slope) = (0.002 + 0.04 * share(5), 1.2 * share(6) - 0.6);
    let (way, from, check) = if wall {
        (format!("PLANE/0,{slope},1,0"), "40,-30,5", "PLANE/0,1,0,30")
    } else {
        (format!("PLANE/{slope},1,0,0"), "-30,0,5", "PLANE/1,0,0,30")
    };
    let forward = if wall { "0,1,0" } else { "1,0,0" };
    format!(
        "UNITS/MM\nWAVE=TABCYL/NOY,SPLINE{points}\nWAY={way}\nEND={check}\nTOLER/{tolerance}\n\
         CUTTER/{diameter},{corner}\nFROM/{from}\nINDIRV/{}\nGO/ON,WAY,TO,WAVE\nINDIRV/{forward}\n\
         TLON,GOFWD/WAY,ON,END\nFINI\n",
        if wall { "-1,0,0" } else { "0,0,-1" }
    )
}

#[test]
fn all_crests_below_a_wide_cutter_are_kept() {
    let (mut told, mut refused) = (Vec::new(), 0);
    for k in 0..60 {
        for wall in [false, true] {
            for (code, message) in run::run(&program(k, wall), Verify::Full).told {
                // The way may end at a crest that leaves no cut vector.
                if code == "APT2021" {
                    refused += 1;
                } else {
                    told.push(format!("{k} {wall}: {code} {message}"));
                }
            }
        }
    }
    assert!(refused <= 1, "{refused} of 120 are refused");
    assert!(told.is_empty(), "{told:#?}");
}
