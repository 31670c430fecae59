//! Random scenes of all surfaces, cutters, tool axes and tolerances: each motion is proved or refused.
//!
//! `cargo run -p aptc-tests --example scenes -- 200 5000` tries 200 scenes from the 5000th on and fails when the proof
//! refutes a path, when it comes to no decision or when something panics. A scene has two motions, the start-up and the
//! way on; each counts. What is refuted is told with the gap that brute force finds at the place. With `scaled` as a third word each scene
//! is made 25.4 and 1/1000 times as large as well, and the path must be the same but for its size.
#![expect(clippy::print_stdout, reason = "it talks to its terminal")]

#[path = "../../crates/section2-arelem/tests/support/mod.rs"]
mod support;

use std::collections::BTreeMap;
use std::panic::catch_unwind;
use std::process::ExitCode;
use std::time::Instant;

use aptc_cldata::{Controlled, Kind, Position};
use aptc_geometry::{Profile, Surface};
use aptc_verify::{Effort, Fault, Verifier};
use support::scene::{Scene, wide};
use support::{Run, brute, run};

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
    /// Its motions by what became of each.
    motions: BTreeMap<Outcome, u64>,
    /// Does the axis turn?
    turns: bool,
}

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize| words.get(i).and_then(|w| w.parse::<u64>().ok());
    let (n, from) = (number(0).unwrap_or(30), number(1).unwrap_or(0));
    let scaled = words.iter().any(|w| w == "scaled");
    let (mut counts, mut vectors) = (BTreeMap::new(), 0);
    let mut motions: BTreeMap<Outcome, u64> = BTreeMap::new();
    let mut slowest: Vec<(u128, u64)> = Vec::new();
    for seed in from..from + n {
        let start = Instant::now();
        let answer = catch_unwind(|| answer(seed, scaled)).unwrap_or_else(|_| {
            let (outcome, said) = (Outcome::Panicked, String::new());
            let motions = BTreeMap::from([(outcome, 1)]);
            Some(Answer { outcome, said, vectors: 0, motions, turns: false })
        });
        let Some(answer) = answer else { continue };
        slowest.push((start.elapsed().as_millis(), seed));
        slowest.sort_by(|a, b| b.cmp(a));
        slowest.truncate(8);
        vectors += answer.vectors;
        answer.motions.iter().for_each(|(o, n)| *motions.entry(*o).or_insert(0) += n);
        *counts.entry((answer.turns, answer.outcome)).or_insert(0_u64) += 1;
        if answer.outcome != Outcome::Certified {
            println!("{:?} {seed}: {}", answer.outcome, answer.said);
        }
    }
    for ((turns, outcome), n) in &counts {
        println!("{n:6} {outcome:?}, axis {}", if *turns { "turning" } else { "fixed" });
    }
    println!("of {} motions {motions:?}", motions.values().sum::<u64>());
    println!("{vectors} vectors proved; slowest scenes (ms, number): {slowest:?}");
    let right = |o: Outcome| matches!(o, Outcome::Certified | Outcome::Refused);
    if counts.keys().all(|(_, o)| right(*o)) { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Runs and proves a scene; `None` where there is no way on from its start.
fn answer(seed: u64, scaled: bool) -> Option<Answer> {
    let scene = wide(seed, 1.0)?;
    let turns = scene.what.contains(" axis ");
    let ran = run(&scene.forms, &scene.setup);
    let mut answer = judged(&ran);
    if answer.outcome == Outcome::Certified
        && scaled
        && let Some(differs) = scaling(seed, &ran)
    {
        (answer.outcome, answer.said) = (Outcome::Differs, differs);
    }
    let Scene { what, .. } = scene;
    Some(Answer { said: format!("{} | {what}", answer.said), turns, ..answer })
}

fn judged(ran: &Run) -> Answer {
    let mut verifier = Verifier::new(Effort::Full);
    for record in &ran.cl {
        verifier.push(record);
    }
    let (certificate, told) = verifier.finish();
    let mut motions = BTreeMap::new();
    let mut said: Vec<String> =
        told.iter().map(|d| format!("{} {:?}", d.message, d.notes)).collect();
    for statement in &certificate.statements {
        let outcome = match &statement.fault {
            Some(f) if f.refuted => {
                said.push(format!("brute force: {:?}", by_force(ran, statement.origin.line, f)));
                Outcome::Refuted
            }
            Some(_) => Outcome::Open,
            None => Outcome::Certified,
        };
        *motions.entry(outcome).or_insert(0) += 1;
    }
    if let Some(d) = ran.diagnostics.iter().find(|d| d.is_error()) {
        said.push(format!("{} {:?}", d.message, d.notes));
        *motions.entry(Outcome::Refused).or_insert(0) += 1;
    }
    let outcome = motions.keys().max().copied().unwrap_or(Outcome::Certified);
    Answer { outcome, said: said.join("; "), vectors: certificate.proved, motions, turns: false }
}

/// The gap that brute force finds where a motion is refuted, and the band that it should be in.
fn by_force(ran: &Run, line: u32, fault: &Fault) -> Option<(f64, [f64; 2])> {
    let (mut cutter, mut last) = (None, None);
    let mut vector = 0;
    for record in &ran.cl {
        match &record.kind {
            Kind::Cutter(c) => cutter = Some(*c),
            Kind::Motion(m) => {
                for to in &m.points {
                    let from: Position = last.replace(*to).unwrap_or(*to);
                    let Some(control) = m.control.as_ref().filter(|_| record.origin.line == line)
                    else {
                        continue;
                    };
                    vector += 1;
                    if vector != fault.vector {
                        continue;
                    }
                    let asked = match fault.surface.split(' ').next() {
                        Some("drive") => control.drive.as_ref(),
                        Some("part") => control.part.as_ref(),
                        _ => control.checks.first(),
                    }?;
                    let way = to.te - from.te;
                    let te = aptc_geometry::Vec3::from(fault.te);
                    let t = (te - from.te).dot(&way) / way.norm_squared().max(f64::MIN_POSITIVE);
                    let t = if way.norm() > 0.0 { t } else { 1.0 };
                    // The axis turns evenly; over so little the chord is as good.
                    let ta = (from.ta + (to.ta - from.ta) * t).normalize();
                    return gap(&Profile::new(&cutter?).ok()?, asked, &Position { te, ta });
                }
            }
            _ => {}
        }
    }
    None
}

fn gap(profile: &Profile, asked: &Controlled, at: &Position) -> Option<(f64, [f64; 2])> {
    let surface = Surface::from_form(&asked.form)?;
    if asked.side == 0 || asked.relation == aptc_cldata::Relation::On {
        return Some((surface.distance(at.te), [-asked.intol, asked.outtol]));
    }
    let disk = asked.disk.and_then(|[radius, height]| Profile::disk(radius, height).ok());
    let found =
        brute::least(&disk.unwrap_or(*profile), at.te, at.ta, &surface, f64::from(asked.side));
    Some((found, [asked.thick - asked.intol, asked.thick + asked.outtol]))
}

/// How the path differs from that of the same scene in other units.
fn scaling(seed: u64, plain: &Run) -> Option<String> {
    let points = |r: &Run| -> Vec<_> {
        r.motions().flat_map(|(_, m)| m.points.iter().map(|p| (p.te, p.ta))).collect()
    };
    let plain = points(plain);
    // By powers of two no digit is rounded otherwise, but for quadrics, which are divided by their greatest
    // coefficient: what differs there is held against a length of its own.
    [32.0, 1.0 / 1024.0, 25.4, 1e-3].into_iter().find_map(|scale| {
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
