//! Edges of faces: the part of a curve between two vertices, or all of it.

use std::collections::BTreeMap;
use std::rc::Rc;

use aptc_geometry::{Vec3, trig};
use ruststep::ast::Parameter;

use super::curves::{Shape, flag, point, single};
use super::{Entities, reference};
use crate::Limits;
use crate::border::following;
use crate::curve::Curve;
use crate::follow::Work;

/// Places of an edge along a line, and along an ellipse.
const OF_LINE: usize = 16;
const OF_ELLIPSE: usize = 32;
/// How far a vertex may be off its curve, as a share of its size.
const OFF: f64 = 1e-3;

/// The curves of a file, each read once, and the work that is left for the borders of its faces.
pub(super) struct Curves<'x> {
    pub(super) entities: &'x Entities<'x>,
    limits: &'x Limits,
    known: BTreeMap<u64, Option<Rc<Shape>>>,
    pub(super) work: Work,
}

/// A part of a curve with the direction in which a border runs along it.
pub(crate) struct Edge {
    shape: Rc<Shape>,
    ends: [Vec3; 2],
    /// Parameters that rise; of a closed curve they may go on into its next round.
    range: [f64; 2],
    against: bool,
}

impl<'x> Curves<'x> {
    pub(super) fn new(entities: &'x Entities<'x>, limits: &'x Limits) -> Self {
        Self { entities, limits, known: BTreeMap::new(), work: Work::new() }
    }

    fn shape(&mut self, id: u64) -> Option<Rc<Shape>> {
        let (entities, limits) = (self.entities, self.limits);
        let read = || Shape::of(entities, id, limits).map(Rc::new);
        self.known.entry(id).or_insert_with(read).clone()
    }

    /// An oriented edge; `None` where its curve is not read or does not lead from vertex to vertex.
    pub(super) fn edge(&mut self, p: &Parameter) -> Option<Edge> {
        let oriented = single(self.entities, reference(p)?, "ORIENTED_EDGE")?;
        let curve = single(self.entities, reference(oriented.get(3)?)?, "EDGE_CURVE")?;
        let vertex = |k: usize| {
            let v = single(self.entities, reference(curve.get(k)?)?, "VERTEX_POINT")?;
            point(self.entities, v.get(1)?)
        };
        let ends = [vertex(1)?, vertex(2)?];
        let (along, forward) = (flag(curve.get(4)?)?, flag(oriented.get(4)?)?);
        let closed = reference(curve.get(1)?) == reference(curve.get(2)?) || ends[0] == ends[1];
        let shape = self.shape(reference(curve.get(3)?)?)?;
        if let Shape::Spline(curve) = &*shape {
            self.work.take(4 * curve.spans() as u64 + 1000)?;
        }
        let ends = if along { ends } else { [ends[1], ends[0]] };
        let range = range(&shape, ends, closed)?;
        Some(Edge { shape, ends, range, against: along != forward })
    }
}

/// The parameters of a curve from one place of it to another in its sense; all round where both are the same.
fn range(shape: &Shape, ends: [Vec3; 2], closed: bool) -> Option<[f64; 2]> {
    match shape {
        Shape::Line { along, .. } => {
            // Vertices say where it runs; that is along the line.
            let by = ends[1] - ends[0];
            (by.cross(along).norm() <= OFF * by.norm() * along.norm()).then_some([0.0, 1.0])
        }
        Shape::Ellipse { frame, half } => {
            let angle = |p: Vec3| {
                let own = frame.own(p);
                let a = trig::atan2(own.y / half[1], own.x / half[0]);
                let (s, c) = trig::sin_cos(a);
                let off = own - Vec3::new(half[0] * c, half[1] * s, 0.0);
                (off.norm() <= OFF * half[0].max(half[1])).then_some(a)
            };
            let (a, b) = (angle(ends[0])?, angle(ends[1])?);
            let round = core::f64::consts::TAU;
            let by = if b > a { b - a } else { b - a + round };
            Some([a, a + if closed { round } else { by }])
        }
        Shape::Spline(curve) => {
            let [from, to] = curve.range;
            let place = |p: Vec3| {
                let t = curve.nearest(|q| q - p);
                ((curve.at(t) - p).norm() <= OFF * curve.extent()).then_some(t)
            };
            let (a, b) = (place(ends[0])?, place(ends[1])?);
            let Some(period) = curve.period() else {
                // Against the sense of an open curve there is no way.
                return (!closed && a < b).then_some([a, b]);
            };
            let a = if a >= to { from } else { a };
            Some([a, if closed { a + period } else { following(a, b, period) }])
        }
    }
}

impl Edge {
    /// All of a curve, or all of it the other way.
    pub(crate) fn whole(curve: Curve, forward: bool) -> Self {
        let range = curve.range;
        let ends = range.map(|t| curve.at(t));
        Self { shape: Rc::new(Shape::Spline(curve)), ends, range, against: !forward }
    }

    /// How far places of its curve are apart, about.
    pub(crate) fn extent(&self) -> f64 {
        match &*self.shape {
            Shape::Line { .. } => (self.ends[1] - self.ends[0]).norm(),
            Shape::Ellipse { half, .. } => half[0].max(half[1]),
            Shape::Spline(curve) => curve.extent(),
        }
    }

    /// Its first and last place.
    pub(crate) fn ends(&self) -> [Vec3; 2] {
        let [a, b] = self.range.map(|t| self.at(t));
        if self.against { [b, a] } else { [a, b] }
    }

    /// Parameters from its beginning to its end, with all where it has corners.
    pub(crate) fn looks(&self) -> Vec<f64> {
        let even = |n: usize| {
            let [a, b] = self.range;
            (0..=n).map(|k| a + (b - a) * (k as f64 / n as f64)).collect()
        };
        let mut all: Vec<f64> = match &*self.shape {
            Shape::Line { .. } => even(OF_LINE),
            Shape::Ellipse { .. } => even(OF_ELLIPSE),
            Shape::Spline(curve) => curve.along(self.range),
        };
        if self.against {
            all.reverse();
        }
        all
    }

    pub(crate) fn at(&self, t: f64) -> Vec3 {
        match &*self.shape {
            Shape::Line { .. } => self.ends[0] + (self.ends[1] - self.ends[0]) * t,
            Shape::Ellipse { frame, half } => {
                let (s, c) = trig::sin_cos(t);
                frame.origin + frame.x * (half[0] * c) + frame.y * (half[1] * s)
            }
            Shape::Spline(curve) => {
                let [from, to] = curve.range;
                if t > to { curve.around(t, to - from) } else { curve.at(t) }
            }
        }
    }
}
