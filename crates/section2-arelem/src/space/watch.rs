//! Where the track meets a check surface (APT: `CHECK1`, `CHECK2`, `CHECK3`, `CPLAN`).
//!
//! The gap between cutter and check surface is followed along the track: that of the whole cutter on either side of the
//! surface. TO is where one of them falls to zero, PAST where one rises to it, ON a zero of the tool end's distance; a
//! tangency is a place where the gap is stationary and near zero, so that no plane has to stand in for the check surface.
//! The gap changes no faster than the tool moves: that excludes most cut vectors at once, and bounds the search on the others.

use aptc_contact::{Condition, Gap, Reason, Side, on};
use aptc_protap::Relation;

use super::keep::{Keep, Pose};
use super::stride::Stride;
use super::track::{Node, Track, Trouble};

/// Bound of each search along one cut vector.
const ROUNDS: usize = 80;
/// Halvings in the search for the last place that faces a surface with ends.
const FACING: u32 = 14;
/// How often a piece of a cut vector over a surface of mixed curvature is halved.
const HALVINGS: u32 = 6;
/// Rate of change of a gap along the track that is never exceeded, the turning of the axis apart.
const RATE: f64 = 1.5;

/// A check surface on the way.
#[derive(Clone, Debug)]
pub(crate) struct Watch {
    relation: Relation,
    nth: u32,
    gauges: Vec<Gauge>,
    met: u32,
    /// Closer than this counts as touching.
    near: f64,
    /// A tangency may be this far from exact.
    loose: f64,
    closest: (f64, Pose),
    /// Least gap at a place that runs alike, for the report.
    pub(crate) alike: f64,
}

/// One of the gaps that are followed.
#[derive(Clone, Debug)]
struct Gauge {
    keep: Keep,
    /// Did the gap leave zero since the start?
    armed: bool,
    last: Option<Gap>,
}

/// A value of the gap on the track.
#[derive(Clone, Copy, Debug)]
struct Sample {
    s: f64,
    gap: Gap,
    slope: f64,
}

/// The way between two nodes.
struct Way<'a> {
    track: &'a Track,
    from: &'a Node,
    stride: &'a Stride,
    /// Turning of the axis over the length.
    turn: aptc_geometry::Vec3,
}

/// A place where a gauge reads zero.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    s: f64,
    /// Does the gap turn back there?
    touch: bool,
    /// Does it fall there?
    falls: bool,
}

/// Where a motion ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Halt {
    pub(crate) s: f64,
    pub(crate) node: Node,
    /// Side of the check surface's own normal on which the tool is.
    pub(crate) side: Side,
    /// Which gauge said so, what it reads there, and whether the place is where it reads that.
    gauge: usize,
    reading: f64,
    crosses: bool,
}

/// What a watch has seen until now.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    met: u32,
    closest: (f64, Pose),
    alike: f64,
    gauges: [(bool, Option<Gap>); 2],
}

impl Watch {
    pub(crate) fn mark(&self) -> Mark {
        let gauge = |i: usize| self.gauges.get(i).map_or((false, None), |g| (g.armed, g.last));
        let Self { met, closest, alike, .. } = *self;
        Mark { met, closest, alike, gauges: [gauge(0), gauge(1)] }
    }

    /// Forgets what it has seen since.
    pub(crate) fn back_to(&mut self, mark: &Mark) {
        (self.met, self.closest, self.alike) = (mark.met, mark.closest, mark.alike);
        for (gauge, (armed, last)) in self.gauges.iter_mut().zip(mark.gauges) {
            (gauge.armed, gauge.last) = (armed, last);
        }
    }

    /// The gauges of a check surface for a motion that starts at `pose`.
    pub(crate) fn new(keep: &Keep, relation: Relation, nth: u32, pose: &Pose) -> Self {
        let inner = match keep.condition {
            Condition::On => None,
            Condition::Touch => Some(keep.inner(pose)),
        };
        // A cutter that comes from outside is inside only when all of it is.
        let inner = inner.map(|s| if keep.on_side(s).clears(pose) { s } else { Side::Negative });
        let near = keep.intol.max(keep.outtol);
        let gauge = |side: Side| Gauge { keep: keep.on_side(side), armed: true, last: None };
        let sides = std::iter::once(Side::Positive).chain(inner);
        let mut gauges: Vec<Gauge> = sides.map(gauge).collect();
        let mut closest = f64::INFINITY;
        for g in &mut gauges {
            if let Ok(gap) = g.keep.gap(pose, None) {
                g.armed = gap.g.abs() > near;
                if gap.g.abs() < closest.abs() {
                    closest = gap.g;
                }
                g.last = Some(gap);
            }
        }
        Self {
            relation,
            nth: nth.max(1),
            gauges,
            met: 0,
            near,
            loose: 2.0 * keep.width(),
            closest: (closest, *pose),
            alike: f64::INFINITY,
        }
    }

    /// How often it was met, the closest approach and where that was.
    pub(crate) fn account(&self) -> (u32, f64, Pose) {
        (self.met, self.closest.0, self.closest.1)
    }

    /// Way of a tool that keeps its axis for which the check surface cannot be met, as the last readings tell; tangencies
    /// are looked for everywhere.
    pub(crate) fn free(&self) -> f64 {
        if matches!(self.relation, Relation::Tanto | Relation::Pstan) {
            return 0.0;
        }
        let free = |g: &Gauge| match g.last {
            Some(gap) if g.armed && simple(&g.keep) => gap.g.abs() / RATE,
            _ => 0.0,
        };
        self.gauges.iter().map(free).fold(f64::INFINITY, f64::min)
    }

    /// The tool is elsewhere than at the last readings.
    pub(crate) fn moved(&mut self) {
        self.gauges.iter_mut().for_each(|g| g.last = None);
    }

    /// Distance ahead at which a plane is passed for certain; 0 for other surfaces.
    pub(crate) fn ahead(&self, node: &Node) -> f64 {
        let to = |g: &Gauge| {
            let gap = g.keep.is_plane().then_some(g.last)??;
            let s = (-gap.g / gap.normal.dot(&node.along)).abs();
            s.is_finite().then_some(s)
        };
        self.gauges.iter().filter_map(to).fold(0.0, f64::max)
    }

    /// Where the check surface stops the motion between a node and the end of a cut vector.
    pub(crate) fn scan(
        &mut self,
        track: &Track,
        from: &Node,
        stride: &Stride,
    ) -> Result<Option<Halt>, Trouble> {
        let turn = from.pose.ta.cross(&stride.to.pose.ta) / stride.length;
        let way = Way { track, from, stride, turn };
        let tangent = matches!(self.relation, Relation::Tanto | Relation::Pstan);
        let mut found: Vec<(Crossing, usize)> = Vec::new();
        for i in 0..self.gauges.len() {
            let (near, loose) = (self.near, self.loose);
            let gauge = &mut self.gauges[i];
            if tangent
                && !gauge.armed
                && let Ok(Some(s)) = way.alongside(&gauge.keep, loose)
            {
                found.push((Crossing { s, touch: true, falls: true }, i));
            }
            let Some((a, b)) = gauge.ends(&way, near) else { continue };
            for p in [a, b] {
                if p.gap.g.abs() < self.closest.0.abs() {
                    let pose = if p.s > 0.0 { stride.to.pose } else { from.pose };
                    self.closest = (p.gap.g, pose);
                }
            }
            let keep = &self.gauges[i].keep;
            let mut out = Vec::new();
            if tangent {
                tangencies(&way, keep, a, b, loose, HALVINGS, &mut self.alike, &mut out)?;
            } else {
                crossings(&way, keep, a, b, HALVINGS, &mut out)?;
                if self.relation == Relation::To && self.met + 1 >= self.nth && out.is_empty() {
                    out.extend(grazed(&way, keep, a, b));
                }
            }
            found.extend(out.into_iter().map(|c| (c, i)));
        }
        found.sort_by(|a, b| a.0.s.total_cmp(&b.0.s));
        for (crossing, i) in found {
            let wanted = match self.relation {
                Relation::To => crossing.touch || crossing.falls,
                Relation::Past => crossing.touch || !crossing.falls,
                _ => true,
            };
            if !wanted {
                continue;
            }
            if self.met + 1 < self.nth {
                self.met += 1;
            } else if let Some(halt) = self.halt(&way, crossing, i)? {
                self.met += 1;
                return Ok(Some(halt));
            }
        }
        Ok(None)
    }

    /// The node at a crossing; `None` where the cutter is much deeper in the check surface elsewhere: the shank may stand
    /// through it at the start, or the place of contact go over from one wall to another.
    fn halt(&self, way: &Way<'_>, crossing: Crossing, i: usize) -> Result<Option<Halt>, Trouble> {
        let keep = &self.gauges[i].keep;
        let node = way.settled(crossing.s)?;
        let gap = read(keep, &node, None)?;
        let at = Sample { s: crossing.s, gap, slope: way.slope(&node, &gap) };
        let s = if matches!(self.relation, Relation::Tanto | Relation::Pstan) {
            None
        } else if self.relation == Relation::To && at.slope.abs() < GRAZING {
            grazing(way, keep, &at)
        } else {
            in_band(way, keep, &node, at)
        };
        let (mut s, mut node) = match s {
            Some(s) => (s, way.settled(s)?),
            None => (crossing.s, node),
        };
        let crosses =
            !matches!(self.relation, Relation::Tanto | Relation::Pstan) && !crossing.touch;
        let exact = way.track.exact;
        let mut met = read(keep, &node, None)?;
        if crosses && !in_limits(keep, met.g, exact) {
            // Drive or part surface is touched elsewhere than on the way there.
            let other = way.to_reading(keep, s, node, 0.0)?;
            let there = read(keep, &other.1, None)?;
            if in_limits(keep, there.g, exact) {
                (s, node, met) = (other.0, other.1, there);
            }
        }
        // Another place of the cutter may lie much deeper in the check surface.
        let deeper = || keep.deeper(&node.pose, &met, self.loose).0.is_some();
        if crosses && (met.g < -self.loose || deeper()) {
            return Ok(None);
        }
        let (side, reading) = (keep.side, met.g);
        Ok(Some(Halt { s, node, side, gauge: i, reading, crosses }))
    }

    /// The same halt on the way of another cut vector from the same node.
    pub(crate) fn again(
        &self,
        track: &Track,
        from: &Node,
        stride: &Stride,
        halt: &Halt,
    ) -> Result<Halt, Trouble> {
        let turn = from.pose.ta.cross(&stride.to.pose.ta) / stride.length;
        let way = Way { track, from, stride, turn };
        let keep = &self.gauges[halt.gauge].keep;
        let (mut s, mut node) = (halt.s, way.settled(halt.s)?);
        if halt.crosses {
            (s, node) = way.to_reading(keep, s, node, halt.reading)?;
        }
        if halt.crosses && !in_limits(keep, read(keep, &node, None)?.g, track.exact) {
            return Err(Trouble::Check);
        }
        Ok(Halt { s, node, ..*halt })
    }
}

/// Is the gap in the band, but for rounding?
fn in_limits(keep: &Keep, gap: f64, exact: f64) -> bool {
    let limits = keep.limits();
    (limits.low - exact..=limits.high + exact).contains(&gap)
}

/// Gap to the check surface, near a gap that is known.
fn read(keep: &Keep, node: &Node, near: Option<&Gap>) -> Result<Gap, Trouble> {
    keep.gap_from(&node.pose, near).map_err(|_| Trouble::Check)
}

/// A gap that changes less than this with the way keeps its value: far above rounding, and a round surface of a
/// thousand times the length of the cut vector changes more at the first look.
const LEVEL: f64 = 1e-10;

/// A bound of the gap of a cutter that is so deep in the surface that no pair of points faces each other: the depth of a point
/// of its axis. `None` where none of those looked at is in it.
///
/// On the way through a small ellipsoid a cutter is there for a while. The gap is at most that of any point of the cutter,
/// so that it is negative with the bound; where it is zero there is a pair.
fn sunk(keep: &Keep, node: &Node) -> Option<Gap> {
    if keep.condition == Condition::On || keep.side == Side::Open {
        return None;
    }
    let at = |share: f64| {
        let p = node.pose.te + node.pose.ta * (share * keep.profile.height());
        let gap = on(p, &keep.surface, keep.side);
        Gap { g: gap.raw - keep.thick, ..gap }
    };
    let deepest =
        [0.0, 0.25, 0.5, 0.75, 1.0].map(at).into_iter().min_by(|a, b| a.g.total_cmp(&b.g));
    deepest.filter(|gap| gap.g < -keep.width())
}

/// Sine of the angle below which a check surface is met at a graze.
const GRAZING: f64 = 0.1;

/// Share of the band that is left where the tool stops at a surface that it only grazes, which is near for a long way: as
/// with APT-360, not at the very place of contact.
fn left(keep: &Keep) -> f64 {
    (0.1 * keep.width()).min(keep.outtol)
}

/// The same on a cut vector that comes so near and does not touch yet.
fn grazed(way: &Way<'_>, keep: &Keep, a: Sample, b: Sample) -> Option<Crossing> {
    let left = left(keep);
    let over = |p: &Sample| p.gap.g - left;
    let comes = over(&a) > 0.0 && over(&b) <= 0.0 && b.gap.g > 0.0;
    let grazes = b.slope <= 0.0 && b.slope > -GRAZING;
    let at = (comes && grazes).then(|| way.zero(keep, a, b, over, |_| None, way.track.exact))?;
    Some(Crossing { s: at.ok()?.s, touch: true, falls: true })
}

/// The place on the way to a contact where a surface that is grazed there is as near as that.
fn grazing(way: &Way<'_>, keep: &Keep, at: &Sample) -> Option<f64> {
    let left = left(keep);
    let gap = keep.gap_from(&way.from.pose, Some(&at.gap)).ok()?;
    let start = Sample { s: 0.0, gap, slope: way.slope(way.from, &gap) };
    let over = |p: &Sample| p.gap.g - left;
    if over(&start) <= 0.0 || over(at) >= 0.0 {
        return None;
    }
    way.zero(keep, start, *at, over, |_| None, way.track.exact).ok().map(|p| p.s)
}

/// At a round or hollow check surface the tool stops where it would go on along it: outside, or inside, in
/// the band.
fn in_band(way: &Way<'_>, keep: &Keep, node: &Node, mut at: Sample) -> Option<f64> {
    let next = at.gap.normal.cross(&node.gaps[1].normal);
    if keep.is_plane() || next.norm() <= 1e-3 {
        return None;
    }
    let target = keep.target(keep.bend(&node.pose, &at.gap, next.normalize()), 1.0);
    for _ in 0..8 {
        if (at.gap.g - target).abs() <= way.track.exact {
            return Some(at.s);
        }
        let s = at.s - (at.gap.g - target) / at.slope;
        // Beyond the end of the cut vector the path goes on otherwise.
        if at.slope.abs() < 0.05 || s <= 0.0 || s > way.stride.length {
            return None;
        }
        at = way.sample(keep, s, &at).ok()?;
    }
    in_limits(keep, at.gap.g, 0.0).then_some(at.s)
}

impl Gauge {
    /// Readings at both ends of a cut vector; `None` when this side of the surface cannot be touched.
    fn ends(&mut self, way: &Way<'_>, near: f64) -> Option<(Sample, Sample)> {
        let known = self.last;
        let at = |keep: &Keep, node: &Node, s: f64, last: Option<Gap>| {
            let gap = keep.gap_from(&node.pose, last.as_ref());
            let gap = gap.or_else(|_| keep.gap_from(&node.pose, known.as_ref())).ok()?;
            Some(Sample { s, gap, slope: way.slope(node, &gap) })
        };
        let to = &way.stride.to;
        // Where several places may touch the last one says nothing of the others.
        let whole = way.whole(&self.keep);
        let last = self.last.filter(|_| !whole);
        let b = at(&self.keep, to, way.stride.length, last);
        let a = match last {
            Some(gap) => Some(Sample { s: 0.0, gap, slope: way.slope(way.from, &gap) }),
            None => at(&self.keep, way.from, 0.0, None),
        };
        self.last = b.map(|b| b.gap);
        let mut a = a?;
        // A surface with ends faces nothing at the far end of a long cut vector, and was passed on the way.
        let b = b.or_else(|| way.last_facing(&self.keep, &a))?;
        if !self.armed {
            // The contact at the start does not count: from where it has ended.
            let mut s = (2.0 * near).max(1e-6 * b.s);
            let mut left = None;
            for _ in 0..ROUNDS {
                if s >= b.s {
                    break;
                }
                if let Ok(sample) = way.sample(&self.keep, s, &a)
                    && sample.gap.g.abs() > near
                {
                    left = Some(sample);
                    break;
                }
                s *= 3.0;
            }
            match left {
                Some(sample) => {
                    self.armed = true;
                    a = sample;
                }
                None => {
                    self.armed = b.gap.g.abs() > near;
                    a = b;
                }
            }
        }
        Some((a, b))
    }
}

impl Way<'_> {
    fn node(&self, s: f64) -> Result<Node, Trouble> {
        self.track.walk(self.from, s, self.stride.targets, false)
    }

    /// The same where the motion may end: no other place of contact is deeper.
    fn settled(&self, s: f64) -> Result<Node, Trouble> {
        self.track.walk(self.from, s, self.stride.targets, true)
    }

    /// The place near `s`, with its node, where the gap is `wanted`, as far as it does not only graze the surface.
    fn to_reading(
        &self,
        keep: &Keep,
        mut s: f64,
        mut node: Node,
        wanted: f64,
    ) -> Result<(f64, Node), Trouble> {
        for _ in 0..8 {
            let gap = read(keep, &node, None)?;
            let off = gap.g - wanted;
            let slope = self.slope(&node, &gap);
            if off.abs() <= self.track.exact || slope.abs() < GRAZING {
                break;
            }
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
    fn slope(&self, node: &Node, gap: &Gap) -> f64 {
        gap.normal.dot(&node.along) + gap.turn_rate(node.pose.te, self.turn)
    }

    /// Is the gap to be that of the whole cutter? Where several places of it may touch, and it may be at the surface on
    /// the way: no point of it is farther from the middle of its axis than the corner of its box.
    fn whole(&self, keep: &Keep) -> bool {
        if simple(keep) || keep.condition == Condition::On {
            return false;
        }
        let half = 0.5 * keep.profile.height();
        let around = aptc_geometry::trig::hypot(half, keep.profile.widest()) + keep.thick.abs();
        let clear = |node: &Node| {
            let middle = node.pose.te + node.pose.ta * half;
            keep.surface.distance(middle).abs() - around
        };
        let change = self.stride.length * (RATE + self.turn.norm() * keep.profile.reach());
        clear(self.from) + clear(&self.stride.to) <= change
    }

    fn sample(&self, keep: &Keep, s: f64, near: &Sample) -> Result<Sample, Trouble> {
        let node = self.node(s)?;
        let whole = if simple(keep) { None } else { read(keep, &node, None).ok() };
        let gap = whole.map_or_else(|| read(keep, &node, Some(&near.gap)), Ok);
        let gap = gap.or_else(|t| sunk(keep, &node).ok_or(t))?;
        Ok(Sample { s, gap, slope: self.slope(&node, &gap) })
    }

    /// The last place after `a`, about, where something of the surface faces the cutter.
    fn last_facing(&self, keep: &Keep, a: &Sample) -> Option<Sample> {
        let (mut low, mut high) = (None, self.stride.length);
        for _ in 0..FACING {
            let s = 0.5 * (low.map_or(0.0, |l: Sample| l.s) + high);
            match self.sample(keep, s, low.as_ref().unwrap_or(a)) {
                Ok(sample) => low = Some(sample),
                Err(_) => high = s,
            }
        }
        low
    }

    /// The zero of `f` between two samples of opposite sign, by Newton's method kept in the bracket.
    fn zero(
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
            if f(&at).abs() < f(&best).abs() {
                best = at;
            } else if newton(&best).is_some() {
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
    fn extreme(
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

impl Way<'_> {
    /// The middle of the stretch about the extreme `m` along which the gap keeps its value, `m` itself without one.
    ///
    /// A flat end of the cutter lies along its part surface and touches a round check surface tangent to it all the time
    /// that the line of contact goes through below the flat: the tool stops where that line is below its end, as in APT-360.
    fn middle(&self, keep: &Keep, a: &Sample, m: &Sample, b: &Sample) -> Result<f64, Trouble> {
        let (from, to) = (self.level(keep, m, a)?, self.level(keep, m, b)?);
        Ok(0.5 * (from + to))
    }

    /// Where, going from `m` to `end`, the gap ceases to keep its value.
    fn level(&self, keep: &Keep, m: &Sample, end: &Sample) -> Result<f64, Trouble> {
        let same = 2.0 * keep.width() + self.track.exact;
        let keeps = |p: &Sample| p.slope.abs() <= LEVEL && (p.gap.g - m.gap.g).abs() <= same;
        if keeps(end) {
            return Ok(end.s);
        }
        let (mut inside, mut outside) = (m.s, end.s);
        // The first look decides whether there is such a stretch at all.
        let mut s = m.s + 1e-6 * (end.s - m.s);
        for round in 0..ROUNDS {
            if keeps(&self.sample(keep, s, m)?) {
                inside = s;
            } else if round == 0 {
                return Ok(m.s);
            } else {
                outside = s;
            }
            if (outside - inside).abs() <= self.track.exact {
                break;
            }
            s = 0.5 * (inside + outside);
        }
        Ok(inside)
    }

    /// How far the check surface runs along with the way from its beginning, where the tool touches it there.
    ///
    /// The straight end of a TABCYL lies along the line that it is tangent to: the motion to it ends where they part, though
    /// nothing but that stretch says that they are tangent. APT-360 stops at once; along the check surface it is the same way.
    fn alongside(&self, keep: &Keep, loose: f64) -> Result<Option<f64>, Trouble> {
        let at = |node: &Node, s: f64| -> Result<Sample, Trouble> {
            let gap = read(keep, node, None)?;
            Ok(Sample { s, gap, slope: self.slope(node, &gap) })
        };
        let start = at(self.from, 0.0)?;
        if start.gap.g.abs() > loose || start.slope.abs() > LEVEL {
            return Ok(None);
        }
        let whole = at(&self.stride.to, self.stride.length).ok();
        let Some(end) = whole.or_else(|| self.last_facing(keep, &start)) else { return Ok(None) };
        let s = self.level(keep, &start, &end)?;
        Ok((s > loose).then_some(s))
    }
}

/// Is the gap along any cut vector free of more than one extreme value?
fn simple(keep: &Keep) -> bool {
    keep.surface.convex() || keep.surface.concave()
}

/// The zeros of the gap between two samples.
fn crossings(
    way: &Way<'_>,
    keep: &Keep,
    a: Sample,
    b: Sample,
    halvings: u32,
    out: &mut Vec<Crossing>,
) -> Result<(), Trouble> {
    if b.s <= a.s {
        return Ok(());
    }
    let (fa, fb) = (a.gap.g, b.gap.g);
    let gap = |p: &Sample| p.gap.g;
    let newton = |p: &Sample| (p.slope != 0.0).then(|| p.s - p.gap.g / p.slope);
    if (fa > 0.0) != (fb > 0.0) {
        let falls = fb < fa;
        let runs = |p: &Sample| (p.slope < 0.0) == falls;
        if halvings == 0 || simple(keep) || (runs(&a) && runs(&b)) {
            let root = way.zero(keep, a, b, gap, newton, way.track.exact)?;
            out.push(Crossing { s: root.s, touch: false, falls });
            return Ok(());
        }
    } else {
        if fa.abs() + fb.abs() > reach(way, keep, &a, &b) {
            return Ok(());
        }
        let towards = if fa > 0.0 { -1.0 } else { 1.0 };
        if a.slope * towards > 0.0 && b.slope * towards < 0.0 {
            let m = way.extreme(keep, a, b, 1e-9, true)?;
            if (m.gap.g > 0.0) != (fa > 0.0) {
                crossings(way, keep, a, m, 0, out)?;
                return crossings(way, keep, m, b, 0, out);
            }
            if in_limits(keep, m.gap.g, way.track.exact) {
                out.push(Crossing { s: m.s, touch: true, falls: fa > 0.0 });
                return Ok(());
            }
        }
        if halvings == 0 || simple(keep) {
            return Ok(());
        }
    }
    let m = way.sample(keep, 0.5 * (a.s + b.s), &a)?;
    crossings(way, keep, a, m, halvings - 1, out)?;
    crossings(way, keep, m, b, halvings - 1, out)
}

/// The places between two samples where the gap is stationary and within `loose` of zero.
#[expect(clippy::too_many_arguments, reason = "the bracket, its surface and what is found")]
fn tangencies(
    way: &Way<'_>,
    keep: &Keep,
    a: Sample,
    b: Sample,
    loose: f64,
    halvings: u32,
    alike: &mut f64,
    out: &mut Vec<Crossing>,
) -> Result<(), Trouble> {
    if b.s <= a.s {
        return Ok(());
    }
    // The way comes to run along with the check surface, as along the straight end of a TABCYL: where that begins.
    let runs = |p: &Sample| p.slope.abs() <= LEVEL && p.gap.g.abs() <= loose;
    if runs(&b) && !runs(&a) {
        out.push(Crossing { s: way.level(keep, &b, &a)?, touch: true, falls: a.slope < 0.0 });
        return Ok(());
    }
    let far = a.gap.g.abs() + b.gap.g.abs() - 2.0 * loose > reach(way, keep, &a, &b);
    let turns = (a.slope > 0.0) != (b.slope > 0.0);
    if turns && (!far || simple(keep)) {
        let m = way.extreme(keep, a, b, 1e-12, false)?;
        if m.gap.g.abs() <= loose {
            let s = way.middle(keep, &a, &m, &b)?;
            out.push(Crossing { s, touch: true, falls: a.slope < 0.0 });
        } else if m.gap.g.abs() < alike.abs() {
            *alike = m.gap.g;
        }
        return Ok(());
    }
    if far || halvings == 0 || simple(keep) {
        return Ok(());
    }
    let m = way.sample(keep, 0.5 * (a.s + b.s), &a)?;
    tangencies(way, keep, a, m, loose, halvings - 1, alike, out)?;
    tangencies(way, keep, m, b, loose, halvings - 1, alike, out)
}

/// How much a gap can change between two samples.
fn reach(way: &Way<'_>, keep: &Keep, a: &Sample, b: &Sample) -> f64 {
    (b.s - a.s) * (RATE + way.turn.norm() * keep.profile.reach())
}

/// The gap that says how far a tool is from a surface, whichever side it is on: where it fits, else where it
/// is least in the way.
pub(crate) fn clearance(keep: &Keep, pose: &Pose) -> Result<(f64, Side), Reason> {
    let mut best: Result<(f64, Side), Reason> = Err(Reason::NoHit);
    for side in keep.sides(pose) {
        match (keep.on_side(side).gap(pose, None), &best) {
            (Ok(gap), Ok((most, _))) if gap.g > *most && *most < 0.0 => best = Ok((gap.g, side)),
            (Ok(gap), Err(_)) => best = Ok((gap.g, side)),
            (Err(reason), Err(_)) => best = Err(reason),
            _ => {}
        }
    }
    best
}
