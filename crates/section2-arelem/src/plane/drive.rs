//! One motion along a line or circle.

use aptc_cldata::{Arc, Control, Controlled, Course as ArcCourse, Position};
use aptc_contact::Side as Contact;
use aptc_geometry::Circle;
use aptc_protap::Relation;

use super::chords::{Ring, chords};
use super::course::Course;
use super::curve::Curve;
use super::floor::{Floor, Height};
use super::frame::{Frame, Vec2, angle, left};
use super::meet::{Touched, into_both};
use super::stop::{Stop, Target, stop};
use crate::failure::Failure;
use crate::prepare::way;
use crate::scene::{Astray, Path, Scene, Stance, Wall, to_or_on};

/// Share of the band by which the end of an arc may lie off its circle.
const ON_ARC: f64 = 0.05;

/// The path of a motion; `None` when the scene is not one for the plane routine.
pub(crate) fn run(scene: &Scene) -> Option<Result<Path, Failure>> {
    let frame = Frame::of(scene.tool.ta);
    let curve = Curve::of(&scene.drive.surface.form, &frame)?;
    let floor = Floor::of(&scene.part, &frame, scene.tool.te, Height::AsItStands)?;
    let mut targets = Vec::with_capacity(scene.checks.len());
    for check in &scene.checks {
        if check.relation == Relation::Pstan {
            return None;
        }
        let band = check.wall.band;
        let tangent = check.relation == Relation::Tanto;
        targets.push(Target {
            curve: Curve::of(&check.wall.surface.form, &frame)?,
            relation: check.relation,
            reach: if tangent && scene.drive.on { 0.0 } else { check.wall.reach() },
            nth: check.nth,
            near: band.intol.max(band.outtol),
            loose: 2.0 * (band.intol + band.outtol),
        });
    }
    Some(follow(scene, &Plan { frame, curve, floor, targets }))
}

struct Plan {
    frame: Frame,
    curve: Curve,
    floor: Floor,
    targets: Vec<Target>,
}

fn follow(scene: &Scene, plan: &Plan) -> Result<Path, Failure> {
    let begin = begin(scene, plan)?;
    let (s, check) = first_stop(scene, plan, &begin.course)?;
    let shift = shift(scene, plan, &begin, begin.course.at(s), check);
    let mut corners: Vec<Vec2> = Vec::new();
    if begin.reposition {
        corners.push(begin.course.at(0.0));
    }
    match begin.course {
        Course::Straight { .. } => corners.push(begin.course.at(s) + shift),
        Course::Round { c, r, start, sense } => {
            let ring = begin.ring(scene, r);
            let last = r + shift.dot(&super::frame::ray(start + sense * s));
            let first = if begin.reposition { r } else { (begin.place - c).norm() };
            corners.extend(
                chords(ring, [first, last], s)
                    .into_iter()
                    .map(|v| c + super::frame::ray(start + sense * v.angle) * v.radius),
            );
        }
    }
    let (frame, floor) = (&plan.frame, &plan.floor);
    let place = |q: Vec2| frame.space(q, floor.height(frame, q));
    let points: Vec<Position> =
        corners.into_iter().map(|q| Position { te: place(q), ta: scene.tool.ta }).collect();
    let arc = match begin.course {
        // A control goes along arcs to ends on their circle.
        Course::Round { c, r, .. }
            if r > 0.0
                && floor.is_level(frame)
                && shift.norm() <= ON_ARC * (scene.drive.band.intol + scene.drive.band.outtol) =>
        {
            let circle = Circle { center: place(c), axis: scene.tool.ta, radius: r };
            Some(Arc { circle, course: ArcCourse::Chords })
        }
        _ => None,
    };
    let end = begin.course.at(s);
    Ok(Path {
        points,
        arc,
        check,
        forward: floor.lift(frame, begin.course.direction(s)),
        control: control(scene, plan, &begin, end, check),
        fouls: None,
        astray: begin.astray,
        rivals: Vec::new(),
        left: None,
    })
}

/// By how much the end of the course at a tangent check surface is to be moved into the bands of both.
fn shift(scene: &Scene, plan: &Plan, begin: &Begin, end: Vec2, check: usize) -> Vec2 {
    let (target, wall) = (&plan.targets[check], &scene.checks[check].wall);
    if target.relation != Relation::Tanto {
        return Vec2::zeros();
    }
    let (drive, on) = (&scene.drive, scene.drive.on);
    let drive =
        Touched { curve: plan.curve, side: begin.side, reach: drive.reach(), band: drive.band };
    let side = if on { 0.0 } else { target.curve.distance(end).signum() };
    let check = Touched { curve: target.curve, side, reach: target.reach, band: wall.band };
    into_both(end, &drive, &check)
}

/// The course of the tool end and how the tool stands at its start.
struct Begin {
    place: Vec2,
    course: Course,
    /// +1 with the tool on the side of the curve's normal, -1 on the other, 0 on it.
    side: f64,
    /// Is the tool so far off that it must first be put in place?
    reposition: bool,
    astray: Option<Astray>,
}

impl Begin {
    fn ring(&self, scene: &Scene, r: f64) -> Ring {
        let band = scene.drive.band;
        let (inner, outer) =
            if self.side < 0.0 { (band.outtol, band.intol) } else { (band.intol, band.outtol) };
        Ring { radius: r, inner, outer }
    }
}

fn begin(scene: &Scene, plan: &Plan) -> Result<Begin, Failure> {
    let (tool, drive) = (&scene.tool, &scene.drive);
    let band = drive.band;
    let place = plan.frame.plan(tool.te);
    let reach = drive.reach();
    let foot = plan.curve.normal(place).filter(|_| {
        // At the centre of a circle, within tolerance, the normal is noise.
        !matches!(plan.curve, Curve::Circle { c, .. } if (place - c).norm() <= band.outtol + band.intol)
    });
    let (t, side) = match foot {
        Some(n) => {
            let t =
                plan.frame.plan(way(tool, scene.direction, plan.floor.lift(&plan.frame, left(n)))?);
            let t = t.normalize();
            let toward = if n.dot(&left(t)) >= 0.0 { 1.0 } else { -1.0 };
            let side = match scene.stance {
                Stance::AsItStands => plan.curve.distance(place).signum(),
                stance => toward * stance.left(),
            };
            (t, side)
        }
        // The cutter fills the circle: it turns in place, the surface around it.
        None => (plan.frame.plan(tool.forward), -1.0),
    };
    // Where the motion before left it within wider bands it comes into these first.
    let in_place = |wall: &Wall, off: f64| {
        let sides = [Contact::Positive, Contact::Negative].into_iter();
        let bands = sides.filter_map(|side| scene.left_in(wall, side));
        let before = bands.map(|[intol, outtol]| if off > 0.0 { outtol } else { intol });
        before.fold(2.0 * (wall.band.intol + wall.band.outtol), f64::max) >= off.abs()
    };
    let allowed = 2.0 * (band.intol + band.outtol);
    let beside = |side: f64| match scene.stance {
        Stance::On => plan.curve.distance(place).abs(),
        _ => plan.curve.distance(place) * side - reach,
    };
    // A tool that is in place on the other side than the word says stays there.
    let astray = scene
        .stance
        .astray()
        .filter(|_| !in_place(drive, beside(side)) && in_place(drive, beside(-side)));
    let side = if astray.is_some() { -side } else { side };
    let (asked, off) = (side * reach, beside(side));
    if let Curve::Circle { r, .. } = plan.curve
        && r + asked < -allowed
    {
        return Err(too_large(scene, r));
    }
    if !in_place(drive, off) {
        let surface = scene.drive.surface.clone();
        return Err(Failure::OffDrive { surface, off, allowed, outside: off > 0.0 });
    }
    let lift = plan.floor.off(tool.te);
    let part = scene.part.band;
    if !in_place(&scene.part, lift) {
        return Err(Failure::OffPart {
            surface: scene.part.surface.clone(),
            off: lift,
            allowed: 2.0 * (part.intol + part.outtol),
            outside: lift > 0.0,
        });
    }
    let course = match plan.curve {
        Curve::Line { n, d } => {
            let from = place - n * (n.dot(&place) - d - asked);
            Course::Straight { from, along: t }
        }
        Curve::Circle { c, r } => {
            let r = (r + asked).max(0.0);
            let v = if foot.is_some() { place - c } else { -left(t) * scene.stance.left() };
            let sense = if left(v).dot(&t) >= 0.0 { 1.0 } else { -1.0 };
            let r = if foot.is_some() { r } else { 0.0 };
            Course::Round { c, r, start: angle(v), sense }
        }
    };
    let slack = 1e-6 * (band.intol + band.outtol) + 1e-12 * tool.te.norm();
    let within = (-band.intol - slack..=band.outtol + slack).contains(&off)
        && (-part.intol - slack..=part.outtol + slack).contains(&lift);
    Ok(Begin {
        place,
        course,
        side: if drive.on { 0.0 } else { side },
        reposition: !within,
        astray,
    })
}

fn too_large(scene: &Scene, radius: f64) -> Failure {
    let cutter = scene.drive.reach();
    Failure::TooLarge { surface: scene.drive.surface.clone(), radius, cutter }
}

/// Parameter of the first stop and the check surface that makes it.
fn first_stop(scene: &Scene, plan: &Plan, course: &Course) -> Result<(f64, usize), Failure> {
    let stops: Vec<Stop> = plan.targets.iter().map(|t| stop(course, t)).collect();
    let mut best: Option<(f64, usize)> = None;
    for (i, s) in stops.iter().enumerate() {
        if let Stop::At(s) = *s
            && best.is_none_or(|(b, _)| s < b)
        {
            best = Some((s, i));
        }
    }
    best.ok_or_else(|| {
        let place = |q: Vec2| plan.frame.space(q, plan.floor.height(&plan.frame, q));
        match (stops.first(), scene.checks.first()) {
            (Some(Stop::Never { met, closest, at, within }), Some(check)) => Failure::NotReached {
                surface: check.wall.surface.clone(),
                nth: check.nth,
                met: *met,
                closest: *closest,
                place: place(course.at(*at)),
                gone: course.length(*at),
                spent: None,
                within: *within,
                stuck: None,
            },
            (Some(Stop::NotTangent { closest }), Some(check)) => Failure::NoTangency {
                surface: scene.drive.surface.clone(),
                other: check.wall.surface.clone(),
                closest: *closest,
                allowed: plan.targets[0].loose,
                thick: [scene.drive.thick, check.wall.thick],
            },
            _ => Failure::NoCheck { word: scene.direction },
        }
    })
}

fn control(scene: &Scene, plan: &Plan, begin: &Begin, end: Vec2, stopped: usize) -> Control {
    let mut checks: Vec<_> = scene
        .checks
        .iter()
        .zip(&plan.targets)
        .map(|(c, t)| Controlled {
            nth: c.nth,
            ..c.wall.controlled(c.relation, t.curve.distance(end))
        })
        .collect();
    checks.swap(0, stopped);
    Control {
        drive: Some(scene.drive.controlled(to_or_on(scene.drive.on), begin.side)),
        part: Some(
            scene.part.controlled(to_or_on(scene.part.on), plan.floor.form_side(&scene.part)),
        ),
        checks,
        milling: None,
    }
}
