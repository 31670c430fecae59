//! The way of a start-up: what it promises is where it ends, and what the tool goes through before is told.

use aptc_cldata::milling::Milling;
use aptc_cldata::{Control, Controlled, Position, Relation};
use aptc_geometry::{Form, Profile};

use crate::between::{NO_TURN, angle, between_poses};
use crate::certificate::Fault;
use crate::judged::{called, disk};
use crate::milled::MilledSurface;
use crate::sheets::Sheets;
use crate::statement::{Seen, keep};
use crate::tool::Pose;

/// The surfaces that the tool ends beside, each held against its way there.
#[derive(Debug)]
pub(crate) struct Coming(Vec<Beside>);

#[derive(Debug)]
struct Beside {
    surface: MilledSurface,
    called: String,
    /// The disk of CUTTER/OPTION, which stands for the cutter.
    disk: Option<Profile>,
}

/// Places at which a tool that turns on its way is looked at: that it goes in nowhere is not promised, and need not be proved.
const LOOKS: u32 = 64;

impl Coming {
    /// Of a start-up of the tool from `from`. What it ends on (ON) or goes past it may go through, a plane only where SRFVCT
    /// asks for that, and of a motion at rapid the part surface is judged elsewhere.
    pub(crate) fn new(
        control: &Control,
        sheets: &Sheets,
        profile: &Profile,
        from: &Position,
        rapid: bool,
    ) -> Self {
        let part = control.part.as_ref().filter(|_| !rapid).map(|c| (c, "part"));
        let drive = control.drive.iter().map(|c| (c, "drive"));
        let all = drive.chain(part).chain(control.checks.iter().map(|c| (c, "check")));
        let ends_beside = |(c, _): &(&Controlled, _)| {
            let flat = matches!(c.form.shape(), Form::Plane(_) | Form::Line(_));
            let passed = matches!(c.relation, Relation::On | Relation::Past);
            c.side != 0 && !flat && !passed
        };
        let beside = |(c, role): (&Controlled, &'static str)| {
            // A thickness is left at the end of the way, where its surface is not to be met before.
            let depth = Milling::touching(c.intol, c.outtol) - c.thick.min(0.0);
            let disk = disk(c);
            let from = (disk.as_ref().unwrap_or(profile), from);
            let surface = MilledSurface::beside(&c.form, depth, sheets, from)?;
            Some(Beside { surface, called: called(c, role), disk })
        };
        Self(all.filter(ends_beside).filter_map(beside).collect())
    }

    /// The deepest place on the way where a surface is in the tool that was not in it before.
    pub(crate) fn fault(
        &self,
        profile: &Profile,
        from: &Position,
        to: &Position,
        pad: f64,
    ) -> Option<Fault> {
        let mut worst = None;
        for Beside { surface, called, disk } in &self.0 {
            let profile = disk.as_ref().unwrap_or(profile);
            if surface.encloses(profile, to) {
                continue;
            }
            let judge = |a: &Position, b: &Position| {
                let fault = surface.vector(profile, a, b, pad, 1, &mut Seen::default());
                fault.filter(|f| f.refuted)
            };
            // On which side it began is not known of a tool that stands in the surface.
            let fault = if angle(from.ta, to.ta) > NO_TURN {
                let mut deepest = None;
                (1..LOOKS).for_each(|i| {
                    let share = f64::from(i) / f64::from(LOOKS);
                    let at = between_poses(&Pose::of(from), &Pose::of(to), share);
                    let at = Position { te: at.te, ta: at.ta };
                    keep(&mut deepest, judge(&at, &at));
                });
                deepest
            } else {
                judge(from, to)
            };
            let fault = fault.filter(|_| judge(from, from).is_none());
            keep(&mut worst, fault.map(|f| Fault { surface: called.clone(), ..f }));
        }
        worst
    }
}
