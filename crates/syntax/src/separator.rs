//! Words that ran together because a sign is missing between them.
//!
//! Blanks have no meaning, so `GOTO P1` is the one word GOTOP1. Nobody means that: where blanks part a
//! name that is no word into pieces and a word is among them, the sign is missing. Without a blank, as in
//! `GOTOP1` or `P1POINT/1,2`, it is only said of the head of a statement, which must be a word.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_vocabulary::{Class, Dialect, Word, find, word};

use crate::shape;
use crate::tree::{Body, Name};

/// The message for a statement that was read, but whose heads are words run together.
pub(crate) fn in_heads(body: &Body, source: &str) -> Option<Diagnostic> {
    let clauses = match body {
        Body::Clauses(clauses) => clauses,
        Body::IfThen { then, .. } => return in_heads(then, source),
        _ => return None,
    };
    clauses.iter().find_map(|clause| check_head(clause.head, source))
}

/// What to do about an IF without brackets.
pub(crate) const IF_HELP: &str = "IF(value)l1,l2,l3 has its value in brackets";

/// Words that take no arguments.
const ALONE: [Word; 4] = [word::FINI, word::LOOPST, word::LOOPND, word::TERMAC];

/// The message for `name`, if it is words run together, one of them from the head of a statement.
pub(crate) fn check(name: Name, source: &str) -> Option<Diagnostic> {
    if name.word.is_some() {
        return None;
    }
    let text = source.get(name.span.start as usize..name.span.end as usize)?;
    let help = missing_sign(text)?;
    let all: String = text.split_ascii_whitespace().collect();
    let message =
        format!("blanks have no meaning: this is the one word {}", all.to_ascii_uppercase());
    Some(Diagnostic::error(codes::MISSING_SEPARATOR, name.span, message).help(help))
}

/// The message for `name`, which must be a word, if it is words run together with or without blanks.
pub(crate) fn check_head(name: Name, source: &str) -> Option<Diagnostic> {
    if name.word.is_some() {
        return None;
    }
    check(name, source).or_else(|| {
        let text = source.get(name.span.start as usize..name.span.end as usize)?;
        if text.len() > LONGEST || !text.bytes().all(|b| b.is_ascii_alphanumeric()) {
            return None;
        }
        let text = text.to_ascii_uppercase();
        let help = (1..text.len()).rev().find_map(|n| within(text.split_at(n)))?;
        let message = format!("{text} is no word of APT");
        Some(Diagnostic::error(codes::MISSING_SEPARATOR, name.span, message).help(help))
    })
}

/// Words shorter than this begin too many names by chance.
const SHORTEST: usize = 4;
/// Longer names than this are neither words nor symbols of APT.
const LONGEST_WORD: usize = 6;

/// What to do when one side of a name without blanks is a word that moves, defines or steers.
fn within((front, rest): (&str, &str)) -> Option<String> {
    // A word of a post-processor that nobody knows has no digit and at most six letters.
    let is_one = |side: &str| {
        front.len() + rest.len() <= LONGEST_WORD && !side.bytes().any(|b| b.is_ascii_digit())
    };
    let steers = |word: &Word| {
        front.len() >= SHORTEST
            && is_major(*word)
            && matches!(word.class(), Class::Motion | Class::Geometry | Class::Control)
    };
    if let Some(word) = find(front).filter(steers).filter(|_| !is_one(rest)) {
        return Some(behind(word, rest));
    }
    let defines = |word: &Word| rest.len() >= SHORTEST && shape::defines(*word);
    let word = find(rest).filter(defines).filter(|_| !is_one(front))?;
    Some(format!("put a `=` before {word}: {front}={word}"))
}

/// What to do when `rest` follows a word.
fn behind(word: Word, rest: &str) -> String {
    match word {
        word::IF => IF_HELP.to_owned(),
        _ if ALONE.contains(&word) => format!("{word} stands alone: take {rest} away"),
        _ if word.class() == Class::Function => format!("write {word}({rest})"),
        _ if find(rest).is_some_and(is_major) => format!("put a `,` behind {word}: {word},{rest}"),
        _ => format!("put a `/` behind {word}: {word}/{rest}"),
    }
}

/// What to do when the source text of a name (`GOTO P1`, `RAPID GOTO`, `P1 POINT`) is words with blanks
/// but no sign between; `None` when nothing speaks for that.
///
/// For a name that turned out to be unknown: with blanks in it, it may be several.
pub fn missing_sign(text: &str) -> Option<String> {
    let pieces: Vec<&str> = text.split_ascii_whitespace().collect();
    if pieces.len() < 2 || text.len() > LONGEST || !text.is_ascii() || text.contains('$') {
        return None;
    }
    let joined = |pieces: &[&str]| pieces.concat().to_ascii_uppercase();
    let parts = |n: usize| (joined(&pieces[..n]), joined(&pieces[n..]));
    for (front, rest) in (1..pieces.len()).rev().map(parts) {
        let Some(word) = find(&front).filter(|w| is_major(*w)) else { continue };
        return Some(behind(word, &rest));
    }
    for (front, rest) in (1..pieces.len()).map(parts) {
        let Some(word) = find(&rest).filter(|w| is_major(*w)) else { continue };
        if shape::defines(word) {
            return Some(format!("put a `=` before {word}: {front}={word}"));
        }
        if word.class() != Class::Function {
            return Some(format!("put a `)` behind {front} if it is a label: {front}) {word}"));
        }
    }
    None
}

/// Longest text of a name that is looked into.
const LONGEST: usize = 72;

/// Does the word stand at the head of statements of APT, or is it a function?
fn is_major(word: Word) -> bool {
    word.is_major(Dialect::Apt360) || word.is_major(Dialect::Apt4)
}
