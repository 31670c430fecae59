//! Cutter location data: the records that Section 2 makes, Section 3 edits and Section 4 posts.
//!
//! A [`Record`] carries its [`Origin`](aptc_diagnostics::Origin) from the statement on. Lengths are in the
//! unit of the last [`Kind::Units`] record (inches without one), positions in the part frame.

mod catia;
pub mod clfile;
mod dialect;
pub mod diff;
pub mod flatten;
pub mod json;
pub mod milling;
pub mod number;
mod read;
mod record;
mod restore;
mod spool;
pub mod stats;
mod stream;
pub mod tape;
mod text;

pub use catia::CatiaWriter;
pub use clfile::{ClfileReader, ClfileWriter};
pub use dialect::Dialect;
pub use json::{JsonReader, JsonWriter};
pub use number::Decimals;
pub use read::{Reader, TextReader, detect, source};
pub use record::{
    Arc, Arg, Clprnt, Control, Controlled, Course, Edit, Kind, Motion, MotionKind, NameRef, Output,
    Position, Record, Relation, Units, begins_cycle,
};
pub use spool::{Block, Spill, Spool};
pub use stream::{RecordReader, RecordWriter, copy};
pub use tape::{TapeReader, TapeWriter};
pub use text::{TextOptions, TextWriter};

#[cfg(test)]
mod roundtrip_tests;
