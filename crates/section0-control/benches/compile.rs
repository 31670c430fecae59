//! The whole road: source to machine code, of a program with many cuts.
//!
//! `cargo bench -p aptc-control`. The program is made here: contours with fillets, one below the other, cut by a
//! macro in a loop, with the proof of every cut vector.

use aptc_control::{Memory, Options, Source, compile};
use aptc_testkit::bench;

/// Contours one below the other.
const LEVELS: u32 = 20;

fn program() -> String {
    format!(
        "PARTNO LEVELS\nMACHIN/LINUXCNC\nUNITS/MM\nCANON/ON\nL1=LINE/XAXIS\nL2=LINE/PARLEL,L1,YLARGE,60\n\
         L3=LINE/YAXIS\nL4=LINE/PARLEL,L3,XLARGE,100\nF1=CIRCLE/XLARGE,L3,YLARGE,L1,RADIUS,15\n\
         F2=CIRCLE/XSMALL,L4,YLARGE,L1,RADIUS,15\nF3=CIRCLE/XSMALL,L4,YSMALL,L2,RADIUS,15\n\
         F4=CIRCLE/XLARGE,L3,YSMALL,L2,RADIUS,15\nCUTTER/10\nINTOL/.002\nOUTTOL/.002\nLOADTL/1\n\
         SPINDL/2400,CLW\nCOOLNT/ON\nFEDRAT/240,MMPM\nFROM/50,30,5\nROUND=MACRO/Z\n\
         GOTO/50,30,Z\nPSIS/(PLANE/0,0,1,Z)\nGO/TO,L1\nINDIRV/1,0,0\nTLLFT,GOFWD/L1,TANTO,F2\n\
         GOFWD/F2,TANTO,L4\nGOFWD/L4,TANTO,F3\nGOFWD/F3,TANTO,L2\nGOFWD/L2,TANTO,F4\n\
         GOFWD/F4,TANTO,L3\nGOFWD/L3,TANTO,F1\nGOFWD/F1,TANTO,L1\nGOFWD/L1,ON,(LINE/PARLEL,L3,XLARGE,60)\n\
         TERMAC\nDO/9,I=1,{LEVELS}\n9) CALL/ROUND,Z=(-I/10)\nRAPID,GOTO/50,30,50\nFINI\n"
    )
}

fn main() {
    let text = program();
    let run = || {
        let source = Source { name: "levels.apt".into(), text: text.as_str().into() };
        let compiled = compile(source, &mut Memory::default(), &Options::default());
        assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics.first());
        compiled
    };
    let vectors: u64 = run().parts.iter().map(|part| part.summary.cut_vectors).sum();
    #[expect(clippy::cast_precision_loss, reason = "some thousands")]
    let thousands = vectors as f64 / 1e3;
    bench::rate(
        "compile, contours in the plane, proved",
        thousands,
        "thousand cut vectors/s",
        None,
        run,
    );
    if let Some(memory) = bench::peak_memory() {
        bench::figure("compile, peak memory", memory, "MiB", None);
    }
}
