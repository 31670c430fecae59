//! A cutter against a corner of a TABCYL: a straight line along its generatrix.

use aptc_geometry::surface::{OnEdge, TabcylCorner};
use aptc_geometry::{Cylinder, Tool, Vec3};

use crate::edges::Sharp;
use crate::tangents;

/// A corner, its places told by how far they lie along the generatrix.
pub(crate) struct Corner {
    pub(crate) corner: TabcylCorner,
    /// Unit direction of the generatrix.
    pub(crate) along: Vec3,
}

impl Sharp for Corner {
    /// The distance is convex along a line: there is one.
    fn each_least(&self, tool: &Tool<'_>, by: Vec3, take: &mut dyn FnMut(f64, f64)) {
        let line = Cylinder { point: self.corner.point + by, axis: self.along, radius: 0.0 };
        let gap = tangents::oblique_outside(tool, &line);
        take(self.along.dot(&(gap.surface_point - line.point)), gap.raw);
    }

    fn least_beside(&self, tool: &Tool<'_>, by: Vec3, t: f64) -> f64 {
        let mut least = t;
        self.each_least(tool, by, &mut |t, _| least = t);
        least
    }

    fn place(&self, t: f64) -> Option<OnEdge> {
        let TabcylCorner { at, point, mean, .. } = self.corner;
        Some(OnEdge { at, point: point + self.along * t, along: self.along, mean })
    }

    fn all_inwards(&self, _: f64, does: &dyn Fn(Vec3) -> bool) -> bool {
        self.corner.into.into_iter().all(does)
    }
}
