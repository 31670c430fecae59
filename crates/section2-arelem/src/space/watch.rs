//! Where the track meets a check surface (APT: `CHECK1`, `CHECK2`, `CHECK3`, `CPLAN`).
//!
//! The gap between cutter and check surface is followed along the track: that of the whole cutter on either side of the
//! surface. TO is where one of them falls to zero, PAST where one rises to it, ON a zero of the tool end's distance; a
//! tangency is a place where the gap is stationary and near zero, so that no plane has to stand in for the check surface.
//! The gap changes no faster than the tool moves: that excludes most cut vectors at once, and bounds the search on the others.

use aptc_contact::{Condition, Gap, Reason, Side};
use aptc_protap::Relation;

use super::joined::{Between, tangent_places};
use super::keep::{Keep, Pose};
use super::stride::Stride;
use super::track::{Node, Track, Trouble};
use super::way::{
    Crossing, GRAZING, HALVINGS, Lost, RATE, ROUNDS, Sample, Way, crossings, in_limits, read,
    simple, sunk,
};

/// How often a long cut vector over a surface of mixed curvature is halved at most.
const MOST_HALVINGS: u32 = 20;

/// Share of the size of the scene by which a place may lie out of a band, and of the band by which it is put inside then.
const ROUNDED: f64 = 1e-12;
const INSIDE: f64 = 1e-7;

/// A check surface on the way.
#[derive(Clone, Debug)]
pub(crate) struct Watch {
    relation: Relation,
    nth: u32,
    gauges: Vec<Gauge>,
    met: u32,
    /// Does it stand in a hollow that counts as open, which it has not left since the start?
    open: bool,
    /// Closer than this counts as touching.
    near: f64,
    /// A tangency may be this far from exact.
    loose: f64,
    /// Does one count only where both bands can take up by what it is not? One that did not count is told.
    strict: bool,
    pub(crate) passed_by: bool,
    closest: (f64, Pose),
    /// Least gap at a place that runs alike, for the report.
    pub(crate) alike: f64,
}

/// One of the gaps that are followed.
#[derive(Clone, Debug)]
struct Gauge {
    keep: Keep,
    /// Length of cut vectors that is halved [`HALVINGS`] times: beside a straight drive surface they go past the whole of
    /// the check surface at once, which may be met often there.
    piece: f64,
    /// Did the gap leave zero since the start?
    armed: bool,
    /// Did it run along with the whole of the cut vector before, or since it left zero with the end of that?
    along: bool,
    last: Option<Gap>,
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
    /// Is that beyond what counts as met? Drive or part surface is touched elsewhere there than at the start of the cut
    /// vector, which leads beside the check surface then.
    pub(crate) beside: bool,
}

/// What a watch has seen until now.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    met: u32,
    open: bool,
    closest: (f64, Pose),
    alike: f64,
    gauges: [([bool; 2], Option<Gap>); 3],
}

impl Watch {
    pub(crate) fn mark(&self) -> Mark {
        let gauge = |i: usize| {
            self.gauges.get(i).map_or(([false; 2], None), |g| ([g.armed, g.along], g.last))
        };
        let Self { met, open, closest, alike, .. } = *self;
        Mark { met, open, closest, alike, gauges: [gauge(0), gauge(1), gauge(2)] }
    }

    /// Forgets what it has seen since.
    pub(crate) fn back_to(&mut self, mark: &Mark) {
        (self.met, self.open) = (mark.met, mark.open);
        (self.closest, self.alike) = (mark.closest, mark.alike);
        for (gauge, ([armed, along], last)) in self.gauges.iter_mut().zip(mark.gauges) {
            (gauge.armed, gauge.along, gauge.last) = (armed, along, last);
        }
    }

    /// The same that stops at no tangency but one that the bands can take up.
    pub(crate) fn strict(self) -> Self {
        Self { strict: true, ..self }
    }

    /// The gauges of a check surface for a motion that starts at `pose`.
    pub(crate) fn new(keep: &Keep, relation: Relation, nth: u32, pose: &Pose) -> Self {
        // A cutter that comes from outside is inside only when all of it is.
        let inner = (keep.condition == Condition::Touch).then_some(Side::Negative);
        let stands = stands_in_open(keep, pose);
        // A fillet that the cutter is too tall for is tangent to its wall or floor all the same.
        let tangent = matches!(relation, Relation::Tanto | Relation::Pstan);
        let inner = inner.filter(|_| !(tangent && stands && keep.taller(pose)));
        let open = (stands || tangent && keep.opens(pose)).then_some(Side::Open);
        let near = keep.intol.max(keep.outtol);
        let piece = 4.0 * keep.profile.widest().max(keep.surface.extent() / 256.0);
        let gauge = |side: Side| {
            let keep = keep.on_side(side);
            Gauge { keep, piece, armed: true, along: false, last: None }
        };
        let sides = std::iter::once(Side::Positive).chain(inner).chain(open);
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
            open: stands,
            near,
            loose: 2.0 * keep.width(),
            strict: false,
            passed_by: false,
            closest: (closest, *pose),
            alike: f64::INFINITY,
        }
    }

    /// How often it was met, the closest approach and where that was.
    pub(crate) fn account(&self) -> (u32, f64, Pose) {
        (self.met, self.closest.0, self.closest.1)
    }

    /// Does the cutter stand in the surface, whichever side of it is taken?
    pub(crate) fn stands_in(&self, pose: &Pose) -> bool {
        self.depth(pose).is_some()
    }

    /// How deep it stands in it then on the side on which it is least so.
    pub(crate) fn depth(&self, pose: &Pose) -> Option<f64> {
        let mut least = f64::INFINITY;
        for gauge in &self.gauges {
            let depth = -gauge.keep.gap(pose, None).ok()?.g;
            if depth <= self.near {
                return None;
            }
            least = least.min(depth);
        }
        least.is_finite().then_some(least)
    }

    /// Does a gauge count now? Of a hollow that is open all of it does not, nor what is open of it once the cutter has left it.
    fn counts(&self, i: usize) -> bool {
        self.gauges[i].keep.side != if self.open { Side::Negative } else { Side::Open }
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
            let s = (-gap.g / gap.normal.dot(&node.course.along)).abs();
            s.is_finite().then_some(s)
        };
        self.gauges.iter().filter_map(to).fold(0.0, f64::max)
    }

    /// Where the check surface stops the motion between a node and the end of a cut vector; else whether that is not known from
    /// some place on.
    pub(crate) fn scan(
        &mut self,
        track: &Track,
        from: &Node,
        stride: &Stride,
    ) -> Result<Option<Halt>, Lost> {
        let mut known = 0.0;
        let found = self.seek(track, from, stride, &mut known);
        found.map_err(|trouble| Lost { s: known, trouble })
    }

    /// The same; until `known` it is.
    fn seek(
        &mut self,
        track: &Track,
        from: &Node,
        stride: &Stride,
        known: &mut f64,
    ) -> Result<Option<Halt>, Trouble> {
        let turn = from.pose.ta.cross(&stride.to.pose.ta) / stride.length;
        let way = Way { track, from, stride, turn };
        let tangent = matches!(self.relation, Relation::Tanto | Relation::Pstan);
        let mut found: Vec<(Crossing, usize)> = Vec::new();
        // How far all is found: what a long cut vector leads to far behind a check surface does not matter.
        let mut lost: Option<Lost> = None;
        for i in 0..self.gauges.len() {
            let (near, loose) = (self.near, self.loose);
            let gauge = &mut self.gauges[i];
            if tangent
                && !gauge.armed
                && let Ok(Some(s)) = way.alongside(&gauge.keep, loose, gauge.piece)
            {
                let before = std::mem::replace(&mut gauge.along, s >= stride.length);
                if !gauge.along && (s > loose || before) {
                    found.push((Crossing { s, touch: true, falls: true }, i));
                }
            }
            let Some((a, b)) = gauge.ends(&way, near) else { continue };
            for p in [a, b] {
                if p.gap.g.abs() < self.closest.0.abs() {
                    let pose = if p.s > 0.0 { stride.to.pose } else { from.pose };
                    self.closest = (p.gap.g, pose);
                }
            }
            let counts = tangent || self.counts(i);
            let gauge = &mut self.gauges[i];
            let halvings = gauge.halvings(stride.length);
            let (keep, mut out) = (&gauge.keep, Vec::new());
            if tangent {
                let other = usize::from(self.relation == Relation::Pstan);
                let between = Between { keep, other, ends: [a, b], loose, halvings };
                let (along, alike) = (&mut gauge.along, &mut self.alike);
                tangent_places(&way, &between, along, alike, &mut out)?;
            } else {
                if let Err(now) = crossings(&way, keep, a, b, halvings, &mut out)
                    && counts
                    && lost.as_ref().is_none_or(|before| now.s < before.s)
                {
                    lost = Some(now);
                }
                if self.relation == Relation::To && self.met + 1 >= self.nth && out.is_empty() {
                    out.extend(grazed(&way, keep, a, b));
                }
            }
            found.extend(out.into_iter().map(|c| (c, i)));
        }
        found.sort_by(|a, b| a.0.s.total_cmp(&b.0.s));
        // The place that counted last: one at which the cutter touches with the hollow whole and open is one.
        let mut counted = f64::NEG_INFINITY;
        for (crossing, i) in found {
            if tangent && crossing.s - counted <= self.near {
                continue;
            }
            if lost.as_ref().is_some_and(|lost| crossing.s > lost.s) {
                break;
            }
            if !tangent && !self.counts(i) {
                continue;
            }
            // Out of an open hollow it comes from outside, as any other.
            let outside = self.gauges[i].keep.side == Side::Positive;
            self.open &= !outside || crossing.touch || crossing.falls;
            let wanted = match self.relation {
                Relation::To => crossing.touch || crossing.falls,
                Relation::Past => crossing.touch || !crossing.falls,
                _ => true,
            };
            if !wanted {
                continue;
            }
            let before = self.met + 1 < self.nth;
            let asked = tangent && self.strict;
            let halt = if before && !asked { None } else { self.halt(&way, crossing, i)? };
            if asked && halt.as_ref().is_some_and(|halt| !self.serves(track, halt)) {
                self.passed_by = true;
                continue;
            }
            if before {
                self.met += 1;
                counted = crossing.s;
                continue;
            }
            let halt = match halt {
                None if self.relation == Relation::To => self.before(&way, crossing.s, i)?,
                halt => halt,
            };
            if halt.is_some() {
                self.met += 1;
                return Ok(halt);
            }
        }
        let Some(lost) = lost else { return Ok(None) };
        *known = lost.s;
        Err(lost.trouble)
    }

    /// The node at a crossing; `None` where the cutter is much deeper in the check surface elsewhere: the shank may stand
    /// through it at the start, or the place of contact go over from one wall to another; and where it does not touch.
    fn halt(&self, way: &Way<'_>, crossing: Crossing, i: usize) -> Result<Option<Halt>, Trouble> {
        let keep = &self.gauges[i].keep;
        let node = way.settled(crossing.s)?;
        let gap = read(keep, &node, None)?;
        let (te, slope) = (node.pose.te, way.slope(&node, &gap));
        let at = Sample { s: crossing.s, te, gap, slope };
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
        // What is found to a share of a wide band lies out of one that begins at the surface by more than rounding.
        if crosses
            && in_limits(keep, met.g, exact)
            && !in_limits(keep, met.g, ROUNDED * way.track.size)
        {
            let inside = way.to_reading(keep, s, node, keep.inside(met.g, INSIDE))?;
            let there = read(keep, &inside.1, None)?;
            if in_limits(keep, there.g, 0.0) {
                (s, node, met) = (inside.0, inside.1, there);
            }
        }
        // Beyond the end of a surface the cutter changes its side without touching; and another place of it may lie much deeper
        // in the check surface.
        let beyond = met.g > self.loose && keep.goes_round_an_end(&met);
        let deeper = || keep.deeper(&node.pose, &met, self.loose, true).0.is_some();
        // Of a plane there is no other place: the crossing was not come to, and is sought on a shorter way.
        let one = keep.is_plane() || keep.condition == Condition::On && simple(keep);
        if crosses && (met.g < -self.loose && !one || beyond || deeper()) {
            return Ok(None);
        }
        let (side, reading) = (keep.side, met.g);
        let beside = crosses && !in_limits(keep, met.g, exact);
        Ok(Some(Halt { s, node, side, gauge: i, reading, crosses, beside }))
    }

    /// Where on the way to `s`, at which the cutter is deeper in the check surface elsewhere, it came to be so; `None` where it was
    /// from the beginning on. Of a place that goes through a sheet, as a shank does, nothing is left to be read after a while.
    fn before(&self, way: &Way<'_>, s: f64, i: usize) -> Result<Option<Halt>, Trouble> {
        let keep = &self.gauges[i].keep;
        let at = |node: &Node| -> Result<Gap, Trouble> {
            let gap = read(keep, node, None)?;
            Ok(keep.deeper(&node.pose, &gap, self.loose, true).0.unwrap_or(gap))
        };
        let (mut low, mut high) = (0.0, s);
        if at(way.from)?.g <= self.near || at(&way.settled(s)?)?.g > -self.loose {
            return Ok(None);
        }
        for _ in 0..ROUNDS {
            if high - low <= way.track.exact {
                break;
            }
            let middle = 0.5 * (low + high);
            let clear = at(&way.settled(middle)?)?.g > 0.0;
            *(if clear { &mut low } else { &mut high }) = middle;
        }
        let node = way.settled(low)?;
        let reading = at(&node)?.g;
        let beside = !in_limits(keep, reading, way.track.exact);
        let side = keep.side;
        Ok(Some(Halt { s: low, node, side, gauge: i, reading, crosses: true, beside }))
    }

    /// Can the bands of the check surface and of that which is tangent to it take up together by what these miss each other?
    fn serves(&self, track: &Track, halt: &Halt) -> bool {
        let Some((i, check)) = self.tangent(halt) else { return true };
        let limits = check.limits();
        (limits.low..=limits.high).contains(&halt.reading)
            || track.axis.turns()
            || track.met_by_both(&halt.node, i, check).is_some()
    }

    /// The surface that the check surface is tangent to, 0 for drive and 1 for part, and how this was met.
    pub(crate) fn tangent(&self, halt: &Halt) -> Option<(usize, &Keep)> {
        let i = match self.relation {
            Relation::Tanto => 0,
            Relation::Pstan => 1,
            _ => return None,
        };
        Some((i, &self.gauges[halt.gauge].keep))
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
        Ok(Halt { s, node, beside: false, ..*halt })
    }
}

/// Does the cutter stand in a hollow that is open along its axis, its end no higher than the middle of that, and is it clear of it so but
/// not of all of it? Higher up nothing stands beside it but what runs straight up from the outline.
fn stands_in_open(keep: &Keep, pose: &Pose) -> bool {
    /// Share of the cutter's radius by which it may be higher: a floor through the middle, or about it, is one.
    const HIGHER: f64 = 0.1;
    let clears = |side: Side| keep.on_side(side).clears(pose);
    let lower = pose.te - pose.ta * (HIGHER * keep.profile.widest());
    keep.opens(pose)
        && keep.surface.foot(lower).normal.dot(&pose.ta) <= 0.0
        && clears(Side::Open)
        && !clears(Side::Negative)
        && !clears(Side::Positive)
}

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
    let (te, slope) = (way.from.pose.te, way.slope(way.from, &gap));
    let start = Sample { s: 0.0, te, gap, slope };
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
    let target = keep.onwards(&node.pose, keep.bend(&node.pose, &at.gap, next.normalize()));
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
    /// How often a cut vector of this length is halved in search of what lies on it.
    fn halvings(&self, mut length: f64) -> u32 {
        let mut n = HALVINGS;
        while length > self.piece && n < MOST_HALVINGS {
            (length, n) = (0.5 * length, n + 1);
        }
        n
    }

    /// Readings at both ends of a cut vector; `None` when this side of the surface cannot be touched.
    fn ends(&mut self, way: &Way<'_>, near: f64) -> Option<(Sample, Sample)> {
        let known = self.last;
        let at = |keep: &Keep, node: &Node, s: f64, last: Option<Gap>| {
            let gap = keep.gap_from(&node.pose, last.as_ref());
            let gap = gap.or_else(|_| keep.gap_from(&node.pose, known.as_ref())).ok();
            let gap = gap.or_else(|| sunk(keep, node))?;
            Some(Sample { s, te: node.pose.te, gap, slope: way.slope(node, &gap) })
        };
        let to = &way.stride.to;
        // Where several places may touch the last one says nothing of the others.
        let whole = way.whole(&self.keep);
        let last = self.last.filter(|_| !whole);
        let b = at(&self.keep, to, way.stride.length, last);
        let a = match last {
            Some(gap) => {
                let (te, slope) = (way.from.pose.te, way.slope(way.from, &gap));
                Some(Sample { s: 0.0, te, gap, slope })
            }
            None => at(&self.keep, way.from, 0.0, None),
        };
        self.last = b.map(|b| b.gap);
        let mut a = a.or_else(|| way.first_facing(&self.keep))?;
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

/// The gap that says how far a tool is from a surface, whichever side it is on: where it fits, else where it
/// is least in the way.
pub(crate) fn clearance(keep: &Keep, pose: &Pose) -> Result<(f64, Side), Reason> {
    let mut best: Result<(f64, Side), Reason> = Err(Reason::NoHit);
    for side in keep.sides(pose) {
        // A side on which it fits is taken as it is.
        if best.as_ref().is_ok_and(|(gap, _)| *gap >= 0.0) {
            break;
        }
        match (keep.on_side(side).gap(pose, None), &best) {
            (Ok(gap), Ok((most, _))) if gap.g > *most => best = Ok((gap.g, side)),
            (Ok(gap), Err(_)) => best = Ok((gap.g, side)),
            (Err(reason), Err(_)) => best = Err(reason),
            _ => {}
        }
    }
    best
}
