//! POLCON: a conic section over each place of its length.

use std::sync::Arc;

use aptc_geometry::sculpt::Derivatives;
use aptc_geometry::{Polyconic, Transform, Vec2, Vec3};

use super::bend::Bend;
use super::patched::{Cells, Grid, Side};
use super::sculpted::halved;
use crate::each::three;

/// Cells along the length and along a section.
const CELLS: [usize; 2] = [16, 4];
/// How far it goes straight on beyond its ends, in shares of itself, as Section 2 has it.
const BEYOND: f64 = 0.5;
/// Coefficients of a control curve by its parameter: powers 0 to 14.
const POWERS: usize = 15;

/// The sections. With square roots among the control curves the parameter is the root of the share of the
/// length.
#[derive(Clone, Debug)]
pub(crate) struct Sections {
    form: Arc<Polyconic>,
    transform: Option<Transform>,
    rooted: bool,
    /// A B C D L H P.
    curves: [[f64; POWERS]; 7],
    /// Coefficients up to the last that is not zero in all of them: few are written with more than four.
    powers: usize,
}

impl Sections {
    /// `None` where a section is no conic.
    pub(crate) fn new(form: &Arc<Polyconic>) -> Option<(Self, Grid)> {
        let rooted = form.curves.iter().any(|c| c.root != 0.0);
        let mut curves = [[0.0; POWERS]; 7];
        for (own, curve) in curves.iter_mut().zip(&form.curves) {
            for (k, c) in curve.c.iter().enumerate() {
                own[if rooted { 2 * k } else { k }] = *c;
            }
            own[1] += curve.root;
        }
        let last = |c: &[f64; POWERS]| c.iter().rposition(|x| x.abs() > 0.0).map_or(0, |k| k + 1);
        let powers = curves.iter().map(last).max().unwrap_or(0);
        let transform = form.transform();
        let new = Self { form: Arc::clone(form), transform, rooted, curves, powers };
        let conic = (0..CELLS[0]).all(|i| {
            let p = new.control(6, i);
            let reach = p.u * new.half();
            let middle = new.value(6, new.middle(i))[0];
            middle - reach > 0.5 && middle + reach < 1.0
        });
        let side = |n: usize| Side {
            knots: halved(&[0.0, 1.0], n),
            before: Some(-BEYOND),
            behind: Some(1.0 + BEYOND),
            loose: None,
        };
        (conic && form.length > 0.0 && !form.is_skew())
            .then(|| (new, Grid { sides: CELLS.map(side) }))
    }

    fn half(&self) -> f64 {
        0.5 / CELLS[0] as f64
    }

    fn middle(&self, i: usize) -> f64 {
        (i as f64 + 0.5) / CELLS[0] as f64
    }

    /// Bounds of a control curve over a cell along the length, counted from its value in the middle.
    fn control(&self, curve: usize, i: usize) -> Bend {
        let (mid, h) = (self.middle(i), self.half());
        let mut c = self.curves[curve];
        for k in 0..POWERS {
            for i in (k..POWERS - 1).rev() {
                c[i] += mid * c[i + 1];
            }
        }
        let (mut value, mut first, mut second, mut third) = (0.0, 0.0, 0.0, 0.0);
        for (k, c) in c.iter().enumerate().skip(1).rev() {
            let (k, c) = (k as f64, c.abs());
            // Sums of k c h^(k-1) and so on, by Horner's rule over the powers that are left.
            value = (value + c) * h;
            first = first * h + k * c;
            second = if k >= 2.0 { second * h + k * (k - 1.0) * c } else { second };
            third = if k >= 3.0 { third * h + k * (k - 1.0) * (k - 2.0) * c } else { third };
        }
        Bend { value, u: first, uu: second, uuu: third, ..Bend::default() }
    }

    /// A control curve with its two derivatives.
    fn value(&self, curve: usize, u: f64) -> [f64; 3] {
        let (mut f, mut f1, mut f2) = (0.0, 0.0, 0.0);
        for c in self.curves[curve][..self.powers].iter().rev() {
            f2 = f2 * u + 2.0 * f1;
            f1 = f1 * u + f;
            f = f * u + c;
        }
        [f, f1, f2]
    }

    fn pair(&self, x: usize, y: usize, u: f64) -> [Vec2; 3] {
        let (x, y) = (self.value(x, u), self.value(y, u));
        three([0, 1, 2], |i| Vec2::new(x[i], y[i]))
    }

    fn pair_bend(&self, x: usize, y: usize, i: usize) -> Bend {
        sum(self.control(x, i), self.control(y, i))
    }

    /// Start, apex, end and weight of a section with their derivatives.
    fn section(&self, u: f64) -> ([[Vec2; 3]; 3], [f64; 3]) {
        let plus = |x: [Vec2; 3], y: [Vec2; 3]| three([0, 1, 2], |i| x[i] + y[i]);
        let start = self.pair(4, 5, u);
        let apex = plus(start, self.pair(2, 1, u));
        let end = plus(apex, self.pair(0, 3, u));
        let p = self.value(6, u);
        let q = 1.0 - p[0];
        let (w1, w2) = (0.5 / (q * q), 1.0 / (q * q * q));
        ([start, apex, end], [(p[0] - 0.5) / q, w1 * p[1], w2 * p[1] * p[1] + w1 * p[2]])
    }

    fn lift(&self, along: f64, x: Vec2) -> Vec3 {
        let v = Vec3::new(along, x.x, x.y);
        self.transform.as_ref().map_or(v, |m| m.vector(v))
    }
}

/// Bounds of a sum of functions of u.
fn sum(a: Bend, b: Bend) -> Bend {
    Bend {
        value: a.value + b.value,
        u: a.u + b.u,
        uu: a.uu + b.uu,
        uuu: a.uuu + b.uuu,
        ..Bend::default()
    }
}

/// Bernstein's polynomials of degree two with their derivatives.
fn basis(t: f64) -> [[f64; 3]; 3] {
    let s = 1.0 - t;
    [[s * s, 2.0 * t * s, t * t], [-2.0 * s, 2.0 - 4.0 * t, 2.0 * t], [2.0, -4.0, 2.0]]
}

impl Cells for Sections {
    fn at(&self, _: usize, _: usize, u: f64, t: f64) -> Derivatives {
        let ([start, apex, end], w) = self.section(u);
        let product = [
            apex[0] * w[0],
            apex[1] * w[0] + apex[0] * w[1],
            apex[2] * w[0] + apex[1] * (2.0 * w[1]) + apex[0] * w[2],
        ];
        let b = basis(t);
        let num = |i: usize, j: usize| start[i] * b[j][0] + product[i] * b[j][1] + end[i] * b[j][2];
        let den =
            |i: usize, j: usize| (if i == 0 { b[j][0] + b[j][2] } else { 0.0 }) + w[i] * b[j][1];
        let d = den(0, 0);
        let x = num(0, 0) / d;
        let xu = (num(1, 0) - x * den(1, 0)) / d;
        let xv = (num(0, 1) - x * den(0, 1)) / d;
        let xuu = (num(2, 0) - xu * (2.0 * den(1, 0)) - x * den(2, 0)) / d;
        let xvv = (num(0, 2) - xv * (2.0 * den(0, 1)) - x * den(0, 2)) / d;
        let xuv = (num(1, 1) - xu * den(0, 1) - xv * den(1, 0) - x * den(1, 1)) / d;
        let length = self.form.length;
        let [at, rate, turn] = if self.rooted { [u * u, 2.0 * u, 2.0] } else { [u, 1.0, 0.0] };
        let p = Vec3::new(self.form.origin + length * at, x.x, x.y);
        Derivatives {
            point: self.transform.as_ref().map_or(p, |m| m.point(p)),
            u: self.lift(length * rate, xu),
            v: self.lift(0.0, xv),
            uu: self.lift(length * turn, xuu),
            uv: self.lift(0.0, xuv),
            vv: self.lift(0.0, xvv),
        }
    }

    fn bend(&self, i: usize, j: usize) -> Bend {
        let n = CELLS[1] as f64;
        let (t0, t1) = (j as f64 / n, (j as f64 + 1.0) / n);
        // Control points about the middle of the cell, where the section is.
        let (corners, weights) = self.section(self.middle(i));
        let middle = {
            let b = basis(0.5 * (t0 + t1))[0];
            let d = b[0] + weights[0] * b[1] + b[2];
            (corners[0][0] * b[0] + corners[1][0] * (weights[0] * b[1]) + corners[2][0] * b[2]) / d
        };
        let start = self.pair_bend(4, 5, i);
        let apex = sum(start, self.pair_bend(2, 1, i));
        let end = sum(apex, self.pair_bend(0, 3, i));
        let about =
            |k: usize, b: Bend| Bend { value: b.value + (corners[k][0] - middle).norm(), ..b };
        let (start, apex, end) = (about(0, start), about(1, apex), about(2, end));
        let p = self.control(6, i);
        let at = self.value(6, self.middle(i))[0];
        let q = 1.0 - at - p.value;
        let w = Bend {
            value: (at + p.value - 0.5) / q,
            u: 0.5 * p.u / (q * q),
            uu: p.u * p.u / (q * q * q) + 0.5 * p.uu / (q * q),
            uuu: 3.0 * p.u * (p.u * p.u / q + p.uu) / (q * q * q) + 0.5 * p.uuu / (q * q),
            ..Bend::default()
        };
        let least_weight = (at - p.value - 0.5) / (1.0 - at + p.value);
        let product = Bend {
            value: apex.value * w.value,
            u: apex.u * w.value + apex.value * w.u,
            uu: apex.uu * w.value + 2.0 * apex.u * w.u + apex.value * w.uu,
            uuu: apex.uuu * w.value + 3.0 * (apex.uu * w.u + apex.u * w.uu) + apex.value * w.uuu,
            ..Bend::default()
        };
        // Bounds of the basis over the cell: it bends no more than that.
        let (ends, mid) = ([basis(t0), basis(t1)], basis(0.5));
        let top = |k: usize, m: usize| {
            let inner = if k == 0 && m == 1 && t0 < 0.5 && t1 > 0.5 { mid[0][1] } else { 0.0 };
            ends[0][k][m].abs().max(ends[1][k][m].abs()).max(inner)
        };
        let over = |k: usize, a: f64, b: f64, c: f64| a * top(k, 0) + b * top(k, 1) + c * top(k, 2);
        let num = Bend {
            value: over(0, start.value, product.value, end.value),
            u: over(0, start.u, product.u, end.u),
            v: over(1, start.value, product.value, end.value),
            uu: over(0, start.uu, product.uu, end.uu),
            uv: over(1, start.u, product.u, end.u),
            vv: over(2, start.value, product.value, end.value),
            uuu: over(0, start.uuu, product.uuu, end.uuu),
            uuv: over(1, start.uu, product.uu, end.uu),
            uvv: over(2, start.u, product.u, end.u),
            vvv: 0.0,
        };
        let off = (w.value - 1.0).abs().max((least_weight - 1.0).abs());
        let den = Bend {
            value: 0.0,
            u: w.u * top(0, 1),
            v: off * top(1, 1),
            uu: w.uu * top(0, 1),
            uv: w.u * top(1, 1),
            vv: 4.0 * off,
            uuu: w.uuu * top(0, 1),
            uuv: w.uu * top(1, 1),
            uvv: 4.0 * w.u,
            vvv: 0.0,
        };
        let mut bend = num.over(&den, least_weight.min(1.0));
        if self.rooted {
            bend.uu += 2.0 * self.form.length.abs();
        }
        // The map into the part's system is rigid but for a mirror; a scale would show in its vectors.
        let scale = self.transform.as_ref().map_or(1.0, |m| {
            [Vec3::x(), Vec3::y(), Vec3::z()]
                .iter()
                .map(|e| m.vector(*e).norm_squared())
                .sum::<f64>()
                .sqrt()
        });
        Bend {
            value: bend.value * scale,
            u: bend.u * scale,
            v: bend.v * scale,
            uu: bend.uu * scale,
            uv: bend.uv * scale,
            vv: bend.vv * scale,
            uuu: bend.uuu * scale,
            uuv: bend.uuv * scale,
            uvv: bend.uvv * scale,
            vvv: bend.vvv * scale,
        }
    }
}
