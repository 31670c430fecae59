//! Where the post-processor must refuse, it names the statement and the cure.

mod common;

use common::{errors, good, post};

#[test]
fn no_feed_is_said_once_and_names_the_cure() {
    let (_, posted) =
        post("linuxcnc-mill", "LOADTL/1\nSPINDL/100\nCOOLNT/ON\nGOTO/1,1,1\nGOTO/2,1,1\nFINI");
    let list: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
    assert_eq!(list.len(), 1);
    assert_eq!(list[0].code.to_string(), "APT4001");
    assert!(list[0].help.as_deref().unwrap().contains("FEDRAT"));
}

#[test]
fn each_refusal_has_its_code() {
    for (statement, code) in [
        ("CYCLE/DRILL", "APT4005"),
        ("CYCLE/DRILL,5,IPM,3\nGOTO/0,0,0", "APT4005"),
        ("CYCLE/DEEP,DEPTH,5,CLEAR,1\nGOTO/0,0,0", "APT4005"),
        ("COOLNT/THRU", "APT4006"),
        ("COOLNT/5", "APT4007"),
        ("SPINDL/SFM,100", "APT4007"),
        ("SPINDL/0", "APT4008"),
        ("FEDRAT/0", "APT4007"),
        ("FEDRAT/LOTS", "APT4007"),
        ("HEAD/2", "APT4006"),
        ("LOADTL/1.5", "APT4007"),
        ("CLRSRF/NOW", "APT4007"),
        ("GOTO/1E14,0,0", "APT4009"),
        ("END\nGOTO/1,1,1", "APT4010"),
        ("GOTO/1,1,1,1,0,0", "APT4004"),
        ("CUTCOM/LEFT,1\nGOTO/1,1,1\nLOADTL/2", "APT4015"),
    ] {
        let text = format!("LOADTL/1\nSPINDL/100\nCOOLNT/ON\nFEDRAT/10\nGOTO/0,0,1\n{statement}");
        assert_eq!(
            errors("linuxcnc-mill", &text).first().map(String::as_str),
            Some(code),
            "{statement}"
        );
    }
}

#[test]
fn default_feed_of_a_machine_warns() {
    let text = include_str!("../machines/linuxcnc-mill.toml");
    let text = format!("default_feed = 150\n{text}");
    let machine = aptc_post::Machine::parse(&text).unwrap();
    let records = common::records("UNITS/MM\nLOADTL/1\nGOTO/1,1,1\nFINI");
    let (nc, posted) = aptc_post::post_all(&machine, aptc_post::PostOptions::default(), &records);
    assert!(nc.contains("F150"), "{nc}");
    assert!(posted.diagnostics.iter().any(|d| d.code.to_string() == "APT4012" && !d.is_error()));
}

#[test]
fn machine_files_are_checked_by_name() {
    for (text, says) in [
        ("name = 'x'\ntitle = 'y'\nformat = {}\nspindel = 1", "spindel"),
        ("name = 'x'\ntitle = 'y'\nformat = {}", "lacks X"),
        ("name = ", "machine file"),
    ] {
        let list = aptc_post::Machine::parse(text).unwrap_err();
        assert!(list[0].message.contains(says), "{:?}", list[0].message);
        assert_eq!(list[0].code.to_string(), "APT4002");
    }
}

#[test]
fn no_number_has_a_minus_zero_or_an_exponent() {
    let nc = good(
        "linuxcnc-mill",
        "LOADTL/1\nSPINDL/100\nCOOLNT/ON\nFEDRAT/10\nGOTO/-.0000001,1E-7,1\nGOTO/123456789.125,-1E-9,0\nFINI",
    );
    assert!(!nc.contains("-0\n") && !nc.contains("-0 ") && nc.contains("X123456789.125"), "{nc}");
}
