//! Time, travel and limits, counted while the blocks are written.

use aptc_geometry::Vec3;

use crate::emit::{FeedMode, FeedWord};
use crate::post::Post;
use crate::report::Extent;

impl Post {
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
