//! Where the normals of a part of a patch lie, where its derivatives vanish too.

use super::patch::Patch;
use crate::Vec3;

/// Vectors over a unit square by their Bernstein coefficients, rows along u; of degree eight by each parameter at most.
#[derive(Clone, Copy, Debug)]
struct Net {
    degree: [usize; 2],
    at: [[Vec3; 9]; 9],
}

impl Patch {
    /// How far the unit normals over `u[0]..u[1]` and `v[0]..v[1]` stand from the unit vector `n` at most, as the length of the
    /// difference; `None` where some may stand square to it, or there are none. Beyond a border, where a range lies as a whole, the patch
    /// goes on straight; of a rational one nothing is told there.
    ///
    /// The normal goes along a polynomial whose Bernstein coefficients it lies between, wherever it is not 0; coefficients that are 0,
    /// as beside a corner in which the derivatives are parallel or vanish, do not move it.
    pub fn normals_about(&self, n: Vec3, u: [f64; 2], v: [f64; 2]) -> Option<f64> {
        let is_beyond = |[from, to]: [f64; 2]| from >= 1.0 || to <= 0.0;
        let all = if is_beyond(u) || is_beyond(v) {
            if self.rational {
                return None;
            }
            let (turned, u) = self.exchanged().straight_on(u);
            let (whole, v) = turned.exchanged().straight_on(v);
            whole.crossed(u, v)
        } else {
            self.crossed(u, v)
        };
        let (mut far, mut any) = (0.0_f64, false);
        for m in all.coefficients() {
            let size = m.norm();
            if size > 0.0 {
                if m.dot(&n) <= 0.0 {
                    return None;
                }
                any = true;
                far = far.max((m / size - n).norm());
            }
        }
        any.then_some(far)
    }

    /// The straight continuation by v over a range beyond a border, and where in it the range lies; within the borders the same.
    fn straight_on(&self, [from, to]: [f64; 2]) -> (Self, [f64; 2]) {
        let [first, second, third, last] = self.net;
        let (border, near, reach) = if from >= 1.0 {
            (last, third, to - 1.0)
        } else if to <= 0.0 {
            (first, second, from)
        } else {
            return (self.clone(), [from, to]);
        };
        // The derivative there is three times the way from one row to the next, a row of the new net one third of it.
        let away =
            |j: usize, i: usize| border[i] + (border[i] - near[i]) * (reach.abs() * j as f64);
        let net = core::array::from_fn(|j| {
            core::array::from_fn(|i| away(if reach > 0.0 { j } else { 3 - j }, i))
        });
        let at = |x: f64| if reach > 0.0 { (x - 1.0) / reach } else { (x - from) / -from };
        (Self { net, rational: self.rational }, [at(from), at(to)])
    }

    /// What the normals go along.
    ///
    /// With `P = w S` the cross product of the derivatives of S is, times `w^3`, `w (Pu x Pv) + wv (P x Pu) - wu (P x Pv)`.
    fn crossed(&self, u: [f64; 2], v: [f64; 2]) -> Net {
        let points = Net::of([3, 3], |j, i| self.net[j][i].xyz());
        let along = points.derivatives().map(|net| net.part(u, v));
        let cross = along[0].times(&along[1], |a, b| a.cross(&b));
        if !self.rational {
            return cross;
        }
        let points = points.part(u, v);
        let weights = Net::of([3, 3], |j, i| Vec3::repeat(self.net[j][i].w));
        let [wu, wv] = weights.derivatives().map(|net| net.part(u, v));
        let scaled = |net: &Net, by: &Net| net.times(by, |a, b| a.component_mul(&b));
        let [by_u, by_v] = along.map(|net| points.times(&net, |a, b| a.cross(&b)));
        let mut all = scaled(&cross, &weights.part(u, v));
        let (plus, minus) = (scaled(&by_u, &wv), scaled(&by_v, &wu));
        for (j, row) in all.at.iter_mut().enumerate() {
            for (i, m) in row.iter_mut().enumerate() {
                *m += plus.at[j][i] - minus.at[j][i];
            }
        }
        all
    }
}

impl Net {
    fn of(degree: [usize; 2], coefficient: impl Fn(usize, usize) -> Vec3) -> Self {
        let mut at = [[Vec3::zeros(); 9]; 9];
        for (j, row) in at.iter_mut().enumerate().take(degree[1] + 1) {
            for (i, m) in row.iter_mut().enumerate().take(degree[0] + 1) {
                *m = coefficient(j, i);
            }
        }
        Self { degree, at }
    }

    fn coefficients(&self) -> impl Iterator<Item = &Vec3> {
        let [m, n] = self.degree;
        self.at[..=n].iter().flat_map(move |row| &row[..=m])
    }

    /// The derivatives by u and by v; what rounding leaves of equal coefficients is 0.
    fn derivatives(&self) -> [Self; 2] {
        let [m, n] = self.degree;
        let most = self.coefficients().map(|c| c.norm()).fold(0.0, f64::max);
        let step = |a: Vec3, b: Vec3| {
            let way = b - a;
            if way.norm() <= 8.0 * f64::EPSILON * most { Vec3::zeros() } else { way }
        };
        let by_u = Self::of([m - 1, n], |j, i| step(self.at[j][i], self.at[j][i + 1]) * m as f64);
        let by_v = Self::of([m, n - 1], |j, i| step(self.at[j][i], self.at[j + 1][i]) * n as f64);
        [by_u, by_v]
    }

    /// The same vectors over a part of the square.
    fn part(&self, u: [f64; 2], v: [f64; 2]) -> Self {
        let mut new = *self;
        let [m, n] = self.degree;
        for row in &mut new.at[..=n] {
            narrow(&mut row[..=m], u);
        }
        for i in 0..=m {
            let mut column: [Vec3; 9] = core::array::from_fn(|j| new.at[j][i]);
            narrow(&mut column[..=n], v);
            for (row, m) in new.at.iter_mut().zip(column) {
                row[i] = m;
            }
        }
        new
    }

    /// The product of two, place by place.
    fn times(&self, other: &Self, product: impl Fn(Vec3, Vec3) -> Vec3) -> Self {
        let degree = [0, 1].map(|k| self.degree[k] + other.degree[k]);
        let mut out = Self::of(degree, |_, _| Vec3::zeros());
        let share = |net: &Self, j: usize, i: usize| {
            net.at[j][i] * (CHOOSE[net.degree[0]][i] * CHOOSE[net.degree[1]][j])
        };
        for j in 0..=self.degree[1] {
            for i in 0..=self.degree[0] {
                let a = share(self, j, i);
                for l in 0..=other.degree[1] {
                    for k in 0..=other.degree[0] {
                        out.at[j + l][i + k] += product(a, share(other, l, k));
                    }
                }
            }
        }
        for (j, row) in out.at.iter_mut().enumerate().take(degree[1] + 1) {
            for (i, m) in row.iter_mut().enumerate().take(degree[0] + 1) {
                *m /= CHOOSE[degree[0]][i] * CHOOSE[degree[1]][j];
            }
        }
        out
    }
}

/// Bernstein coefficients over a part of what they are given for: means of each two, so that 0 stays 0.
fn narrow(b: &mut [Vec3], [from, to]: [f64; 2]) {
    let last = b.len() - 1;
    let from = from / to;
    for k in 1..=last {
        for i in (k..=last).rev() {
            b[i] = b[i - 1] * (1.0 - to) + b[i] * to;
        }
    }
    for k in 1..=last {
        for i in 0..=last - k {
            b[i] = b[i] * (1.0 - from) + b[i + 1] * from;
        }
    }
}

/// Numbers of ways to choose.
const CHOOSE: [[f64; 9]; 9] = choose();

const fn choose() -> [[f64; 9]; 9] {
    let mut out = [[0.0; 9]; 9];
    let mut n = 0;
    while n < 9 {
        out[n][0] = 1.0;
        let mut k = 1;
        while k <= n {
            out[n][k] = out[n - 1][k - 1] + out[n - 1][k];
            k += 1;
        }
        n += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::patch::tests::random;
    use super::*;
    use proptest::prelude::*;

    /// A round corner of three sides: its border v = 1 is one point, and at u = 0 and 1 its twist vanishes there too.
    fn corner() -> Patch {
        let (x, y, z, o) = (Vec3::x(), Vec3::y(), Vec3::z(), Vec3::zeros());
        let (a, b, tip) =
            (Vec3::new(3.0, 1.0, 2.0), Vec3::new(2.0, 1.0, 3.0), Vec3::new(2.0, 0.0, 2.0));
        Patch::hermite([[a, b, z, -x], [tip, tip, o, o], [-y, -y, o, o], [-x, -z, o, o]])
    }

    /// How far the normal at a place that is not beyond a border stands from another.
    fn off(p: &Patch, n: Vec3, [u, v]: [f64; 2]) -> Option<f64> {
        let d = p.at(u, v);
        Some((d.u.cross(&d.v).try_normalize(0.0)? - n).norm())
    }

    proptest! {
        /// The normals of parts of patches are as near to that of the middle as is told, and for small parts little more is told.
        #[test]
        fn normals_are_as_near_as_is_told(
            z in prop::array::uniform16(-1.0_f64..1.0), w in prop::array::uniform16(-1.0_f64..1.0),
            weighted: bool, from in prop::array::uniform2(0.0..0.9_f64), size in prop::array::uniform2(0.001..0.1_f64),
            places in prop::array::uniform8(prop::array::uniform2(0.0..1.0_f64)),
        ) {
            let p = random(z, if weighted { w } else { [0.0; 16] });
            let [u, v] = [0, 1].map(|k| [from[k], from[k] + size[k]]);
            let at = |[s, t]: [f64; 2]| [u[0] + s * size[0], v[0] + t * size[1]];
            let n = p.at(u[0] + 0.5 * size[0], v[0] + 0.5 * size[1]).normal().unwrap();
            let told = p.normals_about(n, u, v);
            let met = places.iter().filter_map(|s| off(&p, n, at(*s))).fold(0.0, f64::max);
            prop_assert!(told.is_none_or(|t| met <= t + 1e-12), "{met} {told:?}");
            if size[0].max(size[1]) < 0.01 {
                let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|s| off(&p, n, at(s)).unwrap());
                let most = corners.into_iter().fold(0.0, f64::max);
                prop_assert!(told.is_some_and(|t| t <= 1.5 * most + 1e-6), "{told:?} {most}");
            }
        }

        /// Beside a corner without a normal too.
        #[test]
        fn normals_beside_a_bare_corner(
            last: bool, size in 0.001..0.2_f64, places in prop::array::uniform8(prop::array::uniform2(0.0..1.0_f64)),
        ) {
            let p = corner();
            let u = if last { [1.0 - size, 1.0] } else { [0.0, size] };
            let v = [1.0 - size, 1.0];
            let n = -Vec3::y();
            let told = p.normals_about(n, u, v).unwrap();
            let at = |[s, t]: [f64; 2]| [u[0] + s * (u[1] - u[0]), v[0] + t * (v[1] - v[0])];
            let met = places.iter().filter_map(|s| off(&p, n, at(*s))).fold(0.0, f64::max);
            prop_assert!(met <= told + 1e-9 && told < 6.0 * size, "{met} {told} {size}");
        }
    }

    /// Where a patch goes on straight its normals are told as well: beyond a border that bends, those along the border.
    #[test]
    fn normals_beyond_a_border() {
        let p = random(core::array::from_fn(|i| 0.3 * crate::trig::sin(i as f64)), [0.0; 16]);
        for (k, beyond) in [(0, [1.0, 1.5]), (0, [-0.5, 0.0]), (1, [1.25, 1.5]), (1, [-0.5, -0.25])]
        {
            let mut range = [[0.4, 0.5]; 2];
            range[k] = beyond;
            let border = if beyond[0] >= 1.0 { 1.0 } else { 0.0 };
            let normal = |s: f64, t: f64| {
                let mut at = [0.4 + 0.1 * s; 2];
                at[k] = border;
                let far = beyond[0] + (beyond[1] - beyond[0]) * t - border;
                let d = p.at(at[0], at[1]);
                let (u, v) = if k == 0 { (d.u, d.v + d.uv * far) } else { (d.u + d.uv * far, d.v) };
                u.cross(&v).normalize()
            };
            let n = normal(0.5, 0.5);
            let told = p.normals_about(n, range[0], range[1]).unwrap();
            let all = (0..=20)
                .map(|i| (normal(f64::from(i % 5) / 4.0, f64::from(i / 5) / 4.0) - n).norm());
            let met = all.fold(0.0, f64::max);
            assert!(met <= told + 1e-12 && told <= 1.5 * met, "{k} {beyond:?} {met} {told}");
        }
    }

    /// A patch that is all one point, or a line, has no normals.
    #[test]
    fn no_normals() {
        let o = Vec3::zeros();
        let x = Vec3::x();
        let point = Patch::hermite([[o; 4]; 4]);
        assert_eq!(point.normals_about(x, [0.0, 1.0], [0.0, 1.0]), None);
        let line = Patch::hermite([[o, x, x, x], [o, x, x, x], [o; 4], [o; 4]]);
        assert_eq!(line.normals_about(x, [0.0, 1.0], [0.0, 1.0]), None);
    }
}
