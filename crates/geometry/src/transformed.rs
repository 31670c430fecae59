//! Forms carried from one system to another (REFSYS, and copies of surfaces).

use std::sync::Arc;

use crate::sculptured::{Side, Solid};
use crate::{
    Circle, Cone, Cylinder, Form, FormKind, Line, Pattern, Plane, Polyconic, Quadric, Rail,
    RuledSurface, Second, Sphere, Transform, Vec3, Written,
};

/// Why a form cannot be carried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotCarried {
    /// The map flattens space.
    Flat,
    /// The map scales directions differently, and the form would change its kind.
    Unequal,
}

/// A LINE stays a line while its normal leans out of the xy plane by less than this.
const UPRIGHT: f64 = 1e-12;

impl Form {
    /// The form carried by `m`.
    ///
    /// A LINE that is tilted by the map is a plane from then on, kept under the word LINE. A MATRIX is not
    /// carried: REFSYS leaves it as it is.
    pub fn transformed(&self, m: &Transform) -> Result<Self, NotCarried> {
        let scale = || m.uniform_scale().ok_or(NotCarried::Unequal);
        let unit = |v: Vec3| {
            let v = m.vector(v);
            v.try_normalize(0.0).ok_or(NotCarried::Flat)
        };
        Ok(match self {
            Self::Point(p) => Self::Point(m.point(*p)),
            Self::Vector(v) => Self::Vector(m.vector(*v)),
            Self::Line(l) => {
                let p = plane(&l.plane(), m)?;
                match Line::new(p.n.x, p.n.y, p.d).filter(|_| p.n.z.abs() <= UPRIGHT) {
                    Some(line) => Self::Line(line),
                    None => Self::Written(Arc::new(Written {
                        kind: FormKind::Line,
                        elements: vec![p.n.x, p.n.y, p.n.z, p.d],
                        shape: Self::Plane(p),
                    })),
                }
            }
            Self::Plane(p) => Self::Plane(plane(p, m)?),
            Self::Circle(c) => Self::Circle(Circle {
                radius: c.radius * scale()?,
                center: m.point(c.center),
                axis: unit(c.axis)?,
            }),
            Self::Cylinder(c) => Self::Cylinder(Cylinder {
                radius: c.radius * scale()?,
                point: m.point(c.point),
                axis: unit(c.axis)?,
            }),
            Self::Sphere(s) => {
                Self::Sphere(Sphere { center: m.point(s.center), radius: s.radius * scale()? })
            }
            Self::Cone(c) => {
                scale()?;
                let (vertex, axis) = (m.point(c.vertex), unit(c.axis)?);
                Self::Cone(Cone { vertex, axis, cos_half: c.cos_half })
            }
            Self::Quadric(q) => Self::Quadric(quadric(q, m)?),
            Self::Matrix(t) => Self::Matrix(*t),
            Self::Pattern(p) => {
                Self::Pattern(Pattern { points: p.points.iter().map(|p| m.point(*p)).collect() })
            }
            Self::Tabcyl(t) => Self::Tabcyl(Arc::new(t.transformed(m).ok_or(NotCarried::Unequal)?)),
            Self::Ruled(r) => {
                let second = match &r.second {
                    Second::Rail(rail) => Second::Rail(carry_rail(rail, m)?),
                    Second::Apex(p) => Second::Apex(m.point(*p)),
                };
                Self::Ruled(Arc::new(RuledSurface { first: carry_rail(&r.first, m)?, second }))
            }
            Self::Polyconic(p) => {
                scale()?;
                let whole = p.transform().unwrap_or_else(Transform::identity).then(m);
                let back = whole.inverse().ok_or(NotCarried::Unequal)?;
                Self::Polyconic(Arc::new(Polyconic { matrix: back.rows(), ..(**p).clone() }))
            }
            Self::Scurv(c) => Self::Scurv(Arc::new(c.then(m))),
            Self::Ssurf(s) => Self::Ssurf(Arc::new(s.then(m))),
            Self::Solid(s) => {
                let parts = s.parts.iter().map(|(form, side)| {
                    let side = match *side {
                        Side::Of(p) => Side::Of(m.point(p)),
                        Side::Toward(v) => Side::Toward(unit(v)?),
                        other => other,
                    };
                    Ok((form.transformed(m)?, side))
                });
                let parts = parts.collect::<Result<_, _>>()?;
                Self::Solid(Arc::new(Solid { object: s.object, parts }))
            }
            Self::Written(w) => {
                let shape = w.shape.transformed(m)?;
                let (kind, elements) = (w.kind, shape.canonical());
                match shape {
                    Self::Written(_) => shape,
                    shape if shape.kind() == kind => shape,
                    shape => Self::Written(Arc::new(Written { kind, elements, shape })),
                }
            }
        })
    }
}

fn plane(p: &Plane, m: &Transform) -> Result<Plane, NotCarried> {
    let n = m.normal(p.n).ok_or(NotCarried::Flat)?;
    let d = n.dot(&m.point(p.n * p.d));
    Plane::new(n, d).ok_or(NotCarried::Flat)
}

fn carry_rail(rail: &Rail, m: &Transform) -> Result<Rail, NotCarried> {
    Ok(Rail {
        surface: Arc::new(rail.surface.transformed(m)?),
        start: m.point(rail.start),
        end: m.point(rail.end),
        toward: m.vector(rail.toward),
    })
}

/// With p = B q + s the form back, `[p 1] Q [p 1]` becomes `[q 1] T' Q T [q 1]`.
fn quadric(q: &Quadric, m: &Transform) -> Result<Quadric, NotCarried> {
    let back = m.inverse().ok_or(NotCarried::Flat)?;
    let [a, b, c, d, f, g, h, l, n, r] = q.c;
    let old = nalgebra::Matrix4::new(a, h, g, l, h, b, f, n, g, f, c, r, l, n, r, d);
    let mut t = nalgebra::Matrix4::identity();
    t.fixed_view_mut::<3, 3>(0, 0).copy_from(&back.linear);
    t.fixed_view_mut::<3, 1>(0, 3).copy_from(&back.shift);
    let e = t.transpose() * old * t;
    let at = |i: usize, j: usize| e[(i, j)];
    let c = [
        at(0, 0),
        at(1, 1),
        at(2, 2),
        at(3, 3),
        at(1, 2),
        at(0, 2),
        at(0, 1),
        at(0, 3),
        at(1, 3),
        at(2, 3),
    ];
    Ok(Quadric { kind: q.kind, c })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::QuadricKind;

    fn map() -> Transform {
        let turn = Transform::rotation(Vec3::new(1.0, 2.0, -0.5).normalize(), 33.0);
        turn.then(&Transform::scale(2.0)).then(&Transform::translation(Vec3::new(3.0, -1.0, 7.0)))
    }

    #[test]
    fn points_of_a_surface_stay_on_it() {
        let m = map();
        let line = Form::Line(Line::new(1.0, 2.0, 3.0).unwrap());
        let moved = line.transformed(&m).unwrap();
        assert_eq!(moved.kind(), FormKind::Line);
        let Form::Plane(p) = moved.shape() else { panic!("tilted") };
        for q in [Vec3::new(3.0, 0.0, 9.0), Vec3::new(1.0, 1.0, -2.0)] {
            assert!(p.distance(m.point(q)).abs() < 1e-12);
        }
        let back = moved.transformed(&m.inverse().unwrap()).unwrap();
        let (a, b) = (back.canonical(), line.canonical());
        assert_eq!(back.kind(), FormKind::Line);
        assert!(a.iter().zip(&b).all(|(x, y)| (x - y).abs() < 1e-12), "{a:?}");

        let c = [1.0, 2.0, 3.0, -4.0, 0.5, 0.25, -0.5, 1.0, 0.0, 2.0];
        let q = Quadric { kind: QuadricKind::Qadric, c };
        let Form::Quadric(moved) = Form::Quadric(q).transformed(&m).unwrap() else {
            panic!("quadric")
        };
        let p = Vec3::new(0.3, -0.7, 1.1);
        assert!((moved.value(m.point(p)) - q.value(p)).abs() < 1e-12);
    }

    #[test]
    fn a_stretched_circle_is_refused() {
        let mut m = Transform::identity();
        m.linear[(0, 0)] = 2.0;
        let c = Circle { center: Vec3::zeros(), axis: Vec3::z(), radius: 1.0 };
        assert_eq!(Form::Circle(c).transformed(&m), Err(NotCarried::Unequal));
    }
}
