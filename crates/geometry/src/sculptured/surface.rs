//! SSURF: what a sculptured surface is made of.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::numbers::{push, push_curves, push_knots, push_map, push_smoothing};
use super::{CurveDefinition, Extent, Knot, Smoothing};
use crate::{Transform, Vec3};

/// SSURF: what a sculptured surface is made of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SurfaceDefinition {
    /// The surface before TRFORM.
    pub shape: SurfaceShape,
    /// Carries the finished surface into the base system.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub map: Option<Transform>,
}

/// The kinds of SSURF.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SurfaceShape {
    /// SMESH, GMESH: splines in order, each through its points; all have the same number of points, u
    /// runs along a spline, v across.
    Mesh {
        /// SMESH or GMESH.
        kind: MeshKind,
        /// Which coordinates the points are spaced by.
        spacing: MeshSpacing,
        /// The splines.
        splines: Vec<MeshSpline>,
    },
    /// PATCH.
    Patches {
        /// What the sixteen items of a patch are.
        kind: PatchKind,
        /// The patches in order.
        patches: Vec<Patch>,
    },
    /// REVOLV: a curve turned about an axis.
    Revolved {
        /// The curve.
        curve: Arc<CurveDefinition>,
        /// A point of the axis.
        origin: Vec3,
        /// Direction of the axis, not unit.
        axis: Vec3,
        /// CLW; CCLW when false.
        clockwise: bool,
        /// First and last angle, degrees.
        angles_deg: [f64; 2],
    },
    /// RULED by two curves.
    RuledBetween([Arc<CurveDefinition>; 2]),
    /// RULED along an axis: a cylinder over the curve.
    RuledAlong {
        /// The curve.
        curve: Arc<CurveDefinition>,
        /// Direction of the rulings: the vector, or from the first point to the second.
        axis: Vec3,
        /// How far they go to both sides of the curve (APT4: ten inches).
        reach: f64,
    },
    /// GENCUR: a surface through curves, and with CROSS through curves across them.
    General {
        /// Curves along the surface.
        curves: Vec<Arc<CurveDefinition>>,
        /// Curves behind CROSS.
        cross: Vec<Arc<CurveDefinition>>,
    },
    /// TRANSL XYROT YZROT ZXROT SCALE: a curve moved along another.
    Swept {
        /// How it moves.
        motion: Sweep,
        /// The curve.
        curve: Arc<CurveDefinition>,
        /// The curve behind CROSS that guides it.
        guide: Arc<CurveDefinition>,
    },
    /// COMBIN: surfaces taken together.
    Combined(Vec<Arc<SurfaceDefinition>>),
    /// CANON: the array of numbers by which APT4 kept a surface.
    Canonical(Vec<f64>),
    /// A B-spline surface from outside.
    Bspline(Box<BsplineSurface>),
    /// Triangles from outside, for checking.
    Facets(Vec<[Vec3; 3]>),
}

/// A B-spline surface, rational where its weights differ.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BsplineSurface {
    /// Along u and across.
    pub degree: [usize; 2],
    /// Never falling, for each direction as many as control points plus degree plus one.
    pub knots: [Vec<f64>; 2],
    /// Control points along u and across.
    pub counts: [usize; 2],
    /// x, y, z and weight of each, along u first; the coordinates are not multiplied by the weight.
    pub points: Vec<[f64; 4]>,
    /// The part of each parameter's range that belongs to the surface; all of it where none is given.
    #[serde(default)]
    pub range: [Option<[f64; 2]>; 2],
}

/// SMESH or GMESH.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
#[expect(missing_docs, reason = "each is the APT word")]
pub enum MeshKind {
    Smesh,
    Gmesh,
}

/// The word behind SMESH.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum MeshSpacing {
    /// Distances in space.
    Xyz,
    /// Bilinear seen along z; heights in z.
    Xyplan,
    /// Bilinear seen along x; heights in x.
    Yzplan,
    /// Bilinear seen along y; heights in y.
    Zxplan,
    /// Straight between neighbouring splines.
    Ruled,
}

/// A spline of a mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MeshSpline {
    /// WEIGHT and LIMIT before its first point.
    #[serde(default, skip_serializing_if = "Smoothing::is_none")]
    pub smoothing: Smoothing,
    /// Its points.
    pub knots: Vec<Knot>,
}

/// What the items of a patch are; corners in the order (0,0) (1,0) (0,1) (1,1) of (u,v).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum PatchKind {
    /// Rows of the Coons matrix: P00 P10 Pu00 Pu10, P01 P11 Pu01 Pu11, Pv00 Pv10 Puv00 Puv10, Pv01 Pv11
    /// Puv01 Puv11.
    Pntvec,
    /// Sixteen corners of a Bezier net, u running first.
    Polygn,
    /// Sixteen points of the surface, u running first; zeros inside are chosen by the evaluator.
    Pntson,
}

/// A patch with the side of its normal.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Patch {
    /// MINUS was written. It changes nothing: parameters and normal are those of PLUS, as in SSV3.
    #[serde(default)]
    pub minus: bool,
    /// The sixteen items as written.
    pub items: [Vec3; 16],
}

/// How a curve moves along another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
#[expect(missing_docs, reason = "each is the APT word")]
pub enum Sweep {
    Transl,
    Xyrot,
    Yzrot,
    Zxrot,
    Scale,
}

impl SurfaceDefinition {
    /// Does it hold triangles, so that a cutter is checked against it and cannot be guided by it?
    pub fn only_checks(&self) -> bool {
        match &self.shape {
            SurfaceShape::Facets(_) => true,
            SurfaceShape::Combined(parts) => parts.iter().any(|p| p.only_checks()),
            _ => false,
        }
    }

    /// All of its triangles, where it holds nothing else.
    pub fn triangles(&self) -> Option<Vec<[Vec3; 3]>> {
        let all = match &self.shape {
            SurfaceShape::Facets(all) => all.clone(),
            SurfaceShape::Combined(parts) => {
                let parts: Option<Vec<_>> = parts.iter().map(|p| p.triangles()).collect();
                parts?.concat()
            }
            _ => return None,
        };
        let Some(map) = &self.map else { return Some(all) };
        Some(all.into_iter().map(|t| t.map(|p| map.point(p))).collect())
    }

    /// SMESH through the points of splines in order, without anything asked of them.
    pub fn mesh(spacing: MeshSpacing, splines: impl IntoIterator<Item = Vec<Vec3>>) -> Self {
        let knot = |point: Vec3| Knot { point, ..Knot::default() };
        let spline = |points: Vec<Vec3>| MeshSpline {
            smoothing: Smoothing::default(),
            knots: points.into_iter().map(knot).collect(),
        };
        let splines = splines.into_iter().map(spline).collect();
        Self::plain(SurfaceShape::Mesh { kind: MeshKind::Smesh, spacing, splines })
    }

    /// A surface without TRFORM.
    pub fn plain(shape: SurfaceShape) -> Self {
        Self { shape, map: None }
    }

    /// Its size.
    pub fn extent(&self) -> Extent {
        match &self.shape {
            SurfaceShape::Mesh { splines, .. } => {
                Extent::of(splines.iter().map(|s| s.knots.len()).sum(), [])
            }
            SurfaceShape::Patches { patches, .. } => Extent::of(16 * patches.len(), []),
            SurfaceShape::Revolved { curve, .. } | SurfaceShape::RuledAlong { curve, .. } => {
                Extent::of(2, [curve.extent()])
            }
            SurfaceShape::RuledBetween(curves) => Extent::of(0, curves.iter().map(|c| c.extent())),
            SurfaceShape::General { curves, cross } => {
                Extent::of(0, curves.iter().chain(cross).map(|c| c.extent()))
            }
            SurfaceShape::Swept { curve, guide, .. } => {
                Extent::of(0, [curve.extent(), guide.extent()])
            }
            SurfaceShape::Combined(surfaces) => Extent::of(0, surfaces.iter().map(|s| s.extent())),
            SurfaceShape::Canonical(numbers) => Extent::of(numbers.len() / 3, []),
            SurfaceShape::Bspline(b) => Extent::of(b.points.len(), []),
            SurfaceShape::Facets(all) => Extent::of(all.len(), []),
        }
    }

    /// The surface carried by `m` after all it has gone through.
    #[must_use]
    pub fn then(&self, m: &Transform) -> Self {
        let map = Some(self.map.map_or(*m, |own| own.then(m)));
        Self { map, ..self.clone() }
    }

    /// All numbers of the definition in the order written, for print-outs and checks.
    pub fn numbers(&self) -> Vec<f64> {
        let mut out = Vec::new();
        match &self.shape {
            SurfaceShape::Mesh { splines, .. } => {
                for spline in splines {
                    push_smoothing(&mut out, &spline.smoothing);
                    push_knots(&mut out, &spline.knots);
                }
            }
            SurfaceShape::Patches { patches, .. } => {
                patches.iter().for_each(|p| push(&mut out, &p.items));
            }
            SurfaceShape::Revolved { curve, origin, axis, angles_deg, .. } => {
                out.extend(curve.numbers());
                push(&mut out, &[*origin, *axis]);
                out.extend(angles_deg);
            }
            SurfaceShape::RuledBetween(curves) => push_curves(&mut out, curves),
            SurfaceShape::RuledAlong { curve, axis, .. } => {
                out.extend(curve.numbers());
                push(&mut out, &[*axis]);
            }
            SurfaceShape::General { curves, cross } => {
                push_curves(&mut out, curves);
                push_curves(&mut out, cross);
            }
            SurfaceShape::Swept { curve, guide, .. } => {
                out.extend(curve.numbers());
                out.extend(guide.numbers());
            }
            SurfaceShape::Combined(surfaces) => {
                surfaces.iter().for_each(|s| out.extend(s.numbers()));
            }
            SurfaceShape::Canonical(numbers) => out.extend(numbers),
            SurfaceShape::Bspline(b) => {
                b.knots.iter().for_each(|k| out.extend(k));
                b.points.iter().for_each(|p| out.extend(p));
                b.range.iter().flatten().for_each(|r| out.extend(r));
            }
            SurfaceShape::Facets(all) => all.iter().for_each(|t| push(&mut out, t)),
        }
        push_map(&mut out, self.map.as_ref());
        out
    }
}
