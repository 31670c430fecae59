//! Files of another kind than the one that was meant, and results that would take the place of what they are made of.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const PART: &str = "PARTNO SLOT\nUNITS/MM\nL1=LINE/XAXIS\nLOADTL/1\nSPINDL/1000,CLW\nFEDRAT/100,MMPM\nCUTTER/6\n\
                    FROM/0,0,10\nGOTO/0,0,-1\nGOTO/50,0,-1\nRAPID\nGODLTA/0,0,20\nFINI\n";
const CL: &str = "PARTNO SLOT\nUNITS/MM\nLOADTL/1\nSPINDL/1000,CLW\nCOOLNT/ON\nFEDRAT/100,MMPM\nRAPID\nGOTO/0,0,10\n\
                  GOTO/0,0,-1\nGOTO/50,0,-1\nFINI\n";
const CODE: &str = "%\nO100\nG21\nG17 G40 G80\nT1 M6\nG0 X0 Y0\nG1 Z-1 F100\nM30\n%\n";

fn aptc(folder: &Path, line: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_aptc"))
        .args(line.split(' '))
        .current_dir(folder)
        .output()
        .expect("the program starts")
}

fn folder() -> tempfile::TempDir {
    let dir = tempfile::tempdir().expect("a folder");
    let files: [(&str, &[u8]); 8] = [
        ("p.apt", PART.as_bytes()),
        ("x.cl", CL.as_bytes()),
        ("x.nc", CODE.as_bytes()),
        ("x.svg", b"<svg xmlns=\"http://www.w3.org/2000/svg\">\n</svg>\n"),
        ("blank.txt", b"\r\n \n"),
        ("words.txt", b"HELLO WORLD\nTHIS IS A TEXT\n"),
        ("bad.toml", b"name = \"bad\"\n[format\n"),
        ("wide.apt", &[]),
    ];
    for (name, bytes) in files {
        fs::write(dir.path().join(name), bytes).expect("it is written");
    }
    let wide =
        PART.replace('\n', "\r\n").encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<_>>();
    fs::write(dir.path().join("wide.apt"), [&[0xff, 0xfe], &wide[..]].concat())
        .expect("it is written");
    dir
}

fn said(run: &Output) -> String {
    String::from_utf8_lossy(&run.stderr).into_owned()
}

/// One line, exit code 2, and no file changed or made.
#[test]
fn a_file_of_another_kind_is_refused_in_one_line() {
    let dir = folder();
    let before = fs::read_dir(dir.path()).expect("it is there").count();
    for (line, words) in [
        ("x.nc", "cannot read x.nc: it is machine code, no part program"),
        ("check x.svg", "it is a drawing or a page (SVG, HTML, XML), no part program"),
        ("blank.txt", "cannot read blank.txt: it is empty"),
        ("fmt x.nc", "it is machine code, no part program"),
        ("verify x.nc", "it is machine code, no part program"),
        ("copmile p.apt", "did you mean the command compile?"),
        ("post p.apt", "it is a part program, no CL data; `aptc p.apt` compiles it"),
        ("post x.nc", "it is machine code, no CL data"),
        ("post blank.txt", "it is empty"),
        ("post words.txt -q", "no machine code comes of words.txt"),
        ("stats x.nc", "it is machine code, no CL data"),
        ("stats no.cl", "cannot read no.cl: there is no such file"),
        ("convert x.svg -o y.cl", "it is a drawing or a page (SVG, HTML, XML), no CL data"),
        ("cldiff x.cl p.apt", "it is a part program, no CL data"),
        ("verify p.apt --cl x.nc", "it is machine code, no CL data"),
        ("post x.cl -m nosuch", "there is no machine nosuch"),
        ("post x.cl -m p.apt", "the name of a machine file ends in .toml"),
    ] {
        let run = aptc(dir.path(), line);
        let said = said(&run);
        assert_eq!(run.status.code(), Some(2), "{line}: {said}");
        let told = said.lines().filter(|l| l.starts_with("aptc: ")).count();
        assert!(said.contains(words) && (told == 1 || line.starts_with("copm")), "{line}: {said}");
    }
    // The second name of the misspelt command is a part program, and was compiled.
    let made = ["cl", "nc", "lst", "svg"].map(|e| format!("p.{e}"));
    for name in &made {
        fs::remove_file(dir.path().join(name)).expect("it was made");
    }
    assert_eq!(fs::read_dir(dir.path()).expect("it is there").count(), before);
    assert_eq!(fs::read(dir.path().join("x.nc")).expect("it is there"), CODE.as_bytes());
}

#[test]
fn no_result_takes_the_place_of_what_it_is_made_of() {
    let dir = folder();
    fs::create_dir(dir.path().join("more")).expect("a folder");
    fs::copy(dir.path().join("p.apt"), dir.path().join("more/p.apt")).expect("it is copied");
    for (line, words) in [
        ("post x.cl -o x.cl", "x.cl is what is posted"),
        ("post x.cl -o ./more/../x.cl", "is what is posted"),
        ("convert x.cl -o x.cl", "x.cl is what is converted"),
        ("x.cl", "cannot write ./x.cl: it is what was compiled"),
        ("p.apt more/p.apt", "p.apt and more/p.apt would both be written to ./p.*"),
    ] {
        let run = aptc(dir.path(), line);
        assert_eq!(run.status.code(), Some(2), "{line}: {}", said(&run));
        assert!(said(&run).contains(words), "{line}: {}", said(&run));
    }
    assert_eq!(fs::read(dir.path().join("x.cl")).expect("it is there"), CL.as_bytes());
    assert!(!dir.path().join("p.cl").exists());
}

#[test]
fn what_is_wrong_with_a_machine_file_is_shown_in_it_and_nothing_is_compiled() {
    let dir = folder();
    for line in ["p.apt -m bad.toml", "post x.cl -m bad.toml", "machines bad.toml"] {
        let run = aptc(dir.path(), line);
        assert_eq!(run.status.code(), Some(1), "{line}: {}", said(&run));
        assert!(said(&run).contains("bad.toml:2:8"), "{line}: {}", said(&run));
    }
    assert!(!dir.path().join("p.cl").exists());
}

/// A machine that is built in is printed as the file with which one's own begins.
#[test]
fn the_file_of_a_machine_is_printed_and_is_one() {
    let dir = folder();
    let run = aptc(dir.path(), "machines haas-vf");
    fs::write(dir.path().join("mine.toml"), &run.stdout).expect("it is written");
    let run = aptc(dir.path(), "machines mine.toml");
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let posted = aptc(dir.path(), "post x.cl -m mine.toml -o -");
    assert_eq!(posted.stdout, aptc(dir.path(), "post x.cl -m haas-vf -o -").stdout);
}

#[test]
fn a_part_program_in_utf16_is_read_and_one_bad_file_stops_no_other() {
    let dir = folder();
    let run = aptc(dir.path(), "check wide.apt");
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let run = aptc(dir.path(), "fmt x.nc no.apt wide.apt");
    assert_eq!(run.status.code(), Some(2));
    assert_eq!(said(&run).lines().count(), 2, "{}", said(&run));
    let text = fs::read_to_string(dir.path().join("wide.apt")).expect("it is UTF-8 now");
    assert!(text.starts_with("PARTNO SLOT"), "{text}");
}
