//! The program beside others that do the same work, whole processes in processor time.
//!
//! `cargo bench -p aptc --bench peers`. What is wanted is the rate of the peer in the same run, so that the ratio is
//! ours to theirs. A peer that is not on the search path leaves its column empty: `apt360` (the port "aptos" of IBM's
//! system, built without optimisation as it asks to be: else its motions in space fail, soon and fast), `rs274` (LinuxCNC's interpreter, which only reads what we write and read back), `wc` (a scan for the ends of lines).

use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use aptc_testkit::{bench, client};

/// Least processor time that is measured: the system counts it in hundredths of a second.
const LEAST_SECONDS: f64 = 1.0;
/// Runs after which that must have come together.
const MOST_RUNS: f64 = 1e4;
/// Cut vectors of the CL file that is posted.
const MOVES: u32 = 200_000;

fn main() {
    let folder = std::env::temp_dir().join(format!("aptc-peers-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder for what is made");
    let part_programs = [
        ("smallest part program", "CUTTER/10\nFROM/0,0,0\nGOTO/1,2,3\n".to_owned()),
        ("200 circles of 168 cut vectors", circles(200)),
        ("30 passes of a ball over a sphere", passes(30)),
    ];
    for (name, text) in part_programs {
        part_program(&folder, name, &format!("PARTNO PEERS\n{text}FINI\n"));
    }
    cl_file(&folder);
    fs::remove_dir_all(&folder).expect("the folder is ours");
}

/// Full circles in a loop, within .005.
fn circles(n: u32) -> String {
    format!(
        "INTOL/.005\nOUTTOL/.005\nCUTTER/10\nC1=CIRCLE/0,0,0,50\nL1=LINE/XAXIS\nPL1=PLANE/0,0,1,0\nLOOPST\nK=0\n\
         A)K=K+1\nFROM/70,0,0\nINDIRV/-1,0,0\nGO/TO,C1,ON,PL1\nTLRGT,GORGT/C1,ON,2,INTOF,L1\nIF(K-{n})A,B,B\n\
         B)LOOPND\n"
    )
}

/// A ball over a sphere along a plane, within .00005.
fn passes(n: u32) -> String {
    format!(
        "INTOL/.00005\nOUTTOL/.00005\nCUTTER/10,5\nSP=SPHERE/0,0,0,50\nDP=PLANE/1,0,0,20\nP1=PLANE/0,1,0,-30\n\
         P2=PLANE/0,1,0,30\nLOOPST\nK=0\nA)K=K+1\nFROM/20,-60,60\nINDIRV/0,1,-.3\nGO/ON,DP,TO,SP,ON,P1\n\
         INDIRV/0,1,0\nTLON,GOFWD/DP,ON,P2\nIF(K-{n})A,B,B\nB)LOOPND\n"
    )
}

/// Source to CL data: ours without and with the proof, beside APT-360.
fn part_program(folder: &Path, name: &str, text: &str) {
    let source = folder.join("part.apt");
    fs::write(&source, text).expect("room for a part program");
    let peer = client("peers", "apt360").map(|apt360| {
        1.0 / seconds(|| {
            let mut command = Command::new(&apt360);
            command.current_dir(folder).stdin(File::open(&source).expect("it was written"));
            command
        })
    });
    for (how, verify) in [("", "off"), (", proved", "full")] {
        let rate = 1.0
            / seconds(|| {
                let mut command =
                    aptc(&["compile", "part.apt", "--emit", "cl", "--quiet", "--verify", verify]);
                command.current_dir(folder);
                command
            });
        bench::figure(&format!("beside APT-360: {name}{how}"), rate, "programs/s", peer);
    }
}

/// A large CL file: converted beside a scan of its lines, posted and read back beside a control that reads.
fn cl_file(folder: &Path) {
    let cl = folder.join("long.cl");
    let megabytes = write_path(&cl);
    let wc = client("peers", "wc")
        .map(|wc| megabytes / seconds(|| with(Command::new(&wc), &["-l", "long.cl"], folder)));
    let convert = seconds(|| {
        with(aptc(&[]), &["convert", "long.cl", "--to", "iso", "--output", "copy.cl"], folder)
    });
    bench::figure("beside a scan of lines: convert CL data", megabytes / convert, "MB/s", wc);
    let post = seconds(|| {
        with(aptc(&[]), &["post", "long.cl", "--machine", "linuxcnc-mill", "--quiet"], folder)
    });
    let code = folder.join("long.nc");
    let control = client("peers", "rs274").map(|rs274| {
        let tools: PathBuf = folder.join("tool.tbl");
        let variables = folder.join("rs274.var");
        fs::write(&tools, "T1 P1 D0 Z0 ;\n").expect("room for a line");
        let read = seconds(|| {
            let mut command = Command::new(&rs274);
            command.env("HOME", folder).args(["-g", "-n", "2", "-t"]).arg(&tools);
            // A program's offsets would leak into the next one.
            fs::write(&variables, "").expect("room for nothing");
            command.arg("-v").arg(&variables).arg(&code);
            command
        });
        f64::from(MOVES) / 1e6 / read
    });
    let rate = f64::from(MOVES) / 1e6 / post;
    bench::figure("beside rs274, which reads only: post and read back", rate, "M lines/s", control);
}

/// A surface-like path in ISO 4343; its size in megabytes.
fn write_path(file: &Path) -> f64 {
    let mut text =
        String::from("PARTNO/LONG\nUNITS/MM\nLOADTL/1\nSPINDL/9000,CLW\nFEDRAT/2000,MMPM\n");
    for i in 0..MOVES {
        let t = f64::from(i) * 0.37;
        let u = (t / 60.0).rem_euclid(2.0) - 1.0;
        let (x, y, z) =
            (t % 185.0, f64::from(i / 500) * 0.5, 3.0 * (1.0 - u * u) * (1.0 - u * u) - 10.0);
        writeln!(text, "GOTO/{x:.4},{y:.4},{z:.4}").expect("a string takes all");
    }
    text.push_str("FINI\n");
    fs::write(file, &text).expect("room for a CL file");
    f64::from(u32::try_from(text.len()).expect("some megabytes")) / 1e6
}

fn aptc(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_aptc"));
    command.args(arguments);
    command
}

fn with(mut command: Command, arguments: &[&str], folder: &Path) -> Command {
    command.args(arguments).current_dir(folder);
    command
}

/// Processor seconds of one run, over as many as the clock needs.
fn seconds(command: impl Fn() -> Command) -> f64 {
    let (start, mut runs) = (bench::children_seconds(), 0.0);
    loop {
        let mut command = command();
        let status = command.stdout(Stdio::null()).stderr(Stdio::null()).status();
        assert!(status.is_ok_and(|status| status.success()), "{command:?} failed");
        runs += 1.0;
        assert!(runs < MOST_RUNS, "the system tells no processor time");
        let spent = bench::children_seconds() - start;
        if spent >= LEAST_SECONDS {
            return spent / runs;
        }
    }
}
