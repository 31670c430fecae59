//! A cell of a patch without weights by the powers of its parameters: looked at so often that it is worth to be made ready.

use core::ops::{Add, Mul};

use aptc_geometry::Vec3;
use aptc_geometry::sculpt::{Derivatives, Pair, Patch};

use crate::each::two;

/// What stands before the powers of u and v from the middle of the cell.
#[derive(Clone, Debug)]
pub(super) struct Powers {
    middle: [f64; 2],
    /// The first two coordinates: by the power of v, by that of u.
    xy: [[Pair; 4]; 4],
    /// The third of two powers of v side by side.
    z: [[Pair; 4]; 2],
}

impl Powers {
    /// Of a patch the parameters of which begin at `from` and run `rate` times as fast; `None` of one with weights.
    pub(super) fn new(
        patch: &Patch,
        from: [f64; 2],
        rate: [f64; 2],
        middle: [f64; 2],
    ) -> Option<Self> {
        if patch.rational {
            return None;
        }
        let weight = 1.0 / patch.net[0][0].w;
        let from = two([0, 1], |k| (middle[k] - from[k]) * rate[k]);
        let mut rows = [[Vec3::zeros(); 4]; 4];
        for (row, [a, b, c, d]) in rows.iter_mut().zip(&patch.net) {
            let net = [a.xyz() * weight, b.xyz() * weight, c.xyz() * weight, d.xyz() * weight];
            *row = powers(net, from[0], rate[0]);
        }
        let (mut xy, mut z) = ([[Pair(0.0, 0.0); 4]; 4], [[Pair(0.0, 0.0); 4]; 2]);
        for i in 0..4 {
            let along = [rows[0][i], rows[1][i], rows[2][i], rows[3][i]];
            let column = powers(along, from[1], rate[1]);
            xy.iter_mut().zip(&column).for_each(|(row, c)| row[i] = Pair(c.x, c.y));
            (z[0][i], z[1][i]) = (Pair(column[0].z, column[1].z), Pair(column[2].z, column[3].z));
        }
        Some(Self { middle, xy, z })
    }

    /// Point and derivatives.
    #[inline(always)]
    pub(super) fn at(&self, [u, v]: [f64; 2]) -> Derivatives {
        let (u, v) = (u - self.middle[0], v - self.middle[1]);
        let [a, b, c, d] = &self.xy;
        let [a, b, c, d] = [cubic(a, u), cubic(b, u), cubic(c, u), cubic(d, u)];
        let along = |n: usize| cubic(&[a[n], b[n], c[n], d[n]], v);
        let ([p, pv, pvv], [pu, puv, _], [puu, ..]) = (along(0), along(1), along(2));
        let [near, far] = [cubic(&self.z[0], u), cubic(&self.z[1], u)];
        // Value and slope by u side by side.
        let [z, zv, zvv] = cubic(
            &[
                Pair(near[0].0, near[1].0),
                Pair(near[0].1, near[1].1),
                Pair(far[0].0, far[1].0),
                Pair(far[0].1, far[1].1),
            ],
            v,
        );
        let [zuu, ..] = cubic(&[near[2].0, near[2].1, far[2].0, far[2].1], v);
        let of = |xy: Pair, z: f64| Vec3::new(xy.0, xy.1, z);
        Derivatives {
            point: of(p, z.0),
            u: of(pu, z.1),
            v: of(pv, zv.0),
            uu: of(puu * 2.0, 2.0 * zuu),
            uv: of(puv, zv.1),
            vv: of(pvv * 2.0, 2.0 * zvv.0),
        }
    }
}

/// What stands before the powers from `t` on of a cubic with these control points, over a parameter that runs `rate` times as fast.
fn powers([a, b, c, d]: [Vec3; 4], t: f64, rate: f64) -> [Vec3; 4] {
    let [ab, bc, cd] = [b - a, c - b, d - c];
    let [near, far] = [ab + (bc - ab) * t, bc + (cd - bc) * t];
    let way = near + (far - near) * t;
    let third = (cd - bc) - (bc - ab);
    [
        a + (ab + near + way) * t,
        way * (3.0 * rate),
        (far - near) * (3.0 * rate * rate),
        third * (rate * rate * rate),
    ]
}

/// Value, slope and half of the second derivative of a cubic by its powers.
#[inline(always)]
fn cubic<T: Copy + Add<Output = T> + Mul<f64, Output = T>>(
    [a, b, c, d]: &[T; 4],
    t: f64,
) -> [T; 3] {
    let last = *d * t;
    let second = last + *c;
    let first = second * t + *b;
    let slope = last + second;
    [first * t + *a, slope * t + first, last + slope]
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::sculpt::Vec4;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn powers_are_the_patch(
            x in prop::array::uniform16(-1.0_f64..1.0), z in prop::array::uniform16(-1.0_f64..1.0),
            at in prop::array::uniform2(0.0_f64..1.0), middle in prop::array::uniform2(0.1_f64..0.9),
            from in prop::array::uniform2(-3.0_f64..3.0), rate in prop::array::uniform2(0.2_f64..3.0),
        ) {
            let patch = Patch::new(core::array::from_fn(|j| core::array::from_fn(|i| {
                let k = 4 * j + i;
                Vec4::new(3.0 * i as f64 + x[k], 2.0 * j as f64, z[k], 1.0)
            })));
            let of = |t: [f64; 2]| [0, 1].map(|k| from[k] + t[k] / rate[k]);
            let powers = Powers::new(&patch, from, rate, of(middle)).unwrap();
            let (a, b) = (powers.at(of(at)), patch.at(at[0], at[1]).rated(rate[0], rate[1]));
            for (x, y) in [
                (a.point, b.point), (a.u, b.u), (a.v, b.v), (a.uu, b.uu), (a.uv, b.uv), (a.vv, b.vv),
            ] {
                prop_assert!((x - y).norm() < 1e-12 * (1.0 + y.norm()), "{x} {y}");
            }
        }
    }
}
