//! The tool on its way along a cut vector, held against points by separating planes.

use aptc_geometry::Vec3;

use crate::demand::{bulge, parabola};
use crate::tool::{Pose, Tool, turned};

/// Looks for the nearest meeting, and the sine at which it is square to the way.
const LOOKS: u32 = 12;
const SQUARE: f64 = 1e-6;

/// A tool and its way. Every tool on the way lies in the hull of those at the ends, enlarged by `pad`. Seen
/// from the tool a point of space goes along its chord but for a bulge, second order in the turn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sweep<'a> {
    pub(crate) tool: &'a Tool<'a>,
    pub(crate) a: Pose,
    pub(crate) b: Pose,
    /// Angle by which the axis turns.
    pub(crate) turn: f64,
    /// Arc less chord of the farthest point of the tool, when the axis turns.
    pub(crate) pad: f64,
}

impl<'a> Sweep<'a> {
    /// From one position to another, the axis turning by `turn`; angles of rounding count as none.
    pub(crate) fn new(tool: &'a Tool<'a>, a: Pose, b: Pose, turn: f64) -> Self {
        let turn = if turn <= 1e-15 { 0.0 } else { turn };
        Self { tool, a, b, turn, pad: bulge(tool.reach(), turn) }
    }

    /// Standing at a position.
    pub(crate) fn still(tool: &'a Tool<'a>, at: Pose) -> Self {
        Self::new(tool, at, at, 0.0)
    }
}

/// Where a point is nearest to the tool on its way, not exactly.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Meeting {
    /// Share of the way.
    pub(crate) t: f64,
    /// Signed distance there, negative in the tool.
    pub(crate) distance: f64,
    /// Unit direction from the tool to the point.
    pub(crate) m: Vec3,
}

impl Sweep<'_> {
    fn pose(&self, t: f64) -> Pose {
        let mix = |p: Vec3, q: Vec3| p + (q - p) * t;
        let ta = if self.pad == 0.0 { self.a.ta } else { mix(self.a.ta, self.b.ta).normalize() };
        Pose { te: mix(self.a.te, self.b.te), ta }
    }

    /// The middle of a sphere that holds all of the way, and its radius.
    pub(crate) fn sphere(&self) -> (Vec3, f64) {
        let half = 0.5 * (self.b.te - self.a.te);
        (self.a.te + half, half.norm() + self.tool.reach() + self.pad)
    }

    /// The nearest meeting, found by few looks: an inexact one makes a bound weaker and not wrong.
    pub(crate) fn meet(&self, x: Vec3) -> Meeting {
        let v = self.b.te - self.a.te;
        let at = |t: f64| {
            let (distance, m) = self.tool.near(&self.pose(t), x);
            (Meeting { t, distance, m }, -m.dot(&v))
        };
        let (first, mut f0) = at(0.0);
        if f0 >= 0.0 && self.pad == 0.0 {
            return first;
        }
        let (last, mut f1) = at(1.0);
        if f1 <= 0.0 || f0 >= 0.0 {
            return if last.distance < first.distance { last } else { first };
        }
        let (mut t0, mut t1) = (0.0, 1.0);
        let mut best = if last.distance < first.distance { last } else { first };
        let small = SQUARE * v.norm();
        // Regula falsi; the end that stays twice counts half, so that it comes nearer from both sides.
        let mut stayed = 0;
        for _ in 0..LOOKS {
            let t = t0 - f0 * (t1 - t0) / (f1 - f0);
            let (now, slope) = at(t);
            if now.distance <= best.distance {
                best = now;
            }
            if slope.abs() <= small {
                break;
            }
            if slope < 0.0 {
                (t0, f0) = (t, slope);
                f1 *= if stayed < 0 { 0.5 } else { 1.0 };
                stayed = -1;
            } else {
                (t1, f1) = (t, slope);
                f0 *= if stayed > 0 { 0.5 } else { 1.0 };
                stayed = 1;
            }
        }
        best.m = self.square(best.m).unwrap_or(best.m);
        best
    }

    /// Meetings in the middle of the way with a given direction and with that square to the way.
    pub(crate) fn level(&self, m: Vec3) -> [Meeting; 2] {
        let of = |m: Vec3| Meeting { t: 0.5, distance: f64::INFINITY, m };
        [of(m), of(self.square(m).unwrap_or(m))]
    }

    /// The direction made square to the way, which bounds all of it alike; `None` where it runs along it.
    fn square(&self, m: Vec3) -> Option<Vec3> {
        let v = self.b.te - self.a.te;
        let square = m - v * (m.dot(&v) / v.norm_squared());
        (self.pad == 0.0 && square.norm() > 0.5).then(|| square.normalize())
    }

    /// What a meeting proves of the distance of a piece about `x` that lies within `radius` of it: not less than
    /// the first number with the greater slack of both ends taken off; the last one is the part of it that
    /// is due to the turn. `slack` tells by parameter how much the piece may be nearer in a direction.
    pub(crate) fn proved(
        &self,
        meeting: &Meeting,
        x: Vec3,
        radius: f64,
        slack: impl Fn(Vec3) -> [f64; 2],
    ) -> (f64, [f64; 2], f64) {
        let m = meeting.m;
        if self.pad == 0.0 {
            let first = self.tool.height(&self.a, m);
            let height = first.max(first + m.dot(&(self.b.te - self.a.te)));
            let slack = slack(m);
            return (m.dot(&x) - height - slack[0] - slack[1], slack, 0.0);
        }
        // The direction turns with the tool, whose support in it stays the same.
        let pose = self.pose(meeting.t);
        let own = self.tool.height(&Pose { te: Vec3::zeros(), ta: pose.ta }, m);
        let end = |at: &Pose| {
            let m = turned(pose.ta, at.ta, m);
            let slack = slack(m);
            (m.dot(&(x - at.te)) - own - slack[0] - slack[1], slack)
        };
        let ((a, slack_a), (b, slack_b)) = (end(&self.a), end(&self.b));
        let lever = (x - self.a.te).norm().max((x - self.b.te).norm()) + radius;
        let drift = (self.b.te - self.a.te).norm();
        let rise = bulge(lever, self.turn) + 0.25 * self.turn * drift;
        (-parabola(-a, -b, rise), [0, 1].map(|i| slack_a[i].max(slack_b[i])), rise)
    }
}
