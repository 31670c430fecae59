//! How far aside of its line the chords of a pass lead a ball.
//!
//! Where the line bends to the side, as round the axis of a flange, the tool stands beside it half way along a chord and on it at
//! the ends: between a vertex of one pass and a chord of the next more is left.

use aptc_contact::axis_between;
use aptc_geometry::Vec3;

use crate::position::Position;
use crate::settings::Band;
use crate::solve::Setup;

/// Part of the band by which a chord leaves the line up or down at most.
const SAGS: f64 = 0.95;
/// A chord has no fewer spans.
const LEAST: f64 = 1e-12;

impl Setup<'_> {
    /// How far across, in this direction or against it, the centre of a ball is off its line on a chord over the middle of three
    /// places of a pass that is as long as tolerances, joints and MAXDP let it be.
    pub(crate) fn aside(&self, [a, p, b]: [&Position; 3], side: Vec3) -> f64 {
        let centre = |te: Vec3, ta: Vec3| te + ta * self.profile.corner_radius();
        let by = b.te - a.te;
        let length = by.norm();
        if length <= 0.0 {
            return 0.0;
        }
        let share = ((p.te - a.te).dot(&by) / (length * length)).clamp(0.0, 1.0);
        let on = centre(a.te + by * share, axis_between(a.ta, b.ta, share));
        let off = on - centre(p.te, p.ta);
        let [up, over] = [p.normal, side].map(|n| off.dot(&n).abs());
        // What a chord leaves of its line grows with the square of its length.
        let spans: f64 = (0..2).map(|k| (b.drive_uv[k] - a.drive_uv[k]).abs()).sum();
        let longest = (1.0 / spans.max(LEAST)).min(self.maxdp / length);
        let Band { intol, outtol } = self.band;
        let sags = SAGS * (intol + outtol) / up;
        (over * sags.min(longest * longest)).min(self.lateral)
    }
}
