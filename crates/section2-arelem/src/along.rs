//! Motion to and along surfaces: the routine is chosen, and what it gives is put out.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::Side;
use aptc_diagnostics::Origin;
use aptc_geometry::{Cutter, FormKind};
use aptc_protap as protap;
use aptc_protap::{Direction, Outcome, Relation, SurfaceRef};

use crate::arelem::Arelem;
use crate::diagram::Situation;
use crate::failure::{Candidate, Failure};
use crate::feed::divide;
use crate::points::put_feed;
use crate::scene::Path;
use crate::since::Since;
use crate::space::{Keep, Pose, Watch};
use crate::state::{Role, Tool};
use crate::warning;
use crate::{forward, plane, space};

impl Arelem {
    /// GO and OFFSET.
    pub(crate) fn start(
        &mut self,
        origin: &Origin,
        go: &protap::Go,
        out: &mut Vec<cl::Record>,
    ) -> Outcome {
        if self.poisoned {
            self.settings.given.clear();
            return Outcome::Failed;
        }
        let placed = self.tool.is_some();
        let tool = match self.tool {
            Some(tool) => tool,
            None => self.stand_at_zero(origin),
        };
        self.need_cutter(origin, go.surfaces.iter().map(|s| &s.1));
        self.chosen_contact(origin);
        let start = match self.start_scene(go, tool) {
            Ok(start) => start,
            Err(f) => return self.fail(origin, &f),
        };
        let flat = self.plane_allowed(&start.axis).then(|| plane::start(&start)).flatten();
        // With three surfaces, or with SRFVCT, APT-360 starts up in space although the plane has the answer.
        let sided = start.normals.iter().any(Option::is_some);
        let in_space = flat.is_none() || start.surfaces.len() > 2 || sided;
        let result = flat.unwrap_or_else(|| space::start(&start));
        for (i, (relation, surface)) in go.surfaces.iter().enumerate() {
            let sided = start.normals.get(i).copied().flatten().is_some();
            let asks = matches!(relation, Relation::To | Relation::Past) && !sided;
            // Without FROM it stands there by chance.
            if asks && placed && self.between_sides(surface, start.surfaces.get(i), &tool) {
                self.diagnostics.push(warning::no_side(origin, surface));
            }
        }
        let path = match result {
            Ok(path) => path,
            Err(f) => {
                let named = go.surfaces.iter().map(|(_, s)| s.clone()).enumerate().collect();
                self.picture(&f, &tool, named);
                return self.fail(origin, &f);
            }
        };
        if let (true, Some(end)) = (in_space && !start.offset, path.points.last()) {
            self.settings.part_normal_before = start.part_normal(end.te);
        }
        if let (false, Some(end)) = (path.rivals.is_empty(), path.points.last()) {
            let taken = Candidate::of(tool.te, end.te);
            self.diagnostics.push(warning::ambiguous(origin, &taken, &path.rivals));
        }
        if let (Some(far), [(_, drive), ..]) = (path.left, &go.surfaces[..]) {
            self.diagnostics.push(warning::left(origin, drive, far));
        }
        if let (1, Some(end)) = (go.surfaces.len(), path.points.last())
            && self.settings.lifts(tool.te.z, end.te.z)
        {
            self.diagnostics.push(warning::lifted(origin, tool.te.z));
        }
        self.settings.started = None;
        if let Some((relation, surface)) = go.surfaces.get(1) {
            self.settings.start_part(surface, *relation == Relation::On);
        }
        if let Some((relation, _)) = go.surfaces.first() {
            self.settings.start_side(*relation == Relation::On);
        }
        let name = go.surfaces.first().map(|(_, s)| forward::name(&s.name)).unwrap_or_default();
        self.arrive(origin, cl::MotionKind::Startup, name, path, out)
    }

    /// Motion along surfaces.
    pub(crate) fn drive(
        &mut self,
        origin: &Origin,
        d: &protap::Drive,
        out: &mut Vec<cl::Record>,
    ) -> Outcome {
        self.settings.given.clear();
        if self.poisoned {
            return Outcome::Failed;
        }
        let Some(tool) = self.tool else { return self.fail(origin, &Failure::NoPosition) };
        let part = self.part(&tool);
        let checks = d.checks.iter().map(|c| &c.surface);
        self.need_cutter(origin, [&d.drive, &part].into_iter().chain(checks));
        let stays_on = self.stays_on(&d.drive, &tool);
        let unsaid = self.unsaid_depth(&part, &tool);
        let result = self.path(d, tool);
        self.chosen_contact(origin);
        match result {
            Ok(path) => {
                if let Some(length) = self.settings.longest_path.take() {
                    self.diagnostics.push(warning::no_length(origin, length));
                }
                if tool.assumed && !matches!(d.direction, Direction::Goup | Direction::Godown) {
                    self.diagnostics.push(warning::assumed_direction(origin, d.direction));
                }
                if let Some(depth) = path.fouls {
                    self.diagnostics.push(warning::fouls(origin, &d.drive, depth));
                }
                if let Some(surface) = self.comes_back(d, &tool, &path) {
                    self.diagnostics.push(warning::comes_back(origin, surface));
                }
                if let Some((surface, depth)) = self.begins_in(d, &tool, &path) {
                    self.diagnostics.push(warning::begins_in(origin, surface, depth));
                }
                if let Some(depth) = unsaid {
                    self.diagnostics.push(warning::ends_on_part(origin, &part, depth));
                }
                if stays_on {
                    self.diagnostics.push(warning::stays_on(origin, &d.drive));
                }
                // One word that is wrong may hold for many motions.
                match path.astray {
                    Some(astray) if !self.settings.astray_told => {
                        self.diagnostics.push(warning::astray(origin, &d.drive, astray));
                    }
                    _ => {}
                }
                self.settings.astray_told = path.astray.is_some();
                let name = forward::name(&d.drive.name);
                self.arrive(origin, cl::MotionKind::Continuous, name, path, out)
            }
            Err(f) => {
                let checks = d.checks.iter().enumerate().map(|(i, c)| (2 + i, c.surface.clone()));
                let mut all = vec![(0, d.drive.clone()), (1, self.part(&tool))];
                all.extend(checks);
                self.picture(&f, &tool, all);
                let is_part = |c: &&protap::Check| same(&c.surface, &part);
                if let Some(check) = d.checks.iter().find(is_part).filter(|_| f.is_unmet()) {
                    let told = warning::check_is_part(f.explain(origin), &check.surface);
                    self.diagnostics.push(told);
                    return self.give_up();
                }
                match self.other_way(&f, d, tool) {
                    Some(word) => {
                        self.diagnostics.push(warning::other_way(f.explain(origin), word));
                        self.give_up()
                    }
                    None => self.fail(origin, &f),
                }
            }
        }
    }

    /// The plane at which PAST stopped a tool that is on the side from which it came: it went in and out again, which by the manual
    /// is where it is past.
    fn comes_back<'d>(
        &self,
        d: &'d protap::Drive,
        tool: &Tool,
        path: &Path,
    ) -> Option<&'d SurfaceRef> {
        let first = |c: &&protap::Check| c.relation == Relation::Past && c.nth <= 1;
        let check = d.checks.get(path.check).filter(first)?;
        let keep = Keep::of(&self.wall(&check.surface, Role::Check, false).ok()?).ok()?;
        let (start, end) = (Pose { te: tool.te, ta: tool.ta }, path.points.last()?);
        let end = Pose { te: end.te, ta: end.ta };
        // Of what touches on both sides, as a point, neither is that from which it came.
        let on = |pose: &Pose| {
            let [a, b] = [Side::Positive, Side::Negative].map(|s| keep.on_side(s).clears(pose));
            (a != b).then_some(a)
        };
        let back = keep.is_plane() && on(&start).is_some_and(|side| on(&end) == Some(side));
        back.then_some(&check.surface)
    }

    /// The check surface at which TO stopped a tool that stood in it where the motion began, and how deep it stood: it comes out of
    /// it first, on whichever side the motion leads to, and meets it there.
    fn begins_in<'d>(
        &self,
        d: &'d protap::Drive,
        tool: &Tool,
        path: &Path,
    ) -> Option<(&'d SurfaceRef, f64)> {
        let first = |c: &&protap::Check| c.relation == Relation::To && c.nth <= 1;
        let check = d.checks.get(path.check).filter(first)?;
        let keep = Keep::of(&self.wall(&check.surface, Role::Check, false).ok()?).ok()?;
        let start = Pose::standing(tool);
        let depth = Watch::new(&keep, check.relation, check.nth, &start).depth(&start)?;
        Some((&check.surface, depth))
    }

    fn path(&self, d: &protap::Drive, tool: Tool) -> Result<Path, Failure> {
        let scene = self.scene(d, tool)?;
        let flat = self.plane_allowed(&scene.axis) && scene.tool.stands();
        let flat = flat.then(|| plane::run(&scene)).flatten();
        flat.unwrap_or_else(|| space::run(&scene)).map_err(|f| match f {
            Failure::NoTangency { allowed, .. } => scene.too_tight(allowed).unwrap_or(f),
            f => f,
        })
    }

    /// The opposite direction, where it leads to a check surface that this one does not.
    fn other_way(&self, f: &Failure, d: &protap::Drive, tool: Tool) -> Option<Direction> {
        if !f.never_met() {
            return None;
        }
        let direction = match d.direction {
            Direction::Golft => Direction::Gorgt,
            Direction::Gorgt => Direction::Golft,
            Direction::Gofwd => Direction::Goback,
            Direction::Goback => Direction::Gofwd,
            Direction::Goup => Direction::Godown,
            Direction::Godown => Direction::Goup,
        };
        let path = self.path(&protap::Drive { direction, ..d.clone() }, tool).ok()?;
        path.astray.is_none().then_some(direction)
    }

    /// Says once that a place of contact chosen by TLAXIS does not count.
    fn chosen_contact(&mut self, origin: &Origin) {
        if std::mem::take(&mut self.settings.contact_chosen) {
            self.diagnostics.push(warning::contact_not_chosen(origin));
        }
    }

    /// Along sculptured surfaces a missing CUTTER stands for a point, as in APT4; the message says so once.
    fn need_cutter<'a>(
        &mut self,
        origin: &Origin,
        surfaces: impl IntoIterator<Item = &'a SurfaceRef>,
    ) {
        if self.settings.cutter.is_some() || self.failed_before {
            return;
        }
        let sculptured = |s: &&SurfaceRef| s.form.kind() == FormKind::Ssurf;
        if let Some(surface) = surfaces.into_iter().find(sculptured) {
            self.settings.set_cutter(Cutter::mill(0.0, 0.0, 0.0), 0);
            self.diagnostics.push(warning::point_taken(origin, surface));
        }
    }

    /// Keeps the situation of the first failure for a picture.
    fn picture(&mut self, failure: &Failure, tool: &Tool, surfaces: Vec<(usize, SurfaceRef)>) {
        if self.situation.is_none() {
            self.situation = Some(Situation {
                tool: *tool,
                profile: self.settings.profile(Role::Check).and_then(Result::ok),
                surfaces,
                place: failure.place(),
                text: failure.text(),
            });
        }
    }

    pub(crate) fn arrive(
        &mut self,
        origin: &Origin,
        kind: cl::MotionKind,
        name: cl::NameRef,
        path: Path,
        out: &mut Vec<cl::Record>,
    ) -> Outcome {
        if let Some((surface, far)) = self.wholly_beyond(kind, &path).filter(|_| self.settings.cut)
        {
            self.diagnostics.push(warning::wholly_beyond(origin, &surface, far));
        }
        let start = self.tool.map(|t| Pose::standing(&t));
        if let (Some(end), Some(tool)) = (path.points.last(), &mut self.tool) {
            (tool.te, tool.ta, tool.stood) = (end.te, end.ta, None);
            tool.turn(path.forward);
        }
        let control = Arc::new(path.control);
        self.ended = Some((Arc::clone(&control), self.settings.cutter));
        self.since = Since::default();
        let motion = cl::Motion {
            kind,
            name,
            arc: path.arc,
            points: path.points,
            with_axis: self.settings.multax,
            control: Some(control),
        };
        let slow = if kind == cl::MotionKind::Continuous { self.feed.slow() } else { None };
        match (slow, start) {
            (Some((slow, base)), Some(start)) if self.settings.cut => {
                let (before, near) =
                    divide(start, &motion.points, slow.distance, motion.arc.as_ref());
                if !before.is_empty() {
                    self.put_motion(origin, cl::Motion { points: before, ..motion.clone() }, out);
                }
                put_feed(origin, slow.feed, out);
                self.put_motion(origin, cl::Motion { points: near, ..motion }, out);
                if !base.is_empty() {
                    put_feed(origin, base, out);
                }
            }
            _ => self.put_motion(origin, motion, out),
        }
        self.moved(path.check)
    }
}

/// Do both name one surface?
fn same(a: &SurfaceRef, b: &SurfaceRef) -> bool {
    Arc::ptr_eq(&a.form, &b.form) || a.form == b.form
}
