//! Section 1: from statements to the numeric part program.
//!
//! An [`Interpreter`] walks the statement tree and gives out one PROTAP record at a time. Section 0 asks
//! for the next one with [`Interpreter::step`] and hands back what came of it with
//! [`Interpreter::outcome`], so that labels behind check surfaces are ordinary jumps. Errors do not stop
//! it: what could not be computed poisons its users in silence.
//!
//! ```
//! use aptc_translate::{Interpreter, NoFiles, Options, Step};
//! use aptc_protap::{Kind, Outcome};
//!
//! let mut files = NoFiles;
//! let text = "PARTNO HOLES\nLOOPST\nI=1\nA) GOTO/(I*10),0,5\nI=I+1\nIF(I-3)A,A,B\nB) LOOPND\nFINI\n";
//! let mut program = Interpreter::new("holes.apt", text, &mut files, Options::default());
//! let mut moves = 0;
//! while let Step::Record(record) = program.step() {
//!     moves += usize::from(matches!(record.kind, Kind::Goto(_)));
//!     program.outcome(Outcome::None);
//! }
//! assert_eq!(moves, 3);
//! assert!(program.take_diagnostics().is_empty());
//! ```

pub mod define;
mod eval;
mod files;
mod flow;
mod interpreter;
mod level;
mod listing;
mod memory;
mod options;
mod program;
mod report;
mod sentence;
mod statement;
mod usage;
mod words;

pub use files::{Asker, FileError, FileRequest, Files, LoadedFile, NoFiles};
pub use interpreter::{Interpreter, Quantity, Step};
pub use listing::{Entry, EntryKind};
pub use options::{Language, Limits, Options, UnknownWords};
pub use words::{about, near_word};
