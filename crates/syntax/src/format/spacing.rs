//! The tokens of a statement as they are to be written, each with the place of its first byte.

use crate::form::{Form, closing, form};
use crate::scan::Flat;
use crate::token::{Spanned, Token, sign};
use crate::tree::Name;

/// A piece of text that is not divided.
pub(super) struct Written {
    /// Place in the file of its first byte, which tells its card.
    pub(super) at: u32,
    /// With the blanks around it.
    pub(super) text: String,
    /// May a card end behind it?
    pub(super) breaks: bool,
    /// Where the statement begins, if this is its label.
    pub(super) label_of: Option<u32>,
}

/// The statement's label and tokens as they are to be written.
pub(super) fn words(
    source: &str,
    flat: &Flat,
    label: Option<Name>,
    tokens: &[Spanned],
) -> Vec<Written> {
    let mut words = Vec::with_capacity(tokens.len() + 1);
    if let Some(label) = label {
        let end = flat.places.partition_point(|p| *p < label.span.end);
        // The `)` or `:` belongs to the label.
        let text = format!("{}{}", &flat.text[..=end], if tokens.is_empty() { "" } else { " " });
        let label_of = tokens.first().map(|(_, span)| span.start);
        words.push(Written { at: label.span.start, text, breaks: false, label_of });
    }
    let spaced = equals_of_statement(tokens);
    let condition = end_of_condition(tokens);
    for (i, (token, span)) in tokens.iter().enumerate() {
        let start = flat.places.partition_point(|p| *p < span.start);
        let end = flat.places.partition_point(|p| *p < span.end);
        let as_written = &flat.text[start..end];
        let text = match token {
            Token::Text(_) => source[span.start as usize..span.end as usize].to_owned(),
            Token::Equal if spaced == Some(i) => " = ".to_owned(),
            Token::Close if condition == Some(i) => ") ".to_owned(),
            Token::Truth(true) => ".TRUE.".to_owned(),
            Token::Truth(false) => ".FALSE.".to_owned(),
            Token::Not => ".NOT.".to_owned(),
            Token::Operator(op) => match sign(*op) {
                letters if letters.starts_with(|c: char| c.is_ascii_alphabetic()) => {
                    format!(" {letters} ")
                }
                sign => sign.to_owned(),
            },
            _ => as_written.to_owned(),
        };
        let breaks = matches!(token, Token::Comma);
        words.push(Written { at: span.start, text, breaks, label_of: None });
    }
    words
}

/// The `=` that gives the statement its value: the first outside of brackets, in an assignment or macro.
fn equals_of_statement(tokens: &[Spanned]) -> Option<usize> {
    let from = match form(tokens) {
        Form::Assign | Form::Macro => 0,
        Form::IfThen => {
            let from = closing(tokens, 1)? + 1;
            if form(&tokens[from..]) != Form::Assign {
                return None;
            }
            from
        }
        _ => return None,
    };
    let mut depth = 0_usize;
    for (i, (token, _)) in tokens.iter().enumerate().skip(from) {
        match token {
            Token::Open => depth += 1,
            Token::Close => depth = depth.saturating_sub(1),
            Token::Equal if depth == 0 => return Some(i),
            _ => {}
        }
    }
    None
}

/// The bracket behind which an IF goes on.
fn end_of_condition(tokens: &[Spanned]) -> Option<usize> {
    match form(tokens) {
        Form::If | Form::IfThen => closing(tokens, 1),
        _ => None,
    }
}
