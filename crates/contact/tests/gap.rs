//! Gaps against closed forms, against brute force, and against their own derivatives.

mod support;

use aptc_contact::{Gap, Reason, Side, Tool, gap, gap_near, on, opens, second};
use aptc_geometry::{Cone, Cutter, Cylinder, Plane, Profile, Sphere, Surface, Vec3, trig};
use proptest::prelude::*;
use support::{axis, cutter, quadric, quadric_of, simple, tabcyl};

fn mill(d: f64, r: f64) -> Profile {
    Profile::new(&Cutter::mill(d, r, 50.0)).expect("a mill")
}

/// Half axes of an ellipsoid about the origin.
const HALVES: [f64; 3] = [50.0, 30.0, 25.0];

fn ellipsoid(halves: [f64; 3]) -> Surface {
    let [a, b, c] = halves.map(|h| 1.0 / (h * h));
    quadric_of([a, b, c, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
}

#[test]
fn published_gaps() {
    let ball = mill(10.0, 5.0);
    let tool = Tool { profile: &ball, te: Vec3::new(0.0, 0.0, 2.0), ta: Vec3::z() };
    let floor = Surface::Plane(Plane { n: Vec3::z(), d: 0.0 });
    let g = gap(&tool, &floor, Side::Positive, 0.0).unwrap();
    assert!((g.g - 2.0).abs() < 1e-15 && (g.tool_point - tool.te).norm() < 1e-15);
    assert_eq!(g.normal, Vec3::z());
    let dome = Surface::Sphere(Sphere { center: Vec3::new(0.0, 0.0, -10.0), radius: 10.0 });
    assert!((gap(&tool, &dome, Side::Positive, 0.0).unwrap().g - 2.0).abs() < 1e-14);
    assert!((gap(&tool, &dome, Side::Positive, 0.5).unwrap().g - 1.5).abs() < 1e-14);

    let bull = mill(20.0, 3.0);
    let tool = Tool { profile: &bull, te: Vec3::zeros(), ta: Vec3::z() };
    let slope = Surface::Plane(Plane { n: Vec3::new(0.6, 0.0, 0.8), d: -5.0 });
    let g = gap(&tool, &slope, Side::Positive, 0.0).unwrap();
    assert!((g.g - 0.2).abs() < 1e-14);
    assert!((g.tool_point - Vec3::new(-8.8, 0.0, 0.6)).norm() < 1e-14);

    // z = xy/10, ball of radius 3 one above the saddle.
    let saddle = quadric_of([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.05, 0.0, 0.0, 0.5]);
    let small = mill(6.0, 3.0);
    let tool = Tool { profile: &small, te: Vec3::z(), ta: Vec3::z() };
    let g = gap(&tool, &saddle, Side::Positive, 0.0).unwrap();
    assert!((g.g - 1.0).abs() < 1e-14 && g.surface_point.norm() < 1e-7, "{g:?}");
}

/// Flat end tangent to the bottom of a bowl: the depth at its edge is 50 - sqrt(50^2 - 10^2).
#[test]
fn rim_of_a_flat_end_in_a_bowl() {
    let flat = mill(20.0, 0.0);
    let bowl = Surface::Sphere(Sphere { center: Vec3::new(0.0, 0.0, 50.0), radius: 50.0 });
    let tool = Tool { profile: &flat, te: Vec3::zeros(), ta: Vec3::z() };
    let g = gap(&tool, &bowl, Side::Negative, 0.0).unwrap();
    // Seen from the edge the wall is nearer than straight below.
    let depth = Vec3::new(10.0, 0.0, -50.0).norm() - 50.0;
    assert!((g.g + depth).abs() < 1e-12);
    let shorter = Profile::new(&Cutter::mill(20.0, 0.0, 95.0)).unwrap();
    let tool = Tool { profile: &shorter, te: Vec3::new(0.0, 0.0, 4.0), ta: Vec3::z() };
    // Now the top edge touches.
    let g = gap(&tool, &bowl, Side::Negative, 0.0).unwrap();
    assert!((g.tool_point.z - 99.0).abs() < 1e-12);
}

fn check(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    found: Result<Gap, Reason>,
) -> Result<(), TestCaseError> {
    let reference = brute(tool, surface, side);
    // Deep inside several notions of depth differ.
    prop_assume!(reference > -1.5);
    // Beside the ends of a curve there is nothing to face.
    prop_assume!(!matches!(found, Err(Reason::OutOfDomain)));
    // A tool over the vertex of a cone is as deep as it must move back, not as deep as its points are.
    if let (Surface::Cone(c), Ok(g)) = (surface, &found) {
        prop_assume!(reference > 0.0 && g.g > 0.0 || (g.tool_point - c.vertex).norm() > 12.0);
    }
    let g = found.map_err(|e| TestCaseError::fail(format!("{e:?}, brute {reference}")))?;
    // The reference is the distance of some point of the tool, so it bounds the gap from above; and the
    // gap found belongs to a point of the tool.
    let attained = side.sign() * surface.distance(g.tool_point);
    prop_assert!(g.g < reference + 1e-6, "{:?}, brute {}", g, reference);
    prop_assert!((g.g - attained).abs() < 1e-7, "{:?}, attained {}", g, attained);
    prop_assert!((g.normal.norm() - 1.0).abs() < 1e-12);
    prop_assert!((g.tool_point - g.surface_point - g.normal * g.raw).norm() < 1e-6);
    prop_assert!(tool.distance(g.tool_point).abs() < 1e-7);
    prop_assert!(surface.distance(g.surface_point).abs() < 1e-7);
    prop_assert!(g.residual < 1e-6, "{:?}", g);
    Ok(())
}

proptest! {
    #![proptest_config(support::cases(300))]

    #[test]
    fn closed_forms_agree_with_brute_force(
        cutter in cutter(), surface in simple(), ta in axis(),
        te in prop::array::uniform3(-30.0_f64..30.0), lift in -1.0_f64..3.0,
    ) {
        let profile = Profile::new(&cutter).unwrap();
        let te = Vec3::from(te);
        let side = Side::of(te, &surface);
        // Put the tool near the surface: move it along the gradient to the gap `lift`.
        let mut tool = Tool { profile: &profile, te, ta };
        for _ in 0..3 {
            let g = gap(&tool, &surface, side, 0.0).unwrap();
            tool.te -= g.normal * (g.g - lift);
        }
        check(&tool, &surface, side, gap(&tool, &surface, side, 0.0))?;
    }

    #[test]
    fn quadrics_agree_with_brute_force(
        cutter in cutter(), surface in prop_oneof![quadric(), tabcyl()], ta in axis(),
        te in prop::array::uniform3(-30.0_f64..30.0), lift in -0.5_f64..3.0,
    ) {
        let profile = Profile::new(&cutter).unwrap();
        let te = Vec3::from(te);
        let side = Side::of(te, &surface);
        let mut tool = Tool { profile: &profile, te, ta };
        for _ in 0..3 {
            if let Ok(g) = gap(&tool, &surface, side, 0.0) {
                tool.te -= g.normal * (g.g - lift);
            }
        }
        check(&tool, &surface, side, gap(&tool, &surface, side, 0.0))?;
    }

    #[test]
    fn derivatives_are_those_of_differences(
        cutter in cutter(), simple in simple(), quadric in prop_oneof![quadric(), tabcyl()], which in any::<bool>(),
        ta in axis(), te in prop::array::uniform3(-30.0_f64..30.0), lift in -0.1_f64..2.0,
    ) {
        let surface = if which { simple } else { quadric };
        let profile = Profile::new(&cutter).unwrap();
        let te = Vec3::from(te);
        let side = Side::of(te, &surface);
        let mut tool = Tool { profile: &profile, te, ta };
        for _ in 0..3 {
            if let Ok(g) = gap(&tool, &surface, side, 0.0) {
                tool.te -= g.normal * (g.g - lift);
            }
        }
        let Ok(here) = gap(&tool, &surface, side, 0.0) else { return Ok(()) };
        if let Surface::Cone(c) = &surface {
            prop_assume!((here.surface_point - c.vertex).norm() > 1.0);
        }
        let across = |g: &Gap, d: Vec3| second(&tool.at(tool.te + d), &surface, side, g);
        let Some(bend) = second(&tool, &surface, side, &here) else { return Ok(()) };
        let h = 1e-4;
        for d in [Vec3::x(), Vec3::y(), Vec3::z()] {
            let at = |s: f64| gap_near(&tool.at(tool.te + d * s), &surface, side, 0.0,
                Some(here.spot()));
            if let (Ok(f), Ok(b)) = (at(h), at(-h)) {
                // Only within one smooth piece.
                let apart = (f.tool_point - b.tool_point).norm();
                let jump = |g: &Gap, s: f64| {
                    across(g, d * s).is_none_or(|k| {
                        (k.second(d) - bend.second(d)).abs() > 1e-3 * (1.0 + bend.second(d).abs())
                    })
                };
                let smooth = !jump(&f, h) && !jump(&b, -h);
                if f.segment == here.segment && b.segment == here.segment && apart < 1e-2 && smooth
                {
                    let slope = (f.g - b.g) / (2.0 * h);
                    prop_assert!((slope - here.normal.dot(&d)).abs() < 1e-4, "{} {:?}", slope, here);
                    let curved = (f.normal - b.normal).dot(&d) / (2.0 * h);
                    let exact = bend.second(d);
                    prop_assert!(
                        (curved - exact).abs() < 1e-3 * (1.0 + exact.abs()),
                        "{} {} {:?}", curved, exact, here
                    );
                }
            }
        }
    }

    #[test]
    fn an_open_hollow_has_the_walls_that_do_not_lean_over_the_tool(
        cutter in cutter(), kind in 0_usize..4, te in prop::array::uniform3(-9.0_f64..9.0),
        lean in prop::array::uniform2(-0.4_f64..0.4), axis in prop::array::uniform2(-0.5_f64..0.5),
    ) {
        let profile = Profile::new(&cutter).unwrap();
        let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
        let tool = Tool { profile: &profile, te: Vec3::from(te), ta };
        let t = Vec3::new(1.0, axis[0], axis[1]).normalize();
        let o = Vec3::zeros();
        let (surface, tilt, flat) = match kind {
            0 => (Surface::Sphere(Sphere { center: o, radius: 40.0 }), None, 1.0),
            1 => (Surface::Cylinder(Cylinder { point: o, axis: t, radius: 40.0 }), Some(0.0), 1.0),
            2 => (ellipsoid(HALVES), None, 1.0),
            _ => (Surface::Cone(Cone { vertex: t * -90.0, axis: t, cos_half: 0.9 }), Some(0.19_f64.sqrt()), 0.9),
        };
        prop_assert!(opens(&surface, ta));
        let g = gap(&tool, &surface, Side::Open, 0.0).unwrap();
        // The least clearance of all tangent planes allowed.
        let reach = |m: Vec3| match &surface {
            Surface::Cone(s) => m.dot(&s.vertex),
            Surface::Quadric(_) => (0..3).map(|i| (m[i] * HALVES[i]).powi(2)).sum::<f64>().sqrt(),
            _ => 40.0,
        };
        let [u, v] = aptc_geometry::surface::frame_about(if tilt.is_some() { t } else { ta });
        let mut least = f64::INFINITY;
        let around = if tilt.is_some() { 7200 } else { 360 };
        for i in 0..around {
            let turn = f64::from(i) / f64::from(around) * std::f64::consts::TAU;
            let (s, c) = trig::sin_cos(turn);
            let e = u * c + v * s;
            for k in 0..=90 {
                let m = match tilt {
                    Some(tilt) => e * flat - t * tilt,
                    None => {
                        let turn = f64::from(k) / 90.0 * std::f64::consts::FRAC_PI_2;
                        let (s, c) = trig::sin_cos(turn);
                        e * c - ta * s
                    }
                };
                if m.dot(&ta) <= 1e-12 {
                    least = least.min(reach(m) - tool.support(m).reach);
                }
                if tilt.is_some() {
                    break;
                }
            }
        }
        prop_assert!(g.g <= least + 1e-9, "{} {least} {surface:?}", g.g);
        prop_assert!(g.g >= least - 0.1, "{} {least} {surface:?}", g.g);
        prop_assert!((g.surface_point - g.tool_point + g.normal * g.g).norm() < 1e-9);
        let h = 1e-4;
        for d in [Vec3::x(), Vec3::y(), Vec3::z()] {
            let at = |s: f64| gap(&tool.at(tool.te + d * s), &surface, Side::Open, 0.0).unwrap();
            let (f, b) = (at(h), at(-h));
            if (f.normal - b.normal).norm() < 1e-3 && f.segment == b.segment {
                prop_assert!(((f.g - b.g) / (2.0 * h) - g.normal.dot(&d)).abs() < 1e-4);
                let bend = (f.normal - b.normal).dot(&d) / (2.0 * h);
                let told = second(&tool, &surface, Side::Open, &g).map(|s| s.second(d));
                // The bend jumps where the wall begins to run straight up.
                if let Some(told) = told && g.normal.dot(&ta) > 1e-3 {
                    prop_assert!((told - bend).abs() < 1e-3 * (1.0 + bend.abs()), "{told} {bend} {surface:?}");
                }
            }
        }
    }

    #[test]
    fn sides_and_scales(
        cutter in cutter(), surface in simple(), te in prop::array::uniform3(-30.0_f64..30.0),
        thick in -1.0_f64..1.0,
    ) {
        let profile = Profile::new(&cutter).unwrap();
        let tool = Tool { profile: &profile, te: Vec3::from(te), ta: Vec3::z() };
        let side = Side::of(tool.te, &surface);
        let g = gap(&tool, &surface, side, thick).unwrap();
        prop_assert!((g.raw - thick - g.g).abs() < 1e-15);
        // A plane with reversed normal and the other side is the same plane.
        if let Surface::Plane(p) = &surface {
            let turned = Surface::Plane(Plane { n: -p.n, d: -p.d });
            let h = gap(&tool, &turned, if side == Side::Positive { Side::Negative } else { Side::Positive }, thick).unwrap();
            prop_assert!((g.g - h.g).abs() < 1e-13 && (g.normal - h.normal).norm() < 1e-15);
        }
        let o = on(tool.te, &surface, side);
        prop_assert!(o.g >= 0.0 && o.g >= g.raw - 1e-12);
    }
}

/// Least signed distance of the tool's outline from the surface, by sampling and zooming in.
fn brute(tool: &Tool<'_>, surface: &Surface, side: Side) -> f64 {
    let profile = tool.profile;
    let outline = outline(profile);
    let [a, b] = aptc_geometry::surface::frame_about(tool.ta);
    let at = |turn: f64, s: f64| {
        let [rho, z] = outline(s);
        let (sin, cos) = trig::sin_cos(turn);
        side.sign() * surface.distance(tool.te + (a * cos + b * sin) * rho + tool.ta * z)
    };
    let (nt, ns) = (24, 36);
    let tau = std::f64::consts::TAU;
    let mut all: Vec<(f64, f64, f64)> = Vec::new();
    for i in 0..nt {
        for j in 0..=ns {
            let (turn, s) =
                (tau * f64::from(i) / f64::from(nt), 6.0 * f64::from(j) / f64::from(ns));
            // A sharp corner is one place, not a third of all.
            if profile.corner_radius() == 0.0 && s > 1.0 && s < 4.0 {
                continue;
            }
            all.push((at(turn, s), turn, s));
        }
    }
    all.sort_by(|x, y| x.0.total_cmp(&y.0));
    let mut best = f64::INFINITY;
    for &(value, turn, s) in all.iter().take(40) {
        let (mut value, mut turn, mut s) = (value, turn, s);
        let (mut dt, mut ds) = (tau / f64::from(nt), 6.0 / f64::from(ns));
        for _ in 0..400 {
            let around = [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, -1), (1, -1), (-1, 1)];
            let next = around
                .iter()
                .map(|(i, j)| (turn + dt * f64::from(*i), (s + ds * f64::from(*j)).clamp(0.0, 6.0)))
                .map(|(t, s)| (at(t, s), t, s))
                .min_by(|x, y| x.0.total_cmp(&y.0))
                .expect("eight neighbours");
            if next.0 < value {
                (value, turn, s) = next;
            } else {
                (dt, ds) = (0.5 * dt, 0.5 * ds);
                if dt < 1e-9 {
                    break;
                }
            }
        }
        best = best.min(value);
    }
    best
}

/// The profile by a parameter in 0..6, two units for the arc, one for each line and face.
fn outline(profile: &Profile) -> impl Fn(f64) -> [f64; 2] + '_ {
    let [lower, upper] = profile.joints();
    let [e, f] = profile.corner();
    let (from, to) = if profile.corner_radius() > 0.0 {
        (trig::atan2(lower[1] - f, lower[0] - e), trig::atan2(upper[1] - f, upper[0] - e))
    } else {
        (0.0, 0.0)
    };
    let r = profile.corner_radius();
    let mix =
        |a: [f64; 2], b: [f64; 2], x: f64| [a[0] + (b[0] - a[0]) * x, a[1] + (b[1] - a[1]) * x];
    let rim = [profile.top_radius(), profile.height()];
    move |s| {
        if s <= 1.0 {
            mix([0.0, profile.bottom()], lower, s)
        } else if s <= 4.0 {
            let (sin, cos) = trig::sin_cos(from + (to - from) * (s - 1.0) / 3.0);
            [e + r * cos, f + r * sin]
        } else if s <= 5.0 {
            mix(upper, rim, s - 4.0)
        } else {
            mix(rim, [0.0, profile.height()], s - 5.0)
        }
    }
}

/// A flat end upon a cone touches along a ruling, and with the least tilt at one end of it: the peak of the clearance is as
/// sharp as the tilt is small.
#[test]
fn flat_ends_that_all_but_lie_on_a_cone() {
    let mut dice = 7_u64;
    let mut unit = || {
        dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        #[expect(clippy::cast_precision_loss, reason = "31 bits")]
        let x = (dice >> 33) as f64 / 2_147_483_648.0;
        2.0 * x - 1.0
    };
    let cone = Cone { vertex: Vec3::new(20.0, 12.0, 9.0), axis: -Vec3::z(), cos_half: 0.4 };
    let surface = Surface::Cone(cone);
    for corner in [0.0, 1.09] {
        let profile = mill(7.26, corner);
        for k in 0..400 {
            let at = cone.vertex + Vec3::new(30.0 * unit(), 30.0 * unit(), -40.0 - 10.0 * unit());
            let foot = surface.foot(at);
            // Tilts of .1 to 1e-13 radians, and none.
            let size = if k % 20 == 0 { 0.0 } else { trig::pow(10.0, -7.0 + 6.0 * unit()) };
            let tilt = Vec3::new(unit(), unit(), unit()) * size;
            let ta = (foot.normal + tilt).normalize();
            let te = foot.point + foot.normal * (1e-3 * (1.0 + unit()));
            let tool = Tool { profile: &profile, te, ta };
            let found = gap(&tool, &surface, Side::Positive, 0.0).unwrap();
            // The deepest point lies on the edge of the flat end, or on the arc beside it.
            let [u, w] = aptc_geometry::surface::frame_about(ta);
            let rho = profile.joints()[0][0];
            let edge = |turn: f64| {
                surface.distance(te + u * (rho * trig::cos(turn)) + w * (rho * trig::sin(turn)))
            };
            let lowest = |turn: f64| {
                let (mut best, mut step) = ((edge(turn), turn), 0.01);
                while step > 1e-12 {
                    let turn =
                        [best.1 - step, best.1 + step].into_iter().find(|t| edge(*t) < best.0);
                    match turn {
                        Some(turn) => best = (edge(turn), turn),
                        None => step *= 0.5,
                    }
                }
                best.0
            };
            let all = (0..36).map(|i| lowest(f64::from(i) * core::f64::consts::TAU / 36.0));
            let least = all.fold(surface.distance(te), f64::min);
            // The arc goes deeper by its sagitta, of the order of the square of the tilt.
            let slack = 1e-11 + corner * 2.0 * size * size;
            assert!(
                (found.g - least).abs() <= slack,
                "{corner} {k} {size:e}: {} {least} {found:?}",
                found.g
            );
        }
    }
}
