//! How wide a strip a cutter clears down to a height, whatever its form: as far as it reaches across the path there.

use aptc_contact::{Convex, Swept, Tool};
use aptc_geometry::{Profile, Vec3, trig};

use crate::position::Position;

/// Halvings of the strip.
const HALVINGS: u32 = 30;
/// Below this share of its size a surface is flat.
const FLAT: f64 = 1e-9;

/// A cutter on its way over a place of the surface that it touches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pass<'a> {
    pub(crate) profile: &'a Profile,
    pub(crate) at: &'a Position,
    /// Unit direction of the path, and of the step across along the surface.
    pub(crate) along: Vec3,
    pub(crate) side: Vec3,
    /// Curvature of the surface across the path, positive hollow.
    pub(crate) curvature: f64,
}

impl Pass<'_> {
    /// Width of the strip over which nothing stands higher than `high` over the surface; two passes as far apart leave that.
    ///
    /// A place is cleared when the cutter comes over it somewhere on the straight way through this one: what it clears is
    /// convex, so that all between is cleared too. A corner that leads with its edge leaves a saw's tooth, `h / sin cos` wide,
    /// where the formula of a round one has no radius.
    pub(crate) fn strip(&self, high: f64) -> f64 {
        let widest = self.profile.widest();
        let way = self.along * widest;
        let tool = Tool { profile: self.profile, te: self.at.te - way, ta: self.at.ta };
        let swept = Swept { tool, by: way * 2.0 };
        let clears = |s: f64| swept.near(self.over(s, high)).0 <= 0.0;
        if !clears(0.0) {
            return 0.0;
        }
        let reach = |sense: f64| {
            let (mut near, mut far) = (0.0, 2.0 * widest);
            if clears(sense * far) {
                return far;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (near + far);
                if clears(sense * middle) { near = middle } else { far = middle }
            }
            near
        };
        (reach(1.0) + reach(-1.0)).min(2.0 * widest)
    }

    /// The place that height over the surface, so far across from where it is touched along its circle of curvature.
    fn over(&self, s: f64, high: f64) -> Vec3 {
        let (contact, n, k) = (self.at.contact, self.at.normal, self.curvature);
        if k.abs() * self.profile.reach() < FLAT {
            return contact + self.side * s + n * high;
        }
        let (sin, cos) = trig::sin_cos(s * k);
        contact + n / k + (self.side * sin - n * cos) * (1.0 / k - high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stepover::scallop_width;
    use aptc_geometry::{Cutter, Segment, Transform};

    fn strip(cutter: &Cutter, lean: f64, curvature: f64, high: f64) -> f64 {
        let profile = Profile::new(cutter).unwrap();
        let ta = Transform::rotation(Vec3::x(), lean).vector(Vec3::z());
        let support = Tool { profile: &profile, te: Vec3::zeros(), ta }.support(-Vec3::z());
        let at = Position {
            te: -support.point,
            ta,
            part_uv: [0.0; 2],
            contact: Vec3::zeros(),
            normal: Vec3::z(),
            shift: 0.0,
            drive_uv: [0.0; 2],
            segment: Segment::Arc,
            lift: Vec3::zeros(),
        };
        let (along, side) = (Vec3::x(), Vec3::y());
        Pass { profile: &profile, at: &at, along, side, curvature }.strip(high)
    }

    #[test]
    fn a_ball_clears_what_the_formula_says() {
        for (lean, k) in [(0.0, 0.0), (20.0, 0.02), (-10.0, -0.04)] {
            let width = strip(&Cutter::mill(10.0, 5.0, 30.0), lean, k, 0.05);
            assert!((width - scallop_width(5.0, 0.05, k)).abs() < 1e-5, "{lean} {k} {width}");
        }
    }

    #[test]
    fn an_edge_leaves_the_tooth_of_a_saw() {
        let (h, lean) = (0.1, 8.0);
        let (s, c) = (trig::sin_deg(lean), trig::cos_deg(lean));
        for lean in [lean, -lean] {
            let width = strip(&Cutter::mill(10.0, 0.0, 30.0), lean, 0.0, h);
            assert!((width - h / (s * c)).abs() < 1e-5, "{width}");
        }
        // Not wider than the cutter.
        let width = strip(&Cutter::mill(10.0, 0.0, 30.0), 0.05, 0.0, h);
        assert!(width <= 10.0 && width > 9.99, "{width}");
    }
}
