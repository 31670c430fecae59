//! What arcs the control takes.

use serde::{Deserialize, Serialize};

/// Circular motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Arcs {
    /// The planes that the control has: `XY`, `ZX`, `YZ`.
    pub planes: Vec<ArcPlane>,
    /// How the centre is told.
    pub center: ArcCenter,
    /// Arcs with motion along the axis?
    pub helix: bool,
    /// A whole turn in one block?
    pub full_circle: bool,
    /// Longest arc in one block, degrees; 90 stops at each quadrant.
    pub max_sweep: f64,
    /// Least radius, millimetres.
    pub min_radius: f64,
    /// Greatest radius, millimetres.
    pub max_radius: f64,
    /// By how much the radii at both ends may differ, millimetres: half of what the control allows.
    pub radius_tolerance: f64,
    /// Runs of short lines become arcs that leave them by at most this, millimetres; 0 for never, unless
    /// ARCSLP/LINCIR asks for it.
    pub fit: f64,
}

/// A plane of circular motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum ArcPlane {
    /// G17.
    #[serde(rename = "XY")]
    Xy,
    /// G18.
    #[serde(rename = "ZX")]
    Zx,
    /// G19.
    #[serde(rename = "YZ")]
    Yz,
}

/// How the centre of an arc is told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ArcCenter {
    /// I J K from the start of the arc.
    #[default]
    Relative,
    /// I J K as coordinates.
    Absolute,
    /// R, negative above 180 degrees; arcs near 180 degrees are halved, whole turns too.
    Radius,
}
