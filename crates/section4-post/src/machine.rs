//! The machine file: all that the post-processor knows of a machine and its control.
//!
//! A machine is data. Each struct below is a table of the TOML file and each field a key; a key that is
//! not here is refused by name. Lengths of the file are in millimetres and angles in degrees, whatever
//! unit a part program or its output has. Templates are lines of the control's own language: `{name}` in
//! them is replaced, a line with an empty replacement is left out, and a line that begins with `;` is
//! written as a comment of the control.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

mod arcs;
mod builtin;
mod check;
mod cycles;
mod defaults;
mod milling;
mod rotary;

pub use arcs::{ArcCenter, ArcPlane, Arcs};
pub use builtin::{machin_names, machine, machine_file, machine_for, machines};
pub use cycles::{Cycle, CycleWord, CycleWords};
pub use milling::Milling;
pub use rotary::{Carries, Multiaxis, Rotary, RotaryFeed, Wrap};

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
