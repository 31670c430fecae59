//! Columns 73 to 80: the identification of a card, or text that was meant to be read?
//!
//! An identification is letters and digits, such as `TEST0010` or a number at the right edge. What looks
//! otherwise, or stands behind column 80, was most likely written without thought of cards, so that a
//! message is due: one for each file, an error where a statement is cut off there. A statement that is cut
//! off is not read, so that nothing else is said of it. Free form has none of this.

use std::collections::BTreeMap;
use std::ops::Range;

use aptc_diagnostics::{Diagnostic, FileId, Severity, Span, codes};

use crate::cards::{Card, TEXT_COLUMNS};
use crate::scan::{End, Flat, Scanner, place};

/// Columns 73 to 80.
const WIDTH: usize = 8;
/// So many like fields make a habit.
const HABIT: usize = 3;
/// Places shown beside the first.
const SHOWN: usize = 2;

/// Blanks between column 72 and what goes on behind it.
const GAP: usize = 1;

/// How text behind column 72 stands to that before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tail {
    /// Right behind it: a statement that goes on.
    Adjoining,
    /// With blanks between: perhaps a remark.
    Apart,
}

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

/// The texts behind column 72 of a file that are no identification.
#[derive(Default)]
pub(crate) struct Behind {
    /// Where they stand, in order.
    strange: Vec<Range<u32>>,
    /// Statements that they cut off.
    n_cut: usize,
}

impl Behind {
    /// Those of `source`.
    pub(crate) fn new(source: &str, free_form: bool) -> Self {
        let long = |line: &str| line.len() > TEXT_COLUMNS;
        if free_form || !source.lines().any(long) {
            return Self::default();
        }
        let mut scanner = Scanner::new(source, false, 1);
        let mut flat = Flat::default();
        while scanner.next(&mut flat).is_some() {}
        let tails = std::mem::take(&mut scanner.tails);
        let habits = Habits::new(source, &tails);
        let identification =
            |t: &Range<u32>| habits.is_identification(&source[t.start as usize..t.end as usize]);
        let strange = tails.iter().filter(|t| !identification(t)).cloned().collect();
        Self { strange, n_cut: 0 }
    }

    /// How the statement on these cards goes on behind column 72, if it does.
    pub(crate) fn of(&self, source: &str, cards: &[(Card, End)]) -> Option<Tail> {
        let (first, last) = (&cards.first()?.0, &cards.last()?.0);
        let from = self.strange.partition_point(|t| (t.start as usize) < first.text.start);
        let tail = self.strange.get(from).filter(|t| t.end as usize <= last.end)?;
        let (text, tail) =
            source[first.text.start..].split_at(tail.start as usize - first.text.start);
        let blanks = |text: &str, rest: &str| text.len() - rest.len();
        let gap = blanks(text, text.trim_end()) + blanks(tail, tail.trim_start());
        Some(if gap <= GAP { Tail::Adjoining } else { Tail::Apart })
    }

    /// The message about them; those of statements that they cut off are counted later.
    pub(crate) fn message(&self, file: FileId, source: &str) -> Option<Diagnostic> {
        let mut spans = self.strange.iter().map(|tail| {
            let text = &source[tail.start as usize..tail.end as usize];
            let start = tail.start + place(text.len() - text.trim_start().len());
            Span::new(file, start, tail.start + place(text.trim_end().len()))
        });
        let warning = Diagnostic::warning(codes::TEXT_BEHIND_CARD, spans.next()?, self.words())
            .label("a card's text ends with column 72; 73 to 80 are for its identification")
            .help("carry the statement on with `$` and a further card, or read the file with --free-form");
        Some(spans.take(SHOWN).fold(warning, |warning, span| warning.also(span, "here too")))
    }

    /// Makes the message an error: one more statement is cut off.
    pub(crate) fn cut_off(&mut self, message: &mut Diagnostic) {
        self.n_cut += 1;
        message.severity = Severity::Error;
        message.message = self.words();
    }

    fn words(&self) -> String {
        let text = match self.strange.len() {
            1 => "text behind column 72 is not read".to_owned(),
            n => format!("text behind column 72 of {n} cards is not read"),
        };
        match self.n_cut {
            0 => text,
            1 => format!("{text}, and a statement is cut off there"),
            n => format!("{text}, and {n} statements are cut off there"),
        }
    }
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
