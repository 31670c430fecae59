//! One motion along any two surfaces (APT: `AREPRE`, `ARLM3`).

use std::collections::VecDeque;

use aptc_cldata::{Control, Controlled, Position};
use aptc_contact::{Condition, Gap, Side};
use aptc_geometry::{Profile, Surface, Vec3};
use aptc_protap::{OptionSurface, Relation};

use super::band::Band;
use super::blocked::{Cause, cause};
use super::guided::Guides;
use super::keep::{Keep, Pose};
use super::nearest::approach;
use super::stride::Pace;
use super::track::{Node, Track, Trouble};
use super::watch::{Halt, Mark, Watch, clearance};
use crate::axis::{Around, AxisRule};
use crate::failure::{Blocked, Failure, Hindrance};
use crate::prepare::way;
use crate::scene::{Astray, Path, Scene, Stance, Wall, to_or_on};

/// Cut vectors that turn back before a motion counts as caught between two places of contact: a path may have
/// a cusp, but a tool that is caught goes to and fro.
const MOST_BACK: u32 = 3;
/// Cut vectors one after another that are shorter than the band is wide before a motion counts as caught: an edge or a
/// corner that the band rounds is passed in a few.
const MOST_CREEPS: u32 = 60;
/// How often the way to the check surface may be cut shorter, because its last cut vector leaves the bands.
const MOST_SHORTENED: u32 = 20;
/// Share of a cut vector by which a track that has come back may pass beside its start, where it may have an edge.
const BESIDE: f64 = 0.1;
/// Cut vectors before a corner that one may stand for.
const MERGED: usize = 8;
/// How far a tool goes from its start, in sizes of the scene: what it has not met there it never does.
const FAR: f64 = 1e3;
/// Sine below which a track is along rulings.
const PARALLEL: f64 = 1e-9;
/// Cut vectors of one motion when NUMPTS does not say.
const MOST_VECTORS: u32 = 20_000;

/// The path of a motion.
///
/// A turning axis may lay the cutter's side into a hollow drive surface that its lower edge just touches.
/// Then the motion follows the lower edge, and says how deep the rest cuts in.
pub(crate) fn run(scene: &Scene) -> Result<Path, Failure> {
    let failure = match begin(scene) {
        Ok(begin) => return follow(scene, &begin),
        Err(f) => f,
    };
    let Failure::OffDrive { off, .. } = failure else { return Err(failure) };
    if !scene.axis.turns() || off >= 0.0 || scene.drive.on {
        return Err(failure);
    }
    let [_, [radius, height]] = scene.drive.profile.joints();
    let Ok(edge) = Profile::disk(radius, height) else { return Err(failure) };
    let mut lower = scene.clone();
    lower.drive.profile = edge;
    lower.drive.disk = Some([radius, height]);
    match begin(&lower) {
        Ok(begin) => follow(&lower, &begin).map(|path| Path { fouls: Some(-off), ..path }),
        Err(_) => Err(failure),
    }
}

fn follow(scene: &Scene, begin: &Begin) -> Result<Path, Failure> {
    let mut watches: Vec<Watch> = Vec::with_capacity(scene.checks.len());
    for check in &scene.checks {
        let keep = keep(&check.wall, Side::Positive)?;
        watches.push(Watch::new(&keep, check.relation, check.nth, &begin.node.pose));
    }
    let track = &begin.track;
    let (cap, straight) = longest(scene, begin, &watches);
    let most = scene.limits.vectors.unwrap_or(MOST_VECTORS);
    let mut node = begin.node;
    let mut points: Vec<Position> = begin.first.iter().copied().collect();
    let mut loops = Loops::new(&node);
    let (mut pace, mut gone) = (Pace::new(), 0.0);
    let mut spent = Some(most);
    let (mut last, mut back) = (Vec3::zeros(), 0);
    let mut marks: Vec<Mark> = Vec::with_capacity(watches.len());
    let least = track.keeps.iter().map(Keep::width).fold(f64::INFINITY, f64::min);
    let mut creeps = 0;
    let (mut reach, mut shortened) = (cap, 0);
    let mut vectors = 0;
    // The last nodes since the start or a corner.
    let mut trail: VecDeque<Node> = VecDeque::with_capacity(MERGED);
    // Is it at a corner?
    let mut cornered = true;
    // Where a straight track meets other check surfaces than planes is not known before.
    let planes = scene.checks.iter().all(|c| matches!(c.wall.fitted, Some(Surface::Plane(_))));
    let far = if along_rulings(begin) && planes {
        beyond(scene, begin, &watches)
    } else {
        FAR * scene.checks.iter().map(|c| extent(&c.wall)).fold(track.size, f64::max)
    };
    while vectors < most {
        // Most of a path is far from all check surfaces.
        let free = watches.iter().map(Watch::free).fold(f64::INFINITY, f64::min);
        if free > 0.0 && reach >= cap && !straight {
            let met: u32 = watches.iter().map(|w| w.account().0).sum();
            let (ta, mut round) = (node.pose.ta, false);
            let cruised = track.cruise(&node, cap, &mut pace, free, |[from, to], along| {
                let way = to - from;
                let length = way.norm();
                if round || vectors >= most || length < least {
                    return false;
                }
                (vectors, gone, last) = (vectors + 1, gone + length, way);
                points.push(Position { te: to, ta });
                round = loops.closed(from, to, along, met);
                true
            });
            if let Some(to) = cruised {
                node = to;
                (creeps, cornered) = (0, false);
                trail.clear();
                watches.iter_mut().for_each(Watch::moved);
            }
            if round {
                spent = None;
                break;
            }
            if vectors >= most {
                break;
            }
        }
        let mut leave = None;
        let stride = match track.stride(&node, reach, &mut pace) {
            Ok(s) => s,
            Err(t) => match track.corner(&node) {
                // A place with a corner after a corner at it leads nowhere.
                Some(c) if c.arrive.length > track.exact || !cornered => {
                    leave = Some(c.leave);
                    c.arrive
                }
                _ => return Err(blocked(scene, begin, &watches, &node, gone, t)),
            },
        };
        reach = cap;
        marks.clear();
        marks.extend(watches.iter().map(Watch::mark));
        let mut stop: Option<(usize, Halt)> = None;
        for (i, w) in watches.iter_mut().enumerate() {
            let check = &scene.checks[i].wall;
            let unmet = |t| match t {
                Trouble::Check => Failure::NoContact { surface: check.surface.clone() },
                t => trouble_at(scene, &node.pose, t),
            };
            let halt = w.scan(track, &node, &stride).map_err(unmet)?;
            if let Some(h) = halt
                && stop.as_ref().is_none_or(|(_, s)| h.s < s.s)
            {
                stop = Some((i, h));
            }
        }
        if let Some((i, mut halt)) = stop {
            // A place that the cut vector before ended at needs no other. The last one ends where the gaps were to be farther on;
            // where the surface changes its bend on the way that does not fit, and a cut vector made for that length does.
            let here = halt.s <= track.exact && !points.is_empty();
            if !here && (halt.beside || !track.fits(&node, &halt.node)) {
                let shorter = track.stride(&node, halt.s, &mut pace);
                let again = shorter.and_then(|s| watches[i].again(track, &node, &s, &halt));
                match again.ok().filter(|h| track.fits(&node, &h.node)) {
                    Some(made) => halt = made,
                    None if shortened < MOST_SHORTENED => {
                        // One cut vector more on the way there.
                        watches.iter_mut().zip(&marks).for_each(|(w, m)| w.back_to(m));
                        reach = 0.5 * halt.s;
                        shortened += 1;
                        continue;
                    }
                    // The proof of the path says by how much it is off.
                    None => {}
                }
            }
            if !here {
                points.push(position(&halt.node.pose));
            }
            return Ok(Path {
                points,
                arc: None,
                turned: begin.turned,
                check: i,
                forward: halt.node.course.along,
                control: control(scene, track, &watches, i, &halt),
                fouls: None,
                astray: begin.astray,
                rivals: Vec::new(),
            });
        }
        let way = stride.to.pose.te - node.pose.te;
        let returns = way.dot(&last) < 0.0 && leave.is_none();
        // A tool end on a surface that ends finds no way on there, only the one that it came.
        if returns && (0..2).any(|i| track.keeps[i].ends_below(&node.gaps[i])) {
            return Err(blocked(scene, begin, &watches, &node, gone, Trouble::Contact));
        }
        back += u32::from(returns);
        last = if leave.is_none() { way } else { Vec3::zeros() };
        if back >= MOST_BACK {
            return Err(blocked(scene, begin, &watches, &node, gone, Trouble::Stuck));
        }
        gone += way.norm();
        creeps = if way.norm() < least { creeps + 1 } else { 0 };
        if creeps >= MOST_CREEPS {
            return Err(blocked(scene, begin, &watches, &node, gone, Trouble::Stuck));
        }
        vectors += 1;
        if trail.len() >= MERGED {
            trail.pop_front();
        }
        trail.push_back(node);
        if let Some(leave) = leave {
            // The cut vectors before a corner come ever shorter: one that ends at it stands for them.
            let short = |t: &Node| (stride.to.pose.te - t.pose.te).norm() <= cap;
            let fits = |t: &Node| short(t) && track.fits(t, &stride.to);
            let kept = trail.iter().position(fits).unwrap_or(trail.len() - 1);
            points.truncate(points.len().saturating_sub(trail.len() - 1 - kept));
            points.push(position(&stride.to.pose));
            trail.clear();
            (node, cornered) = (leave, true);
            continue;
        }
        points.push(position(&stride.to.pose));
        if (stride.to.pose.te - begin.node.pose.te).norm() > far {
            spent = None;
            break;
        }
        let met: u32 = watches.iter().map(|w| w.account().0).sum();
        if straight || loops.closed(node.pose.te, stride.to.pose.te, stride.to.course.along, met) {
            spent = None;
            break;
        }
        (node, cornered) = (stride.to, false);
    }
    Err(not_reached(scene, &watches, begin.node.pose, &points, gone, spent))
}

fn position(p: &Pose) -> Position {
    Position { te: p.te, ta: p.ta }
}

fn extent(wall: &Wall) -> f64 {
    wall.fitted.as_ref().map_or(0.0, Surface::extent)
}

/// Greatest length of a cut vector, and whether the track is one straight line.
fn longest(scene: &Scene, begin: &Begin, watches: &[Watch]) -> (f64, bool) {
    let track = &begin.track;
    if !track.keeps.iter().all(Keep::is_plane) || track.axis.turns() {
        return (scene.limits.step, false);
    }
    (beyond(scene, begin, watches), true)
}

/// A length of a straight track that passes whatever the check surfaces have on it.
fn beyond(scene: &Scene, begin: &Begin, watches: &[Watch]) -> f64 {
    let size = scene.checks.iter().map(|c| extent(&c.wall)).fold(scene.tool.te.norm(), f64::max);
    let planes = watches.iter().map(|w| w.ahead(&begin.node)).fold(0.0, f64::max);
    8.0 * (size + begin.track.keeps[0].profile.reach()) + 2.0 * planes
}

/// Is the track one straight line, along the rulings of surfaces whose rulings are parallel and in planes?
fn along_rulings(begin: &Begin) -> bool {
    let along = begin.node.course.along;
    let straight = |k: &Keep| {
        let across = |g: Vec3| g.normalize().cross(&along).norm();
        k.is_plane() || k.surface.generator().is_some_and(|g| across(g) <= PARALLEL)
    };
    !begin.track.axis.turns() && begin.track.keeps.iter().all(straight)
}

/// Notices a track that has come back to its start.
struct Loops {
    start: Pose,
    along: Vec3,
    vectors: u32,
    met: u32,
}

impl Loops {
    fn new(node: &Node) -> Self {
        Self { start: node.pose, along: node.course.along, vectors: 0, met: 0 }
    }

    /// Has it passed its start again without meeting anything on the round?
    fn closed(&mut self, from: Vec3, to: Vec3, along: Vec3, met: u32) -> bool {
        self.vectors += 1;
        let v = to - from;
        let w = self.start.te - from;
        let length = v.norm();
        let t = w.dot(&v) / (length * length);
        let beside = (w - v * t).norm();
        let again = self.vectors > 3
            && (0.0..=1.0).contains(&t)
            && beside <= BESIDE * length
            && self.along.dot(&along) > 0.5;
        if !again {
            return false;
        }
        let idle = met == self.met;
        self.met = met;
        self.vectors = 0;
        idle
    }
}

/// The tool at the start of a motion.
struct Begin {
    track: Track,
    node: Node,
    /// The first position when the tool must first be put in place.
    first: Option<Position>,
    /// The first position when the tool must first turn there.
    turned: Option<Position>,
    astray: Option<Astray>,
}

fn keep(wall: &Wall, side: Side) -> Result<Keep, Failure> {
    let unusable = || Failure::Unsupported { surface: wall.surface.clone() };
    Ok(Keep {
        profile: wall.profile,
        surface: wall.fitted.clone().ok_or_else(unusable)?,
        condition: if wall.on { Condition::On } else { Condition::Touch },
        side,
        thick: wall.thick,
        intol: wall.band.intol,
        outtol: wall.band.outtol,
    })
}

fn begin(scene: &Scene) -> Result<Begin, Failure> {
    let tool = &scene.tool;
    let mut part = keep(&scene.part, Side::Positive)?;
    let pose = upright(scene, &part);
    let mut drive = keep(&scene.drive, Side::Positive)?;
    let apart = |w: &Wall| Failure::NoContact { surface: w.surface.clone() };
    let part_gap = if scene.part.on {
        part.gap(&pose, None).map_err(|_| apart(&scene.part))?
    } else {
        let (gap, side) = nearer(&part, &pose).ok_or_else(|| apart(&scene.part))?;
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
            nearer(&drive, &pose).ok_or_else(|| apart(&scene.drive))?.1
        } else if wanted > 0.0 {
            Side::Positive
        } else {
            drive.inner(&pose)
        };
    }
    let astray = across(scene, &mut drive, &pose);
    let drive_gap = drive.gap(&pose, None).map_err(|_| apart(&scene.drive))?;
    let off_drive = placed(&drive, &drive_gap);
    let off_part = placed(&part, &part_gap);
    if off_drive > 2.0 {
        return Err(misplaced(scene, &drive, &drive_gap));
    }
    if off_part > 2.0 {
        return Err(Failure::OffPart {
            surface: scene.part.surface.clone(),
            off: part_gap.g,
            allowed: 2.0 * part.width(),
            outside: part_gap.g > 0.0,
        });
    }
    let size =
        pose.te.norm() + drive.profile.reach() + drive.surface.extent() + part.surface.extent();
    let exact = 1e-13 * size + 2e-9 * drive.width().min(part.width());
    let keeps = [drive, part];
    let (te, ta) = (pose.te, pose.ta);
    let around = Around { te, ta, part: &part_gap, drive: &drive_gap, along: heading };
    let axis = sided(scene, &keeps, &around);
    let guides = Guides::new(&keeps, &axis, &pose);
    let bands = keeps.each_ref().map(|keep| Band::new(keep, size, axis.turns()));
    let track = Track { keeps, bands, axis, guides, exact, size };
    let node = track
        .finish(pose, [drive_gap, part_gap], heading)
        .map_err(|t| trouble_at(scene, &pose, t))?;
    if off_drive <= 1.0 && off_part <= 1.0 {
        let turned = turn(&track, &node, scene.limits.step);
        let node = turned.unwrap_or(node);
        let turned = turned.map(|n| position(&n.pose));
        return Ok(Begin { track, node, first: None, turned, astray });
    }
    let targets = [0.0, 0.0];
    let node = track
        .settle(pose, node.course.along, targets, &node, true)
        .map_err(|t| trouble_at(scene, &pose, t))?;
    let first = Some(position(&node.pose));
    Ok(Begin { track, node, first, turned: None, astray })
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

/// The place at the start with the axis that the rule asks for there, when the tool stands with another one:
/// GO does not know the direction of the motion that follows, on which CUTANG depends. `None` when the axis can
/// turn with the first cut vector.
fn turn(track: &Track, node: &Node, cap: f64) -> Option<Node> {
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
    let turned =
        track.settle(Pose { ta, ..node.pose }, node.course.along, [0.0; 2], node, true).ok()?;
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
        keep.gap(&pose, None).is_ok_and(|g| placed(&keep, &g) <= 2.0)
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

/// The side on which the tool is nearer to touching. A disk touches from below as well as from above within the band:
/// it is that side towards which the rest of the cutter stands on it; where it is in one band alone, as a needle beside a
/// wall or a disk that came from below, the side of that band.
fn nearer(keep: &Keep, pose: &Pose) -> Option<(Gap, Side)> {
    let gap = |side: Side| keep.on_side(side).gap(pose, None).ok().map(|g| (g, side));
    let at = |(g, _): &(Gap, Side)| g.g.abs() <= 2.0 * keep.width();
    let better = |a: &(Gap, Side), b: &(Gap, Side)| {
        if at(a) && at(b) {
            let lean = (b.0.normal - a.0.normal).dot(&pose.ta);
            let off = [a, b].map(|(gap, _)| placed(keep, gap));
            let alike = (off[0] <= 1.0) == (off[1] <= 1.0);
            if alike && lean.abs() > 1e-3 { lean > 0.0 } else { off[1] < off[0] }
        } else {
            b.0.g.abs() < a.0.g.abs()
        }
    };
    let mut best: Option<(Gap, Side)> = None;
    for side in keep.sides(pose) {
        // A tool in place on one side is not nearer to another one that it is deep in.
        if best.as_ref().is_some_and(|b| at(b) && keep.deep(pose, side, 2.0 * keep.width())) {
            continue;
        }
        best = match (best, gap(side)) {
            (Some(best), Some(next)) if better(&best, &next) => Some(next),
            (best, next) => best.or(next),
        };
    }
    best
}

/// How many bands the tool is from its place: up to one it is in the band.
fn placed(keep: &Keep, gap: &Gap) -> f64 {
    let slack = 1e-6 * keep.width();
    let (low, high) = match keep.condition {
        Condition::On => {
            let most = keep.intol.max(keep.outtol);
            (-most, most)
        }
        Condition::Touch => (-keep.intol, keep.outtol),
    };
    if gap.g >= low - slack && gap.g <= high + slack {
        return 0.0;
    }
    let off = if gap.g < low { low - gap.g } else { gap.g - high };
    1.0 + off / keep.width()
}

/// A tool that is in place on the other side than the word says stays there.
fn across(scene: &Scene, drive: &mut Keep, pose: &Pose) -> Option<Astray> {
    let astray = scene.stance.astray()?;
    let fits = |keep: &Keep| keep.gap(pose, None).is_ok_and(|g| placed(keep, &g) <= 2.0);
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
    let allowed = 2.0 * keep.width();
    let off = if scene.drive.on { gap.g.abs() } else { gap.g };
    Failure::OffDrive { surface, off, allowed, outside: off > 0.0 }
}

fn trouble_at(scene: &Scene, pose: &Pose, t: Trouble) -> Failure {
    let (drive, part) = (scene.drive.surface.clone(), scene.part.surface.clone());
    match t {
        Trouble::SideBySide => Failure::SideBySide { drive, part },
        Trouble::Axis => unruled(scene, pose).unwrap_or(Failure::NoAxis { place: pose.te }),
        Trouble::Contact | Trouble::Check | Trouble::Stuck => {
            Failure::NoPlace { surfaces: vec![drive, part], place: pose.te }
        }
    }
}

/// TLAXIS/PARLEL along a surface without rulings.
fn unruled(scene: &Scene, pose: &Pose) -> Option<Failure> {
    let AxisRule::Rulings(role) = scene.axis else { return None };
    let (wall, other) = match role {
        OptionSurface::Part => (&scene.part, &scene.drive),
        OptionSurface::Drive => (&scene.drive, &scene.part),
    };
    let ruled = |w: &Wall| w.fitted.as_ref().is_some_and(|s| s.ruling(pose.te).is_some());
    let other = ruled(other).then(|| other.surface.clone());
    (!ruled(wall)).then(|| Failure::NoRulings { role, surface: wall.surface.clone(), other })
}

/// The track ends before a check surface: the cutter does not fit on, or the surfaces end.
fn blocked(
    scene: &Scene,
    begin: &Begin,
    watches: &[Watch],
    node: &Node,
    gone: f64,
    t: Trouble,
) -> Failure {
    let walls = [&scene.drive, &scene.part];
    for (keep, wall) in begin.track.keeps.iter().zip(walls) {
        let contact = keep.gap(&node.pose, None).ok().map(|gap| gap.surface_point);
        if let Some(radius) = contact.and_then(|q| keep.too_tight(q)) {
            let (surface, cutter) = (wall.surface.clone(), keep.profile.widest());
            return Failure::TooLarge { surface, radius, cutter };
        }
    }
    let (Some(check), Some(watch)) = (scene.checks.first(), watches.first()) else {
        return Failure::NoCheck { word: scene.direction };
    };
    if matches!(t, Trouble::Axis | Trouble::SideBySide) {
        return trouble_at(scene, &node.pose, t);
    }
    let now = keep(&check.wall, Side::Positive).ok().and_then(|k| clearance(&k, &node.pose).ok());
    let closest = now.map_or(f64::INFINITY, |g| g.0.abs()).min(watch.account().1.abs());
    let named = |i: usize| walls[i].surface.clone();
    let why = match cause(&begin.track, node) {
        Cause::Ends(i) => Hindrance::Ends(named(i)),
        Cause::Again(i, at) => Hindrance::Again { surface: named(i), at },
        Cause::Tight => Hindrance::Tight,
    };
    Failure::Blocked(Box::new(Blocked {
        surfaces: [named(0), named(1)],
        check: check.wall.surface.clone(),
        why,
        place: node.pose.te,
        gone,
        closest,
    }))
}

fn not_reached(
    scene: &Scene,
    watches: &[Watch],
    start: Pose,
    points: &[Position],
    gone: f64,
    spent: Option<u32>,
) -> Failure {
    let (Some(check), Some(watch)) = (scene.checks.first(), watches.first()) else {
        return Failure::NoCheck { word: scene.direction };
    };
    let (met, mut closest, mut pose) = watch.account();
    if matches!(check.relation, Relation::Tanto | Relation::Pstan) {
        let own = if check.relation == Relation::Pstan { &scene.part } else { &scene.drive };
        return Failure::NoTangency {
            surface: own.surface.clone(),
            other: check.wall.surface.clone(),
            closest: watch.alike,
            allowed: 2.0 * (check.wall.band.intol + check.wall.band.outtol),
        };
    }
    let path: Vec<Pose> =
        std::iter::once(start).chain(points.iter().map(|p| Pose { te: p.te, ta: p.ta })).collect();
    let nearer = keep(&check.wall, Side::Positive).ok().and_then(|k| approach(&k, &path));
    if let Some((gap, place)) = nearer.filter(|n| n.0 < closest.abs()) {
        (closest, pose) = (gap, place);
    }
    let within = check.relation == Relation::To && watch.stands_in(&start);
    let always = check.relation == Relation::Past && path.iter().all(|p| watch.stands_in(p));
    let stuck = always.then(|| check.wall.profile.height());
    Failure::NotReached {
        surface: check.wall.surface.clone(),
        nth: check.nth,
        met,
        closest,
        place: pose.te,
        gone,
        spent,
        within,
        stuck,
    }
}

fn control(
    scene: &Scene,
    track: &Track,
    watches: &[Watch],
    stopped: usize,
    halt: &Halt,
) -> Control {
    let mut checks: Vec<_> = scene
        .checks
        .iter()
        .enumerate()
        .map(|(i, c)| {
            let side = if i == stopped {
                halt.side
            } else {
                keep(&c.wall, Side::Positive)
                    .ok()
                    .and_then(|k| clearance(&k, &halt.node.pose).ok())
                    .map_or(Side::Positive, |(_, side)| side)
            };
            Controlled { nth: c.nth, ..c.wall.beside(c.relation, side) }
        })
        .collect();
    debug_assert_eq!(checks.len(), watches.len());
    checks.swap(0, stopped);
    Control {
        drive: Some(scene.drive.beside(to_or_on(scene.drive.on), track.keeps[0].side)),
        part: Some(scene.part.beside(to_or_on(scene.part.on), track.keeps[1].side)),
        checks,
        milling: None,
    }
}
