//! Lathes: diameters, constant surface speed, threads, and what they refuse.

mod common;

use common::{errors, good, records, rs274};

const HEAD: &str =
    "UNITS/MM\nTURRET/3\nSPINDL/180,SMM,CLW,MAXRPM,2500\nCOOLNT/ON\nFEDRAT/0.2,MMPR\n";

/// The axis words of all blocks of motion, in order.
fn moves(nc: &str) -> Vec<&str> {
    let moves = |l: &&str| l.contains(['X', 'Z']) && !l.contains("G53") && !l.contains("G28");
    nc.lines().filter(moves).collect()
}

#[test]
fn a_contour_is_written_in_diameters_with_arcs_in_zx() {
    let text = format!(
        "{HEAD}FROM/30,0,50\nRAPID\nGOTO/10,0,2\nGOTO/10,0,-20\nCHORDS/15,0,-20,0,1,0,5\nGOTO/11.4645,0,-23.5355;15,0,-25\nGOTO/30,0,-25\nFINI"
    );
    let nc = good("linuxcnc-lathe", &text);
    for part in ["G7\n", "G96 D2500 S180 M3", "G95", "X20", "G1 Z-20 F0.2", "X60"] {
        assert!(nc.contains(part), "{part} is missing:\n{nc}");
    }
    // From (10, -20) around (15, -20) to (15, -25): in the ZX plane from X back to Z is clockwise.
    let arc = nc.lines().find(|l| l.contains('I') && l.contains('K')).unwrap();
    assert_eq!(arc, "G2 X30 Z-25 K0 I5", "\n{nc}");
    assert!(!nc.contains('Y'), "{nc}");
    // LinuxCNC takes diameters for what they are.
    if let Some(ran) = rs274(&nc) {
        let canon = ran.unwrap_or_else(|e| panic!("{e}\n{nc}"));
        let ends = common::ends(&canon);
        let near = |x: f64, z: f64| {
            ends.iter().any(|(_, p)| (p[0] - x).abs() < 1e-4 && (p[2] - z).abs() < 1e-4)
        };
        // Ends of an arc in its plane, the first axis Z.
        let arc = canon.iter().find(|c| c.name == "ARC_FEED").expect("an arc");
        assert!((arc.numbers[0] + 25.0).abs() < 1e-4 && (arc.numbers[1] - 15.0).abs() < 1e-4);
        assert!(near(10.0, -20.0) && near(30.0, -25.0), "{ends:?}");
    }
}

#[test]
fn the_two_ways_to_draw_a_turned_part_give_the_same_text() {
    let zx = format!("{HEAD}FROM/30,0,50\nRAPID\nGOTO/10,0,2\nGOTO/10,0,-20\nGOTO/12,0,-22\nFINI");
    let xy = format!("{HEAD}FROM/50,30,0\nRAPID\nGOTO/2,10,0\nGOTO/-20,10,0\nGOTO/-22,12,0\nFINI");
    assert_eq!(good("linuxcnc-lathe", &zx), good("linuxcnc-lathe-xy", &xy));
}

#[test]
fn a_thread_goes_with_the_spindle_and_back_at_rapid() {
    let pass = |x: f64| {
        format!("RAPID\nGOTO/{x},0,3\nGOTO/{x},0,-15\nRAPID\nGOTO/12,0,-15\nRAPID\nGOTO/12,0,3\n")
    };
    let text = format!(
        "UNITS/MM\nTURRET/5\nSPINDL/500,RPM,CLW\nCOOLNT/ON\nFEDRAT/100\nFROM/30,0,50\nTHREAD/1.5\n{}{}THREAD/OFF\nFINI",
        pass(9.6),
        pass(9.3)
    );
    let nc = good("linuxcnc-lathe", &text);
    let cuts: Vec<_> = nc.lines().filter(|l| l.starts_with("G33")).collect();
    assert_eq!(cuts, ["G33 Z-15 K1.5", "G33 Z-15 K1.5"], "{nc}");
    assert!(nc.contains("G97 S500 M3"));
    let fanuc = good("fanuc-0i-lathe", &text);
    assert!(fanuc.contains("G32 Z-15. F1.5") && fanuc.contains("T0505"), "{fanuc}");
}

#[test]
fn what_a_lathe_cannot_do_is_refused_by_name() {
    let ready = "UNITS/MM\nTURRET/3\nSPINDL/500,RPM,CLW\nCOOLNT/ON\nFEDRAT/0.2,MMPR\nFROM/30,0,50\nGOTO/20,0,2\n";
    for (statements, code) in [
        ("GOTO/10,3,2", "APT4026"),
        // A drill across the spindle, and one that stands square to the plane of turning.
        ("GOTO/10,0,2,1,0,0", "APT4004"),
        ("CYCLE/DRILL,DEPTH,5,MMPR,.1,CLEAR,2\nGOTO/0,0,0,0,1,0", "APT4004"),
        ("THREAD/2\nGOTO/22,0,2", "APT4027"),
        ("SPINDL/100,SMM\nTHREAD/2\nGOTO/20,0,-9", "APT4027"),
        ("THREAD/2,1\nGOTO/20,0,-9", "APT4006"),
        ("THREAD/0", "APT4007"),
    ] {
        let text = format!("{ready}{statements}\nFINI");
        assert_eq!(errors("linuxcnc-lathe", &text), [code], "{statements}");
    }
    assert_eq!(errors("linuxcnc-mill", "LOADTL/1\nTHREAD/2\nFINI"), ["APT4006"]);
}

#[test]
fn the_time_at_constant_surface_speed_follows_the_radius() {
    let text = format!("{HEAD}FROM/30,0,2\nGOTO/30,0,2\nGOTO/30,0,-98\nFINI");
    let machine = aptc_post::machine("linuxcnc-lathe").unwrap();
    let posted = aptc_post::post_all(machine, Default::default(), &records(&text)).1;
    let rpm = 180_000.0 / (std::f64::consts::TAU * 30.0);
    assert!((posted.summary.cut_minutes - 100.0 / (0.2 * rpm)).abs() < 1e-9);
    assert_eq!(moves("X1\nG53 G0 X0\nM9").len(), 1);
}

#[test]
fn words_that_turn_a_table_are_refused_and_never_dropped() {
    let ready = "UNITS/MM\nLOADTL/1\nSPINDL/500,CLW\nCOOLNT/ON\nFEDRAT/100\nGOTO/0,0,5\n";
    for (machine, statement, codes) in [
        ("linuxcnc-mill", "ROTABL/ATANGL,90", vec!["APT4006"]),
        ("linuxcnc-4axis", "ROTABL/ATANGL,90", vec![]),
        ("linuxcnc-mill", "ROTABL/0,CLW", vec![]),
        ("linuxcnc-mill", "MODE/TURN", vec!["APT4006"]),
        ("linuxcnc-mill", "MODE/MILL", vec![]),
        ("linuxcnc-mill", "ARCSLP/5", vec!["APT4006"]),
    ] {
        let text = format!("{ready}{statement}\nGOTO/5,0,5\nFINI");
        assert_eq!(errors(machine, &text), codes, "{statement} on {machine}");
    }
}

#[test]
fn what_moves_the_part_turns_with_the_plane() {
    let cut = |words: &str, points: [&str; 2]| {
        let [a, b] = points;
        format!("{HEAD}FROM/60,0,50\n{words}\nRAPID\nGOTO/{a}\nGOTO/{b}\nFINI")
    };
    let zx = good("linuxcnc-lathe", &cut("TRANS/1,0,7", ["10,0,2", "10,0,-20"]));
    let xy = cut("TRANS/7,1,0", ["2,10,0", "-20,10,0"]).replace("60,0,50", "50,60,0");
    assert_eq!(zx, good("linuxcnc-lathe-xy", &xy));
    assert!(zx.contains("X22") && zx.contains("G1 Z-13"), "{zx}");
}

#[test]
fn stock_on_a_lathe_is_told_to_be_unchecked() {
    let text = format!("{HEAD}STOCK/0,-30,-60,30,30,0\nFROM/60,0,50\nRAPID\nGOTO/10,0,-5\nFINI");
    let (_, posted) = common::post("linuxcnc-lathe", &text);
    let told: Vec<_> = posted.diagnostics.iter().map(|d| d.code.to_string()).collect();
    assert!(told.iter().any(|c| c == "APT4025") && posted.summary.stock.is_none(), "{told:?}");
}

#[test]
fn a_dog_leg_leaves_the_part_across_and_comes_to_it_along() {
    // From the shoulder out, and from outside to a groove: never along the spindle at the radius of the part.
    let text = format!(
        "{HEAD}FROM/50,0,100\nRAPID\nGOTO/17,0,5\nRAPID\nGOTO/16,0,-10\nGOTO/12,0,-10\nRAPID\nGOTO/17,0,5\nFINI"
    );
    let nc = good("fanuc-0i-lathe", &text);
    let tail: Vec<&str> =
        nc.lines().skip_while(|l| !l.starts_with("Z5.")).skip(1).take(5).collect();
    assert_eq!(tail[0..2], ["Z-10.", "X32."], "{nc}");
    assert_eq!(tail[3..5], ["G0 X34.", "Z5."], "{nc}");
}

#[test]
fn a_thread_by_its_cycle_is_cut_in_passes_outside_and_in_a_nut() {
    let ready = "UNITS/MM\nTURRET/5\nSPINDL/500,RPM,CLW\nCOOLNT/ON\nFEDRAT/.2,MMPR\nFROM/30,0,50\n";
    let cycle = "CYCLE/THREAD,DEPTH,.9,STEP,.3,MMPR,1.5,CLEAR,1\n";
    for (start, end, first, last, clear) in [
        ("14,0,4", "12,0,-20", "X23.4", "X22.2", "X26"),
        ("9,0,4", "10,0,-20", "X20.6", "X21.8", "X18"),
    ] {
        let text = format!(
            "{ready}RAPID\nGOTO/{start}\n{cycle}GOTO/{end}\nCYCLE/OFF\nRAPID\nGOTO/30,0,50\nFINI"
        );
        let nc = good("linuxcnc-lathe", &text);
        assert_eq!(nc.matches("G33 Z-20 K1.5").count(), 9, "{nc}");
        for word in [first, last, clear] {
            assert!(nc.lines().any(|l| l.ends_with(word)), "{word}\n{nc}");
        }
        assert!(rs274(&nc).is_none_or(|r| r.is_ok()), "{nc}");
        let fanuc = good("fanuc-0i-lathe", &text);
        assert_eq!(fanuc.matches("G32 Z-20. F1.5").count(), 9, "{fanuc}");
    }
    let bad = |cycle: &str, end: &str| {
        errors("linuxcnc-lathe", &format!("{ready}RAPID\nGOTO/12,0,4\n{cycle}\nGOTO/{end}\nFINI"))
    };
    assert_eq!(bad("CYCLE/THREAD,DEPTH,.9,MMPR,1.5,CLEAR,1", "10,0,-9"), ["APT4005"]);
    assert_eq!(bad(cycle.trim(), "12,0,-9"), ["APT4027"]);
    // A mill has no such cycle.
    let mill =
        format!("UNITS/MM\nLOADTL/1\nSPINDL/500\nFEDRAT/9\nGOTO/0,0,9\n{cycle}GOTO/0,0,0\nFINI");
    assert_eq!(errors("linuxcnc-mill", &mill), ["APT4006"]);
}

/// The path is that of the nose centre, so that the control compensates the wear alone: right of a cut towards the chuck
/// is away from the spindle.
#[test]
fn compensation_on_a_lathe_is_of_wear_only() {
    let cut = "RAPID\nGOTO/15,0,5\nCUTCOM/RIGHT\nGOTO/10,0,2\nGOTO/10,0,-20\nGOTO/14,0,-20\nCUTCOM/OFF\nGOTO/20,0,-20\nFINI";
    let text = format!("{HEAD}FROM/30,0,50\n{cut}");
    let nc = good("linuxcnc-lathe", &text);
    assert!(nc.contains("G42.1 D#<_wear_3>") && nc.contains("NOSE CENTRE"), "{nc}");
    let drawn = format!(
        "{HEAD}FROM/50,30,0\nRAPID\nGOTO/5,15,0\nCUTCOM/RIGHT\nGOTO/2,10,0\nGOTO/-20,10,0\nGOTO/-20,14,0\n\
         CUTCOM/OFF\nGOTO/-20,20,0\nFINI"
    );
    assert_eq!(good("linuxcnc-lathe-xy", &drawn), nc);
    let radii = |nc: &str| {
        let canon = rs274(nc)?.unwrap_or_else(|e| panic!("{e}\n{nc}"));
        let ends = common::ends(&canon);
        let cuts = ends.iter().filter(|(k, p)| k == "STRAIGHT_FEED" && p[2] < -15.0);
        Some(cuts.map(|(_, p)| p[0]).fold(f64::INFINITY, f64::min))
    };
    if let Some(new) = radii(&nc) {
        assert!((new - 10.0).abs() < 1e-4, "{new}");
        let worn = radii(&nc.replace("#<_wear_3>=0", "#<_wear_3>=0.2")).unwrap();
        assert!((worn - 10.1).abs() < 1e-4, "{worn}");
    }
    let fanuc = good("fanuc-0i-lathe", &text);
    assert!(fanuc.contains("G42 G1 X20.") || fanuc.contains("G1 G42 X20."), "{fanuc}");
    assert!(fanuc.contains("G40") && !fanuc.contains("D3"), "{fanuc}");
    assert_eq!(
        errors("fanuc-0i-lathe", &text.replace("CUTCOM/RIGHT", "CUTCOM/RIGHT,7")),
        ["APT4006"]
    );
}

/// A slip of the pen in a speed is told for every machine.
#[test]
fn every_machine_has_a_greatest_spindle_speed() {
    for machine in aptc_post::machines().filter(|m| m.name != "apt") {
        assert!(machine.spindle.max > 0.0, "{}", machine.name);
    }
}
