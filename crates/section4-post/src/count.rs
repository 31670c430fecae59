//! Time, travel and limits, counted while the blocks are written.

use aptc_geometry::Vec3;

use crate::emit::{FeedMode, FeedWord};
use crate::post::Post;
use crate::report::{AxisUse, Extent};

/// Rapid motions up to this do not take the tool out of what it cuts, millimetres. Reading back takes 1e-6: what is
/// written must not be bolder than what is asked for.
const NOWHERE_MM: f64 = 0.01;

impl Post {
    pub(crate) fn count_cut(&mut self, te: Vec3, length: f64, feed: FeedWord) {
        self.st.cut_last = true;
        self.summary.cut_length += length;
        let minutes = match feed.mode {
            FeedMode::PerMinute => length / feed.value,
            FeedMode::PerRevolution if self.st.spindle.speed > 0.0 => {
                length / (feed.value * self.revolutions(te.x))
            }
            FeedMode::PerRevolution => 0.0,
            FeedMode::InverseTime => 1.0 / feed.value,
        };
        self.summary.cut_minutes += minutes;
        self.take_extent(te);
        let speed = self.st.spindle.on.then(|| self.revolutions(te.x));
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
        // One that goes nowhere leaves the tool where the cut ended.
        self.st.cut_last &= length * self.st.out_mm() <= NOWHERE_MM;
        let minutes = length * self.st.out_mm() / self.machine.rapid.feed;
        self.summary.rapid_length += length;
        self.summary.rapid_minutes += minutes;
        self.take_extent(te);
        self.tool_use().minutes += minutes;
    }

    /// How far each axis went.
    pub(crate) fn axes_used(&self) -> Vec<AxisUse> {
        let unit = self.st.out_mm();
        let linear = ['X', 'Y', 'Z'].into_iter().map(|letter| {
            let axis = self.machine.axes.get(&letter);
            let limit = |l: Option<f64>| l.map(|mm| mm / unit);
            (letter, false, axis.map_or([None; 2], |a| [limit(a.min), limit(a.max)]))
        });
        let rotary = self.machine.rotary.iter().map(|r| (r.letter, true, [r.min, r.max]));
        linear
            .chain(rotary)
            .zip(self.st.reach)
            .filter(|(_, [min, max])| min <= max)
            .map(|((letter, rotary, limits), [min, max])| AxisUse {
                letter,
                rotary,
                min,
                max,
                limits,
            })
            .collect()
    }

    #[inline]
    pub(crate) fn take_extent(&mut self, te: Vec3) {
        let p = [te.x, te.y, te.z];
        self.st.extent.get_or_insert_with(|| Extent::of(p)).take(p);
    }
}

fn widened(range: Option<[f64; 2]>, value: f64) -> [f64; 2] {
    range.map_or([value, value], |[a, b]| [a.min(value), b.max(value)])
}
