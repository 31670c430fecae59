//! The cutters that a CL file names, beside those of the program that it is held against.

use aptc_cldata::{Dialect, Kind, MotionKind, Record};
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::{Cutter, Units};

/// Lengths of cutters that differ by less than this share of the diameter, and angles by less degrees, are the same: files
/// round them.
const ROUNDED: f64 = 1e-3;

/// A cutter with which something moves, lengths in millimetres.
struct Used {
    cutter: Cutter,
    origin: Origin,
    /// Is something of it along surfaces?
    along: bool,
    /// The numbers of the records that give it.
    given: Vec<usize>,
}

/// Puts the cutters of the file into the program's records, where they are others, and says so: the file is what a machine gets.
/// Where the file names no cutters those of the program hold, and where it names another number of them too.
pub(crate) fn exchange(
    judged: &mut [Record],
    file: &[Record],
    (name, dialect): (&str, Dialect),
) -> Vec<Diagnostic> {
    let (ours, theirs) = (used(judged), used(file));
    if ours.len() != theirs.len() {
        return Vec::new();
    }
    let mut said = Vec::new();
    for (here, there) in ours.iter().zip(&theirs) {
        let there = whole(&there.cutter, &here.cutter, dialect);
        if alike(&here.cutter, &there) || !here.along {
            continue;
        }
        let message = format!(
            "the cutter of {name} is {}, that of the program {}",
            written(&there),
            written(&here.cutter)
        );
        said.push(
            Diagnostic::warning(codes::UNMATCHED, here.origin.span, message)
                .note("the path is judged with the cutter of the file; lengths are in millimetres")
                .within(here.origin.trace.clone()),
        );
        put(judged, &here.given, &there);
    }
    said
}

/// The cutters with which something moves, in their order.
fn used(records: &[Record]) -> Vec<Used> {
    let mut mm = Units::default().mm();
    let mut given: Option<(Cutter, &Origin)> = None;
    // CUTTERs that no motion was made with yet.
    let mut fresh = Vec::new();
    let mut out: Vec<Used> = Vec::new();
    for (i, record) in records.iter().enumerate() {
        match &record.kind {
            Kind::Units(u) => mm = u.mm(),
            Kind::Cutter(c) => {
                given = Some((scaled(c, mm), &record.origin));
                fresh = vec![i];
            }
            Kind::Motion(m) if m.kind != MotionKind::From => {
                let Some((cutter, origin)) = given else { continue };
                if !out.last().is_some_and(|u| alike(&u.cutter, &cutter)) {
                    out.push(Used { cutter, origin: origin.clone(), along: false, given: vec![] });
                }
                let last = out.last_mut().expect("one is there");
                last.along |= m.control.is_some();
                last.given.append(&mut fresh);
            }
            _ => {}
        }
    }
    out
}

/// What the file says of a cutter, and of what it does not say what the program has: Creo gives a diameter alone, and heights
/// are nobody's business.
fn whole(there: &Cutter, here: &Cutter, dialect: Dialect) -> Cutter {
    if dialect != Dialect::Creo {
        return Cutter { height: here.height, ..*there };
    }
    if alike(&Cutter { diameter: there.diameter, ..*here }, here) {
        return *here;
    }
    Cutter::mill(there.diameter, here.corner_radius.min(there.diameter / 2.0), here.height)
}

/// Are they the same but for their heights and rounding?
fn alike(a: &Cutter, b: &Cutter) -> bool {
    let near = ROUNDED * a.diameter.max(b.diameter).max(f64::MIN_POSITIVE);
    let lengths = |c: &Cutter| {
        // Zero e and f say nothing.
        let given = [c.e, c.f];
        let [e, f] = c.tangent_corner().filter(|_| c.e == 0.0 && c.f == 0.0).unwrap_or(given);
        [c.diameter, c.corner_radius, e, f]
    };
    let angles = |c: &Cutter| [c.alpha_deg, c.beta_deg];
    let differ = |a: f64, b: f64, by: f64| (a - b).abs() > by;
    !lengths(a).iter().zip(lengths(b)).any(|(a, b)| differ(*a, b, near))
        && !angles(a).iter().zip(angles(b)).any(|(a, b)| differ(*a, b, ROUNDED))
}

/// Another cutter, in millimetres, where one is given.
fn put(records: &mut [Record], given: &[usize], there: &Cutter) {
    let mut mm = Units::default().mm();
    for (i, record) in records.iter_mut().enumerate() {
        match &mut record.kind {
            Kind::Units(u) => mm = u.mm(),
            Kind::Cutter(c) if given.contains(&i) => *c = scaled(there, 1.0 / mm),
            _ => {}
        }
    }
}

fn scaled(c: &Cutter, by: f64) -> Cutter {
    Cutter {
        diameter: c.diameter * by,
        corner_radius: c.corner_radius * by,
        e: c.e * by,
        f: c.f * by,
        height: c.height * by,
        ..*c
    }
}

/// The cutter as CUTTER has it, its height left out.
fn written(c: &Cutter) -> String {
    let number = |x: f64| ((x * 1e4).round() / 1e4).to_string();
    let mut values = vec![number(c.diameter)];
    if c.corner_radius > 0.0 {
        values.push(number(c.corner_radius));
    }
    let plain = Cutter::mill(c.diameter, c.corner_radius, c.height);
    if !alike(&plain, c) {
        values = c.values()[..6].iter().map(|x| number(*x)).collect();
    }
    format!("CUTTER/{}", values.join(","))
}
