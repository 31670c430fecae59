//! The way from home: from above, along the tool, to where the CL data goes on.

use aptc_geometry::Vec3;

use super::done::along;
use super::{Checker, Expect, Over, shown};
use crate::approach::goes_up;
use crate::machine::{Carries, MachineKind};
use crate::readback::Place;

/// Rapid motions up to this have no length, millimetres.
pub(super) const NOWHERE_MM: f64 = 1e-6;

impl Checker {
    /// From home to where the CL data goes on.
    pub(super) fn arrive(&mut self, end: Vec3, axis: Vec3, rapid: bool) {
        let near = |p: Vec3, tol: f64| (p - end).norm() <= tol;
        self.back_below(end, axis);
        if self.at.is_some_and(|(at, _)| near(at, 2.0 * self.linear)) {
            self.cuts_on_from(end, rapid);
            self.away = false;
            self.now = Some((end, axis));
            self.skip_here();
            return;
        }
        while let Some(Expect::Clear) = self.queue.front() {
            self.queue.pop_front();
            // Straight to the clearance plane over the last position.
            if self.at.is_some_and(|(at, t)| along(end - at, t, self.angular) >= 0.0) {
                self.below = self.at.filter(|_| self.at_cut);
                (self.at, self.at_cut) = (Some((end, axis)), false);
                self.away = false;
                return;
            }
        }
        match self.queue.front().cloned() {
            Some(Expect::Hole(h)) if rapid => {
                let height = (end - h.at).dot(&h.ta);
                if height >= h.clearance - self.linear {
                    self.away = false;
                    return;
                }
                self.say(format!("a rapid motion to {} below the clearance of a hole", shown(end)));
            }
            Some(Expect::Point { rapid: want, .. }) => {
                if self.pop_if_at(end, axis) {
                    self.away = false;
                    if rapid && !want {
                        self.say(format!(
                            "a rapid motion to {} where the CL data cuts",
                            shown(end)
                        ));
                    }
                } else if !rapid {
                    self.say(format!("a cut to {} on the way from home", shown(end)));
                    self.away = false;
                }
            }
            _ => {}
        }
    }

    /// The line along the tool on which it stands after a motion across, at a height that is not known.
    pub(super) fn across(&mut self, to: &Place) -> Option<Over> {
        let [x, y] = [to[0], to[1]];
        let (at, ta) = self.pose(&[x, y, Some(0.0), to[3], to[4]])?;
        let (higher, _) = self.pose(&[x, y, Some(1.0), to[3], to[4]])?;
        if !self.away || (higher - at - ta).norm() > self.angular {
            return None;
        }
        Some(Over { at, ta, known: false, angles: [to[3], to[4]] })
    }

    /// Where a control keeps the tool end on its path, or a head leans: is the way here from home one down along the
    /// tool, with the rotary axes at rest?
    ///
    /// Then the linear axes of the machine go along the tool only, however the control leads a rapid motion: the
    /// place across was reached before, at the height of home or above this place.
    pub(super) fn comes_down(&self, to: &Place, end: Vec3, axis: Vec3) -> bool {
        let m = &self.machine;
        // Tables without such control turn the part under a tool that comes down along itself.
        if !m.multiaxis.tool_center && m.rotary.iter().all(|r| r.carries == Carries::Part) {
            return true;
        }
        let Some(over) = self.over.filter(|o| o.angles == [to[3], to[4]]) else { return false };
        let d = over.at - end;
        let aside = (d - axis * d.dot(&axis)).norm();
        // The angles of a tilted plane are rounded as those of the axes are.
        let tol = 2.0 * self.linear + 2.0 * self.angular * (end.norm() + d.norm());
        aside <= tol
            && (over.ta - axis).norm() <= 2.0 * self.angular
            && (!over.known || d.dot(&axis) >= -tol)
    }

    /// Is this a place at which the CL data goes on?
    pub(super) fn wants(&self, end: Vec3) -> bool {
        let near = |p: Vec3| (p - end).norm() <= 2.0 * self.linear;
        self.at.is_some_and(|(at, _)| near(at))
            || match self.queue.front() {
                Some(Expect::Point { te, .. }) => near(*te),
                Some(Expect::Hole(h)) => (end - h.at).dot(&h.ta) < h.retract + 2.0 * self.linear,
                _ => false,
            }
    }

    /// Ended a cut of a mill where the CL data stands, and does the next motion cut on from there other than straight up?
    fn goes_on_cutting(&self) -> bool {
        let mills = self.machine.kind == MachineKind::Mill || self.machine.is_milling();
        let Some((at, axis)) = self.at.filter(|_| self.at_cut && mills) else { return false };
        // What RETRCT asked for has been done by way of home, and a rapid motion of no length ends no cut.
        let next = self.queue.iter().find(|e| match e {
            Expect::Clear | Expect::Tool { .. } => false,
            Expect::Point { te, rapid: true, .. } => (te - at).norm() > NOWHERE_MM,
            _ => true,
        });
        match next {
            // Twice the angle that the writer allows: both compute it in units of their own.
            Some(Expect::Point { te, rapid: false, .. }) => !goes_up(te - at, axis, 2e-6),
            _ => false,
        }
    }

    /// Does the tool go down again to where a cut ended? Then the CL data goes on from there.
    pub(super) fn back_below(&mut self, end: Vec3, axis: Vec3) -> bool {
        let Some((te, ta)) = self.below.take() else { return false };
        let there = (te - end).norm() <= 2.0 * self.linear && (ta - axis).norm() <= self.angular;
        if there {
            (self.at, self.at_cut) = (Some((te, ta)), true);
        }
        there
    }

    /// The tool comes to where a cut ended: not at rapid where the next one goes on from there.
    pub(super) fn cuts_on_from(&mut self, end: Vec3, rapid: bool) {
        if rapid && self.goes_on_cutting() {
            self.say(format!(
                "a rapid motion to {}, where the last cut of the CL data ended and the next begins",
                shown(end)
            ));
        }
    }
}
