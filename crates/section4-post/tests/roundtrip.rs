//! The proof by reading back finds what is wrong, and nothing where all is right.

#![expect(clippy::unwrap_used, reason = "test code")]

mod common;

use aptc_post::{machine, prove};
use common::{chords, good, records};

const HEAD: &str =
    "UNITS/MM\nLOADTL/1,LENGTH,80\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\nFROM/0,0,100\n";

fn faults(name: &str, cl: &str, nc: &str) -> Vec<String> {
    let (m, mut cl) = (machine(name).unwrap(), records(cl).into_iter());
    let (_, list) = prove(m, &mut cl, &mut nc.as_bytes()).unwrap();
    list.into_iter().map(|d| d.message).collect()
}

fn part() -> String {
    let arc = chords([10.0, 20.0, -1.0], 10.0, 0.0, 270.0, 60, 0.0);
    format!(
        "{HEAD}RAPID\nGOTO/20,20,5\nGOTO/20,20,-1\n{arc}GOTO/10,0,-1\nRAPID\nGOTO/10,0,50\n\
         CYCLE/DRILL,DEPTH,8,MMPM,100,CLEAR,3\nGOTO/40,0,0\nGOTO/50,0,2\nCYCLE/OFF\n\
         CLRSRF/0,0,1,60\nCLRSRF/NOW\nINSERT M8\nGOTO/0,0,70\nFINI"
    )
}

#[test]
fn a_good_program_is_proved_and_every_change_is_found() {
    let cl = part();
    let nc = good("linuxcnc-mill", &cl);
    assert_eq!(faults("linuxcnc-mill", &cl, &nc), Vec::<String>::new(), "{nc}");
    for (find, put) in [
        ("G3 X10 Y10", "G2 X10 Y10"),
        ("G3 X10 Y10", "G3 X10 Y10.2"),
        ("I-10 J0", "I-10.1 J0"),
        ("G1 Y0", "G0 Y0"),
        ("G1 Y0", "G1 Y0.001"),
        ("Z-1 F500", "Z-1.001 F500"),
        ("F500", "F"),
        ("Z-8", "Z-9"),
        ("Z-8", "Z-7"),
        ("R3", "R-1"),
        ("X50", "X51"),
        ("G21", "G20"),
        ("M30", "M30\nX5"),
        ("G0 X20", "G123 X20"),
        ("X0 Y0 Z70", "X0 Y0 Z.5"),
        ("G0 Z60", "G0 X3 Z60"),
    ] {
        let broken = nc.replace(find, put);
        assert_ne!(broken, nc, "{find}\n{nc}");
        assert!(!faults("linuxcnc-mill", &cl, &broken).is_empty(), "{find} to {put}\n{broken}");
    }
}

#[test]
fn a_lost_line_of_motion_is_found() {
    let cl = part();
    let nc = good("linuxcnc-mill", &cl);
    let lines: Vec<&str> = nc.lines().collect();
    for (i, line) in lines.iter().enumerate() {
        if !line.contains(['X', 'Y', 'Z']) || line.contains("G53") {
            continue;
        }
        let mut without = lines.clone();
        without.remove(i);
        assert!(!faults("linuxcnc-mill", &cl, &without.join("\n")).is_empty(), "{line}\n{nc}");
    }
}

#[test]
fn five_axes_are_proved_and_a_wrong_angle_is_found() {
    let cl = format!(
        "{HEAD}MULTAX\nRAPID\nGOTO/10,0,30,0,.2,1\nGOTO/20,5,10,.3,.1,1\nGOTO/30,5,12,.4,-.2,1\nFINI"
    );
    for name in [
        "linuxcnc-5axis",
        "linuxcnc-5axis-head",
        "linuxcnc-5axis-head-table",
        "linuxcnc-5axis-nutated",
    ] {
        let nc = good(name, &cl);
        assert_eq!(faults(name, &cl, &nc), Vec::<String>::new(), "{nc}");
        let line = nc.lines().rfind(|l| l.contains('C') && l.contains('F')).unwrap();
        let at = line.find('C').unwrap();
        let broken =
            nc.replacen(line, &format!("{}C1{}", &line[..at], &line[at + 1..].replace('-', "")), 1);
        assert!(!faults(name, &cl, &broken).is_empty(), "{name}\n{line}");
    }
}
