//! Part programs and their goldens.
//!
//! A case is a folder with a `program.apt`, or a loose `X.apt` with a folder `X.golden`. There stand, for each
//! Section that gives something, `program.protap`, `program.cl`, `program.edited.cl` (where Section 3 changed anything), `program.nc` and
//! `program.diag` (where there are messages), and optionally a `case.toml` with settings ([`Settings`]).
//! Messages that are expected stand in the program itself ([`expected`]). A golden that is missing, changed
//! or orphaned fails, and so does a message that is missing or unexpected.
//!
//! `aptc test DIR` offers the runner for a user's own programs; the project's corpus is held by the same.

mod case;
mod compare;
mod compile;
pub mod expected;
mod report;
mod run;

pub use case::{Case, Settings, discover};
pub use compare::{Change, change};
pub use compile::compile;
pub use report::{Fault, Report};
pub use run::{Message, Mode, Outputs, Stage, run};
