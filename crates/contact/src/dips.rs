//! Extreme values of a gap along a chord, from its values and slopes at places.

use aptc_geometry::Reason;

use crate::chord::Extreme;

/// Bound of the search for one extreme value.
const MAX_STEPS: usize = 60;
/// Places at which a single extreme is looked for before the chord is cut into pieces.
const SINGLE: usize = 5;

/// Gap and its rate of change at a place of a chord.
#[derive(Clone, Copy)]
pub(crate) struct Sample {
    pub(crate) t: f64,
    pub(crate) g: f64,
    pub(crate) slope: f64,
}

/// The least value of `sign * g`, a convex function, bounded from below by the tangents of a bracket; `at` gives the
/// sample at a place, and what helps to find those near it.
#[inline]
pub(crate) fn dip<N>(
    a: (Sample, N),
    b: (Sample, N),
    sign: f64,
    resolution: f64,
    at: impl Fn(f64, &N) -> Result<(Sample, N), Reason>,
) -> Result<Extreme, Reason> {
    let value = |p: &Sample| sign * p.g;
    let slope = |p: &Sample| sign * p.slope;
    if slope(&a.0) >= 0.0 {
        return Ok(Extreme { t: a.0.t, g: a.0.g });
    }
    if slope(&b.0) <= 0.0 {
        return Ok(Extreme { t: b.0.t, g: b.0.g });
    }
    let ((mut a, mut by_a), (mut b, mut by_b)) = (a, b);
    // The cubic through both ends and slopes starts the search: exact for constant curvature.
    let mut t = cubic_minimum(&a, &b, slope(&a), slope(&b), value(&a), value(&b));
    let mut last = f64::INFINITY;
    for _ in 0..MAX_STEPS {
        let near = if t - a.t < b.t - t { &by_a } else { &by_b };
        let (here, by) = at(t, near)?;
        // The slope's own slope, from the parabola through three places.
        let turn = |p: &Sample| (slope(p) - slope(&here)) / (p.t - here.t);
        let bend = turn(&a) + turn(&b) - (slope(&b) - slope(&a)) / (b.t - a.t);
        if slope(&here) < 0.0 {
            (a, by_a) = (here, by);
        } else {
            (b, by_b) = (here, by);
        }
        let cut = tangents_meet(&a, &b, slope(&a), slope(&b), value(&a), value(&b));
        let best = if value(&a) < value(&b) { &a } else { &b };
        if value(best) - cut.1 <= resolution || b.t - a.t <= 1e-15 {
            return Ok(Extreme { t: best.t, g: sign * cut.1.min(value(best)) });
        }
        let step = -slope(&here) / bend;
        let newton = here.t + step;
        t = if bend > 0.0 && newton > a.t && newton < b.t && step.abs() < 0.5 * last {
            last = step.abs();
            newton
        } else {
            last = f64::INFINITY;
            let margin = 0.05 * (b.t - a.t);
            cut.0.clamp(a.t + margin, b.t - margin)
        };
        if step.abs() <= 1e-9 && bend > 0.0 {
            // The bracket closes from one side only: step over to see the other.
            let over = 4.0 * step.abs().max(1e-12) * step.signum();
            let cross = here.t + over;
            if cross > a.t && cross < b.t {
                t = cross;
            }
        }
    }
    let cut = tangents_meet(&a, &b, slope(&a), slope(&b), value(&a), value(&b));
    Ok(Extreme { t: cut.0, g: sign * cut.1 })
}

/// The one dip or bump between two places whose slopes have different signs: the slope, met at a few places, falls or rises
/// all along, and the cubic through the ends foretells what is met. `None` when it is not so. `between` looks at a place
/// between two that are known.
#[inline]
pub(crate) fn single<P: Copy>(
    a: P,
    b: P,
    resolution: f64,
    sample: impl Fn(&P) -> Sample,
    between: impl Fn(&P, &P, f64) -> Result<P, Reason>,
) -> Result<Option<Extreme>, Reason> {
    let [begin, end] = [sample(&a), sample(&b)];
    let sign = if end.slope > begin.slope { 1.0 } else { -1.0 };
    let (value, slope) = (|p: &Sample| sign * p.g, |p: &Sample| sign * p.slope);
    let [sa, sb] = [slope(&begin), slope(&end)];
    if sa >= 0.0 || sb <= 0.0 {
        return Ok(None);
    }
    let depth = 0.125 * (end.t - begin.t) * (sb - sa);
    let (mut low, mut high) = ((a, begin), (b, end));
    let mut t = cubic_minimum(&begin, &end, sa, sb, value(&begin), value(&end));
    let [foretold, _] = cubic_at(&begin, &end, t);
    for round in 0..SINGLE {
        let found = between(&low.0, &high.0, t)?;
        let at = sample(&found);
        let s = slope(&at);
        let strange = round == 0 && (at.g - foretold).abs() > 0.05 * depth;
        if strange || s <= slope(&low.1) || s >= slope(&high.1) {
            return Ok(None);
        }
        // The slope's own slope there, from the parabola through three places.
        let by = |p: &Sample| (slope(p) - s) / (p.t - at.t);
        let whole = (slope(&high.1) - slope(&low.1)) / (high.1.t - low.1.t);
        let bend = by(&low.1) + by(&high.1) - whole;
        if bend <= 0.0 {
            return Ok(None);
        }
        // What is left to the extreme of a parabola, which is so near that nothing else is: where it ends is the same one round
        // sooner or later.
        let left = 0.5 * s * s / bend;
        if 2.0 * left <= resolution {
            return Ok(Some(Extreme { t: at.t - s / bend, g: sign * (value(&at) - left) }));
        }
        t = at.t - s / bend;
        *(if s < 0.0 { &mut low } else { &mut high }) = (found, at);
        if t <= low.1.t || t >= high.1.t {
            return Ok(None);
        }
    }
    Ok(None)
}

/// The one dip or bump between two places of a smooth gap, by the values, slopes and second derivatives there, the whole way being
/// 1; `None` where the cubic through values and slopes is off by more of it than leaves what is between to be told so.
///
/// The form of fifth degree that has the second derivatives too is x^2 (1 - x)^2 (p + q x) above the cubic. What is off the cubic falls
/// with the fourth power of the way and what is off that form with the sixth: as a share of the dip by about the square.
pub(crate) fn foretold(
    a: &Sample,
    b: &Sample,
    [bend_a, bend_b]: [f64; 2],
    resolution: f64,
) -> Option<Extreme> {
    let (sign, rise) = (if b.slope > a.slope { 1.0 } else { -1.0 }, b.g - a.g);
    let (sa, sb) = (sign * a.slope, sign * b.slope);
    if sa >= 0.0 || sb <= 0.0 || sign * bend_a <= 0.0 || sign * bend_b <= 0.0 {
        return None;
    }
    let second =
        [6.0 * rise - 4.0 * a.slope - 2.0 * b.slope, 2.0 * a.slope + 4.0 * b.slope - 6.0 * rise];
    let (p, end) = (0.5 * (bend_a - second[0]), 0.5 * (bend_b - second[1]));
    let (depth, off) = (0.125 * (sb - sa), p.abs().max(end.abs()) / 16.0);
    if off * off > 0.25 * resolution * depth {
        return None;
    }
    let t = cubic_minimum(a, b, sa, sb, sign * a.g, sign * b.g);
    let ([g, slope], inner) = (cubic_at(a, b, t), t * (1.0 - t));
    let (more, by) = (p + (end - p) * t, end - p);
    let g = g + inner * inner * more;
    let slope = slope + inner * (2.0 * (1.0 - 2.0 * t) * more + inner * by);
    let bend = second[0] + (second[1] - second[0]) * t;
    // The extreme lies so near that the parabola there tells it.
    Some(Extreme { t: t - slope / bend, g: g - 0.5 * slope * slope / bend })
}

/// The cubic through values and slopes of two places, and its slope.
pub(crate) fn cubic_at(a: &Sample, b: &Sample, t: f64) -> [f64; 2] {
    let h = b.t - a.t;
    let x = (t - a.t) / h;
    let (c1, rise) = (a.slope * h, b.g - a.g);
    let c2 = 3.0 * rise - 2.0 * c1 - b.slope * h;
    let c3 = c1 + b.slope * h - 2.0 * rise;
    [a.g + x * (c1 + x * (c2 + x * c3)), (c1 + x * (2.0 * c2 + x * (3.0 * c3))) / h]
}

/// Where the tangents at the ends of a bracket meet.
pub(crate) fn tangents_meet(
    a: &Sample,
    b: &Sample,
    sa: f64,
    sb: f64,
    ga: f64,
    gb: f64,
) -> (f64, f64) {
    let t = (ga - gb + sb * b.t - sa * a.t) / (sb - sa);
    if t.is_finite() {
        let t = t.clamp(a.t, b.t);
        (t, (ga + sa * (t - a.t)).max(gb + sb * (t - b.t)))
    } else {
        (0.5 * (a.t + b.t), ga.min(gb))
    }
}

/// Place of the minimum of the cubic through values and slopes, the slopes falling and rising.
fn cubic_minimum(a: &Sample, b: &Sample, sa: f64, sb: f64, ga: f64, gb: f64) -> f64 {
    let h = b.t - a.t;
    let z = 3.0 * (ga - gb) / h + sa + sb;
    let root = (z * z - sa * sb).max(0.0).sqrt();
    let x = 1.0 - (sb + root - z) / (sb - sa + 2.0 * root);
    let x = if x.is_finite() { x.clamp(0.02, 0.98) } else { 0.5 };
    a.t + h * x
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::trig;

    #[test]
    fn what_ends_foretell_is_met_in_between() {
        // The distance of a point beside a circle, along a straight way; and what rises faster and faster.
        let round = |h: f64, x: f64| {
            let far = h * (x - 0.3);
            let d = trig::hypot(far, 2.0);
            let slope = h * far / d;
            [d, slope, (h * h - slope * slope) / d]
        };
        let steep = |h: f64, x: f64| {
            let y = h * (x - 0.6);
            [trig::exp(y) - y, h * (trig::exp(y) - 1.0), h * h * trig::exp(y)]
        };
        let mut told = [0_u32; 2];
        for k in 1..=60 {
            let h = 0.02 * f64::from(k);
            for (i, f) in [&round as &dyn Fn(f64, f64) -> [f64; 3], &steep].into_iter().enumerate()
            {
                for sign in [1.0, -1.0] {
                    let sample = |t: f64| {
                        let [g, slope, _] = f(h, t);
                        Sample { t, g: sign * g, slope: sign * slope }
                    };
                    let bends = [sign * f(h, 0.0)[2], sign * f(h, 1.0)[2]];
                    let resolution = 1e-9;
                    let Some(found) = foretold(&sample(0.0), &sample(1.0), bends, resolution)
                    else {
                        continue;
                    };
                    told[i] += 1;
                    let least = (0..=4000)
                        .map(|j| f(h, f64::from(j) / 4000.0)[0])
                        .fold(f64::INFINITY, f64::min);
                    let off = sign * found.g - least;
                    assert!(off.abs() <= 0.1 * resolution + 2e-8 * h * h, "{i} {h} {off}");
                }
            }
        }
        assert!(told.iter().all(|n| *n > 10), "{told:?}");
        // Ends that do not agree on what is between tell nothing.
        let [a, b] = [(0.0, -1.0), (1.0, 1.0)].map(|(t, slope)| Sample { t, g: 0.0, slope });
        assert!(foretold(&a, &b, [2.0, 2.0], 1e-9).is_some());
        assert!(foretold(&a, &b, [2.0, 2.1], 1e-9).is_none());
        assert!(foretold(&a, &b, [4.0, 0.5], 1e-9).is_none());
    }
}
