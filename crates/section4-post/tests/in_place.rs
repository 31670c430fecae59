//! Blocks in which only rotary axes move: they have a time of their own, for the feed of a tool end that rests says
//! nothing.

mod common;

use aptc_geometry::trig;
use aptc_post::{PostOptions, machine, machines, post_all};
use common::{good, records};

/// A swing of the tool at its place, and a cut after it. The cutter of 10 is 50 high: 30 of it count.
fn part(m: &aptc_post::Machine, unit: &str, feed: f64, degrees: f64) -> String {
    let scale = if unit == "MM" { 1.0 } else { 1.0 / 25.4 };
    let a = degrees.to_radians();
    // Across the second axis, which any of the machines has room to turn about.
    let (s, c) = (trig::sin(a), trig::cos(a));
    let about_x = m.rotary.iter().any(|r| r.axis[0].abs() > 0.9);
    let axis = if about_x { format!("0,{s},{c}") } else { format!("{s},0,{c}") };
    let at = |x: f64, axis: &str| format!("{},0,{},{axis}", x * scale, 10.0 * scale);
    format!(
        "UNITS/{unit}\nCUTTER/{}\nMULTAX\nLOADTL/1,LENGTH,{}\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/{feed}\n\
         FROM/0,0,{},0,0,1\nRAPID\nGOTO/{}\nGOTO/{}\nGOTO/{}\nGOTO/{}\nFINI",
        10.0 * scale,
        80.0 * scale,
        100.0 * scale,
        at(0.0, "0,0,1"),
        at(20.0, "0,0,1"),
        at(20.0, &axis),
        at(40.0, &axis)
    )
}

fn value(line: &str, letter: char) -> Option<f64> {
    line.split_whitespace().find_map(|w| w.strip_prefix(letter)?.parse().ok())
}

#[test]
fn the_flank_sweeps_at_the_feed_and_the_next_cut_has_its_own_again() {
    let mut n = 0;
    for m in machines().filter(|m| m.rotary.len() == 2 && m.milling.is_none()) {
        let text = part(m, "MM", 300.0, 20.0);
        let (nc, posted) = post_all(m, PostOptions::default(), &records(&text));
        assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{}\n{nc}", m.name);
        let turns = |l: &&str| m.rotary.iter().any(|r| value(l, r.letter).is_some());
        let cuts: Vec<&str> =
            nc.lines().skip_while(|l| !l.contains("X20") && !l.contains("X+20")).collect();
        let blocks: Vec<&str> =
            cuts.iter().copied().filter(turns).filter(|l| l.contains('F')).collect();
        assert!(!blocks.is_empty(), "{}\n{nc}", m.name);
        // A way of 30 mm through 20 degrees; the axis lies so that no free axis turns before it.
        let wanted = 30.0 * 20.0_f64.to_radians() / 300.0;
        let mut minutes = 0.0;
        let mut total = 0.0;
        for line in &blocks {
            let f = value(line, 'F').expect("each has its own");
            minutes += if m.feed.inverse_time.is_empty() {
                let turn: f64 =
                    m.rotary.iter().filter_map(|r| value(line, r.letter)).map(f64::abs).sum();
                total += turn;
                turn / f
            } else {
                1.0 / f
            };
        }
        assert!(
            minutes > 0.95 * wanted && minutes < 1.2 * wanted,
            "{}: {minutes} min, {wanted} wanted ({total})\n{}",
            m.name,
            blocks.join("\n")
        );
        let last = cuts.iter().rev().find(|l| l.contains("F300"));
        assert!(last.is_some(), "{}: {}", m.name, cuts.join("\n"));
        if !m.feed.inverse_time.is_empty() {
            let after = cuts.iter().skip_while(|l| !l.contains("G93")).find(|l| l.contains("F300"));
            assert!(after.is_some_and(|l| l.contains("G94")), "{}\n{nc}", m.name);
        }
        n += 1;
    }
    assert!(n >= 7, "{n}");
}

#[test]
fn programs_in_inches_turn_as_fast() {
    for name in [
        "fanuc-31i-5axis",
        "haas-umc",
        "siemens-840d-5axis",
        "heidenhain-tnc-5axis",
        "linuxcnc-5axis",
    ] {
        let m = machine(name).expect("built in");
        let of = |unit: &str, feed: f64| {
            let nc = good(name, &part(m, unit, feed, 20.0));
            let line = nc.lines().filter(|l| value(l, 'F').is_some()).nth(1).map(str::to_owned);
            value(&line.expect("the turn"), 'F').expect("its feed")
        };
        let (mm, inch) = (of("MM", 254.0), of("INCHES", 10.0));
        assert!((mm - inch).abs() <= 0.02 * mm, "{name}: {mm} {inch}");
    }
}

#[test]
fn a_spin_about_its_own_axis_is_no_faster_than_ten_turns_a_minute() {
    // From the tool along Z the table must first be laid the right way: C turns while the tool stands.
    let text = "UNITS/MM\nCUTTER/10\nMULTAX\nLOADTL/1,LENGTH,80\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/5000\n\
        FROM/0,0,100,0,0,1\nRAPID\nGOTO/0,0,10,0,0,1\nGOTO/20,0,10,0,0,1\nGOTO/20,30,10,.5,.0,.8660254\nFINI";
    for name in ["fanuc-31i-5axis", "siemens-840d-5axis", "linuxcnc-5axis", "haas-umc"] {
        let nc = good(name, text);
        for line in nc.lines() {
            let only =
                value(line, 'C').filter(|_| "XYZAB".chars().all(|l| value(line, l).is_none()));
            if let (Some(c), Some(f)) = (only, value(line, 'F')) {
                assert!(c.min(360.0 - c).abs() * f <= 3601.0, "{name}: {line}\n{nc}");
            }
        }
    }
}

#[test]
fn fanuc_says_which_parameter_it_needs() {
    let m = machine("fanuc-31i-5axis").expect("built in");
    let nc = good("fanuc-31i-5axis", &part(m, "MM", 300.0, 20.0));
    assert_eq!(nc.matches("PARAMETER 19696").count(), 1, "{nc}");
    let straight = good(
        "fanuc-31i-5axis",
        "UNITS/MM\nLOADTL/1\nSPINDL/3000,CLW\nFEDRAT/300\nFROM/0,0,100\nGOTO/0,0,10\nGOTO/9,0,10\nFINI",
    );
    assert!(!straight.contains("19696"), "{straight}");
}

/// Heidenhain wants M128 reset before M91 and TOOL CALL; with TRAORI on, SUPA goes to no place of the machine.
#[test]
fn tool_center_control_is_off_where_the_machine_goes_to_a_place_of_its_own() {
    for (name, on, off, home) in [
        ("heidenhain-tnc-5axis", "M128", "M129", ["M91", "TOOL CALL 2"]),
        ("siemens-840d-5axis", "TRAORI", "TRAFOOF", ["SUPA", "T2 M6"]),
    ] {
        let m = machine(name).expect("built in");
        let one = part(m, "MM", 300.0, 20.0);
        let (head, _) = one.split_once("FINI").expect("it ends");
        let text = format!(
            "{head}RETRCT\nGOTO/40,0,40,0,0,1\nGOTO/60,0,40,0,0,1\nLOADTL/2,LENGTH,80\nSPINDL/900,CLW\n\
             GOTO/60,0,10,0,0,1\nGOHOME\nGOTO/70,0,10,0,0,1\nEND\nFINI"
        );
        let nc = good(name, &text);
        let (mut active, mut times) = (false, 0);
        for line in nc.lines() {
            if line.ends_with(on) {
                assert!(!active, "{nc}");
                (active, times) = (true, times + 1);
            } else if line.ends_with(off) {
                assert!(active, "{nc}");
                active = false;
            } else {
                assert!(!active || home.iter().all(|h| !line.contains(h)), "{name}: {line}\n{nc}");
            }
        }
        assert!(!active && times == 4, "{name}: {times}\n{nc}");
    }
}
