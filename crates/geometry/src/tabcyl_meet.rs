//! Where a TABCYL meets lines, and where lines and circles touch it, in the plane of its directrix.

use crate::tabcyl::left;
use crate::{Tabcyl, TabcylSpan, Vec2, Vec3, polynomial};

/// A place on the directrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveFoot {
    /// Number of the span.
    pub span: usize,
    /// How far along its chord.
    pub s: f64,
    /// The point.
    pub point: Vec2,
}

/// Share of a chord by which a place may lie beyond its ends, so that none is lost at a joint.
const JOINT: f64 = 1e-10;

/// Share of the chord within which a curve counts as touching.
const TOUCH: f64 = 1e-13;

/// Product of two polynomials.
fn times(a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

fn plus(a: &[f64], b: &[f64], factor: f64) -> Vec<f64> {
    let n = a.len().max(b.len());
    let at = |c: &[f64], i: usize| c.get(i).copied().unwrap_or(0.0);
    (0..n).map(|i| at(a, i) + factor * at(b, i)).collect()
}

impl TabcylSpan {
    /// The offset as a polynomial of t = s / L, in shares of L.
    fn unit(&self) -> [f64; 4] {
        let (a, b) = (self.a * self.length * self.length, self.b * self.length);
        [0.0, -(a + b), b, a]
    }
}

/// The same curve over a chord of length 1 along x, and its derivative.
struct Unit {
    v: [f64; 4],
    slope: [f64; 3],
}

impl Unit {
    fn of(span: &TabcylSpan) -> Self {
        let v = span.unit();
        Self { v, slope: [v[1], 2.0 * v[2], 3.0 * v[3]] }
    }
}

impl Tabcyl {
    /// Every place where the directrix, straight ends included, cuts or touches the line `n . p = d`.
    pub fn meets_line(&self, n: Vec2, d: f64) -> Vec<CurveFoot> {
        self.places(true, |span, chord, unit| {
            let (x, y) = (n.dot(&chord), n.dot(&left(chord)));
            let constant = (n.dot(&span.start) - d) / span.length;
            plus(&plus(&[constant, x], &unit.v, y), &[], 0.0)
        })
    }

    /// Directed distances along the unit direction `d` from `p` to the surface, rising; `None` when `d` runs
    /// along the generatrix.
    pub fn ray(&self, p: Vec3, d: Vec3) -> Option<Vec<f64>> {
        let (from, along) = (self.flatten(p), self.flatten(d));
        // Steeper, and the distance would be lost in rounding.
        if along.norm() <= 1e-10 * d.norm() {
            return None;
        }
        let n = left(along).normalize();
        let feet = self.meets_line(n, n.dot(&from));
        let far = |f: &CurveFoot| along.dot(&(f.point - from)) / along.norm_squared();
        let mut all: Vec<f64> = feet.iter().map(far).collect();
        all.sort_by(f64::total_cmp);
        Some(all)
    }

    /// The place of the directrix, straight ends included, that is nearest to a point of its plane.
    pub fn nearest_to(&self, p: Vec2) -> Option<CurveFoot> {
        let mut feet = self.normals_from(p);
        // A corner between two spans, or an end, may be nearer than any upright place.
        let start = |i: usize| CurveFoot { span: i, s: 0.0, point: self.spans[i].start };
        feet.extend((0..self.spans.len()).map(start));
        feet.extend(self.spans.last().map(|l| CurveFoot {
            span: self.spans.len() - 1,
            s: l.length,
            point: self.end,
        }));
        nearest_foot(&feet, p)
    }

    /// Every place where a line through `p` touches the directrix; the straight ends do not count.
    pub fn tangents_from(&self, p: Vec2) -> Vec<CurveFoot> {
        self.places(false, |span, chord, unit| {
            let way = (p - span.start) / span.length;
            let (s, v) = (way.dot(&chord), chord.perp(&way));
            // (t - s) slope - (offset - v)
            plus(&plus(&times(&[-s, 1.0], &unit.slope), &unit.v, -1.0), &[v], 1.0)
        })
    }

    /// Every place, straight ends included, where the perpendicular to the directrix goes through `p`.
    pub fn normals_from(&self, p: Vec2) -> Vec<CurveFoot> {
        self.places(true, |span, chord, unit| {
            let way = (p - span.start) / span.length;
            let (s, v) = (way.dot(&chord), chord.perp(&way));
            plus(&times(&plus(&unit.v, &[v], -1.0), &unit.slope), &[-s, 1.0], 1.0)
        })
    }

    /// Every circle of radius `r` that touches the directrix and has its centre on the line `n . p = d`:
    /// place of the touch, and centre.
    pub fn circles_on_line(&self, n: Vec2, d: f64, r: f64) -> Vec<(CurveFoot, Vec2)> {
        // With q the point, N the unit normal: n.q - d = -+ r n.N, squared to be a polynomial.
        let feet = self.places(true, |span, chord, unit| {
            let (x, y) = (n.dot(&chord), n.dot(&left(chord)));
            let constant = (n.dot(&span.start) - d) / span.length;
            let reach = plus(&[constant, x], &unit.v, y);
            let normal = plus(&[y], &unit.slope, -x);
            let stretch = plus(&[1.0], &times(&unit.slope, &unit.slope), 1.0);
            let k = r / span.length;
            plus(&times(&times(&reach, &reach), &stretch), &times(&normal, &normal), -k * k)
        });
        let mut found = Vec::new();
        for foot in feet {
            let off = |f: &CurveFoot, r: f64| n.dot(&(f.point + self.left_normal(f) * r)) - d;
            let side = if off(&foot, r).abs() <= off(&foot, -r).abs() { r } else { -r };
            let foot = self.polished(foot, n, d, side);
            if off(&foot, side).abs() <= 1e-10 * (foot.point.amax() + r) {
                found.push((foot, foot.point + self.left_normal(&foot) * side));
            }
        }
        found
    }

    fn left_normal(&self, f: &CurveFoot) -> Vec2 {
        left(self.tangent(f.span, f.s)).normalize()
    }

    /// Newton on the offset curve itself: the squared equation has lost half the figures where `r` is
    /// small.
    fn polished(&self, mut foot: CurveFoot, n: Vec2, d: f64, side: f64) -> CurveFoot {
        let off = |f: &CurveFoot| n.dot(&(f.point + self.left_normal(f) * side)) - d;
        for _ in 0..4 {
            let (span, s) = (foot.span, foot.s);
            let bend = 1.0 - side * self.curvature(span, s);
            let step = off(&foot) / (n.dot(&self.tangent(span, s)) * bend);
            let s = (s - step).clamp(0.0, self.spans[span].length);
            let next = CurveFoot { span, s, point: self.point(span, s) };
            if !step.is_finite() || off(&next).abs() >= off(&foot).abs() {
                break;
            }
            foot = next;
        }
        foot
    }

    /// The places in all spans where the polynomial of s / L that `make` gives is zero.
    fn places(
        &self,
        ends: bool,
        make: impl Fn(&TabcylSpan, Vec2, &Unit) -> Vec<f64>,
    ) -> Vec<CurveFoot> {
        let mut found: Vec<CurveFoot> = Vec::new();
        let last = self.spans.len().saturating_sub(1);
        let straight = !ends && !self.closed();
        for (i, span) in self.spans.iter().enumerate() {
            if straight && (i == 0 || i == last) {
                continue;
            }
            let c = make(span, self.chord(i), &Unit::of(span));
            let size = c.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
            for t in polynomial::roots(&c, -JOINT, 1.0 + JOINT, TOUCH * size) {
                let s = t.clamp(0.0, 1.0) * span.length;
                let point = self.point(i, s);
                let same = |f: &CurveFoot| (f.point - point).norm() <= 4.0 * JOINT * span.length;
                let before = found.last().filter(|f: &&CurveFoot| f.span + 1 == i);
                let first = found.first().filter(|f| i == last && i > 0 && f.span == 0);
                let joined = first.filter(|_| self.closed());
                if !(before.is_some_and(same) || joined.is_some_and(same)) {
                    found.push(CurveFoot { span: i, s, point });
                }
            }
        }
        found
    }
}

/// Of several places the one nearest to `p`.
pub fn nearest_foot(feet: &[CurveFoot], p: Vec2) -> Option<CurveFoot> {
    let far = |f: &CurveFoot| (f.point - p).norm_squared();
    feet.iter().copied().min_by(|a, b| far(a).total_cmp(&far(b)))
}

#[cfg(test)]
mod tests {
    use nalgebra::Matrix3;

    use super::*;
    use crate::{Fit, Knot, trig};

    fn wave() -> Tabcyl {
        let knots: Vec<Knot> = (0..30)
            .map(|i| {
                let x = f64::from(i) * 0.25;
                Knot { point: Vec2::new(x, trig::sin(x * 2.0)), tangent: None }
            })
            .collect();
        Tabcyl::fit(&knots, Fit::Spline, Matrix3::identity(), 10.0).unwrap()
    }

    #[test]
    fn a_line_is_met_on_the_line_and_on_the_curve() {
        let t = wave();
        let feet = t.meets_line(Vec2::new(0.0, 1.0), 0.25);
        // Up and down through .25 from 0 to 7.25, and the straight end that falls from there.
        assert_eq!(feet.len(), 6, "{feet:?}");
        for f in feet {
            assert!((f.point.y - 0.25).abs() < 1e-13);
            assert!((t.point(f.span, f.s) - f.point).norm() < 1e-15);
        }
        // Through a knot, where two spans meet.
        let knot = t.spans[5].start;
        assert_eq!(t.meets_line(Vec2::new(1.0, 0.0), knot.x).len(), 1);
    }

    #[test]
    fn tangents_and_normals_go_through_the_point() {
        let t = wave();
        for p in [Vec2::new(3.0, 4.0), Vec2::new(-2.0, 0.7), t.spans[7].start] {
            let tangents = t.tangents_from(p);
            assert!(!tangents.is_empty(), "{p:?}");
            for f in tangents {
                let along = t.tangent(f.span, f.s).normalize();
                assert!(along.perp(&(p - f.point)).abs() < 1e-9, "{p:?} {f:?}");
            }
            let normals = t.normals_from(p);
            assert!(!normals.is_empty());
            for f in normals {
                let along = t.tangent(f.span, f.s).normalize();
                assert!(along.dot(&(p - f.point)).abs() < 1e-9, "{p:?} {f:?}");
            }
        }
    }

    #[test]
    fn circles_touch_at_their_radius() {
        let t = wave();
        let n = Vec2::new(0.6, 0.8);
        let found = t.circles_on_line(n, 2.0, 0.3);
        assert!(found.len() >= 2, "{found:?}");
        for (f, c) in found {
            let along = t.tangent(f.span, f.s).normalize();
            assert!((n.dot(&c) - 2.0).abs() < 1e-9, "{}", n.dot(&c) - 2.0);
            assert!(((c - f.point).norm() - 0.3).abs() < 1e-12);
            assert!(along.dot(&(c - f.point)).abs() < 1e-12);
        }
    }

    #[test]
    fn rays_and_nearest_points_lie_on_the_surface() {
        let t = wave();
        let (p, d) = (Vec3::new(3.0, 5.0, 1.0), Vec3::new(0.1, -0.9, 0.4).normalize());
        let hits = t.ray(p, d).unwrap();
        assert!(!hits.is_empty());
        for far in hits {
            let q = t.flatten(p + d * far);
            let foot = t.nearest_to(q).unwrap();
            assert!((foot.point - q).norm() < 1e-12);
        }
        assert!(t.ray(p, Vec3::z()).is_none());
        let q = Vec2::new(3.0, 0.3);
        let best = t.nearest_to(q).unwrap();
        let sampled = (0..t.spans.len())
            .flat_map(|i| (0..=50).map(move |k| (i, f64::from(k) / 50.0)))
            .map(|(i, s)| (t.point(i, s * t.spans[i].length) - q).norm())
            .fold(f64::MAX, f64::min);
        assert!((best.point - q).norm() <= sampled);
    }
}
