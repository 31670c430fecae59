//! The words of APT: spelling, class, and integer codes by dialect.
//!
//! One table, `words.tsv`, holds every word; `cargo xtask codegen` turns it into [`word`] and the
//! lookups. A word is known in some dialects and not in others, and its code differs between them: AT
//! is 175 in APT-360 and 189 in APT4. So nothing here gives a code without a [`Dialect`].
//!
//! ```
//! use aptc_vocabulary::{Class, Code, Dialect, closest, find, word};
//!
//! let golft = find("GOLFT").expect("a word of APT");
//! assert_eq!(golft, word::GOLFT);
//! assert_eq!(golft.class(), Class::Motion);
//! assert_eq!(golft.code(Dialect::Apt360), Some(Code::Record { kind: 8000, subtype: 1 }));
//! assert_eq!(closest("GOLFTT", |_| true), Some(word::GOLFT));
//! ```

mod class;
mod closest;
mod dialect;
mod entry;
mod lookup;
mod table;
mod words;

pub use class::Class;
pub use closest::closest;
pub use dialect::{Code, Dialect};
pub use lookup::{find, find_in, from_code};
pub use table::word;
pub use words::{Word, all};
