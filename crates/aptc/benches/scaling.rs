//! Cost against work: ten times the work is to cost ten times as much, and two threads half the time.
//!
//! `cargo bench -p aptc --bench scaling`. In the library, without the start of a process; for threads the clock counts.

use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Instant;

use aptc_control::{Memory, Options, Source, compile};
use aptc_testkit::bench;

fn main() {
    for n in [100, 1_000, 10_000] {
        work("definitions and points", n, &statements(n));
    }
    for n in [10, 100, 1_000] {
        work("contours in the plane, proved", n, &contours(n));
    }
    threads();
}

/// Geometry that hangs on geometry, each with a motion to it.
fn statements(n: u32) -> String {
    let mut text = String::from("CUTTER/1\nFROM/0,0,0\n");
    for i in 0..n {
        let y = i % 97;
        writeln!(text, "P{i}=POINT/{i},{y},0\nL{i}=LINE/P{i},ATANGL,30\nQ{i}=POINT/INTOF,L{i},(LINE/XAXIS)\nGOTO/Q{i}")
            .expect("a string takes all");
    }
    text
}

/// One circle after another in a loop.
fn contours(n: u32) -> String {
    format!(
        "INTOL/.005\nOUTTOL/.005\nCUTTER/10\nC1=CIRCLE/0,0,0,50\nL1=LINE/XAXIS\nFROM/70,0,0\n\
         DO/9,I=1,{n}\nGOTO/70,0,0\nINDIRV/-1,0,0\nGO/TO,C1,ON,(PLANE/0,0,1,0)\nTLRGT,GORGT/C1,ON,2,INTOF,L1\n9) K=I\n"
    )
}

/// Passes back and forth over a bumpy mesh, with interference control and the proof.
fn region() -> String {
    let mut text = String::from("S=SSURF/SMESH,XYZ");
    for j in 0..=10 {
        text.push_str(",$\n SPLINE");
        for i in 0..=10 {
            let (x, y) = (f64::from(i) * 10.0, f64::from(j) * 10.0);
            let z = 6.0 * bump(x) * bump(y + 17.0);
            write!(text, ",$\n ({x:.1},{y:.1},{z:.6})").expect("a string takes all");
        }
    }
    text + "\nUP=VECTOR/0,0,1\nCUTTER/10,5\nINTOL/.005\nOUTTOL/.005\nFROM/0,0,60\n\
            SCON/DS,S,PARAM,0,10,0,10,AT,UP\nSCON/PS,TO,S,PLUS,0\nSCON/AXIS,UP\nSCON/FEED,900,900,400,2000\n\
            SCON/FEED,(PLANE/0,0,1,40)\nSCON/STEPOV,0,2,0,0\nCHKSRF/PS,ON\n\
            SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS\n"
}

/// A smooth hill every 50 mm.
fn bump(x: f64) -> f64 {
    let u = (x / 25.0).rem_euclid(2.0) - 1.0;
    (1.0 - u * u) * (1.0 - u * u)
}

fn source(text: &str) -> Source {
    Source {
        name: "part.apt".into(),
        text: format!("PARTNO SCALING\nUNITS/MM\n{text}FINI\n").into(),
    }
}

fn run(text: &str, threads: usize) {
    let options = Options { threads, post: false, ..Options::default() };
    let compiled = compile(source(text), &mut Memory::default(), &options);
    assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics.first());
    black_box(compiled);
}

fn work(what: &str, n: u32, text: &str) {
    let name = format!("cost against work: {what}, {n}");
    bench::rate(&name, f64::from(n) / 1e3, "thousand/s", None, || run(text, 1));
}

/// A region of some fifty passes, on the clock.
fn threads() {
    let text = region();
    let time = |threads: usize| {
        (0..5).fold(f64::INFINITY, |least: f64, _| {
            let start = Instant::now();
            run(&text, threads);
            least.min(start.elapsed().as_secs_f64())
        })
    };
    let (one, two) = (time(1), time(2));
    bench::figure("regional milling, proved, one thread", one, "s of the clock", None);
    bench::figure("regional milling, proved, two threads", two, "s of the clock", None);
    bench::figure(
        "regional milling, proved, two threads beside one",
        one / two,
        "times",
        Some(1.8),
    );
}
