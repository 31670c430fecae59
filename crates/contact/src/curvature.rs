//! Second derivatives of the gap by the tool end, for predicting steps.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Shape, Surface, Tool};

use crate::gap::{Gap, Side};
use crate::open;

/// Second derivatives of the gap when the tool moves without turning, at a gap found by
/// [`crate::gap()`] or [`crate::on()`]: `g(te + v) = g + n.v + second(v)/2 + ...`.
///
/// The tool ends at which the gap has one value make a surface whose radii of curvature are those of the
/// surface, of the tool and the gap added up as 2x2 matrices: its inverse is returned. Positive on domes,
/// negative in hollows; `None` where a hollow is exactly as tight as the tool.
#[inline]
pub fn second(tool: &Tool<'_>, surface: &Surface, side: Side, gap: &Gap) -> Option<Shape> {
    let outward = gap.normal * side.sign();
    let shape = match side {
        Side::Open => open::shape(surface, tool.ta, gap.spot(), outward),
        _ => surface.shape_at(gap.spot(), outward),
    };
    let shape = if side == Side::Positive { shape } else { shape.reversed() };
    let Some(segment) = gap.segment else { return shape.offset(gap.raw) };

    let n = gap.normal;
    let up = -n.dot(&tool.ta);
    let radial = -n - tool.ta * up;
    let across = radial.norm();
    if across <= 1e-12 {
        // The tool's end faces the surface: on the axis its curvature is the same all round.
        let r = match segment {
            Segment::Arc if tool.profile.is_round() => tool.profile.corner_radius(),
            Segment::Tip => 0.0,
            _ => f64::INFINITY,
        };
        return relative(shape, [r, r], gap.raw);
    }
    let out = radial / across;
    let along = match segment {
        Segment::Arc => tool.profile.corner_radius(),
        Segment::LowerLine | Segment::UpperLine | Segment::Top => f64::INFINITY,
        _ => 0.0,
    };
    let w = gap.tool_point - tool.te;
    let rho = (w - tool.ta * w.dot(&tool.ta)).norm();
    let around = match segment {
        Segment::Arc => along + tool.profile.corner()[0] / across,
        Segment::Top => f64::INFINITY,
        Segment::Tip => 0.0,
        _ => rho / across,
    };
    let frame = [tool.ta * across - out * up, tool.ta.cross(&out)];
    relative(shape.in_frame(frame), [along, around], gap.raw)
}

/// `(1/K + diag(radii) + g)^-1` with K of the surface in the same frame; both may be singular.
#[inline]
pub(crate) fn relative(shape: Shape, radii: [f64; 2], g: f64) -> Option<Shape> {
    let frame = shape.frame;
    let [a1, a2] = [radii[0] + g, radii[1] + g];
    let inverse = |a: f64| if a.is_infinite() { 0.0 } else { 1.0 / a };
    let [k11, k12, k22] = shape.k;
    if k11.is_infinite() || k22.is_infinite() {
        // A vertex: only the tool and the gap have radii.
        return (a1 != 0.0 && a2 != 0.0)
            .then(|| Shape { frame, k: [inverse(a1), 0.0, inverse(a2)] });
    }
    let d = k11 * k22 - k12 * k12;
    let only = |across: f64, along: f64, a: f64| {
        // One radius infinite: what is left in the other direction, a its radius.
        let straight = across.abs().max(k12.abs()) <= 1e-12 * along.abs();
        let free = if straight || across == 0.0 && k12 == 0.0 { along } else { d / across };
        let h = if free.is_infinite() { inverse(a) } else { free / (1.0 + a * free) };
        if a.is_infinite() { 0.0 } else { h }
    };
    let k = match (a1.is_infinite(), a2.is_infinite()) {
        (true, true) => [0.0; 3],
        (true, false) => [0.0, 0.0, only(k11, k22, a2)],
        (false, true) => [only(k22, k11, a1), 0.0, 0.0],
        (false, false) => {
            let (p, r) = (1.0 + a1 * k11, 1.0 + a2 * k22);
            let det = p * r - a1 * a2 * k12 * k12;
            if det.abs() <= 1e-14 * (1.0 + (p * r).abs()) {
                return None;
            }
            [(k11 + a2 * d) / det, k12 / det, (k22 + a1 * d) / det]
        }
    };
    k.iter().all(|k| k.is_finite()).then_some(Shape { frame, k })
}
