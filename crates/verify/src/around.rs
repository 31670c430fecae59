//! What stands around the tool after a motion along surfaces and before it, which rapid motion shall not go through.

use std::sync::Arc;

use aptc_cldata::milling::Milled;
use aptc_cldata::{Control, Controlled, Position};
use aptc_geometry::{Form, Profile};

use crate::certificate::Fault;
use crate::free::Rapid;
use crate::judged::Judged;
use crate::milled::MilledSurface;
use crate::sheets::Sheets;
use crate::statement::{Seen, Statement};

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
    /// The part surface of a motion of the arithmetic element, with the cutter.
    Guided(Arc<Control>, Profile),
    /// The sculptured surfaces of regional milling, or its part surface alone.
    Milled { control: Arc<Control>, sheets: Sheets, part_alone: bool },
}

/// One of them.
#[derive(Clone, Debug)]
pub(crate) enum Wall {
    Guided(Box<Judged>),
    Milled {
        surface: Box<MilledSurface>,
        /// The same for the tool end, where that is led on it. Beside it the cutter is as deep as the slope makes it.
        end: Option<Box<MilledSurface>>,
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
            control.part.as_ref()?;
            let of = vec![Surfaces::Guided(Arc::clone(control), statement.profile)];
            return Some(Self { of, at });
        };
        let own = Surfaces::Milled {
            control: Arc::clone(control),
            sheets: statement.sheets.clone(),
            part_alone: false,
        };
        let older = before.filter(|_| milling.part.is_none());
        let older = older.and_then(|b| b.of.iter().find_map(Surfaces::part_of_milling));
        Some(Self { of: [own].into_iter().chain(older).collect(), at })
    }

    /// Each of them that can be told to be cut, without those that the way of the rapid motion is held against already.
    pub(crate) fn walls(&self, arrives: bool) -> Vec<Wall> {
        self.of.iter().flat_map(|s| s.walls(&self.at, arrives)).collect()
    }
}

impl Surfaces {
    fn part_of_milling(&self) -> Option<Self> {
        match self {
            Self::Milled { control, sheets, .. }
                if control.milling.as_ref().is_some_and(|m| m.part.is_some()) =>
            {
                let (control, sheets) = (Arc::clone(control), sheets.clone());
                Some(Self::Milled { control, sheets, part_alone: true })
            }
            _ => None,
        }
    }

    fn walls(&self, at: &Position, arrives: bool) -> Vec<Wall> {
        let (control, sheets, part_alone) = match self {
            Self::Guided(control, profile) => {
                let part = control.part.as_ref();
                return part.and_then(|part| guided(part, at, profile)).into_iter().collect();
            }
            Self::Milled { control, sheets, part_alone } => (control, sheets, *part_alone),
        };
        let Some(milling) = &control.milling else { return Vec::new() };
        let wall = |of: &Milled, role| {
            let surface = MilledSurface::passed(of, role, milling, sheets)?;
            let surface = Box::new(surface);
            let led = role == "part" && milling.on;
            let end = led.then(|| MilledSurface::led_on(of, milling, sheets)).flatten();
            Some(Wall::Milled { surface, end: end.map(Box::new) })
        };
        let part = milling.part.iter().filter(|_| !(arrives && milling.guarded));
        let checked = milling.checked.iter().filter(|_| !arrives && !part_alone);
        part.filter_map(|p| wall(p, "part"))
            .chain(checked.filter_map(|c| wall(c, "checked")))
            .collect()
    }
}

/// Around a tool that works inside of a round surface the surface closes above: leaving it is no cut.
fn guided(part: &Controlled, at: &Position, profile: &Profile) -> Option<Wall> {
    let flat = matches!(part.form.shape(), Form::Plane(_) | Form::Line(_));
    if part.side < 0 && !flat {
        return None;
    }
    Judged::clear(part, at, profile).map(|judged| Wall::Guided(Box::new(judged)))
}

impl Wall {
    /// How the rapid motion cuts in from `a` to `b`, if it is shown to.
    pub(crate) fn cut(&self, rapid: &Rapid, a: &Position, b: &Position, i: u64) -> Option<Fault> {
        self.fault(rapid, a, b, i).filter(|f| f.refuted)
    }

    fn fault(&self, rapid: &Rapid, a: &Position, b: &Position, i: u64) -> Option<Fault> {
        let (seen, Rapid { profile, pad, .. }) = (&mut Seen::default(), rapid);
        match self {
            Self::Guided(judged) => judged.vector(profile, a, b, *pad, i, seen),
            Self::Milled { surface, .. } => surface.vector(profile, a, b, *pad, i, seen),
        }
    }

    /// Allows the tool to be deeper by so much.
    pub(crate) fn allow(&mut self, deeper: f64) {
        match self {
            Self::Guided(judged) => judged.allow(deeper),
            Self::Milled { surface, .. } => surface.allow(deeper),
        }
    }

    /// As messages call it, whatever stands for the tool.
    pub(crate) fn called(&self, otherwise: String) -> String {
        match self {
            Self::Guided(_) => otherwise,
            Self::Milled { surface, .. } => surface.told(),
        }
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
        matches!(self, Self::Milled { surface, .. } if deep - surface.least() >= FULL * half)
    }

    /// The same for a tool raised along its axis until it is clear of it at each of the places: what this one cuts lies
    /// higher over the tool end than there. `None` where it nowhere is.
    pub(crate) fn raised(&self, rapid: &Rapid, places: &[&Position]) -> Option<Self> {
        let Self::Milled { surface, end } = self else { return None };
        let by = |up: f64| {
            let surface = Box::new(surface.raised(&rapid.profile, up));
            Self::Milled { surface, end: end.clone() }
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
