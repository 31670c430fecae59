//! Curvature of a surface at a point.

use crate::Vec3;

/// Two unit vectors that make a right-handed frame with a given third.
pub type Frame = [Vec3; 2];

/// Second fundamental form: the curvatures in two perpendicular directions of the tangent plane and the
/// mixed term. Positive where the surface bends away from its positive side, as a dome does seen from
/// outside (a sphere of radius R has 1/R): these are the second derivatives of the signed distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// The two directions.
    pub frame: Frame,
    /// k11, k12, k22. An edge or a vertex has an infinite k11 or k22, and then k12 = 0.
    pub k: [f64; 3],
}

impl Shape {
    /// No curvature at a place with normal `n`.
    #[inline]
    pub fn flat(n: Vec3) -> Self {
        Self { frame: frame_about(n), k: [0.0; 3] }
    }

    /// The same curvature in all directions.
    #[inline]
    pub fn round(n: Vec3, k: f64) -> Self {
        Self { frame: frame_about(n), k: [k, 0.0, k] }
    }

    /// Seen from the other side.
    #[must_use]
    #[inline]
    pub fn reversed(&self) -> Self {
        Self { frame: self.frame, k: self.k.map(|k| -k) }
    }

    /// `II(v, v)`: the second derivative of the signed distance along `v`.
    #[inline]
    pub fn second(&self, v: Vec3) -> f64 {
        let (a, b) = (self.frame[0].dot(&v), self.frame[1].dot(&v));
        let term = |k: f64, s: f64| if s == 0.0 { 0.0 } else { k * s };
        term(self.k[0], a * a) + term(2.0 * self.k[1], a * b) + term(self.k[2], b * b)
    }

    /// `II v`: how the unit normal turns when the point moves along `v`.
    #[inline]
    pub fn apply(&self, v: Vec3) -> Vec3 {
        let (a, b) = (self.frame[0].dot(&v), self.frame[1].dot(&v));
        self.frame[0] * (self.k[0] * a + self.k[1] * b)
            + self.frame[1] * (self.k[1] * a + self.k[2] * b)
    }

    /// The curvatures and the mixed term along other unit vectors square to each other in the same tangent plane; of an edge or a
    /// vertex they are no numbers.
    #[inline]
    pub fn terms(&self, [a, b]: Frame) -> [f64; 3] {
        let [u, v] = &self.frame;
        let (p, q) = ([u.dot(&a), v.dot(&a)], [u.dot(&b), v.dot(&b)]);
        let [k11, k12, k22] = self.k;
        let turned = [k11 * p[0] + k12 * p[1], k12 * p[0] + k22 * p[1]];
        [
            turned[0] * p[0] + turned[1] * p[1],
            turned[0] * q[0] + turned[1] * q[1],
            k11 * q[0] * q[0] + 2.0 * k12 * q[0] * q[1] + k22 * q[1] * q[1],
        ]
    }

    /// The form in another frame of the same tangent plane.
    #[must_use]
    #[inline]
    pub fn in_frame(&self, frame: Frame) -> Self {
        let (c, s) = (self.frame[0].dot(&frame[0]), self.frame[1].dot(&frame[0]));
        let sign = if self.frame[0].cross(&self.frame[1]).dot(&frame[0].cross(&frame[1])) < 0.0 {
            -1.0
        } else {
            1.0
        };
        let [a, b, d] = self.k;
        if a.is_infinite() || d.is_infinite() {
            return *self;
        }
        let k11 = c * c * a + 2.0 * c * s * b + s * s * d;
        let k22 = s * s * a - 2.0 * c * s * b + c * c * d;
        let k12 = sign * ((d - a) * c * s + (c * c - s * s) * b);
        Self { frame, k: [k11, k12, k22] }
    }

    /// Curvature of the parallel surface at signed distance `s`: each principal radius grows by `s`.
    /// `None` at a centre of curvature.
    #[must_use]
    #[inline]
    pub fn offset(&self, s: f64) -> Option<Self> {
        let [a, b, d] = self.k;
        if a.is_infinite() || d.is_infinite() {
            let grow = |k: f64| if k.is_infinite() { 1.0 / s } else { k / (1.0 + k * s) };
            return (s != 0.0).then(|| Self { frame: self.frame, k: [grow(a), 0.0, grow(d)] });
        }
        // K (I + s K)^-1
        let (p, q, r) = (1.0 + s * a, s * b, 1.0 + s * d);
        let det = p * r - q * q;
        if det.abs() < 1e-14 {
            return None;
        }
        let k = a * d - b * b;
        Some(Self { frame: self.frame, k: [(a + s * k) / det, b / det, (d + s * k) / det] })
    }

    /// The two principal curvatures, the greater first.
    ///
    /// APT: `CURCAL`.
    pub fn principal(&self) -> [f64; 2] {
        let [a, b, d] = self.k;
        let (mean, half) = (0.5 * (a + d), 0.5 * (a - d));
        let root = (half * half + b * b).sqrt();
        [mean + root, mean - root]
    }
}

/// Two unit vectors perpendicular to the unit vector `n` and to each other, `a x b = n`; continuous but at
/// one direction.
#[inline]
pub fn frame_about(n: Vec3) -> Frame {
    // Duff et al., "Building an orthonormal basis, revisited", JCGT 6 (2017).
    let sign = 1.0_f64.copysign(n.z);
    let a = -1.0 / (sign + n.z);
    let b = n.x * n.y * a;
    [
        Vec3::new(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x),
        Vec3::new(b, sign + n.y * n.y * a, -n.y),
    ]
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "some closed forms are met to the last bit")]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn offsets_and_principal_values() {
        let s = Shape { frame: [Vec3::x(), Vec3::y()], k: [0.2, 0.0, -0.1] };
        let o = s.offset(5.0).unwrap();
        assert!((o.k[0] - 0.1).abs() < 1e-15 && (o.k[2] + 0.2).abs() < 1e-15);
        assert!(s.offset(-5.0).is_none());
        let k = s.principal();
        assert!((k[0] - 0.2).abs() < 1e-15 && (k[1] + 0.1).abs() < 1e-15);
        let edge = Shape { frame: s.frame, k: [f64::INFINITY, 0.0, 0.0] };
        assert_eq!(edge.offset(4.0).unwrap().k, [0.25, 0.0, 0.0]);
        assert_eq!(edge.second(Vec3::y()), 0.0);
    }

    proptest! {
        #[test]
        fn frames(x in -1.0_f64..1.0, y in -1.0_f64..1.0, z in -1.0_f64..1.0, turn in 0.0_f64..6.0) {
            let n = Vec3::new(x, y, z);
            prop_assume!(n.norm() > 0.1);
            let n = n.normalize();
            let f = frame_about(n);
            prop_assert!((f[0].cross(&f[1]) - n).norm() < 1e-14);
            prop_assert!(f[0].dot(&f[1]).abs() < 1e-14);
            let s = Shape { frame: f, k: [0.3, -0.2, 0.7] };
            let (sin, cos) = crate::trig::sin_cos(turn);
            let turned = [f[0] * cos + f[1] * sin, f[1] * cos - f[0] * sin];
            let t = s.in_frame(turned);
            let flipped = s.in_frame([turned[1], turned[0]]);
            prop_assert!(s.terms(turned).iter().zip(t.k).all(|(a, b)| (a - b).abs() < 1e-14));
            let v = f[0] * 0.4 + f[1] * 1.1;
            prop_assert!((s.second(v) - t.second(v)).abs() < 1e-13);
            prop_assert!((s.second(v) - flipped.second(v)).abs() < 1e-13);
            prop_assert!((s.apply(v).dot(&v) - s.second(v)).abs() < 1e-13);
        }
    }
}
