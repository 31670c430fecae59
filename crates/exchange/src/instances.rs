//! What a file draws once and places as often as it likes, within each other: parts of assemblies, subfigures.

use std::collections::{BTreeMap, BTreeSet};

use aptc_geometry::Transform;

use crate::{Collected, Fault, broken};

/// Things placed within each other, and all that are placed: two in each of many would fill any memory.
const DEPTH: usize = 64;
const PLACED: usize = 100_000;
/// Numbers of a placement are below it, so that lengths and their products stay numbers.
const FAR: f64 = 1e75;

/// Things that hold surfaces and place each other, by numbers of their own; [`Assembly::FILE`] is the file.
pub(crate) struct Assembly {
    /// What stands before a number in a message.
    mark: &'static str,
    /// Surfaces that each holds, by the numbers under which they are drawn.
    pub(crate) held: BTreeMap<u64, BTreeSet<u64>>,
    /// What each places, and where, in the order of the file.
    pub(crate) placed: BTreeMap<u64, Vec<(u64, Transform)>>,
}

/// Things at one place.
struct Group {
    /// `None`: as they are drawn.
    map: Option<Transform>,
    things: BTreeSet<u64>,
}

/// The groups of a file, in the order in which the first of each is placed.
#[derive(Default)]
struct Groups {
    all: Vec<Group>,
    /// By the bits of the map.
    known: BTreeMap<[u64; 12], usize>,
    n_placed: usize,
    path: Vec<u64>,
}

/// One map after the other, each of which may be none.
pub(crate) fn then(first: Option<Transform>, next: Option<Transform>) -> Option<Transform> {
    match (first, next) {
        (Some(a), Some(b)) => Some(a.then(&b)),
        (a, b) => a.or(b),
    }
}

/// Can a map place something? Its numbers are finite, and it does not flatten space.
pub(crate) fn is_place(map: &Transform) -> bool {
    map.rows().iter().all(|x| x.abs() < FAR) && map.inverse().is_some()
}

impl Assembly {
    /// The file itself.
    pub(crate) const FILE: u64 = 0;

    pub(crate) fn new(mark: &'static str) -> Self {
        Self { mark, held: BTreeMap::new(), placed: BTreeMap::new() }
    }

    /// A thing that would have no end.
    pub(crate) fn endless(&self, thing: u64) -> Fault {
        broken(format!("{}{thing} is placed within itself", self.mark))
    }

    /// Everything that is placed from the file on.
    fn groups(&self) -> Result<Groups, Fault> {
        let mut groups = Groups::default();
        groups.add(self, Self::FILE, &Transform::identity())?;
        Ok(groups)
    }
}

impl Groups {
    fn add(&mut self, all: &Assembly, thing: u64, map: &Transform) -> Result<(), Fault> {
        if self.path.contains(&thing) {
            return Err(all.endless(thing));
        }
        self.n_placed += 1;
        if self.path.len() >= DEPTH || self.n_placed > PLACED {
            return Err(Fault::TooLarge(format!(
                "more than {PLACED} parts are placed, or more than {DEPTH} within each other"
            )));
        }
        // Zero without its sign.
        let bits = map.rows().map(|x| (x + 0.0).to_bits());
        let group = *self.known.entry(bits).or_insert_with(|| {
            let own = (*map != Transform::identity()).then_some(*map);
            self.all.push(Group { map: own, things: BTreeSet::new() });
            self.all.len() - 1
        });
        self.all[group].things.insert(thing);
        self.path.push(thing);
        for (part, own) in all.placed.get(&thing).into_iter().flatten() {
            self.add(all, *part, &own.then(map))?;
        }
        self.path.pop();
        Ok(())
    }
}

impl Collected<'_> {
    /// Puts the surfaces, of which `drawn` has the numbers, where an assembly places them: those of the file first, then those of
    /// each placement, each in the order of the file. What stands twice at one place is there once.
    pub(crate) fn place(&mut self, drawn: &[u64], assembly: &Assembly) -> Result<(), Fault> {
        let groups = assembly.groups()?;
        let mut by_number = BTreeMap::<u64, Vec<usize>>::new();
        for (k, id) in drawn.iter().enumerate() {
            by_number.entry(*id).or_default().push(k);
        }
        // Of each thing the surfaces that were read.
        let of_thing = |held: &BTreeSet<u64>| {
            held.iter().filter_map(|id| by_number.get(id)).flatten().copied().collect()
        };
        let read: BTreeMap<u64, Vec<usize>> =
            assembly.held.iter().map(|(thing, held)| (*thing, of_thing(held))).collect();
        let surfaces = std::mem::take(&mut self.file.surfaces);
        let sizes = std::mem::take(&mut self.sizes);
        self.points = 0;
        for Group { map, things } in &groups.all {
            let own: BTreeSet<usize> =
                things.iter().filter_map(|t| read.get(t)).flatten().copied().collect();
            for k in own {
                let s = &surfaces[k];
                self.push(s.shape.clone(), sizes[k], then(s.map, *map))?;
            }
        }
        Ok(())
    }
}
