//! The cutter as the motion sees it: its greatest radius and its lowest point in a direction.

use aptc_geometry::{Cutter, Vec3, trig};

/// A solid of revolution about the tool axis, tool end at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shape {
    /// The cutter itself.
    Mill(Cutter),
    /// CUTTER/OPTION: a disk.
    Disk { radius: f64, height: f64 },
    /// No cutter was given: the tool end.
    Point,
}

impl Shape {
    /// The shape that touches a surface: the disk if there is one, else the cutter.
    pub(crate) fn of(cutter: Option<Cutter>, disk: Option<(f64, f64)>) -> Self {
        match (disk, cutter) {
            (Some((radius, height)), _) => Self::Disk { radius, height },
            (None, Some(c)) => Self::Mill(c),
            (None, None) => Self::Point,
        }
    }

    /// Greatest distance of the shape from its axis: where it touches a wall along the axis.
    pub(crate) fn radius(&self) -> f64 {
        match self {
            Self::Mill(c) => profile(c).iter().fold(0.0, |m, p| p.0.max(m)),
            Self::Disk { radius, .. } => *radius,
            Self::Point => 0.0,
        }
    }

    /// Least of `n . q` over the points q of the shape, for the unit tool axis `ta`.
    pub(crate) fn lowest(&self, n: Vec3, ta: Vec3) -> f64 {
        let up = n.dot(&ta);
        let out = (n - ta * up).norm();
        match self {
            Self::Mill(c) => profile(c)
                .iter()
                .map(|p| up * p.1 - out * p.0)
                .chain(arc(c, out, up))
                .fold(f64::INFINITY, f64::min),
            Self::Disk { radius, height } => up * height - out * radius,
            Self::Point => 0.0,
        }
    }
}

/// Corners of the profile: radius and height.
fn profile(c: &Cutter) -> Vec<(f64, f64)> {
    let (sa, ca) = trig::sin_cos(c.alpha_deg.to_radians());
    let (sb, cb) = trig::sin_cos(c.beta_deg.to_radians());
    let r = c.corner_radius;
    let low = (c.e + r * sa, c.f - r * ca);
    let high = (c.e + r * cb, c.f - r * sb);
    let mut p = vec![(0.0, 0.0), low];
    if c.height > high.1 {
        p.push(high);
        p.push((high.0 + (c.height - high.1) * sb / cb, c.height));
    } else {
        // The top cuts the corner.
        let up = (c.height - c.f).clamp(-r, r);
        p.push((c.e + ((r - up) * (r + up)).sqrt(), c.height));
    }
    p.retain(|p| p.0 >= 0.0);
    p
}

/// The value at the corner arc when its point in that direction lies between the two lines.
fn arc(c: &Cutter, out: f64, up: f64) -> Option<f64> {
    let turn = trig::atan2(out, up).to_degrees();
    (turn >= c.alpha_deg && turn <= 90.0 - c.beta_deg)
        .then(|| up * c.f - out * c.e - c.corner_radius * trig::hypot(out, up))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_support_point_of_a_bull_nose_on_a_slope() {
        // d 20, corner radius 3, plane normal (.6, 0, .8): touches at (-8.8, 0, .6).
        let s = Shape::Mill(Cutter::mill(20.0, 3.0, 50.0));
        let n = Vec3::new(0.6, 0.0, 0.8);
        let q = n.dot(&Vec3::new(-8.8, 0.0, 0.6));
        assert!((s.lowest(n, Vec3::z()) - q).abs() < 1e-12);
        assert!((s.radius() - 10.0).abs() < 1e-12);
    }

    #[test]
    fn a_flat_end_touches_with_its_rim() {
        let s = Shape::Mill(Cutter::mill(2.0, 0.0, 5.0));
        let n = Vec3::new(0.6, 0.0, 0.8);
        assert!((s.lowest(n, Vec3::z()) + 0.6).abs() < 1e-12);
    }
}
