//! Passes followed from place to place: does what the tool takes along two of them clear what lies between?
//!
//! The width of a step is told by how far the cutter reaches beside its contact as it goes straight on. A sharp rim clears a place
//! beside the contact a little before or behind, and where its axis turns on the way, or its bottom swings, it stands otherwise there.

use aptc_contact::{Convex, Swept, Tool, axis_between};
use aptc_geometry::{Vec3, trig};

use crate::jump::Pair;
use crate::lanes::Lane;
use crate::position::Position;
use crate::region::Region;
use crate::stepover::kept;

/// Places along a pass, in a span of the drive and in all.
const PLACES: f64 = 16.0;
const MOST: f64 = 400.0;
/// A step at which something is left is made shorter so many times, by this factor.
const CLOSER: u32 = 6;
const SHORTER: f64 = 0.75;
/// Parts of a way with a turn that are looked at, and rounds that close in on where the tool is nearest.
const PARTS: u32 = 4;
const ROUNDS: u32 = 16;

/// Halvings that close in on where a pass ends to clear.
const CLOSE: u32 = 7;

/// Tool ends and axes at both ends of a way.
type Way = [(Vec3, Vec3); 2];

impl Region<'_> {
    /// The step across, shorter where the tool leaves more than the scallop between the pass and the next. Where a far shorter one
    /// leaves more too that is no matter of the step, and it stays as it is.
    pub(crate) fn followed(&self, lane: &Lane, step: f64) -> f64 {
        if self.setup.profile.is_round() || !self.setup.part.touches {
            return step;
        }
        let mut closer = step;
        for _ in 0..CLOSER {
            if self.all_cleared(lane, closer) {
                return closer;
            }
            closer *= SHORTER;
        }
        step
    }

    fn all_cleared(&self, lane: &Lane, step: f64) -> bool {
        let k = self.course.index();
        let length = lane.to - lane.from[k];
        let n = (length.abs() * PLACES).ceil().clamp(PLACES, MOST);
        let mut pairs: Vec<Pair> = Vec::new();
        let mut i = 0.0;
        while i <= n {
            // What cannot be reached the pass will tell.
            pairs.extend(self.pair(lane, step, lane.from[k] + length * (i / n), pairs.last()));
            i += 1.0;
        }
        let (ways, from) = self.ways(lane, &pairs);
        // Between places that are looked at it may stand a little higher.
        let high = self.setup.thick() + kept(self.stepover.scallop, &self.setup);
        pairs.iter().zip(from).all(|(pair, from)| {
            self.cleared(pair, &|pass, (place, normal)| {
                let x = place + normal * high;
                // The nearest ways first.
                let (before, behind) = ways[pass].split_at(from);
                let takes = |way: &Way| self.takes(way, x);
                let near = 4.min(before.len());
                let (far, close) = before.split_at(before.len() - near);
                close.iter().rev().any(takes) || behind.iter().chain(far).any(takes)
            })
        })
    }

    /// Is all between two places cleared by the one pass or the other? What stands highest is where the first ends to clear, be that
    /// between the places that are looked at.
    fn cleared(&self, pair: &Pair, takes: &impl Fn(usize, (Vec3, Vec3)) -> bool) -> bool {
        let (mut near, mut beyond) = (0.0, None);
        for (f, place) in self.places(pair) {
            if beyond.is_none() && takes(0, place) {
                near = f;
            } else if takes(1, place) || beyond.is_some() && takes(0, place) {
                beyond.get_or_insert(f);
            } else {
                return false;
            }
        }
        let Some(mut beyond) = beyond else { return true };
        for _ in 0..CLOSE {
            let middle = 0.5 * (near + beyond);
            let Some(place) = self.place(pair, middle) else { return true };
            if takes(0, place) {
                near = middle;
            } else if takes(1, place) {
                beyond = middle;
            } else {
                return false;
            }
        }
        true
    }

    /// The ways between places of each pass, with how many of them lie before each pair. At ends, and on both sides of an edge,
    /// the tool counts as going straight on.
    fn ways(&self, lane: &Lane, pairs: &[Pair]) -> ([Vec<Way>; 2], Vec<usize>) {
        let mut ways: [Vec<Way>; 2] = Default::default();
        let mut from = Vec::new();
        for (i, pair) in pairs.iter().enumerate() {
            let before =
                i.checked_sub(1).map(|i| &pairs[i]).filter(|b| !self.parted(lane, b, pair));
            let ends = i + 1 == pairs.len() || self.parted(lane, pair, &pairs[i + 1]);
            from.push(ways[0].len());
            for (k, (p, _)) in pair.both.iter().enumerate() {
                let here = (p.te, p.ta);
                let on = self.straight_on(lane, p);
                ways[k].push(before.map_or([(p.te - on, p.ta), here], |b| {
                    let q = &b.both[k].0;
                    [(q.te, q.ta), here]
                }));
                if ends {
                    ways[k].push([here, (p.te + on, p.ta)]);
                }
            }
        }
        (ways, from)
    }

    /// As far as the tool is wide along the lane.
    fn straight_on(&self, lane: &Lane, p: &Position) -> Vec3 {
        let drive = self.setup.drive.place(p.drive_uv, self.course);
        let along = drive.along - p.normal * drive.along.dot(&p.normal);
        let along = along.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        along * (self.setup.profile.widest() * lane.sense)
    }

    /// Does an edge of the drive lie between two pairs?
    fn parted(&self, lane: &Lane, a: &Pair, b: &Pair) -> bool {
        let joint = if lane.sense > 0.0 { (a.t + 1e-9).ceil() } else { (a.t - 1e-9).floor() };
        if (joint - b.t) * lane.sense > 1e-9 {
            return false;
        }
        let mut uv = a.both[0].0.drive_uv;
        uv[self.course.index()] = joint;
        self.setup.at_edge(uv, (self.course, 1.0)) || self.setup.at_edge(uv, (self.course, -1.0))
    }

    /// Is a point in the cutter somewhere on a way?
    fn takes(&self, [a, b]: &Way, x: Vec3) -> bool {
        let profile = self.setup.profile;
        let by = b.0 - a.0;
        let turn = trig::angle_between(a.1, b.1);
        let ta = axis_between(a.1, b.1, 0.5);
        let off = 0.5 * turn * (x - a.0).norm().max((x - b.0).norm());
        // From half way it comes nearer by no more than it goes.
        let half = Tool { profile, te: a.0 + by * 0.5, ta }.distance(x);
        if half > off + 0.5 * by.norm() {
            return false;
        }
        let near = Swept { tool: Tool { profile, te: a.0, ta }, by }.near(x).0;
        if near > off || near <= -off {
            return near <= -off;
        }
        let distance = |t: f64| {
            let (te, ta) = (a.0 + by * t, axis_between(a.1, b.1, t));
            Tool { profile, te, ta }.distance(x)
        };
        let part = 1.0 / f64::from(PARTS);
        let all = (0..=PARTS).map(|i| f64::from(i) * part).map(|t| (distance(t), t));
        let Some((least, t)) = all.min_by(|a, b| a.0.total_cmp(&b.0)) else { return false };
        if least <= 0.0 {
            return true;
        }
        let [mut low, mut high] = [(t - part).max(0.0), (t + part).min(1.0)];
        for _ in 0..ROUNDS {
            let third = (high - low) / 3.0;
            if distance(low + third) < distance(high - third) {
                high -= third;
            } else {
                low += third;
            }
        }
        distance(0.5 * (low + high)) <= 0.0
    }
}
