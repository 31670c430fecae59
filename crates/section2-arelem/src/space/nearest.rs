//! How near a path comes to a surface that it does not reach, for the message.

use super::judge::between;
use super::keep::{Keep, Pose};
use super::watch::clearance;

/// Places of the path that are looked at.
const PLACES: usize = 400;
/// Rounds of the search about the best of them.
const ROUNDS: usize = 60;

/// Least gap of the cutter from the surface on a path of straight pieces, and where. The longest pieces are
/// looked at more than once.
pub(crate) fn approach(keep: &Keep, path: &[Pose]) -> Option<(f64, Pose)> {
    let gap = |p: &Pose| clearance(keep, p).map_or(f64::INFINITY, |(g, _)| g.abs());
    let pieces = path.len().checked_sub(1).filter(|n| *n > 0)?;
    let each = (PLACES / pieces).max(1);
    let share = |i: usize| {
        #[expect(clippy::cast_precision_loss, reason = "hundreds")]
        let t = i as f64 / each as f64;
        t
    };
    let place = |k: usize, t: f64| between(&path[k], &path[k + 1], t);
    let mut best = (f64::INFINITY, 0, 0.0);
    for k in (0..pieces).step_by(pieces / PLACES + 1) {
        for i in 0..=each {
            let g = gap(&place(k, share(i)));
            if g < best.0 {
                best = (g, k, share(i));
            }
        }
    }
    // Shrinking steps to both sides on the same piece.
    let (mut g, k, mut t) = best;
    let mut step = share(1);
    for _ in 0..ROUNDS {
        let both = [t - step, t + step].map(|t| t.clamp(0.0, 1.0));
        let found = both.map(|t| (gap(&place(k, t)), t));
        match found.into_iter().find(|f| f.0 < g) {
            Some(lower) => (g, t) = lower,
            None => step *= 0.5,
        }
    }
    g.is_finite().then(|| (g, place(k, t)))
}
