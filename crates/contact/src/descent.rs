//! The normal pair near a place of a surface, where no closed form exists.
//!
//! The tool's distance is minimised over the surface moved away from the tool by a depth `back`: that
//! changes no normal pair, and keeps the tool's distance smooth through sharp edges and through contact.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Foot, Reason, Shape, Spot, Surface, Tool, Vec3};

use crate::edges;
use crate::even;
use crate::gap::{Gap, Side};

/// Bound of one local search. Newton's method takes 3 to 8 steps; the rest is for places where the surface
/// is as tight as the tool.
const MAX_STEPS: usize = 60;
/// A normal pair is accepted when the normals differ by less than this sine. The gap is then exact to its
/// square.
const FACING: f64 = 1e-12;
/// The same on a straight line of the cutter: along a ruling the gap falls by so much of its length to the end.
const FACING_ON_LINE: f64 = 1e-12;
/// Sine up to which the normals may differ where rounding stops a search.
const LEVEL: f64 = 1e-7;

/// The normal pair into which the surface point `q` runs downhill.
pub(crate) fn local(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    q: Spot,
) -> Result<Gap, Reason> {
    let size = tool.profile.widest().max(0.1 * tool.profile.reach());
    let mut foot = surface.place(q);
    let mut back = 0.25 * size + 2.0 * (-tool.distance(foot.point)).max(0.0);
    let mut failure = Reason::NotConverged { best: q.point, residual: f64::INFINITY };
    // A tool deeper in than the surface was moved back is met again with the surface farther back.
    for _ in 0..4 {
        // The moved surface must not pass a centre of curvature.
        let shape = if side == Side::Positive { foot.shape } else { foot.shape.reversed() };
        let tight = shape.principal()[0].max(0.0);
        let most = if tight.is_finite() { 0.7 / tight.max(1e-300) } else { 0.0 };
        let begin = at(tool, &foot, side, back.min(most));
        let (here, border) = descend(tool, surface, side, begin, back.min(most));
        let w = here.tool_point - here.q.point;
        let raw = w.dot(&here.normal);
        let residual = (w - here.normal * raw).norm();
        if here.facing > 0.0 && here.across.norm() <= LEVEL {
            let gap = Gap {
                g: raw,
                raw,
                tool_point: here.tool_point,
                surface_point: here.q.point,
                at: here.q.at,
                normal: here.normal,
                segment: Some(here.segment),
                residual,
            };
            return Ok(even::end(tool, surface, side, &gap, &here.own).unwrap_or(gap));
        }
        if let Some(gap) = edges::at(tool, surface, side, here.q.point) {
            return Ok(gap);
        }
        failure = Reason::NotConverged { best: here.q.point, residual };
        foot = surface.place(here.q);
        if border {
            return Err(Reason::OutOfDomain);
        }
        if back >= most {
            break;
        }
        back = 2.0 * back + 2.0 * (-here.value).max(0.0);
    }
    Err(failure)
}

/// A place of the search.
struct At {
    /// Foot on the surface.
    q: Spot,
    normal: Vec3,
    /// Surface moved back.
    x: Vec3,
    /// Distance of the tool from it.
    value: f64,
    /// Part of the tool's normal across the surface's.
    across: Vec3,
    tool_point: Vec3,
    segment: Segment,
    bend: Shape,
    /// Cosine between the tool's normal and the surface's reversed.
    facing: f64,
    shape: Option<Shape>,
    /// The same of the surface itself.
    own: Shape,
    /// Its derivatives by its two parameters, when they are known.
    sides: Option<[Vec3; 2]>,
}

fn at(tool: &Tool<'_>, foot: &Foot, side: Side, back: f64) -> At {
    let normal = foot.normal * side.sign();
    let shape = if side == Side::Positive { foot.shape } else { foot.shape.reversed() };
    let x = foot.point - normal * back;
    let near = tool.near(x);
    let facing = -near.normal.dot(&normal);
    At {
        q: foot.spot(),
        normal,
        x,
        value: near.distance,
        across: near.normal + normal * facing,
        tool_point: near.point,
        segment: near.segment,
        bend: near.shape,
        facing,
        shape: shape.offset(-back),
        own: shape,
        sides: None,
    }
}

/// Newton's method downhill on the surface moved `back`, from one place to the next; and whether it was
/// stopped by the border of the surface or at a place without a tangent plane.
fn descend(tool: &Tool<'_>, surface: &Surface, side: Side, start: At, back: f64) -> (At, bool) {
    let size = tool.profile.widest().max(0.1 * tool.profile.reach());
    let mut here = start;
    let mut border = false;
    let mut cap = size;
    for _ in 0..MAX_STEPS {
        let slope = here.across.norm();
        let line = matches!(here.segment, Segment::LowerLine | Segment::UpperLine);
        if here.facing > 0.0 && slope <= if line { FACING_ON_LINE } else { FACING } {
            break;
        }
        let d = step(&here, cap);
        let (foot, sides) = match beside(surface, &here, d, back) {
            Some(found) => found,
            None => (surface.foot_from(here.x + d, here.q), None),
        };
        border = foot.shape.k[0].is_infinite();
        let next = At { sides, ..at(tool, &foot, side, back) };
        // Close to the end the values agree to rounding, and the slope tells.
        let lower = next.value < here.value - 1e-14 * size;
        let flatter = next.value <= here.value + 1e-13 * size && next.across.norm() < 0.7 * slope;
        if lower || flatter && next.facing > 0.0 {
            cap = (2.0 * cap).min(size);
            here = next;
            continue;
        }
        cap = 0.35 * d.norm().min(cap);
        // The lowest place of a tool that stands on the other side: rounding alone is left, and no pair to be found.
        let turned = here.facing <= 0.0 && slope <= LEVEL;
        if turned || cap <= 1e-14 * size {
            break;
        }
    }
    (here, border)
}

/// The place to which the moved surface's tangent step `d` leads, where the surface has one without a search for a
/// nearest point: the surface itself goes by as much less or more as it bends.
fn beside(surface: &Surface, here: &At, d: Vec3, back: f64) -> Option<(Foot, Option<[Vec3; 2]>)> {
    if here.q.at.is_none() && !matches!(surface, Surface::Quadric(_)) {
        return None;
    }
    let [k11, k12, k22] = here.own.k;
    if !(k11.is_finite() && k22.is_finite()) {
        return None;
    }
    let [u, v] = here.own.frame;
    let (a, b, c) = (1.0 - back * k11, -back * k12, 1.0 - back * k22);
    let (p, q, det) = (d.dot(&u), d.dot(&v), a * c - b * b);
    let by = u * ((c * p - b * q) / det) + v * ((a * q - b * p) / det);
    if by.iter().all(|x| x.is_finite()) { surface.beside(here.q, here.sides, by) } else { None }
}

/// Newton's step in the tangent plane, with the signs of the curvatures made positive; no longer than `cap`.
fn step(here: &At, cap: f64) -> Vec3 {
    let [u, v] = aptc_geometry::surface::frame_about(here.normal);
    let g = [here.across.dot(&u), here.across.dot(&v)];
    let mut h = [here.bend.second(u), 0.0, here.bend.second(v)];
    h[1] = 0.5 * (here.bend.second(u + v) - h[0] - h[2]);
    if let Some(shape) = &here.shape {
        let k = [shape.second(u), shape.second(v), shape.second(u + v)];
        h[0] += here.facing * k[0];
        h[2] += here.facing * k[1];
        h[1] += here.facing * 0.5 * (k[2] - k[0] - k[1]);
    }
    let (mean, half) = (0.5 * (h[0] + h[2]), 0.5 * (h[0] - h[2]));
    let root = (half * half + h[1] * h[1]).sqrt();
    let (w1, w2) = (mean + root, mean - root);
    let top = w1.abs().max(w2.abs());
    let d = if !top.is_finite() || top <= 0.0 {
        [-g[0] * cap, -g[1] * cap]
    } else {
        // Eigenvector of w1.
        let (p, q) = if half >= 0.0 { (half + root, h[1]) } else { (h[1], root - half) };
        let s = aptc_geometry::trig::hypot(p, q);
        let (p, q) = if s > 0.0 { (p / s, q / s) } else { (1.0, 0.0) };
        let (a, b) = (p * g[0] + q * g[1], p * g[1] - q * g[0]);
        // Along a flank that lies nearly along a ruling the gap falls evenly, by little, to its end.
        let floor = 1e-9 * top;
        let (a, b) = (-a / w1.abs().max(floor), -b / w2.abs().max(floor));
        [p * a - q * b, q * a + p * b]
    };
    let d = u * d[0] + v * d[1];
    let length = d.norm();
    if length > cap { d * (cap / length) } else { d }
}
