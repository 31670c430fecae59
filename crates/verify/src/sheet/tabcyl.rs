//! TABCYL: each span of the directrix is a chart, along it and along the generatrix.

use aptc_geometry::{Tabcyl as Form, Vec2, Vec3};

use super::{Jet, Patch, Patches, Spot, Tile};

/// Length of the difference of two unit tangents from which on there is a corner between them, halved.
const CORNER: f64 = 1e-9;
/// Spans that share a bounding circle.
const GROUP: usize = 8;

/// A tabulated cylinder in its own axes. The positive side is the left of the directrix.
#[derive(Clone, Debug)]
pub(crate) struct Tabcyl {
    spans: Vec<Span>,
    groups: Vec<Disk>,
    /// Does the last span end where the first begins?
    closed: bool,
    /// Where it turns at once: what closes the gaps there counts as charts, behind the spans.
    corners: Vec<Corner>,
}

/// Where the directrix turns at once, from one unit normal to the other.
#[derive(Clone, Copy, Debug)]
struct Corner {
    /// The span that begins there.
    span: usize,
    point: Vec2,
    normals: [Vec2; 2],
}

impl Corner {
    /// Is it hollow seen from this side?
    fn is_hollow(&self, side: f64) -> bool {
        let [m, n] = self.normals;
        side * m.perp(&n) > 0.0
    }

    /// The sine of half the angle by which it turns.
    fn half(&self) -> f64 {
        let [m, n] = self.normals;
        0.5 * (n - m).norm()
    }
}

#[derive(Clone, Copy, Debug)]
struct Span {
    flat: Flat,
    disk: Disk,
}

/// A span of the directrix in its plane: `x` along the chord, to its left `x (a (x^2 - l^2) + b (x - l))`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flat {
    pub(crate) start: Vec2,
    /// Unit direction of the chord.
    pub(crate) chord: Vec2,
    pub(crate) a: f64,
    pub(crate) b: f64,
    /// That of the chord.
    pub(crate) length: f64,
}

impl Flat {
    /// The place at `x` and its first and second derivatives.
    pub(crate) fn jet(&self, x: f64) -> [Vec2; 3] {
        let (l, left) = (self.length, Vec2::new(-self.chord.y, self.chord.x));
        let offset = x * (self.a * (x * x - l * l) + self.b * (x - l));
        let slope = 3.0 * self.a * x * x + 2.0 * self.b * x - self.a * l * l - self.b * l;
        let bend = 6.0 * self.a * x + 2.0 * self.b;
        [self.start + self.chord * x + left * offset, self.chord + left * slope, left * bend]
    }
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
                let flat = Flat { start: s.start, chord, a: s.a, b: s.b, length: s.length };
                Span { flat, disk }
            })
            .collect();
        let usable = |s: &Span| s.flat.length > 0.0 && s.flat.chord.norm().is_finite();
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
        let mut new = Self { spans, groups, closed: form.closed(), corners: Vec::new() };
        for chart in 0..new.spans.len() {
            let Some(before) = new.before(chart) else { continue };
            let before = &new.spans[before].flat;
            let own = &new.spans[chart].flat;
            let left = |d: Vec2| Vec2::new(-d.y, d.x).normalize();
            let normals = [left(before.jet(before.length)[1]), left(own.jet(0.0)[1])];
            let corner = Corner { span: chart, point: own.start, normals };
            if corner.half() > CORNER {
                new.corners.push(corner);
            }
        }
        Some(new)
    }

    /// The sine of half the greatest angle by which it turns at once; none where it does nowhere.
    pub(crate) fn sharpest(&self) -> f64 {
        self.corners.iter().map(Corner::half).fold(0.0, f64::max)
    }

    /// What closes the gaps at corners that are hollow seen from this side, within a sphere.
    pub(crate) fn rolled(
        &self,
        side: f64,
        (center, radius): (Vec3, f64),
    ) -> impl Iterator<Item = Patch> {
        let flat = center.xy();
        let near = move |c: &Corner| c.is_hollow(side) && (c.point - flat).norm() <= radius;
        let all = self.corners.iter().enumerate().filter(move |(_, c)| near(c));
        all.map(move |(i, _)| Patch {
            chart: self.spans.len() + i,
            at: [0.5, center.z],
            half: [0.5, radius],
            ..Patch::default()
        })
    }

    /// The corner that a chart closes the gap at.
    fn corner(&self, chart: usize) -> Option<&Corner> {
        self.corners.get(chart.checked_sub(self.spans.len())?)
    }

    /// The same place on a face beside the corner.
    pub(crate) fn on_face(&self, spot: Spot) -> Spot {
        let on = |c: &Corner| Spot { chart: c.span, at: [0.0, spot.at[1]] };
        self.corner(spot.chart).map_or(spot, on)
    }

    /// What holds a part of what closes a gap; `None` of a part of a span.
    ///
    /// Between unit normals m and n the chord from one to the other is nowhere nearer to the middle than half of m + n, and a unit
    /// vector turns by no more than that on it does, over its length.
    pub(crate) fn rolled_tile(&self, patch: &Patch) -> Option<Tile> {
        let corner = self.corner(patch.chart)?;
        let [m, n] = corner.normals;
        let least = 0.5 * (m + n).norm();
        let turn = [patch.half[0] * (n - m).norm() / least.max(f64::MIN_POSITIVE), 0.0];
        let jet = self.jet(&patch.spot());
        let side = [Vec3::zeros(), Vec3::z() * patch.half[1]];
        let none = [Vec3::zeros(); 3];
        Some(Tile { c: jet.p, side, stray: [0.0; 2], bend: none, vary: [0.0; 3], n: jet.n, turn })
    }

    pub(crate) fn roots(&self, center: Vec3, radius: f64, out: &mut Patches) -> bool {
        let flat = center.xy();
        let far = |d: &Disk| (d.center - flat).norm() > d.radius + radius;
        for (g, disk) in self.groups.iter().enumerate() {
            if far(disk) {
                continue;
            }
            for (i, s) in self.spans.iter().enumerate().skip(g * GROUP).take(GROUP) {
                let half = 0.5 * s.flat.length;
                let patch = Patch {
                    chart: i,
                    at: [half, center.z],
                    half: [half, radius],
                    ..Patch::default()
                };
                if !far(&s.disk) && !out.push(patch) {
                    return false;
                }
            }
        }
        true
    }

    /// A span of the directrix.
    pub(crate) fn flat(&self, chart: usize) -> Option<Flat> {
        self.spans.get(chart).map(|s| s.flat)
    }

    /// The span that begins where this one ends.
    pub(crate) fn after(&self, chart: usize) -> Option<usize> {
        let next = chart + 1;
        if next < self.spans.len() { Some(next) } else { self.closed.then_some(0) }
    }

    /// The span that ends where this one begins.
    pub(crate) fn before(&self, chart: usize) -> Option<usize> {
        chart.checked_sub(1).or_else(|| self.closed.then(|| self.spans.len() - 1))
    }

    /// How many spans ahead the span `to` is of the span `from`, less than none for one behind it; of a curve that goes round
    /// the shorter way.
    pub(crate) fn ahead(&self, from: usize, to: usize) -> isize {
        let all = self.spans.len() as isize;
        let by = to as isize - from as isize;
        if !self.closed || 2 * by.abs() <= all {
            by
        } else if by > 0 {
            by - all
        } else {
            by + all
        }
    }

    /// The spans of which a part may be within `radius` of a point of the plane.
    pub(crate) fn about(&self, p: Vec2, radius: f64) -> impl Iterator<Item = usize> {
        let far = move |d: &Disk| (d.center - p).norm() > d.radius + radius;
        let groups = self.groups.iter().enumerate().filter(move |(_, disk)| !far(disk));
        groups.flat_map(move |(g, _)| {
            let spans = self.spans.iter().enumerate().skip(g * GROUP).take(GROUP);
            spans.filter(move |(_, s)| !far(&s.disk)).map(|(i, _)| i)
        })
    }

    pub(crate) fn jet(&self, spot: &Spot) -> Jet {
        if let Some(corner) = self.corner(spot.chart) {
            let [share, w] = spot.at;
            let [m, n] = corner.normals;
            let n = crate::solid::unit_or((m * (1.0 - share) + n * share).push(0.0), m.push(0.0));
            return Jet { p: corner.point.push(w), d: [Vec3::zeros(), Vec3::z()], n };
        }
        let s = &self.spans[spot.chart].flat;
        let [x, w] = spot.at;
        let left = Vec2::new(-s.chord.y, s.chord.x);
        let [p, d, _] = s.jet(x);
        let slope = d.dot(&left);
        let n = (left - s.chord * slope) / (1.0 + slope * slope).sqrt();
        Jet {
            p: Vec3::new(p.x, p.y, w),
            d: [Vec3::new(d.x, d.y, 0.0), Vec3::z()],
            n: Vec3::new(n.x, n.y, 0.0),
        }
    }

    pub(crate) fn second(&self, patch: &Patch) -> [f64; 3] {
        let s = &self.spans[patch.chart].flat;
        let at = |x: f64| (6.0 * s.a * x + 2.0 * s.b).abs();
        let (x, h) = (patch.at[0], patch.half[0]);
        [at(x - h).max(at(x + h)), 0.0, 0.0]
    }

    /// Second derivatives in the middle of a piece, and how much they differ on it.
    pub(crate) fn bend(&self, patch: &Patch) -> ([Vec3; 3], [f64; 3]) {
        let s = &self.spans[patch.chart].flat;
        let left = Vec3::new(-s.chord.y, s.chord.x, 0.0);
        let bend = left * (6.0 * s.a * patch.at[0] + 2.0 * s.b);
        ([bend, Vec3::zeros(), Vec3::zeros()], [6.0 * s.a.abs() * patch.half[0], 0.0, 0.0])
    }

    pub(crate) fn settle(&self, spot: Spot) -> Spot {
        let [x, w] = spot.at;
        let length = self.spans[spot.chart].flat.length;
        if x > length
            && let Some(chart) = self.after(spot.chart)
        {
            let x = (x - length).min(self.spans[chart].flat.length);
            return Spot { chart, at: [x, w] };
        }
        if x < 0.0
            && let Some(chart) = self.before(spot.chart)
        {
            let l = self.spans[chart].flat.length;
            return Spot { chart, at: [(l + x).max(0.0), w] };
        }
        Spot { at: [x.clamp(0.0, length), w], ..spot }
    }

    /// The side of the nearest place; `None` beyond an end, where only what lies near the surface has a side.
    pub(crate) fn sign(&self, p: Vec3) -> Option<f64> {
        self.sign_at(p.xy())
    }

    /// The same of a point of the plane.
    pub(crate) fn sign_at(&self, flat: Vec2) -> Option<f64> {
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
        if self.closed {
            return false;
        }
        let last = self.spans.len() - 1;
        let ahead = |chart: usize, x: f64, way: f64| {
            let jet = self.jet(&Spot { chart, at: [x, 0.0] });
            way * (flat - jet.p.xy()).dot(&jet.d[0].xy()) > 0.0
        };
        ahead(0, 0.0, -1.0) || ahead(last, self.spans[last].flat.length, 1.0)
    }

    /// Distance of a point from a span and how far it is to the left of the nearest place there. The span is cut
    /// into pieces; in each the place is narrowed down where the distance stops falling, by regula falsi; the end that
    /// stays counts half.
    fn nearest(&self, chart: usize, flat: Vec2) -> (f64, f64) {
        /// Pieces of a span.
        const PIECES: u32 = 16;
        /// Looks at a piece; some six are usual.
        const LOOKS: u32 = 60;
        let length = self.spans[chart].flat.length;
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
                let (mut a, mut b) = ((at(i - 1), before.2), (at(i), behind.2));
                let mut stayed = 0;
                for _ in 0..LOOKS {
                    let x = a.0 - a.1 * (b.0 - a.0) / (b.1 - a.1);
                    let here = look(x);
                    offer(here);
                    if here.2 < 0.0 {
                        (a, b.1) = ((x, here.2), if stayed < 0 { 0.5 * b.1 } else { b.1 });
                        stayed = -1;
                    } else {
                        (b, a.1) = ((x, here.2), if stayed > 0 { 0.5 * a.1 } else { a.1 });
                        stayed = 1;
                    }
                    if here.2.abs() <= f64::EPSILON * here.0 || b.0 - a.0 <= f64::EPSILON * length {
                        break;
                    }
                }
            }
            before = behind;
        }
        best
    }
}
