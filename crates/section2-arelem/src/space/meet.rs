//! The end of a motion at a check surface that misses being tangent by less than the bands, or is met near the edge of one.

use super::keep::{Keep, Pose};
use super::track::{Aim, Node, Track, solve_normals};

/// Cosine of the angle between two normals that are those of one tangent.
const ALIKE: f64 = 0.9;
/// Share of the band by which the place stays inside of it.
const INSIDE: f64 = 1e-3;
/// Rounds of Newton's method.
const ROUNDS: usize = 8;

impl Track {
    /// The node beside `at` that is in the bands of surface `i` and of the check surface that is tangent to it: moved along
    /// their normal as little as that takes, and no farther than the band of surface `i` goes. `None` where nothing is to be
    /// moved, or could be.
    pub(crate) fn met_by_both(&self, at: &Node, i: usize, check: &Keep) -> Option<Node> {
        let keep = &self.keeps[i];
        let (mut pose, mut gaps) = (at.pose, at.gaps);
        let mut moved = false;
        for _ in 0..ROUNDS {
            let met = check.gap_from(&pose, None).ok()?;
            let cos = gaps[i].normal.dot(&met.normal);
            let limits = check.limits();
            if limits.low <= met.g && met.g <= limits.high {
                return moved.then(|| self.finish(pose, gaps, at.course.along).ok()).flatten();
            }
            if cos.abs() < ALIKE {
                return None;
            }
            let miss = inside(check, met.g) - met.g;
            let by = inside(keep, gaps[i].g + miss / cos) - gaps[i].g;
            if by.abs() <= self.exact {
                return None;
            }
            if self.axis.turns() {
                // The axis of the place that it moves to is another.
                let mut targets = gaps.map(|gap| gap.g);
                targets[i] += by;
                let aim = Aim { across: at.course.along, targets, hint: at, look: false };
                let node = self.settle(pose, &aim).ok()?;
                (pose, gaps, moved) = (node.pose, node.gaps, true);
                continue;
            }
            let normals = [gaps[i].normal, gaps[1 - i].normal, at.course.along];
            pose = Pose { te: pose.te + solve_normals(normals, [by, 0.0, 0.0])?, ..pose };
            let gap = |k: usize| self.keeps[k].gap(&pose, Some(gaps[k].spot())).ok();
            gaps = [gap(0)?, gap(1)?];
            moved = true;
        }
        None
    }
}

/// The nearest gap that is in the band, a little inside of it.
fn inside(keep: &Keep, g: f64) -> f64 {
    let (limits, room) = (keep.limits(), INSIDE * keep.width());
    g.clamp(limits.low + room, limits.high - room)
}
