//! Plane, and LINE as the vertical plane that it is.

use crate::surface::{EPS_ANG, EPS_LEN, Foot, Shape};
use crate::{Plane, Reason, Vec3};

impl Plane {
    /// Directed distance along the unit direction `d`.
    ///
    /// APT: `DDPLAN`. A direction in the plane is `Parallel`, or `AllHit` from a point of the plane.
    pub fn ray(&self, p: Vec3, d: Vec3) -> Result<Vec<f64>, Reason> {
        let (away, slope) = (self.distance(p), self.n.dot(&d));
        if slope.abs() > EPS_ANG {
            Ok(vec![-away / slope])
        } else if away.abs() <= EPS_LEN * (p.norm() + self.d.abs()) {
            Err(Reason::AllHit)
        } else {
            Err(Reason::Parallel)
        }
    }

    /// The nearest point.
    #[inline]
    pub fn foot(&self, p: Vec3) -> Foot {
        let distance = self.distance(p);
        let shape = Shape::flat(self.n);
        Foot { point: p - self.n * distance, normal: self.n, distance, shape, at: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{Fiop, Surface};

    #[test]
    fn published_distances() {
        let s = Surface::Plane(Plane::new(Vec3::new(1.0, 1.0, 1.0), 3.0).unwrap());
        let o = Vec3::zeros();
        assert!((s.ray(o, Vec3::x()).unwrap()[0] - 3.0).abs() < 1e-15);
        let along = Vec3::new(1.0, -1.0, 0.0).normalize();
        assert_eq!(s.ray(o, along), Err(Reason::Parallel));
        let on = Vec3::new(1.0, 1.0, 1.0);
        assert_eq!(s.ray(on, along), Err(Reason::AllHit));
        assert_eq!(s.directed_distance(on, along, Fiop::Nearest).map(|h| h.distance), Ok(0.0));
        let behind = s.directed_distance(Vec3::new(5.0, 0.0, 0.0), Vec3::x(), Fiop::Ahead);
        assert_eq!(behind, Err(Reason::NoHit));
        let hit = s.directed_distance(Vec3::new(5.0, 0.0, 0.0), Vec3::x(), Fiop::AheadFirst);
        assert!((hit.unwrap().distance + 2.0).abs() < 1e-14);
        assert!(s.ray(o, o).is_err());
    }
}
