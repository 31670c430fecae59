//! SPLINE: tangents through given points.

use nalgebra::DMatrix;

use super::arc::CubicArc;
use crate::Vec3;

/// A point of a spline with what is demanded there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SplinePoint {
    /// The point.
    pub point: Vec3,
    /// TANSPL: direction of the curve.
    pub tangent: Option<Vec3>,
    /// NORMAL: the curve is square to it.
    pub normal: Option<Vec3>,
    /// CRSSPL: direction across the curve.
    pub cross: Option<Vec3>,
    /// WEIGHT: 1 holds the point.
    pub weight: Option<f64>,
    /// LIMIT: how far smoothing may move the point.
    pub limit: Option<f64>,
}

impl SplinePoint {
    /// A point without demands.
    pub fn plain(point: Vec3) -> Self {
        Self { point, ..Self::default() }
    }
}

/// Why points make no spline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SplineFault {
    /// Fewer than two points.
    TooFew,
    /// The vector at this point (counted from 0) has length zero, or a normal leaves no tangent.
    NoDirection(usize),
}

/// Unit tangents of the twice differentiable cubic over the chords of `points`.
///
/// A tangent that is given splits the spline there, and is turned round where it points against the chord of the neighbours. A free end
/// takes the direction of the parabola through three points whose middle parameter is the middle point's place along the chord
/// of the outer two; beside a given tangent, or beside one chord, the mirror of the other end's tangent, and the chord itself when
/// both ends are free. A normal holds the tangent there of that parabola, at an end the chord, or the given tangent, laid square to
/// itself. Points that close on themselves are run through without a joint. Null spans take the direction
/// of their neighbours.
pub fn tangents(points: &[SplinePoint]) -> Result<Vec<Vec3>, SplineFault> {
    let n = points.len();
    if n < 2 {
        return Err(SplineFault::TooFew);
    }
    let mut fixed = vec![None; n];
    for (i, p) in points.iter().enumerate() {
        let normal = p.normal.and_then(|n| n.try_normalize(0.0));
        if p.normal.is_some() && normal.is_none() {
            return Err(SplineFault::NoDirection(i));
        }
        let at = |k: usize| points[k].point;
        let chord = at((i + 1).min(n - 1)) - at(i.saturating_sub(1));
        let inside = i > 0 && i + 1 < n;
        let free = || match inside {
            true => parabola([at(i - 1), at(i), at(i + 1)], 1),
            false => chord,
        };
        let given = p.tangent.map(|t| if t.dot(&chord) < 0.0 { -t } else { t });
        let Some(t) = given.or_else(|| normal.map(|_| free())) else { continue };
        // Where a normal is given too, the normal has the last word.
        let t = normal.map_or(t, |n| t - n * n.dot(&t));
        fixed[i] = Some(t.try_normalize(0.0).ok_or(SplineFault::NoDirection(i))?);
    }
    // A normal beside an end does not hold the end.
    let at = |k: usize| points[k].point;
    let by_normal = |k: usize| n > 2 && fixed[k].is_some() && points[k].tangent.is_none();
    let ends = [
        (fixed[0].is_none() && by_normal(1.min(n - 1))).then(|| parabola([at(0), at(1), at(2)], 0)),
        (fixed[n - 1].is_none() && by_normal(n - 2))
            .then(|| parabola([at(n - 3), at(n - 2), at(n - 1)], 2)),
    ];
    fixed[0] = fixed[0].or(ends[0]);
    fixed[n - 1] = fixed[n - 1].or(ends[1]);
    let mut all = vec![Vec3::zeros(); n];
    let mut from = 0;
    if fixed.iter().all(Option::is_none) {
        let at: Vec<Vec3> = points.iter().map(|p| p.point).collect();
        if let Some(t) = closed(&at) {
            return Ok(t);
        }
    }
    for to in 1..n {
        if to == n - 1 || fixed[to].is_some() {
            let at: Vec<Vec3> = points[from..=to].iter().map(|p| p.point).collect();
            let piece = piece(&at, fixed[from], fixed[to]);
            for (k, t) in piece.into_iter().enumerate() {
                all[from + k] = t;
            }
            from = to;
        }
    }
    Ok(all)
}

/// Tangents of a piece whose inner points are free.
fn piece(p: &[Vec3], first: Option<Vec3>, last: Option<Vec3>) -> Vec<Vec3> {
    let distinct = distinct(p);
    let q: Vec<Vec3> = distinct.iter().map(|&i| p[i]).collect();
    let t = distinct_piece(&q, first, last);
    let mut all = vec![Vec3::zeros(); p.len()];
    let mut k = 0;
    for (i, slot) in all.iter_mut().enumerate() {
        if k + 1 < distinct.len() && i >= distinct[k + 1] {
            k += 1;
        }
        *slot = t[k];
    }
    all
}

/// Tangents of points that close on themselves; `None` when they do not, or stand still somewhere.
fn closed(p: &[Vec3]) -> Option<Vec<Vec3>> {
    let m = p.len() - 1;
    let h: Vec<f64> = p.windows(2).map(|w| (w[1] - w[0]).norm()).collect();
    let size: f64 = h.iter().sum();
    if m < 3 || (p[m] - p[0]).norm() > 1e-9 * size || h.iter().any(|h| *h <= 1e-12 * size) {
        return None;
    }
    let mut a: DMatrix<f64> = DMatrix::zeros(m, m);
    let mut b: DMatrix<f64> = DMatrix::zeros(m, 3);
    for i in 0..m {
        let before = (i + m - 1) % m;
        let (l, r) = (1.0 / h[before], 1.0 / h[i]);
        a[(i, before)] += l;
        a[(i, i)] += 2.0 * (l + r);
        a[(i, (i + 1) % m)] += r;
        let rhs = ((p[i] - p[before]) * (l * l) + (p[i + 1] - p[i]) * (r * r)) * 3.0;
        b.set_row(i, &rhs.transpose());
    }
    let t = a.lu().solve(&b)?;
    let of = |i: usize| Vec3::new(t[(i, 0)], t[(i, 1)], t[(i, 2)]).try_normalize(0.0);
    (0..=m).map(|i| of(i % m)).collect()
}

/// Indices of points that differ from the one before.
fn distinct(p: &[Vec3]) -> Vec<usize> {
    let size = p.iter().map(|q| (q - p[0]).norm()).fold(0.0, f64::max);
    let mut keep = vec![0];
    for i in 1..p.len() {
        if (p[i] - p[keep[keep.len() - 1]]).norm() > 1e-12 * size {
            keep.push(i);
        }
    }
    keep
}

fn distinct_piece(p: &[Vec3], first: Option<Vec3>, last: Option<Vec3>) -> Vec<Vec3> {
    let n = p.len();
    if n == 1 {
        return vec![first.or(last).unwrap_or_else(Vec3::zeros)];
    }
    let along = |a: Vec3, b: Vec3| (b - a).try_normalize(0.0).unwrap_or_else(Vec3::zeros);
    if n == 2 {
        let c = along(p[0], p[1]);
        let mirrored = |t: Vec3| c * (2.0 * c.dot(&t)) - t;
        let a = first.or_else(|| last.map(mirrored)).unwrap_or(c);
        let b = last.or_else(|| first.map(mirrored)).unwrap_or(c);
        return vec![a, b];
    }
    let a = first.unwrap_or_else(|| parabola([p[0], p[1], p[2]], 0));
    let b = last.unwrap_or_else(|| parabola([p[n - 3], p[n - 2], p[n - 1]], 2));
    inner(p, a, b)
}

/// Direction of the parabola through three points at the one of the number `k`.
fn parabola([p0, p1, p2]: [Vec3; 3], k: usize) -> Vec3 {
    let (whole, step) = (p2 - p0, p1 - p0);
    let square = whole.norm_squared();
    let t = if square > 0.0 { step.dot(&whole) / square } else { 0.0 };
    // Outside this range the points turn back on themselves and chords tell more.
    let t = if (0.01..=0.99).contains(&t) {
        t
    } else {
        let (a, b) = (step.norm(), (p2 - p1).norm());
        a / (a + b)
    };
    let first = (step - whole * (t * t)) / (t - t * t);
    let along = first + (whole - first) * (2.0 * [0.0, t, 1.0][k]);
    along.try_normalize(0.0).unwrap_or_else(Vec3::zeros)
}

/// The system of a twice differentiable cubic over chords with unit tangents at both ends.
fn inner(p: &[Vec3], a: Vec3, b: Vec3) -> Vec<Vec3> {
    let n = p.len();
    let h: Vec<f64> = p.windows(2).map(|w| (w[1] - w[0]).norm()).collect();
    let mut upper = vec![0.0; n];
    let mut t = vec![Vec3::zeros(); n];
    (t[0], t[n - 1]) = (a, b);
    for i in 1..n - 1 {
        let (l, r) = (1.0 / h[i - 1], 1.0 / h[i]);
        let rhs = ((p[i] - p[i - 1]) * (l * l) + (p[i + 1] - p[i]) * (r * r)) * 3.0;
        let pivot = 2.0 * (l + r) - l * upper[i - 1];
        upper[i] = r / pivot;
        t[i] = (rhs - t[i - 1] * l) / pivot;
    }
    for i in (1..n - 1).rev() {
        let next = t[i + 1];
        t[i] -= next * upper[i];
    }
    t.into_iter().map(|v| v.try_normalize(0.0).unwrap_or_else(Vec3::zeros)).collect()
}

/// SCURV/SPLINE: arcs through the points, each with the tangent lengths of least bending energy.
pub fn spline(points: &[SplinePoint]) -> Result<Vec<CubicArc>, SplineFault> {
    let t = tangents(points)?;
    Ok((1..points.len())
        .map(|i| {
            let (p, q) = (points[i - 1].point, points[i].point);
            let (a, b) = least_bending(q - p, t[i - 1], t[i]);
            CubicArc::hermite(p, q, t[i - 1] * a, t[i] * b)
        })
        .collect())
}

/// Lengths of the tangents along the unit vectors `t0` and `t1` over the chord `d` that make the integral
/// of the squared second derivative least.
fn least_bending(d: Vec3, t0: Vec3, t1: Vec3) -> (f64, f64) {
    let c = t0.dot(&t1);
    let (x, y) = (3.0 * d.dot(&t0), 3.0 * d.dot(&t1));
    let det = 4.0 - c * c;
    let m = [(2.0 * x - c * y) / det, (2.0 * y - c * x) / det];
    let chord = d.norm();
    // A tangent that would run backwards or vanish takes a tenth of the chord.
    let held = |v: f64| if v > 0.1 * chord { v } else { 0.1 * chord };
    (held(m[0]), held(m[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(p: &[[f64; 3]]) -> Vec<SplinePoint> {
        p.iter().map(|p| SplinePoint::plain(Vec3::from(*p))).collect()
    }

    /// First row of the mesh of the traces tr1 to tr3 of the SSV3 oracle, unit tangents to all digits.
    #[test]
    fn tangents_of_a_traced_mesh() {
        let t = tangents(&plain(&[
            [0.0, 0.0, 0.095],
            [1.5, 0.0, 0.183],
            [3.0, 0.0, -0.214],
            [4.5, 0.0, -0.045],
        ]))
        .unwrap();
        let slopes = [
            0.308_747_208_031_225_7 / 1.469_521_477_767_115_3,
            -0.245_982_849_225_643_9 / 1.481_320_576_368_517_5,
            -0.207_662_410_348_519_87 / 1.518_597_728_765_725_5,
            0.420_716_666_045_863_55 / 1.446_033_401_400_176,
        ];
        for (v, slope) in t.iter().zip(slopes) {
            assert!((v.z / v.x - slope).abs() < 1e-14, "{v} {slope}");
            assert!((v.norm() - 1.0).abs() < 1e-15);
        }
    }

    /// Curve C2 of TEST44: an S with both tangents square to its middle.
    #[test]
    fn arcs_of_least_bending() {
        let mut p = plain(&[[1.0, 0.0, 2.0], [0.0, 1.0, 2.0]]);
        p[0].tangent = Some(Vec3::y());
        p[1].tangent = Some(Vec3::y());
        let arcs = spline(&p).unwrap();
        let a = arcs[0].at(0.0);
        assert!((a.first - Vec3::y()).norm() < 1e-15);
    }

    /// Tangent of curve SCV of TEST39 in the middle of its first arc, to the six printed digits.
    #[test]
    fn printed_tangent() {
        let arcs = spline(&plain(&[[0.0, 3.0, 0.0], [7.0, 5.0, 1.2], [12.0, 6.0, 0.0]])).unwrap();
        let t = arcs[0].at(0.5).first;
        assert!((t - Vec3::new(7.057_423, 2.021_167, 1.232_694)).norm() < 1e-6, "{t}");
        let p = arcs[0].at(0.55).point;
        assert!((p - Vec3::new(3.776_449, 4.166_338, 1.066_683)).norm() < 1e-6, "{p}");
    }

    #[test]
    fn a_closed_row_has_no_joint() {
        let at = |i: u32| {
            let a = f64::from(i % 9) * 40.0;
            [crate::trig::cos_deg(a), crate::trig::sin_deg(a), 0.0]
        };
        let p = plain(&(0..10).map(at).collect::<Vec<_>>());
        for (p, t) in p.iter().zip(tangents(&p).unwrap()) {
            assert!((Vec3::z().cross(&p.point) - t).norm() < 1e-12);
        }
    }

    /// A normal at a point inside, beside the first: two points of the curve as SSV3 gives them.
    #[test]
    fn a_normal_holds_the_tangent_of_the_parabola() {
        let mut p = plain(&[[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [3.0, 2.0, 0.0], [2.0, 3.0, 1.0]]);
        p[1].normal = Some(Vec3::new(-0.2, 0.9, 0.3));
        let arcs = spline(&p).unwrap();
        for (arc, q) in [
            (0, [0.487_549_081, 0.623_271_964, 0.020_240_876]),
            (1, [2.352_297_925, 1.471_342_124, -0.133_184_162]),
        ] {
            assert!((arcs[arc].at(0.5).point - Vec3::from(q)).norm() < 2e-9, "{arc}");
        }
    }

    #[test]
    fn a_tangent_against_the_chord_is_turned_round() {
        let mut p = plain(&[[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [3.0, 2.0, 0.0]]);
        p[1].tangent = Some(-Vec3::x());
        let arcs = spline(&p).unwrap();
        assert!((arcs[0].at(0.5).point - Vec3::new(0.3125, 0.6875, 0.0)).norm() < 1e-12);
        assert!(arcs[0].at(1.0).first.x > 0.0);
    }

    #[test]
    fn one_tangent_over_one_chord_is_mirrored() {
        let mut p = plain(&[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
        p[0].tangent = Some(Vec3::new(3.0, 3.0, 0.0));
        let t = tangents(&p).unwrap();
        assert!((t[1] - Vec3::new(1.0, -1.0, 0.0).normalize()).norm() < 1e-15);
        assert_eq!(tangents(&p[..1]), Err(SplineFault::TooFew));
    }
}
