//! The machine file: all that the post-processor knows of a machine and its control.
//!
//! A machine is data. Each struct below is a table of the TOML file and each field a key; a key that is
//! not here is refused by name. Lengths of the file are in millimetres and angles in degrees, whatever
//! unit a part program or its output has. Templates are lines of the control's own language: `{name}` in
//! them is replaced, a line with an empty replacement is left out, and a line that begins with `;` is
//! written as a comment of the control.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

mod builtin;
mod check;
mod defaults;
mod milling;

pub use builtin::{machin_names, machine, machine_file, machine_for, machines};
pub use milling::Milling;

/// A machine with its control.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Machine {
    /// Name for `--machine`, small letters.
    pub name: String,
    /// What it is, one line.
    pub title: String,
    /// MACHIN names that mean this machine: `EMC`, or `PMILL,5` where the number after the name decides.
    #[serde(default)]
    pub machin: Vec<String>,
    /// Mill or lathe.
    #[serde(default)]
    pub kind: MachineKind,
    /// The language of the control.
    #[serde(default)]
    pub dialect: Dialect,
    /// Unit of the output.
    #[serde(default)]
    pub units: OutputUnits,
    /// Feed per minute, in millimetres, for cuts of a program that gives none; used with a warning. Without
    /// it a cut without feed is refused.
    #[serde(default)]
    pub default_feed: Option<f64>,
    /// Frame of the program.
    #[serde(default)]
    pub program: Program,
    /// How numbers are written, by address letter.
    pub format: BTreeMap<char, Format>,
    /// Spindle.
    #[serde(default)]
    pub spindle: Spindle,
    /// Code of each COOLNT word: `ON`, `FLOOD`, `MIST`, `TAPKUL`, `THRU`, `AIR`, `OFF`. A word that is not
    /// here is refused.
    #[serde(default)]
    pub coolant: BTreeMap<String, String>,
    /// Feed.
    #[serde(default)]
    pub feed: Feed,
    /// Rapid motion.
    #[serde(default)]
    pub rapid: Rapid,
    /// Circular motion; without the table all arcs are written as lines.
    #[serde(default)]
    pub arcs: Option<Arcs>,
    /// Drilling cycles by the word after CYCLE; one that is not here is written as single motions where
    /// that is possible and refused where it is not.
    #[serde(default)]
    pub cycles: BTreeMap<String, Cycle>,
    /// Words of cycles.
    #[serde(default)]
    pub cycle: CycleWords,
    /// Length and radius compensation in the control.
    #[serde(default)]
    pub compensation: Compensation,
    /// Turning; for lathes.
    #[serde(default)]
    pub turning: Turning,
    /// Milling with the spindle as an axis; for lathes.
    #[serde(default)]
    pub milling: Option<Box<Milling>>,
    /// The linear axes by letter.
    #[serde(default)]
    pub axes: BTreeMap<char, Axis>,
    /// The rotary axes, from the one next to the machine's frame to the one that carries the part, then from
    /// the frame to the tool.
    #[serde(default)]
    pub rotary: Vec<Rotary>,
    /// How motion with rotary axes is done.
    #[serde(default)]
    pub multiaxis: Multiaxis,
}

/// Mill or lathe.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum MachineKind {
    /// The tool turns.
    #[default]
    Mill,
    /// The part turns; X and Z only.
    Lathe,
}

/// The language of a control.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Dialect {
    /// Words of letter and number, after RS-274.
    #[default]
    Rs274,
    /// The same with the keywords and cycles of Siemens 840D.
    Siemens,
    /// Heidenhain conversational.
    Heidenhain,
    /// CL data again, as text of ISO 4343.
    Apt,
}

/// Unit of the output.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum OutputUnits {
    /// As the part program: inches for INCHES and FEET, else millimetres.
    #[default]
    Part,
    /// Millimetres.
    Mm,
    /// Inches.
    Inch,
}

/// Frame of the program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Program {
    /// Lines before the first block: `{part}` the PARTNO text, `{number}` the program number, `{units}`,
    /// `{work_offset}`, `{tolerance}` of the path, `{machine}`.
    pub start: Vec<String>,
    /// Lines of END and FINI.
    pub end: Vec<String>,
    /// Lines of LOADTL: `{tool}` and `{offset}`, with two digits `{tool2}` and `{offset2}`, `{next}` the next
    /// tool, `{tool_comment}` what TPRINT says, `{units}`,
    /// `{work_offset}`. They must leave the tool retracted, and all modes as a restart needs them.
    pub tool_change: Vec<String>,
    /// Line that makes the next tool ready, with `{next}`.
    pub preselect: String,
    /// Lines that retract the tool as far as the machine goes: RETRCT.
    pub retract: Vec<String>,
    /// Lines that bring the machine to its home: GOHOME.
    pub home: Vec<String>,
    /// Does the start leave the tool retracted, so that the first motion may go to its X and Y at once?
    pub start_retracts: bool,
    /// STOP.
    pub stop: String,
    /// OPSTOP.
    pub optional_stop: String,
    /// DELAY with `{seconds}` or `{milliseconds}`.
    pub dwell: String,
    /// Code of inches.
    pub inch: String,
    /// Code of millimetres.
    pub metric: String,
    /// Work offset that `{work_offset}` stands for.
    pub work_offset: String,
    /// Tolerance of the path in the control when MCHTOL gives none, millimetres; 0 for none.
    pub path_tolerance: f64,
    /// Line of MCHTOL with `{tolerance}`; empty when the control has none.
    pub path_mode: String,
    /// Program number; 0 for none.
    pub number: u32,
    /// Between two words of a block.
    pub separator: String,
    /// Before a comment.
    pub comment_open: String,
    /// After a comment.
    pub comment_close: String,
    /// Characters that a comment may not hold; they are left out.
    pub comment_forbidden: String,
    /// Comments in capitals?
    pub comment_capitals: bool,
    /// Longest line, characters.
    pub max_line: usize,
    /// Before a block of OPSKIP; empty when the control has none.
    pub skip: String,
    /// Block numbers.
    pub block_numbers: BlockNumbers,
}

/// Block numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct BlockNumbers {
    /// Are blocks numbered before SEQNO speaks?
    pub on: bool,
    /// The letter.
    pub letter: String,
    /// First number.
    pub start: u32,
    /// Step.
    pub step: u32,
    /// After this number comes `start` again.
    pub max: u32,
}

/// How the number after an address is written.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Format {
    /// Decimals when the output is metric, at most 9.
    pub mm: u8,
    /// Decimals when the output is in inches; as `mm` when left out.
    #[serde(default)]
    pub inch: Option<u8>,
    /// Is a whole number written with its point? `X5.` for `X5`.
    #[serde(default)]
    pub point: bool,
    /// Are zeros at the end kept?
    #[serde(default)]
    pub zeros: bool,
    /// Is the plus sign written?
    #[serde(default)]
    pub plus: bool,
}

/// Spindle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Spindle {
    /// Clockwise, with `{speed}`.
    pub cw: String,
    /// Anticlockwise, with `{speed}`; empty when it cannot.
    pub ccw: String,
    /// Off.
    pub off: String,
    /// Oriented stop, with `{angle}`; empty when it cannot.
    pub orient: String,
    /// Constant surface speed with `{speed}` in metres or feet a minute and `{max}`; empty when it cannot.
    pub surface_speed: String,
    /// Ends constant surface speed.
    pub surface_speed_off: String,
    /// Least speed, revolutions a minute.
    pub min: f64,
    /// Greatest speed, revolutions a minute; 0 when unknown.
    pub max: f64,
    /// Code of each gear range (LOW, MEDIUM, HIGH, or a number); empty when the machine has one range only.
    pub ranges: BTreeMap<String, String>,
}

/// Feed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Feed {
    /// Mode of feed per minute.
    pub per_minute: String,
    /// Mode of feed per revolution; empty when it cannot.
    pub per_revolution: String,
    /// Mode of inverse time; empty when it cannot.
    pub inverse_time: String,
    /// Greatest feed, millimetres a minute; 0 when unknown.
    pub max: f64,
}

/// Rapid motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Rapid {
    /// How a rapid motion along all axes is done.
    pub path: RapidPath,
    /// Feed of rapid motion for the time, millimetres a minute.
    pub feed: f64,
}

/// How a rapid motion along all axes is done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RapidPath {
    /// The control moves on the straight line.
    #[default]
    Straight,
    /// Each axis goes as fast as it can: the tool axis is moved apart, first when it goes up, last when it
    /// goes down.
    Split,
    /// By a cut at the feed of rapid motion.
    Feed,
}

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

/// A cycle that the control has.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cycle {
    /// Its code: `G81`. Depth, clearance and feed follow as Z, R and F.
    #[serde(default)]
    pub code: String,
    /// Or lines that define it, where a position calls it: `{surface}` `{bottom}` `{clearance}` `{retract}`
    /// as coordinates, `{depth}` `{clear}` `{back}` as distances from the surface, `{step}` `{first}`
    /// `{dwell}` `{feed}` `{pitch}` `{speed}`.
    #[serde(default)]
    pub lines: Vec<String>,
    /// Lines before the block that begins it, with `{speed}` `{pitch}` `{feed}`: `M29 S{speed}` of rigid tapping.
    /// The control stops the spindle for them; it is started again after the cycle.
    #[serde(default)]
    pub before: Vec<String>,
    /// Address of the pitch, for a code that taps one hole from the clearance down and up again with the spindle
    /// and stays for no other: `K` of G33.1.
    #[serde(default)]
    pub lead: Option<char>,
    /// The words that it needs besides depth, retract plane and feed: `Q` step, `P` dwell.
    #[serde(default)]
    pub words: Vec<CycleWord>,
    /// The spindle turns so in it: `CLW` or `CCLW`; empty when it does not matter.
    #[serde(default)]
    pub spindle: String,
}

/// A word of a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum CycleWord {
    /// Depth of one peck.
    Step,
    /// Dwell at the bottom.
    Dwell,
    /// Dwell at the bottom, left out when there is none.
    MaybeDwell,
}

/// Words of cycles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct CycleWords {
    /// Ends a cycle; empty when it holds for one position only.
    pub off: String,
    /// Words at the end of a position that calls a cycle defined by lines.
    pub call: String,
    /// Retracts to the plane of the first height.
    pub to_initial: String,
    /// Retracts to the clearance plane only.
    pub to_clearance: String,
    /// Address of the step.
    pub step: char,
    /// Address of the dwell.
    pub dwell: char,
    /// Is the dwell in milliseconds?
    pub dwell_ms: bool,
    /// How far above the last depth an expanded peck comes back, millimetres.
    pub peck_back: f64,
}

/// Compensation in the control.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Compensation {
    /// Length offset in the block of the first motion along Z, with `{offset}`.
    pub length: String,
    /// Ends it.
    pub length_off: String,
    /// Do the lines of RETRCT and GOHOME end it, so that the next motion along Z has to begin it again?
    pub retract_ends_length: bool,
    /// CUTCOM/LEFT with `{offset}`; empty when the control has none.
    pub left: String,
    /// CUTCOM/RIGHT with `{offset}`.
    pub right: String,
    /// CUTCOM/OFF.
    pub off: String,
    /// Does it stand in the block of the next motion, and not alone?
    pub off_with_motion: bool,
    /// Line written once for each offset number before it is used, with `{offset}`: where the wear is kept.
    pub wear_define: String,
    /// How it is guaranteed that the number means wear only: a comment in the program.
    pub wear_note: String,
}

/// Turning.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Turning {
    /// The plane in which turned parts are drawn.
    pub plane: TurningPlane,
    /// Code of a straight cut that goes with the spindle: `G33`; empty when there is none.
    pub thread: String,
    /// Address of the lead along Z in such a block.
    pub lead: Option<char>,
}

/// The plane in which turned parts are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum TurningPlane {
    /// The spindle along Z, radii along X.
    #[default]
    #[serde(rename = "ZX")]
    Zx,
    /// The spindle along X, radii along Y.
    #[serde(rename = "XY")]
    Xy,
}

/// A linear axis.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Axis {
    /// Least position, millimetres in the frame of the program.
    pub min: Option<f64>,
    /// Greatest position, millimetres.
    pub max: Option<f64>,
    /// Greatest speed, millimetres a minute; 0 when unknown.
    pub max_feed: f64,
    /// Are positions written as twice their value (diameters of a lathe)?
    pub diameter: bool,
}

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
