//! Bounds of derivatives: how the norms of a quotient's derivatives follow from those of its parts.

use aptc_geometry::Vec3;
use aptc_geometry::sculpt::Patch;

/// Greatest norms over a cell: value, u, v, uu, uv, vv, uuu, uuv, uvv, vvv.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bend {
    pub(crate) value: f64,
    pub(crate) u: f64,
    pub(crate) v: f64,
    pub(crate) uu: f64,
    pub(crate) uv: f64,
    pub(crate) vv: f64,
    pub(crate) uuu: f64,
    pub(crate) uuv: f64,
    pub(crate) uvv: f64,
    pub(crate) vvv: f64,
}

impl Bend {
    /// Bounds of `self / d` where `d` is nowhere below `least`.
    pub(crate) fn over(&self, d: &Self, least: f64) -> Self {
        let value = self.value / least;
        let u = (self.u + value * d.u) / least;
        let v = (self.v + value * d.v) / least;
        let uu = (self.uu + 2.0 * u * d.u + value * d.uu) / least;
        let vv = (self.vv + 2.0 * v * d.v + value * d.vv) / least;
        let uv = (self.uv + u * d.v + v * d.u + value * d.uv) / least;
        let uuv = self.uuv + 2.0 * (uv * d.u + u * d.uv) + v * d.uu + uu * d.v + value * d.uuv;
        let uvv = self.uvv + 2.0 * (uv * d.v + v * d.uv) + u * d.vv + vv * d.u + value * d.uvv;
        let uuu = self.uuu + 3.0 * (uu * d.u + u * d.uu) + value * d.uuu;
        let vvv = self.vvv + 3.0 * (vv * d.v + v * d.vv) + value * d.vvv;
        let [uuu, uuv, uvv, vvv] = [uuu, uuv, uvv, vvv].map(|x| x / least);
        Self { value, u, v, uu, uv, vv, uuu, uuv, uvv, vvv }
    }

    /// The same when u and v run `a` and `b` times as fast.
    pub(crate) fn rated(&self, a: f64, b: f64) -> Self {
        Self {
            value: self.value,
            u: self.u * a,
            v: self.v * b,
            uu: self.uu * a * a,
            uv: self.uv * a * b,
            vv: self.vv * b * b,
            uuu: self.uuu * a * a * a,
            uuv: self.uuv * a * a * b,
            uvv: self.uvv * a * b * b,
            vvv: self.vvv * b * b * b,
        }
    }
}

/// Bounds over a Bezier patch, the value counted from its middle: derivatives lie in the hull of the
/// differences of the control points.
pub(crate) fn of_patch(patch: &Patch) -> Bend {
    let center = patch.point(0.5, 0.5);
    let (mut net, mut weights) = ([[Vec3::zeros(); 4]; 4], [[0.0; 4]; 4]);
    let mut least = f64::INFINITY;
    for (j, row) in patch.net.iter().enumerate() {
        for (i, h) in row.iter().enumerate() {
            (net[j][i], weights[j][i]) = (h.xyz() - center * h.w, h.w);
            least = least.min(h.w);
        }
    }
    let top = greatest(net, |p| p.norm_squared());
    let weight = if patch.rational { greatest(weights, |w| w * w) } else { Bend::default() };
    top.over(&weight, least)
}

/// The greatest derivatives by the differences of a net, `square` being the square of the norm.
fn greatest<T: Copy + core::ops::Sub<Output = T>>(
    net: [[T; 4]; 4],
    square: impl Fn(&T) -> f64,
) -> Bend {
    // Of what is in so many columns and rows of a net.
    let most = |net: &[[T; 4]; 4], [columns, rows]: [usize; 2], factor: f64| {
        let all = net[..rows].iter().flat_map(|row| &row[..columns]);
        factor * all.map(&square).fold(0.0, f64::max).sqrt()
    };
    let by_u = |mut net: [[T; 4]; 4]| {
        for row in &mut net {
            (row[0], row[1], row[2]) = (row[1] - row[0], row[2] - row[1], row[3] - row[2]);
        }
        net
    };
    let by_v = |mut net: [[T; 4]; 4]| {
        for j in 0..3 {
            let next = net[j + 1];
            net[j].iter_mut().zip(next).for_each(|(x, y)| *x = y - *x);
        }
        net
    };
    let (u, v) = (by_u(net), by_v(net));
    let (uu, uv, vv) = (by_u(u), by_v(u), by_v(v));
    let (uuu, uuv, uvv, vvv) = (by_u(uu), by_v(uu), by_v(uv), by_v(vv));
    Bend {
        value: most(&net, [4, 4], 1.0),
        u: most(&u, [3, 4], 3.0),
        v: most(&v, [4, 3], 3.0),
        uu: most(&uu, [2, 4], 6.0),
        uv: most(&uv, [3, 3], 9.0),
        vv: most(&vv, [4, 2], 6.0),
        uuu: most(&uuu, [1, 4], 6.0),
        uuv: most(&uuv, [2, 3], 18.0),
        uvv: most(&uvv, [3, 2], 18.0),
        vvv: most(&vvv, [4, 1], 6.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::sculpt::Vec4;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn derivatives_stay_below_their_bounds(
            z in prop::array::uniform16(-1.0_f64..1.0), w in prop::array::uniform16(0.4_f64..1.5),
            rational: bool, u in 0.01_f64..0.99, v in 0.01_f64..0.99,
        ) {
            let patch = Patch::new(core::array::from_fn(|j| core::array::from_fn(|i| {
                let k = 4 * j + i;
                let w = if rational { w[k] } else { 1.0 };
                Vec4::new(3.0 * i as f64 * w, 2.0 * j as f64 * w, z[k] * w, w)
            })));
            let bend = of_patch(&patch);
            let d = patch.at(u, v);
            let h = 1e-5;
            let uuv = (patch.at(u, v + h).uu - patch.at(u, v - h).uu) / (2.0 * h);
            let uvv = (patch.at(u + h, v).vv - patch.at(u - h, v).vv) / (2.0 * h);
            let uuu = (patch.at(u + h, v).uu - patch.at(u - h, v).uu) / (2.0 * h);
            let vvv = (patch.at(u, v + h).vv - patch.at(u, v - h).vv) / (2.0 * h);
            for (x, top) in [
                (d.u, bend.u), (d.v, bend.v), (d.uu, bend.uu), (d.uv, bend.uv), (d.vv, bend.vv),
                (uuv, bend.uuv), (uvv, bend.uvv), (uuu, bend.uuu), (vvv, bend.vvv),
            ] {
                prop_assert!(x.norm() <= top * (1.0 + 1e-9) + 1e-5, "{} {top}", x.norm());
            }
        }
    }
}
