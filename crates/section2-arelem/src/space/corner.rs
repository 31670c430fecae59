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

/// A pose with the gaps at the old and the new place of the surface, and at the other surface.
type Touched = (Pose, [Gap; 3]);

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
                let ahead = Pose { te: from.pose.te + from.course.along * h, ..from.pose };
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
        let keep = &self.keeps[i];
        let far = far + 2.0 * keep.width();
        // A little inside of the band, where what is found by iteration cannot lie beyond it.
        let limits = keep.limits();
        let room = INSIDE * keep.width();
        let within = |g: f64| g.clamp(limits.low + room, limits.high - room);
        // The new place at first where it is.
        let start = (from.pose, [from.gaps[i], new, from.gaps[1 - i]]);
        let kept = [within(from.gaps[i].g), within(new.g), from.gaps[1 - i].g];
        let here = self.touched(i, start, kept, far)?;
        let leave = self.leaving(here.0, i, here.1, from.course.along)?;
        // The way on tells how the surface bends along it, and so where in the band it would best begin. Where the
        // hollow becomes tighter than the cutter on the way, the old place may end before.
        let best = within(keep.onwards(&leave.pose, leave.course.bends[i]));
        let there = self.touched(i, here, [kept[0], best, kept[2]], far);
        let found = there.and_then(|at| self.corner_at(from, i, at));
        found.or_else(|| self.corner_at(from, i, here))
    }

    /// The pose near a start where the old place of surface `i`, the new one and the other surface are at these
    /// gaps.
    fn touched(&self, i: usize, start: Touched, wanted: [f64; 3], far: f64) -> Option<Touched> {
        let (mut pose, mut gaps) = start;
        for _ in 0..ROUNDS {
            let off = [0, 1, 2].map(|k| wanted[k] - gaps[k].g);
            if off.iter().all(|o| o.abs() <= self.exact) {
                return Some((pose, gaps));
            }
            pose.te += solve_normals(gaps.map(|g| g.normal), off)?;
            if (pose.te - start.0.te).norm() > far {
                return None;
            }
            let at = |k: usize| self.keeps[i].gap_at(&pose, gaps[k].spot()).ok();
            let other = self.keeps[1 - i].gap(&pose, Some(gaps[2].spot())).ok()?;
            gaps = [at(0)?, at(1)?, other];
        }
        None
    }

    /// The corner at such a pose, if the cutter is deeper nowhere else.
    fn corner_at(&self, from: &Node, i: usize, at: Touched) -> Option<Corner> {
        let (pose, [old, new, other]) = at;
        let deepest = self.keeps[i].gap(&pose, None).ok()?.g;
        let least = (old.g.min(new.g) - 4.0 * self.exact).max(self.keeps[i].limits().low);
        let free = deepest >= least;
        if !free || self.keeps[1 - i].deeper(&pose, &other, 4.0 * self.exact, true).0.is_some() {
            return None;
        }
        let leave = self.leaving(pose, i, [old, new, other], from.course.along)?;
        let mut gaps = [other; 2];
        gaps[i] = old;
        let to = self.finish(pose, gaps, from.course.along).ok()?;
        let length = (pose.te - from.pose.te).norm();
        Some(Corner { arrive: Stride { length, to, targets: gaps.map(|g| g.g) }, leave })
    }

    /// The node that goes on along the new place, away from the old one, with the surface on the same hand as it was on the way
    /// `heading` to the old one: the other way leads back.
    fn leaving(
        &self,
        pose: Pose,
        i: usize,
        [old, new, other]: [Gap; 3],
        heading: Vec3,
    ) -> Option<Node> {
        let mut gaps = [other; 2];
        gaps[i] = new;
        let along: Vec3 = new.normal.cross(&other.normal).try_normalize(1e-7)?;
        let rise = along.dot(&old.normal);
        let hand = heading.dot(&old.normal.cross(&other.normal));
        if rise.abs() <= 1e-9 || rise * hand <= 0.0 {
            return None;
        }
        self.finish(pose, gaps, along * rise.signum()).ok()
    }
}
