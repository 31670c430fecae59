//! Surfaces that tests share.

use std::sync::Arc;

use aptc_geometry::sculptured::{MeshSpacing, SurfaceDefinition};
use aptc_geometry::{Circle, Form, Rail, RuledSurface, Second, Surface, Vec3, trig};

/// Rulings along y between arcs over x from -45 to 45, domes or hollows.
pub(crate) fn rulings(radii: [f64; 2], lift: f64) -> Surface {
    let rail = |y: f64, lift: f64, radius: f64| {
        let (sign, radius) = (radius.signum(), radius.abs());
        let center = Vec3::new(0.0, y, lift - sign * radius);
        let circle = Circle { center, axis: Vec3::y(), radius };
        let z = lift + sign * (((radius - 45.0) * (radius + 45.0)).sqrt() - radius);
        let end = |x: f64| Vec3::new(x, y, z);
        let surface = Arc::new(Form::Circle(circle));
        Rail { surface, start: end(-45.0), end: end(45.0), toward: Vec3::z() * sign }
    };
    let second = Second::Rail(rail(40.0, lift, radii[1]));
    let first = rail(-40.0, 0.0, radii[0]);
    Surface::from_form(&Form::Ruled(Arc::new(RuledSurface { first, second }))).expect("a surface")
}

/// A mesh over the same with waves and uneven spans.
pub(crate) fn mesh(waves: [f64; 2], lift: f64, uneven: f64) -> Surface {
    let stretch = |t: f64| t + uneven * trig::sin(3.0 * t) / 3.0;
    let row = |j: i32| {
        let at = |i: i32| {
            let (s, t) = (f64::from(i) / 4.0 - 1.0, f64::from(j) / 3.0 - 1.0);
            let (x, y) = (45.0 * stretch(s), 40.0 * stretch(t));
            let z = waves[0] * trig::sin(4.0 * s + t) + waves[1] * trig::cos(3.0 * t - s);
            Vec3::new(x, y, lift * t + z)
        };
        (0..9).map(at).collect()
    };
    let definition = SurfaceDefinition::mesh(MeshSpacing::Xyz, (0..7).map(row));
    Surface::from_form(&Form::Ssurf(Arc::new(definition))).expect("a surface")
}
