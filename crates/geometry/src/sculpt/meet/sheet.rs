//! One patch or plane, moved by its thickness.

use crate::sculpt::{Derivatives, Patch};
use crate::surface::frame_about;
use crate::{Plane, Vec3};

/// A patch or a plane with its thickness.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheet<'a> {
    pub(super) shape: Shape<'a>,
    /// Moved so far along its normals.
    pub(super) thick: f64,
    /// The surface and its patch.
    pub(super) of: [usize; 2],
    /// Least and greatest coordinates; none for a plane.
    bounds: Option<[Vec3; 2]>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Shape<'a> {
    /// A point of the plane, two unit directions in it, and its normal.
    Plane {
        origin: Vec3,
        frame: [Vec3; 2],
        normal: Vec3,
    },
    Patch(&'a Patch),
}

/// A place on a sheet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    /// The place of the moved sheet.
    pub(super) point: Vec3,
    /// Its derivatives.
    pub(super) u: Vec3,
    pub(super) v: Vec3,
    pub(super) normal: Vec3,
    /// The place of the sheet itself.
    pub(super) foot: Vec3,
}

impl<'a> Sheet<'a> {
    pub(super) fn plane(plane: &Plane, thick: f64) -> Self {
        let normal = plane.n;
        let shape = Shape::Plane { origin: normal * plane.d, frame: frame_about(normal), normal };
        Self { shape, thick, of: [0, 0], bounds: None }
    }

    pub(super) fn patch(patch: &'a Patch, of: [usize; 2], thick: f64) -> Self {
        let room = Vec3::repeat(thick.abs());
        let [lo, hi] = patch.bounds();
        Self { shape: Shape::Patch(patch), thick, of, bounds: Some([lo - room, hi + room]) }
    }

    /// Do the boxes around both overlap?
    pub(super) fn may_meet(&self, other: &Self) -> bool {
        let (Some([a, b]), Some([c, d])) = (self.bounds, other.bounds) else { return true };
        (0..3).all(|k| a[k] <= d[k] && c[k] <= b[k])
    }

    /// How large its numbers are.
    pub(super) fn extent(&self) -> f64 {
        self.bounds.map_or(0.0, |[lo, hi]| lo.norm().max(hi.norm()))
    }

    /// Has it borders?
    pub(super) fn ends(&self) -> bool {
        self.bounds.is_some()
    }

    /// The place at (u, v); `None` where a patch has no normal.
    pub(super) fn spot(&self, [u, v]: [f64; 2]) -> Option<Spot> {
        match self.shape {
            Shape::Plane { origin, frame: [a, b], normal } => {
                let foot = origin + a * u + b * v;
                Some(Spot { point: foot + normal * self.thick, u: a, v: b, normal, foot })
            }
            Shape::Patch(patch) => {
                let d = patch.at(u, v);
                let normal = d.normal()?;
                if self.thick == 0.0 {
                    return Some(Spot { point: d.point, u: d.u, v: d.v, normal, foot: d.point });
                }
                let size = d.u.cross(&d.v).norm();
                let turn = |nu: Vec3| (nu - normal * normal.dot(&nu)) * (self.thick / size);
                Some(Spot {
                    point: d.point + normal * self.thick,
                    u: d.u + turn(d.uu.cross(&d.v) + d.u.cross(&d.uv)),
                    v: d.v + turn(d.uv.cross(&d.v) + d.u.cross(&d.vv)),
                    normal,
                    foot: d.point,
                })
            }
        }
    }
}

impl Spot {
    /// Components of `w`, laid into the tangent plane, along the derivatives.
    pub(super) fn components(&self, w: Vec3) -> Option<[f64; 2]> {
        Derivatives { u: self.u, v: self.v, ..Derivatives::default() }.components(w)
    }
}
