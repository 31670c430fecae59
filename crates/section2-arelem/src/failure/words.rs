//! The words of a failure: the message, what helps, and what else there is to say.

use aptc_diagnostics::{Code, codes};
use aptc_protap::{Direction, OptionSurface, SurfaceRef};

use super::{Candidate, Failure, Hindrance};
use crate::naming::{called, coordinates, list, number, with_role, word_of};

impl Failure {
    pub(super) fn words(&self) -> (Code, String, String) {
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
            Self::NoTangency { surface, other, closest, allowed, thick } => {
                let (one, other) = (called(surface), called(other));
                let (by, most) = (number(closest.abs()), number(*allowed));
                let uneven = (thick[0] - thick[1]).abs() > *allowed;
                let text = if !closest.is_finite() {
                    format!("{one} is nowhere tangent to {other} ahead")
                } else if *closest < 0.0 {
                    format!(
                        "{one} is not tangent to {other} for this cutter, which is {by} deep in that where they run alike, \
                         allowed {most}"
                    )
                } else {
                    format!(
                        "{one} is not tangent to {other}: {by} apart where they run alike, allowed {most}"
                    )
                };
                let help = if uneven {
                    let [a, b] = thick.map(number);
                    format!("their thicknesses are {a} and {b}: give both the same in THICK/part,drive,check")
                } else if *closest < 0.0 {
                    "use a cutter that fits there, or TO, ON or PAST, or define one of them tangent to the other".into()
                } else {
                    "use TO, ON or PAST, or define one of them tangent to the other".into()
                };
                (codes::NO_TANGENCY, text, help)
            }
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
            Self::NoTurn { place, axes: [from, to] } => (
                codes::NO_AXIS,
                format!(
                    "the tool cannot turn in place at {} from the axis {} that GO left it with to {}, which TLAXIS asks for along this motion, within tolerance",
                    coordinates(*place),
                    coordinates(*from),
                    coordinates(*to)
                ),
                "give GO the axis of the motion by TLAXIS/i,j,k, or wider tolerances".into(),
            ),
            Self::TurnsInto { surface, place, axis, deep } => (
                codes::NO_AXIS,
                format!(
                    "the tool comes {} deep into {} where it turns in place at {} to the axis {}, before the motion along the drive surface begins",
                    number(*deep),
                    with_role("check", surface),
                    coordinates(*place),
                    coordinates(*axis)
                ),
                "give GO the axis of the motion by TLAXIS/i,j,k, or end GO farther from the check surface".into(),
            ),
            Self::TurnsOver { surface, place, axes: [from, to] } => (
                codes::NO_AXIS,
                format!(
                    "the tool would turn over at {} from the axis {} to {}: its disk is on the side of {} that the axis points into",
                    coordinates(*place),
                    coordinates(*from),
                    coordinates(*to),
                    called(surface)
                ),
                "give GO the axis of the motion, so that the tool comes from that side of the surface".into(),
            ),
            Self::NoneSquare { place, least, asked } => (
                codes::NO_AXIS,
                format!(
                    "no tool axis satisfies TLAXIS {} {}: square to the vector it is {} degrees off the normal at least, and {} are asked",
                    if *least < asked.abs() { "beyond" } else { "at" },
                    coordinates(*place),
                    number(*least),
                    number(*asked)
                ),
                "give ATANGL a greater angle, or another vector".into(),
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
                match surface.form.shape() {
                    aptc_geometry::Form::Ssurf(d) if !d.only_checks() => {
                        "correct the definition of the surface, or of a curve or surface in it".into()
                    }
                    _ => "use another surface, or give the positions with GOTO".into(),
                },
            ),
        }
    }

    /// What else there is to say, a line each.
    pub(super) fn notes(&self) -> Vec<String> {
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
                vec![match b.met {
                    [0, _] => {
                        format!("{closest} from {check} at the nearest, after {gone} of travel")
                    }
                    [met, of] => {
                        format!("{check} was met {met} of {of} times, after {gone} of travel")
                    }
                }]
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
    pub(crate) fn words(&self) -> String {
        format!("INDIRV/{} leads to {}", coordinates(self.along), coordinates(self.te))
    }
}

/// Why a sculptured surface is none.
fn unfit(surface: &SurfaceRef) -> String {
    match surface.form.shape() {
        aptc_geometry::Form::Ssurf(d) if d.only_checks() => {
            ": its triangles serve CHKSRF only".into()
        }
        aptc_geometry::Form::Ssurf(d) => aptc_geometry::sculpt::fit_surface(d)
            .err()
            .map_or_else(String::new, |why| format!(": {why}")),
        aptc_geometry::Form::Polyconic(_) => {
            ": its length Pb is not above 0, or P leaves the range of 1/2 to 1".into()
        }
        _ => " yet".into(),
    }
}
