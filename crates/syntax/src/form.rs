//! Which kind of statement the tokens are, judged by the first few of them.

use aptc_vocabulary::word;

use crate::token::{Spanned, Token};

/// Kinds of statement that have a grammar of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// `A=3`, `P(2)=POINT/1,2`.
    Assign,
    /// `M=MACRO/A,B=2`.
    Macro,
    /// `CALL/M,A=1`.
    Call,
    /// `IF(A)1,2,3`.
    If,
    /// `IF(A.LT.B)statement`.
    IfThen,
    /// `DO/L,I=1,10`.
    Do,
    /// Words, the last with arguments.
    Clauses,
}

/// The kind of the statement. A word followed by `=` or by `(..)=` is a symbol.
pub(crate) fn form(tokens: &[Spanned]) -> Form {
    let token = |i: usize| tokens.get(i).map(|t| t.0);
    let Some(Token::Name(_, head)) = token(0) else { return Form::Clauses };
    match (token(1), head) {
        (Some(Token::Equal), _) => match (token(2), token(3)) {
            (Some(Token::Name(_, Some(word::MACRO))), None | Some(Token::Slash)) => Form::Macro,
            _ => Form::Assign,
        },
        (Some(Token::Open), _) => match closing(tokens, 1) {
            Some(close) if token(close + 1) == Some(Token::Equal) => Form::Assign,
            Some(close) if head == Some(word::IF) => after_condition(&tokens[close + 1..]),
            _ => Form::Clauses,
        },
        (Some(Token::Slash), Some(word::CALL)) => Form::Call,
        (Some(Token::Slash), Some(word::DO)) => Form::Do,
        _ => Form::Clauses,
    }
}

/// Does the statement, or that behind its condition, give a value?
pub(crate) fn is_assignment(tokens: &[Spanned], form: Form) -> bool {
    match form {
        Form::Assign => true,
        Form::IfThen => {
            closing(tokens, 1).is_some_and(|close| self::form(&tokens[close + 1..]) == Form::Assign)
        }
        _ => false,
    }
}

/// Labels or a statement?
fn after_condition(rest: &[Spanned]) -> Form {
    match rest {
        [] | [(Token::Number(..) | Token::Comma, _), ..] => Form::If,
        [(Token::Name(..), _), (Token::Comma, _), ..]
            if rest.iter().all(|t| {
                matches!(t.0, Token::Name(..) | Token::Comma | Token::Number(_, Some(_)))
            }) =>
        {
            Form::If
        }
        _ => Form::IfThen,
    }
}

/// The bracket that closes the one at `open`.
pub(crate) fn closing(tokens: &[Spanned], open: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for (i, (token, _)) in tokens.iter().enumerate().skip(open) {
        match token {
            Token::Open => depth += 1,
            Token::Close => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some(i);
                }
            }
            _ => {}
        }
    }
    None
}
