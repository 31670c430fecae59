//! Words of the program that are in force and do nothing: what regional milling takes from elsewhere.

use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::Vec3;
use aptc_protap::ToolAxis;

use crate::area::{AxisArea, PartArea};
use crate::failure::{point, short};
use crate::regional::Regional;

/// A statement of regional milling that such words stand before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Milling {
    /// SMIL/POSN: one position.
    Posn,
    /// SMIL along passes.
    Smil,
    /// GOLOFT along a surface.
    Goloft,
    /// GOMILL along a surface.
    Gomill,
}

impl Milling {
    fn word(self) -> &'static str {
        match self {
            Self::Posn | Self::Smil => "SMIL",
            Self::Goloft => "GOLOFT",
            Self::Gomill => "GOMILL",
        }
    }
}

/// What is said, and what to do.
type Said = (String, String);

impl Regional {
    /// Tells of each word that has no effect on the statement, once as long as it is given in the same way.
    pub(crate) fn tells_unused(&mut self, origin: &Origin, what: Milling) {
        let smil = matches!(what, Milling::Posn | Milling::Smil);
        let passes = !matches!(what, Milling::Posn);
        let part = self.areas.part.as_ref().filter(|_| smil);
        let all = [
            self.unused_disk(what, part),
            part.and_then(|part| self.unused_thick(part)),
            self.areas.axis.filter(|_| smil).and_then(|area| self.unused_axis(area)),
            (smil && passes && self.outlines.is_active()).then(unused_region),
            (passes && !matches!(what, Milling::Goloft) && self.clears.is_idle())
                .then(|| unused_clears(what)),
            self.is_avoidance_idle().then(|| unused_avoidance(what)),
            self.projecting.is_some().then(|| unused_projection(what)),
        ];
        self.tells_no_effect(origin, all.into_iter().flatten());
        self.tells_bare_holder(origin);
    }

    /// The same of GOLOFT along a curve.
    pub(crate) fn tells_unprojected(&mut self, origin: &Origin) {
        let said = self.projecting.is_some().then(|| unused_projection(Milling::Goloft));
        self.tells_no_effect(origin, said.into_iter());
    }

    fn tells_no_effect(&mut self, origin: &Origin, all: impl Iterator<Item = Said>) {
        for said in all {
            self.tells_once(
                |(text, help)| {
                    Diagnostic::warning(codes::NO_EFFECT, origin.span, text)
                        .within(origin.trace.clone())
                        .help(help)
                },
                said,
            );
        }
    }

    /// Does CHKSRF name anything, or was to?
    fn is_checked(&self) -> bool {
        let named = !self.checked.is_empty() || !self.plain.is_empty();
        self.check_part || named || self.check_failed
    }

    /// Is AVCTRL on and nothing checked? Of a HOLDER that is held against nothing it is told.
    fn is_avoidance_idle(&self) -> bool {
        self.avoid.on && self.holder.is_empty() && !self.is_checked() && !self.is_recording()
    }

    /// Tells once that shank and holder are given and held against nothing.
    pub(crate) fn tells_bare_holder(&mut self, origin: &Origin) {
        if self.holder.is_empty() || self.is_checked() || self.is_recording() {
            return;
        }
        let text =
            "HOLDER is given and nothing is checked: shank and holder are held against no surface";
        let help = "write CHKSRF/PS,ON, or CHKSRF with the surfaces that they must keep clear of; or HOLDER/OFF";
        self.tells_once(
            |(text, help)| {
                Diagnostic::warning(codes::BARE_HOLDER, origin.span, text)
                    .within(origin.trace.clone())
                    .help(help)
            },
            (text.into(), help.into()),
        );
    }

    fn tells_once(&mut self, of: impl FnOnce(Said) -> Diagnostic, said: Said) {
        if !self.told_unused.contains(&said.0) {
            self.told_unused.push(said.0.clone());
            self.diagnostics.push(of(said));
        }
    }

    /// CUTTER/OPTION where a cutter touches.
    fn unused_disk(&self, what: Milling, part: Option<&PartArea>) -> Option<Said> {
        if part.is_some_and(|p| !p.touches) {
            return None;
        }
        let (n, (radius, height)) =
            self.settings.disks.iter().zip(1..).find_map(|(disk, n)| Some((n, (*disk)?)))?;
        let (radius, height, word) = (short(radius), short(height), what.word());
        let text = format!(
            "CUTTER/OPTION,{n},{radius},{height} has no effect on {word}: the cutter itself touches the surface"
        );
        let help = format!(
            "give CUTTER the shape that is to touch, and write CUTTER/OPTION,{n},OFF; the disk counts in motion along surfaces"
        );
        Some((text, help))
    }

    /// THICK where SCON/PS says otherwise.
    fn unused_thick(&self, part: &PartArea) -> Option<Said> {
        let thick = self.settings.thick;
        if !part.touches || thick == 0.0 || (thick - part.thick).abs() <= f64::EPSILON * thick.abs()
        {
            return None;
        }
        let (name, left, thick) = (&part.name.name, short(part.thick), short(thick));
        let text = format!(
            "THICK leaves {thick} on part surfaces and has no effect on SMIL, which leaves the {left} of SCON/PS on {name}"
        );
        let side = if part.side < 0.0 { "MINUS" } else { "PLUS" };
        Some((text, format!("write SCON/PS,TO,{name},{side},{thick}")))
    }

    /// TLAXIS where SCON/AXIS gives a fixed axis that is another one.
    fn unused_axis(&self, area: AxisArea) -> Option<Said> {
        /// Unit vectors that differ by less are one.
        const SAME: f64 = 1e-9;
        let AxisArea::Fixed(axis) = area else { return None };
        let given = self.settings.axis.as_ref().filter(|_| self.settings.axis_idle)?;
        let (word, help) = match given {
            ToolAxis::Keep | ToolAxis::Last => return None,
            ToolAxis::Fixed(v) => {
                let v = v.try_normalize(0.0)?;
                if (v - axis).norm() <= SAME || (v - Vec3::z()).norm() <= SAME {
                    return None;
                }
                (format!("TLAXIS/({})", point(v)), "write SCON/AXIS with that vector")
            }
            ToolAxis::NormPs => ("TLAXIS/NORMPS".into(), "write SCON/AXIS,ATANGL,PS,0,CUTANG,0"),
            ToolAxis::NormDs => ("TLAXIS/NORMDS".into(), "write SCON/AXIS,NORMDS"),
            ToolAxis::Parallel { .. } => {
                let help = "write SCON/AXIS,NORMDS with a drive surface that is square to it, or mill by GOMILL";
                ("TLAXIS/PARLEL".into(), help)
            }
            ToolAxis::PerpTo(_) => {
                ("TLAXIS/PERPTO".into(), "write SCON/AXIS,ATANGL,PS,a,CUTANG,b, or mill by GOMILL")
            }
            ToolAxis::Angle(_) => ("TLAXIS/ATANGL".into(), "write SCON/AXIS,ATANGL,PS,a,CUTANG,b"),
        };
        let text = format!(
            "{word} has no effect on SMIL, whose tool axis is the {} of SCON/AXIS",
            point(axis)
        );
        Some((text, help.into()))
    }
}

fn unused_region() -> Said {
    (
        "REGION has no effect on SMIL, which mills all between the limits of SCON/DS".into(),
        "narrow the limits behind PARAM of SCON/DS, or mill by GOMILL, whose lines keep to REGION; REGION/OFF ends it"
            .into(),
    )
}

fn unused_clears(what: Milling) -> Said {
    let word = what.word();
    let text =
        format!("GCLEAR has no effect on {word}, whose passes begin and end where they touch");
    let help = if what == Milling::Gomill {
        "lead the tool by RETR, or mill line by line with GOLOFT; GCLEAR/OFF ends it"
    } else {
        "lead the tool there and away by GOTO and GODLTA, or mill lines by GOLOFT; GCLEAR/OFF ends it"
    };
    (text, help.into())
}

fn unused_projection(what: Milling) -> Said {
    let word = what.word();
    let text = format!(
        "TLPROJ has no effect on {word}, which stays on the surface or curve that it names"
    );
    let help = "project the motion of GOTO, GODLTA or along surfaces, or mill by SMIL with SCON/DS, which guides the tool over the part surface; TLPROJ/OFF ends it";
    (text, help.into())
}

fn unused_avoidance(what: Milling) -> Said {
    let text = format!(
        "AVCTRL has no effect on {}: nothing is checked, so there is nothing that the tool gets out of the way of",
        what.word()
    );
    let help = "write CHKSRF/PS,ON, or CHKSRF with the surfaces that the tool must keep clear of; or AVCTRL/OFF";
    (text, help.into())
}

/// SCON/PS,ON with a thickness.
pub(crate) fn on_with_thickness(origin: &Origin, part: &PartArea) -> Diagnostic {
    let (name, thick) = (&part.name.name, short(part.thick));
    let side = if part.side < 0.0 { "MINUS" } else { "PLUS" };
    let text =
        format!("the thickness {thick} has no effect with ON: the tool end stays on {name} itself");
    let deep =
        if part.thick < 0.0 { ", for a cutter with at least such a corner radius" } else { "" };
    let help = format!(
        "write SCON/PS,TO,{name},{side},{thick}, with which the cutter keeps that thickness{deep}; or 0"
    );
    Diagnostic::warning(codes::NO_EFFECT, origin.span, text).within(origin.trace.clone()).help(help)
}

/// Passes that are to run out of the region from its border.
pub(crate) fn leads_out(origin: &Origin, from: [f64; 2], sense: f64) -> Diagnostic {
    let (place, [out, into]) = leads(from, sense);
    let text =
        format!("the passes have no length: from {place} {out} leads out of the limits of DS");
    value(origin, text)
        .help(format!("write {into} behind TANSPL or CRSSPL, which leads into the region"))
}

/// A region with one pass, as the step to the next leads out of it.
pub(crate) fn steps_out(origin: &Origin, from: [f64; 2], sense: f64) -> Diagnostic {
    let (place, [out, into]) = leads(from, sense);
    let text = format!(
        "one pass is milled: from {place} {out} behind STEPOV leads out of the limits of DS"
    );
    value(origin, text).help(format!(
        "write {into} behind STEPOV, which leads into the region; for one pass SMIL/PATH"
    ))
}

/// GOMILL with one line, as the step to the next leads out of its surface: which parameter it names, its value and the step.
pub(crate) fn lines_out(
    origin: &Origin,
    surface: &str,
    (word, first, step): (&str, f64, Option<f64>),
) -> Diagnostic {
    let first = short(first);
    let (by, help) = match step {
        Some(step) => {
            (format!("a STEPOV of {}", short(step)), format!("give STEPOV {}", short(-step)))
        }
        None => ("the step to the next".into(), "give STEPOV a negative number".into()),
    };
    let text = format!("one line is milled: from {word},{first} {by} leads out of {surface}");
    value(origin, text).help(format!("{help}, or begin at the other border; for one line GOLOFT"))
}

fn leads([u, v]: [f64; 2], sense: f64) -> (String, [&'static str; 2]) {
    let words = if sense > 0.0 { ["PLUS", "MINUS"] } else { ["MINUS", "PLUS"] };
    (format!("{},{}", short(u), short(v)), words)
}

fn value(origin: &Origin, text: String) -> Diagnostic {
    Diagnostic::warning(codes::REGION_VALUE, origin.span, text).within(origin.trace.clone())
}
