//! Motion with rotary axes: positions of the axes, straight paths of the tool end, winding back.

use aptc_diagnostics::{Origin, codes};
use aptc_geometry::Vec3;

use crate::emit::{FeedMode, FeedWord, Joints, MotionCode};
use crate::kinematics::{Chain, NoSolution, UPRIGHT};
use crate::machine::{Carries, RotaryFeed};
use crate::motion::ALL;
use crate::post::{Post, trimmed};
use crate::turnmill::RAPID_BAND_MM;

/// How often a motion may be halved: 4096 blocks of one motion at most.
const MOST_HALVINGS: u32 = 12;

/// How often a free axis may jump within one motion; beyond it the rotary axes are wound back.
const MOST_TURNS: u32 = 16;

/// Position of tool and axes together.
#[derive(Clone, Copy, Debug)]
struct Pose {
    te: Vec3,
    ta: Vec3,
    /// Angles as they are written, degrees, not wrapped.
    angles: [f64; 2],
    /// Linear axes.
    xyz: Vec3,
}

impl Pose {
    fn joints(&self) -> Joints {
        [self.xyz.x, self.xyz.y, self.xyz.z, self.angles[0], self.angles[1]]
    }
}

/// How far above the top of the stock the tool end is while rotary axes turn over, millimetres.
const CLEAR_OF_STOCK_MM: f64 = 2.0;

impl Post {
    /// Positions of the axes for a position of the tool; `None` after a refusal.
    #[inline]
    pub(crate) fn joints(&mut self, te: Vec3, ta: Vec3, origin: &Origin) -> Option<Joints> {
        let joints = if self.machine.rotary.is_empty() {
            if ta.x.abs() > UPRIGHT || ta.y.abs() > UPRIGHT || ta.z < 0.0 {
                self.out_of_reach(ta, NoSolution::Direction, origin);
                return None;
            }
            [te.x, te.y, te.z, 0.0, 0.0]
        } else {
            let pose = self.pose(te, ta, self.st.angles, origin)?;
            pose.joints()
        };
        self.reach(&joints, origin);
        Some(joints)
    }

    /// Told once with how many positions have such an axis.
    fn out_of_reach(&mut self, ta: Vec3, why: NoSolution, origin: &Origin) {
        let axis = [ta.x, ta.y, ta.z].map(|c| trimmed(c, 6)).join(",");
        let name = &self.machine.name;
        let (what, message, help) = match (why, self.machine.rotary.len()) {
            (NoSolution::Direction, 0) => (
                "upright alone",
                format!("tool axis {axis} on {name}, whose tool axis is 0,0,1"),
                "choose a machine with rotary axes: `aptc machines` lists them",
            ),
            (NoSolution::Direction, _) => (
                "no angles",
                format!("tool axis {axis}: no angles of {name} give it"),
                "choose a machine with other rotary axes: `aptc machines` lists them",
            ),
            (NoSolution::Limits, _) => (
                "limits",
                format!("tool axis {axis}: the angles are beyond the limits of {name}"),
                "lay the part otherwise, or choose a machine that turns farther",
            ),
        };
        self.error_counted(codes::AXIS_OUT_OF_REACH, what, origin, message, help);
    }

    /// The chain with the present tool; `None` after a refusal.
    fn chain(&mut self, origin: &Origin) -> Option<&Chain> {
        if self.st.chain.is_none() {
            let m = &self.machine;
            let needs =
                !m.multiaxis.tool_center && m.rotary.iter().any(|r| r.carries == Carries::Tool);
            let unit = self.st.out_mm();
            let said = self.st.tool_length.map(|l| l * self.st.scale);
            let length = said.or(m.multiaxis.tool_length.map(|l| l / unit));
            if needs && length.is_none() {
                let message = format!(
                    "{} turns the tool and needs its length, which is not known",
                    self.machine.name
                );
                let help =
                    "write LOADTL/n,LENGTH,l, or give `multiaxis.tool_length` in the machine file";
                self.error(codes::TOOL_LENGTH, origin, message, help);
                return None;
            }
            if let (true, None, None, Some(length)) = (needs, said, self.st.tool, length) {
                let message = format!(
                    "no tool is loaded whose length is known: {} of {} is taken",
                    trimmed(length, 4),
                    self.machine.name
                );
                let help = "write LOADTL/n,LENGTH,l before the first motion";
                self.warn(codes::TOOL_LENGTH, origin, message, help);
            }
            let mut chain = Chain::new(&self.machine, unit, length.unwrap_or(0.0));
            chain.plane = self.st.plane;
            if self.st.across == Some(true) {
                chain.stand_across();
            }
            self.st.chain = Some(chain);
        }
        self.st.chain.as_ref()
    }

    fn pose(&mut self, te: Vec3, ta: Vec3, from: [f64; 2], origin: &Origin) -> Option<Pose> {
        let norm = ta.norm();
        if !(norm > 0.5 && norm < 2.0) {
            self.out_of_reach(ta, NoSolution::Direction, origin);
            return None;
        }
        let ta = ta / norm;
        match self.chain(origin)?.angles(te, ta, from) {
            Ok(angles) => {
                let angles = self.blocks.round_angles(angles);
                if self.lacks_length(angles, origin) {
                    return None;
                }
                let mut pose = self.placed(te, ta, angles);
                if self.machine.is_milling() {
                    if !self.reaches_side(te, pose.xyz.y, origin) {
                        return None;
                    }
                    pose.xyz.y = 0.0;
                }
                Some(pose)
            }
            Err(why) => {
                self.out_of_reach(ta, why, origin);
                None
            }
        }
    }

    /// Beside turned axes the control keeps the tool end on its path by the length of the tool. Where that comes by a
    /// number and no tool is loaded, no code can be written; where it comes with the tool, the code is right for the one
    /// that happens to be in the spindle.
    fn lacks_length(&mut self, angles: [f64; 2], origin: &Origin) -> bool {
        let m = &self.machine.multiaxis;
        if self.st.offset.is_some() || !m.tool_center || self.st.plane.is_some() {
            return false;
        }
        let turned = angles.iter().any(|a| (a / 360.0 - (a / 360.0).round()).abs() > 1e-12);
        if !turned {
            return false;
        }
        let by_number = m.tool_center_on.contains("{offset}");
        let name = &self.machine.name;
        let help = "write LOADTL/n before the first motion";
        let message =
            format!("{name} turns axes and needs the length of the tool, and no tool is loaded");
        if by_number {
            self.error_counted(codes::TOOL_LENGTH, "no length", origin, message, help);
        } else if !std::mem::replace(&mut self.st.length_told, true) {
            self.warn(codes::TOOL_LENGTH, origin, message, help);
        }
        by_number
    }

    fn placed(&self, te: Vec3, ta: Vec3, angles: [f64; 2]) -> Pose {
        let xyz = self.st.chain.as_ref().map_or(te, |c| c.linear(te, angles));
        Pose { te, ta, angles, xyz }
    }

    /// The place of the linear axes for a tool end while the rotary axes rest.
    pub(crate) fn at_rest(&self, te: Vec3) -> Vec3 {
        self.st.chain.as_ref().map_or(te, |c| c.linear(te, self.st.angles))
    }

    /// Does the tool stand along its axis of the machine, as the rotary axes are now?
    pub(crate) fn along_tool(&self, ta: Vec3) -> bool {
        self.stands_along(ta, self.st.angles)
    }

    /// The same with the rotary axes at these angles.
    pub(crate) fn stands_along(&self, ta: Vec3, angles: [f64; 2]) -> bool {
        let seen = self.st.chain.as_ref().map_or(ta, |c| c.turned(angles) * ta);
        let mut axis = Vec3::zeros();
        axis[self.tool_along()] = 1.0;
        (seen - axis).norm() < 1e-6
    }

    /// Switches tool-centre control on where it has a line of its own.
    pub(crate) fn tool_center_on(&mut self) {
        let m = &self.machine.multiaxis;
        if !m.tool_center || m.tool_center_with_z || self.st.centered || self.st.plane.is_some() {
            return;
        }
        let offset = self.st.offset.map_or(String::new(), |o| o.to_string());
        if let Some(line) = crate::emit::render(&m.tool_center_on, &[("offset", &offset)]) {
            self.blocks.line(&line);
        }
        self.st.centered = true;
    }

    /// Ends tool-centre control that has a line of its own: the lines of the machine file go to places of the machine.
    pub(crate) fn tool_center_off(&mut self) {
        if std::mem::take(&mut self.st.centered) {
            let machine = std::sync::Arc::clone(&self.machine);
            self.blocks.line(&machine.multiaxis.tool_center_off);
        }
    }

    /// One straight motion of the tool end while rotary axes may turn.
    pub(crate) fn go_turning(&mut self, te: Vec3, ta: Vec3, rapid: bool, origin: &Origin) {
        let Some(end) = self.pose(te, ta, self.st.angles, origin) else { return };
        let total = self.distance(te);
        let Some(pos) = self.st.pos else {
            self.leg(&end, rapid, total, origin);
            return;
        };
        // The place of the axes is known from the last block unless the tool end came otherwise.
        let start = match self.st.placed {
            Some((te, xyz)) if te == pos => {
                Pose { te: pos, ta: self.st.ta, angles: self.st.angles, xyz }
            }
            _ => self.placed(pos, self.st.ta, self.st.angles),
        };
        // Halves still to do, the next one last.
        let mut from = start;
        if self.straight_enough(&from, &end, rapid) || rapid && self.free_to_turn(pos, te) {
            self.leg(&end, rapid, total, origin);
            return;
        }
        let end = match self.turn_free(&mut from, &end, 1.0, rapid, origin) {
            None => return,
            Some(false) => end,
            Some(true) => match self.pose(te, ta, from.angles, origin) {
                Some(end) => end,
                None => return,
            },
        };
        let mut to_do = vec![(end, 0)];
        let mut turns = 0;
        while let Some((to, halved)) = to_do.pop() {
            if self.straight_enough(&from, &to, rapid) {
                let part = (to.te - from.te).norm();
                if !self.leg(&to, rapid, part, origin) {
                    return;
                }
                from = to;
                continue;
            }
            if halved >= MOST_HALVINGS {
                // A free axis jumps: it turns while the tool stays in its place.
                let turned = if turns < MOST_TURNS {
                    self.turn_free(&mut from, &to, 3.0, rapid, origin)
                } else {
                    Some(false)
                };
                turns += 1;
                match turned {
                    None => return,
                    Some(true) => to_do.push((to, 0)),
                    Some(false) => {
                        if !self.wind_back(&from, &to, rapid, origin) {
                            return;
                        }
                        from = to;
                    }
                }
                continue;
            }
            let middle = (from.ta + to.ta) / 2.0;
            if middle.norm() < 1e-3 {
                let message = "the tool axis turns over between two positions".to_string();
                let help = "put positions between them that say which way it turns";
                let code = codes::AXIS_OUT_OF_REACH;
                self.error_counted(code, "turns over", origin, message, help);
                return;
            }
            let te = (from.te + to.te) / 2.0;
            let Some(half) = self.pose(te, middle.normalize(), from.angles, origin) else { return };
            // The end again, now near to the half.
            let Some(again) = self.pose(to.te, to.ta, half.angles, origin) else { return };
            to_do.push((again, halved + 1));
            to_do.push((half, halved + 1));
        }
    }

    /// In the singular direction one rotary axis is free: it goes to where the motion needs it while the tool
    /// stays in its place. Did it have to? `None` after a refusal.
    fn turn_free(
        &mut self,
        from: &mut Pose,
        to: &Pose,
        cone: f64,
        rapid: bool,
        origin: &Origin,
    ) -> Option<bool> {
        let free = self.st.chain.as_ref().and_then(|c| c.free(from.te, from.ta, cone));
        let Some(i) = free.filter(|&i| (to.angles[i] - from.angles[i]).abs() > 1e-9) else {
            return Some(false);
        };
        let way = to.angles[i] - from.angles[i];
        let turned = |angle: f64| {
            let mut angles = from.angles;
            angles[i] += angle;
            self.placed(from.te, from.ta, self.blocks.round_angles(angles))
        };
        let mut n: u32 = 1;
        let short = |n: u32| self.straight_enough(from, &turned(way / f64::from(n)), rapid);
        while n < 1 << MOST_HALVINGS && !short(n) {
            n *= 2;
        }
        let legs: Vec<Pose> = (1..=n).map(|k| turned(way * f64::from(k) / f64::from(n))).collect();
        for pose in legs {
            if !self.leg(&pose, rapid, 0.0, origin) {
                return None;
            }
            *from = pose;
        }
        Some(true)
    }

    /// Does the tool follow closely enough when all axes move evenly from one pose to the other?
    fn straight_enough(&self, from: &Pose, to: &Pose, rapid: bool) -> bool {
        #[expect(clippy::float_cmp, reason = "rounded numbers: the same text")]
        if from.angles == to.angles {
            return true;
        }
        let Some(chain) = &self.st.chain else { return true };
        let lintol = match self.machine.is_milling() && rapid {
            true => self.lintol().max(RAPID_BAND_MM / self.st.out_mm()),
            false => self.lintol(),
        };
        let lean = self.machine.multiaxis.axis_tolerance.to_radians();
        let (a, b) = (from.joints(), to.joints());
        // The tool end is turned by the angles x while the axes move by d: from its second derivative
        // x^2 r + 2 x d it cannot leave the line by more than an eighth of that.
        let x = (0..2).map(|i| (b[3 + i] - a[3 + i]).abs()).sum::<f64>().to_radians();
        let r = chain.reach() + from.xyz.norm().max(to.xyz.norm());
        if x < 2.0 * lean && x * (x * r + 2.0 * (to.xyz - from.xyz).norm()) <= 8.0 * lintol {
            return true;
        }
        [0.5, 0.25, 0.75].into_iter().all(|s| {
            let mut joints = [0.0; 5];
            for i in 0..5 {
                joints[i] = a[i] + (b[i] - a[i]) * s;
            }
            let (te, ta) = chain.forward(&joints);
            let line = to.te - from.te;
            let length2 = line.norm_squared();
            let along = if length2 > 0.0 { (te - from.te).dot(&line) / length2 } else { 0.0 };
            let foot = from.te + line * along.clamp(0.0, 1.0);
            let normal = from.ta.cross(&to.ta);
            let out = if normal.norm() > 1e-9 {
                aptc_geometry::trig::asin(ta.dot(&normal.normalize()).clamp(-1.0, 1.0)).abs()
            } else {
                (ta - from.ta).norm()
            };
            (te - foot).norm() <= lintol && out <= lean
        })
    }

    /// One block, or one rapid motion.
    fn leg(&mut self, to: &Pose, rapid: bool, length: f64, origin: &Origin) -> bool {
        let joints = to.joints();
        self.reach(&joints, origin);
        if rapid {
            self.rapid_to(to.te, &joints, origin);
        } else {
            let Some(feed) = self.turning_feed(to, length, origin) else { return false };
            let done = self.blocks.straight(MotionCode::Line, &joints, ALL, Some(feed));
            self.check(done, origin);
            self.count_cut(to.te, length, feed);
            self.takes_away(self.st.pos, to.te, to.ta, origin);
        }
        self.st.pos = Some(to.te);
        self.st.ta = to.ta;
        self.st.angles = to.angles;
        self.st.placed = Some((to.te, to.xyz));
        true
    }

    /// Feed of a block: inverse time where rotary axes turn and the control does not mean the tool end.
    fn turning_feed(&mut self, to: &Pose, length: f64, origin: &Origin) -> Option<FeedWord> {
        let turn = (0..2).map(|i| (to.angles[i] - self.st.angles[i]).abs()).fold(0.0, f64::max);
        if turn > 0.0 {
            let sweep = self.flank_way(to.ta);
            if length <= 0.0 || (length <= self.lintol() && 10.0 * length <= sweep) {
                return self.feed_in_place(to, sweep, origin);
            }
        }
        let m = &self.machine;
        let by_time = self.st.inverse
            || (turn > 0.0 && !m.multiaxis.tool_center && m.multiaxis.feed == RotaryFeed::Inverse);
        if !by_time && turn > 0.0 && m.multiaxis.feed == RotaryFeed::Degrees {
            return self.feed_with_degrees(to, length, turn, origin);
        }
        if !by_time || m.feed.inverse_time.is_empty() {
            let inverse = std::mem::replace(&mut self.st.inverse, false);
            let feed = self.feed_for(to.te, origin);
            self.st.inverse = inverse;
            return feed;
        }
        // No axis may turn faster than it can.
        let slowest = m
            .rotary
            .iter()
            .zip(0..2)
            .filter(|(r, _)| r.max_feed > 0.0)
            .map(|(r, i)| (to.angles[i] - self.st.angles[i]).abs() / r.max_feed)
            .fold(0.0, f64::max);
        let feed = self.inverse_feed(length, origin)?;
        if feed.mode != FeedMode::InverseTime {
            return Some(feed);
        }
        let value = if slowest > 0.0 { feed.value.min(1.0 / slowest) } else { feed.value };
        Some(FeedWord { value, ..feed })
    }

    /// LINTOL or that of the machine, in output units.
    fn lintol(&self) -> f64 {
        self.st.lintol_mm.unwrap_or(self.machine.multiaxis.lintol) / self.st.out_mm()
    }

    /// How far the flank of the cutter comes while its axis turns to `ta`, output units. Of a cutter whose height is
    /// not said no more than three diameters are taken to cut.
    fn flank_way(&self, ta: Vec3) -> f64 {
        let flank = self.st.cutter.map_or(0.0, |c| c.height.min(3.0 * c.diameter) * self.st.scale);
        aptc_geometry::trig::angle_between(self.st.ta, ta) * flank
    }

    /// Feed of a block in which the tool turns where it stands: its end leaves its place by no more than LINTOL while
    /// its flank goes the way `sweep`.
    ///
    /// The speed of the tool end says nothing there. Fanuc with G43.4 turns at its greatest cutting feed (parameter 1422)
    /// unless bit 6 of 19696 (RFC) is set (additional manual A-79348E of Series 30i, page 78). That Siemens, Haas and
    /// Heidenhain take degrees a minute, in programs in inches too, is assumed: no document shown here says so. So
    /// the block has a time: the flank of the cutter, which sweeps through the part, goes no faster than the feed, and no
    /// axis makes a turn in less than a tenth of a minute.
    fn feed_in_place(&mut self, to: &Pose, sweep: f64, origin: &Origin) -> Option<FeedWord> {
        let inverse = std::mem::replace(&mut self.st.inverse, false);
        let feed = self.feed_for(to.te, origin);
        self.st.inverse = inverse;
        let feed = feed?;
        let spindle = self.st.spindle;
        let per_minute = match feed.mode {
            FeedMode::PerMinute => feed.value,
            _ if spindle.on && !spindle.surface => feed.value * spindle.speed,
            _ => return Some(feed),
        };
        let m = &self.machine;
        let turns: [f64; 2] = std::array::from_fn(|i| (to.angles[i] - self.st.angles[i]).abs());
        let slowest = m
            .rotary
            .iter()
            .zip(turns)
            .map(|(r, turn)| turn / if r.max_feed > 0.0 { r.max_feed.min(3600.0) } else { 3600.0 })
            .fold(0.0, f64::max);
        let minutes = (sweep / per_minute).max(slowest);
        let turn = aptc_geometry::trig::hypot(turns[0], turns[1]);
        let (mode, value) = if !m.feed.inverse_time.is_empty() {
            (FeedMode::InverseTime, (1.0 / minutes).min(99_999.0))
        } else if m.multiaxis.feed == RotaryFeed::Degrees {
            let from = self.st.placed.map_or(to.xyz, |p| p.1);
            let way = aptc_geometry::trig::hypot((to.xyz - from).norm(), turn);
            (FeedMode::PerMinute, way / minutes)
        } else if m.multiaxis.tool_center {
            (FeedMode::PerMinute, turn / minutes)
        } else {
            return Some(feed);
        };
        if m.multiaxis.tool_center && !std::mem::replace(&mut self.st.turn_noted, true) {
            let note = self.machine.multiaxis.turn_note.clone();
            if !note.is_empty() {
                self.blocks.comment(&note);
            }
        }
        Some(FeedWord { mode, value })
    }

    /// The feed that a control needs which measures the way of all axes, a degree as a unit of length: the tool end
    /// then goes at the feed that was asked for, and no axis faster than it can.
    fn feed_with_degrees(
        &mut self,
        to: &Pose,
        length: f64,
        turn: f64,
        origin: &Origin,
    ) -> Option<FeedWord> {
        let feed = self.feed_for(to.te, origin)?;
        if feed.mode != FeedMode::PerMinute {
            return Some(feed);
        }
        let from = self.st.placed.map_or(to.xyz, |p| p.1);
        let way = aptc_geometry::trig::hypot((to.xyz - from).norm(), turn);
        let fastest = self.machine.rotary.first().map_or(0.0, |r| r.max_feed);
        let slowest = if fastest > 0.0 { turn / fastest } else { 0.0 };
        Some(FeedWord { value: way / (length / feed.value).max(slowest), ..feed })
    }

    /// How far the tool goes up along itself before the rotary axes turn over: at least `least`, to the clearance plane,
    /// and above the top of the stock, where these do not lie steep to it.
    fn clear_of(&self, at: &Pose, least: f64) -> f64 {
        let plane = self.height_of_clearance(at.te, at.ta).unwrap_or(0.0);
        let top = self.summary.stock.filter(|_| at.ta.z > 0.1).map_or(0.0, |[_, max]| {
            let above = CLEAR_OF_STOCK_MM / self.st.out_mm();
            (max[2] + above - at.te.z) / at.ta.z
        });
        least.max(plane).max(top)
    }

    /// The rotary axes go over to another pair of angles while the tool is away from the part.
    fn wind_back(&mut self, from: &Pose, to: &Pose, rapid: bool, origin: &Origin) -> bool {
        let m = &self.machine.multiaxis;
        let unit = self.st.out_mm();
        let (retract, feed) = (m.rewind_retract / unit, m.rewind_feed / unit);
        if retract <= 0.0 {
            let message = format!(
                "the rotary axes of {} would have to turn over within a motion",
                self.machine.name
            );
            let help = "split the motion, lay the part otherwise, or allow it with \
                        `multiaxis.rewind_retract` in the machine file";
            self.error(codes::WIND_BACK, origin, message, help);
            return false;
        }
        let retract = self.clear_of(from, retract).max(self.clear_of(to, retract));
        let message = format!(
            "the rotary axes are wound back with the tool retracted by {}",
            trimmed(retract, 3)
        );
        self.warn(codes::WIND_BACK, origin, message, "look at this place before cutting");
        let cut = FeedWord { mode: FeedMode::PerMinute, value: feed };
        let up = self.placed(from.te + from.ta * retract, from.ta, from.angles);
        let over = self.placed(to.te + to.ta * retract, to.ta, to.angles);
        for (pose, rapid) in [(up, rapid), (over, true), (*to, rapid)] {
            let joints = pose.joints();
            self.reach(&joints, origin);
            let done = if rapid {
                self.blocks.straight(MotionCode::Rapid, &joints, ALL, None)
            } else {
                self.blocks.straight(MotionCode::Line, &joints, ALL, Some(cut))
            };
            self.check(done, origin);
            self.count_rapid(pose.te);
            self.st.pos = Some(pose.te);
        }
        self.st.ta = to.ta;
        self.st.angles = to.angles;
        self.st.placed = None;
        true
    }
}
