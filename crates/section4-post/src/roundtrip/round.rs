//! A step along an arc, past all positions of it.

use aptc_geometry::{Vec3, trig};

use super::done::segment;
use super::{Checker, Expect, shown};
use crate::readback::ArcStep;

impl Checker {
    pub(super) fn arc(&mut self, arc: &ArcStep) {
        let (Some(begin), Some(end)) = (self.pose(&arc.from), self.pose(&arc.to)) else {
            self.say("an arc to a place that is not known".into());
            return;
        };
        (self.away, self.below) = (false, None);
        self.now = Some(begin);
        self.skip_here();
        self.now = Some(end);
        if std::mem::take(&mut self.free) {
            self.at = Some(begin);
        }
        let band = self.band();
        let most = arc.sweep.abs();
        let (Some(start), Some(axis)) = (self.pose(&arc.at(0.0)), self.arc_axis(arc)) else {
            return;
        };
        let Some(center) = self.arc_center(arc) else { return };
        let spoke = start.0 - center;
        let rise = (end.0 - begin.0).dot(&axis);
        let mut passed = 0.0_f64;
        let fit = self.fit.map_or(band, |t| t + 2.0 * self.linear);
        while let Some(Expect::Point { te, ta, rapid, round, .. }) = self.queue.front().cloned() {
            let d = te - center;
            let flat = d - axis * d.dot(&axis);
            let mut angle =
                trig::atan2(axis.dot(&spoke.cross(&flat)), spoke.dot(&flat)) * arc.sweep.signum();
            let slack = 2.0 * band / arc.radius;
            if angle < passed - slack {
                angle += std::f64::consts::TAU;
            }
            let height = rise * (angle / most).clamp(0.0, 1.0);
            let mut off = ((flat.norm() - arc.radius).abs())
                .max((d.dot(&axis) - spoke.dot(&axis) - height).abs());
            if let Some((last, _)) = self.at.filter(|_| !round) {
                // In place of a line: the middle of the line counts as well.
                let near = nearest(center, last, te) - center;
                off = off.max(((near - axis * near.dot(&axis)).norm() - arc.radius).abs());
            }
            if off > if round { band } else { fit } || angle > most + slack {
                break;
            }
            if rapid {
                self.say("an arc where the CL data is rapid".into());
            }
            passed = passed.max(angle);
            self.queue.pop_front();
            self.proof.points += 1;
            self.proof.path_mm = self.proof.path_mm.max(off);
            (self.at, self.at_cut) = (Some((te, ta)), !rapid);
        }
        let Some((at, _)) = self.at else { return };
        if (at - end.0).norm() <= 2.0 * self.linear {
            return;
        }
        // A piece of a longer arc ends between two cut vectors.
        if let Some(Expect::Point { te, .. }) = self.queue.front()
            && segment(end.0, at, *te).0 <= band + arc.radius * 0.04
        {
            return;
        }
        self.say(format!("an arc to {} that the CL data does not have", shown(end.0)));
    }

    fn arc_axis(&mut self, arc: &ArcStep) -> Option<Vec3> {
        let n = 3 - arc.axes[0] - arc.axes[1];
        let mut up = arc.from;
        up[n] = Some(up[n].unwrap_or(0.0) + 1.0);
        let (a, b) = (self.pose(&arc.from)?.0, self.pose(&up)?.0);
        Some((b - a).normalize())
    }

    fn arc_center(&mut self, arc: &ArcStep) -> Option<Vec3> {
        let mut c = arc.from;
        c[arc.axes[0]] = Some(arc.center[0]);
        c[arc.axes[1]] = Some(arc.center[1]);
        Some(self.pose(&c)?.0)
    }
}

/// The place of the segment `a b` that is nearest to `p`.
fn nearest(p: Vec3, a: Vec3, b: Vec3) -> Vec3 {
    a + (b - a) * segment(p, a, b).1
}
