//! Feed: from FEDRAT to the number that the control is told.

use aptc_diagnostics::{Origin, codes};
use aptc_geometry::Vec3;

use crate::emit::{FeedMode, FeedWord};
use crate::post::Post;
use crate::state::{FeedUnit, Feedrate};

impl Post {
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
        let said = std::mem::replace(&mut self.st.feed_missing_said, true);
        if !said && !self.st.refused_words.contains("FEDRAT") {
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
}
