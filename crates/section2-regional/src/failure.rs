//! Why regional milling ends: data first, words in [`Failure::explain`].

use aptc_diagnostics::{Code, Diagnostic, Origin, codes};
use aptc_geometry::Vec3;

use crate::avoid::Avoid;
use crate::guard::{Gouge, Solid};
use crate::judge::{Limit, Worst};

/// Why a statement of regional milling fails.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Failure {
    /// A curve or surface that cannot be fitted.
    Unfit { name: Box<str>, why: Box<str> },
    /// What was told at an earlier statement.
    Told,
    /// Triangles, along which no lines run.
    Facets { name: Box<str> },
    /// Areas that a statement needs are not set; none where their own statements failed, which was told there.
    NotSet { areas: Vec<&'static str> },
    /// GOMILL with PICKFD and nothing that leads the tool back.
    NoRetract,
    /// A number that is out of its range.
    Value { what: &'static str, value: f64, need: Box<str> },
    /// A direction of length zero.
    NoDirection { what: &'static str },
    /// No cutter, or one that is no solid.
    NoCutter,
    /// The part surface is not met.
    NotMet { part: Box<str>, uv: [f64; 2], place: Vec3 },
    /// The tool axis cannot be had.
    NoAxis { uv: [f64; 2] },
    /// No chord keeps the tolerance; or none by which the tool moves so far, and the path does but creep.
    NoStep { uv: [f64; 2], part_uv: [f64; 2], worst: Worst, creeps: Option<f64> },
    /// The drive goes on elsewhere beyond a joint.
    Torn { drive: Box<str>, uv: [f64; 2], ends: [Vec3; 2] },
    /// The cutter is to go into the surface by more than it is round where it touches.
    ThickBeyond { part: Box<str>, uv: [f64; 2], thick: f64, radius: f64 },
    /// More points than NUMPTS.
    TooMany { limit: usize, uv: [f64; 2] },
    /// Longer than MAXDP lets a path be.
    TooLong { limit: f64, uv: [f64; 2] },
    /// A checked surface is gouged.
    Gouge(Box<Deep>),
    /// The same where a lift along the axis would begin or end: this surface stands over the tool, in its way up.
    Under(Box<Deep>, Box<str>),
    /// The way from one pass to the next goes through a surface.
    PickFeed(Box<Deep>),
    /// A pass stands in a surface where it ends, or where the next begins: more than where it is led along is in the cutter.
    Stands(Box<Deep>, &'static str),
    /// The first point is left out, and the way to the second goes through a surface.
    Skipped(Box<Deep>),
    /// The work was called off.
    Stopped { done: usize, all: usize },
    /// A cutter that touches with no cutting place.
    Sphere { part: Box<str>, part_uv: [f64; 2], te: Vec3 },
    /// The plane of START, THRU or AT is not met along the line.
    PlaneMissed { word: &'static str },
    /// The surface of CLEARS is not met along the tool axis.
    NoClearance { te: Vec3 },
    /// The way to the first projected position goes through a surface.
    Approach(Box<Deep>),
    /// The way to where a statement begins does.
    WayIn(Box<Deep>),
    /// The way from one stretch of a line to the next, over what REGION leaves out, does.
    Over(Box<Deep>),
    /// A motion from point to point, or along surfaces, does.
    Way(Box<Deep>),
    /// The tool stands in a body of triangles and touches none.
    Held(Box<Deep>),
    /// Surfaces of INTSEC whose curves are not found.
    NotCut { why: Box<str> },
    /// Curves of INTSEC that make no outline of REGION.
    Outline { why: &'static str },
    /// An outline of REGION that leaves a patch where nothing is beside it.
    Joint { why: &'static str },
    /// A section of CLDAT that goes round nothing.
    NoOutline(Box<NoOutline>),
    /// A statement that is not done here.
    Undone { what: &'static str },
}

/// A section of CLDAT that REGION names, and of which no places on an SSURF are known.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct NoOutline {
    pub(crate) number: f64,
    /// UVPDS, not UVPPS.
    pub(crate) of_drive: bool,
    /// The first surface that was recorded along and is no SSURF.
    pub(crate) other: Option<Box<str>>,
}

impl NoOutline {
    fn said(&self) -> String {
        let number = short(self.number);
        let (word, role) = if self.of_drive { ("UVPDS", "drive") } else { ("UVPPS", "part") };
        match &self.other {
            Some(name) => {
                let name = if name.is_empty() { "that" } else { name };
                format!(
                    "section {number} of CLDAT goes round nothing: {word} takes the {role} surface, and {name} is no SSURF"
                )
            }
            None => {
                format!(
                    "section {number} of CLDAT goes round nothing: its motions have less than three places on an SSURF"
                )
            }
        }
    }

    fn help(&self) -> String {
        match (&self.other, self.of_drive) {
            (Some(_), true) => {
                "record UVPPS, the places on the part surface, where that is the SSURF to be milled"
                    .into()
            }
            (Some(_), false) => {
                "record motions whose part surface is the SSURF to be milled".into()
            }
            _ => "record motions along an SSURF, round what is to be milled".into(),
        }
    }
}

/// How a line goes round what REGION leaves out.
pub(crate) const ROUND: &str =
    "lead the tool away and back by GCLEAR/AWAY and GCLEAR/BACK, with NORMAL,h or CLEARS,plane";

/// A gouge with the tool that makes it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Deep {
    pub(crate) gouge: Gouge,
    pub(crate) te: Vec3,
    pub(crate) ta: Vec3,
    /// What AVCTRL says.
    pub(crate) avoids: Avoid,
}

impl Failure {
    pub(crate) fn gouge(gouge: Gouge, te: Vec3, ta: Vec3, avoids: Avoid) -> Self {
        Self::Gouge(Box::new(Deep { gouge, te, ta, avoids }))
    }

    /// The words, at the statement; `None` where it was told before.
    pub(crate) fn explain(&self, origin: &Origin) -> Option<Diagnostic> {
        let (code, text, help) = self.words()?;
        let said = Diagnostic::error(code, origin.span, text).within(origin.trace.clone());
        Some(said.help(help))
    }

    fn words(&self) -> Option<(Code, String, String)> {
        Some(match self {
            Self::Told => return None,
            Self::NotSet { areas } if areas.is_empty() => return None,
            Self::Gouge(deep)
            | Self::Under(deep, _)
            | Self::PickFeed(deep)
            | Self::Stands(deep, _)
            | Self::Skipped(deep)
            | Self::Approach(deep)
            | Self::WayIn(deep)
            | Self::Over(deep)
            | Self::Way(deep)
                if let Some((text, help)) = deep.entered() =>
            {
                (codes::INTERFERENCE, text, help)
            }
            Self::Unfit { name, why } => (
                codes::UNFIT_SURFACE,
                format!("{name} cannot be fitted: {why}"),
                "correct its definition".into(),
            ),
            Self::Facets { name } => (
                codes::UNSUPPORTED_MOTION,
                format!("{name} is made of triangles, along which no lines run"),
                "lead the tool over another surface (SCON/DS), and hold it off the triangles by CHKSRF"
                    .into(),
            ),
            Self::NotSet { areas } => (
                codes::AREA_NOT_SET,
                format!("{} not set since the last INIT", join(areas)),
                format!("give SCON/{} before SMIL", areas.first().unwrap_or(&"DS")),
            ),
            Self::NoRetract => (
                codes::AREA_NOT_SET,
                "PICKFD leads the tool back over the part from line to line, and GOMILL has nothing to lead it by".into(),
                "give RETR behind it, with a distance, a vector or a plane; or SCON/FEED,plane before it"
                    .into(),
            ),
            Self::Value { what, value, need } => (
                codes::REGION_VALUE,
                format!("{what} is {value}, and must be {need}"),
                "correct the number".into(),
            ),
            Self::NoDirection { what } => (
                codes::REGION_VALUE,
                format!("{what} has length zero"),
                "give a vector with a length; a drive curve has CRSSPL only where it was given at its ends"
                    .into(),
            ),
            Self::NoCutter => (
                codes::NO_CUTTER,
                "no cutter is given that is a solid".into(),
                "give CUTTER/diameter,corner radius first".into(),
            ),
            Self::NotMet { part, uv, place } => (
                codes::PART_NOT_MET,
                format!(
                    "from the drive point at u {}, v {} ({}) no place of {part} is met",
                    short(uv[0]),
                    short(uv[1]),
                    point(*place)
                ),
                "turn the direction of projection, or narrow the limits of DS".into(),
            ),
            Self::NoAxis { uv } => (
                codes::NO_AXIS,
                format!(
                    "at the drive point u {}, v {} there is no normal of the surface, or no tool axis",
                    short(uv[0]),
                    short(uv[1])
                ),
                "where a corner or border has no normal leave it out by the limits (PARAM, START); a path may not run along \
                 the direction of projection; along a drive curve NORMDS is its CRSSPL, given at its ends, and an angle is one to PS"
                    .into(),
            ),
            Self::ThickBeyond { part, uv, thick, radius } => (
                codes::THICK_BEYOND_CUTTER,
                format!(
                    "the thickness {} on {part} is negative by more than the radius {} with which the \
                     cutter touches it, at the drive point u {}, v {}",
                    short(*thick),
                    short(*radius),
                    short(uv[0]),
                    short(uv[1])
                ),
                "give a thickness of at least minus the corner radius".into(),
            ),
            Self::NoStep { uv, part_uv, worst, creeps } => (
                codes::NO_CHORD,
                no_chord(*uv, *part_uv, worst, *creeps),
                worst.help().into(),
            ),
            Self::Torn { drive, uv, ends: [before, behind] } => (
                codes::NO_CHORD,
                format!(
                    "at u {}, v {} the line jumps from {} to {}: the patches of {drive} do not lie side by side there",
                    short(uv[0]),
                    short(uv[1]),
                    point(*before),
                    point(*behind)
                ),
                "define the surfaces of COMBIN so that one begins, with the same parameter, where the one before ends; or mill each by itself"
                    .into(),
            ),
            Self::TooMany { limit, uv } => (
                codes::PATH_TOO_LONG,
                format!(
                    "the path has more than {limit} points; it ends at u {}, v {} of the drive",
                    short(uv[0]),
                    short(uv[1])
                ),
                "raise NUMPTS or the tolerances".into(),
            ),
            Self::TooLong { limit, uv } => (
                codes::PATH_TOO_LONG,
                format!(
                    "the path is longer than {}; it ends at u {}, v {} of the drive",
                    short(*limit),
                    short(uv[0]),
                    short(uv[1])
                ),
                "raise the second number of MAXDP".into(),
            ),
            Self::Gouge(deep) => (
                codes::INTERFERENCE,
                deep.said(""),
                deep.help(),
            ),
            Self::Under(deep, above) => (
                codes::INTERFERENCE,
                format!(
                    "{}; {above} goes on above the tool as CUTTER and HOLDER say it is, and is in the way of a lift",
                    deep.said("")
                ),
                format!(
                    "give CUTTER the height of the tool, or HOLDER what is above the cutter: it is lifted then before it stands under {above}"
                ),
            ),
            Self::Way(deep) => (
                codes::INTERFERENCE,
                deep.said(""),
                "lead the tool round it, or use a smaller cutter".into(),
            ),
            Self::Over(deep) => (
                codes::INTERFERENCE,
                deep.said("on the way over what REGION leaves out of the line "),
                ROUND.into(),
            ),
            Self::WayIn(deep) => (
                codes::BETWEEN_PASSES,
                deep.said("on the way to its first position "),
                "bring the tool before to a place from which it comes there clear".into(),
            ),
            Self::Held(deep) => (
                codes::INTERFERENCE,
                deep.held(),
                format!("begin outside of {0}, or leave {0} out of CHKSRF", deep.gouge.surface),
            ),
            Self::PickFeed(deep) => (
                codes::BETWEEN_PASSES,
                deep.said("on the way to the next pass "),
                "give SCON/FEED a plane, or GOMILL a RETR, that the tool clears from one pass to the next"
                    .into(),
            ),
            Self::Stands(deep, word) => (
                codes::BETWEEN_PASSES,
                deep.said(&format!("where a pass {word} ")),
                "CHKSRF/PS,ON holds the passes to all of the surface, and AVCTRL takes the cutter out where it does not fit; or use a smaller cutter"
                    .into(),
            ),
            Self::Skipped(deep) => (
                codes::BETWEEN_PASSES,
                deep.said("the first point is left out, and on the way to the second "),
                "bring the tool to the first point before, or leave the last number away".into(),
            ),
            Self::Stopped { done, all } => (
                codes::TOO_MUCH_TIME,
                format!("the region was stopped after {done} of {all} passes"),
                "allow more time by --max-seconds, or mill with fewer passes".into(),
            ),
            Self::Sphere { part, part_uv, te } => (
                codes::NO_CONTACT,
                format!(
                    "at the tool end {} the cutter could touch {part} at u {}, v {} only with its top",
                    point(*te),
                    short(part_uv[0]),
                    short(part_uv[1])
                ),
                "turn the tool axis towards the side of PLUS or MINUS that SCON/PS names; MINUS behind NORMDS turns it round".into(),
            ),
            Self::PlaneMissed { word } => (
                codes::PART_NOT_MET,
                format!("along the line the tool nowhere meets the plane of {word}"),
                "give a plane that crosses the line, or a parameter".into(),
            ),
            Self::NoClearance { te } => (
                codes::PART_NOT_MET,
                format!("from the tool end {} along the tool axis CLEARS is not met", point(*te)),
                "give a surface of CLEARS that lies above the line".into(),
            ),
            Self::Approach(deep) => (
                codes::BETWEEN_PASSES,
                deep.said("on the way to the first projected position "),
                "bring the tool over that position before TLPROJ".into(),
            ),
            Self::NotCut { why } => (
                codes::NO_MEETING,
                format!("the curves of INTSEC are not found: {why}"),
                "raise the tolerances, or move one of the two by THICK".into(),
            ),
            Self::Outline { why } => (
                codes::NO_OUTLINE,
                format!("what REGION holds is not certain: {why}"),
                "close the curves, along the borders by motions; give each its own section".into(),
            ),
            Self::Joint { why } => (
                codes::NO_OUTLINE,
                format!("what REGION holds is not certain: {why}"),
                "give the outline in shorter steps, or to each surface of COMBIN a section of CLDAT and a REGION of its own; or take patches that have whole borders in one place"
                    .into(),
            ),
            Self::NoOutline(n) => (codes::NO_OUTLINE, n.said(), n.help()),
            Self::Undone { what } => (
                codes::UNSUPPORTED_MOTION,
                format!("{what} cannot be computed yet"),
                "use SMIL".into(),
            ),
        })
    }
}

/// What every chord from a drive point exceeds near a place of the part surface.
fn no_chord(uv: [f64; 2], part_uv: [f64; 2], worst: &Worst, creeps: Option<f64>) -> String {
    let [u, v] = uv.map(short);
    let which = match creeps {
        Some(still) => {
            format!(
                "from the drive point u {u}, v {v} no chord that moves the tool by {} or more",
                short(still)
            )
        }
        None => format!("no chord from the drive point u {u}, v {v}"),
    };
    if let (Limit::Unknown, Some(_)) = (worst.what, creeps) {
        return format!("{which} is found: the path does but creep");
    }
    let [u, v] = part_uv.map(short);
    let near = format!("near u {u}, v {v} of the part surface");
    let (much, allowed) = (amount(worst.much, worst.allowed), short(worst.allowed));
    let why = match worst.what {
        Limit::Deep => format!("{near} the cutter is {much} deep in it, and INTOL is {allowed}"),
        Limit::Off => {
            format!("{near} the cutter stands off it by up to {much}, and OUTTOL is {allowed}")
        }
        Limit::Beside => format!(
            "{near} the tool is {much} beside its path, and sideways, by the tolerance of the drive surface, {allowed} is allowed"
        ),
        Limit::Sags => format!(
            "{near} the tool end is {much} off the line that it is led on, and {allowed} is left of INTOL and OUTTOL"
        ),
        Limit::Unknown => format!("{near} no place of the tool is found between its ends"),
    };
    format!("{which} keeps the tolerance: {why}")
}

/// With more digits where six do not tell it from what is allowed.
fn amount(much: f64, allowed: f64) -> String {
    if short(much) == short(allowed) { format!("{much:.5e}") } else { short(much) }
}

impl Worst {
    fn help(&self) -> &'static str {
        match self.what {
            Limit::Deep | Limit::Unknown => "the cutter does not fit there, or INTOL is too narrow",
            Limit::Off => {
                "the cutter does not reach the surface there, it has a step or a gap there, or OUTTOL is too narrow"
            }
            Limit::Beside => "give OUTTOL a second number, for the drive surface, that is wider",
            Limit::Sags => "the surface has an edge there, or INTOL and OUTTOL are too narrow",
        }
    }
}

impl Deep {
    fn who(&self) -> &'static str {
        match self.gouge.by {
            Solid::Cutter => "the cutter",
            Solid::Holder => "the holder",
            Solid::Between => "the axis between cutter and holder",
        }
    }

    fn held(&self) -> String {
        let Gouge { surface, depth, .. } = &self.gouge;
        let (te, ta, who) = (point(self.te), point(self.ta), self.who());
        format!(
            "at the tool end {te} with axis {ta} {who} stands inside of {surface}, {} from its nearest triangle in the middle",
            short(*depth)
        )
    }

    /// What to do about a place where the tool gouges.
    fn help(&self) -> String {
        let Gouge { surface, left, .. } = &self.gouge;
        match left.as_ref().and_then(|left| left.own) {
            Some(thick) => format!(
                "name it PS in CHKSRF: with the name {surface} in its place the thickness {} of the part surface does not count",
                short(thick)
            ),
            None if self.avoids.on && self.avoids.along_normal => {
                "lift along the tool axis (AVCTRL/AXIS), which clears walls that go up along it; or widen RANGE or LIMIT, or use a smaller cutter".into()
            }
            None if self.avoids.on => "widen RANGE or LIMIT of AVCTRL, or use a smaller cutter".into(),
            None => "switch AVCTRL on, or use a smaller cutter".into(),
        }
    }

    fn said(&self, way: &str) -> String {
        let Gouge { surface, depth, stood, .. } = &self.gouge;
        let who = self.who();
        let depth =
            if depth.is_finite() { format!("{} deep", little(*depth)) } else { "perhaps".into() };
        let (te, ta) = stood.as_ref().map_or((self.te, self.ta), |s| (s.te, s.ta));
        let (te, ta) = (point(te), point(ta));
        let place = self.gouge.placed();
        format!("at the tool end {te} with axis {ta} {way}{who} is {depth} in {surface}{place}")
    }
}

impl Deep {
    /// What is said of a tool that came from outside of a solid which could be a bowl, and what to do.
    fn entered(&self) -> Option<(String, String)> {
        let Gouge { surface, entered, .. } = &self.gouge;
        let from = point(**entered.as_ref()?);
        let (te, ta) = (point(self.te), point(self.ta));
        let text = format!(
            "the tool came from {from}, outside of {surface}, which counts as solid; here, at the tool end {te} with axis {ta}, it stands inside"
        );
        let help = format!(
            "where {surface} is a bowl, bring the tool into it before CHKSRF: by FROM, or a motion to a place inside"
        );
        Some((text, help))
    }
}

fn join(words: &[&str]) -> String {
    match words {
        [one] => format!("SCON/{one} is"),
        many => format!("SCON/{} are", many.join(" and SCON/")),
    }
}

/// A number as a message shows it.
pub(crate) fn short(x: f64) -> String {
    let text = format!("{x:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

/// A length that may be very little, of which as much is to be seen.
fn little(x: f64) -> String {
    if x > 0.0 && x < 1e-5 { format!("{x:.1e}") } else { short(x) }
}

/// A point as a message shows it.
pub(crate) fn point(p: Vec3) -> String {
    format!("{}, {}, {}", short(p.x), short(p.y), short(p.z))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::guard::Left;

    #[test]
    fn a_little_depth_is_told() {
        let told = [0.0, 3e-9, 9.94e-6, 1e-5, 0.25].map(little);
        assert_eq!(told, ["0", "3.0e-9", "9.9e-6", "0.00001", "0.25"]);
    }

    #[test]
    fn what_no_chord_keeps_is_told_by_its_own_limit() {
        let told = |what, much, allowed, creeps| {
            let worst = Worst { what, much, allowed };
            no_chord([0.5, 1.0], [0.5, 1.25], &worst, creeps)
        };
        let head = "no chord from the drive point u 0.5, v 1 keeps the tolerance: near u 0.5, v 1.25 of the part surface ";
        for (what, said) in [
            (Limit::Deep, "the cutter is 0.02 deep in it, and INTOL is 0.01"),
            (Limit::Off, "the cutter stands off it by up to 0.02, and OUTTOL is 0.01"),
            (
                Limit::Beside,
                "the tool is 0.02 beside its path, and sideways, by the tolerance of the drive surface, 0.01 is allowed",
            ),
        ] {
            assert_eq!(told(what, 0.02, 0.01, None), format!("{head}{said}"));
        }
        // What is above the limit by less than is shown is told apart from it.
        let close = told(Limit::Deep, 0.010_000_2, 0.01, None);
        assert!(
            close.ends_with("the cutter is 1.00002e-2 deep in it, and INTOL is 0.01"),
            "{close}"
        );
        let creeps = told(Limit::Unknown, 0.0, 0.0, Some(0.02));
        assert_eq!(
            creeps,
            "from the drive point u 0.5, v 1 no chord that moves the tool by 0.02 or more is found: the path does but creep"
        );
    }

    #[test]
    fn what_to_do_about_a_gouge_is_what_helps() {
        let help = |thick: Option<f64>, avoids: Avoid| {
            let left = Some(Box::new(Left { thick: 0.0, own: thick }));
            let (surface, span, by) = ("F".into(), None, Solid::Cutter);
            let (entered, seen, stood) = (None, None, None);
            let gouge = Gouge { surface, span, depth: 0.5, left, by, entered, seen, stood };
            Deep { gouge, te: Vec3::zeros(), ta: Vec3::z(), avoids }.help()
        };
        let off = Avoid::default();
        assert!(help(Some(-0.5), off).starts_with("name it PS in CHKSRF"));
        assert!(help(None, off).starts_with("switch AVCTRL on"));
        let axis = Avoid { on: true, ..off };
        assert!(help(None, axis).starts_with("widen RANGE or LIMIT"));
        assert!(help(None, Avoid { along_normal: true, ..axis }).contains("(AVCTRL/AXIS)"));
    }
}
