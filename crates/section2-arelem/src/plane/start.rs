//! Start-up in the plane (APT: `STRTUP`): lines, circles and the floor.

use aptc_cldata::{Control, Position};
use aptc_geometry::Vec3;
use aptc_protap::Relation;

use super::curve::Curve;
use super::floor::{Floor, Height};
use super::frame::{Frame, Vec2};
use crate::failure::{Candidate, Failure};
use crate::scene::{Path, Start, Wall};

/// Sine to the tool axis above which a part plane leans.
const LEANS: f64 = 1e-9;

/// A surface along the axis with the curve on which the tool end is to be.
struct Side<'a> {
    wall: &'a Wall,
    relation: Relation,
    /// Its trace.
    trace: Curve,
    /// Signed distance of the tool end from it.
    by: f64,
    along: Option<Vec3>,
}

/// The position of a start-up; `None` when it is not one for the plane routine: the first surface must stand along
/// the axis.
pub(crate) fn start(go: &Start) -> Option<Result<Path, Failure>> {
    let frame = Frame::of(go.tool.ta);
    let te = frame.plan(go.tool.te);
    let mut floor: Option<(Floor, &Wall, Relation)> = None;
    let mut sides: Vec<Side<'_>> = Vec::new();
    let mut failure = None;
    let named = go.surfaces.iter().enumerate().map(|(i, s)| (s, Some(i)));
    for ((relation, wall), i) in named.chain(go.part.iter().map(|s| (s, None))) {
        if matches!(relation, Relation::Tanto | Relation::Pstan) {
            return None;
        }
        let to_past = i.and_then(|i| go.normals.get(i).copied().flatten());
        if let Some(trace) = Curve::of(&wall.surface.form, &frame) {
            let normal = to_past.map(|v| frame.plan(v));
            let along = i.and_then(|i| go.along.get(i).copied().flatten());
            // A tool on the surface comes to it anew along its direction: TO is before that place.
            let normal = normal.or_else(|| {
                if trace.distance(te).abs() > standing(wall) {
                    return None;
                }
                let t = flat(&frame, along?)?;
                let q = te + t * ahead(&trace, te, t, wall)?;
                Some(trace.normal(te)? * trace.normal(q)?.dot(&t))
            });
            let by = match signed_reach(*relation, wall, &trace, te, normal) {
                Ok(by) => by,
                Err(f) => {
                    failure.get_or_insert(f);
                    continue;
                }
            };
            sides.push(Side { wall, relation: *relation, trace, by, along });
        } else if floor.is_none() && !sides.is_empty() {
            let height = match (to_past, *relation == Relation::Past) {
                (Some(v), false) => Height::Behind(v),
                (Some(v), true) => Height::Before(v),
                (None, false) => Height::Near,
                (None, true) => Height::Far,
            };
            floor = Some((Floor::of(wall, &frame, go.tool.te, height)?, wall, *relation));
        } else {
            return None;
        }
    }
    if let Some(f) = failure {
        return Some(Err(f));
    }
    // Directions for further surfaces lead to a place from which the nearest position counts.
    let several = sides.len() == 1 && go.along.iter().skip(1).any(Option::is_some);
    if sides.is_empty() || sides.len() > 2 || several || in_space(go, &floor, &sides, &frame) {
        return None;
    }
    // Without a floor the direction may climb; that is exact only for one surface.
    let lift = |place: Vec2| {
        let height = match &floor {
            Some((f, ..)) => f.height(&frame, place),
            None => free_height(go, &frame, te, place, &sides),
        };
        frame.space(place, height)
    };
    let (place, rival) = match locate(go, &frame, te, &sides) {
        Ok(found) => found,
        Err(f) => return Some(Err(f)),
    };
    let end = lift(place);
    let rivals = rival.map(|q| Candidate::of(go.tool.te, lift(q))).into_iter().collect();
    let mut controlled = Vec::new();
    for (relation, wall) in go.surfaces.iter().chain(&go.part) {
        let side = sides
            .iter()
            .find(|s| std::ptr::eq(s.wall, wall))
            .map(|s| s.by)
            .or_else(|| floor.as_ref().map(|(f, w, _)| f.form_side(w)));
        controlled.push(wall.controlled(*relation, side.unwrap_or(1.0)));
    }
    let mut controlled = controlled.into_iter();
    let (drive, part) = (controlled.next(), controlled.next());
    let control = Control { drive, part, checks: controlled.collect(), milling: None };
    let points = vec![Position { te: end, ta: go.tool.ta }];
    let forward = end - go.tool.te;
    Some(Ok(Path { rivals, ..Path::started(points, forward, control) }))
}

/// With a thickness, with a cutter whose sides lean, and with one that is a point at a circle, APT-360 starts up in space; that
/// ends elsewhere where a direction was given or the part surface leans.
fn in_space(
    go: &Start,
    floor: &Option<(Floor, &Wall, Relation)>,
    sides: &[Side<'_>],
    frame: &Frame,
) -> bool {
    let differs = floor.as_ref().is_some_and(|(f, ..)| f.n.cross(&frame.w).norm() > LEANS)
        || sides.iter().any(|s| s.along.is_some());
    let point = |w: &Wall| !w.on && w.profile.widest() == 0.0;
    let at_a_circle = sides.iter().any(|s| matches!(s.trace, Curve::Circle { .. }));
    let any = |is: &dyn Fn(&Wall) -> bool| go.surfaces.iter().chain(&go.part).any(|(_, w)| is(w));
    let leans = |w: &Wall| (w.profile.top_radius() - w.profile.half_diameter()).abs() > LEANS;
    differs && (go.thick || any(&leans) || at_a_circle && any(&point))
}

/// Signed distance from the curve at which the tool end is to be: TO keeps the tool on its side, PAST
/// takes it to the other.
fn signed_reach(
    relation: Relation,
    wall: &Wall,
    trace: &Curve,
    te: Vec2,
    from_to_to_past: Option<Vec2>,
) -> Result<f64, Failure> {
    let reach = wall.reach();
    if relation == Relation::On || reach <= 0.0 {
        return Ok(if relation == Relation::On { 0.0 } else { reach });
    }
    let at = trace.distance(te);
    let given = from_to_to_past.and_then(|v| trace.normal(te).map(|n| -v.dot(&n)));
    let near = match given {
        Some(side) if side.abs() > 0.0 => side.signum(),
        // A tool that stands on the surface counts as being on its negative side, and is told so.
        _ if at.abs() <= standing(wall) => -1.0,
        _ => at.signum(),
    };
    let side = if relation == Relation::Past { -near } else { near };
    match *trace {
        Curve::Circle { r, .. } if side < 0.0 && r < reach => {
            if relation == Relation::Past {
                // There is no room inside: the far side is the outside, beyond the centre.
                Ok(reach)
            } else {
                Err(Failure::TooLarge { surface: wall.surface.clone(), radius: r, cutter: reach })
            }
        }
        _ => Ok(side * reach),
    }
}

/// Least distance from the curve of a tool that goes on from `te` along `t`, where they do not meet.
fn closest(trace: &Curve, te: Vec2, t: Option<Vec2>) -> f64 {
    let way = match (*trace, t) {
        (Curve::Circle { c, .. }, Some(t)) => t * (c - te).dot(&t).max(0.0),
        _ => Vec2::zeros(),
    };
    trace.distance(te + way).abs()
}

/// The place of the tool end, and another one that is just as near, when nothing says which is meant.
fn locate(
    go: &Start,
    frame: &Frame,
    te: Vec2,
    sides: &[Side<'_>],
) -> Result<(Vec2, Option<Vec2>), Failure> {
    let curve = |s: &Side<'_>| {
        s.trace.offset(s.by).ok_or_else(|| Failure::TooLarge {
            surface: s.wall.surface.clone(),
            radius: 0.0,
            cutter: s.by.abs(),
        })
    };
    if let [side] = sides {
        let target = curve(side)?;
        let Some(v) = side.along else {
            let place = target.nearest(te, frame.plan(go.tool.forward));
            return Ok((place, opposite(&side.trace, te, place, standing(side.wall))));
        };
        let t = flat(frame, v);
        let misses = || Failure::Misses {
            surface: side.wall.surface.clone(),
            closest: (closest(&side.trace, te, t) - side.by.abs()).max(0.0),
        };
        let t = t.ok_or_else(misses)?;
        if go.offset {
            let s = ahead(&side.trace, te, t, side.wall).ok_or_else(misses)?;
            let q = te + t * s;
            let n = side.trace.normal(q).ok_or_else(misses)?;
            return Ok((q + n * side.by, None));
        }
        return directed(side, &target, te, t).map(|s| (te + t * s, None)).ok_or_else(misses);
    }
    // Two surfaces: each direction given brings the tool nearer, then the nearest position counts.
    let mut from = te;
    let mut first = None;
    for side in sides {
        let Some(v) = side.along else { continue };
        let Some(t) = flat(frame, v) else { continue };
        first.get_or_insert(t);
        if let Some(s) = directed(side, &curve(side)?, from, t).or_else(|| side.trace.hit(from, t))
        {
            from += t * s;
        }
    }
    let (one, other) = (curve(&sides[0])?, curve(&sides[1])?);
    let mut meets = one.meet(&other);
    if meets.is_empty() {
        meets.extend(touching(sides, &one, &other));
    }
    if let Some(t) = first {
        let forward: Vec<Vec2> = meets.iter().copied().filter(|q| (q - te).dot(&t) > 0.0).collect();
        if !forward.is_empty() {
            meets = forward;
        }
    }
    meets.sort_by(|a, b| (a - from).norm().total_cmp(&(b - from).norm()));
    let place = meets.first().copied().ok_or_else(|| Failure::NoStart {
        place: None,
        left: Vec::new(),
        others: Vec::new(),
        surfaces: sides.iter().map(|s| s.wall.surface.clone()).collect(),
        why: "the two do not meet where the cutter would have to be",
    })?;
    // What rounding alone decides is told.
    let near = standing(sides[0].wall) + 1e-9 * te.norm();
    let rival = meets.get(1).copied().filter(|q| {
        let tie = (q - from).norm() - (place - from).norm() <= near;
        first.is_none() && tie && (q - place).norm() > 1e3 * near
    });
    Ok((place, rival))
}

/// The place on the other side of a circle in whose centre the tool stands: all round it is as near.
fn opposite(trace: &Curve, te: Vec2, place: Vec2, near: f64) -> Option<Vec2> {
    let Curve::Circle { c, .. } = *trace else { return None };
    ((te - c).norm() <= near).then(|| c - (place - c))
}

/// Where two surfaces that are tangent but for the digits they were written with nearly meet: halfway, or on the
/// one or the other, as their bands allow.
fn touching(sides: &[Side<'_>], one: &Curve, other: &Curve) -> Option<Vec2> {
    let (p, q) = one.nearest_of(other)?;
    let holds = |at: &Vec2| {
        sides.iter().all(|s| {
            let band = &s.wall.band;
            let off = s.trace.distance(*at) - s.by;
            // The tool is on the side that `by` names; ON has the band on both.
            let clear = if s.by < 0.0 { -off } else { off };
            -band.intol <= clear && clear <= band.outtol
        })
    };
    [(p + q) / 2.0, p, q].into_iter().find(holds)
}

/// So near to a surface the tool stands on it.
fn standing(wall: &Wall) -> f64 {
    1e-3 * (wall.band.intol + wall.band.outtol)
}

/// Unit direction in the plane.
fn flat(frame: &Frame, v: Vec3) -> Option<Vec2> {
    let t = frame.plan(v);
    let l = t.norm();
    (l > 1e-12 * v.norm()).then(|| t / l)
}

/// Distance to the place where the direction pierces the surface, the place where the tool stands apart.
fn ahead(trace: &Curve, te: Vec2, t: Vec2, wall: &Wall) -> Option<f64> {
    trace.hits(te, t).into_iter().find(|s| *s > standing(wall))
}

/// Distance along the direction to the place asked for: TO is the last one before the surface is pierced,
/// PAST the first one after it. A direction that passes beside a circle meets it TO and then PAST.
fn directed(side: &Side<'_>, target: &Curve, te: Vec2, t: Vec2) -> Option<f64> {
    let slack = 1e-9 * (te.norm() + side.by.abs());
    let hits: Vec<f64> = target.hits(te, t).into_iter().filter(|s| *s >= -slack).collect();
    let place = match ahead(&side.trace, te, t, side.wall) {
        Some(pierce) => match side.relation {
            Relation::On => Some(pierce),
            Relation::Past => hits.into_iter().find(|s| *s >= pierce - slack),
            _ => hits.into_iter().rev().find(|s| *s <= pierce + slack),
        },
        None if side.relation == Relation::Past => hits.into_iter().next_back(),
        None => hits.into_iter().next(),
    };
    place.map(|s| s.max(0.0))
}

/// Height of the tool end when no surface gives it: as it was, or as the direction climbs.
fn free_height(go: &Start, frame: &Frame, te: Vec2, place: Vec2, sides: &[Side<'_>]) -> f64 {
    let old = frame.height(go.tool.te);
    let [side] = sides else { return old };
    let Some(v) = side.along else { return old };
    let flat = frame.plan(v).norm();
    if flat > 0.0 && side.relation != Relation::Tanto {
        old + frame.height(v) * (place - te).norm() / flat
    } else {
        old
    }
}
