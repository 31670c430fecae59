//! Corners between two spans of a TABCYL: edges along its generatrix.

use super::TabcylSurface;
use crate::surface::{Foot, Shape};
use crate::tabcyl::left;
use crate::{Vec2, Vec3};

/// Sine up to which a normal at a corner counts as that of a side.
const SAME: f64 = 1e-7;
/// Curvature of a corner, in extents of the curve.
const SHARP: f64 = 1e9;

/// An edge along the generatrix, where the tangent of the directrix turns at once.
#[derive(Clone, Copy, Debug)]
pub struct TabcylCorner {
    /// Its parameters: the span that begins there, and 0.
    pub at: [f64; 2],
    /// A point of it.
    pub point: Vec3,
    /// The mean of the normals of both sides, not of unit length.
    pub mean: Vec3,
    /// Unit directions from it into both sides.
    pub into: [Vec3; 2],
}

impl TabcylSurface {
    /// Has the directrix a corner?
    #[inline]
    pub fn has_corners(&self) -> bool {
        self.cornered
    }

    /// Is there a corner on the way from one span to another, the shorter way round?
    pub fn has_corner_between(&self, from: f64, to: f64) -> bool {
        if !self.cornered {
            return false;
        }
        let [a, b] = [self.span(from.min(to)), self.span(from.max(to))];
        let n = self.spans.len();
        let corner = |i: usize| self.spans[i % n].corner;
        if self.form.closed() && 2 * (b - a) > n {
            (b + 1..=a + n).any(corner)
        } else {
            (a + 1..=b).any(corner)
        }
    }

    /// The corners that may come nearer than `reach` to the straight way from `a` to `b`.
    pub fn corners_near(&self, a: Vec3, b: Vec3, reach: f64) -> impl Iterator<Item = TabcylCorner> {
        self.spans_near(a, b, reach).filter_map(|(span, _)| self.corner(span))
    }

    /// The place that lies beside that of `q` with the parameters `at` by the tangent `by`, to first order, along the directrix and
    /// round its corners; `None` where it has none, as nearest places do there, and beyond its ends.
    ///
    /// What lies behind a corner is nearer to the other side of it, so that nearest places do not lead along this one.
    pub fn beside(&self, q: Vec3, at: [f64; 2], by: Vec3) -> Option<Foot> {
        if !self.cornered {
            return None;
        }
        let [u, v, _] = self.axes;
        let along = Vec2::new(u.dot(&by), v.dot(&by));
        let span = self.span(at[0]);
        // Along the chord of a span, whose tangents have the part 1 along it.
        let rate = |span: usize, s: f64| self.form.tangent(span, s).norm();
        let tangent = self.form.tangent(span, at[1]);
        let (to, length) =
            (at[1] + along.dot(&tangent) / tangent.norm_squared(), self.form.spans[span].length);
        let (span, s) = if to < 0.0 {
            let before = self.form.span_before(span)?;
            let end = self.form.spans[before].length;
            (before, end + to * rate(span, 0.0) / rate(before, end))
        } else if to > length {
            let after = self.form.span_after(span)?;
            (after, (to - length) * rate(span, length) / rate(after, 0.0))
        } else {
            (span, to)
        };
        let s = s.clamp(0.0, self.form.spans[span].length);
        #[expect(clippy::cast_precision_loss, reason = "thousands at most")]
        let at = [span as f64, s];
        Some(self.place(q + by, at))
    }

    /// The corner at the beginning of a span.
    fn corner(&self, span: usize) -> Option<TabcylCorner> {
        let [before, after] = self.tangents(span)?;
        let [u, v, _] = self.axes;
        let lift = |a: Vec2| u * a.x + v * a.y;
        #[expect(clippy::cast_precision_loss, reason = "thousands at most")]
        let at = [span as f64, 0.0];
        Some(TabcylCorner {
            at,
            point: lift(self.spans[span].span.start),
            mean: lift(left(before) + left(after)),
            into: [lift(-before), lift(after)],
        })
    }

    /// Unit tangents before and behind the beginning of a span, where there is a corner.
    fn tangents(&self, span: usize) -> Option<[Vec2; 2]> {
        let before = self.form.span_before(span).filter(|_| self.spans[span].corner)?;
        let end = self.form.spans[before].length;
        Some([self.form.tangent(before, end).normalize(), self.form.tangent(span, 0.0).normalize()])
    }

    /// How a corner at the place `s` of a span bends where it is touched along the unit normal `n`; `None` where none is there and
    /// where that is the normal of a side.
    pub(super) fn sharp(&self, span: usize, s: f64, n: Vec3) -> Option<Shape> {
        let corner = if s <= 0.0 {
            span
        } else if s >= self.spans[span].span.length {
            self.form.span_after(span)?
        } else {
            return None;
        };
        let tangents = self.tangents(corner)?;
        let [u, v, _] = self.axes;
        let n = Vec2::new(u.dot(&n), v.dot(&n)).try_normalize(0.0)?;
        let between = tangents.iter().all(|t| n.dot(t).abs() > SAME);
        between.then(|| self.shape(n, SHARP / self.extent.max(f64::MIN_POSITIVE)))
    }
}
