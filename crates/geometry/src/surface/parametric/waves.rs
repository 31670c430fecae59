//! The rulings of a ruled surface whose curves are waves, and the sections of a polyconic: a wide cutter may touch at several
//! of them.

use super::samples::{Column, Samples};
use super::{ParametricSurface, Patch, Placed};
use crate::Vec3;

/// Samples of a span of a curve.
const SAMPLES: f64 = 4.0;
/// Bends of a polyconic along its length at most: the degree of its control curves.
const BENDS: f64 = 7.0;

/// The sampled sections of a polyconic, which lie in parallel planes, or with a thickness near them.
#[derive(Clone, Debug)]
pub(super) struct Planes {
    /// Unit normal of the planes, and from where to where each section is along it.
    normal: Vec3,
    levels: Vec<[f64; 2]>,
    /// All places of the first section first.
    samples: Vec<Sample>,
}

/// A place of a section.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Its parameters along the polyconic and along the section.
    pub at: [f64; 2],
    /// The point.
    pub point: Vec3,
    /// Unit normal.
    pub normal: Vec3,
    /// The derivative along the section.
    pub along: Vec3,
}

impl Planes {
    /// Those of the samples of a polyconic; `None` of other surfaces.
    pub(super) fn new(surface: &ParametricSurface) -> Option<Self> {
        let Patch::Polyconic(sections) = &surface.patch else { return None };
        let sample = |u: f64, v: f64| {
            let place = Placed::new(&surface.patch, u, v);
            let normal = surface.normal_at(u, v, &place.jet);
            let (point, [_, along]) = surface.working(&place);
            Sample { at: [u, v], point, normal, along }
        };
        let (us, vs) = (&surface.samples.us, &surface.samples.vs);
        let each = |u: &f64| vs.iter().map(|v| sample(*u, *v)).collect::<Vec<_>>();
        let samples: Vec<Sample> = us.iter().flat_map(each).collect();
        let normal = sections.across()?;
        let level = |section: &[Sample]| {
            let each = section.iter().map(|s| s.point.dot(&normal));
            let around = |m: [f64; 2], x: f64| [m[0].min(x), m[1].max(x)];
            each.fold([f64::INFINITY, f64::NEG_INFINITY], around)
        };
        let levels = samples.chunks_exact(vs.len()).map(level).collect();
        Some(Self { normal, levels, samples })
    }

    /// All places of the first section first.
    pub(super) fn samples(&self) -> &[Sample] {
        &self.samples
    }
}

impl ParametricSurface {
    /// Is it a ruled surface?
    pub fn is_ruled(&self) -> bool {
        matches!(self.patch, Patch::Ruled(_))
    }

    /// Is it a ruled surface, and does one of its curves bend to both sides?
    pub fn has_waves(&self) -> bool {
        self.waves
    }

    /// How many spans of its curves lie between two places of a ruled surface with waves; of a polyconic how often it bends
    /// between them at most.
    pub fn spans_between(&self, a: [f64; 2], b: [f64; 2]) -> Option<f64> {
        let spans = match &self.patch {
            Patch::Ruled(rulings) if self.waves => f64::from(rulings.pieces()) / SAMPLES,
            Patch::Polyconic(_) => BENDS,
            _ => return None,
        };
        Some((a[0] - b[0]).abs() * spans)
    }

    /// How many spans or patches two places are apart.
    pub fn pieces_between(&self, [a, b]: [[f64; 2]; 2]) -> f64 {
        let [u, v] = match &self.patch {
            Patch::Ruled(rulings) => [f64::from(rulings.pieces()) / SAMPLES, 0.0],
            Patch::Polyconic(_) => [BENDS, 0.0],
            Patch::Sculptured(s) => s.spans(),
        };
        (a[0] - b[0]).abs() * u + (a[1] - b[1]).abs() * v
    }

    /// Is it a polyconic, whose sections are sampled?
    pub fn has_sections(&self) -> bool {
        self.planes.is_some()
    }

    /// The sampled sections of a polyconic between which some places may come nearer than `reach` to the straight way from `a`
    /// to `b`, two and two in their order.
    pub fn sections_near(&self, a: Vec3, b: Vec3, reach: f64) -> impl Iterator<Item = [usize; 2]> {
        let levels = self.planes.iter().flat_map(|p| p.levels.windows(2).map(|l| (l, p.normal)));
        levels.enumerate().filter_map(move |(i, (levels, n))| {
            let (from, to) = (a.dot(&n), b.dot(&n));
            let (low, high) = (levels[0][0].min(levels[1][0]), levels[0][1].max(levels[1][1]));
            let near = low <= from.max(to) + reach && high >= from.min(to) - reach;
            near.then_some([i, i + 1])
        })
    }

    /// The samples of a section, in their order; none of other surfaces.
    pub fn section(&self, i: usize) -> &[Sample] {
        let n = self.samples.vs.len();
        self.planes.as_ref().and_then(|p| p.samples.get(i * n..(i + 1) * n)).unwrap_or_default()
    }

    /// The sampled rulings between which some may come nearer than `reach` to the straight way from `a` to `b`, two and two in
    /// their order.
    pub fn rulings_near(&self, a: Vec3, b: Vec3, reach: f64) -> impl Iterator<Item = [f64; 2]> {
        // The place of a ruling next to the way, and how far off it is.
        let near = move |Column { start, way, inverse }: &Column| {
            let off = |p: Vec3| p - way * (way.dot(&p) * inverse);
            let (from, by) = (off(a - start), off(b - a));
            let t = (-from.dot(&by) / by.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            let away = from + by * t;
            (a + (b - a) * t - away, away.norm())
        };
        let Samples { us, columns, .. } = &self.samples;
        us.windows(2).zip(columns.windows(2)).filter_map(move |(u, columns)| {
            let ((p, d), (q, e)) = (near(&columns[0]), near(&columns[1]));
            (d.min(e) - (q - p).norm() <= reach).then(|| [u[0], u[1]])
        })
    }
}
