//! The order of tools, known before the first block.

use aptc_cldata::{Arg, Kind, Record};

use crate::args::whole;

/// The tools of LOADTL in order, for `PostOptions::tools`.
#[derive(Clone, Debug, Default)]
pub struct ToolScan {
    tools: Vec<u32>,
}

impl ToolScan {
    /// Looks at one record.
    pub fn push(&mut self, record: &Record) {
        if let Kind::Post { word, args } = &record.kind
            && let Some(tool) = loaded_tool(word, args)
        {
            self.tools.push(tool);
        }
    }

    /// The tools.
    pub fn finish(self) -> Vec<u32> {
        self.tools
    }
}

/// The tool that LOADTL, LOAD/TOOL or TURRET brings in.
fn loaded_tool(word: &str, args: &[Arg]) -> Option<u32> {
    let n = match (word, args) {
        ("LOADTL" | "TURRET", [Arg::Number(n), ..]) => *n,
        ("LOAD", [Arg::Word(w), Arg::Number(n), ..]) if w == "TOOL" => *n,
        _ => return None,
    };
    whole(n)
}
