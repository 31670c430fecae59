//! TANTO and PSTAN: a motion ends at the first place where the check surface is tangent to drive or part surface.
//!
//! The gap to the check surface is followed from the start to the end. Where it comes from clear of the band into it, is touched in the
//! direction in which the other surface is, in the bands of both, and is clear of the band again before the motion ends, that place
//! was passed; with n,INTOF the n-th of them. Where it is not clear again, as both surfaces go on as one from a joint, over which a
//! surface goes on straight, the place is where they begin to: up to there the gaps to both differ, from there on by no more than
//! where the motion ends. Left out is what a motion may pass: where it begins, unless both surfaces run along with
//! each other from there, what only one band could take up, and what touches elsewhere on the cutter.

use aptc_cldata::{Control, Position, Relation};
use aptc_geometry::{Profile, Vec3};

use crate::between::{Way, angle};
use crate::demand::Demand;
use crate::sheet::Spot;
use crate::sheets::Sheets;
use crate::tool::Pose;

/// Half bands from the middle of the band at which the tool is clear of it. Between two places of a path its chords move it by two.
const CLEAR: f64 = 5.0;
/// The same up to which it may be in the band where that of the other surface takes up the rest, and share of the narrower band that
/// is left to both.
const HELD: f64 = 1.5;
const SPARE: f64 = 0.1;
/// Half bands by which another place of the check surface is nearer and not the same.
const ANOTHER: f64 = 0.2;
/// Looks along a motion.
const LOOKS: u32 = 4000;
/// Looks for the place where both directions are nearest to each other.
const ROUNDS: u32 = 30;
/// The lesser share of the golden section.
const GOLDEN: f64 = 0.381_966_011_250_105;
/// Sine of the angle between the directions of two surfaces that are tangent, and of that at which the place where they are is
/// looked for.
const LEVEL: f64 = 2e-3;
const GRAZING: f64 = 0.3;
/// Half bands for which surfaces run along with each other, and share of one by which they do.
const LONG: f64 = 50.0;
const ALONG: f64 = 1e-5;
/// Half bands by which the gaps to surfaces that are one may differ otherwise than at the end.
const ONE: f64 = 1e-3;
/// How far beyond the end, in ways from where they become one, they are to be one as well: a flat end or a flank lies along another
/// surface for a while, and stops in the middle of that.
const ONWARDS: f64 = 1.25;

/// A place that a motion passed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Passed {
    /// The number of the vector, counted from 0.
    pub(crate) vector: usize,
    pub(crate) te: Vec3,
    /// The way from there to the end.
    pub(crate) by: f64,
}

/// The tangency that a motion to a tangent check surface passed, if it did for certain.
pub(crate) fn goes_past(
    control: &Control,
    start: &Position,
    points: &[Position],
    profile: &Profile,
    sheets: &Sheets,
) -> Option<Passed> {
    let check = control.checks.first().filter(|c| c.disk.is_none())?;
    let other = match check.relation {
        Relation::Tanto => control.drive.as_ref(),
        Relation::Pstan => control.part.as_ref(),
        _ => None,
    };
    let other = other.filter(|c| c.disk.is_none())?;
    let (gap, beside) = (Demand::new(check, sheets), Demand::new(other, sheets));
    let half = 0.5 * (gap.most - gap.least);
    let ways = Ways::new(start, points, profile);
    if !(half > 0.0 && ways.length() > 0.0) {
        return None;
    }
    let motion = Motion { ways, gap, beside, half, nth: check.nth.max(1), profile };
    motion.passed()
}

/// A path by the way that any point of the tool goes at most.
struct Ways {
    poses: Vec<Pose>,
    /// Where each of them is.
    at: Vec<f64>,
}

struct Motion<'a> {
    ways: Ways,
    gap: Demand,
    /// The surface to which the check surface is to be tangent.
    beside: Demand,
    half: f64,
    /// Which of the tangencies is meant, counted from 1.
    nth: u32,
    profile: &'a Profile,
}

/// A look: the place, and the gap from the middle of the band; infinite where the tool is clear and it is not known how far.
#[derive(Clone, Copy, Debug)]
struct Look {
    s: f64,
    off: f64,
    /// Where the surface was met.
    spot: Option<Spot>,
}

impl Ways {
    fn new(start: &Position, points: &[Position], profile: &Profile) -> Self {
        let poses: Vec<Pose> = std::iter::once(start).chain(points).map(Pose::of).collect();
        let mut at = vec![0.0];
        let mut s = 0.0;
        for w in poses.windows(2) {
            s += (w[1].te - w[0].te).norm() + profile.reach() * angle(w[0].ta, w[1].ta);
            at.push(s);
        }
        Self { poses, at }
    }

    fn length(&self) -> f64 {
        self.at[self.at.len() - 1]
    }

    /// The vector there, counted from 0, and the position.
    fn pose(&self, s: f64) -> (usize, Pose) {
        let i = self.at.partition_point(|x| *x <= s).clamp(1, self.at.len() - 1);
        let [from, to] = [self.at[i - 1], self.at[i]];
        let t = if to > from { ((s - from) / (to - from)).clamp(0.0, 1.0) } else { 1.0 };
        (i - 1, Way::new(self.poses[i - 1], self.poses[i]).at(t))
    }
}

impl Motion<'_> {
    /// Goes along the motion: clear of the check surface about as far as it stays so.
    fn passed(&self) -> Option<Passed> {
        let (end, clear) = (self.ways.length(), CLEAR * self.half);
        let fine = self.half.max(1e-6 * end);
        // What was seen since the tool was clear last; nothing until it was.
        let mut zone: Vec<Look> = Vec::new();
        let (mut begun, mut count) = (false, 0);
        let (mut s, mut step, mut spot) = (0.0, fine, None);
        let first = self.look(0.0, f64::INFINITY, &mut spot);
        let (mut before, mut other) = (first, first);
        for _ in 0..LOOKS {
            let now = self.nearest(s, before.off, &mut spot);
            if now.off.abs() > clear {
                zone.push(now);
                let found = match begun {
                    true if zone.len() > 2 => self.tangent(&zone),
                    false if s > 0.0 => self.along(first, now),
                    _ => None,
                };
                count += u32::from(found.is_some());
                if count == self.nth {
                    return found;
                }
                (begun, step) = (true, fine);
                zone.clear();
                zone.push(now);
                s += self.free([&other, &before, &now], now.off.abs() - clear).max(fine);
            } else {
                zone.push(now);
                let change = (now.off - before.off).abs();
                if change < 0.2 * self.half {
                    step *= 2.0;
                } else if change > self.half {
                    step = (0.5 * step).max(fine);
                }
                s += step;
            }
            (other, before) = (before, now);
            if s >= end {
                return (count + 1 == self.nth).then(|| self.as_one(&zone, end)).flatten();
            }
        }
        None
    }

    /// The place from which on the check surface and the other are one to the end of the motion, where they were not since the first
    /// of these looks, and are so for longer than they took to come together from half a band apart.
    fn as_one(&self, zone: &[Look], end: f64) -> Option<Passed> {
        let first = zone.first()?;
        let last = self.nearest(end, zone.last()?.off, &mut None);
        let held = last.off.abs() <= CLEAR * self.half && self.is_alone(&last, ANOTHER);
        let miss = self.miss(&self.ways.pose(end).1)?;
        // By how much more they are apart; where that is not known they are not one.
        let more = |pose: &Pose| self.miss(pose).map_or(f64::INFINITY, |m| (m - miss).abs());
        let there = |s: f64| self.ways.pose(s).1;
        let same = |pose: &Pose| more(pose) <= ONE * self.half;
        if !held || self.apart(&last).is_none_or(|angle| angle > LEVEL) || same(&there(first.s)) {
            return None;
        }
        let place = border([first.s, end], |s| same(&there(s)));
        let begun = border([first.s, place], |s| more(&there(s)) <= self.half);
        let (from, to) = (there(place), there(end));
        let passed = self.at(place);
        let coming = (from.te - there(begun).te).norm();
        let way = to.te - from.te;
        let between = [0.25, 0.5, 0.75].map(|share| there(place + share * (end - place)));
        let beyond = [0.5 * ONWARDS, ONWARDS].map(|t| Pose { te: to.te + way * t, ..to });
        // A flat end comes over a joint for as long as it is wide.
        let [[flat, _], _] = self.profile.joints();
        let long = passed.by > (LONG * self.half).max(coming) + 2.0 * flat;
        (long && between.iter().chain(&beyond).all(same)).then_some(passed)
    }

    /// By how much the gap to the check surface is more than that to the other.
    fn miss(&self, pose: &Pose) -> Option<f64> {
        let gap = |demand: &Demand| demand.beside_tangent(self.profile, pose);
        let miss = gap(&self.gap)? - gap(&self.beside)?;
        miss.is_finite().then_some(miss)
    }

    /// How far the tool may go from the last look on until it has gone `room`: by half of what it takes at the rate of before, and no
    /// more than four times as far as the tool is clear; no farther than that where it comes nearer again, or goes away.
    fn free(&self, [other, before, now]: [&Look; 3], room: f64) -> f64 {
        const FARTHER: f64 = 4.0;
        if !room.is_finite() {
            return 0.1 * self.profile.reach();
        }
        let rate = |a: &Look, b: &Look| (b.off - a.off) / (b.s - a.s);
        let (last, now) = (rate(other, before), rate(before, now));
        let turns = last * now < 0.0;
        if now.is_finite() && !turns { room * (0.5 / now.abs()).clamp(1.0, FARTHER) } else { room }
    }

    /// Of what is not known the sign is that of before.
    fn look(&self, s: f64, before: f64, spot: &mut Option<Spot>) -> Look {
        let middle = 0.5 * (self.gap.least + self.gap.most);
        let found = self.gap.beside(self.profile, &self.ways.pose(s).1, spot);
        let off = found.map(|(gap, _)| gap - middle).filter(|off| off.is_finite());
        Look { s, off: off.unwrap_or(f64::INFINITY.copysign(before)), spot: *spot }
    }

    /// The same, anew where another place of the surface is nearer than the one beside that of before: a wide cutter comes from crest
    /// to crest.
    fn nearest(&self, s: f64, before: f64, spot: &mut Option<Spot>) -> Look {
        let now = self.look(s, before, spot);
        if !now.off.is_finite() || self.is_alone(&now, ANOTHER) {
            return now;
        }
        *spot = None;
        self.look(s, before, spot)
    }

    /// The gap at a place near a look.
    fn near(&self, s: f64, of: &Look) -> f64 {
        self.look(s, of.off, &mut of.spot.clone()).off
    }

    /// Is there a place between the first look and the last, which are clear, where the check surface is tangent?
    fn tangent(&self, zone: &[Look]) -> Option<Passed> {
        let [first, last] = [zone[0], zone[zone.len() - 1]];
        let held = |l: &&Look| l.off.abs() <= HELD * self.half;
        let apart = |l: &Look| self.apart(l).unwrap_or(f64::INFINITY);
        let looks = zone.iter().filter(held).map(|l| (*l, apart(l)));
        let (of, angle) = looks.min_by(|a, b| a.1.total_cmp(&b.1))?;
        if angle > GRAZING {
            return None;
        }
        // Between the looks beside it.
        let after = zone.partition_point(|l| l.s <= of.s);
        let ends = [zone[after.max(2) - 2].s, zone[after.min(zone.len() - 1)].s];
        let at = |s: f64| self.look(s, of.off, &mut of.spot.clone());
        let place = least(ends, |s| apart(&at(s)));
        let now = at(place);
        let tangent = now.off.abs() <= HELD * self.half
            && self.in_both(&now)
            && apart(&now) <= LEVEL
            // No other place of the surface tells something else.
            && self.is_alone(&now, ANOTHER)
            && [first, last].iter().all(|l| self.is_alone(l, 2.0));
        tangent.then(|| self.at(place))
    }

    /// Is no other place of the check surface nearer by more than so many half bands? Where the tool is deep in it nothing is asked.
    fn is_alone(&self, of: &Look, half_bands: f64) -> bool {
        let gap = of.off + 0.5 * (self.gap.least + self.gap.most);
        let by = gap.min(self.profile.reach()) - half_bands * self.half;
        let deep = of.off < -CLEAR * self.half;
        deep || self.gap.is_clear(self.profile, &self.ways.pose(of.s).1, by)
    }

    /// Does the check surface run along with the motion from its start, and leave it before it ends? The place where it does.
    fn along(&self, first: Look, clear: Look) -> Option<Passed> {
        let runs = |s: f64| (self.near(s, &first) - first.off).abs() <= ALONG * self.half;
        let (mut low, mut high) = (LONG * self.half, clear.s);
        let looks = [0.3, 0.6, 1.0];
        if !self.in_both(&first) || low >= high || !looks.iter().all(|share| runs(share * low)) {
            return None;
        }
        for _ in 0..2 * ROUNDS {
            let middle = 0.5 * (low + high);
            *(if runs(middle) { &mut low } else { &mut high }) = middle;
        }
        let there = self.look(0.5 * low, first.off, &mut first.spot.clone());
        let alike = self.apart(&there).is_some_and(|angle| angle <= LEVEL);
        let held = alike && self.is_alone(&there, ANOTHER);
        (held && self.is_alone(&clear, 2.0)).then(|| self.at(low))
    }

    fn at(&self, s: f64) -> Passed {
        let (vector, pose) = self.ways.pose(s);
        let rest = self.ways.poses[vector + 1..].windows(2).map(|w| (w[1].te - w[0].te).norm());
        let by = (self.ways.poses[vector + 1].te - pose.te).norm() + rest.sum::<f64>();
        Passed { vector, te: pose.te, by }
    }

    /// Are there places in the bands of both surfaces, beside one in the direction in which both are touched?
    fn in_both(&self, of: &Look) -> bool {
        let pose = self.ways.pose(of.s).1;
        let Some((gap, _)) = self.beside.beside(self.profile, &pose, &mut None) else {
            return false;
        };
        let b = [self.beside.least - gap, self.beside.most - gap];
        let a = [-self.half - of.off, self.half - of.off];
        let least = (a[1] - a[0]).min(b[1] - b[0]);
        a[1].min(b[1]) - a[0].max(b[0]) >= SPARE * least
    }

    /// The sine of the angle between the directions in which both surfaces are touched.
    fn apart(&self, of: &Look) -> Option<f64> {
        let pose = self.ways.pose(of.s).1;
        let a = self.direction(&self.gap, &pose, of.spot)?;
        let b = self.direction(&self.beside, &pose, None)?;
        (a.dot(&b) > 0.0).then(|| a.cross(&b).norm())
    }

    /// The direction away from a surface, of a closed form by the gaps about a place.
    fn direction(&self, demand: &Demand, pose: &Pose, mut spot: Option<Spot>) -> Option<Vec3> {
        if let (_, Some(away)) = demand.beside(self.profile, pose, &mut spot)? {
            return Some(away);
        }
        let by = (0.1 * self.half).max(1e-6 * (self.profile.reach() + pose.te.norm()));
        let gap =
            |e: Vec3| demand.gap_at(self.profile, &Position { te: pose.te + e * by, ta: pose.ta });
        let along = |e: Vec3| Some((gap(e)? - gap(-e)?) / (2.0 * by));
        let n = Vec3::new(along(Vec3::x())?, along(Vec3::y())?, along(Vec3::z())?);
        // Where several places touch it is none.
        let one = (n.norm() - 1.0).abs() <= LEVEL;
        one.then(|| n.normalize())
    }
}

/// The place between two from which on something holds that does so at the second and not at the first; the first where it does there.
fn border([mut low, mut high]: [f64; 2], holds: impl Fn(f64) -> bool) -> f64 {
    if holds(low) {
        return low;
    }
    for _ in 0..2 * ROUNDS {
        let middle = 0.5 * (low + high);
        *(if holds(middle) { &mut high } else { &mut low }) = middle;
    }
    high
}

/// The place between two where a function is least.
fn least([mut low, mut high]: [f64; 2], value: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..ROUNDS {
        let [s, t] = [low + GOLDEN * (high - low), high - GOLDEN * (high - low)];
        (low, high) = if value(s) <= value(t) { (low, t) } else { (s, high) };
    }
    0.5 * (low + high)
}
