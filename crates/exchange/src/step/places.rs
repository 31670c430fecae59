//! Assemblies of STEP: which representations of shapes share a frame, and which stand in others, by relations with a
//! transformation or as mapped items.

mod operators;

use std::collections::{BTreeMap, BTreeSet};

use aptc_geometry::Transform;
use ruststep::ast::{Parameter, Record};

use super::curves::single;
use super::{Entities, list, of, reference};
use crate::instances::{Assembly, is_place};
use crate::{Fault, named};
use operators::{mapped, operator};

/// Entities that representations reach, all together.
const REACH: usize = 20_000_000;

/// Relations of two representations.
const RELATIONS: [&str; 4] = [
    "REPRESENTATION_RELATIONSHIP",
    "SHAPE_REPRESENTATION_RELATIONSHIP",
    "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION",
    "CONSTRUCTIVE_GEOMETRY_REPRESENTATION_RELATIONSHIP",
];

/// The faces of a file with their surfaces, and the numbers of faces and surfaces that were read.
pub(super) struct Drawn<'d> {
    pub(super) faces: BTreeMap<u64, u64>,
    pub(super) read: &'d [u64],
}

/// A representation that stands in another one.
struct Placement {
    /// The entity that says so.
    id: u64,
    part: u64,
    whole: u64,
    /// `None`: by what is not read.
    map: Option<Transform>,
}

/// Representations, their items, and which of them share a frame.
#[derive(Default)]
struct Frames {
    items: BTreeMap<u64, BTreeSet<u64>>,
    /// One of a lower number with the same frame, or itself.
    same: BTreeMap<u64, u64>,
}

/// Does its name say that a representation holds shapes? Others, as those of colours, refer to what these hold.
pub(super) fn is_shape(r: &Record) -> bool {
    const OTHERS: [&str; 2] =
        ["SHAPE_REPRESENTATION_WITH_PARAMETERS", "CONSTRUCTIVE_GEOMETRY_REPRESENTATION"];
    r.name.ends_with("SHAPE_REPRESENTATION") || OTHERS.contains(&r.name.as_str())
}

impl Frames {
    /// All that hold shapes.
    fn of(entities: &Entities<'_>) -> Self {
        let mut all = Self::default();
        for (id, records) in entities {
            if !records.iter().any(|r| is_shape(r) || r.name == "REPRESENTATION") {
                continue;
            }
            let items = records.iter().find_map(|r| match list(&r.parameter)? {
                [_, items, context, ..] => reference(context).map(|_| items),
                _ => None,
            });
            let Some(items) = items else { continue };
            let items = list(items).unwrap_or_default().iter().filter_map(reference).collect();
            all.items.insert(*id, items);
            all.same.insert(*id, *id);
        }
        all
    }

    /// The lowest number of those that share a frame; `None` for what is no representation of a shape.
    fn least(&mut self, mut id: u64) -> Option<u64> {
        loop {
            let next = *self.same.get(&id)?;
            if next == id {
                return Some(id);
            }
            // The way is halved for the next time.
            let over = *self.same.get(&next)?;
            self.same.insert(id, over);
            id = over;
        }
    }

    fn join(&mut self, [a, b]: [u64; 2]) {
        if let (Some(a), Some(b)) = (self.least(a), self.least(b)) {
            self.same.insert(a.max(b), a.min(b));
        }
    }
}

/// What the representations of a file place; `None` where none stands in another one.
///
/// Parts that are placed by what is not read are left out and told. The things of the assembly are representations that share a
/// frame, by the lowest of their numbers.
pub(super) fn assembly(
    entities: &Entities<'_>,
    drawn: &Drawn<'_>,
    notes: &mut Vec<String>,
) -> Result<Option<Assembly>, Fault> {
    let mut frames = Frames::of(entities);
    let products = Products::of(entities);
    let mut placed = Vec::new();
    for (id, records) in entities {
        let Some((ends, by)) = related(records) else { continue };
        let product = products.parts.get(id).copied();
        if by.is_none() && product.is_none() {
            frames.join(ends);
        } else {
            placed.push((*id, ends, by, product));
        }
    }
    let mut placements = Vec::new();
    for (id, ends, by, product) in placed {
        let [Some(a), Some(b)] = ends.map(|e| frames.least(e)) else { continue };
        let map = match by {
            Some(by) => operator(entities, by, ends.map(|e| &frames.items[&e])),
            None => Some(Transform::identity()),
        };
        // The second one stands in the first where that is the shape of the part.
        let is_of = |at: u64, frames: &mut Frames| {
            let shapes = product.and_then(|p| products.shapes.get(&p));
            shapes.into_iter().flatten().any(|s| frames.least(*s) == Some(at))
        };
        let turned = is_of(b, &mut frames) && !is_of(a, &mut frames);
        let (part, whole) = if turned { (b, a) } else { (a, b) };
        let map = if turned { map.and_then(|m| m.inverse()) } else { map };
        placements.push(Placement { id, part, whole, map });
    }
    let held = held(entities, drawn, &mut frames, &mut placements)?;
    if placements.is_empty() {
        return Ok(None);
    }
    let shapes = products.shapes.values().flatten().filter_map(|s| frames.least(*s)).collect();
    joined(held, placements, &shapes, drawn, notes).map(Some)
}

/// What stands in each frame, of surfaces and faces; items that are mapped are added to what is placed.
fn held(
    entities: &Entities<'_>,
    drawn: &Drawn<'_>,
    frames: &mut Frames,
    placements: &mut Vec<Placement>,
) -> Result<BTreeMap<u64, BTreeSet<u64>>, Fault> {
    let ends: BTreeSet<u64> = drawn.faces.keys().chain(drawn.read).copied().collect();
    let mut held = BTreeMap::<u64, BTreeSet<u64>>::new();
    let mut left = REACH;
    let all: Vec<u64> = frames.items.keys().copied().collect();
    for id in all {
        let Some(whole) = frames.least(id) else { continue };
        let found = held.entry(whole).or_default();
        let mut open: Vec<u64> = frames.items[&id].iter().copied().collect();
        let mut seen: BTreeSet<u64> = open.iter().copied().collect();
        while let Some(at) = open.pop() {
            left = left.checked_sub(1).ok_or_else(|| {
                Fault::TooLarge(format!("its representations reach more than {REACH} entities"))
            })?;
            if ends.contains(&at) {
                found.insert(at);
                found.extend(drawn.faces.get(&at));
            } else if let Some((part, map)) = mapped(entities, at) {
                if let Some(part) = frames.least(part) {
                    placements.push(Placement { id: at, part, whole, map });
                }
            } else if !frames.items.contains_key(&at) {
                let records = entities.get(&at).copied().unwrap_or_default();
                records.iter().for_each(|r| references(&r.parameter, &mut open, &mut seen));
            }
        }
    }
    Ok(held)
}

/// What parameters refer to, unless it was seen.
fn references(p: &Parameter, open: &mut Vec<u64>, seen: &mut BTreeSet<u64>) {
    match p {
        Parameter::List(all) => all.iter().for_each(|p| references(p, open, seen)),
        Parameter::Typed { parameter, .. } => references(parameter, open, seen),
        _ => {
            if let Some(id) = reference(p).filter(|id| seen.insert(*id)) {
                open.push(id);
            }
        }
    }
}

fn joined(
    mut held: BTreeMap<u64, BTreeSet<u64>>,
    mut placements: Vec<Placement>,
    shapes: &BTreeSet<u64>,
    drawn: &Drawn<'_>,
    notes: &mut Vec<String>,
) -> Result<Assembly, Fault> {
    placements.sort_by_key(|p| p.id);
    let mut inside = BTreeMap::<u64, Vec<u64>>::new();
    let mut all = Assembly::new("#");
    let mut unread = Vec::new();
    for p in &placements {
        inside.entry(p.whole).or_default().push(p.part);
        match p.map.filter(is_place) {
            Some(map) => all.placed.entry(p.whole).or_default().push((p.part, map)),
            None => unread.push(p.id),
        }
    }
    unread.dedup();
    if !unread.is_empty() {
        let which = named("#", &unread);
        notes.push(format!("parts whose place is not read are left out there: {which}"));
    }
    // Whatever stands in nothing else stands in the file; from there all others are met, or they stand in each other.
    let parts: BTreeSet<u64> = placements.iter().map(|p| p.part).collect();
    let roots: BTreeSet<u64> = held.keys().filter(|h| !parts.contains(h)).copied().collect();
    let mut met = roots.clone();
    let mut open: Vec<u64> = roots.iter().copied().collect();
    while let Some(at) = open.pop() {
        open.extend(inside.get(&at).into_iter().flatten().filter(|p| met.insert(**p)));
    }
    if let Some(lost) = parts.difference(&met).next() {
        return Err(all.endless(*lost));
    }
    // A representation of no product and without parts, as of features, draws nothing that others have.
    let (aside, own): (BTreeSet<u64>, BTreeSet<u64>) = held
        .keys()
        .partition(|h| roots.contains(h) && !shapes.contains(h) && !inside.contains_key(h));
    let known: BTreeSet<u64> = own.iter().flat_map(|h| &held[h]).copied().collect();
    for at in aside {
        held.entry(at).and_modify(|all| all.retain(|id| !known.contains(id)));
    }
    let known: BTreeSet<u64> = held.values().flatten().copied().collect();
    let rest = drawn.read.iter().filter(|id| !known.contains(id)).copied().collect();
    held.insert(Assembly::FILE, rest);
    all.held = held;
    let drawn = roots.into_iter().map(|r| (r, Transform::identity())).collect();
    all.placed.insert(Assembly::FILE, drawn);
    Ok(all)
}

/// The ends of a relation of representations, and what transforms the first into the second.
fn related(records: &[Record]) -> Option<([u64; 2], Option<u64>)> {
    let ends = |p: &[Parameter]| Some([reference(p.get(2)?)?, reference(p.get(3)?)?]);
    let ends = RELATIONS.iter().find_map(|name| of(records, name).and_then(ends))?;
    let by = of(records, RELATIONS[2]).and_then(|p| p.last());
    Some((ends, by.map(|p| reference(p).unwrap_or_default())))
}

/// Products of an assembly.
#[derive(Default)]
struct Products {
    /// Representations of each.
    shapes: BTreeMap<u64, Vec<u64>>,
    /// The product that a relation of representations places.
    parts: BTreeMap<u64, u64>,
}

impl Products {
    fn of(entities: &Entities<'_>) -> Self {
        let mut all = Self::default();
        // What the shape of PRODUCT_DEFINITION_SHAPE is of.
        let defined = |p: &Parameter| {
            let shape = single(entities, reference(p)?, "PRODUCT_DEFINITION_SHAPE")?;
            reference(shape.get(2)?)
        };
        for records in entities.values() {
            let used = match of(records, "SHAPE_DEFINITION_REPRESENTATION") {
                Some([shape, used]) => defined(shape).zip(reference(used)),
                _ => None,
            };
            if let Some((product, used)) = used {
                all.shapes.entry(product).or_default().push(used);
            }
            let Some([relation, shape]) = of(records, "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION")
            else {
                continue;
            };
            let part = |id: u64| {
                let usage = entities.get(&id)?.iter().find_map(|r| list(&r.parameter)?.get(4))?;
                reference(usage)
            };
            let part = defined(shape).and_then(part);
            if let (Some(relation), Some(part)) = (reference(relation), part) {
                all.parts.insert(relation, part);
            }
        }
        all
    }
}
