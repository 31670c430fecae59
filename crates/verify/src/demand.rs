//! One cut vector against one surface: proved, refuted or not decided.

use std::sync::Arc;

use aptc_cldata::{Controlled, Position, Relation};
use aptc_geometry::surface::QuadricSurface;
use aptc_geometry::{Form, Plane, Profile, Quadric, Vec3};

use crate::between::{NO_TURN, Way, between_poses};
use crate::bound::{Bound, Touch};
use crate::curved::{Curved, Warm};
use crate::inside::{self, Walls};
use crate::level::{self, Run};
use crate::outside::{self, Outside};
use crate::oval::Oval;
use crate::pile::Pile;
use crate::sheet::{Sheet, Spot};
use crate::sheets::Sheets;
use crate::solid::Solid;
use crate::tool::{Pose, Tool, Turn, same};

/// Stretches of a vector that wait, from, to and how often halved: never more than one a halving.
type Stack = Pile<(Stop, Stop, u32), 32>;

/// A place of a vector: its share of the way, the tool there, and what serves both stretches that meet there.
#[derive(Clone, Copy, Debug)]
struct Stop {
    t: f64,
    pose: Pose,
    touch: Option<Touch>,
}

/// What is asked of the gap to a surface.
#[derive(Clone, Debug)]
pub(crate) struct Demand {
    /// What the surface is held to be.
    body: Body,
    /// The side of the tool, +1 or -1.
    side: f64,
    /// Is the tool inside of it?
    within: bool,
    /// Is that inside open along the tool axis?
    open: bool,
    /// Is the tool end alone concerned (ON)?
    on: bool,
    /// The gap at the working surface: the thickness of a POLCON.
    pub(crate) moved: f64,
    /// Least and greatest gap allowed.
    pub(crate) least: f64,
    pub(crate) most: f64,
}

/// What is known of a surface.
#[derive(Clone, Debug)]
enum Body {
    /// It bounds a convex solid with a support function.
    Solid(Solid),
    /// Inside of a convex quadric that is open along the tool axis.
    Hollow(Oval),
    /// It has charts. The convex side of a quadric, outside of which the tool is or inside, is tried first.
    Sheet(Arc<Sheet>, Option<(Oval, Side)>),
    /// Nothing that could be proved against.
    Unknown,
}

/// The side of a convex quadric on which the tool is.
#[derive(Clone, Copy, Debug)]
enum Side {
    Outside,
    Inside,
}

/// What has a support function.
#[derive(Clone, Copy, Debug)]
enum Convex<'a> {
    Solid(&'a Solid),
    Hollow(&'a Oval),
}

/// What lies below a plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfSpace {
    /// The unit direction away from it.
    pub(crate) away: Vec3,
    /// How far the tool end is from it.
    pub(crate) off: f64,
    /// Does it hold all material below the surface?
    pub(crate) holds: bool,
}

/// The answer for one cut vector and one surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// The gap stays between these bounds, which lie in the band.
    Proved { low: f64, high: f64 },
    /// At the tool end `te` the gap is `gap`, outside the band.
    Refuted { gap: f64, te: Vec3 },
    /// The bounds could not be brought together; nothing violates the band by more than `at_most`, which was
    /// met near the tool end `te`.
    Undecided { at_most: f64, te: Vec3 },
}

impl Demand {
    /// What a controlled surface asks.
    pub(crate) fn new(c: &Controlled, sheets: &Sheets) -> Self {
        let on = c.side == 0 || c.relation == Relation::On;
        let flipped = match c.form.shape() {
            Form::Plane(p) if c.side < 0 => Some(*p),
            Form::Line(l) if c.side < 0 => Some(l.plane()),
            _ => None,
        };
        let body = match flipped {
            Some(p) => Body::Solid(Solid::Half(Plane { n: -p.n, d: -p.d })),
            None => Solid::new(&c.form)
                .map(Body::Solid)
                .or_else(|| opened(c).map(Body::Hollow))
                .or_else(|| sheets.of_form(&c.form).map(|s| Body::Sheet(s, beside(c))))
                .unwrap_or(Body::Unknown),
        };
        let flat = matches!(body, Body::Solid(Solid::Half(_)));
        let side = if c.side < 0 { -1.0 } else { 1.0 };
        let within = c.side < 0 && !flat && !on;
        let (least, most) = match (on, flat) {
            // Neither side of a plane is its outside.
            (true, true) => (-c.intol.max(c.outtol), c.intol.max(c.outtol)),
            (true, false) => (-c.intol, c.outtol),
            (false, _) => (c.thick - c.intol, c.thick + c.outtol),
        };
        // The working surface of a POLCON lies beside the one that is defined.
        let moved = match c.form.shape() {
            Form::Polyconic(p) => side * p.rise(),
            _ => 0.0,
        };
        let (least, most) = (least + moved, most + moved);
        Self { body, side, within, open: c.open, on, moved, least, most }
    }

    /// That no point of a tool is deeper than `depth` beyond a surface with a closed form, the tool on the side `side` of
    /// it, inside of a hollow that is open along the tool axis if told so; `None` of other surfaces.
    pub(crate) fn clear(form: &Form, side: f64, open: bool, depth: f64) -> Option<Self> {
        let solid = match Solid::new(form)? {
            Solid::Half(p) if side < 0.0 => Solid::Half(Plane { n: -p.n, d: -p.d }),
            solid => solid,
        };
        let within = side < 0.0 && !matches!(solid, Solid::Half(_));
        let (body, least, most) = (Body::Solid(solid), -depth, f64::INFINITY);
        Some(Self { body, side, within, open: open && within, on: false, moved: 0.0, least, most })
    }

    /// The same inside of a convex quadric that is open along the tool axis; `None` of others.
    pub(crate) fn hollow(quadric: &QuadricSurface, depth: f64) -> Option<Self> {
        let body = Body::Hollow(Oval::new(quadric)?);
        let (least, most) = (-depth, f64::INFINITY);
        let moved = 0.0;
        Some(Self { body, side: -1.0, within: true, open: true, on: false, moved, least, most })
    }

    /// Judges the cut vector from `a` to `b`; `pad` covers rounding. Of what is refuted the deepest place is
    /// given, to a tenth of its depth.
    #[cfg(test)]
    pub(crate) fn judge(&self, profile: &Profile, a: &Position, b: &Position, pad: f64) -> Verdict {
        self.judge_next(profile, a, b, pad, &mut Warm::default())
    }

    /// The same behind a vector along the same surface. Of a vector that is proved the lesser bound is told no closer than
    /// that it is not below what `warm` says.
    pub(crate) fn judge_next(
        &self,
        profile: &Profile,
        a: &Position,
        b: &Position,
        pad: f64,
        warm: &mut Warm,
    ) -> Verdict {
        self.judge_tool(&self.tool(profile), a, b, pad, warm)
    }

    /// The same of any tool.
    pub(crate) fn judge_tool(
        &self,
        tool: &Tool<'_>,
        a: &Position,
        b: &Position,
        pad: f64,
        warm: &mut Warm,
    ) -> Verdict {
        if let Some([low, high]) = self.straight(tool, a, b, pad, warm) {
            return Verdict::Proved { low, high };
        }
        let convex = match &self.body {
            Body::Solid(solid) => Convex::Solid(solid),
            Body::Hollow(hollow) => Convex::Hollow(hollow),
            Body::Sheet(sheet, _) => return self.curved(sheet).judge(tool, a, b, pad, warm),
            Body::Unknown => return Verdict::Undecided { at_most: f64::INFINITY, te: a.te },
        };
        let [from, to] = tool.ends(a, b);
        let told = warm.told.unwrap_or(f64::INFINITY);
        let band = [self.least - pad, self.most + pad];
        let way = Way::new(from, to);
        match self.halving(tool, &way, convex, band, told) {
            proved @ Verdict::Proved { .. }
                if self.within && self.open && self.most.is_finite() =>
            {
                self.not_above(tool, &way, convex, band[1]).unwrap_or(proved)
            }
            verdict => verdict,
        }
    }

    /// What is wrong with a tool that is to touch a hollow that counts as open and stands outside of it, above it, beside what runs
    /// straight up from its outline.
    ///
    /// The gap to what is convex is nowhere greater than at one of both ends of a stretch, but for the turn: the point of the tool that is
    /// a share t of the way from the nearest one at the first to that at the last leaves the line between these by `2 t (1 - t)` times
    /// the turn and the reach of the tool at most.
    fn not_above(
        &self,
        tool: &Tool<'_>,
        way: &Way,
        convex: Convex<'_>,
        most: f64,
    ) -> Option<Verdict> {
        /// Halvings of a way.
        const DEPTH: u32 = 16;
        let look = |t: f64| {
            let pose = way.at(t);
            let gap = match convex {
                Convex::Solid(solid) => solid.touch(tool, &pose, None).low,
                Convex::Hollow(hollow) => hollow.touch(tool, &pose, None).low,
            };
            // Of one deep in it nothing is known.
            (t, if gap.is_finite() { gap } else { f64::NEG_INFINITY }, pose)
        };
        let mut stack = Pile::<_, 32>::new();
        stack.push((look(0.0), look(1.0), 0));
        while let Some((from, to, depth)) = stack.pop() {
            let (_, gap, Pose { te, .. }) = if to.1 > from.1 { to } else { from };
            let turn = way.turn_between(&from.2, &to.2, to.0 - from.0);
            let at_most = gap + 0.5 * turn * tool.reach() - most;
            match () {
                () if gap > most => return Some(Verdict::Refuted { gap, te }),
                () if at_most <= 0.0 => {}
                () if depth >= DEPTH => return Some(Verdict::Undecided { at_most, te }),
                () => {
                    let middle = look(0.5 * (from.0 + to.0));
                    stack.push((middle, to, depth + 1));
                    stack.push((from, middle, depth + 1));
                }
            }
        }
        None
    }

    /// Bounds of all vectors from `start` through the points, where the surface is a plane, the axis stands still and they are
    /// as asked.
    pub(crate) fn row(
        &self,
        profile: &Profile,
        start: &Position,
        points: &[Position],
        pad: f64,
    ) -> Option<Run> {
        let Body::Solid(Solid::Half(plane)) = &self.body else { return None };
        let run = level::beside_plane(&self.tool(profile), start, points, plane)?;
        (run.low >= self.least - pad && run.high <= self.most + pad).then_some(run)
    }

    /// What of the cutter is held against the surface.
    pub(crate) fn tool<'p>(&self, profile: &'p Profile) -> Tool<'p> {
        if self.on { Tool::End } else { Tool::Solid(profile) }
    }

    /// Least and greatest gap beside a convex solid along a way on which the axis does not turn, where they are as asked.
    #[inline]
    fn straight(
        &self,
        tool: &Tool<'_>,
        a: &Position,
        b: &Position,
        pad: f64,
        warm: &mut Warm,
    ) -> Option<[f64; 2]> {
        let ends @ [from, to] = tool.ends(a, b);
        if !same(from.ta, to.ta) {
            return None;
        }
        let (least, most) = (self.least - pad, self.most + pad);
        // How much more there is does not tell beside what was told of others.
        let enough = least.max(warm.told.unwrap_or(f64::INFINITY));
        let [low, high] = match &self.body {
            Body::Solid(Solid::Half(plane)) => {
                outside::beside_plane(tool, &ends, plane, &mut warm.end)
            }
            Body::Solid(solid) if !self.within => {
                let bound = outside::bound(tool, &ends, solid, &mut warm.end, enough);
                [bound.low, bound.high]
            }
            Body::Sheet(_, Some((oval, Side::Outside))) => {
                let bound = outside::bound(tool, &ends, oval, &mut warm.end, enough);
                [bound.low, bound.high]
            }
            // Where the hollow runs on along the axis its tangent planes are those that do not look up.
            Body::Sheet(_, Some((oval, Side::Inside)))
                if oval.is_endless(from.ta)
                    && ends.iter().all(|p| oval.rolled(tool, p).is_some()) =>
            {
                let bound = inside::bound(tool, &from, &to, oval, true);
                [bound.low, bound.high]
            }
            _ => return None,
        };
        let held = low >= least && high <= most;
        if held {
            warm.forget();
        }
        held.then_some([low, high])
    }

    /// The same by halving the way: bounds of its stretches are put together.
    #[inline(never)]
    fn halving(
        &self,
        tool: &Tool<'_>,
        way: &Way,
        convex: Convex<'_>,
        [least, most]: [f64; 2],
        told: f64,
    ) -> Verdict {
        /// Halvings of a vector at most, and stretches that are looked at. Where the path of a turning tool
        /// just meets the border of its band the bounds are short of it by the square of the stretch.
        const DEPTH: u32 = 24;
        const MOST: u32 = 4000;
        let stop = |t: f64| {
            let pose = way.at(t);
            let touch = if way.turn > NO_TURN { self.touch(tool, &pose, convex) } else { None };
            Stop { t, pose, touch }
        };
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut open: (f64, Vec3) = (0.0, way.at(0.0).te);
        let mut worst: Option<(f64, f64, Vec3)> = None;
        let mut stack = Stack::new();
        stack.push((stop(0.0), stop(1.0), 0));
        let mut seen = 0;
        while let Some((from, to, depth)) = stack.pop() {
            seen += 1;
            let turn = way.turn_between(&from.pose, &to.pose, to.t - from.t);
            let enough = least.max(low.min(told));
            let bound = self.bound(tool, &from, &to, turn, convex, enough);
            let excess = (least - bound.low).max(bound.high - most);
            if excess <= 0.0 {
                (low, high) = (low.min(bound.low), high.max(bound.high));
                continue;
            }
            // Of what is no number nothing is known.
            let excess = if excess.is_nan() { f64::INFINITY } else { excess };
            let (deep, far) = (bound.least < least, bound.high > most);
            let suspects = [deep.then_some(bound.low_at), far.then_some(bound.high_at)];
            for t in suspects.into_iter().flatten() {
                let place = between_poses(&from.pose, &to.pose, t);
                let gap = self.gap(tool, &place, convex);
                let depth = (least - gap).max(gap - most);
                if depth > worst.map_or(0.0, |w| w.0) {
                    worst = Some((depth, gap, place.te));
                }
            }
            if worst.is_some_and(|w| excess <= 1.1 * w.0) {
                continue;
            }
            if depth >= DEPTH || seen > MOST {
                if excess > open.0 {
                    open = (excess, from.pose.te);
                }
            } else {
                let middle = stop(0.5 * (from.t + to.t));
                stack.push((middle, to, depth + 1));
                stack.push((from, middle, depth + 1));
            }
        }
        match worst {
            Some((_, gap, te)) => Verdict::Refuted { gap, te },
            None if open.0 > 0.0 => Verdict::Undecided { at_most: open.0, te: open.1 },
            None => Verdict::Proved { low, high },
        }
    }

    /// The gap at a position; `None` where the surface has no closed form.
    pub(crate) fn gap_at(&self, profile: &Profile, at: &Position) -> Option<f64> {
        self.gap_of(&self.tool(profile), at)
    }

    /// The same of any tool.
    pub(crate) fn gap_of(&self, tool: &Tool<'_>, at: &Position) -> Option<f64> {
        let pose = Pose::of(at);
        match &self.body {
            Body::Solid(solid) => Some(self.gap(tool, &pose, Convex::Solid(solid))),
            Body::Hollow(hollow) => Some(self.gap(tool, &pose, Convex::Hollow(hollow))),
            Body::Sheet(sheet, _) => self.curved(sheet).gap(tool, &pose),
            Body::Unknown => None,
        }
    }

    /// The half space below the plane that is tangent to the surface where the tool touches it with its end; `None` where nothing is
    /// near. Of another surface than one that has convex material below it that holds near there alone.
    pub(crate) fn half_space(&self, profile: &Profile, at: &Position) -> Option<HalfSpace> {
        let (away, off, holds) = match &self.body {
            _ if self.on => return None,
            Body::Solid(solid) => {
                let (away, off) = solid.half_space(at.te);
                if self.within { (-away, -off, false) } else { (away, off, true) }
            }
            _ => {
                let (off, away) = self.beside(profile, &Pose::of(at), &mut None)?;
                (away?, off, false)
            }
        };
        Some(HalfSpace { away, off, holds })
    }

    /// The gap at a position and the direction away from the surface there, where that is one. Of a surface with charts it is that at the
    /// place next to the tool from `spot` on, which need not be the nearest.
    pub(crate) fn beside(
        &self,
        profile: &Profile,
        pose: &Pose,
        spot: &mut Option<Spot>,
    ) -> Option<(f64, Option<Vec3>)> {
        if let Body::Sheet(sheet, _) = &self.body {
            let found = self.curved(sheet).beside(&self.tool(profile), pose, spot);
            return found.map(|(gap, away)| (gap, Some(away)));
        }
        self.gap_at(profile, &Position { te: pose.te, ta: pose.ta }).map(|gap| (gap, None))
    }

    /// The gap at a position, of a surface with charts that to the plane which is tangent next to the tool.
    pub(crate) fn beside_tangent(&self, profile: &Profile, pose: &Pose) -> Option<f64> {
        match &self.body {
            Body::Sheet(sheet, _) => self.curved(sheet).beside_tangent(&self.tool(profile), pose),
            _ => self.gap_at(profile, &Position { te: pose.te, ta: pose.ta }),
        }
    }

    /// Is the gap at a position nowhere less than so? Of what has a closed form it is what that tells.
    pub(crate) fn is_clear(&self, profile: &Profile, pose: &Pose, by: f64) -> bool {
        match &self.body {
            Body::Sheet(sheet, _) => {
                self.curved(sheet).nothing_nearer(&self.tool(profile), pose, by)
            }
            _ => true,
        }
    }

    fn curved<'s>(&self, sheet: &'s Sheet) -> Curved<'s> {
        Curved {
            sheet,
            side: self.side,
            on: self.on,
            moved: self.moved,
            least: self.least,
            most: self.most,
        }
    }

    /// How it is proved.
    pub(crate) fn method(&self) -> &'static str {
        match self.body {
            Body::Solid(_) | Body::Hollow(_) => "support functions",
            Body::Sheet(..) => "branch and bound",
            Body::Unknown => "none",
        }
    }

    fn gap(&self, tool: &Tool<'_>, pose: &Pose, convex: Convex<'_>) -> f64 {
        match convex {
            Convex::Solid(solid) if self.within => inside::gap(tool, pose, solid, self.open).1,
            Convex::Solid(solid) => solid.touch(tool, pose, None).low,
            Convex::Hollow(hollow) => inside::gap(tool, pose, hollow, true).1,
        }
    }

    /// What is known at one end of a stretch whatever its other end is: not inside of what is open, where that says which
    /// directions count.
    fn touch(&self, tool: &Tool<'_>, pose: &Pose, convex: Convex<'_>) -> Option<Touch> {
        match convex {
            Convex::Solid(solid) if self.within && !self.open => {
                let (low, high, m) = inside::gap(tool, pose, solid, false);
                Some(Touch { low, high, m, p: pose.te })
            }
            Convex::Solid(solid) if !self.within => Some(solid.touch(tool, pose, None)),
            Convex::Solid(_) | Convex::Hollow(_) => None,
        }
    }

    /// Bounds of a stretch on which the axis turns by `turn`, from below no closer than to `enough`.
    fn bound(
        &self,
        tool: &Tool<'_>,
        from: &Stop,
        to: &Stop,
        turn: f64,
        convex: Convex<'_>,
        enough: f64,
    ) -> Bound {
        let (p, q) = (&from.pose, &to.pose);
        let ends = [from.touch, to.touch];
        match convex {
            Convex::Solid(solid) if self.within => {
                within(tool, [p, q], solid, self.open, turn, ends)
            }
            Convex::Solid(solid) if turn <= NO_TURN => {
                outside::bound(tool, &[*p, *q], solid, &mut None, enough)
            }
            Convex::Solid(solid) => {
                outside::bound_turning(tool, [p, q], solid, &Turn::new(turn), ends, enough)
            }
            Convex::Hollow(hollow) => within(tool, [p, q], hollow, true, turn, ends),
        }
    }
}

fn within(
    tool: &Tool<'_>,
    [p, q]: [&Pose; 2],
    walls: &impl Walls,
    open: bool,
    turn: f64,
    ends: [Option<Touch>; 2],
) -> Bound {
    if turn <= NO_TURN {
        inside::bound(tool, p, q, walls, open)
    } else {
        inside::bound_turning(tool, [p, q], walls, open, &Turn::new(turn), ends)
    }
}

/// The hollow of a quadric that counts as open.
fn opened(c: &Controlled) -> Option<Oval> {
    let touches = c.open && c.side != 0 && c.relation != Relation::On;
    if touches { convex(c, c.side >= 0) } else { None }
}

/// The convex quadric outside or inside of which the tool is; one that it cannot be inside of as a whole is judged from outside.
fn beside(c: &Controlled) -> Option<(Oval, Side)> {
    let on = c.side == 0 || c.relation == Relation::On;
    let outside = convex(c, c.side < 0).map(|oval| (oval, Side::Outside));
    outside.or_else(|| {
        (!on).then(|| convex(c, c.side >= 0)).flatten().map(|oval| (oval, Side::Inside))
    })
}

/// The negative side of a quadric, or its positive one, where that is convex and its middle is known.
fn convex(c: &Controlled, positive: bool) -> Option<Oval> {
    let Form::Quadric(q) = c.form.shape() else { return None };
    let c = if positive { q.c.map(|x| -x) } else { q.c };
    Oval::new(&QuadricSurface::new(&Quadric { kind: q.kind, c })?).filter(|oval| !oval.is_slack())
}

#[cfg(test)]
#[path = "demand_tests.rs"]
mod tests;
