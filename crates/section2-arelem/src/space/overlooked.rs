//! Looks along a cut vector that is longer than the way for which nothing else could touch.

use super::judge::between;
use super::stride::Stride;
use super::track::{Node, Track};

/// Share of the cutter's radius between two looks at least, where another place of contact is about as near.
const CLOSE: f64 = 0.03;
/// Looks along one cut vector at most.
const MOST: f64 = 256.0;
/// Share of the way to a place where the cutter cuts in that is tried next.
const BEFORE: f64 = 0.9;

impl Track {
    /// A length at which the cutter does not yet cut in elsewhere than where it is known to touch, when it does so on the way
    /// of a cut vector beyond the `room` for which nothing could.
    pub(super) fn overlooked(&self, from: &Node, stride: &Stride, room: f64) -> Option<f64> {
        for (i, keep) in self.keeps.iter().enumerate().filter(|(_, k)| k.is_mixed()) {
            let close = (CLOSE * keep.profile.widest()).max(stride.length / MOST);
            let mut s = room.max(0.0) + close;
            let mut near = from.gaps[i];
            while close > 0.0 && s < stride.length {
                let pose = between(&from.pose, &stride.to.pose, s / stride.length);
                near = keep.gap(&pose, Some(near.spot())).ok()?;
                let (deeper, free) = keep.deeper(&pose, &near, 0.0, true);
                let least = deeper.map_or(near.g, |d| d.g);
                if least < keep.limits().low - 1e-6 * keep.width() {
                    return Some(BEFORE * s);
                }
                s += free.max(close);
            }
        }
        None
    }
}
