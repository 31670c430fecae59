//! A flat bottom that is led along lines of projection and stands square on the surface.

use aptc_contact::{Clear, Tool};
use aptc_geometry::Vec3;

use crate::area::AxisArea;
use crate::drive::DrivePoint;
use crate::project::{Met, Probe, Shot};
use crate::settings::Band;
use crate::solve::{CLOSE, Setup};

/// Leans that are none, radians: what they tilt a bottom by is rounding.
const SQUARE: f64 = 1e-12;

impl Setup<'_> {
    /// Where a flat bottom touches with its middle, its axis the normal there: the tool end stands on the line of projection.
    ///
    /// With an axis along the normal of the part surface a bottom that is led may touch with any place of it: each place
    /// of a hump as near to the line as the bottom is wide has its own axis. The search for one by turns, contact and axis,
    /// would have to choose, and where the axis it begins with is far off it comes to the edge of the bottom and not to an
    /// end. The middle is the one place that is as far from all the others; what the drive is like has no say in it.
    /// `None` where no bottom is led so, and where it would be in the surface beside its middle, as in hollows.
    pub(crate) fn seat(
        &self,
        p: &DrivePoint,
        direction: Vec3,
        start: Option<[f64; 2]>,
    ) -> Option<Met> {
        let AxisArea::Angle { part: true, alpha, beta } = self.axis else { return None };
        let [wide, bottom] = self.profile.joints()[0];
        let flat = wide > 0.0 && bottom.abs() <= 1e-12 * self.profile.reach();
        if !self.leads() || !flat || alpha.abs().max(beta.abs()) > SQUARE {
            return None;
        }
        // The place of the drive comes to stand over the contact by the offset that the tip has.
        let probe = Probe::Ball(self.drive.offset);
        let shot = Shot { from: p.point, probe, ..self.shot(p, direction, Vec3::zeros()) };
        let met = start.and_then(|s| shot.near(s)).or_else(|| shot.first(&self.part.tree))?;
        let Band { intol, outtol } = self.band;
        let thick = self.thick();
        let tool =
            Tool { profile: self.profile, te: met.at.point + met.normal * thick, ta: met.normal };
        let least = thick - CLOSE * (intol + outtol);
        let clear = self.part.tree.clear(&tool, -least) == Clear::Yes;
        // The tool end is told by the way along the line.
        clear.then_some(met)
    }
}
