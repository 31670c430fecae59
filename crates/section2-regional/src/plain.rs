//! CHKSRF of planes, spheres, cylinders and the other surfaces that are not sculptured.

use std::sync::Arc;

use aptc_contact::{Condition, Side, Tool, chord, gap};
use aptc_geometry::surface::kept;
use aptc_geometry::{Form, Profile, Surface, Vec3, trig};

/// Such a surface.
#[derive(Clone, Debug)]
pub(crate) struct Plain {
    pub(crate) name: String,
    pub(crate) form: Arc<Form>,
    /// Its inside, if it has one, is on its negative side.
    pub(crate) surface: Arc<Surface>,
    /// From where the tool comes; `None` where nothing is known of it.
    pub(crate) from: Option<Came>,
}

/// From where the tool comes to a statement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Came {
    pub(crate) te: Vec3,
    /// The side of the surface to which it keeps, by [`kept`]; `None` of one that has no sides.
    pub(crate) side: Option<f64>,
}

/// Halvings of a way with a turning axis.
const HALVINGS: u32 = 14;
/// Stretches of it.
const STRETCHES: u32 = 4000;
/// Part of what is allowed to which the least gap of a way is found.
const FINE: f64 = 1e-3;

impl Plain {
    /// The surface of a form; `None` of what cannot be checked.
    pub(crate) fn new(name: String, form: &Arc<Form>) -> Option<Self> {
        let surface = Surface::from_form(form)?;
        let surface = Arc::new(kept::with_inside(&surface).unwrap_or(surface));
        Some(Self { name, form: Arc::clone(form), surface, from: None })
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

    /// How deep a solid whose lower end is `up` above the tool end gets into the surface on its way, and where,
    /// if that is deeper than `allowed`. What cannot be computed is not taken for clear.
    pub(crate) fn deep(
        &self,
        cutter: &Profile,
        (profile, up): (&Profile, f64),
        [a, b]: [(Vec3, Vec3); 2],
        allowed: f64,
    ) -> Option<(f64, Vec3)> {
        let reach = profile.reach();
        let axis = |t: f64| (a.1 * (1.0 - t) + b.1 * t).try_normalize(1e-9).unwrap_or(a.1);
        // Of a tool that comes from nowhere its first place tells.
        let kept = self.from.map_or_else(|| self.side(cutter, a, allowed), |from| from.side);
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
                return Some(deepest);
            }
        }
        let fine = FINE * allowed.abs().max(1e-6 * reach);
        let place = |t: f64| (a.0 + (b.0 - a.0) * t, axis(t));
        let mut stack = vec![(0.0, 1.0, 0_u32)];
        let mut stretches = 0;
        while let Some((from, to, halvings)) = stack.pop() {
            stretches += 1;
            let ends = [place(from), place(to)];
            let mid = axis(0.5 * (from + to));
            let turn = trig::sin(0.25 * trig::acos_clamped(ends[0].1.dot(&ends[1].1))) * 2.0;
            let slack = turn * (up + 2.0 * reach);
            let at = |te: Vec3| Tool { profile, te: te + mid * up, ta: mid };
            let tool = at(ends[0].0);
            let low = if ends[0].0 == ends[1].0 {
                gap(&tool, &self.surface, side, 0.0).map(|g| g.g)
            } else {
                let end = at(ends[1].0);
                let touch = Condition::Touch;
                chord(&tool, &end, &self.surface, touch, side, 0.0, None, fine).map(|c| c.low.g)
            };
            let Ok(low) = low else { return Some((f64::INFINITY, ends[0].0)) };
            if low - slack >= -allowed {
                continue;
            }
            if low + slack < -allowed || halvings >= HALVINGS || stretches > STRETCHES {
                return Some((-low, ends[1].0));
            }
            let half = 0.5 * (from + to);
            stack.push((half, to, halvings + 1));
            stack.push((from, half, halvings + 1));
        }
        None
    }
}

#[cfg(test)]
#[path = "plain_tests.rs"]
mod tests;
