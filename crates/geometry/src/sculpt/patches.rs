//! PATCH: single patches by sixteen items each.

use nalgebra::{Matrix4, Matrix4x3, RowVector4};

use super::arc::weighted;
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

/// PNTSON: four rows of four points. The sides of the patch pass their inner points at the parameters that these have along the chord
/// of the side; the twists are those with which the patch passes the four points inside, each at the mean of its places along
/// the chords of opposite sides.
///
/// Where two of the four coincide there is no twist; where the two rows inside are one point the patch is straight between the outer ones.
/// APT: `PNTSON`, `PARMPT`, `COMPTW`. Source: APT4 SSV3.
pub fn from_points(items: [Vec3; 16]) -> Patch {
    let at = |j: usize, i: usize| items[4 * j + i];
    let row = |j: usize| side(core::array::from_fn(|i| at(j, i)));
    let column = |i: usize| side(core::array::from_fn(|j| at(j, i)));
    let (u0, u1) = (row(0), row(3));
    let ends = |j: usize, u: [Vec3; 2]| [at(j, 0), at(j, 3), u[0], u[1]];
    let straight = (5..12).all(|k| items[k] == items[4]);
    if straight {
        let across = [at(3, 0) - at(0, 0), at(3, 3) - at(0, 3), u1[0] - u0[0], u1[1] - u0[1]];
        return Patch::hermite([ends(0, u0), ends(3, u1), across, across]);
    }
    let (v0, v1) = (column(0), column(3));
    let twisted = |t: [Vec3; 4]| {
        let across = |k: usize| [v0[k], v1[k], t[2 * k], t[2 * k + 1]];
        Patch::hermite([ends(0, u0), ends(3, u1), across(0), across(1)])
    };
    let bare = twisted([Vec3::zeros(); 4]);
    let inside = [at(1, 1), at(1, 2), at(2, 1), at(2, 2)];
    if (1..4).any(|k| inside[..k].contains(&inside[k])) {
        return bare;
    }
    let mut system = Matrix4::zeros();
    let mut wanted = Matrix4x3::zeros();
    for (k, p) in inside.into_iter().enumerate() {
        let mean = |a: [Vec3; 2], b: [Vec3; 2]| 0.5 * (along(a, p) + along(b, p));
        let u = mean([at(0, 0), at(0, 3)], [at(3, 0), at(3, 3)]);
        let v = mean([at(0, 0), at(3, 0)], [at(0, 3), at(3, 3)]);
        let bend = |t: f64| [t * (1.0 - t) * (1.0 - t), t * t * (t - 1.0)];
        let (f, g) = (bend(u), bend(v));
        system.set_row(k, &RowVector4::new(f[0] * g[0], f[1] * g[0], f[0] * g[1], f[1] * g[1]));
        wanted.set_row(k, &(p - bare.point(u, v)).transpose());
    }
    match system.lu().solve(&wanted) {
        Some(t) => twisted(core::array::from_fn(|k| t.row(k).transpose())),
        None => bare,
    }
}

/// Where `p` lies along the chord from `a` to `b`: 0 at `a`, 1 at `b`.
fn along([a, b]: [Vec3; 2], p: Vec3) -> f64 {
    let d = b - a;
    let square = d.norm_squared();
    if square > 0.0 { (p - a).dot(&d) / square } else { 0.5 }
}

/// The tangents at both ends of the cubic that passes its inner points where they lie along the chord.
fn side(p: [Vec3; 4]) -> [Vec3; 2] {
    let d = p[3] - p[0];
    let [b, c] = [along([p[0], p[3]], p[1]), along([p[0], p[3]], p[2])];
    let off = |t: f64, q: Vec3| q - p[0] - d * (t * t * (3.0 - 2.0 * t));
    let bend = |t: f64| [t * (1.0 - t) * (1.0 - t), t * t * (t - 1.0)];
    let solved = |b: f64, c: f64| {
        let ([b0, b1], [c0, c1]) = (bend(b), bend(c));
        let det = b0 * c1 - b1 * c0;
        let (x, y) = (off(b, p[1]), off(c, p[2]));
        (det.abs() > 1e-12).then(|| [(x * c1 - y * b1) / det, (y * b0 - x * c0) / det])
    };
    // Points that coincide, or turn back on the chord, say nothing of the parameter: thirds.
    solved(b, c).or_else(|| solved(1.0 / 3.0, 2.0 / 3.0)).unwrap_or([d; 2])
}

/// POLYGN whose inner items are all zero: the two rows inside, when wholly zero, lie straight
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
        let given = items();
        let p = from_points(given);
        let at = |j: usize, i: usize| given[4 * j + i];
        for (k, q) in given.into_iter().enumerate() {
            let (i, j) = (k % 4, k / 4);
            let on = |a: Vec3, b: Vec3| along([a, b], q);
            let u = match j {
                0 | 3 => on(at(j, 0), at(j, 3)),
                _ if i % 3 == 0 => (i / 3) as f64,
                _ => 0.5 * (on(at(0, 0), at(0, 3)) + on(at(3, 0), at(3, 3))),
            };
            let v = match i {
                0 | 3 => on(at(0, i), at(3, i)),
                _ if j % 3 == 0 => (j / 3) as f64,
                _ => 0.5 * (on(at(0, 0), at(3, 0)) + on(at(0, 3), at(3, 3))),
            };
            assert!((p.point(u, v) - q).norm() < 1e-13, "{k}");
        }
    }

    /// Sides of a patch as SSV3 gives them.
    #[test]
    fn sides_pass_their_points_along_the_chord() {
        let p = from_points(core::array::from_fn(|k| {
            let (i, j) = ((k % 4) as f64, (k / 4) as f64);
            Vec3::new(i + 0.1 * j * j, 1.3 * j, 0.1 * i * i - 0.2 * i * j + 0.05 * j * j * j)
        }));
        for (u, v, q) in [
            (0.3, 0.0, [0.953_703_240, 0.0, 0.090_989_201]),
            (0.4, 0.0, [1.260_389_665, 0.0, 0.158_701_116]),
            (0.0, 0.7, [0.496_907_486, 2.898_068_279, 0.548_197_760]),
        ] {
            assert!((p.point(u, v) - Vec3::from(q)).norm() < 1e-9, "{u} {v}");
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
