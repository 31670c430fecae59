//! A corner whose centre lies beyond the axis, as of a barrel cutter, inside a hollow.
//!
//! Its points are nearer to the axis than the circle about the centre reaches: no circle of middles thickened by the radius
//! is the corner, but the outer side of one that turns itself inside out. So the distance from the wall is sought on the points
//! of the corner themselves, by the angle about the axis and that along the arc: inside of a convex hollow each of them has one
//! nearest place however deep it is in the wall, and the least of them is the gap.

use aptc_geometry::{Foot, Profile, Tool, Vec3, trig};

use crate::rings::{Wall, at16};

/// Bound of Newton's method from one place.
const MAX_STEPS: usize = 60;
/// Radians of the arc between two rows of samples at most, and rows.
const APART: f64 = 0.2;
const MOST_ROWS: usize = 13;
/// Share of the corner's radius by which Newton's method goes at last: rounding alone is left.
const LAST: f64 = 1e-9;
/// Sine between tool and wall up to which they face each other.
const FACING: f64 = 1e-14;
/// The same where rounding stops the search.
const LEVEL: f64 = 1e-7;
/// Share of the cutter's own curvature that a place bends by at least.
const FLAT: f64 = 1e-3;

/// The corner of a tool.
pub(crate) struct Barrel<'a> {
    tool: &'a Tool<'a>,
    /// Two unit vectors across the axis.
    across: [Vec3; 2],
    /// The angles at which the arc begins and ends, from across the axis towards its top.
    ends: [f64; 2],
}

/// A place of the corner.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    pub(crate) point: Vec3,
    pub(crate) foot: Foot,
    /// Distance from the wall, inside positive.
    pub(crate) value: f64,
    /// How steeply that changes along the corner.
    pub(crate) slope: f64,
    /// Away from the axis, and the angle along the arc.
    out: Vec3,
    turn: f64,
    /// The same along the arc and around the axis, and how that changes.
    slopes: [f64; 2],
    bends: [f64; 3],
    /// Distance from the axis.
    rho: f64,
}

/// Is the centre of the corner beyond the axis?
pub(crate) fn is_one(profile: &Profile) -> bool {
    profile.corner()[0] < 0.0 && profile.corner_radius() > 0.0
}

impl<'a> Barrel<'a> {
    pub(crate) fn new(tool: &'a Tool<'a>, across: [Vec3; 2]) -> Self {
        let ([e, f], joints) = (tool.profile.corner(), tool.profile.joints());
        let ends = joints.map(|[rho, z]| trig::atan2(z - f, rho - e));
        Self { tool, across, ends }
    }

    /// The places nearest to the wall among those about them; and of each sixteenth of a turn a place with a distance that is not
    /// greater than that of those beside it.
    pub(crate) fn nearest(
        &self,
        wall: &impl Wall,
        mut offer: impl FnMut(&Place),
    ) -> [(Vec3, f64); 16] {
        let [low, high] = self.ends;
        let close = |n: &usize| high - low <= APART * (*n - 2) as f64;
        let rows = (3..MOST_ROWS).find(close).unwrap_or(MOST_ROWS);
        let turn = |j: usize| low + (high - low) * j as f64 / (rows - 1) as f64;
        let mut all = [[0.0; 16]; MOST_ROWS];
        for (j, row) in all[..rows].iter_mut().enumerate() {
            let (rho, z) = self.place(turn(j));
            *row = wall.around(self.at_height(z), self.across.map(|v| v * rho)).map(|d| -d);
        }
        let mut seen = [(self.tool.te, f64::INFINITY); 16];
        for (i, nearest) in seen.iter_mut().enumerate() {
            for j in 0..rows {
                let here = all[j][i];
                let beside = [(i + 15) % 16, i, (i + 1) % 16];
                let about = (j.saturating_sub(1)..=(j + 1).min(rows - 1))
                    .flat_map(|row| beside.map(|k| all[row][k]));
                let (least, most) =
                    about.fold((here, here), |(a, b), value| (a.min(value), b.max(value)));
                let (rho, z) = self.place(turn(j));
                let point = self.at_height(z) + at16(self.across.map(|v| v * rho), i);
                let mut known = (point, here);
                if least >= here {
                    known.1 = here - (most - here);
                    if let Some(found) = self.descend(wall, at16(self.across, i), turn(j)) {
                        offer(&found);
                        known = (found.point, found.value.min(here));
                    }
                }
                if known.1 < nearest.1 {
                    *nearest = known;
                }
            }
        }
        seen
    }

    /// Distance from the axis and height of the place at an angle along the arc.
    fn place(&self, turn: f64) -> (f64, f64) {
        let ([e, f], r) = (self.tool.profile.corner(), self.tool.profile.corner_radius());
        let (sin, cos) = trig::sin_cos(turn);
        ((e + r * cos).max(0.0), f + r * sin)
    }

    fn at_height(&self, z: f64) -> Vec3 {
        self.tool.te + self.tool.ta * z
    }

    fn at(&self, wall: &impl Wall, out: Vec3, turn: f64) -> Place {
        let (r, ta) = (self.tool.profile.corner_radius(), self.tool.ta);
        let ((sin, cos), (rho, z)) = (trig::sin_cos(turn), self.place(turn));
        let point = self.at_height(z) + out * rho;
        let foot = wall.foot(point);
        let n = foot.normal;
        let (up, around) = (ta * cos - out * sin, ta.cross(&out));
        let slopes = [-n.dot(&up), -n.dot(&around)];
        let bend = foot.shape.offset(foot.distance);
        let mut bends = bend.map_or([0.0; 3], |shape| {
            let [a, c] = [shape.second(up), shape.second(around)];
            [-a, -0.5 * (shape.second(up + around) - a - c), -c]
        });
        bends[0] += n.dot(&(out * cos + ta * sin)) / r;
        bends[1] += sin * n.dot(&around) / rho.max(f64::MIN_POSITIVE);
        bends[2] += n.dot(&out) / rho.max(f64::MIN_POSITIVE);
        let slope = trig::hypot(slopes[0], slopes[1]);
        Place { point, foot, value: -foot.distance, slope, out, turn, slopes, bends, rho }
    }

    /// The place downhill from one; `None` where it is an end of the arc, which is an edge of the tool.
    fn descend(&self, wall: &impl Wall, out: Vec3, turn: f64) -> Option<Place> {
        let r = self.tool.profile.corner_radius();
        let [low, high] = self.ends;
        let mut at = self.at(wall, out, turn);
        let size = self.tool.profile.widest();
        let mut cap = APART * r.min(2.0 * size);
        for _ in 0..MAX_STEPS {
            // Beyond its ends the arc does not go on.
            let held =
                at.turn <= low && at.slopes[0] > 0.0 || at.turn >= high && at.slopes[0] < 0.0;
            let [a, b, c] = at.bends;
            let [p, q] = at.slopes;
            if held && q.abs() <= LEVEL {
                return None;
            }
            if !held && at.slope <= FACING {
                return Some(at);
            }
            let det = a * c - b * b;
            let newton = !held && a > 0.0 && det > 0.0;
            // Where it bends down, as it does on the way, as far as where it would be level if it bent up.
            let straight = |slope: f64, bend: f64| -slope / bend.abs().max(FLAT / size);
            let [x, y] = match newton {
                true => [(b * q - c * p) / det, (b * p - a * q) / det],
                false => [if held { 0.0 } else { straight(p, a) }, straight(q, c)],
            };
            let whole = trig::hypot(x, y);
            let share = (cap / whole.max(f64::MIN_POSITIVE)).min(1.0);
            let (x, y, way) = (x * share, y * share, whole * share);
            let side = (y / at.rho.max(f64::MIN_POSITIVE)).clamp(-0.5, 0.5);
            let out = (at.out + self.tool.ta.cross(&at.out) * side).normalize();
            let next = self.at(wall, out, (at.turn + x / r).clamp(low, high));
            if newton && way <= LAST * r && next.slope <= LEVEL {
                return Some(next);
            }
            let flatter =
                next.value <= at.value + LEVEL * LEVEL * size && next.slope < 0.5 * at.slope;
            if next.value < at.value || flatter {
                (at, cap) = (next, 2.0 * cap);
            } else {
                cap = 0.35 * way;
                if cap < 1e-15 * r {
                    break;
                }
            }
        }
        (at.slope <= LEVEL).then_some(at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Side, gap};
    use aptc_geometry::{Cone, Cutter, Cylinder, Form, Quadric, QuadricKind, Sphere, Surface};
    use proptest::prelude::*;

    /// A leaning cylinder, a cone that opens upwards, an ellipsoid, a sphere and a bowl, each about the origin.
    fn hollow(kind: usize, size: f64) -> Surface {
        let quadric = |c: [f64; 10]| Form::Quadric(Quadric { kind: QuadricKind::Qadric, c });
        let (lean, k) = (Vec3::new(0.2, -0.3, 0.9).normalize(), size.powi(-2));
        let zero = Vec3::zeros();
        let form = match kind {
            0 => Form::Cylinder(Cylinder { point: zero, axis: lean, radius: size }),
            1 => {
                let vertex = -lean * (2.0 * size);
                Form::Cone(Cone { vertex, axis: lean, cos_half: 0.894_427_190_999_915_9 })
            }
            2 => quadric([k, 0.7 * k, 0.4 * k, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
            3 => Form::Sphere(Sphere { center: zero, radius: size }),
            _ => quadric([1.0, 1.2, 0.0, -size * size, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5 * size]),
        };
        Surface::from_form(&form).unwrap()
    }

    /// Corner centres beyond the axis by a little and by much; the last one's arc is wider than the hollow.
    const CUTTERS: [[f64; 5]; 4] = [
        [20.0, 10.02, -0.02, 8.0, 30.0],
        [20.0, 12.0, -2.0, 8.0, 30.0],
        [16.0, 30.0, -22.0, 20.0, 40.0],
        [14.0, 90.0, -83.0, 24.0, 34.0],
    ];

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]
        #[test]
        fn no_point_of_a_barrel_is_nearer_to_the_wall_of_a_hollow_than_its_gap(
            kind in 0_usize..5, cutter in 0_usize..4, size in 32.0_f64..70.0,
            [te, ta] in prop::array::uniform2(prop::array::uniform3(-1.0_f64..1.0)),
        ) {
            let surface = hollow(kind, size);
            let [d, r, e, f, height] = CUTTERS[cutter];
            let cutter = Cutter { diameter: d, corner_radius: r, e, f, alpha_deg: 0.0, beta_deg: 0.0, height };
            let profile = Profile::new(&cutter).unwrap();
            let ta = (Vec3::from(ta) * 0.6 + Vec3::z()).normalize();
            let te = Vec3::from(te) * (0.5 * size) - ta * 12.0;
            let tool = Tool { profile: &profile, te, ta };
            let found = gap(&tool, &surface, Side::Negative, 0.0).unwrap();
            prop_assert!((-surface.distance(found.tool_point) - found.raw).abs() < 1e-9, "{found:?}");
            prop_assert!(tool.near(found.tool_point).distance.abs() < 1e-9, "{found:?}");
            let Barrel { ends: [low, high], .. } =
                Barrel::new(&tool, aptc_geometry::surface::frame_about(ta));
            let arc = (0..=60).map(|j| low + (high - low) * f64::from(j) / 60.0).map(|turn| {
                let (sin, cos) = trig::sin_cos(turn);
                [e + r * cos, f + r * sin]
            });
            let [lower, upper] = profile.joints();
            let others = [[0.0, profile.bottom()], lower, upper, [profile.top_radius(), height]];
            let [a, b] = aptc_geometry::surface::frame_about(ta);
            let mut least = f64::INFINITY;
            for [rho, z] in arc.chain(others) {
                for k in 0..180 {
                    let (sin, cos) = trig::sin_cos(f64::from(k) * std::f64::consts::TAU / 180.0);
                    let point = te + ta * z + (a * cos + b * sin) * rho;
                    least = least.min(-surface.distance(point));
                }
            }
            prop_assert!(found.raw <= least + 1e-9, "{} {least} {found:?}", found.raw);
            prop_assert!(found.raw >= least - 0.03, "{} {least} {found:?}", found.raw);
        }
    }
}
