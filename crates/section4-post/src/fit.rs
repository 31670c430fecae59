//! Arcs and helices in place of runs of short lines: the geometry.
//!
//! An arc that replaces a run begins and ends on the run's own ends and stays within the tolerance of every
//! line between them, ends and middles alike, so that path and arc are nowhere farther apart. Lengths have any
//! one unit.

use aptc_geometry::{Vec3, trig};

use crate::machine::ArcPlane;

/// An arc saves nothing over fewer lines than this.
const LEAST_LINES: usize = 3;

/// A point in the frame of a plane: along its two axes, and its height over it.
type Lifted = [f64; 3];

/// What an arc must keep to.
#[derive(Clone, Debug)]
pub(crate) struct Limits {
    /// Greatest distance between arc and lines.
    pub(crate) tolerance: f64,
    /// Heights across the plane that count as one.
    pub(crate) flat: f64,
    /// Least and greatest radius.
    pub(crate) radius: [f64; 2],
    /// Planes that the control has.
    pub(crate) planes: Vec<ArcPlane>,
    /// Has the control helices?
    pub(crate) helix: bool,
}

/// An arc for the first lines of a run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fitted {
    /// Lines that it replaces.
    pub(crate) lines: usize,
    pub(crate) center: Vec3,
    /// Unit normal about which it turns anticlockwise by `sweep`.
    pub(crate) axis: Vec3,
    pub(crate) radius: f64,
    /// Radians, above 0 and at most half a turn.
    pub(crate) sweep: f64,
    /// Greatest distance between arc and lines.
    pub(crate) deviation: f64,
}

/// What becomes of the first lines of a run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Found {
    /// They become an arc.
    Arc(Fitted),
    /// So many of them stay lines.
    Lines(usize),
}

/// The arc for most of the lines from `points[0]` on, in any of the planes.
///
/// Lines stay where no arc takes three of them, and where they are straight to within the tolerance: an arc of
/// almost no curvature would have its centre anywhere. Of a straight run half is given up at once, for its end
/// may belong to the next arc.
pub(crate) fn longest(points: &[Vec3], limits: &Limits) -> Found {
    let mut straight = 0;
    let mut best: Option<Fitted> = None;
    for plane in &limits.planes {
        let ([a, b], _) = plane.axes();
        let n = 3 - a - b;
        let Some(first) = points.first() else { break };
        let level = |p: &&Vec3| (p[n] - first[n]).abs() <= limits.flat;
        // A run that rises from the first line on may be a helix.
        let rises = limits.helix && points.get(1).is_some_and(|p| !level(&p));
        let lifted = |p: &Vec3| [p[a], p[b], p[n]];
        let run: Vec<Lifted> = if rises {
            points.iter().map(lifted).collect()
        } else {
            points.iter().take_while(level).map(lifted).collect()
        };
        let (lines, arc) = most_lines(&run, limits);
        let Some(arc) = arc else {
            straight = straight.max(lines);
            continue;
        };
        if best.as_ref().is_none_or(|f| f.lines < lines) {
            let mut center = *first;
            (center[a], center[b]) = (arc.center[0], arc.center[1]);
            let mut axis = Vec3::zeros();
            axis[n] = if arc.left { 1.0 } else { -1.0 };
            let Flat { radius, sweep, deviation, .. } = arc;
            best = Some(Fitted { lines, center, axis, radius, sweep, deviation });
        }
    }
    best.map_or(Found::Lines((straight / 2).max(1)), Found::Arc)
}

/// An arc in its plane.
#[derive(Clone, Copy, Debug)]
struct Flat {
    center: [f64; 2],
    radius: f64,
    sweep: f64,
    /// Anticlockwise?
    left: bool,
    deviation: f64,
}

/// How an arc takes lines.
#[derive(Clone, Copy, Debug)]
enum Takes {
    /// It does not.
    Not,
    /// It would be no better than a line.
    Straight,
    Arc(Flat),
}

/// The longest run from the first point that an arc takes, or that is straight: doubled while it is, then halved
/// in between.
fn most_lines(p: &[Lifted], limits: &Limits) -> (usize, Option<Flat>) {
    let last = p.len().saturating_sub(1);
    let mut good = (0, None);
    let mut bad = last + 1;
    let mut next = LEAST_LINES;
    while next > good.0 && next < bad {
        match arc(&p[..=next], limits) {
            Takes::Not => bad = next,
            Takes::Straight => good = (next, None),
            Takes::Arc(found) => good = (next, Some(found)),
        }
        next = if bad > last { (2 * next).min(last) } else { usize::midpoint(good.0, bad) };
        if next < LEAST_LINES {
            break;
        }
    }
    good
}

/// An arc from the first to the last point, no more than half a turn, within the tolerance of all lines.
///
/// With the chord of the ends from (-h, 0) to (h, 0) and the centre at (0, -c), a point (x, y) lies off the arc
/// by `sqrt(x^2 + (y+c)^2) - sqrt(h^2 + c^2)`, which grows with c. So each point bounds c from both sides, and
/// where the bounds of all points leave something its middle is taken. The bounds take line ends and middles
/// only; what decides is the exact distance in [`judged`].
fn arc(p: &[Lifted], limits: &Limits) -> Takes {
    let tol = limits.tolerance;
    let (a, b) = (p[0], p[p.len() - 1]);
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let h = trig::hypot(dx, dy) / 2.0;
    if h <= tol {
        return Takes::Not;
    }
    let (u, m) = ([dx / (2.0 * h), dy / (2.0 * h)], middle(a, b));
    let across = |q: Lifted| (q[1] - m[1]) * u[0] - (q[0] - m[0]) * u[1];
    // A path that bulges to the right of its chord turns left.
    let left = across(p[p.len() / 2]) < 0.0;
    let side = if left { -1.0 } else { 1.0 };
    let (mut low, mut high) = (0.0_f64, f64::INFINITY);
    let mut bound = |q: Lifted| {
        let x = (q[0] - m[0]) * u[0] + (q[1] - m[1]) * u[1];
        let y = side * across(q);
        if y > tol {
            low = low.max(depth(x, y, h, -tol));
            high = high.min(depth(x, y, h, tol));
        }
        y >= -tol && x.abs() <= h + tol && low <= high
    };
    for w in p.windows(2) {
        if !bound(middle(w[0], w[1])) || !bound(w[1]) {
            return Takes::Not;
        }
    }
    if high.is_infinite() {
        return straight(p, tol);
    }
    let c = f64::midpoint(low, high);
    let center = [m[0] + side * c * u[1], m[1] - side * c * u[0]];
    match judged(p, center, left).filter(|f| f.deviation <= tol) {
        None => Takes::Not,
        Some(f) => {
            let bulge = f.radius * (1.0 - trig::cos(f.sweep / 2.0));
            let can = (limits.radius[0]..=limits.radius[1]).contains(&f.radius);
            if bulge >= 2.0 * tol && can { Takes::Arc(f) } else { straight(p, 3.0 * tol) }
        }
    }
}

/// A run that lies along one line in space, not only in the plane.
fn straight(p: &[Lifted], tol: f64) -> Takes {
    let (a, b) = (Vec3::from(p[0]), Vec3::from(p[p.len() - 1]));
    let along = (b - a).normalize();
    let off = |q: &Lifted| (Vec3::from(*q) - a).cross(&along).norm();
    if p.iter().all(|q| off(q) <= tol) { Takes::Straight } else { Takes::Not }
}

/// The `c` at which the point lies off the arc by `e`; `y > |e|`.
fn depth(x: f64, y: f64, h: f64, e: f64) -> f64 {
    let q = h * h + e * e - x * x - y * y;
    let d = y * y - e * e;
    (y * q + e * (q * q + 4.0 * h * h * d).sqrt()) / (2.0 * d)
}

/// The arc about a centre with its exact greatest distance from the lines; `None` when they do not go round it
/// one way.
///
/// A helix rises evenly with the angle. A line does not quite: over a step of `s` radians, at most a quarter turn, its
/// height is off by less than `s^2 / 50` of its rise.
fn judged(p: &[Lifted], center: [f64; 2], left: bool) -> Option<Flat> {
    let spoke = |q: Lifted| [q[0] - center[0], q[1] - center[1]];
    let first = spoke(p[0]);
    let radius = trig::hypot(first[0], first[1]);
    let step = |w: &[Lifted]| {
        let (s, t) = (spoke(w[0]), spoke(w[1]));
        let step = trig::atan2(s[0] * t[1] - s[1] * t[0], s[0] * t[0] + s[1] * t[1]);
        if left { step } else { -step }
    };
    let sweep: f64 = p.windows(2).map(step).sum();
    let rise = p[p.len() - 1][2] - p[0][2];
    let (mut turned, mut deviation, mut height) = (0.0, 0.0_f64, 0.0_f64);
    for w in p.windows(2) {
        let step = step(w);
        let climb = w[1][2] - w[0][2];
        if step <= 0.0 || (climb.abs() > 0.0 && step > std::f64::consts::FRAC_PI_2) {
            return None;
        }
        let before = (w[0][2] - p[0][2] - rise * turned / sweep).abs();
        turned += step;
        let after = (w[1][2] - p[0][2] - rise * turned / sweep).abs();
        height = height.max(before.max(after) + climb.abs() * step * step / 50.0);
        let (s, t) = (spoke(w[0]), spoke(w[1]));
        let d = [t[0] - s[0], t[1] - s[1]];
        let length2 = d[0] * d[0] + d[1] * d[1];
        let part = (-(s[0] * d[0] + s[1] * d[1]) / length2).clamp(0.0, 1.0);
        let near = trig::hypot(s[0] + d[0] * part, s[1] + d[1] * part);
        let far = trig::hypot(t[0], t[1]);
        deviation = deviation.max((near - radius).abs()).max((far - radius).abs());
    }
    let deviation = trig::hypot(deviation, height);
    (sweep <= std::f64::consts::PI).then_some(Flat { center, radius, sweep, left, deviation })
}

fn middle(a: Lifted, b: Lifted) -> Lifted {
    [0, 1, 2].map(|i| f64::midpoint(a[i], b[i]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn limits(tolerance: f64) -> Limits {
        let planes = vec![ArcPlane::Xy, ArcPlane::Zx, ArcPlane::Yz];
        Limits { tolerance, flat: 1e-6, radius: [0.01, 1e4], planes, helix: true }
    }

    /// Distance of `q` from the polyline.
    fn off_lines(q: Vec3, lines: &[Vec3]) -> f64 {
        let off = |w: &[Vec3]| {
            let d = w[1] - w[0];
            let t = ((q - w[0]).dot(&d) / d.norm_squared()).clamp(0.0, 1.0);
            (w[0] + d * t - q).norm()
        };
        lines.windows(2).map(off).fold(f64::INFINITY, f64::min)
    }

    /// The place at a part of the way of an arc or helix that replaces the run.
    fn point(f: &Fitted, run: &[Vec3], part: f64) -> Vec3 {
        let (from, to) = (run[0], run[f.lines]);
        let spoke = from - f.center;
        let (s, c) = trig::sin_cos(f.sweep * part);
        f.center + spoke * c + f.axis.cross(&spoke) * s + f.axis * (f.axis.dot(&(to - from)) * part)
    }

    fn fitted(list: &[Vec3]) -> Fitted {
        match longest(list, &limits(0.02)) {
            Found::Arc(f) => f,
            Found::Lines(n) => panic!("{n} lines"),
        }
    }

    #[test]
    fn lines_and_corners_are_no_arcs() {
        let line: Vec<_> = (0..40).map(|i| Vec3::new(f64::from(i), 0.001, 2.0)).collect();
        assert!(matches!(longest(&line, &limits(0.01)), Found::Lines(n) if n > 10));
        let mut bow = line.clone();
        for p in &mut bow {
            // So flat that its centre would be four kilometres away.
            p.y = p.x * (39.0 - p.x) / 8e6;
        }
        assert!(matches!(longest(&bow, &limits(0.01)), Found::Lines(_)));
        let corner: Vec<_> = [(0, 0), (10, 0), (20, 0), (20, 10), (20, 20)]
            .map(|(x, y)| Vec3::new(x.into(), y.into(), 0.0))
            .into();
        assert_eq!(longest(&corner, &limits(0.01)), Found::Lines(1));
    }

    #[test]
    fn chords_of_a_circle_become_it_in_every_plane() {
        for n in 0..3 {
            let mut list = Vec::new();
            for i in 0..=30 {
                let (s, c) = trig::sin_cos(f64::from(i) * 0.1);
                let mut p = Vec3::zeros();
                (p[n], p[(n + 1) % 3], p[(n + 2) % 3]) = (4.0, 10.0 * c, 10.0 * s);
                list.push(p);
            }
            let f = fitted(&list);
            assert!(f.lines == 30 && f.axis[n] > 0.5);
            assert!((f.radius - 10.0).abs() < 0.02 && (f.sweep - 3.0).abs() < 0.01, "{f:?}");
            list.reverse();
            assert!(fitted(&list).axis[n] < -0.5);
        }
    }

    #[test]
    fn chords_of_a_helix_become_it_in_every_plane() {
        for n in 0..3 {
            let mut list = Vec::new();
            for i in 0..=30 {
                let (s, c) = trig::sin_cos(f64::from(i) * 0.1);
                let mut p = Vec3::zeros();
                (p[n], p[(n + 1) % 3], p[(n + 2) % 3]) =
                    (4.0 - f64::from(i) * 0.2, 10.0 * c, 10.0 * s);
                list.push(p);
            }
            let f = fitted(&list);
            assert!(f.lines == 30 && f.axis[n] > 0.5 && f.deviation <= 0.02, "{f:?}");
            // A step in the middle of it is no helix, and where there are none lines remain.
            let mut broken = list.clone();
            for p in &mut broken[15..] {
                p[n] -= 0.1;
            }
            assert!(fitted(&broken).lines < 16);
            let none = Limits { helix: false, ..limits(0.02) };
            assert!(matches!(longest(&list, &none), Found::Lines(_)));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]
        /// Whatever the path, arc and lines are nowhere farther apart than was allowed.
        #[test]
        fn never_farther_than_allowed(
            turn in -0.3..0.3_f64, grow in -0.02..0.02_f64, step in 0.1..2.0_f64,
            climb in prop_oneof![Just(0.0), -0.5..0.5_f64],
            noise in prop::collection::vec((-0.01..0.01_f64, -0.01..0.01_f64), 40), tol in 0.001..0.05_f64,
        ) {
            let (mut p, mut heading) = (Vec3::zeros(), 0.0_f64);
            let mut list = vec![p];
            for (i, (x, y)) in (0..).zip(noise) {
                heading += turn + grow * f64::from(i) * 0.1;
                let (s, c) = trig::sin_cos(heading);
                p += Vec3::new(step * c, step * s, climb);
                list.push(p + Vec3::new(x, y, 0.0));
            }
            let mut at = 0;
            while at + 1 < list.len() {
                let f = match longest(&list[at..], &limits(tol)) {
                    Found::Arc(f) => f,
                    Found::Lines(n) => {
                        at += n;
                        continue;
                    }
                };
                let run = &list[at..=at + f.lines];
                prop_assert!((point(&f, run, 1.0) - run[f.lines]).norm() < 1e-9);
                for k in 0..=400 {
                    let off = off_lines(point(&f, run, f64::from(k) / 400.0), run);
                    prop_assert!(off <= tol + 1e-9, "{off} of {tol}");
                }
                prop_assert!(f.deviation <= tol && f.sweep <= std::f64::consts::PI);
                at += f.lines;
            }
        }
    }
}
