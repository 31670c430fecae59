//! One surface that the tool keeps to, and how near it has to stay.

use aptc_cldata::Position;
use aptc_contact::{
    Condition, Gap, Reason, Side, Tool, distance, elsewhere, gap_at, opens, second, surrounds,
    touches_once,
};
use aptc_geometry::{Profile, Spot, Surface, Vec3};

use crate::failure::Failure;
use crate::scene::Wall;

/// A tool position: tool end and unit tool axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose {
    pub(crate) te: Vec3,
    pub(crate) ta: Vec3,
}

/// A surface with what is asked of the tool against it.
#[derive(Clone, Debug)]
pub(crate) struct Keep {
    /// What touches it.
    pub(crate) profile: Profile,
    pub(crate) surface: Surface,
    pub(crate) condition: Condition,
    pub(crate) side: Side,
    pub(crate) thick: f64,
    pub(crate) intol: f64,
    pub(crate) outtol: f64,
    /// Do the ends of cut vectors keep outside of the surface?
    pub(crate) outside: bool,
}

/// How deep what touches may be. The faces beside an edge, moved in by INTOL, cross each other there and end outside of each other:
/// what keeps outside of both is nowhere deeper than this, and beside a sharp edge it stands off.
fn deep(wall: &Wall, surface: &Surface) -> f64 {
    /// Part of the band that is to be left.
    const LEFT: f64 = 0.1;
    let band = wall.band;
    let cos = match surface {
        Surface::Parametric(s) if !wall.on && wall.thick <= 0.0 => {
            s.edges().iter().map(|edge| edge.cos).fold(1.0, f64::min)
        }
        _ => 1.0,
    };
    let deep = band.intol * cos;
    if deep + band.outtol < LEFT * (band.intol + band.outtol) { band.intol } else { deep }
}

/// Least and greatest gap allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Limits {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// Share of the band that vertices keep from its edge, so that rounding does not carry them out.
const EDGE: f64 = 1e-7;
/// The same against surfaces whose nearest point is found by iteration, and that by which chords over them aim inside of it:
/// what is met on a chord tells the rest of it to less.
const EDGE_SEARCHED: f64 = 5e-5;
/// A gap that bends by less than this over the size of the scene does so by rounding.
const STRAIGHT: f64 = 1e-9;

impl Pose {
    /// That of CL data.
    pub(crate) fn of(p: &Position) -> Self {
        Self { te: p.te, ta: p.ta }
    }

    /// How a tool stands: with the axis that it had where another one was given since.
    pub(crate) fn standing(tool: &crate::state::Tool) -> Self {
        Self { te: tool.te, ta: tool.stood.unwrap_or(tool.ta) }
    }

    /// The same in CL data.
    pub(crate) fn position(&self) -> Position {
        Position { te: self.te, ta: self.ta }
    }
}

impl Keep {
    /// What is asked of the tool at a wall, on the positive side of its surface.
    pub(crate) fn of(wall: &Wall) -> Result<Self, Failure> {
        let unusable = || Failure::Unsupported { surface: wall.surface.clone() };
        let surface = wall.fitted.clone().ok_or_else(unusable)?;
        Ok(Self {
            profile: wall.profile,
            condition: if wall.on { Condition::On } else { Condition::Touch },
            side: Side::Positive,
            thick: wall.thick,
            intol: deep(wall, &surface),
            outtol: wall.band.outtol,
            outside: wall.outside,
            surface,
        })
    }

    pub(crate) fn tool(&self, pose: &Pose) -> Tool<'_> {
        Tool { profile: &self.profile, te: pose.te, ta: pose.ta }
    }

    /// The gap; a search starts at the place `start` of the surface.
    #[inline]
    pub(crate) fn gap(&self, pose: &Pose, start: Option<Spot>) -> Result<Gap, Reason> {
        let tool = self.tool(pose);
        distance(&tool, &self.surface, self.condition, self.side, self.thick, start)
    }

    /// The gap near a known one. Nothing says that a check surface's deepest place stays where it was, so inside
    /// of a hollow all of the tool is looked at.
    pub(crate) fn gap_from(&self, pose: &Pose, known: Option<&Gap>) -> Result<Gap, Reason> {
        let known = known.filter(|_| !surrounds(&self.surface, self.side));
        self.gap(pose, known.map(Gap::spot))
    }

    /// The gap at the place of contact near the surface point `q`, also where another one is deeper.
    pub(crate) fn gap_at(&self, pose: &Pose, q: Spot) -> Result<Gap, Reason> {
        gap_at(&self.tool(pose), &self.surface, self.side, self.thick, q)
    }

    /// The same surface with the tool on another side.
    pub(crate) fn on_side(&self, side: Side) -> Self {
        Self { side, ..self.clone() }
    }

    /// The sides on which the tool may be.
    pub(crate) fn sides(&self, pose: &Pose) -> impl Iterator<Item = Side> + use<> {
        let open = (self.taller(pose) || self.reaches_the_roof(pose)).then_some(Side::Open);
        [Side::Positive, Side::Negative].into_iter().chain(open)
    }

    /// Is the surface a bowl or a trough that the cutter cannot stand in as a whole?
    pub(crate) fn taller(&self, pose: &Pose) -> bool {
        let height = self.profile.height() - self.profile.bottom();
        let radius = match &self.surface {
            Surface::Quadric(s) => {
                let low = s.too_low(pose.ta, pose.te, height, self.profile.widest());
                return self.condition == Condition::Touch && low && opens(&self.surface, pose.ta);
            }
            Surface::Sphere(s) => s.radius,
            Surface::Cylinder(s) => s.radius,
            Surface::Cone(s) => (pose.te - s.vertex).dot(&s.axis) * s.sin_half() / s.cos_half,
            _ => return false,
        };
        let around = aptc_geometry::trig::hypot(0.5 * height, self.profile.widest());
        self.condition == Condition::Touch && opens(&self.surface, pose.ta) && around > radius
    }

    /// The inside of a surface that the cutter touches: open above one that reaches the roof.
    pub(crate) fn below(&self, pose: &Pose) -> Side {
        if self.reaches_the_roof(pose) { Side::Open } else { self.inner(pose) }
    }

    /// Does the cutter stand on the floor of a hollow in the middle of which it would fit, and is it there deeper in the roof than in
    /// the floor, and than its band lets it be?
    fn reaches_the_roof(&self, pose: &Pose) -> bool {
        let gap =
            |side: Side| self.on_side(side).gap(pose, None).map_or(f64::NEG_INFINITY, |g| g.g);
        let outside = || self.on_side(Side::Positive).clears(pose);
        if !self.opens(pose) {
            return false;
        }
        let floor = gap(Side::Open);
        let most = floor.min(self.limits().low) - 1e-6 * self.width();
        floor >= -2.0 * self.width() && gap(Side::Negative) < most && !outside()
    }

    /// Is it a hollow that counts as open, above all of which the tool stands, beside what runs straight up from its outline?
    pub(crate) fn stands_above(&self, pose: &Pose) -> bool {
        let off = |g: Gap| g.g > 2.0 * self.width();
        self.side == Side::Open && self.on_side(Side::Positive).gap(pose, None).is_ok_and(off)
    }

    /// Is it touched, and a hollow that can be open along the axis?
    pub(crate) fn opens(&self, pose: &Pose) -> bool {
        self.condition == Condition::Touch && opens(&self.surface, pose.ta)
    }

    /// The inside of the surface: as a whole where the cutter fits into it, else open along its axis.
    pub(crate) fn inner(&self, pose: &Pose) -> Side {
        let clears = |side: Side| self.on_side(side).clears(pose);
        // A cutter outside may well stand where the hollow would be open.
        let whole = !self.taller(pose) || clears(Side::Negative) || clears(Side::Positive);
        if whole { Side::Negative } else { Side::Open }
    }

    /// Is the cutter clear of the surface but for two bands?
    pub(crate) fn clears(&self, pose: &Pose) -> bool {
        self.gap(pose, None).is_ok_and(|g| g.g >= -2.0 * self.width())
    }

    /// Is the gap on a side less than `-least`? No gap is greater than the distance of a point of the cutter; here that of
    /// the middle of its axis.
    pub(crate) fn deep(&self, pose: &Pose, side: Side, least: f64) -> bool {
        let profile = self.profile;
        let middle = pose.te + pose.ta * (0.5 * (profile.bottom() + profile.height()));
        let touches = self.condition == Condition::Touch && side != Side::Open;
        touches && side.sign() * self.surface.distance(middle) - self.thick < -least
    }

    /// The gap, when a place of contact deeper than `known` by more than `exact` was missed, and the way for
    /// which there is none, with an axis that `stands` or may turn.
    pub(crate) fn deeper(
        &self,
        pose: &Pose,
        known: &Gap,
        exact: f64,
        stands: bool,
    ) -> (Option<Gap>, f64) {
        self.deeper_on(pose, known, exact, (stands, f64::INFINITY))
    }

    /// The same, where no way longer than `most` is asked for.
    pub(crate) fn deeper_on(
        &self,
        pose: &Pose,
        known: &Gap,
        exact: f64,
        way: (bool, f64),
    ) -> (Option<Gap>, f64) {
        if self.condition == Condition::On || self.profile.reach() == 0.0 {
            return (None, f64::INFINITY);
        }
        let (deeper, room) = elsewhere(&self.tool(pose), &self.surface, self.side, known, way);
        (deeper.filter(|g| g.g < known.g - exact), room)
    }

    /// Is it seen that the cutter touches at one place alone, wherever that goes, as long as it goes no farther than a way?
    pub(crate) fn touches_once(&self, pose: &Pose, known: &Gap, way: f64) -> bool {
        let touches = self.condition == Condition::Touch && self.profile.reach() > 0.0;
        touches && touches_once(&self.tool(pose), &self.surface, self.side, known, way)
    }

    /// Second derivative of the gap when the tool end moves along the unit vector `v`.
    #[inline]
    pub(crate) fn bend(&self, pose: &Pose, gap: &Gap, v: Vec3) -> f64 {
        if self.is_plane() {
            return 0.0;
        }
        second(&self.tool(pose), &self.surface, self.side, gap).map_or(0.0, |s| s.second(v))
    }

    /// Radius of the hollow at the surface point `q`, when the widest of the cutter does not fit into it.
    pub(crate) fn too_tight(&self, q: Vec3) -> Option<f64> {
        let k = self.surface.foot(q).shape.principal();
        let tightest = if self.side == Side::Positive { -k[1] } else { k[0] };
        let tight = tightest > 0.0 && 1.0 / tightest < 1.01 * self.profile.widest();
        (self.condition == Condition::Touch && tight).then(|| 1.0 / tightest)
    }

    /// Does the cutter touch the edge at which the surface ends, and not the surface itself?
    pub(crate) fn goes_round_an_end(&self, gap: &Gap) -> bool {
        self.condition == Condition::Touch && self.surface.ends_at(gap.at)
    }

    /// Is the tool end on the surface, at its edge or beyond?
    pub(crate) fn ends_below(&self, gap: &Gap) -> bool {
        self.condition == Condition::On && self.surface.ends_at(gap.at)
    }

    /// Is a point beyond the end of a surface by two parameters, by more than the band? Along the end itself the tool may go.
    pub(super) fn runs_out(&self, te: Vec3) -> bool {
        matches!(self.surface, Surface::Parametric(_)) && {
            let foot = self.surface.foot(te);
            self.surface.ends_at(foot.at) && foot.distance.abs() > self.width()
        }
    }

    /// Is the tool end on it?
    pub(super) fn is_on(&self) -> bool {
        self.condition == Condition::On
    }

    #[inline]
    pub(crate) fn is_plane(&self) -> bool {
        matches!(self.surface, Surface::Plane(_))
    }

    /// How many spans or patches of the surface two places of it are apart, by their parameters; 0 where it has none.
    pub(super) fn spans_between(&self, a: Option<[f64; 2]>, b: Option<[f64; 2]>) -> f64 {
        match (&self.surface, a, b) {
            (Surface::Tabcyl(s), Some(a), Some(b)) => s.spans_between(a[0], b[0]),
            (Surface::Parametric(s), Some(a), Some(b)) => s.pieces_between([a, b]),
            _ => 0.0,
        }
    }

    /// May several places of the cutter touch, because the surface bends both ways?
    pub(crate) fn is_mixed(&self) -> bool {
        self.condition == Condition::Touch && !self.surface.convex() && !self.surface.concave()
    }

    /// The band. With the tool end on the surface its positive side counts as outside.
    pub(crate) fn limits(&self) -> Limits {
        Limits { low: -self.intol, high: self.outtol }
    }

    /// Where in the band a vertex lies when the gap bends by `bend` along the path and the cut vectors use
    /// the share `share` of the band: outside where the surface is round, so that the middle of the cut
    /// vectors may go in, and inside where it is hollow.
    pub(crate) fn target(&self, bend: f64, share: f64) -> f64 {
        target(self.vertices(), bend, share)
    }

    /// Where in the band vertices lie at least and at most.
    pub(super) fn vertices(&self) -> [f64; 2] {
        let (Limits { low, high }, edge) = (self.limits(), self.edge());
        let low = if self.outside && high > 2.0 * edge { low.max(0.0) } else { low };
        [low + edge, high - edge]
    }

    /// Where in the band the tool stops that goes on along a way on which the gap bends by `bend`: at the edge that leaves the
    /// whole band, and touching where the bend is rounding alone, as on the ruling of a cylinder.
    pub(crate) fn onwards(&self, pose: &Pose, bend: f64) -> f64 {
        let size = pose.te.norm() + self.profile.reach() + self.surface.extent();
        if bend.abs() * size <= STRAIGHT { self.level() } else { self.target(bend, 1.0) }
    }

    /// Where it lies when the gap does not bend: touching, but a little inside of a band that begins there.
    pub(crate) fn level(&self) -> f64 {
        if self.is_plane() { 0.0 } else { self.target(0.0, 0.0) }
    }

    /// How far vertices keep from the edge of the band.
    fn edge(&self) -> f64 {
        self.searched().unwrap_or(EDGE) * self.width()
    }

    /// Share of the band that is kept where the nearest point is found by iteration.
    #[inline]
    pub(crate) fn searched(&self) -> Option<f64> {
        let closed =
            matches!(self.surface, Surface::Plane(_) | Surface::Sphere(_) | Surface::Cylinder(_));
        (!closed).then_some(EDGE_SEARCHED)
    }

    /// The gap itself, or the next one that is farther inside of the band than the share `share` of it, for an axis that
    /// turns: not for the tool end, whose gap does not depend on it.
    pub(crate) fn inside(&self, gap: f64, share: f64) -> f64 {
        if self.is_on() {
            return gap;
        }
        let (limits, room) = (self.limits(), share.min(0.5) * self.width());
        gap.max(limits.low + room).min(limits.high - room)
    }

    /// The limits within which a tool is in place: neither side of a plane is the outside for a tool end on it.
    pub(super) fn in_place(&self) -> Limits {
        match self.condition {
            Condition::On if self.is_plane() => {
                let most = self.intol.max(self.outtol);
                Limits { low: -most, high: most }
            }
            _ => self.limits(),
        }
    }

    /// Width of the band.
    pub(crate) fn width(&self) -> f64 {
        self.intol + self.outtol
    }
}

/// Does the gap lie in a band?
pub(super) fn within(gap: &Gap, [intol, outtol]: [f64; 2]) -> bool {
    let slack = 1e-6 * (intol + outtol);
    gap.g >= -intol - slack && gap.g <= outtol + slack
}

/// As [`Keep::target`], where vertices lie between these limits.
#[inline(always)]
pub(super) fn target([low, high]: [f64; 2], bend: f64, share: f64) -> f64 {
    let at = if bend > 0.0 {
        share * high.max(0.0)
    } else if bend < 0.0 {
        share * low.min(0.0)
    } else {
        0.0
    };
    // A band may begin at the surface itself.
    at.max(low).min(high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Cutter, Cylinder, Plane, Sphere, Vec3, trig};

    #[test]
    fn what_lies_deep_has_a_gap_as_deep() {
        let (point, axis) = (Vec3::new(1.0, -2.0, -20.0), Vec3::new(2.0, 1.0, 2.0) / 3.0);
        let surfaces = [
            Surface::Plane(Plane { n: axis, d: 1.0 }),
            Surface::Sphere(Sphere { center: point, radius: 25.0 }),
            Surface::Cylinder(Cylinder { point, axis, radius: 22.0 }),
        ];
        let (mut told, mut all) = (0, 0);
        for (k, surface) in (0..1200_u32).zip(surfaces.iter().cycle()) {
            let f = f64::from(k);
            let corner = [0.0, 2.0, 5.0][k as usize / 3 % 3];
            let keep = Keep {
                profile: Profile::new(&Cutter::mill(10.0, corner, 30.0)).expect("a mill"),
                surface: surface.clone(),
                condition: Condition::Touch,
                side: Side::Positive,
                thick: 0.1 * f64::from(k % 5),
                intol: 0.01,
                outtol: 0.01,
                outside: false,
            };
            let lean = Vec3::new(trig::sin(f), trig::sin(1.7 * f), 2.0).normalize();
            let te = Vec3::new(
                30.0 * trig::sin(2.3 * f),
                30.0 * trig::sin(3.1 * f),
                20.0 * trig::sin(0.7 * f),
            );
            let pose = Pose { te, ta: lean };
            for side in [Side::Positive, Side::Negative] {
                let Ok(gap) = keep.on_side(side).gap(&pose, None) else { continue };
                all += 1;
                for least in [0.0, 0.5, 8.0] {
                    let deep = keep.deep(&pose, side, least);
                    assert!(!deep || gap.g < -least + 1e-9, "{k} {side:?} {least} {gap:?}");
                    told += u32::from(deep);
                }
            }
        }
        assert!(told > 400 && all > 2000, "{told} of {all}");
    }
}
