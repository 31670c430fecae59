//! A tree of balls over things that are asked for by where they are.

use crate::Vec3;

/// A ball that holds some of the things.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    /// Its centre.
    pub center: Vec3,
    /// Its radius.
    pub radius: f64,
    /// What it holds.
    pub below: Below,
}

/// What a ball of the tree holds.
#[derive(Clone, Copy, Debug)]
pub enum Below {
    /// Two balls, by their places in the tree.
    Balls([usize; 2]),
    /// The things from the first place up to, not including, the second.
    Things(usize, usize),
}

/// The tree over `things`, which it sorts so that those of a ball stand together; its first ball holds all. No
/// balls where there are no things.
///
/// `of` tells the ball that holds a thing; `leaf` things or fewer are not divided any more.
pub fn balls<T>(things: &mut [T], leaf: usize, of: impl Fn(&T) -> (Vec3, f64)) -> Vec<Ball> {
    let mut tree = Vec::new();
    if !things.is_empty() {
        let n = things.len();
        grow(&mut tree, things, [0, n], leaf.max(1), &of);
    }
    tree
}

fn grow<T>(
    tree: &mut Vec<Ball>,
    things: &mut [T],
    [from, to]: [usize; 2],
    leaf: usize,
    of: &impl Fn(&T) -> (Vec3, f64),
) -> usize {
    let all = &mut things[from..to];
    let (mut lo, mut hi) = (of(&all[0]).0, of(&all[0]).0);
    for thing in &*all {
        let (center, _) = of(thing);
        (lo, hi) = (lo.inf(&center), hi.sup(&center));
    }
    let center = (lo + hi) * 0.5;
    let reach = |thing: &T| {
        let (c, r) = of(thing);
        (c - center).norm() + r
    };
    let radius = all.iter().map(reach).fold(0.0, f64::max);
    let here = tree.len();
    tree.push(Ball { center, radius, below: Below::Things(from, to) });
    if to - from > leaf {
        let axis = (hi - lo).imax();
        all.sort_by(|a, b| of(a).0[axis].total_cmp(&of(b).0[axis]));
        let mid = usize::midpoint(from, to);
        let first = grow(tree, things, [from, mid], leaf, of);
        let second = grow(tree, things, [mid, to], leaf, of);
        tree[here].below = Below::Balls([first, second]);
    }
    here
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_ball_holds_what_is_below_it() {
        let mut things: Vec<(Vec3, f64)> = (0..50)
            .map(|k| {
                let t = f64::from(k);
                (Vec3::new(crate::trig::sin(t), crate::trig::cos(2.0 * t), 0.1 * t), 0.01 * t)
            })
            .collect();
        let tree = balls(&mut things, 4, |t| *t);
        let mut held = 0;
        for ball in &tree {
            match ball.below {
                Below::Balls(pair) => {
                    for b in pair.map(|i| tree[i]) {
                        // A ball over both halves, and not over their balls, may be the smaller.
                        assert!((b.center - ball.center).norm() <= ball.radius + 1e-12);
                    }
                }
                Below::Things(from, to) => {
                    held += to - from;
                    assert!(to - from <= 4);
                    for (c, r) in &things[from..to] {
                        assert!((c - ball.center).norm() + r <= ball.radius + 1e-12);
                    }
                }
            }
        }
        assert_eq!(held, 50);
        let mut none: [(Vec3, f64); 0] = [];
        assert!(balls(&mut none, 4, |t| *t).is_empty());
    }
}
