//! Random scenes of all surfaces, cutters, tool axes and tolerances: each motion is proved or refused.
//!
//! `cargo run -p aptc-tests --example scenes -- 200 5000` tries 200 scenes from the 5000th on, and fails when the proof
//! refutes a path. It takes seconds a scene, and not all are solved yet (`docs/roadmap.md`), so it is no test.
#![expect(clippy::print_stdout, reason = "it talks to its terminal")]

#[path = "../../crates/section2-arelem/tests/support/mod.rs"]
mod support;

use std::process::ExitCode;

use aptc_verify::{Effort, Verifier};
use support::run;
use support::scene::wide;

fn main() -> ExitCode {
    let mut numbers = std::env::args().skip(1).map_while(|a| a.parse::<u64>().ok());
    let n = numbers.next().unwrap_or(30);
    let from = numbers.next().unwrap_or(0);
    let (mut solved, mut vectors) = ([0_usize; 2], 0);
    let (mut refused, mut wrong, mut open) = ([Vec::new(), Vec::new()], Vec::new(), Vec::new());
    for seed in from..from + n {
        let Some(s) = wide(seed, 1.0) else { continue };
        let turns = usize::from(s.what.contains(" axis "));
        let ran = run(&s.forms, &s.setup);
        if let Some(d) = ran.diagnostics.iter().find(|d| d.is_error()) {
            let line = format!("{seed}: {} {:?} | {}", d.message, d.notes, s.what);
            println!("refused {line}");
            refused[turns].push(line);
            continue;
        }
        solved[turns] += 1;
        let mut verifier = Verifier::new(Effort::Full);
        for record in &ran.cl {
            verifier.push(record);
        }
        let (certificate, told) = verifier.finish();
        vectors += certificate.proved;
        let line = || format!("{seed}: {:?} | {}", told.first().map(|d| &d.message), s.what);
        if certificate.refuted > 0 {
            println!("refuted {}", line());
            wrong.push(line());
        } else if certificate.undecided > 0 {
            open.push(line());
        }
    }
    let counts = [refused[0].len(), refused[1].len(), wrong.len(), open.len()];
    println!("{solved:?} solved with the axis fixed and turning, {vectors} vectors proved");
    println!("refused with the axis fixed and turning, refuted, open: {counts:?}");
    if wrong.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
