//! The gap along a cut vector: where it is least and greatest while the tool end moves straight, its axis fixed
//! or turning evenly.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Reason, Spot, Surface, Tool, Vec3, trig};

use crate::centred;
use crate::dips::{Sample, cubic_at, dip, single, tangents_meet};
use crate::edges::{comes_over_corner, has_edges};
use crate::gap::{Condition, Gap, Side, distance};

/// Share of the cutter's radius by which two places of contact lie apart.
const ANOTHER: f64 = 0.1;
/// Greatest change of the normal along a chord, as a vector, on which the contact goes round the cutter.
const MOST_ROUND: f64 = 0.7;
/// Share of a chord at which it is seen what touches once the axis turns.
const BESIDE: f64 = 1e-3;
/// Share by which a gap rises over its tangents at an edge, of what these rise and fall on the piece.
const BENT: f64 = 0.05;
/// Share of its way to a limit to which an extreme gap is found.
const BY: f64 = 0.01;
/// Looks along a chord that comes by corners, and halvings between two of them.
const CORNERED: u8 = 12;
const HALVINGS: u8 = 40;
/// Greatest number of pieces into which a chord over a surface of mixed curvature is cut.
const MAX_PIECES: usize = 256;

/// An extreme value of the gap on a chord.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// Where, 0 at the first tool end, 1 at the second.
    pub t: f64,
    /// The gap there; as a bound it may lie beyond the value by less than the resolution asked for.
    pub g: f64,
}

/// Least and greatest gap along a cut vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord {
    /// No gap on the chord is less.
    pub low: Extreme,
    /// No gap on the chord is greater.
    pub high: Extreme,
    /// How much the rate of change of the gap grows from the first tool end to the second, the whole chord
    /// being 1: positive where the gap bends up.
    pub bow: f64,
    /// Are the bounds proved? They are where the gap is convex or concave along every chord (plane, sphere,
    /// cylinder, cone, convex quadrics); elsewhere they rest on the curvatures met on the way.
    pub proved: bool,
}

/// How exactly extreme gaps are wanted.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    resolution: f64,
    limits: Option<[f64; 2]>,
    looks: &'static [f64],
}

impl Exact {
    /// To `resolution` near `limits` of the gap; elsewhere to a share of how far it is from them, which is enough to tell how
    /// much longer or shorter a chord has to be.
    pub fn beside(resolution: f64, limits: [f64; 2]) -> Self {
        Self { resolution, limits: Some(limits), looks: &[] }
    }

    /// The whole cutter is looked at at these shares of a chord with a turning axis, in their order: a place of it that touches
    /// at neither end may dip on the way, as a flank that lies nearly along rulings does with its other end.
    pub fn looking(self, looks: &'static [f64]) -> Self {
        Self { looks, ..self }
    }

    /// At least and greatest gaps like these.
    fn at(self, gaps: [f64; 2]) -> [f64; 2] {
        let Some(limits) = self.limits else { return [self.resolution; 2] };
        [0, 1].map(|i| self.resolution.max(BY * (gaps[i] - limits[i]).abs()))
    }
}

impl From<f64> for Exact {
    fn from(resolution: f64) -> Self {
        Self { resolution, limits: None, looks: &[] }
    }
}

/// One place of the chord.
#[derive(Clone, Copy)]
struct Place {
    t: f64,
    gap: Gap,
    slope: f64,
}

impl Place {
    fn sample(&self) -> Sample {
        Sample { t: self.t, g: self.gap.g, slope: self.slope }
    }
}

/// Least and greatest gap while the tool end moves straight from `tool` to `to`, the axis turning evenly in the
/// plane of both axes. `ends` are the gaps at both ends when they are known. Extreme values are found as exactly as
/// `exact` says.
///
/// Without turning a plane's gap is linear; outside a convex solid the gap is a convex function of the tool's place
/// and inside one a concave function, so tangents bound it: the greatest (least) value is at an end, the other
/// between the tangents of a bracket that Newton's method closes. All else goes by cubics through values and slopes.
#[expect(clippy::too_many_arguments, reason = "the two ends, the surface and its condition")]
pub fn chord(
    tool: &Tool<'_>,
    to: &Tool<'_>,
    surface: &Surface,
    condition: Condition,
    side: Side,
    thick: f64,
    ends: Option<[Gap; 2]>,
    exact: impl Into<Exact>,
) -> Result<Chord, Reason> {
    let exact = exact.into();
    let resolution = exact.resolution;
    // Where the tool end lies on a surface it does not matter how the axis stands.
    let turn = if condition == Condition::On { None } else { Turn::between(tool.ta, to.ta) };
    let run = Run { tool, v: to.te - tool.te, turn, surface, condition, side, thick };
    let (a, b) = match ends {
        Some([a, b]) => (a, b),
        None => (run.gap(0.0, None)?, run.gap(1.0, None)?),
    };
    let (a, b) = (run.at(0.0, a), run.at(1.0, b));
    let ends = if a.gap.g <= b.gap.g { [a, b] } else { [b, a] };
    let extreme = |p: &Place| Extreme { t: p.t, g: p.gap.g };
    if turn.is_some() {
        let [a, b] = run.governed(a, b, resolution)?;
        if exact.looks.is_empty()
            && let Some(chord) = run.single(a, b, resolution)?
        {
            return Ok(chord);
        }
        return run.mixed(a, b, exact);
    }
    let bow = b.slope - a.slope;
    if let Surface::Plane(_) = surface {
        return Ok(Chord { low: extreme(&ends[0]), high: extreme(&ends[1]), bow, proved: true });
    }
    let known = [&a.gap, &b.gap];
    if let Some(inner) = centred::extreme(tool, run.v, surface, condition, side, known) {
        let (low, high) = match side {
            Side::Positive => (inner, extreme(&ends[1])),
            Side::Negative | Side::Open => (extreme(&ends[0]), inner),
        };
        return Ok(Chord { low, high, bow, proved: true });
    }
    let (far, near) = match side {
        Side::Positive => (surface.convex(), surface.concave()),
        Side::Negative | Side::Open => (surface.concave(), surface.convex()),
    };
    if far {
        let low = run.dip(a, b, 1.0, resolution)?;
        Ok(Chord { low, high: extreme(&ends[1]), bow, proved: true })
    } else if near {
        let high = run.dip(a, b, -1.0, resolution)?;
        Ok(Chord { low: extreme(&ends[0]), high, bow, proved: true })
    } else if run.comes_to_corners(&a, &b) {
        run.cornered(a, b, exact)
    } else {
        match run.single(a, b, resolution)? {
            Some(chord) => Ok(chord),
            None => run.mixed(a, b, exact),
        }
    }
}

/// The even turning of an axis.
#[derive(Clone, Copy)]
struct Turn {
    /// The axis at the start, and the unit vector square to it towards which it turns.
    from: Vec3,
    across: Vec3,
    /// Radians in all.
    angle: f64,
}

impl Turn {
    /// `None` when both are the same.
    fn between(from: Vec3, to: Vec3) -> Option<Self> {
        let cos = from.dot(&to);
        let across = to - from * cos;
        let sin = across.norm();
        (sin > 1e-12).then(|| Self { from, across: across / sin, angle: trig::atan2(sin, cos) })
    }

    fn axis(&self, t: f64) -> Vec3 {
        let (sin, cos) = trig::sin_cos(self.angle * t);
        (self.from * cos + self.across * sin).normalize()
    }

    /// Radians for the whole chord, as a vector.
    fn rate(&self) -> Vec3 {
        self.from.cross(&self.across) * self.angle
    }
}

struct Run<'a, 'b> {
    tool: &'a Tool<'b>,
    v: Vec3,
    turn: Option<Turn>,
    surface: &'a Surface,
    condition: Condition,
    side: Side,
    thick: f64,
}

impl Run<'_, '_> {
    fn gap(&self, t: f64, start: Option<Spot>) -> Result<Gap, Reason> {
        let mut tool = self.tool.at(self.tool.te + self.v * t);
        if let Some(turn) = &self.turn {
            tool.ta = turn.axis(t);
        }
        distance(&tool, self.surface, self.condition, self.side, self.thick, start)
    }

    fn place(&self, t: f64, start: Option<Spot>) -> Result<Place, Reason> {
        Ok(self.at(t, self.gap(t, start)?))
    }

    fn at(&self, t: f64, gap: Gap) -> Place {
        let te = self.tool.te + self.v * t;
        let turning = self.turn.map_or(0.0, |turn| gap.turn_rate(te, turn.rate()));
        Place { t, gap, slope: gap.normal.dot(&self.v) + turning }
    }

    /// The ends of a chord with a turning axis. A flat end or a flank that lies along a surface there touches at all of a
    /// line, and any of its points may have been found: the slope is that of the point that touches once the axis turns.
    fn governed(&self, a: Place, b: Place, resolution: f64) -> Result<[Place; 2], Reason> {
        let angle = self.turn.map_or(0.0, |turn| turn.angle);
        let profile = self.tool.profile;
        let alike = ANOTHER * profile.half_width(a.gap.segment) + angle * profile.reach();
        let apart = |p: &Place, q: &Place| {
            (p.gap.tool_point - q.gap.tool_point - self.v * (p.t - q.t)).norm() > alike
        };
        let m = self.place(0.5, Some(a.gap.spot()))?;
        let end = |end: Place, inwards: f64| {
            if !apart(&end, &m) {
                return Ok(end);
            }
            let near = self.place(end.t + inwards * BESIDE, Some(m.gap.spot()))?;
            let change = 2.0 * BESIDE * near.slope.abs() + resolution;
            let touches = (near.gap.g - end.gap.g).abs() <= change && !apart(&near, &m);
            let gap = Gap { g: end.gap.g, raw: end.gap.raw, ..near.gap };
            Ok(if touches { Place { t: end.t, gap, slope: near.slope } } else { end })
        };
        Ok([end(a, 1.0)?, end(b, -1.0)?])
    }

    /// A place of a piece; where its ends touch at different places, the deeper of both.
    fn between(&self, a: &Place, b: &Place, t: f64) -> Result<Place, Reason> {
        let [near, far] = if t - a.t <= b.t - t { [a, b] } else { [b, a] };
        let m = self.place(t, Some(near.gap.spot()))?;
        // What goes over a crest touches at the same place of this.
        let alike = ANOTHER * self.tool.profile.half_width(a.gap.segment);
        let same = (a.gap.surface_point - b.gap.surface_point).norm() <= alike;
        if same || self.apart(a, b) <= alike || self.closed() {
            return Ok(m);
        }
        let other = self.place(t, Some(far.gap.spot()))?;
        Ok(if other.gap.g < m.gap.g { other } else { m })
    }

    /// The whole cutter at a place, which may be nearer at the places of contact before and behind than where looks begin.
    fn looked(&self, t: f64, beside: [&Place; 2]) -> Result<Place, Reason> {
        let mut here = self.place(t, None)?;
        for place in beside {
            let there = self.place(t, Some(place.gap.spot()))?;
            here = if there.gap.g < here.gap.g { there } else { here };
        }
        Ok(here)
    }

    /// Where the contact goes over from one place to another on a piece, the gap is the less of two and has an edge: about where
    /// both tangents meet. Over a crest both gaps bend up from them; that counts as a share of how steep they are, which is an
    /// estimate and falls away as pieces are halved.
    fn crest(&self, a: &Place, b: &Place) -> Option<Extreme> {
        let edge = a.slope > 0.0 && b.slope < 0.0;
        if !edge || self.apart(a, b) <= ANOTHER * self.tool.profile.half_width(a.gap.segment) {
            return None;
        }
        let [from, to] = [a.sample(), b.sample()];
        let (t, g) = tangents_meet(&from, &to, from.slope, to.slope, from.g, to.g);
        let bent = BENT * (b.t - a.t) * (a.slope - b.slope);
        (t > a.t && t < b.t).then_some(Extreme { t, g: g + bent })
    }

    /// Where the contact comes from the corner onto the flat end on a piece, or back: there the gap goes on as steeply, and bends
    /// otherwise. Cut there, each part is soon as its cubic says; in halves it would be cut until the edge is of no account.
    ///
    /// On the flat end the gap hardly bends, along a ridge not at all: so the edge is where a parabola from the one end goes over into
    /// the tangent of the other, which both ends tell. `None` where that is hardly on the piece.
    fn edge(&self, a: &Place, b: &Place) -> Option<f64> {
        /// Share of the piece from its ends.
        const INSIDE: f64 = 0.02;
        if self.turn.is_some() {
            return None;
        }
        let (h, rise) = (b.t - a.t, b.gap.g - a.gap.g);
        let share = match [a, b].map(|p| p.gap.segment) {
            [Some(Segment::Arc), Some(Segment::LowerLine)] => {
                2.0 * (rise / h - b.slope) / (a.slope - b.slope)
            }
            [Some(Segment::LowerLine), Some(Segment::Arc)] => {
                1.0 - 2.0 * (a.slope - rise / h) / (a.slope - b.slope)
            }
            _ => return None,
        };
        (share > INSIDE && share < 1.0 - INSIDE).then_some(a.t + share * h)
    }

    /// How far the places of the cutter are from one another that touch at two places of the chord.
    fn apart(&self, a: &Place, b: &Place) -> f64 {
        (a.gap.tool_point - b.gap.tool_point - self.v * (a.t - b.t)).norm()
    }

    /// Does the contact go round the cutter as the surface turns, and not from one place to another?
    fn goes_round(&self, a: &Place, b: &Place) -> bool {
        let widest = self.tool.profile.half_width(a.gap.segment);
        let turned = (a.gap.normal - b.gap.normal).norm();
        turned <= MOST_ROUND && self.apart(a, b) <= (ANOTHER + 2.0 * turned) * widest
    }

    /// Is the contact found without a search, so that it does not matter where one would begin?
    fn closed(&self) -> bool {
        use Surface::{Cone, Cylinder, Plane, Sphere};
        matches!(self.surface, Plane(_) | Sphere(_) | Cylinder(_) | Cone(_))
    }

    /// The extreme value of a convex or concave gap; see [`dip`].
    fn dip(&self, a: Place, b: Place, sign: f64, resolution: f64) -> Result<Extreme, Reason> {
        let known = |p: Place| (p.sample(), p.gap.spot());
        // In a hollow the nearest wall may change on the way: only a search without a start sees it.
        let at = |t: f64, near: &Spot| Ok(known(self.place(t, (sign > 0.0).then_some(*near))?));
        dip(known(a), known(b), sign, resolution, at)
    }

    /// One dip or one bump, as on most chords: the slope, met at a few places, falls or rises all along, and
    /// the cubic through the ends foretells what is met. `None` when it is not so.
    fn single(&self, a: Place, b: Place, resolution: f64) -> Result<Option<Chord>, Reason> {
        if !self.goes_round(&a, &b) {
            return Ok(None);
        }
        let between = |a: &Place, b: &Place, t: f64| self.between(a, b, t);
        let Some(inner) = single(a, b, resolution, Place::sample, between)? else {
            return Ok(None);
        };
        let rises = b.slope > a.slope;
        let ends = if (a.gap.g <= b.gap.g) == rises { &b } else { &a };
        let outer = Extreme { t: ends.t, g: ends.gap.g };
        let (low, high) = if rises { (inner, outer) } else { (outer, inner) };
        Ok(Some(Chord { low, high, bow: b.slope - a.slope, proved: false }))
    }

    /// Does the contact go over a corner of a TABCYL, or of a tool that stands askew to its rulings from one span of one with corners
    /// to another?
    fn comes_to_corners(&self, a: &Place, b: &Place) -> bool {
        let alike =
            a.gap.at.map(|at| at[0]) == b.gap.at.map(|at| at[0]) && a.gap.segment == b.gap.segment;
        let askew =
            || matches!(self.surface, Surface::Tabcyl(_)) && has_edges(self.tool, self.surface);
        !alike && (comes_over_corner(self.surface, [a.gap.at, b.gap.at]) || askew())
    }

    /// Any curvature, and the least and greatest gap where its slope jumps, or nearly so, as at corners: between looks it is halved to
    /// where the slope changes its sign.
    fn cornered(&self, a: Place, b: Place, exact: Exact) -> Result<Chord, Reason> {
        let Chord { mut low, mut high, bow, proved } = self.mixed(a, b, exact)?;
        let mut last = a;
        for i in 1..=CORNERED {
            let t = f64::from(i) / f64::from(CORNERED);
            let here = if i == CORNERED { b } else { self.between(&last, &b, t)? };
            let (mut from, mut to) = (last, here);
            for _ in 0..HALVINGS {
                // Tangents meet no farther beyond than so.
                let beyond = from.slope.abs().min(to.slope.abs()) * (to.t - from.t);
                if from.slope * to.slope >= 0.0 || beyond <= exact.resolution {
                    break;
                }
                let m = self.between(&from, &to, 0.5 * (from.t + to.t))?;
                low = if m.gap.g < low.g { Extreme { t: m.t, g: m.gap.g } } else { low };
                high = if m.gap.g > high.g { Extreme { t: m.t, g: m.gap.g } } else { high };
                *(if m.slope * from.slope > 0.0 { &mut from } else { &mut to }) = m;
            }
            last = here;
        }
        Ok(Chord { low, high, bow, proved })
    }

    /// Any curvature: halves of a piece are bounded by the cubics through their ends and slopes and by how far
    /// value and slope of the middle are from what the cubic of the piece foretells; pieces whose bounds reach
    /// beyond what was met are halved.
    fn mixed(&self, a: Place, b: Place, exact: Exact) -> Result<Chord, Reason> {
        let at = |p: &Place| Extreme { t: p.t, g: p.gap.g };
        let (mut low, mut high) =
            if a.gap.g < b.gap.g { (at(&a), at(&b)) } else { (at(&b), at(&a)) };
        let bow = b.slope - a.slope;
        let mut todo: Vec<(Place, Place, bool)> = Vec::with_capacity(exact.looks.len() + 1);
        let mut last = a;
        for t in exact.looks {
            let here = self.looked(*t, [&last, &b])?;
            low = if here.gap.g < low.g { at(&here) } else { low };
            high = if here.gap.g > high.g { at(&here) } else { high };
            todo.push((last, here, true));
            last = here;
        }
        todo.push((last, b, true));
        let (mut floor, mut roof) = (low, high);
        let mut pieces = 0;
        while let Some((a, b, whole)) = todo.pop() {
            pieces += 1;
            let edge = if whole { self.edge(&a, &b) } else { None };
            let m = self.between(&a, &b, edge.unwrap_or(0.5 * (a.t + b.t)))?;
            if m.gap.g < low.g {
                low = at(&m);
            }
            if m.gap.g > high.g {
                high = at(&m);
            }
            let h = b.t - a.t;
            let [foretold, lean] = match edge {
                Some(t) => cubic_at(&a.sample(), &b.sample(), t),
                None => [
                    0.5 * (a.gap.g + b.gap.g) + h * (a.slope - b.slope) / 8.0,
                    1.5 * (b.gap.g - a.gap.g) / h - 0.25 * (a.slope + b.slope),
                ],
            };
            // The halves have the value and the slope of the middle: their cubics are off by an eighth of
            // this at most where the third derivative jumps once, and by less where it does not.
            let off = 0.25 * ((m.gap.g - foretold).abs() + 0.25 * h * (m.slope - lean).abs());
            let [fine_low, fine_high] = exact.at([low.g, high.g]);
            let mut beyond = [false; 2];
            let (mut under, mut over, mut rough) = (floor, roof, off);
            for (a, b) in [(a, m), (m, b)] {
                if let Some(crest) = self.crest(&a, &b) {
                    beyond[1] |= crest.g > high.g + fine_high;
                    rough = rough.max(crest.g - a.gap.g.max(b.gap.g));
                    if crest.g > over.g {
                        over = crest;
                    }
                }
                for (t, g) in cubic_extremes(&a, &b) {
                    beyond[0] |= g - off < low.g - fine_low;
                    beyond[1] |= g + off > high.g + fine_high;
                    if g - off < under.g {
                        under = Extreme { t, g: g - off };
                    }
                    if g + off > over.g {
                        over = Extreme { t, g: g + off };
                    }
                }
            }
            let open = beyond[0] && off > 0.25 * fine_low || beyond[1] && rough > 0.25 * fine_high;
            if open && pieces < MAX_PIECES {
                todo.push((a, m, edge.is_none()));
                todo.push((m, b, edge.is_none()));
            } else {
                (floor, roof) = (under, over);
            }
        }
        Ok(Chord { low: floor, high: roof, bow, proved: false })
    }
}

/// Ends and inner extreme values of the cubic through values and slopes.
fn cubic_extremes(a: &Place, b: &Place) -> impl Iterator<Item = (f64, f64)> {
    let h = b.t - a.t;
    let (ga, gb) = (a.gap.g, b.gap.g);
    let (c1, rise) = (a.slope * h, gb - ga);
    let c2 = 3.0 * rise - 2.0 * c1 - b.slope * h;
    let c3 = c1 + b.slope * h - 2.0 * rise;
    let start = a.t;
    let roots = aptc_geometry::roots::quadratic(3.0 * c3, c2, c1, 1.0);
    let inner = roots.ok().into_iter().flat_map(|q| q.roots().to_vec());
    [(a.t, ga), (b.t, gb)].into_iter().chain(
        inner
            .filter(|x| *x > 0.0 && *x < 1.0)
            .map(move |x| (start + h * x, ga + x * (c1 + x * (c2 + x * c3)))),
    )
}
