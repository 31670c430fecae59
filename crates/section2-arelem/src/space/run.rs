//! One motion along any two surfaces (APT: `AREPRE`, `ARLM3`).

use aptc_geometry::Profile;

use super::begin::begin;
use super::follow::follow;
use crate::failure::Failure;
use crate::scene::{Path, Scene};

/// The path of a motion.
///
/// A turning axis may lay the cutter's side into a hollow drive surface that its lower edge just touches.
/// Then the motion follows the lower edge, and says how deep the rest cuts in.
pub(crate) fn run(scene: &Scene) -> Result<Path, Failure> {
    let failure = match begin(scene) {
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
    match begin(&lower) {
        Ok(begin) => follow(&lower, &begin).map(|path| Path { fouls: Some(-off), ..path }),
        Err(_) => Err(failure),
    }
}
