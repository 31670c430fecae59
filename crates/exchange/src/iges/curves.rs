//! Curves of IGES: circular and conic arcs (100, 104), composite curves (102), lines of points (106), lines (110), parametric
//! splines (112) and B-splines (126).

use core::f64::consts::TAU;

use aptc_geometry::sculpt::{flat, weighted};
use aptc_geometry::{Transform, Vec3, trig};

use super::{File, Numbers};
use crate::curve::{Chain, Curve};
use crate::{Fault, Limits};

/// Composite curves within each other.
const DEPTH: usize = 8;
/// Curves of a composite one, those of composite ones within it counted.
const PARTS: usize = 10_000;

/// A curve with the parameter that the file has for it.
#[derive(Clone, Debug)]
pub(super) struct Path {
    pub(super) curve: Curve,
    /// The file's parameter is the angle of an arc, which the curve's meets where its pieces do.
    pub(super) arc: bool,
    /// A single straight line.
    pub(super) straight: bool,
    /// A circle, or a part of one.
    pub(super) round: bool,
}

impl Path {
    fn plain(curve: Curve) -> Self {
        Self { curve, arc: false, straight: false, round: false }
    }

    /// The curve's parameter for one of the file's.
    pub(super) fn own(&self, t: f64) -> f64 {
        if self.arc { self.curve.at_angle(t) } else { t }
    }

    /// First and last place.
    pub(super) fn ends(&self) -> [Vec3; 2] {
        self.curve.range.map(|t| self.curve.at(t))
    }
}

/// The curves that make up the one of a directory line, each going on where the one before ends.
///
/// # Errors
/// The file is broken. `None`: a curve of a type that is not read.
pub(super) fn paths(
    file: &File<'_>,
    at: usize,
    limits: &Limits,
) -> Result<Option<Vec<Path>>, Fault> {
    let mut out = Vec::new();
    Ok(collect(file, at, limits, DEPTH, &mut out)?.then_some(out))
}

fn collect(
    file: &File<'_>,
    at: usize,
    limits: &Limits,
    depth: usize,
    out: &mut Vec<Path>,
) -> Result<bool, Fault> {
    let Some(e) = file.entries.get(&at) else { return Ok(false) };
    if depth == 0 || out.len() > PARTS {
        return Err(Fault::TooLarge(
            "composite curves (102) within each other, or too many".into(),
        ));
    }
    let mut p = Numbers::of(file, e)?;
    let map = file.map(e.matrix)?;
    if e.kind == 102 {
        let n = p.count(limits)?;
        // A matrix of the whole is applied to what its parts are.
        let from = out.len();
        for _ in 0..n {
            let part = p.pointer()?;
            if !collect(file, part, limits, depth - 1, out)? {
                return Ok(false);
            }
        }
        if let Some(m) = map {
            out[from..].iter_mut().for_each(|path| path.curve.carry(&m));
        }
        return Ok(true);
    }
    let path = match e.kind {
        100 => arc(p.take(7)?),
        104 => conic(p.take(11)?),
        106 => lines(&mut p, limits)?,
        110 => {
            let c = p.take(6)?;
            let [a, b] = [Vec3::new(c[0], c[1], c[2]), Vec3::new(c[3], c[4], c[5])];
            let straight = Path { straight: true, ..Path::plain(Curve::line(a, b)) };
            ((b - a).norm() > 0.0).then_some(straight)
        }
        112 => spline(&mut p, limits)?,
        126 => bspline(&mut p, limits)?,
        _ => None,
    };
    let Some(mut path) = path else { return Ok(false) };
    if let Some(m) = &map {
        path.curve.carry(m);
    }
    out.push(path);
    Ok(true)
}

/// Anticlockwise about the centre from one angle to the other; all round when both are the same.
fn turn(from: f64, to: f64) -> [f64; 2] {
    let from = if from < 0.0 { from + TAU } else { from };
    let mut to = if to < 0.0 { to + TAU } else { to };
    while to <= from + 1e-12 {
        to += TAU;
    }
    [from, to]
}

fn arc(c: &[f64]) -> Option<Path> {
    let center = Vec3::new(c[1], c[2], c[0]);
    let [start, end] = [(c[3], c[4]), (c[5], c[6])].map(|(x, y)| [x - c[1], y - c[2]]);
    let radius = trig::hypot(start[0], start[1]);
    let angles = turn(trig::atan2(start[1], start[0]), trig::atan2(end[1], end[0]));
    let curve = Curve::arc(center, Vec3::x() * radius, Vec3::y() * radius, angles);
    (radius > 0.0).then_some(Path { arc: true, round: true, ..Path::plain(curve) })
}

/// An ellipse about the origin, its half axes along x and y; parabolas and hyperbolas are not read.
fn conic(c: &[f64]) -> Option<Path> {
    let [a, b, k, d, e, f] = [c[0], c[1], c[2], c[3], c[4], c[5]];
    let size = a.abs().max(k.abs());
    if [b, d, e].iter().any(|x| x.abs() > 1e-9 * size) || a * k <= 0.0 || f * a >= 0.0 {
        return None;
    }
    let half = [(-f / a).sqrt(), (-f / k).sqrt()];
    let angle = |x: f64, y: f64| trig::atan2(y / half[1], x / half[0]);
    let angles = turn(angle(c[7], c[8]), angle(c[9], c[10]));
    let (x, y) = (Vec3::x() * half[0], Vec3::y() * half[1]);
    Some(Path { arc: true, ..Path::plain(Curve::arc(Vec3::z() * c[6], x, y, angles)) })
}

/// Lines from point to point, the first again at the end of a closed one (form 63).
fn lines(p: &mut Numbers, limits: &Limits) -> Result<Option<Path>, Fault> {
    let (kind, n) = (p.take(1)?[0], p.count(limits)?);
    let flat = (kind - 1.0).abs() < 0.5;
    let height = if flat { p.take(1)?[0] } else { 0.0 };
    let each = if flat { 2 } else { 3 };
    // Of triples with a vector each (kind 3) the points alone count.
    let skip = if kind > 2.5 { 3 } else { 0 };
    let mut points = Vec::with_capacity(n);
    for _ in 0..n {
        let c = p.take(each + skip)?;
        points.push(Vec3::new(c[0], c[1], if flat { height } else { c[2] }));
    }
    if p.form == 63 && points.first() != points.last() {
        points.extend(points.first().copied());
    }
    let curve = (11..=13).contains(&p.form) || p.form == 63;
    Ok(if curve { Curve::through(&points).map(Path::plain) } else { None })
}

/// Powers of the distance from each breakpoint, up to the third.
fn spline(p: &mut Numbers, limits: &Limits) -> Result<Option<Path>, Fault> {
    let _kind = p.take(3)?;
    let n = p.count(limits)?;
    let breaks = p.take(n + 1)?.to_vec();
    if n == 0 || !breaks.windows(2).all(|w| w[1] > w[0]) {
        return Ok(None);
    }
    let mut points = Vec::with_capacity(3 * n + 1);
    for w in breaks.windows(2) {
        let c = p.take(12)?;
        let h = w[1] - w[0];
        let power = |k: usize| {
            let scale = [1.0, h, h * h, h * h * h][k];
            Vec3::new(c[k], c[4 + k], c[8 + k]) * scale
        };
        let (a, b, q, d) = (power(0), power(1), power(2), power(3));
        let own = [a, a + b / 3.0, a + (b * 2.0 + q) / 3.0, a + b + q + d];
        let skip = usize::from(!points.is_empty());
        points.extend(own[skip..].iter().map(|p| weighted(*p, 1.0)));
    }
    Ok(Some(Path::plain(Chain::of(3, breaks, points).curve())))
}

fn bspline(p: &mut Numbers, limits: &Limits) -> Result<Option<Path>, Fault> {
    let (upper, degree) = (p.count(limits)?, p.count(limits)?);
    let _flags = p.take(4)?;
    let n = upper + 1;
    let knots = p.take(n.saturating_add(degree).saturating_add(1))?.to_vec();
    let weights = p.take(n)?.to_vec();
    let points = p.take(3 * n)?.chunks_exact(3).zip(weights);
    let points: Vec<_> = points.map(|(q, w)| [q[0], q[1], q[2], w]).collect();
    let r = p.take(2)?;
    let range = (r[1] > r[0]).then_some([r[0], r[1]]);
    Ok(Curve::new(degree, knots, &points, range)
        .map(|curve| Path { straight: degree == 1 && n == 2, ..Path::plain(curve) }))
}

impl Curve {
    /// Carried by a map.
    pub(super) fn carry(&mut self, m: &Transform) {
        self.points.iter_mut().for_each(|h| *h = weighted(m.point(flat(*h)), h.w));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The place at the file's parameter of an arc is that at its angle, also within a piece.
    #[test]
    fn angles_of_arcs() {
        for (from, to) in [(0.3, 1.2), (-0.4, 4.0), (1.0, 1.0)] {
            let at = |a: f64| (2.0 + 5.0 * trig::cos(a), 1.0 + 5.0 * trig::sin(a));
            let ((x, y), (z, w)) = (at(from), at(to));
            let path = arc(&[7.0, 2.0, 1.0, x, y, z, w]).unwrap();
            let [first, last] = turn(from, to);
            for k in 0..=20 {
                let a = first + (last - first) * f64::from(k) / 20.0;
                let p = path.curve.at(path.own(a));
                assert!((p - Vec3::new(at(a).0, at(a).1, 7.0)).norm() < 1e-13, "{a} {p}");
            }
        }
        // x^2 / 9 + y^2 / 4 = 1, a quarter; a hyperbola is none.
        let c = [4.0, 0.0, 9.0, 0.0, 0.0, -36.0, 1.0, 3.0, 0.0, 0.0, 2.0];
        let quarter = conic(&c).unwrap();
        let [a, b] = quarter.ends();
        assert!((a - Vec3::new(3.0, 0.0, 1.0)).norm() < 1e-14);
        assert!((b - Vec3::new(0.0, 2.0, 1.0)).norm() < 1e-14);
        assert!(conic(&[4.0, 0.0, -9.0, 0.0, 0.0, -36.0, 1.0, 3.0, 0.0, 3.0, 0.0]).is_none());
    }
}
