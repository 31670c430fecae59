//! Drilling cycles: what CYCLE means, as a cycle of the control or as single motions.

mod cycle;
mod expanded;
mod native;

use aptc_cldata::Position;
use aptc_diagnostics::{Code, Origin, codes};
use aptc_geometry::Vec3;

use crate::emit::FeedWord;
use crate::pecks::is_pecked;
use crate::post::Post;
pub(crate) use cycle::{DrillCycle, Heights};

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
