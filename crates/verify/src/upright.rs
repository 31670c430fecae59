//! A cutter that stands along the generatrix of a TABCYL: a circle that moves in the plane of the directrix.
//!
//! Its gap is the distance of its centre from the curve less its radius. Seen from the straight way of the centre a
//! span of the curve is a cubic, whose extreme values are closed forms. So a bound needs no search.

use aptc_geometry::Vec2;

use crate::pile::Pile;
use crate::sheet::{Flat, Spot, Tabcyl};

/// Rounds of Newton's method to a nearest place; some three are usual.
const ROUNDS: usize = 24;
/// Halvings of a span where it is held away from an end of the way.
const DEPTH: u32 = 16;
/// Pieces of the curve that are looked at for one vector.
const MOST: u32 = 200;
/// Halvings of the way where it is held near the curve.
const HALVES: u32 = 10;
/// Share of the way by which it may go beyond what is seen square to it.
const BESIDE: f64 = 1e-9;

/// The straight way of a centre.
#[derive(Clone, Copy, Debug)]
struct Way {
    from: Vec2,
    /// Unit direction, and the one square to it that points to the curve.
    along: Vec2,
    square: Vec2,
    length: f64,
}

/// A place of the curve.
#[derive(Clone, Copy, Debug)]
struct At {
    chart: usize,
    x: f64,
    p: Vec2,
}

/// `c0 + c1 x + c2 x^2 + c3 x^3`.
#[derive(Clone, Copy, Debug)]
struct Cubic([f64; 4]);

/// Least and greatest distance of the curve from a centre that goes straight from one point to another on the side
/// `side` of it, when they are within `least` and `most`; with the nearest places at both ends. `None` where this
/// shows nothing. `near` is a place to begin at.
pub(crate) fn distances(
    curve: &Tabcyl,
    side: f64,
    [a, b]: [Vec2; 2],
    [least, most]: [f64; 2],
    near: &Spot,
) -> Option<([f64; 2], [Spot; 2])> {
    if least <= 0.0 || curve.sign_at(a) != Some(side) {
        return None;
    }
    let first = foot(curve, a, near.chart, near.at[0])?;
    let last = foot(curve, b, first.chart, first.x)?;
    let way = Way::new(a, b, first.p)?;
    let low = nearest(curve, &way, [least, most])?;
    let high = farthest(curve, &way, [first, last], most, HALVES)?;
    let spot = |at: At| Spot { chart: at.chart, at: [at.x, 0.0] };
    Some(([low, high], [spot(first), spot(last)]))
}

impl Way {
    /// `None` where the points are one.
    fn new(from: Vec2, to: Vec2, curve: Vec2) -> Option<Self> {
        let length = (to - from).norm();
        let along = (to - from) / length;
        let square = Vec2::new(-along.y, along.x);
        let square = if square.dot(&(curve - from)) < 0.0 { -square } else { square };
        (length > 0.0 && along.norm().is_finite()).then_some(Self { from, along, square, length })
    }

    fn at(&self, t: f64) -> Vec2 {
        self.from + self.along * (t * self.length)
    }
}

/// The place into which one of the curve runs downhill towards `p`, inside of the curve.
fn foot(curve: &Tabcyl, p: Vec2, chart: usize, x: f64) -> Option<At> {
    let (mut chart, mut x) = (chart, x);
    for _ in 0..ROUNDS {
        let span = curve.flat(chart)?;
        let [c, d, dd] = span.jet(x);
        let away = c - p;
        let bend = d.norm_squared() + away.dot(&dd);
        let step = -away.dot(&d) / bend;
        if bend <= 0.0 || !step.is_finite() {
            return None;
        }
        let next = x + step.clamp(-span.length, span.length);
        let done = step.abs() <= 1e-12 * span.length;
        if next < 0.0
            && let Some(before) = curve.before(chart)
        {
            chart = before;
            x = (curve.flat(chart)?.length + next).max(0.0);
        } else if next > span.length
            && let Some(after) = curve.after(chart)
        {
            chart = after;
            x = (next - span.length).min(curve.flat(chart)?.length);
        } else {
            x = next.clamp(0.0, span.length);
        }
        if done {
            break;
        }
    }
    Some(At { chart, x, p: curve.flat(chart)?.jet(x)[0] })
}

/// No point of the curve is nearer to the way than this, which is at least `least`; what is farther than `most` counts
/// as there.
fn nearest(curve: &Tabcyl, way: &Way, [least, most]: [f64; 2]) -> Option<f64> {
    let middle = way.at(0.5);
    let within = 0.5 * way.length + most;
    let mut low = most;
    let mut seen = 0;
    for chart in curve.about(middle, within) {
        let span = curve.flat(chart)?;
        let up = Cubic::of(&span, way.from, way.square);
        let ahead = Cubic::of(&span, way.from, way.along);
        let mut stack = Pile::<(f64, f64, u32), 32>::new();
        stack.push((0.0, span.length, 0));
        while let Some((x0, x1, depth)) = stack.pop() {
            seen += 1;
            let [h0, h1] = up.range(x0, x1);
            let beside = h0.max(-h1);
            let [w0, w1] = ahead.range(x0, x1);
            // Beyond the ends of the way their distance counts.
            let before = if w1 <= BESIDE * way.length { Some((way.from, w1)) } else { None };
            let behind =
                (w0 >= (1.0 - BESIDE) * way.length).then(|| (way.at(1.0), way.length - w0));
            let mut far = beside.max(w0 - way.length).max(-w1);
            if far < least
                && let Some((end, over)) = before.or(behind)
            {
                far = far.max(from_point(&span, end, x0, x1) - over.max(0.0));
            }
            if far >= least {
                low = low.min(far);
                continue;
            }
            if depth >= DEPTH || seen > MOST {
                return None;
            }
            // The ends of the way part what is seen square to it from the rest.
            let ends = [0.0, way.length].map(|w| ahead.crossing(w, x0, x1));
            let inner = |x: &f64| *x > x0 && *x < x1;
            let cut = ends.into_iter().flatten().find(inner).unwrap_or(0.5 * (x0 + x1));
            if !(stack.push((x0, cut, depth + 1)) && stack.push((cut, x1, depth + 1))) {
                return None;
            }
        }
    }
    Some(low)
}

/// A distance below which no point of a span between two places is from `p`.
fn from_point(span: &Flat, p: Vec2, x0: f64, x1: f64) -> f64 {
    let half = 0.5 * (x1 - x0);
    let middle = 0.5 * (x0 + x1);
    let [c, d, dd] = span.jet(middle);
    let (bend, jump) = (dd.norm(), 6.0 * span.a.abs() * half);
    let bend = bend + jump;
    let speed = d.norm() + bend * half;
    let reach = (c - p).norm() + speed * half;
    // Half the second derivative of the square of the distance: the tangent of a convex function lies below it.
    let convex = 1.0 - bend * reach > 0.0;
    let mut best = (c - p).norm() - speed * half;
    if convex {
        let rate = |x: f64| {
            let [c, d, dd] = span.jet(x);
            let away = c - p;
            (away.norm_squared(), away.dot(&d), d.norm_squared() + away.dot(&dd), away)
        };
        let mut x = middle;
        for _ in 0..4 {
            let (_, slope, bend, _) = rate(x);
            x = (x - slope / bend).clamp(x0, x1);
        }
        let (square, slope, _, away) = rate(x);
        let tangent = square + 2.0 * (slope * (x0 - x)).min(slope * (x1 - x));
        best = best.max(tangent.max(0.0).sqrt());
        if let Some(m) = away.try_normalize(0.0) {
            best = best.max(Cubic::of(span, p, m).range(x0, x1)[0]);
        }
    }
    best
}

/// No point of the way is farther from the curve than this, which is at most `most`.
///
/// Points of the curve seen from the way in one direction, as far as they go without a gap, are so far from it at
/// most as the farthest of them: square to the way, and beyond the feet of its ends in the directions of these.
fn farthest(curve: &Tabcyl, way: &Way, [a, b]: [At; 2], most: f64, halves: u32) -> Option<f64> {
    let from = |at: &At, end: Vec2| (at.p - end).norm();
    let ends = from(&a, way.from).max(from(&b, way.at(1.0)));
    if ends > most {
        return None;
    }
    // One place may be near enough to all of the way.
    let fixed = |at: &At| from(at, way.from).max(from(at, way.at(1.0)));
    let fixed = fixed(&a).min(fixed(&b));
    if fixed <= most {
        return Some(fixed);
    }
    let slack = BESIDE * way.length;
    let seen = |m: Vec2, at: &At| {
        let w = at.p - way.from;
        let r = w.dot(&way.square) / m.dot(&way.square);
        (way.along.dot(&w) - r * way.along.dot(&m), r)
    };
    let cover = || -> Option<f64> {
        let (begin, _) = seen(way.square, &a);
        let (end, _) = seen(way.square, &b);
        let mut high = ends + slack;
        high = high.max(curve.greatest(way, way.square, [&a, &b])?);
        if begin > slack {
            let m = (a.p - way.from).try_normalize(0.0)?;
            let until = curve.between([&a, &b], 1.3 * begin / (end - begin))?;
            (seen(m, &until).0 >= begin).then_some(())?;
            high = high.max(curve.greatest(way, m, [&a, &until])?);
        }
        if end < way.length - slack {
            let m = (b.p - way.at(1.0)).try_normalize(0.0)?;
            let until = curve.between([&b, &a], 1.3 * (way.length - end) / (end - begin))?;
            (seen(m, &until).0 <= end).then_some(())?;
            high = high.max(curve.greatest(way, m, [&until, &b])?);
        }
        (high <= most).then_some(high)
    };
    if let Some(high) = cover() {
        return Some(high);
    }
    (halves > 0).then_some(())?;
    let middle = way.at(0.5);
    let m = foot(curve, middle, a.chart, a.x)?;
    let half = |from: Vec2, to: Vec2, ends: [At; 2]| {
        farthest(curve, &Way::new(from, to, ends[0].p)?, ends, most, halves - 1)
    };
    Some(half(way.from, middle, [a, m])?.max(half(middle, way.at(1.0), [m, b])?))
}

impl Tabcyl {
    /// The greatest distance of the curve from the way in the direction `m`, between two places.
    fn greatest(&self, way: &Way, m: Vec2, ends: [&At; 2]) -> Option<f64> {
        let [a, b] = ends;
        let by = self.ahead(a.chart, b.chart);
        let [a, b] = if by > 0 || by == 0 && a.x <= b.x { [a, b] } else { [b, a] };
        let lean = m.dot(&way.square);
        let by = by.unsigned_abs();
        if lean <= 0.1 || by > DEPTH as usize {
            return None;
        }
        let mut most = f64::NEG_INFINITY;
        let mut chart = a.chart;
        for i in 0..=by {
            let span = self.flat(chart)?;
            let x0 = if i == 0 { a.x } else { 0.0 };
            let x1 = if i == by { b.x } else { span.length };
            chart = self.after(chart).unwrap_or(chart);
            let [least, greatest] = Cubic::of(&span, way.from, way.square).range(x0, x1);
            if least <= 0.0 {
                return None;
            }
            most = most.max(greatest / lean);
        }
        Some(most)
    }

    /// The place about a share of the curve from one to another; the other one from 1 on.
    fn between(&self, [a, b]: [&At; 2], share: f64) -> Option<At> {
        if share.is_nan() || share >= 1.0 {
            return Some(*b);
        }
        if a.chart == b.chart {
            let x = a.x + share.max(0.0) * (b.x - a.x);
            return Some(At { chart: a.chart, x, p: self.flat(a.chart)?.jet(x)[0] });
        }
        // A joint on the way; the other place from the last on.
        let up = self.ahead(a.chart, b.chart) > 0;
        let (chart, x) = if up { (self.after(a.chart)?, 0.0) } else { (a.chart, 0.0) };
        let p = self.flat(chart)?.jet(x)[0];
        let whole = (b.p - a.p).norm();
        if (p - a.p).norm() >= share * whole { Some(At { chart, x, p }) } else { Some(*b) }
    }
}

impl Cubic {
    /// How far a span lies from `p` in the direction `m`.
    fn of(span: &Flat, p: Vec2, m: Vec2) -> Self {
        let (l, chord) = (span.length, span.chord);
        let left = m.dot(&Vec2::new(-chord.y, chord.x));
        let lean = span.a * l * l + span.b * l;
        let c1 = m.dot(&chord) - left * lean;
        Self([m.dot(&(span.start - p)), c1, left * span.b, left * span.a])
    }

    fn at(&self, x: f64) -> f64 {
        let [c0, c1, c2, c3] = self.0;
        c0 + x * (c1 + x * (c2 + x * c3))
    }

    /// Least and greatest value between two places.
    fn range(&self, x0: f64, x1: f64) -> [f64; 2] {
        let [_, c1, c2, c3] = self.0;
        let (a, b) = (self.at(x0), self.at(x1));
        let mut range = [a.min(b), a.max(b)];
        let root = c2 * c2 - 3.0 * c3 * c1;
        if root >= 0.0 {
            let q = -(c2 + root.sqrt().copysign(c2));
            for x in [q / (3.0 * c3), c1 / q] {
                if x > x0 && x < x1 {
                    let inner = self.at(x);
                    range = [range[0].min(inner), range[1].max(inner)];
                }
            }
        }
        range
    }

    /// A place between two where the value is `w`, when it has another sign beside it at both.
    fn crossing(&self, w: f64, x0: f64, x1: f64) -> Option<f64> {
        let (mut a, mut b) = ((x0, self.at(x0) - w), (x1, self.at(x1) - w));
        (a.1 * b.1 < 0.0).then_some(())?;
        let mut x = 0.5 * (x0 + x1);
        for _ in 0..6 {
            x = a.0 - a.1 * (b.0 - a.0) / (b.1 - a.1);
            let f = self.at(x) - w;
            *(if f * a.1 > 0.0 { &mut a } else { &mut b }) = (x, f);
        }
        Some(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Fit, Knot, Tabcyl as Form, Vec3};
    use proptest::prelude::*;

    /// Distance of a point from the curve: the least over many places, each brought down by ternary search.
    fn distance(curve: &Tabcyl, p: Vec2) -> f64 {
        const PIECES: u32 = 60;
        let mut best = f64::INFINITY;
        let mut chart = 0;
        while let Some(span) = curve.flat(chart) {
            let far = |x: f64| (span.jet(x)[0] - p).norm();
            let step = span.length / f64::from(PIECES);
            for i in 0..PIECES {
                let (mut a, mut b) = (step * f64::from(i), step * f64::from(i + 1));
                if far(0.5 * (a + b)) > best + 2.0 * step {
                    continue;
                }
                for _ in 0..60 {
                    let (x, y) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
                    if far(x) < far(y) { b = y } else { a = x }
                }
                best = best.min(far(0.5 * (a + b)));
            }
            chart += 1;
        }
        best
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(600))]
        #[test]
        fn bounds_hold_where_sampled(
            heights in prop::array::uniform7(-6.0_f64..6.0), radius in 0.05_f64..6.0, band in 1e-4_f64..0.5,
            chart in 1_usize..6, length in 0.05_f64..6.0, tilt in -0.05_f64..0.05, right in any::<bool>(),
        ) {
            let knot = |(i, y): (usize, &f64)| Knot { point: Vec2::new(5.0 * i as f64, *y), tangent: None };
            let knots: Vec<Knot> = heights.iter().enumerate().map(knot).collect();
            let own = |e: Vec3| e * e.transpose();
            let axes = own(Vec3::x()) + own(Vec3::y()) + own(Vec3::z());
            let form = Form::fit(&knots, Fit::Spline, axes, 20.0);
            let Ok(form) = form else { return Ok(()) };
            let curve = Tabcyl::new(&form).unwrap();
            let side = if right { -1.0 } else { 1.0 };
            // A centre beside the curve, and a way about along it.
            let [p, d, _] = curve.flat(chart).unwrap().jet(0.0);
            let along = d.normalize();
            let left = Vec2::new(-along.y, along.x);
            let from = p + left * (side * radius);
            let to = from + (along + left * tilt) * length;
            let band = band.min(radius);
            let limits = [radius - 0.5 * band, radius + 0.5 * band];
            let gaps: Vec<f64> = (0..=40).map(|i| distance(&curve, from + (to - from) * (f64::from(i) / 40.0))).collect();
            let low = gaps.iter().copied().fold(f64::INFINITY, f64::min);
            let high = gaps.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let spot = Spot { chart, at: [0.0; 2] };
            let found = distances(&curve, side, [from, to], limits, &spot);
            if let Some(([least, most], _)) = found {
                prop_assert!(least <= low + 1e-9 && most >= high - 1e-9, "{least} {low} {high} {most}");
                prop_assert!(least >= limits[0] && most <= limits[1]);
            }
            // Within the limits by a tenth of them it is shown where the nearest place is that beside which it begins.
            let room = 0.1 * band;
            let first = foot(&curve, from, chart, 0.0);
            let last = first.and_then(|f| foot(&curve, to, f.chart, f.x));
            let own = |at: Option<At>, p: Vec2, far: f64| at.is_some_and(|at| (at.p - p).norm() < far + 1e-9);
            let nearest = own(first, from, gaps[0]) && own(last, to, gaps[40]) && curve.sign_at(from) == Some(side);
            if low > limits[0] + room && high < limits[1] - room && length < radius && nearest {
                prop_assert!(found.is_some(), "{low} {high} {limits:?} {first:?} {last:?}");
            }
        }
    }
}
