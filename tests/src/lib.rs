//! The golden runner: part programs in folders, each with what every stage should make of it.
//!
//! A test runs it over `corpus/`, `cargo xtask bless` writes its goldens anew, `aptc test DIR` offers it for
//! a user's own programs.

pub mod golden;
pub mod targets;
