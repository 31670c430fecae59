//! The only way to transcendental functions: libm, so that output is the same bits on every platform.

use crate::Vec3;

/// Sine of `x` radians.
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}

/// Cosine of `x` radians.
pub fn cos(x: f64) -> f64 {
    libm::cos(x)
}

/// Sine and cosine of `x` radians.
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// Tangent of `x` radians.
pub fn tan(x: f64) -> f64 {
    libm::tan(x)
}

/// Arc sine in radians.
pub fn asin(x: f64) -> f64 {
    libm::asin(x)
}

/// Arc cosine in radians.
pub fn acos(x: f64) -> f64 {
    libm::acos(x)
}

/// Arc cosine in radians of `x` clamped to [-1, 1], for cosines that rounding carried outside.
pub fn acos_clamped(x: f64) -> f64 {
    libm::acos(x.clamp(-1.0, 1.0))
}

/// Arc tangent in radians.
pub fn atan(x: f64) -> f64 {
    libm::atan(x)
}

/// Angle of the point (x, y) in radians, in (-pi, pi].
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// Angle between two directions in radians, 0 to pi; they need no unit length. Exact where cosines are not: next to 0
/// and half a turn.
pub fn angle_between(a: Vec3, b: Vec3) -> f64 {
    libm::atan2(a.cross(&b).norm(), a.dot(&b))
}

/// `e` to the power `x`.
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// Natural logarithm.
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// Logarithm to base 10.
pub fn log10(x: f64) -> f64 {
    libm::log10(x)
}

/// `x` to the power `y`.
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// Cube root.
pub fn cbrt(x: f64) -> f64 {
    libm::cbrt(x)
}

/// Length of the hypotenuse without overflow.
pub fn hypot(x: f64, y: f64) -> f64 {
    libm::hypot(x, y)
}

/// Hyperbolic sine.
pub fn sinh(x: f64) -> f64 {
    libm::sinh(x)
}

/// Hyperbolic cosine.
pub fn cosh(x: f64) -> f64 {
    libm::cosh(x)
}

/// Hyperbolic tangent.
pub fn tanh(x: f64) -> f64 {
    libm::tanh(x)
}

/// Sine of `x` degrees, exact at multiples of 30 where the value is rational.
pub fn sin_deg(x: f64) -> f64 {
    let r = within_a_turn(x);
    let r = if r < 0.0 { r + 360.0 } else { r };
    // Fold to [0, 90], where the rational values are tested for.
    let (r, sign) = if r >= 180.0 { (r - 180.0, -1.0) } else { (r, 1.0) };
    let r = if r > 90.0 { 180.0 - r } else { r };
    sign * match r {
        0.0 => 0.0,
        30.0 => 0.5,
        90.0 => 1.0,
        _ => sin(r.to_radians()),
    }
}

/// Cosine of `x` degrees, exact at multiples of 30 where the value is rational.
pub fn cos_deg(x: f64) -> f64 {
    sin_deg(within_a_turn(x) + 90.0)
}

/// The remainder of whole turns; most angles have none, and a division of its kind takes its time.
fn within_a_turn(x: f64) -> f64 {
    if x.abs() < 360.0 { x } else { x % 360.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_are_exact_where_the_value_is() {
        for (deg, s, c) in [
            (0.0, 0.0, 1.0),
            (30.0, 0.5, 0.75_f64.sqrt()),
            (90.0, 1.0, 0.0),
            (-150.0, -0.5, -(0.75_f64.sqrt())),
            (720.0, 0.0, 1.0),
            (270.0, -1.0, 0.0),
        ] {
            assert!((sin_deg(deg) - s).abs() < 2e-16, "{deg}");
            assert!((cos_deg(deg) - c).abs() < 2e-16, "{deg}");
        }
    }
}
