//! Random scenes.

use aptc_geometry::surface::{QuadricSurface, TabcylSurface};
use aptc_geometry::{
    Cone, Cutter, Cylinder, Fit, Knot, Plane, Quadric, QuadricKind, Sphere, Surface, Tabcyl, Vec2,
    Vec3, trig,
};
use proptest::prelude::*;
use std::sync::Arc;

/// So many cases, of which no file is left.
pub(crate) fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

/// Cutters of all shapes, about 4 to 12 wide.
pub(crate) fn cutter() -> impl Strategy<Value = Cutter> {
    (0_usize..7, 4.0_f64..12.0, 0.05_f64..0.95, 0.0_f64..1.0, 0.0_f64..1.0).prop_map(
        |(kind, d, share, x, y)| {
            let r = 0.5 * d * share;
            let height = 1.2 * d + 10.0 * x;
            let lines = |alpha_deg: f64, beta_deg: f64, r: f64| {
                let (ca, sa) = (trig::cos_deg(alpha_deg), trig::sin_deg(alpha_deg));
                let (cb, sb) = (trig::cos_deg(beta_deg), trig::sin_deg(beta_deg));
                let rhs = r - cb * d / 2.0 + sb * d / 2.0 * sa / ca;
                let det = ca * cb - sa * sb;
                let (e, f) = ((r * sb - ca * rhs) / det, (cb * r - sa * rhs) / det);
                Cutter { diameter: d, corner_radius: r, e, f, alpha_deg, beta_deg, height }
            };
            match kind {
                0 => Cutter::mill(d, d / 2.0, height),
                1 => Cutter::mill(d, 0.0, height),
                2 => Cutter::mill(d, r, height),
                3 => lines(25.0 * x, 15.0 * y, 0.3 * r),
                4 => lines(5.0 + 30.0 * x, 0.0, 0.0),
                5 => Cutter { f: 0.7 * r, ..Cutter::mill(d, r, height) },
                _ => lines(0.0, 30.0 * y, 0.3 * r),
            }
        },
    )
}

/// A unit vector.
pub(crate) fn direction() -> impl Strategy<Value = Vec3> {
    (-1.0_f64..1.0, -1.0_f64..1.0, -1.0_f64..1.0)
        .prop_map(|(x, y, z)| Vec3::new(x, y, z))
        .prop_filter("not too short", |v| v.norm() > 0.1)
        .prop_map(|v| v.normalize())
}

/// Tool axes, the plain ones often.
pub(crate) fn axis() -> impl Strategy<Value = Vec3> {
    prop_oneof![Just(Vec3::z()), Just(Vec3::x()), direction()]
}

/// Plane, sphere, cylinder, cone.
pub(crate) fn simple() -> impl Strategy<Value = Surface> {
    (0_usize..4, axis(), 15.0_f64..40.0, 20.0_f64..70.0, -5.0_f64..5.0).prop_map(
        |(kind, n, radius, angle, x)| {
            let point = Vec3::new(x, -0.5 * x, 0.3 * x);
            match kind {
                0 => Surface::Plane(Plane { n, d: x }),
                1 => Surface::Sphere(Sphere { center: point, radius }),
                2 => Surface::Cylinder(Cylinder { point, axis: n, radius }),
                _ => Surface::Cone(Cone { vertex: point, axis: n, cos_half: trig::cos_deg(angle) }),
            }
        },
    )
}

/// Waves over a line, the generatrix along z or oblique.
pub(crate) fn tabcyl() -> impl Strategy<Value = Surface> {
    (prop::collection::vec(-4.0_f64..4.0, 19..21), axis(), any::<bool>()).prop_filter_map(
        "a curve",
        |(y, w, spline)| {
            let knots: Vec<Knot> = y
                .iter()
                .enumerate()
                .map(|(i, y)| Knot { point: Vec2::new(i as f64 * 12.0 - 110.0, *y), tangent: None })
                .collect();
            let fit = if spline { Fit::Spline } else { Fit::TwoPoint };
            let [u, v] = aptc_geometry::surface::frame_about(w);
            let axes = nalgebra::Matrix3::from_rows(&[u.transpose(), v.transpose(), w.transpose()]);
            let form = Arc::new(Tabcyl::fit(&knots, fit, axes, 10.0).ok()?);
            TabcylSurface::new(&form).map(|s| Surface::Tabcyl(Arc::new(s)))
        },
    )
}

pub(crate) fn quadric_of(c: [f64; 10]) -> Surface {
    let form = Quadric { kind: QuadricKind::Qadric, c };
    Surface::Quadric(Arc::new(QuadricSurface::new(&form).expect("a quadric")))
}

/// Ellipsoids, saddles, hyperboloids, elliptic and hyperbolic cylinders, paraboloids.
pub(crate) fn quadric() -> impl Strategy<Value = Surface> {
    (0_usize..6, 15.0_f64..40.0, 15.0_f64..40.0, 15.0_f64..40.0, -4.0_f64..4.0).prop_map(
        |(kind, a, b, c, x)| {
            let (p, q, r) = (1.0 / (a * a), 1.0 / (b * b), 1.0 / (c * c));
            match kind {
                0 => quadric_of([p, q, r, -1.0, 0.0, 0.0, 0.0, p * x, 0.0, 0.0]),
                1 => quadric_of([p, q, -r, -1.0, 0.0, 0.0, 0.0, p * x, 0.0, 0.0]),
                2 => quadric_of([0.0, 0.0, 0.0, x, 0.0, 0.0, -0.5 / a, 0.0, 0.0, 0.5]),
                3 => quadric_of([p, q, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, q * x, 0.0]),
                4 => quadric_of([0.0, p, -r, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
                _ => quadric_of([1.0 / a, 1.0 / b, 0.0, x, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5]),
            }
        },
    )
}
