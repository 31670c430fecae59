//! The cutter as a convex body, known by its support function.

use aptc_geometry::{Cutter, Vec3, trig};

/// A cutter as a convex solid of revolution: the hull of its profile's corners and its corner arc.
///
/// A cutter whose profile is not convex is contained in this hull, so what is proved of the hull against
/// gouging holds for the cutter; contact proved for a hull that is larger than the cutter does not, which
/// is why [`Body::exact`] tells the two apart.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Body {
    /// Corners of the profile: distance from the axis, height above the tool end.
    corners: [(f64, f64); 5],
    /// Centre of the corner arc and its radius.
    arc: (f64, f64, f64),
    /// The arc's normals as (radial, axial) sine and cosine: from the lower to the upper one.
    from: (f64, f64),
    to: (f64, f64),
    /// Is the hull the cutter itself?
    exact: bool,
}

/// Position of the tool: tool end and unit tool axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    pub(crate) te: Vec3,
    pub(crate) ta: Vec3,
}

impl Body {
    /// The body of a cutter; `thick` is left on the surface, as if the cutter were that much fatter.
    pub(crate) fn new(c: &Cutter) -> Self {
        let (sa, ca) = (trig::sin_deg(c.alpha_deg), trig::cos_deg(c.alpha_deg));
        let (sb, cb) = (trig::sin_deg(c.beta_deg), trig::cos_deg(c.beta_deg));
        let half = c.diameter / 2.0;
        let r = c.corner_radius;
        // Where the arc meets the lower and the upper line.
        let lower = (c.e + r * sa, c.f - r * ca);
        let upper = (c.e + r * cb, c.f - r * sb);
        let corner = (half, half * sa / ca);
        // An arc of radius 0 that does not sit at the corner leaves a sharp corner there.
        let sharp = r == 0.0 && (c.e < half || c.e == 0.0);
        let (lower, upper) = if sharp { (corner, corner) } else { (lower, upper) };
        let top = upper.0 + (c.height - upper.1) * sb / cb;
        let corners = [(0.0, 0.0), lower, upper, (top.max(0.0), c.height), (0.0, c.height)];
        let on_lower = (lower.1 * ca - lower.0 * sa).abs() <= 1e-9 * c.diameter.max(c.height);
        let on_upper = ((upper.0 - half) * cb - (upper.1 - corner.1) * sb).abs()
            <= 1e-9 * c.diameter.max(c.height);
        let convex = c.alpha_deg + c.beta_deg <= 90.0 + 1e-9 && c.height >= upper.1;
        Self {
            corners,
            arc: (c.e, c.f, if sharp { 0.0 } else { r }),
            from: (sa, -ca),
            to: (cb, -sb),
            exact: convex && (sharp || r == 0.0 || (on_lower && on_upper)),
        }
    }

    /// Is the hull the cutter itself?
    pub(crate) fn exact(&self) -> bool {
        self.exact
    }

    /// Farthest distance of a point of the body from the tool end.
    pub(crate) fn reach(&self) -> f64 {
        let far = |(x, z): (f64, f64)| trig::hypot(x, z);
        let corners = self.corners.iter().copied().map(far).fold(0.0, f64::max);
        corners.max(far((self.arc.0, self.arc.1)) + self.arc.2)
    }

    /// The point of the profile farthest along (radial, axial), radial not negative.
    pub(crate) fn support(&self, radial: f64, axial: f64) -> (f64, f64) {
        let mut best = self.corners[0];
        let mut value = f64::NEG_INFINITY;
        for p in self.corners {
            let v = p.0 * radial + p.1 * axial;
            if v > value {
                (best, value) = (p, v);
            }
        }
        let (e, f, r) = self.arc;
        let length = trig::hypot(radial, axial);
        if r > 0.0 && length > 0.0 {
            let d = (radial / length, axial / length);
            // The arc answers for the directions between its end normals.
            let left = |a: (f64, f64), b: (f64, f64)| a.0 * b.1 - a.1 * b.0;
            if left(self.from, d) >= 0.0 && left(d, self.to) >= 0.0 {
                let p = (e + r * d.0, f + r * d.1);
                let v = p.0 * radial + p.1 * axial;
                if v > value {
                    best = p;
                }
            }
        }
        best
    }

    /// The point of the body in `pose` farthest along `n`.
    pub(crate) fn farthest(&self, pose: &Pose, n: Vec3) -> Vec3 {
        let axial = n.dot(&pose.ta);
        let across = n - axial * pose.ta;
        let radial = across.norm();
        let (x, z) = self.support(radial, axial);
        let out = if radial > 0.0 { across / radial } else { Vec3::zeros() };
        pose.te + x * out + z * pose.ta
    }

    /// Support function: greatest `n . p` over the body in `pose`.
    pub(crate) fn height(&self, pose: &Pose, n: Vec3) -> f64 {
        self.farthest(pose, n).dot(&n)
    }

    /// Points of the profile that may be farthest from a point: the corners, and the far point of the arc.
    pub(crate) fn corners(&self) -> &[(f64, f64); 5] {
        &self.corners
    }

    /// Centre and radius of the corner arc.
    pub(crate) fn arc(&self) -> (f64, f64, f64) {
        self.arc
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn upright() -> Pose {
        Pose { te: Vec3::zeros(), ta: Vec3::z() }
    }

    #[test]
    fn a_ball_reaches_its_radius_below_and_aside() {
        let body = Body::new(&Cutter::mill(10.0, 5.0, 40.0));
        assert!(body.exact());
        assert!((body.height(&upright(), -Vec3::z()) - 0.0).abs() < 1e-12);
        assert!((body.height(&upright(), Vec3::x()) - 5.0).abs() < 1e-12);
        let n = Vec3::new(0.6, 0.0, -0.8);
        assert!((body.farthest(&upright(), n) - Vec3::new(3.0, 0.0, 1.0)).norm() < 1e-12);
    }

    #[test]
    fn a_bull_nose_touches_with_its_corner() {
        // The published case: d 20, r 3, plane normal (.6, 0, .8) touched at (-8.8, 0, .6).
        let body = Body::new(&Cutter::mill(20.0, 3.0, 40.0));
        let p = body.farthest(&upright(), -Vec3::new(0.6, 0.0, 0.8));
        assert!((p - Vec3::new(-8.8, 0.0, 0.6)).norm() < 1e-12);
    }

    #[test]
    fn a_conical_cutter_has_its_tangent_points() {
        let (d, r, a, b, h) = (20.0, 2.0, 10.0, 15.0, 50.0);
        let cutter = Cutter {
            diameter: d,
            corner_radius: r,
            e: 8.397_920_0,
            f: 3.511_633_0,
            alpha_deg: a,
            beta_deg: b,
            height: h,
        };
        let body = Body::new(&cutter);
        assert!((body.corners()[1].0 - 8.745_217).abs() < 1e-5);
        assert!((body.corners()[2].0 - 10.329_772).abs() < 1e-5);
        assert!((body.corners()[3].0 - 22.924_993).abs() < 1e-4);
    }
}
