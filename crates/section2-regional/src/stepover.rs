//! How far the next path may lie.

use aptc_geometry::{Profile, Vec3};

use crate::area::{Hold, StepoverArea};
use crate::drive::Course;
use crate::position::Position;
use crate::solve::Setup;

/// A cutter that nearly fills a hollow moves its contact so many times as fast as itself, at most the inverse.
const LEAST: f64 = 0.05;

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
    setup: &Setup<'_>,
    points: &[Position],
    course: Course,
) -> f64 {
    let Setup { drive, profile, .. } = *setup;
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
        // The part of the step that leads away from the path, as seen on the part surface.
        let side = p.normal.cross(&ahead).try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        let k = across_curvature(setup, p, side);
        let radius = radius_across(profile, p, side);
        let across = laid(place.across, place.direction, p.normal);
        let mut speed = across.dot(&side).abs();
        if setup.part.touches && drive.hold == Hold::On {
            // It is the tool that is led: in a hollow its contact moves faster, on a hump more slowly.
            speed /= (1.0 - k * radius).max(LEAST);
        }
        if speed <= 1e-12 * across.norm() || speed == 0.0 {
            continue;
        }
        let mut width = if by_parameter || area.most == 0.0 { f64::INFINITY } else { area.most };
        if area.scallop > 0.0 {
            width = width.min(scallop_width(radius, area.scallop, k));
        }
        if width.is_finite() && width > 0.0 {
            step = step.min(width / speed);
        }
    }
    if step.is_finite() { step } else { 1.0 }.min(area.parameter.unwrap_or(f64::INFINITY))
}

/// A step of the drive as the tool takes it: projected along the line of projection on the plane that touches
/// the part surface.
fn laid(across: Vec3, direction: Option<Vec3>, n: Vec3) -> Vec3 {
    let Some(along) = direction else { return across };
    let down = n.dot(&along);
    if down.abs() < 1e-6 { across } else { across - along * (n.dot(&across) / down) }
}

/// Curvature of the part surface across the path.
fn across_curvature(setup: &Setup<'_>, p: &Position, side: Vec3) -> f64 {
    let d = setup.part.surface.at(p.part_uv[0], p.part_uv[1]);
    d.curvature_along(p.normal, side).unwrap_or(0.0)
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
