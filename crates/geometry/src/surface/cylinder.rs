//! Cylinder without ends; CIRCLE as a control surface.

use crate::roots::quadratic;
use crate::surface::{EPS_ANG, EPS_LEN, Foot, Shape, frame_about};
use crate::{Cylinder, Place, Reason, Vec3};

impl Cylinder {
    /// Part of `p` minus the axis point that is perpendicular to the axis.
    #[inline]
    pub fn radial(&self, p: Vec3) -> Vec3 {
        let w = p - self.point;
        w - self.axis * w.dot(&self.axis)
    }

    /// Directed distances along the unit direction `d`.
    ///
    /// APT: `DDCYLN`. Along the axis there is `NoHit`, or `AllHit` from a point of the surface.
    pub fn ray(&self, p: Vec3, d: Vec3) -> Result<Vec<f64>, Reason> {
        let across = d - self.axis * d.dot(&self.axis);
        let w = self.radial(p);
        let away = w.norm();
        if across.norm() <= EPS_ANG {
            let off = (away - self.radius).abs();
            return Err(if off <= EPS_LEN * (p - self.point).norm().max(self.radius) {
                Reason::AllHit
            } else {
                Reason::NoHit
            });
        }
        let c = (away - self.radius) * (away + self.radius);
        let scale = away + self.radius;
        quadratic(across.norm_squared(), across.dot(&w), c, scale).map(|q| q.roots().to_vec())
    }

    /// Outward unit normal of the cylinder through `p` about the same axis.
    ///
    /// APT: `UNCYLN`.
    pub fn normal(&self, p: Vec3) -> Result<Vec3, Reason> {
        let w = self.radial(p);
        let away = w.norm();
        if away <= EPS_LEN * self.radius {
            return Err(Reason::Degenerate(Place::Axis));
        }
        Ok(w / away)
    }

    /// The nearest point; from the axis one of them.
    #[inline]
    pub fn foot(&self, p: Vec3) -> Foot {
        let w = self.radial(p);
        let away = w.norm();
        let normal = if away > 0.0 { w / away } else { frame_about(self.axis)[0] };
        let distance = away - self.radius;
        let shape = self.shape(normal);
        Foot { point: p - normal * distance, normal, distance, shape, at: None }
    }

    /// Curvature where the normal is `n`.
    #[inline]
    pub fn shape(&self, n: Vec3) -> Shape {
        Shape { frame: [self.axis.cross(&n), self.axis], k: [1.0 / self.radius, 0.0, 0.0] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_distances_and_normals() {
        let c = Cylinder { point: Vec3::zeros(), axis: Vec3::z(), radius: 2.0 };
        assert_eq!(c.ray(Vec3::new(5.0, 0.0, 1.0), -Vec3::x()), Ok(vec![3.0, 7.0]));
        let slant = Vec3::new(-1.0, 0.0, 1.0).normalize();
        let r = c.ray(Vec3::new(4.0, 0.0, 0.0), slant).unwrap();
        assert!((r[0] - 2.0 * 2.0_f64.sqrt()).abs() < 1e-14);
        assert!((r[1] - 6.0 * 2.0_f64.sqrt()).abs() < 1e-14);
        assert_eq!(c.ray(Vec3::x(), Vec3::z()), Err(Reason::NoHit));
        assert_eq!(c.ray(2.0 * Vec3::x(), Vec3::z()), Err(Reason::AllHit));
        let c = Cylinder { point: Vec3::new(1.0, 2.0, 0.0), axis: Vec3::z(), radius: 2.0 };
        let n = c.normal(Vec3::new(4.0, 6.0, 9.0)).unwrap();
        assert!((n - Vec3::new(0.6, 0.8, 0.0)).norm() < 1e-15);
        assert_eq!(c.normal(Vec3::new(1.0, 2.0, 5.0)), Err(Reason::Degenerate(Place::Axis)));
    }
}
