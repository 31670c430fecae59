//! Rotary axes, and motion with them.

use serde::{Deserialize, Serialize};

/// A rotary axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rotary {
    /// Address letter.
    pub letter: char,
    /// Does it turn the part or the tool?
    pub carries: Carries,
    /// Direction of its axis at zero of all axes. A positive angle turns what it carries anticlockwise seen
    /// from the tip of this direction.
    pub axis: [f64; 3],
    /// A point of its axis, millimetres: for the part in the frame of the program, for the tool from the
    /// tool end of a tool of no length.
    #[serde(default)]
    pub point: [f64; 3],
    /// Least angle; none for an axis without end.
    #[serde(default)]
    pub min: Option<f64>,
    /// Greatest angle.
    #[serde(default)]
    pub max: Option<f64>,
    /// How an axis without end writes angles beyond a turn.
    #[serde(default)]
    pub wrap: Wrap,
    /// Greatest speed, degrees a minute; 0 when unknown.
    #[serde(default)]
    pub max_feed: f64,
    /// Code that holds it fast.
    #[serde(default)]
    pub clamp: String,
    /// Code that sets it free.
    #[serde(default)]
    pub unclamp: String,
}

/// What a rotary axis turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Carries {
    /// A table.
    Part,
    /// A head.
    Tool,
}

/// How an axis without end writes angles beyond a turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Wrap {
    /// The angles grow without end.
    #[default]
    Unwound,
    /// Within 0 to 360; the control takes the shorter way.
    Modulo,
}

/// How motion with rotary axes is done.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Multiaxis {
    /// Does the control keep the tool end on its path? Then positions of the tool end are written, else
    /// positions of the axes.
    pub tool_center: bool,
    /// Words that begin tool-centre control, with `{offset}`.
    pub tool_center_on: String,
    /// Do these words stand in the block of the first motion along Z, in place of the length offset? Else
    /// they are a block before the first motion.
    pub tool_center_with_z: bool,
    /// Line that ends it.
    pub tool_center_off: String,
    /// Lines that tilt the plane of the program after ROTABL and ROTHED, for controls with tool-centre control:
    /// `{first}` `{second}` `{third}` are the angles about Z, the new X and the new Z, `{x}` `{y}` `{z}` those about
    /// X, the new Y and the new Z. Without them positions stay in the frame of the part.
    pub plane_on: Vec<String>,
    /// Lines that end it.
    pub plane_off: Vec<String>,
    /// How far the tool end may leave the straight line because rotary axes turn evenly (LINTOL),
    /// millimetres.
    pub lintol: f64,
    /// How far the tool axis may lean out of the plane of its ends between two blocks, degrees.
    pub axis_tolerance: f64,
    /// Feed of blocks in which a rotary axis turns.
    pub feed: RotaryFeed,
    /// How far the tool retracts along its axis before rotary axes are wound back, millimetres; 0 when that
    /// may not be done.
    pub rewind_retract: f64,
    /// Feed of that retract and of the way back, millimetres a minute.
    pub rewind_feed: f64,
    /// Within this angle of the singular direction the first rotary axis may keep its angle, degrees.
    pub singular: f64,
    /// Comment before the first block in which the tool turns where it stands at feed, for tool-centre controls
    /// that need a parameter of theirs for it.
    pub turn_note: String,
    /// Length of the tool for control without tool-centre control when CUTTER and LOADTL give none,
    /// millimetres.
    pub tool_length: Option<f64>,
}

/// Feed of blocks in which a rotary axis turns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RotaryFeed {
    /// The control means the tool end.
    #[default]
    Tip,
    /// Inverse time.
    Inverse,
    /// The control takes degrees as if they were units of length, and the feed along the way of all axes.
    Degrees,
}
