//! Angles of a tilted plane, as controls take them.

use aptc_geometry::trig;
use nalgebra::Matrix3;

/// Angles in degrees such that `Rz(a) Rx(b) Rz(c)` is the rotation; of both ways the one that turns less about Z.
///
/// Fanuc G68.2 takes them as I J K.
pub(crate) fn euler_zxz(q: &Matrix3<f64>) -> [f64; 3] {
    let [a, b, c] = upward(q);
    let other = |angle: f64| if angle > 0.0 { angle - 180.0 } else { angle + 180.0 };
    if other(a).abs() + other(c).abs() < a.abs() + c.abs() - 1e-9 && b > 1e-9 {
        return [other(a), -b, other(c)];
    }
    [a, b, c]
}

/// The way with b within 0 to 180.
fn upward(q: &Matrix3<f64>) -> [f64; 3] {
    let b = trig::atan2(trig::hypot(q[(0, 2)], q[(1, 2)]), q[(2, 2)]);
    let (a, c) = if trig::hypot(q[(0, 2)], q[(1, 2)]) < FLAT {
        // About Z alone: the first angle does it.
        (trig::atan2(q[(1, 0)], q[(0, 0)]), 0.0)
    } else {
        (trig::atan2(q[(0, 2)], -q[(1, 2)]), trig::atan2(q[(2, 0)], q[(2, 1)]))
    };
    [a, b, c].map(f64::to_degrees)
}

/// Angles in degrees such that `Rx(a) Ry(b) Rz(c)` is the rotation; b within -90 to 90.
///
/// Heidenhain PLANE SPATIAL takes them as SPA SPB SPC, Siemens CYCLE800 in its mode 57.
pub(crate) fn euler_xyz(q: &Matrix3<f64>) -> [f64; 3] {
    let b = trig::atan2(q[(0, 2)], trig::hypot(q[(0, 0)], q[(0, 1)]));
    let (a, c) = if trig::hypot(q[(0, 0)], q[(0, 1)]) < FLAT {
        (trig::atan2(q[(2, 1)], q[(1, 1)]), 0.0)
    } else {
        (trig::atan2(-q[(1, 2)], q[(2, 2)]), trig::atan2(-q[(0, 1)], q[(0, 0)]))
    };
    [a, b, c].map(f64::to_degrees)
}

/// Sines below this are none.
const FLAT: f64 = 1e-9;

/// The rotation by `degrees` about X, Y or Z: axis 0, 1 or 2.
pub(crate) fn about(axis: usize, degrees: f64) -> Matrix3<f64> {
    let (s, c) = (trig::sin_deg(degrees), trig::cos_deg(degrees));
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut m = Matrix3::identity();
    (m[(i, i)], m[(j, j)], m[(j, i)], m[(i, j)]) = (c, c, s, -s);
    m
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_angles_make_the_rotation_again(
            x in -4.0..4.0_f64, y in -4.0..4.0_f64, z in -4.0..4.0_f64, quarters: bool,
        ) {
            let whole = |a: f64| if quarters { (a * 2.0).round() * 90.0 } else { a * 90.0 };
            let q = about(0, whole(x)) * about(1, whole(y)) * about(2, whole(z));
            let [a, b, c] = euler_zxz(&q);
            prop_assert!((about(2, a) * about(0, b) * about(2, c) - q).norm() < 1e-9);
            let [a, b, c] = euler_xyz(&q);
            prop_assert!((about(0, a) * about(1, b) * about(2, c) - q).norm() < 1e-9);
        }
    }
}
