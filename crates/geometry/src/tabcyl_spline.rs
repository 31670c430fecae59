//! The SPLINE of a TABCYL: the slopes at which its curvature is continuous.
//!
//! A slope of more than some 35 degrees bends its span less and less: the true curvature of a parabola over a chord L is
//! `2 m / (L (1 + m^2)^1.5)`, greatest at `m^2 = 1/2`. Where the chords turn far at the second point, the curve is one whose
//! end span takes nearly all of that turn, and from the circles through three points each, which share the turn between both
//! chords, the way there leads over that hump. So other beginnings are tried where the first one fails.

use crate::tabcyl_fit::{Chord, FitError, Knot, STEEPEST, between_tangents, two_point};

/// Angles in radians of the tangents at `knots`, counted as those of the chords.
///
/// Newton's method from the circles through three points each, then from other beginnings. Of 900 sets of 3 to 10 points that
/// stand up to the distance between them off a line, each with a curve that 100 beginnings by chance found, some ten are
/// not found; many more have no curve at all.
pub(crate) fn spline(knots: &[Knot], chords: &[Chord]) -> Result<Vec<f64>, FitError> {
    let circles = two_point(knots, chords);
    let mut failed: Option<System> = None;
    let mut steep = None;
    for lie in Lie::ALL {
        let start = lie.from(&circles, knots, chords);
        for form in [Form::Curvature, Form::Product] {
            match descend(knots, chords, start.clone(), form) {
                Ok(angles) if sound(&angles, chords) => return Ok(angles),
                Ok(angles) => steep = steep.or(Some(angles)),
                Err(system) => failed = failed.or(Some(system)),
            }
        }
    }
    match (steep, failed) {
        (Some(angles), _) => Ok(angles),
        (None, Some(system)) => Err(system.at_worst(chords)),
        (None, None) => Ok(circles),
    }
}

/// Steps of Newton's method; each doubles the figures once it is near.
const MAX_STEPS: u32 = 80;

/// How the tangents lie at the beginning.
#[derive(Clone, Copy)]
enum Lie {
    /// Along circles through three points each.
    Round,
    /// So, but along the inner chord at the points next to both ends.
    Ends,
    /// So at the point next to the first alone.
    First,
    /// So at the point next to the last alone.
    Last,
    /// Between the chords.
    Mean,
    /// Along the chord after every other point, before the points between.
    Even,
    /// Along the other chords.
    Odd,
}

impl Lie {
    const ALL: [Self; 7] =
        [Self::Round, Self::Ends, Self::First, Self::Last, Self::Mean, Self::Even, Self::Odd];

    /// The angles that lie so; slopes that are given stay.
    fn from(self, circles: &[f64], knots: &[Knot], chords: &[Chord]) -> Vec<f64> {
        let mut angles = circles.to_vec();
        let last = knots.len() - 1;
        if last < 2 {
            return angles;
        }
        for i in 1..last {
            let (before, after) = (chords[i - 1].angle, chords[i].angle);
            angles[i] = match self {
                Self::First | Self::Ends if i == 1 => after,
                Self::Last | Self::Ends if i == last - 1 => before,
                Self::Mean => 0.5 * (before + after),
                Self::Even => [before, after][i % 2],
                Self::Odd => [after, before][i % 2],
                _ => angles[i],
            };
        }
        if knots[0].tangent.is_none() {
            angles[0] = 2.0 * chords[0].angle - angles[1];
        }
        if knots[last].tangent.is_none() {
            angles[last] = 2.0 * chords[last - 1].angle - angles[last - 1];
        }
        angles
    }
}

/// What is taken to zero at an inner point.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    /// The difference of the curvatures, times the mean length of the chords.
    Curvature,
    /// That times `((1 + m^2) (1 + n^2))^1.5` of both slopes there, over four: it grows with steep slopes.
    Product,
}

/// Whether no slope is steeper than a cubic over a chord may be.
fn sound(angles: &[f64], chords: &[Chord]) -> bool {
    let within = |a: f64, c: &Chord| (a - c.angle).abs() < STEEPEST;
    chords.iter().enumerate().all(|(i, c)| within(angles[i], c) && within(angles[i + 1], c))
}

/// Newton's method from `angles`, the step halved while it makes things worse; the conditions where it ends without an answer.
fn descend(
    knots: &[Knot],
    chords: &[Chord],
    mut angles: Vec<f64>,
    form: Form,
) -> Result<Vec<f64>, System> {
    let mut system = System::at(knots, chords, &angles, form);
    for _ in 0..MAX_STEPS {
        if system.residual <= 1e-14 {
            return Ok(angles);
        }
        let step = system.solve();
        let mut share = 1.0;
        let mut better = None;
        for _ in 0..30 {
            let trial: Vec<f64> = angles.iter().zip(&step).map(|(a, s)| a - share * s).collect();
            let next = System::at(knots, chords, &trial, form);
            if next.residual < system.residual {
                better = Some((trial, next));
                break;
            }
            share *= 0.5;
        }
        match better {
            Some((trial, next)) => (angles, system) = (trial, next),
            // Rounding alone is left, or it is stuck.
            None => break,
        }
    }
    if system.residual <= 1e-10 { Ok(angles) } else { Err(system) }
}

/// The conditions at all points, linearised: three diagonals and a right side.
struct System {
    rows: Vec<[f64; 4]>,
    residual: f64,
}

impl System {
    fn at(knots: &[Knot], chords: &[Chord], angles: &[f64], form: Form) -> Self {
        let slopes = between_tangents(chords, angles);
        let last = knots.len() - 1;
        let row = |i: usize| -> [f64; 4] {
            if knots[i].tangent.is_some() {
                return [0.0, 1.0, 0.0, 0.0];
            }
            if i == 0 || i == last {
                let chord = chords[if i == 0 { 0 } else { last - 1 }].angle;
                let (end, next) = if i == 0 { (0, 1) } else { (last, last - 1) };
                let value = angles[end] + angles[next] - 2.0 * chord;
                return if i == 0 {
                    // A single chord without slopes: both conditions are one, the straight line.
                    let other = if last == 1 { 0.0 } else { 1.0 };
                    let value = if last == 1 { angles[0] - chord } else { value };
                    [0.0, 1.0, other, value]
                } else {
                    let other = if last == 1 && knots[0].tangent.is_none() { 0.0 } else { 1.0 };
                    let value = if other > 0.0 { value } else { angles[1] - chord };
                    [other, 1.0, 0.0, value]
                };
            }
            // Curvature at the end of the chord before less that at the start of the one after, times
            // the mean of their lengths.
            let ([m0, m1], [n0, n1]) = (slopes[i - 1], slopes[i]);
            let (l, k) = (chords[i - 1].length, chords[i].length);
            let mean = 0.5 * (l + k);
            let (q0, q1, r0, r1) = (1.0 + m0 * m0, 1.0 + m1 * m1, 1.0 + n0 * n0, 1.0 + n1 * n1);
            let (q, r) = (q1 * q1.sqrt(), r0 * r0.sqrt());
            let (x, y) = (m0 + 2.0 * m1, 2.0 * n0 + n1);
            let value = 2.0 * x / (l * q) + 2.0 * y / (k * r);
            let at_before = 2.0 * q0 / (l * q);
            let at_here = 2.0 * (2.0 * q1 - 3.0 * m1 * x) / (l * q)
                + 2.0 * (2.0 * r0 - 3.0 * n0 * y) / (k * r);
            let at_after = 2.0 * r1 / (k * r);
            if form == Form::Curvature {
                return [at_before * mean, at_here * mean, at_after * mean, value * mean];
            }
            let product = 0.25 * mean * q * r;
            // The factors turn with the tangent at the point too: the derivative of (1 + m^2)^1.5 is 3 m times itself.
            let here = at_here + 3.0 * (m1 + n0) * value;
            [at_before * product, here * product, at_after * product, value * product]
        };
        let rows: Vec<[f64; 4]> = (0..=last).map(row).collect();
        let largest = rows.iter().fold(0.0_f64, |m, r| m.max(r[3].abs()));
        // A slope beyond all bounds makes the rows undefined, and `max` would pass over that.
        let sound = rows.iter().flatten().all(|x| x.is_finite());
        Self { rows, residual: if sound { largest } else { f64::INFINITY } }
    }

    /// The step that takes the linearised conditions to zero, by elimination.
    fn solve(&self) -> Vec<f64> {
        let n = self.rows.len();
        let (mut upper, mut right) = (vec![0.0; n], vec![0.0; n]);
        for (i, [before, here, after, value]) in self.rows.iter().enumerate() {
            let (u, r) = if i > 0 { (upper[i - 1], right[i - 1]) } else { (0.0, 0.0) };
            let pivot = here - before * u;
            upper[i] = after / pivot;
            right[i] = (value - before * r) / pivot;
        }
        for i in (0..n - 1).rev() {
            right[i] -= upper[i] * right[i + 1];
        }
        right
    }

    /// What is told where the curvatures did not become continuous.
    fn at_worst(&self, chords: &[Chord]) -> FitError {
        let inner = 1..self.rows.len() - 1;
        let off = |i: &usize| self.rows[*i][3].abs();
        let at = inner.max_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(0);
        let turn = if at > 0 { chords[at].angle - chords[at - 1].angle } else { 0.0 };
        let (turn_deg, residual) = (turn.to_degrees().abs(), self.residual);
        FitError::NotConverged { at, turn_deg, residual }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Matrix3;

    use crate::{Fit, FitError, Knot, Tabcyl, Vec2, trig};

    fn through(points: &[[f64; 2]]) -> Result<Tabcyl, FitError> {
        let knot = |p: &[f64; 2]| Knot { point: Vec2::new(p[0], p[1]), tangent: None };
        let knots: Vec<Knot> = points.iter().map(knot).collect();
        Tabcyl::fit(&knots, Fit::Spline, Matrix3::identity(), 10.0)
    }

    /// The greatest step of the curvature at an inner point, times the length of the chord before it.
    fn step(t: &Tabcyl) -> f64 {
        let n = t.spans.len() - 2;
        let at = |i: usize| {
            let l = t.spans[i].length;
            (t.tangent(i, l).normalize() - t.tangent(i + 1, 0.0).normalize()).norm()
                + ((t.curvature(i, l) - t.curvature(i + 1, 0.0)) * l).abs()
        };
        (1..n).map(at).fold(0.0, f64::max)
    }

    /// Two chords of length one that turn by `turn`: with the slopes m at the second point against the first chord and n against the
    /// other the parabolas bend alike where `m (1 + n^2)^1.5 = -n (1 + m^2)^1.5`, `m = -n` by symmetry, up to a right angle.
    #[test]
    fn two_chords_share_their_turn() {
        for degrees in [5.0_f64, 40.0, 69.0, 71.0, 100.0, 150.0] {
            let (s, c) = (trig::sin_deg(degrees), trig::cos_deg(degrees));
            let t = through(&[[0.0, 0.0], [1.0, 0.0], [1.0 + c, s]]).expect("a curve");
            let slope = t.tangent(1, 1.0);
            let half = trig::atan2(slope.y, slope.x).to_degrees();
            assert!((half - 0.5 * degrees).abs() < 1e-9, "{degrees}: {half}");
        }
    }

    /// Heights at one distance of 20: where chords turn by 30 to 60 degrees next to an end, the end span takes the turn.
    #[test]
    fn a_sharp_turn_beside_an_end_is_taken_by_the_end_span() {
        let heights: [&[f64]; 4] = [
            &[0.0, 13.0, 4.0, 15.0, 9.0],
            &[10.0, 0.0, 11.0, 5.0],
            &[17.0, 4.0, 16.0, 17.0],
            &[0.0, 19.0, 12.0, 16.0, 17.0],
        ];
        for heights in heights {
            for mirrored in [false, true] {
                let mut at: Vec<[f64; 2]> =
                    heights.iter().enumerate().map(|(i, h)| [20.0 * i as f64, *h]).collect();
                if mirrored {
                    at.reverse();
                }
                let t = through(&at).expect("a curve");
                assert!(step(&t) < 1e-9, "{heights:?}: {}", step(&t));
                let n = t.spans.len() - 2;
                assert!(t.spans[1].a.abs() < 1e-9 && t.spans[n].a.abs() < 1e-9);
            }
        }
    }

    /// By chance: what is found has one curvature everywhere; from circles alone 384 are found.
    #[test]
    fn curves_by_chance_have_one_curvature() {
        let mut seed = 7_u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 40) as f64 / (1_u64 << 24) as f64
        };
        let (mut found, mut all) = (0, 0);
        for i in 0..400 {
            let n = 3 + i % 8;
            let at: Vec<[f64; 2]> =
                (0..n).map(|j| [20.0 * j as f64 + 8.0 * next(), 12.0 * next()]).collect();
            all += 1;
            if let Ok(t) = through(&at) {
                assert!(step(&t) < 1e-9, "{at:?}");
                found += 1;
            }
        }
        assert!(found * 50 >= all * 49, "{found} of {all}");
    }
}
