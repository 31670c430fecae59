//! How the tool is led away from the surface between passes.

use aptc_geometry::{Plane, Vec3};

/// How the tool is led away from the surface between passes.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Retract {
    /// To a plane, along its normal.
    Plane(Plane),
    /// So far along the tool axis.
    Along(f64),
    /// By a vector.
    By(Vec3),
}

impl Retract {
    /// The tool led away.
    pub(crate) fn above(&self, (te, ta): (Vec3, Vec3)) -> (Vec3, Vec3) {
        let te = match self {
            Self::Plane(plane) => te - plane.n * plane.distance(te),
            Self::Along(d) => te + ta * *d,
            Self::By(v) => te + v,
        };
        (te, ta)
    }

    /// From one place of the tool to another by way of those above them.
    pub(crate) fn over(&self, from: (Vec3, Vec3), to: (Vec3, Vec3)) -> [(Vec3, Vec3); 3] {
        [self.above(from), self.above(to), to]
    }
}
