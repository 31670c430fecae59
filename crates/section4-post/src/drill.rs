//! Drilling cycles: what CYCLE means, as a cycle of the control or as single motions.

use aptc_cldata::Position;
use aptc_diagnostics::{Code, Origin, codes};
use aptc_geometry::Vec3;
use smol_str::SmolStr;

use crate::emit::{FeedMode, FeedWord, MotionCode, NativeCycle};
use crate::machine::CycleWord;
use crate::motion::ALL;
use crate::pecks::{MOST_PECKS, is_pecked};
use crate::post::Post;
use crate::state::Feedrate;

/// CYCLE with its values, lengths in CL units until used.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DrillCycle {
    /// DRILL, DEEP ...
    pub(crate) kind: SmolStr,
    /// From the programmed point down to the bottom, along the tool axis.
    pub(crate) depth: f64,
    /// The heights as they were said, from which `clear` and `retract` follow.
    pub(crate) said: Heights,
    /// From the point up to where the feed begins.
    pub(crate) clear: Option<f64>,
    /// From the point up to where the tool ends.
    pub(crate) retract: Option<f64>,
    /// RTRCTO,AUTO: back to the height from which the tool came.
    pub(crate) retract_auto: bool,
    pub(crate) feed: Option<Feedrate>,
    /// A feed that was said beside PITCH, which `feed` is then; both must be the same.
    pub(crate) beside_pitch: Option<Feedrate>,
    /// PITCH, CL units.
    pub(crate) pitch: Option<f64>,
    /// Pecks: the first and the others.
    pub(crate) first_step: Option<f64>,
    pub(crate) step: Option<f64>,
    /// Seconds.
    pub(crate) dwell: Option<f64>,
    /// Revolutions of the spindle instead.
    pub(crate) dwell_rev: Option<f64>,
    /// Has a fault of it been told, that no clearance is given or no step? It is one of the cycle, not of each hole.
    pub(crate) told: bool,
}

/// Heights of a cycle above the point, CL units, each under the word that gave it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Heights {
    pub(crate) clear: Option<f64>,
    pub(crate) rapto: Option<f64>,
    /// RTRCTO or RETURN; zero, which CATIA writes, asks for none beside the clearance.
    pub(crate) retract: Option<f64>,
}

impl Heights {
    /// The same, with what another statement said in its place.
    pub(crate) fn or(self, before: Self) -> Self {
        Self {
            clear: self.clear.or(before.clear),
            rapto: self.rapto.or(before.rapto),
            retract: self.retract.or(before.retract),
        }
    }

    /// Where CLEAR and RAPTO both stand, the feed begins at the nearer one and the tool ends at the farther one.
    pub(crate) fn clearance(&self) -> Option<f64> {
        match (self.clear, self.rapto) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        }
    }

    /// Where the tool ends, if it is said.
    pub(crate) fn end(&self) -> Option<f64> {
        let far = self.clear.zip(self.rapto).map(|(a, b)| a.max(b));
        match self.retract {
            Some(0.0) => self.clearance(),
            retract => retract.or(far),
        }
    }
}

/// A hole in output units: heights along the tool axis, from the programmed point.
struct Hole {
    at: Vec3,
    ta: Vec3,
    bottom: f64,
    clearance: f64,
    retract: f64,
}

impl Hole {
    fn point(&self, height: f64) -> Vec3 {
        self.at + self.ta * height
    }

    fn height(&self, p: Vec3) -> f64 {
        (p - self.at).dot(&self.ta)
    }
}

impl Post {
    /// One position of a cycle.
    pub(crate) fn hole(&mut self, p: &Position, origin: &Origin) {
        let Some(cycle) = self.st.cycle.clone() else { return };
        if self.threads(&cycle) {
            self.thread_cycle(&cycle, p, origin);
            return;
        }
        let at = self.st.point(p.te);
        if self.joints(at, p.ta, origin).is_none() {
            return;
        }
        if self.st.cutcom.is_some() {
            let message = "a cycle while radius compensation is on".to_string();
            self.error(codes::COMPENSATION, origin, message, "write CUTCOM/OFF before CYCLE");
            // Told: the next hole and the end of the program shall not say the same.
            self.st.cutcom = None;
            return;
        }
        // Of the few digits of CL data an axis is not quite of length 1: heights along it would grow from hole to hole.
        let ta = p.ta.normalize();
        let Some(hole) = self.heights(&cycle, at, ta, origin) else { return };
        if is_pecked(&cycle.kind) && self.pecks(&cycle).is_none() {
            let message = format!("CYCLE/{} has no step", cycle.kind);
            let help = "add STEP,s to the cycle, not less than the control can be told";
            self.fault_of_cycle(codes::CYCLE_INCOMPLETE, message, help, origin);
            return;
        }
        let feed = match cycle.feed {
            Some(feed) => self.feed_of(feed, origin),
            None => {
                let inverse = std::mem::replace(&mut self.st.inverse, false);
                let feed = self.feed_for(at, origin);
                self.st.inverse = inverse;
                feed
            }
        };
        let Some(feed) = feed else { return };
        if !self.st.ready_said {
            self.ready(origin);
        }
        let dwell = cycle.dwell.or_else(|| {
            let per_second = self.revolutions_here().unwrap_or(0.0) / 60.0;
            cycle.dwell_rev.filter(|_| per_second > 0.0).map(|r| r / per_second)
        });
        if !self.machine.rotary.is_empty() && (self.st.ta - hole.ta).norm() > 1e-9 {
            self.leave_cycle();
            self.turn_to_hole(&hole, origin);
        }
        for height in [hole.bottom, hole.retract] {
            if self.joints(hole.point(height), hole.ta, origin).is_none() {
                return;
            }
        }
        let along_z = self.tool_along() == 2 && self.along_tool(hole.ta);
        match self.native(&cycle, &hole, dwell, feed).filter(|_| along_z) {
            Some(native) => self.drill_native(native, &cycle, dwell, &hole, origin),
            None => self.drill_expanded(&cycle, &hole, dwell, feed, origin),
        }
        self.count_hole(&hole, feed, origin);
        self.st.pos = Some(hole.point(hole.retract));
        self.st.ta = ta;
    }

    /// To the retract height over a hole with another tool axis. What lies between is not known: the axes turn at
    /// the clearance plane, where both ways to it lead up, else with the tool retracted by the machine.
    fn turn_to_hole(&mut self, hole: &Hole, origin: &Origin) {
        let over = hole.point(hole.retract);
        if let (Some(pos), false) = (self.st.pos, self.st.away) {
            // The plane must not be so steep to the tool axis that the way to it goes far aside.
            let way_up = |p: Vec3, ta: Vec3| {
                let steep = self.st.clearance()?.n.dot(&ta) < 0.1;
                self.clearance_above(p, ta).filter(|h| *h >= 0.0 && !steep)
            };
            let here = self.st.ta;
            match (way_up(pos, here), way_up(over, hole.ta)) {
                (Some(up), Some(down)) => {
                    self.go_to(pos + here * up, here, true, origin);
                    self.go_to(over + hole.ta * down, hole.ta, true, origin);
                }
                _ => self.retract_to_home(origin),
            }
        }
        self.go_to(over, hole.ta, true, origin);
    }

    /// Is it a thread that a lathe cuts with a single point?
    fn threads(&self, cycle: &DrillCycle) -> bool {
        cycle.kind == "THREAD" && !self.machine.turning.thread.is_empty()
    }

    fn heights(&mut self, cycle: &DrillCycle, at: Vec3, ta: Vec3, origin: &Origin) -> Option<Hole> {
        let scale = self.st.scale;
        let clearance = match (cycle.clear, self.clearance_above(at, ta)) {
            (Some(c), _) => c * scale,
            (None, Some(h)) if h > 0.0 => h,
            (None, plane) => {
                let message = format!("CYCLE/{} has no clearance above the hole", cycle.kind);
                let help = "add CLEAR,c to the cycle, or write CLRSRF before it";
                if plane.is_some() {
                    self.error(codes::CYCLE_INCOMPLETE, origin, message, help);
                } else {
                    self.fault_of_cycle(codes::CYCLE_INCOMPLETE, message, help, origin);
                }
                return None;
            }
        };
        let bottom = -cycle.depth * scale;
        let mut retract = cycle.retract.map_or(clearance, |r| r * scale);
        if cycle.retract_auto
            && let Some(p) = self.st.pos
        {
            retract = retract.max((p - at).dot(&ta));
        }
        Some(Hole { at, ta, bottom, clearance, retract: retract.max(clearance) })
    }

    /// Tells what is wrong with the cycle at its first hole alone.
    fn fault_of_cycle(&mut self, code: Code, message: String, help: &str, origin: &Origin) {
        let told = self.st.cycle.as_mut().is_some_and(|c| std::mem::replace(&mut c.told, true));
        if !told {
            self.error(code, origin, message, help);
        }
    }

    /// Height of the clearance plane over a point along the tool axis, in output units.
    pub(crate) fn clearance_above(&self, at: Vec3, ta: Vec3) -> Option<f64> {
        let plane = self.st.clearance()?;
        let slope = plane.n.dot(&ta);
        if slope.abs() < 1e-6 {
            return None;
        }
        Some((plane.d - plane.n.dot(&at)) / slope)
    }

    /// The control's own cycle for this, if it has one.
    fn native(
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

    fn drill_native(
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
            let mut out = Vec::new();
            let n = self.blocks.number(letter);
            n.write(n.round(value).unwrap_or(0), &mut out);
            String::from_utf8(out).unwrap_or_default()
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
        let written = |b: &crate::emit::Blocks, letter: u8, value: f64| {
            let n = b.number(letter);
            let mut out = Vec::new();
            if let Some(q) = n.round(value) {
                n.write(q, &mut out);
            }
            String::from_utf8(out).unwrap_or_default()
        };
        let z = |value: f64| written(&self.blocks, b'Z', value);
        // Heights above the surface and those of the machine must come out the same when both are rounded, and each hole
        // as deep as the others, or a control would make one more peck of the last step.
        let number = self.blocks.number(b'Z');
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
            ("feed", written(&self.blocks, b'F', native.feed.value)),
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

    /// Brings the tool to where the cycle may begin: never across below `level`; exactly on it over the hole
    /// when the control takes the height as the one to come back to.
    fn reach_level(&mut self, hole: &Hole, level: f64, exactly: bool, origin: &Origin) {
        let over = hole.point(level);
        if self.st.away || self.st.pos.is_none() {
            self.approach(over, hole.ta, true, origin);
            if self.st.pos.is_none() {
                self.go_to(over, hole.ta, true, origin);
            }
            return;
        }
        if !self.blocks.in_cycle() {
            self.run_again();
        }
        let Some(pos) = self.st.pos else { return };
        let half = self.blocks.number(b'Z').resolution() / 2.0;
        let height = hole.height(pos);
        if height < level - half {
            self.blocks.end_cycle();
            self.go_to(pos + hole.ta * (level - height), hole.ta, true, origin);
        } else if exactly && height > level + half {
            self.blocks.end_cycle();
            self.go_to(hole.point(height), hole.ta, true, origin);
            self.go_to(over, hole.ta, true, origin);
        }
    }

    fn drill_expanded(
        &mut self,
        cycle: &DrillCycle,
        hole: &Hole,
        dwell: Option<f64>,
        feed: FeedWord,
        origin: &Origin,
    ) {
        let kind = cycle.kind.as_str();
        let pecks = match kind {
            "DRILL" | "FACE" | "CSINK" | "REAM" | "BORE" | "SPOT" => false,
            kind if is_pecked(kind) => true,
            _ => {
                let mut message = format!("{} has no cycle for CYCLE/{kind}", self.machine.name);
                if self.machine.cycles.contains_key(kind) {
                    let upright = self.along_tool(hole.ta);
                    message.push_str(match (upright, dwell.is_some()) {
                        (false, _) => " while the tool leans in the frame of the axes",
                        (true, true) => " with DWELL",
                        (true, false) => " with these values",
                    });
                }
                let help =
                    "write the motions of the hole instead, or choose a machine with the cycle";
                self.fault_of_cycle(codes::WORD_LACKING, message, help, origin);
                return;
            }
        };
        self.reach_level(hole, hole.clearance.max(hole.retract), false, origin);
        let ta = hole.ta;
        let z = |h: f64| hole.point(h);
        let here = self.st.pos.map_or(hole.retract, |p| hole.height(p));
        self.go_to(z(here), ta, true, origin);
        self.go_to(z(hole.clearance), ta, true, origin);
        let back = self.machine.cycle.peck_back / self.st.out_mm();
        if let Some(pecks) = self.pecks(cycle).filter(|_| pecks) {
            let Some(depths) = pecks.depths(hole.clearance, hole.bottom) else {
                let message = format!("more than {MOST_PECKS} pecks for one hole");
                self.fault_of_cycle(codes::CYCLE_INCOMPLETE, message, "give a larger STEP", origin);
                return;
            };
            let mut before = None;
            for depth in depths {
                if let Some(last) = before.replace(depth) {
                    let above = (last + back).min(hole.clearance);
                    if kind == "DEEP" {
                        self.go_to(z(hole.clearance), ta, true, origin);
                    }
                    self.go_to(z(above), ta, true, origin);
                }
                self.cut(z(depth), feed, origin);
            }
        } else {
            self.cut(z(hole.bottom), feed, origin);
        }
        if let Some(t) = dwell.filter(|t| *t > 0.0) {
            self.dwell(t);
        }
        if matches!(kind, "REAM" | "BORE") {
            self.cut(z(hole.clearance), feed, origin);
        }
        self.go_to(z(hole.retract), ta, true, origin);
    }

    fn cut(&mut self, te: Vec3, feed: FeedWord, origin: &Origin) {
        let Some(joints) = self.joints(te, self.st.ta, origin) else { return };
        let done = self.blocks.straight(MotionCode::Line, &joints, ALL, Some(feed));
        self.check(done, origin);
        self.takes_away(self.st.pos, te, self.st.ta, origin);
        self.st.pos = Some(te);
    }

    fn count_hole(&mut self, hole: &Hole, feed: FeedWord, origin: &Origin) {
        self.summary.holes += 1;
        let top = hole.point(hole.clearance);
        self.st.pos.get_or_insert(top);
        self.count_rapid(top);
        self.st.pos = Some(top);
        self.count_cut(hole.point(hole.bottom), hole.clearance - hole.bottom, feed);
        self.takes_away(Some(top), hole.point(hole.bottom), hole.ta, origin);
    }

    /// The cycle of the control ends; the tool stands where the last hole left it.
    pub(crate) fn leave_cycle(&mut self) {
        if self.blocks.in_cycle() {
            self.blocks.end_cycle();
        }
    }
}
