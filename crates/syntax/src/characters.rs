//! Words for a character that APT does not have.

use aptc_diagnostics::{Diagnostic, Span, codes};

/// The message for `c`, which no token begins with.
pub(crate) fn not_of_apt(c: char, span: Span) -> Diagnostic {
    if matches!(c, '\'' | '"') {
        let message = format!("this {c} has no closing {c} on its card");
        return Diagnostic::error(codes::UNCLOSED_QUOTE, span, message)
            .help(format!("close the text with {c}"));
    }
    let message = match c {
        '.' => "this `.` belongs to no number and no operator".to_owned(),
        c if c.is_control() => {
            format!("the control character {} is not of APT", c.escape_unicode())
        }
        c if c.is_whitespace() => format!("the blank {} is not of APT", c.escape_unicode()),
        c => format!("the character `{c}` is not of APT"),
    };
    let diagnostic = Diagnostic::error(codes::ILLEGAL_CHARACTER, span, message);
    match help(c) {
        Some(help) => diagnostic.help(help),
        None => diagnostic,
    }
}

fn help(c: char) -> Option<&'static str> {
    Some(match c {
        '.' => "points stand in numbers, `.5`, and around operators, `.EQ.`",
        '^' => "a power is written `A**2`",
        '<' => "a comparison is written `A.LT.B` or `A.LE.B`",
        '>' => "a comparison is written `A.GT.B` or `A.GE.B`",
        ';' => "a card holds one statement; a comment begins with `$$`",
        '%' | '#' | '!' => "a comment begins with `$$`; names are letters and digits",
        '_' => "names are letters and digits",
        '[' | '{' => "brackets are written `(`",
        ']' | '}' => "brackets are written `)`",
        '\u{2018}' | '\u{2019}' | '\u{201c}' | '\u{201d}' | '`' => "quotes are written `'`",
        '\u{2010}'..='\u{2015}' | '\u{2212}' => "minus is written `-`",
        '\u{d7}' => "a product is written `*`",
        c if c.is_whitespace() => "put an ordinary blank there",
        c if c.is_alphabetic() => "names are made of the letters A to Z and digits",
        _ => return None,
    })
}
