//! Where a record came from: statement, line, and the macros and loops around it.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use smol_str::SmolStr;

use crate::Span;

/// Origin of a record, carried from the statement to the G-code block.
#[derive(Clone, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Origin {
    /// The statement's text.
    pub span: Span,
    /// Statement number as APT counts it: every card but continuations (ISN).
    pub isn: u32,
    /// Line of the statement in its file, from 1; 0 when unknown.
    pub line: u32,
    /// Name of the file when it is not the main part program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<Arc<str>>,
    /// Macro calls, loops and includes around the statement, innermost first.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "list")]
    pub trace: Trace,
}

/// The chain of expansions around a statement; shared, so that an origin is cheap to copy.
pub type Trace = Option<Arc<Frame>>;

/// One expansion.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Frame {
    /// What was expanded.
    pub kind: FrameKind,
    /// Name of the macro, loop label or file.
    pub name: SmolStr,
    /// Where the call or loop stands.
    pub span: Span,
    /// Line of the call.
    pub line: u32,
    /// Which pass of a loop, from 2; 0 for what is no loop.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub pass: u32,
    /// The expansion around this one. Written as the next in the list of an [`Origin`].
    #[serde(skip)]
    pub outer: Trace,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands over a reference")]
fn is_zero(pass: &u32) -> bool {
    *pass == 0
}

/// Kind of expansion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FrameKind {
    /// CALL of a macro.
    Macro,
    /// A further pass of a loop.
    Loop,
    /// READ or INCLUD of a file.
    Include,
}

/// A trace as a list, so that its length is no depth of nesting.
mod list {
    use std::sync::Arc;

    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use super::{Frame, Trace};

    pub(super) fn serialize<S: Serializer>(
        trace: &Trace,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        let frames = std::iter::successors(trace.as_deref(), |f| f.outer.as_deref());
        frames.collect::<Vec<&Frame>>().serialize(serializer)
    }

    pub(super) fn deserialize<'d, D: Deserializer<'d>>(deserializer: D) -> Result<Trace, D::Error> {
        let frames = Vec::<Frame>::deserialize(deserializer)?;
        let around = |outer, mut frame: Frame| {
            frame.outer = outer;
            Some(Arc::new(frame))
        };
        Ok(frames.into_iter().rev().fold(None, around))
    }
}

impl Origin {
    /// The frames around, innermost first.
    pub fn frames(&self) -> impl Iterator<Item = &Frame> {
        std::iter::successors(self.trace.as_deref(), |f| f.outer.as_deref())
    }
}

/// Frees a long chain without recursion, so that its length cannot exhaust the stack.
impl Drop for Frame {
    fn drop(&mut self) {
        let mut next = self.outer.take();
        while let Some(frame) = next {
            match Arc::try_unwrap(frame) {
                Ok(mut f) => next = f.outer.take(),
                Err(_) => break,
            }
        }
    }
}
