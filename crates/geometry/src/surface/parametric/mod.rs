//! Surfaces given by two parameters: RLDSRF, POLCON and SSURF.
//!
//! Beyond their ends they go on straight, as a TABCYL does, so that a cutter can come to an end.

mod cells;
#[cfg(test)]
mod dips_tests;
mod part;
mod polyconic;
mod rail;
mod raised;
mod ruled;
mod sculptured;
#[cfg(test)]
mod tests;
mod waves;

use std::sync::Arc;

use crate::surface::{EPS_LEN, Foot, Shape, Spot, frame_about};
use crate::{Place, Polyconic, Reason, RuledSurface, Vec2, Vec3};
pub use part::Part;
use part::Strips;
use polyconic::Sections;
use ruled::Rulings;
use sculptured::Spans;
pub use sculptured::{Continued, continued, continued_of};
use waves::Planes;
pub use waves::Sample;

/// Bound of one search; Newton's method takes some six steps.
const MAX_STEPS: usize = 60;
/// Share of the surface's size that rounding may change of a distance.
const NOISE: f64 = 1e-14;
/// Share of the surface's size below which the square of a step of Newton's method is rounding.
const NEAR: f64 = 1e-9;
/// The same of a step at whose end a smooth surface is as its derivatives at the start tell.
const BESIDE: f64 = 3e-7;
/// Share of the surface's size by which two places lie apart.
const SAME: f64 = 1e-6;
/// Samples along each side of a sculptured surface that tell how large its numbers are.
const SHARES: u32 = 24;
/// Places from which the nearest point is looked for.
const SEEDS: usize = 4;

/// A ruled surface or a polyconic prepared for evaluation. Its positive side is that of the cross product
/// of the derivatives along and across: along the first rail and along the ruling, along the polyconic and
/// along its section.
#[derive(Clone, Debug)]
pub struct ParametricSurface {
    patch: Patch,
    /// Parameters of the grid of samples; a sculptured surface has none.
    us: Vec<f64>,
    vs: Vec<f64>,
    /// The samples, all `v` of the first `u` first.
    grid: Vec<Vec3>,
    /// Greatest distance of each sample from those beside it: no place that belongs to it is farther off.
    apart: Vec<f64>,
    /// Of a ruled surface the sampled rulings: start, whole way and one over its square.
    columns: Vec<(Vec3, Vec3, f64)>,
    /// Of a smooth ruled surface how it bends between them.
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

/// Where a search for the nearest point begins.
#[derive(Clone, Copy, Debug)]
struct Seed {
    /// Square of its distance from the point.
    square: f64,
    u: f64,
    v: f64,
    /// Its sample.
    at: usize,
}

/// Value and derivatives at a place.
#[derive(Clone, Copy, Debug)]
struct Jet {
    s: Vec3,
    su: Vec3,
    sv: Vec3,
    suu: Vec3,
    suv: Vec3,
    svv: Vec3,
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
        let (us, vs, grid) = (Vec::new(), Vec::new(), Vec::new());
        Self {
            patch,
            us,
            vs,
            grid,
            apart: Vec::new(),
            columns: Vec::new(),
            strips: None,
            waves: false,
            planes: None,
            extent,
            rise: 0.0,
        }
    }

    /// Samples at the parameters `us` and `vs`; the ends of the domain across are put in.
    fn prepared(patch: Patch, us: Vec<f64>, mut vs: Vec<f64>) -> Option<Self> {
        let domain = patch.domain();
        vs.retain(|v| *v > domain.v[0] && *v < domain.v[1]);
        vs.insert(0, domain.v[0]);
        vs.push(domain.v[1]);
        let mut grid = Vec::with_capacity(us.len() * vs.len());
        let mut extent = 0.0_f64;
        for u in &us {
            for v in &vs {
                let s = patch.jet(*u, *v).s;
                if !s.iter().all(|x| x.is_finite()) {
                    return None;
                }
                if (0.0..=1.0).contains(u) && (0.0..=1.0).contains(v) {
                    extent = extent.max(s.norm());
                }
                grid.push(s);
            }
        }
        let apart = (0..grid.len()).map(|k| apart(&patch, &grid, vs.len(), k)).collect();
        let n = vs.len();
        let column = |row: &[Vec3]| {
            let way = row[n - 1] - row[0];
            (row[0], way, 1.0 / way.norm_squared())
        };
        let ruled = matches!(patch, Patch::Ruled(_));
        let columns = grid.chunks_exact(n).filter(|_| ruled).map(column).collect();
        let (strips, waves) = match &patch {
            Patch::Ruled(rulings) => (Strips::new(rulings), rulings.waves()),
            _ => (None, false),
        };
        let planes = None;
        let rise = match &patch {
            Patch::Polyconic(sections) => sections.rise(),
            _ => 0.0,
        };
        extent += rise.abs();
        let new = Self { patch, us, vs, grid, apart, columns, strips, waves, planes, extent, rise };
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

    /// Directed distances along the unit direction `d`, rising.
    ///
    /// APT: `ADDSTR`.
    pub fn ray(&self, p: Vec3, d: Vec3) -> Result<Vec<f64>, Reason> {
        let [a, b] = frame_about(d);
        let mut all: Vec<f64> = Vec::new();
        if let Patch::Sculptured(spans) = &self.patch {
            let mut put = |u: f64, v: f64| {
                all.extend(self.pierce(u, v, [a, b], p).map(|s| (s - p).dot(&d)));
            };
            spans.cells().met(p, d, |patch, u, v| spans.jet_of(patch, u, v), &mut put);
        }
        let flat = |s: Vec3| Vec2::new((s - p).dot(&a), (s - p).dot(&b));
        let points: Vec<Vec2> = self.working_grid().map(flat).collect();
        let n = self.vs.len();
        for i in 0..self.us.len().saturating_sub(1) {
            for j in 0..n - 1 {
                let corners = [(i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)];
                let around = |axis: usize| {
                    let x = corners.map(|(i, j)| points[i * n + j][axis]);
                    let (low, high) = x.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |m, x| {
                        (m.0.min(*x), m.1.max(*x))
                    });
                    let slack = 0.5 * (high - low);
                    low - slack <= 0.0 && high + slack >= 0.0
                };
                if !(around(0) && around(1)) {
                    continue;
                }
                let (u, v) =
                    (0.5 * (self.us[i] + self.us[i + 1]), 0.5 * (self.vs[j] + self.vs[j + 1]));
                if let Some(s) = self.pierce(u, v, [a, b], p) {
                    all.push((s - p).dot(&d));
                }
            }
        }
        all.sort_by(f64::total_cmp);
        let same = 1e-7 * (self.extent + p.norm());
        all.dedup_by(|x, y| (*x - *y).abs() <= same);
        if !all.is_empty() {
            return Ok(all);
        }
        let on = self.foot(p).distance.abs() <= EPS_LEN * (self.extent + p.norm());
        Err(if on { Reason::AllHit } else { Reason::NoHit })
    }

    /// The place where the line through `p` across the frame pierces, from a place near it.
    fn pierce(&self, u: f64, v: f64, [a, b]: [Vec3; 2], p: Vec3) -> Option<Vec3> {
        let domain = self.patch.domain();
        let (mut u, mut v) = (u, v);
        let enough = 1e-13 * (self.extent + p.norm());
        for _ in 0..MAX_STEPS {
            let (s, [su, sv]) = self.working(&Placed::new(&self.patch, u, v));
            let w = s - p;
            let (x, y) = (w.dot(&a), w.dot(&b));
            if x.abs().max(y.abs()) <= enough {
                return Some(s);
            }
            let (xu, xv, yu, yv) = (su.dot(&a), sv.dot(&a), su.dot(&b), sv.dot(&b));
            let det = xu * yv - xv * yu;
            let (du, dv) = ((xv * y - yv * x) / det, (yu * x - xu * y) / det);
            if !(du.is_finite() && dv.is_finite()) {
                return None;
            }
            let shorter = 0.5 / du.abs().max(0.2 * dv.abs()).max(0.5);
            let (nu, nv) = (domain.clamp_u(u + du * shorter), domain.clamp_v(v + dv * shorter));
            if (nu - u).abs() <= 1e-16 && (nv - v).abs() <= 1e-16 * (1.0 + v.abs()) {
                return (x.abs().max(y.abs()) <= 1e3 * enough).then_some(s);
            }
            (u, v) = (nu, nv);
        }
        None
    }

    /// Unit normal at the nearest point.
    pub fn normal(&self, p: Vec3) -> Result<Vec3, Reason> {
        let foot = self.foot(p);
        if foot.shape.k[0].is_infinite() {
            return Err(Reason::Degenerate(Place::Singular));
        }
        Ok(foot.normal)
    }

    /// Curvature at a point of the surface.
    pub fn shape_at(&self, spot: Spot) -> Shape {
        let Some([u, v]) = spot.at else { return self.foot(spot.point).shape };
        let jet = self.patch.jet(u, v);
        self.bend(&jet, self.normal_at(u, v, &jet))
    }

    /// Is the place with these parameters on the border?
    pub(crate) fn ends_at(&self, [u, v]: [f64; 2]) -> bool {
        self.patch.domain().border(u, v)
    }

    /// The nearest point. Beyond an end the normal points from or to the given point.
    pub fn foot(&self, p: Vec3) -> Foot {
        let place = self.nearest(p).unwrap_or_else(|| Placed::new(&self.patch, 0.5, 0.5));
        self.foot_at(p, &place)
    }

    /// The foot into which the place with the parameters `at` runs downhill.
    pub fn foot_from(&self, p: Vec3, at: [f64; 2]) -> Foot {
        self.foot_at(p, &self.descend_free(p, at).1)
    }

    /// The foot of the place with the parameters `at`.
    pub fn place(&self, at: [f64; 2]) -> Foot {
        self.place_with_sides(at).0
    }

    /// The same with the derivatives by both parameters.
    pub fn place_with_sides(&self, [u, v]: [f64; 2]) -> (Foot, [Vec3; 2]) {
        let place = Placed::new(&self.patch, u, v);
        let (point, sides) = self.working(&place);
        (self.foot_at(point, &place), sides)
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
        let place = Placed::new(&self.patch, u, v);
        let (point, sides) = self.working(&place);
        Some((self.foot_at(point, &place), sides))
    }

    /// What [`Self::beside`] finds of a smooth surface for a short way, from a foot that is a place of it.
    pub fn close_by(&self, foot: &Foot, [su, sv]: [Vec3; 2], by: Vec3) -> Option<Foot> {
        self.strips.as_ref()?;
        let [u, v] = foot.at?;
        let (du, dv) = by_sides([su, sv], by)?;
        let (u, v) = (u + du, v + dv);
        (!self.patch.domain().border(u, v)).then(|| Foot { at: Some([u, v]), ..foot.close_by(by) })
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
        if across > 1e-6 * size && size > 1e-12 * self.extent && self.patch.domain().border(u, v) {
            let side = if distance < 0.0 { -1.0 } else { 1.0 };
            let normal = away * (side / size);
            let shape = Shape { frame: frame_about(normal), k: [f64::INFINITY * side, 0.0, 0.0] };
            return Foot { point, normal, distance: side * size, shape, at };
        }
        Foot { point, normal, distance, shape: self.bend(&jet, normal), at }
    }

    fn normal_at(&self, u: f64, v: f64, jet: &Jet) -> Vec3 {
        let cross = |jet: &Jet| {
            let n = jet.su.cross(&jet.sv);
            let square = n.norm_squared();
            let flat = square <= 1e-18 * jet.su.norm_squared() * jet.sv.norm_squared();
            (!flat).then(|| n / square.sqrt())
        };
        // Where one derivative vanishes the normal of a place beside it.
        let beside = |x: f64| x + (0.5 - x) * 1e-5;
        cross(jet).or_else(|| cross(&self.patch.jet(beside(u), beside(v)))).unwrap_or_else(Vec3::z)
    }

    /// Distance of the second nearest of the places into which the samples run downhill, of a sculptured surface of
    /// all dips; at most `limit`.
    pub fn rival(&self, p: Vec3, limit: f64) -> f64 {
        let Some(nearest) = self.nearest(p) else { return limit };
        let apart = SAME * self.extent;
        let other = |place: &Placed| (place.jet.s - nearest.jet.s).norm() > apart;
        if let Patch::Sculptured(spans) = &self.patch {
            let jet = |patch, u, v| spans.jet_of(patch, u, v);
            let dip =
                |u, v| Some(self.descend_free(p, [u, v])).filter(|(_, d)| other(d)).map(|(d, _)| d);
            return spans.cells().rival(p, limit, jet, self.descending(spans, p), dip);
        }
        let places = self.seeds(p).into_iter().flatten();
        let places = places.map(|s| self.descend_free(p, [s.u, s.v]));
        let others = places.filter(|(_, place)| other(place));
        let distance = |square: f64| (square.sqrt() - self.rise.abs()).max(0.0);
        others.map(|(square, _)| distance(square)).fold(limit, f64::min)
    }

    /// Is all of a sculptured surface, with its straight continuation, at least so far from a convex body? `near` tells the
    /// signed distance from a point, negative in the body, and its gradient, no longer than 1: the distance lies above the
    /// plane of both. `least` may be negative. False also where it is not seen, and of other surfaces.
    pub fn keeps_off(&self, least: f64, near: impl Fn(Vec3) -> (f64, Vec3)) -> bool {
        let Patch::Sculptured(spans) = &self.patch else { return false };
        spans.cells().keeps_off(least, near, |patch, u, v| spans.jet_of(patch, u, v))
    }

    /// Where the nearest point is looked for from samples.
    fn seeds(&self, p: Vec3) -> [Option<Seed>; SEEDS] {
        match &self.patch {
            Patch::Ruled(r) => self.lowest_rulings(r, p),
            Patch::Polyconic(_) | Patch::Sculptured(_) => self.lowest(p),
        }
    }

    /// The nearest point: Newton's method from the lowest samples, or over the cells.
    fn nearest(&self, p: Vec3) -> Option<Placed> {
        if let Patch::Sculptured(spans) = &self.patch {
            return self.over_cells(spans, p);
        }
        let mut best: Option<(f64, Placed)> = None;
        for seed in self.seeds(p).into_iter().flatten() {
            // No place is nearer than its sample by more than the samples are apart.
            if best.as_ref().is_some_and(|b| seed.square.sqrt() - self.apart[seed.at] > b.0.sqrt())
            {
                continue;
            }
            let (square, place) = self.descend_free(p, [seed.u, seed.v]);
            if best.as_ref().is_none_or(|b| square < b.0) {
                best = Some((square, place));
            }
        }
        best.map(|b| b.1)
    }

    /// Of a sculptured surface the nearest point over its cells.
    fn over_cells(&self, spans: &Spans, p: Vec3) -> Option<Placed> {
        let jet = |patch, u, v| spans.jet_of(patch, u, v);
        let noise = NOISE * (self.extent + p.norm());
        spans.cells().nearest((p, noise), &spans.domain(), jet, self.descending(spans, p))
    }

    /// Of a sculptured surface the way downhill within a rectangle of the parameters, on one patch or all of them.
    fn descending<'a>(
        &'a self,
        spans: &'a Spans,
        p: Vec3,
    ) -> impl Fn(Option<[usize; 2]>, [f64; 2], &Domain) -> (f64, Placed) + 'a {
        move |patch, uv, within| match patch {
            Some(patch) => self.descend(p, uv, within, |u, v| spans.jet_of(patch, u, v)),
            None => self.descend(p, uv, within, |u, v| spans.jet(u, v)),
        }
    }

    /// On a ruling the nearest point is known: the lowest of the sampled rulings.
    fn lowest_rulings(&self, rulings: &Rulings, p: Vec3) -> [Option<Seed>; SEEDS] {
        let domain = rulings.domain();
        let mut found = [None; SEEDS];
        let seed = |i: usize, square: f64| {
            let along = along(&self.columns[i], p);
            let v = domain.v[0] + (domain.v[1] - domain.v[0]) * along;
            Seed { square, u: self.us[i], v, at: i * self.vs.len() }
        };
        // The one before with what came before it, until it is known whether the next is lower.
        let (mut before, mut last) = (f64::INFINITY, f64::INFINITY);
        for (i, column) in self.columns.iter().enumerate() {
            let (start, way, _) = column;
            let square = (p - start - way * along(column, p)).norm_squared();
            if i > 0 && last <= before && last <= square {
                offer(&mut found, seed(i - 1, last));
            }
            (before, last) = (last, square);
        }
        if last <= before && !self.columns.is_empty() {
            offer(&mut found, seed(self.columns.len() - 1, last));
        }
        found
    }

    /// The lowest samples of the grid that are lower than their neighbours.
    fn lowest(&self, p: Vec3) -> [Option<Seed>; SEEDS] {
        let n = self.vs.len();
        let squares: Vec<f64> = self.grid.iter().map(|s| (s - p).norm_squared()).collect();
        let mut found = [None; SEEDS];
        for i in 0..self.us.len() {
            for j in 0..n {
                let here = squares[i * n + j];
                let lower =
                    |i: usize, j: usize| i < self.us.len() && j < n && squares[i * n + j] < here;
                let (up, left) = (i.wrapping_sub(1), j.wrapping_sub(1));
                if !(lower(up, j) || lower(i + 1, j) || lower(i, left) || lower(i, j + 1)) {
                    offer(&mut found, self.seed(here, i * n + j));
                }
            }
        }
        found
    }

    fn seed(&self, square: f64, at: usize) -> Seed {
        let n = self.vs.len();
        Seed { square, u: self.us[at / n], v: self.vs[at % n], at }
    }

    /// Downhill over the whole surface.
    fn descend_free(&self, p: Vec3, uv: [f64; 2]) -> (f64, Placed) {
        self.descend(p, uv, &self.patch.domain(), |u, v| self.patch.jet(u, v))
    }

    /// Newton's method for the nearest point, kept in the rectangle; steps that do not lower the distance are
    /// halved.
    fn descend(
        &self,
        p: Vec3,
        [u, v]: [f64; 2],
        domain: &Domain,
        jet_at: impl Fn(f64, f64) -> Jet,
    ) -> (f64, Placed) {
        let (mut u, mut v) = (u, v);
        let mut jet = jet_at(u, v);
        let mut square = (jet.s - p).norm_squared();
        let tiny = 1e-15 * (self.extent + p.norm());
        for _ in 0..MAX_STEPS {
            let (du, dv) = step(&jet, p, domain.fixed(u, v, &jet, p));
            let moved = (jet.su * du + jet.sv * dv).norm();
            if moved <= tiny {
                break;
            }
            if moved <= BESIDE * self.extent && self.strips.is_some() {
                let to = (u + du, v + dv);
                if !domain.border(to.0, to.1) {
                    ((u, v), jet) = (to, jet.beside(du, dv));
                    square = (jet.s - p).norm_squared();
                    break;
                }
            }
            let mut factor = (0.5 / du.abs().max(1e-300)).min(1.0);
            let mut better = None;
            for _ in 0..30 {
                let (nu, nv) = (domain.clamp_u(u + factor * du), domain.clamp_v(v + factor * dv));
                let next = jet_at(nu, nv);
                let value = (next.s - p).norm_squared();
                // Near the end the distances agree to rounding, that of the coordinates, and the step tells.
                let size = self.extent + p.norm();
                let noise = 16.0 * f64::EPSILON * size * square.sqrt();
                if value < square || moved <= 1e-6 * size && value <= square + noise {
                    better = Some((nu, nv, next, value));
                    break;
                }
                factor *= 0.5;
            }
            let Some((nu, nv, next, value)) = better else { break };
            let stays = (nu - u).abs() <= 1e-16 && (nv - v).abs() <= 1e-16;
            (u, v, jet, square) = (nu, nv, next, value);
            // The method converges quadratically: after a step this small rounding alone is left.
            if stays || factor >= 1.0 && moved <= NEAR * self.extent {
                break;
            }
        }
        (square, Placed { u, v, jet })
    }
}

/// Greatest distance of a sample from those beside it; on rulings, which are straight, from the next rulings.
fn apart(patch: &Patch, grid: &[Vec3], n: usize, k: usize) -> f64 {
    let to = |other: Option<usize>| {
        other.and_then(|o| grid.get(o)).map_or(0.0, |s: &Vec3| (s - grid[k]).norm())
    };
    let along = to(k.checked_sub(n)).max(to(Some(k + n)));
    if matches!(patch, Patch::Ruled(_)) {
        return along;
    }
    let left = (!k.is_multiple_of(n)).then(|| k - 1);
    let right = (k % n + 1 < n).then(|| k + 1);
    along + to(left).max(to(right))
}

/// The share of a sampled ruling at which it is nearest to `p`.
#[inline]
fn along((start, way, inverse): &(Vec3, Vec3, f64), p: Vec3) -> f64 {
    ((p - start).dot(way) * inverse).clamp(0.0, 1.0)
}

/// Keeps the lowest few.
fn offer(found: &mut [Option<Seed>; SEEDS], new: Seed) {
    let mut new = Some(new);
    for slot in found {
        if new.is_some_and(|n| slot.is_none_or(|s| n.square < s.square)) {
            std::mem::swap(slot, &mut new);
        }
    }
}

/// 0 to 1 in `n` equal steps, the ends of the domain and a sample halfway to each.
fn halfway(ends: [f64; 2], n: u32) -> Vec<f64> {
    let mut all = vec![ends[0], 0.5 * ends[0]];
    all.extend(steps(n));
    all.extend([0.5 * (1.0 + ends[1]), ends[1]]);
    all
}

/// 0 to 1 in `n` equal steps.
fn steps(n: u32) -> Vec<f64> {
    (0..=n).map(|i| f64::from(i) / f64::from(n)).collect()
}

/// Newton's step towards the nearest point; parameters that are `fixed` stay.
fn step(jet: &Jet, p: Vec3, fixed: [bool; 2]) -> (f64, f64) {
    let w = jet.s - p;
    let (gu, gv) = (w.dot(&jet.su), w.dot(&jet.sv));
    let (e, f, g) = (jet.su.norm_squared(), jet.su.dot(&jet.sv), jet.sv.norm_squared());
    let (huu, huv, hvv) = (e + w.dot(&jet.suu), f + w.dot(&jet.suv), g + w.dot(&jet.svv));
    let alone = |grad: f64, h: f64, size: f64| {
        if size > 0.0 { -grad / if h > 1e-3 * size { h } else { size } } else { 0.0 }
    };
    match fixed {
        [true, true] => (0.0, 0.0),
        [true, false] => (0.0, alone(gv, hvv, g)),
        [false, true] => (alone(gu, huu, e), 0.0),
        [false, false] => {
            let det = huu * hvv - huv * huv;
            if huu > 0.0 && det > 1e-6 * e * g {
                ((huv * gv - hvv * gu) / det, (huv * gu - huu * gv) / det)
            } else {
                let det = e * g - f * f;
                if det > 1e-12 * e * g {
                    ((f * gv - g * gu) / det, (f * gu - e * gv) / det)
                } else {
                    (alone(gu, huu, e), alone(gv, hvv, g))
                }
            }
        }
    }
}

/// The second fundamental form from the derivatives, positive where the surface bends away from its normal.
fn shape(jet: &Jet, normal: Vec3) -> Shape {
    let (l, m, n) = (-normal.dot(&jet.suu), -normal.dot(&jet.suv), -normal.dot(&jet.svv));
    let (e, f, g) = (jet.su.norm_squared(), jet.su.dot(&jet.sv), jet.sv.norm_squared());
    let area = (e * g - f * f).max(0.0).sqrt();
    if e <= 0.0 || area <= 1e-9 * (e * g).sqrt() {
        return Shape::flat(normal);
    }
    let along = jet.su / e.sqrt();
    let k11 = l / e;
    let k12 = (m - f * k11) / area;
    let k22 = (e * n - f * f * k11 - 2.0 * f * area * k12) / (area * area);
    Shape { frame: [along, normal.cross(&along)], k: [k11, k12, k22] }
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

/// The tangent `by` in these derivatives by both parameters; `None` where they have no area.
#[inline]
fn by_sides([su, sv]: [Vec3; 2], by: Vec3) -> Option<(f64, f64)> {
    let (e, f, g) = (su.norm_squared(), su.dot(&sv), sv.norm_squared());
    let det = e * g - f * f;
    if det <= 1e-12 * e * g {
        return None;
    }
    let (a, b) = (by.dot(&su), by.dot(&sv));
    Some(((g * a - f * b) / det, (e * b - f * a) / det))
}

impl Placed {
    fn new(patch: &Patch, u: f64, v: f64) -> Self {
        Self { u, v, jet: patch.jet(u, v) }
    }
}

impl Jet {
    /// A place beside it where it is smooth, to second order.
    fn beside(&self, a: f64, b: f64) -> Self {
        let (su, sv) = (self.suu * a + self.suv * b, self.suv * a + self.svv * b);
        Self {
            s: self.s + (self.su + su * 0.5) * a + (self.sv + sv * 0.5) * b,
            su: self.su + su,
            sv: self.sv + sv,
            ..*self
        }
    }

    /// A place beyond the ends by `a` and `b`, from the jet at the end itself.
    fn beyond(&self, a: f64, b: f64) -> Self {
        let zero = Vec3::zeros();
        Self {
            s: self.s + self.su * a + self.sv * b + self.suv * (a * b),
            su: self.su + self.suv * b,
            sv: self.sv + self.suv * a,
            suu: if a == 0.0 { self.suu } else { zero },
            suv: self.suv,
            svv: if b == 0.0 { self.svv } else { zero },
        }
    }
}
