//! The numeric part program (PROTAP): what Section 1 hands to Section 2.
//!
//! One [`Record`] for each statement executed, in order of execution, macros and loops unrolled, geometry
//! in canonical form in the base system. Lengths are in the unit of the last [`Kind::Units`] record,
//! inches without one; angles in degrees as written. [`Outcome`] is the one answer that goes back.
//!
//! ```
//! use aptc_diagnostics::{FileId, Origin};
//! use aptc_protap::{Kind, Record, read, verify, write};
//!
//! let records = [Record { origin: Origin::default(), kind: Kind::Fini }];
//! let text = write(&records);
//! assert_eq!(read(FileId(0), &text), (records.to_vec(), vec![]));
//! assert!(verify(&records).is_empty());
//! ```

mod motion;
mod record;
mod saved;
mod text;
mod verify;

pub use motion::{
    AxisAngle, Check, Direction, Drive, DriveSide, Go, OptionSurface, Outcome, PartSide, Place,
    Pocket, Relation, Sense, SurfaceRef, ToolAxis,
};
pub use record::{Arg, Clprnt, Dimension, Edit, Kind, NameRef, Record, Units};
pub use saved::{CutContact, CutPoint, CutVectors};
pub use text::{Writer, read, read_in_place, write};
pub use verify::{Verifier, fault_of_form, verify};
