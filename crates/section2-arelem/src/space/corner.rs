//! Corners of a track: the cutter comes to touch a surface at a second place, and goes on along that.
//!
//! In a hollow tighter than the cutter the two places are touched at once, and the path has a corner there that
//! no cut vector may round: whatever it leaves out stays as material. So the corner itself becomes the end of a
//! cut vector.

use aptc_contact::{Condition, Gap};
use aptc_geometry::Vec3;

use super::keep::Pose;
use super::stride::Stride;
use super::track::{Node, Track, solve_normals};

/// Shares of the cutter's size by which the tool is moved ahead to see what it comes to touch.
const AHEAD: [f64; 8] = [1e-6, 1e-5, 1e-4, 1e-3, 4e-3, 1.6e-2, 6.4e-2, 0.2];
/// Normals that differ by less belong to one place of contact.
const ANOTHER: f64 = 1e-2;
/// Share of the cutter's size by which two places of contact lie apart.
const APART: f64 = 1e-3;
/// Share of the band by which both places stay inside of it.
const INSIDE: f64 = 1e-4;
/// Rounds of Newton's method.
const ROUNDS: usize = 40;

/// A corner of the track.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    /// The cut vector that ends there, along the old place of contact.
    pub(crate) arrive: Stride,
    /// The same place with the new place of contact, going on along it.
    pub(crate) leave: Node,
}

impl Track {
    /// The corner just ahead of a node, if the track has one there. The axis must not turn.
    pub(crate) fn corner(&self, from: &Node) -> Option<Corner> {
        if self.axis.turns() {
            return None;
        }
        for share in AHEAD {
            for (i, keep) in self.keeps.iter().enumerate() {
                if keep.condition == Condition::On || keep.is_plane() {
                    continue;
                }
                let size = keep.profile.widest().max(0.1 * keep.profile.reach());
                let h = share * size;
                let ahead = Pose { te: from.pose.te + from.along * h, ..from.pose };
                let Ok(met) = keep.gap(&ahead, None) else { continue };
                let old = &from.gaps[i];
                if (met.normal - old.normal).norm() <= ANOTHER {
                    continue;
                }
                // The place touched ahead exists here too, or it is the old one moved on.
                let Ok(new) = keep.gap_at(&from.pose, met.spot()) else { continue };
                if (new.surface_point - old.surface_point).norm() <= APART * size {
                    continue;
                }
                if let Some(corner) = self.turn_at(from, i, new, 4.0 * h) {
                    return Some(corner);
                }
            }
        }
        None
    }

    /// The place no farther than `far` where surface `i` is touched at the old and the `new` place.
    fn turn_at(&self, from: &Node, i: usize, new: Gap, far: f64) -> Option<Corner> {
        let j = 1 - i;
        let keep = &self.keeps[i];
        let mut pose = from.pose;
        let (mut old, mut new, mut other) = (from.gaps[i], new, from.gaps[j]);
        // A little inside of the band, where what is found by iteration cannot lie beyond it.
        let limits = keep.limits();
        let room = INSIDE * keep.width();
        let within = |g: f64| g.clamp(limits.low + room, limits.high - room);
        let kept = [within(old.g), other.g];
        // The new place at first where it is.
        let mut target = within(new.g);
        let mut settled = false;
        for _ in 0..ROUNDS {
            let off = [kept[0] - old.g, target - new.g, kept[1] - other.g];
            if off.iter().all(|o| o.abs() <= self.exact) {
                if settled {
                    break;
                }
                // The way on tells how the surface bends along it, and so where in the band it begins.
                let leave = self.leaving(pose, i, [old, new, other])?;
                target = within(keep.target(leave.bends[i], 1.0));
                settled = true;
                continue;
            }
            let step = solve_normals([old.normal, new.normal, other.normal], off)?;
            pose.te += step;
            if (pose.te - from.pose.te).norm() > far + 2.0 * keep.width() {
                return None;
            }
            old = keep.gap_at(&pose, old.spot()).ok()?;
            new = keep.gap_at(&pose, new.spot()).ok()?;
            other = self.keeps[j].gap(&pose, Some(other.spot())).ok()?;
        }
        let off = [kept[0] - old.g, target - new.g, kept[1] - other.g];
        let deepest = keep.gap(&pose, None).ok()?.g;
        let there = off.iter().all(|o| o.abs() <= self.exact);
        let free = deepest >= old.g.min(new.g) - 4.0 * self.exact;
        if !there || !free || self.keeps[j].deeper(&pose, &other, 4.0 * self.exact).0.is_some() {
            return None;
        }
        let leave = self.leaving(pose, i, [old, new, other])?;
        let mut gaps = [other; 2];
        gaps[i] = old;
        let to = self.finish(pose, gaps, from.along).ok()?;
        let length = (pose.te - from.pose.te).norm();
        Some(Corner { arrive: Stride { length, to, targets: gaps.map(|g| g.g) }, leave })
    }

    /// The node that goes on along the new place, away from the old one.
    fn leaving(&self, pose: Pose, i: usize, [old, new, other]: [Gap; 3]) -> Option<Node> {
        let mut gaps = [other; 2];
        gaps[i] = new;
        let along: Vec3 = new.normal.cross(&other.normal).try_normalize(1e-7)?;
        let rise = along.dot(&old.normal);
        if rise.abs() <= 1e-9 {
            return None;
        }
        self.finish(pose, gaps, along * rise.signum()).ok()
    }
}
