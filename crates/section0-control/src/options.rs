//! What the user may choose.

use std::sync::Arc;
use std::time::Duration;

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_post::Machine;

use crate::Passes;

/// Choices of a run.
#[derive(Clone, Debug)]
pub struct Options {
    /// How statements are read and carried out, with the limits.
    pub translate: aptc_translate::Options,
    /// How machine code is written.
    pub code: CodeOptions,
    /// How much of the path is proved.
    pub verify: Verify,
    /// Keep the PROTAP records.
    pub keep_protap: bool,
    /// Run Section 2 and what follows; off for checking the language alone.
    pub motion: bool,
    /// Run Section 4.
    pub post: bool,
    /// Draw the plot.
    pub plot: bool,
    /// Stop a part program that has not ended after so long.
    pub time: Option<Duration>,
    /// Threads for regional milling and for the proof; 0: as many as the machine has. The results are the same, bit by bit.
    pub threads: usize,
    /// Where it is told how far a region is.
    pub passes: Option<Arc<Passes>>,
}

/// How machine code is written.
#[derive(Clone, Debug, Default)]
pub struct CodeOptions {
    /// Machine instead of the program's MACHIN.
    pub machine: Option<MachineChoice>,
    /// Work offset instead of the machine file's, as `G55`.
    pub work_offset: Option<String>,
    /// Two opposite corners of the block of material, as STOCK gives them.
    pub stock: Option<[f64; 6]>,
    /// Write the statement number as a comment before its blocks.
    pub annotate: bool,
    /// Keep the statement of each block.
    pub map: bool,
    /// Machine code is not asked for: where neither the program nor [`machine`](Self::machine) names a machine that is known,
    /// none is assumed and Section 4 is left out.
    pub unasked: bool,
    /// Machine code is one of the things that are written when nothing is said of it: where no machine is named either,
    /// and the one that is assumed finds no feed rate or has not the words, the CL data stand without machine code and with a note.
    pub by_default: bool,
}

impl MachineChoice {
    /// The machine, or why there is none.
    pub fn machine(&self) -> Result<Machine, Vec<Diagnostic>> {
        match self {
            Self::Read(machine) => Ok((**machine).clone()),
            Self::Named(name) => {
                let found = aptc_post::machine(name).or_else(|| aptc_post::machine_for(name, &[]));
                found.cloned().ok_or_else(|| {
                    let known: Vec<_> = aptc_post::machines().map(|m| m.name.as_str()).collect();
                    let message = format!("there is no machine {name}");
                    let d = Diagnostic::error(codes::MACHINE_FILE, Span::default(), message);
                    vec![d.help(format!("give a machine file, or one of {}", known.join(", ")))]
                })
            }
        }
    }
}

/// A machine by its name or by its machine file.
#[derive(Clone, Debug)]
pub enum MachineChoice {
    /// Name of a machine that aptc knows.
    Named(String),
    /// What its file says.
    Read(Box<Machine>),
}

/// How much of the path is proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verify {
    /// Every cut vector up to this number, a sample of as many beyond.
    UpTo(u64),
    /// Every cut vector.
    Full,
    /// A sample by count.
    Sample,
    /// Nothing.
    Off,
}

/// Cut vectors that are proved without being asked for a full proof.
pub const FULL_PROOF: u64 = 20_000;

impl Default for Options {
    fn default() -> Self {
        Self {
            translate: aptc_translate::Options::default(),
            code: CodeOptions::default(),
            verify: Verify::UpTo(FULL_PROOF),
            keep_protap: false,
            motion: true,
            post: true,
            plot: true,
            time: None,
            threads: 0,
            passes: None,
        }
    }
}
