//! From the retracted place to the part.
//!
//! A tool that stands along Z goes across, then down. Where the rotary axes are turned and the control keeps the tool
//! end on its path, X and Y of the part say nothing before that control is on, and Z alone is aslant of the tool
//! after it. So the rotary axes turn where the tool is retracted, the tool goes across in the tilted plane, and with the
//! plane off and the control on it comes to X, Y and Z of the part at once: with the rotary axes at rest and the place
//! across reached, nothing but the axis along the tool moves. A head that leans without such control comes to a place
//! high above on the tool's line first.

use aptc_diagnostics::Origin;
use aptc_geometry::Vec3;

use crate::emit::{Joints, MotionCode};
use crate::machine::{Carries, MachineKind};
use crate::motion::ALL;
use crate::post::Post;

const ROTARY: [bool; 5] = [false, false, false, true, true];

/// How far above its place a tool comes to the part where there is no tilted plane and the machine file says no more,
/// millimetres.
const ABOVE: f64 = 50.0;

/// How far above the end of a cut a tool that goes on with it comes at rapid where no clearance plane is given,
/// millimetres.
const ABOVE_CUT: f64 = 2.0;

impl Post {
    /// From the retracted position to where the CL data thinks that the tool is, the last part of the way down along the
    /// tool; and what a tool change has stopped runs again.
    pub(crate) fn approach(&mut self, te: Vec3, ta: Vec3, rapid: bool, origin: &Origin) {
        self.run_again();
        if !std::mem::take(&mut self.st.away) {
            return;
        }
        // A rapid motion may go to its own end; a cut must begin where the last motion ended.
        let (over, axis, down) = match self.st.pos {
            Some(p) if !rapid => (p, self.st.ta, true),
            _ => (te, ta, rapid),
        };
        let Some(joints) = self.joints(over, axis, origin) else { return };
        if self.turned_for_control(&joints) {
            self.approach_turned(over, axis, (te, rapid), &joints, down, origin);
        } else {
            self.enter_plane();
            let (tool_axis, but_tool_axis) = self.tool_axis_and_others();
            let angles = [joints[3], joints[4]];
            let mask = if self.tool_follows(axis, angles) {
                self.rapid_block(&joints, but_tool_axis, origin);
                tool_axis
            } else {
                // Down in Z alone a head that leans would go across its flank: so down in Z beside the tool's own
                // line, high above, and from there along it.
                let above = self.placed_above(over, axis, angles);
                self.reach(&above, origin);
                self.rapid_block(&above, but_tool_axis, origin);
                self.rapid_block(&above, tool_axis, origin);
                ALL
            };
            self.tool_center_on();
            if down {
                let way = self.down_to(over);
                self.must_be_free(&way, axis, origin);
                self.come_down(over, axis, te, &joints, (mask, rapid), origin);
            }
        }
        if down {
            self.st.pos = Some(over);
            self.st.ta = axis;
        }
        self.st.angles = [joints[3], joints[4]];
        self.st.placed = None;
    }

    /// Does the axis of the machine that comes down go along the tool? It does not with heads that lean where positions
    /// are those of the axes; under a control that keeps the tool end on its path all axes come down together.
    fn tool_follows(&self, axis: Vec3, angles: [f64; 2]) -> bool {
        let m = &self.machine;
        m.rotary.is_empty() || m.multiaxis.tool_center || self.stands_along(axis, angles)
    }

    /// Are positions those of the tool end beside axes that are not at zero?
    fn turned_for_control(&self, joints: &Joints) -> bool {
        let turned = joints[3..].iter().any(|a| (a / 360.0 - (a / 360.0).round()).abs() > 1e-12);
        let m = &self.machine;
        m.multiaxis.tool_center && !m.rotary.is_empty() && self.st.plane.is_none() && turned
    }

    /// The approach beside turned axes.
    fn approach_turned(
        &mut self,
        over: Vec3,
        axis: Vec3,
        (next, rapid): (Vec3, bool),
        joints: &Joints,
        down: bool,
        origin: &Origin,
    ) {
        self.rapid_block(joints, ROTARY, origin);
        let m = std::sync::Arc::clone(&self.machine);
        // A head that leans would not stay at its height in the plane.
        let tables = m.rotary.iter().all(|r| r.carries == Carries::Part);
        let table = self.st.chain.as_ref().map(|c| c.table([joints[3], joints[4]]));
        let tilt = table.filter(|_| tables && !m.multiaxis.plane_on.is_empty());
        if let Some(tilt) = tilt {
            self.st.plane = Some(tilt);
            self.enter_plane();
            let across = tilt * over;
            let (_, but_tool_axis) = self.tool_axis_and_others();
            let place = [across.x, across.y, across.z, joints[3], joints[4]];
            self.rapid_block(&place, but_tool_axis, origin);
            self.leave_plane();
            self.st.plane = None;
        }
        self.tool_center_on();
        if tilt.is_none() {
            let above = self.placed_above(over, axis, [joints[3], joints[4]]);
            self.reach(&above, origin);
            self.rapid_block(&above, ALL, origin);
        }
        if down {
            let way = self.down_to(over);
            self.must_be_free(&way, axis, origin);
            self.come_down(over, axis, next, joints, (ALL, rapid), origin);
        }
    }

    /// Down to a place. Where a cut ended, and the next goes on from there, the tool must not meet the material at rapid:
    /// the last part of the way, from the clearance plane or from a little above, is gone at the feed of the cut.
    fn come_down(
        &mut self,
        over: Vec3,
        axis: Vec3,
        next: Vec3,
        joints: &Joints,
        (mask, rapid): ([bool; 5], bool),
        origin: &Origin,
    ) {
        let mills = self.machine.kind == MachineKind::Mill || self.machine.is_milling();
        // A cut straight up ends in what lies above; it needs no way down at feed.
        let cuts = self.st.cut_last && !rapid && mills && !goes_up(next - over, axis, 1e-6);
        let plane = self.height_of_clearance(over, axis);
        let height = plane.filter(|h| *h > 0.0).unwrap_or(ABOVE_CUT / self.st.out_mm());
        let above = if cuts { self.joints(over + axis * height, axis, origin) } else { None };
        let Some(above) = above else {
            self.rapid_block(joints, mask, origin);
            return;
        };
        self.rapid_block(&above, mask, origin);
        let inverse = std::mem::replace(&mut self.st.inverse, false);
        if let Some(feed) = self.feed_for(over, origin) {
            let done = self.blocks.straight(MotionCode::Line, joints, ALL, Some(feed));
            self.check(done, origin);
            self.count_cut(over, height, feed);
        }
        self.st.inverse = inverse;
    }

    /// Above a place along the tool, and above the clearance plane.
    fn placed_above(&self, over: Vec3, axis: Vec3, angles: [f64; 2]) -> Joints {
        let retract = self.machine.multiaxis.rewind_retract;
        let above = if retract > 0.0 { retract } else { ABOVE } / self.st.out_mm();
        let plane = self.height_of_clearance(over, axis);
        let te = over + axis * plane.map_or(above, |h| h.max(above));
        let xyz = self.st.chain.as_ref().map_or(te, |c| c.linear(te, angles));
        [xyz.x, xyz.y, xyz.z, angles[0], angles[1]]
    }

    /// How far above a place the tool meets the clearance plane, where that does not lie steep to it.
    pub(crate) fn height_of_clearance(&self, over: Vec3, axis: Vec3) -> Option<f64> {
        let p = self.st.clearance()?;
        let slope = p.n.dot(&axis);
        (slope > 0.1).then(|| (p.d - p.n.dot(&over)) / slope)
    }

    fn rapid_block(&mut self, joints: &Joints, mask: [bool; 5], origin: &Origin) {
        let done = self.blocks.straight(MotionCode::Rapid, joints, mask, None);
        self.check(done, origin);
    }
}

/// Does a way lead up along a unit vector, within the angle `lean`? None does not: what comes after it may be any cut.
pub(crate) fn goes_up(way: Vec3, axis: Vec3, lean: f64) -> bool {
    let up = way.dot(&axis);
    up > 0.0 && (way - axis * up).norm() <= lean * way.norm()
}
