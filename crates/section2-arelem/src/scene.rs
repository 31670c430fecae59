//! What one motion is asked to do: the tool, the surfaces, and what the cutter does to each.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::Side;
use aptc_geometry::{Form, Profile, Surface, Vec3};
use aptc_protap::{Direction, Relation, SurfaceRef};

use crate::axis::AxisRule;
use crate::failure::{Candidate, Failure};
use crate::forward;
use crate::state::{Band, Tool};

/// Sine below which a circle is square to the tool axis.
const UPRIGHT: f64 = 1e-9;

/// A surface with what is asked of the cutter against it.
#[derive(Clone, Debug)]
pub(crate) struct Wall {
    pub(crate) surface: SurfaceRef,
    /// The same prepared for evaluation; `None` when it cannot be.
    pub(crate) fitted: Option<Surface>,
    /// Do its normals point to the other side than those of the form? A hollow is always on the negative side.
    pub(crate) reversed: bool,
    /// What touches it.
    pub(crate) profile: Profile,
    /// Radius and height of the disk that the profile is, CUTTER/OPTION.
    pub(crate) disk: Option<[f64; 2]>,
    /// Is the tool end on it, rather than the cutter at it?
    pub(crate) on: bool,
    /// Thickness left on it; 0 when the tool end is on it.
    pub(crate) thick: f64,
    pub(crate) band: Band,
    /// Is the band the other way round, for the normal points away from the cutter?
    pub(crate) below: bool,
    /// Are the ends of cut vectors to keep outside of it?
    pub(crate) outside: bool,
}

/// A check surface.
#[derive(Clone, Debug)]
pub(crate) struct Check {
    pub(crate) wall: Wall,
    pub(crate) relation: Relation,
    pub(crate) nth: u32,
}

/// A motion along surfaces.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub(crate) tool: Tool,
    /// What the motion before was held to, where it ended here.
    pub(crate) ended: Option<Arc<cl::Control>>,
    pub(crate) direction: Direction,
    pub(crate) drive: Wall,
    pub(crate) stance: Stance,
    pub(crate) part: Wall,
    pub(crate) checks: Vec<Check>,
    pub(crate) axis: AxisRule,
    pub(crate) limits: Limits,
}

/// How the tool stands to the drive surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stance {
    /// TLON, TLNDON.
    On,
    /// TLLFT.
    Left,
    /// TLRGT.
    Right,
    /// No word was given yet: as the start-up left it.
    AsItStands,
}

/// Limits of one motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// NUMPTS.
    pub(crate) vectors: Option<u32>,
    /// MAXDP.
    pub(crate) step: f64,
}

/// A start-up.
#[derive(Clone, Debug)]
pub(crate) struct Start {
    pub(crate) tool: Tool,
    /// What the motion before was held to, where it ended here.
    pub(crate) ended: Option<Arc<cl::Control>>,
    pub(crate) offset: bool,
    /// The surfaces named, in the order drive, part, check.
    pub(crate) surfaces: Vec<(Relation, Wall)>,
    /// The part surface in force when none was named; none after NOPS.
    pub(crate) part: Option<(Relation, Wall)>,
    /// Direction given for each surface.
    pub(crate) along: Vec<Option<Vec3>>,
    /// SRFVCT for each surface.
    pub(crate) normals: Vec<Option<Vec3>>,
    pub(crate) axis: AxisRule,
    /// Is a THICK in force?
    pub(crate) thick: bool,
    /// Unit normal of the part surface where the last start-up in space ended.
    pub(crate) part_normal_before: Option<Vec3>,
}

impl Start {
    /// Unit normal of the part surface at its place nearest to `te`.
    pub(crate) fn part_normal(&self, te: Vec3) -> Option<Vec3> {
        let (_, wall) = self.surfaces.get(1).or(self.part.as_ref())?;
        Some(wall.fitted.as_ref()?.foot(te).normal)
    }

    /// Has the part surface at `te` the normal that it had at the last start-up in space? Only then a direction is followed
    /// all the way. Source: what APT-360 does.
    pub(crate) fn on_the_same_part(&self, te: Vec3) -> bool {
        let both = self.part_normal_before.zip(self.part_normal(te));
        both.is_some_and(|(a, b)| a.cross(&b).norm() <= 1e-9)
    }
}

/// What came of it.
#[derive(Clone, Debug)]
pub(crate) struct Path {
    /// Ends of the cut vectors.
    pub(crate) points: Vec<cl::Position>,
    /// The circle of the tool end.
    pub(crate) arc: Option<cl::Arc>,
    /// Which check surface stopped it.
    pub(crate) check: usize,
    /// Direction at the end.
    pub(crate) forward: Vec3,
    /// For the proof.
    pub(crate) control: cl::Control,
    /// The upper part of the cutter cuts into the drive surface by so much, and only its lower edge was
    /// followed.
    pub(crate) fouls: Option<f64>,
    /// TLLFT or TLRGT was said, and the tool is on the other side.
    pub(crate) astray: Option<Astray>,
    /// Other positions that are just as near, of a start-up.
    pub(crate) rivals: Vec<Candidate>,
    /// How far OFFSET ended from its drive surface, which leans; below zero how deep in it.
    pub(crate) left: Option<f64>,
}

impl Path {
    /// That of a start-up.
    pub(crate) fn started(points: Vec<cl::Position>, forward: Vec3, control: cl::Control) -> Self {
        let (arc, fouls, astray) = (None, None, None);
        let rivals = Vec::new();
        Self { points, arc, check: 0, forward, control, fouls, astray, rivals, left: None }
    }
}

/// The word that was given for the side of the drive surface, and the one that holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Astray {
    pub(crate) word: &'static str,
    pub(crate) holds: &'static str,
}

impl Wall {
    /// The surface with its band as it is where the tool stands.
    ///
    /// Where the normal of a surface on which the tool end lies points away from the cutter, what stays is on the side to which it
    /// points, and INTOL and OUTTOL are the other way round. Both sides of a plane have the wider one, and a wall has its own.
    pub(crate) fn seen_from(mut self, te: Vec3, ta: Vec3) -> Self {
        /// Cosine of the angle between normal and axis from which the surface is no wall.
        const FLOOR: f64 = 0.2;
        let curved = self.fitted.as_ref().filter(|s| self.on && !matches!(s, Surface::Plane(_)));
        let below = curved.is_some_and(|s| s.foot(te).normal.dot(&ta) < -FLOOR);
        if below != self.below {
            (self.band.intol, self.band.outtol) = (self.band.outtol, self.band.intol);
        }
        Self { below, ..self }
    }

    /// Distance between surface and tool axis for a surface along the axis.
    pub(crate) fn reach(&self) -> f64 {
        if self.on { 0.0 } else { self.profile.widest() + self.thick }
    }

    /// For the proof: the tool is on that side of the form's normal.
    pub(crate) fn controlled(&self, relation: Relation, side: f64) -> cl::Controlled {
        cl::Controlled {
            name: forward::name(&self.surface.name),
            form: Arc::clone(&self.surface.form),
            relation: forward::relation(relation),
            side: if self.on {
                0
            } else if side < 0.0 {
                -1
            } else {
                1
            },
            open: false,
            nth: 1,
            thick: self.thick,
            disk: self.disk.filter(|_| !self.on),
            intol: self.band.intol,
            outtol: self.band.outtol,
        }
    }

    /// INTOL and OUTTOL of a motion along this surface, where it was held to it in the same way, with the tool on the side.
    pub(crate) fn band_in(
        &self,
        control: Option<&Arc<cl::Control>>,
        side: Side,
    ) -> Option<[f64; 2]> {
        control?.band_of(&self.beside(to_or_on(self.on), side))
    }

    /// The same of a surface in space, whose hollow may count as open.
    pub(crate) fn beside(&self, relation: Relation, side: Side) -> cl::Controlled {
        let open = side == Side::Open && !self.on;
        let sign = if self.reversed { -side.sign() } else { side.sign() };
        cl::Controlled { open, ..self.controlled(relation, sign) }
    }
}

impl Scene {
    /// INTOL and OUTTOL of the motion before along a surface that it was held to in the same way, with the tool on the side.
    pub(crate) fn left_in(&self, wall: &Wall, side: Side) -> Option<[f64; 2]> {
        wall.band_in(self.ended.as_ref(), side)
    }

    /// Was it in a hollow then that did not count as open?
    pub(crate) fn left_whole(&self, wall: &Wall) -> bool {
        let inside = wall.beside(to_or_on(wall.on), Side::Negative);
        self.ended.as_ref().is_some_and(|ended| ended.held_whole(&inside))
    }

    /// A round check surface, tangent to the drive surface to `allowed` on the side of the tool, into which the cutter does not fit.
    pub(crate) fn too_tight(&self, allowed: f64) -> Option<Failure> {
        let check = self.checks.first()?;
        if check.relation != Relation::Tanto || self.drive.on {
            return None;
        }
        let (centre, axis, radius) = match check.wall.surface.form.shape() {
            Form::Circle(c) => (c.center, c.axis, c.radius),
            Form::Cylinder(c) => (c.point, c.axis, c.radius),
            _ => return None,
        };
        let Tool { te, ta, .. } = self.tool;
        let drive = self.drive.fitted.as_ref()?;
        let level = centre + ta * (te - centre).dot(&ta);
        let away = drive.distance(level);
        let within = drive.distance(te) * away > 0.0 && (away.abs() - radius).abs() <= allowed;
        let cutter = check.wall.reach();
        let upright = axis.cross(&ta).norm() <= UPRIGHT;
        (upright && within && radius < cutter).then(|| Failure::TooLarge {
            surface: check.wall.surface.clone(),
            radius,
            cutter,
        })
    }
}

impl Stance {
    /// The warning for a tool on the other side; none when no side was said.
    pub(crate) fn astray(self) -> Option<Astray> {
        match self {
            Self::Left => Some(Astray { word: "TLLFT", holds: "TLRGT" }),
            Self::Right => Some(Astray { word: "TLRGT", holds: "TLLFT" }),
            Self::On | Self::AsItStands => None,
        }
    }

    /// +1 when the tool is to be on the left.
    pub(crate) fn left(self) -> f64 {
        if self == Self::Right { -1.0 } else { 1.0 }
    }
}

/// TO or ON, for part and drive surface.
pub(crate) fn to_or_on(on: bool) -> Relation {
    if on { Relation::On } else { Relation::To }
}
