//! The cutter in space: a profile with its tool end and axis.

use crate::profile::{Farthest, Profile, Segment};
use crate::surface::{EPS_ANG, Shape, frame_about};
use crate::{Vec2, Vec3};

/// A cutter at a place.
#[derive(Clone, Copy, Debug)]
pub struct Tool<'a> {
    /// Its profile.
    pub profile: &'a Profile,
    /// Tool end.
    pub te: Vec3,
    /// Unit tool axis, from the tool end to the holder.
    pub ta: Vec3,
}

/// The place of a tool nearest to a point.
#[derive(Clone, Copy, Debug)]
pub struct ToolNear {
    /// Signed distance, negative inside the tool.
    pub distance: f64,
    /// Unit gradient of the distance: the outward normal of the tool.
    pub normal: Vec3,
    /// The nearest point of the tool.
    pub point: Vec3,
    /// Second derivatives of the distance at the given point, across the gradient: along the profile,
    /// around the axis.
    pub shape: Shape,
    /// Where on the profile.
    pub segment: Segment,
}

/// The place of a tool farthest from a point.
#[derive(Clone, Copy, Debug)]
pub struct ToolFarthest {
    /// Its distance from the point.
    pub distance: f64,
    /// The place.
    pub point: Vec3,
    /// Unit direction from the given point to it: the outward normal of the tool.
    pub direction: Vec3,
    /// Where on the profile.
    pub segment: Segment,
}

/// The extreme point of a tool in a direction.
#[derive(Clone, Copy, Debug)]
pub struct ToolSupport {
    /// `n . point`.
    pub reach: f64,
    /// The extreme point.
    pub point: Vec3,
    /// Directions along the profile and around the axis, perpendicular to the normal.
    pub frame: [Vec3; 2],
    /// Radii of curvature along them: 0 at edges, infinite along faces.
    pub radii: [f64; 2],
    /// Where on the profile.
    pub segment: Segment,
}

impl<'a> Tool<'a> {
    /// The same cutter with the same axis elsewhere.
    #[must_use]
    #[inline]
    pub fn at(&self, te: Vec3) -> Self {
        Self { te, ..*self }
    }

    /// Height above the tool end, distance from the axis, unit direction away from the axis.
    #[inline]
    fn half_plane(&self, w: Vec3) -> (f64, f64, Vec3) {
        let z = w.dot(&self.ta);
        let radial = self.square(w - self.ta * z);
        let rho = radial.norm();
        // On the axis every direction is as good; below this the direction would be rounding.
        if rho > 1e-15 * z.abs() && rho > 0.0 {
            (z, rho, radial / rho)
        } else {
            (z, 0.0, frame_about(self.ta)[0])
        }
    }

    /// What is left of a difference across the axis, once more without what rounding left along it: beside a small
    /// difference that is much.
    #[inline]
    fn square(&self, radial: Vec3) -> Vec3 {
        radial - self.ta * radial.dot(&self.ta)
    }

    /// Signed distance of `q` to the tool, negative inside; convex, with slope 1.
    #[inline]
    pub fn distance(&self, q: Vec3) -> f64 {
        let w = q - self.te;
        let z = w.dot(&self.ta);
        self.profile.near((w - self.ta * z).norm(), z).distance
    }

    /// The nearest point of the tool, and the derivatives of the distance.
    ///
    /// APT: `TLNORM` for a convex surface.
    #[inline]
    pub fn near(&self, q: Vec3) -> ToolNear {
        let (z, rho, out) = self.half_plane(q - self.te);
        let n = self.profile.near(rho, z);
        let [nr, nz] = n.normal;
        let around = self.ta.cross(&out);
        let bend = if rho > 0.0 { nr / rho } else { n.bend };
        ToolNear {
            distance: n.distance,
            normal: out * nr + self.ta * nz,
            point: self.te + out * n.point[0] + self.ta * n.point[1],
            shape: Shape { frame: [self.ta * nr - out * nz, around], k: [n.bend, 0.0, bend] },
            segment: n.segment,
        }
    }

    /// The extreme point in the unit direction `n`.
    #[inline]
    pub fn support(&self, n: Vec3) -> ToolSupport {
        let up = n.dot(&self.ta);
        let radial = self.square(n - self.ta * up);
        let size = radial.norm();
        let (across, out) = if size > EPS_ANG * 0.01 {
            (size, radial / size)
        } else {
            (0.0, frame_about(self.ta)[0])
        };
        let s = self.profile.support(across, up);
        let [rho, z] = s.point;
        let round = |r: f64| if across > 0.0 { r / across } else { f64::INFINITY };
        // On the arc r + e / sin: with e = 0 the ball's radius in every direction.
        let around = match s.segment {
            Segment::Arc => {
                let e = self.profile.c.x;
                if e == 0.0 { s.radius } else { s.radius + round(e) }
            }
            Segment::Tip => 0.0,
            _ if rho > 0.0 || across <= 0.0 => round(rho),
            _ => 0.0,
        };
        ToolSupport {
            reach: n.dot(&self.te) + across * rho + up * z,
            point: self.te + out * rho + self.ta * z,
            frame: [self.ta * across - out * up, self.ta.cross(&out)],
            radii: [s.radius, around],
            segment: s.segment,
        }
    }

    /// The face of the tool whose normal is nearest to the unit direction `n`.
    pub fn face(&self, n: Vec3) -> Segment {
        let up = n.dot(&self.ta);
        let v = Vec2::new((n - self.ta * up).norm(), up);
        let faces = [
            (v.dot(&self.profile.nl), Segment::LowerLine),
            (v.dot(&self.profile.nu), Segment::UpperLine),
            (v.y, Segment::Top),
        ];
        faces.iter().fold(faces[0], |best, f| if f.0 > best.0 { *f } else { best }).1
    }

    /// Unit vector square to the axis, from the axis towards `p`; for a point of the axis an arbitrary but
    /// fixed one.
    ///
    /// APT: `UICOMP`.
    pub fn across(&self, p: Vec3) -> Vec3 {
        let w = p - self.te;
        let z = w.dot(&self.ta);
        let radial = w - self.ta * z;
        let rho = radial.norm();
        if rho > EPS_ANG * z.abs() && rho > 0.0 { radial / rho } else { frame_about(self.ta)[0] }
    }

    /// The place of the tool farthest from `p`: where a hollow surface with its centre at `p` touches.
    ///
    /// APT: `TLNORM` for a concave surface.
    #[inline]
    pub fn farthest(&self, p: Vec3) -> ToolFarthest {
        let (z, rho, out) = self.half_plane(p - self.te);
        self.far(&self.profile.farthest(rho, z), out)
    }

    /// The place of the tool farthest from the ray that runs from `p` along the tool axis: where a hollow
    /// that is open that way and has its centre at `p` touches.
    #[inline]
    pub fn farthest_below(&self, p: Vec3) -> ToolFarthest {
        let (z, rho, out) = self.half_plane(p - self.te);
        self.far(&self.profile.farthest_below(rho, z), out)
    }

    #[inline]
    fn far(&self, f: &Farthest, out: Vec3) -> ToolFarthest {
        let local = |v: [f64; 2]| self.ta * v[1] - out * v[0];
        ToolFarthest {
            distance: f.distance,
            point: self.te + local(f.point),
            direction: local(f.direction),
            segment: f.segment,
        }
    }

    /// Centre of the corner arc on the side of the outward unit normal `tn`.
    ///
    /// APT: `AXIS-POINT`, which steps back from the tool point along the normal by the corner radius; for a
    /// contact on a line or an edge there is no such centre, and the point itself is returned.
    pub fn arc_center(&self, tool_point: Vec3, tn: Vec3) -> Vec3 {
        let n = Vec2::new((tn - self.ta * tn.dot(&self.ta)).norm(), tn.dot(&self.ta));
        if self.profile.in_arc(n) { tool_point - tn * self.profile.r } else { tool_point }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Cutter;
    use crate::profile::distance::tests::cutter;
    use proptest::prelude::*;

    fn mill(d: f64, r: f64) -> Profile {
        Profile::new(&Cutter::mill(d, r, 60.0)).unwrap()
    }

    #[test]
    fn published_tool_normals() {
        let ball = mill(10.0, 5.0);
        let o = Vec3::zeros();
        let tool = Tool { profile: &ball, te: o, ta: Vec3::z() };
        let n = tool.near(Vec3::new(0.0, 0.0, -100.0));
        assert_eq!((n.point, n.normal), (o, -Vec3::z()));
        assert_eq!(
            tool.arc_center(Vec3::new(3.0, 0.0, 1.0), Vec3::new(0.6, 0.0, -0.8)),
            Vec3::new(0.0, 0.0, 5.0)
        );
        let bull = mill(20.0, 3.0);
        let tool = Tool { profile: &bull, te: o, ta: Vec3::z() };
        let n = tool.near(Vec3::new(11.0, 0.0, 0.0));
        assert!((n.point - Vec3::new(9.4, 0.0, 1.2)).norm() < 1e-14);
        assert!((n.normal - Vec3::new(0.8, 0.0, -0.6)).norm() < 1e-14);
        let s = tool.support(-Vec3::new(0.6, 0.0, 0.8));
        assert!((s.point - Vec3::new(-8.8, 0.0, 0.6)).norm() < 1e-14);
        // Torus radii r and r + e / sin phi.
        assert!((s.radii[0] - 3.0).abs() < 1e-15 && (s.radii[1] - (3.0 + 7.0 / 0.6)).abs() < 1e-13);
    }

    #[test]
    fn unit_vector_across_the_axis() {
        let ball = mill(10.0, 5.0);
        let tool = Tool { profile: &ball, te: Vec3::zeros(), ta: Vec3::z() };
        let u = tool.across(Vec3::new(3.0, 4.0, 10.0));
        assert!((u - Vec3::new(0.6, 0.8, 0.0)).norm() < 1e-15);
        let ta = Vec3::new(1.0, 1.0, 1.0).normalize();
        let tool = Tool { profile: &ball, te: Vec3::zeros(), ta };
        let u = tool.across(ta * 7.0);
        assert!((u.norm() - 1.0).abs() < 1e-15 && u.dot(&ta).abs() < 1e-15);
    }

    proptest! {
        #[test]
        fn derivatives_by_differences(
            kind in 0_usize..8, s in prop::array::uniform4(0.05_f64..0.95),
            q in prop::array::uniform3(-20.0_f64..20.0), a in prop::array::uniform3(-1.0_f64..1.0),
        ) {
            let p = Profile::new(&cutter(kind, s)).unwrap();
            let ta = Vec3::from(a);
            prop_assume!(ta.norm() > 0.1);
            let tool = Tool { profile: &p, te: Vec3::new(1.0, 2.0, 3.0), ta: ta.normalize() };
            let q = Vec3::from(q);
            let n = tool.near(q);
            prop_assume!(n.distance.abs() > 0.1);
            prop_assert!((n.point + n.normal * n.distance - q).norm() < 1e-9);
            let h = 1e-4;
            for d in [Vec3::x(), Vec3::y(), Vec3::z()] {
                let (f, b) = (tool.near(q + d * h), tool.near(q - d * h));
                // Only where no border between two segments lies in between.
                if f.segment == n.segment && b.segment == n.segment {
                    let slope = (f.distance - b.distance) / (2.0 * h);
                    prop_assert!((slope - n.normal.dot(&d)).abs() < 1e-5);
                    let second = (f.distance + b.distance - 2.0 * n.distance) / (h * h);
                    let exact = n.shape.second(d);
                    prop_assert!((second - exact).abs() < 1e-4 * (1.0 + exact.abs()));
                }
            }
            // Support points are those of the distance far out.
            let dir = n.normal;
            let far = tool.support(dir);
            let reach = dir.dot(&far.point);
            prop_assert!((reach - far.reach).abs() < 1e-9);
            prop_assert!(n.distance < 0.0 || dir.dot(&n.point) >= far.reach - 1e-9);
        }

        #[test]
        fn farthest_place_beats_every_support_point(
            kind in 0_usize..8, s in prop::array::uniform4(0.05_f64..0.95),
            q in prop::array::uniform3(-20.0_f64..20.0), n in prop::array::uniform3(-1.0_f64..1.0),
        ) {
            let p = Profile::new(&cutter(kind, s)).unwrap();
            let tool = Tool { profile: &p, te: Vec3::zeros(), ta: Vec3::z() };
            let n = Vec3::from(n);
            prop_assume!(n.norm() > 0.1);
            let q = Vec3::from(q);
            let ToolFarthest { point: place, direction, distance, .. } = tool.farthest(q);
            prop_assert!((q + direction * distance - place).norm() < 1e-9);
            prop_assert!((tool.support(n.normalize()).point - q).norm() <= distance + 1e-9);
            prop_assert!(tool.distance(place).abs() < 1e-9);
        }
    }
}
