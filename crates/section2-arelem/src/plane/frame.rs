//! The plane square to the tool axis, in which the plane routine works.

use aptc_geometry::Vec3;

/// A point or vector of the plane.
pub(crate) type Vec2 = nalgebra::Vector2<f64>;

/// Right-handed frame: `w` the tool axis, `u` and `v` square to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) u: Vec3,
    pub(crate) v: Vec3,
    pub(crate) w: Vec3,
}

impl Frame {
    /// The frame of a unit tool axis; for the z axis exactly x, y, z.
    pub(crate) fn of(w: Vec3) -> Self {
        if w.x.abs() + w.y.abs() < f64::MIN_POSITIVE && w.z > 0.0 {
            return Self { u: Vec3::x(), v: Vec3::y(), w: Vec3::z() };
        }
        let least = if w.x.abs() <= w.y.abs() && w.x.abs() <= w.z.abs() {
            Vec3::x()
        } else if w.y.abs() <= w.z.abs() {
            Vec3::y()
        } else {
            Vec3::z()
        };
        let u = least.cross(&w).normalize();
        Self { u, v: w.cross(&u), w }
    }

    /// Projection of a point or vector into the plane.
    pub(crate) fn plan(&self, p: Vec3) -> Vec2 {
        Vec2::new(self.u.dot(&p), self.v.dot(&p))
    }

    /// Height of a point along the axis.
    pub(crate) fn height(&self, p: Vec3) -> f64 {
        self.w.dot(&p)
    }

    /// The point over `q` at that height.
    pub(crate) fn space(&self, q: Vec2, height: f64) -> Vec3 {
        self.u * q.x + self.v * q.y + self.w * height
    }
}

/// A quarter turn to the left.
pub(crate) fn left(t: Vec2) -> Vec2 {
    Vec2::new(-t.y, t.x)
}

/// Angle of a vector.
pub(crate) fn angle(v: Vec2) -> f64 {
    aptc_geometry::trig::atan2(v.y, v.x)
}

/// The unit vector at an angle.
pub(crate) fn ray(angle: f64) -> Vec2 {
    let (s, c) = aptc_geometry::trig::sin_cos(angle);
    Vec2::new(c, s)
}
