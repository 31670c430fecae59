//! Blocks of motion: straight, along arcs, with the spindle.

use std::sync::Arc;

use crate::machine::{ArcCenter, ArcPlane, Dialect};

use super::{Blocks, FeedWord, Joints, Rounded, TooGreat, idx};

/// What a block of motion does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MotionCode {
    Rapid,
    Line,
    Clockwise,
    Anticlockwise,
}

/// An arc in one of the control's planes, all lengths rounded already.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ArcBlock {
    pub(crate) plane: ArcPlane,
    pub(crate) anticlockwise: bool,
    pub(crate) end: Rounded,
    /// From the start to the centre, along the two axes of the plane.
    pub(crate) center: [f64; 2],
    /// Coordinates of the centre.
    pub(crate) center_at: [f64; 2],
    pub(crate) radius: f64,
    /// More than half a turn?
    pub(crate) large: bool,
    /// Angle travelled, degrees, positive anticlockwise.
    pub(crate) sweep: f64,
    /// Motion along the normal of the plane.
    pub(crate) rise: f64,
}

impl Blocks {
    /// G0 or G1 to `joints`; only the axes of `mask` are written. No block when nothing would change.
    pub(crate) fn straight(
        &mut self,
        code: MotionCode,
        joints: &Joints,
        mut mask: [bool; 5],
        feed: Option<FeedWord>,
    ) -> Result<(), TooGreat> {
        if self.tilted {
            mask[3..].fill(false);
        }
        let q = self.round(joints)?;
        let moves = (0..5).any(|i| {
            mask[i] && self.axes[i] != b' ' && self.known[idx(self.axes[i])] != Some(q[i])
        });
        if !moves {
            return Ok(());
        }
        self.end_cycle();
        if self.machine.dialect == Dialect::Heidenhain {
            return self.tnc_straight(code, &q, mask, feed);
        }
        self.begin();
        self.feed_mode_word(feed);
        if let Some(words) = self.with_motion.take() {
            self.push(&words);
            self.motion = None;
        }
        if mask[2]
            && self.known[idx(b'Z')] != Some(q[2])
            && let Some(words) = self.with_tool_axis.take()
        {
            self.push(&words);
        }
        self.motion_word(code);
        for i in 0..5 {
            if mask[i] && self.axes[i] != b' ' {
                self.coordinate(self.axes[i], q[i]);
            }
        }
        self.feed_word(feed)?;
        self.end();
        Ok(())
    }

    /// G2 or G3.
    pub(crate) fn arc(&mut self, arc: &ArcBlock, feed: Option<FeedWord>) -> Result<(), TooGreat> {
        self.end_cycle();
        if self.machine.dialect == Dialect::Heidenhain {
            return self.tnc_arc(arc, feed);
        }
        self.begin();
        self.feed_mode_word(feed);
        self.plane_word(arc.plane);
        if let Some(words) = self.with_tool_axis.take() {
            self.push(&words);
        }
        self.motion_word(if arc.anticlockwise {
            MotionCode::Anticlockwise
        } else {
            MotionCode::Clockwise
        });
        let (axes, letters) = arc.plane.axes();
        let center = self.machine.arcs.as_ref().map_or(ArcCenter::Relative, |a| a.center);
        for i in 0..3 {
            // In the plane of the arc both end coordinates are written: a control must not have to guess.
            if axes.contains(&i) {
                self.known[idx(self.axes[i])] = None;
            }
            if self.axes[i] != b' ' {
                self.coordinate(self.axes[i], arc.end[i]);
            }
        }
        if center == ArcCenter::Radius {
            let r = if arc.large { -arc.radius } else { arc.radius };
            self.value(b'R', r)?;
        } else {
            let c = if center == ArcCenter::Absolute { arc.center_at } else { arc.center };
            for (letter, value) in letters.into_iter().zip(c) {
                self.value(letter, value)?;
            }
        }
        self.feed_word(feed)?;
        self.end();
        Ok(())
    }

    /// A straight cut that goes with the spindle, `lead` along Z a turn.
    pub(crate) fn thread(&mut self, joints: &Joints, lead: f64) -> Result<(), TooGreat> {
        let q = self.round(joints)?;
        self.end_cycle();
        self.begin();
        let machine = Arc::clone(&self.machine);
        self.push(&machine.turning.thread);
        self.motion = None;
        for (letter, q) in self.axes.into_iter().zip(q).take(3) {
            if letter != b' ' {
                self.coordinate(letter, q);
            }
        }
        let letter = machine.turning.lead.map_or(b'K', |l| l as u8);
        self.value(letter, lead)?;
        if letter == b'F' {
            self.known[idx(b'F')] = None;
        }
        self.end();
        Ok(())
    }

    /// Selects the plane in a block of its own.
    pub(crate) fn select_plane(&mut self, plane: ArcPlane) {
        if self.plane != Some(plane) {
            self.begin();
            self.plane_word(plane);
            self.end();
        }
    }
}

impl ArcPlane {
    /// The two axes of the plane in the order in which a positive turn goes from the first to the second,
    /// and the letters of the centre along them.
    pub(crate) fn axes(self) -> ([usize; 2], [u8; 2]) {
        match self {
            Self::Xy => ([0, 1], [b'I', b'J']),
            Self::Zx => ([2, 0], [b'K', b'I']),
            Self::Yz => ([1, 2], [b'J', b'K']),
        }
    }
}
