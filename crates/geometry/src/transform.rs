//! MATRIX: an affine map of space.

use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use crate::{Vec3, trig};

/// `p -> linear p + shift`: the twelve numbers of a MATRIX, three rows of four.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Transform {
    /// The three columns left of the last.
    pub linear: Matrix3<f64>,
    /// The last column.
    pub shift: Vec3,
}

impl Transform {
    /// The map that leaves everything where it is.
    pub fn identity() -> Self {
        Self { linear: Matrix3::identity(), shift: Vector3::zeros() }
    }

    /// From three rows of four.
    pub fn from_rows(e: &[f64; 12]) -> Self {
        let linear = Matrix3::new(e[0], e[1], e[2], e[4], e[5], e[6], e[8], e[9], e[10]);
        Self { linear, shift: Vector3::new(e[3], e[7], e[11]) }
    }

    /// Three rows of four.
    pub fn rows(&self) -> [f64; 12] {
        let (m, s) = (&self.linear, &self.shift);
        let row = |i: usize| [m[(i, 0)], m[(i, 1)], m[(i, 2)], s[i]];
        let (a, b, c) = (row(0), row(1), row(2));
        [a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3], c[0], c[1], c[2], c[3]]
    }

    /// Moves by `v`.
    pub fn translation(v: Vec3) -> Self {
        Self { linear: Matrix3::identity(), shift: v }
    }

    /// Scales all lengths.
    pub fn scale(s: f64) -> Self {
        Self { linear: Matrix3::identity() * s, shift: Vector3::zeros() }
    }

    /// Turns by `angle_deg` about the axis through the origin along the unit vector `axis`, anticlockwise
    /// seen from its tip. Exact for multiples of 90 degrees about the axes of the frame.
    pub fn rotation(axis: Vec3, angle_deg: f64) -> Self {
        let (s, c) = (trig::sin_deg(angle_deg), trig::cos_deg(angle_deg));
        let k = Matrix3::new(0.0, -axis.z, axis.y, axis.z, 0.0, -axis.x, -axis.y, axis.x, 0.0);
        let linear = Matrix3::identity() * c + k * s + axis * axis.transpose() * (1.0 - c);
        Self { linear, shift: Vector3::zeros() }
    }

    /// The map "first `self`, then `next`".
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        Self { linear: next.linear * self.linear, shift: next.linear * self.shift + next.shift }
    }

    /// A point moved.
    pub fn point(&self, p: Vec3) -> Vec3 {
        self.vector(p) + self.shift
    }

    /// A vector turned and scaled, not moved.
    ///
    /// The library's product is a call for each column, and the sums are in its order here.
    #[inline]
    pub fn vector(&self, v: Vec3) -> Vec3 {
        let m = &self.linear;
        let row = |i: usize| m[(i, 0)] * v.x + m[(i, 1)] * v.y + m[(i, 2)] * v.z;
        Vec3::new(row(0), row(1), row(2))
    }

    /// A normal of a surface carried with the surface (inverse transposed, not normalised); `None` for a
    /// singular map.
    pub fn normal(&self, n: Vec3) -> Option<Vec3> {
        self.linear.try_inverse().map(|m| m.transpose() * n)
    }

    /// The map back; `None` when the map flattens space.
    pub fn inverse(&self) -> Option<Self> {
        let linear = self.linear.try_inverse()?;
        Some(Self { linear, shift: -(linear * self.shift) })
    }

    /// The common factor by which the map scales all lengths; `None` when it scales directions
    /// differently (relative difference above 1e-9).
    pub fn uniform_scale(&self) -> Option<f64> {
        let g = self.linear.transpose() * self.linear;
        let s2 = g.trace() / 3.0;
        let off = (g - Matrix3::identity() * s2).abs().max();
        (s2 > 0.0 && off <= 1e-9 * s2).then(|| s2.sqrt())
    }

    /// Does it turn left into right?
    pub fn mirrors(&self) -> bool {
        self.linear.determinant() < 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn then_applies_left_first() {
        let t = Transform::translation(Vec3::new(1.0, 0.0, 0.0));
        let r = Transform::rotation(Vec3::z(), 90.0);
        assert_eq!(t.then(&r).point(Vec3::zeros()), Vec3::new(0.0, 1.0, 0.0));
        assert_eq!(r.then(&t).point(Vec3::x()), Vec3::new(1.0, 1.0, 0.0));
    }

    #[test]
    fn inverse_and_rows_round_trip() {
        let m =
            Transform::from_rows(&[2.0, 1.0, 0.0, 5.0, 0.0, 3.0, 1.0, -1.0, 1.0, 0.0, 1.0, 2.0]);
        assert_eq!(Transform::from_rows(&m.rows()), m);
        let p = Vec3::new(0.3, -4.0, 7.0);
        assert!((m.inverse().unwrap().point(m.point(p)) - p).norm() < 1e-12);
        assert!(m.uniform_scale().is_none());
        assert_eq!(Transform::scale(2.0).uniform_scale(), Some(2.0));
    }
}
