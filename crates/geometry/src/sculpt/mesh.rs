//! SMESH: a surface through rows of points.

use super::patch::Patch;
use super::smooth::smooth;
use super::spline::{SplineFault, SplinePoint, tangents};
use super::surface::{SculptFault, Sculptured};
use crate::Vec3;
use crate::sculptured::MeshSpacing;

/// Why rows make no mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFault {
    /// Fewer than two rows.
    TooFew,
    /// This row (counted from 0) has another number of points than the first.
    Uneven(usize),
    /// A row along the splines makes no curve.
    Spline(usize, SplineFault),
    /// A row across makes no curve.
    Cross(usize, SplineFault),
    /// The points make no surface.
    Surface(SculptFault),
}

/// The surface through the rows: u runs along a row, v from row to row.
///
/// Weights smooth the rows first, each for itself, as SSV3 does. TANSPL holds the direction along a row, CRSSPL across, NORMAL both. Tangents
/// are as long as chords, twists are zero. With RULED the lines across are straight; so they are between two rows without CRSSPL and NORMAL,
/// and the rows themselves where they have two points each without TANSPL and NORMAL.
///
/// XYPLAN, YZPLAN and ZXPLAN: seen along the axis square to that plane every patch is the bilinear one of its
/// corners; only the coordinate along that axis is curved, its tangents those of the unit tangents in space
/// times the chord in the plane. So a slope is the sine of that of XYZ, not its tangent: 1.5 % less at 10
/// degrees, 29 % at 45. Found from TEST01 of SSV3 (normals, curvatures and 21 numbers a patch), whose meshes
/// are rectangles in the plane; elsewhere each span has its own chord.
pub fn mesh(rows: &[Vec<SplinePoint>], spacing: MeshSpacing) -> Result<Sculptured, MeshFault> {
    let columns = rows.first().map_or(0, Vec::len);
    if rows.len() < 2 {
        return Err(MeshFault::TooFew);
    }
    if let Some(i) = rows.iter().position(|r| r.len() != columns) {
        return Err(MeshFault::Uneven(i));
    }
    let free = |held: fn(&SplinePoint) -> bool| !rows.iter().flatten().any(held);
    let ruled = spacing == MeshSpacing::Ruled
        || rows.len() == 2 && free(|p| p.cross.is_some() || p.normal.is_some());
    let straight = columns == 2 && free(|p| p.tangent.is_some() || p.normal.is_some());
    let mut rows = rows.to_vec();
    for row in &mut rows {
        smooth(row);
    }
    let mut along = Vec::with_capacity(rows.len());
    for (i, row) in rows.iter().enumerate() {
        along.push(tangents(row).map_err(|f| MeshFault::Spline(i, f))?);
    }
    let across = columns_tangents(&rows, columns)?;
    let height = match spacing {
        MeshSpacing::Xyplan => Some(2),
        MeshSpacing::Yzplan => Some(0),
        MeshSpacing::Zxplan => Some(1),
        MeshSpacing::Xyz | MeshSpacing::Ruled => None,
    };
    if let Some(axis) = height {
        let patches = over_plane(&rows, &along, &across, axis, [straight, ruled]);
        return Sculptured::grid(patches, columns - 1, rows.len() - 1).map_err(MeshFault::Surface);
    }
    let lu = lengths(rows.len(), columns, |j, i| rows[j][i].point);
    let lv = lengths(columns, rows.len(), |i, j| rows[j][i].point);
    let mut patches = Vec::with_capacity((columns - 1) * (rows.len() - 1));
    for j in 0..rows.len() - 1 {
        for i in 0..columns - 1 {
            let p = |a: usize, b: usize| rows[j + b][i + a].point;
            let u = |a: usize, b: usize| along[j + b][i + a] * lu[j + b][i][a];
            let v = |a: usize, b: usize| {
                if ruled { p(a, 1) - p(a, 0) } else { across[i + a][j + b] * lv[i + a][j][b] }
            };
            let twist = |a: usize, b: usize| match (straight, ruled) {
                (true, _) => v(1, b) - v(0, b),
                (_, true) => u(a, 1) - u(a, 0),
                _ => Vec3::zeros(),
            };
            let row = |b: usize| [p(0, b), p(1, b), u(0, b), u(1, b)];
            let side = |b: usize| [v(0, b), v(1, b), twist(0, b), twist(1, b)];
            patches.push(Patch::hermite([row(0), row(1), side(0), side(1)]));
        }
    }
    Sculptured::grid(patches, columns - 1, rows.len() - 1).map_err(MeshFault::Surface)
}

/// Patches that are bilinear but for the coordinate of the number `axis`; `straight` along and across.
fn over_plane(
    rows: &[Vec<SplinePoint>],
    along: &[Vec<Vec3>],
    across: &[Vec<Vec3>],
    axis: usize,
    straight: [bool; 2],
) -> Vec<Patch> {
    // The way from one point to the next, with the height that the unit tangent has on a way so long.
    let leaned = |chord: Vec3, tangent: Vec3| {
        let mut way = chord;
        way[axis] = 0.0;
        way[axis] = tangent[axis] * way.norm();
        way
    };
    let columns = rows[0].len();
    let mut patches = Vec::with_capacity((columns - 1) * (rows.len() - 1));
    for j in 0..rows.len() - 1 {
        for i in 0..columns - 1 {
            let p = |a: usize, b: usize| rows[j + b][i + a].point;
            let u = |a: usize, b: usize| leaned(p(1, b) - p(0, b), along[j + b][i + a]);
            let v = |a: usize, b: usize| leaned(p(a, 1) - p(a, 0), across[i + a][j + b]);
            let flat = p(1, 1) - p(1, 0) - p(0, 1) + p(0, 0);
            let twist = |a: usize, b: usize| {
                let mut t = flat;
                t[axis] = match straight {
                    [true, _] => v(1, b)[axis] - v(0, b)[axis],
                    [_, true] => u(a, 1)[axis] - u(a, 0)[axis],
                    _ => 0.0,
                };
                t
            };
            let row = |b: usize| [p(0, b), p(1, b), u(0, b), u(1, b)];
            let side = |b: usize| [v(0, b), v(1, b), twist(0, b), twist(1, b)];
            patches.push(Patch::hermite([row(0), row(1), side(0), side(1)]));
        }
    }
    patches
}

/// How far below and above their mean the chords of a span may lie that are given one length, by SSV3.
const EVEN: [f64; 2] = [0.95, 1.06];

/// Lengths of the tangents at both ends of each span of each line: `lengths[line][span]`.
///
/// Where the chords of every span are about equal over the lines, both are their mean. Else, and on lines
/// of one span, each line has its own chord, at a joint the lesser of the two that meet.
fn lengths(lines: usize, points: usize, at: impl Fn(usize, usize) -> Vec3) -> Vec<Vec<[f64; 2]>> {
    let chord = |l: usize, k: usize| (at(l, k + 1) - at(l, k)).norm();
    let spans = points - 1;
    let mean = |k: usize| (0..lines).map(|l| chord(l, k)).sum::<f64>() / lines as f64;
    let even = |k: usize| {
        let m = mean(k);
        (0..lines).all(|l| (EVEN[0] * m..=EVEN[1] * m).contains(&chord(l, k)))
    };
    if spans > 1 && (0..spans).all(even) {
        return vec![(0..spans).map(|k| [mean(k); 2]).collect(); lines];
    }
    let own = |l: usize| {
        let c: Vec<f64> = (0..spans).map(|k| chord(l, k)).collect();
        let joint = |k: usize| match (k.checked_sub(1).map(|b| c[b]), c.get(k)) {
            (Some(a), Some(b)) => a.min(*b),
            (Some(a), None) => a,
            (None, b) => b.copied().unwrap_or(0.0),
        };
        (0..spans).map(|k| [joint(k), joint(k + 1)]).collect()
    };
    (0..lines).map(own).collect()
}

/// Unit tangents across, one list a column.
fn columns_tangents(
    rows: &[Vec<SplinePoint>],
    columns: usize,
) -> Result<Vec<Vec<Vec3>>, MeshFault> {
    (0..columns)
        .map(|i| {
            let column: Vec<SplinePoint> =
                rows.iter().map(|r| SplinePoint { tangent: r[i].cross, ..r[i] }).collect();
            tangents(&column).map_err(|f| MeshFault::Cross(i, f))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::nearest::{along_line, nearest_on};
    use super::*;

    fn rows(z: &[[[f64; 3]; 3]]) -> Vec<Vec<SplinePoint>> {
        z.iter().map(|r| r.iter().map(|p| SplinePoint::plain(Vec3::from(*p))).collect()).collect()
    }

    /// Surface SRF of TEST39 with a normal and two tangents given; the printed digits.
    #[test]
    fn printed_points_of_a_constrained_mesh() {
        let mut r = rows(&[
            [[0.0, 0.0, 0.0], [7.0, 2.0, 1.0], [12.0, 4.0, 0.0]],
            [[0.0, 3.0, 0.0], [7.0, 5.0, 1.2], [12.0, 6.0, 0.0]],
            [[0.2, 7.0, 0.2], [7.0, 8.0, 1.2], [12.0, 9.0, 0.2]],
        ]);
        r[0][0].normal = Some(Vec3::new(-0.4, 0.017, 0.9));
        r[0][0].tangent = Some(Vec3::new(6.7, 1.3, 2.83));
        r[1][0].tangent = Some(Vec3::new(6.15, 2.25, 3.4));
        let s = mesh(&r, MeshSpacing::Xyz).unwrap();
        let n = |u: f64, v: f64| s.at(u, v).normal().unwrap();
        for (u, v, printed) in [
            (0.0, 0.0, [-0.40608, 0.01726, 0.91368]),
            (1.0, 0.0, [0.10441, -0.09911, 0.98958]),
            (2.0, 0.0, [0.32272, 0.02510, 0.94616]),
            (0.0, 1.0, [-0.48072, -0.01097, 0.87680]),
            (1.0, 1.0, [0.09525, -0.03309, 0.99490]),
            (2.0, 2.0, [0.34812, -0.09963, 0.93214]),
        ] {
            assert!((n(u, v) - Vec3::from(printed)).norm() < 2e-5, "{u} {v} {}", n(u, v));
        }
        let d = s.at(1.1, 1.2);
        assert!(
            (d.point - Vec3::new(7.513_811, 5.711_049, 1.164_761)).norm() < 2e-6,
            "{}",
            d.point
        );
        assert!((d.u - Vec3::new(5.121_045, 1.062_564, -0.590_318)).norm() < 2e-6, "{}", d.u);
        // The printed place nearest to (6, 6, 3) is 0.04 off the nearest one.
        let (p, printed) = (Vec3::new(6.0, 6.0, 3.0), Vec3::new(6.007_903, 6.014_283, 1.265_433));
        let near = nearest_on(&s, p);
        assert!(near.distance < (p - printed).norm());
        assert!((near.at.point - printed).norm() < 0.04);
        assert!(near.at.normal().unwrap().cross(&(near.at.point - p)).norm() < 1e-7);
        let hits = along_line(&s, Vec3::new(6.0, 6.0, 3.0), Vec3::new(-0.5, -0.4, -1.02));
        let hit = hits.first().unwrap();
        assert!((hit.at.point - Vec3::new(5.146_898, 5.317_524, 1.259_656)).norm() < 5e-5);
        assert!((hit.at.v - Vec3::new(0.050_688, 3.116_401, -0.033_710)).norm() < 1e-4);
    }

    /// Surface SSDRIV of TEST01: the point of weight .5 moves as its row alone asks for, not the one across, and the
    /// normals are those that are printed, one of them given.
    #[test]
    fn a_weight_moves_a_point_along_its_row() {
        let mut r = rows(&[
            [[10.0, -3.0, -10.0], [10.0, -2.0, 0.0], [10.0, -3.0, 10.0]],
            [[0.0, -1.0, -10.0], [0.0, 0.0, 0.0], [0.0, -1.0, 10.0]],
            [[-10.0, -3.0, -10.0], [-10.0, -2.0, 0.0], [-10.0, -3.0, 10.0]],
        ]);
        r[1][2].normal = Some(Vec3::new(10.0, 0.0, 1.0));
        r[2][1].weight = Some(0.5);
        let s = mesh(&r, MeshSpacing::Xyz).unwrap();
        let p = s.at(1.0, 2.0).point;
        assert!((p - Vec3::new(-10.0, -2.005_88, 0.0)).norm() < 5e-6, "{p}");
        for (u, v, n) in [
            (0.0, 0.0, [-0.36515, -0.91287, 0.18257]),
            (1.0, 2.0, [0.37213, -0.92818, 0.0]),
            (0.0, 2.0, [0.36522, -0.91305, 0.18154]),
            (2.0, 1.0, [-0.99504, 0.0, -0.09950]),
        ] {
            let ours = s.at(u, v).normal().unwrap();
            assert!((ours - Vec3::from(n)).amax() < 1.1e-5, "{u} {v} {ours}");
        }
    }

    /// Surfaces SSPARB, SSPHER and SSADLE (XYPLAN) and SSCHK2 (YZPLAN) of TEST01: the printed normals, and the
    /// printed radii of the greatest and least curvature among the middles of the patches. SSV3 adds 1e-5 to
    /// a curvature before it takes the radius.
    #[test]
    fn printed_normals_and_curvatures_over_a_plane() {
        type Height = fn(f64, f64) -> f64;
        type Printed = [(f64, f64, [f64; 3]); 4];
        let parabola: Height = |x, y| 0.01 * (x * x + y * y);
        let sphere: Height = |x, y| (1e4 - x * x - y * y).sqrt() - 100.0;
        let saddle: Height = |x, y| 0.02 * (x * x - y * y);
        let all: [(Height, Printed, [f64; 2]); 3] = [
            (
                parabola,
                [
                    (0.0, 0.0, [-0.18982, 0.18999, -0.96326]),
                    (1.0, 0.0, [-0.09693, 0.19260, -0.97648]),
                    (3.0, 1.0, [0.09857, 0.06570, -0.99296]),
                    (4.0, 3.0, [0.18982, -0.18999, -0.96326]),
                ],
                [-54.199_94, -50.468_58],
            ),
            (
                sphere,
                [
                    (0.0, 0.0, [0.09947, -0.09943, -0.99006]),
                    (1.0, 1.0, [0.04995, -0.03334, -0.99820]),
                    (2.0, 2.0, [0.0, 0.03334, -0.99944]),
                    (4.0, 3.0, [-0.09947, 0.09943, -0.99006]),
                ],
                [99.780_04, 100.863_53],
            ),
            (
                saddle,
                [
                    (0.0, 0.0, [-0.33311, -0.33427, -0.88164]),
                    (1.0, 1.0, [-0.18928, -0.12597, -0.97381]),
                    (2.0, 0.0, [0.0, -0.35452, -0.93505]),
                    (4.0, 2.0, [0.35088, 0.12013, -0.92868]),
                ],
                [25.894_72, -26.129_34],
            ),
        ];
        let across = [10.0, 10.0 / 3.0, -10.0 / 3.0, -10.0];
        let along = [-10.0, -5.0, 0.0, 5.0, 10.0];
        for (z, printed, radii) in all {
            let at = |x: f64, y: f64| SplinePoint::plain(Vec3::new(x, y, z(x, y)));
            let r: Vec<Vec<_>> =
                across.iter().map(|&y| along.iter().map(|&x| at(x, y)).collect()).collect();
            let s = mesh(&r, MeshSpacing::Xyplan).unwrap();
            for (u, v, n) in printed {
                // The digits are cut off in places: up to one of the last.
                let ours = s.at(u, v).normal().unwrap();
                assert!((ours - Vec3::from(n)).amax() < 1.1e-5, "{u} {v} {ours} {n:?}");
            }
            let (mut most, mut least) = (f64::NEG_INFINITY, f64::INFINITY);
            for patch in &s.patches {
                let d = patch.at(0.5, 0.5);
                let [k1, k2] = d.curvatures(d.normal().unwrap()).unwrap();
                (most, least) = (most.max(k1), least.min(k2));
                // Seen along z the middle is that of the corners.
                let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
                let mean = corners.iter().map(|[a, b]| patch.point(*a, *b)).sum::<Vec3>() / 4.0;
                assert!((d.point - mean).xy().norm() < 1e-14);
            }
            for (k, radius) in [most, least].into_iter().zip(radii) {
                let ours = 1.0 / (k + 1e-5);
                assert!((ours - radius).abs() < 1e-5, "{ours} {radius}");
            }
        }
        let wall =
            |y: f64, z: f64| SplinePoint::plain(Vec3::new(-0.02 * y * y - 0.01 * z * z, y, z));
        let r: Vec<Vec<_>> =
            [-10.0, 0.0, 10.0].map(|y| [-10.0, 0.0, 10.0].map(|z| wall(y, z)).to_vec()).to_vec();
        let s = mesh(&r, MeshSpacing::Yzplan).unwrap();
        for (u, v, n) in [
            (0.0, 0.0, [-0.92199, 0.34242, 0.18082]),
            (1.0, 0.0, [-0.93744, 0.34816, 0.0]),
            (2.0, 1.0, [-0.98131, 0.0, -0.19245]),
            (2.0, 2.0, [-0.92199, -0.34242, -0.18082]),
        ] {
            let ours = s.at(u, v).normal().unwrap();
            assert!((ours - Vec3::from(n)).amax() < 1.1e-5, "{u} {v} {ours} {n:?}");
        }
        // The same seen along another axis: one rule for the three planes.
        let turned = |v: Vec3| Vec3::new(v.z, v.x, v.y);
        let moved: Vec<Vec<_>> = r
            .iter()
            .map(|row| row.iter().map(|p| SplinePoint::plain(turned(p.point))).collect())
            .collect();
        let t = mesh(&moved, MeshSpacing::Zxplan).unwrap();
        assert!((t.at(0.3, 1.6).point - turned(s.at(0.3, 1.6).point)).norm() < 1e-14);
    }

    /// Tangents across columns of uneven chords, as SSV3 gives them: each column has its own chords.
    #[test]
    fn columns_of_uneven_chords_keep_them() {
        let r = rows(&[
            [
                [-0.114798, -0.084757, 0.191832],
                [1.141447, 0.071584, 0.254471],
                [2.222867, 0.030811, 0.282864],
            ],
            [
                [0.085433, 1.254559, 0.162312],
                [1.019008, 1.203676, 0.292805],
                [2.303148, 1.248816, 0.388302],
            ],
            [
                [0.060165, 2.465285, 0.158457],
                [1.161788, 2.293737, 0.406451],
                [2.265578, 2.49088, 0.564607],
            ],
        ]);
        let s = mesh(&r, MeshSpacing::Xyz).unwrap();
        for (v, t) in [
            (0.0, [0.317_376_764, 1.316_134_104, -0.042_358_489]),
            (1.0, [0.071_416_772, 1.208_800_583, -0.014_545_621]),
            (2.0, [-0.120_337_269, 1.204_983_338, 0.006_698_944]),
        ] {
            assert!((s.at(0.0, v).v - Vec3::from(t)).norm() < 2e-9, "{v}");
        }
        let p = Vec3::new(0.540_498_034, 0.628_084_226, 0.224_226_037);
        assert!((s.at(0.5, 0.5).point - p).norm() < 2e-9);
    }

    /// Two rows without CRSSPL and NORMAL, as SSV3 gives them, and rows of two points: straight from one to the other.
    #[test]
    fn two_rows_are_ruled() {
        let a = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.2], [2.1, 0.1, 0.3]];
        let b = [[0.0, 1.0, 0.1], [1.3, 1.2, -0.1], [2.6, 1.5, 0.1]];
        let r = rows(&[a, b]);
        let s = mesh(&r, MeshSpacing::Xyz).unwrap();
        let p = Vec3::new(0.534_311_942, 0.263_536_957, 0.072_597_697);
        assert!((s.at(0.5, 0.25).point - p).norm() < 2e-9);
        let columns: Vec<Vec<SplinePoint>> = (0..3).map(|i| vec![r[0][i], r[1][i]]).collect();
        for m in [&r, &columns] {
            let s = mesh(m, MeshSpacing::Xyz).unwrap();
            let across = |t: f64| if m.len() == 2 { s.at(0.7, t) } else { s.at(t, 0.7) };
            let line = across(0.0).point.lerp(&across(1.0).point, 0.3);
            assert!((across(0.3).point - line).norm() < 1e-14);
        }
        // Over a plane the tangents along run evenly from row to row.
        let s = mesh(&r, MeshSpacing::Xyplan).unwrap();
        let slope = s.at(1.0, 0.0).u.lerp(&s.at(1.0, 1.0).u, 0.3);
        assert!((s.at(1.0, 0.3).u - slope).norm() < 1e-14);
        // A direction across takes the straightness away.
        let mut held = r.clone();
        held[0][1].cross = Some(Vec3::new(0.3, 1.0, 0.5));
        let s = mesh(&held, MeshSpacing::Xyz).unwrap();
        assert!(
            (s.at(1.0, 0.3).point - Vec3::from(a[1]).lerp(&Vec3::from(b[1]), 0.3)).norm() > 0.01
        );
    }

    #[test]
    fn uneven_rows_are_refused() {
        let mut r = rows(&[[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]; 2]);
        r[1].pop();
        assert_eq!(mesh(&r, MeshSpacing::Xyz).unwrap_err(), MeshFault::Uneven(1));
        assert_eq!(mesh(&r[..1], MeshSpacing::Xyz).unwrap_err(), MeshFault::TooFew);
    }
}
