//! RLDSRF: rulings between two rails, `S = A(u) + (B(u) - A(u)) v`.

use aptc_geometry::sculpt::Derivatives;
use aptc_geometry::{RuledSurface, Second, Vec3};

use super::bend::Bend;
use super::patched::{Cells, Grid, Side};
use super::rail::{Rail, Root};
use super::sculpted::halved;

/// Cells along a rail without joints.
const CELLS: usize = 16;
/// How far the rulings go beyond the rails, and the rails straight on, as Section 2 has it.
const RULINGS: f64 = 10.0;
const RAILS: f64 = 0.5;

/// The rulings over the parameter u, of which the fraction of the base lines is slow where a rail is steep.
#[derive(Clone, Debug)]
pub(crate) struct Rulings {
    first: Rail,
    second: Far,
    steep: [bool; 2],
    us: Vec<f64>,
    vs: Vec<f64>,
    /// Fractions of the base lines in the middles of the cells along u.
    middles: Vec<f64>,
    /// Bounds of the second derivatives of both rails and of the third ones, by cell along u.
    bends: Vec<[[f64; 2]; 2]>,
}

#[derive(Clone, Debug)]
enum Far {
    Rail(Rail),
    Apex(Vec3),
}

impl Rulings {
    pub(crate) fn new(form: &RuledSurface) -> Option<(Self, Grid)> {
        let first = Rail::new(&form.first)?;
        let second = match &form.second {
            Second::Rail(rail) => Far::Rail(Rail::new(rail)?),
            Second::Apex(p) => Far::Apex(*p),
        };
        let far = matches!(second, Far::Rail(_));
        // Cells about as long as they are wide.
        let ends = |share: f64| match &second {
            Far::Rail(rail) => {
                (rail.start + rail.base * share) - (first.start + first.base * share)
            }
            Far::Apex(p) => p - (first.start + first.base * share),
        };
        let long = [0.0, 0.5, 1.0].map(|share| ends(share).norm()).into_iter().fold(0.0, f64::max);
        let wide = first.base.norm() / CELLS as f64;
        let across = (1..CELLS).find(|n| wide * *n as f64 >= long).unwrap_or(CELLS);
        let mut vs = vec![-RULINGS, -1.0];
        vs.extend(halved(&[0.0, 1.0], across));
        if far {
            vs.extend([2.0, 1.0 + RULINGS]);
        }
        let mut new = Self {
            first,
            second,
            steep: [false; 2],
            us: Vec::new(),
            vs,
            middles: Vec::new(),
            bends: Vec::new(),
        };
        new.steep = [0, 1].map(|k| new.rails().any(|r| r.steep()[k]));
        let mut us = halved(&[0.0, 1.0], CELLS);
        for t in new.rails().flat_map(Rail::joints).collect::<Vec<_>>() {
            us.push(new.parameter(t));
        }
        us.sort_by(f64::total_cmp);
        us.dedup_by(|b, a| *b - *a < 1e-9);
        new.middles = us.windows(2).map(|w| new.fraction(0.5 * (w[0] + w[1]))[0]).collect();
        new.bends = us.windows(2).map(|w| new.cell_bends(w[0], w[1])).collect();
        new.us = us;
        let straight = Side {
            knots: new.us.clone(),
            before: Some(-RAILS),
            behind: Some(1.0 + RAILS),
            loose: None,
        };
        let rulings = Side { knots: new.vs.clone(), before: None, behind: None, loose: None };
        Some((new, Grid { sides: [straight, rulings] }))
    }

    fn rails(&self) -> impl Iterator<Item = &Rail> {
        let second = match &self.second {
            Far::Rail(rail) => Some(rail),
            Far::Apex(_) => None,
        };
        std::iter::once(&self.first).chain(second)
    }

    /// Fraction of the base lines at `u` with its derivatives; the same as Section 2's, for it is part of
    /// how far the rails go straight on.
    fn fraction(&self, u: f64) -> [f64; 3] {
        match self.steep {
            [false, false] => [u, 1.0, 0.0],
            [true, false] => [u * u, 2.0 * u, 2.0],
            [false, true] => [u * (2.0 - u), 2.0 - 2.0 * u, -2.0],
            [true, true] => [u * u * (3.0 - 2.0 * u), 6.0 * u * (1.0 - u), 6.0 - 12.0 * u],
        }
    }

    /// The parameter of a fraction, by halving.
    fn parameter(&self, t: f64) -> f64 {
        let (mut lo, mut hi) = (0.0, 1.0);
        for _ in 0..60 {
            let u = 0.5 * (lo + hi);
            if self.fraction(u)[0] < t { lo = u } else { hi = u }
        }
        0.5 * (lo + hi)
    }

    fn cell_bends(&self, u0: f64, u1: f64) -> [[f64; 2]; 2] {
        let of = |rail: &Rail| [self.bend_of(rail, u0, u1), self.twist_of(rail, u0, u1)];
        let second = match &self.second {
            Far::Rail(rail) => of(rail),
            Far::Apex(_) => [0.0; 2],
        };
        let [[a, aa], [b, bb]] = [of(&self.first), second];
        [[a, b], [aa, bb]]
    }

    /// Bound of a rail's third derivative by u; infinite where one is steep.
    fn twist_of(&self, rail: &Rail, u0: f64, u1: f64) -> f64 {
        if self.steep == [false; 2] {
            rail.toward.norm() * rail.twist(u0, u1)
        } else {
            f64::INFINITY
        }
    }

    /// Bound of a rail's second derivative by u.
    fn bend_of(&self, rail: &Rail, u0: f64, u1: f64) -> f64 {
        let [t0, t1] = [u0, u1].map(|u| self.fraction(u)[0]);
        let rate =
            [u0, 0.5 * (u0 + u1), u1].map(|u| self.fraction(u)[1]).into_iter().fold(0.0, f64::max)
                + 0.5 * (u1 - u0) * 6.0 * f64::from(u8::from(self.steep == [true, true]));
        let turn = self.fraction(u0)[2].abs().max(self.fraction(u1)[2].abs());
        let y = match rail.root() {
            Some(root) => {
                root.b[1].abs() * turn
                    + root.scale.abs() * self.root_bend(&root, rail.steep(), u0, u1)
            }
            None => {
                let bend = rail.bend(t0, t1);
                let slope = rail.at(0.5 * (t0 + t1)).map_or(f64::INFINITY, |f| f[1].abs());
                bend * rate * rate
                    + if turn > 0.0 { (slope + 0.5 * (t1 - t0) * bend) * turn } else { 0.0 }
            }
        };
        rail.base.norm() * turn + rail.toward.norm() * y
    }

    /// Bound of the second derivative of `u^i (1 - u)^j sqrt(R(u))`, the root of a discriminant that
    /// vanishes at steep ends.
    fn root_bend(&self, root: &Root, ends: [bool; 2], u0: f64, u1: f64) -> f64 {
        let (mid, h) = (0.5 * (u0 + u1), 0.5 * (u1 - u0));
        let r = self.smooth(root, ends);
        // R about the middle of the cell.
        let mut c = r;
        for k in 0..c.len() {
            for i in (k..c.len() - 1).rev() {
                c[i] += mid * c[i + 1];
            }
        }
        let power = |k: usize| (0..k).fold(1.0, |p, _| p * h);
        let tail = |from: usize, factor: &dyn Fn(usize) -> f64| {
            (from..c.len()).map(|k| factor(k) * c[k].abs() * power(k - from)).sum::<f64>()
        };
        let least = c[0] - h * tail(1, &|_| 1.0);
        if least <= 0.0 {
            return f64::INFINITY;
        }
        let most = c[0] + h * tail(1, &|_| 1.0);
        let first = tail(1, &|k| k as f64);
        let second = tail(2, &|k| (k * (k - 1)) as f64);
        let s = least.sqrt();
        let g =
            [most.sqrt(), 0.5 * first / s, 0.5 * second / s + 0.25 * first * first / (least * s)];
        // The factor and its derivatives: u, 1 - u or u (1 - u).
        let f = match ends {
            [true, true] => [0.25, 1.0, 2.0],
            [true, false] | [false, true] => [1.0, 1.0, 0.0],
            [false, false] => [1.0, 0.0, 0.0],
        };
        f[0] * g[2] + 2.0 * f[1] * g[1] + f[2] * g[0]
    }

    /// The polynomial R of which the root is taken: the rest of the discriminant at t(u), times what t and
    /// 1 - t are more than squares.
    fn smooth(&self, root: &Root, ends: [bool; 2]) -> [f64; 6] {
        // t(u), t / u^2 and (1 - t) / (1 - u)^2 as polynomials of u.
        let (t, low, high): ([f64; 4], [f64; 2], [f64; 2]) = match self.steep {
            [false, false] => ([0.0, 1.0, 0.0, 0.0], [1.0, 0.0], [1.0, 0.0]),
            [true, false] => ([0.0, 0.0, 1.0, 0.0], [1.0, 0.0], [1.0, 0.0]),
            [false, true] => ([0.0, 2.0, -1.0, 0.0], [1.0, 0.0], [1.0, 0.0]),
            [true, true] => ([0.0, 0.0, 3.0, -2.0], [3.0, -2.0], [1.0, 2.0]),
        };
        let mut r = [0.0; 6];
        for (r, t) in r.iter_mut().zip(t) {
            *r = root.rest[1] * t;
        }
        r[0] += root.rest[0];
        for (factor, end) in [(low, ends[0]), (high, ends[1])] {
            if !end {
                continue;
            }
            let mut product = [0.0; 6];
            for (i, x) in r.iter().enumerate() {
                product[i] += x * factor[0];
                if i + 1 < product.len() {
                    product[i + 1] += x * factor[1];
                }
            }
            r = product;
        }
        r
    }

    /// Is it evaluated alike in two cells along the rails?
    pub(crate) fn is_one_map(&self, one: usize, other: usize) -> bool {
        let (a, b) = (self.middles[one], self.middles[other]);
        self.rails().all(|rail| rail.span(a) == rail.span(b))
    }

    /// A rail at `u` with its derivatives, as of the cell `i`.
    fn line(&self, rail: &Rail, i: usize, u: f64) -> [Vec3; 3] {
        let beside = |t: f64| rail.at_beside(t, self.middles[i]).unwrap_or([f64::NAN; 3]);
        if self.steep == [false; 2] {
            let [y, y1, y2] = beside(u);
            let point = rail.start + rail.base * u + rail.toward * y;
            return [point, rail.base + rail.toward * y1, rail.toward * y2];
        }
        let [t, t1, t2] = self.fraction(u);
        let y = match rail.root() {
            Some(root) => self.steep_height(&root, rail.steep(), u),
            None => {
                let [y, y1, y2] = beside(t);
                [y, y1 * t1, y2 * t1 * t1 + y1 * t2]
            }
        };
        [
            rail.start + rail.base * t + rail.toward * y[0],
            rail.base * t1 + rail.toward * y[1],
            rail.base * t2 + rail.toward * y[2],
        ]
    }

    fn steep_height(&self, root: &Root, ends: [bool; 2], u: f64) -> [f64; 3] {
        let r = self.smooth(root, ends);
        let (mut p, mut p1, mut p2) = (0.0, 0.0, 0.0);
        for c in r.iter().rev() {
            p2 = p2 * u + 2.0 * p1;
            p1 = p1 * u + p;
            p = p * u + c;
        }
        let s = p.max(0.0).sqrt();
        let g = [s, 0.5 * p1 / s, 0.5 * p2 / s - 0.25 * p1 * p1 / (p * s)];
        let f = match ends {
            [true, true] => [u * (1.0 - u), 1.0 - 2.0 * u, -2.0],
            [true, false] => [u, 1.0, 0.0],
            [false, true] => [1.0 - u, -1.0, 0.0],
            [false, false] => [1.0, 0.0, 0.0],
        };
        let [t, t1, t2] = self.fraction(u);
        [
            root.scale * f[0] * g[0] - root.b[0] - root.b[1] * t,
            root.scale * (f[1] * g[0] + f[0] * g[1]) - root.b[1] * t1,
            root.scale * (f[2] * g[0] + 2.0 * f[1] * g[1] + f[0] * g[2]) - root.b[1] * t2,
        ]
    }
}

impl Cells for Rulings {
    fn at(&self, i: usize, _: usize, u: f64, v: f64) -> Derivatives {
        let a = self.line(&self.first, i, u);
        let b = match &self.second {
            Far::Rail(rail) => self.line(rail, i, u),
            Far::Apex(p) => [*p, Vec3::zeros(), Vec3::zeros()],
        };
        Derivatives {
            point: a[0] + (b[0] - a[0]) * v,
            u: a[1] + (b[1] - a[1]) * v,
            v: b[0] - a[0],
            uu: a[2] + (b[2] - a[2]) * v,
            uv: b[1] - a[1],
            vv: Vec3::zeros(),
        }
    }

    fn bend(&self, i: usize, j: usize) -> Bend {
        let [[a, b], [aa, bb]] = self.bends[i];
        let (u0, u1) = (self.us[i], self.us[i + 1]);
        let far = |share: f64| (share - self.vs[j]).abs().max((share - self.vs[j + 1]).abs());
        let uv = self.at(i, j, 0.5 * (u0 + u1), 0.0).uv.norm() + 0.5 * (u1 - u0) * (a + b);
        let along = |a: f64, b: f64| a * far(1.0) + b * far(0.0);
        Bend { uu: along(a, b), uv, uuu: along(aa, bb), uuv: a + b, ..Bend::default() }
    }
}
