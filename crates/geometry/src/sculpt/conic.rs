//! CURSEG: one conic arc of less than half a turn from at most five conditions.

use nalgebra::{Matrix6, Vector6};

use super::arc::{CubicArc, weighted};
use crate::{Vec2, Vec3};

/// A point of the arc with the direction of the curve there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConicCondition {
    /// The point.
    pub point: Vec3,
    /// TANSPL.
    pub tangent: Option<Vec3>,
    /// NORMAL: square to the curve, in its plane.
    pub normal: Option<Vec3>,
}

/// Why conditions make no conic arc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConicFault {
    /// Fewer than two points, or the two ends coincide.
    TooFew,
    /// More than five conditions.
    TooMany,
    /// The conditions do not lie in one plane.
    NotPlane,
    /// Points and tangents do not turn one way in their order.
    Turns,
    /// No conic arc of less than half a turn meets the conditions.
    NoArc,
}

/// The straight line between two points.
pub fn line_arc(a: Vec3, b: Vec3) -> CubicArc {
    CubicArc::line(a, b)
}

/// The arc from the first to the last point. Three conditions give a circle, five any conic. Four give, of the conics
/// x x + b y y + c x y + d x + e y = 0 with x along the chord, the ellipse b = 1 + c c / 2, else the parabola b = c c / 4, as SSV3 does; a tangent
/// at an end may lean less than a right angle from the chord.
///
/// Of the weights the ends' ratio is that of the tangents' lengths to where they meet, so that the
/// parameter starts and ends equally fast.
pub fn conic_arc(given: &[ConicCondition]) -> Result<CubicArc, ConicFault> {
    let (Some(first), Some(last)) = (given.first(), given.last()) else {
        return Err(ConicFault::TooFew);
    };
    let size = given.iter().map(|c| (c.point - first.point).norm()).fold(0.0, f64::max);
    if given.len() < 2 || (last.point - first.point).norm() <= 1e-12 * size || size <= 0.0 {
        return Err(ConicFault::TooFew);
    }
    let directions = given.iter().filter(|c| c.tangent.is_some() || c.normal.is_some()).count();
    let count = given.len() + directions;
    if count > 5 {
        return Err(ConicFault::TooMany);
    }
    if count == 2 {
        return Ok(CubicArc::line(first.point, last.point));
    }
    let frame = Frame::of(given, size)?;
    if frame.straight {
        let goes_on = frame.goes_on(given);
        return goes_on.then(|| CubicArc::line(first.point, last.point)).ok_or(ConicFault::Turns);
    }
    if !frame.turns_one_way(given) {
        return Err(ConicFault::Turns);
    }
    let conic = frame.conic(given, count)?;
    let (a, b) = (frame.flat(first.point), frame.flat(last.point));
    arc_of(&frame, conic, a, b)
}

/// The plane of the conic: origin, axes, and the length of one unit.
struct Frame {
    origin: Vec3,
    x: Vec3,
    y: Vec3,
    unit: f64,
    /// All conditions lie on one line.
    straight: bool,
}

impl Frame {
    fn of(given: &[ConicCondition], unit: f64) -> Result<Self, ConicFault> {
        let origin = given[0].point;
        let chord = (given[given.len() - 1].point - origin).normalize();
        let mut normal = Vec3::zeros();
        let mut offer = |v: Vec3| {
            let n = chord.cross(&v);
            if n.norm() > normal.norm() {
                normal = n;
            }
        };
        for c in given {
            offer((c.point - origin) / unit);
            if let Some(t) = c.tangent {
                offer(t.try_normalize(0.0).unwrap_or_else(Vec3::zeros));
            }
            if let Some(n) = c.normal {
                // A normal that stands square to the chord's plane partner gives the plane itself.
                offer(n.try_normalize(0.0).unwrap_or_else(Vec3::zeros));
            }
        }
        let straight = normal.norm() < 1e-10;
        let z =
            normal.try_normalize(1e-10).unwrap_or_else(|| crate::surface::frame_about(chord)[0]);
        let y = z.cross(&chord);
        // The arc lies where y is positive: that is told by points inside, else by the tangents at the ends.
        let side = |i: usize, c: &ConicCondition| {
            let inside = y.dot(&(c.point - origin));
            let way = c.tangent.or_else(|| c.normal.map(|n| n.cross(&z)));
            let lean = way.map_or(0.0, |t| y.dot(&t) * chord.dot(&t).signum());
            if inside.abs() > 1e-9 * unit {
                inside
            } else if i == 0 {
                lean
            } else {
                -lean
            }
        };
        let most = given.iter().enumerate().map(|(i, c)| side(i, c));
        let most = most.fold(0.0_f64, |m, s| if s.abs() > m.abs() { s } else { m });
        let frame = Self { origin, x: chord, y: y * most.signum(), unit, straight };
        let off = |v: Vec3, s: f64| z.dot(&v).abs() > 1e-6 * s;
        let out = given
            .iter()
            .any(|c| off(c.point - origin, unit) || c.tangent.is_some_and(|t| off(t, t.norm())));
        if out && !straight { Err(ConicFault::NotPlane) } else { Ok(frame) }
    }

    fn flat(&self, p: Vec3) -> Vec2 {
        self.turned(p - self.origin) / self.unit
    }

    fn turned(&self, v: Vec3) -> Vec2 {
        Vec2::new(self.x.dot(&v), self.y.dot(&v))
    }

    fn lift(&self, p: Vec2) -> Vec3 {
        self.origin + (self.x * p.x + self.y * p.y) * self.unit
    }

    /// Coefficients of x x, x y, y y, x, y, 1.
    fn conic(&self, given: &[ConicCondition], count: usize) -> Result<Vector6<f64>, ConicFault> {
        if count == 4 {
            return self.four(given).ok_or(ConicFault::NoArc);
        }
        let mut m = Matrix6::zeros();
        let mut row = 0;
        let mut put = |r: [f64; 6]| {
            let v = Vector6::from(r);
            let v = v.try_normalize(0.0).unwrap_or(v);
            m.set_row(row, &v.transpose());
            row += 1;
        };
        for c in given {
            let p = self.flat(c.point);
            put([p.x * p.x, p.x * p.y, p.y * p.y, p.x, p.y, 1.0]);
            let normal = || c.normal.map(|n| self.turned(n)).map(|n| Vec2::new(-n.y, n.x));
            let Some(t) = c.tangent.map(|t| self.turned(t)).or_else(normal) else { continue };
            put([2.0 * p.x * t.x, p.x * t.y + p.y * t.x, 2.0 * p.y * t.y, t.x, t.y, 0.0]);
        }
        if count < 5 {
            put([0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
            put([1.0, 0.0, -1.0, 0.0, 0.0, 0.0]);
        }
        let svd = m.svd(false, true);
        let (Some(v), s) = (svd.v_t, svd.singular_values) else { return Err(ConicFault::NoArc) };
        let least = s.imin();
        let second = (0..6).filter(|&i| i != least).map(|i| s[i]).fold(f64::INFINITY, f64::min);
        // Two independent conics meet the conditions: they are contradictory or repeated.
        if second < 1e-11 {
            return Err(ConicFault::NoArc);
        }
        Ok(v.row(least).transpose())
    }

    /// Of conditions on a line, do they follow one another from one end to the other?
    fn goes_on(&self, given: &[ConicCondition]) -> bool {
        let along = |w: &[ConicCondition]| self.x.dot(&(w[1].point - w[0].point)) > 0.0;
        given.windows(2).all(along)
    }

    /// Does the way over the points turn right at each, with all of them on one side of each tangent?
    fn turns_one_way(&self, given: &[ConicCondition]) -> bool {
        let cross = |a: Vec2, b: Vec2| a.x * b.y - a.y * b.x;
        let at: Vec<Vec2> = given.iter().map(|c| self.flat(c.point)).collect();
        let right = at.windows(3).all(|w| cross(w[1] - w[0], w[2] - w[1]) < 0.0);
        right
            && given.iter().zip(&at).all(|(c, p)| {
                let Some(t) = c.tangent.map(|t| self.turned(t)) else { return true };
                let sides = at.iter().filter(|q| *q != p).map(|q| cross(t, q - p));
                let (mut left, mut right) = (false, false);
                sides.for_each(|s| if s > 0.0 { left = true } else { right = true });
                !(left && right)
            })
    }

    /// The conic of four conditions: two besides the ends, each linear in b, c and e.
    fn four(&self, given: &[ConicCondition]) -> Option<Vector6<f64>> {
        let d = -self.flat(given[given.len() - 1].point).x;
        let last = given.len() - 1;
        let mut rows = Vec::new();
        for c in given {
            let p = self.flat(c.point);
            let normal = || c.normal.map(|n| self.turned(n)).map(|n| Vec2::new(-n.y, n.x));
            let Some(t) = c.tangent.map(|t| self.turned(t)).or_else(normal) else { continue };
            rows.push([2.0 * p.y * t.y, p.x * t.y + p.y * t.x, t.y, (2.0 * p.x + d) * t.x]);
        }
        let only_tangents = rows.len() == 2;
        for c in &given[1..last] {
            let p = self.flat(c.point);
            rows.push([p.y * p.y, p.x * p.y, p.y, (p.x + d) * p.x]);
        }
        let [one, other] = rows.as_slice() else { return None };
        // Without e.
        let [b, c, r] = [0, 1, 3].map(|k| one[k] * other[2] - other[k] * one[2]);
        let whole = |square: f64, mid: f64| {
            let from = if one[2].abs() > other[2].abs() { one } else { other };
            let fits = move |c: f64| {
                let b = mid + square * c * c;
                let e = -(from[0] * b + from[1] * c + from[3]) / from[2];
                // Both end tangents lean less than a right angle.
                (only_tangents || d * e < 0.0 && d * (e - c * d) < 0.0)
                    .then(|| Vector6::new(1.0, c, b, d, e, 0.0))
            };
            let (q, p) = (square * b, r + mid * b);
            if q.abs() <= 1e-10 {
                return fits(-p / c);
            }
            let under = c * c - 4.0 * q * p;
            let root = under.max(0.0).sqrt();
            (under >= 0.0)
                .then(|| fits((-c - root) / (2.0 * q)).or_else(|| fits((root - c) / (2.0 * q))))?
        };
        whole(0.5, 1.0).or_else(|| whole(0.25, 0.0))
    }
}

fn gradient(c: &Vector6<f64>, p: Vec2) -> Vec2 {
    Vec2::new(2.0 * c[0] * p.x + c[1] * p.y + c[3], c[1] * p.x + 2.0 * c[2] * p.y + c[4])
}

/// The rational quadratic from `a` to `b` on the conic `c`.
fn arc_of(frame: &Frame, c: Vector6<f64>, a: Vec2, b: Vec2) -> Result<CubicArc, ConicFault> {
    let (ga, gb) = (gradient(&c, a), gradient(&c, b));
    let det = ga.x * gb.y - ga.y * gb.x;
    if det.abs() <= 1e-9 * ga.norm() * gb.norm() {
        return Err(ConicFault::NoArc);
    }
    // Where the tangents meet.
    let (da, db) = (ga.dot(&a), gb.dot(&b));
    let q = Vec2::new((da * gb.y - db * ga.y) / det, (ga.x * db - gb.x * da) / det);
    let pair = |p: Vec2, r: Vec2| {
        c[0] * p.x * r.x
            + 0.5 * c[1] * (p.x * r.y + p.y * r.x)
            + c[2] * p.y * r.y
            + 0.5 * c[3] * (p.x + r.x)
            + 0.5 * c[4] * (p.y + r.y)
            + c[5]
    };
    let ratio = -pair(a, b) / (2.0 * pair(q, q));
    if ratio <= 0.0 || !ratio.is_finite() {
        return Err(ConicFault::NoArc);
    }
    let end = (b - q).norm() / (q - a).norm();
    let mid = (ratio * end).sqrt();
    Ok(CubicArc::quadratic([
        weighted(frame.lift(a), 1.0),
        weighted(frame.lift(q), mid),
        weighted(frame.lift(b), end),
    ]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64, y: f64) -> ConicCondition {
        ConicCondition { point: Vec3::new(x, y, 0.0), tangent: None, normal: None }
    }

    /// The ellipse of TEST18: half axes 20 and 15.
    fn on(x: f64) -> (ConicCondition, Vec3) {
        let y = 15.0 * (1.0 - x * x / 400.0).sqrt();
        (at(x, y), Vec3::new(y / 225.0, -x / 400.0, 0.0))
    }

    fn printed(arc: &CubicArc, rows: [[f64; 2]; 3]) {
        for (i, [x, y]) in rows.into_iter().enumerate() {
            let p = arc.at(0.25 + 0.25 * i as f64).point;
            assert!((p - Vec3::new(x, y, 0.0)).norm() < 1e-4, "{i} {p}");
        }
    }

    #[test]
    fn arcs_of_test18_as_printed() {
        let p = |x: f64| on(x).0;
        let with = |x: f64| ConicCondition { tangent: Some(on(x).1), ..p(x) };
        let circle = conic_arc(&[p(0.0), p(10.0), p(20.0)]).unwrap();
        printed(&circle, [[6.5267, 14.3435], [12.8077, 11.2436], [17.5423, 6.0819]]);
        let one_tangent = conic_arc(&[with(0.0), p(20.0)]).unwrap();
        printed(&one_tangent, [[6.4189, 13.9865], [12.5, 10.8333], [17.2297, 5.8784]]);
        let ellipse = [[6.5914, 14.1620], [13.2767, 11.2182], [18.2493, 6.1373]];
        printed(&conic_arc(&[with(0.0), p(10.0), with(20.0)]).unwrap(), ellipse);
        printed(&conic_arc(&[p(0.0), p(5.0), p(15.0), p(20.0)]).unwrap(), ellipse);
        printed(&conic_arc(&[p(0.0), p(5.0), p(10.0), p(15.0), p(20.0)]).unwrap(), ellipse);
        printed(&conic_arc(&[with(0.0), p(15.0), p(20.0)]).unwrap(), ellipse);
        let normal = ConicCondition { normal: Some(Vec3::x()), ..p(20.0) };
        let c4 = conic_arc(&[p(0.0), normal]).unwrap();
        printed(&c4, [[6.7647, 15.4412], [13.75, 12.5], [18.5294, 6.6176]]);
    }

    /// Four conditions as SSV3 takes them.
    #[test]
    fn four_conditions() {
        let with = |x, y, t: [f64; 2]| ConicCondition {
            tangent: Some(Vec3::new(t[0], t[1], 0.0)),
            ..at(x, y)
        };
        for (given, x, y) in [
            (
                vec![at(0.0, 0.0), at(1.0, 1.0), at(3.0, 2.0), at(5.0, 1.0)],
                2.522_514_152,
                1.905_387_395,
            ),
            (
                vec![with(0.0, 0.0, [1.0, 2.0]), with(5.0, 1.0, [1.0, -0.5])],
                2.230_120_224,
                1.485_030_795,
            ),
        ] {
            let p = conic_arc(&given).unwrap().at(0.5).point;
            assert!((p - Vec3::new(x, y, 0.0)).norm() < 1e-7, "{p}");
            // The other way round it is the same curve, and so is its mirror image.
            let back: Vec<_> = given.iter().rev().copied().collect();
            assert!((conic_arc(&back).unwrap().at(0.5).point - p).norm() < 1e-9);
            let over = |v: Vec3| Vec3::new(v.x, -v.y, v.z);
            let mirrored: Vec<_> = given
                .iter()
                .map(|c| ConicCondition {
                    point: over(c.point),
                    tangent: c.tangent.map(over),
                    ..*c
                })
                .collect();
            assert!((over(conic_arc(&mirrored).unwrap().at(0.5).point) - p).norm() < 1e-9);
        }
    }

    #[test]
    fn half_a_turn_is_refused() {
        assert_eq!(conic_arc(&[at(1.0, 0.0), at(0.0, 1.0), at(-1.0, 0.0)]), Err(ConicFault::NoArc));
        let arc = conic_arc(&[
            at(1.0, 0.0),
            at(0.0, 1.0),
            at(crate::trig::cos_deg(179.0), crate::trig::sin_deg(179.0)),
        ])
        .unwrap();
        assert!((arc.at(0.3).point.norm() - 1.0).abs() < 1e-9);
        assert_eq!(conic_arc(&[at(1.0, 0.0)]), Err(ConicFault::TooFew));
        let zigzag = [at(0.0, 0.0), at(3.0, 1.0), at(1.0, 1.0), at(4.0, 0.0)];
        assert_eq!(conic_arc(&zigzag), Err(ConicFault::Turns));
        let through = ConicCondition { tangent: Some(Vec3::y()), ..at(1.0, 1.0) };
        assert_eq!(conic_arc(&[at(0.0, 0.0), through, at(4.0, 0.0)]), Err(ConicFault::Turns));
    }

    #[test]
    fn two_points_make_a_line() {
        let arc = conic_arc(&[at(1.0, 0.0), at(3.0, 4.0)]).unwrap();
        assert!((arc.at(0.5).point - Vec3::new(2.0, 2.0, 0.0)).norm() < 1e-15);
    }
}
