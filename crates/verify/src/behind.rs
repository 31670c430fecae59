//! What GCLEAR puts behind a line of GOLOFT, which leads the tool away from it at feed.

use std::sync::Arc;

use aptc_cldata::{Control, Motion, MotionKind};
use aptc_diagnostics::Diagnostic;

use crate::certificate::Fault;
use crate::free::Rapid;

/// The motions behind the last line of a statement, with the place where that ends. What comes before a further line of it is held
/// against the part surface there.
#[derive(Debug, Default)]
pub(crate) struct Behind(Option<Box<Rapid>>);

impl Behind {
    /// Does a motion at feed belong to the statement of a line of regional milling that it comes after?
    pub(crate) fn takes(motion: &Motion, along: Option<&Arc<Control>>) -> bool {
        let milled = |c: &Arc<Control>| c.milling.as_ref().is_some_and(|m| m.part.is_some());
        motion.kind == MotionKind::Goto && motion.control.is_none() && along.is_some_and(milled)
    }

    /// Takes such a motion, as a way from where the tool was before it.
    pub(crate) fn add(&mut self, way: Rapid) {
        match &mut self.0 {
            Some(known) => {
                known.points.extend(way.points.into_iter().skip(1));
                known.pad = known.pad.max(way.pad);
            }
            None => self.0 = Some(Box::new(way)),
        }
    }

    /// They lead to a further line of the statement.
    pub(crate) fn goes_on(&mut self) {
        self.0 = None;
    }

    /// The statement is over.
    pub(crate) fn over(&mut self) -> Option<Box<Rapid>> {
        self.0.take()
    }
}

/// That they lead into the part surface of their line.
pub(crate) fn into(way: &Rapid, fault: &Fault) -> Diagnostic {
    let who = "behind the line GCLEAR leads the tool";
    let help = "shorten what GCLEAR/THRU adds, or lead the tool off the surface with NORMAL or CLEARS; CHKSRF/PS,ON refuses such a way";
    fault.through(&way.origin, who, help)
}
