//! From a spelling or a code to the word.

use crate::dialect::{Code, Dialect};
use crate::entry::stored;
use crate::table::{BY_CODE, MULTIPLIER, PACKED, SLOTS};
use crate::words::Word;

/// Longest spelling in the table, in bytes; what a packed spelling can hold.
const LONGEST: usize = 8;

/// The word spelled exactly `text`, in capitals, in any dialect.
///
/// No allocation: the spelling is packed into a number and looked up in an open-addressed table.
pub fn find(text: &str) -> Option<Word> {
    let packed = pack(text.as_bytes())?;
    let mut slot = usize::try_from(packed.wrapping_mul(MULTIPLIER) >> 52).ok()?;
    // Three slots of four are empty, so the walk meets one.
    loop {
        let index = SLOTS[slot];
        if *PACKED.get(usize::from(index))? == packed {
            return Some(Word(index));
        }
        slot = (slot + 1) % SLOTS.len();
    }
}

/// The word spelled exactly `text` in `dialect`.
pub fn find_in(text: &str, dialect: Dialect) -> Option<Word> {
    find(text).filter(|word| word.is_in(dialect))
}

/// The word that `code` stands for at the head of a statement (`major`) or among arguments.
///
/// Some codes stand for several words: TANTO and DSTAN share 27, and in APT4 GOHOME and CODEL share 14.
/// Then the word known to most dialects is given, of those the longest. So a word should be kept as a
/// word in files of our own.
pub fn from_code(dialect: Dialect, major: bool, code: Code) -> Option<Word> {
    let place = |column: usize| {
        let column = u8::try_from(column).ok()?;
        let key = (column, !major, stored(code));
        let found = BY_CODE.binary_search_by_key(&key, |&(d, minor, code, _)| (d, minor, code));
        found.ok().map(|at| Word(BY_CODE[at].3))
    };
    place(dialect.column()).or_else(|| match dialect {
        Dialect::IbmCl => place(Dialect::PostWorks.column()),
        _ => None,
    })
}

/// The spelling as a number, first letter lowest; none for what cannot be a word.
fn pack(bytes: &[u8]) -> Option<u64> {
    // A shorter spelling is filled up with zeros, so a text that ends in one would pass for it.
    if bytes.last().is_none_or(|&last| last == 0) {
        return None;
    }
    let mut packed = [0; LONGEST];
    packed.get_mut(..bytes.len())?.copy_from_slice(bytes);
    Some(u64::from_le_bytes(packed))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::all;
    use crate::{Class, word};

    #[test]
    fn every_word_is_found_by_its_spelling() {
        for word in all() {
            assert_eq!(find(word.text()), Some(word));
            assert_eq!(find(&word.text().to_lowercase()), None, "{word}");
        }
        for absent in ["", "P1", "SETPT", "GOLFTT", "ABCDEFGH", "ABCDEFGHI", "É", "\0", "TO\0"] {
            assert_eq!(find(absent), None, "{absent:?}");
        }
    }

    #[test]
    fn words_sort_as_their_spellings() {
        assert!(all().zip(all().skip(1)).all(|(a, b)| a < b && a.text() < b.text()));
        assert!(all().len() >= 945);
    }

    #[test]
    fn codes_lead_back_to_a_word_with_that_code() {
        for dialect in Dialect::ALL {
            for word in all() {
                for (major, code) in
                    [(true, word.major_code(dialect)), (false, word.minor_code(dialect))]
                {
                    let Some(code) = code else { continue };
                    let back = from_code(dialect, major, code).expect("a code of the table");
                    let again =
                        if major { back.major_code(dialect) } else { back.minor_code(dialect) };
                    assert_eq!(again, Some(code), "{word} and {back} in {}", dialect.name());
                }
            }
        }
    }

    #[test]
    fn constants_name_their_words() {
        for (word, text) in [
            (word::TLLFT, "TLLFT"),
            (word::W3DCALC, "3DCALC"),
            (word::W5PT, "5PT"),
            (word::W3PT2SL, "3PT2SL"),
            (word::DOT_EQ, ".EQ"),
            (word::DOT, "DOT"),
            (word::ZXVIEW, "ZXVIEW"),
        ] {
            assert_eq!(word.text(), text);
        }
    }

    #[test]
    fn words_of_ncl_alone_are_no_words_of_apt() {
        for text in ["AA", "ABS", "GT", "LN", "PT", "CI"] {
            let word = find(text).expect("a word of NCL");
            assert!(word.is_in(Dialect::Ncl));
            assert!(!word.is_in(Dialect::Apt360) && !word.is_in(Dialect::Apt4), "{text}");
            assert_eq!(find_in(text, Dialect::Apt4), None);
        }
    }

    #[test]
    fn dialects_give_one_word_different_codes() {
        use Dialect::{Apt4, Apt360, IbmCl, Ncl, PostWorks};
        let minor = |text: &str, d| find(text).and_then(|w: Word| w.minor_code(d));
        let major = |text: &str, d| find(text).and_then(|w: Word| w.major_code(d));
        let n = |number| Some(Code::Word(number));
        for (text, by_dialect) in [
            ("AT", [n(175), n(189), n(189), n(189)]),
            ("ARC", [n(87), n(182), n(182), n(87)]),
            ("GRID", [n(176), n(67), n(67), n(176)]),
            ("OMIT", [n(172), n(186), n(176), n(176)]),
            ("AVOID", [n(173), n(187), n(187), n(187)]),
            ("RANDOM", [n(174), n(147), n(183), n(183)]),
            ("ZIGZAG", [n(170), n(177), n(170), n(170)]),
            ("NORMDS", [n(182), n(87), None, None]),
            ("MMPM", [None, n(171), n(315), n(181)]),
            ("MMPR", [None, n(172), n(316), n(182)]),
            ("TO", [n(69); 4]),
        ] {
            for (dialect, code) in [Apt360, Apt4, PostWorks, IbmCl].into_iter().zip(by_dialect) {
                assert_eq!(minor(text, dialect), code, "{text} in {}", dialect.name());
            }
        }
        for (text, by_dialect) in [
            ("GOHOME", [n(14), n(14), n(17), n(14)]),
            ("BREAK", [None, n(17), n(16), n(17)]),
            ("POSMAP", [None, n(1068), n(1034), n(24)]),
            ("LINTOL", [None, n(1067), n(1067), n(1073)]),
            ("SELECT", [None, None, n(1074), n(1034)]),
            ("LOAD", [None, None, n(1075), n(1074)]),
            ("COMBIN", [None, None, n(1071), n(1079)]),
            ("SPINDL", [n(1031); 4]),
        ] {
            for (dialect, code) in [Apt360, Apt4, PostWorks, IbmCl].into_iter().zip(by_dialect) {
                assert_eq!(major(text, dialect), code, "{text} in {}", dialect.name());
            }
        }
        assert_eq!(word::GOTO.code(Ncl), n(703));
        assert_eq!(word::DWELL.major_code(Apt360), n(1058));
        assert_eq!(word::DWELL.minor_code(PostWorks), n(279));
    }

    #[test]
    fn one_code_is_different_words_by_dialect() {
        use Dialect::{Apt4, Apt360, IbmCl, PostWorks};
        let major = |dialect, code| from_code(dialect, true, Code::Word(code));
        for (code, by_dialect) in [
            (14, [Some(word::GOHOME), Some(word::GOHOME), None, Some(word::GOHOME)]),
            (16, [Some(word::GOCLER), Some(word::GOCLER), Some(word::BREAK), Some(word::BREAK)]),
            (17, [Some(word::DRAWLI), Some(word::BREAK), Some(word::GOHOME), Some(word::BREAK)]),
            (1018, [Some(word::MCHFIN), Some(word::MCHFIN), Some(word::UAXIS), Some(word::UAXIS)]),
            (1032, [Some(word::IFRO), Some(word::DEBUGG), Some(word::DEBUGG), Some(word::DEBUGG)]),
            (1034, [None, None, Some(word::POSMAP), Some(word::SELECT)]),
            (1039, [Some(word::INDEX), Some(word::INDEX), Some(word::INDEXF), Some(word::INDEXF)]),
            (
                1047,
                [Some(word::CAMERA), Some(word::CAMERA), Some(word::TPRINT), Some(word::TPRINT)],
            ),
            (1064, [Some(word::MAXVEL), Some(word::MAXVEL), Some(word::INTOL), Some(word::INTOL)]),
            (1068, [Some(word::PBS), Some(word::POSMAP), Some(word::PPTOL), Some(word::PPTOL)]),
            (
                1072,
                [Some(word::MAGTAP), Some(word::MAGTAP), Some(word::POSITN), Some(word::POSITN)],
            ),
            (1074, [None, None, Some(word::SELECT), Some(word::LOAD)]),
        ] {
            for (dialect, word) in [Apt360, Apt4, PostWorks, IbmCl].into_iter().zip(by_dialect) {
                assert_eq!(major(dialect, code), word, "{code} in {}", dialect.name());
            }
        }
        for dialect in [Apt360, Apt4] {
            assert_eq!(from_code(dialect, false, Code::Word(27)), Some(word::TANTO));
            assert_eq!(major(dialect, 1012), Some(word::OPSKIP));
        }
        assert_eq!(from_code(Apt4, false, Code::Word(185)), Some(word::ZIGZAG));
        let circle = Code::Surface(4);
        assert_eq!(from_code(Apt4, true, circle), Some(word::CIRCLE));
        assert_eq!(major(Apt360, 1), Some(word::END));
        let fini = Code::Record { kind: 14000, subtype: 0 };
        assert_eq!(from_code(Apt360, true, fini), Some(word::FINI));
    }

    #[test]
    fn classes_follow_the_use() {
        for (word, class) in [
            (word::SSURF, Class::Geometry),
            (word::TLAXIS, Class::Motion),
            (word::CLPRNT, Class::Control),
            (word::LOG10F, Class::Function),
            (word::PPRINT, Class::Text),
            (word::COOLNT, Class::Post),
            (word::AVCTRL, Class::Regional),
            (word::XLARGE, Class::Modifier),
        ] {
            assert_eq!(word.class(), class, "{word}");
        }
        assert!(word::TOOL.is(Class::Modifier) && word::TOOL.is(Class::Geometry));
        assert!(word::DWELL.is(Class::Modifier) && word::DWELL.is(Class::Post));
    }
}
