//! How a motion begins (APT: `AREPRE`): on which sides of the surfaces the tool stands, whether it is in their bands, and which
//! way it goes.

use aptc_cldata::Position;
use aptc_contact::{Condition, Gap, Side};
use aptc_geometry::Vec3;
use aptc_protap::OptionSurface;

use super::band::Band;
use super::guided::Guides;
use super::keep::{Keep, Limits, Pose, within};
use super::pace::Pace;
use super::placing::{placing, put};
use super::refusal::trouble_at;
use super::track::{Aim, Node, Track};
use crate::axis::{Around, AxisRule};
use crate::failure::Failure;
use crate::prepare::way;
use crate::scene::{Astray, Scene, Stance, Wall};
use crate::state::Tool;

/// The tool at the start of a motion.
pub(super) struct Begin {
    pub(super) track: Track,
    pub(super) node: Node,
    /// The first positions, when the tool must first be put in place or turn there.
    pub(super) first: Vec<Position>,
    pub(super) astray: Option<Astray>,
}

/// Does the axis turn in place when a motion begins?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum InPlace {
    /// Where it cannot turn with the first cut vector.
    AsNeeded,
    /// However little it turns.
    Always,
}

pub(super) fn begin(scene: &Scene, turns: InPlace) -> Result<Begin, Failure> {
    let turns_first = !scene.tool.stands() && !scene.axis.turns();
    match scene.tool.stood.filter(|_| turns_first) {
        Some(stood) => to_fixed(scene, stood),
        None => as_it_stands(scene, turns),
    }
}

/// The start of a motion with a fixed axis of a tool that stands there with another one: it turns in place. Where it does not stand
/// in place with that, as after FROM, it has the new one.
fn to_fixed(scene: &Scene, stood: Vec3) -> Result<Begin, Failure> {
    let with = |te: Vec3, ta: Vec3| {
        let tool = Tool { te, ta, stood: None, ..scene.tool };
        as_it_stands(&Scene { tool, ..scene.clone() }, InPlace::AsNeeded)
    };
    let Ok(Begin { track, node, mut first, .. }) = with(scene.tool.te, stood) else {
        return with(scene.tool.te, scene.tool.ta);
    };
    let still = Track { guides: None, ..track };
    let axes = [stood, scene.tool.ta];
    let pose = Pose { ta: scene.tool.ta, ..node.pose };
    let to = still.settle(pose, &placing(&still, &node)).ok();
    let way = to.and_then(|to| way_to(&still, &node, to));
    let way = way.ok_or(Failure::NoTurn { place: node.pose.te, axes })?;
    first.extend(way.iter().map(|n| n.pose.position()));
    let end = way.last().map_or(node.pose.te, |n| n.pose.te);
    let turned = with(end, scene.tool.ta)?;
    first.extend(&turned.first);
    Ok(Begin { first, ..turned })
}

fn as_it_stands(scene: &Scene, turns: InPlace) -> Result<Begin, Failure> {
    let tool = &scene.tool;
    let mut part = Keep::of(&scene.part)?;
    let pose = upright(scene, &part);
    let mut drive = Keep::of(&scene.drive)?;
    let apart = |w: &Wall| Failure::NoContact { surface: w.surface.clone() };
    let part_gap = if scene.part.on {
        part.gap(&pose, None).map_err(|_| apart(&scene.part))?
    } else {
        let rule = scene.axis.normal_of() == Some(OptionSurface::Part);
        let near = nearer(scene, &scene.part, &part, &pose, rule);
        let (gap, side) = near.ok_or_else(|| apart(&scene.part))?;
        part.side = side;
        gap
    };
    // The direction of the track from the normals as they are; the side of the drive surface does not
    // change it.
    let probe = drive.surface.foot(pose.te).normal;
    let line = probe.cross(&part_gap.normal);
    if line.norm() <= 1e-7 {
        return Err(Failure::SideBySide {
            drive: scene.drive.surface.clone(),
            part: scene.part.surface.clone(),
        });
    }
    let heading = way(tool, scene.direction, line.normalize())?;
    if !scene.drive.on {
        let left = tool.ta.cross(&heading);
        let lean = probe.dot(&left);
        let wanted = lean * scene.stance.left();
        drive.side = if wanted.abs() < 1e-3 || scene.stance == Stance::AsItStands {
            let rule = scene.axis.normal_of() == Some(OptionSurface::Drive);
            let near = nearer(scene, &scene.drive, &drive, &pose, rule);
            near.ok_or_else(|| apart(&scene.drive))?.1
        } else if wanted > 0.0 {
            Side::Positive
        } else if left_whole(scene, &scene.drive, &drive, &pose) {
            Side::Negative
        } else {
            drive.below(&pose)
        };
    }
    let astray = across(scene, &mut drive, &pose);
    let drive_gap = drive.gap(&pose, None).map_err(|_| apart(&scene.drive))?;
    let off_drive = placed(&drive, &drive_gap);
    let off_part = placed(&part, &part_gap);
    // Where the motion before left it within wider bands it comes into these first.
    let stands = |off: f64, gap: &Gap, wall: &Wall, keep: &Keep| {
        off <= 2.0 || left(scene, wall, keep.side, gap)
    };
    if !stands(off_drive, &drive_gap, &scene.drive, &drive) {
        return Err(misplaced(scene, &drive, &drive_gap));
    }
    if !stands(off_part, &part_gap, &scene.part, &part) {
        return Err(Failure::OffPart {
            surface: scene.part.surface.clone(),
            off: part_gap.g,
            allowed: allowed(&part, &part_gap),
            outside: part_gap.g > 0.0,
        });
    }
    let rules = match scene.axis.normal_of() {
        Some(OptionSurface::Part) => Some((&scene.part, &part_gap)),
        Some(OptionSurface::Drive) => Some((&scene.drive, &drive_gap)),
        None => None,
    };
    if let Some((wall, gap)) = rules {
        stands_upright(wall, gap, &pose)?;
    }
    let size =
        pose.te.norm() + drive.profile.reach() + drive.surface.extent() + part.surface.extent();
    let exact = 1e-13 * size + 2e-9 * drive.width().min(part.width());
    let keeps = [drive, part];
    let (te, ta) = (pose.te, pose.ta);
    let around = Around { te, ta, part: &part_gap, drive: &drive_gap, along: heading };
    let axis = sided(scene, &keeps, &around).begun(&around, [&keeps[0], &keeps[1]]);
    let guides = Guides::new(&keeps, &axis, &pose);
    let bands = keeps.each_ref().map(|keep| Band::new(keep, size, axis.turns()));
    let track = Track { keeps, bands, axis, guides, exact, size };
    let node = track
        .finish(pose, [drive_gap, part_gap], heading)
        .map_err(|t| trouble_at(scene, &pose, t))?;
    let stays = off_drive <= 1.0 && off_part <= 1.0;
    // Where the old axis gave way the tool turns about its end before it goes anywhere.
    let gave_way = (pose.ta - tool.ta).norm() > 0.0;
    let mut way = Vec::from_iter(gave_way.then_some(node));
    if !stays {
        way.push(put(&track, &node).map_err(|t| trouble_at(scene, &pose, t))?);
    }
    let node = way.last().copied().unwrap_or(node);
    way.extend(turn(&track, &node, scene.limits.step, turns)?);
    let node = way.last().copied().unwrap_or(node);
    let first = way.iter().map(|n| n.pose.position()).collect();
    Ok(Begin { track, node, first, astray })
}

/// Refuses a disk that an axis, which is to be the normal of the surface or at an angle to it, would turn over: it came from the side
/// that the axis points into, and the cutter above it would go through the surface.
fn stands_upright(wall: &Wall, gap: &Gap, pose: &Pose) -> Result<(), Failure> {
    /// Cosine between axis and normal from which it stands on its head.
    const OVER: f64 = -0.5;
    if wall.disk.is_none() || wall.on || gap.normal.dot(&pose.ta) > OVER {
        return Ok(());
    }
    let (place, axes) = (pose.te, [pose.ta, gap.normal]);
    Err(Failure::TurnsOver { surface: wall.surface.clone(), place, axes })
}

/// The rule of the axis with the side of the other surface to which it leans, where the tool end lies on that: as the
/// axis stands, and as it will stand by that.
fn sided(scene: &Scene, keeps: &[Keep; 2], around: &Around<'_>) -> AxisRule {
    let other = match scene.axis.angle_to() {
        Some(OptionSurface::Part) => around.drive,
        Some(OptionSurface::Drive) => around.part,
        None => return scene.axis.clone(),
    };
    let rule = scene.axis.leaning(around.ta, other.normal);
    let on_it = other.segment.is_none();
    match rule.at(around, [&keeps[0], &keeps[1]]) {
        Some(ta) if on_it => rule.leaning(ta, other.normal),
        _ => rule,
    }
}

/// The way in place to the axis that the rule asks for at the start, when the tool stands with another one: GO does not know the
/// direction of the motion that follows, on which CUTANG depends. Empty when the axis can turn with the first cut vector.
fn turn(track: &Track, node: &Node, cap: f64, turns: InPlace) -> Result<Vec<Node>, Failure> {
    let Some(to) = turned(track, node, cap, turns) else { return Ok(Vec::new()) };
    let axes = [node.pose.ta, to.pose.ta];
    way_to(track, node, to).ok_or(Failure::NoTurn { place: node.pose.te, axes })
}

fn way_to(track: &Track, node: &Node, to: Node) -> Option<Vec<Node>> {
    /// How high in their bands the places of the way lie, the first that serves: a chord dips or rises between its ends.
    const HIGH: [f64; 3] = [0.5, 0.9, 0.1];
    HIGH.into_iter().find_map(|high| turning(track, node, to, high))
}

/// The way from one axis to the other by places so high in their bands, each chord in both bands; `None` where there is none.
fn turning(track: &Track, from: &Node, to: Node, high: f64) -> Option<Vec<Node>> {
    /// Places and halvings at most.
    const MOST: usize = 4000;
    /// Axes closer to each other have no way between them.
    const LEAST: f64 = 1e-6;
    let still = Track { axis: AxisRule::Fixed, guides: None, ..track.clone() };
    let targets = track.keeps.each_ref().map(|keep| {
        let limits = keep.limits();
        limits.low + high * (limits.high - limits.low)
    });
    let across = from.course.along;
    let (mut way, mut ahead) = (vec![*from], vec![to]);
    for _ in 0..MOST {
        let (Some(here), Some(next)) = (way.last().copied(), ahead.last().copied()) else { break };
        if track.holds(&here, &next) {
            way.extend(ahead.pop());
            continue;
        }
        if (here.pose.ta - next.pose.ta).norm() <= LEAST {
            return None;
        }
        let ta = (here.pose.ta + next.pose.ta).try_normalize(0.0)?;
        // All in the plane across the track at the start: on the way along it check surfaces may stand.
        let middle = (here.pose.te + next.pose.te) * 0.5;
        let te = middle + across * across.dot(&(from.pose.te - middle));
        let aim = Aim { across, targets, ..Aim::at(&here) };
        ahead.push(still.settle(Pose { te, ta }, &aim).ok()?);
    }
    ahead.is_empty().then(|| way.split_off(1))
}

/// The end of that way.
fn turned(track: &Track, node: &Node, cap: f64, turns: InPlace) -> Option<Node> {
    /// What APT-360 allows an axis to be off, radians; so much the first cut vector takes up.
    const LEAST: f64 = 0.01;
    /// Share of the usual length that the first cut vector must have if the axis is to turn with it.
    const WORTH: f64 = 0.1;
    if !track.axis.turns() {
        return None;
    }
    let [drive, part] = &node.gaps;
    let around =
        Around { te: node.pose.te, ta: node.pose.ta, part, drive, along: node.course.along };
    let ta = track.axis.at(&around, [&track.keeps[0], &track.keeps[1]])?;
    if (ta - node.pose.ta).norm() <= LEAST {
        return None;
    }
    let turned = track.settle(Pose { ta, ..node.pose }, &placing(track, node)).ok()?;
    if turns == InPlace::Always {
        return Some(turned);
    }
    let length = |node: &Node| track.stride(node, cap, &mut Pace::new()).map_or(0.0, |s| s.length);
    (length(node) < WORTH * length(&turned)).then_some(turned)
}

/// How the tool stands when a motion begins. With TLAXIS/NORMPS an axis from elsewhere, with which the tool is
/// off the part surface, gives way to the normal below the tool end.
fn upright(scene: &Scene, part: &Keep) -> Pose {
    let tool = &scene.tool;
    let pose = Pose { te: tool.te, ta: tool.ta };
    let sides = if part.condition == Condition::On { 1 } else { usize::MAX };
    let stands = |s: Side| {
        let keep = part.on_side(s);
        let there = |g: &Gap| placed(&keep, g) <= 2.0 || left(scene, &scene.part, s, g);
        keep.gap(&pose, None).is_ok_and(|g| there(&g))
    };
    let normal = part.surface.foot(tool.te).normal;
    let lean = normal.dot(&tool.ta);
    // Where the old axis lies in the surface it does not say which side is meant.
    let rule = matches!(scene.axis, AxisRule::Normal(OptionSurface::Part)) && lean.abs() >= 1e-3;
    if !rule || part.sides(&pose).take(sides).any(stands) {
        return pose;
    }
    Pose { ta: normal * lean.signum(), ..pose }
}

/// The side on which the tool is nearer to touching.
///
/// A disk touches from below as well as from above within the band: it is that side towards which the rest of the cutter stands on it;
/// where it is in one band alone, as a needle beside a wall or a disk that came from below, the side of that band. Where the motion
/// before left it in a wider band it is in place as well, and an axis whose `rule` is the normal of the surface stands on the side to
/// which it points: on the other one it would turn over.
fn nearer(scene: &Scene, wall: &Wall, keep: &Keep, pose: &Pose, rule: bool) -> Option<(Gap, Side)> {
    let gap = |side: Side| keep.on_side(side).gap(pose, None).ok().map(|g| (g, side));
    let was = |(g, side): &(Gap, Side)| left(scene, wall, *side, g);
    let at = |near: &(Gap, Side)| near.0.g.abs() <= 2.0 * keep.width() || was(near);
    let better = |a: &(Gap, Side), b: &(Gap, Side)| {
        let both = at(a) && at(b);
        let lean = (b.0.normal - a.0.normal).dot(&pose.ta);
        let off = [a, b].map(|near| if was(near) { 0.0 } else { placed(keep, &near.0) });
        let alike = rule || (off[0] <= 1.0) == (off[1] <= 1.0);
        if both && alike && lean.abs() > 1e-3 {
            lean > 0.0
        } else if was(a) != was(b) {
            was(b)
        } else if both {
            off[1] < off[0]
        } else {
            b.0.g.abs() < a.0.g.abs()
        }
    };
    let mut best: Option<(Gap, Side)> = None;
    let whole = left_whole(scene, wall, keep, pose);
    for side in keep.sides(pose).filter(|side| !(whole && *side == Side::Open)) {
        // A tool in place on one side is not nearer to another one that it is deep in.
        let deep =
            || keep.deep(pose, side, 2.0 * keep.width()) && scene.left_in(wall, side).is_none();
        if best.as_ref().is_some_and(|b| at(b) && deep()) {
            continue;
        }
        best = match (best, gap(side)) {
            (Some(best), Some(next)) if better(&best, &next) => Some(next),
            (best, next) => best.or(next),
        };
    }
    best
}

/// Did the motion before leave the tool so on that side of a surface, in its band?
fn left(scene: &Scene, wall: &Wall, side: Side, gap: &Gap) -> bool {
    scene.left_in(wall, side).is_some_and(|band| within(gap, band))
}

/// Did it leave the tool in the surface as a whole? In a narrower band it would seem to be deep in the roof, and the hollow open.
fn left_whole(scene: &Scene, wall: &Wall, keep: &Keep, pose: &Pose) -> bool {
    let there = |g: &Gap| left(scene, wall, Side::Negative, g);
    let gap = || keep.on_side(Side::Negative).gap(pose, None).ok();
    scene.left_whole(wall) && gap().is_some_and(|g| there(&g))
}

/// How many bands the tool is from its place: up to one it is in the band.
fn placed(keep: &Keep, gap: &Gap) -> f64 {
    let slack = 1e-6 * keep.width();
    let Limits { low, high } = keep.in_place();
    if gap.g >= low - slack && gap.g <= high + slack {
        return 0.0;
    }
    let off = if gap.g < low { low - gap.g } else { gap.g - high };
    1.0 + off / keep.width()
}

/// How far off its surface the tool may be to be in place: its band, and the width of that beside it.
fn allowed(keep: &Keep, gap: &Gap) -> f64 {
    keep.width() + if gap.g > 0.0 { keep.outtol } else { keep.intol }
}

/// A tool that is in place on the other side than the word says stays there.
fn across(scene: &Scene, drive: &mut Keep, pose: &Pose) -> Option<Astray> {
    let astray = scene.stance.astray()?;
    let there =
        |keep: &Keep, g: &Gap| placed(keep, g) <= 2.0 || left(scene, &scene.drive, keep.side, g);
    let fits = |keep: &Keep| keep.gap(pose, None).is_ok_and(|g| there(keep, &g));
    let other = match drive.side {
        Side::Positive => drive.on_side(drive.inner(pose)),
        Side::Negative | Side::Open => drive.on_side(Side::Positive),
    };
    if fits(drive) || !fits(&other) {
        return None;
    }
    *drive = other;
    Some(astray)
}

fn misplaced(scene: &Scene, keep: &Keep, gap: &Gap) -> Failure {
    let surface = scene.drive.surface.clone();
    let allowed = allowed(keep, gap);
    let off = if scene.drive.on { gap.g.abs() } else { gap.g };
    Failure::OffDrive { surface, off, allowed, outside: off > 0.0 }
}
