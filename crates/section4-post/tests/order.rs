//! The order of words at a tool change: spindle and coolant belong to the tool that comes.

mod common;

use aptc_post::{
    Dialect, Machine, MachineKind, PostOptions, TurningPlane, machine, machines, post_all,
};
use common::{good, post, records};

/// A part for mill or lathe with `head` before its first motion and `middle` before its second.
fn part(m: &Machine, head: &str, middle: &str) -> String {
    let at = |x: f64, z: f64| match (m.kind, m.turning.plane) {
        (MachineKind::Mill, _) => format!("{x},5,{z}"),
        (MachineKind::Lathe, TurningPlane::Xy) => format!("{z},{x},0"),
        (MachineKind::Lathe, _) => format!("{x},0,{z}"),
    };
    format!(
        "UNITS/MM\nCUTTER/6\n{head}\nFEDRAT/200\nFROM/{}\nRAPID\nGOTO/{}\nGOTO/{}\n\
         RAPID\nGOTO/{}\n{middle}\nGOTO/{}\nFINI",
        at(60.0, 100.0),
        at(20.0, 5.0),
        at(20.0, -5.0),
        at(40.0, 5.0),
        at(40.0, -5.0)
    )
}

/// Every machine that changes tools and turns a spindle.
fn changers() -> impl Iterator<Item = &'static Machine> {
    machines().filter(|m| m.dialect != Dialect::Apt && !m.program.tool_change.is_empty())
}

/// What the spindle, the coolant and the tool do, in the order of the blocks: `3` starts it, `5` stops it, `8` and `9`
/// are coolant, `T` a tool change. Stops of what does not run are left out.
fn course(m: &Machine, nc: &str) -> String {
    let changes = |line: &str| match (m.kind, m.dialect) {
        (_, Dialect::Heidenhain) => line.contains("TOOL CALL ") && line.contains(" Z"),
        (MachineKind::Lathe, _) if !line.contains("M6") => {
            line.split(' ').any(|w| w.len() == 5 && w.starts_with('T'))
        }
        // A control without a changer waits for the operator.
        _ => line.contains(" M6") || line == "M0",
    };
    let (mut out, mut spindle, mut coolant) = (String::new(), false, false);
    for line in nc.lines().filter(|l| !l.starts_with('(')) {
        if changes(line) {
            out.push('T');
        }
        for word in line.split_whitespace() {
            match word {
                "M3" => (spindle, out) = (true, out + "3"),
                "M5" if spindle => (spindle, out) = (false, out + "5"),
                "M8" => (coolant, out) = (true, out + "8"),
                "M9" if coolant => (coolant, out) = (false, out + "9"),
                _ => {}
            }
        }
    }
    out
}

#[test]
fn spindle_and_coolant_come_on_after_the_tool_change_that_follows_them() {
    let mut n = 0;
    for m in changers() {
        let load = if m.kind == MachineKind::Lathe { "TURRET" } else { "LOADTL" };
        let multax = if m.rotary.len() == 2 { "MULTAX\n" } else { "" };
        let length = if m.kind == MachineKind::Mill { ",LENGTH,80" } else { "" };
        let head = format!("{multax}SPINDL/500,CLW\nCOOLNT/ON\nPPRINT NEXT\n{load}/1{length}");
        let middle = format!("COOLNT/ON\nSPINDL/600,CLW\n{load}/2{length}");
        let (nc, posted) = post_all(m, PostOptions::default(), &records(&part(m, &head, &middle)));
        assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{}\n{nc}", m.name);
        assert_eq!(course(m, &nc), "T3895T3895", "{}\n{nc}", m.name);
        assert!(nc.contains("S500") && nc.contains("S600"), "{}\n{nc}", m.name);
        let warned: Vec<_> = posted
            .diagnostics
            .iter()
            .map(|d| d.message.as_str())
            .filter(|t| t.contains("turned"))
            .collect();
        if m.kind == MachineKind::Lathe {
            assert!(warned.is_empty(), "{}: {warned:?}", m.name);
        } else {
            assert_eq!(warned.len(), 2, "{}: {warned:?}", m.name);
            assert!(warned[0].contains("happens to be in the spindle"), "{warned:?}");
            assert!(warned[1].contains("tool 1 would have turned"), "{warned:?}");
        }
        n += 1;
    }
    assert!(n > 12);
}

#[test]
fn what_runs_already_is_no_mistake_before_a_tool_change() {
    let m = machine("fanuc-0i-mill").expect("built in");
    let text = part(m, "LOADTL/1\nSPINDL/500,CLW\nCOOLNT/ON", "SPINDL/500,CLW\nLOADTL/2");
    let (nc, posted) = post("fanuc-0i-mill", &text);
    assert!(posted.diagnostics.is_empty(), "{:?}", posted.diagnostics);
    assert_eq!(course(m, &nc), "T3895T3895");
}

#[test]
fn a_dwell_or_a_stop_finds_the_spindle_running() {
    for word in ["DELAY/2", "STOP", "OPSTOP", "INSERT M98 P100", "AUXFUN/40"] {
        let m = machine("haas-vf").expect("built in");
        let nc = good("haas-vf", &part(m, &format!("LOADTL/1\nSPINDL/500,CLW\n{word}"), ""));
        let lines: Vec<&str> = nc.lines().collect();
        let at = lines.iter().position(|l| l.contains("M3")).expect("it turns");
        let next = lines[at + 1];
        assert!(!next.contains('X') && !next.contains('Z'), "{word}: {next}\n{nc}");
    }
}

#[test]
fn blocks_of_a_spindle_that_waited_are_its_own() {
    let m = machine("linuxcnc-mill").expect("built in");
    let options = PostOptions { map: true, annotate: true, ..PostOptions::default() };
    let text = part(m, "LOADTL/1\nSPINDL/500,CLW\nCOOLNT/ON", "");
    let (nc, posted) = post_all(m, options, &records(&text));
    let lines: Vec<&str> = nc.lines().collect();
    for (word, code) in [("SPINDL", "M3"), ("COOLNT", "M8")] {
        let of: Vec<_> = posted.map.iter().filter(|b| b.record == word).collect();
        assert_eq!(of.len(), 1, "{word}: {:?}", posted.map);
        let first = usize::try_from(of[0].first).expect("small") - 1;
        let last = usize::try_from(of[0].last).expect("small") - 1;
        assert!(lines[first..=last].iter().any(|l| l.contains(code)), "{word}\n{nc}");
    }
    assert!(posted.map.windows(2).all(|w| w[0].last < w[1].first), "{:?}", posted.map);
}

#[test]
fn after_a_stop_spindle_and_coolant_run_again() {
    for m in changers() {
        let load = if m.kind == MachineKind::Lathe { "TURRET" } else { "LOADTL" };
        let multax = if m.rotary.len() == 2 { "MULTAX\n" } else { "" };
        let length = if m.kind == MachineKind::Mill { ",LENGTH,80" } else { "" };
        let head = format!("{multax}{load}/1{length}\nSPINDL/500,CLW\nCOOLNT/ON");
        let (nc, _) = post_all(m, PostOptions::default(), &records(&part(m, &head, "STOP")));
        let after = nc.split("M0\n").last().expect("it stops");
        let on = |text: &str, word: &str| text.split_whitespace().position(|w| w == word);
        let (spindle, cut) = (on(after, "M3"), on(after, "F200"));
        assert!(spindle.is_some_and(|s| cut.is_none_or(|c| s < c)), "{}\n{nc}", m.name);
        assert!(on(after, "M8").is_some(), "{}\n{nc}", m.name);
        // What does not run is not started.
        let text = part(m, &head, "SPINDL/OFF\nCOOLNT/OFF\nSTOP");
        let (nc, _) = post_all(m, PostOptions::default(), &records(&text));
        let after = nc.split("M0\n").last().expect("it stops");
        assert!(on(after, "M3").is_none() && on(after, "M8").is_none(), "{nc}");
    }
}
