//! One cut vector against a surface with charts.

mod edges;
mod side;
mod sunk;

use aptc_cldata::Position;

use crate::between::Way;
use crate::deep::{deepest, inside};
use crate::demand::Verdict;
use crate::each::two;
use crate::outside::Stood;
use crate::pile::Pile;
use crate::search::{Aim, FINE_FOLD, FOLD, Lead, Moved, TURNED, clearance_from};
use crate::sheet::{Sheet, Spot};
use crate::sweep::Sweep;
use crate::tool::{Pose, Tool};
use crate::upright::distances;
use crate::witness::{Excess, Near, excess};

/// Halvings of a vector whose axis turns.
const DEPTH: u32 = 22;
/// Halvings of a vector along which the surface was not searched to the end.
const LONG: u32 = 5;
/// The same where the axis turns: what the turn takes falls with the square of the length.
const LONG_TURNING: u32 = 9;
/// Stretches of one vector that are looked at.
const MOST: u32 = 2000;

/// A surface with charts and what is asked of the gap to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Curved<'s> {
    pub(crate) sheet: &'s Sheet,
    /// The side of the tool.
    pub(crate) side: f64,
    /// Is the tool end alone concerned?
    pub(crate) on: bool,
    /// The gap at the working surface: the thickness of a POLCON.
    pub(crate) moved: f64,
    pub(crate) least: f64,
    pub(crate) most: f64,
}

/// What a vector found, where the next of the same tool along the same surface is best begun. A bad beginning costs time;
/// what is known of a position is taken as it stands, so that one of these serves one tool and one surface.
#[derive(Clone, Debug, Default)]
pub(crate) struct Warm {
    pub(crate) lead: Lead,
    /// The places of the surface next to the tool where it began and where it ended.
    near: Option<[Near; 2]>,
    /// That it is nowhere too far was shown by points of the tool alone.
    sunk: bool,
    /// What may be allowed for the turn of the axis on one stretch.
    pub(crate) stretch: Option<f64>,
    /// The least gap that was told before, if any: beside a convex solid no greater one is told closer.
    pub(crate) told: Option<f64>,
    /// What is known where the last vector ended, outside of a convex solid.
    pub(crate) end: Option<Stood>,
}

impl Warm {
    /// Nothing is known of the places next to the next vector.
    pub(crate) fn forget(&mut self) {
        self.near = None;
    }

    /// Of a vector of which no bound is told.
    pub(crate) fn silent() -> Self {
        Self { told: Some(f64::NEG_INFINITY), ..Self::default() }
    }
}

/// What came of one bound.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Half {
    /// It holds; the gap is nowhere beyond this.
    Holds(f64),
    /// It does not: share of the way, gap there.
    Broken(f64, f64),
    /// By how much it may be broken, and where.
    Open(f64, f64),
}

impl Curved<'_> {
    /// Judges the vector; `pad` covers rounding.
    pub(crate) fn judge(
        &self,
        tool: &Tool<'_>,
        a: &Position,
        b: &Position,
        pad: f64,
        warm: &mut Warm,
    ) -> Verdict {
        let ends = tool.ends(a, b);
        let way = Way::new(ends[0], ends[1]);
        let (world, turn) = (|t: f64| way.at(t), way.turn);
        let [begin, end] = [self.sheet.local(&world(0.0)), self.sheet.local(&world(1.0))];
        let pose = |t: f64| match t {
            t if t <= 0.0 => begin,
            t if t >= 1.0 => end,
            t => self.sheet.local(&world(t)),
        };
        if ends[0].ta.dot(&ends[1].ta) > 0.0
            && let Some([low, high]) = self.upright(tool, [&pose(0.0), &pose(1.0)], pad, warm)
        {
            return Verdict::Proved { low, high };
        }
        // A tool that is to be in the surface, as a disk is, is looked at from its own side first once that has told.
        let by_points = if warm.sunk { self.sunk(tool, &pose, turn, pad) } else { None };
        let by_points = by_points.filter(|half| matches!(half, Half::Holds(_)));
        if by_points.is_some() {
            warm.forget();
        }
        let asked = !self.on && by_points.is_none();
        let above = asked.then(|| self.excess(tool, &pose, turn, pad, warm));
        let low = self.not_below(tool, self.side, self.least, &pose, turn, pad, warm);
        let low = worst(low, self.least, |least| {
            let warm = &mut Warm::default();
            self.not_below(tool, self.side, least, &pose, turn, pad, warm)
        });
        // A point has the same distance from both sides.
        let cut = matches!(low, Half::Broken(..));
        let high = match (by_points, above) {
            (Some(held), _) => held,
            (None, None) => {
                let above = |most: f64| {
                    let warm = &mut Warm::default();
                    self.not_below(tool, -self.side, most, &pose, turn, pad, warm)
                };
                match worst(above(-self.most), -self.most, above) {
                    Half::Holds(g) => Half::Holds(-g),
                    Half::Broken(t, g) => Half::Broken(t, -g),
                    open @ Half::Open(..) => open,
                }
            }
            (None, Some(found)) => self.not_above(tool, &pose, turn, pad, cut, found),
        };
        let touched = matches!(above, None | Some(Excess::Within(_)));
        warm.sunk = by_points.is_some() || !touched && matches!(high, Half::Holds(_));
        match (low, high) {
            (Half::Broken(t, g), Half::Broken(s, h)) => {
                let deeper = self.least - g >= h - self.most;
                let (t, gap) = if deeper { (t, g) } else { (s, h) };
                Verdict::Refuted { gap, te: world(t).te }
            }
            (Half::Broken(t, gap), _) | (_, Half::Broken(t, gap)) => {
                Verdict::Refuted { gap, te: world(t).te }
            }
            (Half::Open(t, at_most), _) | (_, Half::Open(t, at_most)) => {
                Verdict::Undecided { at_most, te: world(t).te }
            }
            (Half::Holds(low), Half::Holds(high)) => Verdict::Proved { low, high },
        }
    }

    /// Least and greatest gap of a cutter that stands along the generatrix of a TABCYL, when they are within what is
    /// allowed; `None` where nothing is known of a vector before, and where they are not shown so.
    fn upright(
        &self,
        tool: &Tool<'_>,
        [a, b]: [&Pose; 2],
        pad: f64,
        warm: &mut Warm,
    ) -> Option<[f64; 2]> {
        let curve = self.sheet.curve()?;
        let near = warm.near?[1].spot;
        // How far the tool reaches sideways where its axis leans by rounding.
        let leans = two([a, b], |pose| tool.reach() * pose.ta.xy().norm());
        if self.on || leans[0].max(leans[1]) > 0.5 * pad {
            return None;
        }
        let (widest, pad) = (tool.widest(), 0.5 * pad);
        let limits = [widest + self.least - pad, widest + self.most + pad];
        let ([low, high], near) =
            distances(curve, self.side, [a.te.xy(), b.te.xy()], limits, &near)?;
        warm.near = Some(near.map(|spot| Near { spot, touch: None }));
        Some([low - widest, high - widest])
    }

    /// The gap at a position, from below and to a thousandth of the tool; `None` when it is not found.
    pub(crate) fn gap(&self, tool: &Tool<'_>, pose: &Pose) -> Option<f64> {
        let pose = self.sheet.local(pose);
        // Nothing is near enough to end the search before the nearest is found.
        let enough = 4.0 * tool.reach().max(self.most.abs().min(1.0));
        let nearest = self.next_to(tool, &pose, enough);
        let (distance, spot) = nearest?;
        let inner = pose.te + pose.ta * (0.5 * tool.reach());
        let right = if self.on { pose.te } else { inner };
        let sign = self.sheet.sign(right).unwrap_or_else(|| self.facing(tool, &pose, &spot));
        let sign = sign * self.side;
        if self.on { Some(sign * distance) } else { (sign > 0.0).then_some(distance.min(enough)) }
    }

    /// That the gap is nowhere below `least`, the tool on the side `side`.
    #[expect(clippy::too_many_arguments, reason = "one bound and all that it hangs on")]
    fn not_below(
        &self,
        tool: &Tool<'_>,
        side: f64,
        least: f64,
        pose: &dyn Fn(f64) -> Pose,
        turn: f64,
        pad: f64,
        warm: &mut Warm,
    ) -> Half {
        let judge = |fold: f64, warm: &mut Warm| {
            self.not_below_but(tool, side, least, pose, turn, pad, fold, warm)
        };
        match judge(FOLD, warm) {
            // What looked like a fold may be a piece that is still too large.
            Half::Open(_, at_most) if at_most.is_finite() => judge(FINE_FOLD, warm),
            told => told,
        }
    }

    /// The same; pieces smaller than the share `fold` of the shift count as folds.
    #[expect(clippy::too_many_arguments, reason = "one bound and all that it hangs on")]
    fn not_below_but(
        &self,
        tool: &Tool<'_>,
        side: f64,
        least: f64,
        pose: &dyn Fn(f64) -> Pose,
        turn: f64,
        pad: f64,
        fold: f64,
        warm: &mut Warm,
    ) -> Half {
        if least == f64::NEG_INFINITY {
            return Half::Holds(f64::NEG_INFINITY);
        }
        // A tool without thickness would pass through the surface without holding any of its points: the
        // surface is moved farther back, and the tool stays farther away from it. At an edge what is moved out to the side of the
        // tool gapes: there it stays away from the surface itself.
        let held = self.held(tool, [&pose(0.0), &pose(1.0)], turn, side, least, pad);
        let (sheet, shift) = (self.sheet, held.least - held.thin);
        // A tool that stays away by more than rounding is held off by all of it.
        let overlaps = held.thin <= 0.0 && held.edges.is_some() && sheet.curve().is_some();
        let moved = Moved { sheet, side, shift, fold, overlaps, only: None };
        // Both the surface farther back and the distance from it are rounded.
        let thin = held.thin;
        let enough = if thin > 0.0 { thin - 2.0 * pad } else { -pad };
        let mut low = f64::INFINITY;
        let mut open = (0.0, 0.0);
        let mut stack = Pile::<(f64, f64, u32), 32>::new();
        stack.push((0.0, 1.0, 0));
        let mut seen = 0;
        while let Some((t0, t1, depth)) = stack.pop() {
            seen += 1;
            let bend = turn * (t1 - t0);
            let sweep = Sweep::new(tool, pose(t0), pose(t1), bend);
            let turned = sweep.turned();
            let mut found = clearance_from(&sweep, &moved, enough, Aim::Clear, &mut warm.lead);
            let mut shown = found.least - thin;
            if found.least >= enough
                && let Some(near) = held.edges
            {
                found = self.clear_of_edges(tool, near, &sweep, &moved, enough);
                shown = shown.min(found.least - thin);
            }
            if found.least >= enough {
                low = low.min(held.least + shown);
                continue;
            }
            if let Some((distance, t, spot)) = found.nearest
                && distance < enough
            {
                let t = t0 + t * (t1 - t0);
                let pose = pose(t);
                let distance = tool.near(&pose, moved.place(&spot)).0;
                let spot = self.sheet.on_face(spot);
                let gap = if distance < enough {
                    self.confirm(tool, side, least, &pose, &spot, distance - thin, pad)
                } else {
                    None
                };
                match gap {
                    Some(gap) => return Half::Broken(t, gap),
                    // On its chord it is too near, on its way it is not.
                    None if distance >= enough && sweep.turn > 0.0 && depth < DEPTH => {}
                    None => {
                        open = widest(open, (t, thin - distance));
                        continue;
                    }
                }
            }
            // Where much more is missing than what the turn takes, shorter stretches do not help; they do where
            // the search came to no end.
            let helps = if shown == f64::NEG_INFINITY {
                depth < if sweep.turn > 0.0 { LONG_TURNING } else { LONG }
            } else {
                sweep.turn > 0.0 && -shown <= TURNED * turned && depth < DEPTH
            };
            if helps && seen < MOST {
                let m = 0.5 * (t0 + t1);
                stack.push((m, t1, depth + 1));
                stack.push((t0, m, depth + 1));
            } else {
                open = widest(open, (t0, -shown));
            }
        }
        if open.1 > 0.0 {
            return Half::Open(open.0, open.1);
        }
        // Nothing of the surface is in the tool: it is wholly on one side.
        let start = pose(0.0);
        let inner = tool.inner(&start);
        let near = least.abs() + pad;
        // The edge of a disk may be in the surface by the tolerance; its middle is on the side that counts.
        let sign = self.sheet.sign(inner).unwrap_or_else(|| {
            let first = if tool.is_thin() {
                self.lies(inner, near)
            } else if self.sheet.edged().is_some() {
                // Another face may be nearer.
                0.0
            } else {
                warm.near.map_or(0.0, |near| Self::faces(tool, &start, &near[0].jet(self.sheet)))
            };
            let then = if first == 0.0 { self.stands(tool, &start) } else { first };
            if then == 0.0 { self.lies_about(tool, &start, near) } else { then }
        });
        let sign = sign * side;
        if sign >= 0.0 && least > 0.0 && thin <= 0.0 {
            return self.farther(inner, sign, least, low, pad);
        }
        if sign > 0.0 || self.nearest(inner, 2.0 * near).0 <= near {
            Half::Holds(low)
        } else if sign < 0.0 {
            Half::Broken(0.0, -self.beyond(inner, near.max(tool.reach())).0)
        } else {
            Half::Open(0.0, f64::INFINITY)
        }
    }

    /// How much farther back the surface is moved for a tool without thickness.
    fn back(&self, least: f64, pad: f64) -> f64 {
        let band = self.most - self.least;
        let band = if band.is_finite() { band } else { 0.0 };
        // Seen from its other side the surface that is moved lies the other way.
        let beside = (least - self.moved).abs().min((least + self.moved).abs());
        (4.0 * beside).max(4.0 * band).max(1e3 * pad)
    }

    /// A place of the surface moved by `least` is in the tool by `-inside_by`. The gap where that means what it
    /// seems to; moved surfaces fold where the surface is bent too much.
    #[expect(clippy::too_many_arguments, reason = "one place and all that is known of it")]
    fn confirm(
        &self,
        tool: &Tool<'_>,
        side: f64,
        least: f64,
        pose: &Pose,
        spot: &Spot,
        inside_by: f64,
        pad: f64,
    ) -> Option<f64> {
        let seen = least + inside_by;
        let deep = deepest(tool, pose, self.sheet, side, *spot, least - pad);
        // Of a surface moved towards the tool the place itself is as near, on whichever side.
        let known = (least >= 0.0 && !tool.is_thin()).then_some(seen);
        if let Some(seen) = known.filter(|_| deep.gap >= 0.0) {
            return Some(seen.min((deep.p - self.sheet.jet(&deep.spot).p).norm()));
        }
        // How far the deepest point of the tool is from the whole surface.
        let near = inside_by.abs().max(deep.gap.abs()) + least.abs();
        let (far, place) = self.nearest(deep.p, 2.0 * near);
        let off = || Some(self.off(deep.p, &place?).signum());
        // Beside an edge what is deep below the one face is far from it.
        let Some(sign) = self.sheet.sign(deep.p).or_else(off) else { return known };
        let gap = if sign * side > 0.0 { far } else { -far };
        // An edge is deeper in the tool than the tool is below the faces beside it.
        let place = match self.sheet.edged() {
            Some(_) => inside(tool, pose, self.sheet, *spot, least.abs().max(inside_by.abs())),
            None => tool.near(pose, self.sheet.jet(spot).p).0,
        };
        let gap = match tool.is_thin() {
            true => gap,
            false if least >= 0.0 => gap.min(seen),
            false => gap.min(place),
        };
        (gap < least - pad).then_some(gap)
    }

    /// The greatest gap along the vector. Where that is in the band, the places that are met show the direction
    /// that parts tool and surface.
    fn excess(
        &self,
        tool: &Tool<'_>,
        pose: &dyn Fn(f64) -> Pose,
        turn: f64,
        pad: f64,
        warm: &mut Warm,
    ) -> Excess {
        if self.most == f64::INFINITY {
            return Excess::Within(f64::INFINITY);
        }
        let most = self.most + pad;
        let found = excess(tool, self.sheet, self.side, pose, turn, most, &mut warm.near);
        if let Some(near) = &warm.near {
            let [a, b] = two(*near, |near| near.jet(self.sheet));
            if let Some(m) = (a.n + b.n).try_normalize(1e-3) {
                let sweep = Sweep::new(tool, pose(0.0), pose(1.0), turn);
                warm.lead.direction = Some(sweep.square(m * -self.side, a.p));
                let told = [(near[0].spot, a.n * -self.side), (near[1].spot, b.n * -self.side)];
                warm.lead.begin.tell(told);
            }
        }
        found
    }

    /// That the gap is nowhere above the greatest allowed; looked at less closely where the tool cuts in anyway.
    fn not_above(
        &self,
        tool: &Tool<'_>,
        pose: &dyn Fn(f64) -> Pose,
        turn: f64,
        pad: f64,
        cut: bool,
        found: Excess,
    ) -> Half {
        // A tool without thickness may lie behind the surface, within the band: its distance has no sign.
        if let Excess::Beyond(t, gap) = found
            && self.most >= 0.0
            && !tool.is_thin()
        {
            return Half::Broken(t, gap);
        }
        match found {
            Excess::Within(high) => Half::Holds(high),
            // How deep the tool is in the surface is not how deep the surface is in the tool.
            Excess::Beyond(t, gap) | Excess::Open(t, gap) => {
                let sunk = if cut { None } else { self.sunk(tool, pose, turn, pad) };
                sunk.unwrap_or(Half::Open(t, gap - self.most))
            }
        }
    }
}

/// The deepest place to a tenth, of what one was found that is too deep: more is asked for until no place is as deep.
pub(crate) fn worst(first: Half, least: f64, judge: impl Fn(f64) -> Half) -> Half {
    /// Times that it is asked.
    const TIMES: u32 = 8;
    let Half::Broken(mut t, mut gap) = first else { return first };
    for _ in 0..TIMES {
        match judge(gap - 0.1 * (least - gap)) {
            Half::Broken(s, deeper) if deeper < gap => (t, gap) = (s, deeper),
            _ => break,
        }
    }
    Half::Broken(t, gap)
}

fn widest(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    if b.1 > a.1 { b } else { a }
}

#[cfg(test)]
#[path = "curved_tests.rs"]
mod tests;
