//! One rational bicubic patch.

use core::ops::{Add, Mul, Sub};

use serde::{Deserialize, Serialize};

use super::arc::{CubicArc, Vec4, carry};
use super::pair::Pair;
use crate::surface::Shape;
use crate::{Transform, Vec3};

/// A rational bicubic patch by its sixteen homogeneous control points, `net[j][i]` with i along u and j
/// along v, parameters 0 to 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Patch {
    /// Control points.
    pub net: [[Vec4; 4]; 4],
    /// Do the weights differ?
    pub rational: bool,
}

/// A place on a surface with its derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Derivatives {
    /// The point.
    pub point: Vec3,
    /// By u.
    pub u: Vec3,
    /// By v.
    pub v: Vec3,
    /// Twice by u.
    pub uu: Vec3,
    /// By u and v.
    pub uv: Vec3,
    /// Twice by v.
    pub vv: Vec3,
}

impl Derivatives {
    /// Unit normal along u x v, `None` where the two derivatives are parallel or vanish.
    pub fn normal(&self) -> Option<Vec3> {
        let n = self.u.cross(&self.v);
        let size = n.norm();
        (size > 1e-12 * self.u.norm() * self.v.norm() && size > 0.0).then(|| n / size)
    }

    /// First and second fundamental forms, the second against the unit normal `n`: [g11, g12, g22],
    /// [d11, d12, d22].
    pub fn forms(&self, n: Vec3) -> ([f64; 3], [f64; 3]) {
        (
            [self.u.dot(&self.u), self.u.dot(&self.v), self.v.dot(&self.v)],
            [self.uu.dot(&n), self.uv.dot(&n), self.vv.dot(&n)],
        )
    }

    /// Principal curvatures, the greater first, positive when the surface is hollow on the side of `n`.
    ///
    /// APT: `CURCAL`. `None` where the derivatives are parallel.
    pub fn curvatures(&self, n: Vec3) -> Option<[f64; 2]> {
        let ([g11, g12, g22], [d11, d12, d22]) = self.forms(n);
        let a = g11 * g22 - g12 * g12;
        if a <= 1e-24 * g11 * g22 || a <= 0.0 {
            return None;
        }
        let mean = 0.5 * (d11 * g22 - 2.0 * d12 * g12 + d22 * g11) / a;
        let gauss = (d11 * d22 - d12 * d12) / a;
        let root = (mean * mean - gauss).max(0.0).sqrt();
        Some([mean + root, mean - root])
    }

    /// Normal curvature along the tangent direction nearest to `w`, positive when hollow on the side of
    /// `n`. `None` when `w` stands on the surface or the derivatives are parallel.
    ///
    /// APT: `MIDKUR`.
    pub fn curvature_along(&self, n: Vec3, w: Vec3) -> Option<f64> {
        let [a, b] = self.components(w)?;
        let ([g11, g12, g22], [d11, d12, d22]) = self.forms(n);
        let first = g11 * a * a + 2.0 * g12 * a * b + g22 * b * b;
        let second = d11 * a * a + 2.0 * d12 * a * b + d22 * b * b;
        (first > 0.0).then(|| second / first)
    }

    /// Components of `w`, laid into the tangent plane, along the derivatives.
    ///
    /// APT: `ALGO1` takes the step towards a point this way.
    pub fn components(&self, w: Vec3) -> Option<[f64; 2]> {
        let (g11, g12, g22) = (self.u.dot(&self.u), self.u.dot(&self.v), self.v.dot(&self.v));
        let det = g11 * g22 - g12 * g12;
        if det <= 1e-24 * g11 * g22 || det <= 0.0 {
            return None;
        }
        let (p, q) = (w.dot(&self.u), w.dot(&self.v));
        Some([(p * g22 - q * g12) / det, (q * g11 - p * g12) / det])
    }

    /// Curvature as the gap solver takes it: second derivatives of the distance from the surface.
    pub fn shape(&self, n: Vec3) -> Option<Shape> {
        let frame = crate::surface::frame_about(n);
        let [a, b] = [self.components(frame[0])?, self.components(frame[1])?];
        let (_, [d11, d12, d22]) = self.forms(n);
        let of = |p: [f64; 2], q: [f64; 2]| {
            -(d11 * p[0] * q[0] + d12 * (p[0] * q[1] + p[1] * q[0]) + d22 * p[1] * q[1])
        };
        Some(Shape { frame, k: [of(a, a), of(a, b), of(b, b)] })
    }

    /// Of a place on a border those so far beyond it by both parameters, where the surface goes on straight; the third ones are by
    /// u, u, v and by u, v, v. Along a border it bends as that does, and by how much the slope across it does farther out.
    pub(crate) fn beyond(&self, s: f64, t: f64, [uuv, uvv]: [Vec3; 2]) -> Self {
        Self {
            point: self.point + self.u * s + self.v * t + self.uv * (s * t),
            u: self.u + self.uv * t,
            v: self.v + self.uv * s,
            uu: if s == 0.0 { self.uu + uuv * t } else { Vec3::zeros() },
            uv: self.uv,
            vv: if t == 0.0 { self.vv + uvv * s } else { Vec3::zeros() },
        }
    }

    /// The same place when u and v run `a` and `b` times as fast.
    #[must_use]
    #[inline(always)]
    pub fn rated(self, a: f64, b: f64) -> Self {
        Self {
            point: self.point,
            u: self.u * a,
            v: self.v * b,
            uu: self.uu * (a * a),
            uv: self.uv * (a * b),
            vv: self.vv * (b * b),
        }
    }
}

impl Patch {
    /// From control points; the weights must be positive.
    pub fn new(net: [[Vec4; 4]; 4]) -> Self {
        let w = net[0][0].w;
        let rational = net.iter().flatten().any(|h| (h.w - w).abs() > 1e-15 * w.abs());
        Self { net, rational }
    }

    /// From corner points, tangents along u, tangents along v and twists: rows P(v=0), P(v=1), V(v=0),
    /// V(v=1), in each P(u=0), P(u=1), U(u=0), U(u=1).
    pub fn hermite(rows: [[Vec3; 4]; 4]) -> Self {
        // Points have weight 1, derivatives 0.
        let with = |p: Vec3, w: f64| Vec4::new(p.x, p.y, p.z, w);
        let of =
            |r: [Vec3; 4], w: f64| [with(r[0], w), with(r[1], w), with(r[2], 0.0), with(r[3], 0.0)];
        let [a, b, c, d] = rows;
        Self::homogeneous_hermite([of(a, 1.0), of(b, 1.0), of(c, 0.0), of(d, 0.0)])
    }

    /// The same in homogeneous coordinates.
    pub fn homogeneous_hermite(rows: [[Vec4; 4]; 4]) -> Self {
        let arcs = rows.map(|[a, b, s, t]| CubicArc::homogeneous(a, b, s, t).b);
        let mut net = [[Vec4::zeros(); 4]; 4];
        for i in 0..4 {
            let along = CubicArc::homogeneous(arcs[0][i], arcs[1][i], arcs[2][i], arcs[3][i]);
            for (row, b) in net.iter_mut().zip(along.b) {
                row[i] = b;
            }
        }
        Self::new(net)
    }

    /// Point and derivatives at (u, v); outside 0 to 1 the same polynomials go on.
    pub fn at(&self, u: f64, v: f64) -> Derivatives {
        if !self.rational {
            let w = self.net[0][0].w;
            let [point, u, v, uu, uv, vv] = self.plain(u, v);
            #[expect(clippy::float_cmp, reason = "most weights are 1 exactly, and change nothing")]
            if w == 1.0 {
                return Derivatives { point, u, v, uu, uv, vv };
            }
            let w = 1.0 / w;
            return Derivatives {
                point: point * w,
                u: u * w,
                v: v * w,
                uu: uu * w,
                uv: uv * w,
                vv: vv * w,
            };
        }
        let [h, hu, hv, huu, huv, hvv] = self.weighted(u, v);
        let w = h.w;
        let point = h.xyz() / w;
        let u = (hu.xyz() - point * hu.w) / w;
        let v = (hv.xyz() - point * hv.w) / w;
        Derivatives {
            point,
            u,
            v,
            uu: (huu.xyz() - u * (2.0 * hu.w) - point * huu.w) / w,
            uv: (huv.xyz() - u * hv.w - v * hu.w - point * huv.w) / w,
            vv: (hvv.xyz() - v * (2.0 * hv.w) - point * hvv.w) / w,
        }
    }

    /// The third derivatives by u, u, v and by u, v, v at (u, v), where the others are `d`.
    pub(super) fn thirds(&self, d: &Derivatives, u: f64, v: f64) -> [Vec3; 2] {
        let rows = self.net.map(|row| cubic(row, u));
        let across = |n: usize| cubic(rows.map(|r| r[n]), v);
        let [[h, hv, hvv], [hu, huv, huvv], [huu, huuv, _]] = [across(0), across(1), across(2)];
        // The derivatives of `w S = H`.
        let uuv = d.v * huu.w + (d.u * huv.w + d.uv * hu.w) * 2.0 + d.uu * hv.w;
        let uvv = d.u * hvv.w + (d.v * huv.w + d.uv * hv.w) * 2.0 + d.vv * hu.w;
        let left = |third: Vec4, known: Vec3| (third.xyz() - d.point * third.w - known) / h.w;
        [left(huuv, uuv), left(huvv, uvv)]
    }

    /// Point and first derivatives at (u, v), for less than all.
    pub fn tangents(&self, u: f64, v: f64) -> (Vec3, Vec3, Vec3) {
        if !self.rational {
            let w = 1.0 / self.net[0][0].w;
            let [point, u, v, ..] = self.plain(u, v);
            return (point * w, u * w, v * w);
        }
        let [h, hu, hv, ..] = self.weighted(u, v);
        let w = 1.0 / h.w;
        let point = h.xyz() * w;
        (point, (hu.xyz() - point * hu.w) * w, (hv.xyz() - point * hv.w) * w)
    }

    /// The weighted point and its derivatives by u, v, uu, uv and vv.
    #[inline(always)]
    fn weighted(&self, u: f64, v: f64) -> [Vec4; 6] {
        let xy = both(self.along(u, xy), v);
        let zw = both(self.along(u, zw), v);
        let at = |n: usize| Vec4::new(xy[n].0, xy[n].1, zw[n].0, zw[n].1);
        [at(0), at(1), at(2), at(3), at(4), at(5)]
    }

    /// The same where all weights are one number: that number is left out.
    #[inline(always)]
    fn plain(&self, u: f64, v: f64) -> [Vec3; 6] {
        let xy = both(self.along(u, xy), v);
        // Two rows at a time, then value and slope of each.
        let [near, far] = [self.rows(0, u), self.rows(2, u)];
        let along = |n: usize| [near[n].0, near[n].1, far[n].0, far[n].1];
        let ([a, b, c, d], [au, bu, cu, du]) = (along(0), along(1));
        let [z, zv, zvv] = cubic([Pair(a, au), Pair(b, bu), Pair(c, cu), Pair(d, du)], v);
        let [zuu, ..] = cubic(along(2), v);
        let at = |n: usize, z: f64| Vec3::new(xy[n].0, xy[n].1, z);
        [at(0, z.0), at(1, z.1), at(2, zv.0), at(3, zuu), at(4, zv.1), at(5, zvv.0)]
    }

    /// Two coordinates of the rows along u: value and two derivatives of each.
    #[inline(always)]
    fn along(&self, u: f64, pair: impl Fn(&Vec4) -> Pair) -> [[Pair; 3]; 4] {
        let row = |[a, b, c, d]: &[Vec4; 4]| cubic([pair(a), pair(b), pair(c), pair(d)], u);
        let [a, b, c, d] = &self.net;
        [row(a), row(b), row(c), row(d)]
    }

    /// The heights of two rows.
    #[inline(always)]
    fn rows(&self, j: usize, u: f64) -> [Pair; 3] {
        let (a, b) = (&self.net[j], &self.net[j + 1]);
        let z = |i: usize| Pair(a[i].z, b[i].z);
        cubic([z(0), z(1), z(2), z(3)], u)
    }

    /// The point at (u, v).
    pub fn point(&self, u: f64, v: f64) -> Vec3 {
        self.at(u, v).point
    }

    /// The part over `u[0]..u[1]` and `v[0]..v[1]`.
    #[must_use]
    pub fn part(&self, u: [f64; 2], v: [f64; 2]) -> Self {
        let rows = self.net.map(|b| CubicArc { b }.part(u[0], u[1]).b);
        let mut net = [[Vec4::zeros(); 4]; 4];
        for i in 0..4 {
            let b = [rows[0][i], rows[1][i], rows[2][i], rows[3][i]];
            let along = CubicArc { b }.part(v[0], v[1]).b;
            for (row, b) in net.iter_mut().zip(along) {
                row[i] = b;
            }
        }
        Self { net, rational: self.rational }
    }

    /// The patch carried by `m`.
    #[must_use]
    pub fn transformed(&self, m: &Transform) -> Self {
        Self { net: self.net.map(|r| r.map(|h| carry(h, m))), rational: self.rational }
    }

    /// With u and v exchanged.
    #[must_use]
    pub fn exchanged(&self) -> Self {
        let net = core::array::from_fn(|j| core::array::from_fn(|i| self.net[i][j]));
        Self { net, rational: self.rational }
    }

    /// Is its first or last border of u (0) or v (1) one point, but for rounding? From there it does not go on.
    pub fn ends_in_point(&self, axis: usize, end: usize) -> bool {
        let at = |k: usize, border: usize| {
            let h = if axis == 0 { self.net[k][border] } else { self.net[border][k] };
            h.xyz() / h.w
        };
        let wide = |border: usize| {
            (1..4).map(|k| (at(k, border) - at(0, border)).norm()).fold(0.0, f64::max)
        };
        wide(3 * end) <= 1e-13 * (wide(3 - 3 * end) + at(0, 3 * end).norm())
    }

    /// Least and greatest coordinates of the control points: a box that holds the patch.
    pub fn bounds(&self) -> [Vec3; 2] {
        let mut b = [Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY)];
        for h in self.net.iter().flatten() {
            let p = h.xyz() / h.w;
            b = [b[0].inf(&p), b[1].sup(&p)];
        }
        b
    }
}

#[inline(always)]
fn xy(h: &Vec4) -> Pair {
    Pair(h.x, h.y)
}

#[inline(always)]
fn zw(h: &Vec4) -> Pair {
    Pair(h.z, h.w)
}

/// The value and its derivatives by u, v, uu, uv and vv from what four rows along u show, value and two derivatives each.
#[inline(always)]
fn both([a, b, c, d]: [[Pair; 3]; 4], v: f64) -> [Pair; 6] {
    let along = |n: usize| cubic([a[n], b[n], c[n], d[n]], v);
    let (s, su, suu) = (along(0), along(1), along(2));
    [s[0], su[0], s[1], suu[0], su[1], s[2]]
}

/// Value and first two derivatives at `t` of the cubic with these control points, by de Casteljau's scheme.
#[inline(always)]
fn cubic<T>([a, b, c, d]: [T; 4], t: f64) -> [T; 3]
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
{
    // The ways from point to point, twice more from each to the next, and at last the way on which the place lies.
    let [ab, bc, cd] = [b - a, c - b, d - c];
    let [near, far] = [ab + (bc - ab) * t, bc + (cd - bc) * t];
    let way = near + (far - near) * t;
    [a + (ab + near + way) * t, way * 3.0, (far - near) * 6.0]
}

#[cfg(test)]
pub(crate) mod tests {
    use super::super::arc::weighted;
    use super::*;
    use proptest::prelude::*;

    /// A patch over 60 x 60 with random heights and weights.
    pub(crate) fn random(z: [f64; 16], w: [f64; 16]) -> Patch {
        Patch::new(core::array::from_fn(|j| {
            core::array::from_fn(|i| {
                let k = 4 * j + i;
                let p = Vec3::new(20.0 * i as f64, 20.0 * j as f64, 10.0 * z[k]);
                weighted(p, 1.0 + 0.5 * w[k])
            })
        }))
    }

    proptest! {
        #[test]
        fn derivatives_by_differences(
            z in prop::array::uniform16(-1.0_f64..1.0), w in prop::array::uniform16(-1.0_f64..1.0),
            u in 0.1_f64..0.9, v in 0.1_f64..0.9,
        ) {
            let p = random(z, w);
            let (d, h) = (p.at(u, v), 1e-5);
            let (f, b) = (p.at(u + h, v), p.at(u - h, v));
            prop_assert!(((f.point - b.point) / (2.0 * h) - d.u).norm() < 1e-5);
            let (point, along, across) = p.tangents(u, v);
            prop_assert!((point - d.point).norm() < 1e-12);
            prop_assert!((along - d.u).norm() < 1e-10 && (across - d.v).norm() < 1e-10);
            prop_assert!(((f.u - b.u) / (2.0 * h) - d.uu).norm() < 1e-4);
            prop_assert!(((f.v - b.v) / (2.0 * h) - d.uv).norm() < 1e-4);
            let (f, b) = (p.at(u, v + h), p.at(u, v - h));
            prop_assert!(((f.point - b.point) / (2.0 * h) - d.v).norm() < 1e-5);
            prop_assert!(((f.v - b.v) / (2.0 * h) - d.vv).norm() < 1e-4);
            let q = p.part([0.25, 0.75], [0.1, 0.9]);
            prop_assert!((q.point(0.5, 0.5) - p.point(0.5, 0.5)).norm() < 1e-12);
            let [lo, hi] = p.bounds();
            prop_assert!(d.point.inf(&lo) == lo && d.point.sup(&hi) == hi);
        }
    }

    #[test]
    fn published_curvatures() {
        // z = x y at (1, 1).
        let d = Derivatives {
            point: Vec3::new(1.0, 1.0, 1.0),
            u: Vec3::new(1.0, 0.0, 1.0),
            v: Vec3::new(0.0, 1.0, 1.0),
            uv: Vec3::z(),
            ..Derivatives::default()
        };
        let n = d.normal().unwrap();
        let [a, b] = d.curvatures(n).unwrap();
        assert!((a - 0.192_450_1).abs() < 1e-7 && (b + 0.577_350_3).abs() < 1e-7);
        let s = d.shape(n).unwrap();
        let trace = s.k[0] + s.k[2];
        assert!((trace + a + b).abs() < 1e-14);
        assert_eq!(Derivatives::default().curvatures(Vec3::z()), None);
    }
}
