//! Part programs and their goldens.
//!
//! A case is a folder with a `program.apt`. Beside it stand, for each stage that gives something,
//! `program.protap`, `program.cl`, `program.edited.cl` (where Section 3 changed anything), `program.nc` and
//! `program.diag` (where there are messages), and optionally a `case.toml` with settings ([`Settings`]).
//! Messages that are expected stand in the program itself ([`expected`]). A golden that is missing, changed
//! or orphaned fails, and so does a message that is missing or unexpected.
//!
//! The runner knows no compiler: it is handed one as a function from a [`Case`] to [`Outputs`].

mod case;
mod compare;
pub mod expected;
mod report;
mod run;

pub use case::{Case, Settings, discover};
pub use compare::{Change, change};
pub use report::{Fault, Report};
pub use run::{Message, Mode, Outputs, Stage, run};
