//! Surfaces by one curve moved along another: REVOLV, RULED, TRANSL, SCALE, XYROT, YZROT, ZXROT.

use super::arc::{CubicArc, Vec4, weighted};
use super::curve::SpaceCurve;
use super::patch::Patch;
use super::surface::{SculptFault, Sculptured};
use super::whole;
use crate::{Vec3, trig};

/// How the second curve moves the points of the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Product {
    /// TRANSL: moves them.
    Transl,
    /// SCALE: multiplies them coordinate by coordinate.
    Scale,
    /// XYROT: turns and stretches x y as its own x y do (1, 0), and moves z.
    XyRot,
    /// YZROT likewise.
    YzRot,
    /// ZXROT likewise.
    ZxRot,
}

/// `first` along u, moved by the points of `second` along v.
pub fn cross_product(
    kind: Product,
    first: &SpaceCurve,
    second: &SpaceCurve,
) -> Result<Sculptured, SculptFault> {
    let mut patches = Vec::new();
    for d in &second.arcs {
        for p in &first.arcs {
            patches.push(Patch::new(d.b.map(|d| p.b.map(|p| moved(kind, p, d)))));
        }
    }
    Sculptured::grid(patches, first.arcs.len(), second.arcs.len())
}

/// Bilinear in both, so that control points are moved as points are.
fn moved(kind: Product, p: Vec4, d: Vec4) -> Vec4 {
    let w = p.w * d.w;
    let sum = |k: usize| p[k] * d.w + d[k] * p.w;
    let turned = |i: usize, j: usize| (p[i] * d[i] - p[j] * d[j], p[i] * d[j] + p[j] * d[i]);
    match kind {
        Product::Transl => Vec4::new(sum(0), sum(1), sum(2), w),
        Product::Scale => Vec4::new(p.x * d.x, p.y * d.y, p.z * d.z, w),
        Product::XyRot => {
            let (x, y) = turned(0, 1);
            Vec4::new(x, y, sum(2), w)
        }
        Product::YzRot => {
            let (y, z) = turned(1, 2);
            Vec4::new(sum(0), y, z, w)
        }
        Product::ZxRot => {
            let (z, x) = turned(2, 0);
            Vec4::new(x, sum(1), z, w)
        }
    }
}

/// RULED: straight lines between two curves of equally many arcs.
pub fn ruled(first: &SpaceCurve, second: &SpaceCurve) -> Result<Sculptured, SculptFault> {
    if first.arcs.len() != second.arcs.len() {
        return Err(SculptFault::WrongCount);
    }
    let pairs = first.arcs.iter().zip(&second.arcs);
    let patches = pairs.map(|(a, b)| {
        let row = |t: f64| core::array::from_fn(|i| a.b[i] * (1.0 - t) + b.b[i] * t);
        Patch::new([row(0.0), row(1.0 / 3.0), row(2.0 / 3.0), row(1.0)])
    });
    Sculptured::grid(patches.collect(), first.arcs.len(), 1)
}

/// RULED with AXIS: the cylinder over a curve, `reach` to both sides along `axis`.
pub fn swept(curve: &SpaceCurve, axis: Vec3, reach: f64) -> Result<Sculptured, SculptFault> {
    let by = axis.try_normalize(0.0).ok_or(SculptFault::NotFinite)? * reach;
    let shift = |v: Vec3| curve.transformed(&crate::Transform::translation(v));
    ruled(&shift(-by), &shift(by))
}

/// REVOLV: the curve turned about the axis through `origin` from the angle `from_deg` to `to_deg`, seen
/// from the axis' tip anticlockwise with `ccw`. Each span is an exact circle of at most 120 degrees; equal
/// angles make the whole turn.
pub fn revolve(
    curve: &SpaceCurve,
    origin: Vec3,
    axis: Vec3,
    [from_deg, to_deg]: [f64; 2],
    ccw: bool,
) -> Result<Sculptured, SculptFault> {
    let axis = axis.try_normalize(0.0).ok_or(SculptFault::NotFinite)?;
    let sense = if ccw { 1.0 } else { -1.0 };
    let turn = ((to_deg - from_deg) * sense) % 360.0;
    let turn = if turn <= 1e-9 { turn + 360.0 } else { turn };
    let spans = (turn / 120.0 - 1e-9).ceil().max(1.0);
    let step = sense * turn / spans;
    let mut patches = Vec::new();
    for k in 0..whole(spans) {
        let a = from_deg + step * k as f64;
        patches.extend(curve.arcs.iter().map(|arc| turned_patch(arc, origin, axis, [a, a + step])));
    }
    Sculptured::grid(patches, curve.arcs.len(), whole(spans))
}

fn turned_patch(arc: &CubicArc, origin: Vec3, axis: Vec3, [from, to]: [f64; 2]) -> Patch {
    let half = trig::cos_deg(0.5 * (to - from));
    let around = |h: Vec4| {
        let p = h.xyz() - origin * h.w;
        let along = axis * axis.dot(&p);
        let (x, y) = (p - along, axis.cross(&p));
        let place = |deg: f64, weight: f64| {
            // The corner of the tangents lies 1 / cos out, which its weight takes back.
            let r = x * trig::cos_deg(deg) + y * trig::sin_deg(deg);
            let q = (origin * h.w + along) * weight + r;
            Vec4::new(q.x, q.y, q.z, h.w * weight)
        };
        CubicArc::quadratic([place(from, 1.0), place(0.5 * (from + to), half), place(to, 1.0)]).b
    };
    let columns = arc.b.map(around);
    let mut net = [[weighted(Vec3::zeros(), 1.0); 4]; 4];
    for (i, column) in columns.iter().enumerate() {
        for (j, h) in column.iter().enumerate() {
            net[j][i] = *h;
        }
    }
    Patch::new(net)
}

#[cfg(test)]
mod tests {
    use super::super::spline::{SplinePoint, spline};
    use super::*;

    fn curve(p: &[[f64; 3]]) -> SpaceCurve {
        let p: Vec<_> = p.iter().map(|p| SplinePoint::plain(Vec3::from(*p))).collect();
        SpaceCurve::new(spline(&p).unwrap())
    }

    /// Surfaces S2 and S5 of TEST29.
    #[test]
    fn printed_revolution() {
        let c = curve(&[[0.0, 0.5, 0.0], [2.0, 1.0, 0.0], [3.0, 1.0, 0.0]]);
        let s = revolve(&c, Vec3::zeros(), Vec3::x(), [0.0, 360.0], true).unwrap();
        assert_eq!(s.spans().map(whole), [2, 3]);
        let p = s.at(1.0, 1.0);
        assert!((p.point - Vec3::new(2.0, -0.5, 0.866_03)).norm() < 1e-5);
        let n = s.at(0.0, 1.0).normal().unwrap();
        assert!((n - Vec3::new(0.395_84, 0.459_16, -0.795_29)).norm() < 1e-5, "{n}");
        let r = s.at(0.37, 2.2).point;
        assert!((trig::hypot(r.y, r.z) - c.at(0.37).point.y).abs() < 1e-14);
        let s = revolve(&c, Vec3::zeros(), Vec3::x(), [90.0, 270.0], false).unwrap();
        assert_eq!(s.spans().map(whole), [2, 2]);
        assert!((s.at(2.0, 1.0).point - Vec3::new(3.0, 1.0, 0.0)).norm() < 1e-14);
    }

    /// Corners of SS, SR and Y1 of TEST44.
    #[test]
    fn printed_products() {
        let profile = curve(&[[1.0, 0.0, 1.5], [1.0, 0.0, 2.0]]);
        let guide = curve(&[[1.0, 0.0, 0.0], [0.4, 0.4, 0.0], [0.0, 1.0, 0.0]]);
        let s = cross_product(Product::Transl, &profile, &guide).unwrap();
        let at = |s: &Sculptured, u, v| (s.at(u, v).point, s.at(u, v).normal().unwrap());
        let (p, n) = at(&s, 0.0, 0.0);
        assert!((p - Vec3::new(2.0, 0.0, 1.5)).norm() < 1e-15);
        assert!((n - Vec3::new(-0.393_92, -0.919_15, 0.0)).norm() < 1e-5, "{n}");
        let (p, n) = at(&cross_product(Product::XyRot, &profile, &guide).unwrap(), 1.0, 1.0);
        assert!((p - Vec3::new(0.4, 0.4, 2.0)).norm() < 1e-15);
        assert!((n + Vec3::new(0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.0)).norm() < 1e-12);
        let d = curve(&[[1.0, 1.0, 1.0], [2.0, 2.0, 2.0]]);
        let y = cross_product(Product::Scale, &curve(&[[0.0, -1.0, 2.0], [1.0, 0.0, 2.0]]), &d);
        assert!((y.unwrap().at(1.0, 1.0).point - Vec3::new(2.0, 0.0, 4.0)).norm() < 1e-15);
    }

    #[test]
    fn a_swept_curve_reaches_both_ways() {
        let c = curve(&[[0.0, 0.0, 1.0], [0.88, 0.6514, 1.0], [3.888, 1.738, 1.0]]);
        let s = swept(&c, Vec3::z() * 3.0, 10.0).unwrap();
        assert!((s.at(1.0, 0.0).point - Vec3::new(0.88, 0.6514, -9.0)).norm() < 1e-14);
        assert!((s.at(1.0, 1.0).point.z - 11.0).abs() < 1e-14);
    }
}
