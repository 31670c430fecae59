//! CHKSRF in ordinary motion.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_diagnostics::Origin;
use aptc_geometry::{Form, Profile, Sculptured, Vec3};

use crate::avoid::Avoid;
use crate::failure::{Deep, Failure};
use crate::guard::{Checked, Guard};
use crate::outline::same_form;
use crate::plain::Plain;
use crate::regional::{Failed, Regional};
use crate::warning::too_thin;

/// What is known of the tool along the records.
#[derive(Clone, Debug, Default)]
pub(crate) struct Watch {
    profile: Option<Profile>,
    /// Where the way to the next point begins.
    pub(crate) last: Option<(Vec3, Vec3)>,
    /// Surfaces of triangles of which it is known, or told, where the tool is since it moves on from place to place.
    pub(crate) outside: Vec<Arc<Sculptured>>,
    /// Is it told that the tool is too thin to be seen?
    thin: bool,
}

impl Regional {
    /// Holds the motions of the arithmetic element from `records[from]` on against the surfaces of CHKSRF: those
    /// that it names, and with PS the sculptured part surface of each motion. AVCTRL is for regional milling:
    /// here a gouge is an error, and the motion ends before it.
    ///
    /// # Errors
    /// A motion gouges; see [`Regional::take_diagnostics`]. Where the tool stands is then unknown.
    pub fn watch(&mut self, records: &mut Vec<cl::Record>, from: usize) -> Result<(), Failed> {
        let mut cut = None;
        let came = self.came;
        for (i, record) in records.iter_mut().enumerate().skip(from) {
            match &mut record.kind {
                cl::Kind::Cutter(c) => self.watch.profile = Profile::new(c).ok(),
                cl::Kind::Motion(motion) => {
                    let found = self.watched(&record.origin, motion, came);
                    let recorded = self.is_recording();
                    if let Err((k, failure)) = found {
                        cut_short(motion, k);
                        self.put_out(motion);
                        self.diagnostics.extend(failure.explain(&record.origin));
                        cut = Some(if k == 0 { i } else { i + 1 });
                        break;
                    }
                    if !recorded {
                        self.put_out(motion);
                        if motion.kind == cl::MotionKind::From {
                            self.watch.outside.clear();
                        }
                        let last = motion.points.last().map(|p| (p.te, p.ta));
                        self.watch.last = last.or(self.watch.last);
                    }
                }
                _ => {}
            }
        }
        let Some(end) = cut else { return Ok(()) };
        records.truncate(end);
        (self.watch.last, self.stand) = (None, None);
        Err(Failed)
    }

    /// The way from where the tool was put out last to the first position of a statement of regional milling, whose paths
    /// are checked on their own. Where a first position is left out the way to the second was looked at.
    pub(crate) fn comes_to(&mut self, records: &[cl::Record]) -> Result<(), Failure> {
        let motion = records.iter().find_map(|r| match &r.kind {
            cl::Kind::Motion(motion) => Some(motion),
            _ => None,
        });
        let milling = motion.and_then(|m| m.control.as_ref()?.milling.as_ref());
        let to = motion.and_then(|m| m.points.first()).map(|p| (p.te, p.ta));
        let Some(to) = to.filter(|_| !self.is_recording()) else { return Ok(()) };
        let here = self.watch.last;
        if let (Some(here), Some(milling)) = (here, milling.filter(|m| !m.joined)) {
            let holder = self.holder.clone();
            let mut guard = self.guarded(None).unwrap_or(Guard { holder, ..Guard::default() });
            if let Some(part) = milling.part.as_ref().filter(|_| milling.guarded) {
                let surface = self.whole(&part.surface);
                let (name, tree) = (part.name.name.to_string(), self.tree(&surface));
                Checked::part(name, surface, tree).put(&mut guard.surfaces);
                guard.thick = part.thick;
            }
            if let Some((_, Failure::Way(deep))) = self.blocked(&guard, Some(here), &[to]) {
                return Err(Failure::WayIn(deep));
            }
        }
        match self.settings.profile {
            Some(profile) => self.stands_outside(&profile, here.unwrap_or(to)),
            None => Ok(()),
        }
    }

    /// Motions of regional milling were put out, which are not watched; what is only recorded was not.
    pub(crate) fn went(&mut self, records: &[cl::Record]) {
        if self.is_recording() {
            return;
        }
        for record in records {
            if let cl::Kind::Motion(motion) = &record.kind {
                self.put_out(motion);
                self.watch.last = self.came;
            }
        }
    }

    /// From its end the tool comes to the next statement.
    pub(crate) fn put_out(&mut self, motion: &cl::Motion) {
        self.came = motion.points.last().map(|p| (p.te, p.ta)).or(self.came);
    }

    /// Tells once that the cutter goes unseen through a sheet or triangles that are checked: nothing gets as deep in it as may be.
    pub(crate) fn tells_thin(&mut self, origin: &Origin, guard: Option<&Guard>) {
        let (Some(profile), false) = (self.settings.profile, self.watch.thin) else { return };
        let deepest = profile.widest().min(0.5 * (profile.height() - profile.bottom()));
        let allowed =
            |s: &Checked, guard: &Guard| self.touching().max(guard.intol) - guard.left_on(s);
        let thin = guard.and_then(|guard| {
            let mut all = guard.surfaces.iter().map(|s| (s, allowed(s, guard)));
            all.find(|(_, allowed)| deepest <= *allowed)
        });
        if let Some((surface, allowed)) = thin {
            self.diagnostics.push(too_thin(origin, &surface.name, allowed));
            self.watch.thin = true;
        }
    }

    /// The first point whose way gouges; the tool came to the statement from `came`.
    fn watched(
        &mut self,
        origin: &Origin,
        motion: &cl::Motion,
        came: Option<(Vec3, Vec3)>,
    ) -> Result<(), (usize, Failure)> {
        let moves = motion.kind != cl::MotionKind::From && !self.is_recording();
        let (Some(profile), true) = (self.watch.profile, moves) else { return Ok(()) };
        let first = motion.points.first().map(|p| (p.te, p.ta));
        if motion.control.as_ref().is_some_and(|c| c.part.is_some()) {
            self.settings.axis_idle = false;
            self.tells_bare_holder(origin);
        }
        let Some(mut guard) = self.motion_guard(motion).map_err(|f| (0, f))? else { return Ok(()) };
        self.tells_thin(origin, Some(&guard));
        if let Some(from) = came.or(first) {
            guard.come_from(&profile, from);
        }
        let points = motion.points.iter().map(|p| (p.te, p.ta));
        first_gouge(&guard, &profile, self.watch.last, points).map_or(Ok(()), Err)?;
        match self.watch.last.or(first) {
            Some(at) => self.stands_outside(&profile, at).map_err(|f| (0, f)),
            None => Ok(()),
        }
    }

    /// That the tool stands in no body of triangles, none of which it touches. It is asked once: wherever a tool wider than it may
    /// touch goes on to it would touch them first, and what is told once need not be told again.
    fn stands_outside(&mut self, cutter: &Profile, at: (Vec3, Vec3)) -> Result<(), Failure> {
        let known = |c: &&Checked| self.watch.outside.iter().any(|s| Arc::ptr_eq(s, &c.surface));
        let new = |c: &&Checked| c.body.is_some() && !known(c);
        let surfaces: Vec<Checked> = self.checked.iter().filter(new).cloned().collect();
        let holder = self.holder.clone();
        let guard = Guard { surfaces, holder, intol: self.touching(), ..Guard::default() };
        let held = guard.held(cutter, at);
        self.watch.outside.extend(guard.surfaces.into_iter().map(|c| c.surface));
        held.map_or(Ok(()), |gouge| {
            let (te, ta) = at;
            Err(Failure::Held(Box::new(Deep { gouge, te, ta, avoids: Avoid::default() })))
        })
    }

    /// The first of some points that regional milling goes to from point to point the way to which gouges, the tool coming
    /// from `here`.
    pub(crate) fn blocked(
        &self,
        guard: &Guard,
        here: Option<(Vec3, Vec3)>,
        points: &[(Vec3, Vec3)],
    ) -> Option<(usize, Failure)> {
        let (profile, first) = (self.settings.profile.as_ref()?, points.first()?);
        let mut guard = Guard { intol: self.touching(), ..guard.clone() };
        if guard.asks() {
            guard.come_from(profile, here.unwrap_or(*first));
        }
        first_gouge(&guard, profile, here, points.iter().copied())
    }

    /// How deep a tool that just touches may be in.
    pub(crate) fn touching(&self) -> f64 {
        let band = self.settings.band();
        cl::milling::Milling::touching(band.intol, band.outtol)
    }

    fn motion_guard(&mut self, motion: &cl::Motion) -> Result<Option<Guard>, Failure> {
        let (mut surfaces, mut plain) = self.named();
        let mut thick = 0.0;
        let control = motion.control.as_deref();
        // Where the motion itself is led along one of them it leaves no more than that asks for.
        let led = control.iter().flat_map(|c| c.drive.iter().chain(&c.part).chain(&c.checks));
        for led in led.filter(|led| led.thick < self.settings.thick_check) {
            let known = self.fitted.iter().find(|(f, _)| same_form(f, &led.form));
            let same = |s: &&mut Checked| known.is_some_and(|k| Arc::ptr_eq(&k.1, &s.surface));
            surfaces.iter_mut().filter(same).for_each(|s| s.thick = s.thick.min(led.thick));
            let same = |p: &&mut Plain| same_form(&p.form, &led.form);
            plain.iter_mut().filter(same).for_each(|p| p.thick = p.thick.min(led.thick));
        }
        let part = control.and_then(|c| c.part.as_ref()).filter(|_| self.check_part);
        if let Some(part) = part.filter(|p| p.side != 0 && matches!(p.form.shape(), Form::Ssurf(_)))
        {
            let name = aptc_protap::NameRef {
                name: part.name.name.clone(),
                subscript: part.name.subscript,
            };
            let surface = self.surface(&name, &part.form)?;
            let (name, tree) = (name.name.to_string(), self.tree(&surface));
            Checked::part(name, surface, tree).put(&mut surfaces);
            thick = part.thick;
        }
        let intol = self.touching();
        let (holder, report) = (self.holder.clone(), false);
        let guard = Guard { surfaces, plain, intol, thick, holder, report, tilting: None };
        Ok((!guard.is_empty()).then_some(guard))
    }
}

/// A motion of which `k` points are left. It never came to its check surface, and a start-up not to its surfaces: nothing is to
/// be proved of them.
fn cut_short(motion: &mut cl::Motion, k: usize) {
    motion.points.truncate(k);
    if motion.kind != cl::MotionKind::Continuous {
        motion.control = None;
    } else if let Some(control) = &mut motion.control {
        Arc::make_mut(control).checks.clear();
    }
}

/// The first point the way to which gouges, from the one before; the tool comes to the first from `here`, if that is known.
fn first_gouge(
    guard: &Guard,
    profile: &Profile,
    mut here: Option<(Vec3, Vec3)>,
    points: impl Iterator<Item = (Vec3, Vec3)>,
) -> Option<(usize, Failure)> {
    for (k, to) in points.enumerate() {
        let ends = [here.unwrap_or(to), to];
        if let Err(gouge) = guard.way(profile, ends) {
            let gouge = guard.deepest(profile, ends, gouge);
            let deep = Deep { gouge, te: to.0, ta: to.1, avoids: Avoid::default() };
            return Some((k, Failure::Way(Box::new(deep))));
        }
        here = Some(to);
    }
    None
}
