//! A tree of balls and boxes over things that are asked for by where they are.

use crate::Vec3;

/// A ball and a box about the same centre, each of which holds some of the things.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    /// Their centre.
    pub center: Vec3,
    /// The ball's radius.
    pub radius: f64,
    /// Half the widths of the box.
    pub half: Vec3,
    /// What they hold.
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

/// What holds a thing: the centre of a ball and a box, the radius, half the widths.
pub type Held = (Vec3, f64, Vec3);

impl Ball {
    /// Is its box nearer to a point than the other one, or its centre where both boxes are as near?
    #[inline]
    pub(crate) fn nearer(&self, other: &Self, p: Vec3) -> bool {
        let far = |ball: &Self| (ball.apart(p), (ball.center - p).norm_squared());
        far(self) < far(other)
    }

    /// The square of the distance of a point from the box; zero within.
    #[inline]
    pub fn apart(&self, p: Vec3) -> f64 {
        let out = |x: f64, center: f64, half: f64| ((x - center).abs() - half).max(0.0);
        let (c, h) = (&self.center, &self.half);
        let [x, y, z] = [out(p.x, c.x, h.x), out(p.y, c.y, h.y), out(p.z, c.z, h.z)];
        x * x + y * y + z * z
    }
}

/// The tree over `things`, which it puts in such an order that those of a ball stand together; its first ball holds all. No
/// balls where there are no things.
///
/// `of` tells what holds a thing; `leaf` things or fewer are not divided any more.
pub fn balls<T>(things: &mut [T], leaf: usize, of: impl Fn(&T) -> Held) -> Vec<Ball> {
    let held: Vec<Held> = things.iter().map(of).collect();
    let mut order: Vec<usize> = (0..held.len()).collect();
    let mut tree = Vec::new();
    if !things.is_empty() {
        grow(&mut tree, &held, &mut order, 0, leaf.max(1));
    }
    // What stands at `order[i]` goes to `i`, round after round.
    for i in 0..order.len() {
        let mut at = i;
        while order[at] != i {
            let from = std::mem::replace(&mut order[at], at);
            things.swap(at, from);
            at = from;
        }
        order[at] = at;
    }
    tree
}

fn grow(
    tree: &mut Vec<Ball>,
    held: &[Held],
    order: &mut [usize],
    first: usize,
    leaf: usize,
) -> usize {
    let [lo, hi] = around(held, order);
    let center = (lo + hi) * 0.5;
    let reach = |i: &usize| (held[*i].0 - center).norm() + held[*i].1;
    let radius = order.iter().map(reach).fold(0.0, f64::max);
    let here = tree.len();
    let below = Below::Things(first, first + order.len());
    tree.push(Ball { center, radius, half: (hi - lo) * 0.5, below });
    if order.len() > leaf {
        let mid = order.len() / 2;
        // Across the direction that leaves the smaller boxes.
        let mut halve = |axis: usize| {
            let at = |i: &usize| held[*i].0[axis];
            order.select_nth_unstable_by(mid, |a, b| at(a).total_cmp(&at(b)).then(a.cmp(b)));
            let (first, second) = order.split_at(mid);
            [first, second].map(|half| skin(around(held, half))).iter().sum::<f64>()
        };
        let [x, y, z] = [0, 1, 2].map(&mut halve);
        if !(z < x && z < y) {
            halve(usize::from(y < x));
        }
        let (one, other) = order.split_at_mut(mid);
        let one = grow(tree, held, one, first, leaf);
        let other = grow(tree, held, other, first + mid, leaf);
        tree[here].below = Below::Balls([one, other]);
    } else {
        order.sort_unstable();
    }
    here
}

/// The least and greatest coordinates of what holds some of the things.
fn around(held: &[Held], some: &[usize]) -> [Vec3; 2] {
    let far = Vec3::repeat(f64::INFINITY);
    let both = |[lo, hi]: [Vec3; 2], (center, _, half): &Held| {
        [lo.inf(&(center - half)), hi.sup(&(center + half))]
    };
    some.iter().map(|i| &held[*i]).fold([far, -far], both)
}

/// Half the area of a box.
fn skin([lo, hi]: [Vec3; 2]) -> f64 {
    let d = hi - lo;
    d.x * d.y + d.y * d.z + d.z * d.x
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
        let before = things.clone();
        let tree = balls(&mut things, 4, |t| (t.0, t.1, Vec3::new(t.1, 0.5 * t.1, t.1)));
        // None is lost.
        assert!(before.iter().all(|t| things.contains(t)));
        let mut held = 0;
        for ball in &tree {
            match ball.below {
                Below::Balls(pair) => {
                    for b in pair.map(|i| tree[i]) {
                        // A ball over both halves, and not over their balls, may be the smaller.
                        assert!((b.center - ball.center).norm() <= ball.radius + 1e-12);
                        let out = (b.center - ball.center).abs() + b.half - ball.half;
                        assert!(out.max() <= 1e-12, "{out}");
                    }
                }
                Below::Things(from, to) => {
                    held += to - from;
                    assert!(to - from <= 4);
                    for (c, r) in &things[from..to] {
                        assert!((c - ball.center).norm() + r <= ball.radius + 1e-12);
                        let lowest = c - Vec3::new(*r, 0.5 * r, *r);
                        assert!(ball.apart(lowest) <= 1e-24);
                        assert!(ball.apart(lowest - Vec3::x() * 100.0) >= 1e3);
                    }
                }
            }
        }
        assert_eq!(held, 50);
        let mut none: [Held; 0] = [];
        assert!(balls(&mut none, 4, |t| *t).is_empty());
    }
}
