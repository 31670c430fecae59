//! A tool on its way while its axis turns.
//!
//! Seen from the tool a place of the surface goes along a curve, and about that curve's chord the tool is one that moves
//! straight. With the axis turned by `R(t)`, over the angle `a` in all, and the way `v` of the tool end, the curve is
//! `p(t) = R(t)'(q - te(t))` and `|p''| <= a^2 |q - te| + 2 a |v|`: it is never off its chord by more than an eighth of that.
//! A place `w` from `q` turns about it besides: beside the axis of the middle by the chord of half the angle, times `|w|`.

use aptc_geometry::{Profile, Tool, Vec3, trig};

use crate::bodies::{Convex, Near, Swept};
use crate::under::{Cell, Low};

/// A tool that moves straight while its axis turns evenly in the plane of both.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turned<'a> {
    profile: &'a Profile,
    /// The lower end of the solid from the tool end.
    up: Vec3,
    /// The axis of the middle.
    axis: Vec3,
    /// The tool ends.
    ends: [Vec3; 2],
    /// About what the axis turns, and sine and cosine of half the angle.
    about: (Vec3, [f64; 2]),
    angle: f64,
    /// Chord of half the angle, for the length 1.
    turn: f64,
    /// The way of the tool end.
    way: f64,
}

impl<'a> Turned<'a> {
    /// From tool end and axis to tool end and axis, of a solid whose lower end is `up` above the tool end. Of axes that point
    /// against each other nothing is known.
    pub(crate) fn new(profile: &'a Profile, up: f64, [a, b]: [(Vec3, Vec3); 2]) -> Self {
        let across = a.1.cross(&b.1);
        let angle = trig::angle_between(a.1, b.1);
        let about = across.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        let (sin, cos) = trig::sin_cos(0.5 * angle);
        let middle = (a.1 + b.1).try_normalize(1e-9);
        let known = middle.is_some();
        let axis = middle.unwrap_or(a.1);
        Self {
            profile,
            up: axis * up,
            axis,
            ends: [a.0, b.0],
            about: (about, [sin, cos]),
            angle,
            turn: if known { 2.0 * trig::sin(0.25 * angle) } else { f64::INFINITY },
            way: (b.0 - a.0).norm(),
        }
    }

    /// The tool as the place `q` sees it go by.
    fn seen(&self, q: Vec3) -> Swept<'a> {
        let (about, [sin, cos]) = self.about;
        let [x, y] = self.ends.map(|te| q - te);
        let turned = |x: Vec3, sin: f64| {
            x * cos + about.cross(&x) * sin + about * (about.dot(&x) * (1.0 - cos))
        };
        let [p, r] = [turned(x, sin), turned(y, -sin)];
        let tool = Tool { profile: self.profile, te: q - p + self.up, ta: self.axis };
        Swept { tool, by: p - r }
    }
}

impl Convex for Turned<'_> {
    fn near(&self, q: Vec3) -> Near {
        self.seen(q).near(q)
    }

    fn near_enough(&self, q: Vec3, enough: f64) -> Near {
        self.seen(q).near_enough(q, enough)
    }

    fn near_until(&self, q: Vec3, aim: f64, lost: impl Fn(Vec3) -> f64) -> (Near, f64) {
        self.seen(q).near_until(q, aim, lost)
    }

    fn misses(&self, q: Vec3, reach: f64) -> bool {
        self.seen(q).misses(q, reach)
    }

    fn under(&self, cell: &Cell, aim: f64) -> Option<Low> {
        self.seen(cell.point).under(cell, aim)
    }

    /// A place turns about `q` by its distance from the axis of the turn at most.
    fn slack(&self, q: Vec3, radius: f64) -> f64 {
        if self.turn.is_infinite() {
            return f64::INFINITY;
        }
        let [from, to] = self.ends.map(|te| (q - te).norm());
        let far = from.max(to) + radius;
        bulge(self.angle, far, self.way) + self.turn * radius
    }

    /// How far a piece reaches along what it turns about does not count. Two places of it are no more than twice as far apart.
    fn slacks(&self, cell: &Cell) -> [f64; 2] {
        if self.turn.is_infinite() {
            return [f64::INFINITY; 2];
        }
        let across = [self.axis, self.about.0.cross(&self.axis)].map(|d| cell.extent(d));
        let across = trig::hypot(across[0], across[1]).min(cell.far);
        let beside = self.turn * across;
        [self.slack(cell.point, 0.0) + 0.125 * self.angle * self.angle * cell.far + beside, beside]
    }
}

/// How far a place no farther than `far` from the tool end is off the chord of its way about the tool, that turns by `angle`
/// while its end moves by `way`.
pub fn bulge(angle: f64, far: f64, way: f64) -> f64 {
    0.125 * angle * (angle * far + 2.0 * way)
}

/// The axis at the share `t` of the turn from `a` to `b`.
pub fn axis_between(a: Vec3, b: Vec3, t: f64) -> Vec3 {
    let angle = trig::acos_clamped(a.dot(&b));
    let s = trig::sin(angle);
    if s < 1e-9 {
        return (a * (1.0 - t) + b * t).try_normalize(1e-9).unwrap_or(a);
    }
    (a * trig::sin(angle * (1.0 - t)) + b * trig::sin(angle * t)) / s
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::Cutter;
    use proptest::prelude::*;

    proptest! {
        /// No place on the way comes nearer than a tangent says less its slack, by small steps of the way.
        #[test]
        fn a_turning_tool_stays_within_its_slack(
            corner in 0.0_f64..6.0, up in 0.0_f64..5.0,
            way in prop::array::uniform3(-4.0_f64..4.0), lean in prop::array::uniform3(-1.0_f64..1.0),
            turn in prop::array::uniform3(-0.4_f64..0.4), short in 0.0_f64..1.0,
            at in prop::array::uniform3(-15.0_f64..15.0), beside in prop::array::uniform3(-1.0_f64..1.0),
        ) {
            let profile = Profile::new(&Cutter::mill(12.0, corner, 40.0)).unwrap();
            let [way, lean, turn, q, w] = [way, lean, turn, at, beside].map(Vec3::from);
            let te = Vec3::new(1.0, 2.0, 3.0);
            let axes = [lean, lean + turn * short].map(|a| (a + Vec3::z() * 2.0).normalize());
            let body = Turned::new(&profile, up, [(te, axes[0]), (te + way * short, axes[1])]);
            let across = axes[0].cross(&axes[1]);
            let angle = trig::atan2(across.norm(), axes[0].dot(&axes[1]));
            let other = across.cross(&axes[0]).try_normalize(0.0).unwrap_or_else(Vec3::zeros);
            let p = q + w;
            let (mut least, mut beside) = (f64::INFINITY, f64::INFINITY);
            for i in 0..=400 {
                let t = f64::from(i) / 400.0;
                let (sin, cos) = trig::sin_cos(angle * t);
                let ta = (axes[0] * cos + other * sin).normalize();
                let tool = Tool { profile: &profile, te: te + way * (short * t) + ta * up, ta };
                least = least.min(tool.distance(q));
                beside = beside.min(tool.distance(p));
            }
            // Between the steps.
            let steps = (way.norm() * short + angle * 25.0) / 800.0;
            let (d, n, _) = body.near(q);
            prop_assert!((d - least).abs() <= body.slack(q, 0.0) + steps, "{} {}", d, least);
            prop_assert!(d + n.dot(&w) <= beside + body.slack(q, w.norm()) + 1e-9, "{} {}", d, beside);
            // Of a place beside another about the same middle.
            let z = Vec3::zeros();
            let cell = Cell { point: q, first: [w, z], second: [z; 3], rests: [0.0; 2], far: w.norm() };
            let [own, other] = body.slacks(&cell);
            prop_assert!(own <= body.slack(q, w.norm()) + 1e-12);
            prop_assert!(d + n.dot(&w) <= beside + own + 1e-9, "{} {}", d, beside);
            let (e, m, _) = body.near(q - w);
            prop_assert!(e + m.dot(&(w * 2.0)) <= beside + own + other + 1e-9, "{} {}", e, beside);
            prop_assert!(!body.misses(q, least + body.slack(q, 0.0) + 1e-9));
        }
    }

    #[test]
    fn of_axes_against_each_other_nothing_is_known() {
        let profile = Profile::new(&Cutter::mill(12.0, 1.0, 40.0)).unwrap();
        let body =
            Turned::new(&profile, 0.0, [(Vec3::zeros(), Vec3::z()), (Vec3::x(), -Vec3::z())]);
        assert!([0.0, 1.0].iter().all(|radius| body.slack(Vec3::x(), *radius) == f64::INFINITY));
    }
}
