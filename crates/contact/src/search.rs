//! Places of contact where no closed form exists: which of them is the deepest, and when another one may become it.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Foot, Reason, Spot, Surface, Tool, Vec3};

use crate::alone::{Faced, WORTH, alone, faced, likely};
use crate::closed::{along_axis, is_axis};
use crate::descent::local;
use crate::gap::{Gap, Side, deeper};
use crate::stations::{SEEDS, Seeds, Stations, seeds};
use crate::{beneath, disk, edges, ridge, ring, rings, shank, wall};

/// Gap to a surface without closed form, of faces and of edges.
pub(crate) fn general(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    start: Option<Spot>,
) -> Result<Gap, Reason> {
    let found = faces(tool, surface, side, start);
    // With a start the search stays where it is.
    if start.is_some() {
        return found;
    }
    let limit = found.as_ref().map_or(f64::INFINITY, |gap| gap.raw);
    let Some(edge) = edges::all(tool, surface, side, limit, None) else { return found };
    match (found, edge.deepest) {
        (Ok(gap), Some(edge)) if !deeper(tool, edge.raw, gap.raw) => Ok(gap),
        (_, Some(edge)) => Ok(edge),
        (found, None) => found,
    }
}

/// The gap to the faces alone.
fn faces(
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
        // A search that begins beside the flank is not to end at the arc where the flank is the deeper.
        let flank = start.filter(|q| !far_is_convex && beside_flank(tool, q.point));
        let flank = flank.and_then(|q| local(tool, surface, side, q).ok());
        return Ok(flank.filter(|f| deeper(tool, f.raw, gap.raw)).unwrap_or(gap));
    }
    let corner = |q| ring::beside(tool, surface, side, q);
    let lower = |q| disk::beside(tool, surface, side, q);
    // What lies below the flat end is more likely to touch that.
    let found = start.and_then(|q| match below_flat(tool, q.point) {
        true => lower(q).or_else(|| corner(q)),
        false => corner(q).or_else(|| lower(q)),
    });
    if let Some(gap) = found {
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
        return rings::within(tool, foot);
    }
    if let Some(gap) = round
        && (!has_side(tool)
            || shank::keeps_off(tool, surface, gap.raw)
            || alone(tool, surface, side, &gap, 0.0).is_some())
    {
        // Nothing but the arc can touch.
        return Ok(gap);
    }
    let mut best = round;
    match round.and_then(|gap| wall::deepest(tool, surface, side, &gap)) {
        Some((gap, true)) => return Ok(gap),
        Some((deep, _)) => best = Some(deep),
        None => {}
    }
    let mut stations = Stations { lower: round.is_none(), flank: 1.0, disk: None };
    // Whether the way there leads past another place is no matter: they all are looked for.
    let any =
        |q| disk::beside(tool, surface, side, q).or_else(|| local(tool, surface, side, q).ok());
    if round.is_none()
        && matches!(surface, Surface::Parametric(_))
        && let Some(gap) = any(surface.foot(middle(tool)).spot())
    {
        if alone(tool, surface, side, &gap, 0.0).is_some() {
            return Ok(gap);
        }
        if let Some((found, _)) = dips(tool, surface, side, &gap, 0.0) {
            // Of places that are as deep by symmetry the first station tells, and not the way down from the middle.
            let deepest = found.reduce(|a, b| if deeper(tool, b.raw, a.raw) { b } else { a });
            return Ok(deepest.filter(|d| !deeper(tool, gap.raw, d.raw)).unwrap_or(gap));
        }
        if let Some(gap) = beneath::deepest(tool, surface, side, &gap) {
            return Ok(gap);
        }
        match wall::deepest(tool, surface, side, &gap) {
            Some((gap, true)) => return Ok(gap),
            Some((deep, _)) if deeper(tool, deep.raw, gap.raw) => best = Some(deep),
            _ => {}
        }
        // What of a shank is farther than that place leads nowhere, and from high above a surface by long ways.
        if flank(tool, surface, side, LOWER, gap.raw).is_some() {
            stations.flank = LOWER;
        }
    }
    let Seeds { found: seeds, deepest, .. } = seeds(tool, surface, side, stations, None);
    let mut failure = Reason::NoHit;
    for q in seeds.into_iter().flatten() {
        match disk::below(tool, surface, side, q) {
            Ok(gap) if best.is_none_or(|b| deeper(tool, gap.raw, b.raw)) => best = Some(gap),
            Ok(_) => {}
            Err(reason) => failure = reason,
        }
    }
    best.map(|gap| drowned(tool, surface, side, &gap, deepest).unwrap_or(gap)).ok_or(failure)
}

/// Is a point nearer to the axis than the corner?
fn below_flat(tool: &Tool<'_>, p: Vec3) -> bool {
    let (away, [rho, _]) = (p - tool.te, tool.profile.corner());
    (away - tool.ta * away.dot(&tool.ta)).norm_squared() < rho * rho
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
    (stands, most): (bool, f64),
) -> (Option<Gap>, f64) {
    let (found, room) = elsewhere_on_faces(tool, surface, side, known, (stands, most));
    let limit = known.raw + 2.0 * room;
    let Some(edges) = edges::all(tool, surface, side, limit, Some(known)) else {
        return (found, room);
    };
    let least = found.map_or(known.raw, |gap| gap.raw.min(known.raw));
    let edge = edges.deepest.filter(|edge| deeper(tool, edge.raw, least));
    let until = 0.5 * (edges.least - known.raw).max(0.0);
    (edge.or(found), room.min(until))
}

/// The same of the faces alone.
fn elsewhere_on_faces(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
    (stands, most): (bool, f64),
) -> (Option<Gap>, f64) {
    // An opened hollow is looked at as a whole each time.
    if side == Side::Open || !several(tool, surface, side) {
        return (None, f64::INFINITY);
    }
    let (wide, reach) = (tool.profile.widest(), tool.profile.reach());
    // A line alone has no other measure than its length.
    let size = if wide > 0.0 { wide.max(0.1 * reach) } else { reach };
    if stands && matches!(surface, Surface::Parametric(_)) {
        let free = |first: f64| {
            // Those that are too long need not be tried, but one is.
            let wanted = |share: &f64| share * first <= most || *share <= TRIED[TRIED.len() - 1];
            let mut ways = TRIED.into_iter().filter(wanted).map(|share| share * first);
            ways.find_map(|way| alone(tool, surface, side, known, way))
        };
        let likely = likely(tool, surface, side, known, size);
        // Beside the ridge of a surface of rulings the next places are told sooner, and for a longer way.
        let ruled = matches!(surface, Surface::Parametric(s) if s.is_ruled());
        let short = |way: &f64| ruled && *way < RIDGE * SEEN * wide;
        let shown = |way: Option<f64>| way.and_then(free).filter(|way| *way >= WORTH * size);
        if let Some(way) = shown(likely.filter(|way| !short(way))) {
            return (None, way);
        }
        let seen = SEEN * wide;
        let found = lower(tool, surface, side, known, seen)
            .or_else(|| beneath::elsewhere(tool, surface, side, known, seen));
        if let Some(found) = found {
            return found;
        }
        if let Some(way) = shown(likely.filter(short)) {
            return (None, way);
        }
    }
    let arc = round(tool, surface, side, None);
    let below = |gap: Gap| deeper(tool, gap.raw, known.raw).then_some(gap);
    let apart = |rival: f64, gap: f64| 0.5 * (rival - gap).max(0.0);
    let until = |rival: f64, gap: f64| (LOOK * size).min(apart(rival, gap));
    if hollow(surface, side) && (arc.is_none() || has_side(tool)) {
        let foot = |p| turned(surface.foot(p), side);
        let found = rings::with_rival(tool, foot, 0.1 * size);
        let Ok((gap, rival)) = found else { return (None, LOOK * size) };
        return (below(gap), until(rival, gap.raw));
    }
    if let Some(gap) = arc {
        let flank = match has_side(tool) {
            true => shank::clear(tool, surface, [gap.raw, known.raw], LOOK * size)
                .or_else(|| flank(tool, surface, side, 0.0, known.raw)),
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
            return (below(gap), room);
        }
    }
    if let Some(through) = pierced(tool, surface, side) {
        return (Some(through), 0.0);
    }
    let seen = SEEN * if wide > 0.0 { wide } else { size };
    if stands && let Some(found) = wall::elsewhere(tool, surface, side, known, seen.min(most)) {
        return found;
    }
    let (mut deepest, mut room) = (*known, seen);
    let mut stations = Stations { lower: arc.is_none(), flank: 1.0, disk: None };
    if arc.is_none()
        && let Some(flank) = flank(tool, surface, side, LOWER, known.raw)
    {
        room = seen.min(apart(flank, known.raw));
        stations.flank = 0.0;
    }
    let Seeds { found: seeds, deepest: lowest, way } =
        seeds(tool, surface, side, stations, Some(known));
    room = room.min(0.5 * way);
    let ends = flank_ends(tool, surface, known);
    let found = seeds.into_iter().chain(ends).flatten();
    let found = found.filter_map(|q| disk::below(tool, surface, side, q).ok());
    for gap in found.chain(arc) {
        rival(tool, known, &gap, &mut deepest, &mut room);
    }
    if let Some(through) = drowned(tool, surface, side, &deepest, lowest) {
        return (Some(through), 0.0);
    }
    (below(deepest), room)
}

/// The same where nothing but corner and flat end can touch on the way of `most`; `None` where that is not seen.
fn lower(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
    most: f64,
) -> Option<(Option<Gap>, f64)> {
    let (found, way) = dips(tool, surface, side, known, most)?;
    let (mut deepest, mut room) = (*known, way.map_or(most, |way| most.min(0.5 * way)));
    // All of a ridge along which the cutter lies has one normal, and comes as near on the way.
    let size = tool.profile.reach();
    let line = |gap: &Gap| {
        let turned = (gap.normal - known.normal).norm();
        way.is_none() && turned <= LINE && (gap.raw - known.raw).abs() <= LINE * LINE * size
    };
    for gap in found.filter(|gap| !line(gap)) {
        rival(tool, known, &gap, &mut deepest, &mut room);
    }
    Some((deeper(tool, deepest.raw, known.raw).then_some(deepest), room))
}

/// The places of contact of corner and flat end where nothing else can touch on the way of `most`, and the way after which
/// another may be as deep, none where all of them lie on one ridge; `None` where that is not seen.
fn dips<'t>(
    tool: &'t Tool<'_>,
    surface: &'t Surface,
    side: Side,
    known: &Gap,
    most: f64,
) -> Option<(impl Iterator<Item = Gap> + 't, Option<f64>)> {
    let Faced { ridge, .. } = faced(tool, surface, side, known, most)?;
    let ends = if ridge { ridge::ends(tool, surface, side, known) } else { None };
    let (found, way) = match ends {
        Some([a, b]) => {
            let mut found = [None; 2 * SEEDS];
            (found[0], found[1]) = (a, b);
            (found, None)
        }
        None => {
            let stations = Stations { lower: true, flank: 0.0, disk: Some(known.spot()) };
            let Seeds { found, way, .. } = seeds(tool, surface, side, stations, Some(known));
            (found, Some(way))
        }
    };
    let dip = move |q| disk::below(tool, surface, side, q).ok();
    Some((found.into_iter().flatten().filter_map(dip), way))
}

/// Takes another place of contact than the `known` one: it may be the deepest, or become it on a way.
pub(crate) fn rival(tool: &Tool<'_>, known: &Gap, gap: &Gap, deepest: &mut Gap, room: &mut f64) {
    let (wide, reach) = (tool.profile.widest(), tool.profile.reach());
    let size = if wide > 0.0 { wide.max(0.1 * reach) } else { reach };
    if (gap.tool_point - known.tool_point).norm() > 1e-6 * size {
        *room = room.min(0.5 * (gap.raw - known.raw).max(0.0));
    }
    if deeper(tool, gap.raw, deepest.raw) {
        *deepest = *gap;
    }
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

/// What lies beside both ends of a flank that touches: along rulings that twist it touches with one of them or with the other,
/// and stations all round it may lead past that.
fn flank_ends(tool: &Tool<'_>, surface: &Surface, known: &Gap) -> [Option<Spot>; 2] {
    let lean = known.normal.dot(&tool.ta);
    let upright = lean.abs() <= ALONG && has_side(tool);
    let ruled = matches!(surface, Surface::Parametric(s) if s.is_ruled());
    if !upright || !ruled {
        return [None; 2];
    }
    let out = -(known.normal - tool.ta * lean).normalize();
    let profile = tool.profile;
    let [_, joint] = profile.joints();
    [joint, [profile.top_radius(), profile.height()]].map(|[rho, z]| {
        let end = tool.te + out * rho + tool.ta * z;
        Some(surface.foot(end).spot())
    })
}

/// Greatest sine of the angle between a flank and what it touches.
const ALONG: f64 = 0.3;

/// Halvings in the search for the place where an axis goes through a surface.
const HALVINGS: u32 = 40;

/// A distance greater than `above` from the surface within which none of the tool's upper line is beyond the share
/// `from` of it, nor its top; `None` where that is not seen. No point of a piece is nearer than the middle of its axis
/// by more than it lies away from that.
fn flank(tool: &Tool<'_>, surface: &Surface, side: Side, from: f64, above: f64) -> Option<f64> {
    let [_, [ru, zu]] = tool.profile.joints();
    let (rim, top) = (tool.profile.top_radius(), tool.profile.height());
    let wide = ru.max(rim);
    // Beside the tip of a line, which is no farther than `above`, nothing can be seen.
    if wide <= 0.0 && from <= 0.0 {
        return None;
    }
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
/// Share of the upper line above which it is: what is nearer to the corner is hardly seen to be clear of what that touches.
const LOWER: f64 = 0.25;

/// Share of the cutter's size after which its contact is looked for anew in any case.
const LOOK: f64 = 0.25;

/// Shares of the way for which a contact is likely to be shown to be the only one for which that is tried.
const TRIED: [f64; 3] = [1.0, 0.4, 0.1];

/// Length of the difference of the normals at two places of a line of contact at most, and the root of the share of the cutter's
/// reach by which they are as deep.
const LINE: f64 = 1e-6;

/// The same where a dip that is not there yet may come up: share of the cutter's radius, which below a long shank is several
/// times less.
const SEEN: f64 = 0.15;

/// Share of that way below which one for which a contact is alone is worth less than the places beside a ridge.
const RIDGE: f64 = 0.5;

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

/// Is a point higher than the joint of arc and upper line, so that it is the flank that passes it?
fn beside_flank(tool: &Tool<'_>, q: Vec3) -> bool {
    /// Share of the cutter's size by which it has to be.
    const ABOVE: f64 = 1e-3;
    let [_, [_, joint]] = tool.profile.joints();
    has_side(tool) && (q - tool.te).dot(&tool.ta) > joint + ABOVE * tool.profile.reach()
}

/// Has the cutter an upper line of any length?
fn has_side(tool: &Tool<'_>) -> bool {
    let [_, [ru, zu]] = tool.profile.joints();
    let rim = [tool.profile.top_radius() - ru, tool.profile.height() - zu];
    rim[0].abs() + rim[1].abs() > 1e-12 * tool.profile.reach()
}
