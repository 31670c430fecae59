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
        let place =
            |w: &str| w.strip_prefix(['X', 'Y', 'Z']).is_some_and(|v| v.parse::<f64>().is_ok());
        let (spindle, way) = (on(after, "M3"), after.split_whitespace().position(place));
        assert!(spindle.zip(way).is_some_and(|(s, w)| s < w), "{}\n{nc}", m.name);
        assert!(on(after, "M8").is_some(), "{}\n{nc}", m.name);
        // What does not run is not started.
        let text = part(m, &head, "SPINDL/OFF\nCOOLNT/OFF\nSTOP");
        let (nc, _) = post_all(m, PostOptions::default(), &records(&text));
        let after = nc.split("M0\n").last().expect("it stops");
        assert!(on(after, "M3").is_none() && on(after, "M8").is_none(), "{nc}");
    }
}

/// A boring bar goes into the bore with its edge where ORIENT has put it: no spindle that waits, or that a stop has
/// stopped, starts after it before the program says so.
#[test]
fn an_oriented_spindle_does_not_turn_before_it_is_told() {
    let mut n = 0;
    for m in changers().filter(|m| m.kind == MachineKind::Mill && !m.spindle.orient.is_empty()) {
        let multax = if m.rotary.len() == 2 { "MULTAX\n" } else { "" };
        let code = m.spindle.orient.split('{').next().expect("a first part");
        for (head, middle, wanted) in [
            ("SPINDL/800,CLW\nSPINDL/ORIENT,0", "", "3o"),
            ("SPINDL/800,CLW\nSPINDL/ORIENT,0", "SPINDL/800,CLW", "3o3"),
            ("SPINDL/800,CLW", "STOP\nSPINDL/ORIENT,0", "3o"),
            ("SPINDL/800,CLW", "SPINDL/ORIENT,0\nSTOP", "3o"),
            ("SPINDL/800,CLW\nLOADTL/2,LENGTH,80\nSPINDL/ORIENT,0", "", "o"),
        ] {
            let head = format!("{multax}LOADTL/1,LENGTH,80\n{head}");
            let text = part(m, &head, middle);
            let options = PostOptions { map: true, ..PostOptions::default() };
            let (nc, posted) = post_all(m, options, &records(&text));
            assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{}\n{nc}", m.name);
            let mut course = String::new();
            for line in nc.lines() {
                if line.contains(code.trim()) {
                    course.push('o');
                } else if line.split_whitespace().any(|w| w == "M3") {
                    course.push('3');
                }
            }
            assert_eq!(course, wanted, "{} {middle}\n{nc}", m.name);
            assert!(posted.map.windows(2).all(|w| w[0].last < w[1].first), "{:?}", posted.map);
        }
        n += 1;
    }
    assert!(n >= 4, "{n}");
}

/// Where an operator skips the optional stop nothing has stopped: one kind of coolant ends before another begins.
#[test]
fn after_an_optional_stop_what_may_run_is_stopped() {
    let mut n = 0;
    for m in changers() {
        let Some([flood, mist, off]) = ["FLOOD", "MIST", "OFF"]
            .map(|k| m.coolant.get(k))
            .into_iter()
            .collect::<Option<Vec<_>>>()
            .and_then(|v| <[_; 3]>::try_from(v).ok())
        else {
            continue;
        };
        if flood == mist || m.program.optional_stop.is_empty() {
            continue;
        }
        let load = if m.kind == MachineKind::Lathe { "TURRET/1" } else { "LOADTL/1,LENGTH,80" };
        let multax = if m.rotary.len() == 2 { "MULTAX\n" } else { "" };
        let head = format!("{multax}{load}\nSPINDL/500,CLW\nCOOLNT/FLOOD");
        let of = |middle: &str| {
            let (nc, posted) =
                post_all(m, PostOptions::default(), &records(&part(m, &head, middle)));
            assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{}\n{nc}", m.name);
            let (_, after) = nc.split_once(m.program.optional_stop.as_str()).expect("it stops");
            after.to_owned()
        };
        let after = of("OPSTOP\nCOOLNT/MIST");
        let at = |text: &str, code: &str| {
            text.lines()
                .position(|l| l == code || l.split_once(' ').is_some_and(|(_, r)| r == code))
        };
        let (ends, begins) = (at(&after, off), at(&after, mist));
        assert!(ends.zip(begins).is_some_and(|(e, b)| e < b), "{}\n{after}", m.name);
        // The same kind only begins again.
        let after = of("OPSTOP\nCOOLNT/FLOOD");
        let (ends, begins) = (at(&after, off), at(&after, flood));
        assert!(begins.is_some_and(|b| ends.is_none_or(|e| b < e)), "{}\n{after}", m.name);
        n += 1;
    }
    assert!(n >= 3, "{n}");
}
