//! Real roots of polynomials in an interval.

/// Most coefficients that [`roots`] takes.
const MAX: usize = 12;

/// Value at `x` of the polynomial with the coefficients `c`, constant first.
pub fn value(c: &[f64], x: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// The roots in `[lo, hi]` of a polynomial of degree 11 at most, constant first, in ascending order.
///
/// The roots of the derivative cut the interval into pieces where the polynomial rises or falls; in each
/// a change of sign is closed in on by bisection and secants until it cannot be told apart. A place where
/// the polynomial only comes within `touch` of zero counts as a root. A polynomial that is zero
/// everywhere has none.
pub fn roots(c: &[f64], lo: f64, hi: f64, touch: f64) -> Vec<f64> {
    let n = c.iter().rposition(|c| *c != 0.0).map_or(0, |i| i + 1);
    debug_assert!(n <= MAX, "a polynomial of degree {n}");
    if !(2..=MAX).contains(&n) {
        return Vec::new();
    }
    let c = &c[..n];
    let mut derivative = [0.0; MAX];
    for (i, d) in derivative[..n - 1].iter_mut().enumerate() {
        *d = c[i + 1] * f64::from(u32::try_from(i + 1).unwrap_or(u32::MAX));
    }
    let mut cuts = vec![lo];
    cuts.extend(roots(&derivative[..n - 1], lo, hi, 0.0));
    cuts.push(hi);
    let mut found: Vec<f64> = Vec::new();
    let mut keep = |x: f64| {
        if found.last().is_none_or(|last| x > *last) {
            found.push(x);
        }
    };
    for (i, pair) in cuts.windows(2).enumerate() {
        let (a, b) = (pair[0], pair[1]);
        let (fa, fb) = (value(c, a), value(c, b));
        if fa == 0.0 || (i > 0 && fa.abs() <= touch) {
            keep(a);
        }
        if fa * fb < 0.0 && !(i > 0 && fa.abs() <= touch) {
            keep(between(c, a, b, fa));
        }
        if fb == 0.0 && i + 2 == cuts.len() {
            keep(b);
        }
    }
    found
}

/// The root between `a` and `b`, where the signs differ: false position with halved ends (Illinois),
/// bisection whenever that is slow. 200 halvings end below any spacing of doubles.
fn between(c: &[f64], mut a: f64, mut b: f64, mut fa: f64) -> f64 {
    let mut fb = value(c, b);
    let (mut wa, mut wb) = (fa, fb);
    for i in 0..200 {
        let middle = 0.5 * (a + b);
        let secant = (a * wb - b * wa) / (wb - wa);
        let x = if i % 3 == 2 || !(secant > a && secant < b) { middle } else { secant };
        if x <= a || x >= b {
            break;
        }
        let f = value(c, x);
        if f == 0.0 {
            return x;
        }
        if (f < 0.0) == (fa < 0.0) {
            (a, fa, wa) = (x, f, f);
            wb *= 0.5;
        } else {
            (b, fb, wb) = (x, f, f);
            wa *= 0.5;
        }
    }
    if fa.abs() < fb.abs() { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_roots_come_back() {
        // (x - 1/8)(x - 1/2)(x - 3/4)
        let c = [-0.046875, 0.53125, -1.375, 1.0];
        let r = roots(&c, 0.0, 1.0, 0.0);
        assert_eq!(r.len(), 3);
        for (x, y) in r.iter().zip([0.125, 0.5, 0.75]) {
            assert!((x - y).abs() < 1e-14, "{r:?}");
        }
        assert_eq!(roots(&c, 0.2, 0.6, 0.0).len(), 1);
    }

    #[test]
    fn a_touched_zero_counts() {
        let c = [0.25 + 1e-14, -1.0, 1.0];
        assert!(roots(&c, 0.0, 1.0, 0.0).is_empty());
        let r = roots(&c, 0.0, 1.0, 1e-12);
        assert!(r.len() == 1 && (r[0] - 0.5).abs() < 1e-9);
    }
}
