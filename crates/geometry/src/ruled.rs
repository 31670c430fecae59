//! RLDSRF: straight rulings between two plane curves.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::{Form, Vec3};

/// RLDSRF. A ruling joins the points of both curves that stand over equal fractions of their base lines.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RuledSurface {
    /// The first curve.
    pub first: Rail,
    /// What the rulings run to.
    pub second: Second,
}

/// The far ends of the rulings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Second {
    /// A second curve.
    Rail(Rail),
    /// One point for all: a general cone.
    Apex(Vec3),
}

/// A plane curve: the cut of a surface with the plane of its base line and a vector.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rail {
    /// The surface that is cut.
    pub surface: Arc<Form>,
    /// One end of the curve and of the base line.
    pub start: Vec3,
    /// The other end.
    pub end: Vec3,
    /// Direction in the cutting plane in which the curve is looked for from the base line, backwards only
    /// when it is not found forwards. Of any length but zero, not parallel to the base line.
    pub toward: Vec3,
}

impl RuledSurface {
    /// Flat list for print-outs: for each curve its surface's elements, both ends, the vector; or the apex.
    pub fn canonical(&self) -> Vec<f64> {
        let mut e = self.first.canonical();
        match &self.second {
            Second::Rail(rail) => e.extend(rail.canonical()),
            Second::Apex(p) => e.extend([p.x, p.y, p.z]),
        }
        e
    }
}

impl Rail {
    fn canonical(&self) -> Vec<f64> {
        let mut e = self.surface.canonical();
        e.extend([self.start, self.end, self.toward].iter().flat_map(|p| [p.x, p.y, p.z]));
        e
    }

    /// The point of the base line at fraction `t`, 0 at the start, 1 at the end.
    pub fn base(&self, t: f64) -> Vec3 {
        self.start + (self.end - self.start) * t
    }
}
