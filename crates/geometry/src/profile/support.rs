//! Extreme points of the profile: in a direction, and farthest from a point.

use crate::Vec2;
use crate::profile::{Near, Profile, Segment, cross};

/// The extreme point of a profile in a direction.
#[derive(Clone, Copy, Debug)]
pub struct Support {
    /// How far the solid reaches in the direction, from the tool end.
    pub reach: f64,
    /// The point: distance from the axis, height.
    pub point: [f64; 2],
    /// Where it lies.
    pub segment: Segment,
    /// Radius of curvature there in the half plane: 0 at edges, infinite on a face.
    pub radius: f64,
}

/// The place of the solid farthest from a point.
#[derive(Clone, Copy, Debug)]
pub struct Farthest {
    /// Distance.
    pub distance: f64,
    /// The place: distance from the axis, negative on the point's own side (never nearer than 0 on the
    /// other), height.
    pub point: [f64; 2],
    /// Unit direction from the point to the place, in the same coordinates.
    pub direction: [f64; 2],
    /// Where it lies.
    pub segment: Segment,
}

/// A face whose normal is nearer to the direction than this is touched as a whole.
const FACE: f64 = 1e-12;

impl Profile {
    /// The extreme point in the unit direction (`out` >= 0 away from the axis, `up`). When a flat end faces
    /// the direction, its middle; when a side does, its far end from the arc.
    #[inline]
    pub fn support(&self, out: f64, up: f64) -> Support {
        let n = Vec2::new(out, up);
        let (p, segment, radius) = if cross(self.a0, n) >= 0.0 {
            if cross(n, self.a1) >= 0.0 && n.dot(&(self.a0 + self.a1)) >= -1e-9 {
                (self.c + n * self.r, Segment::Arc, self.r)
            } else if cross(n, self.nu) >= 0.0 {
                (self.pu, Segment::UpperPoint, 0.0)
            } else {
                (self.rim, Segment::Rim, 0.0)
            }
        } else if cross(self.nl, n) >= 0.0 {
            (self.pl, Segment::LowerPoint, 0.0)
        } else {
            (self.tip, Segment::Tip, 0.0)
        };
        let (p, segment, radius) = self.face(n, p, segment, radius);
        Support { reach: n.dot(&p), point: [p.x, p.y], segment, radius }
    }

    /// Does the arc touch in the unit direction (`out` >= 0 away from the axis, `up`)? What [`Self::support`] tells.
    #[inline]
    pub fn touches_with_arc(&self, out: f64, up: f64) -> bool {
        let n = Vec2::new(out, up);
        let along = |m: Vec2| cross(m, n).abs() <= FACE && m.dot(&n) > 0.0;
        cross(self.a0, n) >= 0.0
            && cross(n, self.a1) >= 0.0
            && n.dot(&(self.a0 + self.a1)) >= -1e-9
            && !(along(self.nl) && self.pl != self.tip)
            && !(along(self.nu) && self.rim != self.pu)
            && !(n.x <= FACE && n.y > 0.0 && self.rim.x > 0.0)
    }

    /// Recognises that a whole face is touched.
    #[inline]
    fn face(&self, n: Vec2, p: Vec2, segment: Segment, radius: f64) -> (Vec2, Segment, f64) {
        let along = |m: Vec2| cross(m, n).abs() <= FACE && m.dot(&n) > 0.0;
        if along(self.nl) && self.pl != self.tip {
            let q = if self.nl.x <= FACE { self.tip } else { self.pl };
            (q, Segment::LowerLine, f64::INFINITY)
        } else if along(self.nu) && self.rim != self.pu {
            (self.pu, Segment::UpperLine, f64::INFINITY)
        } else if n.x <= FACE && n.y > 0.0 && self.rim.x > 0.0 {
            (Vec2::new(0.0, self.rim.y), Segment::Top, f64::INFINITY)
        } else {
            (p, segment, radius)
        }
    }

    /// The place of the whole solid farthest from the point at `rho` from the axis and height `z`: it lies
    /// across the axis from it.
    ///
    /// APT: `TLNORM` for a concave surface, whose centre lies on the tool's side.
    pub fn farthest(&self, rho: f64, z: f64) -> Farthest {
        let x = Vec2::new(-rho, z);
        let mut best = (self.tip, Segment::Tip);
        let mut square = (self.tip - x).norm_squared();
        let mut offer = |p: Vec2, segment: Segment| {
            let d = (p - x).norm_squared();
            if d > square {
                square = d;
                best = (p, segment);
            }
        };
        offer(self.pl, Segment::LowerPoint);
        offer(self.pu, Segment::UpperPoint);
        offer(self.rim, Segment::Rim);
        let w = self.c - x;
        let away = w.norm();
        if self.r > 0.0 && away > 0.0 && self.in_arc(w) {
            offer(self.c + w * (self.r / away), Segment::Arc);
        }
        let (p, segment) = best;
        let distance = square.sqrt();
        let d = if distance > 0.0 { (p - x) / distance } else { Vec2::new(0.0, -1.0) };
        Farthest { distance, point: [p.x, p.y], direction: [d.x, d.y], segment }
    }

    /// The place farthest from the ray that runs up from the point at `rho` from the axis and height `z`: of
    /// what lies above the point the distance counts level.
    ///
    /// A hollow that is open along the tool axis and has its centre at the point touches there.
    pub fn farthest_below(&self, rho: f64, z: f64) -> Farthest {
        let x = Vec2::new(-rho, z);
        let off = |p: Vec2| Vec2::new(p.x - x.x, (p.y - x.y).min(0.0));
        let mut best = (self.tip, Segment::Tip, off(self.tip));
        let mut offer = |p: Vec2, segment: Segment| {
            let d = off(p);
            if d.norm_squared() > best.2.norm_squared() {
                best = (p, segment, d);
            }
        };
        offer(self.pl, Segment::LowerPoint);
        offer(self.pu, Segment::UpperPoint);
        offer(self.rim, Segment::Rim);
        if self.r > 0.0 {
            let w = self.c - x;
            let away = w.norm();
            if away > 0.0 && self.in_arc(w) {
                offer(self.c + w * (self.r / away), Segment::Arc);
            }
            let level = Vec2::new(1.0, 0.0);
            if self.in_arc(level) {
                offer(self.c + level * self.r, Segment::Arc);
            }
        }
        let (p, segment, d) = best;
        let distance = d.norm();
        let d = if distance > 0.0 { d / distance } else { Vec2::new(0.0, -1.0) };
        Farthest { distance, point: [p.x, p.y], direction: [d.x, d.y], segment }
    }

    /// Nearest profile point and normal for a sphere about the point at `rho`, `z` that the tool touches
    /// from outside.
    ///
    /// APT: `TLNORM` and `SEVENSEQ` for a convex surface.
    pub fn opposite(&self, rho: f64, z: f64) -> Near {
        self.near(rho, z)
    }
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "some closed forms are met to the last bit")]
mod tests {
    use super::*;
    use crate::Cutter;
    use crate::profile::distance::tests::cutter;
    use crate::trig;
    use proptest::prelude::*;

    #[test]
    fn faces_are_touched_in_the_middle() {
        let p = Profile::new(&Cutter::mill(20.0, 3.0, 60.0)).unwrap();
        let s = p.support(0.0, -1.0);
        assert_eq!((s.point, s.segment), ([0.0, 0.0], Segment::LowerLine));
        let s = p.support(0.6, -0.8);
        assert!((s.point[0] - 8.8).abs() < 1e-14 && (s.point[1] - 0.6).abs() < 1e-14);
        let s = p.support(0.0, 1.0);
        assert_eq!((s.point, s.segment), ([0.0, 60.0], Segment::Top));
        let ball = Profile::new(&Cutter::mill(10.0, 5.0, 5.0)).unwrap();
        assert_eq!(ball.support(0.0, -1.0).segment, Segment::Arc);
        assert_eq!(ball.support(0.6, 0.8).point, [5.0, 5.0]);
    }

    proptest! {
        #[test]
        fn the_lowest_point_at_a_distance_is_on_the_skin(
            kind in 0_usize..8, s in prop::array::uniform4(0.05_f64..0.95), share in 0.0_f64..1.0,
        ) {
            let p = Profile::new(&cutter(kind, s)).unwrap();
            let rho = share * p.widest();
            let z = p.height_at(rho).unwrap();
            prop_assert!(p.near(rho, z).distance.abs() < 1e-9, "{rho} {z} {p:?}");
            // Below it there is nothing.
            prop_assert!(p.near(rho, z - 1e-3).distance > 0.0, "{rho} {z} {p:?}");
            prop_assert!(p.height_at(p.widest() + 1e-6).is_none());
        }

        #[test]
        fn support_bounds_the_solid(
            kind in 0_usize..8, s in prop::array::uniform4(0.05_f64..0.95),
            turn in -90.0_f64..90.0, x in prop::array::uniform2(-30.0_f64..30.0),
        ) {
            let p = Profile::new(&cutter(kind, s)).unwrap();
            let (out, up) = (trig::cos_deg(turn), trig::sin_deg(turn));
            let far = p.support(out, up);
            prop_assert_eq!(p.touches_with_arc(out, up), far.segment == Segment::Arc);
            // The support point belongs to the solid.
            prop_assert!(p.near(far.point[0], far.point[1]).distance.abs() < 1e-9);
            // Moving out of it along the direction the distance grows at rate 1.
            let q = p.near(far.point[0] + 7.0 * out, far.point[1] + 7.0 * up);
            prop_assert!((q.distance - 7.0).abs() < 1e-9, "{:?} {:?}", far, q);
            // No point of the solid lies beyond.
            let n = p.near(x[0].abs(), x[1]);
            prop_assert!(n.point[0] * out + n.point[1] * up <= far.reach + 1e-9);
            // The farthest place is a support point in its direction.
            let f = p.farthest_below(x[0].abs(), x[1]);
            let (z, rho) = (x[1], x[0].abs());
            for k in 0..=90 {
                let (out, up) = (trig::cos_deg(2.0 * f64::from(k) - 90.0), trig::sin_deg(2.0 * f64::from(k) - 90.0));
                let q = p.support(out, up).point;
                let away = trig::hypot(q[0] + rho, (q[1] - z).min(0.0));
                prop_assert!(away <= f.distance + 1e-9, "{f:?} {q:?}");
            }
            let f = p.farthest(x[0].abs(), x[1]);
            let s = p.support(f.direction[0].max(0.0), f.direction[1]);
            if f.direction[0] > 1e-9 {
                let d = f.direction[0] * f.point[0] + f.direction[1] * f.point[1];
                prop_assert!((s.reach - d).abs() < 1e-9, "{:?} {:?}", f, s);
            }
        }
    }
}
