//! LinuxCNC's interpreter without the machine: reads machine code as the control would.
//!
//! `rs274` prints what a program makes the machine do as canonical calls. A program is accepted when it
//! ends well, complains of nothing and reaches its end: a truncated one ends well too.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// A canonical call: `STRAIGHT_FEED(10.0000, 0.0000, ...)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// Its name.
    pub name: String,
    /// Its arguments that are numbers, in order. Lengths are in the unit that the program set.
    pub numbers: Vec<f64>,
    /// The arguments as written.
    pub text: String,
}

/// Runs a program through the interpreter; tools 1 to 99 are known, with length and diameter 0.
///
/// # Errors
/// When the interpreter rejects the program, with its words; when it cannot be started.
pub fn interpret(rs274: &Path, program: &Path) -> Result<Vec<Call>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let (tools, variables) = (folder.path().join("tool.tbl"), folder.path().join("rs274.var"));
    let table = (1..100).fold(String::new(), |mut table, tool| {
        writeln!(table, "T{tool} P{tool} D0 Z0 ;").expect("a string takes all");
        table
    });
    // The parameters are a fresh file: a program's offsets would leak into the next one.
    let written = fs::write(&tools, table).and_then(|()| fs::write(&variables, ""));
    written.map_err(|error| format!("{}: {error}", folder.path().display()))?;
    // The interpreter keeps its tools in a file of the home folder: two runs at once would destroy it.
    let output = Command::new(rs274)
        .env("HOME", folder.path())
        .args(["-g", "-n", "2", "-t"])
        .arg(&tools)
        .arg("-v")
        .arg(&variables)
        .arg(program)
        .stdin(Stdio::null())
        .output()
        .map_err(|error| format!("{}: {error}", rs274.display()))?;
    let complaints = String::from_utf8_lossy(&output.stderr);
    let complaints: Vec<&str> =
        complaints.lines().filter(|line| !line.is_empty() && *line != "executing").collect();
    let calls: Vec<Call> =
        String::from_utf8_lossy(&output.stdout).lines().filter_map(call).collect();
    if !output.status.success() || !complaints.is_empty() {
        return Err(format!("{}: {}", program.display(), complaints.join(": ")));
    }
    if !calls.iter().any(|call| call.name == "PROGRAM_END") {
        return Err(format!("{}: the program has no end", program.display()));
    }
    Ok(calls)
}

/// A line such as `   20 N..... STRAIGHT_TRAVERSE(0.0000, 0.0000, 5.0000, 0.0000, 0.0000, 0.0000)`.
fn call(line: &str) -> Option<Call> {
    let (head, rest) = line.split_once('(')?;
    let name = head.split_whitespace().last()?.to_owned();
    let text = rest.rsplit_once(')').map_or(rest, |(arguments, _)| arguments).to_owned();
    let numbers = text.split([',', ' ']).filter_map(|number| number.parse().ok()).collect();
    Some(Call { name, numbers, text })
}

#[cfg(test)]
mod tests {
    use super::*;

    const PART: &str = "%\nG21 G17 G90 G40 G49 G80\nT1 M6\nS2000 M3\nG43 H1\nG0 X0 Y0 Z5\n\
                        G1 Z-1 F100\nG2 X10 Y0 I5 J0\nG0 Z50\nM5\nM2\n%\n";

    fn run(test: &str, text: &str) -> Option<Result<Vec<Call>, String>> {
        let rs274 = aptc_testkit::client(test, "rs274")?;
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("part.ngc");
        fs::write(&file, text).unwrap();
        Some(interpret(&rs274, &file))
    }

    #[test]
    fn the_control_reads_a_good_program() {
        let Some(answer) = run("rs274::the_control_reads_a_good_program", PART) else { return };
        let calls = answer.unwrap();
        let arc = calls.iter().find(|call| call.name == "ARC_FEED").unwrap();
        assert_eq!(arc.numbers, [10.0, 0.0, 5.0, 0.0, -1.0, -1.0, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn the_control_rejects_broken_programs() {
        let broken = [
            ("no feed", PART.replace(" F100", "")),
            ("arc whose radii differ", PART.replace("I5", "I4")),
            ("two motions in a block", PART.replace("G1 Z-1", "G0 G1 Z-1")),
            ("no end", PART.replace("M2\n%\n", "")),
            ("no number", PART.replace("Z-1", "Z")),
        ];
        for (what, text) in broken {
            assert_ne!(text, PART, "{what}");
            let Some(answer) = run("rs274::the_control_rejects_broken_programs", &text) else {
                return;
            };
            assert!(answer.is_err(), "{what} was accepted");
        }
    }
}
