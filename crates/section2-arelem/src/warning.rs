//! What is told of a motion that is done all the same.

use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_protap::{Direction, SurfaceRef};

use crate::failure::Candidate;
use crate::naming::{called, coordinates, number, word_of};
use crate::pocket::Between;
use crate::scene::Astray;

/// A direction word before anything moved: x is forward.
pub(crate) fn assumed_direction(origin: &Origin, word: Direction) -> Diagnostic {
    let text =
        format!("{} has no direction before it: the x axis is taken as forward", word_of(word));
    Diagnostic::warning(codes::ASSUMED_DIRECTION, origin.span, text)
        .within(origin.trace.clone())
        .help("give INDIRV or INDIRP after FROM")
}

/// A motion along surfaces for which the second number of MAXDP does not count.
pub(crate) fn no_length(origin: &Origin, length: f64) -> Diagnostic {
    let text = format!(
        "the second number of MAXDP, {}, limits the paths of regional milling and not this motion",
        number(length)
    );
    Diagnostic::warning(codes::WITHOUT_EFFECT, origin.span, text)
        .within(origin.trace.clone())
        .help("NUMPTS limits how many cut vectors a motion has; write MAXDP with one number")
}

/// DNTCUT to the end of the part, and so many motions behind it.
pub(crate) fn never_cut(origin: &Origin, motions: u64) -> Diagnostic {
    let (are, motions) = match motions {
        1 => ("is", "the motion behind it".to_owned()),
        n => ("are", format!("{n} motions behind it")),
    };
    let text = format!("DNTCUT holds to the end of the part: {motions} {are} not put out");
    Diagnostic::warning(codes::NEVER_CUT, origin.span, text)
        .within(origin.trace.clone())
        .help("write CUT where the tool is to be put out again")
}

/// A check surface that is the part surface.
pub(crate) fn check_is_part(failure: Diagnostic, surface: &SurfaceRef) -> Diagnostic {
    let check = called(surface);
    failure
        .note(format!("the check surface {check} is the part surface itself, to which the tool keeps all along"))
        .help(format!(
            "name the surface at which the motion is to end; where {check} is to end it, give another part surface by PSIS"
        ))
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

/// OFFSET that left its drive surface on the way to the part surface, so far off it or, below zero, in it.
pub(crate) fn left(origin: &Origin, drive: &SurfaceRef, far: f64) -> Diagnostic {
    let (drive, by) = (called(drive), number(far.abs()));
    let ends = if far < 0.0 {
        format!("with the cutter {by} deep in {drive}")
    } else {
        format!("{by} from {drive}")
    };
    let text = format!(
        "OFFSET ends {ends}: it came to it, and then went along the tool axis to the part surface"
    );
    Diagnostic::warning(codes::LEFT_BY_OFFSET, origin.span, text)
        .within(origin.trace.clone())
        .help("GO comes to both surfaces at once")
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

/// Nothing says that the tool end is to lie on the part surface, and it does, with the cutter in it.
pub(crate) fn ends_on_part(origin: &Origin, surface: &SurfaceRef, depth: f64) -> Diagnostic {
    let part = called(surface);
    let text = format!(
        "the tool end is on part surface {part} and stays on it, the cutter {} deep in it: TLONPS is not written",
        number(depth)
    );
    Diagnostic::warning(codes::ENDS_ON_PART, origin.span, text).within(origin.trace.clone()).help(
        "write TLONPS where that is meant, else TLOFPS, and bring the cutter to touch it with GO/TO",
    )
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

/// PAST at a plane that the tool never gets past.
pub(crate) fn comes_back(origin: &Origin, surface: &SurfaceRef) -> Diagnostic {
    let text = format!(
        "the cutter never gets past {}: it stops where it comes out of it on the side from which it came",
        called(surface)
    );
    Diagnostic::warning(codes::COMES_BACK, origin.span, text)
        .within(origin.trace.clone())
        .help("if it is to stop before, write TO or ON, else a check surface that it gets past")
}

/// TO a check surface in which the cutter stands at the start.
pub(crate) fn begins_in(origin: &Origin, surface: &SurfaceRef, depth: f64) -> Diagnostic {
    let check = called(surface);
    let text = format!(
        "the cutter stands {} deep in check surface {check} where the motion begins, and TO stops it where it comes to {check} the next \
         time",
        number(depth)
    );
    Diagnostic::warning(codes::BEGINS_IN, origin.span, text).within(origin.trace.clone()).help(
        format!("begin the motion clear of {check}; where all of the cutter is to have gone through it, write PAST"),
    )
}

/// RADIUS or HIGHT of TLAXIS, which say where on the cutter it touches, before a motion in which its shape does.
pub(crate) fn contact_not_chosen(origin: &Origin) -> Diagnostic {
    let text = "RADIUS and HIGHT of TLAXIS do not count along surfaces: the cutter touches where its shape does";
    Diagnostic::warning(codes::CONTACT_NOT_CHOSEN, origin.span, text)
        .within(origin.trace.clone())
        .help("leave them out, or write CUTTER/OPTION with the surface, the radius and the height of a disk that is to touch")
}

/// A motion that keeps to what goes straight on beyond a sculptured surface, and nowhere to the surface itself.
pub(crate) fn wholly_beyond(origin: &Origin, surface: &SurfaceRef, far: f64) -> Diagnostic {
    let text = format!(
        "all that the cutter touches here lies beyond the border of {}, by {} at least, on what goes straight on there: it is clear of the surface itself",
        called(surface),
        number(far)
    );
    Diagnostic::note_at(codes::WHOLLY_BEYOND, origin.span, text)
        .within(origin.trace.clone())
        .help("lead the tool over the surface, where that is to be cut; beside a wall that leans over it give the cutter its height")
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

/// A pocket whose passes lie farther apart than the flat end of the cutter clears.
pub(crate) fn flat_too_small(origin: &Origin, b: &Between) -> Diagnostic {
    let text = format!(
        "between the passes material stands up to {} high: the flat end of the cutter has the radius {}, \
         and the effective radius is {}",
        number(b.height),
        number(b.flat),
        number(b.radius)
    );
    let help = if b.flat > 0.0 {
        format!("give {} as the effective radius", number(b.flat))
    } else {
        "take a cutter with a flat end, or make the cut smaller".to_owned()
    };
    Diagnostic::warning(codes::MATERIAL_LEFT, origin.span, text)
        .within(origin.trace.clone())
        .help(help)
}

/// A pocket with a floor that leans, below which the cutter reaches while its tool end is on it.
pub(crate) fn below_floor(origin: &Origin, depth: f64) -> Diagnostic {
    let text = format!(
        "the floor of the pocket leans, and its passes put the tool end on it: the cutter reaches {} below it",
        number(depth)
    );
    Diagnostic::warning(codes::BELOW_FLOOR, origin.span, text)
        .within(origin.trace.clone())
        .help("turn the tool axis square to the floor (TLAXIS), or give points or a part surface that lie higher by so much")
}
