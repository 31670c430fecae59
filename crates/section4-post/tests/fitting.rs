//! Arcs in place of runs of short lines: never farther from them than was allowed.

mod common;

use aptc_geometry::trig;
use common::{errors, good, post, rs274};

const HEAD: &str = "UNITS/MM\nOUTTOL/.01\nCUTTER/6\nLOADTL/1\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\nFROM/0,0,100\n";

/// A slot with round ends in lines of half a millimetre, one record each.
fn slot() -> String {
    let mut text = String::from("RAPID\nGOTO/0,-10,5\nGOTO/0,-10,-1\n");
    let mut go = |x: f64, y: f64| text.push_str(&format!("GOTO/{x:.4},{y:.4},-1\n"));
    for i in 1..=30 {
        go(f64::from(i), -10.0);
    }
    for i in 1..=60 {
        let (s, c) = trig::sin_cos((f64::from(i) * 3.0 - 90.0).to_radians());
        go(30.0 + 10.0 * c, 10.0 * s);
    }
    for i in 1..=30 {
        go(30.0 - f64::from(i), 10.0);
    }
    for i in 1..=60 {
        let (s, c) = trig::sin_cos((f64::from(i) * 3.0 + 90.0).to_radians());
        go(10.0 * c, 10.0 * s);
    }
    text
}

#[test]
fn runs_become_arcs_within_the_tolerance_and_the_whole_is_told() {
    let text = format!("{HEAD}ARCSLP/LINCIR,ON,.01\n{}RAPID\nGOTO/0,0,50\nFINI", slot());
    for machine in
        ["linuxcnc-mill", "fanuc-0i-mill", "haas-vf", "siemens-840d-mill", "heidenhain-tnc", "grbl"]
    {
        let (nc, posted) = post(machine, &text);
        let bad: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert!(bad.is_empty(), "{machine} {bad:#?}\n{nc}");
        let arcs = posted.summary.arcs;
        assert!((2..=6).contains(&arcs) && posted.summary.blocks < 100, "{machine} {arcs}\n{nc}");
        let told = posted.diagnostics.iter().find(|d| d.code.to_string() == "APT4028").unwrap();
        assert!(
            told.message.contains("0.01 with rounding") && told.message.contains("0.02 in all"),
            "{told:?}"
        );
        let proof = posted.proof.unwrap();
        assert!(proof.points >= 182 && proof.path_mm <= 0.0105, "{machine} {proof:?}");
    }
    let nc = good("linuxcnc-mill", &text);
    assert!(rs274(&nc).is_none_or(|r| r.is_ok()), "{nc}");
}

#[test]
fn what_was_not_asked_for_stays_lines_and_off_ends_it() {
    let lines = good("linuxcnc-mill", &format!("{HEAD}{}FINI", slot()));
    assert!(!lines.contains("G2") || !lines.contains(" I"), "{lines}");
    let off = format!("{HEAD}ARCSLP/LINCIR,ON,.01\nARCSLP/LINCIR,OFF\n{}FINI", slot());
    assert_eq!(good("linuxcnc-mill", &off), lines);
    // A tolerance that rounding alone may take leaves nothing to fit.
    let tiny = format!("{HEAD}ARCSLP/LINCIR,ON,.0002\n{}FINI", slot());
    assert_eq!(good("linuxcnc-mill", &tiny), lines);
}

#[test]
fn the_machine_file_may_ask_for_it() {
    let text =
        include_str!("../machines/linuxcnc-mill.toml").replace("[arcs]", "[arcs]\nfit = 0.01");
    let machine = aptc_post::Machine::parse(&text).unwrap();
    let records = common::records(&format!("{HEAD}{}FINI", slot()));
    let (nc, posted) = aptc_post::post_all(
        &machine,
        aptc_post::PostOptions { map: true, ..Default::default() },
        &records,
    );
    assert!(posted.summary.arcs >= 2 && !posted.diagnostics.iter().any(|d| d.is_error()), "{nc}");
    // Each block still knows its statement: an arc that of its end.
    let total = nc.lines().count() as u64;
    let mapped: u64 = posted.map.iter().map(|m| m.last - m.first + 1).sum();
    assert!(mapped + 6 >= total, "{mapped} of {total}");
    assert!(
        posted
            .map
            .windows(2)
            .all(|w| w[0].last < w[1].first && w[0].origin.line <= w[1].origin.line)
    );
}

#[test]
fn a_run_longer_than_the_memory_is_the_same_path() {
    // A spiral of 20,000 lines: arcs end where the memory ends, and nothing is lost.
    let mut text = format!("{HEAD}ARCSLP/LINCIR,ON,.005\nGOTO/5,0,0\n");
    for i in 1..20_000 {
        let (s, c) = trig::sin_cos(f64::from(i) * 0.02);
        let r = 5.0 + f64::from(i) * 0.001;
        text.push_str(&format!("GOTO/{:.4},{:.4},0\n", r * c, r * s));
    }
    let (_, posted) = post("linuxcnc-mill", &format!("{text}FINI"));
    assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{:?}", posted.diagnostics);
    let proof = posted.proof.unwrap();
    assert!(proof.points >= 20_000 && proof.path_mm <= 0.0055, "{proof:?}");
    assert!(posted.summary.blocks < 2_000, "{}", posted.summary.blocks);
}

#[test]
fn a_changed_arc_is_found() {
    let cl = format!("{HEAD}ARCSLP/LINCIR,ON,.01\n{}FINI", slot());
    let nc = good("linuxcnc-mill", &cl);
    let arc = nc.lines().find(|l| l.starts_with("G3")).unwrap();
    let m = aptc_post::machine("linuxcnc-mill").unwrap();
    let check = |text: &str| {
        let mut records = common::records(&cl).into_iter();
        aptc_post::prove(m, &mut records, &mut text.as_bytes()).unwrap().1
    };
    assert!(check(&nc).is_empty(), "{:?}", check(&nc));
    for broken in [arc.replace("G3", "G2"), arc.replace(" I", " I0.1"), arc.replace(" J", " J-0.1")]
    {
        assert!(!check(&nc.replacen(arc, &broken, 1)).is_empty(), "{broken}");
    }
}

#[test]
fn what_has_no_arcs_refuses() {
    for (machine, word, code) in [
        ("linuxcnc-mill", "ARCSLP/LINCIR,ON", "APT4007"),
        ("linuxcnc-mill", "ARCSLP/LINCIR,ON,-1", "APT4007"),
        ("linuxcnc-mill", "ARCSLP/5", "APT4006"),
    ] {
        assert_eq!(errors(machine, &format!("{HEAD}{word}\nGOTO/0,0,1\nFINI")), [code], "{word}");
    }
}

/// A ramp of two and a half turns down into a round pocket, in lines: a helix a half turn.
#[test]
fn ramps_in_lines_become_helices() {
    let mut text = format!("{HEAD}ARCSLP/LINCIR,ON,.01\nRAPID\nGOTO/10,0,1\nGOTO/10,0,0\n");
    for i in 1..=300 {
        let (s, c) = trig::sin_cos((f64::from(i) * 3.0).to_radians());
        text.push_str(&format!(
            "GOTO/{:.4},{:.4},{:.4}\n",
            10.0 * c,
            10.0 * s,
            -f64::from(i) * 0.02
        ));
    }
    text.push_str("RAPID\nGOTO/0,0,50\nFINI");
    for machine in ["linuxcnc-mill", "fanuc-0i-mill", "haas-vf", "siemens-840d-mill"] {
        let (nc, posted) = post(machine, &text);
        let bad: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert!(bad.is_empty(), "{machine} {bad:#?}\n{nc}");
        let arcs = posted.summary.arcs;
        assert!((5..=8).contains(&arcs) && posted.summary.blocks < 60, "{machine} {arcs}\n{nc}");
        let proof = posted.proof.unwrap();
        assert!(proof.points >= 302 && proof.path_mm <= 0.0105, "{machine} {proof:?}");
    }
    let nc = good("linuxcnc-mill", &text);
    let Some(ran) = rs274(&nc) else { return };
    let canon = ran.unwrap_or_else(|e| panic!("{e}\n{nc}"));
    let last = canon.iter().rfind(|c| c.name == "ARC_FEED").expect("an arc");
    assert!((last.numbers[5] + 6.0).abs() < 1e-3, "{nc}");
    // Where a helix has no end of its own that the control is told, lines stay lines.
    let nc = good("heidenhain-tnc", &text);
    assert!(!nc.contains("CP ") && nc.matches("\nL ").count() == 0 && nc.contains(" L X"), "{nc}");
}
