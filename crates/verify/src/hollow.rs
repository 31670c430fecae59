//! The inside of a convex quadric that counts as open along the tool axis: what its tangent planes show.
//!
//! The gap is the least of `h(C, m) - h(T, m)` over the unit directions m that do not look up the axis, h being support
//! functions. On the cone over a few such directions m_i it is at least the least of `x . m_i - h(T, m_i)` for any point
//! x of the hollow, for h(T) is convex; with the point that touches in the middle of the cone that misses the truth by
//! the square of the cone's width. Cones are halved until nothing is missed.

use aptc_geometry::{Vec3, trig};

use crate::bound::CLOSE;
use crate::inside::{Walls, allowed};
use crate::oval::Oval;
use crate::pile::Pile;
use crate::solid::{Supported, any_across, unit_or};
use crate::tool::{Pose, Tool};

/// Halvings of a cone at most.
const DEPTH: u32 = 120;
/// Cones that are looked at for one gap.
const MOST: u32 = 20_000;
/// The same where it hardly bends along an axis, so that most directions meet it far away: what is not shown soon is not shown.
const FEW: u32 = 1_000;
/// Largest sine by which a direction may miss the bounded ones and still count as rounding.
const ROUNDING: f64 = 1e-12;

/// Up to three directions whose cone is looked at, and how often it was halved.
type Cone = ([Vec3; 3], u32);

impl Walls for Oval {
    fn nearest(&self, tool: &Tool<'_>, pose: &Pose, up: Option<f64>) -> (f64, f64, Vec3) {
        let up = up.unwrap_or(0.0);
        if let Some(rolled) = self.rolled(tool, pose).filter(|_| up == 0.0) {
            return rolled;
        }
        let clear = |x: Vec3, m: Vec3| x.dot(&m) - tool.height(pose, m);
        let mut pile = self.cones(pose.ta, up);
        let enough = if self.is_slack() { FEW } else { MOST };
        let (mut low, mut best) = (f64::INFINITY, (f64::INFINITY, -pose.ta));
        let mut seen = 0;
        while let Some((corners, halvings)) = pile.pop() {
            seen += 1;
            let middle = unit_or(corners.iter().sum(), corners[0]);
            // Of a cone in whose middle the hollow has no end a corner may do.
            let Some((m, x)) = std::iter::once(middle)
                .chain(corners)
                .find_map(|m| self.touching(m).map(|x| (m, x)))
            else {
                if halvings < DEPTH && !self.endless(&corners) {
                    halve(&mut pile, &corners, halvings);
                }
                continue;
            };
            for m in std::iter::once(m).chain(corners) {
                let level = m.dot(&pose.ta) <= up + ROUNDING;
                if let Some(g) = self.touching(m).filter(|_| level).map(|x| clear(x, m))
                    && g < best.0
                {
                    best = (g, m);
                }
            }
            let least = corners.iter().map(|m| clear(x, *m)).fold(f64::INFINITY, f64::min);
            // Directions between the corners are shorter than 1 by so much.
            let short = corners.iter().map(|c| c.dot(&middle)).fold(1.0, f64::min).max(0.1);
            let bound = if least < 0.0 { least / short } else { least };
            let size = x.norm() + pose.te.norm() + tool.reach();
            if bound >= best.0 - 1e-13 * size || halvings >= DEPTH || seen > enough {
                low = low.min(bound);
                continue;
            }
            halve(&mut pile, &corners, halvings);
        }
        (low.min(best.0), best.0, best.1)
    }
}

impl Oval {
    /// The gap over the directions that do not look up the axis, where the tool that is seen from there lies in a ball that
    /// touches where it does, and that in a ball within the hollow which touches there too.
    ///
    /// With the corner's circle about the axis, its radius rho, the direction m to the place that leans by the sine s from the axis
    /// and p the middle of the corner there, a ball of rho / s about `p - m rho / s` holds the disk in the circle: of a point `p + d`
    /// of that `|d|^2 <= -2 rho d . e`, e being the way out from the axis, and `d . m = s d . e`.
    pub(crate) fn rolled(&self, tool: &Tool<'_>, pose: &Pose) -> Option<(f64, f64, Vec3)> {
        /// Rounds to the place, and by how little the direction to it turns in the last.
        const ROUNDS: u32 = 24;
        const STILL: f64 = 1e-10;
        let (profile, base) = tool.solid()?;
        let ([rho, high], radius) = (profile.corner(), profile.corner_radius());
        // All of it is above the disk in the circle, made rounder by the corner.
        let little = 1e-13 * profile.reach();
        let held =
            profile.widest() <= rho + radius + little && profile.bottom() >= high - radius - little;
        let middle = pose.te + pose.ta * (base + high);
        let mut n = self.bounded_direction(self.slope(middle));
        for _ in 0..if held { ROUNDS } else { 0 } {
            let m = n;
            let side = m - pose.ta * m.dot(&pose.ta);
            let wide = if rho > 0.0 { rho / side.norm() } else { 0.0 };
            if !(wide + radius < self.roundest() && m.dot(&pose.ta) <= 0.0) {
                return None;
            }
            let p = middle + side * wide;
            let found = self.next_to(&Tool::End, &Pose { te: p, ta: pose.ta }, Some(m))?;
            n = found.n;
            if (n - m).norm() > STILL {
                continue;
            }
            // How much smaller the one ball is than the other, and how far apart their middles are.
            let room = self.roundest() - wide - radius;
            let apart = (found.x - n * self.roundest()) - (p - m * wide);
            let (low, high) = (room - apart.norm(), self.support(n) - tool.height(pose, n));
            let size = found.x.norm() + pose.te.norm() + tool.reach();
            return (low >= high - CLOSE * size).then_some((low.min(high), high, n));
        }
        None
    }

    /// Directions whose cones hold all that do not look up `ta` by more than `up`.
    fn cones(&self, ta: Vec3, up: f64) -> Pile<Cone, 192> {
        let mut pile = Pile::new();
        let mut frame = self.frame();
        match [frame.next(), frame.next(), frame.next()] {
            [Some(_), Some(_), Some(_)] => {
                let a = any_across(ta);
                let b = ta.cross(&a);
                let low = (1.0 - up * up).max(0.0).sqrt();
                let rim = |k: u32| {
                    let (s, c) = trig::sin_cos(f64::from(k) * std::f64::consts::FRAC_PI_4);
                    (a * c + b * s) * low + ta * up
                };
                for k in 0..8 {
                    pile.push(([-ta, rim(k), rim(k + 1)], 0));
                }
            }
            [Some(e1), Some(e2), None] => {
                if let Some((from, turn)) = allowed(e1, e2, Vec3::zeros(), ta, Some(up)) {
                    let at = |k: u32| {
                        let (s, c) = trig::sin_cos(from + f64::from(k) * turn / 8.0);
                        e1 * c + e2 * s
                    };
                    for k in 0..8 {
                        pile.push(([at(k), at(k), at(k + 1)], 0));
                    }
                }
            }
            [Some(e), ..] => {
                for m in [e, -e].into_iter().filter(|m| m.dot(&ta) <= up + ROUNDING) {
                    pile.push(([m; 3], DEPTH));
                }
            }
            [None, ..] => {}
        }
        pile
    }

    /// Does no direction of the cone bound the hollow?
    fn endless(&self, corners: &[Vec3; 3]) -> bool {
        self.straight().is_some_and(|t| corners.iter().all(|m| m.dot(&t) <= 0.0))
    }
}

/// Both halves of a cone, across its longest side.
fn halve(pile: &mut Pile<Cone, 192>, corners: &[Vec3; 3], halvings: u32) {
    let side = |i: usize, j: usize| (corners[i] - corners[j]).norm_squared();
    let sides = [(0, 1), (1, 2), (2, 0)];
    let longest = sides.into_iter().max_by(|a, b| side(a.0, a.1).total_cmp(&side(b.0, b.1)));
    let (i, j) = longest.unwrap_or((0, 1));
    let middle = unit_or(corners[i] + corners[j], corners[i]);
    for k in [i, j] {
        // An arc is a cone of which two directions are the same.
        let half = corners.map(|c| if c == corners[k] { middle } else { c });
        pile.push((half, halvings + 1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inside::{bound, gap};
    use aptc_geometry::surface::QuadricSurface;
    use aptc_geometry::{Cutter, Profile, Quadric, QuadricKind};
    use proptest::prelude::*;

    fn quadric(c: [f64; 10]) -> Oval {
        let form = Quadric { kind: QuadricKind::Qadric, c };
        Oval::new(&QuadricSurface::new(&form).unwrap()).unwrap()
    }

    #[test]
    fn support_functions_of_known_hollows() {
        let h = |s: &Oval, x: f64, y: f64, z: f64| s.support(Vec3::new(x, y, z));
        // Half axes 2, 3, 5 about (1, 0, 0).
        let e = quadric([0.25, 1.0 / 9.0, 0.04, -0.75, 0.0, 0.0, 0.0, -0.25, 0.0, 0.0]);
        assert!((h(&e, 1.0, 0.0, 0.0) - 3.0).abs() < 1e-12);
        assert!((h(&e, 0.0, 0.6, -0.8) - (3.24_f64 + 16.0).sqrt()).abs() < 1e-12);
        // An elliptic cylinder along y, and z = x^2 + 2 y^2, whose tangent plane at (1, 1) is 2x + 4y - z = 3.
        let c = quadric([0.25, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert!((h(&c, 0.0, 0.0, 1.0) - 1.0).abs() < 1e-12 && h(&c, 0.0, 0.6, 0.8).is_infinite());
        let p = quadric([1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5]);
        let n = Vec3::new(2.0, 4.0, -1.0) / 21.0_f64.sqrt();
        assert!((p.support(n) - 3.0 / 21.0_f64.sqrt()).abs() < 1e-12);
        assert!(h(&p, 0.0, 0.0, 1.0).is_infinite());
    }

    /// Towards the end of its long axis an ellipsoid is nearest at that only as far as it is round there.
    #[test]
    fn balls_tell_the_gap_where_the_place_they_touch_is_the_nearest() {
        let (long, short) = (40.0, 8.0);
        let [a, b] = [1.0 / (long * long), 1.0 / (short * short)];
        let hollow = quadric([a, b, b, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let profile = Profile::new(&Cutter::mill(1.0, 0.5, 60.0)).unwrap();
        let tool = Tool::Solid(&profile);
        for (share, told) in [(0.6, true), (0.99, true), (1.01, false), (3.0, false), (9.0, false)]
        {
            let te = Vec3::new(long - share * short * short / long, 0.0, -0.5);
            let rolled = hollow.rolled(&tool, &Pose { te, ta: Vec3::z() });
            assert_eq!(rolled.is_some(), told, "{share}");
            let end = long - te.x - 0.5;
            assert!(
                rolled.is_none_or(|(low, high, _)| (low - end).abs() + (high - end).abs() < 1e-9)
            );
        }
    }

    #[test]
    fn a_tall_cutter_at_the_bottom_of_a_bowl() {
        let profile = Profile::new(&Cutter::mill(10.0, 5.0, 127.0)).unwrap();
        let tool = Tool::Solid(&profile);
        // Half axes 30, 20, 12: radii 75 and 33 at the bottom.
        let axes = [1.0 / 900.0, 1.0 / 400.0, 1.0 / 144.0];
        let bowl = quadric([axes[0], axes[1], axes[2], -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let pose = |x: f64, z: f64| Pose { te: Vec3::new(x, 0.0, z), ta: Vec3::z() };
        let g = gap(&tool, &pose(0.0, -11.5), &bowl, true);
        assert!((g.0 - 0.5).abs() < 1e-9 && (g.1 - 0.5).abs() < 1e-9, "{} {}", g.0, g.1);
        // High up the wall that runs on straight.
        let g = gap(&tool, &pose(24.5, 3.0), &bowl, true);
        assert!((g.0 - 0.5).abs() < 1e-9 && (g.1 - 0.5).abs() < 1e-9, "{} {}", g.0, g.1);
        let b = bound(&tool, &pose(-1.0, -11.5), &pose(1.0, -11.5), &bowl, true);
        let end = gap(&tool, &pose(1.0, -11.5), &bowl, true).1;
        assert!((b.low - end).abs() < 1e-8 && (b.high - 0.5).abs() < 1e-8, "{b:?}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn no_direction_shows_less_than_the_gap(
            axes in prop::array::uniform3(8.0_f64..40.0), te in prop::array::uniform3(-5.0_f64..5.0),
            lean in prop::array::uniform2(-0.4_f64..0.4), r in 0.0_f64..3.0,
        ) {
            let k = axes.map(|a| 1.0 / (a * a));
            let bowl = quadric([k[0], k[1], k[2], -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
            let profile = Profile::new(&Cutter::mill(6.0, r, 60.0)).unwrap();
            let tool = Tool::Solid(&profile);
            let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
            let pose = Pose { te: Vec3::from(te), ta };
            let (low, high, _) = gap(&tool, &pose, &bowl, true);
            prop_assert!(high - low <= 1e-9, "{low} {high}");
            let a = any_across(ta);
            let b = ta.cross(&a);
            let mut least = f64::INFINITY;
            for i in 0..=90 {
                let (s, c) = trig::sin_cos(f64::from(i) * std::f64::consts::FRAC_PI_2 / 90.0);
                for j in 0..180 {
                    let (t, d) = trig::sin_cos(f64::from(j) * std::f64::consts::TAU / 180.0);
                    let m = (a * d + b * t) * c - ta * s;
                    least = least.min(bowl.support(m) - tool.height(&pose, m));
                }
            }
            prop_assert!(low <= least + 1e-9 && low >= least - 0.1, "{low} {least}");
        }
    }
}
