//! The surfaces that can control the tool, with what is asked of them.
//!
//! Every surface has a positive side, to which its normals point: that of a plane's normal, the outside
//! of sphere, cylinder and cone, the side where a quadric's form is positive, the left of a directrix.

mod cone;
mod cylinder;
pub mod kept;
mod opened;
mod parametric;
mod plane;
mod probe;
mod quadric;
mod shape;
mod sphere;
mod tabcyl;

use std::sync::Arc;

pub use cone::vertex_side;
pub use opened::OpenedQuadric;
pub use parametric::{
    Continued, Disk, Edge, Facing, Next, OnEdge, ParametricSurface, Part, Sample, Touching,
    continued, continued_of,
};
pub use probe::{Aimed, ajundo, ccurv, control, radar};
pub use quadric::QuadricSurface;
pub use shape::{Frame, Shape, frame_about};
pub use tabcyl::{TabcylCorner, TabcylSurface};

use crate::{Cone, Cylinder, Form, Place, Plane, Reason, Sphere, Vec3};

/// A length is taken for zero below this fraction of the scene's size.
pub const EPS_LEN: f64 = 1e-12;
/// Directions are taken for parallel when their sine is below this.
pub const EPS_ANG: f64 = 1e-10;

/// A surface that can control the tool. LINE is a vertical plane, CIRCLE the cylinder along its axis.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "each is the form of its name")]
pub enum Surface {
    Plane(Plane),
    Sphere(Sphere),
    Cylinder(Cylinder),
    Cone(Cone),
    Quadric(Arc<QuadricSurface>),
    Tabcyl(Arc<TabcylSurface>),
    Parametric(Arc<ParametricSurface>),
}

/// The point of a surface nearest to a given one.
#[derive(Clone, Copy, Debug)]
pub struct Foot {
    /// The nearest point.
    pub point: Vec3,
    /// Unit normal there, to the positive side.
    pub normal: Vec3,
    /// Signed distance of the given point, positive on the positive side.
    pub distance: f64,
    /// Curvature of the surface at the nearest point.
    pub shape: Shape,
    /// Parameters of the nearest point, of surfaces that have two.
    pub at: Option<[f64; 2]>,
}

/// A point of a surface: where a search may begin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The point.
    pub point: Vec3,
    /// Its parameters, of surfaces that have two, when they are known.
    pub at: Option<[f64; 2]>,
}

impl Foot {
    /// The nearest point with its parameters.
    #[inline]
    pub fn spot(&self) -> Spot {
        Spot { point: self.point, at: self.at }
    }

    /// The place beside this one by the tangent `by`, where the curvature changes little on the way.
    #[inline]
    fn close_by(&self, by: Vec3) -> Self {
        let turned = self.shape.apply(by);
        let normal = self.normal + turned;
        let normal = normal / normal.norm();
        let [a, b] = self.shape.frame;
        let frame = [a - self.normal * turned.dot(&a), b - self.normal * turned.dot(&b)];
        let point = self.point + by - self.normal * (0.5 * turned.dot(&by));
        Self { point, normal, shape: Shape { frame, ..self.shape }, ..*self }
    }
}

impl From<Vec3> for Spot {
    fn from(point: Vec3) -> Self {
        Self { point, at: None }
    }
}

/// Which intersection is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fiop {
    /// 0: the nearest, in front or behind.
    Nearest,
    /// +1: the nearest in front.
    Ahead,
    /// -1: the nearest in front, or else the nearest.
    AheadFirst,
}

/// An intersection of a line with a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Directed distance along the unit direction.
    pub distance: f64,
    /// The point.
    pub point: Vec3,
}

impl Surface {
    /// The surface that a form stands for; `None` for what cannot control the tool, and for a quadric
    /// without coefficients.
    pub fn from_form(form: &Form) -> Option<Self> {
        Some(match form.shape() {
            Form::Line(l) => Self::Plane(l.plane()),
            Form::Plane(p) => Self::Plane(*p),
            Form::Circle(c) => Self::Cylinder(c.cylinder()),
            Form::Cylinder(c) => Self::Cylinder(*c),
            Form::Sphere(s) => Self::Sphere(*s),
            Form::Cone(c) => Self::Cone(*c),
            Form::Quadric(q) => Self::Quadric(Arc::new(QuadricSurface::new(q)?)),
            Form::Tabcyl(t) => Self::Tabcyl(Arc::new(TabcylSurface::new(t)?)),
            Form::Ruled(r) => Self::Parametric(Arc::new(ParametricSurface::ruled(r)?)),
            Form::Polyconic(p) => Self::Parametric(Arc::new(ParametricSurface::polyconic(p)?)),
            Form::Ssurf(d) => Self::Parametric(Arc::new(ParametricSurface::sculptured(d)?)),
            _ => return None,
        })
    }

    /// Directed distances along the unit direction `d` from `p` to all intersections, rising. A line in the
    /// surface is `AllHit`, one beside it `Parallel` or `NoHit`.
    pub fn ray(&self, p: Vec3, d: Vec3) -> Result<Vec<f64>, Reason> {
        let d = unit(d)?;
        match self {
            Self::Plane(s) => s.ray(p, d),
            Self::Sphere(s) => s.ray(p, d),
            Self::Cylinder(s) => s.ray(p, d),
            Self::Cone(s) => s.ray(p, d),
            Self::Quadric(s) => s.ray(p, d),
            Self::Tabcyl(s) => s.ray(p, d),
            Self::Parametric(s) => s.ray(p, d),
        }
    }

    /// The intersection along `d` from `p` that `fiop` asks for.
    ///
    /// APT: `DDST` over `DDPLAN`, `DDSPHR`, `DDCON`, `DDCYLN`, `DDQUAD`, `DDTABC`. Source: B70-18 ch. D.
    /// The nappe and the ends of a surface are respected before the choice, not after it.
    pub fn directed_distance(&self, p: Vec3, d: Vec3, fiop: Fiop) -> Result<Hit, Reason> {
        let d = unit(d)?;
        let distance = match self.ray(p, d) {
            Ok(roots) => select(&roots, fiop).ok_or(Reason::NoHit)?,
            Err(Reason::AllHit) => 0.0,
            Err(reason) => return Err(reason),
        };
        Ok(Hit { distance, point: p + d * distance })
    }

    /// Unit normal at a point of the surface, to its positive side; off the surface the normal of the
    /// parallel or level surface through the point.
    ///
    /// APT: `UNRMAL` over `UNPLAN`, `UNSPHR`, `UNCON`, `UNCYLN`, `UNQUAD`, `NORM-TAB`.
    pub fn normal(&self, p: Vec3) -> Result<Vec3, Reason> {
        match self {
            Self::Plane(s) => Ok(s.n),
            Self::Sphere(s) => s.normal(p),
            Self::Cylinder(s) => s.normal(p),
            Self::Cone(s) => s.normal(p),
            Self::Quadric(s) => s.normal(p),
            Self::Tabcyl(s) => s.normal(p),
            Self::Parametric(s) => s.normal(p),
        }
    }

    /// The nearest point of the whole surface, with its normal, curvature and the signed distance. Where
    /// several are equally near (the centre of a sphere) one of them.
    #[inline]
    pub fn foot(&self, p: Vec3) -> Foot {
        match self {
            Self::Plane(s) => s.foot(p),
            Self::Sphere(s) => s.foot(p),
            Self::Cylinder(s) => s.foot(p),
            Self::Cone(s) => s.foot(p),
            Self::Quadric(s) => s.foot(p),
            Self::Tabcyl(s) => s.foot(p),
            Self::Parametric(s) => s.foot(p),
        }
    }

    /// The foot into which `near` runs downhill towards `p`: of a surface by two parameters with the place of `near`
    /// known the nearest point thereabouts, several times as fast; else the nearest of all.
    #[inline]
    pub fn foot_from(&self, p: Vec3, near: Spot) -> Foot {
        match (self, near.at) {
            (Self::Parametric(s), Some(at)) => s.foot_from(p, at),
            (Self::Tabcyl(s), at) => s.foot_from(p, at),
            _ => self.foot(p),
        }
    }

    /// A distance from `p`, at most `limit`, below which no place is but that of [`Self::foot`], among those from which
    /// the distance grows all round: of surfaces by two parameters, of rulings and conics as far as their samples show.
    pub fn rival(&self, p: Vec3, limit: f64) -> f64 {
        match self {
            Self::Parametric(s) => s.rival(p, limit),
            _ => 0.0,
        }
    }

    /// How the surface turns and bends within balls about a place with parameters: see [`ParametricSurface::part`].
    pub fn part(&self, balls: &[(Vec3, f64)], from: (Vec3, f64), near: Spot) -> Option<Part> {
        match (self, near.at) {
            (Self::Parametric(s), Some(at)) => s.part(balls, from, at),
            _ => None,
        }
    }

    /// The foot of a point of the surface, which is known by its parameters where it has two.
    #[inline]
    pub fn place(&self, spot: Spot) -> Foot {
        match (self, spot.at) {
            (Self::Parametric(s), Some(at)) => s.place(at),
            (Self::Tabcyl(s), Some(at)) => s.place(spot.point, at),
            (Self::Quadric(s), _) => s.place(spot.point).unwrap_or_else(|| s.foot(spot.point)),
            _ => self.foot_from(spot.point, spot),
        }
    }

    /// The parameters a share of the way from those of one place to those of another.
    pub fn between(&self, at: [[f64; 2]; 2], share: f64) -> [f64; 2] {
        match self {
            Self::Tabcyl(s) => s.between(at, share),
            _ => [0, 1].map(|i| at[0][i] + share * (at[1][i] - at[0][i])),
        }
    }

    /// As [`Surface::place`], with its derivatives by its parameters, of a surface by two.
    #[inline]
    pub fn place_with_sides(&self, spot: Spot) -> (Foot, Option<[Vec3; 2]>) {
        match (self, spot.at) {
            (Self::Parametric(s), Some(at)) => {
                let (foot, sides) = s.place_with_sides(at);
                (foot, Some(sides))
            }
            _ => (self.place(spot), None),
        }
    }

    /// The place of the surface that lies beside `near` by the tangent `by`, to first order: any place will do that
    /// comes nearer to it as `by` falls. `None` where there is no simple one, and beside a border. With it, of a surface by
    /// two parameters, the derivatives by them there; `sides` are those at `near`, when they are known.
    #[inline]
    pub fn beside(
        &self,
        near: Spot,
        sides: Option<[Vec3; 2]>,
        by: Vec3,
    ) -> Option<(Foot, Option<[Vec3; 2]>)> {
        match (self, near.at) {
            (Self::Parametric(s), Some(at)) => {
                let (foot, sides) = s.beside(at, sides, by)?;
                Some((foot, Some(sides)))
            }
            (Self::Quadric(s), _) => Some((s.beside(near.point, by)?, None)),
            (Self::Tabcyl(s), Some(at)) => Some((s.beside(near.point, at, by)?, None)),
            _ => None,
        }
    }

    /// What [`Surface::beside`] finds of a smooth surface for a way that is short, from a foot that is a place of it; `None` of
    /// others. What it is off falls with the third power of that, and the normal with the square.
    #[inline]
    pub fn close_by(&self, foot: &Foot, sides: Option<[Vec3; 2]>, by: Vec3) -> Option<Foot> {
        match self {
            Self::Parametric(s) => s.close_by(foot, sides?, by),
            _ => None,
        }
    }

    /// Signed distance of `p`, positive on the positive side.
    #[inline]
    pub fn distance(&self, p: Vec3) -> f64 {
        match self {
            Self::Plane(s) => s.distance(p),
            Self::Sphere(s) => (p - s.center).norm() - s.radius,
            _ => self.foot(p).distance,
        }
    }

    /// Curvature at the point `spot` of the surface with unit normal `n` there (to the positive side).
    #[inline]
    pub fn shape_at(&self, spot: Spot, n: Vec3) -> Shape {
        let q = spot.point;
        match self {
            Self::Plane(_) => Shape::flat(n),
            Self::Sphere(s) => Shape::round(n, 1.0 / s.radius),
            Self::Cylinder(s) => s.shape(n),
            Self::Cone(s) => s.shape_at(q, n),
            Self::Quadric(s) => s.shape_at(q, n),
            Self::Tabcyl(s) => s.shape_at(spot, n),
            Self::Parametric(s) => s.shape_at(spot, n),
        }
    }

    /// Is a place with these parameters on the border of a surface that ends, where what touches it goes round its edge?
    pub fn ends_at(&self, at: Option<[f64; 2]>) -> bool {
        match (self, at) {
            (Self::Tabcyl(t), Some(at)) => t.ends_at(at),
            (Self::Parametric(s), Some(at)) => s.ends_at(at),
            _ => false,
        }
    }

    /// The direction in which the surface runs straight for ever (planes have many and give none).
    pub fn generator(&self) -> Option<Vec3> {
        match self {
            Self::Cylinder(s) => Some(s.axis),
            Self::Quadric(s) => s.generator(),
            Self::Tabcyl(s) => Some(s.generator()),
            Self::Plane(_) | Self::Sphere(_) | Self::Cone(_) | Self::Parametric(_) => None,
        }
    }

    /// The direction of the straight line in the surface through its point nearest to `q`, where there is
    /// just one.
    pub fn ruling(&self, q: Vec3) -> Option<Vec3> {
        match self {
            Self::Cone(c) => (self.foot(q).point - c.vertex).try_normalize(0.0),
            Self::Parametric(s) => s.ruling(q),
            _ => self.generator().and_then(|g| g.try_normalize(0.0)),
        }
    }

    /// How many pieces of a surface of spans or patches, as long as the shortest of them near a straight way, make up that way between
    /// two places of contact `at`; 0 of other surfaces.
    pub fn pieces_between(&self, at: [[f64; 2]; 2], way: [Vec3; 2], reach: f64) -> f64 {
        match self {
            Self::Tabcyl(s) => s.pieces_between(at, way, reach),
            Self::Parametric(s) => s.pieces_between(at),
            _ => 0.0,
        }
    }

    /// Is the region on the negative side convex (ball, solid cylinder, solid cone, half space)? Then the
    /// gap of a tool on the positive side is a convex function of its place.
    pub fn convex(&self) -> bool {
        match self {
            Self::Plane(_) | Self::Sphere(_) | Self::Cylinder(_) | Self::Cone(_) => true,
            Self::Quadric(s) => s.convexity() > 0,
            Self::Tabcyl(_) | Self::Parametric(_) => false,
        }
    }

    /// Is the region on the positive side convex?
    pub fn concave(&self) -> bool {
        match self {
            Self::Plane(_) => true,
            Self::Sphere(_) | Self::Cylinder(_) | Self::Cone(_) => false,
            Self::Tabcyl(_) | Self::Parametric(_) => false,
            Self::Quadric(s) => s.convexity() < 0,
        }
    }

    /// A length that says how large the numbers of the surface are: the farthest of its defining points
    /// from the origin plus its radius.
    pub fn extent(&self) -> f64 {
        match self {
            Self::Plane(s) => s.d.abs(),
            Self::Sphere(s) => s.center.norm() + s.radius,
            Self::Cylinder(s) => s.point.norm() + s.radius,
            Self::Cone(s) => s.vertex.norm(),
            Self::Quadric(s) => s.extent(),
            Self::Tabcyl(s) => s.extent(),
            Self::Parametric(s) => s.extent(),
        }
    }
}

/// Of directed distances the one that `fiop` asks for; of two equally near ones the positive.
///
/// APT: the choice at the end of `DDST`.
pub fn select(roots: &[f64], fiop: Fiop) -> Option<f64> {
    let nearest = |all: &mut dyn Iterator<Item = f64>| {
        all.reduce(|a, b| if b.abs() < a.abs() || (b.abs() <= a.abs() && b > a) { b } else { a })
    };
    let ahead = || nearest(&mut roots.iter().copied().filter(|l| *l >= 0.0));
    match fiop {
        Fiop::Nearest => nearest(&mut roots.iter().copied()),
        Fiop::Ahead => ahead(),
        Fiop::AheadFirst => ahead().or_else(|| nearest(&mut roots.iter().copied())),
    }
}

/// The unit vector along `v`; a zero or infinite one is refused.
pub(crate) fn unit(v: Vec3) -> Result<Vec3, Reason> {
    let s = v.norm();
    if s > 0.0 && s.is_finite() { Ok(v / s) } else { Err(Reason::Degenerate(Place::Direction)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fiop_algebra() {
        assert_eq!(select(&[-14.0, -6.0], Fiop::Nearest), Some(-6.0));
        assert_eq!(select(&[-14.0, -6.0], Fiop::Ahead), None);
        assert_eq!(select(&[-14.0, -6.0], Fiop::AheadFirst), Some(-6.0));
        for f in [Fiop::Nearest, Fiop::Ahead, Fiop::AheadFirst] {
            assert_eq!(select(&[8.0, 18.0], f), Some(8.0));
            assert_eq!(select(&[-2.0, 2.0], f), Some(2.0));
            assert_eq!(select(&[], f), None);
        }
        assert_eq!(select(&[-1.0, 4.0], Fiop::AheadFirst), Some(4.0));
        assert_eq!(select(&[-1.0, 4.0], Fiop::Nearest), Some(-1.0));
    }

    #[test]
    fn points_do_not_control_the_tool() {
        assert!(Surface::from_form(&Form::Point(Vec3::zeros())).is_none());
        let c = crate::Circle { center: Vec3::zeros(), axis: Vec3::z(), radius: 2.0 };
        let s = Surface::from_form(&Form::Circle(c)).unwrap();
        assert!((s.distance(Vec3::new(5.0, 0.0, 9.0)) - 3.0).abs() < 1e-15);
    }
}
