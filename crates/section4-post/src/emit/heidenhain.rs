//! Heidenhain conversational: `L`, `CC` and `C`, `CP` for helices, lines numbered from zero.

use super::{ArcBlock, Blocks, FeedWord, MotionCode, Rounded, TooGreat, idx};

impl Blocks {
    /// `L X+1 Y+2 R0 FMAX`.
    pub(super) fn tnc_straight(
        &mut self,
        code: MotionCode,
        q: &Rounded,
        mask: [bool; 5],
        feed: Option<FeedWord>,
    ) -> Result<(), TooGreat> {
        self.begin();
        self.push("L");
        for i in 0..5 {
            if mask[i] && self.axes[i] != b' ' {
                self.coordinate(self.axes[i], q[i]);
            }
        }
        if let Some(words) = self.with_motion.take() {
            self.push(&words);
        }
        if code == MotionCode::Rapid {
            // FMAX holds for its block only; the feed before it comes back by itself.
            self.push("FMAX");
        } else {
            self.feed_word(feed)?;
        }
        self.end();
        Ok(())
    }

    /// `CC` with the centre, then `C` with the end, or `CP` with the angle for a helix.
    pub(super) fn tnc_arc(
        &mut self,
        arc: &ArcBlock,
        feed: Option<FeedWord>,
    ) -> Result<(), TooGreat> {
        let (axes, _) = arc.plane.axes();
        let normal = 3 - axes[0] - axes[1];
        let mut order = axes;
        order.sort_unstable();
        let turn = if arc.anticlockwise { "DR+" } else { "DR-" };
        self.begin();
        self.push("CC");
        for i in order {
            let center = if i == axes[0] { arc.center_at[0] } else { arc.center_at[1] };
            self.value(self.axes[i], center)?;
        }
        self.end();
        self.begin();
        let number = self.number(self.axes[normal]);
        let rise = number.round(arc.rise).unwrap_or(0);
        if rise == 0 {
            self.push("C");
            for i in order {
                self.known[idx(self.axes[i])] = None;
                self.coordinate(self.axes[i], arc.end[i]);
            }
        } else {
            self.push("CP");
            let angle = crate::post::trimmed(arc.sweep, 6);
            let sign = if arc.sweep < 0.0 { "" } else { "+" };
            self.push(&format!("IPA{sign}{angle}"));
            let axis = char::from(self.axes[normal]);
            self.push(&format!("I{axis}{}", number.text(rise)));
            // The end follows from the angle: the next block says it again.
            for i in axes {
                self.known[idx(self.axes[i])] = None;
            }
            self.known[idx(self.axes[normal])] = Some(arc.end[normal]);
        }
        self.push(turn);
        self.feed_word(feed)?;
        self.end();
        Ok(())
    }
}
