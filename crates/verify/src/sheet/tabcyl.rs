//! TABCYL: each span of the directrix is a chart, along it and along the generatrix.

use aptc_geometry::{Tabcyl as Form, Vec2, Vec3};

use super::{Jet, Patch, Patches, Spot};

/// Spans that share a bounding circle.
const GROUP: usize = 8;

/// A tabulated cylinder in its own axes. The positive side is the left of the directrix.
#[derive(Clone, Debug)]
pub(crate) struct Tabcyl {
    spans: Vec<Span>,
    groups: Vec<Disk>,
}

#[derive(Clone, Copy, Debug)]
struct Span {
    start: Vec2,
    chord: Vec2,
    a: f64,
    b: f64,
    length: f64,
    disk: Disk,
}

#[derive(Clone, Copy, Debug)]
struct Disk {
    center: Vec2,
    radius: f64,
}

impl Tabcyl {
    pub(crate) fn new(form: &Form) -> Option<Self> {
        let spans: Vec<Span> = form
            .spans
            .iter()
            .enumerate()
            .map(|(i, s)| {
                let chord = form.chord(i);
                let center = s.start + chord * (0.5 * s.length);
                let rise = s.max.abs().max(s.min.abs());
                let disk = Disk { center, radius: 0.5 * s.length + rise };
                Span { start: s.start, chord, a: s.a, b: s.b, length: s.length, disk }
            })
            .collect();
        let usable = |s: &Span| s.length > 0.0 && s.chord.norm().is_finite();
        if spans.is_empty() || !spans.iter().all(usable) {
            return None;
        }
        let groups = spans
            .chunks(GROUP)
            .map(|g| {
                let mean = g.iter().map(|s| s.disk.center).sum::<Vec2>() / g.len() as f64;
                let reach = |s: &Span| (s.disk.center - mean).norm() + s.disk.radius;
                Disk { center: mean, radius: g.iter().map(reach).fold(0.0, f64::max) }
            })
            .collect();
        Some(Self { spans, groups })
    }

    pub(crate) fn roots(&self, center: Vec3, radius: f64, out: &mut Patches) -> bool {
        let flat = center.xy();
        let far = |d: &Disk| (d.center - flat).norm() > d.radius + radius;
        for (g, disk) in self.groups.iter().enumerate() {
            if far(disk) {
                continue;
            }
            for (i, s) in self.spans.iter().enumerate().skip(g * GROUP).take(GROUP) {
                let half = 0.5 * s.length;
                let patch =
                    Patch { chart: i, at: [half, center.z], half: [half, radius], group: false };
                if !far(&s.disk) && !out.push(patch) {
                    return false;
                }
            }
        }
        true
    }

    pub(crate) fn jet(&self, spot: &Spot) -> Jet {
        let s = &self.spans[spot.chart];
        let [x, w] = spot.at;
        let left = Vec2::new(-s.chord.y, s.chord.x);
        let l = s.length;
        let offset = x * (s.a * (x * x - l * l) + s.b * (x - l));
        let slope = 3.0 * s.a * x * x + 2.0 * s.b * x - s.a * l * l - s.b * l;
        let p = s.start + s.chord * x + left * offset;
        let d = s.chord + left * slope;
        let n = (left - s.chord * slope) / (1.0 + slope * slope).sqrt();
        Jet {
            p: Vec3::new(p.x, p.y, w),
            d: [Vec3::new(d.x, d.y, 0.0), Vec3::z()],
            n: Vec3::new(n.x, n.y, 0.0),
        }
    }

    pub(crate) fn second(&self, patch: &Patch) -> [f64; 3] {
        let s = &self.spans[patch.chart];
        let at = |x: f64| (6.0 * s.a * x + 2.0 * s.b).abs();
        let (x, h) = (patch.at[0], patch.half[0]);
        [at(x - h).max(at(x + h)), 0.0, 0.0]
    }

    /// Second derivatives in the middle of a piece, and how much they differ on it.
    pub(crate) fn bend(&self, patch: &Patch) -> ([Vec3; 3], [f64; 3]) {
        let s = &self.spans[patch.chart];
        let left = Vec3::new(-s.chord.y, s.chord.x, 0.0);
        let bend = left * (6.0 * s.a * patch.at[0] + 2.0 * s.b);
        ([bend, Vec3::zeros(), Vec3::zeros()], [6.0 * s.a.abs() * patch.half[0], 0.0, 0.0])
    }

    pub(crate) fn settle(&self, spot: Spot) -> Spot {
        let [x, w] = spot.at;
        let length = self.spans[spot.chart].length;
        if x > length && spot.chart + 1 < self.spans.len() {
            let chart = spot.chart + 1;
            let x = (x - length).min(self.spans[chart].length);
            return Spot { chart, at: [x, w] };
        }
        if x < 0.0 && spot.chart > 0 {
            let chart = spot.chart - 1;
            let l = self.spans[chart].length;
            return Spot { chart, at: [(l + x).max(0.0), w] };
        }
        Spot { at: [x.clamp(0.0, length), w], ..spot }
    }

    /// The side of the nearest place; `None` beyond an end, where only what lies near the surface has a side.
    pub(crate) fn sign(&self, p: Vec3) -> Option<f64> {
        let flat = p.xy();
        let mut best = (f64::INFINITY, 1.0);
        for (chart, s) in self.spans.iter().enumerate() {
            if (s.disk.center - flat).norm() - s.disk.radius > best.0 {
                continue;
            }
            let (distance, side) = self.nearest(chart, flat);
            if distance < best.0 {
                best = (distance, side);
            }
        }
        // At corners between spans the side is that of either; an end has no other.
        let beside = best.1.abs() < 0.5 * best.0 && self.beyond(flat);
        (!beside).then(|| 1.0_f64.copysign(best.1))
    }

    /// Is a point beyond an end of the curve, seen along it there?
    fn beyond(&self, flat: Vec2) -> bool {
        let last = self.spans.len() - 1;
        let ahead = |chart: usize, x: f64, way: f64| {
            let jet = self.jet(&Spot { chart, at: [x, 0.0] });
            way * (flat - jet.p.xy()).dot(&jet.d[0].xy()) > 0.0
        };
        ahead(0, 0.0, -1.0) || ahead(last, self.spans[last].length, 1.0)
    }

    /// Distance of a point from a span and how far it is to the left of the nearest place there. The span is cut
    /// into pieces; in each the place is narrowed down where the distance stops falling.
    fn nearest(&self, chart: usize, flat: Vec2) -> (f64, f64) {
        /// Pieces of a span.
        const PIECES: u32 = 16;
        /// Halvings of a piece: to the last digit of its length.
        const HALVINGS: u32 = 52;
        let length = self.spans[chart].length;
        let look = |x: f64| {
            let jet = self.jet(&Spot { chart, at: [x, 0.0] });
            let away = flat - jet.p.xy();
            (away.norm(), away.dot(&jet.n.xy()), -away.dot(&jet.d[0].xy()))
        };
        let at = |i: u32| length * f64::from(i) / f64::from(PIECES);
        let mut before = look(0.0);
        let mut best = (before.0, before.1);
        let mut offer = |found: (f64, f64, f64)| {
            if found.0 < best.0 {
                best = (found.0, found.1);
            }
        };
        for i in 1..=PIECES {
            let behind = look(at(i));
            offer(behind);
            if before.2 < 0.0 && behind.2 > 0.0 {
                let (mut a, mut b) = (at(i - 1), at(i));
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (a + b);
                    if look(middle).2 < 0.0 { a = middle } else { b = middle }
                }
                offer(look(0.5 * (a + b)));
            }
            before = behind;
        }
        best
    }
}
