//! Words and arguments of a statement.

use smol_str::SmolStr;

use crate::{Arg, number};

/// Most numbers taken from one statement.
pub(super) const MOST_NUMBERS: usize = 32;

/// A coordinate beyond this is a mistake in the file, not a place: its products would leave the range of
/// numbers.
const FARTHEST: f64 = 1e30;

/// A number that can be a coordinate, all of the text but for blanks.
pub(super) fn coordinate(text: &[u8]) -> Option<f64> {
    number::parse(text).filter(|x| is_coordinate(*x))
}

/// Can it be a coordinate?
pub(super) fn is_coordinate(x: f64) -> bool {
    x.abs() < FARTHEST
}

/// Numbers of a statement, and how many.
pub(super) struct Numbers {
    values: [f64; MOST_NUMBERS],
    len: usize,
}

impl Numbers {
    pub(super) fn get(&self) -> &[f64] {
        &self.values[..self.len]
    }
}

/// The arguments as numbers, when all of them are; empty ones at the end are left out.
pub(super) fn all_numbers(args: &[u8]) -> Option<Numbers> {
    let mut out = Numbers { values: [0.0; MOST_NUMBERS], len: 0 };
    let args = args.trim_ascii();
    if args.is_empty() {
        return Some(out);
    }
    let args = args.strip_suffix(b",").unwrap_or(args);
    for field in args.split(|b| *b == b',') {
        *out.values.get_mut(out.len)? = coordinate(field)?;
        out.len += 1;
    }
    Some(out)
}

/// The arguments of a post-processor word.
pub(super) fn parse(args: &[u8], out: &mut Vec<Arg>) {
    if args.trim_ascii().is_empty() {
        return;
    }
    for field in fields(args) {
        out.push(argument(field.trim_ascii()));
    }
}

/// Cuts at commas that stand neither in quotes nor in parentheses.
pub(super) fn fields(args: &[u8]) -> impl Iterator<Item = &[u8]> {
    let mut rest = Some(args);
    std::iter::from_fn(move || {
        let text = rest?;
        let (mut quoted, mut depth) = (false, 0_u32);
        for (i, b) in text.iter().enumerate() {
            match b {
                b'\'' => quoted = !quoted,
                b'(' if !quoted => depth += 1,
                b')' if !quoted => depth = depth.saturating_sub(1),
                b',' if !quoted && depth == 0 => {
                    rest = Some(&text[i + 1..]);
                    return Some(&text[..i]);
                }
                _ => {}
            }
        }
        rest = None;
        Some(text)
    })
}

fn argument(field: &[u8]) -> Arg {
    if let Some(x) = number::parse(field) {
        return Arg::Number(x);
    }
    if field.len() >= 2 && field.first() == Some(&b'\'') && field.last() == Some(&b'\'') {
        return Arg::Text(text(&field[1..field.len() - 1]).replace("''", "'").into());
    }
    if is_word(field) {
        return Arg::Word(upper(field));
    }
    Arg::Text(text(field).into())
}

fn is_word(field: &[u8]) -> bool {
    field.iter().all(|b| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'-' | b'.' | b'*' | b'#'))
}

/// Upper case without blanks inside.
pub(super) fn upper(word: &[u8]) -> SmolStr {
    word.iter()
        .filter(|b| !b.is_ascii_whitespace())
        .map(|b| char::from(b.to_ascii_uppercase()))
        .collect()
}

/// Text of a file that need not be UTF-8: if it is not, each byte is a Latin-1 character.
pub(super) fn text(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(s) => s.to_owned(),
        Err(_) => bytes.iter().map(|b| char::from(*b)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn args(text: &str) -> Vec<Arg> {
        let mut out = Vec::new();
        parse(text.as_bytes(), &mut out);
        out
    }

    #[test]
    fn arguments_are_what_they_look_like() {
        let word = |w: &str| Arg::Word(w.into());
        assert_eq!(args(" RPM, 1000.0,  clw"), [word("RPM"), Arg::Number(1000.0), word("CLW")]);
        assert_eq!(args("'a, b''c',1stpeck"), [Arg::Text("a, b'c".into()), word("1STPECK")]);
        assert_eq!(args("T1 Tap D 10"), [Arg::Text("T1 Tap D 10".into())]);
        assert_eq!(args("1,,(PLANE/0,0,1,5)").len(), 3);
        assert_eq!(args("  "), []);
        assert_eq!(args("\u{e9}"), [Arg::Text("\u{e9}".into())]);
    }

    #[test]
    fn numbers_only() {
        assert_eq!(all_numbers(b" 1, -2.5 ,.5,").unwrap().get(), [1.0, -2.5, 0.5]);
        assert!(all_numbers(b"1,X").is_none() && all_numbers(b"1,,2").is_none());
        assert!(all_numbers(&b"1,".repeat(40)).is_none());
    }
}
