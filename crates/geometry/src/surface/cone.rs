//! One nappe of a cone, its vertex included.

use crate::roots::quadratic;
use crate::surface::{EPS_LEN, Foot, Shape, frame_about};
use crate::{Cone, Place, Reason, Vec3};

/// Height along the axis, distance from it, and the unit direction away from it.
struct Meridian {
    t: f64,
    rho: f64,
    away: Vec3,
}

/// For a point given by height above the vertex `t` and distance from the axis `rho`: its place along the
/// generator, negative where the vertex is the nearest point, and its distance outside the generator.
#[inline]
pub fn vertex_side(t: f64, rho: f64, cos: f64, sin: f64) -> (f64, f64) {
    (t * cos + rho * sin, rho * cos - t * sin)
}

impl Cone {
    /// Sine of the half angle.
    #[inline]
    pub fn sin_half(&self) -> f64 {
        ((1.0 - self.cos_half) * (1.0 + self.cos_half)).max(0.0).sqrt()
    }

    fn meridian(&self, p: Vec3) -> Meridian {
        let w = p - self.vertex;
        let t = w.dot(&self.axis);
        let radial = w - self.axis * t;
        let rho = radial.norm();
        let away = if rho > 0.0 { radial / rho } else { frame_about(self.axis)[0] };
        Meridian { t, rho, away }
    }

    /// Directed distances along the unit direction `d` to the nappe.
    ///
    /// APT: `DDCON`. Intersections with the other nappe, which squaring brings in, are dropped.
    pub fn ray(&self, p: Vec3, d: Vec3) -> Result<Vec<f64>, Reason> {
        let w = p - self.vertex;
        let (dt, wt) = (d.dot(&self.axis), w.dot(&self.axis));
        let k2 = self.cos_half * self.cos_half;
        let size = w.norm();
        // Along a generator all three vanish but for rounding.
        let clean = |x: f64, size: f64| if x.abs() <= 1e-15 * size { 0.0 } else { x };
        let a = clean(dt * dt - k2, 1.0);
        let b = clean(dt * wt - k2 * d.dot(&w), size);
        // (w.T)^2 - k^2 w.w as a product: free of cancellation near the surface.
        let c = (wt - self.cos_half * size) * (wt + self.cos_half * size);
        let c = clean(c, size * size);
        let roots = quadratic(a, b, c, size.max(f64::MIN_POSITIVE))?;
        let near = |l: &f64| wt + l * dt >= -EPS_LEN * size;
        let kept: Vec<f64> = roots.roots().iter().copied().filter(near).collect();
        if kept.is_empty() { Err(Reason::NoHit) } else { Ok(kept) }
    }

    /// Outward unit normal of the cone parallel to this one through `p`.
    ///
    /// APT: `UNCON`. Where the vertex is nearest there is none, nor on the axis.
    pub fn normal(&self, p: Vec3) -> Result<Vec3, Reason> {
        let m = self.meridian(p);
        let sin = self.sin_half();
        let size = (p - self.vertex).norm();
        let (along, _) = vertex_side(m.t, m.rho, self.cos_half, sin);
        if along <= EPS_LEN * size {
            Err(Reason::Degenerate(Place::Vertex))
        } else if m.rho <= EPS_LEN * size {
            Err(Reason::Degenerate(Place::Axis))
        } else {
            Ok(m.away * self.cos_half - self.axis * sin)
        }
    }

    /// The nearest point; behind the vertex the vertex itself, with the normal towards `p`.
    #[inline]
    pub fn foot(&self, p: Vec3) -> Foot {
        let m = self.meridian(p);
        let (cos, sin) = (self.cos_half, self.sin_half());
        let (along, distance) = vertex_side(m.t, m.rho, cos, sin);
        if along <= 0.0 {
            let w = p - self.vertex;
            let away = w.norm();
            let normal = if away > 0.0 { w / away } else { -self.axis };
            return Foot {
                point: self.vertex,
                normal,
                distance: away,
                shape: Shape::round(normal, f64::INFINITY),
                at: None,
            };
        }
        let normal = m.away * cos - self.axis * sin;
        let shape = self.shape(m.away, along);
        Foot { point: p - normal * distance, normal, distance, shape, at: None }
    }

    /// Curvature at the point `q` of the surface with outward unit normal `n` there.
    pub fn shape_at(&self, q: Vec3, n: Vec3) -> Shape {
        let m = self.meridian(q);
        let (along, _) = vertex_side(m.t, m.rho, self.cos_half, self.sin_half());
        if along <= EPS_LEN * m.rho {
            return Shape::round(n, f64::INFINITY);
        }
        self.shape(m.away, along)
    }

    /// Curvature on the generator in the direction `away` from the axis, at `along` from the vertex.
    #[inline]
    pub fn shape(&self, away: Vec3, along: f64) -> Shape {
        let (cos, sin) = (self.cos_half, self.sin_half());
        let generator = self.axis * cos + away * sin;
        let around = self.axis.cross(&away);
        Shape { frame: [around, generator], k: [cos / (along * sin), 0.0, 0.0] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{Fiop, Surface};
    use crate::trig;

    fn cone(half_deg: f64) -> Cone {
        Cone { vertex: Vec3::zeros(), axis: Vec3::z(), cos_half: trig::cos_deg(half_deg) }
    }

    #[test]
    fn published_distances() {
        let s = Surface::Cone(cone(45.0));
        let up = s.ray(Vec3::new(1.0, 0.0, -3.0), Vec3::z()).unwrap();
        assert_eq!(up.len(), 1);
        assert!((up[0] - 4.0).abs() < 1e-14);
        let side = s.ray(Vec3::new(3.0, 0.0, 5.0), Vec3::x()).unwrap();
        assert!((side[0] + 8.0).abs() < 1e-14 && (side[1] - 2.0).abs() < 1e-14);
        let along = Vec3::new(1.0, 0.0, 1.0).normalize();
        assert_eq!(s.ray(-Vec3::z(), along), Err(Reason::NoHit));
        let hit = s.directed_distance(Vec3::new(1.0, 0.0, -3.0), Vec3::z(), Fiop::Ahead).unwrap();
        assert!((hit.distance - 4.0).abs() < 1e-14);
    }

    #[test]
    fn published_normals() {
        let c = cone(30.0);
        let n = Vec3::new(0.75_f64.sqrt(), 0.0, -0.5);
        for p in [Vec3::new(1.0, 0.0, 3.0_f64.sqrt()), Vec3::new(2.0, 0.0, -1.0)] {
            assert!((c.normal(p).unwrap() - n).norm() < 1e-15);
        }
        let vertex = c.normal(Vec3::new(1.0, 0.0, -1.0));
        // The foot of (1, 0, -1) lies at -.366 along the generator: the vertex is nearest.
        assert_eq!(vertex, Err(Reason::Degenerate(Place::Vertex)));
        assert_eq!(c.normal(Vec3::new(0.0, 0.0, 2.0)), Err(Reason::Degenerate(Place::Axis)));
    }

    #[test]
    fn vertex_is_a_foot() {
        let f = cone(30.0).foot(Vec3::new(1.0, 0.0, -1.0));
        assert_eq!(f.point, Vec3::zeros());
        assert!((f.distance - 2.0_f64.sqrt()).abs() < 1e-15);
    }
}
