//! The hollow of a quadric with all that lies above it, seen along an axis.

use nalgebra::Matrix3;

use crate::surface::{Foot, QuadricSurface, Shape, frame_about};
use crate::{Quadric, Vec3, trig};

/// Cosine with the axis below which a normal counts as square to it.
const LEVEL: f64 = 1e-12;

/// A convex hollow that counts as open along a direction: its wall is the part of the quadric whose outward normal does
/// not look that way, and beyond the outline seen along it the wall runs straight on.
#[derive(Clone, Debug)]
pub struct OpenedQuadric<'a> {
    whole: &'a QuadricSurface,
    outline: QuadricSurface,
    up: Vec3,
}

impl QuadricSurface {
    /// The hollow on the negative side, open along the unit vector `up`; `None` where that side is not convex, where it
    /// is open already (a paraboloid about the axis, a bore) and where it opens down.
    pub fn opened(&self, up: Vec3) -> Option<OpenedQuadric<'_>> {
        /// Share of the greatest coefficient below which a line along the axis meets the surface but once.
        const ONCE: f64 = 1e-6;
        if self.convexity() != 1 {
            return None;
        }
        // Half the change of the form along the axis is a linear function w.x + e, and a its own change. What is left
        // of the form without its square over a does not change along the axis: the outline.
        let [a, b, c, d, f, g, h, p, q, r] = self.form().c;
        let w = Vec3::new(
            a * up.x + h * up.y + g * up.z,
            h * up.x + b * up.y + f * up.z,
            g * up.x + f * up.y + c * up.z,
        );
        let e = p * up.x + q * up.y + r * up.z;
        let bend = w.dot(&up);
        let greatest = [a, b, c, f, g, h].into_iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        if bend <= ONCE * greatest {
            return None;
        }
        let of = |x: f64, y: f64| x * y / bend;
        let outline = [
            a - of(w.x, w.x),
            b - of(w.y, w.y),
            c - of(w.z, w.z),
            d - of(e, e),
            f - of(w.y, w.z),
            g - of(w.x, w.z),
            h - of(w.x, w.y),
            p - of(w.x, e),
            q - of(w.y, e),
            r - of(w.z, e),
        ];
        let kind = self.form().kind;
        let outline = QuadricSurface::new(&Quadric { kind, c: outline })?;
        (outline.convexity() == 1).then_some(OpenedQuadric { whole: self, outline, up })
    }

    /// Is a tool of the height and radius too large to stand in the hollow with its axis `up`: wherever it is, or of a
    /// hollow that is open to a side, with its end near `p`?
    pub fn too_low(&self, up: Vec3, p: Vec3, height: f64, radius: f64) -> bool {
        if self.opened(up).is_none() {
            return false;
        }
        let [a, b, c, _, f, g, h, ..] = self.form().c;
        let m = Matrix3::new(a, h, g, h, b, f, g, f, c);
        let bend = up.dot(&(m * up));
        let Some(depth) = self.depth() else {
            // The line along the axis enters where it leaves again after twice the slope over the bend.
            let slope = 0.5 * self.form().gradient(self.foot(p).point).dot(&up);
            return 2.0 * slope.abs() < bend * height;
        };
        // The mean of the form over the rims of both ends, taken about their middle, is least about that of the hollow.
        let [u, v] = frame_about(up);
        let (uu, uv, vv) = (u.dot(&(m * u)), u.dot(&(m * v)), v.dot(&(m * v)));
        let narrow = 0.5 * (uu + vv) - trig::hypot(0.5 * (uu - vv), uv);
        0.25 * bend * height * height + narrow.max(0.0) * radius * radius > depth
    }
}

impl OpenedQuadric<'_> {
    /// The nearest place of the wall.
    pub fn foot(&self, p: Vec3) -> Foot {
        let first = self.whole.foot(p);
        if first.normal.dot(&self.up) <= 0.0 {
            return first;
        }
        // Within the opened hollow the tangent planes that do not look up bound it: the nearest is square to the axis, or
        // belongs to the second place of the quadric from which the distance grows all round.
        let wall = self.outline.foot(p);
        match self.whole.second_foot(p) {
            Some(second)
                if second.normal.dot(&self.up) <= 0.0 && second.distance > wall.distance =>
            {
                second
            }
            _ => wall,
        }
    }

    /// Curvature of the wall at its point `q` with the outward normal `n` there.
    pub fn shape_at(&self, q: Vec3, n: Vec3) -> Shape {
        if n.dot(&self.up) < -LEVEL {
            self.whole.shape_at(q, n)
        } else {
            self.outline.shape_at(q, n)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::QuadricKind;
    use proptest::prelude::*;

    fn quadric(c: [f64; 10]) -> QuadricSurface {
        QuadricSurface::new(&Quadric { kind: QuadricKind::Qadric, c }).unwrap()
    }

    /// An ellipsoid by half axes and centre.
    fn ellipsoid(axes: [f64; 3], m: [f64; 3]) -> QuadricSurface {
        let k = axes.map(|a| 1.0 / (a * a));
        let last = k[0] * m[0] * m[0] + k[1] * m[1] * m[1] + k[2] * m[2] * m[2] - 1.0;
        quadric([k[0], k[1], k[2], last, 0.0, 0.0, 0.0, -k[0] * m[0], -k[1] * m[1], -k[2] * m[2]])
    }

    #[test]
    fn a_flat_bowl_keeps_its_floor_above_its_middle() {
        let s = ellipsoid([30.0, 30.0, 4.0], [0.0; 3]);
        let open = s.opened(Vec3::z()).unwrap();
        for z in [-3.0, 0.0, 1.0, 6.0, 20.0] {
            let f = open.foot(Vec3::new(0.0, 0.0, z));
            let floor = f.distance + 4.0 + z;
            assert!(floor.abs() < 1e-9 || z > 26.0 - 1e-9, "{z} {f:?}");
        }
        // High up the rim, which runs on straight, is nearer.
        let f = open.foot(Vec3::new(25.0, 0.0, 9.0));
        assert!((f.distance + 5.0).abs() < 1e-9 && (f.normal - Vec3::x()).norm() < 1e-9);
        assert!(s.too_low(Vec3::z(), Vec3::zeros(), 20.0, 2.0));
        assert!(!s.too_low(Vec3::z(), Vec3::zeros(), 5.0, 2.0));
    }

    #[test]
    fn what_is_open_already_stays_as_it_is() {
        let bowl = quadric([0.1, 0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5]);
        assert!(bowl.opened(Vec3::z()).is_none());
        let lean = Vec3::new(0.3, 0.0, 1.0).normalize();
        let open = bowl.opened(lean).unwrap();
        assert!(open.foot(Vec3::new(0.0, 0.0, 3.0)).normal.dot(&lean) <= 1e-12);
        let bore = quadric([0.1, 0.2, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert!(bore.opened(Vec3::z()).is_none());
        let saddle = quadric([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5, 0.0, 0.0, 0.5]);
        assert!(saddle.opened(Vec3::z()).is_none());
    }

    proptest! {
        /// The distance from the wall is the least over all planes that touch the hollow and do not look up.
        #[test]
        fn the_wall_is_the_nearest_of_all_planes_that_do_not_look_up(
            axes in prop::array::uniform3(1.0_f64..9.0), m in prop::array::uniform3(-2.0_f64..2.0),
            p in prop::array::uniform3(-1.0_f64..1.0), lean in prop::array::uniform2(-0.7_f64..0.7),
            high in 0.0_f64..6.0,
        ) {
            let s = ellipsoid(axes, m);
            let up = Vec3::new(lean[0], lean[1], 1.0).normalize();
            let open = s.opened(up).unwrap();
            let mid = Vec3::from(m);
            let p = mid + Vec3::new(p[0] * axes[0], p[1] * axes[1], p[2] * axes[2]) * 0.57 + up * high;
            let clear = |n: Vec3| {
                let h = Vec3::new(n.x * axes[0], n.y * axes[1], n.z * axes[2]).norm();
                n.dot(&mid) + h - n.dot(&p)
            };
            let [a, b] = frame_about(up);
            let mut least = f64::INFINITY;
            for i in 0..=60 {
                let (s, c) = trig::sin_cos(f64::from(i) * std::f64::consts::FRAC_PI_2 / 60.0);
                for k in 0..120 {
                    let (t, d) = trig::sin_cos(f64::from(k) * std::f64::consts::TAU / 120.0);
                    least = least.min(clear((a * d + b * t) * c - up * s));
                }
            }
            let f = open.foot(p);
            prop_assert!(-f.distance <= least + 1e-9, "{} {}", -f.distance, least);
            prop_assert!(-f.distance >= least - 0.02 * (1.0 + least.abs()), "{} {}", -f.distance, least);
            prop_assert!(f.normal.dot(&up) <= 1e-9 && (clear(f.normal) + f.distance).abs() < 1e-6);
        }
    }
}
