//! The gap between a tool and a surface.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Reason, Spot, Surface, Tool, Vec3};

use crate::{alone, closed, disk, edges, rings, search, tangents};

/// The side of a surface on which the tool is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// Where the surface's normals point: outside of sphere, cylinder and cone.
    Positive,
    /// The other side.
    Negative,
    /// The other side of a hollow that counts as open along the tool axis: whatever lies above the hollow,
    /// seen along the axis, is no material. So a cutter works inside of a sphere or a lying cylinder that it
    /// is taller than. For sphere, cylinder, cone and convex quadrics; see [`aptc_geometry::surface::kept::opens`].
    Open,
}

impl Side {
    /// The side on which a point lies; the positive one for a point of the surface.
    pub fn of(p: Vec3, surface: &Surface) -> Self {
        if surface.distance(p) < 0.0 { Self::Negative } else { Self::Positive }
    }

    /// +1 or -1.
    #[inline]
    pub fn sign(self) -> f64 {
        match self {
            Self::Positive => 1.0,
            Self::Negative | Self::Open => -1.0,
        }
    }
}

/// What the tool does to a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Condition {
    /// The tool touches it (TO, PAST, TANTO, TLLFT, TLRGT, TLOFPS).
    Touch,
    /// The tool end lies on it (ON, TLON, TLONPS).
    On,
}

/// The gap and where it is.
#[derive(Clone, Copy, Debug)]
pub struct Gap {
    /// Signed gap less THICK: positive clear, negative deep by as much.
    pub g: f64,
    /// Gap before THICK was taken off.
    pub raw: f64,
    /// The point of the tool; the tool end for ON.
    pub tool_point: Vec3,
    /// The point of the surface.
    pub surface_point: Vec3,
    /// Its parameters, of surfaces that have two, when they are known.
    pub at: Option<[f64; 2]>,
    /// Unit normal of the surface there, towards the tool's side: the gradient of `g` by the tool end.
    pub normal: Vec3,
    /// Where on the cutter; `None` for ON.
    pub segment: Option<Segment>,
    /// By how much tool point and surface point fail to face each other: the length of the part of their
    /// difference across the normal. `g` is wrong by about its square over the radius of curvature.
    pub residual: f64,
}

impl Gap {
    /// The point of the surface, for the next search to begin at.
    #[inline]
    pub fn spot(&self) -> Spot {
        Spot { point: self.surface_point, at: self.at }
    }

    /// How fast the gap grows when the tool turns at the rate `omega` (radians, as a vector) about its end.
    ///
    /// The tool axis then changes by `omega x ta`.
    pub fn turn_rate(&self, te: Vec3, omega: Vec3) -> f64 {
        omega.cross(&(self.tool_point - te)).dot(&self.normal)
    }
}

/// Share of a tool's reach and place by which one gap must be less than another to count as deeper.
const TIE: f64 = 1e-12;

/// Is the first of two gaps of a tool the less by more than rounding?
///
/// Two places of a cutter may touch at once, by symmetry of the scene or because one point belongs to two parts of the cutter. Then
/// the first one that is met is taken, and not the one that rounding makes the deeper.
#[inline]
pub(crate) fn deeper(tool: &Tool<'_>, one: f64, other: f64) -> bool {
    one < other - TIE * (tool.profile.reach() + tool.te.norm())
}

/// Gap between the tool and the surface, the tool being on `side` of it, less `thick` of stock.
///
/// APT: `AMIND`, `DISDS`, `TLNORM`. Source: B70-18 ch. D; closed forms for plane, sphere, cylinder and cone,
/// and for all surfaces along whose generator the tool axis stands. Elsewhere the search starts from points
/// all round the tool and ends at a normal pair, `residual` below 1e-9 of the cutter; its bound is reached
/// only for surfaces tighter than the tool, and then it says so.
#[inline]
pub fn gap(tool: &Tool<'_>, surface: &Surface, side: Side, thick: f64) -> Result<Gap, Reason> {
    gap_near(tool, surface, side, thick, None)
}

/// As [`gap`]; where a search is needed it starts at the surface point `start` of the last position and
/// stays on its branch. That is several times faster, and local: where the surface is of mixed curvature seen
/// from that side several places of the cutter may touch at once, and [`elsewhere`] finds the others.
#[inline]
pub fn gap_near(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    thick: f64,
    start: Option<Spot>,
) -> Result<Gap, Reason> {
    debug_assert!((tool.ta.norm() - 1.0).abs() < 1e-9, "the tool axis is a unit vector");
    let mut gap = match surface {
        Surface::Plane(s) => closed::plane(tool, s, side),
        Surface::Sphere(s) => closed::sphere(tool, s, side),
        Surface::Cylinder(s) => tangents::cylinder(tool, s, side)?,
        Surface::Cone(s) => tangents::cone(tool, s, side)?,
        Surface::Quadric(s) if side == Side::Open => {
            let open = s.opened(tool.ta).ok_or(Reason::NoHit)?;
            rings::within(tool, |p| open.foot(p))?
        }
        _ if side == Side::Open => return Err(Reason::NoHit),
        _ => search::general(tool, surface, side, start)?,
    };
    gap.g = gap.raw - thick;
    Ok(gap)
}

/// The gap at the place of contact into which the surface point `q` runs downhill, also where another one is
/// deeper. For surfaces without a closed form.
pub fn gap_at(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    thick: f64,
    q: Spot,
) -> Result<Gap, Reason> {
    let gap = disk::below(tool, surface, side, q)?;
    Ok(Gap { g: gap.raw - thick, ..gap })
}

/// Does the surface go all round a tool on that side, as the inside of an ellipsoid? A search that starts at the
/// last place of contact then finds the wall there, whatever the rest of the tool does.
pub fn surrounds(surface: &Surface, side: Side) -> bool {
    search::hollow(surface, side)
}

/// Of a tool with the `known` gap a deeper one, if there is one, and the way that the tool can go (the way of
/// its top when it turns, which it does not where it `stands`) until a place of contact far from the known one may be the
/// deepest; where it stands a way longer than `most` is not asked for.
pub fn elsewhere(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    known: &Gap,
    (stands, most): (bool, f64),
) -> (Option<Gap>, f64) {
    let (deeper, room) = search::elsewhere(tool, surface, side, known, (stands, most));
    let thick = known.raw - known.g;
    (deeper.map(|gap| Gap { g: gap.raw - thick, ..gap }), room)
}

/// Is it seen that a tool with the `known` gap, its axis standing, touches a surface by two parameters nowhere but at that place of
/// contact, wherever this goes, while it goes no farther than `way`?
pub fn touches_once(tool: &Tool<'_>, surface: &Surface, side: Side, known: &Gap, way: f64) -> bool {
    let searched = matches!(surface, Surface::Parametric(_));
    let found = || alone::alone(tool, surface, side, known, way);
    searched && found().is_some_and(|free| free >= way) && !edges::has_edges(tool, surface)
}

/// Signed distance of the tool end from the surface, positive on `side`. THICK does not count for ON.
///
/// APT: the ON branch of `DISDS`.
#[inline]
pub fn on(te: Vec3, surface: &Surface, side: Side) -> Gap {
    let foot = surface.foot(te);
    let s = side.sign();
    Gap {
        g: s * foot.distance,
        raw: s * foot.distance,
        tool_point: te,
        surface_point: foot.point,
        at: foot.at,
        normal: foot.normal * s,
        segment: None,
        residual: 0.0,
    }
}

/// [`gap_near`] or [`on`], as the condition says.
#[inline]
pub fn distance(
    tool: &Tool<'_>,
    surface: &Surface,
    condition: Condition,
    side: Side,
    thick: f64,
    start: Option<Spot>,
) -> Result<Gap, Reason> {
    match condition {
        // A tool without size touches where its end is.
        Condition::Touch if tool.profile.reach() == 0.0 => {
            let at = on(tool.te, surface, side);
            Ok(Gap { g: at.raw - thick, ..at })
        }
        Condition::Touch => gap_near(tool, surface, side, thick, start),
        Condition::On => Ok(on(tool.te, surface, side)),
    }
}
