//! SCURV: a chain of arcs, with flow if it has one.

use serde::{Deserialize, Serialize};

use super::arc::{ArcPoint, CubicArc};
use super::flow::Flow;
use super::whole;
use crate::{Transform, Vec3};

/// A curve in space.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SpaceCurve {
    /// Its arcs in order, never none.
    pub arcs: Vec<CubicArc>,
    /// FLOW and SEG, where they were given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flow: Option<Flow>,
    /// Direction across the curve at its ends (CRSSPL), where it was given.
    #[serde(default)]
    pub cross: [Option<Vec3>; 2],
}

/// How a parameter of a curve is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveAt {
    /// Along the whole curve, or along the arc of the given number, counted from 1.
    Param(Option<usize>),
    /// Along the segments of the flow, or along the segment of the given number.
    Flow(Option<usize>),
}

impl SpaceCurve {
    /// A curve without flow.
    pub fn new(arcs: Vec<CubicArc>) -> Self {
        Self { arcs, flow: None, cross: [None; 2] }
    }

    /// How far the parameter goes: the number of arcs.
    pub fn span(&self) -> f64 {
        self.arcs.len() as f64
    }

    /// How far the parameter of the flow goes: the number of segments, without flow that of arcs.
    pub fn flow_span(&self) -> f64 {
        self.segments() as f64
    }

    /// The number of segments of the flow, without flow that of arcs.
    pub fn segments(&self) -> usize {
        self.flow.as_ref().map_or(self.arcs.len(), |f| f.segments.len())
    }

    /// Point and derivatives at the parameter `t`; before the beginning and behind the end the arcs go on.
    pub fn at(&self, t: f64) -> ArcPoint {
        let last = self.arcs.len() - 1;
        let i = whole(t).min(last);
        self.arcs[i].at(t - i as f64)
    }

    /// Point and derivatives at the parameter `s` of the flow; without flow at the parameter `s`.
    pub fn at_flow(&self, s: f64) -> ArcPoint {
        let Some(flow) = &self.flow else { return self.at(s) };
        let (t, rate, rate2) = flow.parameter(self, s);
        self.at(t).rated(rate, rate2)
    }

    /// Point and derivatives as a statement asks for them; beyond its ends the curve, its arc or its segment goes straight on. `None` for an arc or
    /// segment that is not there.
    pub fn place(&self, t: f64, how: CurveAt) -> Option<ArcPoint> {
        let straight = |span: f64, at: &dyn Fn(f64) -> ArcPoint| {
            let end = at(t.clamp(0.0, span));
            let over = t - t.clamp(0.0, span);
            if over == 0.0 {
                return end;
            }
            ArcPoint { point: end.point + end.first * over, second: Vec3::zeros(), ..end }
        };
        Some(match how {
            CurveAt::Param(None) => straight(self.span(), &|t| self.at(t)),
            CurveAt::Param(Some(n)) => {
                let arc = self.arcs.get(n.checked_sub(1)?)?;
                straight(1.0, &|t| arc.at(t))
            }
            CurveAt::Flow(None) => straight(self.flow_span(), &|s| self.at_flow(s)),
            CurveAt::Flow(Some(n)) => {
                let i = n.checked_sub(1).filter(|i| *i < self.segments())?;
                straight(1.0, &|s| self.at_flow(i as f64 + s))
            }
        })
    }

    /// Where the curve begins.
    pub fn start(&self) -> Vec3 {
        self.arcs[0].start()
    }

    /// Where it ends.
    pub fn end(&self) -> Vec3 {
        self.arcs[self.arcs.len() - 1].end()
    }

    /// Its length.
    pub fn length(&self) -> f64 {
        self.arcs.iter().map(|a| a.length(1.0)).sum()
    }

    /// The curve carried by `m`, its flow with it.
    #[must_use]
    pub fn transformed(&self, m: &Transform) -> Self {
        Self {
            arcs: self.arcs.iter().map(|a| a.transformed(m)).collect(),
            flow: self.flow.clone(),
            cross: self.cross.map(|c| c.map(|v| m.vector(v))),
        }
    }

    /// Number of arcs, then for each its four control points (w x, w y, w z, w).
    pub fn canonical(&self) -> Vec<f64> {
        let mut e = vec![self.span()];
        e.extend(self.arcs.iter().flat_map(|a| a.b.iter().flat_map(|h| h.iter().copied())));
        e
    }

    /// One curve of several, end to beginning. A curve is turned round where its end is nearer to the
    /// chain than its beginning; its flow is dropped. `None` for none.
    pub fn chained(curves: &[Self]) -> Option<Self> {
        let mut arcs: Vec<CubicArc> = Vec::new();
        for (i, c) in curves.iter().enumerate() {
            let turn = match arcs.last() {
                Some(last) => (c.end() - last.end()).norm() < (c.start() - last.end()).norm() * 0.5,
                None => curves.get(i + 1).is_some_and(|next| {
                    let to = |p: Vec3| (next.start() - p).norm().min((next.end() - p).norm());
                    to(c.start()) < to(c.end()) * 0.5
                }),
            };
            if turn {
                arcs.extend(c.arcs.iter().rev().map(CubicArc::reversed));
            } else {
                arcs.extend(c.arcs.iter().copied());
            }
        }
        let cross = [curves.first()?.cross[0], curves.last()?.cross[1]];
        (!arcs.is_empty()).then_some(Self { arcs, flow: None, cross })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_turns_curves_round() {
        let line = |a: [f64; 3], b: [f64; 3]| {
            SpaceCurve::new(vec![CubicArc::line(Vec3::from(a), Vec3::from(b))])
        };
        let c = SpaceCurve::chained(&[
            line([0.0; 3], [1.0, 0.0, 0.0]),
            line([3.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
        ])
        .unwrap();
        assert!((c.at(1.5).point - Vec3::new(2.0, 0.5, 0.0)).norm() < 1e-15);
        assert_eq!(c.place(0.5, CurveAt::Param(Some(2))).unwrap().point, c.at(1.5).point);
        let beyond = c.place(2.5, CurveAt::Param(None)).unwrap();
        assert_eq!(beyond.point, c.end() + c.at(2.0).first * 0.5);
        assert_eq!(
            c.place(-0.5, CurveAt::Flow(Some(2))).unwrap().point,
            c.at(1.0).point - c.at(1.0).first * 0.5
        );
        assert!(c.place(0.5, CurveAt::Flow(Some(3))).is_none());
        assert!(c.place(0.5, CurveAt::Param(Some(0))).is_none());
    }
}
