//! Tapping with the spindle, as the machine file says it.

mod common;

use aptc_post::{Machine, PostOptions, machine, post_all, prove};
use common::{good, records, rs274};

/// Two threads M6, with another tool motion behind them.
fn program(hand: &str) -> String {
    format!(
        "UNITS/MM\nLOADTL/4\nSPINDL/500,{hand}\nCOOLNT/ON\nFEDRAT/300\nFROM/0,0,100\n\
         CYCLE/TAP,DEPTH,12,MMPM,500,CLEAR,4\nGOTO/10,10,0\nGOTO/30,10,0\nCYCLE/OFF\nGOTO/0,0,20\nFINI"
    )
}

fn blocks(nc: &str) -> Vec<&str> {
    nc.lines().collect()
}

#[test]
fn each_control_taps_in_its_own_way_right_and_left_handed() {
    for (name, right, left) in [
        ("fanuc-0i-mill", "M29 S500\nG99 G84 X10. Y10. Z-12. R4. F500", "M29 S500\nG99 G74 X10."),
        ("haas-vf", "G99 G84 X10. Y10. Z-12. R4. F500", "G99 G74 X10."),
        ("linuxcnc-mill", "G99 G84 X10 Y10 Z-12 R4 F500", "G99 G74 X10"),
        (
            "siemens-840d-mill",
            "CYCLE84(4,0,4,-12,,0,5,,1,0,500,500)",
            "CYCLE84(4,0,4,-12,,0,5,,-1,0,500,500)",
        ),
        ("heidenhain-tnc", "Q239=1 ", "Q239=-1 "),
    ] {
        for (hand, expected) in [("CLW", right), ("CCLW", left)] {
            let nc = good(name, &program(hand));
            assert!(nc.contains(expected), "{name} {hand}: {expected}\n{nc}");
        }
    }
}

/// Rigid tapping stops the spindle: it runs again before the next cut, and not between the holes.
#[test]
fn the_spindle_runs_again_after_rigid_tapping() {
    let nc = good("fanuc-0i-mill", &program("CLW"));
    let lines = blocks(&nc);
    let at = |what: &str| {
        lines.iter().position(|l| l.contains(what)).unwrap_or_else(|| panic!("{what}\n{nc}"))
    };
    let (tap, second, off) = (at("G84"), at("X30."), at("G80"));
    let starts: Vec<_> = (0..lines.len()).filter(|&i| lines[i].contains("M3")).collect();
    assert_eq!(lines.iter().filter(|l| l.contains("M29")).count(), 1, "{nc}");
    assert!(starts.iter().all(|i| *i < tap || *i > second), "{nc}");
    assert!(starts.iter().any(|i| *i > second) && second > tap && off > 0, "{nc}");
}

#[test]
fn linuxcnc_taps_with_its_synchronised_code() {
    let own = machine("linuxcnc-mill").unwrap();
    let mut own: Machine = own.clone();
    let tap = own.cycles.get_mut("TAP").unwrap();
    (tap.code, tap.lead) = ("G33.1".into(), Some('K'));
    let records = records(&program("CLW"));
    let (nc, posted) = post_all(&own, PostOptions::default(), &records);
    assert!(posted.diagnostics.iter().all(|d| !d.is_error()), "{:#?}\n{nc}", posted.diagnostics);
    assert_eq!(nc.matches("G33.1 Z-12 K1").count(), 2, "{nc}");
    if let Some(ran) = rs274(&nc) {
        let canon = ran.unwrap_or_else(|e| panic!("{e}\n{nc}"));
        let taps: Vec<_> = canon.iter().filter(|c| c.name == "RIGID_TAP").collect();
        assert_eq!(taps.len(), 2, "{nc}");
        assert!(
            (taps[1].numbers[0] - 30.0).abs() < 1e-6 && (taps[1].numbers[2] + 12.0).abs() < 1e-6
        );
    }
    for wrong in
        [("Z-12 K1", "Z-11 K1"), ("Z-12 K1", "Z-12"), ("G33.1", "G33"), ("G33.1 Z", "G33.1 X1 Z")]
    {
        let nc = nc.replace(wrong.0, wrong.1);
        let (_, said) = prove(&own, &mut records.clone().into_iter(), &mut nc.as_bytes()).unwrap();
        assert!(!said.is_empty(), "{wrong:?}\n{nc}");
    }
}

#[test]
fn what_a_machine_file_cannot_mean_is_named() {
    let text = include_str!("../machines/linuxcnc-mill.toml");
    let tap = "TAP = { code = \"G84\", spindle = \"CLW\" }";
    for (to, what) in [
        ("TAP = { code = \"G84\", before = [\"M29 S{sped}\"] }", "{sped}"),
        (
            "TAP = { code = \"G33.1\", lead = \"K\", before = [\"M29\"] }",
            "`lead` goes with `code` alone",
        ),
    ] {
        assert!(text.contains(tap));
        let said = Machine::parse(&text.replace(tap, to)).unwrap_err();
        assert!(said[0].message.contains(what), "{said:?}");
    }
}
