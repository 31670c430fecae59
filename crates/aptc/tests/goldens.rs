//! `aptc test`: a user's own folder of part programs.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const SLOT: &str = "PARTNO SLOT\nMACHIN/LINUXCNC\nUNITS/MM\nLOADTL/1\nSPINDL/1000,CLW\nCOOLNT/ON\n\
                    FEDRAT/100,MMPM\nCUTTER/6\nFROM/0,0,10\nGOTO/0,0,-1\nGOTO/50,0,-1\nRAPID\n\
                    GODLTA/0,0,20\nFINI\n";

fn test(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let Output { status, stdout, stderr } = Command::new(env!("CARGO_BIN_EXE_aptc"))
        .args(["test", "."])
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the program starts");
    let said = String::from_utf8_lossy(&stdout) + String::from_utf8_lossy(&stderr);
    (status.code(), said.into_owned())
}

fn change(folder: &Path, file: &str, from: &str, to: &str) {
    let text = fs::read_to_string(folder.join(file)).expect("a file");
    assert!(text.contains(from), "{text}");
    fs::write(folder.join(file), text.replacen(from, to, 1)).expect("it is written");
}

#[test]
fn a_folder_of_ones_own_is_blessed_and_held() {
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path();
    assert_eq!(test(folder, &[]).0, Some(2), "an empty folder is a mistake");
    fs::write(folder.join("slot.apt"), SLOT).unwrap();
    fs::create_dir(folder.join("lug")).unwrap();
    fs::write(folder.join("lug/program.apt"), SLOT).unwrap();

    let (code, said) = test(folder, &[]);
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("slot: program.cl is missing"), "{said}");
    assert!(said.contains("0 of 2 programs"), "{said}");
    let (code, said) = test(folder, &["--bless"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("slot: blessed: program.cl is new"), "{said}");
    assert!(said.contains("goldens are written anew"), "{said}");
    let (code, said) = test(folder, &["none"]);
    assert!(code == Some(2) && said.contains("no program of . has none in its name"), "{said}");
    for file in ["slot.golden/program.nc", "slot.golden/program.protap", "lug/program.cl"] {
        assert!(folder.join(file).is_file(), "{file}");
    }
    let (code, said) = test(folder, &[]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("2 of 2 programs as they should be"), "{said}");

    // A comment moves every line; the part stays.
    change(folder, "slot.apt", "FROM", "$$ the slot\nFROM");
    let (code, said) = test(folder, &[]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("program.cl line 15: cosmetic"), "{said}");
    assert!(said.contains("program.protap") && !said.contains("became"), "{said}");

    change(folder, "slot.apt", "GOTO/50,0,-1", "GOTO/51,0,-1");
    let (code, said) = test(folder, &["slot"]);
    assert_eq!(code, Some(1), "{said}");
    assert!(
        said.contains("slot: program.cl line 20: `GOTO/50,0,-1` became `GOTO/51,0,-1`"),
        "{said}"
    );
    assert!(said.contains("0 of 1 programs"), "{said}");
}

#[test]
fn messages_that_come_are_to_be_expected() {
    let dir = tempfile::tempdir().unwrap();
    let wrong = SLOT.replace("GOTO/50,0,-1", "$$ ERROR APT1050 6-7 P9 has no value\nGOTO/P9");
    fs::write(dir.path().join("slot.apt"), &wrong).unwrap();
    let (code, said) = test(dir.path(), &["--bless"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(!dir.path().join("slot.golden/program.cl").exists());
    let diag = fs::read_to_string(dir.path().join("slot.golden/program.diag")).unwrap();
    assert!(diag.starts_with("line 12: error APT1050 6-7 P9"), "{diag}");
    change(dir.path(), "slot.apt", "APT1050 6-7", "APT1050 7-8");
    let (code, said) = test(dir.path(), &[]);
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("no message: line 12: error APT1050 7-8"), "{said}");
    assert!(said.contains("unexpected: line 12: error APT1050 6-7"), "{said}");
}
