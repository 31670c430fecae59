//! Places of the drive curve or surface.

use aptc_geometry::Vec3;
use aptc_geometry::surface::ParametricSurface;

use crate::area::{DriveArea, Guide, Projection};

/// A place of the drive with what is asked of it (APT: the array DR).
#[derive(Clone, Copy, Debug)]
pub(crate) struct DrivePoint {
    /// Its parameters.
    pub(crate) uv: [f64; 2],
    /// Which of them runs along the path.
    pub(crate) course: Course,
    /// The point.
    pub(crate) point: Vec3,
    /// Derivative along the path, in the direction of rising parameter; where a border runs together in a point the
    /// direction to which it comes.
    pub(crate) along: Vec3,
    /// The same across the path; zero for a curve without CRSSPL.
    pub(crate) across: Vec3,
    /// Derivative across the path, zero where a border runs together.
    pub(crate) speed: Vec3,
    /// Unit normal of the drive surface along dU x dV; `None` for a curve and where it vanishes.
    pub(crate) normal: Option<Vec3>,
    /// Unit direction of CRSSPL of a curve that has it, which stands for a normal.
    pub(crate) cross: Option<Vec3>,
    /// Unit direction of projection; `None` where it is not defined.
    pub(crate) direction: Option<Vec3>,
    /// Where the projection ends, in shares of the part surface, if that is known beforehand.
    pub(crate) foot: Option<[f64; 2]>,
}

/// Which parameter runs along the path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Course {
    /// TANSPL: u.
    U,
    /// CRSSPL: v.
    V,
}

impl Course {
    /// Index of the running parameter.
    pub(crate) fn index(self) -> usize {
        match self {
            Self::U => 0,
            Self::V => 1,
        }
    }

    /// The other one.
    pub(crate) fn across(self) -> Self {
        match self {
            Self::U => Self::V,
            Self::V => Self::U,
        }
    }
}

impl DriveArea {
    /// The place at (u, v); v does not count for a curve.
    ///
    /// APT: `DGEOM`.
    pub(crate) fn place(&self, uv: [f64; 2], course: Course) -> DrivePoint {
        match &self.guide {
            Guide::Curve(c) => {
                let p = c.at(uv[0]);
                let f = uv[0] / c.span();
                let across = match c.cross {
                    [Some(a), Some(b)] => a * (1.0 - f) + b * f,
                    [Some(a), None] | [None, Some(a)] => a,
                    [None, None] => Vec3::zeros(),
                };
                let (direction, foot) = match &self.projection {
                    Projection::Along(v) => (Some(*v), None),
                    Projection::Normal | Projection::Cross => (across.try_normalize(0.0), None),
                    Projection::Foot(surface, side) => foot(surface, *side, p.point),
                };
                let (point, along) = (p.point, p.first);
                DrivePoint {
                    uv,
                    course,
                    point,
                    along,
                    across,
                    speed: across,
                    normal: None,
                    cross: across.try_normalize(0.0),
                    direction,
                    foot,
                }
            }
            Guide::Surface(s) => {
                let d = s.at(uv[0], uv[1]);
                let normal = s.normal_at(uv[0], uv[1]);
                let [a, b] = [d.u.norm(), d.v.norm()];
                // Only there the limits differ from what is known already.
                let limits =
                    if a.min(b) <= 1e-6 * a.max(b) { s.tangents(uv[0], uv[1]) } else { [d.u, d.v] };
                let (along, across, speed) = match course {
                    Course::U => (limits[0], limits[1], d.v),
                    Course::V => (limits[1], limits[0], d.u),
                };
                let (direction, foot) = match &self.projection {
                    Projection::Along(v) => (Some(*v), None),
                    Projection::Normal => (normal.map(|n| -n), None),
                    Projection::Cross => (across.try_normalize(0.0), None),
                    Projection::Foot(surface, side) => foot(surface, *side, d.point),
                };
                DrivePoint {
                    uv,
                    course,
                    point: d.point,
                    along,
                    across,
                    speed,
                    normal,
                    cross: None,
                    direction,
                    foot,
                }
            }
        }
    }

    /// Limits of the running parameter.
    pub(crate) fn limits(&self, course: Course) -> [f64; 2] {
        match course {
            Course::U => self.u,
            Course::V => self.v,
        }
    }

    /// Is it a curve?
    pub(crate) fn is_curve(&self) -> bool {
        matches!(self.guide, Guide::Curve(_))
    }
}

/// Against the normal of the place nearest to `p`, seen from one side of the surface, and that place.
fn foot(surface: &ParametricSurface, side: f64, p: Vec3) -> (Option<Vec3>, Option<[f64; 2]>) {
    let foot = surface.foot(p);
    let smooth = foot.shape.k[0].is_finite();
    (smooth.then(|| foot.normal * -side), foot.at)
}
