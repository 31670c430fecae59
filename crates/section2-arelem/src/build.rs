//! From a record and the modal words to what a motion is asked to do.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::{Side, gap};
use aptc_geometry::{Cutter, Form, Profile, Surface, Vec3};
use aptc_protap as protap;
use aptc_protap::{Dimension, DriveSide, PartSide, Relation, SurfaceRef};

use crate::arelem::Arelem;
use crate::axis::AxisRule;
use crate::failure::Failure;
use crate::scene::{Check, Limits, Scene, Stance, Start, Wall};
use crate::state::{Band, Part, Role, Tool, auto_part, is_auto, unit};

/// Part of the cutter's reach by which a thickness may pass its radius: what rounding makes of equal numbers.
const SAME: f64 = 1e-12;

impl Arelem {
    pub(crate) fn start_scene(&mut self, go: &protap::Go, tool: Tool) -> Result<Start, Failure> {
        let roles = [Role::Drive, Role::Part, Role::Check];
        let mut surfaces = Vec::with_capacity(go.surfaces.len());
        for ((relation, surface), role) in go.surfaces.iter().zip(roles) {
            surfaces.push((*relation, self.wall(surface, role, *relation == Relation::On)?));
        }
        let part = if surfaces.len() < 2 && !self.settings.nops {
            let on = self.settings.ends_on_part;
            let relation = if on { Relation::On } else { Relation::To };
            Some((relation, self.wall(&self.part(&tool), Role::Part, on)?))
        } else {
            None
        };
        let given = std::mem::take(&mut self.settings.given);
        let along = given.into_iter().map(|v| v.and_then(unit)).collect();
        let normals = std::mem::take(&mut self.settings.normals);
        let axis = AxisRule::of(&self.settings.axis);
        let thick = self.settings.thick.iter().any(|t| *t != 0.0);
        let part_normal_before = self.settings.part_normal_before;
        let (offset, ended) = (go.offset, self.ended_here());
        let start = Start {
            tool,
            ended,
            offset,
            surfaces,
            part,
            along,
            normals,
            axis,
            thick,
            part_normal_before,
        };
        Ok(start)
    }

    /// What the motion that ended here with this cutter was held to.
    fn ended_here(&self) -> Option<Arc<cl::Control>> {
        let same =
            |(_, cutter): &&(Arc<cl::Control>, Option<Cutter>)| *cutter == self.settings.cutter;
        self.ended.as_ref().filter(same).map(|(control, _)| Arc::clone(control))
    }

    pub(crate) fn scene(&self, d: &protap::Drive, tool: Tool) -> Result<Scene, Failure> {
        let s = &self.settings;
        let stance = match s.drive_side {
            Some(DriveSide::Tlon | DriveSide::Tlndon) => Stance::On,
            Some(_) if self.stays_on(&d.drive, &tool) => Stance::On,
            Some(DriveSide::Tllft) => Stance::Left,
            Some(DriveSide::Tlrgt) => Stance::Right,
            None if self.stands_on(&d.drive, Role::Drive, &tool) => Stance::On,
            None => Stance::AsItStands,
        };
        let on = stance == Stance::On;
        let part = self.part(&tool);
        let part_on = self.on_part(&part, &tool);
        let mut checks = Vec::with_capacity(d.checks.len());
        for (i, c) in d.checks.iter().enumerate() {
            let role = if i == 0 { Role::Check } else { Role::SecondCheck };
            // A tangent surface is met as the surface is that it is tangent to.
            let on_check = match c.relation {
                Relation::On => true,
                Relation::Tanto => on,
                Relation::Pstan => part_on,
                Relation::To | Relation::Past => false,
            };
            let wall = self.wall(&c.surface, role, on_check)?;
            checks.push(Check { wall, relation: c.relation, nth: c.nth });
        }
        Ok(Scene {
            ended: self.ended_here(),
            tool,
            direction: d.direction,
            drive: self.wall(&d.drive, Role::Drive, on)?,
            stance,
            part: self.wall(&part, Role::Part, part_on)?,
            checks,
            axis: AxisRule::of(&s.axis),
            limits: Limits { vectors: s.numpts, step: s.maxdp() },
        })
    }

    /// Is the tool end to lie on the part surface? Where neither TLONPS nor TLOFPS says it, GO does: for its own part surface, and
    /// where it brought the cutter to touch one also for those that PSIS gives after it. That of AUTOPS goes through the tool end,
    /// whatever THICK asks of it.
    fn on_part(&self, part: &SurfaceRef, tool: &Tool) -> bool {
        let s = &self.settings;
        match (s.part_side, &s.started) {
            (Some(side), _) => side == PartSide::Tlonps,
            (None, Some((_, false))) if !is_auto(part) => false,
            (None, Some((form, true))) if Arc::ptr_eq(form, &part.form) => true,
            (None, _) => self.seems_on(part, tool),
        }
    }

    /// How deep the cutter stands in the part surface, its end on it though nothing says so; `None` where something does, and where
    /// it is within two bands.
    pub(crate) fn unsaid_depth(&self, part: &SurfaceRef, tool: &Tool) -> Option<f64> {
        let s = &self.settings;
        let said = match &s.started {
            Some((form, on)) => !on || Arc::ptr_eq(form, &part.form),
            None => false,
        };
        if said || s.part_side.is_some() || !self.seems_on(part, tool) {
            return None;
        }
        let wall = self.wall(part, Role::Part, false).ok()?;
        let surface = wall.fitted.as_ref()?;
        let at = aptc_contact::Tool { profile: &wall.profile, te: tool.te, ta: tool.ta };
        let on = |side| gap(&at, surface, side, 0.0).map_or(f64::NEG_INFINITY, |g| g.g);
        let sides = [Side::Positive, Side::Negative, Side::Open];
        let depth = -sides.into_iter().map(on).fold(f64::NEG_INFINITY, f64::max);
        (depth > 2.0 * (wall.band.intol + wall.band.outtol) && depth.is_finite()).then_some(depth)
    }

    /// Where nothing says it: is the tool end on the part surface, and does the cutter not touch it?
    fn seems_on(&self, part: &SurfaceRef, tool: &Tool) -> bool {
        self.stands_on(part, Role::Part, tool) && !self.touches(part, tool)
    }

    /// Does a tool with TLLFT or TLRGT stay ON the drive surface: an upright plane on which its end is, and beside which the
    /// cutter would stand elsewhere? Along other surfaces, and with THICK, APT-360 refuses it too.
    pub(crate) fn stays_on(&self, drive: &SurfaceRef, tool: &Tool) -> bool {
        /// Sine of the lean of a plane that counts as upright.
        const UPRIGHT: f64 = 1e-9;
        let s = &self.settings;
        let beside = matches!(s.drive_side, Some(DriveSide::Tllft | DriveSide::Tlrgt));
        if !beside || s.thick[1] != 0.0 {
            return false;
        }
        let Some(Surface::Plane(plane)) = self.fitted.of(&drive.form) else { return false };
        let Band { intol, outtol } = s.band(Role::Drive);
        let wide =
            matches!(s.profile(Role::Drive), Some(Ok(p)) if p.widest() > 2.0 * (intol + outtol));
        let upright = plane.n.dot(&tool.ta).abs() <= UPRIGHT;
        upright && wide && self.stands_on(drive, Role::Drive, tool)
    }

    /// Is the tool end on the surface, as GO/ON leaves it? A point or a needle touches where its end is on it: on the narrow
    /// side of the band it stands beside.
    pub(crate) fn stands_on(&self, surface: &SurfaceRef, role: Role, tool: &Tool) -> bool {
        let Band { intol, outtol } = self.settings.band(role);
        let thin = matches!(self.settings.profile(role), Some(Ok(p)) if p.widest() == 0.0);
        let slack = 1e-6 * (intol + outtol);
        let [inside, outside] =
            if thin { [intol + slack, outtol + slack] } else { [intol + outtol; 2] };
        let at = self.fitted.of(&surface.form).map(|s| s.distance(tool.te));
        at.is_some_and(|d| (-inside..=outside).contains(&d))
    }

    /// Does the tool cut into the surface as deep from either side, so that it has none?
    pub(crate) fn between_sides(
        &self,
        surface: &SurfaceRef,
        wall: Option<&(Relation, Wall)>,
        tool: &Tool,
    ) -> bool {
        let (Some((_, wall)), Some(form)) = (wall, self.fitted.of(&surface.form)) else {
            return false;
        };
        let at = aptc_contact::Tool { profile: &wall.profile, te: tool.te, ta: tool.ta };
        let near = 1e-3 * (wall.band.intol + wall.band.outtol);
        let on = |side: Side| gap(&at, &form, side, 0.0);
        wall.profile.widest() > 0.0
            && on(Side::Positive).is_ok_and(|a| {
                a.g < 0.0 && on(Side::Negative).is_ok_and(|b| (a.g - b.g).abs() <= near)
            })
    }

    /// Does the cutter touch the part surface, to within the width of its band?
    pub(crate) fn touches(&self, part: &SurfaceRef, tool: &Tool) -> bool {
        let Ok(wall) = self.wall(part, Role::Part, false) else { return false };
        let Some(surface) = &wall.fitted else { return false };
        let at = aptc_contact::Tool { profile: &wall.profile, te: tool.te, ta: tool.ta };
        [Side::Positive, Side::Negative, Side::Open].into_iter().any(|side| {
            gap(&at, surface, side, wall.thick)
                .is_ok_and(|g| g.g.abs() <= wall.band.intol + wall.band.outtol)
        })
    }

    /// May the plane routine be tried?
    pub(crate) fn plane_allowed(&self, axis: &AxisRule) -> bool {
        self.settings.calc == Dimension::Two && !axis.turns()
    }

    /// The part surface in force, with AUTOPS laid through the tool.
    pub(crate) fn part(&self, tool: &Tool) -> SurfaceRef {
        match &self.settings.part {
            Part::Surface(s) => s.clone(),
            Part::Auto => auto_part(tool.te, tool.ta),
        }
    }

    pub(crate) fn wall(&self, surface: &SurfaceRef, role: Role, on: bool) -> Result<Wall, Failure> {
        let s = &self.settings;
        if surface_of(surface).is_none() {
            return Err(Failure::NotASurface { surface: surface.clone() });
        }
        let profile = match s.profile(role) {
            Some(Ok(p)) => p,
            Some(Err(why)) => return Err(Failure::BadCutter { why }),
            // A point stands for the cutter where its shape does not matter.
            None if on || self.is_square(surface, role) => Profile::disk(0.0, 0.0)
                .map_err(|_| Failure::NoCutter { surface: surface.clone() })?,
            None => return Err(Failure::NoCutter { surface: surface.clone() }),
        };
        let thick = if on { 0.0 } else { s.thick(role) };
        // Deeper than its radius the cutter would be past the surface. Of a cutter that is not given nothing is known.
        let radius = profile.widest();
        if s.profile(role).is_some() && -thick > radius + SAME * profile.reach() {
            return Err(Failure::ThickBeyond { surface: surface.clone(), thick, radius });
        }
        let disk = s.disk(role).map(|(r, h)| [r, h]);
        let mut fitted = self.fitted.of(&surface.form);
        let mut reversed = false;
        if let (Some(Surface::Quadric(q)), false) = (&mut fitted, on)
            && q.convexity() == -1
            && let Some(other) = q.reversed()
        {
            (*q, reversed) = (Arc::new(other), true);
        }
        let (surface, band) = (surface.clone(), s.band(role));
        let (below, outside) = (false, false);
        let wall =
            Wall { surface, fitted, reversed, profile, disk, on, thick, band, below, outside };
        Ok(match self.tool {
            Some(tool) => wall.seen_from(tool.te, tool.ta),
            None => wall,
        })
    }

    /// A part plane square to the axis is touched by the tool end of any cutter.
    pub(crate) fn is_square(&self, surface: &SurfaceRef, role: Role) -> bool {
        let ta = self.tool.map_or_else(Vec3::z, |t| t.ta);
        match surface.form.shape() {
            Form::Plane(p) => role == Role::Part && p.n.cross(&ta).norm() <= 1e-9,
            _ => false,
        }
    }
}

/// Can the form guide a tool?
fn surface_of(s: &SurfaceRef) -> Option<()> {
    s.form.is_surface().then_some(())
}
