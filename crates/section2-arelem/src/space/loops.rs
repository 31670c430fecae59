//! A track that goes round.

use aptc_geometry::Vec3;

use super::track::Node;

/// Share of a cut vector by which a track that has come back may pass beside its start, where it may have an edge.
const BESIDE: f64 = 0.1;

/// Cut vectors from which on a place on the way counts as a start, and so at each doubling of them.
const ONWARDS: u32 = 256;

/// Notices a track that has come back to its start, or to a place on its way: it may have come to where it goes round from elsewhere
/// (R. P. Brent: places that lie ever farther apart are held against what comes after them).
pub(super) struct Loops {
    start: Vec3,
    along: Vec3,
    vectors: u32,
    met: u32,
    /// Vectors in all, and those at which the next place counts as the start.
    gone: u32,
    next: u32,
    /// How far beside a place on the way one may pass that has come back to it: both keep to the same bands.
    width: f64,
}

impl Loops {
    /// On a track whose bands are together so wide.
    pub(super) fn new(node: &Node, width: f64) -> Self {
        let (start, along) = (node.pose.te, node.course.along);
        Self { start, along, vectors: 0, met: 0, gone: 0, next: ONWARDS, width }
    }

    /// Has it passed its start again without meeting anything on the round?
    pub(super) fn closed(&mut self, from: Vec3, to: Vec3, along: Vec3, met: u32) -> bool {
        self.vectors += 1;
        self.gone += 1;
        if self.gone == self.next {
            (self.start, self.along, self.vectors, self.met) = (to, along, 0, met);
            self.next = self.next.saturating_mul(2);
            return false;
        }
        let v = to - from;
        let w = self.start - from;
        let length = v.norm();
        let t = w.dot(&v) / (length * length);
        let beside = (w - v * t).norm();
        let onwards = self.gone >= ONWARDS;
        let most = if onwards { self.width.min(BESIDE * length) } else { BESIDE * length };
        let again = self.vectors > 3
            && (0.0..=1.0).contains(&t)
            && beside <= most
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
