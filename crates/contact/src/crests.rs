//! All places of contact on a tabulated cylinder, by a look along its directrix, on a ruled surface whose curves are waves, by
//! a look from ruling to ruling, and on a polyconic, from section to section.
//!
//! At a place of the directrix let p be the point of the cutter that is farthest in along the surface normal. Where it lies
//! ahead of the place before, and behind it afterwards, the cutter touches in between, on a crest as in a hollow; where the
//! opposite happens it is farthest away. The cutter may span many crests, which stations around it would miss. Of a ruling the
//! place counts that p lies beside.

use aptc_geometry::surface::{ParametricSurface, TabcylSurface};
use aptc_geometry::{Foot, Spot, Surface, Tool, Vec3};

use crate::gap::{Gap, Side};
use crate::sections::over_sections;
use crate::stations::{FAR, SEEDS, Seeds};

/// Parts in which a span is looked at, and those of it where the cutter is near a contact at both ends.
const PARTS: u32 = 4;
/// How often parts are divided at most.
pub(crate) const LEVELS: u32 = 3;
/// Halvings to where a span faces the end of the tool.
const FACING: u32 = 24;
/// Halvings between two looks.
const HALVINGS: u32 = 10;
/// Rounds to the place of a ruling that the cutter's point lies beside, and from the next one on it.
const ROUNDS: u32 = 4;

/// Places of contact beside the tool, the deepest first; `None` where there are none, as far from the surface, and on other
/// surfaces.
pub(crate) fn seeds(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: Option<&Gap>,
) -> Option<Seeds> {
    let wide = tool.profile.widest();
    let within = |reach: f64| {
        let mut all = Crests::new(tool, surface, side, known);
        match surface {
            Surface::Tabcyl(s) => all.along_directrix(s, reach),
            Surface::Parametric(s) if s.has_waves() => all.over_rulings(s, reach),
            Surface::Parametric(s) if s.has_sections() => over_sections(&mut all, s, reach),
            _ => {}
        }
        all.seeds()
    };
    let found = within((1.0 + MARGIN) * wide)?;
    // What is nearer than the deepest may lie farther beside a tool that is not at the surface.
    let depth = found.deepest.0;
    if depth > MARGIN * wide { within(wide + (1.0 + BEHIND) * depth) } else { Some(found) }
}

/// Share of the cutter's radius by which a span may be beside the cutter.
const MARGIN: f64 = 0.5;
/// The same by which a place that the cutter seems to cut into may be outside of it.
const BEHIND: f64 = 1e-3;

/// Places of contact of a tool.
pub(crate) struct Crests<'a> {
    pub(crate) tool: &'a Tool<'a>,
    surface: &'a Surface,
    pub(crate) side: Side,
    pub(crate) top: Vec3,
    /// The deepest ones.
    found: [Option<(f64, Spot)>; SEEDS],
    deepest: (f64, Vec3),
    /// The depth of the deepest that is not among them.
    next: f64,
    known: Option<&'a Gap>,
    /// The least way after which a place that is none of contact yet may be as deep as the known one.
    way: f64,
}

impl<'a> Crests<'a> {
    fn new(tool: &'a Tool<'a>, surface: &'a Surface, side: Side, known: Option<&'a Gap>) -> Self {
        let top = tool.te + tool.ta * tool.profile.height();
        let deepest = (f64::INFINITY, tool.te);
        let (found, next, way) = ([None; SEEDS], f64::INFINITY, f64::INFINITY);
        Self { tool, surface, side, top, found, deepest, next, known, way }
    }

    pub(crate) fn offer(&mut self, l: &Look) {
        // The far side of a closed curve, or of a fold, is not cut into from behind: neither is the cutter's point behind the
        // surface there, nor the place in the cutter.
        let behind = BEHIND * self.tool.profile.widest();
        let w = l.ruling;
        let apart = |p: Vec3| self.tool.distance(l.spot.point + w * w.dot(&(p - l.spot.point)));
        let outside =
            || [l.tool_point, self.tool.te, self.top].into_iter().all(|p| apart(p) > behind);
        let before = || self.side.sign() * self.surface.foot(l.tool_point).distance > 0.5 * l.depth;
        if l.depth < 0.0 && outside() && before() {
            return;
        }
        // A little beside a crest the normal leans, and the edge of a flat end lies lower along it by that of its radius: how near
        // the place itself is tells which crests are the deepest, to second order.
        let value = self.tool.distance(l.spot.point);
        if value < self.deepest.0 {
            self.deepest = (value, l.tool_point);
        }
        let mut last = Some((value, l.spot));
        if let Some(i) = self.found.iter().position(|f| f.is_none_or(|f| value < f.0)) {
            self.found[i..].rotate_right(1);
            std::mem::swap(&mut self.found[i], &mut last);
        }
        self.next = last.map_or(self.next, |l| self.next.min(l.0));
    }

    /// Takes a place of a section at which the cutter does not touch yet.
    pub(crate) fn pass(&mut self, l: &Look) {
        let p = l.spot.point;
        let far = |k: &Gap| FAR * self.tool.profile.half_width(k.segment);
        if let Some(known) = self.known.filter(|k| (k.surface_point - p).norm() > far(k)) {
            let near = self.tool.near(p);
            // Both go by their normals times the way.
            let turned = (near.normal + known.normal).norm();
            self.way = self.way.min((near.distance - known.raw) / turned.max(1e-9));
        }
    }

    /// Those of the spans not farther than `reach` from the tool axis.
    fn along_directrix(&mut self, surface: &TabcylSurface, reach: f64) {
        let (tool, side) = (self.tool, self.side);
        let (mut before, mut begin): (Option<(usize, Look)>, Option<Look>) = (None, None);
        let joint = |last: &Look, first: &Look| last.ahead > 0.0 && first.ahead <= 0.0;
        let mut rises = Rises::default();
        for (span, length) in surface.spans_near(tool.te, self.top, reach) {
            let look = |s: f64| Look::at(tool, surface, side, span, s);
            let places = divided(length, &look);
            let [(_, first), .., (_, last)] = places;
            let follows = before.is_some_and(|(last, _)| last + 1 == span);
            if !follows {
                rises = Rises { least: rises.least, ..Rises::default() };
            }
            // A corner between two spans.
            if let Some((_, l)) = before.filter(|_| follows)
                && joint(&l, &first)
            {
                self.offer(&first);
            }
            if span == 0 {
                begin = Some(first);
            }
            rises.take(&first);
            for ends in places.windows(2) {
                let part = Part { from: ends[0], to: ends[1], scale: 1.0 };
                let sides = part.sides(tool, &look);
                part.contacts(sides.as_ref(), &look, &mut |l| self.offer(l), LEVELS - 1);
                rises.along(sides.as_ref(), &ends[1].1);
            }
            before = Some((span, last));
        }
        self.takes(&rises);
        // The corner where the curve closes.
        if let (Some((last, l)), Some(first)) = (before, begin)
            && last > 0
            && surface.form().span_after(last) == Some(0)
            && joint(&l, &first)
        {
            self.offer(&first);
        }
    }

    /// Those between sampled rulings not farther than `reach` from the tool axis.
    fn over_rulings(&mut self, surface: &ParametricSurface, reach: f64) {
        let (tool, side) = (self.tool, self.side);
        let middle = tool.te + tool.ta * tool.profile.corner()[1];
        let look = |u: f64| Look::on_ruling(tool, surface, side, u, middle);
        let mut before: Option<(f64, Look)> = None;
        let mut rises = Rises::default();
        for [low, high] in surface.rulings_near(tool.te, self.top, reach) {
            #[expect(clippy::float_cmp, reason = "the same ruling")]
            let known = before.filter(|b| b.0 == low).map(|b| b.1);
            let first = known.unwrap_or_else(|| look(low));
            if known.is_none() {
                rises = Rises { least: rises.least, ..Rises::default() };
                rises.take(&first);
            }
            let last = look(high);
            let scale = first.rate;
            let part = Part { from: (low, first), to: (high, last), scale };
            let sides = part.sides(tool, &look);
            part.contacts(sides.as_ref(), &look, &mut |l| self.offer(l), LEVELS - 1);
            rises.along(sides.as_ref(), &last);
            before = Some((high, last));
        }
        self.takes(&rises);
    }

    /// Takes where another place of contact would begin.
    fn takes(&mut self, rises: &Rises) {
        if self.known.is_some() {
            // Half of a way counts, as two places come nearer to each other by twice of it.
            self.way = self.way.min(2.0 * rises.least);
        }
    }

    fn seeds(&self) -> Option<Seeds> {
        self.found[0]?;
        let next = self.known.map_or(f64::INFINITY, |k| self.next - k.raw);
        let way = next.min(self.way).max(0.0);
        let spot = |i: usize| self.found.get(i).copied().flatten().map(|f| f.1);
        Some(Seeds { found: std::array::from_fn(spot), deepest: self.deepest, way })
    }
}

/// How far the cutter is from where another place of contact would begin: where it is ahead by less again, after by more, before it
/// comes to a place of contact, and behind by less after one. As the tool moves that changes by its way at most.
#[derive(Clone, Copy)]
struct Rises {
    least: f64,
    last: Option<f64>,
    rising: bool,
}

impl Default for Rises {
    fn default() -> Self {
        Self { least: f64::INFINITY, last: None, rising: false }
    }
}

impl Rises {
    /// Takes the next part to its end, with the sides of a place within it that faces the end of the tool.
    fn along(&mut self, sides: Option<&[(f64, Look); 2]>, to: &Look) {
        sides.iter().copied().flatten().for_each(|side| self.take(&side.1));
        self.take(to);
    }

    /// Takes the next place of the directrix.
    fn take(&mut self, look: &Look) {
        let ahead = look.ahead;
        let Some(last) = self.last.replace(ahead) else { return };
        let rising = ahead > last;
        // A place at which it ceases to rise is a highest one, and one at which it begins to is a lowest one.
        let nearly = if rising { last } else { -last };
        if rising != self.rising && nearly >= 0.0 {
            self.least = self.least.min(nearly);
        }
        self.rising = rising;
    }
}

/// What is seen at the ends of the parts of a span.
fn divided(length: f64, look: &impl Fn(f64) -> Look) -> [(f64, Look); PARTS as usize + 1] {
    let mut part = 0;
    std::array::from_fn(|_| {
        let s = length * (f64::from(part) / f64::from(PARTS));
        part += 1;
        (s, look(s))
    })
}

/// A part of a span, or of the way from a ruling to the next, between two looks.
#[derive(Clone, Copy)]
pub(crate) struct Part {
    pub(crate) from: (f64, Look),
    pub(crate) to: (f64, Look),
    /// The length of a unit of the parameter.
    pub(crate) scale: f64,
}

impl Part {
    /// What is seen on both sides of the place that faces the end of a tool with a flat end: there the cutter's farthest point goes
    /// over from one edge of it to the other. `None` where no place of the part does.
    pub(crate) fn sides(
        &self,
        tool: &Tool<'_>,
        look: &impl Fn(f64) -> Look,
    ) -> Option<[(f64, Look); 2]> {
        let leans = |l: &Look| l.along.dot(&tool.ta) > 0.0;
        let Self { from: mut low, to: mut high, .. } = *self;
        let first = leans(&low.1);
        if tool.profile.corner()[0] <= 0.0 || first == leans(&high.1) {
            return None;
        }
        for _ in 0..FACING {
            let s = 0.5 * (low.0 + high.0);
            let middle = (s, look(s));
            *(if leans(&middle.1) == first { &mut low } else { &mut high }) = middle;
        }
        Some([low, high])
    }

    /// Offers its places of contact: those on both `sides` of a place that faces the end of the tool, and that one.
    pub(crate) fn contacts(
        &self,
        sides: Option<&[(f64, Look); 2]>,
        look: &impl Fn(f64) -> Look,
        offer: &mut impl FnMut(&Look),
        levels: u32,
    ) {
        let Some([low, high]) = sides else { return self.even(look, offer, levels) };
        Self { to: *low, ..*self }.even(look, offer, levels);
        if low.1.ahead > 0.0 && high.1.ahead <= 0.0 {
            offer(&high.1);
        }
        Self { from: *high, ..*self }.even(look, offer, levels);
    }

    /// The same of one on which the cutter's farthest point goes on evenly. Where the cutter is ahead at both ends, or behind, by
    /// less than the length of the part it may touch in between.
    fn even(&self, look: &impl Fn(f64) -> Look, offer: &mut impl FnMut(&Look), levels: u32) {
        let Self { from: (low, a), to: (high, b), scale } = self;
        let (a_ahead, b_ahead) = (a.ahead > 0.0, b.ahead > 0.0);
        let near = a.ahead.abs().min(b.ahead.abs()) < (high - low) * scale;
        if levels > 0 && a_ahead == b_ahead && near {
            let mut from = self.from;
            for part in 1..=PARTS {
                let s = low + (high - low) * (f64::from(part) / f64::from(PARTS));
                let to = if part == PARTS { self.to } else { (s, look(s)) };
                Self { from, to, scale: *scale }.even(look, offer, levels - 1);
                from = to;
            }
            return;
        }
        if !a_ahead || b_ahead {
            return;
        }
        let (mut low, mut high, mut nearest) = (*low, *high, *b);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            nearest = look(middle);
            *(if nearest.ahead > 0.0 { &mut low } else { &mut high }) = middle;
        }
        offer(&nearest);
    }
}

/// What is seen at a place of the directrix, of a ruling or of a section.
#[derive(Clone, Copy)]
pub(crate) struct Look {
    spot: Spot,
    tool_point: Vec3,
    /// How far the cutter's farthest point in is before the tangent plane, and how far ahead across the rulings.
    depth: f64,
    ahead: f64,
    /// Unit direction across the rulings.
    along: Vec3,
    /// Unit direction of the ruling, none on a section, and how fast the surface goes by across it.
    ruling: Vec3,
    rate: f64,
}

impl Look {
    fn at(tool: &Tool<'_>, surface: &TabcylSurface, side: Side, span: usize, s: f64) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "thousands at most")]
        let place = surface.place(tool.te, [span as f64, s]);
        let normal = place.normal * side.sign();
        let tool_point = tool.support(-normal).point;
        let away = tool_point - place.point;
        let ruling = surface.generator();
        // The directrix runs with its normal on its left.
        let along = place.normal.cross(&ruling);
        let mut spot = place.spot();
        spot.point += ruling * ruling.dot(&away);
        Self {
            spot,
            tool_point,
            depth: normal.dot(&away),
            ahead: along.dot(&away),
            along,
            ruling,
            rate: 1.0,
        }
    }

    /// On a ruling, where the cutter's point lies beside it: the normal turns from one place of it to the next. Begun at the
    /// place next to `near`.
    fn on_ruling(
        tool: &Tool<'_>,
        surface: &ParametricSurface,
        side: Side,
        u: f64,
        near: Vec3,
    ) -> Self {
        let (start, [_, way]) = surface.place_with_sides([u, 0.0]);
        let (length, ruling) = (way.norm(), way.normalize());
        let mut v = ruling.dot(&(near - start.point)) / length;
        let mut look = Self::beside(tool, surface, side, [u, v], ruling);
        for _ in 0..ROUNDS {
            v += ruling.dot(&(look.tool_point - look.spot.point)) / length;
            look = Self::beside(tool, surface, side, [u, v], ruling);
        }
        look
    }

    fn beside(
        tool: &Tool<'_>,
        surface: &ParametricSurface,
        side: Side,
        at: [f64; 2],
        ruling: Vec3,
    ) -> Self {
        let (place, [across, _]) = surface.place_with_sides(at);
        Self::at_place(tool, side, &place, across, ruling)
    }

    /// At a place through which a curve goes with the unit direction `ruling`, and `across` to the next one.
    pub(crate) fn at_place(
        tool: &Tool<'_>,
        side: Side,
        place: &Foot,
        across: Vec3,
        ruling: Vec3,
    ) -> Self {
        let normal = place.normal * side.sign();
        let tool_point = tool.support(-normal).point;
        let away = tool_point - place.point;
        let across = across - ruling * ruling.dot(&across);
        let (rate, depth) = (across.norm(), normal.dot(&away));
        let along = across / rate;
        let ahead = along.dot(&away);
        Self { spot: place.spot(), tool_point, depth, ahead, along, ruling, rate }
    }

    /// The same of a place that is none of a ruling.
    pub(crate) fn alone(self) -> Self {
        Self { ruling: Vec3::zeros(), ..self }
    }

    pub(crate) fn rate(&self) -> f64 {
        self.rate
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::gap::gap;
    use aptc_geometry::{
        Cutter, Fit, Form, Knot, Profile, Rail, RuledSurface, Second, Tabcyl, Vec2, trig,
    };
    use nalgebra::Matrix3;
    use proptest::prelude::*;

    /// A wave along x, of this height and length, that repeats itself but for its last digits.
    fn wave([height, length, phase]: [f64; 3], lift: f64) -> Form {
        let knot = |i: i32| {
            let x = f64::from(i) * length / 8.0;
            let turn = std::f64::consts::TAU * (x / length + phase);
            let z = lift + height * (trig::sin(turn) + 0.15 * trig::sin(3.7 * turn));
            Knot { point: Vec2::new(x, z), tangent: None }
        };
        // Over x from -55 to 55 with the shortest waves.
        let knots: Vec<Knot> = (-88..=88).map(knot).collect();
        let rows = [Vec3::x(), Vec3::z(), -Vec3::y()].map(|v| v.transpose());
        let axes = Matrix3::from_rows(&rows);
        Form::Tabcyl(Arc::new(Tabcyl::fit(&knots, Fit::Spline, axes, 10.0).unwrap()))
    }

    fn rulings(waves: [[f64; 3]; 2], lift: f64) -> Form {
        let rail = |i: usize| {
            let (y, lift) = ([-30.0, 30.0][i], lift * [0.0, 1.0][i]);
            let end = |x: f64| Vec3::new(x, y, lift);
            let surface = Arc::new(wave(waves[i], lift));
            Rail { surface, start: end(-50.0), end: end(50.0), toward: Vec3::z() }
        };
        Form::Ruled(Arc::new(RuledSurface { first: rail(0), second: Second::Rail(rail(1)) }))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16))]
        /// No place of a grid is nearer than the place of contact that is found, which is not below the nearest of them.
        #[test]
        fn no_crest_is_missed(
            ruled: bool, height in prop::array::uniform2(0.05_f64..0.3), length in 5.0_f64..12.0,
            [phase, lean, y] in prop::array::uniform3(-1.0_f64..1.0), x in -15.0_f64..-10.0,
            corner in 0_usize..3, lift in -2.0_f64..2.0,
        ) {
            let waves = [0, 1].map(|i| [height[i], length * [1.0, 1.0 + 0.1 * lean][i], phase]);
            let form = if ruled { rulings(waves, lift) } else { wave(waves[0], 0.0) };
            let surface = Surface::from_form(&form).unwrap();
            let side = Side::of(Vec3::z() * 40.0, &surface);
            let corner = [0.0, 0.5, 2.0][corner];
            let profile = Profile::new(&Cutter::mill(20.0, corner, 60.0)).unwrap();
            let ta = Vec3::new(0.03 * lean * f64::from(u8::from(lean > 0.0)), 0.0, 1.0).normalize();
            // Base lines and rulings are even over x and y.
            let on = |p: Vec3| match &surface {
                Surface::Parametric(s) => s.place([(p.x + 50.0) / 100.0, (p.y + 30.0) / 60.0]).point,
                s => s.foot(p).point,
            };
            let rows = if ruled { 4 } else { 0 };
            for step in 0..16 {
                let te = Vec3::new(x + 1.7 * f64::from(step), 5.0 * y, 2.5);
                let tool = Tool { profile: &profile, te, ta };
                let found = gap(&tool, &surface, side, 0.0).unwrap();
                let mut least = f64::INFINITY;
                for i in -300..=300 {
                    for k in -rows..=rows {
                        let beside = Vec3::new(f64::from(i) * 0.04, f64::from(k) * 2.5, -te.z);
                        least = least.min(tool.distance(on(te + beside)));
                    }
                }
                prop_assert!(found.raw <= least + 1e-9, "{least} {found:?}");
                prop_assert!(found.raw >= least - 0.1, "{least} {found:?}");
            }
        }
    }
}
