//! Curves in which sculptured surfaces meet a plane or one another.
//!
//! Pairs of cells of the patches whose hulls overlap are halved until the surfaces cross in them at an angle,
//! and Newton's method finds a place there ([`cells`]); of a plane and a patch, until no curve closes in a cell, and
//! each one is met on its sides ([`level`]). From a place that lies on no curve yet the curve is followed to the
//! borders of both patches or round to itself ([`trace`]), in chords that keep a tolerance. The pieces are put
//! together where they meet ([`join()`]); one that ends where no surface does is told as such.

mod cells;
#[cfg(test)]
mod hills;
mod join;
mod level;
mod sheet;
mod strays;
#[cfg(test)]
mod tests;
mod trace;

use std::fmt;

use super::surface::Sculptured;
use crate::{Plane, Vec3};
use cells::Budget;
use join::{join, loose_end};
use sheet::Sheet;
use trace::{Knot, Piece, Touch, Tracer};

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
    /// An end of it where no surface ends: it may go on there, as beside places where the two touch.
    pub lost: Option<Vec3>,
}

/// Why the curves were not found.
#[derive(Clone, Copy, Debug, PartialEq)]
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
/// that are smaller than some tolerances may be missed (of two sculptured surfaces, and with thickness, those smaller
/// than a 256th of a patch), as may places where the two touch without crossing. The order is that of the patches, whatever the number of threads.
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
    let mut budget = Budget::new();
    let mut found: Vec<Found<'_>> = Vec::new();
    let others = sheets(second.0, second.1);
    for other in &others {
        for one in ones.iter().filter(|one| one.may_meet(other)) {
            let tracer = Tracer::new(one, other, tolerance);
            let mut own: Vec<Found<'_>> = Vec::new();
            for seed in cells::seeds(&tracer, &mut budget)? {
                let at = (tracer.point(&seed), seed.along());
                if own.iter().any(|f| f.holds(at)) {
                    continue;
                }
                if let Some(piece) = tracer.trace(seed)? {
                    own.push(Found::new(tracer, piece));
                }
            }
            // A curve along the border of two patches, or just over it and back, is met in both.
            own.retain(|piece| !found.iter().any(|f| piece.lies_on(f)));
            found.retain(|piece| !own.iter().any(|f| piece.lies_on(f)));
            found.append(&mut own);
        }
    }
    let surfaces = match first.0 {
        Cutting::Plane(_) => &[][..],
        Cutting::Surfaces(all) => all.as_slice(),
    };
    let surfaces = [surfaces, second.0];
    let curves = join(found.into_iter().map(|f| f.piece).collect(), tolerance);
    Ok(curves.iter().map(|c| c.told(surfaces)).collect())
}

/// A piece with the sheets that it is of.
struct Found<'a> {
    tracer: Tracer<'a>,
    piece: Piece,
    /// A box round it.
    bounds: [Vec3; 2],
    /// A place within it, and its direction there.
    middle: Option<(Vec3, Vec3)>,
}

impl<'a> Found<'a> {
    fn new(tracer: Tracer<'a>, piece: Piece) -> Self {
        let room = Vec3::repeat(2.0 * tracer.tolerance);
        let start = [Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY)];
        let points = piece.knots.iter().map(|k| k.point);
        let [lo, hi] = points.fold(start, |[lo, hi], p| [lo.inf(&p), hi.sup(&p)]);
        let middle = tracer.middle(&piece);
        Self { tracer, piece, bounds: [lo - room, hi + room], middle }
    }

    /// Does a place with the direction of its curve lie on the piece?
    fn holds(&self, (p, along): (Vec3, Vec3)) -> bool {
        let [lo, hi] = self.bounds;
        (0..3).all(|k| lo[k] <= p[k] && p[k] <= hi[k]) && self.tracer.holds(&self.piece, p, along)
    }

    fn lies_on(&self, other: &Self) -> bool {
        self.middle.is_some_and(|at| other.holds(at))
    }
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
        let points = self.knots.iter().map(told).collect();
        MeetCurve { points, closed: self.closed, lost: loose_end(self, surfaces) }
    }
}
