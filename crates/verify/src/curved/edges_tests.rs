//! Valleys of two flat faces, against the distance of points in closed form.

use std::sync::Arc;

use aptc_cldata::{Controlled, NameRef, Position, Relation};
use aptc_geometry::sculptured::{
    Knot, MeshKind, MeshSpacing, MeshSpline, Smoothing, SurfaceDefinition, SurfaceShape,
};
use aptc_geometry::{Cutter, Form, Profile, Vec3, trig};
use proptest::prelude::*;

use crate::demand::{Demand, Verdict};
use crate::sheets::Sheets;

/// Half the width of each face along y and along the edge.
const WIDE: f64 = 4.0;

/// Faces that rise by `slope` on both sides of the edge, which is the x axis.
fn valley(slope: f64) -> Form {
    let row = |y: f64| {
        let knot = |x: f64| Knot { point: Vec3::new(x, y, slope * y.abs()), ..Knot::default() };
        let knots = [-WIDE, 0.0, WIDE].map(knot).to_vec();
        MeshSpline { smoothing: Smoothing::default(), knots }
    };
    let shape = SurfaceShape::Mesh {
        kind: MeshKind::Smesh,
        spacing: MeshSpacing::Ruled,
        splines: [-WIDE, 0.0, WIDE].map(row).to_vec(),
    };
    Form::Ssurf(Arc::new(SurfaceDefinition::plain(shape)))
}

/// Signed distance of a point, negative below the faces, which go on beyond their borders.
fn distance(p: Vec3, slope: f64) -> f64 {
    let size = (1.0 + slope * slope).sqrt();
    let (y, z) = (p.y.abs(), p.z);
    // Along the nearer face from the edge, and off it.
    let (along, off) = ((y + slope * z) / size, (z - slope * y) / size);
    let far = if along >= 0.0 { off.abs() } else { trig::hypot(y, z) };
    if off >= 0.0 { far } else { -far }
}

/// The deepest of the points of a tool.
fn deepest(profile: &Profile, at: &Position, slope: f64) -> f64 {
    const AROUND: u32 = 90;
    const HIGH: u32 = 24;
    let u = crate::solid::any_across(at.ta);
    let w = at.ta.cross(&u);
    let mut least = f64::INFINITY;
    for i in 0..=HIGH {
        let (s, c) = trig::sin_cos(f64::from(i) / f64::from(HIGH) * std::f64::consts::FRAC_PI_2);
        let [r, z] = profile.support(s, -c).point;
        for k in 0..AROUND {
            let (s, c) = trig::sin_cos(f64::from(k) / f64::from(AROUND) * std::f64::consts::TAU);
            least = least.min(distance(at.te + at.ta * z + (u * c + w * s) * r, slope));
        }
    }
    least
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    /// A tool that goes deeper in at a hollow edge than it may is never proved, however thin it is; one that does not mostly is.
    #[test]
    fn a_tool_at_a_hollow_edge_is_proved_to_its_depth_and_no_deeper(
        slope in 0.02..1.5_f64, te in prop::array::uniform3(-0.4..0.4_f64), v in prop::array::uniform2(-0.5..0.5_f64),
        lean in prop::array::uniform2(-0.5..0.5_f64), which in 0_usize..5,
    ) {
        let cutter = [
            Cutter::mill(0.02, 0.0, 5.0),
            Cutter::mill(0.1, 0.05, 5.0),
            Cutter::mill(1.0, 0.0, 5.0),
            Cutter::mill(1.0, 0.2, 5.0),
            Cutter { e: 0.0, beta_deg: 20.0, ..Cutter::mill(0.002, 0.0, 3.0) },
        ][which];
        let profile = Profile::new(&cutter).unwrap();
        let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
        let a = Position { te: Vec3::new(te[0], te[1], 0.3 * te[2]), ta };
        let b = Position { te: a.te + Vec3::new(v[0], v[1], 0.0), ta };
        let gaps = [0.0, 0.25, 0.5, 0.75, 1.0].map(|t| {
            let at = Position { te: a.te + (b.te - a.te) * t, ta };
            deepest(&profile, &at, slope)
        });
        let gap = gaps.into_iter().fold(f64::INFINITY, f64::min);
        prop_assume!(gap < -0.01);
        let form = Arc::new(valley(slope));
        let judge = |least: f64| {
            let controlled = Controlled {
                name: NameRef::default(), form: Arc::clone(&form), relation: Relation::To, side: 1, open: false, nth: 1,
                thick: 0.0, disk: None, intol: -least, outtol: 1.0,
            };
            Demand::new(&controlled, &Sheets::default()).judge(&profile, &a, &b, 1e-11)
        };
        let shallow = judge(gap + 1e-6);
        prop_assert!(!matches!(shallow, Verdict::Proved { .. }), "{} {:?}", gap, shallow);
        // What lies between the points and places that are looked at is deeper by less.
        let deep = judge(1.02 * gap - 0.003);
        prop_assert!(matches!(deep, Verdict::Proved { .. }), "{} {:?}", gap, deep);
    }
}
