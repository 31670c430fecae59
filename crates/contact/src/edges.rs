//! A cutter against edges and tips of a surface, where it touches with a normal between those of the sides.

use aptc_geometry::surface::{Edge, OnEdge, ParametricSurface};
use aptc_geometry::{Surface, Tool, ToolNear, Vec3};

use crate::closed::is_axis;
use crate::corners::Corner;
use crate::gap::{Gap, Side};

/// Parts of an edge that are looked at for a least distance each, and the share of the slopes at its ends that is none.
const PARTS: u8 = 12;
const EVEN: f64 = 1e-14;
/// First step from a place of an edge to one that is least beside it, and by how much the next are longer.
const STEP: f64 = 1e-4;
const FASTER: f64 = 8.0;
/// Sine by which what leads into the surface may come nearer to the tool.
const LEVEL: f64 = 1e-9;
/// Share of the tool's size below which the place of contact is found with the edge moved back, and rounds of that and of other
/// searches.
const CLOSE: f64 = 1e-6;
const ROUNDS: u32 = 60;
/// Share of the tool's size by which a place may lie off an edge.
const ON: f64 = 1e-6;

/// What all edges of a surface tell.
pub(crate) struct Edges {
    /// The deepest place at which one touches.
    pub(crate) deepest: Option<Gap>,
    /// No place of them is nearer to the tool.
    pub(crate) least: f64,
}

/// An edge or a tip, its places told by a number.
pub(crate) trait Sharp {
    /// Calls `take` for each place, with all of it moved `by`, at which the tool is nearest, with its distance.
    fn each_least(&self, tool: &Tool<'_>, by: Vec3, take: &mut dyn FnMut(f64, f64));

    /// The one of these places to which the way leads from the place `t`.
    fn least_beside(&self, tool: &Tool<'_>, by: Vec3, t: f64) -> f64;

    /// A place of it.
    fn place(&self, t: f64) -> Option<OnEdge>;

    /// Do all unit directions from a place into the surface?
    fn all_inwards(&self, t: f64, does: &dyn Fn(Vec3) -> bool) -> bool;
}

/// Has a surface edges that a tool may touch otherwise than its faces? What stands along all of them rolls about them as about a face.
pub(crate) fn has_edges(tool: &Tool<'_>, surface: &Surface) -> bool {
    match surface {
        Surface::Parametric(s) => !s.edges().is_empty(),
        Surface::Tabcyl(s) => s.has_corners() && !is_axis(tool, s.generator()),
        _ => false,
    }
}

/// Is there a corner of a TABCYL between two places of it?
pub(crate) fn comes_over_corner(surface: &Surface, [from, to]: [Option<[f64; 2]>; 2]) -> bool {
    let (Surface::Tabcyl(s), Some(from), Some(to)) = (surface, from, to) else { return false };
    s.has_corner_between(from[0], to[0])
}

/// The edges of a surface that may come nearer than `limit`, but for the place of them that is `known`; `None` of one that has none.
pub(crate) fn all(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    limit: f64,
    known: Option<&Gap>,
) -> Option<Edges> {
    if !has_edges(tool, surface) {
        return None;
    }
    let same = ON * tool.profile.reach();
    let mut all = Edges { deepest: None, least: f64::INFINITY };
    let look = |edge: &dyn Sharp, all: &mut Edges| {
        edge.each_least(tool, Vec3::zeros(), &mut |t, distance| {
            let place = edge.place(t).map(|p| p.point);
            let is_known = |k: &Gap| place.is_some_and(|p| (p - k.surface_point).norm() <= same);
            if known.is_some_and(is_known) {
                return;
            }
            all.least = all.least.min(distance);
            if all.deepest.is_none_or(|gap| distance < gap.raw) {
                all.deepest = touching(tool, surface, side, edge, t).or(all.deepest);
            }
        });
    };
    match surface {
        Surface::Parametric(s) => {
            for edge in s.edges() {
                let bound = tool.distance(edge.center) - edge.radius;
                let deepest = all.deepest.map_or(f64::INFINITY, |gap| gap.raw);
                if bound > limit || bound > deepest && bound > all.least {
                    continue;
                }
                look(&Joint { surface: s, edge }, &mut all);
            }
        }
        Surface::Tabcyl(s) => {
            let top = tool.te + tool.ta * tool.profile.height();
            let reach = limit + tool.profile.widest();
            for corner in s.corners_near(tool.te, top, reach) {
                look(&Corner { corner, along: s.generator() }, &mut all);
            }
        }
        _ => {}
    }
    Some(all)
}

/// The place at which an edge touches on which the point `q` lies; `None` where it lies on none, and where that does not touch.
pub(crate) fn at(tool: &Tool<'_>, surface: &Surface, side: Side, q: Vec3) -> Option<Gap> {
    if !has_edges(tool, surface) {
        return None;
    }
    let near = ON * tool.profile.reach();
    let mut best: Option<Gap> = None;
    let mut look = |edge: &dyn Sharp| {
        edge.each_least(tool, Vec3::zeros(), &mut |t, distance| {
            if best.is_none_or(|gap| distance < gap.raw) {
                best = touching(tool, surface, side, edge, t).or(best);
            }
        });
    };
    match surface {
        Surface::Parametric(s) => {
            for edge in s.edges().iter().filter(|e| (e.center - q).norm() <= e.radius + near) {
                if passes(s, edge, q, near) {
                    look(&Joint { surface: s, edge });
                }
            }
        }
        Surface::Tabcyl(s) => {
            let along = s.generator();
            let away = |p: Vec3| (q - p - along * along.dot(&(q - p))).norm();
            for corner in s.corners_near(q, q, near).filter(|c| away(c.point) <= near) {
                look(&Corner { corner, along });
            }
        }
        _ => {}
    }
    best
}

/// An edge or a tip of a sculptured surface.
struct Joint<'a> {
    surface: &'a ParametricSurface,
    edge: &'a Edge,
}

impl Joint<'_> {
    /// Distance of the tool from the place `t` of the edge moved `by`, and its slope.
    fn value(&self, tool: &Tool<'_>, by: Vec3, t: f64) -> Option<(f64, f64)> {
        let [point, along] = self.surface.line_on_edge(self.edge, t)?;
        let near = tool.near(point + by);
        Some((near.distance, near.normal.dot(&along)))
    }
}

impl Sharp for Joint<'_> {
    fn each_least(&self, tool: &Tool<'_>, by: Vec3, take: &mut dyn FnMut(f64, f64)) {
        if self.edge.is_tip() {
            take(0.0, tool.distance(self.edge.center + by));
            return;
        }
        least(&|t| self.value(tool, by, t), take);
    }

    fn least_beside(&self, tool: &Tool<'_>, by: Vec3, t: f64) -> f64 {
        let line = self.surface.line_on_edge(self.edge, t);
        let size = line.map_or(0.0, |[_, along]| along.norm());
        let found = || beside(&|t| self.value(tool, by, t), size, t);
        if self.edge.is_tip() { 0.0 } else { found().unwrap_or(t) }
    }

    fn place(&self, t: f64) -> Option<OnEdge> {
        self.surface.on_edge(self.edge, t)
    }

    fn all_inwards(&self, t: f64, does: &dyn Fn(Vec3) -> bool) -> bool {
        self.surface.inwards_of(self.edge, t, does)
    }
}

/// Does an edge pass within `near` of a point?
fn passes(surface: &ParametricSurface, edge: &Edge, q: Vec3, near: f64) -> bool {
    if edge.is_tip() {
        return true;
    }
    let mut found = false;
    let away = |t: f64| {
        let [point, along] = surface.line_on_edge(edge, t)?;
        Some(((point - q).norm(), (point - q).dot(&along)))
    };
    least(&away, &mut |_, distance| found |= distance <= near);
    found
}

/// Value and slope at a place of an edge.
type Sloped<'a> = dyn Fn(f64) -> Option<(f64, f64)> + 'a;

/// The places of an edge at which a value is least.
fn least(at: &Sloped<'_>, take: &mut dyn FnMut(f64, f64)) {
    let part = |i: u8| f64::from(i) / f64::from(PARTS);
    let Some(mut before) = at(0.0) else { return };
    if before.1 >= 0.0 {
        take(0.0, before.0);
    }
    for i in 1..=PARTS {
        let Some(now) = at(part(i)) else { return };
        if before.1 < 0.0 && now.1 >= 0.0 {
            let size = before.1.abs().max(now.1.abs());
            let (t, value) = between(at, size, (part(i - 1), before), (part(i), now));
            take(t, value);
        }
        before = now;
    }
    if before.1 < 0.0 {
        take(1.0, before.0);
    }
}

/// The place at which a value is least next to `t`, downhill, its slopes being of that `size`.
fn beside(at: &Sloped<'_>, size: f64, t: f64) -> Option<f64> {
    let mut last = (t, at(t)?);
    let way = if last.1.1 < 0.0 { 1.0 } else { -1.0 };
    let mut step = STEP;
    loop {
        let to = (last.0 + way * step).clamp(0.0, 1.0);
        let next = (to, at(to)?);
        if next.1.1 * way >= 0.0 {
            let [low, high] = if way > 0.0 { [last, next] } else { [next, last] };
            return Some(between(at, size, low, high).0);
        }
        if to <= 0.0 || to >= 1.0 {
            return Some(to);
        }
        (last, step) = (next, FASTER * step);
    }
}

/// A place between two, with their values and slopes that fall and rise, at which the value is least, and that; the slopes are of
/// the `size`.
fn between(
    at: &Sloped<'_>,
    size: f64,
    (a, begin): (f64, (f64, f64)),
    (b, end): (f64, (f64, f64)),
) -> (f64, f64) {
    let (mut low, mut high) = ((a, begin.1), (b, end.1));
    let mut best = (b, end.0);
    for round in 0..ROUNDS {
        // The zero of the chord of the slopes, and every third time the middle.
        let chord = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
        let inside = chord > low.0 && chord < high.0 && round % 3 != 2;
        let t = if inside { chord } else { 0.5 * (low.0 + high.0) };
        let Some((distance, slope)) = at(t) else { break };
        if distance < best.1 {
            best = (t, distance);
        }
        *(if slope < 0.0 { &mut low } else { &mut high }) = (t, slope);
        if slope.abs() <= EVEN * size || high.0 - low.0 <= f64::EPSILON {
            best = (t, distance);
            break;
        }
    }
    best
}

/// The gap at a place of an edge, where the surface falls off to all sides of it.
fn touching(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    edge: &dyn Sharp,
    t: f64,
) -> Option<Gap> {
    let place = edge.place(t)?;
    let near = tool.near(place.point);
    let touches = |t: f64, place: &OnEdge, near: &ToolNear, raw: f64| {
        let normal = -near.normal;
        // Through a body an edge on its far side is seen from inside.
        let before = || raw <= 0.0 || side.sign() * surface.foot(near.point).distance >= 0.0;
        let faces = normal.dot(&place.mean) * side.sign() > 0.0 && before();
        let falls = |into: Vec3| near.normal.dot(&into) >= -LEVEL;
        (faces && edge.all_inwards(t, &falls)).then_some(Gap {
            g: raw,
            raw,
            tool_point: near.point,
            surface_point: place.point,
            at: Some(place.at),
            normal,
            segment: Some(near.segment),
            residual: 0.0,
        })
    };
    let size = tool.profile.widest().max(0.1 * tool.profile.reach());
    if near.distance > CLOSE * size {
        return touches(t, &place, &near, near.distance);
    }
    // At the tool's own edges its normal is anything where they touch: with the edge moved away from the tool it is one.
    let back = 0.25 * size + 2.0 * (-near.distance).max(0.0);
    let mut normal = (place.mean * side.sign()).try_normalize(0.0)?;
    let mut at = t;
    for _ in 0..ROUNDS {
        let by = -normal * back;
        at = edge.least_beside(tool, by, at);
        let place = edge.place(at)?;
        let near = tool.near(place.point + by);
        let turned = (near.normal + normal).norm();
        normal = -near.normal;
        if turned <= LEVEL {
            return touches(at, &place, &near, near.distance - back);
        }
    }
    None
}
