//! Bounds of the gap along cut vectors against dense sampling.

mod support;

use aptc_contact::{Condition, Side, Tool, chord, gap, on};
use aptc_geometry::{Cutter, Cylinder, Profile, Surface, Vec3};
use proptest::prelude::*;
use support::{axis, cutter, quadric, simple, tabcyl};

/// Ball of radius 1 round a cylinder of radius 4: the centre's path has radius 5, and a chord of angle .2
/// dips by 5 (1 - cos .1); inside a cylinder of radius 6 it lifts off by as much.
#[test]
fn published_sagitta() {
    let ball = Profile::new(&Cutter::mill(2.0, 1.0, 9.0)).expect("a ball cutter");
    let dip = 5.0 * (1.0 - aptc_geometry::trig::cos(0.1));
    let end = |t: f64| {
        let (s, c) = aptc_geometry::trig::sin_cos(t);
        Vec3::new(5.0 * c, 5.0 * s, 0.0)
    };
    for (radius, side) in [(4.0, Side::Positive), (6.0, Side::Negative)] {
        let s = Surface::Cylinder(Cylinder { point: Vec3::zeros(), axis: Vec3::z(), radius });
        let tool = Tool { profile: &ball, te: end(0.0), ta: Vec3::z() };
        let c = chord(&tool, &tool.at(end(0.2)), &s, Condition::Touch, side, 0.0, None, 1e-12)
            .expect("a closed form");
        assert!(c.proved);
        let (extreme, other, sign) = match side {
            Side::Positive => (c.low, c.high, -1.0),
            _ => (c.high, c.low, 1.0),
        };
        assert!((extreme.g - sign * dip).abs() < 1e-12, "{c:?}");
        assert!((extreme.t - 0.5).abs() < 1e-6);
        assert!(other.g.abs() < 1e-14);
    }
}

proptest! {
    #![proptest_config(support::cases(300))]

    #[test]
    fn bounds_hold_and_are_tight(
        cutter in cutter(), simple in simple(), quadric in prop_oneof![quadric(), tabcyl()], which in any::<bool>(),
        ta in axis(), te in prop::array::uniform3(-30.0_f64..30.0), lift in 0.0_f64..1.0,
        v in prop::array::uniform3(-4.0_f64..4.0), ends_on in any::<bool>(),
    ) {
        let surface = if which { simple } else { quadric };
        let profile = Profile::new(&cutter).unwrap();
        let te = Vec3::from(te);
        let side = Side::of(te, &surface);
        let condition = if ends_on { Condition::On } else { Condition::Touch };
        let at = |te: Vec3| {
            let tool = Tool { profile: &profile, te, ta };
            if ends_on { Ok(on(te, &surface, side)) } else { gap(&tool, &surface, side, 0.0) }
        };
        let mut te = te;
        for _ in 0..3 {
            if let Ok(g) = at(te) {
                te -= g.normal * (g.g - lift);
            }
        }
        let (Ok(first), v) = (at(te), Vec3::from(v)) else { return Ok(()) };
        // Along the surface, as a cut vector runs.
        let v = v - first.normal * v.dot(&first.normal);
        let tool = Tool { profile: &profile, te, ta };
        let resolution = 1e-6;
        let Ok(c) = chord(&tool, &tool.at(te + v), &surface, condition, side, 0.0, None, resolution) else {
            return Ok(());
        };
        let mut sampled = (f64::INFINITY, f64::NEG_INFINITY);
        for i in 0..=200 {
            if let Ok(g) = at(te + v * (f64::from(i) / 200.0)) {
                sampled = (sampled.0.min(g.g), sampled.1.max(g.g));
            }
        }
        // Deep inside the notions of depth differ.
        prop_assume!(sampled.0 > -0.5);
        if c.proved {
            prop_assert!(c.low.g <= sampled.0 + 1e-9, "{:?} {:?}", c, sampled);
            prop_assert!(c.high.g >= sampled.1 - 1e-9, "{:?} {:?}", c, sampled);
            // Sampling misses an extreme value by at most a step.
            let miss = v.norm() / 200.0 + resolution;
            prop_assert!(c.low.g >= sampled.0 - miss && c.high.g <= sampled.1 + miss);
        }
    }

    #[test]
    fn bounds_hold_while_the_axis_turns(
        cutter in cutter(), surface in simple(), ta in axis(), lean in axis(), turn in 0.0_f64..0.3,
        te in prop::array::uniform3(-30.0_f64..30.0), v in prop::array::uniform3(-4.0_f64..4.0),
    ) {
        let profile = Profile::new(&cutter).unwrap();
        let (te, v) = (Vec3::from(te), Vec3::from(v));
        let side = Side::of(te, &surface);
        let tool = Tool { profile: &profile, te, ta };
        let square = lean - ta * lean.dot(&ta);
        prop_assume!(square.norm() > 0.1);
        let square = square.normalize();
        let axis = |t: f64| {
            let (s, c) = aptc_geometry::trig::sin_cos(turn * t);
            ta * c + square * s
        };
        let at = |t: f64| Tool { profile: &profile, te: te + v * t, ta: axis(t) };
        let Ok(c) = chord(&tool, &at(1.0), &surface, Condition::Touch, side, 0.0, None, 1e-6) else {
            return Ok(());
        };
        for i in 0..=200 {
            let t = f64::from(i) / 200.0;
            if let Ok(g) = gap(&at(t), &surface, side, 0.0) {
                prop_assume!(g.g > -0.5);
                prop_assert!(c.low.g <= g.g + 1e-4 && c.high.g >= g.g - 1e-4, "{t} {g:?} {c:?}");
            }
        }
    }
}
