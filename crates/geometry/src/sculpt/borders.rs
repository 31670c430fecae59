//! How a surface goes on at its borders: straight on, or in itself.

use super::{Layout, Sculptured};
use crate::Vec3;

/// Share of the surface's size up to which two places are one.
const SAME: f64 = 1e-9;
/// Places along a border at which it is looked at.
const PLACES: u8 = 16;
/// Difference of the normals on both sides of a seam, or round a pole, up to which the surface is smooth there.
const ALIKE: f64 = 1e-4;
/// So much of the way to where lines cross that go on from a border.
const CLEAR: f64 = 0.999;
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

    /// How far beyond the first or last border of u (0) or v (1) the lines go on straight, in shares of the surface, before they
    /// cross, as round a hole they do on its axis. Of a border that closes in itself to the first place where two do; of another, a
    /// corner of which alone may be round, to where all are turned over. Infinite where they do not.
    pub fn runs_on(&self, axis: usize, last: bool) -> f64 {
        let (border, out) = if last { (1.0, 1.0) } else { (0.0, -1.0) };
        let [nu, nv] = self.spans();
        let to_crossing = |uv: [f64; 2]| {
            let d = self.place(uv).rated(nu, nv);
            let (way, side) = if axis == 0 { (d.u, d.v) } else { (d.v, d.u) };
            // With what lies along the border the normal comes to go against what it was.
            let (normal, turned) = (way.cross(&side), way.cross(&d.uv) * out);
            let falls = -normal.dot(&turned);
            if falls > 0.0 { normal.norm_squared() / falls } else { f64::INFINITY }
        };
        let all = along(axis, border).map(to_crossing);
        CLEAR
            * if self.closes(1 - axis) {
                all.fold(f64::INFINITY, f64::min)
            } else {
                all.fold(0.0, f64::max)
            }
    }

    /// The control points of the curves that make up the first or last border of u (0) or v (1).
    pub(crate) fn border_curves(
        &self,
        [axis, end]: [usize; 2],
    ) -> impl Iterator<Item = [Vec3; 4]> + '_ {
        let [columns, rows] = match &self.layout {
            Layout::Mesh { u, v } => [u.len() - 1, v.len() - 1],
            Layout::Patches => [self.patches.len(), 1],
        };
        let last = if axis == 0 { columns - 1 } else { rows - 1 };
        let (across, along) = (last * end, if axis == 0 { rows } else { columns });
        (0..along).map(move |k| {
            let index = if axis == 0 { k * columns + across } else { across * columns + k };
            let net = &self.patches[index].net;
            [0, 1, 2, 3].map(|k| {
                let h = if axis == 0 { net[k][3 * end] } else { net[3 * end][k] };
                h.xyz() / h.w
            })
        })
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

#[cfg(test)]
mod tests {
    use super::super::{CubicArc, Patch, SpaceCurve, revolve};
    use super::*;

    fn turned(from: f64, to: f64, angles: [f64; 2]) -> Sculptured {
        let [a, b] = [from, to].map(|r| Vec3::new(r, 0.0, 9.0 - 0.5 * r));
        let curve = SpaceCurve::new(vec![CubicArc::hermite(a, b, b - a, b - a)]);
        revolve(&curve, Vec3::zeros(), Vec3::z(), angles, true).unwrap()
    }

    /// Towards the axis, which is half as far from the rim of the hole as that is wide, and outwards without end.
    #[test]
    fn lines_round_a_hole_cross_on_its_axis() {
        for angles in [[0.0, 360.0], [30.0, 170.0]] {
            let s = turned(4.0, 12.0, angles);
            assert!((s.runs_on(0, false) - 0.4995).abs() < 1e-9, "{}", s.runs_on(0, false));
            for (axis, last) in [(0, true), (1, false), (1, true)] {
                assert!(s.runs_on(axis, last) > 1e9, "{axis} {last}");
            }
        }
    }

    /// One corner of a border is round: along the rest of it the surface goes on.
    #[test]
    fn a_round_corner_does_not_end_all_of_a_border() {
        let flat = |a: Vec3, b: Vec3, out: [Vec3; 2], along: [Vec3; 2]| {
            let twist = out[1] - out[0];
            Patch::hermite([
                [a - out[0], b - out[1], along[0], along[1]],
                [a, b, along[0], along[1]],
                [out[0], out[1], twist, twist],
                [out[0], out[1], twist, twist],
            ])
        };
        let (x, y) = (Vec3::x(), Vec3::y());
        let straight = flat(Vec3::zeros(), x * 5.0, [y; 2], [x * 5.0; 2]);
        let corner = flat(x * 5.0, x * 6.0 + y, [y, -x], [x * 2.0, y * 2.0]);
        let s = Sculptured::grid(vec![straight, corner], 2, 1).unwrap();
        assert!(s.runs_on(1, true).is_infinite());
    }
}
