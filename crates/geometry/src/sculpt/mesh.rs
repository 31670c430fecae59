//! SMESH: a surface through rows of points.

use super::patch::Patch;
use super::smooth::smooth;
use super::spline::{SplineFault, SplinePoint, tangents};
use super::surface::{SculptFault, Sculptured};
use crate::Vec3;

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
/// Weights smooth the rows first. TANSPL holds the direction along a row, CRSSPL across, NORMAL both. Tangents
/// are as long as chords, twists are zero. With `ruled` the
/// lines across are straight.
pub fn mesh(rows: &[Vec<SplinePoint>], ruled: bool) -> Result<Sculptured, MeshFault> {
    let columns = rows.first().map_or(0, Vec::len);
    if rows.len() < 2 {
        return Err(MeshFault::TooFew);
    }
    if let Some(i) = rows.iter().position(|r| r.len() != columns) {
        return Err(MeshFault::Uneven(i));
    }
    let mut rows = rows.to_vec();
    for row in &mut rows {
        smooth(row);
    }
    let mut along = Vec::with_capacity(rows.len());
    for (i, row) in rows.iter().enumerate() {
        along.push(tangents(row).map_err(|f| MeshFault::Spline(i, f))?);
    }
    let across = columns_tangents(&rows, columns, ruled)?;
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
            let twist = |a: usize| if ruled { u(a, 1) - u(a, 0) } else { Vec3::zeros() };
            let row = |b: usize| [p(0, b), p(1, b), u(0, b), u(1, b)];
            let side = |b: usize| [v(0, b), v(1, b), twist(0), twist(1)];
            patches.push(Patch::hermite([row(0), row(1), side(0), side(1)]));
        }
    }
    Sculptured::grid(patches, columns - 1, rows.len() - 1).map_err(MeshFault::Surface)
}

/// Spans of one direction whose chords differ by more than this factor are not given one length. By the
/// printed surfaces of SSV3 it lies between 1.07 and 1.33.
const EVEN: f64 = 1.2;

/// Lengths of the tangents at both ends of each span of each line: `lengths[line][span]`.
///
/// Where the chords of every span are about equal over the lines, both are their mean. Else each line has
/// its own chord, at a joint the lesser of the two that meet.
fn lengths(lines: usize, points: usize, at: impl Fn(usize, usize) -> Vec3) -> Vec<Vec<[f64; 2]>> {
    let chord = |l: usize, k: usize| (at(l, k + 1) - at(l, k)).norm();
    let spans = points - 1;
    let range = |k: usize| {
        let all = (0..lines).map(|l| chord(l, k));
        all.fold((f64::INFINITY, 0.0_f64), |(lo, hi), c| (lo.min(c), hi.max(c)))
    };
    if (0..spans).all(|k| range(k).1 <= EVEN * range(k).0) {
        let mean = |k: usize| (0..lines).map(|l| chord(l, k)).sum::<f64>() / lines as f64;
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
    ruled: bool,
) -> Result<Vec<Vec<Vec3>>, MeshFault> {
    if ruled {
        return Ok(Vec::new());
    }
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
        let s = mesh(&r, false).unwrap();
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

    #[test]
    fn uneven_rows_are_refused() {
        let mut r = rows(&[[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]; 2]);
        r[1].pop();
        assert_eq!(mesh(&r, false).unwrap_err(), MeshFault::Uneven(1));
        assert_eq!(mesh(&r[..1], false).unwrap_err(), MeshFault::TooFew);
    }
}
