//! A track that comes back to its start.

use aptc_geometry::Vec3;

use super::keep::Pose;
use super::track::Node;

/// Share of a cut vector by which a track that has come back may pass beside its start, where it may have an edge.
const BESIDE: f64 = 0.1;

/// Notices a track that has come back to its start.
pub(super) struct Loops {
    start: Pose,
    along: Vec3,
    vectors: u32,
    met: u32,
}

impl Loops {
    pub(super) fn new(node: &Node) -> Self {
        Self { start: node.pose, along: node.course.along, vectors: 0, met: 0 }
    }

    /// Has it passed its start again without meeting anything on the round?
    pub(super) fn closed(&mut self, from: Vec3, to: Vec3, along: Vec3, met: u32) -> bool {
        self.vectors += 1;
        let v = to - from;
        let w = self.start.te - from;
        let length = v.norm();
        let t = w.dot(&v) / (length * length);
        let beside = (w - v * t).norm();
        let again = self.vectors > 3
            && (0.0..=1.0).contains(&t)
            && beside <= BESIDE * length
            && self.along.dot(&along) > 0.5;
        if !again {
            return false;
        }
        let idle = met == self.met;
        self.met = met;
        self.vectors = 0;
        idle
    }
}
