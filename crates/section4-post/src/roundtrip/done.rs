//! What the text does, step by step, held against what was asked for.

use aptc_geometry::{Vec3, trig};

use super::{Checker, Expect, Hole, Over, shown};
use crate::approach::goes_up;
use crate::emit::Joints;
use crate::kinematics::Chain;
use crate::machine::{Carries, MachineKind, RapidPath};
use crate::readback::{ArcStep, Frame, Place, Step};
use crate::turnmill::{RAPID_BAND_MM, is_clear};

/// Rapid motions up to this have no length, millimetres.
const NOWHERE_MM: f64 = 1e-6;

/// The chain of the machine, and the last two positions of its axes that were asked for: each block begins where the
/// one before it ended, and is asked for both several times.
pub(super) struct Posed {
    chain: Chain,
    known: [Option<(Joints, (Vec3, Vec3))>; 2],
}

impl Posed {
    fn pose(&mut self, joints: &Joints) -> (Vec3, Vec3) {
        let same = |at: &&(Joints, _)| at.0.map(f64::to_bits) == joints.map(f64::to_bits);
        if let Some((_, pose)) = self.known.iter().flatten().find(same) {
            return *pose;
        }
        let pose = self.chain.forward(joints);
        self.known = [Some((*joints, pose)), self.known[0]];
        pose
    }
}

impl Checker {
    fn pose(&mut self, place: &Place) -> Option<(Vec3, Vec3)> {
        let joints =
            [place[0]?, place[1]?, place[2]?, place[3].unwrap_or(0.0), place[4].unwrap_or(0.0)];
        if self.machine.rotary.is_empty() {
            return Some((Vec3::new(joints[0], joints[1], joints[2]), Vec3::z()));
        }
        if !self.means_the_part(place) {
            return None;
        }
        Some(self.posed().pose(&joints))
    }

    /// Are the numbers of the linear axes positions of the part? Beside turned axes only a tilted plane or
    /// tool-centre control makes them so, where the control has these.
    fn means_the_part(&self, place: &Place) -> bool {
        let turned = place[3..].iter().flatten().any(|a| (a / 360.0).fract().abs() > 1e-9);
        !self.machine.multiaxis.tool_center || self.centered || self.frame.is_some() || !turned
    }

    fn posed(&mut self) -> &mut Posed {
        if self.machine.is_milling()
            && let Some(
                Expect::Point { ta, .. } | Expect::Hole(Hole { ta, .. }) | Expect::From { ta, .. },
            ) = self.queue.front()
        {
            let across = ta.z.abs() < 0.5;
            if across != self.across {
                (self.across, self.posed) = (across, None);
            }
        }
        let across = self.across;
        let length = self.read_length.or(self.machine.multiaxis.tool_length).unwrap_or(0.0);
        let (machine, frame) = (&self.machine, self.frame.as_ref());
        self.posed.get_or_insert_with(|| {
            let mut chain = Chain::new(machine, 1.0, length);
            if across && machine.is_milling() {
                chain.stand_across();
            }
            chain.plane = frame.map(|f| match f {
                Frame::Plane(q) => q.transpose(),
                Frame::Table(angles) => chain.table(*angles),
            });
            Posed { chain, known: [None; 2] }
        })
    }

    pub(super) fn step(&mut self, step: &Step) {
        self.marks();
        match step {
            Step::Away => {
                self.away = true;
                self.now = None;
                (self.over, self.below) = (None, None);
            }
            Step::Frame(frame) => {
                self.frame = *frame;
                self.posed = None;
            }
            Step::Center(on) => self.centered = *on,
            Step::Line { from, to, rapid, .. } => self.line(from, to, *rapid),
            Step::Arc(arc) => self.arc(arc),
        }
    }

    /// Positions that the tool already stands at.
    pub(super) fn skip_here(&mut self) {
        let Some((now, axis)) = self.now.filter(|_| !self.away) else { return };
        while let Some(Expect::Point { te, ta, rapid, .. }) = self.queue.front() {
            if (te - now).norm() > self.linear || (ta - axis).norm() > self.angular {
                return;
            }
            let (te, ta, cut) = (*te, *ta, !*rapid);
            self.reached((te, ta), (now, axis), cut);
            self.queue.pop_front();
        }
    }

    fn reached(&mut self, (te, ta): (Vec3, Vec3), (now, axis): (Vec3, Vec3), cut: bool) {
        self.proof.points += 1;
        self.proof.position_mm = self.proof.position_mm.max((te - now).norm());
        let lean = ta.cross(&axis).norm().min(1.0);
        self.proof.axis_deg = self.proof.axis_deg.max(trig::asin(lean).to_degrees());
        // A rapid motion of no length leaves the tool in its cut.
        let stays = self.at.is_some_and(|(at, _)| (te - at).norm() <= NOWHERE_MM);
        self.at = Some((te, ta));
        self.at_cut = cut || self.at_cut && stays;
    }

    fn line(&mut self, from: &Place, to: &Place, rapid: bool) {
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

    /// Is the next position this one? Then it is reached.
    fn pop_if_at(&mut self, end: Vec3, axis: Vec3) -> bool {
        let Some(Expect::Point { te, ta, rapid, .. }) = self.queue.front() else { return false };
        if (te - end).norm() > 2.0 * self.linear || (ta - axis).norm() > self.angular {
            return false;
        }
        let (te, ta, cut) = (*te, *ta, !*rapid);
        self.queue.pop_front();
        self.reached((te, ta), (end, axis), cut);
        true
    }

    /// The line along the tool on which it stands after a motion across, at a height that is not known.
    fn across(&mut self, to: &Place) -> Option<Over> {
        let [x, y] = [to[0], to[1]];
        let (at, ta) = self.pose(&[x, y, Some(0.0), to[3], to[4]])?;
        let (higher, _) = self.pose(&[x, y, Some(1.0), to[3], to[4]])?;
        if !self.away || (higher - at - ta).norm() > self.angular {
            return None;
        }
        Some(Over { at, ta, known: false, angles: [to[3], to[4]] })
    }

    /// Where a control keeps the tool end on its path, or a head leans: is the way here from home one down along the
    /// tool, with the rotary axes at rest?
    ///
    /// Then the linear axes of the machine go along the tool only, however the control leads a rapid motion: the
    /// place across was reached before, at the height of home or above this place.
    fn comes_down(&self, to: &Place, end: Vec3, axis: Vec3) -> bool {
        let m = &self.machine;
        // Tables without such control turn the part under a tool that comes down along itself.
        if !m.multiaxis.tool_center && m.rotary.iter().all(|r| r.carries == Carries::Part) {
            return true;
        }
        let Some(over) = self.over.filter(|o| o.angles == [to[3], to[4]]) else { return false };
        let d = over.at - end;
        let aside = (d - axis * d.dot(&axis)).norm();
        // The angles of a tilted plane are rounded as those of the axes are.
        let tol = 2.0 * self.linear + 2.0 * self.angular * (end.norm() + d.norm());
        aside <= tol
            && (over.ta - axis).norm() <= 2.0 * self.angular
            && (!over.known || d.dot(&axis) >= -tol)
    }

    /// Is this a place at which the CL data goes on?
    fn wants(&self, end: Vec3) -> bool {
        let near = |p: Vec3| (p - end).norm() <= 2.0 * self.linear;
        self.at.is_some_and(|(at, _)| near(at))
            || match self.queue.front() {
                Some(Expect::Point { te, .. }) => near(*te),
                Some(Expect::Hole(h)) => (end - h.at).dot(&h.ta) < h.retract + 2.0 * self.linear,
                _ => false,
            }
    }

    /// Ended a cut of a mill where the CL data stands, and does the next motion cut on from there other than straight up?
    fn goes_on_cutting(&self) -> bool {
        let mills = self.machine.kind == MachineKind::Mill || self.machine.is_milling();
        let Some((at, axis)) = self.at.filter(|_| self.at_cut && mills) else { return false };
        // What RETRCT asked for has been done by way of home, and a rapid motion of no length ends no cut.
        let next = self.queue.iter().find(|e| match e {
            Expect::Clear | Expect::Tool { .. } => false,
            Expect::Point { te, rapid: true, .. } => (te - at).norm() > NOWHERE_MM,
            _ => true,
        });
        match next {
            // Twice the angle that the writer allows: both compute it in units of their own.
            Some(Expect::Point { te, rapid: false, .. }) => !goes_up(te - at, axis, 2e-6),
            _ => false,
        }
    }

    /// Does the tool go down again to where a cut ended? Then the CL data goes on from there.
    fn back_below(&mut self, end: Vec3, axis: Vec3) -> bool {
        let Some((te, ta)) = self.below.take() else { return false };
        let there = (te - end).norm() <= 2.0 * self.linear && (ta - axis).norm() <= self.angular;
        if there {
            (self.at, self.at_cut) = (Some((te, ta)), true);
        }
        there
    }

    /// The tool comes to where a cut ended: not at rapid where the next one goes on from there.
    fn cuts_on_from(&mut self, end: Vec3, rapid: bool) {
        if rapid && self.goes_on_cutting() {
            self.say(format!(
                "a rapid motion to {}, where the last cut of the CL data ended and the next begins",
                shown(end)
            ));
        }
    }

    /// From home to where the CL data goes on.
    fn arrive(&mut self, end: Vec3, axis: Vec3, rapid: bool) {
        let near = |p: Vec3, tol: f64| (p - end).norm() <= tol;
        self.back_below(end, axis);
        if self.at.is_some_and(|(at, _)| near(at, 2.0 * self.linear)) {
            self.cuts_on_from(end, rapid);
            self.away = false;
            self.now = Some((end, axis));
            self.skip_here();
            return;
        }
        while let Some(Expect::Clear) = self.queue.front() {
            self.queue.pop_front();
            // Straight to the clearance plane over the last position.
            if self.at.is_some_and(|(at, t)| along(end - at, t, self.angular) >= 0.0) {
                self.below = self.at.filter(|_| self.at_cut);
                (self.at, self.at_cut) = (Some((end, axis)), false);
                self.away = false;
                return;
            }
        }
        match self.queue.front().cloned() {
            Some(Expect::Hole(h)) if rapid => {
                let height = (end - h.at).dot(&h.ta);
                if height >= h.clearance - self.linear {
                    self.away = false;
                    return;
                }
                self.say(format!("a rapid motion to {} below the clearance of a hole", shown(end)));
            }
            Some(Expect::Point { rapid: want, .. }) => {
                if self.pop_if_at(end, axis) {
                    self.away = false;
                    if rapid && !want {
                        self.say(format!(
                            "a rapid motion to {} where the CL data cuts",
                            shown(end)
                        ));
                    }
                } else if !rapid {
                    self.say(format!("a cut to {} on the way from home", shown(end)));
                    self.away = false;
                }
            }
            _ => {}
        }
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

    pub(super) fn band(&self) -> f64 {
        let said = self.band.unwrap_or(if self.intol > 0.0 { 0.0 } else { 0.0127 });
        said.max(self.intol) + 4.0 * self.linear
    }

    fn arc(&mut self, arc: &ArcStep) {
        let (Some(begin), Some(end)) = (self.pose(&arc.from), self.pose(&arc.to)) else {
            self.say("an arc to a place that is not known".into());
            return;
        };
        (self.away, self.below) = (false, None);
        self.now = Some(begin);
        self.skip_here();
        self.now = Some(end);
        if std::mem::take(&mut self.free) {
            self.at = Some(begin);
        }
        let band = self.band();
        let most = arc.sweep.abs();
        let (Some(start), Some(axis)) = (self.pose(&arc.at(0.0)), self.arc_axis(arc)) else {
            return;
        };
        let Some(center) = self.arc_center(arc) else { return };
        let spoke = start.0 - center;
        let rise = (end.0 - begin.0).dot(&axis);
        let mut passed = 0.0_f64;
        let fit = self.fit.map_or(band, |t| t + 2.0 * self.linear);
        while let Some(Expect::Point { te, ta, rapid, round, .. }) = self.queue.front().cloned() {
            let d = te - center;
            let flat = d - axis * d.dot(&axis);
            let mut angle =
                trig::atan2(axis.dot(&spoke.cross(&flat)), spoke.dot(&flat)) * arc.sweep.signum();
            let slack = 2.0 * band / arc.radius;
            if angle < passed - slack {
                angle += std::f64::consts::TAU;
            }
            let height = rise * (angle / most).clamp(0.0, 1.0);
            let mut off = ((flat.norm() - arc.radius).abs())
                .max((d.dot(&axis) - spoke.dot(&axis) - height).abs());
            if let Some((last, _)) = self.at.filter(|_| !round) {
                // In place of a line: the middle of the line counts as well.
                let near = nearest(center, last, te) - center;
                off = off.max(((near - axis * near.dot(&axis)).norm() - arc.radius).abs());
            }
            if off > if round { band } else { fit } || angle > most + slack {
                break;
            }
            if rapid {
                self.say("an arc where the CL data is rapid".into());
            }
            passed = passed.max(angle);
            self.queue.pop_front();
            self.proof.points += 1;
            self.proof.path_mm = self.proof.path_mm.max(off);
            (self.at, self.at_cut) = (Some((te, ta)), !rapid);
        }
        let Some((at, _)) = self.at else { return };
        if (at - end.0).norm() <= 2.0 * self.linear {
            return;
        }
        // A piece of a longer arc ends between two cut vectors.
        if let Some(Expect::Point { te, .. }) = self.queue.front()
            && segment(end.0, at, *te).0 <= band + arc.radius * 0.04
        {
            return;
        }
        self.say(format!("an arc to {} that the CL data does not have", shown(end.0)));
    }

    fn arc_axis(&mut self, arc: &ArcStep) -> Option<Vec3> {
        let n = 3 - arc.axes[0] - arc.axes[1];
        let mut up = arc.from;
        up[n] = Some(up[n].unwrap_or(0.0) + 1.0);
        let (a, b) = (self.pose(&arc.from)?.0, self.pose(&up)?.0);
        Some((b - a).normalize())
    }

    fn arc_center(&mut self, arc: &ArcStep) -> Option<Vec3> {
        let mut c = arc.from;
        c[arc.axes[0]] = Some(arc.center[0]);
        c[arc.axes[1]] = Some(arc.center[1]);
        Some(self.pose(&c)?.0)
    }

    /// A step of a hole; true when it is done.
    fn drill(
        &mut self,
        hole: &mut Hole,
        begin: Option<(Vec3, Vec3)>,
        end: Vec3,
        rapid: bool,
    ) -> bool {
        let tol = 2.0 * self.linear;
        let height = |p: Vec3| (p - hole.at).dot(&hole.ta);
        let aside = |p: Vec3| {
            let d = p - hole.at;
            (d - hole.ta * d.dot(&hole.ta)).norm()
        };
        let (h, from) = (height(end), begin.map(|b| b.0));
        if aside(end) > tol || from.is_some_and(|b| aside(b) > tol) {
            // On the way to the hole: only rapid, and only up or at a height that is clear.
            // From another axis it comes along the clearance plane, at a height that in the frame of this hole means nothing.
            // Which side of the plane is above both tool axes tell; its normal may point either way.
            let above = |p: Vec3, ta: Vec3| {
                hole.plane.is_some_and(|c| (c.n.dot(&p) - c.d) * c.n.dot(&ta).signum() >= -tol)
            };
            let free = begin.is_some_and(|(b, ta)| {
                (ta - hole.ta).norm() > self.angular
                    && [end, b].iter().all(|p| above(*p, ta) && above(*p, hole.ta))
            });
            let low = !free
                && from.is_some_and(|b| {
                    height(b) < hole.clearance - tol && aside(b) > tol && aside(end) <= tol
                });
            let across =
                from.is_some_and(|b| (end - b - hole.ta * (end - b).dot(&hole.ta)).norm() > tol);
            let turning = !self.machine.rotary.is_empty();
            if !rapid || low || (across && h < hole.clearance - tol && !turning) {
                self.say(format!("a motion to {} on the way to a hole", shown(end)));
            }
            let there = aside(end) <= tol && hole.bottom >= -tol && (h - hole.retract).abs() <= tol;
            return there && hole.clearance <= tol;
        }
        if rapid && h < hole.clearance.min(hole.deepest) - tol {
            self.say(format!("a rapid motion into a hole to {}", shown(end)));
        }
        if h < hole.bottom - tol {
            self.say(format!("a hole too deep at {}", shown(end)));
        }
        hole.deepest = hole.deepest.min(h);
        if hole.deepest > hole.bottom + tol || (h - hole.retract).abs() > tol {
            return false;
        }
        self.proof.points += 1;
        (self.at, self.at_cut) = (Some((hole.at + hole.ta * hole.retract, hole.ta)), false);
        true
    }
}

/// Distance of `p` from the segment `a b`, and where along it, 0 to 1.
fn segment(p: Vec3, a: Vec3, b: Vec3) -> (f64, f64) {
    let d = b - a;
    let n = d.norm_squared();
    let t = if n > 0.0 { ((p - a).dot(&d) / n).clamp(0.0, 1.0) } else { 0.0 };
    ((p - a - d * t).norm(), t)
}

/// The place of the segment `a b` that is nearest to `p`.
fn nearest(p: Vec3, a: Vec3, b: Vec3) -> Vec3 {
    a + (b - a) * segment(p, a, b).1
}

/// Length of a motion when it goes straight along the unit vector, to within the angle `lean`, else 0.
fn along(d: Vec3, unit: Vec3, lean: f64) -> f64 {
    let way = d.dot(&unit);
    if (d - unit * way).norm() <= 0.002 + lean * way.abs() { way } else { 0.0 }
}
