//! The tool axis at a place.

use aptc_geometry::{Vec3, trig};

use crate::area::AxisArea;
use crate::drive::DrivePoint;

/// The axis before the part surface is met; for an axis tilted against the part surface this is where the
/// search for it starts.
///
/// APT: `AXSET`. The slew is towards the direction across the path, laid square to the normal, the tilt
/// towards the motion. `None` where normal or directions vanish.
pub(crate) fn at_drive(area: &AxisArea, p: &DrivePoint, forward: Vec3) -> Option<Vec3> {
    match *area {
        AxisArea::Fixed(v) => Some(v),
        AxisArea::NormDs(sign) => p.normal.map(|n| n * sign),
        AxisArea::Angle { part: true, .. } => p.normal.or_else(|| p.direction.map(|d| -d)),
        AxisArea::Angle { part: false, alpha, beta } => {
            let n = p.normal?;
            let (sa, ca) = trig::sin_cos(alpha);
            let slewed = if alpha == 0.0 { n } else { n * ca + square(p.across, n)? * sa };
            let (sb, cb) = trig::sin_cos(beta);
            if beta == 0.0 {
                return Some(slewed);
            }
            Some(slewed * cb + square(forward, slewed)? * sb)
        }
    }
}

/// The axis at a contact with the part surface whose unit normal `n` points to the tool.
///
/// APT: `SSPATH` for ITAC = 2, with unit directions of roll and pitch. `over` points to the side of the
/// step-over.
pub(crate) fn at_part(alpha: f64, beta: f64, n: Vec3, forward: Vec3, over: Vec3) -> Option<Vec3> {
    let (sa, ca) = trig::sin_cos(alpha);
    let (sb, cb) = trig::sin_cos(beta);
    let ahead = square(forward, n)?;
    let side = n.cross(&ahead);
    let side = if side.dot(&over) < 0.0 { -side } else { side };
    Some(n * (ca * cb) + ahead * sb + side * (sa * cb))
}

/// The part of `v` square to the unit vector `n`, as a unit vector.
fn square(v: Vec3, n: Vec3) -> Option<Vec3> {
    let v = v.try_normalize(0.0)?;
    (v - n * n.dot(&v)).try_normalize(1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(across: Vec3) -> DrivePoint {
        DrivePoint {
            uv: [0.0; 2],
            point: Vec3::zeros(),
            along: Vec3::y(),
            across,
            normal: Some(Vec3::z()),
            direction: Some(-Vec3::z()),
        }
    }

    #[test]
    fn published_slews() {
        let tilt = |deg: f64, across: Vec3| {
            let area = AxisArea::Angle { part: false, alpha: deg.to_radians(), beta: 0.0 };
            at_drive(&area, &place(across), Vec3::y()).unwrap()
        };
        let (s, c) = (0.5, 0.75_f64.sqrt());
        assert!((tilt(30.0, Vec3::x()) - Vec3::new(s, 0.0, c)).norm() < 1e-15);
        assert!((tilt(-30.0, Vec3::x()) - Vec3::new(-s, 0.0, c)).norm() < 1e-15);
        assert!((tilt(30.0, Vec3::new(1.0, 0.0, 1.0)) - Vec3::new(s, 0.0, c)).norm() < 1e-15);
        let area = AxisArea::Angle { part: false, alpha: 0.3, beta: 0.0 };
        assert!(at_drive(&area, &place(Vec3::zeros()), Vec3::y()).is_none());
    }

    #[test]
    fn an_axis_at_the_part_is_unit_and_leads() {
        let n = Vec3::new(0.1, -0.2, 1.0).normalize();
        let a = at_part(0.2, 0.1, n, Vec3::x(), Vec3::y()).unwrap();
        assert!((a.norm() - 1.0).abs() < 1e-15);
        assert!((a.dot(&n) - trig::cos(0.2) * trig::cos(0.1)).abs() < 1e-15);
        assert!(a.x > n.x && a.y > n.y);
    }
}
