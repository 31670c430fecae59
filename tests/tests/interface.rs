//! The program from outside: what its files hold, letter for letter, and what it says and returns.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const HEAD: &str =
    "MACHIN/LINUXCNC\nUNITS/MM\nLOADTL/1\nSPINDL/1000,CLW\nCOOLNT/ON\nFEDRAT/100,MMPM\n";

fn aptc(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(aptc_testkit::aptc());
    command.args(arguments).current_dir(folder).output().expect("the program starts")
}

fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let dir = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        fs::write(dir.path().join(name), text).expect("it is written");
    }
    dir
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn said(run: &Output) -> String {
    String::from_utf8_lossy(&run.stderr).into_owned()
}

/// CL text of a program, compiled without messages.
fn cl(text: &str) -> String {
    let dir = folder(&[("x.apt", text)]);
    let run = aptc(dir.path(), &["compile", "x.apt", "--emit", "cl"]);
    assert_eq!((run.status.code(), said(&run).as_str()), (Some(0), ""), "{text}");
    read(dir.path(), "x.cl")
}

/// Positions of CL text, with the `$$ LINE` above each.
fn positions(cl: &str) -> Vec<(String, String)> {
    let mut line = String::new();
    let mut found = Vec::new();
    for text in cl.lines() {
        if let Some(rest) = text.strip_prefix("$$ LINE ") {
            rest.clone_into(&mut line);
        } else if let Some((_, at)) =
            text.split_once('/').filter(|(word, _)| ["GOTO", "FROM"].contains(word))
        {
            found.push((line.clone(), at.to_owned()));
        }
    }
    found
}

/// The program asks for the points of INTSEC, for cut vectors that CLDAT recorded, and for the last motion.
#[test]
fn cut_vectors_come_back_to_the_program() {
    let flat = "PARTNO BACK\nNOPOST\nUNITS/MM\nS=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(10,0,0),SPLINE,(0,10,0),(10,10,0)\n\
                L=LINE/4,0,4,10\nCUTTER/6,3\nFROM/20,5,9\n";
    let cut = "CLDAT/START,1,PDS,NPS,UVPPS\nINTSEC/L,WITH,S\nCLDAT/NOMORE,1\n\
               GOTO/(CLDATF(1,UPS,2)),(CLDATF(1,PPS,2)),0\n\
               GOTO/(POINT/CLDATA,1,TP,1)\nGOTO/(POINT/CLDATA,1,PDS,NUMF(CLDATA,1))\n\
               GODLTA/(VECTOR/CLDATA,1,NPS,1)\nGODLTA/(VECTOR/CLDATA,1,TV,1)\n";
    let along = "GOTO/20,5,9\nCLDAT/START,2,PPS,PDS\nGO/TO,L,TO,S\nGORGT/L,TO,(LINE/0,20,1,20)\nCLDAT/NOMORE,2\n\
                 GOTO/(POINT/CLDATA,2,PPS,1)\nGOTO/(POINT/CLDATA,2,PDS,2)\n\
                 GOTO/(NUMF(CLDATA)),0,0\nGODLTA/(VECTOR/CLDATA,1)\n\
                 CLDAT/START,3,UVPPS,PPS,NPS\nGOLOFT/S,UCONST,.25,START,.5,INCR,.5\nCLDAT/NOMORE,3\n\
                 GOTO/(POINT/CLDATA,3,PPS,1)\nGOTO/(CLDATF(3,UPS,2)),(CLDATF(3,VPS,2)),(NUMF(CLDATA,3))\n\
                 GODLTA/(VECTOR/CLDATA,3,NPS,2)\n";
    // What moved within a reference system is found there again.
    let within = "REFSYS/(MATRIX/TRANSL,100,0,0)\nGOTO/-80,5,9\nCLDAT/START,4,PPS\nGO/TO,(LINE/-96,0,-96,10),TO,S\n\
                  CLDAT/NOMORE,4\nGOTO/(POINT/CLDATA,4,TP,1)\nGOTO/(POINT/CLDATA,2,PDS,2)\nREFSYS/NOMORE\n\
                  GOTO/(POINT/CLDATA,4,TP,1)\nFINI\n";
    let dir = folder(&[("x.apt", &format!("{flat}{cut}{along}{within}"))]);
    let run = aptc(dir.path(), &["compile", "x.apt", "--emit", "cl"]);
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let text = read(dir.path(), "x.cl");
    let found: Vec<String> = positions(&text).into_iter().map(|p| p.1).collect();
    let numbers: Vec<Vec<f64>> = found
        .iter()
        .map(|p| p.split(',').map(|x| x.parse().expect("a number")).collect())
        .collect();
    let wanted = [
        [20.0, 5.0, 9.0],
        [0.4, 1.0, 0.0],
        [4.0, 10.0, 0.0],
        [4.0, 0.0, 0.0],
        [4.0, 0.0, 1.0],
        [4.0, -1.0, 1.0],
        [20.0, 5.0, 9.0],
        [7.0, 5.0, 0.0],
        [4.0, 17.0, 3.0],
        [1.0, 0.0, 0.0],
        [1.0, 0.0, 1.0],
        [2.5, 5.0, 0.0],
        [0.25, 1.0, 2.0],
        [0.25, 1.0, 3.0],
        [-80.0, 5.0, 9.0],
        [-93.0, 5.0, 0.0],
        [-96.0, 17.0, 3.0],
        [7.0, 5.0, 0.0],
    ];
    assert_eq!(numbers.len(), wanted.len(), "{text}");
    for (got, want) in numbers.iter().zip(wanted) {
        assert!(got.iter().zip(want).all(|(a, b)| (a - b).abs() < 0.015), "{got:?} {want:?}");
    }
    assert!(said(&run).contains("APT2052"));
}

#[test]
fn each_motion_knows_its_line_also_in_macros_files_and_copies() {
    let main = "PARTNO LINES\nNOPOST\nUNITS/MM\nM=MACRO/X\nGOTO/X,0,0\nTERMAC\nFROM/0,0,9\nINDEX/1\n\
                CALL/M,X=4\nINCLUD/UP\nCOPY/1,TRANSL,0,7,0,1\nGOTO/$\n1,1,1\nFINI\n";
    let dir = folder(&[("x.apt", main), ("UP.mac", "$$ UP\nGODLTA/0,0,1\n")]);
    let run = aptc(dir.path(), &["compile", "x.apt", "--emit", "cl"]);
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let text = read(dir.path(), "x.cl");
    let found = positions(&text);
    let found: Vec<(&str, &str)> = found.iter().map(|(l, p)| (l.as_str(), p.as_str())).collect();
    let expected = [
        ("7", "0,0,9"),
        ("5", "4,0,0"),
        ("2 FILE UP", "4,0,1"),
        ("5", "4,7,0"),
        ("2 FILE UP", "4,7,1"),
        ("12", "1,1,1"),
    ];
    assert_eq!(found, expected, "{text}");
    assert!(text.lines().any(|line| line == "UNITS/MM"), "{text}");
}

#[test]
fn a_circle_stands_before_its_points_and_the_axis_behind_positions() {
    let program = "PARTNO ROUND\nNOPOST\nUNITS/MM\nC1=CIRCLE/10,20,30\nCUTTER/10\nOUTTOL/.1\nFROM/60,20,0\n\
                   GO/TO,C1\nTLRGT,GORGT/C1,ON,2,INTOF,(LINE/0,20,1,20)\nFINI\n";
    let text = cl(program);
    let lines: Vec<&str> = text.lines().collect();
    let circle = lines.iter().position(|line| line.starts_with("$$ CIRCLE ")).expect("a circle");
    assert!(lines[circle].starts_with("$$ CIRCLE 10,20,0,0,0,1,35"), "{text}");
    assert!(lines[circle + 1].starts_with("GOTO/") && lines[circle - 2].starts_with("$$ LINE 9"));
    let axes =
        cl("PARTNO AXIS\nNOPOST\nUNITS/MM\nMULTAX\nFROM/1,2,3,0,0,1\nGOTO/4,5,6,1,0,0\nFINI\n");
    assert!(axes.contains("FROM/1,2,3,0,0,1\n") && axes.contains("GOTO/4,5,6,1,0,0\n"), "{axes}");
    let form = cl(
        "PARTNO FORM\nNOPOST\nUNITS/MM\nPL=PLANE/0,0,1,5\nCLRSRF/PL\nCLRSRF/(PLANE/0,0,1,7)\nFINI\n",
    );
    assert!(form.contains("CLRSRF/PL,0,0,0,1,5\n"), "{form}");
    assert!(form.contains("CLRSRF/0,0,0,0,1,7\n"), "{form}");
}

#[test]
fn geometry_is_the_last_value_of_each_name() {
    let program = "PARTNO FORMS\nNOPOST\nUNITS/MM\nRESERV/Q,2\nq(1)=POINT/1,2,3\nQ(2)=POINT/4,5\n\
                   CANON/ON\nC1=CIRCLE/0,0,1\nC1=CIRCLE/5,6,2\nROW=PATERN/LINEAR,Q(1),Q(2),2\n\
                   M=MACRO/P\nLOCAL/INNER\nINNER=LINE/P,(POINT/9,9)\nTERMAC\nCALL/M,P=Q(1)\n\
                   REFSYS/(MATRIX/TRANSL,100,0,0)\nPR=POINT/1,1,1\nREFSYS/NOMORE\nFINI\n";
    let dir = folder(&[("x.apt", program)]);
    let run = aptc(dir.path(), &["compile", "x.apt", "--emit", "geometry"]);
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let forms: BTreeMap<String, serde_json::Value> =
        serde_json::from_str(&read(dir.path(), "x.geometry.json")).expect("one object");
    let names: Vec<&str> = forms.keys().map(String::as_str).collect();
    assert_eq!(names, ["C1", "PR", "Q(1)", "Q(2)", "ROW"]);
    let shown = forms["C1"].to_string();
    assert!(shown.contains("5.0") && shown.contains("6.0") && shown.contains("2.0"), "{shown}");
    assert_eq!(forms["ROW"]["points"].as_array().map(Vec::len), Some(2));
    assert!(forms["PR"].to_string().contains("101.0"), "{}", forms["PR"]);
}

#[test]
fn a_numeric_part_program_goes_on_at_section_2() {
    let program = format!("PARTNO A\n{HEAD}CUTTER/10\nFROM/0,0,9\nGOTO/1,2,3\nFINI\n");
    let dir = folder(&[("x.apt", &program)]);
    aptc(dir.path(), &["compile", "x.apt", "--emit", "protap,cl,nc"]);
    let (first, code) = (read(dir.path(), "x.cl"), read(dir.path(), "x.nc"));
    let run = aptc(dir.path(), &["compile", "x.protap", "-o", "again", "--emit", "cl,nc"]);
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    assert_eq!(read(dir.path(), "again/x.cl"), first);
    assert_eq!(read(dir.path(), "again/x.nc"), code);
}

#[test]
fn binary_records_are_those_of_the_text() {
    let Some(tool) =
        aptc_testkit::shared("interface::binary_records_are_those_of_the_text", "tools/cl360.py")
    else {
        return;
    };
    let program =
        format!("PARTNO A\n{HEAD}CUTTER/10\nFROM/0,0,9\nGOTO/1,2,3\nGOTO/4,5,-6.25\nFINI\n");
    let dir = folder(&[("x.apt", &program)]);
    let run = aptc(dir.path(), &["compile", "x.apt", "--emit", "cltape"]);
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let decoded = Command::new("python3").arg(tool).arg(dir.path().join("x.cltape")).output();
    let decoded = decoded.expect("python starts");
    let records: Vec<serde_json::Value> = serde_json::from_slice(&decoded.stdout)
        .unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&decoded.stderr)));
    let points: Vec<String> = records
        .iter()
        .filter(|r| r["points"].is_array())
        .map(|r| r["points"].to_string())
        .collect();
    assert_eq!(points, ["[[0.0,0.0,9.0]]", "[[1.0,2.0,3.0]]", "[[4.0,5.0,-6.25]]"]);
    let posts = records.iter().filter(|r| r["kind"] == "post").count();
    assert!(posts >= 5, "{records:?}");
}

#[test]
fn several_files_and_several_programs_in_a_file_run_in_order() {
    let one = |name: &str, x: i32| format!("PARTNO {name}\n{HEAD}FROM/0,0,9\nGOTO/{x},0,0\nFINI\n");
    let both = one("FIRST", 1) + &one("SECOND", 2);
    let dir = folder(&[("a.apt", &both), ("b.apt", &one("THIRD", 3))]);
    let run = aptc(dir.path(), &["compile", "a.apt", "b.apt", "-o", "out"]);
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let text = read(dir.path(), "out/a.cl");
    assert!(text.find("GOTO/1,0,0") < text.find("PARTNO SECOND"), "{text}");
    assert!(text.find("PARTNO SECOND") < text.find("GOTO/2,0,0"), "{text}");
    assert!(read(dir.path(), "out/a.nc").contains("X1"));
    assert!(read(dir.path(), "out/a.2.nc").contains("X2"));
    assert!(read(dir.path(), "out/b.nc").contains("X3"));
    let post = aptc(dir.path(), &["post", "out/a.cl", "-o", "again.nc"]);
    assert_eq!(post.status.code(), Some(0), "{}", said(&post));
    assert_eq!(read(dir.path(), "again.nc"), read(dir.path(), "out/a.nc"));
    assert_eq!(read(dir.path(), "again.2.nc"), read(dir.path(), "out/a.2.nc"));
}

#[test]
fn words_choose_the_sections() {
    let made = |word: &str| -> Vec<&str> {
        let program = format!("PARTNO A\n{word}\n{HEAD}FROM/0,0,9\nGOTO/1,2,3\nFINI\n");
        let dir = folder(&[("x.apt", &program)]);
        let run = aptc(dir.path(), &["x.apt"]);
        assert_eq!(run.status.code(), Some(0), "{word}: {}", said(&run));
        ["cl", "nc", "lst", "svg"]
            .into_iter()
            .filter(|ending| dir.path().join(format!("x.{ending}")).exists())
            .collect()
    };
    assert_eq!(made("$$"), ["cl", "nc", "lst", "svg"]);
    assert_eq!(made("NOPOST"), ["cl", "lst", "svg"]);
    assert_eq!(made("NOPLOT"), ["cl", "nc", "lst"]);
    // There is no CL data of an earlier run to take: all motion is computed.
    for sections in ["PTONLY/1", "PTONLY/2", "PTONLY/3,12"] {
        assert_eq!(made(sections), ["cl", "nc", "lst", "svg"], "{sections}");
    }
}

#[test]
fn where_the_post_must_refuse_cl_and_listing_are_written() {
    let refused = [
        ("APT4001", "FEDRAT/100,MMPM\n", ""),
        ("APT4005", "GOTO/1,2,3\n", "CYCLE/DRILL,CLEAR,2\nGOTO/1,2,3\nCYCLE/OFF\n"),
        ("APT4006", "COOLNT/ON\n", "COOLNT/ON\nCLAMP/ON\nROTABL/90\n"),
    ];
    for (code, from, to) in refused {
        let program = format!("PARTNO A\n{HEAD}FROM/0,0,9\nGOTO/1,2,3\nFINI\n");
        assert!(program.contains(from));
        let dir = folder(&[("x.apt", &program.replace(from, to))]);
        let run = aptc(dir.path(), &["x.apt", "--message-format", "short", "--quiet"]);
        assert_eq!(run.status.code(), Some(1), "{code}: {}", said(&run));
        let told: Vec<String> = said(&run).lines().map(str::to_owned).collect();
        assert!(told.len() == 1 && told[0].contains(code), "{code}: {told:?}");
        let made =
            ["cl", "lst", "nc"].map(|ending| dir.path().join(format!("x.{ending}")).exists());
        assert_eq!(made, [true, true, false], "{code}");
    }
}

#[test]
fn a_terminal_shows_colours_and_progress_unless_told_otherwise() {
    let Some(script) =
        aptc_testkit::client("interface::a_terminal_shows_colours_and_progress", "script")
    else {
        return;
    };
    let dir = folder(&[
        ("bad.apt", "PARTNO A\nGOTO/P9\nFINI\n"),
        ("long.apt", "PARTNO A\nI=0\nA) I=I+1\nJUMPTO/A\nFINI\n"),
    ]);
    let on_terminal = |arguments: &str, no_color: bool| -> String {
        let line = format!("{} {arguments}", aptc_testkit::aptc().display());
        let mut command = Command::new(&script);
        command.args(["-qec", &line, "/dev/null"]).current_dir(dir.path()).env("TERM", "xterm");
        if no_color {
            command.env("NO_COLOR", "1");
        } else {
            command.env_remove("NO_COLOR");
        }
        String::from_utf8_lossy(&command.output().expect("script starts").stdout).into_owned()
    };
    let coloured = |text: &str| text.contains("\u{1b}[3");
    assert!(coloured(&on_terminal("check bad.apt", false)));
    assert!(!coloured(&on_terminal("check bad.apt", true)));
    assert!(!coloured(&on_terminal("check bad.apt --color never", false)));
    let long = "check long.apt --max-seconds 1.5 --max-statements 99999999999";
    assert!(on_terminal(long, false).contains("long.apt, "), "a bar after a second");
    assert!(!on_terminal(&format!("{long} --quiet"), false).contains("long.apt, "));
    assert!(!on_terminal("check bad.apt", false).contains("bad.apt, "), "none within a second");
    let run = aptc(dir.path(), &long.split(' ').collect::<Vec<_>>());
    assert!(!said(&run).contains("long.apt, "), "none into a pipe");
}

#[test]
fn exit_codes_are_as_documented() {
    let good = format!("PARTNO A\n{HEAD}FROM/0,0,9\nGOTO/1,2,3\nFINI\n");
    let dir = folder(&[("good.apt", &good), ("bad.apt", "PARTNO A\nGOTO/P9\nFINI\n")]);
    let code = |arguments: &[&str]| aptc(dir.path(), arguments).status.code();
    assert_eq!(code(&["good.apt"]), Some(0));
    assert_eq!(code(&["check", "good.apt"]), Some(0));
    assert_eq!(code(&["bad.apt"]), Some(1));
    assert_eq!(code(&["check", "bad.apt"]), Some(1));
    assert_eq!(code(&["check", "bad.apt", "good.apt"]), Some(1));
    assert_eq!(code(&["none.apt"]), Some(2));
    assert_eq!(code(&["good.apt", "--no-such-flag"]), Some(2));
    assert_eq!(code(&["good.apt", "-o", "good.apt/in/a/file"]), Some(2));
    assert_eq!(code(&["good.apt", "--machine", "none.toml"]), Some(2));
    assert_eq!(code(&["good.apt", "-I", "nowhere"]), Some(2));
    assert_eq!(code(&["good.apt", "-I", "."]), Some(0));
    assert_eq!(code(&["machines"]), Some(0));
}
