//! Why a routine has no answer.

use crate::Vec3;

/// What every solver answers when it cannot give the value. Nothing is kept from an earlier call.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reason {
    /// The direction runs along the surface, or two surfaces run side by side.
    Parallel,
    /// No admissible intersection or contact exists.
    NoHit,
    /// Every value is an answer: the line lies in the surface.
    AllHit,
    /// The answer is not defined at this place.
    Degenerate(Place),
    /// The search ended at its bound; the best place found and what is left of its condition.
    NotConverged {
        /// Best point found.
        best: Vec3,
        /// How far its condition is from being satisfied.
        residual: f64,
    },
    /// The point lies outside the region where the surface is defined.
    OutOfDomain,
}

/// Where a normal or a direction is not defined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// At the centre of a sphere or quadric.
    Center,
    /// On the axis of a cylinder, a cone or the tool.
    Axis,
    /// At the vertex of a cone, or where the vertex is the nearest point.
    Vertex,
    /// Where the gradient of a quadric vanishes, or on the edge of a patch.
    Singular,
    /// Two things that must differ coincide.
    Coincident,
    /// A direction of length zero, or a number that is not finite.
    Direction,
}
