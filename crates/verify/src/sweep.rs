//! The tool on its way along a cut vector, held against points by separating planes.

use aptc_geometry::Vec3;

use crate::between::{bulge, parabola};
use crate::tool::{Pose, Tool, Turn, turned};

/// Looks for the nearest meeting, and the sine at which it is square to the way.
const LOOKS: u32 = 18;
const SQUARE: f64 = 1e-9;

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
    /// Unit direction from the tool to the point, as the axis stands at the first position.
    pub(crate) m: Vec3,
    /// How far the tool reaches in that direction from its end.
    reach: f64,
}

/// By how much a piece may be nearer in a direction than its middle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slack {
    /// By parameter, to first order and by the bend of the piece.
    pub(crate) by: [f64; 2],
    /// In all, when its bend is on the right side.
    pub(crate) all: f64,
}

impl Sweep<'_> {
    /// The middle of a sphere that holds all of the way, and its radius.
    pub(crate) fn sphere(&self) -> (Vec3, f64) {
        let (up, radius) = self.tool.middle();
        let [a, b] = [self.a, self.b].map(|at| at.te + at.ta * up);
        let half = 0.5 * (b - a);
        (a + half, half.norm() + radius + self.pad)
    }

    /// Any unit direction, wherever on the way.
    pub(crate) fn along(&self, m: Vec3) -> Meeting {
        Meeting { t: 0.5, distance: f64::INFINITY, m, reach: self.reach(m) }
    }

    /// How far the tool reaches in a direction from its end, as the axis stands at the first position.
    fn reach(&self, m: Vec3) -> f64 {
        self.tool.height(&Pose { te: Vec3::zeros(), ta: self.a.ta }, m)
    }

    /// The point seen from the tool at both ends, as the axis stands at the first.
    fn seen(&self, x: Vec3) -> [Vec3; 2] {
        let last = x - self.b.te;
        [x - self.a.te, if self.turns() { turned(self.b.ta, self.a.ta, last) } else { last }]
    }

    fn turns(&self) -> bool {
        self.pad != 0.0
    }

    /// The nearest meeting, found by few looks: an inexact one makes a bound weaker and not wrong. Where the axis
    /// turns the way of the point counts as its chord.
    pub(crate) fn meet(&self, x: Vec3) -> Meeting {
        let [from, to] = self.seen(x);
        let v = to - from;
        let still = Pose { te: Vec3::zeros(), ta: self.a.ta };
        let at = |t: f64| {
            let (distance, m) = self.tool.near(&still, from + v * t);
            (Meeting { t, distance, m, reach: 0.0 }, m.dot(&v))
        };
        let reaching = |best: Meeting| Meeting { reach: self.reach(best.m), ..best };
        let (first, mut f0) = at(0.0);
        if f0 >= 0.0 {
            return reaching(first);
        }
        let (last, mut f1) = at(1.0);
        if f1 <= 0.0 {
            return reaching(last);
        }
        let mut best = if last.distance < first.distance { last } else { first };
        let small = SQUARE * v.norm();
        let (mut near, mut far) = ((first, f0), (last, f1));
        // Regula falsi; the end that stays twice counts half, so that it comes nearer from both sides, and every
        // third look is half way: about an edge of the tool the slope jumps.
        let mut stayed = 0;
        for look in 0..LOOKS {
            let (t0, t1) = (near.0.t, far.0.t);
            let t = if look % 3 == 2 { 0.5 * (t0 + t1) } else { t0 - f0 * (t1 - t0) / (f1 - f0) };
            let (now, slope) = at(t);
            if now.distance <= best.distance {
                best = now;
            }
            if slope < 0.0 {
                (near, f0) = ((now, slope), slope);
                f1 *= if stayed < 0 { 0.5 } else { 1.0 };
                stayed = -1;
            } else {
                (far, f1) = ((now, slope), slope);
                f0 *= if stayed > 0 { 0.5 } else { 1.0 };
                stayed = 1;
            }
            if slope.abs() <= small {
                break;
            }
        }
        // Between both directions there is the one that is square to the way, and bounds all of it alike; on a face
        // and about an edge of the tool it is none the worse.
        best.m = (near.0.m * far.1 - far.0.m * near.1).try_normalize(0.0).unwrap_or(best.m);
        reaching(best)
    }

    /// A direction told from both ends alone: where the tool does not turn it bounds the way as the tangents there do.
    pub(crate) fn glance(&self, x: Vec3) -> Meeting {
        let [from, to] = self.seen(x);
        let way = to - from;
        let still = Pose { te: Vec3::zeros(), ta: self.a.ta };
        let [a, b] = [from, to].map(|q| self.tool.near(&still, q).1);
        let (falls, rises) = (a.dot(&way), b.dot(&way));
        self.along(if falls >= 0.0 {
            a
        } else if rises <= 0.0 {
            b
        } else {
            (a * rises - b * falls).try_normalize(0.0).unwrap_or(a)
        })
    }

    /// Meetings with a given direction in the middle of the way and with that square to the way of `x`.
    pub(crate) fn level(&self, m: Vec3, x: Vec3) -> [Meeting; 2] {
        let [from, to] = self.seen(x);
        let own = self.own(m);
        [own, square(own, to - from).unwrap_or(own)].map(|m| self.along(m))
    }

    /// Meetings with a given direction made square to the ring of the tool at the share `t` of the way of `x`, and to
    /// that way too: about an edge of the tool none shows more of a piece with that normal. `None` on the axis.
    pub(crate) fn edge(&self, m: Vec3, x: Vec3, t: f64) -> Option<[Meeting; 2]> {
        let [from, to] = self.seen(x);
        let way = to - from;
        let ring = self.a.ta.cross(&(from + way * t)).try_normalize(0.0)?;
        let off = |w: Vec3| w - ring * w.dot(&ring);
        let m = off(self.own(m)).try_normalize(0.0)?;
        let of = |m: Vec3| Meeting { t, ..self.along(m) };
        Some([of(m), of(square(m, off(way)).unwrap_or(m))])
    }

    /// A direction at the middle of the way, as the axis stands at the first position.
    fn own(&self, m: Vec3) -> Vec3 {
        if self.turns() { turned(self.middle(), self.a.ta, m) } else { m }
    }

    /// The axis in the middle of the way.
    fn middle(&self) -> Vec3 {
        (self.a.ta + self.b.ta).normalize()
    }

    /// What a meeting proves of the distance of a piece about `x` that lies within `radius` of it: not less than
    /// the first number, with the slack of both ends taken off; that of the nearer end is told. The last one is the part
    /// of it that is due to the turn. `slack` tells how much the piece may be nearer in a direction.
    pub(crate) fn proved(
        &self,
        meeting: &Meeting,
        x: Vec3,
        radius: f64,
        slack: impl Fn(Vec3) -> Slack,
    ) -> (f64, Slack, f64) {
        let m = meeting.m;
        if !self.turns() {
            let first = meeting.reach + m.dot(&self.a.te);
            let height = first.max(first + m.dot(&(self.b.te - self.a.te)));
            let slack = slack(m);
            return (m.dot(&x) - height - slack.all, slack, 0.0);
        }
        // The direction turns with the tool, whose support in it stays the same.
        let own = meeting.reach;
        let end = |at: &Pose, m: Vec3| {
            let slack = slack(m);
            (m.dot(&(x - at.te)) - own - slack.all, slack)
        };
        let (a, slack_a) = end(&self.a, m);
        let (b, slack_b) = end(&self.b, turned(self.a.ta, self.b.ta, m));
        let lever = (x - self.a.te).norm().max((x - self.b.te).norm()) + radius;
        let drift = (self.b.te - self.a.te).norm();
        let rise = bulge(lever, self.turn) + 0.25 * self.turn * drift;
        // What is lost at the end that is nearer counts: at the other there is room for it.
        let turning = (-parabola(-a, -b, rise), if a <= b { slack_a } else { slack_b }, rise);
        // A direction that stands still, as it is in the middle of the way: beside a piece square to it the better one.
        let middle = turned(self.a.ta, self.middle(), m);
        let slack = slack(middle);
        let (height, rise) =
            self.tool.height_turning(&self.a, &self.b, middle, &Turn::new(self.turn));
        let standing = (middle.dot(&x) - height - slack.all, slack, rise);
        if standing.0 > turning.0 { standing } else { turning }
    }
}

/// The direction made square to the way, which bounds all of it alike; `None` where it runs along it.
fn square(m: Vec3, v: Vec3) -> Option<Vec3> {
    let square = m - v * (m.dot(&v) / v.norm_squared());
    (square.norm() > 0.5).then(|| square.normalize())
}
