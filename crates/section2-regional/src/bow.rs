//! How the chords of a pass lie beside the line that the tool follows.
//!
//! Between its ends a chord leaves that line up and down as far as the band lets it, and sideways as well: the tool stands to one
//! side, and where its axis turns, it leans otherwise than it would on the line. What it clears beside its contact lies elsewhere then.

use aptc_contact::{Tool, axis_between};
use aptc_geometry::Vec3;

use crate::position::Position;
use crate::settings::Band;
use crate::solve::Setup;

/// Part of the band by which a chord leaves the line at most.
const SAGS: f64 = 0.95;
/// Below this part of the size of things a tool does not move.
const LEAST: f64 = 1e-12;

/// What a chord from one place to another leaves at a place between them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bow {
    /// From the tool end on the line to that on the chord, and the same of the axis.
    te: Vec3,
    ta: Vec3,
    /// How far what touches is moved along the normal there.
    up: f64,
    /// Spans of the drive from the one place to the other.
    spans: f64,
}

impl Bow {
    /// At the middle of three places of a pass.
    pub(crate) fn at(setup: &Setup<'_>, [a, p, b]: [&Position; 3]) -> Self {
        let way = b.te - a.te;
        let length = way.norm_squared();
        let spans = (0..2).map(|k| (b.drive_uv[k] - a.drive_uv[k]).abs()).sum();
        let share = if length > LEAST * LEAST * setup.profile.reach().powi(2) {
            ((p.te - a.te).dot(&way) / length).clamp(0.0, 1.0)
        } else {
            0.5
        };
        let (te, ta) = (a.te + way * share, axis_between(a.ta, b.ta, share));
        let low = |te, ta| lowest(setup, p.normal, te, ta);
        let up = low(te, ta) - low(p.te, p.ta);
        Self { te: te - p.te, ta: ta - p.ta, up, spans }
    }

    /// The place as the tool takes it on a chord as long as the tolerance lets it be, at the same height over the surface, where
    /// that is another one; `beside` are the places next to it, which may hold chords shorter.
    pub(crate) fn longest(
        &self,
        setup: &Setup<'_>,
        p: &Position,
        beside: [Self; 2],
    ) -> Option<Position> {
        let Band { intol, outtol } = setup.band;
        let per_span = |bow: Self| bow.up.abs() / (bow.spans * bow.spans).max(LEAST);
        let up = beside.into_iter().map(per_span).fold(per_span(*self), f64::max);
        let level = (self.te - p.normal * self.te.dot(&p.normal)).norm();
        // What a chord leaves grows with the square of its length, which is no more than a span.
        let whole = 1.0 / (self.spans * self.spans).max(LEAST);
        let mut times = whole;
        if up > 0.0 {
            times = times.min(whole * SAGS * (intol + outtol) / up);
        }
        if level > 0.0 {
            times = times.min(setup.lateral / level);
        }
        let moved = times * (self.te.norm() + setup.profile.reach() * self.ta.norm());
        if moved <= LEAST * setup.profile.reach() {
            return None;
        }
        let ta = (p.ta + self.ta * times).try_normalize(0.0)?;
        let low = |te, ta| lowest(setup, p.normal, te, ta);
        let te = p.te + self.te * times;
        let te = te + p.normal * (low(p.te, p.ta) - low(te, ta));
        Some(Position { te, ta, ..*p })
    }
}

/// How high the tool reaches down along a normal.
fn lowest(setup: &Setup<'_>, normal: Vec3, te: Vec3, ta: Vec3) -> f64 {
    let tool = Tool { profile: setup.profile, te: Vec3::zeros(), ta };
    te.dot(&normal) - tool.support(-normal).reach
}
