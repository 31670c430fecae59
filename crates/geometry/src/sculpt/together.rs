//! Loose patches that lie side by side, as one grid, however each is turned.
//!
//! Meshes through the same points rarely have the same border to the last digit: the tangents of a mesh are as long as the mean of its
//! chords, and both have other means. So borders count as one whose ends are in one place and that nowhere part by more than a small share
//! of their length; each patch stays what it is, and the grid has a crack there that is as narrow. What is missing of a rectangle, as of an L,
//! is closed by patches that go on smoothly: they count as the continuation of the surface beyond its borders.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::arc::Vec4;
use super::patch::Patch;
use super::surface::{Layout, Sculptured};
use super::whole;
use crate::Vec3;

/// Ends of borders that are no farther apart than this share of the surface's size are in one place.
const SAME: f64 = 1e-6;
/// Share of its length by which a border may part from the one that it is joined to, and by which places of both with one parameter
/// may: tangents of meshes differ in length more than borders part.
const CRACK: f64 = 1e-4;
const SHIFT: f64 = 1e-2;
/// Cosine of the directions into both patches above which one goes back under the other.
const FOLD: f64 = 0.5;
/// Share of a patch at which the direction into it is taken.
const INTO: f64 = 0.05;
/// Rounds to the nearest place of a border.
const ROUNDS: u32 = 24;
/// Cells of a grid for each patch at most.
const MOST: usize = 4;
/// Places along a border at which it is held against others.
const PLACES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// What a cell of a grid was before it was put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    /// The number of the loose patch.
    patch: usize,
    /// Does its u run along the v of the grid?
    exchanged: bool,
    /// Does it run back along u and v of the grid?
    back: [bool; 2],
}

/// A border of a patch: its patch, the parameter that is constant along it, at which end, and places along it.
struct Side {
    patch: usize,
    axis: usize,
    end: usize,
    at: [Vec3; 5],
}

/// What is beside a border: the border of another patch with this patch, axis and end, and whether it runs the other way.
type Beside = ([usize; 3], bool);

impl Origin {
    const FIRST: Self = Self { patch: 0, exchanged: false, back: [false; 2] };

    /// The parameter of the grid along which that of the patch runs, and the other way about.
    fn along(&self, axis: usize) -> usize {
        if self.exchanged { 1 - axis } else { axis }
    }

    /// Is the normal of the patch against that of the grid?
    fn is_mirrored(&self) -> bool {
        self.exchanged ^ self.back[0] ^ self.back[1]
    }

    /// The parameter of the grid across a border of the patch, and whether it rises outwards.
    fn outwards(&self, axis: usize, end: usize) -> (usize, bool) {
        let grid = self.along(axis);
        (grid, (end == 1) ^ self.back[grid])
    }

    /// How the patch lies that is beside a border of this one.
    fn next(&self, axis: usize, end: usize, ([patch, other, other_end], turned): Beside) -> Self {
        let (grid, rises) = self.outwards(axis, end);
        let exchanged = other != grid;
        let mut back = [false; 2];
        // Outwards of the other is inwards here.
        back[grid] = (other_end == 1) == rises;
        back[1 - grid] = self.back[1 - grid] ^ turned;
        Self { patch, exchanged, back }
    }

    /// Parameters of the patch for those of the cell.
    fn own(&self, cell: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| {
            let grid = self.along(axis);
            if self.back[grid] { 1.0 - cell[grid] } else { cell[grid] }
        })
    }

    /// Parameters of the cell for those of the patch.
    fn in_cell(&self, own: [f64; 2]) -> [f64; 2] {
        let mut cell = [0.0; 2];
        for (axis, at) in own.into_iter().enumerate() {
            let grid = self.along(axis);
            cell[grid] = if self.back[grid] { 1.0 - at } else { at };
        }
        cell
    }

    /// The patch as it lies in the grid.
    fn laid(&self, patch: &Patch) -> Patch {
        let index = |grid: usize, i: usize| if self.back[grid] { 3 - i } else { i };
        Patch::new(core::array::from_fn(|j| {
            core::array::from_fn(|i| {
                let cell = [index(0, i), index(1, j)];
                let [u, v] = [0, 1].map(|axis| cell[self.along(axis)]);
                patch.net[v][u]
            })
        }))
    }
}

impl Sculptured {
    /// Loose patches that fit together into a rectangle, or a part of one, as one grid with the directions and the normals of the first;
    /// `None` when they do not, and of a grid.
    #[must_use]
    pub fn together(&self) -> Option<Self> {
        if !matches!(self.layout, Layout::Patches) || self.patches.len() < 2 {
            return None;
        }
        let beside = self.beside()?;
        let n = self.patches.len();
        let mut placed: Vec<Option<([i32; 2], Origin)>> = vec![None; n];
        placed[0] = Some(([0, 0], Origin::FIRST));
        // Along rising parameters first: what goes round begins with the first.
        let mut ways = [Vec::new(), Vec::new()];
        let mut here = Some(0);
        while let Some(i) = here {
            let (place, origin) = placed[i]?;
            for (axis, end) in [(1, 1), (0, 1), (1, 0), (0, 0)] {
                let Some(other) = beside[4 * i + 2 * axis + end] else { continue };
                let (grid, rises) = origin.outwards(axis, end);
                let mut to = place;
                to[grid] += if rises { 1 } else { -1 };
                ways[usize::from(!rises)].push((to, origin.next(axis, end, other)));
            }
            here = None;
            while let Some((to, origin)) = ways[0].pop().or_else(|| ways[1].pop()) {
                if placed[origin.patch].is_none() {
                    placed[origin.patch] = Some((to, origin));
                    here = Some(origin.patch);
                    break;
                }
            }
        }
        let all: Vec<([i32; 2], Origin)> = placed.into_iter().collect::<Option<_>>()?;
        let low = [0, 1].map(|g| all.iter().map(|(p, _)| p[g]).min().unwrap_or(0));
        let count =
            |g: usize| usize::try_from(all.iter().map(|(p, _)| p[g] - low[g]).max()? + 1).ok();
        let (columns, rows) = (count(0)?, count(1)?);
        let cells_in_all = columns.checked_mul(rows)?;
        if cells_in_all > MOST * n {
            return None;
        }
        let mut cells: Vec<Option<Origin>> = vec![None; cells_in_all];
        for (place, origin) in &all {
            let [i, j] = [0, 1].map(|g| usize::try_from(place[g] - low[g]).unwrap_or(0));
            let cell = &mut cells[j * columns + i];
            if cell.replace(*origin).is_some() {
                return None;
            }
        }
        // What is side by side in the grid is so in space, and where the grid has holes the other way about.
        let mut joints = 0;
        for (k, cell) in cells.iter().enumerate() {
            let Some(cell) = cell else { continue };
            let next = [(k + 1) % columns != 0, k + columns < cells.len()];
            for grid in (0..2).filter(|g| next[*g]) {
                let Some(there) = &cells[k + if grid == 0 { 1 } else { columns }] else { continue };
                let axis = cell.along(grid);
                let end = usize::from(!cell.back[grid]);
                let other = beside[4 * cell.patch + 2 * axis + end]?;
                if *there != cell.next(axis, end, other) {
                    return None;
                }
                joints += 1;
            }
        }
        if n < cells.len() && beside.iter().flatten().count() != 2 * joints {
            return None;
        }
        let laid = |c: &Option<Origin>| c.as_ref().map(|c| c.laid(&self.patches[c.patch]));
        let patches = closed(cells.iter().map(laid).collect(), columns)?;
        let grid = Self::grid(patches, columns, rows).ok()?;
        Some(Self { origins: Some(cells.into()), ..grid })
    }

    /// Does the patch with this number close a hole of a grid that was put together? It is no part of the surface, which goes on there.
    pub fn is_hole(&self, patch: usize) -> bool {
        self.origins.as_ref().is_some_and(|all| all[patch].is_none())
    }

    /// Has it such patches?
    pub fn has_holes(&self) -> bool {
        self.origins.as_ref().is_some_and(|all| all.iter().any(Option::is_none))
    }

    /// Does a place lie in a patch that closes a hole?
    pub fn is_in_hole(&self, uv: [f64; 2]) -> bool {
        self.origins.as_ref().is_some_and(|all| all[self.local(uv).0].is_none())
    }

    /// Are normals of patches against those of the grid that they were put together to?
    pub fn is_mirrored(&self) -> bool {
        self.origins.iter().flat_map(|all| all.iter().flatten()).any(Origin::is_mirrored)
    }

    /// The parameters by which a place is told: of a grid that was put together those of the loose patches. Beyond a border those of the
    /// border.
    pub fn told(&self, uv: [f64; 2]) -> [f64; 2] {
        let Some(origins) = &self.origins else { return uv };
        let [columns, rows] = self.spans().map(whole);
        let at =
            |cell: usize| [(uv[0] - (cell % columns) as f64), (uv[1] - (cell / columns) as f64)];
        // Of what closes a hole the nearest place beside it.
        let cells = (0..columns * rows).filter_map(|k| Some((k, origins[k]?)));
        let off =
            |k: usize| at(k).map(|x| x - x.clamp(0.0, 1.0)).iter().map(|x| x * x).sum::<f64>();
        let found = match self.local(uv).0 {
            k if origins[k].is_some() => origins[k].map(|origin| (k, origin)),
            _ => cells.min_by(|a, b| off(a.0).total_cmp(&off(b.0))),
        };
        let Some((cell, origin)) = found else { return uv };
        let [u, v] = origin.own(at(cell)).map(|x| x.clamp(0.0, 1.0));
        let first = origin.patch as f64;
        // The end of a patch is the beginning of the next, which may be anywhere.
        let last = origin.patch + 1 == origins.iter().flatten().count();
        let u = if last { first + u } else { (first + u).min((first + 1.0).next_down()) };
        [u, v]
    }

    /// The parameters of a place that the loose patches tell in the grid that they were put together to; `None` of no patch.
    pub fn laid_at(&self, [u, v]: [f64; 2]) -> Option<[f64; 2]> {
        let Some(origins) = &self.origins else { return Some([u, v]) };
        let columns = whole(self.spans()[0]);
        let patch = whole(u).min(origins.iter().flatten().count().max(1) - 1);
        let mut cells = origins.iter().enumerate().filter_map(|(k, o)| Some((k, (*o)?)));
        let (cell, origin) = cells.find(|(_, o)| o.patch == patch)?;
        let [a, b] = origin.in_cell([u - patch as f64, v]);
        Some([(cell % columns) as f64 + a, (cell / columns) as f64 + b])
    }

    /// By which parameters of its loose patch a place in a cell of the grid is told, or on a border of it: the end of a patch has the
    /// number at which the next begins. `None` of what closes a hole.
    pub fn told_in(&self, [column, row]: [usize; 2], [u, v]: [f64; 2]) -> Option<[f64; 2]> {
        let Some(origins) = &self.origins else { return Some([u, v]) };
        let columns = whole(self.spans()[0]);
        let origin = (*origins.get(row * columns + column)?)?;
        let [a, b] = origin.own([u - column as f64, v - row as f64]);
        Some([origin.patch as f64 + a, b])
    }

    /// For each border of each patch (four each, by axis and end) what is beside it; `None` when there are several, as then the patches
    /// make no sheet.
    fn beside(&self) -> Option<Vec<Option<Beside>>> {
        let same = SAME * self.extent();
        let mut sides: Vec<Side> = Vec::new();
        for (patch, p) in self.patches.iter().enumerate() {
            for (axis, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let at = PLACES.map(|t| {
                    let border = end as f64;
                    if axis == 0 { p.point(border, t) } else { p.point(t, border) }
                });
                // A border that is one point is beside none.
                if at.iter().any(|x| (x - at[0]).norm() > same) {
                    sides.push(Side { patch, axis, end, at });
                }
            }
        }
        let middle = |s: &Side| 0.5 * (s.at[0].x + s.at[4].x);
        sides.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
        let mut found: Vec<Option<Beside>> = vec![None; 4 * self.patches.len()];
        for (k, a) in sides.iter().enumerate() {
            let long = a.at.windows(2).map(|w| (w[1] - w[0]).norm()).sum::<f64>();
            let alike = |b: &Side, turned: bool| {
                (0..5).all(|i| {
                    let most = if i % 4 == 0 { same } else { same.max(SHIFT * long) };
                    (a.at[i] - b.at[if turned { 4 - i } else { i }]).norm() <= most
                })
            };
            let near = sides[k + 1..].iter().take_while(|b| middle(b) - middle(a) <= same);
            for b in near {
                let turned = !alike(b, false);
                if turned && !alike(b, true) {
                    continue;
                }
                if self.parts(a, b, turned) > same.max(CRACK * long) || self.folds(a, b, turned) {
                    continue;
                }
                for (one, other) in [(a, b), (b, a)] {
                    let slot = &mut found[4 * one.patch + 2 * one.axis + one.end];
                    let there = ([other.patch, other.axis, other.end], turned);
                    if slot.replace(there).is_some() {
                        return None;
                    }
                }
            }
        }
        Some(found)
    }

    /// By how much a border parts from another, at some places.
    fn parts(&self, a: &Side, b: &Side, turned: bool) -> f64 {
        let apart = |i: usize| {
            let t = if turned { 1.0 - PLACES[i] } else { PLACES[i] };
            let away = |t: f64| (self.border(b, t) - a.at[i]).norm();
            let (mut low, mut high) = ((t - 0.1).max(0.0), (t + 0.1).min(1.0));
            for _ in 0..ROUNDS {
                let third = (high - low) / 3.0;
                if away(low + third) < away(high - third) { high -= third } else { low += third }
            }
            away(0.5 * (low + high))
        };
        (1..4).map(apart).fold(0.0, f64::max)
    }

    /// Goes one patch back under the other at a border of both? Then it is no sheet that a tool goes along.
    fn folds(&self, a: &Side, b: &Side, turned: bool) -> bool {
        let into = |s: &Side, t: f64| -> Option<Vec3> {
            let along = (s.at[4] - s.at[0]).try_normalize(0.0)?;
            let within = if s.end == 0 { INTO } else { 1.0 - INTO };
            let p = &self.patches[s.patch];
            let inner = if s.axis == 0 { p.point(within, t) } else { p.point(t, within) };
            let way = inner - self.border(s, t);
            (way - along * along.dot(&way)).try_normalize(0.0)
        };
        [0.25, 0.5, 0.75].into_iter().any(|t| {
            let ways = into(a, t).zip(into(b, if turned { 1.0 - t } else { t }));
            ways.is_none_or(|(m, n)| m.dot(&n) > FOLD)
        })
    }

    /// A place of a border.
    fn border(&self, s: &Side, t: f64) -> Vec3 {
        let p = &self.patches[s.patch];
        if s.axis == 0 { p.point(s.end as f64, t) } else { p.point(t, s.end as f64) }
    }
}

/// A grid of patches some of which are missing, each hole closed by one that goes on from those beside it: along their borders with their
/// derivatives across, elsewhere by the sum of both ways. `None` where nothing is beside a hole along both parameters, and of rational ones.
fn closed(mut cells: Vec<Option<Patch>>, columns: usize) -> Option<Vec<Patch>> {
    let rows = cells.len() / columns;
    while let Some(first) = cells.iter().position(Option::is_none) {
        let beside = |k: usize| -> [[Option<&Patch>; 2]; 2] {
            let (i, j) = (k % columns, k / columns);
            let at = |there: bool, k: usize| if there { cells[k].as_ref() } else { None };
            [
                [at(i > 0, k.wrapping_sub(1)), at(i + 1 < columns, k + 1)],
                [at(j > 0, k.wrapping_sub(columns)), at(j + 1 < rows, k + columns)],
            ]
        };
        let known = |k: &usize| {
            cells[*k].is_none() && beside(*k).iter().all(|ends| ends.iter().any(Option::is_some))
        };
        let k = (first..cells.len()).find(known)?;
        let made = closing(beside(k))?;
        cells[k] = Some(made);
    }
    cells.into_iter().collect()
}

/// The patch between those at the ends of u and v.
fn closing(beside: [[Option<&Patch>; 2]; 2]) -> Option<Patch> {
    if beside.iter().flatten().flatten().any(|p| p.rational) {
        return None;
    }
    // Control points by the way along u and across: the border itself, and the next row by going on straight.
    let mut on: [[Vec<Vec4>; 4]; 4] =
        core::array::from_fn(|_| core::array::from_fn(|_| Vec::new()));
    let mut near = on.clone();
    for (axis, ends) in beside.iter().enumerate() {
        for (end, patch) in ends.iter().enumerate() {
            let Some(patch) = patch else { continue };
            for n in 0..4 {
                // Of the other patch by how far from the border that both share.
                let of = |away: usize| {
                    let m = if end == 0 { 3 - away } else { away };
                    let h = if axis == 0 { patch.net[n][m] } else { patch.net[m][n] };
                    h / h.w
                };
                for (away, h) in [(0, of(0)), (1, of(0) * 2.0 - of(1))] {
                    let m = if end == 0 { away } else { 3 - away };
                    let (i, j) = if axis == 0 { (m, n) } else { (n, m) };
                    if away == 0 { on[j][i].push(h) } else { near[j][i].push(h) }
                }
            }
        }
    }
    let mean = |all: &[Vec4]| all.iter().sum::<Vec4>() / all.len() as f64;
    let mut net = [[Vec4::zeros(); 4]; 4];
    let flip = [0, 1].map(|axis| beside[axis][0].is_none());
    let at = |axis: usize, i: usize| if flip[axis] { 3 - i } else { i };
    for j in 0..4 {
        for i in 0..4 {
            let (x, y) = (at(0, i), at(1, j));
            net[y][x] = match (on[y][x].as_slice(), near[y][x].as_slice()) {
                ([], []) => {
                    let twist =
                        |f: &dyn Fn(usize, usize) -> Vec4| f(1, 1) - f(1, 0) - f(0, 1) + f(0, 0);
                    let of = |i: usize, j: usize| net[at(1, j)][at(0, i)];
                    let share = (i - 1) as f64 * (j - 1) as f64;
                    of(i, 1) + of(1, j) - of(1, 1) + twist(&of) * share
                }
                ([], near) => mean(near),
                (on, _) => mean(on),
            };
        }
    }
    Some(Patch::new(net))
}

/// What the cells of a grid were; those that close a hole were nothing.
pub(super) type Origins = Arc<[Option<Origin>]>;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sculpt::{SplinePoint, mesh};
    use crate::sculptured::MeshSpacing;
    use proptest::prelude::*;

    /// A patch of a wave over the unit square at i, j, its points and derivatives taken from the wave.
    fn patch(i: usize, j: usize) -> Patch {
        let z = |x: f64, y: f64| 0.3 * x * x - 0.2 * y * y + 0.1 * x * y;
        let at = |a: usize, b: usize| {
            let (x, y) = ((i + a) as f64, (j + b) as f64);
            (
                Vec3::new(x, y, z(x, y)),
                Vec3::new(1.0, 0.0, 0.6 * x + 0.1 * y),
                Vec3::new(0.0, 1.0, 0.1 * x - 0.4 * y),
            )
        };
        let twist = Vec3::z() * 0.1;
        let row = |b: usize| [at(0, b).0, at(1, b).0, at(0, b).1, at(1, b).1];
        let side = |b: usize| [at(0, b).2, at(1, b).2, twist, twist];
        Patch::hermite([row(0), row(1), side(0), side(1)])
    }

    proptest! {
        /// A grid whose patches are shuffled and turned is found again, with the directions of the first, and its places are told by
        /// the parameters of the loose patches.
        #[test]
        fn a_grid_is_found_again(
            columns in 1_usize..4, rows in 1_usize..4,
            turns in prop::collection::vec((any::<bool>(), any::<bool>(), any::<bool>()), 9),
            order in Just((0..9_usize).collect::<Vec<_>>()).prop_shuffle(),
            places in prop::collection::vec((0.0_f64..1.0, 0.0_f64..1.0), 12),
        ) {
            let n = columns * rows;
            prop_assume!(n > 1);
            let order: Vec<usize> = order.into_iter().filter(|k| *k < n).collect();
            let loose = order.iter().zip(&turns).map(|(k, (exchanged, a, b))| {
                let turn = Origin { patch: 0, exchanged: *exchanged, back: [*a, *b] };
                turn.laid(&patch(k % columns, k / columns))
            });
            let loose = Sculptured::loose(loose.collect()).unwrap();
            let grid = loose.together().expect("they lie side by side");
            let spans = grid.spans();
            prop_assert!((spans[0] * spans[1] - n as f64).abs() < 1e-12);
            for (a, b) in places {
                let uv = [a * spans[0], b * spans[1]];
                let [u, v] = grid.told(uv);
                let back = grid.laid_at([u, v]).unwrap();
                prop_assert!((0..2).all(|k| (back[k] - uv[k]).abs() < 1e-12), "{:?} {:?}", back, uv);
                let (there, here) = (loose.at(u, v), grid.at(uv[0], uv[1]));
                prop_assert!((there.point - here.point).norm() < 1e-12);
            }
            // The first keeps its directions and its normal.
            let mirrored = |t: &(bool, bool, bool)| t.0 ^ t.1 ^ t.2;
            let up = grid.normal_at(0.3, 0.3).unwrap().z > 0.0;
            prop_assert_eq!(up, !mirrored(&turns[0]));
            prop_assert_eq!(grid.is_mirrored(), turns[..n].iter().any(|t| mirrored(t) != mirrored(&turns[0])));
        }
    }

    #[test]
    fn what_is_no_rectangle_stays_loose() {
        let of = |all: &[(usize, usize)]| {
            Sculptured::loose(all.iter().map(|(i, j)| patch(*i, *j)).collect()).unwrap()
        };
        assert!(of(&[(0, 0), (1, 0), (2, 0)]).together().is_some());
        // A gap is between them, or three meet in one border.
        assert!(of(&[(0, 0), (2, 0)]).together().is_none());
        assert!(of(&[(0, 0), (1, 0), (1, 0)]).together().is_none());
    }

    /// A surface of the second degree goes on into the corner that an L leaves out as itself along its borders, and is smooth there.
    #[test]
    fn a_corner_that_is_missing_is_closed() {
        for missing in 0..4 {
            let cells = (0..4).filter(|k| *k != missing).map(|k| patch(k % 2, k / 2));
            let grid = Sculptured::loose(cells.collect()).unwrap().together().expect("an L");
            let [i, j] = [0, 1].map(|axis| {
                let at = [1, 0, 3, 2][missing];
                let found =
                    grid.patches.iter().position(|p| p.net == patch(at % 2, at / 2).net).unwrap();
                [found % 2, found / 2][axis]
            });
            // In the row of the hole, on its other side.
            let hole = 2 * j + (1 - i);
            assert!(grid.is_hole(hole) && grid.has_holes() && !grid.is_hole(3 - hole));
            let middle = [(1 - i) as f64 + 0.5, j as f64 + 0.5];
            assert!(grid.is_in_hole(middle));
            let n = grid.normal_at(middle[0], middle[1]).unwrap();
            assert!(n.z.abs() > 0.5, "{n}");
            for t in [0.1, 0.5, 0.9] {
                let [before, behind] =
                    [1.0 - 1e-9, 1.0 + 1e-9].map(|u| grid.normal_at(u, j as f64 + t).unwrap());
                assert!((before - behind).norm() < 1e-6);
            }
            // It is told by what is beside it.
            let [u, v] = grid.told(middle);
            assert!((0.0..=3.0).contains(&u) && (0.0..=1.0).contains(&v));
        }
    }

    /// Two meshes through the same points of a border have other tangents there, as the mean of their chords differs.
    #[test]
    fn meshes_through_the_same_points_are_joined() {
        let rows = |x: f64, z: [[f64; 3]; 3]| -> Vec<Vec<SplinePoint>> {
            let row = |j: usize| {
                let of = |i: usize| Vec3::new(x + 15.0 * i as f64, 20.0 * j as f64, z[j][i]);
                (0..3).map(|i| SplinePoint::plain(of(i))).collect()
            };
            (0..3).map(row).collect()
        };
        let a = rows(0.0, [[1.0, 3.0, 2.0], [3.0, 5.0, 3.0], [1.0, 4.0, 2.0]]);
        let b = rows(30.0, [[2.0, 3.0, 1.0], [3.0, 5.0, 2.0], [2.0, 4.0, 1.0]]);
        let [a, b] = [a, b].map(|rows| mesh(&rows, MeshSpacing::Xyz).unwrap());
        let both = Sculptured::combined(&[b, a]).unwrap();
        let grid = both.together().expect("side by side");
        assert_eq!(grid.patches.len(), 8);
        let [left, right] =
            [1.999_999_999, 2.000_000_001].map(|u| grid.at(u - 2.0 + 2.0, 0.3).point);
        assert!((left - right).norm() < 1e-2);
    }
}
