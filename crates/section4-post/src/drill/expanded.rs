//! A hole as single motions, where the control has no cycle for it.

use aptc_diagnostics::{Origin, codes};
use aptc_geometry::Vec3;

use super::{DrillCycle, Hole};
use crate::emit::{FeedWord, MotionCode};
use crate::motion::ALL;
use crate::pecks::{MOST_PECKS, is_pecked};
use crate::post::Post;

impl Post {
    pub(super) fn drill_expanded(
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
}
