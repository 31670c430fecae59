//! The seven-parameter cutter.

use serde::{Deserialize, Serialize};

use crate::trig;

/// A corner that reaches beyond the axis, or misses a line that it touches, by less than this fraction of the cutter's size does so
/// in digits: CAM systems write five or six of them, and a half of an inch in millimetres is none of these. Larger would hide real
/// edges.
pub(crate) const TANGENT: f64 = 1e-5;

/// CUTTER/d,r,e,f,alpha,beta,h: a solid of revolution about the tool axis, tool end at the origin of its
/// frame. All lengths in the unit of the scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cutter {
    /// Diameter, where the upper and the lower line meet.
    pub diameter: f64,
    /// Corner radius.
    pub corner_radius: f64,
    /// Distance of the corner circle's centre from the axis.
    pub e: f64,
    /// Height of the corner circle's centre above the tool end.
    pub f: f64,
    /// Angle of the lower line above the horizontal, degrees.
    pub alpha_deg: f64,
    /// Angle of the upper line from the axis, degrees.
    pub beta_deg: f64,
    /// Height.
    pub height: f64,
}

impl Cutter {
    /// The cutter of `CUTTER/d[,r]`, of the usual height. `CUTTER/0` is a point: nothing but its end can touch.
    pub fn by_two(diameter: f64, corner_radius: f64, usual_height: f64) -> Self {
        Self::mill(diameter, corner_radius, if diameter > 0.0 { usual_height } else { 0.0 })
    }

    /// An end mill: e = d/2 - r, f = r, straight sides, `height` or at least r. A corner radius that is half the diameter but for
    /// digits makes a ball.
    pub fn mill(diameter: f64, corner_radius: f64, height: f64) -> Self {
        let e = diameter / 2.0 - corner_radius;
        let ball = e < 0.0 && -e <= TANGENT * diameter;
        Self {
            diameter,
            corner_radius,
            e: if ball { 0.0 } else { e },
            f: corner_radius,
            alpha_deg: 0.0,
            beta_deg: 0.0,
            height: height.max(corner_radius),
        }
    }

    /// Centre e, f of a corner of its radius that touches both lines; `None` of lines that do not meet so.
    ///
    /// On the lower line n.x = 0 with n = (sin alpha, -cos alpha), on the upper one n.(x - m) = 0 with n = (cos beta, -sin beta),
    /// m being where they meet, d/2 from the axis; the centre is inside of both by the radius.
    pub fn tangent_corner(&self) -> Option<[f64; 2]> {
        let [d, r, _, _, alpha, beta, _] = self.values();
        let (sa, ca) = (trig::sin_deg(alpha), trig::cos_deg(alpha));
        let (sb, cb) = (trig::sin_deg(beta), trig::cos_deg(beta));
        let (low, up) = (-r, cb * d / 2.0 - sb * d / 2.0 * sa / ca - r);
        let det = ca * cb - sa * sb;
        let centre = [ca * up - sb * low, sa * up - cb * low].map(|x| x / det);
        (det > 0.0 && ca > 0.0 && centre.iter().all(|x| x.is_finite())).then_some(centre)
    }

    /// The seven numbers in APT's order.
    pub fn values(&self) -> [f64; 7] {
        let Self { diameter, corner_radius, e, f, alpha_deg, beta_deg, height } = *self;
        [diameter, corner_radius, e, f, alpha_deg, beta_deg, height]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_corner_that_touches_both_lines() {
        let corner = |d: f64, r: f64, alpha_deg: f64, beta_deg: f64| {
            let height = 50.0;
            let c = Cutter {
                diameter: d,
                corner_radius: r,
                e: 0.0,
                f: 0.0,
                alpha_deg,
                beta_deg,
                height,
            };
            c.tangent_corner().expect("lines that meet")
        };
        let near = |a: [f64; 2], b: [f64; 2]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6);
        assert!(near(corner(20.0, 2.0, 0.0, 0.0), [8.0, 2.0]));
        // Published.
        assert!(near(corner(20.0, 2.0, 10.0, 15.0), [8.397_920, 3.511_633]));
        // A point drill: without a radius the corner is where the lines meet.
        assert!(near(corner(20.0, 0.0, 30.0, 0.0), [10.0, 10.0 / 3.0_f64.sqrt()]));
        let flat = Cutter { alpha_deg: 60.0, beta_deg: 30.0, ..Cutter::mill(10.0, 0.0, 30.0) };
        assert_eq!(flat.tangent_corner(), None);
    }

    #[test]
    fn a_corner_radius_of_half_the_diameter_but_for_digits_is_a_ball() {
        for (r, e) in [(5.0, 0.0), (5.000_05, 0.0), (5.0 + 5e-13, 0.0), (5.001, -0.001), (4.0, 1.0)]
        {
            assert!((Cutter::mill(10.0, r, 40.0).e - e).abs() < 1e-12, "{r}");
        }
    }

    #[test]
    fn a_mill_without_diameter_is_a_point() {
        assert!(Cutter::by_two(0.0, 0.0, 127.0).values().iter().all(|x| *x == 0.0));
    }
}
