//! Fixed-field words: PARTNO PPRINT INSERT REMARK TITLES take the rest of their card as text.
//!
//! The word needs no blank behind it (`INSERTG0G49`, `remarkin APT`), and `$` and `$$` in the text belong
//! to it. Only an assignment to a symbol of that name, `INSERT=3`, is no text: what follows the `=`
//! decides.

use std::ops::Range;

use aptc_vocabulary::{Word, word};

use crate::scan::place;

/// A fixed-field word and its text.
#[derive(Clone, Debug)]
pub(crate) struct FixedText {
    pub(crate) word_is: Word,
    /// The word's place.
    pub(crate) word: Range<u32>,
    /// The text's place, without blanks around it and without the quotes of APT4.
    pub(crate) text: Range<u32>,
}

const WORDS: [(&[u8; 6], Word); 5] = [
    (b"PARTNO", word::PARTNO),
    (b"PPRINT", word::PPRINT),
    (b"INSERT", word::INSERT),
    (b"REMARK", word::REMARK),
    (b"TITLES", word::TITLES),
];

/// A text of the program as data: control characters are blanks. A carriage return in the middle of a card
/// would else begin a line of its own in a CL file or in machine code.
pub(crate) fn printable(text: &str) -> Box<str> {
    if !text.contains(char::is_control) {
        return text.into();
    }
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect::<String>().into()
}

/// Where the fixed-field word of a card begins, if it has one: at its head, behind a label, or behind
/// `IF(...)`.
pub(crate) fn start_of_text(source: &str, card: Range<usize>) -> Option<usize> {
    let bytes = &source.as_bytes()[card.clone()];
    let mut at = first_letter(bytes, 0)?;
    // `PARTNO LEVER: LEFT HAND` begins with the word and not with a label of eleven letters.
    let begins_with_word = word_at(&bytes[at..]).is_some_and(|(_, length)| {
        first_letter(bytes, at + length).is_none_or(|next| !matches!(bytes[next], b')' | b':'))
    });
    if !begins_with_word && let Some(end) = end_of_label(bytes, at) {
        at = first_letter(bytes, end)?;
    }
    if let Some(end) = end_of_condition(bytes, at) {
        at = first_letter(bytes, end)?;
    }
    word_at(&bytes[at..])?;
    (!is_assignment(bytes, at)).then_some(card.start + at)
}

/// Behind the `)` or `:` of a label that begins at `at`.
fn end_of_label(bytes: &[u8], at: usize) -> Option<usize> {
    let rest = &bytes[at..];
    let end = rest.iter().position(|b| !b.is_ascii_alphanumeric() && !is_blank(*b))?;
    (end > 0 && matches!(rest[end], b')' | b':')).then_some(at + end + 1)
}

/// Behind the bracket of `IF(...)` that begins at `at`.
fn end_of_condition(bytes: &[u8], at: usize) -> Option<usize> {
    let mut letters = (at..).zip(&bytes[at..]).filter(|(_, b)| !is_blank(**b));
    for expected in *b"IF(" {
        letters.next().filter(|(_, b)| b.to_ascii_uppercase() == expected)?;
    }
    let mut depth = 1_usize;
    for (i, b) in letters {
        match b {
            b'(' => depth += 1,
            b')' => depth -= 1,
            b'$' => return None,
            _ => {}
        }
        if depth == 0 {
            return Some(i + 1);
        }
    }
    None
}

fn is_blank(b: u8) -> bool {
    matches!(b, b' ' | b'\t')
}

fn first_letter(bytes: &[u8], from: usize) -> Option<usize> {
    bytes.get(from..)?.iter().position(|b| !is_blank(*b)).map(|i| i + from)
}

/// The fixed-field word at the start of `bytes` and its length there.
fn word_at(bytes: &[u8]) -> Option<(Word, usize)> {
    let mut letters = [0; 6];
    let mut n = 0;
    for (i, b) in bytes.iter().enumerate() {
        if is_blank(*b) {
            continue;
        }
        letters[n] = b.to_ascii_uppercase();
        n += 1;
        if n == 1 && !matches!(letters[0], b'P' | b'I' | b'R' | b'T') {
            return None;
        }
        if n == letters.len() {
            let found = WORDS.iter().find(|(w, _)| **w == letters)?;
            return Some((found.1, i + 1));
        }
    }
    None
}

/// Is the word at `at` the symbol of an assignment? So when one `=` follows it directly and then
/// something that can be a value on its own.
fn is_assignment(bytes: &[u8], at: usize) -> bool {
    let Some((_, length)) = word_at(&bytes[at..]) else { return false };
    let Some(equal) = first_letter(bytes, at + length) else { return false };
    if bytes[equal] != b'=' {
        return false;
    }
    is_value(&bytes[equal + 1..])
}

/// Could this be the right side of an assignment: numbers, names, operators and brackets in an order
/// that makes sense, up to a comment?
fn is_value(bytes: &[u8]) -> bool {
    // A value and an operator take turns.
    let mut wants_value = true;
    let mut depth = 0_u32;
    let mut in_item = false;
    for &b in bytes {
        match b {
            // Two words side by side are prose.
            b' ' | b'\t' => {}
            b'$' => break,
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'.' => {
                if !wants_value && !in_item {
                    return false;
                }
                (wants_value, in_item) = (false, true);
                continue;
            }
            b'(' => {
                depth += 1;
                wants_value = true;
            }
            b')' => {
                if wants_value || depth == 0 {
                    return false;
                }
                depth -= 1;
            }
            b'+' | b'-' => wants_value = true,
            b'*' | b'/' | b',' => {
                wants_value = true;
            }
            _ => return false,
        }
        in_item = false;
    }
    !wants_value && depth == 0
}

/// The fixed-field word at `start` with its text, which ends at `end`.
pub(crate) fn read(source: &str, start: usize, end: usize) -> FixedText {
    let bytes = source.as_bytes();
    let (word_is, length) = word_at(&bytes[start..end]).unwrap_or((word::REMARK, end - start));
    let word = place(start)..place(start + length);
    let text = trimmed(source, start + length..end);
    let text = quoted(source, text.clone()).unwrap_or_else(|| match word_is {
        // A slash in front of an inserted block may be its block delete mark.
        word::INSERT => text.clone(),
        _ if source[text.clone()].starts_with('/') => trimmed(source, text.start + 1..text.end),
        _ => text.clone(),
    });
    FixedText { word_is, word, text: place(text.start)..place(text.end) }
}

/// The text between the quotes of `/'...'`.
fn quoted(source: &str, text: Range<usize>) -> Option<Range<usize>> {
    let after =
        trimmed(source, text.start + source[text.clone()].strip_prefix('/').map(|_| 1)?..text.end);
    let inner = &source[after.clone()];
    let mark = inner.chars().next().filter(|c| matches!(c, '\'' | '"'))?;
    let end = inner[1..].find(mark)?;
    // What follows the closing quote must be nothing or a comment, else the quotes are part of the text.
    let behind = inner[end + 2..].trim_start();
    (behind.is_empty() || behind.starts_with("$$"))
        .then_some(after.start + 1..after.start + 1 + end)
}

fn trimmed(source: &str, range: Range<usize>) -> Range<usize> {
    let text = &source[range.clone()];
    let start = range.start + (text.len() - text.trim_start().len());
    start..start.max(range.start + text.trim_end().len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_one_line() {
        assert_eq!(&*printable("BRACKET 7"), "BRACKET 7");
        assert_eq!(&*printable("M30\rG0\tZ-99\u{85}\0"), "M30 G0 Z-99  ");
    }

    #[test]
    fn a_colon_in_the_text_makes_no_label_of_the_word() {
        let start = |text: &str| start_of_text(text, 0..text.len());
        assert_eq!(start("PARTNO  WEDGE: OUTLINE"), Some(0));
        assert_eq!(start("REMARK (A) AND B)"), Some(0));
        assert_eq!(start("LAB: PPRINT TEXT"), Some(5));
        assert_eq!(start("12) INSERTG0"), Some(4));
        assert_eq!(start("PARTNO) PPRINT X"), Some(8));
        assert_eq!(start("INSERT=3"), None);
    }
}
