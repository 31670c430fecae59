//! Cylinder and cone: surfaces whose tangent planes are a family of one parameter.
//!
//! With m the unit normal against which the tool leans and p(m) its extreme point that way, the tool clears
//! the tangent plane by `m . (V - p(m))` up to the radius. Outside it clears the solid by the greatest of
//! these clearances, also when it cuts in. Inside, the wall is nearest to an edge or the arc of the tool.

use aptc_geometry::surface::{frame_about, vertex_side};
use aptc_geometry::{Cone, Cylinder, Foot, Reason, Tool, ToolSupport, Vec3};

use crate::closed::is_axis;
use crate::gap::{Gap, Side};
use crate::open;
use crate::rings::{self, COS16, Wall};

/// Bound of each one-parameter search; bisection alone would need 53 steps.
const MAX_STEPS: usize = 80;
/// How much farther than the tangents of a sharp peak say the next place lies beyond it.
const BEYOND: f64 = 4.0;

/// Gap to a cylinder.
#[inline]
pub(crate) fn cylinder(tool: &Tool<'_>, s: &Cylinder, side: Side) -> Result<Gap, Reason> {
    let t = s.axis;
    if is_axis(tool, t) {
        let w = s.radial(tool.te);
        let rho = w.norm();
        let out = if rho > 0.0 { w / rho } else { frame_about(t)[0] };
        let (m, raw) = match side {
            Side::Positive => (-out, rho - s.radius - tool.profile.widest()),
            Side::Negative | Side::Open => (out, s.radius - rho - tool.profile.widest()),
        };
        return Ok(made(tool.support(m), m, raw, 0.0));
    }
    if t.dot(&tool.ta).abs() <= 1e-12 {
        return Ok(square(tool, s, side));
    }
    match side {
        Side::Positive => Ok(oblique_outside(tool, s)),
        Side::Negative => rings::within(tool, Bore { s, up: None }),
        Side::Open => rings::within(tool, Bore::open(s, tool.ta)),
    }
}

/// The inside of a cylinder, open upwards or not.
struct Bore<'a> {
    s: &'a Cylinder,
    /// Where it is open, and square to its walls there.
    up: Option<[Vec3; 2]>,
}

impl<'a> Bore<'a> {
    fn open(s: &'a Cylinder, up: Vec3) -> Self {
        Self { s, up: Some([up, s.axis.cross(&up).normalize()]) }
    }

    /// The distance of a point that is `w` from the axis.
    #[inline]
    fn away(&self, w: Vec3) -> f64 {
        let away = match self.up {
            Some([up, side]) if w.dot(&up) > 0.0 => w.dot(&side).abs(),
            _ => w.norm(),
        };
        away - self.s.radius
    }
}

impl Wall for Bore<'_> {
    fn foot(&self, p: Vec3) -> Foot {
        self.up.map_or_else(|| self.s.foot(p), |[up, _]| open::cylinder(self.s, up, p))
    }

    fn distance(&self, p: Vec3) -> f64 {
        self.away(self.s.radial(p))
    }

    /// Seen along the axis the circle is an ellipse.
    fn around(&self, center: Vec3, spokes: [Vec3; 2]) -> [f64; 16] {
        let t = self.s.axis;
        let middle = self.s.radial(center);
        let spokes = spokes.map(|v| v - t * t.dot(&v));
        std::array::from_fn(|k| self.away(middle + rings::at16(spokes, k)))
    }
}

/// Seen along a cylinder square to the tool axis the tool is its own profile.
#[inline]
fn square(tool: &Tool<'_>, s: &Cylinder, side: Side) -> Gap {
    let w = s.radial(tool.te);
    let b = s.axis.cross(&tool.ta);
    let x = w.dot(&b);
    let z = -w.dot(&tool.ta);
    // Away from the tool axis, towards the cylinder's.
    let out = if x > 0.0 { -b } else { b };
    let place = |v: [f64; 2], sign: f64| out * (sign * v[0]) + tool.ta * v[1];
    let (point, away, raw, segment) = match side {
        Side::Positive => {
            let n = tool.profile.near(x.abs(), z);
            (place(n.point, 1.0), -place(n.normal, 1.0), n.distance - s.radius, n.segment)
        }
        Side::Negative | Side::Open => {
            let f = if side == Side::Open {
                tool.profile.farthest_below(x.abs(), z)
            } else {
                tool.profile.farthest(x.abs(), z)
            };
            (place(f.point, -1.0), place(f.direction, -1.0), s.radius - f.distance, f.segment)
        }
    };
    let normal = away * side.sign();
    let tool_point = tool.te + point;
    Gap {
        g: raw,
        raw,
        tool_point,
        surface_point: tool_point - normal * raw,
        at: None,
        normal,
        segment: Some(segment),
        residual: 0.0,
    }
}

/// The tool's distance from the axis: a convex function of the place on the axis.
pub(crate) fn oblique_outside(tool: &Tool<'_>, s: &Cylinder) -> Gap {
    let t = s.axis;
    let base = t.dot(&s.point);
    let mut hi = tool.support(t).reach - base;
    let mut lo = -tool.support(-t).reach - base;
    let slack = 1e-12 * (hi - lo);
    (lo, hi) = (lo - slack, hi + slack);
    let center = tool.te + tool.ta * tool.profile.corner()[1];
    let mut x = (t.dot(&center) - base).clamp(lo, hi);
    let mut last = hi - lo;
    // Values and slopes at the ends of the bracket, once they are known.
    let mut below: Option<(f64, f64)> = None;
    let mut above: Option<(f64, f64)> = None;
    let mut near = tool.near(s.point + t * x);
    for _ in 0..MAX_STEPS {
        let slope = near.normal.dot(&t);
        if slope.abs() <= 1e-13 {
            break;
        }
        if slope > 0.0 {
            (hi, above) = (x, Some((near.distance, slope)));
        } else {
            (lo, below) = (x, Some((near.distance, slope)));
        }
        let bend = near.shape.second(t);
        let step = -slope / bend;
        let newton = x + step;
        let next = if bend > 0.0 && newton > lo && newton < hi && step.abs() < 0.5 * last {
            last = step.abs();
            newton
        } else {
            last = hi - lo;
            match (below, above) {
                (Some((f, a)), Some((g, b))) => {
                    let cut = (f - g + b * hi - a * lo) / (b - a);
                    let margin = 0.05 * (hi - lo);
                    cut.clamp(lo + margin, hi - margin)
                }
                _ => 0.5 * (lo + hi),
            }
        };
        if next <= lo || next >= hi || (next - x).abs() <= 1e-15 * (x.abs() + s.radius) {
            break;
        }
        x = next;
        near = tool.near(s.point + t * x);
    }
    let slope = near.normal.dot(&t);
    let away = (-near.normal + t * slope).normalize();
    let raw = near.distance - s.radius;
    Gap {
        g: raw,
        raw,
        tool_point: near.point,
        surface_point: near.point - away * raw,
        at: None,
        normal: away,
        segment: Some(near.segment),
        residual: slope.abs() * near.distance.abs(),
    }
}

/// Gap to a cone, its vertex included.
#[inline]
pub(crate) fn cone(tool: &Tool<'_>, s: &Cone, side: Side) -> Result<Gap, Reason> {
    let (a, b) = (s.cos_half, -s.sin_half());
    let sense = -side.sign();
    let family = Family { tool, v: s.vertex, t: s.axis, a, b, sense };
    let at = if is_axis(tool, s.axis) {
        let w = tool.te - s.vertex;
        let w = w - s.axis * w.dot(&s.axis);
        let rho = w.norm();
        let out = if rho > 0.0 { w / rho } else { frame_about(s.axis)[0] };
        family.at(out)
    } else if side == Side::Positive {
        family.greatest()
    } else if side == Side::Open {
        let foot = |p| open::cone(s, tool.ta, p);
        return rings::within(tool, foot);
    } else {
        return rings::within(tool, |p| s.foot(p));
    };
    if side == Side::Positive {
        let w = at.p.point - s.vertex;
        let t = w.dot(&s.axis);
        let (along, _) = vertex_side(t, (w - s.axis * t).norm(), a, -b);
        if along < tool.profile.reach() {
            let near = tool.near(s.vertex);
            // The vertex touches when the normal lies in its cone of normals; the greatest clearance of all
            // planes through the vertex counts.
            if near.distance >= at.value && near.normal.dot(&s.axis) >= -b {
                return Ok(Gap {
                    g: near.distance,
                    raw: near.distance,
                    tool_point: near.point,
                    surface_point: s.vertex,
                    at: None,
                    normal: -near.normal,
                    segment: Some(near.segment),
                    residual: 0.0,
                });
            }
        }
    }
    Ok(at.gap())
}

fn made(p: ToolSupport, m: Vec3, raw: f64, residual: f64) -> Gap {
    Gap {
        g: raw,
        raw,
        tool_point: p.point,
        surface_point: p.point + m * raw,
        at: None,
        normal: -m,
        segment: Some(p.segment),
        residual,
    }
}

/// The tangent planes `m(e) = sense (a e + b t)` through `v`, e unit across t.
struct Family<'a, 'b> {
    tool: &'a Tool<'b>,
    v: Vec3,
    t: Vec3,
    a: f64,
    b: f64,
    /// -1 outside, +1 inside.
    sense: f64,
}

/// The clearance at one plane of the family.
#[derive(Clone, Copy)]
struct At {
    e: Vec3,
    m: Vec3,
    p: ToolSupport,
    value: f64,
    slope: f64,
    bend: f64,
}

impl At {
    fn gap(&self) -> Gap {
        made(self.p, self.m, self.value, self.slope.abs())
    }
}

impl Family<'_, '_> {
    #[inline]
    fn at(&self, e: Vec3) -> At {
        let turn = self.t.cross(&e);
        let m = (e * self.a + self.t * self.b) * self.sense;
        let p = self.tool.support(m);
        let w = self.v - p.point;
        let dm = turn * (self.a * self.sense);
        let term = |i: usize| {
            let c = dm.dot(&p.frame[i]);
            if c == 0.0 { 0.0 } else { p.radii[i] * c * c }
        };
        let bend = -self.sense * self.a * e.dot(&w) - (term(0) + term(1));
        At { e, m, p, value: m.dot(&w), slope: dm.dot(&w), bend }
    }

    /// Outside: the greatest clearance. Among all planes through the vertex that clear the cone it is
    /// unique, among the tangent ones it may have rivals: each sample higher than its neighbours is climbed
    /// from, and the plane that faces the tool seen from the vertex.
    fn greatest(&self) -> At {
        let [u, w] = frame_about(self.t);
        let all: [At; 8] =
            std::array::from_fn(|k| self.at(u * COS16[2 * k] + w * COS16[(2 * k + 12) % 16]));
        let facing = -self.tool.near(self.v).normal;
        let across = facing - self.t * facing.dot(&self.t);
        let size = across.norm();
        let start = if size > 1e-9 { self.at(across / size) } else { all[0] };
        let mut best = self.climb(&start);
        for i in 0..8 {
            let (before, here, after) = (&all[(i + 7) % 8], &all[i], &all[(i + 1) % 8]);
            if here.value >= before.value && here.value >= after.value {
                let found = self.climb(here);
                if found.value > best.value {
                    best = found;
                }
            }
        }
        best
    }

    /// The peak uphill from `start`. Where a face of the tool touches it is sharp, and the tool point is
    /// the place on the face between the extreme points of both slopes.
    fn climb(&self, start: &At) -> At {
        let e0 = start.e;
        let turn = self.t.cross(&e0);
        let place = |x: f64| self.at((e0 + turn * x).normalize());
        let (mut x, mut at) = (0.0_f64, *start);
        let (mut lo, mut hi) = ((x, at), (x, at));
        let uphill = at.slope.signum();
        let mut stride = 0.1;
        // At most 1.4 radians: beyond, another sample is nearer.
        while stride < 8.0 {
            if at.slope > 0.0 {
                lo = (x, at);
            } else {
                hi = (x, at);
            }
            if lo.1.slope > 0.0 && hi.1.slope <= 0.0 {
                break;
            }
            x = uphill * stride;
            at = place(x);
            stride *= 2.0;
        }
        let mut last = hi.0 - lo.0;
        // Which end of the bracket was brought nearer last, and how often one after another.
        let (mut below, mut times) = (false, 0);
        for _ in 0..MAX_STEPS {
            let size = (self.v - at.p.point).norm();
            if at.slope.abs() <= 1e-14 * size {
                return at;
            }
            let rising = at.slope > 0.0;
            times = if rising == below { times + 1 } else { 1 };
            below = rising;
            if rising {
                lo = (x, at);
            } else {
                hi = (x, at);
            }
            // The slope is by the angle, and dx = (1 + x^2) of it.
            let step = -at.slope / at.bend * (1.0 + x * x);
            let newton = x + step;
            let inside = newton > lo.0 && newton < hi.0;
            let next = if at.bend < 0.0 && inside && step.abs() < 0.5 * last {
                last = step.abs();
                newton
            } else {
                let width = hi.0 - lo.0;
                last = width;
                let by_x = |(x, at): &(f64, At)| at.slope / (1.0 + x * x);
                let (a, b) = (by_x(&lo), by_x(&hi));
                let cut = (lo.1.value - hi.1.value + b * hi.0 - a * lo.0) / (b - a);
                let middle = 0.5 * (lo.0 + hi.0);
                if !(cut.is_finite() && a > 0.0 && b < 0.0) {
                    middle
                } else if rising {
                    // Beside a sharp peak the tangents meet short of it, as the sides bend: a step beyond, farther each
                    // time, brings the other end near it too.
                    (cut + (cut - lo.0) * BEYOND.powi(times)).min(cut.max(middle))
                } else {
                    (cut - (hi.0 - cut) * BEYOND.powi(times)).max(cut.min(middle))
                }
            };
            let between = |x: f64| x > lo.0 && x < hi.0;
            x = if between(next) { next } else { 0.5 * (lo.0 + hi.0) };
            if hi.0 - lo.0 <= 1e-15 || !between(x) {
                break;
            }
            at = place(x);
        }
        at = if lo.1.value > hi.1.value { lo.1 } else { hi.1 };
        if lo.1.slope > 0.0 && hi.1.slope < 0.0 {
            let share = lo.1.slope / (lo.1.slope - hi.1.slope);
            at.p.point = lo.1.p.point + (hi.1.p.point - lo.1.p.point) * share;
            at.slope = 0.0;
            at.p.segment = self.tool.face(at.m);
        }
        at
    }
}
