//! CHKSRF in ordinary motion.

use aptc_cldata as cl;
use aptc_geometry::{Form, Profile, Vec3};

use crate::failure::Failure;
use crate::guard::{Checked, Guard};
use crate::regional::{Failed, Regional};

/// What is known of the tool along the records.
#[derive(Clone, Debug, Default)]
pub(crate) struct Watch {
    profile: Option<Profile>,
    last: Option<(Vec3, Vec3)>,
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
        for (i, record) in records.iter_mut().enumerate().skip(from) {
            match &mut record.kind {
                cl::Kind::Cutter(c) => self.watch.profile = Profile::new(c).ok(),
                cl::Kind::Motion(motion) => {
                    if let Err((k, failure)) = self.watched(motion) {
                        motion.points.truncate(k);
                        self.diagnostics.push(failure.explain(&record.origin));
                        cut = Some(if k == 0 { i } else { i + 1 });
                        break;
                    }
                    let last = motion.points.last().map(|p| (p.te, p.ta));
                    self.watch.last = last.or(self.watch.last);
                }
                _ => {}
            }
        }
        let Some(end) = cut else { return Ok(()) };
        records.truncate(end);
        (self.watch.last, self.stand) = (None, None);
        Err(Failed)
    }

    /// The tool stands there after a motion that is not watched.
    pub(crate) fn watch_from(&mut self, te: Vec3, ta: Vec3) {
        self.watch.last = Some((te, ta));
    }

    /// The first point whose way gouges.
    fn watched(&mut self, motion: &cl::Motion) -> Result<(), (usize, Failure)> {
        let moves = motion.kind != cl::MotionKind::From && !self.is_recording();
        let (Some(profile), true) = (self.watch.profile, moves) else { return Ok(()) };
        let Some(guard) = self.motion_guard(motion).map_err(|f| (0, f))? else { return Ok(()) };
        let mut here = self.watch.last;
        for (k, p) in motion.points.iter().enumerate() {
            let to = (p.te, p.ta);
            guard
                .way(&profile, [here.unwrap_or(to), to])
                .map_err(|gouge| (k, Failure::gouge(gouge, p.te, p.ta, false)))?;
            here = Some(to);
        }
        Ok(())
    }

    fn motion_guard(&mut self, motion: &cl::Motion) -> Result<Option<Guard>, Failure> {
        let mut surfaces = self.checked.clone();
        let mut thick = 0.0;
        let part =
            motion.control.as_ref().and_then(|c| c.part.as_ref()).filter(|_| self.check_part);
        if let Some(part) = part.filter(|p| p.side != 0 && matches!(p.form.shape(), Form::Ssurf(_)))
        {
            let name = aptc_protap::NameRef {
                name: part.name.name.clone(),
                subscript: part.name.subscript,
            };
            let surface = self.surface(&name, &part.form)?;
            let (name, tree) = (name.name.to_string(), self.tree(&surface));
            surfaces.retain(|c| !std::sync::Arc::ptr_eq(&c.surface, &surface));
            surfaces.push(Checked { name, surface, tree, part: true });
            thick = part.thick;
        }
        let band = self.settings.band();
        // A tool that just touches is not in.
        let intol = band.intol.max(0.01 * (band.intol + band.outtol));
        let (holder, report, plain) = (self.holder.clone(), false, self.plain.clone());
        let mut guard = Guard { surfaces, plain, intol, thick, holder, report };
        guard.come_from(self.watch.profile.as_ref(), self.watch.last);
        Ok((!guard.is_empty()).then_some(guard))
    }
}
