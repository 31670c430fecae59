//! Places on every curve in which a plane meets a patch: the roots on the sides of cells in which no curve closes.

use super::MeetFault;
use super::cells::Budget;
use super::trace::Uvs;
use crate::Vec3;
use crate::sculpt::Patch;

/// Halvings of a patch at most.
const DEEPEST: u32 = 14;
/// Halvings of a side at most: then it is as short as numbers are exact.
const HALVINGS: u32 = 50;
/// Roots of a side so near to each other are one.
const NEAR: f64 = 1e-12;
/// Share of the size of numbers to which heights are known.
const NOISE: f64 = 4e-16;

/// Heights above the plane, times the weights, by their control values: rows run along u.
type Heights = [[f64; 4]; 4];

/// A part of the patch.
struct Cell {
    heights: Heights,
    /// Where it begins, and how wide it is.
    from: [f64; 2],
    wide: f64,
    depth: u32,
}

/// Places on all curves in which the patch is at the level along the normal, but for loops smaller than `least`.
///
/// A cell in which the heights rise in one direction everywhere holds no place with a level tangent plane, so that no
/// curve closes within it: each one comes in and goes out over its sides.
pub(super) fn starts(
    patch: &Patch,
    (normal, level): (Vec3, f64),
    least: f64,
    budget: &mut Budget,
) -> Result<Vec<Uvs>, MeetFault> {
    let heights = patch.net.map(|row| row.map(|h| normal.dot(&h.xyz()) - level * h.w));
    let [lo, hi] = patch.bounds();
    let size = (hi - lo).norm();
    let numbers = patch.net.iter().flatten().map(|h| h.xyz().norm() + level.abs() * h.w);
    let noise = NOISE * numbers.fold(0.0, f64::max);
    let mut found = Vec::new();
    let mut stack = vec![Cell { heights, from: [0.0; 2], wide: 1.0, depth: 0 }];
    while let Some(cell) = stack.pop() {
        budget.spend()?;
        if of_one_sign(cell.heights.as_flattened()) {
            continue;
        }
        let small = cell.depth >= DEEPEST || cell.wide * size <= least;
        if small || rises(&cell.heights) || rises(&turned(&cell.heights)) {
            cell.sides(noise, &mut found);
            if small {
                found.push(cell.place(0.5, 0.5));
            }
            continue;
        }
        cell.split(&mut stack);
    }
    Ok(found)
}

impl Cell {
    fn place(&self, s: f64, t: f64) -> Uvs {
        [[0.0; 2], [self.from[0] + self.wide * s, self.from[1] + self.wide * t]]
    }

    /// Where its sides are at the level.
    fn sides(&self, noise: f64, found: &mut Vec<Uvs>) {
        let across = turned(&self.heights);
        for (end, share) in [(0, 0.0), (3, 1.0)] {
            let along_u = roots(self.heights[end], noise);
            found.extend(along_u.into_iter().map(|s| self.place(s, share)));
            let along_v = roots(across[end], noise);
            found.extend(along_v.into_iter().map(|t| self.place(share, t)));
        }
    }

    fn split(&self, stack: &mut Vec<Self>) {
        let (wide, depth) = (0.5 * self.wide, self.depth + 1);
        let halves = |h: &Heights| {
            let parts = h.map(halved);
            [0, 1].map(|k| parts.map(|p| p[k]))
        };
        for (i, h) in halves(&turned(&self.heights)).iter().enumerate() {
            for (j, heights) in halves(&turned(h)).into_iter().enumerate() {
                let at = |k: usize, half: usize| self.from[k] + if half == 1 { wide } else { 0.0 };
                stack.push(Self { heights, from: [at(0, j), at(1, i)], wide, depth });
            }
        }
    }
}

fn of_one_sign(all: &[f64]) -> bool {
    all.iter().all(|x| *x > 0.0) || all.iter().all(|x| *x < 0.0)
}

/// Do the heights rise, or fall, along all rows?
fn rises(heights: &Heights) -> bool {
    let ways = heights.map(|[a, b, c, d]| [b - a, c - b, d - c]);
    of_one_sign(ways.as_flattened())
}

fn turned(h: &Heights) -> Heights {
    std::array::from_fn(|i| std::array::from_fn(|j| h[j][i]))
}

/// The control values of both halves of a cubic.
fn halved([a, b, c, d]: [f64; 4]) -> [[f64; 4]; 2] {
    let [ab, bc, cd] = [0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + d)];
    let [abc, bcd] = [0.5 * (ab + bc), 0.5 * (bc + cd)];
    let middle = 0.5 * (abc + bcd);
    [[a, ab, abc, middle], [middle, bcd, cd, d]]
}

/// Where a cubic is 0; of a stretch on which it is but noise the ends and the middle.
fn roots(side: [f64; 4], noise: f64) -> Vec<f64> {
    let is_noise = |c: &[f64; 4]| c.iter().all(|x| x.abs() <= noise);
    if is_noise(&side) {
        return vec![0.0, 0.5, 1.0];
    }
    let mut found = Vec::new();
    let mut stack = vec![(side, 0.0, 1.0, HALVINGS)];
    while let Some((part, from, wide, left)) = stack.pop() {
        if of_one_sign(&part) {
            continue;
        }
        let half = 0.5 * wide;
        if left == 0 || is_noise(&part) {
            found.push(from + half);
            continue;
        }
        let [a, b] = halved(part);
        stack.push((a, from, half, left - 1));
        stack.push((b, from + half, half, left - 1));
    }
    found.sort_by(f64::total_cmp);
    found.dedup_by(|a, b| (*a - *b).abs() <= NEAR);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_cubics() {
        let near = |side: [f64; 4], expected: &[f64]| {
            let found = roots(side, 1e-16);
            assert_eq!(found.len(), expected.len(), "{found:?}");
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
        };
        near([1.0, 1.0, 1.0, 1.0], &[]);
        near([-1.0, -1.0, 0.0, 2.0], &[0.577_350_269_189_6]);
        near([0.0, 1.0, 1.0, 0.0], &[0.0, 1.0]);
        near([0.0; 4], &[0.0, 0.5, 1.0]);
        // (t - .25)(t - .5)(t - .75).
        near(
            [-0.09375, 0.135_416_666_666_666_67, -0.135_416_666_666_666_67, 0.09375],
            &[0.25, 0.5, 0.75],
        );
    }
}
