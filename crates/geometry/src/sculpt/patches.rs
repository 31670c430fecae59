//! PATCH: single patches by sixteen items each.

use super::arc::{CubicArc, weighted};
use super::patch::Patch;
use crate::Vec3;

/// PNTVEC: two points, two tangents along u at v = 0; the same at v = 1; two tangents across and two
/// twists at v = 0; the same at v = 1.
pub fn from_vectors(items: [Vec3; 16]) -> Patch {
    let row = |k: usize| [items[k], items[k + 1], items[k + 2], items[k + 3]];
    Patch::hermite([row(0), row(4), row(8), row(12)])
}

/// POLYGN: four rows of four control points.
pub fn from_polygon(items: [Vec3; 16]) -> Patch {
    let h = items.map(|p| weighted(p, 1.0));
    let row = |k: usize| [h[k], h[k + 1], h[k + 2], h[k + 3]];
    Patch::new([row(0), row(4), row(8), row(12)])
}

/// PNTSON: four rows of four points that the patch passes at the thirds of its parameters.
pub fn from_points(items: [Vec3; 16]) -> Patch {
    let h = items.map(|p| weighted(p, 1.0));
    let mut net = [[h[0]; 4]; 4];
    for (j, row) in net.iter_mut().enumerate() {
        *row = through([h[4 * j], h[4 * j + 1], h[4 * j + 2], h[4 * j + 3]]).b;
    }
    for i in 0..4 {
        let along = through([net[0][i], net[1][i], net[2][i], net[3][i]]).b;
        for (row, b) in net.iter_mut().zip(along) {
            row[i] = b;
        }
    }
    Patch::new(net)
}

/// POLYGN and PNTSON whose inner items are all zero: the two rows inside, when wholly zero, lie straight
/// between the outer ones; the four items inside alone are those of the bilinear blend of the border.
pub fn filled(mut items: [Vec3; 16]) -> [Vec3; 16] {
    let zero = |k: usize| items[k] == Vec3::zeros();
    let third = 1.0 / 3.0;
    if (4..12).all(zero) {
        for i in 0..4 {
            let (a, b) = (items[i], items[12 + i]);
            items[4 + i] = a + (b - a) * third;
            items[8 + i] = a + (b - a) * (2.0 * third);
        }
    } else if [5, 6, 9, 10].into_iter().all(zero) {
        let p = items;
        for (j, i) in [(1, 1), (1, 2), (2, 1), (2, 2)] {
            let (u, v) = (i as f64 * third, j as f64 * third);
            let at = |j: usize, i: usize| p[4 * j + i];
            let rows = at(0, i) * (1.0 - v) + at(3, i) * v;
            let columns = at(j, 0) * (1.0 - u) + at(j, 3) * u;
            let corners = (at(0, 0) * (1.0 - u) + at(0, 3) * u) * (1.0 - v)
                + (at(3, 0) * (1.0 - u) + at(3, 3) * u) * v;
            items[4 * j + i] = rows + columns - corners;
        }
    }
    items
}

/// The arc through four points at its thirds.
fn through(p: [super::arc::Vec4; 4]) -> CubicArc {
    let [a, b, c, d] = p;
    let second = (a * -5.0 + b * 18.0 - c * 9.0 + d * 2.0) / 6.0;
    let third = (a * 2.0 - b * 9.0 + c * 18.0 - d * 5.0) / 6.0;
    CubicArc { b: [a, second, third, d] }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn items() -> [Vec3; 16] {
        core::array::from_fn(|k| {
            let (i, j) = ((k % 4) as f64, (k / 4) as f64);
            Vec3::new(i, j, 0.1 * i * i - 0.2 * i * j + 0.05 * j * j * j)
        })
    }

    #[test]
    fn a_patch_passes_its_points() {
        let p = from_points(items());
        for (k, q) in items().iter().enumerate() {
            let (u, v) = ((k % 4) as f64 / 3.0, (k / 4) as f64 / 3.0);
            assert!((p.point(u, v) - q).norm() < 1e-13);
        }
    }

    #[test]
    fn vectors_and_polygon_say_the_same() {
        let p = from_polygon(items());
        let corner = |u: f64, v: f64| p.at(u, v);
        let row = |v: f64| [corner(0.0, v), corner(1.0, v)];
        let q = from_vectors([
            row(0.0)[0].point,
            row(0.0)[1].point,
            row(0.0)[0].u,
            row(0.0)[1].u,
            row(1.0)[0].point,
            row(1.0)[1].point,
            row(1.0)[0].u,
            row(1.0)[1].u,
            row(0.0)[0].v,
            row(0.0)[1].v,
            row(0.0)[0].uv,
            row(0.0)[1].uv,
            row(1.0)[0].v,
            row(1.0)[1].v,
            row(1.0)[0].uv,
            row(1.0)[1].uv,
        ]);
        assert!((p.point(0.3, 0.8) - q.point(0.3, 0.8)).norm() < 1e-14);
    }
}
