//! The seven-parameter cutter.

use serde::{Deserialize, Serialize};

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
    /// The cutter of `CUTTER/d[,r]`: e = d/2 - r, f = r, straight sides, `height` or at least r.
    pub fn mill(diameter: f64, corner_radius: f64, height: f64) -> Self {
        Self {
            diameter,
            corner_radius,
            e: diameter / 2.0 - corner_radius,
            f: corner_radius,
            alpha_deg: 0.0,
            beta_deg: 0.0,
            height: height.max(corner_radius),
        }
    }

    /// The seven numbers in APT's order.
    pub fn values(&self) -> [f64; 7] {
        let Self { diameter, corner_radius, e, f, alpha_deg, beta_deg, height } = *self;
        [diameter, corner_radius, e, f, alpha_deg, beta_deg, height]
    }
}
