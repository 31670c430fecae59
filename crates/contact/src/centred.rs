//! Chords on which the gap is the distance of one moving point from a point or a line: a round cutter, or its
//! end, at a sphere or a cylinder.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Surface, Tool, Vec3};

use crate::chord::Extreme;
use crate::gap::{Condition, Gap, Side};

/// The extreme gap between the ends of the chord along `v`, least outside and greatest inside of the surface;
/// `ends` are the gaps at both.
///
/// `None` when something else than the arc about the one centre may touch. The arc begins on the axis and faces no
/// more than half of all directions, so that what lies between two of its normals is one too.
pub(crate) fn extreme(
    tool: &Tool<'_>,
    v: Vec3,
    surface: &Surface,
    condition: Condition,
    side: Side,
    ends: [&Gap; 2],
) -> Option<Extreme> {
    let profile = tool.profile;
    let center = match condition {
        Condition::On => tool.te,
        Condition::Touch => {
            let arc = ends.iter().all(|g| g.segment == Some(Segment::Arc));
            let from_the_axis = profile.joints()[0][0] <= 0.0;
            (arc && profile.is_round() && from_the_axis)
                .then(|| tool.te + tool.ta * profile.corner()[1])?
        }
    };
    let (from, by) = match surface {
        Surface::Sphere(s) => (center - s.center, v),
        Surface::Cylinder(s) => (s.radial(center), v - s.axis * v.dot(&s.axis)),
        _ => return None,
    };
    let sign = match side {
        Side::Positive => 1.0,
        Side::Negative => -1.0,
        Side::Open => return None,
    };
    let t = -from.dot(&by) / by.norm_squared();
    if t > 0.0 && t < 1.0 {
        let change = (from + by * t).norm() - from.norm();
        return Some(Extreme { t, g: ends[0].g + sign * change });
    }
    // Without a place between them the nearer end is the extreme one.
    let first = sign * ends[0].g <= sign * ends[1].g;
    let (t, end) = if first { (0.0, ends[0]) } else { (1.0, ends[1]) };
    Some(Extreme { t, g: end.g })
}
