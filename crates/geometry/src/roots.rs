//! Roots of the quadratic that every ray against sphere, cylinder, cone and quadric asks for.

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

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "some closed forms are met to the last bit")]
mod tests {
    use super::*;

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
}
