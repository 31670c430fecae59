//! What the tests end to end are made of.
//!
//! [`golden`] is the runner for part programs in folders, each with what every stage should make of it: a
//! test runs it over `corpus/`, `cargo xtask bless` writes its goldens anew, `aptc test DIR` offers it for a
//! user's own programs. [`rs274`] hands our machine code to a real control's interpreter. [`targets`] says
//! what must hold for any input at all.

pub mod golden;
pub mod rs274;
pub mod targets;
