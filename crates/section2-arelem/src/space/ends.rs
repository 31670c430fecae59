//! Ends of a surface in the cutter: its contact is told by what faces it, and an end faces nothing.

use aptc_contact::Condition;
use aptc_geometry::{Surface, Vec3};

use super::keep::{Keep, Pose};

/// Places of each side that are looked at.
const PLACES: usize = 64;
/// Times as long as its chord that an end is at most between two of them.
const BENT: f64 = 2.0;
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
    let most = keep.thick - 2.0 * keep.width();
    let near = |q| {
        let near = tool.near(q);
        (near.distance, near.normal)
    };
    let sides = [0, 1, 2, 3].into_iter().filter(|side| {
        let border = [1 - side / 2, side % 2];
        !surface.border_keeps_off(border, most, near)
    });
    let least = sides.map(|side| {
        let at = |t: f64| {
            let place = match side {
                0 => [t, 0.0],
                1 => [t, 1.0],
                2 => [0.0, t],
                _ => [1.0, t],
            };
            let point = surface.point(place);
            (tool.distance(point), point)
        };
        lowest(at, most)
    });
    let gap = least.fold(f64::INFINITY, f64::min) - keep.thick;
    (gap < -2.0 * keep.width()).then_some(gap)
}

/// The least value of a function on 0 to 1 with one low for each that the places looked at show; it goes with a point, and changes no
/// faster than that moves. What is not less than `most` is told to the places looked at alone.
fn lowest(at: impl Fn(f64) -> (f64, Vec3), most: f64) -> f64 {
    let share = |i: usize| i as f64 / PLACES as f64;
    let all: Vec<(f64, Vec3)> = (0..=PLACES).map(|i| at(share(i))).collect();
    let mut least = f64::INFINITY;
    for (i, (here, point)) in all.iter().enumerate() {
        let beside = [i.checked_sub(1), Some(i + 1)].map(|k| k.and_then(|k| all.get(k)));
        least = least.min(*here);
        let low = beside.iter().flatten().all(|(value, _)| here <= value);
        let far = beside.iter().flatten().map(|(_, p)| (p - point).norm()).fold(0.0, f64::max);
        if !low || here - BENT * far >= most {
            continue;
        }
        let [mut a, mut b] = [share(i.saturating_sub(1)), share((i + 1).min(PLACES))];
        for _ in 0..ROUNDS {
            let [p, q] = [b - SHARE * (b - a), a + SHARE * (b - a)];
            let [(f, _), (g, _)] = [at(p), at(q)];
            least = least.min(f).min(g);
            if f <= g { b = q } else { a = p }
        }
    }
    least
}
