//! Trials of a cut vector by the contacts of the tool.

use aptc_contact::Gap;
use aptc_geometry::profile::Segment;

use super::judge::Fit;
use super::keep::{Keep, Pose};
use super::longest::Trials;
use super::stride::Stride;
use super::track::{Course, Node, Track, Trouble};

/// Share of a length up to which another trial begins at the one before.
const BESIDE: f64 = 0.25;
/// Sine of the angle to a flat end up to which a track goes along it.
const LEVEL: f64 = 0.1;

/// Trials by contacts; with `look` none that is deeper may be elsewhere, with `between` chords on which the contact goes
/// over from one place to another are looked at as a whole.
pub(super) struct Contacts<'a> {
    pub(super) track: &'a Track,
    pub(super) from: &'a Node,
    pub(super) look: bool,
    pub(super) between: bool,
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
            let level = to.course.along.dot(&ta).abs() < LEVEL;
            // What does not bend is left with no bend.
            let touches = gap.segment == Some(Segment::LowerLine) && level && !keep.is_plane();
            touches.then_some(radius + from_axis)
        };
        self.track.keeps.iter().zip(&to.gaps).filter_map(flat).min_by(f64::total_cmp)
    }

    fn course<'p>(&self, to: &'p Node) -> &'p Course {
        &to.course
    }
}

impl Track {
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

    /// Is a trial near enough to the length `s`, and does it touch at the places of the cutter that its start touches at?
    fn beside(&self, from: &Node, tried: &Stride, s: f64) -> bool {
        let alike = (0..2).all(|i| !self.apart(i, from, &tried.to));
        (tried.length - s).abs() <= BESIDE * s && alike
    }
}
