//! Start-up in space (APT: `STRTUP`): the nearest position that satisfies one, two or three surfaces.

use aptc_cldata::{Control, Controlled};
use aptc_contact::{Condition, Gap, Side, opens};
use aptc_geometry::surface::frame_about;
use aptc_geometry::{Surface, Vec3};
use aptc_protap::{OptionSurface, Relation, SurfaceRef};

use super::ends::end_in;
use super::keep::{Keep, Pose, within};
use super::settle::{Solver, flattened};
use super::watch::clearance;
use crate::axis::{AxisRule, Came};
use crate::failure::{Candidate, Failure};
use crate::scene::{Path, Start, Wall};

/// A surface with the gap that the tool is to have.
pub(super) struct Aim<'a> {
    pub(super) wall: &'a Wall,
    pub(super) relation: Relation,
    pub(super) keep: Keep,
    pub(super) along: Option<Vec3>,
}

/// The position of a start-up. Where surfaces leave one position or a few, one on sculptured surfaces themselves counts before those
/// on what goes on straight beyond their borders, which may stand over them.
pub(crate) fn start(go: &Start) -> Result<Path, Failure> {
    let path = start_there(go)?;
    // The bands of surfaces on which the tool end comes to lie are those where it does.
    let there = path.points.last().and_then(|end| seen_from(go, end.te, end.ta));
    Ok(there.and_then(|go| start_there(&go).ok()).unwrap_or(path))
}

fn start_there(go: &Start) -> Result<Path, Failure> {
    let on_itself = on_itself(go).map(|itself| start_on(&itself, true));
    on_itself.and_then(Result::ok).map_or_else(|| start_on(go, false), Ok)
}

/// The same start-up with the bands of another place; `None` where they are those of this one.
fn seen_from(go: &Start, te: Vec3, ta: Vec3) -> Option<Start> {
    let mut other = go.clone();
    let walls = other.surfaces.iter_mut().chain(other.part.iter_mut()).map(|(_, wall)| wall);
    let mut changed = false;
    for wall in walls {
        let seen = wall.clone().seen_from(te, ta);
        changed |= seen.below != wall.below;
        *wall = seen;
    }
    changed.then_some(other)
}

/// The same start-up without what goes on straight; `None` where surfaces leave a choice, or nothing does.
fn on_itself(go: &Start) -> Option<Start> {
    const ALL: usize = 3;
    if go.surfaces.len() < ALL || go.offset {
        return None;
    }
    let mut itself = go.clone();
    let mut some = false;
    for (_, wall) in &mut itself.surfaces {
        if let Some(Surface::Parametric(surface)) = &wall.fitted
            && let Some(own) = surface.without_continuation()
        {
            wall.fitted = Some(Surface::Parametric(own));
            some = true;
        }
    }
    some.then_some(itself)
}

/// The position by the surfaces as they are. Where they are tried first, others follow: `all` of the cutter is to be on the side that
/// is meant, for the search goes by the places of contact about it alone, and no other way is sought.
fn start_on(go: &Start, all: bool) -> Result<Path, Failure> {
    let pose = Pose { te: go.tool.te, ta: go.tool.ta };
    let mut aims = Vec::new();
    let named = go.surfaces.iter().enumerate().map(|(i, s)| (s, Some(i)));
    for ((relation, wall), i) in named.chain(go.part.iter().map(|s| (s, None))) {
        let normal = i.and_then(|i| go.normals.get(i).copied().flatten());
        let along = i.and_then(|i| go.along.get(i).copied().flatten());
        let role = if i == Some(0) { OptionSurface::Drive } else { OptionSurface::Part };
        let rules = i != Some(2) && matches!(go.axis, AxisRule::Normal(r) if r == role);
        let keep = aim(go, *relation, wall, normal, rules)?;
        aims.push(Aim { wall, relation: *relation, keep, along });
    }
    let end = match arrive(go, &mut aims, pose) {
        Ok(end) => end,
        Err(Failure::NoStart { surfaces, why, place, left, .. }) if !all => {
            let others = reachable(go, &mut aims, pose);
            return Err(Failure::NoStart { surfaces, why, place, left, others });
        }
        Err(failure) => return Err(failure),
    };
    let rivals = rivals(go, &aims, pose, end);
    for aim in &aims {
        let deep = |g: &Gap| all && g.g < -2.0 * aim.keep.width();
        let gap = aim.keep.gap(&end, None).ok();
        let gap = gap.filter(|g| !aim.keep.goes_round_an_end(g) && !deep(g));
        gap.ok_or_else(|| Failure::NoContact { surface: aim.wall.surface.clone() })?;
    }
    let mut sides = aims.iter().map(|a| a.wall.beside(a.relation, a.keep.side));
    let (mut drive, part) = (sides.next(), sides.next());
    let mut left = None;
    if go.offset && part.is_some() {
        let gap = aims[0].keep.gap(&end, None).map_or(0.0, |gap| gap.g);
        if gap.abs() > aims[0].keep.width() {
            drive = drive.filter(|_| !aims[0].wall.on);
            drive = drive.map(|drive| left_by_offset(drive, aims[0].keep.width(), gap));
            left = Some(if aims[0].wall.on { gap.abs() } else { gap });
        } else if gap < aims[0].keep.limits().low - 1e-6 * aims[0].keep.width() {
            left = Some(gap);
        }
    }
    let control = Control { drive, part, checks: sides.collect(), milling: None };
    let points = vec![end.position()];
    let forward = end.te - go.tool.te;
    Ok(Path { rivals, left, ..Path::started(points, forward, control) })
}

/// What OFFSET promises of its drive surface once it has gone along the axis to the part surface: not to cut in. It may well
/// have left a surface that leans.
fn left_by_offset(drive: Controlled, width: f64, gap: f64) -> Controlled {
    let outtol = drive.outtol.max(gap + width);
    Controlled { outtol, ..drive }
}

/// The position, which is none where the tool stands above all of a hollow, beside what runs straight up from its outline, and where
/// the end of a surface is in its side.
fn arrive(go: &Start, aims: &mut [Aim<'_>], pose: Pose) -> Result<Pose, Failure> {
    let end = arrive_in(go, aims, pose)?;
    let none = |why: &'static str, left: Vec<(SurfaceRef, f64)>| Failure::NoStart {
        surfaces: aims.iter().map(|a| a.wall.surface.clone()).collect(),
        why,
        place: Some(end.te),
        left,
        others: Vec::new(),
    };
    let above: Vec<&Aim<'_>> = aims.iter().filter(|a| a.keep.stands_above(&end)).collect();
    if !above.is_empty() {
        let off = |a: &&Aim<'_>| {
            let outside = a.keep.on_side(Side::Positive).gap(&end, None);
            Some((a.wall.surface.clone(), outside.ok()?.g))
        };
        let left = above.iter().filter_map(off).collect();
        return Err(none("the tool would stand above all of the hollow that it is to be in", left));
    }
    // OFFSET does not promise that the surface that it leaves is not cut.
    let touched = aims.iter().filter(|_| !go.offset);
    let ends = touched.filter_map(|a| Some((a.wall.surface.clone(), end_in(&a.keep, &end)?)));
    let ends: Vec<_> = ends.collect();
    if ends.is_empty() {
        return Ok(end);
    }
    Err(none("where it comes to them, an end of one of them is in the cutter", ends))
}

/// The position; where a hollow may count as open, its side is decided.
///
/// A machinist means the bottom of a hollow, so that it is looked for as if it were open. A cutter that fits
/// below the rest of the hollow there has the hollow as it is. One that does not, but fits where it stands,
/// is to touch the hollow's roof if it can: only a cutter taller than the hollow makes it open.
fn arrive_in(go: &Start, aims: &mut [Aim<'_>], pose: Pose) -> Result<Pose, Failure> {
    let hollow = |a: &Aim<'_>| {
        let touches = a.keep.condition == Condition::Touch;
        touches && a.keep.side != Side::Positive && opens(&a.keep.surface, pose.ta)
    };
    if !aims.iter().any(hollow) {
        return solve(go, aims, pose);
    }
    let fits = |keep: &Keep, at: &Pose, least: f64| {
        keep.on_side(Side::Negative).gap(at, None).is_ok_and(|g| g.g >= least)
    };
    let upwards = |a: &Aim<'_>| a.along.is_some_and(|v| v.dot(&pose.ta) > 0.1);
    let put = |aims: &mut [Aim<'_>], open: &dyn Fn(&Aim<'_>) -> bool| {
        for a in aims.iter_mut().filter(|a| hollow(a)) {
            a.keep.side = if open(a) { Side::Open } else { Side::Negative };
        }
    };
    put(aims, &|a| !(upwards(a) && fits(&a.keep, &pose, 0.0)));
    let open = solve(go, aims, pose);
    let sides: Vec<Side> = aims.iter().map(|a| a.keep.side).collect();
    if let Ok(end) = &open {
        put(aims, &|a| !fits(&a.keep, end, -1.01 * a.keep.intol.max(0.0)));
        if aims.iter().all(|a| a.keep.side != Side::Open) {
            return open;
        }
    }
    put(aims, &|a| a.keep.taller(&pose) && !fits(&a.keep, &pose, 0.0));
    let whole = solve(go, aims, pose);
    if whole.is_ok() || aims.iter().any(|a| hollow(a) && !a.keep.taller(&pose)) {
        return whole;
    }
    for (aim, side) in aims.iter_mut().zip(sides) {
        aim.keep.side = side;
    }
    open
}

/// Positions that directions about the tool lead to, when the nearest one is not found.
fn reachable(go: &Start, aims: &mut [Aim<'_>], pose: Pose) -> Vec<Candidate> {
    let mut found: Vec<Candidate> = Vec::new();
    if go.offset || go.along.iter().any(Option::is_some) {
        return found;
    }
    let [a, b] = frame_about(pose.ta);
    for v in [a, b, -a, -b, a + b, b - a, -a - b, a - b].map(|v| v.normalize()) {
        for aim in aims.iter_mut().take(1) {
            aim.along = Some(v);
        }
        let directed = Start { along: vec![Some(v)], ..go.clone() };
        let Ok(end) = arrive(&directed, aims, pose) else { continue };
        let near = |c: &Candidate| (c.te - end.te).norm() <= 1e-6 * (end.te - pose.te).norm();
        if !found.iter().any(near) {
            found.push(Candidate { te: end.te, along: v });
        }
    }
    found
}

/// The mirror images of the position that are just as near, when nothing says which is meant.
///
/// Where two positions are equally near there is a plane through the tool axis in which the scene mirrors; it
/// holds the normals of the surfaces at the start.
fn rivals(go: &Start, aims: &[Aim<'_>], pose: Pose, end: Pose) -> Vec<Candidate> {
    let mut all: Vec<Candidate> = Vec::new();
    if aims.len() < 2 || go.along.iter().any(Option::is_some) {
        return all;
    }
    let axis = coming(&go.axis, aims, &pose);
    let solver = Solver { aims, axis: &axis, onwards: onwards(&axis, aims, &pose), held: None };
    let band = solver.narrowest();
    let by = end.te - pose.te;
    let near = 1e-3 * band + 1e-9 * solver.size(&pose);
    for aim in aims.iter().filter(|a| !a.keep.is_plane()) {
        let normal = aim.keep.surface.foot(pose.te).normal;
        let Some(m) = pose.ta.cross(&normal).try_normalize(1e-6) else { continue };
        let across = m.dot(&by);
        if across.abs() <= 10.0 * (band + near) {
            continue;
        }
        let from = Pose { te: end.te - m * (2.0 * across), ..pose };
        let Ok(other) = solver.nearest(from, pose) else { continue };
        let tie = ((other.te - pose.te).norm() - by.norm()).abs() <= near;
        // Where the tool comes to all but evenly the nearest place is found to some bands only.
        let mirrored = m.dot(&(other.te - pose.te)) * across < 0.0;
        let apart = |te: Vec3| (te - other.te).norm() > 10.0 * (band + near);
        if tie && mirrored && apart(end.te) && all.iter().all(|c| apart(c.te)) {
            all.push(Candidate::of(pose.te, other.te));
        }
    }
    all
}

/// The rule of the axis for a tool that comes from `pose`.
fn coming(axis: &AxisRule, aims: &[Aim<'_>], pose: &Pose) -> AxisRule {
    let other = match axis.angle_to() {
        Some(OptionSurface::Part) => aims.first(),
        Some(OptionSurface::Drive) => aims.get(1),
        None => None,
    };
    other.map_or_else(
        || axis.clone(),
        |o| {
            let foot = o.keep.surface.foot(pose.te);
            let axis = axis.coming(Came::from(foot.distance, o.keep.width()));
            let on = o.keep.condition == Condition::On;
            if on { axis.leaning(pose.ta, foot.normal) } else { axis }
        },
    )
}

/// The normal of the surface that controls the axis, on the side away from where the tool comes: an axis upright on it leans
/// that way once the tool end lies on it. Source: what APT-360 does. Zero where the tool does not come from beside it.
fn onwards(axis: &AxisRule, aims: &[Aim<'_>], pose: &Pose) -> Vec3 {
    let aim = match axis.normal_of() {
        Some(OptionSurface::Part) => aims.get(1),
        Some(OptionSurface::Drive) => aims.first(),
        None => None,
    };
    aim.map_or_else(Vec3::zeros, |aim| {
        let foot = aim.keep.surface.foot(pose.te);
        match Came::from(foot.distance, aim.keep.width()) {
            Came::There => Vec3::zeros(),
            from => foot.normal * from.onwards(),
        }
    })
}

fn solve(go: &Start, aims: &[Aim<'_>], pose: Pose) -> Result<Pose, Failure> {
    let axis = coming(&go.axis, aims, &pose);
    let solver = Solver { aims, axis: &axis, onwards: onwards(&axis, aims, &pose), held: None };
    let free = go.surfaces.len() == 1 && go.part.is_none();
    let others = go.along.iter().skip(1).any(Option::is_some);
    match go.along.first().copied().flatten() {
        Some(v) if go.offset => solver.offset(pose, v),
        Some(v) if free => solver.along(pose, v),
        Some(v) if go.on_the_same_part(pose.te) && aims.len() == 2 && !others => {
            let from = solver.approach(pose);
            let held = solver.plane_along(from, v)?;
            let found = Solver { held, ..solver }.nearest(from, pose);
            found.map_err(|failure| match failure {
                Failure::NoStart { left, .. } if held.is_some() => Failure::Misses {
                    surface: aims[0].wall.surface.clone(),
                    closest: left.first().map_or(0.0, |(_, gap)| gap.abs()),
                },
                other => other,
            })
        }
        _ => {
            let (from, before) = solver.let_down(solver.approach(pose));
            let found = solver.nearest(from, pose);
            let other = before.and_then(|from| solver.nearest(from, pose).ok());
            let far = |end: &Pose| (end.te - pose.te).norm();
            let nearer = |other: &Pose| found.as_ref().map_or(true, |end| far(other) < far(end));
            let found = other.filter(nearer).map_or(found, Ok);
            found.or_else(|failure| solver.by_a_plane(pose).ok_or(failure))
        }
    }
}

/// The side on which the tool is to be: TO where it is, PAST on the other. Along a surface that `rules` the axis, its
/// normal, the axis before says where a point is.
fn aim(
    go: &Start,
    relation: Relation,
    wall: &Wall,
    to_past: Option<Vec3>,
    rules: bool,
) -> Result<Keep, Failure> {
    let mut keep = Keep::of(wall)?;
    if wall.on {
        return Ok(keep);
    }
    let pose = &Pose { te: go.tool.te, ta: go.tool.ta };
    // What is asked for more than once.
    let outside = to_past.is_none().then(|| keep.on_side(Side::Positive).gap(pose, None).ok());
    let outside = outside.flatten();
    let near = match to_past {
        Some(v) => {
            let n = keep.surface.foot(pose.te).normal;
            if n.dot(&v) > 0.0 { keep.inner(pose) } else { Side::Positive }
        }
        None if let Some(side) = rests_on(&keep, pose, outside.as_ref(), rules) => side,
        None if let Some(side) = left_on(go, wall, &keep) => side,
        None if let Some(side) = beside_itself(&keep, pose) => side,
        None if both(&keep, pose, 1.0) => Side::Positive,
        None if both(&keep, pose, -1.0) => keep.inner(pose),
        None if let Some(side) = cut_through(&keep, pose, outside.as_ref()) => side,
        None => {
            let apart = || Failure::NoContact { surface: wall.surface.clone() };
            let fits = outside.filter(|g| g.g >= 0.0).map(|g| (g.g, Side::Positive));
            let (gap, side) = fits
                .map_or_else(|| clearance(&keep, pose), Ok)
                .ok()
                .filter(|found| !only_other_told(&keep, pose, *found))
                .map_or_else(|| clearance(&flattened(&keep, pose), pose), Ok)
                .map_err(|_| apart())?;
            let other = keep.on_side(opposite(side));
            let near = 1e-3 * keep.width();
            let alike = |g: Gap| (g.g - gap).abs() <= near;
            let beside =
                keep.profile.widest() > 0.0 && !(gap >= 0.0 && keep.deep(pose, other.side, near));
            let tie = beside && other.gap(pose, None).is_ok_and(alike);
            if tie { Side::Negative } else { side }
        }
    };
    keep.side = match (relation, near) {
        (Relation::Past, Side::Positive) => keep.inner(pose),
        (Relation::Past, Side::Negative | Side::Open) => Side::Positive,
        _ => near,
    };
    Ok(keep)
}

/// The side of a sculptured surface itself on which tool end and middle of the cutter both lie: from far away what goes on straight
/// beyond its borders may be nearer, and stand over it.
fn beside_itself(keep: &Keep, pose: &Pose) -> Option<Side> {
    let Surface::Parametric(surface) = &keep.surface else { return None };
    let middle = pose.te + pose.ta * (0.5 * keep.profile.height());
    let [end, above] = [pose.te, middle].map(|p| surface.side_of_itself(p));
    let side = end.filter(|_| end == above)?;
    Some(if side > 0.0 { Side::Positive } else { keep.inner(pose) })
}

/// Are tool end and the middle of the cutter both outside of a surface that closes round the tool (`sign` 1), or inside of
/// it (-1)? However deep the cutter cuts in from there, it is that side that is meant. Source: what APT-360 does.
fn both(keep: &Keep, pose: &Pose, sign: f64) -> bool {
    let middle = pose.te + pose.ta * (0.5 * keep.profile.height());
    let there = |p: Vec3| sign * keep.surface.distance(p) > keep.width();
    opens(&keep.surface, pose.ta) && there(pose.te) && there(middle)
}

/// Is the tool deep in on the side that was found, and has it no place of contact on the other one? A flank that goes by the end
/// of a surface faces nothing there: that it could be told on one side only does not say that the tool is on that one.
fn only_other_told(keep: &Keep, pose: &Pose, (gap, side): (f64, Side)) -> bool {
    gap < -keep.width() && keep.on_side(opposite(side)).gap(pose, None).is_err()
}

fn opposite(side: Side) -> Side {
    match side {
        Side::Positive => Side::Negative,
        Side::Negative | Side::Open => Side::Positive,
    }
}

/// The side on which the middle of a cutter lies that the surface cuts through, so that neither side is free: a cutter beside
/// a wall that leans over it. Source: what APT-360 does.
fn cut_through(keep: &Keep, pose: &Pose, outside: Option<&Gap>) -> Option<Side> {
    let middle = pose.te + pose.ta * (0.5 * keep.profile.height());
    let there = keep.surface.distance(middle);
    let inner = keep.inner(pose);
    let in_it = |gap: &Gap| gap.g < -keep.width();
    let through = in_it(outside?) && in_it(&keep.on_side(inner).gap(pose, None).ok()?);
    let clear = through && !opens(&keep.surface, pose.ta) && there.abs() > keep.width();
    clear.then_some(if there > 0.0 { Side::Positive } else { inner })
}

/// The side on which the motion before left a disk, in its band: that of this start-up may be narrower, and be left on that side alone.
fn left_on(go: &Start, wall: &Wall, keep: &Keep) -> Option<Side> {
    wall.disk?;
    let pose = Pose::standing(&go.tool);
    let left = |side: Side| {
        let band = wall.band_in(go.ended.as_ref(), side);
        band.is_some_and(|b| keep.on_side(side).gap(&pose, None).is_ok_and(|g| within(&g, b)))
    };
    let mut sides = [Side::Positive, keep.inner(&pose)].into_iter();
    sides.find(|side| left(*side))
}

/// The side towards which a point or a thin disk stands that is within the band on both, or anywhere when it is a point
/// whose axis follows the surface.
fn rests_on(keep: &Keep, pose: &Pose, outside: Option<&Gap>, rules: bool) -> Option<Side> {
    let inner = keep.inner(pose);
    let anywhere = rules && keep.profile.reach() == 0.0;
    let lean =
        |gap: &Gap| (anywhere || gap.g.abs() <= keep.width()).then(|| gap.normal.dot(&pose.ta));
    let outside = lean(outside?)?;
    let inside = lean(&keep.on_side(inner).gap(pose, None).ok()?)?;
    ((outside - inside).abs() > 0.1).then_some(if outside > inside {
        Side::Positive
    } else {
        inner
    })
}
