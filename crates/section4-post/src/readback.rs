//! Reading back: machine director text as a control would read it.
//!
//! Nothing of the writer is used here, so that a mistake there cannot hide behind the same mistake here. A
//! `Control` takes lines and gives [`Step`]s: what the axes do. What it does not know it refuses.

mod control;
mod cycles;
mod siemens;
mod tnc;
mod words;

use crate::machine::{Dialect, Machine};

pub(crate) use control::{ArcStep, Frame, Place, Step};

/// A control of some dialect.
pub(crate) enum Reader {
    /// RS-274 and Siemens.
    Words(Box<control::Control>),
    /// Heidenhain.
    Tnc(Box<tnc::Tnc>),
}

impl Reader {
    pub(crate) fn new(machine: &Machine) -> Self {
        match machine.dialect {
            Dialect::Heidenhain => Self::Tnc(Box::new(tnc::Tnc::new(machine))),
            _ => Self::Words(Box::new(control::Control::new(machine))),
        }
    }

    /// Number of lines read.
    pub(crate) fn n_lines(&self) -> u64 {
        match self {
            Self::Words(c) => c.n_lines(),
            Self::Tnc(c) => c.n_lines(),
        }
    }

    /// Reads a line; what it does is added to `steps`.
    pub(crate) fn read(&mut self, text: &[u8], steps: &mut Vec<Step>) -> Result<(), Fault> {
        match self {
            Self::Words(c) => c.read(text, steps),
            Self::Tnc(c) => c.read(text, steps),
        }
    }
}

/// Tool-centre control begins or ends, when the block says so and it is not so already.
fn turn_center(said: Option<bool>, centered: &mut bool, at: &mut Place, steps: &mut Vec<Step>) {
    let Some(on) = said.filter(|on| on != centered) else { return };
    *centered = on;
    // Beside turned axes the numbers of the linear axes no longer mean the same places.
    if at[3..].iter().flatten().any(|a| a % 360.0 != 0.0) {
        at[..3].fill(None);
    }
    steps.push(Step::Center(on));
}

/// The words that begin and end tool-centre control; empty ones where the control has none, or never ends it.
fn center_words(machine: &Machine) -> [String; 2] {
    let m = &machine.multiaxis;
    let usable = m.tool_center && !m.tool_center_on.is_empty();
    [&m.tool_center_on, &m.tool_center_off].map(|line| {
        let word = line.split_ascii_whitespace().next().filter(|_| usable);
        word.unwrap_or_default().to_owned()
    })
}

/// A line that the control would not take.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fault {
    /// Line of the text, from 1.
    pub(crate) line: u64,
    /// What is wrong.
    pub(crate) message: String,
}
