//! CUTCOM: compensation in the control.

use aptc_diagnostics::{Diagnostic, codes};

use crate::args::{Statement, whole};
use crate::emit::render;
use crate::machine::{ArcPlane, Dialect, MachineKind};
use crate::post::Post;
use crate::words::{bad_arguments, refuse};

/// `CUTCOM/LEFT|RIGHT[,plane][,d]`, `ON`, `OFF`, `LENGTH|ZAXIS,n`, `LENGTH,OFF`.
pub(super) fn cutcom(post: &mut Post, s: &Statement<'_>) {
    post.start(s.origin);
    post.annotate(s.origin);
    if matches!(s.word(0), Some("LEFT" | "RIGHT")) {
        post.st.cutcom_asked = None;
    } else {
        post.no_side();
    }
    match s.word(0) {
        Some("OFF") => off(post, s),
        // HSMWorks: `CUTCOM/ON,LEFT,d`.
        Some("ON") if s.has("LEFT") != s.has("RIGHT") => {
            on(post, s, s.has("LEFT"), s.first_number().and_then(whole));
        }
        Some("ON") => match post.st.last_cutcom {
            Some((left, d)) => on(post, s, left, Some(d)),
            // Nothing was on before: ON without a side has nothing to bring back.
            // Fusion writes ON before each LEFT or RIGHT.
            None => post.st.cutcom_asked = Some(s.origin.clone()),
        },
        Some("LEFT") => on(post, s, true, s.first_number().and_then(whole)),
        Some("RIGHT") => on(post, s, false, s.first_number().and_then(whole)),
        Some("LENGTH" | "ZAXIS") => length(post, s),
        Some("ADJUST" | "NORMDS" | "NORMPS" | "ENDPT") => {
            refuse(post, s, "the machine has no such compensation");
        }
        _ => bad_arguments(post, s, "CUTCOM/LEFT,d, RIGHT,d, OFF or LENGTH,n"),
    }
}

impl Post {
    /// `CUTCOM/ON` and no side behind it.
    pub(crate) fn no_side(&mut self) {
        let Some(origin) = self.st.cutcom_asked.take() else { return };
        let message = "CUTCOM/ON has no earlier LEFT or RIGHT to bring back".to_string();
        let help = "write CUTCOM/LEFT,d or CUTCOM/RIGHT,d";
        self.warn(codes::COMPENSATION, &origin, message, help);
    }
}

fn on(post: &mut Post, s: &Statement<'_>, left: bool, d: Option<u32>) {
    let comp = post.machine.compensation.clone();
    let template = if left { &comp.left } else { &comp.right };
    if template.is_empty() {
        refuse(post, s, "the control has no radius compensation");
        return;
    }
    let planes = ["XYPLAN", "ZXPLAN", "YZPLAN"];
    // What stands before the number of the offset says nothing more.
    let of_offset = ["OSETNO", "OFFSET", "ADJUST"];
    let side = if s.word(0) == Some("ON") { 2 } else { 1 };
    let other = (side..s.args.len())
        .filter_map(|i| s.word(i))
        .find(|w| !planes.contains(w) && !of_offset.contains(w));
    if let Some(other) = other {
        refuse(
            post,
            s,
            &format!("{other} is not known here; only the plane and the number of the offset"),
        );
        return;
    }
    if post.machine.dialect == Dialect::Heidenhain && (s.has("ZXPLAN") || s.has("YZPLAN")) {
        refuse(post, s, "the control compensates across the tool axis only");
        return;
    }
    if post.machine.kind == MachineKind::Lathe {
        // The control knows the one plane alone, however the part is drawn.
        post.blocks.select_plane(ArcPlane::Zx);
    } else {
        select_plane(post, s);
    }
    let of_tool = post.st.offset.or(post.st.tool);
    if let (Some(d), Some(own)) = (d, of_tool)
        && d != own
        && !template.contains("{offset}")
    {
        let reason = format!("the control takes the offset of the tool, {own}");
        refuse(post, s, &reason);
        return;
    }
    let Some(d) = d.or(of_tool) else {
        let message = format!("{} names no offset, and no tool is loaded to take its", s.written());
        let help = "write CUTCOM/LEFT,d or CUTCOM/RIGHT,d, or LOADTL before it";
        post.error(codes::POST_ARGUMENTS, s.origin, message, help);
        return;
    };
    if post.machine.is_milling() || !post.along_tool(post.st.ta) {
        let message = format!("{} while the tool leans in the frame of the axes", s.written());
        let help = "compensate in Section 2 with THICK, or choose a machine that turns the part";
        let d = Diagnostic::error(codes::COMPENSATION, s.origin.span, message);
        post.say_counted("CUTCOM leans", d, s.origin, help);
        return;
    }
    post.leave_cycle();
    let text = d.to_string();
    let vars = [("offset", text.as_str())];
    if !post.st.wear_defined.contains(&d) {
        if post.st.wear_defined.len() < 1000 {
            post.st.wear_defined.push(d);
        }
        if let Some(note) = render(&comp.wear_note, &vars) {
            if post.summary.notes.len() < 100 && !note.is_empty() {
                post.summary.notes.push(note.clone());
            }
            post.blocks.comment(&note);
        }
        if let Some(line) = render(&comp.wear_define, &vars) {
            post.blocks.line(&line);
        }
        let message = format!(
            "{}: the path is offset by the cutter already, so offset {d} holds wear only, 0 for a new tool",
            s.written()
        );
        post.note(codes::WEAR_ONLY, s.origin, message, "");
    }
    post.blocks.with_motion = render(template, &vars);
    post.st.cutcom = Some((left, d));
    post.st.cutcom_since = post.n_motions;
    post.st.last_cutcom = post.st.cutcom;
}

/// The plane that is named, else that across the tool.
fn select_plane(post: &mut Post, s: &Statement<'_>) {
    let named = ["XYPLAN", "ZXPLAN", "YZPLAN"].iter().any(|w| s.has(w));
    if !named && post.machine.arcs.is_some() {
        post.blocks.select_plane(ArcPlane::Xy);
    }
    for (word, plane) in
        [("XYPLAN", ArcPlane::Xy), ("ZXPLAN", ArcPlane::Zx), ("YZPLAN", ArcPlane::Yz)]
    {
        if s.has(word) {
            post.blocks.select_plane(plane);
        }
    }
}

fn off(post: &mut Post, s: &Statement<'_>) {
    let was = post.st.cutcom.take().is_some();
    let begun = post.blocks.with_motion.take().is_none();
    if was && begun {
        let words = post.machine.compensation.off.clone();
        if post.machine.compensation.off_with_motion {
            post.blocks.with_motion = Some(words);
        } else {
            post.blocks.line(&words);
        }
    } else if was && post.st.cutcom_since == post.n_motions {
        // Motions that were refused are told of themselves.
        let message = "compensation ends before any motion".to_string();
        let d = Diagnostic::warning(codes::COMPENSATION, s.origin.span, message);
        post.say_counted("CUTCOM idle", d, s.origin, "remove CUTCOM or move between");
    }
}

fn length(post: &mut Post, s: &Statement<'_>) {
    let comp = post.machine.compensation.clone();
    if s.has("OFF") {
        // The offset ends where it is safe: retracted, by the end or the next tool change. Ended here, the
        // next motion would dive by the length of the tool.
        let message = format!("{}: the length offset ends when the tool is retracted", s.written());
        post.note(codes::WORD_IGNORED, s.origin, message, "");
        return;
    }
    let Some(n) = s.first_number().and_then(whole) else {
        bad_arguments(post, s, "CUTCOM/LENGTH,n with the number of the offset");
        return;
    };
    let Some(words) = render(&comp.length, &[("offset", &n.to_string())]).filter(|w| !w.is_empty())
    else {
        refuse(post, s, "the control has no length offsets");
        return;
    };
    post.st.offset = Some(n);
    if post.blocks.known_axis(2).is_some() {
        post.leave_cycle();
        post.blocks.line(&words);
        // With a new offset the same Z is another place.
        post.blocks.forget_axis(2);
    } else {
        post.blocks.with_tool_axis = Some(words);
    }
}
