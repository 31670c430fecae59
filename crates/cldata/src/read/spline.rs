//! NURBS of NX: knots and control points, made into chords.

use aptc_geometry::Vec3;

/// Most chords of one span; what it trades is memory against a tolerance that no span of a tool path asks
/// for.
const MOST_CHORDS: usize = 4096;

/// A spline that is being read.
#[derive(Default)]
pub(super) struct Spline {
    pub(super) on: bool,
    pub(super) knots: Vec<f64>,
    pub(super) points: Vec<Vec3>,
}

impl Spline {
    pub(super) fn is_empty(&self) -> bool {
        !self.on
    }

    /// Chords of the cubic from `start` over the control points read, each within `tolerance` of the
    /// curve; empty when knots and points do not fit together. The knots given are those after the start,
    /// the last one the end of the curve.
    pub(super) fn chords(&self, start: Vec3, tolerance: f64) -> Option<Vec<Vec3>> {
        let mut control = vec![start];
        control.extend_from_slice(&self.points);
        let n = control.len();
        let degree = 3;
        if n <= degree || self.knots.is_empty() {
            return None;
        }
        let first = 0.0;
        let last = *self.knots.last()?;
        let inner = &self.knots[..self.knots.len() - 1];
        if inner.len() + degree + 1 != n {
            return None;
        }
        let mut knots = vec![first; degree + 1];
        knots.extend_from_slice(inner);
        knots.extend([last; 4]);
        if knots.windows(2).any(|w| w[1] < w[0]) || last <= first {
            return None;
        }
        let mut out = Vec::new();
        for span in degree..n {
            let (a, b) = (knots[span], knots[span + 1]);
            if b <= a {
                continue;
            }
            let pieces = pieces(&knots, &control, span, tolerance);
            for i in 1..=pieces {
                let t = a + (b - a) * i as f64 / pieces as f64;
                out.push(evaluate(&knots, &control, span, t));
            }
        }
        Some(out)
    }
}

/// Chords that a span needs: h^2/8 times the largest second derivative, which a cubic takes at an end.
fn pieces(knots: &[f64], control: &[Vec3], span: usize, tolerance: f64) -> usize {
    let (a, b) = (knots[span], knots[span + 1]);
    let h = (b - a) / 64.0;
    let second = |t: f64| {
        let p = |t| evaluate(knots, control, span, t);
        ((p(t - h) + p(t + h) - p(t) * 2.0) / (h * h)).norm()
    };
    let most = second(a).max(second(b)).max(second((a + b) / 2.0));
    let n = ((b - a) * (b - a) * most / (8.0 * tolerance)).sqrt().ceil();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
    let n = n.clamp(1.0, MOST_CHORDS as f64) as usize;
    n
}

/// De Boor's recurrence on the polynomial of a span, also a little outside of it.
fn evaluate(knots: &[f64], control: &[Vec3], span: usize, t: f64) -> Vec3 {
    let mut d = [control[span - 3], control[span - 2], control[span - 1], control[span]];
    for r in 1..=3 {
        for j in (r..=3).rev() {
            let i = span - 3 + j;
            let width = knots[i + 4 - r] - knots[i];
            let w = if width > 0.0 { (t - knots[i]) / width } else { 0.0 };
            d[j] = d[j - 1] * (1.0 - w) + d[j] * w;
        }
    }
    d[3]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bezier_arc_is_followed() {
        // One span: the cubic Bezier curve of these points.
        let c = [
            Vec3::zeros(),
            Vec3::new(0.0, 4.0, 0.0),
            Vec3::new(4.0, 4.0, 0.0),
            Vec3::new(4.0, 0.0, 2.0),
        ];
        let spline = Spline { on: true, knots: vec![1.0], points: c[1..].to_vec() };
        let chords = spline.chords(c[0], 0.001).unwrap();
        let bezier = |t: f64| {
            let s = 1.0 - t;
            c[0] * s * s * s + c[1] * 3.0 * s * s * t + c[2] * 3.0 * s * t * t + c[3] * t * t * t
        };
        let n = chords.len();
        for (i, p) in chords.iter().enumerate() {
            assert!((p - bezier((i + 1) as f64 / n as f64)).norm() < 1e-12);
        }
        let mut last = c[0];
        for (i, p) in chords.iter().enumerate() {
            let middle = bezier((i as f64 + 0.5) / n as f64);
            assert!(((last + p) / 2.0 - middle).norm() < 0.001);
            last = *p;
        }
        assert!((20..90).contains(&n), "{n}");
        let wrong = Spline { on: true, knots: vec![0.5, 1.0], points: c[1..].to_vec() };
        assert!(wrong.chords(c[0], 0.001).is_none());
    }
}
