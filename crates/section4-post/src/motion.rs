//! Motion: from positions of the tool to blocks.

use aptc_cldata::{Course, Motion, MotionKind, Position};
use aptc_diagnostics::{Origin, codes};
use aptc_geometry::Vec3;

use crate::emit::{FeedMode, FeedWord, Joints, MotionCode};
use crate::machine::{MachineKind, RapidPath};
use crate::post::Post;

pub(crate) const ALL: [bool; 5] = [true; 5];

impl Post {
    pub(crate) fn motion(&mut self, m: &Motion, origin: &Origin) {
        let Some(last) = m.points.last() else { return };
        self.n_motions += 1;
        if self.machine.kind == MachineKind::Lathe && !self.lathe_takes(m, origin) {
            return;
        }
        if m.kind == MotionKind::From {
            self.from(last, origin);
            return;
        }
        if self.st.ended {
            self.after_end("a motion", true, origin);
            return;
        }
        let rapid = std::mem::take(&mut self.st.rapid);
        self.start(origin);
        if self.options.annotate {
            self.annotate(origin);
        }
        if self.st.cycle.is_some() {
            if m.kind == MotionKind::Goto && !rapid && m.arc.is_none() {
                for p in &m.points {
                    self.n_motions += 1;
                    self.hole(p, origin);
                }
                return;
            }
            self.leave_cycle();
        }
        if let Some(arc) = &m.arc {
            if !rapid && self.arc(arc, &m.points, origin) {
                return;
            }
            // No control goes along an arc at rapid; straight to its end the tool would cross what it goes around.
            if let Course::Sweep(_) = arc.course {
                self.sweep_as_lines(arc, last, rapid, origin);
                return;
            }
        }
        for p in &m.points {
            self.n_motions += 1;
            self.go(p, rapid, origin);
        }
    }

    /// Can the lathe do it, turning or milling?
    fn lathe_takes(&mut self, m: &Motion, origin: &Origin) -> bool {
        if self.machine.is_milling() {
            self.tool_stands(m, origin)
        } else {
            self.stays_in_plane(m, origin)
        }
    }

    /// The axis along which the tool stands, and the others.
    pub(crate) fn tool_axis_and_others(&self) -> ([bool; 5], [bool; 5]) {
        let mut tool = [false; 5];
        tool[self.tool_along()] = true;
        (tool, tool.map(|t| !t))
    }

    /// FROM: the tool is there, or has to be brought there.
    fn from(&mut self, p: &Position, origin: &Origin) {
        let te = self.st.point(p.te);
        // A rapid approach to the start is what RAPID before FROM asks for; it must not speed up the first cut.
        self.st.rapid = false;
        if let Some(pos) = self.st.pos
            && !self.st.away
            && (te - pos).norm() > self.blocks.number(b'X').resolution()
        {
            self.start(origin);
            self.leave_cycle();
            self.retract_to_home(origin);
        }
        self.st.pos = Some(te);
        self.st.ta = p.ta;
        self.st.cut_last = false;
    }

    /// Runs the retract lines of the machine; the next motion comes from there.
    pub(crate) fn retract_to_home(&mut self, _origin: &Origin) {
        let machine = std::sync::Arc::clone(&self.machine);
        if machine.program.retract.is_empty() {
            return;
        }
        self.leave_plane();
        self.tool_center_off();
        let vars = self.common_vars();
        self.blocks.template(&machine.program.retract, &vars.list());
        self.left_for_home();
    }

    /// After lines of the machine file that brought it home.
    pub(crate) fn left_for_home(&mut self) {
        self.blocks.forget_after_lines();
        self.st.away = true;
        self.st.centered = false;
        if self.machine.compensation.retract_ends_length {
            self.length_words();
        }
    }

    /// One straight motion.
    #[inline]
    pub(crate) fn go(&mut self, p: &Position, rapid: bool, origin: &Origin) {
        let te = self.st.point(p.te);
        self.go_to(te, p.ta, rapid, origin);
    }

    /// One straight motion to a tool end in output units. What follows begins there also when it was refused.
    pub(crate) fn go_to(&mut self, te: Vec3, ta: Vec3, rapid: bool, origin: &Origin) {
        if self.st.away || self.st.stands_still() {
            self.approach(te, ta, rapid, origin);
        }
        if !rapid && !self.st.ready_said {
            self.ready(origin);
        }
        if !self.machine.rotary.is_empty() {
            self.go_turning(te, ta, rapid, origin);
            self.st.pos = Some(te);
            return;
        }
        if let (Some(lead), false) = (self.st.thread, rapid) {
            self.thread_to(te, lead, origin);
            (self.st.pos, self.st.ta) = (Some(te), ta);
            return;
        }
        if let Some(joints) = self.joints(te, ta, origin) {
            self.st.ta = ta;
            if rapid {
                self.rapid_to(te, &joints, origin);
            } else if let Some(feed) = self.feed_for(te, origin) {
                let done = self.blocks.straight(MotionCode::Line, &joints, ALL, Some(feed));
                self.check(done, origin);
                self.count_cut(te, self.distance(te), feed);
                self.takes_away(self.st.pos, te, ta, origin);
            }
        }
        self.st.pos = Some(te);
    }

    /// A rapid motion of all axes, in the way of the machine.
    pub(crate) fn rapid_to(&mut self, te: Vec3, joints: &Joints, origin: &Origin) {
        let path = self.machine.rapid.path;
        // Only a tool that stands along its axis while the rotary axes rest is moved apart from the others.
        let t = self.tool_along();
        let (tool_axis, but_tool_axis) = self.tool_axis_and_others();
        #[expect(clippy::float_cmp, reason = "rounded angles: the same text")]
        let still = self.st.angles == [joints[3], joints[4]] && self.along_tool(self.st.ta);
        let way = self.st.pos.map(|p| {
            let p = self.at_rest(p);
            [joints[0] - p.x, joints[1] - p.y, joints[2] - p.z]
        });
        // A piece of an arc is so short that its axes may come to its end as they like.
        let split = path == RapidPath::Split
            && !self.st.rounding
            && still
            && way.is_none_or(|d| {
                let r = self.blocks.number(b'Z').resolution();
                d[t].abs() >= r && (0..3).any(|i| i != t && d[i].abs() >= r)
            });
        if self.stock.is_some()
            && let Some(from) = self.st.pos
        {
            let rise = self.st.ta * (te - from).dot(&self.st.ta);
            let up = rise.dot(&self.st.ta) > 0.0;
            let corner = if up { from + rise } else { te - rise };
            let way = [from, if split { corner } else { from }, te];
            self.must_be_free(&way, self.st.ta, origin);
        }
        let done = if path == RapidPath::Feed {
            let value = self.machine.rapid.feed / self.st.out_mm();
            let feed = FeedWord { mode: FeedMode::PerMinute, value };
            self.blocks.straight(MotionCode::Line, joints, ALL, Some(feed))
        } else if split {
            // On a lathe the tool leaves the part across and comes to it along the spindle, outside and in a bore.
            let turns = self.machine.kind == MachineKind::Lathe && !self.machine.is_milling();
            let up = way.is_some_and(|d| d[t] > 0.0) != turns;
            let (first, then) =
                if up { (tool_axis, but_tool_axis) } else { (but_tool_axis, tool_axis) };
            let one = self.blocks.straight(MotionCode::Rapid, joints, first, None);
            one.and_then(|()| self.blocks.straight(MotionCode::Rapid, joints, then, None))
        } else {
            self.blocks.straight(MotionCode::Rapid, joints, ALL, None)
        };
        self.check(done, origin);
        self.count_rapid(te);
    }

    /// The axes go to `joints`: how far is kept, and what is beyond a limit is refused.
    #[inline]
    pub(crate) fn reach(&mut self, joints: &Joints, origin: &Origin) {
        for (range, &j) in self.st.reach.iter_mut().zip(joints) {
            *range = [range[0].min(j), range[1].max(j)];
        }
        if !self.machine.axes.is_empty() {
            self.check_limits(joints, origin);
        }
    }

    fn check_limits(&mut self, joints: &Joints, origin: &Origin) {
        let unit = self.st.out_mm();
        for (i, letter) in ['X', 'Y', 'Z'].into_iter().enumerate() {
            let Some(axis) = self.machine.axes.get(&letter) else { continue };
            let mm = joints[i] * unit;
            let below = axis.min.filter(|m| mm < m - 1e-9);
            let above = axis.max.filter(|m| mm > m + 1e-9);
            if let Some(limit) = below.or(above) {
                // Once for each end of each axis: what follows from it is not told again.
                let told = &mut self.st.limits_told[i][usize::from(above.is_some())];
                if std::mem::replace(told, true) {
                    continue;
                }
                let message = format!(
                    "{letter}{} is beyond the limit {letter}{} of {}",
                    crate::post::trimmed(joints[i], 4),
                    crate::post::trimmed(limit / unit, 4),
                    self.machine.name
                );
                let help = "move the part with ORIGIN or TRANS, or choose a larger machine";
                self.error(codes::OVER_LIMIT, origin, message, help);
            }
        }
    }

    /// Warns once when the first cut comes without spindle, tool or coolant.
    pub(crate) fn ready(&mut self, origin: &Origin) {
        self.st.ready_said = true;
        let missing: Vec<&str> = [
            (!self.st.spindle.on, "spindle", "SPINDL"),
            (self.st.tool.is_none(), "tool", "LOADTL"),
            (self.st.coolant.is_none(), "coolant", "COOLNT"),
        ]
        .into_iter()
        .filter(|(missing, _, word)| *missing && !self.st.refused_words.contains(*word))
        .map(|(_, what, _)| what)
        .collect();
        if !missing.is_empty() {
            let message = format!("the first cut comes without {}", missing.join(" and "));
            let help = "write SPINDL, LOADTL and COOLNT before it, or ignore this when it is meant";
            self.warn(codes::NOT_READY, origin, message, help);
        }
    }

    pub(crate) fn check(&mut self, done: Result<(), crate::emit::TooGreat>, origin: &Origin) {
        if let Err(e) = done {
            self.too_great(origin, e);
        }
    }
    #[inline]
    pub(crate) fn distance(&self, te: Vec3) -> f64 {
        self.st.pos.map_or(0.0, |p| (te - p).norm())
    }
}
