//! Positions of the axes for a position of the tool, and what keeps the tool from it.

use aptc_diagnostics::{Origin, codes};
use aptc_geometry::Vec3;

use crate::emit::Joints;
use crate::kinematics::{Chain, NoSolution, UPRIGHT};
use crate::machine::Carries;
use crate::post::{Post, trimmed};

/// Position of tool and axes together.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    pub(crate) te: Vec3,
    pub(crate) ta: Vec3,
    /// Angles as they are written, degrees, not wrapped.
    pub(crate) angles: [f64; 2],
    /// Linear axes.
    pub(crate) xyz: Vec3,
}

impl Pose {
    pub(crate) fn joints(&self) -> Joints {
        [self.xyz.x, self.xyz.y, self.xyz.z, self.angles[0], self.angles[1]]
    }
}

impl Post {
    /// Positions of the axes for a position of the tool; `None` after a refusal.
    #[inline]
    pub(crate) fn joints(&mut self, te: Vec3, ta: Vec3, origin: &Origin) -> Option<Joints> {
        let joints = if self.machine.rotary.is_empty() {
            if ta.x.abs() > UPRIGHT || ta.y.abs() > UPRIGHT || ta.z < 0.0 {
                self.out_of_reach(ta, NoSolution::Direction, origin);
                return None;
            }
            [te.x, te.y, te.z, 0.0, 0.0]
        } else {
            let pose = self.pose(te, ta, self.st.angles, origin)?;
            pose.joints()
        };
        self.reach(&joints, origin);
        Some(joints)
    }

    /// Told once with how many positions have such an axis.
    fn out_of_reach(&mut self, ta: Vec3, why: NoSolution, origin: &Origin) {
        let axis = [ta.x, ta.y, ta.z].map(|c| trimmed(c, 6)).join(",");
        let name = &self.machine.name;
        let (what, message, help) = match (why, self.machine.rotary.len()) {
            (NoSolution::Direction, 0) => (
                "upright alone",
                format!("tool axis {axis} on {name}, whose tool axis is 0,0,1"),
                "choose a machine with rotary axes: `aptc machines` lists them",
            ),
            (NoSolution::Direction, _) => (
                "no angles",
                format!("tool axis {axis}: no angles of {name} give it"),
                "choose a machine with other rotary axes: `aptc machines` lists them",
            ),
            (NoSolution::Limits, _) => (
                "limits",
                format!("tool axis {axis}: the angles are beyond the limits of {name}"),
                "lay the part otherwise, or choose a machine that turns farther",
            ),
        };
        self.error_counted(codes::AXIS_OUT_OF_REACH, what, origin, message, help);
    }

    /// The chain with the present tool; `None` after a refusal.
    fn chain(&mut self, origin: &Origin) -> Option<&Chain> {
        if self.st.chain.is_none() {
            let m = &self.machine;
            let needs =
                !m.multiaxis.tool_center && m.rotary.iter().any(|r| r.carries == Carries::Tool);
            let unit = self.st.out_mm();
            let said = self.st.tool_length.map(|l| l * self.st.scale);
            let length = said.or(m.multiaxis.tool_length.map(|l| l / unit));
            if needs && length.is_none() {
                let message = format!(
                    "{} turns the tool and needs its length, which is not known",
                    self.machine.name
                );
                let help =
                    "write LOADTL/n,LENGTH,l, or give `multiaxis.tool_length` in the machine file";
                self.error(codes::TOOL_LENGTH, origin, message, help);
                return None;
            }
            if let (true, None, None, Some(length)) = (needs, said, self.st.tool, length) {
                let message = format!(
                    "no tool is loaded whose length is known: {} of {} is taken",
                    trimmed(length, 4),
                    self.machine.name
                );
                let help = "write LOADTL/n,LENGTH,l before the first motion";
                self.warn(codes::TOOL_LENGTH, origin, message, help);
            }
            let mut chain = Chain::new(&self.machine, unit, length.unwrap_or(0.0));
            chain.plane = self.st.plane;
            if self.st.across == Some(true) {
                chain.stand_across();
            }
            self.st.chain = Some(chain);
        }
        self.st.chain.as_ref()
    }

    pub(crate) fn pose(
        &mut self,
        te: Vec3,
        ta: Vec3,
        from: [f64; 2],
        origin: &Origin,
    ) -> Option<Pose> {
        let norm = ta.norm();
        if !(norm > 0.5 && norm < 2.0) {
            self.out_of_reach(ta, NoSolution::Direction, origin);
            return None;
        }
        let ta = ta / norm;
        match self.chain(origin)?.angles(te, ta, from) {
            Ok(angles) => {
                let angles = self.blocks.round_angles(angles);
                if self.lacks_length(angles, origin) {
                    return None;
                }
                let mut pose = self.placed(te, ta, angles);
                if self.machine.is_milling() {
                    if !self.reaches_side(te, pose.xyz.y, origin) {
                        return None;
                    }
                    pose.xyz.y = 0.0;
                }
                Some(pose)
            }
            Err(why) => {
                self.out_of_reach(ta, why, origin);
                None
            }
        }
    }

    /// Beside turned axes the control keeps the tool end on its path by the length of the tool. Where that comes by a
    /// number and no tool is loaded, no code can be written; where it comes with the tool, the code is right for the one
    /// that happens to be in the spindle.
    fn lacks_length(&mut self, angles: [f64; 2], origin: &Origin) -> bool {
        let m = &self.machine.multiaxis;
        if self.st.offset.is_some() || !m.tool_center || self.st.plane.is_some() {
            return false;
        }
        let turned = angles.iter().any(|a| (a / 360.0 - (a / 360.0).round()).abs() > 1e-12);
        if !turned {
            return false;
        }
        let by_number = m.tool_center_on.contains("{offset}");
        let name = &self.machine.name;
        let help = "write LOADTL/n before the first motion";
        let message =
            format!("{name} turns axes and needs the length of the tool, and no tool is loaded");
        if by_number {
            self.error_counted(codes::TOOL_LENGTH, "no length", origin, message, help);
        } else if !std::mem::replace(&mut self.st.length_told, true) {
            self.warn(codes::TOOL_LENGTH, origin, message, help);
        }
        by_number
    }

    pub(crate) fn placed(&self, te: Vec3, ta: Vec3, angles: [f64; 2]) -> Pose {
        let xyz = self.st.chain.as_ref().map_or(te, |c| c.linear(te, angles));
        Pose { te, ta, angles, xyz }
    }

    /// The place of the linear axes for a tool end while the rotary axes rest.
    pub(crate) fn at_rest(&self, te: Vec3) -> Vec3 {
        self.st.chain.as_ref().map_or(te, |c| c.linear(te, self.st.angles))
    }

    /// Does the tool stand along its axis of the machine, as the rotary axes are now?
    pub(crate) fn along_tool(&self, ta: Vec3) -> bool {
        self.stands_along(ta, self.st.angles)
    }

    /// The same with the rotary axes at these angles.
    pub(crate) fn stands_along(&self, ta: Vec3, angles: [f64; 2]) -> bool {
        let seen = self.st.chain.as_ref().map_or(ta, |c| c.turned(angles) * ta);
        let mut axis = Vec3::zeros();
        axis[self.tool_along()] = 1.0;
        (seen - axis).norm() < 1e-6
    }
}
