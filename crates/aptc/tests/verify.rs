//! `aptc verify` from outside.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn aptc(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_aptc"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the program starts")
}

fn folder_with(name: &str, content: &str) -> tempfile::TempDir {
    let dir = tempfile::tempdir().expect("a folder");
    fs::write(dir.path().join(name), content).expect("it is written");
    dir
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("it is text")
}

const PART: &str = "PARTNO BOX\nUNITS/MM\nLOADTL/1\nSPINDL/1000,CLW\nFEDRAT/100,MMPM\n\
                    CUTTER/10\nINTOL/.01\nOUTTOL/.01\nL1=LINE/0,0,100,0\n\
                    L2=LINE/60,-100,60,100\nL3=LINE/0,-70,100,-70\nC1=CIRCLE/60,0,20\nFLOOR=PLANE/0,0,1,0\n\
                    FROM/-20,-20,30\nGO/TO,L1,TO,FLOOR\nTLRGT,GORGT/L1,TO,C1\nGORGT/C1,PAST,L2\n\
                    TLLFT,GORGT/L2,PAST,L3\nFINI\n";

#[test]
fn a_cl_file_is_held_against_the_program() {
    let dir = folder_with("box.apt", PART);
    let own = aptc(dir.path(), &["verify", "box.apt"]);
    assert_eq!(own.status.code(), Some(0), "{}{}", text(&own.stdout), text(&own.stderr));
    assert!(text(&own.stdout).contains("proved within tolerance"), "{}", text(&own.stdout));
    aptc(dir.path(), &["compile", "box.apt", "--emit", "cl,cltape", "--quiet"]);
    let cl = fs::read_to_string(dir.path().join("box.cl")).unwrap();
    // The same without the comments that say where each record comes from.
    let bare: String =
        cl.lines().filter(|l| !l.starts_with("$$")).map(|l| format!("{l}\n")).collect();
    fs::write(dir.path().join("bare.cl"), &bare).unwrap();
    for file in ["box.cl", "box.cltape", "bare.cl"] {
        let run = aptc(dir.path(), &["verify", "box.apt", "--cl", file, "--json"]);
        assert_eq!(run.status.code(), Some(0), "{file}: {}", text(&run.stderr));
        let found: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
        let c = &found["programs"][0]["parts"][0]["certificate"];
        assert!(c["proved"].as_u64().unwrap() > 5 && c["unmatched"] == 0, "{file}: {c}");
        for key in ["origin", "method", "surfaces", "fault"] {
            assert!(c["statements"][0].get(key).is_some(), "{key}");
        }
    }
    // A vertex of the arc is left out: its chord cuts in.
    let gotos: Vec<&str> = bare.lines().filter(|l| l.starts_with("GOTO")).collect();
    let arc = gotos[gotos.len() / 2];
    fs::write(dir.path().join("bad.cl"), bare.replace(&format!("{arc}\n"), "")).unwrap();
    let run = aptc(dir.path(), &["verify", "box.apt", "--cl", "bad.cl"]);
    assert_eq!(run.status.code(), Some(3), "{}", text(&run.stderr));
    assert!(text(&run.stderr).contains("APT5001") && text(&run.stderr).contains("C1"));
    // A file of something else.
    fs::write(dir.path().join("other.cl"), "UNITS/MM\nGOTO/1000,1000,1000\nFINI\n").unwrap();
    let run = aptc(dir.path(), &["verify", "box.apt", "--cl", "other.cl"]);
    assert_eq!(run.status.code(), Some(3));
    assert!(text(&run.stderr).contains("APT5003"), "{}", text(&run.stderr));
}

const REGION: &str = "PARTNO CREST\nUNITS/MM\nCUTTER/10,5\nINTOL/.01\nOUTTOL/.01\n\
                      S=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(15,0,3),(30,0,0),$\n\
                      SPLINE,(0,12,1),(15,12,4),(30,12,1),$\nSPLINE,(0,24,0),(15,24,2),(30,24,0)\nUP=VECTOR/0,0,1\nFEDRAT/800\nFROM/0,0,40\n\
                      SCON/DS,S,PARAM,0,2,0,2,AT,UP\nSCON/PS,TO,S,PLUS,0\nSCON/AXIS,UP\n\
                      SCON/FEED,800,800,400,2000\nSCON/STEPOV,.05,4,0,0\n\
                      SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS\nFINI\n";

/// The passes of a region are records of their own where the feed rate changes: they are judged together, as what lies between
/// them is.
#[test]
fn a_cl_file_of_a_region_is_held_against_all_of_it() {
    let dir = folder_with("crest.apt", REGION);
    let made = aptc(dir.path(), &["compile", "crest.apt", "--emit", "cl,cltape", "--quiet"]);
    assert_eq!(made.status.code(), Some(0), "{}{}", text(&made.stdout), text(&made.stderr));
    let cl = fs::read_to_string(dir.path().join("crest.cl")).unwrap();
    let bare: Vec<&str> = cl.lines().filter(|l| !l.starts_with("$$")).collect();
    fs::write(dir.path().join("bare.cl"), bare.join("\n") + "\n").unwrap();
    for file in ["crest.cl", "crest.cltape", "bare.cl"] {
        let run = aptc(dir.path(), &["verify", "crest.apt", "--cl", file]);
        assert_eq!(run.status.code(), Some(0), "{file}: {}", text(&run.stderr));
    }
    // What lies between two feed rates in the middle, two passes, is left out.
    let feeds: Vec<usize> = (0..bare.len()).filter(|i| bare[*i].starts_with("FEDRAT")).collect();
    let pass = feeds[feeds.len() / 2]..feeds[feeds.len() / 2 + 4];
    let left: Vec<&str> = (0..bare.len()).filter(|i| !pass.contains(i)).map(|i| bare[i]).collect();
    assert!(left.len() + 5 < bare.len(), "{pass:?}");
    fs::write(dir.path().join("left.cl"), left.join("\n") + "\n").unwrap();
    let run = aptc(dir.path(), &["verify", "crest.apt", "--cl", "left.cl"]);
    assert_eq!(run.status.code(), Some(3), "{}", text(&run.stderr));
    assert!(text(&run.stderr).contains("leaves material"), "{}", text(&run.stderr));
}

#[test]
fn a_cl_file_of_another_program_gives_one_error() {
    let dir = folder_with("box.apt", PART);
    // The lines of another program have the same numbers; its numbers do not fit.
    let other = PART.replace("60,", "460,").replace("-70", "-270").replace("-20,-20", "-400,-90");
    for (file, part) in [("same", "PARTNO BOX"), ("other", "PARTNO LID"), ("none", "REMARK")] {
        fs::write(dir.path().join("other.apt"), other.replace("PARTNO BOX", part)).unwrap();
        aptc(dir.path(), &["compile", "other.apt", "--emit", "cl", "--quiet"]);
        let cl = fs::read_to_string(dir.path().join("other.cl")).unwrap();
        let bare: String =
            cl.lines().filter(|l| !l.starts_with("$$")).map(|l| format!("{l}\n")).collect();
        for cl in [&cl, &bare] {
            fs::write(dir.path().join("given.cl"), cl).unwrap();
            let options = ["verify", "box.apt", "--cl", "given.cl", "--message-format", "json"];
            let run = aptc(dir.path(), &options);
            assert_eq!(run.status.code(), Some(3), "{file}: {}", text(&run.stderr));
            let said = text(&run.stderr);
            assert_eq!(said.lines().count(), 1, "{said}");
            assert!(said.contains("APT5003") && said.contains("\"line\":14"), "{said}");
            assert_eq!(said.contains("its part is LID, not BOX"), file == "other", "{said}");
            assert_eq!(text(&run.stdout), "");
        }
    }
    // The file of this program before lines were put into it, and one whose UNITS were lost.
    aptc(dir.path(), &["compile", "box.apt", "--emit", "cl", "--quiet"]);
    fs::write(dir.path().join("box.apt"), PART.replace("CUTTER", "REMARK ONE\nREMARK\nCUTTER"))
        .unwrap();
    let run = aptc(dir.path(), &["verify", "box.apt", "--cl", "box.cl"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let cl = fs::read_to_string(dir.path().join("box.cl")).unwrap();
    fs::write(dir.path().join("lost.cl"), cl.replace("UNITS/MM", "UNITS/INCHES")).unwrap();
    let run = aptc(dir.path(), &["verify", "box.apt", "--cl", "lost.cl"]);
    assert_eq!(run.status.code(), Some(3), "{}", text(&run.stderr));
    assert!(text(&run.stderr).contains("25.400 times as large"), "{}", text(&run.stderr));
}

#[test]
fn a_file_is_judged_with_its_own_cutter() {
    let dir = folder_with("box.apt", PART);
    aptc(dir.path(), &["compile", "box.apt", "--emit", "cl", "--quiet"]);
    let cl = fs::read_to_string(dir.path().join("box.cl")).unwrap();
    let given = "CUTTER/10,0,5,0,0,0,127";
    assert!(cl.contains(given), "{cl}");
    // The number of errors, and what is said.
    let judged = |cutter: &str| {
        fs::write(dir.path().join("other.cl"), cl.replace(given, cutter)).unwrap();
        let run = aptc(dir.path(), &["verify", "box.apt", "--cl", "other.cl"]);
        (run.status.code(), text(&run.stderr))
    };
    // Another height, rounded numbers, and e and f that are left open, are the same cutter.
    for same in ["CUTTER/10,0,5,0,0,0,40", "CUTTER/9.9999", "CUTTER/10,0,0,0,0,0,50"] {
        assert_eq!(judged(same), (Some(0), String::new()), "{same}");
    }
    for (other, said) in
        [("CUTTER/12", "CUTTER/12"), ("CUTTER/10,1", "CUTTER/10,1"), ("CUTTER/9", "CUTTER/9")]
    {
        let (code, messages) = judged(other);
        assert!(
            messages.contains(&format!(
                "the cutter of other.cl is {said}, that of the program CUTTER/10"
            )),
            "{messages}"
        );
        // The corner leaves nothing and cuts nothing of lines and a floor; another diameter does.
        let right = if other == "CUTTER/10,1" { 0 } else { 3 };
        assert_eq!(code, Some(right), "{other}: {messages}");
        assert_eq!(messages.contains("APT5001"), right == 3, "{messages}");
    }
}

/// Two cutters that have changed places: the larger one goes where the smaller one was to go, and the other way.
#[test]
fn cutters_that_change_places_are_each_judged_where_they_are() {
    let more = "CUTTER/12\nGOTO/-20,-20,30\nGO/TO,L1,TO,FLOOR\nTLRGT,GORGT/L1,TO,C1\n";
    let part = PART.replace("FINI\n", &format!("{more}FINI\n"));
    let dir = folder_with("box.apt", &part);
    aptc(dir.path(), &["compile", "box.apt", "--emit", "cl", "--quiet"]);
    let cl = fs::read_to_string(dir.path().join("box.cl")).unwrap();
    let [ten, twelve] = ["CUTTER/10,", "CUTTER/12,"];
    assert!(cl.contains(ten) && cl.contains(twelve), "{cl}");
    let swapped = cl.replace(ten, "CUTTER/X,").replace(twelve, ten).replace("CUTTER/X,", twelve);
    let swapped =
        swapped.replace("12,0,5,0", "12,0,6,0").replace("CUTTER/10,0,6,0", "CUTTER/10,0,5,0");
    fs::write(dir.path().join("other.cl"), swapped).unwrap();
    let run = aptc(dir.path(), &["verify", "box.apt", "--cl", "other.cl"]);
    assert_eq!(run.status.code(), Some(3), "{}", text(&run.stderr));
    let said = text(&run.stderr);
    assert!(said.contains("other.cl is CUTTER/12, that of the program CUTTER/10"), "{said}");
    assert!(said.contains("other.cl is CUTTER/10, that of the program CUTTER/12"), "{said}");
    // The larger one cuts in, the smaller one leaves what was to be cut.
    assert!(said.contains("cuts into"), "{said}");
    assert!(said.matches("APT5001").count() > said.matches("cuts into").count(), "{said}");
}

#[test]
fn how_much_is_proved_can_be_chosen() {
    let dir = folder_with("box.apt", PART);
    for (how, said) in [("full", "all"), ("sample", "left out"), ("off", "")] {
        let run = aptc(dir.path(), &["compile", "box.apt", "--verify", how]);
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
        let summary = text(&run.stdout);
        assert_eq!(summary.contains("tolerance"), how != "off", "{summary}");
        assert!(summary.contains(said), "{how}: {summary}");
    }
    // `verify` is good only where everything is proved.
    for (how, code, said) in [
        ("full", 0, "all 23 cut vectors"),
        ("sample", 3, "left out of the sample"),
        ("off", 3, "nothing is proved"),
    ] {
        let run = aptc(dir.path(), &["verify", "box.apt", "--verify", how]);
        assert_eq!(run.status.code(), Some(code), "{how}: {}", text(&run.stderr));
        assert!(text(&run.stdout).contains(said), "{how}: {}", text(&run.stdout));
    }
}

#[test]
fn a_cut_at_rapid_gives_no_machine_code() {
    let bad = PART.replace("FINI", "RAPID\nGOTO/0,50,-9\nGODLTA/0,0,20\nGO/TO,L1,TO,FLOOR\nFINI");
    let dir = folder_with("box.apt", &bad);
    let run = aptc(dir.path(), &["compile", "box.apt"]);
    assert_eq!(run.status.code(), Some(3), "{}", text(&run.stderr));
    assert!(text(&run.stderr).contains("APT5005"), "{}", text(&run.stderr));
    assert!(dir.path().join("box.cl").is_file() && !dir.path().join("box.nc").is_file());
}

#[test]
fn machine_code_is_held_against_a_cl_file() {
    let dir = folder_with("box.apt", PART);
    let run = aptc(dir.path(), &["compile", "box.apt", "--machine", "linuxcnc-mill"]);
    assert!(run.status.success(), "{}", text(&run.stderr));
    let nc = fs::read_to_string(dir.path().join("box.nc")).expect("it was written");
    let check = |file: &str| {
        let options = ["verify", "--nc", file, "--machine", "linuxcnc-mill", "--cl", "box.cl"];
        aptc(dir.path(), &options)
    };
    let good = check("box.nc");
    assert!(good.status.success(), "{}", text(&good.stderr));
    assert!(
        text(&good.stdout).starts_with("box.nc goes where box.cl says"),
        "{}",
        text(&good.stdout)
    );
    // A foreign hand changed one coordinate.
    let changed = nc.replacen("G1 Y-75", "G1 Y-75.21", 1);
    assert_ne!(changed, nc);
    fs::write(dir.path().join("bad.nc"), changed).expect("it is written");
    let bad = check("bad.nc");
    assert_eq!(bad.status.code(), Some(3), "{}", text(&bad.stderr));
    assert!(text(&bad.stderr).contains("APT5401") && text(&bad.stderr).contains("line "));
    assert!(text(&bad.stdout).starts_with("bad.nc does not go where box.cl says"));
    assert!(!text(&bad.stdout).contains("within"), "{}", text(&bad.stdout));
    // Of another part, for another control, none at all: one message, and no word of agreement.
    let program = |text: &str| fs::write(dir.path().join("bad.nc"), text).expect("it is written");
    for other in [nc.replace('X', "X9"), nc.replace('G', "%")] {
        program(&other);
        let bad = check("bad.nc");
        assert_eq!(bad.status.code(), Some(3), "{}", text(&bad.stderr));
        assert_eq!(text(&bad.stderr).matches("[APT").count(), 1, "{}", text(&bad.stderr));
        assert!(text(&bad.stderr).contains("of another part"), "{}", text(&bad.stderr));
    }
    program("");
    assert_eq!(check("bad.nc").status.code(), Some(2));
    assert_eq!(check("box.apt").status.code(), Some(2));
    // CL data that cannot be read are the fault of the CL data, and are named with their file.
    let cl = fs::read_to_string(dir.path().join("box.cl")).expect("it was written");
    fs::write(dir.path().join("box.cl"), cl.replacen("GOTO/", "GOTO/Q,", 1))
        .expect("it is written");
    let bad = check("box.nc");
    assert_eq!(bad.status.code(), Some(1), "{}", text(&bad.stderr));
    assert!(text(&bad.stderr).contains("box.cl:"), "{}", text(&bad.stderr));
    // Both the machine and the CL data have to be named, and how is told.
    for options in [&["verify", "--nc", "box.nc"][..], &["verify", "box.apt", "--nc", "box.nc"]] {
        let bad = aptc(dir.path(), options);
        assert_eq!(bad.status.code(), Some(2));
        assert!(
            text(&bad.stderr).contains("aptc verify --nc box.nc --cl "),
            "{}",
            text(&bad.stderr)
        );
    }
}
