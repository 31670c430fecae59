//! COOLNT.

use aptc_diagnostics::codes;

use crate::args::Statement;
use crate::post::Post;
use crate::words::{bad_arguments, refuse};

/// `COOLNT/ON|OFF|FLOOD|MIST|TAPKUL|THRU|AIR[,LOW|MEDIUM|HIGH]`. ON brings back the last kind.
pub(super) fn coolnt(post: &mut Post, s: &Statement<'_>) {
    let Some(kind) = s.word(0) else {
        if s.args.is_empty() {
            switch(post, s, "ON");
        } else {
            bad_arguments(post, s, "COOLNT/ON, OFF, FLOOD, MIST or TAPKUL");
        }
        return;
    };
    if s.args.len() > 1 {
        let message = format!("{}: the machine has no choice of pressures", s.written());
        post.note(codes::WORD_IGNORED, s.origin, message, "");
    }
    switch(post, s, if kind == "TAP" { "TAPKUL" } else { kind });
}

/// `AIR/ON|OFF`.
pub(super) fn air(post: &mut Post, s: &Statement<'_>) {
    switch(post, s, if s.has("OFF") { "OFF" } else { "AIR" });
}

fn switch(post: &mut Post, s: &Statement<'_>, kind: &str) {
    post.start(s.origin);
    if kind == "OFF" {
        post.annotate(s.origin);
        (post.st.coolant_again, post.st.coolant_perhaps) = (false, false);
        post.st.held.retain(|h| h.spindle);
        if let Some(off) = post.machine.coolant.get("OFF").cloned() {
            if post.st.coolant.take().is_some() {
                post.blocks.line(&off);
            }
        } else {
            refuse(post, s, "the machine has no coolant");
        }
        return;
    }
    let wanted = match kind {
        "ON" => post.st.last_coolant.clone().unwrap_or_else(|| "ON".into()),
        _ => kind.to_string(),
    };
    let Some(code) = post.machine.coolant.get(&wanted).cloned() else {
        refuse(post, s, &format!("the machine has no coolant {wanted}"));
        return;
    };
    let stands = post.st.coolant_again || post.st.coolant_perhaps;
    if post.st.coolant.as_deref() != Some(wanted.as_str()) || stands {
        // From one kind to another the first is switched off, or both would run.
        let other =
            post.st.coolant.as_deref().and_then(|k| post.machine.coolant.get(k)) != Some(&code);
        if post.st.coolant.is_some()
            && other
            && !post.st.coolant_again
            && let Some(off) = post.machine.coolant.get("OFF").cloned()
        {
            post.annotate(s.origin);
            post.blocks.line(&off);
        }
        post.hold(false, s.written(), s.origin);
    }
    (post.st.coolant_again, post.st.coolant_perhaps) = (false, false);
    post.st.coolant = Some(wanted.clone());
    if wanted != "ON" {
        post.st.last_coolant = Some(wanted);
    }
}

impl Post {
    /// Spindle and coolant that a tool change has stopped, or a program stop perhaps, run again.
    pub(crate) fn run_again(&mut self) {
        let st = &mut self.st;
        let spindle =
            std::mem::take(&mut st.spindle_again) | std::mem::take(&mut st.spindle_perhaps);
        let coolant =
            std::mem::take(&mut st.coolant_again) | std::mem::take(&mut st.coolant_perhaps);
        if spindle && self.st.spindle.on {
            self.spindle_on();
        }
        if coolant {
            self.coolant_on();
        }
    }

    /// Writes the coolant as it is to run.
    pub(crate) fn coolant_on(&mut self) {
        if let Some(code) =
            self.st.coolant.as_ref().and_then(|k| self.machine.coolant.get(k)).cloned()
        {
            self.blocks.line(&code);
        }
    }
}
