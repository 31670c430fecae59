//! Cards, tokens and statement trees of APT part programs.
//!
//! Knows words, not meanings: [`parse`] turns text into a [`tree::Program`] and never fails as a whole.
//! A statement that cannot be read becomes [`tree::Body::Error`] with one diagnostic; the next begins
//! afresh at its own first token. Nobody outside this crate meets the lexer or the parser library.

mod interner;
pub mod tree;

pub use interner::{Interner, Symbol};
