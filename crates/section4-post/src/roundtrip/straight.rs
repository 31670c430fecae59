//! A straight step: to the next position, or past those of an arc that became lines.

use aptc_geometry::Vec3;

use super::done::{along, segment};
use super::{Checker, Expect, Over, shown};
use crate::emit::Joints;
use crate::machine::RapidPath;
use crate::readback::Place;
use crate::turnmill::{RAPID_BAND_MM, is_clear};

impl Checker {
    pub(super) fn line(&mut self, from: &Place, to: &Place, rapid: bool) {
        let Some((end, axis)) = self.pose(to) else {
            self.over = self.across(to);
            // Across at a height that only the machine knows: allowed on the way from home.
            if !rapid && !self.free {
                self.say("a cut to a place that is not known".into());
            }
            return;
        };
        if self.free {
            // Until the CL data is met again, motion is the user's own.
            self.now = Some((end, axis));
            if self.pop_if_at(end, axis) {
                (self.free, self.away) = (false, false);
                return;
            }
            if !matches!(self.queue.front(), Some(Expect::Hole(_))) {
                (self.at, self.at_cut) = (self.now, false);
                return;
            }
            self.free = false;
        }
        let begin = self.pose(from).or(if self.away { None } else { self.at });
        if self.away {
            let down = self.comes_down(to, end, axis);
            if !down && (!rapid || self.wants(end)) {
                self.say(format!(
                    "the tool comes to {} from a place that is not above it along its axis",
                    shown(end)
                ));
                self.arrive(end, axis, rapid);
            } else if down {
                self.arrive(end, axis, rapid);
            }
            self.over = Some(Over { at: end, ta: axis, known: true, angles: [to[3], to[4]] });
            self.now = Some((end, axis));
            return;
        }
        self.now = begin.or(self.now);
        self.skip_here();
        self.now = Some((end, axis));
        if self.back_below(end, axis) {
            self.cuts_on_from(end, rapid);
            self.skip_here();
            return;
        }
        while let Some(Expect::Clear) = self.queue.front() {
            self.queue.pop_front();
            self.marks();
            if begin.is_some_and(|(b, t)| along(end - b, t, self.angular) > 0.0) {
                (self.at, self.at_cut) = (Some((end, axis)), false);
                return;
            }
        }
        // A place that was reached before is said again: the height after a cycle.
        let again = self.stands_at(end, axis);
        match self.queue.front_mut() {
            None if again => {}
            None => self.say(format!("a motion to {} that the CL data does not have", shown(end))),
            Some(Expect::Hole(hole)) => {
                let mut hole = hole.clone();
                let done = self.drill(&mut hole, begin, end, rapid);
                self.queue.pop_front();
                if !done {
                    self.queue.push_front(Expect::Hole(hole));
                }
            }
            Some(_) => self.toward(from, to, (end, axis), rapid),
        }
    }

    /// Does the tool stand there?
    fn stands_at(&self, end: Vec3, axis: Vec3) -> bool {
        self.at.is_some_and(|(at, ta)| {
            (at - end).norm() <= 2.0 * self.linear && (ta - axis).norm() <= self.angular
        })
    }

    /// A straight step towards the next position.
    fn toward(&mut self, from: &Place, to: &Place, (end, axis): (Vec3, Vec3), rapid: bool) {
        let Some((start, start_axis)) = self.at else {
            // The first motion of all comes from nowhere.
            self.pop_if_at(end, axis);
            return;
        };
        let off = self.bend(from, to);
        let band = self.band();
        // Positions on an arc that became lines: passed within the band, and those of its own chords where it is so
        // flat that one line is the arc.
        let here = self.pose(from).map_or(start, |p| p.0);
        while let Some(Expect::Point { te, ta, via, round: true, .. }) = self.queue.front() {
            let (te, ta, off) = (*te, *ta, if *via { band } else { self.linear });
            if segment(te, here, end).0 > off || (te - end).norm() < self.linear {
                break;
            }
            self.queue.pop_front();
            self.proof.points += 1;
            (self.at, self.at_cut) = (Some((te, ta)), !rapid);
        }
        let Some(Expect::Point { te, ta, rapid: want, round, .. }) = self.queue.front().cloned()
        else {
            self.say(format!("a motion to {} that the CL data does not have", shown(end)));
            return;
        };
        let start = self.at.map_or(start, |a| a.0);
        let turning = !self.machine.rotary.is_empty();
        let retract = self.machine.multiaxis.rewind_retract;
        if turning && retract > 0.0 && !self.detour {
            let (begin, ta) = self.pose(from).unwrap_or((start, start_axis));
            self.detour = along(end - begin, ta, 3.0 * self.angular) > 0.9 * retract;
        }
        if rapid && !want && !self.detour {
            self.say(format!("a rapid motion to {} where the CL data cuts", shown(end)));
        }
        if !rapid && want && self.machine.rapid.path != RapidPath::Feed && !self.detour {
            self.say(format!("a cut to {} where the CL data is rapid", shown(end)));
        }
        let tol = self.linear + if off > 0.0 { self.lintol } else { 0.0 };
        let tol = match rapid && want && self.machine.is_milling() {
            true if self.clears(here) && self.clears(end) => f64::INFINITY,
            true => tol.max(self.linear + RAPID_BAND_MM),
            false => tol,
        };
        let place = segment(end, start, te).0;
        if off > tol && !self.detour {
            self.say(format!("the tool end leaves its line by {off:.5} mm before {}", shown(end)));
        }
        let counts = !(self.detour || rapid && self.machine.is_milling());
        self.proof.path_mm = self.proof.path_mm.max(if counts { off } else { 0.0 });
        if self.pop_if_at(end, axis) {
            self.detour = false;
            return;
        }
        let near = self.linear + if turning { self.lintol } else { 0.0 };
        if place <= if round { band.max(near) } else { near } {
            return;
        }
        let d = te - start;
        let split = rapid && want && self.is_split(from, to, te);
        if split || (d.norm() <= band && place <= band) {
            return;
        }
        if self.detour {
            return;
        }
        self.say(format!("a motion to {}, but the CL data goes to {}", shown(end), shown(te)));
        self.queue.pop_front();
        self.at = Some((te, ta));
    }

    /// Is the place above the clearance plane, in whose height C may turn as it likes?
    fn clears(&self, te: Vec3) -> bool {
        self.clearance.is_some_and(|plane| is_clear(&plane, te, self.linear))
    }

    /// Is it a rapid motion with Z apart from the other axes, towards `te`?
    fn is_split(&mut self, from: &Place, to: &Place, te: Vec3) -> bool {
        let angles = [to[3].unwrap_or(0.0), to[4].unwrap_or(0.0)];
        let goal =
            if self.machine.rotary.is_empty() { te } else { self.posed().chain.linear(te, angles) };
        let tol = 2.0 * self.linear;
        let is = |i: usize, v: f64| to[i].is_some_and(|x| (x - v).abs() <= tol);
        let stays = |i: usize| from[i].is_some_and(|v| is(i, v));
        let turned = from.iter().zip(to).skip(3).any(|(a, b)| a != b);
        !turned
            && ((stays(0) && stays(1) && is(2, goal.z))
                || (is(0, goal.x) && is(1, goal.y) && stays(2)))
    }

    /// By how much the tool end leaves the line of its ends when all axes move evenly.
    fn bend(&mut self, from: &Place, to: &Place) -> f64 {
        if from.iter().zip(to).skip(3).all(|(a, b)| a == b || b.is_none()) {
            return 0.0;
        }
        let (Some((a, _)), Some((b, _))) = (self.pose(from), self.pose(to)) else { return 0.0 };
        let end: Joints = to.map(|v| v.unwrap_or(0.0));
        let start: Joints =
            std::array::from_fn(|i| from[i].filter(|_| to[i].is_some()).unwrap_or(end[i]));
        let chain = &self.posed().chain;
        let off = [0.25, 0.5, 0.75].map(|part| {
            let between = std::array::from_fn(|i| start[i] + (end[i] - start[i]) * part);
            segment(chain.forward(&between).0, a, b).0
        });
        off.into_iter().fold(0.0, f64::max)
    }
}
