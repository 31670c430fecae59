//! Routines about the direction in which a surface is looked for: those of chapter D that survive.

use crate::surface::{Fiop, Hit, Surface, frame_about, unit};
use crate::{Place, Reason, Vec3, trig};

/// What [`ajundo`] found.
#[derive(Clone, Copy, Debug)]
pub struct Aimed {
    /// Where the surface was met.
    pub hit: Hit,
    /// Its normal there, turned as asked.
    pub normal: Vec3,
    /// Was the normal turned against the surface's own?
    pub turned: bool,
    /// The direction that was used: the given one, or the first of [`radar`] that hits.
    pub direction: Vec3,
}

/// The `k`-th of the fourteen directions about the unit vector `t`, k from 1: eight at 30 degrees to it,
/// four at 60, two at 90.
///
/// APT: `RADAR`. Used only where a user's direction misses the surface at start-up; nearest points need no
/// direction, so nothing else does. The two vectors that span the plane across `t` are arbitrary.
pub fn radar(k: usize, t: Vec3) -> Option<Vec3> {
    let [a, b] = frame_about(t);
    let (from, step, lean) = match k {
        1..=8 => (1, 45.0, 30.0),
        9..=12 => (9, 90.0, 60.0),
        13..=14 => (13, 90.0, 90.0),
        _ => return None,
    };
    let turn = step * f64::from(u32::try_from(k - from).ok()?);
    let across = a * trig::cos_deg(turn) + b * trig::sin_deg(turn);
    Some(t * trig::cos_deg(lean) + across * trig::sin_deg(lean))
}

/// The normal turned against the direction `d`, or along it when `along` is set, and whether it was turned.
/// A normal square to `d` stays as it is.
///
/// APT: `CONTROL` (`along` is FCON = 1).
pub fn control(normal: Vec3, d: Vec3, along: bool) -> (Vec3, bool) {
    let s = normal.dot(&d);
    let turned = if along { s < 0.0 } else { s > 0.0 };
    (if turned { -normal } else { normal }, turned)
}

/// The surface met along `d` from `p`, or along the first direction of [`radar`] that meets it, with the
/// normal turned by [`control`] against (or along) the direction used.
///
/// APT: `AJUNDO`.
pub fn ajundo(
    surface: &Surface,
    p: Vec3,
    d: Vec3,
    fiop: Fiop,
    along: bool,
) -> Result<Aimed, Reason> {
    let d = unit(d)?;
    let mut first = None;
    for k in 0..=14 {
        let direction = if k == 0 { Some(d) } else { radar(k, d) };
        let Some(direction) = direction else { break };
        match surface.directed_distance(p, direction, fiop) {
            Ok(hit) => {
                let (normal, turned) = control(surface.normal(hit.point)?, direction, along);
                return Ok(Aimed { hit, normal, turned, direction });
            }
            Err(reason) => first = first.or(Some(reason)),
        }
    }
    Err(first.unwrap_or(Reason::NoHit))
}

/// Signed curvature of the circle through `p2`, tangent there to the plane with unit normal `normal`, and
/// through `p1`: positive when the centre lies behind `p2` seen along the normal, 0 for a plane.
///
/// APT: `CCURV`, which returns the radius `S = 1 / curvature` and has the centre at `p2 - S normal`.
/// Points nearer to each other than 1e-4 of the radius lose digits: use [`Surface::foot`]'s shape there.
pub fn ccurv(p1: Vec3, p2: Vec3, normal: Vec3) -> Result<f64, Reason> {
    let w = p2 - p1;
    let s = w.norm_squared();
    if s > 0.0 { Ok(2.0 * normal.dot(&w) / s) } else { Err(Reason::Degenerate(Place::Coincident)) }
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "some closed forms are met to the last bit")]
mod tests {
    use super::*;
    use crate::{Plane, Sphere};

    #[test]
    fn fourteen_directions() {
        let t = Vec3::new(0.3, -0.5, 0.7).normalize();
        for k in 1..=14 {
            let d = radar(k, t).unwrap();
            assert!((d.norm() - 1.0).abs() < 1e-15);
            let lean = if k <= 8 {
                0.75_f64.sqrt()
            } else if k <= 12 {
                0.5
            } else {
                0.0
            };
            assert!((d.dot(&t) - lean).abs() < 1e-15, "{k}");
        }
        assert!(radar(13, t).unwrap().dot(&radar(14, t).unwrap()).abs() < 1e-15);
        assert!(radar(15, t).is_none());
    }

    #[test]
    fn sphere_from_outside_and_plane_beside_the_ray() {
        let s = Surface::Sphere(Sphere { center: Vec3::zeros(), radius: 2.0 });
        let p = Vec3::new(5.0, 0.0, 0.0);
        let near = ajundo(&s, p, -Vec3::x(), Fiop::Nearest, false).unwrap();
        assert_eq!((near.hit.distance, near.normal, near.turned), (3.0, Vec3::x(), false));
        let far = ajundo(&s, p, -Vec3::x(), Fiop::Nearest, true).unwrap();
        assert_eq!((far.normal, far.turned), (-Vec3::x(), true));
        let plane = Surface::Plane(Plane::new(Vec3::z(), 0.0).unwrap());
        let probe = ajundo(&plane, Vec3::z(), Vec3::x(), Fiop::Ahead, false).unwrap();
        assert!(probe.hit.distance > 0.0 && probe.hit.point.z.abs() < 1e-15);
        assert!((probe.direction.x - 0.75_f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn curvature_from_two_points() {
        let o = Vec3::zeros();
        let k = |z| ccurv(Vec3::new(3.0, 0.0, z), o, Vec3::z()).unwrap();
        assert!((1.0 / k(-1.0) - 5.0).abs() < 1e-15);
        assert!((1.0 / k(1.0) + 5.0).abs() < 1e-15);
        assert_eq!(k(0.0), 0.0);
        assert!(ccurv(o, o, Vec3::z()).is_err());
    }
}
