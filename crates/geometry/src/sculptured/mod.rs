//! SCURV, SSURF, BOUNDS and OBJECT as they were defined: every argument resolved, nothing fitted yet.
//!
//! Section 1 reads and checks the statement and writes these; what evaluates curves and surfaces starts
//! from them. All points and vectors stand in the system of the definition, lengths in program units,
//! angles in degrees; `map` (TRFORM first, REFSYS after it) carries the finished curve or surface into the
//! base system. Curves and surfaces that a definition names are held by value, with their own `map`.

mod curve;
mod numbers;
mod solid;
mod surface;

use serde::{Deserialize, Serialize};

use crate::Vec3;
pub use curve::{CurveDefinition, CurveShape, FlowLaw, FlowSpan, SegmentSpan};
pub use solid::{Side, Solid};
pub use surface::{
    BsplineSurface, MeshKind, MeshSpacing, MeshSpline, Patch, PatchKind, SurfaceDefinition,
    SurfaceShape, Sweep,
};

/// A point of a curve or of a spline of a surface, with what is asked of the curve there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Knot {
    /// The point.
    pub point: Vec3,
    /// TANSPL: direction and length along the curve.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tangent: Option<Vec3>,
    /// CRSSPL: direction across it, for the surface that uses the curve.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cross: Option<Vec3>,
    /// NORMAL: the normal of the surface.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub normal: Option<Vec3>,
    /// WEIGHT and LIMIT behind the point, in place of those for all.
    #[serde(default, skip_serializing_if = "Smoothing::is_none")]
    pub smoothing: Smoothing,
}

/// How far a smoothed curve may leave its points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Smoothing {
    /// WEIGHT: how much a point's distance counts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weight: Option<f64>,
    /// LIMIT: greatest distance.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limit: Option<f64>,
}

/// How large a definition is with all that it holds; whoever builds one from others bounds it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extent {
    /// Points, or surfaces of a solid.
    pub points: usize,
    /// Definitions within each other; 1 for one that holds none.
    pub depth: usize,
}

impl Extent {
    /// A definition of `points` points that holds others.
    fn of(points: usize, held: impl IntoIterator<Item = Self>) -> Self {
        let mut whole = Self { points, depth: 0 };
        for part in held {
            whole.points = whole.points.saturating_add(part.points);
            whole.depth = whole.depth.max(part.depth);
        }
        whole.depth += 1;
        whole
    }
}

impl Smoothing {
    /// Is neither WEIGHT nor LIMIT given?
    pub fn is_none(&self) -> bool {
        self.weight.is_none() && self.limit.is_none()
    }
}
