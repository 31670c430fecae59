//! Words about the program itself: STOP, SEQNO, INSERT, PREFUN, ORIGIN ...

use aptc_cldata::Arg;
use aptc_diagnostics::{Origin, codes};
use aptc_geometry::Vec3;

use crate::args::{Statement, whole};
use crate::emit::render;
use crate::machine::{Dialect, MachineKind};
use crate::post::{Post, trimmed};
use crate::words::{bad_arguments, refuse};

/// `STOP`.
pub(super) fn stop(post: &mut Post, s: &Statement<'_>) {
    let line = post.machine.program.stop.clone();
    one(post, s, &line);
}

/// `OPSTOP`.
pub(super) fn opstop(post: &mut Post, s: &Statement<'_>) {
    let line = post.machine.program.optional_stop.clone();
    one(post, s, &line);
}

fn one(post: &mut Post, s: &Statement<'_>, line: &str) {
    if line.is_empty() {
        refuse(post, s, "the control has no code for it");
        return;
    }
    post.start(s.origin);
    post.annotate(s.origin);
    post.blocks.line(line);
    // Controls are told to stop spindle and coolant for it and to leave them so when the operator goes on; no manual of
    // the controls here was at hand for it. Where both run still, starting them again changes nothing.
    post.st.spindle_perhaps |= post.st.spindle.on && !post.st.spindle_oriented;
    post.st.coolant_perhaps |= post.st.coolant.is_some();
}

/// `CALSUB/n` that nothing has carried out: there is no such subprogram before it.
pub(super) fn calsub(post: &mut Post, s: &Statement<'_>) {
    let message = format!(
        "{}: no DEFSUB before it has that name, so that its motions are missing",
        s.written()
    );
    let help = "put DEFSUB/n .. ENDSUB before the first call";
    post.error(codes::SUBPROGRAM, s.origin, message, help);
}

/// `END`.
pub(super) fn end(post: &mut Post, s: &Statement<'_>) {
    post.end_of_program(s.origin);
}

/// `REWIND`: the end of the program does it.
pub(super) fn rewind(post: &mut Post, s: &Statement<'_>) {
    let message = "REWIND is left out: the end of the program goes back to its start".to_string();
    post.note(codes::WORD_IGNORED, s.origin, message, "");
}

/// `DELAY/t[,REV]`, `DELAY/REV,n`, `DELAY/DWELL,t`.
pub(super) fn delay(post: &mut Post, s: &Statement<'_>) {
    let Some(t) = s.first_number().filter(|t| *t >= 0.0 && *t < 1e6) else {
        bad_arguments(post, s, "DELAY/t with t in seconds, or DELAY/REV,n");
        return;
    };
    post.start(s.origin);
    post.annotate(s.origin);
    let seconds = if s.has("REV") {
        let speed = post.revolutions_here().filter(|_| post.st.spindle.on);
        let Some(speed) = speed.filter(|rpm| *rpm > 0.0) else {
            let message = format!("{}: the spindle speed is not known", s.written());
            post.error(codes::POST_ARGUMENTS, s.origin, message, "write SPINDL/n before it");
            return;
        };
        t * 60.0 / speed
    } else {
        t
    };
    post.blocks.end_cycle();
    post.dwell(seconds);
}

impl Post {
    /// Waits.
    pub(crate) fn dwell(&mut self, seconds: f64) {
        let (s, ms) = (trimmed(seconds, 3), trimmed(seconds * 1000.0, 0));
        let vars = [("seconds", s.as_str()), ("milliseconds", &ms)];
        if let Some(line) = render(&self.machine.program.dwell, &vars) {
            self.blocks.line(&line);
        }
        self.summary.cut_minutes += seconds / 60.0;
        self.tool_use().minutes += seconds / 60.0;
    }
}

/// `OFSTNO/FIXTUR,n` of NX, `MCSYS/NUM,n` of DMG: the number of the zero, 1 for the first.
pub(super) fn ofstno(post: &mut Post, s: &Statement<'_>) {
    if s.first_number().is_some_and(|n| n <= 1.0) {
        let message = format!("{} is left out: the machine file has the first zero", s.written());
        post.note(codes::WORD_IGNORED, s.origin, message, "");
    } else {
        refuse(post, s, "there is one zero; post what stands at each zero by itself");
    }
}

/// `CHANNEL,n`: the program of the first channel is the only one.
pub(super) fn channel(post: &mut Post, s: &Statement<'_>) {
    match s.number(0).and_then(whole) {
        Some(0 | 1) => {
            let message = "CHANNEL is left out: the machines here have one channel".to_string();
            post.note(codes::WORD_IGNORED, s.origin, message, "");
        }
        Some(_) => refuse(post, s, "the machines here have one channel; post the other by itself"),
        None => bad_arguments(post, s, "CHANNEL,n with a whole number"),
    }
}

/// `MODE/MILL|TURN|LATHE`: must be what the machine is, or what a lathe with tools that turn can be.
pub(super) fn mode(post: &mut Post, s: &Statement<'_>) {
    let wanted = match s.word(0) {
        Some("MILL") if s.args.len() == 1 => MachineKind::Mill,
        Some("TURN" | "LATHE") if s.args.len() == 1 => MachineKind::Lathe,
        _ => {
            refuse(post, s, "only MODE/MILL and MODE/TURN are known");
            return;
        }
    };
    if post.lathe.milling.is_some() {
        post.set_milling(wanted == MachineKind::Mill, s.origin);
        return;
    }
    if wanted != post.machine.kind {
        let is = if wanted == MachineKind::Mill { "a lathe" } else { "a mill" };
        let reason = format!("{} is {is}", post.machine.name);
        refuse(post, s, &reason);
    }
}

/// `OPSKIP/ON|OFF`, the same as `DELETE/ON|OFF`.
pub(super) fn opskip(post: &mut Post, s: &Statement<'_>) {
    if post.machine.program.skip.is_empty() {
        refuse(post, s, "the control skips no blocks");
        return;
    }
    match s.word(0) {
        Some("ON" | "OFF") if s.args.len() > 1 => {
            refuse(post, s, "there is one switch for blocks that are skipped");
        }
        Some("ON") => {
            post.start(s.origin);
            post.leave_cycle();
            post.blocks.skip = true;
        }
        Some("OFF") => {
            post.leave_cycle();
            // What was skipped the control may not know.
            if std::mem::take(&mut post.blocks.skip) {
                post.blocks.forget();
            }
        }
        _ => bad_arguments(post, s, "OPSKIP/ON or OPSKIP/OFF"),
    }
}

/// `SEQNO/n[,INCR,i]`, `SEQNO/ON|OFF`.
pub(super) fn seqno(post: &mut Post, s: &Statement<'_>) {
    match s.word(0) {
        Some("OFF") => post.blocks.numbered = false,
        Some("ON") => post.blocks.numbered = true,
        _ => {
            let Some(n) = s.number(0).and_then(whole) else {
                bad_arguments(post, s, "SEQNO/n, SEQNO/n,INCR,i, SEQNO/ON or SEQNO/OFF");
                return;
            };
            if s.args.len() > 3 {
                let message = format!("{}: every block is numbered", s.written());
                post.note(codes::WORD_IGNORED, s.origin, message, "");
            }
            post.blocks.next_number = n;
            if let Some(step) = s.after(&["INCR"]).and_then(whole).filter(|i| *i > 0) {
                post.blocks.number_step = step;
            }
            post.blocks.numbered = true;
        }
    }
}

/// `PREFUN/n`: a G word of its own.
pub(super) fn prefun(post: &mut Post, s: &Statement<'_>) {
    if post.machine.dialect == Dialect::Heidenhain {
        refuse(post, s, "the control has no G words");
        return;
    }
    function(post, s, 'G');
}

/// `AUXFUN/n`: an M word of its own.
pub(super) fn auxfun(post: &mut Post, s: &Statement<'_>) {
    function(post, s, 'M');
}

fn function(post: &mut Post, s: &Statement<'_>, letter: char) {
    let Some(n) = s.number(0).filter(|n| (0.0..1000.0).contains(n)) else {
        bad_arguments(post, s, "the number of the function");
        return;
    };
    if letter == 'M' && matches!(whole(n), Some(2 | 30)) {
        post.end_of_program(s.origin);
        return;
    }
    post.start(s.origin);
    post.annotate(s.origin);
    post.blocks.line(&format!("{letter}{}", trimmed(n, 1)));
    if letter == 'G' {
        // It may have changed any mode.
        post.blocks.forget();
    }
}

/// `INSERT` as a word with text arguments.
pub(super) fn insert_word(post: &mut Post, s: &Statement<'_>) {
    insert(post, &joined(s), s.origin);
}

/// `PPRINT` as a word with text arguments.
pub(super) fn pprint(post: &mut Post, s: &Statement<'_>) {
    super::text(post, "PPRINT", &joined(s), s.origin);
}

/// `PARTNO` as a word with text arguments.
pub(super) fn partno(post: &mut Post, s: &Statement<'_>) {
    super::text(post, "PARTNO", &joined(s), s.origin);
}

/// `DISPLY/text`; `ON` and `OFF` are for the screen of a CAM system.
pub(super) fn disply(post: &mut Post, s: &Statement<'_>) {
    let text = joined(s);
    if matches!(s.args.first(), Some(Arg::Text(_))) && !text.is_empty() {
        post.comment(&text, s.origin);
    }
}

fn joined(s: &Statement<'_>) -> String {
    let mut text = String::new();
    for (i, arg) in s.args.iter().enumerate() {
        if i > 0 {
            text.push(',');
        }
        match arg {
            Arg::Text(t) => text.push_str(t),
            Arg::Word(w) => text.push_str(w),
            Arg::Number(n) => text.push_str(&trimmed(*n, 6)),
            Arg::Form { name, .. } => text.push_str(&name.name),
        }
    }
    text
}

/// INSERT: a block of the control's own, word for word. Text from `$$` on is a remark of the part program.
pub(super) fn insert(post: &mut Post, text: &str, origin: &Origin) {
    let text = text.split("$$").next().unwrap_or("").trim();
    if text.is_empty() {
        return;
    }
    let p = &post.machine.program;
    if !p.comment_open.is_empty()
        && let Some(comment) = text.strip_prefix(p.comment_open.as_str())
        && let Some(comment) = comment.strip_suffix(p.comment_close.as_str())
    {
        let comment = comment.to_string();
        post.comment(&comment, origin);
        return;
    }
    if !reads_as_block(text) {
        let shown: String = text.chars().take(40).collect();
        let message = format!("INSERT {shown}: this is no block and becomes a comment");
        post.warn(codes::INSERT_NO_BLOCK, origin, message, "write PPRINT for a comment");
        post.comment(text, origin);
        return;
    }
    post.start(origin);
    post.annotate(origin);
    post.leave_cycle();
    post.blocks.line(text);
    // It may have changed any mode and any position.
    post.blocks.forget();
}

/// Letters with numbers, each after the other, and comments: all that a block is made of.
fn reads_as_block(text: &str) -> bool {
    let bytes = text.as_bytes();
    let mut i = 0;
    let mut any = false;
    while i < bytes.len() {
        match bytes[i] {
            b' ' | b'\t' | b'/' | b'%' => i += 1,
            b'(' => match text[i..].find(')') {
                Some(n) => i += n + 1,
                None => return false,
            },
            b';' => return any,
            c if c.is_ascii_alphabetic() => {
                let start = i + 1;
                i = start;
                while i < bytes.len() && matches!(bytes[i], b'0'..=b'9' | b'.' | b'-' | b'+') {
                    i += 1;
                }
                if text[start..i].parse::<f64>().is_err() {
                    return false;
                }
                any = true;
            }
            _ => return false,
        }
    }
    any
}

/// `TRANS/x,y,z`: added to every position.
pub(super) fn trans(post: &mut Post, s: &Statement<'_>) {
    shift(post, s, 1.0);
}

/// `ORIGIN/x,y,z`: the machine's zero in the frame of the part, so taken from every position.
pub(super) fn origin(post: &mut Post, s: &Statement<'_>) {
    shift(post, s, -1.0);
}

fn shift(post: &mut Post, s: &Statement<'_>, sign: f64) {
    let mut v = [0.0; 3];
    let plain = s.args.len() <= 3 && !s.args.is_empty();
    let all = s.args.iter().zip(&mut v).all(|(arg, slot)| match arg {
        Arg::Number(n) => {
            *slot = *n;
            true
        }
        _ => false,
    });
    if !plain || !all {
        bad_arguments(post, s, "three numbers: x,y,z");
        return;
    }
    let new = Vec3::new(v[0], v[1], v[2]) * (sign * post.st.units.mm());
    // The tool has not moved: only later positions are shifted.
    post.st.shift_mm = new;
    post.st.rescale();
}

/// `LINTOL/t`; `ON` brings back the tolerance of the machine.
pub(super) fn lintol(post: &mut Post, s: &Statement<'_>) {
    match (s.args.len(), s.number(0), s.word(0)) {
        (1, Some(t), _) if t > 0.0 && t.is_finite() => {
            post.st.lintol_mm = Some(t * post.st.units.mm());
        }
        (1, _, Some("ON")) => post.st.lintol_mm = None,
        (1, _, Some("OFF")) if post.machine.rotary.is_empty() => {
            let message = format!("{} is left out: no axis turns", s.written());
            post.note(codes::WORD_IGNORED, s.origin, message, "");
        }
        (_, _, Some("OFF" | "LINEAR" | "AXIS" | "RAPID" | "ADJUST")) => {
            refuse(
                post,
                s,
                "the tool end is always kept on its line to a tolerance; give it with LINTOL/t",
            );
        }
        _ => bad_arguments(post, s, "LINTOL/t with a positive tolerance, or ON"),
    }
}

/// `MCHTOL/t`: how far the control may leave the path to keep its speed.
pub(super) fn mchtol(post: &mut Post, s: &Statement<'_>) {
    let Some(t) = s.number(0).filter(|t| *t > 0.0) else {
        bad_arguments(post, s, "MCHTOL/t with a positive tolerance");
        return;
    };
    if post.machine.program.path_mode.is_empty() {
        let message =
            format!("{}: {} has no tolerance of the path", s.written(), post.machine.name);
        post.note(codes::WORD_IGNORED, s.origin, message, "");
        return;
    }
    post.st.path_tolerance_mm = Some(t * post.st.units.mm());
    if post.st.started {
        let line = post.common_vars().path_mode;
        post.blocks.line(&line);
    }
}
