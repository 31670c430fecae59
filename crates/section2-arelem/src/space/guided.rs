//! Trials of cut vectors along guides: surfaces whose gaps are closed forms, or hang on one point of the tool, while its axis
//! stands.
//!
//! The same places as those of the general trials, to rounding, found several times as fast. Whatever is out of the
//! ordinary is left to those.

use std::cell::Cell;

use aptc_contact::{ClosedGuide, End, Gap, Guide, Passed, PointGuide, Reading};
use aptc_geometry::Vec3;

use super::judge::{Fit, loses_slope};
use super::keep::{Keep, Pose};
use super::longest::Trials;
use super::pace::Pace;
use super::stride::Stride;
use super::track::{Course, Node, SIDE_BY_SIDE, Track, Trouble, solve_normals};
use crate::axis::AxisRule;

/// Rounds of Newton's method; two are usual.
const ROUNDS: usize = 12;
/// Turn of the normal of a crest below a flat end that is none.
const LEVEL: f64 = 1e-10;
/// Cosine of the turn from which the direction at the end of a cut vector may have to be reversed.
const SHARP: f64 = 0.5;

/// The guides of drive and part surface.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Guides {
    /// Both have closed forms.
    Closed([ClosedGuide; 2]),
    /// One of them hangs on a point.
    Point([PointGuide; 2]),
}

impl Guides {
    /// Those of a tool that keeps its axis; `None` when there are none.
    pub(super) fn new(keeps: &[Keep; 2], axis: &AxisRule, pose: &Pose) -> Option<Self> {
        fn both<G: Guide>(keeps: &[Keep; 2], pose: &Pose) -> Option<[G; 2]> {
            let guide = |k: &Keep| {
                let tool = k.tool(pose);
                G::new(&tool, &k.surface, k.condition, k.side, k.thick)
            };
            Some([guide(&keeps[0])?, guide(&keeps[1])?])
        }
        (!axis.turns()).then_some(())?;
        let closed = both(keeps, pose).map(Self::Closed);
        closed.or_else(|| both(keeps, pose).map(Self::Point))
    }

    /// May they miss a place of contact that becomes the deepest?
    pub(super) fn several(&self) -> bool {
        match self {
            Self::Closed(_) => false,
            Self::Point(guides) => guides.iter().any(Guide::several),
        }
    }
}

/// Trials along guides.
pub(super) struct Guided<'a, G: Guide> {
    pub(super) track: &'a Track,
    pub(super) guides: &'a [G; 2],
    pub(super) from: &'a Along<G>,
    /// The first trial, where it was made at once and others are to follow.
    tried: Cell<Option<Tried<Along<G>>>>,
}

/// A trial by its length, and that of cut vectors about there, with what came of it.
#[derive(Clone, Copy)]
struct Tried<To> {
    length: f64,
    usual: f64,
    end: Result<Stride<To>, Trouble>,
    fit: Result<Fit, Trouble>,
}

impl<'a, G: Guide> Guided<'a, G> {
    #[inline(always)]
    pub(super) fn new(track: &'a Track, guides: &'a [G; 2], from: &'a Along<G>) -> Self {
        Self { track, guides, from, tried: Cell::new(None) }
    }
}

/// A place on the track as guides read it, and how the gaps bend there where they were read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<At, Bow> {
    pub(super) te: Vec3,
    gaps: [End<At>; 2],
    bows: Option<[Bow; 2]>,
    pub(super) course: Course,
    /// The places of the surfaces at the one before, and the way from there.
    before: Option<([At; 2], f64)>,
}

/// That of a guide.
pub(super) type Along<G> = Place<<G as Guide>::At, <G as Guide>::Bow>;

impl<At: Copy, Bow: Copy> Place<At, Bow> {
    #[inline(always)]
    pub(super) fn of<G: Guide<At = At>>(node: &Node) -> Self {
        let [a, b] = &node.gaps;
        let end = |gap: &Gap| End { g: gap.g, normal: gap.normal, at: G::at(gap) };
        let gaps = [end(a), end(b)];
        Self { te: node.pose.te, gaps, bows: None, course: node.course, before: None }
    }

    /// Where the places of the surfaces are after a way of `s`, about: as far ahead as they came from those before.
    #[inline(always)]
    fn ahead<G: Guide<At = At>>(&self, s: f64) -> [At; 2] {
        let [a, b] = [self.gaps[0].at, self.gaps[1].at];
        match self.before {
            Some(([from, other], way)) if way > 0.0 => {
                [G::ahead(from, a, s / way), G::ahead(other, b, s / way)]
            }
            _ => [a, b],
        }
    }

    #[inline(always)]
    fn gaps(&self) -> [f64; 2] {
        [self.gaps[0].g, self.gaps[1].g]
    }
}

impl<G: Guide> Trials for Guided<'_, G> {
    type Place = Along<G>;
    const FINAL: bool = false;

    #[inline(always)]
    fn start(&self) -> ([f64; 2], &Course) {
        (self.from.gaps(), &self.from.course)
    }

    fn reach(
        &self,
        s: f64,
        usual: f64,
        bends: Option<[f64; 2]>,
        _: Option<&Stride<Self::Place>>,
    ) -> Result<Stride<Self::Place>, Trouble> {
        let same = |t: &Tried<Along<G>>| {
            t.length.total_cmp(&s).is_eq() && t.usual.total_cmp(&usual).is_eq()
        };
        if let Some(tried) = self.tried.get().filter(|t| bends.is_none() && same(t)) {
            return tried.end;
        }
        let mut to = *self.from;
        let targets = self.go(s, usual, bends, &mut to)?;
        Ok(Stride { length: s, to, targets })
    }

    fn fit(&self, to: &Self::Place) -> Result<Fit, Trouble> {
        let same = |t: &Tried<Along<G>>| t.end.as_ref().is_ok_and(|end| end.to.te == to.te);
        match self.tried.take().filter(same) {
            Some(tried) => tried.fit,
            None => self.fits(to),
        }
    }

    fn below(&self, to: &Self::Place) -> Option<f64> {
        let leaves = |i: usize| self.guides[i].leaves(to.te, &to.gaps[i], to.course.along);
        (0..2).filter_map(leaves).min_by(f64::total_cmp)
    }

    #[inline(always)]
    fn course<'p>(&self, to: &'p Self::Place) -> &'p Course {
        &to.course
    }
}

impl<G: Guide> Guided<'_, G> {
    /// How the chord to it lies in both bands, and how much longer it could be.
    #[inline(always)]
    fn fits(&self, to: &Along<G>) -> Result<Fit, Trouble> {
        let (track, from) = (self.track, self.from);
        let v = to.te - from.te;
        let mut all = Fit { fits: true, ratio: f64::INFINITY, bends: [0.0; 2], crest: false };
        if v.dot(&from.course.along) <= 0.0 && from.course.curl.norm() <= 0.0 {
            return Ok(Fit { fits: false, ratio: 0.5, ..all });
        }
        for (i, guide) in self.guides.iter().enumerate() {
            let keep = &track.keeps[i];
            if keep.is_plane() {
                continue;
            }
            let (here, there) = (&from.gaps[i], &to.gaps[i]);
            let bow = |p: &Along<G>| p.bows.map(|bows| bows[i]);
            let bows = bow(from).zip(bow(to));
            let resolution = track.bands[i].resolution;
            let chord = guide.chord(&keep.surface, from.te, v, [here, there], bows, resolution);
            // The contact may have gone over to another place.
            let Passed { gaps: [low, high], crest } = chord.ok_or(Trouble::Contact)?;
            all.crest |= crest;
            let turned = there.normal - here.normal;
            // Along the plane of a flat end a gap bends by rounding alone.
            let level = crest && turned.norm_squared() <= LEVEL * LEVEL;
            let bow = if level { 0.0 } else { turned.dot(&v) };
            let bends = [from.course.bends[i], to.course.bends[i]];
            if guide.several() && !crest && loses_slope(bow, bends, v.norm_squared()) {
                return Err(Trouble::Contact);
            }
            let (fits, ratio) = track.bands[i].judge([here.g, there.g], [low, high], bow);
            all.fits &= fits;
            all.ratio = all.ratio.min(ratio);
            all.bends[i] = bow / v.norm_squared();
        }
        Ok(all)
    }

    /// The cut vector that is as long as foretold, as most are: what [`Track::longest`] takes with its first trial. Its end comes
    /// to `to`; gives its length, `None` where other lengths are to be tried.
    #[inline(always)]
    pub(super) fn at_once(&self, cap: f64, pace: &mut Pace, to: &mut Along<G>) -> Option<f64> {
        let track = self.track;
        let (plan, s) = track.foretold(&self.from.course, cap, pace)?;
        let end = self.go(s, plan, None, to);
        let fit = end.and_then(|_| self.fits(to));
        if let Ok(Fit { fits: true, ratio, .. }) = fit
            && track.enough_at_once(ratio)
        {
            pace.learn(s, ratio, plan);
            return Some(s);
        }
        let end = end.map(|targets| Stride { length: s, to: *to, targets });
        self.tried.set(Some(Tried { length: s, usual: plan, end, fit }));
        None
    }

    /// To the place at distance `s`, as [`Trials::reach`].
    #[inline(always)]
    fn go(
        &self,
        s: f64,
        usual: f64,
        bends: Option<[f64; 2]>,
        to: &mut Along<G>,
    ) -> Result<[f64; 2], Trouble> {
        let (track, from) = (self.track, self.from);
        let mut targets = track.aims(from.gaps(), bends.unwrap_or(from.course.bends), usual);
        let (step, across) = from.course.ahead(s);
        let start = from.te + step;
        self.settle(start, start, across, targets, from.ahead::<G>(s), to)?;
        let other = track.other_aims(self.start(), bends, to.course.bends, usual, targets);
        if let Some(aims) = other {
            let (begin, near) = (to.te, [to.gaps[0].at, to.gaps[1].at]);
            self.settle(start, begin, across, aims, near, to)?;
            targets = aims;
        }
        let far = track.farthest(s);
        if (to.te - from.te).norm_squared() > far * far {
            return Err(Trouble::Stuck);
        }
        Ok(targets)
    }

    /// Newton's method from `begin` to the place in the plane across `across` through `start`, with the gaps at their
    /// targets, from the places `at` of both surfaces.
    #[inline(always)]
    fn settle(
        &self,
        start: Vec3,
        begin: Vec3,
        across: Vec3,
        targets: [f64; 2],
        mut at: [G::At; 2],
        to: &mut Along<G>,
    ) -> Result<(), Trouble> {
        let [drive, part] = self.guides;
        let [one, two] = [&self.track.keeps[0].surface, &self.track.keeps[1].surface];
        let exact = self.track.exact;
        let (mut te, mut last) = (begin, f64::INFINITY);
        for _ in 0..ROUNDS {
            let a = drive.read(one, te, at[0]).ok_or(Trouble::Contact)?;
            let b = part.read(two, te, at[1]).ok_or(Trouble::Contact)?;
            at = [a.end.at, b.end.at];
            let off = [targets[0] - a.end.g, targets[1] - b.end.g, across.dot(&(start - te))];
            let worst = off[0].abs().max(off[1].abs()).max(off[2].abs());
            if worst <= exact {
                return self.place(te, [&a, &b], to);
            }
            if worst > 0.9 * last && worst > 10.0 * exact {
                break;
            }
            last = worst;
            let by = solve_normals([a.end.normal, b.end.normal, across], off)
                .ok_or(Trouble::SideBySide)?;
            te += by;
            if by.norm_squared() <= exact * self.track.size {
                // The place is read so well that another reading would say nothing new.
                let ((a, in_a), (b, in_b)) = (a.moved::<G>(by), b.moved::<G>(by));
                if in_a.abs() <= exact && in_b.abs() <= exact {
                    return self.place(te, [&a, &b], to);
                }
            }
        }
        Err(Trouble::Stuck)
    }

    /// The node at a place, with the tool axis `ta`.
    #[inline(always)]
    pub(super) fn node(&self, ta: Vec3, at: &Along<G>) -> Node {
        let gap = |i: usize| -> Gap { self.guides[i].gap(at.te, &at.gaps[i]) };
        Node { pose: Pose { te: at.te, ta }, gaps: [gap(0), gap(1)], course: at.course }
    }

    /// The end of a trial comes to `to`, going on as its start does.
    #[inline(always)]
    fn place(
        &self,
        te: Vec3,
        [a, b]: [&Reading<G::At, G::Bends>; 2],
        to: &mut Along<G>,
    ) -> Result<(), Trouble> {
        let heading = self.from.course.along;
        let normals = [a.end.normal, b.end.normal];
        let along = normals[0].cross(&normals[1]);
        let sine = along.norm();
        if sine <= SIDE_BY_SIDE {
            return Err(Trouble::SideBySide);
        }
        let along = along * (if along.dot(&heading) < 0.0 { -1.0 } else { 1.0 } / sine);
        if along.dot(&heading) < SHARP {
            return Err(Trouble::Stuck);
        }
        let bends = [G::second(a, along), G::second(b, along)];
        let beyond = [G::beyond(a, along), G::beyond(b, along)];
        let course = Course { bends: beyond, ..Course::across(normals, sine, along, bends) };
        let from = [self.from.gaps[0].at, self.from.gaps[1].at];
        let before = Some((from, (te - self.from.te).norm()));
        let bows = Some([G::bow(a), G::bow(b)]);
        *to = Place { te, gaps: [a.end, b.end], bows, course, before };
        Ok(())
    }
}
