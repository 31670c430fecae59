//! How far a piece of a patch bends out of its parallelogram.

use super::patch::Patch;
use crate::Vec3;

/// Bounds of the second derivatives of a patch.
#[derive(Clone, Debug)]
pub struct Bends {
    /// Of |Suu|, |Suv|, |Svv|.
    pub most: [f64; 3],
    /// Least and greatest coordinates of Suu, Suv and Svv; none of a rational patch.
    boxes: Option<[[Vec3; 2]; 3]>,
}

impl Bends {
    /// Of a patch within a ball about `center`.
    pub fn of(patch: &Patch, center: Vec3, radius: f64) -> Self {
        let boxes = (!patch.rational).then(|| boxes(patch));
        Self { most: norms(patch, center, radius), boxes }
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

/// Bounds of |Suu|, |Suv|, |Svv| from the differences of the control net.
///
/// With weights, S'' = (H'' - 2 w' S' - w'' S) / w for the homogeneous H about the middle of the patch,
/// where |S| is at most its radius.
fn norms(patch: &Patch, center: Vec3, radius: f64) -> [f64; 3] {
    let h = |j: usize, i: usize| {
        let p = patch.net[j][i];
        (p.xyz() - center * p.w, p.w)
    };
    let mut top = [[0.0_f64; 2]; 5];
    let mut least = f64::INFINITY;
    let mut raise = |k: usize, v: Vec3, w: f64| {
        top[k][0] = top[k][0].max(v.norm());
        top[k][1] = top[k][1].max(w.abs());
    };
    for a in 0..4 {
        for b in 0..4 {
            least = least.min(h(a, b).1);
            if b < 3 {
                let (p, q) = (h(a, b), h(a, b + 1));
                raise(0, (q.0 - p.0) * 3.0, 3.0 * (q.1 - p.1));
                let (p, q) = (h(b, a), h(b + 1, a));
                raise(1, (q.0 - p.0) * 3.0, 3.0 * (q.1 - p.1));
            }
            if b < 2 {
                let (p, q, r) = (h(a, b), h(a, b + 1), h(a, b + 2));
                raise(2, (p.0 - q.0 * 2.0 + r.0) * 6.0, 6.0 * (p.1 - 2.0 * q.1 + r.1));
                let (p, q, r) = (h(b, a), h(b + 1, a), h(b + 2, a));
                raise(4, (p.0 - q.0 * 2.0 + r.0) * 6.0, 6.0 * (p.1 - 2.0 * q.1 + r.1));
            }
            if a < 3 && b < 3 {
                let (p, q, r, s) = (h(a, b), h(a, b + 1), h(a + 1, b), h(a + 1, b + 1));
                raise(3, (p.0 - q.0 - r.0 + s.0) * 9.0, 9.0 * (p.1 - q.1 - r.1 + s.1));
            }
        }
    }
    let [[hu, wu], [hv, wv], [huu, wuu], [huv, wuv], [hvv, wvv]] = top;
    if !patch.rational {
        return [huu / least, huv / least, hvv / least];
    }
    let (su, sv) = ((hu + wu * radius) / least, (hv + wv * radius) / least);
    [
        (huu + 2.0 * wu * su + wuu * radius) / least,
        (huv + wu * sv + wv * su + wuv * radius) / least,
        (hvv + 2.0 * wv * sv + wvv * radius) / least,
    ]
}
