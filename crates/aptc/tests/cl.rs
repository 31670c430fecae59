//! CL files through the program: long ones in little memory, subprograms, several parts, messages.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn aptc(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_aptc"));
    command.args(arguments).current_dir(folder).output().expect("the program starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("messages are UTF-8")
}

const HEAD: &str = "PARTNO BIG\nMACHIN/LINUXCNC\nUNITS/MM\nLOADTL/1\nSPINDL/RPM,3000,CLW\nCOOLNT/ON\n\
                    FEDRAT/900,MMPM\nCUTTER/10\n";

/// A range of so many moves that one COPY repeats.
fn long(n: u32) -> String {
    let mut out = format!("{HEAD}INDEX/1\n");
    for i in 0..n {
        let t = f64::from(i);
        let (x, y) = (t % 400.0 + t / 1e5, t % 311.0 - t / 1e6);
        writeln!(out, "GOTO/{x:.5},{y:.5},{:.3}", t % 7.0).expect("a string takes all");
    }
    out + "COPY/1,TRANSL,1,2,3,1\nFINI\n"
}

/// What is collected instead of passed on would not fit: 600,000 records are more than 100 MB.
#[cfg(target_os = "linux")]
#[test]
fn long_files_need_little_memory() {
    let dir = tempfile::tempdir().unwrap();
    let n = 300_000;
    fs::write(dir.path().join("long.cl"), long(n)).unwrap();
    for command in [
        "convert --edit long.cl -o copied.cl",
        "convert copied.cl --to clfile -o copied.clfile",
        "convert copied.clfile --to json -o copied.json",
        "cldiff copied.cl copied.clfile",
        "stats copied.json --json",
        "post --edit long.cl -o long.nc",
    ] {
        // Address space counts the program itself, which is large in this profile.
        let size = fs::metadata(env!("CARGO_BIN_EXE_aptc")).unwrap().len() / 1024;
        let limited =
            format!("ulimit -v {}; exec {} {command}", size + 72_000, env!("CARGO_BIN_EXE_aptc"));
        let run =
            Command::new("sh").args(["-c", &limited]).current_dir(dir.path()).output().unwrap();
        assert_eq!(run.status.code(), Some(0), "{command}: {}", text(&run.stderr));
        if command.starts_with("stats") {
            let figures: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
            assert_eq!(figures["points"], 2 * n);
        }
    }
    let blocks = fs::read_to_string(dir.path().join("long.nc")).unwrap().lines().count();
    assert!(blocks >= 2 * n as usize, "{blocks}");
}

#[test]
fn each_part_of_a_file_gets_its_code() {
    let dir = tempfile::tempdir().unwrap();
    let part = |x: u32| format!("{HEAD}GOTO/{x},0,0\nGOTO/0,{x},0\nFINI\n");
    fs::write(dir.path().join("two.cl"), format!("{}$$ between\n{}$$ after\n", part(5), part(7)))
        .unwrap();
    let run = aptc(dir.path(), &["post", "two.cl", "--setup", "--map"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    for (name, x) in [("two.nc", "X5"), ("two.2.nc", "X7")] {
        let code = fs::read_to_string(dir.path().join(name)).unwrap();
        assert!(code.contains(x), "{name}: {code}");
    }
    assert!(!dir.path().join("two.3.nc").exists());
    assert!(
        dir.path().join("two.setup.txt").is_file() && dir.path().join("two.nc.map.json").is_file()
    );
    let shown = aptc(dir.path(), &["post", "two.cl", "-o", "-"]);
    assert!(text(&shown.stdout).contains("X5") && text(&shown.stdout).contains("X7"));
    let left = fs::read_dir(dir.path()).unwrap().filter(|f| {
        f.as_ref().is_ok_and(|f| f.file_name().to_string_lossy().starts_with(".aptc-"))
    });
    assert_eq!(left.count(), 0);
}

#[test]
fn subprograms_go_where_they_are_called() {
    let dir = tempfile::tempdir().unwrap();
    let body = "DEFSUB/1\nGODLTA/0,0,-5\nGODLTA/0,0,5\nENDSUB\n";
    let file = format!("{HEAD}{body}GOTO/11,0,2\nCALSUB/1\nGOTO/21,0,2\nCALSUB/1\nFINI\n");
    fs::write(dir.path().join("sub.cl"), file).unwrap();
    let run = aptc(dir.path(), &["post", "sub.cl"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let code = fs::read_to_string(dir.path().join("sub.nc")).unwrap();
    assert_eq!(code.matches("Z-3").count(), 2, "{code}");
    assert!(code.find("X11").unwrap() < code.find("Z-3").unwrap(), "{code}");
}

/// Messages tell lines whether the text is kept or not; refused code is not written.
#[test]
fn messages_have_lines_in_long_files_too() {
    let dir = tempfile::tempdir().unwrap();
    let wrong = "GOTO/1,2,X\nFINI\n";
    let short = format!("{HEAD}{wrong}");
    let long = format!("{HEAD}{}{wrong}", "GOTO/1.5,2.5,3.5\n".repeat(300_000));
    for (file, line) in [(short, 9), (long, 300_009)] {
        fs::write(dir.path().join("bad.cl"), file).unwrap();
        fs::write(dir.path().join("bad.nc"), "good\n").unwrap();
        for command in ["post bad.cl", "convert bad.cl -o x.cl", "stats bad.cl"] {
            let args: Vec<&str> = command.split(' ').chain(["--message-format", "short"]).collect();
            let run = aptc(dir.path(), &args);
            assert_eq!(run.status.code(), Some(1), "{command}");
            let said = text(&run.stderr);
            assert!(
                said.contains(&format!("bad.cl:{line}:1: error[APT3001]")),
                "{command}: {said}"
            );
        }
        assert_eq!(fs::read_to_string(dir.path().join("bad.nc")).unwrap(), "good\n");
    }
}

#[test]
fn what_cannot_be_read_or_written_is_told() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("a.cl"), format!("{HEAD}GOTO/1,2,3\nFINI\n")).unwrap();
    fs::write(dir.path().join("cl.tap"), format!("{HEAD}GOTO/1,2,3\nFINI\n")).unwrap();
    for (command, why) in [
        ("post none.cl", "no such file"),
        ("post .", "no file"),
        ("post a.cl --from sanskrit", "no CL dialect"),
        ("convert a.cl -o no/such/x.cl", "cannot write no/such/x.cl: there is no such folder\n"),
        ("convert a.cl --to nx -o x.cls", "only read"),
        ("cldiff a.cl none.cl", "cannot read"),
    ] {
        let run = aptc(dir.path(), &command.split(' ').collect::<Vec<_>>());
        assert_eq!(run.status.code(), Some(2), "{command}");
        assert!(text(&run.stderr).contains(why), "{command}: {}", text(&run.stderr));
    }
}

#[test]
fn machine_code_is_compared_as_what_the_axes_do() {
    let dir = tempfile::tempdir().unwrap();
    let code = "G21 G90\nT1 M6\nG0 X0 Y0 Z5\nG1 X10 F100\nG0 Z9\nM30\n";
    fs::write(dir.path().join("a.nc"), code).unwrap();
    fs::write(dir.path().join("same.nc"), code.replace("X10 F100", "X4 F100\nX10")).unwrap();
    fs::write(dir.path().join("far.nc"), code.replace("X10", "X10 Y0.5")).unwrap();
    fs::write(dir.path().join("bad.nc"), code.replace("X10", "X1 X2")).unwrap();
    fs::write(dir.path().join("a.cl"), format!("{HEAD}GOTO/1,2,3\nFINI\n")).unwrap();
    fs::write(dir.path().join("cl.tap"), format!("{HEAD}GOTO/1,2,3\nFINI\n")).unwrap();
    for (command, exit, shown) in [
        ("cldiff a.nc same.nc", 0, "agree within 0.001 mm"),
        ("cldiff a.nc far.nc", 1, "first divergence: 0.49"),
        ("cldiff a.nc far.nc --tolerance 0.6", 0, "greatest deviation: 0.5"),
        ("cldiff a.nc far.nc --machine heidenhain-tnc", 1, ""),
        ("cldiff a.nc bad.nc", 1, ""),
        ("cldiff a.nc a.cl", 2, ""),
        ("cldiff a.cl cl.tap", 0, "agree"),
        ("cldiff a.nc a.nc --machine plough", 2, ""),
    ] {
        let run = aptc(dir.path(), &command.split(' ').collect::<Vec<_>>());
        assert_eq!(run.status.code(), Some(exit), "{command}: {}", text(&run.stderr));
        assert!(text(&run.stdout).contains(shown), "{command}: {}", text(&run.stdout));
    }
    // What could not be read does not agree.
    let run = aptc(dir.path(), &["cldiff", "bad.nc", "bad.nc"]);
    let said = text(&run.stdout);
    assert_eq!(run.status.code(), Some(1), "{said}");
    assert!(!said.contains("agree") && said.contains("bad.nc cannot be read"), "{said}");
    // Heidenhain's plain language is known by its first line, whatever the name ends in.
    let plain = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+0 Y+0 Z+5 R0 FMAX M3\n\
                 3 L X+10 F100\n4 END PGM A MM\n";
    fs::write(dir.path().join("plain.nc"), plain).unwrap();
    fs::write(dir.path().join("other.nc"), plain.replace("+10", "+11")).unwrap();
    for (other, exit, shown) in [("plain.nc", 0, "agree"), ("other.nc", 1, "deviation: 1.0")] {
        let run = aptc(dir.path(), &["cldiff", "plain.nc", other]);
        assert_eq!(run.status.code(), Some(exit), "{}", text(&run.stderr));
        assert!(text(&run.stdout).contains(shown), "{}", text(&run.stdout));
    }
    let run = aptc(dir.path(), &["cldiff", "a.nc", "far.nc", "--json"]);
    let found: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(found["first"]["line"], 4);
}

#[test]
fn only_cl_data_needs_no_machine() {
    let dir = tempfile::tempdir().unwrap();
    let part = |machin: &str| {
        format!("PARTNO BARE\n{machin}UNITS/MM\nCUTTER/10\nFROM/0,0,0\nGOTO/1,2,3\nFINI\n")
    };
    let run = |name: &str, machin: &str, emit: &str| {
        fs::write(dir.path().join(name), part(machin)).unwrap();
        let run = aptc(dir.path(), &["compile", name, "--emit", emit]);
        (run.status.code(), text(&run.stderr))
    };
    let (code, messages) = run("bare.apt", "", "cl");
    assert_eq!(code, Some(0), "{messages}");
    assert!(dir.path().join("bare.cl").exists());
    for (name, machin, emit) in [("mill.apt", "MACHIN/LINUXCNC\n", "cl"), ("bare.apt", "", "nc")] {
        let (code, messages) = run(name, machin, emit);
        assert_eq!(code, Some(1), "{messages}");
        assert!(messages.contains("APT4001"), "{messages}");
    }
}

/// A file that was cut short moves the tool less far than it should.
#[test]
fn a_file_without_its_end_is_told() {
    let dir = tempfile::tempdir().unwrap();
    let whole = format!("{HEAD}FROM/0,0,50\nGOTO/1,2,30\nGOTO/1,2,3\n");
    for (cl, told) in [
        (whole.clone(), true),
        (whole.clone() + "$$ a remark\nSPINDL/OFF\n", true),
        (whole.clone() + "FINI\n", false),
        (whole.clone() + "FINI\n$$ what follows says nothing\n", false),
        (whole.clone() + "FINI\n" + &whole, true),
        (format!("TOOL PATH/A,TOOL,B\n{whole}END-OF-PATH\n"), false),
        (whole + "END\n", false),
    ] {
        fs::write(dir.path().join("part.cl"), &cl).unwrap();
        let run = aptc(dir.path(), &["post", "part.cl", "--machine", "linuxcnc-mill"]);
        assert_eq!(text(&run.stderr).contains("APT3007"), told, "{cl}{}", text(&run.stderr));
    }
}
