//! Where a cutter can have one place of contact only: over a part of a surface that bends little against it.
//!
//! The corner touches where the circle of its middles is nearest to the surface. Let N(x) be the part across the tool axis of
//! the gradient of the distance at a point x of the circle's disk, H the mean second derivative between two such points. At
//! a least distance N = -a e, a >= 0, with e the way out from the axis; at a flat end that touches N = 0. Two of them give
//! `rho (a + b) |e - f|^2 / 2 = -rho^2 (e - f) H (e - f)`, so that there is one only where every a is greater than rho
//! times the least curvature of a hollow; where the tool has moved by w, N and x are those of before but for w.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Surface, Tool, Vec3, trig};

use crate::gap::{Gap, Side};

/// Share of a corner's own curvature that a hollow may use up.
const ROOM: f64 = 0.9;
/// Greatest product of a curvature and a distance at which the surface is followed along its normals.
const BEND: f64 = 0.2;
/// Sine of the tilt from which the corner is to touch, if no flat end does.
const TILT: f64 = 1e-7;
/// Length of a shank, in widths of the tool, about which one ball is laid, and balls at most.
const SHANK: f64 = 4.0;
const SHANKS: usize = 6;

/// Share of the way that the known place tells for which it may be shown.
const LIKELY: f64 = 0.9;
/// Share of the cutter's size for which it is looked at most with a corner about a circle, of its half width over a dome, and of its
/// size with a round end; and from which that is worth more than a look.
const MOST: f64 = 0.8;
const WIDE: f64 = 1.2;
const FAR: f64 = 32.0;
pub(crate) const WORTH: f64 = 0.02;
/// Share of the greater curvature of a dome that the less is.
const ROUND: f64 = 0.05;
/// Share of the way to where the surface stands up beside a round end for which that may be.
const TOWARDS: f64 = 0.4;

/// How a part of a surface bends that alone can touch a tool, and this with its corner or flat end only.
pub(crate) struct Faced {
    /// Greatest curvatures of the distance on the way, of hollow and of round places.
    hollow: f64,
    bend: f64,
    /// Direction of the ruling of the known place, by how much others differ from it, and greatest second derivative by a ruling's
    /// direction and another.
    ruling: Vec3,
    lean: f64,
    twist: f64,
    /// Does it bend one way all over, and much less another?
    pub(crate) ridge: bool,
}

/// Share of the curvature of a ridge that the hollow along it may have.
const THIN: f64 = 0.1;

/// The part of a surface that a tool with the `known` gap can touch while it goes by `most`, its axis standing, where nothing
/// of it can but its corner and its flat end, and each point of the disk of the corner's middles has one nearest place; `None`
/// where it is not seen that all normals there face those.
pub(crate) fn faced(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
    most: f64,
) -> Option<Faced> {
    let profile = tool.profile;
    let arc = |out: f64, up: f64| profile.support(out, up).segment == Segment::Arc;
    let lower = matches!(known.segment, Some(Segment::Arc | Segment::LowerLine));
    if side == Side::Open || !lower || !arc(TILT, -1.0) {
        return None;
    }
    let n = known.normal;
    let upright = n.dot(&tool.ta);
    let across = (n - tool.ta * upright).norm();
    let ([rho, high], away) = (profile.corner(), known.raw + profile.corner_radius());
    // What lies outside of the first balls is farther from the tool than the known place, wherever both have moved. From that of
    // the disk's middle the nearest places of its points lie no farther than they do, but for how the surface bends.
    let (mut balls, count) = around(tool, known.raw.max(0.0) + 2.0 * most);
    let center = tool.te + tool.ta * high;
    let foot = surface.foot_from(center, known.spot());
    let deepest = foot.distance.abs() + rho + most;
    balls[count] = (foot.point, (rho + most) / (1.0 - BEND));
    let balls = &balls[..=count];
    let part = surface.part(balls, (center, rho + most), known.spot())?;
    // All normals there face the corner, or a flat end.
    let turned = 0.5 * part.turn * part.turn;
    let (cos, sin) = (1.0 - turned, (turned * (2.0 - turned)).sqrt());
    let (out, up) = (across * cos + upright * sin, across * sin - upright * cos);
    if out < 0.0 || !arc(out, up) {
        return None;
    }
    let across = match side {
        Side::Positive => part.across[0],
        Side::Negative | Side::Open => -part.across[1],
    };
    let [hollow, round] = bends(part.curvature, side);
    let ridge = hollow < THIN * across;
    // Of what is no number nothing is known.
    if deepest * hollow >= BEND || part.curvature.iter().any(|k| k.is_nan()) {
        return None;
    }
    // The second derivatives at the distance d are k / (1 + d k). No point of the disk is much deeper than the known one, for
    // N leads up from there.
    let hollow = hollow / (1.0 - deepest * hollow);
    let deep = (most + 2.0 * rho * rho * hollow - away).max(0.0) * round;
    let (ruling, lean) = (part.ruling, part.lean);
    let twist = part.twist * (1.0 + deepest * hollow).max(1.0 / (1.0 - deep));
    let bend = hollow.max(round / (1.0 - deep));
    (deep < BEND).then_some(Faced { hollow, bend, ruling, lean, twist, ridge })
}

/// Balls that hold all that is no farther than `clear` from the tool, and their number; at least one more has room.
///
/// Along the shank there are several of them: one about all of it would hold what is far from it.
pub(crate) fn around(tool: &Tool<'_>, clear: f64) -> ([(Vec3, f64); SHANKS + 2], usize) {
    let profile = tool.profile;
    let (low, top, wide) = (profile.bottom(), profile.height(), profile.widest());
    let joint = (low + 2.0 * wide).min(top);
    let ball = |low: f64, top: f64| {
        let radius = trig::hypot(0.5 * (top - low), wide);
        (tool.te + tool.ta * (0.5 * (top + low)), radius + clear)
    };
    let holds = |n: &usize| top - joint <= SHANK * wide * *n as f64;
    let parts = (1..SHANKS).find(holds).unwrap_or(SHANKS);
    let mut balls = [ball(low, joint); SHANKS + 2];
    let end = |i: usize| joint + (top - joint) * i as f64 / parts as f64;
    (0..parts).for_each(|i| balls[1 + i] = ball(end(i), end(i + 1)));
    (balls, parts + 1)
}

/// A way that the tool can go, its axis standing, no longer than `most`, on which no place of it touches but that of the
/// corner with the `known` gap, wherever this goes; `None` where that is not seen.
///
/// Where nothing of the surface there is hollow, the distance is convex over all that the disk of the corner's middles sweeps: its
/// second derivatives are `k / (1 + d k)`. Of a convex function each least place is the deepest, so that none is deeper than the
/// known one, be it below the flat end, wherever the tool goes on that way.
pub(crate) fn alone(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
    most: f64,
) -> Option<f64> {
    let (n, [rho, _]) = (known.normal, tool.profile.corner());
    let corner = known.segment == Some(Segment::Arc);
    if !corner && !is_dome(principal(surface, known), side) {
        return None;
    }
    let Faced { hollow, bend, ruling, lean, twist, .. } = faced(tool, surface, side, known, most)?;
    if rho <= 0.0 && corner || hollow <= 0.0 {
        return Some(most);
    }
    corner.then_some(())?;
    let across = (n - tool.ta * n.dot(&tool.ta)).norm();
    let way = within([across, rho], [bend, hollow])?;
    // No second derivative by the direction of the corner's circle and another is greater there.
    let around = tool.ta.cross(&n) / across;
    let beside = (around - ruling).norm().min((around + ruling).norm());
    let kept = followed([across, rho], [bend, hollow, bend * (beside + lean) + twist]);
    Some(way.max(kept).min(most))
}

/// The least and the greatest curvature at the known place.
fn principal(surface: &Surface, known: &Gap) -> [f64; 2] {
    let [most, least] = surface.place(known.spot()).shape.principal();
    [least, most]
}

/// Is a place with these curvatures round both ways, seen from a side, so that what is about it is so, most likely?
fn is_dome([least, most]: [f64; 2], side: Side) -> bool {
    let [flatter, rounder] = match side {
        Side::Positive => [least, most],
        Side::Negative | Side::Open => [-most, -least],
    };
    rounder.is_finite() && rounder > 0.0 && flatter >= ROUND * rounder
}

/// How hollow and how round a surface with these least and greatest curvatures is seen from a side.
fn bends([least, most]: [f64; 2], side: Side) -> [f64; 2] {
    let seen = match side {
        Side::Positive => [-least, most],
        Side::Negative | Side::Open => [most, -least],
    };
    seen.map(|k| k.max(0.0))
}

/// A way for which the contact is likely to be shown to be the only one, as the surface bends at the `known` place, for a tool of
/// that `size`; `None` where there is hardly one.
pub(crate) fn likely(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
    size: f64,
) -> Option<f64> {
    let (profile, upright) = (tool.profile, known.normal.dot(&tool.ta));
    let principal = principal(surface, known);
    let [hollow, round] = bends(principal, side);
    let bend = hollow.max(round);
    let [rho, _] = profile.corner();
    let deep = (known.raw + profile.corner_radius()).abs() + rho;
    // Where the way adds more to that, the surface is not followed along its normals.
    let room = if hollow > 0.0 { LIKELY * BEND / hollow - deep } else { f64::INFINITY };
    // Nor is there a way beside where the surface ends: it bends there without bound.
    if room < WORTH * size {
        return None;
    }
    let way = if rho <= 0.0 {
        // Some of the way after which the surface stands up beside it.
        let turned = (bend * size).max(f64::MIN_POSITIVE);
        (TOWARDS * upright / turned).clamp(1.0, FAR) * size
    } else if is_dome(principal, side) {
        // As long as nothing there is hollow. What has to be looked at grows with the square of the way and the width together.
        (MOST * size).min(WIDE * profile.widest())
    } else {
        let most = room.min(MOST * size);
        let hollow = hollow / (1.0 - (deep + most) * hollow);
        let across = (1.0 - upright * upright).max(0.0).sqrt();
        let bend = bend.max(hollow);
        let kept = followed([across, rho], [bend, hollow, bend]);
        LIKELY * within([across, rho], [bend, hollow])?.max(kept).min(MOST * size)
    };
    let way = way.min(room);
    (way >= WORTH * size).then_some(way)
}

/// The way after which the place of contact of a corner about a circle of the radius `rho` is the only one within reach of it, with
/// the sine `a` between normal and axis, the greatest second derivative and that of a hollow; `None` where it may not be now.
fn within([a, rho]: [f64; 2], [bend, hollow]: [f64; 2]) -> Option<f64> {
    // A place of contact after the way w lies within y w of this one: by the same products,
    // y^2 <= alpha (1 + y) + beta (1 + y)^2.
    let (alpha, beta) = (2.0 * rho * bend / a, 2.0 * rho * hollow / a);
    (beta < ROOM).then_some(())?;
    let (p, q) = (alpha + 2.0 * beta, alpha + beta);
    let y = (p + (p * p + 4.0 * (1.0 - beta) * q).sqrt()) / (2.0 * (1.0 - beta));
    Some((a - rho * hollow) / (bend * (1.0 + y)))
}

/// The way on which the place of contact of a corner is the only one wherever it goes around the circle of the `rho`: with the
/// greatest second derivative, that of a hollow, and that by the direction of the circle at the known place and another.
///
/// While `a > 2 rho hollow` there is no other. By the derivative of `N = -a e` along the way `e` turns by no more than
/// `side / c`, and `a` falls by no more than `bend + rho side^2 / c`, with `c = a - rho hollow`. As `e` turns `side` grows with
/// `bend`, so that it is no more than `c0 / c` times that at the start.
fn followed([a, rho]: [f64; 2], [bend, hollow, side]: [f64; 3]) -> f64 {
    let least = rho * hollow;
    let c = a - least;
    if c <= least {
        return 0.0;
    }
    // The way is the integral of `1 - g^3 / (c^3 + g^3)` over `bend`, from `rho hollow` to that at the start.
    let cube = rho * side * side * c * c / bend;
    let g = trig::cbrt(cube).clamp(least, c);
    let lost = if g > 0.0 { g - least + 0.5 * cube * (1.0 / (g * g) - 1.0 / (c * c)) } else { 0.0 };
    (c - least - lost).max(0.0) / bend
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::{gap, gap_near};
    use crate::shapes::{mesh, rulings};
    use aptc_geometry::{Cutter, Profile, trig};
    use proptest::prelude::*;
    use proptest::test_runner::{Config, TestRunner};

    /// The least distance of points of the tool from the surface.
    fn least(tool: &Tool<'_>, surface: &Surface, side: Side) -> f64 {
        let [[rl, zl], [ru, zu]] = tool.profile.joints();
        let (radius, [rho, high]) = (tool.profile.corner_radius(), tool.profile.corner());
        let (wide, top) = (tool.profile.widest(), tool.profile.height());
        let arc = [5.0, 15.0, 30.0, 50.0, 70.0, 85.0].map(|tilt: f64| {
            [rho + radius * trig::sin_deg(tilt), high - radius * trig::cos_deg(tilt)]
        });
        let level = [0.0, 0.35, 0.7].map(|share| [share * rl, zl]);
        let flank = [0.1, 0.3, 0.6].map(|share| [wide, zu + share * (top - zu)]);
        let places = level.into_iter().chain([[rl, zl], [ru, zu], [wide, top]]);
        let mut found = f64::INFINITY;
        for [r, z] in places.chain(arc).chain(flank) {
            for turn in 0..16 {
                let (sin, cos) =
                    (trig::sin_deg(22.5 * f64::from(turn)), trig::cos_deg(22.5 * f64::from(turn)));
                let [a, b] = aptc_geometry::surface::frame_about(tool.ta);
                let p = tool.te + (a * cos + b * sin) * r + tool.ta * z;
                found = found.min(side.sign() * surface.distance(p));
            }
        }
        found
    }

    #[test]
    fn no_point_of_the_tool_is_deeper_on_the_way() {
        let along_rulings = |radii: [f64; 2], bends: [f64; 2], lift: f64| {
            let sign = |x: f64| if x < -0.4 { -1.0 } else { 1.0 };
            rulings([radii[0] * sign(bends[0]), radii[1] * sign(bends[1])], lift)
        };
        nowhere_deeper(1500, along_rulings);
    }

    #[test]
    fn no_point_of_the_tool_is_deeper_on_the_way_over_a_mesh() {
        let waves = |radii: [f64; 2], bends: [f64; 2], lift: f64| {
            let high = |i: usize| 150.0 / radii[i] * bends[i];
            mesh([high(0), high(1)], 0.3 * lift, 0.02 * lift)
        };
        nowhere_deeper(400, waves);
    }

    #[test]
    fn beyond_where_a_surface_ends_no_place_is_likely_to_be_alone() {
        let Surface::Parametric(whole) = mesh([2.0, 2.0], 0.0, 0.0) else { panic!("a mesh") };
        let surface = Surface::Parametric(whole.without_continuation().unwrap());
        let profile = Profile::new(&Cutter::mill(6.0, 1.0, 40.0)).unwrap();
        let beyond = Vec3::new(50.0, 3.0, 9.0);
        let end = surface.foot(beyond);
        let [most, least] = end.shape.principal();
        assert!(!(most - least).is_finite(), "{most} {least}");
        for side in [Side::Positive, Side::Negative] {
            let normal = end.normal * side.sign();
            let tool = Tool { profile: &profile, te: beyond, ta: normal };
            let known = Gap {
                g: 0.0,
                raw: 0.0,
                tool_point: beyond,
                surface_point: beyond,
                at: None,
                normal,
                segment: Some(Segment::Arc),
                residual: 0.0,
            };
            assert_eq!(likely(&tool, &surface, side, &known, 3.0), None);
        }
    }

    fn nowhere_deeper(cases: u32, surface: impl Fn([f64; 2], [f64; 2], f64) -> Surface) {
        let shown = std::cell::Cell::new([0_u32; 2]);
        let one = || -1.0_f64..1.0;
        let all = (
            (prop::array::uniform2(50.0_f64..150.0), [one(), one()], -25.0_f64..25.0),
            (0_usize..3, [one(), one(), one()], [one(), one()]),
            ([one(), one(), one()], 0.02_f64..0.5, any::<bool>()),
        );
        let mut runner = TestRunner::new(Config::with_cases(cases));
        let check =
            runner.run(&all, |((radii, bends, lift), (kind, te, lean), (way, share, below))| {
                let surface = surface(radii, bends, lift);
                let corner = [5.0, 2.0, 0.3][kind];
                let profile = Profile::new(&Cutter::mill(10.0, corner, 40.0)).unwrap();
                let side = if below { Side::Negative } else { Side::Positive };
                let up = side.sign() * surface.foot(Vec3::zeros()).normal.z.signum();
                let ta = Vec3::new(0.2 * lean[0], 0.2 * lean[1], up).normalize();
                let place = Vec3::new(25.0 * te[0], 20.0 * te[1], 20.0 * up);
                let tool = Tool { profile: &profile, te: place, ta };
                let Ok(high) = gap(&tool, &surface, side, 0.0) else { return Ok(()) };
                // Down to the surface, or near it.
                let tool = tool.at(place - high.normal * (high.raw - te[2]));
                let Ok(known) = gap(&tool, &surface, side, 0.0) else { return Ok(()) };
                let most = share * profile.widest();
                let found = alone(&tool, &surface, side, &known, most);
                let [yes, no] = shown.get();
                let Some(free) = found.filter(|w| *w > 0.0) else {
                    shown.set([yes, no + 1]);
                    return Ok(());
                };
                shown.set([yes + 1, no]);
                prop_assert!(free <= most);
                prop_assert!(least(&tool, &surface, side) >= known.raw - 1e-7, "{known:?}");
                let moved = tool.at(tool.te + Vec3::from(way).normalize() * free);
                let next = gap_near(&moved, &surface, side, 0.0, Some(known.spot()));
                let next = next.map_err(|r| TestCaseError::fail(format!("{r:?}")))?;
                let deepest = least(&moved, &surface, side);
                prop_assert!(deepest >= next.raw - 1e-7, "{deepest} {known:?} {next:?}");
                Ok(())
            });
        check.unwrap();
        let [yes, no] = shown.get();
        assert!(yes > no / 4, "{yes} {no}");
    }

    #[test]
    fn nothing_is_deeper_than_the_known_place_and_the_ends_of_a_ridge() {
        let shown = std::cell::Cell::new([0_u32; 3]);
        let one = || -1.0_f64..1.0;
        let all = (
            (prop::array::uniform2(50.0_f64..150.0), -25.0_f64..25.0, one(), any::<bool>()),
            ([one(), one()], [one(), one()], 0.5_f64..8.0, -0.01_f64..0.3),
            ([one(), one()], prop::sample::select(vec![0.3, 1.0, 2.0, 4.0])),
        );
        let mut runner = TestRunner::new(Config::with_cases(600));
        let check = runner.run(
            &all,
            |((radii, lift, far, below), (te, lean, wide, above), (near, corner))| {
                let surface = rulings(if below { radii.map(|r| -r) } else { radii }, lift);
                let side = if below { Side::Negative } else { Side::Positive };
                let profile =
                    Profile::new(&Cutter::mill(2.0 * (corner + wide), corner, 40.0)).unwrap();
                // With the axis along a normal, or nearly so, and that place below the tool or beside it.
                let top = surface.foot(Vec3::new(25.0 * far, 20.0 * te[1], 0.0));
                let up = top.normal * side.sign();
                let ta = (up + Vec3::new(0.01 * lean[0], 0.0005 * lean[1], 0.0)).normalize();
                let place = top.point + Vec3::x() * (1.2 * wide * te[0]) + up * above;
                let tool = Tool { profile: &profile, te: place, ta };
                let near = place + Vec3::new(near[0], near[1], 0.0) * (corner + wide);
                let Some(known) =
                    crate::disk::beside(&tool, &surface, side, surface.foot(near).spot())
                else {
                    return Ok(());
                };
                let [few, no, other] = shown.get();
                let Some(Faced { ridge: true, .. }) =
                    faced(&tool, &surface, side, &known, 0.05 * wide)
                else {
                    shown.set([few, no + 1, other]);
                    return Ok(());
                };
                let Some(ends) = crate::ridge::ends(&tool, &surface, side, &known) else {
                    return Ok(());
                };
                let found = ends
                    .into_iter()
                    .flatten()
                    .filter_map(|q| crate::disk::below(&tool, &surface, side, q).ok());
                let told = found.map(|g| g.raw).fold(known.raw, f64::min);
                shown.set([few + 1, no, other + u32::from(told < known.raw - 1e-6)]);
                // Around the disk of the corner's middles, and within it.
                let [rho, high] = profile.corner();
                let [a, b] = aptc_geometry::surface::frame_about(ta);
                for k in 0..180_u32 {
                    let (sin, cos) =
                        (trig::sin_deg(2.0 * f64::from(k)), trig::cos_deg(2.0 * f64::from(k)));
                    for share in [1.0, 0.98, 0.7, 0.3] {
                        let p = place + (a * cos + b * sin) * (share * rho) + ta * high;
                        let deep =
                            side.sign() * surface.foot_from(p, known.spot()).distance - corner;
                        prop_assert!(deep >= told - 1e-8, "{deep} {told} {known:?} {k} {share}");
                    }
                }
                let deepest = least(&tool, &surface, side);
                prop_assert!(deepest >= told - 1e-7, "{deepest} {told} {known:?}");
                Ok(())
            },
        );
        check.unwrap();
        let [yes, no, other] = shown.get();
        assert!(yes > no && other > yes / 50, "{yes} {no} {other}");
    }
}
