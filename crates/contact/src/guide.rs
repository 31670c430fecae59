//! Gaps that are closed forms of the place of the tool end while the tool axis stands: of any cutter to a plane, a sphere
//! from outside and a cylinder along or square to the axis, of a ball to any cylinder, of the tool end to all of them.
//!
//! What does not change along a motion is worked out once. The values are those of [`crate::distance`] to rounding.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Profile, Surface, Tool, Vec3};

use crate::chord::{Sample, dip};
use crate::closed::is_axis;
use crate::gap::{Condition, Gap, Side};

/// Sine of the angle between two directions below which they count as square to each other.
const SQUARE: f64 = 1e-12;

/// A surface with a cutter that does not turn.
#[derive(Clone, Copy, Debug)]
pub struct Guide {
    form: Form,
    touch: Touch,
    profile: Profile,
    ta: Vec3,
    /// What the gap is less than the distance.
    thick: f64,
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
pub struct Reading {
    /// Signed gap less THICK, as in [`Gap`].
    pub g: f64,
    /// Its gradient, a unit vector.
    pub normal: Vec3,
    /// Second derivatives across the normal: along `across` and square to it.
    bends: [f64; 2],
    across: Vec3,
}

impl Reading {
    /// Second derivative of the gap when the tool end moves along `v`; see [`crate::second`].
    #[inline]
    pub fn second(&self, v: Vec3) -> f64 {
        let (out, aside) = (self.normal.dot(&v), self.across.dot(&v));
        let rest = v.norm_squared() - out * out - aside * aside;
        self.bends[0] * aside * aside + self.bends[1] * rest
    }
}

impl Guide {
    /// The guide of what [`crate::distance`] is asked for, where there is one.
    pub fn new(
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

    /// The gap with the tool end at `te`; `None` where another part of the cutter touches than the guide is made for,
    /// and in the middle of the surface, where no normal is.
    #[inline]
    pub fn read(&self, te: Vec3) -> Option<Reading> {
        match &self.form {
            Form::Plane { n, d } => {
                let g = n.dot(&te) - d;
                Some(Reading { g, normal: *n, bends: [0.0; 2], across: Vec3::zeros() })
            }
            Form::Round { from, along, sign, level, up } => {
                let w = te - from;
                let w = w - along * w.dot(along);
                let away = w.norm();
                let bend = sign / away;
                let reading = Reading {
                    g: sign * away + level,
                    normal: w * bend,
                    bends: [0.0, bend],
                    across: *along,
                };
                (away > 0.0 && up.dot(&w) >= 0.0).then_some(reading)
            }
            Form::Solid { from, along, level } => {
                let w = from - te;
                let near = self.tool(te).near(te + (w - along * w.dot(along)));
                let [bend, _, around] = near.shape.k;
                let straight = along != &Vec3::zeros();
                let (around, across) =
                    if straight { (0.0, *along) } else { (around, near.shape.frame[1]) };
                Some(Reading {
                    g: near.distance + level,
                    normal: -near.normal,
                    bends: [around, bend],
                    across,
                })
            }
        }
    }

    /// The gap in full at a place where `g` and `normal` were read.
    #[inline]
    pub fn gap(&self, te: Vec3, g: f64, normal: Vec3) -> Gap {
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

    /// Least and greatest gap while the tool end moves by `v` from `te`, as of [`crate::chord`]; `ends` are gap and rate of
    /// change at both ends, of which the second has a reading. `None` where the first has none.
    #[inline]
    pub fn chord(
        &self,
        te: Vec3,
        v: Vec3,
        ends: [[f64; 2]; 2],
        resolution: f64,
    ) -> Option<[f64; 2]> {
        let [[a, rate], [b, rate_at_end]] = ends;
        let (low, high) = (a.min(b), a.max(b));
        match &self.form {
            Form::Plane { .. } => Some([low, high]),
            Form::Round { from, along, sign, up, .. } => {
                let w = te - from;
                let w = w - along * w.dot(along);
                if up.dot(&w) < 0.0 {
                    return None;
                }
                let v = v - along * v.dot(along);
                let t = -w.dot(&v) / v.norm_squared();
                if !(t > 0.0 && t < 1.0) {
                    return Some([low, high]);
                }
                let inner = a + sign * ((w + v * t).norm() - w.norm());
                Some(if *sign > 0.0 { [inner, high] } else { [low, inner] })
            }
            Form::Solid { .. } => {
                let at = |t: f64, (): &()| {
                    // Solids are read everywhere.
                    let r = self.read(te + v * t).ok_or(aptc_geometry::Reason::NoHit)?;
                    Ok((Sample { t, g: r.g, slope: r.normal.dot(&v) }, ()))
                };
                let first = Sample { t: 0.0, g: a, slope: rate };
                let last = Sample { t: 1.0, g: b, slope: rate_at_end };
                let found = dip((first, ()), (last, ()), 1.0, resolution, at);
                Some([found.ok()?.g, high])
            }
        }
    }

    #[inline]
    fn tool(&self, te: Vec3) -> Tool<'_> {
        Tool { profile: &self.profile, te, ta: self.ta }
    }
}

/// Is the cutter a ball up to the height of its middle? All below the middle it then touches with its arc.
fn is_ball(profile: &Profile) -> bool {
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
            let Some(guide) = Guide::new(&tool, &surface, condition, side, thick) else { return Ok(()) };
            let (Some(a), Some(b)) = (guide.read(te), guide.read(te + v)) else { return Ok(()) };
            let whole = |te: Vec3| distance(&tool.at(te), &surface, condition, side, thick, None).unwrap();
            let ends = [whole(te), whole(te + v)];
            for (te, reading, gap) in [(te, &a, &ends[0]), (te + v, &b, &ends[1])] {
                prop_assert!((reading.g - gap.g).abs() < NEAR, "{reading:?} {gap:?}");
                let slant = (reading.normal - gap.normal).norm();
                prop_assert!(slant < 1e-6, "{reading:?} {gap:?}");
                let made = guide.gap(te, reading.g, reading.normal);
                prop_assert!((made.tool_point - gap.tool_point).norm() < 1e-4, "{made:?} {gap:?}");
                prop_assert!((made.surface_point - gap.surface_point).norm() < 1e-4);
                prop_assert_eq!(made.segment, gap.segment);
                prop_assert!((made.raw - gap.raw).abs() < NEAR);
                let edge = gap.segment.is_some_and(|s| s != Segment::Arc);
                if let Some(shape) = second(&tool.at(te), &surface, side, gap)
                    && !(edge && gap.raw.abs() < 1.0)
                {
                    let d = v.normalize();
                    let (x, y) = (reading.second(d), shape.second(d));
                    prop_assert!((x - y).abs() < 1e-6 * (1.0 + x.abs()), "{x} {y} {gap:?}");
                }
            }
            let to = tool.at(te + v);
            let c = chord(&tool, &to, &surface, condition, side, thick, Some(ends), 1e-10).unwrap();
            let slopes = [[a.g, a.normal.dot(&v)], [b.g, b.normal.dot(&v)]];
            let [low, high] = guide.chord(te, v, slopes, 1e-10).unwrap();
            prop_assert!((low - c.low.g).abs() < NEAR, "{low} {c:?}");
            prop_assert!((high - c.high.g).abs() < NEAR, "{high} {c:?}");
            for i in 0..=20 {
                let g = whole(te + v * (f64::from(i) / 20.0)).g;
                prop_assert!((low - NEAR..=high + NEAR).contains(&g), "{g} in {low} {high}");
            }
        }
    }
}
