//! How a surface goes on at its borders: straight on, or in itself.

use super::Sculptured;
use crate::Vec3;

/// Share of the surface's size up to which two places are one.
const SAME: f64 = 1e-9;
/// Places along a border at which it is looked at.
const PLACES: u8 = 16;
/// Difference of the normals on both sides of a seam, or round a pole, up to which the surface is smooth there.
const ALIKE: f64 = 1e-4;
/// Share of its way across at which a surface is looked at beside its borders.
const BESIDE: f64 = 1e-6;

/// What a border is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Border {
    /// The surface ends, and goes on straight.
    Free,
    /// The same place as the opposite border, and smooth across it.
    Seam,
    /// A point, round which a surface that closes has one normal.
    Pole,
    /// Another point, or a seam with an edge: nothing goes on there.
    Edge,
}

impl Sculptured {
    /// The first and the last border of u, and of v.
    pub fn borders(&self) -> [[Border; 2]; 2] {
        let even =
            |axis: usize| along(axis, 0.0).zip(along(axis, 1.0)).all(|(a, b)| self.alike(a, b));
        let joins = [0, 1].map(|axis| self.closes(axis));
        let seams = [0, 1].map(|axis| joins[axis] && even(axis));
        [0, 1].map(|axis| {
            [0_u8, 1].map(|last| {
                let end = f64::from(last);
                let flat = || {
                    let mut beside = along(axis, end + (0.5 - end) * BESIDE);
                    beside.next().is_some_and(|a| beside.all(|b| self.alike(a, b)))
                };
                match (self.is_point(axis, last == 1), joins[axis]) {
                    (true, _) if seams[1 - axis] && flat() => Border::Pole,
                    (false, true) if seams[axis] => Border::Seam,
                    (false, false) => Border::Free,
                    _ => Border::Edge,
                }
            })
        })
    }

    /// Is the first border of u (0) or v (1) in the same place as the last?
    pub fn closes(&self, axis: usize) -> bool {
        let size = self.extent();
        along(axis, 0.0).zip(along(axis, 1.0)).all(|(a, b)| self.same(a, b, size))
    }

    /// Is the first, or the last, border of u (0) or v (1) one point?
    pub fn is_point(&self, axis: usize, last: bool) -> bool {
        let (size, end) = (self.extent(), f64::from(u8::from(last)));
        let middle = if axis == 0 { [end, 0.5] } else { [0.5, end] };
        along(axis, end).all(|uv| self.same(uv, middle, size))
    }

    fn same(&self, a: [f64; 2], b: [f64; 2], size: f64) -> bool {
        (self.place(a).point - self.place(b).point).norm() <= SAME * size
    }

    /// The place by shares of the whole surface.
    fn place(&self, [u, v]: [f64; 2]) -> super::Derivatives {
        let [nu, nv] = self.spans();
        self.at(u * nu, v * nv)
    }

    fn alike(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        let normal = |uv: [f64; 2]| -> Option<Vec3> {
            let d = self.place(uv);
            d.u.cross(&d.v).try_normalize(0.0)
        };
        normal(a).zip(normal(b)).is_some_and(|(a, b)| (a - b).norm() <= ALIKE)
    }
}

/// Places with one value of the parameter `axis`, by shares of the whole surface.
fn along(axis: usize, at: f64) -> impl Iterator<Item = [f64; 2]> {
    (0..=PLACES).map(move |k| {
        let w = BESIDE + (1.0 - 2.0 * BESIDE) * f64::from(k) / f64::from(PLACES);
        if axis == 0 { [at, w] } else { [w, at] }
    })
}
