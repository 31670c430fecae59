//! Faces of STEP: the box of a surface's parameters that a face's edges leave.

use super::curves::{flag, single};
use super::edges::{Curves, Edge};
use super::forms::Form;
use super::{Entities, list, reference};
use crate::border::Border;
use crate::follow::{bounded, follow};

/// A face, with its surface.
pub(super) struct Face {
    pub(super) id: u64,
    pub(super) surface: u64,
    /// Does its normal have the surface's sense?
    along: bool,
    bounds: Vec<u64>,
}

/// The faces of a file, by their numbers.
pub(super) fn faces(entities: &Entities<'_>) -> Vec<Face> {
    let of = |(id, records): (&u64, &&[ruststep::ast::Record])| {
        let all = ["ADVANCED_FACE", "FACE_SURFACE"].iter().find_map(|n| super::of(records, n))?;
        let bounds = list(all.get(1)?).unwrap_or_default().iter().filter_map(reference).collect();
        let along = flag(all.get(3)?)?;
        Some(Face { id: *id, surface: reference(all.get(2)?)?, along, bounds })
    };
    entities.iter().filter_map(of).collect()
}

/// The box of a face in the parameters of its surface; `None` where its edges do not tell.
pub(super) fn border(curves: &mut Curves<'_>, face: &Face, form: &Form) -> Option<Border> {
    let mut lines = Vec::new();
    for bound in &face.bounds {
        let name = ["FACE_OUTER_BOUND", "FACE_BOUND"];
        let all = name.iter().find_map(|n| single(curves.entities, *bound, n))?;
        let id = reference(all.get(1)?)?;
        // A single vertex bounds nothing.
        if single(curves.entities, id, "VERTEX_LOOP").is_some() {
            continue;
        }
        let edges = list(single(curves.entities, id, "EDGE_LOOP")?.get(1)?)?;
        // The face is on the left of its border, seen against its normal.
        let left = flag(all.get(2)?)? == face.along;
        let edges = edges.iter().map(|e| curves.edge(e)).collect::<Option<Vec<Edge>>>()?;
        lines.push(follow(&mut curves.work, &edges, form, left)?);
    }
    bounded(&mut lines, form)
}
