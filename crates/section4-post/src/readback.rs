//! Reading back: machine director text as a control would read it.
//!
//! Nothing of the writer is used here, so that a mistake there cannot hide behind the same mistake here. A
//! [`Control`] takes lines and gives [`Step`]s: what the axes do. What it does not know it refuses.

mod control;
mod cycles;
mod words;

pub(crate) use control::{ArcStep, Control, Place, Step};

/// A line that the control would not take.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fault {
    /// Line of the text, from 1.
    pub(crate) line: u64,
    /// What is wrong.
    pub(crate) message: String,
}
