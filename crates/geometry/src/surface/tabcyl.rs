//! TABCYL as a surface: prepared so that the nearest point is found without looking at every span.

mod corners;

use std::sync::Arc;

pub use corners::TabcylCorner;

use crate::surface::{EPS_LEN, Foot, Shape, Spot};
use crate::tabcyl::left;
use crate::{Place, Reason, Tabcyl, TabcylSpan, Vec2, Vec3};

/// Spans that share one bounding circle.
const GROUP: usize = 8;
/// Bound of the search for the nearest point of one span; it closes a bracket of doubles at worst.
const MAX_STEPS: usize = 60;
/// After a step of Newton's method of no more than this share of a span rounding alone is left: it converges
/// quadratically.
const LAST: f64 = 1e-9;
/// Pieces of a strongly bent span that are searched one by one.
const PIECES: usize = 8;

/// A tabulated cylinder prepared for evaluation. Its positive side is the left of the directrix.
#[derive(Clone, Debug)]
pub struct TabcylSurface {
    form: Arc<Tabcyl>,
    spans: Vec<Prepared>,
    /// Circles around every eight spans.
    groups: Vec<Disk>,
    axes: [Vec3; 3],
    extent: f64,
    /// Is there a corner?
    cornered: bool,
}

#[derive(Clone, Copy, Debug)]
struct Disk {
    center: Vec2,
    radius: f64,
}

#[derive(Clone, Copy, Debug)]
struct Prepared {
    span: TabcylSpan,
    chord: Vec2,
    disk: Disk,
    /// Greatest second derivative of the offset.
    bend: f64,
    /// Greatest distance from the chord.
    rise: f64,
    /// Does the tangent turn at its beginning?
    corner: bool,
}

/// Nearest place of the directrix.
#[derive(Clone, Copy, Debug)]
struct Near {
    square: f64,
    span: usize,
    s: f64,
}

impl TabcylSurface {
    /// Prepares a form; `None` when it has no spans.
    pub fn new(form: &Arc<Tabcyl>) -> Option<Self> {
        let mut spans: Vec<Prepared> = Vec::with_capacity(form.spans.len());
        let mut extent = 0.0_f64;
        for (i, span) in form.spans.iter().enumerate() {
            let (l, chord) = (span.length, form.chord(i));
            let rise = span.max.abs().max(span.min.abs());
            let center =
                span.start + chord * (0.5 * l) + left(chord) * (0.5 * (span.max + span.min));
            let high = 0.5 * (span.max - span.min);
            let radius = (0.25 * l * l + high * high).sqrt() * (1.0 + 1e-12);
            let bend = span.second(0.0).abs().max(span.second(l).abs());
            let corner = form.span_before(i).is_some_and(|before| {
                let before = form.tangent(before, form.spans[before].length).normalize();
                let here = form.tangent(i, 0.0).normalize();
                before.perp(&here).abs() > 1e-9 || before.dot(&here) < 0.0
            });
            extent = extent.max(center.norm() + radius);
            let disk = Disk { center, radius };
            spans.push(Prepared { span: *span, chord, disk, bend, rise, corner });
        }
        let groups = spans
            .chunks(GROUP)
            .map(|chunk| {
                let sum = chunk.iter().fold(Vec2::zeros(), |c, s| c + s.disk.center);
                let center = sum / f64::from(u32::try_from(chunk.len()).unwrap_or(1));
                let reach = |s: &Prepared| (s.disk.center - center).norm() + s.disk.radius;
                Disk { center, radius: chunk.iter().map(reach).fold(0.0, f64::max) }
            })
            .collect();
        let axes = [form.u(), form.v(), form.w()];
        let cornered = spans.iter().any(|span| span.corner);
        (!spans.is_empty()).then(|| Self {
            form: form.clone(),
            spans,
            groups,
            axes,
            extent,
            cornered,
        })
    }

    /// The form.
    pub fn form(&self) -> &Tabcyl {
        &self.form
    }

    /// Direction of the generatrix.
    pub fn generator(&self) -> Vec3 {
        self.axes[2]
    }

    /// Greatest distance of the directrix from the generatrix through the origin.
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// Directed distances along the unit direction `d`, the straight ends included.
    ///
    /// APT: `DDTABC`. Each is found where the cubic itself crosses the ray, at joints once.
    pub fn ray(&self, p: Vec3, d: Vec3) -> Result<Vec<f64>, Reason> {
        match self.form.ray(p, d) {
            None => {
                let foot = self.foot(p);
                let on = foot.distance.abs() <= EPS_LEN * (self.extent + p.norm());
                Err(if on { Reason::AllHit } else { Reason::Parallel })
            }
            Some(all) if all.is_empty() => Err(Reason::NoHit),
            Some(all) => Ok(all),
        }
    }

    /// Unit normal at the nearest point, to the left of the directrix.
    ///
    /// APT: `NORM-TAB`. At a corner between two spans there is none.
    pub fn normal(&self, p: Vec3) -> Result<Vec3, Reason> {
        let foot = self.foot(p);
        if foot.shape.k[0].is_infinite() {
            return Err(Reason::Degenerate(Place::Singular));
        }
        Ok(foot.normal)
    }

    /// The nearest point. At a corner, and beyond an end, the normal points from or to the given point.
    ///
    /// Its parameters are the number of the span and the place along its chord.
    #[inline]
    pub fn foot(&self, p: Vec3) -> Foot {
        self.foot_from(p, None)
    }

    /// The same, found sooner when it lies near the place `at`.
    pub fn foot_from(&self, p: Vec3, at: Option<[f64; 2]>) -> Foot {
        let [u, v, w] = self.axes;
        let (x, height) = (Vec2::new(u.dot(&p), v.dot(&p)), w.dot(&p));
        let near = self.nearest(x, at.map(|at| self.span(at[0])));
        let Bent { point: q, tangent, k } = self.spans[near.span].bent(near.s);
        let mut k = k;
        let mut normal = left(tangent);
        let away = x - q;
        let mut distance = normal.dot(&away);
        let along = tangent.dot(&away);
        let size = near.square.sqrt();
        if along.abs() > 1e-7 * size && size > 1e-12 * self.extent && self.free_end(&near) {
            let side = self.side(&near, away);
            normal = away * (side / size);
            distance = side * size;
            k = f64::INFINITY.copysign(side);
        }
        let lift = |a: Vec2| u * a.x + v * a.y;
        #[expect(clippy::cast_precision_loss, reason = "thousands at most")]
        let span = near.span as f64;
        Foot {
            point: lift(q) + w * height,
            normal: lift(normal),
            distance,
            shape: self.shape(normal, k),
            at: Some([span, near.s]),
        }
    }

    /// The foot of the point `q` of the surface, whose parameters are `at`.
    pub fn place(&self, q: Vec3, at: [f64; 2]) -> Foot {
        let Bent { point, tangent, k } = self.spans[self.span(at[0])].bent(at[1]);
        let [u, v, w] = self.axes;
        let lift = |a: Vec2| u * a.x + v * a.y;
        let normal = left(tangent);
        Foot {
            point: lift(point) + w * w.dot(&q),
            normal: lift(normal),
            distance: 0.0,
            shape: self.shape(normal, k),
            at: Some(at),
        }
    }

    /// Curvature at a point of the surface that is touched along the unit normal `n`, at corners any between those of the sides.
    pub fn shape_at(&self, spot: Spot, n: Vec3) -> Shape {
        let Some([span, s]) = spot.at else { return self.foot(spot.point).shape };
        let span = self.span(span);
        let Bent { tangent, k, .. } = self.spans[span].bent(s);
        self.sharp(span, s, n).unwrap_or_else(|| self.shape(left(tangent), k))
    }

    /// By how many spans two of them are apart, the shorter way round.
    pub fn spans_between(&self, a: f64, b: f64) -> f64 {
        let apart = (a - b).abs();
        #[expect(clippy::cast_precision_loss, reason = "thousands at most")]
        let all = self.spans.len() as f64;
        if self.form.closed() { apart.min(all - apart) } else { apart }
    }

    /// The parameters a share of the way from one place to another, the shorter way round, over whole spans evenly.
    pub(super) fn between(&self, [a, b]: [[f64; 2]; 2], share: f64) -> [f64; 2] {
        let length = |i: usize| self.spans[i].span.length;
        let at = |p: [f64; 2]| p[0] + p[1] / length(self.span(p[0]));
        #[expect(clippy::cast_precision_loss, reason = "thousands at most")]
        let all = self.spans.len() as f64;
        let (from, mut by) = (at(a), at(b) - at(a));
        if self.form.closed() && 2.0 * by.abs() > all {
            by -= all.copysign(by);
        }
        let x = from + share * by;
        let x = if self.form.closed() { x.rem_euclid(all) } else { x.max(0.0) };
        let span = self.span(x);
        #[expect(clippy::cast_precision_loss, reason = "thousands at most")]
        let whole = span as f64;
        [whole, (x - whole) * length(span)]
    }

    /// How many of the shortest of them near a straight way make up that between two places of contact on different ones.
    pub(super) fn pieces_between(&self, at: [[f64; 2]; 2], [a, b]: [Vec3; 2], reach: f64) -> f64 {
        if self.spans_between(at[0][0], at[1][0]) < 1.0 {
            return 0.0;
        }
        let least = self.spans_near(a, b, reach).map(|(_, length)| length);
        (b - a).norm() / least.fold(f64::INFINITY, f64::min)
    }

    /// The spans that may come nearer than `reach` to the straight way from `a` to `b`, in their order, with the
    /// lengths of their chords.
    pub fn spans_near(&self, a: Vec3, b: Vec3, reach: f64) -> impl Iterator<Item = (usize, f64)> {
        let [u, v, _] = self.axes;
        let [a, b] = [a, b].map(|p| Vec2::new(u.dot(&p), v.dot(&p)));
        let way = b - a;
        let size = way.norm_squared().max(f64::MIN_POSITIVE);
        let near = move |disk: &Disk| {
            let t = ((disk.center - a).dot(&way) / size).clamp(0.0, 1.0);
            (disk.center - a - way * t).norm() <= disk.radius + reach
        };
        let groups = self.groups.iter().enumerate().filter(move |(_, g)| near(g));
        let of = |g: usize| self.spans.iter().enumerate().skip(g * GROUP).take(GROUP);
        groups
            .flat_map(move |(g, _)| of(g))
            .filter(move |(_, s)| near(&s.disk))
            .map(|(i, s)| (i, s.span.length))
    }

    /// The span that a parameter names.
    #[inline]
    fn span(&self, at: f64) -> usize {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "made from one"
        )]
        let span = at as usize;
        span.min(self.spans.len() - 1)
    }

    #[inline]
    fn shape(&self, normal: Vec2, k: f64) -> Shape {
        let [u, v, w] = self.axes;
        Shape { frame: [u * normal.y - v * normal.x, w], k: [k, 0.0, 0.0] }
    }

    /// Is the place at an end of the curve?
    pub(crate) fn ends_at(&self, [span, s]: [f64; 2]) -> bool {
        if self.form.closed() {
            return false;
        }
        let (span, last) = (self.span(span), self.spans.len() - 1);
        span == 0 && s <= 0.0 || span == last && s >= self.spans[last].span.length
    }

    /// Is the place an end of the curve or a corner?
    fn free_end(&self, near: &Near) -> bool {
        let span = &self.spans[near.span];
        if near.s <= 0.0 {
            span.corner || self.form.span_before(near.span).is_none()
        } else if near.s >= span.span.length {
            self.form.span_after(near.span).is_none_or(|next| self.spans[next].corner)
        } else {
            false
        }
    }

    /// +1 on the left of a corner or an end, else -1.
    fn side(&self, near: &Near, away: Vec2) -> f64 {
        let f = &self.form;
        let (before, after) = if near.s <= 0.0 {
            (f.span_before(near.span), Some(near.span))
        } else {
            (Some(near.span), f.span_after(near.span))
        };
        let mut normal = Vec2::zeros();
        if let Some(before) = before {
            normal += left(f.tangent(before, f.spans[before].length).normalize());
        }
        if let Some(after) = after {
            normal += left(f.tangent(after, 0.0).normalize());
        }
        if normal.dot(&away) < 0.0 { -1.0 } else { 1.0 }
    }

    /// Nearest place of the directrix, that of the span `first` looked at before all others: groups and spans that
    /// cannot be nearer than the best are passed.
    fn nearest(&self, x: Vec2, first: Option<usize>) -> Near {
        let first = first.unwrap_or_else(|| self.likely(x) * GROUP);
        let look = |i: usize, best: &mut Near| {
            let (square, s) = self.spans[i].nearest(x);
            if square < best.square {
                *best = Near { square, span: i, s };
            }
        };
        let mut best = Near { square: f64::INFINITY, span: first, s: 0.0 };
        look(first, &mut best);
        let mut away = best.square.sqrt();
        for (g, group) in self.groups.iter().enumerate() {
            if group.beyond(x, away) {
                continue;
            }
            let from = g * GROUP;
            for i in from..(from + GROUP).min(self.spans.len()) {
                if i != first && !self.spans[i].disk.beyond(x, away) {
                    look(i, &mut best);
                    away = best.square.sqrt();
                }
            }
        }
        best
    }

    /// The group whose circle is nearest.
    fn likely(&self, x: Vec2) -> usize {
        let mut first = (f64::INFINITY, 0);
        for (i, g) in self.groups.iter().enumerate() {
            let b = (x - g.center).norm() - g.radius;
            if b < first.0 {
                first = (b, i);
            }
        }
        first.1
    }
}

impl Disk {
    /// Is all of it farther from `x` than `away`?
    #[inline]
    fn beyond(&self, x: Vec2, away: f64) -> bool {
        let most = self.radius + away;
        (x - self.center).norm_squared() >= most * most
    }
}

/// A place of the directrix.
#[derive(Clone, Copy, Debug)]
struct Bent {
    point: Vec2,
    /// Unit tangent.
    tangent: Vec2,
    /// Curvature seen from the left: what bends to the left is a hollow.
    k: f64,
}

impl Prepared {
    /// The place at `s` along the chord.
    #[inline]
    fn bent(&self, s: f64) -> Bent {
        let (offset, slope) = (self.span.offset(s), self.span.slope(s));
        let stretch = (1.0 + slope * slope).sqrt();
        Bent {
            point: self.span.start + self.chord * s + left(self.chord) * offset,
            tangent: (self.chord + left(self.chord) * slope) / stretch,
            k: -self.span.second(s) / (stretch * stretch * stretch),
        }
    }

    /// Square of the distance of `x` and the place on the chord of the nearest point.
    fn nearest(&self, x: Vec2) -> (f64, f64) {
        let w = x - self.span.start;
        let (px, py) = (w.dot(&self.chord), self.chord.perp(&w));
        let l = self.span.length;
        if self.bend * (py.abs() + self.rise) < 0.9 {
            // One dip: the derivative rises all along.
            return self.dip(px, py, 0.0, l);
        }
        let mut best = (f64::INFINITY, 0.0);
        let step = l / PIECES as f64;
        for i in 0..PIECES {
            let from = step * i as f64;
            let found = self.dip(px, py, from, from + step);
            if found.0 < best.0 {
                best = found;
            }
        }
        best
    }

    /// The nearest place between two places with at most one dip between them.
    fn dip(&self, px: f64, py: f64, from: f64, to: f64) -> (f64, f64) {
        let f = &self.span;
        let square = |s: f64| {
            let (a, b) = (s - px, f.offset(s) - py);
            a * a + b * b
        };
        // Half the derivative of the squared distance, and its derivative.
        let rate = |s: f64| (s - px) + (f.offset(s) - py) * f.slope(s);
        let (mut a, mut b) = (from, to);
        if rate(a) >= 0.0 {
            return (square(a), a);
        }
        if rate(b) <= 0.0 {
            return (square(b), b);
        }
        let mut s = px.clamp(a, b);
        let mut last = b - a;
        for _ in 0..MAX_STEPS {
            let (offset, slope) = (f.offset(s) - py, f.slope(s));
            let r = (s - px) + offset * slope;
            if r < 0.0 {
                a = s;
            } else {
                b = s;
            }
            let steep = 1.0 + slope * slope + offset * f.second(s);
            let step = -r / steep;
            let next = s + step;
            if step.abs() <= 1e-15 * to {
                break;
            }
            if steep > 0.0 && next > a && next < b && step.abs() < 0.5 * last {
                last = step.abs();
                s = next;
                if last <= LAST * to {
                    break;
                }
            } else {
                last = b - a;
                let middle = 0.5 * (a + b);
                if middle <= a || middle >= b {
                    break;
                }
                s = middle;
            }
        }
        (square(s), s)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Matrix3;
    use proptest::prelude::*;

    use super::*;
    use crate::surface::{Fiop, Surface};
    use crate::{Fit, Knot, trig};

    fn fitted(points: &[(f64, f64)], fit: Fit) -> TabcylSurface {
        let knots: Vec<Knot> =
            points.iter().map(|(x, y)| Knot { point: Vec2::new(*x, *y), tangent: None }).collect();
        let form = Tabcyl::fit(&knots, fit, Matrix3::identity(), 10.0).unwrap();
        TabcylSurface::new(&Arc::new(form)).unwrap()
    }

    /// The middle piece through (-3, 8), (-1, 0), (1, 0), (3, 8) is v = u^2 - 1.
    #[test]
    fn published_ray_and_normal() {
        let s = fitted(&[(-3.0, 8.0), (-1.0, 0.0), (1.0, 0.0), (3.0, 8.0)], Fit::FourPoint);
        let below = Vec3::new(0.0, -10.0, 0.0);
        let t = Surface::Tabcyl(Arc::new(s.clone()));
        let hit = t.directed_distance(below, Vec3::y(), Fiop::Nearest).unwrap();
        assert!((hit.distance - 9.0).abs() < 1e-12);
        assert!((s.normal(hit.point).unwrap() - Vec3::y()).norm() < 1e-12);
        let slant = Vec3::new(0.0, 1.0, 1.0).normalize();
        let hit = t.directed_distance(below, slant, Fiop::Nearest).unwrap();
        assert!((hit.distance - 9.0 * 2.0_f64.sqrt()).abs() < 1e-12);
        assert!((hit.point.z - 9.0).abs() < 1e-12);
        let n = s.normal(Vec3::new(0.5, -0.75, 0.0)).unwrap();
        assert!((n - Vec3::new(-1.0, 1.0, 0.0).normalize()).norm() < 1e-12);
        assert_eq!(s.ray(below, Vec3::z()), Err(Reason::Parallel));
        // Bent to the left with radius 1/2 at the bottom: a hollow from above.
        let f = s.foot(Vec3::new(0.0, -0.9, 3.0));
        assert!((f.shape.k[0] + 2.0).abs() < 1e-12 && (f.distance - 0.1).abs() < 1e-12);
    }

    #[test]
    fn straight_points_are_a_plane() {
        let s = fitted(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (5.0, 5.0)], Fit::Spline);
        let f = s.foot(Vec3::new(3.0, 1.0, 7.0));
        assert!((f.distance + 2.0_f64.sqrt()).abs() < 1e-12);
        assert!((f.point - Vec3::new(2.0, 2.0, 7.0)).norm() < 1e-12);
        let l = s.ray(Vec3::new(3.0, 1.0, 7.0), Vec3::y()).unwrap();
        assert_eq!(l.len(), 1);
        assert!((l[0] - 2.0).abs() < 1e-12);
        // Beyond the straight end the end itself is nearest.
        let f = s.foot(Vec3::new(50.0, 49.0, 0.0));
        let end = 5.0 + 10.0 * std::f64::consts::FRAC_1_SQRT_2;
        assert!((f.point - Vec3::new(end, end, 0.0)).norm() < 1e-12);
        assert!(f.distance < 0.0 && f.shape.k[0].is_infinite());
    }

    /// A square of four points, with corners by its straight sides: outside of each the normal points from it, also of the one where
    /// the curve closes.
    #[test]
    fn a_curve_that_closes_has_a_corner_there_and_no_end() {
        let knot = |(x, y): (f64, f64)| Knot { point: Vec2::new(x, y), tangent: None };
        let square = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0), (1.0, 1.0)];
        let straight = square.map(knot);
        let form = {
            let mut t = Tabcyl::fit(&straight, Fit::TwoPoint, Matrix3::identity(), 10.0).unwrap();
            t.spans.iter_mut().for_each(|s| *s = TabcylSpan::new(s.start, 0.0, 0.0, s.length));
            t
        };
        let s = TabcylSurface::new(&Arc::new(form)).unwrap();
        for (x, y) in &square {
            let corner = Vec3::new(*x, *y, 0.0);
            // Against the clock the left is inside.
            let (out, within) = (s.foot(corner * 1.5), s.foot(corner * 0.5));
            assert!(
                (out.distance + 0.5_f64.sqrt()).abs() < 1e-12
                    && (out.point - corner).norm() < 1e-12
            );
            assert!(
                (out.normal + corner.normalize()).norm() < 1e-12 && out.shape.k[0].is_infinite()
            );
            assert!((within.distance - 0.5).abs() < 1e-12);
            assert!(!s.ends_at(out.at.unwrap()));
        }
        assert!((s.spans_between(0.0, 3.0) - 1.0).abs() < 1e-12);
    }

    /// Round a curve of straight sides and of one that goes on straight in the next only the ways over a corner have it between their ends.
    #[test]
    fn a_corner_is_between_spans_the_shorter_way_round() {
        let knot = |(x, y): (f64, f64)| Knot { point: Vec2::new(x, y), tangent: None };
        // The fourth side goes on in the fifth, which ends where the first begins.
        let sides = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0), (1.0, 0.0), (1.0, 1.0)];
        let mut form =
            Tabcyl::fit(&sides.map(knot), Fit::TwoPoint, Matrix3::identity(), 10.0).unwrap();
        form.spans.iter_mut().for_each(|s| *s = TabcylSpan::new(s.start, 0.0, 0.0, s.length));
        let s = TabcylSurface::new(&Arc::new(form)).unwrap();
        let between = [(0.0, 1.0), (1.0, 2.0), (2.0, 3.0), (4.0, 0.0), (3.0, 0.0), (0.0, 2.0)];
        for (from, to) in between {
            assert!(
                s.has_corner_between(from, to) && s.has_corner_between(to, from),
                "{from} {to}"
            );
        }
        for (from, to) in [(3.0, 4.0), (0.0, 0.0), (4.0, 4.0)] {
            assert!(
                !s.has_corner_between(from, to) && !s.has_corner_between(to, from),
                "{from} {to}"
            );
        }
    }

    proptest! {
        #[test]
        fn nearest_of_all_spans(
            y in prop::collection::vec(-3.0_f64..3.0, 12..40),
            p in prop::array::uniform3(-6.0_f64..30.0), spline in any::<bool>(),
        ) {
            let points: Vec<(f64, f64)> =
                y.iter().enumerate().map(|(i, y)| (i as f64 * 1.3 + 0.2 * trig::sin(*y), *y)).collect();
            let fit = if spline { Fit::Spline } else { Fit::TwoPoint };
            let knots: Vec<Knot> = points
                .iter()
                .map(|(x, y)| Knot { point: Vec2::new(*x, *y), tangent: None })
                .collect();
            let Ok(form) = Tabcyl::fit(&knots, fit, Matrix3::identity(), 10.0) else {
                return Ok(());
            };
            let form = Arc::new(form);
            let s = TabcylSurface::new(&form).unwrap();
            let p = Vec3::new(p[0], p[1] * 0.3 - 4.0, p[2]);
            let f = s.foot(p);
            let slow = form.nearest_to(p.xy()).unwrap();
            let exact = (slow.point - p.xy()).norm();
            prop_assert!((f.distance.abs() - exact).abs() < 1e-9, "{:?} {}", f, exact);
            prop_assert!((f.point + f.normal * f.distance - p).norm() < 1e-6 * (1.0 + exact));
            prop_assert!((f.normal.norm() - 1.0).abs() < 1e-9);
        }
    }
}
