//! Trials of cut vectors along guides: surfaces whose gaps are closed forms while the tool axis stands.
//!
//! The same places as those of the general trials, to rounding, found several times as fast. Whatever is out of the
//! ordinary is left to those.

use aptc_contact::{Gap, Guide, Reading};
use aptc_geometry::Vec3;

use super::judge::{Fit, RESOLUTION};
use super::keep::{Keep, Pose};
use super::stride::{Stride, Trials};
use super::track::{Course, Node, Track, Trouble, solve_normals};
use crate::axis::AxisRule;

/// Rounds of Newton's method; two are usual.
const ROUNDS: usize = 12;
/// Cosine of the turn from which the direction at the end of a cut vector may have to be reversed.
const SHARP: f64 = 0.5;

/// The guides of drive and part surface for a tool that keeps its axis; `None` when one has no closed form.
pub(super) fn guides(keeps: &[Keep; 2], axis: &AxisRule, pose: &Pose) -> Option<[Guide; 2]> {
    let guide = |keep: &Keep| {
        let tool = keep.tool(pose);
        Guide::new(&tool, &keep.surface, keep.condition, keep.side, keep.thick)
    };
    (!axis.turns()).then_some(())?;
    Some([guide(&keeps[0])?, guide(&keeps[1])?])
}

/// Trials along guides.
pub(super) struct Guided<'a> {
    pub(super) track: &'a Track,
    pub(super) guides: &'a [Guide; 2],
    pub(super) from: &'a Place,
}

/// A place on the track as guides read it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    te: Vec3,
    gaps: [f64; 2],
    normals: [Vec3; 2],
    course: Course,
}

impl Place {
    #[inline(always)]
    pub(super) fn of(node: &Node) -> Self {
        let [a, b] = &node.gaps;
        let (gaps, normals) = ([a.g, b.g], [a.normal, b.normal]);
        Self { te: node.pose.te, gaps, normals, course: node.course }
    }

    /// The tool end.
    #[inline]
    pub(crate) fn te(&self) -> Vec3 {
        self.te
    }

    /// Unit direction of motion.
    #[inline]
    pub(crate) fn along(&self) -> Vec3 {
        self.course.along
    }
}

impl Trials for Guided<'_> {
    type Place = Place;
    const FINAL: bool = false;

    #[inline(always)]
    fn start(&self) -> ([f64; 2], &Course) {
        (self.from.gaps, &self.from.course)
    }

    #[inline(always)]
    fn reach(
        &self,
        s: f64,
        usual: f64,
        bends: Option<[f64; 2]>,
        _: Option<&Stride<Place>>,
    ) -> Result<Stride<Place>, Trouble> {
        let (track, from) = (self.track, self.from);
        let targets = track.aims(from.gaps, bends.unwrap_or(from.course.bends), usual);
        let (step, across) = from.course.ahead(s);
        let start = from.te + step;
        let to = self.settle(start, start, across, targets)?;
        let (to, targets) =
            match track.other_aims(self.start(), bends, to.course.bends, usual, targets) {
                Some(aims) => (self.settle(start, to.te, across, aims)?, aims),
                None => (to, targets),
            };
        if (to.te - from.te).norm() > track.farthest(s) {
            return Err(Trouble::Stuck);
        }
        Ok(Stride { length: s, to, targets })
    }

    #[inline(always)]
    fn fit(&self, to: &Place) -> Result<Fit, Trouble> {
        let (track, from) = (self.track, self.from);
        let v = to.te - from.te;
        let mut all = Fit { fits: true, ratio: f64::INFINITY, bends: [0.0; 2] };
        if v.dot(&from.course.along) <= 0.0 && from.course.curl.norm() <= 0.0 {
            return Ok(Fit { fits: false, ratio: 0.5, ..all });
        }
        for (i, guide) in self.guides.iter().enumerate() {
            let keep = &track.keeps[i];
            if keep.is_plane() {
                continue;
            }
            let (here, there) = (from.gaps[i], to.gaps[i]);
            let slopes = [from.normals[i].dot(&v), to.normals[i].dot(&v)];
            let ends = [[here, slopes[0]], [there, slopes[1]]];
            let chord = guide.chord(from.te, v, ends, RESOLUTION * keep.width());
            let [low, high] = chord.ok_or(Trouble::Contact)?;
            let bow = slopes[1] - slopes[0];
            let (fits, ratio) = track.judge(i, [here, there], [low, high], bow);
            all.fits &= fits;
            all.ratio = all.ratio.min(ratio);
            all.bends[i] = bow / v.norm_squared();
        }
        Ok(all)
    }
}

impl Guided<'_> {
    /// Newton's method from `begin` to the place in the plane across `across` through `start`, with the gaps at their
    /// targets.
    #[inline(always)]
    fn settle(
        &self,
        start: Vec3,
        begin: Vec3,
        across: Vec3,
        targets: [f64; 2],
    ) -> Result<Place, Trouble> {
        let [drive, part] = self.guides;
        let exact = self.track.exact;
        let (mut te, mut last) = (begin, f64::INFINITY);
        for _ in 0..ROUNDS {
            let a = drive.read(te).ok_or(Trouble::Contact)?;
            let b = part.read(te).ok_or(Trouble::Contact)?;
            let off = [targets[0] - a.g, targets[1] - b.g, across.dot(&(start - te))];
            let worst = off[0].abs().max(off[1].abs()).max(off[2].abs());
            if worst <= exact {
                return place(te, [&a, &b], self.from.course.along);
            }
            if worst > 0.9 * last && worst > 10.0 * exact {
                break;
            }
            last = worst;
            te += solve_normals([a.normal, b.normal, across], off).ok_or(Trouble::SideBySide)?;
        }
        Err(Trouble::Stuck)
    }

    /// The node at a place, with the tool axis `ta`.
    #[inline(always)]
    pub(super) fn node(&self, ta: Vec3, at: &Place) -> Node {
        let gap = |i: usize| -> Gap { self.guides[i].gap(at.te, at.gaps[i], at.normals[i]) };
        Node { pose: Pose { te: at.te, ta }, gaps: [gap(0), gap(1)], course: at.course }
    }
}

/// The end of a trial, going on as `heading` does.
#[inline(always)]
fn place(te: Vec3, [a, b]: [&Reading; 2], heading: Vec3) -> Result<Place, Trouble> {
    let along = a.normal.cross(&b.normal).try_normalize(1e-7).ok_or(Trouble::SideBySide)?;
    let along = if along.dot(&heading) < 0.0 { -along } else { along };
    if along.dot(&heading) < SHARP {
        return Err(Trouble::Stuck);
    }
    let bends = [a.second(along), b.second(along)];
    let normals = [a.normal, b.normal];
    let course = Course::new(normals, along, bends)?;
    Ok(Place { te, gaps: [a.g, b.g], normals, course })
}
