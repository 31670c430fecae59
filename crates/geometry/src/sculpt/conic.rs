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
/// at an end may lean less than a right angle from the chord. Tangents are lines to touch, as SSV3 turns them to lead with the points.
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
    let q = apex(&conic, a, b)?;
    // Any other arc of the conic between the ends is half a turn or more, or goes through infinity.
    let between = &given[1..given.len() - 1];
    let meets = if between.is_empty() {
        leads_along([first, last].map(|c| frame.way(c)), [q - a, b - q], b - a)
    } else {
        between.iter().all(|c| within(frame.flat(c.point), [a, q, b]))
    };
    if !meets {
        return Err(ConicFault::NoArc);
    }
    arc_of(&frame, conic, [a, q, b])
}

/// Is a point of the conic on the arc that has its ends and tangents in common with this triangle, whose base is on the x axis?
fn within(p: Vec2, [a, q, b]: [Vec2; 3]) -> bool {
    let cross = |u: Vec2, v: Vec2| u.x * v.y - u.y * v.x;
    let least = -1e-12 * (1.0 + q.norm());
    let inside = |u: Vec2, v: Vec2| cross(u - p, v - p) * -q.y.signum() > least;
    p.y * q.y > 0.0 && inside(a, q) && inside(q, b)
}

/// Do what is given of the directions at the two ends and those of the arc there agree: as they are given, or each turned
/// round that leans more than a right angle from the chord? A normal is taken the latter way.
fn leads_along(given: [Way; 2], arc: [Vec2; 2], chord: Vec2) -> bool {
    let agree = |turned: bool| {
        given.iter().zip(arc).all(|(way, along)| {
            let (t, turned) = match way {
                Way::Free => return true,
                Way::Tangent(t) => (t, turned),
                Way::Line(t) => (t, true),
            };
            let sense = if turned { chord.dot(t).signum() } else { 1.0 };
            sense * t.dot(&along) > 0.0
        })
    };
    agree(false) || agree(true)
}

/// What is given of the direction at a point.
#[derive(Clone, Copy, Debug)]
enum Way {
    Free,
    Tangent(Vec2),
    /// Along it or back.
    Line(Vec2),
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
        let inside = |c: &ConicCondition| y.dot(&(c.point - origin)) / unit;
        let lean = |i: usize, c: &ConicCondition| {
            let way = c.tangent.or_else(|| c.normal.map(|n| n.cross(&z)));
            let way = way.and_then(|t| t.try_normalize(0.0));
            let lean = way.map_or(0.0, |t| y.dot(&t) * chord.dot(&t).signum());
            if i == 0 { lean } else { -lean }
        };
        let greatest = |m: f64, s: f64| if s.abs() > m.abs() { s } else { m };
        let mut most = given.iter().map(inside).fold(0.0, greatest);
        if most.abs() <= 1e-9 {
            most = given.iter().enumerate().map(|(i, c)| lean(i, c)).fold(0.0, greatest);
        }
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

    fn way(&self, c: &ConicCondition) -> Way {
        if let Some(t) = c.tangent {
            return Way::Tangent(self.turned(t));
        }
        let normal = c.normal.map(|n| self.turned(n));
        normal.map_or(Way::Free, |n| Way::Line(Vec2::new(-n.y, n.x)))
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

/// Where the tangents at `a` and `b` meet.
fn apex(c: &Vector6<f64>, a: Vec2, b: Vec2) -> Result<Vec2, ConicFault> {
    let (ga, gb) = (gradient(c, a), gradient(c, b));
    let det = ga.x * gb.y - ga.y * gb.x;
    if det.abs() <= 1e-9 * ga.norm() * gb.norm() {
        return Err(ConicFault::NoArc);
    }
    let (da, db) = (ga.dot(&a), gb.dot(&b));
    Ok(Vec2::new((da * gb.y - db * ga.y) / det, (ga.x * db - gb.x * da) / det))
}

/// The rational quadratic from `a` to `b` on the conic `c`, whose tangents there meet in `q`.
fn arc_of(frame: &Frame, c: Vector6<f64>, [a, q, b]: [Vec2; 3]) -> Result<CubicArc, ConicFault> {
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
    use proptest::prelude::*;

    use super::*;
    use crate::trig;

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
            at(trig::cos_deg(179.0), trig::sin_deg(179.0)),
        ])
        .unwrap();
        assert!((arc.at(0.3).point.norm() - 1.0).abs() < 1e-9);
        assert_eq!(conic_arc(&[at(1.0, 0.0)]), Err(ConicFault::TooFew));
        let zigzag = [at(0.0, 0.0), at(3.0, 1.0), at(1.0, 1.0), at(4.0, 0.0)];
        assert_eq!(conic_arc(&zigzag), Err(ConicFault::Turns));
        let through = ConicCondition { tangent: Some(Vec3::y()), ..at(1.0, 1.0) };
        assert_eq!(conic_arc(&[at(0.0, 0.0), through, at(4.0, 0.0)]), Err(ConicFault::Turns));
    }

    /// How far the arc is from a point, and how far its direction there is from `tangent`.
    fn off(arc: &CubicArc, p: Vec3, tangent: Option<Vec3>) -> (f64, f64) {
        let away = |t: f64| (arc.at(t).point - p).norm();
        let near = (0..=1000).map(|k| f64::from(k) / 1000.0);
        let near = near.min_by(|a, b| away(*a).total_cmp(&away(*b))).unwrap();
        let (mut a, mut b) = ((near - 1e-3).max(0.0), (near + 1e-3).min(1.0));
        for _ in 0..120 {
            let (c, d) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
            if away(c) < away(d) { b = d } else { a = c }
        }
        let t = 0.5 * (a + b);
        let way = arc.at(t).first.normalize();
        (away(t), tangent.map_or(0.0, |w| way.cross(&w.normalize()).norm()))
    }

    fn all_met(arc: &CubicArc, given: &[ConicCondition]) {
        let size = given.iter().map(|c| (c.point - given[0].point).norm()).fold(0.0, f64::max);
        for c in given {
            let (place, way) = off(arc, c.point, c.tangent);
            assert!(place < 1e-9 * size && way < 1e-6, "{place:e} {way:e} {given:?}");
        }
        let ends = [given[0].point, given[given.len() - 1].point];
        assert!((arc.at(0.0).point - ends[0]).norm() < 1e-9 * size);
        assert!((arc.at(1.0).point - ends[1]).norm() < 1e-9 * size);
    }

    /// The conditions of a curve at some of its parameters, with tangents of any length at those of `lines`, laid somewhere in space.
    fn laid(
        curve: impl Fn(f64) -> (Vec2, Vec2),
        at: &[f64],
        (lines, stretch): (&[usize], f64),
        turn: Vec3,
    ) -> Vec<ConicCondition> {
        let turn = nalgebra::Rotation3::new(turn);
        let lay = |v: Vec2| turn * Vec3::new(v.x, v.y, 0.0);
        let one = |(i, t): (usize, &f64)| {
            let (p, way) = curve(*t);
            let tangent = lines.contains(&i).then(|| lay(way) * stretch);
            ConicCondition { point: lay(p) + Vec3::new(7.0, -3.0, 2.0), tangent, normal: None }
        };
        at.iter().enumerate().map(one).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]

        /// Parts of ellipses: five conditions or, of circles, three give that part if it is less than half a turn and nothing if it is
        /// more. Four give another conic, which meets them.
        #[test]
        fn parts_of_ellipses(
            half in prop::array::uniform2(2.0_f64..40.0),
            from in 0.0_f64..360.0,
            sweep in prop_oneof![15.0_f64..178.0, 182.0_f64..345.0],
            shares in prop::array::uniform3(0.2_f64..0.8),
            turn in prop::array::uniform3(-2.0_f64..2.0),
            stretch in prop_oneof![1e-3_f64..1.0, -1e3_f64..1e3],
            kind in 0_usize..8,
        ) {
            let circle = kind > 5;
            let half = if circle { [half[0]; 2] } else { half };
            let curve = |t: f64| {
                let (c, s) = (trig::cos_deg(t), trig::sin_deg(t));
                (Vec2::new(half[0] * c, half[1] * s), Vec2::new(-half[0] * s, half[1] * c))
            };
            let (inner, lines): (usize, &[usize]) = match kind {
                0 | 1 => (3, &[]),
                2 => (1, &[0, 2]),
                3 => (2, &[3]),
                4 => (1, &[0, 1]),
                5 => (2, &[]),
                6 => (1, &[]),
                _ => (0, &[0]),
            };
            let step = 1.0 / (inner as f64 + 1.0);
            let share = |k: usize| (k as f64 + 0.6 * shares[k.min(2)] + 0.7) * step;
            let mut at = vec![0.0];
            at.extend((0..inner).map(share));
            at.push(1.0);
            let at: Vec<_> = at.iter().map(|s| from + sweep * s).collect();
            prop_assume!(stretch.abs() > 1e-6);
            let given = laid(curve, &at, (lines, stretch), Vec3::from(turn));
            match conic_arc(&given) {
                // A tangent alone is turned round to lead with the chord: it begins the other part of the circle.
                Ok(arc) => {
                    prop_assert!(sweep < 180.0 || matches!(kind, 5 | 7), "{sweep} {given:?}");
                    all_met(&arc, &given);
                }
                Err(why) => prop_assert!(sweep > 180.0 || kind == 5, "{why:?} {given:?}"),
            }
        }

        /// A branch of a hyperbola is met from any five conditions of it, and never its other branch.
        #[test]
        fn parts_of_hyperbolas(
            half in prop::array::uniform2(2.0_f64..40.0),
            ends in prop::array::uniform2(0.3_f64..1.5),
            turn in prop::array::uniform3(-2.0_f64..2.0),
            lines in any::<bool>(),
            other in any::<bool>(),
        ) {
            let [a, b] = [-ends[0], ends[1]];
            let curve = |t: f64| {
                let (c, s) = (trig::cosh(t), trig::sinh(t));
                (Vec2::new(half[0] * c, half[1] * s), Vec2::new(half[0] * s, half[1] * c))
            };
            let given = if lines {
                laid(curve, &[a, 0.1 * a, b], (&[0, 2], 5.0), Vec3::from(turn))
            } else {
                laid(curve, &[a, 0.5 * a, 0.1, 0.5 * b, b], (&[], 1.0), Vec3::from(turn))
            };
            if other && !lines {
                let far = |t: f64| (-curve(t).0, curve(t).1);
                let mut mixed = given.clone();
                mixed[2] = laid(far, &[0.1], (&[], 1.0), Vec3::from(turn))[0];
                prop_assert!(conic_arc(&mixed).is_err());
            }
            all_met(&conic_arc(&given).unwrap(), &given);
        }
    }

    /// Tangents are lines to touch: they are turned to lead with the chord. What bends both ways is refused.
    #[test]
    fn tangents_turned_round() {
        let with = |x, y, t: [f64; 2]| ConicCondition {
            tangent: Some(Vec3::new(t[0], t[1], 0.0)),
            ..at(x, y)
        };
        let back = conic_arc(&[with(10.0, 0.0, [1.0, 1.0]), at(0.0, 0.0)]).unwrap();
        let ahead = conic_arc(&[with(10.0, 0.0, [-1.0, -1.0]), at(0.0, 0.0)]).unwrap();
        assert!((back.at(0.5).point - ahead.at(0.5).point).norm() < 1e-12);
        assert!((back.at(0.5).point - Vec3::new(5.0, 5.0 - 50.0_f64.sqrt(), 0.0)).norm() < 1e-9);
        let bent = [with(0.0, 0.0, [1.0, 1.0]), with(10.0, 0.0, [1.0, 0.5])];
        assert_eq!(conic_arc(&bent), Err(ConicFault::NoArc));
        // As they are given, one leaning more than a right angle.
        let far = [with(0.0, 0.0, [-0.5, 0.8]), with(10.0, 0.0, [0.9, -0.5])];
        all_met(&conic_arc(&far).unwrap(), &far);
    }

    #[test]
    fn two_points_make_a_line() {
        let arc = conic_arc(&[at(1.0, 0.0), at(3.0, 4.0)]).unwrap();
        assert!((arc.at(0.5).point - Vec3::new(2.0, 2.0, 0.0)).norm() < 1e-15);
    }
}
