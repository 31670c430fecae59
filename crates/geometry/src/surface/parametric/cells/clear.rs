//! Whether a convex body keeps off a sculptured surface.

use super::super::Jet;
use super::{Cell, Cells, WAITING};
use crate::Vec3;
use crate::balls::Below;

/// How often a cell is cut in four at most, and cells that are looked at.
const CUTS: u32 = 6;
const LOOKS: u32 = 2000;

impl Cells {
    /// Is all of the surface at least so far from a convex body? `near` tells its signed distance from a point, and the
    /// gradient of that: a convex function lies above its tangent plane. False also where it is not seen.
    pub(in super::super) fn keeps_off(
        &self,
        least: f64,
        near: impl Fn(Vec3) -> (f64, Vec3),
        jet: impl Fn([usize; 2], f64, f64) -> Jet,
    ) -> bool {
        let mut waiting = [0_usize; WAITING];
        let mut n = usize::from(!self.tree.is_empty());
        let mut left = LOOKS;
        while n > 0 {
            n -= 1;
            let ball = &self.tree[waiting[n]];
            if near(ball.center).0 - ball.radius >= least {
                continue;
            }
            match ball.below {
                Below::Balls(_) if n + 2 > WAITING => return false,
                Below::Balls(pair) => {
                    waiting[n..n + 2].copy_from_slice(&pair);
                    n += 2;
                }
                Below::Things(from, to) => {
                    let mut all = self.cells[from..to].iter();
                    if !all.all(|c| c.keeps_off(least, &near, &jet, CUTS, &mut left)) {
                        return false;
                    }
                }
            }
        }
        true
    }
}

impl Cell {
    fn keeps_off(
        &self,
        least: f64,
        near: &impl Fn(Vec3) -> (f64, Vec3),
        jet: &impl Fn([usize; 2], f64, f64) -> Jet,
        cuts: u32,
        left: &mut u32,
    ) -> bool {
        let (distance, gradient) = near(self.c);
        let over = |k: usize| self.bend[k].1 - gradient.dot(&self.bend[k].0);
        let twist = gradient.dot(&self.bend[1].0).abs() + self.bend[1].1;
        let stray = 0.5 * (over(0).max(0.0) + over(2).max(0.0)) + twist;
        let [a, b] = self.side.map(|s| gradient.dot(&s).abs());
        if distance - a - b - stray >= least {
            return true;
        }
        // A place that is too near ends it.
        if distance < least || cuts == 0 || *left == 0 {
            return false;
        }
        *left -= 1;
        self.parts(jet).iter().all(|c| c.keeps_off(least, near, jet, cuts - 1, left))
    }
}
