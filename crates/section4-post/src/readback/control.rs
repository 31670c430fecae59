//! A control of RS-274: its modes, and what each line makes the axes do.

use std::f64::consts::{PI, TAU};

use aptc_geometry::trig;
use nalgebra::Matrix3;

use super::Fault;
use super::words::Line;
use crate::angles::about;
use crate::machine::{ArcCenter, ArcPlane, Machine, MachineKind, Wrap};

/// Positions of X Y Z and two rotary axes in millimetres and degrees; none where the text has not said it.
pub(crate) type Place = [Option<f64>; 5];

/// What a line makes the axes do.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Step {
    /// Some axes go to places of the machine: the tool is away from the part.
    Away,
    /// A straight motion.
    Line { from: Place, to: Place, rapid: bool, feed: Option<f64> },
    /// A circular motion.
    Arc(ArcStep),
    /// The plane of the program is tilted, or no more.
    Frame(Option<Frame>),
    /// Positions are those of the tool end beside turned axes from here on, or no more.
    Center(bool),
}

/// A tilted plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Frame {
    /// Its axes in the frame of the part, as columns.
    Plane(Matrix3<f64>),
    /// The frame of the linear axes with the rotary axes at these angles, degrees.
    Table([f64; 2]),
}

/// A circular motion.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ArcStep {
    pub(crate) from: Place,
    pub(crate) to: Place,
    /// The axes of the plane, such that a positive sweep goes from the first to the second.
    pub(crate) axes: [usize; 2],
    pub(crate) center: [f64; 2],
    pub(crate) radius: f64,
    /// Radians, positive anticlockwise.
    pub(crate) sweep: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    None,
    Rapid,
    Line,
    Thread,
    /// Tapping with the spindle: down, and up again.
    Tap,
    Clockwise,
    Anticlockwise,
    /// A cycle by its number.
    Cycle(i32),
}

/// The modal group of the tool length: of Fanuc's codes and Haas's one is on at a time.
const LENGTH_CODES: [&str; 9] =
    ["G43", "G43.1", "G43.4", "G43.5", "G44", "G49", "G49.1", "G143", "G234"];

/// A control.
pub(crate) struct Control {
    line: Line,
    n_lines: u64,
    mm: Option<f64>,
    mode: Mode,
    plane: ArcPlane,
    absolute: bool,
    center: ArcCenter,
    inverse: bool,
    feed: Option<f64>,
    pub(super) at: Place,
    letters: [u8; 5],
    /// There is no Y: it is always 0.
    lathe: bool,
    divide: [f64; 5],
    modulo: [bool; 5],
    pub(super) to_initial: bool,
    pub(super) cycle: super::cycles::Sticky,
    radius_tolerance_mm: f64,
    /// M2 or M30 was read.
    pub(crate) ended: bool,
    /// MCALL: the cycle that each position calls.
    pub(super) called: Option<super::siemens::Called>,
    /// What begins and ends tool-centre control.
    center_words: [String; 2],
    centered: bool,
}

impl Control {
    pub(crate) fn new(machine: &Machine) -> Self {
        let mut letters = [b'X', b'Y', b'Z', 0, 0];
        let mut modulo = [false; 5];
        let lathe = machine.kind == MachineKind::Lathe;
        if lathe {
            letters[1] = 0;
        }
        let spindle = machine.milling.iter().map(|m| &m.rotary);
        for (i, r) in machine.rotary.iter().chain(spindle).take(2).enumerate() {
            letters[3 + i] = r.letter as u8;
            modulo[3 + i] = r.wrap == Wrap::Modulo && r.min.is_none() && r.max.is_none();
        }
        let siemens = machine.dialect == crate::machine::Dialect::Siemens;
        let diameter = |l: char| machine.axes.get(&l).is_some_and(|a| a.diameter);
        let divide = ['X', 'Y', 'Z', ' ', ' '].map(|l| if diameter(l) { 2.0 } else { 1.0 });
        Self {
            line: Line::new(siemens),
            n_lines: 0,
            mm: None,
            mode: Mode::None,
            plane: ArcPlane::Xy,
            absolute: true,
            center: machine.arcs.as_ref().map_or(ArcCenter::Relative, |a| a.center),
            inverse: false,
            feed: None,
            at: [None; 5],
            letters,
            lathe,
            divide,
            modulo,
            to_initial: true,
            cycle: super::cycles::Sticky::default(),
            radius_tolerance_mm: machine.arcs.as_ref().map_or(0.005, |a| 2.5 * a.radius_tolerance),
            ended: false,
            called: None,
            center_words: super::center_words(machine),
            centered: false,
        }
    }

    /// Number of lines read.
    pub(crate) fn n_lines(&self) -> u64 {
        self.n_lines
    }

    /// Reads a line; what it does is added to `steps`.
    pub(crate) fn read(&mut self, text: &[u8], steps: &mut Vec<Step>) -> Result<(), Fault> {
        self.n_lines += 1;
        let mut line = std::mem::take(&mut self.line);
        let done = line.read(text).and_then(|()| self.obey(&line, steps));
        self.line = line;
        done.map_err(|message| Fault { line: self.n_lines, message })
    }

    fn obey(&mut self, line: &Line, steps: &mut Vec<Step>) -> Result<(), String> {
        if line.words.is_empty() && line.keywords.is_empty() {
            return Ok(());
        }
        if self.ended {
            return Err("a block after the end of the program".into());
        }
        let mut seen: u32 = 0;
        let mut machine_frame = false;
        let mut home = false;
        let mut motion_said = false;
        let mut dwell = false;
        let mut frame = None;
        let mut center = None;
        for keyword in &line.keywords {
            center = self.center_word(&keyword.name).or(center);
            if keyword.name == "CYCLE800" {
                frame = Some(super::siemens::swivelled(keyword));
            }
            machine_frame |= self.keyword(keyword)?;
        }
        for w in &line.words {
            if matches!(w.letter, b'G' | b'M') {
                let said = format!("{}{}", char::from(w.letter), w.value);
                center = self.center_word(&said).or(center);
            }
            match w.letter {
                b'G' => {
                    let code = tenths(w.value)?;
                    match code {
                        70 if self.lathe => self.divide[0] = 2.0,
                        80 if self.lathe => self.divide[0] = 1.0,
                        0 | 10 | 20 | 30 | 320 | 330 | 331 | 730 | 740 | 800..=890
                            if code % 10 == 0 || code == 331 =>
                        {
                            // G80 may stand with another motion code; it ends cycles first.
                            if motion_said && code != 800 && self.mode != Mode::None {
                                return Err("two motion codes in one block".into());
                            }
                            if code != 800 || !motion_said {
                                self.mode = motion(code);
                            }
                            if !matches!(self.mode, Mode::Cycle(_)) {
                                self.cycle = super::cycles::Sticky::default();
                            }
                            motion_said = true;
                        }
                        40 => dwell = true,
                        170 => self.plane = ArcPlane::Xy,
                        180 => self.plane = ArcPlane::Zx,
                        190 => self.plane = ArcPlane::Yz,
                        200 | 700 => self.mm = Some(25.4),
                        210 | 710 => self.mm = Some(1.0),
                        280 | 300 => home = true,
                        682 => {
                            let angle = |l: u8| line.value(l).unwrap_or(0.0);
                            let q = about(2, angle(b'I')) * about(0, angle(b'J'));
                            frame = Some(Some(Frame::Plane(q * about(2, angle(b'K')))));
                        }
                        690 | 2550 => frame = Some(None),
                        2540 => {
                            let [a, b] = [3, 4].map(|i: usize| self.at[i].unwrap_or(0.0));
                            frame = Some(Some(Frame::Table([a, b])));
                        }
                        530 => machine_frame = true,
                        900 => self.absolute = true,
                        901 => self.center = ArcCenter::Absolute,
                        910 => self.absolute = false,
                        911 => self.center = ArcCenter::Relative,
                        930 => {
                            self.inverse = true;
                            self.feed = None;
                        }
                        940 | 950 => {
                            if self.inverse {
                                self.feed = None;
                            }
                            self.inverse = false;
                        }
                        980 => self.to_initial = true,
                        990 => self.to_initial = false,
                        400
                        | 410
                        | 411
                        | 420
                        | 421
                        | 430
                        | 434
                        | 490
                        | 500
                        | 960
                        | 970
                        | 540..=599
                        | 610
                        | 611
                        | 640
                        | 531
                        | 2340
                        | 51 => {}
                        _ => return Err(format!("G{} is not known", w.value)),
                    }
                }
                b'M' => match tenths(w.value)? {
                    20 | 300 => self.ended = true,
                    0 | 10 | 30 | 40 | 50 | 60 | 70 | 80 | 90 | 190 => {}
                    code if code < 10_000 => {}
                    _ => return Err(format!("M{} is not known", w.value)),
                },
                b'F' => {
                    if w.value <= 0.0 {
                        return Err("a feed that does not cut".into());
                    }
                }
                b'N' | b'S' | b'T' | b'H' | b'D' | b'O' | b'P' | b'Q' | b'R' | b'I' | b'J'
                | b'K' | b'X' | b'Y' | b'Z' | b'L' | b'E' => {}
                // Steps of X and Z.
                b'U' | b'W' if self.lathe => {}
                letter if self.letters[3..].contains(&letter) => {}
                letter => return Err(format!("the letter {}", char::from(letter))),
            }
            if w.letter.is_ascii_alphabetic() && !matches!(w.letter, b'G' | b'M') {
                let bit = 1 << (w.letter - b'A');
                if seen & bit != 0 {
                    return Err(format!("two {} words in one block", char::from(w.letter)));
                }
                seen |= bit;
            }
        }
        super::turn_center(center, &mut self.centered, &mut self.at, steps);
        if dwell {
            return Ok(());
        }
        if let Some(frame) = frame {
            let at = |l: u8| line.value(l).unwrap_or(0.0).abs();
            if at(b'X') + at(b'Y') + at(b'Z') > 0.0 {
                return Err("a tilted plane with a zero of its own".into());
            }
            // The numbers of the linear axes no longer mean the same places.
            self.at[..3].fill(None);
            steps.push(Step::Frame(frame));
            return Ok(());
        }
        let scale = self.mm;
        if let Some(f) = line.value(b'F') {
            self.feed = Some(if self.inverse { f } else { f * scale.unwrap_or(1.0) });
        } else if self.inverse {
            self.feed = None;
        }
        if home {
            let named = [0, 1, 2, 3, 4]
                .map(|i| line.words.iter().any(|w| w.letter == self.letters[i]).then_some(0.0));
            self.leave(&named, named.iter().any(Option::is_some));
            steps.push(Step::Away);
            return Ok(());
        }
        let target = self.target(line)?;
        let moves = target.iter().any(Option::is_some);
        if machine_frame {
            self.leave(&target, moves);
            if moves {
                steps.push(Step::Away);
            }
            return Ok(());
        }
        if let Mode::Cycle(code) = self.mode {
            if motion_said || moves {
                return self.drill(code, line, &target, steps);
            }
            return Ok(());
        }
        if !moves {
            let arc = matches!(self.mode, Mode::Clockwise | Mode::Anticlockwise) && motion_said;
            return if arc { Err("an arc without an end".into()) } else { Ok(()) };
        }
        self.go(line, &target, steps)?;
        match self.called {
            Some(called) => self.call(&called, steps),
            None => Ok(()),
        }
    }

    /// Does the word begin or end tool-centre control? The codes of the tool length end each other, and so that which
    /// keeps the tool end on its path, where it is one of them.
    fn center_word(&self, word: &str) -> Option<bool> {
        let [on, off] = &self.center_words;
        let ends =
            word == off || (LENGTH_CODES.contains(&on.as_str()) && LENGTH_CODES.contains(&word));
        if word == on { Some(true) } else { ends.then_some(false) }
    }

    /// The positions that a line names, in millimetres.
    fn target(&self, line: &Line) -> Result<Place, String> {
        let mut target = [None; 5];
        for w in &line.words {
            let step = match w.letter {
                b'U' if self.lathe => Some(0),
                b'W' if self.lathe => Some(2),
                _ => None,
            };
            let named = self.letters.iter().position(|l| *l == w.letter);
            let Some(i) = step.or(named) else { continue };
            let mm = if i < 3 { self.mm.ok_or("a position before the unit is said")? } else { 1.0 };
            let value = w.value * mm / self.divide[i];
            target[i] = Some(if self.absolute && step.is_none() {
                value
            } else {
                self.at[i].ok_or("a step from a place that is not known")? + value
            });
        }
        Ok(target)
    }

    fn leave(&mut self, target: &Place, some: bool) {
        for (at, to) in self.at.iter_mut().zip(target) {
            if to.is_some() || !some {
                *at = None;
            }
        }
    }

    pub(super) fn merged(&self, target: &Place) -> Place {
        let mut to = self.at;
        if self.lathe {
            to[1] = Some(0.0);
        }
        for i in 0..5 {
            let Some(value) = target[i] else { continue };
            // The control takes the shorter way round.
            to[i] = Some(match self.at[i] {
                Some(at) if self.modulo[i] => {
                    at + (value - at) - 360.0 * ((value - at) / 360.0).round()
                }
                _ => value,
            });
        }
        to
    }

    fn go(&mut self, line: &Line, target: &Place, steps: &mut Vec<Step>) -> Result<(), String> {
        let from = self.at;
        let to = self.merged(target);
        let step = match self.mode {
            Mode::None => return Err("a position without a motion code".into()),
            Mode::Rapid => Step::Line { from, to, rapid: true, feed: None },
            Mode::Line => Step::Line { from, to, rapid: false, feed: Some(self.needed_feed()?) },
            Mode::Thread => Step::Line { from, to, rapid: false, feed: None },
            Mode::Tap => {
                if !line.value(b'K').is_some_and(|k| k > 0.0) {
                    return Err("tapping without its lead K".into());
                }
                if from[..2] != to[..2] || from[3..] != to[3..] {
                    return Err("tapping that does not go along Z alone".into());
                }
                steps.push(Step::Line { from, to, rapid: false, feed: None });
                // The control stands where it began, and the code holds for this block only.
                steps.push(Step::Line { from: to, to: from, rapid: false, feed: None });
                self.mode = Mode::None;
                return Ok(());
            }
            Mode::Clockwise | Mode::Anticlockwise => {
                self.needed_feed()?;
                Step::Arc(self.arc(line, from, to)?)
            }
            Mode::Cycle(_) => unreachable!("cycles were done before"),
        };
        self.at = to;
        steps.push(step);
        Ok(())
    }

    pub(super) fn needed_feed(&self) -> Result<f64, String> {
        self.feed.ok_or_else(|| {
            let each = if self.inverse {
                "inverse time without F in the block"
            } else {
                "a cut without a feed"
            };
            each.to_string()
        })
    }

    pub(super) fn unit(&self) -> f64 {
        self.mm.unwrap_or(1.0)
    }

    pub(super) fn along_z(&self) -> bool {
        self.plane == ArcPlane::Xy
    }

    fn arc(&self, line: &Line, from: Place, to: Place) -> Result<ArcStep, String> {
        let (axes, letters) = match self.plane {
            ArcPlane::Xy => ([0, 1], [b'I', b'J']),
            ArcPlane::Zx => ([2, 0], [b'K', b'I']),
            ArcPlane::Yz => ([1, 2], [b'J', b'K']),
        };
        if from.iter().zip(&to).skip(3).any(|(a, b)| a != b) {
            return Err("an arc while a rotary axis turns".into());
        }
        let both = |p: &Place| Some([p[axes[0]]?, p[axes[1]]?]);
        let unknown = "an arc from a place that is not known";
        let (a, b) = (both(&from).ok_or(unknown)?, both(&to).ok_or(unknown)?);
        let anticlockwise = self.mode == Mode::Anticlockwise;
        let mm = self.unit();
        let center = if let Some(r) = line.value(b'R') {
            center_by_radius(a, b, r * mm, anticlockwise)?
        } else {
            let said = [line.value(letters[0]), line.value(letters[1])];
            if said == [None, None] {
                return Err("an arc without a centre".into());
            }
            let absolute = self.center == ArcCenter::Absolute;
            let one = |i: usize| match said[i] {
                Some(c) if absolute => c * mm,
                Some(c) => a[i] + c * mm,
                None => a[i],
            };
            [one(0), one(1)]
        };
        let spoke = |p: [f64; 2]| [p[0] - center[0], p[1] - center[1]];
        let (u, v) = (spoke(a), spoke(b));
        let (r0, r1) = (trig::hypot(u[0], u[1]), trig::hypot(v[0], v[1]));
        if r0 <= 0.0 || (r0 - r1).abs() > self.radius_tolerance_mm {
            return Err(format!("an arc whose radii are {r0:.5} and {r1:.5} mm"));
        }
        let turned = trig::atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
        let whole = trig::hypot(a[0] - b[0], a[1] - b[1]) < 1e-7;
        let sweep = match (anticlockwise, whole) {
            (true, true) => TAU,
            (false, true) => -TAU,
            (true, false) if turned <= 0.0 => turned + TAU,
            (false, false) if turned >= 0.0 => turned - TAU,
            _ => turned,
        };
        Ok(ArcStep { from, to, axes, center, radius: r0, sweep })
    }
}

fn motion(code: i64) -> Mode {
    match code {
        0 => Mode::Rapid,
        10 => Mode::Line,
        320 | 330 => Mode::Thread,
        331 => Mode::Tap,
        20 => Mode::Clockwise,
        30 => Mode::Anticlockwise,
        800 => Mode::None,
        c => Mode::Cycle(i32::try_from(c / 10).unwrap_or(0)),
    }
}

/// A code in tenths: G43.4 is 434.
fn tenths(value: f64) -> Result<i64, String> {
    let t = (value * 10.0).round();
    if (value * 10.0 - t).abs() > 1e-6 || !(0.0..100_000.0).contains(&t) {
        return Err(format!("the code {value}"));
    }
    #[expect(clippy::cast_possible_truncation, reason = "within 0..100000")]
    Ok(t as i64)
}

fn center_by_radius(
    a: [f64; 2],
    b: [f64; 2],
    r: f64,
    anticlockwise: bool,
) -> Result<[f64; 2], String> {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let chord = trig::hypot(dx, dy);
    if chord <= 0.0 {
        return Err("a whole turn by radius".into());
    }
    let h2 = r * r - chord * chord / 4.0;
    if h2 < -1e-6 * r * r {
        return Err("a radius shorter than half the chord".into());
    }
    let h = h2.max(0.0).sqrt();
    // A positive radius means the arc of less than half a turn: its centre lies left of an anticlockwise arc.
    let side = if anticlockwise == (r > 0.0) { 1.0 } else { -1.0 };
    Ok([
        f64::midpoint(a[0], b[0]) - side * h * dy / chord,
        f64::midpoint(a[1], b[1]) + side * h * dx / chord,
    ])
}

impl ArcStep {
    /// The place at a part of the way, 0 to 1.
    pub(crate) fn at(&self, part: f64) -> Place {
        let spoke = [0, 1].map(|i| self.from[self.axes[i]].unwrap_or(0.0) - self.center[i]);
        let (s, c) = trig::sin_cos(self.sweep * part);
        let mut p = self.from;
        p[self.axes[0]] = Some(self.center[0] + spoke[0] * c - spoke[1] * s);
        p[self.axes[1]] = Some(self.center[1] + spoke[0] * s + spoke[1] * c);
        let n = 3 - self.axes[0] - self.axes[1];
        if let (Some(a), Some(b)) = (self.from[n], self.to[n]) {
            p[n] = Some(a + (b - a) * part);
        }
        debug_assert!(self.sweep.abs() <= 2.0 * PI + 1e-9, "one turn a block");
        p
    }
}
