//! The longest cut vector that the band allows (APT: `DELTA`, `ADELTA`, `GOUGCK`).
//!
//! A chord between two places at gaps e and f above the low limit, over a surface whose gap bends along it,
//! dips by what a parabola does: with A the depth of the parabola over its chord, the lowest place is at the
//! limit when A = (sqrt e + sqrt f)^2. A grows with the square of the length. So the ratio of the longest
//! chord to the one just tried is known from the lowest gap on it, and the search for the length takes two
//! or three trials. The same holds for the high limit over hollow surfaces.

use aptc_contact::{Condition, Gap, chord};
use aptc_geometry::{Surface, Vec3};

use super::guided::{Guided, Place};
use super::keep::{Keep, Limits, Pose};
use super::track::{Node, Onset, Track, Trouble};

/// Trials of one cut vector; two or three are usual.
const TRIALS: usize = 40;
/// A chord that could be longer by less than this ratio is taken: a longer one would save no cut vector in
/// a hundred thousand.
const LONG_ENOUGH: f64 = 1e-5;
/// Share of the band by which a vertex may lie off its target: half of it is the share of a length that it costs.
const OFF_TARGET: f64 = 1e-2;
/// Share of a bend by which it may change until where the vertex ought to lie does.
const SAME_BEND: f64 = 1e-3;
/// Greatest change of the ratio of two cut vectors that is expected to go on.
const EVEN: f64 = 0.02;
/// By how much longer than the one before a cut vector is tried at first where nothing bends.
const FARTHER: f64 = 16.0;
/// Share of a length up to which another trial begins at the one before.
const BESIDE: f64 = 0.25;
/// How often one cut vector may learn from its chord how its gaps bend.
const LESSONS: u32 = 3;
/// A chord to be shortened to less than this has its vertex in the wrong place.
const LOST: f64 = 0.5;
/// Share of the band by which such a vertex is moved at least.
const EDGES_APART: f64 = 1e-9;
/// By how much more than it needs a chord is given, for a bend that changes along it.
const SPARE: f64 = 1.1;
/// Greatest turn of the track in one cut vector, radians.
const MOST_TURN: f64 = 2.0;
/// Share of the band by which a chord aims inside of it.
const AIM: f64 = 1e-6;
/// The same, and that by which vertices keep from the edge, where the axis turns: the gaps go by more than cubics then, and
/// are looked at in places. It makes a path longer by half of it.
pub(crate) const AIM_TURNING: f64 = 1e-3;
/// Extreme gaps on such a chord are found to this share of the band.
const RESOLUTION_TURNING: f64 = 0.01 * AIM_TURNING;
/// By this share of it they may be beyond those at its ends, which may lie at the edge of the band: what looks are unsure of.
const OWN_TURNING: f64 = 0.3 * RESOLUTION_TURNING;
/// Shares of a chord at which it is looked at as a whole where its contact goes over from one place to another.
const BETWEEN: [f64; 7] = [0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98];
/// Places of contact that are farther apart than this share of the cutter's radius are two.
const ANOTHER: f64 = 0.1;
/// Share of the band by which two places that touch at once may differ.
const BOTH: f64 = 1e-2;
/// Extreme gaps on a chord are found to this share of the band.
pub(super) const RESOLUTION: f64 = 2e-7;

/// A cut vector.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stride<To = Node> {
    /// Length along the track.
    pub(crate) length: f64,
    pub(crate) to: To,
    /// Gaps at its end, from which the next one continues.
    pub(crate) targets: [f64; 2],
}

/// How a chord lies in the bands: it fits, the ratio by which it could be longer, and second derivatives of the
/// gaps along it, from the slopes at its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fit {
    pub(super) fits: bool,
    pub(super) ratio: f64,
    pub(super) bends: [f64; 2],
}

/// How the ends of trials are found and held against the bands.
pub(super) trait Trials {
    /// The end of a trial.
    type Place: Copy;
    /// Is there no place where none is found? Else other trials tell.
    const FINAL: bool;

    /// The place that they begin at.
    fn onset(&self) -> Onset;

    /// The place at distance `s`, its gaps at the targets that belong to the `bends` of cut vectors about `usual` long;
    /// without them to its own curvature. `last` is the trial before.
    fn reach(
        &self,
        s: f64,
        usual: f64,
        bends: Option<[f64; 2]>,
        last: Option<&Stride<Self::Place>>,
    ) -> Result<Stride<Self::Place>, Trouble>;

    /// How the chord to it lies in both bands, and how much longer it could be.
    fn fit(&self, to: &Self::Place) -> Result<Fit, Trouble>;
}

/// Trials by contacts; with `look` none that is deeper may be elsewhere, with `between` chords on which the contact goes
/// over from one place to another are looked at as a whole.
struct Contacts<'a> {
    track: &'a Track,
    from: &'a Node,
    look: bool,
    between: bool,
}

impl Trials for Contacts<'_> {
    type Place = Node;
    const FINAL: bool = true;

    fn onset(&self) -> Onset {
        self.from.onset()
    }

    fn reach(
        &self,
        s: f64,
        usual: f64,
        bends: Option<[f64; 2]>,
        last: Option<&Stride>,
    ) -> Result<Stride, Trouble> {
        let beside = last.filter(|l| self.track.beside(self.from, l, s)).map(|l| &l.to);
        self.track.reach(self.from, s, usual, bends, self.look, beside)
    }

    fn fit(&self, to: &Node) -> Result<Fit, Trouble> {
        self.track.fit(self.from, to, self.between)
    }
}

/// What one cut vector tells the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    /// The longest length over the foretold one, and by how much more it was than that of the cut vector before.
    ratio: Option<f64>,
    trend: f64,
    /// The length of the last one.
    length: f64,
    /// Way for which no other place of contact can become the deepest.
    room: f64,
    /// Every trial looks for other places of contact.
    careful: bool,
    /// How the gaps bend along the last cut vector when the axis turns, which the curvatures do not tell.
    bends: Option<[f64; 2]>,
}

impl Pace {
    pub(crate) fn new() -> Self {
        Self { ratio: None, trend: 0.0, length: 0.0, room: 0.0, careful: false, bends: None }
    }

    /// The ratio that is to be expected next: the curvature that changes it does so evenly for a while.
    fn expected(&self) -> f64 {
        self.ratio.unwrap_or(1.0) + self.trend
    }

    fn learn(&mut self, ratio: f64) {
        let ratio = ratio.clamp(0.2, 2.0);
        let trend = self.ratio.map_or(0.0, |last| ratio - last);
        self.trend = if trend.abs() <= EVEN { trend } else { 0.0 };
        self.ratio = Some(ratio);
    }
}

impl Track {
    /// The longest cut vector from a node, no longer than `cap`.
    ///
    /// The contacts are followed from vector to vector. Whether the cutter touches deeper elsewhere is asked
    /// when it may be so; once it is, and where nothing is found, every trial asks.
    pub(crate) fn stride(&self, from: &Node, cap: f64, pace: &mut Pace) -> Result<Stride, Trouble> {
        if !pace.careful {
            if let Some(stride) = self.guided(from, cap, pace) {
                return Ok(stride);
            }
            if let Ok(stride) = self.by_contacts(from, cap, pace, false) {
                let turn = (stride.to.pose.ta - from.pose.ta).norm();
                let reach = self.keeps[0].profile.reach().max(self.keeps[1].profile.reach());
                pace.room -= stride.length + turn * reach;
                if pace.room > 0.0 {
                    return Ok(stride);
                }
                let (deeper, room) = self.deeper(&stride.to.pose, &stride.to.gaps);
                if deeper.iter().all(Option::is_none) {
                    pace.room = room;
                    return Ok(stride);
                }
            }
            pace.careful = true;
        }
        self.by_contacts(from, cap, pace, true)
    }

    /// The same by contacts. Chords on which the contact goes over to another place are looked at as a whole once one is found;
    /// only where that does not fit each trial is.
    fn by_contacts(
        &self,
        from: &Node,
        cap: f64,
        pace: &mut Pace,
        look: bool,
    ) -> Result<Stride, Trouble> {
        let trials = |between| Contacts { track: self, from, look, between };
        if self.axis.turns() || !self.keeps.iter().any(Keep::is_mixed) {
            return self.longest(&trials(true), cap, pace);
        }
        let before = *pace;
        let found = self.longest(&trials(false), cap, pace);
        let over = |to: &Node| (0..2).any(|i| self.keeps[i].is_mixed() && self.apart(i, from, to));
        if let Ok(stride) = found
            && (!over(&stride.to) || self.fits(from, &stride.to))
        {
            return Ok(stride);
        }
        *pace = before;
        self.longest(&trials(true), cap, pace)
    }

    /// The same along guides, where no other place of contact can be; `None` where these do not tell.
    fn guided(&self, from: &Node, cap: f64, pace: &mut Pace) -> Option<Stride> {
        let place = Place::of(from);
        let guided = Guided { track: self, guides: self.guides.as_ref()?, from: &place };
        let Stride { length, to, targets } = self.longest(&guided, cap, pace).ok()?;
        Some(Stride { length, to: guided.node(from.pose.ta, &to), targets })
    }

    /// Goes on along guides, without a look at anything else, for less than `free`; `take` gets the start and the
    /// end of each cut vector, and says whether it goes on so. The node where that ends; `None` at the start.
    pub(crate) fn cruise(
        &self,
        from: &Node,
        cap: f64,
        pace: &mut Pace,
        mut free: f64,
        mut take: impl FnMut(&Place, &Place) -> bool,
    ) -> Option<Node> {
        let guides = self.guides.as_ref().filter(|_| !pace.careful)?;
        let (mut at, mut gone) = (Place::of(from), false);
        loop {
            let guided = Guided { track: self, guides, from: &at };
            let before = *pace;
            let stride = self.longest(&guided, cap, pace).ok().filter(|s| s.length < free);
            let taken = stride.filter(|s| take(&at, &s.to));
            let Some(Stride { length, to, .. }) = taken else {
                *pace = before;
                return gone.then(|| guided.node(from.pose.ta, &at));
            };
            free -= length;
            (at, gone) = (to, true);
        }
    }

    #[inline(always)]
    fn longest<T: Trials>(
        &self,
        trials: &T,
        cap: f64,
        pace: &mut Pace,
    ) -> Result<Stride<T::Place>, Trouble> {
        let from = &trials.onset();
        let mut bends = pace.bends;
        let mut plan = self.plan(from, bends, cap);
        let mut s = (plan.length * pace.expected() * (1.0 - 0.25 * LONG_ENOUGH)).min(plan.most);
        if plan.length >= plan.most && pace.length > 0.0 {
            // Nothing bends here, which may end soon.
            s = s.min(FARTHER * pace.length);
        }
        let (mut good, mut bad): (Option<Stride<T::Place>>, f64) = (None, f64::INFINITY);
        let (mut last, mut rest): (Option<Stride<T::Place>>, f64) = (None, 1.0);
        let mut trouble = Trouble::Stuck;
        let mut before: Option<(f64, f64)> = None;
        let mut learnt = 0;
        // A chord that does not fit though its ratio says so is shortened more each time.
        let mut back = LONG_ENOUGH;
        for _ in 0..TRIALS {
            let tried = trials.reach(s, plan.length, bends, last.as_ref());
            let tried = tried.map(|t| &*last.insert(t));
            let next = match tried.and_then(|t| Ok((trials.fit(&t.to)?, t))) {
                Ok((fit, tried)) => {
                    // With a turning axis only the chord tells how the gaps bend along it; and where the bend
                    // grows from nothing on the way, a vertex may lie where no chord of any length fits.
                    let lost = !fit.fits && fit.ratio < LOST;
                    if learnt < LESSONS && (lost || self.axis.turns()) {
                        learnt += 1;
                        let better = self.plan(from, Some(fit.bends), cap);
                        let aim = self.aims(from, fit.bends, better.length);
                        if self.axis.turns() {
                            pace.bends = Some(fit.bends);
                        }
                        let least = if lost { EDGES_APART } else { OFF_TARGET };
                        if self.differ(aim, tried.targets, least) {
                            // The same once more with the vertex where it ought to be.
                            (bends, plan) = (Some(fit.bends), better);
                            s = s.min(plan.most);
                            (good, bad, before) = (None, f64::INFINITY, None);
                            continue;
                        }
                    }
                    if fit.fits {
                        rest = fit.ratio;
                        good = Some(*tried);
                        if fit.ratio <= 1.0 + LONG_ENOUGH || s >= plan.most {
                            break;
                        }
                    } else {
                        bad = bad.min(s);
                    }
                    let ratio = if fit.fits { fit.ratio } else { fit.ratio.min(1.0 - back) };
                    if !fit.fits && good.is_none() {
                        back = (4.0 * back).min(0.5);
                    }
                    let next = lengthen(s, ratio, before) * (1.0 - 0.25 * LONG_ENOUGH);
                    before = Some((s, ratio));
                    next
                }
                Err(t) if !T::FINAL => return Err(t),
                Err(t) => {
                    trouble = t;
                    bad = bad.min(s);
                    0.5 * s
                }
            };
            let low = good.as_ref().map_or(0.0, |g| g.length);
            if bad - low <= LONG_ENOUGH * low || s <= self.exact {
                break;
            }
            s = next.min(plan.most);
            if s <= low || s >= bad {
                s = if bad.is_finite() { 0.5 * (low + bad) } else { plan.most };
            }
        }
        let stride = good.ok_or(trouble)?;
        let rest = if rest <= 1.0 + LONG_ENOUGH { rest } else { 1.0 };
        pace.length = stride.length;
        pace.learn(stride.length * rest / plan.length);
        Ok(stride)
    }

    /// Does the chord between two nodes stay in both bands?
    pub(crate) fn fits(&self, from: &Node, to: &Node) -> bool {
        self.fit(from, to, true).is_ok_and(|f| f.fits)
    }

    /// The place at distance `s`, its gaps at the targets that belong to the `bends`; without them to its own
    /// curvature.
    fn reach(
        &self,
        from: &Node,
        s: f64,
        usual: f64,
        bends: Option<[f64; 2]>,
        look: bool,
        beside: Option<&Node>,
    ) -> Result<Stride, Trouble> {
        let onset = &from.onset();
        let targets = self.aims(onset, bends.unwrap_or(from.bends), usual);
        let to = self.walk_beside(from, s, targets, look, beside)?;
        let other = self.other_aims(onset, bends, to.bends, usual, targets);
        let (to, targets) = match other {
            Some(aims) => (self.walk_beside(from, s, aims, look, Some(&to))?, aims),
            None => (to, targets),
        };
        Ok(Stride { length: s, to, targets })
    }

    /// The aims that belong to the bends at the end of a trial, when they are off its targets: with `bends` these were for them,
    /// and a bend that is the same to a thousandth moves them by half of what counts.
    #[inline]
    pub(super) fn other_aims(
        &self,
        from: &Onset,
        bends: Option<[f64; 2]>,
        found: [f64; 2],
        usual: f64,
        targets: [f64; 2],
    ) -> Option<[f64; 2]> {
        let same = |i: usize| (found[i] - from.bends[i]).abs() <= SAME_BEND * found[i].abs();
        if bends.is_some() || same(0) && same(1) {
            return None;
        }
        let aims = self.aims(from, found, usual);
        self.differ(aims, targets, OFF_TARGET).then_some(aims)
    }

    /// Is a trial near enough to the length `s`, and does it touch at the places of the cutter that its start touches at?
    fn beside(&self, from: &Node, tried: &Stride, s: f64) -> bool {
        let alike = (0..2).all(|i| !self.apart(i, from, &tried.to));
        (tried.length - s).abs() <= BESIDE * s && alike
    }

    /// Are the aims off these targets by more than a share of the band?
    fn differ(&self, aims: [f64; 2], targets: [f64; 2], share: f64) -> bool {
        (0..2).any(|i| (aims[i] - targets[i]).abs() > share * self.keeps[i].width())
    }

    /// Gaps of the next vertex when cut vectors are about `usual` long and the gaps bend so along them: in the
    /// share of the band that the chords use, and farther out where the vertex before left less room for the
    /// chord between both.
    #[inline]
    pub(super) fn aims(&self, from: &Onset, bends: [f64; 2], usual: f64) -> [f64; 2] {
        let target = |i: usize| {
            let (keep, bend) = (&self.keeps[i], bends[i]);
            let share = (bend.abs() * usual * usual / (8.0 * keep.width())).min(1.0);
            if share < 1e-9 {
                return keep.level();
            }
            let (even, edge) = (keep.target(bend, share), keep.target(bend, 1.0));
            let Limits { low, high } = keep.limits();
            let before = from.gaps[i];
            let room = if bend > 0.0 { before - low } else { high - before };
            let depth = 0.5 * bend.abs() * usual * usual;
            let rest = SPARE * (depth.sqrt() - room.max(0.0).sqrt()).max(0.0).powi(2);
            if bend > 0.0 {
                even.max(low + rest).min(edge)
            } else {
                even.min(high - rest).max(edge)
            }
        };
        let target = |i: usize| {
            let target = target(i);
            if self.axis.turns() { self.keeps[i].inside(target, AIM_TURNING) } else { target }
        };
        [target(0), target(1)]
    }

    /// The length foretold from how the gaps bend, and the greatest allowed.
    fn plan(&self, from: &Onset, bends: Option<[f64; 2]>, cap: f64) -> Plan {
        let turn = from.curl.norm();
        let most = if turn * cap > MOST_TURN { MOST_TURN / turn } else { cap };
        let mut length = most;
        for (keep, bend) in self.keeps.iter().zip(bends.unwrap_or(from.bends)) {
            if bend.abs() * length * length > 8.0 * keep.width() {
                length = (8.0 * keep.width() / bend.abs()).sqrt();
            }
        }
        Plan { length, most }
    }

    /// Does the chord stay in both bands, and how much longer could it be? With `between` it is looked at as a whole where the
    /// contact goes over from one place to another.
    fn fit(&self, from: &Node, to: &Node, between: bool) -> Result<Fit, Trouble> {
        let mut all = Fit { fits: true, ratio: f64::INFINITY, bends: [0.0; 2] };
        // The end must be ahead: a track that closes on itself is not cut short.
        if (to.pose.te - from.pose.te).dot(&from.along) <= 0.0 && from.curl.norm() <= 0.0 {
            return Ok(Fit { fits: false, ratio: 0.5, ..all });
        }
        for i in 0..2 {
            let (fits, ratio, bend) = self.fit_one(i, from, to, between)?;
            all.fits &= fits;
            all.ratio = all.ratio.min(ratio);
            all.bends[i] = bend;
        }
        Ok(all)
    }

    /// The same of one surface.
    fn fit_one(
        &self,
        i: usize,
        from: &Node,
        to: &Node,
        whole: bool,
    ) -> Result<(bool, f64, f64), Trouble> {
        let keep = &self.keeps[i];
        let turning = (from.pose.ta - to.pose.ta).norm_squared() > 1e-24;
        if keep.is_plane() && !turning {
            return Ok((true, f64::INFINITY, 0.0));
        }
        if keep.goes_round_an_end(&from.gaps[i]) && keep.goes_round_an_end(&to.gaps[i]) {
            // The surface is left behind, and its edge no guide.
            return Err(Trouble::Contact);
        }
        let v = to.pose.te - from.pose.te;
        let other = self.governs(i, from, to);
        let ends = [other.as_ref().unwrap_or(&from.gaps[i]), &to.gaps[i]];
        let c = chord(
            &keep.tool(&from.pose),
            &keep.tool(&to.pose),
            &keep.surface,
            keep.condition,
            keep.side,
            keep.thick,
            Some([*ends[0], *ends[1]]),
            if self.axis.turns() { RESOLUTION_TURNING } else { RESOLUTION } * keep.width(),
        )?;
        let (mut low, mut high) = (c.low.g, c.high.g);
        if keep.condition == Condition::Touch && turning || keep.is_mixed() {
            // A turning axis may bring another place of the cutter down between two vertices at which it is free; and where
            // the contact goes over from one place to another the gap has an edge on the way.
            let apart = (turning || whole) && self.apart(i, from, to);
            let places: &[f64] = match (apart, turning) {
                (true, _) => &BETWEEN,
                // Along a surface of rulings a flank lies nearly, and its gap goes by more than cubics.
                (false, true) if matches!(keep.surface, Surface::Parametric(_)) => &BETWEEN,
                (false, true) => &[0.5],
                (false, false) => &[],
            };
            let look = |t: f64| Ok(keep.gap(&between(&from.pose, &to.pose, t), None)?.g);
            let [least, most] = extremes(places, ends.map(|g| g.g), look)?;
            (low, high) = (low.min(least), high.max(most));
        }
        let gaps = ends.map(|g| g.g);
        let (fits, ratio) = self.judge(i, gaps, [low, high], c.bow);
        Ok((fits, ratio, c.bow / v.norm_squared()))
    }
}

impl Track {
    /// Does a chord stay in the band of surface `i`, and how much longer could it be? `ends` are the gaps at its ends,
    /// `bow` by how much the rate of change grows.
    #[inline]
    pub(super) fn judge(
        &self,
        i: usize,
        ends: [f64; 2],
        [low, high]: [f64; 2],
        bow: f64,
    ) -> (bool, f64) {
        let keep = &self.keeps[i];
        let limits = keep.limits();
        // The chord aims a little inside the band, so that it fits when it comes out a little longer.
        let [aim, found, own] = match self.axis.turns() {
            true => [AIM_TURNING, 2.0 * RESOLUTION_TURNING, OWN_TURNING],
            false => [AIM, RESOLUTION, RESOLUTION],
        };
        let aim = aim * keep.width();
        let e = ends.map(|g| (g - limits.low - aim).max(0.0));
        let f = ends.map(|g| (limits.high - aim - g).max(0.0));
        let dips = [ends[0] - low, ends[1] - low].map(|d| d.max(0.0));
        let rises = [high - ends[0], high - ends[1]].map(|d| d.max(0.0));
        let depth = 0.5 * bow;
        // Vertices of the motion before may lie at the very edge; they are no fault of this chord.
        let slack = |share: f64| 1e-14 * self.size + share * keep.width();
        let (own, inside) = (slack(own), slack(found));
        let least = (ends[0].min(ends[1]) - own).min(limits.low + inside);
        let most = (ends[0].max(ends[1]) + own).max(limits.high - inside);
        let fits = low >= least && high <= most;
        let mut ratio = f64::INFINITY;
        if depth > 0.0 || dips[0].min(dips[1]) > aim {
            ratio = ratio.min(grow(e, dips, depth));
        }
        if depth < 0.0 || rises[0].min(rises[1]) > aim {
            ratio = ratio.min(grow(f, rises, -depth));
        }
        (fits, ratio)
    }
}

impl Track {
    /// Does the cutter touch at different places of it at both ends?
    fn apart(&self, i: usize, from: &Node, to: &Node) -> bool {
        let place = |node: &Node| node.gaps[i].tool_point - node.pose.te;
        (place(from) - place(to)).norm() > ANOTHER * self.keeps[i].profile.widest()
    }

    /// The gap at the start of a cut vector at the place of contact of its end, where both touch at once: at the
    /// bottom of a hollow the cutter goes over from one to the other.
    fn governs(&self, i: usize, from: &Node, to: &Node) -> Option<Gap> {
        let (keep, here, there) = (&self.keeps[i], &from.gaps[i], &to.gaps[i]);
        if !self.apart(i, from, to) {
            return None;
        }
        let other = keep.gap(&from.pose, Some(there.spot())).ok()?;
        ((other.g - here.g).abs() <= BOTH * keep.width()).then_some(other)
    }
}

/// Least and greatest gap at the ends of a chord and at these shares of it, and between those where a parabola has its own.
fn extremes(
    places: &[f64],
    ends: [f64; 2],
    look: impl Fn(f64) -> Result<f64, Trouble>,
) -> Result<[f64; 2], Trouble> {
    let mut seen = [(1.0, ends[1]); BETWEEN.len() + 2];
    seen[0] = (0.0, ends[0]);
    for (place, t) in seen[1..].iter_mut().zip(places) {
        *place = (*t, look(*t)?);
    }
    let seen = &seen[..places.len() + 2];
    let mut found = [ends[0].min(ends[1]), ends[0].max(ends[1])];
    for (sign, found) in [1.0, -1.0].into_iter().zip(&mut found) {
        let lower =
            |a: &&[(f64, f64)], b: &&[(f64, f64)]| (sign * a[1].1).total_cmp(&(sign * b[1].1));
        let Some(three) = seen.windows(3).min_by(lower) else { continue };
        let beyond = |g: f64, than: f64| sign * g < sign * than;
        if !beyond(three[1].1, *found) {
            continue;
        }
        *found = three[1].1;
        // One look alone tells too little for another.
        if places.len() > 1
            && let Some(t) = vertex(three)
        {
            let there = look(t)?;
            *found = if beyond(there, *found) { there } else { *found };
        }
    }
    Ok(found)
}

/// Where the parabola through three places turns, when that is between the outer two.
fn vertex(three: &[(f64, f64)]) -> Option<f64> {
    let [a, b, c] = three else { return None };
    let ((x, p), (y, q)) = ((b.0 - a.0, b.1 - a.1), (b.0 - c.0, b.1 - c.1));
    let t = b.0 - 0.5 * (x * x * q - y * y * p) / (x * q - y * p);
    (t > a.0 && t < c.0).then_some(t)
}

/// The next length to try: by the ratio, and from the second trial on by the secant of the ratios, which
/// also sees how the targets and the curvature change with the length.
fn lengthen(s: f64, ratio: f64, before: Option<(f64, f64)>) -> f64 {
    let simple = s * ratio.clamp(0.1, 4.0);
    let Some((s0, r0)) = before else { return simple };
    let slope = (ratio - r0) / (s - s0);
    let secant = s - (ratio - 1.0) / slope;
    // The ratio falls with the length; where rounding or a kink says otherwise the simple step holds.
    if slope < 0.0 && secant > 0.25 * s && secant < 4.0 * s { secant } else { simple }
}

struct Plan {
    length: f64,
    most: f64,
}

/// Ratio of the longest chord to this one: `room` between the ends and the limit, `dips` between the ends
/// and the extreme place, `depth` of the parabola where the chord has no inner extreme.
fn grow(room: [f64; 2], dips: [f64; 2], depth: f64) -> f64 {
    let allowed = room[0].sqrt() + room[1].sqrt();
    let used = if dips[0].min(dips[1]) > 0.0 {
        dips[0].sqrt() + dips[1].sqrt()
    } else {
        depth.max(0.0).sqrt()
    };
    if used > 0.0 { allowed / used } else { f64::INFINITY }
}

/// The pose at `t` in [0, 1] of a cut vector: the tool end moves straight, the axis turns evenly.
pub(crate) fn between(a: &Pose, b: &Pose, t: f64) -> Pose {
    Pose { te: a.te + (b.te - a.te) * t, ta: slerp(a.ta, b.ta, t) }
}

fn slerp(a: Vec3, b: Vec3, t: f64) -> Vec3 {
    let cos = a.dot(&b).clamp(-1.0, 1.0);
    let across = b - a * cos;
    let sin = across.norm();
    if sin <= 1e-15 {
        return a;
    }
    let angle = aptc_geometry::trig::atan2(sin, cos) * t;
    let (s, c) = aptc_geometry::trig::sin_cos(angle);
    (a * c + across * (s / sin)).normalize()
}
