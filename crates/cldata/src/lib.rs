//! Cutter location data: the records that Section 2 makes, Section 3 edits and Section 4 posts.
//!
//! A [`Record`] carries its [`Origin`](aptc_diagnostics::Origin) from the statement on. Lengths are in the
//! unit of the last [`Kind::Units`] record (inches without one), positions in the part frame.

pub mod number;
mod record;
mod stream;
mod text;

pub use number::Decimals;
pub use record::{
    Arc, Arg, Control, Controlled, Course, Edit, Kind, Motion, MotionKind, NameRef, Output,
    Position, Record, Relation, Units,
};
pub use stream::{RecordReader, RecordWriter, copy};
pub use text::{TextOptions, TextWriter};
