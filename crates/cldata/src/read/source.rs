//! What tells a part program from CL data: definitions of geometry, motion along surfaces, INCLUDE.

use aptc_vocabulary::{Class, find};

use super::args;

/// Is the line a text word with its text?
pub fn is_text(line: &[u8]) -> bool {
    super::words::text_word(line).is_some()
}

/// Is the statement `NAME = WORD/..` with a word of geometry, also with a label or a subscript?
pub fn is_definition(text: &[u8]) -> bool {
    let text = unlabelled(text);
    let Some(equals) = memchr::memchr(b'=', text) else { return false };
    let (name, value) = (text[..equals].trim_ascii_end(), &text[equals + 1..]);
    let open = name.ends_with(b")").then(|| memchr::memchr(b'(', name)).flatten();
    let name = name[..open.unwrap_or(name.len())].trim_ascii();
    let Some(slash) = memchr::memchr(b'/', value) else { return false };
    name.first().is_some_and(u8::is_ascii_alphabetic)
        && name.iter().all(u8::is_ascii_alphanumeric)
        && find(&args::upper(&value[..slash])).is_some_and(|w| w.is(Class::Geometry))
}

/// The statement behind its label, `10)` or `ID1 )`, without blanks around.
pub fn unlabelled(text: &[u8]) -> &[u8] {
    let text = text.trim_ascii();
    let end = text.iter().position(|b| !b.is_ascii_alphanumeric()).unwrap_or(text.len());
    match text[end..].trim_ascii_start().strip_prefix(b")") {
        Some(rest) if end > 0 => rest.trim_ascii_start(),
        _ => text,
    }
}

/// Words of statements that are carried out before there are CL data: their cuts would be missing. CAM systems
/// write GOFWD of an arc, and TLON alone before it; both are taken before this is asked.
pub(super) fn is_word(word: &str) -> bool {
    matches!(
        word,
        "GO" | "GOLFT"
            | "GL"
            | "GORGT"
            | "GR"
            | "GOFWD"
            | "GF"
            | "GOBACK"
            | "GB"
            | "GOUP"
            | "GU"
            | "GODOWN"
            | "GD"
            | "INCLUD"
            | "INCLUDE"
            | "TLLFT"
            | "TLRGT"
            | "TLON"
    )
}

/// What is said of such a statement and of a definition.
pub(super) const TOLD: &str =
    "this is a part program, compile it: a statement that CL data have not";

/// The word at the head of a statement that moves the tool or says how fast, when it is one.
pub(super) fn motion_word(text: &[u8]) -> Option<&'static str> {
    const WORDS: [&str; 14] = [
        "GOTO", "FROM", "GODLTA", "GOHOME", "CIRCLE", "INDIRV", "INDIRP", "MOVARC", "ARCDAT",
        "ARCMOV", "GOCLW", "GOCCLW", "RAPID", "FEDRAT",
    ];
    /// With a digit behind they are other words, and alone some are modes.
    const SHORT: [&str; 6] = ["ARC", "CW", "CCW", "HELICAL", "NURBS", "CYCLE"];
    let text = unlabelled(text);
    let (word, rest) =
        text.split_at(text.iter().position(|b| !b.is_ascii_alphabetic()).unwrap_or(text.len()));
    // A longer word of a vendor is none of these.
    let longer = match rest {
        [b'_', ..] => true,
        [b'-', next, ..] => !(next.is_ascii_digit() || *next == b'.'),
        _ => false,
    };
    let short = rest.is_empty() || rest[0].is_ascii_digit();
    let is = |w: &&&str| word.eq_ignore_ascii_case(w.as_bytes());
    let found = WORDS.iter().find(is).or_else(|| SHORT.iter().find(is).filter(|_| !short));
    found.copied().filter(|_| !longer)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn definitions_have_a_name_and_a_word_of_geometry() {
        for text in ["L1=LINE/XAXIS", "p(3) = point / 1,2", "10) A= CIRCLE/C,5", "ID1 )P=PLANE/1"] {
            assert!(is_definition(text.as_bytes()), "{text}");
        }
        for text in ["X = Y/2", "=LINE/1", "A B=LINE/1", "A=SPINDL/1", "L1=LINE", "$$ A=LINE/1"] {
            assert!(!is_definition(text.as_bytes()), "{text}");
        }
    }

    #[test]
    fn a_motion_word_is_not_the_beginning_of_another() {
        for (text, word) in [
            ("goto50,0,-1", Some("GOTO")),
            ("GOTO\\50,0,-1", Some("GOTO")),
            ("10) GOTO/1,2,3", Some("GOTO")),
            ("GOTO-1,2,3", Some("GOTO")),
            ("RAPID 5", Some("RAPID")),
            ("GOTOX 5", None),
            ("RAPID_FEED/5", None),
            ("CYCLE-END", None),
            ("GOTO", Some("GOTO")),
            ("CW 1,2,3", Some("CW")),
            ("CCW", None),
            ("CYCLE81,1", None),
            ("", None),
        ] {
            assert_eq!(motion_word(text.as_bytes()), word, "{text}");
        }
    }
}
