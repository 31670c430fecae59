//! The working surface of a polyconic that has a thickness: parallel to the one that is defined, with the same normals and
//! the same nearest places.

use super::jet::{Jet, shape};
use super::{ParametricSurface, Placed};
use crate::Vec3;
use crate::surface::Shape;

impl ParametricSurface {
    /// The point of the working surface over a point of the patch.
    #[inline]
    pub(super) fn raised(&self, s: Vec3, normal: Vec3) -> Vec3 {
        if self.rise == 0.0 { s } else { s + normal * self.rise }
    }

    /// A place of the working surface with its derivatives by both parameters.
    #[inline]
    pub(super) fn working(&self, place: &Placed) -> (Vec3, [Vec3; 2]) {
        let Placed { u, v, jet } = place;
        if self.rise == 0.0 {
            return (jet.s, [jet.su, jet.sv]);
        }
        let normal = self.normal_at(*u, *v, jet);
        let shape = shape(jet, normal);
        let raised = |along: Vec3| along + shape.apply(along) * self.rise;
        (self.raised(jet.s, normal), [raised(jet.su), raised(jet.sv)])
    }

    /// The curvature of the working surface; none at a centre of curvature of the patch.
    #[inline]
    pub(super) fn bend(&self, jet: &Jet, normal: Vec3) -> Shape {
        let shape = shape(jet, normal);
        if self.rise == 0.0 {
            return shape;
        }
        shape.offset(self.rise).unwrap_or_else(|| Shape::flat(normal))
    }

    /// The samples of the working surface.
    pub(super) fn working_grid(&self) -> impl Iterator<Item = Vec3> {
        let own = self.planes.iter().filter(|_| self.rise != 0.0);
        let raised = own.flat_map(|p| p.samples().iter().map(|s| s.point));
        let plain = if self.rise == 0.0 { self.samples.grid.as_slice() } else { &[] };
        raised.chain(plain.iter().copied())
    }
}
