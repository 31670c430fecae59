//! The rulings of a ruled surface whose curves are waves: a wide cutter may touch at several of them.

use super::{ParametricSurface, Patch};
use crate::Vec3;

/// Samples of a span of a curve.
const SAMPLES: f64 = 4.0;

impl ParametricSurface {
    /// Is it a ruled surface, and does one of its curves bend to both sides?
    pub fn has_waves(&self) -> bool {
        self.waves
    }

    /// How many spans of its curves lie between two places of a ruled surface with waves.
    pub fn spans_between(&self, a: [f64; 2], b: [f64; 2]) -> Option<f64> {
        let Patch::Ruled(rulings) = &self.patch else { return None };
        self.waves.then(|| (a[0] - b[0]).abs() * f64::from(rulings.pieces()) / SAMPLES)
    }

    /// The sampled rulings between which some may come nearer than `reach` to the straight way from `a` to `b`, two and two in
    /// their order.
    pub fn rulings_near(&self, a: Vec3, b: Vec3, reach: f64) -> impl Iterator<Item = [f64; 2]> {
        // The place of a ruling next to the way, and how far off it is.
        let near = move |(start, way, inverse): &(Vec3, Vec3, f64)| {
            let off = |p: Vec3| p - way * (way.dot(&p) * inverse);
            let (from, by) = (off(a - start), off(b - a));
            let t = (-from.dot(&by) / by.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            let away = from + by * t;
            (a + (b - a) * t - away, away.norm())
        };
        self.us.windows(2).zip(self.columns.windows(2)).filter_map(move |(u, columns)| {
            let ((p, d), (q, e)) = (near(&columns[0]), near(&columns[1]));
            (d.min(e) - (q - p).norm() <= reach).then(|| [u[0], u[1]])
        })
    }
}
