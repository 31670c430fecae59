//! Messages: said once, as many as a reader can use, with the trace of their statement.

use aptc_diagnostics::{Code, Diagnostic, Origin, codes};
use smol_str::SmolStr;

use super::Post;
use crate::emit::TooGreat;

/// Messages of one program; after that many one message says that there are more.
const MOST_MESSAGES: usize = 500;

/// Most places at which the same words are told; of further ones there is a count.
const MOST_ALIKE: u64 = 3;

/// How often the same words came, and where the last that were told stand in the list of messages.
#[derive(Debug)]
pub(crate) struct Alike {
    times: u64,
    at: usize,
}

/// Something that is told at its first place, with how often it came.
#[derive(Debug)]
pub(crate) struct Counted {
    /// The same word for the same thing, whatever numbers the message has.
    what: SmolStr,
    /// Where it stands in the list of messages.
    at: usize,
    times: u64,
    /// The motion that was counted last; none where statements are counted.
    motion: Option<u64>,
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
            if known.motion.replace(motion) != Some(motion) {
                known.times += 1;
            }
            return;
        }
        let at = self.diagnostics.len();
        self.error(code, origin, message, help);
        self.count(what.into(), at, Some(motion));
    }

    /// A message that is told once for all statements that have it: `what` tells which it is.
    pub(crate) fn say_counted(
        &mut self,
        what: impl Into<SmolStr>,
        d: Diagnostic,
        origin: &Origin,
        help: &str,
    ) {
        let what = what.into();
        if let Some(known) = self.counted.iter_mut().find(|c| c.what == what) {
            known.times += 1;
            return;
        }
        let at = self.diagnostics.len();
        self.say(d, origin, help);
        self.count(what, at, None);
    }

    /// What was said at `at`, if it was not left out, is counted from now on.
    fn count(&mut self, what: SmolStr, at: usize, motion: Option<u64>) {
        if self.diagnostics.len() > at {
            self.counted.push(Counted { what, at, times: 1, motion });
        }
    }

    /// Says how often each came.
    pub(super) fn count_messages(&mut self) {
        for Alike { times, at } in std::mem::take(&mut self.alike).into_values() {
            if let (Some(more @ 1..), Some(d)) =
                (times.checked_sub(MOST_ALIKE), self.diagnostics.get_mut(at))
            {
                d.message.push_str(&format!(", and {more} times more"));
            }
        }
        for Counted { at, times, motion, .. } in self.counted.drain(..).filter(|c| c.times > 1) {
            if let Some(d) = self.diagnostics.get_mut(at) {
                d.message.push_str(&match motion {
                    Some(_) => format!(", the first of {times} positions"),
                    None => format!(", {times} times"),
                });
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
        let at = self.diagnostics.len();
        let key = (d.code.number(), d.message.clone());
        let alike = self.alike.entry(key).or_insert(Alike { times: 0, at });
        alike.times += 1;
        if alike.times > MOST_ALIKE {
            return;
        }
        alike.at = at;
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
