//! LOADTL, SELCTL, TOOLNO and their kin.

use std::sync::Arc;

use aptc_cldata::Arg;
use aptc_diagnostics::codes;

use crate::args::{Statement, whole};
use crate::emit::render;
use crate::post::Post;
use crate::report::ToolUse;
use crate::words::{bad_arguments, refuse};

/// `LOADTL/n[,LENGTH,l][,ADJUST|OFFSET|OSETNO,h]`, and by places `LOADTL/n,p,l[,h[,d]]`.
pub(super) fn loadtl(post: &mut Post, s: &Statement<'_>) {
    change(post, s, 0);
}

/// `LOAD/TOOL,n[,ADJUST,h]`.
pub(super) fn load(post: &mut Post, s: &Statement<'_>) {
    if s.word(0) == Some("TOOL") {
        change(post, s, 1);
    } else {
        refuse(post, s, "only tools are loaded here");
    }
}

fn change(post: &mut Post, s: &Statement<'_>, at: usize) {
    let Some(tool) = s.number(at).and_then(whole) else {
        bad_arguments(post, s, "LOADTL/n with a whole number");
        return;
    };
    if post.st.ended {
        post.after_end(&s.written(), true, s.origin);
        return;
    }
    post.start(s.origin);
    post.annotate(s.origin);
    if post.machine.program.tool_change.is_empty() {
        refuse(post, s, "the machine changes no tools");
        return;
    }
    if post.st.cutcom.is_some() {
        let message = "a tool change while radius compensation is on".to_string();
        post.error(codes::COMPENSATION, s.origin, message, "write CUTCOM/OFF before LOADTL");
        post.st.cutcom = None;
        return;
    }
    post.leave_cycle();
    let said = loaded(s, at);
    let offset = said.offset.unwrap_or(tool);
    post.st.tool_length = said.length.or(post.st.tool_length);
    if !said.left_out.is_empty() {
        let left = said.left_out.join(",");
        let message = format!("{}: {left} has no effect", s.written());
        let help = "write LENGTH,l for the length of the tool, ADJUST,h for its offset";
        post.note(codes::WORD_IGNORED, s.origin, message, help);
    }
    post.st.n_loads += 1;
    let later = post.options.tools.get(post.st.n_loads..).unwrap_or_default();
    let next = later.iter().find(|n| **n != tool).map_or(String::new(), u32::to_string);
    let comment = std::mem::take(&mut post.st.tool_comment);
    if post.just_changed(tool) {
        // CATIA names the tool at its change, and again with its compensation where the operation begins.
        if let Some(offset) = said.offset {
            post.st.offset = Some(offset);
            post.length_words();
            post.tool_use().offset = Some(offset);
            post.own_offset(tool, offset, s);
        }
        let known = &mut post.tool_use().comment;
        if known.is_empty() {
            *known = comment;
        }
        return;
    }
    post.held_over_change(tool, &s.written(), s.origin);
    let machine = Arc::clone(&post.machine);
    let (tool_text, offset_text) = (tool.to_string(), offset.to_string());
    let (tool_two, offset_two) = (format!("{tool:02}"), format!("{offset:02}"));
    let common = post.common_vars();
    let mut vars = common.list();
    vars.extend([
        ("tool", tool_text.as_str()),
        ("offset", &offset_text),
        ("tool2", &tool_two),
        ("offset2", &offset_two),
        ("next", &next),
        ("tool_comment", &comment),
    ]);
    // The blocks of a tool change are never skipped and begin on no modal state.
    let skip = std::mem::replace(&mut post.blocks.skip, false);
    post.blocks.with_tool_axis = None;
    post.leave_plane();
    post.tool_center_off();
    let line = post.blocks.lines + 1;
    post.blocks.template(&machine.program.tool_change, &vars);
    post.blocks.skip = skip;
    post.blocks.forget_after_lines();
    post.st.offset = Some(offset);
    post.length_words();
    post.st.chain = None;
    post.st.across = None;
    post.st.placed = None;
    post.st.away = machine.program.start_retracts;
    post.st.tool = Some(tool);
    post.st.changed_at = post.st.pos;
    post.own_offset(tool, offset, s);
    post.st.spindle_again = post.st.spindle.on;
    post.st.coolant_again = post.st.coolant.is_some();
    (post.st.spindle_perhaps, post.st.spindle_oriented, post.st.coolant_perhaps) =
        (false, false, false);
    let cutter = post.st.cutter.map(|c| c.values());
    if post.summary.tools.len() == 1 && post.summary.tools[0] == unused(&post.summary.tools[0]) {
        post.summary.tools.clear();
    }
    post.summary.tools.push(ToolUse {
        number: Some(tool),
        offset: Some(offset),
        cutter,
        comment,
        line,
        ..ToolUse::default()
    });
}

/// What LOADTL and its kin say of a tool besides its number.
#[derive(Debug, Default)]
pub(crate) struct Loaded {
    /// Length, in units of the CL data.
    pub(crate) length: Option<f64>,
    offset: Option<u32>,
    /// Arguments without effect, as they were written.
    left_out: Vec<String>,
}

/// The arguments behind the number of the tool, which stands at `at`.
///
/// One number alone may be a length or a place of the magazine: it is neither here.
pub(crate) fn loaded(s: &Statement<'_>, at: usize) -> Loaded {
    let mut said = Loaded::default();
    let mut args = s.args.get(at + 1..).unwrap_or_default();
    if s.word == "LOADTL" {
        match args {
            // MANUSpost has the offset of the radius behind them.
            [Arg::Number(_), Arg::Number(length), Arg::Number(offset)]
            | [Arg::Number(_), Arg::Number(length), Arg::Number(offset), Arg::Number(_)] => {
                (said.length, said.offset, args) = (Some(*length), whole(*offset), &[]);
            }
            [Arg::Number(_), Arg::Number(length)] => (said.length, args) = (Some(*length), &[]),
            _ => {}
        }
    }
    while let Some((first, rest)) = args.split_first() {
        args = rest;
        let value = match rest.first() {
            Some(Arg::Number(n)) => Some(*n),
            _ => None,
        };
        match (first, value) {
            (Arg::Word(w), Some(n)) if w == "LENGTH" => said.length = Some(n),
            (Arg::Word(w), Some(n)) if matches!(w.as_str(), "ADJUST" | "OFFSET" | "OSETNO") => {
                said.offset = whole(n);
            }
            // CATIA: they come again in statements of their own.
            (Arg::Word(w), Some(_)) if w == "SPINDL" => {}
            (Arg::Word(w), _) if matches!(w.as_str(), "MILL" | "TURN") => continue,
            (Arg::Number(n), _) => {
                said.left_out.push(crate::post::trimmed(*n, 6));
                continue;
            }
            (Arg::Word(w), _) => {
                said.left_out.push(w.to_string());
                continue;
            }
            _ => continue,
        }
        args = args.get(1..).unwrap_or_default();
    }
    said
}

impl Post {
    /// Has this tool come in and not moved since?
    fn just_changed(&self, tool: u32) -> bool {
        let idle = self
            .summary
            .tools
            .last()
            .is_some_and(|t| t.number == Some(tool) && t.minutes <= 0.0 && t.lowest.is_none());
        idle && self.st.tool == Some(tool)
            && self.st.changed_at == self.st.pos
            && self.st.away == self.machine.program.start_retracts
    }

    /// Warns when another tool has this length offset: CAM systems give each tool the number 1 if none is said.
    fn own_offset(&mut self, tool: u32, offset: u32, s: &Statement<'_>) {
        let machine = &self.machine;
        let words = [&machine.compensation.length, &machine.multiaxis.tool_center_on];
        let by_number = words.into_iter().chain(&machine.program.tool_change);
        let by_number = by_number.into_iter().any(|words| words.contains("{offset"));
        let other = |t: &ToolUse| t.offset == Some(offset) && t.number.is_some_and(|n| n != tool);
        let Some(other) = self.summary.tools.iter().find(|t| other(t)).and_then(|t| t.number)
        else {
            return;
        };
        if by_number {
            let message =
                format!("{}: length offset {offset} is that of tool {other} too", s.written());
            let help = "leave ADJUST out, so that each tool has the offset of its own number, or give each its own";
            self.warn(codes::SHARED_OFFSET, s.origin, message, help);
        }
    }

    /// The length offset comes with the next motion along Z.
    pub(crate) fn length_words(&mut self) {
        let Some(offset) = self.st.offset else { return };
        let multi = &self.machine.multiaxis;
        let with_z = multi.tool_center && multi.tool_center_with_z && self.st.plane.is_none();
        let words = if with_z { &multi.tool_center_on } else { &self.machine.compensation.length };
        self.blocks.with_tool_axis =
            render(words, &[("offset", &offset.to_string())]).filter(|w| !w.is_empty());
    }
}

/// A use in which no tool has worked: only its cutter is known.
fn unused(tool: &ToolUse) -> ToolUse {
    ToolUse { cutter: tool.cutter, comment: tool.comment.clone(), ..ToolUse::default() }
}

/// `SELCTL/n`: makes a tool ready.
pub(super) fn selctl(post: &mut Post, s: &Statement<'_>) {
    ready(post, s, s.number(0));
}

/// `SELECT/TOOL,n`.
pub(super) fn select(post: &mut Post, s: &Statement<'_>) {
    if s.word(0) == Some("TOOL") {
        if s.args.len() > 1 {
            ready(post, s, s.number(1));
        }
    } else if s.word(0) == Some("TURRET") && s.args.len() == 1 {
        // The turret turns by the tool change itself.
    } else {
        refuse(post, s, "only tools are selected here");
    }
}

fn ready(post: &mut Post, s: &Statement<'_>, tool: Option<f64>) {
    let Some(tool) = tool.and_then(whole) else {
        bad_arguments(post, s, "SELCTL/n with a whole number");
        return;
    };
    // When the order of tools is known, each tool change makes the next one ready by itself.
    if !post.options.tools.is_empty() || post.st.tool == Some(tool) {
        return;
    }
    post.start(s.origin);
    let template = post.machine.program.preselect.clone();
    if let Some(line) = render(&template, &[("next", &tool.to_string())]) {
        post.blocks.line(&line);
    }
}

/// `TPRINT/name,..`: what the operator calls the next tool.
pub(super) fn tprint(post: &mut Post, s: &Statement<'_>) {
    let name = match s.args.first() {
        Some(Arg::Word(name)) => name.as_str(),
        Some(Arg::Text(name)) => name,
        _ => return,
    };
    post.st.tool_comment = name.to_string();
}

/// `TOOLNO/n[,l]`: data of a tool; LOADTL brings it in.
pub(super) fn toolno(post: &mut Post, s: &Statement<'_>) {
    if s.has("ADJUST") {
        refuse(post, s, "the number of a length offset comes with LOADTL/n,ADJUST,h");
        return;
    }
    let length = s.after(&["LENGTH"]).or(match s.args {
        [Arg::Number(_), Arg::Number(l)] => Some(*l),
        _ => None,
    });
    if length.is_some() {
        post.st.tool_length = length;
    }
}
