//! Angles by which one or two turns bring a direction to another.

use std::f64::consts::{PI, TAU};

use aptc_geometry::{Vec3, trig};

use super::{NoSolution, UPRIGHT};

/// Angle of `R(d, x) u = v`; `from` when `u` lies along `d`.
pub(super) fn one_turn(
    d: Vec3,
    u: Vec3,
    v: Vec3,
    from: f64,
    singular: f64,
) -> Result<f64, NoSolution> {
    if (trig::angle_between(d, u) - trig::angle_between(d, v)).abs() > UPRIGHT {
        return Err(NoSolution::Direction);
    }
    Ok(angle_about(d, u, v, singular).unwrap_or(from))
}

/// Angle about `d` from `u` to `v`, seen across `d`; `None` when one of them lies within `singular` of `d`.
pub(super) fn angle_about(d: Vec3, u: Vec3, v: Vec3, singular: f64) -> Option<f64> {
    let (pu, pv) = (u - d * d.dot(&u), v - d * d.dot(&v));
    let least = singular.max(1e-12);
    if pu.norm() < least || pv.norm() < least {
        return None;
    }
    Some(trig::atan2(d.dot(&pu.cross(&pv)), pu.dot(&pv)))
}

/// Angles of `R(d1, x) R(d2, y) u = v`.
pub(super) fn two_turns(
    d1: Vec3,
    d2: Vec3,
    u: Vec3,
    v: Vec3,
    from: [f64; 2],
    singular: f64,
) -> Result<[Option<[f64; 2]>; 2], NoSolution> {
    // The vector w = R(d2, y) u = R(d1, -x) v lies in the plane of d1 and d2 and on both sides of it.
    // They meet where three angles make a spherical triangle; by how much they miss is the lean that would be left.
    let (alpha, beta, gamma) =
        (trig::angle_between(d1, v), trig::angle_between(d2, u), trig::angle_between(d1, d2));
    let short = (gamma - alpha - beta).max((alpha - beta).abs() - gamma);
    if short.max(alpha + beta + gamma - TAU) > UPRIGHT {
        return Err(NoSolution::Direction);
    }
    let cos = d1.dot(&d2);
    let (p, q) = (v.dot(&d1), u.dot(&d2));
    let det = 1.0 - cos * cos;
    if det < 1e-12 {
        return Err(NoSolution::Direction);
    }
    let (a, b) = ((p - cos * q) / det, (q - cos * p) / det);
    // At the border both solutions are one.
    let rest = 1.0 - (a * a + b * b + 2.0 * a * b * cos);
    let normal = d1.cross(&d2);
    let c = (rest.max(0.0) / det).sqrt();
    let base = d1 * a + d2 * b;
    let solve = |w: Vec3| {
        let y = angle_about(d2, u, w, 0.0).unwrap_or(from[1]);
        // Near the singular direction the first axis may stay where it is.
        let x = angle_about(d1, w, v, singular).unwrap_or(from[0]);
        [x, y]
    };
    let one = solve(base + normal * c);
    if c < 1e-9 {
        return Ok([Some(one), None]);
    }
    Ok([Some(one), Some(solve(base - normal * c))])
}

/// The angle within -pi..pi.
pub(super) fn wrapped(angle: f64) -> f64 {
    let a = angle - TAU * (angle / TAU).round();
    if a <= -PI { a + TAU } else { a }
}

/// Degrees without the noise of the last bits around whole quarters, so that 90 is written as 90.
pub(super) fn clean_degrees(radians: f64) -> f64 {
    let degrees = radians.to_degrees();
    let near = (degrees / 90.0).round() * 90.0;
    if (degrees - near).abs() < 1e-10 { near } else { degrees }
}

/// Sine and cosine of an angle, exact at multiples of 90 degrees.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spin {
    sin: f64,
    cos: f64,
}

impl Spin {
    pub(super) const NONE: Self = Self { sin: 0.0, cos: 1.0 };

    pub(super) fn new(degrees: f64) -> Self {
        Self { sin: trig::sin_deg(degrees), cos: trig::cos_deg(degrees) }
    }

    pub(super) fn back(self) -> Self {
        Self { sin: -self.sin, ..self }
    }

    /// The vector turned about the unit vector `d`.
    pub(super) fn turn(self, d: Vec3, v: Vec3) -> Vec3 {
        v * self.cos + d.cross(&v) * self.sin + d * (d.dot(&v) * (1.0 - self.cos))
    }
}
