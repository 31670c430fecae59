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
        let (hold, bound) = (swath.hold(0, &piece), swath.bound(0, &piece));
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
                prop_assert!(d >= bound.all - 1e-9, "{d} of {}", bound.all);
                prop_assert!(i != 0 || j != 0 || d >= bound.middle - 1e-9, "{d} of {}", bound.middle);
            }
        }
    }
}
