//! Blocks: the modal state of the control, and the text that changes it.
//!
//! A word is written when it changes what the control already knows, and always after
//! [`Blocks::forget`]. All comparisons are between rounded numbers, so what the control knows is what
//! stands in the text.

use std::sync::Arc;

use crate::machine::{ArcPlane, Machine, MachineKind, Wrap};
use crate::number::Number;

mod apt;
mod cycle;
mod heidenhain;
mod motion;
mod text;
mod word;

pub(crate) use apt::AptText;
pub(crate) use cycle::NativeCycle;
pub(crate) use motion::{ArcBlock, MotionCode};
pub(crate) use text::render;

/// Positions of the axes: X Y Z and up to two rotary axes, in output units and degrees.
pub(crate) type Joints = [f64; 5];

/// The same in units of the last decimal.
pub(crate) type Rounded = [i64; 5];

/// A number that is too great for the control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TooGreat {
    /// The address.
    pub(crate) letter: char,
    /// The number.
    pub(crate) value: f64,
}

/// How the feed number is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FeedMode {
    PerMinute,
    PerRevolution,
    InverseTime,
}

/// Feed of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FeedWord {
    pub(crate) mode: FeedMode,
    pub(crate) value: f64,
}

/// Writer of blocks.
pub(crate) struct Blocks {
    /// The text that was not yet taken.
    pub(crate) out: Vec<u8>,
    /// Lines written so far.
    pub(crate) lines: u64,
    machine: Arc<Machine>,
    numbers: [Option<Number>; 26],
    /// What the control knows, by address letter.
    known: [Option<i64>; 26],
    motion: Option<MotionCode>,
    plane: Option<ArcPlane>,
    feed_mode: Option<FeedMode>,
    /// Letters of the five axes; a blank for an axis that is not there.
    axes: [u8; 5],
    /// Factor of each axis: 2 for diameters.
    factor: [f64; 5],
    /// Rotary axes that are written within one turn.
    modulo: [bool; 2],
    cycle: Option<NativeCycle>,
    /// Z where the last hole of a cycle has left the tool; it counts until another motion.
    stands: Option<i64>,
    /// The plane of the program is tilted: the control itself places the rotary axes.
    pub(crate) tilted: bool,
    /// OPSKIP is on.
    pub(crate) skip: bool,
    /// Blocks are numbered.
    pub(crate) numbered: bool,
    /// The next block number and the step.
    pub(crate) next_number: u32,
    pub(crate) number_step: u32,
    /// Words for the next motion block along the tool axis: G43 H1.
    pub(crate) with_tool_axis: Option<String>,
    /// Words for the next motion block: G41 D1.
    pub(crate) with_motion: Option<String>,
    start: usize,
    bare: usize,
}

impl Blocks {
    pub(crate) fn new(machine: Arc<Machine>, inch: bool) -> Self {
        let mut numbers = [None; 26];
        for (letter, format) in &machine.format {
            numbers[idx(*letter as u8)] = Some(Number::new(format, inch));
        }
        let (axes, factor, modulo) = axes_of(&machine);
        let n = &machine.program.block_numbers;
        let (numbered, next_number, number_step) = (n.on, n.start, n.step);
        Self {
            out: Vec::new(),
            lines: 0,
            machine,
            numbers,
            known: [None; 26],
            motion: None,
            plane: None,
            feed_mode: None,
            axes,
            factor,
            modulo,
            cycle: None,
            stands: None,
            tilted: false,
            skip: false,
            numbered,
            next_number,
            number_step,
            with_tool_axis: None,
            with_motion: None,
            start: 0,
            bare: 0,
        }
    }

    /// A lathe begins or ends to mill.
    pub(crate) fn change_machine(&mut self, machine: Arc<Machine>) {
        (self.axes, self.factor, self.modulo) = axes_of(&machine);
        self.machine = machine;
    }

    /// The control may be in any state: every word is written again.
    pub(crate) fn forget(&mut self) {
        self.known = [None; 26];
        self.stands = None;
        self.motion = None;
        self.plane = None;
        self.feed_mode = None;
        self.cycle = None;
    }

    /// The modes are as the start lines of the machine leave them; positions are unknown.
    pub(crate) fn forget_after_start(&mut self) {
        self.forget();
        let lathe = self.machine.kind == MachineKind::Lathe;
        self.plane = Some(if lathe { ArcPlane::Zx } else { ArcPlane::Xy });
        self.feed_mode = Some(FeedMode::PerMinute);
    }

    /// Lines of the machine file have moved the axes: the modes are as those lines say, else as they were.
    pub(crate) fn forget_after_lines(&mut self) {
        let (plane, feed_mode) = (self.plane, self.feed_mode);
        self.forget();
        (self.plane, self.feed_mode) = (plane, feed_mode);
    }

    /// Format of an address; that of X for a letter without one.
    pub(crate) fn number(&self, letter: u8) -> Number {
        let own = self.numbers[idx(letter)];
        let other = || self.numbers[idx(b'X')].expect("checked when the machine was read");
        own.unwrap_or_else(other)
    }

    /// The positions as the control will know them.
    pub(crate) fn round(&self, joints: &Joints) -> Result<Rounded, TooGreat> {
        let mut q = [0; 5];
        for i in 0..5 {
            let letter = self.axes[i];
            if letter == b' ' {
                continue;
            }
            let value = joints[i] * self.factor[i];
            let number = self.number(letter);
            q[i] = number.round(value).ok_or(TooGreat { letter: char::from(letter), value })?;
            if i >= 3 && self.modulo[i - 3] {
                q[i] = q[i].rem_euclid(number.round(360.0).unwrap_or(i64::MAX));
            }
        }
        Ok(q)
    }

    /// Angles as they will be written, not wrapped.
    pub(crate) fn round_angles(&self, angles: [f64; 2]) -> [f64; 2] {
        let mut out = angles;
        for i in 0..2 {
            if self.axes[3 + i] != b' ' {
                let n = self.number(self.axes[3 + i]);
                out[i] = n.round(angles[i]).map_or(angles[i], |q| n.value(q));
            }
        }
        out
    }

    /// The positions that rounded numbers stand for.
    pub(crate) fn unround(&self, q: &Rounded) -> Joints {
        let mut joints = [0.0; 5];
        for i in 0..5 {
            if self.axes[i] != b' ' {
                joints[i] = self.number(self.axes[i]).value(q[i]) / self.factor[i];
            }
        }
        joints
    }

    /// A block of the control's own words.
    pub(crate) fn line(&mut self, text: &str) {
        if text.is_empty() {
            return;
        }
        self.end_cycle();
        for line in text.split('\n') {
            // The ends of a tape and the number of a program stand alone, where numbers of blocks have a letter.
            let alone = line.starts_with('%')
                || line
                    .strip_prefix('O')
                    .is_some_and(|n| n.starts_with(|c: char| c.is_ascii_digit()));
            let alone = alone && !self.machine.program.block_numbers.letter.is_empty();
            let (numbered, skip) = (self.numbered, self.skip);
            (self.numbered, self.skip) = (numbered && !alone, skip && !alone);
            self.begin();
            self.push(line);
            self.end();
            (self.numbered, self.skip) = (numbered, skip);
            self.take_modes(line);
        }
    }

    /// The rounded number that the control knows of an axis, 0 to 4.
    pub(crate) fn known_axis(&self, i: usize) -> Option<i64> {
        if self.axes[i] == b' ' { Some(0) } else { self.known[idx(self.axes[i])] }
    }

    /// The control's number of an axis, 0 to 4, no longer means the same place.
    pub(crate) fn forget_axis(&mut self, i: usize) {
        if self.axes[i] != b' ' {
            self.known[idx(self.axes[i])] = None;
        }
        if self.axes[i] == b'Z' {
            self.stands = None;
        }
    }
}

/// Letters of the five axes, the factor of each, and which rotary axes are written within one turn.
fn axes_of(machine: &Machine) -> ([u8; 5], [f64; 5], [bool; 2]) {
    let mut axes = [b' '; 5];
    let mut factor = [1.0; 5];
    let mut modulo = [false; 2];
    for (i, letter) in [b'X', b'Y', b'Z'].into_iter().enumerate() {
        axes[i] = letter;
        if machine.axes.get(&char::from(letter)).is_some_and(|a| a.diameter) {
            factor[i] = 2.0;
        }
    }
    if machine.kind == MachineKind::Lathe {
        axes[1] = b' ';
    }
    for (i, r) in machine.rotary.iter().take(2).enumerate() {
        axes[3 + i] = r.letter as u8;
        modulo[i] = r.wrap == Wrap::Modulo && r.min.is_none() && r.max.is_none();
    }
    (axes, factor, modulo)
}

fn idx(letter: u8) -> usize {
    usize::from(letter.wrapping_sub(b'A')).min(25)
}
