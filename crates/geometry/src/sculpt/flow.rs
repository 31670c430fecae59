//! FLOW and SEG: another measure along a curve.
//!
//! FLOW gives each arc a measure (its length, the parameter, an angle seen from a pivot, the distance
//! along a chord); SEG makes segments of arcs, each with a parameter from 0 to 1 that runs evenly with
//! the measure over all its arcs (LENGTH), or gives each arc the same share and runs evenly with the measure within it (PARAM).

use serde::{Deserialize, Serialize};

use super::curve::SpaceCurve;
use super::whole;
use crate::{Vec3, trig};

/// The measure of an arc.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum FlowKind {
    /// PARAM.
    Param,
    /// ARC: the length.
    Arc,
    /// ANGLE: the angle swept about a pivot, radians.
    Angle(Vec3),
    /// CHORD: the distance along a direction.
    Chord(Vec3),
}

/// FLOW for the arcs from one joint to another.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlowSpan {
    /// The measure.
    pub kind: FlowKind,
    /// Joint where it begins, from 0.
    pub from: usize,
    /// Joint where it ends.
    pub to: usize,
}

/// How the parameter of a segment runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum SegmentKind {
    /// Evenly with the measure of the flow.
    Length,
    /// The same share for each arc, evenly with the measure within it.
    Param,
}

/// SEG: arcs from one joint to another as one segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SegmentSpan {
    /// How its parameter runs.
    pub kind: SegmentKind,
    /// First joint.
    pub from: usize,
    /// Last joint.
    pub to: usize,
}

/// The flow of a curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Flow {
    /// Measures; arcs without one are measured by their length.
    pub spans: Vec<FlowSpan>,
    /// Segments in order.
    pub segments: Vec<SegmentSpan>,
}

/// Pieces into which an arc is cut to tabulate its measure; between them it is solved for.
const PIECES: usize = 32;

impl Flow {
    /// One segment an arc, evenly in the length: what FLOW without SEG gives.
    pub fn by_arcs(spans: Vec<FlowSpan>, arcs: usize) -> Self {
        let one = |i| SegmentSpan { kind: SegmentKind::Length, from: i, to: i + 1 };
        Self { spans, segments: (0..arcs).map(one).collect() }
    }

    /// The parameter of the curve at `s` of the flow, and its first and second derivative by `s`.
    pub fn parameter(&self, curve: &SpaceCurve, s: f64) -> (f64, f64, f64) {
        let last = self.segments.len().saturating_sub(1);
        let i = whole(s).min(last);
        let Some(seg) = self.segments.get(i) else { return (s, 1.0, 0.0) };
        let f = s - i as f64;
        let (from, to) = (seg.from as f64, seg.to as f64);
        let whole: Vec<f64> = (seg.from..seg.to).map(|a| self.measure(curve, a, 1.0)).collect();
        let mut total: f64 = whole.iter().sum();
        let mut left = f * total;
        let mut arc = seg.from;
        if seg.kind == SegmentKind::Param {
            let share = f * (to - from);
            let k = super::whole(share).min(whole.len() - 1);
            arc += k;
            total = whole[k] * (to - from);
            left = (share - k as f64) * whole[k];
        } else {
            for (k, w) in whole.iter().enumerate() {
                arc = seg.from + k;
                if left <= *w || k + 1 == whole.len() {
                    break;
                }
                left -= w;
            }
        }
        if total <= 0.0 {
            return (from + (to - from) * f, to - from, 0.0);
        }
        let t = self.solve(curve, arc, left, whole[arc - seg.from]);
        let h = 1e-5;
        let rate = |t: f64| self.rate(curve, arc, t);
        let m = rate(t);
        if m.abs() <= 1e-300 {
            return (arc as f64 + t, 0.0, 0.0);
        }
        let slope = (rate(t + h) - rate(t - h)) / (2.0 * h);
        let first = total / m;
        (arc as f64 + t, first, -first * first * slope / m)
    }

    fn kind(&self, arc: usize) -> FlowKind {
        let found = self.spans.iter().find(|s| s.from <= arc && arc < s.to);
        found.map_or(FlowKind::Arc, |s| s.kind)
    }

    /// Measure of the arc from its beginning to `t`.
    fn measure(&self, curve: &SpaceCurve, arc: usize, t: f64) -> f64 {
        let a = &curve.arcs[arc];
        match self.kind(arc) {
            FlowKind::Param => t,
            FlowKind::Arc => a.length(t),
            FlowKind::Chord(d) => (a.at(t).point - a.start()).dot(&d).abs(),
            FlowKind::Angle(pivot) => trig::angle_between(a.start() - pivot, a.at(t).point - pivot),
        }
    }

    /// Derivative of the measure by the parameter of the arc.
    fn rate(&self, curve: &SpaceCurve, arc: usize, t: f64) -> f64 {
        let p = curve.arcs[arc].at(t);
        match self.kind(arc) {
            FlowKind::Param => 1.0,
            FlowKind::Arc => p.first.norm(),
            FlowKind::Chord(d) => p.first.dot(&d).abs(),
            FlowKind::Angle(pivot) => {
                // In the plane of pivot, beginning and place.
                let (v, w) = (curve.arcs[arc].start() - pivot, p.point - pivot);
                let r = w.norm();
                let n = v.cross(&w);
                let e = n.cross(&w).try_normalize(1e-12 * v.norm() * r * r);
                match e {
                    Some(e) if r > 0.0 => p.first.dot(&e) / r,
                    _ if r > 0.0 => w.cross(&p.first).norm() / (r * r),
                    _ => 0.0,
                }
            }
        }
    }

    /// Where the measure of the arc is `m`: bisection of a table, then Newton kept within its interval.
    fn solve(&self, curve: &SpaceCurve, arc: usize, m: f64, whole: f64) -> f64 {
        // Outside the arc the measure goes on in a straight line.
        if m <= 0.0 {
            let r = self.rate(curve, arc, 0.0);
            return if r > 0.0 { m / r } else { 0.0 };
        }
        if m >= whole {
            let r = self.rate(curve, arc, 1.0);
            return 1.0 + if r > 0.0 { (m - whole) / r } else { 0.0 };
        }
        let (mut lo, mut hi) = (0.0, 1.0);
        let mut t = m / whole;
        for _ in 0..2 * PIECES {
            let e = self.measure(curve, arc, t) - m;
            if e > 0.0 {
                hi = t;
            } else {
                lo = t;
            }
            let r = self.rate(curve, arc, t);
            let step = if r > 0.0 { -e / r } else { 1.0 };
            if step.abs() <= 1e-15 {
                break;
            }
            let next = t + step;
            let next = if next > lo && next < hi { next } else { 0.5 * (lo + hi) };
            t = next;
        }
        t
    }
}

#[cfg(test)]
mod tests {
    use super::super::spline::{SplinePoint, spline};
    use super::*;

    fn curve() -> SpaceCurve {
        let p = [[0.0, 3.0, 0.0], [7.0, 5.0, 1.2], [12.0, 6.0, 0.0]];
        SpaceCurve::new(spline(&p.map(|p| SplinePoint::plain(Vec3::from(p)))).unwrap())
    }

    fn flowing(kind: FlowKind) -> SpaceCurve {
        let mut c = curve();
        c.flow = Some(Flow {
            spans: vec![FlowSpan { kind, from: 0, to: 2 }],
            segments: vec![SegmentSpan { kind: SegmentKind::Length, from: 0, to: 2 }],
        });
        c
    }

    /// Curve SCF of TEST39: 12.7034 long; its middle near the printed one (SSV3 tabulates the length with
    /// tolerance factor 0.005, and is 0.0024 off).
    #[test]
    fn flow_by_length() {
        let c = flowing(FlowKind::Arc);
        assert!((c.length() - 12.7034).abs() < 5e-4);
        let p = c.at_flow(0.5);
        assert!(
            (p.point - Vec3::new(5.938_328, 4.741_788, 1.234_590)).norm() < 3e-3,
            "{}",
            p.point
        );
        assert!((p.first.norm() - c.length()).abs() < 1e-10);
        // Even: a quarter of the way is a quarter of the length.
        let (t, ..) = c.flow.as_ref().unwrap().parameter(&c, 0.25);
        assert!((c.arcs[0].length(t) - c.length() / 4.0).abs() < 1e-12);
    }

    /// SEG,PARAM with FLOW,ARC: nine tenths of the length of the first of three arcs, as SSV3 tabulates it.
    #[test]
    fn a_segment_by_parameter_runs_evenly_in_each_arc() {
        let p = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.2], [2.1, 0.1, 0.3], [3.0, 1.0, 0.1]];
        let mut c = SpaceCurve::new(spline(&p.map(|p| SplinePoint::plain(Vec3::from(p)))).unwrap());
        c.flow = Some(Flow {
            spans: vec![FlowSpan { kind: FlowKind::Arc, from: 0, to: 3 }],
            segments: vec![SegmentSpan { kind: SegmentKind::Param, from: 0, to: 3 }],
        });
        let t = c.flow.as_ref().unwrap().parameter(&c, 0.3).0;
        assert!((c.arcs[0].length(t) - 0.9 * c.arcs[0].length(1.0)).abs() < 1e-12);
        for (s, q) in
            [(0.3, [0.853_708, 0.990_817, 0.173_692]), (0.8, [2.552_557, 0.346_027, 0.229_673])]
        {
            assert!((c.at_flow(s).point - Vec3::from(q)).norm() < 2e-3, "{s}");
        }
        let h = 1e-5;
        let d = (c.at_flow(0.8 + h).point - c.at_flow(0.8 - h).point) / (2.0 * h);
        assert!((d - c.at_flow(0.8).first).norm() < 1e-6);
    }

    #[test]
    fn derivatives_of_flows_by_differences() {
        for kind in
            [FlowKind::Arc, FlowKind::Chord(Vec3::x()), FlowKind::Angle(Vec3::new(5.0, -9.0, 0.0))]
        {
            let c = flowing(kind);
            for s in [0.2, 0.45, 0.8] {
                let (p, h) = (c.at_flow(s), 1e-4);
                let (f, b) = (c.at_flow(s + h), c.at_flow(s - h));
                assert!(
                    ((f.point - b.point) / (2.0 * h) - p.first).norm() < 1e-4,
                    "{kind:?} {s} {} {}",
                    (f.point - b.point) / (2.0 * h),
                    p.first
                );
                assert!(((f.first - b.first) / (2.0 * h) - p.second).norm() < 1e-3, "{kind:?} {s}");
            }
        }
    }
}
