//! What stands around the tool after a motion along surfaces and before it, which rapid motion shall not go through.

use std::sync::Arc;

use aptc_cldata::milling::{Area, Milled, Plain};
use aptc_cldata::{Control, Controlled, Position};
use aptc_geometry::{Form, Profile, Vec3};

use crate::between::{NO_TURN, Way, angle};
use crate::certificate::Fault;
use crate::free::Rapid;
use crate::judged::Judged;
use crate::limited::Limited;
use crate::milled::{MilledSurface, name_of};
use crate::sheets::Sheets;
use crate::statement::{Seen, Statement};
use crate::tool::Pose;

/// Depth, as a share of the tool's half width, from which on a surface that goes through its axis is no deeper in it.
const FULL: f64 = 0.99;
/// Halvings of how far a tool is to be raised, and heights of the tool by which it is at most.
const HALVINGS: usize = 24;
const TALL: f64 = 2.0;
/// Share by which it is raised more than it needs.
const MORE: f64 = 1e-3;

/// The surfaces of a motion, and where it ended.
#[derive(Clone, Debug)]
pub(crate) struct Around {
    of: Vec<Surfaces>,
    pub(crate) at: Position,
}

/// Those of one motion; what is to be known of them is found where rapid motion asks for it.
#[derive(Clone, Debug)]
enum Surfaces {
    /// The part surface of a motion of the arithmetic element, with the cutter, and between which numbers the tool end was over it.
    Guided { control: Arc<Control>, sheets: Sheets, profile: Profile, ran: [Vec3; 2] },
    /// The surfaces of regional milling, or its part surface alone.
    Milled { control: Arc<Control>, sheets: Sheets, came: Option<Came> },
}

/// How the tool came to regional milling, and how high that went: what is checked keeps to its side.
#[derive(Clone, Copy, Debug)]
struct Came {
    profile: Profile,
    from: Position,
    /// The greatest height of a tool end along the axis.
    top: f64,
}

/// Where a tool ran over a plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ran {
    ends: [Vec3; 2],
    normal: Vec3,
    reach: f64,
}

/// Which of them a way is held against.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Which<'a> {
    All,
    /// The part surface, if the way is not held against what is checked already.
    Unchecked,
    /// The part surface that a statement gives, with that tool axis at both ends if it is a plane, which lies on other sides of the part too.
    Part([&'a Position; 2]),
}

/// One of them.
#[derive(Clone, Debug)]
pub(crate) enum Wall {
    /// Of a plane, which goes on without end, with where it is known to be the part's.
    Guided(Box<Judged>, Option<Ran>),
    Milled {
        surface: Box<MilledSurface>,
        /// The same for the tool end, where that is led on it. Beside it the cutter is as deep as the slope makes it.
        end: Option<Box<MilledSurface>>,
        /// The height along an axis up to which it is known to stand: a plane or an upright bar goes on without end.
        top: Option<(Vec3, f64)>,
    },
}

impl Around {
    /// Those of a statement that the tool came to with `before` around it; `None` of one that has no part surface.
    ///
    /// A tool end that is led away from its part surface leaves that where it was.
    pub(crate) fn of(statement: &Statement, before: Option<&Self>) -> Option<Self> {
        let at = *statement.points.last()?;
        let control = &statement.control;
        let Some(milling) = &control.milling else {
            let part = control.part.as_ref()?;
            let earlier = before.and_then(|b| b.of.first()?.ran_over(part));
            let start = earlier.unwrap_or([at.te; 2]);
            let wider = |[low, high]: [Vec3; 2], p: &Position| [low.inf(&p.te), high.sup(&p.te)];
            let ran = statement.points.iter().fold(start, wider);
            let (control, sheets) = (Arc::clone(control), statement.sheets.clone());
            let of = vec![Surfaces::Guided { control, sheets, profile: statement.profile, ran }];
            return Some(Self { of, at });
        };
        let own = Surfaces::Milled {
            control: Arc::clone(control),
            sheets: statement.sheets.clone(),
            came: Came::new(statement),
        };
        let older = before.filter(|_| milling.part.is_none());
        let older = older.and_then(|b| b.of.iter().find_map(Surfaces::part_of_milling));
        Some(Self { of: [own].into_iter().chain(older).collect(), at })
    }

    /// What REGION leaves to be milled of the part surface, with the name of that; `None` where it does not limit it, or it is not known.
    pub(crate) fn limited(&self, profile: &Profile) -> Option<(Limited, String)> {
        let Surfaces::Milled { control, sheets, .. } = self.of.first()? else { return None };
        let milling = control.milling.as_ref()?;
        let part = milling.part.as_ref().filter(|_| milling.limits.is_some())?;
        let limited = Limited::new(milling, sheets.of(&part.surface), profile)?;
        limited.is_whole().then(|| (limited, name_of(&part.name)))
    }

    /// The outlines that limit it.
    pub(crate) fn areas(&self) -> Option<&[Area]> {
        let Surfaces::Milled { control, .. } = self.of.first()? else { return None };
        control.milling.as_ref()?.limits.as_ref().map(|limits| &limits.areas[..])
    }

    /// Each of them that can be told to be cut.
    pub(crate) fn walls(&self, which: Which<'_>) -> Vec<Wall> {
        self.of.iter().flat_map(|s| s.walls(&self.at, which)).collect()
    }
}

impl Surfaces {
    /// Between which numbers the tool end was over that part surface.
    fn ran_over(&self, part: &Controlled) -> Option<[Vec3; 2]> {
        match self {
            Self::Guided { control, ran, .. } => {
                let same = control.part.as_ref().is_some_and(|p| Arc::ptr_eq(&p.form, &part.form));
                same.then_some(*ran)
            }
            Self::Milled { .. } => None,
        }
    }

    fn part_of_milling(&self) -> Option<Self> {
        match self {
            Self::Milled { control, sheets, .. }
                if control.milling.as_ref().is_some_and(|m| m.part.is_some()) =>
            {
                let (control, sheets) = (Arc::clone(control), sheets.clone());
                Some(Self::Milled { control, sheets, came: None })
            }
            _ => None,
        }
    }

    fn walls(&self, at: &Position, which: Which<'_>) -> Vec<Wall> {
        let (control, sheets, came) = match self {
            Self::Guided { control, sheets, profile, ran } => {
                let part = control.part.as_ref().filter(|part| which.takes(part, at));
                let ran = matches!(which, Which::Part(_)).then_some(*ran);
                return part
                    .and_then(|part| guided(part, at, (profile, sheets), ran))
                    .into_iter()
                    .collect();
            }
            Self::Milled { control, sheets, came } => (control, sheets, came.as_ref()),
        };
        let Some(milling) = &control.milling else { return Vec::new() };
        let wall = |of: &Milled, role| {
            let surface = MilledSurface::passed(of, role, milling, sheets)?;
            let surface = Box::new(surface);
            let led = role == "part" && milling.on;
            let end = led.then(|| MilledSurface::led_on(of, milling, sheets)).flatten();
            Some(Wall::Milled { surface, end: end.map(Box::new), top: None })
        };
        let part =
            milling.part.iter().filter(|_| !(matches!(which, Which::Unchecked) && milling.guarded));
        let checked = came.filter(|_| matches!(which, Which::All));
        let sculptured = checked.iter().flat_map(|_| &milling.checked);
        let plain = checked.iter().flat_map(|came| milling.plain.iter().map(move |p| (p, came)));
        let kept = |(of, came): (&Plain, &&Came)| {
            let from = (&came.profile, &came.from);
            let surface = MilledSurface::passed_plain(of, milling, sheets, from)?;
            let top = (!surface.ends_along(at.ta)).then_some((at.ta, came.top));
            Some(Wall::Milled { surface: Box::new(surface), end: None, top })
        };
        part.filter_map(|p| wall(p, "part"))
            .chain(sculptured.filter_map(|c| wall(c, "checked")))
            .chain(plain.filter_map(kept))
            .collect()
    }
}

impl Which<'_> {
    fn takes(&self, part: &Controlled, at: &Position) -> bool {
        let Self::Part(ends) = self else { return true };
        let turned = ends.iter().any(|p| angle(p.ta, at.ta) > NO_TURN);
        let elsewhere = turned && normal(part).is_some();
        !elsewhere && !part.name.is_in_words()
    }
}

impl Came {
    fn new(s: &Statement) -> Option<Self> {
        let up = s.points.last()?.ta;
        let from = *s.before.as_ref().or(s.way.last()).or(s.points.first())?;
        let top = s.points.iter().map(|p| p.te.dot(&up)).fold(f64::NEG_INFINITY, f64::max);
        Some(Self { profile: s.profile, from, top })
    }
}

/// Around a tool that works inside of a round surface the surface closes above: leaving it is no cut.
fn guided(
    part: &Controlled,
    at: &Position,
    (profile, sheets): (&Profile, &Sheets),
    ran: Option<[Vec3; 2]>,
) -> Option<Wall> {
    let normal = normal(part);
    if part.side < 0 && normal.is_none() {
        return None;
    }
    let reach = profile.widest();
    let ran = ran.zip(normal).map(|(ends, normal)| Ran { ends, normal, reach });
    Judged::clear(part, at, profile, sheets).map(|judged| Wall::Guided(Box::new(judged), ran))
}

/// The normal of a plane.
fn normal(part: &Controlled) -> Option<Vec3> {
    match part.form.shape() {
        Form::Plane(p) => Some(p.n),
        Form::Line(l) => Some(l.plane().n),
        _ => None,
    }
}

impl Ran {
    /// Is a place, seen along the normal, no farther than the tool is wide from where it ran?
    fn is_at(&self, te: Vec3) -> bool {
        let [low, high] = self.ends;
        let off = te - te.sup(&low).inf(&high);
        (off - self.normal * self.normal.dot(&off)).norm() <= self.reach
    }
}

impl Wall {
    /// How the rapid motion cuts in from `a` to `b`, if it is shown to.
    pub(crate) fn cut(&self, rapid: &Rapid, a: &Position, b: &Position, i: u64) -> Option<Fault> {
        self.fault(rapid, a, b, i).filter(|f| f.refuted)
    }

    fn fault(&self, rapid: &Rapid, a: &Position, b: &Position, i: u64) -> Option<Fault> {
        let (seen, Rapid { profile, pad, .. }) = (&mut Seen::default(), rapid);
        match self {
            Self::Guided(judged, _) => judged.vector(profile, a, b, *pad, i, seen),
            Self::Milled { surface, top, .. } => {
                let ends = match top {
                    Some((up, top)) => below(*up, top + pad, [a, b])?,
                    None => [*a, *b],
                };
                surface.vector(profile, &ends[0], &ends[1], *pad, i, seen)
            }
        }
    }

    /// Allows the tool to be deeper by so much.
    pub(crate) fn allow(&mut self, deeper: f64) {
        match self {
            Self::Guided(judged, _) => judged.allow(deeper),
            Self::Milled { surface, .. } => surface.allow(deeper),
        }
    }

    /// As messages call it, whatever stands for the tool.
    pub(crate) fn called(&self, otherwise: String) -> String {
        match self {
            Self::Guided(..) => otherwise,
            Self::Milled { surface, .. } => surface.told(),
        }
    }

    /// Is it known to be the part's at a place?
    pub(crate) fn is_at(&self, te: Vec3) -> bool {
        !matches!(self, Self::Guided(_, Some(ran)) if !ran.is_at(te))
    }

    /// Is the tool end led on it, and is it no lower than that at this place?
    pub(crate) fn leads_the_end(&self, rapid: &Rapid, p: &Position) -> bool {
        let Self::Milled { end: Some(end), .. } = self else { return false };
        let fault = end.vector(&rapid.profile, p, p, rapid.pad, 0, &mut Seen::default());
        fault.is_none_or(|f| f.refuted && !f.gouge)
    }

    /// Is a tool that stands so deep in it through it, so that it is nowhere deeper?
    pub(crate) fn is_through(&self, profile: &Profile, deep: f64) -> bool {
        let half = profile.widest().min(0.5 * (profile.height() - profile.bottom()));
        let through = |s: &MilledSurface| s.has_no_sides() && deep - s.least() >= FULL * half;
        matches!(self, Self::Milled { surface, .. } if through(surface))
    }

    /// The same for a tool raised along its axis until it is clear of it at each of the places: what this one cuts lies
    /// higher over the tool end than there. `None` where it nowhere is.
    pub(crate) fn raised(&self, rapid: &Rapid, places: &[&Position]) -> Option<Self> {
        let Self::Milled { surface, end, top } = self else { return None };
        let by = |up: f64| {
            let surface = Box::new(surface.raised(&rapid.profile, up));
            Self::Milled { surface, end: end.clone(), top: *top }
        };
        let is_clear = |up: f64| places.iter().all(|p| by(up).fault(rapid, p, p, 0).is_none());
        let (mut low, mut high) = (0.0, TALL * rapid.profile.height());
        if !is_clear(high) {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if is_clear(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        Some(by(high * (1.0 + MORE)))
    }
}

/// The part of a way on which the tool end is no higher than `top` along `up`; `None` where none of it is.
fn below(up: Vec3, top: f64, [a, b]: [&Position; 2]) -> Option<[Position; 2]> {
    let [low, high] = [a, b].map(|p| p.te.dot(&up) - top);
    if low > 0.0 && high > 0.0 {
        return None;
    }
    let way = Way::new(Pose::of(a), Pose::of(b));
    let cut = |t: f64| {
        let Pose { te, ta } = way.at(t);
        Position { te, ta }
    };
    let share = low / (low - high);
    Some(match (low > 0.0, high > 0.0) {
        (true, _) => [cut(share), *b],
        (_, true) => [*a, cut(share)],
        _ => [*a, *b],
    })
}
