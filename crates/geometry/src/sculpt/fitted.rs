//! From definition to curve and surface.

use std::sync::Arc;

use super::arc::CubicArc;
use super::bspline::{BsplineFault, bspline};
use super::canon;
use super::conic::{ConicCondition, ConicFault, conic_arc};
use super::cross::{Product, cross_product, revolve, ruled, swept};
use super::curve::SpaceCurve;
use super::flow::{self, Flow, FlowKind};
use super::loft::{LoftFault, loft};
use super::mesh::{MeshFault, mesh};
use super::patch::Patch;
use super::patches::{filled, from_points, from_polygon, from_vectors};
use super::smooth::smooth;
use super::spline::{SplineFault, SplinePoint, spline};
use super::surface::{SculptFault, Sculptured};
use super::trimmed::circle_between;
use crate::sculptured::{
    CurveDefinition, CurveShape, FlowLaw, FlowSpan, Knot, PatchKind, Smoothing, SurfaceDefinition,
    SurfaceShape, Sweep,
};
use crate::{Circle, Vec3};

/// Why a definition gives no curve or surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "each is the fault of its maker")]
pub enum FitFault {
    Spline(SplineFault),
    Conic(ConicFault),
    Mesh(MeshFault),
    Loft(LoftFault),
    Surface(SculptFault),
    /// The ends of a stretch or arc coincide.
    NoLength,
    /// FLOW or SEG names a joint that the curve has not.
    NoJoint,
    /// CHORD without a direction or two points, or ANGLE without a point.
    NoPivot,
    /// CHORD of FLOW along nothing.
    NoChord,
    /// A B-spline surface is none.
    Bspline(BsplineFault),
    /// The array of CANON is not understood.
    Canonical,
    /// Definitions within each other deeper than a bound.
    TooDeep,
}

impl From<SplineFault> for FitFault {
    fn from(f: SplineFault) -> Self {
        Self::Spline(f)
    }
}

impl From<SculptFault> for FitFault {
    fn from(f: SculptFault) -> Self {
        Self::Surface(f)
    }
}

impl core::fmt::Display for FitFault {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let said = match self {
            Self::Spline(s) | Self::Loft(LoftFault::Across(s)) => return spline_said(*s, f),
            Self::Mesh(MeshFault::Spline(i, _)) => {
                return write!(f, "spline {} has no direction at a point", i + 1);
            }
            Self::Mesh(MeshFault::Cross(i, _)) => {
                return write!(
                    f,
                    "the points numbered {} of the splines have no direction across",
                    i + 1
                );
            }
            Self::Mesh(MeshFault::Uneven(i)) => {
                return write!(f, "spline {} has another number of points than the first", i + 1);
            }
            Self::Loft(LoftFault::Uneven(i)) => {
                return write!(f, "curve {} has another number of segments than the first", i + 1);
            }
            Self::Mesh(MeshFault::TooFew) => "a mesh needs two splines",
            Self::Loft(LoftFault::TooFew) => "GENCUR needs two curves",
            Self::Loft(LoftFault::UnevenCross(i)) => {
                return write!(
                    f,
                    "curve {} across has another number of segments than the first",
                    i + 1
                );
            }
            Self::Loft(LoftFault::Apart(i, j)) => {
                return write!(
                    f,
                    "curve {} and curve {} across do not meet at a joint of both",
                    i + 1,
                    j + 1
                );
            }
            Self::Loft(LoftFault::Cross) => {
                "the curves across do not all meet the curves at the same joints, in one order and at both ends"
            }
            Self::Surface(s)
            | Self::Mesh(MeshFault::Surface(s))
            | Self::Loft(LoftFault::Surface(s)) => match s {
                SculptFault::Empty => "there is no patch",
                SculptFault::WrongCount => "the curves have different numbers of arcs",
                SculptFault::NotFinite => "a control point is not finite",
            },
            Self::Conic(ConicFault::TooFew) => "an arc needs two different ends",
            Self::Conic(ConicFault::TooMany) => "an arc has at most five conditions",
            Self::Conic(ConicFault::NotPlane) => "the conditions do not lie in one plane",
            Self::Conic(ConicFault::Turns) => {
                "its points and tangents do not turn one way in the order given"
            }
            Self::Conic(ConicFault::NoArc) => {
                "no conic arc of less than half a turn meets the conditions"
            }
            Self::NoLength => "the ends coincide",
            Self::NoJoint => "FLOW or SEG names a span that the curve has not",
            Self::NoPivot => "ANGLE needs a point from which it is seen, PIVOT,point",
            Self::NoChord => "what CHORD runs along has no length",
            Self::Bspline(b) => return b.fmt(f),
            Self::Canonical => "the array of CANON is not understood",
            Self::TooDeep => "definitions are nested too deep",
        };
        f.write_str(said)
    }
}

fn spline_said(s: SplineFault, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
    match s {
        SplineFault::TooFew => f.write_str("a spline needs two points"),
        SplineFault::NoDirection(i) => {
            write!(f, "the vectors at point {} leave the curve no direction", i + 1)
        }
    }
}

/// Definitions within each other at most.
const DEPTH: usize = 64;

/// The curve of a definition.
pub fn fit_curve(d: &CurveDefinition) -> Result<SpaceCurve, FitFault> {
    curve(d, DEPTH)
}

/// The surface of a definition.
pub fn fit_surface(d: &SurfaceDefinition) -> Result<Sculptured, FitFault> {
    surface(d, DEPTH)
}

fn curve(d: &CurveDefinition, depth: usize) -> Result<SpaceCurve, FitFault> {
    let depth = depth.checked_sub(1).ok_or(FitFault::TooDeep)?;
    let mut c = match &d.shape {
        CurveShape::Conic(knots) => {
            let given: Vec<_> = knots.iter().map(condition).collect();
            let mut c = SpaceCurve::new(vec![conic_arc(&given).map_err(FitFault::Conic)?]);
            c.cross = ends_cross(knots);
            c
        }
        CurveShape::Spline { smoothing, knots } => {
            let mut points: Vec<_> = knots.iter().map(|k| point(k, smoothing)).collect();
            smooth(&mut points);
            let mut c = SpaceCurve::new(spline(&points)?);
            c.cross = ends_cross(knots);
            c
        }
        CurveShape::Stretch { ends: [a, b] } => {
            if a == b {
                return Err(FitFault::NoLength);
            }
            SpaceCurve::new(vec![CubicArc::line(*a, *b)])
        }
        CurveShape::Arc { center, axis, ends: [a, b] } => {
            let radius = (a - center).norm();
            let circle = Circle { center: *center, axis: *axis, radius };
            SpaceCurve::new(circle_between(&circle, *a, *b).ok_or(FitFault::NoLength)?)
        }
        CurveShape::Combined(curves) => {
            let parts = curves.iter().map(|c| curve(c, depth)).collect::<Result<Vec<_>, _>>()?;
            SpaceCurve::chained(&parts).ok_or(FitFault::NoLength)?
        }
        CurveShape::Canonical(e) => canon::curve(e).ok_or(FitFault::Canonical)?,
    };
    c.flow = flow_of(d, &c)?;
    Ok(match &d.map {
        Some(m) => carried(c, m),
        None => c,
    })
}

/// Flow measures lengths, and a map may change them: pivots and directions go with the curve.
fn carried(c: SpaceCurve, m: &crate::Transform) -> SpaceCurve {
    let mut moved = c.transformed(m);
    if let Some(flow) = &mut moved.flow {
        for span in &mut flow.spans {
            span.kind = match span.kind {
                FlowKind::Angle(p) => FlowKind::Angle(m.point(p)),
                FlowKind::Chord(v) => FlowKind::Chord(m.vector(v)),
                other => other,
            };
        }
    }
    moved
}

fn condition(k: &Knot) -> ConicCondition {
    ConicCondition { point: k.point, tangent: k.tangent, normal: k.normal }
}

fn ends_cross(knots: &[Knot]) -> [Option<Vec3>; 2] {
    [knots.first().and_then(|k| k.cross), knots.last().and_then(|k| k.cross)]
}

fn point(k: &Knot, all: &Smoothing) -> SplinePoint {
    SplinePoint {
        point: k.point,
        tangent: k.tangent,
        normal: k.normal,
        cross: k.cross,
        weight: k.smoothing.weight.or(all.weight),
        limit: k.smoothing.limit.or(all.limit),
    }
}

/// Joints by their numbers.
fn joints([a, b]: [f64; 2], arcs: usize) -> Result<[usize; 2], FitFault> {
    let of = |x: f64| {
        let whole = x.round();
        ((whole - x).abs() < 1e-6 && (0.0..=arcs as f64).contains(&whole))
            .then_some(super::whole(whole))
    };
    match (of(a), of(b)) {
        (Some(a), Some(b)) if a < b => Ok([a, b]),
        _ => Err(FitFault::NoJoint),
    }
}

fn flow_of(d: &CurveDefinition, c: &SpaceCurve) -> Result<Option<Flow>, FitFault> {
    if d.flow.is_empty() && d.segments.is_empty() {
        return Ok(None);
    }
    let arcs = c.arcs.len();
    let mut spans = Vec::with_capacity(d.flow.len());
    for s in &d.flow {
        let [from, to] = joints(s.range, arcs)?;
        let ends = [c.arcs[from].start(), c.arcs[to - 1].end()];
        spans.push(flow::FlowSpan { kind: law(s, ends)?, from, to });
    }
    if d.segments.is_empty() {
        return Ok(Some(Flow::by_arcs(spans, arcs)));
    }
    let mut segments = Vec::with_capacity(d.segments.len());
    for s in &d.segments {
        let [from, to] = joints(s.range, arcs)?;
        let kind = if s.by_length { flow::SegmentKind::Length } else { flow::SegmentKind::Param };
        segments.push(flow::SegmentSpan { kind, from, to });
    }
    Ok(Some(Flow { spans, segments }))
}

fn law(s: &FlowSpan, ends: [Vec3; 2]) -> Result<FlowKind, FitFault> {
    Ok(match s.law {
        FlowLaw::Parameter => FlowKind::Param,
        FlowLaw::Arc => FlowKind::Arc,
        FlowLaw::Angle => FlowKind::Angle(*s.points.first().ok_or(FitFault::NoPivot)?),
        FlowLaw::Chord => {
            let along = match (s.vector, s.points.as_slice()) {
                (Some(v), _) => v,
                (None, [a, b, ..]) => b - a,
                // From the beginning of the span to its end.
                _ => ends[1] - ends[0],
            };
            FlowKind::Chord(along.try_normalize(0.0).ok_or(FitFault::NoChord)?)
        }
    })
}

fn surface(d: &SurfaceDefinition, depth: usize) -> Result<Sculptured, FitFault> {
    let depth = depth.checked_sub(1).ok_or(FitFault::TooDeep)?;
    let one = |c: &Arc<CurveDefinition>| curve(c, depth);
    let all = |c: &[Arc<CurveDefinition>]| c.iter().map(one).collect::<Result<Vec<_>, _>>();
    let s = match &d.shape {
        SurfaceShape::Mesh { spacing, splines, .. } => {
            let rows: Vec<Vec<SplinePoint>> = splines
                .iter()
                .map(|s| s.knots.iter().map(|k| point(k, &s.smoothing)).collect())
                .collect();
            mesh(&rows, *spacing).map_err(FitFault::Mesh)?
        }
        SurfaceShape::Patches { kind, patches } => patch_list(*kind, patches)?,
        SurfaceShape::Revolved { curve, origin, axis, clockwise, angles_deg } => {
            revolve(&one(curve)?, *origin, *axis, *angles_deg, !clockwise)?
        }
        SurfaceShape::RuledBetween([a, b]) => {
            let (a, b) = (one(a)?, one(b)?);
            if a.flow.is_none() && b.flow.is_none() {
                ruled(&a, &b)?
            } else {
                loft(&[a, b], &[]).map_err(FitFault::Loft)?
            }
        }
        SurfaceShape::RuledAlong { curve, axis, reach } => swept(&one(curve)?, *axis, *reach)?,
        SurfaceShape::General { curves, cross } => {
            loft(&all(curves)?, &all(cross)?).map_err(FitFault::Loft)?
        }
        SurfaceShape::Swept { motion, curve, guide } => {
            cross_product(product(*motion), &one(curve)?, &one(guide)?)?
        }
        SurfaceShape::Combined(parts) => {
            let parts = parts.iter().map(|p| surface(p, depth)).collect::<Result<Vec<_>, _>>()?;
            Sculptured::combined(&parts)?
        }
        SurfaceShape::Canonical(e) => canon::surface(e).ok_or(FitFault::Canonical)??,
        SurfaceShape::Bspline(b) => bspline(b).map_err(FitFault::Bspline)?.0,
        SurfaceShape::Facets(all) => Sculptured::loose(all.iter().map(facet).collect())?,
    };
    Ok(match &d.map {
        Some(m) => s.transformed(m),
        None => s,
    })
}

fn product(s: Sweep) -> Product {
    match s {
        Sweep::Transl => Product::Transl,
        Sweep::Xyrot => Product::XyRot,
        Sweep::Yzrot => Product::YzRot,
        Sweep::Zxrot => Product::ZxRot,
        Sweep::Scale => Product::Scale,
    }
}

fn patch_list(
    kind: PatchKind,
    patches: &[crate::sculptured::Patch],
) -> Result<Sculptured, FitFault> {
    // PLUS or MINUS leaves parameters and normals as they are, as in SSV3, which keeps the sign and never asks for it.
    let made = patches.iter().map(|p| match kind {
        PatchKind::Pntvec => from_vectors(p.items),
        PatchKind::Polygn => from_polygon(filled(p.items)),
        PatchKind::Pntson => from_points(p.items),
    });
    Ok(Sculptured::loose(made.collect())?)
}

/// A triangle as a flat patch with one border of no length.
fn facet(t: &[Vec3; 3]) -> Patch {
    let [a, b, c] = *t;
    let zero = Vec3::zeros();
    Patch::hermite([
        [a, b, b - a, b - a],
        [c, c, zero, zero],
        [c - a, c - b, a - b, a - b],
        [c - a, c - b, a - b, a - b],
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Transform;

    fn knot(x: f64, y: f64) -> Knot {
        Knot { point: Vec3::new(x, y, 0.0), ..Knot::default() }
    }

    fn spline_of(p: &[[f64; 2]]) -> CurveDefinition {
        let knots = p.iter().map(|p| knot(p[0], p[1])).collect();
        CurveDefinition::plain(CurveShape::Spline { smoothing: Smoothing::default(), knots })
    }

    #[test]
    fn flow_goes_with_the_curve() {
        let mut d = spline_of(&[[0.0, 0.0], [1.0, 1.0], [3.0, 1.0]]);
        let span = |law, v| FlowSpan {
            law,
            range: [0.0, 2.0],
            tolerance: None,
            points: Vec::new(),
            vector: v,
        };
        d.flow = vec![span(FlowLaw::Chord, Some(Vec3::x() * 7.0))];
        let c = fit_curve(&d.then(&Transform::rotation(Vec3::z(), 90.0))).unwrap();
        assert_eq!(c.segments(), 2);
        assert!((c.at_flow(1.25).point.y - 1.5).abs() < 1e-12);
        // Without a vector CHORD runs from the beginning of the span to its end.
        let way = |d: &CurveDefinition| fit_curve(d).unwrap().at_flow(1.25).point;
        d.flow = vec![span(FlowLaw::Chord, None)];
        let open = way(&d);
        d.flow = vec![span(FlowLaw::Chord, Some(Vec3::new(3.0, 1.0, 0.0)))];
        assert_eq!(open, way(&d));
        d.flow = vec![span(FlowLaw::Angle, None)];
        assert_eq!(fit_curve(&d), Err(FitFault::NoPivot));
        d.flow[0].range = [0.0, 3.0];
        assert_eq!(fit_curve(&d), Err(FitFault::NoJoint));
    }

    /// SPTON and SPOLY of TEST02: eight zero items inside, rulings between the sides. Areas as printed,
    /// which SSV3 sums over a coarse grid.
    #[test]
    fn items_left_open_are_straight() {
        let z = Vec3::zeros();
        let row = |y: f64| {
            [[0.0, 0.0], [1.0, 1.0], [2.0, 1.0], [3.0, 0.0]].map(|p| Vec3::new(p[0], y, p[1]))
        };
        let (a, b) = (row(0.0), row(3.0));
        let mut items = [z; 16];
        items[..4].copy_from_slice(&a);
        items[12..].copy_from_slice(&b);
        let patch = crate::sculptured::Patch { minus: false, items };
        for (kind, area) in [(PatchKind::Pntson, 25.22 / 2.0), (PatchKind::Polygn, 21.73 / 2.0)] {
            let s = patch_list(kind, core::slice::from_ref(&patch)).unwrap();
            // SSV3 sums at the middle and the ends.
            let t = [0.0, 0.5, 1.0];
            let size = |u: f64| {
                let d = s.at(u, 0.5);
                d.u.cross(&d.v).norm()
            };
            let sum = 0.25 * size(t[0]) + 0.5 * size(t[1]) + 0.25 * size(t[2]);
            assert!((sum - area).abs() < 0.005, "{kind:?} {sum} {area}");
        }
        let minus = crate::sculptured::Patch { minus: true, items };
        let of = |p| patch_list(PatchKind::Pntson, &[p]).unwrap().at(0.4, 0.6);
        assert_eq!(of(minus).normal(), of(patch).normal());
    }
}
