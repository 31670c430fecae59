//! Looks along a cut vector that is longer than the way for which nothing else could touch.

use super::judge::between;
use super::stride::Stride;
use super::track::{Node, Track};

/// Share of the cutter's radius between two looks at least, where another place of contact is about as near.
const CLOSE: f64 = 0.03;
/// Looks along one cut vector at most.
const MOST: f64 = 256.0;
/// Looks at each span that the contact goes over in one cut vector, and at all of them at most.
const EACH: f64 = 4.0;
const LEAPS: f64 = 1024.0;
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

    /// The same of a cut vector whose contact goes over several spans of a surface at once: from one straight end to the other, the
    /// gap is level at both, and in the middle of it too.
    pub(super) fn overleapt(&self, from: &Node, stride: &Stride) -> Option<f64> {
        let way = [from.pose.te, stride.to.pose.te];
        for (i, keep) in self.keeps.iter().enumerate() {
            let (Some(a), Some(b)) = (from.gaps[i].at, stride.to.gaps[i].at) else { continue };
            let pieces = keep.surface.pieces_between([a, b], way, keep.profile.reach());
            let looks = (EACH * pieces).ceil().min(LEAPS);
            // A first cut vector may come from a wider band.
            let (limits, begin, little) = (keep.limits(), from.gaps[i].g, 1e-6 * keep.width());
            let band = limits.low.min(begin) - little..=limits.high.max(begin) + little;
            let (mut near, mut k) = (from.gaps[i], 1.0);
            while k < looks {
                let pose = between(&from.pose, &stride.to.pose, k / looks);
                let Ok(mut gap) = keep.gap(&pose, Some(near.spot())) else { break };
                // From another place of contact it may be farther than it is.
                if gap.g > *band.end() {
                    gap = keep.gap(&pose, None).unwrap_or(gap);
                }
                if !band.contains(&gap.g) {
                    return Some(BEFORE * stride.length * k / looks);
                }
                (near, k) = (gap, k + 1.0);
            }
        }
        None
    }
}
