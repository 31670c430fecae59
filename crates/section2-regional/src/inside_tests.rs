//! Every kind of surface against places of it all round the tool.

use std::sync::Arc;

use aptc_contact::axis_between;
use aptc_geometry::surface::kept;
use aptc_geometry::{
    Circle, Cone, Cutter, Fit, Form, Knot, Plane, Profile, Quadric, QuadricKind, Rail,
    RuledSurface, Second, Surface, Tabcyl, Tool, Vec2, Vec3, trig,
};

use crate::plain::{Depth, Patience, Plain};

/// A curve over x, drawn out along z or y.
fn tabcyl(place: f64, high: f64, upright: bool) -> Form {
    let at = |i: i32| {
        let x = 12.0 * f64::from(i) - 48.0;
        let bend = place + high * trig::sin(0.13 * x + place);
        if upright { Vec2::new(x, bend) } else { Vec2::new(bend, x) }
    };
    let knots: Vec<_> = (0..9).map(|i| Knot { point: at(i), tangent: None }).collect();
    let own = |e: Vec3| e * e.transpose();
    let across = |e: Vec3, f: Vec3| e * f.transpose();
    // NOZ has x and y; NOY has z and x.
    let axes = if upright {
        own(Vec3::x()) + own(Vec3::y()) + own(Vec3::z())
    } else {
        across(Vec3::z(), Vec3::x()) + across(Vec3::x(), Vec3::y()) + across(Vec3::y(), Vec3::z())
    };
    Form::Tabcyl(Arc::new(Tabcyl::fit(&knots, Fit::Spline, axes, 1.0).unwrap()))
}

/// Rulings between a quarter of a circle and a straight line above, or another quarter.
fn ruled(centre: Vec3, radius: f64, straight: bool) -> Form {
    let arc = |center: Vec3, radius: f64| {
        let circle = Circle { center, axis: Vec3::z(), radius };
        let at = |x: f64, y: f64| center + Vec3::new(x, y, 0.0) * radius;
        let toward = at(1.0, 1.0) - center;
        let surface = Arc::new(Form::Circle(circle));
        Rail { surface, start: at(1.0, 0.0), end: at(0.0, 1.0), toward }
    };
    let up = centre + Vec3::z() * 40.0;
    let second = if straight {
        let start = up + Vec3::x() * radius;
        let end = up + Vec3::y() * radius;
        let n = Vec3::new(1.0, 1.0, 0.0).normalize();
        let plane = Arc::new(Form::Plane(Plane { n, d: n.dot(&start) }));
        Rail { surface: plane, start, end, toward: Vec3::x() }
    } else {
        arc(up, 1.3 * radius)
    };
    let second = Second::Rail(second);
    Form::Ruled(Arc::new(RuledSurface { first: arc(centre, radius), second }))
}

fn quadric(c: [f64; 10]) -> Form {
    Form::Quadric(Quadric { kind: QuadricKind::Qadric, c })
}

/// The form of that number; lengths are some tens.
fn form(kind: usize, random: &mut impl FnMut(f64, f64) -> f64) -> Form {
    let centre = Vec3::new(random(-25.0, 25.0), random(-25.0, 25.0), random(-20.0, 10.0));
    let [p, q, r] = [random(8.0, 30.0), random(8.0, 30.0), random(8.0, 30.0)].map(|a| 1.0 / a / a);
    match kind {
        0 => tabcyl(random(-20.0, 20.0), random(1.0, 6.0), true),
        1 => tabcyl(random(-20.0, 20.0), random(1.0, 6.0), false),
        2 => ruled(centre - Vec3::z() * 15.0, random(8.0, 25.0), true),
        3 => ruled(centre - Vec3::z() * 15.0, random(8.0, 25.0), false),
        // z = h + x y / c.
        4 => quadric([0.0, 0.0, 0.0, centre.z, 0.0, 0.0, random(-0.03, 0.03), 0.0, 0.0, -0.5]),
        // Hyperboloids of one sheet and of two, about x or z.
        5 => quadric([p, q, -r, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        6 => quadric([p, -q, -r, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        // A hyperbola and an ellipse along z.
        7 => quadric([p, -q, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        8 => quadric([p, q, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        _ => {
            let axis = Vec3::new(random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0));
            let cos_half = trig::cos_deg(random(10.0, 50.0));
            Form::Cone(Cone { vertex: centre, axis: axis.normalize(), cos_half })
        }
    }
}

/// How deep places of the surface are in the tool: its feet from places all over the tool.
fn sampled(profile: &Profile, (te, ta): (Vec3, Vec3), surface: &Surface) -> f64 {
    let tool = Tool { profile, te, ta };
    let side = ta.cross(&Vec3::x()).normalize();
    let other = ta.cross(&side);
    let mut deepest = f64::NEG_INFINITY;
    for i in 0..=24 {
        for j in 0..=4 {
            for k in 0..12 {
                let turn = std::f64::consts::TAU * f64::from(k) / 12.0;
                let out = side * trig::cos(turn) + other * trig::sin(turn);
                let z =
                    profile.bottom() + (profile.height() - profile.bottom()) * f64::from(i) / 24.0;
                let p = te + ta * z + out * (profile.widest() * f64::from(j) / 4.0);
                deepest = deepest.max(-tool.distance(surface.foot(p).point));
            }
        }
    }
    deepest
}

#[test]
fn what_is_in_the_tool_is_told_of_every_kind_of_surface() {
    const ALLOWED: f64 = 0.02;
    let mut state = 11_u64;
    let mut random = |from: f64, to: f64| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (state >> 40) as f64 / f64::from(1 << 24)
    };
    let mut told = [[0; 3]; 10];
    for n in 0..600 {
        let kind = n % 10;
        let made = Arc::new(form(kind, &mut random));
        let plain = Plain::new("K".into(), &made).unwrap();
        let corner = [0.0, 1.5, 5.0][n % 3];
        let profile = Profile::new(&Cutter::mill(10.0, corner, 30.0)).unwrap();
        let te = Vec3::new(random(-30.0, 30.0), random(-30.0, 30.0), random(-20.0, 20.0));
        let by = Vec3::new(random(-4.0, 4.0), random(-4.0, 4.0), random(-2.0, 2.0));
        let lean = Vec3::new(random(-0.4, 0.4), random(-0.4, 0.4), 1.0).normalize();
        let turned = if n % 4 == 0 {
            (lean + Vec3::new(random(-0.1, 0.1), random(-0.1, 0.1), 0.0)).normalize()
        } else {
            lean
        };
        let at = |t: f64| (te + by * t, axis_between(lean, turned, t));
        let found =
            plain.deep(&profile, (&profile, 0.0), [at(0.0), at(1.0)], ALLOWED, Patience::Full);
        let steps = (0..=8).map(|i| sampled(&profile, at(f64::from(i) / 8.0), &plain.surface));
        let deepest = steps.fold(f64::NEG_INFINITY, f64::max);
        // On the other side of what has sides the tool is in the solid, though nothing of the surface is in the tool.
        let sided = kept::side_from(&plain.surface, &profile, at(0.0), ALLOWED).is_some();
        match found {
            None => {
                assert!(deepest <= ALLOWED * 1.05, "{n}: {deepest} deep is not told");
                told[kind][0] += 1;
            }
            Some(Depth { depth, .. }) if depth.is_finite() => {
                assert!(depth > ALLOWED, "{n}: {depth}");
                // Samples are 1.25 apart.
                assert!(sided || deepest > ALLOWED - 0.3, "{n}: {depth} told, {deepest} sampled");
                told[kind][1] += 1;
            }
            Some(_) => told[kind][2] += 1,
        }
    }
    for (kind, [clear, deep, open]) in told.into_iter().enumerate() {
        assert!(clear > 3 && deep > 3, "{kind}: {told:?}");
        assert!(open <= 1, "{kind}: {told:?}");
    }
}
