//! SSURF: the cells are its patches, cut in four where they are few.

use aptc_geometry::sculpt::{Derivatives, Layout, Patch};
use aptc_geometry::sculptured::SurfaceDefinition;
use aptc_geometry::surface::{Continued, continued};
use aptc_geometry::{Sculptured, Vec3};

use super::bend::{Bend, of_patch};
use super::patched::{Cells, Grid, Side};
use super::powers::Powers;

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
    /// Of each patch whether it closes a hole and is none of the surface; none do of one with its continuation.
    holes: Vec<bool>,
}

/// The patch of a cell: its number, where it begins and how fast its parameters run.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Own {
    patch: usize,
    from: [f64; 2],
    rate: [f64; 2],
}

impl Sculpted {
    /// The surface of a definition with its straight continuation, over 0 to 1.
    pub(crate) fn with_continuation(definition: &SurfaceDefinition) -> Option<(Self, Grid)> {
        Some(Self::reaching(&continued(definition)?))
    }

    /// A surface with its straight continuation.
    pub(crate) fn reaching(whole: &Continued) -> (Self, Grid) {
        let spans = whole.surface.spans();
        let (mut cells, mut grid) = Self::new(&whole.surface);
        cells.holes.clear();
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
            Layout::Patches if surface.patches.len() == 1 => ([whole(1), whole(1)], None),
            Layout::Patches => ([whole(surface.patches.len()), whole(1)], Some(cut)),
        };
        let columns = knots[0].len() - 1;
        let sides = [0, 1].map(|k| Side {
            knots: halved(&knots[k], cut),
            before: None,
            behind: None,
            loose: loose.filter(|_| k == 0),
        });
        let holes = (0..surface.patches.len()).map(|k| surface.is_hole(k)).collect();
        let cells = Self { patches: surface.patches.clone(), columns, cut, knots, holes };
        (cells, Grid { sides })
    }

    /// Is a cell, or what goes on from it beyond the ends that are given, none of the surface?
    pub(crate) fn is_nothing(&self, [i, j]: [usize; 2], beyond: [Option<usize>; 2]) -> bool {
        let at = j / self.cut * self.columns + i / self.cut;
        let ends = |k: usize| beyond[k].is_some_and(|end| self.patch(i, j).0.ends_in_point(k, end));
        self.holes.get(at).is_some_and(|hole| *hole) || (0..2).any(ends)
    }

    /// Does a cell end by the parameter `k` where its patch does?
    pub(crate) fn is_corner(&self, cell: [usize; 2], k: usize, end: usize) -> bool {
        (cell[k] + end).is_multiple_of(self.cut)
    }

    /// How far any place of the border between two cells, at the end of the first by the parameter `k`, lies from the border of the other
    /// at most; `None` where weights differ along it.
    ///
    /// On a short part of the border, c being the direction of its chord, the way from a place to that of the other with the same parameter
    /// goes by `across` from c at most and by `along` along it: so much do the control points of both. To come back along c the other's
    /// parameter changes by no more than `along` over its least derivative along c, which takes it from c by that times its greatest
    /// derivative square to c; both are bounded by its control points on the part and as far again on both sides. At the ends of the
    /// border, beyond which it does not go, both begin in one place but for `ends`.
    pub(crate) fn apart(&self, cells: [[usize; 2]; 2], k: usize, end: usize) -> Option<f64> {
        /// Parts of the border of a cell.
        const PARTS: u32 = 16;
        let border = |[i, j]: [usize; 2], end: usize| {
            let patch = self.patch(i, j).0;
            let at = 3 * end;
            let row =
                [0, 1, 2, 3].map(|n| if k == 0 { patch.net[n][at] } else { patch.net[at][n] });
            let even = row.iter().all(|h| (h.w - row[0].w).abs() <= 1e-12 * row[0].w.abs());
            even.then(|| row.map(|h| h.xyz() / h.w))
        };
        let (a, b) = border(cells[0], end).zip(border(cells[1], 1 - end))?;
        let gap = |n: usize| (a[n] - b[n]).norm();
        let ends = gap(0).max(gap(3));
        let width = 1.0 / (self.cut as f64 * f64::from(PARTS));
        let first = (cells[0][1 - k] % self.cut) as f64 / self.cut as f64;
        let mut most = 0.0_f64;
        for n in 0..PARTS {
            let from = first + f64::from(n) * width;
            let [p, q] = [a, b].map(|row| cut_out(row, [from, from + width]));
            let far = [(from - width).max(0.0), (from + 2.0 * width).min(1.0)];
            let wide = cut_out(b, far);
            let slopes = [0, 1, 2].map(|i| (wide[i + 1] - wide[i]) * (3.0 / (far[1] - far[0])));
            let plain = (0..4).map(|i| (p[i] - q[i]).norm()).fold(0.0, f64::max);
            let Some(c) = (p[3] - p[0]).try_normalize(0.0) else {
                most = most.max(plain);
                continue;
            };
            let square = |w: Vec3| (w - c * w.dot(&c)).norm();
            let across = (0..4).map(|i| square(p[i] - q[i])).fold(0.0, f64::max);
            let along = (0..4).map(|i| (p[i] - q[i]).dot(&c).abs()).fold(0.0, f64::max);
            let least = slopes.iter().map(|s| s.dot(&c)).fold(f64::INFINITY, f64::min);
            let aside = slopes.iter().map(|s| square(*s)).fold(0.0, f64::max);
            let fits = least > 0.0 && along <= least * width;
            let told = if fits { across + along * aside / least } else { plain };
            most = most.max(told.min(plain));
        }
        Some(most + ends)
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

    /// Are two cells parts of one patch?
    pub(crate) fn is_one_patch(&self, one: [usize; 2], other: [usize; 2]) -> bool {
        (0..2).all(|k| one[k] / self.cut == other[k] / self.cut)
    }

    /// The patch of a cell.
    pub(crate) fn own(&self, [i, j]: [usize; 2]) -> Own {
        let (i, j) = (i / self.cut, j / self.cut);
        let [u, v] = &self.knots;
        let rate = [1.0 / (u[i + 1] - u[i]), 1.0 / (v[j + 1] - v[j])];
        Own { patch: j * self.columns + i, from: [u[i], v[j]], rate }
    }

    /// Point and derivatives at a place of a cell with that patch.
    #[inline]
    pub(crate) fn on(&self, own: &Own, [u, v]: [f64; 2]) -> Derivatives {
        let Own { patch, from, rate: [a, b] } = own;
        self.patches[*patch].at((u - from[0]) * a, (v - from[1]) * b).rated(*a, *b)
    }

    /// A cell with that patch by powers from its middle, where it has them.
    pub(super) fn powers(&self, own: &Own, middle: [f64; 2]) -> Option<Powers> {
        Powers::new(&self.patches[own.patch], own.from, own.rate, middle)
    }

    /// The patch of a cell with where it begins and how fast its parameters run.
    fn patch(&self, i: usize, j: usize) -> (&Patch, [f64; 2], [f64; 2]) {
        let Own { patch, from, rate } = self.own([i, j]);
        (&self.patches[patch], from, rate)
    }
}

impl Cells for Sculpted {
    fn at(&self, i: usize, j: usize, u: f64, v: f64) -> Derivatives {
        self.on(&self.own([i, j]), [u, v])
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

/// The control points of a part of a cubic.
fn cut_out(row: [Vec3; 4], [from, to]: [f64; 2]) -> [Vec3; 4] {
    // By its polar form: the parameters that a control point has.
    let polar = |t: [f64; 3]| {
        let mut p = row;
        for (k, t) in t.into_iter().enumerate() {
            for i in 0..3 - k {
                p[i] = p[i] * (1.0 - t) + p[i + 1] * t;
            }
        }
        p[0]
    };
    [[from; 3], [from, from, to], [from, to, to], [to; 3]].map(polar)
}

/// Rising numbers with `cut` steps between two of them.
pub(super) fn halved(knots: &[f64], cut: usize) -> Vec<f64> {
    let mut out = vec![knots[0]];
    for w in knots.windows(2) {
        out.extend((1..=cut).map(|k| w[0] + (w[1] - w[0]) * (k as f64 / cut as f64)));
    }
    out
}
