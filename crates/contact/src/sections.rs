//! All places of contact on a polyconic, by a look from section to section.
//!
//! On a section the cutter touches where its point farthest in along the normal goes over from ahead along the section to
//! behind: at one place of a crest; in a hollow that both ends of a flat end touch, or of a flank, at two, the first and the last
//! of which are followed.

use aptc_geometry::surface::ParametricSurface;
use aptc_geometry::{Tool, Vec3};

use crate::crests::{Crests, LEVELS, Look, Part};
use crate::gap::Side;

/// Rounds to the place of a section, each of which looks twice.
const ROUNDS: u32 = 3;
/// Share of a section by which the place on the next one may lie beside those of two that are known.
const BESIDE: f64 = 0.05;

/// Which of the places of a section is followed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    First,
    Last,
}

/// A place of a section and what is seen there.
type Place = (f64, Look);

/// Offers those between sampled sections not farther than `reach` from the tool axis.
pub(crate) fn over_sections(all: &mut Crests<'_>, surface: &ParametricSurface, reach: f64) {
    let walk = Walk { tool: all.tool, surface, side: all.side };
    let mut several = false;
    for end in [End::First, End::Last] {
        let mut before: Option<(usize, Option<Place>)> = None;
        for [i, k] in surface.sections_near(all.tool.te, all.top, reach) {
            let first = match before {
                Some((at, place)) if at == i => place,
                _ => walk.sampled(i, end, &mut several),
            };
            let last = walk.sampled(k, end, &mut several);
            before = Some((k, last));
            if let Some((_, look)) = &first {
                all.pass(look);
            }
            let (Some(first), Some(last)) = (first, last) else { continue };
            let ends = [i, k].map(|i| surface.section(i).first().map_or(0.0, |s| s.at[0]));
            let look = |u: f64| walk.between(u, ends, [first.0, last.0]);
            let part =
                Part { from: (ends[0], first.1), to: (ends[1], last.1), scale: first.1.rate() };
            let sides = part.sides(all.tool, &look);
            part.contacts(sides.as_ref(), &look, &mut |l| all.offer(l), LEVELS - 1);
        }
        if !several {
            return;
        }
    }
}

/// A tool beside the sections of a polyconic.
struct Walk<'a> {
    tool: &'a Tool<'a>,
    surface: &'a ParametricSurface,
    side: Side,
}

impl Walk<'_> {
    /// How far ahead along the section the cutter's farthest point in lies.
    fn ahead(&self, point: Vec3, normal: Vec3, along: Vec3) -> f64 {
        let away = self.tool.support(normal * -self.side.sign()).point - point;
        along.dot(&away)
    }

    /// The place of a sampled section, and whether there are several.
    fn sampled(&self, i: usize, end: End, several: &mut bool) -> Option<Place> {
        let section = self.surface.section(i);
        let ahead = |k: usize| {
            let s = &section[k];
            self.ahead(s.point, s.normal, s.along)
        };
        let mut found: Option<[(f64, f64); 2]> = None;
        let mut before = ahead(0);
        for k in 1..section.len() {
            let here = ahead(k);
            if before > 0.0 && here <= 0.0 {
                *several |= found.is_some();
                if found.is_none() || end == End::Last {
                    found = Some([(section[k - 1].at[1], before), (section[k].at[1], here)]);
                }
            }
            before = here;
        }
        let u = section.first()?.at[0];
        found.map(|bracket| self.within(u, bracket))
    }

    /// The place between two sections, beside the straight way between theirs.
    fn between(&self, u: f64, [a, b]: [f64; 2], [from, to]: [f64; 2]) -> Look {
        let v = from + (to - from) * ((u - a) / (b - a));
        let beside = BESIDE + (to - from).abs();
        let at = |v: f64| (v, self.look(u, v).0);
        let (low, high) = (at(v - beside), at(v + beside));
        if low.1 > 0.0 && high.1 <= 0.0 { self.within(u, [low, high]).1 } else { self.look(u, v).1 }
    }

    /// The place between two of which one has the cutter ahead.
    fn within(&self, u: f64, [mut low, mut high]: [(f64, f64); 2]) -> Place {
        let mut found = (0.5 * (low.0 + high.0), None);
        for round in 0..2 * ROUNDS {
            // Halved, as the cutter's point may jump, and by a straight line.
            let share = if round % 2 == 0 { 0.5 } else { low.1 / (low.1 - high.1) };
            let v = low.0 + (high.0 - low.0) * share;
            let (ahead, look) = self.look(u, v);
            found = (v, Some(look));
            *(if ahead > 0.0 { &mut low } else { &mut high }) = (v, ahead);
        }
        (found.0, found.1.unwrap_or_else(|| self.look(u, found.0).1))
    }

    fn look(&self, u: f64, v: f64) -> (f64, Look) {
        let (place, [across, along]) = self.surface.place_with_sides([u, v]);
        let ahead = self.ahead(place.point, place.normal, along);
        let look = Look::at_place(self.tool, self.side, &place, across, along.normalize());
        (ahead, look.alone())
    }
}
