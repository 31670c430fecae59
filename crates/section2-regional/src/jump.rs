//! Passes between which the contact jumps across the bottom of the cutter.
//!
//! On the near side of a crest the one rim of a flat bottom touches, on the far side the other, so that both passes stand
//! off to their own side of what is between them and neither clears it, however wide the cutter is. How far each reaches
//! beside its contact does not tell that: here it is asked whether the two together clear the places between.

use aptc_contact::{Convex, Swept, Tool};
use aptc_geometry::Vec3;

use crate::lanes::Lane;
use crate::position::Position;
use crate::region::Region;
use crate::solve::{Memory, Take};

/// Stretches of a pass that are looked at first, in a span of the drive and in all.
const STRETCHES: f64 = 5.0;
const MOST: f64 = 4_000.0;
/// Halvings of a stretch along which the contact swings, down to this part of how far the passes are apart.
const HALVINGS: u32 = 12;
const FINE: f64 = 0.25;
/// Part of a jump by which the contact of a pass may go on within a stretch that is looked at no closer.
const STEADY: f64 = 0.25;
/// Places between the contacts of two passes.
const BETWEEN: u32 = 12;
/// A step at which something is left is made shorter so many times, by this factor.
const CLOSER: u32 = 32;
const SHORTER: f64 = 0.75;
/// Summits between a pass and the next that are gone to.
const SUMMITS: u32 = 3;
/// Halvings of a height.
const HEIGHT: u32 = 30;

/// What is left between two passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stands {
    /// Above the thickness; infinite where neither pass comes over it.
    pub(crate) height: f64,
    /// The place of the part surface below it.
    pub(crate) place: Vec3,
}

/// Places of two passes beside each other.
#[derive(Clone, Copy)]
pub(crate) struct Pair {
    /// Parameter along the passes.
    pub(crate) t: f64,
    pub(crate) both: [(Position, Memory); 2],
}

impl Pair {
    /// From the contacts to the tool ends.
    fn arms(&self) -> [Vec3; 2] {
        self.both.each_ref().map(|(p, _)| p.te - p.contact)
    }

    fn apart(&self) -> f64 {
        (self.both[1].0.contact - self.both[0].0.contact).norm()
    }
}

impl Region<'_> {
    /// The step across, shorter where the contact jumps and something higher than the scallop would be left: to a summit
    /// between the two, or less.
    pub(crate) fn closed(&self, lane: &Lane, wide: f64) -> f64 {
        let high = self.setup.thick() + self.stepover.scallop;
        let (mut step, mut summits) = (wide, 0);
        for _ in 0..CLOSER {
            let mut stands = None;
            self.jumps(lane, step, &mut |pair| {
                let clear = self.places(pair).all(|(_, place)| self.clears(pair, place, high));
                stands = (!clear).then_some(*pair);
                clear
            });
            let Some(pair) = stands else { return step };
            let summit = (summits < SUMMITS).then(|| self.summit(lane, step, &pair)).flatten();
            summits += u32::from(summit.is_some());
            step = summit.unwrap_or(SHORTER * step);
        }
        // Where a far shorter one leaves something too that is no matter of the step.
        wide
    }

    /// The highest of what is left between passes where the contact jumps; `ways` has the positions of each.
    pub(crate) fn stands(&self, lanes: &[Lane], ways: &[Vec<(Vec3, Vec3)>]) -> Option<Stands> {
        let across = self.course.across().index();
        let thick = self.setup.thick();
        let mut highest: Option<Stands> = None;
        for (lane, ways) in lanes.iter().zip(ways.windows(2)) {
            let Some(next) = lane.next else { continue };
            self.jumps(lane, (next - lane.from[across]).abs(), &mut |pair| {
                for (_, place) in self.places(pair) {
                    let known = highest.map_or(0.0, |h| h.height);
                    if known == f64::INFINITY {
                        return false;
                    }
                    let covered = |high: f64| self.covered(ways, place, thick + high);
                    if !self.clears(pair, place, thick + known) && !covered(known) {
                        let height = self.height(known, &covered);
                        highest = Some(Stands { height, place: place.0 });
                    }
                }
                true
            });
        }
        highest
    }

    /// Calls `look` for places of a pass and of the next, a step across, between which the contact jumps, until one says no.
    fn jumps(&self, lane: &Lane, step: f64, look: &mut dyn FnMut(&Pair) -> bool) -> bool {
        let jump = self.setup.profile.corner()[0];
        if jump <= 0.0 || !self.setup.part.touches {
            return true;
        }
        let k = self.course.index();
        let length = lane.to - lane.from[k];
        let n = (length.abs() * STRETCHES).ceil().clamp(STRETCHES, MOST);
        let pair = |t: f64, near: Option<&Pair>| self.pair(lane, step, t, near);
        let swings = |a: [Vec3; 2], b: [Vec3; 2]| {
            let all = [a[0], a[1], b[0], b[1]];
            all.iter().any(|p| all.iter().any(|q| (p - q).norm() > jump))
        };
        // Where passes go to and fro the bottom may lie on the surface all along with its one side and its other.
        let steady = |a: &Pair, b: &Pair| {
            let (a, b) = (a.arms(), b.arms());
            (0..2).all(|k| (a[k] - b[k]).norm() <= STEADY * jump)
        };
        let mut before: Option<Pair> = None;
        let mut i = 0.0;
        while i <= n {
            let now = pair(lane.from[k] + length * (i / n), before.as_ref());
            if let Some(now) = &now
                && swings(now.arms(), now.arms())
                && !look(now)
            {
                return false;
            }
            let mut stack: Vec<(Pair, Pair, u32)> =
                before.zip(now).map(|(a, b)| (a, b, 0)).into_iter().collect();
            while let Some((a, b, halvings)) = stack.pop() {
                let long = (b.both[0].0.contact - a.both[0].0.contact).norm();
                let fine = FINE * a.apart().max(b.apart());
                let swings_on = swings(a.arms(), b.arms()) && !steady(&a, &b);
                if halvings >= HALVINGS || long <= fine || !swings_on {
                    continue;
                }
                let Some(mid) = pair(0.5 * (a.t + b.t), Some(&a)) else { continue };
                if swings(mid.arms(), mid.arms()) && !look(&mid) {
                    return false;
                }
                stack.push((mid, b, halvings + 1));
                stack.push((a, mid, halvings + 1));
            }
            before = now.or(before);
            i += 1.0;
        }
        true
    }

    /// Places of both passes at a parameter; `None` where one of them cannot be reached.
    pub(crate) fn pair(&self, lane: &Lane, step: f64, t: f64, near: Option<&Pair>) -> Option<Pair> {
        let across = self.course.across();
        let [low, high] = self.setup.drive.limits(across);
        let over = self.senses[1];
        let at = |i: usize| {
            let mut uv = lane.from;
            uv[self.course.index()] = t;
            // Passes to and fro go in turns.
            let back = i == 1 && self.clearance.is_none();
            let sense = if back { -lane.sense } else { lane.sense };
            if i == 1 {
                let v = uv[across.index()] + over * step;
                uv[across.index()] = v.clamp(low.min(high), low.max(high));
            }
            let memory = near.map(|pair| pair.both[i].1);
            self.setup.position(uv, self.course, sense, memory, Take::Nothing).ok()
        };
        Some(Pair { t, both: [at(0)?, at(1)?] })
    }

    /// Shares of the way from contact to contact, with the places of the part surface there and the normals.
    pub(crate) fn places(&self, pair: &Pair) -> impl Iterator<Item = (f64, (Vec3, Vec3))> {
        let shares = (1..BETWEEN).map(|i| f64::from(i) / f64::from(BETWEEN));
        shares.filter_map(|f| Some((f, self.place(pair, f)?)))
    }

    pub(crate) fn place(&self, pair: &Pair, f: f64) -> Option<(Vec3, Vec3)> {
        let part = self.setup.part;
        let [a, b] = pair.both.map(|(p, _)| p);
        let [u, v] = [0, 1].map(|k| a.part_uv[k] + f * (b.part_uv[k] - a.part_uv[k]));
        let place = part.surface.at(u, v).point;
        let normal = part.surface.normal_at(u, v)? * part.side;
        // Parameters that do not run through from patch to patch lead elsewhere.
        let beside = (place - a.contact).norm() + (place - b.contact).norm();
        (beside <= 2.0 * pair.apart()).then_some((place, normal))
    }

    /// Does one of the two, going straight on, come over a place at a height?
    fn clears(&self, pair: &Pair, (place, normal): (Vec3, Vec3), high: f64) -> bool {
        let profile = self.setup.profile;
        pair.both.iter().any(|(p, _)| {
            let drive = self.setup.drive.place(p.drive_uv, self.course);
            let along = drive.along - p.normal * drive.along.dot(&p.normal);
            let way = along.try_normalize(0.0).unwrap_or_else(Vec3::zeros) * profile.widest();
            let tool = Tool { profile, te: p.te - way, ta: p.ta };
            Swept { tool, by: way * 2.0 }.near(place + normal * high).0 <= 0.0
        })
    }

    /// Does the cutter come over a place at a height on one of the ways?
    fn covered(
        &self,
        ways: &[Vec<(Vec3, Vec3)>],
        (place, normal): (Vec3, Vec3),
        high: f64,
    ) -> bool {
        let profile = self.setup.profile;
        let x = place + normal * high;
        ways.iter().flat_map(|way| way.windows(2)).any(|ends| {
            let [(a, ta), (b, _)] = [ends[0], ends[1]];
            let by = b - a;
            let near = (x - a).norm() <= profile.reach() + by.norm();
            near && Swept { tool: Tool { profile, te: a, ta }, by }.near(x).0 <= 0.0
        })
    }

    /// How high it stands, above the thickness, where it is known to stand as high as `known`.
    fn height(&self, known: f64, covered: &impl Fn(f64) -> bool) -> f64 {
        let (mut low, mut high) = (known, known + 2.0 * self.setup.profile.widest());
        if !covered(high) {
            return f64::INFINITY;
        }
        for _ in 0..HEIGHT {
            let middle = 0.5 * (low + high);
            *(if covered(middle) { &mut high } else { &mut low }) = middle;
        }
        high
    }
}
