//! Milling on a lathe: the spindle turns the part under tools that stand along it or across it.

mod common;

use aptc_geometry::trig;
use aptc_post::{machine, prove};
use common::{errors, good, post, records, rs274};

const HEAD: &str =
    "UNITS/MM\nTURRET/3\nMODE/MILL\nCUTTER/8\nSPINDL/2000,CLW\nCOOLNT/ON\nFEDRAT/160,MMPM\n";
const MACHINES: [&str; 2] = ["linuxcnc-lathe-c", "fanuc-0i-lathe-c"];

/// A square on the face, a line through the middle, holes, and work of a tool across the spindle.
fn program() -> String {
    format!(
        "{HEAD}RAPID\nGOTO/30,-15,2\nRAPID\nGOTO/30,-15,-5\nGOTO/-15,-15,-5\nGOTO/-15,15,-5\nGOTO/15,15,-5\n\
         GOTO/15,-15,-5\nRAPID\nGOTO/15,-15,5\nRAPID\nGOTO/0,16,5\nGOTO/0,16,-1\nGOTO/0,-16,-1\nRAPID\nGOTO/0,-16,5\n\
         CYCLE/DRILL,DEPTH,8,MMPM,90,CLEAR,2\nGOTO/7,0,-1\nGOTO/0,7,-1\nGOTO/-7,0,-1\nGOTO/0,-7,-1\nCYCLE/OFF\n\
         TURRET/7\nRAPID\nGOTO/0,30,-25,0,1,0\nGOTO/0,17,-25,0,1,0\nGOTO/0,17,-35,0,1,0\nRAPID\n\
         GOTO/0,30,-35,0,1,0\nCYCLE/DRILL,DEPTH,15,MMPM,110,CLEAR,2\n\
         GOTO/-17.32050808,-10,-20,-.8660254038,-.5,0\nCYCLE/OFF\nFINI"
    )
}

/// The place of the tool in the frame of the part, from the control's own X (a radius), Z and C.
fn in_part(x: f64, z: f64, c: f64) -> [f64; 3] {
    let (s, c) = trig::sin_cos(-c.to_radians());
    [x * c, x * s, z]
}

#[test]
fn faces_and_sides_are_milled_and_proved() {
    for machine in MACHINES {
        let (nc, posted) = post(machine, &program());
        let bad: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert!(bad.is_empty(), "{machine} {bad:#?}\n{nc}");
        let proof = posted.proof.unwrap();
        assert!(proof.points >= 20 && proof.path_mm <= 0.011, "{machine} {proof:?}");
        assert!(!nc.contains('Y') && nc.contains('C'), "{nc}");
    }
}

/// LinuxCNC's own idea of the axes, turned into the frame of the part, keeps to the lines of the square.
#[test]
fn linuxcnc_goes_along_the_square() {
    let nc = good("linuxcnc-lathe-c", &program());
    let Some(ran) = rs274(&nc) else { return };
    let canon = ran.unwrap_or_else(|e| panic!("{e}\n{nc}"));
    let feeds = canon.iter().filter(|c| c.name == "STRAIGHT_FEED");
    let at: Vec<[f64; 3]> =
        feeds.map(|c| in_part(c.numbers[0], c.numbers[2], c.numbers[5])).collect();
    let square = at.iter().filter(|p| (p[2] + 5.0).abs() < 1e-6);
    let mut n = 0;
    for p in square {
        n += 1;
        let (x, y) = (p[0], p[1]);
        let off = ((x.abs() - 15.0).abs()).min((y.abs() - 15.0).abs());
        assert!(off < 0.011 && y.abs() < 15.011 && x > -15.011, "{p:?}");
    }
    assert!(n > 50, "{n}");
    let reached = |q: [f64; 3]| at.iter().any(|p| (0..3).all(|i| (p[i] - q[i]).abs() < 1e-3));
    for q in [[-15.0, -15.0, -5.0], [-15.0, 15.0, -5.0], [15.0, 15.0, -5.0], [0.0, -16.0, -1.0]] {
        assert!(reached(q), "{q:?}");
    }
}

#[test]
fn a_wrong_angle_is_found() {
    for name in MACHINES {
        let nc = good(name, &program());
        let machine = machine(name).unwrap();
        let judge = |nc: &str| {
            let records = &mut records(&program()).into_iter();
            prove(machine, records, &mut nc.as_bytes()).unwrap().1.len()
        };
        assert_eq!(judge(&nc), 0, "{name}");
        let line = nc.lines().filter(|l| l.contains(" C")).nth(20).unwrap();
        let angle = line.split(" C").nth(1).unwrap().split(' ').next().unwrap();
        let other: f64 = angle.parse::<f64>().unwrap() + 1.0;
        let wrong =
            nc.replace(line, &line.replace(&format!(" C{angle}"), &format!(" C{other:.3}")));
        assert!(judge(&wrong) > 0, "{name}: {line}");
    }
}

#[test]
fn feeds_are_those_of_the_tool_in_the_part() {
    // A quarter turn on a circle of radius 20 by chords: 31.4 mm at 160 mm a minute.
    let mut text = format!("{HEAD}RAPID\nGOTO/20,0,2\nGOTO/20,0,-1\n");
    for i in 1..=90 {
        let (s, c) = trig::sin_cos(f64::from(i).to_radians());
        text.push_str(&format!("GOTO/{:.6},{:.6},-1\n", 20.0 * c, 20.0 * s));
    }
    text.push_str("FINI");
    let words = |line: &str, letter: char| -> Option<f64> {
        line.split(' ').find_map(|w| w.strip_prefix(letter)?.parse().ok())
    };
    // Inverse time: the sum of the times of all blocks.
    let nc = good("linuxcnc-lathe-c", &text);
    let minutes: f64 = nc
        .lines()
        .skip_while(|l| !l.contains("G93"))
        .filter(|l| l.contains('C'))
        .filter_map(|l| words(l, 'F'))
        .map(|f| 1.0 / f)
        .sum();
    let wanted = std::f64::consts::PI * 10.0 / 160.0;
    assert!((minutes / wanted - 1.0).abs() < 0.01, "{minutes} {wanted}");
    // Degrees as millimetres: 160 mm a minute at radius 20 are 458.4 degrees a minute.
    let nc = good("fanuc-0i-lathe-c", &text);
    let last = nc.lines().rfind(|l| l.contains('C') && words(l, 'F').is_some());
    let feed = last.and_then(|l| words(l, 'F')).unwrap();
    assert!((feed / 458.37 - 1.0).abs() < 0.01, "{feed}");
}

#[test]
fn what_the_lathe_cannot_do_is_refused() {
    for (text, code, what) in [
        // Beside the axis of the spindle with a tool across it: that takes a Y axis.
        (format!("{HEAD}RAPID\nGOTO/5,30,-20,0,1,0\nFINI"), "APT4026", "no Y axis"),
        // A tool that leans.
        (
            format!("{HEAD}RAPID\nGOTO/0,30,-20,0,.6,.8\nFINI"),
            "APT4004",
            "along the spindle or across it",
        ),
        // One tool stands one way.
        (
            format!("{HEAD}RAPID\nGOTO/9,0,2\nRAPID\nGOTO/0,30,-20,0,1,0\nFINI"),
            "APT4004",
            "stands along the spindle",
        ),
        (format!("{HEAD}CUTCOM/LEFT,1\nGOTO/9,0,2\nFINI"), "", "CUTCOM/LEFT,1"),
        (format!("{HEAD}THREAD/2\nGOTO/9,0,2\nFINI"), "", "THREAD/2"),
    ] {
        let (nc, posted) = post("linuxcnc-lathe-c", &text);
        let said = posted.diagnostics.iter().filter(|d| d.is_error());
        let found = said
            .clone()
            .any(|d| d.message.contains(what) && (code.is_empty() || d.code.to_string() == code));
        assert!(found, "{what}: {:#?}\n{nc}", said.collect::<Vec<_>>());
    }
    assert!(!errors("linuxcnc-lathe", "UNITS/MM\nMODE/MILL\nFINI").is_empty());
}

#[test]
fn turning_goes_on_after_milling_from_the_retracted_place() {
    let text = format!(
        "{HEAD}RAPID\nGOTO/9,0,2\nGOTO/9,0,-1\nMODE/TURN\nTURRET/1\nSPINDL/1200,CLW\nFEDRAT/.1,MMPR\nRAPID\n\
         GOTO/21,0,-38\nGOTO/19,0,-40\nFINI"
    );
    let nc = good("linuxcnc-lathe-c", &text);
    let after = nc.split("M65 P0").nth(1).unwrap();
    assert!(after.contains("G97 S1200 M3") && after.contains("G95 G1 X38 Z-40 F0.1"), "{nc}");
    assert!(!after.contains('C') || after.contains("("), "{after}");
    let before = nc.split("M65 P0").next().unwrap();
    assert!(before.trim_end().ends_with("G53 G0 X0\nG53 G0 Z0\nM5"), "{nc}");
}

#[test]
fn a_live_tool_does_not_come_down_to_its_cut_at_rapid() {
    let face = "RAPID\nGOTO/30,0,2\nGOTO/30,0,-5\nRETRCT\nGOTO/10,0,-5\n";
    let side = "RAPID\nGOTO/0,30,-25,0,1,0\nGOTO/0,17,-25,0,1,0\nRETRCT\nGOTO/0,17,-35,0,1,0\n";
    for name in MACHINES {
        for (way, letter, above, at) in [(face, 'Z', -3.0, -5.0), (side, 'X', 38.0, 34.0)] {
            let nc = good(name, &format!("{HEAD}{way}FINI"));
            let value = |l: &str| -> Option<f64> {
                l.split(' ').find_map(|w| w.strip_prefix(letter)?.parse().ok())
            };
            let lines: Vec<&str> = nc.lines().filter(|l| value(l).is_some()).collect();
            let last = lines.iter().rposition(|l| value(l) == Some(at)).expect("it goes on");
            assert!(
                lines[last].contains("G1") && value(lines[last - 1]) == Some(above),
                "{name}\n{nc}"
            );
            assert!(!lines[last - 1].contains("G1"), "{name}\n{nc}");
        }
    }
}

/// The spindle that an optional stop may have left running must stand before it places the part.
#[test]
fn the_spindle_is_stopped_for_milling_after_an_optional_stop() {
    for name in MACHINES {
        let m = machine(name).unwrap();
        let stop = m.program.optional_stop.as_str();
        let nc = good(
            name,
            "UNITS/MM\nTURRET/3\nSPINDL/500,CLW\nCOOLNT/ON\nFEDRAT/.2,MMPR\nRAPID\nGOTO/20,0,5\nGOTO/20,0,-5\n\
             OPSTOP\nMODE/MILL\nCUTTER/8\nSPINDL/2000,CLW\nCOOLNT/ON\nFEDRAT/160,MMPM\nRAPID\nGOTO/30,0,2\n\
             GOTO/30,0,-5\nFINI",
        );
        let (_, after) = nc.split_once(&format!("{stop}\n")).expect("it stops");
        let off = after.lines().position(|l| l.ends_with(&m.spindle.off));
        let on = after.lines().position(|l| l.contains("S2000"));
        assert!(off.zip(on).is_some_and(|(off, on)| off < on), "{name}\n{nc}");
    }
}

/// Above the clearance plane C turns in one block; elsewhere a rapid motion keeps near to its line, in few blocks.
#[test]
fn a_rapid_motion_over_the_face_is_no_swarm_of_blocks() {
    let across = |plane: &str| {
        format!(
            "{HEAD}{plane}RAPID\nGOTO/16,9,5\nGOTO/16,9,-3\nRAPID\nGOTO/16,9,5\nRAPID\nGOTO/-16,9,5\n\
             GOTO/-16,9,-3\nRAPID\nGOTO/-16,9,5\nFINI"
        )
    };
    for machine in MACHINES {
        let turns = |plane: &str| {
            let (nc, posted) = post(machine, &across(plane));
            let bad: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
            assert!(bad.is_empty(), "{machine} {bad:#?}\n{nc}");
            // Behind the first place.
            nc.lines().filter(|l| l.contains('C') && !l.contains('(')).count() - 1
        };
        assert_eq!(turns("CLRSRF/0,0,1,4\n"), 1, "{machine}");
        let below = turns("");
        assert!((4..=12).contains(&below), "{machine} {below}");
        assert_eq!(turns("CLRSRF/0,0,1,6\n"), below, "{machine}: both ends lie below the plane");
    }
}
