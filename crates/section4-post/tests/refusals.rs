//! Where the post-processor must refuse, it names the statement and the cure.
#![expect(clippy::unwrap_used, reason = "test code")]

mod common;

use aptc_diagnostics::{FileId, Span};

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
fn an_arc_behind_a_refused_cut_has_its_start() {
    let ready = "UNITS/MM\nLOADTL/1\nSPINDL/100\nCOOLNT/ON\n";
    let arc = "MOVARC/0,0,0,0,0,1,5,ANGLE,90\nGOTO/0,5,0\nFINI";
    let text = format!("{ready}GOTO/5,0,0\n{arc}");
    assert_eq!(errors("linuxcnc-mill", &text), ["APT4001"]);
    let text = format!("{ready}FEDRAT/100\nGOTO/5,0,0,0,1,0\n{arc}");
    assert_eq!(errors("linuxcnc-mill", &text), ["APT4004"]);
}

#[test]
fn compensation_without_an_offset_says_what_is_missing() {
    let text = "UNITS/MM\nSPINDL/100\nCOOLNT/ON\nFEDRAT/100\nGOTO/5,0,0\nCUTCOM/LEFT\nGOTO/6,0,0";
    let (_, posted) = post("linuxcnc-mill", text);
    let error = posted.diagnostics.iter().find(|d| d.is_error()).unwrap();
    assert_eq!(error.code.to_string(), "APT4007");
    assert!(error.message.contains("no tool is loaded"), "{}", error.message);
}

/// The cycle lacks its clearance, not each of its holes; a plane that lies above some of them is told at each other.
#[test]
fn a_cycle_without_clearance_is_told_once() {
    let told = |text: &str| {
        let mut list = common::records(text);
        for (record, i) in list.iter_mut().zip(0..) {
            record.origin.span = Span::new(FileId(0), i, i + 1);
        }
        let mill = aptc_post::machine("linuxcnc-mill").unwrap();
        let posted = aptc_post::post_all(mill, Default::default(), &list).1;
        let errors = posted.diagnostics.iter().filter(|d| d.is_error());
        errors.map(|d| d.code.number()).collect::<Vec<_>>()
    };
    let ready = "UNITS/MM\nLOADTL/1\nSPINDL/100\nCOOLNT/ON\nFEDRAT/10\nRAPID\nGOTO/0,0,50\n";
    let holes = "CYCLE/DRILL,DEPTH,5\nGOTO/0,0,0\nGOTO/9,0,0\nGOTO/18,0,0\nCYCLE/OFF\n";
    assert_eq!(told(&format!("{ready}{holes}FINI")), [4005]);
    assert_eq!(told(&format!("{ready}{holes}{holes}FINI")), [4005; 2]);
    assert_eq!(told(&format!("{ready}CLRSRF/-1\n{holes}FINI")), [4005; 3]);
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
        ("SPINDL/100,CLW,CCLW", "APT4007"),
        ("FEDRAT/10,IPM,MMPM", "APT4007"),
        ("FEDRAT/0", "APT4007"),
        ("FEDRAT/LOTS", "APT4007"),
        ("HEAD/2", "APT4006"),
        ("LOADTL/1.5", "APT4007"),
        ("CLRSRF/NOW", "APT4007"),
        ("GOTO/1E14,0,0", "APT4009"),
        ("END\nGOTO/1,1,1", "APT4010"),
        ("GOTO/1,1,1,1,0,0", "APT4004"),
        ("CUTCOM/LEFT,1\nGOTO/1,1,1\nLOADTL/2", "APT4015"),
        ("CUTCOM/LEFT,1,PERPTO", "APT4006"),
        ("LINTOL/LINEAR,1", "APT4006"),
        ("LINTOL/-1", "APT4007"),
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
fn what_follows_end_is_left_out_and_told_once() {
    let ready = "LOADTL/1\nSPINDL/100\nCOOLNT/ON\nFEDRAT/10\nCLRSRF/5\nGOTO/0,0,1\n";
    let late = "SPINDL/OFF\nSTOP\nDELAY/2\nINSERT M99\nPPRINT LATE";
    for machine in ["linuxcnc-mill", "haas-vf", "heidenhain-tnc"] {
        let (early, posted) = post(machine, &format!("{ready}END\nFINI"));
        assert!(posted.diagnostics.is_empty());
        let (code, posted) = post(machine, &format!("{ready}END\n{late}\nFINI"));
        assert_eq!(code, early, "{machine}");
        let said: Vec<_> = posted.diagnostics.iter().map(|d| &*d.message).collect();
        assert_eq!(said, ["SPINDL/OFF after END, which ends the machine's program"]);
        for motion in ["CLRSRF/NOW", "GOHOME", "LOADTL/2", "GOTO/1,1,1\nGOTO/2,1,1"] {
            let text = format!("{ready}END\n{motion}\nFINI");
            assert_eq!(errors(machine, &text), ["APT4010"], "{machine}: {motion}");
        }
    }
}

#[test]
fn a_tool_axis_that_a_mill_cannot_take_is_told_once() {
    let text = "LOADTL/1\nSPINDL/100\nCOOLNT/ON\nFEDRAT/10\nGOTO/0,0,1\nGOTO/1,1,1,1,0,0\nGOTO/1,1,2,0,1,0\nFINI";
    assert_eq!(errors("linuxcnc-mill", text), ["APT4004"]);
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

/// The mill with limits of X, metric.
fn limited() -> aptc_post::Machine {
    let text = include_str!("../machines/linuxcnc-mill.toml");
    aptc_post::Machine::parse(&format!("{text}\n[axes.X]\nmin = -10.0\nmax = 20.0\n")).unwrap()
}

const READY: &str = "UNITS/MM\nCUTTER/10\nLOADTL/1\nSPINDL/100,CLW\nCOOLNT/ON\nFEDRAT/100\n";

#[test]
fn an_arc_that_bulges_beyond_a_limit_is_refused_though_its_ends_are_within() {
    let post = |radius: f64| {
        // A half turn from X0 to X0 around 0,0: it goes out to X = radius.
        let text = format!(
            "{READY}GOTO/0,-{radius},0\nARC/0,0,0,0,0,1,{radius},180\nGOTO/0,{radius},0\nFINI"
        );
        aptc_post::post_all(&limited(), Default::default(), &common::records(&text)).1
    };
    assert!(!post(19.9).diagnostics.iter().any(|d| d.is_error()));
    let refused = post(20.1);
    let list: Vec<_> = refused.diagnostics.iter().filter(|d| d.is_error()).collect();
    assert_eq!(list.len(), 1, "{list:?}");
    assert!(list[0].message.starts_with("X20.1 is beyond the limit X20"), "{}", list[0].message);
}

#[test]
fn the_summary_has_the_bulge_of_arcs_and_the_bottom_of_holes() {
    let text = format!(
        "{READY}GOTO/0,-15,0\nARC/0,0,0,0,0,1,15,180\nGOTO/0,15,0\nCYCLE/DRILL,DEPTH,7,MMPM,50,CLEAR,2\nGOTO/0,15,0\nCYCLE/OFF\nFINI"
    );
    let posted = aptc_post::post_all(&limited(), Default::default(), &common::records(&text)).1;
    assert!(!posted.diagnostics.iter().any(|d| d.is_error()));
    let s = &posted.summary;
    let extent = s.extent.unwrap();
    assert!((extent.max[0] - 15.0).abs() < 1e-9, "{extent:?}");
    let axis = |letter| s.axes.iter().find(|a| a.letter == letter).unwrap();
    assert!((axis('X').max - 15.0).abs() < 1e-9);
    assert_eq!(axis('X').limits, [Some(-10.0), Some(20.0)]);
    assert!((axis('Z').min + 7.0).abs() < 1e-9);
}

const BLOCK: &str = "UNITS/MM\nSTOCK/0,0,-20,100,60,0\nCUTTER/10\nLOADTL/1\nSPINDL/100,CLW\nCOOLNT/ON\nFEDRAT/100\nFROM/-20,30,10\n";

#[test]
fn a_rapid_through_the_stock_is_refused_with_place_and_depth() {
    let text = format!("{BLOCK}RAPID\nGOTO/-20,30,-3\nRAPID\nGOTO/120,30,-3\nFINI");
    let (_, posted) = post("linuxcnc-mill", &text);
    let list: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
    assert_eq!(list.len(), 1, "{list:?}");
    assert_eq!(list[0].code.to_string(), "APT4024");
    assert!(list[0].message.contains("3 deep at"), "{}", list[0].message);
}

/// What a rapid motion has gone through is gone: the way out of it is no mistake of its own.
#[test]
fn the_way_back_from_a_rapid_into_the_stock_is_told_with_it() {
    let text =
        format!("{BLOCK}RAPID\nGOTO/50,30,10\nRAPID\nGOTO/50,30,-3\nRAPID\nGOTO/50,30,10\nFINI");
    assert_eq!(errors("linuxcnc-mill", &text), ["APT4024"]);
    let aside = text.replace("RAPID\nGOTO/50,30,10\nFINI", "RAPID\nGOTO/90,30,-3\nFINI");
    assert_eq!(errors("linuxcnc-mill", &aside), ["APT4024"; 2]);
}

#[test]
fn a_rapid_through_what_was_cut_away_is_free() {
    // A slot, an arc and a hole; each is left the way it was cut.
    for machine in ["linuxcnc-mill", "grbl"] {
        for way in WAYS {
            let text = format!("{BLOCK}RAPID\nGOTO/-20,30,10\n{way}\nFINI");
            good(machine, &text.replace("COOLNT/ON", "COOLNT/FLOOD"));
        }
    }
}

/// GRBL has no cycles: there each peck is a motion of its own.
const WAYS: &[&str] = &[
    "GOTO/-20,30,-3\nGOTO/120,30,-3\nRAPID\nGOTO/-20,30,-3",
    "GOTO/50,30,-5\nRAPID\nGOTO/50,30,20",
    "GOTO/30,30,5\nGOTO/30,30,-4\nCHORDS/50,30,0,0,0,1,20\nGOTO/50,10,-4;70,30,-4\nRAPID\nGOTO/70,30,9",
    "CYCLE/DRILL,DEPTH,15,MMPM,50,CLEAR,2\nGOTO/20,20,0\nGOTO/80,20,0\nCYCLE/OFF\nRAPID\nGOTO/80,20,-15\nRAPID\nGOTO/80,20,5",
    "CYCLE/DEEP,DEPTH,15,STEP,4,MMPM,50,CLEAR,2\nGOTO/20,20,0\nGOTO/80,20,0\nCYCLE/OFF\nRAPID\nGOTO/80,20,20",
];

#[test]
fn between_holes_the_tool_goes_above_the_stock() {
    let text = format!(
        "{BLOCK}RAPID\nGOTO/-20,30,10\nCYCLE/DRILL,DEPTH,5,MMPM,50,CLEAR,2\nGOTO/-15,20,-8\nGOTO/30,20,-8\nCYCLE/OFF\nFINI"
    );
    for machine in ["linuxcnc-mill", "fanuc-0i-mill", "grbl"] {
        let text = text.replace("COOLNT/ON", "COOLNT/FLOOD");
        assert_eq!(errors(machine, &text), ["APT4024"], "{machine}");
    }
}

#[test]
fn a_dog_leg_goes_through_stock_where_the_straight_line_does_not() {
    // Up and across at once from a corner: a control that moves Z first is free, one that moves it last is not.
    let down = format!("{BLOCK}RAPID\nGOTO/-20,30,10\nRAPID\nGOTO/120,30,-5\nFINI");
    assert_eq!(errors("linuxcnc-mill", &down), ["APT4024"]);
    assert!(errors("fanuc-0i-mill", &down).is_empty(), "across first, then down beside the block");
}

#[test]
fn a_tool_that_leans_ends_the_check_with_a_warning() {
    let text = format!("{BLOCK}MULTAX\nGOTO/-20,30,10,.6,0,.8\nRAPID\nGOTO/50,30,-5,.6,0,.8\nFINI");
    let (_, posted) = post("linuxcnc-5axis", &text);
    let told: Vec<_> = posted.diagnostics.iter().map(|d| d.code.to_string()).collect();
    assert_eq!(told.iter().filter(|c| *c == "APT4025").count(), 1, "{told:?}");
}

#[test]
fn the_machine_file_of_the_book_is_whole() {
    let page = include_str!("../../../docs/machines.md");
    let text = page.split("```toml\n").nth(1).unwrap().split("```").next().unwrap();
    let machine = aptc_post::Machine::parse(text).unwrap();
    assert_eq!(machine.name, "our-mill");
}

/// Words with modifiers that a machine does not have: each is refused or told of by name, never a block that the
/// control would not take.
#[test]
fn every_modifier_is_done_refused_or_told_of() {
    let lathe = |m: &str| m.contains("lathe");
    for (machine, word, code, text) in [
        ("heidenhain-tnc", "PREFUN/64", "APT4006", "no G words"),
        ("heidenhain-tnc", "OPSKIP/ON", "APT4006", "skips no blocks"),
        ("heidenhain-tnc", "CUTCOM/LEFT,ZXPLAN,3", "APT4006", "across the tool axis"),
        ("linuxcnc-mill", "OPSKIP/ON,2", "APT4006", "one switch"),
        ("linuxcnc-mill", "RETRCT/PAST,ZAXIS,80", "APT4006", "RETRCT"),
        ("linuxcnc-mill", "TOOLNO/ADJUST,7", "APT4006", "LOADTL/n,ADJUST,h"),
        ("linuxcnc-mill", "FEDRAT/IPR,.01,SCALE,2", "APT4007", "FEDRAT"),
        ("linuxcnc-mill", "LOADTL/7,MANUAL", "APT4013", "MANUAL has no effect"),
        ("linuxcnc-mill", "LOADTL/7,80", "APT4013", "80 has no effect"),
        ("linuxcnc-mill", "LOADTL/7,OFFSET,17,18", "APT4013", "18 has no effect"),
        ("linuxcnc-mill", "SEQNO/100,INCR,5,3", "APT4013", "every block"),
        ("haas-vf", "COOLNT/THRU,HIGH", "APT4013", "pressures"),
        ("linuxcnc-mill", "FEDRAT/IPR,.01,MAXIPM,20", "APT4013", "MAXIPM"),
        ("linuxcnc-lathe", "TURRET/3,10,20", "APT4013", "10,20 has no effect"),
        ("linuxcnc-lathe", "TRANS/1,2,3", "APT4026", "Y 2"),
        ("fanuc-0i-lathe", "ORIGIN/1,2,3", "APT4026", "Y -2"),
    ] {
        let y = if lathe(machine) { 0 } else { 5 };
        let program = format!(
            "UNITS/MM\nLOADTL/1\nCUTTER/10\nSPINDL/1000,CLW\nCOOLNT/ON\nFEDRAT/500,MMPM\nFROM/0,0,100\n{word}\n\
             SPINDL/1000,CLW\nGOTO/10,{y},5\nGOTO/20,{y},4\nFINI"
        );
        let (nc, posted) = post(machine, &program);
        let said: Vec<_> =
            posted.diagnostics.iter().filter(|d| d.code.to_string() == code).collect();
        let named = said
            .iter()
            .any(|d| d.message.contains(text) || d.help.iter().any(|h| h.contains(text)));
        assert!(named, "{machine} {word}: {:#?}\n{nc}", posted.diagnostics);
        let ours = posted.diagnostics.iter().any(|d| d.code.to_string() == "APT5401");
        assert!(!ours, "{machine} {word}: {:#?}\n{nc}", posted.diagnostics);
    }
}

#[test]
fn words_that_were_misread_are_done() {
    let part = |word: &str| {
        format!(
            "UNITS/MM\nLOADTL/1\nCUTTER/10\nSPINDL/1000,CLW\nCOOLNT/ON\nFEDRAT/500,MMPM\nFROM/0,0,100\n{word}\n\
             SPINDL/1000,CLW\nGOTO/10,5,5\nGOTO/20,5,4\nFINI"
        )
    };
    // By places: number, magazine, length, offset.
    assert!(good("linuxcnc-mill", &part("LOADTL/7,1,80,17")).contains("G43 H17"));
    assert!(good("siemens-840d-mill", &part("SPINDL/ORIENT,45")).contains("SPOS=45"));
    // A hole of no depth: the cycles of these controls would do nothing.
    for machine in ["heidenhain-tnc", "siemens-840d-mill"] {
        let nc =
            good(machine, &part("CYCLE/DRILL,FEDTO,0,MMPM,250,RAPTO,3\nGOTO/7,7,1\nCYCLE/OFF"));
        assert!(nc.contains("Z1") || nc.contains("Z+1"), "{machine}\n{nc}");
    }
    // How NX and ISO 4343 say what kind of drilling it is, and lists of pecks.
    for (cycle, native) in [
        (
            "CYCLE/DRILL,DEEP,STEP,2,2,2,RAPTO,3,FEDTO,-12,RTRCTO,AUTO,MMPM,100",
            "G83 X7 Y7 Z-11 R4 Q2",
        ),
        (
            "CYCLE/DRILL,DEEP,STEP,20,CLEAR,3,FEDTO,-72,RTRCTO,AUTO,MMPM,250",
            "G83 X7 Y7 Z-71 R4 Q20",
        ),
        ("CYCLE/DRILL,BRKCHP,STEP,2,0,0,RAPTO,3,FEDTO,-12,MMPM,100", "G73 X7 Y7 Z-11 R4 Q2"),
        ("CYCLE/DRILL,CSINK,30,RAPTO,3,FEDTO,-3,MMPM,50", "G82 X7 Y7 Z-2 R4"),
        ("CYCLE/DEEP,DEPTH,12,STEP,2,MMPM,100,CLEAR,3", "G83 X7 Y7 Z-11 R4 Q2"),
    ] {
        let nc = good("linuxcnc-mill", &part(&format!("{cycle}\nGOTO/7,7,1\nCYCLE/OFF")));
        assert!(nc.contains(native), "{cycle}: {native}\n{nc}");
    }
    let (_, posted) = post(
        "linuxcnc-mill",
        &part("CYCLE/DRILL,DEEP,STEP,5,3,2,RAPTO,3,FEDTO,-12,MMPM,100\nGOTO/7,7,1\nCYCLE/OFF"),
    );
    assert!(posted.diagnostics.iter().any(|d| d.message.contains("more than two lengths")));
    // What comes of a surface speed is bounded: 300 feet a minute at 10 mm would be 2911.
    assert!(
        good("linuxcnc-mill", &part("SPINDL/SFM,300,CLW,MAXRPM,2000\nGOTO/9,9,9"))
            .contains("S2000")
    );
    assert!(good("fanuc-0i-mill", &part("COOLNT/FLOOD\nCOOLNT/OFF")).contains("M9"));
    // Numbers of blocks leave the ends of the tape and the number of the program alone.
    for machine in ["fanuc-0i-mill", "haas-vf"] {
        let nc = good(machine, &part("SEQNO/100,INCR,5"));
        assert!(nc.trim_end().ends_with("\n%") && nc.contains("\nN100 "), "{machine}\n{nc}");
    }
}

/// One CUTCOM/OFF is missing: one message, not one for each hole and one for the end.
#[test]
fn compensation_that_is_never_ended_is_told_once() {
    let head = "UNITS/MM\nCUTTER/10\nLOADTL/1\nSPINDL/100,CLW\nCOOLNT/ON\nFEDRAT/100\nFROM/0,0,9\nCUTCOM/LEFT\nGOTO/10,0,9\n";
    let holes = "CYCLE/DRILL,DEPTH,5,MMPM,50,CLEAR,2\nGOTO/20,20,0\nGOTO/30,20,0\nCYCLE/OFF\nFINI";
    for rest in [holes, "LOADTL/2\nLOADTL/3\nFINI", "FINI"] {
        assert_eq!(errors("haas-vf", &format!("{head}{rest}")), ["APT4015"], "{rest}");
    }
}

#[test]
fn a_feed_that_is_so_small_a_minute_is_doubted_once() {
    let told = |machine: &str, text: &str| {
        let (_, posted) = post(machine, text);
        let said = posted.diagnostics.iter().map(|d| d.code.to_string());
        said.filter(|code| code == "APT4032").count()
    };
    let lathe = "UNITS/MM\nTURRET/1\nSPINDL/500,CLW\nCOOLNT/ON\nFEDRAT/.2\nFROM/30,0,9\nGOTO/20,0,9\nFEDRAT/.3\nGOTO/20,0,0\nFINI";
    assert_eq!(told("linuxcnc-lathe", lathe), 1);
    assert_eq!(
        told(
            "linuxcnc-lathe",
            &lathe.replace("FEDRAT/.2", "FEDRAT/.2,MMPM").replace(".3", ".3,MMPR")
        ),
        0
    );
    assert_eq!(told("linuxcnc-lathe", &lathe.replace("FEDRAT/.", "FEDRAT/12.")), 0);
    assert_eq!(told("linuxcnc-mill", &lathe.replace("TURRET", "LOADTL")), 1);
    assert_eq!(
        told("linuxcnc-mill", &lathe.replace("TURRET", "LOADTL").replace("FEDRAT/.", "FEDRAT/2.")),
        0
    );
}
