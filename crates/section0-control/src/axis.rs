//! A tool axis that stays as FROM or GOTO gave it, where TLAXIS before had it turn.

use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_protap::{Kind, Record, ToolAxis};

/// What TLAXIS, FROM and GOTO said of the axis so far.
#[derive(Debug, Default)]
pub(crate) struct AxisSaid {
    /// The word by which it turns along surfaces, now and in the mode before.
    turns: [Option<&'static str>; 2],
    /// The one that was ended, with the line that did it, and that was not told yet.
    ended: Option<(&'static str, u32)>,
}

impl AxisSaid {
    /// Takes the next record; the warning, where motion begins whose axis turned before.
    pub(crate) fn next(&mut self, Record { origin, kind }: &Record) -> Option<Diagnostic> {
        match kind {
            Kind::ToolAxis(axis) => {
                let [now, before] = self.turns;
                let next = if *axis == ToolAxis::Last { before } else { turning(axis) };
                (self.turns, self.ended) = ([next, now], None);
                None
            }
            Kind::From(place) | Kind::Goto(place) if place.axis.is_some() => {
                let [now, _] = self.turns;
                self.turns = [None, now];
                self.ended = now.map(|word| (word, origin.line)).or(self.ended);
                None
            }
            kind if obeys(kind) => self.ended.take().map(|ended| told(origin, ended)),
            _ => None,
        }
    }
}

/// Does a statement move the tool with the axis of TLAXIS?
fn obeys(kind: &Kind) -> bool {
    match kind {
        Kind::Go(_) | Kind::Drive(_) => true,
        Kind::Regional { word, .. } => word == "GOLOFT" || word == "GOMILL",
        _ => false,
    }
}

/// The word of TLAXIS by which the axis turns along surfaces.
fn turning(axis: &ToolAxis) -> Option<&'static str> {
    match axis {
        ToolAxis::Fixed(_) | ToolAxis::Keep | ToolAxis::Last => None,
        ToolAxis::NormPs => Some("NORMPS"),
        ToolAxis::NormDs => Some("NORMDS"),
        ToolAxis::Parallel { .. } => Some("PARLEL"),
        ToolAxis::Angle(_) => Some("ATANGL"),
        ToolAxis::PerpTo(_) => Some("PERPTO"),
    }
}

fn told(origin: &Origin, (word, line): (&str, u32)) -> Diagnostic {
    let text = format!(
        "the tool axis stays as line {line} gave it: TLAXIS/{word} before that ended there"
    );
    Diagnostic::warning(codes::AXIS_ENDED, origin.span, text).within(origin.trace.clone()).help(
        format!("write TLAXIS/{word} behind line {line}, or TLAXIS/1 where the axis is to stay"),
    )
}
