//! Arcs of which only the end is known, as chords.

use aptc_geometry::{Vec3, trig};

use crate::{Arc, Course, Motion, Position};

/// Most chords of one arc; what it trades is memory against tolerances that no machine holds.
const MOST: f64 = 60_000.0;

/// The positions of the motion from `start`; where the arc of an end is all that is given, vertices on
/// the circle whose chords lie within `tolerance` of it, the end last. A helix rises evenly, the axis
/// turns from that of `start` to that of the end.
pub fn positions(motion: &Motion, start: Option<Position>, tolerance: f64) -> Vec<Position> {
    let (Some(Arc { circle, course: Course::Sweep(sweep) }), Some(start), [end]) =
        (&motion.arc, start, motion.points.as_slice())
    else {
        return motion.points.clone();
    };
    let axis = circle.axis;
    let arm = start.te - circle.center;
    let height = axis.dot(&arm);
    let flat = arm - axis * height;
    let radius = flat.norm();
    let Some(e1) = flat.try_normalize(0.0) else { return motion.points.clone() };
    let e2 = axis.cross(&e1);
    let end_arm = end.te - circle.center;
    let end_radius = (end_arm - axis * axis.dot(&end_arm)).norm();
    let rise = axis.dot(&end_arm) - height;
    let half = trig::acos_clamped(1.0 - (tolerance / radius.max(end_radius)).clamp(1e-12, 1.0));
    let n = (sweep.abs().to_radians() / (2.0 * half)).ceil().clamp(1.0, MOST);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
    let n = n as usize;
    let mut out = Vec::with_capacity(n);
    for i in 1..n {
        let t = i as f64 / n as f64;
        let (sin, cos) = trig::sin_cos((sweep * t).to_radians());
        let r = radius + (end_radius - radius) * t;
        let te = circle.center + axis * (height + rise * t) + (e1 * cos + e2 * sin) * r;
        let ta: Vec3 = start.ta + (end.ta - start.ta) * t;
        out.push(Position { te, ta: ta.try_normalize(0.0).unwrap_or(end.ta) });
    }
    out.push(*end);
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::Circle;

    #[test]
    fn a_helix_of_two_turns() {
        let circle = Circle { center: Vec3::new(1.0, 1.0, 0.0), axis: Vec3::z(), radius: 2.0 };
        let at = |x, y, z| Position::upright(Vec3::new(x, y, z));
        let motion = Motion {
            arc: Some(Arc { circle, course: Course::Sweep(810.0) }),
            points: vec![at(1.0, 3.0, 9.0)],
            ..Motion::default()
        };
        let chords = positions(&motion, Some(at(3.0, 1.0, 0.0)), 0.001);
        let n = chords.len();
        assert!(n > 100 && n < 300, "{n}");
        for (i, p) in chords.iter().enumerate() {
            let flat = Vec3::new(p.te.x - 1.0, p.te.y - 1.0, 0.0);
            assert!((flat.norm() - 2.0).abs() < 1e-12);
            assert!((p.te.z - 9.0 * (i + 1) as f64 / n as f64).abs() < 1e-12);
        }
        assert_eq!(chords[n - 1], at(1.0, 3.0, 9.0));
        assert_eq!(positions(&motion, None, 0.001).len(), 1);
    }
}
