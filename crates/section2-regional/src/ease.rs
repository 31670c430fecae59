//! A position raised within the band where the cutter beside its contact would be too deep.

use aptc_contact::{Clear, PatchPlace, Tool};

use crate::position::Position;
use crate::settings::Band;
use crate::solve::{LOOKS, Setup};

/// Times that a position is raised.
const TIMES: usize = 4;
/// Part of the band by which it is raised more than it has to be, for the chords beside it.
const MORE: f64 = 0.02;
/// How exactly the deepest place is asked for, in parts of the band.
const FINE: f64 = 1e-3;

impl Setup<'_> {
    /// The position for chords beside which the whole cutter keeps the band of the part surface: lowered less, or raised, where its
    /// bottom or rim comes deeper into a hollow than the contact. Where all of the band does not suffice for it the cutter
    /// touches, or as nearly as OUTTOL lets it, and is not lowered.
    pub(crate) fn eased(&self, p: Position) -> Position {
        if self.leads() || !self.part.touches {
            return p;
        }
        let Band { intol, outtol } = self.band;
        let band = intol + outtol;
        let (tree, allowed) = (&self.part.tree, intol - self.part.thick);
        let highest = self.highest();
        let raised = |p: &Position, by: f64| Position {
            te: p.te + p.normal * by,
            shift: p.shift + by,
            ..*p
        };
        let mut now = p;
        for _ in 0..TIMES {
            let tool = Tool { profile: self.profile, te: now.te, ta: now.ta };
            let seen = match tree.clear_by(&tool, allowed, LOOKS) {
                Clear::Yes => return now,
                Clear::No(place) | Clear::Unknown(place) => place,
            };
            let by = |place: &PatchPlace| (-place.distance - allowed).max(0.0) + MORE * band;
            let room = highest - now.shift;
            // The first place that is too deep may be so by more than all of the band: which is deepest does not matter then.
            if by(&seen) > room {
                break;
            }
            let Some((place, _)) = tree.deepest(&tool, FINE * band) else { break };
            let by = by(&place);
            if by > room {
                break;
            }
            now = raised(&now, by);
        }
        // Without OUTTOL the very top of the band leaves no room for a chord.
        let touches = highest.min(0.0);
        if p.shift < touches { raised(&p, touches - p.shift) } else { p }
    }
}
