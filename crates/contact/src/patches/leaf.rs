//! A patch prepared for questions: the bounds of its derivatives, and its pieces that are made beforehand.

use aptc_geometry::Vec3;
use aptc_geometry::sculpt::{Bends, Patch, Vec4};

use crate::under::Cell;

/// Times that a patch is divided beforehand at most, so that most pieces need no evaluation: each takes four times the memory
/// of the one before.
pub(super) const KEPT: usize = 3;
/// A piece that strays from its parallelogram by no more than this part of the patch is not divided beforehand.
const FLAT: f64 = 2e-4;
/// A side that is not shorter than this part of the other is halved with it.
const SQUARE: f64 = 0.6;

/// Times as heavy as another one that a weight may be in a row of them: what bounds derivatives grows by its third power.
const UNEVEN: f64 = 4.0;
/// Parts that a patch with such weights is made into at most, and the least of their sides.
const PARTS: usize = 64;
const LEAST: f64 = 1.0 / 64.0;

/// A patch, or a part of one, with bounds of its derivatives.
#[derive(Clone, Debug)]
pub(super) struct Leaf {
    /// Its number in the surface.
    pub(super) number: usize,
    /// Where it begins in the patch, and how far it goes.
    from: [f64; 2],
    size: [f64; 2],
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
    /// A patch, in parts where its weights are uneven.
    pub(super) fn all(number: usize, patch: &Patch) -> Vec<Self> {
        let mut open = vec![([0.0; 2], [1.0; 2], patch.clone())];
        let mut done: Vec<Self> = Vec::new();
        while let Some((from, size, patch)) = open.pop() {
            let full = done.len() + open.len() + 1 >= PARTS;
            let Some(k) = uneven(&patch).filter(|k| !full && size[*k] > LEAST) else {
                done.push(Self::new(number, (from, size), patch));
                continue;
            };
            for half in [[0.5, 1.0], [0.0, 0.5]] {
                let (mut from, mut size, mut of) = (from, size, [[0.0, 1.0]; 2]);
                from[k] += half[0] * size[k];
                (size[k], of[k]) = (0.5 * size[k], half);
                open.push((from, size, patch.part(of[0], of[1])));
            }
        }
        done
    }

    /// Parameters of the patch for its own.
    pub(super) fn of_patch(&self, uv: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| self.from[k] + self.size[k] * uv[k])
    }

    fn new(number: usize, (from, size): ([f64; 2], [f64; 2]), patch: Patch) -> Self {
        let [lo, hi] = patch.bounds();
        let center = (lo + hi) * 0.5;
        let radius =
            patch.net.iter().flatten().map(|h| (h.xyz() / h.w - center).norm()).fold(0.0, f64::max);
        let bends = Bends::of(&patch, center, radius);
        let levels = [Level::default(); KEPT + 1];
        Self { number, from, size, patch, bends, center, radius, levels, depth: 0 }
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

/// The parameter along which the weights of a patch are the most uneven, if they are.
fn uneven(patch: &Patch) -> Option<usize> {
    let times = |row: &[Vec4; 4]| {
        let of = |pick: fn(f64, f64) -> f64| row.iter().map(|h| h.w).reduce(pick).unwrap_or(1.0);
        of(f64::max) / of(f64::min)
    };
    let [u, v] = [patch, &patch.exchanged()].map(|p| p.net.iter().map(times).fold(1.0, f64::max));
    (u.max(v) > UNEVEN).then_some(usize::from(v > u))
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
