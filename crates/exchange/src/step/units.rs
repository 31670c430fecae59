//! Units of STEP.

use std::collections::BTreeSet;

use ruststep::ast::{Parameter, Record};

use super::places::is_shape;
use super::{Entities, list, of, real, reference};
use crate::{Fault, broken, named};

/// Units that are told by others, within each other at most.
const DEPTH: usize = 4;

/// What stands before a unit, and the multiple that it makes.
const PREFIXES: [(&str, f64); 16] = [
    ("EXA", 1e18),
    ("PETA", 1e15),
    ("TERA", 1e12),
    ("GIGA", 1e9),
    ("MEGA", 1e6),
    ("KILO", 1e3),
    ("HECTO", 1e2),
    ("DECA", 1e1),
    ("DECI", 1e-1),
    ("CENTI", 1e-2),
    ("MILLI", 1e-3),
    ("MICRO", 1e-6),
    ("NANO", 1e-9),
    ("PICO", 1e-12),
    ("FEMTO", 1e-15),
    ("ATTO", 1e-18),
];

/// What a unit measures.
#[derive(Clone, Copy)]
struct Kind {
    /// The type of its entities.
    entity: &'static str,
    /// The unit by which others are told, and what it is here.
    si: &'static str,
    size: f64,
    /// In a message.
    name: &'static str,
}

const LENGTH: Kind =
    Kind { entity: "LENGTH_UNIT", si: "METRE", size: 1000.0, name: "unit of length" };
const ANGLE: Kind =
    Kind { entity: "PLANE_ANGLE_UNIT", si: "RADIAN", size: 1.0, name: "unit of plane angles" };

/// Millimetres of the unit of length; `None` where the file names none, or none that is known, which is told.
///
/// # Errors
/// There are several that differ, or one of no length.
pub(super) fn length(
    entities: &Entities<'_>,
    notes: &mut Vec<String>,
) -> Result<Option<f64>, Fault> {
    let (known, unknown) = found(entities, LENGTH)?;
    let mm = known.first().copied();
    if known.iter().any(|x| (x - known[0]).abs() > 1e-9 * x) {
        return Err(Fault::Unsupported("it has several units of length".into()));
    }
    let taken = if mm.is_some() { "the one that it names besides" } else { "that of the program" };
    if !unknown.is_empty() {
        let which = named("#", &unknown);
        notes.push(format!("its {} is not known ({which}); {taken} is taken", LENGTH.name));
    } else if mm.is_none() {
        notes.push(format!("it names no {}; {taken} is taken", LENGTH.name));
    }
    Ok(mm)
}

/// Radians of the unit of plane angles: 1 where the file names none, or none that is known, which is told.
pub(super) fn angle(entities: &Entities<'_>, notes: &mut Vec<String>) -> Result<f64, Fault> {
    let (known, unknown) = found(entities, ANGLE)?;
    if known.is_empty() && !unknown.is_empty() {
        let which = named("#", &unknown);
        notes.push(format!("its {} is not known ({which}); radians are taken", ANGLE.name));
    }
    Ok(known.first().copied().unwrap_or(1.0))
}

/// Contexts of the representations of shapes; others, of which files may have some, say nothing of these.
fn used(entities: &Entities<'_>) -> BTreeSet<u64> {
    let shapes = entities.values().filter(|r| r.iter().any(is_shape));
    let context = |r: &&[Record]| match r.iter().find_map(|r| list(&r.parameter)?.get(..3))? {
        [_, _, context] => reference(context),
        _ => None,
    };
    shapes.filter_map(context).collect()
}

/// Units that are known, by their sizes, and others by their numbers.
type Units = (Vec<f64>, Vec<u64>);

/// The units of a kind that the contexts of shapes name, or any context where these name none.
fn found(entities: &Entities<'_>, kind: Kind) -> Result<Units, Fault> {
    let used = used(entities);
    let found = named_by(entities, kind, |context| used.contains(&context))?;
    if found.0.is_empty() && found.1.is_empty() {
        return named_by(entities, kind, |_| true);
    }
    Ok(found)
}

fn named_by(
    entities: &Entities<'_>,
    kind: Kind,
    is_used: impl Fn(u64) -> bool,
) -> Result<Units, Fault> {
    let (mut known, mut unknown) = (Vec::new(), Vec::new());
    for (_, records) in entities.iter().filter(|(id, _)| is_used(**id)) {
        let all = of(records, "GLOBAL_UNIT_ASSIGNED_CONTEXT").and_then(|p| list(p.first()?));
        for id in all.unwrap_or_default().iter().filter_map(reference) {
            match size(entities, id, kind, 0)? {
                Some(x) => known.push(x),
                None if entities.get(&id).is_some_and(|r| is(r, kind.entity)) => unknown.push(id),
                None => {}
            }
        }
    }
    unknown.sort_unstable();
    unknown.dedup();
    Ok((known, unknown))
}

fn is(records: &[Record], name: &str) -> bool {
    records.iter().any(|r| r.name == name)
}

/// Millimetres or radians of a unit; `None` for one that is not known, or not of the kind.
fn size(entities: &Entities<'_>, id: u64, kind: Kind, depth: usize) -> Result<Option<f64>, Fault> {
    let Some(records) = entities.get(&id).filter(|_| depth < DEPTH) else { return Ok(None) };
    if let Some([.., prefix, Parameter::Enumeration(si)]) = of(records, "SI_UNIT") {
        let times = match prefix {
            Parameter::Enumeration(e) => PREFIXES.iter().find(|p| p.0 == e).map(|p| p.1),
            _ => Some(1.0),
        };
        return Ok(times.filter(|_| si == kind.si).map(|x| x * kind.size));
    }
    let Some([.., measure]) = of(records, "CONVERSION_BASED_UNIT") else { return Ok(None) };
    let Some((value, base)) = reference(measure).and_then(|m| measured(entities, m)) else {
        return Ok(None);
    };
    let Some(base) = size(entities, base, kind, depth + 1)? else { return Ok(None) };
    let whole = value * base;
    if whole > 0.0 && whole.is_finite() {
        Ok(Some(whole))
    } else {
        Err(broken(format!("#{id}: the {} has the factor {value}", kind.name)))
    }
}

/// A number and its unit, as one entity of its kind or of several types.
fn measured(entities: &Entities<'_>, id: u64) -> Option<(f64, u64)> {
    let mut all = entities.get(&id)?.iter().filter_map(|r| list(&r.parameter));
    let [value, unit] = all.find(|p| p.len() == 2)? else { return None };
    Some((real(value)?, reference(unit)?))
}
