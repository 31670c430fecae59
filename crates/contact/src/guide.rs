//! Gaps that are closed forms of the place of the tool end while the tool axis stands: of any cutter to a plane, a sphere
//! from outside and a cylinder along or square to the axis, of a ball to any cylinder, of the tool end to all of them.
//!
//! What does not change along a motion is worked out once. The values are those of [`crate::distance`] to rounding.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Profile, Surface, Tool, Vec3};

use crate::closed::is_axis;
use crate::dips::{Sample, dip};
use crate::gap::{Condition, Gap, Side};

/// Sine of the angle between two directions below which they count as square to each other.
const SQUARE: f64 = 1e-12;

/// A surface with a cutter that does not turn.
#[derive(Clone, Copy, Debug)]
pub struct ClosedGuide {
    form: Form,
    touch: Touch,
    profile: Profile,
    ta: Vec3,
    /// What the gap is less than the distance.
    thick: f64,
}

/// A surface with a cutter that does not turn, and what is read of the gap between them.
pub trait Guide: Sized {
    /// What is known of the place of the surface, for the next reading to begin at.
    type At: Copy;
    /// How the gap bends.
    type Bends: Copy;
    /// What of that a chord asks for at its ends: nothing where the gap along it is a closed form.
    type Bow: Copy;

    /// The guide of what [`crate::distance`] is asked for, where there is one.
    fn new(
        tool: &Tool<'_>,
        surface: &Surface,
        condition: Condition,
        side: Side,
        thick: f64,
    ) -> Option<Self>;

    /// The place of a gap.
    fn at(gap: &Gap) -> Self::At;

    /// About where the place is after one that came from `before`, on a way so many times as long.
    fn ahead(before: Self::At, here: Self::At, factor: f64) -> Self::At;

    /// May another place of contact than that read become the deepest, so that it has to be looked for?
    fn several(&self) -> bool;

    /// The gap to the `surface` that the guide is made for with the tool end at `te`, at the place near `at`; `None` where
    /// another part of the cutter touches than the guide is made for, at an end of the surface, and in its middle, where
    /// no normal is.
    fn read(
        &self,
        surface: &Surface,
        te: Vec3,
        at: Self::At,
    ) -> Option<Reading<Self::At, Self::Bends>>;

    /// How far the tool goes on along the unit vector with what its flat end touches below it; `None` where it touches otherwise.
    fn leaves(&self, te: Vec3, end: &End<Self::At>, along: Vec3) -> Option<f64>;

    /// Second derivative of the gap that was read when the tool end moves along `v`; see [`crate::second`].
    fn second(read: &Reading<Self::At, Self::Bends>, v: Vec3) -> f64;

    /// The same as cut vectors meet it that go on from there: where a flat end lies on a crest, how the gap bends once it has left it.
    fn beyond(read: &Reading<Self::At, Self::Bends>, v: Vec3) -> f64 {
        Self::second(read, v)
    }

    /// By how much its normal turns on a way `v` so short that the bends do not change.
    fn turn(read: &Reading<Self::At, Self::Bends>, v: Vec3) -> Vec3;

    /// What the chords to and from a place ask for.
    fn bow(read: &Reading<Self::At, Self::Bends>) -> Self::Bow;

    /// The gap in full at a place where this was read.
    fn gap(&self, te: Vec3, read: &End<Self::At>) -> Gap;

    /// Least and greatest gap while the tool end moves by `v` from `te`, as of [`crate::chord()`]; `ends` are what is read at
    /// both ends, with their `bows` where they were read. `None` where nothing is at the first, where more than one dip or bump may
    /// be on the way, and where the contacts at both ends lie far from each other on the cutter, so that it may have gone over from
    /// one place to another.
    fn chord(
        &self,
        surface: &Surface,
        te: Vec3,
        v: Vec3,
        ends: [&End<Self::At>; 2],
        bows: Option<(Self::Bow, Self::Bow)>,
        resolution: f64,
    ) -> Option<Passed>;
}

/// What a chord passes.
#[derive(Clone, Copy, Debug)]
pub struct Passed {
    /// Least and greatest gap on it.
    pub gaps: [f64; 2],
    /// Does the flat end of the cutter come onto a crest, go over it or leave it?
    pub crest: bool,
}

impl From<[f64; 2]> for Passed {
    #[inline]
    fn from(gaps: [f64; 2]) -> Self {
        Self { gaps, crest: false }
    }
}

#[derive(Clone, Copy, Debug)]
enum Form {
    /// `n . te - d`.
    Plane { n: Vec3, d: f64 },
    /// `sign` times the distance of the tool end from a point, or from the line along `along`, and `level`; as far as `up`
    /// points from there to the tool end.
    Round { from: Vec3, along: Vec3, sign: f64, level: f64, up: Vec3 },
    /// The distance of the cutter from a point, or from the line along `along` square to its axis, and `level`.
    Solid { from: Vec3, along: Vec3, level: f64 },
}

/// What touches.
#[derive(Clone, Copy, Debug)]
enum Touch {
    /// The tool end.
    End,
    /// The arc of a ball.
    Ball,
    /// The extreme point against the normal.
    Extreme,
}

/// The gap at a place.
#[derive(Clone, Copy, Debug)]
pub struct Reading<At, Bends> {
    /// Gap, gradient and place.
    pub end: End<At>,
    /// How it bends.
    pub(crate) bends: Bends,
}

/// Second derivatives of a gap across its normal: along `across` and square to it.
#[derive(Clone, Copy, Debug)]
pub struct Bends {
    pub(crate) along: f64,
    pub(crate) aside: f64,
    pub(crate) across: Vec3,
}

/// The gap at an end of a chord.
#[derive(Clone, Copy, Debug)]
pub struct End<At> {
    /// Signed gap less THICK, as in [`Gap`].
    pub g: f64,
    /// Its gradient, a unit vector.
    pub normal: Vec3,
    /// Where on the surface.
    pub at: At,
}

impl Bends {
    /// That along `v`, of a gap with this unit normal.
    #[inline]
    pub(crate) fn second(&self, normal: Vec3, v: Vec3) -> f64 {
        let (out, aside) = (normal.dot(&v), self.across.dot(&v));
        let rest = v.norm_squared() - out * out - aside * aside;
        self.along * aside * aside + self.aside * rest
    }

    /// By how much the normal turns along `v`.
    #[inline]
    pub(crate) fn turn(&self, normal: Vec3, v: Vec3) -> Vec3 {
        let aside = self.across * self.across.dot(&v);
        aside * self.along + (v - normal * normal.dot(&v) - aside) * self.aside
    }
}

impl<At: Copy, Bends: Copy> Reading<At, Bends> {
    /// What is read a way `by` farther, where that is so short that the bends do not change on it; and how much of the gap
    /// they make.
    #[inline(always)]
    pub fn moved<G: Guide<At = At, Bends = Bends>>(&self, by: Vec3) -> (Self, f64) {
        let End { g, normal, at } = self.end;
        let bent = 0.5 * G::second(self, by);
        let end = End { g: g + normal.dot(&by) + bent, normal: normal + G::turn(self, by), at };
        (Self { end, bends: self.bends }, bent)
    }
}

impl Guide for ClosedGuide {
    type At = ();
    type Bends = Bends;
    type Bow = ();

    fn new(
        tool: &Tool<'_>,
        surface: &Surface,
        condition: Condition,
        side: Side,
        thick: f64,
    ) -> Option<Self> {
        let on = condition == Condition::On;
        let end = on || tool.profile.reach() == 0.0;
        let thick = if on { 0.0 } else { thick };
        let sign = side.sign();
        let (from, along, radius) = match surface {
            Surface::Plane(s) => {
                let n = s.n * sign;
                let (reach, touch) = if end {
                    (0.0, Touch::End)
                } else {
                    (n.dot(&tool.te) + tool.support(-n).reach, Touch::Extreme)
                };
                let form = Form::Plane { n, d: reach + sign * s.d + thick };
                return Some(Self { form, touch, profile: *tool.profile, ta: tool.ta, thick });
            }
            Surface::Sphere(s) => (s.center, Vec3::zeros(), s.radius),
            Surface::Cylinder(s) => (s.point, s.axis, s.radius),
            _ => return None,
        };
        let (beside, outside) = (along != Vec3::zeros(), side == Side::Positive);
        let round = |from: Vec3, radius: f64, up: Vec3| {
            let level = -sign * radius - thick;
            Form::Round { from, along, sign, level, up }
        };
        let no = Vec3::zeros();
        let (form, touch) = if end {
            (round(from, radius, no), Touch::End)
        } else if beside && is_axis(tool, along) {
            (round(from, radius + sign * tool.profile.widest(), no), Touch::Extreme)
        } else if outside && is_ball(tool.profile) {
            let [_, high] = tool.profile.corner();
            let up = tool.ta - along * tool.ta.dot(&along);
            let radius = radius + tool.profile.corner_radius();
            (round(from - tool.ta * high, radius, up), Touch::Ball)
        } else if outside && along.dot(&tool.ta).abs() <= SQUARE {
            (Form::Solid { from, along, level: -radius - thick }, Touch::Extreme)
        } else {
            return None;
        };
        Some(Self { form, touch, profile: *tool.profile, ta: tool.ta, thick })
    }

    #[inline]
    fn at(_: &Gap) {}

    #[inline]
    fn ahead((): (), (): (), _: f64) {}

    #[inline]
    fn several(&self) -> bool {
        false
    }

    #[inline(always)]
    fn read(&self, _: &Surface, te: Vec3, (): ()) -> Option<Reading<(), Bends>> {
        match &self.form {
            Form::Plane { n, d } => Some(reading(n.dot(&te) - d, *n, [0.0; 2], Vec3::zeros())),
            Form::Round { from, along, sign, level, up } => {
                let w = te - from;
                let w = w - along * w.dot(along);
                let away = w.norm();
                let bend = sign / away;
                let found = reading(sign * away + level, w * bend, [0.0, bend], *along);
                (away > 0.0 && up.dot(&w) >= 0.0).then_some(found)
            }
            Form::Solid { from, along, level } => Some(self.solid(te, [*from, *along], *level)),
        }
    }

    #[inline]
    fn leaves(&self, _: Vec3, _: &End<()>, _: Vec3) -> Option<f64> {
        None
    }

    #[inline]
    fn second(read: &Reading<(), Bends>, v: Vec3) -> f64 {
        read.bends.second(read.end.normal, v)
    }

    #[inline]
    fn turn(read: &Reading<(), Bends>, v: Vec3) -> Vec3 {
        read.bends.turn(read.end.normal, v)
    }

    #[inline]
    fn bow(_: &Reading<(), Bends>) {}

    #[inline]
    fn gap(&self, te: Vec3, &End { g, normal, .. }: &End<()>) -> Gap {
        let raw = g + self.thick;
        let (tool_point, segment) = match (self.touch, &self.form) {
            (Touch::End, _) => (te, None),
            (Touch::Ball, _) => {
                let [_, high] = self.profile.corner();
                let arc = self.ta * high - normal * self.profile.corner_radius();
                (te + arc, Some(Segment::Arc))
            }
            (Touch::Extreme, Form::Solid { from, along, .. }) => {
                let w = from - te;
                let near = self.tool(te).near(te + (w - along * w.dot(along)));
                (near.point, Some(near.segment))
            }
            (Touch::Extreme, _) => {
                let p = self.tool(te).support(-normal);
                (p.point, Some(p.segment))
            }
        };
        let surface_point = tool_point - normal * raw;
        Gap { g, raw, tool_point, surface_point, at: None, normal, segment, residual: 0.0 }
    }

    #[inline(always)]
    fn chord(
        &self,
        _: &Surface,
        te: Vec3,
        v: Vec3,
        [begin, end]: [&End<()>; 2],
        _: Option<((), ())>,
        resolution: f64,
    ) -> Option<Passed> {
        let (low, high) = if begin.g < end.g { (begin.g, end.g) } else { (end.g, begin.g) };
        match &self.form {
            Form::Plane { .. } => Some([low, high].into()),
            Form::Round { along, sign, level, up, .. } => {
                // A level normal is that of the flank above the ball.
                let lean = sign * up.dot(&begin.normal);
                let level_off = lean <= 0.0 || lean * lean <= SQUARE * SQUARE * up.norm_squared();
                if matches!(self.touch, Touch::Ball) && level_off {
                    return None;
                }
                // The nearest place of the chord, by how far it comes in there.
                let (away, aside) = (sign * (begin.g - level), along.dot(&v));
                let fall = -sign * away * begin.normal.dot(&v);
                let length = v.norm_squared() - aside * aside;
                if !(fall > 0.0 && fall < length) {
                    return Some([low, high].into());
                }
                let square = fall * fall / length;
                let rest = away * away - square;
                let rest = if rest > 0.0 { rest.sqrt() } else { 0.0 };
                let inner = begin.g - sign * square / (rest + away);
                Some(if *sign > 0.0 { [inner, high] } else { [low, inner] }.into())
            }
            Form::Solid { from, along, level } => {
                let least = self.least(te, v, [begin, end], [*from, *along], *level, resolution);
                Some([least?, high].into())
            }
        }
    }
}

impl ClosedGuide {
    #[inline]
    fn tool(&self, te: Vec3) -> Tool<'_> {
        Tool { profile: &self.profile, te, ta: self.ta }
    }

    /// The least gap of [`Form::Solid`] along a chord.
    fn least(
        &self,
        te: Vec3,
        v: Vec3,
        [begin, end]: [&End<()>; 2],
        middle: [Vec3; 2],
        level: f64,
        resolution: f64,
    ) -> Option<f64> {
        let sample = |t: f64, e: &End<()>| Sample { t, g: e.g, slope: e.normal.dot(&v) };
        let at = |t: f64, (): &()| {
            let read = self.solid(te + v * t, middle, level);
            Ok((sample(t, &read.end), ()))
        };
        let (first, last) = (sample(0.0, begin), sample(1.0, end));
        Some(dip((first, ()), (last, ()), 1.0, resolution, at).ok()?.g)
    }

    /// What is read of [`Form::Solid`].
    #[inline]
    fn solid(&self, te: Vec3, [from, along]: [Vec3; 2], level: f64) -> Reading<(), Bends> {
        let w = from - te;
        let near = self.tool(te).near(te + (w - along * w.dot(&along)));
        let [bend, _, around] = near.shape.k;
        let (around, across) = match along == Vec3::zeros() {
            true => (around, near.shape.frame[1]),
            false => (0.0, along),
        };
        reading(near.distance + level, -near.normal, [around, bend], across)
    }
}

#[inline(always)]
fn reading(g: f64, normal: Vec3, [along, aside]: [f64; 2], across: Vec3) -> Reading<(), Bends> {
    Reading { end: End { g, normal, at: () }, bends: Bends { along, aside, across } }
}

/// Is the cutter a ball up to the height of its middle? All below the middle it then touches with its arc.
pub(crate) fn is_ball(profile: &Profile) -> bool {
    let (r, [_, high]) = (profile.corner_radius(), profile.corner());
    let [[inner, _], [wide, top]] = profile.joints();
    let near = 1e-12 * r;
    let half = (wide - r).abs() <= near && (top - high).abs() <= near;
    r > 0.0 && profile.is_round() && inner <= 0.0 && half
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{chord, distance, second};
    use aptc_geometry::{Cutter, Cylinder, Plane, Sphere};
    use proptest::prelude::*;

    /// Difference of the values beyond which one of both is wrong, for numbers of this size.
    const NEAR: f64 = 1e-9;

    fn vec(x: [f64; 3]) -> Vec3 {
        Vec3::new(x[0], x[1], x[2])
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        #[test]
        fn reads_what_the_general_forms_read(
            kind in 0_usize..3, how in 0_usize..4, lie in 0_usize..3, inside in any::<bool>(), on in any::<bool>(),
            thick in -0.3_f64..0.5,
            [te, v, ta, axis, center] in prop::array::uniform5(prop::array::uniform3(-1.0_f64..1.0)),
        ) {
            let cutter = match how {
                0 => Cutter::mill(10.0, 5.0, 40.0),
                1 => Cutter::mill(10.0, 2.0, 40.0),
                2 => Cutter::mill(10.0, 0.0, 40.0),
                _ => Cutter::mill(0.0, 0.0, 40.0),
            };
            let profile = Profile::new(&cutter).unwrap();
            let [ta, axis] = [ta, axis].map(vec);
            prop_assume!(ta.norm() > 0.1 && axis.cross(&ta).norm() > 0.1);
            let ta = ta.normalize();
            let axis = match lie {
                0 => ta,
                1 => axis.cross(&ta).normalize(),
                _ => axis.normalize(),
            };
            let center = vec(center) * 40.0;
            let surface = match kind {
                0 => Surface::Plane(Plane { n: axis, d: 3.0 }),
                1 => Surface::Sphere(Sphere { center, radius: 25.0 }),
                _ => Surface::Cylinder(Cylinder { point: center, axis, radius: 25.0 }),
            };
            let condition = if on { Condition::On } else { Condition::Touch };
            let side = if inside { Side::Negative } else { Side::Positive };
            let (te, v) = (vec(te) * 40.0, vec(v) * 9.0);
            let tool = Tool { profile: &profile, te, ta };
            let Some(guide) = ClosedGuide::new(&tool, &surface, condition, side, thick) else { return Ok(()) };
            let (Some(a), Some(b)) = (guide.read(&surface, te, ()), guide.read(&surface, te + v, ())) else { return Ok(()) };
            let whole = |te: Vec3| distance(&tool.at(te), &surface, condition, side, thick, None).unwrap();
            let ends = [whole(te), whole(te + v)];
            for (te, reading, gap) in [(te, &a, &ends[0]), (te + v, &b, &ends[1])] {
                prop_assert!((reading.end.g - gap.g).abs() < NEAR, "{reading:?} {gap:?}");
                let slant = (reading.end.normal - gap.normal).norm();
                prop_assert!(slant < 1e-6, "{reading:?} {gap:?}");
                let made = guide.gap(te, &reading.end);
                prop_assert!((made.tool_point - gap.tool_point).norm() < 1e-4, "{made:?} {gap:?}");
                prop_assert!((made.surface_point - gap.surface_point).norm() < 1e-4);
                prop_assert_eq!(made.segment, gap.segment);
                prop_assert!((made.raw - gap.raw).abs() < NEAR);
                let edge = gap.segment.is_some_and(|s| s != Segment::Arc);
                if let Some(shape) = second(&tool.at(te), &surface, side, gap)
                    && !(edge && gap.raw.abs() < 1.0)
                {
                    let d = v.normalize();
                    let (x, y) = (ClosedGuide::second(reading, d), shape.second(d));
                    prop_assert!((x - y).abs() < 1e-6 * (1.0 + x.abs()), "{x} {y} {gap:?}");
                }
            }
            let to = tool.at(te + v);
            let c = chord(&tool, &to, &surface, condition, side, thick, Some(ends), 1e-10).unwrap();
            let passed = guide.chord(&surface, te, v, [&a.end, &b.end], None, 1e-10).unwrap();
            let [low, high] = passed.gaps;
            prop_assert!((low - c.low.g).abs() < NEAR, "{low} {c:?}");
            prop_assert!((high - c.high.g).abs() < NEAR, "{high} {c:?}");
            for i in 0..=20 {
                let g = whole(te + v * (f64::from(i) / 20.0)).g;
                prop_assert!((low - NEAR..=high + NEAR).contains(&g), "{g} in {low} {high}");
            }
        }
    }

    /// Beside the flank the normal is level, as it is where the ball begins: a chord from there is none of the ball.
    #[test]
    fn a_chord_that_begins_beside_the_flank_is_none_of_the_ball() {
        let profile = Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap();
        let surface = Surface::Sphere(Sphere { center: Vec3::zeros(), radius: 25.0 });
        let (ta, touch, side) = (Vec3::z(), Condition::Touch, Side::Positive);
        for lean in [0.0, 1e-17, -1e-17] {
            let te = Vec3::new(29.0, 8.0, -5.5);
            let tool = Tool { profile: &profile, te, ta };
            let guide = ClosedGuide::new(&tool, &surface, touch, side, 0.0).unwrap();
            let mut begin = distance(&tool, &surface, touch, side, 0.0, None).unwrap();
            assert_eq!(begin.segment, Some(Segment::UpperLine));
            begin.normal.z = lean;
            let begin = End { g: begin.g, normal: begin.normal, at: () };
            let v = Vec3::new(0.5, -4.0, 3.0);
            let end = guide.read(&surface, te + v, ()).unwrap().end;
            assert!(guide.chord(&surface, te, v, [&begin, &end], None, 1e-9).is_none());
        }
    }
}
