//! Motion at feed from point to point: what it goes through of the part surfaces of the motions along surfaces before and after it.
//!
//! A tool that is sent down along its axis is to work deeper there, and where the chain begins and ends the motions along surfaces
//! tell how deep: what is no deeper than that is meant. What goes in from the side is not, and nothing else says so.

use aptc_cldata::{Motion, Position};
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::Profile;

use crate::around::{Around, Which};
use crate::certificate::{Fault, length};
use crate::free::{Rapid, cut_into, goes_down, goes_up};

/// Places of a chain at most; of a longer one those next to the motions along surfaces are held, so many at each.
const MOST: usize = 10_000;

/// All motion from point to point between two motions along surfaces, with one cutter.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    points: Vec<Position>,
    /// What each vector between them belongs to; none of what is not held here: rapid motion, and what is told elsewhere.
    origins: Vec<Option<Origin>>,
    profile: Profile,
    pad: f64,
    /// Does it begin where a motion along surfaces ended?
    comes: bool,
    /// Does it lead to one?
    pub(crate) leads: bool,
}

/// Puts them together from the records.
#[derive(Debug, Default)]
pub(crate) struct Chains {
    open: Option<Chain>,
    /// Vectors of it before the statement at hand.
    before: usize,
    /// Did a motion along surfaces end where it begins, or would begin?
    comes: bool,
}

impl Chains {
    /// A further statement begins.
    pub(crate) fn statement(&mut self) {
        self.before = self.open.as_ref().map_or(0, |c| c.origins.len());
    }

    /// A motion from point to point; of one that is not held here there is no `origin`. What is before it, where that grows too long.
    pub(crate) fn add(
        &mut self,
        from: Option<Position>,
        motion: &Motion,
        origin: Option<&Origin>,
        (profile, pad): (&Profile, f64),
    ) -> Option<Box<Chain>> {
        let long = self.open.as_ref().is_some_and(|c| c.points.len() + motion.points.len() > MOST);
        let before = if long { self.breaks() } else { None };
        let (profile, comes) = (*profile, self.comes && from.is_some());
        let chain = self.open.get_or_insert_with(|| {
            let (points, origins) = (from.into_iter().collect(), Vec::new());
            Chain { points, origins, profile, pad, comes, leads: false }
        });
        // The machine has led it there by itself (CLRSRF).
        if let (Some(last), Some(from)) = (chain.points.last(), from)
            && *last != from
        {
            chain.points.push(from);
            chain.origins.push(None);
        }
        for point in &motion.points {
            if !chain.points.is_empty() {
                chain.origins.push(origin.cloned());
            }
            chain.points.push(*point);
        }
        chain.pad = chain.pad.max(pad);
        before
    }

    /// The machine or another tool goes on.
    pub(crate) fn breaks(&mut self) -> Option<Box<Chain>> {
        (self.comes, self.before) = (false, 0);
        self.open.take().filter(Chain::asks).map(Box::new)
    }

    /// A motion along surfaces follows, to whose first place the tool is led, if it does not begin where the chain ends. What
    /// its statement puts before that is told there.
    pub(crate) fn along(&mut self, to: Option<&Position>) -> Option<Box<Chain>> {
        self.comes = true;
        let mut chain = self.open.take()?;
        chain.origins.iter_mut().skip(self.before).for_each(|o| *o = None);
        chain.leads = true;
        if let Some(to) = to {
            chain.points.push(*to);
            chain.origins.push(None);
        }
        Some(Box::new(chain)).filter(|c| c.asks())
    }
}

impl Chain {
    fn asks(&self) -> bool {
        (self.comes || self.leads) && self.origins.iter().any(Option::is_some)
    }

    /// What it goes through of the motion before it.
    pub(crate) fn leaves(&self, before: &Around) -> Option<Diagnostic> {
        if self.comes { self.through(before) } else { None }
    }

    /// The deepest place at which it goes through the part surface of a motion.
    pub(crate) fn through(&self, around: &Around) -> Option<Diagnostic> {
        let mut worst: Option<(usize, Fault)> = None;
        let ends = [self.points.first()?, self.points.last()?];
        for wall in around.walls(Which::Part(ends)) {
            for [from, to] in self.stretches() {
                let points = self.points[from..=to].to_vec();
                let way = Rapid::at_feed(&Origin::default(), points, self.profile, self.pad);
                let own = [from, to].into_iter().filter(|i| self.is_meant(*i));
                let meant: Vec<_> = ends.into_iter().chain(own.map(|i| &self.points[i])).collect();
                let fault =
                    cut_into(&way, wall.clone(), &meant).filter(|f| wall.is_at(f.te.into()));
                if let Some(f) =
                    fault.filter(|f| worst.as_ref().is_none_or(|(_, w)| f.depth > w.depth))
                {
                    worst = Some((from, f));
                }
            }
        }
        let (from, fault) = worst?;
        let vector = (from as u64 + fault.vector).checked_sub(1)?;
        let origin = self.origins.get(usize::try_from(vector).ok()?)?.as_ref()?;
        Some(told(origin, &fault))
    }

    /// Its stretches that are held, from place to place: all vectors of them go aside.
    fn stretches(&self) -> Vec<[usize; 2]> {
        let mut all: Vec<[usize; 2]> = Vec::new();
        let held = self.origins.iter().zip(self.points.windows(2)).enumerate();
        for (i, (origin, pair)) in held {
            if origin.is_none() || goes_up(pair) || goes_down(pair) {
                continue;
            }
            match all.last_mut() {
                Some(last) if last[1] == i => last[1] = i + 1,
                _ => all.push([i, i + 1]),
            }
        }
        all
    }

    /// Is the tool meant to be as deep as at a place? It is sent down along its axis there, or from there, or goes up from such a
    /// place; where rapid motion ends is told elsewhere.
    fn is_meant(&self, i: usize) -> bool {
        let pair = |i: usize| self.points.get(i..i + 2);
        if i == 0 || i + 1 == self.points.len() || pair(i).is_some_and(goes_down) {
            return true;
        }
        let mut before = i;
        while let Some(from) = before.checked_sub(1) {
            match pair(from) {
                Some(pair) if goes_down(pair) || self.origins[from].is_none() => return true,
                Some(pair) if goes_up(pair) => before = from,
                _ => return false,
            }
        }
        true
    }
}

fn told(origin: &Origin, fault: &Fault) -> Diagnostic {
    let message = format!(
        "motion from point to point cuts into {} by {} beyond tolerance {}",
        fault.surface,
        length(fault.depth),
        fault.place()
    );
    Diagnostic::warning(codes::FEED_CUT, origin.span, message)
        .help("go up before going aside; CHKSRF with the name of the surface refuses such a motion")
        .within(origin.trace.clone())
}
