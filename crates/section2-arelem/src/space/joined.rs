//! Where drive or part surface becomes one with a tangent check surface while the tool axis turns: beyond its border a surface goes on
//! straight, along a plane that is tangent there for ever.
//!
//! With a fixed axis the gap has no slope on such a stretch, to rounding. Where the axis turns its slope is known from the mean turn of
//! the cut vector alone, and not to zero where a flat end lies along both; but the gaps to both surfaces differ by as much all along.

use super::keep::Keep;
use super::tangent::tangencies;
use super::track::Trouble;
use super::way::{Crossing, ROUNDS, Sample, Way, reach, read};

/// Sine of the angle up to which the normals of surfaces that are one may differ.
const ALIKE: f64 = 1e-6;
/// Share of the band by which the gaps to both may differ otherwise, and up to which a place that is tangent is the same.
const SAME: f64 = 1e-7;
const BESIDE: f64 = 0.05;
/// Shares of a cut vector at which it is looked whether both are one, the last first: it is as long as it is for going on straight, and
/// may lead beyond where that ends; and how much of the way before tells it.
const LOOKS: [f64; 5] = [1.0, 0.75, 0.5, 0.25, 0.125];
const TAIL: f64 = 1.0 / 64.0;

/// What is looked for between two samples.
pub(super) struct Between<'k> {
    pub(super) keep: &'k Keep,
    /// The surface that it is to be tangent to, 0 for drive and 1 for part.
    pub(super) other: usize,
    pub(super) ends: [Sample; 2],
    pub(super) loose: f64,
    pub(super) halvings: u32,
}

/// The places where the check surface is tangent. `along` tells whether both were one where the cut vector before ended; then that they
/// still are is nothing new. With a fixed axis the slope of the gap tells all that.
pub(super) fn tangent_places(
    way: &Way<'_>,
    between: &Between<'_>,
    along: &mut bool,
    alike: &mut f64,
    out: &mut Vec<Crossing>,
) -> Result<(), Trouble> {
    let Between { keep, ends: [a, b], loose, halvings, .. } = *between;
    if way.turn.norm() <= 0.0 {
        return tangencies(way, keep, a, b, loose, halvings, alike, out);
    }
    let one = way.joined(between)?;
    let before = std::mem::replace(along, one.as_ref().is_some_and(|one| one.to_the_end));
    let Some(Stretch { begins, at, .. }) = one else {
        return tangencies(way, keep, a, b, loose, halvings, alike, out);
    };
    if begins <= a.s && before {
        return Ok(());
    }
    if begins > a.s {
        let first = way.sample(keep, begins, &a)?;
        tangencies(way, keep, a, first, loose, halvings, alike, out)?;
        let (miss, beside) = (way.miss(between, at)?, BESIDE * keep.width());
        out.retain(|c| way.miss(between, c.s).is_ok_and(|m| (m - miss).abs() > beside));
    }
    out.push(Crossing { s: begins, touch: true, falls: a.slope < 0.0 });
    Ok(())
}

/// A part of a cut vector on which both surfaces are one: where it begins, a place on it, and whether that is the end of the vector.
struct Stretch {
    begins: f64,
    at: f64,
    to_the_end: bool,
}

impl Way<'_> {
    /// The first part between two samples on which both surfaces are one, if there is any.
    fn joined(&self, between: &Between<'_>) -> Result<Option<Stretch>, Trouble> {
        let Between { keep, ends: [a, b], loose, .. } = *between;
        let far = a.gap.g.abs() + b.gap.g.abs() - 2.0 * loose > reach(self, keep, &a, &b);
        if far || b.s <= a.s {
            return Ok(None);
        }
        let same = SAME * keep.width() + 4.0 * self.track.exact;
        let length = b.s - a.s;
        let is_one =
            |miss: f64, s: f64| self.miss(between, s).is_ok_and(|m| (m - miss).abs() <= same);
        let mut found: Option<(f64, f64)> = None;
        for share in LOOKS {
            let s = if share < 1.0 { a.s + share * length } else { b.s };
            match self.miss_where_tangent(between, s) {
                Some(miss) if is_one(miss, s - TAIL * length) => found = Some((s, miss)),
                // It was one from there on.
                _ if found.is_some() => break,
                _ => {}
            }
        }
        let Some((at, miss)) = found else { return Ok(None) };
        let (mut low, mut high) = (a.s, at - TAIL * length);
        if is_one(miss, low) {
            high = low;
        }
        for _ in 0..ROUNDS {
            if high - low <= self.track.exact {
                break;
            }
            let middle = 0.5 * (low + high);
            *(if is_one(miss, middle) { &mut high } else { &mut low }) = middle;
        }
        let to_the_end = is_one(miss, b.s);
        Ok(Some(Stretch { begins: high, at, to_the_end }))
    }

    /// The same as [`Way::miss`], where both surfaces are touched in one direction.
    fn miss_where_tangent(&self, between: &Between<'_>, s: f64) -> Option<f64> {
        let node = self.node(s).ok()?;
        let [gap, other] = [read(between.keep, &node, None).ok()?, node.gaps[between.other]];
        let tangent = gap.normal.cross(&other.normal).norm() <= ALIKE;
        (tangent && gap.g.abs() <= between.loose).then_some(gap.g - other.g)
    }

    /// By how much the gap to the check surface is more than that to the other.
    fn miss(&self, between: &Between<'_>, s: f64) -> Result<f64, Trouble> {
        let node = self.node(s)?;
        Ok(read(between.keep, &node, None)?.g - node.gaps[between.other].g)
    }
}
