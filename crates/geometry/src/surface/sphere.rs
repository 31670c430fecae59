//! Sphere.

use crate::roots::quadratic;
use crate::surface::{EPS_LEN, Foot, Shape};
use crate::{Place, Reason, Sphere, Vec3};

impl Sphere {
    /// Directed distances along the unit direction `d`.
    ///
    /// APT: `DDSPHR`.
    pub fn ray(&self, p: Vec3, d: Vec3) -> Result<Vec<f64>, Reason> {
        let w = p - self.center;
        let away = w.norm();
        // From a far point c would lose its digits as a difference of squares.
        let c = (away - self.radius) * (away + self.radius);
        quadratic(1.0, w.dot(&d), c, away + self.radius).map(|q| q.roots().to_vec())
    }

    /// Outward unit normal of the sphere through `p` about the same centre.
    ///
    /// APT: `UNSPHR`.
    pub fn normal(&self, p: Vec3) -> Result<Vec3, Reason> {
        let w = p - self.center;
        let away = w.norm();
        if away <= EPS_LEN * self.radius {
            return Err(Reason::Degenerate(Place::Center));
        }
        Ok(w / away)
    }

    /// The nearest point; from the centre the one in the z direction.
    #[inline]
    pub fn foot(&self, p: Vec3) -> Foot {
        let w = p - self.center;
        let away = w.norm();
        let normal = if away > 0.0 { w / away } else { Vec3::z() };
        Foot {
            point: self.center + normal * self.radius,
            normal,
            distance: away - self.radius,
            shape: Shape::round(normal, 1.0 / self.radius),
            at: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{Fiop, Surface};

    #[test]
    fn published_distances_and_normals() {
        let s = Surface::Sphere(Sphere { center: Vec3::zeros(), radius: 5.0 });
        let ray = |x, y| s.ray(Vec3::new(x, y, 0.0), Vec3::x());
        assert_eq!(ray(-13.0, 0.0), Ok(vec![8.0, 18.0]));
        let left = ray(10.0, 3.0).unwrap();
        assert!((left[0] + 14.0).abs() < 1e-14 && (left[1] + 6.0).abs() < 1e-14);
        assert_eq!(ray(0.0, 5.0), Ok(vec![0.0]));
        assert_eq!(ray(0.0, 5.0001), Err(Reason::NoHit));
        let at = |f| s.directed_distance(Vec3::new(10.0, 3.0, 0.0), Vec3::x(), f);
        assert!((at(Fiop::Nearest).unwrap().distance + 6.0).abs() < 1e-14);
        assert_eq!(at(Fiop::Ahead), Err(Reason::NoHit));
        assert!((at(Fiop::AheadFirst).unwrap().distance + 6.0).abs() < 1e-14);
        let n = s.normal(Vec3::new(0.0, 3.0, 4.0)).unwrap();
        assert!((n - Vec3::new(0.0, 0.6, 0.8)).norm() < 1e-15);
        assert_eq!(s.normal(Vec3::zeros()), Err(Reason::Degenerate(Place::Center)));
    }
}
