//! Traces of control surfaces in the plane square to the tool axis: lines and circles.

use aptc_geometry::{Form, Plane, Vec3};

use super::frame::{Frame, Vec2, angle, ray};

/// Sine of the angle up to which a surface counts as parallel to the tool axis: over the height of a
/// cutter it changes no position by more than this times the height.
const PARALLEL: f64 = 1e-12;

/// Trace of a surface that is parallel to the tool axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Curve {
    /// `n . p = d`, n unit, towards the side of the form's normal.
    Line { n: Vec2, d: f64 },
    /// Centre and radius; the normal is outwards.
    Circle { c: Vec2, r: f64 },
}

impl Curve {
    /// The trace of a form; `None` when it is not a line or circle in this frame.
    pub(crate) fn of(form: &Form, frame: &Frame) -> Option<Self> {
        let plane = |p: &Plane| {
            let n = frame.plan(p.n);
            let l = n.norm();
            (p.n.dot(&frame.w).abs() <= PARALLEL && l > 0.5)
                .then(|| Self::Line { n: n / l, d: p.d / l })
        };
        let round = |point: Vec3, axis: Vec3, r: f64| {
            (axis.cross(&frame.w).norm() <= PARALLEL)
                .then(|| Self::Circle { c: frame.plan(point), r: r.abs() })
        };
        match form.shape() {
            Form::Line(l) => plane(&l.plane()),
            Form::Plane(p) => plane(p),
            Form::Circle(c) => round(c.center, c.axis, c.radius),
            Form::Cylinder(c) => round(c.point, c.axis, c.radius),
            _ => None,
        }
    }

    /// Signed distance of `p`, positive on the side of the normal.
    pub(crate) fn distance(&self, p: Vec2) -> f64 {
        match *self {
            Self::Line { n, d } => n.dot(&p) - d,
            Self::Circle { c, r } => (p - c).norm() - r,
        }
    }

    /// Unit normal at the foot of `p`; `None` at the centre of a circle.
    pub(crate) fn normal(&self, p: Vec2) -> Option<Vec2> {
        match *self {
            Self::Line { n, .. } => Some(n),
            Self::Circle { c, .. } => {
                let v = p - c;
                let l = v.norm();
                (l > 0.0).then(|| v / l)
            }
        }
    }

    /// The curve at signed distance `by`; `None` inside a circle that is too small.
    pub(crate) fn offset(&self, by: f64) -> Option<Self> {
        match *self {
            Self::Line { n, d } => Some(Self::Line { n, d: d + by }),
            Self::Circle { c, r } => (r + by >= 0.0).then_some(Self::Circle { c, r: r + by }),
        }
    }

    /// Common points of two curves, at most two; touching curves give one.
    pub(crate) fn meet(&self, other: &Self) -> Vec<Vec2> {
        match (*self, *other) {
            (Self::Line { n, d }, Self::Line { n: m, d: e }) => {
                let det = n.x * m.y - n.y * m.x;
                if det.abs() <= PARALLEL {
                    return Vec::new();
                }
                vec![Vec2::new((d * m.y - e * n.y) / det, (e * n.x - d * m.x) / det)]
            }
            (Self::Line { n, d }, Self::Circle { c, r })
            | (Self::Circle { c, r }, Self::Line { n, d }) => {
                let h = d - n.dot(&c);
                let foot = c + n * h;
                let t = Vec2::new(-n.y, n.x);
                half_chord(r, h).map_or(Vec::new(), |k| pair(foot, t, k))
            }
            (Self::Circle { c, r }, Self::Circle { c: b, r: q }) => {
                let (axis, dist) = (b - c, (b - c).norm());
                if dist <= PARALLEL * (r + q) {
                    return Vec::new();
                }
                let n = axis / dist;
                let h = (dist + (r - q) * (r + q) / dist) / 2.0;
                let t = Vec2::new(-n.y, n.x);
                half_chord(r, h).map_or(Vec::new(), |k| pair(c + n * h, t, k))
            }
        }
    }

    /// The nearest places of two curves that do not meet, on this one and on the other; `None` for lines.
    pub(crate) fn nearest_of(&self, other: &Self) -> Option<(Vec2, Vec2)> {
        match (*self, *other) {
            (Self::Line { .. }, Self::Line { .. }) => None,
            (Self::Line { n, d }, Self::Circle { c, r }) => {
                let h = d - n.dot(&c);
                Some((c + n * h, c + n * r * h.signum()))
            }
            (Self::Circle { .. }, Self::Line { .. }) => {
                other.nearest_of(self).map(|(on_line, on_circle)| (on_circle, on_line))
            }
            (Self::Circle { c, r }, Self::Circle { c: b, r: q }) => {
                let (axis, dist) = (b - c, (b - c).norm());
                let n = (dist > PARALLEL * (r + q)).then(|| axis / dist)?;
                // Beside each other the near sides face each other; within each other the same sides do.
                let (one, two) = match (dist >= r.max(q), r >= q) {
                    (true, _) => (1.0, -1.0),
                    (false, true) => (1.0, 1.0),
                    (false, false) => (-1.0, -1.0),
                };
                Some((c + n * r * one, b + n * q * two))
            }
        }
    }

    /// First point of the curve along the ray, strictly ahead, with its distance.
    pub(crate) fn hit(&self, from: Vec2, along: Vec2) -> Option<f64> {
        self.hits(from, along).into_iter().find(|s| *s >= 0.0)
    }

    /// Directed distances along the ray to all its points, rising.
    pub(crate) fn hits(&self, from: Vec2, along: Vec2) -> Vec<f64> {
        match *self {
            Self::Line { n, d } => {
                let rate = n.dot(&along);
                if rate.abs() <= PARALLEL {
                    return Vec::new();
                }
                vec![(d - n.dot(&from)) / rate]
            }
            Self::Circle { c, r } => {
                let w = c - from;
                let foot = w.dot(&along);
                half_chord(r, (w - along * foot).norm())
                    .map_or(Vec::new(), |k| vec![foot - k, foot + k])
            }
        }
    }

    /// The place of the curve nearest to `p`; at a centre the place in direction `hint`.
    pub(crate) fn nearest(&self, p: Vec2, hint: Vec2) -> Vec2 {
        match *self {
            Self::Line { n, d } => p - n * (n.dot(&p) - d),
            Self::Circle { c, r } => c + self.normal(p).unwrap_or_else(|| ray(angle(hint))) * r,
        }
    }
}

/// Half the chord of a circle of radius `r` at distance `h` from its centre; touching within rounding
/// counts as zero.
fn half_chord(r: f64, h: f64) -> Option<f64> {
    let h = h.abs();
    let q = (r - h) * (r + h);
    if q >= 0.0 { Some(q.sqrt()) } else { (h - r <= 1e-12 * (h + r)).then_some(0.0) }
}

fn pair(foot: Vec2, t: Vec2, k: f64) -> Vec<Vec2> {
    if k > 0.0 { vec![foot - t * k, foot + t * k] } else { vec![foot] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_circles_outside_both_as_the_closed_form_has_it() {
        // Radii 3 and 4 at distance 10, both moved out by 2.
        let a = Curve::Circle { c: Vec2::zeros(), r: 5.0 };
        let b = Curve::Circle { c: Vec2::new(10.0, 0.0), r: 6.0 };
        let m = a.meet(&b);
        assert_eq!(m.len(), 2);
        for p in m {
            assert!((p.x - 4.45).abs() < 1e-12 && (p.y.abs() - 2.279_802_622_159).abs() < 1e-9);
        }
    }

    #[test]
    fn curves_that_miss_each_other_have_nearest_places() {
        let circle = |x: f64, r: f64| Curve::Circle { c: Vec2::new(x, 0.0), r };
        let line = Curve::Line { n: Vec2::new(0.0, 1.0), d: -3.5 };
        let at = |a: &Curve, b: &Curve| a.nearest_of(b).map(|(p, q)| (p.x, p.y, q.x, q.y));
        assert_eq!(at(&circle(2.0, 3.0), &line), Some((2.0, -3.0, 2.0, -3.5)));
        assert_eq!(at(&circle(0.0, 3.0), &circle(8.0, 4.0)), Some((3.0, 0.0, 4.0, 0.0)));
        assert_eq!(at(&circle(0.0, 6.0), &circle(1.0, 4.0)), Some((6.0, 0.0, 5.0, 0.0)));
        assert_eq!(at(&circle(1.0, 4.0), &circle(0.0, 6.0)), Some((5.0, 0.0, 6.0, 0.0)));
        assert_eq!(at(&line, &line), None);
    }

    #[test]
    fn a_plane_along_the_axis_has_a_trace_and_a_leaning_one_has_none() {
        let frame = Frame::of(Vec3::z());
        let p = |x, y, z, d| Form::Plane(Plane::new(Vec3::new(x, y, z), d).unwrap());
        assert!(Curve::of(&p(1.0, 0.0, 0.0, 2.0), &frame).is_some());
        assert!(Curve::of(&p(1.0, 0.0, 0.1, 2.0), &frame).is_none());
    }

    #[test]
    fn a_tilted_frame_is_right_handed_and_carries_points() {
        let f = Frame::of(Vec3::new(1.0, 2.0, -2.0) / 3.0);
        assert!((f.u.cross(&f.v) - f.w).norm() < 1e-14);
        let p = Vec3::new(0.3, -4.0, 5.0);
        assert!((f.space(f.plan(p), f.height(p)) - p).norm() < 1e-13);
    }
}
