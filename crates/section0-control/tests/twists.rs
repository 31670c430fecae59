//! Blades whose rulings twist, milled by the flank with the axis along them: the flank touches with one end of it at the vertices
//! and with the other between them, and every cut vector is proved.

#[path = "support/run.rs"]
mod run;

use std::fmt::Write as _;

use aptc_control::Verify;
use aptc_geometry::trig;

/// A blade between two bows, the upper one turned by up to 30 degrees, with its program; with a ball end it is longer.
fn program(k: u32, ball: bool) -> String {
    let share = |i: u32| (f64::from(k + 1) * 0.618_033_988_75 * f64::from(i)).fract();
    let (length, height) = (30.0 + 30.0 * share(1), 10.0 + 15.0 * share(2));
    let (length, height) = if ball { (1.6 * length, 1.8 * height) } else { (length, height) };
    let turn = (5.0 + 25.0 * share(3)).to_radians() * if k % 2 == 1 { 1.0 } else { -1.0 };
    let mut rails = String::new();
    for (name, bow, z, turn) in
        [("H", 8.0 * share(4) - 4.0, 0.0, 0.0), ("S", 8.0 * share(5) - 4.0, height, turn)]
    {
        let (sin, cos) = trig::sin_cos(turn);
        for (i, x, y) in [(0, -0.5 * length, 0.0), (1, 0.0, bow), (2, 0.5 * length, 0.0)] {
            let (x, y) = (x * cos - y * sin, x * sin + y * cos);
            writeln!(rails, "{name}{i}=POINT/{x:.4},{y:.4},0").unwrap_or_default();
            writeln!(rails, "{name}E{i}=POINT/{x:.4},{y:.4},{z:.4}").unwrap_or_default();
        }
        writeln!(rails, "{name}C=CIRCLE/{name}0,{name}1,{name}2").unwrap_or_default();
        writeln!(rails, "{name}V=VECTOR/{:.4},{:.4},0", -bow * sin, bow * cos).unwrap_or_default();
    }
    let (diameter, corner) = (4.0 + 6.0 * share(6), if k % 2 == 1 { 0.5 } else { 0.0 });
    let corner = if ball { 0.5 * diameter } else { corner };
    let (side, word) = if !k.is_multiple_of(3) { (1.0, "TLRGT") } else { (-1.0, "TLLFT") };
    format!(
        "UNITS/MM\n{rails}BLADE=RLDSRF/HC,HE0,HE2,HV,SC,SE0,SE2,SV\nFLOOR=PLANE/0,0,1,-2\n\
         END=PLANE/1,0,0,{:.4}\nTOLER/{:.4}\n\
         CUTTER/{diameter:.4},{corner:.5},{:.5},{corner:.5},0,0,{:.4}\nMULTAX\nTLAXIS/PARLEL,2\n\
         FROM/{:.4},{},5\nINDIRV/0,{side},0\nGO/TO,BLADE,TO,FLOOR\nINDIRV/1,0,0\n\
         {word},GOFWD/BLADE,ON,END\nFINI\n",
        0.5 * length - diameter,
        0.01 + 0.05 * share(7),
        0.5 * diameter - corner,
        1.6 * height,
        diameter - 0.5 * length,
        -30.0 * side,
    )
}

/// What is told of programs.
fn told(ball: bool, programs: u32) -> Vec<String> {
    let told = (0..programs).flat_map(|k| {
        let told = run::run(&program(k, ball), Verify::Full).told.into_iter();
        told.map(move |(code, message)| format!("{k}: {code} {message}"))
    });
    told.collect()
}

#[test]
fn a_flank_along_twisted_rulings_is_proved() {
    let told = told(false, 24);
    assert!(told.is_empty(), "{told:#?}");
}

#[test]
fn the_shank_of_a_ball_along_twisted_rulings_is_proved() {
    let told = told(true, 24);
    assert!(told.is_empty(), "{told:#?}");
}
