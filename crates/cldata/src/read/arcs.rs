//! Circles of the ways in which CL text says "arc".

use aptc_geometry::{Circle, Plane, Vec3, trig};

/// A chord shorter than this part of the radius is no chord: the arc is a full circle. CL text gives four
/// decimals or more, and equal ends are printed equal.
const CLOSED: f64 = 1e-5;

/// An arc of which the next position is the end, or the points of which follow.
#[derive(Clone, Debug)]
pub(super) enum Pending {
    /// Points on this circle follow; their order gives the sense.
    Points {
        /// The circle, its axis right-handed about the motion when only the end is given.
        circle: Circle,
        /// Until the next mark, not only as long as they lie on the circle.
        to_mark: bool,
    },
    /// The next position is the end.
    End {
        /// Centre of the circle.
        center: Vec3,
        /// Axis, right-handed about the motion, of any length.
        axis: Vec3,
        /// Radius, if it is not to be taken from the start.
        radius: Option<f64>,
        /// Full turns besides the arc itself.
        turns: u32,
        /// Angle in degrees when it is stated.
        sweep: Option<f64>,
    },
}

/// The part of `v` across the unit vector `axis`.
fn across(v: Vec3, axis: Vec3) -> Vec3 {
    v - axis * axis.dot(&v)
}

/// Distance of `p` from the axis of the circle less its radius.
pub(super) fn off_circle(circle: &Circle, p: Vec3) -> f64 {
    across(p - circle.center, circle.axis).norm() - circle.radius
}

/// Angle in degrees from `start` to `end`, right-handed about the unit vector `axis`, more than 0 and at
/// most 360; 360 when they coincide.
pub(crate) fn sweep(center: Vec3, axis: Vec3, start: Vec3, end: Vec3) -> f64 {
    let (u, v) = (across(start - center, axis), across(end - center, axis));
    if (u - v).norm() <= CLOSED * u.norm().max(v.norm()) {
        return 360.0;
    }
    let angle = trig::atan2(axis.dot(&u.cross(&v)), u.dot(&v)).to_degrees();
    if angle <= 0.0 { angle + 360.0 } else { angle }
}

/// How far two angles in degrees are apart, whole turns aside.
pub(super) fn apart(a: f64, b: f64) -> f64 {
    let d = (a - b).rem_euclid(360.0);
    d.min(360.0 - d)
}

/// Greatest distance of an arc between two successive points from its chord.
pub(super) fn rise(circle: &Circle, start: Vec3, points: impl Iterator<Item = Vec3>) -> f64 {
    let mut last = start;
    points.fold(0.0, |most: f64, p| {
        let angle = sweep(circle.center, circle.axis, last, p);
        last = p;
        let half = angle.min(360.0 - angle).to_radians() / 2.0;
        most.max(circle.radius * (1.0 - trig::cos(half)))
    })
}

/// The axis about which the points follow one another right-handed within one turn, that of the circle or
/// the opposite one; `None` when their order does not say.
pub(super) fn sense(
    circle: &Circle,
    start: Vec3,
    points: impl Iterator<Item = Vec3>,
) -> Option<Vec3> {
    let mut last = start;
    let (mut left, mut right) = (0.0, 0.0);
    for p in points {
        left += sweep(circle.center, circle.axis, last, p);
        right += sweep(circle.center, -circle.axis, last, p);
        last = p;
    }
    if left <= 360.5 { Some(circle.axis) } else { (right <= 360.5).then_some(-circle.axis) }
}

/// The plane through the circle's axis, or touching the circle, in which a motion ends.
pub(super) struct EndPlane {
    /// The plane.
    pub(super) plane: Plane,
    /// Which crossing counts, from 1.
    pub(super) nth: u32,
    /// Does the plane touch the circle there?
    pub(super) tangent: bool,
}

/// End and angle in degrees of the motion from `start` along the circle, right-handed about its axis, to
/// the plane; `None` when they do not meet.
pub(super) fn end_on_plane(circle: &Circle, start: Vec3, end: &EndPlane) -> Option<(Vec3, f64)> {
    let full = 2.0 * std::f64::consts::PI;
    let e1 = across(start - circle.center, circle.axis).try_normalize(0.0)?;
    let e2 = circle.axis.cross(&e1);
    let (a, b) = (circle.radius * end.plane.n.dot(&e1), circle.radius * end.plane.n.dot(&e2));
    let reach = trig::hypot(a, b);
    let c = -end.plane.distance(circle.center);
    // Planes and radii are rounded to a few decimals.
    if !(reach > 0.0 && c.abs() <= reach * (1.0 + 1e-3)) {
        return None;
    }
    let middle = trig::atan2(b, a);
    let half = trig::acos_clamped(c / reach);
    // A crossing at the start itself is the last of a turn, not the first.
    let folded = |t: f64| {
        let t = t.rem_euclid(full);
        if t < 5e-5 { t + full } else { t }
    };
    let angle = if end.tangent {
        folded(if c < 0.0 { middle + std::f64::consts::PI } else { middle })
    } else {
        let (p, q) = (folded(middle - half), folded(middle + half));
        let (first, second) = if p < q { (p, q) } else { (q, p) };
        let turns = f64::from((end.nth.max(1) - 1) / 2) * full;
        turns + if end.nth.max(1) % 2 == 1 { first } else { second }
    };
    let height = circle.axis * circle.axis.dot(&(start - circle.center));
    let (sin, cos) = trig::sin_cos(angle);
    let at = circle.center + height + (e1 * cos + e2 * sin) * circle.radius;
    Some((at, angle.to_degrees()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sweeps_go_round_their_axis() {
        let (c, z) = (Vec3::new(5.0, 5.0, 0.0), Vec3::z());
        let at = |x, y, h| Vec3::new(x, y, h);
        let (east, north) = (at(6.0, 5.0, 0.0), at(5.0, 6.0, -3.0));
        assert!((sweep(c, z, east, north) - 90.0).abs() < 1e-12);
        assert!((sweep(c, -z, east, north) - 270.0).abs() < 1e-12);
        assert!((sweep(c, z, east, at(6.0, 5.0, 9.0)) - 360.0).abs() < 1e-12);
    }

    #[test]
    fn crossings_are_counted_along_the_way() {
        let circle = Circle { center: Vec3::zeros(), axis: Vec3::z(), radius: 2.0 };
        let start = Vec3::new(2.0, 0.0, 1.0);
        let plane = Plane::new(Vec3::x(), 0.0).unwrap();
        let at = |nth, tangent| end_on_plane(&circle, start, &EndPlane { plane, nth, tangent });
        for (nth, y, angle) in [(1, 2.0, 90.0), (2, -2.0, 270.0), (3, 2.0, 450.0)] {
            let (p, a) = at(nth, false).unwrap();
            assert!((p - Vec3::new(0.0, y, 1.0)).norm() < 1e-12 && (a - angle).abs() < 1e-9);
        }
        let side = Plane::new(Vec3::y(), 0.0).unwrap();
        let end = |nth| {
            end_on_plane(&circle, start, &EndPlane { plane: side, nth, tangent: false }).unwrap().1
        };
        assert!((end(1) - 180.0).abs() < 1e-9 && (end(2) - 360.0).abs() < 1e-9);
        let touch = Plane::new(-Vec3::y(), 2.0).unwrap();
        let (p, a) =
            end_on_plane(&circle, start, &EndPlane { plane: touch, nth: 1, tangent: true })
                .unwrap();
        assert!((p - Vec3::new(0.0, -2.0, 1.0)).norm() < 1e-9 && (a - 270.0).abs() < 1e-9);
        let far = Plane::new(Vec3::x(), 5.0).unwrap();
        assert!(
            end_on_plane(&circle, start, &EndPlane { plane: far, nth: 1, tangent: false })
                .is_none()
        );
    }
}
