//! IGES 5.3: B-spline surfaces (128), parametric spline surfaces (114), ruled surfaces (118), those of revolution (120) and tabulated
//! cylinders (122), also trimmed (143, 144), with their matrices (124), in subfigures (308, 408).
//!
//! No library of the registry reads IGES. Source of the layout: IGES 5.3 (US PRO, 1996), chapters 2 and 4.

mod borders;
mod curves;
mod faces;
mod lines;
mod splines;
mod subfigures;
mod units;

use std::collections::{BTreeMap, BTreeSet};

use aptc_geometry::Transform;

use crate::follow::{WORK, Work};
use crate::instances::{is_place, then};
use crate::{Collected, Fault, Limits, Outside, broken, named};
use borders::{border, trimmed};
use faces::{Held, held};
pub(crate) use lines::is;
use lines::{field, sections};
use splines::{bspline, cells, joined};

const MATRIX: u32 = 124;

/// Matrices that refer to each other.
const MATRICES: usize = 8;

/// A surface of these types is known and not read.
const OTHER: [(u32, &str); 9] = [
    (108, "plane"),
    (118, "ruled surface"),
    (120, "surface of revolution"),
    (122, "tabulated cylinder"),
    (140, "offset surface"),
    (186, "solid"),
    (190, "plane surface"),
    (192, "cylindrical surface"),
    (196, "spherical surface"),
];

/// Types that are read, some of them where their curves are, a plane where it is trimmed.
const READ: [u32; 6] = [108, 114, 118, 120, 122, 128];

/// Trimmed surfaces.
const TRIMMED: [u32; 2] = [143, 144];

/// A pair of lines of the directory.
struct Entry {
    kind: u32,
    form: usize,
    /// First line of its parameters, and their number.
    from: usize,
    lines: usize,
    /// Directory line of its matrix; 0 for none.
    matrix: usize,
    /// Line of the file.
    line: usize,
}

/// The file by its sections.
struct File<'t> {
    entries: BTreeMap<usize, Entry>,
    /// Columns 1 to 64 of the parameter section, with the line of the file.
    parameters: Vec<(&'t str, usize)>,
    /// Between parameters, and behind the last.
    marks: [char; 2],
    unit_mm: Option<f64>,
    /// What is to tell of the unit.
    notes: Vec<String>,
    /// How long what is a unit long on the part is in the file.
    scale: f64,
}

pub(crate) fn read(text: &str, limits: &Limits) -> Result<Outside, Fault> {
    let mut file = sections(text)?;
    let mut out = Collected::new(limits);
    out.file.unit_mm = file.unit_mm;
    out.file.notes.append(&mut file.notes);
    if (file.scale - 1.0).abs() > 1e-12 {
        let told =
            if file.unit_mm.is_some() { "regarded" } else { "not regarded, as it has no unit" };
        out.file.notes.push(format!("its model has the scale {}, which is {told}", file.scale));
    }
    let unlike = file.unlike_rotations();
    if !unlike.is_empty() {
        out.file.notes.push(format!(
            "matrices (124) that are no rotations are applied as they are: line {}",
            named("", &unlike)
        ));
    }
    // What a trimmed surface is cut from is no surface of its own.
    let mut cut_from = BTreeSet::new();
    for e in file.entries.values().filter(|e| TRIMMED.contains(&e.kind)) {
        cut_from.insert(trimmed(&file, e, limits)?.surface);
    }
    let mut left = BTreeMap::<u32, Left>::new();
    // Trimmed surfaces that are not the box of their parameters, those of which the box is not known, and those that make no
    // surface, by their lines.
    let (mut cut, mut unbounded, mut none) = (Vec::new(), Vec::new(), Vec::new());
    let mut work = Work::new();
    // The lines of the directory of what the surfaces are.
    let mut drawn = Vec::new();
    for (at, e) in &file.entries {
        let mut name = format!("entity {} of line {}", e.kind, e.line);
        let (base, trim) = match e.kind {
            kind if TRIMMED.contains(&kind) => {
                let own = trimmed(&file, e, limits)?;
                let base = file.entries.get(&own.surface);
                let base = base.ok_or_else(|| broken(format!("{name} is of no surface")))?;
                name =
                    format!("entity {} of line {}, cut by line {}", base.kind, base.line, e.line);
                (base, Some(own))
            }
            _ if cut_from.contains(at) => continue,
            _ => (e, None),
        };
        let known = OTHER.iter().any(|(kind, _)| *kind == base.kind);
        let read = READ.contains(&base.kind) && (base.kind != 108 || trim.is_some());
        let found = if read { held(&file, base, trim.is_some(), limits)? } else { None };
        let Some(found) = found else {
            if known || trim.is_some() {
                left.entry(base.kind).or_default().add(e);
            }
            continue;
        };
        // What is trimmed is placed by its own matrix behind that of its surface.
        let place = if trim.is_some() { file.map(e.matrix)? } else { None };
        let base = match found {
            Held::Exact(base) => base,
            Held::Followed(shape, n, map) => {
                out.push(shape, n, then(map, place))?;
                drawn.push(subfigures::number(*at));
                if trim.is_some() {
                    unbounded.push(e.line);
                }
                continue;
            }
        };
        let mut told = None;
        let patch = match &trim {
            None => base.whole(),
            Some(trim) => match border(&file, trim, &base, &mut work, limits)? {
                Some(border) => {
                    told = (!border.whole).then_some(&mut cut);
                    Some(base.patch(border.range))
                }
                None => {
                    told = Some(&mut unbounded);
                    base.whole()
                }
            },
        };
        let Some(patch) = patch else {
            left.entry(e.kind).or_default().add(e);
            continue;
        };
        match out.bspline(&name, patch, then(base.map, place)) {
            Ok(()) => {
                drawn.push(subfigures::number(*at));
                told.into_iter().for_each(|lines| lines.push(e.line));
            }
            // A trimmed one that has no extent leaves the others.
            Err(Fault::Broken { .. }) if trim.is_some() => none.push(e.line),
            Err(why) => return Err(why),
        }
    }
    let said = |kind: &u32| {
        let name = OTHER.iter().find(|(k, _)| k == kind).map_or("surface", |(_, name)| *name);
        left[kind].told(*kind, name)
    };
    let left: Vec<String> = left.keys().map(said).collect();
    if !cut.is_empty() {
        out.file.notes.push(format!(
            "trimmed surfaces whose border is not a box of their parameters are taken as all of that box: line {}",
            named("", &cut)
        ));
    }
    if !unbounded.is_empty() {
        out.file.notes.push(format!(
            "trimmed surfaces of which the border is not read are taken as the whole of their surface: line {}",
            named("", &unbounded)
        ));
    }
    if !none.is_empty() {
        out.file.notes.push(format!(
            "trimmed surfaces that have no extent are not read: line {}",
            named("", &none)
        ));
    }
    if work.spent() {
        out.file.notes.push(format!(
            "the borders of its trimmed surfaces take more than {WORK} looks at curves; those of further ones are not read"
        ));
    }
    match (out.file.surfaces.is_empty(), left.is_empty()) {
        (true, false) => return Err(Fault::NoSurface(left.join(", "))),
        (false, false) => out.file.notes.push(format!("not read: {}", left.join(", "))),
        _ => {}
    }
    if let Some(assembly) = subfigures::assembly(&file, limits, &mut out.file.notes)? {
        out.place(&drawn, &assembly)?;
        if out.file.surfaces.is_empty() {
            return Err(Fault::NoSurface(out.file.notes.join("; ")));
        }
    }
    Ok(out.done())
}

/// Surfaces of a type that are not read, and the lines of those that are trimmed.
#[derive(Default)]
struct Left {
    surfaces: usize,
    trimmed: Vec<usize>,
}

impl Left {
    fn add(&mut self, e: &Entry) {
        self.surfaces += 1;
        if TRIMMED.contains(&e.kind) {
            self.trimmed.push(e.line);
        }
    }

    fn told(&self, kind: u32, name: &str) -> String {
        let lines = match self.trimmed.as_slice() {
            [] => String::new(),
            all => format!(", trimmed by line {}", named("", all)),
        };
        format!("{} of type {kind} ({name}{lines})", self.surfaces)
    }
}

/// A number, whose power of ten may stand behind a D; `None` for what is none, or not finite.
fn number(text: &str) -> Option<f64> {
    let x = text.trim().replace(['D', 'd'], "E").parse().ok();
    x.filter(|x: &f64| x.is_finite())
}

/// The numbers of an entity, behind its type.
struct Numbers {
    all: Vec<f64>,
    at: usize,
    line: usize,
    form: usize,
}

impl Numbers {
    fn of(file: &File<'_>, e: &Entry) -> Result<Self, Fault> {
        Self::read(file, e, false)
    }

    /// Those of an entity that holds texts too, which are no numbers; so is what is left out.
    fn loose(file: &File<'_>, e: &Entry) -> Result<Self, Fault> {
        Self::read(file, e, true)
    }

    fn read(file: &File<'_>, e: &Entry, loose: bool) -> Result<Self, Fault> {
        let wrong = |what: &str| Fault::Broken { what: what.to_owned(), line: Some(e.line) };
        let lines = e
            .from
            .checked_sub(1)
            .and_then(|from| file.parameters.get(from..from.checked_add(e.lines.max(1))?))
            .ok_or_else(|| wrong("its parameters are not in the file"))?;
        let text: String = lines.iter().map(|(l, _)| *l).collect();
        let (mut rest, mut all, mut over) = (text.as_str(), Vec::new(), false);
        while !over && !rest.trim().is_empty() {
            let (held, after, last) = field(rest, file.marks)?;
            let x = match number(&held) {
                None if loose => Some(f64::NAN),
                None if held.trim().is_empty() => Some(0.0),
                x => x,
            };
            let first = lines.first().map_or(e.line, |l| l.1);
            all.push(x.ok_or_else(|| Fault::Broken {
                what: format!("{} is no number, among the parameters", held.trim()),
                line: Some(first),
            })?);
            (rest, over) = (after, last);
        }
        if all.first().is_none_or(|k| (*k - f64::from(e.kind)).abs() > 0.0) {
            return Err(wrong("its parameters are those of another type"));
        }
        Ok(Self { all, at: 1, line: e.line, form: e.form })
    }

    fn take(&mut self, n: usize) -> Result<&[f64], Fault> {
        let end = self.at.checked_add(n).filter(|end| *end <= self.all.len());
        let Some(end) = end else {
            let what = format!("it has {} parameters and needs more", self.all.len());
            return Err(Fault::Broken { what, line: Some(self.line) });
        };
        let from = std::mem::replace(&mut self.at, end);
        Ok(&self.all[from..end])
    }

    /// A line of the directory.
    fn pointer(&mut self) -> Result<usize, Fault> {
        self.count(&Limits { points: usize::MAX, surfaces: 0 })
    }

    /// A count that the limits allow.
    fn count(&mut self, limits: &Limits) -> Result<usize, Fault> {
        let x = self.take(1)?[0];
        let whole = (x >= 0.0 && x.fract() == 0.0 && x < 1e9)
            .then(|| format!("{x}").parse().ok())
            .flatten();
        whole.filter(|n: &usize| *n <= limits.points).ok_or_else(|| Fault::Broken {
            what: format!("{x} is no count"),
            line: Some(self.line),
        })
    }
}

impl File<'_> {
    fn matrix(&self, e: &Entry) -> Result<Transform, Fault> {
        let rows: [f64; 12] = Numbers::of(self, e)?
            .take(12)?
            .try_into()
            .map_err(|_| broken("a matrix has twelve numbers"))?;
        Ok(Transform::from_rows(&rows))
    }

    /// Lines of matrices that others refer to and that are no rotations, as the standard wants them.
    fn unlike_rotations(&self) -> Vec<usize> {
        /// How far products of columns may miss, for numbers of few digits.
        const DIGITS: f64 = 1e-4;
        let used: BTreeSet<usize> = self.entries.values().map(|e| e.matrix).collect();
        let matrices = used.iter().filter_map(|at| self.entries.get(at));
        let unlike = |e: &&Entry| {
            let Ok(m) = self.matrix(e) else { return false };
            let columns = [0, 1, 2].map(|k| m.linear.column(k).into_owned());
            let off = |i: usize, k: usize| {
                let due = if i == k { 1.0 } else { 0.0 };
                (columns[i].dot(&columns[k]) - due).abs() > DIGITS
            };
            (0..3).any(|i| (0..=i).any(|k| off(i, k)))
        };
        matrices.filter(|e| e.kind == MATRIX).filter(unlike).map(|e| e.line).collect()
    }

    /// The map of the matrix at a directory line, those that it refers to after it.
    fn map(&self, matrix: usize) -> Result<Option<Transform>, Fault> {
        let (mut at, mut map) = (matrix, None);
        for _ in 0..MATRICES {
            if at == 0 {
                return Ok(map);
            }
            let Some(e) = self.entries.get(&at).filter(|e| e.kind == MATRIX) else {
                return Err(broken(format!("directory line {at} is no matrix (124)")));
            };
            let own = self.matrix(e)?;
            if !is_place(&own) {
                let what = "a matrix (124) flattens what it carries".to_owned();
                return Err(Fault::Broken { what, line: Some(e.line) });
            }
            map = then(map, Some(own));
            at = e.matrix;
        }
        Err(Fault::TooLarge(format!("more than {MATRICES} matrices refer to each other")))
    }
}
