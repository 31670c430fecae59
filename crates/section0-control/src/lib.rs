//! Section 0: conducts the Sections over a [`World`]; the face of the library.

mod world;

pub use world::{Disk, Memory, Source, World, WorldError};
