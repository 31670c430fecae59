//! REGION: that no stretch of a line is left out that the outlines leave to be milled.
//!
//! A tool on its line comes within OUTTOL of each of its places. So a place that no cut vector of the statement comes near was not
//! milled; where half of a stretch and more lies beside all vectors it was left out.

use std::sync::Arc;

use aptc_cldata::Control;
use aptc_cldata::milling::{AskedLine, Held, Limits, Milling};
use aptc_diagnostics::Origin;
use aptc_geometry::{Profile, Sculptured, Vec3};

use crate::certificate::LeftOut;
use crate::limited::{AT_BORDER, Areas};
use crate::milled::{name_of, ways};
use crate::statement::Statement;
use crate::swath::Swath;
use crate::tool::Pose;
use crate::verifier::Effort;

/// Places of a stretch that are looked at, an odd number.
const PLACES: u32 = 17;
/// A stretch is not looked at that is not longer than so many bands.
const LONG: f64 = 4.0;

/// The lines of a statement and all its vectors so far: what GCLEAR puts between parts it.
#[derive(Debug)]
pub(crate) struct Asked {
    control: Arc<Control>,
    origin: Origin,
    profile: Profile,
    pad: f64,
    ways: Vec<[Pose; 2]>,
}

impl Asked {
    /// Of a statement of which lines are promised.
    pub(crate) fn new(s: &Statement) -> Option<Self> {
        let limits = s.control.milling.as_ref()?.limits.as_ref()?;
        // A tool that got out of the way does not come to all of its line.
        let promised = !limits.lines.is_empty() && limits.held == Held::Touching;
        (promised && s.effort == Effort::Full).then(|| Self {
            control: Arc::clone(&s.control),
            origin: s.origin.clone(),
            profile: s.profile,
            pad: s.pad,
            ways: own_ways(s),
        })
    }

    /// Takes the vectors of a further part; false where it is another statement.
    pub(crate) fn takes(&mut self, s: &Statement) -> bool {
        let same = Arc::ptr_eq(&self.control, &s.control);
        if same {
            self.ways.extend(own_ways(s));
            self.pad = self.pad.max(s.pad);
        }
        same
    }

    /// The stretches that are left out.
    pub(crate) fn left_out(&self) -> Vec<LeftOut> {
        let Some(milling) = &self.control.milling else { return Vec::new() };
        let (Some(limits), Some(part)) = (&milling.limits, &milling.part) else {
            return Vec::new();
        };
        let lines = Lines::new(milling, limits, &part.surface);
        let swath = Swath::new(&self.profile, false, &self.ways, lines.room);
        let reach = (part.thick + milling.outtol).max(0.0) + lines.room + self.pad;
        let touched = |p: &Vec3| swath.least(*p, reach).is_some_and(|(far, _)| far <= reach);
        let mut all = Vec::new();
        for line in &limits.lines {
            for stretch in lines.stretches(line) {
                if let Some(missed) = longest(&stretch, touched) {
                    let word = if line.running == 1 { "UCONST" } else { "VCONST" };
                    all.push(LeftOut {
                        origin: self.origin.clone(),
                        surface: format!("part surface {}", name_of(&part.name)),
                        line: (word, line.fixed),
                        at: missed[missed.len() / 2].into(),
                        length: missed.windows(2).map(|w| (w[1] - w[0]).norm()).sum(),
                    });
                }
            }
        }
        all
    }
}

/// The vectors of a statement, the first one a place where it does not begin at the end of another.
fn own_ways(s: &Statement) -> Vec<[Pose; 2]> {
    ways(&s.start, &s.points)
}

/// What is known of the lines of a surface.
struct Lines<'a> {
    surface: &'a Sculptured,
    areas: Areas,
    /// Distance that does not count.
    room: f64,
}

impl<'a> Lines<'a> {
    fn new(milling: &Milling, limits: &Limits, surface: &'a Sculptured) -> Self {
        let areas = Areas::new(&limits.areas, surface);
        let room = milling.intol + milling.outtol + limits.off;
        Self { surface, areas, room }
    }

    /// Places of the stretches of a line that are to be milled for certain, away from their ends and from what runs along them.
    fn stretches(&self, line: &AskedLine) -> Vec<Vec<Vec3>> {
        let (k, c) = (line.running, 1 - line.running);
        let [low, high] = self.areas.ends(c, line.fixed);
        let [low, high] = [low + AT_BORDER, high - AT_BORDER];
        let fixed = line.fixed.min(high).max(low);
        let mut cuts = line.ends.to_vec();
        for [a, b] in self.areas.lines() {
            let (p, q) = (a[c] - fixed, b[c] - fixed);
            if (p > 0.0) != (q > 0.0) {
                cuts.push(a[k] + (b[k] - a[k]) * p / (p - q));
            }
        }
        cuts.retain(|t| (line.ends[0]..=line.ends[1]).contains(t));
        cuts.sort_by(f64::total_cmp);
        let place = |t: f64, across: f64| {
            let mut at = [t; 2];
            at[c] = across;
            at
        };
        let at = |t: f64| self.surface.at(place(t, fixed)[0], place(t, fixed)[1]).point;
        // Beside the line too, by as much as does not count.
        let allowed = |t: f64| {
            let [u, v] = place(t, fixed);
            let jet = self.surface.at(u, v);
            let speed = if c == 0 { jet.u.norm() } else { jet.v.norm() };
            let aside = self.room / speed;
            let sides = [fixed, (fixed - aside).max(low), (fixed + aside).min(high)];
            aside.is_finite() && sides.iter().all(|x| self.areas.allow(place(t, *x)))
        };
        let n = f64::from(PLACES);
        let mut all = Vec::new();
        for w in cuts.windows(2) {
            let inner: Vec<f64> = (0..PLACES)
                .map(|i| w[0] + (w[1] - w[0]) * (f64::from(i) + 1.0) / (n + 1.0))
                .collect();
            if !inner.iter().all(|t| allowed(*t)) {
                continue;
            }
            let places: Vec<Vec3> = inner.into_iter().map(at).collect();
            let length: f64 = places.windows(2).map(|p| (p[1] - p[0]).norm()).sum();
            if length > LONG * self.room {
                all.push(places);
            }
        }
        all
    }
}

/// The longest row of places that are not touched, where that is half of them or more.
fn longest(places: &[Vec3], touched: impl Fn(&Vec3) -> bool) -> Option<&[Vec3]> {
    let rows = places.split(touched);
    let row = rows.max_by_key(|row| row.len())?;
    (2 * row.len() >= places.len()).then_some(row)
}
