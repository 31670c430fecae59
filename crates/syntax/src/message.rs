//! Words for a statement that the grammar does not take.

use aptc_diagnostics::{Diagnostic, FileId, Span, codes};
use chumsky::error::{Rich, RichPattern, RichReason};
use chumsky::span::SimpleSpan;

use crate::Interner;
use crate::form::Form;
use crate::token::{Spanned, Token, sign};

/// The message for a statement that failed.
pub(crate) fn of_grammar(
    file: FileId,
    _form: Form,
    tokens: &[Spanned],
    error: Option<Rich<'_, Token, SimpleSpan<u32>>>,
    interner: &Interner,
    statement: Span,
) -> Diagnostic {
    let Some(error) = error else {
        let message = "this statement cannot be read";
        return Diagnostic::error(codes::EXPECTED_OTHERWISE, statement, message);
    };
    let at = error.span();
    let span = Span::new(file, at.start.min(at.end), at.end.max(at.start));
    let (wanted, found) = match error.reason() {
        RichReason::ExpectedFound { expected, found } => {
            let mut wanted: Vec<String> = expected.iter().map(|e| pattern(e, interner)).collect();
            wanted.sort();
            wanted.dedup();
            (wanted, found.as_deref().copied())
        }
        RichReason::Custom(text) => (vec![text.clone()], None),
    };
    let found = match found.or_else(|| tokens.iter().find(|t| t.1 == *at).map(|t| t.0)) {
        Some(token) => shown(token, interner),
        None => "the end of the statement".to_owned(),
    };
    let message = if wanted.is_empty() {
        format!("{found} is not expected here")
    } else {
        format!("expected {}, found {found}", join(&wanted))
    };
    Diagnostic::error(codes::EXPECTED_OTHERWISE, span, message)
}

fn join(list: &[String]) -> String {
    match list {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}

fn pattern(pattern: &RichPattern<'_, Token>, interner: &Interner) -> String {
    match pattern {
        RichPattern::Token(token) => shown(**token, interner),
        RichPattern::Label(label) => label.to_string(),
        RichPattern::Identifier(name) => name.clone(),
        RichPattern::EndOfInput => "the end of the statement".to_owned(),
        _ => "something else".to_owned(),
    }
}

/// A token as the user wrote it.
fn shown(token: Token, interner: &Interner) -> String {
    match token {
        Token::Name(symbol, _) | Token::Head(symbol, _) => format!("`{}`", interner.text(symbol)),
        Token::Number(value, _) => format!("the number {value}"),
        Token::Text(_) => "a text".to_owned(),
        Token::Truth(true) => "`.TRUE.`".to_owned(),
        Token::Truth(false) => "`.FALSE.`".to_owned(),
        Token::Not => "`.NOT.`".to_owned(),
        Token::Operator(op) => format!("`{}`", sign(op)),
        Token::Slash => "`/`".to_owned(),
        Token::Comma => "`,`".to_owned(),
        Token::Equal => "`=`".to_owned(),
        Token::Open => "`(`".to_owned(),
        Token::Close => "`)`".to_owned(),
        Token::Colon => "`:`".to_owned(),
    }
}
