//! Drilling cycles of the control.

use super::{Blocks, FeedMode, FeedWord, MotionCode, TooGreat, idx};
use crate::machine::{ArcPlane, Dialect};

/// A cycle as the control does it, lengths in output units.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct NativeCycle {
    /// G81.
    pub(crate) code: String,
    /// G98 or G99.
    pub(crate) retract: String,
    /// Further words: step and dwell with their letters.
    pub(crate) words: Vec<(u8, f64)>,
    /// Feed.
    pub(crate) feed: FeedWord,
    /// Lines that define it, with the numbers of the hole; then code and words do not count.
    pub(crate) lines: Vec<String>,
    /// Lines before the block that begins it.
    pub(crate) before: Vec<String>,
}

impl Blocks {
    /// One hole: `bottom`, `clearance` and where the tool ends, along Z. The cycle stays modal until any other block.
    pub(crate) fn hole(
        &mut self,
        cycle: &NativeCycle,
        xy: [f64; 2],
        [bottom, clearance, end]: [f64; 3],
    ) -> Result<(), TooGreat> {
        let round = |b: &Self, letter: u8, value: f64| {
            b.number(letter).round(value).ok_or(TooGreat { letter: char::from(letter), value })
        };
        let (x, y) = (round(self, b'X', xy[0])?, round(self, b'Y', xy[1])?);
        let z = round(self, b'Z', bottom)?;
        // Each hole as deep as the others below its clearance, or a control would make one more peck of the last step.
        let clearance = self.number(b'Z').value(z) + clearance - bottom;
        let r = round(self, b'R', clearance)?;
        let moved = self.known[idx(b'Z')].filter(|_| self.cycle.is_none());
        let from = moved.or(self.stands);
        let (level, end) = (round(self, b'Z', clearance)?, round(self, b'Z', end)?);
        // The angles of a turned part are rounded: a hole that is as high as the last may come out a step above it.
        // A cycle must not begin below its clearance, so the tool goes up before.
        let below = from.is_some_and(|z| z < level);
        let same = self.cycle.as_ref() == Some(cycle) && !below;
        if !same {
            self.end_cycle();
        }
        if below {
            self.rise(level)?;
        }
        self.stands = if !cycle.lines.is_empty() {
            Some(end)
        } else if cycle.retract == self.machine.cycle.to_clearance {
            Some(level)
        } else if same {
            self.stands
        } else {
            from.map(|z| z.max(level))
        };
        // A cycle goes along the normal of the plane that the last arc may have left behind.
        let plane = self.plane.is_some_and(|p| p != ArcPlane::Xy);
        if plane && self.machine.dialect != Dialect::Heidenhain {
            self.select_plane(ArcPlane::Xy);
        }
        if !cycle.lines.is_empty() {
            return self.called_hole(cycle, same, [x, y]);
        }
        if !same {
            for line in &cycle.before {
                self.begin();
                self.push(line);
                self.end();
            }
        }
        self.begin();
        self.feed_mode_word(Some(cycle.feed));
        if same {
            // A block without an axis word would drill nothing: X is said again for a hole above the last.
            if self.known[idx(b'X')] == Some(x) && self.known[idx(b'Y')] == Some(y) {
                self.known[idx(b'X')] = None;
            }
        } else {
            self.push(&cycle.retract);
            self.push(&cycle.code);
            for letter in [b'X', b'Y', b'Z', b'R', b'F'] {
                self.known[idx(letter)] = None;
            }
            self.motion = None;
        }
        self.coordinate(b'X', x);
        self.coordinate(b'Y', y);
        self.coordinate(b'Z', z);
        self.coordinate(b'R', r);
        if !same {
            for &(letter, value) in &cycle.words {
                self.value(letter, value)?;
            }
            self.feed_word(Some(cycle.feed))?;
            self.cycle = Some(cycle.clone());
        }
        self.end();
        Ok(())
    }

    /// Up along Z alone, at rapid.
    fn rise(&mut self, z: i64) -> Result<(), TooGreat> {
        if self.machine.dialect == Dialect::Heidenhain {
            let along = [false, false, true, false, false];
            return self.tnc_straight(MotionCode::Rapid, &[0, 0, z, 0, 0], along, None);
        }
        self.begin();
        self.motion_word(MotionCode::Rapid);
        self.coordinate(b'Z', z);
        self.end();
        Ok(())
    }

    /// A hole that one block taps, down to `bottom` and up again with the spindle; the tool stands at the
    /// clearance over it.
    pub(crate) fn tap(
        &mut self,
        code: &str,
        bottom: f64,
        (letter, pitch): (u8, f64),
    ) -> Result<(), TooGreat> {
        let z = self.number(b'Z').round(bottom);
        let z = z.ok_or(TooGreat { letter: 'Z', value: bottom })?;
        self.end_cycle();
        if self.plane.is_some_and(|p| p != ArcPlane::Xy) {
            self.select_plane(ArcPlane::Xy);
        }
        self.begin();
        self.push(code);
        self.motion = None;
        let back = self.known[idx(b'Z')].take();
        self.coordinate(b'Z', z);
        self.value(letter, pitch)?;
        self.known[idx(b'Z')] = back;
        self.end();
        Ok(())
    }

    /// One hole of a cycle that lines define and a position calls.
    fn called_hole(
        &mut self,
        cycle: &NativeCycle,
        same: bool,
        [x, y]: [i64; 2],
    ) -> Result<(), TooGreat> {
        if !same {
            // The lines give the feed as a number alone.
            if self.machine.dialect != Dialect::Heidenhain {
                self.begin();
                self.feed_mode_word(Some(cycle.feed));
                self.end();
            }
            for line in &cycle.lines {
                self.begin();
                self.push(line);
                self.end();
            }
            self.cycle = Some(cycle.clone());
            self.known[idx(b'F')] = None;
            self.motion = None;
        }
        let call = self.machine.cycle.call.clone();
        self.begin();
        if self.machine.dialect == Dialect::Heidenhain {
            self.push("L");
        } else {
            self.motion_word(MotionCode::Rapid);
        }
        self.known[idx(b'X')] = None;
        self.coordinate(b'X', x);
        self.coordinate(b'Y', y);
        if self.machine.dialect == Dialect::Heidenhain {
            self.push("FMAX");
        }
        if !call.is_empty() {
            self.push(&call);
        }
        self.end();
        self.known[idx(b'Z')] = None;
        Ok(())
    }

    /// Is a cycle of the control on?
    pub(crate) fn in_cycle(&self) -> bool {
        self.cycle.is_some()
    }

    /// Ends the cycle of the control. Z and R belonged to the cycle: neither is known any more.
    pub(crate) fn end_cycle(&mut self) {
        if self.cycle.take().is_none() {
            return;
        }
        let off = self.machine.cycle.off.clone();
        if !off.is_empty() {
            self.begin();
            self.push(&off);
            self.end();
        }
        self.known[idx(b'Z')] = None;
        self.known[idx(b'R')] = None;
        self.motion = None;
        if self.feed_mode == Some(FeedMode::InverseTime) {
            self.feed_mode = None;
        }
    }
}
