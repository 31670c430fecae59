//! APT words, their classes and codes by dialect

/// A vocabulary word.
#[derive(Copy, Clone, Eq, PartialEq, Ord, PartialOrd, Hash, Debug)]
pub struct Word(pub(crate) u16);
