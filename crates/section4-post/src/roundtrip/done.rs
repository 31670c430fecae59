//! What the text does, step by step, held against what was asked for.

use aptc_geometry::{Vec3, trig};

use super::from_home::NOWHERE_MM;
use super::{Checker, Expect};
use crate::readback::Step;

impl Checker {
    pub(super) fn step(&mut self, step: &Step) {
        self.marks();
        match step {
            Step::Away => {
                self.away = true;
                self.now = None;
                (self.over, self.below) = (None, None);
            }
            Step::Frame(frame) => {
                self.frame = *frame;
                self.posed = None;
            }
            Step::Center(on) => self.centered = *on,
            Step::Line { from, to, rapid, .. } => self.line(from, to, *rapid),
            Step::Arc(arc) => self.arc(arc),
        }
    }

    /// Positions that the tool already stands at.
    pub(super) fn skip_here(&mut self) {
        let Some((now, axis)) = self.now.filter(|_| !self.away) else { return };
        while let Some(Expect::Point { te, ta, rapid, .. }) = self.queue.front() {
            if (te - now).norm() > self.linear || (ta - axis).norm() > self.angular {
                return;
            }
            let (te, ta, cut) = (*te, *ta, !*rapid);
            self.reached((te, ta), (now, axis), cut);
            self.queue.pop_front();
        }
    }

    pub(super) fn reached(&mut self, (te, ta): (Vec3, Vec3), (now, axis): (Vec3, Vec3), cut: bool) {
        self.proof.points += 1;
        self.proof.position_mm = self.proof.position_mm.max((te - now).norm());
        let lean = ta.cross(&axis).norm().min(1.0);
        self.proof.axis_deg = self.proof.axis_deg.max(trig::asin(lean).to_degrees());
        // A rapid motion of no length leaves the tool in its cut.
        let stays = self.at.is_some_and(|(at, _)| (te - at).norm() <= NOWHERE_MM);
        self.at = Some((te, ta));
        self.at_cut = cut || self.at_cut && stays;
    }

    /// Is the next position this one? Then it is reached.
    pub(super) fn pop_if_at(&mut self, end: Vec3, axis: Vec3) -> bool {
        let Some(Expect::Point { te, ta, rapid, .. }) = self.queue.front() else { return false };
        if (te - end).norm() > 2.0 * self.linear || (ta - axis).norm() > self.angular {
            return false;
        }
        let (te, ta, cut) = (*te, *ta, !*rapid);
        self.queue.pop_front();
        self.reached((te, ta), (end, axis), cut);
        true
    }

    pub(super) fn band(&self) -> f64 {
        let said = self.band.unwrap_or(if self.intol > 0.0 { 0.0 } else { 0.0127 });
        said.max(self.intol) + 4.0 * self.linear
    }
}

/// Distance of `p` from the segment `a b`, and where along it, 0 to 1.
pub(super) fn segment(p: Vec3, a: Vec3, b: Vec3) -> (f64, f64) {
    let d = b - a;
    let n = d.norm_squared();
    let t = if n > 0.0 { ((p - a).dot(&d) / n).clamp(0.0, 1.0) } else { 0.0 };
    ((p - a - d * t).norm(), t)
}

/// Length of a motion when it goes straight along the unit vector, to within the angle `lean`, else 0.
pub(super) fn along(d: Vec3, unit: Vec3, lean: f64) -> f64 {
    let way = d.dot(&unit);
    if (d - unit * way).norm() <= 0.002 + lean * way.abs() { way } else { 0.0 }
}
