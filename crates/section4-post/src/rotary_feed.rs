//! Feeds of blocks in which rotary axes turn.

use aptc_diagnostics::Origin;
use aptc_geometry::Vec3;

use crate::emit::{FeedMode, FeedWord};
use crate::machine::RotaryFeed;
use crate::pose::Pose;
use crate::post::Post;

impl Post {
    /// Feed of a block: inverse time where rotary axes turn and the control does not mean the tool end.
    pub(crate) fn turning_feed(
        &mut self,
        to: &Pose,
        length: f64,
        origin: &Origin,
    ) -> Option<FeedWord> {
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
}
