//! A pass over the summit between two passes.
//!
//! Beside a summit a flat bottom swings round it with its rim, on the left of it in a pass on its left, on the right in
//! one on its right, and what is between them stays, however near they are. The pass that goes over the summit itself
//! swings to neither side and clears it.

use aptc_geometry::Vec3;

use crate::jump::Pair;
use crate::lanes::Lane;
use crate::region::Region;

/// Widenings of the stretch of a pass in which the bottom goes from behind its contact to before it, from this part of
/// the pass on.
const WIDER: u32 = 9;
const STRETCH: f64 = 1.0 / 512.0;
/// Halvings of a stretch, and of a step: down to rounding.
const HALVINGS: u32 = 52;

impl Region<'_> {
    /// The step from a pass to the one over the summit near `pair`, which lies between it and the pass `step` away; `None`
    /// where none lies there.
    pub(crate) fn summit(&self, lane: &Lane, step: f64, pair: &Pair) -> Option<f64> {
        let [a, b] = &pair.both;
        let over = b.0.contact - a.0.contact;
        let side = |step: f64| self.abeam(lane, step, pair.t, over);
        let first = side(0.0)?;
        if first * side(step)? >= 0.0 {
            return None;
        }
        let (mut low, mut high) = (0.0, step);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            *(if side(middle)? * first > 0.0 { &mut low } else { &mut high }) = middle;
        }
        Some(high)
    }

    /// How far the tool stands to the side `over` of its contact, in the pass `step` away, where its bottom goes from
    /// behind the contact to before it near the parameter `t`.
    fn abeam(&self, lane: &Lane, step: f64, t: f64, over: Vec3) -> Option<f64> {
        let k = self.course.index();
        let [from, to] = [lane.from[k].min(lane.to), lane.from[k].max(lane.to)];
        let at = |t: f64| Some(self.pair(lane, step, t, None)?.both[1].0);
        let ahead = |t: f64| {
            let p = at(t)?;
            Some((p.te - p.contact).dot(&self.setup.drive.place(p.drive_uv, self.course).along))
        };
        let mut reach = STRETCH * (to - from);
        for _ in 0..WIDER {
            let (mut low, mut high) = ((t - reach).max(from), (t + reach).min(to));
            reach *= 2.0;
            // In a hollow it goes from before the contact to behind it, and no pass clears what is below the bottom.
            if ahead(low)? >= 0.0 || ahead(high)? <= 0.0 {
                continue;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                *(if ahead(middle)? < 0.0 { &mut low } else { &mut high }) = middle;
            }
            let p = at(0.5 * (low + high))?;
            return Some((p.te - p.contact).dot(&over));
        }
        None
    }
}
