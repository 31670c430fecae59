//! Fairing a TABCYL: the cubics over the chords of its points.
//!
//! With the slopes m0 and m1 against the chord at its ends the cubic is `a = (m0 + m1) / L^2`,
//! `b = -(2 m0 + m1) / L`, and its true curvatures there are `-2 (2 m0 + m1) / (L (1 + m0^2)^1.5)` and
//! `2 (m0 + 2 m1) / (L (1 + m1^2)^1.5)`.

use nalgebra::Matrix3;

use crate::tabcyl::left;
use crate::tabcyl_spline::spline;
use crate::{Tabcyl, TabcylSpan, Vec2, trig};

/// How the curve runs through its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    /// SPLINE: slope and curvature are continuous. A slope given at an end holds; without one an end interval is a
    /// parabola. Given in between it does not count, as in APT-360: it would break the curvature.
    Spline,
    /// TWOPT, PTSLOP, PTNORM: given slopes hold, others are those of the circle through the point and its
    /// neighbours.
    TwoPoint,
    /// FOURPT: over each chord the cubic through its ends and the next point on either side.
    FourPoint,
}

/// A point of the directrix with the direction of the curve there, of any length and sense.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knot {
    /// The point.
    pub point: Vec2,
    /// Direction of the tangent, when it is given.
    pub tangent: Option<Vec2>,
}

/// Why no curve was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FitError {
    /// Fewer than two points.
    TooFew,
    /// This point and the one before fall together.
    Coincide(usize),
    /// At this point the curve would leave the chord at this angle in degrees, 85 or more.
    Overhang(usize, f64),
    /// FOURPT: a neighbour of the chord at this point stands level with one of its ends.
    Level(usize),
    /// The curvatures did not become continuous.
    NotConverged {
        /// The inner point where they differ most.
        at: usize,
        /// Angle in degrees by which the chords turn there.
        turn_deg: f64,
        /// The difference of curvature, times the mean length of the chords.
        residual: f64,
    },
}

/// Angle against the chord in radians beyond which a cubic over the chord is no sensible curve.
pub(crate) const STEEPEST: f64 = 85.0 / 180.0 * std::f64::consts::PI;

impl Tabcyl {
    /// The TABCYL through `knots` in the plane of the rows u and v of `axes`, prolonged straight by
    /// `extension` at both ends; where the last point is the first but for rounding the curve goes round, and nothing prolongs
    /// it. The tangents at that point are those of both ends of the same curve if it were open, and may differ.
    ///
    /// Where the straight ends would cross each other they stop a hundredth before the crossing, as
    /// APT-360's do.
    pub fn fit(
        knots: &[Knot],
        fit: Fit,
        axes: Matrix3<f64>,
        extension: f64,
    ) -> Result<Self, FitError> {
        let closed = closes(knots);
        let mut knots = knots.to_vec();
        if closed && let [first, .., last] = &mut knots[..] {
            last.point = first.point;
        }
        let knots = &knots[..];
        let chords = chords(knots)?;
        let slopes = match fit {
            Fit::Spline => between_tangents(&chords, &spline(&free_within(knots), &chords)?),
            Fit::TwoPoint => between_tangents(&chords, &two_point(knots, &chords)),
            Fit::FourPoint => four_point(knots, &chords)?,
        };
        for (i, m) in slopes.iter().enumerate() {
            for (j, m) in m.iter().enumerate() {
                let angle = trig::atan(m.abs());
                if angle.is_nan() || angle >= STEEPEST {
                    return Err(FitError::Overhang(i + j, angle.to_degrees()));
                }
            }
        }
        let mut spans = Vec::with_capacity(chords.len() + 2);
        let first = along(&chords[0], slopes[0][0]);
        let last = &chords[chords.len() - 1];
        let end = along(last, slopes[chords.len() - 1][1]);
        let tip = knots[knots.len() - 1].point;
        let lengths = extensions(knots[0].point, -first, tip, end, extension);
        if !closed {
            spans.push(straight(knots[0].point - first * lengths[0], lengths[0]));
        }
        for (i, (chord, [m0, m1])) in chords.iter().zip(&slopes).enumerate() {
            let l = chord.length;
            let (a, b) = ((m0 + m1) / (l * l), -(2.0 * m0 + m1) / l);
            spans.push(span(knots[i].point, a, b, l));
        }
        if closed {
            return Ok(Self { axes, spans, end: tip });
        }
        spans.push(straight(tip, lengths[1]));
        Ok(Self { axes, spans, end: tip + end * lengths[1] })
    }
}

/// Share of the size of the points within which the last one is the first: a few digits are lost where points are computed.
const CLOSED: f64 = 1e-9;

/// Is the last point the first, with an area between?
fn closes(knots: &[Knot]) -> bool {
    let [first, _, _, .., last] = knots else { return false };
    let size = knots.iter().map(|k| k.point.amax()).fold(0.0, f64::max);
    (last.point - first.point).norm() <= CLOSED * size
}

/// The points without the slopes of those between the ends.
fn free_within(knots: &[Knot]) -> Vec<Knot> {
    let last = knots.len() - 1;
    let free = |(i, k): (usize, &Knot)| match i {
        i if i == 0 || i == last => *k,
        _ => Knot { tangent: None, ..*k },
    };
    knots.iter().enumerate().map(free).collect()
}

/// One chord.
pub(crate) struct Chord {
    pub(crate) length: f64,
    unit: Vec2,
    /// Angle against u in radians, counted on from chord to chord without jumps.
    pub(crate) angle: f64,
}

fn chords(knots: &[Knot]) -> Result<Vec<Chord>, FitError> {
    if knots.len() < 2 {
        return Err(FitError::TooFew);
    }
    let mut all: Vec<Chord> = Vec::with_capacity(knots.len() - 1);
    for (i, pair) in knots.windows(2).enumerate() {
        let way = pair[1].point - pair[0].point;
        let length = way.norm();
        let size = pair[0].point.amax().max(pair[1].point.amax());
        if length.is_nan() || length <= 1e-12 * size {
            return Err(FitError::Coincide(i + 1));
        }
        let unit = way / length;
        let angle = match all.last() {
            None => trig::atan2(unit.y, unit.x),
            Some(before) => {
                before.angle + trig::atan2(before.unit.perp(&unit), before.unit.dot(&unit))
            }
        };
        all.push(Chord { length, unit, angle });
    }
    Ok(all)
}

/// Unit direction at slope `m` against the chord.
fn along(chord: &Chord, m: f64) -> Vec2 {
    (chord.unit + left(chord.unit) * m).normalize()
}

/// Length of the straight ends from `p` along `u` and from `q` along `v`.
fn extensions(p: Vec2, u: Vec2, q: Vec2, v: Vec2, extension: f64) -> [f64; 2] {
    let (sine, way) = (u.perp(&v), q - p);
    let (s, t) = (way.perp(&v) / sine, way.perp(&u) / sine);
    let crossing = s > 0.0 && t > 0.0 && s.min(t) < extension;
    if crossing && s.is_finite() && t.is_finite() {
        return [0.99 * s, 0.99 * t];
    }
    [extension, extension]
}

fn straight(start: Vec2, length: f64) -> TabcylSpan {
    TabcylSpan { start, a: 0.0, b: 0.0, length, max: 0.0, min: 0.0 }
}

/// The span with its extreme offsets.
pub(crate) fn span(start: Vec2, a: f64, b: f64, length: f64) -> TabcylSpan {
    let mut span = TabcylSpan { start, a, b, length, max: 0.0, min: 0.0 };
    let slope = [-(a * length * length + b * length), 2.0 * b, 3.0 * a];
    for s in crate::polynomial::roots(&slope, 0.0, length, 0.0) {
        let v = span.offset(s);
        (span.max, span.min) = (span.max.max(v), span.min.min(v));
    }
    span
}

/// Slopes against the chords at both ends of each, from the angles of the tangents at the points.
pub(crate) fn between_tangents(chords: &[Chord], angles: &[f64]) -> Vec<[f64; 2]> {
    let slope = |i: usize, c: &Chord| bounded_tan(angles[i] - c.angle);
    chords.iter().enumerate().map(|(i, c)| [slope(i, c), slope(i + 1, c)]).collect()
}

/// The tangent, infinite from a right angle on, so that such a slope is refused and not folded back.
fn bounded_tan(angle: f64) -> f64 {
    if angle.abs() < std::f64::consts::FRAC_PI_2 { trig::tan(angle) } else { f64::INFINITY }
}

/// Angle of the tangent at point `i` in radians: the given one in the sense of the chords, or that of the
/// circle through the neighbours; at an end, that of the parabola that meets the next point's circle.
fn start_angle(knots: &[Knot], chords: &[Chord], i: usize) -> Option<f64> {
    let (before, after) = (i.checked_sub(1).map(|j| &chords[j]), chords.get(i));
    if let Some(given) = knots[i].tangent {
        // Between both chords, which may turn far: against their mean direction.
        let mean = match (before, after) {
            (Some(b), Some(a)) => 0.5 * (b.angle + a.angle),
            (Some(c), None) | (None, Some(c)) => c.angle,
            (None, None) => 0.0,
        };
        let turn = trig::atan2(given.y, given.x) - mean;
        let half = std::f64::consts::PI;
        return Some(mean + turn - half * (turn / half).round());
    }
    circle_angle(chords, i)
}

/// Angle at an inner point of the circle through it and its neighbours: with the angles p and q between tangent and chords,
/// p + q is the turn of the chords and sin p : sin q their lengths, so tan p = sin turn / (cos turn + after / before).
fn circle_angle(chords: &[Chord], i: usize) -> Option<f64> {
    let (before, after) = (chords.get(i.checked_sub(1)?)?, chords.get(i)?);
    let (sine, cosine) = (before.unit.perp(&after.unit), before.unit.dot(&after.unit));
    Some(before.angle + trig::atan2(sine, cosine + after.length / before.length))
}

pub(crate) fn two_point(knots: &[Knot], chords: &[Chord]) -> Vec<f64> {
    let n = knots.len();
    let mut angles: Vec<Option<f64>> = (0..n).map(|i| start_angle(knots, chords, i)).collect();
    for (end, next, chord) in [(0, 1, 0), (n - 1, n - 2, n - 2)] {
        if angles[end].is_none() {
            let angle = chords[chord].angle;
            // A slope given at the next point is that point's alone, as in APT-360. Alone, two points have no next
            // tangent: the chord itself.
            let next = circle_angle(chords, next).or(angles[next]);
            angles[end] = Some(next.map_or(angle, |next| 2.0 * angle - next));
        }
    }
    angles.into_iter().flatten().collect()
}

/// Slopes of the cubic `s (s - L) (a s + c)` over each chord that meets the points next to the chord.
fn four_point(knots: &[Knot], chords: &[Chord]) -> Result<Vec<[f64; 2]>, FitError> {
    let n = knots.len();
    let mut slopes = Vec::with_capacity(chords.len());
    for (i, chord) in chords.iter().enumerate() {
        // At an end of the table both other points lie on one side.
        let first = i.saturating_sub(1).min(n.saturating_sub(4));
        let l = chord.length;
        let mut outer = Vec::new();
        for j in (first..n.min(first + 4)).filter(|j| *j != i && *j != i + 1) {
            let way = knots[j].point - knots[i].point;
            let (s, v) = (way.dot(&chord.unit), chord.unit.perp(&way));
            let across = s * (s - l);
            if across.abs() <= 1e-9 * l * l {
                return Err(FitError::Level(j));
            }
            outer.push((s, v / across));
        }
        let (a, c) = match outer[..] {
            [(s, g), (t, h), ..] => {
                if (t - s).abs() <= 1e-9 * l {
                    return Err(FitError::Level(i));
                }
                let a = (h - g) / (t - s);
                (a, g - a * s)
            }
            [(_, g)] => (0.0, g),
            [] => (0.0, 0.0),
        };
        slopes.push([-c * l, l * (a * l + c)]);
    }
    Ok(slopes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn free(points: &[[f64; 2]]) -> Vec<Knot> {
        points.iter().map(|p| Knot { point: Vec2::new(p[0], p[1]), tangent: None }).collect()
    }

    fn fitted(knots: &[Knot], fit: Fit) -> Tabcyl {
        Tabcyl::fit(knots, fit, Matrix3::identity(), 10.0).expect("a curve")
    }

    /// A wave, a hook and a spiral: bends both ways and turns past a right angle.
    fn samples() -> Vec<Vec<Knot>> {
        let wave: Vec<[f64; 2]> =
            (0..30).map(|i| [f64::from(i) * 0.3, trig::sin(f64::from(i) * 0.6)]).collect();
        let hook =
            [[5.0, 0.0], [6.0, 0.2], [7.0, 0.9], [7.3, 1.5], [7.2, 2.4], [6.0, 3.5], [4.0, 4.0]];
        let spiral: Vec<[f64; 2]> = (0..40)
            .map(|i| {
                let t = f64::from(i) * 0.4;
                [t * trig::cos(t), t * trig::sin(t)]
            })
            .skip(2)
            .collect();
        vec![free(&wave), free(&hook), free(&spiral)]
    }

    #[test]
    fn a_spline_is_smooth_and_ends_in_parabolas() {
        for knots in samples() {
            let t = fitted(&knots, Fit::Spline);
            assert_eq!(t.spans.len(), knots.len() + 1);
            let n = t.spans.len() - 2;
            for i in 1..n {
                let l = t.spans[i].length;
                let (u, v) = (t.tangent(i, l).normalize(), t.tangent(i + 1, 0.0).normalize());
                assert!((u - v).norm() < 1e-12, "slope at {i}");
                let jump = t.curvature(i, l) - t.curvature(i + 1, 0.0);
                assert!((jump * l).abs() < 1e-9, "curvature at {i}: {jump}");
            }
            assert!(t.spans[1].a.abs() < 1e-9 && t.spans[n].a.abs() < 1e-9);
            for (i, k) in knots.iter().enumerate() {
                assert_eq!(t.spans[i + 1].start, k.point);
            }
        }
    }

    #[test]
    fn given_slopes_hold() {
        for (n, mut knots) in samples().into_iter().enumerate() {
            let plain = fitted(&knots, Fit::Spline);
            let places = [0, 3, knots.len() - 1];
            let turn = 0.1 + 0.02 * f64::from(u32::try_from(n).unwrap());
            for i in places {
                let t = plain.tangent(i + 1, 0.0);
                // Slopes come without a sense: the opposite one is as good.
                knots[i].tangent = Some(-(t + left(t) * turn));
            }
            for fit in [Fit::Spline, Fit::TwoPoint] {
                let t = fitted(&knots, fit);
                // Within a SPLINE none holds: the ends alone give the same curve.
                let ends = [0, knots.len() - 1];
                let mut free = knots.clone();
                free[3].tangent = None;
                assert_eq!(t == fitted(&free, fit), fit == Fit::Spline);
                for i in places.into_iter().filter(|i| fit == Fit::TwoPoint || ends.contains(i)) {
                    let given = knots[i].tangent.unwrap().normalize();
                    let after = t.tangent(i + 1, 0.0).normalize();
                    let before = t.tangent(i, t.spans[i].length).normalize();
                    assert!(given.perp(&after).abs() < 1e-12 && after.dot(&before) > 0.999_999);
                }
            }
        }
    }

    /// Points of a circle have its tangents, and so have the ends, whatever is given beside them.
    #[test]
    fn two_point_slopes_are_those_of_circles() {
        let at = |degrees: f64| [5.0 * trig::cos_deg(degrees), 5.0 * trig::sin_deg(degrees)];
        let degrees = [0.0, 25.0, 95.0, 130.0, 190.0];
        let plain = free(&degrees.map(at));
        let mut given = plain.clone();
        given[1].tangent = Some(Vec2::new(-1.0, 1.0));
        for (knots, places) in [(&plain, [1, 2, 3]), (&given, [2, 2, 3])] {
            let t = fitted(knots, Fit::TwoPoint);
            for i in places {
                let off = t.tangent(i + 1, 0.0).normalize().dot(&knots[i].point) / 5.0;
                assert!(off.abs() < 1e-12, "{i}: {off}");
            }
            // The parabola at an end leans as much against its chord as the circle does at the other end of it.
            let off = t.tangent(1, 0.0).normalize().dot(&knots[0].point) / 5.0;
            assert!(off.abs() < 1e-12, "the end: {off}");
        }
    }

    #[test]
    fn points_of_a_circle_give_nearly_the_circle() {
        let knots: Vec<[f64; 2]> = (0..25)
            .map(|i| {
                let (s, c) = trig::sin_cos(f64::from(i) * 0.1);
                [3.0 * c, 3.0 * s]
            })
            .collect();
        let t = fitted(&free(&knots), Fit::Spline);
        for i in 2..t.spans.len() - 2 {
            let p = t.point(i, 0.5 * t.spans[i].length);
            assert!((p.norm() - 3.0).abs() < 1e-5, "{}", p.norm() - 3.0);
        }
    }

    /// Twelve points of a circle, the last of them the first: the slopes at the ends are the same by symmetry, and no place is beyond
    /// an end.
    #[test]
    fn what_ends_where_it_begins_goes_round() {
        let at = |i: u32| {
            let a = f64::from(i) * 30.0 + 7.0;
            [20.0 + 3.0 * trig::cos_deg(a), 3.0 * trig::sin_deg(a) - 4.0]
        };
        let mut points: Vec<[f64; 2]> = (0..=12).map(at).collect();
        for off in [0.0, 3e-9] {
            points[12] = [points[0][0] + off, points[0][1]];
            for fit in [Fit::Spline, Fit::TwoPoint, Fit::FourPoint] {
                let t = fitted(&free(&points), fit);
                assert!(t.closed() && t.spans.len() == 12 && t.end == t.spans[0].start);
                assert!(t.transformed(&crate::Transform::identity()).is_some_and(|t| t.closed()));
                assert_eq!(
                    (t.span_before(0), t.span_after(11), t.span_after(3)),
                    (Some(11), Some(0), Some(4))
                );
                let turn =
                    t.tangent(11, t.spans[11].length).normalize() - t.tangent(0, 0.0).normalize();
                // FOURPT takes both points beside the last chord from one side of it.
                assert!(fit == Fit::FourPoint || turn.norm() < 1e-9, "{fit:?}: {turn}");
                // The line through the first point and the centre meets it there once, and on the other side.
                let n = left(Vec2::new(20.0, -4.0) - t.end).normalize();
                assert_eq!(t.meets_line(n, n.dot(&t.end)).len(), 2, "{fit:?}");
                // From the centre all of it is 3 away, nearly.
                let near = t.nearest_to(Vec2::new(20.0, -4.0)).expect("a place");
                let far = (near.point - Vec2::new(20.0, -4.0)).norm();
                assert!(fit == Fit::FourPoint || far > 2.99, "{fit:?}: {far}");
            }
        }
        points[12][0] += 1e-6;
        let t = fitted(&free(&points), Fit::Spline);
        assert!(!t.closed() && t.spans.len() == 14);
    }

    #[test]
    fn four_points_lie_on_each_cubic() {
        let knots = free(&[[0.0, 0.0], [1.0, 0.5], [2.0, 0.4], [3.5, 1.0], [4.0, 0.0], [5.5, 0.1]]);
        let t = fitted(&knots, Fit::FourPoint);
        for i in 0..5_usize {
            let first = i.saturating_sub(1).min(2);
            for knot in &knots[first..first + 4] {
                let way = knot.point - knots[i].point;
                let chord = t.chord(i + 1);
                let (s, v) = (way.dot(&chord), chord.perp(&way));
                assert!((t.spans[i + 1].offset(s) - v).abs() < 1e-12);
            }
        }
        let line = fitted(&free(&[[0.0, 0.0], [3.0, 4.0]]), Fit::Spline);
        assert!((line.end - Vec2::new(9.0, 12.0)).norm() < 1e-12);
    }

    #[test]
    fn what_cannot_be_is_refused() {
        let fit = |k: &[Knot]| Tabcyl::fit(k, Fit::Spline, Matrix3::identity(), 10.0).map(|_| ());
        assert_eq!(fit(&free(&[[1.0, 1.0]])), Err(FitError::TooFew));
        let twice = free(&[[1.0, 1.0], [2.0, 1.0], [2.0, 1.0]]);
        assert_eq!(fit(&twice), Err(FitError::Coincide(2)));
        let back = free(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.001], [1.0, 0.002]]);
        assert!(fit(&back).is_err());
        // A zigzag of sharp teeth: no curvature could turn it that fast at every tooth.
        let teeth: Vec<[f64; 2]> =
            (0..30).map(|i| [f64::from(i) * 0.3, trig::sin(f64::from(i))]).collect();
        assert!(matches!(fit(&free(&teeth)), Err(FitError::NotConverged { .. })));
    }
}
