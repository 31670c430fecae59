//! Post-processor words: one table says what becomes of each.

use aptc_cldata::Arg;
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_vocabulary::find;

use crate::args::Statement;
use crate::post::Post;

pub(crate) mod arcslp;
mod coolnt;
mod cutcom;
pub(crate) mod cycle;
mod fedrat;
pub(crate) mod planes;
mod program;
mod rotabl;
mod spindl;
mod stock;
mod table;
mod thread;
mod tool;

pub use table::{Treatment, treatment};
pub(crate) use tool::loaded;

/// What is done for a word.
type Action = fn(&mut Post, &Statement<'_>);

/// A post-processor statement.
pub(crate) fn post_word(post: &mut Post, s: &Statement<'_>) {
    match table::action(s.word) {
        Some(table::Entry::Do(action)) => {
            let before = post.diagnostics.len();
            action(post, s);
            let said = post.diagnostics.get_mut(before..).unwrap_or_default();
            if said.iter().any(Diagnostic::is_error) {
                said.iter_mut().for_each(|d| d.notes.extend(names_for_words(s)));
                // What is missing because of it is no mistake of its own.
                post.st.refused_words.insert(s.word.into());
            }
        }
        Some(table::Entry::Ignore(reason)) => {
            let message = format!("{} is left out: {reason}", s.word);
            post.note(codes::WORD_IGNORED, s.origin, message, "");
        }
        Some(table::Entry::Silent(_)) => {}
        Some(table::Entry::Refuse(reason)) => refuse(post, s, reason),
        None => {
            let message = format!("{} is not known to the post-processor and is left out", s.word);
            let d = Diagnostic::warning(codes::WORD_UNKNOWN, s.origin.span, message);
            post.say_counted(s.word, d, s.origin, "check the spelling, or remove it");
            // It may be any of those that the first cut wants, misspelt.
            post.st.refused_words.extend(["SPINDL", "LOADTL", "COOLNT"].map(Into::into));
        }
    }
}

/// A word of the language that the program has given to a form does not stand for itself.
fn names_for_words(s: &Statement<'_>) -> Option<String> {
    s.args.iter().find_map(|arg| match arg {
        Arg::Form { name, form } => {
            let word = find(&name.name)?;
            Some(format!(
                "{word} is the name of a {} of the program here, and not the word",
                form.kind().word()
            ))
        }
        _ => None,
    })
}

/// Does the machine move by this word?
pub(crate) fn moves(word: &str) -> bool {
    matches!(word, "CLRSRF" | "RETRCT" | "GOHOME" | "ROTABL" | "ROTHED" | "LOAD" | "LOADTL")
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
