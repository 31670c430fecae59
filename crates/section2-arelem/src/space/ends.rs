//! Ends of a surface in the cutter: its contact is told by what faces it, and an end faces nothing.

use aptc_contact::Condition;
use aptc_geometry::Surface;

use super::keep::{Keep, Pose};

/// Places of each side that are looked at.
const PLACES: u32 = 64;
/// Rounds of the search about those where it is nearest, and the share of the way that each leaves.
const ROUNDS: usize = 40;
const SHARE: f64 = 0.618;

/// The gap at the end of a surface by two parameters, itself and not what goes on straight beyond it, that lies deeper in the cutter
/// than two bands. A wall that leans over a tall tool ends in its side, whatever of the tool touches the wall farther down.
pub(super) fn end_in(keep: &Keep, pose: &Pose) -> Option<f64> {
    let Surface::Parametric(surface) = &keep.surface else { return None };
    if keep.condition != Condition::Touch || keep.profile.reach() <= 0.0 {
        return None;
    }
    let tool = keep.tool(pose);
    let least = (0..4).map(|side| {
        let at = |t: f64| {
            let place = match side {
                0 => [t, 0.0],
                1 => [t, 1.0],
                2 => [0.0, t],
                _ => [1.0, t],
            };
            tool.distance(surface.place(place).point)
        };
        lowest(at)
    });
    let gap = least.fold(f64::INFINITY, f64::min) - keep.thick;
    (gap < -2.0 * keep.width()).then_some(gap)
}

/// The least value of a function on 0 to 1 with one low for each that the places looked at show.
fn lowest(at: impl Fn(f64) -> f64) -> f64 {
    let share = |i: u32| f64::from(i) / f64::from(PLACES);
    let values: Vec<f64> = (0..=PLACES).map(|i| at(share(i))).collect();
    let low = |i: &u32| {
        let value = |k: Option<u32>| k.and_then(|k| values.get(k as usize)).copied();
        let here = value(Some(*i)).unwrap_or(f64::INFINITY);
        let beside = [i.checked_sub(1), Some(i + 1)].map(|k| value(k).unwrap_or(f64::INFINITY));
        beside.iter().all(|b| here <= *b)
    };
    let mut least = f64::INFINITY;
    for i in (0..=PLACES).filter(low) {
        let [mut a, mut b] = [share(i.saturating_sub(1)), share((i + 1).min(PLACES))];
        for _ in 0..ROUNDS {
            let [p, q] = [b - SHARE * (b - a), a + SHARE * (b - a)];
            let [f, g] = [at(p), at(q)];
            least = least.min(f).min(g);
            if f <= g { b = q } else { a = p }
        }
    }
    values.into_iter().fold(least, f64::min)
}
