//! A step of a hole: from its clearance to its bottom and back.

use aptc_geometry::Vec3;

use super::{Checker, Hole, shown};

impl Checker {
    /// A step of a hole; true when it is done.
    pub(super) fn drill(
        &mut self,
        hole: &mut Hole,
        begin: Option<(Vec3, Vec3)>,
        end: Vec3,
        rapid: bool,
    ) -> bool {
        let tol = 2.0 * self.linear;
        let height = |p: Vec3| (p - hole.at).dot(&hole.ta);
        let aside = |p: Vec3| {
            let d = p - hole.at;
            (d - hole.ta * d.dot(&hole.ta)).norm()
        };
        let (h, from) = (height(end), begin.map(|b| b.0));
        if aside(end) > tol || from.is_some_and(|b| aside(b) > tol) {
            // On the way to the hole: only rapid, and only up or at a height that is clear.
            // From another axis it comes along the clearance plane, at a height that in the frame of this hole means nothing.
            // Which side of the plane is above both tool axes tell; its normal may point either way.
            let above = |p: Vec3, ta: Vec3| {
                hole.plane.is_some_and(|c| (c.n.dot(&p) - c.d) * c.n.dot(&ta).signum() >= -tol)
            };
            let free = begin.is_some_and(|(b, ta)| {
                (ta - hole.ta).norm() > self.angular
                    && [end, b].iter().all(|p| above(*p, ta) && above(*p, hole.ta))
            });
            let low = !free
                && from.is_some_and(|b| {
                    height(b) < hole.clearance - tol && aside(b) > tol && aside(end) <= tol
                });
            let across =
                from.is_some_and(|b| (end - b - hole.ta * (end - b).dot(&hole.ta)).norm() > tol);
            let turning = !self.machine.rotary.is_empty();
            if !rapid || low || (across && h < hole.clearance - tol && !turning) {
                self.say(format!("a motion to {} on the way to a hole", shown(end)));
            }
            let there = aside(end) <= tol && hole.bottom >= -tol && (h - hole.retract).abs() <= tol;
            return there && hole.clearance <= tol;
        }
        if rapid && h < hole.clearance.min(hole.deepest) - tol {
            self.say(format!("a rapid motion into a hole to {}", shown(end)));
        }
        if h < hole.bottom - tol {
            self.say(format!("a hole too deep at {}", shown(end)));
        }
        hole.deepest = hole.deepest.min(h);
        if hole.deepest > hole.bottom + tol || (h - hole.retract).abs() > tol {
            return false;
        }
        self.proof.points += 1;
        (self.at, self.at_cut) = (Some((hole.at + hole.ta * hole.retract, hole.ta)), false);
        true
    }
}
