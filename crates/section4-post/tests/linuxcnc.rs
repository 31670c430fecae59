//! Programs for LinuxCNC, read by LinuxCNC.

mod common;

use common::{assert_reaches, chords, ends, good, rs274};

const HEAD: &str = "PARTNO BRACKET
UNITS/MM
PPRINT FOR TEST, ONLY
LOADTL/1
SPINDL/3000,CLW
COOLNT/FLOOD
";

fn accepted(nc: &str) -> Option<Vec<common::Canon>> {
    rs274(nc).map(|r| r.unwrap_or_else(|e| panic!("{e}\n{nc}")))
}

#[test]
fn a_contour_with_arcs_in_inches() {
    let arcs = chords([1.0, 1.0, -0.1], 0.5, -90.0, 180.0, 40, 0.0);
    let text = format!(
        "PARTNO X\nLOADTL/1\nSPINDL/3000\nCOOLNT/ON\nFROM/0,0,1\nRAPID\nGOTO/0,.5,.1\nFEDRAT/12.5,IPM\n\
         GOTO/0,.5,-.1\nGOTO/1,.5,-.1\n{arcs}GOTO/0,1.5,-.1\nRAPID\nGOTO/0,1.5,1\nFINI"
    );
    let nc = good("linuxcnc-mill", &text);
    assert!(nc.contains("\nG20\n"), "{nc}");
    assert!(nc.contains("\nG3 X1 Y1.5 I0 J0.5\n"), "{nc}");
    assert!(nc.contains("G1 Z-0.1 F12.5\n"), "{nc}");
    let Some(canon) = accepted(&nc) else { return };
    let points =
        [[0.0, 0.5, 0.1], [0.0, 0.5, -0.1], [1.0, 0.5, -0.1], [1.0, 1.5, -0.1], [0.0, 1.5, -0.1]];
    assert_reaches(&ends(&canon), &points, 1e-4);
    assert_eq!(canon.iter().filter(|c| c.name == "ARC_FEED").count(), 1);
}

#[test]
fn first_motion_goes_across_before_down_and_takes_the_length_offset() {
    let nc = good("linuxcnc-mill", &format!("{HEAD}FEDRAT/100\nGOTO/10,20,5\nGOTO/10,20,-1\nFINI"));
    let tail: Vec<&str> = nc.lines().skip_while(|l| *l != "M8").skip(1).take(3).collect();
    assert_eq!(tail, ["G0 X10 Y20", "G43 H1 G1 Z5 F100", "Z-1"], "{nc}");
    assert!(accepted(&nc).is_none_or(|c| !c.is_empty()));
}

#[test]
fn full_circle_and_helix() {
    let full = chords([0.0, 0.0, 0.0], 10.0, 0.0, 360.0, 90, 0.0);
    let helix = chords([0.0, 0.0, 0.0], 10.0, 0.0, -720.0, 200, -4.0);
    let text = format!("{HEAD}FEDRAT/200\nRAPID\nGOTO/10,0,2\nGOTO/10,0,0\n{full}{helix}FINI");
    let nc = good("linuxcnc-mill", &text);
    assert!(nc.contains("G3 X10 Y0 I-10 J0\n"), "{nc}");
    assert_eq!(nc.matches("G2 ").count(), 1, "{nc}");
    let Some(canon) = accepted(&nc) else { return };
    assert_eq!(canon.iter().filter(|c| c.name == "ARC_FEED").count(), 3);
    assert_reaches(&ends(&canon), &[[10.0, 0.0, 0.0], [10.0, 0.0, -2.0], [10.0, 0.0, -4.0]], 1e-4);
}

#[test]
fn arcs_in_all_three_planes_go_the_right_way_round() {
    for (axis, start, end, mid) in [
        // A quarter turn from the first axis of the plane to the second, seen from the tip of the normal.
        ("0,0,1", "10,0,0", "0,10,0", "G17"),
        ("0,1,0", "0,0,10", "10,0,0", "G18"),
        ("1,0,0", "0,10,0", "0,0,10", "G19"),
    ] {
        let text = format!(
            "{HEAD}FEDRAT/200\nGOTO/{start}\nARC/0,0,0,{axis},10,90\nGOTO/{end}\n\
             ARC/0,0,0,{axis},10,-90\nGOTO/{start}\nFINI"
        );
        let nc = good("linuxcnc-mill", &text);
        let three = nc.lines().position(|l| l.contains("G3")).expect("G3");
        let two = nc.lines().position(|l| l.contains("G2 ")).expect("G2");
        assert!(three < two, "{nc}");
        assert!(nc.contains(mid), "{nc}");
        let Some(canon) = accepted(&nc) else { return };
        let arcs: Vec<_> = canon.iter().filter(|c| c.name == "ARC_FEED").collect();
        // The interpreter's turns: 1 anticlockwise, -1 clockwise.
        assert!(arcs[0].numbers[4] > 0.0 && arcs[1].numbers[4] < 0.0, "{arcs:?}");
    }
}

#[test]
fn drilling_cycles() {
    let text = format!(
        "{HEAD}FROM/0,0,50\nCYCLE/DRILL,DEPTH,12,MMPM,120,CLEAR,2\nGOTO/10,0,0\nGOTO/20,0,0\nGOTO/30,0,5\n\
         CYCLE/DEEP,DEPTH,20,STEP,5,MMPM,100,CLEAR,2,RTRCTO,25\nGOTO/40,0,0\nCYCLE/OFF\n\
         RAPID\nGOTO/0,0,50\nFINI"
    );
    let nc = good("linuxcnc-mill", &text);
    assert!(nc.contains("G99 G81 X10 Y0 Z-12 R2 F120\nX20\n"), "{nc}");
    assert!(nc.contains("G98 G83 X40 Y0 Z-20 R2 Q5 F100\n"), "{nc}");
    let Some(canon) = accepted(&nc) else { return };
    let points = [
        [10.0, 0.0, 2.0],
        [10.0, 0.0, -12.0],
        [10.0, 0.0, 2.0],
        [20.0, 0.0, 2.0],
        [20.0, 0.0, -12.0],
        [30.0, 0.0, -7.0],
        [30.0, 0.0, 7.0],
        [40.0, 0.0, -20.0],
        [40.0, 0.0, 25.0],
        [0.0, 0.0, 50.0],
    ];
    assert_reaches(&ends(&canon), &points, 1e-4);
    // Never across below the clearance of either hole.
    let list = ends(&canon);
    for w in list.windows(2) {
        let ([x0, y0, z0], [x1, y1, z1]) = (w[0].1, w[1].1);
        let across = (x0 - x1).abs() + (y0 - y1).abs() > 1e-6;
        assert!(
            !across || z0.min(z1) >= 2.0 - 1e-9 || x0.abs() + y0.abs() + z0.abs() < 1e-9,
            "{w:?}\n{nc}"
        );
    }
}

#[test]
fn positional_cycles_of_apt360() {
    let head = "PARTNO X\nLOADTL/2\nSPINDL/3000\nCOOLNT/ON\nFEDRAT/9\nFROM/0,0,1\n";
    for (cycle, block) in [
        ("CYCLE/DRILL,-2,IPM,23,.05", "G99 G81 X1 Y0 Z-2 R0.05 F23\n"),
        ("CYCLE/DRILL,.4,20.,IPM,.1", "G99 G81 X1 Y0 Z-0.4 R0.1 F20\n"),
        ("CYCLE/DRILL,DRILL,32,5,3", "G99 G81 X1 Y0 Z-32 R3 F5\n"),
        ("CYCLE/DEEP,2,.5,.1", "G99 G83 X1 Y0 Z-2 R0.1 Q0.5 F9\n"),
    ] {
        let nc = good("linuxcnc-mill", &format!("{head}{cycle}\nGOTO/1,0,0\nCYCLE/OFF\nFINI"));
        assert!(nc.contains(block), "{cycle}\n{nc}");
        assert!(accepted(&nc).is_none_or(|c| !c.is_empty()));
    }
}

#[test]
fn radius_compensation_is_wear_only() {
    let text = format!(
        "{HEAD}FEDRAT/100\nFROM/0,0,5\nGOTO/0,0,-1\nCUTCOM/LEFT,3\nGOTO/10,0,-1\nGOTO/10,10,-1\n\
         CUTCOM/OFF\nGOTO/0,20,-1\nFINI"
    );
    let nc = good("linuxcnc-mill", &text);
    let Some(canon) = accepted(&nc) else { return };
    // With the wear of the program, zero, the control moves exactly as the CL data says.
    let points = [[10.0, 0.0, -1.0], [10.0, 10.0, -1.0], [0.0, 20.0, -1.0]];
    assert_reaches(&ends(&canon), &points, 1e-4);
}

#[test]
fn words_that_write_blocks() {
    let text = format!(
        "{HEAD}SEQNO/100,INCR,5\nFEDRAT/100\nOPSKIP/ON\nCOOLNT/MIST\nOPSKIP/OFF\nGOTO/0,0,5\nDELAY/2.5\n\
         STOP\nOPSTOP\nAUXFUN/8\nINSERT G4 P1\nINSERT(A (NESTED) COMMENT)\nSELCTL/2\nLOADTL/2\nGOTO/1,0,5\nREWIND\nEND\nFINI"
    );
    let nc = good("linuxcnc-mill", &text);
    for block in ["G4 P2.5", " M0\n", " M1\n", " M8\n", "(A NESTED COMMENT)", "/N", "N100 "] {
        assert!(nc.contains(block), "{block}\n{nc}");
    }
    assert!(accepted(&nc).is_none_or(|c| !c.is_empty()));
}

#[test]
fn a_broken_program_is_rejected() {
    let nc = good("linuxcnc-mill", &format!("{HEAD}FEDRAT/100\nGOTO/10,20,5\nFINI"));
    for (find, put) in [("F100", "F"), ("M30", ""), ("G0 X10", "G0 G1 X10"), ("X10", "X1O")] {
        let broken = nc.replacen(find, put, 1);
        assert_ne!(broken, nc);
        let Some(result) = rs274(&broken) else { return };
        assert!(result.is_err(), "{find} to {put} was accepted");
    }
}
