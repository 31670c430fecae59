//! Where the tool stands at a position of the axes.

use aptc_geometry::Vec3;

use super::{Checker, Expect, Hole};
use crate::emit::Joints;
use crate::kinematics::Chain;
use crate::readback::{Frame, Place};

/// The chain of the machine, and the last two positions of its axes that were asked for: each block begins where the
/// one before it ended, and is asked for both several times.
pub(super) struct Posed {
    pub(super) chain: Chain,
    known: [Option<(Joints, (Vec3, Vec3))>; 2],
}

impl Posed {
    fn pose(&mut self, joints: &Joints) -> (Vec3, Vec3) {
        let same = |at: &&(Joints, _)| at.0.map(f64::to_bits) == joints.map(f64::to_bits);
        if let Some((_, pose)) = self.known.iter().flatten().find(same) {
            return *pose;
        }
        let pose = self.chain.forward(joints);
        self.known = [Some((*joints, pose)), self.known[0]];
        pose
    }
}

impl Checker {
    pub(super) fn pose(&mut self, place: &Place) -> Option<(Vec3, Vec3)> {
        let joints =
            [place[0]?, place[1]?, place[2]?, place[3].unwrap_or(0.0), place[4].unwrap_or(0.0)];
        if self.machine.rotary.is_empty() {
            return Some((Vec3::new(joints[0], joints[1], joints[2]), Vec3::z()));
        }
        if !self.means_the_part(place) {
            return None;
        }
        Some(self.posed().pose(&joints))
    }

    /// Are the numbers of the linear axes positions of the part? Beside turned axes only a tilted plane or
    /// tool-centre control makes them so, where the control has these.
    fn means_the_part(&self, place: &Place) -> bool {
        let turned = place[3..].iter().flatten().any(|a| (a / 360.0).fract().abs() > 1e-9);
        !self.machine.multiaxis.tool_center || self.centered || self.frame.is_some() || !turned
    }

    pub(super) fn posed(&mut self) -> &mut Posed {
        if self.machine.is_milling()
            && let Some(
                Expect::Point { ta, .. } | Expect::Hole(Hole { ta, .. }) | Expect::From { ta, .. },
            ) = self.queue.front()
        {
            let across = ta.z.abs() < 0.5;
            if across != self.across {
                (self.across, self.posed) = (across, None);
            }
        }
        let across = self.across;
        let length = self.read_length.or(self.machine.multiaxis.tool_length).unwrap_or(0.0);
        let (machine, frame) = (&self.machine, self.frame.as_ref());
        self.posed.get_or_insert_with(|| {
            let mut chain = Chain::new(machine, 1.0, length);
            if across && machine.is_milling() {
                chain.stand_across();
            }
            chain.plane = frame.map(|f| match f {
                Frame::Plane(q) => q.transpose(),
                Frame::Table(angles) => chain.table(*angles),
            });
            Posed { chain, known: [None; 2] }
        })
    }
}
