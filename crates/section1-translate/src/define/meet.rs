//! Where lines, circles and conics of the plane meet, with residuals that stay small near tangency.

use aptc_geometry::{Line, Plane, Quadric, Vec2, Vec3};

/// Sine of the angle below which two directions count as parallel.
///
/// Smaller, and what is given as parallel would meet far away by rounding alone; larger, and long thin
/// wedges could not be given.
pub(super) const PARALLEL: f64 = 1e-9;

/// Share of the size by which curves may miss each other and still count as touching. It has to cover
/// what rounding leaves after a few definitions on top of each other.
pub(super) const SLACK: f64 = 4e-10;

/// What two curves have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Meet<P> {
    /// Two points; equal when the curves touch.
    At(P, P),
    /// The curves miss each other by this much.
    Apart(f64),
    /// Every point of one is on the other, or their centres fall together.
    Same,
}

/// Unit normal of a line.
pub(super) fn normal(l: &Line) -> Vec2 {
    Vec2::new(l.a, l.b)
}

/// `v` turned left by 90 degrees.
pub(super) fn left(v: Vec2) -> Vec2 {
    Vec2::new(-v.y, v.x)
}

/// Direction of a line, its normal to the left.
pub(super) fn direction(l: &Line) -> Vec2 {
    Vec2::new(l.b, -l.a)
}

/// The line through `p` with unit normal `n`.
pub(super) fn line_at(p: Vec2, n: Vec2) -> Line {
    Line { a: n.x + 0.0, b: n.y + 0.0, d: n.dot(&p) + 0.0 }
}

/// The line moved by `by` along its normal.
pub(super) fn offset(l: &Line, by: f64) -> Line {
    Line { d: l.d + by, ..*l }
}

/// Where two lines meet; `None` for parallel ones.
///
/// The point is taken along the first line, so that the residual on both stays that of rounding however
/// thin the wedge between them is.
pub(super) fn lines(one: &Line, other: &Line) -> Option<Vec2> {
    let foot = normal(one) * one.d;
    let along = direction(one);
    let sine = normal(other).dot(&along);
    (sine.abs() > PARALLEL).then(|| foot + along * ((other.d - normal(other).dot(&foot)) / sine))
}

/// The shortest vector with `u . x = r` and `v . x = s` for unit vectors u, v that are not parallel.
fn shortest(u: Vec3, v: Vec3, r: f64, s: f64) -> Vec3 {
    let w = u.cross(&v);
    (v.cross(&w) * r + w.cross(&u) * s) / w.norm_squared()
}

/// The unit vector square to both `u` and `v`, which need not be unit; `None` when they are parallel.
///
/// Taken once more against its own residuals: of nearly parallel vectors the product alone has lost as
/// many figures as their angle has zeros.
pub(super) fn across(u: Vec3, v: Vec3) -> Option<Vec3> {
    let (u, v) = (u.try_normalize(0.0)?, v.try_normalize(0.0)?);
    let w = u.cross(&v);
    if w.norm() <= PARALLEL {
        return None;
    }
    let mut w = w.normalize();
    for _ in 0..2 {
        w = (w - shortest(u, v, u.dot(&w), v.dot(&w))).normalize();
    }
    Some(w)
}

/// A point and the unit direction of the line in which two planes cut each other.
pub(super) fn planes(one: &Plane, other: &Plane) -> Option<(Vec3, Vec3)> {
    let along = across(one.n, other.n)?;
    let mut foot = Vec3::zeros();
    for _ in 0..3 {
        foot -= shortest(one.n, other.n, one.distance(foot), other.distance(foot));
    }
    Some((foot, along))
}

/// Where a line meets the circle of radius `r` about `c`.
pub(super) fn line_circle(l: &Line, c: Vec2, r: f64) -> Meet<Vec2> {
    let d = normal(l).dot(&c) - l.d;
    let foot = c - normal(l) * d;
    let room = (r - d.abs()) * (r + d.abs());
    if d.abs() - r > SLACK * (r + c.amax()) {
        return Meet::Apart(d.abs() - r);
    }
    let half = direction(l) * room.max(0.0).sqrt();
    Meet::At(foot + half, foot - half)
}

/// Where two circles meet.
pub(super) fn circles(c1: Vec2, r1: f64, c2: Vec2, r2: f64) -> Meet<Vec2> {
    let between = c2 - c1;
    let distance = between.norm();
    let slack = SLACK * (r1 + r2 + c1.amax().max(c2.amax()));
    if distance <= slack {
        let gap = (r1 - r2).abs();
        return if gap <= slack { Meet::Same } else { Meet::Apart(gap) };
    }
    let gap = (distance - (r1 + r2)).max((r1 - r2).abs() - distance);
    if gap > slack {
        return Meet::Apart(gap);
    }
    let u = between / distance;
    let along = 0.5 * ((r1 - r2) * (r1 + r2) / distance + distance);
    let along = along.clamp(-r1, r1);
    let half = left(u) * ((r1 - along) * (r1 + along)).sqrt();
    Meet::At(c1 + u * along + half, c1 + u * along - half)
}

/// Where the straight line `p + t v` (v unit) meets a quadric.
pub(super) fn line_quadric(p: Vec3, v: Vec3, q: &Quadric) -> Meet<Vec3> {
    // Begin at the middle of the chord where there is one: it keeps the constant term small.
    let pure =
        Quadric { c: [q.c[0], q.c[1], q.c[2], 0.0, q.c[4], q.c[5], q.c[6], 0.0, 0.0, 0.0], ..*q };
    let a = pure.value(v);
    let scale = q.c[..3].iter().chain(&q.c[4..7]).fold(0.0_f64, |m, c| m.max(c.abs()));
    let b = q.gradient(p).dot(&v);
    if a.abs() <= 1e-12 * scale {
        let t = -q.value(p) / b;
        return if t.is_finite() && b.abs() > 0.0 {
            Meet::At(p + v * t, p + v * t)
        } else {
            Meet::Apart(f64::INFINITY)
        };
    }
    let middle = p + v * (-b / (2.0 * a));
    let value = q.value(middle);
    let room = -value / a;
    if room >= 0.0 {
        // One step of Newton for each root takes away what the shift of the origin lost.
        let polish = |s: f64| {
            let at = middle + v * s;
            let slope = q.gradient(at).dot(&v);
            let step = q.value(at) / slope;
            if step.is_finite() && step.abs() < 0.1 * s.abs() { at - v * step } else { at }
        };
        let half = room.sqrt();
        return Meet::At(polish(half), polish(-half));
    }
    let slope = q.gradient(middle).norm();
    let gap = if slope > 0.0 { value.abs() / slope } else { f64::INFINITY };
    let gap = gap.min((-room).sqrt());
    if gap <= SLACK * middle.amax().max(f64::MIN_POSITIVE) {
        return Meet::At(middle, middle);
    }
    Meet::Apart(gap)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thin_wedge_meets_on_both_lines() {
        let one = Line::new(0.0, 1.0, 3.0).unwrap();
        let other = Line::new(1e-8, 1.0, 3.5).unwrap();
        let p = lines(&one, &other).unwrap();
        assert!((normal(&one).dot(&p) - one.d).abs() <= 1e-15 * p.norm());
        assert!((normal(&other).dot(&p) - other.d).abs() <= 1e-15 * p.norm());
        assert!(lines(&one, &Line::new(1e-10, 1.0, 0.0).unwrap()).is_none());
    }

    #[test]
    fn circles_touch_cross_and_miss() {
        let (o, x) = (Vec2::zeros(), Vec2::new(5.0, 0.0));
        assert_eq!(circles(o, 4.0, x, 3.0), Meet::At(Vec2::new(3.2, 2.4), Vec2::new(3.2, -2.4)));
        assert_eq!(circles(o, 2.0, x, 3.0), Meet::At(Vec2::new(2.0, 0.0), Vec2::new(2.0, 0.0)));
        assert_eq!(circles(o, 1.0, x, 3.0), Meet::Apart(1.0));
        assert_eq!(circles(o, 9.0, x, 3.0), Meet::Apart(1.0));
        assert_eq!(circles(o, 3.0, o, 3.0), Meet::Same);
    }
}
