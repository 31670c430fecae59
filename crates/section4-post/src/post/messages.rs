//! Messages: said once, as many as a reader can use, with the trace of their statement.

use aptc_diagnostics::{Code, Diagnostic, Origin, codes};

use super::Post;
use crate::emit::TooGreat;

/// Messages of one program; after that many one message says that there are more.
const MOST_MESSAGES: usize = 500;

impl Post {
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
