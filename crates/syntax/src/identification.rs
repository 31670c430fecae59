//! Columns 73 to 80: the identification of a card, or text that was meant to be read?
//!
//! An identification is letters and digits, such as `TEST0010` or a number at the right edge. What looks
//! otherwise, or stands behind column 80, was most likely written without thought of cards, so that a
//! warning is due. One warning a file; free form has none of this.

use std::collections::BTreeMap;
use std::ops::Range;

use aptc_diagnostics::{Diagnostic, FileId, Span, codes};

use crate::scan::place;

/// Columns 73 to 80.
const WIDTH: usize = 8;
/// So many like fields make a habit.
const HABIT: usize = 3;
/// Places shown beside the first.
const SHOWN: usize = 2;

/// Where a field of identification stands and what it begins with: cards of one program agree in this.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Habit<'s> {
    blanks: usize,
    width: usize,
    letters: &'s str,
}

/// What the cards of a file have behind column 72.
pub(crate) struct Habits<'s> {
    met: BTreeMap<Habit<'s>, usize>,
    n_tails: usize,
}

impl<'s> Habits<'s> {
    /// The habits of a file with these `tails`: texts behind column 72 up to the ends of their lines.
    pub(crate) fn new(source: &'s str, tails: &[Range<u32>]) -> Self {
        let mut met = BTreeMap::new();
        for tail in tails {
            if let Some(habit) = habit(&source[tail.start as usize..tail.end as usize]) {
                *met.entry(habit).or_default() += 1;
            }
        }
        Self { met, n_tails: tails.len() }
    }

    /// Is the tail an identification: a number at the right edge, or what most others in this file are?
    pub(crate) fn is_identification(&self, tail: &str) -> bool {
        let Some(habit) = habit(tail) else { return false };
        let at_edge = habit.blanks + habit.width == WIDTH && habit.letters.len() < habit.width;
        let n = self.met.get(&habit).copied().unwrap_or(0);
        at_edge || (n >= HABIT && 2 * n >= self.n_tails)
    }

    /// Is the tail of a comment, which may be of any length, an identification as others are?
    pub(crate) fn is_identification_of_comment(&self, tail: &str) -> bool {
        self.is_identification(tail) && habit(tail).is_some_and(|h| self.met.contains_key(&h))
    }
}

/// A warning about the texts behind column 72 that are no identification.
pub(crate) fn check(file: FileId, source: &str, tails: &[Range<u32>]) -> Option<Diagnostic> {
    let text = |tail: &Range<u32>| &source[tail.start as usize..tail.end as usize];
    let habits = Habits::new(source, tails);
    let mut strange = tails.iter().filter(|t| !habits.is_identification(text(t))).map(|tail| {
        let text = text(tail);
        let start = tail.start + place(text.len() - text.trim_start().len());
        Span::new(file, start, tail.start + place(text.trim_end().len()))
    });
    let first = strange.next()?;
    let shown: Vec<Span> = strange.by_ref().take(SHOWN).collect();
    let n = 1 + shown.len() + strange.count();
    let message = match n {
        1 => "text behind column 72 is not read".to_owned(),
        _ => format!("text behind column 72 of {n} cards is not read"),
    };
    let mut warning = Diagnostic::warning(codes::TEXT_BEHIND_CARD, first, message)
        .label("a card's text ends with column 72; 73 to 80 are for its identification")
        .help(
            "carry the statement on with `$` and a further card, or read the file with --free-form",
        );
    for span in shown {
        warning = warning.also(span, "here too");
    }
    Some(warning)
}

/// The field's habit when it could be an identification: letters and digits in columns 73 to 80.
fn habit(tail: &str) -> Option<Habit<'_>> {
    let field = tail.trim_end();
    let blanks = field.len() - field.trim_start().len();
    let field = field.trim_start();
    let width = field.len();
    if blanks + width > WIDTH || !field.bytes().all(|b| b.is_ascii_alphanumeric()) {
        return None;
    }
    Some(Habit { blanks, width, letters: field.trim_end_matches(|c: char| c.is_ascii_digit()) })
}
