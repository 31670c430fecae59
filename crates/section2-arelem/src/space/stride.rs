//! The longest cut vector that the band allows (APT: `DELTA`, `ADELTA`).
//!
//! A chord between two places at gaps e and f above the low limit, over a surface whose gap bends along it,
//! dips by what a parabola does: with A the depth of the parabola over its chord, the lowest place is at the
//! limit when A = (sqrt e + sqrt f)^2. A grows with the square of the length. So the ratio of the longest
//! chord to the one just tried is known from the lowest gap on it, and the search for the length takes two
//! or three trials. The same holds for the high limit over hollow surfaces.

use aptc_contact::{Gap, Guide};
use aptc_geometry::Vec3;
use aptc_geometry::profile::Segment;

use super::band::AIM_TURNING;
use super::guided::{Guided, Guides, Place};
use super::judge::Fit;
use super::keep::{Keep, Pose};
use super::lengths::{Lengths, lengthen, older, rest};
use super::track::{Course, Node, Track, Trouble};

/// Trials of one cut vector; two or three are usual.
const TRIALS: usize = 40;
/// Trials in which most lengths are found, with a fixed axis and with one that turns, whose vertices are moved between them.
const EASY: usize = 4;
const EASY_TURNING: usize = 10;
/// Share of what is long enough to which others are found.
const FINE: f64 = 1e-4;
const FINE_TURNING: f64 = 1e-3;
/// A chord that could be longer by less than this ratio is taken: a longer one would save no cut vector in
/// a hundred thousand.
const LONG_ENOUGH: f64 = 1e-5;
/// The same where the axis turns, whose chords aim a thousandth inside of the band.
const LONG_ENOUGH_TURNING: f64 = 0.5 * AIM_TURNING;
/// Share of the lengths that are long enough along which a chord goes over to that of another trial.
const RAMP: f64 = 0.1;
/// Share of the way by which chords aim inside of the band, by which one may be too long.
const TOO_LONG: f64 = 0.1;
/// Share of the band by which a vertex may lie off its target: half of it is the share of a length that it costs.
const OFF_TARGET: f64 = 1e-2;
/// Share of a bend by which it may change until where the vertex ought to lie does.
const SAME_BEND: f64 = 1e-3;
/// Greatest change of the ratio of two cut vectors that is expected to go on.
const EVEN: f64 = 0.02;
/// The same of their bends, as a share of these.
const EVEN_BENDS: f64 = 0.5;
/// By how much longer than it is foretold from its bend a chord is tried again that was much too long.
const TOO_FAR: f64 = 2.0;
/// By how much longer than the one before a cut vector is tried at first where nothing bends.
const FARTHER: f64 = 16.0;
/// Share of a length up to which another trial begins at the one before.
const BESIDE: f64 = 0.25;
/// Share of the length that is foretold from a bend by which a chord goes beyond what a flat end touched below it.
const BEYOND: f64 = 0.5;
/// Sine of the angle to a flat end up to which a track goes along it.
const LEVEL: f64 = 0.1;
/// How often one cut vector may learn from its chord how its gaps bend.
const LESSONS: u32 = 3;
/// A chord to be shortened to less than this has its vertex in the wrong place.
const LOST: f64 = 0.5;
/// Share of the band by which such a vertex is moved at least.
const EDGES_APART: f64 = 1e-9;
/// Cut vectors of which every trial looks for other places of contact once one was found.
const CAREFUL: u32 = 6;
/// How often a cut vector is made shorter as the cutter cuts in on its way.
const CUT_SHORT: u32 = 12;
/// Greatest turn of the track in one cut vector, radians.
const MOST_TURN: f64 = 2.0;

/// A cut vector.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stride<To = Node> {
    /// Length along the track.
    pub(crate) length: f64,
    pub(crate) to: To,
    /// Gaps at its end, from which the next one continues.
    pub(crate) targets: [f64; 2],
}

/// How the ends of trials are found and held against the bands.
pub(super) trait Trials {
    /// The end of a trial.
    type Place: Copy;
    /// Is there no place where none is found? Else other trials tell.
    const FINAL: bool;

    /// The gaps where they begin, and how the track goes on there.
    fn start(&self) -> ([f64; 2], &Course);

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

    /// How far the track goes on with what the flat end touches there below it; `None` where it touches otherwise.
    fn below(&self, to: &Self::Place) -> Option<f64>;

    /// How the track goes on there.
    fn course<'p>(&self, to: &'p Self::Place) -> &'p Course;
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

    fn start(&self) -> ([f64; 2], &Course) {
        (self.from.gaps.map(|g| g.g), &self.from.course)
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

    fn below(&self, to: &Node) -> Option<f64> {
        let Pose { te, ta } = to.pose;
        let flat = |(keep, gap): (&Keep, &Gap)| {
            let from_axis = (gap.tool_point - te).dot(&to.course.along);
            let [[radius, _], _] = keep.profile.joints();
            let touches =
                gap.segment == Some(Segment::LowerLine) && to.course.along.dot(&ta).abs() < LEVEL;
            touches.then_some(radius + from_axis)
        };
        self.track.keeps.iter().zip(&to.gaps).filter_map(flat).min_by(f64::total_cmp)
    }

    fn course<'p>(&self, to: &'p Node) -> &'p Course {
        &to.course
    }
}

/// What one cut vector tells the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    /// The longest length over the foretold one, and by how much more it was than that of the cut vector before.
    ratio: Option<f64>,
    trend: f64,
    /// By how much more that was than the time before.
    growth: f64,
    /// The length of the last one.
    length: f64,
    /// Way for which no other place of contact can become the deepest, and whether that was looked for where it is now.
    room: f64,
    looked: bool,
    /// Cut vectors yet of which every trial looks for other places of contact.
    careful: u32,
    /// How the gaps bend along the last cut vector when the axis turns, which the curvatures do not tell, and by how much
    /// more than along the one before.
    bends: Option<[f64; 2]>,
    grown: [f64; 2],
}

impl Pace {
    pub(crate) fn new() -> Self {
        Self {
            ratio: None,
            trend: 0.0,
            growth: 0.0,
            length: 0.0,
            room: 0.0,
            looked: false,
            careful: 0,
            bends: None,
            grown: [0.0; 2],
        }
    }

    /// The ratio that is to be expected next: the curvature that changes it does so evenly for a while. With an axis that `turns`
    /// ratios scatter, and how the change grows says nothing.
    fn expected(&self, turns: bool) -> f64 {
        self.ratio.unwrap_or(1.0) + self.trend + if turns { 0.0 } else { self.growth }
    }

    /// How the gaps of the next one are expected to bend.
    fn expected_bends(&self) -> Option<[f64; 2]> {
        self.bends.map(|b| [b[0] + self.grown[0], b[1] + self.grown[1]])
    }

    /// The gaps bend so along a cut vector.
    fn learn_bends(&mut self, bends: [f64; 2]) {
        let last = self.bends.unwrap_or(bends);
        self.grown = [0, 1].map(|i| {
            let grown = bends[i] - last[i];
            // What jumps does not go on so.
            if grown.abs() <= EVEN_BENDS * last[i].abs() { grown } else { 0.0 }
        });
        self.bends = Some(bends);
    }

    /// A cut vector was this long where `plan` was foretold, and could be longer by the ratio `rest`.
    #[inline]
    pub(super) fn learn(&mut self, length: f64, rest: f64, plan: f64) {
        self.length = length;
        let ratio = (length * rest / plan).clamp(0.2, 2.0);
        let trend = self.ratio.map_or(0.0, |last| ratio - last);
        let trend = if trend.abs() <= EVEN { trend } else { 0.0 };
        let growth = trend - self.trend;
        self.growth = if growth.abs() <= EVEN * EVEN { growth } else { 0.0 };
        self.trend = trend;
        self.ratio = Some(ratio);
    }
}

impl Track {
    /// The longest cut vector from a node, no longer than `cap`.
    ///
    /// The contacts are followed from vector to vector. Whether the cutter touches deeper elsewhere is asked
    /// when it may be so; once it is, and where nothing is found, every trial of some cut vectors asks.
    pub(crate) fn stride(&self, from: &Node, cap: f64, pace: &mut Pace) -> Result<Stride, Trouble> {
        let mut cap = cap;
        for _ in 0..CUT_SHORT {
            let before = *pace;
            let (stride, room) = self.stride_to(from, cap, pace)?;
            let Some(s) = self.overlooked(from, &stride, room) else { return Ok(stride) };
            (*pace, cap) = (before, s);
        }
        Err(Trouble::Contact)
    }

    /// The same, of which nobody has looked on the way, and the way from its start for which nothing else could touch.
    fn stride_to(&self, from: &Node, cap: f64, pace: &mut Pace) -> Result<(Stride, f64), Trouble> {
        let looked = std::mem::take(&mut pace.looked);
        let mut free = pace.room;
        if pace.careful == 0 {
            let guided = self.guided(from, cap, pace);
            if let Some(stride) = guided
                && !self.several()
            {
                return Ok((stride, free));
            }
            let stride = match guided {
                Some(stride) => Ok(stride),
                None => self.by_contacts(from, cap, pace, false),
            };
            if let Ok(stride) = stride {
                let turn = (stride.to.pose.ta - from.pose.ta).norm();
                let reach = self.keeps[0].profile.reach().max(self.keeps[1].profile.reach());
                pace.room -= stride.length + turn * reach;
                if pace.room > 0.0 {
                    return Ok((stride, free));
                }
                let none = |deeper: &[Option<Gap>; 2]| deeper.iter().all(Option::is_none);
                // One look from its start is worth those on the way and at its end.
                if !looked && !self.axis.turns() {
                    let (deeper, room) = self.deeper(&from.pose, &from.gaps);
                    if none(&deeper) {
                        free = free.max(room);
                    }
                    if free > stride.length {
                        pace.room = free - stride.length;
                        return Ok((stride, free));
                    }
                }
                let (deeper, room) = self.deeper(&stride.to.pose, &stride.to.gaps);
                if none(&deeper) {
                    (pace.room, pace.looked) = (room, true);
                    return Ok((stride, free));
                }
            }
            pace.careful = CAREFUL;
        }
        pace.careful -= 1;
        pace.room = 0.0;
        Ok((self.by_contacts(from, cap, pace, true)?, free))
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

    /// May guides miss a place of contact that becomes the deepest?
    fn several(&self) -> bool {
        self.guides.as_ref().is_some_and(Guides::several)
    }

    /// The same along guides; `None` where these do not tell.
    fn guided(&self, from: &Node, cap: f64, pace: &mut Pace) -> Option<Stride> {
        match self.guides.as_ref()? {
            Guides::Closed(guides) => self.guided_by(guides, from, cap, pace),
            Guides::Point(guides) => self.guided_by(guides, from, cap, pace),
        }
    }

    fn guided_by<G: Guide>(
        &self,
        guides: &[G; 2],
        from: &Node,
        cap: f64,
        pace: &mut Pace,
    ) -> Option<Stride> {
        let place = Place::of::<G>(from);
        let guided = Guided { track: self, guides, from: &place };
        let Stride { length, to, targets } = self.longest(&guided, cap, pace).ok()?;
        Some(Stride { length, to: guided.node(from.pose.ta, &to), targets })
    }

    /// Goes on along guides, without a look at anything else, for less than `free`; `take` gets both ends of each cut vector
    /// and the direction at the second, and says whether it goes on so. The node where that ends; `None` at the start.
    pub(crate) fn cruise(
        &self,
        from: &Node,
        cap: f64,
        pace: &mut Pace,
        free: f64,
        take: impl FnMut([Vec3; 2], Vec3) -> bool,
    ) -> Option<Node> {
        let free = if self.several() { free.min(pace.room) } else { free };
        if pace.careful > 0 || free <= pace.length {
            return None;
        }
        match self.guides.as_ref()? {
            Guides::Closed(guides) => self.cruise_by(guides, from, cap, pace, free, take),
            Guides::Point(guides) => self.cruise_by(guides, from, cap, pace, free, take),
        }
    }

    fn cruise_by<G: Guide>(
        &self,
        guides: &[G; 2],
        from: &Node,
        cap: f64,
        pace: &mut Pace,
        mut free: f64,
        mut take: impl FnMut([Vec3; 2], Vec3) -> bool,
    ) -> Option<Node> {
        let mut at = Place::of::<G>(from);
        let (mut next, mut gone) = (at, false);
        loop {
            let guided = Guided { track: self, guides, from: &at };
            let before = *pace;
            let length = guided.at_once(cap, pace, &mut next).or_else(|| {
                let found = self.longest(&guided, cap, pace).ok()?;
                next = found.to;
                Some(found.length)
            });
            match length {
                Some(length) if length < free && take([at.te, next.te], next.course.along) => {
                    free -= length;
                    (pace.room, pace.looked) = (pace.room - length, false);
                    (at, gone) = (next, true);
                }
                _ => {
                    *pace = before;
                    return gone.then(|| guided.node(from.pose.ta, &at));
                }
            }
        }
    }

    /// What is foretold with a fixed axis: by the bends, and the length that comes of it for a first trial; `None` where that is
    /// another.
    #[inline(always)]
    pub(super) fn foretold(&self, from: &Course, cap: f64, pace: &Pace) -> Option<(f64, f64)> {
        let plan = self.plan(from, None, cap);
        let s = plan.length * pace.expected(false) * (1.0 - 0.25 * LONG_ENOUGH);
        (plan.length < plan.most && s < plan.most).then_some((plan.length, s))
    }

    /// Does a first trial that fits end the search for a length, when it could be longer by this ratio?
    #[inline(always)]
    pub(super) fn enough_at_once(&self, ratio: f64) -> bool {
        ratio - 1.0 <= LONG_ENOUGH && self.another(ratio, LONG_ENOUGH) == 0.0
    }

    /// The longest cut vector, found by trials.
    fn longest<T: Trials>(
        &self,
        trials: &T,
        cap: f64,
        pace: &mut Pace,
    ) -> Result<Stride<T::Place>, Trouble> {
        let (gaps, from) = trials.start();
        let long_enough = if self.axis.turns() { LONG_ENOUGH_TURNING } else { LONG_ENOUGH };
        // Share by which a length is foretold shorter than the band allows.
        let aim = 0.25 * long_enough;
        let mut bends = pace.expected_bends();
        let mut bent = None;
        let mut plan = self.plan(from, bends, cap);
        let mut s = (plan.length * pace.expected(self.axis.turns()) * (1.0 - aim)).min(plan.most);
        if plan.length >= plan.most && pace.length > 0.0 {
            // Nothing bends here, which may end soon.
            s = s.min(FARTHER * pace.length);
        }
        let (mut good, mut bad): (Option<Stride<T::Place>>, f64) = (None, f64::INFINITY);
        let mut last: Option<Stride<T::Place>> = None;
        // One that fits with its vertex elsewhere, where none does that has it in the right place.
        let mut spare: Option<Stride<T::Place>> = None;
        let mut trouble = Trouble::Stuck;
        let mut before: Option<(f64, f64)> = None;
        // The least length that is foretold from a bend.
        let mut usual = if plan.length < plan.most { plan.length } else { pace.length };
        let (mut between, mut beyond) = (Lengths::default(), None);
        let mut learnt = 0;
        // A chord that does not fit though its ratio says so is shortened more each time.
        let mut back: f64 = 0.0;
        // Does the first chord go on to another length?
        let mut over = false;
        // With an axis that turns trials also move the vertices, and do not fall evenly.
        let secants = !self.axis.turns();
        let (most_easy, close) = if secants { (EASY, FINE) } else { (EASY_TURNING, FINE_TURNING) };
        for trial in 0..TRIALS {
            // A length that does not come at once, as over a crest, depends on all trials unless it is found to the last digits.
            let easy = !T::FINAL || trial < most_easy;
            let fine = if easy { 1.0 } else { close };
            let longer = |ratio: f64, before: Option<(f64, f64)>| match easy {
                true => lengthen(s, ratio, before) * (1.0 - aim),
                false => lengthen(s, ratio - aim, before.map(|(s, ratio)| (s, ratio - aim))),
            };
            let tried = trials.reach(s, plan.length, bends, last.as_ref());
            let fit = tried.as_ref().map_err(|t| *t).and_then(|t| trials.fit(&t.to));
            let targets = tried.as_ref().map_or(gaps, |t| t.targets);
            let next = match fit {
                Ok(fit) => {
                    // With a turning axis only the chord tells how the gaps bend along it; and where the bend
                    // grows from nothing on the way, a vertex may lie where no chord of any length fits.
                    let lost = !fit.fits && fit.ratio < LOST;
                    if learnt < LESSONS && !over && (lost || self.axis.turns()) {
                        learnt += 1;
                        let better = self.plan(from, Some(fit.bends), cap);
                        let targeted = self.aims(gaps, fit.bends, better.length);
                        bent = Some(fit.bends);
                        let least = if lost { EDGES_APART } else { OFF_TARGET };
                        if self.differ(targeted, targets, least) {
                            // Once more with the vertex where it ought to be.
                            (bends, plan) = (Some(fit.bends), better);
                            let share = fit.ratio.clamp(LOST, 1.0 / LOST);
                            let next = match lost {
                                true if self.axis.turns() => s.min(TOO_FAR * plan.length),
                                true => s,
                                false => s * share,
                            };
                            s = (next * (1.0 - aim)).min(plan.most);
                            (good, bad, before) = (None, f64::INFINITY, None);
                            between = Lengths::default();
                            last = tried.ok().or(last);
                            spare = if fit.fits { last } else { spare };
                            continue;
                        }
                    }
                    if fit.fits {
                        let enough = if easy {
                            let more = before.and_then(|before| rest(s, fit.ratio, before));
                            more.unwrap_or(fit.ratio - 1.0) <= long_enough
                        } else {
                            // What the next trial would be is what this one lacks.
                            (longer(fit.ratio, before) / s - 1.0).abs() <= close * long_enough
                        };
                        let enough = enough || s >= plan.most;
                        let first = before.is_none() && bad.is_infinite() && !over;
                        if enough && first && s < plan.most {
                            let on = self.another(fit.ratio, long_enough);
                            if on != 0.0 {
                                (s, good, over) =
                                    ((s * (1.0 + on)).min(plan.most), tried.ok(), true);
                                continue;
                            }
                        }
                        // Of lengths found to the last digits one may be too long that fits yet.
                        let too_long = secants && !easy && fit.ratio < 1.0 + aim;
                        if enough {
                            let rest = if fit.ratio <= 1.0 + long_enough { fit.ratio } else { 1.0 };
                            pace.learn(s, rest, plan.length);
                            if self.axis.turns() {
                                pace.learn_bends(fit.bends);
                            }
                            return tried;
                        }
                        if too_long {
                            bad = bad.min(s);
                        }
                        if !too_long || good.is_none() {
                            good = tried.ok();
                        }
                    } else if over {
                        break;
                    } else {
                        bad = bad.min(s);
                    }
                    let ratio = if fit.fits { fit.ratio } else { fit.ratio.min(1.0 - back) };
                    if !fit.fits && good.is_none() {
                        back = (4.0 * back).clamp(long_enough, 0.5);
                    }
                    if let Ok(end) = &tried {
                        let foretold = self.plan(trials.course(&end.to), None, cap);
                        usual = usual.min(foretold.length);
                        // A flat end keeps touching what it has below it, and leaves it with the next bend.
                        let below = if bad.is_infinite() { trials.below(&end.to) } else { None };
                        beyond = below.map(|on| s + on + BEYOND * usual);
                    }
                    between.take(s, 1.0 / ratio - (1.0 - aim));
                    let next = beyond.take().or_else(|| between.next(usual));
                    let next = next.filter(|_| secants).unwrap_or_else(|| longer(ratio, before));
                    // Where the ratio does not tell why it does not fit, halfway to what does.
                    let halfway = |g: &Stride<T::Place>| 0.5 * (g.length + s);
                    let blind = !secants && !fit.fits && fit.ratio >= 1.0;
                    let next = good.as_ref().filter(|_| blind).map_or(next, halfway);
                    before = older(next, Some((s, ratio)), before);
                    next
                }
                Err(t) if !T::FINAL => return Err(t),
                Err(t) => {
                    trouble = t;
                    bad = bad.min(s);
                    0.5 * s
                }
            };
            last = tried.ok().or(last);
            let low = good.as_ref().map_or(0.0, |g| g.length);
            if bad - low <= fine * long_enough * low || s <= self.exact {
                break;
            }
            s = next.min(plan.most);
            if s <= low && bad.is_infinite() {
                // No longer one is foretold than the one that fits.
                break;
            }
            if s <= low || s >= bad {
                s = 0.5 * (low + bad);
            }
        }
        let stride = good.or(spare).ok_or(trouble)?;
        pace.learn(stride.length, 1.0, plan.length);
        if let Some(bends) = bent.filter(|_| self.axis.turns()) {
            pace.learn_bends(bends);
        }
        Ok(stride)
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
        let gaps = from.gaps.map(|g| g.g);
        let targets = self.aims(gaps, bends.unwrap_or(from.course.bends), usual);
        let to = self.walk_beside(from, s, targets, look, beside)?;
        let other = self.other_aims((gaps, &from.course), bends, to.course.bends, usual, targets);
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
        (gaps, from): ([f64; 2], &Course),
        bends: Option<[f64; 2]>,
        found: [f64; 2],
        usual: f64,
        targets: [f64; 2],
    ) -> Option<[f64; 2]> {
        let same = |i: usize| (found[i] - from.bends[i]).abs() <= SAME_BEND * found[i].abs();
        if bends.is_some() || same(0) && same(1) {
            return None;
        }
        let aims = self.aims(gaps, found, usual);
        self.differ(aims, targets, OFF_TARGET).then_some(aims)
    }

    /// Is a trial near enough to the length `s`, and does it touch at the places of the cutter that its start touches at?
    fn beside(&self, from: &Node, tried: &Stride, s: f64) -> bool {
        let alike = (0..2).all(|i| !self.apart(i, from, &tried.to));
        (tried.length - s).abs() <= BESIDE * s && alike
    }

    /// Are the aims off these targets by more than a share of the band?
    fn differ(&self, aims: [f64; 2], targets: [f64; 2], share: f64) -> bool {
        (0..2).any(|i| (aims[i] - targets[i]).abs() > share * self.bands[i].width)
    }

    /// Gaps of the next vertex when cut vectors are about `usual` long and the gaps bend so along them.
    #[inline]
    pub(super) fn aims(&self, gaps: [f64; 2], bends: [f64; 2], usual: f64) -> [f64; 2] {
        let [drive, part] = &self.bands;
        [drive.vertex(gaps[0], bends[0], usual), part.vertex(gaps[1], bends[1], usual)]
    }

    /// By what share of its length a first chord goes on that is long enough: at the edges of what is taken at once all of the way
    /// to the length that a second trial would have, and none of it in between.
    ///
    /// Else whether a ratio lies before or beyond an edge would make the vertex jump by as much, and rounding says so now and then.
    #[inline]
    fn another(&self, ratio: f64, long_enough: f64) -> f64 {
        let ramp = RAMP * long_enough;
        let short_enough = TOO_LONG * self.bands[0].share.min(self.bands[1].share);
        let (over, under) = (ratio - 1.0 - long_enough + ramp, 1.0 - ratio - short_enough + ramp);
        if under > 2.0 * (ramp + short_enough) {
            // An end at the very edge of the band, from where no chord is as long as it aims.
            return 0.0;
        }
        let share = (over.max(under) / ramp).clamp(0.0, 1.0);
        share * (ratio * (1.0 - 0.25 * long_enough) - 1.0)
    }

    /// The length foretold from how the gaps bend, and the greatest allowed.
    fn plan(&self, from: &Course, bends: Option<[f64; 2]>, cap: f64) -> Plan {
        let turn = from.curl.norm();
        let most = if turn * cap > MOST_TURN { MOST_TURN / turn } else { cap };
        let mut length = most;
        for (band, bend) in self.bands.iter().zip(bends.unwrap_or(from.bends)) {
            if bend.abs() * length * length > 8.0 * band.width {
                length = (8.0 * band.width / bend.abs()).sqrt();
            }
        }
        Plan { length, most }
    }
}

struct Plan {
    length: f64,
    most: f64,
}
