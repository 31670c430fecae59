//! Motion: from positions of the tool to blocks.

use aptc_cldata::{Course, Motion, MotionKind, Position};
use aptc_diagnostics::{Origin, codes};
use aptc_geometry::Vec3;

use crate::emit::{FeedMode, FeedWord, Joints, MotionCode};
use crate::machine::RapidPath;
use crate::post::Post;
use crate::report::Extent;
use crate::state::{FeedUnit, Feedrate};

pub(crate) const ALL: [bool; 5] = [true; 5];
const TOOL_AXIS: [bool; 5] = [false, false, true, false, false];
const BUT_TOOL_AXIS: [bool; 5] = [true, true, false, true, true];

/// A tool axis counts as upright when it leans by less than this, radians: some 0.2 seconds of arc, below
/// the last digit of any CL text.
const UPRIGHT: f64 = 1e-6;

impl Post {
    pub(crate) fn motion(&mut self, m: &Motion, origin: &Origin) {
        let Some(last) = m.points.last() else { return };
        if m.kind == MotionKind::From {
            self.from(last, origin);
            return;
        }
        if self.st.ended {
            let message = "a motion after END".to_string();
            let help = "END ends the machine's program; put it after the last motion, or use STOP";
            self.error(codes::AFTER_END, origin, message, help);
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
                    self.hole(p, origin);
                }
                return;
            }
            self.leave_cycle();
        }
        if let Some(arc) = &m.arc
            && !rapid
        {
            if self.arc(arc, &m.points, origin) {
                return;
            }
            if let Course::Sweep(_) = arc.course {
                self.sweep_as_lines(arc, last, origin);
                return;
            }
        }
        for p in &m.points {
            self.go(p, rapid, origin);
        }
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
    }

    /// Runs the retract lines of the machine; the next motion comes from there.
    pub(crate) fn retract_to_home(&mut self, _origin: &Origin) {
        let machine = std::sync::Arc::clone(&self.machine);
        if machine.program.retract.is_empty() {
            return;
        }
        let vars = self.common_vars();
        self.blocks.template(&machine.program.retract, &vars.list());
        self.blocks.forget_after_start();
        self.st.away = true;
    }

    /// One straight motion.
    #[inline]
    pub(crate) fn go(&mut self, p: &Position, rapid: bool, origin: &Origin) {
        let te = self.st.point(p.te);
        self.go_to(te, p.ta, rapid, origin);
    }

    /// One straight motion to a tool end in output units.
    pub(crate) fn go_to(&mut self, te: Vec3, ta: Vec3, rapid: bool, origin: &Origin) {
        let Some(joints) = self.joints(te, ta, origin) else { return };
        if self.st.away || self.st.spindle_again || self.st.coolant_again {
            self.approach(te, ta, rapid, origin);
        }
        if rapid {
            self.rapid(te, &joints, origin);
        } else {
            if !self.st.ready_said {
                self.ready(origin);
            }
            let Some(feed) = self.feed_for(te, origin) else { return };
            let done = self.blocks.straight(MotionCode::Line, &joints, ALL, Some(feed));
            self.check(done, origin);
            self.count_cut(te, self.distance(te), feed);
        }
        self.st.pos = Some(te);
        self.st.ta = ta;
    }

    fn rapid(&mut self, te: Vec3, joints: &Joints, origin: &Origin) {
        let path = self.machine.rapid.path;
        let split = path == RapidPath::Split
            && self.st.pos.is_none_or(|p| {
                let d = te - p;
                let r = self.blocks.number(b'Z').resolution();
                d.z.abs() >= r && d.x.abs().max(d.y.abs()) >= r
            });
        let done = if path == RapidPath::Feed {
            let value = self.machine.rapid.feed / self.st.out_mm();
            let feed = FeedWord { mode: FeedMode::PerMinute, value };
            self.blocks.straight(MotionCode::Line, joints, ALL, Some(feed))
        } else if split {
            let up = self.st.pos.is_some_and(|p| te.z > p.z);
            let (first, then) =
                if up { (TOOL_AXIS, BUT_TOOL_AXIS) } else { (BUT_TOOL_AXIS, TOOL_AXIS) };
            let one = self.blocks.straight(MotionCode::Rapid, joints, first, None);
            one.and_then(|()| self.blocks.straight(MotionCode::Rapid, joints, then, None))
        } else {
            self.blocks.straight(MotionCode::Rapid, joints, ALL, None)
        };
        self.check(done, origin);
        self.count_rapid(te);
    }

    /// From the retracted position to where the CL data thinks that the tool is: first across, then down;
    /// and what a tool change has stopped runs again.
    pub(crate) fn approach(&mut self, te: Vec3, ta: Vec3, rapid: bool, origin: &Origin) {
        self.run_again();
        if !std::mem::take(&mut self.st.away) {
            return;
        }
        // A rapid motion may go to its own end; a cut must begin where the last motion ended.
        let (over, axis, down) = match self.st.pos {
            Some(p) if !rapid => (p, self.st.ta, true),
            _ => (te, ta, rapid),
        };
        let Some(joints) = self.joints(over, axis, origin) else { return };
        let done = self.blocks.straight(MotionCode::Rapid, &joints, BUT_TOOL_AXIS, None);
        self.check(done, origin);
        if down {
            let done = self.blocks.straight(MotionCode::Rapid, &joints, TOOL_AXIS, None);
            self.check(done, origin);
            self.st.pos = Some(over);
        }
    }

    /// Positions of the axes for a position of the tool.
    #[inline]
    pub(crate) fn joints(&mut self, te: Vec3, ta: Vec3, origin: &Origin) -> Option<Joints> {
        if ta.x.abs() > UPRIGHT || ta.y.abs() > UPRIGHT || ta.z < 0.0 {
            let message = format!(
                "tool axis {},{},{} on {}, whose tool axis is 0,0,1",
                crate::post::trimmed(ta.x, 6),
                crate::post::trimmed(ta.y, 6),
                crate::post::trimmed(ta.z, 6),
                self.machine.name
            );
            let help = "choose a machine with rotary axes: `aptc machines` lists them";
            self.error(codes::AXIS_OUT_OF_REACH, origin, message, help);
            return None;
        }
        let joints = [te.x, te.y, te.z, 0.0, 0.0];
        if !self.machine.axes.is_empty() {
            self.check_limits(&joints, origin);
        }
        Some(joints)
    }

    fn check_limits(&mut self, joints: &Joints, origin: &Origin) {
        let unit = self.st.out_mm();
        for (i, letter) in ['X', 'Y', 'Z'].into_iter().enumerate() {
            let Some(axis) = self.machine.axes.get(&letter) else { continue };
            let mm = joints[i] * unit;
            let beyond = axis.min.filter(|m| mm < m - 1e-9).or(axis.max.filter(|m| mm > m + 1e-9));
            if let Some(limit) = beyond {
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

    /// Feed of a cut to `te`; `None` after a refusal.
    #[inline]
    pub(crate) fn feed_for(&mut self, te: Vec3, origin: &Origin) -> Option<FeedWord> {
        if self.st.inverse {
            let length = self.distance(te);
            return self.inverse_feed(length, origin);
        }
        match self.st.feed_word {
            Some(feed) => Some(feed),
            None => self.find_feed(origin),
        }
    }

    pub(crate) fn inverse_feed(&mut self, length: f64, origin: &Origin) -> Option<FeedWord> {
        let feed = match self.st.feed_word {
            Some(feed) => feed,
            None => self.find_feed(origin)?,
        };
        if feed.mode != FeedMode::PerMinute {
            return Some(feed);
        }
        // A block without length is over in the least time that the control can be told.
        let value = if length > 0.0 { feed.value / length } else { 99_999.0 };
        Some(FeedWord { mode: FeedMode::InverseTime, value: value.min(99_999.0) })
    }

    /// The feed that holds until the next FEDRAT or SPINDL.
    fn find_feed(&mut self, origin: &Origin) -> Option<FeedWord> {
        let feed = match self.st.feed {
            Some(feed) => feed,
            None => self.default_feed(origin)?,
        };
        let word = self.feed_of(feed, origin)?;
        let max = self.machine.feed.max / self.st.out_mm();
        if word.mode == FeedMode::PerMinute && max > 0.0 && word.value > max * (1.0 + 1e-9) {
            let message = format!(
                "feed {} a minute is above {} of {}",
                crate::post::trimmed(word.value, 3),
                crate::post::trimmed(max, 3),
                self.machine.name
            );
            self.error(codes::OVER_LIMIT, origin, message, "program a feed that the machine has");
            return None;
        }
        self.st.feed_word = Some(word);
        Some(word)
    }

    fn default_feed(&mut self, origin: &Origin) -> Option<Feedrate> {
        if let Some(mm) = self.machine.default_feed {
            let message = format!(
                "no feed was programmed: {} mm a minute of {} is used",
                crate::post::trimmed(mm, 3),
                self.machine.name
            );
            let help = "write FEDRAT/f before the first cut";
            self.warn(codes::DEFAULT_FEED, origin, message, help);
            let feed = Feedrate { value: mm, unit: FeedUnit::MmPerMinute };
            self.st.feed = Some(feed);
            return Some(feed);
        }
        if !std::mem::replace(&mut self.st.feed_missing_said, true) {
            let message = "this cut has no feed rate".to_string();
            let help = "write FEDRAT/f before it, or RAPID when it shall not cut";
            self.error(codes::NO_FEED, origin, message, help);
        }
        None
    }

    /// A programmed feed as the machine is told it.
    pub(crate) fn feed_of(&mut self, feed: Feedrate, origin: &Origin) -> Option<FeedWord> {
        let out = self.st.out_mm();
        let (factor, per_revolution) = match feed.unit {
            FeedUnit::PerMinute => (self.st.scale, false),
            FeedUnit::PerRevolution => (self.st.scale, true),
            FeedUnit::InchPerMinute => (25.4 / out, false),
            FeedUnit::InchPerRevolution => (25.4 / out, true),
            FeedUnit::MmPerMinute => (1.0 / out, false),
            FeedUnit::MmPerRevolution => (1.0 / out, true),
        };
        let value = feed.value * factor;
        if !(value > 0.0 && value.is_finite()) {
            let message = format!("a feed of {} does not cut", feed.value);
            self.error(codes::NO_FEED, origin, message, "write FEDRAT/f with a positive feed");
            return None;
        }
        if !per_revolution {
            return Some(FeedWord { mode: FeedMode::PerMinute, value });
        }
        if !self.machine.feed.per_revolution.is_empty() {
            return Some(FeedWord { mode: FeedMode::PerRevolution, value });
        }
        let s = self.st.spindle;
        if s.on && !s.surface && s.speed > 0.0 {
            return Some(FeedWord { mode: FeedMode::PerMinute, value: value * s.speed });
        }
        let message = format!(
            "a feed per revolution, but {} has none and the spindle speed is not known",
            self.machine.name
        );
        let help = "write SPINDL/n before it, or a feed per minute";
        self.error(codes::NO_FEED, origin, message, help);
        None
    }

    /// Warns once when the first cut comes without spindle, tool or coolant.
    pub(crate) fn ready(&mut self, origin: &Origin) {
        self.st.ready_said = true;
        let missing: Vec<&str> = [
            (!self.st.spindle.on, "spindle"),
            (self.st.tool.is_none(), "tool"),
            (self.st.coolant.is_none(), "coolant"),
        ]
        .into_iter()
        .filter_map(|(missing, what)| missing.then_some(what))
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

    pub(crate) fn count_cut(&mut self, te: Vec3, length: f64, feed: FeedWord) {
        self.summary.cut_length += length;
        let minutes = match feed.mode {
            FeedMode::PerMinute => length / feed.value,
            FeedMode::PerRevolution if self.st.spindle.speed > 0.0 => {
                length / (feed.value * self.st.spindle.speed)
            }
            FeedMode::PerRevolution => 0.0,
            FeedMode::InverseTime => 1.0 / feed.value,
        };
        self.summary.cut_minutes += minutes;
        self.take_extent(te);
        let speed = self.st.spindle.on.then_some(self.st.spindle.speed);
        let tool = self.tool_use();
        tool.minutes += minutes;
        tool.lowest = Some(tool.lowest.map_or(te.z, |z| z.min(te.z)));
        if feed.mode == FeedMode::PerMinute {
            tool.feeds = Some(widened(tool.feeds, feed.value));
        }
        if let Some(s) = speed {
            tool.speeds = Some(widened(tool.speeds, s));
        }
    }

    pub(crate) fn count_rapid(&mut self, te: Vec3) {
        let length = self.distance(te);
        let minutes = length * self.st.out_mm() / self.machine.rapid.feed;
        self.summary.rapid_length += length;
        self.summary.rapid_minutes += minutes;
        self.take_extent(te);
        self.tool_use().minutes += minutes;
    }

    #[inline]
    fn take_extent(&mut self, te: Vec3) {
        let p = [te.x, te.y, te.z];
        self.st.extent.get_or_insert_with(|| Extent::of(p)).take(p);
    }
}

fn widened(range: Option<[f64; 2]>, value: f64) -> [f64; 2] {
    range.map_or([value, value], |[a, b]| [a.min(value), b.max(value)])
}
