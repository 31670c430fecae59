//! ROTABL and ROTHED: work beside a turned table or head, in the plane of the control where it has one.

mod common;

use common::{errors, good, post, rs274};

const HEAD: &str = "UNITS/MM\nCUTTER/8\nLOADTL/1,LENGTH,80\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\nFROM/0,0,100\n";

/// A slot, a bow and two holes on the side that the table brings up.
fn side() -> String {
    let bow = common::chords([0.0, 0.0, 19.0], 20.0, 0.0, 90.0, 40, 0.0);
    format!(
        "RAPID\nGOTO/20,0,30\nGOTO/20,0,19\n{bow}RAPID\nGOTO/0,20,30\nCLRSRF/0,0,1,40\n\
         CYCLE/DRILL,DEPTH,5,MMPM,100,CLEAR,2\nGOTO/10,5,20\nGOTO/-10,5,20\nCYCLE/OFF\nCLRSRF/NOW\n"
    )
}

fn program(turns: &[&str]) -> String {
    let works: Vec<String> = turns.iter().map(|t| format!("{t}\n{}", side())).collect();
    format!("{HEAD}{}FINI", works.concat())
}

#[test]
fn a_four_axis_table_is_turned_and_the_work_is_written_as_programmed() {
    let nc = good(
        "linuxcnc-4axis",
        &program(&["ROTABL/ATANGL,90", "ROTABL/INCR,90", "ROTABL/ATANGL,0"]),
    );
    for block in ["G0 A90", "G0 A180", "G0 A0", "G3 X0 Y20 I-20 J0", "G99 G81 X10 Y5 Z15 R22 F100"]
    {
        assert!(nc.lines().any(|l| l == block), "{block}\n{nc}");
    }
    // Retracted before each turn, and across before down after it.
    let lines: Vec<&str> = nc.lines().collect();
    for (i, _) in lines.iter().enumerate().filter(|(_, l)| l.starts_with("G0 A")) {
        assert!(["G53 G0 Z0", "M8"].contains(&lines[i - 1]), "{nc}");
        assert!(lines[i + 1].starts_with("X20 Y0"), "{nc}");
    }
    assert!(rs274(&nc).is_none_or(|r| r.is_ok()), "{nc}");
}

#[test]
fn controls_with_a_tilted_plane_get_it_and_are_proved() {
    for (machine, turn, on, off, n) in [
        ("fanuc-31i-5axis", "ROTABL/AXIS,1,ATANGL,60", "G68.2 X0. Y0. Z0. I0. J-60. K0.", "G69", 2),
        ("haas-umc", "ROTABL/AXIS,1,ATANGL,60", "G254", "G255", 3),
        (
            "siemens-840d-5axis",
            "ROTABL/AXIS,1,ATANGL,60",
            "CYCLE800(0,\"\",200000,57,0,0,0,-60,0,0,0,0,0,1,0,1)",
            "CYCLE800()",
            2,
        ),
        (
            "heidenhain-tnc-5axis",
            "ROTABL/AXIS,1,ATANGL,60",
            "PLANE SPATIAL SPA-60 SPB+0 SPC+0 TURN FMAX",
            "PLANE RESET STAY",
            2,
        ),
    ] {
        // Two angles at once, the tool change a place to begin again.
        let text = program(&[
            turn,
            "LOADTL/2",
            "ROTABL/AXIS,2,INCR,30",
            "ROTABL/AXIS,2,ATANGL,0\nROTABL/AXIS,1,ATANGL,0",
        ]);
        let (nc, posted) = post(machine, &text);
        let bad: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert!(bad.is_empty(), "{machine} {bad:#?}\n{nc}");
        assert_eq!(nc.lines().filter(|l| l.ends_with(on)).count(), n, "{machine}\n{nc}");
        assert_eq!(nc.lines().filter(|l| l.ends_with(off)).count(), 3, "{machine}\n{nc}");
        let proof = posted.proof.unwrap();
        assert!(proof.points > 150 && proof.position_mm < 0.002, "{machine} {proof:?}");
    }
}

#[test]
fn every_five_axis_machine_is_proved_at_turned_tables_and_heads() {
    for m in aptc_post::machines().filter(|m| m.rotary.len() == 2) {
        let parts = m.rotary.iter().filter(|r| r.carries == aptc_post::Carries::Part).count();
        let turns = match parts {
            2 => ["ROTABL/AXIS,1,ATANGL,25", "ROTABL/AXIS,2,ATANGL,-70"],
            1 => ["ROTABL/ATANGL,25", "ROTHED/ATANGL,-20"],
            _ => ["ROTHED/AXIS,1,ATANGL,25", "ROTHED/AXIS,2,ATANGL,-20"],
        };
        let (nc, posted) = post(&m.name, &program(&turns));
        let bad: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert!(bad.is_empty(), "{} {bad:#?}\n{nc}", m.name);
        assert!(posted.proof.unwrap().points > 80, "{}", m.name);
    }
}

#[test]
fn a_wrong_angle_or_plane_is_found() {
    for (machine, find, put) in [
        ("linuxcnc-4axis", "A90", "A91"),
        ("linuxcnc-4axis", "A90", "A-90"),
        ("fanuc-31i-5axis", "J-90.", "J90."),
        ("fanuc-31i-5axis", "G69\nG91", "G91"),
        ("siemens-840d-5axis", ",-90,0,0,", ",0,-90,0,"),
        ("heidenhain-tnc-5axis", "SPA-90", "SPA+90"),
        ("haas-umc", "G254", "G255"),
    ] {
        let axis = if machine == "linuxcnc-4axis" { "" } else { "AXIS,1," };
        let cl = program(&[&format!("ROTABL/{axis}ATANGL,90"), &format!("ROTABL/{axis}ATANGL,0")]);
        let nc = good(machine, &cl);
        let broken = nc.replacen(find, put, 1);
        assert_ne!(broken, nc, "{machine} {find}\n{nc}");
        let mut records = common::records(&cl).into_iter();
        let m = aptc_post::machine(machine).unwrap();
        let (_, list) = aptc_post::prove(m, &mut records, &mut broken.as_bytes()).unwrap();
        assert!(!list.is_empty(), "{machine} {find}\n{broken}");
    }
}

#[test]
fn brakes_are_let_go_before_a_turn_and_hold_after_it() {
    let nc = good("haas-umc", &program(&["ROTABL/AXIS,1,ATANGL,60"]));
    let lines: Vec<&str> = nc.lines().collect();
    let at = lines.iter().position(|l| *l == "M11").unwrap();
    assert_eq!(&lines[at..at + 3], ["M11", "G0 B60.", "M10"], "{nc}");
}

#[test]
fn the_way_round_is_the_one_asked_for() {
    for (turn, block) in [
        ("ROTABL/ATANGL,350", "G0 A-10"),
        ("ROTABL/ATANGL,350,CCLW", "G0 A350"),
        ("ROTABL/ATANGL,10,CLW", "G0 A-350"),
        ("ROTABL/INCR,400", "G0 A400"),
    ] {
        let nc = good("linuxcnc-4axis", &program(&[turn]));
        assert!(nc.lines().any(|l| l == block), "{turn}\n{nc}");
    }
    // Within one turn the control would take the shorter way: a stop in between leads it.
    let nc = good("fanuc-31i-5axis", &program(&["ROTABL/AXIS,2,ATANGL,350,CCLW"]));
    let turns: Vec<&str> = nc.lines().filter(|l| l.contains(" C") || l.starts_with('C')).collect();
    assert_eq!(turns, ["G0 C175.", "C350."], "{nc}");
}

#[test]
fn what_cannot_turn_is_refused_by_name() {
    for (machine, word, code) in [
        ("linuxcnc-mill", "ROTABL/ATANGL,90", "APT4006"),
        ("linuxcnc-4axis", "ROTHED/ATANGL,90", "APT4006"),
        ("linuxcnc-4axis", "ROTABL/90", "APT4006"),
        ("linuxcnc-4axis", "ROTABL/ATANGL,90,ROTREF", "APT4006"),
        ("linuxcnc-4axis", "ROTABL/AXIS,2,ATANGL,90", "APT4006"),
        ("linuxcnc-5axis", "ROTABL/ATANGL,90", "APT4006"),
        ("fanuc-31i-5axis", "ROTABL/AXIS,1,ATANGL,170", "APT4029"),
        ("linuxcnc-4axis", "MULTAX\nROTABL/ATANGL,90", "APT4006"),
        ("linuxcnc-4axis", "CUTCOM/LEFT,1\nGOTO/9,9,9\nROTABL/ATANGL,90", "APT4029"),
        ("linuxcnc-4axis", "ROTABL/ATANGL,90\nGOTO/0,0,50,0,-1,1", "APT4029"),
    ] {
        let text = format!("{HEAD}{word}\nGOTO/0,0,60\nFINI");
        let list = errors(machine, &text);
        assert_eq!(list.first().map(String::as_str), Some(code), "{machine} {word}: {list:?}");
    }
}
