//! The gap to a check surface along a cut vector: its zeros, its extreme values, and where it keeps its value.

use aptc_contact::{Condition, Gap, Side, on};
use aptc_geometry::Vec3;

use super::keep::Keep;
use super::stride::Stride;
use super::track::{Node, Track, Trouble, solve_normals};

/// Bound of each search along one cut vector.
pub(super) const ROUNDS: usize = 80;

/// Halvings in the search for the last place that faces a surface with ends.
const FACING: u32 = 14;

/// Pieces of a way, and places of it at which the foot of the tool end is no end of the surface, that are looked at for the first that
/// faces it.
pub(super) const PIECES: f64 = 4096.0;
const TRIES: u32 = 16;

/// How often a way is halved towards its beginning in search of a place that can be read.
const NEARER: i32 = 8;

/// How often the places of a tool's axis are looked at twice as close for one that is in a surface.
const CLOSER: u32 = 8;

/// How often a piece of a cut vector over a surface of mixed curvature is halved. Where more halvings are left the piece is
/// too long for its ends to tell how often the gap changes its sign in between.
pub(super) const HALVINGS: u32 = 6;

/// Rate of change of a gap along the track that is never exceeded, the turning of the axis apart.
pub(super) const RATE: f64 = 1.5;

/// Share of a zero's value that a step of Newton's method is to leave of it at most.
const SLOW: f64 = 0.5;

/// Sine of the angle below which a check surface is met at a graze.
pub(super) const GRAZING: f64 = 0.1;

/// A value of the gap on the track.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub(super) s: f64,
    pub(super) te: Vec3,
    pub(super) gap: Gap,
    pub(super) slope: f64,
}

/// The way between two nodes.
pub(super) struct Way<'a> {
    pub(super) track: &'a Track,
    pub(super) from: &'a Node,
    pub(super) stride: &'a Stride,
    /// Turning of the axis over the length.
    pub(super) turn: Vec3,
}

/// A place where a gauge reads zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub(super) s: f64,
    /// Does the gap turn back there?
    pub(super) touch: bool,
    /// Does it fall there?
    pub(super) falls: bool,
}

/// Is the gap in the band, but for rounding?
pub(super) fn in_limits(keep: &Keep, gap: f64, exact: f64) -> bool {
    let limits = keep.limits();
    (limits.low - exact..=limits.high + exact).contains(&gap)
}

/// Gap to the check surface, near a gap that is known.
pub(super) fn read(keep: &Keep, node: &Node, near: Option<&Gap>) -> Result<Gap, Trouble> {
    keep.gap_from(&node.pose, near).or_else(|_| sunk(keep, node).ok_or(Trouble::Check))
}

/// A bound of the gap of a cutter that is so deep in the surface that no pair of points faces each other: the depth of a point
/// of its axis, or of a place of the surface in it. `None` where none of those looked at is in it.
///
/// On the way through a small ellipsoid a cutter is there for a while. The gap is at most that of any point of the cutter,
/// so that it is negative with the bound; where it is zero there is a pair.
pub(super) fn sunk(keep: &Keep, node: &Node) -> Option<Gap> {
    if keep.condition == Condition::On || keep.side == Side::Open {
        return None;
    }
    let (te, ta, height) = (node.pose.te, node.pose.ta, keep.profile.height());
    let at = |up: f64| {
        let gap = on(te + ta * up, &keep.surface, keep.side);
        Gap { g: gap.raw - keep.thick, ..gap }
    };
    // A place of the surface next to them may be in the tool.
    let tool = keep.tool(&node.pose);
    let holds = |gap: &Gap| {
        let near = tool.near(gap.surface_point);
        let g = near.distance - keep.thick;
        Gap { g, raw: near.distance, tool_point: near.point, ..*gap }
    };
    let deeper = |a: Gap, b: Gap| if b.g < a.g { b } else { a };
    let deepest = |ups: [f64; 5]| {
        let all = ups.map(|up| (up, at(up)));
        let held = all.map(|(_, gap)| holds(&gap)).into_iter().reduce(deeper)?;
        let (up, gap) = all.into_iter().min_by(|a, b| a.1.g.total_cmp(&b.1.g))?;
        Some((up, deeper(gap, held)))
    };
    let mut part = 0.25 * height;
    let (mut up, mut gap) = deepest([0.0, 1.0, 2.0, 3.0, 4.0].map(|k| k * part))?;
    // A small body may lie between two of those.
    for _ in 0..CLOSER {
        if gap.g < -keep.width() {
            return Some(gap);
        }
        part *= 0.5;
        let beside = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| (up + k * part).clamp(0.0, height));
        (up, gap) = deepest(beside)?;
    }
    None
}

impl Way<'_> {
    pub(super) fn node(&self, s: f64) -> Result<Node, Trouble> {
        self.track.walk(self.from, s, self.targets(s), false)
    }

    /// The gaps asked for at `s`: those of the end, but close behind the node those between, for a way without a jump.
    fn targets(&self, s: f64) -> [f64; 2] {
        let near: f64 = self.track.keeps.iter().map(Keep::width).sum();
        let share = if s < near { s / near } else { 1.0 };
        let [a, b] = [0, 1].map(|i| (self.from.gaps[i].g, self.stride.targets[i]));
        [a, b].map(|(from, to)| if share < 1.0 { from + (to - from) * share } else { to })
    }

    /// The same where the motion may end: no other place of contact is deeper.
    pub(super) fn settled(&self, s: f64) -> Result<Node, Trouble> {
        self.track.walk(self.from, s, self.targets(s), true)
    }

    /// The place near `s`, with its node, where the gap is `wanted`, as far as it does not only graze the surface.
    pub(super) fn to_reading(
        &self,
        keep: &Keep,
        mut s: f64,
        mut node: Node,
        wanted: f64,
    ) -> Result<(f64, Node), Trouble> {
        // The last place with its reading: where the tool moves by more than `s` the slope along the track alone leads too far.
        let mut last: Option<(f64, f64)> = None;
        for _ in 0..8 {
            let gap = read(keep, &node, None)?;
            let off = gap.g - wanted;
            let slope = self.slope(&node, &gap);
            if off.abs() <= self.track.exact || slope.abs() < GRAZING {
                break;
            }
            let chord = last.map(|(at, was)| (off - was) / (s - at));
            let slope = chord.filter(|c| c * slope > slope * slope).unwrap_or(slope);
            last = Some((s, off));
            let next = s - off / slope;
            if !(0.0..=self.stride.length).contains(&next) {
                break;
            }
            s = next;
            node = self.settled(s)?;
        }
        Ok((s, node))
    }

    /// Change of a gap with the way.
    pub(super) fn slope(&self, node: &Node, gap: &Gap) -> f64 {
        gap.normal.dot(&self.rate(node)) + gap.turn_rate(node.pose.te, self.turn)
    }

    /// Change of the tool end with the way, on which the gaps to drive and part surface stay: what turns in place leaves them.
    ///
    /// So a check surface that is touched where one of those is, with the same normal, has no slope, however the axis turns there.
    pub(super) fn rate(&self, node: &Node) -> Vec3 {
        let along = node.course.along;
        if self.turn == Vec3::zeros() {
            return along;
        }
        let [a, b] = node.gaps.each_ref();
        let rest = |gap: &Gap| -gap.normal.dot(&along) - gap.turn_rate(node.pose.te, self.turn);
        let aside = solve_normals([a.normal, b.normal, along], [rest(a), rest(b), 0.0]);
        along + aside.unwrap_or_default()
    }

    /// Is the gap to be that of the whole cutter? Where several places of it may touch, and it may be at the surface on
    /// the way: no point of it is farther from the middle of its axis than the corner of its box.
    pub(super) fn whole(&self, keep: &Keep) -> bool {
        if simple(keep) || keep.condition == Condition::On {
            return false;
        }
        let half = 0.5 * keep.profile.height();
        let around = aptc_geometry::trig::hypot(half, keep.profile.widest()) + keep.thick.abs();
        let clear = |node: &Node| {
            let middle = node.pose.te + node.pose.ta * half;
            keep.surface.distance(middle).abs() - around
        };
        let change = self.stride.most(self.from) * RATE
            + self.stride.length * self.turn.norm() * keep.profile.reach();
        clear(self.from) + clear(&self.stride.to) <= change
    }

    pub(super) fn sample(&self, keep: &Keep, s: f64, near: &Sample) -> Result<Sample, Trouble> {
        let node = self.node(s)?;
        let beside = |trouble| keep.gap_from(&node.pose, Some(&near.gap)).map_err(|_| trouble);
        let gap = if simple(keep) {
            read(keep, &node, Some(&near.gap))?
        } else {
            read(keep, &node, None).or_else(beside)?
        };
        Ok(self.read(&node, s, gap))
    }

    /// What is read at a node.
    pub(super) fn read(&self, node: &Node, s: f64, gap: Gap) -> Sample {
        Sample { s, te: node.pose.te, gap, slope: self.slope(node, &gap) }
    }

    /// The first place, about, where something of a surface with ends faces the cutter that comes from beyond one of them.
    pub(super) fn first_facing(&self, keep: &Keep) -> Option<Sample> {
        let profile = &keep.profile;
        let beyond = |te: Vec3| {
            let foot = keep.surface.foot(te);
            (keep.surface.ends_at(foot.at), (foot.point - te).norm())
        };
        let (from, to) = (self.from.pose.te, self.stride.to.pose.te);
        let (mut ends, mut away) = beyond(from);
        if !ends {
            return None;
        }
        let (length, mut s, mut tries) = (self.stride.length, 0.0, 0);
        let piece = profile.widest().max(length / PIECES);
        while tries < TRIES {
            // Nothing of the surface is nearer to the tool than the foot of its end, its reach apart.
            s += piece.max((away - profile.reach()) / RATE);
            if s >= length {
                break;
            }
            (ends, away) = beyond(from + (to - from) * (s / length));
            if !ends {
                let read = self.node(s).and_then(|n| Ok(self.read(&n, s, read(keep, &n, None)?)));
                if let Ok(sample) = read {
                    return Some(sample);
                }
                tries += 1;
            }
        }
        None
    }

    /// The last place after `a`, about, where something of the surface faces the cutter.
    pub(super) fn last_facing(&self, keep: &Keep, a: &Sample) -> Option<Sample> {
        let (mut low, mut high) = (None, self.stride.length);
        for _ in 0..FACING {
            let s = 0.5 * (low.map_or(a.s, |l: Sample| l.s) + high);
            match self.sample(keep, s, low.as_ref().unwrap_or(a)) {
                Ok(sample) => low = Some(sample),
                Err(_) => high = s,
            }
        }
        low
    }

    /// The zero of `f` between two samples of opposite sign, by Newton's method kept in the bracket.
    pub(super) fn zero(
        &self,
        keep: &Keep,
        a: Sample,
        b: Sample,
        f: impl Fn(&Sample) -> f64,
        newton: impl Fn(&Sample) -> Option<f64>,
        enough: f64,
    ) -> Result<Sample, Trouble> {
        let (mut a, mut b) = (a, b);
        let mut best = if f(&a).abs() < f(&b).abs() { a } else { b };
        let mut side = 0_i32;
        let (mut fa, mut fb) = (f(&a), f(&b));
        for _ in 0..ROUNDS {
            if f(&best).abs() <= enough || b.s - a.s <= 1e-15 * (b.s.abs() + 1e-300) {
                break;
            }
            let secant = (a.s * fb - b.s * fa) / (fb - fa);
            let s = newton(&best).filter(|s| *s > a.s && *s < b.s).unwrap_or(secant);
            let s = if s > a.s && s < b.s { s } else { 0.5 * (a.s + b.s) };
            let at = self.sample(keep, s, &best)?;
            let value = f(&at);
            // Illinois: the end that stays loses weight, so that the bracket closes from both sides.
            if (value > 0.0) == (fa > 0.0) {
                (a, fa) = (at, value);
                if side == 1 {
                    fb *= 0.5;
                }
                side = 1;
            } else {
                (b, fb) = (at, value);
                if side == -1 {
                    fa *= 0.5;
                }
                side = -1;
            }
            let (was, is) = (f(&best).abs(), f(&at).abs());
            if is < was {
                best = at;
            }
            if is > SLOW * was && newton(&best).is_some() {
                // Newton's method does not help here.
                let mid = self.sample(keep, 0.5 * (a.s + b.s), &best)?;
                let value = f(&mid);
                if (value > 0.0) == (fa > 0.0) {
                    (a, fa) = (mid, value);
                } else {
                    (b, fb) = (mid, value);
                }
                if value.abs() < f(&best).abs() {
                    best = mid;
                }
            }
        }
        Ok(best)
    }
}

impl Way<'_> {
    /// The extreme gap between two samples whose slopes differ in sign, towards zero from where they are.
    /// With `through` any place beyond zero will do. A kink is closed in by halving.
    pub(super) fn extreme(
        &self,
        keep: &Keep,
        a: Sample,
        b: Sample,
        enough: f64,
        through: bool,
    ) -> Result<Sample, Trouble> {
        let (mut a, mut b) = (a, b);
        let falls = a.slope < 0.0;
        let above = a.gap.g > 0.0;
        let deeper = |p: &Sample, q: &Sample| (p.gap.g < q.gap.g) == falls;
        let mut best = if deeper(&a, &b) { a } else { b };
        for round in 0..ROUNDS {
            let secant = (a.s * b.slope - b.s * a.slope) / (b.slope - a.slope);
            // Every third step halves: at a kink the slopes tell nothing about the place.
            let mid = 0.5 * (a.s + b.s);
            let s = if round % 3 == 2 || !(secant > a.s && secant < b.s) { mid } else { secant };
            let at = self.sample(keep, s, &best)?;
            if deeper(&at, &best) {
                best = at;
            }
            if at.slope.abs() <= enough || (through && (at.gap.g > 0.0) != above) {
                return Ok(at);
            }
            if (at.slope < 0.0) == falls {
                a = at;
            } else {
                b = at;
            }
            if b.s - a.s <= 1e-14 * b.s.abs() {
                break;
            }
        }
        Ok(best)
    }
}

/// Is the gap along any cut vector free of more than one extreme value?
pub(super) fn simple(keep: &Keep) -> bool {
    keep.surface.convex() || keep.surface.concave()
}

/// Where a search for zeros could go no farther: all of those before that place are found.
pub(crate) struct Lost {
    pub(crate) s: f64,
    pub(crate) trouble: Trouble,
}

/// Where the gap would be zero by its slope.
pub(super) fn newton(p: &Sample) -> Option<f64> {
    (p.slope != 0.0).then(|| p.s - p.gap.g / p.slope)
}

/// The zeros of the gap between two samples, the nearest first.
pub(super) fn crossings(
    way: &Way<'_>,
    keep: &Keep,
    a: Sample,
    b: Sample,
    halvings: u32,
    out: &mut Vec<Crossing>,
) -> Result<(), Lost> {
    if b.s <= a.s {
        return Ok(());
    }
    let lost = |trouble| Lost { s: a.s, trouble };
    let (fa, fb) = (a.gap.g, b.gap.g);
    let gap = |p: &Sample| p.gap.g;
    let coarse = halvings > HALVINGS && !simple(keep);
    if (fa > 0.0) != (fb > 0.0) {
        let falls = fb < fa;
        let runs = |p: &Sample| (p.slope < 0.0) == falls;
        if !coarse && (halvings == 0 || simple(keep) || (runs(&a) && runs(&b))) {
            match way.zero(keep, a, b, gap, newton, way.track.exact) {
                Ok(root) => {
                    out.push(Crossing { s: root.s, touch: false, falls });
                    return Ok(());
                }
                Err(trouble) if halvings == 0 || simple(keep) => return Err(lost(trouble)),
                // A shorter stretch may be read all along.
                Err(_) => {}
            }
        }
    } else {
        if fa.abs() + fb.abs() > reach(way, keep, &a, &b) {
            return Ok(());
        }
        let towards = if fa > 0.0 { -1.0 } else { 1.0 };
        if !coarse && a.slope * towards > 0.0 && b.slope * towards < 0.0 {
            match way.extreme(keep, a, b, 1e-9, true) {
                Ok(m) if (m.gap.g > 0.0) != (fa > 0.0) => {
                    crossings(way, keep, a, m, 0, out)?;
                    return crossings(way, keep, m, b, 0, out);
                }
                Ok(m) if in_limits(keep, m.gap.g, way.track.exact) => {
                    out.push(Crossing { s: m.s, touch: true, falls: fa > 0.0 });
                    return Ok(());
                }
                Err(trouble) if halvings == 0 || simple(keep) => return Err(lost(trouble)),
                _ => {}
            }
        }
        if halvings == 0 || simple(keep) {
            return Ok(());
        }
    }
    let m = match way.sample(keep, 0.5 * (a.s + b.s), &a) {
        // Where nothing faces the cutter the ends have to do.
        Err(_) if coarse => return crossings(way, keep, a, b, HALVINGS, out),
        // What is before the place that cannot be read is found all the same.
        Err(trouble) => {
            let mut places = (2..=NEARER).map(|k| a.s + 0.5_f64.powi(k) * (b.s - a.s));
            let Some(m) = places.find_map(|s| way.sample(keep, s, &a).ok()) else {
                return Err(lost(trouble));
            };
            crossings(way, keep, a, m, halvings - 1, out)?;
            return Err(Lost { s: m.s, trouble });
        }
        Ok(m) => m,
    };
    crossings(way, keep, a, m, halvings - 1, out)?;
    crossings(way, keep, m, b, halvings - 1, out)
}

/// How much a gap can change between two samples. Where the track ends to bend the planes across it meet it far ahead, and the
/// tool moves by more than `s`.
pub(super) fn reach(way: &Way<'_>, keep: &Keep, a: &Sample, b: &Sample) -> f64 {
    let by = b.s - a.s;
    RATE * by.max((b.te - a.te).norm()) + by * way.turn.norm() * keep.profile.reach()
}
