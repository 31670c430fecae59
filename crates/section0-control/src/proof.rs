//! The proof of a path on several threads, also while the path is computed.

use std::collections::VecDeque;
use std::io;
use std::sync::Arc;

use aptc_cldata::{Kind, Record};
use aptc_diagnostics::Diagnostic;
use aptc_verify::{Batch, Certificate, Effort, Verifier};

use crate::hands::Hands;
use crate::{FULL_PROOF, Options, Records, Verify};

/// Vectors that are shared out together at least.
const BATCH: usize = 512;
/// Fewer are judged sooner than threads begin.
const FEW: usize = 96;
/// Batches that are out at once; then the program waits for the first, and works at it meanwhile.
const OUT: usize = 4;

/// A proof that takes one record after the other.
#[derive(Debug)]
pub(crate) struct PathProof {
    verifier: Verifier,
    hands: Hands,
    out: VecDeque<Arc<Batch>>,
}

impl PathProof {
    /// On so many threads, that of the caller among them; 0 for as many as the machine has.
    pub(crate) fn new(verifier: Verifier, threads: usize) -> Self {
        Self { verifier, hands: Hands::new(threads), out: VecDeque::new() }
    }

    pub(crate) fn push(&mut self, record: &Record) {
        self.verifier.push(record);
        if let Some(batch) = self.verifier.batch(BATCH) {
            self.give(batch);
            if self.hands.are_none() || self.out.len() > OUT {
                self.take_back();
            }
        }
    }

    pub(crate) fn finish(mut self) -> (Certificate, Vec<Diagnostic>) {
        let last = self.verifier.last_batch();
        self.give(last);
        while !self.out.is_empty() {
            self.take_back();
        }
        self.verifier.finish()
    }

    fn give(&mut self, batch: Batch) {
        let batch = Arc::new(batch);
        if !self.out.is_empty() || batch.vectors() >= FEW {
            self.hands.give(&batch);
        }
        self.out.push_back(batch);
    }

    fn take_back(&mut self) {
        let Some(batch) = self.out.pop_front() else { return };
        batch.work();
        batch.wait();
        self.verifier.settle(&batch);
    }
}

/// The proof of a part program that goes on while its path is computed, where there are threads for it and as long
/// as every vector is to be judged.
#[derive(Debug)]
pub(crate) struct Ahead {
    verify: Verify,
    threads: usize,
    n_positions: u64,
    proof: Option<PathProof>,
}

impl Ahead {
    pub(crate) fn new(options: &Options) -> Self {
        let Options { verify, threads, .. } = *options;
        let full = matches!(verify, Verify::Full | Verify::UpTo(_)) && threads != 1;
        let proof = full.then(|| PathProof::new(Verifier::new(Effort::Full), threads));
        Self { verify, threads, n_positions: 0, proof }
    }

    /// Takes the next record of the path.
    pub(crate) fn push(&mut self, record: &Record) {
        let Some(proof) = &mut self.proof else { return };
        self.n_positions += positions(record);
        if effort(self.n_positions, self.verify) == Effort::Full {
            proof.push(record);
        } else {
            // A sample is judged when it is known of how many.
            self.proof = None;
        }
    }

    /// The proof of all of the path, which is in `records`; `None` where none is wanted.
    ///
    /// # Errors
    /// What the temporary file of the records gives.
    pub(crate) fn finish(
        self,
        records: &Records,
    ) -> io::Result<Option<(Certificate, Vec<Diagnostic>)>> {
        if self.verify == Verify::Off {
            return Ok(None);
        }
        let proof = match self.proof {
            Some(proof) => proof,
            None => {
                let verifier = Verifier::new(effort(records.positions(), self.verify));
                let mut proof = PathProof::new(verifier, self.threads);
                records.for_each(|record| proof.push(record))?;
                proof
            }
        };
        Ok(Some(proof.finish()))
    }
}

pub(crate) fn positions(record: &Record) -> u64 {
    if let Kind::Motion(m) = &record.kind { m.points.len() as u64 } else { 0 }
}

/// How many of `n` positions are judged.
pub(crate) fn effort(n: u64, verify: Verify) -> Effort {
    let every = n.div_ceil(FULL_PROOF).max(2);
    match verify {
        Verify::UpTo(most) if n > most => Effort::Every(every),
        Verify::Sample => Effort::Every(every),
        _ => Effort::Full,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Memory, Source, compile};
    use std::fmt::Write as _;

    /// Circles and then a region with a scallop, and rapid motion between.
    fn program() -> Source {
        let mut text = String::from(
            "PARTNO THREADS\nUNITS/MM\nCUTTER/10,5\nINTOL/.005\nOUTTOL/.005\nC1=CIRCLE/0,0,0,50\nFROM/70,0,0\n\
             DO/9,I=1,8\nGOTO/70,0,0\nINDIRV/-1,0,0\nGO/TO,C1,ON,(PLANE/0,0,1,0)\n\
             TLRGT,GORGT/C1,ON,2,INTOF,(LINE/XAXIS)\nRAPID\nGODLTA/0,0,-20\n9) K=I\nS=SSURF/SMESH,XYZ",
        );
        for j in 0..4 {
            text.push_str(",$\n SPLINE");
            for i in 0..4 {
                let z = if (i + j) % 2 == 0 { 2.0 } else { 0.0 };
                write!(text, ",$\n ({},{},{z})", 10 * i, 10 * j).unwrap();
            }
        }
        text += "\nUP=VECTOR/0,0,1\nGOTO/0,0,60\nSCON/DS,S,PARAM,0,3,0,3,AT,UP\nSCON/PS,TO,S,PLUS,0\n\
                 SCON/AXIS,UP\nSCON/FEED,900,900,400,2000\nSCON/FEED,(PLANE/0,0,1,40)\nSCON/STEPOV,.2,6,0,0\n\
                 SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS\nFINI\n";
        Source { name: "part.apt".into(), text: text.into() }
    }

    #[test]
    fn the_report_is_the_same_for_any_number_of_threads() {
        let options =
            Options { verify: Verify::Off, post: false, threads: 1, ..Options::default() };
        let compiled = compile(program(), &mut Memory::default(), &options);
        assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics);
        let mut records = compiled.parts[0].computed.to_vec().unwrap();
        let judge = |records: &[Record], threads: usize| {
            let mut proof = PathProof::new(Verifier::new(Effort::Full), threads);
            records.iter().for_each(|r| proof.push(r));
            proof.finish()
        };
        let whole = judge(&records, 1);
        // All but the rapid motions, which go down between the circles.
        let Certificate { proved, refuted, undecided, rapid_cuts, .. } = whole.0;
        assert!(proved > 500 && refuted + undecided == 0, "{} {:?}", whole.0, whole.1);
        assert_eq!(rapid_cuts, 7);
        // Now and then a place is wrong.
        let mut n = 0;
        for record in &mut records {
            if let Kind::Motion(m) = &mut record.kind {
                for p in &mut m.points {
                    n += 1;
                    p.te.z += if n % 67 == 0 { 0.07 * f64::from(n % 5 - 2) } else { 0.0 };
                }
            }
        }
        let spoiled = judge(&records, 1);
        assert!(spoiled.0.refuted > 8 && spoiled.1.len() > 3, "{} {:?}", spoiled.0, spoiled.1);
        for threads in [2, 5] {
            assert_eq!(judge(&records, threads), spoiled, "{threads} threads");
        }
    }

    #[test]
    fn a_proof_that_goes_ahead_is_that_of_all_records() {
        let of = |verify, threads| {
            let options = Options { verify, threads, post: false, ..Options::default() };
            let compiled = compile(program(), &mut Memory::default(), &options);
            (compiled.parts[0].certificate.clone(), compiled.diagnostics)
        };
        // In full, and given up on the way for a sample.
        for most in [20_000, 200] {
            let alone = of(Verify::UpTo(most), 1);
            assert_eq!(of(Verify::UpTo(most), 3), alone);
            assert_eq!(alone.0.is_some_and(|c| c.left_out > 0), most == 200);
        }
    }
}
