//! `aptc fmt` from outside: what it writes, what it only shows, and its exit codes.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const LOOSE: &str =
    "partno plate\nunits/mm\nP1 =POINT/ 0 , 0\nP2=point/10,  0\nL1=LINE/P1,P2\nfini\n";

fn fmt(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_aptc"))
        .arg("fmt")
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the program starts")
}

fn folder() -> tempfile::TempDir {
    let dir = tempfile::tempdir().expect("a folder");
    fs::write(dir.path().join("plate.apt"), LOOSE).expect("it is written");
    dir
}

#[test]
fn a_program_is_put_into_style_once() {
    let dir = folder();
    let file = dir.path().join("plate.apt");
    assert_eq!(fmt(dir.path(), &["plate.apt"]).status.code(), Some(0));
    let once = fs::read_to_string(&file).unwrap();
    assert_ne!(once, LOOSE);
    assert_eq!(once.lines().count(), LOOSE.lines().count());
    assert!(once.contains("POINT/") && !once.contains("point/"), "{once}");
    assert_eq!(fmt(dir.path(), &["--check", "plate.apt"]).status.code(), Some(0));
    assert_eq!(fmt(dir.path(), &["plate.apt"]).status.code(), Some(0));
    assert_eq!(fs::read_to_string(&file).unwrap(), once);
}

#[test]
fn check_names_the_file_and_changes_nothing() {
    let dir = folder();
    let run = fmt(dir.path(), &["--check", "plate.apt"]);
    assert_eq!(run.status.code(), Some(1));
    assert_eq!(String::from_utf8_lossy(&run.stdout), "would change plate.apt\n");
    assert_eq!(fs::read_to_string(dir.path().join("plate.apt")).unwrap(), LOOSE);
}

#[test]
fn diff_shows_the_lines_that_change() {
    let dir = folder();
    let run = fmt(dir.path(), &["--diff", "plate.apt"]);
    assert_eq!(run.status.code(), Some(1));
    let shown = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(shown.starts_with("--- plate.apt\n+++ plate.apt\n@@ line "), "{shown}");
    assert!(shown.contains("-P1 =POINT/ 0 , 0\n+"), "{shown}");
    let (old, new) = (shown.matches("\n-").count(), shown.matches("\n+").count());
    assert_eq!(old, new - 1, "{shown}");
    assert_eq!(fs::read_to_string(dir.path().join("plate.apt")).unwrap(), LOOSE);
}

#[test]
fn a_file_that_is_not_there_is_named() {
    let run = fmt(folder().path(), &["none.apt"]);
    assert_ne!(run.status.code(), Some(0));
    assert!(String::from_utf8_lossy(&run.stderr).contains("cannot read none.apt"));
}
