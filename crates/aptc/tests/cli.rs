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
    let dir = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(dir.path().join(name), text).unwrap();
    }
    dir
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
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
    let run = aptc(dir.path(), &["post", "slot.cl", "-o", "again.nc"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let read = |name| fs::read_to_string(dir.path().join(name)).unwrap();
    assert_eq!(read("again.nc"), read("slot.nc"));
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
