//! Convex solids bounded by the simple surfaces, known by their support function.
//!
//! Plane, sphere, cylinder and cone bound a convex solid C (half space, ball, cylinder, one nappe). The
//! signed distance of a point, positive outside, is `sd(p) = max over unit m of m . p - h(m)` with the support
//! function h of C, so **every unit m proves a lower bound** of it: the bounds of this crate rest on that
//! alone and need no solver.

use aptc_geometry::{Form, Plane, Vec3};

/// A convex solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Solid {
    /// `n . p <= d`.
    Half(Plane),
    /// Centre, radius.
    Ball(Vec3, f64),
    /// Point of the axis, unit axis, radius.
    Rod(Vec3, Vec3, f64),
    /// Vertex, unit axis into the cone, cosine and sine of the half angle.
    Nappe(Vec3, Vec3, f64, f64),
}

/// What has a support function.
pub(crate) trait Supported {
    /// Greatest `m . p` over the solid; infinite where it has no end.
    fn support(&self, m: Vec3) -> f64;

    /// The direction near `m` in which the solid is bounded, unit.
    fn bounded_direction(&self, m: Vec3) -> Vec3;

    /// The direction near the unit vector `m` that is a normal of the solid and square to `v`; one that is not where there
    /// is none.
    fn square_direction(&self, m: Vec3, v: Vec3) -> Vec3 {
        self.bounded_direction(without(m, v))
    }
}

impl Solid {
    /// The solid that a form bounds; `None` for forms that bound no simple convex solid.
    pub(crate) fn new(form: &Form) -> Option<Self> {
        Some(match form.shape() {
            Form::Plane(p) => Self::Half(*p),
            Form::Line(l) => Self::Half(l.plane()),
            Form::Sphere(s) => Self::Ball(s.center, s.radius),
            Form::Circle(c) => Self::Rod(c.center, c.axis, c.radius),
            Form::Cylinder(c) => Self::Rod(c.point, c.axis, c.radius),
            Form::Cone(c) => {
                let sin = (1.0 - c.cos_half * c.cos_half).max(0.0).sqrt();
                Self::Nappe(c.vertex, c.axis, c.cos_half, sin)
            }
            _ => return None,
        })
    }

    /// Signed distance of `p`, positive outside.
    pub(crate) fn distance(&self, p: Vec3) -> f64 {
        match self {
            Self::Half(plane) => plane.distance(p),
            Self::Ball(c, r) => (p - c).norm() - r,
            Self::Rod(q, t, r) => across(p - q, *t).norm() - r,
            Self::Nappe(v, t, cos, sin) => {
                let w = p - v;
                let (along, radial) = (w.dot(t), across(w, *t).norm());
                // Beyond the vertex the vertex itself is nearest.
                if along * cos + radial * sin <= 0.0 && along * sin < radial * cos {
                    w.norm()
                } else {
                    radial * cos - along * sin
                }
            }
        }
    }

    /// The unit direction away from a half space that holds the solid, and how far a place is from it: its signed distance, but
    /// beyond the vertex of a cone, where it may be less.
    pub(crate) fn half_space(&self, p: Vec3) -> (Vec3, f64) {
        let from = match self {
            Self::Half(plane) => plane.n,
            Self::Ball(c, _) => p - c,
            Self::Rod(q, ..) => p - q,
            Self::Nappe(v, ..) => p - v,
        };
        let m = self.bounded_direction(from);
        (m, m.dot(&p) - self.support(m))
    }
}

impl Supported for Solid {
    fn support(&self, m: Vec3) -> f64 {
        /// Largest sine by which a direction may miss the bounded ones and still count as rounding.
        const ROUNDING: f64 = 1e-12;
        match self {
            Self::Half(plane) => {
                if (m - plane.n).norm() <= ROUNDING {
                    plane.d
                } else {
                    f64::INFINITY
                }
            }
            Self::Ball(c, r) => m.dot(c) + r * m.norm(),
            Self::Rod(q, t, r) => {
                if m.dot(t).abs() <= ROUNDING {
                    m.dot(q) + r * m.norm()
                } else {
                    f64::INFINITY
                }
            }
            Self::Nappe(v, t, cos, sin) => {
                // Bounded where no generator points along m.
                let (along, radial) = (m.dot(t), across(m, *t).norm());
                if along * cos + radial * sin <= ROUNDING { m.dot(v) } else { f64::INFINITY }
            }
        }
    }

    fn bounded_direction(&self, m: Vec3) -> Vec3 {
        match self {
            Self::Half(plane) => plane.n,
            Self::Ball(..) => unit_or(m, Vec3::z()),
            Self::Rod(_, t, _) => unit_or(across(m, *t), any_across(*t)),
            Self::Nappe(_, t, cos, sin) => {
                let out = across(m, *t);
                let (along, radial) = (m.dot(t), out.norm());
                if along * cos + radial * sin <= 0.0 {
                    unit_or(m, -*t)
                } else {
                    unit_or(out, any_across(*t)) * *cos - *t * *sin
                }
            }
        }
    }

    fn square_direction(&self, m: Vec3, v: Vec3) -> Vec3 {
        match self {
            Self::Half(_) | Self::Ball(..) => self.bounded_direction(without(m, v)),
            Self::Rod(_, t, _) => square_to_both(m, *t, v),
            Self::Nappe(_, t, cos, sin) => {
                // Of the normals of its side, `cos r - sin t` with r square to t, those with `cos r.v = sin t.v`.
                let aside = across(v, *t);
                let along = sin * t.dot(&v) / (cos * aside.norm());
                // Of a way between its generators there is none, along the axis no one.
                if along.abs() > 1.0 || !along.is_finite() {
                    return self.bounded_direction(without(m, v));
                }
                let (u, w) = (aside.normalize(), t.cross(&aside).normalize());
                let rest = (1.0 - along * along).max(0.0).sqrt().copysign(m.dot(&w));
                (u * along + w * rest) * *cos - *t * *sin
            }
        }
    }
}

/// `m` without its part along `v`.
pub(crate) fn without(m: Vec3, v: Vec3) -> Vec3 {
    m - v * (m.dot(&v) / v.norm_squared().max(f64::MIN_POSITIVE))
}

/// The unit vector square to `t` and `v` on the side of `m`; `m` without its part along `t` where those run alike.
pub(crate) fn square_to_both(m: Vec3, t: Vec3, v: Vec3) -> Vec3 {
    let both = t.cross(&v);
    let alike = both.norm() <= 1e-12 * v.norm();
    unit_or(if alike { across(m, t) } else { both * both.dot(&m).signum() }, any_across(t))
}

fn across(w: Vec3, t: Vec3) -> Vec3 {
    w - w.dot(&t) * t
}

pub(crate) fn unit_or(v: Vec3, otherwise: Vec3) -> Vec3 {
    let n = v.norm();
    if n > 0.0 { v / n } else { otherwise }
}

pub(crate) fn any_across(t: Vec3) -> Vec3 {
    let (x, y, z) = (t.x.abs(), t.y.abs(), t.z.abs());
    let e = if x <= y && x <= z {
        Vec3::x()
    } else if y <= z {
        Vec3::y()
    } else {
        Vec3::z()
    };
    unit_or(across(e, t), Vec3::x())
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Cone, Cylinder, Sphere};
    use proptest::prelude::*;

    fn solids() -> Vec<Solid> {
        let t = Vec3::new(1.0, 2.0, 2.0) / 3.0;
        [
            Form::Plane(Plane { n: t, d: 1.5 }),
            Form::Sphere(Sphere { center: Vec3::new(1.0, -2.0, 0.5), radius: 3.0 }),
            Form::Cylinder(Cylinder { point: Vec3::new(0.0, 1.0, 1.0), axis: t, radius: 2.0 }),
            Form::Cone(Cone { vertex: Vec3::new(1.0, 0.0, -1.0), axis: t, cos_half: 0.8 }),
        ]
        .iter()
        .map(|f| Solid::new(f).unwrap())
        .collect()
    }

    proptest! {
        #[test]
        fn no_direction_proves_more_than_the_distance(
            p in prop::array::uniform3(-9.0..9.0_f64), m in prop::array::uniform3(-1.0..1.0_f64),
        ) {
            let p = Vec3::from(p);
            for solid in solids() {
                let d = solid.bounded_direction(Vec3::from(m));
                let h = solid.support(d);
                prop_assert!(h.is_finite() && (d.norm() - 1.0).abs() < 1e-12, "{solid:?}");
                prop_assert!(d.dot(&p) - h <= solid.distance(p) + 1e-9, "{solid:?}");
            }
        }

        #[test]
        fn directions_square_to_a_way_are_normals(
            m in prop::array::uniform3(-1.0..1.0_f64), v in prop::array::uniform3(-1.0..1.0_f64),
        ) {
            let v = Vec3::from(v);
            for solid in solids() {
                let from = solid.bounded_direction(Vec3::from(m));
                let d = solid.square_direction(from, v);
                prop_assert!((d.norm() - 1.0).abs() < 1e-12 && solid.support(d).is_finite(), "{solid:?}");
                let there_is = match solid {
                    Solid::Half(_) => false,
                    Solid::Ball(..) | Solid::Rod(..) => true,
                    // A way within the cone of directions of its generators is square to none of its normals.
                    Solid::Nappe(_, t, cos, _) => v.dot(&t).abs() <= cos * v.norm(),
                };
                if there_is {
                    prop_assert!(d.dot(&v).abs() <= 1e-12, "{solid:?} {d} {v}");
                }
            }
        }
    }
}
