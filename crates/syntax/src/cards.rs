//! Card images: what of a line is statement text.

use std::ops::Range;

use memchr::memchr;

/// Columns of a card that hold statement text.
pub(crate) const TEXT_COLUMNS: usize = 72;

/// A line of the file.
#[derive(Clone, Debug)]
pub(crate) struct Card {
    /// Bytes of the statement text: columns 1 to 72, or the whole line in free form.
    pub(crate) text: Range<usize>,
    /// End of the line, without its end mark.
    pub(crate) end: usize,
    /// Number of the line, from 1.
    pub(crate) line: u32,
}

/// Iterates over the cards of a file.
pub(crate) struct Cards<'s> {
    source: &'s str,
    at: usize,
    line: u32,
    free_form: bool,
}

impl<'s> Cards<'s> {
    pub(crate) fn new(source: &'s str, free_form: bool) -> Self {
        let source = before_end_mark(source);
        // A byte order mark is no column.
        let at = if source.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        Self { source, at, line: 0, free_form }
    }
}

impl Iterator for Cards<'_> {
    type Item = Card;

    fn next(&mut self) -> Option<Card> {
        if self.at >= self.source.len() {
            return None;
        }
        let start = self.at;
        let rest = &self.source.as_bytes()[start..];
        let length = memchr(b'\n', rest).unwrap_or(rest.len());
        self.at = start + length + 1;
        self.line += 1;
        let mut end = start + length;
        while end > start && self.source.as_bytes()[end - 1] == b'\r' {
            end -= 1;
        }
        let text_end =
            if self.free_form { end } else { column_end(&self.source[start..end]) + start };
        Some(Card { text: start..text_end, end, line: self.line })
    }
}

/// Bytes in the first 72 columns of a line; a column is a character.
fn column_end(line: &str) -> usize {
    if line.len() <= TEXT_COLUMNS {
        return line.len();
    }
    line.char_indices().nth(TEXT_COLUMNS).map_or(line.len(), |(i, _)| i)
}

/// The text before a final `^Z`, the end mark of files from DOS and CP/M.
fn before_end_mark(source: &str) -> &str {
    let trimmed = source.trim_end_matches(['\u{1a}', '\0', ' ', '\t', '\r', '\n']);
    match source[trimmed.len()..].find('\u{1a}') {
        Some(i) => &source[..trimmed.len() + i],
        None => source,
    }
}
