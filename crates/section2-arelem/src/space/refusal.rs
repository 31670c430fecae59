//! Why a motion fails: what is told of a track that ends, or that meets no check surface.

use aptc_cldata::Position;
use aptc_geometry::trig;
use aptc_protap::{OptionSurface, Relation};

use super::begin::Begin;
use super::blocked::{Cause, cause};
use super::keep::{Keep, Pose};
use super::nearest::approach;
use super::track::{Node, Trouble};
use super::watch::{Watch, clearance};
use crate::axis::AxisRule;
use crate::failure::{Blocked, Failure, Hindrance};
use crate::scene::{Scene, Wall};
use crate::state::unit;

/// Sine of the angle between two surfaces up to which they run side by side.
const NEARLY_ALONG: f64 = 0.05;
/// Degrees that are left of the angle of an axis square to a vector where a motion comes to the end of such axes.
const NEARLY_DEG: f64 = 0.05;
/// So many are left at the beginning of such a motion.
const MUCH_DEG: f64 = 0.5;

pub(super) fn trouble_at(scene: &Scene, pose: &Pose, t: Trouble) -> Failure {
    let (drive, part) = (scene.drive.surface.clone(), scene.part.surface.clone());
    match t {
        Trouble::SideBySide => Failure::SideBySide { drive, part },
        Trouble::Axis => {
            let why = unruled(scene, pose).or_else(|| none_square(scene, pose, 0.0));
            why.unwrap_or(Failure::NoAxis { place: pose.te })
        }
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

/// TLAXIS/ATANGL,..,V where the normal leans out of the plane square to V by more than the angle, or less by so many degrees: where
/// that is used up the axis turns without end.
fn none_square(scene: &Scene, pose: &Pose, nearly_deg: f64) -> Option<Failure> {
    let (AxisRule::Angle(angle, _) | AxisRule::InPlane(angle, _)) = &scene.axis else {
        return None;
    };
    let v = unit(angle.reference?)?;
    let wall = if angle.surface == OptionSurface::Part { &scene.part } else { &scene.drive };
    let keep = Keep::of(wall).ok()?;
    let normal = keep.gap(pose, None).ok()?.normal;
    let least = trig::asin(normal.dot(&v).abs().min(1.0)).to_degrees();
    let asked = angle.angle_deg;
    let none = least > asked.abs() - nearly_deg;
    none.then_some(Failure::NoneSquare { place: pose.te, least, asked })
}

/// The track ends before a check surface: the cutter does not fit on, or the surfaces end.
pub(super) fn blocked(
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
    // Behind the tip of a cone the surfaces have no normals that would tell a direction, and do not run side by side for that.
    let [drive, part] = node.gaps.each_ref().map(|gap| gap.normal);
    let along = || drive.cross(&part).norm() <= NEARLY_ALONG;
    if matches!(t, Trouble::Axis) || matches!(t, Trouble::SideBySide) && along() {
        return trouble_at(scene, &node.pose, t);
    }
    let now = Keep::of(&check.wall).ok().and_then(|k| clearance(&k, &node.pose).ok());
    let closest = now.map_or(f64::INFINITY, |g| g.0.abs()).min(watch.account().1.abs());
    let named = |i: usize| walls[i].surface.clone();
    let why = cause(&begin.track, node);
    // Nothing stands in the way but that the axis, which had more room at first, turns without end.
    let uses_up = || none_square(scene, &begin.node.pose, MUCH_DEG).is_none();
    if matches!(why, Cause::Tight)
        && let Some(none) = none_square(scene, &node.pose, NEARLY_DEG).filter(|_| uses_up())
    {
        return none;
    }
    let why = match why {
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
        met: [watch.account().0, check.nth],
    }))
}

pub(super) fn not_reached(
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
            thick: [own.thick, check.wall.thick],
        };
    }
    let path: Vec<Pose> = std::iter::once(start).chain(points.iter().map(Pose::of)).collect();
    let nearer = Keep::of(&check.wall).ok().and_then(|k| approach(&k, &path));
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
