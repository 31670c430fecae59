//! From where the tool comes to a statement, and where motion from point to point leads it.

use std::sync::Arc;

use aptc_cldata::{Control, Motion, MotionKind, Position};
use aptc_diagnostics::Origin;
use aptc_geometry::Profile;

use super::Verifier;
use crate::batch::Event;
use crate::behind::Behind;

impl Verifier {
    /// Keeps from where the tool comes to the statement of a motion; the extra motions of GCLEAR belong to it.
    pub(super) fn comes(&mut self, motion: &Motion, origin: &Origin) {
        let (before, along, came) = &mut self.statement;
        // Of records of which nothing tells the statement each motion is one, but for those under one control.
        let goes_on = match (&motion.control, &*along) {
            (Some(new), Some(old)) => Arc::ptr_eq(new, old),
            _ => before == origin && *origin != Origin::default(),
        };
        if !goes_on {
            (*before, *along, *came) = (origin.clone(), None, self.came);
            self.led.clear();
            self.led.extend(self.last);
            self.led_on = false;
            self.chains.statement();
            self.waiting.extend(self.behind.over().map(Event::Behind));
        }
        *along = motion.control.clone().or(along.take());
    }

    /// Keeps the way at feed on which a statement leads the tool to its next motion along surfaces.
    pub(super) fn leads(&mut self, motion: &Motion, rapid: bool) {
        if rapid || motion.control.is_some() {
            self.led.clear();
            self.led.extend(motion.points.last());
            self.led_on = motion.control.is_some();
        } else {
            self.led.extend_from_slice(&motion.points);
        }
    }

    /// That way, from where the machine has left the tool since.
    pub(super) fn way(&mut self) -> Vec<Position> {
        if self.led.last() == self.last.as_ref() {
            std::mem::take(&mut self.led)
        } else {
            self.last.into_iter().collect()
        }
    }

    /// Another tool goes on, or from another place.
    pub(super) fn breaks(&mut self) {
        self.waiting.extend(self.chains.breaks().map(Event::Chain));
    }

    /// Keeps motion from point to point until it is known where it leads. What goes along a curve is not held.
    pub(super) fn chained(
        &mut self,
        motion: &Motion,
        origin: &Origin,
        control: Option<&Arc<Control>>,
        rapid: bool,
        profile: &Profile,
    ) {
        if let Some(control) = control {
            // Of regional milling the first vector leads to it.
            let begins = self.open.is_none() && control.milling.as_ref().is_some_and(|m| !m.joined);
            let to = motion.points.first().filter(|_| begins);
            self.waiting.extend(self.chains.along(to).map(Event::Chain));
        } else if motion.kind != MotionKind::Goto {
            self.breaks();
        } else if !self.cycle && !Behind::takes(motion, self.statement.1.as_ref()) {
            let held = Some(origin).filter(|_| !rapid && !self.silent && motion.points.len() == 1);
            let pad = self.pad(&motion.points, profile);
            let before = self.chains.add(self.last, motion, held, (profile, pad));
            self.waiting.extend(before.map(Event::Chain));
        }
    }
}
