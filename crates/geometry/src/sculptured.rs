//! SCURV, SSURF, BOUNDS and OBJECT as they were defined: every argument resolved, nothing fitted yet.
//!
//! Section 1 reads and checks the statement and writes these; what evaluates curves and surfaces starts
//! from them. All points and vectors stand in the system of the definition, lengths in program units,
//! angles in degrees; `map` (TRFORM first, REFSYS after it) carries the finished curve or surface into the
//! base system. Curves and surfaces that a definition names are held by value, with their own `map`.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::{Form, Transform, Vec3};

/// SCURV: what a sculptured curve is made of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CurveDefinition {
    /// The curve before FLOW, SEG and TRFORM.
    pub shape: CurveShape,
    /// FLOW: how the parameter runs; the spans adjoin, from 0 to the last. Empty without FLOW.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub flow: Vec<FlowSpan>,
    /// SEG behind FLOW: how the spans are divided; they adjoin likewise. Empty without FLOW.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub segments: Vec<SegmentSpan>,
    /// Carries the finished curve into the base system.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub map: Option<Transform>,
}

/// The kinds of SCURV.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CurveShape {
    /// CURSEG: one conic arc by two to five conditions, points and tangents counted together; three of them
    /// make a circle, two points a line.
    Conic(Vec<Knot>),
    /// SPLINE: two or more points.
    Spline {
        /// WEIGHT and LIMIT before the first point, which switch smoothing on for all points.
        smoothing: Smoothing,
        /// The points in order.
        knots: Vec<Knot>,
    },
    /// SEG: the stretch of a straight line.
    Stretch {
        /// Where it begins and ends, on ZSURF.
        ends: [Vec3; 2],
    },
    /// SEG: an arc of a circle, clockwise seen against its axis from the first end to the second.
    Arc {
        /// Centre, in the plane of the ends.
        center: Vec3,
        /// Unit axis.
        axis: Vec3,
        /// Where it begins and ends, on ZSURF.
        ends: [Vec3; 2],
    },
    /// COMBIN: curves one after the other.
    Combined(Vec<Arc<CurveDefinition>>),
    /// CANON: the array of numbers by which APT4 kept a curve.
    Canonical(Vec<f64>),
}

/// A point of a curve or of a spline of a surface, with what is asked of the curve there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Knot {
    /// The point.
    pub point: Vec3,
    /// TANSPL: direction and length along the curve.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tangent: Option<Vec3>,
    /// CRSSPL: direction across it, for the surface that uses the curve.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cross: Option<Vec3>,
    /// NORMAL: the normal of the surface.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub normal: Option<Vec3>,
    /// WEIGHT and LIMIT behind the point, in place of those for all.
    #[serde(default, skip_serializing_if = "Smoothing::is_none")]
    pub smoothing: Smoothing,
}

/// How far a smoothed curve may leave its points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Smoothing {
    /// WEIGHT: how much a point's distance counts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weight: Option<f64>,
    /// LIMIT: greatest distance.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limit: Option<f64>,
}

/// `ARC|PARAM|ANGLE|CHORD,n1,n2[,RELTOL,t][,points][,vector]` behind FLOW.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlowSpan {
    /// What grows evenly.
    pub law: FlowLaw,
    /// First and last point of the curve, counted from 0.
    pub range: [f64; 2],
    /// RELTOL, between 0 and 1; the evaluator's own when not written.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// ANGLE: the centre (PIVOT). CHORD: the two ends of the base line (CHDPT). At most two.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<Vec3>,
    /// Normal of the plane in which angles, or direction along which chords are measured (PLANO).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vector: Option<Vec3>,
}

/// What grows evenly along a span of FLOW.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FlowLaw {
    /// PARAM: the parameter of the arcs.
    Parameter,
    /// ARC: the length of the curve.
    Arc,
    /// ANGLE: the angle about a point.
    Angle,
    /// CHORD: the distance along a base line.
    Chord,
}

/// `LENGTH|PARAM,m1,m2` behind SEG.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SegmentSpan {
    /// Whether by length (LENGTH) or by parameter (PARAM).
    pub by_length: bool,
    /// First and last point of the curve, counted from 0.
    pub range: [f64; 2],
}

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
        /// Direction and length of the rulings: the vector, or from the first point to the second.
        axis: Vec3,
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

/// BOUNDS and OBJECT: sides of surfaces, and solids made of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solid {
    /// OBJECT joins its parts; BOUNDS is what all its sides have in common.
    pub object: bool,
    /// The surfaces, or BOUNDS and OBJECTs, with their sides.
    pub parts: Vec<(Form, Side)>,
}

/// Which side of a surface belongs to a BOUNDS.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// None was named: the surface's own positive side; always so in an OBJECT.
    Own,
    /// A number.
    Numbered(f64),
    /// IN.
    In,
    /// OUT.
    Out,
    /// The side of a point.
    Of(Vec3),
    /// POSX to NEGZ: the side towards this unit direction.
    Toward(Vec3),
}

/// How large a definition is with all that it holds; whoever builds one from others bounds it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extent {
    /// Points, or surfaces of a solid.
    pub points: usize,
    /// Definitions within each other; 1 for one that holds none.
    pub depth: usize,
}

impl Extent {
    /// A definition of `points` points that holds others.
    fn of(points: usize, held: impl IntoIterator<Item = Self>) -> Self {
        let mut whole = Self { points, depth: 0 };
        for part in held {
            whole.points = whole.points.saturating_add(part.points);
            whole.depth = whole.depth.max(part.depth);
        }
        whole.depth += 1;
        whole
    }
}

impl Smoothing {
    /// Is neither WEIGHT nor LIMIT given?
    pub fn is_none(&self) -> bool {
        self.weight.is_none() && self.limit.is_none()
    }
}

impl CurveDefinition {
    /// A curve without FLOW and TRFORM.
    pub fn plain(shape: CurveShape) -> Self {
        Self { shape, flow: Vec::new(), segments: Vec::new(), map: None }
    }

    /// The number of spans that FLOW counts; `None` where only the evaluator knows.
    pub fn n_spans(&self) -> Option<usize> {
        match &self.shape {
            CurveShape::Conic(_) | CurveShape::Stretch { .. } | CurveShape::Arc { .. } => Some(1),
            CurveShape::Spline { knots, .. } => Some(knots.len().saturating_sub(1)),
            CurveShape::Combined(curves) => curves.iter().map(|c| c.n_spans()).sum(),
            CurveShape::Canonical(_) => None,
        }
    }

    /// Its size.
    pub fn extent(&self) -> Extent {
        match &self.shape {
            CurveShape::Conic(knots) | CurveShape::Spline { knots, .. } => {
                Extent::of(knots.len(), [])
            }
            CurveShape::Stretch { .. } | CurveShape::Arc { .. } => Extent::of(2, []),
            CurveShape::Combined(curves) => Extent::of(0, curves.iter().map(|c| c.extent())),
            CurveShape::Canonical(numbers) => Extent::of(numbers.len() / 3, []),
        }
    }

    /// The curve carried by `m` after all it has gone through.
    #[must_use]
    pub fn then(&self, m: &Transform) -> Self {
        let map = Some(self.map.map_or(*m, |own| own.then(m)));
        Self { map, ..self.clone() }
    }

    /// All numbers of the definition in the order written, for print-outs and checks.
    pub fn numbers(&self) -> Vec<f64> {
        let mut out = Vec::new();
        match &self.shape {
            CurveShape::Conic(knots) => push_knots(&mut out, knots),
            CurveShape::Spline { smoothing, knots } => {
                push_smoothing(&mut out, smoothing);
                push_knots(&mut out, knots);
            }
            CurveShape::Stretch { ends } => push(&mut out, ends),
            CurveShape::Arc { center, axis, ends } => {
                push(&mut out, &[*center, *axis]);
                push(&mut out, ends);
            }
            CurveShape::Combined(curves) => push_curves(&mut out, curves),
            CurveShape::Canonical(numbers) => out.extend(numbers),
        }
        for span in &self.flow {
            out.extend(span.range);
            out.extend(span.tolerance);
            push(&mut out, &span.points);
            push(&mut out, span.vector.as_slice());
        }
        out.extend(self.segments.iter().flat_map(|s| s.range));
        push_map(&mut out, self.map.as_ref());
        out
    }
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
            SurfaceShape::RuledAlong { curve, axis } => {
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

impl Solid {
    /// Its size.
    pub fn extent(&self) -> Extent {
        let inner = self.parts.iter().filter_map(|(form, _)| match form {
            Form::Solid(s) => Some(s.extent()),
            _ => None,
        });
        Extent::of(self.parts.len(), inner)
    }

    /// All numbers of the parts in order.
    pub fn numbers(&self) -> Vec<f64> {
        let mut out = Vec::new();
        for (form, side) in &self.parts {
            out.extend(form.canonical());
            match side {
                Side::Numbered(n) => out.push(*n),
                Side::Of(v) | Side::Toward(v) => push(&mut out, &[*v]),
                Side::Own | Side::In | Side::Out => {}
            }
        }
        out
    }
}

fn push(out: &mut Vec<f64>, points: &[Vec3]) {
    out.extend(points.iter().flat_map(|p| [p.x, p.y, p.z]));
}

fn push_smoothing(out: &mut Vec<f64>, s: &Smoothing) {
    out.extend(s.weight.into_iter().chain(s.limit));
}

fn push_knots(out: &mut Vec<f64>, knots: &[Knot]) {
    for knot in knots {
        push(out, &[knot.point]);
        for v in [knot.tangent, knot.cross, knot.normal].into_iter().flatten() {
            push(out, &[v]);
        }
        push_smoothing(out, &knot.smoothing);
    }
}

fn push_curves(out: &mut Vec<f64>, curves: &[Arc<CurveDefinition>]) {
    curves.iter().for_each(|c| out.extend(c.numbers()));
}

fn push_map(out: &mut Vec<f64>, map: Option<&Transform>) {
    out.extend(map.iter().flat_map(|m| m.rows()));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line() -> CurveDefinition {
        let knot = |x| Knot { point: Vec3::new(x, 0.0, 0.0), ..Knot::default() };
        CurveDefinition::plain(CurveShape::Conic(vec![knot(0.0), knot(2.0)]))
    }

    #[test]
    fn maps_are_applied_one_after_the_other() {
        let turn = Transform::from_rows(&[0., -1., 0., 0., 1., 0., 0., 0., 0., 0., 1., 0.]);
        let shift = Transform::from_rows(&[1., 0., 0., 5., 0., 1., 0., 0., 0., 0., 1., 0.]);
        let curve = line().then(&turn).then(&shift);
        let whole = curve.map.expect("a map was given");
        assert_eq!(whole.point(Vec3::new(2.0, 0.0, 0.0)), Vec3::new(5.0, 2.0, 0.0));
    }

    #[test]
    fn spans_of_joined_curves_add_up() {
        let both = CurveShape::Combined(vec![Arc::new(line()), Arc::new(line())]);
        assert_eq!(CurveDefinition::plain(both).n_spans(), Some(2));
        let canon = CurveDefinition::plain(CurveShape::Canonical(vec![1.0]));
        assert_eq!(canon.n_spans(), None);
    }
}
