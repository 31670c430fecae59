//! Where a surface that is moved overlaps itself at edges.
//!
//! A tool that has no point at the shift from the surface, and one on the right side of that, has none on the other: so of the surface
//! that is moved only what lies at the shift from all of it counts. Beside an edge on whose inner side the faces are moved they go
//! through each other, and what lies behind the other face is nearer to that.

use aptc_geometry::Vec3;

use super::Moved;
use crate::each::two;
use crate::sheet::Patch;
use crate::tool::{Pose, Tool};
use crate::witness::descend;

/// Shifts from a border of its chart within which a piece is looked at.
const NEAR: f64 = 4.0;
/// Share of the numbers by which a distance may be rounded.
const ROUNDING: f64 = 1e-14;

impl Moved<'_> {
    /// Is all within `radius` of a place to which a piece is moved nearer to a face beside it than the shift, by more than rounding?
    pub(super) fn is_overlapped(&self, patch: &Patch, x: Vec3, radius: f64) -> bool {
        let shift = self.shift.abs() - ROUNDING * (self.shift.abs() + x.norm());
        if !self.overlaps || radius >= shift {
            return false;
        }
        let pose = Pose { te: x, ta: Vec3::z() };
        // What closes a gap counts as a piece of the face beside it.
        let base = self.sheet.on_face(patch.spot());
        let rates = self.sheet.jet(&base).d.map(|d| d.norm());
        (0..2).any(|k| {
            let half = if base.chart == patch.chart { patch.half[k] } else { 0.0 };
            let far = half + NEAR * shift / rates[k];
            let beside = two([-far, far], |by| {
                let mut spot = base;
                spot.at[k] += by;
                self.sheet.settle(spot)
            });
            // The way down from either side may lead over the edge.
            far.is_finite()
                && beside.iter().any(|spot| spot.chart != patch.chart)
                && beside
                    .into_iter()
                    .any(|spot| descend(&Tool::End, &pose, self.sheet, spot).0 < shift - radius)
        })
    }
}
