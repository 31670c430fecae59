//! A tool that turns in place before a motion begins, beside the check surface that the motion is to end at.

use aptc_protap::Relation;

use super::begin::Begin;
use super::keep::{Keep, Pose};
use super::watch::clearance;
use crate::failure::Failure;
use crate::scene::{Check, Scene};

/// Refuses a motion TO a check surface that the tool, clear of it where it stands, turns into before it begins: the track that comes
/// out of it again would be taken for one that comes to it.
pub(super) fn clear(scene: &Scene, begin: &Begin) -> Result<(), Failure> {
    let stands = Pose::standing(&scene.tool);
    scene.checks.iter().try_for_each(|check| beside(check, stands, begin))
}

fn beside(check: &Check, stands: Pose, begin: &Begin) -> Result<(), Failure> {
    if begin.first.is_empty() || check.relation != Relation::To || check.nth > 1 {
        return Ok(());
    }
    let keep = Keep::of(&check.wall)?;
    let Ok((gap, side)) = clearance(&keep, &stands) else { return Ok(()) };
    let allowed = keep.width();
    if gap < -allowed {
        return Ok(());
    }
    let keep = keep.on_side(side);
    for position in &begin.first {
        let pose = Pose::of(position);
        if let Ok(gap) = keep.gap(&pose, None)
            && gap.g < -allowed
        {
            let surface = check.wall.surface.clone();
            let (place, axis, deep) = (pose.te, pose.ta, -gap.g);
            return Err(Failure::TurnsInto { surface, place, axis, deep });
        }
    }
    Ok(())
}
