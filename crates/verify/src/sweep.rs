//! The tool on its way along a cut vector, held against points by separating planes.

use aptc_geometry::Vec3;

use crate::between::{bulge, parabola};
use crate::each::two;
use crate::solid::unit_or;
use crate::tool::{Pose, Tool, Turn};

/// Looks for the nearest meeting, and the sine at which it is square to the way.
const LOOKS: u32 = 18;
const SQUARE: f64 = 1e-9;
/// Cosine of directions that show the same but for a little.
const SAME: f64 = 0.9999;

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
    /// How it turns, when it does.
    spin: Option<Spin>,
}

/// Part of what a turn takes by which a piece may be larger before a shorter way is tried: it takes so much more time to cut
/// pieces than ways.
const SEEN: f64 = 0.1;

/// How the axis turns, once for all pieces.
#[derive(Clone, Copy, Debug)]
struct Spin {
    turn: Turn,
    /// Unit axis of the turn.
    k: Vec3,
    /// Sine and cosine of half of it and of all of it.
    to_middle: [f64; 2],
    to_last: [f64; 2],
    /// The way of the tool end, where it is in the middle, and its length.
    way: Vec3,
    half: Vec3,
    drift: f64,
}

impl Spin {
    /// A vector turned about the axis of the turn by an angle, by its sine and cosine, the sine below 0 for the way back.
    #[inline]
    fn turned(&self, x: Vec3, [sin, cos]: [f64; 2]) -> Vec3 {
        if self.k == Vec3::zeros() {
            return x;
        }
        x * cos + self.k.cross(&x) * sin + self.k * (self.k.dot(&x) * (1.0 - cos))
    }

    /// By how much `m . (p - te)` may be less along the way than evenly between its values at the ends, for all points p within
    /// `radius` of `x`, the direction turning with the tool from `m` in the middle of the way: the part `4 t (1 - t)` of it.
    ///
    /// With `w = x - te` the second derivative is `-turn^2 m_k . w - 2 turn (k x m) . v`, `m_k` being the part of m square to the
    /// axis of the turn, and the third `turn^3 lever + 3 turn^2 |v|` at most. So a tool that rolls over a crest comes nearer
    /// to a place by what it is seen to, and one that rolls through a hollow by nothing.
    fn rise(&self, m: Vec3, x: Vec3, lever: f64, radius: f64) -> [f64; 2] {
        let (k, turn) = (self.k, self.turn.angle);
        if self.k == Vec3::zeros() {
            return [bulge(lever, turn) + 0.25 * turn * self.drift; 2];
        }
        let w = x - self.half;
        let middle = -turn * turn * (m.dot(&w) - k.dot(&m) * k.dot(&w))
            - 2.0 * turn * k.cross(&m).dot(&self.way);
        let third = turn * turn * (turn * lever + 3.0 * self.drift);
        let lost = 0.125 * (0.5 * third + turn * turn * radius);
        let rise = (0.125 * middle + lost).max(0.0);
        [rise, lost.min(rise).max(SEEN * rise)]
    }
}

impl<'a> Sweep<'a> {
    /// From one position to another, the axis turning by `turn`; angles of rounding count as none.
    pub(crate) fn new(tool: &'a Tool<'a>, a: Pose, b: Pose, turn: f64) -> Self {
        let turn = if turn <= 1e-15 { 0.0 } else { turn };
        let pad = bulge(tool.reach(), turn);
        let spin = (pad != 0.0).then(|| {
            let k = unit_or(a.ta.cross(&b.ta), Vec3::zeros());
            let by = |to: Vec3| [k.dot(&a.ta.cross(&to)), a.ta.dot(&to)];
            Spin {
                turn: Turn::new(turn),
                k,
                to_middle: by(unit_or(a.ta + b.ta, a.ta)),
                to_last: by(b.ta),
                way: b.te - a.te,
                half: 0.5 * (a.te + b.te),
                drift: (b.te - a.te).norm(),
            }
        });
        Self { tool, a, b, turn, pad, spin }
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
    /// What else does not hang on what is met, when the axis turns.
    spun: Option<Spun>,
}

/// A direction while the axis turns.
#[derive(Clone, Copy, Debug)]
struct Spun {
    /// As it is in the middle of the way and at its end when it turns along.
    middle: Vec3,
    last: Vec3,
    /// How high the tool comes on its way along the middle one, and what the turn makes of it, where that is kept.
    height: Option<(f64, f64)>,
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
    /// What is allowed for the turn of the axis near the tool.
    pub(crate) fn turned(&self) -> f64 {
        self.spin.map_or(0.0, |spin| self.pad + 0.25 * self.turn * spin.drift)
    }

    /// The middle of a sphere that holds all of the way, and its radius.
    pub(crate) fn sphere(&self) -> (Vec3, f64) {
        let (up, radius) = self.tool.middle();
        let [a, b] = two([self.a, self.b], |at| at.te + at.ta * up);
        let half = 0.5 * (b - a);
        (a + half, half.norm() + radius + self.pad)
    }

    /// Any unit direction, wherever on the way.
    pub(crate) fn along(&self, m: Vec3) -> Meeting {
        Meeting { t: 0.5, distance: f64::INFINITY, m, reach: self.reach(m), spun: self.spun(m) }
    }

    fn spun(&self, m: Vec3) -> Option<Spun> {
        let spin = self.spin.as_ref()?;
        let (middle, last) = (spin.turned(m, spin.to_middle), spin.turned(m, spin.to_last));
        Some(Spun { middle, last, height: None })
    }

    /// The same meeting for many pieces: what does not hang on them is made once.
    pub(crate) fn kept(&self, mut meeting: Meeting) -> Meeting {
        if let (Some(spin), Some(spun)) = (&self.spin, &mut meeting.spun) {
            spun.height.get_or_insert_with(|| self.standing(spin, spun.middle));
        }
        meeting
    }

    fn standing(&self, spin: &Spin, m: Vec3) -> (f64, f64) {
        self.tool.height_about(&self.a, &self.b, m, &spin.turn, spin.k)
    }

    /// How far the tool reaches in a direction from its end, as the axis stands at the first position.
    fn reach(&self, m: Vec3) -> f64 {
        self.tool.height(&Pose { te: Vec3::zeros(), ta: self.a.ta }, m)
    }

    /// The point seen from the tool at both ends, as the axis stands at the first.
    fn seen(&self, x: Vec3) -> [Vec3; 2] {
        let last = x - self.b.te;
        let back = |spin: Spin| spin.turned(last, [-spin.to_last[0], spin.to_last[1]]);
        [x - self.a.te, self.spin.map_or(last, back)]
    }

    /// The nearest meeting, found by few looks: an inexact one makes a bound weaker and not wrong. Where the axis
    /// turns the way of the point counts as its chord.
    pub(crate) fn meet(&self, x: Vec3) -> Meeting {
        self.meet_within(x).0
    }

    /// The same, and where the point passes an edge of the tool within, from one face to another, what [`Sweep::turning`] takes for
    /// both together. With `d >= a . q - h(a)` and the same of b the distance is no less than the mean of both by any weights, and
    /// that is less than what the unit direction between them shows: how deep the point is in all that the tool sweeps, and in
    /// each tool on its way it is less deep.
    pub(crate) fn meet_within(&self, x: Vec3) -> (Meeting, Option<Meeting>) {
        let [from, to] = self.seen(x);
        let v = to - from;
        let still = Pose { te: Vec3::zeros(), ta: self.a.ta };
        let at = |t: f64| {
            let (distance, m) = self.tool.near(&still, from + v * t);
            (Meeting { t, distance, m, reach: 0.0, spun: None }, m.dot(&v))
        };
        let reaching =
            |best: Meeting| Meeting { reach: self.reach(best.m), spun: self.spun(best.m), ..best };
        let (first, mut f0) = at(0.0);
        if f0 >= 0.0 {
            return (reaching(first), None);
        }
        let (last, mut f1) = at(1.0);
        if f1 <= 0.0 {
            return (reaching(last), None);
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
        let between = near.0.m * far.1 - far.0.m * near.1;
        best.m = between.try_normalize(0.0).unwrap_or(best.m);
        let within = (best.distance < 0.0 && near.0.m.dot(&far.0.m) < SAME).then(|| {
            let all = far.1 - near.1;
            let reach = (self.reach(near.0.m) * far.1 - self.reach(far.0.m) * near.1) / all;
            let m = between / all;
            Meeting { m, reach, spun: self.spun(m), ..best }
        });
        (reaching(best), within)
    }

    /// A direction told from both ends alone: where the tool does not turn it bounds the way as the tangents there do.
    pub(crate) fn glance(&self, x: Vec3) -> Meeting {
        let [from, to] = self.seen(x);
        let way = to - from;
        let still = Pose { te: Vec3::zeros(), ta: self.a.ta };
        let [a, b] = two([from, to], |q| self.tool.near(&still, q).1);
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
        two([own, square(own, to - from).unwrap_or(own)], |m| self.along(m))
    }

    /// A given direction in the middle of the way, made square to the way of `x`.
    pub(crate) fn square(&self, m: Vec3, x: Vec3) -> Vec3 {
        let [from, to] = self.seen(x);
        let own = self.own(m);
        square(own, to - from).unwrap_or(own)
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
        self.spin.map_or(m, |spin| spin.turned(m, [-spin.to_middle[0], spin.to_middle[1]]))
    }

    /// What a meeting proves of the distance of a piece about `x` that lies within `radius` of it: not less than
    /// the first number, with the slack of both ends taken off; that of the nearer end is told. The last one is the part
    /// of it that is due to the turn. `slack` tells how much the piece may be nearer in a direction; when `enough` is proved no more is
    /// looked for.
    pub(crate) fn proved(
        &self,
        meeting: &Meeting,
        x: Vec3,
        radius: f64,
        enough: f64,
        slack: impl Fn(Vec3) -> Slack,
    ) -> (f64, Slack, f64) {
        let turning = self.turning(meeting, x, radius, &slack);
        let (Some(spin), Some(spun)) = (&self.spin, &meeting.spun) else { return turning };
        if turning.0 >= enough {
            return turning;
        }
        // A direction that stands still, as it is in the middle of the way: beside a piece square to it the better one.
        let slack = slack(spun.middle);
        let (height, rise) = spun.height.unwrap_or_else(|| self.standing(spin, spun.middle));
        let standing = (spun.middle.dot(&x) - height - slack.all, slack, rise);
        if standing.0 > turning.0 { standing } else { turning }
    }

    /// The same by the direction alone that turns with the tool, whose support in it stays the same.
    pub(crate) fn turning(
        &self,
        meeting: &Meeting,
        x: Vec3,
        radius: f64,
        slack: &impl Fn(Vec3) -> Slack,
    ) -> (f64, Slack, f64) {
        let m = meeting.m;
        let (Some(spin), Some(spun)) = (&self.spin, &meeting.spun) else {
            let first = meeting.reach + m.dot(&self.a.te);
            let height = first.max(first + m.dot(&(self.b.te - self.a.te)));
            let slack = slack(m);
            return (m.dot(&x) - height - slack.all, slack, 0.0);
        };
        let end = |at: &Pose, m: Vec3| {
            let slack = slack(m);
            (m.dot(&(x - at.te)) - meeting.reach - slack.all, slack)
        };
        let (a, slack_a) = end(&self.a, m);
        let (b, slack_b) = end(&self.b, spun.last);
        let lever = (x - self.a.te).norm().max((x - self.b.te).norm()) + radius;
        let [rise, lost] = spin.rise(spun.middle, x, lever, radius);
        // What is lost at the end that is nearer counts: at the other there is room for it.
        (-parabola(-a, -b, rise), if a <= b { slack_a } else { slack_b }, lost)
    }
}

/// The direction made square to the way, which bounds all of it alike; `None` where it runs along it.
fn square(m: Vec3, v: Vec3) -> Option<Vec3> {
    let square = m - v * (m.dot(&v) / v.norm_squared());
    (square.norm() > 0.5).then(|| square.normalize())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::between::{angle, between_poses};
    use aptc_geometry::{Cutter, Profile};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        /// No point of a piece is nearer to a tool that turns than what any direction proves.
        #[test]
        fn what_is_proved_holds_all_the_way(
            x in prop::array::uniform3(-12.0..12.0_f64), m in prop::array::uniform3(-1.0..1.0_f64),
            v in prop::array::uniform3(-6.0..6.0_f64), lean in prop::array::uniform4(-1.0..1.0_f64),
            side in prop::array::uniform3(-2.0..2.0_f64), small in 0.0..1.0_f64, corner in 0.0..4.0_f64,
        ) {
            let profile = Profile::new(&Cutter::mill(8.0, corner, 30.0)).unwrap();
            let tool = Tool::Solid(&profile);
            let up = |x: f64, y: f64| Vec3::new(x, y, 1.0).normalize();
            let a = Pose { te: Vec3::new(1.0, -2.0, 0.5), ta: up(lean[0], lean[1]) };
            let ta = up(lean[0] + small * lean[2], lean[1] + small * lean[3]);
            let b = Pose { te: a.te + Vec3::from(v), ta };
            let sweep = Sweep::new(&tool, a, b, angle(a.ta, b.ta));
            let (x, side) = (Vec3::from(x), Vec3::from(side));
            let Some(m) = Vec3::from(m).try_normalize(1e-3) else { return Ok(()) };
            let slack = |m: Vec3| Slack { by: [0.0; 2], all: m.dot(&side).abs() };
            let meetings = [sweep.along(m), sweep.meet(x), sweep.level(m, x)[1]];
            let lows = meetings.map(|m| sweep.proved(&m, x, side.norm(), f64::INFINITY, slack).0);
            let within = sweep.meet_within(x).1;
            let within = within.map(|m| sweep.turning(&m, x, side.norm(), &slack).0);
            for low in lows.into_iter().chain(within) {
                for i in 0..=40 {
                    let at = between_poses(&a, &b, f64::from(i) / 40.0);
                    for s in [-1.0, -0.5, 0.0, 0.5, 1.0] {
                        let far = tool.near(&at, x + side * s).0;
                        prop_assert!(far >= low - 1e-9, "{i} {s} {far} {low}");
                    }
                }
            }
        }
    }
}
