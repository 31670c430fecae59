//! Bounds of the gap along a cut vector, the tool inside a convex solid.
//!
//! The gap is h(C, m) - m . p at the worst tool point p and direction m, so for a tool that moves without
//! turning it is concave in t: nowhere less than at the lesser end. From above any unit m proves
//! `g(t) <= h(C, m) - h(T, m) - t m.v`.
//!
//! A hollow that is open along the tool axis `ta` has the tangent planes of the solid whose m does not look
//! up the axis: all of the above holds with these m alone.

use aptc_geometry::{Vec2, Vec3, trig};

use crate::between::{bulge, parabola};
use crate::bound::{Bound, CLOSE, Touch};
use crate::pile::Pile;
use crate::rings;
use crate::solid::{Solid, Supported, any_across};
use crate::tool::{Pose, Tool, Turn, carry};

/// A direction may look up the axis by so much and still count as square to it.
const LEVEL: f64 = 1e-12;

/// A convex solid as it is seen from within.
pub(crate) trait Walls: Supported {
    /// Greatest `|m . ta|` over its normals m at most.
    fn steepest(&self, _ta: Vec3) -> f64 {
        1.0
    }

    /// Gap from below and from above over the directions m with `m . ta <= up`, and where it is least.
    fn nearest(&self, tool: &Tool<'_>, pose: &Pose, up: Option<f64>) -> (f64, f64, Vec3);
}

impl Walls for Solid {
    fn steepest(&self, ta: Vec3) -> f64 {
        match self {
            Self::Rod(_, t, _) => ta.cross(t).norm(),
            Self::Nappe(_, t, cos, sin) => cos * ta.cross(t).norm() + sin * ta.dot(t).abs(),
            Self::Half(_) | Self::Ball(..) => 1.0,
        }
    }

    fn nearest(&self, tool: &Tool<'_>, pose: &Pose, up: Option<f64>) -> (f64, f64, Vec3) {
        nearest(tool, pose, self, up)
    }
}

/// Gap at a position, from below and from above, and the direction in which it is least.
pub(crate) fn gap(
    tool: &Tool<'_>,
    pose: &Pose,
    solid: &impl Walls,
    open: bool,
) -> (f64, f64, Vec3) {
    solid.nearest(tool, pose, open.then_some(0.0))
}

/// The same over the directions m with `m . ta <= up`.
fn nearest(tool: &Tool<'_>, pose: &Pose, solid: &Solid, up: Option<f64>) -> (f64, f64, Vec3) {
    match (solid, up) {
        (Solid::Half(plane), _) => {
            let g = plane.d - tool.height(pose, plane.n);
            (g, g, plane.n)
        }
        (Solid::Ball(c, r), None) => {
            let (far, m) = tool.farthest_from(pose, *c);
            (r - far, r - far, m)
        }
        (Solid::Ball(c, r), Some(up)) => {
            let (far, m) = tool.farthest_below(pose, *c);
            // Directions that look up the axis a little are nearly level: they reach little farther than level ones.
            let off = pose.te - c;
            let level = (off - pose.ta * off.dot(&pose.ta)).norm() + tool.widest();
            let more = up * (off.norm() + tool.reach());
            (r - far.max(level + more), r - far, m)
        }
        (Solid::Rod(_, t, _) | Solid::Nappe(_, t, ..), _) => around(tool, pose, solid, *t, up),
    }
}

/// The least of `h(C, m) - h(T, m)` over the normals m of a surface of revolution, which form a circle.
///
/// On a sector from m0 to m1 of less than half a turn `m = a m0 + b m1 - (a + b - 1) tilt`, so that the tool reaches
/// no farther from the axis than the sinusoid through `h(C, m0) + k` and `h(C, m1) + k`, less k, with `k = h(C, -tilt)`: where
/// one edge of the tool is next to the wall, that is what it does.
fn around(
    tool: &Tool<'_>,
    pose: &Pose,
    solid: &Solid,
    axis: Vec3,
    up: Option<f64>,
) -> (f64, f64, Vec3) {
    /// Sectors to begin with, each at most a quarter.
    const SECTORS: u32 = 4;
    /// Divisions of a sector at most, and of all of them: a tool that stands nearly along the axis in the middle is
    /// nearly as far from the wall all around.
    const DEPTH: u32 = 60;
    const MOST: u32 = 4_000;
    let e1 = any_across(axis);
    let e2 = axis.cross(&e1);
    let (origin, tilt, flat, radius) = match solid {
        Solid::Rod(q, _, r) => (*q, Vec3::zeros(), 1.0, *r),
        Solid::Nappe(q, t, cos, sin) => (*q, -*sin * *t, *cos, 0.0),
        Solid::Half(_) | Solid::Ball(..) => (Vec3::zeros(), Vec3::zeros(), 1.0, 0.0),
    };
    let normal = |to: Vec2| flat * (to.x * e1 + to.y * e2) + tilt;
    let from_axis = |m: Vec3| tool.height(pose, m) - m.dot(&origin);
    let w = pose.te - origin;
    if let (Solid::Rod(q, t, r), None) = (solid, up)
        && let Some((far, m)) = rings::reach(tool, pose, *q, *t)
    {
        // The whole of a corner's circle may reach farther than the tool.
        let found = from_axis(m);
        if far - found <= 1e-13 * (w.norm() + tool.reach()) {
            return (r - far.max(found), r - found, m);
        }
    }
    let Some((from, turn)) = allowed(flat * e1, flat * e2, tilt, pose.ta, up) else {
        return (f64::INFINITY, f64::INFINITY, -pose.ta);
    };
    let whole = turn >= std::f64::consts::TAU;
    let kept = from_axis(-tilt).max(0.0);
    let lifted = |to: Vec2| from_axis(normal(to)) + kept;
    let off = Vec2::new(w.dot(&e1), w.dot(&e2));
    let close = 1e-13 * (flat * (off.norm() + tool.reach()));
    // Of a tool along the axis the same edge looks in every direction: it is farthest out where the tool is off the axis.
    let off = off.try_normalize(0.0).unwrap_or(Vec2::x());
    let out = lifted(off);
    let cap = out + 2.0 * axis.cross(&pose.ta).norm() * tool.reach();
    if cap <= out + close && whole {
        return (radius + kept - cap, radius + kept - out, normal(off));
    }
    // All around the sectors begin at the side on which the tool stands: about there it reaches farthest.
    let border = |i: u32| {
        if whole {
            let side = Vec2::new(-off.y, off.x);
            return [off, side, -off, -side][i as usize % 4];
        }
        let angle = from + f64::from(i) * (turn / f64::from(SECTORS));
        let (s, c) = trig::sin_cos(angle);
        Vec2::new(c, s)
    };
    let mut stack = Pile::<_, 72>::new();
    let mut a = border(0);
    let mut ha = lifted(a);
    let (mut best, mut best_to) = (ha, a);
    for i in 1..=SECTORS {
        let b = border(i);
        let hb = lifted(b);
        if hb > best {
            (best, best_to) = (hb, b);
        }
        stack.push((a, ha, b, hb, 0));
        (a, ha) = (b, hb);
    }
    let (mut top, mut seen) = (best, 0);
    while let Some((a, ha, b, hb, depth)) = stack.pop() {
        let s = a.perp(&b);
        let bend = 0.5 * (b - a).norm_squared();
        // How steeply the sinusoid begins and ends; its crest lies in the direction `fall a + rise b`.
        let (rise, fall) = ((hb - ha + ha * bend) / s, (ha - hb + hb * bend) / s);
        let crests = rise > 0.0 && fall > 0.0;
        if !crests {
            continue;
        }
        seen += 1;
        let most = (ha * ha + rise * rise).sqrt();
        if most <= best + close || depth >= DEPTH || seen > MOST {
            top = top.max(most);
            continue;
        }
        let share = (rise / (rise + fall)).clamp(0.1, 0.9);
        let m = (a + (b - a) * share).normalize();
        let hm = lifted(m);
        if hm > best {
            (best, best_to) = (hm, m);
        }
        stack.push((a, ha, m, hm, depth + 1));
        stack.push((m, hm, b, hb, depth + 1));
    }
    (radius + kept - top.min(cap).max(best), radius + kept - best, normal(best_to))
}

/// The angles at which `c e1 + s e2 + tilt` does not look up the axis by more than `up`: the first and how
/// far they go on; `None` when there are none.
pub(crate) fn allowed(
    e1: Vec3,
    e2: Vec3,
    tilt: Vec3,
    ta: Vec3,
    up: Option<f64>,
) -> Option<(f64, f64)> {
    const TURN: f64 = std::f64::consts::TAU;
    let Some(up) = up else { return Some((0.0, TURN)) };
    let (x, y) = (e1.dot(&ta), e2.dot(&ta));
    let size = trig::hypot(x, y);
    let most = up + LEVEL - tilt.dot(&ta);
    if most >= size {
        return Some((0.0, TURN));
    }
    if most < -size {
        return None;
    }
    let half = trig::atan2(((size - most) * (size + most)).sqrt(), most);
    Some((trig::atan2(y, x) + half, TURN - 2.0 * half))
}

/// Bounds along the vector from `a` to `b`, axis fixed.
pub(crate) fn bound(tool: &Tool<'_>, a: &Pose, b: &Pose, solid: &impl Walls, open: bool) -> Bound {
    let v = b.te - a.te;
    let at = |t: f64| gap(tool, &Pose { te: a.te + t * v, ta: a.ta }, solid, open);
    let (first, last) = (at(0.0), at(1.0));
    let (low, low_at) = if first.0 <= last.0 { (first.0, 0.0) } else { (last.0, 1.0) };
    // Any direction bounds the gap from above; the best is square to the motion.
    let mut high = f64::INFINITY;
    let mut high_at = 0.0;
    let mut offer = |m: Vec3, t: f64| {
        let start = solid.support(m) - tool.height(a, m);
        let most = start + (-m.dot(&v)).max(0.0);
        if most < high {
            (high, high_at) = (most, t);
        }
        high
    };
    offer(first.2, 0.0);
    offer(last.2, 1.0);
    let mut seen = first.0.max(last.0);
    let (mut t0, mut t1, mut f0, mut f1) = (0.0, 1.0, -first.2.dot(&v), -last.2.dot(&v));
    if f0 > 0.0 && f1 < 0.0 {
        for round in 0..40 {
            let secant = t0 - f0 * (t1 - t0) / (f1 - f0);
            let t = if round % 3 == 2 || !(t0..=t1).contains(&secant) {
                0.5 * (t0 + t1)
            } else {
                secant
            };
            let m = at(t);
            let slope = -m.2.dot(&v);
            let square = solid.bounded_direction(m.2 - v * (m.2.dot(&v) / v.norm_squared()));
            if !open || square.dot(&a.ta) <= LEVEL {
                offer(square, t);
            }
            seen = seen.max(m.0);
            let apart = offer(m.2, t) - seen;
            if apart <= CLOSE * (tool.reach() + v.norm()) || t1 - t0 <= 1e-15 {
                break;
            }
            if slope > 0.0 {
                (t0, f0) = (t, slope);
            } else {
                (t1, f1) = (t, slope);
            }
        }
    }
    Bound { low, high, least: first.1.min(last.1), low_at, high_at }
}

/// Bounds along the vector from `a` to `b` when the axis turns by `turn`. From below each direction has its own
/// straight line but for what the tool rises while it turns, which is no more than for the direction that looks most along
/// the axis. From above the depth of a point is concave along the chord of its way. `ends` is what is known at both
/// ends of all directions.
pub(crate) fn bound_turning(
    tool: &Tool<'_>,
    [a, b]: [&Pose; 2],
    solid: &impl Walls,
    open: bool,
    turn: &Turn,
    ends: [Option<Touch>; 2],
) -> Bound {
    // What does not look up the axis on the way looks up it at either end by no more than its turn.
    let up = open.then(|| (a.ta - b.ta).norm());
    let at = |pose: &Pose, known: Option<Touch>| match known.filter(|_| !open) {
        Some(Touch { low, high, m, .. }) => (low, high, m),
        None => solid.nearest(tool, pose, up),
    };
    let (first, last) = (at(a, ends[0]), at(b, ends[1]));
    let steep = solid.steepest(a.ta).max(solid.steepest(b.ta));
    let lever = (tool.widest() + steep * tool.tallest()).min(tool.reach());
    let low = -parabola(-first.0, -last.0, turn.rise(lever, turn.angle * tool.reach()));
    let low_at = if first.0 <= last.0 { 0.0 } else { 1.0 };
    let carried = |from: &Pose, to: &Pose, m: Vec3| {
        let p = tool.farthest(from, m);
        let ends = [-m.dot(&p), -m.dot(&carry(from, to, p))];
        solid.support(m) + parabola(ends[0], ends[1], bulge((p - from.te).norm(), turn.angle))
    };
    let mut high = f64::INFINITY;
    // A direction level with the tool at one end looks up its axis at the other: it is laid down.
    let level = |m: Vec3| {
        let laid = [a.ta, b.ta].iter().fold(m, |m, ta| m - ta * m.dot(ta).max(0.0));
        if open { solid.bounded_direction(laid) } else { m }
    };
    for m in [first.2, last.2, solid.bounded_direction(first.2 + last.2)].map(level) {
        if !open || m.dot(&a.ta).max(m.dot(&b.ta)) <= LEVEL {
            high = high.min(carried(a, b, m)).min(carried(b, a, m));
        }
    }
    let high_at = if first.1 >= last.1 { 0.0 } else { 1.0 };
    Bound { low, high, least: first.1.min(last.1), low_at, high_at }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Cutter, Profile};

    fn up(lean: f64) -> Vec3 {
        Vec3::new(lean, 0.0, 1.0).normalize()
    }

    /// Of a sphere of radius 40 about the origin, and a cylinder of that radius along y.
    fn hollows() -> [Solid; 2] {
        [Solid::Ball(Vec3::zeros(), 40.0), Solid::Rod(Vec3::zeros(), Vec3::y(), 40.0)]
    }

    #[test]
    fn a_tall_ball_cutter_in_a_bowl_leaves_the_sagitta_of_its_chord() {
        let profile = Profile::new(&Cutter::mill(10.0, 5.0, 127.0)).unwrap();
        let tool = Tool::Solid(&profile);
        let at = |angle: f64| {
            let (s, c) = trig::sin_cos(angle);
            Pose { te: Vec3::new(35.0 * s, 0.0, -35.0 * c - 5.0), ta: Vec3::z() }
        };
        let sagitta = 35.0 * (1.0 - trig::cos(0.1));
        for solid in hollows() {
            let b = bound(&tool, &at(0.3), &at(0.5), &solid, true);
            assert!(b.low.abs() < 1e-9 && (b.high - sagitta).abs() < 1e-9, "{} {}", b.low, b.high);
            // The shank stands beyond the whole of the hollow.
            assert!(gap(&tool, &at(0.3), &solid, false).1 < -45.0);
            // Above the hollow's middle its wall runs straight up.
            let high = Pose { te: Vec3::new(35.0, 0.0, 7.0), ta: Vec3::z() };
            let g = gap(&tool, &high, &solid, true);
            assert!(g.0.abs() < 1e-9 && g.1.abs() < 1e-9, "{} {}", g.0, g.1);
        }
    }

    #[test]
    fn an_axis_that_turns_in_a_bowl_stays_in_its_bounds() {
        let profile = Profile::new(&Cutter::mill(10.0, 1.0, 127.0)).unwrap();
        let tool = Tool::Solid(&profile);
        for solid in hollows() {
            for k in 0..40 {
                let x = 0.7 * f64::from(k);
                let a = Pose { te: Vec3::new(x, 0.5, -20.0), ta: up(0.01 * x) };
                let b = Pose { te: Vec3::new(x + 0.6, 0.3, -20.4), ta: up(0.01 * x + 0.02) };
                let turn = Turn::new((a.ta.cross(&b.ta)).norm());
                let bound = bound_turning(&tool, [&a, &b], &solid, true, &turn, [None; 2]);
                for i in 0..=20 {
                    let t = f64::from(i) / 20.0;
                    let ta = (a.ta + t * (b.ta - a.ta)).normalize();
                    let g = gap(&tool, &Pose { te: a.te + t * (b.te - a.te), ta }, &solid, true);
                    assert!(g.1 >= bound.low - 1e-9 && g.0 <= bound.high + 1e-9, "{k} {t}");
                }
            }
        }
    }

    #[test]
    fn a_tall_tool_that_leans_deep_in_a_cone_is_told_to_the_last_digits() {
        let (diameter, corner_radius, e) = (6.6, 1.0, 2.3);
        let f = corner_radius;
        let cutter =
            Cutter { diameter, corner_radius, e, f, alpha_deg: 0.0, beta_deg: 0.0, height: 20.0 };
        let profile = Profile::new(&cutter).unwrap();
        let (tool, half) = (Tool::Solid(&profile), 0.5_f64.sqrt());
        let cone = Solid::Nappe(Vec3::zeros(), Vec3::z(), half, half);
        for i in 0..40 {
            let lean = 0.012 * f64::from(i);
            let pose = Pose {
                te: Vec3::new(0.12, 0.52, 3.17),
                ta: Vec3::new(0.05 * lean, -lean, 1.0).normalize(),
            };
            let (low, high, _) = gap(&tool, &pose, &cone, false);
            assert!(low <= high && high - low < 1e-11, "{lean} {low} {high}");
        }
    }

    #[test]
    fn an_upright_tool_in_a_round_wall_is_as_far_as_its_edge_reaches() {
        let profile = Profile::new(&Cutter::mill(10.0, 1.0, 50.0)).unwrap();
        let tool = Tool::Solid(&profile);
        let rod = Solid::Rod(Vec3::new(3.0, -2.0, 7.0), Vec3::z(), 40.0);
        for (x, y) in [(30.0, 4.0), (-12.0, 25.0), (0.0, -31.0), (0.0, 0.0)] {
            let te = Vec3::new(3.0 + x, y - 2.0, -60.0);
            for lean in [0.0, 1e-14, 1e-9] {
                let g = gap(&tool, &Pose { te, ta: up(lean) }, &rod, false);
                let far = 40.0 - trig::hypot(x, y) - 5.0;
                let slack = 200.0 * lean + 1e-10;
                assert!((g.0 - far).abs() < slack && (g.1 - far).abs() < slack, "{x} {y} {g:?}");
                assert!(g.0 <= g.1);
            }
        }
    }
}
