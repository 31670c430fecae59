//! Section 4: from cutter location data to machine director text.
//!
//! A [`Machine`] is data; a [`Post`] takes CL records one at a time, keeps what the control knows, and
//! writes blocks. Nothing here reads a file or knows APT's source language.
//!
//! ```
//! use aptc_cldata::{Kind, Motion, Position, Record};
//! use aptc_geometry::Vec3;
//! use aptc_post::{Post, PostOptions, machine};
//!
//! let record = |kind| Record { origin: Default::default(), kind };
//! let goto = |x, y, z| {
//!     let points = vec![Position::upright(Vec3::new(x, y, z))];
//!     record(Kind::Motion(Motion { points, ..Motion::default() }))
//! };
//! let feed = Kind::Post { word: "FEDRAT".into(), args: vec![aptc_cldata::Arg::Number(20.0)] };
//! let mut post = Post::new(machine("linuxcnc-mill").unwrap(), PostOptions::default());
//! let mut text = Vec::new();
//! for r in [record(feed), goto(0.0, 0.0, 1.0), goto(2.5, 0.0, 1.0), record(Kind::Fini)] {
//!     post.push(&r, &mut text);
//! }
//! let done = post.finish(&mut text);
//! assert!(!done.diagnostics.iter().any(|d| d.is_error()));
//! assert!(String::from_utf8(text).unwrap().contains("\nX2.5\n"));
//! ```

mod angles;
mod approach;
mod arc;
mod args;
mod count;
mod drill;
mod emit;
mod feed;
mod fit;
mod fitting;
mod frame;
mod held;
mod index;
mod kinematics;
mod machine;
mod motion;
mod multiaxis;
mod nc_reader;
mod number;
mod pecks;
mod pose;
mod post;
mod readback;
mod report;
mod rotary_feed;
mod roundtrip;
mod setup;
mod state;
mod stock;
mod threading;
mod turning;
mod turnmill;
mod words;

pub use machine::{
    ArcCenter, ArcPlane, Arcs, Axis, BlockNumbers, Carries, Compensation, Cycle, CycleWord,
    CycleWords, Dialect, Feed, Format, Machine, MachineKind, Milling, Multiaxis, OutputUnits,
    Program, Rapid, RapidPath, Rotary, RotaryFeed, Spindle, Turning, TurningPlane, Wrap,
    machin_names, machine, machine_file, machine_for, machines,
};
pub use nc_reader::NcReader;
pub use post::{Post, PostOptions, Posted, ToolScan, post_all};
pub use report::{AxisUse, BlockOrigin, Extent, Summary, ToolUse};
pub use roundtrip::{Proof, prove};
pub use setup::{SetupSheet, setup_html, setup_text};
pub use words::{Treatment, treatment};
