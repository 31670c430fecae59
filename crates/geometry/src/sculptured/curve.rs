//! SCURV: what a sculptured curve is made of, and how FLOW and SEG divide it.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::numbers::{push, push_curves, push_knots, push_map, push_smoothing};
use super::{Extent, Knot, Smoothing};
use crate::{Transform, Vec3};

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
