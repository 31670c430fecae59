//! TABCYL: the cylinder over a faired plane curve.
//!
//! The directrix lies in the plane of the axes u and v, the generatrix runs along w. Over each chord of
//! the directrix stands one cubic `a s^3 + b s^2 - (a L^2 + b L) s`, s along the chord of length L, the
//! offset positive to the left. The first and the last span are straight: they prolong the curve. One whose last point is its
//! first goes round, and has none.

use nalgebra::{Matrix3, Vector2};
use serde::{Deserialize, Serialize};

use crate::{Transform, Vec3};

/// A point or vector of the plane of a directrix.
pub type Vec2 = Vector2<f64>;

/// TABCYL.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tabcyl {
    /// Rows: the unit axes u, v, w (right-handed) in the part's system.
    pub axes: Matrix3<f64>,
    /// The spans in order, the straight ones at both ends included, if it does not go round.
    pub spans: Vec<TabcylSpan>,
    /// Far end of the last span.
    pub end: Vec2,
}

/// One chord with its cubic.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TabcylSpan {
    /// Where the chord begins.
    pub start: Vec2,
    /// Coefficient of s^3.
    pub a: f64,
    /// Coefficient of s^2.
    pub b: f64,
    /// Length of the chord.
    pub length: f64,
    /// Greatest offset over the chord, at least 0.
    pub max: f64,
    /// Least offset over the chord, at most 0.
    pub min: f64,
}

impl TabcylSpan {
    /// The span with its extreme offsets.
    pub fn new(start: Vec2, a: f64, b: f64, length: f64) -> Self {
        crate::tabcyl_fit::span(start, a, b, length)
    }

    /// Offset from the chord at `s` along it.
    pub fn offset(&self, s: f64) -> f64 {
        let l = self.length;
        s * (self.a * (s * s - l * l) + self.b * (s - l))
    }

    /// Derivative of the offset at `s`.
    pub fn slope(&self, s: f64) -> f64 {
        let l = self.length;
        3.0 * self.a * s * s + 2.0 * self.b * s - self.a * l * l - self.b * l
    }

    /// Second derivative of the offset at `s`.
    pub fn second(&self, s: f64) -> f64 {
        6.0 * self.a * s + 2.0 * self.b
    }
}

impl Tabcyl {
    /// The axis u.
    pub fn u(&self) -> Vec3 {
        self.axes.row(0).transpose()
    }

    /// The axis v.
    pub fn v(&self) -> Vec3 {
        self.axes.row(1).transpose()
    }

    /// The direction of the generatrix.
    pub fn w(&self) -> Vec3 {
        self.axes.row(2).transpose()
    }

    /// The point of the directrix's plane below `p`, looking along the generatrix.
    pub fn flatten(&self, p: Vec3) -> Vec2 {
        Vec2::new(self.u().dot(&p), self.v().dot(&p))
    }

    /// The point of space at (u, v) and at height w.
    pub fn lift(&self, p: Vec2, w: f64) -> Vec3 {
        self.u() * p.x + self.v() * p.y + self.w() * w
    }

    /// Does the curve go round, its last point being its first? Then nothing prolongs it.
    pub fn closed(&self) -> bool {
        self.spans.first().is_some_and(|first| first.start == self.end)
    }

    /// The span that ends where span `i` begins.
    pub fn span_before(&self, i: usize) -> Option<usize> {
        let round = || self.closed().then(|| self.spans.len() - 1);
        i.checked_sub(1).or_else(round)
    }

    /// The span that begins where span `i` ends.
    pub fn span_after(&self, i: usize) -> Option<usize> {
        let next = i + 1;
        if next < self.spans.len() { Some(next) } else { self.closed().then_some(0) }
    }

    /// Far end of the chord of span `i`.
    pub fn span_end(&self, i: usize) -> Vec2 {
        self.spans.get(i + 1).map_or(self.end, |next| next.start)
    }

    /// Unit direction of the chord of span `i`.
    pub fn chord(&self, i: usize) -> Vec2 {
        (self.span_end(i) - self.spans[i].start) / self.spans[i].length
    }

    /// Point of the directrix at `s` along the chord of span `i`.
    pub fn point(&self, i: usize, s: f64) -> Vec2 {
        let (span, t) = (&self.spans[i], self.chord(i));
        span.start + t * s + left(t) * span.offset(s)
    }

    /// Tangent of the directrix there, in the sense of increasing s; its part along the chord is 1.
    pub fn tangent(&self, i: usize, s: f64) -> Vec2 {
        let t = self.chord(i);
        t + left(t) * self.spans[i].slope(s)
    }

    /// Curvature of the directrix there, positive when it bends to the left.
    pub fn curvature(&self, i: usize, s: f64) -> f64 {
        let m = self.spans[i].slope(s);
        let q = 1.0 + m * m;
        self.spans[i].second(s) / (q * q.sqrt())
    }

    /// Number of points, a control word that is always 0, the nine direction cosines, then for each span
    /// u v a b length max min, and the last point.
    pub fn canonical(&self) -> Vec<f64> {
        let n = u32::try_from(self.spans.len() + 1).unwrap_or(u32::MAX);
        let mut e = vec![f64::from(n), 0.0];
        e.extend(self.axes.transpose().iter());
        for s in &self.spans {
            e.extend([s.start.x, s.start.y, s.a, s.b, s.length, s.max, s.min]);
        }
        e.extend([self.end.x, self.end.y]);
        e
    }

    /// The same surface carried by `m`; `None` when `m` does not keep angles.
    pub fn transformed(&self, m: &Transform) -> Option<Self> {
        let k = m.uniform_scale()?;
        let (u, v) = (m.vector(self.u()) / k, m.vector(self.v()) / k);
        let w = u.cross(&v);
        let axes = Matrix3::from_rows(&[u.transpose(), v.transpose(), w.transpose()]);
        let shift = Vec2::new(u.dot(&m.shift), v.dot(&m.shift));
        let span = |s: &TabcylSpan| TabcylSpan {
            start: s.start * k + shift,
            a: s.a / (k * k),
            b: s.b / k,
            length: s.length * k,
            max: s.max * k,
            min: s.min * k,
        };
        let spans = self.spans.iter().map(span).collect();
        Some(Self { axes, spans, end: self.end * k + shift })
    }
}

/// `t` turned by 90 degrees to the left.
pub(crate) fn left(t: Vec2) -> Vec2 {
    Vec2::new(-t.y, t.x)
}
