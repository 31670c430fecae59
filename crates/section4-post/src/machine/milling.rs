//! Milling on a lathe: its spindle as a rotary axis, and tools that turn.

use serde::{Deserialize, Serialize};

use super::{Machine, MachineKind, Multiaxis, Rotary, Spindle};

/// What MODE/MILL makes of a lathe.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Milling {
    /// Lines of MODE/MILL, after the tool has been retracted and the spindle stopped: the spindle becomes an axis.
    #[serde(default)]
    pub on: Vec<String>,
    /// Lines of MODE/TURN: it turns again.
    #[serde(default)]
    pub off: Vec<String>,
    /// The spindle of the tools.
    #[serde(default)]
    pub spindle: Spindle,
    /// The spindle of the part as an axis, along Z of the machine.
    pub rotary: Rotary,
    /// How motion with this axis is done.
    #[serde(default)]
    pub multiaxis: Multiaxis,
}

impl Machine {
    /// The lathe while it mills; `None` where it does not.
    pub(crate) fn while_milling(&self) -> Option<Self> {
        let milling = self.milling.as_ref()?;
        let mut machine = self.clone();
        machine.rotary = vec![milling.rotary.clone()];
        machine.spindle = milling.spindle.clone();
        machine.multiaxis = milling.multiaxis.clone();
        // Without a linear Y no circle of the part is one of the axes. Feeds a turn are those of the other spindle.
        machine.arcs = None;
        machine.cycles.clear();
        machine.feed.per_revolution.clear();
        machine.turning.thread.clear();
        Some(machine)
    }

    /// Is it a lathe that mills?
    pub(crate) fn is_milling(&self) -> bool {
        self.kind == MachineKind::Lathe && !self.rotary.is_empty()
    }
}
