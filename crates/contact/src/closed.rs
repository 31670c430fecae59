//! Closed forms: plane, sphere, and whatever runs straight along the tool axis.

use aptc_geometry::{Plane, Sphere, Spot, Surface, Tool, Vec3};

use crate::gap::{Gap, Side};

/// The tool point is the extreme one against the normal.
#[inline]
pub(crate) fn plane(tool: &Tool<'_>, plane: &Plane, side: Side) -> Gap {
    let s = side.sign();
    let normal = plane.n * s;
    let p = tool.support(-normal);
    let g = -p.reach - s * plane.d;
    Gap {
        g,
        raw: g,
        tool_point: p.point,
        surface_point: p.point - normal * g,
        at: None,
        normal,
        segment: Some(p.segment),
        residual: 0.0,
    }
}

/// Outside: the tool's distance from the centre. Inside: how far the tool reaches from the centre, which
/// may be at its top edge.
#[inline]
pub(crate) fn sphere(tool: &Tool<'_>, sphere: &Sphere, side: Side) -> Gap {
    let (point, away, raw, segment) = match side {
        Side::Positive => {
            let near = tool.near(sphere.center);
            (near.point, -near.normal, near.distance - sphere.radius, near.segment)
        }
        Side::Negative | Side::Open => {
            let far = if side == Side::Open {
                tool.farthest_below(sphere.center)
            } else {
                tool.farthest(sphere.center)
            };
            (far.point, far.direction, sphere.radius - far.distance, far.segment)
        }
    };
    Gap {
        g: raw,
        raw,
        tool_point: point,
        surface_point: match side {
            Side::Open => point + away * raw,
            _ => sphere.center + away * sphere.radius,
        },
        at: None,
        normal: away * side.sign(),
        segment: Some(segment),
        residual: 0.0,
    }
}

/// The tool axis runs along the generator: seen along it the tool is a circle of its greatest radius, and
/// the surface a curve whose nearest point to the axis is known, sooner from a place near it.
#[inline]
pub(crate) fn along_axis(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    near: Option<Spot>,
) -> Gap {
    let foot = match near {
        Some(near) => surface.foot_from(tool.te, near),
        None => surface.foot(tool.te),
    };
    let s = side.sign();
    let normal = foot.normal * s;
    let raw = s * foot.distance - tool.profile.widest();
    let p = tool.support(-normal);
    Gap {
        g: raw,
        raw,
        tool_point: p.point,
        surface_point: p.point - normal * raw,
        at: foot.at,
        normal,
        segment: Some(p.segment),
        residual: 0.0,
    }
}

/// Is `d` the direction of the tool axis or its opposite?
#[inline]
pub(crate) fn is_axis(tool: &Tool<'_>, d: Vec3) -> bool {
    d.cross(&tool.ta).norm_squared() <= 1e-24
}
