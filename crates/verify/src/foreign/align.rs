//! Two sequences brought together.

use aptc_geometry::Vec3;

use super::Point;

/// Cells of a table; beyond it the comparison would need gigabytes.
const MOST_CELLS: usize = 40_000_000;

const TOO_LONG: &str = "the file is too long to be matched without statement numbers";

/// The longest common subsequence, as pairs of indices.
pub(crate) fn common(a: &[u32], b: &[u32]) -> Result<Vec<(usize, usize)>, String> {
    let head = a.iter().zip(b).take_while(|(x, y)| x == y).count();
    let (ra, rb) = (&a[head..], &b[head..]);
    let tail = ra.iter().rev().zip(rb.iter().rev()).take_while(|(x, y)| x == y).count();
    let (ma, mb) = (&ra[..ra.len() - tail], &rb[..rb.len() - tail]);
    let mut pairs: Vec<_> = (0..head).map(|i| (i, i)).collect();
    let width = mb.len() + 1;
    if (ma.len() + 1).saturating_mul(width) > MOST_CELLS {
        return Err(TOO_LONG.to_owned());
    }
    // longest[i * width + j]: of ma[i..] and mb[j..].
    let mut longest = vec![0_u32; (ma.len() + 1) * width];
    for i in (0..ma.len()).rev() {
        for j in (0..mb.len()).rev() {
            longest[i * width + j] = if ma[i] == mb[j] {
                longest[(i + 1) * width + j + 1] + 1
            } else {
                longest[(i + 1) * width + j].max(longest[i * width + j + 1])
            };
        }
    }
    let (mut i, mut j) = (0, 0);
    while i < ma.len() && j < mb.len() {
        if ma[i] == mb[j] {
            pairs.push((head + i, head + j));
            (i, j) = (i + 1, j + 1);
        } else if longest[(i + 1) * width + j] >= longest[i * width + j + 1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    pairs.extend((0..tail).map(|k| (a.len() - tail + k, b.len() - tail + k)));
    Ok(pairs)
}

/// For each target, in order, the index of the point that stands for it: rising, with the least sum of
/// distances, each at most `near`; `None` for a target that has none.
pub(crate) fn ends(
    targets: &[Vec3],
    points: &[Point],
    near: f64,
) -> Result<Vec<Option<usize>>, String> {
    let (n, m) = (targets.len(), points.len());
    if n == 0 {
        return Ok(Vec::new());
    }
    if n.saturating_mul(m + 1) > MOST_CELLS {
        return Err(TOO_LONG.to_owned());
    }
    // cost[j]: least for the targets so far with the points before j; a target without a point costs more
    // than any that has one. A motion ends where a record of the file ends, if that does not matter else.
    let missing = 4.0 * near;
    let whole = |p: &Point| if p.last { 0.0 } else { 1e-6 * near };
    let mut cost = vec![0.0_f64; m + 1];
    let mut next = vec![0.0_f64; m + 1];
    let mut choice = vec![Choice::None; n * (m + 1)];
    for (k, target) in targets.iter().enumerate() {
        next[0] = cost[0] + missing;
        for (j, point) in points.iter().enumerate() {
            let away = (point.at.te - target).norm();
            let with = if away <= near { cost[j] + away + whole(point) } else { f64::INFINITY };
            let without = cost[j + 1] + missing;
            let (mut best, mut how) = (next[j], Choice::Earlier);
            if with < best {
                (best, how) = (with, Choice::This);
            }
            if without < best {
                (best, how) = (without, Choice::None);
            }
            next[j + 1] = best;
            choice[k * (m + 1) + j + 1] = how;
        }
        std::mem::swap(&mut cost, &mut next);
    }
    Ok(trace(n, m, &choice))
}

/// What is best for a target among the points before one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Choice {
    /// It ends at the last of them.
    This,
    /// What is best without the last of them.
    Earlier,
    /// It has no point.
    None,
}

/// Reads the choices back from the end.
fn trace(n: usize, m: usize, choice: &[Choice]) -> Vec<Option<usize>> {
    let mut out = vec![None; n];
    let (mut k, mut j) = (n, m);
    while k > 0 {
        match choice[(k - 1) * (m + 1) + j] {
            Choice::Earlier => j -= 1,
            Choice::This => {
                out[k - 1] = Some(j - 1);
                (k, j) = (k - 1, j - 1);
            }
            Choice::None => k -= 1,
        }
    }
    out
}
