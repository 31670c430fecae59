//! Spindle and coolant that wait: they come on where work begins, after a tool change that stands before it.
//!
//! `SPINDL COOLNT LOADTL` in the order of their writing would start the spindle with the tool that is about to
//! leave it, and stop it at once. What a program means by it is the tool that it loads.

use aptc_cldata::{Arg, Kind, MotionKind, Record};
use aptc_diagnostics::{Origin, codes};

use crate::machine::MachineKind;
use crate::post::Post;

/// A SPINDL or COOLNT whose block is not written yet.
#[derive(Clone, Debug)]
pub(crate) struct Held {
    /// The spindle; else the coolant.
    pub(crate) spindle: bool,
    /// The statement as it was written.
    pub(crate) written: String,
    pub(crate) origin: Origin,
}

impl Post {
    /// The block of a SPINDL or COOLNT waits until something comes that may want it.
    pub(crate) fn hold(&mut self, spindle: bool, written: String, origin: &Origin) {
        self.st.held.retain(|h| h.spindle != spindle);
        self.st.held.push(Held { spindle, written, origin: origin.clone() });
        if self.st.ended {
            self.let_go();
        }
    }

    /// Writes what waits, in the order of the program.
    pub(crate) fn let_go(&mut self) {
        for held in std::mem::take(&mut self.st.held) {
            let before = self.blocks.lines;
            self.annotate(&held.origin);
            if held.spindle {
                self.spindle_on();
            } else {
                self.coolant_on();
            }
            self.note_word(before, &held.origin, if held.spindle { "SPINDL" } else { "COOLNT" });
        }
    }

    /// At a tool change, which stops both: what waits comes on with what ran before, when the new tool works.
    pub(crate) fn held_over_change(&mut self, tool: u32, change: &str, origin: &Origin) {
        let held = std::mem::take(&mut self.st.held);
        // Where the part turns, no tool does.
        let turns_tool = self.machine.kind == MachineKind::Mill || self.machine.is_milling();
        if let Some(spindle) = held.iter().find(|h| h.spindle)
            && turns_tool
            && self.st.tool != Some(tool)
        {
            let other = match self.st.tool {
                Some(n) => format!("tool {n} would have turned"),
                None => "the tool that happens to be in the spindle would have turned".into(),
            };
            let message = format!(
                "{} before {change}: {other}; the spindle starts after the tool change",
                spindle.written
            );
            self.warn(codes::NOT_READY, origin, message, "write SPINDL after the tool change");
        }
    }
}

/// May spindle and coolant wait beyond this record? It moves nothing, writes nothing that wants them, or stops them.
pub(crate) fn may_wait(record: &Record) -> bool {
    match &record.kind {
        Kind::Motion(m) => m.kind == MotionKind::From,
        // An oriented stop ends the turning of the spindle, also of one that waits.
        Kind::Post { word, args } if word == "SPINDL" => {
            !matches!(args.first(), Some(Arg::Word(w)) if w == "ORIENT")
        }
        Kind::Post { word, .. } => matches!(
            word.as_str(),
            "AIR"
                | "CLRSRF"
                | "COOLNT"
                | "END"
                | "FEDRAT"
                | "LINTOL"
                | "LOAD"
                | "LOADTL"
                | "MACHIN"
                | "MODE"
                | "PARTNO"
                | "PPRINT"
                | "SELCTL"
                | "SELECT"
                | "TOOLNO"
                | "TPRINT"
                | "TURRET"
        ),
        Kind::Text { word, .. } => word != "INSERT",
        _ => true,
    }
}
