//! BOUNDS and OBJECT: sides of surfaces, and solids made of them.

use serde::{Deserialize, Serialize};

use super::Extent;
use super::numbers::push;
use crate::{Form, Vec3};

/// BOUNDS and OBJECT: sides of surfaces, and solids made of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solid {
    /// OBJECT joins its parts; BOUNDS is what all its sides have in common.
    pub object: bool,
    /// The surfaces, or BOUNDS and OBJECTs, with their sides.
    pub parts: Vec<(Form, Side)>,
}

/// Which side of a surface belongs to a BOUNDS.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// None was named: the surface's own positive side; always so in an OBJECT.
    Own,
    /// A number.
    Numbered(f64),
    /// IN.
    In,
    /// OUT.
    Out,
    /// The side of a point.
    Of(Vec3),
    /// POSX to NEGZ: the side towards this unit direction.
    Toward(Vec3),
}

impl Solid {
    /// Its size.
    pub fn extent(&self) -> Extent {
        let inner = self.parts.iter().filter_map(|(form, _)| match form {
            Form::Solid(s) => Some(s.extent()),
            _ => None,
        });
        Extent::of(self.parts.len(), inner)
    }

    /// All numbers of the parts in order.
    pub fn numbers(&self) -> Vec<f64> {
        let mut out = Vec::new();
        for (form, side) in &self.parts {
            out.extend(form.canonical());
            match side {
                Side::Numbered(n) => out.push(*n),
                Side::Of(v) | Side::Toward(v) => push(&mut out, &[*v]),
                Side::Own | Side::In | Side::Out => {}
            }
        }
        out
    }
}
