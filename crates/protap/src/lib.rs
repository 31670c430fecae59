//! The numeric part program (PROTAP): what Section 1 hands to Section 2.
//!
//! One [`Record`] for each statement executed, in order of execution, macros and loops unrolled, geometry
//! in canonical form in the base system. Lengths are in the unit of the last [`Kind::Units`] record,
//! inches without one; angles in degrees as written. [`Outcome`] is the one answer that goes back.

mod motion;
mod record;

pub use motion::{
    AxisAngle, Check, Direction, Drive, DriveSide, Go, OptionSurface, Outcome, PartSide, Place,
    Pocket, Relation, Sense, SurfaceRef, ToolAxis,
};
pub use record::{Arg, Dimension, Edit, Kind, NameRef, Record, Units};
