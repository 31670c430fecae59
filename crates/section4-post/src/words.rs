//! Post-processor words: one table says what becomes of each.

use aptc_diagnostics::{Origin, codes};

use crate::args::Statement;
use crate::post::Post;

mod coolnt;
mod cutcom;
pub(crate) mod cycle;
mod fedrat;
pub(crate) mod planes;
mod program;
mod spindl;
mod table;
mod tool;

pub use table::{Treatment, treatment};

/// What is done for a word.
type Action = fn(&mut Post, &Statement<'_>);

/// A post-processor statement.
pub(crate) fn post_word(post: &mut Post, s: &Statement<'_>) {
    match table::action(s.word) {
        Some(table::Entry::Do(action)) => action(post, s),
        Some(table::Entry::Ignore(reason)) => {
            let message = format!("{} is left out: {reason}", s.word);
            post.note(codes::WORD_IGNORED, s.origin, message, "");
        }
        Some(table::Entry::Silent(_)) => {}
        Some(table::Entry::Refuse(reason)) => refuse(post, s, reason),
        None => {
            let message = format!("{} is not known to the post-processor and is left out", s.word);
            post.warn(codes::WORD_UNKNOWN, s.origin, message, "check the spelling, or remove it");
        }
    }
}

/// The machine lacks what the statement asks for.
pub(crate) fn refuse(post: &mut Post, s: &Statement<'_>, reason: &str) {
    let message = format!("{}: {reason}", s.written());
    let help = "remove the statement, or choose a machine that has it";
    post.error(codes::WORD_LACKING, s.origin, message, help);
}

/// The arguments are none that the word has.
pub(crate) fn bad_arguments(post: &mut Post, s: &Statement<'_>, forms: &str) {
    let message = format!("{} has no meaning", s.written());
    post.error(codes::POST_ARGUMENTS, s.origin, message, &format!("write {forms}"));
}

/// PARTNO, PPRINT, INSERT and other texts.
pub(crate) fn text(post: &mut Post, word: &str, text: &str, origin: &Origin) {
    match word {
        "PARTNO" => {
            if post.st.started {
                post.comment(text, origin);
            } else {
                post.st.partno = text.trim().to_string();
            }
        }
        "INSERT" => program::insert(post, text, origin),
        "PPRINT" | "DISPLY" | "TITLES" => {
            if word == "PPRINT" && !post.st.ready_said && post.summary.notes.len() < 100 {
                post.summary.notes.push(text.trim().to_string());
            }
            if word != "TITLES" {
                post.comment(text, origin);
            }
        }
        // REMARK and the like speak to the reader of the part program.
        _ => {}
    }
}
