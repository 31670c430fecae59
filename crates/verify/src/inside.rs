//! Bounds of the gap along a cut vector, the tool inside a convex solid.
//!
//! The gap is h(C, m) - m . p at the worst tool point p and direction m, so for a tool that moves without
//! turning it is concave in t: nowhere less than at the lesser end. From above any unit m proves
//! `g(t) <= h(C, m) - h(T, m) - t m.v`.

use aptc_geometry::{Vec3, trig};

use crate::bound::Bound;
use crate::demand::{bulge, parabola};
use crate::pile::Pile;
use crate::solid::{Solid, any_across};
use crate::tool::{Pose, Tool, carry};

/// Gap at a position, from below and from above, and the direction in which it is least.
pub(crate) fn gap(tool: &Tool<'_>, pose: &Pose, solid: &Solid) -> (f64, f64, Vec3) {
    match solid {
        Solid::Half(plane) => {
            let g = plane.d - tool.height(pose, plane.n);
            (g, g, plane.n)
        }
        Solid::Ball(c, r) => {
            let g = r - tool.farthest_from(pose, *c);
            (g, g, ball_direction(tool, pose, *c))
        }
        Solid::Rod(_, t, _) | Solid::Nappe(_, t, ..) => around(tool, pose, solid, *t),
    }
}

/// Unit direction from the centre to the tool point farthest from it, by climbing the support function.
fn ball_direction(tool: &Tool<'_>, pose: &Pose, c: Vec3) -> Vec3 {
    let mut m = crate::solid::unit_or(pose.te - c, -pose.ta);
    for _ in 0..50 {
        let next = crate::solid::unit_or(tool.farthest(pose, m) - c, m);
        if (next - m).norm() < 1e-15 {
            break;
        }
        m = next;
    }
    m
}

/// The least of `h(C, m) - h(T, m)` over the normals m of a surface of revolution, which form a circle. On a
/// sector of half width w about the angle u each tool point gives a sinusoid, whose value is at most that at
/// the better end plus its amplitude times (1/cos w - 1).
fn around(tool: &Tool<'_>, pose: &Pose, solid: &Solid, axis: Vec3) -> (f64, f64, Vec3) {
    /// Sectors to begin with.
    const SECTORS: u32 = 24;
    /// Halvings of a sector at most.
    const DEPTH: u32 = 40;
    let (e1, tilt, flat) = match solid {
        Solid::Nappe(_, t, cos, sin) => (any_across(*t), -*sin * *t, *cos),
        _ => (any_across(axis), Vec3::zeros(), 1.0),
    };
    let e2 = axis.cross(&e1);
    let origin = match solid {
        Solid::Rod(q, ..) | Solid::Nappe(q, ..) => *q,
        _ => Vec3::zeros(),
    };
    let normal = |angle: f64| {
        let (s, c) = trig::sin_cos(angle);
        flat * (c * e1 + s * e2) + tilt
    };
    let excess = |angle: f64| {
        let m = normal(angle);
        tool.height(pose, m) - solid.support(m)
    };
    let w = pose.te - origin;
    let amplitude = flat * ((w - w.dot(&axis) * axis).norm() + tool.reach());
    let step = std::f64::consts::TAU / f64::from(SECTORS);
    let mut ends = [0.0; SECTORS as usize];
    for (i, end) in (0_u32..).zip(&mut ends) {
        *end = excess(f64::from(i) * step);
    }
    let (mut best, mut best_angle) = (f64::NEG_INFINITY, 0.0);
    // A sector waits for each of the first, and one for each halving.
    let mut stack = Pile::<_, 72>::new();
    for (i, &f) in (0_u32..).zip(&ends) {
        if f > best {
            (best, best_angle) = (f, f64::from(i) * step);
        }
        let next = ends[((i + 1) % SECTORS) as usize];
        stack.push((f64::from(i) * step, f, f64::from(i + 1) * step, next, 0));
    }
    let mut top = best;
    while let Some((a, fa, b, fb, depth)) = stack.pop() {
        let half = 0.5 * (b - a);
        let over = amplitude * (1.0 / trig::cos(half) - 1.0);
        let most = fa.max(fb) + over;
        if most <= best + 1e-13 * amplitude || depth >= DEPTH {
            top = top.max(most);
            continue;
        }
        let m = 0.5 * (a + b);
        let fm = excess(m);
        if fm > best {
            (best, best_angle) = (fm, m);
        }
        stack.push((a, fa, m, fm, depth + 1));
        stack.push((m, fm, b, fb, depth + 1));
    }
    (-top.max(best), -best, normal(best_angle))
}

/// Bounds along the vector from `a` to `b`, axis fixed.
pub(crate) fn bound(tool: &Tool<'_>, a: &Pose, b: &Pose, solid: &Solid) -> Bound {
    let v = b.te - a.te;
    let at = |t: f64| gap(tool, &Pose { te: a.te + t * v, ta: a.ta }, solid);
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
    };
    offer(first.2, 0.0);
    offer(last.2, 1.0);
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
            offer(m.2, t);
            let square = solid.bounded_direction(m.2 - v * (m.2.dot(&v) / v.norm_squared()));
            offer(square, t);
            if slope.abs() <= 1e-14 * v.norm() || t1 - t0 <= 1e-15 {
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

/// Bounds along the vector from `a` to `b` when the axis turns by `turn`, as for the outside: the depth of a
/// point is concave along the chord of its way.
pub(crate) fn bound_turning(
    tool: &Tool<'_>,
    a: &Pose,
    b: &Pose,
    solid: &Solid,
    turn: f64,
) -> Bound {
    let (first, last) = (gap(tool, a, solid), gap(tool, b, solid));
    let low = -parabola(-first.0, -last.0, bulge(tool.reach(), turn));
    let low_at = if first.0 <= last.0 { 0.0 } else { 1.0 };
    let carried = |from: &Pose, to: &Pose, m: Vec3| {
        let p = tool.farthest(from, m);
        let ends = [-m.dot(&p), -m.dot(&carry(from, to, p))];
        solid.support(m) + parabola(ends[0], ends[1], bulge((p - from.te).norm(), turn))
    };
    let mut high = f64::INFINITY;
    for m in [first.2, last.2, solid.bounded_direction(first.2 + last.2)] {
        high = high.min(carried(a, b, m)).min(carried(b, a, m));
    }
    let high_at = if first.1 >= last.1 { 0.0 } else { 1.0 };
    Bound { low, high, least: first.1.min(last.1), low_at, high_at }
}
