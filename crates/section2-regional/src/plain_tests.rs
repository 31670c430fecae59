//! Sides and depths against closed forms.

use super::*;
use aptc_geometry::{Cutter, Cylinder, Plane, Quadric, QuadricKind, Sphere};

fn plain(surface: Surface) -> Plain {
    let form = Arc::new(Form::Point(Vec3::zeros()));
    Plain { name: "K".into(), form, surface: Arc::new(surface), from: None, thick: 0.0 }
}

#[test]
fn planes_and_spheres_are_kept_clear_of() {
    let profile = Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap();
    let up = Vec3::z();
    let floor = plain(Surface::Plane(Plane { n: Vec3::z(), d: 0.0 }));
    let deep = |p: &Plain, a: Vec3, b: Vec3| {
        p.deep(&profile, (&profile, 0.0), [(a, up), (b, up)], 0.01, Patience::Full)
    };
    assert!(deep(&floor, Vec3::z() * 0.5, Vec3::new(30.0, 0.0, 0.0)).is_none());
    let d = deep(&floor, Vec3::z() * 0.5, Vec3::new(30.0, 0.0, -0.25)).unwrap().depth;
    assert!((d - 0.25).abs() < 1e-3, "{d}");
    // Past a sphere whose top is met half way only.
    let ball = Sphere { center: Vec3::new(20.0, 0.0, -3.0), radius: 4.0 };
    let dome = plain(Surface::Sphere(ball));
    let d = deep(&dome, Vec3::zeros(), Vec3::x() * 40.0).unwrap().depth;
    assert!((d - 1.0).abs() < 1e-2, "{d}");
    assert!(deep(&dome, Vec3::zeros(), Vec3::new(0.0, 40.0, 0.0)).is_none());
    // Turning about a tool end that stays clear, the side comes down on the plane.
    let lying = Vec3::new(1.0, 0.0, 0.02).normalize();
    let ends = [(Vec3::z() * 6.0, up), (Vec3::z() * 3.0, lying)];
    assert!(floor.deep(&profile, (&profile, 0.0), ends, 0.01, Patience::Full).is_some());
}

/// How deep cutter, holder and the axis between them are on a way at the height 0 along x, the tool coming from `from`.
fn deep(surface: Surface, from: Option<Vec3>) -> [f64; 3] {
    let cutter = Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap();
    let holder = [(Profile::new(&Cutter::mill(16.0, 0.0, 20.0)).unwrap(), 50.0)];
    let (rod, top) = kept::between(&cutter, &holder, 0.01).unwrap();
    let up = Vec3::z();
    let mut p = plain(surface);
    if let Some(from) = from {
        p.come_from(&cutter, (from, up), 0.01);
    }
    let ends = [(Vec3::new(-1.0, 0.0, 0.0), up), (Vec3::new(1.0, 0.0, 0.0), up)];
    [(cutter, 0.0), holder[0], (rod, top)].map(|(profile, up)| {
        p.deep(&cutter, (&profile, up), ends, 0.01, Patience::Full).map_or(0.0, |d| d.depth)
    })
}

fn near(found: [f64; 3], wanted: [f64; 3]) {
    let off = found.iter().zip(wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off < 2e-2, "{found:?}, not {wanted:?}");
}

const ABOVE: Option<Vec3> = Some(Vec3::new(0.0, 0.0, 90.0));
const INSIDE: Option<Vec3> = Some(Vec3::new(0.0, 0.0, 1.0));

#[test]
fn cutter_and_holder_keep_to_the_side_that_the_tool_comes_from() {
    let plane = |z: f64| Surface::Plane(Plane { n: Vec3::z(), d: z });
    near(deep(plane(45.0), INSIDE), [0.0, 25.0, 5.0]);
    near(deep(plane(45.0), ABOVE), [45.0, 0.0, 5.0]);
    near(deep(plane(-3.0), ABOVE), [0.0; 3]);
    near(deep(plane(75.0), INSIDE), [0.0; 3]);
    // Where nothing was put out before the first place of the way tells.
    near(deep(plane(45.0), None), [0.0, 25.0, 5.0]);
    near(deep(plane(-3.0), None), [0.0; 3]);
}

#[test]
fn bowls_and_troughs_are_open_above() {
    let ball = |radius: f64| Surface::Sphere(Sphere { center: Vec3::new(0.0, 0.0, 6.0), radius });
    let point = Vec3::new(0.0, 0.0, 6.0);
    let bar = |radius: f64| Surface::Cylinder(Cylinder { point, axis: Vec3::y(), radius });
    let own = |radius: f64| {
        // The same ball, and with the other sign.
        let c = [1.0, 1.0, 1.0, 36.0 - radius * radius, 0.0, 0.0, 0.0, 0.0, 0.0, -6.0];
        [c, c.map(|x| -x)].map(|c| {
            let form = Form::Quadric(Quadric { kind: QuadricKind::Qadric, c });
            let made = Plain::new("K".into(), &Arc::new(form)).unwrap();
            Surface::clone(&made.surface)
        })
    };
    // Solid for who comes from above: a ball about the height 6 in the cutter up to its middle and the axis.
    near(deep(ball(9.5), ABOVE), [14.5, 0.0, 0.0]);
    near(deep(bar(9.5), ABOVE), [14.5, 0.0, 0.0]);
    for from in [INSIDE, None] {
        for radius in [9.0, 8.5, 90.0] {
            // The holder, of radius 8, goes as far as 9; one that has room in a ball does not ask how high it is.
            let wanted = [0.0, f64::max(9.0 - radius, 0.0), 0.0];
            near(deep(ball(radius), from), wanted);
            near(deep(bar(radius), from), wanted);
            for own in own(radius) {
                near(deep(own, from), wanted);
            }
        }
        // The cutter's middle is 1 below that of the hollow and goes 1 to the side.
        near(deep(ball(5.5), from), [2.0_f64.sqrt() + 5.0 - 5.5, 3.5, 0.0]);
    }
    // Tool and holder in a ball of radius 50 about the height 30 reach to 70: its roof at 80 does not count, nor one at 60.
    for radius in [50.0, 30.5] {
        let large = Surface::Sphere(Sphere { center: Vec3::new(0.0, 0.0, 30.0), radius });
        near(deep(large, INSIDE), [0.0; 3]);
    }
}

#[test]
fn what_stands_between_cutter_and_holder_is_met_by_the_axis() {
    // A ball of radius 2 about the axis at the height 45, and bars through it: neither cutter nor holder touches them.
    let center = Vec3::new(0.0, 0.0, 45.0);
    near(deep(Surface::Sphere(Sphere { center, radius: 2.0 }), ABOVE), [0.0, 0.0, 2.02]);
    let bar = Cylinder { point: center, axis: Vec3::y(), radius: 2.0 };
    near(deep(Surface::Cylinder(bar), ABOVE), [0.0, 0.0, 2.02]);
    let past = Vec3::new(0.0, 2.5, 45.0);
    let bar = Cylinder { point: past, axis: Vec3::x(), radius: 2.0 };
    near(deep(Surface::Cylinder(bar), ABOVE), [0.0; 3]);
    // z = 45 + xy / 10 has no sides.
    let c = [0.0, 0.0, 0.0, 45.0, 0.0, 0.0, 0.05, 0.0, 0.0, -0.5];
    let saddle = |c: [f64; 10]| {
        let form = Form::Quadric(Quadric { kind: QuadricKind::Qadric, c });
        Surface::from_form(&form).unwrap()
    };
    let found = deep(saddle(c.map(|x| -x)), ABOVE);
    // It goes right through the rod, which is .018 thick from its middle.
    near(found, [0.0, 0.0, 0.018]);
    assert!(found[2] > 0.01, "{found:?}");
    let below = [0.0, 0.0, 0.0, -9.0, 0.0, 0.0, 0.05, 0.0, 0.0, -0.5];
    near(deep(saddle(below), ABOVE), [0.0; 3]);
}

#[test]
fn who_comes_from_outside_is_told() {
    let cutter = Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap();
    let (inside, above) = (Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.0, 0.0, 90.0));
    let entered = |surface: Surface, from: Vec3| {
        let mut p = plain(surface);
        p.come_from(&cutter, (from, Vec3::z()), 0.01);
        p.entered(&cutter, (inside, Vec3::z()))
    };
    let ball = || Surface::Sphere(Sphere { center: Vec3::new(0.0, 0.0, 6.0), radius: 20.0 });
    assert_eq!((entered(ball(), above), entered(ball(), inside)), (Some(above), None));
    // What stands could not be a bowl.
    let (point, axis) = (Vec3::zeros(), Vec3::z());
    let post = Surface::Cylinder(Cylinder { point, axis, radius: 20.0 });
    assert_eq!(entered(post, Vec3::new(90.0, 0.0, 0.0)), None);
}

/// Random ways with a turning axis beside solids, against small steps of them: what is told is as deep as a place of the
/// way, and what is clear is so; the bound from the ends is below all steps and falls short by second order.
#[test]
fn a_turning_way_is_as_deep_as_its_deepest_place() {
    let mut state = 7_u64;
    let mut random = |from: f64, to: f64| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (state >> 40) as f64 / f64::from(1 << 24)
    };
    let (mut told, mut bounded) = ([0; 2], 0);
    for k in 0..600 {
        let corner = [0.0, 1.5, 5.0][k % 3];
        let profile = Profile::new(&Cutter::mill(10.0, corner, 40.0)).unwrap();
        let mut v =
            |size: f64| Vec3::new(random(-size, size), random(-size, size), random(-size, size));
        let (center, way, turn, tilt) = (v(3.0), v(4.0), v(0.2), v(0.3));
        let (te, other, up) = (v(2.0), v(1.0), random(0.0, 6.0));
        let axes = [tilt, tilt + turn].map(|a| (a + Vec3::z()).normalize());
        let point = center - Vec3::z() * 22.0;
        let (surface, side) = match k / 3 % 7 {
            0 => (Surface::Plane(Plane { n: (Vec3::z() + other * 0.2).normalize(), d: -2.0 }), 1.0),
            1 => (Surface::Sphere(Sphere { center: point, radius: 20.0 }), 1.0),
            2 => {
                let axis = (Vec3::y() + other * 0.2).normalize();
                (Surface::Cylinder(Cylinder { point, axis, radius: 20.0 }), 1.0)
            }
            3 => {
                (Surface::Sphere(Sphere { center: center + Vec3::z() * 30.0, radius: 33.0 }), -1.0)
            }
            4 => {
                let cylinder = Cylinder { point: center, axis: axes[0], radius: 9.0 };
                (Surface::Cylinder(cylinder), -1.0)
            }
            5 => {
                // Half axes of 30, 20 and 24.
                let [p, q, r] = [1.0 / 900.0, 1.0 / 400.0, 1.0 / 576.0];
                let c = [p, q, r, 484.0 * r - 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 22.0 * r];
                let form = Form::Quadric(Quadric { kind: QuadricKind::Qadric, c });
                (kept::with_inside(&Surface::from_form(&form).unwrap()).unwrap(), 1.0)
            }
            _ => {
                (Surface::Cylinder(Cylinder { point: center, axis: Vec3::y(), radius: 30.0 }), -1.0)
            }
        };
        let mut p = plain(surface);
        p.from = Some(Came { te, side: Some(side) });
        let ends = [(te, axes[0]), (te + way, axes[1])];
        let opened = kept::opens(&p.surface, axis_between(axes[0], axes[1], 0.5));
        let kind = if side > 0.0 {
            Side::Positive
        } else if opened {
            Side::Open
        } else {
            Side::Negative
        };
        let at = |t: f64| {
            let ta = axis_between(axes[0], axes[1], t);
            let tool = Tool { profile: &profile, te: te + way * t + ta * up, ta };
            let g = gap(&tool, &p.surface, kind, 0.0).ok().map(|gap| gap.g);
            Stood { t, te: te + way * t, ta, g }
        };
        let least = |from: f64, to: f64| {
            let of = |i: u32| at(from + (to - from) * f64::from(i) / 300.0).g.unwrap();
            (0..=300).map(of).fold(f64::INFINITY, f64::min)
        };
        let true_least = least(0.0, 1.0);
        let deep = |allowed: f64| p.deep(&profile, (&profile, up), ends, allowed, Patience::Full);
        // Just above the greatest depth it is clear, but for what falls between the steps; just below it is told truly.
        if true_least < -0.02 {
            assert_eq!(deep(-true_least * 1.001 + 2e-4), None, "{k}");
            let depth = deep(-true_least * 0.99 - 1e-4).unwrap().depth;
            assert!(
                depth <= -true_least * 1.001 + 2e-4 && depth > -true_least * 0.99 - 1e-4,
                "{k}"
            );
            told[0] += 1;
        } else if true_least > 0.0 {
            assert_eq!(deep(1e-6), None, "{k}");
            told[1] += 1;
        }
        let mut lost = [0.0; 2];
        for (i, length) in [0.1, 0.05].into_iter().enumerate() {
            let (a, b) = (at(0.4), at(0.4 + length));
            let bound = p.between(kind, (&profile, up), [a, b].map(|s| (s, s.g.unwrap())));
            let least = least(0.4, 0.4 + length);
            assert!(bound <= least + 1e-9, "{k} {bound} {least}");
            lost[i] = least - bound;
        }
        if lost[0].is_finite() && lost[0] > 1e-7 {
            // Half of the way, a quarter of what is lost, about.
            assert!(lost[1] < 0.45 * lost[0], "{k} {lost:?}");
            bounded += 1;
        }
    }
    assert!(told[0] > 100 && told[1] > 50 && bounded > 15, "{told:?} {bounded}");
}

/// A flat end that rolls over its edge on a plane, deeper than its ends but for less than is allowed.
#[test]
fn a_tool_that_rolls_within_the_tolerance_is_clear() {
    let profile = Profile::new(&Cutter::mill(10.0, 0.0, 400.0)).unwrap();
    let mut floor = plain(Surface::Plane(Plane { n: Vec3::z(), d: 0.0 }));
    floor.from = Some(Came { te: Vec3::z(), side: Some(1.0) });
    let place = |deg: f64, depth: f64| {
        let (sin, cos) = (trig::sin_deg(deg), trig::cos_deg(deg));
        // The edge that leads is so deep.
        (Vec3::new(0.0, 0.0, 5.0 * sin - depth), Vec3::new(sin, 0.0, cos))
    };
    for (allowed, turn) in [(0.01, 1.0), (1e-4, 0.1)] {
        let ends = [place(20.0, allowed * (1.0 - 1e-7)), place(20.0 + turn, 0.5 * allowed)];
        assert_eq!(floor.deep(&profile, (&profile, 0.0), ends, allowed, Patience::Full), None);
        let ends = [place(20.0, 0.5 * allowed), place(20.0 + turn, allowed * (1.0 + 1e-7))];
        let depth =
            floor.deep(&profile, (&profile, 0.0), ends, allowed, Patience::Full).unwrap().depth;
        assert!(depth > allowed && depth < 1.001 * allowed, "{depth}");
    }
}
