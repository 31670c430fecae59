//! Section 2: the arithmetic element. PROTAP records go in, in order; CL records come out.
//!
//! A motion along surfaces is prepared (APT: `AREPRE`), run in the plane (`plane`, APT:
//! `ARLM2`) where all surfaces allow it, and stops at its check surface. Start-up motions (APT:
//! `STRTUP`) bring the tool to its first surfaces.

mod along;
mod arelem;
mod axis;
mod beyond;
mod build;
mod diagram;
mod failure;
mod feed;
mod fitted;
mod forward;
mod naming;
mod plane;
mod pocket;
mod points;
mod prepare;
mod scene;
mod since;
mod space;
mod state;
mod warning;

pub use arelem::{Arelem, Options};
pub use diagram::Situation;
