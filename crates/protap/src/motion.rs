//! The record types of motion.

use std::sync::Arc;

use aptc_geometry::{Form, Vec3};
use serde::{Deserialize, Serialize};

use crate::NameRef;

/// What Section 2 answers to a record; Section 0 hands it to Section 1 before it asks for the next one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// Nothing moved, or the motion waits for its implied check surface.
    None,
    /// The tool stands at `te` with axis `ta`; `check` is the place (from 0) of the check surface that
    /// stopped it, among those of the statement.
    Moved {
        /// Tool end.
        te: Vec3,
        /// Tool axis.
        ta: Vec3,
        /// Which check surface.
        check: usize,
    },
    /// The motion failed; a diagnostic was given.
    Failed,
}

/// A surface as a statement names it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SurfaceRef {
    /// Name and subscript; empty for an unnamed definition.
    #[serde(default)]
    pub name: NameRef,
    /// Its canonical form in the base system.
    pub form: Arc<Form>,
}

/// A point of point-to-point motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// The point's name.
    #[serde(default)]
    pub name: NameRef,
    /// Tool end.
    pub point: Vec3,
    /// Tool axis, not necessarily unit; it becomes the fixed axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<Vec3>,
}

/// What the cutter does to a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum Relation {
    /// Touches it from the near side.
    To,
    /// Tool end on it.
    On,
    /// Touches it from the far side.
    Past,
    /// Tangent to the drive surface (TANTO, DSTAN).
    Tanto,
    /// Tangent to the part surface.
    Pstan,
}

/// GO and OFFSET: one to three surfaces in the order drive, part, check.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Go {
    /// Is it OFFSET?
    #[serde(default)]
    pub offset: bool,
    /// The surfaces with their relations; TO when none was written.
    pub surfaces: Vec<(Relation, SurfaceRef)>,
}

/// The motion words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
#[expect(missing_docs, reason = "each is the APT word")]
pub enum Direction {
    Golft,
    Gorgt,
    Gofwd,
    Goback,
    Goup,
    Godown,
}

/// Continuous motion along a drive surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drive {
    /// The way to turn from the last motion.
    pub direction: Direction,
    /// The drive surface.
    pub drive: SurfaceRef,
    /// The check surfaces; none when the next motion's drive surface is meant. The first that is satisfied
    /// stops the motion.
    pub checks: Vec<Check>,
}

/// A check surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// What the cutter does to it.
    pub relation: Relation,
    /// `n,INTOF`: the n-th intersection, 1 when not written.
    pub nth: u32,
    /// The surface.
    pub surface: SurfaceRef,
    /// Does a label follow it? Section 1 keeps the label and jumps on the outcome.
    #[serde(default)]
    pub branch: bool,
}

/// Side of the cutter to the drive surface, seen along the motion with the tool axis up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
#[expect(missing_docs, reason = "each is the APT word")]
pub enum DriveSide {
    Tllft,
    Tlrgt,
    Tlon,
    Tlndon,
}

/// TLONPS or TLOFPS.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum PartSide {
    /// Tool end on the part surface.
    Tlonps,
    /// Cutter tangent to the part surface.
    Tlofps,
}

/// Sense of direction for the next motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Sense {
    /// INDIRV: vectors, one for each surface of the next GO in the order written there; `None` for an
    /// empty field. Never empty.
    Vector(Vec<Option<Vec3>>),
    /// INDIRP: points, likewise.
    Point(Vec<Option<Vec3>>),
}

/// Against which surface a CUTTER/OPTION disk stands for the cutter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum OptionSurface {
    /// 1: the part surface.
    Part,
    /// 2: the drive surface.
    Drive,
}

/// TLAXIS.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ToolAxis {
    /// A fixed axis, not necessarily unit.
    Fixed(Vec3),
    /// TLAXIS/1: the axis that the tool has now, fixed from here on.
    Keep,
    /// Square to the part surface.
    NormPs,
    /// Square to the drive surface.
    NormDs,
    /// Along the rulings of the part (1) or drive (2) surface; APT4 adds radius and height at which the
    /// cutter touches.
    Parallel {
        /// The surface.
        surface: OptionSurface,
        /// RADIUS.
        radius: Option<f64>,
        /// HIGHT.
        height: Option<f64>,
    },
    /// At an angle to the normal of the part (1) or drive (2) surface.
    Angle(AxisAngle),
    /// Square to a direction (PERPTO).
    PerpTo(Vec3),
    /// Back to the mode before.
    Last,
}

/// TLAXIS/ATANGL.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AxisAngle {
    /// The surface to whose normal the angle is measured.
    pub surface: OptionSurface,
    /// The angle, degrees.
    pub angle_deg: f64,
    /// The axis stays in the plane square to this vector (four axes); without it the axis is tilted in
    /// the plane of the surface normal and the motion's cross direction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reference: Option<Vec3>,
    /// CUTANG: tilt along the motion, degrees, positive leading.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cutting_deg: Option<f64>,
    /// RADIUS of APT4: how far from the tool axis the cutter touches.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub radius: Option<f64>,
    /// HIGHT of APT4: how far above the tool end the cutter touches.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
}

/// POCKET/re,c,f,f1,f2,f3,o,p,P1..Pn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pocket {
    /// Effective cutter radius.
    pub radius: f64,
    /// Cut of the general passes as a multiple of the effective radius.
    pub cut: f64,
    /// Cut of the finish pass likewise.
    pub finish: f64,
    /// Feed rates of plunge, general passes and finish pass.
    pub feeds: [f64; 3],
    /// The two flags o and p: offset of the points from the boundary, and kind of the points.
    pub flags: [i32; 2],
    /// The vertices.
    pub vertices: Vec<Vec3>,
}
