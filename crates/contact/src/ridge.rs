//! Where the disk of a corner's middles can touch a ridge: a part of a surface that bends one way, and hardly another.
//!
//! On a surface that bends both ways at each place, as one of rulings does, the least distance on the lines across a ridge
//! bends down along it, so that it is least at its ends: where the ridge leaves the disk.

use aptc_geometry::surface::frame_about;
use aptc_geometry::{Spot, Surface, Tool, Vec3};

use crate::gap::{Gap, Side};

/// Share of the disk's radius by which a ridge may pass beside the disk and still have a place on its border.
const BESIDE: f64 = 0.2;

/// The places of the surface below the ends of the ridge through the `known` place of contact; `None` where no ridge is.
pub(crate) fn ends(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
) -> Option<[Option<Spot>; 2]> {
    let ([rho, high], radius) = (tool.profile.corner(), tool.profile.corner_radius());
    let shape = surface.place(known.spot()).shape;
    let shape = if side.sign() > 0.0 { shape } else { shape.reversed() };
    let shape = shape.offset(known.raw + radius)?;
    let [a, b] = frame_about(tool.ta);
    // The second derivatives of the distance in the plane of the disk.
    let [x, y] = [a, b].map(|e| shape.apply(e));
    let (h11, h12, h22) = (a.dot(&x), a.dot(&y), b.dot(&y));
    let (mean, half) = (0.5 * (h11 + h22), 0.5 * (h11 - h22));
    let root = aptc_geometry::trig::hypot(half, h12);
    let most = mean + root;
    let across =
        if half >= 0.0 { a * (half + root) + b * h12 } else { a * h12 + b * (root - half) };
    let across = across.try_normalize(0.0).filter(|_| most > 0.0)?;
    let along = tool.ta.cross(&across);
    let center = tool.te + tool.ta * high;
    let middle = known.tool_point + known.normal * radius - center;
    // The distance falls towards the ridge, on which it changes along it alone.
    let off = middle.dot(&across) - known.normal.dot(&across) / most;
    if off.abs() > (1.0 + BESIDE) * rho {
        return Some([None; 2]);
    }
    let room = ((rho - off) * (rho + off)).max(0.0).sqrt();
    let at = |v: Vec3| surface.foot_from(center + v, known.spot()).spot();
    let off = across * off.clamp(-rho, rho);
    let second = (room > 0.0).then(|| at(off - along * room));
    Some([Some(at(off + along * room)), second])
}
