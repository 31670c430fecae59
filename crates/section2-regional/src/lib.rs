//! Section 2: regional milling of sculptured surfaces.
//!
//! SCON sets the areas of a region: the drive curve or surface (DS) that is followed, the part surface
//! (PS) that is cut, the tool axis (AXIS), feeds (FEED) and step-over (STEPOV). SMIL then mills a point
//! (POSN), a line (PATH) or the region (ZIGZAG, PICKFD): points of the drive are projected on the part
//! surface, the cutter is put against it there, and chords are as long as the tolerances let them be.
//!
//! GOLOFT mills a line of constant parameter or a curve, within outlines that CLDAT recorded and REGION named.
//!
//! Source: PS-90-SS-01 vol. II, sections 5.2 and 6, with the corrections that its routines need.

mod afar;
mod area;
mod avoid;
mod axis;
mod bow;
mod checks;
mod contacts;
mod corner;
mod crew;
mod cut_vectors;
mod deepest;
mod drive;
mod ease;
mod failure;
mod followed;
mod gclear;
mod goloft;
mod gomill;
mod guard;
mod guarded;
mod holder;
mod inside;
mod intsec;
mod joints;
mod judge;
mod jump;
mod lanes;
mod outline;
mod path;
mod patience;
mod plain;
mod plotft;
mod position;
mod project;
mod put;
mod region;
mod regional;
mod report;
mod retract;
mod ridge;
mod roll;
mod round;
mod scon;
mod seat;
mod settings;
mod smil;
mod solve;
mod step;
mod stepover;
mod strips;
mod summit;
mod tlproj;
mod touched;
mod unused;
mod warning;
mod watch;
mod within;

pub use crew::{Alone, Crew};
pub use project::{Ends, Met, Probe, Shot};
pub use regional::{Failed, Regional, Stand};
