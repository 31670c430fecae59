//! Where a track is tangent to a check surface, or runs along with it (APT: `CPLAN`, without a plane in the surface's place).

use std::cmp::Ordering;

use aptc_geometry::{Foot, Segment, Spot};

use super::keep::Keep;
use super::track::{Node, Trouble};
use super::way::{
    Crossing, GRAZING, HALVINGS, PIECES, ROUNDS, Sample, Way, newton, reach, read, simple,
};

/// A gap that changes less than this with the way keeps its value: far above rounding, and a round surface of a
/// thousand times the length of the cut vector changes more at the first look.
const LEVEL: f64 = 1e-10;

/// Sine of the angle up to which a check surface that is touched where a motion begins lies along it: printed with few digits.
const ALONG: f64 = 1e-6;

/// Sine of the angle by which a way that is tangent to a check surface without turning back from it may miss it, and how often the
/// gap changes by what a tangency may be off within the way about it that is looked at.
const ALMOST: f64 = 5e-3;
const LOOSE: f64 = 4.0;
/// Spans between two places of contact about one crest or hollow at most.
const ONE_CREST: f64 = 1.5;
/// The lesser share of the golden section.
const GOLDEN: f64 = 0.381_966_011_250_105;

/// The places between two samples where the gap is stationary and within `loose` of zero.
#[expect(clippy::too_many_arguments, reason = "the bracket, its surface and what is found")]
pub(super) fn tangencies(
    way: &Way<'_>,
    keep: &Keep,
    a: Sample,
    b: Sample,
    loose: f64,
    halvings: u32,
    alike: &mut f64,
    out: &mut Vec<Crossing>,
) -> Result<(), Trouble> {
    if b.s <= a.s {
        return Ok(());
    }
    // The way comes to run along with the check surface, as along the straight end of a TABCYL: where that begins.
    let runs = |p: &Sample| p.slope.abs() <= LEVEL && p.gap.g.abs() <= loose;
    let flat =
        |p: &Sample| runs(p) && matches!(p.gap.segment, Some(Segment::Tip | Segment::LowerLine));
    let several = !simple(keep) && halvings > 0 && crests_between(keep, &a, &b);
    if (flat(&a) || flat(&b)) && !several {
        let mut found = |s| out.push(Crossing { s, touch: true, falls: a.slope < 0.0 });
        return way.below(keep, [a.s, b.s], &mut found);
    }
    if runs(&b) && !runs(&a) && !several {
        out.push(Crossing { s: way.level(keep, &b, &a)?, touch: true, falls: a.slope < 0.0 });
        return Ok(());
    }
    let far = a.gap.g.abs() + b.gap.g.abs() - 2.0 * loose > reach(way, keep, &a, &b);
    let turns = (a.slope > 0.0) != (b.slope > 0.0);
    let coarse = halvings > HALVINGS && !simple(keep);
    if turns && !coarse && !several && (!far || simple(keep)) {
        let m = way.extreme(keep, a, b, 1e-12, false)?;
        if m.gap.g.abs() <= loose {
            let s = way.middle(keep, &a, &m, &b)?;
            out.push(Crossing { s, touch: true, falls: a.slope < 0.0 });
        } else if m.gap.g.abs() < alike.abs() {
            *alike = m.gap.g;
        }
        return Ok(());
    }
    if far {
        return Ok(());
    }
    if halvings == 0 || simple(keep) {
        let about = if (a.gap.g > 0.0) != (b.gap.g > 0.0) {
            way.zero(keep, a, b, |p| p.gap.g, newton, way.track.exact)?
        } else if a.slope.abs() < b.slope.abs() {
            a
        } else {
            b
        };
        let at = way.inflection(keep, &about, loose)?;
        let at = at.filter(|p| p.s >= a.s && p.s <= b.s);
        out.extend(at.map(|p| Crossing { s: p.s, touch: true, falls: a.slope < 0.0 }));
        return Ok(());
    }
    let m = match way.sample(keep, 0.5 * (a.s + b.s), &a) {
        Err(_) if coarse => return tangencies(way, keep, a, b, loose, HALVINGS, alike, out),
        m => m?,
    };
    tangencies(way, keep, a, m, loose, halvings - 1, alike, out)?;
    tangencies(way, keep, m, b, loose, halvings - 1, alike, out)
}

/// May the way between two samples be tangent at several crests, as it goes as far as from one to the next? Where the surface between the
/// places of contact lies above the line through them, seen from the tool, it is one crest, and where it lies below that and the places
/// face each other one hollow.
fn crests_between(keep: &Keep, a: &Sample, b: &Sample) -> bool {
    /// Looks a span, and most of all.
    const EACH: f64 = 2.0;
    const MOST: f64 = 64.0;
    /// Share of the way between the places by which one counts as beside the line.
    const BESIDE: f64 = 1e-9;
    let (from, to) = (a.gap.spot(), b.gap.spot());
    let spans = keep.spans_between(from.at, to.at);
    let line = to.point - from.point;
    if spans <= ONE_CREST || ONE_CREST * line.norm() > spans * (b.s - a.s) {
        return false;
    }
    let (Some(begin), Some(end)) = (from.at, to.at) else { return false };
    let up = a.gap.normal + b.gap.normal;
    let up = up - line * (up.dot(&line) / line.norm_squared());
    let looks = (EACH * spans).ceil().min(MOST);
    let (mut above, mut below, mut k) = (false, false, 1.0);
    while k < looks {
        let share = k / looks;
        let at = Some(keep.surface.between([begin, end], share));
        let there = keep.surface.place(Spot { point: from.point + line * share, at }).point;
        let off = (there - from.point).dot(&up);
        above |= off > BESIDE * line.norm() * up.norm();
        below |= off < -BESIDE * line.norm() * up.norm();
        k += 1.0;
    }
    let face = a.gap.normal.dot(&line) > 0.0 && b.gap.normal.dot(&line) < 0.0;
    below && (above || !face)
}

impl Way<'_> {
    /// The middle of the stretch about the extreme `m` along which the gap keeps its value, `m` itself without one; where the axis
    /// turns and it goes on at `b`, its beginning.
    ///
    /// A flat end of the cutter lies along its part surface and touches a round check surface tangent to it all the time
    /// that the line of contact goes through below the flat: the tool stops where that line is below its end, as in APT-360.
    fn middle(&self, keep: &Keep, a: &Sample, m: &Sample, b: &Sample) -> Result<f64, Trouble> {
        let (from, to) = (self.level(keep, m, a)?, self.level(keep, m, b)?);
        let goes_on = self.turn.norm() > 0.0 && to >= b.s;
        Ok(if goes_on { from } else { 0.5 * (from + to) })
    }

    /// Where, going from `m` to `end`, the gap ceases to keep its value.
    fn level(&self, keep: &Keep, m: &Sample, end: &Sample) -> Result<f64, Trouble> {
        self.level_but(keep, m, end, LEVEL)
    }

    /// The same but for slopes up to `least`.
    fn level_but(&self, keep: &Keep, m: &Sample, end: &Sample, least: f64) -> Result<f64, Trouble> {
        let same = 2.0 * keep.width() + self.track.exact;
        let keeps = |p: &Sample| p.slope.abs() <= least && (p.gap.g - m.gap.g).abs() <= same;
        if keeps(end) {
            return Ok(end.s);
        }
        let (mut inside, mut outside) = (m.s, end.s);
        // The first look decides whether there is such a stretch at all.
        let mut s = m.s + 1e-6 * (end.s - m.s);
        for round in 0..ROUNDS {
            if keeps(&self.sample(keep, s, m)?) {
                inside = s;
            } else if round == 0 {
                return Ok(m.s);
            } else {
                outside = s;
            }
            if (outside - inside).abs() <= self.track.exact {
                break;
            }
            s = 0.5 * (inside + outside);
        }
        Ok(inside)
    }

    /// Where between two places the tool end is over a place at which a check surface that a flat end lies along is tangent: until
    /// there they come nearer, from there they part; over a hollow between two crests it is the reverse. The stretch itself may go on
    /// in the next cut vector.
    fn below(
        &self,
        keep: &Keep,
        [from, to]: [f64; 2],
        found: &mut impl FnMut(f64),
    ) -> Result<(), Trouble> {
        /// Looks a span, and most of all.
        const EACH: f64 = 2.0;
        const MOST: f64 = 256.0;
        let foot = |s: f64| -> Result<(Foot, Option<Ordering>), Trouble> {
            let node = self.node(s)?;
            let foot = keep.surface.foot(node.pose.te);
            let rate = (foot.normal * keep.side.sign()).dot(&self.rate(&node));
            Ok((foot, if rate.abs() <= LEVEL { 0.0 } else { rate }.partial_cmp(&0.0)))
        };
        let parting = |s: f64| -> Result<Option<Ordering>, Trouble> { Ok(foot(s)?.1) };
        let [(begin, mut before), (end, last)] = [foot(from)?, foot(to)?];
        let looks = (EACH * keep.spans_between(begin.at, end.at)).ceil().clamp(1.0, MOST);
        let (mut here, mut k) = (from, 1.0);
        while k <= looks {
            let next = if k < looks { from + (to - from) * (k / looks) } else { to };
            let there = if k < looks { parting(next)? } else { last };
            if before != Some(Ordering::Greater) && there != before {
                let (mut near, mut far) = (here, next);
                for _ in 0..ROUNDS {
                    if far - near <= self.track.exact {
                        break;
                    }
                    let mid = 0.5 * (near + far);
                    *(if parting(mid)? == before { &mut near } else { &mut far }) = mid;
                }
                found(far);
            }
            (here, before, k) = (next, there, k + 1.0);
        }
        Ok(())
    }

    /// How far the check surface runs along with the way from its beginning, where the tool touches it there; all of the cut
    /// vector where they do not part on it.
    ///
    /// The straight end of a TABCYL lies along the line that it is tangent to: the motion to it ends where they part, though
    /// nothing but that stretch says that they are tangent. APT-360 stops at once; along the check surface it is the same way.
    ///
    /// It is looked at in pieces: beyond a hump on it the check surface may lie along the same line again.
    pub(super) fn alongside(
        &self,
        keep: &Keep,
        loose: f64,
        piece: f64,
    ) -> Result<Option<f64>, Trouble> {
        let at = |node: &Node, s: f64| -> Result<Sample, Trouble> {
            Ok(self.read(node, s, read(keep, node, None)?))
        };
        let start = at(self.from, 0.0)?;
        if start.gap.g.abs() > loose || start.slope.abs() > ALONG {
            return Ok(None);
        }
        // What is level to rounding leaves it as exactly.
        let least = if start.slope.abs() <= LEVEL { LEVEL } else { ALONG };
        let whole = at(&self.stride.to, self.stride.length).ok();
        let Some(end) = whole.or_else(|| self.last_facing(keep, &start)) else { return Ok(None) };
        let (mut here, pieces) = (start, (end.s / piece).ceil().clamp(1.0, PIECES));
        let mut k = 1.0;
        while k <= pieces {
            let next = if k < pieces { self.sample(keep, end.s * k / pieces, &here)? } else { end };
            let s = self.level_but(keep, &here, &next, least)?;
            if s < next.s {
                return Ok(Some(s));
            }
            (here, k) = (next, k + 1.0);
        }
        Ok(Some(end.s))
    }

    /// The place about `m`, where the gap is small, at which the way comes nearest to running along with the check surface, if it does
    /// but for [`ALMOST`]: the gap does not turn back there, as where the one goes on straight that the other bends away from.
    fn inflection(&self, keep: &Keep, m: &Sample, loose: f64) -> Result<Option<Sample>, Trouble> {
        let off = |p: &Sample| p.slope.abs();
        if off(m) > GRAZING || m.gap.g.abs() > LOOSE * loose {
            return Ok(None);
        }
        // About it, as far as the gap is not much more than what a tangency may be off.
        let edge = |sense: f64| {
            let (mut to, mut by) = (m.s, loose);
            for _ in 0..ROUNDS {
                let s = (m.s + sense * by).clamp(0.0, self.stride.length);
                let near = |p: Sample| p.gap.g.abs() <= LOOSE * loose;
                if (s - to).abs() <= 0.0 || !self.sample(keep, s, m).is_ok_and(near) {
                    break;
                }
                (to, by) = (s, 2.0 * by);
            }
            to
        };
        let (mut low, mut high) = (edge(-1.0), edge(1.0));
        let mut best = *m;
        for _ in 0..ROUNDS {
            if high - low <= self.track.exact {
                break;
            }
            let [s, t] = [low + GOLDEN * (high - low), high - GOLDEN * (high - low)];
            let [p, q] = [self.sample(keep, s, &best)?, self.sample(keep, t, &best)?];
            let nearer = if off(&p) <= off(&q) { p } else { q };
            (low, high) = if off(&p) <= off(&q) { (low, t) } else { (s, high) };
            best = if off(&nearer) < off(&best) { nearer } else { best };
        }
        // At an end of the cut vector the next one may come nearer.
        let inside = best.s > 0.0 && best.s < self.stride.length || off(&best) <= ALONG;
        let is_one = inside && off(&best) <= ALMOST && best.gap.g.abs() <= loose;
        Ok(is_one.then_some(best))
    }
}
