//! Places of contact that a search found, so that no other piece of the surface beside one leads there again.

use aptc_geometry::Vec3;

/// How far from the middle of a piece a place counts as beside it, as a share of its reach.
const BESIDE: f64 = 3.0;

/// The last `N` of them.
pub(crate) struct Places<const N: usize> {
    at: [Vec3; N],
    found: usize,
}

impl<const N: usize> Places<N> {
    /// The one that is known.
    pub(crate) fn new(known: Vec3) -> Self {
        Self { at: [known; N], found: 0 }
    }

    /// Is one of them beside a piece with this middle, no point of which is farther from it than `reach`?
    pub(crate) fn beside(&self, middle: Vec3, reach: f64) -> bool {
        self.at.iter().any(|p| (p - middle).norm() <= BESIDE * reach)
    }

    /// Takes another one.
    pub(crate) fn take(&mut self, place: Vec3) {
        self.at[self.found % N] = place;
        self.found += 1;
    }

    /// How many were taken.
    pub(crate) fn found(&self) -> usize {
        self.found
    }
}
