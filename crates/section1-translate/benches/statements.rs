//! How many statements a core executes in a second.
//!
//! `cargo bench -p aptc-translate`. A loop of a million executed statements that defines points, in full
//! with reading the text and giving out the records; it shall take two seconds and a GiB at most.

use aptc_protap::Outcome;
use aptc_testkit::bench;
use aptc_translate::{Interpreter, NoFiles, Options, Step};

/// Passes of the loop, each of five statements; the array holds a point for each.
const PASSES: u32 = 200_000;

fn executed(text: &str) -> u64 {
    let mut files = NoFiles;
    let mut program = Interpreter::new("bench.apt", text, &mut files, Options::default());
    while let Step::Record(_) = program.step() {
        program.outcome(Outcome::None);
    }
    assert_eq!(program.n_errors(), 0, "the program of the bench has errors");
    program.n_executed()
}

fn main() {
    let points = format!(
        "RESERV/P,{PASSES}\nI=0\nLOOPST\nA) I=I+1\nX=I*.5\nP(I)=POINT/X,(X+I),3\n\
         IF(I-{PASSES})B,C,C\nB) JUMPTO/A\nC) LOOPND\nFINI\n"
    );
    let statements = executed(&points);
    let millions = f64::from(u32::try_from(statements).unwrap_or(u32::MAX)) / 1e6;
    bench::rate(
        "execute: a loop that defines points",
        millions,
        "M statements/s",
        Some(0.5),
        || executed(&points),
    );
    let lines = "RESERV/L,50000\nDO/E,I=1,50000\nA=MODF(I,37)+1\nQ=POINT/A,2\nR=POINT/(A+1),(SINF(I)*3)\n\
         C=CIRCLE/CENTER,Q,RADIUS,(.125+A*.01)\nL(I)=LINE/R,LEFT,TANTO,C\nE) CONTIN\nFINI\n";
    let lines = lines.replace("Q=", "CANON/ON\nQ=");
    let statements = executed(&lines);
    let millions = f64::from(u32::try_from(statements).unwrap_or(u32::MAX)) / 1e6;
    bench::rate("execute: a loop that defines tangents", millions, "M statements/s", None, || {
        executed(&lines)
    });
    if let Some(peak) = bench::peak_memory() {
        bench::figure("execute: peak memory", peak, "MiB", Some(1024.0));
    }
}
