//! How many megabytes of source a core reads in a second.
//!
//! `cargo bench -p aptc-syntax`. Dense source has no comments; the second figure has a mistake in one
//! statement of six, each with its full message. Dropping the tree is counted.

use aptc_diagnostics::FileId;
use aptc_syntax::{Interner, Options, parse};
use aptc_testkit::{bench, shared};

/// Bytes of source for each figure.
const SIZE: usize = 4 << 20;

const DENSE: [&str; 12] = [
    "P1=POINT/60.85,25.475",
    "L3=LINE/(POINT/CENTER,C1),PARLEL,LX",
    "C2=CIRCLE/YLARGE,L2,XSMALL,OUT,C1,RADIUS,D8",
    "X0=SQRTF(A*A+B*B-2*A*B*COSF(T1))+3.1416/(2*B)",
    "TLLFT,GOLFT/L1,TO,L2",
    "GOFWD/C1,PAST,2,INTOF,L5",
    "GOTO/10.5,-3.25,0.125",
    "ID10)N=N+1",
    "IF(N-40)ID10,ID10,ID11",
    "CALL/FANSTA,MV1=81.0,MV2=2,KF=22,Q=0",
    "PT(I)=POINT/(R*(C+T*S)),(R*(S-T*C)),Z",
    "SPINDL/3000,RPM,CLW",
];

const WRONG: [&str; 4] =
    ["P1=POINT/1,*2,3", "GOTO/10.5,(-3.25,0.125", "IF(N-40)ID10,ID10", "L1=LINE/P1,PARLEL,L2)"];

fn source(wrong_every: Option<usize>) -> String {
    let mut text = String::with_capacity(SIZE + 64);
    let mut n = 0;
    while text.len() < SIZE {
        n += 1;
        let line = match wrong_every {
            Some(every) if n % every == 0 => WRONG[n / every % WRONG.len()],
            _ => DENSE[n % DENSE.len()],
        };
        text.push_str(line);
        text.push('\n');
    }
    text
}

fn measure(name: &str, text: &str, target: Option<f64>) {
    let megabytes = f64::from(u32::try_from(text.len()).unwrap_or(u32::MAX)) / 1e6;
    bench::rate(name, megabytes, "MB/s", target, || {
        let mut interner = Interner::default();
        parse(FileId(0), text, &mut interner, &Options::default()).diagnostics.len()
    });
}

fn main() {
    measure("parse dense source", &source(None), Some(15.0));
    measure("parse with one statement of six in error", &source(Some(6)), Some(15.0));
    for name in ["apt360/sample2.apt", "ssv3/TEST20.DAT"] {
        let label = format!("parse {name}");
        let Some(path) = shared(&label, &format!("corpus/{name}")) else { continue };
        let bytes = std::fs::read(path).expect("a file that is there");
        let text = String::from_utf8_lossy(&bytes);
        measure(&label, &text.repeat(SIZE / text.len()), None);
    }
    if let Some(peak) = bench::peak_memory() {
        bench::figure("parse: peak memory", peak, "MiB", None);
    }
}
