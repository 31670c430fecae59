//! Words of a block, each written when it changes what the control knows.

use std::sync::Arc;

use crate::machine::ArcPlane;
use crate::number::Number;

use super::{Blocks, FeedMode, FeedWord, MotionCode, TooGreat, idx};

impl Blocks {
    pub(super) fn begin(&mut self) {
        self.start = self.out.len();
        if self.skip {
            self.out.extend_from_slice(self.machine.program.skip.as_bytes());
        }
        if self.numbered {
            self.out.extend_from_slice(self.machine.program.block_numbers.letter.as_bytes());
            let mut digits = Vec::with_capacity(10);
            Number::new(&WHOLE, false).write(i64::from(self.next_number), &mut digits);
            self.out.extend_from_slice(&digits);
        }
        self.bare = self.out.len();
    }

    pub(super) fn end(&mut self) {
        if self.out.len() == self.bare {
            self.out.truncate(self.start);
            return;
        }
        if self.numbered {
            let n = &self.machine.program.block_numbers;
            self.next_number = self.next_number.saturating_add(self.number_step);
            if self.next_number > n.max {
                self.next_number = n.start;
            }
        }
        self.out.push(b'\n');
        self.lines += 1;
    }

    pub(super) fn push(&mut self, text: &str) {
        self.separate();
        self.out.extend_from_slice(text.as_bytes());
    }

    pub(super) fn separate(&mut self) {
        let first = self.out.len() == self.bare;
        if !first || self.numbered {
            self.out.extend_from_slice(self.machine.program.separator.as_bytes());
        }
    }

    pub(super) fn coordinate(&mut self, letter: u8, q: i64) {
        let known = &mut self.known[idx(letter)];
        if *known == Some(q) {
            return;
        }
        *known = Some(q);
        self.number_word(letter, q);
    }

    pub(super) fn number_word(&mut self, letter: u8, q: i64) {
        self.separate();
        self.out.push(letter);
        let number = self.number(letter);
        number.write(q, &mut self.out);
    }

    pub(super) fn value(&mut self, letter: u8, value: f64) -> Result<(), TooGreat> {
        let q = self
            .number(letter)
            .round(value)
            .ok_or(TooGreat { letter: char::from(letter), value })?;
        self.number_word(letter, q);
        Ok(())
    }

    pub(super) fn motion_word(&mut self, code: MotionCode) {
        if self.motion == Some(code) {
            return;
        }
        self.motion = Some(code);
        self.push(match code {
            MotionCode::Rapid => "G0",
            MotionCode::Line => "G1",
            MotionCode::Clockwise => "G2",
            MotionCode::Anticlockwise => "G3",
        });
    }

    pub(super) fn plane_word(&mut self, plane: ArcPlane) {
        if self.plane != Some(plane) {
            self.plane = Some(plane);
            self.push(match plane {
                ArcPlane::Xy => "G17",
                ArcPlane::Zx => "G18",
                ArcPlane::Yz => "G19",
            });
        }
    }

    pub(super) fn feed_mode_word(&mut self, feed: Option<FeedWord>) {
        let Some(feed) = feed else { return };
        if self.feed_mode == Some(feed.mode) {
            return;
        }
        self.feed_mode = Some(feed.mode);
        self.known[idx(b'F')] = None;
        let machine = Arc::clone(&self.machine);
        self.push(match feed.mode {
            FeedMode::PerMinute => &machine.feed.per_minute,
            FeedMode::PerRevolution => &machine.feed.per_revolution,
            FeedMode::InverseTime => &machine.feed.inverse_time,
        });
    }

    pub(super) fn feed_word(&mut self, feed: Option<FeedWord>) -> Result<(), TooGreat> {
        let Some(feed) = feed else { return Ok(()) };
        let number = self.number(b'F');
        let too_great = TooGreat { letter: 'F', value: feed.value };
        // A feed below the last decimal would be written as zero, and zero stops the machine.
        let q = number.round(feed.value).ok_or(too_great)?.max(1);
        if feed.mode == FeedMode::InverseTime {
            self.known[idx(b'F')] = None;
        }
        self.coordinate(b'F', q);
        Ok(())
    }
}

const WHOLE: crate::machine::Format =
    crate::machine::Format { mm: 0, inch: None, point: false, zeros: false, plus: false };
