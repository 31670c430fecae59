//! Why a motion failed: data first, words in [`Failure::explain`].

use aptc_diagnostics::{Code, Diagnostic, Origin, codes};
use aptc_geometry::Vec3;
use aptc_protap::{Direction, OptionSurface, SurfaceRef};

use crate::scene::Astray;

/// Why a motion failed.
#[derive(Clone, Debug)]
pub(crate) enum Failure {
    /// No position yet.
    NoPosition,
    /// A surface is to be touched and there is no cutter.
    NoCutter { surface: SurfaceRef },
    /// The tool stands off the drive surface.
    OffDrive { surface: SurfaceRef, off: f64, allowed: f64, outside: bool },
    /// The tool stands off the part surface.
    OffPart { surface: SurfaceRef, off: f64, allowed: f64, outside: bool },
    /// Neither way is more left, right, forward or back than the other.
    Direction { word: Direction },
    /// The check surface is never met.
    NotReached {
        surface: SurfaceRef,
        nth: u32,
        met: u32,
        closest: f64,
        place: Vec3,
        gone: f64,
        /// The cut vectors after which it was given up, if that is why.
        spent: Option<u32>,
        /// TO was asked for, and the cutter stands in the surface at the start.
        within: bool,
        /// PAST was asked for, and a cutter of this height stands in the surface all the way.
        stuck: Option<f64>,
    },
    /// The track ends before its check surface is met.
    Blocked(Box<Blocked>),
    /// Nowhere tangent.
    NoTangency { surface: SurfaceRef, other: SurfaceRef, closest: f64, allowed: f64 },
    /// The cutter does not fit into a round surface.
    TooLarge { surface: SurfaceRef, radius: f64, cutter: f64 },
    /// Start-up without a position that does what is asked.
    NoStart {
        surfaces: Vec<SurfaceRef>,
        why: &'static str,
        /// The best place that was found.
        place: Option<Vec3>,
        /// How far it is from each surface, negative when it cuts in.
        left: Vec<(SurfaceRef, f64)>,
        /// Positions that are found from elsewhere.
        others: Vec<Candidate>,
    },
    /// INDIRV or INDIRP leads away from the surface or along it.
    Misses { surface: SurfaceRef, closest: f64 },
    /// The next motion is needed to know where this one ends.
    NoCheck { word: Direction },
    /// A form that is no surface.
    NotASurface { surface: SurfaceRef },
    /// The cutter has no normal contact with a surface.
    NoContact { surface: SurfaceRef },
    /// Drive and part surface run alike, so that they give no direction.
    SideBySide { drive: SurfaceRef, part: SurfaceRef },
    /// No tool axis satisfies TLAXIS.
    NoAxis { place: Vec3 },
    /// TLAXIS/PARLEL along a surface that has no rulings, beside one that has them.
    NoRulings { role: OptionSurface, surface: SurfaceRef, other: Option<SurfaceRef> },
    /// The cutter cannot be at both surfaces.
    NoPlace { surfaces: Vec<SurfaceRef>, place: Vec3 },
    /// CUTTER that is no solid.
    BadCutter { why: String },
    /// A negative thickness greater than the cutter's greatest radius: the cutter would be past the surface.
    ThickBeyond { surface: SurfaceRef, thick: f64, radius: f64 },
    /// POCKET with numbers or points that make none.
    Pocket { why: String },
    /// A surface that is not done yet.
    Unsupported { surface: SurfaceRef },
}

/// The end of a track before its check surface.
#[derive(Clone, Debug)]
pub(crate) struct Blocked {
    /// Drive and part surface.
    pub(crate) surfaces: [SurfaceRef; 2],
    /// The check surface that was to be met.
    pub(crate) check: SurfaceRef,
    pub(crate) why: Hindrance,
    pub(crate) place: Vec3,
    /// Way done until then.
    pub(crate) gone: f64,
    /// How far the check surface is at the nearest.
    pub(crate) closest: f64,
}

/// What keeps the cutter from going on.
#[derive(Clone, Debug)]
pub(crate) enum Hindrance {
    /// No place of the surface faces the cutter any more.
    Ends(SurfaceRef),
    /// The cutter comes to touch the surface here as well, on its other hand.
    Again { surface: SurfaceRef, at: Vec3 },
    /// Neither: no cut vector of any length stays in the bands.
    Tight,
}

/// A position that would do for a start-up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidate {
    pub(crate) te: Vec3,
    /// Direction to it from where the tool stands.
    pub(crate) along: Vec3,
}

impl Failure {
    /// The words, at the statement.
    pub(crate) fn explain(&self, origin: &Origin) -> Diagnostic {
        let (code, text, help) = self.words();
        let mut d = Diagnostic::error(code, origin.span, text).within(origin.trace.clone());
        for note in self.notes() {
            d = d.note(note);
        }
        d.help(help)
    }

    fn words(&self) -> (Code, String, String) {
        match self {
            Self::NoPosition => (
                codes::NO_POSITION,
                "the tool has no position yet".into(),
                "give FROM or GOTO before the first motion".into(),
            ),
            Self::NoCutter { surface } => (
                codes::NO_CUTTER,
                format!("no cutter is given, so it cannot touch {}", called(surface)),
                "give CUTTER/diameter,corner radius first, CUTTER/0 for a point".into(),
            ),
            Self::OffDrive { surface, off, allowed, outside } => (
                codes::OFF_DRIVE_SURFACE,
                format!(
                    "the tool is not within tolerance of {}: {} {}, allowed {}",
                    with_role("drive", surface),
                    number(off.abs()),
                    if *outside { "off it" } else { "in it" },
                    number(*allowed)
                ),
                format!(
                    "bring the tool to {} with GO, or end the motion before at it",
                    called(surface)
                ),
            ),
            Self::OffPart { surface, off, allowed, outside } => (
                codes::OFF_PART_SURFACE,
                format!(
                    "the tool is not within tolerance of {}: {} {}, allowed {}",
                    with_role("part", surface),
                    number(off.abs()),
                    if *outside { "off it" } else { "in it" },
                    number(*allowed)
                ),
                "bring the tool to it with GO, or give PSIS or AUTOPS for the surface it is on"
                    .into(),
            ),
            Self::Direction { word } => {
                let (runs, help) = match word {
                    Direction::Golft | Direction::Gorgt => (
                        "straight on from the direction before",
                        "use GOFWD or GOBACK where the path goes on smoothly",
                    ),
                    Direction::Gofwd | Direction::Goback => (
                        "square to the direction before",
                        "use GOLFT or GORGT at a corner, or give INDIRV",
                    ),
                    Direction::Goup | Direction::Godown => {
                        ("square to the tool axis", "use GOLFT, GORGT, GOFWD or GOBACK")
                    }
                };
                (
                    codes::UNCLEAR_DIRECTION,
                    format!("{} does not say which way: the surface runs {runs}", word_of(*word)),
                    help.into(),
                )
            }
            Self::NotReached { surface, nth, met, within, .. } => (
                codes::CHECK_NOT_REACHED,
                if *met == 0 || *nth <= 1 {
                    format!("{} is not reached", with_role("check", surface))
                } else {
                    let times = if *met == 1 { "once".to_owned() } else { format!("{met} times") };
                    format!("{} is met {times}, not {nth} times", with_role("check", surface))
                },
                if *within {
                    "use a smaller cutter, or PAST where the tool is to leave the surface"
                } else {
                    "check the direction, the relation (TO, ON, PAST, TANTO) and the surface"
                }
                .into(),
            ),
            Self::Blocked(b) => (
                codes::NO_PLACE,
                format!(
                    "the motion to {} ends at {}: {}",
                    called(&b.check),
                    coordinates(b.place),
                    b.why.words(&b.surfaces)
                ),
                match b.why {
                    Hindrance::Ends(_) => "end the motion before, or use a surface that goes on",
                    Hindrance::Again { .. } => {
                        "use a smaller cutter or a ball end, or another tool axis"
                    }
                    Hindrance::Tight => "use a smaller cutter, or wider tolerances",
                }
                .into(),
            ),
            Self::NoTangency { surface, other, closest, allowed } => (
                codes::NO_TANGENCY,
                if closest.is_finite() {
                    format!(
                        "{} is not tangent to {}: {} apart where they run alike, allowed {}",
                        called(surface),
                        called(other),
                        number(closest.abs()),
                        number(*allowed)
                    )
                } else {
                    format!("{} is nowhere tangent to {} ahead", called(surface), called(other))
                },
                "use TO, ON or PAST, or define one of them tangent to the other".into(),
            ),
            Self::TooLarge { surface, radius, cutter } => (
                codes::CUTTER_TOO_LARGE,
                format!(
                    "the cutter does not fit into {}: cutter radius {}, radius of the surface {}",
                    called(surface),
                    number(*cutter),
                    number(*radius)
                ),
                format!("use a cutter of a diameter below {}", number(2.0 * radius)),
            ),
            Self::NoStart { surfaces, why, left, others, .. } => {
                let cuts_in = left.iter().any(|(_, gap)| *gap < 0.0);
                (
                    codes::NO_START,
                    format!("no position of the tool satisfies {}: {why}", list(surfaces)),
                    if !others.is_empty() {
                        "give the INDIRV that leads to the position that is meant"
                    } else if cuts_in {
                        "check TO, ON and PAST of each surface, come from another point, or use a smaller cutter"
                    } else {
                        "check TO, ON and PAST of each surface, or come from another point"
                    }
                    .into(),
                )
            }
            Self::Misses { surface, closest } => (
                codes::DIRECTION_MISSES,
                format!(
                    "the tool does not come to {} in the given direction{}",
                    called(surface),
                    // A distance that would be read as none says nothing: the tool meets the surface and is wrong there.
                    match number(*closest).as_str() {
                        "0" => {
                            ": it is at it already, or meets it, but not as TO, ON, PAST or TANTO asks".into()
                        }
                        far => format!(", {far} away at the nearest"),
                    }
                ),
                "give another INDIRV or INDIRP, or leave it out for the shortest way".into(),
            ),
            Self::NoCheck { word } => (
                codes::NO_CHECK_SURFACE,
                format!(
                    "{} has no check surface, and no motion along a surface follows",
                    word_of(*word)
                ),
                "name the check surface after the drive surface".into(),
            ),
            Self::NotASurface { surface } => (
                codes::NOT_A_SURFACE,
                format!(
                    "{} is a {}, which cannot guide the tool",
                    called(surface),
                    surface.form.kind().word()
                ),
                "use a line, circle, plane or another surface".into(),
            ),
            Self::NoContact { surface } => (
                codes::NO_CONTACT,
                format!("the cutter has no place that faces {}", called(surface)),
                "bring the tool nearer, or use a surface that does not end there".into(),
            ),
            Self::SideBySide { drive, part } => (
                codes::SIDE_BY_SIDE,
                format!(
                    "{} and {} run side by side: no direction follows",
                    called(drive),
                    called(part)
                ),
                "use a drive surface that crosses the part surface".into(),
            ),
            Self::NoAxis { place } => (
                codes::NO_AXIS,
                format!("no tool axis satisfies TLAXIS at {}", coordinates(*place)),
                "make the angles smaller, or free the axis of one condition; CUTANG is a part of the angle behind ATANGL, \
                 no more than it"
                    .into(),
            ),
            Self::NoRulings { role, surface, other } => {
                let (mine, others, one) = match role {
                    OptionSurface::Part => ("PARLEL,1", "PARLEL,2", "part"),
                    OptionSurface::Drive => ("PARLEL,2", "PARLEL,1", "drive"),
                };
                (
                    codes::NO_AXIS,
                    format!(
                        "TLAXIS/{mine} lays the tool axis along the rulings of {}, which has none",
                        with_role(one, surface)
                    ),
                    match other {
                        Some(s) => format!("write TLAXIS/{others}: {} has them", called(s)),
                        None => "cylinders, cones, TABCYL and RLDSRF have rulings; give TLAXIS/i,j,k or NORMPS elsewhere".into(),
                    },
                )
            }
            Self::NoPlace { surfaces, place } => (
                codes::NO_PLACE,
                format!("the cutter cannot be at {} near {}", list(surfaces), coordinates(*place)),
                "check the sides, the cutter and the place where the motion starts".into(),
            ),
            Self::BadCutter { why } => (
                codes::CUTTER_NO_SOLID,
                format!("the cutter is no solid: {why}"),
                "correct that CUTTER/d,r,e,f,alpha,beta,h; e and f may be 0, then the corner touches both lines"
                    .into(),
            ),
            Self::ThickBeyond { surface, thick, radius } => (
                codes::THICK_BEYOND_CUTTER,
                format!(
                    "the thickness {} on {} is negative by more than the radius {} of the cutter",
                    number(*thick),
                    called(surface),
                    number(*radius)
                ),
                "give THICK at least minus the radius, or ON where the tool end shall follow the surface"
                    .into(),
            ),
            Self::Pocket { why } => (
                codes::POCKET,
                format!("no pocket: {why}"),
                "POCKET/re,c,f,f1,f2,f3,o,p,P1,.. takes the corners of a convex figure in order"
                    .into(),
            ),
            Self::Unsupported { surface } => (
                codes::UNSUPPORTED_MOTION,
                format!("motion with {} cannot be computed{}", called(surface), unfit(surface)),
                "use another surface, or give the positions with GOTO".into(),
            ),
        }
    }

    /// Did the motion end without its check surface?
    pub(crate) fn never_met(&self) -> bool {
        // What was given up after many cut vectors would take as many the other way.
        let given_up = matches!(self, Self::NotReached { spent: Some(_), .. });
        let never =
            matches!(self, Self::NotReached { .. } | Self::NoTangency { .. } | Self::Blocked(_));
        never && !given_up
    }

    /// The words of the message alone.
    pub(crate) fn text(&self) -> String {
        self.words().1
    }

    /// The place that it speaks of.
    pub(crate) fn place(&self) -> Option<Vec3> {
        match self {
            Self::NotReached { place, .. }
            | Self::NoAxis { place }
            | Self::NoPlace { place, .. } => Some(*place),
            Self::Blocked(b) => Some(b.place),
            Self::NoStart { place, .. } => *place,
            _ => None,
        }
    }

    /// What else there is to say, a line each.
    fn notes(&self) -> Vec<String> {
        match self {
            Self::NoStart { place, left, others, .. } => {
                let each = left.iter().map(|(s, g)| {
                    let side = if *g < 0.0 { "in" } else { "off" };
                    format!("{} {side} {}", number(g.abs()), called(s))
                });
                let each = each.collect::<Vec<_>>().join(", ");
                let nearest = place.filter(|_| others.is_empty());
                let nearest = nearest.map(|p| format!("nearest at {}: {each}", coordinates(p)));
                nearest.into_iter().chain(others.iter().map(Candidate::words)).collect()
            }
            Self::Blocked(b) => {
                let (check, closest, gone) = (called(&b.check), number(b.closest), number(b.gone));
                vec![format!("{closest} from {check} at the nearest, after {gone} of travel")]
            }
            Self::NotReached { surface, closest, place, gone, spent, within, stuck, .. } => {
                let (place, closest) = (coordinates(*place), number(closest.abs()));
                let gone = number(*gone);
                let near = format!("closest at {place}, {closest} from it, after {gone} of travel");
                let limit = spent.map(|n| {
                    format!("given up after {n} cut vectors; NUMPTS with a number allows more")
                });
                let within = within.then(|| {
                    let check = called(surface);
                    format!(
                        "the cutter stands in {check} at the start: TO waits for one that comes from outside, \
                         PAST ends where it has left {check}"
                    )
                });
                let stuck = stuck.map(|height| {
                    let (check, height) = (called(surface), number(height));
                    format!(
                        "the cutter, {height} high, stands in {check} all the way: PAST ends where none of it does; \
                         the last of the seven numbers of CUTTER is its height"
                    )
                });
                within.into_iter().chain(stuck).chain([near]).chain(limit).collect()
            }
            _ => Vec::new(),
        }
    }
}

impl Hindrance {
    fn words(&self, surfaces: &[SurfaceRef]) -> String {
        match self {
            Self::Ends(surface) => {
                format!("farther on no place of {} faces the cutter", called(surface))
            }
            Self::Again { surface, at } => format!(
                "farther on the cutter touches {} at {} as well",
                called(surface),
                coordinates(*at)
            ),
            Self::Tight => {
                format!("no cut vector from there stays within tolerance of {}", list(surfaces))
            }
        }
    }
}

impl Candidate {
    /// The position `te` seen from `from`.
    pub(crate) fn of(from: Vec3, te: Vec3) -> Self {
        Self { te, along: (te - from).normalize() }
    }

    fn words(&self) -> String {
        format!("INDIRV/{} leads to {}", coordinates(self.along), coordinates(self.te))
    }
}

/// A direction word before anything moved: x is forward.
pub(crate) fn assumed_direction(origin: &Origin, word: Direction) -> Diagnostic {
    let text =
        format!("{} has no direction before it: the x axis is taken as forward", word_of(word));
    Diagnostic::warning(codes::ASSUMED_DIRECTION, origin.span, text)
        .within(origin.trace.clone())
        .help("give INDIRV or INDIRP after FROM")
}

/// GO with one surface, below a part surface that nobody gave.
pub(crate) fn lifted(origin: &Origin, z: f64) -> Diagnostic {
    let text = format!(
        "no PSIS is given: the tool is lifted from z={} to the part surface z=0",
        number(z)
    );
    Diagnostic::warning(codes::LIFTED_TO_PART, origin.span, text)
        .within(origin.trace.clone())
        .help("give PSIS/surface before it, or the part surface with it: GO/TO,drive surface,TO,part surface")
}

/// A tool that leans without MULTAX.
pub(crate) fn no_multax(origin: &Origin) -> Diagnostic {
    let text = "the tool leans from here on, and without MULTAX the CL data do not have its axis";
    Diagnostic::warning(codes::AXIS_LEFT_OUT, origin.span, text)
        .within(origin.trace.clone())
        .help("write MULTAX before the first motion")
}

/// INTOL and OUTTOL that leave no band.
pub(crate) fn no_band(origin: &Origin, least: f64) -> Diagnostic {
    let text = format!(
        "INTOL and OUTTOL are both 0 here, in which no chord of a curve lies; a band of {} is taken",
        number(least)
    );
    Diagnostic::warning(codes::BAD_TOLERANCE, origin.span, text)
        .within(origin.trace.clone())
        .help("give TOLER or OUTTOL the tolerance of the part: the smaller, the more cut vectors")
}

/// The tool stays on the other side of the drive surface than the word says (APT-360: warning 1601).
pub(crate) fn astray(origin: &Origin, surface: &SurfaceRef, is: Astray) -> Diagnostic {
    let text = format!(
        "{}, but going this way the tool is on the other side of {}; it stays there",
        is.word,
        called(surface)
    );
    Diagnostic::warning(codes::WRONG_SIDE, origin.span, text)
        .within(origin.trace.clone())
        .help(format!("write {}, or turn the other way", is.holds))
}

/// The check surface lies the other way.
pub(crate) fn other_way(failure: Diagnostic, word: Direction) -> Diagnostic {
    failure.help(format!("{} leads to it", word_of(word)))
}

/// TLLFT or TLRGT, and the tool end lies on the drive surface.
pub(crate) fn stays_on(origin: &Origin, surface: &SurfaceRef) -> Diagnostic {
    let text = format!(
        "the tool is to be beside {0}, but its end is on it; it goes on with its end on it, half the cutter in the wall",
        called(surface)
    );
    Diagnostic::warning(codes::WRONG_SIDE, origin.span, text)
        .within(origin.trace.clone())
        .help("write TLON, or bring the tool beside it with GO/TO before")
}

/// A start before the first position: it begins at 0,0,0.
pub(crate) fn from_zero(origin: &Origin) -> Diagnostic {
    let text = "the tool has no position yet and is taken to stand at 0,0,0";
    Diagnostic::warning(codes::NO_POSITION, origin.span, text)
        .within(origin.trace.clone())
        .help("give FROM with the place where the tool stands")
}

/// TO and PAST while the tool stands on the surface: it is taken to be on the negative side.
pub(crate) fn no_side(origin: &Origin, surface: &SurfaceRef) -> Diagnostic {
    let text = format!(
        "the tool stands on {}; TO is taken as the side from which its normal points away",
        called(surface)
    );
    Diagnostic::warning(codes::NO_SIDE, origin.span, text)
        .within(origin.trace.clone())
        .help("come from the side that is meant, or give SRFVCT with the vector from the TO side to the PAST side")
}

/// Other positions of a start-up are just as near as the one that was taken.
pub(crate) fn ambiguous(origin: &Origin, taken: &Candidate, rivals: &[Candidate]) -> Diagnostic {
    let text = format!(
        "the tool goes to {}; another position is as near, and nothing says which is meant",
        coordinates(taken.te)
    );
    let mut d = Diagnostic::warning(codes::AMBIGUOUS_START, origin.span, text)
        .within(origin.trace.clone())
        .help("give INDIRV with the direction to the one that is meant, or INDIRP");
    for candidate in std::iter::once(taken).chain(rivals) {
        d = d.note(candidate.words());
    }
    d
}

/// A CUTTER is missing and a sculptured surface guides the tool.
pub(crate) fn point_taken(origin: &Origin, surface: &SurfaceRef) -> Diagnostic {
    let text = format!("no cutter is given; a point is taken along {}", called(surface));
    Diagnostic::warning(codes::NO_CUTTER, origin.span, text)
        .within(origin.trace.clone())
        .help("give CUTTER/diameter,corner radius first, CUTTER/0 for a point")
}

/// The cutter's side cuts into the drive surface that its lower edge follows.
pub(crate) fn fouls(origin: &Origin, surface: &SurfaceRef, depth: f64) -> Diagnostic {
    let text = format!(
        "the upper part of the cutter cuts into {} by {}; its lower edge is followed",
        called(surface),
        number(depth)
    );
    Diagnostic::warning(codes::SIDE_FOULS, origin.span, text)
        .within(origin.trace.clone())
        .help("write CUTTER/OPTION,2,radius,height if that is meant, or use a shorter cutter")
}

/// RADIUS or HIGHT of TLAXIS, which say where on the cutter it touches, before a motion in which its shape does.
pub(crate) fn contact_not_chosen(origin: &Origin) -> Diagnostic {
    let text = "RADIUS and HIGHT of TLAXIS do not count along surfaces: the cutter touches where its shape does";
    Diagnostic::warning(codes::CONTACT_NOT_CHOSEN, origin.span, text)
        .within(origin.trace.clone())
        .help("leave them out, or write CUTTER/OPTION with the surface, the radius and the height of a disk that is to touch")
}

/// A pocket whose passes do not reach everything in it.
pub(crate) fn material_left(origin: &Origin, left: f64) -> Diagnostic {
    let text = format!(
        "the passes leave material in the pocket, up to {} beyond what the effective radius reaches",
        number(left)
    );
    Diagnostic::warning(codes::MATERIAL_LEFT, origin.span, text)
        .within(origin.trace.clone())
        .help("make the cut smaller, or let the passes be set closer where they must: the flag o of POCKET as 0")
}

/// How a message names a surface.
pub(crate) fn called(s: &SurfaceRef) -> String {
    if s.name.name.is_empty() {
        return format!("the {} given there", s.form.kind().word());
    }
    if s.name.subscript == 0 {
        s.name.name.to_string()
    } else {
        format!("{}({})", s.name.name, s.name.subscript)
    }
}

/// The same with its role, which one that no statement gives has in its name.
pub(crate) fn with_role(role: &str, s: &SurfaceRef) -> String {
    if s.name.is_in_words() {
        return s.name.name.to_string();
    }
    if s.name.name.is_empty() {
        return format!("the {} given there as {role} surface", s.form.kind().word());
    }
    format!("the {role} surface {}", called(s))
}

/// The APT word.
pub(crate) fn word_of(d: Direction) -> &'static str {
    match d {
        Direction::Golft => "GOLFT",
        Direction::Gorgt => "GORGT",
        Direction::Gofwd => "GOFWD",
        Direction::Goback => "GOBACK",
        Direction::Goup => "GOUP",
        Direction::Godown => "GODOWN",
    }
}

fn coordinates(p: Vec3) -> String {
    format!("{},{},{}", number(p.x), number(p.y), number(p.z))
}

fn list(surfaces: &[SurfaceRef]) -> String {
    surfaces.iter().map(called).collect::<Vec<_>>().join(" and ")
}

/// A number with as many digits as a person wants to read.
pub(crate) fn number(x: f64) -> String {
    if !x.is_finite() {
        return "infinitely far".into();
    }
    let size = x.abs();
    let text = if size >= 1000.0 {
        format!("{x:.1}")
    } else if size >= 1.0 {
        format!("{x:.4}")
    } else if !(1e-12..1e-4).contains(&size) {
        format!("{x:.6}")
    } else {
        return format!("{x:.2e}");
    };
    let trimmed = text.trim_end_matches('0').trim_end_matches('.');
    if trimmed == "-0" { "0".into() } else { trimmed.into() }
}

/// Why a sculptured surface is none.
fn unfit(surface: &SurfaceRef) -> String {
    match surface.form.shape() {
        aptc_geometry::Form::Ssurf(d) if d.only_checks() => {
            ": its triangles serve CHKSRF only".into()
        }
        aptc_geometry::Form::Ssurf(d) => aptc_geometry::sculpt::fit_surface(d, 1.0)
            .err()
            .map_or_else(String::new, |why| format!(": {why}")),
        aptc_geometry::Form::Polyconic(_) => {
            ": its length Pb is not above 0, or P leaves the range of 1/2 to 1".into()
        }
        _ => " yet".into(),
    }
}
