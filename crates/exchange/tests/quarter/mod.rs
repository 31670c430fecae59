//! A quarter of a cylinder, which each format can say.

use aptc_exchange::{Fault, Limits, Outside, read};
use aptc_geometry::sculpt::{Sculptured, fit_surface};

pub(crate) fn all(text: &str) -> Result<Outside, Fault> {
    read(text, &Limits::default()).expect("the format is seen")
}

pub(crate) fn fitted(file: &Outside) -> Sculptured {
    fit_surface(&file.surfaces[0]).expect("a surface")
}

/// A quarter of a cylinder of radius 5 about z, 8 long, as `u` along the arc and `v` along z.
pub(crate) fn is_quarter(s: &Sculptured, radius: f64, length: f64) {
    for k in 0..=8 {
        let (u, v) = (f64::from(k) / 8.0, f64::from(8 - k) / 8.0);
        let p = s.at(u, v).point;
        assert!((p.xy().norm() - radius).abs() < 1e-12, "{p}");
        assert!((p.z - v * length).abs() < 1e-12, "{p}");
    }
}

/// Half the root of two, the weight of its middle points.
pub(crate) const W: &str = "0.70710678118654752440";
