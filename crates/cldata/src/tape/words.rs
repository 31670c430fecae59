//! Words of eight bytes.

use aptc_vocabulary::{self as vocabulary, Code};
use smol_str::SmolStr;

use crate::Arg;

/// A word as it stands in a record.
pub(crate) type Raw = [u8; 8];

/// Six characters and two blanks, the text at the right of its field.
pub(crate) fn right(text: &str) -> Raw {
    chunk(format!("{text:>6}").as_bytes())
}

/// Up to six characters at the left of the field.
pub(crate) fn chunk(text: &[u8]) -> Raw {
    let mut raw = *b"        ";
    for (place, b) in raw.iter_mut().zip(text.iter().take(6)) {
        *place = if (32..127).contains(b) { *b } else { b'?' };
    }
    raw
}

/// An integer, as word codes stand there.
pub(crate) fn integer(n: u32) -> Raw {
    u64::from(n).to_le_bytes()
}

/// A number. A double whose bytes happen to be characters, or that looks like a code, would be taken for
/// one by readers of the format; its last bits are changed, by at most 1e-13 of its value.
pub(crate) fn number(x: f64) -> Raw {
    let mut raw = x.to_le_bytes();
    if is_text(&raw) {
        raw[0] = if raw[0] < 0x50 { 0x1f } else { 0x7f };
    }
    if raw[4..] == [0; 4] { [0; 8] } else { raw }
}

/// Could it be characters?
pub(crate) fn is_text(raw: &Raw) -> bool {
    raw.iter().all(|b| (32..127).contains(b))
}

/// The text of a word of characters.
pub(crate) fn text_of(raw: &Raw) -> String {
    raw[..6].iter().map(|b| char::from(*b)).collect()
}

/// A number where a number must be.
pub(crate) fn number_of(raw: &Raw) -> f64 {
    match code_of(raw) {
        Some(n) => f64::from(n),
        None => f64::from_le_bytes(*raw),
    }
}

/// An integer followed by zeros, but not 0.
pub(crate) fn code_of(raw: &Raw) -> Option<u32> {
    let n = u32::from_le_bytes([raw[0], raw[1], raw[2], raw[3]]);
    (raw[4..] == [0; 4] && n != 0).then_some(n)
}

/// Appends a text of any length behind its count of characters, `'00017` for texts, `"00017` for words.
fn put_long(out: &mut Vec<Raw>, mark: char, text: &str) {
    let bytes: Vec<u8> = text.chars().map(|c| u8::try_from(c).unwrap_or(b'?')).collect();
    let bytes = &bytes[..bytes.len().min(99_999)];
    out.push(chunk(format!("{mark}{:05}", bytes.len()).as_bytes()));
    out.extend(bytes.chunks(6).map(chunk));
}

/// Appends a word by its code, or as characters.
pub(crate) fn put_word(out: &mut Vec<Raw>, word: &str, dialect: vocabulary::Dialect) {
    // A code that several words share stands only for the one that it reads back as.
    match code_for(word, dialect, false) {
        Some(n) => out.push(integer(n)),
        _ if word.len() <= 6 && !word.starts_with(['\'', '"']) => out.push(right(word)),
        _ => put_long(out, '"', word),
    }
}

/// Appends a text.
pub(crate) fn put_text(out: &mut Vec<Raw>, text: &str) {
    put_long(out, '\'', text);
}

/// The arguments that the words stand for.
pub(crate) fn arguments(words: &[Raw], dialect: vocabulary::Dialect) -> Vec<Arg> {
    let mut out = Vec::new();
    let mut rest = words;
    while let Some((raw, tail)) = rest.split_first() {
        rest = tail;
        if !is_text(raw) {
            out.push(match code_of(raw) {
                Some(n) => Arg::Word(minor(n, dialect)),
                None => Arg::Number(finite(f64::from_le_bytes(*raw))),
            });
            continue;
        }
        let text = text_of(raw);
        let count = text.get(1..).and_then(|d| d.parse::<usize>().ok());
        match (text.chars().next(), count) {
            (Some(mark @ ('\'' | '"')), Some(n)) if n.div_ceil(6) <= rest.len() => {
                let (long, tail) = rest.split_at(n.div_ceil(6));
                rest = tail;
                let joined: String = long.iter().map(text_of).collect();
                let joined: String = joined.chars().take(n).collect();
                out.push(match mark {
                    '"' => Arg::Word(joined.into()),
                    _ => Arg::Text(joined.into()),
                });
            }
            _ => out.push(Arg::Word(text.trim().into())),
        }
    }
    out
}

/// A number that records may hold.
fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { 0.0 }
}

/// The code of a word, if it reads back as the same word.
pub(crate) fn code_for(text: &str, dialect: vocabulary::Dialect, major: bool) -> Option<u32> {
    let found = vocabulary::find(text)?;
    let code = if major { found.major_code(dialect) } else { found.minor_code(dialect) };
    let Some(Code::Word(n)) = code else { return None };
    let n = u32::from(n);
    (word(n, dialect, major)?.as_str() == text).then_some(n)
}

/// The word of a minor code.
fn minor(code: u32, dialect: vocabulary::Dialect) -> SmolStr {
    word(code, dialect, false).unwrap_or_else(|| format!("MINOR{code}").into())
}

/// The word of a code.
pub(crate) fn word(code: u32, dialect: vocabulary::Dialect, major: bool) -> Option<SmolStr> {
    let code = Code::Word(u16::try_from(code).ok()?);
    vocabulary::from_code(dialect, major, code).map(|w| w.text().into())
}
