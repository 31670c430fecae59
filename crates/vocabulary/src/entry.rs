//! A row of the generated table.

use crate::class::Class;
use crate::dialect::{Code, Dialect};

/// Not a word of the dialect.
pub(crate) const O: u32 = 0;
/// A word of the dialect that has no code.
pub(crate) const K: u32 = u32::MAX;
const RECORD: u32 = 1 << 31;
const SURFACE: u32 = 1 << 30;

/// One word. `codes[dialect]` is `[major, minor]` in stored form.
pub(crate) struct Entry {
    pub(crate) text: &'static str,
    pub(crate) class: Class,
    pub(crate) also: Option<Class>,
    pub(crate) codes: [[u32; 2]; 6],
}

pub(crate) const fn entry(
    text: &'static str,
    class: Class,
    also: Option<Class>,
    codes: [[u32; 2]; 6],
) -> Entry {
    Entry { text, class, also, codes }
}

/// Stored form of a `type:subtype` code.
pub(crate) const fn record(kind: u32, subtype: u32) -> u32 {
    RECORD | kind << 8 | subtype
}

/// Stored form of a surface type.
pub(crate) const fn surface(number: u32) -> u32 {
    SURFACE | number
}

/// Stored form of `code`.
pub(crate) const fn stored(code: Code) -> u32 {
    match code {
        Code::Word(number) => number as u32,
        Code::Surface(number) => surface(number as u32),
        Code::Record { kind, subtype } => record(kind as u32, subtype as u32),
    }
}

const fn code(stored: u32) -> Option<Code> {
    if stored == O || stored == K {
        None
    } else if stored & SURFACE != 0 {
        Some(Code::Surface((stored & 0xFF) as u8))
    } else if stored & RECORD == 0 {
        Some(Code::Word((stored & 0xFFFF) as u16))
    } else {
        let kind = (stored >> 8 & 0xFFFF) as u16;
        Some(Code::Record { kind, subtype: (stored & 0xFF) as u8 })
    }
}

impl Entry {
    /// The stored `[major, minor]` of a dialect. IBM's CL table is PostWorks's with its own words in
    /// front.
    const fn stored(&self, dialect: Dialect) -> [u32; 2] {
        let own = self.codes[dialect.column()];
        match dialect {
            Dialect::IbmCl if own[0] == O && own[1] == O => self.codes[Dialect::PostWorks.column()],
            _ => own,
        }
    }

    pub(crate) const fn is_major(&self, dialect: Dialect) -> bool {
        self.stored(dialect)[0] != O
    }

    pub(crate) const fn is_minor(&self, dialect: Dialect) -> bool {
        self.stored(dialect)[1] != O
    }

    pub(crate) const fn major_code(&self, dialect: Dialect) -> Option<Code> {
        code(self.stored(dialect)[0])
    }

    pub(crate) const fn minor_code(&self, dialect: Dialect) -> Option<Code> {
        code(self.stored(dialect)[1])
    }
}
