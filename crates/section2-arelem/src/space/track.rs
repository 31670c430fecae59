//! The curve on which the tool moves: in place at drive and part surface (APT: `CENTR`, `CENTR2`).

use aptc_contact::{Condition, Gap, Reason};
use aptc_geometry::{Vec3, trig};

use super::band::Band;
use super::guided::Guides;
use super::keep::{Keep, Pose};
use super::turning::meet;
use crate::axis::{Around, AxisRule, Turn};

/// Rounds of Newton's method; three to five are usual with a fixed axis, some ten with a turning one.
const ROUNDS: usize = 60;

/// The same with an axis whose turn is known; three or four are usual.
const ROUNDS_WITH_AXIS: usize = 8;

/// Halvings of one step to places where nothing faces the tool: each is a search all round it, and a step that leads there
/// by a part of it this small leads nowhere.
pub(super) const MISSED: u32 = 5;

/// Sine between two surfaces below which they run side by side.
pub(super) const SIDE_BY_SIDE: f64 = 1e-7;

/// Drive and part surface with the rule for the axis.
#[derive(Clone, Debug)]
pub(crate) struct Track {
    /// Drive surface, part surface.
    pub(crate) keeps: [Keep; 2],
    /// Their bands.
    pub(super) bands: [Band; 2],
    pub(crate) axis: AxisRule,
    /// What guides the tool past trials by contacts, when there is something.
    pub(crate) guides: Option<Guides>,
    /// Residual of the gaps that counts as zero.
    pub(crate) exact: f64,
    /// A length of the size of the scene.
    pub(crate) size: f64,
}

/// How the track goes on at a place of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Course {
    /// Unit direction of motion.
    pub(crate) along: Vec3,
    /// Second derivatives of the gaps along it.
    pub(crate) bends: [f64; 2],
    /// Curvature of the track.
    pub(crate) curl: Vec3,
}

/// A place on the track.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    pub(crate) pose: Pose,
    pub(crate) gaps: [Gap; 2],
    pub(crate) course: Course,
}

/// What a place that the tool is to settle at has to satisfy.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aim<'a> {
    /// It lies in the plane across this through where the tool settles from.
    pub(crate) across: Vec3,
    /// Its gaps.
    pub(crate) targets: [f64; 2],
    /// The node from which it is come to.
    pub(crate) hint: &'a Node,
    /// The cutter is not to touch deeper elsewhere.
    pub(crate) look: bool,
}

impl<'a> Aim<'a> {
    /// On both surfaces, in the plane across the track at a node.
    pub(crate) fn at(node: &'a Node) -> Self {
        Self { across: node.course.along, targets: [0.0; 2], hint: node, look: true }
    }
}

/// Why there is no place.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Trouble {
    /// No normal pair, or the end of a surface.
    Contact,
    /// The same of a check surface.
    Check,
    /// Drive and part surface run side by side.
    SideBySide,
    /// The iteration ended at its bound.
    Stuck,
    /// The rule of the tool axis has no solution.
    Axis,
}

impl Node {
    /// The node with these gaps that goes on along `along`, along which they bend by `bends`.
    #[inline(always)]
    pub(super) fn new(
        pose: Pose,
        gaps: [Gap; 2],
        along: Vec3,
        bends: [f64; 2],
    ) -> Result<Self, Trouble> {
        let course = Course::new([gaps[0].normal, gaps[1].normal], along, bends)?;
        Ok(Self { pose, gaps, course })
    }
}

impl Course {
    /// That along `along` on which gaps with these gradients bend by `bends`.
    #[inline(always)]
    pub(super) fn new(normals: [Vec3; 2], along: Vec3, bends: [f64; 2]) -> Result<Self, Trouble> {
        let curl = solve_normals([normals[0], normals[1], along], [-bends[0], -bends[1], 0.0]);
        Ok(Self { along, bends, curl: curl.ok_or(Trouble::SideBySide)? })
    }

    /// The same with unit vectors for gradients, this sine between them, and `along` square to both.
    #[inline(always)]
    pub(super) fn across(
        [a, b]: [Vec3; 2],
        sine: f64,
        along: Vec3,
        [at_a, at_b]: [f64; 2],
    ) -> Self {
        let lean = a.dot(&b);
        let curl = (a * (lean * at_b - at_a) + b * (lean * at_a - at_b)) / (sine * sine);
        Self { along, bends: [at_a, at_b], curl }
    }

    /// The way by `s` along the track, to second order, and its direction there.
    #[inline]
    pub(super) fn ahead(&self, s: f64) -> (Vec3, Vec3) {
        let turn = self.curl.norm() * s;
        let (sinc, half) = sinc(turn);
        let (step, bend) = (s * sinc, s * s * half);
        let ahead = self.along * step + self.curl * bend;
        (ahead, self.along * (1.0 - turn * turn * half) + self.curl * step)
    }
}

/// `sin x / x` and `(1 - cos x) / x^2`.
#[inline]
fn sinc(x: f64) -> (f64, f64) {
    /// Up to here the terms that are left out are less than rounding.
    const SMALL: f64 = 0.03;
    let square = x * x;
    if x < SMALL {
        let sinc = 1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0));
        let half = 0.5 - square / 24.0 * (1.0 - square / 30.0 * (1.0 - square / 56.0));
        return (sinc, half);
    }
    let (sin, cos) = trig::sin_cos(x);
    (sin / x, (1.0 - cos) / square)
}

impl From<Reason> for Trouble {
    fn from(_: Reason) -> Self {
        Self::Contact
    }
}

impl Node {
    /// On which hand of the way drive and part surface lie: one sign for all of a motion.
    pub(crate) fn hand(&self) -> f64 {
        let [drive, part] = &self.gaps;
        self.course.along.dot(&drive.normal.cross(&part.normal))
    }
}

impl Track {
    /// Gaps at a pose.
    #[inline]
    pub(super) fn gaps(&self, pose: &Pose, hint: Option<&[Gap; 2]>) -> Result<[Gap; 2], Trouble> {
        let start = |i: usize| hint.map(|h| h[i].spot());
        Ok([self.keeps[0].gap(pose, start(0))?, self.keeps[1].gap(pose, start(1))?])
    }

    /// Gaps at places of contact that are deeper than those of a node, if there are any, and the way for which
    /// there are none; no way longer than `most` is asked for.
    pub(crate) fn deeper(
        &self,
        pose: &Pose,
        gaps: &[Gap; 2],
        most: f64,
    ) -> ([Option<Gap>; 2], f64) {
        let (exact, stands) = (4.0 * self.exact, !self.axis.turns());
        let look = |i: usize| self.keeps[i].deeper_on(pose, &gaps[i], exact, (stands, most));
        let ((a, to_a), (b, to_b)) = (look(0), look(1));
        ([a, b], to_a.min(to_b))
    }

    /// The node at a pose with known gaps, going with `heading`.
    pub(crate) fn finish(
        &self,
        pose: Pose,
        gaps: [Gap; 2],
        heading: Vec3,
    ) -> Result<Node, Trouble> {
        let along = direction(self.slopes(&pose, &gaps), heading)?;
        let bend = |i: usize| self.keeps[i].bend(&pose, &gaps[i], along);
        Node::new(pose, gaps, along, [bend(0), bend(1)])
    }

    /// How fast the gaps grow with the tool end: their normals, and beside rulings what the axis brings that turns with it.
    fn slopes(&self, pose: &Pose, gaps: &[Gap; 2]) -> [Vec3; 2] {
        let turn = match self.axis {
            AxisRule::Rulings(_) => {
                self.axis.by_place(pose.te, pose.ta, self.keeps.each_ref()).map(|(_, turn)| turn)
            }
            _ => None,
        };
        match turn {
            Some(turn) => gaps.each_ref().map(|gap| slope(pose, gap, &turn)),
            None => [gaps[0].normal, gaps[1].normal],
        }
    }

    /// The place that is aimed at.
    ///
    /// The gradients of the gaps are the surface normals, so Newton's method converges quadratically; the
    /// 3x3 system is solved by vector products. A step that does not bring the gaps nearer is halved.
    pub(crate) fn settle(&self, start: Pose, aim: &Aim<'_>) -> Result<Node, Trouble> {
        // A tool end beyond the end of a surface on which it is finds no way back onto it.
        let ends = |keep: &Keep| keep.is_on() && keep.runs_out(start.te);
        if self.keeps.iter().any(ends) {
            return Err(Trouble::Stuck);
        }
        if matches!(self.axis, AxisRule::Normal(_) | AxisRule::Rulings(_))
            && let Ok(found) = self.settle_with_axis(start, aim)
        {
            return Ok(found);
        }
        match self.settle_by_normals(start, aim, &aim.hint.gaps) {
            Err(_) if self.axis.turns() => self.settle_turning(start, aim),
            found => found,
        }
    }

    /// As [`Track::settle`] where the place of the tool end alone tells the axis: Newton's method knows then how the
    /// gaps change as the axis turns. Where the flank lies along a surface the place that touches jumps, and it may fail.
    fn settle_with_axis(&self, start: Pose, aim: &Aim<'_>) -> Result<Node, Trouble> {
        let Aim { across, targets, hint, look } = *aim;
        let level = across.dot(&start.te);
        let keeps = [&self.keeps[0], &self.keeps[1]];
        let mut pose = start;
        let mut near = hint.gaps;
        for _ in 0..ROUNDS_WITH_AXIS {
            let (ta, turn) = self.axis.by_place(pose.te, pose.ta, keeps).ok_or(Trouble::Axis)?;
            pose.ta = ta;
            let gaps = self.gaps(&pose, Some(&near))?;
            let off =
                [targets[0] - gaps[0].g, targets[1] - gaps[1].g, level - across.dot(&pose.te)];
            if off.iter().all(|o| o.abs() <= self.exact) {
                let deeper = if look { self.deeper(&pose, &gaps, 0.0).0 } else { [None, None] };
                if deeper.iter().all(Option::is_none) {
                    return self.finish(pose, gaps, self.onward(&pose, &gaps, hint));
                }
                // The cutter touches elsewhere first: on from there.
                near = [0, 1].map(|i| deeper[i].unwrap_or(gaps[i]));
                continue;
            }
            near = gaps;
            let row = |i: usize| slope(&pose, &gaps[i], &turn);
            pose.te += meet([row(0), row(1), across], off).ok_or(Trouble::SideBySide)?;
        }
        Err(Trouble::Stuck)
    }

    fn settle_by_normals(
        &self,
        start: Pose,
        aim: &Aim<'_>,
        near: &[Gap; 2],
    ) -> Result<Node, Trouble> {
        let Aim { across, targets, hint, look } = *aim;
        let level = across.dot(&start.te);
        let turning = self.axis.turns();
        let mut pose = start;
        let mut near = *near;
        let mut last = (f64::INFINITY, pose, Vec3::zeros());
        let mut missed = 0;
        for _ in 0..ROUNDS {
            let gaps = match self.gaps(&pose, Some(&near)) {
                Ok(gaps) => {
                    missed = 0;
                    gaps
                }
                Err(trouble) if last.0.is_infinite() || missed >= MISSED => return Err(trouble),
                Err(_) => {
                    missed += 1;
                    last.2 *= 0.5;
                    pose.te = last.1.te + last.2;
                    continue;
                }
            };
            let off = [targets[0] - gaps[0].g, targets[1] - gaps[1].g];
            let out = level - across.dot(&pose.te);
            let worst = off[0].abs().max(off[1].abs()).max(out.abs());
            let mut turned = 0.0;
            let mut ta = pose.ta;
            if turning {
                let along = direction([gaps[0].normal, gaps[1].normal], hint.course.along)?;
                let around = Around { te: pose.te, ta, part: &gaps[1], drive: &gaps[0], along };
                ta =
                    self.axis.at(&around, [&self.keeps[0], &self.keeps[1]]).ok_or(Trouble::Axis)?;
                turned = (ta - pose.ta).norm();
            }
            if worst <= self.exact && turned <= 1e-11 {
                let deeper = if look { self.deeper(&pose, &gaps, 0.0).0 } else { [None, None] };
                if deeper.iter().all(Option::is_none) {
                    // The last step goes without a look: whether what is left counts as nothing is no matter then.
                    let step = solve(&gaps, across, [off[0], off[1], out]).unwrap_or_default();
                    let moved = |i: usize| Gap {
                        g: gaps[i].g + gaps[i].normal.dot(&step),
                        raw: gaps[i].raw + gaps[i].normal.dot(&step),
                        tool_point: gaps[i].tool_point + step,
                        ..gaps[i]
                    };
                    let (pose, gaps) = (Pose { te: pose.te + step, ..pose }, [moved(0), moved(1)]);
                    return self.finish(pose, gaps, self.onward(&pose, &gaps, hint));
                }
                // The cutter touches elsewhere first: on from there.
                near = [0, 1].map(|i| deeper[i].unwrap_or(gaps[i]));
                last = (f64::INFINITY, pose, Vec3::zeros());
                continue;
            }
            if !turning && worst > 0.9 * last.0 && worst > 10.0 * self.exact {
                // Too far: back, and half the step.
                last.2 *= 0.5;
                if last.2.norm() <= self.exact {
                    break;
                }
                pose.te = last.1.te + last.2;
                continue;
            }
            near = gaps;
            let step = solve(&gaps, across, [off[0], off[1], out]).ok_or(Trouble::SideBySide)?;
            last = (worst, pose, step);
            pose = Pose { te: pose.te + step, ta };
        }
        Err(Trouble::Stuck)
    }

    /// The direction in which the track goes on from a node at a place near it: as there, but where it turns
    /// sharply. Round an edge no track turns more than its way over the radius of what touches; what turns more
    /// has a corner in a hollow on the way, and leads away from the place of contact before it.
    fn onward(&self, pose: &Pose, gaps: &[Gap; 2], hint: &Node) -> Vec3 {
        let way = (pose.te - hint.pose.te).norm();
        let Ok(t) = direction(self.slopes(pose, gaps), hint.course.along) else {
            return hint.course.along;
        };
        let changed = |i: usize| (gaps[i].normal - hint.gaps[i].normal).norm();
        let i = usize::from(changed(1) > changed(0));
        let keep = &self.keeps[i];
        let level = [gaps[i].normal, hint.gaps[i].normal].map(|n| n.dot(&pose.ta).abs() < 0.3);
        // What touches a floor is rounded by the corner radius alone.
        let beside = level[0] && level[1];
        let radius = if beside { keep.profile.widest() } else { keep.profile.corner_radius() };
        let touches = keep.condition == Condition::Touch && !keep.is_plane();
        let sharp = touches && t.dot(&hint.course.along) < 0.5 && way < 0.1 * radius;
        let rise = t.dot(&hint.gaps[i].normal);
        if sharp && rise < -0.1 { -t } else { t }
    }

    /// The place at the distance `s` along the track from a node, to second order, then settled.
    pub(crate) fn walk(
        &self,
        from: &Node,
        s: f64,
        targets: [f64; 2],
        look: bool,
    ) -> Result<Node, Trouble> {
        self.walk_beside(from, s, targets, look, None)
    }

    /// The same place, found sooner from a node beside it that touches at the same places of the cutter.
    pub(crate) fn walk_beside(
        &self,
        from: &Node,
        s: f64,
        targets: [f64; 2],
        look: bool,
        beside: Option<&Node>,
    ) -> Result<Node, Trouble> {
        let (step, across) = from.course.ahead(s);
        let start = Pose { te: from.pose.te + step, ta: from.pose.ta };
        let aim = Aim { across, targets, hint: from, look };
        let sooner = beside.filter(|_| !self.axis.turns()).and_then(|known| {
            let begin = moved(known, across, across.dot(&start.te), targets)?;
            self.settle_by_normals(begin, &aim, &known.gaps).ok()
        });
        let found = match sooner {
            Some(node) => Ok(node),
            None => self.settle(start, &aim),
        };
        if let Ok(to) = &found
            && (to.pose.te - from.pose.te).norm() > self.farthest(s)
            && !self.axis.turns()
        {
            return Err(Trouble::Stuck);
        }
        // A plane across that is turned by much may meet the track behind as well.
        let back = |to: &Node| (from.pose.te - to.pose.te).dot(&from.course.along);
        if found.as_ref().is_ok_and(|to| back(to) > self.bands[0].width + self.bands[1].width) {
            return Err(Trouble::Stuck);
        }
        found
    }

    /// Greatest length of a cut vector `s` along the track: where the curvature ends on the way, the plane across may
    /// meet the track far away.
    #[inline]
    pub(super) fn farthest(&self, s: f64) -> f64 {
        2.0 * (s + self.bands[0].width + self.bands[1].width)
    }
}

/// Where the track meets the plane `across` at `level` beside a known place of it, to second order.
fn moved(known: &Node, across: Vec3, level: f64, targets: [f64; 2]) -> Option<Pose> {
    let ahead = level - across.dot(&known.pose.te);
    let s = ahead / across.dot(&known.course.along);
    let off = |i: usize| targets[i] - known.gaps[i].g - 0.5 * known.course.bends[i] * s * s;
    let step = solve(&known.gaps, across, [off(0), off(1), ahead])?;
    Some(Pose { te: known.pose.te + step, ta: known.pose.ta })
}

/// How fast a gap grows with the tool end as the axis turns with it: a turn by d ta moves the tool point by (ta x d ta) x w, w
/// from the tool end to it.
fn slope(pose: &Pose, gap: &Gap, turn: &Turn) -> Vec3 {
    let (n, w) = (gap.normal, gap.tool_point - pose.te);
    n + turn.gradient(n * pose.ta.dot(&w) - w * n.dot(&pose.ta))
}

/// The direction along which two gaps with these slopes stay, on the side of `heading`.
pub(super) fn direction(slopes: [Vec3; 2], heading: Vec3) -> Result<Vec3, Trouble> {
    let cross = slopes[0].cross(&slopes[1]);
    let l = cross.norm();
    if l <= SIDE_BY_SIDE {
        return Err(Trouble::SideBySide);
    }
    let t = cross / l;
    Ok(if t.dot(&heading) < 0.0 { -t } else { t })
}

/// The vector with given products with both normals and with `across`.
fn solve(gaps: &[Gap; 2], across: Vec3, rhs: [f64; 3]) -> Option<Vec3> {
    solve_normals([gaps[0].normal, gaps[1].normal, across], rhs)
}

/// The vector with given products with three unit vectors.
pub(crate) fn solve_normals([a, b, c]: [Vec3; 3], rhs: [f64; 3]) -> Option<Vec3> {
    let ab = a.cross(&b);
    let det = ab.dot(&c);
    (det.abs() > SIDE_BY_SIDE * 0.1)
        .then(|| (b.cross(&c) * rhs[0] + c.cross(&a) * rhs[1] + ab * rhs[2]) / det)
}
