//! What is to be said of a word: its tables, how it is written, and what becomes of it.

use std::fmt::Write as _;

use aptc_vocabulary::{Class, Dialect, Word, all, closest, find};

use crate::define;
use crate::eval::reason_of;
use crate::sentence::sentence;
use crate::statement::{fate, statement_shapes};
use crate::usage::usage;

/// Forms of one other statement that a page shows; more of them are counted.
const FORMS: usize = 4;

/// A page about a word in Markdown; `None` for what is no word.
///
/// Geometric words have their formats, statements with a table of arguments theirs; a word that stands among the arguments of
/// other statements has their forms; a word that is ignored or refused has the reason.
pub fn about(text: &str) -> Option<String> {
    let word = find(&text.to_ascii_uppercase())?;
    let (own, others) = (forms(word), forms_with(word));
    let mut page = format!("# {word}\n\n{}.\n", class(word, !others.is_empty()));
    let tables: Vec<&str> =
        Dialect::ALL.iter().filter(|d| word.is_in(**d)).map(|d| d.name()).collect();
    let _ = write!(page, "\nIn the tables of {}.\n", tables.join(", "));
    let fate = fate(word).or(reason_of(word).map(|reason| ("Refused", reason)));
    if let Some((what, reason)) = fate {
        let _ = write!(page, "\n{what}: {reason}.\n");
    }
    if let Some(sentence) = sentence(word) {
        let _ = write!(page, "\n{sentence}\n");
    } else if own.is_empty() && others.is_empty() && fate.is_none() {
        let _ = write!(page, "\n{}\n", nothing_known(word));
    }
    fenced(&mut page, &own);
    if !others.is_empty() {
        page += "\nIt stands in these statements:\n";
        fenced(&mut page, &others);
    }
    Some(page)
}

fn fenced(page: &mut String, forms: &[String]) {
    if !forms.is_empty() {
        let _ = write!(page, "\n```\n{}\n```\n", forms.join("\n"));
    }
}

/// How the word itself is written.
fn forms(word: Word) -> Vec<String> {
    let mut forms = define::formats(word);
    forms.extend(statement_shapes(word));
    forms.extend(usage(word).iter().map(|form| form.replace('@', word.text())));
    forms
}

/// The forms of other statements among whose arguments the word stands.
fn forms_with(word: Word) -> Vec<String> {
    let names = |form: &str| {
        form.split(|c: char| !c.is_ascii_alphanumeric()).any(|part| part == word.text())
    };
    let mut told: Vec<&[&str]> = Vec::new();
    let mut found = Vec::new();
    for head in all().filter(|head| *head != word) {
        // Words that are written alike stand for each other: GOLFT, GORGT and the rest.
        let alike = usage(head);
        if !alike.is_empty() && told.contains(&alike) {
            continue;
        }
        told.push(alike);
        let with: Vec<String> = forms(head).into_iter().filter(|form| names(form)).collect();
        let more = with.len().saturating_sub(FORMS);
        found.extend(with.into_iter().take(FORMS));
        if more > 0 {
            found.push(format!("{head}/..  and {more} more: aptc explain {head}"));
        }
    }
    found
}

/// What is to be said of a word of which no statement for the part knows.
fn nothing_known(word: Word) -> &'static str {
    let of_apt = word.is_in(Dialect::Apt360) || word.is_in(Dialect::Apt4);
    match word.class() {
        _ if !of_apt && word.is_in(Dialect::Ncl) => {
            "It is no word of APT-360 or APT4; programs of NCL are read with --dialect ncl."
        }
        _ if !of_apt => {
            "It is no word of APT-360 or APT4; it is handed on in statements for the post-processor."
        }
        Class::Modifier => {
            "No statement for the part asks for it; it is handed on in statements for the post-processor."
        }
        Class::Operator => "It stands between or before the values that it combines.",
        _ => {
            "What it does is left to the post-processor; those for the usual machines may ignore it, and say so."
        }
    }
}

/// The word that `text` is perhaps meant to be.
pub fn near_word(text: &str) -> Option<&'static str> {
    let of_apt = |w: Word| w.is_in(Dialect::Apt360) || w.is_in(Dialect::Apt4);
    let major = |w: Word| of_apt(w) && w.class() != Class::Modifier;
    let text = text.to_ascii_uppercase();
    closest(&text, major).or_else(|| closest(&text, of_apt)).map(Word::text)
}

/// What kind of word it is; `among` tells that it stands among the arguments of other statements.
fn class(word: Word, among: bool) -> &'static str {
    match word.class() {
        Class::Post if among => {
            "Stands among the arguments of other words; where it begins a statement it is handed on to the post-processor"
        }
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
    use super::*;

    #[test]
    fn every_word_has_a_page() {
        for word in all() {
            let page = about(word.text()).expect("a page");
            assert!(page.starts_with(&format!("# {word}\n")), "{page}");
        }
        assert_eq!(about("QQQ"), None);
    }

    /// A page says more of a word than where it is from.
    #[test]
    fn no_page_is_empty() {
        let says_nothing = |word: &Word| {
            let page = about(word.text()).unwrap_or_default();
            page.lines().skip(5).all(str::is_empty)
        };
        let empty: Vec<Word> = all().filter(says_nothing).collect();
        assert!(empty.is_empty(), "{empty:?}");
    }

    /// Each word with what its page must say.
    const SAID: &[(&str, &str)] = &[
        ("POLCON", "POLCON/CANON,79 elements"),
        ("TRANTO", "TRANTO/label"),
        ("JUMPTO", "JUMPTO/label"),
        ("INTOF", "n-th place where the drive surface meets it"),
        ("INTOF", "POINT/INTOF,line,line"),
        ("INTOF", "TLON,]GOBACK/drive surface,TO|ON|PAST|TANTO|PSTAN,[n,INTOF,]check surface"),
        ("CUTANG", "TLAXIS/ATANGL,1|2|PS|DS,angle,CUTANG,"),
        ("CUTANG", "AVCTRL/CUTANG,CONST,number,RANGE,"),
        ("LEAD", "leans towards the motion"),
        ("LAG", "SCON/AXIS,ATANGL,DS|PS,number,CUTANG,LEAD|LAG,number"),
        ("FETCH", "Refused: it took a form from a library file"),
        ("FLOW", "SCURV/..,FLOW,ARC|PARAM,n1,n2"),
        ("SEG", "SEG,LENGTH|PARAM,n1,n2"),
        ("WEIGHT", "below 1 the point is moved"),
        ("WEIGHT", "SCURV/SPLINE,[WEIGHT,w,][LIMIT,l,]point"),
        ("LIMIT", "alone it changes nothing"),
        ("LIMIT", "AVCTRL/NORMPS|AXIS[,LIMIT,number]"),
        ("LIMIT", "Stands among the arguments of other words; where it begins"),
        ("GENCUR", "SSURF/GENCUR,curve,curve,..[,CROSS"),
        ("AVPRT", "PRINT/AVPRT|AVMSG,ON|OFF"),
        ("AVMSG", "AVCTRL avoided"),
        ("CLDATF", "CLDATF(n,UPS|VPS|PPS|UDS|VDS|PDS,k)"),
        ("SQRTF", "SQRTF(number)"),
        ("BOUNDS", "no statement uses it"),
        ("OBJECT", "no statement uses it"),
        ("OPTION", "CUTTER/OPTION,1|2,radius,height|OFF"),
        ("OPTION", "CLPRNT/OPTION"),
        ("PTNORM", "The angle of the normal follows each point"),
        ("INTOL", "INTOL/part,drive,check,second check surface"),
        ("OUTTOL", "OUTTOL/for all surfaces"),
        ("GOBACK", "TLON,]GOBACK/drive surface"),
        ("TLAXIS", "TLAXIS/PARLEL,1|2|PS|DS[,RADIUS,r][,HIGHT,h]"),
        ("CUTTER", "With e and f both 0 the corner touches bottom and side"),
        ("CUTTER", "5 inches, 127 mm"),
        ("THICK", "A negative one lets the cutter into the surface"),
        ("THICK", "ON a surface there is none"),
        ("OFFSET", "OFFSET/[TO|ON|PAST,]drive surface"),
        ("OFFSET", "LOADTL/n[,LENGTH,l][,OFFSET,h]"),
        ("BLACK", "No statement for the part asks for it"),
        ("YELLOW", "It is no word of APT-360 or APT4"),
        ("CLAMP", "left to the post-processor"),
    ];

    #[test]
    fn pages_say_what_a_word_does() {
        for (word, said) in SAID {
            let page = about(word).unwrap_or_default();
            assert!(page.contains(said), "{said} is missing: {page}");
        }
        // The forms of another word are not shown in its place.
        for (word, other) in [("INTOL", "OUTTOL/"), ("OFFSET", "\nGO/"), ("GOBACK", "GOLFT/")] {
            let page = about(word).unwrap_or_default();
            assert!(!page.contains(other), "{page}");
        }
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
