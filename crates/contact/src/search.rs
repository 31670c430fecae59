//! Normal pairs where no closed form exists.
//!
//! The tool's distance is minimised over the surface moved away from the tool by a depth `back`: that
//! changes no normal pair, and keeps the tool's distance smooth through sharp edges and through contact.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Foot, Reason, Shape, Spot, Surface, Tool, Vec3};

use crate::closed::{along_axis, is_axis};
use crate::gap::{Gap, Side};
use crate::{ring, rings};

/// Bound of one local search. Newton's method takes 3 to 8 steps; the rest is for places where the surface
/// is as tight as the tool.
const MAX_STEPS: usize = 60;
/// A normal pair is accepted when the normals differ by less than this sine. The gap is then exact to its
/// square.
const FACING: f64 = 1e-10;
/// The same on a straight line of the cutter: along a ruling the gap falls by so much of its length to the end.
const FACING_ON_LINE: f64 = 1e-12;
/// Sine up to which the normals may differ where rounding stops a search.
const LEVEL: f64 = 1e-7;
/// Stations around the tool from which a search without a start sets out.
const AROUND: usize = 12;

/// Gap to a surface without closed form.
pub(crate) fn general(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    start: Option<Spot>,
) -> Result<Gap, Reason> {
    if surface.generator().is_some_and(|d| is_axis(tool, d)) {
        return Ok(along_axis(tool, surface, side, start));
    }
    let far_is_convex = match side {
        Side::Positive => surface.convex(),
        Side::Negative | Side::Open => surface.concave(),
    };
    let round = round(tool, surface, side, start);
    if let Some(gap) = round
        && (far_is_convex || start.is_some())
    {
        return Ok(gap);
    }
    if let Some(gap) = start.and_then(|q| ring::beside(tool, surface, side, q)) {
        return Ok(gap);
    }
    if far_is_convex {
        // One dip: any start leads there.
        let q = start.unwrap_or_else(|| surface.foot(middle(tool)).spot());
        if let Ok(gap) = local(tool, surface, side, q) {
            return Ok(gap);
        }
    } else if let Some(q) = start
        && let Ok(gap) = local(tool, surface, side, q)
    {
        return Ok(gap);
    }
    if hollow(surface, side) {
        let foot = |p| turned(surface.foot(p), side);
        return rings::within(tool, foot, |p| foot(p).distance);
    }
    if let Some(gap) = round
        && !has_side(tool)
    {
        // Nothing but the arc can touch.
        return Ok(gap);
    }
    let stations = Stations { lower: round.is_none(), flank: true };
    let Seeds { found: seeds, deepest, .. } = seeds(tool, surface, side, stations);
    let mut best: Option<Gap> = round;
    let mut failure = Reason::NoHit;
    for q in seeds.into_iter().flatten() {
        match local(tool, surface, side, q) {
            Ok(gap) if best.is_none_or(|b| gap.raw < b.raw) => best = Some(gap),
            Ok(_) => {}
            Err(reason) => failure = reason,
        }
    }
    best.map(|gap| drowned(tool, surface, side, &gap, deepest).unwrap_or(gap)).ok_or(failure)
}

/// What a point of the tool tells that is deeper than a place of contact: where a shank goes through a sheet of a quadric
/// and beyond, no pair of points may face each other. Only quadrics have a form that tells the side of every point.
fn drowned(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
    (depth, point): (f64, Vec3),
) -> Option<Gap> {
    let size = tool.profile.reach() + known.raw.abs();
    let deeper = matches!(surface, Surface::Quadric(_)) && depth < known.raw - 1e-9 * size;
    deeper.then(|| {
        let foot = surface.foot(point);
        Gap {
            g: depth,
            raw: depth,
            tool_point: point,
            surface_point: foot.point,
            at: foot.at,
            normal: foot.normal * side.sign(),
            segment: None,
            residual: f64::INFINITY,
        }
    })
}

/// Is the tool within a convex hollow?
pub(crate) fn hollow(surface: &Surface, side: Side) -> bool {
    match side {
        Side::Positive => surface.concave(),
        Side::Negative | Side::Open => surface.convex(),
    }
}

/// May a search with a start miss a deeper place?
pub(crate) fn several(tool: &Tool<'_>, surface: &Surface, side: Side) -> bool {
    let closed = matches!(
        surface,
        Surface::Plane(_) | Surface::Sphere(_) | Surface::Cylinder(_) | Surface::Cone(_)
    );
    let (far, near) = (surface.convex(), surface.concave());
    let convex = if side == Side::Positive { far } else { near };
    !(closed || convex || surface.generator().is_some_and(|d| is_axis(tool, d)))
}

/// A deeper place of contact than the `known` one, and how far the tool can move before another place of
/// contact can become the deepest: two gaps change against each other by twice the way at most.
pub(crate) fn elsewhere(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
) -> (Option<Gap>, f64) {
    // An opened hollow is looked at as a whole each time.
    if side == Side::Open || !several(tool, surface, side) {
        return (None, f64::INFINITY);
    }
    let arc = round(tool, surface, side, None);
    let size = tool.profile.widest().max(0.1 * tool.profile.reach());
    let apart = |rival: f64, gap: f64| 0.5 * (rival - gap).max(0.0);
    let until = |rival: f64, gap: f64| (LOOK * size).min(apart(rival, gap));
    if hollow(surface, side) && (arc.is_none() || has_side(tool)) {
        let foot = |p| turned(surface.foot(p), side);
        let found = rings::with_rival(tool, foot, 0.1 * size);
        let Ok((gap, rival)) = found else { return (None, LOOK * size) };
        return ((gap.raw < known.raw).then_some(gap), until(rival, gap.raw));
    }
    if let Some(gap) = arc {
        let flank = match has_side(tool) {
            true => flank(tool, surface, side, 0.0, known.raw),
            false => Some(f64::INFINITY),
        };
        if let Some(flank) = flank {
            // But for surfaces by two parameters each search is one over the whole of the surface.
            let rival = match surface {
                Surface::Parametric(_) => {
                    let radius = tool.profile.corner_radius();
                    let limit = gap.raw + 2.0 * LOOK * size + radius;
                    surface.rival(middle(tool), limit) - radius
                }
                _ if flank.is_infinite() => return (None, f64::INFINITY),
                _ => f64::INFINITY,
            };
            let room = until(rival, gap.raw).min(until(flank, known.raw));
            return ((gap.raw < known.raw).then_some(gap), room);
        }
    }
    if let Some(through) = pierced(tool, surface, side) {
        return (Some(through), 0.0);
    }
    let seen = SEEN * if tool.profile.widest() > 0.0 { tool.profile.widest() } else { size };
    let (mut deepest, mut room, mut free) = (*known, seen, 0.0_f64);
    let mut stations = Stations { lower: arc.is_none(), flank: true };
    if arc.is_none()
        && let Some(flank) = flank(tool, surface, side, 0.25, known.raw)
    {
        free = apart(flank, known.raw);
        room = seen.min(free);
        stations.flank = false;
    }
    let Seeds { found: seeds, deepest: lowest, tightest } = seeds(tool, surface, side, stations);
    room = room.max(steep(tool, known, tightest).min(free));
    let found = seeds.into_iter().flatten().filter_map(|q| local(tool, surface, side, q).ok());
    for gap in found.chain(arc) {
        if (gap.tool_point - known.tool_point).norm() > 1e-6 * size {
            room = room.min(0.5 * (gap.raw - known.raw).max(0.0));
        }
        if gap.raw < deepest.raw {
            deepest = gap;
        }
    }
    if let Some(through) = drowned(tool, surface, side, &deepest, lowest) {
        return (Some(through), 0.0);
    }
    ((deepest.raw < known.raw).then_some(deepest), room)
}

/// Where the axis of the shank goes through a surface with ends: what lies behind its edge has no place of contact of its
/// own, for there the shank is the deeper the farther out.
fn pierced(tool: &Tool<'_>, surface: &Surface, side: Side) -> Option<Gap> {
    if !matches!(surface, Surface::Tabcyl(_) | Surface::Parametric(_)) || !has_side(tool) {
        return None;
    }
    let [_, [wide, joint]] = tool.profile.joints();
    let at = |z: f64| surface.foot(tool.te + tool.ta * z);
    let (mut low, mut high) = (joint, tool.profile.height());
    let before = |foot: &Foot| side.sign() * foot.distance > 0.0;
    if before(&at(high)) || !before(&at(low)) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        *(if before(&at(middle)) { &mut low } else { &mut high }) = middle;
    }
    let foot = at(high);
    // Where the axis goes by the edge the side changes and the distance does not vanish.
    let near = 1e-6 * tool.profile.reach();
    let raw = -wide.min(tool.profile.top_radius());
    (foot.distance.abs() <= near && raw < 0.0).then(|| Gap {
        g: raw,
        raw,
        tool_point: tool.te + tool.ta * high,
        surface_point: foot.point,
        at: foot.at,
        normal: foot.normal * side.sign(),
        segment: None,
        residual: f64::INFINITY,
    })
}

/// Halvings in the search for the place where an axis goes through a surface.
const HALVINGS: u32 = 40;

/// A distance greater than `above` from the surface within which none of the tool's upper line is beyond the share
/// `from` of it, nor its top; `None` where that is not seen. No point of a piece is nearer than the middle of its axis
/// by more than it lies away from that.
fn flank(tool: &Tool<'_>, surface: &Surface, side: Side, from: f64, above: f64) -> Option<f64> {
    let [_, [ru, zu]] = tool.profile.joints();
    let (rim, top) = (tool.profile.top_radius(), tool.profile.height());
    let wide = ru.max(rim);
    let mut low = zu + (top - zu) * from;
    let mut least = f64::INFINITY;
    // From below in pieces, each time as much of what is left as is seen to be clear.
    let mut high = top;
    for _ in 0..FLANK {
        let half = 0.5 * (high - low);
        let middle = surface.foot(tool.te + tool.ta * (low + half));
        let clear = side.sign() * middle.distance - aptc_geometry::trig::hypot(half, wide);
        if clear <= above {
            high = low + 0.5 * half;
            continue;
        }
        least = least.min(clear);
        if high >= top {
            return Some(least);
        }
        (low, high) = (high, top);
    }
    None
}

/// Pieces in which the upper line is looked at, for a bound of its distance.
const FLANK: usize = 8;

/// Share of the cutter's size after which its contact is looked for anew in any case.
const LOOK: f64 = 0.25;

/// The same where a dip that is not there yet may come up: share of the cutter's radius, which below a long shank is several
/// times less.
const SEEN: f64 = 0.15;

/// The way for which no place of the corner or below it can come to be as deep as the `known` one of the corner, as it leans
/// there more than the surface bends; 0 where that is not so.
///
/// With rho the radius of the circle of the corner's middles, s the sine between axis and normal at the known place and k the
/// greatest curvature about, the distance from the surface grows along the circle from the known place up to the angle t
/// where s cos(t/2) = k rho, for the normals differ by 2 k rho sin(t/2) at most; beyond it is farther than s rho. A flat end
/// has a place of its own only where the normal is the axis. Going on by x takes k x of s at most. Curvatures may be a
/// quarter greater than those that were seen.
fn steep(tool: &Tool<'_>, known: &Gap, tightest: f64) -> f64 {
    let rho = tool.profile.corner()[0];
    if known.segment != Some(Segment::Arc) || rho <= 0.0 {
        return 0.0;
    }
    let lean = known.normal.cross(&tool.ta).norm();
    let way = 0.8 * lean / tightest - 1.5 * rho;
    way.clamp(0.0, tool.profile.widest())
}

/// A point of the tool's axis, near the corner.
fn middle(tool: &Tool<'_>) -> Vec3 {
    tool.te + tool.ta * tool.profile.corner()[1]
}

/// The foot as seen from `side`, which is then the negative one.
fn turned(foot: Foot, side: Side) -> Foot {
    match side {
        Side::Negative | Side::Open => foot,
        Side::Positive => Foot {
            normal: -foot.normal,
            distance: -foot.distance,
            shape: foot.shape.reversed(),
            ..foot
        },
    }
}

/// A cutter with a centre: its nearest surface point, when the arc faces it. Of all arc contacts this is the
/// nearest one, or with a start the one thereabouts.
#[inline]
fn round(tool: &Tool<'_>, surface: &Surface, side: Side, start: Option<Spot>) -> Option<Gap> {
    let profile = tool.profile;
    if !profile.is_round() {
        return None;
    }
    let foot = match start {
        Some(near) => surface.foot_from(middle(tool), near),
        None => surface.foot(middle(tool)),
    };
    let normal = foot.normal * side.sign();
    let p = tool.support(-normal);
    if p.segment != Segment::Arc {
        return None;
    }
    let raw = side.sign() * foot.distance - profile.corner_radius();
    Some(Gap {
        g: raw,
        raw,
        tool_point: p.point,
        surface_point: foot.point,
        at: foot.at,
        normal,
        segment: Some(Segment::Arc),
        residual: 0.0,
    })
}

/// Has the cutter an upper line of any length?
fn has_side(tool: &Tool<'_>) -> bool {
    let [_, [ru, zu]] = tool.profile.joints();
    let rim = [tool.profile.top_radius() - ru, tool.profile.height() - zu];
    rim[0].abs() + rim[1].abs() > 1e-12 * tool.profile.reach()
}

/// Greatest number of seeds that are searched from.
const SEEDS: usize = 4;

/// Which stations around the tool are looked at.
#[derive(Clone, Copy)]
struct Stations {
    /// Those of the lower line and the arc: not where the place of the arc is known.
    lower: bool,
    /// Those of the upper line beyond its lower end.
    flank: bool,
}

/// Values and places below the stations of one ring.
type Ring = [(f64, Spot); AROUND];

/// What the stations around a tool tell.
struct Seeds {
    /// Surface points below the lowest: the local minima over the stations, the lowest of them.
    found: [Option<Spot>; SEEDS],
    /// The deepest station, and by how much.
    deepest: (f64, Vec3),
    /// The greatest curvature of the surface at the feet of all.
    tightest: f64,
}

/// The surface below the stations around the tool.
fn seeds(tool: &Tool<'_>, surface: &Surface, side: Side, of: Stations) -> Seeds {
    let profile = tool.profile;
    let [[rl, zl], [ru, zu]] = profile.joints();
    let mid = |a: [f64; 2], b: [f64; 2]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    let (lower, upper) = ([rl, zl], [ru, zu]);
    let rim = [profile.top_radius(), profile.height()];
    let stations = [rim, mid(upper, rim), upper, lower, mid(lower, [0.0, profile.bottom()])];
    let stations = &stations[if of.flank { 0 } else { 2 }..if of.lower { 5 } else { 2 }];
    let [a, b] = aptc_geometry::surface::frame_about(tool.ta);
    let (mut deepest, mut tightest) = ((f64::INFINITY, tool.te), 0.0_f64);
    let mut at = |rho: f64, z: f64, turn: usize| {
        let out = a * COS12[turn] + b * COS12[(turn + 9) % AROUND];
        let p = tool.te + out * rho + tool.ta * z;
        let foot = surface.foot(p);
        let value = side.sign() * foot.distance;
        if value < deepest.0 {
            deepest = (value, p);
        }
        tightest = foot.shape.principal().into_iter().map(f64::abs).fold(tightest, f64::max);
        (value, foot.spot())
    };
    let mut found: [Option<(bool, f64, Spot)>; SEEDS] = [None; SEEDS];
    let mut offer = |beside: bool, value: f64, q: Spot| {
        let mut new = Some((beside, value, q));
        for slot in &mut found {
            if new.is_some_and(|n| slot.is_none_or(|s| (n.0, n.1) < (s.0, s.1))) {
                std::mem::swap(slot, &mut new);
            }
        }
    };
    if of.lower {
        let (value, q) = at(0.0, profile.bottom(), 0);
        offer(false, value, q);
    }
    let mut ring = |[rho, z]: [f64; 2]| -> Ring { std::array::from_fn(|turn| at(rho, z, turn)) };
    let mut rings = [None; 5];
    for (i, station) in stations.iter().enumerate() {
        if !stations[..i].contains(station) {
            rings[i] = Some(ring(*station));
        }
    }
    let rings: [Option<Ring>; 5] = rings;
    let rings = || rings.iter().flatten();
    for (i, ring) in rings().enumerate() {
        let next = [i.checked_sub(1), Some(i + 1)].map(|k| k.and_then(|k| rings().nth(k)));
        for turn in 0..AROUND {
            let (value, q) = ring[turn];
            let about = [(turn + 1) % AROUND, (turn + AROUND - 1) % AROUND];
            if about.iter().all(|t| value <= ring[*t].0) {
                // Where the ring above or below is lower it leads to the same place, most likely: one such place must not
                // take the seeds of another.
                let lower = |r: &Ring| about.iter().chain([&turn]).any(|t| r[*t].0 < value);
                offer(next.into_iter().flatten().any(lower), value, q);
            }
        }
    }
    Seeds { found: found.map(|f| f.map(|f| f.2)), deepest, tightest }
}

/// Cosines of the multiples of 30 degrees.
const COS12: [f64; AROUND] = {
    let c = 0.866_025_403_784_438_6;
    [1.0, c, 0.5, 0.0, -0.5, -c, -1.0, -c, -0.5, 0.0, 0.5, c]
};

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
            return Ok(Gap {
                g: raw,
                raw,
                tool_point: here.tool_point,
                surface_point: here.q.point,
                at: here.q.at,
                normal: here.normal,
                segment: Some(here.segment),
                residual,
            });
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
        // Each by itself: a long way along a ruling must not shorten the one across it.
        let (a, b) = (a.clamp(-cap, cap), b.clamp(-cap, cap));
        [p * a - q * b, q * a + p * b]
    };
    let d = u * d[0] + v * d[1];
    let length = d.norm();
    if length > cap { d * (cap / length) } else { d }
}
