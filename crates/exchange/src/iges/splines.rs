//! Surfaces of two parameters as IGES writes them: B-splines (128) and parametric splines (114).

use aptc_geometry::sculptured::{BsplineSurface, SurfaceShape};

use super::Numbers;
use crate::{Fault, Limits};

/// Type 128.
pub(super) fn bspline(mut p: Numbers, limits: &Limits) -> Result<BsplineSurface, Fault> {
    let mut upper = [0; 4];
    for u in &mut upper {
        *u = p.count(limits)?;
    }
    let [k1, k2, m1, m2] = upper;
    let _flags = p.take(5)?;
    let counts = [k1 + 1, k2 + 1];
    let degree = [m1, m2];
    let mut knots = [Vec::new(), Vec::new()];
    for k in 0..2 {
        knots[k] = p.take(counts[k] + degree[k] + 1)?.to_vec();
    }
    let n = counts[0].checked_mul(counts[1]).filter(|n| *n <= limits.points);
    let n = n.ok_or_else(|| Fault::TooLarge(format!("more than {} points", limits.points)))?;
    let weights = p.take(n)?.to_vec();
    let points = p.take(3 * n)?.chunks_exact(3).zip(weights).map(|(q, w)| [q[0], q[1], q[2], w]);
    let points = points.collect();
    let r = p.take(4)?;
    let range = [Some([r[0], r[1]]), Some([r[2], r[3]])];
    Ok(BsplineSurface { degree, knots, counts, points, range })
}

/// The patches of type 114.
pub(super) struct Cells {
    /// Patches along u and along v.
    counts: [usize; 2],
    breaks: [Vec<f64>; 2],
    /// Control points with weights of 1, 16 a patch.
    pub(super) net: Vec<f64>,
}

impl Cells {
    /// The patches each on its own.
    pub(super) fn shape(self) -> SurfaceShape {
        let [m, n] = self.counts;
        #[expect(clippy::cast_precision_loss, reason = "counts within the limits")]
        let mut words = vec![m as f64, n as f64, (m * n) as f64];
        words.extend(self.net);
        SurfaceShape::Canonical(words)
    }
}

/// The patches as a B-spline surface of the breakpoints; `None` where they do not join within the digits that files have.
pub(super) fn joined(cells: &Cells) -> Option<BsplineSurface> {
    const DIGITS: f64 = 1e-7;
    let [m, n] = cells.counts;
    let counts = [3 * m + 1, 3 * n + 1];
    let size = cells.net.iter().fold(0.0_f64, |s, x| s.max(x.abs()));
    let mut points = vec![[f64::NAN; 4]; counts[0] * counts[1]];
    for (k, cell) in cells.net.chunks_exact(64).enumerate() {
        let (i, j) = (k % m, k / m);
        for (at, q) in cell.chunks_exact(4).enumerate() {
            let (column, row) = (3 * i + at % 4, 3 * j + at / 4);
            let own = &mut points[row * counts[0] + column];
            let q = [q[0], q[1], q[2], q[3]];
            if own.iter().zip(q).any(|(a, b)| (a - b).abs() > DIGITS * size) {
                return None;
            }
            *own = q;
        }
    }
    let knots = [0, 1].map(|k| {
        let b = &cells.breaks[k];
        let times = |i: usize| 3 + usize::from(i == 0 || i + 1 == b.len());
        b.iter().enumerate().flat_map(|(i, t)| std::iter::repeat_n(*t, times(i))).collect()
    });
    Some(BsplineSurface { degree: [3; 2], knots, counts, points, range: [None; 2] })
}

/// Type 114: powers of the distance from each patch's corner, up to the third.
pub(super) fn cells(mut p: Numbers, limits: &Limits) -> Result<Cells, Fault> {
    let _kind = p.take(2)?;
    let (m, n) = (p.count(limits)?, p.count(limits)?);
    let line = p.line;
    let rising = |b: &[f64]| {
        let up = b.windows(2).all(|w| w[1] > w[0]);
        let what = "the breakpoints of a spline surface do not rise".to_owned();
        if up { Ok(b.to_vec()) } else { Err(Fault::Broken { what, line: Some(line) }) }
    };
    let (tu, tv) = (rising(p.take(m + 1)?)?, rising(p.take(n + 1)?)?);
    let cells = m.checked_mul(n).filter(|c| *c > 0 && 16 * c <= limits.points);
    let cells = cells.ok_or_else(|| Fault::TooLarge("no patches, or too many".into()))?;
    // Row after row along v for each place along u, behind each row one that means nothing.
    let mut net = vec![0.0; 64 * cells];
    for i in 0..m {
        for j in 0..n {
            let c = p.take(48)?;
            let (du, dv) = (tu[i + 1] - tu[i], tv[j + 1] - tv[j]);
            let cell = &mut net[64 * (j * m + i)..][..64];
            for axis in 0..3 {
                let power = |a: usize, b: usize| {
                    let scale =
                        [1.0, du, du * du, du * du * du][a] * [1.0, dv, dv * dv, dv * dv * dv][b];
                    c[16 * axis + 4 * b + a] * scale
                };
                for row in 0..4 {
                    for column in 0..4 {
                        cell[4 * (4 * row + column) + axis] = bezier(column, row, power);
                    }
                }
            }
            (0..16).for_each(|k| cell[4 * k + 3] = 1.0);
        }
        p.take(48)?;
    }
    Ok(Cells { counts: [m, n], breaks: [tu, tv], net })
}

/// The control point (i, j) of a bicubic whose coefficients of u^a v^b are given.
fn bezier(i: usize, j: usize, power: impl Fn(usize, usize) -> f64) -> f64 {
    // Shares of the powers in the control points: C(i, a) / C(3, a).
    const SHARE: [[f64; 4]; 4] = [
        [1.0, 0.0, 0.0, 0.0],
        [1.0, 1.0 / 3.0, 0.0, 0.0],
        [1.0, 2.0 / 3.0, 1.0 / 3.0, 0.0],
        [1.0, 1.0, 1.0, 1.0],
    ];
    let mut sum = 0.0;
    for (a, along) in SHARE[i].iter().enumerate() {
        for (b, across) in SHARE[j].iter().enumerate() {
            sum += along * across * power(a, b);
        }
    }
    sum
}
