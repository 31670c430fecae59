//! What the CL files of CAM systems say in ways of their own.

use aptc_cldata::{Reader, Record, RecordReader};
use aptc_post::{PostOptions, Posted, machine, post_all};

const HEAD: &str =
    "UNITS/MM\nCUTTER/6\nLOADTL/1\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\nFROM/0,0,100\n";

/// The text and findings for a machine, as the file is read.
fn post(name: &str, text: &str) -> (String, Posted) {
    let mut reader = Reader::open(text.as_bytes(), None).expect("text");
    let (mut records, mut record) = (Vec::new(), Record::default());
    while reader.read(&mut record).expect("text") {
        records.push(record.clone());
    }
    assert!(!reader.into_diagnostics().iter().any(aptc_diagnostics::Diagnostic::is_error));
    post_all(machine(name).expect("built in"), PostOptions::default(), &records)
}

/// The text; no errors allowed.
fn good(name: &str, text: &str) -> String {
    let (nc, posted) = post(name, text);
    let errors: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
    assert!(errors.is_empty(), "{errors:#?}\n{nc}");
    nc
}

fn said(posted: &Posted, code: &str) -> Vec<String> {
    let of = |d: &&aptc_diagnostics::Diagnostic| d.code.to_string() == code;
    posted.diagnostics.iter().filter(of).map(|d| d.message.to_string()).collect()
}

#[test]
fn a_cycle_comes_back_with_another_depth() {
    let text = format!(
        "{HEAD}RAPID\nGOTO/0,0,20\nCYCLE/DRILL,DEEP,STEP,4,CLEAR,2,FEDTO,-9,RTRCTO,AUTO,MMPM,80\n\
         GOTO/10,0,0\nCYCLE/ON,FEDTO,-11,RTRCTO,AUTO\nGOTO/20,0,0\nCYCLE/OFF\nCYCLE/ON\nGOTO/30,0,0\n\
         CYCLE/OFF\nFINI"
    );
    for name in ["linuxcnc-mill", "haas-vf", "siemens-840d-mill", "heidenhain-tnc"] {
        let nc = good(name, &text);
        let holes: Vec<&str> = nc
            .lines()
            .filter(|l| ["G83", "CYCLE83(", "Q201"].iter().any(|w| l.contains(w)))
            .collect();
        let depths: Vec<bool> = holes.iter().map(|l| l.contains("-11")).collect();
        assert!(depths.first() == Some(&false) && depths.contains(&true), "{name}: {holes:?}");
        assert!(holes[0].contains("-9"), "{name}: {holes:?}");
        // The last depth holds, for the third hole too.
        assert!(holes[1..].iter().all(|l| l.contains("-11")), "{name}: {holes:?}");
        // Heidenhain gives each number a sign.
        let nc = nc.replace("X+", "X");
        let later = nc.split_once("X20").expect("the second hole").1;
        assert!(later.contains("X30") && !later.contains("-9"), "{name}\n{nc}");
    }
    let (_, posted) = post("haas-vf", &text.replace("CYCLE/ON,FEDTO,-11", "CYCLE/ON,WIDTH,-11"));
    assert_eq!(said(&posted, "APT4006").len(), 1);
}

#[test]
fn a_tap_has_its_pitch_for_a_feed() {
    let text = format!(
        "{HEAD}GOTO/0,0,20\nCYCLE/RIGID, DEPTH, 8, PITCH, 1.25, CLEAR, 12, RETURN, 12, RAPTO, 4\n\
         GOTO/10,0,0\nCYCLE/OFF\nFINI"
    );
    let same = text.replace("RIGID", "TAP").replace("PITCH, 1.25", "MMPR, 1.25");
    for name in ["fanuc-0i-mill", "siemens-840d-mill", "linuxcnc-mill"] {
        assert_eq!(good(name, &text), good(name, &same));
    }
    let nc = good("fanuc-0i-mill", &text);
    assert!(nc.contains("G84 X10. Y0. Z-8. R4."), "{nc}");
}

#[test]
fn a_tool_named_again_is_not_changed_again() {
    let text = HEAD.replace("LOADTL/1", "LOADTL/1\nLOADTL/1,ADJUST,7");
    let nc = good("fanuc-0i-mill", &format!("{text}GOTO/1,2,3\nLOADTL/1\nGOTO/4,5,6\nFINI"));
    assert_eq!(nc.matches("M6").count(), 2, "{nc}");
    assert!(nc.contains("G43 H7") && nc.contains("G43 H1 "), "{nc}");
}

#[test]
fn tools_that_share_an_offset_are_told() {
    let cut = "SPINDL/3000,CLW\nGOTO/1,2,3\n";
    let text = format!("{HEAD}GOTO/0,0,3\nLOADTL/8,ADJUST,1\n{cut}FINI");
    for (name, n) in [("fanuc-0i-mill", 1), ("siemens-840d-mill", 0)] {
        let (_, posted) = post(name, &text);
        let said = said(&posted, "APT4031");
        assert_eq!(said.len(), n, "{name}: {said:?}");
        assert!(said.iter().all(|m| m.contains("offset 1 is that of tool 1 too")), "{said:?}");
    }
    let own = format!("{HEAD}GOTO/0,0,3\nLOADTL/8\n{cut}LOADTL/1\n{cut}FINI");
    assert!(said(&post("fanuc-0i-mill", &own).1, "APT4031").is_empty());
}

#[test]
fn another_coordinate_system_is_told() {
    let same = "CSYS/1,0,0,5,0,1,0,6,0,0,1,7\n";
    let text = format!("{same}{HEAD}GOTO/0,0,3\n{same}GOTO/1,0,3\n");
    assert!(said(&post("haas-vf", &format!("{text}FINI")).1, "APT4030").is_empty());
    let turned = "CSYS/0,-1,0,5,1,0,0,6,0,0,1,57\n";
    let (_, posted) =
        post("haas-vf", &format!("{text}{turned}GOTO/2,0,3\n{turned}GOTO/3,0,3\nFINI"));
    let said = said(&posted, "APT4030");
    assert_eq!(said.len(), 1);
    assert!(said[0].contains("0,0,50") && said[0].contains("90 degrees"), "{said:?}");
}

#[test]
fn compensation_is_switched_on_with_its_side() {
    let path = "GOTO/0,0,3\nGOTO/5,0,3\nGOTO/5,5,3\nCUTCOM/OFF\nGOTO/0,5,3\nFINI";
    let nc = good("haas-vf", &format!("{HEAD}CUTCOM/ON,RIGHT,4\n{path}"));
    assert!(nc.contains("G42 D4"), "{nc}");
}

#[test]
fn words_of_cam_systems_that_say_nothing_to_the_machine() {
    let path = "GOTO/0,0,3\nGOTO/5,0,3\nGOTO/5,5,3\nCUTCOM/OFF\nGOTO/0,5,3\nFINI";
    let text = format!("{HEAD}CHANNEL,1\nOFSTNO/FIXTUR,1\nCUTCOM/ON\nCUTCOM/LEFT,OSETNO,1\n{path}");
    let (nc, posted) = post("haas-vf", &text);
    assert!(nc.contains("G41 D1"), "{nc}");
    assert!(said(&posted, "APT4014").is_empty() && said(&posted, "APT4015").is_empty());
    assert_eq!(said(&posted, "APT4013").len(), 2);
    let (_, posted) = post("haas-vf", &text.replace("CUTCOM/LEFT", "$$ CUTCOM/LEFT"));
    assert_eq!(said(&posted, "APT4015").len(), 1);
    let (_, posted) = post("haas-vf", &text.replace("FIXTUR,1", "FIXTUR,2"));
    assert_eq!(said(&posted, "APT4006").len(), 1);
}

#[test]
fn a_call_of_a_subprogram_that_is_not_there_is_an_error() {
    let (_, posted) = post("haas-vf", &format!("{HEAD}GOTO/0,0,3\nCALSUB/ABC\nFINI"));
    let said = said(&posted, "APT3108");
    assert!(said.len() == 1 && said[0].contains("CALSUB/ABC"), "{said:?}");
    assert!(posted.diagnostics.iter().any(|d| d.is_error()));
}

/// Fusion goes on from each hole at rapid to where the cycle left the tool, and may end there.
#[test]
fn a_rapid_motion_to_where_the_cycle_ended() {
    let text = "MODE/MILL\nPARTNO/'1'\nUNITS/MM\nCUTTER/5., 0., 0., 0., 0., 59., 30.\nLOADTL/2, 0, 50., 2\n\
                SPINDL/3000., RPM, CLW\nCOOLNT/ON\nRAPID\nGOTO/10., 10., 15.\n\
                CYCLE/DRILL, 12., MMPM, 200., 15., RAPTO, 10.\nFEDRAT/200., MMPM\nGOTO/30., 10., -12.\n\
                CYCLE/OFF\nRAPID\nGOTO/30., 10., 15.\nEND\nFINI";
    for name in
        ["haas-vf", "siemens-840d-mill", "heidenhain-tnc", "linuxcnc-mill", "fanuc-31i-5axis"]
    {
        let nc = good(name, text);
        assert!(!nc.contains("-24"), "{name}: as deep again\n{nc}");
    }
    assert!(good("haas-vf", text).contains("G98 G81 X30. Y10. Z-12. R5. F200."));
}

#[test]
fn a_turret_is_loaded_and_a_retract_names_its_axis() {
    let text = "UNITS/MM\nCUTTER/.8\nLOAD/TURRET,3,ADJUST,3\nSELECT/TURRET\nSPINDL/600,CLW\nCOOLNT/ON\n\
                FEDRAT/.2,MMPR\nGOTO/30,0,5\nGOTO/15,0,5\nFINI";
    assert!(good("fanuc-0i-lathe", text).contains("T0303"));
    let text = format!("{HEAD}OPNAME 'x'\nGOTO/0,0,3\nRETRCT/ZAXIS\nGOTO/9,0,3\nFINI");
    assert_eq!(good("haas-vf", &text), good("haas-vf", &text.replace("/ZAXIS", "")));
}

#[test]
fn a_tap_that_is_refused_says_why() {
    let text = format!(
        "{HEAD}MULTAX/ON\nGOTO/0,0,20,0,0,1\nCYCLE/TAP,DEPTH,8,MMPM,300,CLEAR,3,DWELL,1\n\
         GOTO/10,0,0,0,0,1\nCYCLE/OFF\nFINI"
    );
    let (_, posted) = post("fanuc-31i-5axis", &text);
    assert!(said(&posted, "APT4006")[0].ends_with("CYCLE/TAP with DWELL"));
    let (_, posted) = post("fanuc-31i-5axis", &text.replace("0,0,0,0,1", "0,0,.6,0,.8"));
    assert!(said(&posted, "APT4006")[0].contains("CYCLE/TAP while the tool leans"));
}

#[test]
fn turns_at_constant_surface_speed_are_those_where_the_tool_is() {
    let text = "UNITS/MM\nCUTTER/.8\nLOADTL/1\nSPINDL/60,SMM,CLW,MAXRPM,3000\nCOOLNT/ON\n\
                FEDRAT/.2,MMPR\nGOTO/30,0,5\nGOTO/15,0,5\nDELAY/REV,10\nGOTO/30,0,5\nFINI";
    // 60 m a minute at a diameter of 30 mm are 636.6 turns a minute.
    assert!(good("linuxcnc-lathe", text).contains("G4 P0.942"), "{}", good("linuxcnc-lathe", text));
}

#[test]
fn heights_of_a_cycle_that_comes_back() {
    let text = format!(
        "{HEAD}GOTO/0,0,30\nCYCLE/DRILL,DEPTH,9,CLEAR,20,RAPTO,4,MMPM,80\nGOTO/10,0,0\n\
         CYCLE/ON,CLEAR,25\nGOTO/20,0,0\nCYCLE/OFF\nFINI"
    );
    let whole = text.replace("CYCLE/ON,CLEAR,25", "CYCLE/DRILL,DEPTH,9,CLEAR,25,RAPTO,4,MMPM,80");
    for name in ["haas-vf", "siemens-840d-mill", "heidenhain-tnc", "linuxcnc-mill"] {
        assert_eq!(good(name, &text), good(name, &whole), "{name}");
    }
    // A retract below where the feed begins, at once or by what came before.
    let low = text.replace("RAPTO,4", "RTRCTO,21").replace("CYCLE/ON", "CYCLE/ON,RTRCTO,3");
    let (_, posted) = post("haas-vf", &low);
    assert_eq!(said(&posted, "APT4005").len(), 1);
    let (_, posted) = post("haas-vf", &text.replace("RAPTO,4", "RTRCTO,21"));
    assert!(said(&posted, "APT4005")[0].contains("ends at 21, below its clearance of 25"));
}

/// Holes under a refused cycle are not drilled as the one before.
#[test]
fn a_refused_cycle_ends_the_one_before() {
    let text = format!(
        "{HEAD}GOTO/0,0,30\nCYCLE/DRILL,DEPTH,9,CLEAR,2,MMPM,80\nGOTO/10,0,0\n\
         CYCLE/DRILL,DEPTH,5,CLEAR,2,WIDTH,3\nGOTO/20,0,0\nCYCLE/OFF\nFINI"
    );
    let (nc, posted) = post("haas-vf", &text);
    assert_eq!(said(&posted, "APT4006").len(), 1);
    let after = nc.split_once("G81").expect("the first hole").1;
    assert!(after.split_once("X20").expect("the second").0.contains("G80"), "{nc}");
    assert!(!after.contains("G81"), "{nc}");
}

#[test]
fn a_pitch_is_that_of_a_tap() {
    let text = "UNITS/INCHES\nCUTTER/.25\nLOADTL/1\nSPINDL/500,CLW\nCOOLNT/ON\nFEDRAT/10\nFROM/0,0,4\n\
                GOTO/0,0,2\nCYCLE/TAP,DEPTH,.5,PITCH,.05,CLEAR,.1\nGOTO/1,0,0\nCYCLE/OFF\nGOTO/2,0,2\nFINI";
    let nc = good("haas-vf", text);
    for feed in ["IPR,.05", "IPM,25", "PERREV,.05", "MMPM,635"] {
        let both = text.replace("PITCH,.05", &format!("PITCH,.05,{feed}"));
        assert_eq!(good("haas-vf", &both), nc, "{feed}");
    }
    for (bad, code, what) in [
        ("PITCH,20", "APT4007", "a pitch of 20 inches"),
        ("PITCH,.05,IPM,20", "APT4007", "not that of the pitch"),
        ("PITCH,.05,IPR,.06", "APT4007", "not that of the pitch"),
    ] {
        let (_, posted) = post("haas-vf", &text.replace("PITCH,.05", bad));
        let said = said(&posted, code);
        assert!(said.len() == 1 && said[0].contains(what), "{bad}: {:?}", posted.diagnostics);
    }
    let (_, posted) = post("haas-vf", &text.replace("CYCLE/TAP", "CYCLE/DRILL"));
    assert!(said(&posted, "APT4006")[0].contains("nothing for PITCH"));
}

#[test]
fn a_frame_named_after_the_first_motion_is_told() {
    let frame =
        |z: u32| format!("{HEAD}GOTO/0,0,3\nCSYS/1,0,0,{z},0,1,0,0,0,0,1,0\nGOTO/1,0,3\nFINI");
    assert!(said(&post("haas-vf", &frame(80)).1, "APT4030")[0].contains("80,0,0"));
    assert!(said(&post("haas-vf", &frame(0)).1, "APT4030").is_empty());
}

#[test]
fn a_second_channel_is_refused() {
    for (n, errors) in [(1, 0), (2, 1), (4, 1)] {
        let (_, posted) = post("haas-vf", &format!("{HEAD}CHANNEL,{n}\nGOTO/0,0,3\nFINI"));
        assert_eq!(said(&posted, "APT4006").len(), errors, "{n}");
    }
}

#[test]
fn a_tool_named_again_keeps_its_comment_to_itself() {
    let text = HEAD.replace(
        "LOADTL/1",
        "TPRINT/T1 END MILL\nLOADTL/1\nTPRINT/T1 END MILL AGAIN\nLOADTL/1,ADJUST,7",
    ) + "GOTO/1,2,3\nLOADTL/2\nSPINDL/3000,CLW\nGOTO/4,5,6\nFINI";
    let nc = good("haas-vf", &text);
    assert!(nc.contains("END MILL") && !nc.contains("AGAIN"), "{nc}");
    // The next tool is made ready, though its number comes second.
    let mut reader = Reader::open(text.as_bytes(), None).expect("text");
    let (mut records, mut record) = (Vec::new(), Record::default());
    while reader.read(&mut record).expect("text") {
        records.push(record.clone());
    }
    let options = PostOptions { tools: vec![1, 1, 2], ..PostOptions::default() };
    let (nc, _) = post_all(machine("haas-vf").expect("built in"), options, &records);
    let before = nc.split_once("T2 M6").or(nc.split_once("T2 M06")).expect("the second tool").0;
    assert!(before.contains("T2"), "{nc}");
}

#[test]
fn what_comes_often_is_told_once_or_thrice_with_a_count() {
    let words =
        "TRNTYP/WORLD,0,0,0\nSETUP/START,1\nCSI_SET_FLUTE_LENGTH/19.\nCSI_TOOL_PATH/DRILL1\n";
    let strange = "HYDRAU/ON\nGOTO/1,2,3\n".repeat(7);
    let (_, posted) = post("haas-vf", &format!("{HEAD}{words}{strange}FINI"));
    let told = said(&posted, "APT4014");
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(
        told[0].starts_with("HYDRAU is not known") && told[0].ends_with(", 7 times"),
        "{told:?}"
    );

    let idle = "CUTCOM/LEFT,1\nCUTCOM/OFF\n".repeat(5);
    let (_, posted) = post("haas-vf", &format!("{HEAD}{idle}GOTO/1,2,3\nFINI"));
    let told = said(&posted, "APT4015");
    assert_eq!(told, ["compensation ends before any motion, 5 times"]);

    let same = "ROTABL/30,AAXIS,TABLE,CLW\nGOTO/1,2,3\n".repeat(9);
    let (_, posted) = post("haas-vf", &format!("{HEAD}{same}FINI"));
    let told = said(&posted, "APT4006");
    assert_eq!(told.len(), 3, "{told:?}");
    assert!(told[2].ends_with(", and 6 times more"), "{told:?}");
}

#[test]
fn what_follows_a_refused_motion_is_not_told() {
    // The tool stands upside down: no motion comes out, so that compensation and arcs have nothing to be wrong about.
    let path = "GOTO/100,0,-5,0,0,-1\nCUTCOM/LEFT,1\nGOTO/95,0,-5,0,0,-1\n\
                CIRCLE/100,0,-5,0,0,-1,5\nGOTO/100,5,-5,0,0,-1\nCUTCOM/OFF\nGOTO/100,0,-5,0,0,-1\n";
    let text = format!("{HEAD}{path}FINI");
    for name in ["haas-vf", "haas-umc", "heidenhain-tnc-5axis", "siemens-840d-5axis"] {
        let (_, posted) = post(name, &text);
        let errors = posted.diagnostics.iter().filter(|d| d.is_error()).count();
        assert_eq!(errors, 1, "{name}: {:#?}", posted.diagnostics);
        for code in ["APT4015", "APT3004"] {
            assert!(said(&posted, code).is_empty(), "{name}: {:?}", said(&posted, code));
        }
    }
}

#[test]
fn correctors_of_catia_are_no_length_of_the_tool() {
    let text = "$$*CATIA0\nPARTNO A\nOP_NAME/Tool Change.1\nTPRINT/T3 Ball D 6\nLOADTL/3,1,1\n\
                SPINDL/3000,RPM,CLW\nCOOLNT/ON\nFEDRAT/500,MMPM\nMULTAX\nGOTO/0,0,50,0,0,1\n\
                GOTO/10,0,0,.6,0,.8\nFINI\n";
    // With a length of 1 the tool would stand elsewhere, and nothing would be said.
    let (_, posted) = post("linuxcnc-5axis-head", text);
    let told = said(&posted, "APT4013");
    assert!(told.iter().any(|m| m == "LOADTL/3,1: 1 has no effect"), "{told:?}");
    let lengths: Vec<_> = posted.summary.tools.iter().map(|t| t.number).collect();
    assert!(lengths.contains(&Some(3)));
    let other = text.replace("LOADTL/3,1,1", "LOADTL/3");
    assert_eq!(post("linuxcnc-5axis-head", text).0, post("linuxcnc-5axis-head", &other).0);

    let table = text.replace("LOADTL/3,1,1", "LOADTL/3,ADJUST,7,SPINDL,3000,MILL");
    let (nc, posted) = post("fanuc-0i-mill", &table.replace(".6,0,.8", "0,0,1"));
    assert!(nc.contains("G43 H7"), "{nc}");
    for code in ["APT4013", "APT4014"] {
        assert!(said(&posted, code).is_empty(), "{:?}", said(&posted, code));
    }
}
