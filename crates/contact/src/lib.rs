//! Cutter against surfaces: normal distance, gap, penetration, swept gap.
//!
//! The *gap* is the least signed distance of the tool's points from the surface: positive when the tool is
//! clear, negative by its depth when it cuts in. Its gradient by the tool end is the surface's unit normal,
//! so Newton's method on gaps converges quadratically, also through sharp edges of the cutter.
//!
//! ```
//! use aptc_contact::{Side, Tool, gap};
//! use aptc_geometry::{Cutter, Profile, Sphere, Surface, Vec3};
//!
//! let ball = Profile::new(&Cutter::mill(10.0, 5.0, 50.0)).expect("a ball cutter");
//! let dome = Surface::Sphere(Sphere { center: Vec3::new(0.0, 0.0, -10.0), radius: 10.0 });
//! let tool = Tool { profile: &ball, te: Vec3::new(0.0, 0.0, 2.0), ta: Vec3::z() };
//! let gap = gap(&tool, &dome, Side::Positive, 0.0).expect("closed form");
//! assert!((gap.g - 2.0).abs() < 1e-14);
//! assert_eq!(gap.normal, Vec3::z());
//! ```

mod alone;
mod barrel;
mod beneath;
mod bodies;
mod centred;
mod chord;
mod closed;
mod corners;
mod crests;
mod crossing;
mod curvature;
mod descent;
mod dips;
mod disk;
mod edges;
mod even;
mod gap;
mod guide;
mod open;
mod patches;
mod places;
mod point;
mod ridge;
mod ring;
mod rings;
mod search;
mod sections;
mod shank;
#[cfg(test)]
mod shapes;
mod stations;
mod tangents;
mod turned;
mod turning;
mod under;
mod wall;

pub use aptc_geometry::surface::kept::opens;
pub use aptc_geometry::{Place, Reason, Tool};
pub use bodies::{Convex, Swept};
pub use chord::{Chord, Exact, Extreme, chord};
pub use curvature::second;
pub use gap::{
    Condition, Gap, Side, distance, elsewhere, gap, gap_at, gap_near, on, surrounds, touches_once,
};
pub use guide::{ClosedGuide, End, Guide, Passed, Reading};
pub use patches::{Clear, PIECES, PatchPlace, PatchTree};
pub use point::PointGuide;
pub use turned::{axis_between, bulge};
pub use under::{Cell, Low};
