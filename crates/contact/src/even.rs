//! Which place counts where a flank lies along a straight line of a surface, or nearly so: all of it touches at once, but for rounding.
//!
//! Along such a line the gap goes evenly, and a search stops anywhere on it. One end of the flank is the deeper; of ends that are as
//! deep as each other that one stays the nearer as the tool goes on at which the gap bends up the least. It is the place of contact,
//! whichever the search came to; of ends that are alike in this too the one far from the corner.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Shape, Surface, Tool, Vec3};

use crate::curvature::second;
use crate::gap::{Gap, Side, deeper};

/// Sine by which a normal is turned from the flank to tell its ends.
const TURN: f64 = 1e-9;
/// Share of the greatest bend by which those at both ends differ.
const ALIKE: f64 = 1e-6;
/// Rounds in which its normal comes to rest.
const ROUNDS: usize = 4;
/// Share of the tool's reach by which an end and its place of the surface may fail to face each other.
const FACING: f64 = 1e-10;

/// The end of the flank that is the place of contact; `None` where the flank does not touch as a whole. `shape` is that of the
/// surface at the known place.
pub(crate) fn end(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
    shape: &Shape,
) -> Option<Gap> {
    let ([_, [wide, low]], n) = (tool.profile.joints(), known.normal);
    let (top, high) = (tool.profile.top_radius(), tool.profile.height());
    let out = -(n - tool.ta * n.dot(&tool.ta)).try_normalize(0.0)?;
    let line = out * (top - wide) + tool.ta * (high - low);
    let even = |change: f64| !deeper(tool, 0.0, change.abs());
    // Most contacts face no flank, and most surfaces bend along it.
    let (faces, bow) = (known.segment == Some(Segment::UpperLine), shape.second(line));
    if !(faces || even(n.dot(&line))) || even(line.norm()) || !bow.is_finite() || !even(bow) {
        return None;
    }
    let around = tool.ta.cross(&out);
    let along = around.cross(&n);
    let beside = |n: Vec3, turn: f64| {
        let p = tool.support(-n + along * turn);
        let foot = surface.foot_from(p.point, known.spot());
        let (raw, normal) = (side.sign() * foot.distance, foot.normal * side.sign());
        Gap {
            g: raw,
            raw,
            tool_point: p.point,
            surface_point: foot.point,
            at: foot.at,
            normal,
            segment: Some(p.segment),
            residual: (tool.support(-normal + along * turn).point - p.point).norm(),
        }
    };
    // The normal of the end itself is another one where the search stopped before it faced the flank.
    let at = |turn: f64| (0..ROUNDS).fold(beside(n, turn), |end, _| beside(end.normal, turn));
    let (low, high) = (at(-TURN), at(TURN));
    let end = if deeper(tool, low.raw, high.raw) {
        low
    } else if deeper(tool, high.raw, low.raw) {
        high
    } else {
        let bend = |gap: &Gap| second(tool, surface, side, gap).map(|shape| shape.second(around));
        let (a, b) = (bend(&low)?, bend(&high)?);
        if a < b - ALIKE * a.abs().max(b.abs()) { low } else { high }
    };
    let there = end.residual <= FACING * tool.profile.reach();
    (there && !deeper(tool, known.raw, end.raw)).then_some(end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::{gap, gap_near};
    use crate::shapes::rulings;
    use aptc_geometry::{Cutter, Profile};

    /// Beside the one ruling that is straight up, the axis along it.
    #[test]
    fn a_flank_along_a_ruling_touches_with_the_end_that_stays_the_nearest() {
        for radii in [[60.0, 90.0], [90.0, 60.0], [-60.0, -90.0], [-90.0, -60.0]] {
            let surface = rulings(radii, 0.0);
            let up = surface.foot(Vec3::zeros()).normal.z;
            let side = if up > 0.0 { Side::Positive } else { Side::Negative };
            for corner in [0.0, 1.0, 4.0] {
                let profile = Profile::new(&Cutter::mill(8.0, corner, 20.0)).unwrap();
                let te = Vec3::new(0.0, -10.0, 4.02);
                let tool = Tool { profile: &profile, te, ta: Vec3::y() };
                // In domes the less bent end, in hollows the more bent one.
                let far = radii[0] < radii[1];
                let high = if far { 20.0 } else { corner };
                for at in [[-3.0, -8.0], [2.0, 0.0], [-0.5, 8.0], [0.0, 3.0], [1e-7, -2.0]] {
                    let start = surface.foot(Vec3::new(at[0], at[1], 0.0)).spot();
                    let found = gap_near(&tool, &surface, side, 0.0, Some(start)).unwrap();
                    assert!((found.raw - 0.02).abs() < 1e-12, "{radii:?} {found:?}");
                    let off = found.tool_point.y - te.y - high;
                    assert!(off.abs() < 1e-6, "{radii:?} {found:?}");
                    let bend = second(&tool, &surface, side, &found).unwrap().second(Vec3::x());
                    let way = 0.5;
                    let beside = |x: f64| {
                        let tool = tool.at(te + Vec3::x() * x);
                        gap(&tool, &surface, side, 0.0).unwrap().raw
                    };
                    let met = (beside(way) + beside(-way) - 2.0 * found.raw) / (way * way);
                    assert!((bend / met - 1.0).abs() < 2e-3, "{bend} {met} {radii:?} {found:?}");
                }
            }
        }
    }
}
