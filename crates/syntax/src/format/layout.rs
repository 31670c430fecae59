//! Words onto cards, with indentation, comments and identification.

use std::ops::Range;

use super::FormatOptions;
use super::spacing::Written;
use crate::cards::{Card, TEXT_COLUMNS};
use crate::identification::Habits;
use crate::scan::End;

/// Columns between tabulator stops, as editors show them.
const TAB: usize = 8;
/// Blanks before what did not fit on its card.
const INDENT_OF_REST: usize = 6;

/// What stands in place of a card.
pub(super) enum Lines {
    /// The card as it is.
    Untouched,
    /// The card with the fixed-field word at this place in capitals.
    Fixed(Range<u32>),
    /// The card's code in new words, in lines of which all but the last end in `$`.
    Code {
        /// The lines.
        lines: Vec<String>,
        /// Where the old card's comment begins, with its `$` or `$$`.
        comment: Option<usize>,
    },
}

/// The lines that replace the cards of a statement.
pub(super) fn cards(
    source: &str,
    pieces: &[(Card, End)],
    words: &[Written],
    free_form: bool,
) -> Vec<(u32, Lines)> {
    let mut replaced = Vec::with_capacity(pieces.len());
    let mut words = words.iter().peekable();
    for (card, end) in pieces {
        let indent = columns_of_blanks(&source[card.text.clone()]);
        let limit = match end {
            _ if free_form => usize::MAX,
            End::GoesOn(_) => TEXT_COLUMNS - 1,
            End::Card | End::Comment(_) => TEXT_COLUMNS,
        };
        let mut mine = Vec::new();
        while let Some(word) = words.next_if(|w| (w.at as usize) < card.end) {
            mine.push(word);
        }
        let lines = divided(&front(source, card, indent, &mut mine), indent, &mine, limit);
        let too_long = !free_form && lines.iter().any(|l| columns(l) > TEXT_COLUMNS);
        let comment = match end {
            End::Card => None,
            End::Comment(at) | End::GoesOn(at) => Some(*at),
        };
        let lines = if too_long { Lines::Untouched } else { Lines::Code { lines, comment } };
        replaced.push((card.line, lines));
    }
    // A statement is replaced as a whole or not at all.
    if replaced.iter().any(|(_, lines)| matches!(lines, Lines::Untouched)) {
        for (_, lines) in &mut replaced {
            *lines = Lines::Untouched;
        }
    }
    replaced
}

/// What a card begins with: blanks, or the label, which is taken off, with the blanks behind it.
fn front(source: &str, card: &Card, indent: usize, words: &mut Vec<&Written>) -> String {
    let mut front = " ".repeat(indent);
    let Some(label) = words.first().filter(|w| w.label_of.is_some()) else { return front };
    front.push_str(&label.text);
    let body = label.label_of.map_or(0, |at| at as usize);
    if body < card.end {
        let column = shown_columns(&source[card.text.start..body]);
        front.push_str(&" ".repeat(column.saturating_sub(columns(&front))));
    }
    words.remove(0);
    front
}

/// The words in lines of at most `limit` columns, all but the last with a `$`: divided behind commas.
fn divided(front: &str, indent: usize, words: &[&Written], limit: usize) -> Vec<String> {
    let line = |front: &str, words: &[&Written]| {
        let text: String = words.iter().map(|w| &w.text[..]).collect();
        format!("{front}{}", text.trim())
    };
    let mut lines = Vec::new();
    let mut rest = words;
    let further = " ".repeat(indent + INDENT_OF_REST);
    let mut start = front;
    while columns(&line(start, rest)) > limit {
        // As much as fits with the `$`, up to a comma if there is one.
        let fits = |n: &usize| columns(&line(start, &rest[..*n])) < TEXT_COLUMNS;
        let most = (1..rest.len()).take_while(fits).last().unwrap_or(1);
        let comma = (1..=most).rev().find(|&n| rest[n - 1].breaks);
        let (now, later) = rest.split_at(comma.unwrap_or(most));
        lines.push(line(start, now) + "$");
        if later.is_empty() {
            rest = later;
            break;
        }
        (rest, start) = (later, &further);
    }
    lines.push(line(start, rest).trim_end().to_owned());
    lines
}

/// Columns of a text without tabulators.
fn columns(text: &str) -> usize {
    text.chars().count()
}

/// Columns of the blanks that the text begins with.
fn columns_of_blanks(text: &str) -> usize {
    let blanks = text.len() - text.trim_start_matches([' ', '\t']).len();
    shown_columns(&text[..blanks])
}

/// Columns of a text as editors show them.
fn shown_columns(text: &str) -> usize {
    text.chars().fold(0, |column, c| match c {
        '\t' => (column / TAB + 1) * TAB,
        _ => column + 1,
    })
}

/// Writes what stands in place of `card`, without its line end.
pub(super) fn write(
    out: &mut String,
    source: &str,
    card: &Card,
    lines: Option<Lines>,
    habits: &Habits<'_>,
    options: &FormatOptions,
) {
    let whole = &source[card.text.start..card.end];
    let tail = &source[card.text.end..card.end];
    let (code, comment) = match lines {
        Some(Lines::Untouched) => {
            out.push_str(whole);
            return;
        }
        // A comment or blank card; a comment may pass column 72.
        None => {
            let is_comment = source[card.text.clone()].trim_start().starts_with('$');
            let is_id = if is_comment {
                habits.is_identification_of_comment(tail)
            } else {
                habits.is_identification(tail)
            };
            let text = if is_id { &source[card.text.clone()] } else { whole };
            finish(out, text.trim_end(), if is_id { tail } else { "" }, options);
            return;
        }
        Some(Lines::Fixed(word)) => {
            let word = word.start as usize..word.end as usize;
            let mut text = source[card.text.start..word.start].to_ascii_uppercase();
            text.push_str(&source[word.clone()].to_ascii_uppercase());
            text.push_str(source[word.end..card.text.end].trim_end());
            let is_id = habits.is_identification(tail);
            let rest = if is_id { "" } else { tail.trim_end() };
            if !rest.is_empty() {
                out.push_str(whole);
                return;
            }
            finish(out, text.trim_end(), if is_id { tail } else { "" }, options);
            return;
        }
        Some(Lines::Code { lines, comment }) => (lines, comment),
    };
    let line_end = line_end(source, card.end);
    let last = code.len().saturating_sub(1);
    for line in &code[..last] {
        out.push_str(line);
        out.push_str(line_end);
    }
    let mut line = code[last].clone();
    let mut id = if habits.is_identification(tail) { tail } else { "" };
    if let Some(at) = comment {
        let usual = habits.is_identification_of_comment(tail);
        let text = source[at..if usual { card.text.end } else { card.end }].trim_end();
        id = if usual { tail } else { "" };
        if text == "$" {
            line.push('$');
        } else {
            if !line.trim().is_empty() {
                line.push(' ');
            }
            let column = shown_columns(&source[card.text.start..at]);
            let column = if options.free_form { column } else { column.min(TEXT_COLUMNS - 2) };
            let missing = column.saturating_sub(columns(&line));
            line.push_str(&" ".repeat(missing));
            line.push_str(text);
        }
    }
    finish(out, line.trim_end(), id, options);
}

/// The end mark of the card's line.
fn line_end(source: &str, end: usize) -> &'static str {
    if source[end..].starts_with('\r') { "\r\n" } else { "\n" }
}

/// Writes a line with its identification, if that is to stay.
fn finish(out: &mut String, line: &str, id: &str, options: &FormatOptions) {
    out.push_str(line);
    let id = id.trim_end();
    if options.keep_identification && !id.is_empty() {
        let missing = TEXT_COLUMNS.saturating_sub(line.chars().count());
        out.push_str(&" ".repeat(missing));
        out.push_str(id);
    }
}
