//! A patch prepared for questions: the bounds of its derivatives, and its pieces that are made beforehand.

use aptc_geometry::Vec3;
use aptc_geometry::sculpt::{Bends, Patch};

use crate::under::Cell;

/// Times that a patch is divided beforehand at most, so that most pieces need no evaluation: each takes four times the memory
/// of the one before.
pub(super) const KEPT: usize = 3;
/// A piece that strays from its parallelogram by no more than this part of the patch is not divided beforehand.
const FLAT: f64 = 2e-4;
/// A side that is not shorter than this part of the other is halved with it.
const SQUARE: f64 = 0.6;

/// A patch with bounds of its derivatives.
#[derive(Clone, Debug)]
pub(super) struct Leaf {
    /// Its number in the surface.
    pub(super) number: usize,
    pub(super) patch: Patch,
    pub(super) bends: Bends,
    pub(super) center: Vec3,
    pub(super) radius: f64,
    /// Its pieces that are kept, each level rows of as many columns as the parameter u is divided into, the whole first.
    pub(super) levels: [Level; KEPT + 1],
    pub(super) depth: usize,
}

/// Pieces of one size.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Level {
    /// Where the first of them is.
    pub(super) first: usize,
    /// Into how many parts the parameters are divided.
    pub(super) parts: [usize; 2],
}

impl Leaf {
    pub(super) fn new(number: usize, patch: &Patch) -> Self {
        let [lo, hi] = patch.bounds();
        let center = (lo + hi) * 0.5;
        let radius =
            patch.net.iter().flatten().map(|h| (h.xyz() / h.w - center).norm()).fold(0.0, f64::max);
        let bends = Bends::of(patch, center, radius);
        let levels = [Level::default(); KEPT + 1];
        Self { number, patch: patch.clone(), bends, center, radius, levels, depth: 0 }
    }

    /// Adds its pieces to those that are kept.
    pub(super) fn keep(&mut self, depth: usize, cells: &mut Vec<Cell>) {
        let mut parts = [1; 2];
        let mut size = [1.0, 1.0];
        for level in 0..=depth {
            let half = parts.map(|n| 0.5 / n as f64);
            let middle = |k: usize, i: usize| half[k] * (2 * i + 1) as f64;
            self.levels[level] = Level { first: cells.len(), parts };
            self.depth = level;
            for j in 0..parts[1] {
                cells.extend((0..parts[0]).map(|i| self.cell([middle(0, i), middle(1, j)], half)));
            }
            if level == 0 {
                size = cells[cells.len() - 1].first.map(|d| d.norm());
            }
            if self.bends.strays(half) <= FLAT * self.radius {
                break;
            }
            let sides = [0, 1].map(|k| size[k] / parts[k] as f64);
            for k in 0..2 {
                if sides[k] >= SQUARE * sides[1 - k] {
                    parts[k] *= 2;
                }
            }
        }
    }

    /// A piece by its middle and half widths.
    pub(super) fn cell(&self, mid: [f64; 2], half: [f64; 2]) -> Cell {
        let d = self.patch.at(mid[0], mid[1]);
        let [hu, hv] = half;
        let first = [d.u * hu, d.v * hv];
        let far = first[0].norm() + first[1].norm() + self.bends.strays(half);
        let second = [d.uu * (0.5 * hu * hu), d.uv * (hu * hv), d.vv * (0.5 * hv * hv)];
        Cell { point: d.point, first, second, rests: self.bends.rests(half), far }
    }
}

impl Level {
    /// In which part of the parameter `k` a place is.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "0 to 1 times a few"
    )]
    pub(super) fn place(&self, k: usize, at: f64) -> usize {
        (at * self.parts[k] as f64) as usize
    }
}
