//! The cutter put against a contact.

use aptc_contact::Tool;
use aptc_geometry::{Profile, Segment, Vec3};

/// A position of the tool with its contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Position {
    /// Tool end.
    pub(crate) te: Vec3,
    /// Unit tool axis.
    pub(crate) ta: Vec3,
    /// Parameters of the part surface at the contact.
    pub(crate) part_uv: [f64; 2],
    /// The contact on the part surface.
    pub(crate) contact: Vec3,
    /// Unit normal there, towards the tool.
    pub(crate) normal: Vec3,
    /// What the position takes of the tolerance, positive off the surface.
    pub(crate) shift: f64,
    /// Parameters of the drive.
    pub(crate) drive_uv: [f64; 2],
    /// What of the cutter touches; the arc where the tool end lies on the surface.
    pub(crate) segment: Segment,
    /// What avoidance has moved the tool end by.
    pub(crate) lift: Vec3,
}

/// The first tool ends at which the cutter touches with a place that does not cut well.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Odd {
    /// With its tip.
    pub(crate) tip: Option<Vec3>,
    /// With the edge of its top.
    pub(crate) rim: Option<Vec3>,
}

impl Odd {
    pub(crate) fn of(points: &[Position]) -> Self {
        let first = |s: Segment| points.iter().find(|p| p.segment == s).map(|p| p.te);
        Self { tip: first(Segment::Tip), rim: first(Segment::Rim) }
    }

    /// What stands here, else what stands there.
    pub(crate) fn or(self, other: Self) -> Self {
        Self { tip: self.tip.or(other.tip), rim: self.rim.or(other.rim) }
    }
}

/// The tool end for a contact at `contact` whose unit normal `n` points to the tool, with `thick` between
/// cutter and surface.
///
/// APT: `TULPOS`, `TECALC`, for all seven segments: the place of the cutter whose outward normal is `-n`.
/// Where a flat bottom lies on the surface, the contact is under the corner on the side of `last`, the
/// unit direction square to the axis from the contact to the axis of the position before.
pub(crate) fn tool_end(
    profile: &Profile,
    ta: Vec3,
    contact: Vec3,
    n: Vec3,
    thick: f64,
    last: Vec3,
) -> Vec3 {
    let tool = Tool { profile, te: Vec3::zeros(), ta };
    let radial = n - ta * n.dot(&ta);
    let [rho, z] = profile.joints()[0];
    let lowest = -tool.support(-ta).reach;
    let flat = (z - lowest).abs() <= 1e-12 * profile.reach();
    // The squared sine below which normal and axis are taken for parallel.
    let place = if flat && radial.norm_squared() < 1e-12 && n.dot(&ta) > 0.0 {
        let out = -(last - ta * last.dot(&ta)).try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        out * rho + ta * lowest
    } else {
        tool.support(-n).point
    };
    contact + n * thick - place
}

/// Unit direction square to the axis from a contact to the axis, `None` where the normal stands along it.
pub(crate) fn toward_axis(n: Vec3, ta: Vec3) -> Option<Vec3> {
    let radial = n - ta * n.dot(&ta);
    (radial.norm_squared() >= 1e-12).then(|| radial.normalize())
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::Cutter;

    #[test]
    fn published_positions() {
        let ball = Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap();
        let ta = Vec3::new(0.3, -0.4, 1.0).normalize();
        let te = tool_end(&ball, ta, Vec3::zeros(), Vec3::z(), 0.0, Vec3::x());
        assert!((te - (Vec3::z() - ta) * 5.0).norm() < 1e-14);
        let bull = Profile::new(&Cutter::mill(20.0, 3.0, 40.0)).unwrap();
        let ta = Vec3::new(0.5, 0.0, 0.75_f64.sqrt());
        let te = tool_end(&bull, ta, Vec3::zeros(), Vec3::z(), 0.0, Vec3::x());
        assert!((te - Vec3::new(-7.562_177_8, 0.0, 3.901_923_8)).norm() < 1e-6, "{te}");
        // The same surface parametrised the other way round gives the same normal, hence the same place;
        // thickness lifts along it.
        let lifted = tool_end(&bull, ta, Vec3::zeros(), Vec3::z(), 0.25, Vec3::x());
        assert!((lifted - te - Vec3::z() * 0.25).norm() < 1e-15);
    }

    #[test]
    fn a_flat_bottom_keeps_the_side_of_the_last_contact() {
        let flat = Profile::new(&Cutter::mill(20.0, 3.0, 40.0)).unwrap();
        let te = tool_end(&flat, Vec3::z(), Vec3::zeros(), Vec3::z(), 0.0, -Vec3::y());
        assert!((te - Vec3::new(0.0, -7.0, 0.0)).norm() < 1e-14, "{te}");
    }
}
