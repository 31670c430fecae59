//! One surface that the tool keeps to, and how near it has to stay.

use aptc_contact::{Condition, Gap, Reason, Side, Tool, distance, second};
use aptc_geometry::{Profile, Surface, Vec3};

/// A tool position: tool end and unit tool axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose {
    pub(crate) te: Vec3,
    pub(crate) ta: Vec3,
}

/// A surface with what is asked of the tool against it.
#[derive(Clone, Debug)]
pub(crate) struct Keep {
    /// What touches it.
    pub(crate) profile: Profile,
    pub(crate) surface: Surface,
    pub(crate) condition: Condition,
    pub(crate) side: Side,
    pub(crate) thick: f64,
    pub(crate) intol: f64,
    pub(crate) outtol: f64,
}

/// Least and greatest gap allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Limits {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// Share of the band that vertices keep from its edge, so that rounding does not carry them out.
const EDGE: f64 = 1e-7;

impl Keep {
    pub(crate) fn tool(&self, pose: &Pose) -> Tool<'_> {
        Tool { profile: &self.profile, te: pose.te, ta: pose.ta }
    }

    /// The gap; a search starts at the surface point `start`.
    #[inline]
    pub(crate) fn gap(&self, pose: &Pose, start: Option<Vec3>) -> Result<Gap, Reason> {
        let tool = self.tool(pose);
        distance(&tool, &self.surface, self.condition, self.side, self.thick, start)
    }

    /// Second derivative of the gap when the tool end moves along the unit vector `v`.
    #[inline]
    pub(crate) fn bend(&self, pose: &Pose, gap: &Gap, v: Vec3) -> f64 {
        second(&self.tool(pose), &self.surface, self.side, gap).map_or(0.0, |s| s.second(v))
    }

    pub(crate) fn is_plane(&self) -> bool {
        matches!(self.surface, Surface::Plane(_))
    }

    /// The band. With the tool end on the surface its positive side counts as outside.
    pub(crate) fn limits(&self) -> Limits {
        Limits { low: -self.intol, high: self.outtol }
    }

    /// Where in the band a vertex lies when the gap bends by `bend` along the path and the cut vectors use
    /// the share `share` of the band: outside where the surface is round, so that the middle of the cut
    /// vectors may go in, and inside where it is hollow.
    pub(crate) fn target(&self, bend: f64, share: f64) -> f64 {
        let limits = self.limits();
        let edge = EDGE * (limits.high - limits.low);
        if bend > 0.0 {
            share * (limits.high - edge).max(0.0)
        } else if bend < 0.0 {
            share * (limits.low + edge).min(0.0)
        } else {
            0.0
        }
    }

    /// Width of the band.
    pub(crate) fn width(&self) -> f64 {
        self.intol + self.outtol
    }
}
