//! The registry of codes: one table a Section, one line a code.
//!
//! A code is stable: its number is never given to another fault. `APT0xxx` files and limits,
//! `APT1xxx` Section 1 (10xx language, 11xx names and values, 12xx geometry, 13xx statements),
//! `APT2xxx` Section 2, `APT3xxx` Section 3 and the reading of CL data, `APT4xxx` Section 4,
//! `APT5xxx` verification.

use std::fmt;

use serde::{Serialize, Serializer};

mod files;
mod section1;
mod section2;
mod section3;
mod section4;
mod verification;

pub use files::*;
pub use section1::*;
pub use section2::*;
pub use section3::*;
pub use section4::*;
pub use verification::*;

/// The stable number of a kind of message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Code(u16);

impl Code {
    /// The number, 1 to 5999.
    pub const fn number(self) -> u16 {
        self.0
    }

    /// The one-line title in the registry.
    pub fn title(self) -> &'static str {
        all().find(|(c, _)| *c == self).map_or("", |(_, t)| t)
    }

    /// The code written `APT1050`, if the registry has it.
    pub fn parse(text: &str) -> Option<Self> {
        let number = text.strip_prefix("APT").or_else(|| text.strip_prefix("apt")).unwrap_or(text);
        let number = number.parse().ok()?;
        all().map(|(c, _)| c).find(|c| c.0 == number)
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "APT{:04}", self.0)
    }
}

impl Serialize for Code {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// Every code with its title, in order of number within each table.
pub fn all() -> impl Iterator<Item = (Code, &'static str)> {
    let tables = [FILES, SECTION1, SECTION2, SECTION3, SECTION4, VERIFICATION];
    tables.into_iter().flatten().copied()
}

/// Declares a table of codes: `TABLE: NAME = 1001, "title";`
macro_rules! codes {
    ($table:ident: $($name:ident = $number:literal, $title:literal;)*) => {
        $(#[doc = $title] pub const $name: super::Code = super::Code($number);)*
        /// The codes of this table with their titles.
        pub(super) const $table: &[(super::Code, &str)] = &[$(($name, $title)),*];
    };
}
use codes;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_number_stands_twice() {
        let mut numbers: Vec<_> = all().map(|(c, _)| c.number()).collect();
        numbers.sort_unstable();
        let n = numbers.len();
        numbers.dedup();
        assert_eq!(n, numbers.len());
    }

    #[test]
    fn a_code_reads_back() {
        for (code, title) in all() {
            assert_eq!(Code::parse(&code.to_string()), Some(code));
            assert_eq!(code.title(), title);
        }
        assert_eq!(Code::parse("APT9999"), None);
    }
}
