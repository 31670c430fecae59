//! One rational cubic arc.

use serde::{Deserialize, Serialize};

use crate::{Transform, Vec3};

/// Homogeneous coordinates: (w x, w y, w z, w).
pub type Vec4 = nalgebra::Vector4<f64>;

/// A rational cubic arc by its four homogeneous control points, parameter 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CubicArc {
    /// Control points.
    pub b: [Vec4; 4],
}

/// A place on a curve with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcPoint {
    /// The point.
    pub point: Vec3,
    /// First derivative.
    pub first: Vec3,
    /// Second derivative.
    pub second: Vec3,
}

impl ArcPoint {
    /// Curvature, never negative; 0 where the curve stands still.
    pub fn curvature(&self) -> f64 {
        let speed = self.first.norm();
        if speed > 0.0 {
            self.first.cross(&self.second).norm() / (speed * speed * speed)
        } else {
            0.0
        }
    }

    /// The same place when the parameter runs `rate` times as fast, `rate2` being the second derivative of
    /// the old parameter by the new one.
    #[must_use]
    pub fn rated(self, rate: f64, rate2: f64) -> Self {
        Self {
            point: self.point,
            first: self.first * rate,
            second: self.second * (rate * rate) + self.first * rate2,
        }
    }
}

/// A point of weight `w`.
pub fn weighted(p: Vec3, w: f64) -> Vec4 {
    Vec4::new(p.x * w, p.y * w, p.z * w, w)
}

/// The point that homogeneous coordinates stand for.
pub fn flat(h: Vec4) -> Vec3 {
    h.xyz() / h.w
}

/// Bernstein's polynomials of degree three at `t` with their first and second derivatives.
#[inline]
pub(crate) fn bernstein(t: f64) -> [[f64; 4]; 3] {
    let s = 1.0 - t;
    let (s2, t2, st) = (s * s, t * t, s * t);
    [
        [s2 * s, 3.0 * s2 * t, 3.0 * s * t2, t2 * t],
        [-3.0 * s2, 3.0 * (s2 - 2.0 * st), 3.0 * (2.0 * st - t2), 3.0 * t2],
        [6.0 * s, 6.0 * t - 12.0 * s, 6.0 * s - 12.0 * t, 6.0 * t],
    ]
}

impl CubicArc {
    /// Between two points with the tangents there, not rational.
    pub fn hermite(p0: Vec3, p1: Vec3, t0: Vec3, t1: Vec3) -> Self {
        let b = [p0, p0 + t0 / 3.0, p1 - t1 / 3.0, p1];
        Self { b: b.map(|p| weighted(p, 1.0)) }
    }

    /// From homogeneous end points and their derivatives.
    pub fn homogeneous(p0: Vec4, p1: Vec4, t0: Vec4, t1: Vec4) -> Self {
        Self { b: [p0, p0 + t0 / 3.0, p1 - t1 / 3.0, p1] }
    }

    /// A rational quadratic of the control points `c`, raised to degree three.
    pub fn quadratic(c: [Vec4; 3]) -> Self {
        Self { b: [c[0], (c[0] + c[1] * 2.0) / 3.0, (c[1] * 2.0 + c[2]) / 3.0, c[2]] }
    }

    /// The straight line from `a` to `b`.
    pub fn line(a: Vec3, b: Vec3) -> Self {
        Self::hermite(a, b, b - a, b - a)
    }

    /// Where the arc begins.
    pub fn start(&self) -> Vec3 {
        flat(self.b[0])
    }

    /// Where it ends.
    pub fn end(&self) -> Vec3 {
        flat(self.b[3])
    }

    /// Homogeneous value and derivatives at `t`.
    pub(crate) fn homogeneous_at(&self, t: f64) -> [Vec4; 3] {
        bernstein(t)
            .map(|c| self.b[0] * c[0] + self.b[1] * c[1] + self.b[2] * c[2] + self.b[3] * c[3])
    }

    /// Point and derivatives at `t`; outside 0 to 1 the same polynomials go on.
    pub fn at(&self, t: f64) -> ArcPoint {
        let [h, h1, h2] = self.homogeneous_at(t);
        let point = h.xyz() / h.w;
        let first = (h1.xyz() - point * h1.w) / h.w;
        let second = (h2.xyz() - first * (2.0 * h1.w) - point * h2.w) / h.w;
        ArcPoint { point, first, second }
    }

    /// The arc run through the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let [a, b, c, d] = self.b;
        Self { b: [d, c, b, a] }
    }

    /// The part from `t0` to `t1`.
    #[must_use]
    pub fn part(&self, t0: f64, t1: f64) -> Self {
        let blossom = |x: f64, y: f64, z: f64| {
            let lerp = |a: Vec4, b: Vec4, t: f64| a * (1.0 - t) + b * t;
            let [a, b, c, d] = self.b;
            let (p, q, r) = (lerp(a, b, x), lerp(b, c, x), lerp(c, d, x));
            let (p, q) = (lerp(p, q, y), lerp(q, r, y));
            lerp(p, q, z)
        };
        Self {
            b: [blossom(t0, t0, t0), blossom(t0, t0, t1), blossom(t0, t1, t1), blossom(t1, t1, t1)],
        }
    }

    /// The arc carried by `m`.
    #[must_use]
    pub fn transformed(&self, m: &Transform) -> Self {
        Self { b: self.b.map(|h| carry(h, m)) }
    }

    /// Are all weights equal?
    pub fn is_polynomial(&self) -> bool {
        self.b.iter().all(|h| (h.w - self.b[0].w).abs() <= 1e-15 * self.b[0].w.abs())
    }

    /// Length of the arc from 0 to `t`, to about 1e-12 of itself (Gauss-Legendre of eight points on pieces).
    pub fn length(&self, t: f64) -> f64 {
        const PIECES: u32 = 8;
        let h = t / f64::from(PIECES);
        (0..PIECES).map(|i| self.gauss(h * f64::from(i), h)).sum()
    }

    fn gauss(&self, from: f64, h: f64) -> f64 {
        const NODES: [(f64, f64); 4] = [
            (0.183_434_642_495_649_8, 0.362_683_783_378_362),
            (0.525_532_409_916_329, 0.313_706_645_877_887_3),
            (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
            (0.960_289_856_497_536_3, 0.101_228_536_290_376_3),
        ];
        let mid = from + 0.5 * h;
        let speed = |x: f64| self.at(mid + 0.5 * h * x).first.norm();
        NODES.iter().map(|&(x, w)| w * (speed(x) + speed(-x))).sum::<f64>() * 0.5 * h
    }
}

/// A homogeneous point carried by an affine map.
pub(crate) fn carry(h: Vec4, m: &Transform) -> Vec4 {
    let p = m.linear * h.xyz() + m.shift * h.w;
    Vec4::new(p.x, p.y, p.z, h.w)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quarter of the unit circle.
    pub(crate) fn quarter() -> CubicArc {
        let w = 0.5_f64.sqrt();
        CubicArc::quadratic([
            weighted(Vec3::x(), 1.0),
            weighted(Vec3::new(1.0, 1.0, 0.0), w),
            weighted(Vec3::y(), 1.0),
        ])
    }

    #[test]
    fn derivatives_by_differences_and_curvature_of_a_circle() {
        let arc = quarter();
        for i in 1..10 {
            let t = f64::from(i) * 0.1;
            let (p, h) = (arc.at(t), 1e-4);
            assert!((p.point.norm() - 1.0).abs() < 1e-15);
            assert!((p.curvature() - 1.0).abs() < 1e-12);
            let (f, b) = (arc.at(t + h), arc.at(t - h));
            assert!(((f.point - b.point) / (2.0 * h) - p.first).norm() < 1e-7);
            assert!(((f.first - b.first) / (2.0 * h) - p.second).norm() < 1e-6);
        }
        assert!((arc.length(1.0) - core::f64::consts::FRAC_PI_2).abs() < 1e-13);
    }

    #[test]
    fn parts_are_the_same_curve() {
        let arc = quarter();
        let part = arc.part(0.2, 0.7);
        assert!((part.at(0.4).point - arc.at(0.4).point).norm() < 1e-15);
        assert!((part.at(1.0).first - arc.at(0.7).first * 0.5).norm() < 1e-14);
        assert!((arc.reversed().at(0.25).point - arc.at(0.75).point).norm() < 1e-15);
    }
}
