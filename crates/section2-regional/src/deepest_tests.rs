//! Depths of gouges against closed forms.

use std::sync::Arc;

use aptc_contact::{PatchTree, Tool};
use aptc_geometry::sculpt::{SplinePoint, mesh};
use aptc_geometry::sculptured::MeshSpacing;
use aptc_geometry::{
    Circle, Cutter, Form, Profile, Rail, RuledSurface, Second, Sphere, Vec3, trig,
};

use crate::guard::{Checked, Gouge, Guard};
use crate::plain::Plain;

/// Upright rulings along a quarter of a circle of that radius about the z axis, from -20 up to 80: a wall.
fn wall(radius: f64) -> Plain {
    let arc = |z: f64| {
        let center = Vec3::z() * z;
        let circle = Circle { center, axis: Vec3::z(), radius };
        let at = |x: f64, y: f64| center + Vec3::new(x, y, 0.0) * radius;
        let surface = Arc::new(Form::Circle(circle));
        Rail { surface, start: at(1.0, 0.0), end: at(0.0, 1.0), toward: Vec3::new(1.0, 1.0, 0.0) }
    };
    let ruled = RuledSurface { first: arc(-20.0), second: Second::Rail(arc(80.0)) };
    Plain::new("K".into(), &Arc::new(Form::Ruled(Arc::new(ruled)))).unwrap()
}

/// The gouge of a way, with its deepest place.
fn gouge(profile: &Profile, ends: [(Vec3, Vec3); 2]) -> Option<Gouge> {
    let guard = Guard { plain: vec![wall(40.0)], intol: 0.01, ..Guard::default() };
    let found = guard.way(profile, ends).err()?;
    Some(guard.deepest(profile, ends, found))
}

/// A place at that distance from the z axis, half way round the quarter.
fn beside(rho: f64) -> Vec3 {
    Vec3::new(rho, rho, 0.0) * 0.5_f64.sqrt()
}

#[test]
fn a_wall_is_as_deep_in_the_cutter_as_it_is_nearer_than_the_radius() {
    // A wall across a tall cutter is deepest where it is nearest to the axis: there it is in by the radius less that.
    for (corner, rho) in
        [(0.0, 36.0), (5.0, 36.0), (0.0, 39.9), (5.0, 43.0), (1.0, 44.9), (1.5, 40.0)]
    {
        let profile = Profile::new(&Cutter::mill(10.0, corner, 50.0)).unwrap();
        let at = (beside(rho), Vec3::z());
        let found = gouge(&profile, [at, at]).unwrap();
        let deep = 5.0 - (40.0_f64 - rho).abs();
        assert!(
            (found.depth - deep).abs() < 1e-3 * deep,
            "{corner} {rho}: {} not {deep}",
            found.depth
        );
        let stood = found.stood.unwrap();
        let place = stood.place;
        assert!((trig::hypot(place.x, place.y) - 40.0).abs() < 1e-6, "{place}");
        assert!((stood.te, stood.ta) == at);
    }
    let profile = Profile::new(&Cutter::mill(10.0, 0.0, 50.0)).unwrap();
    for rho in [34.9, 45.1] {
        let at = (beside(rho), Vec3::z());
        assert_eq!(gouge(&profile, [at, at]), None, "{rho}");
    }
}

#[test]
fn on_a_way_it_is_told_where_the_tool_is_deepest() {
    // Past the wall along a tangent at the distance 43 from the axis: deepest where it touches, in by 2.
    let profile = Profile::new(&Cutter::mill(10.0, 5.0, 50.0)).unwrap();
    let along = Vec3::new(-1.0, 1.0, 0.0) * 0.5_f64.sqrt();
    let ends = [-9.0, 15.0].map(|s| (beside(43.0) + along * s, Vec3::z()));
    let found = gouge(&profile, ends).unwrap();
    assert!((found.depth - 2.0).abs() < 2e-3, "{}", found.depth);
    let stood = found.stood.unwrap();
    assert!((stood.te - beside(43.0)).norm() < 0.3, "{}", stood.te);
    // Coming out of it: deepest where it begins.
    let ends = [41.0, 60.0].map(|rho| (beside(rho), Vec3::z()));
    let found = gouge(&profile, ends).unwrap();
    // Right through the wall on its way it would be in by the radius.
    assert!((found.depth - 4.0).abs() < 4e-3, "{}", found.depth);
    assert!((found.stood.unwrap().te - ends[0].0).norm() < 0.01);
    // Through it with a turning axis, which stands upright at the end.
    let lean = Vec3::new(0.02, 0.01, 1.0).normalize();
    let ends = [(beside(60.0), lean), (beside(42.0), Vec3::z())];
    let found = gouge(&profile, ends).unwrap();
    assert!((found.depth - 3.0).abs() < 3e-3, "{}", found.depth);
    let stood = found.stood.unwrap();
    assert!((stood.te - ends[1].0).norm() < 0.01 && (stood.ta - Vec3::z()).norm() < 1e-3);
}

/// Of shank and holder the one that is deeper is told, not the first that touches.
#[test]
fn of_the_solids_of_a_holder_the_deepest_is_told() {
    let solid = |d: f64, from: f64, to: f64| {
        (Profile::new(&Cutter::mill(d, 0.0, to - from)).unwrap(), from)
    };
    let ball = Sphere { center: Vec3::new(22.0, 0.0, 45.0), radius: 20.0 };
    let plain = vec![Plain::new("K".into(), &Arc::new(Form::Sphere(ball))).unwrap()];
    let holder = vec![solid(8.0, 30.0, 50.0), solid(40.0, 50.0, 70.0)];
    let guard = Guard { plain, holder, intol: 0.01, ..Guard::default() };
    let profile = Profile::new(&Cutter::mill(6.0, 3.0, 25.0)).unwrap();
    let at = [(Vec3::zeros(), Vec3::z()); 2];
    let found = guard.way(&profile, at).unwrap_err();
    assert!((found.depth - 2.0).abs() < 1e-6, "the shank: {}", found.depth);
    let found = guard.deepest(&profile, at, found);
    let deep = 20.0 - 29.0_f64.sqrt();
    assert!((found.depth - deep).abs() < 1e-3, "{} not {deep}", found.depth);
}

#[test]
fn nothing_is_told_deeper_than_the_tool_is_wide() {
    // A foot of the surface far from the tool is no measure: neither above the wall, nor beyond its ends, nor aslant.
    let mut told = 0;
    for i in 0..60 {
        let turn = f64::from(i) * 2.399_963;
        let (rho, lean) = (30.0 + f64::from(i % 7) * 3.0, 0.05 * f64::from(i % 9));
        let ta = Vec3::new(lean * trig::cos(turn), lean * trig::sin(turn), 1.0).normalize();
        let te =
            Vec3::new(rho * trig::cos(turn), rho * trig::sin(turn), f64::from(i % 5) * 22.0 - 40.0);
        let profile = Profile::new(&Cutter::mill(10.0, 2.5 * f64::from(i % 3), 50.0)).unwrap();
        let by = Vec3::new(trig::sin(turn), 0.3, 0.2) * f64::from(i % 4);
        if let Some(found) = gouge(&profile, [(te, ta), (te + by, ta)]) {
            assert!(found.depth > 0.01 && found.depth <= 5.0 + 1e-9, "{i}: {}", found.depth);
            told += 1;
        }
    }
    assert!(told > 15, "{told}");
}

/// Of a tool that turns it is told how deep the place is where the tool is told to stand.
#[test]
fn a_turning_tool_is_as_deep_as_the_place_that_is_told() {
    let row = |z: f64| {
        let at = |i| SplinePoint::plain(Vec3::new(10.0, 30.0 * f64::from(i) - 30.0, z));
        (0..3).map(at).collect()
    };
    let surface = Arc::new(mesh(&[row(-10.0), row(60.0)], MeshSpacing::Ruled).unwrap());
    let tree = Arc::new(PatchTree::new(&surface));
    let name = "WALL".into();
    let (thick, own, body) = (0.0, None, None);
    let checked = Checked { name, surface, tree, part: false, thick, own, facets: false, body };
    let guard = Guard { surfaces: vec![checked], intol: 0.01, ..Guard::default() };
    let profile = Profile::new(&Cutter::mill(8.0, 4.0, 50.0)).unwrap();
    let mut told = 0;
    for i in 0..40 {
        let lean = |deg: f64| Vec3::new(trig::sin_deg(deg), 0.0, trig::cos_deg(deg));
        let (from, to) = (f64::from(i % 8) * 2.0, 14.0 - f64::from(i % 5) * 3.5);
        let way = Vec3::new(f64::from(i % 3) - 1.0, 9.0, 4.0);
        let ends = [(Vec3::zeros(), lean(from)), (way, lean(to))];
        let Err(found) = guard.way(&profile, ends) else { continue };
        let found = guard.deepest(&profile, ends, found);
        let stood = found.stood.unwrap();
        let tool = Tool { profile: &profile, te: stood.te, ta: stood.ta };
        let real = -tool.distance(stood.place);
        assert!((stood.place.x - 10.0).abs() < 1e-9 && real > 0.01);
        assert!((found.depth - real).abs() < 1e-9, "{i}: {} not {real}", found.depth);
        told += 1;
    }
    assert!(told > 15, "{told}");
}
