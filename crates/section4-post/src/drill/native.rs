//! A hole by the control's own cycle: in one block, by modal words, or by lines that define it.

use aptc_diagnostics::Origin;

use super::{DrillCycle, Hole};
use crate::emit::{FeedMode, FeedWord, NativeCycle};
use crate::machine::CycleWord;
use crate::number::Number;
use crate::post::Post;

impl Post {
    /// The control's own cycle for this, if it has one.
    pub(super) fn native(
        &self,
        cycle: &DrillCycle,
        hole: &Hole,
        dwell: Option<f64>,
        feed: FeedWord,
    ) -> Option<NativeCycle> {
        let m = &self.machine;
        let mut kind = cycle.kind.as_str();
        if kind == "DRILL" && dwell.is_some_and(|t| t > 0.0) {
            kind = "FACE";
        }
        if kind == "TAP" && self.st.spindle.ccw {
            kind = "TAPLEFT";
        }
        let entry = m.cycles.get(kind)?;
        // Cycles that lines define do nothing at depth 0.
        let shallow = cycle.depth * self.st.scale < self.blocks.number(b'Z').resolution();
        if shallow && !entry.lines.is_empty() {
            return None;
        }
        let even = match (cycle.first_step, cycle.step) {
            (Some(a), Some(b)) => (a - b).abs() < 1e-9,
            _ => true,
        };
        if !even && !entry.lines.iter().any(|l| l.contains("{first}")) {
            return None;
        }
        let wants = match entry.spindle.as_str() {
            "CLW" => Some(false),
            "CCLW" => Some(true),
            _ => None,
        };
        if wants.is_some_and(|ccw| !self.st.spindle.on || self.st.spindle.ccw != ccw) {
            return None;
        }
        let mut words = Vec::new();
        for word in &entry.words {
            match word {
                CycleWord::Step => {
                    let letter = m.cycle.step as u8;
                    let way = hole.clearance - hole.bottom;
                    words.push((letter, self.told_pecks(cycle, way, letter)?.step));
                }
                CycleWord::Dwell | CycleWord::MaybeDwell => {
                    let seconds = dwell.unwrap_or(0.0);
                    if *word == CycleWord::Dwell || seconds > 0.0 {
                        let value = if m.cycle.dwell_ms { seconds * 1000.0 } else { seconds };
                        words.push((m.cycle.dwell as u8, value));
                    }
                }
            }
        }
        let takes_dwell =
            entry.words.iter().any(|w| matches!(w, CycleWord::Dwell | CycleWord::MaybeDwell));
        if dwell.is_some_and(|t| t > 0.0) && !takes_dwell {
            return None;
        }
        let (code, retract, lines) = (entry.code.clone(), String::new(), entry.lines.clone());
        let before = self.lines_before(&entry.before, feed);
        Some(NativeCycle { code, retract, words, feed, lines, before })
    }

    pub(super) fn drill_native(
        &mut self,
        mut native: NativeCycle,
        cycle: &DrillCycle,
        dwell: Option<f64>,
        hole: &Hole,
        origin: &Origin,
    ) {
        if !native.lines.is_empty() {
            self.drill_called(native, cycle, dwell, hole, origin);
            return;
        }
        if let Some(letter) = self.lead_of(&native.code) {
            self.tap_once(&native, letter, hole, origin);
            return;
        }
        let high = hole.retract > hole.clearance + self.blocks.number(b'Z').resolution() / 2.0;
        let words = &self.machine.cycle;
        native.retract = if high { words.to_initial.clone() } else { words.to_clearance.clone() };
        self.reach_level(hole, if high { hole.retract } else { hole.clearance }, high, origin);
        self.way_to_hole(hole, origin);
        let at = self.at_rest(hole.at);
        let (bottom, clearance) = (at.z + hole.bottom, at.z + hole.clearance);
        let heights = [bottom, clearance, at.z + hole.retract];
        let done = self.blocks.hole(&native, [at.x, at.y], heights);
        self.check(done, origin);
        // The lines before it have stopped the spindle, whatever comes after the last hole.
        self.st.spindle_again |= !native.before.is_empty();
    }

    /// The address of the pitch when the code taps a hole in one block.
    fn lead_of(&self, code: &str) -> Option<u8> {
        self.machine.cycles.values().find(|c| c.code == code)?.lead.map(|l| l as u8)
    }

    fn lines_before(&self, lines: &[String], feed: FeedWord) -> Vec<String> {
        if lines.is_empty() {
            return Vec::new();
        }
        let text = |letter: u8, value: f64| {
            let n = self.blocks.number(letter);
            n.text(n.round(value).unwrap_or(0))
        };
        let (speed, feed_text) = (text(b'S', self.st.spindle.speed), text(b'F', feed.value));
        let pitch = crate::post::trimmed(self.pitch(feed), 4);
        let vars = [("speed", speed.as_str()), ("pitch", &pitch), ("feed", &feed_text)];
        lines.iter().filter_map(|l| crate::emit::render(l, &vars)).collect()
    }

    /// The way of the tool in one turn of the spindle, output units.
    fn pitch(&self, feed: FeedWord) -> f64 {
        let speed = self.st.spindle.speed;
        match feed.mode {
            FeedMode::PerRevolution => feed.value,
            _ if speed > 0.0 => feed.value / speed,
            _ => 0.0,
        }
    }

    /// A hole that one block of the control taps.
    fn tap_once(&mut self, native: &NativeCycle, letter: u8, hole: &Hole, origin: &Origin) {
        self.reach_level(hole, hole.clearance.max(hole.retract), false, origin);
        let here = self.st.pos.map_or(hole.retract, |p| hole.height(p));
        self.go_to(hole.point(here), hole.ta, true, origin);
        self.go_to(hole.point(hole.clearance), hole.ta, true, origin);
        let at = self.at_rest(hole.at);
        let pitch = (letter, self.pitch(native.feed));
        let done = self.blocks.tap(&native.code, at.z + hole.bottom, pitch);
        self.check(done, origin);
        self.go_to(hole.point(hole.retract), hole.ta, true, origin);
    }

    /// A hole of a cycle that lines define and a position calls.
    fn drill_called(
        &mut self,
        mut native: NativeCycle,
        cycle: &DrillCycle,
        dwell: Option<f64>,
        hole: &Hole,
        origin: &Origin,
    ) {
        self.reach_level(hole, hole.retract, false, origin);
        self.way_to_hole(hole, origin);
        let at = self.at_rest(hole.at);
        let written = |n: Number, value: f64| n.round(value).map_or(String::new(), |q| n.text(q));
        // Heights above the surface and those of the machine must come out the same when both are rounded, and each hole
        // as deep as the others, or a control would make one more peck of the last step.
        let number = self.blocks.number(b'Z');
        let z = |value: f64| written(number, value);
        let exact = |value: f64| number.round(value).map_or(value, |q| number.value(q));
        let surface = exact(at.z + hole.bottom) - exact(hole.bottom);
        let above = |height: f64| exact(at.z + height) - surface;
        // Their pecks count from the surface.
        let pecks = self.told_pecks(cycle, -hole.bottom, b'Z');
        let (step, first) = pecks.map_or((-hole.bottom, -hole.bottom), |p| (p.step, p.first));
        let (speed, pitch) = (self.st.spindle.speed, self.pitch(native.feed));
        let values = [
            ("surface", z(surface)),
            ("bottom", z(at.z + hole.bottom)),
            ("clearance", z(at.z + hole.clearance)),
            ("retract", z(at.z + hole.retract)),
            ("depth", z(above(hole.bottom))),
            ("clear", z(above(hole.clearance))),
            ("back", z(above(hole.retract))),
            ("step", z(step)),
            ("first", z(first)),
            ("dwell", crate::post::trimmed(dwell.unwrap_or(0.0), 3)),
            ("feed", written(self.blocks.number(b'F'), native.feed.value)),
            ("pitch", crate::post::trimmed(pitch, 4)),
            ("speed", crate::post::trimmed(speed, 1)),
        ];
        let vars: Vec<(&str, &str)> = values.iter().map(|(n, v)| (*n, v.as_str())).collect();
        native.lines = native.lines.iter().filter_map(|l| crate::emit::render(l, &vars)).collect();
        let heights = [hole.bottom, hole.clearance, hole.retract].map(|h| at.z + h);
        let done = self.blocks.hole(&native, [at.x, at.y], heights);
        self.check(done, origin);
        if self.machine.cycle.off.is_empty() {
            self.st.pos = Some(hole.point(hole.retract));
        }
    }

    /// The control takes the tool across at the height where it is, then down to the clearance.
    fn way_to_hole(&mut self, hole: &Hole, origin: &Origin) {
        if let Some(pos) = self.st.pos {
            let way = [pos, hole.point(hole.height(pos)), hole.point(hole.clearance)];
            self.must_be_free(&way, hole.ta, origin);
        }
    }
}
