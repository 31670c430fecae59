//! Motion in the plane square to the tool axis (APT: `ARLM2`): drive and check surfaces are planes or
//! circular cylinders along the axis, the part surface is a plane that is not along it. Everything is in
//! closed form.

mod chords;
mod course;
mod curve;
mod drive;
mod floor;
mod frame;
mod meet;
mod start;
mod stop;

pub(crate) use drive::run;
pub(crate) use frame::Frame;
pub(crate) use start::start;
