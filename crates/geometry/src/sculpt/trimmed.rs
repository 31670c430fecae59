//! SCURV/SEG: bounded parts of circles.

use super::arc::{CubicArc, weighted};
use crate::{Circle, Vec3, trig};

/// The shorter arc of a circle between two of its points, in spans of at most 90 degrees only where half a
/// turn is reached: one arc below that, two from it on. `None` when the points coincide.
pub fn circle_between(circle: &Circle, a: Vec3, b: Vec3) -> Option<Vec<CubicArc>> {
    let axis = circle.axis;
    let across = |p: Vec3| {
        let w = p - circle.center;
        (w - axis * axis.dot(&w)).try_normalize(0.0)
    };
    let (x, to) = (across(a)?, across(b)?);
    let turn = trig::atan2(axis.dot(&x.cross(&to)), x.dot(&to));
    if turn.abs() <= 1e-12 {
        return None;
    }
    let y = axis.cross(&x);
    let spans = if turn.abs() > 179.99_f64.to_radians() { 2 } else { 1 };
    let step = turn / f64::from(spans);
    let rise = axis.dot(&(b - a)) / f64::from(spans);
    let base = circle.center + axis * axis.dot(&(a - circle.center));
    let place = |angle: f64, r: f64, up: f64| {
        let (s, c) = trig::sin_cos(angle);
        base + axis * up + (x * c + y * s) * r
    };
    let half = trig::cos(0.5 * step);
    let arc = |k: i32| {
        let (from, up) = (step * f64::from(k), rise * f64::from(k));
        CubicArc::quadratic([
            weighted(place(from, circle.radius, up), 1.0),
            weighted(place(from + 0.5 * step, circle.radius / half, up + 0.5 * rise), half),
            weighted(place(from + step, circle.radius, up + rise), 1.0),
        ])
    };
    Some((0..spans).map(arc).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Curve S1 of TEST40.
    #[test]
    fn printed_arc() {
        let c = Circle { center: Vec3::new(0.75, 0.75, 0.0), axis: Vec3::z(), radius: 0.75 };
        let arcs =
            circle_between(&c, Vec3::new(0.75, 0.0, 0.0), Vec3::new(0.0, 0.75, 0.0)).unwrap();
        assert_eq!(arcs.len(), 1);
        let p = arcs[0].at(0.25);
        assert!((p.point - Vec3::new(0.4739, 0.0527, 0.0)).norm() < 1e-4);
        assert!((p.curvature() - 1.0 / 0.75).abs() < 1e-12);
        assert!(circle_between(&c, Vec3::x(), Vec3::x()).is_none());
    }
}
