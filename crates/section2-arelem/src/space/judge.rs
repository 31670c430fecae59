//! How a chord lies in the bands, and how much longer it could be (APT: `GOUGCK`).

use aptc_contact::{Condition, Exact, Gap, chord};
use aptc_geometry::profile::Segment;
use aptc_geometry::{Surface, Vec3};

use super::keep::Pose;
use super::track::{Node, Track, Trouble};

/// Shares of a chord at which it is looked at as a whole where its contact goes over from one place to another.
pub(super) const BETWEEN: [f64; 7] = [0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98];
/// Places of contact that are farther apart than this share of the cutter's radius are two.
const ANOTHER: f64 = 0.1;
/// Share of the way of the contact around the cutter by which it may be beside the middle of it halfway.
const MIDWAY: f64 = 0.1;
/// Share of what the bends at both ends of a way say of the rise of the slope by which it falls short where there is an edge.
const LOST_SLOPE: f64 = 0.3;
/// Share of the band by which two places that touch at once may differ.
const BOTH: f64 = 1e-2;

/// How a chord lies in the bands: it fits, the ratio by which it could be longer, second derivatives of the gaps along it, from the
/// slopes at its ends, and whether it goes over a crest below a flat end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fit {
    pub(super) fits: bool,
    pub(super) ratio: f64,
    pub(super) bends: [f64; 2],
    pub(super) crest: bool,
}

impl Track {
    /// Does the chord between two nodes stay in both bands?
    pub(crate) fn fits(&self, from: &Node, to: &Node) -> bool {
        self.fit(from, to, true).is_ok_and(|f| f.fits)
    }

    /// The same of a tool that turns in place.
    pub(super) fn holds(&self, from: &Node, to: &Node) -> bool {
        (0..2).all(|i| self.fit_one(i, from, to, true).is_ok_and(|(fits, ..)| fits))
    }

    /// Does the chord stay in both bands, and how much longer could it be? With `between` it is looked at as a whole where the
    /// contact goes over from one place to another.
    pub(super) fn fit(&self, from: &Node, to: &Node, between: bool) -> Result<Fit, Trouble> {
        let mut all = Fit { fits: true, ratio: f64::INFINITY, bends: [0.0; 2], crest: false };
        // The end must be ahead: a track that closes on itself is not cut short.
        if (to.pose.te - from.pose.te).dot(&from.course.along) <= 0.0
            && from.course.curl.norm() <= 0.0
        {
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
        if keep.stands_above(&to.pose) {
            // It has left the hollow by the walls that run straight up from it.
            return Err(Trouble::Contact);
        }
        let v = to.pose.te - from.pose.te;
        // Along a surface of rulings a flank lies nearly, and its gap goes by more than cubics.
        let looks: &[f64] = match keep.surface {
            Surface::Parametric(_) if turning && keep.condition == Condition::Touch => &BETWEEN,
            _ => &[],
        };
        // Until the contact goes over the first place governs: a gap of the other beyond the band does not count there. Looks see
        // by themselves where it does.
        let top = from.gaps[i].g.max(keep.limits().high);
        let other = self.governs(i, from, to).filter(|o| looks.is_empty() || o.g <= top);
        let ends = [other.as_ref().unwrap_or(&from.gaps[i]), &to.gaps[i]];
        let (band, limits) = (&self.bands[i], keep.limits());
        let c = chord(
            &keep.tool(&from.pose),
            &keep.tool(&to.pose),
            &keep.surface,
            keep.condition,
            keep.side,
            keep.thick,
            Some([*ends[0], *ends[1]]),
            Exact::beside(band.resolution, [limits.low, limits.high]).looking(looks),
        )?;
        let gaps = [from.gaps[i].g, to.gaps[i].g];
        let (mut low, mut high) = (c.low.g, c.high.g);
        if other.is_some_and(|o| o.g > top) {
            let (t, crest) = self.crest(i, from, to)?;
            let beyond = if c.high.t < t { gaps[1] } else { high };
            high = beyond.max(crest);
        }
        if looks.is_empty() && (keep.condition == Condition::Touch && turning || keep.is_mixed()) {
            // A turning axis may bring another place of the cutter down between two vertices at which it is free; and where
            // the contact goes over from one place to another the gap has an edge on the way.
            let apart =
                (turning || whole) && self.apart(i, from, to) && !self.goes_round(i, from, to)?;
            let [least, most] = match apart {
                true => self.over_kinks(i, from, to)?,
                false if turning => [keep.gap(&between(&from.pose, &to.pose, 0.5), None)?.g; 2],
                false => gaps,
            };
            (low, high) = (low.min(least), high.max(most));
        }
        let begin = ends[0].g.min(top);
        let (fits, ratio) = band.judge([begin, gaps[1]], [low, high], c.bow);
        // Between two places where one end of a flank touches the other end may come down, and bend the gap otherwise.
        let (dip, rise) = (begin.min(gaps[1]) - low, high - begin.max(gaps[1]));
        let bow = match looks.is_empty() {
            false if dip.max(rise) > c.bow.abs() / 8.0 => {
                8.0 * if dip > rise { dip } else { -rise }
            }
            _ => c.bow,
        };
        Ok((fits, ratio, bow / v.norm_squared()))
    }

    /// Does the cutter touch at different places of it at both ends?
    pub(super) fn apart(&self, i: usize, from: &Node, to: &Node) -> bool {
        let [a, b] = [from, to].map(|node| (&node.gaps[i], node.pose.te));
        let bends = [from, to].map(|node| node.course.bends[i]);
        self.touches_elsewhere(i, a, b) || self.has_edge(i, [a, b], bends)
    }

    /// Has the gap an edge on the way between two places at which it bends so?
    pub(super) fn has_edge(
        &self,
        i: usize,
        [(a, from), (b, to)]: [(&Gap, Vec3); 2],
        bends: [f64; 2],
    ) -> bool {
        if self.axis.turns() || !self.keeps[i].is_mixed() {
            return false;
        }
        let way = to - from;
        loses_slope((b.normal - a.normal).dot(&way), bends, way.norm_squared())
    }

    /// Does a cutter touch at different places of it with the tool end here and there, and at different ones of the surface? What
    /// goes over one crest touches at the same place of that. A flat end that goes from one crest of a TABCYL or a ruled surface
    /// to another is told by their spans.
    pub(super) fn touches_elsewhere(&self, i: usize, a: (&Gap, Vec3), b: (&Gap, Vec3)) -> bool {
        /// Spans between two crests at least.
        const CRESTS: f64 = 1.5;
        let keep = &self.keeps[i];
        let [p, q] = [a, b].map(|(gap, te)| gap.tool_point - te);
        let flat = |gap: &Gap| gap.at.filter(|_| gap.segment == Some(Segment::LowerLine));
        let spans = || match (&keep.surface, flat(a.0)?, flat(b.0)?) {
            (Surface::Tabcyl(s), a, b) => Some(s.spans_between(a[0], b[0])),
            (Surface::Parametric(s), a, b) => s.spans_between(a, b),
            _ => None,
        };
        let another = ANOTHER * keep.profile.half_width(a.0.segment);
        let far = |a: Vec3, b: Vec3| (a - b).norm() > another;
        far(p, q) && far(a.0.surface_point, b.0.surface_point)
            || spans().is_some_and(|n| n > CRESTS)
    }

    /// Does the place of contact go round the cutter evenly, as with a chord along a small circle? At surfaces that have two
    /// places to touch at most it is midway halfway then, and where it goes over from one to the other it is at one of them.
    fn goes_round(&self, i: usize, from: &Node, to: &Node) -> Result<bool, Trouble> {
        let keep = &self.keeps[i];
        if !matches!(keep.surface, Surface::Sphere(_) | Surface::Cylinder(_) | Surface::Cone(_)) {
            return Ok(false);
        }
        let middle = between(&from.pose, &to.pose, 0.5);
        let at = |gap: &Gap, te: Vec3| gap.tool_point - te;
        let [a, b] = [from, to].map(|node| at(&node.gaps[i], node.pose.te));
        let there = at(&keep.gap(&middle, None)?, middle.te);
        Ok((there - (a + b) * 0.5).norm() <= MIDWAY * (b - a).norm())
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

/// Does the slope of a gap that bends so at both ends of a way, the square of which is `square`, rise on it by less than that?
/// Where the contact goes over from one place to another the slope falls, also where both lie side by side.
#[inline]
pub(super) fn loses_slope(rise: f64, bends: [f64; 2], square: f64) -> bool {
    let lost = 0.5 * (bends[0] + bends[1]) * square - rise;
    lost > LOST_SLOPE * bends[0].abs().max(bends[1].abs()) * square
}

/// The pose at `t` in [0, 1] of a cut vector: the tool end moves straight, the axis turns evenly.
pub(crate) fn between(a: &Pose, b: &Pose, t: f64) -> Pose {
    Pose { te: a.te + (b.te - a.te) * t, ta: slerp(a.ta, b.ta, t) }
}

/// How the axis turns along a cut vector: radians, as a vector.
pub(super) fn turn(a: &Pose, b: &Pose) -> Vec3 {
    let across = a.ta.cross(&b.ta);
    let sin = across.norm();
    let angle = aptc_geometry::trig::atan2(sin, a.ta.dot(&b.ta));
    across.try_normalize(1e-15).map_or(Vec3::zeros(), |axis| axis * angle)
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
