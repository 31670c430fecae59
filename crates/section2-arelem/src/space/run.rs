//! One motion along any two surfaces (APT: `AREPRE`, `ARLM3`).

use aptc_geometry::{Profile, Surface};

use super::begin::{InPlace, begin};
use super::follow::follow;
use crate::failure::Failure;
use crate::scene::{Path, Scene, Wall};

/// The path of a motion.
///
/// A turning axis may lay the cutter's side into a hollow drive surface that its lower edge just touches.
/// Then the motion follows the lower edge, and says how deep the rest cuts in.
///
/// An axis from elsewhere turns with the first cut vector where it can, and a check surface may stand nearer than that one's end: then it
/// turns in place first.
///
/// What is in a pointed tool may be as near to its face on all sides, and no normal leads out from there: a motion that comes to no
/// further place is tried once more with the tool outside of what its point touches.
pub(crate) fn run(scene: &Scene) -> Result<Path, Failure> {
    let blocked = match run_along(scene) {
        Err(Failure::Blocked(blocked)) => blocked,
        found => return found,
    };
    if scene.axis.turns()
        && blocked.gone <= 0.0
        && let Ok(begin) = begin(scene, InPlace::Always)
        && !begin.first.is_empty()
        && let Ok(path) = follow(scene, &begin)
    {
        return Ok(path);
    }
    let again = outside(scene).map(|scene| run_along(&scene));
    again.and_then(Result::ok).ok_or(Failure::Blocked(blocked))
}

/// The scene with the ends of cut vectors outside of the surfaces that the cutter touches; `None` where it is not pointed.
fn outside(scene: &Scene) -> Option<Scene> {
    let pointed = |w: &Wall| {
        let searched = matches!(w.fitted, Some(Surface::Parametric(_)));
        searched && !w.on && w.band.outtol > 0.0 && w.profile.is_pointed()
    };
    if !pointed(&scene.drive) && !pointed(&scene.part) {
        return None;
    }
    let mut other = scene.clone();
    other.drive.outside = pointed(&scene.drive);
    other.part.outside = pointed(&scene.part);
    Some(other)
}

fn run_along(scene: &Scene) -> Result<Path, Failure> {
    let failure = match begin(scene, InPlace::AsNeeded) {
        Ok(begin) => return follow(scene, &begin),
        Err(f) => f,
    };
    let Failure::OffDrive { off, .. } = failure else { return Err(failure) };
    if !scene.axis.turns() || off >= 0.0 || scene.drive.on {
        return Err(failure);
    }
    let [_, [radius, height]] = scene.drive.profile.joints();
    let Ok(edge) = Profile::disk(radius, height) else { return Err(failure) };
    let mut lower = scene.clone();
    lower.drive.profile = edge;
    lower.drive.disk = Some([radius, height]);
    match begin(&lower, InPlace::AsNeeded) {
        Ok(begin) => follow(&lower, &begin).map(|path| Path { fouls: Some(-off), ..path }),
        Err(_) => Err(failure),
    }
}
