//! Curves in which sculptured surfaces meet a plane or one another.
//!
//! Pairs of cells of the patches whose hulls overlap are halved until the surfaces cross in them at an angle,
//! and Newton's method finds a place there ([`cells`]). From it the curve is followed to the borders of both
//! patches or round to itself ([`trace`]), in chords that keep a tolerance. The pieces are put together where
//! they meet ([`join()`]).

mod cells;
mod join;
mod sheet;
#[cfg(test)]
mod tests;
mod trace;

use std::fmt;

use super::surface::Sculptured;
use crate::{Plane, Vec3};
use cells::Budget;
use join::join;
use sheet::Sheet;
use trace::{Knot, Piece, Touch, Tracer, near_any};

/// What is cut by surfaces: a plane, or surfaces themselves.
#[derive(Clone, Debug)]
pub enum Cutting<'a> {
    /// A plane.
    Plane(Plane),
    /// Sculptured surfaces.
    Surfaces(Vec<&'a Sculptured>),
}

/// A place on one of the two that meet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeetSide {
    /// Which of the surfaces; 0 for a plane.
    pub surface: usize,
    /// Parameters of the whole surface; 0 0 for a plane.
    pub uv: [f64; 2],
    /// The place itself, without thickness.
    pub foot: Vec3,
    /// Unit normal, u across v.
    pub normal: Vec3,
}

/// A place of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeetPoint {
    /// Where the two with their thicknesses meet.
    pub point: Vec3,
    /// Unit direction of the curve in the order of its places.
    pub along: Vec3,
    /// On what is cut, and on the surface that cuts it.
    pub sides: [MeetSide; 2],
}

/// A curve in which two surfaces meet.
#[derive(Clone, Debug, PartialEq)]
pub struct MeetCurve {
    /// Its places, two at least; the first once more at the end of a closed one.
    pub points: Vec<MeetPoint>,
    /// Does it come back to its beginning?
    pub closed: bool,
}

/// Why the curves were not found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeetFault {
    /// The two lie so near to one another over a stretch that more cells would have to be looked at than this.
    Alike(usize),
    /// A curve has more places than this.
    Long(usize),
}

impl fmt::Display for MeetFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Alike(_) => write!(f, "the two lie within one another over a whole stretch"),
            Self::Long(n) => write!(f, "a curve would have more than {n} points"),
        }
    }
}

/// The curves in which `second` meets `first`, each moved by its thickness in the sense of its normals (for a
/// surface u across v).
///
/// The places lie on both to rounding; the chords between them leave the curve by `tolerance` at most. Loops
/// that are smaller than some tolerances or a 256th of a patch may be missed, as may places where the two touch
/// without crossing. The order is that of the patches, whatever the number of threads.
///
/// APT: `INTSEC`.
pub fn meet(
    first: (&Cutting<'_>, f64),
    second: (&[&Sculptured], f64),
    tolerance: f64,
) -> Result<Vec<MeetCurve>, MeetFault> {
    let plane;
    let ones: Vec<Sheet<'_>> = match first.0 {
        Cutting::Plane(p) => {
            plane = *p;
            vec![Sheet::plane(&plane, first.1)]
        }
        Cutting::Surfaces(all) => sheets(all, first.1),
    };
    let others = sheets(second.0, second.1);
    let mut budget = Budget::new();
    let mut pieces = Vec::new();
    for other in &others {
        for one in ones.iter().filter(|one| one.may_meet(other)) {
            let tracer = Tracer::new(one, other, tolerance);
            for seed in cells::seeds(&tracer, &mut budget)? {
                if near_any(&pieces, tracer.point(&seed), tolerance) {
                    continue;
                }
                if let Some(piece) = tracer.trace(seed)? {
                    pieces.push(piece);
                }
            }
        }
    }
    let surfaces = match first.0 {
        Cutting::Plane(_) => &[][..],
        Cutting::Surfaces(all) => all.as_slice(),
    };
    Ok(join(pieces, tolerance).iter().map(|c| c.told([surfaces, second.0])).collect())
}

fn sheets<'a>(surfaces: &[&'a Sculptured], thick: f64) -> Vec<Sheet<'a>> {
    let mut all = Vec::new();
    for (surface, s) in surfaces.iter().enumerate() {
        for (index, patch) in s.patches.iter().enumerate() {
            all.push(Sheet::patch(patch, [surface, index], thick));
        }
    }
    all
}

impl Piece {
    /// The curve, the parameters of its patches as those of the surfaces.
    fn told(&self, surfaces: [&[&Sculptured]; 2]) -> MeetCurve {
        let side = |touch: &Touch, all: &[&Sculptured]| {
            let [surface, index] = touch.of;
            let uv =
                all.get(surface).map_or([0.0; 2], |s| s.global(index, touch.uv[0], touch.uv[1]));
            MeetSide { surface, uv, foot: touch.foot, normal: touch.normal }
        };
        let told = |k: &Knot| MeetPoint {
            point: k.point,
            along: k.along,
            sides: [side(&k.sides[0], surfaces[0]), side(&k.sides[1], surfaces[1])],
        };
        MeetCurve { points: self.knots.iter().map(told).collect(), closed: self.closed }
    }
}
