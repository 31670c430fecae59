//! Gaps that hang on one place of a surface while the tool axis stands: the distance of one point of the tool, which a ball,
//! the tool end and what stands along the rulings have, or that of the circle of the corner's middles. The place is found
//! from the last one.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Profile, Reason, Shape, Spot, Surface, Tool, Vec3};

use crate::closed::is_axis;
use crate::crossing::over_crest;
use crate::dips::{Sample, dip, foretold, single};
use crate::edges;
use crate::gap::{Condition, Gap, Side};
use crate::guide::{Bends, ClosedGuide, End, Guide, Passed, Reading, is_ball};
use crate::ring::Ring;
use crate::search::several;

/// Change of the normal, as a vector, from which two places of contact on the cutter are two.
const ANOTHER: f64 = 0.1;

/// A surface with a cutter that does not turn, of which one point alone tells the gap.
#[derive(Clone, Copy, Debug)]
pub enum PointGuide {
    /// The gap is a closed form.
    Closed(ClosedGuide),
    /// It is the distance of a point.
    Point(Point),
    /// It is that of a circle.
    Ring(Ring),
}

/// The point of a tool that tells the gap.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    profile: Profile,
    ta: Vec3,
    touch: Touch,
    /// From the tool end to it.
    up: Vec3,
    /// The gap is the distance on this side, and `level`.
    sign: f64,
    level: f64,
    /// What the gap is less than the distance.
    thick: f64,
    /// Is the nearest place of all asked for, not the one near the last?
    nearest: bool,
    /// May another place of contact become the deepest?
    several: bool,
}

/// What touches.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Touch {
    /// The point itself, the tool end.
    End,
    /// The arc of a ball about it.
    Ball,
    /// The widest of a tool that stands along the rulings.
    Widest,
}

/// How the gap bends.
#[derive(Clone, Copy, Debug)]
pub enum PointBends {
    /// As a closed form tells.
    Closed(Bends),
    /// As the tool ends do at which the gap has one value.
    Level(Shape),
    /// Not while the flat end lies on a crest, and so once it has left it.
    Crest(Shape),
}

/// What is known of a place of a chord.
type Known = (Sample, Spot);

impl Guide for PointGuide {
    type At = Spot;
    type Bends = PointBends;
    type Bow = PointBends;

    fn new(
        tool: &Tool<'_>,
        surface: &Surface,
        condition: Condition,
        side: Side,
        thick: f64,
    ) -> Option<Self> {
        // About an edge the gap is another function than beside it.
        let edged = edges::has_edges(tool, surface);
        if edged && matches!(surface, Surface::Parametric(_)) {
            return None;
        }
        let closed = ClosedGuide::new(tool, surface, condition, side, thick).map(Self::Closed);
        let point = || Point::new(tool, surface, condition, side, thick).map(Self::Point);
        let ring = || Ring::new(tool, surface, condition, side, thick).map(Self::Ring);
        closed.or_else(point).or_else(|| if edged { None } else { ring() })
    }

    #[inline]
    fn at(gap: &Gap) -> Spot {
        gap.spot()
    }

    #[inline]
    fn ahead(before: Spot, here: Spot, factor: f64) -> Spot {
        onwards(&before, &here, 1.0 + factor).unwrap_or(here)
    }

    #[inline]
    fn several(&self) -> bool {
        match self {
            Self::Closed(_) => false,
            Self::Point(p) => p.several,
            Self::Ring(r) => r.several,
        }
    }

    #[inline]
    fn read(&self, surface: &Surface, te: Vec3, at: Spot) -> Option<Reading<Spot, PointBends>> {
        match self {
            Self::Closed(guide) => {
                let Reading { end: End { g, normal, .. }, bends } = guide.read(surface, te, ())?;
                let end = End { g, normal, at };
                Some(Reading { end, bends: PointBends::Closed(bends) })
            }
            Self::Point(p) => p.read(surface, te, Some(at)),
            Self::Ring(r) => r.read(surface, te, at),
        }
    }

    #[inline]
    fn leaves(&self, te: Vec3, end: &End<Spot>, along: Vec3) -> Option<f64> {
        match self {
            Self::Ring(r) => r.leaves(te, end, along),
            _ => None,
        }
    }

    #[inline]
    fn second(read: &Reading<Spot, PointBends>, v: Vec3) -> f64 {
        match &read.bends {
            PointBends::Closed(bends) => bends.second(read.end.normal, v),
            PointBends::Level(shape) => shape.second(v),
            PointBends::Crest(_) => 0.0,
        }
    }

    #[inline]
    fn beyond(read: &Reading<Spot, PointBends>, v: Vec3) -> f64 {
        match &read.bends {
            PointBends::Crest(shape) => shape.second(v),
            _ => Self::second(read, v),
        }
    }

    #[inline]
    fn turn(read: &Reading<Spot, PointBends>, v: Vec3) -> Vec3 {
        match &read.bends {
            PointBends::Closed(bends) => bends.turn(read.end.normal, v),
            PointBends::Level(shape) => shape.apply(v),
            PointBends::Crest(_) => Vec3::zeros(),
        }
    }

    #[inline]
    fn bow(read: &Reading<Spot, PointBends>) -> PointBends {
        read.bends
    }

    #[inline]
    fn gap(&self, te: Vec3, read: &End<Spot>) -> Gap {
        match self {
            Self::Closed(guide) => guide.gap(te, &closed(read)),
            Self::Point(p) => p.gap(te, read),
            Self::Ring(r) => r.gap(te, read),
        }
    }

    #[inline]
    fn chord(
        &self,
        surface: &Surface,
        te: Vec3,
        v: Vec3,
        ends: [&End<Spot>; 2],
        bows: Option<(PointBends, PointBends)>,
        resolution: f64,
    ) -> Option<Passed> {
        match self {
            Self::Closed(guide) => {
                let [a, b] = ends.map(closed);
                guide.chord(surface, te, v, [&a, &b], None, resolution)
            }
            Self::Point(p) => {
                // At a corner between two spans the gap has a kink, which smooth forms do not show.
                if edges::comes_over_corner(surface, ends.map(|end| end.at.at)) {
                    return None;
                }
                let read = |t: f64, near: Option<&Spot>| {
                    Some(p.read(surface, te + v * t, near.copied())?.end)
                };
                let apart = || p.apart(ends[0].normal, ends[1].normal);
                let sides = (p.sign, p.several);
                let bows = bows.filter(|_| !p.nearest);
                least_and_greatest(surface, sides, apart, v, (ends, bows), resolution, read)
            }
            Self::Ring(r) => {
                if !dome(surface, r.sign) && r.crosses(ends) {
                    let gaps = over_crest(r, surface, (te, v), ends, resolution)?;
                    return Some(Passed { gaps, crest: true });
                }
                let read =
                    |t: f64, near: Option<&Spot>| Some(r.read(surface, te + v * t, *near?)?.end);
                let apart = || false;
                let sides = (r.sign, r.several);
                least_and_greatest(surface, sides, apart, v, (ends, bows), resolution, read)
            }
        }
    }
}

fn closed(read: &End<Spot>) -> End<()> {
    End { g: read.g, normal: read.normal, at: () }
}

/// Least and greatest gap of a chord along `v`, of which `read` reads places: near a known one, or without it anew; `None` where
/// the contacts at both ends are `apart`, if that may be.
fn least_and_greatest(
    surface: &Surface,
    (sign, several): (f64, bool),
    apart: impl Fn() -> bool,
    v: Vec3,
    ([begin, end], bows): ([&End<Spot>; 2], Option<(PointBends, PointBends)>),
    resolution: f64,
    read: impl Fn(f64, Option<&Spot>) -> Option<End<Spot>>,
) -> Option<Passed> {
    let (low, high) = (begin.g.min(end.g), begin.g.max(end.g));
    let known =
        |t: f64, e: &End<Spot>| -> Known { (Sample { t, g: e.g, slope: e.normal.dot(&v) }, e.at) };
    let look = |t: f64, near: Option<&Spot>| -> Result<Known, Reason> {
        Ok(known(t, &read(t, near).ok_or(Reason::NoHit)?))
    };
    let (a, b) = (known(0.0, begin), known(1.0, end));
    if dome(surface, sign) {
        let beside = |t: f64, near: &Spot| look(t, Some(near));
        return Some([dip(a, b, 1.0, resolution, beside).ok()?.g, high].into());
    }
    let hollow = dome(surface, -sign);
    if (several || !hollow) && apart() {
        return None;
    }
    if hollow {
        // The nearest wall may change on the way: it is looked for anew.
        let whole = |t: f64, _: &Spot| look(t, None);
        return Some([low, dip(a, b, -1.0, resolution, whole).ok()?.g].into());
    }
    // Where the surface is smooth between both ends these tell what is between, if they agree on it.
    let second = |end: &End<Spot>, bends| PointGuide::second(&Reading { end: *end, bends }, v);
    if let Some((at_begin, at_end)) = bows
        && let Surface::Parametric(s) = surface
        && begin.at.at.zip(end.at.at).is_some_and(|(from, to)| s.is_smooth_between(from, to))
        && let bends = [second(begin, at_begin), second(end, at_end)]
        && let Some(found) = foretold(&a.0, &b.0, bends, resolution)
    {
        return Some([low.min(found.g), high.max(found.g)].into());
    }
    let between = |a: &Known, b: &Known, t: f64| look(t, Some(&between(a, b, t)));
    let found = single(a, b, resolution, |k| k.0, between).ok()??;
    Some([low.min(found.g), high.max(found.g)].into())
}

/// Is the surface convex on that side?
fn dome(surface: &Surface, sign: f64) -> bool {
    if sign > 0.0 { surface.convex() } else { surface.concave() }
}

/// About where the place of a chord is between two that are known; where their parameters tell nothing, as on both sides of a seam,
/// the nearer of both.
fn between(a: &Known, b: &Known, t: f64) -> Spot {
    let share = (t - a.0.t) / (b.0.t - a.0.t);
    onwards(&a.1, &b.1, share).unwrap_or(if share <= 0.5 { a.1 } else { b.1 })
}

/// The place as far from `a` as `b` is, times a factor, by parameters that change evenly; `None` where they lie far apart.
fn onwards(a: &Spot, b: &Spot, factor: f64) -> Option<Spot> {
    /// How far the parameters are apart at most, of a surface over which each runs by 1.
    const NEAR: f64 = 1e-2;
    let (from, to) = (a.at?, b.at?);
    let by = [to[0] - from[0], to[1] - from[1]];
    let near = by[0].abs() <= NEAR && by[1].abs() <= NEAR;
    let at = [from[0] + by[0] * factor, from[1] + by[1] * factor];
    near.then(|| Spot { point: a.point + (b.point - a.point) * factor, at: Some(at) })
}

impl Point {
    fn new(
        tool: &Tool<'_>,
        surface: &Surface,
        condition: Condition,
        side: Side,
        thick: f64,
    ) -> Option<Self> {
        use Surface::{Cone, Parametric, Quadric, Tabcyl};
        // The vertex of a cone has no bends, and is left to the general form.
        let beside = matches!(surface, Parametric(_) | Quadric(_) | Tabcyl(_))
            || matches!(surface, Cone(_)) && side == Side::Positive;
        if side == Side::Open || !beside {
            return None;
        }
        let on = condition == Condition::On;
        let end = on || tool.profile.reach() == 0.0;
        let thick = if on { 0.0 } else { thick };
        let (up, radius, touch) = if end {
            (Vec3::zeros(), 0.0, Touch::End)
        } else if surface.generator().is_some_and(|d| is_axis(tool, d)) {
            (Vec3::zeros(), tool.profile.widest(), Touch::Widest)
        } else if is_ball(tool.profile) {
            let [_, high] = tool.profile.corner();
            (tool.ta * high, tool.profile.corner_radius(), Touch::Ball)
        } else {
            return None;
        };
        Some(Self {
            profile: *tool.profile,
            ta: tool.ta,
            touch,
            up,
            sign: side.sign(),
            level: -radius - thick,
            thick,
            nearest: end && matches!(surface, Parametric(_)),
            several: !end && several(tool, surface, side),
        })
    }

    /// Do two places of contact lie far from each other on the cutter?
    #[inline]
    fn apart(&self, a: Vec3, b: Vec3) -> bool {
        self.touch != Touch::End && (a - b).norm_squared() > ANOTHER * ANOTHER
    }

    fn read(
        &self,
        surface: &Surface,
        te: Vec3,
        near: Option<Spot>,
    ) -> Option<Reading<Spot, PointBends>> {
        let p = te + self.up;
        let foot = match near.and_then(|n| n.at) {
            Some(at) if !self.nearest => surface.foot_from(p, Spot { point: p, at: Some(at) }),
            _ => surface.foot(p),
        };
        let normal = foot.normal * self.sign;
        // A ball touches with its lower half.
        let another = self.touch == Touch::Ball && normal.dot(&self.ta) < 0.0;
        if another || surface.ends_at(foot.at) {
            return None;
        }
        let away = self.sign * foot.distance;
        let shape = if self.sign > 0.0 { foot.shape } else { foot.shape.reversed() };
        // Corners go round, which is left to the general forms.
        let smooth = shape.k.iter().all(|k| k.is_finite());
        let bends = PointBends::Level(shape.offset(away).filter(|_| smooth)?);
        Some(Reading { end: End { g: away + self.level, normal, at: foot.spot() }, bends })
    }

    fn gap(&self, te: Vec3, &End { g, normal, at }: &End<Spot>) -> Gap {
        let raw = g + self.thick;
        let (tool_point, segment) = match self.touch {
            Touch::End => (te, None),
            Touch::Ball => {
                let arc = self.up - normal * self.profile.corner_radius();
                (te + arc, Some(Segment::Arc))
            }
            Touch::Widest => {
                let p = Tool { profile: &self.profile, te, ta: self.ta }.support(-normal);
                (p.point, Some(p.segment))
            }
        };
        let surface_point = tool_point - normal * raw;
        Gap { g, raw, tool_point, surface_point, at: at.at, normal, segment, residual: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::{chord, distance, second};
    use aptc_geometry::{Cone, Cutter, Fit, Form, Knot, Quadric, QuadricKind, Tabcyl, Vec2};
    use proptest::prelude::*;

    impl PointGuide {
        /// The chord between two readings to 1e-10, which is the same whether the ends foretell what is between or that is met.
        pub(crate) fn foretold_as_met(
            &self,
            surface: &Surface,
            te: Vec3,
            v: Vec3,
            [a, b]: [&Reading<Spot, PointBends>; 2],
        ) -> Option<[f64; 2]> {
            let told = |bows| Some(self.chord(surface, te, v, [&a.end, &b.end], bows, 1e-10)?.gaps);
            let [low, high] = told(Some((a.bends, b.bends)))?;
            if let Some([least, greatest]) = told(None) {
                let off = (low - least).abs().max((high - greatest).abs());
                assert!(off < 3e-10, "{low} {least} {high} {greatest}");
            }
            Some([low, high])
        }
    }

    fn vec(x: [f64; 3]) -> Vec3 {
        Vec3::new(x[0], x[1], x[2])
    }

    /// An ellipsoid, a saddle, a hyperboloid, a cone, and a wave along the y axis.
    fn surface(kind: usize) -> Surface {
        let quadric = |c: [f64; 10]| {
            Surface::from_form(&Form::Quadric(Quadric { kind: QuadricKind::Qadric, c }))
        };
        let found = match kind {
            0 => quadric([
                1.0 / 900.0,
                1.0 / 1600.0,
                1.0 / 625.0,
                -1.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ]),
            1 => quadric([0.02, -0.015, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5]),
            2 => quadric([
                1.0 / 900.0,
                1.0 / 900.0,
                -1.0 / 400.0,
                -1.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ]),
            3 => {
                let axis = Vec3::new(0.6, 0.0, -0.8);
                Surface::from_form(&Form::Cone(Cone {
                    vertex: Vec3::new(3.0, -2.0, 8.0),
                    axis,
                    cos_half: 0.9,
                }))
            }
            _ => {
                let at = |x: f64, y: f64| Knot { point: Vec2::new(x, y), tangent: None };
                let knots =
                    [at(-40.0, 0.0), at(-20.0, 6.0), at(0.0, 0.0), at(25.0, -5.0), at(50.0, 2.0)];
                let axes = nalgebra::Matrix3::new(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0);
                let wave = Tabcyl::fit(&knots, Fit::Spline, axes.transpose(), 100.0).unwrap();
                Surface::from_form(&Form::Tabcyl(Arc::new(wave)))
            }
        };
        found.unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]
        #[test]
        fn reads_what_the_general_forms_read(
            kind in 0_usize..5, stands in any::<bool>(), on in any::<bool>(), inside in any::<bool>(),
            thick in -0.3_f64..0.5,
            [te, v, ta] in prop::array::uniform3(prop::array::uniform3(-1.0_f64..1.0)),
        ) {
            let surface = surface(kind);
            let ta = match surface.generator() {
                Some(along) if stands => along,
                _ => vec(ta),
            };
            prop_assume!(ta.norm() > 0.1);
            let ta = ta.normalize();
            let profile = Profile::new(&Cutter::mill(6.0, 3.0, 3.0)).unwrap();
            let condition = if on { Condition::On } else { Condition::Touch };
            let side = if inside { Side::Negative } else { Side::Positive };
            let (te, v) = (vec(te) * 30.0, vec(v) * 2.0);
            let tool = Tool { profile: &profile, te, ta };
            prop_assume!(!matches!(surface, Surface::Cone(_)) || side == Side::Positive);
            let guide = Point::new(&tool, &surface, condition, side, thick);
            let guide = guide.expect("a ball and its end are guided");
            let Some(a) = guide.read(&surface, te, None) else { return Ok(()) };
            let Some(b) = guide.read(&surface, te + v, Some(a.end.at)) else { return Ok(()) };
            let near = |te: Vec3, at: Spot| {
                let point = guide.gap(te, &a.end).surface_point;
                distance(&tool.at(te), &surface, condition, side, thick, Some(Spot { point, ..at })).unwrap()
            };
            let ends = [near(te, a.end.at), near(te + v, a.end.at)];
            for (te, read, gap) in [(te, &a, &ends[0]), (te + v, &b, &ends[1])] {
                prop_assert!((read.end.g - gap.g).abs() < 1e-9, "{read:?} {gap:?}");
                prop_assert!((read.end.normal - gap.normal).norm() < 1e-6);
                let made = guide.gap(te, &read.end);
                prop_assert!((made.tool_point - gap.tool_point).norm() < 1e-5, "{made:?} {gap:?}");
                prop_assert!((made.surface_point - gap.surface_point).norm() < 1e-5, "{made:?} {gap:?}");
                prop_assert_eq!(made.segment, gap.segment);
                prop_assert!((made.raw - gap.raw).abs() < 1e-9);
                if let Some(shape) = second(&tool.at(te), &surface, side, gap) {
                    let d = v.normalize();
                    let (x, y) = (PointGuide::second(read, d), shape.second(d));
                    prop_assert!((x - y).abs() < 1e-5 * (1.0 + x.abs() * x.abs()), "{x} {y} {gap:?}");
                }
            }
            // Deep inside the nearest place changes along a chord.
            if a.end.g.abs() > 5.0 {
                return Ok(());
            }
            let path = PointGuide::Point(guide);
            let Some([low, high]) = path.foretold_as_met(&surface, te, v, [&a, &b]) else { return Ok(()) };
            let to = tool.at(te + v);
            let whole = chord(&tool, &to, &surface, condition, side, thick, Some(ends), 1e-10).unwrap();
            prop_assert!((low - whole.low.g).abs() < 1e-8, "{low} {whole:?}");
            prop_assert!((high - whole.high.g).abs() < 1e-8, "{high} {whole:?}");
        }
    }
}
