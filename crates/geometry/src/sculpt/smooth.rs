//! WEIGHT and LIMIT: points relaxed into a smoother row.

use nalgebra::DMatrix;

use super::spline::SplinePoint;
use crate::Vec3;

/// Moves the points of weight below 1.
///
/// The moved points make `sum w/(1-w) |q - p|^2 + integral |f''|^2` least, f being the natural cubic over
/// the chords (closed when first and last point coincide); points of weight 1 stay. A point that would
/// move farther than its LIMIT is drawn back to it along its move. Weights outside 0 to 1 are held there;
/// 0 is taken for 1e-9, for a row without any hold has no place.
pub fn smooth(points: &mut [SplinePoint]) {
    let n = points.len();
    let moves = |p: &SplinePoint| p.weight.is_some_and(|w| w < 1.0);
    if n < 3 || !points.iter().any(moves) {
        return;
    }
    let chords: Vec<f64> = points.windows(2).map(|w| (w[1].point - w[0].point).norm()).collect();
    if chords.iter().any(|h| *h <= 0.0) {
        return;
    }
    let size: f64 = chords.iter().sum();
    let closed = (points[n - 1].point - points[0].point).norm() <= 1e-9 * size;
    let m = if closed { n - 1 } else { n };
    let Some(bending) = bending(&chords, closed) else { return };
    let free: Vec<usize> = (0..m).filter(|&i| moves(&points[i])).collect();
    let hold = |i: usize| {
        let w = points[i].weight.unwrap_or(1.0).clamp(1e-9, 1.0);
        w / (1.0 - w)
    };
    // The normal equations of the free points.
    let k = free.len();
    let a = DMatrix::from_fn(k, k, |r, c| {
        bending[(free[r], free[c])] + if r == c { hold(free[r]) } else { 0.0 }
    });
    let b = DMatrix::from_fn(k, 3, |r, c| {
        let i = free[r];
        let fixed = |j: &usize| !free.contains(j);
        let pull: f64 = (0..m).filter(fixed).map(|j| bending[(i, j)] * points[j].point[c]).sum();
        hold(i) * points[i].point[c] - pull
    });
    let Some(q) = a.lu().solve(&b) else { return };
    for (r, &i) in free.iter().enumerate() {
        let to = Vec3::new(q[(r, 0)], q[(r, 1)], q[(r, 2)]);
        points[i].point = limited(points[i].point, to, points[i].limit);
    }
    if closed {
        points[n - 1].point = points[0].point;
    }
}

fn limited(from: Vec3, to: Vec3, limit: Option<f64>) -> Vec3 {
    let step = to - from;
    match limit {
        Some(most) if step.norm() > most => from + step * (most / step.norm()),
        _ => to,
    }
}

/// The quadratic form of the integral of |f''|^2 over values at the joints.
fn bending(h: &[f64], closed: bool) -> Option<DMatrix<f64>> {
    let spans = h.len();
    let joints = if closed { spans } else { spans + 1 };
    let inner: Vec<usize> = if closed { (0..spans).collect() } else { (1..spans).collect() };
    let (mut q, mut r): (DMatrix<f64>, DMatrix<f64>) =
        (DMatrix::zeros(joints, inner.len()), DMatrix::zeros(inner.len(), inner.len()));
    for (c, &i) in inner.iter().enumerate() {
        let before = h[(i + spans - 1) % spans];
        let after = h[i % spans];
        q[((i + joints - 1) % joints, c)] += 1.0 / before;
        q[(i, c)] -= 1.0 / before + 1.0 / after;
        q[((i + 1) % joints, c)] += 1.0 / after;
        r[(c, c)] += (before + after) / 3.0;
        let next = if closed { (c + 1) % inner.len() } else { c + 1 };
        if next < inner.len() && next != c {
            r[(c, next)] += after / 6.0;
            r[(next, c)] += after / 6.0;
        }
    }
    let x = r.lu().solve(&q.transpose())?;
    Some(q * x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(weights: [Option<f64>; 5], limits: [Option<f64>; 5]) -> Vec<SplinePoint> {
        let y = |x: f64| 15.0 * (1.0 - x * x / 400.0).sqrt();
        [[0.0, y(0.0)], [5.0, y(5.0)], [10.0, y(10.0)], [15.0, 15.0], [20.0, 0.0]]
            .iter()
            .zip(weights)
            .zip(limits)
            .map(|((p, weight), limit)| SplinePoint {
                weight,
                limit,
                ..SplinePoint::plain(Vec3::new(p[0], p[1], 0.0))
            })
            .collect()
    }

    fn agrees(points: &[SplinePoint], printed: [[f64; 2]; 5]) {
        for (p, q) in points.iter().zip(printed) {
            assert!((p.point - Vec3::new(q[0], q[1], 0.0)).norm() < 1e-4, "{} {q:?}", p.point);
        }
    }

    /// Curves S3, S5 and S6 of TEST18.
    #[test]
    fn printed_points() {
        let w = Some(0.001);
        let mut all = row([w; 5], [None; 5]);
        smooth(&mut all);
        agrees(
            &all,
            [
                [1.3157, 16.3201],
                [5.2920, 14.9498],
                [9.2455, 13.3325],
                [12.9063, 11.2029],
                [21.2405, 1.7087],
            ],
        );
        let mut held = row([w, w, w, Some(1.0), w], [None; 5]);
        smooth(&mut held);
        agrees(
            &held,
            [
                [1.4648, 16.5905],
                [6.1620, 16.5276],
                [10.8250, 16.1970],
                [15.0, 15.0],
                [22.5106, 4.0120],
            ],
        );
        let l = Some(0.1);
        let mut limited = row([w, w, w, Some(1.0), w], [l, l, l, Some(1.0), l]);
        smooth(&mut limited);
        agrees(
            &limited,
            [
                [0.0677, 15.0736],
                [5.0502, 14.6102],
                [10.0249, 13.0872],
                [15.0, 15.0],
                [20.0530, 0.0848],
            ],
        );
    }

    /// The closed row of TEST14 with weight 0.5: all points move evenly inwards.
    #[test]
    fn a_closed_row_moves_evenly() {
        let at = |i: u32| {
            let a = f64::from(i % 9) * 40.0;
            Vec3::new(10.0 * crate::trig::cos_deg(a), 10.0 * crate::trig::sin_deg(a), 0.0)
        };
        let mut p: Vec<SplinePoint> = (0..10)
            .map(|i| SplinePoint { weight: Some(0.5), ..SplinePoint::plain(at(i)) })
            .collect();
        smooth(&mut p);
        for q in &p {
            assert!((q.point.norm() - 9.99259).abs() < 1e-4, "{}", q.point.norm());
        }
    }
}
