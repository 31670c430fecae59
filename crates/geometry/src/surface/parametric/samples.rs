//! The samples of a ruled surface or a polyconic, and the lowest of them, where a search for the nearest point begins.

use super::Patch;
use crate::Vec3;

/// Places from which the nearest point is looked for.
const SEEDS: usize = 4;

/// A grid of places, from end to end. A sculptured surface, which is looked at by its cells, has none.
#[derive(Clone, Debug, Default)]
pub(super) struct Samples {
    /// Parameters of the grid.
    pub(super) us: Vec<f64>,
    pub(super) vs: Vec<f64>,
    /// The places, all `v` of the first `u` first.
    pub(super) grid: Vec<Vec3>,
    /// Greatest distance of each sample from those beside it: no place that belongs to it is farther off.
    apart: Vec<f64>,
    /// Of a ruled surface the sampled rulings.
    pub(super) columns: Vec<Column>,
}

/// A sampled ruling.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column {
    /// Its start, the way to its end, and one over the square of that.
    pub(super) start: Vec3,
    pub(super) way: Vec3,
    pub(super) inverse: f64,
}

/// Where a search for the nearest point begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seed {
    /// Square of its distance from the point.
    pub(super) square: f64,
    pub(super) u: f64,
    pub(super) v: f64,
    /// Its sample.
    at: usize,
}

impl Samples {
    /// Those at the parameters `us` and `vs`; the ends of the domain across are put in. `None` where a place is none.
    pub(super) fn new(patch: &Patch, us: Vec<f64>, mut vs: Vec<f64>) -> Option<Self> {
        let domain = patch.domain();
        vs.retain(|v| *v > domain.v[0] && *v < domain.v[1]);
        vs.insert(0, domain.v[0]);
        vs.push(domain.v[1]);
        let mut grid = Vec::with_capacity(us.len() * vs.len());
        for u in &us {
            for v in &vs {
                let s = patch.jet(*u, *v).s;
                if !s.iter().all(|x| x.is_finite()) {
                    return None;
                }
                grid.push(s);
            }
        }
        let apart = (0..grid.len()).map(|k| apart(patch, &grid, vs.len(), k)).collect();
        let ruled = matches!(patch, Patch::Ruled(_));
        let columns = grid.chunks_exact(vs.len()).filter(|_| ruled).map(Column::new).collect();
        Some(Self { us, vs, grid, apart, columns })
    }

    /// Greatest distance from the origin of those between the ends of the surface.
    pub(super) fn extent(&self) -> f64 {
        let inside = |x: &f64| (0.0..=1.0).contains(x);
        let rows = self.us.iter().zip(self.grid.chunks_exact(self.vs.len()));
        let rows = rows.filter(|(u, _)| inside(u));
        let all = rows.flat_map(|(_, row)| self.vs.iter().zip(row).filter(|(v, _)| inside(v)));
        all.map(|(_, s)| s.norm()).fold(0.0, f64::max)
    }

    /// The lowest of them, those on rulings or those of the grid.
    pub(super) fn seeds(&self, patch: &Patch, p: Vec3) -> [Option<Seed>; SEEDS] {
        match patch {
            Patch::Ruled(_) => self.lowest_rulings(patch.domain().v, p),
            Patch::Polyconic(_) | Patch::Sculptured(_) => self.lowest(p),
        }
    }

    /// No place that belongs to the sample of a seed is nearer.
    #[inline]
    pub(super) fn least(&self, seed: &Seed) -> f64 {
        seed.square.sqrt() - self.apart[seed.at]
    }

    /// On a ruling the nearest point is known: the lowest of the sampled rulings.
    fn lowest_rulings(&self, ends: [f64; 2], p: Vec3) -> [Option<Seed>; SEEDS] {
        let mut found = [None; SEEDS];
        let seed = |i: usize, square: f64| {
            let v = ends[0] + (ends[1] - ends[0]) * self.columns[i].along(p);
            Seed { square, u: self.us[i], v, at: i * self.vs.len() }
        };
        // The one before with what came before it, until it is known whether the next is lower.
        let (mut before, mut last) = (f64::INFINITY, f64::INFINITY);
        for (i, column) in self.columns.iter().enumerate() {
            let square = (p - column.start - column.way * column.along(p)).norm_squared();
            if i > 0 && last <= before && last <= square {
                offer(&mut found, seed(i - 1, last));
            }
            (before, last) = (last, square);
        }
        if last <= before && !self.columns.is_empty() {
            offer(&mut found, seed(self.columns.len() - 1, last));
        }
        found
    }

    /// The lowest samples of the grid that are lower than their neighbours.
    fn lowest(&self, p: Vec3) -> [Option<Seed>; SEEDS] {
        let n = self.vs.len();
        let squares: Vec<f64> = self.grid.iter().map(|s| (s - p).norm_squared()).collect();
        let mut found = [None; SEEDS];
        for i in 0..self.us.len() {
            for j in 0..n {
                let here = squares[i * n + j];
                let lower =
                    |i: usize, j: usize| i < self.us.len() && j < n && squares[i * n + j] < here;
                let (up, left) = (i.wrapping_sub(1), j.wrapping_sub(1));
                if !(lower(up, j) || lower(i + 1, j) || lower(i, left) || lower(i, j + 1)) {
                    offer(&mut found, self.seed(here, i * n + j));
                }
            }
        }
        found
    }

    fn seed(&self, square: f64, at: usize) -> Seed {
        let n = self.vs.len();
        Seed { square, u: self.us[at / n], v: self.vs[at % n], at }
    }
}

impl Column {
    fn new(row: &[Vec3]) -> Self {
        let start = row[0];
        let way = row[row.len() - 1] - start;
        Self { start, way, inverse: 1.0 / way.norm_squared() }
    }

    /// The share of it at which it is nearest to `p`.
    #[inline]
    fn along(&self, p: Vec3) -> f64 {
        ((p - self.start).dot(&self.way) * self.inverse).clamp(0.0, 1.0)
    }
}

/// Greatest distance of a sample from those beside it; on rulings, which are straight, from the next rulings.
fn apart(patch: &Patch, grid: &[Vec3], n: usize, k: usize) -> f64 {
    let to = |other: Option<usize>| {
        other.and_then(|o| grid.get(o)).map_or(0.0, |s: &Vec3| (s - grid[k]).norm())
    };
    let along = to(k.checked_sub(n)).max(to(Some(k + n)));
    if matches!(patch, Patch::Ruled(_)) {
        return along;
    }
    let left = (!k.is_multiple_of(n)).then(|| k - 1);
    let right = (k % n + 1 < n).then(|| k + 1);
    along + to(left).max(to(right))
}

/// Keeps the lowest few.
fn offer(found: &mut [Option<Seed>; SEEDS], new: Seed) {
    let mut new = Some(new);
    for slot in found {
        if new.is_some_and(|n| slot.is_none_or(|s| n.square < s.square)) {
            std::mem::swap(slot, &mut new);
        }
    }
}

/// 0 to 1 in `n` equal steps, the ends of the domain and a sample halfway to each.
pub(super) fn halfway(ends: [f64; 2], n: u32) -> Vec<f64> {
    let mut all = vec![ends[0], 0.5 * ends[0]];
    all.extend(steps(n));
    all.extend([0.5 * (1.0 + ends[1]), ends[1]]);
    all
}

/// 0 to 1 in `n` equal steps.
pub(super) fn steps(n: u32) -> Vec<f64> {
    (0..=n).map(|i| f64::from(i) / f64::from(n)).collect()
}
