//! What regional milling warns of: its words.

use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::Vec3;

use crate::failure::{ROUND, point, short};
use crate::jump::Stands;

/// The cutter touches with a place that does not cut well: its tip or the rim of its top.
pub(crate) fn touches_with(origin: &Origin, place: &str, at: Vec3) -> Diagnostic {
    let text = format!("at the tool end {} the cutter touches with {place}", point(at));
    Diagnostic::warning(codes::ODD_CONTACT, origin.span, text)
        .within(origin.trace.clone())
        .help("where the tool stands on the wrong side of the part surface give MINUS for PLUS with it, or PLUS for MINUS, or turn the axis round; else lean the tool axis, so that the corner or the side cuts")
}

/// A line goes straight through what REGION leaves out, so many times.
pub(crate) fn straight_over(origin: &Origin, [from, to]: [Vec3; 2], times: usize) -> Diagnostic {
    let more = match times {
        0 | 1 => String::new(),
        2 => "; and once more".into(),
        n => format!("; and {} times more", n - 1),
    };
    let text = format!(
        "from the tool end {} the tool goes straight, at feed, to the next stretch of the line at {}, through what REGION leaves out{more}",
        point(from),
        point(to)
    );
    Diagnostic::warning(codes::STRAIGHT_OVER, origin.span, text)
        .within(origin.trace.clone())
        .help(ROUND)
}

/// The first point of a path, which was to be left out, is put out.
pub(crate) fn put_out(origin: &Origin, at: Vec3) -> Diagnostic {
    let text = format!(
        "the first point {} is put out: the tool stands elsewhere, and the way to the second goes through the surface",
        point(at)
    );
    Diagnostic::warning(codes::FIRST_POINT, origin.span, text)
        .within(origin.trace.clone())
        .help("bring the tool to the first point before, or leave the last number away")
}

/// The first point of a path is left out, and the tool stands elsewhere.
pub(crate) fn left_out(origin: &Origin, first: Vec3, stands: Vec3) -> Diagnostic {
    let text = format!(
        "the first point {} is left out, and the tool does not stand there but at {}: what lies between it and the second is not milled",
        point(first),
        point(stands)
    );
    Diagnostic::warning(codes::FIRST_POINT, origin.span, text)
        .within(origin.trace.clone())
        .help("bring the tool to the first point before, or leave the last number away")
}

/// RADIUS or HIGHT of TLAXIS where the cutter touches with one place of its shape alone.
pub(crate) fn contact_not_chosen(origin: &Origin, surface: &str) -> Diagnostic {
    let text = format!(
        "RADIUS and HIGHT of TLAXIS do not count on {surface}: neither bottom nor flank lies along it, or the number of the other is given"
    );
    Diagnostic::warning(codes::CONTACT_NOT_CHOSEN, origin.span, text)
        .within(origin.trace.clone())
        .help("leave them out; RADIUS is for a bottom that lies on the surface, HIGHT for a flank along it")
}

/// A line is milled from the side from which the tool's shank passes through the surface.
pub(crate) fn through(origin: &Origin, surface: &str) -> Diagnostic {
    let text = format!(
        "the tool stands on the side of {surface}'s normal, u across v, and its shank passes through {surface}"
    );
    Diagnostic::warning(codes::SIDE_FOULS, origin.span, text)
        .within(origin.trace.clone())
        .help("write MIRROR to mill the other side")
}

/// Passes a fixed distance apart leave something where the contact jumps across the bottom of the cutter.
pub(crate) fn left_standing(origin: &Origin, surface: &str, left: &Stands) -> Diagnostic {
    let what = if left.height < f64::INFINITY {
        format!("{} stands", short(left.height))
    } else {
        "all of the material stands".to_owned()
    };
    let text = format!(
        "{what} on {surface} between two passes over {}, where the contact jumps across the bottom of the cutter",
        point(left.place)
    );
    Diagnostic::warning(codes::LEFT_STANDING, origin.span, text)
        .within(origin.trace.clone())
        .help("a scallop height in STEPOV lays the passes as close there as it asks for")
}

/// What CHKSRF names is no deeper in a tool than half its width, which is no more than is allowed.
pub(crate) fn too_thin(origin: &Origin, surface: &str, allowed: f64) -> Diagnostic {
    let text = format!(
        "the cutter is so thin that nothing can be more than {}, which may be, deep in it: CHKSRF does not see it go through {surface}",
        short(allowed)
    );
    Diagnostic::warning(codes::TOO_THIN, origin.span, text)
        .within(origin.trace.clone())
        .help("give CUTTER the diameter of the tool that cuts, or a smaller INTOL")
}
