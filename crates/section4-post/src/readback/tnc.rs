//! A Heidenhain control: conversational lines.

use std::f64::consts::TAU;

use aptc_geometry::trig;

use super::Fault;
use super::control::{ArcStep, Frame, Place, Step};
use super::cycles::{Kind, MOST_PECKS, NOTHING_LEFT};
use crate::angles::about;
use crate::machine::{Machine, Wrap};

/// A control.
pub(crate) struct Tnc {
    n_lines: u64,
    mm: f64,
    at: Place,
    letters: [u8; 5],
    modulo: [bool; 5],
    feed: Option<f64>,
    center: [Option<f64>; 3],
    cycle: Option<Cycle>,
    pecking: Pecking,
    /// A line that goes on in the next.
    open: String,
    radius_tolerance_mm: f64,
    ended: bool,
    /// What begins and ends tool-centre control: a word, or a line of FUNCTION.
    center_words: [String; 2],
    centered: bool,
}

#[derive(Clone, Copy, Debug)]
struct Cycle {
    kind: Kind,
    clear: f64,
    bottom: f64,
    end: f64,
    feed: f64,
}

/// PECKING, cycle 1 of old controls, as its lines give it: from the height at which it is called.
#[derive(Clone, Copy, Debug, Default)]
struct Pecking {
    distance: Option<f64>,
    depth: f64,
    step: f64,
    feed: f64,
}

impl Pecking {
    /// Takes `1.2 DEPTH-24.62`; false for a line of another cycle.
    fn take(&mut self, rest: &[&str], mm: f64) -> bool {
        let Some((&head, words)) = rest.split_first() else { return false };
        let value = |name: &str| words.first().and_then(|w| number(w.strip_prefix(name)?));
        match head {
            "1.1" => self.distance = value("DIST").map(|d| d * mm),
            "1.2" => self.depth = value("DEPTH").unwrap_or(0.0) * mm,
            "1.3" => self.step = value("PLNGNG").unwrap_or(0.0) * mm,
            "1.5" => self.feed = value("F").unwrap_or(0.0) * mm,
            _ => return matches!(head, "1.0" | "1.4"),
        }
        true
    }

    fn cycle(&self, z: Option<f64>) -> Option<Cycle> {
        let (z, distance) = (z?, self.distance?);
        let kind = Kind::Pecks { first: distance + self.step, step: self.step, out: true };
        let bottom = z - distance + self.depth;
        (self.step > 0.0).then_some(Cycle { kind, clear: z, bottom, end: z, feed: self.feed })
    }
}

impl Tnc {
    pub(super) fn new(machine: &Machine) -> Self {
        let mut letters = [b'X', b'Y', b'Z', 0, 0];
        let mut modulo = [false; 5];
        for (i, r) in machine.rotary.iter().take(2).enumerate() {
            letters[3 + i] = r.letter as u8;
            modulo[3 + i] = r.wrap == Wrap::Modulo && r.min.is_none() && r.max.is_none();
        }
        Self {
            n_lines: 0,
            mm: 1.0,
            at: [None; 5],
            letters,
            modulo,
            feed: None,
            center: [None; 3],
            cycle: None,
            pecking: Pecking::default(),
            open: String::new(),
            radius_tolerance_mm: machine.arcs.as_ref().map_or(0.005, |a| 2.5 * a.radius_tolerance),
            ended: false,
            center_words: [&machine.multiaxis.tool_center_on, &machine.multiaxis.tool_center_off]
                .map(|line| line.trim().to_owned()),
            centered: false,
        }
    }

    pub(super) fn n_lines(&self) -> u64 {
        self.n_lines
    }

    pub(super) fn read(&mut self, text: &[u8], steps: &mut Vec<Step>) -> Result<(), Fault> {
        self.n_lines += 1;
        let text = String::from_utf8_lossy(text);
        let text = text.trim();
        let joined = if self.open.is_empty() {
            text.to_string()
        } else {
            format!("{} {text}", std::mem::take(&mut self.open))
        };
        if let Some(first) = joined.strip_suffix('~') {
            // The remark after a parameter ends at the sign of continuation.
            self.open = first.split(';').next().unwrap_or("").trim_end().to_string();
            return Ok(());
        }
        self.obey(&joined, steps).map_err(|message| Fault { line: self.n_lines, message })
    }

    fn obey(&mut self, text: &str, steps: &mut Vec<Step>) -> Result<(), String> {
        let text = text.split(';').next().unwrap_or("").trim();
        // The sign of optional blocks stands before the number of the block or behind it.
        let text = text.trim_start_matches('/');
        let mut words = text.split_ascii_whitespace().peekable();
        if words.peek().is_some_and(|w| w.bytes().all(|b| b.is_ascii_digit())) {
            words.next();
        }
        let Some(head) = words.next() else { return Ok(()) };
        if self.ended {
            return Err("a block after the end of the program".into());
        }
        let rest: Vec<&str> = words.collect();
        let [on, off] = &self.center_words;
        let said = |line: &str| {
            let whole = || std::iter::once(head).chain(rest.iter().copied());
            whole().any(|w| w == line) || whole().eq(line.split_ascii_whitespace())
        };
        let center = if said(on) { Some(true) } else { said(off).then_some(false) };
        super::turn_center(center, &mut self.centered, &mut self.at, steps);
        match head.trim_start_matches('/') {
            "" => Ok(()),
            "BEGIN" => {
                self.mm = if rest.last() == Some(&"INCH") { 25.4 } else { 1.0 };
                Ok(())
            }
            "END" => {
                self.ended = true;
                Ok(())
            }
            "BLK" | "TOOL" | "STOP" | "FUNCTION" | "CALL" | "LBL" => Ok(()),
            "PLANE" => {
                let angle = |name: &str| {
                    rest.iter().find_map(|w| number(w.strip_prefix(name)?)).unwrap_or(0.0)
                };
                let frame = match rest.first() {
                    Some(&"RESET") => None,
                    Some(&"SPATIAL") => {
                        let q = about(0, angle("SPA")) * about(1, angle("SPB"));
                        Some(Frame::Plane(q * about(2, angle("SPC"))))
                    }
                    _ => return Err("a plane that is not known".into()),
                };
                self.at[..3].fill(None);
                steps.push(Step::Frame(frame));
                Ok(())
            }
            "CYCL" if rest.first() == Some(&"DEF") => self.define(&rest[1..]),
            "L" => self.line(&rest, steps),
            "CC" => {
                // It holds until the next.
                self.center = [None; 3];
                for w in &rest {
                    let (letter, value) = word(w)?;
                    if let Some(i) = b"XYZ".iter().position(|l| *l == letter) {
                        self.center[i] = Some(value * self.mm);
                    }
                }
                Ok(())
            }
            "C" | "CP" => self.arc(head == "CP", &rest, steps),
            m if m.starts_with('M') && m[1..].bytes().all(|b| b.is_ascii_digit()) => Ok(()),
            other => Err(format!("the word {other} is not known")),
        }
    }

    /// Sets the feed of a word; true when the word is one.
    fn feed_word(&mut self, w: &str, rapid: &mut bool) -> Result<bool, String> {
        if w == "FMAX" {
            *rapid = true;
            return Ok(true);
        }
        let Some(f) = w.strip_prefix('F') else { return Ok(false) };
        let f = number(f).ok_or_else(|| format!("the feed {w}"))?;
        if f <= 0.0 {
            return Err("a feed that does not cut".into());
        }
        self.feed = Some(f * self.mm);
        Ok(true)
    }

    fn line(&mut self, rest: &[&str], steps: &mut Vec<Step>) -> Result<(), String> {
        let (mut rapid, mut machine_frame, mut call) = (false, false, false);
        let mut to = self.at;
        let mut named = [false; 5];
        for w in rest {
            if self.feed_word(w, &mut rapid)? {
                continue;
            }
            match *w {
                "R0" | "RL" | "RR" => continue,
                "M91" => {
                    machine_frame = true;
                    continue;
                }
                "M99" => {
                    call = true;
                    continue;
                }
                _ => {}
            }
            let (letter, value) = word(w)?;
            if letter == b'M' {
                continue;
            }
            let Some(i) = self.letters.iter().position(|l| *l == letter) else {
                return Err(format!("the word {w} is not known"));
            };
            let value = if i < 3 { value * self.mm } else { value };
            named[i] = true;
            to[i] = Some(match self.at[i] {
                Some(at) if self.modulo[i] => value - 360.0 * ((value - at) / 360.0).round(),
                _ => value,
            });
        }
        if machine_frame {
            for (at, _) in self.at.iter_mut().zip(named).filter(|(_, named)| *named) {
                *at = None;
            }
            steps.push(Step::Away);
            return Ok(());
        }
        if named.contains(&true) {
            let feed = if rapid { None } else { Some(self.feed.ok_or("a cut without a feed")?) };
            steps.push(Step::Line { from: self.at, to, rapid, feed });
            self.at = to;
        }
        if call {
            let old = self.pecking.cycle(self.at[2]);
            let cycle = self.cycle.or(old).ok_or("M99 without a cycle")?;
            self.drill(&cycle, steps)?;
        }
        Ok(())
    }

    fn arc(&mut self, polar: bool, rest: &[&str], steps: &mut Vec<Step>) -> Result<(), String> {
        let mut to = self.at;
        let mut turn = 0.0;
        let mut angle = None;
        let mut rapid = false;
        for w in rest {
            if self.feed_word(w, &mut rapid)? {
                continue;
            }
            match *w {
                "DR+" => turn = 1.0,
                "DR-" => turn = -1.0,
                "R0" | "RL" | "RR" => {}
                w if w.starts_with("IPA") => {
                    angle = Some(number(&w[3..]).ok_or_else(|| format!("the angle {w}"))?);
                }
                w if w.starts_with('I') && w.len() > 2 => {
                    let (letter, value) = word(&w[1..])?;
                    let i = b"XYZ".iter().position(|l| *l == letter).ok_or("a step of no axis")?;
                    to[i] = Some(self.at[i].ok_or("a step from nowhere")? + value * self.mm);
                }
                w => {
                    let (letter, value) = word(w)?;
                    let i = b"XYZ".iter().position(|l| *l == letter).ok_or("an arc of no axis")?;
                    to[i] = Some(value * self.mm);
                }
            }
        }
        self.feed.ok_or("a cut without a feed")?;
        if turn == 0.0 {
            return Err("an arc without DR".into());
        }
        let axes = match self.center {
            [Some(_), Some(_), None] => [0, 1],
            [Some(_), None, Some(_)] => [2, 0],
            [None, Some(_), Some(_)] => [1, 2],
            _ => return Err("an arc without a centre in one plane".into()),
        };
        let center = axes.map(|i| self.center[i].unwrap_or(0.0));
        let both = |p: &Place| Some(axes.map(|i| p[i])).filter(|c| c.iter().all(Option::is_some));
        let unknown = "an arc from a place that is not known";
        let a = both(&self.at).ok_or(unknown)?.map(|c| c.unwrap_or(0.0));
        let u = [a[0] - center[0], a[1] - center[1]];
        let radius = trig::hypot(u[0], u[1]);
        // DR+ is anticlockwise against the axis of the plane: from X to Y, Y to Z, Z to X.
        let sense: f64 = turn;
        let sweep = if let (true, Some(degrees)) = (polar, angle) {
            let sweep = degrees.to_radians();
            let (s, c) = trig::sin_cos(sweep);
            to[axes[0]] = Some(center[0] + u[0] * c - u[1] * s);
            to[axes[1]] = Some(center[1] + u[0] * s + u[1] * c);
            sweep
        } else {
            let b = axes.map(|i| to[i].unwrap_or(0.0));
            let v = [b[0] - center[0], b[1] - center[1]];
            let r1 = trig::hypot(v[0], v[1]);
            if (radius - r1).abs() > self.radius_tolerance_mm {
                return Err(format!("an arc whose radii are {radius:.5} and {r1:.5} mm"));
            }
            let turned = trig::atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
            let whole = trig::hypot(a[0] - b[0], a[1] - b[1]) < 1e-7;
            match (sense > 0.0, whole) {
                (true, true) => TAU,
                (false, true) => -TAU,
                (true, false) if turned <= 0.0 => turned + TAU,
                (false, false) if turned >= 0.0 => turned - TAU,
                _ => turned,
            }
        };
        steps.push(Step::Arc(ArcStep { from: self.at, to, axes, center, radius, sweep }));
        self.at = to;
        Ok(())
    }

    fn define(&mut self, rest: &[&str]) -> Result<(), String> {
        if self.pecking.take(rest, self.mm) {
            self.cycle = None;
            return Ok(());
        }
        let Some(which) = rest.first().copied().and_then(number) else {
            return Err("a cycle without a number".into());
        };
        let q = |n: u32| {
            let name = format!("Q{n}=");
            rest.iter().find_map(|w| number(w.strip_prefix(name.as_str())?))
        };
        let need = |n: u32| q(n).ok_or_else(|| format!("the cycle {which} without Q{n}"));
        #[expect(clippy::cast_possible_truncation, reason = "a number of a cycle")]
        let code = which as i64;
        if !(200..=300).contains(&code) {
            return Ok(());
        }
        let mm = self.mm;
        let (clear, depth, surface) = (need(200)? * mm, need(201)? * mm, need(203)? * mm);
        let second = q(204).unwrap_or(0.0) * mm;
        let bottom = surface + depth;
        let clearance = surface + clear;
        let end = clearance.max(surface + second);
        let feed = q(206).unwrap_or(0.0) * mm;
        let kind = match code {
            200 | 205 => {
                let step = need(202)? * mm;
                if step <= 0.0 {
                    return Err("a cycle without a peck".into());
                }
                // The first peck counts from the surface.
                Kind::Pecks { first: step + clear, step, out: code == 200 }
            }
            201 | 202 | 207 | 209 => Kind::FeedOut,
            _ => return Err(format!("the cycle {code}")),
        };
        if clear < 0.0 || bottom > clearance {
            return Err("a cycle whose planes are out of order".into());
        }
        self.cycle = Some(Cycle { kind, clear: clearance, bottom, end, feed });
        Ok(())
    }

    fn drill(&mut self, cycle: &Cycle, steps: &mut Vec<Step>) -> Result<(), String> {
        let now = self.at[2].ok_or("a cycle from a height that is not known")?;
        if now < cycle.clear - 1e-6 {
            return Err("a cycle called below its clearance".into());
        }
        let mut z = |to: f64, rapid: bool| {
            let from = self.at;
            self.at[2] = Some(to);
            if from != self.at {
                let feed = (!rapid).then_some(cycle.feed);
                steps.push(Step::Line { from, to: self.at, rapid, feed });
            }
        };
        z(cycle.clear, true);
        match cycle.kind {
            Kind::Drill => z(cycle.bottom, false),
            Kind::FeedOut => {
                z(cycle.bottom, false);
                z(cycle.clear, false);
            }
            Kind::Pecks { first, step, out } => {
                let mut depth = cycle.clear;
                for n in 0.. {
                    if n > MOST_PECKS {
                        return Err("too many pecks".into());
                    }
                    if n > 0 {
                        if out {
                            z(cycle.clear, true);
                        }
                        z((depth + 0.2).min(cycle.clear), true);
                    }
                    depth -= if n == 0 { first } else { step };
                    if depth <= cycle.bottom + NOTHING_LEFT {
                        depth = cycle.bottom;
                    }
                    z(depth, false);
                    if depth <= cycle.bottom {
                        break;
                    }
                }
            }
        }
        z(cycle.end, true);
        Ok(())
    }
}

/// A number of a block: digits with sign and point, so no `nan` and no exponent.
fn number(text: &str) -> Option<f64> {
    let plain = text.bytes().all(|b| matches!(b, b'0'..=b'9' | b'+' | b'-' | b'.'));
    text.parse().ok().filter(|_| plain)
}

/// A letter and its number: `X+12.5`.
fn word(w: &str) -> Result<(u8, f64), String> {
    let letter = *w.as_bytes().first().ok_or("an empty word")?;
    let value = w.get(1..).and_then(number);
    value.map(|v| (letter, v)).ok_or_else(|| format!("the word {w} is not known"))
}
