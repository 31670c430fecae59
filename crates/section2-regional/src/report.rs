//! PRINT/AVMSG and PRINT/AVPRT: what was done about a gouge.

use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::Vec3;

use crate::avoid::Avoided;
use crate::failure::{point, short};
use crate::guard::Gouge;

/// A statement tells of so many gouges; the rest is counted.
const TOLD: usize = 200;

/// A gouge that was avoided.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Note {
    pub(crate) gouge: Gouge,
    /// The tool that made it.
    pub(crate) te: Vec3,
    pub(crate) ta: Vec3,
    pub(crate) how: Avoided,
}

/// The report of a statement, in the order of its path.
///
/// APT: `INTMSG` and `AVMSG`.
pub(crate) fn reports(origin: &Origin, notes: &[Note]) -> Vec<Diagnostic> {
    let at = |text: String| {
        Diagnostic::note_at(codes::AVOIDED, origin.span, text).within(origin.trace.clone())
    };
    let mut all: Vec<Diagnostic> = notes
        .iter()
        .take(TOLD)
        .map(|n| {
            let Gouge { surface, depth, .. } = &n.gouge;
            let text = format!(
                "interference with {surface}, {} deep{}, avoided by {}",
                short(*depth),
                n.gouge.placed(),
                said(&n.how)
            );
            let before = format!("the tool end was {} with axis {}", point(n.te), point(n.ta));
            let after = format!("it is {} with axis {}", point(n.how.te), point(n.how.ta));
            at(text).note(before).note(after)
        })
        .collect();
    if notes.len() > TOLD {
        let more = notes.len() - TOLD;
        all.push(at(format!("interference avoided at {more} further places of this statement")));
    }
    all
}

/// Where nothing limits the lift of AVCTRL the tool may go far off to get out of the way.
pub(crate) fn lifted_far(origin: &Origin, by: f64, at: Vec3) -> Diagnostic {
    let text = format!(
        "AVCTRL without LIMIT lifts the tool by {}, farther than three of its lengths, to the tool end {}",
        short(by),
        point(at)
    );
    Diagnostic::warning(codes::FAR_LIFT, origin.span, text)
        .within(origin.trace.clone())
        .help("give AVCTRL a LIMIT, or another direction of the lift (NORMPS, AXIS), or hold the path off what stands in the way")
}

/// "pitching through 12.5 degrees and lifting off by 0.3 along the tool axis".
fn said(how: &Avoided) -> String {
    let mut done = Vec::new();
    if let Some((deg, rolls)) = how.tilt {
        let verb = if rolls { "rolling" } else { "pitching" };
        done.push(format!("{verb} through {} degrees", short(deg)));
    }
    if let Some((by, normal)) = how.lift {
        let along = if normal { "normal to the part surface" } else { "along the tool axis" };
        done.push(format!("lifting off by {} {along}", short(by)));
    }
    done.join(" and ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_done_is_said() {
        let how = Avoided {
            te: Vec3::zeros(),
            ta: Vec3::z(),
            tilt: Some((-12.5, false)),
            lift: Some((0.25, true)),
        };
        let both =
            "pitching through -12.5 degrees and lifting off by 0.25 normal to the part surface";
        assert_eq!(said(&how), both);
        let lifted = Avoided { tilt: None, lift: Some((2.0, false)), ..how };
        assert_eq!(said(&lifted), "lifting off by 2 along the tool axis");
    }
}
