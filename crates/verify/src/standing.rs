//! On which side of a checked surface the tool as a whole stands.

use aptc_geometry::surface::QuadricSurface;
use aptc_geometry::{Form, Profile, Quadric, Vec3};

use crate::solid::Solid;
use crate::tool::Pose;

/// A surface with two sides that are told of any point.
#[derive(Clone, Debug)]
pub(crate) enum Sided {
    Solid(Solid),
    /// With the sign in which its hollow, if it has one, is negative.
    Quadric(Box<QuadricSurface>),
}

/// Where the tool stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// On the positive side.
    Outside,
    /// On the negative side.
    Inside,
    /// There, in a hollow that no tool as tall as this stands in: it is open along the tool axis.
    Open,
}

impl Sided {
    /// `None` of a surface that tells no side from afar.
    pub(crate) fn new(form: &Form) -> Option<Self> {
        if let Some(solid) = Solid::new(form) {
            return Some(Self::Solid(solid));
        }
        let Form::Quadric(q) = form.shape() else { return None };
        let known = QuadricSurface::new(q)?;
        let turned = || QuadricSurface::new(&Quadric { kind: q.kind, c: q.c.map(|c| -c) });
        Some(Self::Quadric(Box::new(if known.convexity() < 0 { turned()? } else { known })))
    }

    /// Is the point on the negative side?
    fn is_inside(&self, p: Vec3) -> bool {
        match self {
            Self::Solid(solid) => solid.distance(p) < 0.0,
            Self::Quadric(q) => {
                let [a, b, c, d, f, g, h, p0, q0, r] = q.form().c;
                let (x, y, z) = (p.x, p.y, p.z);
                let squares = a * x * x + b * y * y + c * z * z + d;
                let mixed = f * y * z + g * z * x + h * x * y + p0 * x + q0 * y + r * z;
                squares + 2.0 * mixed < 0.0
            }
        }
    }

    /// Where the tool stands whose cutter is `cutter` and that reaches up to `top` above its end.
    ///
    /// The cutter's axis from its lower end to the point asked is in the cutter: a surface with that point on its other
    /// side than the end cuts through the axis, as deep in the cutter as one of the two. With neither so deep both are
    /// on one side, and all that is rigidly above has to be there too. Of a hollow that has no chord along the axis as
    /// long as the tool the far wall cannot be meant: the tool could not be in it.
    pub(crate) fn place(&self, cutter: &Profile, top: f64, at: &Pose) -> Place {
        let half = 0.5 * (cutter.height() - cutter.bottom());
        let up = cutter.bottom() + half.min(cutter.widest());
        let low = at.te + at.ta * up;
        if !self.is_inside(low) {
            return Place::Outside;
        }
        let height = top.max(cutter.height()) - cutter.bottom();
        if self.longest(low, at.ta, height) < height { Place::Open } else { Place::Inside }
    }

    /// How far the point is on the other side than where the tool stands; `None` if it is not.
    pub(crate) fn across(&self, place: Place, p: Vec3) -> Option<f64> {
        if place == Place::Open || self.is_inside(p) == (place == Place::Inside) {
            return None;
        }
        Some(match self {
            Self::Solid(solid) => solid.distance(p).abs(),
            Self::Quadric(q) => q.foot(p).distance.abs(),
        })
    }

    /// The longest chord of the hollow along `ta` (of a cone: from its axis where `p` is); infinite where it is a bore about
    /// the tool's axis, to 45 degrees. Of a quadric: is it shorter than `height`?
    fn longest(&self, p: Vec3, ta: Vec3, height: f64) -> f64 {
        let lies = |along: f64| along.abs() <= std::f64::consts::FRAC_1_SQRT_2;
        match self {
            Self::Solid(Solid::Ball(_, r)) => 2.0 * r,
            Self::Solid(Solid::Rod(_, t, r)) if lies(t.dot(&ta)) => {
                2.0 * r / (1.0 - t.dot(&ta).powi(2)).sqrt()
            }
            Self::Solid(Solid::Nappe(v, t, cos, sin)) if lies(t.dot(&ta)) => {
                // Along the axis of the tool the wall goes off by the tangent of the angle it has there.
                let (wide, c) = ((p - v).dot(t) * sin / cos, t.dot(&ta).abs());
                let (s, c) = ((1.0 - c * c).sqrt(), c * sin / cos);
                if s <= c { f64::INFINITY } else { 2.0 * wide * s / (s * s - c * c) }
            }
            Self::Quadric(q) => {
                let lies = q.generator().is_none_or(|g| lies(g.dot(&ta)));
                let opens = lies && q.convexity() == 1 && q.opened(ta).is_some();
                if opens && q.too_low(ta, p, height, 0.0) { 0.0 } else { f64::INFINITY }
            }
            Self::Solid(_) => f64::INFINITY,
        }
    }
}
