//! How deep a surface of CHKSRF gets in the tool, and where the tool is then: what a gouge is told with.
//!
//! That a way gouges is found at the first place that shows it. To tell of it the deepest is looked for.

use aptc_contact::{Swept, Tool, axis_between};
use aptc_geometry::surface::kept;
use aptc_geometry::{Profile, Vec3, trig};

use crate::guard::{Gouge, Guard, Stood};
use crate::inside::{Found, deepest, hull};
use crate::plain::{Patience, Plain, about};

/// Parts of a way at whose ends a place is looked at, and rounds that close in on where it is deepest.
const PARTS: u32 = 8;
const ROUNDS: u32 = 48;

impl Guard {
    /// The same gouge of a tool that goes from one tool end and axis to the other, with the place of its surface that is
    /// deepest in the tool and where the tool is then.
    pub(crate) fn deepest(&self, cutter: &Profile, ends: [(Vec3, Vec3); 2], gouge: Gouge) -> Gouge {
        let [a, b] = ends;
        let by = gouge.by;
        let solids = || self.solids(cutter).filter(move |s| s.0 == by).map(|s| s.1);
        if let Some(s) = self.surfaces.iter().find(|s| s.name == gouge.surface) {
            let eps = |profile: &Profile| 1e-3 * self.intol.max(1e-6 * profile.reach());
            let found = solids().filter_map(|(profile, up)| {
                // What turns was looked at stretch by stretch: its place is known, if it is not the deepest.
                if (a.1 - b.1).norm() > 1e-12 {
                    return None;
                }
                let tool = Tool { profile: &profile, te: a.0 + a.1 * up, ta: a.1 };
                let (place, _) = s.tree.deepest(&Swept { tool, by: b.0 - a.0 }, eps(&profile))?;
                Some(place)
            });
            let least = found.min_by(|a, b| a.distance.total_cmp(&b.distance));
            let told = least.map(|place| self.told(s, place, by));
            let gouge = told.filter(|told| told.depth > gouge.depth).unwrap_or(gouge);
            let Some((place, thick)) = gouge.seen.as_ref().map(|seen| (seen.place, seen.thick))
            else {
                return gouge;
            };
            let all = solids().map(|(profile, up)| deep_at((&profile, up), ends, place));
            let Some((depth, t)) = all.max_by(|a, b| a.0.total_cmp(&b.0)) else { return gouge };
            // What turns was held against its place with the axis of a stretch; another place may be deeper in it where it stands then.
            let real = thick + depth;
            let depth = if real > self.intol { real } else { gouge.depth };
            let then = stood(ends, t, place);
            if (a.1 - b.1).norm() > 1e-12 {
                let at = [(then.te, then.ta); 2];
                let still = self.deepest(cutter, at, Gouge { seen: None, ..gouge.clone() });
                if still.stood.is_some() && still.depth > depth {
                    return still;
                }
            }
            return Gouge { depth, stood: Some(Box::new(then)), ..gouge };
        }
        let Some(p) = self.plain.iter().find(|p| p.name == gouge.surface) else { return gouge };
        let found = solids()
            .filter_map(|(profile, up)| p.deepest((&profile, up), ends, self.intol - p.thick))
            .map(|found| Found { depth: found.depth + p.thick, ..found })
            .max_by(|a, b| a.depth.total_cmp(&b.depth));
        match found {
            Some(Found { depth, place, t })
                if depth >= gouge.depth || gouge.depth.is_infinite() =>
            {
                Gouge { depth, stood: Some(Box::new(stood(ends, t, place))), ..gouge }
            }
            // Of what has sides it was told how deep the first of them goes beyond it.
            _ if kept::with_inside(&p.surface).is_some() => {
                let all = solids().filter_map(|(profile, up)| {
                    p.deep(cutter, (&profile, up), ends, self.intol, Patience::Full)
                });
                let all = all.map(|d| d.depth + p.thick).filter(|depth| depth.is_finite());
                Gouge { depth: all.fold(gouge.depth, f64::max), ..gouge }
            }
            _ => gouge,
        }
    }
}

impl Plain {
    /// The deepest place of a surface that has no sides in a solid on its way; `None` of others, where the depth is that
    /// beyond the surface, and where none is found deeper than `allowed`.
    fn deepest(
        &self,
        (profile, up): (&Profile, f64),
        ends: [(Vec3, Vec3); 2],
        allowed: f64,
    ) -> Option<Found> {
        if kept::with_inside(&self.surface).is_some() {
            return None;
        }
        let [a, b] = ends;
        let ta = axis_between(a.1, b.1, 0.5);
        let tool = Tool { profile, te: a.0 + ta * up, ta };
        let body = Swept { tool, by: b.0 - a.0 };
        let turn = 2.0 * trig::sin(0.25 * trig::angle_between(a.1, b.1));
        let slack = turn * (up + profile.reach());
        let [low, high] = about(hull(profile, &tool, body.by), allowed);
        let within = [low.add_scalar(-slack), high.add_scalar(slack)];
        let real = |place| deep_at((profile, up), ends, place);
        // What is deepest in a slender tool mostly lies beside its axis.
        let shares = || (0..=PARTS).map(|i| f64::from(i) / f64::from(PARTS));
        let stands = shares().take(if a == b { 1 } else { usize::MAX });
        let beside = stands.flat_map(|t| {
            let Stood { te, ta, .. } = stood(ends, t, a.0);
            let tall = profile.height() - profile.bottom();
            let at = move |share: f64| te + ta * (up + profile.bottom() + tall * share);
            shares().map(move |share| self.surface.foot(at(share)).point)
        });
        let known = (allowed, slack, profile.widest());
        deepest(&body, within, &self.surface, known, beside, real)
    }
}

fn stood([a, b]: [(Vec3, Vec3); 2], t: f64, place: Vec3) -> Stood {
    Stood { te: a.0 + (b.0 - a.0) * t, ta: axis_between(a.1, b.1, t), place }
}

/// How deep a place gets in a solid on its way, and at which share of it. The distance is convex along a way without a
/// turn, and along others nearly.
fn deep_at((profile, up): (&Profile, f64), ends: [(Vec3, Vec3); 2], place: Vec3) -> (f64, f64) {
    let depth = |t: f64| {
        let Stood { te, ta, .. } = stood(ends, t, place);
        -Tool { profile, te: te + ta * up, ta }.distance(place)
    };
    if ends[0] == ends[1] {
        return (depth(0.0), 0.0);
    }
    let all = (0..=PARTS).map(|i| f64::from(i) / f64::from(PARTS)).map(|t| (depth(t), t));
    let best = all.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((depth(0.0), 0.0));
    let part = 1.0 / f64::from(PARTS);
    let [mut low, mut high] = [(best.1 - part).max(0.0), (best.1 + part).min(1.0)];
    for _ in 0..ROUNDS {
        let third = (high - low) / 3.0;
        if depth(low + third) < depth(high - third) {
            low += third;
        } else {
            high -= third;
        }
    }
    let last = 0.5 * (low + high);
    let last = (depth(last), last);
    if last.0 > best.0 { last } else { best }
}

#[cfg(test)]
#[path = "deepest_tests.rs"]
mod tests;
