//! Cycles that random CL data have shown to come out wrong, and messages that came more than once.

mod common;

use common::{good, post};

const READY: &str = "UNITS/MM\nLOADTL/1\nSPINDL/1000,CLW\nCOOLNT/ON\nFEDRAT/100\n";

fn told(machine: &str, text: &str) -> Vec<String> {
    let diagnostics = post(machine, text).1.diagnostics;
    diagnostics.iter().map(|d| format!("{} {}", d.code, d.message)).collect()
}

#[test]
fn a_cycle_without_a_step_is_told_once() {
    for (machine, step) in [("linuxcnc-mill", ""), ("siemens-840d-mill", ",STEP,0")] {
        let holes = "GOTO/0,0,0\nGOTO/9,0,0\nGOTO/18,0,0\nCYCLE/OFF\nFINI";
        let cycle = format!("CYCLE/DEEP,DEPTH,5,CLEAR,1{step}\n");
        let list = told(machine, &format!("{READY}RAPID\nGOTO/0,0,50\n{cycle}{holes}"));
        assert_eq!(list, ["APT4005 CYCLE/DEEP has no step"], "{machine}");
    }
}

#[test]
fn axes_out_of_reach_are_counted() {
    let text =
        format!("{READY}GOTO/0,0,9\nGOTO/1,0,9,1,0,1\nGOTO/2,0,9,1,0,1\nGOTO/3,0,9,0,1,1\nFINI");
    let list = told("linuxcnc-mill", &text);
    assert_eq!(list.len(), 1, "{list:?}");
    assert!(list[0].ends_with("the first of 3 positions"), "{list:?}");
    let list = told("linuxcnc-4axis", &text);
    assert!(list.iter().filter(|m| m.starts_with("APT4004")).count() == 1, "{list:?}");
}

#[test]
fn turned_axes_without_a_tool_want_its_length() {
    let text = "UNITS/MM\nSPINDL/1000,CLW\nCOOLNT/ON\nFEDRAT/100\nRAPID\nGOTO/0,0,50,0,1,1\nGOTO/0,0,9,0,1,1\nFINI";
    for machine in ["fanuc-31i-5axis", "siemens-840d-5axis", "linuxcnc-5axis-head"] {
        let list = told(machine, text);
        assert_eq!(list.iter().filter(|m| m.starts_with("APT4022")).count(), 1, "{list:?}");
        assert!(!list.iter().any(|m| m.starts_with("APT5401")), "{list:?}");
        let loaded = format!("LOADTL/1\n{}", text);
        assert!(!told(machine, &loaded).iter().any(|m| m.starts_with("APT4022")), "{machine}");
    }
}

/// The lines that bring the tool home leave inverse time on.
#[test]
fn a_cycle_after_inverse_time_and_home_has_its_feed_per_minute() {
    for (machine, home) in [("linuxcnc-5axis", "GOHOME"), ("linuxcnc-mill", "RETRCT")] {
        let cut = "FEDRAT/INVERS,AUTO\nGOTO/0,0,9\nGOTO/5,0,8\nFEDRAT/INVERS,OFF\n";
        let text =
            format!("{READY}{cut}{home}\nCYCLE/DRILL,DEPTH,5,CLEAR,2\nGOTO/1,1,0\nCYCLE/OFF\nFINI");
        let nc = good(machine, &text);
        let cycle = nc.lines().find(|l| l.contains("G81")).unwrap_or_default();
        assert!(cycle.starts_with("G94 "), "{nc}");
    }
    let text = format!(
        "{READY}FEDRAT/INVERS,AUTO\nGOTO/0,0,9\nGOTO/5,0,8\nCYCLE/DRILL,DEPTH,5,CLEAR,2\nGOTO/1,1,0\nCYCLE/OFF\nFINI"
    );
    let nc = good("siemens-840d-5axis", &text);
    let [feed, cycle] = ["G94\n", "MCALL CYCLE81"].map(|word| nc.rfind(word));
    let inverse = nc.find("G93").expect("inverse time");
    assert!(feed.is_some_and(|at| inverse < at) && feed < cycle, "{nc}");
}

#[test]
fn even_pecks_leave_no_sliver() {
    let cycle = "CYCLE/DEEP,DEPTH,10,CLEAR,2,STEP,1.3333\nGOTO/0,0,0\nCYCLE/OFF\nFINI";
    let nc = good("fanuc-0i-mill", &format!("{READY}RAPID\nGOTO/0,0,50\n{cycle}"));
    assert!(nc.contains("Q1.334"), "{nc}");
    // Expanded: nine ways down at feed, none longer than a thousandth over the step.
    let nc = good(
        "grbl",
        &format!("UNITS/MM\nSPINDL/1000,CLW\nCOOLNT/ON\nFEDRAT/100\nRAPID\nGOTO/0,0,50\n{cycle}"),
    );
    assert_eq!(nc.matches("G1 Z").count(), 9, "{nc}");
}

/// Rounded angles set holes of one height some steps apart: the control is brought up before, and reads back well.
#[test]
fn holes_of_one_tilted_plane_begin_at_their_clearance() {
    for k in 1..12_u32 {
        let angle = 0.11 * f64::from(k) + 0.003;
        let (s, c) = aptc_geometry::trig::sin_cos(angle);
        let holes: String = (0..24)
            .map(|i| (f64::from(i) * 37.3 - 400.0, f64::from((i * 7) % 24) * 29.1 - 300.0))
            .map(|(x, y)| format!("GOTO/{x:.4},{:.4},{:.4},0,{s:.6},{c:.6}\n", y * c, -y * s))
            .collect();
        let head = format!("{READY}MULTAX\nRAPID\nGOTO/0,90,90,0,{s:.6},{c:.6}\n");
        for machine in ["linuxcnc-5axis", "linuxcnc-5axis-nutated", "fanuc-31i-5axis"] {
            good(
                machine,
                &format!("{head}CYCLE/DEEP,DEPTH,7,CLEAR,2,STEP,3\n{holes}CYCLE/OFF\nFINI"),
            );
        }
    }
}

#[test]
fn a_pitch_that_no_thread_has_is_doubted() {
    let tap = |args: &str| {
        let text = format!("{READY}FROM/0,0,50\nCYCLE/TAP,{args}\nGOTO/1,2,0\nCYCLE/OFF\nFINI\n");
        told("haas-vf", &text).iter().filter(|m| m.starts_with("APT4032")).count()
    };
    assert_eq!(tap("20,1.25,5"), 1);
    assert_eq!(tap("DEPTH,20,MMPM,1.25,CLEAR,5"), 1);
    for right in ["20,1250,5", "DEPTH,20,MMPR,1.25,CLEAR,5", "DEPTH,20,PITCH,1.25,CLEAR,5"] {
        assert_eq!(tap(right), 0, "{right}");
    }
}
