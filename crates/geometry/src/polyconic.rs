//! POLCON: a family of conic sections in parallel planes, steered by polynomials.

use serde::{Deserialize, Serialize};

use crate::Transform;

/// POLCON. In the plane at distance `d` from `origin` along the polyconic the section is a conic from
/// (L, H) by (C, B) to the apex and by (A, D) to the end, all of them functions of `d`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Polyconic {
    /// First canonical element: 2 when the control curves have square roots, else 1.
    pub roots: f64,
    /// Elements 2 to 13 as written; all zero means no transformation.
    pub matrix: [f64; 12],
    /// Thickness between the defined surface and the working surface.
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
    pub fn transform(&self) -> Option<Transform> {
        self.matrix.iter().any(|e| *e != 0.0).then(|| Transform::from_rows(&self.matrix))
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
}
