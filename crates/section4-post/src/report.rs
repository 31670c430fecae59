//! What the post-processor tells besides the text: a summary, and from which statement each block comes.

use aptc_diagnostics::Origin;
use serde::Serialize;
use smol_str::SmolStr;

/// Time, travel and limits of a program.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Summary {
    /// Name of the machine.
    pub machine: String,
    /// Text of PARTNO.
    pub part: String,
    /// `mm` or `inch`: unit of all lengths here.
    pub unit: &'static str,
    /// Lines of text.
    pub blocks: u64,
    /// Minutes of cutting at the programmed feeds.
    pub cut_minutes: f64,
    /// Minutes of rapid motion at the feed of the machine file.
    pub rapid_minutes: f64,
    /// Length of cuts.
    pub cut_length: f64,
    /// Length of rapid motion.
    pub rapid_length: f64,
    /// Positions of the tool end, bulges of arcs included.
    pub extent: Option<Extent>,
    /// How far each axis goes, in the order in which the control knows them.
    pub axes: Vec<AxisUse>,
    /// Least and greatest corner of the block of material, when it was given.
    pub stock: Option<[[f64; 3]; 2]>,
    /// Arcs written.
    pub arcs: u64,
    /// Cut vectors that the arcs replaced.
    pub chords_in_arcs: u64,
    /// Holes of cycles.
    pub holes: u64,
    /// Tools in order of use.
    pub tools: Vec<ToolUse>,
    /// Work offset.
    pub work_offset: String,
    /// What the operator must know: PPRINT texts before the first cut, STOP and wear offsets.
    pub notes: Vec<String>,
}

/// Least and greatest position of the tool end.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Extent {
    /// Least X, Y, Z.
    pub min: [f64; 3],
    /// Greatest X, Y, Z.
    pub max: [f64; 3],
}

/// How far an axis of the machine goes, in the numbers that stand in the text: lengths in output units,
/// angles in degrees, a diameter as its radius.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AxisUse {
    /// Its letter.
    pub letter: char,
    /// Is it a rotary axis?
    pub rotary: bool,
    /// Least position.
    pub min: f64,
    /// Greatest position.
    pub max: f64,
    /// Limits of the machine file, least and greatest, where it gives them.
    pub limits: [Option<f64>; 2],
}

/// Work of one tool between two tool changes.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ToolUse {
    /// Its number; none before the first LOADTL.
    pub number: Option<u32>,
    /// Number of its length offset.
    pub offset: Option<u32>,
    /// The seven values of CUTTER in output units, when they were given.
    pub cutter: Option<[f64; 7]>,
    /// What PPRINT or TPRINT says of it.
    pub comment: String,
    /// Minutes of cutting and rapid motion.
    pub minutes: f64,
    /// Least and greatest spindle speed.
    pub speeds: Option<[f64; 2]>,
    /// Least and greatest feed per minute.
    pub feeds: Option<[f64; 2]>,
    /// Lowest Z of the tool end.
    pub lowest: Option<f64>,
    /// First line of text of this tool, from 1.
    pub line: u64,
}

/// A run of lines that one statement gave.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BlockOrigin {
    /// First line of the text, from 1.
    pub first: u64,
    /// Last line.
    pub last: u64,
    /// The word or kind of the CL record.
    pub record: SmolStr,
    /// Statement, line, file, macros and loops.
    #[serde(flatten)]
    pub origin: Origin,
}

impl Extent {
    /// Of a single point.
    pub(crate) fn of(p: [f64; 3]) -> Self {
        Self { min: p, max: p }
    }

    /// Takes a point in.
    pub(crate) fn take(&mut self, p: [f64; 3]) {
        for (i, value) in p.into_iter().enumerate() {
            self.min[i] = self.min[i].min(value);
            self.max[i] = self.max[i].max(value);
        }
    }
}
