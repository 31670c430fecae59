//! Faults of the world: a full disk, a folder that takes nothing, a kill in the midst of writing, files that cannot
//! be read, another locale. What was there stays, and the message is true.
#![cfg(target_os = "linux")]

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

const APTC: &str = env!("CARGO_BIN_EXE_aptc");
const OLD: &str = "what was there before\n";

fn shell(folder: &Path, line: &str) -> Output {
    let mut command = Command::new("sh");
    command.args(["-c", line]).current_dir(folder).output().expect("the shell starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("messages are UTF-8")
}

/// A part program that goes from point to point so often.
fn points(n: usize) -> String {
    let head = "PARTNO P\nMACHIN/LINUXCNC\nUNITS/MM\nLOADTL/1\nSPINDL/900,CLW\nCOOLNT/ON\nFEDRAT/200,MMPM\n";
    let body = (0..n).fold(String::new(), |mut body, i| {
        writeln!(body, "GOTO/{},{}.5,1", i % 500, i % 300).expect("a string takes all");
        body
    });
    format!("{head}{body}FINI\n")
}

/// Names in a folder, in order.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let mut names: Vec<String> = entries
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn a_full_disk_leaves_the_old_files() {
    for (command, output) in [
        ("compile p.apt -o out", "out/p.cl"),
        ("convert p.apt --to json -o out/p.json", "out/p.json"),
        ("post p.apt -o out/p.nc", "out/p.nc"),
        ("fmt p.apt", "p.apt"),
    ] {
        let dir = tempfile::tempdir().expect("a folder");
        fs::create_dir(dir.path().join("out")).expect("a folder");
        let program = points(400).replace("GOTO/", "GOTO /  ");
        fs::write(dir.path().join("p.apt"), &program).expect("it is written");
        let old = if output == "p.apt" { &*program } else { OLD };
        fs::write(dir.path().join(output), old).expect("it is written");
        let before = (names(dir.path()), names(&dir.path().join("out")));
        // Files of at most 2 KiB, and an error in place of a signal: what a full disk looks like from within.
        let run = shell(dir.path(), &format!("trap '' XFSZ; ulimit -f 4; exec {APTC} {command}"));
        let told = text(&run.stderr);
        assert_ne!(run.status.code(), Some(0), "{command}: {told}");
        assert!(run.status.code().is_some(), "{command}: a signal ended it: {told}");
        assert!(told.contains("cannot"), "{command}: {told}");
        assert_eq!(
            text(&fs::read(dir.path().join(output)).expect("it is there")),
            old,
            "{command}"
        );
        assert_eq!((names(dir.path()), names(&dir.path().join("out"))), before, "{command}");
    }
}

#[test]
fn a_folder_that_takes_nothing_is_named() {
    let dir = tempfile::tempdir().expect("a folder");
    fs::write(dir.path().join("p.apt"), points(3)).expect("it is written");
    for command in
        ["compile p.apt -o /proc/1", "convert p.apt -o /proc/1/p.cl", "post p.apt -o /proc/1/p.nc"]
    {
        let run = shell(dir.path(), &format!("exec {APTC} {command}"));
        let told = text(&run.stderr);
        assert!(run.status.code().is_some_and(|code| code != 0), "{command}: {told}");
        assert!(told.contains("/proc/1"), "{command}: {told}");
    }
}

#[test]
fn a_kill_in_the_midst_of_writing_leaves_the_old_file() {
    let dir = tempfile::tempdir().expect("a folder");
    fs::write(dir.path().join("long.cl"), points(400_000)).expect("it is written");
    fs::write(dir.path().join("long.nc"), OLD).expect("it is written");
    let mut command = Command::new(APTC);
    command.args(["post", "long.cl", "-o", "long.nc"]).current_dir(dir.path());
    let mut run = command.stderr(Stdio::null()).spawn().expect("the program starts");
    // Until some of the text stands beside: then in the midst of it.
    let beside = || {
        let part = names(dir.path()).into_iter().find(|name| name.starts_with(".aptc-"));
        part.and_then(|part| fs::metadata(dir.path().join(part)).ok()).map_or(0, |m| m.len())
    };
    while beside() == 0 {
        assert!(
            run.try_wait().expect("it can be asked").is_none(),
            "it ended before it was killed"
        );
        std::thread::yield_now();
    }
    run.kill().expect("it can be killed");
    run.wait().expect("it ends");
    assert_eq!(fs::read_to_string(dir.path().join("long.nc")).expect("it is there"), OLD);
    // The next run is not in the way of what the killed one left.
    fs::write(dir.path().join("long.cl"), points(10)).expect("it is written");
    let again = shell(dir.path(), &format!("exec {APTC} post long.cl -o long.nc"));
    assert_eq!(again.status.code(), Some(0), "{}", text(&again.stderr));
    assert!(fs::read_to_string(dir.path().join("long.nc")).expect("it is there").contains("G1"));
}

#[test]
fn files_that_cannot_be_read_are_told_with_their_reason() {
    let dir = tempfile::tempdir().expect("a folder");
    fs::create_dir(dir.path().join("folder")).expect("a folder");
    assert!(shell(dir.path(), "mkfifo pipe; ln -s nowhere link").status.success());
    for name in ["folder", "pipe", "link", "absent"] {
        fs::write(dir.path().join("p.apt"), format!("PARTNO P\nINCLUD/{name}\nFINI\n"))
            .expect("it is written");
        let run = shell(dir.path(), &format!("timeout 20 {APTC} compile p.apt -o out"));
        let told = text(&run.stderr);
        assert_eq!(run.status.code(), Some(1), "{name}: {told}");
        assert!(told.to_lowercase().contains(name), "{name}: {told}");
        assert_eq!(told.matches("Error:").count(), 1, "{name}: {told}");
    }
}

#[test]
fn locale_and_clock_change_nothing() {
    let dir = tempfile::tempdir().expect("a folder");
    fs::write(dir.path().join("p.apt"), points(20)).expect("it is written");
    let all = "--emit protap,cl,cl-json,cltape,nc,setup,map,lst,svg,geometry";
    let places = ["LC_ALL=C TZ=UTC", "LC_ALL=de_DE.UTF-8 LANG=tr_TR.UTF-8 TZ=Pacific/Kiritimati"];
    for (n, variables) in places.iter().enumerate() {
        let run =
            shell(dir.path(), &format!("{variables} exec {APTC} compile p.apt -o out{n} {all}"));
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    }
    let (first, second) = (dir.path().join("out0"), dir.path().join("out1"));
    assert!(names(&first).len() >= 8, "{:?}", names(&first));
    assert_eq!(names(&first), names(&second));
    for name in names(&first) {
        let read = |folder: &Path| fs::read(folder.join(&name)).expect("it is there");
        assert_eq!(read(&first), read(&second), "{name}");
    }
}
