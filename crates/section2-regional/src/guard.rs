//! CHKSRF: no position and no cut vector deeper in a checked surface than allowed.

use std::sync::Arc;

use aptc_contact::{Clear, PatchPlace, PatchTree, Swept, Tool};
use aptc_geometry::{Profile, Sculptured, Vec3};

/// A surface that is checked.
#[derive(Clone, Debug)]
pub(crate) struct Checked {
    pub(crate) name: String,
    pub(crate) surface: Arc<Sculptured>,
    pub(crate) tree: Arc<PatchTree>,
    /// Is it the part surface, which keeps its thickness?
    pub(crate) part: bool,
}

/// The checks of a path.
#[derive(Clone, Debug)]
pub(crate) struct Guard {
    pub(crate) surfaces: Vec<Checked>,
    pub(crate) intol: f64,
    /// Left on the part surface.
    pub(crate) thick: f64,
}

/// Where a check fails.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Gouge {
    pub(crate) surface: String,
    pub(crate) place: PatchPlace,
    /// Parameters of the whole surface.
    pub(crate) span: (usize, [f64; 2]),
    /// How deep, the thickness counted.
    pub(crate) depth: f64,
}

impl Guard {
    /// Is the tool clear at `te`?
    pub(crate) fn position(&self, profile: &Profile, te: Vec3, ta: Vec3) -> Result<(), Gouge> {
        self.way(profile, te, ta, Vec3::zeros())
    }

    /// Is the tool clear all the way from `te` by `by`?
    pub(crate) fn way(&self, profile: &Profile, te: Vec3, ta: Vec3, by: Vec3) -> Result<(), Gouge> {
        let tool = Tool { profile, te, ta };
        for s in &self.surfaces {
            let thick = if s.part { self.thick } else { 0.0 };
            let allowed = self.intol - thick;
            let found = if by == Vec3::zeros() {
                s.tree.clear(&tool, allowed)
            } else {
                s.tree.clear(&Swept { tool, by }, allowed)
            };
            // What cannot be proved clear is not taken for clear.
            if let Clear::No(place) | Clear::Unknown(place) = found {
                let [u, v] = s.surface.global(place.patch, place.uv[0], place.uv[1]);
                let span = s.surface.span_of(u, v);
                let depth = thick - place.distance;
                return Err(Gouge { surface: s.name.clone(), place, span, depth });
            }
        }
        Ok(())
    }
}
