//! B-spline surfaces as patches: exact up to degree three, above it within a stated share of their size.

use super::arc::{CubicArc, Vec4};
use super::patch::Patch;
use super::surface::{Layout, SculptFault, Sculptured};
use crate::Vec3;
use crate::sculptured::BsplineSurface;

/// Highest degree: beyond it blossoms lose digits, and nobody uses it.
pub const MAX_DEGREE: usize = 15;
/// Patches of one surface.
const MAX_PATCHES: usize = 250_000;
/// Share of the surface's size by which cubic patches may leave a surface of higher degree.
const REDUCED: f64 = 1e-6;
/// Pieces of a span of higher degree, at most.
const PIECES: usize = 64;

/// Greatest coordinate: its fourth power, as curvatures take it, is a number.
const FARTHEST: f64 = 1e75;

/// Why a B-spline surface is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BsplineFault {
    /// A degree of 0 or above [`MAX_DEGREE`].
    Degree,
    /// The number of knots is not that of control points plus degree plus one.
    KnotCount,
    /// Knots fall, are not finite, or leave no span.
    Knots,
    /// The number of control points is not the product of both counts.
    PointCount,
    /// A control point is not finite, or a weight is not positive.
    Points,
    /// A control point so far off that products of lengths there are no numbers.
    Far,
    /// More patches than a bound, or a degree that cubic patches do not follow.
    TooMany,
    /// The patches make no surface.
    Surface(SculptFault),
}

impl core::fmt::Display for BsplineFault {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Degree => write!(f, "its degree is not between 1 and {MAX_DEGREE}"),
            Self::KnotCount => f.write_str(
                "the number of its knots is not that of its control points plus the degree plus one",
            ),
            Self::Knots => f.write_str("its knots do not rise from span to span"),
            Self::PointCount => {
                f.write_str("the number of its control points is not that of a grid")
            }
            Self::Points => {
                f.write_str("a control point is not finite, or a weight is not above zero")
            }
            Self::Far => write!(f, "a control point is farther off than {FARTHEST:e}"),
            Self::TooMany => write!(f, "it has more than {MAX_PATCHES} cubic patches"),
            Self::Surface(_) => f.write_str("its patches make no surface"),
        }
    }
}

/// The control net of a piece of any degree; rows run along u.
type Net = Vec<Vec<Vec4>>;

/// One of the two directions.
struct Direction<'a> {
    degree: usize,
    knots: &'a [f64],
    /// Borders of the spans within the range, and the knot interval of each span.
    borders: Vec<f64>,
    spans: Vec<usize>,
}

/// The patches of a B-spline surface, and by how much they may leave it (0 up to degree three). Spans between
/// different knots count as spans of the surface.
///
/// Spans come from blossoms (de Boor's algorithm with an argument for each step), so that knots of any
/// multiplicity, also such that are not clamped, are exact.
pub fn bspline(s: &BsplineSurface) -> Result<(Sculptured, f64), BsplineFault> {
    let [u, v] = [direction(s, 0)?, direction(s, 1)?];
    let [nu, nv] = s.counts;
    if nu.checked_mul(nv) != Some(s.points.len()) {
        return Err(BsplineFault::PointCount);
    }
    if !s.points.iter().all(|p| p.iter().all(|x| x.is_finite()) && p[3] > 0.0) {
        return Err(BsplineFault::Points);
    }
    if s.points.iter().flat_map(|p| &p[..3]).any(|x| x.abs() > FARTHEST) {
        return Err(BsplineFault::Far);
    }
    let h: Vec<Vec4> =
        s.points.iter().map(|p| super::arc::weighted(Vec3::new(p[0], p[1], p[2]), p[3])).collect();
    let size = s.points.iter().map(|p| Vec3::new(p[0], p[1], p[2]).norm()).fold(0.0, f64::max);
    let (columns, rows) = (u.spans.len(), v.spans.len());
    if columns.saturating_mul(rows) > MAX_PATCHES {
        return Err(BsplineFault::TooMany);
    }
    // Along u first, then across: each span of both is a net of its own degree.
    let mut along: Vec<Vec<Vec<Vec4>>> = Vec::with_capacity(nv);
    for j in 0..nv {
        let row = &h[j * nu..(j + 1) * nu];
        along.push((0..columns).map(|k| u.piece(row, k)).collect());
    }
    let mut nets: Vec<Net> = Vec::with_capacity(columns * rows);
    for l in 0..rows {
        for k in 0..columns {
            let across: Vec<Vec<Vec4>> = (0..=u.degree)
                .map(|i| {
                    let column: Vec<Vec4> = along.iter().map(|row| row[k][i]).collect();
                    v.piece(&column, l)
                })
                .collect();
            nets.push((0..=v.degree).map(|j| across.iter().map(|c| c[j]).collect()).collect());
        }
    }
    let cut = |degree: usize, m: usize| if degree > 3 { m } else { 1 };
    let mut m = 1;
    loop {
        let (mu, mv) = (cut(u.degree, m), cut(v.degree, m));
        if (columns * mu).saturating_mul(rows * mv) > MAX_PATCHES || m > PIECES {
            return Err(BsplineFault::TooMany);
        }
        let (patches, off) = reduced(&nets, columns, [mu, mv]);
        if off <= REDUCED * size {
            let layout = Layout::Mesh { u: knots(columns, mu), v: knots(rows, mv) };
            let surface = Sculptured::checked(patches, layout).map_err(BsplineFault::Surface)?;
            return Ok((surface, off));
        }
        m *= 2;
    }
}

/// Borders of the patches: whole numbers between spans.
fn knots(spans: usize, m: usize) -> Vec<f64> {
    (0..=spans * m).map(|k| k as f64 / m as f64).collect()
}

fn direction(s: &BsplineSurface, k: usize) -> Result<Direction<'_>, BsplineFault> {
    let (degree, knots, n) = (s.degree[k], s.knots[k].as_slice(), s.counts[k]);
    if degree == 0 || degree > MAX_DEGREE {
        return Err(BsplineFault::Degree);
    }
    if n <= degree || Some(knots.len()) != n.checked_add(degree + 1) {
        return Err(BsplineFault::KnotCount);
    }
    if !knots.iter().all(|t| t.is_finite()) || knots.windows(2).any(|w| w[1] < w[0]) {
        return Err(BsplineFault::Knots);
    }
    let whole = [knots[degree], knots[n]];
    let [from, to] = s.range[k].map_or(whole, |r| [r[0].max(whole[0]), r[1].min(whole[1])]);
    let tiny = 1e-9 * (whole[1] - whole[0]);
    let (mut borders, mut spans) = (Vec::new(), Vec::new());
    for i in degree..n {
        let (a, b) = (knots[i].max(from), knots[i + 1].min(to));
        // Differences of rounding are one knot.
        if b - a > tiny {
            borders.push(a);
            spans.push(i);
        }
    }
    if spans.is_empty() {
        return Err(BsplineFault::Knots);
    }
    borders.push(to);
    Ok(Direction { degree, knots, borders, spans })
}

impl Direction<'_> {
    /// Bezier points of the k-th span of a curve with these control points.
    fn piece(&self, points: &[Vec4], k: usize) -> Vec<Vec4> {
        let (a, b) = (self.borders[k], self.borders[k + 1]);
        (0..=self.degree).map(|i| self.blossom(points, self.spans[k], a, b, i)).collect()
    }

    /// The blossom of the interval at `degree - i` times `a` and `i` times `b`.
    fn blossom(&self, points: &[Vec4], interval: usize, a: f64, b: f64, i: usize) -> Vec4 {
        blossom(self.degree, self.knots, points, interval, |r| if r < i { b } else { a })
    }
}

/// The blossom of a B-spline curve within the interval of its knots from the given index on: de Boor's algorithm with an
/// argument for each of its steps, counted from 0. With the same argument everywhere it is the curve's place.
///
/// `degree` is [`MAX_DEGREE`] at most, and the interval between `degree` and the last of the points and not empty.
pub fn blossom(
    degree: usize,
    knots: &[f64],
    points: &[Vec4],
    interval: usize,
    argument: impl Fn(usize) -> f64,
) -> Vec4 {
    let p = degree;
    let mut d = [Vec4::zeros(); MAX_DEGREE + 1];
    d[..=p].copy_from_slice(&points[interval - p..=interval]);
    for r in 1..=p {
        let t = argument(r - 1);
        for j in (r..=p).rev() {
            let (lo, hi) = (knots[interval - p + j], knots[interval + 1 + j - r]);
            let share = (t - lo) / (hi - lo);
            d[j] = d[j - 1] * (1.0 - share) + d[j] * share;
        }
    }
    d[p]
}

/// Cubic patches of all nets, each cut in `m[0]` by `m[1]`, row after row, and a bound of what they are off.
fn reduced(nets: &[Net], columns: usize, m: [usize; 2]) -> (Vec<Patch>, f64) {
    let rows = nets.len() / columns;
    let mut patches = Vec::with_capacity(nets.len() * m[0] * m[1]);
    let mut off = 0.0_f64;
    for j in 0..rows * m[1] {
        for i in 0..columns * m[0] {
            let net = &nets[(j / m[1]) * columns + i / m[0]];
            let part = |k: usize, m: usize| [k as f64 / m as f64, (k + 1) as f64 / m as f64];
            let cut = across(&along(net, part(i % m[0], m[0])), part(j % m[1], m[1]));
            let (patch, by) = cubic(&cut);
            off = off.max(by);
            patches.push(patch);
        }
    }
    (patches, off)
}

fn along(net: &Net, range: [f64; 2]) -> Net {
    net.iter().map(|row| part(row, range)).collect()
}

fn across(net: &Net, range: [f64; 2]) -> Net {
    turned(&along(&turned(net), range))
}

/// Rows for columns.
fn turned(net: &Net) -> Net {
    (0..net[0].len()).map(|i| net.iter().map(|row| row[i]).collect()).collect()
}

/// The part of a Bezier curve over a range.
fn part(b: &[Vec4], [from, to]: [f64; 2]) -> Vec<Vec4> {
    if from <= 0.0 && to >= 1.0 {
        return b.to_vec();
    }
    let n = b.len() - 1;
    let point = |i: usize| {
        let mut d = b.to_vec();
        for r in 1..=n {
            let t = if r <= i { to } else { from };
            for j in 0..=n - r {
                d[j] = d[j] * (1.0 - t) + d[j + 1] * t;
            }
        }
        d[0]
    };
    (0..=n).map(point).collect()
}

/// The bicubic patch of a net: raised when it is lower, with the same ends and end derivatives when it is
/// higher; and a bound of the distance between both.
fn cubic(net: &Net) -> (Patch, f64) {
    let rows: Net = net.iter().map(|r| to_cubic(r)).collect();
    let both = turned(&turned(&rows).iter().map(|c| to_cubic(c)).collect());
    let patch = Patch::new([0, 1, 2, 3].map(|j| [0, 1, 2, 3].map(|i| both[j][i])));
    let [p, q] = [net[0].len() - 1, net.len() - 1];
    if p <= 3 && q <= 3 {
        return (patch, 0.0);
    }
    // Both raised to one degree: no point is farther off than the control points are.
    let [p, q] = [p.max(3), q.max(3)];
    let up = |net: &Net| {
        let rows: Net = net.iter().map(|r| raised(r, p)).collect();
        let columns: Net = turned(&rows).iter().map(|c| raised(c, q)).collect();
        columns
    };
    let (mut apart, mut weight) = ([0.0_f64; 2], f64::INFINITY);
    let mut far = 0.0_f64;
    let middle = net[0][0].xyz() / net[0][0].w;
    for (a, b) in up(net).iter().flatten().zip(up(&both).iter().flatten()) {
        let local = |h: &Vec4| h.xyz() - middle * h.w;
        apart[0] = apart[0].max((local(a) - local(b)).norm());
        apart[1] = apart[1].max((a.w - b.w).abs());
        weight = weight.min(a.w).min(b.w);
        far = far.max((a.xyz() / a.w - middle).norm());
    }
    (patch, (apart[0] + far * apart[1]) / weight.max(1e-300))
}

/// A Bezier curve as a cubic: raised, or with the same ends and derivatives there.
fn to_cubic(b: &[Vec4]) -> Vec<Vec4> {
    let n = b.len() - 1;
    if n <= 3 {
        return raised(b, 3);
    }
    let rate = n as f64;
    let (first, last) = ((b[1] - b[0]) * rate, (b[n] - b[n - 1]) * rate);
    CubicArc::homogeneous(b[0], b[n], first, last).b.to_vec()
}

/// The same curve with more control points.
fn raised(b: &[Vec4], degree: usize) -> Vec<Vec4> {
    let mut b = b.to_vec();
    while b.len() <= degree {
        let n = b.len();
        let mut up = Vec::with_capacity(n + 1);
        up.push(b[0]);
        for i in 1..n {
            let share = i as f64 / n as f64;
            up.push(b[i - 1] * share + b[i] * (1.0 - share));
        }
        up.push(b[n - 1]);
        b = up;
    }
    b
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn surface(
        degree: [usize; 2],
        knots: [Vec<f64>; 2],
        f: impl Fn(usize, usize) -> [f64; 4],
    ) -> BsplineSurface {
        let counts = [0, 1].map(|k| knots[k].len() - degree[k] - 1);
        let points = (0..counts[1]).flat_map(|j| (0..counts[0]).map(move |i| (i, j)));
        let points = points.map(|(i, j)| f(i, j)).collect();
        BsplineSurface { degree, knots, counts, points, range: [None; 2] }
    }

    /// Cox and de Boor's recursion, as it stands in books.
    fn basis(knots: &[f64], p: usize, i: usize, t: f64) -> f64 {
        if p == 0 {
            return f64::from(knots[i] <= t && t < knots[i + 1]);
        }
        let term = |num: f64, den: f64, b: f64| if den > 0.0 { num / den * b } else { 0.0 };
        term(t - knots[i], knots[i + p] - knots[i], basis(knots, p - 1, i, t))
            + term(
                knots[i + p + 1] - t,
                knots[i + p + 1] - knots[i + 1],
                basis(knots, p - 1, i + 1, t),
            )
    }

    fn direct(s: &BsplineSurface, u: f64, v: f64) -> Vec3 {
        let (mut sum, mut weight) = (Vec3::zeros(), 0.0);
        for (k, p) in s.points.iter().enumerate() {
            let (i, j) = (k % s.counts[0], k / s.counts[0]);
            let b = p[3]
                * basis(&s.knots[0], s.degree[0], i, u)
                * basis(&s.knots[1], s.degree[1], j, v);
            sum += Vec3::new(p[0], p[1], p[2]) * b;
            weight += b;
        }
        sum / weight
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn patches_are_the_surface(
            p in 1_usize..6, q in 1_usize..4, seed in prop::collection::vec(-1.0_f64..1.0, 96),
            steps in prop::collection::vec(0.0_f64..1.0, 20), u in 0.01_f64..0.99, v in 0.01_f64..0.99,
        ) {
            // Knots neither clamped nor even, some of them double.
            let knots = |p: usize, from: usize| {
                let mut t = 0.0;
                let step = |s: f64| if s < 0.15 { 0.0 } else { s };
                (0..p + 1 + 6).map(|k| { t += step(steps[from + k % 10]); t }).collect::<Vec<_>>()
            };
            let s = surface([p, q], [knots(p, 0), knots(q, 7)], |i, j| {
                let z = seed[(7 * i + 13 * j) % 96];
                [10.0 * i as f64, 10.0 * j as f64, 5.0 * z, 1.0 + 0.4 * seed[(i + 5 * j) % 96]]
            });
            let Ok((made, off)) = bspline(&s) else { return Ok(()) };
            let size = s.points.iter().map(|p| p[0].max(p[1])).fold(0.0, f64::max);
            let most = if p > 3 { 2e-6 * size } else { 0.0 };
            prop_assert!(off <= most);
            let borders = |k: usize| direction(&s, k).unwrap().borders;
            let [a, b] = [borders(0), borders(1)];
            let place = |borders: &[f64], t: f64| {
                let n = (borders.len() - 1) as f64;
                let k = (t * n).floor();
                let i = super::super::whole(k);
                (t * n, borders[i] + (borders[i + 1] - borders[i]) * (t * n - k))
            };
            let ((gu, lu), (gv, lv)) = (place(&a, u), place(&b, v));
            let e = (made.at(gu, gv).point - direct(&s, lu, lv)).norm();
            prop_assert!(e <= off + 1e-9 * size, "{} {}", e, off);
        }
    }

    #[test]
    fn a_quarter_of_a_cylinder_is_round() {
        let w = core::f64::consts::FRAC_1_SQRT_2;
        let s = surface(
            [2, 1],
            [vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], vec![0.0, 0.0, 1.0, 1.0]],
            |i, j| {
                let p = [[5.0, 0.0], [5.0, 5.0], [0.0, 5.0]][i];
                [p[0], p[1], 8.0 * j as f64, if i == 1 { w } else { 1.0 }]
            },
        );
        let (made, _) = bspline(&s).unwrap();
        for k in 0..=10 {
            let q = made.at(0.1 * f64::from(k), 0.3).point;
            assert!((q.xy().norm() - 5.0).abs() < 1e-14 && (q.z - 2.4).abs() < 1e-14);
        }
        // A part of it begins and ends where it says.
        let half = BsplineSurface { range: [Some([0.0, 0.5]), None], ..s };
        let (made, _) = bspline(&half).unwrap();
        assert!((made.at(1.0, 0.0).point.x - 5.0 * w).abs() < 1e-14);
    }

    #[test]
    fn what_is_no_surface_is_refused() {
        let good = || {
            surface([1, 1], [vec![0.0, 0.0, 1.0, 1.0], vec![0.0, 0.0, 1.0, 1.0]], |i, j| {
                [i as f64, j as f64, 0.0, 1.0]
            })
        };
        assert!(bspline(&good()).is_ok());
        let refused = |change: &dyn Fn(&mut BsplineSurface)| {
            let mut s = good();
            change(&mut s);
            bspline(&s).unwrap_err()
        };
        assert_eq!(refused(&|s| s.degree[0] = 0), BsplineFault::Degree);
        assert_eq!(refused(&|s| s.knots[0].truncate(3)), BsplineFault::KnotCount);
        assert_eq!(refused(&|s| s.knots[1][2] = -1.0), BsplineFault::Knots);
        assert_eq!(refused(&|s| s.knots[1] = vec![2.0; 4]), BsplineFault::Knots);
        assert_eq!(refused(&|s| s.points.truncate(3)), BsplineFault::PointCount);
        assert_eq!(refused(&|s| s.points[2][3] = 0.0), BsplineFault::Points);
        assert_eq!(refused(&|s| s.points[2][0] = f64::NAN), BsplineFault::Points);
    }
}
