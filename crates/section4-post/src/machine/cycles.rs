//! The cycles of the control, and their words.

use serde::{Deserialize, Serialize};

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
