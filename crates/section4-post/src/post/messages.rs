//! Messages: said once, as many as a reader can use, with the trace of their statement.

use aptc_diagnostics::{Code, Diagnostic, Origin, codes};

use super::Post;
use crate::emit::TooGreat;

/// Messages of one program; after that many one message says that there are more.
const MOST_MESSAGES: usize = 500;

/// Something that is told at its first place, with how often it came.
#[derive(Debug)]
pub(crate) struct Counted {
    /// The same word for the same thing, whatever numbers the message has.
    what: &'static str,
    /// Where it stands in the list of messages.
    at: usize,
    times: u64,
    /// The motion that was counted last.
    motion: u64,
}

impl Post {
    /// An error that is told once for all motions that have it: `what` tells which it is.
    pub(crate) fn error_counted(
        &mut self,
        code: Code,
        what: &'static str,
        origin: &Origin,
        message: String,
        help: &str,
    ) {
        let motion = self.n_motions;
        if let Some(known) = self.counted.iter_mut().find(|c| c.what == what) {
            if std::mem::replace(&mut known.motion, motion) != motion {
                known.times += 1;
            }
            return;
        }
        let at = self.diagnostics.len();
        self.error(code, origin, message, help);
        if self.diagnostics.len() > at {
            self.counted.push(Counted { what, at, times: 1, motion });
        }
    }

    /// Says how often each came.
    pub(super) fn count_messages(&mut self) {
        for Counted { at, times, .. } in self.counted.drain(..).filter(|c| c.times > 1) {
            if let Some(d) = self.diagnostics.get_mut(at) {
                d.message = format!("{}, the first of {times} positions", d.message);
            }
        }
    }

    pub(crate) fn error(&mut self, code: Code, origin: &Origin, message: String, help: &str) {
        self.say(Diagnostic::error(code, origin.span, message), origin, help);
    }

    pub(crate) fn warn(&mut self, code: Code, origin: &Origin, message: String, help: &str) {
        self.say(Diagnostic::warning(code, origin.span, message), origin, help);
    }

    pub(crate) fn note(&mut self, code: Code, origin: &Origin, message: String, help: &str) {
        self.say(Diagnostic::note_at(code, origin.span, message), origin, help);
    }

    fn say(&mut self, mut d: Diagnostic, origin: &Origin, help: &str) {
        // A statement in a loop would say the same at each pass.
        let same = |o: &Diagnostic| o.code == d.code && o.span == d.span && o.message == d.message;
        if self.diagnostics.iter().rev().take(64).any(same) {
            return;
        }
        if self.diagnostics.len() >= MOST_MESSAGES && (!d.is_error() || self.refused()) {
            if self.diagnostics.len() == MOST_MESSAGES {
                let message = format!("more than {MOST_MESSAGES} messages; the rest is left out");
                self.diagnostics.push(Diagnostic::note_at(
                    codes::MORE_MESSAGES,
                    origin.span,
                    message,
                ));
            }
            return;
        }
        if !help.is_empty() {
            d = d.help(help);
        }
        self.diagnostics.push(d.within(origin.trace.clone()));
    }

    pub(crate) fn too_great(&mut self, origin: &Origin, e: TooGreat) {
        let message = format!("{}{:e} is too great a number for a block", e.letter, e.value);
        let help = "check the unit and the position of this statement";
        self.error(codes::TOO_GREAT, origin, message, help);
    }
}
