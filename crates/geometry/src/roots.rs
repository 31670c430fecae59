//! Real roots of polynomials, stable in floating point.

use crate::Reason;

/// Below this fraction of its terms a discriminant or a value counts as zero: a line that touches is
/// reported as touching. Larger reports near misses as hits, smaller loses exact tangents to rounding.
const TOUCH: f64 = 1e-13;
/// Leading coefficients that contribute less than this fraction are not there.
const LEADING: f64 = 1e-14;

/// Real roots of a quadratic in rising order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic {
    roots: [f64; 2],
    n: usize,
    /// The two roots fell together: the line touches the surface.
    pub grazing: bool,
}

impl Quadratic {
    /// The roots in rising order; a touching root once.
    pub fn roots(&self) -> &[f64] {
        &self.roots[..self.n]
    }
}

/// Roots of `a l^2 + 2 b l + c = 0`; `scale` is the size of the lengths at stake, against which a leading
/// coefficient counts as zero.
///
/// APT: `QUAD`. The discriminant is `b^2 - a c`. The root of smaller size is `c / q`, free of cancellation.
pub fn quadratic(a: f64, b: f64, c: f64, scale: f64) -> Result<Quadratic, Reason> {
    let one = |l: f64, grazing| Quadratic { roots: [l, l], n: 1, grazing };
    if a.abs() * scale * scale <= LEADING * (b.abs() * scale).max(c.abs()) || a == 0.0 {
        return if b.abs() * scale > LEADING * c.abs() && b != 0.0 {
            Ok(one(-c / (2.0 * b), false))
        } else if c.abs() <= f64::MIN_POSITIVE {
            Err(Reason::AllHit)
        } else {
            Err(Reason::NoHit)
        };
    }
    let disc = b * b - a * c;
    if disc <= TOUCH * (b * b + (a * c).abs()) {
        return if disc >= -TOUCH * (b * b + (a * c).abs()) {
            Ok(one(-b / a, true))
        } else {
            Err(Reason::NoHit)
        };
    }
    let q = -(b + disc.sqrt().copysign(b));
    let (l1, l2) = (q / a, c / q);
    Ok(Quadratic { roots: [l1.min(l2), l1.max(l2)], n: 2, grazing: false })
}

/// Highest degree that [`polynomial`] takes.
pub const MAX_DEGREE: usize = 8;

/// Real roots in [lo, hi] of `c[0] + c[1] x + ... + c[n] x^n`, n at most [`MAX_DEGREE`], in rising order,
/// each once whatever its multiplicity. Empty for a constant.
///
/// Between two neighbouring stationary points a polynomial is monotone, so the roots of each derivative
/// bracket those of the next lower one: no case is ill-conditioned but by its own roots.
///
/// APT: `EQUAZ3` for the cubic, which may degenerate to a quadratic or a line.
pub fn polynomial(c: &[f64], lo: f64, hi: f64) -> Vec<f64> {
    assert!(c.len() <= MAX_DEGREE + 1, "degree of a polynomial at most {MAX_DEGREE}");
    let size = lo.abs().max(hi.abs()).max(f64::MIN_POSITIVE);
    // Leading coefficients that cannot matter inside the interval only bring spurious far roots.
    let mut power = 1.0;
    let weights: Vec<f64> = c
        .iter()
        .map(|k| {
            let w = k.abs() * power;
            power *= size;
            w
        })
        .collect();
    let greatest = weights.iter().fold(0.0_f64, |m, w| m.max(*w));
    let degree = weights.iter().rposition(|w| *w > 1e-3 * LEADING * greatest).unwrap_or(0);
    let mut stationary: Vec<f64> = Vec::new();
    for d in 1..=degree {
        // The derivative of order `degree - d`, of degree d.
        let order = degree - d;
        let derived: Vec<f64> = (0..=d).map(|i| c[i + order] * falling(i + order, order)).collect();
        stationary = between(&derived, &stationary, lo, hi);
    }
    stationary
}

fn falling(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |p, i| p * u32::try_from(n - i).map_or(0.0, f64::from))
}

/// Value at x, and the sum of the sizes of the terms.
fn eval(c: &[f64], x: f64) -> (f64, f64) {
    c.iter().rev().fold((0.0, 0.0), |(v, s), k| (v * x + k, s * x.abs() + k.abs()))
}

/// Roots of `c` given the stationary points that separate them.
fn between(c: &[f64], stationary: &[f64], lo: f64, hi: f64) -> Vec<f64> {
    let mut roots: Vec<f64> = Vec::new();
    let mut push = |x: f64| {
        if roots.last().is_none_or(|last| x - last > 4.0 * f64::EPSILON * x.abs()) {
            roots.push(x);
        }
    };
    let zero = |x: f64| {
        let (v, s) = eval(c, x);
        v.abs() <= TOUCH * s
    };
    let mut a = lo;
    for b in stationary.iter().copied().chain([hi]) {
        let (fa, fb) = (eval(c, a).0, eval(c, b).0);
        let (za, zb) = (zero(a), zero(b));
        if za {
            push(a);
        }
        if !za && !zb && (fa < 0.0) != (fb < 0.0) {
            push(bisect(c, a, b, fa));
        } else if zb {
            push(b);
        }
        a = b;
    }
    roots
}

/// Root in a bracket by Newton's step kept inside by bisection.
fn bisect(c: &[f64], a: f64, b: f64, fa: f64) -> f64 {
    let (mut a, mut b) = (a, b);
    let mut x = 0.5 * (a + b);
    // Each pass halves the bracket or takes a Newton step that halves the last one: 128 are never used up.
    let mut last = b - a;
    for _ in 0..128 {
        let (mut v, mut slope) = (0.0, 0.0);
        for k in c.iter().rev() {
            slope = slope * x + v;
            v = v * x + k;
        }
        if v == 0.0 {
            return x;
        }
        if (v < 0.0) == (fa < 0.0) {
            a = x;
        } else {
            b = x;
        }
        let step = -v / slope;
        let newton = x + step;
        let next = if slope != 0.0 && newton > a && newton < b && step.abs() < 0.5 * last {
            last = step.abs();
            newton
        } else {
            last = b - a;
            0.5 * (a + b)
        };
        if (next - x).abs() <= f64::EPSILON * next.abs() || b - a <= f64::EPSILON * b.abs() {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "some closed forms are met to the last bit")]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn published_quadratics() {
        let q = |a, b, c| quadratic(a, b, c, 1.0).map(|q| q.roots().to_vec());
        assert_eq!(q(1.0, -3.0, 5.0), Ok(vec![1.0, 5.0]));
        assert_eq!(q(1.0, 3.0, 5.0), Ok(vec![-5.0, -1.0]));
        assert_eq!(q(0.0, 2.0, -8.0), Ok(vec![2.0]));
        assert_eq!(q(0.0, 0.0, 1.0), Err(Reason::NoHit));
        assert_eq!(q(0.0, 0.0, 0.0), Err(Reason::AllHit));
        let double = quadratic(1.0, 1.0, 1.0, 1.0).unwrap();
        assert!(double.grazing);
        assert_eq!(double.roots(), [-1.0]);
        assert_eq!(q(1.0, 1e8, 1.0).unwrap()[1], -5.0e-9);
        assert_eq!(q(1.0, 0.0, -4.0), Ok(vec![-2.0, 2.0]));
        assert_eq!(q(1.0, 0.0, 4.0), Err(Reason::NoHit));
    }

    #[test]
    fn polynomials_with_double_roots_and_lost_leading_terms() {
        assert_eq!(polynomial(&[-6.0, 11.0, -6.0, 1.0], -10.0, 10.0).len(), 3);
        let touch = polynomial(&[0.0, 0.0, -1.0, 1.0], -2.0, 2.0);
        assert_eq!(touch.len(), 2);
        assert!((touch[1] - 1.0).abs() < 1e-15);
        assert_eq!(polynomial(&[-1.0, 1.0, 0.0, 1e-40], 0.0, 5.0), [1.0]);
        assert!(polynomial(&[3.0], -1.0, 1.0).is_empty());
    }

    proptest! {
        #[test]
        fn products_of_roots_are_found(r in prop::array::uniform4(-9.0_f64..9.0)) {
            let mut r = r;
            r.sort_by(f64::total_cmp);
            prop_assume!(r.windows(2).all(|w| w[1] - w[0] > 1e-2));
            let mut c = vec![1.0];
            for x in r {
                let mut next = vec![0.0; c.len() + 1];
                for (i, k) in c.iter().enumerate() {
                    next[i] -= k * x;
                    next[i + 1] += k;
                }
                c = next;
            }
            let found = polynomial(&c, -10.0, 10.0);
            prop_assert_eq!(found.len(), 4);
            for (f, x) in found.iter().zip(r) {
                prop_assert!((f - x).abs() < 1e-7, "{} {}", f, x);
            }
        }
    }
}
