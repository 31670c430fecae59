//! Where charts go on into each other without an edge.

use aptc_geometry::sculpt::Derivatives;

use super::{Kind, Patch, Patched};
use crate::each::two;

/// Length of the difference of two unit normals that count as one.
pub(crate) const SMOOTH: f64 = 1e-9;

impl Patched {
    /// Does the surface go on without an edge wherever a piece lies at a border of its chart?
    pub(crate) fn goes_on(&self, patch: &Patch) -> bool {
        /// Share of a chart up to which what is near a border counts as on it: halving rounds.
        const NEAR: f64 = 1e-9;
        let range = &self.charts[patch.chart].range;
        let smooth = || self.smooth(patch.chart);
        (0..2).all(|k| {
            let [from, to] = [patch.at[k] - patch.half[k], patch.at[k] + patch.half[k]];
            let near = NEAR * (range[k][1] - range[k][0]);
            (from > range[k][0] + near || smooth()[k][0])
                && (to < range[k][1] - near || smooth()[k][1])
        })
    }

    /// At which ends of its parameters has a chart the points and the normals of the one beside it?
    pub(super) fn smooth(&self, chart: usize) -> [[bool; 2]; 2] {
        let columns = self.columns();
        let counts = [columns, self.charts.len() / columns];
        let place = [chart % columns, chart / columns];
        let step = [1, columns];
        let lower = self.smooth_below(chart);
        two([0, 1], |k| {
            let last = place[k] + 1 == counts[k];
            [lower[k], !last && self.smooth_below(chart + step[k])[k]]
        })
    }

    /// The same at the low ends.
    fn smooth_below(&self, chart: usize) -> [bool; 2] {
        *self.smooth[chart].get_or_init(|| {
            let columns = self.columns();
            let place = [chart % columns, chart / columns];
            let step = [1, columns];
            two([0, 1], |k| {
                place[k] > 0
                    && self.grid.sides[k].joins(place[k], 0)
                    && self.meets(chart, chart - step[k], k, 0)
            })
        })
    }

    /// Meets a chart the other at this end of the parameter as if both were one?
    ///
    /// Places along the border tell: along it both are cubics, or rulings with rails that run alike.
    fn meets(&self, chart: usize, other: usize, k: usize, end: usize) -> bool {
        const PLACES: u32 = 16;
        let [one, other] = two([chart, other], |i| &self.charts[i]);
        if one.none || other.none {
            return false;
        }
        // Cells of one map have the same points and derivatives where they meet; at the corner of a rail they are of two.
        let same = self.is_one_map(one.cell, other.cell);
        if same && self.has_normals(chart) {
            return true;
        }
        let [from, to] = one.range[1 - k];
        let size = self.nodes.last().map_or(0.0, |root| root.radius);
        (0..=PLACES).all(|i| {
            let mut at = [one.range[k][end]; 2];
            at[1 - k] = from + (to - from) * f64::from(i) / f64::from(PLACES);
            let a = self.at(one, at);
            if same {
                return a.normal().is_some();
            }
            let b = self.at(other, at);
            let [m, n] = two([&a, &b], Derivatives::normal);
            let turned = m.zip(n).map_or(f64::INFINITY, |(m, n)| (m - n).norm());
            (a.point - b.point).norm() <= 1e-13 * size && turned <= SMOOTH
        })
    }

    /// Has a chart a normal all over, as its middle and the bounds of its second derivatives tell?
    fn has_normals(&self, chart: usize) -> bool {
        /// Sine of the angle between the derivatives that counts as none.
        const PARALLEL: f64 = 1e-9;
        let patch = self.patch(chart);
        let jet = self.jet(&patch.spot());
        let (change, n) = self.change(&patch, &jet, self.second(&patch));
        change[0] + change[1] < 0.5 * n && n > PARALLEL * jet.d[0].norm() * jet.d[1].norm()
    }

    /// Are two cells evaluated alike?
    fn is_one_map(&self, one: [usize; 2], other: [usize; 2]) -> bool {
        match &self.kind {
            Kind::Sculpted(s) => s.is_one_patch(one, other),
            Kind::Ruled(s) => s.is_one_map(one[0], other[0]),
            Kind::Polyconic(_) => one == other,
        }
    }
}
