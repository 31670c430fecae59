//! Hollows that count as open along the tool axis: the hollow with all that lies above it, seen along the
//! axis.
//!
//! The tangent planes of such a hollow are those whose outward normal does not look up the axis. Beyond the
//! outline that the hollow shows along the axis the wall runs on straight up.

use aptc_geometry::surface::frame_about;
use aptc_geometry::{Cone, Cylinder, Foot, Shape, Spot, Surface, Vec3};

/// Cosine with the axis below which a normal counts as square to it.
const LEVEL: f64 = 1e-12;

/// The nearest place of the opened hollow's wall.
pub(crate) fn cylinder(s: &Cylinder, ta: Vec3, p: Vec3) -> Foot {
    let foot = s.foot(p);
    if foot.normal.dot(&ta) <= 0.0 {
        return foot;
    }
    // Two planes along the cylinder and up.
    let side = s.axis.cross(&ta);
    let normal = side * (s.radial(p).dot(&side).signum() / side.norm());
    straight(p, normal, s.radial(p).dot(&normal) - s.radius)
}

/// The nearest place of the opened hollow's wall.
pub(crate) fn cone(s: &Cone, ta: Vec3, p: Vec3) -> Foot {
    let foot = s.foot(p);
    let Some(planes) = outline(s, ta) else { return foot };
    if foot.normal.dot(&ta) <= 0.0 {
        return foot;
    }
    let w = p - s.vertex;
    let [a, b] = planes.map(|n| n.dot(&w));
    let (normal, distance) = if a > b { (planes[0], a) } else { (planes[1], b) };
    straight(p, normal, distance)
}

/// Curvature of the opened hollow's wall where its outward normal is `n`.
pub(crate) fn shape(surface: &Surface, ta: Vec3, spot: Spot, n: Vec3) -> Shape {
    let q = spot.point;
    if n.dot(&ta) < -LEVEL {
        return surface.shape_at(spot, n);
    }
    match surface {
        Surface::Quadric(s) => s.opened(ta).map_or(Shape::flat(n), |open| open.shape_at(q, n)),
        Surface::Sphere(s) => Shape { frame: [ta, ta.cross(&n)], k: [0.0, 0.0, 1.0 / s.radius] },
        _ => Shape::flat(n),
    }
}

/// The outward normals of the cone that are square to the axis `ta`; `None` when there are none.
fn outline(s: &Cone, ta: Vec3) -> Option<[Vec3; 2]> {
    let (cos, sin) = (s.cos_half, s.sin_half());
    let along = s.axis.dot(&ta);
    let across = ta - s.axis * along;
    let size = across.norm();
    // The normals are cos e - sin axis, e square to the axis.
    let share = sin * along / (cos * size);
    if share.is_nan() || share.abs() >= 1.0 - LEVEL {
        return None;
    }
    let e = across / size;
    let side = s.axis.cross(&e) * ((1.0 - share) * (1.0 + share)).sqrt();
    Some([side, -side].map(|side| (e * share + side) * cos - s.axis * sin))
}

fn straight(p: Vec3, normal: Vec3, distance: f64) -> Foot {
    let shape = Shape { frame: frame_about(normal), k: [0.0; 3] };
    Foot { point: p - normal * distance, normal, distance, shape, at: None }
}
