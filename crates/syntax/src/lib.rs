//! Cards, tokens and statement trees of APT part programs.
//!
//! Knows words, not meanings: [`parse()`] turns text into a [`tree::Program`] and never fails as a whole.
//! A statement that cannot be read becomes [`tree::Body::Error`] with one diagnostic; the next begins
//! afresh at its own first token. Nobody outside this crate meets the lexer or the parser library.
//!
//! ```
//! use aptc_diagnostics::FileId;
//! use aptc_syntax::{Interner, Options, parse, tree::Body};
//!
//! let mut interner = Interner::default();
//! let parsed = parse(FileId(0), "p1 = POINT/1, 2\nRAPID, GO TO/P1\n", &mut interner, &Options::default());
//! assert!(parsed.diagnostics.is_empty());
//! let Body::Clauses(clauses) = &parsed.program.statements[1].body else { panic!("clauses") };
//! assert_eq!(interner.text(clauses[1].head.symbol), "GOTO");
//! ```

mod cards;
mod characters;
mod climb;
mod fixed;
mod form;
mod format;
mod grammar;
mod identification;
mod interner;
mod lex;
mod message;
mod options;
mod parse;
mod scan;
mod separator;
mod shape;
mod shelf;
mod token;
pub mod tree;

pub use format::{FormatOptions, format};
pub use interner::{Interner, Symbol};
pub use options::{Options, Parsed};
pub use parse::parse;
pub use separator::missing_sign;
