//! Bounds of the gap along a cut vector, the tool on the outside of a convex solid.
//!
//! The depth of a cut is the length of the shortest way back out.
//!
//! For a tool that moves without turning, g(t) = min over the tool of sd is convex in t, because sd is
//! convex and the tool with its motion is. So g is at most the greater of its ends. From below any unit
//! vector d proves `g(t) >= -h(T, -d) - h(C, d) + t d.v`; the best d is the normal at the contact where
//! d . v = 0, and how it was found does not matter to the proof.

use aptc_geometry::{Plane, Vec3};

use crate::between::{angle, bulge, parabola};
use crate::bound::{Bound, CLOSE, Touch};
use crate::oval::{Nearest, Oval};
use crate::solid::{Solid, Supported, unit_or, without};
use crate::tool::{Pose, Tool, Turn, carry, same, turned};

/// Rounds of the searches for the best direction; reaching them costs tightness, not truth.
const ROUNDS: usize = 60;
/// Sine at which a direction counts as square to the way.
const SQUARE: f64 = 1e-8;

/// A convex solid as it is seen from outside.
pub(crate) trait Outside: Supported {
    /// The gap at a position: its value up to rounding, from above, the direction that proves it and the point of the tool
    /// that has it. `near` is a direction that may be near.
    fn touch(&self, tool: &Tool<'_>, pose: &Pose, near: Option<Vec3>) -> Touch;
}

impl Outside for Oval {
    fn touch(&self, tool: &Tool<'_>, pose: &Pose, near: Option<Vec3>) -> Touch {
        match self.next_to(tool, pose, near) {
            Some(Nearest { gap, n, p, .. }) => Touch { low: gap, high: gap, m: n, p },
            // Nothing is known.
            None => Touch { low: f64::INFINITY, high: f64::INFINITY, m: -pose.ta, p: pose.te },
        }
    }
}

impl Outside for Solid {
    fn touch(&self, tool: &Tool<'_>, pose: &Pose, _near: Option<Vec3>) -> Touch {
        // Of a tool that has `c` at the distance `d` in the direction `n` the point next to it.
        let next = |c: Vec3, d: f64, n: Vec3| c - n * d;
        let (gap, m, p) = match self {
            Self::Half(plane) => {
                let p = tool.farthest(pose, -plane.n);
                (plane.distance(p), plane.n, p)
            }
            Self::Ball(c, r) => {
                let (d, n) = tool.near(pose, *c);
                (d - r, -n, next(*c, d, n))
            }
            Self::Rod(q, t, r) => {
                let (d, n, s) = along_axis(tool, pose, *q, *t, 0.0, f64::NEG_INFINITY);
                (d - r, self.bounded_direction(-n), next(q + s * t, d, n))
            }
            Self::Nappe(v, t, _, sin) => {
                let (d, n, s) = along_axis(tool, pose, *v, *t, *sin, 0.0);
                (d, self.bounded_direction(-n), next(v + s * t, d + s * sin, n))
            }
        };
        Touch { low: gap, high: gap, m, p }
    }
}

/// Least `near(q + s t) - s slope` over s >= least, its direction and s: the solid as the union of balls along its
/// axis. The function is convex in s: Newton's method, held in the bracket that the sign of its slope leaves.
fn along_axis(
    tool: &Tool<'_>,
    pose: &Pose,
    q: Vec3,
    t: Vec3,
    slope: f64,
    least: f64,
) -> (f64, Vec3, f64) {
    /// Slope at which the value is right to the last digit, and rounds: the bracket halves down to rounding in them.
    const LEVEL: f64 = 1e-11;
    const ROUNDS: u32 = 120;
    /// Share of the length in which the least is looked for that values are rounded by.
    const ALIKE: f64 = 1e-14;
    let middle = (pose.te + pose.ta * tool.shoulder() - q).dot(&t);
    let mut s = middle.max(least);
    let (d, n) = tool.near(pose, q + s * t);
    if (n.dot(&t) - slope).abs() <= LEVEL {
        return (d - s * slope, n, s);
    }
    // Beyond twice the distance to the farthest place of interest the function only grows.
    let far = 2.0 * ((pose.te - q).norm() + tool.reach()) / (1.0 - slope).max(0.05);
    let (mut a, mut b) = ((middle - far).max(least), (middle + far).max(least));
    let mut best = (f64::INFINITY, -pose.ta, s, f64::INFINITY);
    // The directions on both sides of the least, with their slopes.
    let mut sides: [Option<(Vec3, f64)>; 2] = [None; 2];
    // The slope two rounds before; halvings that are due, and how many the next time.
    let (mut steep, mut halve, mut halves) = ([f64::INFINITY; 2], 0, 1);
    for _ in 0..ROUNDS {
        let (d, n, change) = tool.bent(pose, q + s * t);
        let (value, rise) = (d - s * slope, n.dot(&t) - slope);
        // Of values alike but for rounding the one counts whose direction proves it best.
        let alike = (value - best.0).abs() <= ALIKE * far;
        let better = if alike { rise.abs() < best.3 } else { value < best.0 };
        if better {
            best = (value, n, s, rise.abs());
        }
        if rise.abs() <= LEVEL || b - a <= 2e-16 * (a.abs() + b.abs()) {
            break;
        }
        *(if rise < 0.0 { &mut a } else { &mut b }) = s;
        sides[usize::from(rise >= 0.0)] = Some((n, rise.abs()));
        let newton = s - rise / change.along(t, t);
        // About an edge of the tool the slope jumps, and the steps would go to and fro across it for ever.
        if halve == 0 && (rise.abs() > 0.5 * steep[0] || !(a..=b).contains(&newton)) {
            (halve, halves) = (halves, 2 * halves);
        }
        steep = [steep[1], rise.abs()];
        s = newton;
        if halve > 0 {
            halve -= 1;
            s = 0.5 * (a + b);
        }
    }
    // At an edge the direction that proves the value lies between those of both sides, level.
    if best.3 > LEVEL
        && let [Some((n, rise)), Some((m, fall))] = sides
    {
        best.1 = unit_or(n * fall + m * rise, best.1);
    }
    (best.0, best.1, best.2)
}

/// What the unit direction `d` proves of the gap along the motion from `pose` by `v`.
fn proved(tool: &Tool<'_>, pose: &Pose, v: Vec3, solid: &impl Supported, d: Vec3) -> f64 {
    debug_assert!((d.norm_squared() - 1.0).abs() < 1e-9, "{d}");
    -tool.height(pose, -d) - solid.support(d) + d.dot(&v).min(0.0)
}

/// The gaps at both ends of a vector along which the axis does not turn, the lesser first: beside a plane they are its bounds.
#[inline]
pub(crate) fn beside_plane(
    tool: &Tool<'_>,
    [a, b]: &[Pose; 2],
    plane: &Plane,
    known: &mut Option<Stood>,
) -> [f64; 2] {
    let gap = |pose: &Pose| -tool.height(pose, -plane.n) - plane.d;
    let first = match known {
        Some(s) if s.at == *a => s.gap,
        _ => gap(a),
    };
    let last = gap(b);
    *known = Some(Stood { at: *b, gap: last, d: plane.n });
    [first.min(last), first.max(last)]
}

/// Bounds along the vector from `a` to `b`, axis fixed, from below no closer than to `enough`. `known` is what is known where
/// the last vector ended, and then of `b`.
pub(crate) fn bound(
    tool: &Tool<'_>,
    [a, b]: &[Pose; 2],
    solid: &impl Outside,
    known: &mut Option<Stood>,
    enough: f64,
) -> Bound {
    let v = b.te - a.te;
    let stand = |pose: &Pose, near: Option<Vec3>| {
        let Touch { low: gap, m: d, .. } = solid.touch(tool, pose, near);
        Stood { at: *pose, gap, d }
    };
    let place = |t: f64, s: &Stood| Place { t, gap: s.gap, d: s.d, slope: s.d.dot(&v) };
    let first = match known {
        Some(s) if same(s.at.te, a.te) && (same(s.at.ta, a.ta) || tool.reach() == 0.0) => {
            place(0.0, s)
        }
        _ => place(0.0, &stand(a, None)),
    };
    let last = place(1.0, known.insert(stand(b, Some(first.d))));
    let (mut least, high) = if first.gap <= last.gap { (first, last) } else { (last, first) };
    let told = |low: f64, least: &Place| {
        let (low_at, high_at) = (least.t, high.t);
        Bound { low, high: high.gap, low_at, high_at, least: least.gap }
    };
    let shown = |d: Vec3| proved(tool, a, v, solid, d);
    // The gap is least at an end, or where its slope changes sign.
    if first.slope >= 0.0 {
        return told(shown(first.d), &least);
    }
    if last.slope <= 0.0 {
        return told(shown(last.d), &least);
    }
    let length = v.norm();
    let enough = enough - CLOSE * (tool.reach() + length);
    // A direction square to the motion proves the same for the whole of it: a normal of a side, or over a vertex any that is
    // bounded.
    let level = |d: Vec3| {
        let is_square = |d: Vec3| d.dot(&v).abs() <= 1e-12 * length;
        if is_square(d) {
            return shown(d);
        }
        let proves = |square: Vec3| shown(if is_square(square) { square } else { d });
        let normal = solid.square_direction(d, v);
        let low = proves(normal);
        if low >= enough {
            return low;
        }
        let other = solid.bounded_direction(without(d, v));
        if same(other, normal) { low } else { low.max(proves(other)) }
    };
    // Between the directions of two places on both sides of the least lies one that is square to the way.
    let between =
        |p: &Place, q: &Place| level(solid.bounded_direction(p.d * q.slope - q.d * p.slope));
    let mut low = between(&first, &last);
    if low >= enough {
        return told(low, &least);
    }
    let (mut p, mut q) = (first, last);
    for round in 0..ROUNDS {
        let secant = p.t - p.slope * (q.t - p.t) / (q.slope - p.slope);
        let halves = round % 3 == 2 || !(p.t..=q.t).contains(&secant);
        let t = if halves { 0.5 * (p.t + q.t) } else { secant };
        let m = place(t, &stand(&Pose { te: a.te + t * v, ta: a.ta }, Some(p.d)));
        if m.gap < least.gap {
            least = m;
        }
        // A direction that is not quite square to the way is made so, and loses the square of what it missed.
        if m.slope.abs() <= SQUARE * length {
            return told(low.max(level(m.d)), &least);
        }
        *(if m.slope < 0.0 { &mut p } else { &mut q }) = m;
        if q.t - p.t <= 1e-15 {
            break;
        }
    }
    // Where the tool changes from one place to another the least is between theirs.
    low = [level(p.d), level(q.d), between(&p, &q)].into_iter().fold(low, f64::max);
    told(low, &least)
}

/// What is known of the tool at a position: the gap and the direction that proves it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stood {
    at: Pose,
    gap: f64,
    d: Vec3,
}

/// The tool at a share of the way: the gap, the direction that proves it and how that rises along the way.
#[derive(Clone, Copy, Debug)]
struct Place {
    t: f64,
    gap: f64,
    d: Vec3,
    slope: f64,
}

/// The gap from below when the direction that proves it turns from one end to the other: second order in the
/// turn also for a flat face that rolls over the solid.
///
/// On the way d the gap is at least `d . (te - o) - h(T, -d) - h(C - o, d)`, the support of the tool taken
/// about its end. The first term bends by `psi^2 |te - o| + 2 psi |v|`. In the tool's own system d goes along
/// its chord but for `(theta + psi)^2 / 8`, and support functions are convex; where the direction turns with
/// the tool, which a ball allows, it stands still there.
fn turning(tool: &Tool<'_>, a: &Pose, b: &Pose, solid: &Solid, d: [Vec3; 2], theta: f64) -> f64 {
    let origin = match solid {
        Solid::Half(_) => return f64::NEG_INFINITY,
        Solid::Ball(o, _) | Solid::Rod(o, ..) | Solid::Nappe(o, ..) => *o,
    };
    let at = |pose: &Pose, d: Vec3| -tool.height(pose, -d) - solid.support(d);
    let across = |te: Vec3| match solid {
        Solid::Rod(_, t, _) => (te - origin) - t * (te - origin).dot(t),
        _ => te - origin,
    };
    let far = across(a.te).norm().max(across(b.te).norm());
    let drift = across(b.te - a.te + origin).norm();
    let bend = |psi: f64| bulge(far, psi) + 0.25 * psi * drift;
    let psi = angle(d[0], d[1]);
    let rise = bend(psi) + bulge(tool.reach(), theta + psi);
    let mut low = -parabola(-at(a, d[0]), -at(b, d[1]), rise);
    if let Solid::Ball(..) = solid {
        for (from, to, d) in [(a, b, d[0]), (b, a, d[1])] {
            let ends = [at(from, d), at(to, turned(from.ta, to.ta, d))];
            low = low.max(-parabola(-ends[0], -ends[1], bend(theta)));
        }
    }
    low
}

/// Bounds along the vector from `a` to `b` when the axis turns by `turn`: each point fixed in the tool keeps to
/// the chord of its way but for its bulge, which vanishes at the ends. `ends` is what is known at both ends. From below no more
/// is asked than `enough`.
pub(crate) fn bound_turning(
    tool: &Tool<'_>,
    [a, b]: [&Pose; 2],
    solid: &Solid,
    turn: &Turn,
    ends: [Option<Touch>; 2],
    enough: f64,
) -> Bound {
    let at =
        |pose: &Pose, known: Option<Touch>| known.unwrap_or_else(|| solid.touch(tool, pose, None));
    let (first, last) = (at(a, ends[0]), at(b, ends[1]));
    let hull = |d: Vec3| -tool.height_turning(a, b, -d, turn).0 - solid.support(d);
    // The direction between both shows most as a rule, and for the rest it is asked only where that is not enough.
    let middle = solid.bounded_direction(first.m + last.m);
    let mut low = hull(middle);
    if low < enough {
        low = low.max(turning(tool, a, b, solid, [first.m, last.m], turn.angle));
    }
    for d in [first.m, last.m] {
        if low < enough {
            low = low.max(hull(d));
        }
    }
    // The distance is convex along the chord.
    let carried = |from: &Pose, to: &Pose, p: Vec3| {
        let ends = [solid.distance(p), solid.distance(carry(from, to, p))];
        parabola(ends[0], ends[1], bulge((p - from.te).norm(), turn.angle))
    };
    let high = carried(a, b, first.p).min(carried(b, a, last.p));
    let (least, low_at) = if first.low <= last.low { (first.low, 0.0) } else { (last.low, 1.0) };
    let high_at = if first.low >= last.low { 0.0 } else { 1.0 };
    Bound { low, high, low_at, high_at, least }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::surface::QuadricSurface;
    use aptc_geometry::{Cutter, Profile, Quadric, QuadricKind, trig};

    /// A leaning tool touches a rod with its flank, an edge or its top: the search over the rod's axis crosses edges.
    #[test]
    fn beside_rods_and_nappes_nothing_of_their_axes_is_nearer_than_what_is_found() {
        for (d, r) in [(4.36, 2.18), (6.0, 0.0), (5.0, 1.0)] {
            let profile = Profile::new(&Cutter::mill(d, r, 20.0)).unwrap();
            let tool = Tool::Solid(&profile);
            for i in 0..400_i32 {
                let (f, lean) = (f64::from(i), 0.1 * f64::from(i % 160));
                let (s, c) = trig::sin_cos(lean.to_radians());
                let (u, w) = trig::sin_cos(f);
                let ta = Vec3::new(s * u, s * w, c);
                let te = Vec3::new(31.0, 6.0 * trig::sin(1.7 * f), 4.4);
                let pose = Pose { te, ta };
                for slope in [0.0, 0.3] {
                    let least = if slope > 0.0 { 0.0 } else { f64::NEG_INFINITY };
                    let t = Vec3::z();
                    let (found, ..) = along_axis(&tool, &pose, Vec3::zeros(), t, slope, least);
                    let at = |s: f64| tool.near(&pose, s * t).0 - s * slope;
                    let sampled =
                        (0..4000).map(|k| at(0.02 * f64::from(k))).fold(f64::MAX, f64::min);
                    assert!(found <= sampled + 1e-12, "{i} {lean} {slope}: {found} {sampled}");
                    assert!(found >= sampled - 0.02, "{i} {lean} {slope}: {found} {sampled}");
                }
                for solid in [
                    Solid::Rod(Vec3::zeros(), Vec3::z(), 25.0),
                    Solid::Nappe(Vec3::zeros(), Vec3::z(), 0.8, 0.6),
                ] {
                    let Touch { low: gap, m: d, .. } = solid.touch(&tool, &pose, None);
                    let low = proved(&tool, &pose, Vec3::zeros(), &solid, d);
                    assert!(low >= gap - 1e-9, "{i} {lean} {solid:?}: {gap} proved {low}");
                }
            }
        }
    }

    /// Least gap along a way, the gap being convex, by thirds.
    fn least(tool: &Tool<'_>, [a, b]: &[Pose; 2], solid: &impl Outside) -> f64 {
        let at = |t: f64| {
            let pose = Pose { te: a.te + t * (b.te - a.te), ta: a.ta };
            solid.touch(tool, &pose, None).low
        };
        let (mut from, mut to) = (0.0, 1.0);
        for _ in 0..80 {
            let (s, t) = ((2.0 * from + to) / 3.0, (from + 2.0 * to) / 3.0);
            (from, to) = if at(s) < at(t) { (from, t) } else { (s, to) };
        }
        at(0.5 * (from + to)).min(at(0.0)).min(at(1.0))
    }

    fn is_told_closely(tool: &Tool<'_>, at: Pose, v: Vec3, solid: &impl Outside) {
        let Touch { low, m, .. } = solid.touch(tool, &at, None);
        let a = Pose { te: at.te - m * (low + 1e-4) - v * 0.5, ..at };
        let way = [a, Pose { te: a.te + v, ..a }];
        let told = bound(tool, &way, solid, &mut None, f64::INFINITY).low;
        let least = least(tool, &way, solid);
        assert!(told <= least + 1e-9 && told >= least - 1e-9, "{told} {least}: {at:?} {v}");
    }

    /// Ways that lean against generators, over the vertex of a cone, with ends that have edges.
    #[test]
    fn the_least_gap_of_a_way_is_told_closely() {
        let form = |c: [f64; 10]| {
            let kind = QuadricKind::Qadric;
            Oval::new(&QuadricSurface::new(&Quadric { kind, c }).unwrap()).unwrap()
        };
        let square = |x: f64| 1.0 / (x * x);
        let ovals = [
            [square(60.0), square(45.0), square(50.0), -1.0],
            [square(60.0), 0.0, square(30.0), -1.0],
        ]
        .map(|[a, b, c, d]| form([a, b, c, d, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]));
        let bowl = form([0.01, 0.02, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5]);
        for corner in [5.0, 2.0, 0.0] {
            let profile = Profile::new(&Cutter::mill(10.0, corner, 60.0)).unwrap();
            let tool = Tool::Solid(&profile);
            for i in 0..60_i32 {
                let f = f64::from(i);
                let v = Vec3::new(trig::sin(f), trig::cos(1.3 * f), 0.2 * trig::sin(2.1 * f));
                let te = Vec3::new(25.0 * trig::sin(1.9 * f), 25.0 * trig::cos(0.7 * f), 80.0);
                let at = Pose { te, ta: Vec3::z() };
                let t = Vec3::new(0.6, 0.7, 0.2).normalize();
                let ball = Solid::Ball(Vec3::zeros(), 40.0);
                let rod = Solid::Rod(Vec3::zeros(), t, 40.0);
                let lying = Solid::Nappe(t * -200.0, t, 0.98, (1.0_f64 - 0.98 * 0.98).sqrt());
                let upright = Solid::Nappe(Vec3::z() * 50.0, -Vec3::z(), 0.8, 0.6);
                for solid in [ball, rod, lying] {
                    is_told_closely(&tool, at, v, &solid);
                }
                // Of an edge that a vertex has gone into no one direction shows the depth.
                if corner > 0.0 {
                    let over = Pose { te: Vec3::new(0.0, 0.0, 80.0), ..at };
                    is_told_closely(&tool, at, v, &upright);
                    is_told_closely(&tool, over, v, &upright);
                }
                ovals.iter().chain([&bowl]).for_each(|oval| is_told_closely(&tool, at, v, oval));
            }
        }
    }
}
