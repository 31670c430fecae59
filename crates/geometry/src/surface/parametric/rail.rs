//! A rail of a ruled surface as polynomials: each evaluation of the curve itself meets a surface with a line.
//!
//! Over every piece the height above the base line is the polynomial of the fifth degree that has its value
//! and both derivatives at the ends. A piece is halved until its middle is met, far closer than any band asks; where that takes
//! too many halvings (at a joint of a TABCYL) the curve itself is asked.

/// How often a piece is halved.
const HALVINGS: u32 = 6;
/// Share of the curve's size to which it is met, of the height and of its first two derivatives: one near rounding takes twice
/// the pieces.
const EXACT: [f64; 3] = [1e-13, 1e-10, 1e-7];

/// A function over 0 to 1 in pieces.
#[derive(Clone, Debug)]
pub(super) struct Pieces {
    /// Equal cells.
    n: u32,
    /// For each of them the first of its pieces and how many it has.
    cells: Vec<(usize, u32)>,
    /// Coefficients over 0 to 1 within the piece; `None` where the function itself is to be asked.
    pieces: Vec<Option<[f64; 6]>>,
}

/// Value and first two derivatives.
pub(super) type Jet3 = [f64; 3];

impl Pieces {
    /// The pieces of `f` in `n` equal cells; `size` is a length of the size of the curve.
    pub(super) fn new(n: u32, size: f64, f: impl Fn(f64) -> Jet3) -> Self {
        let mut new = Self { n, cells: Vec::new(), pieces: Vec::new() };
        let mut from = f(0.0);
        for i in 0..n {
            let ends = [i, i + 1].map(|i| f64::from(i) / f64::from(n));
            let to = f(ends[1]);
            new.cell(ends, [from, to], size, &f);
            from = to;
        }
        new
    }

    fn cell(&mut self, [a, b]: [f64; 2], ends: [Jet3; 2], size: f64, f: &impl Fn(f64) -> Jet3) {
        let first = self.pieces.len();
        // The middle of the first piece is the end of the first one of the next round.
        let mut middle = None;
        for halvings in 0..=HALVINGS {
            let n = 1_u32 << halvings;
            let last = halvings == HALVINGS;
            self.pieces.truncate(first);
            let h = (b - a) / f64::from(n);
            let mut from = ends[0];
            for i in 0..n {
                let at = a + h * f64::from(i);
                let known = if i + 1 == n { Some(ends[1]) } else { middle.filter(|_| i == 0) };
                let to = known.unwrap_or_else(|| f(at + h));
                let c = quintic(from, to, h);
                let (mid, is) = (evaluate(&c, 0.5, 1.0 / h), f(at + 0.5 * h));
                if i == 0 {
                    middle = Some(is);
                }
                let off = |k: usize| (mid[k] - is[k]).abs() <= EXACT[k] * size;
                let exact = (0..3).all(off);
                if !(exact || last) {
                    break;
                }
                self.pieces.push(exact.then_some(c));
                from = to;
            }
            if self.pieces.len() - first == n as usize {
                self.cells.push((first, n));
                return;
            }
        }
    }

    /// Value and derivatives at `u` in [0, 1]; `None` where the function itself is to be asked.
    #[inline(always)]
    pub(super) fn at(&self, u: f64) -> Option<Jet3> {
        let (i, s) = place(u, self.n);
        let (first, n) = self.cells[i as usize];
        let (j, t) = place(s, n);
        let c = self.pieces[first + j as usize].as_ref()?;
        Some(evaluate(c, t, f64::from(self.n * n)))
    }

    /// Bounds of first and second derivative between two places in [0, 1]; `None` where the function itself is to be asked.
    pub(super) fn slopes(&self, [a, b]: [f64; 2]) -> Option<[[f64; 2]; 2]> {
        let mut all = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let (from, (mut to, rest)) = (place(a, self.n).0, place(b, self.n));
        if rest <= 0.0 && to > from {
            to -= 1;
        }
        for (first, n) in &self.cells[from as usize..=to as usize] {
            let inverse = f64::from(self.n * n);
            for piece in &self.pieces[*first..*first + *n as usize] {
                let [_, d, e, p, q, r] = *piece.as_ref()?;
                let once = range([d, 2.0 * e, 3.0 * p, 4.0 * q, 5.0 * r]);
                let twice = range([2.0 * e, 6.0 * p, 12.0 * q, 20.0 * r]);
                for (all, (found, scale)) in
                    all.iter_mut().zip([(once, inverse), (twice, inverse * inverse)])
                {
                    *all = [all[0].min(found[0] * scale), all[1].max(found[1] * scale)];
                }
            }
        }
        Some(all)
    }
}

/// Least and greatest coefficient of a polynomial by Bernstein's polynomials, between which its values over 0 to 1 lie.
fn range<const N: usize>(c: [f64; N]) -> [f64; 2] {
    let mut all = [f64::INFINITY, f64::NEG_INFINITY];
    let mut row = c;
    // The coefficient of t^j is spread over the later ones by C(i, j) / C(n, j).
    let n = N - 1;
    let mut over = 1.0;
    for (j, x) in row.iter_mut().enumerate() {
        *x /= over;
        over *= (n - j) as f64 / (j + 1) as f64;
    }
    for i in 0..N {
        let mut choose = 1.0;
        let mut sum = 0.0;
        for (j, x) in row[..=i].iter().enumerate() {
            sum += choose * x;
            choose *= (i - j) as f64 / (j + 1) as f64;
        }
        all = [all[0].min(sum), all[1].max(sum)];
    }
    all
}

/// Which of `n` equal parts of [0, 1] holds `u`, and where in it.
#[inline(always)]
fn place(u: f64, n: u32) -> (u32, f64) {
    let x = u * f64::from(n);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to n")]
    let i = (x as u32).min(n - 1);
    (i, x - f64::from(i))
}

/// The polynomial over 0 to 1 with these values and derivatives (by the length `h`) at its ends.
fn quintic(a: Jet3, b: Jet3, h: f64) -> [f64; 6] {
    let [f, d, e] = [a[0], a[1] * h, 0.5 * a[2] * h * h];
    let rise = b[0] - f - d - e;
    let slope = b[1] * h - d - 2.0 * e;
    let bend = 0.5 * b[2] * h * h - e;
    [
        f,
        d,
        e,
        10.0 * rise - 4.0 * slope + bend,
        -15.0 * rise + 7.0 * slope - 2.0 * bend,
        6.0 * rise - 3.0 * slope + bend,
    ]
}

/// Value and derivatives at `t`; `inverse` is one over the length.
#[inline(always)]
fn evaluate(c: &[f64; 6], t: f64, inverse: f64) -> Jet3 {
    let [f, d, e, p, q, r] = *c;
    let value = f + t * (d + t * (e + t * (p + t * (q + t * r))));
    let first = d + t * (2.0 * e + t * (3.0 * p + t * (4.0 * q + t * 5.0 * r)));
    let second = 2.0 * e + t * (6.0 * p + t * (12.0 * q + t * 20.0 * r));
    [value, first * inverse, second * (inverse * inverse)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trig;

    #[test]
    fn a_smooth_function_is_met_and_a_kink_is_left_to_itself() {
        let smooth = |u: f64| {
            let (s, c) = trig::sin_cos(5.0 * u);
            [s, 5.0 * c, -25.0 * s]
        };
        let pieces = Pieces::new(8, 1.0, smooth);
        assert!(pieces.pieces.iter().all(Option::is_some));
        for i in 0..=1000 {
            let u = f64::from(i) / 1000.0;
            let (is, wanted) = (pieces.at(u).unwrap(), smooth(u));
            for k in 0..3 {
                assert!((is[k] - wanted[k]).abs() <= 20.0 * EXACT[k], "{u} {k}");
            }
        }
        let kink = |u: f64| if u < 0.3 { [0.3 - u, -1.0, 0.0] } else { [u - 0.3, 1.0, 0.0] };
        let pieces = Pieces::new(4, 1.0, kink);
        assert!(pieces.at(0.3).is_none());
        assert!((pieces.at(0.9).unwrap()[0] - 0.6).abs() < 1e-15);
    }
}
