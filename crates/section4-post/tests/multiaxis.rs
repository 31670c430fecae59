//! Programs with a moving tool axis.

mod common;

use common::{errors, good, rs274};

const HEAD: &str = "UNITS/MM\nLOADTL/1,LENGTH,80\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\nMULTAX\nFROM/0,0,100,0,0,1\n";
const FIVE: &[&str] = &[
    "linuxcnc-5axis",
    "linuxcnc-5axis-head",
    "linuxcnc-5axis-head-table",
    "linuxcnc-5axis-nutated",
];

#[test]
fn all_kinds_of_machines_are_accepted() {
    let text = format!(
        "{HEAD}RAPID\nGOTO/10,0,30,0,.2,1\nGOTO/20,5,10,.3,.1,1\nGOTO/30,5,12,.4,-.2,1\nGOTO/0,-30,5,-.2,-.4,1\n\
         RAPID\nGOTO/0,-30,100,0,0,1\nFINI"
    );
    for machine in FIVE {
        let nc = good(machine, &text);
        assert!(nc.contains("G93"), "{machine}\n{nc}");
        if let Some(r) = rs274(&nc) {
            r.unwrap_or_else(|e| panic!("{machine}: {e}\n{nc}"));
        }
    }
}

#[test]
fn upright_arcs_stay_arcs() {
    let arc = common::chords([0.0, 0.0, 10.0], 20.0, 0.0, 180.0, 40, 0.0);
    for machine in FIVE {
        let nc = good(machine, &format!("{HEAD}GOTO/20,0,10\n{arc}FINI"));
        assert_eq!(nc.matches("G3 ").count(), 1, "{machine}\n{nc}");
        assert!(rs274(&nc).is_none_or(|r| r.is_ok()));
    }
}

#[test]
fn four_axes_take_the_axes_that_they_can() {
    let text = format!("{HEAD}GOTO/10,0,30,0,1,1\nGOTO/20,0,30,0,1,0\n");
    let nc = good("linuxcnc-4axis", &format!("{text}FINI"));
    assert!(nc.contains("A45") && nc.contains("A90"), "{nc}");
    assert_eq!(errors("linuxcnc-4axis", &format!("{text}GOTO/0,0,0,1,0,1\nFINI")), ["APT4004"]);
}

/// From hole to hole with other tool axes the way between is not known: by way of the clearance plane, or with the
/// tool retracted by the machine.
#[test]
fn holes_with_other_axes_are_reached_from_clear_of_the_part() {
    // A dome of radius 30 about the zero: the straight way between the two retract heights cuts through it.
    let holes = "CYCLE/DRILL,DEPTH,5,MMPM,100,CLEAR,1\nGOTO/-18,0,24,-.6,0,.8\nGOTO/18,0,24,.6,0,.8\nCYCLE/OFF\nFINI";
    for machine in FIVE {
        let nc = good(machine, &format!("{HEAD}CLRSRF/40\n{holes}"));
        // Without a clearance plane the machine retracts once more.
        let home = good(machine, &format!("{HEAD}{holes}"));
        assert!(home.matches("G53").count() > nc.matches("G53").count(), "{machine}\n{home}");
        assert!(rs274(&nc).is_none_or(|r| r.is_ok()), "{machine}\n{nc}");
    }
}
