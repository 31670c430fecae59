//! Rational B-spline surfaces that close on themselves against the closed forms of what they are, at their seams too.

use std::sync::Arc;

use aptc_contact::{Gap, Side, Tool, gap, gap_near};
use aptc_geometry::sculptured::{BsplineSurface, SurfaceDefinition, SurfaceShape};
use aptc_geometry::surface::ParametricSurface;
use aptc_geometry::{Cutter, Cylinder, Profile, Sphere, Surface, Vec3, trig};

const HALF: f64 = core::f64::consts::FRAC_1_SQRT_2;

/// All round the z axis, along u, for each distance from it, height and weight.
fn round(outline: &[[f64; 3]], degree: usize, knots: &[f64]) -> Surface {
    let ring = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]];
    let row = |&[r, z, w]: &[f64; 3]| {
        ring.iter().enumerate().map(move |(i, &[x, y])| {
            let corner = if i % 2 == 1 { HALF } else { 1.0 };
            [r * f64::from(x), r * f64::from(y), z, w * corner]
        })
    };
    let quarters = vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0];
    let surface = BsplineSurface {
        degree: [2, degree],
        knots: [quarters, knots.to_vec()],
        counts: [ring.len(), outline.len()],
        points: outline.iter().flat_map(row).collect(),
        range: [None; 2],
    };
    let shape = SurfaceShape::Bspline(Box::new(surface));
    let form = SurfaceDefinition { shape, map: None };
    Surface::Parametric(Arc::new(ParametricSurface::sculptured(&form).expect("a surface")))
}

fn tube() -> Surface {
    round(&[[30.0, 0.0, 1.0], [30.0, 40.0, 1.0]], 1, &[0.0, 0.0, 1.0, 1.0])
}

fn ball() -> Surface {
    let outline = [
        [0.0, -25.0, 1.0],
        [25.0, -25.0, HALF],
        [25.0, 0.0, 1.0],
        [25.0, 25.0, HALF],
        [0.0, 25.0, 1.0],
    ];
    round(&outline, 2, &[0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0])
}

/// Angles about the axis: at the seam, close to it on both sides, between patches, and elsewhere.
const ANGLES: [f64; 11] = [0.0, 1e-9, -1e-9, 1e-4, -1e-4, 1.0, 45.0, 90.0, 180.0, 270.0, 359.0];

fn each(mut with: impl FnMut(&Profile, f64)) {
    for [d, r] in [[8.0, 0.0], [8.0, 4.0], [8.0, 1.0], [0.0, 0.0]] {
        let profile = Profile::new(&Cutter::mill(d, r, 50.0)).expect("a mill");
        ANGLES.into_iter().for_each(|a| with(&profile, a));
    }
}

fn alike(got: Result<Gap, aptc_contact::Reason>, want: &Gap, what: &str) -> Gap {
    let got = got.unwrap_or_else(|why| panic!("{what}: {why:?}"));
    assert!((got.g - want.g).abs() < 1e-9, "{what}: {} and not {}", got.g, want.g);
    assert!((got.normal - want.normal).norm() < 1e-6, "{what}: {}", got.normal);
    got
}

/// The gaps of both at distances from the axis and heights, and from there round by some degrees, over the seam too.
fn has_the_gaps_of(own: &Surface, exact: &Surface, places: [[f64; 2]; 4]) {
    each(|profile, angle| {
        for [away, z] in places {
            let tool = |angle: f64| {
                let te = Vec3::new(away * trig::cos_deg(angle), away * trig::sin_deg(angle), z);
                Tool { profile, te, ta: Vec3::z() }
            };
            let want = |tool: &Tool| gap(tool, exact, Side::Positive, 0.0).expect("it faces");
            let what = format!("{angle} degrees, {away} away, {z} high, {:?}", profile.joints());
            let here = tool(angle);
            let found = alike(gap(&here, own, Side::Positive, 0.0), &want(&here), &what);
            for turn in [-5.0, 5.0] {
                let there = tool(angle + turn);
                let got = gap_near(&there, own, Side::Positive, 0.0, Some(found.spot()));
                alike(got, &want(&there), &format!("{what}, {turn} on"));
            }
        }
    });
}

#[test]
fn a_tube_has_the_gaps_of_its_cylinder() {
    let cylinder =
        Surface::Cylinder(Cylinder { point: Vec3::zeros(), axis: Vec3::z(), radius: 30.0 });
    let places = [[60.0, 10.0], [34.0, 10.0], [33.0, 20.0], [60.0, 39.0]];
    has_the_gaps_of(&tube(), &cylinder, places);
}

#[test]
fn a_ball_has_the_gaps_of_its_sphere() {
    let sphere = Surface::Sphere(Sphere { center: Vec3::zeros(), radius: 25.0 });
    let places = [[20.0, 30.0], [10.0, 25.0], [0.0, 26.0], [28.0, 15.0]];
    has_the_gaps_of(&ball(), &sphere, places);
}
