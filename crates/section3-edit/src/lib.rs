//! Section 3: COPY, TRACUT, INDEX and plots of cutter location data.
//!
//! The [`Editor`] takes the records of Section 2 one by one and puts out the edited ones: INDEX, COPY and
//! TRACUT carried out (their records stay in the stream, where the post-processor passes over them),
//! VTLAXS and WCORN made into tilted positions. What a COPY may want again is kept in a
//! [`Spool`](aptc_cldata::Spool), which a file of Section 0 can take over when it grows.
//!
//! ```
//! use aptc_cldata::{Edit, Kind, Motion, Position, Record};
//! use aptc_edit::Editor;
//! use aptc_geometry::{Transform, Vec3};
//!
//! let goto = Motion { points: vec![Position::upright(Vec3::x())], ..Motion::default() };
//! let step = Transform::translation(Vec3::y());
//! let program = [
//!     Kind::Edit(Edit::Index { n: 1.0, close: false }),
//!     Kind::Motion(goto),
//!     Kind::Edit(Edit::Copy { n: 1.0, step, count: 2 }),
//! ];
//! let mut editor = Editor::new();
//! let mut out: Vec<Record> = Vec::new();
//! for kind in program {
//!     editor.push(&Record { kind, ..Record::default() }, &mut out).unwrap();
//! }
//! editor.finish(&mut out).unwrap();
//! let n = out.iter().filter(|r| matches!(r.kind, Kind::Motion(_))).count();
//! assert_eq!(n, 3);
//! ```

mod carry;
mod editor;
mod listing;
mod plot;
mod subprogram;
mod vtlaxs;

pub use editor::Editor;
pub use listing::Listing;
pub use plot::{Plot, plot_svg};
pub use subprogram::Subprograms;
