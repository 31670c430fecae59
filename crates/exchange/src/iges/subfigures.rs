//! Subfigures of IGES: what a definition (308) lists is there as often as instances (408) place it, and not where it is drawn.

use std::collections::BTreeSet;

use aptc_geometry::{Transform, Vec3};

use super::{Entry, File, Numbers};
use crate::instances::{Assembly, is_place};
use crate::{Fault, Limits, named};

const DEFINITION: u32 = 308;
const INSTANCE: u32 = 408;

/// Groups (402), which place nothing; what a definition lists by them is its own.
const GROUP: u32 = 402;
const GROUPS: [usize; 4] = [1, 7, 14, 15];
/// Within each other, at most.
const DEPTH: usize = 8;

/// Types that place others and are not read.
const OTHER: [(u32, &str); 4] = [
    (412, "rectangular array"),
    (414, "circular array"),
    (416, "external reference"),
    (420, "network subfigure instance"),
];

/// Entities of a file as things that hold and place others, by their lines of the directory.
pub(super) fn assembly(
    file: &File<'_>,
    limits: &Limits,
    notes: &mut Vec<String>,
) -> Result<Option<Assembly>, Fault> {
    let mut others = Vec::new();
    for (kind, name) in OTHER {
        let n = file.entries.values().filter(|e| e.kind == kind).count();
        if n > 0 {
            others.push(format!("{n} of type {kind} ({name})"));
        }
    }
    if !others.is_empty() {
        let others = others.join(", ");
        notes.push(format!("what these place is there once at most, as it is drawn: {others}"));
    }
    let is_moved = |e: &&Entry| e.kind == GROUP && GROUPS.contains(&e.form) && e.matrix > 0;
    let moved = file.entries.values().filter(is_moved);
    let moved: Vec<usize> = moved.map(|e| e.line).collect();
    if !moved.is_empty() {
        let lines = named("", &moved);
        notes.push(format!("the matrices of groups (402) are not regarded: line {lines}"));
    }
    let mut all = Assembly::new("the subfigure of directory line ");
    let mut defined = BTreeSet::<usize>::new();
    let definitions = || file.entries.iter().filter(|(_, e)| e.kind == DEFINITION);
    for (at, e) in definitions() {
        let mut members = BTreeSet::new();
        listed(file, e, limits, DEPTH, &mut members)?;
        defined.extend(&members);
        put(file, number(*at), &members, &mut all)?;
    }
    if all.held.is_empty() {
        return Ok(None);
    }
    let rest = file.entries.keys().filter(|at| !defined.contains(at)).copied().collect();
    put(file, Assembly::FILE, &rest, &mut all)?;
    let placed: BTreeSet<u64> = all.placed.values().flatten().map(|(part, _)| *part).collect();
    let unplaced: Vec<usize> = definitions()
        .filter(|(at, _)| !placed.contains(&number(**at)))
        .map(|(_, e)| e.line)
        .collect();
    if !unplaced.is_empty() {
        let lines = named("", &unplaced);
        notes.push(format!("subfigures that nothing places are not read: line {lines}"));
    }
    Ok(Some(all))
}

/// A line of the directory as the number of a thing.
pub(super) fn number(at: usize) -> u64 {
    u64::try_from(at).unwrap_or(u64::MAX)
}

/// What a definition or a group lists, and groups in it.
fn listed(
    file: &File<'_>,
    e: &Entry,
    limits: &Limits,
    depth: usize,
    members: &mut BTreeSet<usize>,
) -> Result<(), Fault> {
    if depth == 0 {
        return Err(Fault::TooLarge(format!("more than {DEPTH} groups (402) within each other")));
    }
    let mut p = Numbers::loose(file, e)?;
    if e.kind == DEFINITION {
        let _depth_and_name = p.take(2)?;
    }
    for _ in 0..p.count(limits)? {
        let at = p.pointer()?;
        let Some(own) = file.entries.get(&at).filter(|_| members.insert(at)) else { continue };
        if own.kind == GROUP && GROUPS.contains(&own.form) {
            listed(file, own, limits, depth - 1, members)?;
        }
    }
    Ok(())
}

/// Members of a definition, or of the file, as what it holds and places.
fn put(
    file: &File<'_>,
    thing: u64,
    members: &BTreeSet<usize>,
    all: &mut Assembly,
) -> Result<(), Fault> {
    let is_instance = |at: &&usize| file.entries.get(at).is_some_and(|e| e.kind == INSTANCE);
    let (instances, held): (Vec<&usize>, Vec<&usize>) = members.iter().partition(is_instance);
    all.held.insert(thing, held.into_iter().map(|at| number(*at)).collect());
    let placed = instances.into_iter().map(|at| placed(file, &file.entries[at]));
    all.placed.insert(thing, placed.collect::<Result<_, _>>()?);
    Ok(())
}

/// The definition of an instance and where it stands: scaled, carried by the instance's matrix, then moved.
fn placed(file: &File<'_>, e: &Entry) -> Result<(u64, Transform), Fault> {
    let wrong = |what: &str| Fault::Broken { what: what.to_owned(), line: Some(e.line) };
    let mut p = Numbers::loose(file, e)?;
    let at = p.pointer()?;
    let definition = file.entries.get(&at).filter(|d| d.kind == DEFINITION);
    let definition = definition.ok_or_else(|| wrong("it is an instance of no subfigure (308)"))?;
    // Numbers that are left out, also at the end: no way to go, and as large as it is drawn.
    let mut given =
        |usual: f64| p.take(1).ok().map(|x| x[0]).filter(|x| !x.is_nan()).unwrap_or(usual);
    let by = Vec3::new(given(0.0), given(0.0), given(0.0));
    let scale = Transform::scale(given(1.0));
    let own = file.map(definition.matrix)?.map_or(scale, |m| m.then(&scale));
    let carried = file.map(e.matrix)?.map_or(own, |m| own.then(&m));
    let map = carried.then(&Transform::translation(by));
    is_place(&map)
        .then_some((number(at), map))
        .ok_or_else(|| wrong("it shrinks its subfigure to nothing"))
}
