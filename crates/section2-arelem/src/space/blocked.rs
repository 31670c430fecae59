//! Why a track ends before its check surface is met.

use aptc_contact::Condition;
use aptc_geometry::Vec3;

use super::keep::{Keep, Pose};
use super::track::{Node, Track};

/// What keeps the cutter from going on; the number is that of the surface: 0 drive, 1 part.
#[derive(Clone, Copy, Debug)]
pub(super) enum Cause {
    /// Nothing of the surface faces the cutter there.
    Ends(usize),
    /// The cutter comes to touch it at this place too.
    Again(usize, Vec3),
    /// No cut vector of any length stays in the bands.
    Tight,
}

/// Shares of the cutter's size by which the tool is moved about to see what changes.
const STEPS: [f64; 3] = [1e-4, 1e-3, 1e-2];
/// Normals that differ by less belong to one contact along a line or a face.
const ANOTHER: f64 = 1e-2;

/// The cause, from the gaps about the last place of the track.
pub(super) fn cause(track: &Track, node: &Node) -> Cause {
    let ahead = |keep: &Keep, h: f64| {
        let pose = Pose { te: node.pose.te + node.course.along * h, ..node.pose };
        keep.gap(&pose, None)
    };
    let size = |keep: &Keep| keep.profile.widest().max(0.1 * keep.profile.reach());
    for (i, keep) in track.keeps.iter().enumerate() {
        let ends = |s: &f64| ahead(keep, s * size(keep)).is_err();
        if keep.goes_round_an_end(&node.gaps[i]) || STEPS.iter().any(ends) {
            return Cause::Ends(i);
        }
    }
    for (i, keep) in track.keeps.iter().enumerate() {
        for step in STEPS {
            let te = node.pose.te + node.course.along * (step * size(keep));
            let pose = Pose { te, ..node.pose };
            if let Ok(gap) = keep.gap(&pose, Some(node.gaps[i].spot()))
                && let (Some(deeper), _) = keep.deeper(&pose, &gap, keep.width(), true)
            {
                return Cause::Again(i, deeper.surface_point);
            }
        }
    }
    let left = node.pose.ta.cross(&node.course.along);
    for (i, keep) in track.keeps.iter().enumerate() {
        if keep.condition == Condition::On || keep.is_plane() {
            continue;
        }
        let here = &node.gaps[i];
        for step in STEPS {
            let h = step * size(keep);
            for v in [node.course.along, -node.course.along, left, -left] {
                let pose = Pose { te: node.pose.te + v * h, ..node.pose };
                let Ok(gap) = keep.gap(&pose, None) else { continue };
                let level = gap.g <= here.g + 2.0 * h + keep.width();
                let apart = (gap.tool_point - pose.te) - (here.tool_point - node.pose.te);
                let another = (gap.normal - here.normal).norm() > ANOTHER;
                if level && another && apart.norm() > 0.1 * size(keep) {
                    return Cause::Again(i, gap.surface_point);
                }
            }
        }
    }
    Cause::Tight
}
