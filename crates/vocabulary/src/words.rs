//! A word as a value.

use std::fmt;

use crate::class::Class;
use crate::dialect::{Code, Dialect};
use crate::entry::Entry;
use crate::table::{COUNT, ENTRIES};

/// A word of the table. Words compare and sort as their spellings do.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Word(pub(crate) u16);

impl Word {
    /// The spelling, in capitals.
    pub const fn text(self) -> &'static str {
        self.entry().text
    }

    /// What the word is for; of two uses, the one at the head of a statement.
    pub const fn class(self) -> Class {
        self.entry().class
    }

    /// A second use: TOOL defines geometry and is a modifier of LOAD.
    pub const fn also(self) -> Option<Class> {
        self.entry().also
    }

    /// Whether one of the word's uses is of `class`.
    pub fn is(self, class: Class) -> bool {
        self.class() == class || self.also() == Some(class)
    }

    /// Whether the dialect knows the word.
    pub const fn is_in(self, dialect: Dialect) -> bool {
        self.is_major(dialect) || self.is_minor(dialect)
    }

    /// Whether the word heads statements of the dialect (or names one of its functions).
    pub const fn is_major(self, dialect: Dialect) -> bool {
        self.entry().is_major(dialect)
    }

    /// Whether the word stands among the arguments of the dialect's statements.
    pub const fn is_minor(self, dialect: Dialect) -> bool {
        self.entry().is_minor(dialect)
    }

    /// The word's code in a dialect, the major one where it has both; `None` where the dialect does not
    /// know the word or knows it without a code.
    pub const fn code(self, dialect: Dialect) -> Option<Code> {
        match self.major_code(dialect) {
            None => self.minor_code(dialect),
            code => code,
        }
    }

    /// The word's code at the head of a statement.
    pub const fn major_code(self, dialect: Dialect) -> Option<Code> {
        self.entry().major_code(dialect)
    }

    /// The word's code among arguments. Where a dialect lists two, the first: ZIGZAG is 177 and 185 in
    /// APT4, and [`from_code`](crate::from_code) knows both.
    pub const fn minor_code(self, dialect: Dialect) -> Option<Code> {
        self.entry().minor_code(dialect)
    }

    const fn entry(self) -> &'static Entry {
        &ENTRIES[self.0 as usize]
    }
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.text())
    }
}

impl fmt::Debug for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text())
    }
}

/// Every word, in alphabetical order.
pub fn all() -> impl ExactSizeIterator<Item = Word> {
    (0..COUNT).map(Word)
}
