//! How far a piece of a patch bends out of its parallelogram.

use super::patch::Patch;
use crate::Vec3;

/// Bounds of the second and third derivatives of a patch.
#[derive(Clone, Debug)]
pub struct Bends {
    /// Of |Suu|, |Suv|, |Svv|.
    pub most: [f64; 3],
    /// Of |Suuu|, |Suuv|, |Suvv|, |Svvv|.
    pub third: [f64; 4],
    /// Least and greatest coordinates of Suu, Suv and Svv; none of a rational patch.
    boxes: Option<[[Vec3; 2]; 3]>,
}

impl Bends {
    /// Of a patch within a ball about `center`.
    pub fn of(patch: &Patch, center: Vec3, radius: f64) -> Self {
        let boxes = (!patch.rational).then(|| boxes(patch));
        let (most, third) = norms(patch, center, radius);
        Self { most, third, boxes }
    }

    /// How far a piece of half widths `h` may stand off its parallelogram.
    pub fn strays(&self, [hu, hv]: [f64; 2]) -> f64 {
        let [uu, uv, vv] = self.most;
        0.5 * (hu * hu * uu + hv * hv * vv) + hu * hv * uv
    }

    /// How far it may stand off what the second derivatives at its middle make of the parallelogram: at `s` and `t` half
    /// widths from there, both from -1 to 1, no more than the first times `s^2` and the second times `t^2`.
    pub fn rests(&self, [hu, hv]: [f64; 2]) -> [f64; 2] {
        let [uuu, uuv, uvv, vvv] = self.third;
        // By Taylor third powers, the mixed ones three times; each is less than a square.
        [hu * hu * (hu * uuu / 6.0 + 0.5 * hv * uuv), hv * hv * (0.5 * hu * uvv + hv * vvv / 6.0)]
    }

    /// For each of Suu, Suv and Svv a ball that holds it everywhere: centre and radius.
    pub fn balls(&self) -> [(Vec3, f64); 3] {
        core::array::from_fn(|k| match &self.boxes {
            Some(boxes) => {
                let [lo, hi] = boxes[k];
                ((lo + hi) * 0.5, 0.5 * (hi - lo).norm())
            }
            None => (Vec3::zeros(), self.most[k]),
        })
    }

    /// By how much a piece of half widths `h` rises at least along the unit vector `n`, or one that is shorter, where
    /// a parameter goes from its middle to its border, twice as much and without its slope: by u and by v. Negative
    /// where it may fall.
    ///
    /// By Taylor with the remainder n.(Suu du^2 / 2 + Suv du dv + Svv dv^2 / 2) at a place between; of the middle
    /// term each parameter takes one half.
    #[inline]
    pub fn rises(&self, n: Vec3, [hu, hv]: [f64; 2]) -> [f64; 2] {
        let [muu, muv, mvv] = self.most;
        let Some([uu, uv, vv]) = &self.boxes else {
            let twist = hu * hv * muv;
            return [-hu * hu * muu - twist, -hv * hv * mvv - twist];
        };
        let least = |b: &[Vec3; 2]| {
            let of = |i: usize| (n[i] * b[0][i]).min(n[i] * b[1][i]);
            of(0) + of(1) + of(2)
        };
        let most = |b: &[Vec3; 2]| {
            let of = |i: usize| (n[i] * b[0][i]).max(n[i] * b[1][i]);
            of(0) + of(1) + of(2)
        };
        let twist = (-least(uv)).max(most(uv)).min(muv).max(0.0);
        let twist = hu * hv * twist;
        [hu * hu * least(uu).max(-muu) - twist, hv * hv * least(vv).max(-mvv) - twist]
    }
}

/// Least and greatest coordinates of Suu, Suv and Svv: those of the differences of the control net.
fn boxes(patch: &Patch) -> [[Vec3; 2]; 3] {
    let h = |j: usize, i: usize| patch.net[j][i].xyz() / patch.net[j][i].w;
    let mut all = [[Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY)]; 3];
    let mut add = |k: usize, d: Vec3| all[k] = [all[k][0].inf(&d), all[k][1].sup(&d)];
    for a in 0..4 {
        for b in 0..2 {
            add(0, (h(a, b) - h(a, b + 1) * 2.0 + h(a, b + 2)) * 6.0);
            add(2, (h(b, a) - h(b + 1, a) * 2.0 + h(b + 2, a)) * 6.0);
        }
    }
    for a in 0..3 {
        for b in 0..3 {
            add(1, (h(a, b) - h(a, b + 1) - h(a + 1, b) + h(a + 1, b + 1)) * 9.0);
        }
    }
    all
}

/// Bounds of |Suu|, |Suv|, |Svv| and of |Suuu|, |Suuv|, |Suvv|, |Svvv| from the differences of the control net.
///
/// With weights, S'' = (H'' - 2 w' S' - w'' S) / w for the homogeneous H about the middle of the patch,
/// where |S| is at most its radius, and S''' = (H''' - 3 w' S'' - 3 w'' S' - w''' S) / w.
fn norms(patch: &Patch, center: Vec3, radius: f64) -> ([f64; 3], [f64; 4]) {
    let h = |j: usize, i: usize| {
        let p = patch.net[j][i];
        (p.xyz() - center * p.w, p.w)
    };
    let least = patch.net.iter().flatten().map(|p| p.w).fold(f64::INFINITY, f64::min);
    // The greatest derivative, `a` times by u and `b` times by v, of H and of its weight.
    let top = |a: usize, b: usize| {
        let (mut most, mut heavy) = (0.0_f64, 0.0_f64);
        for j in 0..4 - b {
            for i in 0..4 - a {
                let (mut v, mut w) = (Vec3::zeros(), 0.0);
                for (k, x) in DIFFERENCES[b][..=b].iter().enumerate() {
                    for (l, y) in DIFFERENCES[a][..=a].iter().enumerate() {
                        let (p, weight) = h(j + k, i + l);
                        v += p * (x * y);
                        w += weight * (x * y);
                    }
                }
                most = most.max(v.norm());
                heavy = heavy.max(w.abs());
            }
        }
        [most, heavy].map(|m| m * SCALES[a] * SCALES[b])
    };
    let [huu, wuu] = top(2, 0);
    let [huv, wuv] = top(1, 1);
    let [hvv, wvv] = top(0, 2);
    let [huuu, wuuu] = top(3, 0);
    let [huuv, wuuv] = top(2, 1);
    let [huvv, wuvv] = top(1, 2);
    let [hvvv, wvvv] = top(0, 3);
    if !patch.rational {
        let second = [huu, huv, hvv].map(|m| m / least);
        return (second, [huuu, huuv, huvv, hvvv].map(|m| m / least));
    }
    let ([hu, wu], [hv, wv]) = (top(1, 0), top(0, 1));
    let (su, sv) = ((hu + wu * radius) / least, (hv + wv * radius) / least);
    let uu = (huu + 2.0 * wu * su + wuu * radius) / least;
    let uv = (huv + wu * sv + wv * su + wuv * radius) / least;
    let vv = (hvv + 2.0 * wv * sv + wvv * radius) / least;
    let third = [
        huuu + 3.0 * (wu * uu + wuu * su) + wuuu * radius,
        huuv + 2.0 * (wu * uv + wuv * su) + wv * uu + wuu * sv + wuuv * radius,
        huvv + 2.0 * (wv * uv + wuv * sv) + wu * vv + wvv * su + wuvv * radius,
        hvvv + 3.0 * (wv * vv + wvv * sv) + wvvv * radius,
    ];
    ([uu, uv, vv], third.map(|m| m / least))
}

/// Differences of control points, by how often they are taken.
const DIFFERENCES: [[f64; 4]; 4] =
    [[1.0, 0.0, 0.0, 0.0], [-1.0, 1.0, 0.0, 0.0], [1.0, -2.0, 1.0, 0.0], [-1.0, 3.0, -3.0, 1.0]];
/// What makes derivatives of cubics of them.
const SCALES: [f64; 4] = [1.0, 3.0, 6.0, 6.0];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sculpt::patch::tests::random;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn pieces_stay_within_their_bounds(
            z in prop::array::uniform16(-1.0_f64..1.0), w in prop::array::uniform16(-1.0_f64..1.0),
            weights in 0..2_i32, mid in prop::array::uniform2(0.3_f64..0.7),
            half in prop::array::uniform2(0.01_f64..0.3), at in prop::array::uniform2(-1.0_f64..1.0),
        ) {
            let p = random(z, w.map(|w| w * f64::from(weights)));
            let [lo, hi] = p.bounds();
            let bends = Bends::of(&p, (lo + hi) * 0.5, (hi - lo).norm() * 0.5);
            let d = p.at(mid[0], mid[1]);
            let (s, t) = (half[0] * at[0], half[1] * at[1]);
            let [along, across] = bends.rests(half);
            let rest = along * at[0] * at[0] + across * at[1] * at[1];
            let flat = d.point + d.u * s + d.v * t;
            let bent = flat + d.uu * (0.5 * s * s) + d.uv * (s * t) + d.vv * (0.5 * t * t);
            let q = p.at(mid[0] + s, mid[1] + t);
            prop_assert!((q.point - flat).norm() <= bends.strays(half) * (1.0 + 1e-12) + 1e-12);
            prop_assert!((q.point - bent).norm() <= rest * (1.0 + 1e-12) + 1e-12);
            // The second derivatives change no faster than the third allow.
            let [uuu, uuv, uvv, vvv] = bends.third;
            let (s, t) = (s.abs(), t.abs());
            prop_assert!((q.uu - d.uu).norm() <= uuu * s + uuv * t + 1e-9);
            prop_assert!((q.uv - d.uv).norm() <= uuv * s + uvv * t + 1e-9);
            prop_assert!((q.vv - d.vv).norm() <= uvv * s + vvv * t + 1e-9);
        }
    }
}
