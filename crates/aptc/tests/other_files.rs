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
        (
            "verify --nc x.cl --cl x.cl -m linuxcnc-mill",
            "cannot read x.cl: it is CL data or a part program, no machine code",
        ),
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

/// All names are asked, those of further programs, sheets and other inputs too, before the first is written.
#[test]
fn no_result_is_written_where_another_would_be_in_the_way() {
    let dir = folder();
    let file = |name: &str| dir.path().join(name);
    fs::write(file("mine.toml"), aptc(dir.path(), "machines haas-vf").stdout).expect("written");
    fs::write(file("w.2.nc"), [CL, CL].concat()).expect("it is written");
    let made = aptc(dir.path(), "convert x.cl --to json -o a.nc.map.json");
    assert_eq!(made.status.code(), Some(0), "{}", said(&made));
    fs::copy(file("p.apt"), file("p.lst")).expect("it is copied");
    fs::write(file("b.apt"), PART.replace("GOTO/50,0,-1", "GOTO/NONE")).expect("it is written");
    fs::write(file("b.partial.cl"), PART).expect("it is written");
    fs::write(file("i.apt"), PART.replace("RAPID", "INCLUD/'i.nc'")).expect("it is written");
    fs::write(file("i.nc"), "RAPID\n").expect("it is written");
    let all = || {
        let list = fs::read_dir(dir.path()).expect("it is there");
        let mut all: Vec<_> = list.map(|f| f.expect("it is there").path()).collect();
        all.sort();
        all.into_iter().map(|p| (fs::read(&p).expect("it is read"), p)).collect::<Vec<_>>()
    };
    let before = all();
    for (line, words) in [
        ("post x.cl -m mine.toml -o mine.toml", "mine.toml is the file of the machine"),
        ("post w.2.nc -o w.nc", "w.2.nc is what is posted"),
        ("post a.nc.map.json -o a.nc --map", "a.nc.map.json is what is posted"),
        ("b.apt b.partial.cl --keep-going", "b.partial.cl: it is a part program of this run"),
        ("p.lst", "cannot write ./p.lst: it is what was compiled"),
        ("i.apt", "cannot write ./i.nc: it is included in the program"),
    ] {
        let run = aptc(dir.path(), line);
        assert_eq!(run.status.code(), Some(2), "{line}: {}", said(&run));
        assert!(said(&run).contains(words), "{line}: {}", said(&run));
        assert!(all() == before, "{line}");
    }
}

#[test]
fn a_program_named_twice_is_compiled_once() {
    let dir = folder();
    for line in ["p.apt p.apt", "p.apt ./p.apt"] {
        let run = aptc(dir.path(), line);
        assert_eq!(run.status.code(), Some(0), "{line}: {}", said(&run));
        let shown = String::from_utf8_lossy(&run.stdout).into_owned();
        assert_eq!(shown.matches("wrote").count(), 1, "{line}: {shown}");
    }
}

/// What stands in the code as it is given brings nothing else into it.
#[test]
fn a_work_offset_is_one_code() {
    let dir = folder();
    for (code, good) in [("G55", true), ("G54.1P2", true), ("G54 M3", false), ("", false)] {
        let line = ["post", "x.cl", "-m", "linuxcnc-mill", "-o", "-", "--work-offset", code];
        let mut run = Command::new(env!("CARGO_BIN_EXE_aptc"));
        let run = run.args(line).current_dir(dir.path()).output().expect("the program starts");
        assert_eq!(run.status.success(), good, "{code}: {}", said(&run));
        assert_eq!(String::from_utf8_lossy(&run.stdout).contains(code) && !code.is_empty(), good);
    }
}

/// What is cut along surfaces is not in the machine code of a part program that is taken for CL data.
#[test]
fn a_part_program_without_definitions_is_not_posted() {
    let dir = folder();
    let part =
        |line: &str| PART.replace("L1=LINE/XAXIS", line).replace("GODLTA", "GORGT/L1\nGODLTA");
    fs::write(dir.path().join("inc.apt"), part("INCLUDE/GEOM")).expect("it is written");
    fs::write(dir.path().join("lab.apt"), part("10) L1=LINE/XAXIS")).expect("it is written");
    for (line, code, words) in [
        ("post inc.apt", 1, "this is a part program, compile it"),
        ("post lab.apt", 2, "it is a part program, no CL data"),
        ("stats inc.apt", 1, "this is a part program, compile it"),
    ] {
        let run = aptc(dir.path(), line);
        assert_eq!(run.status.code(), Some(code), "{line}: {}", said(&run));
        assert!(said(&run).contains(words), "{line}: {}", said(&run));
    }
    assert!(!dir.path().join("inc.nc").exists() && !dir.path().join("lab.nc").exists());
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
