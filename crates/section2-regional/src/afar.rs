//! Meetings of a probe that comes from afar, with a whole surface.

use aptc_contact::{Clear, PatchTree, Tool};

use crate::project::{Met, Probe, Shot};

/// Starts along each side of a patch for a search without a place to begin at.
const STARTS: usize = 4;
/// Steps of a fall.
const FALLS: usize = 400;
/// Meetings so near to each other, for the size of the numbers, are one.
pub(crate) const SAME: f64 = 1e-8;
/// Radii of the surface that the tool counts as away from it at first.
const AFAR: f64 = 8.0;
/// Share of the distance to which the next step down is told.
const TOLD: f64 = 0.02;

impl Shot<'_> {
    /// The first meeting along the direction, by searches from all over the patches near its line, and where
    /// they find none from all over the surface: a meeting on the surface comes before one on its continuation.
    pub fn first(&self, tree: &PatchTree) -> Option<Met> {
        let inside = self.among(tree.beside(self.from, self.along, self.width()).into_iter());
        if inside.as_ref().is_some_and(|m| self.inside(m)) {
            return inside;
        }
        self.among(0..self.surface.patches.len())
    }

    /// Is it on the surface, not on its continuation?
    fn inside(&self, m: &Met) -> bool {
        let [nu, nv] = self.surface.spans();
        let within = |x: f64, n: f64| (-1e-9..=n + 1e-9).contains(&x);
        within(m.uv[0], nu) && within(m.uv[1], nv) && !self.surface.is_in_hole(m.uv)
    }

    /// The first of the meetings that searches from all over some patches reach.
    fn among(&self, patches: impl Iterator<Item = usize>) -> Option<Met> {
        let mut best: Option<Met> = None;
        let place = |k: usize| (k as f64 + 0.5) / STARTS as f64;
        for patch in patches {
            for k in 0..STARTS * STARTS {
                let start = self.surface.global(patch, place(k % STARTS), place(k / STARTS));
                let Some(m) = self.near(start) else { continue };
                let better =
                    best.as_ref().is_none_or(|b| match (self.inside(&m), self.inside(b)) {
                        (true, false) => true,
                        (false, true) => false,
                        _ => m.way < b.way,
                    });
                if better {
                    best = Some(m);
                }
            }
        }
        best
    }

    /// The first meeting of a cutter that comes from afar: it goes on by its distance from the whole surface, until
    /// a search from the place that it comes near to ends at a meeting with nothing in front of it. `None` where it
    /// first touches a border, and for a ball.
    pub fn touch(&self, tree: &PatchTree) -> Option<Met> {
        let Probe::Cutter { profile, ta, thick } = self.probe else { return None };
        let size = self.extent + self.from.norm() + profile.reach();
        // There it is still clear of a ball about all of the surface.
        let (center, radius) = tree.around()?;
        let mut way =
            (center - self.from).dot(&self.along) - radius - profile.reach() - thick.abs();
        // From afar it is told coarsely.
        let mut gap = AFAR * radius;
        for _ in 0..FALLS {
            let at = |way: f64| Tool { profile, te: self.from + self.along * way, ta };
            let eps = (TOLD * gap).max(1e-11 * size);
            let (place, _) = tree.deepest(&at(way), eps)?;
            gap = place.distance - thick;
            if gap < 0.1 * profile.reach() {
                let [u, v] = place.uv;
                let met = self.near(self.surface.global(place.patch, u, v));
                let allowed = SAME * size - thick;
                let found = met.filter(|m| tree.clear(&at(m.way), allowed) == Clear::Yes);
                if found.is_some() {
                    return found;
                }
            }
            if gap <= 1e-9 * size {
                return None;
            }
            // The nearest place is nearer by what was not asked for at most.
            way += (gap - eps).max(0.0);
        }
        None
    }

    /// The first place that the probe touches when it comes from afar, by a search that cannot miss one: the
    /// probe goes on by its distance from the whole surface until that is nothing. Slower than the others, for where
    /// they find none.
    pub fn fall(&self, tree: &PatchTree) -> Option<Met> {
        let Probe::Cutter { profile, ta, thick } = self.probe else { return None };
        let size = self.extent + self.from.norm() + profile.reach();
        let mut way = -4.0 * size;
        let mut gap = size;
        for _ in 0..FALLS {
            let tool = Tool { profile, te: self.from + self.along * way, ta };
            // From afar no more is asked than what the next step needs.
            let eps = (1e-3 * gap).max(1e-11 * size);
            let (place, _) = tree.deepest(&tool, eps)?;
            let sure = eps <= 1e-11 * size;
            gap = place.distance - thick;
            if gap <= 1e-10 * size && sure {
                let [u, v] = place.uv;
                let uv = self.surface.global(place.patch, u, v);
                let at = self.surface.at(uv[0], uv[1]);
                let normal = at.normal()? * self.side;
                return (normal.dot(&self.along) < 0.0).then_some(Met { uv, at, normal, way });
            }
            // The nearest place is nearer by what was not asked for at most.
            way += (gap - eps).max(0.0);
        }
        None
    }

    /// How far from the line of projection a place that the probe touches can be.
    fn width(&self) -> f64 {
        match self.probe {
            Probe::Ball(r) => r.abs(),
            Probe::Cutter { profile, ta, thick } => {
                let lean = (ta - self.along * ta.dot(&self.along)).norm();
                thick.abs() + profile.widest() + profile.reach() * lean
            }
        }
    }
}
