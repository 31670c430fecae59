//! CHKSRF of planes, spheres, cylinders and the other surfaces that are not sculptured.

use std::sync::Arc;

use aptc_contact::{Condition, Side, Swept, Tool, axis_between, bulge, chord, gap};
use aptc_geometry::surface::kept;
use aptc_geometry::{Form, Profile, Surface, Vec3, trig};

use crate::inside::{FEW, FIRST, Inside, MOST, SOON, hull, inside};

/// Such a surface.
#[derive(Clone, Debug)]
pub(crate) struct Plain {
    pub(crate) name: String,
    pub(crate) form: Arc<Form>,
    /// Its inside, if it has one, is on its negative side.
    pub(crate) surface: Arc<Surface>,
    /// From where the tool comes; `None` where nothing is known of it.
    pub(crate) from: Option<Came>,
    /// Left on it: the thickness of check surfaces.
    pub(crate) thick: f64,
}

/// From where the tool comes to a statement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Came {
    pub(crate) te: Vec3,
    /// The side of the surface to which it keeps, by [`kept`]; `None` of one that has no sides.
    pub(crate) side: Option<f64>,
}

/// How deep a solid gets in such a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Depth {
    pub(crate) depth: f64,
    /// Tool end there.
    pub(crate) te: Vec3,
    /// A place of the surface that is so deep in the solid, where one is known; of what has sides none, as it is in the solid on one
    /// of them and may count for nothing on another.
    pub(crate) place: Option<Vec3>,
}

/// How long a way is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Patience {
    /// Until it is known, as far as that can be.
    Full,
    /// Not long: it is one of many that would do.
    Short,
}

/// Halvings of a way with a turning axis.
const HALVINGS: u32 = 22;
/// Stretches of it; beside what has no sides, where each takes long and a shorter way tells sooner; where another way would do as
/// well; and those on which it is asked what is in the tool.
const STRETCHES: u32 = 4000;
const UNSIDED: u32 = 2000;
const ANOTHER: u32 = 60;
const SEARCHES: u32 = 200;
/// Part of what is allowed to which the least gap of a way is found.
const FINE: f64 = 1e-3;

impl Plain {
    /// The surface of a form; `None` of what cannot be checked.
    pub(crate) fn new(name: String, form: &Arc<Form>) -> Option<Self> {
        let surface = Surface::from_form(form)?;
        let surface = Arc::new(kept::with_inside(&surface).unwrap_or(surface));
        Some(Self { name, form: Arc::clone(form), surface, from: None, thick: 0.0 })
    }

    /// The tool comes to a statement from there.
    pub(crate) fn come_from(&mut self, cutter: &Profile, at: (Vec3, Vec3), allowed: f64) {
        self.from = Some(Came { te: at.0, side: self.side(cutter, at, allowed) });
    }

    fn side(&self, cutter: &Profile, at: (Vec3, Vec3), allowed: f64) -> Option<f64> {
        kept::side_from(&self.surface, cutter, at, allowed)
    }

    /// From where a tool came that stands with its lower end in a solid which could be a bowl or a trough, if it came
    /// from outside.
    pub(crate) fn entered(&self, cutter: &Profile, at: (Vec3, Vec3)) -> Option<Vec3> {
        let from = self.from.filter(|from| from.side.is_some_and(|side| side > 0.0))?;
        let inside = self.surface.distance(kept::lower_end(cutter, at)) < 0.0;
        (inside && kept::opens(&self.surface, at.1)).then_some(from.te)
    }

    /// How deep a solid whose lower end is `up` above the tool end gets into the surface on its way, and where (of what is
    /// found box by box where the way begins), if that is deeper than `intol` less the thickness on it; negative where it is but nearer
    /// than that. What cannot be computed is not taken for clear: its depth is infinite.
    ///
    /// A stretch of the way is held against the surface with the axis of its middle, which is off by first order in the
    /// turn, and by what its ends bound, off by second order ([`Plain::between`]).
    pub(crate) fn deep(
        &self,
        cutter: &Profile,
        (profile, up): (&Profile, f64),
        [a, b]: [(Vec3, Vec3); 2],
        intol: f64,
        patience: Patience,
    ) -> Option<Depth> {
        let beyond_it = |depth: f64, te: Vec3| Some(Depth { depth, te, place: None });
        let allowed = intol - self.thick;
        let reach = profile.reach();
        let axis = |t: f64| match t {
            0.0 => a.1,
            1.0 => b.1,
            _ => axis_between(a.1, b.1, t),
        };
        // Of a tool that comes from nowhere its first place tells.
        let kept = self.from.map_or_else(|| self.side(cutter, a, intol), |from| from.side);
        let side = match kept {
            Some(side) if side > 0.0 => Side::Positive,
            // A trough along which the tool comes to stand is a bore.
            Some(_) if kept::opens(&self.surface, axis(0.5)) => Side::Open,
            Some(_) => Side::Negative,
            None => Side::of(a.0 + a.1 * (up + 0.5 * reach), &self.surface),
        };
        if let (Surface::Quadric(s), Some(_)) = (&*self.surface, kept) {
            // The search for its nearest place begins on the side that is asked for.
            let beyond = |(te, ta): (Vec3, Vec3)| {
                let middle = te + ta * (up + 0.5 * (profile.bottom() + profile.height()));
                let wall = if side == Side::Open { s.opened(ta) } else { None };
                let foot = wall.map_or_else(|| s.foot(middle), |wall| wall.foot(middle));
                -side.sign() * foot.distance
            };
            let deepest = [a, b].map(|at| (beyond(at), at.0));
            let deepest = if deepest[1].0 > deepest[0].0 { deepest[1] } else { deepest[0] };
            if deepest.0 > allowed {
                return beyond_it(deepest.0, deepest.1);
            }
        }
        let fine = FINE * allowed.abs().max(1e-6 * reach);
        let turns = (a.1 - b.1).norm() > 1e-12;
        let at = |(te, ta): (Vec3, Vec3)| Tool { profile, te: te + ta * up, ta };
        let here = |t: f64| {
            let (te, ta) = (a.0 + (b.0 - a.0) * t, axis(t));
            let g = gap(&at((te, ta)), &self.surface, side, 0.0).ok().map(|gap| gap.g);
            Stood { t, te, ta, g }
        };
        // What is in the tool on a stretch, whatever faces it. What lies above a hollow that is open counts for nothing.
        let search = |from: Vec3, to: Vec3, ta: Vec3, slack: f64, most: usize| {
            let body = Swept { tool: at((from, ta)), by: to - from };
            let about = about(hull(profile, &body.tool, body.by), allowed);
            match inside(&body, about, &self.surface, (allowed, slack, intol), most) {
                Inside::Deep(..) if side == Side::Open => Inside::Unknown,
                found => found,
            }
        };
        // Far from what has no sides there is nothing to ask, and what is found in the tool needs no place that faces it.
        let (half, far) = (axis(0.5), trig::angle_between(a.1, b.1) * (up.abs() + reach));
        let most = match patience {
            Patience::Short => ANOTHER,
            Patience::Full if kept.is_none() => UNSIDED,
            Patience::Full => STRETCHES,
        };
        if kept.is_none() {
            match search(a.0, b.0, half, far, if turns { FIRST } else { SOON }) {
                Inside::Nothing => return None,
                Inside::Deep(depth, place) => {
                    return Some(Depth { depth, te: a.0, place: Some(place) });
                }
                Inside::Unknown => {}
            }
        }
        // The gaps at the ends bound what turns, and nothing else.
        let end = |t: f64, (te, ta)| if turns { here(t) } else { Stood { t, te, ta, g: None } };
        let mut stack = vec![(end(0.0, a), end(1.0, b), 0_u32)];
        let (mut stretches, mut searches) = (0, 0);
        while let Some((p, q, halvings)) = stack.pop() {
            stretches += 1;
            if let (true, Some(g), Some(other)) = (turns, p.g, q.g) {
                let (g, te) = if g < other { (g, p.te) } else { (other, q.te) };
                if kept.is_some() && g < -allowed {
                    return beyond_it(-g, te);
                }
                if self.between(side, (profile, up), [(p, g), (q, other)]) >= -allowed {
                    continue;
                }
            }
            let half = 0.5 * (p.t + q.t);
            let mid = axis(half);
            let turn = trig::sin(0.25 * trig::angle_between(p.ta, q.ta)) * 2.0;
            let slack = if turns { turn * (up + 2.0 * reach) } else { 0.0 };
            let low = if p.te == q.te {
                gap(&at((p.te, mid)), &self.surface, side, 0.0).map(|g| (g.g, p.te))
            } else {
                let (from, to) = (at((p.te, mid)), at((q.te, mid)));
                let touch = Condition::Touch;
                let found = chord(&from, &to, &self.surface, touch, side, 0.0, None, fine);
                found.map(|c| (c.low.g, p.te + (q.te - p.te) * c.low.t))
            };
            let (mut te, mut deep) = (p.te, true);
            if let Ok((low, at)) = &low {
                let low = *low;
                if low - slack >= -allowed {
                    continue;
                }
                te = *at;
                deep = low + slack < -allowed;
                if kept.is_some() && deep {
                    return beyond_it(-low, te);
                }
            }
            // Of what has no sides the place that faces the tool may be behind it.
            if deep {
                searches += 1;
                let few = turns || low.is_ok() || patience == Patience::Short;
                let boxes = if few { FEW } else { MOST };
                match search(p.te, q.te, mid, slack, boxes) {
                    Inside::Nothing => continue,
                    // It is the first place found. What faces the tool may be far off: how deep it is along its normal
                    // is no depth of the tool.
                    Inside::Deep(depth, place) => {
                        let place = kept.is_none().then_some(place);
                        return Some(Depth { depth, te, place });
                    }
                    Inside::Unknown => {}
                }
            }
            if let (true, false, Ok((_, te))) = (deep, turns, low) {
                // How deep the place that faces the tool really is in it.
                let tool = at((te, mid));
                let facing = gap(&tool, &self.surface, side, 0.0).ok();
                let depth = facing.map_or(0.0, |gap| -tool.distance(gap.surface_point));
                return beyond_it(if depth > allowed { depth } else { f64::INFINITY }, te);
            }
            let tried = halvings >= HALVINGS || stretches > most || searches > SEARCHES;
            if !turns || tried {
                return beyond_it(f64::INFINITY, te);
            }
            let m = here(half);
            stack.push((m, q, halvings + 1));
            stack.push((p, m, halvings + 1));
        }
        None
    }

    /// What the gap does not fall below between two places of a tool that turns, from those at the places; negative infinity
    /// where nothing is known.
    ///
    /// A point of the tool, at most `far` from the tool end, leaves its chord by no more than `turn^2 far / 8` in the middle
    /// and by the part 4 t (1 - t) of it elsewhere. Along the chord its distance from the wall of a convex hollow, or from a
    /// plane, is concave. From a solid that is made of balls of a radius R the distance less R is that from a convex set, whose
    /// second derivative along a line is at most one over the distance, as that from any set is (R being 0); between ends at
    /// `d` and a length `l` apart that is `sqrt(d^2 - l^2 / 4)` at least. A bowl that is open along the axis moves without turning as the tool sees it, so far as its middle does.
    fn between(
        &self,
        side: Side,
        (profile, up): (&Profile, f64),
        [(p, low), (q, high)]: [(Stood, f64); 2],
    ) -> f64 {
        let (low, high) = (low.min(high), low.max(high));
        let surface = &*self.surface;
        let turn = trig::angle_between(p.ta, q.ta);
        let (way, far) = ((q.te - p.te).norm(), up.abs() + profile.reach());
        let rise = match (side, surface) {
            (Side::Open, Surface::Sphere(s)) => {
                let away = (s.center - p.te).norm().max((s.center - q.te).norm());
                bulge(turn, away, way)
            }
            (Side::Open, _) => f64::INFINITY,
            (Side::Negative, _) if surface.convex() => bulge(turn, far, 0.0),
            (Side::Positive, _) if surface.concave() => bulge(turn, far, 0.0),
            (Side::Positive | Side::Negative, _) => {
                let length = way + 2.0 * trig::sin(0.5 * turn) * far;
                let round = if side == Side::Positive { roundness(surface) } else { 0.0 };
                let end = (round + low).max(0.0);
                let least = (end * end - 0.25 * length * length).max(0.0).sqrt();
                bulge(turn, far, 0.0) + length * length / (8.0 * least)
            }
        };
        if !rise.is_finite() {
            return f64::NEG_INFINITY;
        }
        // The line between both less a parabola.
        let apart = high - low;
        if 4.0 * rise <= apart {
            return low;
        }
        let lean = apart / (4.0 * rise);
        0.5 * (low + high) - rise * (1.0 + lean * lean)
    }
}

/// A place of a way with the gap there.
#[derive(Clone, Copy, Debug)]
struct Stood {
    /// Share of the way.
    t: f64,
    te: Vec3,
    ta: Vec3,
    /// `None` where no place of the surface faces the tool.
    g: Option<f64>,
}

/// A box about what is deeper in a tool than `allowed`, from the box about the tool: what is negative is beside it.
pub(crate) fn about([low, high]: [Vec3; 2], allowed: f64) -> [Vec3; 2] {
    let beside = (-allowed).max(0.0);
    [low.add_scalar(-beside), high.add_scalar(beside)]
}

/// The radius of balls of which the solid on the negative side is made: its least radius of curvature. 0 where it has
/// edges, or is not known.
fn roundness(surface: &Surface) -> f64 {
    match surface {
        Surface::Sphere(s) => s.radius,
        Surface::Cylinder(s) => s.radius,
        Surface::Quadric(s) if s.convexity() > 0 => {
            let (_, lambda, beta, constant) = s.principal();
            let turned = if lambda.x < 0.0 { -1.0 } else { 1.0 };
            if lambda.iter().any(|l| l * turned <= 0.0) {
                return 0.0;
            }
            // Of an ellipsoid, the square of the least half axis over the greatest.
            let size = beta.component_mul(&beta).component_div(&lambda).sum() - constant;
            let squares = lambda.map(|l| size / l);
            if squares.min() > 0.0 { squares.min() / squares.max().sqrt() } else { 0.0 }
        }
        _ => 0.0,
    }
}

#[cfg(test)]
#[path = "plain_tests.rs"]
mod tests;
