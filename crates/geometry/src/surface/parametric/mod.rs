//! Surfaces given by two parameters: RLDSRF, POLCON and SSURF.
//!
//! Beyond their ends they go on straight, as a TABCYL does, so that a cutter can come to an end.

mod cells;
mod creases;
#[cfg(test)]
mod dips_tests;
mod edges;
mod jet;
mod nearest;
mod part;
mod polyconic;
mod rail;
mod raised;
mod ray;
mod ruled;
mod samples;
mod sculptured;
#[cfg(test)]
mod tests;
mod waves;

use std::sync::Arc;

use crate::surface::{Foot, Shape, Spot, frame_about};
use crate::{Place, Polyconic, Reason, RuledSurface, Tool, Vec3};
pub use cells::{Disk, Facing, Next, Touching};
pub use edges::{Edge, OnEdge};
use jet::{Jet, across, by_sides};
pub use part::Part;
use part::Strips;
use polyconic::Sections;
use ruled::Rulings;
use samples::{Samples, halfway, steps};
use sculptured::Spans;
pub use sculptured::{Continued, continued, continued_of};
use waves::Planes;
pub use waves::Sample;

/// Bound of one search; Newton's method takes some six steps.
const MAX_STEPS: usize = 60;
/// Square of the sine between a normal and that of a face which does not have it.
const EDGE: f64 = 1e-10;
/// Samples along each side of a sculptured surface that tell how large its numbers are.
const SHARES: u32 = 24;

/// A ruled surface or a polyconic prepared for evaluation. Its positive side is that of the cross product
/// of the derivatives along and across: along the first rail and along the ruling, along the polyconic and
/// along its section.
#[derive(Clone, Debug)]
pub struct ParametricSurface {
    patch: Patch,
    samples: Samples,
    /// Of a smooth ruled surface how it bends between its samples.
    strips: Option<Strips>,
    /// Of a ruled surface whether a curve bends to both sides.
    waves: bool,
    /// Of a polyconic its sampled sections.
    planes: Option<Planes>,
    extent: f64,
    /// How far along its normals the working surface lies from the patch: the thickness of a polyconic.
    rise: f64,
}

#[derive(Clone, Debug)]
enum Patch {
    Ruled(Box<Rulings>),
    Polyconic(Sections),
    Sculptured(Box<Spans>),
}

/// A place of the surface.
#[derive(Clone, Copy, Debug)]
struct Placed {
    u: f64,
    v: f64,
    jet: Jet,
}

/// How far each parameter goes.
#[derive(Clone, Copy, Debug)]
struct Domain {
    u: [f64; 2],
    v: [f64; 2],
}

impl ParametricSurface {
    /// A ruled surface; `None` when one of its curves is not found over the whole base line.
    pub fn ruled(form: &RuledSurface) -> Option<Self> {
        let rulings = Rulings::new(form)?;
        let us = halfway(rulings.domain().u, rulings.pieces());
        Self::prepared(
            Patch::Ruled(Box::new(rulings)),
            us,
            vec![-10.0, -3.0, -1.0, 0.0, 1.0, 2.0, 4.0, 11.0],
        )
    }

    /// The working surface of a polyconic; `None` when its sections are no conics somewhere.
    pub fn polyconic(form: &Arc<Polyconic>) -> Option<Self> {
        let sections = Sections::new(form)?;
        let us = halfway(sections.domain().u, 24);
        Self::prepared(Patch::Polyconic(sections), us, steps(12))
    }

    /// A sculptured surface with its straight continuation; `None` when it cannot be fitted.
    pub fn sculptured(form: &crate::sculptured::SurfaceDefinition) -> Option<Self> {
        Some(Self::of_spans(Spans::new(form)?))
    }

    /// The same of a surface that is fitted; its parameters are shares of that one's spans.
    pub fn of_sculptured(surface: &crate::Sculptured) -> Option<Self> {
        Some(Self::of_spans(Spans::of_surface(surface.clone())?))
    }

    /// A sculptured surface is looked at by its cells, and keeps no samples.
    fn of_spans(spans: Spans) -> Self {
        let share = |i: u32| f64::from(i) / f64::from(SHARES);
        let points = (0..=SHARES).flat_map(|i| (0..=SHARES).map(move |j| [share(i), share(j)]));
        let extent = points.map(|[u, v]| spans.jet(u, v).s.norm()).fold(0.0, f64::max);
        let patch = Patch::Sculptured(Box::new(spans));
        let samples = Samples::default();
        Self { patch, samples, strips: None, waves: false, planes: None, extent, rise: 0.0 }
    }

    /// A ruled surface or a polyconic with samples at the parameters `us` and `vs` and at the ends across.
    fn prepared(patch: Patch, us: Vec<f64>, vs: Vec<f64>) -> Option<Self> {
        let samples = Samples::new(&patch, us, vs)?;
        let (strips, waves) = match &patch {
            Patch::Ruled(rulings) => (Strips::new(rulings), rulings.waves()),
            _ => (None, false),
        };
        let rise = match &patch {
            Patch::Polyconic(sections) => sections.rise(),
            _ => 0.0,
        };
        let extent = samples.extent() + rise.abs();
        let new = Self { patch, samples, strips, waves, planes: None, extent, rise };
        Some(Self { planes: Planes::new(&new), ..new })
    }

    /// Greatest distance of its points from the origin, between its ends.
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// The direction of the ruling through the point nearest to `p`, away from the first curve. A sculptured
    /// surface that is straight in neither direction is followed across its splines, as APT4 does.
    pub fn ruling(&self, p: Vec3) -> Option<Vec3> {
        let along = match &self.patch {
            Patch::Ruled(_) => false,
            Patch::Sculptured(s) => s.ruled_along(),
            Patch::Polyconic(_) => return None,
        };
        let jet = self.nearest(p)?.jet;
        (if along { jet.su } else { jet.sv }).try_normalize(0.0)
    }

    /// The direction of the ruling of a ruled surface through the point nearest to `p`, and how it turns with `p`: by the first
    /// vector times the product with the second. `None` at the border and where that point is not one of a crest alone.
    pub fn turning_ruling(&self, p: Vec3) -> Option<(Vec3, [Vec3; 2])> {
        let Patch::Ruled(_) = &self.patch else { return None };
        let Placed { u, v, jet } = self.nearest(p)?;
        if self.patch.domain().border(u, v) {
            return None;
        }
        let w = jet.s - p;
        let (e, g) = (jet.su.norm_squared(), jet.sv.norm_squared());
        let (huu, huv) = (e + w.dot(&jet.suu), jet.su.dot(&jet.sv) + w.dot(&jet.suv));
        let det = huu * g - huv * huv;
        let length = g.sqrt();
        let along = jet.sv / length;
        let turn = (jet.suv - along * along.dot(&jet.suv)) / length;
        let way = (jet.su * g - jet.sv * huv) / det;
        (det > 1e-6 * e * g).then_some((along, [turn, way]))
    }

    /// Unit normal at the nearest point.
    pub fn normal(&self, p: Vec3) -> Result<Vec3, Reason> {
        let foot = self.foot(p);
        if foot.shape.k[0].is_infinite() {
            return Err(Reason::Degenerate(Place::Singular));
        }
        Ok(foot.normal)
    }

    /// Curvature at a point of the surface that is touched along the unit normal `n`, on edges and tips any between their sides'.
    pub fn shape_at(&self, spot: Spot, n: Vec3) -> Shape {
        let Some([u, v]) = spot.at else { return self.foot(spot.point).shape };
        let jet = self.patch.jet(u, v);
        let normal = self.normal_at(u, v, &jet);
        if let Patch::Sculptured(spans) = &self.patch
            && (n - normal).norm_squared() > EDGE
            && let Some(shape) = spans.edges().iter().find_map(|e| e.shape_at(spans, [u, v], n))
        {
            return shape;
        }
        self.bend(&jet, normal)
    }

    /// Joints of the patches of a sculptured surface at which its normal jumps, and tips.
    pub fn edges(&self) -> &[Edge] {
        match &self.patch {
            Patch::Sculptured(spans) => spans.edges(),
            _ => &[],
        }
    }

    /// The place at the share `t` of an edge; `None` of a surface that has none.
    pub fn on_edge(&self, edge: &Edge, t: f64) -> Option<OnEdge> {
        let Patch::Sculptured(spans) = &self.patch else { return None };
        Some(edge.at(spans, t))
    }

    /// The point there and the derivative along the edge alone.
    pub fn line_on_edge(&self, edge: &Edge, t: f64) -> Option<[Vec3; 2]> {
        let Patch::Sculptured(spans) = &self.patch else { return None };
        Some(edge.line(spans, t))
    }

    /// Do all unit directions from there into the surface?
    pub fn inwards_of(&self, edge: &Edge, t: f64, does: impl Fn(Vec3) -> bool) -> bool {
        let Patch::Sculptured(spans) = &self.patch else { return false };
        edge.all_inwards(spans, t, does)
    }

    /// Does the surface end at the place with these parameters?
    pub(crate) fn ends_at(&self, [u, v]: [f64; 2]) -> bool {
        match &self.patch {
            Patch::Sculptured(spans) => spans.ends_at(u, v),
            patch => patch.domain().border(u, v),
        }
    }

    /// The nearest point. Beyond an end the normal points from or to the given point.
    pub fn foot(&self, p: Vec3) -> Foot {
        let place = self.nearest(p).unwrap_or_else(|| Placed::new(&self.patch, 0.5, 0.5));
        self.foot_at(p, &place)
    }

    /// A sculptured surface without its straight continuation; `None` of others, and of one that has none.
    pub fn without_continuation(&self) -> Option<Arc<Self>> {
        let Patch::Sculptured(spans) = &self.patch else { return None };
        spans.without_continuation().cloned()
    }

    /// On which side of a sculptured surface itself a point lies, +1 or -1, whatever its straight continuation does; `None` of others,
    /// and beside a border where a point lies but little above or below.
    pub fn side_of_itself(&self, p: Vec3) -> Option<f64> {
        /// Sine of the direction to the point over the tangent plane at a border, or one square to the mean normal, from which on it
        /// is above or below.
        const CLEAR: f64 = 0.3;
        /// Length of the mean of the normals of a surface that bends too much to have an upper side.
        const BENT: f64 = 0.5;
        let Patch::Sculptured(spans) = &self.patch else { return None };
        let own = match spans.without_continuation() {
            Some(own) => own,
            // It is one without already, or one that closes.
            None if spans.is_open() => self,
            None => return None,
        };
        let foot = own.foot(p);
        let at = foot.at?;
        if !own.ends_at(at) {
            return (foot.distance != 0.0).then(|| foot.distance.signum());
        }
        let away = (p - foot.point).try_normalize(0.0)?;
        let mean = spans.mean_normal();
        let mean = (mean.norm() > BENT).then(|| mean.normalize());
        let ups = [spans.own_normal(at), mean].map(|n| n.map(|n| n.dot(&away)));
        ups.into_iter().flatten().find(|up| up.abs() > CLEAR).map(f64::signum)
    }

    /// The foot into which the place with the parameters `at` runs downhill.
    pub fn foot_from(&self, p: Vec3, at: [f64; 2]) -> Foot {
        self.foot_at(p, &self.descend_free(p, at).1)
    }

    /// The foot of the place with the parameters `at`.
    pub fn place(&self, at: [f64; 2]) -> Foot {
        self.place_with_sides(at).0
    }

    /// The point alone.
    pub fn point(&self, [u, v]: [f64; 2]) -> Vec3 {
        self.working(&Placed::new(&self.patch, u, v)).0
    }

    /// The place with the parameters `at`, with the derivatives by both of them.
    #[inline]
    pub fn place_with_sides(&self, [u, v]: [f64; 2]) -> (Foot, [Vec3; 2]) {
        self.foot_on(&Placed::new(&self.patch, u, v))
    }

    /// A place as the foot of itself, with the derivatives by both parameters.
    fn foot_on(&self, place: &Placed) -> (Foot, [Vec3; 2]) {
        let Placed { u, v, jet } = place;
        if self.rise == 0.0
            && let Some((normal, shape)) = jet.formed()
        {
            let foot = Foot { point: jet.s, normal, distance: 0.0, shape, at: Some([*u, *v]) };
            return (foot, [jet.su, jet.sv]);
        }
        let (point, sides) = self.working(place);
        let normal = self.normal_at(*u, *v, jet);
        let shape = self.bend(jet, normal);
        (Foot { point, normal, distance: 0.0, shape, at: Some([*u, *v]) }, sides)
    }

    /// The place beside that with the parameters `at` by the tangent `by`, with its derivatives by both parameters;
    /// `None` at a border and where a derivative vanishes. `sides` are the derivatives at `at`, when they are known.
    pub fn beside(
        &self,
        [u, v]: [f64; 2],
        sides: Option<[Vec3; 2]>,
        by: Vec3,
    ) -> Option<(Foot, [Vec3; 2])> {
        let [su, sv] = sides.unwrap_or_else(|| self.working(&Placed::new(&self.patch, u, v)).1);
        let (du, dv) = by_sides([su, sv], by)?;
        let (u, v) = (u + du, v + dv);
        let inside = |x: f64, ends: [f64; 2]| x > ends[0] && x < ends[1];
        let domain = self.patch.domain();
        if !(inside(u, domain.u) && inside(v, domain.v)) {
            return None;
        }
        Some(self.foot_on(&Placed::new(&self.patch, u, v)))
    }

    /// What [`Self::beside`] finds of a smooth surface for a short way, from a foot that is a place of it.
    pub fn close_by(&self, foot: &Foot, [su, sv]: [Vec3; 2], by: Vec3) -> Option<Foot> {
        let [u, v] = foot.at?;
        let (du, dv) = by_sides([su, sv], by)?;
        let to = [u + du, v + dv];
        self.is_smooth_between([u, v], to).then(|| Foot { at: Some(to), ..foot.close_by(by) })
    }

    /// Is it known without a look to be smooth between two places with parameters close to each other, the second not on a border?
    #[inline]
    pub fn is_smooth_between(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        /// Beside a point in which a border runs together parameters change by much on a short way.
        const NEAR: f64 = 1e-2;
        if (to[0] - from[0]).abs() > NEAR || (to[1] - from[1]).abs() > NEAR {
            return false;
        }
        match &self.patch {
            Patch::Sculptured(s) => s.is_smooth_between(from, to),
            _ => self.strips.is_some() && !self.patch.domain().border(to[0], to[1]),
        }
    }

    fn foot_at(&self, p: Vec3, place: &Placed) -> Foot {
        let Placed { u, v, jet } = *place;
        let at = Some([u, v]);
        let normal = self.normal_at(u, v, &jet);
        let point = self.raised(jet.s, normal);
        let away = p - point;
        let size = away.norm();
        let distance = normal.dot(&away);
        let across = (away - normal * distance).norm();
        if across > 1e-6 * size && size > 1e-12 * self.extent {
            let ends = self.ends_at([u, v]);
            // On an edge, or in a tip, any of its normals may be that of the place: what lies beside it is told by all of them.
            let mean = match &self.patch {
                Patch::Sculptured(s) => s.tip([u, v]).filter(|_| ends).or_else(|| s.edge([u, v])),
                _ => None,
            };
            if ends || mean.is_some() {
                let over = mean.map_or(distance, |mean| mean.dot(&away));
                let side = if over < 0.0 { -1.0 } else { 1.0 };
                let normal = away * (side / size);
                let k = if ends { [f64::INFINITY * side, 0.0, 0.0] } else { [0.0; 3] };
                let shape = Shape { frame: frame_about(normal), k };
                return Foot { point, normal, distance: side * size, shape, at };
            }
        }
        Foot { point, normal, distance, shape: self.bend(&jet, normal), at }
    }

    fn normal_at(&self, u: f64, v: f64, jet: &Jet) -> Vec3 {
        // Where a border shrinks to a point, its derivative along it is rounding: what the normals beside it come to.
        let (along, aside) = (jet.su.norm_squared(), jet.sv.norm_squared());
        let none = 1e-24 * along.max(aside);
        let inwards = |x: f64| if x < 0.5 { 1.0 } else { -1.0 };
        let pole = if along <= none {
            across(jet.suv * inwards(v), jet.sv)
        } else if aside <= none {
            across(jet.su, jet.suv * inwards(u))
        } else {
            None
        };
        let beside = |x: f64| x + (0.5 - x) * 1e-5;
        pole.or_else(|| jet.normal())
            .or_else(|| self.patch.jet(beside(u), beside(v)).normal())
            .unwrap_or_else(Vec3::z)
    }

    /// Is all of a sculptured surface, with its straight continuation, at least so far from a convex body? `near` tells the
    /// signed distance from a point, negative in the body, and its gradient, no longer than 1: the distance lies above the
    /// plane of both. `least` may be negative. False also where it is not seen, and of other surfaces.
    pub fn keeps_off(&self, least: f64, near: impl Fn(Vec3) -> (f64, Vec3)) -> bool {
        let Patch::Sculptured(spans) = &self.patch else { return false };
        spans.cells().keeps_off(least, near, |patch, u, v| spans.jet_of(patch, u, v))
    }

    /// The same of the first or last border of u (0) or v (1) of a sculptured surface itself.
    pub fn border_keeps_off(
        &self,
        border: [usize; 2],
        least: f64,
        near: impl Fn(Vec3) -> (f64, Vec3),
    ) -> bool {
        let Patch::Sculptured(spans) = &self.patch else { return false };
        spans.border_keeps_off(border, least, near)
    }

    /// Pieces of a sculptured surface that may come nearer to a disk, or to what is above it, than the first of the limits and, the disk
    /// having gone by less than the second, hold a place at which its distance dips: `look` is asked what is to become of each. Of
    /// other surfaces it is asked nothing.
    pub fn beneath(&self, disk: &Disk, limits: [f64; 2], look: impl FnMut(&Facing) -> Next) {
        if let Patch::Sculptured(spans) = &self.patch {
            let jet = |patch, u, v| spans.jet_of(patch, u, v);
            spans.cells().beneath(disk, limits, jet, look);
        }
    }

    /// Pieces of a sculptured surface that may come nearer to a tool than the first of the limits and, the tool having gone by less than
    /// the second, hold a place at which its distance dips: `look` is asked what is to become of each. The tool is on the side of the
    /// normal `n` at the parameters `near`. `None` of other surfaces.
    pub fn touching(
        &self,
        tool: &Tool<'_>,
        (near, n): ([f64; 2], Vec3),
        limits: [f64; 2],
        look: impl FnMut(&Touching) -> Next,
    ) -> Option<()> {
        let Patch::Sculptured(spans) = &self.patch else { return None };
        let at = spans.jet(near[0], near[1]);
        let sign = at.su.cross(&at.sv).dot(&n).signum();
        let jet = |patch, u, v| spans.jet_of(patch, u, v);
        spans.cells().touching((tool, sign), limits, jet, look);
        Some(())
    }

    /// The least cosine between a unit vector and the normals of a sculptured surface within balls, which lead to the side to which the
    /// normal `n` at the parameters `near` does; `None` where it is not above 0, at edges, and of other surfaces.
    pub fn upright(
        &self,
        balls: &[(Vec3, f64)],
        axis: Vec3,
        (near, n): ([f64; 2], Vec3),
    ) -> Option<f64> {
        let Patch::Sculptured(spans) = &self.patch else { return None };
        let jet = spans.jet(near[0], near[1]);
        let sign = jet.su.cross(&jet.sv).dot(&n).signum();
        spans.cells().upright(balls, axis * sign)
    }
}

impl Domain {
    fn clamp_u(&self, u: f64) -> f64 {
        u.clamp(self.u[0], self.u[1])
    }

    fn clamp_v(&self, v: f64) -> f64 {
        v.clamp(self.v[0], self.v[1])
    }

    fn border(&self, u: f64, v: f64) -> bool {
        u <= self.u[0] || u >= self.u[1] || v <= self.v[0] || v >= self.v[1]
    }

    /// Parameters at an end beyond which the distance would fall.
    fn fixed(&self, u: f64, v: f64, jet: &Jet, p: Vec3) -> [bool; 2] {
        let w = jet.s - p;
        let (gu, gv) = (w.dot(&jet.su), w.dot(&jet.sv));
        let at =
            |x: f64, ends: [f64; 2], g: f64| x <= ends[0] && g > 0.0 || x >= ends[1] && g < 0.0;
        [at(u, self.u, gu), at(v, self.v, gv)]
    }
}

impl Patch {
    fn domain(&self) -> Domain {
        match self {
            Self::Ruled(r) => r.domain(),
            Self::Polyconic(p) => p.domain(),
            Self::Sculptured(s) => s.domain(),
        }
    }

    /// The place, straight on beyond the ends.
    fn jet(&self, u: f64, v: f64) -> Jet {
        match self {
            Self::Ruled(r) => r.jet(u, v),
            Self::Polyconic(p) => p.jet(u, v),
            Self::Sculptured(s) => s.jet(u, v),
        }
    }
}

impl Placed {
    fn new(patch: &Patch, u: f64, v: f64) -> Self {
        Self { u, v, jet: patch.jet(u, v) }
    }
}
