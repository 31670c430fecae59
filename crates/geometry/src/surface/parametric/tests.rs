//! Ruled surfaces and polyconics that are cones and cylinders.

use proptest::prelude::*;

use super::*;
use crate::{Circle, Cone, Cylinder, Form, Polyconic, Rail, Second, Surface};

/// The arc of a circle about z at height `z` over the chord between two angles.
fn arc(radius: f64, z: f64, from: f64, to: f64) -> Rail {
    let circle = Circle { center: Vec3::zeros(), axis: Vec3::z(), radius };
    let at =
        |a: f64| Vec3::new(radius * crate::trig::cos_deg(a), radius * crate::trig::sin_deg(a), z);
    let toward = at(0.5 * (from + to)) - Vec3::new(0.0, 0.0, z);
    Rail { surface: Arc::new(Form::Circle(circle)), start: at(from), end: at(to), toward }
}

fn surface(first: Rail, second: Second) -> Surface {
    let form = Form::Ruled(Arc::new(RuledSurface { first, second }));
    Surface::from_form(&form).expect("both curves are found")
}

/// Radius 2 at z = 0, radius 4 at z = 5: a cone with its vertex at z = -5.
fn cone() -> Surface {
    let cos_half = 5.0 / 29.0_f64.sqrt();
    Surface::Cone(Cone { vertex: Vec3::new(0.0, 0.0, -5.0), axis: Vec3::z(), cos_half })
}

/// A polyconic whose sections are quarter circles of radius 1 + d about the x axis, x from 2 to 12.
fn quarter(root: bool) -> (Surface, Surface) {
    let mut e = [0.0; 79];
    e[0] = 1.0;
    (e[14], e[15]) = (2.0, 10.0);
    let w = std::f64::consts::FRAC_1_SQRT_2;
    for (k, sign) in [(16, -1.0), (24, 1.0), (48, 1.0)] {
        e[k] = sign;
        // Radius 1 + d, or 1 + sqrt d.
        if root { e[72 + (k - 16) / 8] = sign } else { e[k + 1] = sign }
    }
    e[64] = 0.5 + 0.5 * w / (1.0 + w);
    let form = Form::Polyconic(Arc::new(Polyconic::from_canonical(&e)));
    let cos_half = 10.0 / 101.0_f64.sqrt();
    let cone = Cone { vertex: Vec3::new(-8.0, 0.0, 0.0), axis: Vec3::x(), cos_half };
    (Surface::from_form(&form).expect("conics throughout"), Surface::Cone(cone))
}

fn alike(a: &Surface, b: &Surface, p: Vec3) {
    let (f, g) = (a.foot(p), b.foot(p));
    assert!((f.point - g.point).norm() < 1e-9, "{p:?} {f:?} {g:?}");
    assert!((f.distance.abs() - g.distance.abs()).abs() < 1e-10);
    assert!(f.normal.cross(&g.normal).norm() < 1e-8);
    let side = f.normal.dot(&g.normal).signum();
    for v in [Vec3::x(), Vec3::y(), Vec3::z(), Vec3::new(0.6, -0.8, 0.3)] {
        let (k, l) = (f.shape.second(v), side * g.shape.second(v));
        assert!((k - l).abs() < 1e-5, "{v:?} {k} {l}");
    }
}

fn polar(r: f64, angle_deg: f64, z: f64) -> Vec3 {
    Vec3::new(r * crate::trig::cos_deg(angle_deg), r * crate::trig::sin_deg(angle_deg), z)
}

proptest! {
    #[test]
    fn rulings_between_two_arcs_are_a_cone(
        r in 0.5_f64..6.0, a in 20.0_f64..70.0, z in 0.5_f64..4.5,
    ) {
        let ruled = surface(arc(2.0, 0.0, 0.0, 90.0), Second::Rail(arc(4.0, 5.0, 0.0, 90.0)));
        alike(&ruled, &cone(), polar(r, a, z));
        let apex = surface(arc(4.0, 5.0, 0.0, 90.0), Second::Apex(Vec3::new(0.0, 0.0, -5.0)));
        alike(&apex, &cone(), polar(r, a, z));
    }

    #[test]
    fn close_to_the_surface_the_foot_is_as_exact(
        a in 20.0_f64..70.0, z in 0.5_f64..4.5, off in -0.05_f64..0.05,
    ) {
        let ruled = surface(arc(2.0, 0.0, 0.0, 90.0), Second::Rail(arc(4.0, 5.0, 0.0, 90.0)));
        alike(&ruled, &cone(), polar(2.0 + 0.4 * z + off, a, z));
    }

    #[test]
    fn what_lies_close_by_is_told_by_a_place(
        a in 20.0_f64..70.0, z in 0.5_f64..4.5, way in prop::array::uniform2(-1.0_f64..1.0),
    ) {
        let ruled = surface(arc(2.0, 0.0, 0.0, 90.0), Second::Rail(arc(4.0, 5.0, 10.0, 80.0)));
        let (place, sides) = ruled.place_with_sides(ruled.foot(polar(2.0 + 0.4 * z, a, z)).spot());
        for size in [1e-3, 1e-5] {
            let by = (place.shape.frame[0] * way[0] + place.shape.frame[1] * way[1]) * size;
            let told = ruled.close_by(&place, sides, by).expect("a smooth surface");
            let is = ruled.place(told.spot());
            prop_assert!((told.point - is.point).norm() < 3.0 * size.powi(2), "{told:?} {is:?}");
            // Across the surface to the third power.
            let across = (told.point - is.point).dot(&is.normal);
            prop_assert!(across.abs() < 2.0 * size.powi(3) + 1e-13, "{across} {told:?} {is:?}");
            prop_assert!((told.normal - is.normal).norm() < 2.0 * size.powi(2) + 1e-11);
        }
    }

    #[test]
    fn half_a_cylinder_is_smooth_up_to_its_ends(
        r in 0.5_f64..6.0, a in 0.5_f64..179.5, z in 0.0_f64..5.0,
    ) {
        let ruled = surface(arc(3.0, 0.0, 0.0, 180.0), Second::Rail(arc(3.0, 5.0, 0.0, 180.0)));
        let round = Cylinder { point: Vec3::zeros(), axis: Vec3::z(), radius: 3.0 };
        alike(&ruled, &Surface::Cylinder(round), polar(r, a, z));
    }

    #[test]
    fn round_sections_are_a_cone(r in 0.4_f64..4.0, a in 10.0_f64..80.0, x in 3.0_f64..11.0) {
        let (sections, cone) = quarter(false);
        let p = polar(r, a, 0.0);
        alike(&sections, &cone, Vec3::new(x, p.x, p.y));
    }

    #[test]
    fn the_signed_distance_has_the_normal_as_gradient(
        r in 1.5_f64..4.0, a in 10.0_f64..80.0, x in 2.2_f64..11.0,
    ) {
        let (sections, _) = quarter(true);
        let p = polar(r, a, 0.0);
        let p = Vec3::new(x, p.x, p.y);
        let foot = sections.foot(p);
        prop_assume!(!foot.shape.k[0].is_infinite());
        let h = 1e-4;
        for d in [Vec3::x(), Vec3::y(), Vec3::z()] {
            let slope = (sections.distance(p + d * h) - sections.distance(p - d * h)) / (2.0 * h);
            prop_assert!((slope - foot.normal.dot(&d)).abs() < 1e-4, "{slope} {:?}", foot.normal);
        }
    }

    #[test]
    fn rays_meet_where_they_meet_the_cone(a in 20.0_f64..70.0, z in 0.5_f64..4.5, lean in -0.5_f64..0.5) {
        let ruled = surface(arc(2.0, 0.0, 0.0, 90.0), Second::Rail(arc(4.0, 5.0, 0.0, 90.0)));
        let (p, d) = (polar(9.0, a, z), (polar(-1.0, a, lean)).normalize());
        let first = cone().ray(p, d).expect("it is met")[0];
        let hits = ruled.ray(p, d).expect("it is met");
        prop_assert!(hits.iter().any(|h| (h - first).abs() < 1e-9), "{hits:?} {first}");
    }
}

#[test]
fn beyond_the_straight_ends_the_border_is_nearest() {
    let ruled = surface(arc(2.0, 0.0, 0.0, 90.0), Second::Rail(arc(2.0, 5.0, 0.0, 90.0)));
    // The tangent at the end runs on along -y from (2, 0).
    let foot = ruled.foot(Vec3::new(3.0, -0.5, 1.0));
    assert!((foot.point - Vec3::new(2.0, -0.5, 1.0)).norm() < 1e-9, "{foot:?}");
    let foot = ruled.foot(Vec3::new(3.0, -50.0, 1.0));
    assert!(foot.shape.k[0].is_infinite(), "{foot:?}");
    assert!((foot.point + foot.normal * foot.distance - Vec3::new(3.0, -50.0, 1.0)).norm() < 1e-9);
}

/// Three by three points of a bowl z = (x x + y y) / 20 as a mesh, and the same as two rows of patches.
#[test]
fn a_sculptured_surface_has_feet_and_goes_on_straight() {
    use crate::sculptured::{MeshSpacing, SurfaceDefinition};
    let place = |x: f64, y: f64| Vec3::new(x, y, (x * x + y * y) / 20.0);
    let spline = |y: f64| [-4.0, 0.0, 4.0].map(|x| place(x, y)).to_vec();
    let definition = SurfaceDefinition::mesh(MeshSpacing::Xyz, [-4.0, 0.0, 4.0].map(spline));
    let fitted = crate::sculpt::fit_surface(&definition).unwrap();
    let s = Surface::from_form(&Form::Ssurf(Arc::new(definition))).unwrap();
    for k in 0..40 {
        let f = f64::from(k);
        let p = Vec3::new(
            3.0 * crate::trig::sin(f),
            3.5 * crate::trig::cos(1.7 * f),
            1.0 + crate::trig::sin(0.6 * f),
        );
        let foot = s.foot(p);
        let near = crate::sculpt::nearest_on(&fitted, p);
        assert!((foot.distance.abs() - near.distance).abs() < 1e-9, "{k}");
        assert!((foot.normal.cross(&(p - foot.point))).norm() < 1e-7);
        assert!(foot.normal.z > 0.0);
    }
    // Beyond the border along the tangent there.
    let end = fitted.at(2.0, 1.0);
    let out = end.point + end.u * 0.5;
    assert!(s.distance(out).abs() < 1e-9);
    let hit = s.directed_distance(out + Vec3::z(), -Vec3::z(), crate::Fiop::Ahead).unwrap();
    assert!((hit.distance - 1.0).abs() < 1e-9);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn a_part_turns_and_bends_no_more_than_is_told(
        radii in prop::array::uniform2(50.0_f64..200.0), lift in -30.0_f64..30.0,
        center in prop::array::uniform3(-1.0_f64..1.0), radius in 2.0_f64..15.0, up in -8.0_f64..8.0,
        places in prop::collection::vec(prop::array::uniform2(-1.0_f64..1.0), 40),
    ) {
        let over = |y: f64, lift: f64, radius: f64| {
            let center = Vec3::new(0.0, y, lift - radius);
            let circle = Circle { center, axis: Vec3::y(), radius };
            let z = lift + ((radius - 45.0) * (radius + 45.0)).sqrt() - radius;
            let end = |x: f64| Vec3::new(x, y, z);
            Rail { surface: Arc::new(Form::Circle(circle)), start: end(-45.0), end: end(45.0), toward: Vec3::z() }
        };
        let Surface::Parametric(surface) =
            surface(over(-40.0, 0.0, radii[0]), Second::Rail(over(40.0, lift, radii[1]))) else { unreachable!("ruled") };
        let middle = Vec3::new(40.0 * center[0], 30.0 * center[1], 0.0);
        let foot = surface.foot(middle);
        let at = foot.at.expect("two parameters");
        let ball = (foot.point + foot.normal * up, radius);
        let from = (foot.point + foot.normal * 4.0, 2.0);
        let Some(part) = surface.part(&[ball], from, at) else { return Ok(()) };
        let mut within = Vec::new();
        for [du, dv] in places {
            let (u, v) = (at[0] + 0.4 * du, at[1] + 0.4 * dv);
            let place = surface.place([u, v]);
            if (place.point - ball.0).norm() <= ball.1 {
                prop_assert!((place.normal - foot.normal).norm() <= part.turn + 1e-9);
                let [most, least] = place.shape.principal();
                prop_assert!(part.curvature[0] <= least + 1e-9 && most <= part.curvature[1] + 1e-9);
                within.push([u, v]);
            }
        }
        // From wherever in the part, downhill leads to one place.
        let p = from.0 + Vec3::new(center[1], center[2], center[0]) * (from.1 / 3.0_f64.sqrt());
        let nearest = surface.foot(p);
        for at in within {
            let found = surface.foot_from(p, at);
            prop_assert!((found.point - nearest.point).norm() < 1e-6, "{found:?} {nearest:?}");
        }
    }
}
