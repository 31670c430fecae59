//! Wide flat ends over waves of a TABCYL: of many crests below them the right one touches.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::sync::Arc;

use aptc_contact::{Side, elsewhere, gap, gap_near};
use aptc_geometry::surface::TabcylSurface;
use aptc_geometry::{Cutter, Fit, Knot, Profile, Surface, Tabcyl, Tool, Vec2, Vec3, trig};
use proptest::prelude::*;

/// Waves along x with their rulings along y, the left of the curve being up.
fn waves(height: f64, length: f64, rough: &[f64]) -> Option<Tabcyl> {
    let step = length / 7.0;
    let knots: Vec<Knot> = (0..rough.len())
        .map(|i| {
            let x = -60.0 + step * f64::from(u32::try_from(i).unwrap());
            let z = height * (trig::sin(x * std::f64::consts::TAU / length) + 0.2 * rough[i]);
            Knot { point: Vec2::new(x, z), tangent: None }
        })
        .collect();
    let axes = nalgebra::Matrix3::from_rows(&[
        Vec3::x().transpose(),
        Vec3::z().transpose(),
        (-Vec3::y()).transpose(),
    ]);
    Tabcyl::fit(&knots, Fit::Spline, axes, 10.0).ok()
}

/// The highest place of the curve within `reach` of `x`.
fn highest(form: &Tabcyl, x: f64, reach: f64) -> f64 {
    let within = |p: Vec2| (p.x - x).abs() <= reach;
    let mut best = f64::NEG_INFINITY;
    for (i, span) in form.spans.iter().enumerate() {
        let at = |k: u32| span.length * f64::from(k) / 200.0;
        for k in 0..200 {
            let (mut low, mut high) = (at(k), at(k + 1));
            let [p, q] = [low, high].map(|s| form.point(i, s));
            if !within(p) && !within(q) {
                continue;
            }
            if within(p) != within(q) {
                // The border of the reach.
                let inside = within(p);
                let (mut a, mut b) = (low, high);
                for _ in 0..60 {
                    let middle = 0.5 * (a + b);
                    *(if within(form.point(i, middle)) == inside { &mut a } else { &mut b }) =
                        middle;
                }
                *(if inside { &mut high } else { &mut low }) = if inside { a } else { b };
            }
            // The crest, by thirds.
            for _ in 0..60 {
                let third = (high - low) / 3.0;
                let [a, b] = [low + third, high - third].map(|s| form.point(i, s).y);
                if a < b { low += third } else { high -= third }
            }
            best = best.max(form.point(i, low).y).max(form.point(i, high).y);
        }
    }
    best
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 60, failure_persistence: None, ..ProptestConfig::default()
    })]

    #[test]
    fn a_flat_end_on_the_highest_crest_below_it_touches(
        height in 0.05_f64..0.3, length in 6.0_f64..24.0, diameter in 16.0_f64..25.0,
        rough in prop::collection::vec(0.0_f64..1.0, 120..121), from in -20.0_f64..0.0,
    ) {
        let form = Arc::new(waves(height, length, &rough).unwrap());
        let surface = Surface::Tabcyl(Arc::new(TabcylSurface::new(&form).unwrap()));
        let profile = Profile::new(&Cutter::mill(diameter, 0.0, 60.0)).unwrap();
        let place = |x: f64| Vec3::new(x, 3.0, highest(&form, x, 0.5 * diameter));
        let mut known = None;
        for k in 0..12 {
            let te = place(from + 0.7 * f64::from(k));
            let tool = Tool { profile: &profile, te, ta: Vec3::z() };
            let whole = gap(&tool, &surface, Side::Positive, 0.0).unwrap();
            prop_assert!(whole.g.abs() < 1e-6, "{} {whole:?}", te.x);
            // The same from the last place of contact, with a look for others.
            if let Some(spot) = known {
                let near = gap_near(&tool, &surface, Side::Positive, 0.0, Some(spot)).unwrap();
                let (deeper, room) = elsewhere(&tool, &surface, Side::Positive, &near, (true, f64::INFINITY));
                let found = deeper.unwrap_or(near);
                prop_assert!(found.g.abs() < 1e-6, "{} {near:?} {found:?}", te.x);
                // Nothing else touches before the tool has gone that way.
                let beside = Tool { te: te + Vec3::x() * (0.99 * room), ..tool };
                let then = gap_near(&beside, &surface, Side::Positive, 0.0, Some(found.spot())).unwrap();
                let all = gap(&beside, &surface, Side::Positive, 0.0).unwrap();
                prop_assert!(deeper.is_some() || all.g > then.g - 1e-6, "{} {room} {then:?} {all:?}", te.x);
            }
            known = Some(whole.spot());
        }
    }
}
