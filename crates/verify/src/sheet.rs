//! Curved surfaces as charts: points, tangents, and how far a piece strays from its parallelogram.
//!
//! A chart is a map of a rectangle of parameters into space with bounds of its second derivatives, so that
//! a piece `u +- hu, v +- hv` lies within `du + dv` of the parallelogram `c +- a +- b`. Nothing here is
//! solved for: a bound rests on Taylor's formula alone.

mod bend;
mod bow;
mod patched;
mod polyconic;
mod powers;
mod quadric;
mod rail;
mod ruled;
mod sculpted;
mod slack;
mod tabcyl;

use aptc_geometry::surface::continued_of;
use aptc_geometry::{Form, Sculptured, Vec3};

use crate::each::{three, two};
use crate::pile::Pile;
use crate::tool::Pose;

use patched::{Edged, Patched};
pub(crate) use patched::{Hollow, Node, bare};
pub(crate) use quadric::Quadric;
pub(crate) use slack::SLACK;
pub(crate) use tabcyl::{Flat, Tabcyl};

/// A surface in a system of its own.
#[derive(Clone, Debug)]
pub(crate) struct Sheet {
    /// Unit axes of its system.
    axes: [Vec3; 3],
    /// Its origin.
    origin: Vec3,
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    Quadric(Quadric),
    Tabcyl(Tabcyl),
    Patched(Box<Patched>),
}

/// A rectangle of parameters, or a group of charts.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Patch {
    pub(crate) chart: usize,
    pub(crate) at: [f64; 2],
    pub(crate) half: [f64; 2],
    /// Is `chart` the number of a group of charts?
    pub(crate) group: bool,
    /// Where its tile is kept.
    pub(crate) kept: Kept,
}

/// Where the tile of a piece is kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Kept {
    #[default]
    Nowhere,
    /// With the chart, all of which the piece is.
    Chart,
    /// In a cut, with this number.
    Cut(usize),
}

/// A place of the surface by its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    pub(crate) chart: usize,
    pub(crate) at: [f64; 2],
}

/// What holds a piece.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tile {
    /// The middle.
    pub(crate) c: Vec3,
    /// Half sides.
    pub(crate) side: [Vec3; 2],
    /// Greatest distance from the parallelogram, by parameter.
    pub(crate) stray: [f64; 2],
    /// Second derivatives in the middle times the half lengths: uu, uv, vv.
    pub(crate) bend: [Vec3; 3],
    /// How much they differ from those on the piece at most.
    pub(crate) vary: [f64; 3],
    /// Unit normal in the middle, to the positive side.
    pub(crate) n: Vec3,
    /// Greatest change of the unit normal, by parameter.
    pub(crate) turn: [f64; 2],
}

/// Position and derivatives at a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet {
    pub(crate) p: Vec3,
    pub(crate) d: [Vec3; 2],
    /// Unit normal to the positive side.
    pub(crate) n: Vec3,
}

/// Pieces that wait to be looked at.
pub(crate) type Patches = Pile<Patch, 256>;

impl Sheet {
    /// The surface of a form; `None` for those without charts here.
    pub(crate) fn new(form: &Form) -> Option<Self> {
        match form.shape() {
            Form::Quadric(q) => {
                let (axes, origin, quadric) = Quadric::new(&q.c)?;
                Some(Self { axes, origin, kind: Kind::Quadric(quadric) })
            }
            Form::Tabcyl(t) => {
                let axes = [t.u(), t.v(), t.w()];
                Some(Self { axes, origin: Vec3::zeros(), kind: Kind::Tabcyl(Tabcyl::new(t)?) })
            }
            Form::Ruled(r) => {
                let (cells, grid) = ruled::Rulings::new(r)?;
                Some(Self::of(Patched::new(patched::Kind::Ruled(Box::new(cells)), grid)?))
            }
            Form::Polyconic(p) => {
                let (cells, grid) = polyconic::Sections::new(p)?;
                Some(Self::of(Patched::new(patched::Kind::Polyconic(Box::new(cells)), grid)?))
            }
            Form::Ssurf(d) => {
                let (cells, grid) = sculpted::Sculpted::with_continuation(d)?;
                Some(Self::of(Patched::new(patched::Kind::Sculpted(cells), grid)?))
            }
            _ => None,
        }
    }

    /// A sculptured surface without its continuation.
    pub(crate) fn bare(surface: &Sculptured) -> Option<Self> {
        let (cells, grid) = sculpted::Sculpted::new(surface);
        Some(Self::of(Patched::new(patched::Kind::Sculpted(cells), grid)?))
    }

    /// A sculptured surface with its continuation.
    pub(crate) fn reaching(surface: &Sculptured) -> Option<Self> {
        let (cells, grid) = sculpted::Sculpted::reaching(&continued_of(surface)?);
        Some(Self::of(Patched::new(patched::Kind::Sculpted(cells), grid)?))
    }

    fn of(patched: Patched) -> Self {
        let axes = [Vec3::x(), Vec3::y(), Vec3::z()];
        let mut new = Self { axes, origin: Vec3::zeros(), kind: Kind::Patched(Box::new(patched)) };
        if let Kind::Patched(p) = &new.kind {
            let tiles = p.charts().map(|chart| new.made(&chart)).collect();
            if let Kind::Patched(p) = &mut new.kind {
                p.keep(tiles);
            }
        }
        new
    }

    /// A position in the surface's own system.
    pub(crate) fn local(&self, pose: &Pose) -> Pose {
        let turn =
            |w: Vec3| Vec3::new(self.axes[0].dot(&w), self.axes[1].dot(&w), self.axes[2].dot(&w));
        Pose { te: turn(pose.te - self.origin), ta: turn(pose.ta) }
    }

    /// A direction of the surface's own system in space.
    pub(crate) fn in_space(&self, w: Vec3) -> Vec3 {
        self.axes[0] * w.x + self.axes[1] * w.y + self.axes[2] * w.z
    }

    /// The curve of a TABCYL, in the plane of its own first two axes.
    pub(crate) fn curve(&self) -> Option<&Tabcyl> {
        match &self.kind {
            Kind::Tabcyl(t) => Some(t),
            Kind::Quadric(_) | Kind::Patched(_) => None,
        }
    }

    /// On which side the point of the surface's own system lies, +1 or -1; `None` where only the nearest
    /// place tells.
    pub(crate) fn sign(&self, p: Vec3) -> Option<f64> {
        match &self.kind {
            Kind::Quadric(q) => Some(1.0_f64.copysign(q.value(p))),
            Kind::Tabcyl(t) => t.sign(p),
            Kind::Patched(_) => None,
        }
    }

    /// The pieces that hold all of the surface within the sphere; false when they are too many.
    pub(crate) fn roots(&self, center: Vec3, radius: f64, out: &mut Patches) -> bool {
        match &self.kind {
            Kind::Quadric(q) => q.roots(center, radius, out),
            Kind::Tabcyl(t) => t.roots(center, radius, out),
            Kind::Patched(p) => out.push(p.root()),
        }
    }

    /// The group of all charts, of surfaces that have them in a tree.
    pub(crate) fn tree(&self) -> Option<Patch> {
        match &self.kind {
            Kind::Patched(p) => Some(p.root()),
            Kind::Quadric(_) | Kind::Tabcyl(_) => None,
        }
    }

    /// The charts of a sculptured surface over a range of its parameters.
    pub(crate) fn pieces(&self, range: &[[f64; 2]; 2]) -> Vec<Patch> {
        match &self.kind {
            Kind::Patched(p) => p.pieces(range),
            Kind::Quadric(_) | Kind::Tabcyl(_) => Vec::new(),
        }
    }

    /// What holds a group of charts.
    pub(crate) fn group(&self, patch: &Patch) -> Option<&Node> {
        match &self.kind {
            Kind::Patched(p) if patch.group => Some(p.node(patch.chart)),
            _ => None,
        }
    }

    /// What is in a group of charts, nearer to `x` last.
    pub(crate) fn below(&self, patch: &Patch, x: Vec3) -> [Option<Patch>; 2] {
        match &self.kind {
            Kind::Patched(p) if patch.group => p.below(patch.chart, x),
            _ => [None; 2],
        }
    }

    pub(crate) fn jet(&self, spot: &Spot) -> Jet {
        match &self.kind {
            Kind::Quadric(q) => q.jet(spot),
            Kind::Tabcyl(t) => t.jet(spot),
            Kind::Patched(p) => p.jet(spot),
        }
    }

    /// What is at a place, of charts with borders also on those beside it.
    pub(crate) fn around(&self, spot: &Spot) -> Vec<Jet> {
        match &self.kind {
            Kind::Quadric(_) | Kind::Tabcyl(_) => vec![self.jet(spot)],
            Kind::Patched(p) => p.around(spot),
        }
    }

    /// The same with the second derivatives: uu, uv, vv. What goes on straight along a bent border counts as bent
    /// as the border.
    pub(crate) fn bent(&self, spot: &Spot) -> (Jet, [Vec3; 3]) {
        let place = Patch { chart: spot.chart, at: spot.at, ..Patch::default() };
        match &self.kind {
            Kind::Quadric(q) => (q.jet(spot), q.bend(&place).0),
            Kind::Tabcyl(t) => (t.jet(spot), t.bend(&place).0),
            Kind::Patched(p) => p.look(spot),
        }
    }

    /// The same place where the parameters left the chart, in the chart next to it.
    pub(crate) fn settle(&self, spot: Spot) -> Spot {
        match &self.kind {
            Kind::Quadric(q) => q.settle(spot),
            Kind::Tabcyl(t) => t.settle(spot),
            Kind::Patched(p) => p.settle(spot),
        }
    }

    /// The edges of the surface, if it has any.
    pub(crate) fn edged(&self) -> Option<&Edged> {
        match &self.kind {
            Kind::Quadric(_) | Kind::Tabcyl(_) => None,
            Kind::Patched(p) => Some(p.edged()).filter(|e| e.any),
        }
    }

    /// Does the surface go on without an edge wherever a piece lies at a border of its chart? Of what is not in a grid of
    /// charts nothing is told.
    pub(crate) fn goes_on(&self, patch: &Patch) -> bool {
        match &self.kind {
            Kind::Quadric(_) | Kind::Tabcyl(_) => false,
            Kind::Patched(p) => p.goes_on(patch),
        }
    }

    pub(crate) fn tile(&self, patch: &Patch) -> Tile {
        match &self.kind {
            Kind::Patched(p) if patch.kept == Kept::Chart => *p.tile(patch.chart),
            Kind::Patched(p) => match p.on_rolled(patch.chart) {
                Some(rolled) => p.rolled_tile(rolled, patch, |patch| self.made(&patch)),
                None => self.made(patch),
            },
            Kind::Tabcyl(t) => t.rolled_tile(patch).unwrap_or_else(|| self.made(patch)),
            Kind::Quadric(_) => self.made(patch),
        }
    }

    /// Of a place on an edge the same on a face beside it.
    pub(crate) fn on_face(&self, spot: Spot) -> Spot {
        match &self.kind {
            Kind::Patched(p) => p.on_face(spot),
            Kind::Tabcyl(t) => t.on_face(spot),
            Kind::Quadric(_) => spot,
        }
    }

    fn made(&self, patch: &Patch) -> Tile {
        let (jet, bend, vary) = self.middle(patch);
        let most = self.second(patch);
        // No more than in the middle and by how much they differ: of quotients the norms alone say little.
        let second = three([0, 1, 2], |i| most[i].min(bend[i].norm() + vary[i]));
        let [uu, uv, vv] = second;
        let [hu, hv] = patch.half;
        let cross = 0.5 * uv * hu * hv;
        let stray = [0.5 * uu * hu * hu + cross, 0.5 * vv * hv * hv + cross];
        let side = [jet.d[0] * hu, jet.d[1] * hv];
        let turn = match &self.kind {
            Kind::Quadric(q) => q.turn(patch.chart, jet.p, side, stray),
            Kind::Tabcyl(_) => [uu * hu, 0.0],
            Kind::Patched(p) => p.turn(patch, &jet, second),
        };
        let area = [hu * hu, hu * hv, hv * hv];
        let bend = three([0, 1, 2], |i| bend[i] * area[i]);
        let vary = three([0, 1, 2], |i| vary[i] * area[i]);
        Tile { c: jet.p, side, stray, bend, vary, n: jet.n, turn }
    }

    /// Bounds of the second derivatives over a piece: uu, uv, vv.
    fn second(&self, patch: &Patch) -> [f64; 3] {
        match &self.kind {
            Kind::Quadric(q) => q.second(patch),
            Kind::Tabcyl(t) => t.second(patch),
            Kind::Patched(p) => p.second(patch),
        }
    }

    /// The middle of a piece, the second derivatives there, uu, uv and vv, and by how much they differ from these on it at most.
    pub(crate) fn middle(&self, patch: &Patch) -> (Jet, [Vec3; 3], [f64; 3]) {
        let with = |jet: Jet, (bend, vary)| (jet, bend, vary);
        match &self.kind {
            Kind::Quadric(q) => with(q.jet(&patch.spot()), q.bend(patch)),
            Kind::Tabcyl(t) => with(t.jet(&patch.spot()), t.bend(patch)),
            Kind::Patched(p) => p.bent(patch),
        }
    }

    /// Second derivatives of a piece, and by how much they differ on it at most, where those at a corner of it are known.
    pub(crate) fn bend_on(&self, patch: &Patch, known: &[Vec3; 3]) -> ([Vec3; 3], [f64; 3]) {
        match &self.kind {
            Kind::Patched(p) => p.bend_on(patch, *known, 2.0),
            Kind::Quadric(q) => q.bend(patch),
            Kind::Tabcyl(t) => t.bend(patch),
        }
    }

    /// How far the straight line between two places may lie from the surface; infinite when they have no
    /// chart in common.
    pub(crate) fn sag(&self, a: &Spot, b: &Spot) -> f64 {
        if a.chart != b.chart {
            return f64::INFINITY;
        }
        let half = two([0, 1], |i| 0.5 * (b.at[i] - a.at[i]).abs());
        let at = two([0, 1], |i| 0.5 * (b.at[i] + a.at[i]));
        let [uu, uv, vv] = self.second(&Patch { chart: a.chart, at, half, ..Patch::default() });
        let [hu, hv] = half;
        0.5 * (uu * hu * hu + 2.0 * uv * hu * hv + vv * hv * hv)
    }
}

impl Tile {
    /// By how much a linear function with the unit gradient `m` may be less on the piece than in its middle: by its
    /// slope, and by its bend where that goes down; where it goes up it makes good for the slope.
    #[inline]
    pub(crate) fn dip(&self, m: Vec3) -> f64 {
        let cross = m.dot(&self.bend[1]).abs() + self.vary[1];
        let along = |i: usize| {
            let slope = m.dot(&self.side[i]);
            fall(slope, m.dot(&self.bend[2 * i]) - self.vary[2 * i] - cross)
        };
        along(0) + along(1)
    }

    /// Radius of the sphere about the middle that holds the piece.
    pub(crate) fn radius(&self) -> f64 {
        self.side[0].norm() + self.side[1].norm() + self.stray[0] + self.stray[1]
    }
}

/// By how much `slope s + bend s^2 / 2` may be below 0 with s from -1 to 1.
pub(crate) fn fall(slope: f64, bend: f64) -> f64 {
    let slope = slope.abs();
    if bend > slope { 0.5 * slope * slope / bend } else { slope - 0.5 * bend }
}

impl Patch {
    /// The group of charts with a number.
    pub(crate) fn group(number: usize) -> Self {
        Self { chart: number, group: true, ..Self::default() }
    }

    /// Both halves across parameter `i`.
    pub(crate) fn halves(&self, i: usize) -> [Self; 2] {
        let h = 0.5 * self.half[i];
        two([-h, h], |shift| {
            let mut p = *self;
            (p.half[i], p.kept) = (h, Kept::Nowhere);
            p.at[i] += shift;
            p
        })
    }

    pub(crate) fn spot(&self) -> Spot {
        Spot { chart: self.chart, at: self.at }
    }

    /// Is a place in the piece?
    pub(crate) fn holds(&self, spot: &Spot) -> bool {
        let within = |i: usize| (spot.at[i] - self.at[i]).abs() <= self.half[i];
        spot.chart == self.chart && within(0) && within(1)
    }
}

#[cfg(test)]
pub(crate) mod forms;
#[cfg(test)]
pub(crate) mod tests;
