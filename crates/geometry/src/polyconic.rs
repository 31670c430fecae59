//! POLCON: a family of conic sections in parallel planes, steered by polynomials.

use serde::{Deserialize, Serialize};

use crate::{Transform, Vec2, Vec3};

/// POLCON. At share `d` of the length along x, the plane `x = origin + d length`, the section in y and z is
/// a conic from (L, H) by (C, B) to the apex and from there by (A, D) to the end; P gives its fullness. All
/// of them are functions of `d` in 0 to 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Polyconic {
    /// First canonical element: 2 when the control curves have square roots, else 1.
    pub roots: f64,
    /// Elements 2 to 13 as written: the map from the part into the system of the curves; all zero means none.
    pub matrix: [f64; 12],
    /// Thickness between the defined surface and the working surface, to the side of the product of section and
    /// length.
    pub thickness: f64,
    /// Where the curves begin along the polyconic.
    pub origin: f64,
    /// Length of the valid region.
    pub length: f64,
    /// The control curves A B C D L H P.
    pub curves: [ControlCurve; 7],
}

/// `f(d) = root sqrt(d) + c0 + c1 d + ... + c7 d^7`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ControlCurve {
    /// Coefficient of the square root.
    pub root: f64,
    /// Coefficients of the powers 0 to 7.
    pub c: [f64; 8],
}

impl ControlCurve {
    /// Value at `d >= 0`; the root of a negative `d` counts as that of zero.
    pub fn at(&self, d: f64) -> f64 {
        let polynomial = self.c.iter().rev().fold(0.0, |sum, c| sum * d + c);
        polynomial + self.root * d.max(0.0).sqrt()
    }
}

impl Polyconic {
    /// Number of canonical elements.
    pub const N_ELEMENTS: usize = 79;

    /// From the canonical elements.
    pub fn from_canonical(e: &[f64; Self::N_ELEMENTS]) -> Self {
        let mut matrix = [0.0; 12];
        matrix.copy_from_slice(&e[1..13]);
        let mut curves = [ControlCurve::default(); 7];
        for (i, curve) in curves.iter_mut().enumerate() {
            curve.c.copy_from_slice(&e[16 + 8 * i..24 + 8 * i]);
            curve.root = e[72 + i];
        }
        let (thickness, origin, length) = (e[13], e[14], e[15]);
        Self { roots: e[0], matrix, thickness, origin, length, curves }
    }

    /// The canonical elements.
    pub fn canonical(&self) -> Vec<f64> {
        let mut e = vec![self.roots];
        e.extend(self.matrix);
        e.extend([self.thickness, self.origin, self.length]);
        e.extend(self.curves.iter().flat_map(|c| c.c));
        e.extend(self.curves.iter().map(|c| c.root));
        e
    }

    /// The map from the system of the curves into that of the part; `None` when there is none.
    ///
    /// APT: `APLCN`, which carries points by the matrix as it is written before it looks at the curves.
    pub fn transform(&self) -> Option<Transform> {
        Transform::from_rows(&self.matrix).inverse()
    }

    /// Is there a matrix that flattens space, or does not keep angles and ratios of lengths to a thousandth? Matrices are
    /// written with some digits only.
    pub fn is_skew(&self) -> bool {
        const MOST: f64 = 1e-3;
        let Some(m) = self.transform() else { return self.matrix.iter().any(|e| *e != 0.0) };
        let [x, y, z] = [Vec3::x(), Vec3::y(), Vec3::z()].map(|e| m.vector(e));
        let size = x.norm_squared();
        let skew =
            [x.dot(&y), y.dot(&z), z.dot(&x), y.norm_squared() - size, z.norm_squared() - size];
        skew.iter().any(|s| s.abs() > MOST * size)
    }

    /// How far the working surface lies from the one that is defined, in the part, along the product of the directions of
    /// length and section.
    ///
    /// APT: `APLCNA`, where the product is of section and length in the system of the curves.
    pub fn rise(&self) -> f64 {
        let scale = self.transform().map_or(1.0, |m| {
            let size = m.vector(Vec3::x()).norm();
            if m.mirrors() { -size } else { size }
        });
        -self.thickness * scale
    }
}

/// One section of a polyconic, in the coordinates y and z of its system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Where the conic begins.
    pub start: Vec2,
    /// Where its end tangents meet.
    pub apex: Vec2,
    /// Where it ends.
    pub end: Vec2,
    /// Weight of the apex in the rational quadratic form: below 1 an ellipse, 1 a parabola, above it a
    /// hyperbola.
    pub weight: f64,
}

impl Section {
    /// Point at `t` in 0 to 1.
    pub fn point(&self, t: f64) -> Vec2 {
        let (a, b, c) = ((1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t) * self.weight, t * t);
        (self.start * a + self.apex * b + self.end * c) / (a + b + c)
    }
}

impl Polyconic {
    /// The section at share `d` of the length; `None` where the fullness is not between one half and one,
    /// for which there is no conic.
    ///
    /// The fullness is the height of the shoulder over the far corner of the parallelogram of start, apex
    /// and end, in shares of the diagonal; so one half is the chord and one is the apex itself.
    pub fn section(&self, d: f64) -> Option<Section> {
        let [a, b, c, e, l, h, p] = self.curves.map(|f| f.at(d));
        let start = Vec2::new(l, h);
        let apex = start + Vec2::new(c, b);
        let shoulder = 2.0 * p - 1.0;
        (shoulder > 0.0 && shoulder < 1.0).then(|| Section {
            start,
            apex,
            end: apex + Vec2::new(a, e),
            weight: shoulder / (1.0 - shoulder),
        })
    }

    /// The point of the defined surface at share `d` of the length and `t` of the section, in the part's
    /// system, without the thickness.
    pub fn point(&self, d: f64, t: f64) -> Option<Vec3> {
        let q = self.section(d)?.point(t);
        let p = Vec3::new(self.origin + d * self.length, q.x, q.y);
        Some(self.transform().map_or(p, |m| m.point(p)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn canonical_elements_come_back() {
        let e: [f64; 79] = std::array::from_fn(|i| i as f64 + 0.25);
        let p = Polyconic::from_canonical(&e);
        assert_eq!(p.canonical(), e);
        assert_eq!(vec![p.curves[6].c[0], p.curves[6].root], vec![64.25, 78.25]);
        let c = ControlCurve { root: 2.0, c: [1.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0] };
        assert!((c.at(4.0) - (4.0 + 1.0 + 12.0 + 16384.0)).abs() < 1e-9);
    }

    /// Points go by the matrix into the system of the curves, as in APT-360: here the part's (-y, x, z) + (4, 5, 6).
    #[test]
    fn the_matrix_leads_into_the_system_of_the_curves() {
        let mut e = [0.0; 79];
        e[0] = 1.0;
        (e[13], e[15], e[64]) = (0.5, 10.0, 0.75);
        (e[24], e[16]) = (1.0, 1.0);
        assert!((Polyconic::from_canonical(&e).rise() + 0.5).abs() < 1e-15);
        let plain = Polyconic::from_canonical(&e).point(0.3, 0.4).unwrap();
        e[1..13].copy_from_slice(&[0.0, -1.0, 0.0, 4.0, 1.0, 0.0, 0.0, 5.0, 0.0, 0.0, 1.0, 6.0]);
        let turned = Polyconic::from_canonical(&e);
        let p = turned.point(0.3, 0.4).unwrap();
        assert!((Vec3::new(4.0 - p.y, p.x + 5.0, p.z + 6.0) - plain).norm() < 1e-14);
        assert!((turned.rise() + 0.5).abs() < 1e-15 && !turned.is_skew());
        // A mirror turns the product of length and section, and the side of the thickness stays.
        e[2] = 1.0;
        assert!((Polyconic::from_canonical(&e).rise() - 0.5).abs() < 1e-15);
        e[2] = 1.01;
        assert!(Polyconic::from_canonical(&e).is_skew());
        e[2] = 0.0;
        assert!(Polyconic::from_canonical(&e).is_skew());
    }

    /// A quarter circle of radius 1 + d: fullness where the weight is cos 45.
    #[test]
    fn a_quarter_circle_comes_out_round() {
        let mut e = [0.0; 79];
        e[0] = 1.0;
        (e[14], e[15]) = (2.0, 10.0);
        let w = std::f64::consts::FRAC_1_SQRT_2;
        // A and D: the way from the apex (r, r) to (0, r); C and B: from (r, 0) to the apex.
        (e[16], e[17]) = (-1.0, -1.0);
        (e[24], e[25]) = (1.0, 1.0);
        (e[48], e[49]) = (1.0, 1.0);
        e[64] = 0.5 + 0.5 * w / (1.0 + w);
        let p = Polyconic::from_canonical(&e);
        for d in [0.0, 0.3, 1.0] {
            for t in [0.0, 0.2, 0.5, 0.8, 1.0] {
                let q = p.point(d, t).unwrap();
                assert!((q.yz().norm() - (1.0 + d)).abs() < 1e-14, "{q:?}");
                assert!((q.x - (2.0 + 10.0 * d)).abs() < 1e-14);
            }
        }
        assert!(p.rise().abs() < 1e-15);
        e[64] = 0.4;
        assert!(Polyconic::from_canonical(&e).section(0.5).is_none());
    }
}
