//! Curves from outside as rational B-splines, and the surfaces that they make: all exact.

use aptc_geometry::sculpt::{MAX_DEGREE, Vec4, blossom, flat, weighted};
use aptc_geometry::sculptured::BsplineSurface;
use aptc_geometry::{Vec3, trig};

/// Places of a curve, at least, from which the one nearest to a point is looked for, and those of a span.
const LOOKS: usize = 64;
const LOOKS_OF_SPAN: usize = 2;
/// Of these, how many of the nearest are followed.
const FOLLOWED: usize = 4;
/// Steps that make a nearest place exact.
const THIRDS: usize = 30;
const NEWTONS: usize = 6;
/// Places along a span, and along all spans beyond which each gets fewer, though one.
const PLACES_OF_SPAN: usize = 16;
const PLACES: usize = 512;

/// A rational B-spline curve over a part of its parameter's range.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    degree: usize,
    knots: Vec<f64>,
    pub(crate) points: Vec<Vec4>,
    pub(crate) range: [f64; 2],
}

/// Bezier pieces of one degree, each beginning where the one before ends.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    degree: usize,
    /// Parameters where the pieces meet, both ends among them.
    breaks: Vec<f64>,
    /// One more than pieces times degree.
    points: Vec<Vec4>,
}

/// A line that something is turned about.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axis {
    pub(crate) point: Vec3,
    /// Unit direction.
    pub(crate) z: Vec3,
}

/// Control points of an arc of the unit circle by quarters at most, as cosine, sine and weight, the first two multiplied by it;
/// and the angles where the pieces meet.
fn circle([from, to]: [f64; 2]) -> (Vec<[f64; 3]>, Vec<f64>) {
    let quarter = core::f64::consts::FRAC_PI_2;
    let pieces = (1..4).find(|n| (to - from).abs() <= quarter * f64::from(*n) + 1e-9).unwrap_or(4);
    let step = (to - from) / f64::from(pieces);
    let at = |a: f64, w: f64| {
        let (s, c) = trig::sin_cos(a);
        [c, s, w]
    };
    let mut points = vec![at(from, 1.0)];
    let mut breaks = vec![from];
    for k in 0..pieces {
        let end = if k + 1 == pieces { to } else { from + step * f64::from(k + 1) };
        points.push(at(from + step * (f64::from(k) + 0.5), trig::cos(0.5 * step)));
        points.push(at(end, 1.0));
        breaks.push(end);
    }
    (points, breaks)
}

impl Curve {
    /// Of control points with weights, which do not multiply the coordinates; `None` where that is no curve.
    pub(crate) fn new(
        degree: usize,
        knots: Vec<f64>,
        points: &[[f64; 4]],
        range: Option<[f64; 2]>,
    ) -> Option<Self> {
        let n = points.len();
        let rising = knots.windows(2).all(|w| w[0] <= w[1]) && knots.iter().all(|t| t.is_finite());
        let sound = points.iter().all(|p| p.iter().all(|x| x.is_finite()) && p[3] > 0.0);
        let fits = (1..=MAX_DEGREE).contains(&degree) && n > degree;
        if !rising || !sound || !fits || knots.len() != n + degree + 1 {
            return None;
        }
        let all = [knots[degree], knots[n]];
        let range = range.unwrap_or(all);
        let range = range.map(|t| t.clamp(all[0], all[1]));
        let points = points.iter().map(|p| weighted(Vec3::new(p[0], p[1], p[2]), p[3])).collect();
        // Of ends that are no numbers, or too far apart for one, the length is none above zero.
        let length = range[1] - range[0];
        (length > 0.0 && length.is_finite()).then_some(Self { degree, knots, points, range })
    }

    /// The straight line, over 0 to 1.
    pub(crate) fn line(a: Vec3, b: Vec3) -> Self {
        Chain {
            degree: 1,
            breaks: vec![0.0, 1.0],
            points: [a, b].map(|p| weighted(p, 1.0)).to_vec(),
        }
        .curve()
    }

    /// Straight lines from point to point, over 0 to their number.
    pub(crate) fn through(points: &[Vec3]) -> Option<Self> {
        let n = points.len().checked_sub(1).filter(|n| *n > 0)?;
        let breaks = (0..=n).map(|k| k as f64).collect();
        let points = points.iter().map(|p| weighted(*p, 1.0)).collect();
        Some(Chain { degree: 1, breaks, points }.curve())
    }

    /// `center + x cos a + y sin a` over these angles, of which the first is the less; the parameter meets the angle where
    /// its pieces do.
    pub(crate) fn arc(center: Vec3, x: Vec3, y: Vec3, angles: [f64; 2]) -> Self {
        let (points, breaks) = circle(angles);
        let of = |[c, s, w]: [f64; 3]| {
            let p = center * w + x * c + y * s;
            Vec4::new(p.x, p.y, p.z, w)
        };
        Chain { degree: 2, breaks, points: points.into_iter().map(of).collect() }.curve()
    }

    /// The parameter of an [arc](Self::arc) at one of its angles.
    ///
    /// Within a piece from angle a to b, seen from the centre, the parameter s from 0 to 1 has
    /// s / (1 - s) = sin((x - a) / 2) / sin((b - x) / 2), for the middle weight is the cosine of (b - a) / 2.
    pub(crate) fn at_angle(&self, x: f64) -> f64 {
        let breaks = self.breaks(self.range);
        let k = breaks[1..breaks.len() - 1].iter().filter(|b| **b <= x).count();
        let [a, b] = [breaks[k], breaks[k + 1]];
        let [before, behind] = [trig::sin(0.5 * (x - a)), trig::sin(0.5 * (b - x))];
        if x <= a || x >= b { x } else { a + (b - a) * before / (before + behind) }
    }

    /// Straight lines to `other` from places of the same share of the parameter: u along both, 0 to 1, and v from this one to
    /// the other. Where weights differ v does not run evenly along a line.
    pub(crate) fn ruled(&self, other: &Self) -> BsplineSurface {
        // Pieces of both, wherever one of them has a joint.
        let share = |c: &Self, t: f64| (t - c.range[0]) / (c.range[1] - c.range[0]);
        let mut all: Vec<f64> = Vec::new();
        for c in [self, other] {
            all.extend(c.breaks(c.range).iter().map(|t| share(c, *t)));
        }
        all.sort_by(f64::total_cmp);
        all.dedup_by(|a, b| (*a - *b).abs() <= 1e-9);
        let last = all.len() - 1;
        (all[0], all[last]) = (0.0, 1.0);
        let degree = self.degree.max(other.degree);
        let [a, b] = [self, other].map(|c| {
            let [from, to] = c.range;
            let breaks = all.iter().map(|s| from * (1.0 - s) + to * s).collect();
            Chain { breaks: all.clone(), ..c.pieces(breaks).raised(degree) }
        });
        surface(&a, &line(), |i, j| if j == 0 { a.points[i] } else { b.points[i] })
    }

    /// Run through the other way, over the same range.
    pub(crate) fn reversed(&self) -> Self {
        let sum = self.range[0] + self.range[1];
        let mut own = self.clone();
        own.knots = self.knots.iter().rev().map(|t| sum - t).collect();
        own.points.reverse();
        own
    }

    /// The span in which a parameter lies.
    fn span(&self, t: f64) -> usize {
        let (p, n) = (self.degree, self.points.len());
        let (knots, real) = (&self.knots, |k: &usize| self.knots[*k] < self.knots[*k + 1]);
        // The last knot at or before it begins a span that is none only at the end.
        let next = knots[p..n].partition_point(|k| *k <= t);
        (p..p + next).rev().find(real).or_else(|| (p..n).find(real)).unwrap_or(p)
    }

    /// The place of a parameter; of a closed curve all that are whole periods apart are the same.
    pub(crate) fn at(&self, t: f64) -> Vec3 {
        flat(blossom(self.degree, &self.knots, &self.points, self.span(t), |_| t))
    }

    /// The same beyond the ends of a curve that is closed.
    pub(crate) fn around(&self, t: f64, period: f64) -> Vec3 {
        let [from, to] = self.range;
        let over = ((t - from) / period).floor() * period;
        self.at(if t < from || t > to { (t - over).clamp(from, to) } else { t })
    }

    /// How far its control points are apart at most, about.
    pub(crate) fn extent(&self) -> f64 {
        let first = flat(self.points[0]);
        self.points.iter().map(|h| (flat(*h) - first).norm()).fold(0.0, f64::max)
    }

    /// How many spans it has at most.
    pub(crate) fn spans(&self) -> usize {
        self.points.len() - self.degree
    }

    /// The length of a closed curve's parameter.
    pub(crate) fn period(&self) -> Option<f64> {
        let [from, to] = self.range;
        let (a, b, c) = (self.at(from), self.at(to), self.at(0.5 * (from + to)));
        ((a - b).norm() <= 1e-9 * (a - c).norm().max((b - c).norm())).then_some(to - from)
    }

    /// Both ends of a part of the range, and the knots between.
    fn breaks(&self, [from, to]: [f64; 2]) -> Vec<f64> {
        let room = 1e-12 * (self.range[1] - self.range[0]);
        let mut all = vec![from];
        let first = self.knots.partition_point(|t| *t <= from);
        for t in &self.knots[first..] {
            if *t >= to - room {
                break;
            }
            if *t > all[all.len() - 1] + room {
                all.push(*t);
            }
        }
        all.push(to);
        all
    }

    /// Its Bezier pieces between parameters among which are all knots that they enclose.
    fn pieces(&self, breaks: Vec<f64>) -> Chain {
        let p = self.degree;
        let mut points = Vec::with_capacity(p * breaks.len());
        for w in breaks.windows(2) {
            let span = self.span(0.5 * (w[0] + w[1]));
            let skip = usize::from(!points.is_empty());
            let of =
                |i: usize| blossom(p, &self.knots, &self.points, span, |k| w[usize::from(k < i)]);
            points.extend((skip..=p).map(of));
        }
        Chain { degree: p, breaks, points }
    }

    /// Its Bezier pieces over a part of the range.
    fn over(&self, range: [f64; 2]) -> Chain {
        self.pieces(self.breaks(range))
    }

    pub(crate) fn chain(&self) -> Chain {
        self.over(self.range)
    }

    /// The part between two parameters; of a closed curve they may lie beyond its ends, one period apart at most.
    pub(crate) fn part(&self, [a, b]: [f64; 2]) -> Chain {
        let [from, to] = self.range;
        let room = 1e-9 * (to - from);
        let Some(period) = self.period().filter(|_| a < from - room || b > to + room) else {
            return self.over([a.max(from), b.min(to)]);
        };
        let over = ((a + room - from) / period).floor() * period;
        let (a, b) = ((a - over).max(from), b - over);
        if b <= to + room {
            return self.over([a, b.min(to)]);
        }
        let mut first = self.over([a, to]);
        let then = self.over([from, (b - period).min(to)]);
        // A common factor of all weights is no change.
        let same = first.points[first.points.len() - 1].w / then.points[0].w;
        first.points.extend(then.points[1..].iter().map(|h| h * same));
        first.breaks.extend(then.breaks[1..].iter().map(|t| t + period));
        first
    }

    /// The parameter at which what a place of the curve is off is least.
    pub(crate) fn nearest(&self, off: impl Fn(Vec3) -> Vec3) -> f64 {
        let [from, to] = self.range;
        let parts = LOOKS.max(LOOKS_OF_SPAN * self.spans());
        let step = (to - from) / parts as f64;
        let at = |k: usize| if k == parts { to } else { from + step * k as f64 };
        let of = |t: f64| off(self.at(t)).norm_squared();
        let looks: Vec<f64> = (0..=parts).map(|k| of(at(k))).collect();
        let lowest = |k: &usize| {
            (*k == 0 || looks[*k] <= looks[k - 1]) && (*k == parts || looks[*k] <= looks[k + 1])
        };
        let mut starts: Vec<usize> = (0..=parts).filter(lowest).collect();
        starts.sort_by(|a, b| looks[*a].total_cmp(&looks[*b]).then(a.cmp(b)));
        starts.truncate(FOLLOWED);
        let mut found = vec![from, to];
        for k in starts {
            let (mut low, mut high) = (at(k.saturating_sub(1)), at((k + 1).min(parts)));
            found.push(at(k));
            for _ in 0..THIRDS {
                let third = (high - low) / 3.0;
                if of(low + third) <= of(high - third) {
                    high -= third;
                } else {
                    low += third;
                }
            }
            // The last digits by Gauss and Newton: what is off at a place of the curve is nothing.
            let mut t = 0.5 * (low + high);
            found.push(t);
            let h = 1e-4 * step;
            for _ in 0..NEWTONS {
                let (a, b) = ((t - h).max(from), (t + h).min(to));
                let rate = (off(self.at(b)) - off(self.at(a))) / (b - a);
                let by = off(self.at(t)).dot(&rate) / rate.norm_squared();
                if !by.is_finite() {
                    break;
                }
                t = (t - by).clamp(from, to);
            }
            found.push(t);
        }
        // Ends are hit exactly: of equal ones the first.
        found.into_iter().min_by(|a, b| of(*a).total_cmp(&of(*b))).unwrap_or(from)
    }

    /// Parameters from one to another that is greater, both among them and every knot between; beyond the ends of a
    /// closed curve those of its next round.
    pub(crate) fn along(&self, [a, b]: [f64; 2]) -> Vec<f64> {
        let [from, to] = self.range;
        let mut breaks = self.breaks([a, b.min(to)]);
        if b > to {
            let rest = self.breaks([from, from + (b - to)]);
            breaks.extend(rest[1..].iter().map(|t| t + (to - from)));
        }
        let each = (PLACES / breaks.len()).clamp(1, PLACES_OF_SPAN);
        let mut out = vec![a];
        for w in breaks.windows(2) {
            let inner = (1..each).map(|k| w[0] + (w[1] - w[0]) * k as f64 / each as f64);
            out.extend(inner.chain([w[1]]));
        }
        out
    }
}

impl Chain {
    /// Of the parameters where the pieces meet and their control points; coordinates are multiplied by the weights.
    pub(crate) fn of(degree: usize, breaks: Vec<f64>, points: Vec<Vec4>) -> Self {
        debug_assert_eq!(points.len(), degree * (breaks.len() - 1) + 1);
        Self { degree, breaks, points }
    }

    fn knots(&self) -> Vec<f64> {
        let last = self.breaks.len() - 1;
        let times = |k: usize| self.degree + usize::from(k == 0 || k == last);
        let all = self.breaks.iter().enumerate();
        all.flat_map(|(k, t)| core::iter::repeat_n(*t, times(k))).collect()
    }

    pub(crate) fn curve(self) -> Curve {
        let range = [self.breaks[0], self.breaks[self.breaks.len() - 1]];
        Curve { degree: self.degree, knots: self.knots(), points: self.points, range }
    }

    /// Turned about an axis over these angles: u is the angle, where the pieces of 90 degrees at most meet, and v along it.
    pub(crate) fn turned(&self, axis: &Axis, angles: [f64; 2]) -> BsplineSurface {
        let (arc, breaks) = circle(angles);
        let around = Self { degree: 2, breaks, points: Vec::new() };
        surface(&around, self, |i, j| {
            let h = self.points[j];
            let p = flat(h);
            let foot = axis.point + axis.z * (p - axis.point).dot(&axis.z);
            let out = p - foot;
            let [c, s, w] = arc[i];
            let q = (foot * w + out * c + axis.z.cross(&out) * s) * h.w;
            Vec4::new(q.x, q.y, q.z, w * h.w)
        })
    }

    /// The same with control points of a degree that is not less.
    pub(crate) fn raised(&self, degree: usize) -> Self {
        let mut own = self.clone();
        while own.degree < degree {
            let p = own.degree;
            let mut points = vec![own.points[0]];
            for piece in 0..own.breaks.len() - 1 {
                let h = &own.points[p * piece..=p * piece + p];
                points.extend((1..=p).map(|i| h[i].lerp(&h[i - 1], i as f64 / (p + 1) as f64)));
                points.push(h[p]);
            }
            own = Self { degree: p + 1, breaks: own.breaks, points };
        }
        own
    }

    /// Its pieces, four control points each, where they are cubic.
    pub(crate) fn cubics(&self) -> Option<Vec<[Vec4; 4]>> {
        let own = (self.degree <= 3).then(|| self.raised(3))?;
        let piece = |k: usize| core::array::from_fn(|i| own.points[3 * k + i]);
        Some((0..own.breaks.len() - 1).map(piece).collect())
    }

    /// Moved by a vector: u along it and v from 0 to 1 by the vector.
    pub(crate) fn moved(&self, by: Vec3) -> BsplineSurface {
        surface(self, &line(), |i, j| {
            let h = self.points[i];
            if j == 0 { h } else { weighted(flat(h) + by, h.w) }
        })
    }
}

/// The parameter of straight lines, 0 to 1.
fn line() -> Chain {
    Chain { degree: 1, breaks: vec![0.0, 1.0], points: Vec::new() }
}

/// A surface of the parameters of two chains, by control points along u and v.
fn surface(u: &Chain, v: &Chain, point: impl Fn(usize, usize) -> Vec4) -> BsplineSurface {
    let counts = [u, v].map(|c| c.degree * (c.breaks.len() - 1) + 1);
    let mut points = Vec::with_capacity(counts[0] * counts[1]);
    for j in 0..counts[1] {
        for i in 0..counts[0] {
            let h = point(i, j);
            let p = flat(h);
            points.push([p.x, p.y, p.z, h.w]);
        }
    }
    let degree = [u.degree, v.degree];
    BsplineSurface { degree, knots: [u.knots(), v.knots()], counts, points, range: [None; 2] }
}

/// The surface with its parameters exchanged.
pub(crate) fn exchanged(s: BsplineSurface) -> BsplineSurface {
    let [nu, nv] = s.counts;
    let mut points = Vec::with_capacity(s.points.len());
    for i in 0..nu {
        points.extend((0..nv).map(|j| s.points[j * nu + i]));
    }
    let ([p, q], [ku, kv], [ru, rv]) = (s.degree, s.knots, s.range);
    BsplineSurface { degree: [q, p], knots: [kv, ku], counts: [nv, nu], points, range: [rv, ru] }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Raised in degree, exchanged and ruled: the same places.
    #[test]
    fn the_same_curve_of_a_higher_degree() {
        let arc = Curve::arc(Vec3::z(), Vec3::x() * 3.0, Vec3::y() * 2.0, [0.2, 2.9]);
        let chain = arc.chain();
        let raised = chain.raised(5).curve();
        for k in 0..=10 {
            let t = 0.2 + 2.7 * f64::from(k) / 10.0;
            assert!((arc.at(t) - raised.at(t)).norm() < 1e-14);
        }
        assert_eq!(chain.cubics().map(|c| c.len()), Some(2));
        assert!(chain.raised(4).cubics().is_none());
        let other = Curve::line(Vec3::new(4.0, 0.0, 5.0), Vec3::new(-4.0, 1.0, 6.0));
        let ruled = arc.ruled(&other);
        let fitted = |s: &BsplineSurface| aptc_geometry::sculpt::bspline(s).unwrap().0;
        let (s, t) = (fitted(&ruled), fitted(&exchanged(ruled.clone())));
        assert!((s.at(0.0, 0.0).point - arc.at(0.2)).norm() < 1e-14);
        assert!((s.at(0.7, 0.3).point - t.at(0.3, 0.7).point).norm() < 1e-14);
        // Straight up, between places of the same share of the parameter; turned round from end to end.
        for k in 0..=10 {
            let share = f64::from(k) / 10.0;
            let [p, q] = [arc.at(0.2 + 2.7 * share), other.at(share)];
            let middle = s.at(2.0 * share, 0.5).point;
            assert!(((q - p).cross(&(middle - p))).norm() < 1e-13 * (q - p).norm_squared());
            assert!((s.at(2.0 * share, 1.0).point - q).norm() < 1e-13);
        }
        assert!((other.reversed().at(0.7) - other.at(0.3)).norm() < 1e-14);
    }
}
