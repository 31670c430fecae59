//! CYCLE with its values, and the heights that they give.

use smol_str::SmolStr;

use crate::state::Feedrate;

/// CYCLE with its values, lengths in CL units until used.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DrillCycle {
    /// DRILL, DEEP ...
    pub(crate) kind: SmolStr,
    /// From the programmed point down to the bottom, along the tool axis.
    pub(crate) depth: f64,
    /// The heights as they were said, from which `clear` and `retract` follow.
    pub(crate) said: Heights,
    /// From the point up to where the feed begins.
    pub(crate) clear: Option<f64>,
    /// From the point up to where the tool ends.
    pub(crate) retract: Option<f64>,
    /// RTRCTO,AUTO: back to the height from which the tool came.
    pub(crate) retract_auto: bool,
    pub(crate) feed: Option<Feedrate>,
    /// A feed that was said beside PITCH, which `feed` is then; both must be the same.
    pub(crate) beside_pitch: Option<Feedrate>,
    /// PITCH, CL units.
    pub(crate) pitch: Option<f64>,
    /// Pecks: the first and the others.
    pub(crate) first_step: Option<f64>,
    pub(crate) step: Option<f64>,
    /// Seconds.
    pub(crate) dwell: Option<f64>,
    /// Revolutions of the spindle instead.
    pub(crate) dwell_rev: Option<f64>,
    /// Has a fault of it been told, that no clearance is given or no step? It is one of the cycle, not of each hole.
    pub(crate) told: bool,
}

/// Heights of a cycle above the point, CL units, each under the word that gave it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Heights {
    pub(crate) clear: Option<f64>,
    pub(crate) rapto: Option<f64>,
    /// RTRCTO or RETURN; zero, which CATIA writes, asks for none beside the clearance.
    pub(crate) retract: Option<f64>,
}

impl Heights {
    /// The same, with what another statement said in its place.
    pub(crate) fn or(self, before: Self) -> Self {
        Self {
            clear: self.clear.or(before.clear),
            rapto: self.rapto.or(before.rapto),
            retract: self.retract.or(before.retract),
        }
    }

    /// Where CLEAR and RAPTO both stand, the feed begins at the nearer one and the tool ends at the farther one.
    pub(crate) fn clearance(&self) -> Option<f64> {
        match (self.clear, self.rapto) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        }
    }

    /// Where the tool ends, if it is said.
    pub(crate) fn end(&self) -> Option<f64> {
        let far = self.clear.zip(self.rapto).map(|(a, b)| a.max(b));
        match self.retract {
            Some(0.0) => self.clearance(),
            retract => retract.or(far),
        }
    }
}
