//! Exact signed distance of a point to the profile.

use crate::Vec2;
use crate::profile::{Profile, Segment, cross};

/// The place of a profile nearest to a point of the half plane.
#[derive(Clone, Copy, Debug)]
pub struct Near {
    /// Signed distance, negative inside.
    pub distance: f64,
    /// Unit gradient of the distance: away from the axis, up.
    pub normal: [f64; 2],
    /// Nearest profile point: distance from the axis, height.
    pub point: [f64; 2],
    /// Second derivative of the distance across the gradient in the half plane, at the given point.
    pub bend: f64,
    /// Where the nearest point lies.
    pub segment: Segment,
}

impl Profile {
    /// Signed distance of the point at `rho` from the axis and height `z`.
    ///
    /// Convex in (rho, z), and with rho the distance from the axis convex in space; slope 1 everywhere.
    /// A solid without thickness (point tool, disk) has no inside.
    #[inline]
    pub fn near(&self, rho: f64, z: f64) -> Near {
        let x = Vec2::new(rho, z);
        let w = x - self.c;
        let (l, u) = (self.nl.dot(&(x - self.tip)), self.nu.dot(&(x - self.pu)));
        let t = z - self.rim.y;
        let in_arc = self.in_arc(w);
        if in_arc {
            let away = w.norm();
            if away >= self.r && away > 0.0 {
                let n = w / away;
                return self.made(away - self.r, n, self.c + n * self.r, 1.0 / away, Segment::Arc);
            }
        }
        if l > 0.0 || u > 0.0 || t > 0.0 {
            return self.outside(x, l, u, t);
        }
        // Inside the distance to the boundary is the distance to the nearest supporting line.
        let mut best = (t, Vec2::new(0.0, 1.0), Segment::Top);
        if l > best.0 {
            best = (l, self.nl, Segment::LowerLine);
        }
        if u > best.0 {
            best = (u, self.nu, Segment::UpperLine);
        }
        if in_arc && self.r > 0.0 {
            let away = w.norm();
            if away - self.r > best.0 && away > 0.0 {
                let n = w / away;
                return self.made(away - self.r, n, self.c + n * self.r, 1.0 / away, Segment::Arc);
            }
        }
        let (d, n, segment) = best;
        self.made(d, n, x - n * d, 0.0, segment)
    }

    #[inline]
    fn made(&self, distance: f64, n: Vec2, p: Vec2, bend: f64, segment: Segment) -> Near {
        Near { distance, normal: [n.x, n.y], point: [p.x, p.y], bend, segment }
    }

    /// Outside and not facing the arc: the nearest of lower line, upper line and top.
    #[inline]
    fn outside(&self, x: Vec2, l: f64, u: f64, t: f64) -> Near {
        if t > 0.0 && x.x <= self.rim.x {
            let p = Vec2::new(x.x, self.rim.y);
            return self.made(t, Vec2::new(0.0, 1.0), p, 0.0, Segment::Top);
        }
        let tl = Vec2::new(-self.nl.y, self.nl.x);
        let s = (x - self.tip).dot(&tl);
        let end = (self.pl - self.tip).dot(&tl);
        if l > 0.0 && s >= 0.0 && s <= end {
            return self.made(l, self.nl, x - self.nl * l, 0.0, Segment::LowerLine);
        }
        let tu = Vec2::new(-self.nu.y, self.nu.x);
        let s = (x - self.pu).dot(&tu);
        let end = (self.rim - self.pu).dot(&tu);
        if u > 0.0 && s >= 0.0 && s <= end {
            return self.made(u, self.nu, x - self.nu * u, 0.0, Segment::UpperLine);
        }
        let mut best = (self.tip, Segment::Tip);
        let mut square = (x - self.tip).norm_squared();
        for (p, segment) in [
            (self.pl, Segment::LowerPoint),
            (self.pu, Segment::UpperPoint),
            (self.rim, Segment::Rim),
        ] {
            let d = (x - p).norm_squared();
            if d < square {
                square = d;
                best = (p, segment);
            }
        }
        let (p, segment) = best;
        let away = square.sqrt();
        if away > 0.0 {
            return self.made(away, (x - p) / away, p, 1.0 / away, segment);
        }
        let n = self.edge_normal(segment);
        self.made(0.0, n, p, f64::INFINITY, segment)
    }

    /// A normal inside the normal cone of a vertex.
    fn edge_normal(&self, segment: Segment) -> Vec2 {
        let (a, b) = match segment {
            Segment::Tip => (Vec2::new(0.0, -1.0), self.nl),
            Segment::LowerPoint | Segment::LowerLine => (self.nl, self.a0),
            Segment::Arc => (self.a0, self.a1),
            Segment::UpperPoint | Segment::UpperLine => (self.a1, self.nu),
            Segment::Rim | Segment::Top => (self.nu, Vec2::new(0.0, 1.0)),
        };
        let m = a + b;
        let s = m.norm();
        if s > 1e-9 { m / s } else { Vec2::new(-a.y, a.x) * 1.0_f64.copysign(cross(a, b)) }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::Cutter;
    use proptest::prelude::*;

    /// Cutters of all shapes, by numbers in 0..1.
    pub(crate) fn cutter(kind: usize, s: [f64; 4]) -> Cutter {
        let d = 1.0 + 20.0 * s[0];
        let r = 0.5 * d * s[1];
        let h = 1.5 * d + 10.0 * s[2];
        let tangent = |alpha_deg: f64, beta_deg: f64, r: f64| {
            let (ca, sa) = (crate::trig::cos_deg(alpha_deg), crate::trig::sin_deg(alpha_deg));
            let (cb, sb) = (crate::trig::cos_deg(beta_deg), crate::trig::sin_deg(beta_deg));
            // f cos a - e sin a = r; cos b (d/2 - e) + sin b (f - d/2 tan a) = r
            let rhs = r - cb * d / 2.0 + sb * d / 2.0 * sa / ca;
            let det = -sa * sb + ca * cb;
            let e = (r * sb - ca * rhs) / det;
            let f = (-sa * rhs + cb * r) / det;
            Cutter { diameter: d, corner_radius: r, e, f, alpha_deg, beta_deg, height: h }
        };
        match kind {
            0 => Cutter::mill(d, d / 2.0, h),
            1 => Cutter::mill(d, 0.0, h),
            2 => Cutter::mill(d, r, h),
            3 => tangent(30.0 * s[3], 20.0 * s[2], 0.3 * r),
            4 => tangent(40.0 * s[3], 0.0, 0.0),
            5 => Cutter { height: 0.8 * d, ..tangent(10.0 * s[3], -20.0 * s[2], 0.3 * r) },
            6 => Cutter::mill(0.0, 0.0, h),
            _ => Cutter { f: 0.7 * r, ..Cutter::mill(d, r, h) },
        }
    }

    /// Distance to the closed outline by brute force, negative when all supporting lines are outside.
    fn brute(p: &Profile, rho: f64, z: f64) -> f64 {
        let x = Vec2::new(rho, z);
        let n = 20_000;
        let mut outline = Vec::new();
        let mut line = |a: Vec2, b: Vec2| {
            for i in 0..=n {
                outline.push(a + (b - a) * (f64::from(i) / f64::from(n)));
            }
        };
        line(p.tip, p.pl);
        line(p.pu, p.rim);
        line(p.rim, Vec2::new(0.0, p.rim.y));
        let (from, to) = (crate::trig::atan2(p.a0.y, p.a0.x), crate::trig::atan2(p.a1.y, p.a1.x));
        for i in 0..=n {
            let (s, c) = crate::trig::sin_cos(from + (to - from) * f64::from(i) / f64::from(n));
            outline.push(p.c + Vec2::new(c, s) * p.r);
        }
        let near = outline.iter().map(|q| (q - x).norm()).fold(f64::INFINITY, f64::min);
        let inside = p.radius_at(z).is_some_and(|r| r > rho);
        if inside { -near } else { near }
    }

    #[test]
    fn published_distances() {
        let p = Profile::new(&Cutter::mill(20.0, 3.0, 60.0)).unwrap();
        let n = p.near(11.0, 0.0);
        assert!((n.point[0] - 9.4).abs() < 1e-14 && (n.point[1] - 1.2).abs() < 1e-14);
        assert!((n.normal[0] - 0.8).abs() < 1e-15 && (n.normal[1] + 0.6).abs() < 1e-15);
        assert!((n.distance - 2.0).abs() < 1e-14);
        // Depths of the interference document: 3 - sqrt 5, 1, 1, -2.
        for (rho, z, depth) in [
            (8.0, 1.0, 3.0 - 5.0_f64.sqrt()),
            (2.0, 1.0, 1.0),
            (9.0, 30.0, 1.0),
            (12.0, 30.0, -2.0),
        ] {
            assert!((p.near(rho, z).distance + depth).abs() < 1e-14, "{rho} {z}");
        }
        let ball = Profile::new(&Cutter::mill(10.0, 5.0, 20.0)).unwrap();
        assert!((ball.near(0.0, 1.0).distance + 1.0).abs() < 1e-15);
        let n = ball.near(0.0, -100.0);
        assert_eq!((n.point, n.normal), ([0.0, 0.0], [0.0, -1.0]));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn agrees_with_brute_force(
            kind in 0_usize..8, s in prop::array::uniform4(0.05_f64..0.95),
            rho in 0.0_f64..20.0, z in -15.0_f64..60.0,
        ) {
            let p = Profile::new(&cutter(kind, s)).unwrap();
            let n = p.near(rho, z);
            let b = brute(&p, rho, z);
            prop_assert!((n.distance - b).abs() < 4e-3 * (1.0 + b.abs()).min(2.0), "{:?} {}", n, b);
        }

        #[test]
        fn convex_with_slope_one(
            kind in 0_usize..8, s in prop::array::uniform4(0.05_f64..0.95),
            a in prop::array::uniform2(-25.0_f64..25.0), b in prop::array::uniform2(-25.0_f64..25.0),
        ) {
            let p = Profile::new(&cutter(kind, s)).unwrap();
            // Across the axis too: there the distance is that of the mirrored profile.
            let at = |x: f64, z: f64| p.near(x.abs(), z + 10.0).distance;
            let (fa, fb) = (at(a[0], a[1]), at(b[0], b[1]));
            let apart = crate::trig::hypot(a[0] - b[0], a[1] - b[1]);
            let mid = at(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]));
            prop_assert!(mid <= 0.5 * (fa + fb) + 1e-12 * (1.0 + apart));
            prop_assert!((fa - fb).abs() <= apart * (1.0 + 1e-12) + 1e-13);
            // The gradient is the one of finite differences.
            let n = p.near(a[0].abs(), a[1] + 10.0);
            prop_assert!((crate::trig::hypot(n.normal[0], n.normal[1]) - 1.0).abs() < 1e-12);
            let sign = if a[0] < 0.0 { -1.0 } else { 1.0 };
            let linear = fa + (b[0] - a[0]) * sign * n.normal[0] + (b[1] - a[1]) * n.normal[1];
            prop_assert!(fb >= linear - 1e-12 * (1.0 + apart), "{} {}", fb, linear);
        }
    }
}
