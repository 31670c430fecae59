//! What a misspelt word was meant to be.

use crate::words::{Word, all};

/// Spellings shorter than this are near to too many words for a hint to be right.
const SHORTEST: usize = 3;
/// From this length on, two slips are forgiven.
const TWO_SLIPS: usize = 6;
/// Longer spellings than any word and two slips.
const LONGEST: usize = 10;

/// The one word nearest to `text` among those that `accept` takes; `None` when none is near or several
/// are equally near.
///
/// Where none is, the one word that begins so.
/// Near is a slip (a letter wrong, missing, too many, or two neighbours exchanged), or two in a text of
/// six letters or more. Case does not count. A `text` that is itself an accepted word is nearest to itself.
pub fn closest(text: &str, accept: impl Fn(Word) -> bool) -> Option<Word> {
    let text = text.as_bytes();
    if text.len() < SHORTEST || text.len() > LONGEST {
        return None;
    }
    let limit = if text.len() < TWO_SLIPS { 1 } else { 2 };
    let letters = letter_set(text);
    let (mut least, mut best) = (limit + 1, None);
    for word in all() {
        let spelled = word.text().as_bytes();
        // A slip changes at most two letters of the set; this spares nine words of ten the rest.
        let strange = (letter_set(spelled) ^ letters).count_ones() as usize;
        if strange > 2 * limit || spelled.len().abs_diff(text.len()) > limit || !accept(word) {
            continue;
        }
        let slips = distance(text, spelled);
        if slips < least {
            (least, best) = (slips, Some(word));
        } else if slips == least {
            best = None;
        }
    }
    best.or_else(|| beginning(text, accept))
}

/// The one word that `text` is the beginning of: `RAD` is RADIUS cut short.
fn beginning(text: &[u8], accept: impl Fn(Word) -> bool) -> Option<Word> {
    let begins = |word: &Word| {
        let spelled = word.text().as_bytes();
        spelled.len() > text.len() && spelled[..text.len()].eq_ignore_ascii_case(text)
    };
    let mut words = all().filter(begins).filter(|w| accept(*w));
    words.next().filter(|_| words.next().is_none())
}

/// The letters, digits and points of a spelling as bits, case aside.
fn letter_set(text: &[u8]) -> u64 {
    text.iter().fold(0, |set, byte| set | 1 << (byte.to_ascii_uppercase() & 63))
}

/// Damerau-Levenshtein distance where no part is edited twice; both at most `LONGEST` long.
fn distance(a: &[u8], b: &[u8]) -> usize {
    let mut rows = [[0usize; LONGEST + 1]; 3];
    for (j, cell) in rows[0].iter_mut().enumerate() {
        *cell = j;
    }
    for i in 1..=a.len() {
        let (now, last, before) = (i % 3, (i - 1) % 3, (i + 1) % 3);
        rows[now][0] = i;
        for j in 1..=b.len() {
            let same = a[i - 1].eq_ignore_ascii_case(&b[j - 1]);
            let mut least = rows[last][j - 1] + usize::from(!same);
            least = least.min(rows[last][j] + 1).min(rows[now][j - 1] + 1);
            let swapped = i > 1
                && j > 1
                && a[i - 1].eq_ignore_ascii_case(&b[j - 2])
                && a[i - 2].eq_ignore_ascii_case(&b[j - 1]);
            if swapped {
                least = least.min(rows[before][j - 2] + 1);
            }
            rows[now][j] = least;
        }
    }
    rows[a.len() % 3][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Class, Dialect, find};

    fn of_apt(word: Word) -> bool {
        word.is_in(Dialect::Apt360) || word.is_in(Dialect::Apt4)
    }

    #[test]
    fn slips_are_recognised() {
        for (slip, meant) in [
            ("GOLFTT", "GOLFT"),
            ("GOLTF", "GOLFT"),
            ("CLYNDR", "CYLNDR"),
            ("CYLINDR", "CYLNDR"),
            ("CRICLE", "CIRCLE"),
            ("SPINDLE", "SPINDL"),
            ("spindel", "SPINDL"),
            ("FEDRATE", "FEDRAT"),
            ("XLARG", "XLARGE"),
            ("GORIGTH", "GORGT"),
            ("TERMACC", "TERMAC"),
            ("GOLFT", "GOLFT"),
            // Cut short.
            ("RADI", "RADIUS"),
            ("LENG", "LENGTH"),
        ] {
            assert_eq!(closest(slip, of_apt), find(meant), "{slip}");
        }
    }

    #[test]
    fn a_doubtful_hint_is_none() {
        // TLRFT is one letter from TLLFT and from TLRGT, GORIGHT two from GORGT and from RIGHT.
        for text in ["TLRFT", "GORIGHT", "", "Q", "GP", "WIDGET", "SETPT", "ABCDEFGHIJKLMNOP"] {
            assert_eq!(closest(text, of_apt), None, "{text}");
        }
    }

    #[test]
    fn only_accepted_words_are_given() {
        assert_eq!(closest("POIN", |word| word.class() == Class::Geometry), find("POINT"));
        assert_eq!(closest("POINT", |word| word.class() == Class::Function), None);
    }

    #[test]
    fn distance_is_that_of_the_textbook() {
        for (a, b, slips) in [
            ("", "", 0),
            ("", "ABC", 3),
            ("CA", "ABC", 3),
            ("CA", "AC", 1),
            ("KITTEN", "SITTING", 3),
            ("ABCDEF", "ABDCEF", 1),
            ("abc", "ABC", 0),
        ] {
            assert_eq!(distance(a.as_bytes(), b.as_bytes()), slips, "{a} {b}");
            assert_eq!(distance(b.as_bytes(), a.as_bytes()), slips, "{b} {a}");
        }
    }
}
