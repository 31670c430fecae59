//! The motions of a program in the order and place in which a CL file has them after editing.

use std::sync::Arc;

use aptc_cldata::{Edit, Kind, Motion, Record, Units};
use aptc_geometry::{Transform, Vec3};

/// A record of the program, and the maps that editing carries it by, TRACUT first.
#[derive(Clone, Debug)]
pub(crate) struct Item {
    pub(crate) record: Record,
    pub(crate) units: Units,
    tracut: Option<Transform>,
    copies: Option<Transform>,
}

/// Records that copies may make; beyond it the file is judged piecemeal by nobody.
const MOST: usize = 10_000_000;

impl Item {
    pub(crate) fn motion(&self) -> Option<&Motion> {
        match &self.record.kind {
            Kind::Motion(m) if !m.points.is_empty() => Some(m),
            _ => None,
        }
    }

    /// The map that editing carries it by in all.
    pub(crate) fn map(&self) -> Option<Transform> {
        match (self.tracut, self.copies) {
            (Some(tracut), Some(copies)) => Some(tracut.then(&copies)),
            (one, other) => one.or(other),
        }
    }

    /// It copied once more by that map. A copy is made anew from what it repeats, behind TRACUT: what copies now goes first, then
    /// what copied before.
    fn copied(&self, now: &Transform) -> Self {
        let copies = self.copies.map_or(*now, |before| now.then(&before));
        Self { copies: Some(copies), ..self.clone() }
    }

    /// Is it led along the same surfaces as one before it, carried there by the same map?
    pub(crate) fn goes_on(&self, before: &Self) -> bool {
        let control = |item: &Self| item.motion().and_then(|m| m.control.clone());
        let both = control(self).zip(control(before));
        both.is_some_and(|(a, b)| Arc::ptr_eq(&a, &b))
            && self.map() == before.map()
            && self.units == before.units
    }

    /// Where the motion ends, as the edited file has it, in millimetres.
    pub(crate) fn end_mm(&self) -> Vec3 {
        let end = self.motion().and_then(|m| m.points.last()).map_or_else(Vec3::zeros, |p| p.te);
        self.map().map_or(end, |m| m.point(end)) * self.units.mm()
    }
}

/// Carries out INDEX, COPY and TRACUT on the list of records; their own records are left out.
pub(crate) fn unfold(program: &[Record]) -> Result<Vec<Item>, String> {
    let mut out: Vec<Item> = Vec::with_capacity(program.len());
    let mut tracut: Option<Transform> = None;
    let mut units = Units::default();
    let mut ranges: Vec<(f64, usize, Option<usize>)> = Vec::new();
    for record in program {
        match &record.kind {
            Kind::Edit(Edit::Tracut(map)) => tracut = *map,
            Kind::Edit(Edit::Index { n, close: false }) => ranges.push((*n, out.len(), None)),
            Kind::Edit(Edit::Index { n, close: true }) => {
                let end = out.len();
                if let Some(r) = ranges.iter_mut().rev().find(|r| same(r.0, *n)) {
                    r.2.get_or_insert(end);
                }
            }
            Kind::Edit(Edit::Copy { n, step, count }) => {
                let Some(&(_, start, end)) = ranges.iter().rev().find(|r| same(r.0, *n)) else {
                    continue;
                };
                let range = out[start..end.unwrap_or(out.len())].to_vec();
                if range.len().saturating_mul(*count as usize) + out.len() > MOST {
                    return Err("COPY makes more records than can be compared".to_owned());
                }
                let mut map = Transform::identity();
                for _ in 0..*count {
                    map = map.then(step);
                    out.extend(range.iter().map(|item| item.copied(&map)));
                }
            }
            kind => {
                if let Kind::Units(u) = kind {
                    units = *u;
                }
                out.push(Item { record: record.clone(), units, tracut, copies: None });
            }
        }
    }
    Ok(out)
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}
