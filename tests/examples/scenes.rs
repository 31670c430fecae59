//! Random scenes of all surfaces, cutters, tool axes and tolerances: each motion is proved or refused.
//!
//! `cargo run -p aptc-tests --example scenes -- 200 5000` tries 200 scenes from the 5000th on and fails when the proof
//! refutes a path, when it comes to no decision or when something panics. With `scaled` as a third word each scene
//! is made 25.4 and 1/1000 times as large as well, and the path must be the same but for its size.
#![expect(clippy::print_stdout, reason = "it talks to its terminal")]

#[path = "../../crates/section2-arelem/tests/support/mod.rs"]
mod support;

use std::collections::BTreeMap;
use std::panic::catch_unwind;
use std::process::ExitCode;
use std::time::Instant;

use aptc_verify::{Effort, Verifier};
use support::scene::{Scene, wide};
use support::{Run, run};

/// What became of a scene, the worst last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Outcome {
    Certified,
    Refused,
    /// Not the same path in another size.
    Differs,
    Open,
    Refuted,
    Panicked,
}

/// The scene's answer with what there is to say of it.
struct Answer {
    outcome: Outcome,
    said: String,
    vectors: u64,
    /// Does the axis turn?
    turns: bool,
}

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize| words.get(i).and_then(|w| w.parse::<u64>().ok());
    let (n, from) = (number(0).unwrap_or(30), number(1).unwrap_or(0));
    let scaled = words.iter().any(|w| w == "scaled");
    let (mut counts, mut vectors) = (BTreeMap::new(), 0);
    let mut slowest: Vec<(u128, u64)> = Vec::new();
    for seed in from..from + n {
        let start = Instant::now();
        let answer = catch_unwind(|| answer(seed, scaled)).unwrap_or_else(|_| {
            let (outcome, said) = (Outcome::Panicked, String::new());
            Some(Answer { outcome, said, vectors: 0, turns: false })
        });
        let Some(answer) = answer else { continue };
        slowest.push((start.elapsed().as_millis(), seed));
        slowest.sort_by(|a, b| b.cmp(a));
        slowest.truncate(8);
        vectors += answer.vectors;
        *counts.entry((answer.turns, answer.outcome)).or_insert(0_u64) += 1;
        if answer.outcome != Outcome::Certified {
            println!("{:?} {seed}: {}", answer.outcome, answer.said);
        }
    }
    for ((turns, outcome), n) in &counts {
        println!("{n:6} {outcome:?}, axis {}", if *turns { "turning" } else { "fixed" });
    }
    println!("{vectors} vectors proved; slowest scenes (ms, number): {slowest:?}");
    let right = |o: Outcome| matches!(o, Outcome::Certified | Outcome::Refused);
    if counts.keys().all(|(_, o)| right(*o)) { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Runs and proves a scene; `None` where there is no way on from its start.
fn answer(seed: u64, scaled: bool) -> Option<Answer> {
    let scene = wide(seed, 1.0)?;
    let turns = scene.what.contains(" axis ");
    let ran = run(&scene.forms, &scene.setup);
    let (outcome, said, vectors) = judged(&ran);
    let (outcome, said) = match outcome {
        Outcome::Certified if scaled => {
            scaling(seed, &ran).map_or((outcome, said), |d| (Outcome::Differs, d))
        }
        _ => (outcome, said),
    };
    let Scene { what, .. } = scene;
    Some(Answer { outcome, said: format!("{said} | {what}"), vectors, turns })
}

fn judged(ran: &Run) -> (Outcome, String, u64) {
    if let Some(d) = ran.diagnostics.iter().find(|d| d.is_error()) {
        return (Outcome::Refused, format!("{} {:?}", d.message, d.notes), 0);
    }
    let mut verifier = Verifier::new(Effort::Full);
    for record in &ran.cl {
        verifier.push(record);
    }
    let (certificate, told) = verifier.finish();
    let outcome = match &certificate {
        c if c.refuted > 0 => Outcome::Refuted,
        c if c.undecided > 0 => Outcome::Open,
        _ => Outcome::Certified,
    };
    let told: Vec<_> = told.iter().map(|d| (&d.message, &d.notes)).collect();
    (outcome, format!("{told:?}"), certificate.proved)
}

/// How the path differs from that of the same scene in other units.
fn scaling(seed: u64, plain: &Run) -> Option<String> {
    let points = |r: &Run| -> Vec<_> {
        r.motions().flat_map(|(_, m)| m.points.iter().map(|p| (p.te, p.ta))).collect()
    };
    let plain = points(plain);
    [25.4, 1e-3].into_iter().find_map(|scale| {
        let scene = wide(seed, scale)?;
        let other = points(&run(&scene.forms, &scene.setup));
        let apart = plain.iter().zip(&other).map(|((te, ta), (p, a))| {
            let size = 10.0 + te.norm();
            ((te - p / scale).norm() / size).max((ta - a).norm())
        });
        let apart = apart.fold(0.0, f64::max);
        let n = [plain.len(), other.len()];
        (n[0] != n[1] || apart > 1e-9).then(|| format!("scale {scale}: {n:?} points, {apart:e}"))
    })
}
