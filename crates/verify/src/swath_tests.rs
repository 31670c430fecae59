//! Bounds of pieces against places of them.

use super::*;
use aptc_geometry::Cutter;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    /// No place of a parallelogram is farther from the way than `hold` says, or nearer than `bound` does.
    #[test]
    fn a_piece_is_as_far_as_its_places(
        which in 0_usize..3, v in prop::array::uniform3(-2.0..2.0_f64), lean in prop::array::uniform2(-0.3..0.3_f64),
        turn in prop::array::uniform2(-0.5..0.5_f64), x in prop::array::uniform3(-3.0..3.0_f64),
        sides in prop::array::uniform2(prop::array::uniform3(-1.0..1.0_f64)), share in 0.02..1.0_f64,
    ) {
        let cutter = [Cutter::mill(4.0, 2.0, 9.0), Cutter::mill(4.0, 0.5, 9.0), Cutter::mill(3.0, 0.0, 9.0)][which];
        let profile = Profile::new(&cutter).unwrap();
        let axis = |x: f64, y: f64| Vec3::new(x, y, 1.0).normalize();
        let a = Pose { te: Vec3::zeros(), ta: axis(lean[0], lean[1]) };
        let b = Pose { te: Vec3::from(v), ta: axis(lean[0] + turn[0], lean[1] + turn[1]) };
        let swath = Swath::new(&profile, false, &[[a, b]], f64::INFINITY);
        let sides = sides.map(|s| Vec3::from(s) * share);
        let piece = Piece { x: Vec3::from(x), sides, slop: 0.0 };
        let hold = swath.hold(0, &piece, f64::NEG_INFINITY);
        let middle = swath.bound(0, &piece, f64::INFINITY).unwrap();
        let nearest = |x: Vec3| {
            let at = |k: i32| swath.tool().near(&between_poses(&a, &b, f64::from(k) / 400.0), x).0;
            (0..=400).map(at).fold(f64::INFINITY, f64::min)
        };
        for i in -2..=2 {
            for j in -2..=2 {
                let x = piece.x + sides[0] * (0.5 * f64::from(i)) + sides[1] * (0.5 * f64::from(j));
                let d = nearest(x);
                // What lies between the places of the way is second order, but at edges of the tool.
                prop_assert!(d <= hold.most + 2e-3, "{d} of {}", hold.most);
                prop_assert!(swath.bound(0, &piece, d + 1e-9).is_some(), "{d}");
                prop_assert!(i != 0 || j != 0 || d >= middle - 1e-9, "{d} of {middle}");
            }
        }
    }
}

/// A ball that rolls over a crest: the arc on which a place is seen from it is farther from its chord than the place from
/// where it is nearest, and the chord tells another one.
#[test]
fn a_turning_tool_is_as_near_as_it_comes() {
    let profile = Profile::new(&Cutter::mill(20.0, 10.0, 60.0)).unwrap();
    let pose = |deg: f64| {
        let ta = Vec3::new(
            0.6 * aptc_geometry::trig::sin_deg(deg),
            0.5,
            0.6 * aptc_geometry::trig::cos_deg(deg),
        )
        .normalize();
        Pose { te: ta * 20.0, ta }
    };
    let [a, b] = [pose(0.0), pose(4.0)];
    let swath = Swath::new(&profile, false, &[[a, b]], f64::INFINITY);
    let mut worst: f64 = 0.0;
    for k in 0..40 {
        let around = pose(-1.0 + 0.15 * f64::from(k)).ta;
        let x = around * 20.4 + Vec3::y() * 1.6;
        let at = |t: f64| swath.tool().near(&between_poses(&a, &b, t), x).0;
        let least = (0..=4000).map(|k| at(f64::from(k) / 4000.0)).fold(f64::INFINITY, f64::min);
        let (told, t) = swath.distance(0, x, f64::NEG_INFINITY);
        assert!((told - least).abs() < 1e-7 && (at(t) - told).abs() < 1e-12, "{k} {told} {least}");
        worst = worst.max(at(Sweep::new(&swath.tool(), a, b, angle(a.ta, b.ta)).meet(x).t) - least);
    }
    assert!(worst > 1e-4, "{worst}");
}
