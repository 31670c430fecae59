//! Sculptured curves and surfaces: SCURV and SSURF.
//!
//! Every curve is a chain of rational cubic arcs, every surface a set of rational bicubic patches, all in
//! homogeneous Bezier form. A parameter counts spans: 2.25 is a quarter of the way through the third arc.
//! u runs along the splines of a surface, v across them; patches are numbered along u first.
//!
//! The rules by which tangents are chosen are those of CAM-I's APT4 (SSV3): a spline through points is
//! the twice differentiable cubic over the chords with a parabola's direction at free ends; in a curve the
//! lengths of its tangents make each arc's bending energy least, in a mesh each is the mean chord of its
//! span over all splines. Found from its printed results.

mod arc;
mod bends;
mod borders;
mod bspline;
mod canon;
mod conic;
mod cross;
mod curve;
mod fitted;
mod flow;
mod loft;
mod meet;
mod mesh;
mod nearest;
mod network;
mod normals;
mod pair;
mod patch;
mod patches;
mod smooth;
mod spline;
mod surface;
mod together;
mod trimmed;

pub use arc::{ArcPoint, CubicArc, Vec4, flat, weighted};
pub use bends::Bends;
pub use borders::Border;
pub use bspline::{BsplineFault, MAX_DEGREE, blossom, bspline};
pub use conic::{ConicCondition, ConicFault, conic_arc, line_arc};
pub use cross::{Product, cross_product, revolve, ruled, swept};
pub use curve::{CurveAt, SpaceCurve};
pub use fitted::{FitFault, fit_curve, fit_surface};
pub use flow::{Flow, FlowKind, FlowSpan, SegmentKind, SegmentSpan};
pub use loft::{LoftFault, loft};
pub use meet::{Cutting, MeetCurve, MeetFault, MeetPoint, MeetSide, meet};
pub use mesh::{MeshFault, mesh};
pub use nearest::{SurfaceHit, along_line, nearest_from, nearest_on};
pub use pair::Pair;
pub use patch::{Derivatives, Patch};
pub use patches::{filled, from_points, from_polygon, from_vectors};
pub use smooth::smooth;
pub use spline::{SplineFault, SplinePoint, spline, tangents};
pub use surface::{Layout, SculptFault, Sculptured};
pub use together::Origin;
pub use trimmed::circle_between;

/// The whole number at or below `x`, 0 for negative numbers and those that are none.
#[expect(
    clippy::cast_possible_truncation,
    reason = "casts from f64 saturate, which is what is meant"
)]
pub(crate) fn whole(x: f64) -> usize {
    x as usize
}
