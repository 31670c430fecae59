//! MODE/MILL on a lathe: the spindle places the part, the tools turn.
//!
//! The tools stand along the spindle, for the face, or across it, for the side of the part; which of both a tool is
//! follows from its first motion and holds until the next tool change.

use std::sync::Arc;

use aptc_cldata::Motion;
use aptc_diagnostics::{Origin, codes};
use aptc_geometry::{Plane, Vec3};

use crate::post::{Post, trimmed};
use crate::state::SpindleState;

/// How far a rapid motion in which C turns may leave its line on a lathe, millimetres: far less than the clearance
/// that is kept, and a few blocks in place of some fifty.
pub(crate) const RAPID_BAND_MM: f64 = 0.5;

/// Is the place on that side of a clearance plane across the spindle to which its normal points? There C may turn as it
/// likes: the tool keeps its height above the plane.
pub(crate) fn is_clear(plane: &Plane, te: Vec3, slack: f64) -> bool {
    let across = plane.n.xy().norm() <= 1e-9 * plane.n.norm() && plane.n.z > 0.0;
    across && plane.n.dot(&te) >= plane.d - slack * plane.n.norm()
}

impl Post {
    /// May C turn in one block between these places, wherever that leads the tool around the spindle? Above the
    /// clearance plane, and where it is known above the stock. Elsewhere what stands beside the line might be hit.
    pub(crate) fn free_to_turn(&self, from: Vec3, to: Vec3) -> bool {
        let Some(plane) = self.st.clearance().filter(|_| self.machine.is_milling()) else {
            return false;
        };
        let slack = self.blocks.number(b'Z').resolution();
        let top = self.summary.stock.map(|[_, max]| max[2]);
        [from, to]
            .iter()
            .all(|te| is_clear(&plane, *te, slack) && top.is_none_or(|top| te.z >= top - slack))
    }

    /// MODE/MILL and MODE/TURN on a lathe with such tools.
    pub(crate) fn set_milling(&mut self, on: bool, origin: &Origin) {
        if self.machine.is_milling() == on {
            return;
        }
        let machine = if on {
            let Some(machine) = self.lathe.while_milling() else { return };
            Arc::new(machine)
        } else {
            Arc::clone(&self.lathe)
        };
        self.start(origin);
        self.annotate(origin);
        self.leave_cycle();
        if !self.st.away {
            self.retract_to_home(origin);
        }
        if self.st.spindle.on && !self.st.spindle_again {
            let off = self.machine.spindle.off.clone();
            self.blocks.line(&off);
        }
        let vars = self.common_vars();
        let lines = machine.milling.as_ref().map(|m| if on { &m.on } else { &m.off });
        for line in lines.into_iter().flatten() {
            self.blocks.template(std::slice::from_ref(line), &vars.list());
        }
        self.blocks.change_machine(Arc::clone(&machine));
        self.blocks.forget_after_start();
        self.machine = machine;
        let st = &mut self.st;
        (st.spindle, st.spindle_again, st.feed_word) = (SpindleState::default(), false, None);
        (st.spindle_perhaps, st.spindle_oriented) = (false, false);
        st.held.retain(|h| !h.spindle);
        (st.chain, st.placed, st.angles) = (None, None, [0.0; 2]);
        (st.thread, st.across, st.ready_said) = (None, None, false);
        // The next motion comes from the retracted place.
        st.pos = None;
    }

    /// Refuses a motion whose tool axis the tool cannot have that is loaded.
    pub(crate) fn tool_stands(&mut self, m: &Motion, origin: &Origin) -> bool {
        for p in &m.points {
            let across = if p.ta.z > 1.0 - 1e-9 {
                false
            } else if p.ta.z.abs() < 1e-6 {
                true
            } else {
                let [x, y, z] = [p.ta.x, p.ta.y, p.ta.z].map(|c| trimmed(c, 6));
                let message = format!(
                    "tool axis {x},{y},{z} in the frame of {}, whose tools stand along the spindle or across it",
                    self.machine.name
                );
                let help = "choose a machine with another rotary axis: `aptc machines` lists them";
                let code = codes::AXIS_OUT_OF_REACH;
                self.error_counted(code, "aslant", origin, message, help);
                return false;
            };
            match self.st.across {
                None => {
                    self.st.across = Some(across);
                    self.st.chain = None;
                }
                Some(stands) if stands != across => {
                    let tool = self.st.tool.map_or("the tool".into(), |n| format!("tool {n}"));
                    let how = |a: bool| if a { "across the spindle" } else { "along the spindle" };
                    let message = format!(
                        "{tool} stands {}, and this motion wants it {}",
                        how(stands),
                        how(across)
                    );
                    let help = "load another tool before it: TURRET/n or LOADTL/n";
                    let code = codes::AXIS_OUT_OF_REACH;
                    self.error_counted(code, "another tool", origin, message, help);
                    return false;
                }
                Some(_) => {}
            }
        }
        true
    }

    /// The axis of the machine along which the tool stands: 2 for Z, 0 for X.
    pub(crate) fn tool_along(&self) -> usize {
        if self.machine.is_milling() && self.st.across == Some(true) { 0 } else { 2 }
    }

    /// Refuses a place beside the spindle's axis, to which a lathe without Y has no way. `y` in output units.
    pub(crate) fn reaches_side(&mut self, te: Vec3, y: f64, origin: &Origin) -> bool {
        if (y * self.st.out_mm()).abs() <= crate::turning::OFF_PLANE_MM {
            return true;
        }
        if !std::mem::replace(&mut self.off_plane_told, true) {
            let place = [te.x, te.y, te.z].map(|c| trimmed(c, 4)).join(",");
            let message = format!(
                "the tool at {place} does not point to the spindle's axis, by {}: {} has no Y axis",
                trimmed(y, 4),
                self.machine.name
            );
            let help =
                "let the tool axis go through the axis of the spindle, or choose another machine";
            self.error(codes::OFF_TURNING_PLANE, origin, message, help);
        }
        false
    }
}
