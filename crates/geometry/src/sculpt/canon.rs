//! CANON: the arrays of numbers by which APT4 kept curves and surfaces, and those that `canonical` gives.
//!
//! Source: TEST32 of SSV3, whose surface is such an array, and the routines that carry one by a matrix
//! (`SSTRA`, `SCTRA`). Word 1 of SSV3 is not written, so its pointers are two more than a place here.

use super::arc::{CubicArc, Vec4};
use super::curve::SpaceCurve;
use super::patch::Patch;
use super::surface::{SculptFault, Sculptured};
use super::whole;
use crate::Vec3;

/// Words before the patches of a surface, and words of each.
const HEAD: usize = 9;
const ENTRY: usize = 6;
/// Words of the arc of a curve: four each of x, y, z, w, then cross direction and normal.
const ARC: usize = 24;

/// The surface of an array; `None` when it is neither that of SSV3 nor ours.
pub(crate) fn surface(e: &[f64]) -> Option<Result<Sculptured, SculptFault>> {
    own_surface(e).or_else(|| kept_surface(e))
}

/// The curve of an array.
pub(crate) fn curve(e: &[f64]) -> Option<SpaceCurve> {
    own_curve(e).or_else(|| kept_curve(e))
}

/// A whole number that is a place in the array.
fn place(e: &[f64], at: usize) -> Option<usize> {
    let x = *e.get(at)?;
    ((0.0..=1e9).contains(&x) && x.fract() == 0.0).then(|| whole(x))
}

/// Columns and rows, number of patches, then the control points of each.
fn own_surface(e: &[f64]) -> Option<Result<Sculptured, SculptFault>> {
    let [columns, rows, n] = [place(e, 0)?, place(e, 1)?, place(e, 2)?];
    if n == 0 || e.len() != n.checked_mul(64)?.checked_add(3)? {
        return None;
    }
    let patches = e[3..].chunks_exact(64).map(|c| {
        let h = |k: usize| Vec4::new(c[4 * k], c[4 * k + 1], c[4 * k + 2], c[4 * k + 3]);
        Patch::new([0, 1, 2, 3].map(|j| [0, 1, 2, 3].map(|i| h(4 * j + i))))
    });
    let patches = patches.collect();
    Some(match (columns, rows) {
        (0, 0) => Sculptured::loose(patches),
        _ => Sculptured::grid(patches, columns, rows),
    })
}

/// The array of SSV3: a head with the number of patches, for each the kinds of its four matrices and where
/// they begin, then the matrices, then the neighbours of each patch.
fn kept_surface(e: &[f64]) -> Option<Result<Sculptured, SculptFault>> {
    let n = place(e, 2)?;
    if n == 0 || place(e, 6)?.checked_sub(1) != Some(e.len()) || n > e.len() / ENTRY {
        return None;
    }
    let mut patches = Vec::with_capacity(n);
    for k in 0..n {
        let at = HEAD + ENTRY * k;
        let mut from = place(e, at + 4)?.checked_sub(2)?;
        let mut coordinates = [[0.0; 16]; 4];
        for (c, matrix) in coordinates.iter_mut().enumerate() {
            let (full, used) = matrix_of(e.get(from..)?, place(e, at + c)?)?;
            *matrix = full;
            from += used;
        }
        patches.push(of_matrices(&coordinates));
    }
    // Points of the splines and their number; without a mesh they say something else.
    let [across, along] = [place(e, 7)?, place(e, 8)?].map(|m| m.saturating_sub(1));
    Some(match across.checked_mul(along) {
        Some(cells) if cells == n && is_grid(&patches, along) => {
            Sculptured::grid(patches, along, across)
        }
        _ => Sculptured::loose(patches),
    })
}

/// Rows `P00 P10 Pu00 Pu10`, `P01 P11 Pu01 Pu11`, `Pv00 Pv10 Puv00 Puv10`, `Pv01 Pv11 Puv01 Puv11` of a
/// coordinate, and the number of words read. Kind 1 is a constant, 2 the four corners of a bilinear patch (the
/// meshes XYPLAN of TEST01 have 21 words a patch: 4, 4, 12 and 1), 3 has no twists, 4 is full. Curves in
/// place of a patch (GENCUR) are not known well enough.
fn matrix_of(e: &[f64], kind: usize) -> Option<([f64; 16], usize)> {
    let mut m = [0.0; 16];
    let used = match kind {
        1 => {
            let c = *e.first()?;
            for k in [0, 1, 4, 5] {
                m[k] = c;
            }
            1
        }
        2 => {
            let c = e.get(..4)?;
            let (u, v) = ([c[1] - c[0], c[3] - c[2]], [c[2] - c[0], c[3] - c[1]]);
            let twist = u[1] - u[0];
            m = [
                c[0], c[1], u[0], u[0], c[2], c[3], u[1], u[1], v[0], v[1], twist, twist, v[0],
                v[1], twist, twist,
            ];
            4
        }
        3 => {
            let words = e.get(..12)?;
            m[..8].copy_from_slice(&words[..8]);
            for (to, from) in [(8, 8), (9, 9), (12, 10), (13, 11)] {
                m[to] = words[from];
            }
            12
        }
        4 => {
            m.copy_from_slice(e.get(..16)?);
            16
        }
        _ => return None,
    };
    Some((m, used))
}

/// The patch of four matrices; the coordinates are those of the point times its weight.
fn of_matrices([x, y, z, w]: &[[f64; 16]; 4]) -> Patch {
    let h = |k: usize| Vec4::new(x[k], y[k], z[k], w[k]);
    let along = |r: usize| CubicArc::homogeneous(h(r), h(r + 1), h(r + 2), h(r + 3)).b;
    let rows = [along(0), along(4), along(8), along(12)];
    let mut net = [[Vec4::zeros(); 4]; 4];
    for i in 0..4 {
        let across = CubicArc::homogeneous(rows[0][i], rows[1][i], rows[2][i], rows[3][i]).b;
        for (row, b) in net.iter_mut().zip(across) {
            row[i] = b;
        }
    }
    Patch::new(net)
}

/// Do neighbours in a grid of so many columns share their corners?
fn is_grid(patches: &[Patch], columns: usize) -> bool {
    let size = patches.iter().flat_map(Patch::bounds).map(|b| b.norm()).fold(0.0, f64::max);
    let same = |a: Vec3, b: Vec3| (a - b).norm() <= 1e-5 * size;
    patches.iter().enumerate().all(|(k, p)| {
        let beside = (k + 1) % columns == 0
            || patches.get(k + 1).is_some_and(|q| {
                [0.0, 1.0].iter().all(|t| same(p.point(1.0, *t), q.point(0.0, *t)))
            });
        let above = patches
            .get(k + columns)
            .is_none_or(|q| [0.0, 1.0].iter().all(|t| same(p.point(*t, 1.0), q.point(*t, 0.0))));
        beside && above
    })
}

/// Number of arcs, then the control points of each.
fn own_curve(e: &[f64]) -> Option<SpaceCurve> {
    let n = place(e, 0)?;
    if n == 0 || e.len() != n.checked_mul(16)?.checked_add(1)? {
        return None;
    }
    let arcs = e[1..].chunks_exact(16).map(|c| {
        let h = |k: usize| Vec4::new(c[4 * k], c[4 * k + 1], c[4 * k + 2], c[4 * k + 3]);
        CubicArc { b: [h(0), h(1), h(2), h(3)] }
    });
    sound(arcs.collect())
}

/// The array of SSV3: at words 4 and 5 the number of arcs and where the first begins, 24 words apart.
fn kept_curve(e: &[f64]) -> Option<SpaceCurve> {
    let n = place(e, 2)?;
    let from = place(e, 3)?.checked_sub(2)?;
    // Behind the last arc its end may be written, but need not.
    let needed = from.checked_add(n.checked_sub(1)?.checked_mul(ARC)?)?.checked_add(16)?;
    if from < 4 || needed > e.len() {
        return None;
    }
    let arcs = (0..n).map(|k| {
        let c = &e[from + ARC * k..];
        let h = |i: usize| Vec4::new(c[i], c[4 + i], c[8 + i], c[12 + i]);
        CubicArc::homogeneous(h(0), h(1), h(2), h(3))
    });
    sound(arcs.collect())
}

fn sound(arcs: Vec<CubicArc>) -> Option<SpaceCurve> {
    let good = arcs.iter().flat_map(|a| &a.b).all(|h| h.iter().all(|x| x.is_finite()) && h.w > 0.0);
    good.then(|| SpaceCurve::new(arcs))
}

#[cfg(test)]
mod tests {
    use super::super::{Layout, SplinePoint, mesh, spline};
    use super::*;
    use crate::sculptured::MeshSpacing;

    fn made() -> Sculptured {
        let at = |x: f64, y: f64| SplinePoint::plain(Vec3::new(x, y, 0.3 * x * y - 0.1 * x * x));
        let row = |j: usize| (0..4).map(|i| at(i as f64, j as f64)).collect::<Vec<_>>();
        mesh(&(0..3).map(row).collect::<Vec<_>>(), MeshSpacing::Xyz).unwrap()
    }

    /// As SSV3 would write the mesh, the matrices of these kinds.
    fn kept(s: &Sculptured, kinds: [f64; 4], along: f64, across: f64) -> Vec<f64> {
        let n = s.patches.len();
        let mut values = Vec::new();
        let mut entries = Vec::new();
        let first = HEAD + ENTRY * n + 2;
        for p in &s.patches {
            entries.extend(kinds);
            entries.extend([(first + values.len()) as f64, 0.0]);
            let c = |u: f64, v: f64| p.at(u, v);
            let (a, b, d, e) = (c(0.0, 0.0), c(1.0, 0.0), c(0.0, 1.0), c(1.0, 1.0));
            for k in 0..3 {
                let full = [
                    a.point, b.point, a.u, b.u, d.point, e.point, d.u, e.u, a.v, b.v, a.uv, b.uv,
                    d.v, e.v, d.uv, e.uv,
                ];
                let short = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 13];
                if (kinds[k] - 2.0).abs() < 0.5 {
                    values.extend([0, 1, 4, 5].map(|i| full[i][k]));
                } else if (kinds[k] - 3.0).abs() < 0.5 {
                    values.extend(short.map(|i| full[i][k]));
                } else {
                    values.extend(full.map(|v| v[k]));
                }
            }
            values.push(1.0);
        }
        let total = (HEAD + entries.len() + values.len() + 1) as f64;
        let mut e = vec![values.len() as f64, 0.0, n as f64, 2.0, 4.0, 1.0, total, across, along];
        e.extend(entries);
        e.extend(values);
        e
    }

    #[test]
    fn an_array_of_ssv3_is_the_surface() {
        let s = made();
        let e = kept(&s, [4.0, 4.0, 4.0, 1.0], 4.0, 3.0);
        let back = surface(&e).unwrap().unwrap();
        assert!(matches!(back.layout, Layout::Mesh { .. }));
        for k in 0..20 {
            let (u, v) = (0.149 * f64::from(k), 0.097 * f64::from(k));
            assert!((back.at(u, v).point - s.at(u, v).point).norm() < 1e-13);
        }
        // Without twists the corners and borders stay.
        let e = kept(&s, [3.0, 3.0, 3.0, 1.0], 4.0, 3.0);
        let back = surface(&e).unwrap().unwrap();
        assert!((back.at(1.4, 1.0).point - s.at(1.4, 1.0).point).norm() < 1e-13);
        // Cut short, of a kind that is not known, or pointing beyond its end it is none.
        assert!(surface(&e[..e.len() - 1]).is_none());
        for (at, x) in [(HEAD, 5.0), (HEAD + 4, 1e6), (HEAD + 4, -3.0), (2, 1e9)] {
            let mut bad = e.clone();
            bad[at] = x;
            assert!(surface(&bad).is_none(), "{at} {x}");
        }
    }

    /// A mesh over a plane, as TEST01 has them: 21 words a patch.
    #[test]
    fn bilinear_coordinates_are_read() {
        let at = |x: f64, y: f64| SplinePoint::plain(Vec3::new(x + 0.1 * x * y, y, x * y - x * x));
        let row = |j: usize| (0..4).map(|i| at(i as f64, j as f64)).collect::<Vec<_>>();
        let s = mesh(&(0..3).map(row).collect::<Vec<_>>(), MeshSpacing::Xyplan).unwrap();
        let e = kept(&s, [2.0, 2.0, 3.0, 1.0], 4.0, 3.0);
        assert_eq!(e.len(), HEAD + 6 * ENTRY + 6 * 21);
        let back = surface(&e).unwrap().unwrap();
        for k in 0..20 {
            let (u, v) = (0.149 * f64::from(k), 0.097 * f64::from(k));
            assert!((back.at(u, v).point - s.at(u, v).point).norm() < 1e-13);
        }
        assert!(surface(&e[..e.len() - 1]).is_none());
    }

    #[test]
    fn our_own_arrays_come_back() {
        let s = made();
        assert_eq!(surface(&s.canonical()).unwrap().unwrap(), s);
        let p = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.5], [3.0, 1.0, 0.0]]
            .map(|p| SplinePoint::plain(Vec3::from(p)));
        let c = SpaceCurve::new(spline(&p).unwrap());
        assert_eq!(curve(&c.canonical()).unwrap(), c);
        assert!(curve(&[1.0, 2.0, 3.5]).is_none());
    }

    #[test]
    fn a_curve_of_ssv3() {
        let mut e = vec![0.0; 10 + ARC];
        (e[2], e[3]) = (1.0, 12.0);
        // A straight line from (1, 0, 0) to (3, 4, 0).
        for (k, x) in [1.0, 3.0, 2.0, 2.0, 0.0, 4.0, 4.0, 4.0].into_iter().enumerate() {
            e[10 + k] = x;
        }
        (e[22], e[23]) = (1.0, 1.0);
        let c = curve(&e).unwrap();
        assert!((c.at(0.5).point - Vec3::new(2.0, 2.0, 0.0)).norm() < 1e-14);
    }
}
