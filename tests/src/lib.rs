//! What the tests end to end are made of.
//!
//! [`rs274`] hands our machine code to a real control's interpreter. [`targets`] says what must hold for any
//! input at all. The runner of the corpus is `aptc-golden`.

pub mod rs274;
pub mod targets;
