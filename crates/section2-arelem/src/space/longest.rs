//! The longest cut vector that the band allows (APT: `DELTA`, `ADELTA`), found by trials.
//!
//! A chord between two places at gaps e and f above the low limit, over a surface whose gap bends along it,
//! dips by what a parabola does: with A the depth of the parabola over its chord, the lowest place is at the
//! limit when A = (sqrt e + sqrt f)^2. A grows with the square of the length. So the ratio of the longest
//! chord to the one just tried is known from the lowest gap on it, and the search for the length takes two
//! or three trials. The same holds for the high limit over hollow surfaces.

use super::band::AIM_TURNING;
use super::judge::Fit;
use super::lengths::{Lengths, lengthen, older, rest};
use super::pace::Pace;
use super::stride::Stride;
use super::track::{Course, Track, Trouble};

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
/// By how much longer than it is foretold from its bend a chord is tried again that was much too long.
const TOO_FAR: f64 = 2.0;
/// By how much longer than the one before a cut vector is tried at first where nothing bends.
const FARTHER: f64 = 16.0;
/// Share of the length that is foretold from a bend by which a chord goes beyond what a flat end touched below it.
const BEYOND: f64 = 0.5;
/// How often one cut vector may learn from its chord how its gaps bend.
const LESSONS: u32 = 3;
/// A chord to be shortened to less than this has its vertex in the wrong place.
const LOST: f64 = 0.5;
/// Share of the band by which such a vertex is moved at least.
const EDGES_APART: f64 = 1e-9;
/// Share of a length that fits, and could be so many times as long for its chord, to which it is found how far there are
/// places at all.
const TO_THE_END: f64 = 1.0 / 16.0;
const FREE: f64 = 2.0;
/// Share of the band below which no length is tried where there was no place at any.
const NOWHERE: f64 = 1e-3;
/// The same of a way behind which there are none: the motion ends there.
const NO_MORE: f64 = 1e-4;
/// Greatest turn of the track in one cut vector, radians.
const MOST_TURN: f64 = 2.0;

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

impl Track {
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
    pub(super) fn longest<T: Trials>(
        &self,
        trials: &T,
        cap: f64,
        pace: &mut Pace,
    ) -> Result<Stride<T::Place>, Trouble> {
        let (gaps, from) = trials.start();
        let long_enough = if self.axis.turns() { LONG_ENOUGH_TURNING } else { LONG_ENOUGH };
        // Share by which a length is foretold shorter than the band allows.
        let aim = 0.25 * long_enough;
        let narrow = self.bands[0].width.min(self.bands[1].width);
        let over_the_end = pace.left.is_some_and(|left| left <= NO_MORE * narrow);
        let mut bends = pace.expected_bends();
        let mut bent = None;
        let mut plan = self.plan(from, bends, cap);
        let mut s = (plan.length * pace.expected(self.axis.turns()) * (1.0 - aim)).min(plan.most);
        if plan.length >= plan.most && pace.length > 0.0 {
            // Nothing bends here, which may end soon.
            s = s.min(FARTHER * pace.length);
        }
        // Behind a place beyond which none was found the next is as far as there; at its end one may be beyond.
        s = pace.left.filter(|_| !over_the_end).map_or(s, |left| s.min(left));
        let found = pace.found.take();
        s = found.map_or(s, |found| found.min(plan.most));
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
        // Is there no place at the length that is too long, and at no other so far? And may the one that fits be far longer?
        let (mut ends, mut none, mut free) = (false, true, false);
        let least = NOWHERE * narrow;
        // Does the first chord go on to another length?
        let mut over = false;
        // With an axis that turns trials also move the vertices, and do not fall evenly.
        let secants = !self.axis.turns();
        let (most_easy, close) = if secants { (EASY, FINE) } else { (EASY_TURNING, FINE_TURNING) };
        for trial in 0..TRIALS {
            let tried = trials.reach(s, plan.length, bends, last.as_ref());
            let fit = tried.as_ref().map_err(|t| *t).and_then(|t| trials.fit(&t.to));
            let targets = tried.as_ref().map_or(gaps, |t| t.targets);
            // A length that does not come at once, as over a crest, depends on all trials unless it is found to the last digits.
            let easy = trial < most_easy || !T::FINAL && fit.as_ref().is_ok_and(|fit| !fit.crest);
            let fine = if easy { 1.0 } else { close };
            let longer = |ratio: f64, before: Option<(f64, f64)>| match easy {
                true => lengthen(s, ratio, before) * (1.0 - aim),
                false => lengthen(s, ratio - aim, before.map(|(s, ratio)| (s, ratio - aim))),
            };
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
                        // What was found before is taken as it was then, whether or not it was looked at in between.
                        let again = trial == 0 && found.is_some();
                        let enough = if easy {
                            let more = before.and_then(|before| rest(s, fit.ratio, before));
                            more.unwrap_or(fit.ratio - 1.0) <= long_enough
                        } else {
                            // What the next trial would be is what this one lacks.
                            (longer(fit.ratio, before) / s - 1.0).abs() <= close * long_enough
                        };
                        let enough = enough || again || s >= plan.most;
                        let first = before.is_none() && bad.is_infinite() && !over && !again;
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
                        free = fit.ratio >= FREE;
                    } else if over {
                        break;
                    } else {
                        (bad, ends) = (bad.min(s), ends && s >= bad);
                    }
                    none = false;
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
                Err(t) if !T::FINAL || over_the_end && good.is_none() => return Err(t),
                Err(t) => {
                    trouble = t;
                    // With a fixed axis a corner may be there, to which the tool comes by ever shorter vectors.
                    (bad, ends) = (bad.min(s), self.axis.turns());
                    if ends && none && s <= least {
                        break;
                    }
                    0.5 * s
                }
            };
            last = tried.ok().or(last);
            let low = good.as_ref().map_or(0.0, |g| g.length);
            // How far there are places is no matter to the last digits.
            let at_end = ends && free && bad - low <= TO_THE_END * low;
            if at_end || bad - low <= fine * long_enough * low || s <= self.exact {
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
        // What only was not found may be beyond from nearer by.
        let over = ends && free && matches!(trouble, Trouble::Contact);
        let left = good.as_ref().filter(|_| over).map(|g| bad - g.length);
        let stride = good.or(spare).ok_or(trouble)?;
        pace.learn(stride.length, 1.0, plan.length);
        pace.left = left;
        if let Some(bends) = bent.filter(|_| self.axis.turns()) {
            pace.learn_bends(bends);
        }
        Ok(stride)
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
