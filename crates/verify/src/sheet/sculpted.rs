//! SSURF: the cells are its patches, cut in four where they are few.

use aptc_geometry::sculpt::{Derivatives, Layout, Patch};
use aptc_geometry::sculptured::SurfaceDefinition;
use aptc_geometry::surface::{Continued, continued};
use aptc_geometry::{Sculptured, Vec3};

use super::bend::{Bend, of_patch};
use super::patched::{Cells, Grid, Side};

/// Up to so many patches each is cut into four cells by both parameters, or into two: bounds are constant over a cell.
const FEW: usize = 40;
const MORE: usize = 400;

/// The patches of a sculptured surface.
#[derive(Clone, Debug)]
pub(crate) struct Sculpted {
    patches: Vec<Patch>,
    columns: usize,
    /// Cells along each side of a patch.
    cut: usize,
    /// Borders of the patches.
    knots: [Vec<f64>; 2],
}

impl Sculpted {
    /// The surface of a definition with its straight continuation, over 0 to 1.
    pub(crate) fn with_continuation(definition: &SurfaceDefinition) -> Option<(Self, Grid)> {
        Some(Self::reaching(&continued(definition)?))
    }

    /// A surface with its straight continuation.
    pub(crate) fn reaching(whole: &Continued) -> (Self, Grid) {
        let spans = whole.surface.spans();
        let (cells, mut grid) = Self::new(&whole.surface);
        // There the parameters run from 0 to 1.
        for (k, range) in [whole.u, whole.v].into_iter().enumerate() {
            let side = &mut grid.sides[k];
            side.before = (range[0] < 0.0).then(|| range[0] * spans[k]);
            side.behind = (range[1] > 1.0).then(|| range[1] * spans[k]);
        }
        (cells, grid)
    }

    /// The surface alone.
    pub(crate) fn new(surface: &Sculptured) -> (Self, Grid) {
        let cut = match surface.patches.len() {
            n if n <= FEW => 4,
            n if n <= MORE => 2,
            _ => 1,
        };
        let whole = |n: usize| (0..=n).map(|k| k as f64).collect::<Vec<_>>();
        let (knots, loose) = match &surface.layout {
            Layout::Mesh { u, v } => ([u.clone(), v.clone()], None),
            Layout::Patches => ([whole(surface.patches.len()), whole(1)], Some(cut)),
        };
        let columns = knots[0].len() - 1;
        let sides = [0, 1].map(|k| Side {
            knots: halved(&knots[k], cut),
            before: None,
            behind: None,
            loose: loose.filter(|_| k == 0),
        });
        let cells = Self { patches: surface.patches.clone(), columns, cut, knots };
        (cells, Grid { sides })
    }

    /// Is the border of the patch of a cell one point?
    pub(crate) fn ends_in_point(&self, [i, j]: [usize; 2], k: usize, end: usize) -> bool {
        self.patch(i, j).0.ends_in_point(k, end)
    }

    /// How far apart places with one parameter lie at most along the border between two cells, at the end of the first by the
    /// parameter `k`; `None` where weights differ along it.
    pub(crate) fn apart(&self, cells: [[usize; 2]; 2], k: usize, end: usize) -> Option<f64> {
        let border = |[i, j]: [usize; 2], end: usize| {
            let patch = self.patch(i, j).0;
            let at = 3 * end;
            let row =
                [0, 1, 2, 3].map(|n| if k == 0 { patch.net[n][at] } else { patch.net[at][n] });
            let even = row.iter().all(|h| (h.w - row[0].w).abs() <= 1e-12 * row[0].w.abs());
            even.then(|| row.map(|h| h.xyz() / h.w))
        };
        let (a, b) = border(cells[0], end).zip(border(cells[1], 1 - end))?;
        Some(a.iter().zip(&b).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max))
    }

    /// How far the unit normals over a part of a cell, or of what goes on from it, stand from a unit vector at most.
    pub(crate) fn normals(&self, [i, j]: [usize; 2], range: [[f64; 2]; 2], n: Vec3) -> Option<f64> {
        /// So near to a border of the patch counts as there.
        const NEAR: f64 = 1e-12;
        let (patch, from, rate) = self.patch(i, j);
        let [u, v] = [0, 1].map(|k| {
            let snap = |x: f64| if (x - x.round()).abs() < NEAR { x.round() } else { x };
            range[k].map(|x| snap((x - from[k]) * rate[k]))
        });
        patch.normals_about(n, u, v)
    }

    /// The patch of a cell with where it begins and how fast its parameters run.
    fn patch(&self, i: usize, j: usize) -> (&Patch, [f64; 2], [f64; 2]) {
        let (i, j) = (i / self.cut, j / self.cut);
        let [u, v] = &self.knots;
        let rate = [1.0 / (u[i + 1] - u[i]), 1.0 / (v[j + 1] - v[j])];
        (&self.patches[j * self.columns + i], [u[i], v[j]], rate)
    }
}

impl Cells for Sculpted {
    fn at(&self, i: usize, j: usize, u: f64, v: f64) -> Derivatives {
        let (patch, from, [a, b]) = self.patch(i, j);
        patch.at((u - from[0]) * a, (v - from[1]) * b).rated(a, b)
    }

    fn bend(&self, i: usize, j: usize) -> Bend {
        let (patch, _, [a, b]) = self.patch(i, j);
        let n = self.cut as f64;
        let part = |k: usize| {
            let from = (k % self.cut) as f64 / n;
            [from, from + 1.0 / n]
        };
        of_patch(&patch.part(part(i), part(j))).rated(a * n, b * n)
    }
}

/// Rising numbers with `cut` steps between two of them.
pub(super) fn halved(knots: &[f64], cut: usize) -> Vec<f64> {
    let mut out = vec![knots[0]];
    for w in knots.windows(2) {
        out.extend((1..=cut).map(|k| w[0] + (w[1] - w[0]) * (k as f64 / cut as f64)));
    }
    out
}
