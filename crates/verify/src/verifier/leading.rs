//! From where the tool comes to a statement, and on which way.

use std::sync::Arc;

use aptc_cldata::{Motion, Position};
use aptc_diagnostics::Origin;

use super::Verifier;
use crate::batch::Event;

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
}
