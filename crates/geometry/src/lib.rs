//! Points, curves, surfaces, matrices and the cutter: definitions and evaluation.
//!
//! All lengths of a scene are in one unit, which nobody here needs to know: tolerances are arguments and
//! every constant is a ratio. Angles are in radians unless the name ends in `_deg`.
//!
//! ```
//! use aptc_geometry::{Form, Plane, Vec3};
//! let top = Form::Plane(Plane::new(Vec3::new(0.0, 0.0, 2.0), 3.0).unwrap());
//! assert_eq!(top.canonical(), [0.0, 0.0, 1.0, 1.5]);
//! ```

mod balls;
mod cutter;
mod form;
mod forms;
mod polyconic;
pub mod polynomial;
pub mod profile;
mod reason;
pub mod roots;
mod ruled;
pub mod sculpt;
pub mod sculptured;
pub mod shell;
pub mod surface;
mod tabcyl;
mod tabcyl_fit;
mod tabcyl_meet;
mod tabcyl_spline;
mod tool;
mod transform;
mod transformed;
pub mod trig;
mod units;

pub use balls::{Ball, Below, Held, balls};
pub use cutter::Cutter;
pub use form::{Form, FormKind, Written};
pub use forms::{Circle, Cone, Cylinder, Line, Pattern, Plane, Quadric, QuadricKind, Sphere};
pub use polyconic::{ControlCurve, Polyconic, Section};
pub use profile::{BadCutter, CutterWarning, Profile, Segment};
pub use reason::{Place, Reason};
pub use ruled::{Rail, RuledSurface, Second};
pub use sculpt::{Sculptured, SpaceCurve};
pub use shell::Shell;
pub use surface::{Fiop, Foot, Shape, Spot, Surface};
pub use tabcyl::{Tabcyl, TabcylSpan, Vec2};
pub use tabcyl_fit::{Fit, FitError, Knot};
pub use tabcyl_meet::{CurveFoot, nearest_foot};
pub use tool::{Tool, ToolFarthest, ToolNear, ToolSupport};
pub use transform::Transform;
pub use transformed::NotCarried;
pub use units::Units;

/// A point or a vector; which of the two the name says.
pub type Vec3 = nalgebra::Vector3<f64>;
