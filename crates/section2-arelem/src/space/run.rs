//! One motion along any two surfaces (APT: `AREPRE`, `ARLM3`).

use std::collections::VecDeque;

use aptc_cldata::{Control, Controlled, Position};
use aptc_contact::Side;
use aptc_geometry::{Profile, Surface, Vec3};

use super::begin::{Begin, begin};
use super::keep::Keep;
use super::loops::Loops;
use super::pace::Pace;
use super::refusal::{blocked, not_reached, trouble_at};
use super::track::{Node, Track, Trouble};
use super::watch::{Halt, Mark, Watch, clearance};
use crate::failure::Failure;
use crate::scene::{Path, Scene, Wall, to_or_on};

/// Cut vectors that turn back before a motion counts as caught between two places of contact: a path may have
/// a cusp, but a tool that is caught goes to and fro.
const MOST_BACK: u32 = 3;
/// Cut vectors one after another that are shorter than the band is wide before a motion counts as caught: an edge or a
/// corner that the band rounds is passed in a few.
const MOST_CREEPS: u32 = 60;
/// How often the way to the check surface may be cut shorter, because its last cut vector leaves the bands.
const MOST_SHORTENED: u32 = 20;
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
        let keep = Keep::of(&check.wall)?;
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
                points.push(halt.node.pose.position());
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
            points.push(stride.to.pose.position());
            trail.clear();
            (node, cornered) = (leave, true);
            continue;
        }
        points.push(stride.to.pose.position());
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
                Keep::of(&c.wall)
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
