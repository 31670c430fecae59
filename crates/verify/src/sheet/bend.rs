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

    fn raise(&mut self, other: &Self) {
        self.value = self.value.max(other.value);
        self.u = self.u.max(other.u);
        self.v = self.v.max(other.v);
        self.uu = self.uu.max(other.uu);
        self.uv = self.uv.max(other.uv);
        self.vv = self.vv.max(other.vv);
        self.uuu = self.uuu.max(other.uuu);
        self.uuv = self.uuv.max(other.uuv);
        self.uvv = self.uvv.max(other.uvv);
        self.vvv = self.vvv.max(other.vvv);
    }
}

/// Bounds over a Bezier patch, the value counted from its middle: derivatives lie in the hull of the
/// differences of the control points.
pub(crate) fn of_patch(patch: &Patch) -> Bend {
    let center = patch.point(0.5, 0.5);
    let (mut top, mut weight) = (Bend::default(), Bend::default());
    let mut least = f64::INFINITY;
    // Differences of order (k, l) along u and v.
    let difference = |i: usize, j: usize, k: usize, l: usize| {
        const ROWS: [[f64; 4]; 4] = [
            [1.0, 0.0, 0.0, 0.0],
            [-1.0, 1.0, 0.0, 0.0],
            [1.0, -2.0, 1.0, 0.0],
            [-1.0, 3.0, -3.0, 1.0],
        ];
        let (mut p, mut w) = (Vec3::zeros(), 0.0);
        for (b, cb) in ROWS[l].iter().enumerate().take(l + 1) {
            for (a, ca) in ROWS[k].iter().enumerate().take(k + 1) {
                let h = patch.net[j + b][i + a];
                p += (h.xyz() - center * h.w) * (ca * cb);
                w += h.w * ca * cb;
            }
        }
        (p.norm(), w.abs())
    };
    for j in 0..4 {
        for i in 0..4 {
            least = least.min(patch.net[j][i].w);
            let of = |k: usize, l: usize, factor: f64| {
                if i + k > 3 || j + l > 3 {
                    return (0.0, 0.0);
                }
                let (p, w) = difference(i, j, k, l);
                (p * factor, w * factor)
            };
            let all = [
                of(0, 0, 1.0),
                of(1, 0, 3.0),
                of(0, 1, 3.0),
                of(2, 0, 6.0),
                of(1, 1, 9.0),
                of(0, 2, 6.0),
                of(3, 0, 6.0),
                of(2, 1, 18.0),
                of(1, 2, 18.0),
                of(0, 3, 6.0),
            ];
            let bend = |pick: &dyn Fn(&(f64, f64)) -> f64| {
                let [value, u, v, uu, uv, vv, uuu, uuv, uvv, vvv] =
                    [0, 1, 2, 3, 4, 5, 6, 7, 8, 9].map(|k| pick(&all[k]));
                Bend { value, u, v, uu, uv, vv, uuu, uuv, uvv, vvv }
            };
            top.raise(&bend(&|x| x.0));
            weight.raise(&bend(&|x| x.1));
        }
    }
    if !patch.rational {
        weight = Bend::default();
    }
    top.over(&weight, least)
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
