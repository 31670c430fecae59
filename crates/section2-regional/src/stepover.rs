//! How far the next path may lie.

use aptc_geometry::{Profile, Vec3};

use crate::area::{DriveArea, Guide, StepoverArea};
use crate::drive::Course;
use crate::position::Position;

/// Distance between two paths on a surface of curvature `k` across them (positive hollow) that leaves a
/// scallop of height `h`, for a cutter whose profile across the path is a circle of radius `r` there;
/// never more than its diameter.
pub(crate) fn scallop_width(r: f64, h: f64, k: f64) -> f64 {
    let h = h.min(r);
    let most = 2.0 * r;
    if h <= 0.0 || r <= 0.0 {
        return 0.0;
    }
    if k.abs() * r < 1e-9 {
        return (2.0 * (2.0 * r * h - h * h).max(0.0).sqrt()).min(most);
    }
    let radius = 1.0 / k.abs();
    // Centres of the paths on the circle of radius c, the ridge on that of radius e.
    let (c, e) = if k < 0.0 { (radius + r, radius + h) } else { (radius - r, radius - h) };
    if c <= 0.0 || e <= 0.0 {
        return 0.0;
    }
    let cos = ((c * c + e * e - r * r) / (2.0 * c * e)).clamp(-1.0, 1.0);
    (2.0 * radius * aptc_geometry::trig::acos(cos)).min(most)
}

/// The step of the parameter across the path behind `points`.
///
/// The smallest over the path: for a fixed distance (scallop 0) the distance itself, else the width at
/// which two neighbouring paths leave the scallop, by the radius of the cutter across the path and the
/// curvature of the part surface there. A negative greatest step is one of the parameter.
pub(crate) fn parameter_step(
    area: &StepoverArea,
    drive: &DriveArea,
    profile: &Profile,
    points: &[Position],
    course: Course,
) -> f64 {
    let by_parameter = area.most < 0.0;
    if area.scallop <= 0.0 && area.most == 0.0 {
        return 1.0;
    }
    if area.scallop <= 0.0 && by_parameter {
        return area.most.abs();
    }
    let mut step = if by_parameter { area.most.abs() } else { f64::INFINITY };
    for (i, p) in points.iter().enumerate() {
        let ahead = path_direction(points, i);
        let place = drive.place(p.drive_uv, course);
        let across = place.across;
        // The part of the step that leads away from the path, as seen on the part surface.
        let side = p.normal.cross(&ahead).try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        let speed = across.dot(&side).abs();
        if speed <= 1e-12 * across.norm() || speed == 0.0 {
            continue;
        }
        let mut width = if by_parameter || area.most == 0.0 { f64::INFINITY } else { area.most };
        if area.scallop > 0.0 {
            let k = across_curvature(drive, p, side);
            width = width.min(scallop_width(radius_across(profile, p, side), area.scallop, k));
        }
        if width.is_finite() && width > 0.0 {
            step = step.min(width / speed);
        }
    }
    if step.is_finite() { step } else { 1.0 }
}

/// Curvature of the surface across the path: that of the drive where it is a surface.
fn across_curvature(drive: &DriveArea, p: &Position, side: Vec3) -> f64 {
    let Guide::Surface(s) = &drive.guide else { return 0.0 };
    let d = s.at(p.drive_uv[0], p.drive_uv[1]);
    d.normal()
        .and_then(|n| d.curvature_along(if n.dot(&p.normal) < 0.0 { -n } else { n }, side))
        .unwrap_or(0.0)
}

/// Radius of the cutter at its contact in the plane of the normal and `side`.
fn radius_across(profile: &Profile, p: &Position, side: Vec3) -> f64 {
    let tool = aptc_contact::Tool { profile, te: p.te, ta: p.ta };
    let s = tool.support(-p.normal);
    let mut curvature = 0.0;
    for (frame, radius) in s.frame.iter().zip(s.radii) {
        let c = frame.dot(&side);
        if radius > 0.0 && c.abs() > 1e-9 {
            curvature += c * c / radius;
        } else if c.abs() > 1e-9 {
            return 0.0;
        }
    }
    if curvature > 0.0 { (1.0 / curvature).min(profile.widest()) } else { profile.widest() }
}

fn path_direction(points: &[Position], i: usize) -> Vec3 {
    let a = &points[i.saturating_sub(1)];
    let b = &points[(i + 1).min(points.len() - 1)];
    (b.contact - a.contact).try_normalize(0.0).unwrap_or_else(Vec3::zeros)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_widths() {
        for (k, w) in [(0.0, 0.632_139_2), (-0.02, 0.602_661_8), (0.02, 0.666_401_1)] {
            assert!((scallop_width(5.0, 0.01, k) - w).abs() < 1e-7, "{k}");
        }
        assert!((scallop_width(5.0, 9.0, 0.0) - 10.0).abs() < 1e-15);
    }

    /// Two balls that far apart on a circle of that curvature leave the scallop between them.
    #[test]
    fn the_ridge_is_as_high_as_asked() {
        for k in [0.03, -0.05, 0.1] {
            let (r, h) = (3.0, 0.05);
            let w = scallop_width(r, h, k);
            let radius = 1.0 / f64::abs(k);
            let angle = w / radius;
            let c = if k < 0.0 { radius + r } else { radius - r };
            // Where the two circles cross, on the ray between.
            let (half, d) = (0.5 * angle, c * aptc_geometry::trig::cos(0.5 * angle));
            let side = c * aptc_geometry::trig::sin(half);
            let reach = (r * r - side * side).sqrt();
            let ridge = if k < 0.0 { d - reach } else { d + reach };
            let height = if k < 0.0 { ridge - radius } else { radius - ridge };
            assert!((height - h).abs() < 1e-12, "{k} {height}");
        }
    }
}
