//! The program from outside: exit codes, files, streams.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const GOOD: &str = "PARTNO SLOT\nUNITS/MM\nLOADTL/1\nSPINDL/1000,CLW\nFEDRAT/100,MMPM\nCUTTER/6\n\
                    FROM/0,0,10\nGOTO/0,0,-1\nGOTO/50,0,-1\nRAPID\nGODLTA/0,0,20\nFINI\n";
const BAD: &str = "PARTNO BAD\nP1=POINT/1,2\nL1=LINE/P1,P2\nGOTO/P1\nFINI\n";

fn aptc(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_aptc"))
        .args(arguments)
        .current_dir(folder)
        .env_remove("NO_COLOR")
        .output()
        .expect("the program starts")
}

fn folder_with(files: &[(&str, &str)]) -> tempfile::TempDir {
    let dir = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        fs::write(dir.path().join(name), text).expect("it is written");
    }
    dir
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("it is text")
}

#[test]
fn a_part_alone_is_compiled() {
    let dir = folder_with(&[("slot.apt", GOOD)]);
    let run = aptc(dir.path(), &["slot.apt"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    for ending in ["cl", "nc", "lst", "svg"] {
        assert!(dir.path().join(format!("slot.{ending}")).is_file(), "{ending}");
    }
    let summary = text(&run.stdout);
    assert!(summary.contains("cut vectors") && summary.contains("SLOT"), "{summary}");
}

/// Without MACHIN a machine is taken that can reach the tool axes.
#[test]
fn a_leaning_axis_without_machin_is_posted_for_five_axes() {
    let leaning = GOOD.replace("CUTTER/6\n", "CUTTER/6\nMULTAX\n");
    let leaning = leaning.replace("GOTO/50,0,-1\n", "GOTO/50,0,-1,.6,0,.8\n");
    let dir = folder_with(&[("slot.apt", GOOD), ("lean.apt", &leaning)]);
    for (name, title) in [("slot.apt", "three-axis mill"), ("lean.apt", "five-axis mill")] {
        let run = aptc(dir.path(), &["compile", name]);
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
        assert!(text(&run.stderr).contains(title), "{}", text(&run.stderr));
    }
}

#[test]
fn a_rapid_through_the_stock_is_an_error_with_any_machine() {
    let dir = tempfile::tempdir().expect("a folder of our own");
    let part = "PARTNO RAPID\nCUTTER/10\nFROM/-50,25,40\nRAPID\nGOTO/25,25,5\nFINI\n";
    fs::write(dir.path().join("rapid.apt"), part).expect("a folder of our own");
    let run = aptc(dir.path(), &["compile", "rapid.apt", "--stock", "0,0,0,50,50,20"]);
    let said = text(&run.stderr);
    assert!(run.status.code() != Some(0) && said.contains("Error"), "{said}");
}

/// Who names no machine and asks for no machine code is not failed by a machine that is only assumed.
#[test]
fn cl_data_alone_need_no_feed() {
    let bare = "PARTNO BARE\nUNITS/MM\nCUTTER/6\nFROM/0,0,10\nGOTO/0,0,-1\nGOTO/50,0,-1\nFINI\n";
    let named = bare.replace("CUTTER", "MACHIN/EMC\nCUTTER");
    let dir = folder_with(&[("bare.apt", bare), ("named.apt", &named)]);
    let run = aptc(dir.path(), &["compile", "bare.apt"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    assert!(dir.path().join("bare.cl").is_file() && !dir.path().join("bare.nc").exists());
    let said = text(&run.stderr);
    assert!(said.contains("no machine code is written: this cut has no feed rate"), "{said}");
    assert!(!said.contains("Error") && !said.contains("Warning"), "{said}");
    // Nor words that the assumed machine has not, as a lathe's or an old mill's.
    let words = bare.replace("CUTTER", "FEDRAT/100\nSPINDL/HIGH,2000,OFF\nCUTTER");
    fs::write(dir.path().join("words.apt"), words).expect("a folder of our own");
    let run = aptc(dir.path(), &["compile", "words.apt"]);
    let told = text(&run.stderr);
    assert_eq!(run.status.code(), Some(0), "{told}");
    assert!(told.contains("no machine code is written: SPINDL/HIGH,2000,OFF"), "{told}");
    // Machine code of an earlier run would pass for that of this one.
    assert!(!said.contains("earlier run"), "{said}");
    fs::write(dir.path().join("bare.nc"), "G0 Z50\n").expect("a folder of our own");
    let run = aptc(dir.path(), &["compile", "bare.apt"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let said = text(&run.stderr);
    assert!(said.contains("warning: ") && said.contains("bare.nc is of an earlier run"), "{said}");
    let run = aptc(dir.path(), &["compile", "bare.apt", "--emit", "cl"]);
    assert!(!text(&run.stderr).contains("earlier run"), "{}", text(&run.stderr));
    // The same where the program has come to have an error.
    let bare = fs::read_to_string(dir.path().join("bare.apt")).expect("it is there");
    fs::write(dir.path().join("bare.apt"), bare.replace("FINI", "GOTO/NOWHER\nFINI"))
        .expect("it is written");
    let run = aptc(dir.path(), &["compile", "bare.apt"]);
    assert!(text(&run.stderr).contains("bare.nc is of an earlier run"), "{}", text(&run.stderr));
    fs::write(dir.path().join("bare.apt"), bare).expect("it is written");
    fs::remove_file(dir.path().join("bare.nc")).expect("it is there");
    for asked in [
        vec!["compile", "bare.apt", "--emit", "nc"],
        vec!["compile", "bare.apt", "--machine", "grbl"],
        vec!["compile", "named.apt"],
        vec!["post", "bare.cl"],
    ] {
        let run = aptc(dir.path(), &asked);
        assert_eq!(run.status.code(), Some(1), "{asked:?}: {}", text(&run.stderr));
        assert!(text(&run.stderr).contains("this cut has no feed rate"), "{asked:?}");
    }
}

#[test]
fn errors_leave_good_files_alone() {
    let dir = folder_with(&[("slot.apt", GOOD)]);
    aptc(dir.path(), &["compile", "slot.apt", "-o", "out"]);
    let before = fs::read(dir.path().join("out/slot.nc")).unwrap();
    fs::write(dir.path().join("slot.apt"), BAD).unwrap();
    let run = aptc(dir.path(), &["compile", "slot.apt", "-o", "out"]);
    assert_eq!(run.status.code(), Some(1));
    assert_eq!(fs::read(dir.path().join("out/slot.nc")).unwrap(), before);
    assert!(text(&run.stderr).contains("P2"), "{}", text(&run.stderr));
    let run = aptc(dir.path(), &["compile", "slot.apt", "-o", "out", "--keep-going"]);
    assert_eq!(run.status.code(), Some(1));
    assert!(dir.path().join("out/slot.partial.cl").is_file());
}

#[test]
fn check_gives_json_objects_a_line() {
    let dir = folder_with(&[("bad.apt", BAD)]);
    let run = aptc(dir.path(), &["check", "bad.apt", "--message-format", "json"]);
    assert_eq!(run.status.code(), Some(1));
    let out = text(&run.stdout);
    let first: serde_json::Value = serde_json::from_str(out.lines().next().unwrap()).unwrap();
    for key in [
        "code",
        "severity",
        "message",
        "line",
        "column",
        "end_line",
        "end_column",
        "labels",
        "help",
    ] {
        assert!(first.get(key).is_some(), "{key} in {first}");
    }
    assert_eq!((&first["line"], &first["column"]), (&3.into(), &12.into()));
    assert_eq!(out.lines().count(), 1, "one mistake, one message: {out}");
}

#[test]
fn usage_and_missing_files_are_two() {
    let dir = folder_with(&[]);
    assert_eq!(aptc(dir.path(), &["compile"]).status.code(), Some(2));
    assert_eq!(aptc(dir.path(), &["compile", "none.apt"]).status.code(), Some(2));
    assert_eq!(aptc(dir.path(), &["explain", "APT9999"]).status.code(), Some(2));
}

#[test]
fn no_colour_into_a_pipe() {
    let dir = folder_with(&[("bad.apt", BAD)]);
    let run = aptc(dir.path(), &["bad.apt"]);
    assert!(!text(&run.stderr).contains('\u{1b}'));
    let run = aptc(dir.path(), &["bad.apt", "--color", "always"]);
    assert!(text(&run.stderr).contains('\u{1b}'));
}

#[test]
fn the_same_program_from_cl_gives_the_same_code() {
    let dir = folder_with(&[("slot.apt", GOOD)]);
    aptc(dir.path(), &["slot.apt"]);
    fs::create_dir(dir.path().join("out")).unwrap();
    // A file, or a folder for a file of the CL file's name.
    for (output, written) in [("again.nc", "again.nc"), ("out", "out/slot.nc")] {
        let run = aptc(dir.path(), &["post", "slot.cl", "-o", output]);
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
        let read = |name| fs::read_to_string(dir.path().join(name)).unwrap();
        assert_eq!(read(written), read("slot.nc"));
    }
}

#[test]
fn every_code_is_explained() {
    let dir = folder_with(&[]);
    let list = text(&aptc(dir.path(), &["explain"]).stdout);
    assert!(list.lines().count() > 20);
    for line in list.lines() {
        let code = line.split_whitespace().next().unwrap();
        let page = aptc(dir.path(), &["explain", code]);
        assert_eq!(page.status.code(), Some(0));
        assert!(text(&page.stdout).lines().count() > 3, "{code} has a page");
    }
}

#[test]
fn the_limits_are_settings() {
    let endless = "PARTNO X\nI=0\nLOOPST\nA) I=I+1\nJUMPTO/A\nLOOPND\nFINI\n";
    let files = [
        ("endless.apt", endless),
        ("array.apt", "RESERV/A,50\nFINI\n"),
        ("pattern.apt", "Q=PATERN/LINEAR,(POINT/0,0),(POINT/1,0),50\nFINI\n"),
        ("macro.apt", "A=MACRO/\nTERMAC\nB=MACRO/\nCALL/A\nTERMAC\nCALL/B\nFINI\n"),
        ("outer.apt", "INCLUD/INNER\nFINI\n"),
        ("inner.apt", "INCLUD/DEEP\n"),
        ("deep.apt", "X=1\n"),
    ];
    let dir = folder_with(&files);
    for (part, option, value, code) in [
        ("endless.apt", "--max-seconds", "0.05", "APT1105"),
        ("endless.apt", "--max-statements", "1000", "APT1100"),
        ("array.apt", "--max-array-elements", "40", "APT1103"),
        ("pattern.apt", "--max-points", "40", "APT1215"),
        ("macro.apt", "--max-macro-depth", "1", "APT1101"),
        ("outer.apt", "--max-include-depth", "1", "APT1102"),
        ("array.apt", "--max-file-size", "5", "larger than 5 bytes"),
    ] {
        let run = aptc(dir.path(), &["check", part, option, value]);
        let told = text(&run.stderr);
        assert_ne!(run.status.code(), Some(0), "{option}");
        assert!(told.contains(code), "{option} {value}: {told}");
        if part != "endless.apt" {
            let run = aptc(dir.path(), &["check", part]);
            assert!(!text(&run.stderr).contains("Error"), "{part}: {}", text(&run.stderr));
        }
    }
}

#[test]
fn names_that_are_never_used_are_told_on_request() {
    let dir = folder_with(&[("x.apt", "P1=POINT/1,2\nP2=POINT/3,4\nGOTO/P1\nFINI\n")]);
    assert!(!text(&aptc(dir.path(), &["check", "x.apt"]).stderr).contains("never used"));
    let run = aptc(dir.path(), &["check", "x.apt", "--warn-unused"]);
    assert!(text(&run.stderr).contains("P2 is never used"), "{}", text(&run.stderr));
}

#[test]
fn words_are_explained() {
    let dir = folder_with(&[]);
    let run = aptc(dir.path(), &["explain", "circle"]);
    assert_eq!(run.status.code(), Some(0));
    assert!(
        text(&run.stdout).contains("CIRCLE/CENTER,point,RADIUS,number"),
        "{}",
        text(&run.stdout)
    );
    let run = aptc(dir.path(), &["explain", "CIRCEL"]);
    assert_ne!(run.status.code(), Some(0));
    assert!(text(&run.stderr).contains("did you mean CIRCLE?"), "{}", text(&run.stderr));
}

#[test]
fn an_input_cannot_speak_to_the_terminal() {
    let program = "PARTNO A\u{1b}]0;B\u{7}\nP1=POINT/1,2\u{1b}[2J\nGOTO/P2\nFINI\n";
    let dir = folder_with(&[("x.apt", program)]);
    for format in ["human", "short", "json", "sarif"] {
        let output =
            aptc(dir.path(), &["compile", "x.apt", "--color", "never", "--message-format", format]);
        let all = [output.stdout, output.stderr].concat();
        let wild = all.iter().find(|b| b.is_ascii_control() && !b"\n\t".contains(b));
        assert_eq!(wild, None, "{format}: {}", String::from_utf8_lossy(&all));
    }
}

#[test]
fn an_installation_gets_completions_and_manual_pages() {
    let dir = folder_with(&[]);
    for shell in ["bash", "zsh", "fish"] {
        let script = text(&aptc(dir.path(), &["completions", shell]).stdout);
        assert!(script.contains("cldiff"), "{shell} knows the commands");
    }
    assert!(aptc(dir.path(), &["man", "-o", "man"]).status.success());
    for page in ["aptc.1", "aptc-compile.1", "aptc-post.1"] {
        let page = fs::read_to_string(dir.path().join("man").join(page)).expect("a page");
        assert!(page.contains(".SH OPTIONS"));
    }
}

/// A picture that is asked for and not made is told of, with the reason.
#[test]
fn pictures_that_there_are_not_are_told() {
    let dir = folder_with(&[("slot.apt", GOOD)]);
    let run = aptc(dir.path(), &["slot.apt", "--emit", "diagram,deviation"]);
    let said = text(&run.stdout);
    assert!(said.contains("none, for no motion failed"), "{said}");
    assert!(said.contains("none, for nothing was milled by regions"), "{said}");
    assert!(!said.contains("wrote"), "{said}");
}

/// What PRINT lists stands with the line of its statement, as the source and the messages do.
#[test]
fn the_listing_counts_lines() {
    let part = "PARTNO X\n$$ a remark\nA=$\n1\n\nB=2\nPRINT/3,B\nFINI\n";
    let dir = folder_with(&[("x.apt", part)]);
    let run = aptc(dir.path(), &["x.apt", "--emit", "lst"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let listing = fs::read_to_string(dir.path().join("x.lst")).expect("it was made");
    assert!(listing.contains("     7  PRINT/3,B"), "{listing}");
    assert!(listing.contains("     7  B           SCALAR"), "{listing}");
}
