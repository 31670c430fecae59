//! What is to be said of a word: its tables, how it is written, and what becomes of it.

use std::fmt::Write as _;

use aptc_vocabulary::{Class, Dialect, Word, closest, find};

use crate::define;
use crate::statement::{fate, statement_shapes};
use crate::usage::{sentence, usage};

/// A page about a word in Markdown; `None` for what is no word.
///
/// Geometric words have their formats, statements with a table of arguments theirs; a word that is ignored
/// or refused has the reason.
pub fn about(text: &str) -> Option<String> {
    let word = find(&text.to_ascii_uppercase())?;
    let mut page = format!("# {word}\n\n{}.\n", class(word));
    let tables: Vec<&str> =
        Dialect::ALL.iter().filter(|d| word.is_in(**d)).map(|d| d.name()).collect();
    let _ = write!(page, "\nIn the tables of {}.\n", tables.join(", "));
    if let Some((what, reason)) = fate(word) {
        let _ = write!(page, "\n{what}: {reason}.\n");
    }
    if let Some(sentence) = sentence(word) {
        let _ = write!(page, "\n{sentence}\n");
    }
    let mut formats = define::formats(word);
    formats.extend(statement_shapes(word));
    formats.extend(usage(word).iter().map(|form| (*form).to_owned()));
    if !formats.is_empty() {
        page += "\n```\n";
        for format in formats {
            let _ = writeln!(page, "{format}");
        }
        page += "```\n";
    }
    Some(page)
}

/// The word that `text` is perhaps meant to be.
pub fn near_word(text: &str) -> Option<&'static str> {
    let of_apt = |w: Word| w.is_in(Dialect::Apt360) || w.is_in(Dialect::Apt4);
    let major = |w: Word| of_apt(w) && w.class() != Class::Modifier;
    let text = text.to_ascii_uppercase();
    closest(&text, major).or_else(|| closest(&text, of_apt)).map(Word::text)
}

fn class(word: Word) -> &'static str {
    match word.class() {
        Class::Geometry => "Defines geometry",
        Class::Motion => "Moves the tool, or sets how it moves",
        Class::Control => "Steers translation, listing or the editing of CL data",
        Class::Function => "A function of expressions",
        Class::Text => "Takes the rest of its card as text",
        Class::Post => "Handed on to the post-processor",
        Class::Regional => "Milling of regions and lines of surfaces, and its checks",
        Class::Operator => "An operator of expressions",
        Class::Modifier => "Stands among the arguments of other words",
    }
}

#[cfg(test)]
mod tests {
    use aptc_vocabulary::all;

    use super::*;

    #[test]
    fn every_word_has_a_page() {
        for word in all() {
            let page = about(word.text()).expect("a page");
            assert!(page.starts_with(&format!("# {word}\n")), "{page}");
        }
        assert_eq!(about("QQQ"), None);
    }

    #[test]
    fn formats_and_reasons_stand_on_the_page() {
        let page = |word: &str| about(word).unwrap_or_default();
        assert!(page("line").contains("\nLINE/point,PARLEL,line\n"), "{}", page("line"));
        assert!(page("POINT").contains("POINT/INTOF,sculptured surface,number,number\n"));
        assert!(page("SCON").contains("SCON/AXIS,vector[,PLUS|MINUS]\n"), "{}", page("SCON"));
        assert!(page("VTLAXS").contains("VTLAXS/OFF,LEFT|RIGHT,number\n"));
        assert!(page("DMILL").contains("Refused: its processor was never published."));
        assert!(page("TUNEUP").contains("Ignored: "));
        assert!(page("PTONLY").contains("Ignored: "));
        for (word, form) in [("TANTO", "TANTO|DSTAN"), ("2DCALC", "2DCALC")] {
            let page = page(word);
            assert!(page.contains(form) && page.lines().filter(|l| l.ends_with('.')).count() >= 3);
        }
        assert_eq!(near_word("CIRCEL"), Some("CIRCLE"));
    }
}
